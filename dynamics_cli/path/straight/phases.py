"""Straight motion with constant acceleration: any three of start speed, end speed, acceleration, distance and time."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import maximum, multiply_add, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Acceleration, Annotated, Length, Speed, Time
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Five values that a user typed, rounded, agree when they agree this far.
AGREEMENT = 1e-6
# A stop exactly at the place may be beyond it by rounding.
ROUNDING = 1e-15
NAMES = ("start_speed", "end_speed", "acceleration", "distance", "time")
WORDS = {name: name.replace("_", " ") for name in NAMES}


@record
class Phase:
    """A stretch of constant acceleration: three of its five numbers (two, after a phase before it)."""

    start_speed: Annotated[Speed | None, "Velocity at the start, negative backwards, e.g. 20 m/s."] = None
    end_speed: Annotated[Speed | None, "Velocity at the end, e.g. 0 m/s."] = None
    acceleration: Annotated[Acceleration | None, "Constant acceleration, negative to slow down, e.g. -4 m/s^2."] = None
    distance: Annotated[Length | None, "Displacement from start to end, e.g. 45 m."] = None
    time: Annotated[Time | None, "Duration, e.g. 5 s."] = None


@record
class Solution:
    """One motion that fits: all five numbers."""

    start_speed: Annotated[Speed, "Velocity at the start [m/s]."]
    end_speed: Annotated[Speed, "Velocity at the end [m/s]."]
    acceleration: Annotated[Acceleration, "Acceleration [m/s^2]."]
    distance: Annotated[Length, "Displacement [m]."]
    time: Annotated[Time, "Duration [s]."]


def solutions(phase: Phase) -> list[Solution]:
    """Every motion with these numbers, the earliest first.

    Equation
    --------
    v = u + a·t, s = t·(u + v)/2, v² = u² + 2·a·s; differences of squares are factored, and t = 2s/(u + v) for each
    root, so that nothing cancels as a → 0.

    Raises
    ------
    InadmissibleError
        When fewer than three are given, when they contradict one another or leave the motion open, or when the time
        would be negative.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 3.3.

    Examples
    --------
    >>> [round(one.time, 3) for one in solutions(Phase(start_speed=20.0, acceleration=-4.0, distance=48.0))]
    [4.0, 6.0]
    """
    numbers = {name: getattr(phase, name) for name in NAMES if getattr(phase, name) is not None}
    missing = ", ".join(WORDS[name] for name in NAMES if name not in numbers)
    require(
        len(numbers) >= 3,
        "three of the five numbers are needed, {count} given",
        code="three-of-five",
        hint="give {more} more of: {missing}",
        count=len(numbers),
        more=3 - len(numbers),
        missing=missing,
    )
    first = tuple(numbers)[:3]
    motions = [solution for solution in _SOLVERS[first](*(numbers[name] for name in first)) if solution is not None]
    later = [solution for solution in motions if plain(solution.time) >= 0.0]
    if not later:
        require(
            all(plain(solution.time) < 0.0 for solution in motions),
            "the time of this motion leaves the range of a double",
            code="range",
            hint="check the sizes of speed, acceleration and distance",
        )
        require(
            False,
            "the motion would have to end {time} before it starts",
            code="negative-time",
            hint="check the signs of speed, acceleration and distance",
            time=(-plain(motions[0].time), Time),
        )
    later = _agreeing(later, numbers, first)
    return sorted(later, key=lambda solution: plain(solution.time))


def _agreeing(motions: list[Solution], numbers: "dict[str, Any]", used: tuple[str, ...]) -> list[Solution]:
    """Those that have the fourth and fifth number too, where more than three were given."""
    for name in numbers:
        if name in used:
            continue
        kind = {"time": Time, "distance": Length, "acceleration": Acceleration}.get(name, Speed)
        value = plain(numbers[name])
        near = [solution for solution in motions if _near(solution, name, value)]
        require(
            bool(near),
            "the numbers contradict each other: from {names} the {name} is {value:6}, not {wanted:6}",
            code="inconsistent",
            hint="leave out one of them",
            names=", ".join(WORDS[solution] for solution in used),
            name=WORDS[name],
            value=(plain(getattr(motions[0], name)), kind),
            wanted=(value, kind),
        )
        motions = near
    return motions


def _near(solution: Solution, name: str, wanted: float) -> bool:
    size = abs(wanted)
    if name.endswith("speed"):
        size = max(size, abs(plain(solution.start_speed)), abs(plain(solution.end_speed)))
    return abs(plain(getattr(solution, name)) - wanted) <= AGREEMENT * size


def _open(names: str) -> None:
    require(False, f"these numbers leave {names} open", code="undetermined", hint="give another of the five instead")


def _speeds_acceleration(u: float, v: float, a: float) -> list[Solution]:
    if plain(a) == 0.0:
        if plain(u) == plain(v):
            _open("distance and time")
        require(False, "without acceleration the speed does not change", code="inconsistent")
    t = (v - u) / a
    return [Solution(u, v, a, t * (0.5 * (u + v)), t)]


def _speeds_distance(u: float, v: float, s: float) -> list[Solution]:
    if plain(u + v) == 0.0:
        if plain(s) == 0.0:
            _open("acceleration and time")
        require(
            False,
            "from {u} to {v} with constant acceleration the displacement is zero, not {s}",
            code="inconsistent",
            u=(plain(u), Speed),
            v=(plain(v), Speed),
            s=(plain(s), Length),
        )
    if plain(s) == 0.0:
        require(plain(u) == plain(v), "a change of speed needs a distance above zero", code="inconsistent")
        _open("the acceleration")
    t = 2.0 * s / (u + v)
    return [Solution(u, v, (v - u) * (v + u) / (2.0 * s), s, t)]


def _speeds_time(u: float, v: float, t: float) -> list[Solution]:
    _some_time(t)
    return [Solution(u, v, (v - u) / t, t * (0.5 * (u + v)), t)]


def _some_time(t: float) -> None:
    require(plain(t) > 0.0, "the time is zero: nothing happens", code="no-time", hint="give a time above zero")


def _root(speed: float, a: float, s: float) -> float:
    """The square root of speed² + 2as, by a compensated product; refused where it is not real."""
    square = multiply_add(speed, speed, 2.0 * a * s)
    lost = multiply_add(2.0 * a, s, -(2.0 * a * s))
    square = square + lost
    if plain(square) < -ROUNDING * plain(speed) * plain(speed):
        stop = plain(speed) * plain(speed) / (2.0 * abs(plain(a)))
        backward = plain(s) * plain(a) < 0.0 and plain(speed) * plain(s) < 0.0
        require(
            False,
            "it moves away from there" if backward else "it stops after {stop:6}, {short:3} short of {s:6}",
            code="not-reached",
            hint="check the signs" if backward else "give a shorter distance, more speed or less deceleration",
            stop=(stop, Length),
            short=(abs(plain(s)) - stop, Length),
            s=(abs(plain(s)), Length),
        )
    return sqrt(maximum(square, 0.0 * square))


def _start_acceleration_distance(u: float, a: float, s: float) -> list[Solution]:
    root = _root(u, a, s)
    return [_passage(u, v, a, s) for v in _signs(root) if plain(u + v) != 0.0] or _at_once(u, a, s)


def _end_acceleration_distance(v: float, a: float, s: float) -> list[Solution]:
    root = _root(v, -a, s)
    return [_passage(u, v, a, s) for u in _signs(root) if plain(u + v) != 0.0] or _at_once(v, a, s)


def _signs(root: float) -> tuple[float, ...]:
    return (root, -root) if plain(root) else (root,)


def _passage(u: float, v: float, a: float, s: float) -> Solution:
    # 2s/(u + v) has no digits where both cancel; there (v − u)/a has
    ahead = plain(u) * plain(v) >= 0.0 or plain(a) == 0.0
    return Solution(u, v, a, s, 2.0 * s / (u + v) if ahead else (v - u) / a)


def _at_once(speed: float, a: float, s: float) -> list[Solution]:
    require(plain(s) == 0.0 and plain(a) != 0.0, "at rest without acceleration it does not move", code="not-reached")
    return [Solution(speed, speed, a, s, 0.0 * speed)]


def _start_acceleration_time(u: float, a: float, t: float) -> list[Solution]:
    v = multiply_add(a, t, u)
    return [Solution(u, v, a, t * (u + 0.5 * (a * t)), t)]


def _start_distance_time(u: float, s: float, t: float) -> list[Solution]:
    _some_time(t)
    mean = s / t
    return [Solution(u, 2.0 * mean - u, 2.0 * (mean - u) / t, s, t)]


def _end_acceleration_time(v: float, a: float, t: float) -> list[Solution]:
    u = multiply_add(-a, t, v)
    return [Solution(u, v, a, t * (v - 0.5 * (a * t)), t)]


def _end_distance_time(v: float, s: float, t: float) -> list[Solution]:
    _some_time(t)
    mean = s / t
    return [Solution(2.0 * mean - v, v, 2.0 * (v - mean) / t, s, t)]


def _acceleration_distance_time(a: float, s: float, t: float) -> list[Solution]:
    _some_time(t)
    mean, half = s / t, 0.5 * (a * t)
    return [Solution(mean - half, mean + half, a, s, t)]


_SOLVERS: "dict[tuple[str, ...], Any]" = {
    ("start_speed", "end_speed", "acceleration"): _speeds_acceleration,
    ("start_speed", "end_speed", "distance"): _speeds_distance,
    ("start_speed", "end_speed", "time"): _speeds_time,
    ("start_speed", "acceleration", "distance"): _start_acceleration_distance,
    ("start_speed", "acceleration", "time"): _start_acceleration_time,
    ("start_speed", "distance", "time"): _start_distance_time,
    ("end_speed", "acceleration", "distance"): _end_acceleration_distance,
    ("end_speed", "acceleration", "time"): _end_acceleration_time,
    ("end_speed", "distance", "time"): _end_distance_time,
    ("acceleration", "distance", "time"): _acceleration_distance_time,
}
