"""Events along a curve: extremes of speed and curvature, cusps and inflections; and its arc length."""

import math
from heapq import heappush, heapreplace
from itertools import pairwise

from dynamics_cli.numerics.quadrature.gauss import legendre
from dynamics_cli.numerics.roots import bisected
from dynamics_cli.numerics.vectors import cross, dot
from dynamics_cli.quantities import Annotated, Curvature, Position, Speed, Time
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from dynamics_cli.path.curves.moving_point import MovingPoint, State

SAMPLES = 240
MOST_EVENTS = 60
# Below this share of its terms a derivative is rounding.
NOTHING = 1e-9
# A speed or curvature this small relative to the largest is zero.
ZERO = 1e-6
NODES = 12
MOST_HALVINGS = 600
LENGTH = 1e-13


@record
class Event:
    """One thing that happens on the way."""

    event: Annotated[str, "What happens."]
    time: Annotated[Time, "When [s]."]
    speed: Annotated[Speed, "Speed there [m/s]."]
    curvature: Annotated[Curvature | None, "Curvature there [1/m]."]
    position: Annotated[Position, "Where [m]."]


def events(motion: "MovingPoint", start: float, end: float) -> tuple[Event, ...]:
    """Extremes of speed and curvature, cusps and inflections, between samples of their derivatives' signs."""
    times = [start + (end - start) * i / SAMPLES for i in range(SAMPLES + 1)]
    states = [motion.state(time) for time in times]
    fastest = max(state.bend.speed for state in states)
    tightest = max((state.bend.curvature or 0.0 for state in states), default=0.0)
    events_met: list[Event] = []
    for at, rising in _turns(motion, times, states, _speeding):
        state = motion.state(at)
        slow = state.bend.speed <= ZERO * fastest
        events_met.append(_event("cusp or rest" if rising and slow else "slowest" if rising else "fastest", at, state))
    still = [item.time for item in events_met if item.event == "cusp or rest"]
    for at, rising in _turns(motion, times, states, _bending):
        if any(abs(at - time) <= 2.0 * (end - start) / SAMPLES for time in still):
            continue
        state = motion.state(at)
        flat = (state.bend.curvature or 0.0) <= ZERO * tightest
        events_met.append(_event("inflection" if rising and flat else "flattest" if rising else "tightest", at, state))
    return tuple(sorted(events_met, key=lambda item: item.time)[:MOST_EVENTS])


def _event(name: str, time: float, state: "State") -> Event:
    regular = name != "cusp or rest"
    speed = state.bend.speed if regular else 0.0
    curvature = (0.0 if name == "inflection" else state.bend.curvature) if regular else None
    return Event(name, time, speed, curvature, state.position)


def _speeding(state: "State") -> tuple[float, float]:
    """v·a, which has the sign of the rate of the speed, and the size of its terms."""
    v, a = state.velocity, state.acceleration
    return dot(v, a), math.sqrt(dot(v, v) * dot(a, a))


def _bending(state: "State") -> tuple[float, float]:
    """(v×a)·(v×j) v² − 3 (v×a)² v·a, which has the sign of the rate of the curvature, and the size of its terms."""
    v, a, j = state.velocity, state.acceleration, state.jerk
    across, later = cross(v, a), cross(v, j)
    first, second = dot(across, later) * dot(v, v), 3.0 * dot(across, across) * dot(v, a)
    square = dot(v, v)
    return first - second, square * square * math.sqrt(
        dot(a, a) * (dot(j, j) + dot(a, a) * dot(a, a) / (square or 1.0))
    )


def _turns(
    motion: "MovingPoint", times: list[float], states: "list[State]", rate: "Callable[[State], tuple[float, float]]"
) -> list[tuple[float, bool]]:
    """Where a rate changes its sign, and whether from falling to rising."""
    turns = []
    before: tuple[float, float] | None = None
    for time, state in zip(times, states, strict=True):
        value, size = rate(state)
        if abs(value) <= NOTHING * size:
            continue
        if before is not None and (before[1] < 0.0) != (value < 0.0):
            turns.append((bisected(lambda at: rate(motion.state(at))[0], before[0], time), value > 0.0))
        before = time, value
    return turns


def arc_lengths(motion: "MovingPoint", times: list[float]) -> tuple[list[float], float]:
    """Length of the path up to each of the times, and an estimate of the error of the last."""
    total, doubt, out = 0.0, 0.0, [0.0]
    size = (times[-1] - times[0]) * max(map(motion.speed, times))
    for low, high in pairwise(times):
        part, error = _integral(motion.speed, low, high, LENGTH * size, MOST_HALVINGS // (len(times) - 1) + 1)
        total, doubt = total + part, doubt + error
        out.append(total)
    return out, 4.0 * doubt + 1e-15 * total


def _gauss(function: "Callable[[float], float]", low: float, high: float) -> float:
    return (high - low) * math.fsum(weight * function(low + (high - low) * node) for node, weight in _RULE)


def _integral(
    function: "Callable[[float], float]", low: float, high: float, allowed: float, halvings: int
) -> tuple[float, float]:
    """The integral, the piece with the largest error halved again and again, and the sum of the errors."""
    pieces = [_piece(function, low, high, _gauss(function, low, high))]
    for _ in range(halvings):
        error, start, end, _undivided, first_half, right = pieces[0]
        middle = 0.5 * (start + end)
        if math.fsum(-piece[0] for piece in pieces) <= allowed or not start < middle < end or error == 0.0:
            break
        heapreplace(pieces, _piece(function, start, middle, first_half))
        heappush(pieces, _piece(function, middle, end, right))
    return math.fsum(piece[3] for piece in pieces), math.fsum(-piece[0] for piece in pieces)


def _piece(function: "Callable[[float], float]", low: float, high: float, undivided: float) -> tuple[float, ...]:
    """Minus the error of a piece, its ends, its integral, and those of its halves."""
    middle = 0.5 * (low + high)
    first_half, second_half = _gauss(function, low, middle), _gauss(function, middle, high)
    return -abs(first_half + second_half - undivided), low, high, first_half + second_half, first_half, second_half


_RULE = legendre(NODES)
