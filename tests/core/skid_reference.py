"""Distributions of a skid's speed and time with correlated inputs and drag that may be inadmissible, by quadrature.

Friction's own score is the innermost variable: along it a result crosses a level once, which bisection finds, and
inadmissible drag is cut off at one end. What is left are two smooth integrals by Gauss–Legendre panels. Nothing of the
program's own methods is used.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.polynomial.legendre import leggauss

from dynamics_cli.core.inputs.uncertain.distributions import Normal
from dynamics_cli.numerics.distributions.normal_arrays import probability

G = 9.80665
NAMES = ("mu", "theta", "d")
PAIRS = (("mu", "theta"), ("mu", "d"), ("theta", "d"))
Array = Any


def panels(edges: Array, count: int) -> tuple[Array, Array]:
    nodes, weights = leggauss(count)
    width = np.diff(edges)
    points = edges[:-1, None] + width[:, None] * 0.5 * (nodes + 1.0)
    return points.ravel(), (width[:, None] * 0.5 * weights).ravel()


def drag(mu: Array, theta: Array) -> Array:
    return mu * np.cos(theta) + np.sin(theta)


def problem(rng: np.random.Generator) -> tuple[dict[str, Normal], dict[tuple[str, str], float]]:
    """Steep descents and low friction, with one pair or all correlated."""
    inputs = {
        "mu": Normal(rng.uniform(0.15, 0.9), rng.uniform(0.06, 0.25)),
        "theta": Normal(rng.uniform(-0.3, 0.05), rng.uniform(0.001, 0.04)),
        "d": Normal(rng.uniform(20.0, 80.0), rng.uniform(0.1, 1.0)),
    }
    rho = float(rng.choice([0.99, 0.999, 0.9999]))
    chosen = int(rng.integers(4))
    return inputs, {pair: rho for place, pair in enumerate(PAIRS) if chosen in (place, 3)}


def model(x: dict[str, Any]) -> tuple[dict[str, Any], Any]:
    f = drag(x["mu"], x["theta"])
    refused = (f <= 0.0) | (x["mu"] < 0.0)
    f = np.where(refused, 1.0, f)
    return {"speed": np.sqrt(2.0 * G * x["d"] * f), "time": np.sqrt(2.0 * x["d"] / (G * f))}, refused


class Reference:
    """Probabilities of a problem's results, given that drag is admissible."""

    def __init__(self, inputs: dict[str, Normal], correlation: dict[tuple[str, str], float], slopes: int = 14) -> None:
        """As many panels over the `slopes`: more where these vary much and friction hardly."""
        self._inputs = [inputs[name] for name in NAMES]
        matrix = np.eye(3)
        for (one, other), rho in correlation.items():
            i, j = NAMES.index(one), NAMES.index(other)
            matrix[i, j] = matrix[j, i] = rho
        self._factor = np.linalg.cholesky(matrix)
        (y2, w2), (y3, w3) = (panels(np.linspace(-7.5, 7.5, count + 1), 5) for count in (slopes, 14))
        w2, w3 = (w * np.exp(-0.5 * y * y) for y, w in ((y2, w2), (y3, w3)))
        y2, y3 = np.meshgrid(y2, y3, indexing="ij")
        weight = np.outer(w2, w3).ravel() / (w2.sum() * w3.sum())
        kept = weight > 1e-14
        self._y = y2.ravel()[kept], y3.ravel()[kept]
        self._weight = weight[kept]
        self._edge = probability(self._crossing(lambda mu, theta, d: np.minimum(mu, drag(mu, theta))))
        self.admissible = float(self._weight @ (1.0 - self._edge))

    def _crossing(self, rises: Callable[[Array, Array, Array], Array]) -> Array:
        low, high = np.full(self._weight.size, -12.0), np.full(self._weight.size, 12.0)
        for _ in range(48):
            middle = 0.5 * (low + high)
            scores = self._factor @ np.array([middle, *self._y])
            above = rises(*(made.mean + made.std * z for made, z in zip(self._inputs, scores, strict=True))) > 0.0
            low, high = np.where(above, low, middle), np.where(above, middle, high)
        return high

    def below(self, name: str, level: float) -> float:
        """P(result ≤ level)."""
        if name == "speed":
            cross = self._crossing(lambda mu, theta, d: drag(mu, theta) * d - level * level / (2.0 * G))
        else:
            cross = self._crossing(lambda mu, theta, d: drag(mu, theta) - 2.0 * d / (G * level * level))
        part = np.maximum(probability(cross) - self._edge, 0.0)
        share = float(self._weight @ part) / self.admissible
        return share if name == "speed" else 1.0 - share

    def quantile(self, name: str, p: float, low: float, high: float) -> float:
        """The quantile between two levels."""
        for _ in range(40):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self.below(name, middle) < p else (low, middle)
        return 0.5 * (low + high)
