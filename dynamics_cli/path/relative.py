"""Two points in motion: what one sees of the other, and when and where they are closest."""

import math
from itertools import pairwise

from dynamics_cli.numerics.elementary import maximum
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.vectors import Vector, add, dot, scale, subtract
from dynamics_cli.path.bends import cross, norm
from dynamics_cli.quantities import (
    Acceleration,
    AccelerationVector,
    Annotated,
    Distance,
    Position,
    Speed,
    Time,
    Velocity,
)
from dynamics_cli.records import Advice, Check, record

ZERO = (0.0, 0.0, 0.0)


@record
class Mover:
    """A point with constant acceleration."""

    position: Annotated[Position, "Position at time 0, e.g. 0, 0, 0 m."] = ZERO
    velocity: Annotated[Velocity, "Velocity at time 0, e.g. 15, 0, 0 m/s."] = ZERO
    acceleration: Annotated[AccelerationVector, "Constant acceleration, e.g. 0, 0, -9.81 m/s^2."] = ZERO


@record
class Relative:
    """The second point as the first sees it, without turning."""

    closest_distance: Annotated[Distance, "Distance at the closest approach, from time 0 on [m]."]
    closest_time: Annotated[Time, "When they are closest [s]."]
    closest_speed: Annotated[Speed, "Relative speed there [m/s]."]
    distance: Annotated[Distance, "Distance at the time asked for [m]."]
    closing_speed: Annotated[Speed | None, "Rate at which the distance shrinks at that time [m/s]."]
    position: Annotated[Position, "Relative position at that time [m]."]
    velocity: Annotated[Velocity, "Relative velocity at that time [m/s]."]
    acceleration: Annotated[AccelerationVector, "Relative acceleration [m/s^2]."]
    speed: Annotated[Speed, "Magnitude of the relative velocity at that time [m/s]."]
    acceleration_size: Annotated[Acceleration, "Magnitude of the relative acceleration [m/s^2]."]
    first_position: Annotated[Position, "Where the first is at the closest approach [m]."]
    second_position: Annotated[Position, "Where the second is at the closest approach [m]."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def relative(
    *,
    first: Annotated[Mover, "The point from which the other is seen."],
    second: Annotated[Mover, "The point that is seen."],
    time: Annotated[Time, "Time of the relative position and velocity shown, e.g. 2 s."] = 0.0,
) -> Relative:
    """Relative position, velocity and acceleration of two points, and their closest approach.

    Equation
    --------
    r = r₂ − r₁, v = v₂ − v₁, a = a₂ − a₁; closest where r·v = 0: t = −r·v/‖v‖², distance ‖r×v‖/‖v‖ without relative
    acceleration, else the real roots of r·v + (‖v‖² + r·a)t + (3/2)v·a t² + ‖a‖²t³/2 = 0.

    Returns
    -------
    Relative
        Relative motion at a time, and time, distance and places of the closest approach.

    Raises
    ------
    InadmissibleError
        When a result leaves the range of a double.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 3.4.

    Examples
    --------
    >>> seen = Mover(position=(1000.0, 500.0, 0.0), velocity=(-10.0, -5.0, 0.0))
    >>> relative(first=Mover(), second=seen).closest_time
    100.0
    """
    r = subtract(second.position, first.position)
    v = subtract(second.velocity, first.velocity)
    a = subtract(second.acceleration, first.acceleration)
    here, now = _at(r, v, a, time), add(v, scale(time, a))
    when, gap = _closest(r, v, a)
    apart = norm(here)
    closing = None if plain(apart) == 0.0 else -(dot(here, now) / apart)
    advice: tuple[Advice, ...] = ()
    if closing is None:
        advice = (
            Advice(
                "touching", "they are at the same place: there is no closing direction", "note", result="closing_speed"
            ),
        )
    if plain(when) == 0.0 and not any(map(plain, a)) and not any(map(plain, v)):
        advice += (Advice("at-rest", "they do not move relative to each other: their distance never changes", "note"),)
    elif plain(when) == 0.0:
        advice += (Advice("parting", "they are closest at time 0 and part from then on", "note"),)
    return Relative(
        closest_distance=gap,
        closest_time=when,
        closest_speed=norm(add(v, scale(when, a))),
        distance=apart,
        closing_speed=closing,
        position=here,
        velocity=now,
        acceleration=a,
        speed=norm(now),
        acceleration_size=norm(a),
        first_position=_at(first.position, first.velocity, first.acceleration, when),
        second_position=_at(second.position, second.velocity, second.acceleration, when),
        checks=_nearest_check(r, v, a, when, gap),
        advice=advice,
    )


def _at(r: Vector, v: Vector, a: Vector, time: float) -> Vector:
    return add(r, scale(time, add(v, scale(0.5 * time, a))))


def _closest(r: Vector, v: Vector, a: Vector) -> tuple[float, float]:
    """When they are closest from time 0 on, and how far apart."""
    if not any(map(plain, a)):
        speed = norm(v)
        if plain(speed) == 0.0:
            return 0.0 * speed, norm(r)
        when = -(dot(r, v) / speed / speed)
        if plain(when) <= 0.0:
            return 0.0 * speed, norm(r)
        # not by the positions then, whose difference would cancel
        return when, norm(cross(r, v)) / speed
    times = [0.0, *_stationary([plain(x) for x in r], [plain(x) for x in v], [plain(x) for x in a])]
    best = min(times, key=lambda time: math.hypot(*(plain(x) for x in _at(r, v, a, time))))
    if best == 0.0:
        return 0.0 * norm(a), norm(r)
    when = _polished(r, v, a, best)
    return when, norm(_at(r, v, a, when))


def _rate(r: Vector, v: Vector, a: Vector, time: float) -> float:
    return dot(_at(r, v, a, time), add(v, scale(time, a)))


def _polished(r: Vector, v: Vector, a: Vector, time: float) -> float:
    """One Newton step in the numbers given, which carries their slopes and bounds into the time."""
    place, speed = _at(r, v, a, time), add(v, scale(time, a))
    slope = dot(speed, speed) + dot(place, a)
    if plain(slope) <= 0.0:
        return time + 0.0 * dot(r, v)
    return maximum(time - dot(place, speed) / slope, 0.0)


def _stationary(r: list[float], v: list[float], a: list[float]) -> list[float]:
    """The times after 0 at which the distance is stationary: real roots of a cubic, by its own turning points."""
    inner = [math.fsum(x * y for x, y in zip(p, q, strict=True)) for p, q in ((r, v), (v, v), (r, a), (v, a), (a, a))]
    parts = (inner[0], inner[1] + inner[2], 1.5 * inner[3], 0.5 * inner[4])

    def cubic(t: float) -> float:
        return ((parts[3] * t + parts[2]) * t + parts[1]) * t + parts[0]

    limit = 1.0 + max(abs(part / parts[3]) for part in parts[:3])
    square = parts[2] * parts[2] - 3.0 * parts[3] * parts[1]
    turns = []
    if square > 0.0:
        q = -(parts[2] + math.copysign(math.sqrt(square), parts[2]))
        turns = [q / (3.0 * parts[3]), *([parts[1] / q] if q else [])]
    edges = [0.0, *sorted(turn for turn in turns if 0.0 < turn < limit), limit]
    return [_root(cubic, low, high) for low, high in pairwise(edges) if cubic(low) * cubic(high) <= 0.0]


def _root(function: "object", low: float, high: float) -> float:
    assert callable(function)
    before = function(low)
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return middle
        if (function(middle) < 0.0) == (before < 0.0):
            low = middle
        else:
            high = middle


def _nearest_check(r: Vector, v: Vector, a: Vector, when: float, gap: float) -> tuple[Check, ...]:
    """That a little earlier and later they are no closer."""
    r, v, a = (tuple(map(plain, x)) for x in (r, v, a))  # type: ignore[assignment]
    when, gap = plain(when), plain(gap)
    size = math.hypot(*r) + math.hypot(*v) * when + math.hypot(*a) * when * when
    step = 1e-3 * when or 1e-6
    around = [math.hypot(*_at(r, v, a, time)) for time in (max(when - step, 0.0), when + step)]
    short = max(0.0, gap - min(around))
    return (Check("not closer just before or after", short <= 1e-12 * size, short, 1e-12 * size),)
