"""Units: what expressions mean, which fit one another, and that every conversion is the nearest double."""

import contextlib
import math
import random
from collections.abc import Callable
from fractions import Fraction
from itertools import product

import mpmath
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from dynamics_cli.core.units import conversion, expressions, lookup, names, near_names
from dynamics_cli.core.units.conversion import convert, from_si, to_si
from dynamics_cli.core.units.lookup import candidates, parse_pair, parse_unit
from dynamics_cli.core.units.unit import Unit, conformable
from dynamics_cli.errors import FaultError, UsageError

TABLE = [unit for _, _, unit, _ in names.all_units()]
PAIRS = [(a, b) for a, b in product(TABLE, TABLE) if conformable(a, b)]
MIXED = [
    parse_unit(text)
    for text in ("m/s", "km/h", "ft/s", "mph", "rad/s", "deg/s", "rpm", "kg*m^2", "slug*ft^2", "lb/in^3", "1/in", "N*m")
]
LARGEST = Fraction(2**1024 - 2**970)
with mpmath.workdps(120):
    _SIGN, _MANTISSA, _EXPONENT, _ = mpmath.mpf(mpmath.pi)._mpf_
PI = Fraction(int(_MANTISSA)) * Fraction(2) ** _EXPONENT


def exactly(value: Fraction, source: Unit, target: Unit) -> Fraction:
    """The conversion in plain fractions, with π from mpmath to 120 digits: nothing of the code under test."""

    def factor(unit: Unit) -> Fraction:
        return Fraction(unit.numerator, unit.denominator) * PI**unit.pi

    return (value * factor(source) + Fraction(*source.offset) - Fraction(*target.offset)) / factor(target)


def assert_nearest(value: float, reference: Fraction) -> None:
    """No neighbouring double is nearer: the definition of half an ulp, right at powers of two as well."""
    error = abs(Fraction(value) - reference)
    for neighbour in (math.nextafter(value, math.inf), math.nextafter(value, -math.inf)):
        if math.isfinite(neighbour):
            assert error <= abs(Fraction(neighbour) - reference)


def check(call: Callable[[], float], reference: Fraction) -> None:
    """A call answers with the nearest double, or refuses because there is none."""
    if abs(reference) >= LARGEST or 0 < abs(reference) <= Fraction(1, 2**1075):
        with pytest.raises(UsageError) as refusal:
            call()
        assert refusal.value.code == "range"
    else:
        assert_nearest(call(), reference)


def decimals() -> "st.SearchStrategy[Fraction]":
    """Decimal values of up to 17 digits from 1e-300 to 1e300, either sign."""
    digits = st.integers(min_value=-(10**17), max_value=10**17)
    return st.builds(lambda d, e: Fraction(d) * Fraction(10) ** e, digits, st.integers(-300, 283))


def test_the_reference_value_of_pi() -> None:
    assert conversion.pi_to(conversion.PI_DIGITS) == conversion.PI
    assert abs(PI - Fraction(conversion.pi_to(110), 10**110)) < Fraction(1, 10**109)
    with mpmath.workdps(1020):
        assert str(conversion.pi_to(1000)) == mpmath.nstr(+mpmath.pi, 1010).replace(".", "")[:1001]


def test_every_pair_within_a_kind_is_correctly_rounded() -> None:
    chance = random.Random(1959)
    assert len(PAIRS) > 900
    for source, target in PAIRS:
        for _ in range(25):
            value = Fraction(chance.randrange(-(10**16), 10**16)) * Fraction(10) ** chance.randrange(-316, 284)
            reference = exactly(value, source, target)
            answer = convert(value.numerator, value.denominator, source, target)
            check(lambda answer=answer: conversion.nearest(*answer), reference)


@given(st.sampled_from(PAIRS + list(product(MIXED[:4], MIXED[:4]))), decimals())
def test_conversion_is_correctly_rounded(pair: tuple[Unit, Unit], value: Fraction) -> None:
    answer = convert(value.numerator, value.denominator, *pair)
    check(lambda: conversion.nearest(*answer), exactly(value, *pair))


@given(st.sampled_from(TABLE + MIXED), decimals())
def test_reading_into_si_is_correctly_rounded(unit: Unit, value: Fraction) -> None:
    base = Unit("", 1, 1, unit.dimension)
    check(lambda: to_si(value.numerator, value.denominator, unit), exactly(value, unit, base))


@given(st.sampled_from(TABLE + MIXED), st.floats(allow_nan=False, allow_infinity=False))
def test_writing_from_si_is_correctly_rounded(unit: Unit, value: float) -> None:
    base = Unit("", 1, 1, unit.dimension)
    check(lambda: from_si(value, unit), exactly(Fraction(value), base, unit))


@given(st.sampled_from(PAIRS), decimals())
def test_there_and_back_is_exact_in_ratios(pair: tuple[Unit, Unit], value: Fraction) -> None:
    numerator, denominator, pi = convert(value.numerator, value.denominator, *pair)
    assume(not pi)
    assert convert(numerator, denominator, pair[1], pair[0]) == (value.numerator, value.denominator, 0)


@given(st.integers(2**52, 2**53 - 1), st.sampled_from([1, -1, 2]), st.integers(80, 200), st.booleans())
def test_values_within_a_hair_of_a_tie_go_the_right_way(whole: int, power: int, digits: int, above: bool) -> None:
    tie = Fraction(2 * whole + 1, 2)
    with mpmath.workdps(500):
        _, mantissa, exponent, _ = mpmath.mpf(mpmath.pi)._mpf_
    pi = Fraction(int(mantissa)) * Fraction(2) ** exponent
    near = Fraction(int(tie / pi**power * 10**digits) + above, 10**digits)
    expected = float(whole + 1) if near * pi**power > tie else float(whole)
    assert conversion.nearest(near.numerator, near.denominator, power) == expected


@pytest.mark.parametrize(
    ("value", "source", "target", "expected"),
    [
        ("60", "mph", "ft/s", 88.0),
        ("98.6", "degF", "degC", 37.0),
        ("25", "degC", "degF", 77.0),
        ("-40", "degC", "degF", -40.0),
        ("-459.67", "degF", "K", 0.0),
        ("1", "rev/s", "rpm", 60.0),
        ("180", "deg", "rad", math.pi),
        ("1", "rpm", "rad/s", 0.10471975511965978),
        ("1", "hp", "ft lb/sec", 550.0),
        ("1", "kip", "lb", 1000.0),
        ("1", "N/m2", "Pa", 1.0),
        ("100", "km/h", "m/s", 27.77777777777778),
        ("36", "in. lb", "ft lb", 3.0),
    ],
)
def test_conversions_by_hand(value: str, source: str, target: str, expected: float) -> None:
    number = Fraction(value)
    assert conversion.nearest(*convert(number.numerator, number.denominator, *parse_pair(source, target))) == expected


def test_out_of_range_is_refused() -> None:
    with pytest.raises(UsageError, match="beyond the range of a double") as refusal:
        conversion.nearest(10**400, 1)
    assert refusal.value.code == "range"
    with pytest.raises(UsageError, match="beyond the range"):
        conversion.nearest(10**400, 1, 1)
    with pytest.raises(UsageError, match="too close to zero"):
        conversion.nearest(1, 10**400, -1)
    assert conversion.nearest(0, 5, 1) == 0.0
    assert conversion.nearest(1, 2**1074) == 5e-324
    for value in (math.nan, math.inf):
        with pytest.raises(FaultError):
            from_si(value, parse_unit("ft"))


SAME = [
    ("m/s^2", "m/s2", "m/s**2", "m/s²", "m s^-2", "m s⁻²", "m·s-2", "m/(s*s)", "m/s/s", "meters per second per second"),
    ("kg*m^2", "kg·m²", "kg m2", "kg⋅m^2", "kg-m^2", "m^2*kg", "kilogram square meter", "kg*(m)^2"),
    ("lbf*ft", "lbf ft", "lbf-ft", "pound_force foot", "lbft", "lbf.ft"),
    ("ft/sec2", "ft/s^2", "feet/second^2", "ft per s per s"),
    ("1/in", "in^-1", "per inch", "in.-1", "1/in.", "/in", "(/in)"),
    ("mi/hr", "mph", "miles per hour", "mile/hour"),
    ("sq ft", "ft^2", "square feet", "ft2", "sqft", "ft²"),
    ("cu in", "in.3", "in^3", "cubic inches"),
    ("µm", "um", "μm", "micrometer", "micron"),
    ("Ω", "\u2126", "ohm", "V/A"),
    ("°C", "degC", "\u2103", "celsius"),
]


@pytest.mark.parametrize("spellings", SAME)
def test_spellings_of_one_unit(spellings: tuple[str, ...]) -> None:
    first = parse_unit(spellings[0])
    for text in spellings[1:]:
        other = parse_unit(text)
        assert (other.numerator, other.denominator, other.pi) == (first.numerator, first.denominator, first.pi), text
        assert (other.dimension, other.offset) == (first.dimension, first.offset), text
        assert other.text == text


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("kg/m s", "ambiguous-unit"),
        ("kg/m*s", "ambiguous-unit"),
        ("J/kg·K", "ambiguous-unit"),
        ("kg/3 m", "unit-syntax"),
        ("3 m", "unit-syntax"),
        ("1 m", "unit-syntax"),
        ("m^0.5", "unit-syntax"),
        ("m^(1/2)", "unit-syntax"),
        ("m^0", "unit-syntax"),
        ("m^99", "unit-syntax"),
        ("(m^9)^9", "unit-syntax"),
        ("m^", "unit-syntax"),
        ("/", "unit-syntax"),
        ("//s", "unit-syntax"),
        ("m/", "unit-syntax"),
        ("m//s", "unit-syntax"),
        ("(m", "unit-syntax"),
        ("m)", "unit-syntax"),
        ("()", "unit-syntax"),
        ("(" * 500 + "m" + ")" * 500, "unit-syntax"),
        ("((((((((((m))))))))))", "unit-syntax"),
        ("m;s", "unit-syntax"),
        ("m\x00", "unit-syntax"),
        ("metr", "unknown-unit"),
        ("k", "unknown-unit"),
        ("e", "unknown-unit"),
        ("G", "unknown-unit"),
        ("gauss", "unknown-unit"),
        ("dB", "unknown-unit"),
        ("bit", "unknown-unit"),
        ("_", "unknown-unit"),
        ("Qm^20 Qm^20 Qm^20 Qm^20 Qm^20 Qm^20", "range"),
    ],
)
def test_refused_units(text: str, code: str) -> None:
    with pytest.raises(UsageError) as refusal:
        parse_unit(text)
    assert refusal.value.code == code
    assert refusal.value.hint
    assert len(refusal.value.message) < 400


@pytest.mark.parametrize(
    ("text", "wanted", "kind", "note"),
    [
        ("lb", "kg", "mass", "lb read as pound-mass"),
        ("lb", "N", "force", "lb read as pound-force"),
        ("lb", None, "mass", "lb read as pound-mass"),
        ("lb/in.2", "Pa", "pressure or stress", "lb read as pound-force"),
        ("lb/ft3", "kg/m^3", "density", "lb read as pound-mass"),
        ("lb/ft3", "N/m^3", "weight density", "lb read as pound-force"),
        ("oz", "N", "force", "oz read as ounce-force"),
        ("lb ft", "N*m", "torque", "lb read as pound-force"),
        ("ft lb", "J", "torque or energy", "lb read as pound-force"),
        ("g", "kg", "mass", None),
        ("g", "m/s^2", "acceleration", "g read as standard gravity, 9.80665 m/s^2"),
        ("g/cm3", "kg/m^3", "density", None),
    ],
)
def test_units_with_two_readings(text: str, wanted: str | None, kind: str, note: str | None) -> None:
    unit = parse_unit(text, parse_unit(wanted) if wanted else None)
    assert names.kind_name(unit) == kind
    assert unit.notes == ((note,) if note else ())


def test_all_readings_and_one_reading_per_expression() -> None:
    assert [names.kind_name(unit) for unit in candidates("lb")] == ["mass", "force"]
    assert len(candidates("lb/lb")) == 2
    assert all(unit.numerator == unit.denominator for unit in candidates("lb/lb"))
    assert [unit.dimension for unit in parse_pair("lb", "N")] == [(1, 1, -2, 0, 0, 0, 0, 0)] * 2
    assert parse_pair("lb", "slug")[0].dimension == parse_pair("lb", "lb")[0].dimension == parse_unit("kg").dimension


KINDS_APART = [
    ("Hz", "rad/s", "rpm"),
    ("rpm", "1/s", "Hz"),
    ("cycle/s", "rad/s", "rev/s"),
    ("J", "N*m", "force first"),
    ("Nm", "J", "force first"),
    ("kWh", "lbf*ft", "force first"),
    ("lbf", "kg", "--weight"),
    ("deg", "m/m", "angle"),
    ("mph", "kg", "slug"),
]


@pytest.mark.parametrize(("first", "second", "hint"), KINDS_APART)
def test_kinds_that_do_not_mix(first: str, second: str, hint: str) -> None:
    a, b = parse_pair(first, second)
    assert not conformable(a, b)
    message, mend = names.explain_mismatch(a, b)
    assert message == f"{first} is {message.split(' is ')[1].split(',')[0]}, {second} is {message.split(' is ')[-1]}"
    assert hint in mend


@pytest.mark.parametrize(
    ("text", "tag"),
    [
        ("J", "energy"), ("kWh", "energy"), ("cal", "energy"), ("BTU", "energy"), ("eV", "energy"), ("erg", "energy"),
        ("Nm", "torque"), ("kNm", "torque"), ("N*m", "torque"), ("lbf ft", "torque"), ("lbft", "torque"),
        ("ft lbf", ""), ("ft*lbf", ""), ("in. lbf", ""), ("m*N", ""), ("ft_lb", ""), ("kg*m^2/s^2", ""), ("J/m", ""),
        ("N*m/rad", ""), ("Nm s", ""), ("W*s", ""), ("therm", "energy"),
    ],
)  # fmt: skip
def test_torque_and_energy_tags(text: str, tag: str) -> None:
    assert parse_unit(text).tag == tag


def test_an_untagged_product_fits_both() -> None:
    for text in ("ft lbf", "kg*m^2/s^2"):
        assert conformable(parse_unit(text), parse_unit("J"))
        assert conformable(parse_unit(text), parse_unit("N*m"))
    assert parse_unit("ft lb", tag="torque").dimension == parse_unit("kg*ft").dimension


# Each of these comes out of pint 0.25 without an error, and wrong or doubtful.
def test_traps_of_pint() -> None:
    assert names.kind_name(parse_unit("Nm")) == "torque"
    assert names.kind_name(parse_unit("mil")) == "length"
    assert names.kind_name(parse_unit("PS")) == "power"
    assert parse_unit("cycle/s").dimension == parse_unit("Hz").dimension
    assert parse_unit("rev/s").pi == 1
    assert not conformable(parse_unit("Hz"), parse_unit("rad/s"))


def test_units_beyond_the_table_come_from_pint() -> None:
    assert parse_unit("light_year").numerator == 9460730472580800
    assert parse_unit("circular_mil").pi == 1
    assert parse_unit("mps").notes == ("mps read as meter_per_second",)
    assert parse_unit("réaumur").offset == (5463, 20)
    assert parse_unit("planck_mass").notes[-1].endswith("only approximately")
    assert names.kind_name(parse_unit("Bq")) == "frequency"
    assert parse_unit("lm").dimension == (0, 0, 0, 0, 0, 0, 1, 2)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [("foots/s2x", None), ("KG", "kg"), ("metr", "meter"), ("mhp", "mph"), ("Mph", "mph"), ("ponds", "pounds"),
     ("milimeter", "millimeter"), ("newtn", "newton"), ("psii", "psi")],
)  # fmt: skip
def test_near_names(typed: str, meant: str | None) -> None:
    assert meant is None or meant in near_names.names_like(typed)


def test_unknown_units_name_near_ones() -> None:
    with pytest.raises(UsageError) as refusal:
        parse_unit("kg*metr")
    assert refusal.value.message == "unknown unit 'metr' (in 'kg*metr')"
    assert refusal.value.hint is not None
    assert "meter" in refusal.value.hint


def test_kind_names() -> None:
    for unit in TABLE:
        assert not names.kind_name(unit).startswith("quantity in"), unit.text
    assert names.kind_name(parse_unit("kg*m/s^5")) == "quantity in m·kg/s^5"
    assert parse_unit("m·kg/s^5").dimension == parse_unit("kg*m/s^5").dimension
    assert names.kind_name(parse_unit("")) == "pure number"


def test_conformable_names_are_conformable() -> None:
    for text in ("m", "kg", "N", "J", "N*m", "rad/s", "m/s", "K", "kg*m^2"):
        unit = parse_unit(text)
        listed = names.conformable_names(unit)
        assert listed
        assert all(any(conformable(other, unit) for other in candidates(name)) for name in listed)


@given(st.text(alphabet="mskgNfper19^*/ ·²³-.(", max_size=9))
@example("m/s²")
@example("kg*m^2")
@example("1/s")
@example("lbf*ft/in")
@settings(max_examples=2000)
def test_what_is_read_without_the_grammar_is_read_as_the_grammar_does(text: str) -> None:
    plain = lookup._plain_factors(text.strip())
    if plain:
        assert plain == expressions.factors(text.strip())


def test_caches_do_not_grow_without_end() -> None:
    for power in range(lookup.CACHE_SIZE + 10):
        parse_unit(f"m{' ' * (power % 50)}*{' ' * (power // 50)}s")
    assert len(lookup._candidates) <= lookup.CACHE_SIZE


@settings(max_examples=300, deadline=None)
@given(st.text(alphabet="kmsNlbft ginrad°²⁻-*/^().0123456789per·", max_size=20))
def test_any_text_is_a_unit_or_refused(text: str) -> None:
    found: list[Unit] = []
    with contextlib.suppress(UsageError):
        found = candidates(text)
    assert all(unit.denominator > 0 and unit.numerator > 0 for unit in found)


def test_a_grade_is_neither_a_slope_nor_a_gon_by_itself() -> None:
    for text in ("grade", "% grade", "grade/m"):
        with pytest.raises(UsageError, match="both a slope and 1/400 of a turn"):
            lookup.parse_unit(text)
    assert lookup.parse_unit("gon").pi == 1
