"""The goal of a propagation, its outcome, and the direction of integration."""

from copy import copy

import numpy as np

from dynamics_cli.core.uncertainty.methods.lines import Lines, Roots
from dynamics_cli.core.uncertainty.space import Space
from dynamics_cli.numerics.distributions import normal
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS, lattice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.uncertainty.methods.scan import Scan

    Array = NDArray[Any]

SHIFTS = 8
# Student's 97.5 % quantile with seven degrees of freedom, nearly tripled: five numbers must hold at once, replicates
# are few and not quite normal, and a common kink biases all of them.
REPLICATE_FACTOR = 2.8 * 2.365
FLOOR = 1e-13
# Errors in standard deviations: below the first no other method is needed; below the second no expensive one and no
# warning.
GOOD = 5e-3
FAIR = 0.02
# Default number of model evaluations: about a second of a formula's time.
DEFAULT_POINTS = 3_000_000
# With more results than this each still gets this part of the points: most need few.
MOST_PARTS = 8


# Probabilities closer than this are equal.
SAME = 1e-9


class Goal:
    """The goal for every result: probabilities of the quantiles, accuracy, maximum number of points, a curve."""

    def __init__(
        self, p: "Array", scores: "Array", accuracy: float, points: int, seed: int, *, curve: bool = False
    ) -> None:
        self.p = p
        self.scores = scores
        self.accuracy = accuracy
        self.points = points
        self.seed = seed
        self.curve = curve
        # Limits whose exceedance is requested, probabilities whose quantiles are, and those of `p` that every result
        # has.
        self.limits: Sequence[float] = ()
        self.levels: Sequence[float] = ()
        self.main = np.arange(p.size)

    def asking(self, limits: "Sequence[float]", levels: "Sequence[float]", *, curve: bool) -> "Goal":
        """The goal of one result with further requests."""
        goal = copy(self)
        goal.limits, goal.levels, goal.curve = limits, levels, curve
        further = [level for level in levels if np.abs(self.p - level).min() > SAME]
        if further:
            goal.p = np.unique([*self.p, *further])
            goal.main = np.searchsorted(goal.p, self.p)
            goal.scores = np.array([normal.quantile(p) for p in goal.p.tolist()])
            goal.scores[goal.main] = self.scores
        return goal

    def at_levels(self, quantiles: "Array") -> "list[tuple[float, float]]":
        """The requested levels, each with its quantile."""
        return [(level, float(quantiles[np.abs(self.p - level).argmin()])) for level in self.levels]

    def own(self, space: Space) -> "Goal":
        """The goal of the next of the results, with its part of the points."""
        goal = copy(self)
        goal.points = space.points + self.points // min(max(len(space.results), 1), MOST_PARTS)
        return goal

    @property
    def tolerance(self) -> float:
        """Tolerance of the roots before the last step, which squares it."""
        return min(max(0.06 * float(np.sqrt(self.accuracy)), 6.0 * self.accuracy, 1e-8), 6e-3)


class Outcome:
    """Quantiles of one result, the lines they were found on (and those one level below), and the error estimated."""

    def __init__(self, method: str, quantiles: "Array", lines: Lines, *, groups: int = 1) -> None:
        self.method = method
        self.quantiles = quantiles
        self.lines = lines
        self.groups = groups
        self.before: Lines | None = None
        self.scan: Scan | None = None
        self.roots: Roots | None = None
        self.estimate = float("inf")
        self.admissible = 1.0
        self.mean = float("nan")
        self.std = float("nan")
        # Whether mean and deviation are those of the sample alone: its farthest values make them.
        self.tails = False


def width_of(quantiles: "Array", goal: Goal) -> float:
    """Approximate standard deviation: from the interval's width as for a normal distribution."""
    spread = float(quantiles[-1] - quantiles[0])
    return spread / float(goal.scores[-1] - goal.scores[0])


def direction_of(space: Space, probe: "Array", result: int) -> "Array":
    """The unit vector along which a result rises fastest; along the most curved axis where it does not rise."""
    count = space.size
    centre, ahead, behind = probe[result, 0], probe[result, 1 : count + 1], probe[result, count + 1 : 2 * count + 1]
    gradient = np.nan_to_num(ahead - behind)
    bend = np.nan_to_num(ahead + behind - 2.0 * centre)
    direction = np.zeros(count)
    if space.heavy:
        # Along the axis of the heaviest tail, so that the lines beside it differ little.
        heaviest = [made_.std == np.inf for made_ in space.distributions]
        direction[int(np.argmax(np.where(heaviest, np.abs(gradient) + 1e-300, 0.0)))] = 1.0
        return direction
    size = float(np.sqrt(gradient @ gradient))
    if size > 1e-9 * float(np.abs(bend).max(initial=0.0)) and size > 0.0:
        return gradient / size  # type: ignore[no-any-return]
    overall = _overall(space, result)
    if overall is not None:
        return overall
    direction[int(np.argmax(np.abs(bend)))] = 1.0
    return direction


def _overall(space: Space, result: int) -> "Array | None":
    """The direction of a plane laid through many points: where the centre is flat, the result may rise elsewhere."""
    if space.size > MOST_DIMENSIONS or space.affordable is not None:
        return None
    z = quantile(lattice(space.size, 128, SHIFTS))
    values = space.evaluate(z)[result]
    good = ~np.isnan(values)
    if good.sum() < 4 * space.size:
        return None
    terms = np.column_stack([np.ones(int(good.sum())), z[:, good].T])
    plane, _, _, _ = np.linalg.lstsq(terms, values[good], rcond=None)
    slope = plane[1:]
    size = float(np.sqrt(slope @ slope))
    # For an even function only the scatter remains.
    return slope / size if size > 0.1 * float(values[good].std()) else None


def tail_direction(space: Space, result: int, direction: "Array", score: float) -> "Array":
    """The direction half-way between the gradient at the centre and those at both ends of the interval.

    Where inputs are bounded the ends rise along other inputs than the centre; the lines then tilt less.
    """
    count = space.size
    step = 0.5 * np.eye(count)
    ends = [score * direction[:, None], -score * direction[:, None]]
    values = space.evaluate(np.concatenate([part for end in ends for part in (end + step, end - step)], axis=1))[result]
    blended = direction.copy()
    for part in values.reshape(2, 2, count):
        gradient = part[0] - part[1]
        size = float(np.sqrt(gradient @ gradient))
        if not size > 0.0:
            return direction
        blended += 0.5 * gradient / size
    size = float(np.sqrt(blended @ blended))
    return blended / size if size > 0.5 else direction
