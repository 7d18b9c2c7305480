"""`--bounds`: a column with the largest error bound of a row's results."""

from dynamics_cli.core.answering.models import answer
from dynamics_cli.core.output.document import build
from dynamics_cli.core.output.row_layout import Part

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
        """Nothing: the record does not hold it; the case fills it in."""
        return None


def largest_bound(document: "dict[str, Any]", parts: "Sequence[Part]") -> float | None:
    """The largest error bound that a document states of these results, relative to them; None where one has none."""
    largest = None
    for keys in dict.fromkeys(part.keys for part in parts):
        stated = document["numerics"].get("error_bound", {}).get(".".join(keys), {})
        if stated is None:
            return None
        node: Any = document["results"]
        for key in keys:
            node = node.get(key) if isinstance(node, dict) else None
        size = max(map(abs, _numbers(node.get("value"))), default=0.0) if isinstance(node, dict) else 0.0
        bound = stated["absolute"] / size if "absolute" in stated and size else stated.get("relative")
        if bound is not None:
            largest = max(bound, largest or 0.0)
    return largest


def _numbers(value: "Any") -> "Iterator[float]":
    if isinstance(value, list):
        for item in value:
            yield from _numbers(item)
    elif value is not None:
        yield value


def bound_of(task: "Task", bound: "Fields", asked: str, display: "Display", parts: "Sequence[Part]") -> float | None:
    """What a single call would state of the results that a row shows."""
    return largest_bound(build(task, bound, answer(task, bound, asked), display, []), parts)
