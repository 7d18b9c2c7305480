"""Lists as people write them, taken apart into their items: commas or semicolons between, one unit at the end."""

from itertools import pairwise

from dynamics_cli.core.inputs.context import Token
from dynamics_cli.core.inputs.forms.splitting import split_list, unbracketed
from dynamics_cli.core.inputs.quantity_text import DIGITS, is_uncertain, number_end
from dynamics_cli.core.inputs.specification import Record
from dynamics_cli.errors import UsageError

FEET, INCHES = ("ft", "foot", "feet"), ("in", "inch", "inches")
# Digits between the separators of thousands.
GROUP = 3

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.inputs.context import Context
    from dynamics_cli.core.inputs.specification import Many


def items_of(node: "Many", value: "Any", address: str, context: "Context") -> "list[Any]":
    """The items of a list, however it is given; references to earlier documents and to tables are followed."""
    record = node.item if isinstance(node.item, Record) else None
    tables = value if isinstance(value, dict) and record is not None and "name" in record.names else {}
    if tables and all(isinstance(item, dict) and "name" not in item for item in tables.values()):
        # [surfaces.road] is an item with that name
        return [{"name": name, **item} for name, item in tables.items()]
    form = getattr(getattr(node.item, "kind", None), "form", "text")
    if form not in ("text", "file") and isinstance(value, str) and value[:1] == "@" and "," not in value:
        from dynamics_cli.core.inputs.sources.references import resolve

        value = resolve(value, context, address)
    items = split_items(node, value)
    if record is not None and any(isinstance(item, str) and item[:1] == "@" for item in items):
        from dynamics_cli.core.inputs.sources.item_tables import with_tables

        return with_tables(items, record, context, address)
    return items


def split_items(node: "Many", value: "Any") -> "list[Any]":
    """The items of a list given as JSON, as repeated options, or as one text with commas and a trailing unit."""
    if isinstance(value, list | tuple):
        return list(value)
    if isinstance(value, dict) and isinstance(value.get("value"), list):
        return [{**value, "value": item} for item in value["value"]]
    if isinstance(value, str) and not isinstance(value, Token):
        form = getattr(getattr(node.item, "kind", None), "form", "")
        text = value.strip()
        if ";" in text and form == "vector":
            return _vectors_in_rows(text)
        text = text[1:-1] if form == "vector" and text[:2] + text[-2:] == "[[]]" else text.replace(";", ",")
        items = split_list(text)
        if form == "vector" and not any(mark in text for mark in "()[]@"):
            # nine numbers in a row are three rows of three
            size = node.item.kind.size  # type: ignore[union-attr]
            rows = [", ".join(items[i : i + size]) for i in range(0, len(items), size)]
            return _vectors_in_rows("; ".join(rows))
        if form not in ("scalar", "slope"):
            return items
        # also `4 6 8 in`, and points as `0,0 20,1.5 40,4 ft`
        apart = [spaced_numbers(item) or [item] for item in items]
        for numbers in apart:
            _require_apart(numbers, " ")
        _require_apart(items, ",", two=False)
        items = share_unit([number for numbers in apart for number in numbers])
        for one, other in pairwise(items):
            _require_two(one, other)
        return items
    return [value]


def _vectors_in_rows(text: str) -> "list[str]":
    """Vectors with semicolons between them, `0, 0; 60, 0 mm`: the last one's unit holds for those without."""
    rows = [row.strip() if "," in row else ", ".join(row.split()) for row in text.rstrip("; ").split(";")]
    if not all(rows):
        raise UsageError(f"{text!r} has an empty row", code="syntax", hint="separate rows by single semicolons")
    unit = _unit_after(rows[-1].rpartition(",")[2].strip())
    return [row if not unit or _has_unit(row.rpartition(",")[2].strip()) else f"{row} {unit}" for row in rows]


def spaced_numbers(text: str) -> "list[str]":
    """Numbers with only spaces between them and at most one unit after the last, `0 1 0`, `3 4 0kN`; else nothing."""
    words = text.split()
    last = words[-1] if words else ""
    glued = number_end(last, 0) if last else 0
    if glued and last[glued:][:1].isalpha():
        words[-1:] = last[:glued], last[glued:]
    count = next((nth for nth, word in enumerate(words) if number_end(word, 0) < len(word)), len(words))
    if count < 2 or any(word[0] in f"{DIGITS},±+" for word in words[count:]):
        return []
    unit = " ".join(words[count:])
    return [f"{word} {unit}".rstrip() for word in words[:count]]


def _require_apart(items: "list[str]", mark: str, *, two: bool = True) -> None:
    """Refuse numbers that may be one with a mark between its thousands: `10 000`, `1,000` and, of `two`, `1 500`."""
    first, *later = (item[: number_end(item, 0)].lstrip("+-−") for item in items)
    begins = first.isdigit() and len(first) <= GROUP and first[0] != "0"
    if not (later and begins and all(number.isdigit() and len(number) == GROUP for number in later)):
        return
    if (two and len(later) == 1) or any(number[0] == "0" for number in later):
        message = f"{mark.join((first, *later))!r} may be one number or several"
        raise UsageError(message, code="ambiguous", hint="one number is written 1500, two are written 1, 500")


def _require_two(one: str, other: str) -> None:
    """Refuse `5 ft, 6 in` where it may be one value or two."""
    if _unit_after(one) in FEET and _unit_after(other) in INCHES:
        hint = f"for one value write {one} {other}; for two write both in one unit"
        raise UsageError(f"'{one}, {other}' may be one value or two", code="ambiguous", hint=hint)


def vector_items(text: str, *, lone: bool) -> "list[str]":
    """The components of a vector; `lone`: one number alone is read too, so that two must not look like one."""
    inner = unbracketed(text)
    spaced = spaced_numbers(inner)
    items = spaced or share_unit(split_list(inner))
    if lone and inner == text:
        if spaced or ", " not in text:
            _require_apart(items, " " if spaced else ",")
        if len(items) == 2:
            _require_two(*items)
    return items


def require_one(text: str) -> None:
    """Refuse several numbers where one is wanted: `60, 70 mph`, `60 70 mph`; 1,000 may be one, 5 ft, 6 in is one."""
    items = spaced_numbers(text)
    parts = [part.strip() for part in text.split(", " if ", " in text else ",")]
    grouped = ", " not in text and all(len(part) > 2 and part[:3].isdigit() for part in parts[1:])
    if not items and len(parts) > 1 and (", " in text or len(parts) > 2) and not grouped:
        items = parts if all(part and number_end(part, 0) == len(part) for part in parts[:-1]) else []
    if len(items) > 1:
        hint = "many values, one a line, are read by --rows -"
        raise UsageError(f"{text.strip()!r} is {len(items)} numbers, wanted one", code="several", hint=hint)


def share_unit(items: "list[str]") -> "list[str]":
    """Give the last item's unit to earlier ones without a unit: `1, 2, 3 m`; zeros take any: `1 m, 0, 0`."""
    items = [item.strip() for item in items]
    unit = _unit_after(items[-1]) if items else ""
    if unit:
        return [item if _has_unit(item) or item.endswith(unit) else f"{item} {unit}" for item in items]
    unit = next((_unit_after(item) for item in items if _has_unit(item)), "")
    return [f"{item} {unit}" if unit and not item.strip("+-0.") else item for item in items]


def _unit_after(text: str) -> str:
    if is_uncertain(text):
        from dynamics_cli.core.inputs.uncertain.vectors import trailing_unit

        return trailing_unit(text)
    unit = _after_number(text)
    # `5 ft 6 in` has no unit that a number before it could share
    return "" if any(word[0] in DIGITS for word in unit.split()) else unit


def _after_number(text: str) -> str:
    """What follows a number: `1/2` and `12 1/2` are numbers too."""
    rest = text[number_end(text, 0) :]
    over, slash, under = rest.partition("/")
    end = number_end(under, 0) if slash else 0
    fraction = end and (not over or (over[0].isspace() and over.strip().isdigit()))
    return (under[end:] if fraction else rest).strip()


def _has_unit(text: str) -> bool:
    if is_uncertain(text):
        from dynamics_cli.core.inputs.uncertain.vectors import has_unit

        return has_unit(text)
    return bool(_after_number(text))
