"""Uncertain values from the command line and JSON to the document."""

import json
import math
from statistics import NormalDist
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.core.inputs.uncertain.values import read_uncertain
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.distributions.beta import log_odds
from dynamics_cli.quantities import Fraction, Friction, Kind, Length, Mass, Slope, Temperature

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
        (Mass, "1500 ± 3 % kg", ("normal", 1500.0, 45.0)),
        (Mass, "1500 kg ± 3% kg", ("normal", 1500.0, 45.0)),
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
        (Fraction, "70 ± 5 %", ("normal", 0.7, 0.05)),
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
        (Fraction, "0.7 ± 5 %", "a share of the value or a difference"),
        (Friction, "0.72 ± 5 %", "a share of the value or a difference"),
        (Friction, "0.7 ± -0.1", "negative"),
        (Friction, "-0.1..0.3", "at least 0"),
        (Length, "20..25", "has no unit"),
        (Length, "25..20 m", "above the upper one"),
        (Mass, "1500 ± 50 m", "is a length"),
        (Friction, "uniform(0.5)", "does not have the form low, high"),
        (Friction, "beta(2, 3)", "does not have the form alpha, beta, low, high"),
        (Friction, "beta(2, 0, 0.6, 0.8)", "shape of 0"),
        (Friction, "beta(2, 3 m, 0.6, 0.8)", "not a decimal"),
        (Friction, "lognormal(0.7", "closing"),
        (Friction, "0.7 ±", "the quantity is empty"),
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
    for fragment in ("60 ± 2 ft", "90 %: ", "are driven by", "60 km/h exceeded: 12 %"):
        assert fragment in outcome.out
    for fragment in ("90 % within", "speed is driven by", "worst case", "with a probability of 12"):
        assert fragment in run(*SKID, "--limit", "60 km/h", "--coverage", "90 %", "--all").out


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


def _speed(friction: Any, angle: Any) -> Any:
    """km/h from 30 m of skid on a grade of this angle: v² = 2 g d (μ cos θ + sin θ)."""
    return 3.6 * np.sqrt(2.0 * 9.80665 * 30.0 * (friction * np.cos(angle) + np.sin(angle)))


@pytest.mark.parametrize(
    ("grade", "ends"),
    [
        ("-0.03 ± 0.005 rad", (-0.03 - 1.959963984540054 * 0.005, -0.03 + 1.959963984540054 * 0.005)),
        ("-20 ± 5 deg", tuple(math.radians(-20 + sign * 1.959963984540054 * 5) for sign in (-1, 1))),
        ("-20..10 deg", (math.radians(-19.25), math.radians(9.25))),
    ],
)
def test_an_uncertain_angle_of_a_grade_is_an_angle(grade: str, ends: tuple[float, float]) -> None:
    """Quantiles are those of the angle, carried through the formula by themselves: the speed rises with the angle."""
    speed = answer("skid", "speed", "--distance", "30 m", "--friction", "1.5", "--grade", grade)["results"]["speed"]
    assert speed["interval"] == pytest.approx([_speed(1.5, end) for end in ends], rel=1e-11)


def test_an_uncertain_angle_among_other_uncertain_inputs() -> None:
    argv = ("--distance", "30 m", "--friction", "0.6..0.8", "--grade", "triangular(-12, -2, 4) deg")
    speed = answer("skid", "speed", *argv)["results"]["speed"]
    share = (np.arange(2000) + 0.5) / 2000
    angle = np.where(share < 100 / 160, -12 + np.sqrt(share * 160), 4 - np.sqrt((1 - share) * 96))
    values = _speed((0.6 + 0.2 * share)[:, None], np.radians(angle))
    assert speed["interval"] == pytest.approx(np.quantile(values, (0.025, 0.975)).tolist(), abs=2e-3)
    assert [speed["mean"], speed["std"]] == pytest.approx([values.mean(), values.std()], abs=1e-3)


def test_an_uncertain_angle_reads_back_in_its_own_unit() -> None:
    argv = ("skid", "speed", "--distance", "30 m", "--friction", "0.7", "--grade")
    shown = answer(*argv, "-2 ± 0.5 deg")["inputs"]["grade"]
    assert shown == {"value": -2, "unit": "deg", "distribution": "normal", "mean": -2, "std": 0.5}


def test_angles_beyond_upright_are_inadmissible() -> None:
    argv = ("skid", "speed", "--distance", "30 m", "--friction", "0.7", "--grade", "45 ± 20 deg")
    entry = answer(*argv)["numerics"]["uncertainty"]["results"]["speed"]
    beyond = math.erfc((90 - 45) / 20 / math.sqrt(2)) / 2
    # below −34.99° the vehicle does not stop
    short = math.erfc((45 + math.degrees(math.atan(0.7))) / 20 / math.sqrt(2)) / 2
    assert entry["admissible"] == pytest.approx(1 - beyond - short, abs=2e-4)


@pytest.mark.parametrize("grade", ["-2 deg ± 0.5 %", "-1 deg..3 %", "-2 deg ± 5 %"])
def test_a_grade_is_an_angle_or_a_rise_throughout(grade: str) -> None:
    outcome = run("skid", "speed", "--distance", "30 m", "--friction", "0.7", "--grade", grade)
    assert outcome.status == 2
    assert "mixes an angle with a rise over run" in outcome.err


@pytest.mark.parametrize("shapes", [(2.0, 3.0), (0.2, 0.3), (0.5, 0.5), (1.0, 1.0), (100.0, 3.0), (1e4, 1e3)])
def test_quantiles_of_beta_distributions(shapes: tuple[float, float]) -> None:
    """Against mpmath's incomplete beta function: the probability below each quantile is that of its score."""
    a, b = shapes
    scores = (-8.3, -1.96, -0.31, 0.77, 6.5)
    for z, odds in zip(scores, log_odds(np.array(scores), a, b).tolist(), strict=True):
        with mp.workdps(50):
            x, rest = 1 / (1 + mp.exp(-mp.mpf(odds))), 1 / (1 + mp.exp(mp.mpf(odds)))
            ends = (a, b, 0, x) if z < 0 else (b, a, 0, rest)
            wrong = mp.betainc(*ends, regularized=True) - mp.ncdf(-abs(mp.mpf(z)))
            assert abs(wrong * mp.beta(a, b) / (x**a * rest**b)) < 2e-12 * max(1.0, abs(odds))


@pytest.mark.parametrize(
    ("by_name", "by_dots"), [("uniform(20, 25) m", "20..25 m"), ("triangular(20, 24, 25 m)", "20..24..25 m")]
)
def test_distributions_by_name_and_by_dots(by_name: str, by_dots: str) -> None:
    argv = ("skid", "speed", "--friction", "0.7", "--distance")
    assert answer(*argv, by_name) == answer(*argv, by_dots)


def test_a_beta_distribution_in_a_document(tmp_path: Any) -> None:
    document = answer("skid", "speed", "--distance", "beta(2, 1, 20, 30) m", "--friction", "0.7")
    shown = document["inputs"]["distance"]
    assert shown | {"value": 0} == {
        "value": 0, "unit": "m", "distribution": "beta", "alpha": 2.0, "beta": 1.0, "low": 20, "high": 30,
    }  # fmt: skip
    # of shapes 2 and 1 the distribution function is a square
    ends = [3.6 * math.sqrt(2 * 9.80665 * 0.7 * (20 + 10 * math.sqrt(p))) for p in (0.025, 0.975)]
    assert document["results"]["speed"]["interval"] == pytest.approx(ends, rel=1e-12)
    file = tmp_path / "again.json"
    file.write_text(json.dumps(document["inputs"]))
    assert answer("skid", "speed", "--input", str(file))["results"] == document["results"]


def test_a_beta_distribution_among_other_uncertain_inputs() -> None:
    argv = ("--distance", "20..30 m", "--friction", "beta(2, 1, 0.6, 0.8)", "--method")
    speed = answer("skid", "speed", *argv, "auto")["results"]["speed"]
    share = (np.arange(2000) + 0.5) / 2000
    values = _speed((0.6 + 0.2 * np.sqrt(share))[:, None], 0.0) * np.sqrt((20 + 10 * share) / 30)
    assert speed["interval"] == pytest.approx(np.quantile(values, (0.025, 0.975)).tolist(), abs=2e-3)
    assert speed["std"] == pytest.approx(values.std(), abs=1e-3)


def test_quantiles_and_limits_of_named_results_as_often_as_asked() -> None:
    """A distance is normal, so its quantiles are known; a limit at a quantile has the rest of the probability."""
    call = ("skid", "speed", "--distance", "20 ± 0.5 m", "--friction", "0.7 ± 0.03")
    levels = [0.001, 0.05, 0.3, 0.025, 0.9]
    asked = [word for p in levels for name in ("total_distance", "speed") for word in ("--quantile", f"{name}={p}")]
    document = answer(*call, *asked)
    found = {(item["result"], item["probability"]): item["value"] for item in document["quantiles"]}
    assert len(found) == 2 * len(levels)
    for p in levels:
        assert found["total_distance", p] == pytest.approx(20.0 + 0.5 * NormalDist().inv_cdf(p), rel=1e-9)
    assert found["speed", 0.025] == pytest.approx(document["results"]["speed"]["interval"][0], rel=1e-9)
    limits = [word for p in levels for word in ("--limit", f"speed={found['speed', p]} km/h")]
    limits += ["--limit", "time=2.4 s"]
    beyond = answer(*call, *limits)["limits"]
    assert [item["result"] for item in beyond] == ["speed"] * 5 + ["time"]
    for p, item in zip(levels, beyond, strict=False):
        assert item["probability"] == pytest.approx(1.0 - p, abs=2e-5)


@pytest.mark.parametrize("method", ["linear", "lattice", "monte-carlo", "quadrature"])
def test_quantiles_come_from_every_method(method: str) -> None:
    call = ("skid", "speed", "--distance", "20 ± 0.5 m", "--friction", "0.6..0.7..0.8", "--method", method)
    document = answer(*call, "--samples", "200000", "--quantile", "speed=90 %", "--quantile", "speed=97.5 %")
    first, second = (item["value"] for item in document["quantiles"])
    assert second == pytest.approx(document["results"]["speed"]["interval"][1], rel=1e-12)
    assert document["results"]["speed"]["median"] < first < second


@pytest.mark.parametrize(
    ("argument", "code"),
    [
        ("speed=0", "bounds"),
        ("speed=1", "bounds"),
        ("speed=3 m", "kind"),
        ("nosuch=0.5", "unknown-result"),
        ("0.5", "usage"),
    ],
)
def test_a_quantile_is_of_a_result_at_a_probability(argument: str, code: str) -> None:
    outcome = run("skid", "speed", "--distance", "20 ± 0.5 m", "--friction", "0.7", "--quantile", argument, "--json")
    assert outcome.status == 2
    assert (outcome.error["parameter"], outcome.error["code"]) == ("quantile", code)


def test_certain_results_have_no_quantiles() -> None:
    outcome = run("skid", "speed", "--distance", "20 m", "--friction", "0.7", "--quantile", "speed=0.5", "--json")
    assert (outcome.status, outcome.error["parameter"]) == (2, "quantile")


@pytest.mark.parametrize("text", ["[1e300, 0] m", "[1e308, 1e308, 1e308] m", "1e200 ± 1e199 m", "1..1e300 m"])
def test_values_whose_variance_leaves_the_doubles_are_refused(text: str) -> None:
    outcome = run("skid", "speed", "--distance", text, "--friction", "0.7", "--json")
    assert outcome.status == 2
    assert outcome.error["code"] == "range"
    assert outcome.error["parameter"] == "distance"
    rows = run("skid", "speed", "--friction", "0.7", "--rows", "-", stdin=f'distance\n"{text}"\n60 ft\n')
    assert rows.status == 4
    assert "internal" not in rows.out


def test_what_overflows_within_a_distribution_prints_no_warning(recwarn: pytest.WarningsRecorder) -> None:
    assert run("skid", "speed", "--distance", "1e149 ± 1e148 m", "--friction", "0.7..0.8").status == 0
    assert run("path", "rectilinear", "--start-speed", "3 m/s", "--distance", "1e149 ± 1e148 m", "--acceleration",
               "1e149..2e149 m/s^2").status in (0, 3)  # fmt: skip
    assert [str(one.message) for one in recwarn if one.category is RuntimeWarning] == []


class TestPartsOfCompoundUnits:
    """An uncertain result in `ft;in` has all its numbers in feet and inches, and is carried on as any other."""

    CALL = ("skid", "distance", "--speed", "50 ± 1 mph", "--friction", "0.7")

    def test_every_number_is_in_parts(self) -> None:
        parts = answer(*self.CALL, "--to", "distance=ft;in")["results"]["distance"]
        inches = answer(*self.CALL, "--to", "distance=in")["results"]["distance"]
        for name in ("value", "mean", "median", "std"):
            feet, rest = parts[name]
            assert 12.0 * feet + rest == pytest.approx(inches[name], rel=1e-12)
        for end, whole in zip(parts["interval"], inches["interval"], strict=True):
            assert 12.0 * end[0] + end[1] == pytest.approx(whole, rel=1e-12)

    def test_it_is_read_again(self, tmp_path: Any) -> None:
        speeds = []
        for name, more in (("parts", ("--to", "distance=ft;in")), ("metres", ())):
            path = tmp_path / f"{name}.json"
            path.write_text(json.dumps(answer(*self.CALL, *more)))
            again = answer("skid", "speed", "--distance", f"@{path}:distance", "--friction", "0.7")
            speeds.append(again["results"]["speed"])
        assert speeds[0]["value"] == pytest.approx(speeds[1]["value"], rel=1e-12)
        assert speeds[0]["interval"] == pytest.approx(speeds[1]["interval"], rel=1e-6)

    def test_the_short_answer_has_its_interval(self) -> None:
        out = run(*self.CALL, "--to", "distance=ft;in").out
        assert " ".join(out.splitlines()[0].split()) == "distance 119 ft 5 in 95 %: 110 ft 3 in to 128 ft 11 in"

    def test_cells_have_the_unit_of_their_part(self) -> None:
        head = run(*self.CALL, "--to", "distance=ft;in", "--format", "csv").out.splitlines()[0]
        assert "distance[0].std[ft]" in head
        assert "distance[1].high[in]" in head
        assert "ft;in" not in head
