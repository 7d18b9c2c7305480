"""Every path task against 40-digit references: its error, and the bound stated for it."""

import math
from typing import Any

import pytest
from mpmath import mp, mpf
from references.comparison import build, cases, flat, leaves

from dynamics_cli.accuracy.catalogue import groups
from dynamics_cli.core.answering.tightening import tighten
from dynamics_cli.numerics.orientation.moving_frame import moving_frame
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.path import circle, components, coordinates
from dynamics_cli.path.curves import task as curve
from dynamics_cli.path.relative import task as relative
from dynamics_cli.path.straight import task as straight

TASKS = {
    "rectilinear": straight.rectilinear,
    "rectilinear_law": straight.rectilinear_law,
    "circle": circle.circle,
    "polar": coordinates.polar,
    "cylindrical": coordinates.cylindrical,
    "spherical": coordinates.spherical,
    "components": components.components,
    "curve": curve.curve,
    "relative": relative.relative,
    "moving_frame": moving_frame,
}
# Beside the bound itself, the reference is rounded to 40 digits and bounds near zero to the smallest double.
ROOM = mpf(10) ** -38
# A result that the inputs condition well is right to some last bits.
ULPS, WELL_CONDITIONED = 16.0, 10.0


def answered(task: str, case: dict[str, Any]) -> tuple[Any, Any]:
    """The plain answer, and the tracked one, its bounds tightened as in a call."""
    numbers = list(leaves(case["inputs"]))

    def call(given: Any) -> Any:
        return TASKS[task](**build(case["inputs"], iter(given), groups("path")))

    tracked = call(Tracked.inputs(numbers))
    tighten(tracked, numbers, call)
    return call(numbers), tracked


@pytest.mark.parametrize("task", TASKS)
def test_errors_are_within_stated_bounds(task: str) -> None:
    mp.dps = 60
    seen = 0
    for case in cases("path.json", task):
        plain, tracked = answered(task, case)
        values, numbers = flat(plain), flat(tracked)
        numerics = getattr(tracked, "numerics", None)
        stated = {bound.result: bound.bound for bound in numerics.bounds} if numerics is not None else {}
        for name, text in case["results"].items():
            reference = mpf(text)
            error = abs(mpf(values[name]) - reference)
            bound = getattr(numbers[name], "error", stated.get(name, 0.0))
            assert getattr(numbers[name], "value", numbers[name]) == values[name], (case["name"], name)
            assert error <= mpf(bound) * (1 + ROOM) + ROOM * abs(reference), (case["name"], name, values[name], text)
            slopes = getattr(numbers[name], "slopes", ())
            reach = sum(abs(s * x) for s, x in zip(slopes, leaves(case["inputs"]), strict=False) if x)
            if reference and reach <= WELL_CONDITIONED * abs(float(reference)):
                assert error <= ULPS * math.ulp(float(reference)), (case["name"], name, values[name], text)
            seen += 1
        assert all(check.passed for check in getattr(plain, "checks", ())), case["name"]
    assert seen >= 10


def test_hard_cases_are_named_with_their_reason() -> None:
    hard = [case for task in TASKS for case in cases("path.json", task) if case["kind"] == "hard"]
    assert len(hard) >= 12
    assert all(case["why"] for case in hard)
