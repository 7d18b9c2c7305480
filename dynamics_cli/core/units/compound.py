"""Compound units: 5 ft 6 in, 3 deg 20 min 5 s, as numbers of several units that add up to one value.

Every part carries the sign, so the parts always add up: −5.5 ft is (−5, −6) in `ft;in`. All parts but the last are
whole numbers (`int`); a last part that rounds up to a whole larger unit is carried over.
"""

from dynamics_cli.core.units.conversion import convert, is_offset, lowest, nearest, ratio_of, to_si
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.core.units.unit import Unit, conformable
from dynamics_cli.errors import FaultError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

ANGLE = (0, 0, 0, 0, 0, 0, 0, 1)
TIME = (0, 0, 1, 0, 0, 0, 0, 0)
# After degrees these are parts of a degree, not of an hour.
ARC = {
    **dict.fromkeys(("min", "mins", "minute", "minutes"), "arcmin"),
    **dict.fromkeys(("s", "sec", "secs", "second", "seconds"), "arcsec"),
}
MOST_DECIMALS = 20
PI_DIGITS_LEAST = 40


def parse_compound(text: str) -> tuple[Unit, ...]:
    """Read `ft;in` or `deg;min;s`: conformable units, each smaller than the one before; one unit alone is allowed."""
    words = [word.strip() for word in text.split(";")]
    if not all(words):
        raise UsageError(f"a unit is missing in {text!r}", code="unit-syntax", hint="example: ft;in")
    units = [parse_unit(words[0])]
    for word in words[1:]:
        units.append(part_unit(word, units[0]))
        larger, smaller = units[-2], units[-1]
        if is_offset(larger) or is_offset(smaller):
            raise UsageError(
                f"a temperature cannot have several parts: {text!r}", code="unit-syntax", hint="name one unit"
            )
        if not is_smaller(smaller, larger):
            raise UsageError(
                f"{smaller.text} is not smaller than {larger.text} in {text!r}",
                code="unit-syntax",
                hint="put the larger unit first: ft;in",
            )
    return tuple(units)


def part_unit(text: str, first: Unit) -> Unit:
    """Read the unit of a further part; after an angle `min` and `s` are minutes and seconds of arc."""
    if first.dimension == ANGLE:
        text = ARC.get(text, text)
    elif first.dimension == TIME and text == "m":
        text = "min"
    unit = parse_unit(text, first)
    if not conformable(unit, first):
        from dynamics_cli.core.units.names import explain_mismatch

        message, hint = explain_mismatch(unit, first)
        together = f"{first.text} and {unit.text} cannot both be parts of one value"
        raise UsageError(f"{together}: {message}", code="kind", hint=hint)
    return unit


def is_smaller(a: Unit, b: Unit) -> bool:
    """Whether unit `a` is smaller than its conformable unit `b`."""
    numerator, denominator, pi = convert(1, 1, a, b)
    # With π in the ratio the two cannot be equal, and no pair of units is too close for a double.
    return numerator < denominator if not pi else nearest(numerator, denominator, pi) < 1.0


def joined(
    parts: tuple[tuple[int, int, str], ...], wanted: Unit | None = None, *, added: bool = False
) -> tuple[int, int, Unit]:
    """Add up the parts of `5 ft 6 in`: the exact number of the last part's unit, which it returns too.

    Every part carries its sign. Refused are parts that do not fit together and, unless `added` by a plus, parts that
    are not whole (except the last), that do not decrease, or that exceed one of the part before.
    """
    if not all(text for *_, text in parts):
        raise UsageError("a number has no unit", code="missing-unit", hint="write 5 ft 6 in")
    units = [parse_unit(parts[0][2], wanted)]
    units += [part_unit(text, units[0]) for *_, text in parts[1:]]
    if any(is_offset(unit) for unit in units):
        raise UsageError("a temperature cannot have several parts", code="syntax", hint="write one number and one unit")
    last = units[-1]
    up, down = 0, 1
    for index, (numerator, denominator, text) in enumerate(parts):
        if index and not added and not is_smaller(units[index], units[index - 1]):
            smaller = f"{text} is not smaller than {parts[index - 1][2]}"
            raise UsageError(smaller, code="syntax", hint="put the larger unit first: 5 ft 6 in")
        if index < len(parts) - 1 and not added and numerator % denominator:
            hint = "only the last part may have a fraction"
            raise UsageError(f"the number of {text} is not whole", code="syntax", hint=hint)
        over, under = _size(units[index], last)
        if index and not added:
            larger, larger_under = _size(units[index - 1], last)
            if abs(numerator) * over * larger_under >= denominator * under * larger:
                excess = f"that many {text} are more than one {parts[index - 1][2]}"
                raise UsageError(
                    excess,
                    code="syntax",
                    hint="write all of it in the smaller unit, or join the parts by a plus: 5 ft + 14 in",
                )
        up, down = up * denominator * under + numerator * over * down, down * denominator * under
    return *lowest(up, down), last


def from_si_compound(value_si: float, units: tuple[Unit, ...]) -> tuple[float, ...]:
    """Split an SI value into parts.

    The last part is the shortest decimal for which the parts together round to the very double given, as `repr` does
    for one number: the double next to 5.5 ft is 5 ft 6 in, not 5 ft 6.000000000000004 in.
    """
    last = units[-1]
    numerator, denominator = ratio_of(value_si)
    total, down = _times_inverse(numerator, denominator, last)
    for decimals in range(MOST_DECIMALS + 1):
        scale = 10**decimals
        shortest = _rounded(total * scale, down)
        if shortest and to_si(shortest, scale, last) == value_si:
            return _split(shortest, scale, units)
    return _split(total, down, units)


def from_exact_compound(numerator: int, denominator: int, source: Unit, units: tuple[Unit, ...]) -> tuple[float, ...]:
    """Split an exact number of `source` into parts; the last part is rounded once."""
    up, down, pi = convert(numerator, denominator, source, units[-1])
    if pi:
        up, down = _with_pi_to(up, down, pi)
    return _split(up, down, units)


def in_last_unit(parts: "Sequence[float]", text: str) -> float:
    """The parts of `ft;in` as a number of inches.

    >>> in_last_unit([5, 6.5], "ft;in")
    66.5
    """
    units = parse_compound(text)
    total = 0.0
    for part, unit in zip(parts, units, strict=True):
        up, down = _size(unit, units[-1])
        total += part * up / down
    return total


def rounded_parts(parts: "Sequence[float]", text: str, place: int) -> "list[float]":
    """The parts rounded to so many decimals of the last, which may make a whole of the one before.

    >>> rounded_parts([5, 11.7], "ft;in", 0)
    [6, 0.0]
    """
    tens = 10 ** abs(place)
    total = in_last_unit(parts, text)
    integer = round(total * tens) if place >= 0 else round(total / tens)
    return list(_split(integer if place >= 0 else integer * tens, tens if place >= 0 else 1, parse_compound(text)))


def listed_text(parts: "Sequence[object]", text: str) -> str:
    """The parts of a compound quantity with their units, as they are typed: 5 ft 6.5 in."""
    units = text.split(";")
    if len(units) != len(parts):
        raise UsageError(f"read {len(parts)} numbers of {len(units)} units", hint="one number for each unit")
    return " ".join(f"{number} {unit.strip()}" for number, unit in zip(parts, units, strict=True))


def _times_inverse(numerator: int, denominator: int, unit: Unit) -> tuple[int, int]:
    up, down = numerator * unit.denominator, denominator * unit.numerator
    return _with_pi_to(up, down, -unit.pi) if unit.pi else (up, down)


def _with_pi_to(numerator: int, denominator: int, pi: int) -> tuple[int, int]:
    """Replace π^pi by a ratio good to far more digits than value and parts can show."""
    from dynamics_cli.core.units.conversion import pi_to

    digits = 2 * PI_DIGITS_LEAST + (numerator.bit_length() + denominator.bit_length()) // 3
    power = abs(pi)
    up, down = pi_to(digits) ** power, 10 ** (digits * power)
    if pi < 0:
        up, down = down, up
    return numerator * up, denominator * down


def _rounded(numerator: int, denominator: int) -> int:
    quotient, rest = divmod(abs(numerator), denominator)
    quotient += 2 * rest >= denominator
    return quotient if numerator >= 0 else -quotient


def _split(total: int, down: int, units: tuple[Unit, ...]) -> tuple[float, ...]:
    """Split total/down of the last unit into whole numbers of the others and a rest."""
    sign = -1 if total < 0 else 1
    rest_up, rest_down = abs(total), down
    sizes = [_size(unit, units[-1]) for unit in units]
    parts: list[int] = []
    for up, over in sizes[:-1]:
        quotient, remainder = divmod(rest_up * over, rest_down * up)
        parts.append(quotient)
        rest_up, rest_down = remainder, rest_down * over
    rest = nearest(rest_up, rest_down)
    # The rest may round up to one of the unit before it, and that in turn.
    for index in range(len(parts) - 1, -1, -1):
        up, over = sizes[index]
        low_up, low_over = sizes[index + 1]
        inner = rest if index == len(parts) - 1 else float(parts[index + 1])
        if inner < nearest(up * low_over, over * low_up):
            break
        parts[index] += 1
        if index == len(parts) - 1:
            rest = 0.0
        else:
            parts[index + 1] = 0
    return (*(sign * part for part in parts), sign * rest if rest else 0.0)


def _size(unit: Unit, last: Unit) -> tuple[int, int]:
    up, down, pi = convert(1, 1, unit, last)
    if pi:
        raise FaultError(f"{unit.text} and {last.text} have no rational ratio")
    return up, down
