"""`[units]` at the top of a scene: default units for bare numbers, by the kind's name."""

from dynamics_cli import quantities
from dynamics_cli.core.inputs.context import Token
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.core.units.unit import conformable
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Kind

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any


def default_units(unit_texts: "Mapping[str, Any]") -> "dict[str, str]":
    """The default unit by kind name.

    A kind that is not named takes the unit of the only named kind with the same dimension. Refuses unknown kinds, units
    that do not fit, and a kind with two candidates.
    """
    kinds: dict[str, list[Kind]] = {}
    for kind in vars(quantities).values():
        if isinstance(kind, Kind) and kind.unit:
            kinds.setdefault(kind.name, []).append(kind)
    units: dict[str, str] = {}
    by_unit: dict[str, set[str]] = {}
    for name, text in unit_texts.items():
        key = name.replace("_", " ")
        _check(name, text, kinds.get(key, []), sorted(kinds))
        units[key] = text
        by_unit.setdefault(kinds[key][0].unit, set()).add(text)
    for key, members in kinds.items():
        texts = by_unit.get(members[0].unit, set())
        if key not in units and len(texts) == 1:
            units[key] = next(iter(texts))
    return units


def _check(name: str, text: "Any", kinds: "list[Kind]", known: "list[str]") -> None:
    address = f"units.{name}"
    if not kinds:
        hint = f"kinds are {', '.join(other.replace(' ', '_') for other in known)}"
        raise UsageError(f"there is no kind of quantity {name!r}", parameter=address, hint=hint)
    if not isinstance(text, str) or isinstance(text, Token):
        raise UsageError(f"read {text!r}, wanted a unit", parameter=address, hint=f"for example {kinds[0].si!r}")
    base_unit = parse_unit(kinds[0].unit)
    try:
        unit = parse_unit(text, base_unit)
    except UsageError as error:
        error.parameter = address
        raise
    if not conformable(unit, base_unit):
        raise UsageError(
            f"{text!r} is not a unit of {kinds[0].name}", parameter=address, hint=f"for example {kinds[0].si!r}"
        )
