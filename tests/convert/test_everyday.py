"""Everyday conversions as people type them, against the definitions in NIST SP 811 and Handbook 44, exactly.

Where `everyday.csv` names another source, that definition is used; GNU units 2.22 agrees on all that it reads but the
rows that say otherwise and temperatures, which it takes for differences.
"""

import csv
import json
from fractions import Fraction
from pathlib import Path

import mpmath as mp
import pytest

from dynamics_cli.cli import answer, find_task
from dynamics_cli.core.answering.gather import read_words
from dynamics_cli.errors import DynamicsError
from tests.harness import run

ROWS = list(csv.DictReader((Path(__file__).parent / "everyday.csv").read_text(encoding="utf-8").splitlines()))
REFUSED = "refused: "


def converted(typed: str, to: str) -> dict:
    task, _ = find_task(["convert"])
    raw, _ = read_words(task.specification.fields, [typed, *filter(None, [to])], rows=False)
    return answer("convert", raw)["results"]


def test_the_number_stands_first_and_alone_then_what_was_meant() -> None:
    lines = run("convert", "1", "ton", "kg").out.splitlines()
    assert lines[:3] == [
        "907.18474 kg",
        "",
        "note: ton read as short ton, 2000 lb; others are long_ton (2240 lb) and t (1000",
    ]
    assert run("convert", "60 mph to m/s", "-q").out == "26.8224 m/s\n"
    assert run("convert", "60", "mph", "ft/s", "km/h", "-q").out == "88 ft/s\n96.56064 km/h\n"
    assert run("convert", "98.6", "F", "C", "-q").out == "37 C\n"
    assert run("convert", "10 %", "-q").out == "0.1\n"


@pytest.mark.parametrize(
    ("words", "wanted", "typed"),
    [
        ("5 ft 6 in m", "1.6764 m", "5 ft 6 in"),
        ("6ft 2in cm", "187.96 cm", "6 ft 2 in"),
        ("5 ft 6 1/2 in to mm", "1689.1 mm", "5 ft 6.5 in"),
        ("2 h 30 min s", "9000 s", "2 h 30 min"),
        ("-5 ft 6 in m", "-1.6764 m", "-5 ft -6 in"),
        ("5-1/2 in mm", "139.7 mm", "5.5 in"),
        ("3/8 in mm", "9.525 mm", "0.375 in"),
        ("5 1/in 1/ft", "60 1/ft", "5 1/in"),
    ],
)
def test_a_quantity_of_several_words_needs_no_quotes_and_is_shown_as_typed(words: str, wanted: str, typed: str) -> None:
    shown = run("convert", *words.split()).out.splitlines()
    assert shown[0] == wanted
    assert any(line.startswith(f"for   value {typed}, targets") for line in shown)


def test_a_document_with_feet_and_inches_reads_back() -> None:
    once = run("skid", "speed", "--distance", "60 ft 6 in", "--friction", "0.7", "--json")
    assert json.loads(once.out)["inputs"]["distance"] == {"value": [60, 6], "unit": "ft;in"}
    assert run("skid", "speed", "--input", "-", "--json", stdin=once.out).out == once.out


def test_remedies_name_what_was_typed() -> None:
    assert "write 12.5 with a point" in run("convert", "12,5", "mm", "in").err
    assert "60 mph to km/h" in run("convert", "60", "mph", "in", "km/h").err
    assert "60 has no unit" in run("convert", "60").err


def number(exact: str) -> mp.mpf:
    """The exact value in forty digits."""
    name, _, inner = exact.rstrip(")").partition("(")
    if name in ("atan", "tan"):
        return getattr(mp, name)(number(inner))
    up, _, down = exact.partition("/")
    value = mp.mpf(1)
    for factor in up.split("·"):
        value *= mp.pi if factor == "π" else mp.mpf(int(factor))
    for factor in down.strip("()").split("·") if down else ():
        value /= mp.pi if factor == "π" else mp.mpf(int(factor))
    return value


def test_there_are_enough() -> None:
    assert len(ROWS) >= 245


@pytest.mark.parametrize("row", ROWS, ids=[f"{row['typed']} → {row['to'] or 'SI'}" for row in ROWS])
def test_everyday_conversions(row: dict[str, str]) -> None:
    if row["exact"].startswith(REFUSED):
        with pytest.raises(DynamicsError) as refusal:
            converted(row["typed"], row["to"])
        assert row["exact"].removeprefix(REFUSED) in refusal.value.message
        return
    results = converted(row["typed"], row["to"])
    assert results["exact_value"] == row["exact"]
    value = results["value"]["value"]
    if not any(sign in row["exact"] for sign in ("π", "tan")):
        assert value == float(Fraction(row["exact"]))
        return
    with mp.workdps(40):
        exact = number(row["exact"])
        if "tan" in row["exact"]:
            exact *= {"deg": 180 / mp.pi, "mrad": 1000, "%": 100}[row["to"]]
        assert value == float(exact)


def test_letters_exchanged_are_a_slip_and_not_a_prefix() -> None:
    assert "did you mean mph or" in run("convert", "60", "mhp").err
    assert "did you mean psi" in run("convert", "30", "pis", "bar").err
    assert run("convert", "5 mho", "-q").out == "5 S\n"
    assert run("convert", "180 rads", "rad", "-q").out == "180 rad\n"
    assert run("convert", "500 Nmm", "N*m", "-q").out == "0.5 N*m\n"


WORKSHOP = [
    ("29×10^6 psi to Mpsi", 29),
    ("29 x 10^6 psi to Mpsi", 29),
    ("10^-3 m to mm", 1),
    ("3·10^8 m/s to km/s", 300000),
    ("11 st 4 lb to lb", 158),
    ("29 Msi to ksi", 29000),
    ("2 tsf to psf", 4000),
    ("3 klf to plf", 3000),
    ("1 bar gauge to kPa", 201.325),
    ("1 bar abs to kPa", 100),
    ("1 MPag to kPa", 1101.325),
    ("18 delta F to deltaC", 10),
    ("4 USgal to qt", 16),
    ("1728 CID to cuft", 1),
    ("2 inWC to inH2O", 2),
    ("5 ft, 6 in to in", 66),
]


@pytest.mark.parametrize(("typed", "expected"), WORKSHOP)
def test_what_workshops_write(typed: str, expected: float) -> None:
    unquoted = run("convert", *typed.split(), "-q")
    quoted = run("convert", typed, "-q")
    assert quoted.status == 0, quoted.err
    assert float(quoted.out.split()[0]) == expected
    assert unquoted.out == quoted.out


def test_units_of_several_words_need_no_quotes() -> None:
    for words, expected in (
        ("30 miles per gallon mpg", "30 mpg"), ("1 long ton lb", "2240 lb"), ("9 square feet sqyd", "1 sqyd"),
        ("1 furlong per fortnight furlong/fortnight", "1 furlong/fortnight"), ("100 bar gauge barg", "100 barg"),
    ):  # fmt: skip
        assert run("convert", *words.split(), "-q").out.strip() == expected


def test_several_units_in_other_spellings_and_a_force_in_kg() -> None:
    for target, expected in (("ft+in", "5 ft 9 in"), ("ft, in", "5 ft 9 in"), ("feet and inches", "5 feet 9 inches")):
        assert run("convert", "5.75 ft", target, "-q").out.strip() == expected
    assert run("convert", "30.5 deg", "dms", "-q").out.strip() == "30 deg 30 arcmin 0 arcsec"
    assert "as a force write kgf*cm" in run("convert", "20 kg*cm", "N*m").err


@pytest.mark.parametrize("typed", ["60,70,80 mph", "60, 70, 80 mph", "60 70 80 mph"])
def test_several_numbers_are_for_rows(typed: str) -> None:
    outcome = run("convert", typed, "km/h")
    assert outcome.status == 2
    assert "is 3 numbers, wanted one" in outcome.err
    assert "--rows" in outcome.err


@pytest.mark.parametrize(
    ("typed", "mm"), [("½ in", "12.7"), ("2½ in", "63.5"), ("3 ¼ in", "82.55"), ("5' 6½\"", "1689.1")]
)
def test_fractions_in_one_character(typed: str, mm: str) -> None:
    assert run("convert", typed, "mm", "-q").out == f"{mm} mm\n"
