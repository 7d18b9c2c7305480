"""The smallest cam that keeps limits of pressure angle and curvature, with the best offset of its slide."""

from math import pi

from dynamics_cli.cam.followers import Flank, Rotation, require_lift, require_limits
from dynamics_cli.cam.program import Program, motion_of
from dynamics_cli.errors import require
from dynamics_cli.quantities import Angle, Coordinate, Size, Text
from dynamics_cli.records import Advice, Check, Numerics, record, tagged

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

CCW = Rotation("counter-clockwise")
INNER = Flank("inner")
DEGREE = pi / 180.0


@tagged("follower")
@record
class KnifeEdge:
    """A translating knife-edge.

    Parameters
    ----------
    offset : Coordinate
        Offset of the slide; the best one is found when it is not given [m].
    """

    offset: Coordinate | None = None


@tagged("follower")
@record
class Roller:
    """A translating roller.

    Parameters
    ----------
    roller_radius : Size
        Radius of the roller [m].
    offset : Coordinate
        Offset of the slide; the best one is found when it is not given [m].
    """

    roller_radius: Size
    offset: Coordinate | None = None


@tagged("follower")
@record
class FlatFace:
    """A translating flat face.

    Parameters
    ----------
    face_margin : Size
        Length of face wanted beyond the last contact on either side [m].
    """

    face_margin: Size = 0.0


@tagged("follower")
@record
class OscillatingRoller:
    """A roller on an arm of known length and pivot.

    Parameters
    ----------
    roller_radius : Size
        Radius of the roller [m].
    arm : Size
        Length of the arm [m].
    pivot_distance : Size
        Distance of the pivot from the cam's axis [m].
    """

    roller_radius: Size
    arm: Size
    pivot_distance: Size


@tagged("follower")
@record
class OscillatingFlat:
    """A flat face on an arm of known pivot.

    Parameters
    ----------
    pivot_distance : Size
        Distance of the pivot from the cam's axis [m].
    face_offset : Coordinate
        How far the face stands from the pivot towards the cam [m].
    face_margin : Size
        Length of face wanted beyond the last contact on either side [m].
    """

    pivot_distance: Size
    face_offset: Coordinate = 0.0
    face_margin: Size = 0.0


@tagged("follower")
@record
class ConjugateRoller:
    """Two rollers on one slide, on either side of the cam's axis, each on a cam of its own.

    Parameters
    ----------
    roller_radius : Size
        Radius of both rollers [m].
    roller_distance : Size
        Distance of the two rollers' centres; the shortest one is found when it is not given [m].
    offset : Coordinate
        Offset of the slide [m].
    """

    roller_radius: Size
    roller_distance: Size | None = None
    offset: Coordinate = 0.0


@tagged("follower")
@record
class ConjugateOscillatingRoller:
    """Two rollers on one rocker, on either side of the cam's axis, each on a cam of its own.

    Parameters
    ----------
    roller_radius : Size
        Radius of both rollers [m].
    arm : Size
        Length of both arms [m].
    pivot_distance : Size
        Distance of the pivot from the cam's axis [m].
    arm_angle : Angle
        Angle between the two arms; the smallest one is found when it is not given [rad].
    """

    roller_radius: Size
    arm: Size
    pivot_distance: Size
    arm_angle: Angle | None = None


Wanted = (
    KnifeEdge | Roller | FlatFace | OscillatingRoller | OscillatingFlat | ConjugateRoller | ConjugateOscillatingRoller
)


SWINGING = (OscillatingRoller, OscillatingFlat, ConjugateOscillatingRoller)
TRACKED = (Roller, OscillatingRoller)


@record
class SecondCam:
    """The second cam of a conjugate pair.

    Parameters
    ----------
    start_radius : Size
        Distance of the second roller's centre from the cam's axis at zero lift [m].
    largest_pressure_angle : Angle
        Largest positive pressure angle of the second cam, that of the stroke it drives [rad].
    least_pressure_angle : Angle
        Lowest pressure angle of the second cam [rad].
    least_convex_radius : Coordinate
        Least radius of curvature of the second cam where it is convex [m].
    """

    start_radius: Size
    largest_pressure_angle: Angle
    least_pressure_angle: Angle
    least_convex_radius: Coordinate | None


@record
class CamSize:
    """The smallest cam.

    Parameters
    ----------
    base_radius : Size
        Least radius of the base circle [m].
    offset : Coordinate
        Offset of the slide, to the right [m].
    start_radius : Size
        Distance of the roller's centre from the cam's axis at zero lift, R_b + R_r [m].
    arm_start_angle : Angle
        Angle of the arm from the line pivot–axis at zero lift [rad].
    binding : Text
        The limits that decide.
    largest_pressure_angle : Angle
        Largest positive pressure angle of this cam [rad].
    least_pressure_angle : Angle
        Lowest pressure angle of this cam [rad].
    least_convex_radius : Coordinate
        Least radius of curvature of this cam where it is convex [m].
    least_concave_radius : Coordinate
        Least radius of curvature of an outer flank, where the roller's path is hollow [m].
    in_line_base_radius : Size
        Least radius of the base circle without an offset, for the same limits; where only pressure angles bind [m].
    face_width : Size
        Length of the flat face with its margins [m].
    roller_distance : Size
        Distance of the rollers' centres of a conjugate pair [m].
    arm_angle : Angle
        Angle between the two arms of a conjugate pair [rad].
    second : SecondCam
        The second cam of a conjugate pair.
    """

    base_radius: Size
    offset: Coordinate | None
    start_radius: Size | None
    arm_start_angle: Angle | None
    binding: Text
    largest_pressure_angle: Angle
    least_pressure_angle: Angle
    least_convex_radius: Coordinate | None
    least_concave_radius: Coordinate | None
    in_line_base_radius: Size | None
    face_width: Size | None
    roller_distance: Size | None = None
    arm_angle: Angle | None = None
    second: SecondCam | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def size(
    scene: Program,
    /,
    *,
    program: Text = "",
    follower: Wanted,
    rise_limit: Angle = 30.0 * DEGREE,
    return_limit: Angle = 30.0 * DEGREE,
    least_radius: Size | None = None,
    rotation: Rotation = CCW,
    flank: Flank = INNER,
) -> CamSize:
    """Smallest base circle, and best offset, for limits of pressure angle and radius of curvature.

    Equation
    --------
    A = max(s′ cot φ₁ − s), B = max(−s′ cot φ₂ − s): d + e cot φ₁ ≥ A, d − e cot φ₂ ≥ B, R_p² = d² + e²; at the apex
    e* = (A − B)/(cot φ₁ + cot φ₂), d* = A − e* cot φ₁. Flat face: R_b = ρ − min(s + s″).
    Arm: ψ₀ ≥ max(acos q₂ − φ₂ − s), q = L(1 + ψ′) cos φ/c. Flat rocker: ψ₀ ≥ max(asin(C/M) − β − s),
    C = (ρ + f)(1 + ψ′)³/c, M e^{iβ} = (1 + 2ψ′)(1 + ψ′) + iψ″, R_b = c sin ψ₀ − f.

    Parameters
    ----------
    scene : Program
        The motion of the follower over one turn of the cam, from a file.
    program : Text
        The motion in one line, in place of a file.
    follower : Wanted
        The follower; its base circle, and the offset if not given, are what is found.
    rise_limit : Angle
        Largest positive pressure angle allowed: that of the rise [rad].
    return_limit : Angle
        Largest negative pressure angle allowed: that of the return [rad].
    least_radius : Size
        Least radius of curvature allowed where the cam is convex; of an outer flank, where the roller's path is
        hollow [m].
    rotation : Rotation
        Which way the cam turns.
    flank : Flank
        The inner surface, that of a disc cam, or the outer flank of a closed track, whose curvature is then limited.

    Returns
    -------
    CamSize
        Base radius, offset, the limits that bind, and the extremes of the cam found.

    Raises
    ------
    InadmissibleError
        When a limit is not between 0 and 90 degrees, or no base circle keeps the limits (long arms).

    Notes
    -----
    The extremes are certified; the rest of a pressure-limited size is closed form (the hodograph construction done in
    numbers). Where the apex is not the nearest point, the foot of the perpendicular on the line that binds is. A radius
    of curvature that binds is met by a secant on certified extremes from the largest root in X of w³ = ρ·D; with a free
    offset, every dip of the start radius over a grid of offsets is followed by golden section to 1e-13 of the reach. A
    conjugate pair keeps the limits on both cams, each of which drives one stroke: the second is the first of the motion
    upside down in the mirror. In a closed track both flanks share their pressure angles: size it for the inner flank
    and for the outer, and take the larger.

    Examples
    --------
    >>> from dynamics_cli.cam.program import program_of
    >>> found = size(program_of("rise 10 mm in 180 deg 3-4-5; return in 180 deg 3-4-5"), follower=Roller(0.005))
    >>> found.offset
    0.0
    """
    require_limits(rise_limit, return_limit)
    from dynamics_cli.cam.pieces import joint_jumps

    motion = motion_of(scene, program)
    require_lift(motion, isinstance(follower, SWINGING))
    require(
        str(flank) == "inner" or isinstance(follower, TRACKED),
        "only a roller on a slide or an arm runs in a track that has an outer flank",
        code="flank",
        hint="leave --flank out; the second cam of a conjugate pair takes the place of an outer flank",
    )
    made = _sized(motion, follower, (rise_limit, return_limit), least_radius, rotation, flank)
    jumps = joint_jumps(motion)[0]
    if not jumps:
        return made
    message = f"the follower's velocity jumps at {jumps} joints: no base circle keeps the cam from an edge there"
    mend = "choose laws whose velocities join; `cam check` tells the lift that an edge costs"
    return CamSize(**{**vars(made), "advice": (*made.advice, Advice("velocity-jump", message, "serious", mend))})


def _sized(
    motion: "Any", follower: Wanted, limits: tuple[float, float], least_radius: float | None, rotation: Rotation,
    flank: Flank,
) -> CamSize:  # fmt: skip
    """The size by the kind of follower."""
    if isinstance(follower, OscillatingRoller | OscillatingFlat):
        from dynamics_cli.cam.sizing_arms import size_arm, size_rocker

        if isinstance(follower, OscillatingFlat):
            return size_rocker(motion, follower, limits, least_radius or 0.0, rotation)
        return size_arm(motion, follower, limits, least_radius, rotation, flank)
    if isinstance(follower, ConjugateRoller | ConjugateOscillatingRoller):
        from dynamics_cli.cam.sizing_pairs import size_arms, size_pair

        sized = size_pair if isinstance(follower, ConjugateRoller) else size_arms
        return sized(motion, follower, limits, least_radius, rotation)
    from dynamics_cli.cam.sizing import size_flat, size_slide

    if isinstance(follower, FlatFace):
        return size_flat(motion, follower, least_radius or 0.0, rotation)
    return size_slide(motion, follower, limits, least_radius, rotation, flank)


def best_slide(a: float, b: float, cot_rise: float, cot_return: float) -> tuple[float, float, str]:
    """The nearest (e, d) to the origin with d + e c₁ ≥ A and d − e c₂ ≥ B.

    Parameters
    ----------
    a, b : float
        A and B [m].
    cot_rise, cot_return : float
        Cotangents of the limits.

    Returns
    -------
    tuple
        Offset, height and the limits that bind.

    Raises
    ------
    ZeroDivisionError
        Never for limits between 0 and 90 degrees.

    Notes
    -----
    The apex is the answer unless the foot of the perpendicular on one line keeps the other.

    Examples
    --------
    >>> best_slide(2.0, 2.0, 1.0, 1.0)
    (0.0, 2.0, 'rise and return limit')
    """
    e = (a - b) / (cot_rise + cot_return)
    d = (a * cot_return + b * cot_rise) / (cot_rise + cot_return)
    if e > d * cot_rise:
        share = a / (1.0 + cot_rise * cot_rise)
        return share * cot_rise, share, "rise limit"
    if e < -d * cot_return:
        share = b / (1.0 + cot_return * cot_return)
        return -share * cot_return, share, "return limit"
    return e, d, "rise and return limit"
