"""Results in the units they are shown in: the caller's `--to`, else the kind's unit of the chosen system."""

from dynamics_cli.core.units import Unit, conformable, explain_mismatch, from_si, parse_unit
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Kind

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

_PRETTY = (("^2", "²"), ("^3", "³"), ("^4", "⁴"), ("*", "·"))


def pretty(unit: str) -> str:
    """A unit as a document shows it: `kg·m²`; it parses back."""
    for plain, shown in _PRETTY:
        unit = unit.replace(plain, shown)
    return unit


class Shown:
    """The unit of one result, and how its SI value becomes the number shown."""

    __slots__ = ("compound", "kind", "text", "unit")

    def __init__(self, kind: Kind, text: str) -> None:
        self.kind = kind
        self.text = pretty(text)
        self.compound: tuple[Unit, ...] = ()
        self.unit: Unit | None = None
        if ";" in text:
            from dynamics_cli.core.units import parse_compound

            self.compound = parse_compound(text)
            self._check(self.compound[0])
        elif text != kind.unit:
            wanted = parse_unit(kind.unit) if kind.unit else None
            self.unit = parse_unit(text, wanted)
            self._check(self.unit)

    def _check(self, unit: Unit) -> None:
        wanted = parse_unit(self.kind.unit)
        if self.kind.form == "slope" and unit.text in ("deg", "rad", "°"):
            return
        if not conformable(unit, wanted):
            message, hint = explain_mismatch(unit, wanted)
            raise UsageError(f"a {self.kind.name} cannot be shown in {unit.text}: {message}", parameter="to", hint=hint)

    @property
    def converts(self) -> bool:
        """Whether showing rounds once more."""
        return self.unit is not None or bool(self.compound)

    def value(self, si: float) -> "float | list[float]":
        """The number shown for an SI value."""
        if self.compound:
            from dynamics_cli.core.units import from_si_compound

            return list(from_si_compound(si, self.compound))
        if self.unit is None:
            return si
        if self.kind.form == "slope" and self.unit.text != "%":
            from math import atan

            si = atan(si)
        return from_si(si, self.unit)

    def width(self, si_width: float) -> float:
        """A difference of SI values, in the unit shown."""
        if self.unit is None or self.compound:
            return si_width
        return si_width * (self.unit.denominator / self.unit.numerator) / 3.141592653589793**self.unit.pi


class Display:
    """Which unit each result is shown in."""

    def __init__(self, system: str, to: "Mapping[str, str]") -> None:
        self.system = system
        self.to = dict(to)
        self.used: set[str] = set()
        self._made: dict[tuple[str, int], Shown] = {}

    def of(self, address: str, kind: Kind) -> Shown:
        """How the result at `address` (without indices) is shown."""
        key = (address, id(kind))
        if key not in self._made:
            self._made[key] = self._make(address, kind)
        return self._made[key]

    def _make(self, address: str, kind: Kind) -> Shown:
        for name in (address, address.rpartition(".")[2]):
            if name in self.to:
                self.used.add(name)
                try:
                    return Shown(kind, self.to[name])
                except UsageError as error:
                    error.parameter = "to"
                    raise
        return Shown(kind, kind.shown_in(self.system))

    def check(self, known: "list[str]") -> None:
        """Refuse a `--to` that names no result."""
        for name in self.to:
            if name not in self.used:
                raise UsageError(
                    f"there is no result {name!r}",
                    parameter="to",
                    hint=f"results are {', '.join(known)}",
                    code="unknown-result",
                )


def round_up(bound: float) -> float:
    """A bound in two digits, never below itself."""
    return float(f"{bound * 1.06:.1e}")


def round_condition(number: float) -> float:
    """A condition number in six digits."""
    return float(f"{number:.6g}") + 0.0


def plain(value: "Any") -> "Any":
    """The float in a tracked number."""
    return getattr(value, "value", value)
