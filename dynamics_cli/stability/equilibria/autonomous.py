"""Equilibria of ẋ = f(x) given as formulas: searched by Newton's method, judged by the roots of the exact Jacobian."""

import itertools
import math

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.rational import exact
from dynamics_cli.numerics.roots import bisected
from dynamics_cli.numerics.vectors import eliminated
from dynamics_cli.quantities import (
    Annotated,
    Count,
    Frequency,
    GrowthRate,
    MatrixOfNumbers,
    Ratio,
    Text,
    Variable,
)
from dynamics_cli.records import ErrorBound, record
from dynamics_cli.stability.equilibria.beyond_linear import (
    CENTRE,
    critical_root,
    keeps_area,
    of_one_state,
    weak_focus,
)
from dynamics_cli.stability.equilibria.multiple import distinct
from dynamics_cli.stability.equilibria.rates import Rates, State
from dynamics_cli.stability.matrix import characteristic_of
from dynamics_cli.stability.roots import Root, roots

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from dynamics_cli.stability.equilibria.rates import Point

MOST_STATES, MOST_PLACES = 6, 60
# Newton's method begins at so many places in all, evenly in each range.
STARTS, NEWTON = 700, 100
HALVINGS = 20
# Places nearer than this share of the ranges are one; double ones are found to half the digits only.
APART = 1e-5
# Of one state, what is double is told by its terms.
NEAR = 1e-10
# A rate below this share of the sizes of its Jacobian, and a root below that of the largest, are taken for zero.
ZERO, ON_AXIS = 1e-10, 1e-9
# A place has a bound where that is below this share of its range.
CLOSE = 1e-6
# A root below this share of the slopes is rounding.
NO_ROOT = 1e-20


@record
class StatePlace:
    """One equilibrium of the states."""

    at: Annotated[tuple[Ratio, ...], "The states in their order."]
    verdict: Annotated[Text, "Node, focus, saddle or centre, and whether it is stable."]
    rightmost: Annotated[GrowthRate, "Largest real part of a root: growth, or decay where negative [1/s]."]
    frequency: Annotated[Frequency | None, "Frequency of that root, where it oscillates [Hz]."]
    unstable_directions: Annotated[Count, "Roots on the right [-]."]
    roots: Annotated[tuple[Root, ...], "Roots of the linear terms, the rightmost first; of a pair the upper one."]
    jacobian: Annotated[MatrixOfNumbers, "Slopes of the rates, a row for each state."]


def state_places(states: "tuple[State, ...]", let: "tuple[Variable, ...]") -> "tuple[StatePlace, ...]":
    """The equilibria within the ranges, in order, each with its verdict."""
    require(len(states) <= MOST_STATES, "there are {count} states; {most} are the most", count=str(len(states)),
            most=str(MOST_STATES), code="states")  # fmt: skip
    for state in states:
        require(state.low < state.high, "the range of {name} ends before it begins", name=state.name, code="range")
    rates, ranges = Rates(states, let), [(state.low, state.high) for state in states]
    each = max(int(STARTS ** (1.0 / len(states))), 2)
    # a third of a step off, so that symmetric laws are not begun at their equilibria
    grids = [[low + (k + 1.0 / 3.0) * (high - low) / each for k in range(each)] for low, high in ranges]
    places: list[Point] = []
    starts = _near_zeros(rates, grids[0]) if len(states) == 1 else itertools.product(*grids)
    _search(rates, starts, ranges, places)
    # one that lies between two others, and so close that no start led to it
    pairs = itertools.combinations(tuple(places), 2)
    _search(rates, [tuple(0.5 * (a + b) for a, b in zip(*pair, strict=True)) for pair in pairs], ranges, places)
    require(bool(places), "no equilibrium was found within the ranges", code="no-equilibrium",
            hint="widen low and high, or check the signs; where equilibria form a line, leave out a state")  # fmt: skip
    if len(states) == 1:
        taylor = lambda at, order: rates.along((at,), (1.0,), order)[0]  # noqa: E731
        kept = distinct(taylor, (at for (at,) in places), 0.1 * (ranges[0][1] - ranges[0][0]))
        return tuple(_judged(rates, (at,), ranges, multiplicity) for at, multiplicity in kept)
    points: list[StatePlace] = []
    for point in (_judged(rates, place, ranges, 1) for place in sorted(places)):
        # of several orders, one place may have been found as several
        if not any(point.verdict == other.verdict and _same(point.at, other.at, ranges) for other in points):
            points.append(point)
    return tuple(points)


def _near_zeros(rates: Rates, grid: "list[float]") -> "Iterator[Point]":
    """Starts for one state: zeros between places of a grid by halving, and places where the rate is smallest."""
    values = [rates.at((at,))[0] for at in grid]
    for k, (one, two) in enumerate(itertools.pairwise(values)):
        if (one < 0.0) != (two < 0.0):
            yield (bisected(lambda at: rates.at((at,))[0], grid[k], grid[k + 1], HALVINGS),)
    sizes = [math.inf, *map(abs, values), math.inf]
    for k, at in enumerate(grid, 1):
        if sizes[k] <= min(sizes[k - 1], sizes[k + 1]):
            # from both sides as well: there may be two zeros beside it
            yield from ((near,) for near in (at, *grid[max(k - 2, 0) : k - 1], *grid[k : k + 1]))


def _search(
    rates: Rates, starts: "Iterable[Point]", ranges: "Sequence[tuple[float, float]]", places: "list[Point]"
) -> None:
    """Add the equilibria that starts lead to."""
    for start in starts:
        place = _newton(rates, start, ranges)
        if place is not None and not any(_same(place, other, ranges) for other in places):
            places.append(place)
            require(len(places) <= MOST_PLACES, "there are more than {most} equilibria, or they form a curve",
                    most=str(MOST_PLACES), code="curve", hint="narrow the ranges of the states")  # fmt: skip


def _newton(rates: Rates, place: "Point", ranges: "Sequence[tuple[float, float]]") -> "Point | None":
    """The equilibrium that a start leads to, if one lies within the ranges."""
    for _ in range(NEWTON):
        step = eliminated(*rates.linear(place))
        if step is None:
            return None
        place = tuple(x - d for x, d in zip(place, step, strict=True))
        if not all(map(math.isfinite, place)):
            return None
        if all(abs(d) <= 1e-14 * (high - low) for d, (low, high) in zip(step, ranges, strict=True)):
            break
    place = _cleared(place, ranges)
    inside = all(low - APART * (high - low) <= x <= high + APART * (high - low)
                 for x, (low, high) in zip(place, ranges, strict=True))  # fmt: skip
    slopes, values = rates.linear(place)
    sizes = [sum(abs(slope) * (high - low) for slope, (low, high) in zip(row, ranges, strict=True)) for row in slopes]
    still = all(abs(value) <= ZERO * max(size, 1e-3) for value, size in zip(values, sizes, strict=True))
    return place if inside and still else None


def _same(one: "Point", two: "Point", ranges: "Sequence[tuple[float, float]]") -> bool:
    apart = APART if len(one) > 1 else NEAR
    return all(abs(a - b) <= apart * (high - low) for a, b, (low, high) in zip(one, two, ranges, strict=True))


def _cleared(place: "Point", ranges: "Sequence[tuple[float, float]]") -> "Point":
    """The place with zero for what is rounding beside the ranges."""
    return tuple(0.0 if abs(x) < ZERO * (high - low) else x for x, (low, high) in zip(place, ranges, strict=True))


def place_bounds(
    points: "Sequence[StatePlace]", states: "tuple[State, ...]", let: "tuple[Variable, ...]"
) -> "list[ErrorBound]":
    """How far simple equilibria may lie from where they are said to: twice the step that the rates there would take.

    With |J⁻¹| times the sizes of the rates and of their rounding; one that is not simple has none.
    """
    rates, bounds = Rates(states, let), []
    for nth, point in enumerate(points):
        tracked = rates.tracked(point.at)
        unit = [[float(i == j) for j in range(len(tracked))] for i in range(len(tracked))]
        columns = [eliminated([list(rate.slopes) for rate in tracked], column) for column in unit]
        for k, state in enumerate(states):
            width = 2.0 * sum(abs(column[k]) * (abs(rate.value) + rate.error) if column else math.inf
                              for column, rate in zip(columns, tracked, strict=True))  # fmt: skip
            if width <= CLOSE * (state.high - state.low):
                bounds.append(ErrorBound(f"points[{nth}].at[{k}]", width, relative=False))
    return bounds


def _judged(rates: Rates, place: "Point", ranges: "Sequence[tuple[float, float]]", multiplicity: int) -> StatePlace:
    """The equilibrium with the roots of its linear terms, which are exact of the Jacobian's doubles."""
    slopes = rates.jacobian(place)
    require(all(math.isfinite(x) for row in slopes for x in row), "the rates have no slope at {place}",
            place=", ".join(f"{x:.6g}" for x in place), code="no-slope",
            hint="a corner such as |x| is judged on each side by itself")  # fmt: skip
    found = roots(characteristic_of([[exact(x) for x in row] for row in slopes]))
    largest = max(root.natural for root in found) or 1.0
    steepest = max(abs(slope) for row in slopes for slope in row)
    sides = [0.0 if abs(root.real) <= ON_AXIS * largest else math.copysign(1.0, root.real) for root in found]
    counts = dict.fromkeys((-1.0, 0.0, 1.0), 0)
    for root, side in zip(found, sides, strict=True):
        counts[side] += root.multiplicity * (2 if root.pair else 1)
    leading = found[0]
    at, verdict = _beyond(rates, place, slopes, ranges, counts, leading, multiplicity)
    simple = multiplicity == 1 and at == place
    return StatePlace(
        at=at,
        verdict=verdict or _words(found, sides, counts),
        rightmost=leading.real if simple and abs(leading.real) > NO_ROOT * steepest else 0.0,
        frequency=leading.imaginary / (2.0 * math.pi)
        if leading.pair and leading.natural > NO_ROOT**0.5 * steepest
        else None,
        unstable_directions=counts[1.0],
        roots=found,
        jacobian=tuple(map(tuple, slopes)),
    )


def _beyond(
    rates: Rates,
    place: "Point",
    slopes: "list[list[float]]",
    ranges: "Sequence[tuple[float, float]]",
    counts: "dict[float, int]",
    leading: Root,
    multiplicity: int,
) -> "tuple[Point, str | None]":
    """The place, and the verdict by more than the linear terms where those leave it open and the rest decides."""
    reach = 0.1 * min(high - low for low, high in ranges)
    if len(place) == 1:
        return place, of_one_state(rates, place[0], reach, multiplicity)
    if counts[1.0] or leading.multiplicity > 1 or counts[0.0] != (2 if leading.pair else 1):
        return place, None
    if not leading.pair:
        exact_place, verdict = critical_root(rates, place, slopes, reach)
        return _cleared(exact_place, ranges), verdict
    centre = CENTRE if len(place) == 2 and keeps_area(rates, ranges) else None
    return place, weak_focus(rates, place, slopes) or centre


def _words(found: "Sequence[Root]", sides: "Sequence[float]", counts: "dict[float, int]") -> str:
    """The verdict in the words of the trade."""
    left, axis, right = counts[-1.0], counts[0.0], counts[1.0]
    if right and left:
        name = "saddle-focus" if any(root.pair for root in found) else "saddle"
        return name if left + right == 2 else f"{name}: {right} unstable, {left} stable"
    if right:
        return "unstable" if axis else f"unstable {_shape(found)}"
    if not axis:
        return f"stable {_shape(found)}"
    if any(root.pair for root, side in zip(found, sides, strict=True) if not side):
        return "undecided: a pair on the axis" if left else "undecided: centre of the linear terms"
    return "undecided: a root at zero"


def _shape(found: "Sequence[Root]") -> str:
    """How motions near it look, where all decay or all grow."""
    if len(found) == 1 and found[0].multiplicity == 1 and not found[0].pair:
        return "equilibrium"
    if not any(root.pair for root in found):
        return "node"
    return "focus" if all(root.pair for root in found) else "focus-node"
