"""The engine of uncertainty on models that stand in for families: against references found in other ways."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import uncertain_models as m
from scipy import integrate, optimize, stats

from dynamics_cli.core.inputs.uncertain.distributions import (
    Distribution,
    Empirical,
    Lognormal,
    Normal,
    StudentT,
    Truncated,
    Uniform,
)
from dynamics_cli.core.uncertainty.propagation import METHODS, Propagation, Spread, propagate
from dynamics_cli.errors import InadmissibleError, UsageError

Problem = tuple[Callable[[dict[str, Any]], Any], dict[str, Distribution]]
PROBLEMS: dict[str, Problem] = {
    "skid": (m.skid, m.SKID),
    "momentum": (m.momentum, m.MOMENTUM),
    "surfaces": (m.surfaces, m.SURFACES),
    "cam": (m.cam, m.TOLERANCES),
    "gear": (m.gear, m.GEAR),
    "impact": (m.impact, m.IMPACT),
}


def run(function: Any, inputs: Any, *args: Any, **more: Any) -> Propagation:
    return propagate(m.model_of(function), inputs, *args, **more)


def only(function: Any, inputs: Any, *args: Any, **more: Any) -> Spread:
    return next(iter(run(function, inputs, *args, **more).spreads.values()))


def skid_probability(v: float) -> float:
    """P(speed ≤ v): solved for the friction, averaged over the others by adaptive quadrature."""

    def inner(z_d: float, z_t: float) -> float:
        d, theta = 38.5 + 0.6 * z_d, -0.03 + 0.005 * z_t
        friction = (v * v / (2.0 * m.G * d) - math.sin(theta)) / math.cos(theta)
        return float(stats.norm.cdf((friction - 0.72) / 0.04) * stats.norm.pdf(z_d) * stats.norm.pdf(z_t))

    return float(integrate.dblquad(inner, -8.5, 8.5, -8.5, 8.5, epsabs=1e-10, epsrel=1e-9)[0])


def test_a_skid_of_three_normal_inputs_to_1e8() -> None:
    spread = only(m.skid, m.SKID, accuracy=1e-8)
    assert spread.estimate <= 1e-8
    for end, p in zip((*spread.interval, spread.median), (0.025, 0.975, 0.5), strict=True):
        assert abs(skid_probability(end) - p) < 1e-9


@pytest.mark.parametrize("name", PROBLEMS)
def test_the_choice_agrees_with_a_large_sample(name: str) -> None:
    function, inputs = PROBLEMS[name]
    made = run(function, inputs, accuracy=1e-3)
    sample = run(function, inputs, method="monte-carlo", samples=400_000)
    for key, spread in made.spreads.items():
        other = sample.spreads[key]
        assert spread.estimate <= 1.1e-3
        allowed = (1.7 * other.estimate + spread.estimate) * other.std
        for found, rough in zip((*spread.interval, spread.mean), (*other.interval, other.mean), strict=True):
            assert abs(found - rough) <= allowed


@pytest.mark.parametrize("method", METHODS)
def test_every_method_answers_within_its_own_estimate(method: str) -> None:
    exact = only(m.skid, m.SKID, accuracy=1e-9)
    spread = only(m.skid, m.SKID, method=method, samples=200_000)
    far = max(abs(a - b) for a, b in zip(spread.interval, exact.interval, strict=True)) / exact.std
    assert far <= 1.5 * spread.estimate + 1e-12
    assert spread.estimate < 0.1


def test_one_input_is_exact() -> None:
    spread = only(lambda x: np.sqrt(x["a"]), {"a": Lognormal(4.0, 1.0)})
    low, high = Lognormal(4.0, 1.0).interval(0.95)
    assert spread.interval == pytest.approx((math.sqrt(low), math.sqrt(high)), rel=1e-14)


def test_one_input_that_turns() -> None:
    spread = only(lambda x: x["a"] * x["a"], {"a": Normal(0.3, 1.0)}, limits={"result": [1.0]})
    law = stats.ncx2(1, 0.09)
    assert spread.interval == pytest.approx((law.ppf(0.025), law.ppf(0.975)), rel=1e-8)
    assert spread.mean == pytest.approx(1.09, rel=1e-9)
    assert spread.beyond[0][1] == pytest.approx(law.sf(1.0), rel=1e-9)


def test_one_listed_input_is_counted() -> None:
    spread = only(lambda x: x["a"] ** 2, {"a": Empirical([1, 2, 3, 4, -1])}, limits={"result": [1.0]})
    assert (spread.median, spread.interval) == (4.0, (1.0, 16.0))
    assert spread.beyond == [(1.0, pytest.approx(0.6))]


def test_no_deviation_is_a_certain_input() -> None:
    certain = {"mu": Normal(0.72, 0.0), "d": Normal(38.5, 0.0), "theta": Normal(-0.03, 0.0)}
    spread = only(m.skid, certain)
    assert spread.std == 0.0
    assert spread.interval[0] == spread.median == spread.interval[1]
    assert only(m.skid, {**certain, "mu": Normal(0.72, 0.04)}).method.startswith("the input's own")


def test_sums_of_normals_are_normal_whatever_their_correlation() -> None:
    inputs = {name: Normal(0.0, 1.0) for name in "abc"}

    def weighted(x: dict[str, Any]) -> Any:
        return x["a"] + 2.0 * x["b"] - x["c"]

    rho = {("a", "b"): 0.5, ("b", "c"): -0.3}
    spread = only(weighted, inputs, rho)
    assert spread.std == pytest.approx(math.sqrt(1 + 4 + 1 + 2 * 2 * 0.5 + 2 * 2 * 0.3), rel=1e-10)
    assert spread.interval[1] == pytest.approx(spread.std * stats.norm.ppf(0.975), rel=1e-9)
    assert sum(spread.first) == pytest.approx(1.0)


def test_nearly_singular_correlation() -> None:
    inputs = {"a": Normal(1.0, 0.1), "b": Normal(1.0, 0.1)}
    near = only(lambda x: x["a"] * x["b"], inputs, {("a", "b"): 0.999999})
    whole = only(lambda x: x["a"] * x["b"], inputs, {("a", "b"): 1.0})
    square = only(lambda x: x["a"] * x["a"], {"a": Normal(1.0, 0.1)})
    assert near.interval == pytest.approx(square.interval, abs=1e-4)
    assert whole.interval == pytest.approx(square.interval, abs=1e-9)


def test_a_correlation_that_cannot_be_is_named() -> None:
    inputs = {name: Normal(0.0, 1.0) for name in "abc"}
    rho = {("a", "b"): 0.9, ("b", "c"): 0.9, ("a", "c"): -0.9}
    with pytest.raises(UsageError, match="contradicts the others") as caught:
        only(lambda x: x["a"] + x["b"] + x["c"], inputs, rho)
    assert "can range from" in str(caught.value.hint)
    with pytest.raises(UsageError, match="is not an uncertain input"):
        only(lambda x: x["a"] + x["b"] + x["c"], inputs, {("a", "x"): 0.5})


def drag(x: dict[str, Any]) -> Any:
    return np.sqrt(2.0 * m.G * x["d"] * (x["mu"] + x["G"]))


def test_partly_inadmissible_is_conditioned_and_said() -> None:
    spread = only(drag, {"d": Normal(30.0, 1.0), "mu": Normal(0.1, 0.03), "G": Normal(-0.06, 0.01)})
    share = stats.norm.cdf(0.04 / math.hypot(0.03, 0.01))
    assert spread.admissible == pytest.approx(share, abs=1e-5)

    def below(v: float) -> float:
        def inner(d: float) -> float:
            top = stats.norm.cdf((v * v / (2.0 * m.G * d) - 0.04) / math.hypot(0.03, 0.01)) - (1.0 - share)
            return float(top * stats.norm.pdf(d, 30.0, 1.0))

        return float(integrate.quad(inner, 22.0, 38.0)[0]) / share

    exact = optimize.brentq(lambda v: below(v) - 0.025, 0.1, 9.0, xtol=1e-10)
    assert spread.interval[0] == pytest.approx(exact, abs=2e-4 * spread.std)


def test_nothing_admissible_is_refused() -> None:
    with pytest.raises(InadmissibleError, match="no case"):
        only(drag, {"d": Normal(30.0, 1.0), "mu": Normal(0.1, 1e-4), "G": Normal(-0.6, 1e-4)})


def test_an_atom_is_found_to_its_value() -> None:
    spread = only(m.impact_rest, m.IMPACT, accuracy=2e-3)
    assert spread.median == pytest.approx(1e-12, rel=1e-6)
    sample = only(m.impact_rest, m.IMPACT, method="monte-carlo", samples=400_000)
    assert spread.interval[1] == pytest.approx(sample.interval[1], abs=2.0 * sample.estimate * sample.std)


def test_a_jump_inside_the_range() -> None:
    def jump(x: dict[str, Any]) -> Any:
        return np.where(x["a"] > x["b"], 1.0, 0.0) * x["c"] + x["a"]

    inputs = {"a": Normal(0.0, 1.0), "b": Normal(0.3, 0.5), "c": Normal(2.0, 0.1)}
    spread = only(jump, inputs, accuracy=1e-3)
    sample = only(jump, inputs, method="monte-carlo")
    assert spread.interval == pytest.approx(sample.interval, abs=(2.0 * sample.estimate + 1e-3) * sample.std)


def test_a_model_that_is_flat_or_turns_in_several_inputs() -> None:
    spread = only(lambda x: np.hypot(x["x"], x["y"]), {"x": Normal(0.0, 1.0), "y": Normal(0.1, 1.0)}, accuracy=1e-3)
    law = stats.rice(0.1)
    exact = (law.ppf(0.025), law.ppf(0.975))
    assert spread.interval == pytest.approx(exact, abs=1.5e-3 * spread.std)
    assert spread.mean == pytest.approx(law.mean(), abs=1.5e-3 * spread.std)


def test_bounded_inputs_stay_in_their_range() -> None:
    inputs = {name: Uniform(0.0, 1.0) for name in "ab"}
    spread = only(lambda x: x["a"] + x["b"], inputs, coverage=0.9)
    assert spread.interval == pytest.approx((math.sqrt(0.1), 2.0 - math.sqrt(0.1)), abs=2e-4)
    assert spread.corners is not None
    assert 0.0 < spread.corners[0] < spread.interval[0]


def test_few_readings_have_no_deviation_but_an_interval() -> None:
    spread = only(m.skid, {**m.SKID, "mu": StudentT([0.71, 0.74, 0.70])})
    assert math.isnan(spread.std)
    assert spread.interval == pytest.approx((21.83235, 23.67330), abs=2e-4)


def test_variance_shares_of_a_known_function() -> None:
    """Ishigami's function in disguise: shares known in closed form (uniform inputs on ±π, a = 7, b = 0.1)."""
    inputs = {name: Uniform(-math.pi, math.pi) for name in "abc"}

    def ishigami(x: dict[str, Any]) -> Any:
        return np.sin(x["a"]) + 7.0 * np.sin(x["b"]) ** 2 + 0.1 * x["c"] ** 4 * np.sin(x["a"])

    spread = only(ishigami, inputs, accuracy=1e-2)
    assert spread.first == pytest.approx([0.3139, 0.4424, 0.0], abs=0.02)
    assert spread.total == pytest.approx([0.5576, 0.4424, 0.2437], abs=0.02)


def test_shares_of_two_results_and_their_correlation() -> None:
    made = run(m.momentum, m.MOMENTUM)
    assert made.correlation is not None
    sample = run(m.momentum, m.MOMENTUM, method="monte-carlo", samples=100_000)
    assert sample.correlation is not None
    assert made.correlation[0, 1] == pytest.approx(sample.correlation[0, 1], abs=0.02)
    assert sum(made.spreads["v1"].first) == pytest.approx(1.0, abs=0.01)


def test_the_same_seed_gives_the_same_numbers() -> None:
    one, two = (only(m.impact, m.IMPACT, accuracy=1e-2, seed=5) for _ in range(2))
    other = only(m.impact, m.IMPACT, accuracy=1e-2, seed=6)
    assert one.interval == two.interval
    assert one.interval != other.interval


@pytest.mark.slow
def test_twenty_mixed_inputs() -> None:
    spread = only(m.mixed20, m.mixed20_inputs(), accuracy=1e-3)
    assert spread.estimate <= 1e-3
    sample = only(m.mixed20, m.mixed20_inputs(), method="monte-carlo", samples=300_000)
    assert spread.interval == pytest.approx(sample.interval, abs=2.0 * sample.estimate * sample.std)


def test_truncated_inputs_far_in_the_tail() -> None:
    law = Truncated(0.0, 1.0, 5.0, 6.0)
    assert law.mean == pytest.approx(stats.truncnorm(5.0, 6.0).mean(), rel=1e-9)
    spread = only(lambda x: 2.0 * x["a"], {"a": law})
    assert spread.interval[0] == pytest.approx(2.0 * stats.truncnorm(5.0, 6.0).ppf(0.025), rel=1e-9)


def test_a_method_that_does_not_exist() -> None:
    with pytest.raises(UsageError, match="no method"):
        only(m.skid, m.SKID, method="guess")
