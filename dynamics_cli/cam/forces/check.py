"""Certified verdicts about a cam: undercut and lost lift, pressure angle, curvature, face width, jump."""

from math import isinf, pi

from dynamics_cli.cam.geometry.followers import Flank, Follower, Rotation, require_lift, require_limits
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.errors import require, worded
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Coordinate,
    Count,
    Force,
    Inertia,
    Mass,
    Positive,
    ShaftSpeed,
    Size,
    Stiffness,
    Text,
    Torque,
    TorsionStiffness,
)
from dynamics_cli.records import Advice, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.cam.geometry.contact import Geometry

CCW = Rotation("counter-clockwise")
INNER = Flank("inner")
DEGREE = pi / 180.0


@record
class CamCheck:
    """Verdicts, each with the number that decides it and the cam angle where it occurs."""

    fits: Annotated[bool, "Whether the cam is within all limits."]
    binding: Annotated[Text, "The limits that are exceeded."]
    undercut: Annotated[bool, "Whether the cam profile crosses itself or has a cusp."]
    undercut_stretches: Annotated[
        Count, "Number of stretches where the envelope runs backwards; zero if only flanks far apart cross each other."
    ]
    pieces_cut_off: Annotated[Count | None, "Number of pieces that the undercut cuts off the cam."]
    lift_lost: Annotated[
        Coordinate | None,
        "Maximum lift that a sliding follower loses to undercutting; on an outer flank, its possible overshoot [m].",
    ]
    swing_lost: Annotated[
        Angle | None,
        "Maximum swing that an arm loses to undercutting; on an outer flank, its possible overshoot [rad].",
    ]
    lost_at: Annotated[Angle | None, "Cam angle of the maximum loss [rad]."]
    least_convex_radius: Annotated[
        Coordinate | None, "Minimum radius of curvature of the cam where the pitch curve is convex [m]."
    ]
    least_convex_radius_at: Annotated[Angle | None, "Cam angle there [rad]."]
    least_concave_radius: Annotated[
        Coordinate | None, "Minimum radius of curvature of the cam where it is concave [m]."
    ]
    least_concave_radius_at: Annotated[Angle | None, "Cam angle there [rad]."]
    curvature_kept: Annotated[bool | None, "Whether the radius of curvature stays above the given minimum."]
    largest_pressure_angle: Annotated[Angle, "Maximum pressure angle, compared with the limit of the rise [rad]."]
    largest_pressure_angle_at: Annotated[Angle, "Cam angle there [rad]."]
    least_pressure_angle: Annotated[Angle, "Minimum pressure angle, compared with the limit of the return [rad]."]
    least_pressure_angle_at: Annotated[Angle, "Cam angle there [rad]."]
    pressure_angle_kept: Annotated[bool, "Whether the pressure angle stays within both limits."]
    face_width: Annotated[Size | None, "Length of the flat face that the cam touches [m]."]
    face_kept: Annotated[bool | None, "Whether the given flat face is long enough."]
    velocity_jumps: Annotated[Count, "Number of joints where the follower's velocity jumps (an infinite force)."]
    acceleration_jumps: Annotated[Count, "Number of joints where its acceleration jumps."]
    jump_speed: Annotated[ShaftSpeed | None, "Speed of the cam at which the follower leaves it [rad/s]."]
    jump_at: Annotated[Angle | None, "Cam angle where it leaves the cam [rad]."]
    jump_kept: Annotated[bool | None, "Whether the follower stays on the cam at the given speed."]
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def check(
    scene: Annotated[Program, "One turn of the cam in segments, from a file."],
    /,
    *,
    program: Annotated[Text, "Segments in one line, in place of a file."] = "",
    follower: Annotated[Follower, "The follower and where it stands."],
    rotation: Annotated[Rotation, "Sense of rotation of the cam."] = CCW,
    flank: Annotated[Flank, "The inner surface, that of a disc cam, or the outer flank of a closed track."] = INNER,
    rise_limit: Annotated[Angle, "Largest positive pressure angle allowed [rad]."] = 30.0 * DEGREE,
    return_limit: Annotated[Angle, "Largest negative pressure angle allowed [rad]."] = 30.0 * DEGREE,
    least_radius: Annotated[Size, "Minimum radius of curvature allowed, convex or concave [m]."] = 0.0,
    face_width: Annotated[Size | None, "Length of the flat face, e.g. 25 mm [m]."] = None,
    mass: Annotated[Mass | None, "Mass moving with a sliding follower, for the jump speed, e.g. 0.2 kg [kg]."] = None,
    spring_rate: Annotated[Stiffness | None, "Stiffness of its spring, e.g. 20 N/mm [N/m]."] = None,
    preload: Annotated[Force | None, "Force of the spring at zero lift, e.g. 100 N [N]."] = None,
    inertia: Annotated[
        Inertia | None, "Moment of inertia of an arm about its pivot, for the jump speed, e.g. 0.002 kg*m^2 [kg*m^2]."
    ] = None,
    torsion_rate: Annotated[
        TorsionStiffness | None, "Rate of an arm's torsion spring at the pivot, e.g. 10 N*m/rad [N*m/rad]."
    ] = None,
    preload_torque: Annotated[Torque | None, "Torque of that spring at zero swing, e.g. 2 N*m [N*m]."] = None,
    shaft_speed: Annotated[ShaftSpeed | None, "Speed of the cam shaft to check, e.g. 1500 rpm [rad/s]."] = None,
    safety: Annotated[Positive, "Required ratio of the jump speed to the speed."] = 1.0,
) -> CamCheck:
    """Certified verdicts about a cam: undercut and lost lift, pressure angle, curvature, face width, jump.

    Equation
    --------
    Undercut where ds/dθ = w(1 − R_r κ_p) ≤ 0 (flat: R_b + s + s″ ≤ 0), or where the curve crosses itself; lift lost:
    programmed lift less the lift of the follower on the remaining corner; jump: ω² = min k(s + δ)/(−m s″) over s″ < 0,
    for an arm with its inertia and torques.

    Returns
    -------
    CamCheck
        The verdicts, with the numbers that decide them and the cam angles where they occur.

    Raises
    ------
    InadmissibleError
        When the cam is impossible, or the jump speed lacks mass, stiffness or preload (for an arm: inertia, torsion
        rate or preload torque).

    Notes
    -----
    Extremes come from Chebyshev interpolants of every piece of every law, fine enough for the last digits. A cusp
    counts as undercut; where rounding leaves it undecided, an advice says so. The corners of an undercut cam are
    crossings of its envelope. Bisection and Newton's method find them, however small the undercut, even where several
    merge. The edge is followed from corner to corner, which shows where a lobe is cut off at its neck. The lift lost is
    the maximum gap at a corner, from Chebyshev proxies with an estimated remainder of 3e-15 of the cam's size (1e-12
    where a loop is too small to separate its corner from its ends).

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.4 to 16.8.

    Examples
    --------
    >>> from dynamics_cli.cam.geometry.followers import Roller
    >>> result = check(Program(), program="rise 10 mm in 180 deg 3-4-5; return in 180 deg 3-4-5",
    ...     follower=Roller(0.025, 0.006))
    >>> result.fits, result.undercut
    (True, False)
    """
    from dynamics_cli.cam.forces.jump import asked_jump
    from dynamics_cli.cam.geometry.analysis import analyse, extreme_bounds, extreme_results, runs_forward
    from dynamics_cli.cam.geometry.contact import Geometry
    from dynamics_cli.cam.geometry.undercut import lift_lost
    from dynamics_cli.cam.program.pieces import joint_jumps

    geometry = Geometry(follower, rotation, flank)
    motion = motion_of(scene, program)
    require_lift(motion, geometry.oscillating)
    require_limits(rise_limit, return_limit)
    require(
        geometry.flat or face_width is None,
        "only a flat face has a width",
        code="face-width",
        hint="leave --face-width out",
    )
    analysis = analyse(geometry, motion)
    extremes = extreme_results(geometry, analysis)
    forward = runs_forward(geometry, analysis)
    loss = lift_lost(geometry, motion, forward=forward)
    velocity_jumps, acceleration_jumps = joint_jumps(motion)
    slide, arm = (mass, spring_rate, preload), (inertia, torsion_rate, preload_torque)
    jump = asked_jump(motion, slide, arm, asked=shaft_speed is not None)
    values = _decisive(extremes, analysis.face_width, velocity_jumps, jump and jump[0])
    limits = Limits(rise_limit, return_limit, least_radius, face_width, shaft_speed and safety * abs(shaft_speed))
    kept = {"undercut": loss is None, **_kept(values, limits)}
    exceeded = [name for name, within in kept.items() if not within]
    return CamCheck(
        fits=not exceeded,
        binding=", ".join(exceeded) or "nothing",
        **_undercut(geometry, loss),
        **extremes,
        **_verdicts(kept, limits),
        face_width=analysis.face_width,
        velocity_jumps=velocity_jumps,
        acceleration_jumps=acceleration_jumps,
        jump_speed=jump and jump[0],
        jump_at=jump and jump[1],
        advice=(*_on_undercut(geometry, loss, forward=forward), *_on_limits(exceeded, values, limits), *_on_jump(jump)),
        numerics=Numerics(
            "extremes from Chebyshev interpolants of every piece",
            (*extreme_bounds(geometry, analysis), *_lost_bound(geometry, loss), *_jump_bound(jump)),
        ),
    )


@record
class Decisive:
    """The numbers that decide the verdicts."""

    high: Angle
    low: Angle
    radius: Coordinate | None
    face: Size | None
    velocity_jumps: Count
    jump_speed: ShaftSpeed | None


@record
class Limits:
    """The limits for them."""

    rise: Angle
    return_: Angle
    radius: Size
    face: Size | None
    speed: ShaftSpeed | None


def _decisive(
    extremes: "dict[str, Any]", face: float | None, velocity_jumps: int, jump_speed: float | None
) -> Decisive:
    high, low = extremes["largest_pressure_angle"], extremes["least_pressure_angle"]
    radii = [extremes[name] for name in ("least_convex_radius", "least_concave_radius") if extremes[name] is not None]
    return Decisive(high, low, min(radii, default=None), face, velocity_jumps, jump_speed)


def _kept(values: Decisive, limits: Limits) -> "dict[str, bool]":
    """Which limits are kept, within rounding."""
    return {
        "rise limit": values.high <= limits.rise * (1.0 + 1e-12),
        "return limit": -values.low <= limits.return_ * (1.0 + 1e-12),
        "least radius of curvature": values.radius is None or values.radius >= limits.radius * (1.0 - 1e-12),
        "face width": limits.face is None or values.face is None or values.face <= limits.face,
        "velocity jump": values.velocity_jumps == 0,
        "jump speed": limits.speed is None or values.jump_speed is None or values.jump_speed >= limits.speed,
    }


def _verdicts(kept: "dict[str, bool]", limits: Limits) -> "dict[str, Any]":
    """The results about limits; None where no limit is given."""
    return {
        "curvature_kept": kept["least radius of curvature"],
        "pressure_angle_kept": kept["rise limit"] and kept["return limit"],
        "face_kept": None if limits.face is None else kept["face width"],
        "jump_kept": None if limits.speed is None else kept["jump speed"],
    }


def _undercut(geometry: "Geometry", loss: "Any") -> "dict[str, Any]":
    """The results about undercut: what is cut off, and the lift or swing lost to it where a surface remains."""
    lost = None if loss is None or isinf(loss.lift) else loss.lift
    return {
        "undercut": loss is not None,
        "undercut_stretches": 0 if loss is None else len(loss.stretches),
        "pieces_cut_off": loss and loss.pieces,
        "lift_lost": None if geometry.oscillating else lost,
        "swing_lost": lost if geometry.oscillating else None,
        "lost_at": None if lost is None else loss.at,
    }


def _lost_bound(geometry: "Geometry", loss: "Any") -> tuple[ErrorBound, ...]:
    if loss is None or isinf(loss.lift):
        return ()
    return (ErrorBound("swing_lost" if geometry.oscillating else "lift_lost", loss.error, relative=False),)


def _jump_bound(jump: "tuple[float | None, float | None, float] | None") -> tuple[ErrorBound, ...]:
    if jump is None or not jump[0]:
        return ()
    return (ErrorBound("jump_speed", jump[2] / jump[0]),)


def _on_undercut(geometry: "Geometry", loss: "Any", *, forward: bool) -> "list[Advice]":
    """Advice on the lift lost to undercutting, or on a cusp that rounding leaves undecided."""
    if loss is None:
        message = "the cam has a cusp, to the accuracy of the calculation"
        return [] if forward else [Advice("cusp", message, "caution", "raise the base radius a little")]
    arm = geometry.oscillating
    remedy = "raise the base radius, take a smaller roller, or give the motion a larger angle"
    if isinf(loss.lift):
        message = "the cam is undercut: no surface remains to support the follower"
        return [Advice("undercut", message, "serious", remedy, "swing_lost" if arm else "lift_lost")]
    template = "the cam is undercut: {amount:6} of {travel} is lost"
    if geometry.side < 0.0:
        template = "the outer flank is undercut: the follower can overshoot by {amount:6} of {travel}"
    if loss.pieces:
        template += ", and a piece of the cam is cut off"
    message = worded(template, amount=(loss.lift, Angle if arm else Coordinate), travel="swing" if arm else "lift")
    return [Advice("undercut", message, "serious", remedy)]


def _on_limits(exceeded: "Sequence[str]", values: Decisive, limits: Limits) -> "list[Advice]":
    """Advice on every limit that is exceeded, with the number beside the limit."""
    joints = "1 joint" if values.velocity_jumps == 1 else f"{values.velocity_jumps} joints"
    messages = {
        "rise limit": (
            "the pressure angle reaches {value:6}, beyond the rise limit of {limit:6}",
            (values.high, Angle), (limits.rise, Angle),
            "raise the base radius, offset the follower, or give the rise a larger angle",
        ),
        "return limit": (
            "the pressure angle reaches {value:6}, beyond the return limit of {limit:6}",
            (values.low, Angle), (-limits.return_, Angle),
            "raise the base radius, offset the follower, or give the return a larger angle",
        ),
        "face width": (
            "the flat face is too short: the cam touches {value:6} of it, and its length is {limit:6}",
            (values.face, Size), (limits.face, Size),
            "take a longer face or a slower motion",
        ),
        "velocity jump": (
            "the velocity jumps at {value}: the force there is infinite",
            joints, "",
            "choose laws whose velocities join",
        ),
        "jump speed": (
            "the follower leaves the cam at {value:6}, below the required {limit:6}",
            (values.jump_speed, ShaftSpeed), (limits.speed, ShaftSpeed),
            "take a stiffer spring, a larger preload or a lighter follower",
        ),
        "least radius of curvature": (
            "the minimum radius of curvature, {value:6}, is below the limit of {limit:6}",
            (values.radius, Coordinate), (limits.radius, Size),
            "raise the base radius; `dynamics cam size` finds the smallest one",
        ),
    }  # fmt: skip
    advice = []
    for name, (template, value, limit, remedy) in messages.items():
        if name in exceeded:
            code = "curvature" if name == "least radius of curvature" else name.replace(" ", "-")
            advice.append(Advice(code, worded(template, value=value, limit=limit), "serious", remedy))
    return advice


def _on_jump(jump: "Any") -> tuple[Advice, ...]:
    if jump is None or jump[0] is not None:
        return ()
    return (Advice("no-jump", "the follower never slows down: it cannot leave the cam", "note", result="jump_speed"),)
