"""Two points in motion: relative motion, and time and place of the closest approach."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.roots import bisected
from dynamics_cli.numerics.vectors import add, dot, length, scale, subtract
from dynamics_cli.path.relative.closest import check_of_constant, closest, nearest_check, place_at
from dynamics_cli.path.relative.motions import Mover, Pair, noise_of_rates, require_one_sort
from dynamics_cli.quantities import (
    Acceleration,
    AccelerationVector,
    Annotated,
    Distance,
    Position,
    Speed,
    Time,
    Variable,
    Velocity,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.path.relative.motions import State

# Number of times between which a minimum of the distance is sought.
GRID = 2000
# The same for samples of an uncertain motion beside a track.
COARSE = 250
# A distance below this many of its standard deviations may be none.
WITHIN = 3.0


@record
class RelativePoint:
    """The second point as the first sees it at one measured time."""

    time: Annotated[Time, "Time [s]."]
    distance: Annotated[Distance, "Distance [m]."]
    distance_noise: Annotated[Distance, "Its standard deviation [m]."]
    closing_speed: Annotated[Speed | None, "Rate at which the distance shrinks [m/s]."]
    closing_speed_noise: Annotated[Speed, "Its standard deviation [m/s]."]
    position: Annotated[Position, "Relative position [m]."]


@record
class Relative:
    """The second point as the first sees it, without turning."""

    closest_distance: Annotated[Distance, "Distance at the closest approach, from time 0 on [m]."]
    closest_time: Annotated[Time, "When they are closest [s]."]
    closest_speed: Annotated[Speed, "Relative speed there [m/s]."]
    shown_time: Annotated[Time, "The time asked for, else 0 or where the tracks begin to overlap [s]."]
    distance: Annotated[Distance, "Distance at that time [m]."]
    closing_speed: Annotated[Speed | None, "Rate at which the distance shrinks at that time [m/s]."]
    position: Annotated[Position, "Relative position at that time [m]."]
    velocity: Annotated[Velocity, "Relative velocity at that time [m/s]."]
    acceleration: Annotated[AccelerationVector, "Relative acceleration at that time [m/s^2]."]
    speed: Annotated[Speed, "Magnitude of the relative velocity at that time [m/s]."]
    acceleration_size: Annotated[Acceleration, "Magnitude of the relative acceleration [m/s^2]."]
    first_position: Annotated[Position, "Where the first is at the closest approach [m]."]
    second_position: Annotated[Position, "Where the second is at the closest approach [m]."]
    closest_distance_noise: Annotated[Distance | None, "Its standard deviation, of tracks [m]."] = None
    closest_time_noise: Annotated[Time | None, "Standard deviation of its time [s]."] = None
    distance_noise: Annotated[Distance | None, "Standard deviation of the distance at the time shown [m]."] = None
    closing_speed_noise: Annotated[Speed | None, "Standard deviation of the closing speed [m/s]."] = None
    points: Annotated[tuple[RelativePoint, ...] | None, "The relative motion at the measured times."] = None
    numerics: Numerics | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def relative(
    *,
    first: Annotated[Mover, "The point from which the other is seen."],
    second: Annotated[Mover, "The point that is seen."],
    time: Annotated[Time | None, "Time of the relative motion shown, e.g. 2 s; else the first time."] = None,
    end: Annotated[Time | None, "Until when the closest approach is searched; formulas need it, e.g. 60 s."] = None,
    let: Annotated[tuple[Variable, ...], "Variables of formulas, e.g. r=3 m, w=2 rad/s."] = (),
) -> Relative:
    """Relative position, velocity and acceleration of two points, and their closest approach.

    Equation
    --------
    r = r₂ − r₁, v = v₂ − v₁, a = a₂ − a₁; closest where r·v = 0: t = −r·v/‖v‖², distance ‖r×v‖/‖v‖ without relative
    acceleration, else the real roots of r·v + (‖v‖² + r·a)t + (3/2)v·a t² + ‖a‖²t³/2 = 0.

    Raises
    ------
    InadmissibleError
        When a result leaves the range of a double, a formula has a pole, a corner or no end of its times, or tracks
        have no time, axes or origin in common.

    Notes
    -----
    Formulas are differentiated exactly; their closest approach is the smallest of the minima between 2,000 times, each
    bisected to the last digit. So are smoothed tracks. Their noise is carried to first order: at the closest approach
    by σ_r of the relative position into the distance, and √(σ_r²v² + r²σ_v²)/(v² + r·a) into its time.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 3.4.

    Examples
    --------
    >>> seen = Mover(position=(1000.0, 500.0, 0.0), velocity=(-10.0, -5.0, 0.0))
    >>> relative(first=Mover(), second=seen).closest_time
    100.0
    """
    for mover in (first, second):
        require_one_sort(mover)
    if not (first.simple and second.simple):
        return _searched(Pair(first, second, let), time, None if end is None else plain(end))
    require(not let, "no formula takes these variables", code="let", hint="leave out --let")
    r = subtract(second.position, first.position)
    v = subtract(second.velocity, first.velocity)
    a = subtract(second.acceleration, first.acceleration)
    moment = 0.0 if time is None else time
    when, gap = closest(r, v, a)
    fields, advice = _shown((place_at(r, v, a, moment), add(v, scale(moment, a)), a))
    fields["shown_time"] = moment
    if plain(when) == 0.0 and not any(map(plain, a)) and not any(map(plain, v)):
        advice += (Advice("at-rest", "they do not move relative to each other: their distance never changes", "note"),)
    elif plain(when) == 0.0:
        advice += (Advice("parting", "they are closest at time 0 and part from then on", "note"),)
    return Relative(
        closest_distance=gap,
        closest_time=when,
        closest_speed=length(add(v, scale(when, a))),
        first_position=place_at(first.position, first.velocity, first.acceleration, when),
        second_position=place_at(second.position, second.velocity, second.acceleration, when),
        checks=check_of_constant(r, v, a, when, gap),
        advice=advice,
        **fields,
    )


def _shown(state: "State") -> "tuple[dict[str, Any], tuple[Advice, ...]]":
    """Relative motion at the time asked for."""
    r, v, a = state
    apart = length(r)
    touching = plain(apart) == 0.0
    fields = {
        "distance": apart,
        "closing_speed": None if touching else -(dot(r, v) / apart),
        "position": r,
        "velocity": v,
        "acceleration": a,
        "speed": length(v),
        "acceleration_size": length(a),
    }
    message = "they are at the same place: there is no closing direction"
    return fields, (Advice("touching", message, "note", result="closing_speed"),) if touching else ()


def _searched(pair: Pair, time: "float | None", end: "float | None") -> Relative:
    """The closest approach among the minima between a grid of times, each bisected."""
    start, last = pair.start, pair.end(end)
    moment = start if time is None else plain(time)
    require(
        last > start and start <= moment <= last,
        "the range of times from {start} to {end} does not hold {time}"
        if last > start
        else "the search ends at {end}, not after its start at {start}",
        start=(start, Time),
        end=(last, Time),
        time=(moment, Time),
        code="times",
        hint="give times within the tracks" if pair.measured else "give an end after time 0 and the time asked for",
    )
    pair.check(last)
    span = last - start
    when = _nearest(pair, start, last)
    r, v, _ = state = pair.seen(when)
    places = [motion.at(when)[0] for motion in pair.motions]
    fields, advice = _shown(pair.seen(moment))
    fields["shown_time"] = moment
    if when in (start, last):
        edge = "start" if when == start else "end"
        advice += (Advice("edge", f"they are closest at the {edge} of the times that were searched", "note"),)
    gap, size = length(r), max(map(length, places))
    around = [length(pair.seen(min(max(t, start), last))[0]) for t in (when - 1e-4 * span, when + 1e-4 * span)]
    if pair.measured:
        fields |= _noise(pair, moment, when, last)
        fields |= {"closest_time_noise": None if when in (start, last) else noise_of_rates(state, _at(pair, when))[1]}
        for motion in pair.measured:
            advice += motion.advice
        if gap < WITHIN * fields["closest_distance_noise"]:
            words = "the closest distance is within its noise: they may have met, and it is estimated too large"
            advice += (Advice("within-noise", words, remedy="count it as an upper limit"),)
        numerics = Numerics("quintic smoothing splines; noise is the standard deviation of each number")
    else:
        method = "exact derivatives of the formulas; minima of the distance bisected, its rounding estimated"
        numerics = Numerics(method, (ErrorBound("closest_distance", 1e-15 * size, relative=False),))
    return Relative(
        closest_distance=gap,
        closest_time=when,
        closest_speed=length(v),
        first_position=places[0],
        second_position=places[1],
        checks=nearest_check(gap, around, size),
        advice=advice,
        numerics=numerics,
        **fields,
    )


def _nearest(pair: Pair, start: float, last: float) -> float:
    """When they are closest: at an end, or at the best of the minima."""
    count = COARSE if pair.measured and drawing() else GRID
    grid = [start + (last - start) * k / count for k in range(count + 1)]
    rates = [pair.rate(moment) for moment in grid]
    near = [bisected(pair.rate, grid[k], grid[k + 1]) for k in range(count) if rates[k] < 0.0 <= rates[k + 1]]
    return min([start, *near, last], key=lambda moment: length(pair.seen(moment)[0]))


def _at(pair: Pair, time: float) -> "tuple[float, float]":
    """Noise of the relative position and velocity at one time."""
    place, velocity = pair.noise([time])
    return float(place[0]), float(velocity[0])


def _noise(pair: Pair, moment: float, when: float, last: float) -> "dict[str, Any]":
    """Noise of distances and closing speeds, and the table at the measured times."""
    every = () if drawing() else pair.measured[0].track.times
    times = [time for time in every if pair.start <= time <= last]
    rows = []
    for time, *noise in zip(times, *(pair.noise(times) if times else ((), ())), strict=True):
        state = pair.seen(time)
        row, _ = _shown(state)
        closing = noise_of_rates(state, (float(noise[0]), float(noise[1])))[0]
        rows.append(
            RelativePoint(time, row["distance"], float(noise[0]), row["closing_speed"], closing, row["position"])
        )
    noise_now = _at(pair, moment)
    return {
        "closest_distance_noise": _at(pair, when)[0],
        "distance_noise": noise_now[0],
        "closing_speed_noise": noise_of_rates(pair.seen(moment), noise_now)[0],
        "points": tuple(rows),
    }
