"""Vectors whose components, or magnitude and direction, are uncertain; vector results with their distributions."""

import csv
import json
import math
from pathlib import Path

import pytest
from harness import answer, run

FIXED = ("--first-mass", "1 kg", "--second-mass", "1 kg", "--normal", "0 deg", "--restitution", "0.5")
OBLIQUE = ("impact", "oblique", *FIXED, "--second-velocity", "-0.1, 0.05 m/s")


SI = ("--to", "velocity=m/s", "--to", "tangential_velocity=m/s")


def results(*argv: str) -> dict:
    outcome = run(*argv, *(SI if "oblique" in argv else ()), "--json")
    assert outcome.status == 0, outcome.err
    return outcome.document


def test_a_component_alone_gives_its_own_distribution() -> None:
    """The first body keeps 1/4 of its own velocity along the line: 0.25·(3 ± 0.1) + 0.75·(−0.1) m/s."""
    document = results(*OBLIQUE, "--first-velocity", "3 ± 0.1, 0.2 m/s")
    velocity = document["results"]["first"]["velocity"]
    assert velocity["value"] == pytest.approx([0.25 * 3 - 0.075, 0.2], rel=1e-15)
    assert velocity["mean"] == pytest.approx(velocity["value"], rel=1e-12)
    assert velocity["std"] == pytest.approx([0.025, 0.0], rel=1e-9)
    low, high = velocity["interval"]
    half = 1.9599639845400545 * 0.025
    assert [low[0], high[0]] == pytest.approx([0.675 - half, 0.675 + half], rel=1e-9)
    assert low[1] == high[1] == 0.2
    assert velocity["coverage"] == 0.95
    assert document["numerics"]["uncertainty"]["results"]["first.velocity[0]"]["estimate"] < 1e-9


@pytest.mark.parametrize("force", ["200 N ± 1 % @ 90 deg", "200 ± 1 % N @ 90 deg", "0, 200 N ± 1 %", "0, 200 ± 1 % N"])
def test_a_share_keeps_the_unit_of_a_vector_of_any_kind(force: str) -> None:
    moment = answer("force", "moment", "--force", force, "--at", "0.5, 0 m")["results"]["moment"]
    assert (moment["value"][2], moment["unit"]) == (pytest.approx(100.0), "N·m")
    assert moment["std"][2] == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize("at", ["0.5 ± 1 %, 0 m", "0.5 m ± 1 %, 0 m", "0.5 ± 0.005, 0 m"])
def test_a_share_of_one_component_leaves_it_the_shared_unit(at: str) -> None:
    moment = answer("force", "moment", "--force", "0, 200 N", "--at", at)["results"]["moment"]
    assert moment["std"][2] == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize("written", ["3 ± 0.1, 0.2 m/s", "3 m/s ± 10 cm/s, 0.2 m/s", "300 ± 10, 20 cm/s"])
def test_a_unit_written_last_is_that_of_all_components(written: str) -> None:
    velocity = results(*OBLIQUE, "--first-velocity", written)["results"]["first"]["velocity"]
    assert velocity["std"] == pytest.approx([0.025, 0.0], rel=1e-9)


@pytest.mark.parametrize(
    "written",
    ["2.8..3.2, 0.2 m/s", "uniform(2.8, 3.2) m/s, 0.2 m/s", "uniform(2.8, 3.2), 0.2 m/s", "2.8..3.2 m/s, 0.2 m/s"],
)
def test_every_distribution_may_be_a_component(written: str) -> None:
    low, high = results(*OBLIQUE, "--first-velocity", written)["results"]["first"]["velocity"]["interval"]
    assert [low[0], high[0]] == pytest.approx([0.675 - 0.05 * 0.95, 0.675 + 0.05 * 0.95], rel=1e-9)


def test_magnitude_and_direction_vary_apart() -> None:
    """Only the tangential component, v·sin α, is untouched by the impact of smooth bodies."""
    document = results(*OBLIQUE, "--first-velocity", "3 m/s @ 20 ± 1 deg")
    velocity = document["inputs"]["first"]["velocity"]
    assert velocity["magnitude"] == {"value": 3, "unit": "m/s"}
    assert (velocity["direction"]["mean"], velocity["direction"]["std"]) == (20, 1)
    tangential = document["results"]["first"]["tangential_velocity"]
    # v·E[sin α] = v·sin 20°·exp(−σ²/2)
    assert tangential["mean"] == pytest.approx(
        3 * math.sin(math.radians(20)) * math.exp(-(math.radians(1) ** 2) / 2), rel=1e-9
    )
    assert document["sensitivity"]["first.velocity[1]"]["inputs"][0]["input"] == "first.velocity.direction"
    assert "3 m/s @ 20 ± 1 deg" in run(*OBLIQUE, "--first-velocity", "3 m/s @ 20 ± 1 deg").out


@pytest.mark.parametrize("written", ["3 ± 0.1, 0.2 ± 0.02 m/s", "3 ± 0.1 m/s @ 5 ± 1 deg", "3 m/s @ 4..6 deg"])
def test_the_inputs_of_a_document_read_back(written: str, tmp_path: Path) -> None:
    first = run(*OBLIQUE, "--first-velocity", written, "--json")
    inputs = tmp_path / "inputs.json"
    inputs.write_text(json.dumps(first.document["inputs"]))
    again = run("impact", "oblique", "--input", str(inputs), "--json")
    assert again.status == 0, again.err
    assert again.document["results"] == first.document["results"]
    assert again.document["inputs"] == first.document["inputs"]


def test_a_vector_of_an_earlier_document_keeps_distribution_and_correlation(tmp_path: Path) -> None:
    """Struck again along the same line, the sum of both velocities along it is what it was: nothing of it is lost."""
    before = run(*OBLIQUE, "--first-velocity", "3 ± 0.1 m/s @ 5 ± 1 deg", "--json")
    (tmp_path / "a.json").write_text(before.out)
    name = f"@{tmp_path / 'a.json'}"
    argv = ("impact", "oblique", "--first-mass", "1 kg", "--second-mass", "1 kg", "--normal", "180 deg")
    argv += ("--restitution", "1", "--first-velocity", f"{name}:first.velocity")
    after = results(*argv, "--second-velocity", f"{name}:second.velocity")
    assert after["inputs"]["second"]["velocity"]["distributions"][1] is None
    told = after["numerics"]["uncertainty"]["correlations"]
    assert told["first.velocity[0],second.velocity[0]"] == pytest.approx(1.0, abs=1e-5)
    # u = (1 − e)/2·u₀ and (1 + e)/2·u₀ + …: an elastic impact exchanges them
    spread = before.document["results"]
    assert after["results"]["first"]["velocity"]["std"][0] == pytest.approx(
        spread["second"]["velocity"]["std"][0], rel=1e-3
    )


def test_copies_are_named_beside_the_covariance() -> None:
    covariance = results(*OBLIQUE, "--first-velocity", "3 ± 0.1, 0.2 m/s")["covariance"]
    assert covariance["same"]["second.delta_v.magnitude"] == "first.delta_v.magnitude"
    assert "second.delta_v.magnitude" not in covariance["results"]


def test_tables_show_the_components() -> None:
    out = run(*OBLIQUE, "--first-velocity", "3 ± 0.1, 0.2 m/s", *SI, "--all").out
    assert "first.velocity   [3 ± 0.1, 0.2] m/s" in out
    assert "95 % each within [0.626001, 0.2] to [0.723999, 0.2], σ [0.025, 0]" in out
    assert "first.velocity[0] is driven by" not in out


def test_csv_has_a_column_for_every_number() -> None:
    out = run(*OBLIQUE, "--first-velocity", "3 ± 0.1, 0.2 m/s", *SI, "--format", "csv").out
    head, row = csv.reader(out.splitlines())
    cells = dict(zip(head, row, strict=True))
    assert float(cells["first.velocity[0].std[m/s]"]) == pytest.approx(0.025)
    assert float(cells["first.velocity[1].low[m/s]"]) == 0.2


def test_rows_give_what_single_calls_give() -> None:
    single = results(*OBLIQUE, "--first-velocity", "3 ± 0.1, 0.2 m/s")["results"]["first"]["velocity"]
    rows = '{"first": {"velocity": "3 ± 0.1, 0.2 m/s"}}\n{"first": {"velocity": ["3 ± 0.1 m/s", "0.2 m/s"]}}\n'
    out = run(*OBLIQUE, "--rows", "-", *SI, stdin=rows).out
    for line in out.splitlines():
        velocity = json.loads(line)["results"]["first"]["velocity"]
        assert velocity == {key: single[key] for key in velocity}
        assert set(velocity) == {"value", "unit", "mean", "median", "std", "interval"}
    rows = "first.velocity[0][m/s],first.velocity[1][m/s]\n3 ± 0.1,0.2\n"
    head, row = csv.reader(run(*OBLIQUE, "--rows", "-", *SI, stdin=rows).out.splitlines())
    cells = dict(zip(head, row, strict=True))
    assert float(cells["first.velocity[0].high[m/s]"]) == single["interval"][1][0]


def test_tensors_vary_by_their_elements_and_axes_stay() -> None:
    """A cylinder's moment about its axis is m·r²/2."""
    argv = ("inertia", "shape", "cylinder", "--mass", "3 ± 0.1 kg", "--radius", "10 cm", "--length", "20 cm")
    found = results(*argv)["results"]
    assert found["tensor"]["std"][2][2] == pytest.approx(0.1 * 0.01 / 2, rel=1e-9)
    assert found["tensor"]["std"][0][1] == 0.0
    assert "interval" not in found["centroid"]
    assert "interval" not in found["principal_axes"][0]


@pytest.mark.parametrize(
    ("written", "parameter", "code"),
    [
        ("3 ± 0.1, 0.2, 1 m/s", "first.velocity", "usage"),
        ("3 ± 0.1, 0.2", "first.velocity", "missing-unit"),
        ("3 ± 0.1 m/s @ 5 ± 1 m", "first.velocity", "kind"),
        ("3 ± -0.1, 0.2 m/s", "first.velocity", "distribution"),
    ],
)
def test_what_is_wrong_is_told(written: str, parameter: str, code: str) -> None:
    outcome = run(*OBLIQUE, "--first-velocity", written, "--json")
    assert (outcome.status, outcome.error["parameter"]) == (2, parameter)
    assert outcome.error["code"] == code, outcome.error


def test_a_certain_vector_is_shown_as_it_was_written() -> None:
    call = ("impact", "oblique", "--first-mass", "1 kg", "--second-fixed", "--first-velocity", "10 mph @ 37 deg")
    call += ("--normal", "20 deg", "--restitution", "0.5")
    assert "first velocity 10 mph @ 37 deg" in run(*call).out
    document = answer(*call)
    given = document["inputs"]["first"]["velocity"]
    assert given["magnitude"] == {"value": 10, "unit": "mph"}
    again = answer("impact", "oblique", "--input", "-", stdin=json.dumps(document["inputs"]))
    assert again == document


def test_an_uncertain_vector_is_answered_with_its_interval() -> None:
    """20 ± 1 N at 30°: components 17.32 ± 0.87 N and 10 ± 0.5 N; an angle that rounding alone moves has no interval."""
    out = run("vec", "resultant", "20 ± 1 N @ 30 deg").out
    assert "resultant R     [17.32, 10.00] N      95 %: [15.62, 9.02] to [19.02, 10.98]" in out
    assert "angle from x    30 deg\n" in out
