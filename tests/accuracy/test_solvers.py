"""The alternatives' own solver: Brent's root."""

import math

import pytest
from peers.solvers import brent


class TestBrent:
    @pytest.mark.parametrize(
        ("f", "low", "high", "root"),
        [
            (lambda x: x**3 - 2.0 * x - 5.0, 2.0, 3.0, 2.0945514815423265),
            (lambda x: math.cos(x) - x, 0.0, 1.0, 0.7390851332151607),
            (lambda x: math.exp(-x) - 1e-10, 0.0, 100.0, 10.0 * math.log(10.0)),
            (lambda x: x - 1e-300, -1.0, 1.0, 1e-300),
            (lambda x: (x - 1.0) ** 7, 0.0, 3.1, 1.0),
            (lambda x: math.copysign(1.0, x - 0.3), 0.0, 1.0, 0.3),
        ],
    )
    def test_roots_are_found_to_the_last_bits(self, f, low: float, high: float, root: float) -> None:
        assert brent(f, low, high) == pytest.approx(root, rel=1e-15)
        assert brent(f, high, low) == pytest.approx(root, rel=1e-15)

    def test_it_is_quicker_than_halving(self) -> None:
        calls = 0

        def f(x: float) -> float:
            nonlocal calls
            calls += 1
            return x**3 - 2.0 * x - 5.0

        brent(f, 2.0, 3.0)
        assert calls <= 12

    def test_ends_of_one_sign_are_refused(self) -> None:
        with pytest.raises(ArithmeticError):
            brent(lambda x: x * x + 1.0, -1.0, 1.0)
