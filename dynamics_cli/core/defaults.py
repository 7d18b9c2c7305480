"""`[units]` at the top of a scene: default units for bare numbers, by the kind's name."""

from dynamics_cli import quantities
from dynamics_cli.core.units import conformable, parse_unit
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Kind

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any


def default_units(given: "Mapping[str, Any]") -> "dict[str, str]":
    """The default unit text by a kind's SI unit; refuses unknown kinds and units that do not fit them."""
    kinds = {
        kind.name.replace(" ", "_"): kind for kind in vars(quantities).values() if isinstance(kind, Kind) and kind.unit
    }
    made: dict[str, str] = {}
    for name, text in given.items():
        kind = kinds.get(name)
        address = f"units.{name}"
        if kind is None:
            hint = f"kinds are {', '.join(sorted(kinds))}"
            raise UsageError(f"there is no kind of quantity {name!r}", parameter=address, hint=hint)
        if not isinstance(text, str):
            raise UsageError(f"read {text!r}, wanted a unit", parameter=address, hint=f"for example {kind.si!r}")
        wanted = parse_unit(kind.unit)
        if not conformable(parse_unit(text, wanted), wanted):
            raise UsageError(
                f"{text!r} is not a unit of {kind.name}", parameter=address, hint=f"for example {kind.si!r}"
            )
        made[kind.unit] = text
    return made
