"""Builds the particle tasks' inputs from reference cases, and measures answers against them."""

import json
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import numpy as np
from mpmath import mp, mpf
from references.comparison import HERE, Measured
from references.impact_particles_tasks import CLASSES, UNTRACKED

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.tracked import Tracked


@cache
def cases(task: str) -> list[dict[str, Any]]:
    """The reference cases of one task."""
    data = json.loads((HERE / "impact_particles.json").read_text(encoding="utf-8"))
    return [case for case in data["cases"] if case["task"] == task]


def leaves(tree: Any) -> Iterator[float]:
    """Every double of an input tree, in order."""
    if isinstance(tree, dict):
        for name, part in tree.items():
            if name not in ("record", "choice") and "choice" not in tree:
                yield from leaves(part)
    elif isinstance(tree, list):
        for part in tree:
            yield from leaves(part)
    elif isinstance(tree, str):
        yield float(tree)


PARTS = {
    "central": {"first": "Collinear", "second": "Struck"},
    "oblique": {"first": "Moving", "second": "Met"},
    "pendulum": {"block": "Block"},
    "momentum": {"first": "Vehicle", "second": "Vehicle"},
    "momentum_and_energy": {"first": "Vehicle", "second": "Vehicle"},
    "crush": {"first": "Damaged", "second": "Opponent"},
}


def build(task: str, tree: dict[str, Any], numbers: Iterator[Any]) -> dict[str, Any]:
    """The function's arguments, with `numbers` in place of the leaves."""
    return {name: _part(task, name, part, numbers) for name, part in tree.items()}


def _part(task: str, name: str, part: Any, numbers: Iterator[Any]) -> Any:
    if isinstance(part, str):
        return next(numbers)
    if isinstance(part, list):
        if part and isinstance(part[0], dict):
            return tuple(CLASSES["Body"](**build(task, item, numbers)) for item in part)
        return tuple(_part(task, name, item, numbers) for item in part)
    if not isinstance(part, dict):
        return part
    if "choice" in part:
        return CLASSES[part["choice"]](part["name"])
    record = part.get("record") or PARTS[task][name]
    inner = {key: value for key, value in part.items() if key != "record"}
    return CLASSES[record](**build(task, inner, numbers))


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


def answer(function: Callable[..., Any], task: str, tree: dict[str, Any], numbers: list[Any]) -> Any:
    """The function's answer."""
    return function(**build(task, tree, iter(numbers)))


def measure(function: Callable[..., Any], case: dict[str, Any]) -> list[Measured]:
    """Every result of a case: the plain call must give the bits of the tracked one."""
    mp.dps = 60
    task, tree = case["task"], case["inputs"]
    numbers = list(leaves(tree))
    plain_answer = answer(function, task, tree, numbers)
    plain = flat(plain_answer)
    assert plain.keys() == case["results"].keys(), (case["name"], sorted(plain.keys() ^ case["results"].keys()))
    if task in UNTRACKED:
        stated = {bound.result: bound.bound for bound in plain_answer.numerics.bounds}
        tracked = {name: Tracked(value, abs(value) * stated.get(name, 0.0), (value,)) for name, value in plain.items()}
        numbers = [1.0]
    else:
        tracked = flat(answer(function, task, tree, Tracked.inputs(numbers)))
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
    task, tree = case["task"], case["inputs"]
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
            answers = flat(answer(function, task, tree, picked))
            break
        except InadmissibleError as error:
            if not isinstance(error.refused, np.ndarray):
                raise
            keep = keep[~np.broadcast_to(error.refused, keep.shape)]
    wrong = []
    for row in range(count):
        numbers = [float(column[row]) if isinstance(column, np.ndarray) else column for column in columns]
        try:
            single = flat(answer(function, task, tree, numbers))
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
