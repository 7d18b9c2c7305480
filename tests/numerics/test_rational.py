"""Whole-number elimination against fractions, and one rounding at the end."""

import random
from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.numerics.exact.rational import Solved, exact, lowest, nearest, product, reduce_rows, total, written

WHOLE = st.integers(-(10**30), 10**30)
NOT_ZERO = WHOLE.filter(bool)


@given(WHOLE, NOT_ZERO, WHOLE, NOT_ZERO)
def test_pairs_are_fractions(a: int, b: int, c: int, d: int) -> None:
    one, other = Fraction(a, b), Fraction(c, d)
    assert Fraction(*product((a, b), (c, d))) == one * other
    assert Fraction(*total(((a, b), (c, d)))) == one + other
    assert lowest(a, b) == one.as_integer_ratio()
    assert written((a, b)) == str(one)
    assert nearest((a, b)) == float(one)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_double_is_the_ratio_it_is(x: float) -> None:
    assert nearest(exact(x)) == x


def test_beyond_the_doubles() -> None:
    assert nearest((10**400, 1)) == float("inf")
    assert nearest((-(10**400), 1)) == float("-inf")
    assert nearest((10**400, -1)) == float("-inf")


def test_elimination_keeps_the_row_space() -> None:
    generator = random.Random(3)
    for _ in range(300):
        height, width = generator.randint(1, 5), generator.randint(1, 6)
        rows = [[generator.randint(-9, 9) * (generator.random() < 0.7) for _ in range(width)] for _ in range(height)]
        reduced, pivots = reduce_rows(rows)
        for row, pivot in zip(reduced, pivots, strict=True):
            assert row[pivot] > 0
            assert all(other[pivot] == 0 for other in reduced if other is not row)
        # every row of the first is a combination of the reduced ones, read off at the pivots
        for row in rows:
            left = [Fraction(value) for value in row]
            for own, pivot in zip(reduced, pivots, strict=True):
                share = left[pivot] / own[pivot]
                left = [value - share * other for value, other in zip(left, own, strict=True)]
            assert not any(left)


def test_open_columns_and_conflicts_are_told() -> None:
    solved = Solved([[1, 1, 0, 0]], 4, [0])
    assert solved.freedom == 3
    assert solved.terms(1) == ((-1, 1),)
    assert solved.terms(2) is None
    assert solved.terms(0) == ((1, 1),)
    assert Solved([[1, 0], [0, 1]], 2, [0, 1]).conflict == (0, 1)
    assert Solved([], 2, [0]).freedom == 2
