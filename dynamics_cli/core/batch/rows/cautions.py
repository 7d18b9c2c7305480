"""What a user should know about some rows: the cautions of their answers, the first of each kind.

Answers by arrays carry none. The rows with the smallest and the largest number of each input are called singly for
them: a wrong unit, or a case near a limit, is among these.
"""

import numpy as np

from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.inputs.values import Bound

    Array = NDArray[Any]
    Cautions = dict[str, tuple[str, str]]

# Of the range seen so far: rows that extend it by less are not called singly again.
MUCH = 0.1


def note_cautions(found: "Cautions", record: "Any", bound: "Bound") -> bool:
    """Add a record's cautions, by code, to those found so far: message and remedy; whether one of them is serious."""
    serious = False
    for advice in _within(record):
        serious |= advice.severity == "serious"
        if advice.severity != "note" and advice.code not in found:
            from dynamics_cli.core.answering.messages import in_written_units

            found[advice.code] = in_written_units(advice.message, bound), in_written_units(advice.remedy or "", bound)
    return serious


def _within(node: "Any") -> "Iterator[Advice]":
    if isinstance(node, Advice):
        yield node
    elif isinstance(node, tuple | list):
        for item in node:
            yield from _within(item)
    elif hasattr(node, "fields"):
        for name in node.fields:
            yield from _within(getattr(node, name))


class Extremes:
    """The ranges of the inputs seen so far, and the rows that extend them much."""

    def __init__(self) -> None:
        self._ranges: dict[str, tuple[float, float]] = {}

    def rows(self, arrays: "Mapping[str, Array]") -> "list[int]":
        """The rows with the smallest and the largest numbers, where these are much beyond those before."""
        chosen: dict[int, None] = {}
        for name, array in arrays.items():
            low, high = int(np.argmin(array)), int(np.argmax(array))
            least, most = float(array[low]), float(array[high])
            before = self._ranges.get(name)
            if before is None:
                chosen |= {low: None, high: None}
                self._ranges[name] = least, most
                continue
            margin = MUCH * (before[1] - before[0])
            chosen |= {
                row: None for row, far in ((low, least < before[0] - margin), (high, most > before[1] + margin)) if far
            }
            self._ranges[name] = min(least, before[0]), max(most, before[1])
        return list(chosen)
