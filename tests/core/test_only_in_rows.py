"""`--only` with `--rows`: fewer columns, the same numbers; an unknown name is refused before any row."""

import json
from pathlib import Path

import pytest
from harness import run

CASES = "distance[m],friction\n" + "".join(f"{20 + k / 8:g},0.7\n" for k in range(400))
TENSORS = "".join(
    json.dumps({"moments": {"value": [2.0, 2.2, 3.0 + k / 100], "unit": "kg*m^2"}}) + "\n" for k in range(3)
)


@pytest.fixture
def cases(tmp_path: Path) -> str:
    (tmp_path / "cases.csv").write_text(CASES)
    return str(tmp_path / "cases.csv")


def test_columns_are_those_asked_for_in_their_order(cases: str) -> None:
    every = [line.split(",") for line in run("skid", "speed", "--rows", cases).out.splitlines()]
    few = [line.split(",") for line in run("skid", "speed", "--rows", cases, "--only", "time,speed").out.splitlines()]
    chosen = [every[0].index(name) for name in ("distance[m]", "friction", "time[s]", "speed[km/h]", "error")]
    assert few[0] == ["distance[m]", "friction", "time[s]", "speed[km/h]", "error"]
    assert few == [[row[place] for place in chosen] for row in every]


def test_records_and_tensors_are_chosen_whole(tmp_path: Path) -> None:
    (tmp_path / "tensors.ndjson").write_text(TENSORS)
    call = ("inertia", "tensor", "--rows", str(tmp_path / "tensors.ndjson"))
    every = [json.loads(line)["results"] for line in run(*call).out.splitlines()]
    few = [json.loads(line)["results"] for line in run(*call, "--only", "principal_moments,tensor").out.splitlines()]
    assert few == [{name: row[name] for name in ("principal_moments", "tensor")} for row in every]
    first = run(*call, "--only", "principal-moments.first", "--format", "csv").out.splitlines()
    assert [float(line.split(",")[-2]) for line in first[1:]] == [
        row["principal_moments"]["first"]["value"] for row in every
    ]


def test_uncertain_rows_keep_the_distribution_of_what_is_asked(tmp_path: Path) -> None:
    (tmp_path / "cases.csv").write_text("distance[m],friction\n20 ± 1,0.7\n30,0.7\n")
    call = ("skid", "speed", "--rows", str(tmp_path / "cases.csv"))
    every = [line.split(",") for line in run(*call).out.splitlines()]
    few = [line.split(",") for line in run(*call, "--only", "time").out.splitlines()]
    assert few[0] == ["distance[m]", "friction", "time[s]", *(f"time.{one}[s]" for one in
                      ("mean", "median", "std", "low", "high")), "error"]  # fmt: skip
    places = [every[0].index(name) for name in few[0]]
    assert few == [[row[place] for place in places] for row in every]


def test_an_unknown_name_is_refused_before_any_row(cases: str) -> None:
    done = run("skid", "speed", "--rows", cases, "--only", "spee")
    assert done.status == 2
    assert done.out == ""
    assert "rows have no result 'spee'" in done.err
    assert "results of rows are speed, time, total_distance" in done.err
