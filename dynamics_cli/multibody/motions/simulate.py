"""The task `simulate`: how a scene of bodies in space moves over time."""

from functools import lru_cache

from dynamics_cli.errors import require, worded
from dynamics_cli.multibody.bodies.records import Scene, Upward
from dynamics_cli.multibody.bodies.results import effort, rate
from dynamics_cli.multibody.bodies.system import System
from dynamics_cli.multibody.motions.runs import SAMPLES, Run, parted
from dynamics_cli.numerics.trees.newton_euler import sweep
from dynamics_cli.numerics.trees.tree import BALL, FIXED, PRISMATIC
from dynamics_cli.numerics.vectors import add, cross, length, times
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    AngularVelocity,
    Annotated,
    Count,
    Distance,
    Fraction,
    FreeNumber,
    Gravity,
    Length,
    PotentialEnergy,
    Ratio,
    SpacePosition,
    SpaceVelocity,
    Text,
    Time,
)
from dynamics_cli.records import Advice, Check, Numerics, Quantity, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dynamics_cli.multibody.bodies.loops import Loops
    from dynamics_cli.numerics.vectors import Vector

# Where two runs are apart by this, nothing is known any more [rad, or sizes of the scene].
LOST = 0.01
MANY = 20_000


@record
class DriveRow:
    """What the motion of a driven joint needs."""

    name: Annotated[Text, "The joint's body."]
    largest: Annotated[FreeNumber, "The largest effort of its motor, of either sign."]
    time: Annotated[Time, "When it is needed [s]."]
    end: Annotated[FreeNumber, "The effort at the end."]


@record
class StateRow:
    """A speed and its coordinate at the end."""

    name: Annotated[Text, "The speed: the body's name, of several with its axis."]
    coordinate: Annotated[FreeNumber | None, "Its coordinate; null where it is no rate of one, in ball joints."]
    speed: Annotated[FreeNumber, "Its value."]


@record
class MotionRow:
    """The body that is followed, at a time."""

    time: Annotated[Time, "The time [s]."]
    centre: Annotated[SpacePosition, "Its mass centre, in the ground's frame [m]."]
    velocity: Annotated[SpaceVelocity, "Velocity of the mass centre [m/s]."]
    angular_velocity: Annotated[AngularVelocity, "Its angular velocity, in ground axes [rad/s]."]
    coordinates: Annotated[tuple[Ratio, ...], "Coordinates of all joints in rad, m and Euler parameters."]


@record
class Motion:
    """How a scene moves."""

    verdict: Annotated[Text, "Whether the answer holds to the end."]
    horizon: Annotated[Time | None, "From here on nothing is known: two tolerances are apart by 1 % [s]."]
    difference: Annotated[Angle, "How far two tolerances are apart at most, before that [rad, or of the size]."]
    energy_error: Annotated[Fraction, "Largest change of energy less work, over the largest energy exchanged [-]."]
    kinetic_energy: Annotated[PotentialEnergy, "Kinetic energy at the end [J]."]
    work: Annotated[PotentialEnergy | None, "Work of motors, loads and dampers up to the end, where there are any [J]."]
    drives: Annotated[tuple[DriveRow, ...] | None, "What driven joints need; null where none is driven."]
    gap: Annotated[Distance | None, "Largest gap of a loop before it was put right [m]."]
    states: Annotated[tuple[StateRow, ...], "Coordinates and speeds at the end."]
    motion: Annotated[tuple[MotionRow, ...], "The body that is followed."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def simulate(
    scene: Annotated[Scene, "The bodies, from a file."],
    /,
    *,
    duration: Annotated[Time, "How long it moves, e.g. 2 s."],
    steps: Annotated[Count, "Rows of the motion beside the start, e.g. 20."] = 4,
    follow: Annotated[Text | None, "The body to follow; the last one otherwise, e.g. boom."] = None,
    tolerance: Annotated[Ratio, "Relative and absolute tolerance of each step [-]."] = 1e-10,
    up: Annotated[Upward, "The axis that points up: x, y, z, or none without gravity."] = Upward("z"),  # noqa: B008
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Motion:
    """Motion of bodies in space under weight, loads, springs and motors, with its energy balance and its horizon.

    Equation
    --------
    ẏ by articulated bodies, with loops by the ways left free; q̇ = y, of ball joints ė = ½·e·(0, ω).

    Returns
    -------
    Motion
        The state at the end, a body over time, and how far two tolerances are apart.

    Raises
    ------
    InadmissibleError
        When a joint meets no inertia, loops do not close, or a tolerance is out of reach.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.7 and 18.17.
    """
    require(duration > 0.0, "the duration of {duration} is not above zero", duration=(duration, Time))
    require(1e-13 <= tolerance <= 1e-2, "the tolerance {tolerance} is out of reach", tolerance=(tolerance, Ratio),
            code="tolerance", hint="1e-13 to 1e-2")  # fmt: skip
    require(1 <= steps <= MANY, "{steps} steps are out of reach", steps=steps, code="steps", hint="1 to 20000")
    fine, coarse, loops = runs_of(scene, duration, steps, tolerance, up, gravity)
    system = fine.system
    apart = parted(fine, coarse, scales_of(system, loops))
    lost = next((k for k, off in enumerate(apart) if off > LOST), None)
    every = (len(fine.times) - 1) // steps
    k = system.body_link(follow) if follow is not None else len(system.tree.links) - 1
    rows = []
    for n in range(0, len(fine.times), every):
        if lost is not None and n >= lost:
            break
        rows.append(_row(fine, k, n))
    fine.put(fine.states[-1 if lost is None else lost - 1])
    error = fine.energy_error()
    known = max(apart[:lost], default=0.0)
    return Motion(
        verdict="holds to the end" if lost is None else "lost before the end: shorten it, or give a smaller tolerance",
        horizon=None if lost is None else fine.times[lost],
        difference=known,
        energy_error=error,
        kinetic_energy=fine.kinetics[-1 if lost is None else lost - 1],
        work=fine.clean(fine.states[-1 if lost is None else lost - 1][-1], -1) if fine.worked() else None,
        drives=tuple(drive_rows(fine, len(fine.times) if lost is None else lost)) if scene.drives else None,
        gap=fine.gap * loops.size if loops is not None else None,
        states=tuple(_states(fine)),
        motion=tuple(_cleaned(rows, fine.tolerance)),
        numerics=Numerics("DOP853, two tolerances"),
        checks=(
            Check("energy and work balance", error <= max(1e5 * tolerance, 1e-9), error, max(1e5 * tolerance, 1e-9)),
        ),
        advice=(
            *(one for one in system.advice if one.code != "drives"),
            *_passed(fine, len(fine.times) if lost is None else lost),
        ),
    )


def _passed(run: Run, known: int) -> "Iterator[Advice]":
    """A word on every joint that passes a stop without stiffness, with the time."""
    for name, turning, spring in zip(run.system.names, run.system.turning, run.system.springs, strict=True):
        if spring.place is None or spring.stop or spring.beyond(run.states[0][spring.place]):
            continue
        passed = next((n for n in range(known) if spring.beyond(run.states[n][spring.place])), None)
        if passed is not None:
            stop = spring.upper if spring.beyond(run.states[passed][spring.place]) > 0.0 else spring.lower
            message = worded("{name} passes its stop at {stop} by {time:3}: nothing holds it there", name=name,
                             stop=(stop, Angle if turning else Length), time=(run.times[passed], Time))  # fmt: skip
            remedy = "stop_torsion_stiffness" if turning else "stop_stiffness"
            yield Advice("stop", message, remedy=f"give {remedy}, or end the motion before")


# a picture after the answer needs the same motion
@lru_cache(maxsize=1)
def runs_of(
    scene: Scene, duration: float, steps: int, tolerance: float, up: Upward, gravity: float
) -> "tuple[Run, Run, Loops | None]":
    """The motion at a tenth of the tolerance and at the tolerance, at times of which each so many are the rows."""
    within = -(-SAMPLES // steps)
    times = [duration * k / (steps * within) for k in range(steps * within + 1)]
    pair = []
    for one in (0.1 * tolerance, tolerance):
        system = System(scene, up, gravity)
        drives, loops = None, None
        if scene.drives:
            from dynamics_cli.multibody.motions.drives import Drives

            drives = Drives(system)
        if scene.loops:
            from dynamics_cli.multibody.bodies.loops import Loops

            loops = Loops(system)
            loops.close()
            loops.settle()
            loops.require_regular()
        system.begin()
        pair.append((Run(system, loops, drives, times, max(one, 3e-14)), loops))
    (fine, loops), (coarse, _) = pair
    return fine, coarse, loops


def drive_rows(run: Run, known: int) -> "Iterator[DriveRow]":
    """Efforts of driven joints at the times kept; within loops those that the free ways of the loops need."""
    if run.drives is None:
        return
    import numpy as np

    places, system = list(run.drives.laws), run.system
    needs = []
    for time, state in zip(run.times[:known], run.states, strict=False):
        run.put(state)
        missing = np.array(run.missing(run.accelerations(time, system.coordinates, system.speeds)))
        if run.loops is not None:
            scales = run.loops.column_scales
            free = run.loops.parts()[3].T
            missing[places] = np.linalg.lstsq(free[:, places], free @ (missing * scales))[0] / scales[places]
        needs.append(missing[places].tolist())
    for n, place in enumerate(places):
        k = max(range(len(needs)), key=lambda i, n=n: abs(needs[i][n]))  # type: ignore[misc]
        turns = system.turning[place]
        largest, end = effort(turns, needs[k][n]), effort(turns, needs[-1][n])
        yield DriveRow(system.names[place], largest, run.times[k], end)


def scales_of(system: System, loops: "Loops | None") -> "list[float]":
    """What differences of coordinates are counted in: rad, or the size of the scene."""
    reach = max((length(link.position) + length(link.centroid) for link in system.tree.links), default=0.0)
    size = loops.size if loops is not None else reach or 1.0
    scales: list[float] = []
    for link in system.tree.links:
        scales += {FIXED: [], BALL: [1.0] * 4, PRISMATIC: [size]}.get(link.joint, [1.0])
    return scales


def _row(run: Run, k: int, n: int) -> MotionRow:
    run.put(run.states[n])
    system = run.system
    omega, _, velocity, _ = sweep(system.tree, system.frames, system.speeds)[k]
    turn, link = system.ground[k][0], system.tree.links[k]
    moving = times(turn, add(velocity, cross(omega, link.centroid)))
    return MotionRow(run.times[n], system.centre(k), moving, times(turn, omega), tuple(system.coordinates))


def _cleaned(rows: "list[MotionRow]", share: float) -> "Iterator[MotionRow]":
    """The rows with components as zeros that are below this share of the largest."""

    def clean(vectors: "list[Vector]") -> "list[Vector]":
        least = share * max((abs(x) for v in vectors for x in v), default=0.0)
        return [tuple(x if abs(x) > least else 0.0 for x in v) for v in vectors]  # type: ignore[misc]

    columns = (clean([getattr(row, name) for row in rows]) for name in ("centre", "velocity", "angular_velocity"))
    for row, centre, velocity, omega in zip(rows, *columns, strict=True):
        yield MotionRow(row.time, centre, velocity, omega, row.coordinates)


def _states(run: Run) -> "Sequence[StateRow]":
    """Where the system stands."""
    system, split = run.system, run.split
    rows = []
    columns = zip(system.names, system.turning, system.springs, system.speeds, strict=True)
    for n, (name, turns, spring, speed) in enumerate(columns):
        place = spring.place
        kind = Angle if turns else Length
        value = None if place is None else Quantity(run.clean(system.coordinates[place], place), kind)
        rows.append(StateRow(name, value, rate(turns, run.clean(speed, split + n))))
    return rows
