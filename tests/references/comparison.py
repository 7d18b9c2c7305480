"""Holds the program against the reference values: its error, the bound it states, and arrays beside scalars.

Reference files hold cases with inputs as trees: a leaf is a double as text, a group is a list, and a record of a union
is an object whose "record" names its class.
"""

import json
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from math import inf
from pathlib import Path
from typing import Any

import numpy as np
from mpmath import mp, mpf

from dynamics_cli.accuracy.cases import DATA, build, flat, leaves
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.tracked import Tracked

HERE = Path(__file__).resolve().parent
__all__ = ["DATA", "HERE", "build", "cases", "disagreements", "flat", "leaves", "measure"]
UNIT_ROUNDOFF = mpf(2) ** -53
SMALLEST = mpf(2) ** -1074
# A square root turns the smallest double into 2⁻⁵³⁷; exact zeros may carry that much.
UNDERFLOW = mpf(10) ** -150


@cache
def cases(file: str, task: str) -> list[dict[str, Any]]:
    """The cases of one task in a reference file."""
    data = json.loads((DATA / file).read_text(encoding="utf-8"))
    return [case for case in data["cases"] if case["task"] == task]


def spacing(reference: Any) -> Any:
    """The distance of doubles at a reference value."""
    if reference == 0:
        return SMALLEST
    return max(mpf(2) ** (mp.floor(mp.log(abs(reference), 2)) - 52), SMALLEST)


@dataclass
class Measured:
    """One result of one case beside its reference."""

    where: str
    value: float
    reference: Any
    error: Any
    bound: Any
    reach: float
    condition: float

    @property
    def ulps(self) -> float:
        return float(self.error / spacing(self.reference))

    @property
    def excess(self) -> float:
        """The bound over 100 × max(true error, 2⁻⁵³·|result|); what gradual underflow leaves is not counted."""
        room = 100 * max(self.error, UNIT_ROUNDOFF * abs(self.reference))
        if self.bound <= UNDERFLOW:
            return 0.0
        return float(self.bound / room) if room else inf

    @property
    def excess_by_inputs(self) -> float:
        """The bound over 100 × what one rounding of the inputs does to the result: the measure for a difference."""
        return float(self.bound / (100 * UNIT_ROUNDOFF * self.reach)) if self.reach else inf


def measure(function: Callable[..., Any], case: dict[str, Any], groups: dict[str, type]) -> list[Measured]:
    """Every result of a case: the plain call must give the bits of the tracked one."""
    mp.dps = 60
    numbers = list(leaves(case["inputs"]))
    plain = flat(function(**build(case["inputs"], iter(numbers), groups)))
    tracked = flat(function(**build(case["inputs"], iter(Tracked.inputs(numbers)), groups)))
    assert plain.keys() == tracked.keys() == case["results"].keys(), plain.keys() ^ case["results"].keys()
    found = []
    for name, text in case["results"].items():
        own = tracked[name]
        own = own if isinstance(own, Tracked) else Tracked(own, 0.0, (0.0,) * len(numbers))
        assert own.value == plain[name], (case["name"], name)
        reference = mpf(text)
        # an input of zero has no roundings, even where the slope by it has no bound
        terms = (abs(slope * number) for slope, number in zip(own.slopes, numbers, strict=True) if number)
        reach = sum(terms)
        condition = reach / abs(own.value) if own.value else inf
        error = abs(mpf(own.value) - reference)
        # the reference itself is rounded to 40 digits
        error = max(error - abs(reference) * mpf(10) ** -39, mpf(0))
        found.append(Measured(f"{case['name']}: {name}", own.value, reference, error, mpf(own.error), reach, condition))
    return found


def answer_rows(
    function: Callable[..., Any], tree: Any, columns: list[Any], groups: dict[str, type], count: int
) -> Any:
    """Answer many rows at once as the program does: refused rows are taken out and the rest asked again."""
    keep = np.arange(count)
    while keep.size:
        picked = [column[keep] if isinstance(column, np.ndarray) else column for column in columns]
        try:
            return keep, flat(function(**build(tree, iter(picked), groups)))
        except InadmissibleError as error:
            if not isinstance(error.refused, np.ndarray):
                raise
            keep = keep[~np.broadcast_to(error.refused, keep.shape)]
    return keep, {}


def disagreements(
    function: Callable[..., Any], tree: Any, groups: dict[str, type], seed: int, count: int = 60
) -> list[str]:
    """Rows where an array's answer is not the scalar's to the bit, over random rows about the given inputs."""
    generator = np.random.default_rng(seed)
    columns: list[Any] = []
    for number in leaves(tree):
        column = number * (1.0 + 0.3 * generator.uniform(-1.0, 1.0, count))
        column[0] = number
        if number <= 1.0:
            column[1] = 0.0
        columns.append(column if generator.random() < 0.6 else number)
    columns[0] = columns[0] if isinstance(columns[0], np.ndarray) else np.full(count, columns[0])
    kept, answers = answer_rows(function, tree, columns, groups, count)
    wrong = []
    for row in range(count):
        numbers = [float(column[row]) if isinstance(column, np.ndarray) else column for column in columns]
        try:
            single = flat(function(**build(tree, iter(numbers), groups)))
        except InadmissibleError:
            if row in kept:
                wrong.append(f"row {row} was not refused")
            continue
        place = int(np.searchsorted(kept, row))
        if place >= kept.size or kept[place] != row:
            wrong.append(f"row {row} was refused")
            continue
        for name, value in answers.items():
            own = float(value[place]) if isinstance(value, np.ndarray) and value.ndim else float(value)
            if own.hex() != float(single[name]).hex():
                wrong.append(f"row {row}: {name} {own!r} is not {single[name]!r}")
    return wrong
