"""The command `coords`: in which units a point comes out."""

import json
from math import ulp

import mpmath as mp
import pytest
from harness import answer, run

POINT = ("coords", "4 ft", "30 deg", "2 ft", "--from", "cylindrical", "--into", "spherical")


def test_coherent_units_where_they_are_asked_for() -> None:
    document = answer(*POINT, "--units", "base")
    with mp.workdps(40):
        exact = {"rho": mp.sqrt(20) * mp.mpf("0.3048"), "phi": mp.atan(2), "theta": mp.pi / 6}
    for name, unit in (("rho", "m"), ("phi", "rad"), ("theta", "rad")):
        found = document["results"][name]
        assert found["unit"] == unit
        stated = document["numerics"]["error_bound"][name]["relative"]
        assert abs(mp.mpf(found["value"]) - exact[name]) <= stated * exact[name]
        assert found["value"] == pytest.approx(float(exact[name]), abs=3 * ulp(1.0))


def test_other_systems_leave_the_units_of_the_inputs() -> None:
    for system in ("si", "us"):
        results = answer(*POINT, "--units", system)["results"]
        assert [results[name]["unit"] for name in ("rho", "phi", "theta")] == ["ft", "deg", "deg"]


def test_rows_have_the_units_that_are_asked_for() -> None:
    rows = '{"first": "4 ft", "second": "30 deg", "third": "2 ft"}\n'
    argv = ("coords", "--from", "cylindrical", "--into", "spherical", "--units", "base", "--rows", "-")
    made = json.loads(run(*argv, "--to", "theta=gon", stdin=rows).out)["results"]
    single = answer(*POINT, "--units", "base", "--to", "theta=gon")["results"]
    single.pop("convention")
    assert made == single
    assert run(*argv, "--to", "length=gon", stdin=rows).status == 2


def test_a_unit_named_by_the_caller_is_kept() -> None:
    assert answer("convert", "60 mph", "ft/s", "--units", "base")["results"]["value"] == {"value": 88.0, "unit": "ft/s"}


def test_a_plane_point_a_shared_unit_and_short_names() -> None:
    assert run("coords", "3", "4", "--from", "xyz", "--into", "polar", "--only", "r").out == "5\n"
    assert run("coords", "3", "4", "12 m", "--from", "cart", "--into", "sph", "--only", "rho").out == "13 m\n"
    outcome = run("coords", "3", "30 deg", "--from", "spherical", "--into", "cartesian")
    assert outcome.status == 2
    assert "theta is missing" in outcome.err
