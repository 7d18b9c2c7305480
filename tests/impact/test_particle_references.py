"""Particles and planar impacts against 40-digit references: errors, stated bounds, arrays, checks, derivatives."""

from functools import cache
from typing import Any

import pytest
from references.comparison import Measured, leaves
from references.comparison import cases as read
from references.impact_particles_comparison import answer, disagreements, flat, measure
from references.impact_particles_tasks import CASE_BY_CASE, TASKS, UNTRACKED

from dynamics_cli.impact.planar.impact import planar
from dynamics_cli.numerics.tracked import Tracked

FILE = "impact_particles.json"
TRACKED = [task for task in TASKS if task not in UNTRACKED]
# A result that a small relative change of the inputs changes no more than this many times as much.
WELL_CONDITIONED = 10.0
# Results after an impact are a difference of what was before and what the impulse made: a few roundings of each.
MOST_ULPS = 8.0
# The running bound adds what may cancel: it may exceed 100 × the error of a lucky result a little.
ROOM = 2.0


FUNCTIONS = {**TASKS, "planar": planar}
MEASURED = [*TRACKED, "planar"]


def cases(task: str) -> list[dict[str, Any]]:
    return read("impact_rigid.json" if task == "planar" else FILE, task)


@cache
def measured(task: str) -> list[tuple[bool, Measured]]:
    """Every result of every case beside its reference, and whether search found the case."""
    return [(found(case), one) for case in cases(task) for one in measure(FUNCTIONS[task], case)]


def cancels(one: Measured) -> bool:
    """Spins after a jam are the fiftieth part of the two moments whose difference they are."""
    return one.where.startswith("jam") and "spin" in one.where


def test_there_are_enough_hard_cases() -> None:
    every = [case for task in TASKS for case in cases(task)]
    hard = [case for case in every if case["kind"] == "hard"]
    assert len(every) >= 180
    assert len(hard) >= 60
    assert all(case["why"] for case in hard)


@pytest.mark.parametrize("task", MEASURED)
def test_errors_are_a_few_ulps_where_well_conditioned(task: str) -> None:
    every = [one for by_search, one in measured(task) if task == "planar" or not by_search]
    judged = [one for one in every if one.condition <= WELL_CONDITIONED and one.reference != 0 and not cancels(one)]
    assert len(judged) > len(every) / 2
    worst = max(judged, key=lambda one: one.ulps)
    assert worst.ulps <= (2.0 if task == "planar" else 1.0) * MOST_ULPS, worst


def found(case: dict[str, Any]) -> bool:
    """Whether search found it."""
    return case.get("why", "").startswith("found by search")


@pytest.mark.parametrize("task", TRACKED)
def test_the_worst_that_search_found_is_a_few_roundings_of_the_inputs(task: str) -> None:
    worst = [one for by_search, one in measured(task) if by_search]
    assert worst
    for one in worst:
        assert one.ulps <= 6.0 * max(one.condition, 1.0), one


def test_chains_are_right_to_a_few_roundings_of_the_fastest_body() -> None:
    for case in cases("chain"):
        results = measure(TASKS["chain"], case)
        speeds = [abs(float(body.get("velocity", "0"))) for body in case["inputs"]["bodies"]]
        hits = next(one.value for one in results if one.where.endswith("collisions"))
        for one in results:
            if one.where.endswith(".velocity"):
                assert one.error <= (4.0 + 2.0 * hits) * 2.0**-52 * max(speeds), one


@pytest.mark.parametrize("task", FUNCTIONS)
def test_stated_bound_holds_and_is_tight(task: str) -> None:
    for _, one in measured(task):
        assert one.error <= one.bound, one
        if one.value == 0.0 or task in UNTRACKED or cancels(one):
            continue
        if one.condition <= WELL_CONDITIONED and task != "planar":
            assert one.excess <= ROOM, one
        else:
            assert min(one.excess, one.excess_by_inputs) <= ROOM, one


@pytest.mark.parametrize("task", [task for task in FUNCTIONS if task not in CASE_BY_CASE])
def test_arrays_give_the_bits_of_scalars(task: str) -> None:
    for seed, case in enumerate(cases(task)[:16]):
        assert not disagreements(FUNCTIONS[task], case, seed), case["name"]


@pytest.mark.parametrize("task", FUNCTIONS)
def test_checks_pass_and_name_themselves(task: str) -> None:
    named = set()
    for case in cases(task):
        result = answer(FUNCTIONS[task], case["inputs"], list(leaves(case["inputs"])))
        assert all(check.passed for check in result.checks), (case["name"], result.checks)
        named |= {check.name for check in result.checks}
    assert len(named) >= (15 if task == "planar" else 1)


@pytest.mark.parametrize("task", MEASURED)
def test_derivatives_are_those_of_the_answer(task: str) -> None:
    for case in cases(task)[:5]:
        tree = case["inputs"]
        numbers = list(leaves(tree))
        tracked = flat(answer(FUNCTIONS[task], tree, Tracked.inputs(numbers)))
        for index, number in enumerate(numbers):
            step = 1e-6 * max(abs(number), 1e-2)
            ends = []
            for side in (-step, step):
                moved = [value + side if i == index else value for i, value in enumerate(numbers)]
                ends.append(flat(answer(FUNCTIONS[task], tree, moved)))
            for name, value in tracked.items():
                body, _, which = name.partition(".")
                turns = name.endswith("pdof") and abs(ends[1][name]) > 3.1
                if name.endswith("clock") or turns or (which in ("heading", "speed") and at_rest(ends, body)):
                    # hours are whole, half a turn is written either way, and a body at rest has no direction
                    continue
                slope = value.slopes[index] if isinstance(value, Tracked) else 0.0
                estimate = (ends[1][name] - ends[0][name]) / (2.0 * step)
                size = abs(ends[1][name]) / max(abs(number), 1e-2) + abs(slope)
                room = 5e-6 * size + (1e-7 if task == "planar" else 1e-9)
                assert slope == pytest.approx(estimate, abs=room), (case["name"], name, index)


def at_rest(ends: list[dict[str, float]], name: str) -> bool:
    """Whether a body hardly moves afterwards."""
    return max(abs(end.get(f"{name}.velocity[{axis}]", 1.0)) for end in ends for axis in (0, 1)) < 1e-3
