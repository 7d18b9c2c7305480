"""Josephs, H. and Huston, R. L., Dynamics of Mechanical Systems, CRC Press, 2002, sections 2.3 and 2.4: vectors.

Examples 2.3.1 and 2.3.2: forces of 15 N and 12 N at 60 degrees, and a third of 10 N square to both. The book adds the
third to its rounded 23.43 N and prints 25.47 N; the exact sum is √649 N. Of example 2.4.2 only the data are used.
"""

from math import sqrt

import pytest
from harness import answer


def magnitude(*argv: str) -> float:
    return float(answer("vec", *argv)["results"]["magnitude"]["value"])


def test_two_forces_at_an_angle() -> None:
    assert magnitude("resultant", "15 N", "12 N", "--between", "60 deg") == pytest.approx(23.43, abs=0.005)


def test_a_third_force_square_to_both() -> None:
    whole = magnitude("resultant", "15 N @ 0 deg", "12 N @ 60 deg", "0, 0, 10 N")
    assert whole == pytest.approx(sqrt(649.0), rel=1e-15)
    assert whole == pytest.approx(25.47, abs=0.01)


def test_a_position_vector() -> None:
    assert magnitude("direction", "8, 12, 7 m") == pytest.approx(sqrt(257.0), rel=1e-15)
