"""Quantiles, moments and probabilities of one result by integration along its gradient, with an estimate of the error.

Rules across the direction, in order: tensor Gauss–Hermite (at most two axes) or Smolyak grids; when these do not settle
(kinks, bounded inputs), shifted lattices; when the model turns, jumps or is partly inadmissible, scanned lines. Errors
are in standard deviations of the result. The factors of the estimates were fitted on thousands of random problems so
that the true error stays below them; plain differences of levels or replicates do not achieve that.
"""

import numpy as np

from dynamics_cli.core.uncertain.goal import Goal, Outcome
from dynamics_cli.core.uncertain.grids import grids
from dynamics_cli.core.uncertain.lattices import lattices
from dynamics_cli.core.uncertain.lines import Lines
from dynamics_cli.core.uncertain.nested import nested, suits
from dynamics_cli.core.uncertain.scanned import alone, scanned
from dynamics_cli.core.uncertain.space import Space, complement
from dynamics_cli.numerics.lattice import MOST_DIMENSIONS

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
    if asked == "auto" and suits(space, goal):
        made = _nested(space, result, direction, across, goal)
        if made is not None and made.estimate <= goal.accuracy:
            return made
    best: Outcome | None = None
    if asked != "lattice" and not space.stepped:
        best = grids(space, result, direction, across, goal)
        if best is not None and (best.estimate <= goal.accuracy or asked == "quadrature"):
            return best
    if space.size - 1 <= MOST_DIMENSIONS:
        if not space.stepped:
            other = lattices(space, result, direction, across, goal)
            if other is not None and (best is None or other.estimate < best.estimate):
                best = other
        if best is None:
            best = scanned(space, result, direction, across, goal)
    assert best is not None
    return best


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
