"""Distributions whose numbers are parts of compound units, as those of an earlier result in `ft;in`."""

from dynamics_cli.core.units.compound import listed_text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def without_parts(raw: "dict[str, Any]") -> "dict[str, Any]":
    """An object whose numbers are parts in compound units, with these as text: 5 ft 6.5 in."""
    unit = str(raw["unit"])

    def text(value: "Any") -> "Any":
        return listed_text(value, unit) if isinstance(value, list) else value

    texts = {key: [text(end) for end in value] if key == "interval" else text(value) for key, value in raw.items()}
    return {**texts, "unit": ""}
