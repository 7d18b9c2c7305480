"""Many results of one model, some with kinks, some of one input, some on a straight line with others."""

import math

import numpy as np
import pytest

from dynamics_cli.core.inputs.uncertain.distributions import Empirical, Normal, Uniform
from dynamics_cli.core.uncertainty.methods.lines import Lines, alone, order_moments, side_by_side
from dynamics_cli.core.uncertainty.propagation import propagate
from dynamics_cli.core.uncertainty.space import Space, bearing
from dynamics_cli.core.uncertainty.straight import Straight
from dynamics_cli.numerics.distributions import normal
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature.lattice import lattice

P = np.array([0.025, 0.5, 0.975])
Z = [normal.quantile(p) for p in P.tolist()]
# χ² of three degrees of freedom
CHI = [0.2157952826238983, 2.3659738843753377, 9.348403604496148]
LARGEST = [normal.quantile(math.sqrt(p)) for p in P.tolist()]


def model(inputs: dict) -> tuple[dict, None]:
    a, b, c = (np.asarray(inputs[name], dtype=float) for name in "abc")
    return {
        "distance": a * a + b * b + c * c,
        "largest": np.maximum(a, b),
        "more": 7.0 - 3.0 * np.maximum(a, b),
        "sum": a - b + 2.0 * c,
        "step": np.where(a + 0.3 * b > 0.0, 1.0, -1.0),
        "other": np.abs(a) + 0.2 * c,
    }, None


def space(count: int = 3) -> Space:
    made = Space(model, dict.fromkeys("abc"[:count], Normal(0.0, 1.0)), {})
    made.evaluate(np.zeros((count, 1)))
    return made


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_results_with_kinks_share_a_sample_within_what_is_stated(seed: int) -> None:
    made = propagate(model, dict.fromkeys("abc", Normal(0.0, 1.0)), seed=seed, shares=False)
    assert "one sample" in made.spreads["distance"].method
    for name, exact in (("distance", CHI), ("largest", LARGEST)):
        spread = made.spreads[name]
        off = np.abs(np.array([*spread.interval, spread.median]) - [exact[0], exact[2], exact[1]]).max() / spread.std
        assert off <= spread.estimate <= 0.02


def test_what_is_partly_inadmissible_is_given_the_rest() -> None:
    def partly(inputs: dict) -> tuple[dict, np.ndarray]:
        results, _ = model(inputs)
        return results, np.broadcast_to(np.asarray(inputs["a"] > 0.0), np.shape(results["sum"]))

    made = propagate(partly, dict.fromkeys("abc", Normal(0.0, 1.0)))
    spread = made.spreads["distance"]
    assert spread.admissible == pytest.approx(0.5, abs=1e-3)
    assert spread.median == pytest.approx(CHI[1], abs=2.0 * spread.estimate * spread.std)


def test_a_limit_has_its_probability_by_the_sample() -> None:
    made = propagate(model, dict.fromkeys("abc", Normal(0.0, 1.0)), limits={"distance": [CHI[2]]})
    assert made.spreads["distance"].beyond[0][1] == pytest.approx(0.025, abs=1e-3)


def test_a_result_on_a_straight_line_with_another_has_its_distribution() -> None:
    made = propagate(model, dict.fromkeys("abc", Normal(0.0, 1.0)))
    one, other = made.spreads["largest"], made.spreads["more"]
    assert other.median == pytest.approx(7.0 - 3.0 * one.median, rel=1e-12)
    assert other.interval == pytest.approx((7.0 - 3.0 * one.interval[1], 7.0 - 3.0 * one.interval[0]), rel=1e-12)
    assert other.std == pytest.approx(3.0 * one.std, rel=1e-12)


def test_a_result_that_leaves_the_line_now_and_then_is_not_on_it() -> None:
    def rarely(inputs: dict) -> tuple[dict, None]:
        a, b = (np.asarray(inputs[name], dtype=float) for name in "ab")
        more = {"d": a * a, "e": b * b}
        return {"a": a + b, "b": 2.0 * (a + b) + np.where(a > 2.0, 1.0, 0.0), "c": 1.0 - (a + b), **more}, None

    made = Space(rarely, dict.fromkeys("ab", Normal(0.0, 1.0)), {})
    probe = made.evaluate(np.linspace(-1.0, 1.0, 10).reshape(2, 5))
    straight = Straight(made, probe, 1)
    assert straight.of(1)[0] == ""
    assert straight.of(2) == ("a", pytest.approx(-1.0), pytest.approx(1.0))


def test_one_bounded_input_through_many_results_that_turn() -> None:
    def turning(inputs: dict) -> tuple[dict, None]:
        a = np.asarray(inputs["a"], dtype=float)
        return {f"r{k}": (a - 0.1 * k) ** 2 for k in range(6)}, None

    made = propagate(turning, {"a": Uniform(-1.0, 1.0)})
    # |a| is uniform from 0 to 1
    spread = made.spreads["r0"]
    assert spread.interval == pytest.approx((0.025**2, 0.975**2), abs=spread.estimate * spread.std)
    assert spread.estimate < 5e-4


def test_listed_values_among_normal_inputs_are_a_mixture() -> None:
    def total(inputs: dict) -> tuple[dict, None]:
        return {"sum": inputs["a"] + inputs["b"] + inputs["c"]}, None

    values = (0.0, 0.7, 3.0)
    given = {"a": Normal(1.0, 0.3), "b": Empirical(values), "c": Normal(0.0, 0.4)}
    spread = propagate(total, given).spreads["sum"]
    assert "3 listed or bounded values" in spread.method

    def below(v: float) -> float:
        return sum(normal.upper((1.0 + value - v) / 0.5) for value in values) / 3.0

    for found, p in ((spread.interval[0], 0.025), (spread.median, 0.5), (spread.interval[1], 0.975)):
        assert below(found) == pytest.approx(p, abs=1e-5)
    mean = sum(values) / 3.0
    assert spread.mean == pytest.approx(1.0 + mean, rel=1e-9)
    assert spread.std == pytest.approx(math.sqrt(0.25 + sum((x - mean) ** 2 for x in values) / 3.0), rel=1e-6)


def test_an_input_that_does_not_bear_on_a_result_is_not_integrated_over() -> None:
    """Of four inputs one result has one, one has two: exact as if the others were not there."""

    def model(inputs: dict) -> tuple[dict, None]:
        a, b, c, d = (np.asarray(inputs[name], dtype=float) for name in "abcd")
        results = {"one": np.exp(0.1 * b), "two": b + 2.0 * d, "turning": c * c, "all": a + b + c + d, "other": a - d}
        return results, None

    looked_at = Space(model, dict.fromkeys("abcd", Normal(0.0, 1.0)), {})
    assert bearing(looked_at, quantile(lattice(4, 64, 2))).tolist() == [
        [False, True, False, False], [False, True, False, True], [False, False, True, False], [True] * 4,
        [True, False, False, True],
    ]  # fmt: skip
    made = propagate(model, dict.fromkeys("abcd", Normal(0.0, 1.0)))
    assert made.spreads["one"].method == "the input's own quantiles through the model"
    assert made.spreads["one"].interval == pytest.approx((math.exp(0.1 * Z[0]), math.exp(0.1 * Z[2])), rel=1e-12)
    assert made.spreads["two"].interval == pytest.approx((math.sqrt(5.0) * Z[0], math.sqrt(5.0) * Z[2]), rel=1e-9)
    turning = made.spreads["turning"]
    # χ² of one degree of freedom
    assert (*turning.interval, turning.median) == pytest.approx(
        (9.820691e-4, 5.023886, 0.4549364), abs=turning.estimate
    )
    assert turning.mean == pytest.approx(1.0, abs=turning.estimate)
    assert turning.std == pytest.approx(math.sqrt(2.0), abs=turning.estimate * turning.std)
    assert turning.estimate < 1e-3


def test_calculations_side_by_side_are_those_of_each_alone() -> None:
    model_at = space()
    direction = np.array([1.0, 0.0, 0.0])
    made = {row: Lines(model_at, row, direction, np.zeros((3, 1)), np.zeros((1, 1)), np.ones(1)) for row in (0, 3)}
    together = side_by_side({row: order_moments(lines, 12) for row, lines in made.items()})
    for row, lines in made.items():
        assert together[row].mean == alone(order_moments(lines, 12)).mean


def test_many_bounded_inputs_are_not_taken_value_by_value() -> None:
    """Fifteen uniform inputs beside a normal one: as many values of all of them together would fill any memory."""
    names = [f"x{i}" for i in range(15)]
    inputs: dict = {"z": Normal(0.0, 1.0)} | dict.fromkeys(names, Uniform(-1.0, 1.0))
    made = propagate(lambda at: ({"sum": sum(at.values())}, None), inputs, accuracy=0.01, shares=False)
    assert abs(made.spreads["sum"].std - math.sqrt(6.0)) < 0.05


class Few:
    """The model of six results, of which one is asked for."""

    results = 6

    def __init__(self, name: str) -> None:
        self.name = name

    def __call__(self, inputs: dict) -> tuple[dict, None]:
        return {self.name: model(inputs)[0][self.name]}, None


@pytest.mark.parametrize("name", ["largest", "distance", "sum"])
def test_one_result_alone_has_the_method_and_numbers_that_it_has_among_all(name: str) -> None:
    inputs = dict.fromkeys("abc", Normal(0.0, 1.0))
    one, among = (propagate(each, inputs, shares=False).spreads[name] for each in (Few(name), model))
    assert one.method == among.method
    assert (*one.interval, one.median, one.std) == pytest.approx((*among.interval, among.median, among.std), rel=1e-12)
