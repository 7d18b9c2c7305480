"""The task `rectilinear`: phases of constant acceleration, or a law of the acceleration, with a table over time."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import only_in_doubles, summed
from dynamics_cli.numerics.expressions.laws import law_of
from dynamics_cli.numerics.number import plain
from dynamics_cli.path.straight.laws import Run, estimate, run
from dynamics_cli.path.straight.phases import Phase, Solution, solutions
from dynamics_cli.quantities import (
    Acceleration,
    AccelerationFormula,
    Annotated,
    Count,
    Length,
    Speed,
    Time,
    Variable,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_STEPS = 10000
TOLERANCE = 1e-9


@record
class Moment:
    """One row of the motion."""

    phase: Annotated[int, "Number of its phase."]
    time: Annotated[Time, "Time since the start [s]."]
    distance: Annotated[Length, "Displacement since the start [m]."]
    speed: Annotated[Speed, "Velocity [m/s]."]
    acceleration: Annotated[Acceleration, "Acceleration [m/s^2]."]


@record
class Straight:
    """A straight motion from start to end."""

    start_speed: Annotated[Speed, "Velocity at the start [m/s]."]
    end_speed: Annotated[Speed, "Velocity at the end [m/s]."]
    acceleration: Annotated[Acceleration | None, "Acceleration; of one phase where it is constant [m/s^2]."]
    distance: Annotated[Length, "Displacement from start to end [m]."]
    time: Annotated[Time, "Duration [s]."]
    mean_speed: Annotated[Speed | None, "Displacement over duration [m/s]."]
    stop_time: Annotated[Time | None, "When it first comes to rest, of one phase that goes on or a law [s]."]
    stop_distance: Annotated[Length | None, "Where it first comes to rest [m]."]
    end_acceleration: Annotated[Acceleration | None, "Acceleration at the end; under a law [m/s^2]."]
    alternatives: Annotated[tuple[Solution, ...] | None, "Other motions with the same numbers, for a single phase."]
    motion: Annotated[tuple[Moment, ...], "Time, displacement, velocity and acceleration along the way."]
    numerics: Numerics | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def constant_suffices(*, law: "Any" = None, **_: "Any") -> str | None:
    """Without a law, acceleration is constant in every phase."""
    return "no law of the acceleration is given" if law is None else None


def rectilinear(
    *,
    phases: Annotated[
        Phase | tuple[Phase, ...],
        "Stretches of constant acceleration, each by three of its five numbers; the start speed of a later one is the "
        "end speed of the one before.",
    ],
    law: Annotated[
        AccelerationFormula | None,
        "Acceleration as a formula of t [s], x [m] or v [m/s], with its unit at the end, e.g. -0.004*v^2 m/s^2.",
    ] = None,
    let: Annotated[tuple[Variable, ...], "Variables of the law, e.g. k=0.004 1/m."] = (),
    steps: Annotated[Count, "Rows of the table in every phase [-]."] = 6,
) -> Straight:
    """Straight motion with constant acceleration: any three of speeds, acceleration, distance and time give the rest.

    Equation
    --------
    v = u + a·t, s = t·(u + v)/2, v² = u² + 2·a·s.

    Raises
    ------
    InadmissibleError
        When fewer than three numbers are given, when they contradict one another, or when the motion never gets there.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 3.3.

    Examples
    --------
    >>> rectilinear(phases=Phase(start_speed=20.0, end_speed=0.0, distance=50.0)).acceleration
    -4.0
    """
    _check_steps(steps)
    require(law is None, "a law needs the model for laws", code="model")
    several = phases if isinstance(phases, tuple) else (phases,)
    solutions_by_phase = []
    speed: float | None = None
    for index, phase in enumerate(several):
        continued = phase
        if speed is not None and phase.start_speed is None:
            continued = Phase(speed, phase.end_speed, phase.acceleration, phase.distance, phase.time)
        if speed is not None and phase.start_speed is not None:
            require(
                abs(plain(phase.start_speed) - plain(speed)) <= TOLERANCE * abs(plain(speed)),
                "phase {number} starts at {start}, but the one before ends at {end}",
                code="inconsistent",
                hint="leave out the start speed of later phases",
                number=index + 1,
                start=(phase.start_speed, Speed),
                end=(speed, Speed),
            )
        solutions_by_phase.append(solutions(continued))
        speed = solutions_by_phase[-1][0].end_speed
    chosen = [found_motions[0] for found_motions in solutions_by_phase]
    time, distance = summed([motion.time for motion in chosen]), summed([motion.distance for motion in chosen])
    alone = chosen[0] if len(chosen) == 1 else None
    stop = _stop(alone) if alone is not None else None
    return Straight(
        start_speed=chosen[0].start_speed,
        end_speed=chosen[-1].end_speed,
        acceleration=alone.acceleration if alone is not None else None,
        distance=distance,
        time=time,
        mean_speed=distance / time if plain(time) > 0.0 else None,
        stop_time=stop[0] if stop else None,
        stop_distance=stop[1] if stop else None,
        end_acceleration=None,
        alternatives=tuple(solutions_by_phase[0][1:]) if len(solutions_by_phase[0]) > 1 and alone is not None else None,
        motion=tuple(_table(chosen, steps)),
        checks=_energy(chosen),
        advice=_several_advice(solutions_by_phase),
    )


def rectilinear_law(
    *,
    phases: Annotated[Phase | tuple[Phase, ...], "Start speed, and the end: time, distance or end speed."],
    law: Annotated[AccelerationFormula | None, "Acceleration as a formula of t, x or v."] = None,
    let: Annotated[tuple[Variable, ...], "Variables of the law."] = (),
    steps: Annotated[Count, "Rows of the table [-]."] = 6,
) -> Straight:
    """Straight motion under a law of the acceleration, followed by Taylor series to a time, a distance or a speed.

    Equation
    --------
    dv/dt = a(t, x, v), dx/dt = v, from x = 0 at t = 0.

    Raises
    ------
    InadmissibleError
        When the start speed is missing, more than one end is given, the end is never reached, or the law has a pole.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 3.3; Moore, Methods and Applications of
    Interval Analysis, SIAM 1979, section 8.1.

    Examples
    --------
    >>> from dynamics_cli.records import Formula
    >>> fall = Formula("9.80665 - 0.004*v^2", 1.0, "m/s^2")
    >>> round(rectilinear_law(phases=Phase(start_speed=0.0, time=3.0), law=fall).distance, 9)
    41.754259672
    """
    _check_steps(steps)
    phase = phases[0] if isinstance(phases, tuple) else phases
    require(not isinstance(phases, tuple) or len(phases) == 1, "a law takes one phase only", code="one-phase",
            hint="give one start speed, and a time, a distance or an end speed")  # fmt: skip
    require(law is not None, "no law is given", code="no-law", hint="--law '-0.004*v^2 m/s^2'")
    require(phase.start_speed is not None, "a law needs the start speed", code="missing", hint="--start-speed")
    require(phase.acceleration is None, "the law gives the acceleration: leave out the number", code="exclusive")
    ends = [name for name in ("time", "distance", "end_speed") if getattr(phase, name) is not None]
    require(
        len(ends) <= 1,
        "a law with a start speed needs one end, not {ends}",
        code="exclusive",
        hint="give time, distance or end speed; without one the motion runs until rest",
        ends=" and ".join(name.replace("_", " ") for name in ends),
    )
    numbers = (phase.start_speed, phase.time, phase.distance, phase.end_speed, *(each.value for each in let))
    only_in_doubles(*numbers)
    plainly = Phase(plain(phase.start_speed), plain(phase.end_speed), None, plain(phase.distance), plain(phase.time))
    values = tuple(type(each)(each.name, plain(each.value), each.unit, each.dimension) for each in let)
    function = law_of(law, values, more="; or give it a value, --let 'k=0.004 1/m'")  # type: ignore[arg-type]
    motion, rough = run(function, plainly), run(function, plainly, halved=True)
    distance, speed, rate = motion.at(motion.end)
    stop = motion.stop
    return Straight(
        start_speed=plainly.start_speed,  # type: ignore[arg-type]
        end_speed=speed,
        acceleration=None,
        distance=distance,
        time=motion.end,
        mean_speed=distance / motion.end,
        stop_time=stop,
        stop_distance=motion.at(stop)[0] if stop is not None else None,
        end_acceleration=rate,
        alternatives=None,
        motion=tuple(
            Moment(1, time, *motion.at(time)) for time in (*(motion.end * k / steps for k in range(steps)), motion.end)
        ),
        numerics=_numerics(motion, rough),
        checks=_work(motion, function),
    )


def _check_steps(steps: int) -> None:
    require((steps >= 1) & (steps <= MOST_STEPS), "the table cannot have {steps} rows", code="steps", steps=steps,
            hint=f"give 1 to {MOST_STEPS}")  # fmt: skip


def _stop(solution: Solution) -> "tuple[float, float] | None":
    """When and where it is first at rest, if it ever is from its start on."""
    if plain(solution.acceleration) == 0.0 or plain(solution.start_speed) * plain(solution.acceleration) >= 0.0:
        return None
    time = -solution.start_speed / solution.acceleration
    return time, time * (0.5 * solution.start_speed)


def _table(chosen: "list[Solution]", steps: int) -> "list[Moment]":
    rows = []
    now: float = 0.0
    travelled: float = 0.0
    for number, motion in enumerate(chosen, 1):
        for step in range(steps + 1):
            time = motion.time * step / steps
            gone = time * (motion.start_speed + 0.5 * (motion.acceleration * time))
            speed = motion.end_speed if step == steps else motion.start_speed + motion.acceleration * time
            rows.append(Moment(number, now + time, travelled + gone, speed, motion.acceleration))
        now, travelled = now + motion.time, travelled + motion.distance
    return rows


def _energy(chosen: "list[Solution]") -> tuple[Check, ...]:
    """v² − u² = 2as for every phase."""
    worst = 0.0
    for motion in chosen:
        u, v, a, s = (plain(x) for x in (motion.start_speed, motion.end_speed, motion.acceleration, motion.distance))
        size = max(u * u, v * v, abs(2.0 * a * s))
        worst = max(worst, abs((v - u) * (v + u) - 2.0 * a * s) / size if size else 0.0)
    return (Check("v² − u² = 2as", worst <= TOLERANCE, worst, TOLERANCE),)


def _several_advice(ways: "list[list[Solution]]") -> tuple[Advice, ...]:
    if all(len(motions) == 1 for motions in ways):
        return ()
    if len(ways) > 1:
        return (Advice("two-motions", "a phase has two motions with these numbers: the earlier one is taken", "note"),)
    other = ways[0][1]
    message = worded(
        "another motion has the same numbers: in {time:6}, from {start:6} to {end:6}",
        time=(plain(other.time), Time),
        start=(plain(other.start_speed), Speed),
        end=(plain(other.end_speed), Speed),
    )
    return (Advice("two-motions", message, "note"),)


def _numerics(motion: Run, rough: Run) -> Numerics:
    fine, crude = motion.at(motion.end), rough.at(rough.end)
    bounds = [("time", motion.end, rough.end), ("distance", fine[0], crude[0]), ("end_speed", fine[1], crude[1])]
    if motion.stop is not None and rough.stop is not None:
        bounds.append(("stop_time", motion.stop, rough.stop))
    return Numerics(
        "Taylor series of order 18; errors estimated with half the steps",
        tuple(ErrorBound(name, estimate(*values), relative=False) for name, *values in bounds),
    )


def _work(motion: Run, law: "Any") -> tuple[Check, ...]:
    """Check the law at the end against the slope of the series there."""
    distance, speed, rate = motion.at(motion.end)
    try:
        expected = float(law(t=motion.end, x=distance, v=speed))
    except (ArithmeticError, ValueError):
        return ()
    size = max(abs(expected), abs(motion.at(0.0)[2]), abs(speed / motion.end))
    apart = abs(rate - expected) / size if size else 0.0
    return (Check("acceleration at the end is that of the law", apart <= TOLERANCE, apart, TOLERANCE),)
