"""Which input drives a result: variance shares (first-order and total Sobol indices), and the covariance of results.

Up to three inputs: the analysis of variance of a tensor grid. More, smooth: projection on Hermite polynomials of degree
three from a sparse grid; of more inputs than that grid is for, straight lines. Otherwise Jansen's estimator on shifted
lattices. Correlated inputs have no such indices; the
variance is then split by covariance, share_i = Cov(c_i x_i, result)/variance to first order, which can be negative.
"""

from itertools import combinations_with_replacement

import numpy as np

from dynamics_cli.core.uncertainty.methods.surrogate import standard
from dynamics_cli.core.uncertainty.space import Space
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature.hermite import gauss_hermite, polynomials, tensor
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS, MOST_POINTS, lattice
from dynamics_cli.numerics.quadrature.smolyak import chaos_terms, smolyak

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

SHIFTS = 8
# A projection that misses more than this share of the variance is not used.
_MISSED = 2e-3
_MOST_TERMS = 500
# Points per axis of the grid used and of the one it is compared with, by the number of inputs.
GRIDS = {1: (30, 20), 2: (12, 9), 3: (8, 6)}
FINE_GRIDS = {1: (60, 40), 2: (40, 27), 3: (15, 11)}
_LARGEST_ERROR = 5e-3
# Slopes are tried for more inputs than this, and judged by so many cases.
MANY_INPUTS, STRAIGHT_CASES = 12, 2048
# With fewer admissible cases than this correlations of results are not stated.
FEWEST_CASES = 8


class Shares:
    """For every result: first-order and total shares of every input (results, inputs), and an estimate of their error.

    `values` and `weights` are the cases they came from, which serve for the covariance of results too.
    """

    def __init__(
        self, method: str, first: "Array", total: "Array", error: float, values: "Array", weights: "Array"
    ) -> None:
        self.method = method
        self.first = first
        self.total = total
        self.error = error
        self.values = values
        self.weights = weights

    def covariance(self) -> "Array | None":
        """Correlation coefficients of the results, from the admissible cases; None where these are too few."""
        good = ~np.isnan(self.values).any(axis=0)
        if good.sum() < FEWEST_CASES:
            return None
        values, weights = self.values[:, good], self.weights[good]
        weights = weights / weights.sum()
        apart = values - (values @ weights)[:, None]
        products = (apart * weights) @ apart.T
        scale = np.sqrt(np.maximum(np.diag(products), 0.0))
        with np.errstate(all="ignore"):
            return np.clip(np.nan_to_num(products / np.outer(scale, scale)), -1.0, 1.0)  # type: ignore[no-any-return]


def variance_shares(space: Space, variances: "Array", seed: int, admissible: float = 1.0) -> Shares:
    """The shares of all results by the cheapest method that holds; NaN where too few cases are admissible."""
    if space.factor is not None or space.heavy:
        return _covariances(space, seed)
    if space.size <= 3 and not space.stepped:
        shares = _tensors(space, variances > 0.0)
        if shares is not None:
            return shares
    elif space.smooth and chaos_terms(space.size, 3) <= _MOST_TERMS:
        shares = _chaos(space, variances)
        if shares is not None:
            return shares
    elif space.size > MANY_INPUTS and not space.slow:
        shares = _straight(space, variances > 0.0, seed)
        if shares is not None:
            return shares
    return _jansen(space, variances > 0.0, seed, admissible)


def _tensors(space: Space, vary: "Array") -> Shares | None:
    """Two grids, whose difference is the error; None when kinks keep them apart.

    A result that does not `vary` has no shares: its rounding is noise. A sole input has all of them.
    """
    fine, coarse = (GRIDS if space.smooth else FINE_GRIDS)[space.size]
    finer, other = _tensor(space, fine), _tensor(space, coarse)
    if finer is None or other is None:
        return None
    if space.size == 1:
        return finer
    finer.error = float(np.abs(finer.total - other.total)[vary].max(initial=0.0))
    return finer if finer.error <= _LARGEST_ERROR else None


def _tensor(space: Space, count: int) -> Shares | None:
    """Conditional means on the grid are sums over its axes."""
    n = space.size
    nodes, own = gauss_hermite(count)
    points, weights = tensor(nodes, own, n)
    heavy = weights > 1e-18
    values = np.zeros((0, 0))
    results = space.evaluate(points[:, heavy])
    if np.isnan(results).any():
        return None
    values = np.zeros((results.shape[0], weights.size))
    values[:, heavy] = results
    mean = results @ weights[heavy]
    apart = np.where(heavy, values - mean[:, None], 0.0)
    variance = (apart * apart) @ weights
    cube = apart.reshape((-1, *(count,) * n))
    first, total = np.zeros((len(results), n)), np.zeros((len(results), n))
    for axis in range(n):
        given, without = cube, cube
        for other in reversed(range(n)):
            if other != axis:
                given = np.tensordot(given, own, axes=(other + 1, 0))
        without = np.tensordot(cube, own, axes=(axis + 1, 0))
        first[:, axis] = (given * given) @ own
        rest = tensor(nodes, own, n - 1)[1].reshape((count,) * (n - 1))
        total[:, axis] = variance - (without * without * rest).reshape(len(results), -1).sum(axis=1)
    scale = np.where(variance > 0.0, variance, 1.0)[:, None]
    return Shares(
        f"analysis of variance on {count}^{n} points", first / scale, total / scale, 0.0, results, weights[heavy]
    )


_bases: "dict[int, tuple[Array, Array]]" = {}


def _basis(n: int) -> "tuple[Array, Array]":
    """Weighted Hermite products of total degree ≤ 3 on the sparse grid, (terms, points), and their exponents."""
    if n not in _bases:
        points, weights = smolyak(n, 3)
        tables = polynomials(points, 3)
        choices = [axes for degree in range(1, 4) for axes in combinations_with_replacement(range(n), degree)]
        exponents = np.array([np.bincount(axes, minlength=n) for axes in choices])
        terms = np.ones((len(exponents), weights.size))
        for axis in range(n):
            terms *= tables[exponents[:, axis], axis]
        _bases[n] = terms * weights, exponents
    return _bases[n]


def _chaos(space: Space, variances: "Array") -> Shares | None:
    points, weights = smolyak(space.size, 3)
    terms, exponents = _basis(space.size)
    values = space.evaluate(points)
    if np.isnan(values).any():
        return None
    squares = ((values - values[:, :1]) @ terms.T) ** 2
    explained = squares.sum(axis=1)
    known = variances > 0.0
    missed = np.abs(explained[known] / variances[known] - 1.0)
    if missed.size and missed.max() > _MISSED:
        return None
    active = exponents > 0
    alone = active.sum(axis=1) == 1
    scale = np.where(explained > 0.0, explained, 1.0)[:, None]
    first = np.array([squares[:, active[:, i] & alone].sum(axis=1) for i in range(space.size)]).T / scale
    total = np.array([squares[:, active[:, i]].sum(axis=1) for i in range(space.size)]).T / scale
    error = float(missed.max()) if missed.size else 0.0
    return Shares(f"Hermite polynomials of degree 3 from {weights.size} points", first, total, error, values, weights)


def _straight(space: Space, vary: "Array", seed: int) -> Shares | None:
    """Slopes between half a deviation to both sides of each input; None where a sample is not on these lines.

    Two cases an input, where Jansen's estimator takes thousands.
    """
    n = space.size
    step = 0.5 * np.eye(n)
    z = np.random.default_rng(seed).standard_normal((n, STRAIGHT_CASES))
    distributions = dict(zip(space.names, space.distributions, strict=True))
    above, below, everywhere = (standard(distributions, space.inputs(points)) for points in (step, -step, z))
    values, sample = space.evaluate(np.concatenate([step, -step], axis=1)), space.evaluate(z)
    if np.isnan(values).any() or np.isnan(sample).any():
        return None
    slopes = (values[:, :n] - values[:, n:]) / np.diag(above - below)
    variance = sample.var(axis=1)
    missed = ((sample - slopes @ everywhere).var(axis=1)[vary] / variance[vary]).max(initial=0.0)
    if not missed <= _MISSED:
        return None
    squares = slopes * slopes
    whole = squares.sum(axis=1, keepdims=True)
    shares = squares / np.where(whole > 0.0, whole, 1.0)
    weights = np.full(STRAIGHT_CASES, 1.0 / STRAIGHT_CASES)
    return Shares("slopes at the means, as results are straight", shares, shares, float(missed), sample, weights)


def _jansen(space: Space, vary: "Array", seed: int, admissible: float) -> Shares:
    """Two independent lattices A and B, and A with one coordinate of B, for every input (Jansen 1999)."""
    n = space.size
    count = 64 if space.slow else 1024 if n <= 8 else 256
    if not space.slow:
        # Where few cases are admissible, more are evaluated.
        while count < MOST_POINTS and count * admissible < 512:
            count *= 2
    if 2 * n <= MOST_DIMENSIONS:
        uniform = lattice(2 * n, count, SHIFTS, seed)
    else:
        uniform = np.random.default_rng(seed).random((2 * n, SHIFTS * count))
    z = quantile(uniform)
    a, b = z[:n], z[n:]
    fa, fb = space.evaluate(a), space.evaluate(b)
    weights = np.full(fa.shape[1], 1.0 / fa.shape[1])
    results = len(fa)
    if n == 1:
        # A sole input has all of the variance, however little of its range is admissible.
        whole = np.ones((results, 1))
        return Shares("the only input", whole, whole, 0.0, fa, weights)
    mean = _mean(np.concatenate([fa, fb], axis=1))[:, None]
    variance = 0.5 * (_mean((fa - mean) ** 2) + _mean((fb - mean) ** 2))
    scale = np.where(variance > 0.0, variance, 1.0)[:, None]
    first, total = np.zeros((results, n)), np.zeros((results, n))
    scatter = 0.0
    for i in range(n):
        mixed = a.copy()
        mixed[i] = b[i]
        found = space.evaluate(mixed)
        other, own = 0.5 * (fb - found) ** 2, 0.5 * (fa - found) ** 2
        first[:, i], total[:, i] = 1.0 - _mean(other) / scale[:, 0], _mean(own) / scale[:, 0]
        replicates = _mean(own.reshape(results, SHIFTS, -1)) / scale
        first[np.isnan(replicates).any(axis=1), i] = np.nan
        scatter = np.maximum(scatter, replicates.std(axis=1, ddof=1)[vary].max(initial=0.0))
    error = 2.0 * 2.365 * float(scatter) / float(np.sqrt(SHIFTS))
    return Shares(f"Jansen's estimator, {SHIFTS} lattices of {count} points", first, total, error, fa, weights)


def _mean(values: "Array") -> "Array":
    """The mean of the admissible along the last axis; NaN where none is."""
    if not np.isnan(values.sum()):
        return values.mean(axis=-1)  # type: ignore[no-any-return]
    good = ~np.isnan(values)
    with np.errstate(invalid="ignore"):
        return np.where(good, values, 0.0).sum(axis=-1) / good.sum(axis=-1)  # type: ignore[no-any-return]


def _covariances(space: Space, seed: int) -> Shares:
    """Correlated inputs: slopes by each input's own score, times the covariance of that score with the rest."""
    n = space.size
    correlation = np.eye(n) if space.factor is None else space.factor @ space.factor.T
    step = 0.5 * np.eye(n)
    cases = np.concatenate([step, -step], axis=1)
    values = space.evaluate_inputs(space.inputs_of(cases), cases.shape[1])
    slopes = np.nan_to_num(values[:, :n] - values[:, n:])
    parts = slopes * (slopes @ correlation)
    whole = parts.sum(axis=1, keepdims=True)
    shares = np.where(whole > 0.0, parts / np.where(whole > 0.0, whole, 1.0), 0.0)
    z = quantile(lattice(n, 64 if space.slow else 512, SHIFTS, seed)) if n <= MOST_DIMENSIONS else np.zeros((n, 1))
    sample = space.evaluate(z)
    weights = np.full(sample.shape[1], 1.0 / sample.shape[1])
    return Shares("covariance with the result, first order", shares, shares, np.nan, sample, weights)
