"""Numbers of 60 decimal digits beside mpmath's, and the errors measured with them."""

import math
import random
from decimal import Decimal, localcontext

import pytest
from mpmath import mp, mpf

from dynamics_cli.numerics import elementary
from dynamics_cli.numerics.exact import decimal_functions as functions
from dynamics_cli.numerics.exact.many_digits import CONTEXT, DIGITS, ManyDigits, measured_error, run

RNG = random.Random(11)
SIGNED = [sign * 10.0**exponent for sign in (1.0, -1.0) for exponent in (-300, -150, -40, -12, -3, -1)]
NEAR_ONE = [sign * (1.0 - 10.0**-k) for sign in (1.0, -1.0) for k in range(1, 17)]
ANGLES = [*SIGNED, *(RNG.uniform(-10.0, 10.0) for _ in range(200)), math.pi / 2, math.pi, -math.pi, 1e10, 3e19]
ANYTHING = [*SIGNED, *NEAR_ONE, *(10.0**k for k in range(0, 300, 37)), *(RNG.uniform(-3.0, 3.0) for _ in range(100))]
WITHIN_ONE = [*SIGNED, *NEAR_ONE, *(RNG.uniform(-1.0, 1.0) for _ in range(100))]


def apart(own: ManyDigits, exact: object) -> float:
    """The relative error."""
    return float(abs(mpf(str(own.exact)) / exact - 1)) if exact else float(abs(own.exact))


@pytest.mark.parametrize(
    ("name", "exact", "values"),
    [
        ("sin", mp.sin, ANGLES),
        ("cos", mp.cos, ANGLES),
        ("tan", mp.tan, ANGLES),
        ("atan", mp.atan, ANYTHING),
        ("asin", mp.asin, WITHIN_ONE),
        ("acos", mp.acos, WITHIN_ONE),
        ("exp", mp.exp, [value for value in ANYTHING if abs(value) < 700.0]),
        ("log", mp.log, [abs(value) for value in ANYTHING]),
        ("sqrt", mp.sqrt, [abs(value) for value in ANYTHING]),
        ("involute", lambda x: mp.tan(x) - x, [value for value in WITHIN_ONE if abs(value) > 1e-160]),
        ("roll_less_arc", lambda x: x - mp.atan(x), [value for value in ANYTHING if abs(value) > 1e-160]),
    ],
)
def test_functions_have_58_digits(name, exact, values):
    with mp.workdps(700):
        for value in values:
            number = ManyDigits(Decimal(value))
            assert apart(run(lambda number=number: number.apply(name, number)), exact(mpf(value))) < 1e-57, value


def test_the_inverse_of_the_involute_function():
    with mp.workdps(500):
        for value in (1e-150, 1e-60, 1e-9, 0.0149, 0.99, 1.01, 40.0, 1e9):
            number = ManyDigits(Decimal(value))
            phi = mpf(str(run(lambda number=number: number.apply("inverse_involute", number)).exact))
            back = mp.tan(phi) - phi
            assert abs(back - mpf(value)) < mpf(10) ** -56 * (abs(mpf(value)) + mp.tan(phi) ** 2 * phi)


def test_directions_as_the_c_library_reads_the_signs_of_zeros():
    places = [0.0, -0.0, 1.0, -1.0, 1e-300, -3e5]
    with localcontext(CONTEXT):
        for y in places:
            for x in places:
                assert float(functions.direction(Decimal(y), Decimal(x))) == pytest.approx(math.atan2(y, x), abs=4e-16)


def test_arithmetic_and_comparison():
    a, b = ManyDigits.inputs([3.0, -0.1])
    assert run(lambda: (a * b + 1.0) / b - 2.0 + abs(b) - (-a)).value == pytest.approx(-7.0 - 2.0 + 0.1 + 3.0)
    assert run(lambda: 1.0 / a - 1.0 * a).value == pytest.approx(1.0 / 3.0 - 3.0)
    assert (b < 0.0, b <= -0.1, a > b, a >= 3.0, a == 3.0, bool(b)) == (True,) * 6
    assert hash(a) == hash(ManyDigits(Decimal(3)))
    assert math.copysign(1.0, (-ManyDigits(Decimal(0))).value) == -1.0
    with pytest.raises(TypeError):
        float(a)


@pytest.mark.parametrize(
    ("name", "value"),
    [("asin", 1.5), ("acos", -1.5), ("inverse_involute", -1.0), ("sqrt", -1.0), ("log", -1.0), ("sin", 1e21)],
)
def test_leaving_the_real_numbers_is_an_arithmetic_error(name, value):
    number = ManyDigits(Decimal(value))
    with pytest.raises(ArithmeticError):
        run(lambda: number.apply(name, number))


def test_pi_is_known_to_all_digits():
    with mp.workdps(150):
        assert abs(mpf(str(functions.PI)) - mp.pi) < mpf(10) ** -118
    one = ManyDigits(Decimal(1))
    assert len(str(run(lambda: elementary.pi_beside(2, 1.0, one)).exact)) == DIGITS + 1
    assert elementary.pi_beside(1.0) == math.pi


def test_a_measured_error_covers_the_error_and_never_exceeds_the_bound():
    third = run(lambda: ManyDigits(Decimal(1)) / 3.0)
    assert abs(Decimal(1 / 3) - third.exact) <= Decimal(measured_error(1 / 3, third, 1.0)) < Decimal("3e-16")
    # a difference beyond the bound is of another kind, and a bound that is smaller stands
    assert measured_error(0.25, third, 1e-3) == 1e-3
    assert measured_error(1 / 3, third, 2e-17) == 2e-17


def test_what_iterates_in_doubles_refuses_them():
    with pytest.raises(ArithmeticError):
        elementary.only_in_doubles(1.0, ManyDigits(Decimal(1)))
    elementary.only_in_doubles(1.0, 2)
