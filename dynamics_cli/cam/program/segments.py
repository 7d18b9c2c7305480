"""Records of a program of cam motion."""

from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    CamAcceleration,
    CamVelocity,
    Coordinate,
    Count,
    Fraction,
    InputFile,
    Ratio,
)
from dynamics_cli.records import Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.cam.program.parts import Exact

# Sizes of cams and followers beyond these overflow in the integrals of a plate.
SMALLEST, LARGEST = 1e-60, 1e60


class Move(Choice):
    """Motion of the follower in a segment."""

    names = ("rise", "return", "dwell")
    aliases = {"fall": "return", "rest": "dwell", "hold": "dwell", "lift": "rise"}  # noqa: RUF012


@record
class Point:
    """A point a spline goes through."""

    at: Annotated[Angle, "Cam angle from the start of the segment [rad]."]
    lift: Annotated[Coordinate, "Lift above the level at the start of the segment, e.g. 8 mm [m]."]


@record
class Segment:
    """One segment of a program."""

    move: Annotated[Move, "Rise, return or dwell."]
    span: Annotated[
        Angle | None,
        "Cam angle of the segment; one segment may leave it out and takes the remainder of the turn [rad].",
    ] = None
    lift: Annotated[
        Coordinate | None,
        "How far the follower rises or returns; left out, a return goes to the level of the start, e.g. 20 mm [m].",
    ] = None
    swing: Annotated[Angle | None, "In place of the lift, how far an arm swings [rad]."] = None
    law: Annotated[LawName | None, "The law; 3-4-5 when not given."] = None
    shares: Annotated[
        tuple[Ratio, ...], "Shares b, c, d of sine, constant and cosine acceleration of an scca law."
    ] = ()
    constant: Annotated[Fraction | None, "Share of the rise at constant velocity of a modified constant velocity."] = (
        None
    )
    degree: Annotated[
        Count | None, "Degree 3, 5, 7 or 9 of a polynomial between the states at its ends; 5 when not given."
    ] = None
    start_velocity: Annotated[
        CamVelocity | None,
        "Velocity at the start of a polynomial or spline; unless given, as in the previous segment [m/rad].",
    ] = None
    end_velocity: Annotated[
        CamVelocity | None, "Velocity at its end; unless given, as in the next segment [m/rad]."
    ] = None
    start_acceleration: Annotated[
        CamAcceleration | None,
        "Acceleration at the start of a polynomial; unless given, as in the previous segment [m/rad^2].",
    ] = None
    end_acceleration: Annotated[
        CamAcceleration | None, "Acceleration at its end; unless given, as in the next segment [m/rad^2]."
    ] = None
    points: Annotated[tuple[Point, ...], "Points a spline goes through between its ends."] = ()


@record
class Program:
    """A revolution of cam motion, segment by segment."""

    segments: Annotated[tuple[Segment, ...], "The segments in order; together they make one turn."] = ()
    start: Annotated[Angle, "Cam angle at which the first begins [rad]."] = 0.0
    lifts: Annotated[InputFile, "CSV with angle[deg],lift[mm], in place of segments, e.g. lifts.csv."] = ""


@record
class Step:
    """The common form of a segment from a file or a line: spans exact, in degrees."""

    segment: Annotated[Segment, "The segment as given."]
    span: Annotated["Exact | None", "Its span in degrees, exactly."]
    level: Annotated[float | None, "Lift to reach, in place of the distance."] = None
