"""Quantiles from one sample for all results: for many results that turn, jump or have kinks, each in its own way.

Replicates of a shifted lattice; each number is taken over all points together, its error from the scatter of the
replicates.
"""

import numpy as np

from dynamics_cli.core.uncertainty.methods.lines import Lines
from dynamics_cli.core.uncertainty.methods.outcome import (
    DEFAULT_POINTS,
    FLOOR,
    REPLICATE_FACTOR,
    SHIFTS,
    Goal,
    Outcome,
    width_of,
)
from dynamics_cli.core.uncertainty.methods.scanned_lines import Listed
from dynamics_cli.core.uncertainty.methods.shared_lines import principal
from dynamics_cli.core.uncertainty.space import Space
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS, MOST_POINTS, lattice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# The values of all results are kept: so many bytes and replicates, and in proportion more where more points are asked.
MOST_BYTES = 100_000_000
MOST_SHIFTS = 4 * SHIFTS
MOST_TIMES = 10.0
FEWEST_POINTS = 64
# Points that whole numbers are counted at: a share of the cases is then known to about a thousandth.
COUNTED = 1 << 15
# Points of a single input of a model that is called case by case: they lie evenly, so few do.
SINGLE = 1 << 10


class Pool:
    """Values of every result (results, replicates, points) at the points of a lattice, evaluated once."""

    def __init__(self, space: Space, goal: Goal, points: int = 0) -> None:
        results = len(space.results)
        # Where every point is a call of its own, a quarter of them serves all results.
        most = points or (goal.points // 4 if space.slow else goal.points)
        self.count = min(max(1 << max(most // SHIFTS, 1).bit_length() - 1, FEWEST_POINTS), MOST_POINTS)
        more = min(max(most / DEFAULT_POINTS, 1.0), MOST_TIMES)
        room = int(min(MOST_BYTES // (8 * results * self.count), MOST_SHIFTS) * more)
        # Shared lines have left only a few results inaccurate.
        self.shifts = SHIFTS if space.slow or space.shared or points else max(min(most // self.count, room), SHIFTS)
        total = self.shifts * self.count
        if space.size <= MOST_DIMENSIONS:
            uniform = lattice(space.size, self.count, self.shifts, goal.seed)
        else:
            uniform = np.random.default_rng(goal.seed).random((space.size, total))
        self._rows = {row: place for place, row in enumerate(space.rest())}
        self._values = space.some(principal(space, np.eye(space.size)) @ quantile(uniform), list(self._rows)).reshape(
            -1, self.shifts, self.count
        )

    def outcome(self, result: int, goal: Goal, centre: Lines) -> Outcome:
        """One result's quantiles, mean and deviation."""
        values = self._values[self._rows[result]]
        good = ~np.isnan(values)
        counts = good.sum(axis=1)
        if counts.min() < 2:
            message = "almost no case within the inputs' uncertainty is admissible"
            raise InadmissibleError(message, code="inadmissible", hint="check the inputs")
        whole = bool(good.all())
        sound = values.ravel() if whole else values[good]
        method = f"{self.shifts} shifted lattices of {self.count} points, one sample for all results"
        outcome = Outcome(method, np.quantile(sound, goal.p), centre)
        outcome.admissible = float(counts.sum() / values.size)
        outcome.scan = Listed(sound)  # type: ignore[assignment]
        find = np.quantile if whole else np.nanquantile
        scatter = list(find(values, goal.p, axis=1).std(axis=1, ddof=1))
        width = width_of(outcome.quantiles, goal)
        if not centre.space.heavy:
            outcome.mean, outcome.std = float(sound.mean()), float(sound.std())
            width = outcome.std
            apart = values - outcome.mean
            scatter += [np.nanmean(apart, axis=1).std(ddof=1), np.sqrt(np.nanmean(apart**2, axis=1)).std(ddof=1)]
        error = REPLICATE_FACTOR * max(scatter) / float(np.sqrt(self.shifts))
        outcome.estimate = max(float(error) / width, FLOOR) if width > 0.0 else FLOOR
        return outcome


def counted(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome:
    """A whole number or a label by counting: the sample that results share if there is one, else a smaller one."""
    if space.pool is not None:
        return pooled(space, result, direction, across, goal)
    if space.few is None:
        space.few = Pool(space, goal, COUNTED)
    centre = Lines(space, result, direction, across, np.zeros((space.size - 1, 1)), np.ones(1))
    few: Pool = space.few
    return few.outcome(result, goal, centre)


def pooled(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome:
    """One result from the sample that all of them share, generated when first needed."""
    if space.pool is None:
        space.pool = Pool(space, goal, SINGLE if space.slow and space.size == 1 else 0)
    pool: Pool = space.pool
    centre = Lines(space, result, direction, across, np.zeros((space.size - 1, 1)), np.ones(1))
    return pool.outcome(result, goal, centre)
