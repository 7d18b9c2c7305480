"""The motion at the separation as a function of where and how a car came to rest, for every kind of number.

Friction scales speeds by its root and leaves places alone, and a scene may be turned: what is left is a function of
three numbers, the distance to rest, the nose beside the way to it, and the turn. A single number is solved for as it
stands, and its derivatives come from the solved equations. Thousands of samples are interpolated on a grid over their
spread, which is solved for once.
"""

from functools import lru_cache

from dynamics_cli.errors import require
from dynamics_cli.impact.slide.back import Target, roots
from dynamics_cli.impact.slide.motion import TOLERANCE, run
from dynamics_cli.impact.slide.wheels import Car, State, Wheel
from dynamics_cli.numerics.elementary import atan2, cos, hypot, only_in_doubles, sin
from dynamics_cli.numerics.number import is_array, is_tracked, plain
from dynamics_cli.sampling import drawing, kept, missed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Three = tuple[float, float, float]
    Body = tuple[float, ...]

# Fewer samples than this are solved one by one.
FEWEST = 32
# What the solved motion is off by, of itself.
SOLVED = 1e-6
DIFFERENCE = 1e-4


def car(body: "Body") -> Car:
    """A car on a road of friction one and gravity one: front and rear axle, track, gyration, slope, shares."""
    ahead, behind, track, gyration, slope, *shares = body
    base = ahead + behind
    wheels = [
        Wheel(place, side * 0.5 * track, 0.5 * (base - abs(place)) / base, share, slope, 0.0)
        for (place, side), share in zip(
            ((ahead, 1.0), (ahead, -1.0), (-behind, 1.0), (-behind, -1.0)), shares, strict=True
        )
    ]
    return Car(wheels, gyration, 1.0, 1.0, [])


def separation(body: "Body", distance: float, beside: float, turn: float, whose: str = "") -> "Three":
    """Speed, course from the straight line to rest, and spin, where friction times gravity is one.

    `beside` is the angle from the nose at the separation to the straight line to rest; `whose` slide it is tells those
    of one calculation apart.
    """
    only_in_doubles(*body, distance, beside, turn)
    numbers = (distance, beside, turn)
    if any(is_array(part) for part in (*body, *numbers)):
        if not drawing():
            raise TypeError("a slide is solved one by one")
        return _sampled(body, numbers, whose)
    single: Any = tuple(float(plain(part)) for part in (*body, *numbers))
    solved = _solved(single[:-3], *single[-3:])
    if not any(is_tracked(part) for part in (*body, *numbers)):
        return solved
    return _tracked(solved, (*body, *numbers), single)


def _solved(body: "Body", distance: float, beside: float, turn: float) -> "Three":
    # samples start from the motions of earlier ones: what they end at, to the last digit, is of no use elsewhere
    return (_nearest if drawing() else _alone)(body, distance, beside, turn)


@lru_cache(maxsize=64)
def _alone(body: "Body", distance: float, beside: float, turn: float) -> "Three":
    return _nearest(body, distance, beside, turn)


def _nearest(body: "Body", distance: float, beside: float, turn: float) -> "Three":
    root = roots(car(body), Target((0.0, 0.0), -beside, (distance, 0.0), turn - beside))[0]
    return hypot(*root.velocity), atan2(root.velocity[1], root.velocity[0]), root.spin


def _tracked(solved: "Three", given: "tuple[Any, ...]", single: "tuple[float, ...]") -> "Three":
    """The solved motion with derivatives by whatever is tracked, from the equations that it solves."""
    import numpy as np

    speed, course, spin = solved
    at = [speed * cos(course), speed * sin(course), spin]
    centre = np.array(_rest(single, at))
    matrix = np.array([(np.array(_rest(single, _moved(at, index))) - centre) / DIFFERENCE for index in range(3)]).T
    slopes = []
    for index, part in enumerate(given):
        if not is_tracked(part) or not any(part.slopes):
            slopes.append(np.zeros(3))
            continue
        # shares stay between rolling and locked
        sign = -1.0 if 5 <= index < 9 and single[index] > 0.5 else 1.0
        there = np.array(_rest(tuple(_moved(list(single), index, sign)), at))
        slopes.append(-np.linalg.solve(matrix, (there - centre) / (sign * DIFFERENCE)))
    first = next(part for part in given if is_tracked(part))
    columns = np.array(slopes)
    x, y = at[0], at[1]
    ways = (
        (columns[:, 0] * x + columns[:, 1] * y) / speed,
        (columns[:, 1] * x - columns[:, 0] * y) / (speed * speed),
        columns[:, 2],
    )
    count = len(first.slopes)
    made = []
    for value, way in zip(solved, ways, strict=True):
        total = [0.0] * count
        error = SOLVED * (abs(value) + 1e-3)
        for part, slope in zip(given, way.tolist(), strict=True):
            if is_tracked(part):
                total = [a + slope * b for a, b in zip(total, part.slopes, strict=True)]
                error += abs(slope) * part.error
        made.append(type(first)(value, error, tuple(total)))
    return made[0], made[1], made[2]


def _moved(numbers: "list[float]", index: int, sign: float = 1.0) -> "list[float]":
    return [*numbers[:index], numbers[index] + sign * DIFFERENCE, *numbers[index + 1 :]]


def _rest(single: "tuple[float, ...]", motion: "list[float]") -> "Three":
    """Where a motion ends less where it should: along the way, across it, and the nose."""
    *body, distance, beside, turn = single
    end = run(car(tuple(body)), State(0.0, 0.0, -beside, *motion), TOLERANCE).end
    return end.x - distance, end.y, end.nose - (turn - beside)


def _sampled(body: "tuple[Any, ...]", numbers: "tuple[Any, Any, Any]", whose: str) -> "Three":
    """The motion at samples: from a grid over their spread, which is solved for once in a calculation."""
    import numpy as np

    from dynamics_cli.impact.slide.spread import GYRATION, Spread

    kind = type(next(part for part in (*body, *numbers) if is_array(part)))
    *several, distance, beside, turn = (np.asarray(part) for part in np.broadcast_arrays(*body, *numbers))
    bodies = np.array(several)
    key = (Spread, whose)
    if distance.size < FEWEST and key not in kept():
        rows = zip(bodies.T.tolist(), distance.tolist(), beside.tolist(), turn.tolist(), strict=True)
        singles = np.array([_solved(tuple(one), *others) for one, *others in rows])
        return tuple(part.view(kind) for part in singles.T.copy())
    scale = kept()[key].scale if key in kept() else float(bodies[GYRATION].mean())
    places = np.array([distance * np.cos(beside), distance * np.sin(beside), scale * turn])
    if key not in kept():
        kept()[key] = Spread(car, bodies, places)
        missed(kept()[key].missed)
    motions, reached = kept()[key].at(bodies, places)
    require(reached, "no slide of these wheels ends there", code="unreachable")
    ahead, left, spin = (part.view(kind) for part in motions)
    bend = atan2(places[0] * left - places[1] * ahead, places[0] * ahead + places[1] * left)
    return hypot(ahead, left), bend, spin
