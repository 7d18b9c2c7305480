"""`[points]` at the top of a scene: coordinates by name, for wherever the scene wants a point."""

from dynamics_cli.core.inputs.quantity_text import is_uncertain
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any


def any_named(points: "Mapping[str, Any]", raw: "Any") -> bool:
    """Whether some text of the raw input names one of the points."""
    if isinstance(raw, dict | list):
        return any(any_named(points, value) for value in (raw.values() if isinstance(raw, dict) else raw))
    return isinstance(raw, str) and any(word in points for word in raw.split())


def coordinates(text: str, points: "Mapping[str, Any]") -> "Any":
    """The coordinates of a point that is named, or the text itself."""
    name = text.strip()
    if name not in points:
        if any(character.isdigit() for character in text):
            return text
        raise UsageError(f"there is no point {name!r}", code="unknown-point", hint=f"points are {', '.join(points)}")
    place = points[name]
    numbers = place if isinstance(place, list) else [place]
    # each use would vary by itself
    if any(isinstance(number, dict) or (isinstance(number, str) and is_uncertain(number)) for number in numbers):
        message = f"point {name} is uncertain, and a point of [points] is exact"
        raise UsageError(message, code="uncertain", hint="write uncertain coordinates where they are used")
    return place
