"""Units in uncertain values: compound ones, as of an earlier result in `ft;in`, and shares, `80 kg ± 1 %`."""

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


def beside_share(unit: str) -> str:
    """The unit after a share: `kg` of `% kg`, as in 80 ± 1 % kg, which is 80 kg ± 1 %; of any other unit nothing."""
    after = unit.removeprefix("%").lstrip()
    return after if after != unit and after[:1].isalpha() else ""
