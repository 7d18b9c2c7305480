"""The classical methods: linear, second order, unscented, Monte Carlo. They are used only if named, never chosen.

The truncation error of the first three, which they cannot see themselves, is measured against a quadrature.
"""

import numpy as np

from dynamics_cli.core.uncertainty.methods.outcome import FLOOR, Goal
from dynamics_cli.core.uncertainty.space import Space
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

DEFAULT_SAMPLES = 1_000_000
# Values of a sample that are kept for all results together: a gigabyte.
MOST_VALUES = 125_000_000
_STEP = 0.05


class Plain:
    """Quantiles, mean and deviation of one result, and the error if the method knows it."""

    def __init__(self, method: str, quantiles: "Array", mean: float, std: float, estimate: float = np.inf) -> None:
        self.method = method
        self.quantiles = quantiles
        self.mean = mean
        self.std = std
        self.estimate = estimate


def linear(space: Space, result: int, goal: Goal, slopes: "Mapping[str, float] | None") -> Plain:
    """First order at the means: derivatives as tracked through the formula, or by differences where not known."""
    count = space.size
    centre = np.array([distribution.mean for distribution in space.distributions])
    deviations = np.array([distribution.std for distribution in space.distributions])
    cases = np.concatenate([centre[:, None], centre[:, None] + np.diag(deviations * 1e-3)], axis=1)
    if slopes is None:
        cases = np.concatenate([cases, centre[:, None] - np.diag(deviations * 1e-3)], axis=1)
    inputs = {**space.fixed, **dict(zip(space.names, cases, strict=True))}
    values = space.evaluate_inputs(inputs, cases.shape[1])[result]
    if slopes is None:
        steep = (values[1 : count + 1] - values[count + 1 :]) / 2e-3
    else:
        steep = np.array([slopes.get(name, 0.0) for name in space.names]) * deviations
    turned = steep if space.factor is None else space.factor.T @ steep
    std = float(np.sqrt(turned @ turned))
    return Plain("linear, at the means", values[0] + std * goal.scores, float(values[0]), std)


def second_order(space: Space, result: int, goal: Goal) -> Plain:
    """Mean, deviation and skewness of the quadratic at the centre of z, its quantiles by Cornish and Fisher."""
    count = space.size
    pairs = [(i, j) for i in range(count) for j in range(i)]
    unit = _STEP * np.eye(count)
    both = [unit[i] + a * unit[j] for i, j in pairs for a in (1.0, -1.0)]
    corners = np.array([*both, *[-part for part in both]]).T.reshape(count, -1)
    z = np.concatenate([np.zeros((count, 1)), unit, -unit, corners], axis=1)
    values = space.evaluate(z)[result]
    ahead, behind = values[1 : count + 1], values[count + 1 : 2 * count + 1]
    gradient = (ahead - behind) / (2.0 * _STEP)
    hessian = np.diag((ahead + behind - 2.0 * values[0]) / _STEP**2)
    crossed = values[2 * count + 1 :].reshape(2, -1, 2) if pairs else np.zeros((2, 0, 2))
    for k, (i, j) in enumerate(pairs):
        same, opposite = crossed[0, k, 0] + crossed[1, k, 0], crossed[0, k, 1] + crossed[1, k, 1]
        hessian[i, j] = hessian[j, i] = (same - opposite) / (4.0 * _STEP**2)
    mean = float(values[0] + 0.5 * np.trace(hessian))
    variance = float(gradient @ gradient + 0.5 * (hessian * hessian).sum())
    third = float(3.0 * gradient @ hessian @ gradient + np.trace(hessian @ hessian @ hessian))
    std = float(np.sqrt(variance))
    skew = third / variance**1.5 if variance > 0.0 else 0.0
    z_ = goal.scores
    bent = z_ + (z_**2 - 1.0) * skew / 6.0 - (2.0 * z_**3 - 5.0 * z_) * skew**2 / 36.0
    return Plain("second order, Cornish–Fisher", mean + std * bent, mean, std)


def unscented(space: Space, result: int, goal: Goal) -> Plain:
    """Mean and deviation from points at ±√3 on every axis, the interval as if normal."""
    count = space.size
    far = np.sqrt(3.0) * np.eye(count)
    values = space.evaluate(np.concatenate([np.zeros((count, 1)), far, -far], axis=1))[result]
    weights = np.full(values.size, 1.0 / 6.0)
    weights[0] = 1.0 - count / 3.0
    # Weighted differences from the centre: the central weight is large and negative when inputs are many.
    apart = values - values[0]
    shift = float(weights @ apart)
    std = float(np.sqrt(max(weights @ (apart * apart) - shift * shift, 0.0)))
    mean = float(values[0]) + shift
    return Plain("unscented, 2n + 1 points", mean + std * goal.scores, mean, std)


class Sample:
    """A plain random sample of every result."""

    def __init__(self, space: Space, samples: int, seed: int) -> None:
        count = samples or DEFAULT_SAMPLES
        most = MOST_VALUES // len(space.results)
        if count > most:
            message = f"a sample of {count} cases with {len(space.results)} results each is too large for memory"
            raise UsageError(message, parameter="samples", code="too-many", hint=f"at most {most} are possible here")
        generator = np.random.default_rng(seed)
        block = 1 << 14
        rows = [
            space.evaluate(generator.standard_normal((space.size, min(block, count - start))))
            for start in range(0, count, block)
        ]
        self.values = np.concatenate(rows, axis=1)

    def plain(self, result: int, goal: Goal) -> tuple[Plain, float, "Array"]:
        """One result: quantiles with the sampling error of each (95 %), the admissible share, and the sorted values."""
        values = self.values[result]
        good = np.sort(values[~np.isnan(values)])
        if good.size < 2:
            return Plain("Monte Carlo", np.full(goal.p.size, np.nan), np.nan, np.nan), good.size / values.size, good
        mean, std = float(good.mean()), float(good.std())
        count = good.size
        scatter = 1.96 * np.sqrt(goal.p * (1.0 - goal.p) / count)
        ends = np.clip(((goal.p + scatter[None] * [[-1], [0], [1]]) * count).astype(int), 0, count - 1)
        low, middle, high = good[ends]
        errors = [0.5 * float((high - low).max()), 1.96 * std / np.sqrt(count)]
        estimate = max(errors) / std if std > 0.0 else FLOOR
        return Plain(f"Monte Carlo, {values.size} samples", middle, mean, std, estimate), count / values.size, good
