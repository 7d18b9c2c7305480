"""Elementary functions give the same bits for a float, an array and a tracked number; compensated sums are exact."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.numerics import elementary as el
from dynamics_cli.numerics.tracked import Tracked

RANGES = {
    "sqrt": (0.0, 1e300),
    "sin": (-1e6, 1e6),
    "cos": (-1e6, 1e6),
    "tan": (-1e6, 1e6),
    "asin": (-1.0, 1.0),
    "acos": (-1.0, 1.0),
    "atan": (-1e300, 1e300),
    "exp": (-700.0, 700.0),
    "log": (1e-300, 1e300),
}


@pytest.mark.parametrize("name", RANGES)
def test_float_array_and_tracked_agree_to_the_bit(name: str) -> None:
    low, high = RANGES[name]
    generator = np.random.default_rng(3)
    values = np.concatenate([generator.uniform(low, high, 500), generator.uniform(max(low, -1), min(high, 1), 500)])
    values = values[(values >= low) & (values <= high)]
    function = getattr(el, name)
    scalars = [function(x) for x in values.tolist()]
    assert function(values).tolist() == scalars
    assert [function(Tracked.inputs([x])[0]).value for x in values.tolist()] == scalars


@pytest.mark.parametrize("name", ["hypot", "atan2"])
def test_two_arguments_agree_to_the_bit(name: str) -> None:
    generator = np.random.default_rng(4)
    first, second = generator.normal(size=(2, 500))
    function = getattr(el, name)
    scalars = [function(x, y) for x, y in zip(first.tolist(), second.tolist(), strict=True)]
    assert function(first, second).tolist() == scalars
    assert function(first, 0.25).tolist() == [function(x, 0.25) for x in first.tolist()]


def test_hypot_with_a_plain_zero_keeps_the_other_whole() -> None:
    assert el.hypot(0.0, -3.0) == 3.0
    assert el.hypot(-3.0, 0.0) == 3.0
    assert el.hypot(0.0, np.array([-1.0, 2.0])).tolist() == [1.0, 2.0]


FINITE = st.floats(-1e100, 1e100).filter(lambda x: x == 0.0 or abs(x) > 1e-100)


@settings(max_examples=500, deadline=None)
@given(FINITE, FINITE, FINITE)
def test_multiply_add_is_within_one_rounding(a: float, b: float, c: float) -> None:
    exact = Fraction(a) * Fraction(b) + Fraction(c)
    error = abs(Fraction(el.multiply_add(a, b, c)) - exact)
    room = Fraction(2) ** -100 * (abs(Fraction(a) * Fraction(b)) + abs(Fraction(c)))
    assert error <= Fraction(2) ** -53 * abs(exact) + room
    assert el.multiply_add(np.array([a]), b, c).tolist() == [el.multiply_add(a, b, c)]


def test_multiply_add_keeps_what_cancels() -> None:
    a = 1.0 + 2.0**-30
    assert el.multiply_add(a, a, -1.0 - 2.0**-29) == 2.0**-60
    assert a * a - 1.0 - 2.0**-29 == 0.0


def test_where_and_friends() -> None:
    assert el.where(True, 1.0, 2.0) == 1.0
    assert el.where(np.array([True, False]), 1.0, 2.0).tolist() == [1.0, 2.0]
    assert el.maximum(1.0, 2.0) == 2.0
    assert el.minimum(np.array([1.0, 5.0]), 2.0).tolist() == [1.0, 2.0]
    assert el.multiply_add(1e300, 1e10, 0.0) == math.inf
