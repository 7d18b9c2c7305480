"""The records a program of cam motion is written in."""

from dynamics_cli.cam.laws import LawName
from dynamics_cli.quantities import (
    Angle,
    CamAcceleration,
    CamVelocity,
    Coordinate,
    Count,
    Fraction,
    Ratio,
)
from dynamics_cli.records import Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.cam.motion import Exact


class Move(Choice):
    """What the follower does."""

    names = ("rise", "return", "dwell")
    aliases = {"fall": "return", "rest": "dwell", "lift": "rise"}  # noqa: RUF012


@record
class Point:
    """A point a spline goes through.

    Parameters
    ----------
    at : Angle
        Cam angle from the start of the segment [rad].
    lift : Coordinate
        Lift above the level at the start of the segment [m].
    """

    at: Angle
    lift: Coordinate


@record
class Segment:
    """One segment of a program.

    Parameters
    ----------
    move : Move
        Rise, return or dwell.
    span : Angle
        Cam angle it takes; one segment may leave it out and takes what is left of the turn [rad].
    lift : Coordinate
        How far the follower rises or returns; a return without it goes back to the level of the start [m].
    swing : Angle
        In place of the lift, how far an arm swings [rad].
    law : LawName
        The law; 3-4-5 when not given.
    shares : tuple of Ratio
        Shares b, c, d of sine, constant and cosine acceleration of an scca law.
    constant : Fraction
        Share of the rise at constant velocity of a modified constant velocity.
    degree : Count
        Degree 3, 5, 7 or 9 of a polynomial between the states at its ends; 5 when not given.
    start_velocity : CamVelocity
        Velocity at the start of a polynomial or spline; that of the segment before when not given [m/rad].
    end_velocity : CamVelocity
        Velocity at its end; that of the segment after when not given [m/rad].
    start_acceleration : CamAcceleration
        Acceleration at the start of a polynomial; that of the segment before when not given [m/rad^2].
    end_acceleration : CamAcceleration
        Acceleration at its end; that of the segment after when not given [m/rad^2].
    points : tuple of Point
        Points a spline goes through between its ends.
    """

    move: Move
    span: Angle | None = None
    lift: Coordinate | None = None
    swing: Angle | None = None
    law: LawName | None = None
    shares: tuple[Ratio, ...] = ()
    constant: Fraction | None = None
    degree: Count | None = None
    start_velocity: CamVelocity | None = None
    end_velocity: CamVelocity | None = None
    start_acceleration: CamAcceleration | None = None
    end_acceleration: CamAcceleration | None = None
    points: tuple[Point, ...] = ()


@record
class Program:
    """A revolution of cam motion, segment by segment.

    Parameters
    ----------
    segments : tuple of Segment
        The segments in order; together they make one turn.
    start : Angle
        Cam angle at which the first begins [rad].
    """

    segments: tuple[Segment, ...] = ()
    start: Angle = 0.0


@record
class Step:
    """A segment as both ways of writing it come to: spans exact, in degrees.

    Parameters
    ----------
    segment : Segment
        What was asked.
    span : (int, int) | None
        Its span in degrees, exactly.
    level : float | None
        Lift to go to, in place of how far.
    """

    segment: Segment
    span: "Exact | None"
    level: float | None = None
