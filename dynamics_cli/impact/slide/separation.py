"""The motion at the separation as a function of where and how a car came to rest, for every kind of number.

Friction scales speeds by its root and leaves places alone, and a scene may be turned: what is left is a function of
three numbers, the distance to rest, the nose beside the way to it, and the turn. A single number is solved for as it
stands, and its derivatives come from the solved equations. Thousands of samples go through the second-order expansion
about a point of a fixed grid near their middle, which is solved for once.
"""

from functools import lru_cache

from dynamics_cli.impact.slide.back import Target, roots
from dynamics_cli.impact.slide.motion import TOLERANCE, run
from dynamics_cli.impact.slide.wheels import Car, State, Wheel
from dynamics_cli.numerics.elementary import atan2, cos, hypot, maximum, only_in_doubles, sin, sqrt
from dynamics_cli.numerics.number import is_array, is_tracked, plain
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Three = tuple[float, float, float]
    Body = tuple[float, ...]

# Grid of the points that samples are expanded about, and differences: of distance, nose beside the way, turn. The
# differences are about as wide as such measurements are uncertain, so that the corner where a wheel stands is rounded.
GRID = (1.0, 0.1, 0.1)
STEPS = (0.5, 0.08, 0.25)
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


def separation(body: "Body", distance: float, beside: float, turn: float) -> "Three":
    """Speed, course from the straight line to rest, and spin, where friction times gravity is one.

    `beside` is the angle from the nose at the separation to the straight line to rest.
    """
    only_in_doubles(*body, distance, beside, turn)
    numbers = (distance, beside, turn)
    if any(is_array(part) for part in (*body, *numbers)):
        if not drawing() or any(is_array(part) for part in body):
            raise TypeError("a slide is solved one by one")
        return _expanded(body, numbers)
    single: Any = tuple(float(plain(part)) for part in (*body, *numbers))
    solved = _solved(single[:-3], *single[-3:])
    if not any(is_tracked(part) for part in (*body, *numbers)):
        return solved
    return _tracked(solved, (*body, *numbers), single)


@lru_cache(maxsize=64)
def _solved(body: "Body", distance: float, beside: float, turn: float) -> "Three":
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


def _expanded(body: "Body", numbers: "tuple[Any, Any, Any]") -> "Three":
    """The expansion at samples, about the grid's point nearest to their middle."""
    import numpy as np

    distance, beside, turn = numbers
    middle = atan2(float(np.mean(sin(beside))), float(np.mean(cos(beside))))
    centres = [
        grid * max(round(float(value) / grid), least)
        for value, grid, least in zip(
            (np.median(distance), middle, np.median(turn)), GRID, (1, -1000, -1000), strict=True
        )
    ]
    coefficients = _coefficients(tuple(float(part) for part in body), *centres)
    off = beside - centres[1]
    moved = distance - centres[0], atan2(sin(off), cos(off)), turn - centres[2]
    made = []
    for constant, slopes, curves in coefficients:
        total: Any = constant
        for i in range(3):
            total = total + slopes[i] * moved[i]
            for j in range(i + 1):
                total = total + curves[i][j] * (moved[i] * moved[j])
        made.append(total)
    return maximum(made[0], 0.0) * sqrt(distance), made[1], made[2]


@lru_cache(maxsize=64)
def _coefficients(body: "Body", *centre: float) -> "tuple[Any, ...]":
    """Value, slopes and half curvatures of speed over the root of the distance, course and spin."""

    def at(*moves: int) -> "Three":
        place = [value + step * move for value, step, move in zip(centre, STEPS, moves, strict=True)]
        place[0] = max(place[0], 0.1)
        speed, course, spin = _solved(body, *place)
        return speed / sqrt(place[0]), course, spin

    middle = at(0, 0, 0)
    ends: dict[tuple[int, int], Three] = {}
    for i in range(3):
        for sign in (1, -1):
            ends[i, sign] = at(*(sign if k == i else 0 for k in range(3)))
    made = []
    for result in range(3):
        slopes = [(ends[i, 1][result] - ends[i, -1][result]) / (2.0 * STEPS[i]) for i in range(3)]
        curves = [[0.0] * 3 for _ in range(3)]
        for i in range(3):
            bend = ends[i, 1][result] - 2.0 * middle[result] + ends[i, -1][result]
            curves[i][i] = 0.5 * bend / (STEPS[i] * STEPS[i])
        made.append((middle[result], slopes, curves))
    for i in range(3):
        for j in range(i):
            both = at(*(1 if k in (i, j) else 0 for k in range(3)))
            for result, (constant, slopes, curves) in enumerate(made):
                straight = constant + slopes[i] * STEPS[i] + slopes[j] * STEPS[j]
                curved = curves[i][i] * STEPS[i] * STEPS[i] + curves[j][j] * STEPS[j] * STEPS[j]
                curves[i][j] = (both[result] - straight - curved) / (STEPS[i] * STEPS[j])
    return tuple(made)
