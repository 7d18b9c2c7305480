"""Grids along the gradient at chosen values of the inputs that are not smooth in their score: smooth problems mixed.

An input of listed values (`empirical(…)`) is a step in its score, and one between bounds has corners there; no smooth
rule integrates either. At each listed value, or each Gauss point between the bounds, the other inputs are integrated
as usual; all lines of all values are solved together.
"""

import math

import numpy as np

from dynamics_cli.core.inputs.uncertain.distributions import Empirical, Tangent, Triangular, Truncated, Uniform
from dynamics_cli.core.uncertainty.methods.grids import KINK, MOST_LEVEL, TENSOR_COUNTS, UNSETTLED, rule
from dynamics_cli.core.uncertainty.methods.lines import ORDERS, Lines, carry, order_moments, solve
from dynamics_cli.core.uncertainty.methods.outcome import FLOOR, Goal, Outcome, width_of
from dynamics_cli.core.uncertainty.space import Space, complement
from dynamics_cli.numerics.distributions.normal_arrays import lower, quantile
from dynamics_cli.numerics.quadrature import smolyak
from dynamics_cli.numerics.quadrature.gauss import legendre

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.inputs.uncertain.distributions import Distribution
    from dynamics_cli.core.uncertainty.methods.lines import Roots, Steps

    Array = NDArray[Any]

# Values of all such inputs together at the first level, and lines of all of them.
MOST_VALUES, MOST_LINES = 64, 20_000
# Gauss points of a panel between bounds, by level.
COUNTS = (3, 4, 6, 8, 12, 16, 20, 24)
# The error of a level as a share of its difference from the one before: at least, where no earlier one shows how they
# settle, and where they settle slowly.
GAIN, FIRST, SLOW = 0.3, 1.0, 1.5


def _listed(space: Space, axis: int) -> bool:
    return isinstance(space.distributions[axis], Empirical)


def _bounded(distribution: "Distribution") -> bool:
    # a tangent is that of an angle, whose scores are its own
    return isinstance(getattr(distribution, "angle", distribution), Uniform | Triangular | Truncated)


def _mixed(space: Space) -> "list[int]":
    """The axes that are not smooth in their score, and can be taken value by value."""
    return [
        axis
        for axis, distribution in enumerate(space.distributions)
        if _listed(space, axis) or (not distribution.smooth and _bounded(distribution))
    ]


def suits(space: Space, bears: "Array | None" = None) -> bool:
    """Whether some inputs that bear on a result are short lists or bounded, and the others smooth and independent."""
    every = [axis for axis in range(space.size) if bears is None or bears[axis]]
    axes = [axis for axis in _mixed(space) if axis in every]
    others = [space.distributions[axis] for axis in every if axis not in axes]
    if not axes or not others or space.factor is not None or space.heavy:
        return False
    # lists are exact, and what is integrated beside them may have corners
    smooth = all(one.smooth for one in others) or all(_listed(space, axis) for axis in axes)
    return smooth and math.prod(weights.size for _, weights in _each(space, axes, COUNTS[0])) <= MOST_VALUES


def _each(space: Space, axes: "list[int]", count: int) -> "Iterator[tuple[Array, Array]]":
    """Scores of the values of each axis, and their weights."""
    for axis in axes:
        distribution = space.distributions[axis]
        if isinstance(distribution, Empirical):
            size = distribution.values.size
            yield quantile((np.arange(size) + 0.5) / size), np.full(size, 1.0 / size)
            continue
        yield _between_bounds(distribution, count)


def _between_bounds(distribution: "Distribution", count: int) -> "tuple[Array, Array]":
    """Scores of Gauss points on the panels between a distribution's bounds and its corners, and their weights."""
    d: Any = distribution.angle if isinstance(distribution, Tangent) else distribution
    inner = [0.5 * (d.low + d.high)]
    if isinstance(d, Triangular):
        inner = [d.mode]
    elif isinstance(d, Truncated):
        steps = (1.5 * d.width, 3.5 * d.width)
        inner = [d.centre, *(d.low + step for step in steps), *(d.high - step for step in steps)]
    cuts = np.array([d.low, *sorted({float(cut) for cut in inner if d.low < cut < d.high}), d.high])
    nodes, weights = (np.array(part) for part in zip(*legendre(count), strict=True))
    t = (cuts[:-1, None] + np.diff(cuts)[:, None] * nodes).ravel()
    below, density = _distribution_function(d, t)
    share = np.outer(np.diff(cuts), weights).ravel() * density
    return quantile(below), share / share.sum()


def _distribution_function(d: "Any", t: "Array") -> "tuple[Array, Array]":
    """The distribution function of a bounded input at its values, and a multiple of its density."""
    if isinstance(d, Uniform):
        return (t - d.low) / (d.high - d.low), np.ones_like(t)
    if isinstance(d, Triangular):
        width, low, high = d.high - d.low, t - d.low, d.high - t
        up, down = max(d.mode - d.low, 1e-300), max(d.high - d.mode, 1e-300)
        rising = t < d.mode
        return (
            np.where(rising, low * low / (width * up), 1.0 - high * high / (width * down)),
            np.where(rising, low / up, high / down),
        )
    score = (t - d.centre) / d.width
    first, last = lower((np.array([d.low, d.high]) - d.centre) / d.width)
    return (lower(score) - first) / (last - first), np.exp(-0.5 * score * score)


def _values(space: Space, axes: "list[int]", count: int) -> "tuple[Array, Array]":
    """Scores (axes, values) of all values together, and their weights."""
    scores, weights = zip(*_each(space, axes, count), strict=True)
    product = np.prod(np.meshgrid(*weights, indexing="ij"), axis=0)
    return np.array([part.ravel() for part in np.meshgrid(*scores, indexing="ij")]), product.ravel()


def mixtures(
    space: Space, result: int, direction: "Array", axes: "Array | None", goal: Goal
) -> "Steps[Outcome | None]":
    """Levels of grids until two agree; None where the result does not rise along every line.

    `axes` are those that bear on the result (None: all).
    """
    bears = np.ones(space.size, dtype=bool) if axes is None else axes
    mixed = [axis for axis in _mixed(space) if bears[axis]]
    smooth = [axis for axis in range(space.size) if bears[axis] and axis not in mixed]
    along = direction[smooth]
    size = float(np.sqrt(along @ along))
    if not size > 1e-6:
        return None
    own = np.zeros(space.size)
    own[smooth] = along / size
    best: Outcome | None = None
    before: Outcome | None = None
    apart = np.inf
    for level in range(1, (MOST_LEVEL if len(smooth) > 3 else len(TENSOR_COUNTS)) + 1):
        lines = _lines(space, result, own, (smooth, mixed), level, goal.accuracy)
        if lines is None:
            break
        guess = None if before is None else _guess(before, lines)
        roots = yield from solve(lines, goal.p, goal.scores, goal.tolerance, guess)
        if roots is None and guess is not None:
            roots = yield from solve(lines, goal.p, goal.scores, goal.tolerance)
        if roots is None or (level == 1 and not (yield from order_moments(lines, ORDERS[1])).rising):
            return None
        values = np.unique(lines.base[mixed], axis=1).shape[1]
        method = f"grids along the gradient for {values} listed or bounded values, {lines.weights.size} lines"
        outcome = Outcome(method, roots.quantiles, lines)
        outcome.roots = roots
        if before is not None:
            outcome.before = before.lines
            width, last = width_of(roots.quantiles, goal), apart
            apart = float(np.abs(roots.quantiles - before.quantiles).max()) / width if width > 0.0 else 0.0
            settling = max(GAIN, min(UNSETTLED * apart / last, SLOW)) if last < np.inf else FIRST
            part = UNSETTLED if apart > KINK else settling
            outcome.estimate = max(part * apart, FLOOR)
        elif len(smooth) == 1 and all(_listed(space, axis) for axis in mixed):
            outcome.estimate = FLOOR
        outcome.estimate = max(outcome.estimate, roots.residual)
        best = outcome if best is None or outcome.estimate <= best.estimate else best
        before = outcome
        if outcome.estimate <= goal.accuracy or KINK < apart < np.inf:
            break
    return None if best is None else (yield from _with_moments(best))


def _lines(
    space: Space, result: int, own: "Array", axes: "tuple[list[int], list[int]]", level: int, accuracy: float
) -> Lines | None:
    """The lines of a level; None where they are too many."""
    smooth, mixed = axes
    scores, shares = _values(space, mixed, COUNTS[level - 1])
    if len(smooth) == 1:
        points, weights = np.zeros((0, 1)), np.ones(1)
    elif level > 1 and len(smooth) > 3 and smolyak.size(len(smooth) - 1, level) * shares.size > MOST_LINES:
        return None
    else:
        points, weights = rule(len(smooth) - 1, level, accuracy)
    lines = Lines.__new__(Lines)
    lines.space, lines.result, lines.direction = space, result, own
    lines.rest = np.concatenate([np.tile(points, shares.size), np.repeat(scores, weights.size, axis=1)])
    lines.base = np.zeros((space.size, lines.rest.shape[1]))
    lines.base[smooth] = np.tile(complement(own[smooth]) @ points, shares.size)
    lines.base[mixed] = np.repeat(scores, weights.size, axis=1)
    lines.weights = np.outer(shares, weights).ravel()
    return lines


def _guess(before: Outcome, lines: Lines) -> "tuple[Array, Array]":
    roots: Roots | None = before.roots
    assert roots is not None
    return carry(before.lines, roots, lines)


def _with_moments(outcome: Outcome) -> "Steps[Outcome | None]":
    spread = yield from order_moments(outcome.lines, ORDERS[1])
    if not spread.rising:
        return None
    outcome.mean, outcome.std = spread.mean, spread.std
    if outcome.before is not None and spread.std > 0.0:
        apart = 0.0
        for order in ORDERS[:2]:
            other = yield from order_moments(outcome.before, order)
            apart = max(abs(other.mean - spread.mean), abs(other.std - spread.std), apart)
        outcome.estimate = max(outcome.estimate, GAIN * apart / spread.std)
    return outcome
