"""Uncertain vectors: each component a distribution, or magnitude and direction.

Written `3 ± 0.1, 0 m/s` or `30 ± 2 mph @ 45 ± 3 deg`. Components have the addresses `velocity[0]`, the others
`velocity.magnitude` and `velocity.direction`.
"""

from dynamics_cli.core.inputs.quantity_text import number_end
from dynamics_cli.core.inputs.uncertain.parts import beside_share
from dynamics_cli.core.inputs.uncertain.values import PLUS_MINUS, UncertainValue
from dynamics_cli.core.inputs.values import Value, VectorValue
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.quantities import Kind

# Entries of an earlier result about its components, in addition to their values.
_LISTS = ("mean", "median", "std")


class UncertainVector(VectorValue):
    """A vector of which some components have distributions; its nominal value has their means."""

    def __init__(
        self, address: str, kind: "Kind", si: "tuple[Any, ...]", shown: "Any", unit: str, parts: "Sequence[Value]"
    ) -> None:
        super().__init__(address, kind, si, shown, unit)
        self._parts = parts

    def echo(self) -> "Any":
        """The JSON form, which reads back: nominal value, unit, and the distribution of every uncertain component."""
        echoes = [part.echo() if isinstance(part, UncertainValue) else None for part in self._parts]
        return {**super().echo(), "distributions": echoes}


def component_items(raw: "dict[str, Any]", size: int) -> "list[Any]":
    """The components of an object with `value`, each an object with its part of the distribution."""
    unit = {"unit": raw["unit"]} if raw.get("unit") else {}
    items: list[dict[str, Any]] = [{"value": value, **unit} for value in raw["value"]]
    stated = {key: raw[key] for key in ("distributions", *_LISTS) if raw.get(key) is not None}
    ends = raw.get("interval") or []
    if not isinstance(ends, list):
        raise UsageError("an interval has two ends, each with all components", code="components")
    for key, listed in (*stated.items(), *(("interval", end) for end in ends)):
        if not isinstance(listed, list) or len(listed) != len(items) or len(items) != size:
            message = f"{key} has not as many components as value, which has {len(items)}; wanted {size} of each"
            raise UsageError(message, code="components")
    if ends and len(ends) != 2:
        raise UsageError("an interval has two ends, each with all components", code="components")
    for place, item in enumerate(items):
        component = stated.get("distributions", [None] * size)[place]
        if component is not None:
            items[place] = component
            continue
        interval = [end[place] for end in ends]
        # A component that does not vary has an interval of zero width.
        if interval and _same(*interval):
            continue
        item |= {key: stated[key][place] for key in _LISTS if key in stated}
        if interval:
            item |= {"interval": interval, "coverage": raw.get("coverage")}
    return items


def _same(low: "Any", high: "Any") -> bool:
    """Whether two bare numbers, as text or not, are equal."""
    try:
        return float(low) == float(high)
    except (TypeError, ValueError):
        return False


def trailing_unit(text: str) -> str:
    """The unit of an uncertain value as written, if any: `m/s` of `3 ± 0.1 m/s` and of `3 m/s ± 1 %`."""
    units = _units(text)
    unit = beside_share(units[-1]) or units[-1]
    return next((earlier for earlier in reversed(units) if earlier not in ("", "%")), unit) if unit == "%" else unit


def has_unit(text: str) -> bool:
    """Whether some number of an uncertain value as written has a unit, other than a share at its end."""
    return any(unit not in ("", "%") for unit in _units(text))


def _units(text: str) -> "list[str]":
    """The text after every number, and after a closing bracket."""
    _, opened, inside = text.partition("(") if not text.lstrip().startswith("[") else text.partition("[")
    body, closed, after = inside.rpartition(")" if "(" in text else "]") if opened else (text, "", "")
    for sign in (*PLUS_MINUS, ".."):
        body = body.replace(sign, ",")
    parts = [part.strip() for part in body.split(",")]
    units = [part[number_end(part, 0) :].strip() if part else "" for part in parts]
    return [*units, after.strip()] if closed else units
