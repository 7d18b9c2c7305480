"""Quantiles, moments and probabilities of one result by integration along its gradient, with an estimate of the error.

Rules across the direction, in order: tensor Gauss–Hermite (at most two axes) or Smolyak grids; when these do not settle
(kinks, bounded inputs), shifted lattices; when the model turns, jumps or is partly inadmissible, scanned lines; where
that would be dear, for many results or calls one by one, a sample that all results share (`pooled`). Errors are in
standard deviations of the result. The factors of the estimates were fitted on thousands of random problems so that the
true error stays below them; plain differences of levels or replicates do not achieve that.
"""

import numpy as np

from dynamics_cli.core.uncertainty.methods.grids import grids
from dynamics_cli.core.uncertainty.methods.lattices import lattices
from dynamics_cli.core.uncertainty.methods.lines import Lines
from dynamics_cli.core.uncertainty.methods.nested import nested, suits
from dynamics_cli.core.uncertainty.methods.outcome import FAIR, GOOD, Goal, Outcome
from dynamics_cli.core.uncertainty.methods.pooled import pooled
from dynamics_cli.core.uncertainty.methods.scanned_lines import alone, scanned, scanned_grids
from dynamics_cli.core.uncertainty.space import Space, complement
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS

# Of more results than this, those that turn, jump or have kinks share one sample.
FEW_RESULTS = 4
# Grids of scanned lines are for so many inputs at the most.
FEW_INPUTS = 3

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]


def integrate(space: Space, result: int, direction: "Array", goal: Goal, asked: str) -> Outcome:
    """The best outcome for one result within the goal's points."""
    if space.size == 1:
        return alone(space, result, direction, goal)
    across = complement(direction)
    own = goal.own(space)
    if asked == "auto" and suits(space, own):
        made = _nested(space, result, direction, across, own)
        if made is not None and made.estimate <= own.accuracy:
            return made
    best: Outcome | None = None
    if asked != "lattice" and not space.stepped:
        best = grids(space, result, direction, across, own)
        if best is not None and (best.estimate <= own.accuracy or asked == "quadrature"):
            return best
    several = len(space.results) > FEW_RESULTS
    dear = several and space.slow
    narrow = space.size <= MOST_DIMENSIONS
    if narrow and not space.stepped and not dear:
        best = _better(best, lattices(space, result, direction, across, own))
    if several and _poor(best, GOOD):
        best = _better(best, pooled(space, result, direction, across, goal))
    if _poor(best, GOOD) and space.size <= FEW_INPUTS and not space.stepped and not dear:
        best = _better(best, scanned_grids(space, result, direction, across, own))
    if _poor(best, FAIR) and narrow and not dear:
        best = _better(best, scanned(space, result, direction, across, own))
    if _poor(best, GOOD) and not several:
        best = _better(best, pooled(space, result, direction, across, goal))
    assert best is not None
    return best


def _poor(best: Outcome | None, limit: float) -> bool:
    return best is None or best.estimate > limit


def _better(one: Outcome | None, other: Outcome | None) -> Outcome | None:
    if one is None or other is None:
        return one or other
    return other if other.estimate < one.estimate else one


def _nested(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome | None:
    found = nested(space, result, goal)
    if found is None:
        return None
    centre = Lines(space, result, direction, across, np.zeros((space.size - 1, 1)), np.ones(1))
    made = Outcome("nested integrals, cut at the corners of the densities", found.quantiles, centre)
    made.scan = found  # type: ignore[assignment]
    made.mean, made.std = found.mean, found.std
    made.estimate, made.admissible = found.estimate, found.admissible
    return made
