"""Two points in motion: what one sees of the other, and when and where they are closest."""

import math
from itertools import pairwise

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import maximum
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.vectors import Vector, add, dot, length, scale, subtract
from dynamics_cli.numerics.vectors import compensated_cross as cross
from dynamics_cli.quantities import (
    Acceleration,
    AccelerationVector,
    Annotated,
    Distance,
    LengthFormula,
    Position,
    Speed,
    Time,
    Variable,
    Velocity,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


ZERO = (0.0, 0.0, 0.0)
# Times between which a minimum of the distance of two formulas is looked for.
GRID = 2000


@record
class Mover:
    """A point with constant acceleration, or with formulas of the time for coordinates."""

    position: Annotated[Position, "Position at time 0, e.g. 0, 0, 0 m."] = ZERO
    velocity: Annotated[Velocity, "Velocity at time 0, e.g. 15, 0, 0 m/s."] = ZERO
    acceleration: Annotated[AccelerationVector, "Constant acceleration, e.g. 0, 0, -9.81 m/s^2."] = ZERO
    x: Annotated[LengthFormula | None, "Instead, x over the time t [s], e.g. 20*t m."] = None
    y: Annotated[LengthFormula | None, "And y over t, e.g. 3*sin(t) m."] = None
    z: Annotated[LengthFormula | None, "And z over t, e.g. exp(-t) m."] = None

    @property
    def curved(self) -> bool:
        """Whether it moves by formulas."""
        return any(formula is not None for formula in (self.x, self.y, self.z))


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
    acceleration: Annotated[AccelerationVector, "Relative acceleration at that time [m/s^2]."]
    speed: Annotated[Speed, "Magnitude of the relative velocity at that time [m/s]."]
    acceleration_size: Annotated[Acceleration, "Magnitude of the relative acceleration [m/s^2]."]
    first_position: Annotated[Position, "Where the first is at the closest approach [m]."]
    second_position: Annotated[Position, "Where the second is at the closest approach [m]."]
    numerics: Numerics | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def relative(
    *,
    first: Annotated[Mover, "The point from which the other is seen."],
    second: Annotated[Mover, "The point that is seen."],
    time: Annotated[Time, "Time of the relative position and velocity shown, e.g. 2 s."] = 0.0,
    end: Annotated[Time | None, "Until when the closest approach of formulas is searched, e.g. 60 s."] = None,
    let: Annotated[tuple[Variable, ...], "Variables of formulas, e.g. r=3 m, w=2 rad/s."] = (),
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
        When a result leaves the range of a double, or a formula has a pole, a corner or no end of its times.

    Notes
    -----
    Formulas are differentiated exactly; their closest approach is the smallest of the minima between 2,000 times, each
    bisected to the last digit.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 3.4.

    Examples
    --------
    >>> seen = Mover(position=(1000.0, 500.0, 0.0), velocity=(-10.0, -5.0, 0.0))
    >>> relative(first=Mover(), second=seen).closest_time
    100.0
    """
    if first.curved or second.curved:
        return _of_curves(first, second, plain(time), end, let)
    require(not let, "no formula takes these variables", code="let", hint="leave out --let")
    r = subtract(second.position, first.position)
    v = subtract(second.velocity, first.velocity)
    a = subtract(second.acceleration, first.acceleration)
    here, now = _at(r, v, a, time), add(v, scale(time, a))
    when, gap = _closest(r, v, a)
    apart = length(here)
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
        closest_speed=length(add(v, scale(when, a))),
        distance=apart,
        closing_speed=closing,
        position=here,
        velocity=now,
        acceleration=a,
        speed=length(now),
        acceleration_size=length(a),
        first_position=_at(first.position, first.velocity, first.acceleration, when),
        second_position=_at(second.position, second.velocity, second.acceleration, when),
        checks=_nearest_check(r, v, a, when, gap),
        advice=advice,
    )


class Pair:
    """Two motions in doubles, and the second as seen from the first."""

    def __init__(self, first: Mover, second: Mover, let: "Any") -> None:
        self.motions = [_motion(one, let) if one.curved else one for one in (first, second)]

    def of(self, which: int, time: float) -> "tuple[Vector, Vector, Vector]":
        """Position, velocity and acceleration of one of them."""
        motion = self.motions[which]
        if isinstance(motion, Mover):
            r, v, a = (tuple(map(plain, x)) for x in (motion.position, motion.velocity, motion.acceleration))
            return _at(r, v, a, time), add(v, scale(time, a)), a  # type: ignore[arg-type,return-value]
        state = motion.state(time)
        return state.position, state.velocity, state.acceleration

    def seen(self, time: float) -> "tuple[Vector, Vector, Vector]":
        """Relative position, velocity and acceleration."""
        one, other = self.of(0, time), self.of(1, time)
        return tuple(subtract(b, a) for a, b in zip(one, other, strict=True))  # type: ignore[return-value]

    def rate(self, time: float) -> float:
        """r·v, which vanishes where they are closest."""
        r, v, _ = self.seen(time)
        return dot(r, v)


def _motion(mover: Mover, let: "Any") -> "Any":
    from dynamics_cli.path.curves.moving_point import MovingPoint

    given = (mover.position, mover.velocity, mover.acceleration)
    require(
        given == (ZERO, ZERO, ZERO),
        "a point moves by formulas, or from a position with velocity and acceleration: both are given",
        code="exclusive",
        hint="write the position into the formulas",
    )
    return MovingPoint({"x": mover.x, "y": mover.y, "z": mover.z}, None, None, let).plainly()


def _of_curves(first: Mover, second: Mover, time: float, end: "float | None", let: "Any") -> Relative:
    require(end is not None, "the closest approach of formulas needs an end of its search", code="missing",
            hint="--end '60 s'")  # fmt: skip
    last = plain(end or 0.0)
    require(
        last > 0.0 and 0.0 <= time <= last,
        "the range of times from 0 to {end} does not hold {time}",
        end=(last, Time),
        time=(time, Time),
        code="times",
        hint="give an end after time 0 and after the time asked for",
    )
    pair = Pair(first, second, let)
    for motion in pair.motions:
        if not isinstance(motion, Mover):
            motion.check(0.0, last)
    grid = [last * k / GRID for k in range(GRID + 1)]
    rates = [pair.rate(at) for at in grid]
    near = [
        _root(pair.rate, low, high)
        for low, high, one, other in zip(grid, grid[1:], rates, rates[1:], strict=False)
        if one < 0.0 <= other
    ]
    when = min([0.0, *near, last], key=lambda at: length(pair.seen(at)[0]))
    r, v, a = pair.seen(time)
    apart, gap, there = length(r), length(pair.seen(when)[0]), length(pair.seen(when)[1])
    size = max(length(pair.of(which, when)[0]) for which in (0, 1))
    advice: tuple[Advice, ...] = ()
    if apart == 0.0:
        advice += (
            Advice(
                "touching", "they are at the same place: there is no closing direction", "note", result="closing_speed"
            ),
        )
    if when in (0.0, last):
        where = "start" if when == 0.0 else "end"
        advice += (Advice("edge", f"they are closest at the {where} of the times that were searched", "note"),)
    around = [length(pair.seen(min(max(when + step, 0.0), last))[0]) for step in (-1e-4 * last, 1e-4 * last)]
    short = max(0.0, gap - min(around))
    return Relative(
        closest_distance=gap, closest_time=when, closest_speed=there, distance=apart,
        closing_speed=-dot(r, v) / apart if apart else None, position=r, velocity=v, acceleration=a, speed=length(v),
        acceleration_size=length(a), first_position=pair.of(0, when)[0], second_position=pair.of(1, when)[0],
        checks=(Check("not closer just before or after", short <= 1e-12 * size, short, 1e-12 * size),), advice=advice,
        numerics=Numerics(
            "exact derivatives of the formulas; minima of the distance bisected, its rounding estimated",
            (ErrorBound("closest_distance", 1e-15 * size, relative=False),),
        ),
    )  # fmt: skip


def _at(r: Vector, v: Vector, a: Vector, time: float) -> Vector:
    return add(r, scale(time, add(v, scale(0.5 * time, a))))


def _closest(r: Vector, v: Vector, a: Vector) -> tuple[float, float]:
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
    best = min(times, key=lambda time: math.hypot(*(plain(x) for x in _at(r, v, a, time))))
    if best == 0.0:
        return 0.0 * length(a), length(r)
    when = _polished(r, v, a, best)
    return when, length(_at(r, v, a, when))


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


def _root(function: "Any", low: float, high: float) -> float:
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
