"""Inputs of the smallest cam, by its follower, and the results."""

from dynamics_cli.quantities import Angle, Annotated, Coordinate, Size, Text
from dynamics_cli.records import Advice, Check, Numerics, record, tagged

TYPE_CHECKING = False


@tagged("follower")
@record
class KnifeEdge:
    """A translating knife-edge."""

    offset: Annotated[Coordinate | None, "Offset of the slide; the best one if left out, e.g. 4 mm [m]."] = None


@tagged("follower")
@record
class Roller:
    """A translating roller."""

    roller_radius: Annotated[Size, "Radius of the roller, e.g. 6 mm [m]."]
    offset: Annotated[Coordinate | None, "Offset of the slide; the best one if left out, e.g. 4 mm [m]."] = None


@tagged("follower")
@record
class FlatFace:
    """A translating flat face."""

    face_margin: Annotated[Size, "Length of face required beyond the last contact on either side [m]."] = 0.0


@tagged("follower")
@record
class OscillatingRoller:
    """A roller on an arm of known length and pivot."""

    roller_radius: Annotated[Size, "Radius of the roller, e.g. 6 mm [m]."]
    arm: Annotated[Size, "Length of the arm, e.g. 80 mm [m]."]
    pivot_distance: Annotated[Size, "Distance of the pivot from the cam's axis, e.g. 100 mm [m]."]


@tagged("follower")
@record
class OscillatingFlat:
    """A flat face on an arm of known pivot."""

    pivot_distance: Annotated[Size, "Distance of the pivot from the cam's axis, e.g. 100 mm [m]."]
    face_offset: Annotated[Coordinate, "How far the face stands from the pivot towards the cam [m]."] = 0.0
    face_margin: Annotated[Size, "Length of face required beyond the last contact on either side [m]."] = 0.0


@tagged("follower")
@record
class ConjugateRoller:
    """Two rollers on one slide, on either side of the cam's axis, each with its own cam."""

    roller_radius: Annotated[Size, "Radius of both rollers, e.g. 6 mm [m]."]
    roller_distance: Annotated[
        Size | None,
        "Distance between the two rollers' centres; the shortest possible if left out, e.g. 75 mm [m].",
    ] = None
    offset: Annotated[Coordinate, "Offset of the slide [m]."] = 0.0


@tagged("follower")
@record
class ConjugateOscillatingRoller:
    """Two rollers on one rocker, on either side of the cam's axis, each with its own cam."""

    roller_radius: Annotated[Size, "Radius of both rollers, e.g. 6 mm [m]."]
    arm: Annotated[Size, "Length of both arms, e.g. 80 mm [m]."]
    pivot_distance: Annotated[Size, "Distance of the pivot from the cam's axis, e.g. 100 mm [m]."]
    arm_angle: Annotated[
        Angle | None, "Angle between the two arms; the smallest possible if left out, e.g. 60 deg [rad]."
    ] = None


Wanted = (
    KnifeEdge | Roller | FlatFace | OscillatingRoller | OscillatingFlat | ConjugateRoller | ConjugateOscillatingRoller
)


SWINGING = (OscillatingRoller, OscillatingFlat, ConjugateOscillatingRoller)


TRACKED = (Roller, OscillatingRoller)


@record
class SecondCam:
    """The second cam of a conjugate pair."""

    start_radius: Annotated[Size, "Distance of the second roller's centre from the cam's axis at zero lift [m]."]
    largest_pressure_angle: Annotated[
        Angle, "Maximum pressure angle of the second cam, in the stroke that it drives [rad]."
    ]
    least_pressure_angle: Annotated[Angle, "Lowest pressure angle of the second cam [rad]."]
    least_convex_radius: Annotated[
        Coordinate | None, "Minimum radius of curvature of the second cam where it is convex [m]."
    ]


@record
class CamSize:
    """The smallest cam."""

    base_radius: Annotated[Size, "Minimum radius of the base circle [m]."]
    offset: Annotated[Coordinate | None, "Offset of the slide, to the right [m]."]
    start_radius: Annotated[
        Size | None, "Distance of the roller's centre from the cam's axis at zero lift, R_b + R_r [m]."
    ]
    arm_start_angle: Annotated[Angle | None, "Angle of the arm from the line pivot–axis at zero lift [rad]."]
    binding: Annotated[Text, "The limits that decide."]
    largest_pressure_angle: Annotated[Angle, "Largest positive pressure angle of this cam [rad]."]
    least_pressure_angle: Annotated[Angle, "Lowest pressure angle of this cam [rad]."]
    least_convex_radius: Annotated[Coordinate | None, "Minimum radius of curvature of this cam where it is convex [m]."]
    least_concave_radius: Annotated[
        Coordinate | None, "Minimum radius of curvature of an outer flank, where the roller's path is hollow [m]."
    ]
    in_line_base_radius: Annotated[
        Size | None,
        "Minimum base circle radius without an offset, for the same limits; where only pressure angles bind [m].",
    ]
    face_width: Annotated[Size | None, "Length of the flat face with its margins [m]."]
    roller_distance: Annotated[Size | None, "Distance of the rollers' centres of a conjugate pair [m]."] = None
    arm_angle: Annotated[Angle | None, "Angle between the two arms of a conjugate pair [rad]."] = None
    second: Annotated[SecondCam | None, "The second cam of a conjugate pair."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None
