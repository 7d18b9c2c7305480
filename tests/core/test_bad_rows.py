"""Whatever a row raises costs that row alone: the others are answered, and the status says that some failed."""

import json
from typing import Any

import pytest
from harness import run

from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.inputs.uncertain.vectors import component_items
from dynamics_cli.errors import UsageError

GOOD = '{"distance": "3 m", "friction": 0.7}'
SPEED = ("skid", "speed", "--rows", "-")


@pytest.mark.parametrize(
    "row",
    [
        '{"distance": {"value": 1, "unit": "m", "interval": 5}, "friction": 0.7}',
        '{"distance": {"value": 1, "unit": "m", "interval": [1, null], "coverage": 0.9}, "friction": 0.7}',
        '{"distance": {"value": 1, "unit": "m", "median": 1, "interval": [0.9, 2], "coverage": [1]}, "friction": 0.7}',
        '{"distance": {"value": [1, 2], "unit": "m", "std": 0.1}, "friction": 0.7}',
        '{"distance": {"value": 1, "unit": "m", "std": [0.1]}, "friction": 0.7}',
        '{"distance": {"distribution": "readings", "readings": 5, "unit": "m"}, "friction": 0.7}',
        '{"distance": {"distribution": ["normal"], "mean": 5, "std": 1, "unit": "m"}, "friction": 0.7}',
        '{"distance": "@first.json:surfaces[²].distance", "friction": 0.7}',
        '{"distance": "3 \\ud800", "friction": 0.7}',
    ],
)
@pytest.mark.parametrize("form", ["ndjson", "csv"])
@pytest.mark.parametrize("first", [True, False])
def test_one_bad_row_costs_itself_only(row: str, form: str, first: bool) -> None:
    lines = [row, GOOD, GOOD] if first else [GOOD, row, GOOD]
    outcome = run(*SPEED, "--format", form, "--coverage", "95 %", stdin="\n".join(lines) + "\n")
    assert outcome.status == 4, outcome.err
    made = outcome.out.splitlines()[form == "csv" :]
    assert len(made) == 3
    (bad,) = [line for line in made if ("error" in line if form == "ndjson" else not line.endswith(","))]
    assert made.index(bad) == (0 if first else 1)
    assert "internal" not in bad


@pytest.mark.parametrize("more", [{"interval": 5}, {"interval": {"low": 1}}, {"std": 3}, {"distributions": 4}])
def test_vectors_of_a_wrong_shape_are_refused(more: dict[str, Any]) -> None:
    with pytest.raises(UsageError):
        component_items({"value": [1, 2], "unit": "m/s", **more}, 2)


def test_half_a_surrogate_pair_in_passing_does_not_end_a_stream() -> None:
    rows = f'{{"distance": "3 m", "friction": 0.7, "id": "\\ud800", "\\udfff": 1}}\n{GOOD}\n'
    outcome = run(*SPEED, "--format", "csv", stdin=rows)
    assert outcome.status == 0
    assert len(outcome.out.splitlines()) == 3


@pytest.mark.parametrize("head", ["distance[²],friction", "segments[²].distance,friction", f"a[{'9' * 5000}],friction"])
def test_an_index_is_written_in_plain_digits(head: str) -> None:
    outcome = run(*SPEED, stdin=f"{head}\n3,0.7\n")
    assert outcome.status == 4
    assert "internal" not in outcome.out + outcome.err


def test_what_is_our_own_mistake_costs_its_row_too(monkeypatch: pytest.MonkeyPatch) -> None:
    values = Case.values

    def wrong(case: Case, row: dict[str, Any]) -> Any:
        if row["distance"] == "13 m":
            raise ZeroDivisionError("unlucky")
        return values(case, row)

    monkeypatch.setattr(Case, "values", wrong)
    outcome = run(*SPEED, stdin="".join(f'{{"distance": "{n} m", "friction": 0.7}}\n' for n in range(10, 20)))
    assert outcome.status == 4
    made = [json.loads(line) for line in outcome.out.splitlines()]
    assert [index for index, row in enumerate(made) if "error" in row] == [3]
    assert "ZeroDivisionError: unlucky" in made[3]["error"]["message"]
    assert outcome.err.count("ZeroDivisionError: unlucky") == 1
    assert '"13 m"' in outcome.err
    assert "please report it" in outcome.err


@pytest.mark.parametrize("jobs", [(), ("--jobs", "2")])
def test_our_own_mistake_in_reading_is_told_once_and_costs_its_rows(
    jobs: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Rows are first looked at for uncertain values: a mistake there must not end the stream either."""
    bind = Case.bind

    def wrong(case: Case, row: dict[str, Any], **more: Any) -> Any:
        if str(row.get("distance", "")).startswith("1"):
            raise ZeroDivisionError("unlucky")
        return bind(case, row, **more)

    monkeypatch.setattr(Case, "bind", wrong)
    rows = "".join(f'{{"distance": "{n} ± 0.5 m", "friction": 0.7}}\n' for n in range(15, 25))
    outcome = run(*SPEED, *jobs, stdin=rows)
    assert outcome.status == 4
    made = [json.loads(line) for line in outcome.out.splitlines()]
    assert [index for index, row in enumerate(made) if "error" in row] == [0, 1, 2, 3, 4]
    assert outcome.err.count("ZeroDivisionError: unlucky") == 1
