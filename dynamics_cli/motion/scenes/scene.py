"""The task `scene`: how a planar system of bodies moves."""

from dynamics_cli.errors import require, worded
from dynamics_cli.motion.bodies.records import Link, Scene
from dynamics_cli.motion.scenes.states import (
    JointForce,
    LinkState,
    Moment,
    PointState,
    SpringState,
    followed,
    forces_of,
    joint_rows,
    links_of,
    moment_of,
    peaks_of,
    points_of,
    springs_of,
)
from dynamics_cli.numerics.linkages.records import GROUND
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Coordinate,
    Count,
    Force,
    Fraction,
    Gravity,
    PotentialEnergy,
    Size,
    Text,
    Time,
    TurnRate,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.system import System
    from dynamics_cli.motion.scenes.runs import Runs

    Peaks = list[tuple[float, float, float]]

MANY = 20_000
# Joints between steps, in sizes of the scene.
TOGETHER = 1e-7
STILL = 1e-12
# What a sample does not ask.
UNSAMPLED = ("verdict", "ends", "horizon", "tenfold", "difference", "energy_error", "start_moved", "drift", "time",
             "links", "points", "reactions", "springs", "motion", "numerics")  # fmt: skip


@record
class SceneMotion:
    """How a scene moves, and how long that can be known."""

    verdict: Annotated[Text, "Whether the answer holds to the end of the time asked for."]
    ends: Annotated[Time | None, "Where it ends before that [s]."]
    horizon: Annotated[Time | None, "Beyond it the answer means nothing; null where errors hardly grow [s]."]
    tenfold: Annotated[Time | None, "Time in which an error of the start grows tenfold, about [s]."]
    difference: Annotated[Size, "Largest difference of two runs at different tolerances, of any mass centre [m]."]
    energy_error: Annotated[Fraction, "Largest change of energy less work, over the largest energy exchanged [-]."]
    driver_work: Annotated[PotentialEnergy | None, "Work of the drivers up to the end [J]."]
    load_work: Annotated[PotentialEnergy | None, "Work of the loads up to the end [J]."]
    damper_loss: Annotated[PotentialEnergy | None, "Energy lost in dampers up to the end [J]."]
    largest_force: Annotated[Force | None, "Largest force in any joint [N]."]
    largest_in: Annotated[Text | None, "The joint that bears it."]
    start_moved: Annotated[Size, "How far the start as given was moved so that it closes [m]."]
    drift: Annotated[Size, "Largest gap of a joint after a step, before it was put right [m]."]
    time: Annotated[Time | None, "When links, points and forces are as told [s]."]
    angle: Annotated[Angle | None, "Angle of the link that is followed, then [rad]."]
    speed: Annotated[TurnRate | None, "Its angular velocity then [rad/s]."]
    x: Annotated[Coordinate | None, "Of its mass centre, or of the point that is followed, then [m]."]
    y: Annotated[Coordinate | None, "The same, upwards [m]."]
    links: Annotated[tuple[LinkState, ...] | None, "The links then; null past the horizon, or if one is followed."]
    points: Annotated[tuple[PointState, ...] | None, "The points then."]
    reactions: Annotated[tuple[JointForce, ...] | None, "Forces in the joints and of drivers then."]
    springs: Annotated[tuple[SpringState, ...] | None, "Springs and dampers between points then."]
    motion: Annotated[tuple[Moment, ...] | None, "What is followed, over time."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def scene(
    scene: Annotated[Scene, "The bodies, from a file."],
    /,
    *,
    duration: Annotated[Time, "How long, e.g. 2 s."],
    at: Annotated[Time | None, "Show links and joint forces at this time, e.g. 0.5 s."] = None,
    follow: Annotated[Text, "A link, point or joint to follow over time, e.g. crank."] = "",
    steps: Annotated[Count, "Lines of that table after the start."] = 24,
    gravity: Annotated[Gravity, "Acceleration of gravity, along −y [m/s^2]."] = STANDARD_GRAVITY,
) -> SceneMotion:
    """Motion of planar bodies with pins, slides, welds, springs, dampers, drivers and loads; forces in the joints.

    Equation
    --------
    M·a + Jᵀ·λ = Q, J·a = γ with the mass centres and angles as coordinates; after each step the state is put back onto
    the joints. Energy + loss − work of drivers and loads stays.

    Returns
    -------
    SceneMotion
        Links, points and joint forces at the end or at a time, what is followed over time, work, energy balance,
        difference of two tolerances and horizon.

    Raises
    ------
    InadmissibleError
        When names do not fit, the scene cannot be put together (the gap), nothing can move or does, something moves
        without mass, drivers contradict joints, the start is a change point, or the time is too long.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 8.10, 11.4 and 12.2; Hairer & Wanner,
    Solving Ordinary Differential Equations II, Springer 1996, sections VII.1 and VII.2 (index 1, projection), IV.8
    (Radau).
    """
    from dynamics_cli.motion.scenes.runs import KEPT, runs_of

    require(duration > 0.0, "a time of {duration} is not above zero", duration=(duration, Time))
    require(1 <= steps <= MANY, "steps: {count}; a table has 1 to {most}", count=steps, most=MANY, code="steps")
    require(at is None or at <= duration, "{at} is after the end at {duration}", at=(at or 0.0, Time),
            duration=(duration, Time), code="time", hint="give a longer --duration")  # fmt: skip
    runs = runs_of(scene, gravity, duration)
    _require_motion(runs)
    require(at is None or at <= runs.end, "at {at} the motion is not known: it ends at {end}", at=(at or 0.0, Time),
            end=(runs.end, Time), code="past-horizon", hint="ask for {end} or less")  # fmt: skip
    system = runs.system
    last = None if runs.reached and at is None else runs.end if at is None else at
    then = None if last is None else runs.fine.at(last)
    state = None if follow else then
    # next to a change point forces grow without limit
    peaks = None if runs.stuck or runs.crossed else peaks_of(runs)
    there = moment_of(system, last or 0.0, then, follow) if follow else None
    work = runs.fine.at(runs.end)[-3:]
    if drawing():
        return sampled(system, work, peaks, there)
    numbers = _numbers(system, work, peaks, there)
    kept, tenfold = runs.energy_error(), runs.tenfold()
    return SceneMotion(
        verdict=_verdict(runs, tenfold),
        ends=runs.end if runs.end < duration else None,
        horizon=runs.horizon(),
        tenfold=tenfold,
        difference=runs.difference * system.size,
        energy_error=kept,
        **numbers,
        start_moved=runs.start.moved,
        drift=runs.fine.drift * system.size,
        time=last,
        links=None if state is None else links_of(system, state),
        points=None if state is None else points_of(system, state),
        reactions=None if state is None else joint_rows(system, forces_of(system, last or 0.0, state), peaks),
        springs=None if state is None else springs_of(system, state),
        motion=followed(runs, follow, steps) if follow else None,
        numerics=Numerics(
            "Radau, two tolerances (stiff)" if runs.stiff else "DOP853, two tolerances",
            bounds=(ErrorBound("links", runs.difference * system.size, relative=False),) if state is not None else (),
        ),
        checks=_checks(runs, kept) if kept < KEPT else (),
        advice=(*runs.start.advice, *_advice(runs, kept)),
    )


def sampled(system: "System", work: "Any", peaks: "Peaks | None", there: "Moment | None") -> SceneMotion:
    """What is asked of a sample."""
    unsampled: dict[str, Any] = dict.fromkeys(UNSAMPLED)
    return SceneMotion(**_numbers(system, work, peaks, there), **unsampled)


def _numbers(system: "System", work: "Any", peaks: "Peaks | None", there: "Moment | None") -> "dict[str, Any]":
    """Works, the largest force, and how what is followed moves then."""
    largest = max(((peak[0], joint) for peak, joint in zip(peaks or (), system.joints, strict=False)
                   if not system.left & set(joint.rows())), key=lambda pair: pair[0], default=(0.0, None))  # fmt: skip
    energy = system.mass * system.size**2
    work = [float(x) * energy for x in work]
    return {
        "driver_work": work[0] if system.driven else None,
        "load_work": work[1] if system.scene.loads else None,
        "damper_loss": work[2] if work[2] else None,
        "largest_force": largest[0] if largest[1] else None,
        "largest_in": f"{largest[1].name} on {largest[1].link}" if largest[1] else None,
        "angle": there and there.angle,
        "speed": there and there.speed,
        "x": there and there.position and there.position[0],
        "y": there and there.position and there.position[1],
    }


def _require_motion(runs: "Runs") -> None:
    """Refuse scenes that stay as they are."""
    system, state = runs.system, runs.start.state
    start = slice(system.end, 2 * system.end)
    rates = [abs(system.rate(share * runs.duration, state)[start]).max() for share in (0.0, 0.37, 0.71, 1.0)]
    driven = any(part.motion.law(share * runs.duration)[1] for part in system.driven for share in (0.0, 0.37, 0.71))
    size = max(system.gravity, 1e-3)
    require(abs(state[start]).max() > 0.0 or driven or max(rates) > STILL * size,
            "it is at rest in equilibrium: nothing moves", code="at-rest",
            hint="turn a link, give a speed, or ask `motion equilibrium`")  # fmt: skip


def _checks(runs: "Runs", kept: float) -> "tuple[Check, ...]":
    from dynamics_cli.motion.scenes.runs import KEPT

    system, worst = runs.system, 0.0
    for k in range(41):
        t = runs.end * k / 40.0
        gaps = system.gaps(t, system.frame_of(runs.fine.at(t)))
        worst = max(worst, float(abs(gaps).max())) if len(gaps) else worst
    return (
        Check("energy and work balance", kept < KEPT, kept, KEPT),
        Check("joints stay together", worst < TOGETHER, worst, TOGETHER),
    )


def _verdict(runs: "Runs", tenfold: "float | None") -> str:
    if runs.stuck:
        return "ends at a pose where the joints do not determine the motion"
    if runs.reached:
        return "ends at the horizon"
    return "holds to the end; no horizon in sight yet" if tenfold is None else "holds to the end"


def _loose(scene: Scene) -> "list[Link]":
    """Links that nothing holds, though the scene does not say where they are."""
    names = [pin.name for link in scene.links for pin in link.points]
    held = {name for name in names if names.count(name) > 1} | {slide.point for slide in scene.slides}
    held |= {end for spring in scene.springs for end in (spring.from_, spring.to)}
    joined = {GROUND, *(name for weld in scene.welds for name in (weld.link, weld.to))}
    joined |= {driver.link for driver in scene.drivers} | {slide.slider for slide in scene.slides}
    return [
        link for link in scene.links
        if link.name not in joined and link.position is None and link.velocity is None
        and not held & {pin.name for pin in link.points}
    ]  # fmt: skip


def _advice(runs: "Runs", kept: float) -> "tuple[Advice, ...]":
    from dynamics_cli.motion.scenes.runs import APART, KEPT

    out = []
    if runs.reached:
        words = worded("after {end} two runs at different tolerances part by {apart}: what follows is one motion of "
                       "many", end=(runs.end, Time), apart=(APART * runs.system.size, Size))  # fmt: skip
        remedy = worded("ask for {end} or less", end=(runs.end, Time))
        out.append(Advice("past-horizon", words, "serious", result="links", remedy=remedy))
    if runs.stuck:
        words = worded("at {end:8} the scene comes to a dead centre or change point: from there its joints and drivers "
                       "leave the motion open, or cannot go on", end=(runs.end, Time))  # fmt: skip
        out.append(Advice("singular", words, "serious", remedy="leave a driver out there, or change a length a little"))
    for t in runs.crossed[:1]:
        words = worded("at {t:6} the scene passes a change point, from which it can go on in two ways: the smooth one "
                       "is shown", t=(t, Time))  # fmt: skip
        out.append(Advice("change-point", words, remedy="what decides there is play and friction"))
    out += [
        Advice("not-joined", f"nothing joins {link.name} to another link, and no spring holds it: it moves freely",
               remedy="points of one name are one pin: compare the names; or give its position")
        for link in _loose(runs.system.scene)
    ]  # fmt: skip
    if runs.system.n > 1 and runs.start.ambiguous:
        names = ", ".join(runs.start.ambiguous)
        text = f"the scene does not say at which angle {names} begins: it may fit otherwise"
        out.append(Advice("which-assembly", text, "note", remedy="give its angle, roughly"))
    if kept >= KEPT:
        words = worded("energy and work balance to {kept:2} only", kept=(kept, Fraction))
        out.append(Advice("balance", words, "serious", remedy="ask for a shorter time"))
    return tuple(out)
