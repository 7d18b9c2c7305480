"""The numbers of 240 bits against mpmath's at more digits, function by function."""

import random

import precise
import pytest
from mpmath import mp, mpf
from precise import Precise

from dynamics_cli.numerics import elementary
from dynamics_cli.numerics.involute import inverse_involute
from dynamics_cli.numerics.tracked import _RULES

ONE = {"sqrt": (0.0, 9.0), "sin": (-9.0, 9.0), "cos": (-9.0, 9.0), "tan": (-1.5, 1.5), "asin": (-1.0, 1.0)}
ONE |= {"sinh": (-9.0, 9.0), "cosh": (-9.0, 9.0), "tanh": (-9.0, 9.0)}
ONE |= {"acos": (-1.0, 1.0), "atan": (-9.0, 9.0), "exp": (-9.0, 9.0), "log": (1e-9, 9.0)}


def text(number: Precise) -> mpf:
    """One of these numbers as mpmath reads it."""
    return mpf(str(number.exact)) if precise.gmpy2 else number.exact


def close(number: Precise, wanted: mpf) -> bool:
    return abs(text(number) - wanted) <= mpf(2) ** -230 * abs(wanted)


@pytest.fixture(autouse=True)
def bits() -> None:
    precise.many_bits()
    mp.prec = 400


@pytest.mark.parametrize("name", ONE)
def test_functions_of_one(name: str) -> None:
    rng = random.Random(name)
    for _ in range(50):
        x = rng.uniform(*ONE[name])
        assert close(getattr(elementary, name)(Precise.inputs([x])[0]), getattr(mp, name)(mpf(x)))


@pytest.mark.parametrize("name", ["atan2", "hypot"])
def test_functions_of_two(name: str) -> None:
    rng = random.Random(name)
    for _ in range(50):
        x, y = rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0)
        made = getattr(elementary, name)(Precise.inputs([x])[0], y)
        assert close(made, getattr(mp, name)(mpf(x), mpf(y)))


def test_arithmetic_mixes_with_doubles_and_whole_numbers() -> None:
    a, b = Precise.inputs([0.1, 3.0])
    x, y = mpf(0.1), mpf(3.0)
    assert close(a * b + 2 - 0.3, x * y + 2 - mpf(0.3))
    assert close((1.0 - a) / b, (1 - x) / y)
    assert close(2 / a, 2 / x)
    assert close(-abs(-a) * 0.7, -x * mpf(0.7))
    assert [a < b, a <= 0.1, b > 1, b >= 3.0, a == 0.1, a != b, bool(a)] == [True] * 7
    assert [b < a, b <= 0.1, a > 1, a >= 3.0, a == 0.2, a != 0.1, bool(a - a)] == [False] * 7
    assert elementary.maximum(a, b) == b
    assert elementary.minimum(a, 0.05) == 0.05
    assert close(elementary.multiply_add(a, b, -0.3), x * y - mpf(0.3))


def test_involute_angles_are_found_from_the_equation() -> None:
    for value in (1e-30, 1e-9, 0.0149, 0.5, 0.999, 1.0, 3.0, 1e6):
        phi = text(inverse_involute(Precise.inputs([value])[0]))
        assert abs(mp.tan(phi) - phi - mpf(value)) <= mpf(2) ** -200 * (mpf(value) + 1) * (1 + mp.tan(phi) ** 2)
    assert inverse_involute(Precise.inputs([0.0])[0]) == 0.0


def test_every_function_of_tracked_numbers_is_there() -> None:
    assert set(_RULES) <= set(precise.FUNCTIONS)


def test_leaving_the_real_numbers_is_an_arithmetic_error() -> None:
    for name, x in (("sqrt", -1.0), ("asin", 2.0), ("log", -1.0)):
        with pytest.raises(ArithmeticError):
            getattr(elementary, name)(Precise.inputs([x])[0])
    with pytest.raises(ArithmeticError):
        inverse_involute(Precise.inputs([-1.0])[0])
    with pytest.raises(ArithmeticError):
        Precise.inputs([1.0])[0] / Precise.inputs([0.0])[0]


def test_a_precise_number_does_not_turn_into_a_float_unasked() -> None:
    number = Precise.inputs([0.1])[0]
    assert number.value == 0.1
    with pytest.raises(TypeError):
        float(number)
