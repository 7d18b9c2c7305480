"""Conversion of a quantity to other units: exact rationals throughout, one rounding at the end.

Units are this family's own subject, so unlike physics it works with the unit table itself.
"""

from dynamics_cli.core.units import Unit, candidates, conformable, is_offset, nearest, parse_pair, parse_unit
from dynamics_cli.core.units import convert as convert_exactly
from dynamics_cli.errors import InadmissibleError, UsageError
from dynamics_cli.quantities import STANDARD_GRAVITY_TEXT, Kind, Text
from dynamics_cli.quantities import Unit as UnitName
from dynamics_cli.records import Advice, Condition, ErrorBound, ExactQuantity, Measured, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    WeightGravity = ExactQuantity
else:
    WeightGravity = Kind(
        "acceleration",
        "",
        form="exact",
        example="32.2 ft/s^2",
        about="the gravity between mass and weight",
        default=STANDARD_GRAVITY_TEXT,
        variable="DYNAMICS_GRAVITY",
        needs="weight",
    )

HALF_ULP = 2.0**-53
SMALLEST_NORMAL = 2.0**-1022
SMALLEST_DOUBLE = 5e-324
STANDARD_GRAVITY = ExactQuantity(980665, 100000, "m/s^2")


@record
class Conversion:
    """A quantity in other units.

    Parameters
    ----------
    value : Measured
        The quantity in the one unit asked for.
    values : tuple of Measured
        The quantity in each unit asked for, when several are.
    exact : bool
        Whether every number given is the exact result.
    exact_value : str
        The exact result as a rational, with π where the factor has it.
    factor : str
        The exact factor from the unit read to the unit asked for.
    offset : str
        What is added after the factor, for temperatures.
    """

    value: Measured | None
    values: tuple[Measured, ...] | None
    exact: bool
    exact_value: Text | tuple[Text, ...]
    factor: Text | tuple[Text, ...]
    offset: Text | None
    numerics: Numerics
    advice: tuple[Advice, ...]


def convert(
    value: ExactQuantity,
    /,
    *targets: UnitName,
    weight: bool = False,
    gravity: WeightGravity | None = None,
) -> Conversion:
    """Convert a quantity to one or several units, correctly rounded.

    Equation: value in the target = (value · factor + offset) / (target's factor), in exact rationals; π to as many
    digits as the rounding needs.

    Parameters
    ----------
    value : ExactQuantity
        The number and its unit, as one word or two.
    *targets : Unit
        The units wanted; `ft;in` gives feet and inches.
    weight : bool
        Take a mass for its weight, or a weight for its mass, by gravity.
    gravity : WeightGravity
        The gravity that --weight uses [m/s²].

    Returns
    -------
    Conversion
        One target gives `value`, several give `values`.

    Raises
    ------
    UsageError
        When a unit is unknown or of another kind than the value.
    InadmissibleError
        When a temperature is below absolute zero.

    Notes
    -----
    The error is at most half a unit in the last place: conversion rounds once. Powers of ten beyond the range of a
    double are refused.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, table 1.7.1.

    Examples
    --------
    >>> convert(ExactQuantity(60, 1, "mph"), "ft/s").value
    Measured(value=88.0, unit='ft/s')
    """
    if gravity is not None:
        _gravity(gravity)
    if not value.unit:
        raise UsageError("value: its unit is missing", parameter="value", hint="for example 60 mph")
    for target in targets:
        if target.strip()[:1].isdigit() and not target.strip().startswith("1/"):
            raise UsageError(
                f"{target!r} is a number where a unit should be",
                parameter="targets",
                hint="quote a value that has spaces",
            )
    if not targets or not all(target.strip() for target in targets):
        raise UsageError("targets: the unit to convert to is missing", parameter="targets", hint="for example ft/s")
    parts = [_one(value, target, weight=weight, gravity=gravity) for target in targets]
    several = len(parts) > 1
    name = "values" if several else "value"
    return Conversion(
        value=None if several else parts[0].measured,
        values=tuple(part.measured for part in parts) if several else None,
        exact=all(part.exact for part in parts),
        exact_value=tuple(part.exact_text for part in parts) if several else parts[0].exact_text,
        factor=tuple(part.factor for part in parts) if several else parts[0].factor,
        offset=None if several else parts[0].offset,
        numerics=Numerics(
            "exact rational arithmetic, rounded once",
            (_bound(name, parts),),
            (Condition(name, "value", max((part.condition for part in parts), key=abs)),),
        ),
        advice=_readings(parts),
    )


def _bound(name: str, parts: "list[_Part]") -> ErrorBound:
    """Half a unit in the last place, which subnormal numbers have in absolute terms only."""
    if all(part.exact for part in parts):
        return ErrorBound(name, 0.0)
    tiny = any(0.0 < abs(part.size) < SMALLEST_NORMAL for part in parts)
    return ErrorBound(name, SMALLEST_DOUBLE, relative=False) if tiny else ErrorBound(name, HALF_ULP)


def _readings(parts: "list[_Part]") -> tuple[Advice, ...]:
    """How units of two readings were read; two readings of one value in one call deserve more than a note."""
    readings = {part.notes[0] for part in parts if part.notes}
    severity: Literal["note", "caution"] = "caution" if len(readings) > 1 else "note"
    notes = dict.fromkeys(note for part in parts for note in part.notes)
    return tuple(Advice("reading", note, severity) for note in notes)


class _Part:
    """The conversion to one target."""

    __slots__ = ("condition", "exact", "exact_text", "factor", "measured", "notes", "offset", "size")

    def __init__(self, measured: Measured, exact: bool, exact_text: str, factor: str, condition: float) -> None:
        self.measured = measured
        self.exact = exact
        self.exact_text = exact_text
        self.factor = factor
        self.condition = condition
        self.notes: tuple[str, ...] = ()
        self.offset: str | None = None
        self.size = measured.value if isinstance(measured.value, float) else 1.0


def _one(value: ExactQuantity, target: str, *, weight: bool, gravity: ExactQuantity | None) -> _Part:
    numerator, denominator = value.numerator, value.denominator
    compound: tuple[Unit, ...] = ()
    if ";" in target:
        from dynamics_cli.core.compound import from_exact_compound, parse_compound

        compound = parse_compound(target)
    source, wanted = parse_pair(value.unit, compound[-1].text if compound else target)
    notes = (*source.notes, *wanted.notes)
    if weight:
        numerator, denominator, source, notes = _weigh(numerator, denominator, value.unit, wanted, gravity)
        wanted = parse_unit(wanted.text, source)
        notes = (*notes, *wanted.notes)
    if not conformable(source, wanted):
        message, hint = _mismatch(source, wanted)
        near = _near(value.unit, wanted) or _near(target, source)
        raise UsageError(message, code="dimension", parameter="targets", hint=near or hint)
    if is_offset(source) or is_offset(wanted):
        _check_temperature(numerator, denominator, source)
    n, d, pi = convert_exactly(numerator, denominator, source, wanted)
    exact_text = _rational(n, d, pi)
    factor = _factor(source, wanted)
    if weight:
        factor = _rational(*convert_exactly(*_weigh(1, 1, value.unit, wanted, gravity)[:2], source, wanted))
    if compound:
        numbers = from_exact_compound(numerator, denominator, source, compound)
        total = nearest(n, d, pi)
        part = _Part(Measured(numbers, target), False, f"{exact_text} {wanted.text}", factor, 1.0)
        part.exact = pi == 0 and total.as_integer_ratio() == (n, d)
    else:
        rounded = nearest(n, d, pi)
        exact = pi == 0 and rounded.as_integer_ratio() == (n, d)
        part = _Part(Measured(rounded, target), exact, exact_text, factor, 1.0)
        if is_offset(source) or is_offset(wanted):
            part.condition = _affine_condition(numerator, denominator, source, wanted, rounded)
    if is_offset(source) or is_offset(wanted):
        part.offset = _rational(*convert_exactly(0, 1, source, wanted))
    part.notes = notes
    return part


def _mismatch(read: Unit, wanted: Unit) -> tuple[str, str]:
    from dynamics_cli.core.unit_words import explain_mismatch

    return explain_mismatch(read, wanted)


def _near(text: str, wanted: Unit) -> str | None:
    """A unit of the kind wanted whose name is nearly this one: mph for mhp, which is a power."""
    from dynamics_cli.core.unit_words import names_like

    fits = [name for name in names_like(text) if any(conformable(unit, wanted) for unit in candidates(name))]
    return f"did you mean {' or '.join(fits[:3])}?" if fits else None


def _weigh(
    numerator: int, denominator: int, text: str, wanted: Unit, gravity: ExactQuantity | None
) -> tuple[int, int, Unit, tuple[str, ...]]:
    """A mass as its weight or a weight as its mass, in SI, and how its unit was read."""
    gn, gd = _gravity(gravity)
    kilogram, newton = parse_unit("kg"), parse_unit("N")
    for given, becomes, n, d in ((kilogram, newton, gn, gd), (newton, kilogram, gd, gn)):
        source = parse_unit(text, given)
        if conformable(source, given) and conformable(parse_unit(wanted.text, becomes), becomes):
            an, ad, _ = convert_exactly(numerator, denominator, source, given)
            return an * n, ad * d, becomes, source.notes
    raise UsageError(
        "--weight converts a mass to a weight or a weight to a mass",
        parameter="weight",
        hint="for example: dynamics convert 150 lbf kg --weight",
    )


def _gravity(gravity: ExactQuantity | None) -> tuple[int, int]:
    """The gravity used, as an exact number of m/s²."""
    given = gravity or STANDARD_GRAVITY
    wanted = parse_unit("m/s^2")
    unit = parse_unit(given.unit, wanted)
    if not conformable(unit, wanted):
        message, hint = _mismatch(unit, wanted)
        raise UsageError(message, parameter="gravity", hint=hint)
    n, d, _ = convert_exactly(given.numerator, given.denominator, unit, wanted)
    if n <= 0:
        raise UsageError("gravity must be positive", parameter="gravity")
    return n, d


def _check_temperature(numerator: int, denominator: int, source: Unit) -> None:
    kelvin, below, _ = convert_exactly(numerator, denominator, source, parse_unit("K"))
    if kelvin < 0:
        raise InadmissibleError(
            f"{nearest(numerator, denominator):g} {source.text} is below absolute zero by {-kelvin / below:g} K",
            code="below-zero",
        )


def _rational(numerator: int, denominator: int, pi: int) -> str:
    if pi == 0 or numerator == 0:
        return str(numerator) if denominator == 1 else f"{numerator}/{denominator}"
    power = "π" if abs(pi) == 1 else f"π^{abs(pi)}"
    if pi > 0:
        top = power if numerator == 1 else f"{numerator}·{power}"
        return top if denominator == 1 else f"{top}/{denominator}"
    return f"{numerator}/{power}" if denominator == 1 else f"{numerator}/({denominator}·{power})"


def _factor(source: Unit, target: Unit) -> str:
    """Target units in one source unit; for scales with different zeros, of a difference."""
    numerator = source.numerator * target.denominator
    denominator = source.denominator * target.numerator
    from math import gcd

    common = gcd(numerator, denominator)
    return _rational(numerator // common, denominator // common, source.pi - target.pi)


def _affine_condition(numerator: int, denominator: int, source: Unit, target: Unit, rounded: float) -> float:
    slope = (source.numerator * target.denominator) / (source.denominator * target.numerator)
    return slope * (numerator / denominator) / rounded if rounded else 0.0
