"""Every bound of sizes and of lost lifts, on every reference case shipped: never below the error, and within a hundred
times it, or half a last bit of the size that errors are measured in. Those of other tasks: tests/accuracy.
"""

import json
from functools import cache
from typing import Any

import pytest
from geometry_cases import NOTHING, follower_of
from mpmath import mp, mpf

from dynamics_cli.accuracy.cases import DATA
from dynamics_cli.cam.forces.check import check
from dynamics_cli.cam.geometry.followers import Flank, Rotation
from dynamics_cli.cam.sizing import records, size

HALF_ULP = mpf(2) ** -53
LOOSE = 100


@cache
def cases(file: str, task: str) -> tuple[dict[str, Any], ...]:
    found = json.loads((DATA / file).read_text(encoding="utf-8"))["cases"]
    return tuple(case for case in found if case["task"] == task)


def every(file: str, task: str) -> Any:
    found = cases(file, task)
    return pytest.mark.parametrize("case", found, ids=[case["name"] for case in found])


def held(value: float, text: str, bound: float, scale: float) -> None:
    """The bound is true, and tight in a size."""
    with mp.workdps(60):
        error = abs(mpf(float(value)) - mpf(text))
        # the reference has 40 digits
        assert error <= mpf(float(bound)) + abs(mpf(text)) * mpf(10) ** -39, (float(error), bound)
        assert mpf(float(bound)) <= LOOSE * max(error, HALF_ULP * abs(mpf(scale))), (float(error), bound, scale)


def stated(answer: Any) -> dict[str, float]:
    """Absolute bounds by address."""
    found = {}
    for one in answer.numerics.bounds:
        value = getattr(answer, one.result, 1.0)
        found[one.result] = one.bound * abs(value) if one.relative else one.bound
    return found


def sizes() -> list[dict[str, Any]]:
    return [*cases("cam_geometry.json", "size"), *cases("cam_design.json", "size")]


@pytest.mark.parametrize("case", sizes(), ids=[case["name"] for case in sizes()])
def test_sizes(case: dict[str, Any]) -> None:
    inputs, tree, results = case["inputs"], case["inputs"]["follower"], case["results"]
    follower = getattr(records, tree["record"])(**{key: float(text) for key, text in tree.items() if key != "record"})
    limits = {key: float(text) for key, text in inputs.items() if key.endswith(("_limit", "_radius"))}
    answer = size.size(NOTHING, program=inputs["program"], follower=follower, **limits)
    scale = abs(float(results.get("start_radius", results["base_radius"])))
    held(answer.base_radius, results["base_radius"], stated(answer)["base_radius"], scale)


@every("cam_design.json", "check")
def test_lift_lost(case: dict[str, Any]) -> None:
    inputs, follower = case["inputs"], follower_of(case["inputs"]["follower"])
    answer = check(
        NOTHING,
        program=inputs["program"],
        follower=follower,
        rotation=Rotation(inputs["rotation"]),
        flank=Flank(inputs["flank"]),
    )
    for name, text in case["results"].items():
        # the difference of a lift and of a place on the cam is told in shares of the cam, or of a swing of a radian
        cam = follower.base_radius + getattr(follower, "roller_radius", 0.0)
        held(getattr(answer, name), text, stated(answer)[name], max(cam, abs(float(text))))
