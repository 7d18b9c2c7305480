"""Formulas with a unit at their end (`20*t - 2*t^2 m`), and their variables (`a=3 m`)."""

from dynamics_cli.core.inputs.quantity_text import is_uncertain, number_end
from dynamics_cli.core.inputs.values import Bound, Constant, Fields, Value
from dynamics_cli.core.units.conversion import to_si
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.core.units.names import explain_mismatch
from dynamics_cli.core.units.unit import NUMBER, conformable
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.expressions import FUNCTIONS, begin, parse
from dynamics_cli.numerics.expressions.dimensions import VARIABLES
from dynamics_cli.quantities import Kind
from dynamics_cli.records import Formula, Let

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.core.inputs.context import Context

# A variable may not have a name that formulas already use.
TAKEN = (*FUNCTIONS, "pi", "t")


def read(text: str, kind: Kind, address: str, context: "Context", number: "Callable[..., Value]") -> Bound:
    """A formula, or a variable of formulas, as its kind says; `number` reads the value of a variable."""
    if kind.form == "let":
        return read_let(text, address, context, number)
    return Constant(read_formula(text, kind), text)


def read_formula(text: str, kind: Kind) -> Formula:
    """A formula of plain numbers with a unit at its end, or one whose numbers have their units."""
    try:
        return _with_a_unit(text, kind)
    except UsageError as error:
        known = _Units()
        try:
            parse(text, units=known)
        except UsageError:
            raise error from None
        if not known.units:
            raise
        hertz = [name for name in known.units if name.endswith("Hz")]
        if hertz and "pi" not in text:
            message = f"{text!r} has {hertz[0]}, which counts turns, but no 2*pi"
            raise UsageError(message, code="hertz", hint="write 2*pi*5 Hz*t, or 5 rad/s*t") from None
        units = tuple((name, *unit) for name, unit in known.units.items())
        return Formula(text.strip(), 1.0, kind.unit, units, _dimension(kind.unit))


class _Units:
    """Units by name, with their sizes in SI and their dimensions; `units` are those that were asked for."""

    def __init__(self) -> None:
        self.units: dict[str, tuple[float, tuple[int, ...]]] = {}

    def get(self, name: str) -> "tuple[float, tuple[int, ...]] | None":
        """The unit of that name, unless it is what tasks call a variable."""
        if name in VARIABLES or name in TAKEN:
            return None
        try:
            unit = parse_unit(name)
        except UsageError:
            return None
        if unit.offset[0]:
            return None
        self.units[name] = to_si(1, 1, unit), unit.dimension[:7]
        return self.units[name]


def _with_a_unit(text: str, kind: Kind) -> Formula:
    """A formula and its unit, whose factor to SI its numbers get."""
    body = begin(text)
    unit_text = text[body.end :].strip()
    base_unit = parse_unit(kind.unit) if kind.unit else NUMBER
    if not unit_text and kind.unit and body.text.strip() not in ("0", "0.0"):
        raise UsageError(
            f"{text!r} has no unit at its end", code="missing-unit", hint=f"write for example {kind.example}"
        )
    try:
        unit = parse_unit(unit_text, base_unit) if unit_text else base_unit
    except UsageError as error:
        raise UsageError(
            f"{unit_text!r} is neither a unit nor a continuation of the formula {text[: body.end]!r}",
            code=error.code,
            hint=f"write products with *, and the unit last: {kind.example}",
        ) from None
    if not conformable(unit, base_unit):
        message, _ = explain_mismatch(unit, base_unit)
        hint = f"write products with *, and the unit last: {kind.example}"
        raise UsageError(f"{text!r} is not {kind.about.partition(',')[0]}: {message}", code="kind", hint=hint)
    return Formula(text[: body.end].strip(), to_si(1, 1, unit), unit_text, (), base_unit.dimension[:7])


def _dimension(unit: str) -> "tuple[int, ...]":
    return (parse_unit(unit) if unit else NUMBER).dimension[:7]


def read_let(text: str, address: str, context: "Context", number: "Callable[..., Value]") -> Bound:
    """A variable and its value; the value is an input as any other, `let.NAME`, and may be uncertain."""
    name, equals, value = (part.strip() for part in text.partition("="))
    if not equals or not value or not name.isidentifier():
        raise UsageError(f"read {text!r}, wanted NAME=VALUE", code="syntax", hint="for example a=3 m")
    if name in TAKEN:
        raise UsageError(f"{name!r} already has a meaning in formulas", code="syntax", hint="choose another name")
    unit = _unit_of(value)
    kind = Kind("variable", unit, example="3 m", about="a variable of the formulas")
    let_address = f"{address.partition('[')[0]}.{name}"
    return _Let(name, unit, number(kind, value, let_address, context, ""), text.strip())


def _unit_of(text: str) -> str:
    if is_uncertain(text):
        from dynamics_cli.core.inputs.uncertain.vectors import trailing_unit

        return trailing_unit(text)
    return text[number_end(text, 0) :].strip()


class _Let(Fields):
    """A variable as read, shown as it was written."""

    def __init__(self, name: str, unit: str, value: Value, text: str) -> None:
        self.text = text
        super().__init__(Let, {
            "name": Constant(name, name), "value": value, "unit": Constant(unit, unit),
            "dimension": Constant(_dimension(unit), None),
        })  # fmt: skip

    def echo(self) -> "Any":
        """Name and value as written."""
        return self.text
