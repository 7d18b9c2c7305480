"""Uncertain values in rows and sweeps: what a single call gives, in columns."""

import json

import pytest
from harness import answer, run

from dynamics_cli.core.batch import stream, sweep
from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.stream import FIRST_ARRAY_ROWS

SPEED = ("skid", "speed")
CSV = "distance[ft],friction\n60,0.7 ± 0.05\n50,0.65..0.75\n40,0.7\n"


def single(*argv: str) -> dict:
    return answer(*SPEED, *argv)["results"]


def test_csv_rows_have_what_single_calls_give() -> None:
    outcome = run(*SPEED, "--rows", "-", stdin=CSV)
    assert outcome.status == 0, outcome.err
    head, *rows = (line.split(",") for line in outcome.out.splitlines())
    for row, (distance, friction) in zip(rows, [("60 ft", "0.7 ± 0.05"), ("50 ft", "0.65..0.75")], strict=False):
        cells = dict(zip(head, row, strict=True))
        speed = single("--distance", distance, "--friction", friction)["speed"]
        assert float(cells["speed[km/h]"]) == speed["value"]
        for name in ("mean", "median", "std"):
            assert float(cells[f"speed.{name}[km/h]"]) == pytest.approx(speed[name], rel=1e-3)
        assert float(cells["speed.low[km/h]"]) == pytest.approx(speed["interval"][0], rel=1e-6)
        assert float(cells["speed.high[km/h]"]) == pytest.approx(speed["interval"][1], rel=1e-6)
    certain = dict(zip(head, rows[2], strict=True))
    assert certain["speed.low[km/h]"] == ""
    assert float(certain["speed[km/h]"]) == single("--distance", "40 ft", "--friction", "0.7")["speed"]["value"]


def test_json_rows_carry_intervals_where_there_are_any() -> None:
    frictions = ("0.7 ± 0.05", [0.71, 0.74, 0.70, 0.72], 0.7)
    lines = [{"distance": "60 ft", "friction": friction} for friction in frictions]
    outcome = run(*SPEED, "--rows", "-", stdin="".join(json.dumps(line) + "\n" for line in lines))
    assert outcome.status == 0, outcome.err
    normal, readings, certain = (json.loads(line)["results"]["speed"] for line in outcome.out.splitlines())
    assert normal["interval"] == single("--distance", "60 ft", "--friction", "0.7 ± 0.05")["speed"]["interval"]
    assert readings["interval"][0] < readings["median"] < readings["interval"][1]
    assert "interval" not in certain


def test_an_option_may_be_uncertain_for_every_row() -> None:
    outcome = run(
        *SPEED, "--rows", "-", "--friction", "0.7 ± 0.05", "--format", "ndjson", stdin="distance[ft]\n60\n30\n"
    )
    first, second = (json.loads(line)["results"]["speed"] for line in outcome.out.splitlines())
    assert first["interval"] == single("--distance", "60 ft", "--friction", "0.7 ± 0.05")["speed"]["interval"]
    assert second["interval"][1] < first["interval"][1]


@pytest.mark.parametrize("form", ["csv", "ndjson"])
def test_a_few_uncertain_rows_leave_the_others_to_arrays(form: str, monkeypatch: pytest.MonkeyPatch) -> None:
    frictions = ["0.7 ± 0.05" if row % 100 == 7 else f"{0.5 + row / 1000:g}" for row in range(FIRST_ARRAY_ROWS + 10)]
    if form == "csv":
        rows = "distance[ft],friction\n" + "".join(f"60,{friction}\n" for friction in frictions)
    else:
        rows = "".join(json.dumps({"distance": "60 ft", "friction": friction}) + "\n" for friction in frictions)
    calls = []
    honest = Case.values
    monkeypatch.setattr(Case, "values", lambda case, row: calls.append(row) or honest(case, row))
    together = run(*SPEED, "--rows", "-", stdin=rows).out
    assert len(calls) < 10
    monkeypatch.setattr(stream, "FIRST_ARRAY_ROWS", 10**6)
    assert run(*SPEED, "--rows", "-", stdin=rows).out == together


def test_so_many_rows_that_arrays_pay_are_not_taken_as_certain_where_an_option_is_uncertain() -> None:
    rows = "distance[ft]\n" + "60\n" * (FIRST_ARRAY_ROWS + 10)
    outcome = run(*SPEED, "--rows", "-", "--friction", "0.7 ± 0.05", "--method", "linear", stdin=rows)
    assert outcome.status == 0
    lines = outcome.out.splitlines()
    assert len(lines) == FIRST_ARRAY_ROWS + 11
    assert len(set(lines[1:])) == 1
    assert ",," not in lines[1][: lines[1].index("18.288")]


class TestARowThatComesLate:
    rows = "distance[ft],friction\n" + "60,0.7\n" * 60 + "60,0.7 ± 0.05\n"

    def test_is_refused_with_what_makes_room_for_it(self) -> None:
        outcome = run(*SPEED, "--rows", "-", "--format", "ndjson", stdin=self.rows)
        assert outcome.status == 4
        error = json.loads(outcome.out.splitlines()[-1])["error"]
        assert error["code"] == "uncertain"
        assert "--coverage" in error["hint"]

    def test_has_its_interval_when_the_call_asks(self) -> None:
        outcome = run(*SPEED, "--rows", "-", "--format", "ndjson", "--coverage", "90 %", stdin=self.rows)
        assert outcome.status == 0
        low, high = json.loads(outcome.out.splitlines()[-1])["results"]["speed"]["interval"]
        assert [low, high] == single("--distance", "60 ft", "--friction", "0.7 ± 0.05", "--coverage", "90 %")["speed"][
            "interval"
        ]


class TestSweeps:
    def test_every_point_has_its_interval(self) -> None:
        argv = ("--distance", "60 ft", "--friction", "0.7 ± 0.05", "--sweep", "distance=20 ft:60 ft:3")
        document = answer(*SPEED, *argv)
        table = document["results"]["sweep"]
        last = single("--distance", "60 ft", "--friction", "0.7 ± 0.05")["speed"]
        assert [table["speed.low"]["value"][-1], table["speed.high"]["value"][-1]] == last["interval"]
        assert document["inputs"]["friction"]["distribution"] == "normal"
        assert document["numerics"]["uncertainty"] == {"coverage": 0.95, "seed": 1}

    def test_the_swept_parameter_itself_is_certain_at_each_point(self) -> None:
        table = answer(*SPEED, "--distance", "60 ft", "--friction", "0.7 ± 0.05", "--sweep", "friction=0.5:0.7:2")[
            "results"
        ]["sweep"]
        assert "speed.low" not in table
        assert table["speed"]["value"][1] == single("--distance", "60 ft", "--friction", "0.7")["speed"]["value"]

    def test_many_points_are_not_taken_as_certain(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(sweep, "ARRAY_POINTS", 40)
        argv = ("--distance", "60 ft", "--friction", "0.7 ± 0.05", "--sweep", "distance=20 ft:60 ft:41")
        table = answer(*SPEED, *argv, "--method", "linear")["results"]["sweep"]
        assert all(value is not None for value in table["speed.low"]["value"])
