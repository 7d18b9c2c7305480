"""Followers of a radial cam and their positions: knife-edge, roller and flat, translating and oscillating.

The frame is fixed: the cam's axis at the origin, a translating follower along +y, an arm's pivot on +x. The cam turns
anticlockwise unless said otherwise; points of the cam are those of this frame rotated back by the cam angle.
"""

from math import atan2, fsum, pi, sqrt

from dynamics_cli.errors import require
from dynamics_cli.quantities import Angle, Annotated, Coordinate, Size
from dynamics_cli.records import Choice, record, tagged

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Rotation(Choice):
    """Sense of rotation of the cam."""

    names = ("counter-clockwise", "clockwise")
    aliases = {"ccw": "counter-clockwise", "anticlockwise": "counter-clockwise", "cw": "clockwise"}  # noqa: RUF012


class Flank(Choice):
    """Working surface: of a disc or the inner one of a closed track, or the outer one of a closed track."""

    names = ("inner", "outer")


@tagged("follower")
@record
class KnifeEdge:
    """A translating follower that touches in a point."""

    also = ("pointed",)

    base_radius: Annotated[Size, "Radius of the base circle, e.g. 25 mm [m]."]
    offset: Annotated[Coordinate, "How far to the right of the cam's axis the follower slides [m]."] = 0.0


@tagged("follower")
@record
class Roller:
    """A translating follower with a roller."""

    base_radius: Annotated[Size, "Radius of the base circle of the cam, without the roller, e.g. 25 mm [m]."]
    roller_radius: Annotated[Size, "Radius of the roller, e.g. 6 mm [m]."]
    offset: Annotated[Coordinate, "How far to the right of the cam's axis the follower slides [m]."] = 0.0


@tagged("follower")
@record
class FlatFace:
    """A translating follower with a flat face perpendicular to its motion."""

    also = ("flat", "mushroom")

    base_radius: Annotated[Size, "Radius of the base circle, e.g. 25 mm [m]."]


@tagged("follower")
@record
class OscillatingRoller:
    """A roller on an arm; the lift is the arm's angle, outwards positive."""

    also = ("swinging-roller", "arm-roller")

    base_radius: Annotated[Size, "Radius of the base circle of the cam, without the roller, e.g. 25 mm [m]."]
    roller_radius: Annotated[Size, "Radius of the roller, e.g. 6 mm [m]."]
    arm: Annotated[Size, "Length of the arm from its pivot to the roller's centre, e.g. 80 mm [m]."]
    pivot_distance: Annotated[Size, "Distance of the pivot from the cam's axis, e.g. 100 mm [m]."]


@tagged("follower")
@record
class OscillatingFlat:
    """A flat face on an arm; the lift is the arm's angle, outwards positive."""

    also = ("swinging-flat", "oscillating-flat-face")

    base_radius: Annotated[Size, "Radius of the base circle, e.g. 25 mm [m]."]
    pivot_distance: Annotated[Size, "Distance of the pivot from the cam's axis, e.g. 100 mm [m]."]
    face_offset: Annotated[Coordinate, "How far the face stands from the pivot towards the cam [m]."] = 0.0


@tagged("follower")
@record
class ConjugateRoller:
    """The second cam of a conjugate pair: a second roller on the same slide, on the other side of the cam's axis."""

    base_radius: Annotated[Size, "Radius of the base circle of the first cam, e.g. 25 mm [m]."]
    roller_radius: Annotated[Size, "Radius of both rollers, e.g. 6 mm [m]."]
    roller_distance: Annotated[Size, "Distance of the two rollers' centres, e.g. 75 mm [m]."]
    offset: Annotated[Coordinate, "How far to the right of the cam's axis the slide is [m]."] = 0.0


@tagged("follower")
@record
class ConjugateOscillatingRoller:
    """The second cam of a conjugate pair: a second roller on the same rocker, on the other side of the cam's axis."""

    base_radius: Annotated[Size, "Radius of the base circle of the first cam, e.g. 25 mm [m]."]
    roller_radius: Annotated[Size, "Radius of both rollers, e.g. 6 mm [m]."]
    arm: Annotated[Size, "Length of both arms, e.g. 80 mm [m]."]
    pivot_distance: Annotated[Size, "Distance of the pivot from the cam's axis, e.g. 100 mm [m]."]
    arm_angle: Annotated[Angle, "Angle between the two arms, e.g. 60 deg [rad]."]


Follower = (
    KnifeEdge | Roller | FlatFace | OscillatingRoller | OscillatingFlat | ConjugateRoller | ConjugateOscillatingRoller
)

FLAT = (FlatFace, OscillatingFlat)
MATES = (ConjugateRoller, ConjugateOscillatingRoller)


def require_lift(motion: "Any", oscillating: bool) -> None:
    """Refuse an angular lift of a slide, a linear one of an arm, and an arm that swings all the way round."""
    require(
        bool(motion.swing) == oscillating,
        "an arm's lift is an angle, and this program's lift is a length"
        if oscillating
        else "a sliding follower's lift is a length, and this program's lift is an angle",
        code="lift-kind",
        hint='write "rise 15 deg in 90 deg …" for an arm, "rise 20 mm in 90 deg …" for a slide',
    )
    most = max(map(abs, motion.stroke)) if oscillating else 0.0
    require(
        most < 2.0 * pi,
        "a swing of {swing} takes the arm all the way round its pivot",
        swing=(most, Angle),
        turn=(2.0 * pi, Angle),
        code="swing",
        hint="give a swing below {turn}",
    )


def require_limits(rise_limit: float, return_limit: float) -> None:
    """Refuse limits of pressure angle outside 0 to 90 degrees."""
    for name, limit in (("rise", rise_limit), ("return", return_limit)):
        require(
            0.0 < limit < 0.5 * pi,
            "the {name} limit of {limit} is not between {low} and {high}",
            name=name, limit=(limit, Angle), low=(0.0, Angle), high=(0.5 * pi, Angle),
            code="limit",
            hint="{slide} is usual for a translating follower, {arm} for an arm",
            slide=(pi / 6.0, Angle), arm=(0.25 * pi, Angle),
        )  # fmt: skip


def roller_radius(follower: Follower) -> float:
    """Radius of the roller, zero where there is none."""
    return getattr(follower, "roller_radius", 0.0)


def start_height(base_radius: float, roller_radius: float, offset: float) -> float:
    """Height √(Rp² − e²) of the roller's centre above the cam's axis where the lift is zero.

    `base_radius`: radius of the base circle, e.g. 25 mm [m]; `roller_radius`: radius of the roller, e.g. 6 mm [m];
    `offset`: offset of the slide [m]. Returns the height [m]. Raises InadmissibleError when the offset exceeds the
    radius: the follower would slide past the base circle.

    The factored root keeps its digits where the offset nears the radius.

    Equation
    --------
    d = √((Rp − e)(Rp + e)), Rp = R_b + R_r.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.4 to 16.8.

    Examples
    --------
    >>> start_height(0.04, 0.01, 0.03)
    0.04
    """
    prime = base_radius + roller_radius
    require(
        abs(offset) <= prime,
        "the offset {offset} exceeds the radius {prime} at which the follower starts: it slides past the cam",
        offset=(offset, Coordinate),
        prime=(prime, Size),
        code="offset",
        hint="take an offset below {prime}",
    )
    # sums of three are rounded once: next to the limit only the difference matters
    return sqrt(max(fsum((base_radius, roller_radius, -offset)) * fsum((base_radius, roller_radius, offset)), 0.0))


def start_angle_of_arm(base_radius: float, roller_radius: float, arm: float, pivot_distance: float) -> float:
    """Angle of the arm from the line pivot–axis where the lift is zero.

    `base_radius`: radius of the base circle, e.g. 25 mm [m]; `roller_radius`: radius of the roller, e.g. 6 mm [m];
    `arm`: length of the arm [m]; `pivot_distance`: distance of the pivot from the cam's axis, e.g. 100 mm [m]. Returns
    the angle, between 0 and π. Raises InadmissibleError when the three lengths make no triangle.

    Relative error of a few roundings up to the limits of the triangle, where the arc cosine would lose half the digits.

    Equation
    --------
    tan(ψ₀/2) = √((Rp − |c − L|)(Rp + |c − L|)) / √((c + L − Rp)(c + L + Rp)).

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.4 to 16.8.

    Examples
    --------
    >>> round(start_angle_of_arm(0.03, 0.0, 0.04, 0.05), 12) == round(atan2(3.0, 4.0), 12)
    True
    """
    prime, difference, longest = base_radius + roller_radius, abs(pivot_distance - arm), pivot_distance + arm
    require(
        difference <= prime <= longest and prime > 0.0 and arm > 0.0 and pivot_distance > 0.0,
        "arm {arm}, pivot distance {pivot} and start radius {prime} do not form a triangle: the roller cannot touch "
        "the base circle",
        arm=(arm, Size), pivot=(pivot_distance, Size), prime=(prime, Size),
        code="no-triangle",
        hint="take a base radius of {least:6} to {most:6}"
        if roller_radius < longest
        else "take a smaller roller, or a longer arm farther from the cam",
        least=(max(difference - roller_radius, 0.0), Size), most=(longest - roller_radius, Size),
    )  # fmt: skip
    short, long = min(arm, pivot_distance), max(arm, pivot_distance)
    inside = fsum((base_radius, roller_radius, short, -long)) * fsum((base_radius, roller_radius, long, -short))
    outside = fsum((arm, pivot_distance, -base_radius, -roller_radius)) * (longest + prime)
    return 2.0 * atan2(sqrt(max(inside, 0.0)), sqrt(max(outside, 0.0)))


def start_angle_of_face(base_radius: float, face_offset: float, pivot_distance: float) -> float:
    """Angle of a flat rocker from the line pivot–axis where the lift is zero: sin ψ₀ = (R_b + f)/c.

    `base_radius`: radius of the base circle, e.g. 25 mm [m]; `face_offset`: offset of the face from the pivot
    towards the cam [m]; `pivot_distance`: distance of the pivot from the cam's axis, e.g. 100 mm [m]. Returns the
    angle, between 0 and π/2. Raises InadmissibleError when the pivot lies inside the circle the face has to touch.

    atan2 in place of the arc sine keeps the digits near a right angle.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.4 to 16.8.

    Examples
    --------
    >>> round(start_angle_of_face(0.03, 0.0, 0.05), 9) == round(atan2(3.0, 4.0), 9)
    True
    """
    reach = base_radius + face_offset
    require(
        0.0 <= reach < pivot_distance,
        "the face cannot touch the base circle: base radius and face offset sum to {reach}, and the pivot is {pivot} "
        "from the cam's axis",
        reach=(reach, Coordinate),
        pivot=(pivot_distance, Size),
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
        "the arms, {angle} apart, are on one side of the cam's axis; the second must be on the other side",
        angle=(follower.arm_angle, Angle),
        first=(first, Angle),
        code="arm-angle",
        hint="take an arm angle above {first:6}",
    )
    return angle
