"""Followers of a radial cam and where they stand: knife-edge, roller and flat, translating and oscillating.

The frame is fixed: the cam's axis at the origin, a translating follower along +y, an arm's pivot on +x. The cam turns
anticlockwise unless said otherwise; its own points are those of this frame turned back by the cam angle.
"""

from math import atan2, fsum, pi, sqrt

from dynamics_cli.errors import require
from dynamics_cli.quantities import Angle, Coordinate, Size
from dynamics_cli.records import Choice, record, tagged

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Rotation(Choice):
    """Which way the cam turns."""

    names = ("counter-clockwise", "clockwise")
    aliases = {"ccw": "counter-clockwise", "anticlockwise": "counter-clockwise", "cw": "clockwise"}  # noqa: RUF012


class Flank(Choice):
    """Which surface: of a disc or the inner one of a closed track, or the outer one of a closed track."""

    names = ("inner", "outer")


@tagged("follower")
@record
class KnifeEdge:
    """A translating follower that touches in a point.

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle [m].
    offset : Coordinate
        How far to the right of the cam's axis the follower slides [m].
    """

    base_radius: Size
    offset: Coordinate = 0.0


@tagged("follower")
@record
class Roller:
    """A translating follower with a roller.

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle of the cam, without the roller [m].
    roller_radius : Size
        Radius of the roller [m].
    offset : Coordinate
        How far to the right of the cam's axis the follower slides [m].
    """

    base_radius: Size
    roller_radius: Size
    offset: Coordinate = 0.0


@tagged("follower")
@record
class FlatFace:
    """A translating follower with a flat face square to its way.

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle [m].
    """

    base_radius: Size


@tagged("follower")
@record
class OscillatingRoller:
    """A roller on an arm; the lift is the arm's angle, outwards positive.

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle of the cam, without the roller [m].
    roller_radius : Size
        Radius of the roller [m].
    arm : Size
        Length of the arm from its pivot to the roller's centre [m].
    pivot_distance : Size
        Distance of the pivot from the cam's axis [m].
    """

    base_radius: Size
    roller_radius: Size
    arm: Size
    pivot_distance: Size


@tagged("follower")
@record
class OscillatingFlat:
    """A flat face on an arm; the lift is the arm's angle, outwards positive.

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle [m].
    pivot_distance : Size
        Distance of the pivot from the cam's axis [m].
    face_offset : Coordinate
        How far the face stands from the pivot towards the cam [m].
    """

    base_radius: Size
    pivot_distance: Size
    face_offset: Coordinate = 0.0


@tagged("follower")
@record
class ConjugateRoller:
    """The second cam of a conjugate pair: a second roller on the same slide, on the other side of the cam's axis.

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle of the first cam [m].
    roller_radius : Size
        Radius of both rollers [m].
    roller_distance : Size
        Distance of the two rollers' centres [m].
    offset : Coordinate
        How far to the right of the cam's axis the slide is [m].
    """

    base_radius: Size
    roller_radius: Size
    roller_distance: Size
    offset: Coordinate = 0.0


@tagged("follower")
@record
class ConjugateOscillatingRoller:
    """The second cam of a conjugate pair: a second roller on the same rocker, on the other side of the cam's axis.

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle of the first cam [m].
    roller_radius : Size
        Radius of both rollers [m].
    arm : Size
        Length of both arms [m].
    pivot_distance : Size
        Distance of the pivot from the cam's axis [m].
    arm_angle : Angle
        Angle between the two arms [rad].
    """

    base_radius: Size
    roller_radius: Size
    arm: Size
    pivot_distance: Size
    arm_angle: Angle


Follower = (
    KnifeEdge | Roller | FlatFace | OscillatingRoller | OscillatingFlat | ConjugateRoller | ConjugateOscillatingRoller
)

FLAT = (FlatFace, OscillatingFlat)
MATES = (ConjugateRoller, ConjugateOscillatingRoller)


def require_lift(motion: "Any", oscillating: bool) -> None:
    """Refuse a lift that is an angle for a slide, and one that is a length for an arm."""
    require(
        bool(motion.swing) == oscillating,
        "an arm's lift is an angle, and this program's lift is a length"
        if oscillating
        else "a sliding follower's lift is a length, and this program's lift is an angle",
        code="lift-kind",
        hint='write "rise 15 deg in 90 deg …" for an arm, "rise 20 mm in 90 deg …" for a slide',
    )


def require_limits(rise_limit: float, return_limit: float) -> None:
    """Refuse limits of pressure angle that are no angles between 0 and 90 degrees."""
    for name, limit in (("rise", rise_limit), ("return", return_limit)):
        require(
            0.0 < limit < 0.5 * pi,
            "the {0} limit of {1:.6g} deg is not between 0 and 90 deg",
            name,
            limit * 180.0 / pi,
            code="limit",
            hint="30 deg is usual for a translating follower, 45 deg for an arm",
        )


def roller_radius(follower: Follower) -> float:
    """Radius of the roller, zero where there is none."""
    return getattr(follower, "roller_radius", 0.0)


def start_height(base_radius: float, roller_radius: float, offset: float) -> float:
    """Height √(Rp² − e²) of the roller's centre above the cam's axis where the lift is zero.

    Equation
    --------
    d = √((Rp − e)(Rp + e)), Rp = R_b + R_r.

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle [m].
    roller_radius : Size
        Radius of the roller [m].
    offset : Coordinate
        Offset of the slide [m].

    Returns
    -------
    float
        The height [m].

    Raises
    ------
    InadmissibleError
        When the offset exceeds the radius: the follower would slide past the base circle.

    Notes
    -----
    The factored root keeps its digits where the offset nears the radius.

    Examples
    --------
    >>> start_height(0.04, 0.01, 0.03)
    0.04
    """
    prime = base_radius + roller_radius
    require(
        abs(offset) <= prime,
        "the offset {0:.6g} m exceeds the radius {1:.6g} m at which the follower starts: it slides past the cam",
        offset,
        prime,
        code="offset",
        hint=f"bring the offset below {prime:.6g} m",
    )
    # sums of three are rounded once: next to the limit the difference is all there is
    return sqrt(max(fsum((base_radius, roller_radius, -offset)) * fsum((base_radius, roller_radius, offset)), 0.0))


def start_angle_of_arm(base_radius: float, roller_radius: float, arm: float, pivot_distance: float) -> float:
    """Angle of the arm from the line pivot–axis where the lift is zero.

    Equation
    --------
    tan(ψ₀/2) = √((Rp − |c − L|)(Rp + |c − L|)) / √((c + L − Rp)(c + L + Rp)).

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle [m].
    roller_radius : Size
        Radius of the roller [m].
    arm : Size
        Length of the arm [m].
    pivot_distance : Size
        Distance of the pivot from the cam's axis [m].

    Returns
    -------
    float
        The angle, between 0 and π.

    Raises
    ------
    InadmissibleError
        When the three lengths make no triangle.

    Notes
    -----
    Relative error of a few roundings up to the limits of the triangle, where the arc cosine would lose half the digits.

    Examples
    --------
    >>> round(start_angle_of_arm(0.03, 0.0, 0.04, 0.05), 12) == round(atan2(3.0, 4.0), 12)
    True
    """
    prime, difference, both = base_radius + roller_radius, abs(pivot_distance - arm), pivot_distance + arm
    require(
        difference <= prime <= both and prime > 0.0 and arm > 0.0 and pivot_distance > 0.0,
        "arm {0:.6g} m, pivot distance {1:.6g} m and start radius {2:.6g} m make no triangle: the roller cannot stand "
        "on the base circle",
        arm,
        pivot_distance,
        prime,
        code="no-triangle",
        hint=f"a base circle of {max(difference - roller_radius, 0.0):.6g} m to {both - roller_radius:.6g} m fits"
        if roller_radius < both
        else "take a smaller roller, or a longer arm farther from the cam",
    )
    short, long = min(arm, pivot_distance), max(arm, pivot_distance)
    inside = fsum((base_radius, roller_radius, short, -long)) * fsum((base_radius, roller_radius, long, -short))
    outside = fsum((arm, pivot_distance, -base_radius, -roller_radius)) * (both + prime)
    return 2.0 * atan2(sqrt(max(inside, 0.0)), sqrt(max(outside, 0.0)))


def start_angle_of_face(base_radius: float, face_offset: float, pivot_distance: float) -> float:
    """Angle of a flat rocker from the line pivot–axis where the lift is zero: sin ψ₀ = (R_b + f)/c.

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle [m].
    face_offset : Coordinate
        How far the face stands from the pivot towards the cam [m].
    pivot_distance : Size
        Distance of the pivot from the cam's axis [m].

    Returns
    -------
    float
        The angle, between 0 and π/2.

    Raises
    ------
    InadmissibleError
        When the pivot lies inside the circle the face has to touch.

    Notes
    -----
    atan2 in place of the arc sine keeps the digits near a right angle.

    Examples
    --------
    >>> round(start_angle_of_face(0.03, 0.0, 0.05), 9) == round(atan2(3.0, 4.0), 9)
    True
    """
    reach = base_radius + face_offset
    require(
        0.0 <= reach < pivot_distance,
        "the face cannot touch the base circle: base radius and face offset are {0:.6g} m together, the pivot is "
        "{1:.6g} m from the cam's axis",
        reach,
        pivot_distance,
        code="pivot-inside",
        hint="move the pivot outwards",
    )
    return atan2(reach, sqrt(fsum((pivot_distance, -base_radius, -face_offset)) * (pivot_distance + reach)))


def mate_angle(follower: ConjugateOscillatingRoller) -> float:
    """Angle of the second arm of a rocker where the lift is zero, between -π and 0."""
    first = start_angle_of_arm(follower.base_radius, follower.roller_radius, follower.arm, follower.pivot_distance)
    angle = first - follower.arm_angle
    require(
        -pi < angle < 0.0,
        "the arms, {0:.6g} deg apart, are on one side of the cam's axis: the second has to reach beyond it",
        follower.arm_angle * 180.0 / pi,
        code="arm-angle",
        hint=f"an arm angle above {first * 180.0 / pi:.6g} deg",
    )
    return angle
