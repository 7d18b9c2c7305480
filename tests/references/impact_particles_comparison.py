"""Builds the impact tasks' inputs from reference cases, and measures answers against them."""

from collections.abc import Callable
from typing import Any

import numpy as np
from mpmath import mp, mpf
from references.comparison import Measured, build, leaves
from references.impact_particles_tasks import UNTRACKED

from dynamics_cli.accuracy.catalogue import groups
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.tracked import Tracked

GROUPS = groups("impact")


def flat(result: Any, prefix: str = "") -> dict[str, Any]:
    """Every number of a result by address; checks, advice, numerics, words and answers of yes or no are left out."""
    out: dict[str, Any] = {}
    for name in result.fields:
        value = getattr(result, name)
        if name not in ("checks", "advice", "numerics"):
            out |= _flat(value, prefix + name)
    return out


def _flat(value: Any, address: str) -> dict[str, Any]:
    if value is None or isinstance(value, (str, bool)) or str(getattr(value, "dtype", "")).startswith(("bool", "<U")):
        return {}
    if isinstance(value, tuple):
        return {key: one for i, row in enumerate(value) for key, one in _flat(row, f"{address}[{i}]").items()}
    if hasattr(value, "fields"):
        return flat(value, address + ".")
    return {address: value}


def answer(function: Callable[..., Any], tree: dict[str, Any], numbers: list[Any]) -> Any:
    """The function's answer."""
    return function(**build(tree, iter(numbers), GROUPS))


def measure(function: Callable[..., Any], case: dict[str, Any]) -> list[Measured]:
    """Every result of a case: the plain call must give the bits of the tracked one."""
    mp.dps = 60
    task, tree = case["task"], case["inputs"]
    numbers = list(leaves(tree))
    plain_answer = answer(function, tree, numbers)
    plain = flat(plain_answer)
    assert plain.keys() == case["results"].keys(), (case["name"], sorted(plain.keys() ^ case["results"].keys()))
    if task in UNTRACKED:
        stated = {bound.result: bound.bound for bound in plain_answer.numerics.bounds}
        tracked = {name: Tracked(value, abs(value) * stated.get(name, 0.0), (value,)) for name, value in plain.items()}
        numbers = [1.0]
    else:
        tracked = flat(answer(function, tree, Tracked.inputs(numbers)))
    found = []
    for name, text in case["results"].items():
        own = tracked[name]
        own = own if isinstance(own, Tracked) else Tracked(own, 0.0, (0.0,) * len(numbers))
        assert own.value == plain[name], (case["name"], name)
        reference = mpf(text)
        reach = sum(abs(slope * number) for slope, number in zip(own.slopes, numbers, strict=True))
        condition = reach / abs(own.value) if own.value else mp.inf
        error = abs(mpf(own.value) - reference)
        if name.endswith(("pdof", "heading")):
            # half a turn either way is the same direction
            error = min(error, abs(error - 2 * mp.pi))
        # the reference itself is rounded to 40 digits
        error = max(error - abs(reference) * mpf(10) ** -39, mpf(0))
        bound = mpf(own.error) if task not in UNTRACKED or name in stated else mp.inf
        found.append(Measured(f"{case['name']}: {name}", own.value, reference, error, bound, reach, condition))
    return found


def disagreements(function: Callable[..., Any], case: dict[str, Any], seed: int, count: int = 40) -> list[str]:
    """Rows where an array's answer is not the scalar's to the bit, over random rows about the given inputs."""
    tree = case["inputs"]
    generator = np.random.default_rng(seed)
    columns: list[Any] = []
    for number in leaves(tree):
        column = number * (1.0 + 0.2 * generator.uniform(-1.0, 1.0, count))
        column[0] = number
        columns.append(column if generator.random() < 0.6 else number)
    columns[0] = np.broadcast_to(columns[0], (count,))
    keep = np.arange(count)
    answers: dict[str, Any] = {}
    while keep.size:
        picked = [column[keep] if isinstance(column, np.ndarray) else column for column in columns]
        try:
            answers = flat(answer(function, tree, picked))
            break
        except InadmissibleError as error:
            if not isinstance(error.refused, np.ndarray):
                raise
            keep = keep[~np.broadcast_to(error.refused, keep.shape)]
    wrong = []
    for row in range(count):
        numbers = [float(column[row]) if isinstance(column, np.ndarray) else column for column in columns]
        try:
            single = flat(answer(function, tree, numbers))
        except InadmissibleError:
            if row in keep:
                wrong.append(f"row {row} was not refused")
            continue
        if row not in keep:
            wrong.append(f"row {row} was refused")
            continue
        place = int(np.searchsorted(keep, row))
        for name, value in answers.items():
            own = float(value[place]) if isinstance(value, np.ndarray) and value.ndim else float(value)
            if own.hex() != float(single[name]).hex() and not own == single[name] == 0.0:
                wrong.append(f"row {row}: {name} {own!r} is not {single[name]!r}")
    return wrong
