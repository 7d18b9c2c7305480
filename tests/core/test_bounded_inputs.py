"""Inputs between bounds against closed forms, within what the answer states."""

import numpy as np
import pytest
from scipy import stats

from dynamics_cli.core.inputs.uncertain.distributions import Normal, Uniform
from dynamics_cli.core.uncertainty.propagation import propagate

UNIT = Uniform(0.0, 1.0)


def spread(model, inputs: dict, **more):
    made = propagate(lambda x: ({"y": model(x)}, None), inputs, shares=False, accuracy=1e-4, **more)
    assert made.spreads["y"].estimate <= 1e-4
    return made.spreads["y"]


def agrees(made, low: float, median: float, high: float) -> None:
    """The interval and the median lie within the stated share of the standard deviation."""
    assert (made.interval[0], made.median, made.interval[1]) == pytest.approx(
        (low, median, high), abs=made.estimate * made.std
    )


def below_normal_and_uniform(x: float, sigma: float) -> float:
    """P(a + u ≤ x) for a normal a about zero and u between 0 and 1: ∫ Φ((x − u)/σ) du by its antiderivative."""

    def inner(t: float) -> float:
        return t * stats.norm.cdf(t) + stats.norm.pdf(t)

    return sigma * (inner(x / sigma) - inner((x - 1.0) / sigma))


def slope(share, x: float, h: float = 1e-5) -> float:
    return (share(x + h) - share(x - h)) / (2.0 * h)


def test_the_sum_of_two_uniforms_is_a_triangle() -> None:
    made = spread(lambda x: x["a"] + x["b"], {"a": UNIT, "b": UNIT})
    agrees(made, np.sqrt(0.05), 1.0, 2.0 - np.sqrt(0.05))
    assert (made.mean, made.std) == pytest.approx((1.0, np.sqrt(1.0 / 6.0)), abs=made.estimate * made.std)


def test_the_difference_of_three_uniforms() -> None:
    """Irwin and Hall's distribution, moved: P(s ≤ x) = (x + 1)³/6 below zero."""
    made = spread(lambda x: x["a"] - x["b"] + x["c"], dict.fromkeys("abc", UNIT))
    low = (6.0 * 0.025) ** (1.0 / 3.0) - 1.0
    agrees(made, low, 0.5, 1.0 - low)


def test_the_product_of_two_uniforms() -> None:
    """P(u·v ≤ x) = x − x·ln x."""
    made = spread(lambda x: x["a"] * x["b"], {"a": UNIT, "b": UNIT})
    for value, share in zip((made.interval[0], made.median, made.interval[1]), (0.025, 0.5, 0.975), strict=True):
        density = -np.log(value)
        assert value - value * np.log(value) == pytest.approx(share, abs=made.estimate * made.std * density)


@pytest.mark.parametrize("sigma", [0.02, 0.1, 1.0])
def test_a_normal_and_a_uniform(sigma: float) -> None:
    made = spread(lambda x: x["a"] + x["b"], {"a": Normal(0.0, sigma), "b": UNIT})

    def share(x: float) -> float:
        return below_normal_and_uniform(x, sigma)

    for value, wanted in zip((made.interval[0], made.median, made.interval[1]), (0.025, 0.5, 0.975), strict=True):
        assert share(value) == pytest.approx(wanted, abs=made.estimate * made.std * slope(share, value))


def test_what_is_left_of_inadmissible_values_is_taken_as_the_whole() -> None:
    """√(a + b) of a normal and a uniform: inadmissible where their sum, known in closed form, is below zero."""
    mean, sigma = 1.4, 0.4

    def model(x):
        with np.errstate(invalid="ignore"):
            return np.sqrt(x["a"] + x["b"])

    made = spread(model, {"a": Normal(mean, sigma), "b": UNIT})
    refused = below_normal_and_uniform(-mean, sigma)
    assert 1e-6 < refused < 1e-4
    assert made.admissible == pytest.approx(1.0 - refused, abs=1e-5)

    def share(value: float) -> float:
        return (below_normal_and_uniform(value * value - mean, sigma) - refused) / (1.0 - refused)

    for value, wanted in zip((made.interval[0], made.median, made.interval[1]), (0.025, 0.5, 0.975), strict=True):
        assert share(value) == pytest.approx(wanted, abs=made.estimate * made.std * slope(share, value))


def test_limits_and_curves() -> None:
    inputs = {"a": UNIT, "b": UNIT}
    made = spread(lambda x: x["a"] + x["b"], inputs, limits={"y": [0.5, 1.0, 5.0]}, curve=True)
    assert [chance for _, chance in made.beyond] == pytest.approx([0.875, 0.5, 0.0], abs=1e-6)
    values, below = (np.clip(column, 0.0, 2.0) for column in map(np.array, made.cumulative))
    triangle = np.where(values < 1.0, values**2 / 2, 1.0 - (2.0 - values) ** 2 / 2)
    assert below == pytest.approx(triangle, abs=1e-4)
