"""Units beyond the table, asked of pint in rational arithmetic; the only module that imports pint.

pint is asked for single names only: expressions, kinds and ambiguous names are handled here. Errors and types of pint
stay within this module.
"""

import functools
from fractions import Fraction

from dynamics_cli.core.units.conversion import lowest
from dynamics_cli.core.units.unit import Unit
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

BASES = ("meter", "gram", "second", "kelvin", "ampere", "mole", "candela", "radian")
ENERGY = (2, 1, -2, 0, 0, 0, 0, 0)
PINT_PI = Fraction("3.1415926535897932384626433832795028841971693993751")
LONGEST_NAME = 60


def lookup_in_pint(name: str) -> Unit | None:
    """Ask pint for one unit; None when pint does not know it, a refusal when it cannot be calculated with."""
    if len(name) > LONGEST_NAME or not name.replace("_", "a").replace("°", "a").isalnum():
        return None
    # pint raises a dozen kinds of error on odd names, including tokenizer errors and assertions.
    try:
        readings = registry().parse_unit_name(name)
    except Exception:
        return None
    if not readings:
        return None
    prefix, unit, _ = readings[0]
    if unit == "grade":
        raise UsageError(
            f"{name!r} is both a slope and 1/400 of a turn",
            code="ambiguous-unit",
            hint="write a slope in % or as an angle in deg, and 1/400 of a turn as gon",
        )
    try:
        factor, root = registry().get_root_units(registry().UnitsContainer({prefix + unit: 1}))
        converter = registry()._units[unit].converter
    except Exception:
        return None
    return _translated(name, prefix, unit, factor, dict(root._units), converter)


@functools.cache
def registry() -> "Any":
    """Pint's registry, created once."""
    import pint

    return pint.UnitRegistry(non_int_type=Fraction)


def _translated(name: str, prefix: str, unit: str, factor: "Any", powers: "dict[str, Any]", converter: "Any") -> Unit:
    powers.pop("count", None)
    if not getattr(converter, "is_multiplicative", True) and type(converter).__name__ != "OffsetConverter":
        raise _beyond(name, "a logarithmic unit")
    if any(Fraction(power).denominator != 1 for power in powers.values()) or powers.keys() - set(BASES):
        raise _beyond(name, "a unit outside mechanics and SI")
    if isinstance(factor, complex) or factor <= 0:
        raise _beyond(name, "not a positive quantity")
    dimension = tuple(int(powers.get(base, 0)) for base in BASES)
    offset = Fraction(getattr(converter, "offset", 0))
    if prefix and offset:
        raise _beyond(name, "a prefixed temperature scale")
    ratio, pi = _without_pi(Fraction(factor) / Fraction(1000) ** dimension[1])
    # How pint read a name is reported: `pli` is a picolink to it.
    notes: tuple[str, ...] = () if name == prefix + unit else (f"{name} read as {prefix}{unit}",)
    if not isinstance(factor, Fraction | int):
        notes += (f"{name} is known only approximately",)
    tag = "energy" if dimension == ENERGY and unit != "foot_pound" else ""
    return Unit(
        name,
        *lowest(ratio.numerator, ratio.denominator),
        dimension,
        pi=pi,
        offset=(offset.numerator, offset.denominator),
        tag=tag,
        notes=notes,
    )


def _without_pi(factor: Fraction) -> tuple[Fraction, int]:
    """Remove pint's 50-digit π, as the integer power that leaves the shortest ratio."""

    def height(power: int) -> int:
        rest = factor / PINT_PI**power
        return rest.numerator.bit_length() + rest.denominator.bit_length()

    power = min((0, 1, -1, 2, -2), key=height)
    return factor / PINT_PI**power, power


def _beyond(name: str, reason: str) -> UsageError:
    return UsageError(
        f"{name!r} is {reason}; it cannot be converted here",
        code="unknown-unit",
        hint="`dynamics units list` shows the units this program works with",
    )
