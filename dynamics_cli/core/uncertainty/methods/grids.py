"""Quantiles along the gradient on tensor Gauss–Hermite and Smolyak grids: for models that increase along every line."""

import numpy as np

from dynamics_cli.core.uncertainty.methods.lines import ORDERS, Lines, Roots, carry, moments, order_moments, solve
from dynamics_cli.core.uncertainty.methods.outcome import FLOOR, Goal, Outcome, width_of
from dynamics_cli.core.uncertainty.space import Space
from dynamics_cli.numerics.quadrature import smolyak
from dynamics_cli.numerics.quadrature.hermite import gauss_hermite, tensor

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.uncertainty.methods.lines import Steps

    Array = NDArray[Any]

TENSOR_COUNTS = (3, 5, 8, 12, 18, 27, 40, 60)
# A level whose change is less than this share of the change before is converging.
CONVERGING = 0.2
# A difference of two levels, in deviations, that no further one would settle.
KINK = 0.1
# Levels that settle no further than this, in deviations, meet a kink and may be off by a multiple of their difference.
KINKED, UNSETTLED = 1e-3, 3.0
MOST_LEVEL = 4
MOST_GRID_LINES = 12_000
# More lines than this are not tried unless the previous level suggests that they will suffice.
MANY_LINES = 2_000
_rules: "dict[tuple[int, int, int], tuple[Array, Array]]" = {}


def rule(rest: int, level: int, accuracy: float) -> "tuple[Array, Array]":
    """Points and weights across the direction; tensor points of no weight are left out."""
    if rest > 2:
        return smolyak.smolyak(rest, level)
    power = max(-15, int(np.floor(np.log10(accuracy))) - 4)
    key = (rest, level, power)
    if key not in _rules:
        points, weights = tensor(*gauss_hermite(TENSOR_COUNTS[level - 1]), rest)
        order = np.argsort(weights)
        light = order[np.cumsum(weights[order]) <= 10.0**power]
        kept = np.setdiff1d(np.arange(weights.size), light)
        _rules[key] = points[:, kept], weights[kept] / weights[kept].sum()
    return _rules[key]


def _levels(rest: int) -> "list[int]":
    if rest <= 2:
        return list(range(1, len(TENSOR_COUNTS) + 1))
    levels = [level for level in range(1, MOST_LEVEL + 1) if smolyak.size(rest, level) <= MOST_GRID_LINES]
    # of many inputs a star of lines alone is within reach, beside its centre
    return [0, 1] if levels == [1] else levels


def grids(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> "Steps[Outcome | None]":
    """Levels of tensor or sparse grids until two agree; None when the model is not monotone along the lines."""
    rest = across.shape[1]
    name = "tensor Gauss–Hermite" if rest <= 2 else "Smolyak"
    own, factor = (1.0, 0.03) if space.smooth else (1.5, 0.5)
    best: Outcome | None = None
    differences: list[float] = []
    last: tuple[Lines, Roots, tuple[int, int, int]] | None = None
    levels = _levels(rest)
    for level in levels:
        lines = Lines(space, result, direction, across, *rule(rest, level, goal.accuracy))
        shape = (rest, level, lines.weights.size)
        guess = carry(last[0], last[1], lines, (last[2], shape)) if last else None
        roots = yield from solve(lines, goal.p, goal.scores, goal.tolerance, guess)
        if roots is None and guess is not None:
            roots = yield from solve(lines, goal.p, goal.scores, goal.tolerance)
        if roots is None or (level == 2 and not (yield from order_moments(lines, ORDERS[1])).rising):
            # Far lines of a finer grid that turn or leave the admissible region would bias a coarser one: start again.
            return None
        outcome = Outcome(f"{name} along the gradient, {lines.weights.size} lines", roots.quantiles, lines)
        outcome.roots = roots
        if last is not None:
            width = width_of(roots.quantiles, goal)
            differences.append(float(np.abs(roots.quantiles - last[1].quantiles).max()) / width if width > 0.0 else 0.0)
            outcome.before = last[0]
            now = differences[-1]
            outcome.estimate = max(own * now, factor * differences[-2] if len(differences) > 1 else np.inf, FLOOR)
            if len(differences) == 1 and now < 1e-3 * goal.accuracy:
                outcome.estimate = max(30.0 * now, FLOOR)
            elif levels == [0, 1]:
                outcome.estimate = max(own * now, FLOOR)
            outcome.estimate = max(outcome.estimate, roots.residual)
        if best is None or outcome.estimate <= best.estimate:
            best = outcome
        last = (lines, roots, shape)
        if (
            outcome.estimate <= goal.accuracy
            or _stalled(differences, rest)
            or _hopeless(space, rest, level, differences, goal)
        ):
            break
    return (yield from _with_moments(best, goal))


def _stalled(differences: "list[float]", rest: int) -> bool:
    """Whether a kink or a bounded input keeps the levels from converging."""
    if rest <= 2:
        return len(differences) >= 4 and differences[-1] > 0.7 * differences[-2]
    if len(differences) == 1:
        return differences[-1] > KINK
    return len(differences) >= 2 and differences[-1] > CONVERGING * differences[-2]


def _hopeless(space: Space, rest: int, level: int, differences: "list[float]", goal: Goal) -> bool:
    """Whether the next sparse grid would be large and still, because of bounded inputs, not good enough."""
    if rest <= 2 or space.smooth or not differences:
        return False
    return CONVERGING * differences[-1] > goal.accuracy and smolyak.size(rest, level + 1) > MANY_LINES


def _with_moments(outcome: Outcome | None, goal: Goal) -> "Steps[Outcome | None]":
    """Mean and deviation on the lines; None when the values along them do not increase."""
    if outcome is None:
        return None
    spread = yield from moments(outcome.lines, goal.accuracy, outcome.before)
    if not spread.rising:
        return None
    outcome.mean, outcome.std = spread.mean, spread.std
    error = spread.error
    if outcome.before is not None and spread.std > 0.0:
        before = yield from order_moments(outcome.before, spread.order)
        apart = max(abs(before.mean - spread.mean), abs(before.std - spread.std)) / spread.std
        error = max(error, apart if outcome.estimate > goal.accuracy else min(apart, 0.3 * apart + goal.accuracy))
    outcome.estimate = max(outcome.estimate, error)
    if outcome.estimate > KINKED:
        outcome.estimate *= UNSETTLED
    return outcome
