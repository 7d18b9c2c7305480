"""Uncertain values from the command line and JSON to the document."""

import json
import math
from typing import Any

import pytest
from harness import answer, run

from dynamics_cli.core.uncertain.text import read_uncertain
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Friction, Kind, Length, Mass, Slope, Temperature

SKID = ("skid", "speed", "--distance", "60 ± 2 ft", "--friction", "0.72 ± 0.04")
FOOT = 0.3048


def spread(kind: Any, raw: Any) -> tuple[str, float, float]:
    bound, _ = read_uncertain(kind, raw, "x", "")
    return bound.distribution.name, bound.distribution.mean, bound.distribution.std


@pytest.mark.parametrize(
    ("kind", "raw", "wanted"),
    [
        (Friction, "0.72 ± 0.04", ("normal", 0.72, 0.04)),
        (Friction, "0.72 +/- 0.04 ", ("normal", 0.72, 0.04)),
        (Mass, "1500±50 kg", ("normal", 1500.0, 50.0)),
        (Mass, "1500 kg ± 3 %", ("normal", 1500.0, 45.0)),
        (Length, "60 ft ± 6 in", ("normal", 60 * FOOT, 0.5 * FOOT)),
        (Length, "5 ft 6 in ± 1 in", ("normal", 5.5 * FOOT, FOOT / 12)),
        (Friction, "0.65..0.75", ("uniform", 0.7, 0.1 / math.sqrt(12))),
        (Length, "20..25 m", ("uniform", 22.5, 5 / math.sqrt(12))),
        (Friction, "0.6..0.7..0.8", ("triangular", 0.7, 0.1 / math.sqrt(6))),
        (Friction, "lognormal(0.72 ± 0.04)", ("lognormal", 0.72, 0.04)),
        (Mass, "lognormal(1500, 50 kg)", ("lognormal", 1500.0, 50.0)),
        (Mass, "uniform(1400, 1600) kg", ("uniform", 1500.0, 200 / math.sqrt(12))),
        (Friction, "truncated(0.72 ± 0.1, 0.52, 0.92)", ("truncated", 0.72, 0.0879626)),
        (Friction, "[0.71, 0.74, 0.70, 0.73, 0.72]", ("readings", 0.72, 0.0070710678 * math.sqrt(2.0))),
        (Length, "[60, 61] ft", ("readings", 60.5 * FOOT, math.inf)),
        (Friction, "empirical(0.7, 0.8)", ("empirical", 0.75, 0.05)),
        (Slope, "-3 ± 0.5 %", ("normal", -0.03, 0.005)),
        (Slope, "-3 % ± 0.5 %", ("normal", -0.03, 0.005)),
        (Slope, "45 ± 1 deg", ("normal", 1.0, 2 * math.pi / 180)),
        (Temperature, "20 ± 2 degC", ("normal", 293.15, 2.0)),
        (Mass, {"value": 1500, "std": 50, "unit": "kg"}, ("normal", 1500.0, 50.0)),
        (Length, {"distribution": "uniform", "low": 20, "high": 25, "unit": "ft"}, ("uniform", 6.858, 5 * FOOT / math.sqrt(12))),  # noqa: E501
        (Friction, [0.71, 0.73], ("readings", 0.72, math.inf)),
        (Length, {"value": 9, "unit": "m", "median": 9, "interval": [7, 11], "coverage": 0.95}, ("result", 9.0, 1.0204269)),  # noqa: E501
    ],
)  # fmt: skip
def test_every_form_is_read(kind: Kind, raw: Any, wanted: tuple[str, float, float]) -> None:
    name, mean, std = spread(kind, raw)
    assert name == wanted[0]
    assert mean == pytest.approx(wanted[1], rel=1e-12)
    assert std == pytest.approx(wanted[2], rel=1e-6)


@pytest.mark.parametrize(
    ("kind", "text", "fragment"),
    [
        (Friction, "0.72 ± 5 %", "a share of it or a difference"),
        (Friction, "0.7 ± -0.1", "negative"),
        (Friction, "-0.1..0.3", "at least 0"),
        (Length, "20..25", "unit is missing"),
        (Length, "25..20 m", "above the upper one"),
        (Mass, "1500 ± 50 m", "is a length"),
        (Friction, "uniform(0.5)", "not made of low, high"),
        (Friction, "lognormal(0.7", "closing"),
        (Friction, "0.7 ±", "nothing is written"),
        (Friction, "[0.7]", "at least two"),
    ],
)
def test_what_is_no_distribution_is_refused(kind: Kind, text: str, fragment: str) -> None:
    with pytest.raises(UsageError, match=fragment):
        read_uncertain(kind, text, "x", "")


def test_the_document_says_all() -> None:
    document = answer(*SKID, "--limit", "60 km/h")
    speed = document["results"]["speed"]
    certain = answer("skid", "speed", "--distance", "60 ft", "--friction", "0.72")
    assert speed["value"] == certain["results"]["speed"]["value"]
    assert speed["interval"] == pytest.approx([54.12584, 61.48092], abs=2e-5)
    assert speed["std"] == pytest.approx(1.876031, abs=2e-6)
    assert speed["coverage"] == 0.95
    assert document["inputs"]["friction"]["distribution"] == "normal"
    drivers = document["sensitivity"]["speed"]
    assert [row["input"] for row in drivers["inputs"]] == ["friction", "distance"]
    assert sum(row["share"] for row in drivers["inputs"]) == pytest.approx(1.0, abs=1e-3)
    assert drivers["worst_case"][0] < speed["interval"][0]
    assert document["covariance"]["results"] == ["speed", "time", "total_distance"]
    assert document["limits"][0]["probability"] == pytest.approx(0.1226, abs=5e-3)
    assert document["numerics"]["uncertainty"]["results"]["speed"]["estimate"] < 1e-4


def test_inputs_as_shown_are_read_again(tmp_path: Any) -> None:
    document = answer(*SKID, "--grade", "-0.04..-0.02")
    file = tmp_path / "again.json"
    file.write_text(json.dumps(document["inputs"]))
    again = answer("skid", "speed", "--input", str(file))
    assert again["results"] == document["results"]


def test_an_earlier_result_comes_with_its_distribution(tmp_path: Any) -> None:
    file = tmp_path / "first.json"
    file.write_text(json.dumps(answer(*SKID)))
    document = answer("skid", "stop", "--speed", f"@{file}:speed", "--friction", "0.7", "--reaction-time", "1.5 s")
    first = json.loads(file.read_text())["results"]["speed"]
    assert document["inputs"]["speed"]["distribution"] == "result"
    reaction = document["results"]["reaction_distance"]
    assert reaction["interval"] == pytest.approx([end / 3.6 * 1.5 for end in first["interval"]], rel=1e-9)


def test_the_table_shows_interval_and_drivers() -> None:
    outcome = run(*SKID, "--limit", "60 km/h", "--coverage", "90 %")
    assert outcome.status == 0, outcome.err
    for fragment in ("60 ± 2 ft", "90 % within", "speed is driven by", "not an interval", "with a probability of 12"):
        assert fragment in outcome.out


def test_csv_has_the_spread_in_columns() -> None:
    head = run(*SKID, "--format", "csv").out.splitlines()[0]
    assert "speed.mean[km/h]" in head
    assert "speed.high[km/h]" in head


def test_both_routes_give_the_same_bytes() -> None:
    assert run(*SKID, "--json").out == run(*SKID, "--json", route="tree").out


@pytest.mark.parametrize("method", ["linear", "second-order", "unscented", "quadrature", "lattice", "monte-carlo"])
def test_every_method_by_name(method: str) -> None:
    document = answer(*SKID, "--method", method, "--samples", "100000", "--seed", "7")
    assert document["results"]["speed"]["interval"] == pytest.approx([54.126, 61.481], abs=0.2)
    assert document["numerics"]["uncertainty"]["seed"] == 7


def test_correlation_narrows_or_widens() -> None:
    plus = answer(*SKID, "--correlate", "distance,friction=0.5")["results"]["speed"]["std"]
    minus = answer(*SKID, "--correlate", "distance,friction=-0.5")["results"]["speed"]["std"]
    assert minus < answer(*SKID)["results"]["speed"]["std"] < plus
    wrong = run(*SKID, "--correlate", "distance=0.5")
    assert wrong.status == 2
    assert "A,B=RHO" in wrong.err


def test_a_part_that_cannot_be_is_said() -> None:
    document = answer("skid", "speed", "--distance", "30 m", "--friction", "0.1 ± 0.03", "--grade", "-6 ± 1 %")
    codes = [warning["code"] for warning in document["warnings"]]
    assert "partly-inadmissible" in codes
    entry = document["numerics"]["uncertainty"]["results"]["speed"]
    assert entry["admissible"] == pytest.approx(0.8970, abs=1e-3)


def test_several_surfaces_by_address() -> None:
    surface = "distance=10 ± 0.3 m, friction=0.7 ± 0.05, grade=-3 %"
    document = answer("skid", "speed", "--segment", surface, "--segment", surface.replace("0.7", "0.5"))
    drivers = [row["input"] for row in document["sensitivity"]["speed"]["inputs"]]
    assert set(drivers[:2]) == {"segments[0].friction", "segments[1].friction"}


def test_few_readings() -> None:
    document = answer("skid", "speed", "--distance", "60 ft", "--friction", "[0.71, 0.74, 0.70]")
    speed = document["results"]["speed"]
    assert speed["std"] is None
    assert speed["interval"][0] < speed["value"] < speed["interval"][1]
    assert "no-deviation" in [warning["code"] for warning in document["warnings"]]


def test_inputs_that_only_tables_depend_on_are_not_passed_over_in_silence() -> None:
    argv = ("cam", "rise", "--law", "3-4-5", "--lift", "20 mm", "--span", "70 deg")
    codes = [warning["code"] for warning in answer(*argv, "--at", "35 ± 0.5 deg")["warnings"]]
    assert "nothing-varies" in codes
    assert "nothing-varies" not in [warning["code"] for warning in answer(*argv, "--at", "35 ± 0 deg")["warnings"]]
