"""Properties of the exact counts: what holds for every polynomial."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.numerics.exact.whole_polynomials import (
    common_divisor,
    derivative,
    isolated,
    mirrored,
    quotient,
    square_free,
    times,
)
from dynamics_cli.stability.counting import count
from dynamics_cli.stability.discrete import on_the_plane
from dynamics_cli.stability.roots import roots

COEFFICIENT = st.integers(-30, 30)
POLYNOMIAL = st.lists(COEFFICIENT, min_size=2, max_size=7).filter(lambda p: p[-1] != 0).map(tuple)


@given(POLYNOMIAL)
@settings(max_examples=60)
def test_counts_add_to_the_degree_and_mirror(p: tuple[int, ...]) -> None:
    counts, other = count(p), count(mirrored(p))
    assert counts.left + counts.right + counts.axis == len(p) - 1
    assert (counts.left, counts.right, counts.axis) == (other.right, other.left, other.axis)


@given(POLYNOMIAL)
@settings(max_examples=30)
def test_roots_lie_where_they_are_counted(p: tuple[int, ...]) -> None:
    counts = count(p)
    sides = [0, 0, 0]
    for root in roots(p):
        side = 0 if root.real < 0.0 else 1 if root.real > 0.0 else 2
        sides[side] += root.multiplicity * (2 if root.pair else 1)
    assert sides == [counts.left, counts.right, counts.axis]


@given(POLYNOMIAL, POLYNOMIAL)
@settings(max_examples=40)
def test_a_product_has_the_roots_of_its_factors(p: tuple[int, ...], q: tuple[int, ...]) -> None:
    one, other, both = count(p), count(q), count(times(p, q))
    assert (both.left, both.right, both.axis) == (one.left + other.left, one.right + other.right, one.axis + other.axis)


@given(POLYNOMIAL, POLYNOMIAL)
@settings(max_examples=40)
def test_divisors_divide(p: tuple[int, ...], q: tuple[int, ...]) -> None:
    common = common_divisor(times(p, q), q)
    assert len(common) >= len(q)
    quotient(times(p, q), common)
    degree = 0
    for factor, multiplicity in square_free(p):
        degree += multiplicity * (len(factor) - 1)
        assert len(common_divisor(factor, derivative(factor))) == 1
    assert degree == len(p) - 1


@given(st.lists(st.integers(-12, 12), min_size=1, max_size=6, unique=True))
@settings(max_examples=30)
def test_isolated_roots_are_those_put_in(places: list[int]) -> None:
    p: tuple[int, ...] = (1,)
    for place in places:
        p = times(p, (-place, 1))
    found = isolated(p)
    assert len(found) == len(places)
    for ends, place in zip(found, sorted(places), strict=True):
        assert ends[0][0] <= place * ends[0][1]
        assert place * ends[1][1] <= ends[1][0]


@given(POLYNOMIAL)
@settings(max_examples=30)
def test_the_circle_maps_on_the_axis(p: tuple[int, ...]) -> None:
    """p(z) at a point of the circle is the mapped polynomial at its point of the axis, but for the factor (1 − s)ⁿ."""
    turn = 0.7
    z, s = complex(math.cos(turn), math.sin(turn)), complex(0.0, math.tan(turn / 2.0))
    mapped = on_the_plane(p)
    left = sum(c * z**k for k, c in enumerate(p)) * (1 - s) ** (len(p) - 1)
    assert sum(c * s**k for k, c in enumerate(mapped)) == pytest.approx(left, rel=1e-9, abs=1e-9)
