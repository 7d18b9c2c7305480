"""Tracked tasks of families of closed forms against 40-digit references: errors, and the bounds stated for them."""

from collections.abc import Callable
from typing import Any

import pytest
from mpmath import mp, mpf
from references.comparison import build, cases, flat, leaves

from dynamics_cli.accuracy.catalogue import groups
from dynamics_cli.core.answering.tightening import tighten
from dynamics_cli.energy import body, drop, impulse, power, roll, speed, work
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.particle import fall, incline, projectile, rotating_frame, tube
from dynamics_cli.pendulum import compound, conical, simple
from dynamics_cli.spin import disk, free, gyro, rod, shaft, top

TASKS: dict[str, tuple[Callable[..., Any], ...]] = {
    "energy": (
        work.work, body.body, speed.speed, drop.drop, roll.roll, power.power, power.drive, impulse.impulse,
        impulse.draw_in,
    ),
    "particle": (
        projectile.projectile, fall.fall, tube.tube, tube.hoop, incline.incline, incline.circle,
        rotating_frame.rotating_frame,
    ),
    "pendulum": (simple.simple, compound.compound, compound.rod, conical.conical),
    "spin": (gyro.gyro, free.free, top.top, shaft.shaft, rod.rod, disk.disk),
}  # fmt: skip
# Beside the bound itself, the reference is rounded to 40 digits and bounds near zero to the smallest double.
ROOM = mpf(10) ** -38
# A result that the inputs condition well is right to some last bits.
CLOSE, WELL_CONDITIONED = 2e-15, 10.0


@pytest.mark.parametrize(
    ("family", "task"),
    [pytest.param(family, task, id=f"{family} {task.__name__}") for family in TASKS for task in TASKS[family]],
)
def test_errors_are_within_stated_bounds(family: str, task: Callable[..., Any]) -> None:
    mp.dps = 60
    seen = 0
    for case in cases(f"{family}.json", task.__name__):
        numbers = list(leaves(case["inputs"]))

        def call(given: Any, tree: Any = case["inputs"]) -> Any:
            return task(**build(tree, iter(given), groups(family)))

        tracked = call(Tracked.inputs(numbers))
        tighten(tracked, numbers, call)
        plain, bounded = flat(call(numbers)), flat(tracked)
        for name, text in case["results"].items():
            reference = mpf(text)
            error = abs(mpf(plain[name]) - reference)
            held = bounded[name]
            where = (case["name"], name, plain[name], text)
            assert held.value == plain[name], where
            assert error <= mpf(held.error) * (1 + ROOM) + ROOM * abs(reference), where
            reach = sum(abs(slope * x) for slope, x in zip(held.slopes, numbers, strict=True) if x)
            if reference and reach <= WELL_CONDITIONED * abs(float(reference)):
                assert error <= CLOSE * abs(reference), where
            seen += 1
    assert seen >= 8
