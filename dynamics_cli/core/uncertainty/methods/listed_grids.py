"""Grids along the gradient for each of the values that listed inputs may have: a mixture of smooth problems.

An input of listed values (`empirical(…)`) is a step in its score, which no smooth rule can integrate. For each of
its values the other inputs are integrated as usual; all lines of all values are solved together.
"""

import numpy as np

from dynamics_cli.core.inputs.uncertain.distributions import Empirical
from dynamics_cli.core.uncertainty.methods.grids import MOST_LEVEL, TENSOR_COUNTS, rule
from dynamics_cli.core.uncertainty.methods.lines import ORDERS, Lines, moments, order_moments, solve
from dynamics_cli.core.uncertainty.methods.outcome import FLOOR, Goal, Outcome, width_of
from dynamics_cli.core.uncertainty.space import Space, complement
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature import smolyak

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.uncertainty.methods.lines import Steps

    Array = NDArray[Any]

# Values of all listed inputs together, and lines of all of them.
MOST_VALUES, MOST_LINES = 64, 20_000


def _stepped(space: Space) -> "list[int]":
    return [axis for axis, distribution in enumerate(space.distributions) if isinstance(distribution, Empirical)]


def suits(space: Space) -> bool:
    """Whether some inputs are lists of few values, and the others smooth enough and independent of them."""
    axes = _stepped(space)
    count = int(np.prod([space.distributions[axis].values.size for axis in axes]))  # type: ignore[attr-defined]
    return bool(axes) and len(axes) < space.size and count <= MOST_VALUES and space.factor is None and not space.heavy


def listed_grids(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> "Steps[Outcome | None]":
    """Levels of grids until two agree; None where the result does not rise along every line."""
    listed = _stepped(space)
    smooth = [axis for axis in range(space.size) if axis not in listed]
    along = direction[smooth]
    size = float(np.sqrt(along @ along))
    if not size > 1e-6:
        return None
    own = np.zeros(space.size)
    own[smooth] = along / size
    scores = _scores(space, listed)
    best: Outcome | None = None
    before: Outcome | None = None
    for level in range(1, (MOST_LEVEL if len(smooth) > 3 else len(TENSOR_COUNTS)) + 1):
        if len(smooth) > 3 and smolyak.size(len(smooth) - 1, level) * scores.shape[1] > MOST_LINES:
            break
        lines = _lines(space, result, own, smooth, listed, scores, level, goal.accuracy)
        roots = yield from solve(lines, goal.p, goal.scores, goal.tolerance)
        if roots is None or (level == 2 and not (yield from order_moments(lines, ORDERS[1])).rising):
            return None
        outcome = Outcome(f"grids along the gradient for {scores.shape[1]} listed values", roots.quantiles, lines)
        outcome.roots = roots
        if len(smooth) == 1:
            outcome.estimate = FLOOR
        elif before is not None:
            outcome.before = before.lines
            width = width_of(roots.quantiles, goal)
            apart = float(np.abs(roots.quantiles - before.quantiles).max()) / width if width > 0.0 else 0.0
            outcome.estimate = max(1.5 * apart, FLOOR)
        outcome.estimate = max(outcome.estimate, roots.residual)
        best = outcome if best is None or outcome.estimate <= best.estimate else best
        before = outcome
        if outcome.estimate <= goal.accuracy:
            break
    return None if best is None else (yield from _with_moments(best, goal))


def _scores(space: Space, listed: "list[int]") -> "Array":
    """The middle scores of all values (listed, combinations)."""
    middles = []
    for axis in listed:
        count = space.distributions[axis].values.size  # type: ignore[attr-defined]
        middles.append(quantile((np.arange(count) + 0.5) / count))
    return np.array([part.ravel() for part in np.meshgrid(*middles, indexing="ij")])


def _lines(
    space: Space, result: int, own: "Array", smooth: "list[int]", listed: "list[int]", scores: "Array", level: int,
    accuracy: float,
) -> Lines:  # fmt: skip
    if len(smooth) == 1:
        points, weights = np.zeros((0, 1)), np.ones(1)
    else:
        points, weights = rule(len(smooth) - 1, level, accuracy)
    cases = scores.shape[1]
    lines = Lines.__new__(Lines)
    lines.space, lines.result, lines.direction = space, result, own
    lines.rest = np.concatenate([np.tile(points, cases), np.repeat(scores, weights.size, axis=1)])
    lines.base = np.zeros((space.size, weights.size * cases))
    lines.base[smooth] = np.tile(complement(own[smooth]) @ points, cases)
    lines.base[listed] = np.repeat(scores, weights.size, axis=1)
    lines.weights = np.tile(weights, cases) / cases
    return lines


def _with_moments(outcome: Outcome, goal: Goal) -> "Steps[Outcome | None]":
    spread = yield from moments(outcome.lines, goal.accuracy, outcome.before)
    if not spread.rising:
        return None
    outcome.mean, outcome.std = spread.mean, spread.std
    outcome.estimate = max(outcome.estimate, spread.error)
    return outcome
