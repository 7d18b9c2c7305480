"""`convert --rows FILE --column NAME=UNIT`: units out of the cells, into the header."""

import csv
import io
from pathlib import Path

import pytest

from tests.harness import run

MESSY = """id,speed,mass,note
1,60 mph,"1,500 kg","a, b"
2,88ft/s,1.5 t,=1+1
3,abc,2000 lb,x
4,30 m,1500,"two
lines"
5,,2 1/2 lb,
6,60 KM/H,"1,234.5 kg",
7,1 m/s
8,5 ± 1 m/s,3 slug,
"""


def cleaned(text: str, *columns: str) -> tuple[int, list[dict[str, str]], str]:
    options = [word for column in columns for word in ("--column", column)]
    outcome = run("convert", "--rows", "-", *options, stdin=text)
    return outcome.status, list(csv.DictReader(io.StringIO(outcome.out))), outcome.err


def test_cells_take_one_unit_and_bad_ones_are_reported_by_row() -> None:
    status, rows, told = cleaned(MESSY, "speed=m/s", "mass=kg")
    assert status == 4
    assert list(rows[0]) == ["id", "speed[m/s]", "mass[kg]", "note", "error"]
    assert [row["speed[m/s]"] for row in rows] == ["26.8224", "26.8224", "", "", "", repr(60 / 3.6), "1.0", ""]
    assert [row["mass[kg]"] for row in rows[1:6]] == ["1500.0", "907.18474", "", "1.133980925", "1234.5"]
    assert [row["note"] for row in rows[:4]] == ["a, b", "=1+1", "x", "two\nlines"]
    assert "may be 1500 or 1.5" in rows[0]["error"]
    assert "m is a length, m/s is a speed" in rows[3]["error"]
    assert "'1500': has no unit" in rows[3]["error"]
    assert "the row has 2 cells, wanted 4" in rows[6]["error"]
    assert "uncertain" in rows[7]["error"]
    assert [bool(row["error"]) for row in rows] == [True, False, True, True, False, False, True, True]
    assert "row 3: speed: read 'abc'" in told
    assert "5 of 8 rows" in told
    assert "mass: lb read as pound-mass" in told


def test_a_cleaned_table_is_read_by_rows_and_cleaned_again() -> None:
    _, rows, _ = cleaned("distance,friction\n60 ft,0.7\n", "distance=m")
    assert rows == [{"distance[m]": "18.288", "friction": "0.7", "error": ""}]
    status, rows, _ = cleaned("distance[m];friction\n18.288;0.7\n60 ft;0.6\n", "Distance=ft")
    assert status == 0
    assert [row["distance[ft]"] for row in rows] == ["60.0", "60.0"]


def test_a_file_is_written_whole(tmp_path: Path) -> None:
    (tmp_path / "messy.csv").write_text("﻿t\n20 C\n68 deg F\n", encoding="utf-8")
    name = str(tmp_path / "clean.csv")
    outcome = run("convert", "--rows", str(tmp_path / "messy.csv"), "--column", "t=K", "--output", name)
    assert (outcome.status, outcome.out) == (0, "")
    assert (tmp_path / "clean.csv").read_text() == "t[K],error\n293.15,\n293.15,\n"


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (("convert", "--rows", "-", "--column", "sped=m/s"), "did you mean speed?"),
        (("convert", "--rows", "-", "--column", "speed"), "wanted NAME=UNIT"),
        (("convert", "--rows", "-", "--column", "speed=zork"), "unknown unit 'zork'"),
        (("convert", "--rows", "-", "--column", "speed=m/s", "--format", "ndjson"), "reads and writes CSV"),
        (("convert", "3 m", "ft", "--column", "speed=m/s"), "--column is for --rows"),
        (("skid", "speed", "--rows", "-", "--column", "speed=m/s"), "--column is for convert --rows alone"),
    ],
)
def test_wrong_calls(call: tuple[str, ...], words: str) -> None:
    outcome = run(*call, stdin=MESSY)
    assert outcome.status == 2
    assert words in outcome.err
