"""How a caller writes a parameter: `--first-mass`, `--segment no. 2`, or `first.mass` and `segment 2 (segments[1])`."""

from dynamics_cli.core.documents import singular
from dynamics_cli.core.inputs.specification import Leaf, members_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection, Mapping
    from typing import Any

    from dynamics_cli.core.inputs.options import Option
    from dynamics_cli.core.inputs.specification import Node


class Spelling:
    """Addresses as options, where a call gives its parameters by options; items of a file by their names or numbers."""

    def __init__(
        self, options: "Mapping[str, Option]", typed: "Mapping[str, Any]", raw: "Mapping[str, Any]", *, file: bool
    ) -> None:
        self.options = options
        self.typed = typed
        self.raw = raw
        self.file = file

    def __call__(self, address: str) -> str:
        """A parameter as the caller writes it; of one item among several, its number and then the field."""
        outer, opened, rest = address.partition("[")
        option = self._option(tuple(outer.split(".")))
        if option is None:
            return self._in_file(address)
        if not opened:
            return f"--{option.name}"
        index, _, field = rest.partition("]")
        number = f" no. {int(index) + 1}" if self._several(option) else ""
        field = field.lstrip(".")
        return f"--{option.name}{number}" + (f": {field}" if field else "")

    def _in_file(self, address: str) -> str:
        """Items of lists by their names, else counted from one; other addresses as they are."""
        node: Any = self.raw
        words, path = [], ""
        for step in address.split("."):
            name, opened, index = step.rstrip("]").partition("[")
            path += f".{step}" if path else step
            node = node.get(name) if isinstance(node, dict) else None
            if not opened or not index.isdigit():
                continue
            node = node[int(index)] if isinstance(node, list) and int(index) < len(node) else None
            item_name = node.get("name") if isinstance(node, dict) else None
            place = f"{int(index) + 1} ({path})"
            words.append(f"{singular(path.rpartition('[')[0])} {repr(item_name) if item_name else place}")
            path = ""
        return ": ".join([", ".join(words), path] if path else [", ".join(words)]) if words else address

    def _option(self, path: "tuple[str, ...]") -> "Option | None":
        named = [option for option in self.options.values() if option.path == path]
        allowed: Collection[str] = self.typed if self.file else self.options
        return next((option for option in named if option.name in allowed), None)

    def _several(self, option: "Option") -> bool:
        typed_value = self.typed.get(option.name)
        return not option.repeats or (isinstance(typed_value, list) and len(typed_value) > 1)


def underscored(raw: "Mapping[str, Any]", known: "set[str]") -> "Mapping[str, Any]":
    """The names that a file writes as options do, `force-x`, as those of fields; others stay for the error."""
    names = {key: key.replace("-", "_") for key in raw if key not in known}
    return {name if (name := names.get(key, key)) in known and name not in raw else key: raw[key] for key in raw}


def written(node: "Node") -> str:
    """A record as an option takes it, `amount=12 g*mm, angle=30 deg`, of what it needs; empty without examples."""
    record = members_of(node)[0]
    tag = getattr(record.cls, "tag", None)
    pairs = [f"{tag[0]}={tag[1]}"] if tag else []
    for field in record.fields:
        if field.required and isinstance(field.node, Leaf):
            choice, kind = field.node.choice, field.node.kind
            other = choice.names[0] if choice else "NAME" if kind.form == "text" else kind.example
            value = field.example or other
            pairs += [f"{field.key}={value}"] if value else []
    more = [field.key for field in record.fields if not field.required]
    return ", ".join(pairs) + (f"; it takes {', '.join(more)} too" if len(pairs) == 1 and more else "")
