"""What physics says of sizes, in the units the inputs were written in.

Physics works in SI and words its refusals and advice in it. A size that is one of the inputs is shown as it was
written; another one of the same dimension goes into the inputs' unit where that is no decimal multiple of SI, or where
all of them are written in smaller units than SI's own, such as millimetres; radians become degrees. A size that a
standard names, such as a module of a series, stands before a no-break space and is kept. What is only an example is
left as it is.
"""

from dynamics_cli.core.inputs.values import Bound, Fields, Several, Value, VectorValue
from dynamics_cli.core.units.display import pretty
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.core.units.unit import NUMBER, Unit, conformable
from dynamics_cli.errors import Wording, filled

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from dynamics_cli.quantities import Kind

    # an input's SI value (None for vectors), its number as written, its unit
    _Written = tuple[float | None, object, Unit]

# The units that physics words its messages in.
UNITS = ("kg·m²", "N·m", "N·s", "N/m", "m/s", "m²", "mm", "rad", "kg", "m", "N", "J")
# What may stand behind a unit in a sentence.
ENDS = ",.;:)"
# What keeps a size and its unit as they are: a no-break space.
KEPT = "\u00a0"
# What stands between numbers of one unit.
BETWEEN = ("and", "or", "to")
DEGREE = parse_unit("deg")
# What begins an example, or words to be written as they stand.
EXAMPLES = ("for example", "such as", '"')
# How messages write their numbers.
FORMATS = ("{:.6g}", "{:.4g}", "{:.3g}", "{:.9g}", "{:.5g}")
# What a size in another unit is shown with at the least, and one that a user is told to give.
FEWEST_DIGITS, FEWEST_TO_GIVE = 4, 6


def in_written_units(text: str, bound: Bound, digits: int = FEWEST_DIGITS) -> str:
    """A message with its sizes in the units of the inputs.

    >>> in_written_units("the throw distance 0.3048 m is short", Fields(None, {}))
    'the throw distance 0.3048 m is short'
    """
    if isinstance(text, Wording):
        return _filled(text, bound)
    words = text[: _example(text)].split(" ")
    places = [place for place in range(len(words) - 1) if words[place + 1].rstrip(ENDS) in UNITS]
    places = [place for place in places if _is_number(words[place].lstrip("("))]
    if not places:
        return text.replace(KEPT, " ")
    written = list(_written(bound))
    for place in places:
        name = words[place + 1].rstrip(ENDS)
        alike = _listed(words, place)
        made = [_shown(words[one].strip("(,"), name, written, digits) for one in alike]
        if not any(made):
            continue
        shown = [one or (words[at].strip("(,"), name) for at, one in zip(alike, made, strict=True)]
        for at, (number, unit) in zip(alike[:-1], shown[:-1], strict=True):
            own = number if unit == shown[-1][1] else f"{number} {unit}"
            words[at] = words[at].replace(words[at].strip("(,"), own)
        words[place] = words[place].replace(words[place].strip("(,"), shown[-1][0])
        words[place + 1] = words[place + 1].replace(name, shown[-1][1])
    return (" ".join(words) + text[_example(text) :]).replace(KEPT, " ")


def _filled(wording: Wording, bound: Bound) -> str:
    """A sentence with its values in the unit of the input that has the value, or else of an input of that kind."""
    written = list(_written(bound))
    shares = list(_shares(bound))

    def write(value: float, kind: "Kind", digits: int) -> str:
        unit = parse_unit(kind.unit)
        # pure numbers are alike in nothing but their kind: a grade in % makes no drag factor one
        alike = [entry for entry in written if conformable(entry[2], unit)] if kind.unit else []
        alike = alike or [entry for name, *entry in shares if name == kind.name]  # type: ignore[misc]
        for si, shown, own in alike:
            if si == value and isinstance(shown, int | float):
                return f"{shown:.9g} {pretty(own.text)}".rstrip()
        own = alike[0][2] if alike else parse_unit(kind.si, unit)
        return f"{_in(value, own):.{digits}g} {pretty(own.text)}".rstrip()

    return filled(wording.template, wording.values, write)


def _example(text: str) -> int:
    """Where what is only an example begins: its sizes are not the case's."""
    return min((place for sign in EXAMPLES if (place := text.find(sign)) >= 0), default=len(text))


def _listed(words: "list[str]", last: int) -> "list[int]":
    """Where the numbers stand that share the unit behind the last: those of "1, 2 and 3 m"."""
    made, here = [last], last
    while True:
        here -= 2 if here > 1 and words[here - 1] in BETWEEN else 1
        joined = made[0] - here == 2 or (here >= 0 and words[here].endswith(","))
        if here < 0 or not joined or not _is_number(words[here].strip("(,")):
            return made
        made.insert(0, here)


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def _shown(number: str, name: str, written: "list[_Written]", fewest: int) -> "tuple[str, str] | None":
    """Number and unit in place of these; None where they stay."""
    unit = parse_unit(name)
    alike = [(si, shown, own) for si, shown, own in written if conformable(own, unit)]
    same = [
        (abs(_in(si, unit) - float(number)), shown, own)
        for si, shown, own in alike
        if si is not None and isinstance(shown, int | float) and _is(number, _in(si, unit))
    ]
    if same:
        _, shown, own = min(same, key=lambda one: one[0])
        return f"{shown:.9g}", pretty(own.text)
    other = next((own for _, _, own in alike if not _is_decimal(own)), None)
    if (
        other is None
        and alike
        and factor(unit) == 1.0
        and (all(factor(own) < 1.0 for _, _, own in alike) or len({own.text for _, _, own in alike}) == 1)
    ):
        other = alike[0][2]  # everything of the kind was written in it, or in smaller units
    if other is None and name == "rad" and not alike:
        other = DEGREE
    if other is None:
        return None
    digits = max(fewest, len(number.partition("e")[0].lstrip("-0.").replace(".", "")))
    return f"{_in(float(number) * factor(unit), other):.{digits}g}", pretty(other.text)


def _is(number: str, value: float) -> bool:
    return any(form.format(value) == number for form in FORMATS)


def factor(unit: Unit) -> float:
    """What a number in this unit is times, in SI."""
    from math import pi

    return unit.numerator / unit.denominator * pi**unit.pi


def _in(si: float, unit: Unit) -> float:
    return si / factor(unit)


def _is_decimal(unit: Unit) -> bool:
    """Whether a unit is SI, or a power of ten of it."""
    whole = unit.numerator * unit.denominator
    return unit.pi == 0 and str(whole).strip("0") == "1"


def _shares(bound: Bound) -> "Iterator[tuple[str, float, object, Unit]]":
    """Every pure number by its kind."""
    if isinstance(bound, Fields | Several):
        for part in bound.fields.values() if isinstance(bound, Fields) else bound.items:
            yield from _shares(part)
    elif isinstance(bound, Value) and not bound.kind.unit and conformable(unit := parse_unit(bound.unit), NUMBER):
        yield bound.kind.name, bound.si, bound.shown, unit


def _written(bound: Bound) -> "Iterator[_Written]":
    """Every input with a unit."""
    if isinstance(bound, Fields):
        for part in bound.fields.values():
            yield from _written(part)
    elif isinstance(bound, Several):
        for part in bound.items:
            yield from _written(part)
    elif isinstance(bound, Value | VectorValue) and bound.unit and ";" not in bound.unit:
        unit = parse_unit(bound.unit, parse_unit(bound.kind.unit) if bound.kind.unit else None)
        shown = bound.shown
        if conformable(unit, DEGREE) and factor(unit) < factor(DEGREE):  # 20 deg 30 min is written in minutes
            unit = DEGREE
            shown = _in(bound.si, unit) if isinstance(bound, Value) else None
        yield (bound.si if isinstance(bound, Value) else None), shown, unit
