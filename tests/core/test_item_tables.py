"""Tables as the items of a repeated option: CSV files, and tables of earlier documents."""

from pathlib import Path

import pytest
from harness import answer, run


def test_rows_are_items_with_the_units_of_the_header(tmp_path: Path) -> None:
    table = tmp_path / "surfaces.csv"
    table.write_text("# wet, then dry\n\ndistance[ft],friction,grade[%]\n60,0.7,-3\n20,0.35,\n", encoding="utf-8-sig")
    made = answer("skid", "speed", "--segment", f"@{table}")
    typed = answer(
        "skid", "speed", "--segment", "distance=60 ft, friction=0.7, grade=-3 %", "--segment",
        "distance=20 ft, friction=0.35",
    )  # fmt: skip
    assert made["results"] == typed["results"]


def test_vectors_are_cells_or_components(tmp_path: Path) -> None:
    cells, parts = tmp_path / "cells.csv", tmp_path / "parts.csv"
    cells.write_text('force[N],at[mm]\n"0, -500","2000, 0"\n"300, 20","4000, 1000"\n')
    parts.write_text("at_x[mm],at_y[mm],Force_X[N],Force_Y[N]\n2000,0,0,-500\n4000,1000,300,20\n")
    typed = answer("force", "resultant", "--load", "force=0, -500 N, at=2, 0 m", "--load", "force=300, 20 N, at=4, 1 m")
    for file in (cells, parts):
        assert answer("force", "resultant", "--load", f"@{file}")["results"]["moment"] == typed["results"]["moment"]


def test_a_table_of_a_document_leaves_out_its_other_columns(tmp_path: Path) -> None:
    first = tmp_path / "fly.json"
    point = ("--point", "angle=0 deg, torque=1 N*m", "--point", "angle=9 deg, torque=5 N*m")
    point += ("--point", "angle=19 deg, torque=1 N*m", "--speed", "3 rpm")
    assert run("balance", "flywheel", *point, "--output", str(first)).status == 0
    outcome = run("balance", "flywheel", "--point", f"@{first}:crossings", "--speed", "3 rpm", "--json")
    # the crossings have angles, but no torques
    assert outcome.status == 2
    assert {one["parameter"] for one in outcome.error["errors"]} == {"points[0].torque", "points[1].torque"}
    outcome = run("balance", "flywheel", "--point", f"@{first}:inertia", "--speed", "3 rpm")
    assert outcome.status == 2
    assert "is not a table" in outcome.err


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("distance[ft],mu\n60,0.7\n", "there is no field 'mu'"),
        ("distance[ft],friction\n60\n", "row 2: read 1 cells, the header has 2"),
        ("distance[ft],friction\n", "has 0 rows below its header"),
        ("", "has 0 rows below its header"),
        ("distance[ft],friction\nsixty,0.7\n", "--segment: distance: 'sixty ft'"),
    ],
)
def test_what_cannot_be_read_is_named(text: str, said: str, tmp_path: Path) -> None:
    table = tmp_path / "bad.csv"
    table.write_text(text)
    outcome = run("skid", "speed", "--segment", f"@{table}")
    assert outcome.status == 2
    assert said in outcome.err
    assert "Traceback" not in outcome.err


def test_a_file_that_is_not_there_is_named() -> None:
    outcome = run("skid", "speed", "--segment", "@nowhere.csv")
    assert outcome.status == 2
    assert "nowhere.csv" in outcome.err


def test_what_adds_up_may_be_given_both_ways() -> None:
    both = ("--couple", "moment=3 N*m", "--moment", "5 N*m", "--load", "force=1, 1 N, at=1, 0 m")
    made = answer("force", "resultant", *both, "--force", "1, 2 N", "--at", "0, 0 m")
    assert made["results"]["moment"]["value"] == [0.0, 0.0, 9.0]
    assert made["results"]["force"]["value"] == [2.0, 3.0, 0.0]
    incomplete = run("force", "resultant", *both, "--force", "1, 2 N")
    assert incomplete.status == 2
    assert "at is missing" in incomplete.err
