"""Quantiles from one sample for all results: for many results that turn, jump or have kinks, each in its own way.

Replicates of a shifted lattice; each number is taken over all points together, its error from the scatter of the
replicates. Of a slow model that answers thousands of cases at once, polynomials are fitted to the sample: a sample of
them hundreds of times as large costs little, and what they are off by is known from the small one, far better than the
numbers themselves.
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
from dynamics_cli.core.uncertainty.methods.surrogate import MOST_TERMS, standard, suits, terms
from dynamics_cli.core.uncertainty.space import Space
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS, MOST_POINTS, lattice
from dynamics_cli.numerics.quadrature.smolyak import chaos_terms

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# Values of all results together that are kept, and the most replicates; more where more points are asked for.
MOST_VALUES, MOST_SHIFTS = 8_000_000, 64
# The most replicates of several results: as many for the headline, or for one result, as for all, so that a short
# answer has the numbers of the document. And those where the headline needs none, or all points lie on one line.
SHARED_SHIFTS, FEW_SHIFTS = 20, SHIFTS
MOST_TIMES = 10.0
FEWEST_POINTS = 64
# Points of a replicate where only whole numbers are counted: a share of the cases is then known to about a thousandth.
COUNTED = 1 << 13
# Points of a single input of a model that is called case by case: they lie evenly, so few do.
SINGLE = 1 << 10
# The greatest degree of polynomials fitted to a sample, points of it for each of their terms, and the replicates and
# points of each that they are sampled at, so many at a time.
DEGREE, POINTS_A_TERM = 6, 16
FIT_POINTS = 4  # the fewest points for each term of a plane
WIDE, AT_ONCE = (64, MOST_POINTS), 2048
# A number of theirs may scatter more than that of the sample by this share of its worst quantile.
ALIKE = 0.3
# A value beyond so many deviations asks whether there is a deviation at all: the farthest values show it.
FAR, FARTHEST = 8.0, 20
# Deviations from a quantile within which values are counted, the fewest of them, and how much both sides may differ.
NEAR, FEWEST_NEAR, ALIKE_NEAR = 0.05, 200, 1.5
# Within so many deviations of the mean of a dozen replicates and more five numbers lie together, in 98 of 100 cases.
MANY_FACTOR = 3.5


class Pool:
    """Values of every result (results, replicates, points) at the points of a lattice, evaluated once."""

    def __init__(self, space: Space, goal: Goal) -> None:
        self._slow = space.slow
        self._rows = {row: place for place, row in enumerate(space.rest())}
        self.count, self.shifts = _size(space, goal, list(self._rows))
        self.factor = REPLICATE_FACTOR if self.shifts <= SHIFTS else MANY_FACTOR
        self.distance = FLOOR if space.slow else 1.0 / self.count
        # Blocks that stay in the processor's cache; what is slow is asked once.
        parts = [(self.shifts, goal.seed)] if space.slow else [(1, goal.seed + k) for k in range(self.shifts)]
        values = np.empty((len(self._rows), self.shifts * self.count))
        for place, (shifts, seed) in enumerate(parts):
            z = _points(space.size, self.count, shifts, seed)
            space.some(z, list(self._rows), values[:, place * self.count :][:, : z.shape[1]])
        self._values = values.reshape(-1, self.shifts, self.count)
        # polynomials that pass through every point of a sample say nothing of what they are off by
        enough = z.shape[1] >= FIT_POINTS * (space.size + 1)
        dear = enough and (space.together or space.affordable is not None)
        self._wide = Wide(space, z, self._values, goal.seed) if dear and suits(space) else None

    def outcome(self, result: int, goal: Goal, centre: Lines) -> Outcome:
        """One result's quantiles, mean and deviation."""
        row = self._rows[result]
        values = self._values[row]
        good = ~np.isnan(values)
        counts = np.count_nonzero(good, axis=1)
        if counts.min() < 2:
            message = "almost no case within the inputs' uncertainty is admissible"
            raise InadmissibleError(message, code="inadmissible", hint="check the inputs")
        whole = bool(counts.min() == self.count)
        sound = values.ravel() if whole else values[good]
        tails = not centre.space.heavy and _without_deviation(sound)
        heavy = centre.space.heavy or tails
        method = f"{self.shifts} shifted lattices of {self.count} points, one sample for all results"
        quantiles = np.quantile(sound, goal.p)
        own = None if self._slow else _counted(values, counts, quantiles, NEAR * width_of(quantiles, goal))
        scatter = _numbers(values, goal, own, heavy=heavy).std(axis=1, ddof=1) / np.sqrt(self.shifts)
        if self._wide is not None and whole:
            fitted, wide = self._wide.fitted[row], self._wide.values[row]
            apart = _numbers(values, goal, heavy=heavy) - _numbers(fitted, goal, heavy=heavy)
            left = np.hypot(
                apart.std(axis=1, ddof=1) / np.sqrt(self.shifts),
                _numbers(wide, goal, heavy=heavy).std(axis=1, ddof=1) / np.sqrt(len(wide)),
            )
            if (left <= np.maximum(scatter, ALIKE * scatter[: goal.p.size].max())).all():
                scatter, sound = left, _corrected(wide.ravel(), fitted.ravel(), sound)
                quantiles = np.quantile(sound, goal.p)
                method += f", beside polynomials of degree {self._wide.degree} at {wide.size}"
        outcome = Outcome(method, quantiles, centre)
        outcome.admissible = float(counts.sum() / values.size)
        outcome.scan = Listed(sound)  # type: ignore[assignment]
        outcome.tails = tails
        if not centre.space.heavy:
            outcome.mean, outcome.std = float(sound.mean()), float(sound.std())
        width = width_of(outcome.quantiles, goal) if heavy else outcome.std
        error = self.factor * float(scatter.max())
        # Where one input bears, replicates are alike to less than the distance of their points.
        outcome.estimate = max(error / width, self.distance) if width > 0.0 else FLOOR
        return outcome


def _size(space: Space, goal: Goal, rows: "list[int]") -> tuple[int, int]:
    """Points of a replicate, and their number."""
    if space.slow:
        # Where every point is a call of its own, a quarter of them serves all results; half, where they are cheaper.
        most, fewest = SINGLE if space.size == 1 else goal.points // (2 if space.together else 4), FEWEST_POINTS
        if space.affordable is not None:
            most, fewest = min(most, space.affordable), 1
        return min(max(1 << max(most // SHIFTS, 1).bit_length() - 1, fewest), MOST_POINTS), SHIFTS
    if space.whole.issuperset(rows):
        return COUNTED, SHIFTS
    more = min(max(goal.points / DEFAULT_POINTS, 1.0), MOST_TIMES)
    shared = SHARED_SHIFTS if space.partial and space.several else max(MOST_SHIFTS // len(rows), SHARED_SHIFTS)
    most = shared if space.headline(rows) and space.size > 1 else FEW_SHIFTS
    return MOST_POINTS, max(int(min(MOST_VALUES // (len(rows) * MOST_POINTS), most) * more), SHIFTS)


def _points(size: int, count: int, shifts: int, seed: int) -> "Array":
    if size <= MOST_DIMENSIONS:
        return quantile(lattice(size, count, shifts, seed))
    return np.random.default_rng(seed).standard_normal((size, shifts * count))


class Wide:
    """Polynomials of the inputs, fitted to a sample of every result: at its points, and at those of a large one."""

    def __init__(self, space: Space, z: "Array", values: "Array", seed: int) -> None:
        results, n = len(values), space.size
        most = min(MOST_TERMS, z.shape[1] // POINTS_A_TERM)
        self.degree = max(degree for degree in range(1, DEGREE + 1) if degree == 1 or chaos_terms(n, degree) <= most)
        inputs = dict(zip(space.names, space.distributions, strict=True))
        known = np.nan_to_num(values.reshape(results, -1))
        own = terms(standard(inputs, space.inputs(z)), self.degree)
        coefficients = np.linalg.lstsq(own @ own.T, own @ known.T, rcond=None)[0].T
        self.fitted = (coefficients @ own).reshape(values.shape)
        shifts, count = WIDE
        if space.affordable is not None:
            count //= 8
        self.values = np.empty((results, shifts, count))
        for shift in range(shifts):
            far = quantile(lattice(n, count, 1, seed + 1 + shift))
            for start in range(0, count, AT_ONCE):
                part = standard(inputs, space.inputs(far[:, start : start + AT_ONCE]))
                self.values[:, shift, start : start + AT_ONCE] = coefficients @ terms(part, self.degree)


def _numbers(values: "Array", goal: Goal, quantiles: "Array | None" = None, *, heavy: bool = False) -> "Array":
    """Quantiles (where they are not known), mean and deviation of each replicate (numbers, replicates)."""
    broken = bool(np.isnan(values).any())
    if quantiles is None:
        quantiles = (np.nanquantile if broken else np.quantile)(values, goal.p, axis=1)
    if heavy:
        return quantiles
    mean = np.nanmean if broken else np.mean
    apart = values - mean(values)
    return np.array([*quantiles, mean(apart, axis=1), np.sqrt(mean(np.multiply(apart, apart), axis=1))])


def _counted(values: "Array", counts: "Array", quantiles: "Array", step: float) -> "Array | None":
    """Each replicate's quantiles, by its share of values below those of all over the density: no values are sorted.

    None where the density is not alike on both sides, as beside a jump.
    """
    made = []
    for quantile_ in quantiles.tolist():
        below = np.count_nonzero(values <= quantile_, axis=1)
        under = int(below.sum()) - np.count_nonzero(values <= quantile_ - step)
        over = np.count_nonzero(values <= quantile_ + step) - int(below.sum())
        if min(under, over) < max(FEWEST_NEAR, max(under, over) / ALIKE_NEAR):
            return None
        made.append((below / counts - below.sum() / counts.sum()) * (2.0 * step * counts.sum() / (under + over)))
    return np.array(made)


def _without_deviation(sound: "Array") -> bool:
    """Whether the farthest values grow as those of a ratio do near a pole, of which no sample has the deviation.

    Where P(|x| > t) falls as t to the power −α, the logarithms of the farthest exceed the last of them by 1/α in the
    mean (Hill); from α = 2 on downwards the variance is infinite.
    """
    mean, std = float(sound.mean()), float(sound.std())
    if not max(float(sound.max()) - mean, mean - float(sound.min())) > FAR * std:
        return False
    far = np.partition(np.abs(sound - mean), -FARTHEST)[-FARTHEST:]
    return bool(np.log(far / far.min()).sum() >= 0.5 * (FARTHEST - 1))


def _corrected(wide: "Array", fitted: "Array", sound: "Array") -> "Array":
    """A large sample of polynomials, moved at every rank by what they are off by there in a small one."""
    ranks = (np.arange(sound.size) + 0.5) / sound.size
    off = np.sort(sound) - np.sort(fitted)
    corrected: Array = np.sort(wide) + np.interp((np.arange(wide.size) + 0.5) / wide.size, ranks, off)
    return corrected


def pooled(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome:
    """One result from the sample that all of them share, generated when first needed."""
    centre = Lines(space, result, direction, across, np.zeros((space.size - 1, 1)), np.ones(1))
    if space.pool is None:
        space.pool = Pool(space, goal)
    pool: Pool = space.pool
    return pool.outcome(result, goal, centre)
