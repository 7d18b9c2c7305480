"""The picture of a sweep, drawn from its document."""

import math

from dynamics_cli.core.documents import flatten, number, quantity
from dynamics_cli.core.output.answer_words import body_names, in_words, label_in_words, with_name
from dynamics_cli.pictures import Axis, Curve, Panel, Picture

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.answering.task import Task

MOST_SWEPT = 6
# More panels than this are set in two columns.
MOST_IN_A_COLUMN = 3
# Number of fixed inputs that are named.
MOST_NAMED = 8
ROUNDING = 1e-12


def of_sweep(document: "dict[str, Any]", task: "Task") -> "Picture | None":
    """The varying headline results over the swept parameter; with two, a curve for each value of the second."""
    table: dict[str, Any] = document["results"]["sweep"]
    axes: list[str] = [axis["parameter"] for axis in document["inputs"]["sweep"]]
    # Words have no place on an axis: each has a curve of its own.
    axes.sort(key=lambda axis: isinstance(table[axis]["value"][0], str))
    if isinstance(table[axes[0]]["value"][0], str):
        return None
    names = [
        name
        for name in table
        if name not in axes and name.rpartition(".")[0] not in table and _numbers(table[name]["value"])
    ]
    swept = [table[axis]["value"] for axis in axes]
    changing = [name for name in names if not _constant(table[name]["value"]) and table[name]["value"] not in swept]
    bodies = body_names(document["inputs"])
    words_by_name = {name: with_name(label_in_words(task, name), bodies) for name, _ in task.headline}
    drawn_names = [name for name in words_by_name if name in changing] or changing or names
    panels = tuple(_swept(table, axes, name, words_by_name) for name in drawn_names[:MOST_SWEPT])
    return (
        Picture(panels, _title(document, axes), columns=2 if len(panels) > MOST_IN_A_COLUMN else 1) if panels else None
    )


def _title(document: "dict[str, Any]", axes: "list[str]") -> str:
    """The command and the inputs that stay as they are."""
    fixed = {name: node for name, node in document["inputs"].items() if name != "sweep"}
    inputs = [
        f"{name.replace('_', ' ').replace('.', ' ')} {quantity(value, unit, 6)}"
        for name, value, unit in flatten(fixed)
        if name not in axes
    ]
    more = f" and {len(inputs) - MOST_NAMED} more inputs" if len(inputs) > MOST_NAMED else ""
    return f"{document['command']}: {', '.join(inputs[:MOST_NAMED])}{more}" if inputs else str(document["command"])


def _constant(column: "list[Any]") -> bool:
    """Whether a result is constant apart from rounding."""
    numbers: list[float] = [value for value in column if value is not None]
    return max(numbers) - min(numbers) <= ROUNDING * max(abs(max(numbers)), abs(min(numbers)))


def _numbers(column: "list[Any]") -> bool:
    return all(value is None or isinstance(value, int | float) for value in column) and any(
        isinstance(value, float) for value in column
    )


def _swept(table: "dict[str, Any]", axes: "list[str]", name: str, words_by_name: "dict[str, str]") -> Panel:
    def titled(key: str) -> Axis:
        unit = table[key].get("unit", "")
        words = words_by_name.get(key) or in_words(key)
        return Axis(f"{words} [{unit}]" if unit else words)

    first = table[axes[0]]["value"]
    values = [math.nan if value is None else value for value in table[name]["value"]]
    if len(axes) == 1:
        items = [Curve(first, values, role=0)]
        for end in (f"{name}.low", f"{name}.high"):
            if end in table:
                ends = [math.nan if value is None else value for value in table[end]["value"]]
                items.append(Curve(first, ends, "" if end.endswith("high") else "ends of the interval", "dashed", 0))
        return Panel(titled(axes[0]), titled(name), tuple(items))
    second = table[axes[1]]
    curves = []
    for level in dict.fromkeys(second["value"]):
        rows = [index for index, value in enumerate(second["value"]) if value == level]
        label = f"{axes[1].replace('_', ' ')} = {number(level, 6)} {second.get('unit', '')}".rstrip()
        label = level if isinstance(level, str) else label
        curves.append(Curve([first[row] for row in rows], [values[row] for row in rows], label))
    return Panel(titled(axes[0]), titled(name), tuple(curves))
