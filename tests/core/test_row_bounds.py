"""Rows with the largest error bound of their results in a column of its own."""

import csv
import json
import math

import pytest
from harness import answer, run


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
