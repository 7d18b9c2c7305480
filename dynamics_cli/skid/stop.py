"""A whole stop: reaction, rise of the deceleration, steady braking, and the position of the vehicle over time."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import maximum, minimum, multiply_add, sqrt
from dynamics_cli.numerics.road.drag import drag_advice, drag_along, require_drag
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Annotated,
    Count,
    Distance,
    DragFactor,
    Fraction,
    Friction,
    Gravity,
    RoadSpeed,
    Slope,
    Time,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.diagnostics import balance, reaction_advice

MOST_STEPS = 10000


@record
class Moment:
    """One row of the time–distance table."""

    phase: Annotated[str, "What the vehicle is doing: reaction, build-up or braking."]
    time: Annotated[Time, "Time since the hazard was perceived [s]."]
    distance: Annotated[Distance, "Distance travelled since then [m]."]
    speed: Annotated[RoadSpeed, "Speed at that time [m/s]."]


@record
class Stop:
    """A stop in its phases."""

    stopping_distance: Annotated[Distance, "Distance from the perception of the hazard to rest [m]."]
    stopping_time: Annotated[Time, "Time from the perception of the hazard to rest [s]."]
    reaction_distance: Annotated[Distance, "Distance travelled before the brakes act [m]."]
    build_up_distance: Annotated[
        Distance | None, "Distance travelled while the deceleration rises; needs the build-up time [m]."
    ]
    build_up_duration: Annotated[
        Time | None,
        "Time while the deceleration rises, shorter than given when the vehicle stops before; needs the build-up "
        "time [s].",
    ]
    braking_speed: Annotated[RoadSpeed, "Speed where the full deceleration is reached [m/s]."]
    braking_distance: Annotated[Distance, "Distance travelled at full deceleration [m]."]
    braking_time: Annotated[Time, "Time at full deceleration [s]."]
    drag_factor: Annotated[DragFactor, "Full deceleration along the road over gravity [-]."]
    deceleration: Annotated[Acceleration, "Full deceleration along the road [m/s^2]."]
    timeline: Annotated[tuple[Moment, ...], "Time, distance and speed from perception to rest."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def stop(
    *,
    speed: Annotated[RoadSpeed, "Speed when the hazard is perceived [m/s]."],
    friction: Annotated[Friction, "Coefficient of friction between tyre and road [-]."],
    reaction_time: Annotated[Time, "Time from the perception of the hazard until the brakes begin to act [s]."],
    build_up_time: Annotated[
        Time | None, "Time in which the deceleration rises linearly from zero to its full value, e.g. 0.2 s [s]."
    ] = None,
    grade: Annotated[Slope, "Rise over run of the road in the direction of travel, uphill positive [-]."] = 0.0,
    braking: Annotated[
        Fraction, "Share of the full friction that the brakes use, 1 when all wheels are locked [-]."
    ] = 1.0,
    steps: Annotated[Count, "Rows of the time–distance table for every phase, equally spaced in time [-]."] = 4,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Stop:
    """Distance and time of a whole stop: reaction at constant speed, linear rise of the deceleration, steady braking.

    Equation
    --------
    s = v t_r + τ(v − δ/3) + (v − δ)²/(2a), a = g f; δ = aτ²/(2T) is the speed lost in the build-up of duration T, and
    τ = T, or √(2vT/a) when the vehicle comes to rest before the full deceleration is reached.

    Returns
    -------
    Stop
        Total distance and time, those of every phase, and the time–distance table.

    Raises
    ------
    InadmissibleError
        When the drag factor is not above zero, or steps is not within 1 to 10000.

    Notes
    -----
    A point mass. The driver holds the speed on the grade until the brakes act; the rise of the deceleration includes
    the grade's share. Without a build-up time the full deceleration acts at once and the phase is left out of the
    table.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10 (braking), chapter 3 (straight-line
    motion).

    Examples
    --------
    >>> round(stop(speed=20.0, friction=0.7, reaction_time=1.5).stopping_distance, 4)
    59.1347
    """
    require(
        (steps >= 1) & (steps <= MOST_STEPS), "the table cannot have {steps} rows a phase", code="steps", steps=steps
    )
    drag = require_drag(drag_along(friction, grade, braking))
    deceleration = gravity * drag
    travelled = reaction_distance = speed * reaction_time
    now = reaction_time
    rows = [Moment("reaction", 0.0, 0.0, speed), *_between("reaction", (0.0, 0.0, speed), reaction_time, 0.0, steps)]
    rows.append(Moment("reaction", now, travelled, speed))
    braking_speed = speed
    by_means = reaction_distance
    rise: float | None = None
    rise_way: float | None = None
    if build_up_time is not None:
        rise, drop, braking_speed = _build_up(speed, deceleration, build_up_time)
        rise_way = rise * (speed - drop / 3.0)
        rows.extend(_between("build-up", (now, travelled, speed), rise, drop, steps, braking_speed))
        now, travelled = now + rise, travelled + rise_way
        rows.append(Moment("build-up", now, travelled, braking_speed))
        by_means = by_means + rise * (2.0 * speed + braking_speed) / 3.0
    braking_time = braking_speed / deceleration
    braking_way = braking_time * (0.5 * braking_speed)
    rows.extend(_between("braking", (now, travelled, braking_speed), braking_time, braking_speed, steps))
    now, travelled = now + braking_time, travelled + braking_way
    rows.append(Moment("braking", now, travelled, 0.0 * braking_speed))
    by_means = by_means + braking_way
    return Stop(
        stopping_distance=travelled,
        stopping_time=now,
        reaction_distance=reaction_distance,
        build_up_distance=rise_way,
        build_up_duration=rise,
        braking_speed=braking_speed,
        braking_distance=braking_way,
        braking_time=braking_time,
        drag_factor=drag,
        deceleration=deceleration,
        timeline=tuple(rows),
        checks=balance(
            "distance from mean speeds",
            by_means,
            travelled,
            travelled,
            speed,
            reaction_time,
            deceleration,
            0.0 if build_up_time is None else build_up_time,
        ),
        advice=reaction_advice(reaction_time) + drag_advice(friction, grade, braking),
    )


def _build_up(speed: float, deceleration: float, build_up_time: float) -> tuple[float, float, float]:
    """Duration of the rise, the speed it takes and the speed it leaves; it ends early when the vehicle stops."""
    # at the corner, where rounding decides, each of the three keeps the error of the side not taken
    rise = minimum(build_up_time, sqrt(2.0 * speed * build_up_time / deceleration))
    drop = minimum(0.5 * deceleration * build_up_time, speed)
    rest = maximum(multiply_add(-0.5 * deceleration, build_up_time, speed), 0.0)
    return rise, drop, rest


# The speed lost grows with this power of the time.
POWERS = {"reaction": 1, "build-up": 2, "braking": 1}


def _between(
    phase: str, begin: tuple[float, float, float], duration: float, drop: float, steps: int, end: "float | None" = None
) -> list[Moment]:
    """Rows between the ends of a phase, which are results themselves, from its time, way and speed at the begin."""
    start, travelled, speed = begin
    power = POWERS[phase]
    whole = steps**power
    end = speed - drop if end is None else end
    rows = []
    for step in range(1, steps):
        time, gone = duration * step / steps, step**power
        way = travelled + time * (speed - drop * gone / whole / (power + 1.0))
        rows.append(Moment(phase, start + time, way, end + drop * (whole - gone) / whole))
    return rows
