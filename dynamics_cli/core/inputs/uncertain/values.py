"""Uncertain values as written: `0.72 ± 0.04`, `20..25 m`, `truncated(0.72 ± 0.1, 0.5, 0.9)`, `[0.71, 0.74]`, JSON.

Every number is read like a certain value of its parameter, with its unit and bounds; only a width (after ±) is a
difference. A unit at the end also belongs to earlier numbers without one.
"""

from math import inf

from dynamics_cli.core.inputs.forms.splitting import split_list
from dynamics_cli.core.inputs.quantity_text import ANGLE, read_amount, read_number, read_scalar, total
from dynamics_cli.core.inputs.uncertain import distributions as d
from dynamics_cli.core.inputs.uncertain.parts import beside_share, without_parts
from dynamics_cli.core.inputs.values import Value
from dynamics_cli.core.units.conversion import nearest
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.core.units.names import explain_mismatch
from dynamics_cli.core.units.unit import NUMBER, conformable
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.elementary import tan
from dynamics_cli.quantities import Angle, Kind

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.inputs.quantity_text import Reading

# Variances are squares, which leave the range of a double beyond.
LARGEST = 1e150
PLUS_MINUS = ("±", "+/-", "+-")
FORMS = (
    "0.72 ± 0.04, 0.65..0.75, 0.6..0.7..0.8, uniform(0.65, 0.75), triangular(0.6, 0.7, 0.8), beta(2, 3, 0.6, 0.8), "
    "lognormal(0.72 ± 0.04), truncated(0.72 ± 0.1, 0.5, 0.9), [0.71, 0.74, 0.70], empirical(0.71, 0.74)"
)
# The parts of each JSON form, in the order of its class's arguments; "readings" and "values" are lists.
PARAMETERS = {
    "normal": ("mean", "std"),
    "uniform": ("low", "high"),
    "triangular": ("low", "mode", "high"),
    "beta": ("alpha", "beta", "low", "high"),
    "lognormal": ("mean", "std"),
    "truncated": ("centre", "width", "low", "high"),
    "readings": ("readings",),
    "empirical": ("values",),
    "result": ("median", "low", "high", "coverage"),
}
WIDTHS = ("std", "width")
# Numbers without the unit of the others.
PURE = ("coverage", "alpha", "beta")
LISTS = ("readings", "values")


class UncertainValue(Value):
    """A number with its distribution; its nominal value is the mean, or that of the earlier result referred to."""

    def __init__(
        self,
        address: str,
        kind: Kind,
        distribution: d.Distribution,
        written: d.Distribution,
        unit: str,
        nominal: "tuple[float, float] | None" = None,
    ) -> None:
        si, displayed = nominal or (distribution.mean, written.mean)
        super().__init__(address, kind, si, displayed, unit)
        self.distribution = distribution
        self.written = written

    def echo(self) -> "Any":
        """The JSON form, which reads back: nominal value, unit, distribution and its parameters."""
        out = super().echo()
        return {**out, "distribution": self.written.name, **self.written.parameters()}


class Scale:
    """Conversion of the numbers of one text to SI, and to the one unit they are shown in.

    `angular` says whether a slope's numbers are angles (None before the first): the distribution is then the angle's.
    """

    def __init__(self, kind: Kind, default_unit: str, unit: str = "") -> None:
        self.kind = kind
        self.default_unit = unit or default_unit
        self.units: list[str] = []
        self.notes: list[str] = []
        self.angular: bool | None = None

    def location(self, text: str) -> "tuple[float, float]":
        """SI value and number as written, of a value on the parameter's own scale."""
        reading: Reading = read_scalar(text, self.kind, self.default_unit)
        if self.kind.form == "slope":
            angular = parse_unit(reading.unit).dimension == ANGLE
            if self.angular not in (None, angular):
                raise _mixed(text)
            self.angular = angular
            if angular:
                reading = read_scalar(text, Angle, self.default_unit)  # type: ignore[arg-type]
        self.units.append(reading.unit)
        self.notes += [note for note in reading.notes if note not in self.notes]
        return reading.si, reading.value

    def width(self, text: str, centre: float, shown: float) -> "tuple[float, float]":
        """The same for a difference; `3 %` of a centre with a dimension is relative to it."""
        amount = read_amount(text)
        if self.default_unit and len(amount.parts) == 1 and not amount.parts[0][2]:
            amount = read_amount(f"{text} {self.default_unit}")
        base_unit = parse_unit(self.kind.unit) if self.kind.unit else NUMBER
        numerator, denominator, unit = total(amount, base_unit)
        if self.kind.unit and unit.text.strip() == "%":
            fraction = nearest(numerator, denominator * 100)
            return abs(centre) * fraction, abs(shown) * fraction
        if self.angular:
            base_unit = parse_unit("rad")
        if self.kind.form == "slope" and (unit.dimension == ANGLE) != bool(self.angular):
            raise _mixed(text)
        if not conformable(unit, base_unit):
            message, hint = explain_mismatch(unit, base_unit)
            raise UsageError(message, code="kind", hint=hint)
        if not self.kind.unit and unit.text != (self.units[-1] if self.units else unit.text):
            raise _ambiguous(text)
        self.units.append(unit.text)
        si = nearest(numerator * unit.numerator, denominator * unit.denominator, unit.pi)
        return si, nearest(numerator, denominator)


def read_uncertain(kind: Kind, raw: "Any", address: str, default_unit: str) -> "tuple[UncertainValue, list[str]]":
    """Read a distribution from text or JSON: the parsed value and notes on its interpretation."""
    try:
        if isinstance(raw, dict):
            raw = without_parts(raw) if ";" in str(raw.get("unit")) else raw
            name, parts, scale = _from_object(kind, raw, default_unit)
        elif isinstance(raw, list):
            scale = Scale(kind, default_unit)
            name, parts = "readings", [[scale.location(_number(item)) for item in raw]]
        else:
            name, parts, scale = _from_text(kind, raw.strip(), default_unit)
        nominal = None
        if name == "result" and isinstance(raw, dict) and raw.get("value") is not None:
            nominal = scale.location(_number(raw["value"]))
        return _bind(kind, address, name, parts, scale, nominal), scale.notes
    except UsageError as error:
        error.hint = error.hint or f"uncertain values are written {FORMS}"
        raise


def _bind(
    kind: Kind, address: str, name: str, parts: "list[Any]", scale: Scale, nominal: "tuple[float, float] | None"
) -> UncertainValue:
    build = d.KINDS[name]
    try:
        si = build(*_column(parts, 0))
    except OverflowError:  # of readings: squared, the differences leave the range
        raise _too_large(address) from None
    if abs(si.mean) > LARGEST or LARGEST < si.std < inf:
        raise _too_large(address)
    units = set(scale.units)
    displayed, unit = si, "rad" if scale.angular else kind.unit
    if len(units) == 1:
        displayed, unit = build(*_column(parts, 1)), units.pop()
    distribution = d.Tangent(si) if scale.angular else si
    if nominal is not None:
        central = tan(nominal[0]) if scale.angular else nominal[0]
        nominal = central, nominal[1] if displayed is not si else central
    return UncertainValue(address, kind, distribution, displayed, unit, nominal)


def _too_large(address: str) -> UsageError:
    message = f"an uncertain value beyond {LARGEST:g} has no variance in the range of a double"
    return UsageError(message, parameter=address, code="range", hint="use a larger unit")


def _column(parts: "list[Any]", which: int) -> "list[Any]":
    return [[item[which] for item in part] if isinstance(part, list) else part[which] for part in parts]


def _from_text(kind: Kind, text: str, default_unit: str) -> "tuple[str, list[Any], Scale]":
    if text.startswith("["):
        inside, _, unit = text[1:].rpartition("]")
        return _listed("readings", inside, Scale(kind, default_unit, unit.strip()))
    head, opened, rest = text.partition("(")
    name = head.strip().lower()
    if opened and name in d.KINDS:
        inside, closed, unit = rest.rpartition(")")
        if not closed:
            raise UsageError(f"{text!r}: a closing ) is missing", code="syntax")
        scale = Scale(kind, default_unit, unit.strip())
        if name in ("readings", "empirical"):
            return _listed(name, inside, scale)
        return name, _arguments(name, inside, scale), scale
    for sign in PLUS_MINUS:
        if sign in text:
            scale = Scale(kind, default_unit)
            return "normal", _plus_minus(text, sign, scale), scale
    ends = [part.strip() for part in text.split("..")]
    if len(ends) not in (2, 3):
        raise UsageError(f"{text!r} is not a distribution", code="syntax")
    scale = Scale(kind, default_unit)
    return ("uniform", "triangular")[len(ends) - 2], [scale.location(end) for end in _shared(ends)], scale


def _listed(name: str, inside: str, scale: Scale) -> "tuple[str, list[Any], Scale]":
    return name, [[scale.location(item) for item in _shared(split_list(inside))]], scale


def _arguments(name: str, inside: str, scale: Scale) -> "list[Any]":
    items = split_list(inside)
    names = PARAMETERS[name]
    sign = next((sign for sign in PLUS_MINUS if sign in items[0]), "")
    if sign:
        _, _, tail = items[0].partition(sign)
        unit = _unit_of(items[-1]) or _unit_of(tail)
        first = items[0] if _unit_of(tail) or not unit else f"{items[0]} {unit}"
        rest = [scale.location(item if _unit_of(item) or not unit else f"{item} {unit}") for item in items[1:]]
        parts = [*_plus_minus(first, sign, scale), *rest]
    else:
        pure = sum(key in PURE for key in names)
        items = items[:pure] + _shared(items[pure:])
        parts = []
        for key, item in zip(names, items, strict=False):
            number_read = _pure(item) if key in PURE else None
            parts.append(number_read or (scale.width(item, *parts[0]) if key in WIDTHS else scale.location(item)))
    if len(items) + bool(sign) != len(names):
        raise UsageError(f"{name}({inside}) does not have the form {', '.join(names)}", code="syntax")
    return parts


def _plus_minus(text: str, sign: str, scale: Scale) -> "list[Any]":
    centre, _, width = (part.strip() for part in text.partition(sign))
    unit = _unit_of(width)
    if (whole := beside_share(unit)) and _unit_of(centre) in ("", whole):
        # 80 ± 1 % kg is 80 kg ± 1 %
        centre, width, unit = f"{centre.removesuffix(whole)} {whole}", width.removesuffix(whole), "%"
    if unit == "%" and not _unit_of(centre) and not scale.kind.unit and scale.kind.form != "slope":
        # of a share of at most one, 70 ± 5 % can only be 70 % ± 5 %; 1.2 ± 5 % may be a slip
        over, under, _ = read_amount(centre).parts[0]
        if over <= 10 * (scale.kind.high or inf) * under:
            raise _ambiguous(width)
    if unit[:1] == "%" != unit:
        raise UsageError(f"{width!r} is a share with a unit", code="ambiguous", hint="write for example 60 ft ± 5 %")
    # `1500 ± 50 kg`: the unit of both; `1500 kg ± 3 %` is relative.
    if not _unit_of(centre) and unit and not (unit == "%" and scale.kind.unit):
        centre = f"{centre} {unit}"
    elif _unit_of(centre) and not unit:
        width = f"{width} {_unit_of(centre)}"
    first = scale.location(centre)
    return [first, scale.width(width, *first)]


def _mixed(text: str) -> UsageError:
    hint = "write the whole distribution in one of them, for example -2 ± 0.5 deg or -3 ± 0.5 %"
    return UsageError(f"{text.strip()} mixes an angle with a rise over run", code="kind", hint=hint)


def _ambiguous(text: str) -> UsageError:
    return UsageError(
        f"{text.strip()} of a pure number may be a share of the value or a difference",
        code="ambiguous",
        hint="write both in the same way, for example 0.72 ± 0.04 or 72 % ± 4 %",
    )


def _shared(items: "list[str]") -> "list[str]":
    """Give the last item's unit to items without one."""
    unit = _unit_of(items[-1]) if items else ""
    return [item if _unit_of(item) or not unit else f"{item} {unit}" for item in items]


def _unit_of(text: str) -> str:
    """The unit of a text's last part."""
    return read_amount(text).parts[-1][2]


def _from_object(kind: Kind, raw: "dict[str, Any]", default_unit: str) -> "tuple[str, list[Any], Scale]":
    """`{"distribution": "uniform", "low": 20, "high": 25, "unit": "m"}`, a value with `std`, or an earlier result."""
    unit = str(raw.get("unit") or "")
    scale = Scale(kind, default_unit, unit)
    name = str(raw.get("distribution") or "")
    fields = dict(raw)
    if not name and raw.get("interval") is not None:
        name = "result"
        ends = raw["interval"]
        if not isinstance(ends, list) or len(ends) != 2:
            raise UsageError(f"read the interval {ends!r}, wanted its two ends", code="distribution")
        fields["low"], fields["high"] = ends
    elif not name:
        name = "normal"
    if name not in d.KINDS:
        hint = f"there is {', '.join(d.KINDS)}"
        raise UsageError(f"there is no distribution {name!r}", code="distribution", hint=hint)
    if name in ("normal", "lognormal") and fields.get("mean") is None:
        fields["mean"] = fields.get("value")
    parts: list[Any] = []
    for key in PARAMETERS[name]:
        value = fields.get(key)
        if value is None:
            raise UsageError(f"the {name} distribution needs {key}", code="missing")
        if isinstance(value, list) != (key in LISTS):
            expected = "a list of numbers" if key in LISTS else "one number"
            raise UsageError(f"read {key} {value!r}, wanted {expected}", code="distribution")
        if isinstance(value, list):
            parts.append([scale.location(_number(item)) for item in value])
        elif key in PURE:
            parts.append(_pure(_number(value)))
        elif key in WIDTHS:
            parts.append(scale.width(_number(value), *parts[0]))
        else:
            parts.append(scale.location(_number(value)))
    return name, parts, scale


def _pure(text: str) -> "tuple[float, float]":
    value = nearest(*read_number(text))
    return value, value


def _number(value: "Any") -> str:
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise UsageError(f"read {value!r}, wanted a number", code="number")
    return str(value) if isinstance(value, str) else repr(value)


def read_correlations(texts: "list[str]", known: "list[str]") -> "dict[tuple[str, str], float]":
    """`distance,friction=0.3`: two uncertain inputs by address, and the correlation of their normal scores."""
    correlations: dict[tuple[str, str], float] = {}
    for text in texts:
        names, equals, value = text.rpartition("=")
        pair = [name.strip().replace("-", "_") for name in names.split(",")]
        if not equals or len(pair) != 2 or not all(pair):
            hint = "for example --correlate distance,friction=0.3"
            raise UsageError(f"read {text!r}, wanted A,B=RHO", parameter="correlate", hint=hint)
        first, second = (_address(name, known) for name in pair)
        if (first, second) in correlations or (second, first) in correlations:
            raise UsageError(f"{first} and {second} are correlated twice", parameter="correlate")
        try:
            reading = read_scalar(value.strip(), Kind("correlation", "", low=-1.0, high=1.0, example="0.3"))
        except UsageError as error:
            error.parameter = "correlate"
            raise
        correlations[first, second] = reading.si
    return correlations


def _address(name: str, known: "list[str]") -> str:
    """An address, or the last part of one if it is unambiguous."""
    ending = [address for address in known if address.rpartition(".")[2] == name]
    return ending[0] if name not in known and len(ending) == 1 else name
