"""The text of quantities: what is read, exactly as what, and what is refused in which words."""

import math
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import mpmath as mp
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from dynamics_cli import quantities as q
from dynamics_cli.core.inputs import quantity_text
from dynamics_cli.core.inputs.forms.lists import share_unit
from dynamics_cli.core.inputs.forms.splitting import split_list, split_pairs
from dynamics_cli.core.inputs.quantity_text import (
    is_uncertain,
    read_amount,
    read_fraction,
    read_number,
    read_scalar,
    total,
)
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Kind

KINDS: list[Kind] = [
    kind for kind in vars(q).values() if isinstance(kind, Kind) and kind.form in ("scalar", "slope", "whole")
]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0", "0"), ("60", "60"), ("-60", "-60"), ("+60", "60"), ("−60", "-60"), ("60.5", "60.5"), ("5.", "5"),
        (".5", "0.5"), ("-.5", "-0.5"), ("1e3", "1000"), ("1E3", "1000"), ("1.5e+3", "1500"), ("15e-1", "1.5"),
        ("1e−3", "0.001"), ("007", "7"), ("0.1", "0.1"), ("1e-999", "1e-999"), ("9" * 400, "9" * 400),
        ("0e999", "0"),
    ],
)  # fmt: skip
def test_numbers(text: str, value: str) -> None:
    numerator, denominator = read_number(text)
    assert Fraction(numerator, denominator) == Fraction(value)


@pytest.mark.parametrize(
    "text",
    [
        "", " ", "-", "+", ".", "e3", ".e3", "1e", "1e+", "1e1.5", "1.2.3", "--1", "+-1", "1-", "nan", "inf", "-inf",
        "Infinity", "1_000", "1,5", "1,000.5", "0x10", "0b1", "1e400000", "1e1000", "٣", "１", "1²", "½", "1 000",
        "1\x00", "1e3e3", "1e3.0", "9" * 401, "1j", "1d3", "²", "1e²",
    ],
)  # fmt: skip
def test_what_is_no_number(text: str) -> None:
    with pytest.raises(UsageError) as refusal:
        read_number(text)
    assert refusal.value.code in ("number", "range")
    assert len(refusal.value.message) < 200


@given(st.floats(allow_nan=False, allow_infinity=False))
@example(-0.0)
def test_every_double_is_read_exactly_from_its_repr(value: float) -> None:
    numerator, denominator = read_number(repr(value))
    assert Fraction(numerator, denominator) == Fraction(repr(value))


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("60 mph", [(60, "mph")]),
        ("60mph", [(60, "mph")]),
        ("  60\tmph ", [(60, "mph")]),
        ("60\u00a0mph", [(60, "mph")]),
        ("-40degC", [(-40, "degC")]),
        ("5e3m", [(5000, "m")]),
        ("5eV", [(5, "eV")]),
        ("5 eV", [(5, "eV")]),
        ("5e", [(5, "e")]),
        ("60 ft/sec2", [(60, "ft/sec2")]),
        ("2 slug ft2", [(2, "slug ft2")]),
        ("3 lb/in.2", [(3, "lb/in.2")]),
        ("8 1/in", [(8, "1/in")]),
        ("8/in", [(8, "/in")]),
        ("2 m ^ 2", [(2, "m ^ 2")]),
        ("2 m ** 2", [(2, "m ** 2")]),
        ("3 %", [(3, "%")]),
        ("0.7", [(Fraction(7, 10), "")]),
        ("5 ft 6 in", [(5, "ft"), (6, "in")]),
        ("5ft 6in", [(5, "ft"), (6, "in")]),
        ("-5 ft 6 in", [(-5, "ft"), (-6, "in")]),
        ("-5 ft -6.0 in", [(-5, "ft"), (-6, "in")]),
        ("0 ft -6 in", [(0, "ft"), (-6, "in")]),
        ("-0 ft 6 in", [(0, "ft"), (-6, "in")]),
        ("3 deg 20 min 5 s", [(3, "deg"), (20, "min"), (5, "s")]),
        ("3°20′5.5″", [(3, "°"), (20, "′"), (Fraction(11, 2), "″")]),
        ("3 kg/3 m", [(3, "kg/3 m")]),
    ],
)
def test_amounts(text: str, parts: list) -> None:
    assert [(Fraction(n, d), unit) for n, d, unit in read_amount(text).parts] == parts


READ = [
    ("60 ft", q.Length, 18.288, 60, "ft"),
    ("60", q.Friction, 60.0, 60, ""),
    ("70 %", q.Friction, 0.7, 70, "%"),
    ("-3 %", q.Slope, -0.03, -3, "%"),
    ("0.05", q.Slope, 0.05, 0.05, ""),
    ("45 deg", q.Slope, 1.0, 45, "deg"),
    ("-0.1 rad", q.Slope, math.tan(-0.1), -0.1, "rad"),
    ("5 ft 6 in", q.Length, 1.6764, 66, "in"),
    ("-5 ft 6 in", q.Length, -1.6764, -66, "in"),
    ("5 ft 6.5 in", q.Length, 1.6891, 66.5, "in"),
    ("1 mi 2 yd 1 ft", q.Length, 1611.4776, 5287, "ft"),
    ("3 deg 20 min 5 s", q.Angle, 0.0582018824171998, 12005, "arcsec"),
    ("1 h 20 min", q.Time, 4800.0, 80, "min"),
    ("1 lb 8 oz", q.Mass, 0.68038855500, 24, "oz"),
    ("20 degC", q.Temperature, 293.15, 20, "degC"),
    ("-40degF", q.Temperature, 233.15, -40, "degF"),
    ("0.7 g", q.Deceleration, 6.864655, 0.7, "g"),
    ("700 g", q.Mass, 0.7, 700, "g"),
    ("150 lb", q.Weight, 667.233242289075, 150, "lb"),
    ("150 lb", q.Mass, 68.0388555, 150, "lb"),
    ("30 lb ft", q.Torque, 40.67453844994201, 30, "lb ft"),
    ("30 ft lb", q.Torque, 40.67453844994201, 30, "ft lb"),
    ("30 ft lb", q.Energy, 40.67453844994201, 30, "ft lb"),
    ("1500 rpm", q.ShaftSpeed, 157.07963267948966, 1500, "rpm"),
    ("8 1/in", q.DiametralPitch, 8 / 0.0254, 8, "1/in"),
    ("8/in", q.DiametralPitch, 8 / 0.0254, 8, "/in"),
    ("3", q.Count, 3.0, 3, ""),
    ("1e3", q.Count, 1000.0, 1000, ""),
    ("9007199254740993", q.Ratio, 9007199254740992.0, 9007199254740992.0, ""),
    ("1e310 nm", q.Length, None, None, ""),
    ("6'2\"", q.Length, 1.8796, 74, "in"),
    ("6’ 2 1/2”", q.Length, 1.8923, 74.5, "in"),
    ('5"', q.Length, 0.127, 5, "in"),
    ('-3/8"', q.Length, -0.009525, -0.375, "in"),
    ("1/2 in", q.Length, 0.0127, 0.5, "in"),
    ("12 1/2 in", q.Length, 0.3175, 12.5, "in"),
    ("-12-1/2 in", q.Length, -0.3175, -12.5, "in"),
    ("5 ft 6 1/2 in", q.Length, 1.6891, 66.5, "in"),
    ("1/3 ft", q.Length, 0.1016, 1 / 3, "ft"),
    ("1/2", q.Friction, 0.5, 0.5, ""),
    ("5 ft + 6.5 in", q.Length, 1.6891, 66.5, "in"),
    ("5 ft +6 in", q.Length, 1.6764, 66, "in"),
    ("2.5 ft + 14 in", q.Length, 1.1176, 44.0, "in"),
    ("1e+2 m", q.Length, 100.0, 100.0, "m"),
    ("1,234,567 m", q.Length, 1234567.0, 1234567, "m"),
    ("1,234.5 m", q.Length, 1234.5, 1234.5, "m"),
    ("45°30'", q.Angle, 0.7941248096574199, 2730, "arcmin"),
    ("45°30'15\"", q.Angle, 0.7941975317095864, 163815, "arcsec"),
    ("1h30m", q.Time, 5400.0, 90, "min"),
    ("1h30m15s", q.Time, 5415.0, 5415, "s"),
    ("5ft6in", q.Length, 1.6764, 66, "in"),
    ("2:30:00", q.Time, 9000.0, 9000, "s"),
    ("0:00:07.5", q.Time, 7.5, 7.5, "s"),
    ("20 C", q.Temperature, 293.15, 20, "C"),
    ("68 degrees Fahrenheit", q.Temperature, 293.15, 68, "degrees Fahrenheit"),
    ("60 KM/H", q.Speed, 60 / 3.6, 60, "KM/H"),
    ("5 Feet", q.Length, 1.524, 5, "Feet"),
    ("60 M/S", q.Speed, 60.0, 60, "M/S"),
]


@pytest.mark.parametrize(("text", "kind", "si", "value", "unit"), READ)
def test_scalars(text: str, kind: Kind, si: float | None, value: float, unit: str) -> None:
    if si is None:
        with pytest.raises(UsageError, match="beyond the range of a double"):
            read_scalar(text, kind)
        return
    reading = read_scalar(text, kind)
    assert (reading.si, reading.value, reading.unit) == (si, value, unit)
    assert type(reading.value) is type(value)


@pytest.mark.parametrize(("unit", "circle"), [("deg", 360), ("gon", 400), ("turn", 1), ("rev", 1), ("arcmin", 21600)])
def test_parts_of_a_circle_are_the_doubles_nearest_to_them(unit: str, circle: int) -> None:
    """Multiples of 30° and 45° up to three turns: against π in 60 digits, rounded once."""
    for twelfths in (Fraction(k, 12) for k in range(-36, 37)):
        for share in (twelfths, twelfths * 3 / 2):
            written = Fraction(circle) * share
            digits = str(Decimal(written.numerator) / Decimal(written.denominator))
            with mp.workdps(60):
                exact = 2 * mp.pi * Fraction(digits).numerator / Fraction(digits).denominator / circle
            assert read_scalar(f"{digits} {unit}", q.Angle).si == float(exact)


@pytest.mark.parametrize("text", ["90 deg", "100 gon", "0.25 turn", "90°", "90 deg 0 min", "5400 arcmin", "25e-2 rev"])
def test_a_right_angle_is_one_double_however_it_is_written(text: str) -> None:
    assert read_scalar(text, q.Angle).si == math.pi / 2
    assert read_scalar(f"-{text}", q.Angle).si == -math.pi / 2


def test_notes_say_how_a_unit_with_two_readings_was_read() -> None:
    assert read_scalar("150 lb", q.Force).notes == ("lb read as pound-force",)
    assert read_scalar("150 lb", q.Mass).notes == ("lb read as pound-mass",)
    assert read_scalar("0.7 g", q.Acceleration).notes == ("g read as standard gravity, 9.80665 m/s^2",)
    assert read_scalar("7 g", q.Mass).notes == ()


def test_a_default_unit_stands_in() -> None:
    assert read_scalar("60", q.Length, "ft").si == 18.288
    assert read_scalar("60 m", q.Length, "ft").si == 60.0
    assert read_scalar("3", q.Slope, "%").si == 0.03
    assert read_scalar("60", q.Length, "ft").unit == "ft"
    with pytest.raises(UsageError, match="kg is a mass, m is a length"):
        read_scalar("60", q.Length, "kg")


REFUSED = [
    ("60", q.Length, "missing-unit", "'60' has no unit"),
    ("60 %", q.Length, "kind", "% is a pure number, m is a length"),
    ("60 mph", q.Mass, "kind", "mph is a speed, kg is a mass"),
    ("0.7 m", q.Friction, "kind", "m is a length, a number without a unit is a pure number"),
    ("60 Hz", q.AngularSpeed, "kind", "Hz is a frequency, rad/s is an angular speed"),
    ("60 rpm", q.Frequency, "kind", "rpm is an angular speed"),
    ("30 J", q.Torque, "kind", "J is an energy"),
    ("30 N*m", q.Energy, "kind", "N*m is a torque"),
    ("30 lbf", q.Mass, "kind", "lbf is a force, kg is a mass"),
    ("30 kg", q.Force, "kind", "kg is a mass, N is a force"),
    ("30 deg", q.Friction, "kind", "deg is an angle"),
    ("-5 kg", q.Mass, "bounds", "must be at least 0 kg"),
    ("0 N", q.Weight, "bounds", "must be greater than 0 N"),
    ("-500 degC", q.Temperature, "bounds", "must be at least 0 K"),
    ("-0.1", q.Friction, "bounds", "must be at least 0"),
    ("90 deg", q.Slope, "bounds", "90 deg or more"),
    ("-90 deg", q.Slope, "bounds", "90 deg or more"),
    ("100 grad", q.Slope, "bounds", "90 deg or more"),
    ("0.25 rev", q.Slope, "bounds", "90 deg or more"),
    ("2 rad", q.Slope, "bounds", "90 deg or more"),
    ("3.5", q.Count, "whole", "not a whole number"),
    ("3 %", q.Count, "whole", "not a whole number"),
    ("-3", q.Count, "bounds", "at least 0"),
    ("1e17", q.Count, "bounds", "at most 9007199254740992"),
    ("100000000000000000000", q.Teeth, "bounds", "at most 9007199254740992"),
    ("5 ft 6", q.Length, "missing-unit", "a number has no unit"),
    ("6 ft 2 kg", q.Length, "kind", "cannot both be parts of one value"),
    ("5.5 ft 6 in", q.Length, "syntax", "the number of ft is not whole"),
    ("5 ft 14 in", q.Length, "syntax", "that many in are more than one ft"),
    ("5 ft 12 in", q.Length, "syntax", "that many in are more than one ft"),
    ("6 in 5 ft", q.Length, "syntax", "ft is not smaller than in"),
    ("5 ft 6 ft", q.Length, "syntax", "ft is not smaller than ft"),
    ("5 ft -6 in", q.Length, "syntax", "a sign inside"),
    ("20 degC 5 K", q.Temperature, "syntax", "a temperature cannot have several parts"),
    ("1 m 1 m 1 m 1 m 1 m 1 m 1 m", q.Length, "number", "not a decimal number"),
    ("5' 6\"", q.Angle, "kind", "in is a length, rad is an angle"),
    ("8 3/2 in", q.Length, "number", "3/2 is not less than 1"),
    ("8 1/0 in", q.Length, "number", "divides by zero"),
    ("1/2/3 in", q.Length, "unit-syntax", "cannot read"),
    ("5 ft + 6 kg", q.Length, "kind", "cannot both be parts of one value"),
    ("2:30", q.Time, "ambiguous", "may be hours and minutes or minutes and seconds"),
    ("2:70:00", q.Time, "syntax", "are more than one h"),
    ("12,34 m", q.Length, "number", "not a decimal number"),
    ("0,500 m", q.Length, "number", "not a decimal number"),
    ("5 KN", q.Length, "ambiguous-unit", "'KN' may be kN or kn"),
    ("3 kg/3 m", q.LinearDensity, "unit-syntax", "a number inside the unit"),
    ("3 kg/m s", q.Density, "ambiguous-unit", "two ways"),
    ("60 ftt", q.Length, "unknown-unit", "unknown unit 'ftt'"),
    ("1,5 m", q.Length, "number", "'1,5' is not a decimal number"),
    ("1,000 m", q.Length, "number", "'1,000' may be 1000 or 1"),
    ("1_000 m", q.Length, "number", "'1_000' is not a decimal number"),
    ("nan", q.Length, "number", "does not begin with a number"),
    ("inf m", q.Length, "number", "does not begin with a number"),
    ("ten m", q.Length, "number", "does not begin with a number"),
    ("٣ m", q.Length, "number", "does not begin with a number"),
    ("1e400000 m", q.Length, "range", "beyond the range"),
    ("1e400 m", q.Length, "range", "beyond the range"),
    ("1e-400 m", q.Length, "range", "too close to zero"),
    ("1" * 500 + " m", q.Length, "number", "more than 400 characters"),
    ("1 " + "m" * 2000, q.Length, "syntax", "too long"),
    ("1 " + "m*" * 200, q.Length, "unit-syntax", "too long"),
    ("", q.Length, "syntax", "the quantity is empty"),
    (" \t", q.Length, "syntax", "the quantity is empty"),
    ("\x1b[31m5 m", q.Length, "number", "does not begin with a number"),
    ("5 m\x00", q.Length, "unit-syntax", "cannot stand in a unit"),
    ("30 mph @ 45 deg", q.Speed, "unit-syntax", "'@' cannot stand in a unit"),
]


@pytest.mark.parametrize(("text", "kind", "code", "words"), REFUSED)
def test_refusals_say_what_was_read_what_was_wanted_and_how_to_mend_it(
    text: str, kind: Kind, code: str, words: str
) -> None:
    with pytest.raises(UsageError) as refusal:
        read_scalar(text, kind)
    error = refusal.value
    assert error.code == code
    assert words in error.message
    named = f" {kind.name}: " in error.message or error.message.endswith("has no unit") or code == "bounds"
    assert named or (kind.form == "whole" and "is not a whole number" in error.message)
    assert error.message.startswith(repr(text[:60])[:-1])
    assert error.hint is not None
    assert kind.example in error.hint
    assert error.parameter is None
    assert error.message.isprintable()
    assert len(error.message) < 400


@pytest.mark.parametrize(
    "text",
    [
        "0.72 ± 0.04", "0.72 +/- 0.04", "0.72±0.04", "1500±50 kg", "0.65..0.75", "20..25 m", "20 .. 25 m", "1..2..3",
        "lognormal(0.7, 0.1)", "truncated(0.7, 0.1, 0, 1)", "normal (1, 2) m", "12..120",
    ],
)  # fmt: skip
def test_uncertain_values_are_recognised_and_refused_where_certain_ones_are_wanted(text: str) -> None:
    assert is_uncertain(text)
    for kind in (q.Friction, q.Length, q.Mass, q.Count):
        with pytest.raises(UsageError, match="a certain value is wanted here") as refusal:
            read_scalar(text, kind)
        assert refusal.value.code == "uncertain"


@pytest.mark.parametrize("text", ["60 ft", "-5 ft 6 in", "5. m", "3 kg/(m s)", "1e-3", "sin(3)", ""])
def test_certain_values_are_not_taken_for_uncertain_ones(text: str) -> None:
    assert not is_uncertain(text)


def test_every_example_is_read_by_its_own_kind() -> None:
    for kind in KINDS:
        reading = read_scalar(kind.example, kind)
        assert math.isfinite(reading.si), kind


def test_totals_without_a_wanted_unit() -> None:
    assert total(read_amount("5 ft 6 in"))[:2] == (66, 1)
    assert total(read_amount("1 yd 1.5 in"))[:2] == (75, 2)
    numerator, denominator, unit = total(read_amount("3 lb 4 oz"))
    assert (numerator, denominator, unit.dimension[1]) == (52, 1, 1)


@given(st.integers(-999, 999), st.integers(0, 2), st.integers(0, 11), st.integers(0, 999))
def test_compounds_are_exact(yards: int, feet: int, inches: int, thousandths: int) -> None:
    sign = -1 if yards < 0 else 1
    reading = read_scalar(f"{yards} yd {feet} ft {inches}.{thousandths:03} in", q.Length)
    value = 36 * yards + sign * (12 * feet + inches + Fraction(thousandths, 1000))
    assert reading.si == float(value * Fraction(254, 10000))
    assert reading.value == float(value)


@pytest.mark.parametrize(
    ("text", "ratio"),
    [
        ("365.2422/27.3217", (3652422, 273217)), ("1/2", (1, 2)), (" 4 / 2 ", (2, 1)), ("13.36", (334, 25)),
        ("-1/3", (-1, 3)), ("1/-3", (-1, 3)), ("0/5", (0, 1)), ("1e-3", (1, 1000)), ("10:1", (10, 1)),
    ],
)  # fmt: skip
def test_fractions(text: str, ratio: tuple[int, int]) -> None:
    assert read_fraction(text) == ratio


@pytest.mark.parametrize("text", ["", "/", "1/", "/2", "1/0", "1/0.0", "1/2/3", "a/b", "1/2 m", "nan/1", "1/2,5"])
def test_refused_fractions(text: str) -> None:
    with pytest.raises(UsageError):
        read_fraction(text)


@pytest.mark.parametrize(
    ("text", "items"),
    [
        ("1, 2, 3 m", ["1", "2", "3 m"]),
        ("60 ft", ["60 ft"]),
        ("[1, 2], (3, 4), {a=1, b=2}", ["[1, 2]", "(3, 4)", "{a=1, b=2}"]),
        ("'a, b', \"c, d\"", ["'a, b'", '"c, d"']),
        ("name=driver's, x=1", ["name=driver's", "x=1"]),
        ("lognormal(0.7, 0.1), 3", ["lognormal(0.7, 0.1)", "3"]),
        ("[[2, 0], [0, 3]] kg*m^2", ["[[2, 0], [0, 3]] kg*m^2"]),
    ],
)
def test_lists_split_at_commas_outside_brackets(text: str, items: list[str]) -> None:
    assert split_list(text) == items


@pytest.mark.parametrize(
    ("text", "items"),
    [
        ("1, 2, 3 m", ["1 m", "2 m", "3 m"]),
        ("1 m, 0, -0.0", ["1 m", "0 m", "-0.0 m"]),
        ("1 m, 2, 0", ["1 m", "2", "0 m"]),
        ("1, 2, 0", ["1", "2", "0"]),
        ("1 ft, 2, 3 m", ["1 ft", "2 m", "3 m"]),
    ],
)
def test_items_share_the_last_unit_and_zeros_take_any(text: str, items: list[str]) -> None:
    assert share_unit(split_list(text)) == items


@pytest.mark.parametrize("text", ["", ",", "1,,2", "1,", "(1, 2", "1)", "[1)", "'a, b", "{[}]"])
def test_refused_lists(text: str) -> None:
    with pytest.raises(UsageError) as refusal:
        split_list(text)
    assert refusal.value.code == "syntax"


def test_pairs() -> None:
    assert split_pairs("distance=60 ft, friction=0.7, grade=-3 %") == {
        "distance": "60 ft",
        "friction": "0.7",
        "grade": "-3 %",
    }
    assert split_pairs("force=3, 4 N, at=-2, .5 m") == {"force": "3, 4 N", "at": "-2, .5 m"}
    assert split_pairs('name="a, b=c", at=(1, 2) m') == {"name": "a, b=c", "at": "(1, 2) m"}


def test_pairs_without_a_comma() -> None:
    assert split_pairs("over=4 length=12 mm") == {"over": "4", "length": "12 mm"}
    assert split_pairs("name=hole at=1, 0, 0 mm profile-shift=2 subtract=true") == {
        "name": "hole",
        "at": "1, 0, 0 mm",
        "profile-shift": "2",
        "subtract": "true",
    }


@pytest.mark.parametrize("text", ["", "60 ft", "a=1, a=2", "a=, b=2", "=3", "a=1, b"])
def test_refused_pairs(text: str) -> None:
    with pytest.raises(UsageError):
        split_pairs(text)


def attempt(function: Callable[..., Any], *arguments: Any) -> tuple[Any, UsageError | None]:
    """Call, and give the answer or the refusal; anything else that is raised fails the test."""
    try:
        return function(*arguments), None
    except UsageError as refusal:
        return None, refusal


QUANTITY_CHARACTERS = "0123456789.,+-−eE±/^*·×() \t%°′″'\";:@=[]{}ftinkgmslbNradehpu²⁻_\x00\x1b٣½"


# Without a deadline: a strange name may be the first to load pint.
@example("0N\ts", q.Distance)
@settings(max_examples=400, deadline=None)
@given(st.one_of(st.text(alphabet=QUANTITY_CHARACTERS, max_size=30), st.text(max_size=30)), st.sampled_from(KINDS))
def test_any_text_is_a_value_or_refused(text: str, kind: Kind) -> None:
    reading, refusal = attempt(read_scalar, text, kind)
    if refusal:
        assert refusal.message.isprintable()
        assert refusal.hint
    else:
        assert math.isfinite(reading.si)
        assert kind.outside(reading.si) is None


@settings(max_examples=300, deadline=None)
@given(st.text(alphabet=QUANTITY_CHARACTERS, max_size=30))
def test_any_text_is_split_or_refused(text: str) -> None:
    for function in (read_fraction, split_list, split_pairs, read_amount, is_uncertain, read_number):
        _, refusal = attempt(function, text)
        assert refusal is None or refusal.message.isprintable()


@given(st.floats(-1e300, 1e300), st.sampled_from([kind for kind in KINDS if kind.unit]))
def test_a_value_written_in_si_is_read_back_to_the_bit(value: float, kind: Kind) -> None:
    if kind.outside(value) is None:
        assert read_scalar(f"{value!r} {kind.unit}", kind).si == value


def test_what_is_quoted_is_cut_and_escaped() -> None:
    with pytest.raises(UsageError) as refusal:
        read_amount("\x07" * 900)
    assert len(refusal.value.message) < 350
    assert "\x07" not in refusal.value.message
    assert quantity_text.LONGEST_TEXT < 10**4


@pytest.mark.parametrize(
    ("text", "items"),
    [
        ("4 6 8in", ["4 in", "6 in", "8 in"]),
        ("4 6 8 in", ["4 in", "6 in", "8 in"]),
        ("0,0 20,1.5 40,4 ft", ["0 ft", "0 ft", "20 ft", "1.5 ft", "40 ft", "4 ft"]),
        ("100 200 300 mm", ["100 mm", "200 mm", "300 mm"]),
        # a mixed number or a compound unit is one item
        ("10, 12 1/2 in", ["10 in", "12 1/2 in"]),
        ("1/4, 1, 3/4 in", ["1/4 in", "1 in", "3/4 in"]),
        ("5 ft 6 in, 6 ft", ["5 ft 6 in", "6 ft"]),
        ("6, 5 ft 6 in", ["6", "5 ft 6 in"]),
    ],
)
def test_numbers_of_a_list_may_stand_apart_by_spaces(text: str, items: list[str]) -> None:
    from dynamics_cli.core.inputs.forms.lists import split_items
    from dynamics_cli.core.inputs.specification import Leaf, Many

    assert split_items(Many(Leaf(q.Length)), text) == items
