"""Nested integrals over inputs of any shape: against closed forms, and declined where they do not apply."""

import numpy as np
import pytest
from scipy import stats

from dynamics_cli.core.inputs.uncertain.distributions import (
    Distribution,
    Lognormal,
    Normal,
    StudentT,
    Triangular,
    Truncated,
    Uniform,
)
from dynamics_cli.core.uncertainty.axes import COARSE, FINE, Axis, points
from dynamics_cli.core.uncertainty.propagation import propagate

READINGS = (0.71, 0.74, 0.70, 0.69, 0.72, 0.75, 0.70)
SHAPES: list[Distribution] = [
    Normal(1.0, 0.2), Lognormal(1.0, 0.2), Uniform(0.5, 1.5), Triangular(0.0, 0.3, 2.0), Triangular(0.0, 0.0, 2.0),
    Triangular(0.0, 2.0, 2.0), Truncated(1.0, 0.5, 0.2, 2.5), Truncated(0.0, 0.1, 0.2, 0.9), StudentT(READINGS),
]  # fmt: skip
NAME = "nested integrals"


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: f"{shape.name} {shape.mean:.3g}")
class TestAxes:
    @pytest.mark.parametrize("count", [COARSE, FINE])
    def test_probabilities_add_up_and_give_the_moments(self, shape: Distribution, count: int) -> None:
        axis = Axis(shape)
        for roots in (np.empty((1, 0)), np.full((1, 1), 0.3 * axis.cuts[0] + 0.7 * axis.cuts[-1])):
            _, t, weight = points(axis, roots, count)
            value = axis.value(t)
            mean = weight @ value
            loose = 2e-3 if count == COARSE else 2e-5
            assert weight.sum() == pytest.approx(1.0, abs=loose)
            assert mean == pytest.approx(shape.mean, abs=loose * shape.std + 1e-6 * abs(shape.mean))
            assert np.sqrt(weight @ (value - mean) ** 2) == pytest.approx(shape.std, rel=5 * loose)

    def test_the_distribution_function_is_that_of_the_quantiles(self, shape: Distribution) -> None:
        axis = Axis(shape)
        z = np.linspace(-3.0, 3.0, 25)
        t = shape.at(z) if axis.bounded else z
        assert axis.below(t) == pytest.approx(stats.norm.cdf(z), abs=1e-12)
        h = 1e-6 * (axis.cuts[-1] - axis.cuts[0])
        inner = (t > axis.cuts[0] + 2 * h) & (t < axis.cuts[-1] - 2 * h)
        steep = (axis.below(t[inner] + h) - axis.below(t[inner] - h)) / (2.0 * h)
        assert axis.density(t[inner]) == pytest.approx(steep, rel=1e-4, abs=1e-5)


def spread(model, inputs: dict, **more):
    made = propagate(lambda x: ({"y": model(x)}, None), inputs, shares=False, accuracy=1e-4, **more)
    return made.spreads["y"]


def below_normal_and_uniform(x: float, sigma: float) -> float:
    """P(a + u ≤ x) for a normal a about zero and u between 0 and 1: ∫ Φ((x − u)/σ) du by its antiderivative."""

    def inner(t: float) -> float:
        return t * stats.norm.cdf(t) + stats.norm.pdf(t)

    return sigma * (inner(x / sigma) - inner((x - 1.0) / sigma))


class TestClosedForms:
    def test_the_sum_of_two_uniforms_is_a_triangle(self) -> None:
        made = spread(lambda x: x["a"] + x["b"], {"a": Uniform(0.0, 1.0), "b": Uniform(0.0, 1.0)})
        assert made.method.startswith(NAME)
        assert made.interval == pytest.approx((np.sqrt(0.05), 2.0 - np.sqrt(0.05)), abs=4e-6)
        assert (made.median, made.mean, made.std) == pytest.approx((1.0, 1.0, np.sqrt(1.0 / 6.0)), abs=4e-6)

    def test_the_difference_of_three_uniforms(self) -> None:
        """Irwin and Hall's distribution, moved: P(s ≤ x) = x³/6 below one."""
        made = spread(lambda x: x["a"] - x["b"] + x["c"], {name: Uniform(0.0, 1.0) for name in "abc"})
        assert made.method.startswith(NAME)
        low = (6.0 * 0.025) ** (1.0 / 3.0) - 1.0
        assert made.interval == pytest.approx((low, 1.0 - low), abs=6e-6)
        assert (made.median, made.std) == pytest.approx((0.5, 0.5), abs=6e-6)

    def test_the_product_of_two_uniforms(self) -> None:
        """P(u·v ≤ x) = x − x·ln x."""
        made = spread(lambda x: x["a"] * x["b"], {"a": Uniform(0.0, 1.0), "b": Uniform(0.0, 1.0)})
        share = made.median - made.median * np.log(made.median)
        assert share == pytest.approx(0.5, abs=3e-5)
        assert made.mean == pytest.approx(0.25, abs=1e-5)

    def test_a_normal_and_a_uniform(self) -> None:
        """Their sum has P(x) = ∫ Φ((x − u)/σ) du, by its antiderivative."""
        sigma = 0.1
        made = spread(lambda x: x["a"] + x["b"], {"a": Normal(0.0, sigma), "b": Uniform(0.0, 1.0)})

        shares = [below_normal_and_uniform(x, sigma) for x in (*made.interval, made.median)]
        assert shares == pytest.approx([0.025, 0.975, 0.5], abs=1e-5)


class TestInadmissibleBelow:
    def test_what_is_left_is_taken_as_the_whole(self) -> None:
        """√(a + b) of a normal and a uniform: inadmissible where their sum, known in closed form, is below zero."""
        mean, sigma = 1.4, 0.4

        def model(x):
            with np.errstate(invalid="ignore"):
                return np.sqrt(x["a"] + x["b"])

        made = spread(model, {"a": Normal(mean, sigma), "b": Uniform(0.0, 1.0)})
        refused = below_normal_and_uniform(-mean, sigma)
        assert 1e-6 < refused < 1e-4
        assert made.method.startswith(NAME)
        assert made.admissible == pytest.approx(1.0 - refused, abs=1e-7)
        shares = [below_normal_and_uniform(v * v - mean, sigma) for v in (*made.interval, made.median)]
        assert [(share - refused) / (1.0 - refused) for share in shares] == pytest.approx([0.025, 0.975, 0.5], abs=1e-5)

    def test_behind_a_bounded_input_other_methods_answer(self) -> None:
        def model(x):
            with np.errstate(invalid="ignore"):
                return np.sqrt(x["a"] + x["b"] - 0.01)

        made = spread(model, {"a": Uniform(0.0, 1.0), "b": Uniform(0.0, 1.0)})
        assert not made.method.startswith(NAME)
        assert made.admissible == pytest.approx(1.0 - 0.5e-4, abs=2e-5)


class TestDeclined:
    @pytest.mark.parametrize(
        ("model", "inputs", "more"),
        [
            (lambda x: (x["a"] - 0.5) ** 2 + x["b"], {"a": Uniform(0.0, 1.0), "b": Uniform(0.0, 1.0)}, {}),
            (lambda x: x["a"] + x["b"], {"a": Normal(0.0, 1.0), "b": Normal(0.0, 1.0)}, {}),
            (lambda x: x["a"] + x["b"], {"a": Uniform(0.0, 1.0), "b": Uniform(0.0, 1.0)},
             {"correlation": {("a", "b"): 0.5}}),
            (lambda x: x["a"] + x["b"] + x["c"] + x["d"], {name: Uniform(0.0, 1.0) for name in "abcd"}, {}),
            (lambda x: x["a"] + x["b"], {"a": Uniform(0.0, 1.0), "b": StudentT((1.0, 1.1, 0.9))}, {}),
        ],
    )  # fmt: skip
    def test_other_methods_answer(self, model, inputs, more) -> None:
        made = spread(model, inputs, **more)
        assert not made.method.startswith(NAME)
        assert made.interval[0] < made.median < made.interval[1]

    def test_a_finer_answer_is_another_methods(self) -> None:
        inputs = {"a": Uniform(0.0, 1.0), "b": Uniform(0.0, 1.0)}
        made = propagate(lambda x: ({"y": x["a"] + x["b"]}, None), inputs, shares=False, accuracy=1e-8).spreads["y"]
        assert not made.method.startswith(NAME)

    def test_limits_and_curves_come_from_the_same_integrals(self) -> None:
        inputs = {"a": Uniform(0.0, 1.0), "b": Uniform(0.0, 1.0)}
        made = spread(lambda x: x["a"] + x["b"], inputs, limits={"y": [0.5, 1.0, 5.0]}, curve=True)
        assert [chance for _, chance in made.beyond] == pytest.approx([0.875, 0.5, 0.0], abs=1e-6)
        values, below = map(np.array, made.cumulative)
        triangle = np.where(values < 1.0, np.clip(values, 0, 2) ** 2 / 2, 1.0 - (2.0 - np.clip(values, 0, 2)) ** 2 / 2)
        assert below == pytest.approx(triangle, abs=1e-6)
