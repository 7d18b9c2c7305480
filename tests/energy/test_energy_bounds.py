"""Every tracked task against 40-digit references: its error, and the bound stated for it."""

from typing import Any

import pytest
from mpmath import mp, mpf
from references.comparison import DATA, HERE, build, cases, flat, leaves

from dynamics_cli.accuracy.catalogue import groups
from dynamics_cli.core.answering.tightening import tighten
from dynamics_cli.energy import body, drop, impulse, power, roll, speed, work
from dynamics_cli.numerics.tracked import Tracked

TASKS = {
    "work": work.work,
    "body": body.body,
    "speed": speed.speed,
    "drop": drop.drop,
    "roll": roll.roll,
    "power": power.power,
    "drive": power.drive,
    "impulse": impulse.impulse,
    "draw_in": impulse.draw_in,
}
FILE = "energy.json"
# Beside the bound itself, the reference is rounded to 40 digits and bounds near zero to the smallest double.
ROOM = mpf(10) ** -38
# A result that the inputs condition well is right to some last bits.
CLOSE, WELL_CONDITIONED = 2e-15, 10.0


@pytest.mark.parametrize("task", TASKS)
def test_errors_are_within_stated_bounds(task: str) -> None:
    mp.dps = 60
    seen = 0
    for case in cases(FILE, task):
        numbers = list(leaves(case["inputs"]))

        def call(given: Any, tree: Any = case["inputs"]) -> Any:
            return TASKS[task](**build(tree, iter(given), groups("energy")))  # type: ignore[operator]

        tracked = call(Tracked.inputs(numbers))
        tighten(tracked, numbers, call)
        plain, bounded = flat(call(numbers)), flat(tracked)
        for name, text in case["results"].items():
            reference = mpf(text)
            error = abs(mpf(plain[name]) - reference)
            held = bounded[name]
            assert held.value == plain[name], (case["name"], name)
            where = (case["name"], name, plain[name], text)
            assert error <= mpf(held.error) * (1 + ROOM) + ROOM * abs(reference), where
            reach = sum(abs(s * x) for s, x in zip(held.slopes, numbers, strict=True) if x)
            if reference and reach <= WELL_CONDITIONED * abs(float(reference)):
                assert error <= CLOSE * abs(reference), where
            seen += 1
    assert seen >= 8


def test_generating_again_gives_the_same_bytes(tmp_path: Any) -> None:
    import runpy

    made = tmp_path / FILE
    runpy.run_path(str(HERE / f"generate_{FILE.removesuffix('.json')}_references.py"))["main"](made)
    assert made.read_bytes() == (DATA / FILE).read_bytes()
