"""A slow model replaced by polynomials of its inputs, fitted once for all its results.

Every result would need hundreds of calls of a model that takes one case at a time, each along its own direction.
The polynomials are fitted by least squares at a lattice's points and tested at others farther out; their deviation
there is part of every stated error.
"""

from itertools import combinations_with_replacement

import numpy as np

from dynamics_cli.core.uncertainty.methods.outcome import FAIR
from dynamics_cli.core.uncertainty.space import Space
from dynamics_cli.numerics.distributions import normal
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature.hermite import polynomials
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS, lattice
from dynamics_cli.numerics.quadrature.smolyak import chaos_terms

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# The degree tried first, and those tried if that is not accurate enough; of few inputs, higher ones cost little.
DEGREES = (3, 6)
MORE = {1: (12, 20), 2: (12,)}
# How much farther out the points of these lie: beyond them a plane goes on, whose error is known only by its size.
WIDER = 1.4
MOST_TERMS = 250
# Number of test points, how much farther out they lie, and how much worse the fit may be between them.
TRIALS = 32
FARTHER = 1.25
SAFETY = 3.0


def suits(space: Space) -> bool:
    """Whether the inputs are continuous, of finite variance, and not very many."""
    return (
        1 <= space.size <= MOST_DIMENSIONS
        and chaos_terms(space.size, 2) <= MOST_TERMS
        and not (space.stepped or space.heavy)
    )


class StandIn:
    """The polynomials; `space` has them as its model, with the same inputs.

    `errors` are those of each result (infinite where some case is refused), `missed` the share of its variance that the
    polynomials leave out.
    """

    def __init__(self, space: Space, seed: int, accuracy: float) -> None:
        self._scales = {
            name: (distribution.mean, distribution.std)
            for name, distribution in zip(space.names, space.distributions, strict=True)
        }
        self._results = space.results
        n = space.size
        degrees = (*DEGREES, *MORE.get(n, ()))
        most = max(degree for degree in range(2, degrees[-1] + 1) if chaos_terms(n, degree) <= MOST_TERMS)
        tried = FARTHER * quantile(lattice(n, TRIALS, 1, seed + 1))
        there = space.evaluate(tried)
        points, values = np.zeros((n, 0)), np.zeros((len(there), 0))
        for degree in sorted({min(degree, most) for degree in degrees}):
            self.degree = degree
            self._exponents = _products(n, degree)
            self.count = 1 << (2 * len(self._exponents) - 1).bit_length()
            wide = WIDER if degree > DEGREES[-1] else 1.0
            if degree > DEGREES[-1] and degree == next(iter(MORE[n])):  # others than those known so far
                points, values = np.zeros((n, 0)), np.zeros((len(there), 0))
            points, values = _grown(space, points, values, self.count, seed, wide)
            self._fit(self._standard(space.inputs(points)), values, self._standard(space.inputs(tried)), there)
            if (self.errors <= (accuracy if degree < DEGREES[-1] else FAIR) * values.std(axis=1)).all():
                break
        self.space = Space(self, dict(zip(space.names, space.distributions, strict=True)), {})
        self.space.factor = space.factor

    def _standard(self, inputs: "dict[str, Any]") -> "Array":
        """The inputs about their means, in their deviations."""
        return np.array([(inputs[name] - mean) / std for name, (mean, std) in self._scales.items()])

    def _fit(self, points: "Array", values: "Array", tried: "Array", there: "Array") -> None:
        whole = np.array(np.isfinite(values).all(axis=1) & np.isfinite(there).all(axis=1))
        self._whole = whole[:, None]
        known, wanted = np.where(self._whole, values, 0.0), np.where(self._whole, there, 0.0)
        coefficients, _, _, _ = np.linalg.lstsq(self._terms(points).T, known.T, rcond=None)
        self._coefficients = coefficients.T
        self._plane = np.linalg.lstsq(np.vstack([np.ones(points.shape[1]), points]).T, known.T, rcond=None)[0].T[:, 1:]
        self._far = np.abs(np.concatenate([points, tried], axis=1)).max(axis=1)[:, None]
        off = self._coefficients @ self._terms(tried) - wanted
        near = self._coefficients @ self._terms(points) - known
        variance = wanted.var(axis=1)
        worst = SAFETY * np.abs(np.concatenate([off, near], axis=1)).max(axis=1)
        if self.degree > DEGREES[-1]:
            beyond = sum(2.0 * normal.upper(float(far)) for far in self._far[:, 0])
            worst += beyond * np.ptp(known, axis=1)
        self.errors = np.where(whole, worst, np.inf)
        self.missed = np.where(whole, off.var(axis=1) / np.where(variance > 0.0, variance, 1.0), np.inf)

    def __call__(self, inputs: "dict[str, Any]") -> "tuple[dict[str, Any], None]":
        """Results by address."""
        u = self._standard(inputs)
        # beyond the points they were fitted to, high degrees grow without limit: from there on as a plane does
        near = np.clip(u, -self._far, self._far) if self.degree > DEGREES[-1] else u
        values = self._coefficients @ self._terms(near) + self._plane @ (u - near)
        return dict(zip(self._results, np.where(self._whole, values, np.nan), strict=True)), None

    def _terms(self, u: "Array") -> "Array":
        """Every product of Hermite polynomials (terms, points)."""
        tables = polynomials(u, self.degree)
        terms = np.ones((len(self._exponents), u.shape[1]))
        for axis in range(len(u)):
            terms *= tables[self._exponents[:, axis], axis]
        return terms


def _products(n: int, degree: int) -> "Array":
    """The exponents (terms, n) of all products of total degree ≤ `degree`."""
    axes = [axes for total in range(degree + 1) for axes in combinations_with_replacement(range(n), total)]
    return np.array([np.bincount(choice, minlength=n) for choice in axes])


def _grown(space: Space, points: "Array", values: "Array", count: int, seed: int, wide: float) -> "tuple[Array, Array]":
    """A lattice and the model's values on it; a larger lattice contains the points of a smaller one."""
    made = wide * quantile(lattice(space.size, count, 1, seed))
    values_at = np.empty((len(values), count))
    known = np.zeros(count, dtype=bool)
    if points.shape[1]:
        known[:: count // points.shape[1]] = True
        values_at[:, known] = values
    values_at[:, ~known] = space.evaluate(made[:, ~known])
    return made, values_at
