"""Compound units: parts that add up, in and out."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dynamics_cli.core.units.compound import from_exact_compound, from_si_compound, parse_compound
from dynamics_cli.core.units.conversion import to_si
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.errors import UsageError

FEET = parse_compound("ft;in")
ARC = parse_compound("deg;min;s")


@pytest.mark.parametrize(
    ("value", "units", "parts"),
    [
        (1.6764, FEET, (5, 6.0)),
        (-1.6764, FEET, (-5, -6.0)),
        (1.8288, FEET, (6, 0.0)),
        (-0.1524, FEET, (0, -6.0)),
        (0.0, FEET, (0, 0.0)),
        (math.pi / 4, ARC, (45, 0, 0.0)),
        (1609.344 + 0.3048, parse_compound("mi;ft;in"), (1, 1, 0.0)),
        (3661.5, parse_compound("h;min;s"), (1, 1, 1.5)),
        (86399.99999999999, parse_compound("h;min;s"), (23, 59, 59.99999999999)),
        (6.80388555, parse_compound("stone;lb"), (1, 1.0)),
    ],
)
def test_splitting(value: float, units: tuple, parts: tuple) -> None:
    answer = from_si_compound(value, units)
    assert answer == parts
    assert all(isinstance(part, int) for part in answer[:-1])
    assert isinstance(answer[-1], float)
    assert math.copysign(1.0, answer[-1]) == (-1.0 if parts[-1] < 0 else 1.0)


def test_splitting_an_exact_number() -> None:
    assert from_exact_compound(18796, 10000, parse_unit("m"), FEET) == (6, 2.0)
    assert from_exact_compound(1, 1, parse_unit("rad"), ARC) == (57, 17, 44.80624709635516)
    assert from_exact_compound(1, 3, parse_unit("yd"), FEET) == (1, 0.0)
    # Two thirds of a hair below six feet: the inches round to twelve and are carried.
    assert from_exact_compound(72 * 10**40 - 1, 10**40, parse_unit("in"), FEET) == (6, 0.0)
    almost_a_degree = 3600 * 10**40 - 1
    assert from_exact_compound(almost_a_degree, 10**40, parse_unit("arcsec"), ARC) == (1, 0, 0.0)


@given(st.floats(-1e12, 1e12), st.sampled_from([FEET, parse_compound("mi;yd;ft;in"), parse_compound("kg;g")]))
def test_the_parts_add_up_to_the_very_double(value: float, units: tuple) -> None:
    parts = from_si_compound(value, units)
    total = sum(
        (Fraction(part) * Fraction(unit.numerator, unit.denominator) for part, unit in zip(parts, units, strict=True)),
        Fraction(0),
    )
    # The last part is itself a double: half its last place, and half of the value's, are all that may be lost.
    size = Fraction(units[-1].numerator, units[-1].denominator)
    allowed = Fraction(math.ulp(parts[-1])) / 2 * size + Fraction(math.ulp(value)) / 2
    assert abs(total - Fraction(value)) <= allowed
    assert all(part <= 0 for part in parts) or all(part >= 0 for part in parts)
    for part, unit, larger in zip(parts[1:], units[1:], units, strict=False):
        assert abs(Fraction(part)) * Fraction(unit.numerator, unit.denominator) < Fraction(
            larger.numerator, larger.denominator
        )


@given(st.integers(0, 10**6), st.integers(0, 11), st.integers(0, 9999))
def test_what_was_written_comes_back(feet: int, inches: int, fraction: int) -> None:
    written = Fraction(feet * 12 + inches) + Fraction(fraction, 10000)
    value = to_si(written.numerator, written.denominator, parse_unit("in"))
    assert from_si_compound(value, FEET) == (feet, float(inches + Fraction(fraction, 10000)))


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("in;ft", "unit-syntax"),
        ("ft;ft", "unit-syntax"),
        ("ft;kg", "kind"),
        ("ft;", "unit-syntax"),
        (";", "unit-syntax"),
        ("K;degC", "unit-syntax"),
        ("ft;metr", "unknown-unit"),
    ],
)
def test_refused_compounds(text: str, code: str) -> None:
    with pytest.raises(UsageError) as refusal:
        parse_compound(text)
    assert refusal.value.code == code


def test_minutes_after_degrees_are_of_arc() -> None:
    assert [unit.text for unit in ARC] == ["deg", "arcmin", "arcsec"]
    assert [unit.text for unit in parse_compound("h;min;s")] == ["h", "min", "s"]
    assert [unit.text for unit in parse_compound("ft")] == ["ft"]
