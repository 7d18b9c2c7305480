"""Errors stated of strongly correlated inputs beside inadmissible ones hold, and intervals contain what they claim."""

from collections.abc import Callable
from statistics import NormalDist
from typing import Any

import numpy as np
import pytest
import skid_reference as skid
from search_length import EVALUATIONS

from dynamics_cli.core.inputs.uncertain.distributions import Normal
from dynamics_cli.core.uncertainty.propagation import propagate


def held(seed: int, problems: int) -> tuple[float, float]:
    """Shares of quantiles within the estimate of their error, and of intervals with the coverage that they claim."""
    rng = np.random.default_rng(seed)
    within, right = [], []
    for _ in range(problems):
        inputs, correlation = skid.problem(rng)
        reference = skid.Reference(inputs, correlation)
        made = propagate(skid.model, inputs, correlation, shares=False)
        for name, spread in made.spreads.items():
            assert spread.admissible == pytest.approx(reference.admissible, abs=1e-3)
            low, high = spread.interval
            worst = 0.0
            for p, found in ((0.025, low), (0.5, spread.median), (0.975, high)):
                exact = reference.quantile(name, p, 0.2 * found, 5.0 * found)
                worst = max(worst, abs(found - exact))
            # the reference itself is good to 1e-7 of the probability, which a thin tail makes more of
            within.append(worst <= (spread.estimate + 1e-5) * spread.std)
            right.append(abs(reference.below(name, high) - reference.below(name, low) - 0.95) <= 1e-3)
    return float(np.mean(within)), float(np.mean(right))


def test_estimates_hold_and_intervals_contain_what_they_claim() -> None:
    assert held(15, 4) == (1.0, 1.0)


@pytest.mark.slow
def test_estimates_hold_over_many_problems() -> None:
    within, right = held(16, EVALUATIONS // 16)
    assert within >= 0.95
    assert right >= 0.99


# What falls to its least at great sums, and the sum it came from.
POLES: dict[str, tuple[Callable[[Any], Any], Callable[[float], float]]] = {
    "root": (lambda s: 1.0 / np.sqrt(s), lambda v: v**-2.0),
    "reciprocal": (lambda s: 1.0 / s, lambda v: 1.0 / v),
    "cubed": (lambda s: s**-3.0, lambda v: float(v ** (-1.0 / 3.0))),
    "logarithm": (lambda s: -np.log(s), lambda v: float(np.exp(-v))),
}


@pytest.mark.parametrize("name", POLES)
@pytest.mark.parametrize("mean", [0.5, 1.0, 2.0])
def test_quantiles_beside_a_pole_where_the_inadmissible_begins(name: str, mean: float) -> None:
    """A sum of normals is normal: quantiles of what falls with it, given that it is positive, have a closed form."""
    function, inverse = POLES[name]

    def model(x: dict[str, Any]) -> tuple[dict[str, Any], Any]:
        total = x["a"] + x["b"] + x["c"]
        refused = total <= 0.0
        return {"result": function(np.where(refused, 1.0, total))}, refused

    inputs = {"a": Normal(mean, 0.5), "b": Normal(0.1, 0.4), "c": Normal(-0.1, 0.3)}
    spread = propagate(model, inputs, {("a", "b"): 0.999}, shares=False).spreads["result"]
    total = NormalDist(mean, (0.25 + 0.16 + 0.09 + 2.0 * 0.999 * 0.5 * 0.4) ** 0.5)
    admissible = 1.0 - total.cdf(0.0)
    assert spread.admissible == pytest.approx(admissible, abs=1e-4)
    for p, found in ((0.025, spread.interval[0]), (0.5, spread.median), (0.975, spread.interval[1])):
        assert (1.0 - total.cdf(inverse(found))) / admissible == pytest.approx(p, abs=1e-3)
