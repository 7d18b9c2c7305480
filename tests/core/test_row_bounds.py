"""Rows and sweeps with the largest error bound of their results in a column of its own, and judgements in rows."""

import csv
import json
import math
from typing import Any

import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.core.batch.rows.bounds import largest_bound
from dynamics_cli.core.output.row_layout import Part


@pytest.mark.parametrize("form", ["csv", "ndjson"])
def test_rows_carry_their_largest_bound_when_asked(form: str) -> None:
    rows = "distance[ft],friction,grade\n60,0.7,-3 %\n0.001,0.01,-0.9999 %\n1,-1,0\n"
    made = run("skid", "speed", "--rows", "-", "--bounds", "--format", form, stdin=rows)
    assert made.status == 4
    if form == "csv":
        found = [float(cells["error_bound"] or "nan") for cells in csv.DictReader(made.out.splitlines())]
    else:
        lines = [json.loads(line).get("results", {}) for line in made.out.splitlines()]
        found = [line.get("error_bound", {"value": math.nan})["value"] for line in lines]
    assert math.isnan(found[2])
    cases = (("60", "0.7", "-3"), ("0.001", "0.01", "-0.9999"))
    for (distance, friction, grade), bound in zip(cases, found[:2], strict=True):
        argv = ("--distance", f"{distance} ft", "--friction", friction, "--grade", f"{grade} %")
        stated = answer("skid", "speed", *argv)["numerics"]["error_bound"]
        assert bound == max(stated[name]["relative"] for name in ("speed", "time", "total_distance"))


def test_bounds_of_exact_conversions_and_of_vectors_in_rows() -> None:
    made = run("convert", "--rows", "-", "--bounds", stdin='{"value": "60 mph", "targets": ["m"]}\n')
    assert made.status == 4
    made = run("convert", "ft/s", "--rows", "-", "--bounds", "--format", "ndjson", stdin="60 mph\n61 m/s\n")
    bounds = [json.loads(line)["results"]["error_bound"]["value"] for line in made.out.splitlines()]
    assert bounds == [0.0, pytest.approx(2.0**-53, rel=0.1)]
    assert run("convert", "60 mph", "ft/s", "--bounds").status == 2


def stated(document: dict[str, Any]) -> float | None:
    """The largest relative bound of a document's results outside of tables, read off its JSON alone."""
    relative = []
    for name, bound in document["numerics"]["error_bound"].items():
        address, *indices = name.replace("]", "").split("[")
        node: Any = document["results"]
        for key in address.split("."):
            node = node[key] if isinstance(node, dict) and key in node else None
        if not isinstance(node, dict):
            continue  # it stands in a table
        value = np.array(node["value"])[tuple(map(int, indices))]
        size = float(np.max(np.abs(value)))
        if "relative" in bound:
            relative.append(bound["relative"])
        elif size > bound["absolute"]:
            relative.append(bound["absolute"] / size)
    return max(relative)


@pytest.mark.parametrize(
    "argv",
    [
        pytest.param(["coords", "3", "1", "4", "--from", "cartesian", "--into", "spherical"], id="words"),
        pytest.param(["impact", "central", "--first-mass", "1 kg", "--first-velocity", "3 m/s", "--second-mass", "2 kg",
                      "--second-velocity", "0 m/s", "--restitution", "0.4"], id="records"),
        pytest.param(["impact", "oblique", "--first-mass", "2 kg", "--first-velocity", "3, 1 m/s", "--second-mass",
                      "3 kg", "--second-velocity", "-1, 0 m/s", "--normal", "10 deg", "--restitution", "0.5"],
                     id="vectors"),
        pytest.param(["inertia", "tensor", "--tensor", "[[2, -1e-9, 0.1], [-1e-9, 3, 0.5], [0.1, 0.5, 4]] kg*m^2"],
                     id="tensors"),
        pytest.param(["inertia", "shape", "cylinder", "--radius", "10 mm", "--length", "30 mm", "--mass", "1 kg"],
                     id="shapes"),
        pytest.param(["inertia", "section", "--polygon", "0, 0, 60, 0, 60, 40 mm"], id="sections"),
        pytest.param(["gear", "spur", "--teeth", "24", "--module", "2 mm"], id="gears"),
        pytest.param(["cam", "force", "--program", "rise 20 mm in 90 deg; dwell 90 deg; return in 180 deg",
                      "--shaft-speed", "300 rpm", "--mass", "2 kg", "--spring-rate", "5 N/mm", "--preload", "50 N"],
                     id="cams"),
    ],
)  # fmt: skip
def test_a_row_of_any_kind_carries_what_a_single_call_states(argv: list[str]) -> None:
    document = answer(*argv)
    family = [word for word in argv[:2] if not word[0].isdigit()]
    family = [*family, "cylinder"] if "cylinder" in argv else family
    row = json.dumps(document["inputs"])
    made = run(*family, "--rows", "-", "--bounds", "--format", "ndjson", stdin=row + "\n")
    assert made.status == 0, made.out + made.err
    assert json.loads(made.out)["results"]["error_bound"]["value"] == stated(document)


def test_sweeps_carry_bounds_too() -> None:
    made = answer(
        "skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--sweep", "friction=0.5:0.7:3", "--bounds"
    )
    last = answer("skid", "speed", "--distance", "60 ft", "--friction", "0.7")
    assert made["results"]["sweep"]["error_bound"]["value"][2] == stated(last)
    assert run("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--bounds").status == 2


NEAR_ONE_LINE = {
    "first.mass[kg]": "1500", "second.mass[kg]": "1300", "first.exit_speed[m/s]": "13", "first.exit_heading[deg]": "4",
    "second.exit_speed[m/s]": "12", "second.exit_heading[deg]": "4.5", "first.approach_heading[deg]": "0",
    "second.approach_heading[deg]": "9 ± 3",
}  # fmt: skip


@pytest.mark.parametrize("form", ["csv", "ndjson"])
def test_a_row_that_is_judged_says_what_its_uncertainty_leaves(form: str) -> None:
    table = f"{','.join(NEAR_ONE_LINE)}\n{','.join(NEAR_ONE_LINE.values())}\n"
    made = run("impact", "momentum", "--rows", "-", "--format", form, stdin=table)
    assert made.status == 4
    options = [word for name, value in NEAR_ONE_LINE.items() for word in _option(name, value)]
    single = run("impact", "momentum", *options, "--json").error["hint"].partition("; ")[0]
    assert "first.approach_speed is from" in single
    if form == "ndjson":
        assert json.loads(made.out)["error"]["hint"].startswith(single)
    else:
        assert next(csv.DictReader(made.out.splitlines()))["error"].endswith(single)


def test_a_point_of_a_sweep_that_is_judged_says_so_too() -> None:
    options = [word for name, value in NEAR_ONE_LINE.items() for word in _option(name, value)]
    made = json.loads(run("impact", "momentum", *options, "--sweep", "first-exit-speed=12.9:13 m/s:2", "--json").out)
    assert "first.approach_speed is from" in made["warnings"][0]["remedy"]


def _option(name: str, value: str) -> tuple[str, str]:
    address, _, unit = name.rstrip("]").partition("[")
    return "--" + address.replace(".", "-").replace("_", "-"), f"{value} {unit}"


def test_a_bound_in_inches_is_relative_to_all_of_the_feet_and_inches() -> None:
    """119 ft 0.001 in known to 1e-9 in is known to 7e-13, not to a share of the largest of its two numbers."""
    document = {
        "results": {"distance": {"value": [119, 0.001], "unit": "ft;in"}},
        "numerics": {"error_bound": {"distance": {"absolute": 1e-9, "unit": "in"}}},
    }
    parts = [Part(("distance",), ("distance",), "number")]
    assert largest_bound(document, parts) == pytest.approx(1e-9 / (119 * 12 + 0.001), rel=1e-12)
