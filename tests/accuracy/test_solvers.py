"""The alternatives' own solvers: Brent's root, Dormand and Prince's steps with events."""

import math

import pytest
from peers.solvers import ERRORS, PLACES, SLOPES, WEIGHTS, brent, dormand_prince


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


class TestDormandPrince:
    def test_the_tableau_is_consistent(self) -> None:
        for place, row in zip(PLACES, SLOPES, strict=True):
            assert sum(row) == pytest.approx(place, abs=1e-15)
        assert sum(WEIGHTS) == pytest.approx(1.0, abs=1e-15)
        assert sum(ERRORS) == pytest.approx(0.0, abs=1e-15)
        for power in range(1, 4):
            moments = sum(w * c**power for w, c in zip(WEIGHTS, PLACES, strict=True))
            assert moments == pytest.approx(1.0 / (power + 1.0), abs=1e-14)

    def test_a_pendulum_falls_as_energy_says(self) -> None:
        _, (angle, speed), which = dormand_prince(
            lambda _, y: (y[1], -math.sin(y[0])), [1.0, 0.0], [lambda _, y: -y[0]], 1e-12, 1e-14, first=0.01
        )
        assert which == [True]
        assert angle == pytest.approx(0.0, abs=1e-14)
        assert -speed == pytest.approx(math.sqrt(2.0 * (1.0 - math.cos(1.0))), rel=1e-11)

    def test_the_first_of_two_events_ends_it(self) -> None:
        events = [lambda _, y: y[0] - 2.0, lambda _, y: y[0] - 1.5]
        t, (y,), which = dormand_prince(lambda *_: (1.0,), [0.0], events, 1e-10, 1e-12, first=0.01)
        assert (t, y) == pytest.approx((1.5, 1.5), rel=1e-14)
        assert which == [False, True]

    def test_errors_follow_the_tolerance(self) -> None:
        errors = []
        for tolerance in (1e-5, 1e-10):
            _, (y, _), _ = dormand_prince(
                lambda _, y: (y[0], 1.0), [1.0, 0.0], [lambda _, y: y[1] - 1.0], tolerance, 1e-14, first=0.01
            )
            errors.append(abs(y / math.e - 1.0))
        assert errors[1] < 1e-9
        assert errors[0] > 30.0 * errors[1]

    def test_what_never_ends_is_no_answer(self) -> None:
        with pytest.raises(ArithmeticError):
            dormand_prince(lambda *_: (0.0,), [0.0], [lambda _, y: y[0] - 1.0], 1e-8, 1e-10, first=0.01)
