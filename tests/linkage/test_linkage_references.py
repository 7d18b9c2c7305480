"""Every closed-form task of linkages against 40-digit references: error, stated bound, arrays beside scalars."""

from collections.abc import Callable
from functools import partial
from typing import Any

import pytest
from references.comparison import cases, disagreements, flat
from references.linkage_tasks import GROUPS, TASKS

from dynamics_cli.accuracy.cases import build, leaves
from dynamics_cli.core.answering.tightening import tighten
from dynamics_cli.numerics.tracked import Tracked

FILE = "linkage.json"
# A bound may exceed the error this many times, or what one rounding of the inputs does.
LOOSE = 100.0
UNIT = 2.0**-53
# References have 40 digits.
DIGITS = 1e-39
# What gradual underflow leaves in the bound of an exact zero.
UNDERFLOW = 1e-150


def asked(case: dict[str, Any]) -> Callable[..., Any]:
    return partial(TASKS[case["task"]], **case.get("choices", {}))


@pytest.mark.parametrize("task", TASKS)
def test_error_is_within_the_bound_and_the_bound_is_tight(task: str) -> None:
    from mpmath import mp, mpf

    mp.dps = 50
    for case in cases(FILE, task):
        numbers = list(leaves(case["inputs"]))

        def call(values: Any, case: dict[str, Any] = case) -> Any:
            return asked(case)(**build(case["inputs"], iter(values), GROUPS))

        plain = flat(call(numbers))
        record = call(Tracked.inputs(numbers))
        tighten(record, numbers, call)
        tracked = flat(record)
        assert plain.keys() == tracked.keys() == case["results"].keys(), case["name"]
        for name, text in case["results"].items():
            own, reference = tracked[name], mpf(text)
            own = own if isinstance(own, Tracked) else Tracked(float(own), 0.0, (0.0,) * len(numbers))
            assert own.value == plain[name], (case["name"], name)
            error = abs(mpf(own.value) - reference) - DIGITS * abs(reference)
            assert error <= own.error, (case["name"], name, float(error), own.error)
            reach = sum(abs(slope * number) for slope, number in zip(own.slopes, numbers, strict=True) if number)
            room = LOOSE * max(error, UNIT * abs(reference), UNIT * reach)
            assert own.error <= room + UNDERFLOW, (case["name"], name, own.error, float(error))


@pytest.mark.parametrize("task", ["four_bar", "slider_crank", "quick_return"])
def test_arrays_give_the_bits_of_scalars(task: str) -> None:
    for seed, case in enumerate(cases(FILE, task)[:8]):
        assert not disagreements(asked(case), case["inputs"], GROUPS, seed)
