"""Many monotone roots at once: rising and falling, beyond the ends, from minus infinity, on every cut."""

import numpy as np
import pytest

from dynamics_cli.numerics.monotone import solve

CUTS = np.array([-2.0, -0.5, 0.0, 3.0])
FUNCTIONS = {
    "line": (lambda t: 2.0 * t + 1.0, lambda t: np.full_like(t, 2.0)),
    "cube": (lambda t: t * t * t + t, lambda t: 3.0 * t * t + 1.0),
    "exponential": (np.exp, np.exp),
    "bent": (lambda t: np.where(t < 1.0, t, 10.0 * t - 9.0), lambda t: np.where(t < 1.0, 1.0, 10.0)),
}


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("rising", [True, False])
def test_roots_and_slopes(name: str, rising: bool) -> None:
    function, slope = FUNCTIONS[name]
    sign = 1.0 if rising else -1.0
    wanted = np.concatenate([np.random.default_rng(1).uniform(-1.99, 2.99, 300), CUTS[1:-1]])
    t, found = solve(lambda x: sign * function(x), CUTS, sign * function(wanted), rising=rising, near=1e-4)
    assert np.abs(t - wanted).max() < (2e-5 if name == "bent" else 1e-5)
    inner = np.abs(wanted - 1.0) > 0.01
    apart = np.abs(found[inner] / slope(wanted[inner]) - 1.0)
    # Straddling the bend, or met at the first step, a secant is no tangent; nearly all are.
    assert np.quantile(apart, 0.95) < 0.05


def test_beyond_the_ends_is_the_end_and_an_infinite_slope() -> None:
    t, slope = solve(lambda x: x, CUTS, np.array([-5.0, 9.0]), rising=True, near=1e-4)
    assert t.tolist() == [-2.0, 3.0]
    assert np.isinf(slope).all()
    t, _ = solve(lambda x: -x, CUTS, np.array([5.0, -9.0]), rising=False, near=1e-4)
    assert t.tolist() == [-2.0, 3.0]


@pytest.mark.parametrize("rising", [True, False])
def test_minus_infinity_is_below_all(rising: bool) -> None:
    """A model that is inadmissible below: √t, and −∞ for negative t."""

    def root(t: np.ndarray) -> np.ndarray:
        t = t if rising else -t
        with np.errstate(invalid="ignore"):
            return np.where(t < 0.0, -np.inf, np.sqrt(np.maximum(t, 0.0)))

    cuts = CUTS if rising else -CUTS[::-1]
    wanted = np.array([0.01, 0.3, 2.5])
    t, _ = solve(root, cuts, np.sqrt(wanted), rising=rising, near=1e-4)
    assert np.abs(t - (wanted if rising else -wanted)).max() < 2e-5
