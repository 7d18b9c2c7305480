"""How much the stated bounds of the shipped gear and skid cases exceed what they need be."""

import json
from collections.abc import Iterator
from statistics import median
from typing import Any

import pytest
import search_starts
from mpmath import mp, mpf
from references.comparison import SMALLEST, UNDERFLOW, UNIT_ROUNDOFF, cases, measure
from references.skid_tasks import GROUPS, TASKS

from dynamics_cli.accuracy.cases import DATA, build, flat, leaves
from dynamics_cli.numerics.tracked import Tracked

# Bound over max(error, 2⁻⁵³·|result|): what the issue of the bounds allows of every shipped case.
ROOM = 100.0


def looseness(own: Tracked, reference: Any) -> float:
    """The bound over what it need be; 0 where it is exact or all underflow."""
    error = abs(mpf(own.value) - reference)
    if own.error <= UNDERFLOW:
        return 0.0
    return float(own.error / max(error, UNIT_ROUNDOFF * abs(reference), SMALLEST))


def of_skid() -> Iterator[float]:
    for task, function in TASKS.items():
        for case in cases("skid.json", task):
            for one in measure(function, case, GROUPS):
                own = Tracked(one.value, float(one.bound), ())
                yield looseness(own, one.reference)


def of_gear() -> Iterator[float]:
    for case in json.loads((DATA / "gear_geometry.json").read_text(encoding="utf-8"))["cases"]:
        if case["task"] not in search_starts.GEAR:
            continue
        numbers = Tracked.inputs(list(leaves(case["inputs"])))
        choices = {name: search_starts.GEAR_CHOICES[name](value) for name, value in case["choices"].items()}
        arguments = build(case["inputs"], iter(numbers), search_starts.GEAR_RECORDS)
        answer = flat(search_starts.GEAR[case["task"]](**arguments, **choices))
        for name, text in case["results"].items():
            if isinstance(answer.get(name), Tracked) and not name.endswith(("_at_start", "_at_end")):
                yield looseness(answer[name], mpf(text))


# The share of results within the room: the others are differences that cancel (stops and touches to the last bit,
# tips that are nearly pointed, helices that nearly undo one another) where the roundings happened to cancel too.
@pytest.mark.parametrize(("measured", "share", "middle"), [(of_skid, 0.99, 6.0), (of_gear, 0.96, 15.0)])
def test_nearly_every_bound_is_within_a_hundred_times_the_error(measured: Any, share: float, middle: float) -> None:
    mp.dps = 60
    found = list(measured())
    assert len(found) > 500
    assert sum(one <= ROOM for one in found) >= share * len(found)
    assert median(found) <= middle
