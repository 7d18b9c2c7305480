"""Units in words: the kind of a unit, why two do not fit, suggestions for a misspelt name, and the complete list.

Nothing here is needed to answer a correct call.
"""

from dynamics_cli.core.units.lookup import FORCE, candidates, table_unit
from dynamics_cli.core.units.table import NAMES, SYMBOL_PREFIXES, UNITS, WORD_PREFIXES
from dynamics_cli.core.units.unit import NONE, Unit, conformable
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

# Powers of length, mass, time, temperature, current, amount, luminosity and angle, trailing zeros dropped.
KINDS = {
    (): "pure number",
    (1,): "length",
    (2,): "area",
    (3,): "volume",
    (4,): "second moment of area",
    (-1,): "reciprocal length",
    (-2,): "distance per volume",
    (0, 1): "mass",
    (0, 0, 1): "time",
    (0, 0, 2): "time squared",
    (1, 0, -1): "speed",
    (2, 0, -2): "speed squared (energy per mass)",
    (1, 0, -2): "acceleration",
    (1, 0, -3): "jerk",
    (0, 0, -1): "frequency",
    (0, 0, -2): "frequency squared",
    (0, 0, 0, 0, 0, 0, 0, 1): "angle",
    (0, 0, -1, 0, 0, 0, 0, 1): "angular speed",
    (0, 0, -2, 0, 0, 0, 0, 1): "angular acceleration",
    (0, 0, 0, 0, 0, 0, 0, 2): "solid angle",
    (1, 1, -2): "force",
    (2, 1, -2): "torque or energy",
    (2, 1, -2, 0, 0, 0, 0, -1): "torsional stiffness",
    (2, 1, -3): "power",
    (1, 1, -1): "impulse or momentum",
    (2, 1, -1): "angular impulse or momentum",
    (2, 1): "moment of inertia",
    (-1, 1, -2): "pressure or stress",
    (-2, 1, -2): "weight density",
    (-3, 1): "density",
    (-2, 1): "areal density",
    (-1, 1): "linear density",
    (0, 1, -2): "stiffness (force per length)",
    (0, 1, -1): "damping (force per speed) or mass flow",
    (3, 0, -1): "volume flow",
    (-1, 1, -1): "dynamic viscosity",
    (2, 0, -1): "kinematic viscosity",
    (0, 0, 0, 1): "temperature",
    (0, 0, 0, -1): "reciprocal temperature",
    (0, 0, 0, 0, 1): "electric current",
    (0, 0, 1, 0, 1): "electric charge",
    (2, 1, -3, 0, -1): "voltage",
    (2, 1, -3, 0, -2): "electric resistance",
    (-2, -1, 3, 0, 2): "electric conductance",
    (-2, -1, 4, 0, 2): "capacitance",
    (2, 1, -2, 0, -2): "inductance",
    (2, 1, -2, 0, -1): "magnetic flux",
    (0, 1, -2, 0, -1): "magnetic flux density",
    (0, 0, 0, 0, 0, 1): "amount of substance",
    (0, 0, 0, 0, 0, 0, 1): "luminous intensity",
}
NAMED_SI = ("N", "W", "Pa", "V", "ohm", "S", "F", "H", "Wb", "T", "C")
ENERGY = (2, 1, -2, 0, 0, 0, 0, 0)
SYMBOLS = ("m", "kg", "s", "K", "A", "mol", "cd", "rad")
# Spellings to offer in addition to the names in the table.
OFTEN = (
    "mm km kg ms kN kJ kW kPa MPa mrad m/s km/h ft/s m/s^2 ft/s^2 rad/s deg/s rad/s^2 m^2 ft^2 in^2 m^3 in^3 "
    "kg*m^2 slug*ft^2 lb*ft^2 kg/m^3 lb/ft^3 slug/ft^3 N*m lbf*ft ft*lbf N*s lbf*s N/m lbf/in N*s/m 1/m 1/in "
    "N/m^3 lbf/ft^3 kg/m kg/m^2 mm^4 in^4 N*m*s 1/s cycle/min N*m/rad lbf*ft/deg m^3/s Pa*s m^2/s m/s^3 ft/s^3"
)


def kind_name(unit: Unit) -> str:
    """Name the kind of a unit: length, torque, angular speed; else by its SI base units."""
    if unit.tag:
        return unit.tag
    powers = unit.dimension
    while powers and not powers[-1]:
        powers = powers[:-1]
    return KINDS.get(powers) or f"quantity in {base_expression(unit.dimension)}"


def base_expression(dimension: tuple[int, ...]) -> str:
    """Write a dimension in SI base units: kg·m/s³, so that it parses back."""
    over = [_power(symbol, power) for symbol, power in zip(SYMBOLS, dimension, strict=True) if power > 0]
    under = [_power(symbol, -power) for symbol, power in zip(SYMBOLS, dimension, strict=True) if power < 0]
    if not under:
        return "·".join(over)
    return f"{'·'.join(over) or '1'}/{under[0] if len(under) == 1 else '(' + '·'.join(under) + ')'}"


def si_name(unit: Unit) -> str:
    """The coherent SI unit of a kind by its own name, N or J, else in base units; torque and energy keep apart."""
    if unit.dimension == ENERGY:
        return "N*m" if unit.tag == "torque" else "J"
    named = (table_unit(symbol)[0] for symbol in NAMED_SI)
    same = (other.text for other in named if other.dimension == unit.dimension)
    return next(same, "") or base_expression(unit.dimension) or "1"


def explain_mismatch(a: Unit, b: Unit) -> tuple[str, str]:
    """Explain a mismatch of two units: a message and a hint.

    `a`: the unit read; `b`: the unit expected.
    """
    first, second = _kinds(a), _kinds(b)
    message = f"{_named(a)} is {_article(first)}, {_named(b)} is {_article(second)}"
    return message, _special_hint(a, b) or _offer(b)


def conformable_names(unit: Unit) -> list[str]:
    """Name the units that values in `unit` can be converted to, the usual ones first."""
    names = [text for text in OFTEN.split() if any(conformable(other, unit) for other in candidates(text))]
    names += [symbol for symbol, _, other, _ in all_units() if conformable(other, unit) and symbol[0] != "1"]
    return names


def all_units() -> "Iterator[tuple[str, tuple[str, ...], Unit, str]]":
    """List the table: symbol, all names, the unit, and a description."""
    names: dict[str, list[str]] = {}
    for entry in NAMES.split():
        name, symbols, _ = entry.split("|")
        for symbol in symbols.split("+"):
            names.setdefault(symbol, []).append(name)
    for line in UNITS.strip().splitlines():
        symbol = line[1 : line.index("|")]
        unit, description = table_unit(symbol)
        yield symbol, tuple(names[symbol]), unit, description


def _kinds(unit: Unit) -> str:
    """Kind of a unit, all of them where its text has several readings."""
    try:
        readings = candidates(unit.text)
    except UsageError:
        readings = [unit]
    if not any(other.dimension == unit.dimension for other in readings):
        readings = [unit]
    return " or ".join(dict.fromkeys(kind_name(other) for other in readings))


def _named(unit: Unit) -> str:
    return unit.text.strip() or "a number without a unit"


def _article(kind: str) -> str:
    return f"{'an' if kind[0] in 'aeiou' else 'a'} {kind}"


def _power(symbol: str, power: int) -> str:
    return symbol if power == 1 else f"{symbol}^{power}"


def _offer(unit: Unit) -> str:
    if unit.dimension == NONE:
        return "a pure number is wanted: write it without a unit, or in %"
    names = conformable_names(unit)[:8]
    return f"units of {_article(kind_name(unit))}: {', '.join(names)}" if names else f"wanted is {unit.text}"


def _special_hint(a: Unit, b: Unit) -> str:
    if a.text.strip() in ("C", "F") and b.dimension == (0, 0, 0, 1, 0, 0, 0, 0):
        return f"{a.text.strip()} alone is electrical; a temperature is written deg{a.text.strip()}"
    gap = tuple(x - y for x, y in zip(a.dimension, b.dimension, strict=True))
    for mass, other, sign in ((a, b, -1), (b, a, 1)):
        if (
            "kg" in mass.text
            and other.dimension[1] == 1
            and gap == (sign, 0, -2 * sign, 0, 0, 0, 0, 0)
            and other.dimension != FORCE
        ):
            return f"kg is a mass here: as a force write {mass.text.strip().replace('kg', 'kgf', 1)}"
    angle = (0, 0, 0, 0, 0, 0, 0, 1)
    if gap in (angle, tuple(-x for x in angle)):
        special = b if b.dimension[7] else a
        if special.dimension == (0, 0, -1, 0, 0, 0, 0, 1):
            turning = "write rev/s, rpm or rad/s for an angular speed, Hz or 1/s for a frequency"
            return f"a cycle is not an angle: {turning}"
        if special.dimension == angle:
            return "write an angle with its unit (deg, rad, rev), a ratio without one"
        return "an angle is a dimension of its own here: write or leave out rad on both sides"
    if a.dimension == b.dimension:
        return "a torque is written force first (N*m, lbf*ft), an energy J or length first (ft*lbf)"
    if {a.dimension, b.dimension} == {(1, 1, -2, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0, 0, 0)}:
        return "weight is a force (N, lbf, kgf), mass is not (kg, lb, slug); `dynamics convert --weight` goes between"
    return ""


def prefixes() -> "Iterator[tuple[str, int]]":
    """List the SI prefixes, symbols and words, with their powers of ten."""
    for table in (SYMBOL_PREFIXES, WORD_PREFIXES):
        for entry in table.split():
            prefix, exponent = entry.split("|")
            yield prefix, int(exponent)
