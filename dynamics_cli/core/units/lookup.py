"""Definition of a unit by name or expression: from a generated table without imports, else once from pint."""

from dynamics_cli.core.units.conversion import lowest
from dynamics_cli.core.units.table import NAMES, SYMBOL_PREFIXES, UNITS, WORD_PREFIXES
from dynamics_cli.core.units.unit import NONE, NUMBER, Unit, conformable
from dynamics_cli.errors import UsageError

FORCE = (1, 1, -2, 0, 0, 0, 0, 0)
LENGTH = (1, 0, 0, 0, 0, 0, 0, 0)
# No useful unit comes near 10^±2400; a power of a prefixed unit could, and would cost time and memory.
MOST_BITS = 8000
# Texts of units come from files of millions of rows; the caches must not grow with them.
CACHE_SIZE = 2048
LONGEST_IN_CAPITALS = 24
# Units read without the grammar.
LONGEST_PLAIN = 40
POWERS = frozenset("23456789")


# Units with two readings whose usual one needs no note.
SELDOM_OTHERWISE = ("g", "C", "F")

_candidates: "dict[str, list[Unit]]" = {"": [NUMBER], "1": [NUMBER]}
_names: "dict[str, tuple[Unit, ...]]" = {}


def parse_unit(text: str, wanted: "Unit | None" = None, tag: str = "") -> Unit:
    """Read a unit; where it has several readings, take the one that `wanted` (or the tag alone) allows.

    `lb` and `oz` are masses unless a force fits and a mass does not, `g` is the gram unless an acceleration fits.
    The unit's `notes` say so for `lb` and `oz` in either reading, for `g` only when it is gravity, since a gram is
    clear. A unit that does not fit is returned as well, for the caller to explain.
    """
    readings = candidates(text)
    if len(readings) > 1 or wanted is not None or tag:
        for unit in readings:
            fits = wanted is None or conformable(unit, wanted)
            if fits and not (tag and unit.tag and unit.tag != tag):
                return unit
    return readings[0]


def parse_pair(source: str, target: str) -> tuple[Unit, Unit]:
    """Read two units that are to be converted, each reading chosen to fit the other: `lb` to `N` makes it a force."""
    sources, targets = candidates(source), candidates(target)
    for first in sources:
        for second in targets:
            if conformable(first, second):
                return first, second
    return sources[0], targets[0]


def candidates(text: str) -> list[Unit]:
    """Every reading of a unit's text, the default one first."""
    readings = _candidates.get(text)
    if readings is None:
        readings = _read(text)
        if len(_candidates) >= CACHE_SIZE:
            _candidates.clear()
        _candidates[text] = readings
    return readings


def lookup(name: str) -> tuple[Unit, ...]:
    """Every reading of one unit's name: from the table, by SI prefix, or from pint; () when unknown."""
    readings = _names.get(name)
    if readings is None:
        readings = _from_table(name) or _in_other_case(name) or _from_pint(name)
        if len(_names) >= CACHE_SIZE:
            _names.clear()
        _names[name] = readings
    return readings


def in_table(name: str) -> tuple[str, str] | None:
    """Find a name in the table: its symbols, joined by "+", and its prefix flags."""
    start = NAMES.find(f" {name}|")
    if start < 0:
        return None
    symbols, flags = NAMES[start + len(name) + 2 : NAMES.index(" ", start + 1)].split("|")
    return symbols, flags


def table_unit(symbol: str) -> tuple[Unit, str]:
    """Read one line of the table: the unit under its symbol, and its description."""
    start = UNITS.index(f"\n={symbol}|") + 2
    fields = UNITS[start : UNITS.index("\n", start)].split("|")
    powers = tuple(map(int, fields[4].split(",")))
    up, _, down = fields[5].partition("/")
    offset = (int(up), int(down)) if up else (0, 1)
    dimension = powers if len(powers) == 8 else (*powers, 0, 0, 0, 0, 0)
    unit = Unit(symbol, int(fields[1]), int(fields[2]), dimension, pi=int(fields[3]), offset=offset, tag=fields[6])
    return unit, fields[7]


def _read(text: str) -> list[Unit]:
    # Most units are a name, or a few multiplied, or these over another, and need no grammar.
    plain = text.strip()
    if (plain.isalpha() or plain == "%") and (entry := in_table(plain)):
        return [_renamed(unit, text) for unit in _readings(plain, entry[0])]
    factors_read = _plain_factors(plain)
    if not factors_read:
        from dynamics_cli.core.units.expressions import factors

        factors_read = factors(plain) if plain else []
    readings: list[dict[str, Unit]] = [{}]
    for name, power in dict.fromkeys(factors_read):
        if name in readings[0]:
            continue
        units = _in_capitals(name, power, plain) or lookup(name)
        if not units and " " in plain and (units := lookup("_".join(plain.split()))):
            return [_renamed(unit, text) for unit in units]
        if not units:
            raise _unknown(name, text)
        # One name has one reading throughout an expression.
        readings = [{**chosen, name: unit} for chosen in readings for unit in units]
    return [_combined(text, factors_read, chosen) for chosen in readings]


def _plain_factors(text: str) -> list[tuple[str, int]]:
    """The factors of `m/s^2`, `kg*m^2` or `1/s`: names with single digits as powers; none where there is more."""
    over, slash, under = text.replace("²", "^2").replace("³", "^3").replace("·", "*").partition("/")
    parts = [] if slash and over == "1" else [(factor, 1) for factor in over.split("*")]
    if slash:
        parts.append((under, -1))
    read = []
    for factor, sign in parts:
        name, raised, power = factor.partition("^")
        if len(text) > LONGEST_PLAIN or not name.isalpha() or name == "per" or (raised and power not in POWERS):
            return []
        read.append((name, sign * int(power or 1)))
    return read


def _renamed(unit: Unit, text: str) -> Unit:
    return Unit(
        text, unit.numerator, unit.denominator, unit.dimension,
        pi=unit.pi, offset=unit.offset, tag=unit.tag, notes=unit.notes,
    )  # fmt: skip


def _combined(text: str, factors_read: list[tuple[str, int]], chosen: dict[str, Unit]) -> Unit:
    if len(factors_read) == 1 and factors_read[0][1] == 1:
        return _renamed(chosen[factors_read[0][0]], text)
    numerator = denominator = 1
    pi = 0
    dimension: tuple[int, ...] = NONE
    notes: tuple[str, ...] = ()
    for name, power in factors_read:
        unit = chosen[name]
        # Within an expression a degree is one of difference: BTU/(h*ft*degF).
        up, down = (unit.numerator, unit.denominator) if power > 0 else (unit.denominator, unit.numerator)
        numerator *= up ** abs(power)
        denominator *= down ** abs(power)
        if numerator.bit_length() > MOST_BITS or denominator.bit_length() > MOST_BITS:
            raise UsageError(f"{text!r} is too large or too small a unit", code="range", hint="use fewer prefixes")
        pi += unit.pi * power
        dimension = tuple([a + b * power for a, b in zip(dimension, unit.dimension, strict=True)])
        notes += tuple(note for note in unit.notes if note not in notes)
    return Unit(
        text, *lowest(numerator, denominator), dimension, pi=pi, tag=_product_tag(factors_read, chosen), notes=notes
    )


def _product_tag(factors_read: list[tuple[str, int]], chosen: dict[str, Unit]) -> str:
    """A force times a length, in this order, is a torque; the book writes `ft lb` for torque and energy alike."""
    if len(factors_read) == 2 and factors_read[0][1] == 1 and factors_read[1][1] == 1:
        first, second = (chosen[name] for name, _ in factors_read)
        if first.dimension == FORCE and second.dimension == LENGTH:
            return "torque"
    return ""


def _readings(name: str, symbols: str) -> tuple[Unit, ...]:
    units = []
    for symbol in symbols.split("+"):
        unit, description = table_unit(symbol)
        notes: tuple[str, ...] = ()
        if (symbol != symbols and symbol not in SELDOM_OTHERWISE) or ";" in description:
            notes = (f"{name} read as {description}",)
        units.append(_renamed(unit, name))
        units[-1].notes = notes
    return tuple(units)


def _from_table(name: str) -> tuple[Unit, ...]:
    if entry := in_table(name):
        return _readings(name, entry[0])
    for prefixes, lengths, flag in ((SYMBOL_PREFIXES, (1, 2), "s"), (WORD_PREFIXES, (3, 4, 5, 6), "w")):
        for length in lengths:
            start = prefixes.find(f" {name[:length]}|")
            if start < 0 or len(name) <= length:
                continue
            entry = in_table(name[length:])
            if entry and flag in entry[1]:
                exponent = int(prefixes[start + length + 2 : prefixes.index(" ", start + 1)])
                return (_prefixed(name, exponent, entry[0].partition("+")[0]),)
    return ()


def _prefixed(name: str, exponent: int, symbol: str) -> Unit:
    unit, description = table_unit(symbol)
    up, down = (10**exponent, 1) if exponent > 0 else (1, 10**-exponent)
    factor = lowest(unit.numerator * up, unit.denominator * down)
    notes = (f"{name}: {symbol} read as {description}",) if ";" in description else ()
    return Unit(name, *factor, unit.dimension, pi=unit.pi, tag=unit.tag, notes=notes)


def _in_other_case(name: str) -> tuple[Unit, ...]:
    """A name in other capitals: Pounds, KG, kpa. Lower case is preferred; an ambiguous name is refused."""
    if not (name.isascii() and name.replace("_", "").isalpha() and 2 <= len(name) <= LONGEST_IN_CAPITALS):
        return ()
    from dynamics_cli.core.units.near_names import names_in_other_case

    names = names_in_other_case(name)
    lower = name.lower()
    readings = {name_: _from_table(name_)[0] for name_ in names}
    plain = [unit.text for unit in readings.values()]
    if lower in readings and not any(unit.dimension != readings[lower].dimension for unit in readings.values()):
        plain = [lower]
    meanings = {(unit.numerator, unit.denominator, unit.dimension) for unit in map(readings.get, plain) if unit}
    if len(meanings) > 1:
        several = " or ".join(plain)
        raise UsageError(f"{name!r} may be {several}", code="ambiguous-unit", hint=f"write {several}")
    return tuple(_with_note(unit, name, plain[0]) for unit in (_from_table(plain[0]) if plain else ()))


def _in_capitals(name: str, power: int, text: str) -> tuple[Unit, ...]:
    """The M of M/S and the S and H below a KM/H are metres, seconds and hours where all is written in capitals."""
    if len(name) > 1 or len(text) < 3 or text.upper() != text or not (name in "MG" or (name in "SH" and power < 0)):
        return ()
    return tuple(_with_note(unit, name, name.lower()) for unit in _from_table(name.lower())[:1])


def _with_note(unit: Unit, name: str, known: str) -> Unit:
    renamed = _renamed(unit, name)
    renamed.notes = unit.notes or (f"{name} read as {known}",)
    return renamed


def _from_pint(name: str) -> tuple[Unit, ...]:
    # c, e, k, u and the year `a` of pint would turn a typing error into an answer.
    if len(name) < 2:
        return ()
    from dynamics_cli.core.units.fallback import lookup_in_pint

    unit = lookup_in_pint(name)
    if unit is None or (unit.notes and _is_transposed(name)):
        return ()
    return (unit,)


def _is_transposed(name: str) -> bool:
    """Whether a name is a known one with letters exchanged: mhp is a misspelt mph, not a millihorsepower."""
    from dynamics_cli.core.units.near_names import names_like

    return len(name) > 2 and any(sorted(near) == sorted(name) for near in names_like(name))


def _unknown(name: str, text: str) -> UsageError:
    from dynamics_cli.core.units.expressions import show
    from dynamics_cli.core.units.near_names import names_like

    near = names_like(name)
    hint = f"did you mean {' or '.join(near[:3])}?" if near else "`dynamics units search WORD` finds units by name"
    within = "" if name == text.strip() else f" (in {show(text)})"
    return UsageError(f"unknown unit {show(name)}{within}", code="unknown-unit", hint=hint)
