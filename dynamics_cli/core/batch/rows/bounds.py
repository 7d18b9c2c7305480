"""`--bounds`: a column with the largest error bound of a row's results."""

from dynamics_cli.core.answering.models import answer
from dynamics_cli.core.output.document import build
from dynamics_cli.core.output.row_layout import Part
from dynamics_cli.core.units.compound import in_last_unit

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any

    from dynamics_cli.core.answering.task import Task
    from dynamics_cli.core.inputs.values import Fields
    from dynamics_cli.core.units.display import Display


class BoundPart(Part):
    """The largest error bound of a row's results, relative to them."""

    def __init__(self) -> None:
        super().__init__(("error_bound",), ("error_bound",), "number")

    def value(self, record: "Any") -> "Any":
        """Nothing: the record does not contain it; the case fills it in."""
        return None


def largest_bound(document: "dict[str, Any]", parts: "Sequence[Part]") -> float | None:
    """The largest error bound that a document states of these results, relative to them; None where one has none.

    A result not larger than its bound may be zero: a relative bound would mean nothing.
    """
    bounds = document["numerics"].get("error_bound", {})
    largest = None
    for name, steps in _places(parts):
        stated = bounds.get(name, {})
        if stated is None:
            return None
        node: Any = document["results"]
        for step in steps:
            node = _within(node, step)
        unit = _unit(document["results"], steps)
        # the bound of a result in parts, as of ft;in, is in the last of their units
        size = abs(in_last_unit(node, unit)) if ";" in unit and node else max(map(abs, _numbers(node)), default=0.0)
        if "absolute" in stated:
            bound = stated["absolute"] / size if size > stated["absolute"] else None
        else:
            bound = stated.get("relative")
        if bound is not None:
            largest = max(bound, largest or 0.0)
    return largest


def _places(parts: "Sequence[Part]") -> "Iterator[tuple[str, tuple[str | int, ...]]]":
    """Every result of a row by name, vectors as a whole and by component, with its path in a document."""
    names = set()
    for part in parts:
        full_name = ".".join(part.keys)
        if full_name not in names:
            names.add(full_name)
            yield full_name, (*part.keys, "value")
        indices = tuple(step for step in part.steps if isinstance(step, int))
        if indices and part.how == "number":
            yield full_name + "".join(f"[{index}]" for index in indices), (*part.keys, "value", *indices)


def _within(node: "Any", step: "str | int") -> "Any":
    if isinstance(step, int):
        return node[step] if isinstance(node, list) and step < len(node) else None
    return node.get(step) if isinstance(node, dict) else None


def _unit(results: "dict[str, Any]", steps: "tuple[str | int, ...]") -> str:
    node: Any = results
    for step in steps[: steps.index("value")]:
        node = _within(node, step)
    return str(node.get("unit") or "") if isinstance(node, dict) else ""


def _numbers(value: "Any") -> "Iterator[float]":
    if isinstance(value, list):
        for item in value:
            yield from _numbers(item)
    elif isinstance(value, float | int):
        yield value


def bound_of(task: "Task", bound: "Fields", model: str, display: "Display", parts: "Sequence[Part]") -> float | None:
    """The bound that a single call would state for the results of a row."""
    return largest_bound(build(task, bound, answer(task, bound, model), display, []), parts)
