"""`--limit` in rows and sweeps: a verdict beside each result, by arrays as one by one; `--fail` acts on it."""

import csv
import io
import json
from math import erfc, sqrt

import pytest
from harness import run

G = 9.80665
CASES = "distance[m],friction\n" + "".join(f"{10 + place % 30},0.7\n" for place in range(600))
LIMIT = 15.0


def speed(distance: float) -> float:
    return sqrt(2.0 * G * 0.7 * distance)


def test_each_row_says_whether_it_exceeds_the_limit_by_every_route() -> None:
    words = ("skid", "speed", "--rows", "-", "--only", "time", "--limit", "speed=15 m/s")
    outcome = run(*words, stdin=CASES)
    rows = list(csv.DictReader(io.StringIO(outcome.out)))
    verdicts = [row["speed.limit_exceeded"] for row in rows]
    assert verdicts == [str(speed(float(row["distance[m]"])) > LIMIT).lower() for row in rows]
    count = verdicts.count("true")
    assert (outcome.status, outcome.err) == (0, f"dynamics: speed exceeds 15 m/s in {count} of 600 rows\n")
    singly = run(*words, "--fail", stdin=CASES)
    assert (singly.status, singly.out, singly.err) == (6, outcome.out, outcome.err)
    objects = run(*words, "--format", "ndjson", stdin=CASES)
    results = [json.loads(line)["results"] for line in objects.out.splitlines()]
    assert [str(result["speed"]["limit_exceeded"]).lower() for result in results] == verdicts
    assert run(*words, "--format", "ndjson", "--fail", stdin=CASES).out == objects.out


def test_a_limit_without_a_name_is_for_the_first_result_that_it_can_apply_to() -> None:
    outcome = run("skid", "speed", "--rows", "-", "--limit", "3 s", "--limit", "2 s", "--fail", stdin=CASES[:76])
    assert outcome.out.splitlines()[0].split(",")[3:6] == ["time[s]", "time.limit_exceeded", "time.limit_exceeded_2"]
    assert outcome.status == 6
    refused = run("skid", "speed", "--rows", "-", "--limit", "spee=3 m/s", stdin=CASES)
    assert (refused.status, "no result 'spee'" in refused.err) == (2, True)


def test_an_uncertain_row_has_the_probability() -> None:
    cases = "distance[m],friction\n20 ± 1,0.7\n20,0.7\n"
    words = ("skid", "speed", "--rows", "-", "--only", "speed", "--limit", "17 m/s", "--fail-above")
    outcome = run(*words, "10 %", stdin=cases)
    first, second = csv.DictReader(io.StringIO(outcome.out))
    chance = 0.5 * erfc((17.0**2 / (2.0 * G * 0.7) - 20.0) / sqrt(2.0))
    assert float(first["speed.limit_probability"]) == pytest.approx(chance, rel=1e-4)
    assert (second["speed.limit_probability"], outcome.status) == ("0.0", 6)
    assert run(*words, "20 %", stdin=cases).status == 0


def test_a_sweep_has_a_column_of_verdicts() -> None:
    words = ["skid", "speed", "--distance", "20 m", "--sweep", "friction=0.4:0.8:5", "--limit", "15 m/s", "--fail"]
    outcome = run(*words, "--json")
    wanted = [sqrt(2.0 * G * friction * 20.0) > LIMIT for friction in (0.4, 0.5, 0.6, 0.7, 0.8)]
    assert outcome.document["results"]["sweep"]["speed.limit_exceeded"]["value"] == wanted
    (entry,) = outcome.document["limits"]
    assert (entry["beyond"], outcome.status) == (True, 6)
    assert entry["message"] == f"speed exceeds 15 m/s at {sum(wanted)} of 5 points"


def test_a_serious_warning_of_one_row_fails() -> None:
    cases = "moments[0][kg*m^2],moments[1][kg*m^2],moments[2][kg*m^2]\n2,3,4\n1,1,2.1\n"
    words = ("inertia", "tensor", "--rows", "-", "--tolerance", "0.2")
    assert [run(*words, *more, stdin=cases).status for more in ((), ("--fail",))] == [0, 6]


def test_an_uncertain_sweep_shows_its_probabilities_first() -> None:
    words = ["skid", "speed", "--distance", "20 ± 1 m", "--sweep", "friction=0.3, 0.4", "--limit", "time=3 s"]
    heads = run(*words, env={"COLUMNS": "80"}).out.splitlines()[1].split("  ")
    assert [head.strip() for head in heads if head][:3] == ["friction", "time", "beyond limit"]
