"""Everyday conversions as people type them, against the definitions in NIST SP 811 and Handbook 44, exactly.

Where `everyday.csv` names another source, that definition is used; GNU units 2.22 agrees on all that it reads but the
rows that say otherwise and temperatures, which it takes for differences.
"""

import csv
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
