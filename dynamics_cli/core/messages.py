"""What physics says of sizes, in the units the inputs were written in.

Physics works in SI and words its refusals and advice in it. A size that is one of the inputs is shown as it was
written; another one of the same dimension goes into the inputs' unit where that is no decimal multiple of SI; radians
become degrees.
"""

from dynamics_cli.core.bound import Bound, Fields, Several, Value, VectorValue
from dynamics_cli.core.shown import pretty
from dynamics_cli.core.units import Unit, conformable, parse_unit

TYPE_CHECKING = False
if TYPE_CHECKING:
    import re
    from collections.abc import Iterator

# The units that physics words its messages in.
UNITS = ("kg·m²", "N·m", "N·s", "N/m", "m/s", "m²", "mm", "rad", "kg", "m", "N", "J")
# How messages write their numbers.
FORMATS = ("{:.6g}", "{:.4g}", "{:.3g}", "{:.9g}", "{:.5g}")
FEWEST_DIGITS = 4


def in_written_units(text: str, bound: Bound) -> str:
    """A message with its sizes in the units of the inputs.

    >>> in_written_units("the throw distance 0.3048 m is short", Fields(None, {}))
    'the throw distance 0.3048 m is short'
    """
    if not any(f" {unit}" in text for unit in UNITS):
        return text
    import re

    written = list(_written(bound))
    # what stands in quotes is an example of what to write
    pattern = rf"(?<![\w.\"'-])(-?\d+(?:\.\d+)?(?:e[+-]?\d+)?) ({'|'.join(UNITS)})(?![\w·/²³^*])"
    return re.sub(pattern, lambda found: _shown(found, written), text)


def _shown(found: "re.Match[str]", written: "list[tuple[float | None, object, Unit]]") -> str:
    number, unit = found[1], parse_unit(found[2])
    alike = [(si, shown, own) for si, shown, own in written if conformable(own, unit)]
    for si, shown, own in alike:
        if si is not None and isinstance(shown, int | float) and _is(number, _in(si, unit)):
            return f"{shown:.9g} {pretty(own.text)}"
    other = next((own for _, _, own in alike if not _is_decimal(own)), None)
    if other is None and found[2] == "rad" and not alike:
        other = parse_unit("deg")
    if other is None:
        return found[0]
    digits = max(FEWEST_DIGITS, len(number.partition("e")[0].lstrip("-0.").replace(".", "")))
    return f"{_in(float(number) * _factor(unit), other):.{digits}g} {pretty(other.text)}"


def _is(number: str, value: float) -> bool:
    return any(form.format(value) == number for form in FORMATS)


def _factor(unit: Unit) -> float:
    from math import pi

    return unit.numerator / unit.denominator * pi**unit.pi


def _in(si: float, unit: Unit) -> float:
    return si / _factor(unit)


def _is_decimal(unit: Unit) -> bool:
    """Whether a unit is SI, or a power of ten of it."""
    whole = unit.numerator * unit.denominator
    return unit.pi == 0 and str(whole).strip("0") == "1"


def _written(bound: Bound) -> "Iterator[tuple[float | None, object, Unit]]":
    """Every input with a unit: its SI value (None for vectors), its number as written, its unit."""
    if isinstance(bound, Fields):
        for part in bound.fields.values():
            yield from _written(part)
    elif isinstance(bound, Several):
        for part in bound.items:
            yield from _written(part)
    elif isinstance(bound, Value | VectorValue) and bound.unit and ";" not in bound.unit:
        unit = parse_unit(bound.unit, parse_unit(bound.kind.unit) if bound.kind.unit else None)
        yield (bound.si if isinstance(bound, Value) else None), bound.shown, unit
