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
    from typing import Any

    from dynamics_cli.cam.geometry.contact import Geometry

CCW = Rotation("counter-clockwise")
INNER = Flank("inner")
DEGREE = pi / 180.0


@record
class CamCheck:
    """Verdicts, each with its decisive number and where it occurs."""

    fits: Annotated[bool, "Whether all limits are kept."]
    binding: Annotated[Text, "The limits that are not kept."]
    undercut: Annotated[bool, "Whether the curve of the cam cuts itself or has a cusp."]
    undercut_stretches: Annotated[
        Count, "How many stretches of the envelope run backwards; zero where flanks far apart cut each other."
    ]
    pieces_cut_off: Annotated[Count | None, "Pieces that an undercut cuts off the cam."]
    lift_lost: Annotated[
        Coordinate | None,
        "Maximum lift that an undercut costs a sliding follower; on an outer flank, how far it can overshoot [m].",
    ]
    swing_lost: Annotated[
        Angle | None, "Maximum swing that an undercut costs an arm; on an outer flank, how far it can overshoot [rad]."
    ]
    lost_at: Annotated[Angle | None, "Cam angle where most is lost [rad]."]
    least_convex_radius: Annotated[
        Coordinate | None, "Minimum radius of curvature of the cam where the pitch curve is convex [m]."
    ]
    least_convex_radius_at: Annotated[Angle | None, "Cam angle there [rad]."]
    least_concave_radius: Annotated[
        Coordinate | None, "Minimum radius of curvature of the cam where it is concave [m]."
    ]
    least_concave_radius_at: Annotated[Angle | None, "Cam angle there [rad]."]
    curvature_kept: Annotated[bool | None, "Whether the given minimum radius is kept."]
    largest_pressure_angle: Annotated[Angle, "Maximum pressure angle, compared with the limit of the rise [rad]."]
    largest_pressure_angle_at: Annotated[Angle, "Cam angle there [rad]."]
    least_pressure_angle: Annotated[Angle, "Minimum pressure angle, compared with the limit of the return [rad]."]
    least_pressure_angle_at: Annotated[Angle, "Cam angle there [rad]."]
    pressure_angle_kept: Annotated[bool, "Whether both limits of pressure angle are kept."]
    face_width: Annotated[Size | None, "Length of the flat face that the cam touches [m]."]
    face_kept: Annotated[bool | None, "Whether the given flat face is long enough."]
    velocity_jumps: Annotated[Count, "Joints where the follower's velocity jumps: an infinite force."]
    acceleration_jumps: Annotated[Count, "Joints where its acceleration jumps."]
    jump_speed: Annotated[ShaftSpeed | None, "Speed of the cam at which the follower leaves it [rad/s]."]
    jump_at: Annotated[Angle | None, "Cam angle where it leaves [rad]."]
    jump_kept: Annotated[bool | None, "Whether the follower stays on the cam at the speed given."]
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def check(
    scene: Annotated[Program, "One turn of the cam in segments, from a file."],
    /,
    *,
    program: Annotated[Text, "Segments in one line, in place of a file."] = "",
    follower: Annotated[Follower, "The follower and where it stands."],
    rotation: Annotated[Rotation, "Which way the cam turns."] = CCW,
    flank: Annotated[Flank, "The inner surface, that of a disc cam, or the outer flank of a closed track."] = INNER,
    rise_limit: Annotated[Angle, "Largest positive pressure angle allowed [rad]."] = 30.0 * DEGREE,
    return_limit: Annotated[Angle, "Largest negative pressure angle allowed [rad]."] = 30.0 * DEGREE,
    least_radius: Annotated[Size, "Minimum radius of curvature allowed, convex or concave [m]."] = 0.0,
    face_width: Annotated[Size | None, "Length of the flat face, e.g. 25 mm [m]."] = None,
    mass: Annotated[Mass | None, "Mass that a sliding follower moves, for the jump, e.g. 0.2 kg [kg]."] = None,
    spring_rate: Annotated[Stiffness | None, "Stiffness of its spring, e.g. 20 N/mm [N/m]."] = None,
    preload: Annotated[Force | None, "Force of the spring at zero lift, e.g. 100 N [N]."] = None,
    inertia: Annotated[
        Inertia | None, "Moment of inertia of an arm about its pivot, for the jump, e.g. 0.002 kg*m^2 [kg*m^2]."
    ] = None,
    torsion_rate: Annotated[
        TorsionStiffness | None, "Rate of an arm's spring about the pivot, e.g. 10 N*m/rad [N*m/rad]."
    ] = None,
    preload_torque: Annotated[Torque | None, "Torque of that spring at zero swing, e.g. 2 N*m [N*m]."] = None,
    shaft_speed: Annotated[ShaftSpeed | None, "Speed of the cam to be checked, e.g. 1500 rpm [rad/s]."] = None,
    safety: Annotated[Positive, "Factor by which the jump speed is to exceed the speed."] = 1.0,
) -> CamCheck:
    """Certified verdicts about a cam: undercut and lost lift, pressure angle, curvature, face width, jump.

    Equation
    --------
    Undercut where ds/dθ = w(1 − R_r κ_p) ≤ 0 (flat: R_b + s + s″ ≤ 0), or the curve crosses itself; lift lost: program
    less the lift of the follower resting on the remaining corner; jump: ω² = min k(s + δ)/(−m s″) over s″ < 0,
    for an arm with its inertia and torques.

    Returns
    -------
    CamCheck
        Verdicts with their decisive numbers and places.

    Raises
    ------
    InadmissibleError
        When the cam is impossible, or the jump lacks mass, stiffness or preload (of an arm:
        inertia, torsion rate or preload torque).

    Notes
    -----
    Verdicts do not depend on sampling: extremes come from Chebyshev proxies of every piece of every law, their errors
    proved on discs of the complex plane, with bounds on derivatives that exclude any missed extremum. A cusp counts as
    undercut; if rounding cannot decide whether there is one, an advice says so. Corners of an undercut cam are
    crossings of its envelope, found by halving and Newton's method however small the undercut and even where several
    merge; the edge is followed from corner to corner, so that a lobe cut off at its neck is recognised. The lift lost
    is the largest gap on them, by Chebyshev proxies whose remainder is estimated, to 3e-15 of the cam's size (1e-12
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
    from dynamics_cli.cam.geometry.analysis import analyse, pressure_bounds, runs_forward
    from dynamics_cli.cam.geometry.contact import Geometry
    from dynamics_cli.cam.geometry.profile import concave, convex, radius_bounds
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
    (high, high_at), (low, low_at) = analysis.pressure.largest(), analysis.pressure.smallest()
    round_, round_at = convex(geometry, analysis)
    hollow, hollow_at = concave(geometry, analysis)
    forward = runs_forward(geometry, analysis)
    loss = lift_lost(geometry, motion, forward=forward)
    lost = None if loss is None or isinf(loss.lift) else loss.lift
    face = None if analysis.along is None else analysis.along.largest()[0] - analysis.along.smallest()[0]
    jumps = joint_jumps(motion)
    slide, arm = (mass, spring_rate, preload), (inertia, torsion_rate, preload_torque)
    jump = asked_jump(motion, slide, arm, asked=shaft_speed is not None)
    limits = (rise_limit, return_limit, least_radius, face_width)
    passed = _kept(loss is None, (high, low), (round_, hollow), face, limits)
    passed["velocity jump"] = jumps[0] == 0
    passed["jump speed"] = (
        jump is None or shaft_speed is None or jump[0] is None or jump[0] >= safety * abs(shaft_speed)
    )
    wrong = [name for name, good in passed.items() if not good]
    return CamCheck(
        fits=not wrong,
        binding=", ".join(wrong) if wrong else "nothing",
        undercut=loss is not None,
        undercut_stretches=0 if loss is None else len(loss.stretches),
        pieces_cut_off=None if loss is None else loss.pieces,
        lift_lost=None if geometry.oscillating else lost,
        swing_lost=lost if geometry.oscillating else None,
        lost_at=None if loss is None or lost is None else loss.at,
        least_convex_radius=round_,
        least_convex_radius_at=round_at,
        least_concave_radius=hollow,
        least_concave_radius_at=hollow_at,
        curvature_kept=passed["least radius of curvature"],
        largest_pressure_angle=high,
        largest_pressure_angle_at=high_at,
        least_pressure_angle=low,
        least_pressure_angle_at=low_at,
        pressure_angle_kept=passed["rise limit"] and passed["return limit"],
        face_width=face,
        face_kept=None if face_width is None else passed["face width"],
        velocity_jumps=jumps[0],
        acceleration_jumps=jumps[1],
        jump_speed=None if jump is None else jump[0],
        jump_at=None if jump is None else jump[1],
        jump_kept=None if jump is None or shaft_speed is None else passed["jump speed"],
        advice=(*_advice(geometry, wrong, loss, (round_, hollow), least_radius, jump), *_cusp(loss, forward)),
        numerics=Numerics(
            "Chebyshev proxies of every piece, every extreme certified",
            (
                *pressure_bounds(analysis),
                *radius_bounds(geometry, analysis),
                *_lost_bound(geometry, loss),
                *_jump_bound(jump),
            ),
        ),
    )


def _kept(
    regular: bool, pressure: tuple[float, float], radii: "tuple[float | None, float | None]", face: float | None,
    limits: "tuple[float, float, float, float | None]",
) -> "dict[str, bool]":  # fmt: skip
    """Which limits a cam keeps, within rounding."""
    high, low = pressure
    rise_limit, return_limit, least_radius, face_width = limits
    tightest = min((radius for radius in radii if radius is not None), default=None)
    return {
        "undercut": regular,
        "rise limit": high <= rise_limit * (1.0 + 1e-12),
        "return limit": -low <= return_limit * (1.0 + 1e-12),
        "least radius of curvature": tightest is None or tightest >= least_radius * (1.0 - 1e-12),
        "face width": face_width is None or face is None or face <= face_width,
    }


def _lost_bound(geometry: "Geometry", loss: "Any") -> tuple[ErrorBound, ...]:
    if loss is None or isinf(loss.lift):
        return ()
    return (ErrorBound("swing_lost" if geometry.oscillating else "lift_lost", loss.error, relative=False),)


def _jump_bound(jump: "tuple[float | None, float | None, float] | None") -> tuple[ErrorBound, ...]:
    if jump is None or not jump[0]:
        return ()
    return (ErrorBound("jump_speed", jump[2] / jump[0]),)


def _cusp(loss: "Any", forward: bool) -> tuple[Advice, ...]:
    """Advice on a curve that is not undercut as computed, but may be within its error."""
    if loss is not None or forward:
        return ()
    message = "the cam has a cusp, to the accuracy of the calculation"
    return (Advice("cusp", message, "caution", "raise the base radius a little"),)


def _undercut(geometry: "Geometry", loss: "Any") -> Advice:
    """Advice on the lift lost to an undercut."""
    arm = geometry.oscillating
    remedy = "raise the base radius, take a smaller roller, or give the motion a larger angle"
    if isinf(loss.lift):
        message = "the cam is undercut: no surface remains to support the follower"
        return Advice("undercut", message, "serious", remedy, "swing_lost" if arm else "lift_lost")
    template = "the cam is undercut: it loses {amount:6} of {what}"
    if geometry.side < 0.0:
        template = "the outer flank is undercut: the follower can overshoot by {amount:6} of {what}"
    if loss.pieces:
        template += ", and a piece of the cam is cut off"
    amount = (loss.lift, Angle if arm else Coordinate)
    return Advice("undercut", worded(template, amount=amount, what="swing" if arm else "lift"), "serious", remedy)


def _advice(
    geometry: "Geometry", wrong: list[str], loss: "Any", radii: "tuple[float | None, float | None]",
    least_radius: float, jump: "Any",
) -> tuple[Advice, ...]:  # fmt: skip
    advice = [] if loss is None else [_undercut(geometry, loss)]
    messages = {
        "rise limit": "raise the base radius, offset the follower, or give the rise a larger angle",
        "return limit": "raise the base radius, offset the follower, or give the return a larger angle",
        "face width": "a longer face, or a slower motion",
        "velocity jump": "choose laws whose velocities join",
        "jump speed": "a stiffer spring, a larger preload or a lighter follower",
    }
    advice += [
        Advice(name.replace(" ", "-"), f"the {name} is not kept", "serious", messages[name])
        for name in wrong
        if name in messages
    ]
    if "least radius of curvature" in wrong:
        tightest = min(radius for radius in radii if radius is not None)
        advice.append(
            Advice(
                "curvature",
                worded(
                    "the minimum radius of curvature, {radius:6}, is below the limit of {limit:6}",
                    radius=(tightest, Coordinate), limit=(least_radius, Size),
                ),
                "serious",
                "raise the base radius; `dynamics cam size` finds the smallest one",
            )
        )  # fmt: skip
    if jump is not None and jump[0] is None:
        message = "the follower never slows down: it cannot leave the cam"
        advice.append(Advice("no-jump", message, "note", result="jump_speed"))
    return tuple(advice)
