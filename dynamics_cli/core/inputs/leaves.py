"""One leaf of the input, from text or JSON to a parsed value, read as its kind requires."""

from dynamics_cli.core.inputs.context import Token
from dynamics_cli.core.inputs.quantity_text import (
    FRACTIONS,
    is_uncertain,
    parts_of,
    read_amount,
    read_fraction,
    read_scalar,
    total,
)
from dynamics_cli.core.inputs.values import Bound, Constant, Exact, PolarVector, TypedPolar, Value, VectorValue
from dynamics_cli.core.units.conversion import nearest
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Count, Kind
from dynamics_cli.records import ExactQuantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.core.inputs.context import Context
    from dynamics_cli.core.inputs.specification import Leaf

# Spellings of a flag where only text is possible: a table cell, a value of `name=value, …`.
FLAGS = {"true": True, "yes": True, "1": True, "false": False, "no": False, "0": False}
# With more than these a misspelt choice is answered by the nearest ones alone.
MANY_CHOICES = 8


def read_leaf(leaf: "Leaf", raw: "Any", address: str, context: "Context") -> Bound:
    """Parse one leaf; raises UsageError, whose parameter the caller fills in."""
    if leaf.kind.form not in ("text", "file"):
        raw = _resolved(raw, address, context)
    if leaf.choice is not None:
        return _choice(leaf, raw)
    if context.points and isinstance(raw, str) and leaf.kind.form == "vector" and leaf.kind.unit == "m":
        from dynamics_cli.core.inputs.sources.named_points import coordinates

        raw = coordinates(raw, context.points)
    reader = _FORMS.get(leaf.kind.form, _scalar)
    return reader(leaf.kind, raw, address, context)


def _resolved(raw: "Any", address: str, context: "Context") -> "Any":
    if not isinstance(raw, str) or not raw.startswith("@"):
        return raw
    from dynamics_cli.core.inputs.sources.references import resolve

    return resolve(raw, context, address)


def _text_of(kind: Kind, raw: "Any") -> str:
    """A scalar's text, from text, a bare number or a value–unit pair."""
    if isinstance(raw, bool):
        raise UsageError(f"read {str(raw).lower()}, wanted {_wanted(kind)}", hint=f"for example {kind.example!r}")
    if isinstance(raw, dict):
        unknown = sorted(set(raw) - _PAIR_KEYS)
        if "value" not in raw or unknown:
            raise UsageError(
                f"read an object with {', '.join(raw) or 'nothing'}, wanted value and unit",
                hint=f'for example {{"value": 60, "unit": "{kind.unit}"}}',
            )
        if raw["value"] is None:
            raise UsageError("read null: the earlier calculation has no such result", code="no-value")
        if isinstance(raw["value"], list) and ";" in str(raw.get("unit")):
            from dynamics_cli.core.units.compound import listed_text

            return listed_text(raw["value"], str(raw["unit"]))
        unit = str(raw.get("unit") or "")
        if isinstance(raw["value"], dict) or (unit.startswith(_JOINING) and not unit.startswith("1/")):
            raise UsageError(f"read {_brief(raw)}, wanted a number and its unit")
        return f"{_text_of(kind, raw['value'])} {raw.get('unit') or ''}".strip()
    if isinstance(raw, int | float):
        return repr(raw)
    if not isinstance(raw, str):
        raise UsageError(f"read {_brief(raw)}, wanted {_wanted(kind)}", hint=f"for example {kind.example!r}")
    return raw


# A unit begins with none of these, which the number before it would join: 10 and `½ ft`.
_JOINING = (*"^0123456789", *FRACTIONS)
# Further keys that a result of an earlier document may have beside value and unit.
_PAIR_KEYS = {"value", "unit", "symbol", "mean", "median", "std", "interval", "coverage"}


def _wanted(kind: Kind) -> str:
    return f"{kind.about or kind.name}, in {kind.unit}" if kind.unit else (kind.about or kind.name)


def _brief(raw: object) -> str:
    text = repr(raw)
    return text if len(text) <= 60 else text[:57] + "…"


def _default_unit(kind: Kind, raw: "Any", context: "Context") -> str:
    """The scene's unit for a bare number; text on the command line must name its unit."""
    unquoted = all(isinstance(number, Token | list) for number in (raw if isinstance(raw, list) else [raw]))
    return context.default_unit(kind) if unquoted else ""


def _scalar(kind: Kind, raw: "Any", address: str, context: "Context") -> Value:
    return read_number_of(kind, raw, address, context, _default_unit(kind, raw, context))


def read_number_of(kind: Kind, raw: "Any", address: str, context: "Context", default_unit: str) -> Value:
    """A number or, where allowed, a distribution."""
    if isinstance(raw, list | dict) and context.uncertain is not None and _is_distribution(raw) and not kind.certain:
        return _uncertain(kind, raw, address, context, default_unit)
    text = _text_of(kind, raw)
    if kind.compass and (text[:1].isalpha() or " of " in text):
        from dynamics_cli.core.inputs.forms.compass import in_degrees

        text = in_degrees(text, context)
    try:
        reading = read_scalar(text, kind, default_unit)
    except UsageError as error:
        if error.code != "uncertain" or context.uncertain is None or kind.certain:
            raise
        return _uncertain(kind, text, address, context, default_unit)
    context.note(address, reading.notes)
    return Value(address, kind, reading.si or 0.0, reading.value, reading.unit, reading.parts)


def _is_distribution(raw: "Any") -> bool:
    """Whether JSON is repeated readings, names a distribution, or has a standard uncertainty or an interval."""
    if isinstance(raw, list):
        return len(raw) > 1
    return any(raw.get(key) is not None for key in ("distribution", "std", "interval"))


def _uncertain(kind: Kind, raw: "Any", address: str, context: "Context", default_unit: str) -> Value:
    from dynamics_cli.core.inputs.uncertain.values import read_uncertain

    bound, notes = read_uncertain(kind, raw, address, default_unit)
    context.note(address, notes)
    assert context.uncertain is not None
    context.uncertain[address] = bound.distribution
    return bound


def _whole(kind: Kind, raw: "Any", address: str, context: "Context") -> Bound:
    reading = read_scalar(_text_of(kind, raw), kind)
    return Constant(int(reading.si), {"value": reading.value})


def _range(kind: Kind, raw: "Any", address: str, context: "Context") -> Bound:
    ends = raw if isinstance(raw, list) else _text_of(kind, raw).split("..")
    if len(ends) != 2:
        raise UsageError(f"read {_brief(raw)}, wanted {kind.about}", code="range", hint=f"for example {kind.example}")
    first, last = (int(read_scalar(_text_of(kind, end).strip(), Count).si) for end in ends)  # type: ignore[arg-type]
    if first > last:
        raise UsageError(
            f"read {first}..{last}, which ends below its start", code="range", hint=f"for example {last}..{first}"
        )
    return Constant((first, last), f"{first}..{last}")


def _flag(kind: Kind, raw: "Any", address: str, context: "Context") -> Bound:
    value = FLAGS.get(raw.strip().lower()) if isinstance(raw, str) and not isinstance(raw, Token) else raw
    if not isinstance(value, bool):
        raise UsageError(f"read {_brief(raw)}, wanted true or false")
    return Constant(value, value)


def _text(kind: Kind, raw: "Any", address: str, context: "Context") -> Bound:
    if not isinstance(raw, str) or isinstance(raw, Token):
        raise UsageError(f"read {_brief(raw)}, wanted {kind.about or 'text'}")
    if any(ord(character) < 32 or ord(character) == 127 for character in raw):
        raise UsageError(f"read {raw!r}, which has control characters; wanted {kind.about or 'text'}")
    return Constant(str(raw), str(raw))


def _file(kind: Kind, raw: "Any", address: str, context: "Context") -> Bound:
    import os

    from dynamics_cli.core.inputs.sources.hashes import entry_of_file

    name = _text(kind, raw, address, context).echo()
    path = os.path.join(context.folder, name)
    if not os.path.exists(path) and os.path.exists(name):
        path = name  # a document may stand elsewhere than its command was called
    if not os.path.exists(path):
        raise UsageError(
            f"there is no file {name!r}",
            code="no-file",
            hint="names in a scene are relative to the scene, or to the current folder",
        )
    if not os.path.isfile(path):
        reason = "is a directory" if os.path.isdir(path) else "is a pipe or a device, which cannot be read twice"
        raise UsageError(f"{name!r} {reason}", code="no-file", hint="give a file")
    try:
        context.files.append(entry_of_file(path))
    except OSError as error:
        raise UsageError(f"cannot read {name!r}: {error.strerror or error}", code="unreadable") from None
    return Constant(path, name)


def _choice(leaf: "Leaf", raw: "Any") -> Bound:
    assert leaf.choice is not None
    names = leaf.choice.names
    if not isinstance(raw, str):
        raise UsageError(f"read {_brief(raw)}, wanted one of {', '.join(names)}")
    try:
        chosen = leaf.choice(raw)
    except ValueError:
        from dynamics_cli.core.units.near_names import nearest_words

        # two spellings of one choice are one suggestion
        near = list(
            dict.fromkeys(str(leaf.choice(name)) for name in nearest_words(raw, (*names, *leaf.choice.aliases)))
        )
        hint = f"did you mean {' or '.join(near)}?" if near else None
        message = f"read {_brief(raw)}, wanted one of {', '.join(names)}"
        if hint and len(names) > MANY_CHOICES:
            message, hint = f"{_brief(raw)} is not one of the {len(names)} choices", f"{hint} --help lists all"
        raise UsageError(message, code="unknown-choice", hint=hint) from None
    return Constant(chosen, str(chosen))


def _fraction(kind: Kind, raw: "Any", address: str, context: "Context") -> Bound:
    text = _text_of(kind, raw)
    return Constant(read_fraction(text), {"value": text.strip()})


def _exact(kind: Kind, raw: "Any", address: str, context: "Context") -> Bound:
    text = _text_of(kind, raw)
    if is_uncertain(text):
        raise UsageError(
            f"{_brief(text)} is an uncertain value; a conversion needs one exact number",
            code="uncertain",
            hint=f"write one number, for example {kind.example}",
        )
    if text.count(",") + text.count(" ") > 1:
        from dynamics_cli.core.inputs.forms.lists import require_one

        require_one(text)
    amount = read_amount(text)
    if len(amount.parts) == 1:
        numerator, denominator, unit = amount.parts[0]
    else:
        numerator, denominator, last = total(amount)
        unit = last.text
    value = ExactQuantity(numerator, denominator, unit, text)
    displayed = numerator if denominator == 1 and abs(numerator) < 2**53 else nearest(numerator, denominator)
    shown, unit = parts_of(amount) or (displayed, unit)
    return Exact(address, kind, value, {"value": shown, "unit": unit} if unit else {"value": shown})


def components_of(kind: Kind, raw: "Any") -> "list[Any]":
    """The components of a vector, as raw input each."""
    if isinstance(raw, dict) and isinstance(raw.get("value"), list):
        if any(raw.get(key) is not None for key in ("distributions", "std", "interval")):
            from dynamics_cli.core.inputs.uncertain.vectors import component_items

            return component_items(raw, kind.size)
        return [f"{_text_of(kind, item)} {raw.get('unit') or ''}".strip() for item in raw["value"]]
    if isinstance(raw, list):
        return raw
    from dynamics_cli.core.inputs.forms.lists import vector_items

    return vector_items(_text_of(kind, raw).strip(), lone=kind.exact)


def read_vector(kind: Kind, raw: "Any", address: str, context: "Context") -> VectorValue:
    """A vector by its components; one in the x–y plane also by magnitude and direction."""
    if kind.flat and _is_polar(raw):
        return read_planar(kind, raw, address, context)
    items = [_resolved(item, f"{address}[{i}]", context) for i, item in enumerate(components_of(kind, raw))]
    if kind.flat and (len(items) == 2 or (kind.exact and len(items) == 1)):
        from dynamics_cli.core.inputs.forms.lists import share_unit

        # one coordinate is a place along x, as on a beam
        zero = share_unit(["0", items[-1]])[0] if isinstance(items[-1], str) else 0
        items += [zero] * (kind.size - len(items))
    if len(items) != kind.size:
        count = f"{len(items)} component{'s' if len(items) > 1 else ''}"
        wanted = f"2 or {kind.size}" if kind.flat else kind.size
        raise UsageError(f"read {count}, wanted {wanted}", hint=f"for example {kind.example!r}")
    default_unit = _default_unit(kind, raw, context)
    if not default_unit and all(isinstance(item, str) and not item.strip("+-0.") for item in items):
        default_unit = kind.unit
    parts = [read_number_of(kind, item, f"{address}[{i}]", context, default_unit) for i, item in enumerate(items)]
    units, si = {part.unit for part in parts}, tuple(part.si for part in parts)
    displayed, unit = ([part.shown for part in parts], units.pop()) if len(units) == 1 else (list(si), kind.unit)
    if all(type(part) is Value for part in parts):
        return VectorValue(address, kind, si, displayed, unit)
    from dynamics_cli.core.inputs.uncertain.vectors import UncertainVector

    if address in context.origins:
        document, result, covariance = context.origins.pop(address)
        context.origins |= {f"{address}[{i}]": (document, f"{result}[{i}]", covariance) for i in range(kind.size)}
    return UncertainVector(address, kind, si, displayed, unit, parts)


def _is_polar(raw: "Any") -> bool:
    """Whether a vector is written as a magnitude and a direction; `@` before or between components is a reference."""
    if isinstance(raw, str):
        size, at, _ = raw.partition("@")
        return bool(at and size.strip()) and "," not in size
    return isinstance(raw, dict) and "magnitude" in raw and "direction" in raw


def read_planar(kind: Kind, raw: "Any", address: str, context: "Context") -> VectorValue:
    """A planar vector by its components or by magnitude and direction."""
    if not _is_polar(raw):
        return read_vector(kind, raw, address, context)
    if isinstance(raw, dict):
        size, direction = raw["magnitude"], raw["direction"]
    else:
        size, _, direction = (part.strip() for part in raw.partition("@"))
    from dynamics_cli.quantities import Angle

    magnitude = read_number_of(kind, size, f"{address}.magnitude", context, "")
    angle = read_number_of(Angle, direction, f"{address}.direction", context, "")  # type: ignore[arg-type]
    certain = type(magnitude) is Value and type(angle) is Value
    return (TypedPolar if certain else PolarVector)(address, kind, magnitude, angle)


def _tensor(kind: Kind, raw: "Any", address: str, context: "Context") -> Bound:
    from dynamics_cli.core.inputs.forms.tensors import read_tensor

    return VectorValue(address, kind, *read_tensor(kind, raw, _default_unit(kind, raw, context)))


def _formula(kind: Kind, raw: "Any", address: str, context: "Context") -> Bound:
    from dynamics_cli.core.inputs.forms.formulas import read

    return read(_text_of(kind, raw), kind, address, context, read_number_of)


_FORMS: "dict[str, Callable[[Kind, Any, str, Context], Bound]]" = {
    "scalar": _scalar,
    "slope": _scalar,
    "whole": _whole,
    "range": _range,
    "flag": _flag,
    "text": _text,
    "unit": _text,
    "file": _file,
    "fraction": _fraction,
    "exact": _exact,
    "vector": read_vector,
    "planar": read_planar,
    "tensor": _tensor,
    "formula": _formula,
    "let": _formula,
}
