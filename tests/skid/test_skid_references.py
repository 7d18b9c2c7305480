"""Every skid task against 40-digit references: its error, the bound stated for it, arrays and checks."""

import math

import pytest
from references.comparison import build, cases, disagreements, flat, leaves, measure
from references.skid_tasks import GROUPS, TASKS

from dynamics_cli.numerics.tracked import Tracked

# A result that a small relative change of the inputs changes no more than this many times as much.
WELL_CONDITIONED = 10.0
MOST_ULPS = 4.0
# Both sides of a square root's corner lie within the bound: nothing but exact arithmetic can tell a stop from a touch,
# or equal test skids from unequal ones.
CORNERS = {
    "equal test skids",
    "mark 64.0 of a stop of 64",
    "found loosest, avoid with {'speed': 17.854275884045748}",
}


@pytest.mark.parametrize("task", TASKS)
def test_errors_are_at_most_four_ulps_where_well_conditioned(task: str) -> None:
    measured = [one for case in cases("skid.json", task) for one in measure(TASKS[task], case, GROUPS)]
    judged = [
        one for one in measured if one.condition <= WELL_CONDITIONED and one.where.rpartition(": ")[0] not in CORNERS
    ]
    assert len(judged) > len(measured) / 2
    worst = max(judged, key=lambda one: one.ulps)
    assert worst.ulps <= MOST_ULPS, worst


@pytest.mark.parametrize("task", TASKS)
def test_stated_bound_holds_and_is_tight(task: str) -> None:
    for case in cases("skid.json", task):
        for one in measure(TASKS[task], case, GROUPS):
            assert one.error <= one.bound, one
            if case["name"] in CORNERS:
                continue
            if one.condition <= WELL_CONDITIONED:
                assert one.excess <= 1.0, one
            else:
                assert min(one.excess, one.excess_by_inputs) <= 1.0, one


@pytest.mark.parametrize("task", TASKS)
def test_arrays_give_the_bits_of_scalars(task: str) -> None:
    for seed, case in enumerate(cases("skid.json", task)[:20]):
        assert not disagreements(TASKS[task], case["inputs"], GROUPS, seed)


@pytest.mark.parametrize("task", TASKS)
def test_checks_pass(task: str) -> None:
    named = set()
    for case in cases("skid.json", task):
        result = TASKS[task](**build(case["inputs"], leaves(case["inputs"]), GROUPS))
        assert all(check.passed for check in result.checks), (case["name"], result.checks)
        named |= {check.name for check in result.checks}
    assert named


@pytest.mark.parametrize("task", TASKS)
def test_tracking_a_few_inputs_gives_the_same_bits(task: str) -> None:
    case = cases("skid.json", task)[0]
    numbers = list(leaves(case["inputs"]))
    plain = flat(TASKS[task](**build(case["inputs"], iter(numbers), GROUPS)))
    for index in range(len(numbers)):
        mixed = [Tracked(number, 0.0, (1.0,)) if i == index else number for i, number in enumerate(numbers)]
        answer = flat(TASKS[task](**build(case["inputs"], iter(mixed), GROUPS)))
        assert {name: getattr(value, "value", value) for name, value in answer.items()} == plain


@pytest.mark.parametrize("task", TASKS)
def test_derivatives_are_those_of_the_answer(task: str) -> None:
    for case in cases("skid.json", task)[:6]:
        numbers = list(leaves(case["inputs"]))
        tracked = flat(TASKS[task](**build(case["inputs"], iter(Tracked.inputs(numbers)), GROUPS)))
        for index, number in enumerate(numbers):
            step = 1e-6 * max(abs(number), 1e-2)
            ends = []
            for side in (-step, step):
                moved = [value + side if i == index else value for i, value in enumerate(numbers)]
                ends.append(flat(TASKS[task](**build(case["inputs"], iter(moved), GROUPS))))
            for name, value in tracked.items():
                slope = value.slopes[index] if isinstance(value, Tracked) else 0.0
                if not math.isfinite(slope):
                    # behind the corner of a square root, which is a zero of this same answer
                    assert 0.0 in [getattr(other, "value", other) for other in tracked.values()]
                    continue
                estimate = (ends[1][name] - ends[0][name]) / (2.0 * step)
                size = abs(ends[1][name]) / max(abs(number), 1e-2) + abs(slope)
                assert slope == pytest.approx(estimate, abs=2e-6 * size + 1e-12), (case["name"], name, index)
