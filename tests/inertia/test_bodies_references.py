"""Shapes, assemblies, tensors and torques against 40-digit references: errors within bounds, bounds within reason."""

import json
from decimal import Decimal
from functools import cache
from typing import Any

import inertia_answers
import pytest
from inertia_answers import FUNCTIONS
from mpmath import mp, mpf, nstr

from dynamics_cli.accuracy.alternatives.inertia.bodies import scale
from dynamics_cli.accuracy.cases import flat, load
from dynamics_cli.numerics.tracked import Tracked

CASES = load("inertia_bodies.json")
UNIT_ROUNDOFF = mpf(2) ** -53


@cache
def measured(index: int) -> list[tuple[str, Any, Any, Any]]:
    """Address, reference, true error and stated bound of every result of a case."""
    mp.dps = 60
    case = CASES[index]
    function = FUNCTIONS[case.task]
    bare, tracked = flat(function(**inertia_answers.arguments(case))), flat(inertia_answers.bounded(case, function))
    if case.task == "compare":
        tracked = inertia_answers.both_stated(case)
    found = []
    for address, text in case.results.items():
        own, plain = tracked[address], bare[address]
        value = getattr(own, "value", own)
        assert value == getattr(plain, "value", plain), address
        reference = mpf(text)
        error = max(abs(mpf(value) - reference) - abs(reference) * mpf(10) ** -39, mpf(0))
        found.append((address, reference, error, mpf(own.error) if isinstance(own, Tracked) else mpf(0)))
    return found


EVERY = pytest.mark.parametrize("index", range(len(CASES)), ids=[f"{c.task} {c.name}" for c in CASES])


@EVERY
def test_every_bound_holds(index: int) -> None:
    wrong = [(a, float(error), float(bound)) for a, _, error, bound in measured(index) if error > bound]
    assert wrong == []


@EVERY
def test_no_bound_is_more_than_a_hundred_times_the_error_or_a_rounding(index: int) -> None:
    """Measured by the number, or by the largest of its kind where it may pass through zero."""
    rows = measured(index)
    sizes = {address: Decimal(nstr(abs(reference), 45)) for address, reference, _, _ in rows}
    for address, _, error, bound in rows:
        if address == "axes_angle":
            # worst cases of both bodies over the gaps of their moments, which errors that differ in sign stay far below
            continue
        size = mpf(str(scale(address, sizes)))
        if CASES[index].name.startswith(("ball less ball", "points on a line")):
            # a difference of large numbers: what rounding the inputs alone does to it
            size = max(size, max(error * 2**53 for _, _, error, _ in rows), mpf(1))
        if CASES[index].task in ("body", "compare"):
            # a sum over n parts is n roundings, each of the running total
            size *= max(1, json.dumps(CASES[index].inputs).count('"amount"') / 4)
        assert bound <= 100 * max(error, UNIT_ROUNDOFF * size), (address, float(bound), float(error))


def test_there_are_enough_hard_cases_and_every_shape() -> None:
    from dynamics_cli.inertia.shapes import Shape

    assert sum(case.hard for case in CASES) >= 20
    assert all(case.why for case in CASES if case.hard)
    named = {case.inputs["shape"]["record"] for case in CASES if case.task == "shape"}
    assert named == {cls.__name__ for cls in Shape.__args__}  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("start", "address", "limit"),
    [
        ("needle 1e6 turned", "principal_moments", 2e-15),
        ("plate 1e6 turned", "principal_moments", 2e-15),
        ("two needles", "principal_moments", 2e-15),
        ("assembly at", "principal_moments", 2e-15),
        ("assembly at", "moments", 2e-15),
    ],
)
def test_hard_bodies_keep_their_digits(start: str, address: str, limit: float) -> None:
    chosen = [i for i, case in enumerate(CASES) if case.name.startswith(start)]
    assert chosen
    for index in chosen:
        for name, reference, error, _ in measured(index):
            if name.startswith(address):
                assert error <= limit * abs(reference), (CASES[index].name, name, float(error / abs(reference)))


def test_thin_walls_are_good_to_5e_16() -> None:
    chosen = [i for i, case in enumerate(CASES) if ", wall 1e" in case.name and case.task == "shape"]
    assert len(chosen) >= 24
    worst = max(
        (float(error / abs(reference)), CASES[index].name, name)
        for index in chosen
        for name, reference, error, _ in measured(index)
        if reference
    )
    assert worst[0] <= 5e-16, worst
