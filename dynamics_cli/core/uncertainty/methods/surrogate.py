"""A slow model replaced by polynomials of its inputs, fitted once for all its results.

Every result would need hundreds of calls of a model that takes one case at a time, each along its own direction.
The polynomials are fitted by least squares at a lattice's points and tested at others farther out; their deviation
there is part of every stated error.
"""

from functools import lru_cache
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
    from collections.abc import Mapping
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.inputs.uncertain.distributions import Distribution

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
# Digits that the fit itself may lose of a number.
ROUNDING = 1e-12


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
        self._inputs = dict(zip(space.names, space.distributions, strict=True))
        self._results = space.results
        self._together = space.together
        n = space.size
        degrees = (*DEGREES, *MORE.get(n, ()))
        most = max(degree for degree in range(2, degrees[-1] + 1) if chaos_terms(n, degree) <= MOST_TERMS)
        tried = FARTHER * quantile(lattice(n, TRIALS, 1, seed + 1))
        there = space.evaluate(tried)
        points, values = np.zeros((n, 0)), np.zeros((len(there), 0))
        for degree in sorted({min(degree, most) for degree in degrees}):
            count = 1 << (2 * chaos_terms(n, degree) - 1).bit_length()
            if points.shape[1] and space.affordable is not None and count > space.affordable // 2:
                break
            self.degree, self.count = degree, count
            wide = WIDER if degree > DEGREES[-1] else 1.0
            if degree > DEGREES[-1] and degree == MORE[n][0]:  # others than those known so far
                points, values = np.zeros((n, 0)), np.zeros((len(there), 0))
            points, values = _grown(space, points, values, self.count, seed, wide)
            self._fit(space.inputs(points), values, space.inputs(tried), there)
            enough = (accuracy if degree < DEGREES[-1] else FAIR) * values.std(axis=1)
            # what does not vary is met to rounding
            if (self.errors <= enough + ROUNDING * np.abs(values).max(axis=1)).all():
                break
            if space.affordable is not None and (self.errors > values.std(axis=1)).all():  # no degree will do
                break
        self.space = Space(self, self._inputs, {})
        self.space.factor = space.factor

    def fits(self, deviations: "Array", still: "Array") -> bool:
        """Whether it is good enough for all results but still ones, where the model would answer thousands of cases."""
        return not self._together or bool((still | (self.errors <= FAIR * deviations)).all())

    def _fit(self, given: "dict[str, Any]", values: "Array", farther: "dict[str, Any]", there: "Array") -> None:
        points, tried = standard(self._inputs, given), standard(self._inputs, farther)
        whole = np.array(np.isfinite(values).all(axis=1) & np.isfinite(there).all(axis=1))
        self._whole = whole[:, None]
        known, wanted = np.where(self._whole, values, 0.0), np.where(self._whole, there, 0.0)
        coefficients, _, _, _ = np.linalg.lstsq(terms(points, self.degree).T, known.T, rcond=None)
        self._coefficients = coefficients.T
        self._plane = np.linalg.lstsq(np.vstack([np.ones(points.shape[1]), points]).T, known.T, rcond=None)[0].T[:, 1:]
        self._far = np.abs(np.concatenate([points, tried], axis=1)).max(axis=1)[:, None]
        off = self._coefficients @ terms(tried, self.degree) - wanted
        near = self._coefficients @ terms(points, self.degree) - known
        variance = wanted.var(axis=1)
        worst = SAFETY * np.abs(np.concatenate([off, near], axis=1)).max(axis=1)
        if self.degree > DEGREES[-1]:
            beyond = sum(2.0 * normal.upper(float(far)) for far in self._far[:, 0])
            worst += beyond * np.ptp(known, axis=1)
        self.errors = np.where(whole, worst, np.inf)
        self.missed = np.where(whole, off.var(axis=1) / np.where(variance > 0.0, variance, 1.0), np.inf)

    def __call__(self, inputs: "dict[str, Any]") -> "tuple[dict[str, Any], None]":
        """Results by address."""
        u = standard(self._inputs, inputs)
        # beyond the points they were fitted to, high degrees grow without limit: from there on as a plane does
        near = np.clip(u, -self._far, self._far) if self.degree > DEGREES[-1] else u
        values = self._coefficients @ terms(near, self.degree) + self._plane @ (u - near)
        return dict(zip(self._results, np.where(self._whole, values, np.nan), strict=True)), None


def standard(distributions: "Mapping[str, Distribution]", inputs: "dict[str, Any]") -> "Array":
    """Inputs about their means, in their deviations."""
    return np.array([(inputs[name] - one.mean) / one.std for name, one in distributions.items()])


def terms(u: "Array", degree: int) -> "Array":
    """Every product of Hermite polynomials up to a total degree (terms, points), each from one before it."""
    tables = polynomials(u, degree)
    factors = _factors(len(u), degree)
    made = np.ones((len(factors) + 1, u.shape[1]))
    for term, (known, axis, power) in enumerate(factors, 1):
        np.multiply(made[known], tables[power, axis], out=made[term])
    return made


@lru_cache(maxsize=16)
def _factors(n: int, degree: int) -> "list[tuple[int, int, int]]":
    """Of all products of total degree 1 to `degree`: a product before it, the axis that comes to it, and its power."""
    places: dict[tuple[int, ...], int] = {(): 0}
    factors = []
    for axes in (axes for total in range(1, degree + 1) for axes in combinations_with_replacement(range(n), total)):
        power = axes.count(axes[-1])
        places[axes] = len(places)
        factors.append((places[axes[:-power]], axes[-1], power))
    return factors


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
