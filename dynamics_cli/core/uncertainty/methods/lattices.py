"""Quantiles along the gradient on shifted lattices: for kinks, bounded inputs and many inputs."""

import numpy as np

from dynamics_cli.core.uncertainty.methods.lines import (
    ORDERS,
    ORDERS_OF_MANY,
    Lines,
    Moments,
    Roots,
    carry,
    fitted,
    moments,
    order_moments,
    solve,
)
from dynamics_cli.core.uncertainty.methods.outcome import (
    FLOOR,
    REPLICATE_FACTOR,
    SHIFTS,
    Goal,
    Outcome,
    tail_direction,
    width_of,
)
from dynamics_cli.core.uncertainty.space import Space, complement
from dynamics_cli.numerics.distributions.normal_arrays import probability, quantile
from dynamics_cli.numerics.quadrature.lattice import MOST_POINTS, lattice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.uncertainty.methods.lines import Steps

    Array = NDArray[Any]

FIRST_LATTICE = 128


def lattice_lines(space: Space, result: int, direction: "Array", across: "Array", count: int, seed: int) -> Lines:
    """Lines of one weight through lattice points across the direction, replicate after replicate."""
    rest = quantile(lattice(space.size - 1, count, SHIFTS, seed))
    return Lines(space, result, direction, across, rest, np.full(rest.shape[1], 1.0 / rest.shape[1]))


def lattices(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> "Steps[Outcome | None]":
    """Growing lattices until the replicates agree; None when the iteration fails on any line.

    After the first the axes across are turned so that the first of them is the one along which roots shift most: the
    leading coordinates of a lattice are its best.
    """
    if not space.smooth:
        direction = tail_direction(space, result, direction, float(goal.scores[-1]))
        across = complement(direction)
    last: tuple[Lines, Roots] | None = None
    count = FIRST_LATTICE
    while True:
        guess = None
        lines = lattice_lines(space, result, direction, across, count, goal.seed)
        if last is not None:
            turn = _tilt(*last)
            across = across @ turn
            last[0].rest = turn.T @ last[0].rest
            lines = lattice_lines(space, result, direction, across, count, goal.seed)
            guess = carry(_thinned(last[0]), _thin_roots(*last), lines)
        if last is None and not (yield from order_moments(lines, ORDERS[0])).rising:
            return None
        roots = yield from solve(lines, goal.p, goal.scores, goal.tolerance, guess)
        if roots is None:
            return None
        outcome = Outcome(
            f"{SHIFTS} shifted lattices of {count} lines along the gradient", roots.quantiles, lines, groups=SHIFTS
        )
        outcome.roots = roots
        outcome.estimate = max(replicate_estimate(outcome, goal), roots.residual)
        last = (lines, roots)
        grown = larger(count, outcome.estimate / goal.accuracy)
        cost = 4 * SHIFTS * grown * goal.p.size
        most = grown == count or space.points + cost > goal.points
        if outcome.estimate <= goal.accuracy or most:
            done = yield from _lattice_moments(outcome, goal)
            if done is None or done.estimate <= goal.accuracy or most:
                return done
            # moments may need more lines than quantiles
            grown = larger(count, done.estimate / goal.accuracy)
            if grown == count or space.points + 4 * SHIFTS * grown * goal.p.size > goal.points:
                return done
        count = grown


def _tilt(lines: Lines, roots: Roots) -> "Array":
    """A rotation of the axes across whose first axis is the linear tilt of the outer roots."""
    thin, few = _thinned(lines), _thin_roots(lines, roots)
    terms = np.vstack([np.ones(thin.rest.shape[1]), thin.rest])
    slopes = fitted(terms.T, few.s[:, 0] + few.s[:, -1])[1:]
    size = float(np.sqrt(slopes @ slopes))
    if len(slopes) < 2 or size < 1e-9:
        return np.eye(len(slopes))
    return np.column_stack([slopes / size, complement(slopes / size)])


def larger(count: int, ratio: float) -> int:
    """The next lattice: errors fall about as fast as the count grows, or somewhat faster."""
    power = int(np.ceil(np.clip(0.75 * np.log2(max(ratio, 1.0)), 1.0, 4.0)))
    return min(count << power, MOST_POINTS)


def _thin_roots(lines: Lines, roots: Roots) -> Roots:
    part = slice(None, None, max(1, lines.weights.size // 1024))
    return Roots(roots.s[part], roots.quantiles, roots.slopes[part], 0)


def replicate_estimate(outcome: Outcome, goal: Goal) -> float:
    """The scatter of the replicates' probabilities at the common quantiles, over the density."""
    assert outcome.roots is not None
    share = probability(outcome.roots.s).reshape(SHIFTS, -1, goal.p.size).mean(axis=1)
    scatter = share.std(axis=0, ddof=1) / np.sqrt(SHIFTS)
    dense = outcome.roots.density(outcome.lines.weights)
    width = width_of(outcome.quantiles, goal)
    if not width > 0.0:
        return FLOOR
    return max(float((REPLICATE_FACTOR * scatter / dense).max()) / width, FLOOR)


def _lattice_moments(outcome: Outcome | None, goal: Goal) -> "Steps[Outcome | None]":
    if outcome is None:
        return None
    accuracy = max(goal.accuracy, 0.1 * outcome.estimate)
    spread = yield from moments(outcome.lines, accuracy, _thinned(outcome.lines), ORDERS_OF_MANY)
    if not spread.rising:
        return None
    outcome.mean, outcome.std = spread.mean, spread.std
    outcome.estimate = max(outcome.estimate, spread.error, _moment_scatter(spread))
    return outcome


def _moment_scatter(spread: Moments) -> float:
    """The scatter of the replicates' means and deviations, in deviations: σ changes by half of what σ² does."""
    if spread.by_line is None or not spread.std > 0.0:
        return 0.0
    first, second = (part.reshape(SHIFTS, -1).mean(axis=1) for part in spread.by_line)
    apart = max(float(first.std(ddof=1)) / spread.std, float(second.std(ddof=1)) / (2.0 * spread.std * spread.std))
    return REPLICATE_FACTOR * apart / float(np.sqrt(SHIFTS))


def _thinned(lines: Lines) -> Lines:
    """A regular selection of about a thousand lines."""
    thinner = Lines.__new__(Lines)
    part = slice(None, None, max(1, lines.weights.size // 1024))
    thinner.space, thinner.result, thinner.direction = lines.space, lines.result, lines.direction
    thinner.rest, thinner.base = lines.rest[:, part], lines.base[:, part]
    thinner.weights = np.full(thinner.rest.shape[1], 1.0 / thinner.rest.shape[1])
    return thinner
