"""H. Josephs, R. L. Huston, Dynamics of Mechanical Systems, CRC Press 2002: table 1.7.1 and the examples of chapter 1.

Each printed factor is held against the program's exact one to the last printed digit; where the table's own note says
that the printed value is wrong, the test proves that it is.
"""

from fractions import Fraction

import pytest
from harness import answer, run

from dynamics_cli.convert.unit_lists import Table, TableRow, book_table
from dynamics_cli.core.units.conversion import convert
from dynamics_cli.core.units.lookup import parse_pair

ROWS = book_table(Table("josephs-huston")).rows
# The book's g is 32.2 ft/s², ours standard gravity.
BOOK_GRAVITY = Fraction("32.2") * Fraction(381, 1250)


def spelled(unit: str) -> str:
    """The unit before any remark: `mi/hr (or mph)`."""
    return unit.partition(" (or ")[0]


def exact_factor(row: TableRow) -> tuple[Fraction, int]:
    """The program's own factor, and its power of π."""
    source, target = spelled(row.from_unit), spelled(row.to_unit)
    factor = Fraction(1)
    if "g" in (source, target):
        factor = BOOK_GRAVITY if source == "g" else 1 / BOOK_GRAVITY
        source, target = ("m/sec2" if source == "g" else source), ("m/sec2" if target == "g" else target)
    first, second = parse_pair(source, target)
    numerator, denominator, pi = convert(1, 1, first, second)
    return factor * Fraction(numerator, denominator), pi


@pytest.mark.parametrize("row", ROWS, ids=[f"{row.from_unit} to {row.to_unit}" for row in ROWS])
def test_every_row(row: TableRow) -> None:
    factor, pi = exact_factor(row)
    value = float(factor) * 3.141592653589793**pi
    assert value == pytest.approx(row.factor, rel=4e-16)
    half_digit = 0.5 * 10.0 ** (int(row.printed.partition("e")[2]) - 6)
    printed_right = abs(float(row.printed) - value) <= half_digit * (1.0 + 1e-9)
    wrong = "misprint" in row.note or "digit" in row.note
    assert printed_right is not wrong


def test_the_four_weight_density_rows_are_misprints() -> None:
    misprints = [row for row in ROWS if "misprint" in row.note]
    assert len(misprints) == 4
    assert {row.quantity for row in misprints} == {"Weight density"}


def test_rows_of_g_say_what_they_rest_on() -> None:
    for row in ROWS:
        assert ("32.2" in row.note) == ("g" in (row.from_unit, row.to_unit))


def value(*argv: str) -> float:
    return answer("convert", *argv)["results"]["value"]["value"]


def test_60_mph() -> None:
    assert value("60", "mph", "ft/s") == 88.0
    assert value("60 mph", "km/s") == 0.0268224


def test_a_person_of_150_lb() -> None:
    assert value("150", "lb", "N") == pytest.approx(667.233, abs=5e-4)
    assert value("150 lb", "kg") == pytest.approx(68.0388555, rel=1e-15)
    # In the book lb is a force and the mass follows from g = 32.2 ft/s²: 4.658 slug, 67.98 kg.
    book = ("--weight", "--gravity", "32.2 ft/s^2")
    assert value("150 lbf", "slug", *book) == pytest.approx(4.658, abs=5e-4)
    assert value("150 lbf", "kg", *book) == pytest.approx(67.98, abs=5e-3)


def test_3_mph_per_second() -> None:
    assert value("3", "mph/s", "ft/s^2") == 4.4
    assert value("3 mph/s", "m/s^2") == pytest.approx(1.34112, rel=1e-15)
    assert value("3 mph/s", "g") == pytest.approx(0.136756, abs=5e-7)


def test_the_table_is_printed_whole() -> None:
    lines = run("units", "table", "josephs-huston", "--format", "csv").out.splitlines()
    assert len(lines) == 1 + len(ROWS) == 121
    assert lines[0] == "quantity,from_unit,to_unit,printed,factor,exact,note"
