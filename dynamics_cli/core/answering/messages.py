"""Messages of the physics, with their values in the units that the inputs were written in.

A message of physics carries typed values in SI (`errors.Wording`). A value that is one of the inputs is shown as it was
written; another one, beside an answer, in the unit that results of its kind are shown in; otherwise in the unit of an
input of its kind; one of a kind that no input has, in the kind's default unit. Messages without values are left as they
are.
"""

from dynamics_cli.core.inputs.values import Bound, Fields, Several, Value, VectorValue
from dynamics_cli.core.units.display import pretty
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.core.units.unit import NUMBER, Unit, conformable
from dynamics_cli.errors import Wording, filled

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from dynamics_cli.core.units.display import Shown
    from dynamics_cli.quantities import Kind

    # an input's SI value (None for vectors), its number as written, its unit
    _Written = tuple[float | None, object, Unit]

DEGREE = parse_unit("deg")


def in_written_units(text: str, bound: Bound, results: "Iterable[Shown]" = ()) -> str:
    """A message with its values in the units of the inputs, or of the results that it stands beside.

    >>> in_written_units("no segment is given", Fields(None, {}))
    'no segment is given'
    """
    if not isinstance(text, Wording):
        return text
    inputs = list(_written(bound))
    shares = list(_shares(bound))
    beside = {shown.kind.name: shown.bound_unit for shown in results if shown.kind.unit}

    def write(value: float, kind: "Kind", digits: int) -> str:
        unit = parse_unit(kind.unit)
        # pure numbers share a unit only within their kind: a grade in % does not put a drag factor in %
        alike = [entry for entry in inputs if conformable(entry[2], unit)] if kind.unit else []
        alike = alike or [entry for name, *entry in shares if name == kind.name]  # type: ignore[misc]
        for si, shown, shown_in in alike:
            if si == value and isinstance(shown, int | float):
                return f"{shown:.9g} {pretty(shown_in.text)}".rstrip()
        if kind.name in beside:
            unit = parse_unit(beside[kind.name], unit)
        else:
            unit = alike[0][2] if alike else parse_unit(kind.si, unit)
        # rounded, then written out: 190 deg, not 1.9e+02 deg
        rounded = float(f"{value / factor(unit) + 0.0:.{digits}g}")
        return f"{rounded:.9g} {pretty(unit.text)}".rstrip()

    return filled(text.template, text.values, write)


def factor(unit: Unit) -> float:
    """The factor from this unit to SI."""
    from math import pi

    return unit.numerator / unit.denominator * pi**unit.pi


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
            shown = bound.si / factor(unit) if isinstance(bound, Value) else None
        yield (bound.si if isinstance(bound, Value) else None), shown, unit
