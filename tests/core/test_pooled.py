"""One sample for many results with kinks and jumps, against distributions known in closed form."""

import math

import numpy as np
import pytest

from dynamics_cli.core.inputs.uncertain.distributions import Normal, Uniform
from dynamics_cli.core.uncertainty.propagation import Spread, propagate
from dynamics_cli.core.uncertainty.tails import BEYOND_SAMPLES, drop_moments, narrowing, remedy
from dynamics_cli.numerics.distributions import normal

NAMES = ("a", "b", "c", "d")
P = (0.025, 0.5, 0.975)


def model(inputs: dict) -> tuple[dict, None]:
    """The largest, the least, the one farthest from the middle, how many are above, and one with a pole."""
    z = np.array([np.broadcast_to(inputs[name], np.shape(inputs["a"])) for name in NAMES])
    above = (z > 0.5).sum(axis=0)
    return {
        "largest": z.max(axis=0),
        "least": z.min(axis=0),
        "farthest": np.abs(z).max(axis=0),
        "count": above.astype(float),
        "straight": z.sum(axis=0),
        "middle": np.abs(z).min(axis=0),
        "pole": 1.0 / (1.0 + 0.5 * z.sum(axis=0)),
    }, None


EXACT = {
    "largest": [normal.quantile(p**0.25) for p in P],
    "least": [-normal.quantile((1.0 - p) ** 0.25) for p in P],
    "farthest": [normal.quantile(0.5 * (1.0 + p**0.25)) for p in P],
    "middle": [normal.quantile(0.5 * (2.0 - (1.0 - p) ** 0.25)) for p in P],
    "straight": [2.0 * normal.quantile(p) for p in P],
    "pole": [1.0 / (1.0 + normal.quantile((normal.upper(1.0) - p) % 1.0)) for p in P],
}


@pytest.mark.parametrize("seed", range(1, 9))
def test_the_stated_error_holds(seed: int) -> None:
    made = propagate(model, dict.fromkeys(NAMES, Normal(0.0, 1.0)), seed=seed, shares=False)
    for name, exact in EXACT.items():
        spread = made.spreads[name]
        found = (spread.interval[0], spread.median, spread.interval[1])
        # near a pole no sample has the deviation: the error is told in that of the interval
        assert spread.tails == (name == "pole")
        unit = (found[2] - found[0]) / (2.0 * normal.quantile(P[2])) if spread.tails else spread.std
        worst = max(abs(a - b) for a, b in zip(found, exact, strict=True)) / unit
        assert worst <= spread.estimate, name
    assert "one sample for all results" in made.spreads["farthest"].method
    assert made.spreads["farthest"].estimate < 0.02
    # what rises along straight lines needs no sample
    assert made.spreads["straight"].estimate < 1e-6


def test_near_a_pole_the_input_that_decides_is_named() -> None:
    def ratio(inputs: dict) -> tuple[dict, None]:
        return {"ratio": 1.0 / (1.0 + 0.3 * inputs["wide"] + 0.01 * inputs["narrow"])}, None

    made = propagate(ratio, {"narrow": Normal(0.0, 1.0), "wide": Normal(0.0, 1.0)})
    spread = made.spreads["ratio"]
    assert narrowing(made, spread) == "narrow wide, which decides most"
    # more samples mend a small error, and only that
    spread.estimate = 0.5 * BEYOND_SAMPLES
    assert remedy(made, [spread]) == "raise --samples"
    spread.estimate = 2.0 * BEYOND_SAMPLES
    assert remedy(made, [spread]) == "narrow wide, which decides most"


def test_jumps_stay_whole_numbers() -> None:
    """How many of four are above 1/2: binomial."""
    made = propagate(model, dict.fromkeys(NAMES, Normal(0.0, 1.0)), limits={"count": [1.5]}, shares=False)
    spread = made.spreads["count"]
    assert (spread.interval, spread.median) == ((0.0, 3.0), 1.0)
    p = 0.5 * math.erfc(0.5 / math.sqrt(2.0))
    assert spread.mean == pytest.approx(4 * p, abs=2e-3)
    one_or_none = (1 - p) ** 4 + 4 * p * (1 - p) ** 3
    assert spread.beyond[0][1] == pytest.approx(1.0 - one_or_none, abs=1e-3)


def test_refused_cases_are_left_out() -> None:
    """Given that all are below 1, the largest has the distribution (u/1)^4 of four uniforms on 0 to 1."""

    def bounded(inputs: dict) -> tuple[dict, np.ndarray]:
        results, _ = model(inputs)
        return results, results["largest"] > 1.0

    made = propagate(bounded, dict.fromkeys(NAMES, Uniform(0.0, 1.25)), shares=False)
    spread = made.spreads["largest"]
    assert spread.admissible == pytest.approx(0.8**4, abs=5e-3)
    assert spread.interval == pytest.approx([0.025**0.25, 0.975**0.25], abs=spread.estimate * spread.std + 1e-9)


def test_a_model_asked_case_by_case_is_asked_once_for_all_results() -> None:
    asked: list[int] = []

    def slow(inputs: dict) -> tuple[dict, None]:
        asked.append(len(inputs["a"]))
        return model(inputs)

    slow.arrays = False
    made = propagate(slow, dict.fromkeys(NAMES, Normal(0.0, 1.0)), samples=20_000, accuracy=1e-3, shares=False)
    assert sum(asked) < 20_000
    for name, exact in EXACT.items():
        spread = made.spreads[name]
        found = (spread.interval[0], spread.median, spread.interval[1])
        assert max(abs(a - b) for a, b in zip(found, exact, strict=True)) <= spread.estimate * spread.std, name


def test_more_inputs_than_a_lattice_has_dimensions() -> None:
    names = [f"x{i}" for i in range(45)]

    def peaks(inputs: dict) -> tuple[dict, None]:
        z = np.array([np.broadcast_to(inputs[name], np.shape(inputs["x0"])) for name in names])
        return {"largest": z.max(axis=0), "least": z.min(axis=0)}, None

    spread = propagate(peaks, dict.fromkeys(names, Normal(0.0, 1.0)), shares=False).spreads["largest"]
    exact = [normal.quantile(p ** (1.0 / 45.0)) for p in P]
    found = (spread.interval[0], spread.median, spread.interval[1])
    assert max(abs(a - b) for a, b in zip(found, exact, strict=True)) <= spread.estimate * spread.std


class Together:
    """Six smooth results that bend, and one that turns, of a model that answers thousands of cases at once."""

    arrays, together = False, True

    def __call__(self, inputs: dict) -> tuple[dict, None]:
        """Exponentials of sums of the inputs: lognormal. The size of one: half normal."""
        a, b, c, d = (np.asarray(inputs[name]) for name in NAMES)
        bends = {f"bend{k}": np.exp(0.1 * k * (a + b - c + d)) for k in range(1, 7)}
        return {**bends, "farthest": np.abs([a, b, c, d]).max(axis=0)}, None


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_dear_model_has_polynomials_beside_its_sample(seed: int) -> None:
    made = propagate(Together(), dict.fromkeys(NAMES, Normal(0.0, 1.0)), samples=20_000, seed=seed, shares=False)
    exact = {f"bend{k}": [math.exp(0.2 * k * normal.quantile(p)) for p in P] for k in range(1, 7)}
    for name, numbers in (exact | {"farthest": EXACT["farthest"]}).items():
        spread = made.spreads[name]
        found = (spread.interval[0], spread.median, spread.interval[1])
        worst = max(abs(a - b) for a, b in zip(found, numbers, strict=True)) / spread.std
        assert worst <= spread.estimate, name
        assert "8 shifted lattices of 1024 points" in spread.method, name
        # the lognormal of the largest exponent has a deviation of which its tail is most
        assert spread.estimate < (0.04 if name != "farthest" else 0.12), name
    assert "beside polynomials of degree 6" in made.spreads["bend3"].method
    assert made.spreads["bend3"].std == pytest.approx(math.sqrt(math.expm1(0.36)) * math.exp(0.18), rel=2e-3)
    assert made.points < 10_000


def test_values_at_two_ends_have_a_deviation() -> None:
    """A result that jumps between two values is no long tail, however poorly it is known."""
    two = Spread("place", "", [0.0, 0.1, 1.2], 0.6, 0.6)
    two.estimate = 1.0
    drop_moments(two, 0.95)
    assert (two.std, two.tails) == (0.6, False)
