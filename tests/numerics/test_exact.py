"""Scaling of arrays is rounded once, proved against ratios of integers; decimals are found again exactly."""

import random
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.core.units.conversion import from_si, to_si
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.exact.factors import DECIMAL_DIGITS, Decimals, Factor, has_more_digits, scale

NAN = float("nan")
COMMON = ("ft", "in", "mi", "mph", "km/h", "ft/s", "lb", "lbf", "slug", "psi", "hp", "ft*lbf", "deg", "rpm", "degF",
          "degC", "%", "kJ", "mm", "ft^3", "lb/ft^3", "arcsec", "rev", "kn")  # fmt: skip
COUNT = 1_000_000 // len(COMMON)

integers = st.integers(1, 10**25)
doubles = st.floats(allow_nan=False, allow_infinity=False)


def rounded(exact: Fraction) -> float:
    """The nearest double; NaN where a single call would refuse."""
    try:
        value = exact.numerator / exact.denominator
    except OverflowError:
        return NAN
    return value if value or not exact else NAN


def scaled(values, factor: Factor, *, whole: bool = False, power: int = 0):
    """Every doubtful value done exactly, and how many there were."""
    doubtful = []

    def one(value: float) -> float:
        doubtful.append(value)
        return rounded(exact_of(value, factor))

    return scale(np.array(values, dtype=float), factor, one, whole=whole), len(doubtful)


def exact_of(value: float, factor: Factor) -> Fraction:
    return Fraction(value) * Fraction(factor.numerator, factor.denominator) + Fraction(*factor.shift)


def same(a: float, b: float) -> bool:
    return a == b or (a != a and b != b)


@settings(max_examples=300)
@given(st.lists(doubles, min_size=1, max_size=30), integers, integers)
def test_any_ratio(values, numerator, denominator) -> None:
    factor = Factor(numerator, denominator)
    made, _ = scaled(values, factor)
    for value, result in zip(values, made.tolist(), strict=True):
        assert same(result, rounded(exact_of(value, factor)))


@settings(max_examples=300)
@given(st.lists(st.integers(-(2**53), 2**53), min_size=1, max_size=30), integers, integers, st.integers(0, 22))
def test_whole_numbers_over_powers_of_ten(values, numerator, denominator, power) -> None:
    factor = Factor(numerator, denominator).over_ten_to(power)
    made, _ = scaled(values, factor, whole=True)
    for value, result in zip(values, made.tolist(), strict=True):
        assert same(result, rounded(exact_of(float(value), factor)))


@settings(max_examples=300)
@given(
    st.lists(doubles, min_size=1, max_size=30), integers, integers, st.integers(-(10**9), 10**9), st.integers(1, 10**6)
)
def test_with_a_shift(values, numerator, denominator, shift, over) -> None:
    factor = Factor(numerator, denominator, 0, (shift, over))
    made, _ = scaled(values, factor)
    for value, result in zip(values, made.tolist(), strict=True):
        assert same(result, rounded(exact_of(value, factor)))


@pytest.mark.parametrize("ratio", [(18, 5), (5, 18), (1, 2), (3, 2), (1000, 1), (1, 1000), (1397, 3125), (3, 1 << 30)])
def test_ties_go_to_the_even_neighbour_without_exact_arithmetic(ratio) -> None:
    generator = random.Random(1)
    values = [float(generator.getrandbits(53) | 1) for _ in range(20000)]
    factor = Factor(*ratio)
    made, doubtful = scaled(values, factor)
    assert doubtful == 0
    assert all(result == rounded(exact_of(value, factor)) for value, result in zip(values, made.tolist(), strict=True))


@pytest.mark.parametrize(
    "value", [0.0, -0.0, 5e-324, -5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, 1e-290, 1e290]
)
@pytest.mark.parametrize(
    "ratio", [(1, 1), (1, 3), (3, 1), (10**40, 7), (7, 10**40), (2**60, 1), (1, 2**60), (10**200, 1)]
)
def test_ends_of_the_range(value, ratio) -> None:
    factor = Factor(*ratio)
    made, _ = scaled([value], factor)
    assert same(made[0], rounded(exact_of(value, factor)))
    assert not np.signbit(made[0]) or made[0] != 0.0


@pytest.mark.parametrize("name", COMMON)
def test_units_agree_with_single_calls(name) -> None:
    unit = parse_unit(name)
    shift, over = unit.offset
    generator = np.random.default_rng(list(name.encode()))
    values = generator.random(COUNT) * 10.0 ** generator.integers(-4, 7, COUNT)
    values[: COUNT // 20] *= 10.0 ** generator.integers(-290, 290, COUNT // 20)

    def shown(value: float) -> float:
        try:
            return from_si(value, unit)
        except UsageError:
            return NAN

    out = Factor(unit.denominator, unit.numerator, -unit.pi, (-shift * unit.denominator, over * unit.numerator))
    made = scale(values, out, shown)
    assert all(map(same, made.tolist(), map(shown, values.tolist())))

    power = int(generator.integers(0, 7))
    whole = np.rint(generator.random(COUNT) * 10.0 ** generator.integers(0, 15, COUNT))
    ten = 10**power

    def read(value: float) -> float:
        return to_si(int(value), ten, unit)

    into = Factor(unit.numerator, unit.denominator, unit.pi, unit.offset).over_ten_to(power)
    made = scale(whole, into, read, whole=True)
    assert made.tolist() == list(map(read, whole.tolist()))


@settings(max_examples=400)
@given(st.lists(st.tuples(st.integers(-(10**15) + 1, 10**15 - 1), st.integers(0, 18)), min_size=1, max_size=20))
def test_decimals_are_found_again(pairs) -> None:
    values = np.array([n / 10**k for n, k in pairs])
    whole, power, missing = Decimals().find(values)
    for index, (n, k) in enumerate(pairs):
        if missing is None or not missing[index]:
            assert Fraction(int(whole[index]), 10**power) == Fraction(n, 10**k)


def test_decimals_of_one_length_are_all_found() -> None:
    decimals = Decimals()
    generator = random.Random(5)
    for power in (0, 2, 5, 9, 3, 14):
        numbers = [generator.randint(-(10**14), 10**14) for _ in range(3000)]
        whole, found, missing = decimals.find(np.array([n / 10**power for n in numbers]))
        assert missing is None
        assert all(Fraction(int(w), 10**found) == Fraction(n, 10**power) for w, n in zip(whole, numbers, strict=True))


def test_no_values() -> None:
    assert scale(np.array([]), Factor(3, 7), float).size == 0
    whole, _, missing = Decimals().find(np.array([]))
    assert whole.size == 0
    assert missing is None


def test_doubles_of_more_than_15_digits_are_told_from_decimals() -> None:
    draw = random.Random(5)
    texts = []
    for _ in range(50_000):
        digits = draw.randint(1, 17)
        texts.append(f"{draw.randint(10 ** (digits - 1), 10**digits - 1)}e{draw.randint(-8, 15) - digits}")
    ends = [10.0**power for power in range(-8, 16)]
    numbers = np.array([*map(float, texts), *ends, *np.nextafter(ends, 0.0), *np.nextafter(ends, np.inf), 0.0])
    longer = [len(f"{x!r}".partition("e")[0].replace(".", "").strip("0")) > DECIMAL_DIGITS for x in numbers.tolist()]
    inside = (numbers >= 1e-8) & (numbers < 1e15)
    assert (has_more_digits(numbers) == (inside & np.array(longer))).all()
    assert (has_more_digits(-numbers) == has_more_digits(numbers)).all()
