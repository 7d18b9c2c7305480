"""Smallest cams and lifts lost held against 40-digit solutions of another construction."""

import json

import pytest
from geometry_cases import NOTHING, follower_of
from mpmath import mp, mpf

from dynamics_cli.accuracy.cases import DATA
from dynamics_cli.cam.forces.check import check
from dynamics_cli.cam.geometry.followers import Flank, Rotation
from dynamics_cli.cam.sizing import records as asked
from dynamics_cli.cam.sizing import size

CASES = json.loads((DATA / "cam_design.json").read_text(encoding="utf-8"))["cases"]
CHECKS = [case for case in CASES if case["task"] == "check"]
SIZES = [case for case in CASES if case["task"] == "size"]


def held(made, results, scale) -> None:
    """Every result within its bound, and that bound within 1e-9."""
    mp.dps = 50
    bounds = {bound.result: bound for bound in made.numerics.bounds}
    for name, text in results.items():
        away, reference = abs(mpf(getattr(made, name)) - mpf(text)), abs(mpf(text))
        assert away <= mpf("1e-12") * scale, name
        if name in bounds:
            allowed = mpf(bounds[name].bound) * (reference if bounds[name].relative else 1)
            assert away <= allowed, name
            assert allowed <= mpf("1e-9") * scale, name


@pytest.mark.parametrize("case", CHECKS, ids=[case["name"] for case in CHECKS])
def test_the_lift_lost_at_a_corner(case) -> None:
    given = case["inputs"]
    follower = follower_of(given["follower"])
    made = check(NOTHING, program=given["program"], follower=follower, rotation=Rotation(given["rotation"]),
                 flank=Flank(given["flank"]))  # fmt: skip
    held(made, case["results"], mpf("0.01"))
    (name,) = case["results"]
    assert name in {bound.result for bound in made.numerics.bounds}


@pytest.mark.parametrize("case", SIZES, ids=[case["name"] for case in SIZES])
def test_the_smallest_cam(case) -> None:
    given, tree = case["inputs"], case["inputs"]["follower"]
    follower = getattr(asked, tree["record"])(**{k: float(v) for k, v in tree.items() if k != "record"})
    limits = {key: float(value) for key, value in given.items() if key.endswith(("_limit", "_radius"))}
    made = size.size(NOTHING, program=given["program"], follower=follower, **limits)
    held(made, case["results"], mpf(case["results"]["base_radius"]))
    assert all(one.passed for one in made.checks)
