"""Conversion of a quantity to other units: exact rationals throughout, one rounding at the end.

Units are this family's own subject, so unlike physics it works with the unit table itself.
"""

from math import atan

from dynamics_cli.core.units.conversion import convert as convert_exactly
from dynamics_cli.core.units.conversion import is_offset, lowest, nearest
from dynamics_cli.core.units.lookup import candidates, parse_pair, parse_unit
from dynamics_cli.core.units.unit import NONE, NUMBER, Unit, conformable
from dynamics_cli.errors import InadmissibleError, UsageError
from dynamics_cli.quantities import STANDARD_GRAVITY_TEXT, Annotated, Kind, Text
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

# Units of a slope: rise over run.
SLOPES = ("%", "‰", "percent", "permille", "pct")
ANGLE = (0, 0, 0, 0, 0, 0, 0, 1)
PURE = "1"
HALF_ULP = 2.0**-53
SMALLEST_NORMAL = 2.0**-1022
SMALLEST_DOUBLE = 5e-324
STANDARD_GRAVITY = ExactQuantity(980665, 100000, "m/s^2")


@record
class Conversion:
    """A quantity in other units."""

    value: Annotated[Measured | None, "The quantity in the requested unit."]
    values: Annotated[tuple[Measured, ...] | None, "The quantity in each requested unit, when there are several."]
    exact: Annotated[bool, "Whether every number given is the exact result."]
    exact_value: Annotated[Text | tuple[Text, ...], "The exact result as a rational, with π where the factor has it."]
    factor: Annotated[
        Text | tuple[Text, ...] | None, "The exact factor from the unit read to the requested unit, where there is one."
    ]
    offset: Annotated[Text | None, "Offset added after the factor, for temperatures."]
    numerics: Numerics
    advice: tuple[Advice, ...]


def convert(
    value: Annotated[ExactQuantity, "The number and its unit, as one word or two."],
    /,
    *targets: Annotated[UnitName, "The target units, SI if none is given; `ft;in` gives feet and inches."],
    weight: Annotated[bool, "Take a mass for its weight, or a weight for its mass, by gravity."] = False,
    gravity: Annotated[WeightGravity | None, "The gravity that --weight uses [m/s²]."] = None,
) -> Conversion:
    """Convert a quantity to one or several units, correctly rounded.

    Equation: value in the target = (value · factor + offset) / (target's factor), in exact rationals; π to as many
    digits as the rounding needs. Between a unit and the reciprocal of one (mpg and L/100km) it is factor / value;
    between a slope in % and an angle the tangent or the arctangent.

    Returns
    -------
    Conversion
        One target gives `value`, several give `values`.

    Raises
    ------
    UsageError
        When a unit is unknown or of another kind than the value.
    InadmissibleError
        When a temperature is below absolute zero, the reciprocal of zero or the slope of a right angle is wanted.

    Notes
    -----
    The error is at most half a unit in the last place: conversion rounds once. Powers of ten beyond the range of a
    double are refused.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, table 1.7.1.

    Examples
    --------
    >>> convert(ExactQuantity(60, 1, "mph"), "ft/s").value.value
    88.0
    """
    if gravity is not None:
        _gravity(gravity)
    if not value.unit:
        raise UsageError(f"{value.text.strip()} has no unit", parameter="value", hint="for example 60 mph")
    for target in targets:
        if target.strip()[:1].isdigit() and not target.strip().startswith("1/"):
            raise UsageError(
                f"read {target!r}, wanted a unit to convert to",
                parameter="targets",
                hint="quote a value that has spaces",
            )
    if not all(target.strip() for target in targets):
        raise UsageError("targets: the unit to convert to is empty", parameter="targets", hint="for example ft/s")
    wanted = tuple(map(_several_units, targets)) or (_in_si(value.unit),)
    parts = [_one(value, target, weight=weight, gravity=gravity) for target in wanted]
    several = len(parts) > 1
    name = "values" if several else "value"
    return Conversion(
        value=None if several else parts[0].measured,
        values=tuple(part.measured for part in parts) if several else None,
        exact=all(part.exact for part in parts),
        exact_value=tuple(part.exact_text for part in parts) if several else parts[0].exact_text,
        factor=tuple(part.factor or "none" for part in parts) if several else parts[0].factor,
        offset=None if several else parts[0].offset,
        numerics=Numerics(
            "exact rational arithmetic, rounded once",
            (_bound(name, parts),),
            (Condition(name, "value", max((part.condition for part in parts), key=abs)),),
        ),
        advice=_readings(parts),
    )


def _several_units(target: str) -> str:
    """The units of `ft+in`, `ft, in`, `feet and inches`, `dms` or `hms` as `ft;in` is written."""
    for mark in ("+", ",", "&", " and "):
        target = target.replace(mark, ";")
    return {"dms": "deg;arcmin;arcsec", "hms": "h;min;s"}.get(target, target)


def _bound(name: str, parts: "list[_Part]") -> ErrorBound:
    """Half a unit in the last place, which subnormal numbers have in absolute terms only."""
    if all(part.exact for part in parts):
        return ErrorBound(name, 0.0)
    tiny = any(0.0 < abs(part.size) < SMALLEST_NORMAL for part in parts)
    return ErrorBound(name, SMALLEST_DOUBLE, relative=False) if tiny else ErrorBound(name, HALF_ULP)


def _readings(parts: "list[_Part]") -> tuple[Advice, ...]:
    """How units of several meanings were read; two readings of one value in one call deserve more than a note."""
    readings = {part.reading for part in parts}
    severity: Literal["note", "caution"] = "caution" if len(readings) > 1 else "note"
    notes = dict.fromkeys(note for part in parts for note in part.notes)
    return tuple(Advice("reading", note, severity) for note in notes)


class _Part:
    """The conversion to one target."""

    __slots__ = ("condition", "exact", "exact_text", "factor", "measured", "notes", "offset", "reading", "size")

    def __init__(self, measured: Measured, exact: bool, exact_text: str, factor: str | None, condition: float) -> None:
        self.measured = measured
        self.exact = exact
        self.exact_text = exact_text
        self.factor = factor
        self.condition = condition
        self.notes: tuple[str, ...] = ()
        # How the unit of the input was read.
        self.reading: tuple[str, ...] = ()
        self.offset: str | None = None
        self.size = measured.value if isinstance(measured.value, float) else 1.0


def _one(value: ExactQuantity, target: str, *, weight: bool, gravity: ExactQuantity | None) -> _Part:
    numerator, denominator = value.numerator, value.denominator
    compound: tuple[Unit, ...] = ()
    if ";" in target:
        from dynamics_cli.core.units.compound import from_exact_compound, parse_compound

        compound = parse_compound(target)
    source, target_unit = parse_pair(value.unit, compound[-1].text if compound else target)
    reading = source.notes
    if weight:
        numerator, denominator, source, reading = _weigh(numerator, denominator, value.unit, target_unit, gravity)
        target_unit = parse_unit(target_unit.text, source)
    if not conformable(source, target_unit):
        part = _other_relation(numerator, denominator, source, target_unit, target)
        if part is None:
            message, hint = _mismatch(source, target_unit)
            near = _near(value.unit, target_unit) or _near(target, source)
            if target == "in":
                near = "in is the inch; between a value and its target stands to: 60 mph to km/h"
            raise UsageError(message, code="dimension", parameter="targets", hint=near or hint)
        part.reading, part.notes = reading, (*reading, *target_unit.notes, *part.notes)
        return part
    if is_offset(source) or is_offset(target_unit):
        _check_zero(numerator, denominator, source)
    n, d, pi = convert_exactly(numerator, denominator, source, target_unit)
    exact_text = _rational(n, d, pi)
    factor = _factor(source, target_unit)
    if weight:
        factor = _rational(*convert_exactly(*_weigh(1, 1, value.unit, target_unit, gravity)[:2], source, target_unit))
    rounded = nearest(n, d, pi)
    exact = pi == 0 and rounded.as_integer_ratio() == (n, d)
    if compound:
        numbers = from_exact_compound(numerator, denominator, source, compound)
        part = _Part(Measured(numbers, target), exact, f"{exact_text} {target_unit.text}", factor, 1.0)
    else:
        part = _Part(Measured(rounded, "" if target == PURE else target), exact, exact_text, factor, 1.0)
        if is_offset(source) or is_offset(target_unit):
            part.condition = _affine_condition(numerator, denominator, source, target_unit, rounded)
    if is_offset(source) or is_offset(target_unit):
        part.offset = _rational(*convert_exactly(0, 1, source, target_unit))
    part.reading, part.notes = reading, (*reading, *target_unit.notes)
    return part


def _other_relation(numerator: int, denominator: int, source: Unit, wanted: Unit, target: str) -> _Part | None:
    """The conversion to a reciprocal (mpg to L/100km), or between a slope in % and an angle; None where neither is."""
    if any(source.dimension) and source.dimension == tuple(-power for power in wanted.dimension):
        return _reciprocal(numerator, denominator, source, wanted, target)
    slope, angle = (source, wanted) if source.text.strip() in SLOPES else (wanted, source)
    if slope.text.strip() not in SLOPES or angle.dimension != ANGLE:
        return None
    from dynamics_cli.convert.slopes import angle_of_slope, slope_of_angle

    if slope is source:
        ratio = lowest(numerator, denominator * slope.denominator)
        rounded = angle_of_slope(*ratio, angle)
        text = f"atan({_rational(*ratio, 0)})"
        tangent = ratio[0] / ratio[1]
        condition = tangent / ((1.0 + tangent * tangent) * atan(tangent)) if numerator else 1.0
    else:
        rounded = slope_of_angle(numerator, denominator, angle, slope.denominator)
        text = f"tan({_rational(*convert_exactly(numerator, denominator, angle, parse_unit('rad')))})"
        tangent = rounded / slope.denominator
        condition = (1.0 + tangent * tangent) * atan(tangent) / tangent if numerator else 1.0
    exact = not numerator or (angle.pi == 1 and abs(tangent) == 1.0 and rounded.is_integer())
    text = _rational(*rounded.as_integer_ratio(), 0) if exact else text
    part = _Part(Measured(rounded, target), exact, text, None, condition)
    part.notes = (f"{slope.text.strip()} read as a slope, rise over run",)
    return part


def _reciprocal(numerator: int, denominator: int, source: Unit, wanted: Unit, target: str) -> _Part:
    if not numerator:
        raise InadmissibleError(f"0 {source.text} has no value in {wanted.text}, its reciprocal", code="reciprocal")
    n, d, pi = convert_exactly(numerator, denominator, source, NUMBER)
    n, d, pi = convert_exactly(d, n, NUMBER, Unit("", wanted.numerator, wanted.denominator, NONE, pi=wanted.pi + pi))
    rounded = nearest(n, d, pi)
    exact = pi == 0 and rounded.as_integer_ratio() == (n, d)
    part = _Part(Measured(rounded, target), exact, _rational(n, d, pi), None, -1.0)
    part.notes = (f"{wanted.text} is of the kind 1/({source.text}): the reciprocal",)
    return part


def _in_si(text: str) -> str:
    """The SI unit of a unit's kind; refused for a unit that may be of different kinds."""
    if text.strip() in ("C", "F"):
        hint = f"write {text.strip()} with the unit to convert to, or deg{text.strip()}"
        raise UsageError(f"{text} may be electrical or a temperature", code="ambiguous-unit", hint=hint)
    from dynamics_cli.core.units.names import kind_name, si_name

    readings = candidates(text)
    return si_name(next((unit for unit in readings if not kind_name(unit).startswith("quantity in")), readings[0]))


def _mismatch(read: Unit, wanted: Unit) -> tuple[str, str]:
    from dynamics_cli.core.units.names import explain_mismatch

    return explain_mismatch(read, wanted)


def _near(text: str, wanted: Unit) -> str | None:
    """A unit of the kind wanted whose name is nearly this one: mph for mhp, which is a power."""
    from dynamics_cli.core.units.near_names import names_like

    fits = [name for name in names_like(text) if any(conformable(unit, wanted) for unit in candidates(name))]
    return f"did you mean {' or '.join(fits[:3])}?" if fits else None


def _weigh(
    numerator: int, denominator: int, text: str, wanted: Unit, gravity: ExactQuantity | None
) -> tuple[int, int, Unit, tuple[str, ...]]:
    """A mass as its weight or a weight as its mass, in SI, and how its unit was read."""
    gn, gd = _gravity(gravity)
    kilogram, newton = parse_unit("kg"), parse_unit("N")
    for dimension, converted, n, d in ((kilogram, newton, gn, gd), (newton, kilogram, gd, gn)):
        source = parse_unit(text, dimension)
        if conformable(source, dimension) and conformable(parse_unit(wanted.text, converted), converted):
            an, ad, _ = convert_exactly(numerator, denominator, source, dimension)
            return an * n, ad * d, converted, source.notes
    raise UsageError(
        "--weight converts a mass to a weight or a weight to a mass",
        parameter="weight",
        hint="for example: dynamics convert 150 lbf kg --weight",
    )


def _gravity(gravity: ExactQuantity | None) -> tuple[int, int]:
    """The gravity used, as an exact number of m/s²."""
    acceleration = gravity or STANDARD_GRAVITY
    si_unit = parse_unit("m/s^2")
    unit = parse_unit(acceleration.unit, si_unit)
    if not conformable(unit, si_unit):
        message, hint = _mismatch(unit, si_unit)
        raise UsageError(message, parameter="gravity", hint=hint)
    n, d, _ = convert_exactly(acceleration.numerator, acceleration.denominator, unit, si_unit)
    if n <= 0:
        raise UsageError("gravity must be positive", parameter="gravity")
    return n, d


def _check_zero(numerator: int, denominator: int, source: Unit) -> None:
    """Refuse temperatures below absolute zero and pressures below a vacuum."""
    absolute = Unit("", 1, 1, source.dimension)
    total, below, _ = convert_exactly(numerator, denominator, source, absolute)
    if total < 0:
        limit, unit = ("absolute zero", "K") if source.dimension == parse_unit("K").dimension else ("a vacuum", "Pa")
        raise InadmissibleError(
            f"{nearest(numerator, denominator):g} {source.text} is below {limit} by {-total / below:g} {unit}",
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
