"""How a caller writes a parameter: `--first-mass` and `--segment no. 2`, or `first.mass` and `segments[1]`."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection, Mapping
    from typing import Any

    from dynamics_cli.core.inputs.options import Option


class Spelling:
    """Addresses as options, where a call gives its parameters by options; values in a file keep their addresses."""

    def __init__(self, options: "Mapping[str, Option]", typed: "Mapping[str, Any]", *, file: bool) -> None:
        self.options = options
        self.typed = typed
        self.file = file

    def __call__(self, address: str) -> str:
        """A parameter as the caller writes it; of one item among several, its number and then the field."""
        outer, opened, rest = address.partition("[")
        option = self._option(tuple(outer.split(".")))
        if option is None:
            return address
        if not opened:
            return f"--{option.name}"
        index, _, field = rest.partition("]")
        number = f" no. {int(index) + 1}" if self._several(option) else ""
        field = field.lstrip(".")
        return f"--{option.name}{number}" + (f": {field}" if field else "")

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
