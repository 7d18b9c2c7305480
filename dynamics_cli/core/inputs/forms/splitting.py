"""Text with commas: split into items, or into names and values, brackets and quotes kept whole."""

from dynamics_cli.core.inputs.quantity_text import number_end, shown
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection

OPENING, CLOSING = "([{", ")]}"
PAIRS = "example: distance=60 ft, friction=0.7"
PLACES = ("at", "from", "to")


def split_list(text: str) -> list[str]:
    """Split at the commas outside brackets and quotes; a quote opens only where an item or a value begins."""
    items, start, quote, before = [], 0, "", ","
    open_brackets = ""
    for position, character in enumerate(text):
        if quote:
            quote = "" if character == quote else quote
        elif character in "\"'" and before in ",=:([{":
            quote = character
        elif character in OPENING:
            open_brackets += CLOSING[OPENING.index(character)]
        elif character in CLOSING:
            if not open_brackets.endswith(character):
                raise UsageError(f"{shown(text)}: {character!r} has no opening bracket", code="syntax")
            open_brackets = open_brackets[:-1]
        elif character == "," and not open_brackets:
            items.append(text[start:position].strip())
            start = position + 1
        before = before if character.isspace() else character
    if quote or open_brackets:
        missing = quote or open_brackets[-1]
        raise UsageError(f"{shown(text)}: a closing {missing} is missing", code="syntax")
    items.append(text[start:].strip())
    if not all(items):
        raise UsageError(f"{shown(text)} has an empty item", code="syntax", hint="separate items by single commas")
    return items


def with_names(text: str, first: str, names: "Collection[str]") -> str:
    """`pin at 0, 0 m, name=A` as `type=pin, at=0, 0 m, name=A`: the first value, and places by their words.

    >>> with_names("200 N down at 2, 0 m", "force", ("force", "at"))
    'force=200 N down, at=2, 0 m'
    """
    lead, equals, tail = text.partition("=")
    for word in PLACES:
        before, found, place = lead.rpartition(f" {word} ")
        if found and word in names and f"{word}=" not in text.replace(" ", ""):
            lead = f"{before}, {word}={place}"
    text = lead + equals + tail
    lead, equals, _ = text.partition("=")
    # a word alone, or a value before the first name
    return f"{first}={text}" if ("," in lead if equals else " " not in text) else text


def split_pairs(text: str) -> dict[str, str]:
    """Split `force=3, 4 N, at=2, 0 m` into names and values; quotes around a whole value are taken off."""
    pairs: dict[str, str] = {}
    name = ""
    for item in (part for read in split_list(text) for part in _apart(read)):
        if name and "=" not in item and number_end(item, 0):  # a further component of the value before
            pairs[name] += f",{item}" if f",{item}" in text else f", {item}"
            continue
        name, equals, value = (part.strip() for part in item.partition("="))
        if not (equals and name and value):
            raise UsageError(f"read {shown(item)}, wanted NAME=VALUE", code="syntax", hint=PAIRS)
        if name in pairs:
            raise UsageError(f"{shown(name)} is given twice in {shown(text)}", code="syntax")
        quoted = len(value) > 1 and value[0] in "\"'" and value[-1] == value[0]
        pairs[name] = value[1:-1] if quoted else value
    return pairs


def _apart(item: str) -> list[str]:
    """Items between which a comma was forgotten: `over=4 length=12 mm`, `0 mm name=hole`."""
    name, _, value = item.partition("=")
    component, _, own_name = name.strip().rpartition(" ")
    if value and component and number_end(component, 0):
        return [component, *_apart(f"{own_name}={value}")]
    head, equals, tail = value.partition("=")
    own_value, _, next_name = head.strip().rpartition(" ")
    if not (equals and own_value and next_name.replace("-", "_").isidentifier()) or own_value[0] in "\"'" + OPENING:
        return [item]
    return [f"{name}={own_value}", *_apart(f"{next_name}={tail}")]


def unbracketed(text: str) -> str:
    """`1, 2, 3 m` of `(1, 2, 3) m` or `[1, 2, 3 m]`; brackets around the first component stay."""
    closing = {"(": ")", "[": "]"}.get(text[:1], "")
    if closing and text.count(text[0]) == text.count(closing) == 1:
        inner, _, unit = text[1:].partition(closing)
        return text if "," in unit else f"{inner} {unit}"
    text = text[1:-1] if text[:1] + text[-1:] == "[]" else text
    return text.removeprefix("(").removesuffix(")") if text.startswith("(") else text
