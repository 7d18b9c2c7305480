"""Polynomials that stand in for a slow model, against distributions known in closed form."""

import math

import numpy as np
import pytest

from dynamics_cli.core.inputs.uncertain.distributions import Normal, Uniform
from dynamics_cli.core.uncertainty.methods.outcome import FAIR
from dynamics_cli.core.uncertainty.propagation import Propagation, propagate
from dynamics_cli.numerics.distributions import normal
from dynamics_cli.sampling import Drawing

P = (0.025, 0.5, 0.975)
Z = [normal.quantile(p) for p in P]


class Slow:
    """A model that is asked case by case; counts what it is asked."""

    arrays = False

    def __init__(self) -> None:
        self.asked = 0

    def __call__(self, inputs: dict) -> tuple[dict, np.ndarray | None]:
        a, b, c = (np.broadcast_to(inputs[name], np.shape(inputs["a"])) for name in "abc")
        self.asked += len(a)
        return {
            "power": np.exp(0.1 * (a + b + c)),
            "ratio": (10.0 + a) / 2.0,
            "distance": a * a + b * b + c * c,
            "tilted": a + 0.2 * (b * b - 1.0),
            "sum": a - b + 2.0 * c,
            "bend": np.maximum(a, b),
        }, None


EXACT = {
    "power": [math.exp(0.1 * math.sqrt(3.0) * z) for z in Z],
    "ratio": [5.0 + 0.5 * z for z in Z],
    # χ² of three degrees of freedom
    "distance": [0.2157952826238983, 2.3659738843753377, 9.348403604496148],
    "sum": [math.sqrt(6.0) * z for z in Z],
    "bend": [normal.quantile(math.sqrt(p)) for p in P],
}


def worst(made: Propagation, name: str) -> float:
    """The largest error of the three quantiles, in deviations."""
    spread = made.spreads[name]
    found = (spread.interval[0], spread.median, spread.interval[1])
    return max(abs(a - b) for a, b in zip(found, EXACT[name], strict=True)) / spread.std


@pytest.mark.parametrize("seed", range(1, 6))
def test_few_calls_serve_all_results_and_the_stated_error_holds(seed: int) -> None:
    model = Slow()
    made = propagate(model, dict.fromkeys("abc", Normal(0.0, 1.0)), seed=seed, samples=20_000, accuracy=1e-3)
    for name in EXACT:
        assert worst(made, name) <= made.spreads[name].estimate, name
        if name != "bend":
            assert "on polynomials of degree 6 fitted to 256 calls" in made.spreads[name].method, name
            assert made.spreads[name].estimate < (0.05 if name == "distance" else 5e-3), name
    assert "one sample for all results" in made.spreads["bend"].method
    assert model.asked < 20_000


def test_without_kinks_hundreds_of_calls_do() -> None:
    class Smooth(Slow):
        def __call__(self, inputs: dict) -> tuple[dict, None]:
            results, _ = super().__call__(inputs)
            return {name: value for name, value in results.items() if name != "bend"}, None

    model = Smooth()
    made = propagate(model, dict.fromkeys("abc", Normal(0.0, 1.0)), samples=20_000, accuracy=1e-3)
    assert model.asked < 500
    assert made.spreads["sum"].first == pytest.approx([1 / 6, 1 / 6, 4 / 6], abs=1e-9)
    assert made.spreads["power"].mean == pytest.approx(math.exp(0.015), rel=1e-6)


def test_inputs_of_any_continuous_kind_and_correlated() -> None:
    """Polynomials of the inputs themselves do not mind how these are distributed."""

    class Straight(Slow):
        def __call__(self, inputs: dict) -> tuple[dict, None]:
            results, _ = super().__call__(inputs)
            a, b = inputs["a"], inputs["b"]
            return {name: results[name] for name in ("power", "sum", "distance")} | {"two": a + b, "one": a * 3.0}, None

    model = Straight()
    kinds = {"a": Uniform(-1.0, 1.0), "b": Uniform(-1.0, 1.0), "c": Normal(0.0, 0.1)}
    made = propagate(model, kinds, samples=20_000, accuracy=1e-3)
    assert model.asked < 500
    # the sum of two uniforms is triangular: below its 2.5 % quantile lies (2 + q)²/8
    two = made.spreads["two"]
    assert two.interval[0] == pytest.approx(math.sqrt(0.2) - 2.0, abs=two.estimate * two.std)
    assert two.estimate < 5e-3
    correlated = propagate(
        Straight(), dict.fromkeys("abc", Normal(0.0, 1.0)), {("a", "b"): 0.5}, samples=20_000, accuracy=1e-3
    )
    spread = correlated.spreads["two"]
    assert "polynomials" in spread.method
    assert spread.std == pytest.approx(math.sqrt(3.0), rel=1e-6)
    assert spread.first == pytest.approx([0.5, 0.5, 0.0], abs=1e-6)


def test_a_limit_is_asked_of_the_model_itself() -> None:
    model = Slow()
    made = propagate(
        model, dict.fromkeys("abc", Normal(0.0, 1.0)), samples=20_000, accuracy=1e-3, limits={"sum": [15.0]}
    )
    assert "polynomials" not in made.spreads["sum"].method
    assert made.spreads["sum"].beyond[0][1] == pytest.approx(normal.upper(15.0 / math.sqrt(6.0)), rel=1e-6)


def test_of_few_affordable_cases_a_limit_leaves_the_interval_as_it_is() -> None:
    class Costly(Slow):
        def __init__(self) -> None:
            super().__init__()
            self.drawing = Drawing()
            self.drawing.each = 0.01

    given = dict.fromkeys("abc", Normal(0.0, 1.0))
    limit = 15.0
    alone, limited = (
        propagate(Costly(), given, samples=20_000, accuracy=1e-3, shares=False, limits=limits).spreads["sum"]
        for limits in ({}, {"sum": [limit]})
    )
    assert limited.interval == pytest.approx(alone.interval, rel=1e-9)
    assert limited.estimate < FAIR
    assert limited.beyond[0][1] == pytest.approx(normal.upper(limit / math.sqrt(6.0)), rel=1e-3)


def test_bounded_inputs_and_refused_cases_are_left_to_other_methods() -> None:
    """Beside a wall the polynomials have nothing to be fitted to."""

    class Walled(Slow):
        def __call__(self, inputs: dict) -> tuple[dict, np.ndarray]:
            results, _ = super().__call__(inputs)
            return results, np.asarray(results["ratio"] > 5.3)

    made = propagate(Walled(), dict.fromkeys("abc", Uniform(-1.0, 1.0)), samples=20_000, accuracy=1e-3, shares=False)
    spread = made.spreads["ratio"]
    assert "polynomials" not in spread.method
    assert spread.admissible == pytest.approx(0.8, abs=0.02)
    low, high = 4.5 + 0.8 * 0.025, 4.5 + 0.8 * 0.975
    assert spread.interval == pytest.approx((low, high), abs=spread.estimate * spread.std)


class Turning:
    """One input, asked case by case: a result that turns several times within its spread, and one that jumps about."""

    arrays = False

    def __init__(self, *, wild: bool) -> None:
        self.asked = 0
        self.wild = wild

    def __call__(self, inputs: dict) -> tuple[dict, None]:
        x = inputs["x"]
        self.asked += len(x)
        return {"wave": np.cos(40.0 * x * x) if self.wild else np.cos(1.5 * x), "plain": 3.0 * x}, None


@pytest.mark.parametrize("wild", [False, True])
def test_one_input_on_which_results_turn(*, wild: bool) -> None:
    model = Turning(wild=wild)
    made = propagate(model, {"x": Normal(0.3, 1.0)}, samples=20_000, accuracy=1e-3)
    x = np.random.default_rng(1).standard_normal(400_000) + 0.3
    wave = np.cos(40.0 * x * x) if wild else np.cos(1.5 * x)
    spread = made.spreads["wave"]
    found, plain = [*spread.interval, spread.mean, spread.std], [*np.quantile(wave, P[::2]), wave.mean(), wave.std()]
    assert found == pytest.approx(plain, abs=(spread.estimate + 0.005) * wave.std())
    assert made.spreads["plain"].std == pytest.approx(3.0, rel=1e-4)
    assert spread.estimate < (0.3 if wild else 0.03)
    assert model.asked < (2000 if wild else 300)


class Chaotic:
    """Of expensive cases, a result that no polynomial follows."""

    arrays = False

    def __init__(self) -> None:
        self.drawing = Drawing()
        self.drawing.each = 0.02

    def __call__(self, inputs: dict) -> tuple[dict, np.ndarray | None]:
        self.drawing.spent += self.drawing.each * np.size(inputs["a"])
        return {"angle": np.sin(1e4 * inputs["a"]) + 0.0 * inputs["b"]}, None


def test_what_effort_leaves_poorly_known_is_remedied_by_the_sample_that_is_named() -> None:
    given = {"a": Normal(0.0, 1.0), "b": Normal(0.0, 1.0)}
    made = propagate(Chaotic(), given)
    assert made.estimate > FAIR
    assert "--method monte-carlo --samples" in made.remedy
    named = propagate(Chaotic(), given, method="monte-carlo", samples=8000)
    assert named.remedy == "raise --samples"
    assert named.estimate < 0.2 * made.estimate
