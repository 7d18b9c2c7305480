"""A slow model stood in for by Hermite polynomials of its inputs' normal scores, fitted once for all its results.

Every result would ask a model that is called case by case some hundreds of times, each along a direction of its own.
The polynomials are fitted by least squares at a lattice's points and tried at others farther out; what they are off by
there is part of every error stated.
"""

from itertools import combinations_with_replacement

import numpy as np

from dynamics_cli.core.uncertain.distributions import Normal
from dynamics_cli.core.uncertain.space import Space
from dynamics_cli.numerics.hermite import polynomials
from dynamics_cli.numerics.lattice import MOST_DIMENSIONS, lattice
from dynamics_cli.numerics.normal_arrays import quantile
from dynamics_cli.numerics.smolyak import chaos_terms

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

MOST_DEGREE = 6
MOST_TERMS = 250
# Points beside those of the fit, and how much farther out they lie.
TRIALS = 64
FARTHER = 1.25
# Sixty-four trials do not find the worst place there is.
SAFETY = 2.0


def suits(space: Space) -> bool:
    """Whether the inputs have smooth transformations to normal scores, and are neither one nor very many."""
    return (
        2 <= space.size <= MOST_DIMENSIONS
        and chaos_terms(space.size, 2) <= MOST_TERMS
        and not (space.stepped or space.heavy)
    )


class StandIn:
    """The polynomials: `space` has them as the model of independent standard normals; `errors` by result."""

    def __init__(self, space: Space, seed: int) -> None:
        self._names = space.names
        self._results = space.results
        degrees = range(2, MOST_DEGREE + 1)
        self.degree = max(degree for degree in degrees if chaos_terms(space.size, degree) <= MOST_TERMS)
        axes = [
            choice for d in range(self.degree + 1) for choice in combinations_with_replacement(range(space.size), d)
        ]
        self._exponents = np.array([np.bincount(choice, minlength=space.size) for choice in axes])
        self.count = 1 << (2 * len(axes) - 1).bit_length()
        fitted = quantile(lattice(space.size, self.count, 1, seed))
        tried = FARTHER * quantile(lattice(space.size, TRIALS, 1, seed + 1))
        values = space.evaluate(np.concatenate([fitted, tried], axis=1))
        whole = np.array(np.isfinite(values).all(axis=1))
        self._whole = whole[:, None]
        known = np.where(self._whole, values, 0.0)
        made, _, _, _ = np.linalg.lstsq(self._terms(fitted).T, known[:, : self.count].T, rcond=None)
        self._coefficients = made.T
        off = np.abs(self._coefficients @ self._terms(tried) - known[:, self.count :]).max(axis=1)
        self.errors = np.where(whole, SAFETY * off, np.inf)
        self.space = Space(self, {name: Normal(0.0, 1.0) for name in self._names}, {})

    def __call__(self, inputs: "dict[str, Any]") -> "tuple[dict[str, Any], None]":
        """Results by address, at normal scores by input."""
        z = np.array([inputs[name] for name in self._names])
        found = self._coefficients @ self._terms(z)
        return dict(zip(self._results, np.where(self._whole, found, np.nan), strict=True)), None

    def _terms(self, z: "Array") -> "Array":
        """Every product of Hermite polynomials (terms, points)."""
        tables = polynomials(z, self.degree)
        made = np.ones((len(self._exponents), z.shape[1]))
        for axis in range(len(z)):
            made *= tables[self._exponents[:, axis], axis]
        return made
