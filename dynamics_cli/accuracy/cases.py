"""Reference cases: inputs as doubles in text, results to 40 digits, each with its kind and why it is hard.

An input tree's leaves are doubles as text, vectors and groups are lists, a record is an object whose "record" names its
class (in a group it need not), and {"word": "edge"} is a word, given as it is.
"""

import json
from functools import cache
from importlib.resources import files

from dynamics_cli.records import Quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

DATA = files(__package__) / "data"


class Case:
    """One reference case."""

    def __init__(self, raw: "Mapping[str, Any]") -> None:
        self.task: str = raw["task"]
        self.kind: str = raw["kind"]
        self.name: str = raw["name"]
        self.why: str = raw.get("why", "")
        self.inputs: Any = raw["inputs"]
        # words, given to the methods as they are
        self.choices: Any = raw.get("choices", {})
        self.results: dict[str, str] = raw["results"]

    @property
    def hard(self) -> bool:
        """Whether it was chosen for being difficult."""
        return self.kind != "ordinary"


@cache
def load(file: str) -> "tuple[Case, ...]":
    """Every case of a file of references."""
    data = json.loads((DATA / file).read_text(encoding="utf-8"))
    return tuple(Case(raw) for raw in data["cases"])


def leaves(tree: "Any") -> "Iterator[float]":
    """Every double of an input tree, in order."""
    if isinstance(tree, dict):
        for name, part in tree.items():
            if name not in ("record", "word"):
                yield from leaves(part)
    elif isinstance(tree, list):
        for part in tree:
            yield from leaves(part)
    elif isinstance(tree, str):
        yield float(tree)


def build(tree: "Any", numbers: "Iterator[Any]", groups: "Mapping[str, type]") -> "Any":
    """The function's arguments, with `numbers` in place of the leaves; `groups` gives the class of a group's items."""
    return {name: _part(name, part, numbers, groups) for name, part in tree.items()}


def _part(name: str, part: "Any", numbers: "Iterator[Any]", groups: "Mapping[str, type]") -> "Any":
    if isinstance(part, str):
        return next(numbers)
    if isinstance(part, list):
        return tuple(_part(name, item, numbers, groups) for item in part)
    if not isinstance(part, dict):
        return part
    if "word" in part:
        return part["word"]
    inner = {key: value for key, value in part.items() if key != "record"}
    return groups[part.get("record", name)](**build(inner, numbers, groups))


def flat(result: "Any", prefix: str = "") -> "dict[str, Any]":
    """Every number of a result by address; checks, advice, words and answers of yes or no are left out."""
    out: dict[str, Any] = {}
    for name in result.fields:
        value = getattr(result, name)
        value = value.value if isinstance(value, Quantity) else value
        address = prefix + name
        if name in ("checks", "advice", "numerics") or value is None or isinstance(value, str | bool):
            continue
        if isinstance(value, tuple):
            for index, row in enumerate(value):
                out |= flat(row, f"{address}[{index}].") if hasattr(row, "fields") else {f"{address}[{index}]": row}
        elif hasattr(value, "fields"):
            out |= flat(value, f"{address}.")
        elif str(getattr(value, "dtype", "")) != "bool":
            out[address] = value
    return out
