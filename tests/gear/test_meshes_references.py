"""Meshes, unknown gears, data blocks and profiles against 40 digits: errors, bounds, and how tight these are."""

from typing import Any

import pytest
from mpmath import mp, mpf

from dynamics_cli.accuracy.alternatives.gear.own import data_block, mesh
from dynamics_cli.accuracy.cases import Case, build, flat, leaves, load
from dynamics_cli.core.answering.tightening import tighten
from dynamics_cli.gear.measure.identify import SpanRead, identify
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single.profile import profile
from dynamics_cli.numerics.tracked import Tracked

FILE = "gear_meshes.json"
CASES = load(FILE)
FUNCTIONS: dict[str, Any] = {"mesh": mesh, "identify": identify, "data_block": data_block, "profile": profile}
GROUPS = {"NormalModule": NormalModule, "SpanRead": SpanRead}
UNIT_ROUNDOFF = mpf(2) ** -53
ROOM = 100
# Differences are tied to the module, angles that are none to a radian.
OF_MODULE = ("backlash", "clearance", "_in_", "along", "base_pitch_error")


def answers(case: Case) -> dict[str, tuple[float, float]]:
    """Results and their absolute bounds by address; unknown gears in tracked numbers, whose bounds are carried."""
    numbers: list[Any] = list(leaves(case.inputs))

    def call(own: list[Any]) -> Any:
        return FUNCTIONS[case.task](**build(case.inputs, iter(own), GROUPS))

    answer = call(Tracked.inputs(numbers) if case.task == "identify" else numbers)
    values = answer if isinstance(answer, dict) else flat(answer)
    if case.task == "identify":
        tighten(answer, numbers, call)
        return {name: (own.value, own.error) for name, own in values.items() if isinstance(own, Tracked)}
    bounds = {
        one.result: one.bound * (abs(values[one.result]) if one.relative else 1.0) for one in answer.numerics.bounds
    }
    return {name: (values[name], bound) for name, bound in bounds.items()}


@pytest.mark.parametrize("case", CASES, ids=[case.name for case in CASES])
def test_errors_and_bounds(case: Case) -> None:
    mp.dps = 60
    found = answers(case)
    module = mpf(case.inputs["pitch"]["module"]) if "pitch" in case.inputs else mpf("1e-3")
    assert set(case.results) <= set(found)
    for name, text in case.results.items():
        value, bound = found[name]
        exact = mpf(text)
        error = max(abs(mpf(value) - exact) - abs(exact) * mpf(10) ** -39, mpf(0))
        assert error <= bound, (name, float(error), bound)
        size = 1 if "error" in name and case.task == "mesh" else abs(exact)
        size = max(size, module) if any(part in name for part in OF_MODULE) else size
        assert bound <= ROOM * max(error, UNIT_ROUNDOFF * size), name
        if case.task == "mesh":
            # lengths are differences of the gears' own, and ratios are lengths in pitches
            distance = mpf(max(found["centre_distance"][0], found["path.second_diameter[0]"][0]))
            assert error <= 32 * UNIT_ROUNDOFF * max(size, distance / module if "ratio" in name else distance), name
        if case.task == "profile":
            assert error <= 32 * UNIT_ROUNDOFF * size, name


@pytest.mark.parametrize("task", ["mesh", "identify", "data_block", "profile"])
def test_there_are_hard_cases_that_say_why(task: str) -> None:
    hard = [case for case in CASES if case.task == task and case.hard]
    assert len(hard) >= 10
    assert all(len(case.why) > 15 for case in hard)
