"""When two points with constant relative acceleration are closest."""

import math

from dynamics_cli.numerics.elementary import maximum
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.polynomials import roots_between
from dynamics_cli.numerics.vectors import Vector, add, dot, length, scale
from dynamics_cli.numerics.vectors import compensated_cross as cross
from dynamics_cli.records import Check

# A pose a little earlier or later may be closer by this share of the sizes, which is rounding.
CLOSER = 1e-12


def place_at(r: Vector, v: Vector, a: Vector, time: float) -> Vector:
    """The position after a time of constant acceleration."""
    return add(r, scale(time, add(v, scale(0.5 * time, a))))


def closest(r: Vector, v: Vector, a: Vector) -> tuple[float, float]:
    """When they are closest from time 0 on, and how far apart."""
    if not any(map(plain, a)):
        speed = length(v)
        if plain(speed) == 0.0:
            return 0.0 * speed, length(r)
        when = -(dot(r, v) / speed / speed)
        if plain(when) <= 0.0:
            return 0.0 * speed, length(r)
        # not by the positions then, whose difference would cancel
        return when, length(cross(r, v)) / speed
    times = [0.0, *_stationary([plain(x) for x in r], [plain(x) for x in v], [plain(x) for x in a])]
    best = min(times, key=lambda time: math.hypot(*(plain(x) for x in place_at(r, v, a, time))))
    if best == 0.0:
        return 0.0 * length(a), length(r)
    when = _polished(r, v, a, best)
    return when, length(place_at(r, v, a, when))


def nearest_check(gap: float, around: "list[float]", size: float) -> tuple[Check, ...]:
    """Check that they are not closer slightly earlier or later."""
    short = max(0.0, gap - min(around))
    return (Check("not closer just before or after", short <= CLOSER * size, short, CLOSER * size),)


def check_of_constant(r: Vector, v: Vector, a: Vector, when: float, gap: float) -> tuple[Check, ...]:
    """The same for constant accelerations, in doubles."""
    r, v, a = (tuple(map(plain, x)) for x in (r, v, a))  # type: ignore[assignment]
    when, gap = plain(when), plain(gap)
    size = length(r) + length(v) * when + length(a) * when * when
    step = 1e-3 * when or 1e-6
    around = [length(place_at(r, v, a, time)) for time in (max(when - step, 0.0), when + step)]
    return nearest_check(gap, around, size)


def _polished(r: Vector, v: Vector, a: Vector, time: float) -> float:
    """One Newton step in the numbers given, which carries their slopes and bounds into the time."""
    place, speed = place_at(r, v, a, time), add(v, scale(time, a))
    slope = dot(speed, speed) + dot(place, a)
    if plain(slope) <= 0.0:
        return time + 0.0 * dot(r, v)
    return maximum(time - dot(place, speed) / slope, 0.0)


def _stationary(r: list[float], v: list[float], a: list[float]) -> list[float]:
    """The times after 0 at which the distance is stationary: real roots of a cubic."""
    inner = [math.fsum(x * y for x, y in zip(p, q, strict=True)) for p, q in ((r, v), (v, v), (r, a), (v, a), (a, a))]
    cubic = (inner[0], inner[1] + inner[2], 1.5 * inner[3], 0.5 * inner[4])
    return roots_between(cubic, 0.0, 1.0 + max(abs(part / cubic[3]) for part in cubic))
