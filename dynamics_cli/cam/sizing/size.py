"""The smallest cam that keeps limits of pressure angle and curvature, with the best offset of its slide."""

from math import pi

from dynamics_cli.cam.geometry.followers import Flank, Rotation, require_lift, require_limits
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.cam.sizing.records import (
    SWINGING,
    TRACKED,
    CamSize,
    ConjugateOscillatingRoller,
    ConjugateRoller,
    FlatFace,
    OscillatingFlat,
    OscillatingRoller,
    Wanted,
)
from dynamics_cli.errors import require
from dynamics_cli.quantities import Angle, Annotated, Size, Text
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

CCW = Rotation("counter-clockwise")
INNER = Flank("inner")
DEGREE = pi / 180.0


def size(
    scene: Annotated[Program, "One turn of the cam in segments, from a file."],
    /,
    *,
    program: Annotated[Text, "Segments in one line, in place of a file."] = "",
    follower: Annotated[Wanted, "The follower; its base circle is calculated, and its offset too unless given."],
    rise_limit: Annotated[Angle, "Largest positive pressure angle allowed, in the rise [rad]."] = 30.0 * DEGREE,
    return_limit: Annotated[Angle, "Largest negative pressure angle allowed, in the return [rad]."] = 30.0 * DEGREE,
    least_radius: Annotated[
        Size | None,
        "Minimum radius of curvature allowed where the cam is convex; of an outer flank, where the roller's path is "
        "concave, e.g. 10 mm [m].",
    ] = None,
    rotation: Annotated[Rotation, "Which way the cam turns."] = CCW,
    flank: Annotated[
        Flank,
        "The inner surface, that of a disc cam, or the outer flank of a closed track, whose curvature is then limited.",
    ] = INNER,
) -> CamSize:
    """Smallest base circle, and best offset, for limits of pressure angle and radius of curvature.

    Equation
    --------
    A = max(s′ cot φ₁ − s), B = max(−s′ cot φ₂ − s): d + e cot φ₁ ≥ A, d − e cot φ₂ ≥ B, R_p² = d² + e²; at the apex
    e* = (A − B)/(cot φ₁ + cot φ₂), d* = A − e* cot φ₁. Flat face: R_b = ρ − min(s + s″).
    Arm: ψ₀ ≥ max(acos q₂ − φ₂ − s), q = L(1 + ψ′) cos φ/c. Flat rocker: ψ₀ ≥ max(asin(C/M) − β − s),
    C = (ρ + f)(1 + ψ′)³/c, M e^{iβ} = (1 + 2ψ′)(1 + ψ′) + iψ″, R_b = c sin ψ₀ − f.

    Returns
    -------
    CamSize
        Base radius, offset, the binding limits, and the extremes of the resulting cam.

    Raises
    ------
    InadmissibleError
        When a limit is not between 0 and 90 degrees, or no base circle keeps the limits (long arms).

    Notes
    -----
    The extremes are those of Chebyshev interpolants of every piece; the rest of a pressure-limited size is closed form
    (the hodograph construction). Where the apex is not the nearest point, the foot of the perpendicular on the line
    that binds is. A radius of curvature that binds is met by a secant on extremes over the turn from the largest root
    in X of w³ = ρ·D; with a free offset, every dip of the start radius over a grid of offsets is followed by golden
    section to 1e-13 of the reach. A conjugate pair keeps the limits on both cams, each of which drives one stroke: the
    second is the first one for the inverted motion, mirrored. In a closed track both flanks share their pressure
    angles: size it for the inner flank and for the outer, and take the larger.

    References
    ----------
    Flocke's construction of the smallest cam.

    Examples
    --------
    >>> from dynamics_cli.cam.program.reading import program_of
    >>> from dynamics_cli.cam.sizing.records import Roller
    >>> result = size(program_of("rise 10 mm in 180 deg 3-4-5; return in 180 deg 3-4-5"), follower=Roller(0.005))
    >>> result.offset
    0.0
    """
    require_limits(rise_limit, return_limit)
    from dynamics_cli.cam.program.pieces import joint_jumps

    motion = motion_of(scene, program)
    require_lift(motion, isinstance(follower, SWINGING))
    require(
        str(flank) == "inner" or isinstance(follower, TRACKED),
        "only a roller on a slide or an arm runs in a track that has an outer flank",
        code="flank",
        hint="leave --flank out; the second cam of a conjugate pair takes the place of an outer flank",
    )
    answer = _sized(motion, follower, (rise_limit, return_limit), least_radius, rotation, flank)
    jumps = joint_jumps(motion)[0]
    if not jumps:
        return answer
    message = f"the follower's velocity jumps at {jumps} joints: no base circle keeps the cam from an edge there"
    remedy = "choose laws whose velocities join; `dynamics cam check` gives the lift that an edge costs"
    return CamSize(**{**vars(answer), "advice": (*answer.advice, Advice("velocity-jump", message, "serious", remedy))})


def _sized(
    motion: "Any", follower: Wanted, limits: tuple[float, float], least_radius: float | None, rotation: Rotation,
    flank: Flank,
) -> CamSize:  # fmt: skip
    """The size by the kind of follower."""
    if isinstance(follower, OscillatingRoller | OscillatingFlat):
        from dynamics_cli.cam.sizing.arms import size_arm
        from dynamics_cli.cam.sizing.rockers import size_rocker

        if isinstance(follower, OscillatingFlat):
            return size_rocker(motion, follower, limits, least_radius or 0.0, rotation)
        return size_arm(motion, follower, limits, least_radius, rotation, flank)
    if isinstance(follower, ConjugateRoller | ConjugateOscillatingRoller):
        from dynamics_cli.cam.sizing.pairs import size_arms, size_pair

        sized = size_pair if isinstance(follower, ConjugateRoller) else size_arms
        return sized(motion, follower, limits, least_radius, rotation)
    from dynamics_cli.cam.sizing.slides import size_flat, size_slide

    if isinstance(follower, FlatFace):
        return size_flat(motion, follower, least_radius or 0.0, rotation)
    return size_slide(motion, follower, limits, least_radius, rotation, flank)
