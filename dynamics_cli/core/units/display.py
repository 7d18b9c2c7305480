"""Results in the units they are shown in: the caller's `--to`, else the kind's unit of the chosen system."""

import math

from dynamics_cli.core.units.conversion import convert, from_si, nearest
from dynamics_cli.core.units.lookup import parse_pair, parse_unit
from dynamics_cli.core.units.unit import Unit, conformable
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Kind
from dynamics_cli.records import Measured

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

UNIT_ROUNDOFF = 2.0**-53
RADIAN = parse_unit("rad")
# Below a tenth of a kilojoule a joule reads better, below a tenth of a metre a millimetre.
SMALL, SMALL_LENGTH = 100.0, 0.1
_PRETTY = (("^2", "²"), ("^3", "³"), ("^4", "⁴"), ("*", "·"))


def pretty(unit: str) -> str:
    """A unit as a document shows it: `kg·m²`; it parses back."""
    for plain, symbol in _PRETTY:
        unit = unit.replace(plain, symbol)
    return unit


class Shown:
    """The unit of one result, and the conversion of its SI value to the number shown."""

    __slots__ = ("compound", "kind", "text", "unit")

    def __init__(self, kind: Kind, text: str) -> None:
        self.kind = kind
        self.text = pretty(text)
        self.compound: tuple[Unit, ...] = ()
        self.unit: Unit | None = None
        if ";" in text:
            from dynamics_cli.core.units.compound import parse_compound

            self.compound = parse_compound(text)
            self._check(self.compound[0])
        elif text != kind.unit:
            base_unit = parse_unit(kind.unit) if kind.unit else None
            self.unit = parse_unit(text, base_unit)
            self._check(self.unit)

    def _check(self, unit: Unit) -> None:
        base_unit = parse_unit(self.kind.unit)
        if conformable(unit, base_unit) or self._is_angle_of_slope(unit):
            return
        from dynamics_cli.core.units.names import explain_mismatch

        message, hint = explain_mismatch(unit, base_unit)
        raise UsageError(f"a {self.kind.name} cannot be shown in {unit.text}: {message}", parameter="to", hint=hint)

    def _is_angle_of_slope(self, unit: Unit) -> bool:
        return self.kind.form == "slope" and unit.dimension == RADIAN.dimension

    @property
    def bound_unit(self) -> str:
        """The unit a bound is stated in: of compound units, the last part's."""
        return pretty(self.compound[-1].text) if self.compound else self.text

    def value(self, si: float) -> "float | list[float]":
        """The number shown for an SI value."""
        if self.compound:
            from dynamics_cli.core.units.compound import from_si_compound

            return list(from_si_compound(si, self.compound))
        if self.unit is None:
            return si
        return from_si(math.atan(si) if self._is_angle_of_slope(self.unit) else si, self.unit)

    def width(self, si: float) -> float:
        """A difference of SI values, in the unit shown (of compound units, in the last part's)."""
        unit = self.compound[-1] if self.compound else self.unit
        if unit is None:
            return si
        return si * (unit.denominator / unit.numerator) / math.pi**unit.pi

    def deviation(self, si: float) -> "float | list[float]":
        """A standard deviation as a document shows it: of compound units in parts, as the value is."""
        return self.value(si) if self.compound else self.width(si)

    def spread(self, si: float, error: float) -> float:
        """Error bound of the value shown: of the SI value and of the conversion."""
        if self.unit is None and not self.compound:
            return error
        size = si
        if self.unit is not None and self._is_angle_of_slope(self.unit):
            error, size = error / (1.0 + si * si) + 2.0 * UNIT_ROUNDOFF * abs(math.atan(si)), math.atan(si)
        value = abs(self.width(size))
        return (self.width(error) + UNIT_ROUNDOFF * value) * (1.0 + 1e-9) + (5e-324 if 0.0 < value < 1e-290 else 0.0)


class Display:
    """The unit in which each result is shown; `by_size` a small one without the kilo of its kind, or in mm."""

    def __init__(self, system: str, to: "Mapping[str, str]", *, by_size: bool = False) -> None:
        self.system = system
        self.to = dict(to)
        self.by_size = by_size
        self.used: set[str] = set()
        self._refused: dict[str, UsageError] = {}
        self._made: dict[tuple[str, int], Shown] = {}

    def of(self, address: str, kind: Kind, size: float = 0.0) -> Shown:
        """How the result at `address` (without indices) is shown; its size counts when it is first asked for."""
        key = (address, id(kind))
        if key not in self._made:
            self._made[key] = self._make(address, kind, size)
        return self._made[key]

    def _make(self, address: str, kind: Kind, size: float) -> Shown:
        for name in (address, address.rpartition(".")[2], *self._indexed(address)):
            if name in self.to:
                try:
                    shown = Shown(kind, self.to[name])
                except UsageError as error:
                    error.parameter = "to"
                    # A last name alone may match several results: those that the unit fits.
                    if name == address or "[" in name:
                        raise
                    self._refused[name] = error
                    continue
                self.used.add(name)
                return shown
        text = kind.shown_in(self.system)
        if self.by_size and 0.0 < abs(size) < SMALL and text == f"k{kind.unit}":
            text = kind.unit
        if self.by_size and 0.0 < abs(size) < SMALL_LENGTH and text == "m":
            text = "mm"
        return Shown(kind, text)

    def of_measured(self, address: str, measured: Measured) -> Measured:
        """A result with its own unit, in the caller's unit if one is requested."""
        text = self.to.get(address)
        if text is not None:
            self.used.add(address)
        elif measured.inherited and self.system == "base":
            from dynamics_cli.core.units.names import base_expression

            text = base_expression(parse_unit(measured.unit).dimension)
        if text is None or text == measured.unit or isinstance(measured.value, tuple):
            return measured
        source, target = parse_pair(measured.unit, text)
        if not conformable(source, target):
            from dynamics_cli.core.units.names import explain_mismatch

            message, hint = explain_mismatch(source, target)
            raise UsageError(f"{address} cannot be shown in {text}: {message}", parameter="to", hint=hint)
        exact = convert(*measured.value.as_integer_ratio(), source, target)
        return Measured(nearest(*exact), text)

    def _indexed(self, address: str) -> "list[str]":
        """The caller's names for one cell of this column, `surfaces[0].time`: a column is shown in one unit."""
        return [name for name in self.to if "[" in name and _without_indices(name) == address]

    def check(self, known: "list[str]") -> None:
        """Refuse a `--to` that names no result."""
        for name in self.to:
            if name not in self.used:
                if name in self._refused:
                    raise self._refused[name]
                from dynamics_cli.core.units.near_names import instead_of

                raise UsageError(
                    f"there is no result {name!r}", parameter="to", hint=instead_of(name, known), code="unknown-result"
                )


def _without_indices(address: str) -> str:
    return ".".join(part.partition("[")[0] for part in address.split("."))


def round_up(bound: float) -> float:
    """A bound rounded up to two digits."""
    return float(f"{bound * 1.06:.1e}") if bound > 1e-290 else bound


def round_condition(number: float) -> float:
    """A condition number in six digits."""
    return float(f"{number:.6g}") + 0.0
