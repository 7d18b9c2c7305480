"""Proxies and their extremes: against roots known in closed form, jumps between pieces, constants and noise."""

import functools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.numerics.chebyshev import extremes, proxies


def alone(function, low: float, high: float):
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
