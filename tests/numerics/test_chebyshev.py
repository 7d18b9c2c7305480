"""Proxies and their extremes: against roots known in closed form, jumps between pieces, constants and noise."""

import functools
import random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp, mpf

from dynamics_cli.numerics.chebyshev.proxies import Proxies, extremes, proxies


def alone(function, low: float, high: float) -> Proxies:
    return proxies(lambda x, piece: function(x)[None], np.array([low]), np.array([high]))


def test_every_turning_place_of_a_wave() -> None:
    found = extremes(alone(lambda x: np.cos(40.0 * x), 0.1, 3.0), every=True)
    places = found.places[found.inside]
    expected = np.arange(2, 39) * np.pi / 40.0
    expected = expected[(expected > 0.1) & (expected < 3.0)]
    for place in expected:
        assert np.abs(places - place).min() < 1e-7


def test_a_spike_between_samples_is_found() -> None:
    # as wide as a thousandth of the piece: a table of 100 values does not see it
    spike = lambda x: np.sin(x) + 1e-3 / (1.0 + np.square((x - 0.71234) / 1e-3))  # noqa: E731
    value, place = extremes(alone(lambda x: spike(x) - np.sin(x), 0.0, 3.0)).largest()
    assert place == pytest.approx(0.71234, abs=1e-9)
    assert value == pytest.approx(1e-3, rel=1e-12)


def test_pieces_keep_their_own_coordinates_and_jumps() -> None:
    made = proxies(lambda t, piece: (t + 10.0 * piece[:, None])[None], np.zeros(3), np.ones(3))
    found = extremes(made)
    assert found.largest()[0] == pytest.approx(21.0, abs=1e-13)
    assert found.smallest()[0] == pytest.approx(0.0, abs=1e-13)
    assert int(found.owner[np.argmax(found.values)]) == 2


def test_a_constant_turns_nowhere() -> None:
    found = extremes(alone(lambda x: 0.0 * x + 0.01, 0.0, 1.0), every=True)
    assert not found.inside.any()
    assert found.largest()[0] == pytest.approx(0.01, rel=1e-15)


def test_what_is_not_finite_is_refused() -> None:
    with np.errstate(divide="ignore"), pytest.raises(ValueError, match="finite"):
        alone(lambda x: np.log(x), -1.0, 1.0)


@given(st.lists(st.floats(-5.0, 5.0), min_size=3, max_size=12), st.floats(0.2, 8.0))
def test_no_grid_goes_beyond_a_polynomial_s_extremes(coefficients: list[float], width: float) -> None:
    function = lambda x: functools.reduce(lambda f, c: f * (x / width) + c, coefficients, 0.0 * x)  # noqa: E731
    made = alone(function, -width, width)
    found = extremes(made)
    values = function(np.linspace(-width, width, 4001))
    scale = sum(abs(c) for c in coefficients) + 1e-300
    assert found.largest()[0] >= values.max() - 1e-13 * scale
    assert found.smallest()[0] <= values.min() + 1e-13 * scale
    assert found.largest()[0] <= values.max() + 1e-4 * scale
    assert abs(function(np.array(found.largest()[1])) - found.largest()[0]) <= 1e-12 * scale
    assert found.error >= 0.0


FUNCTIONS = {
    "entire": (lambda x: np.sin(9.0 * x) * np.exp(x), lambda x: mp.sin(9 * x) * mp.exp(x), 0.0, 2.0),
    "poles beside it": (lambda x: 1.0 / (1.0 + np.square(40.0 * x)), lambda x: 1 / (1 + (40 * x) ** 2), -1.0, 1.0),
    "a root near its branch": (lambda x: np.sqrt(x + 1e-6), lambda x: mp.sqrt(x + mpf(1e-6)), 0.0, 1.0),
    "a hidden spike": (
        lambda x: np.cos(x) + 1e-9 / (1e-12 + np.square(x - 0.30103)),
        lambda x: mp.cos(x) + mpf(1e-9) / (mpf(1e-12) + (x - mpf(0.30103)) ** 2), 0.0, 1.0,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_estimated_error_holds_in_forty_digits_and_is_small(name: str) -> None:
    function, exact, low, high = FUNCTIONS[name]
    mp.dps = 40
    made = alone(function, low, high)
    chance = random.Random(name)
    size = 0.0
    for piece in range(made.starts.size):
        start, end = mpf(made.starts[piece]), mpf(made.ends[piece])
        for _ in range(4):
            t = mpf(chance.uniform(0.0, np.pi))
            place = (start + end) / 2 + (end - start) / 2 * mp.cos(t)
            near = sum(mpf(float(c)) * mp.cos(k * t) for k, c in enumerate(made.coefficients[0, piece]))
            # what is left out, and the rounding of the samples and their places
            size_of = np.abs(made.coefficients[0, piece])
            steep = (size_of * np.arange(size_of.size) ** 2).sum() / (made.ends[piece] - made.starts[piece])
            rounded = 2.0**-50 * float(size_of.sum()) + 2.0**-53 * float(steep)
            assert abs(near - exact(place)) <= mpf(float(made.error[0, piece]) + rounded), (piece, t)
            size = max(size, abs(float(near)))
    # values and their sums are rounded a few hundred times; beside a spike the places' rounding is what counts
    small = 1e-9 if "spike" in name else 1e-12
    assert made.error.max() <= small * size
    found = extremes(made)
    assert found.error <= 2.0 * small * size
    dense = function(np.linspace(low, high, 20_001))
    assert found.largest()[0] + found.error >= dense.max()
    assert found.smallest()[0] - found.error <= dense.min()


def test_what_is_not_resolved_has_an_error_that_says_so() -> None:
    # a kink: no proxy on any piece resolves it, and none is claimed to
    made = alone(lambda x: np.sqrt(np.square(x - 0.3)), 0.0, 1.0)
    assert np.isfinite(made.coefficients).all()
    kinked = (made.starts <= 0.3) & (made.ends >= 0.3)
    assert not (made.error[0, kinked] < 1e-14).any()
