"""Forms of numbers that people type besides `60 mph`: 12 1/2 in, 6'2", 45°30', 1h30m, 2:30:00, 5 ft + 6 in, 1,234.5 m.

Tried only where a text shows signs of such a form; text with two readings (1,200 or 2:30) is refused, naming both.
"""

from dynamics_cli.core.units.table import NAMES
from dynamics_cli.errors import UsageError

DIGITS = "0123456789"
# Characters that no plain quantity has.
MARKS = "'\"’‘”“:,"
FEET, INCHES = "'’‘", '"”“'
GROUP = 3


def plain_text(text: str) -> str:
    """The text with clock times, grouped thousands and the signs of feet and inches written plainly."""
    if not any(mark in text for mark in MARKS):
        return text
    plain = _without_signs(_without_groups(_without_clock(text)))
    # the comma of 5 ft, 6 in
    head, comma, tail = plain.partition(", ")
    if not comma or not head[-1:].isalpha() or tail[:1] not in tuple(DIGITS):
        return plain
    if not _in_parts(head, tail):
        hint = f"write {head} {tail} for their sum; here one value is wanted"
        raise UsageError(f"{text!r} may be one value or two", code="ambiguous", hint=hint)
    return f"{head} {tail}"


def _in_parts(head: str, tail: str) -> bool:
    """Whether the unit after the comma divides the one before it, as inches divide a foot and not a metre."""
    from dynamics_cli.core.units.compound import part_unit
    from dynamics_cli.core.units.conversion import convert
    from dynamics_cli.core.units.lookup import parse_unit

    larger, smaller = (part.rstrip().lstrip(DIGITS + "+-−./e ") for part in (head, tail.partition(",")[0]))
    try:
        whole = parse_unit(larger)
        up, down, pi = convert(1, 1, whole, part_unit(smaller, whole))
    except UsageError:
        return True  # what is wrong with them is reported later
    return not pi and not up % down


def summands(text: str) -> list[str]:
    """The parts of `5 ft + 6.5 in`; a text without such a plus is one part."""
    parts, start = [], 0
    for position, character in enumerate(text):
        if character != "+" or not text[:position].strip():
            continue
        before, after = text[:position].rstrip()[-1], text[position + 1 :].lstrip()[:1]
        exponent = before in "eE" and text[position - 2 : position - 1] in (*DIGITS, ".")
        if after and after in DIGITS + "." and (before.isalnum() or before in "%°′″.)") and not exponent:
            parts.append(text[start:position])
            start = position + 1
    return [*parts, text[start:]]


def with_fraction(text: str, at: int, end: int, integer: int) -> tuple[int, int, int]:
    """A whole number that a fraction follows (12 1/2) or that begins one (1/2), exactly, and where it ends."""
    sign = -1 if text[at] in "-−" else 1
    start = at if text[at] in DIGITS else at + 1
    stop = _fraction_end(text, start)
    if stop > start:
        up, down = _fraction(text[start:stop])
        return sign * up, down, stop
    start = end + 1 if text[end : end + 1] == "-" else len(text) - len(text[end:].lstrip(" "))
    stop = _fraction_end(text, start)
    if start == end or stop == start:
        return integer, 1, end
    up, down = _fraction(text[start:stop])
    if up >= down:
        raise UsageError(f"{text[start:stop]} is not less than 1", code="number", hint="write for example 12 1/2 in")
    return integer * down + sign * up, down, stop


def with_power(text: str, token: str, end: int, numerator: int, denominator: int) -> tuple[int, int, int]:
    """A number times a power of ten (29×10^6, 2.1 x 10^-3) or 10^6, exactly, and where it ends."""
    rest = text[end:].lstrip()
    if rest[0] == "^":
        mantissa, power = (1, 1), rest if token == "10" else ""
    else:
        ten = rest[1:].lstrip()
        mantissa, power = (numerator, denominator), ten[2:] if ten.startswith("10") else ""
    power = power.replace("**", "^", 1)
    digits = power[1:].lstrip("+-−") if power[:1] == "^" else ""
    stop = _digits_end(digits, 0)
    sign = power[1:].removesuffix(digits)
    if not 0 < stop <= GROUP or len(sign) > 1:
        return numerator, denominator, end
    scale: int = 10 ** int(digits[:stop])
    over, under = (1, scale) if sign in ("-", "−") else (scale, 1)
    return mantissa[0] * over, mantissa[1] * under, len(text) - len(digits) + stop


def _fraction_end(text: str, at: int) -> int:
    """Where a fraction of whole numbers that begins here ends: `1/2` before a space, a letter or the end; else `at`."""
    middle = _digits_end(text, at)
    if middle == at or text[middle : middle + 1] != "/":
        return at
    end = _digits_end(text, middle + 1)
    distance = text[at:middle] == "1" and text[middle + 1 :].startswith("100")
    return at if end == middle + 1 or distance or text[end : end + 1] in (".", "/") else end


def _fraction(text: str) -> tuple[int, int]:
    up, _, down = text.partition("/")
    if not int(down):
        raise UsageError(f"{text} divides by zero", code="number", hint="write for example 1/2 in")
    return int(up), int(down)


def after_unit(text: str, start: int, at: int) -> bool:
    """Whether the number at `at` begins a new part directly after the unit's name: 1h30m, 5ft6in."""
    name = text[start:at].strip()
    if not name.isalpha() or f" {name}|" not in NAMES:
        return False
    end = _digits_end(text, at)
    while text[end : end + 1] == ".":
        end = _digits_end(text, end + 1)
    rest = text[end:].lstrip()
    letters = len(rest) - len(rest.lstrip("abcdefghijklmnopqrstuvwxyz"))
    return bool(letters) and f" {rest[:letters]}|" in NAMES


def _digits_end(text: str, at: int) -> int:
    while text[at : at + 1] and text[at] in DIGITS:
        at += 1
    return at


def _without_clock(text: str) -> str:
    """2:30:00 as hours, minutes and seconds; 2:30 has two readings and is refused."""
    if ":" not in text:
        return text
    sign = text[0] if text[0] in "+-−" else ""
    parts = text.removeprefix(sign).split(":")
    digits_only = all(part.isascii() and part.isdigit() for part in parts[:-1])
    if not digits_only or not parts[-1].replace(".", "", 1).isdigit() or not parts[-1].isascii() or len(parts) > GROUP:
        message = f"{text[:60]!r} has a colon, which only times such as 2:30:00 have"
        hint = "a series is --sweep NAME=20:60 ft:5 (from, to, points), a range of an uncertain value 20..60 ft"
        raise UsageError(message, code="number", hint=hint)
    if len(parts) < GROUP:
        first, second = parts
        hint = f"write {first} h {second} min, or {first} min {second} s; with hours, minutes and seconds: 2:30:00"
        raise UsageError(f"{text!r} may be hours and minutes or minutes and seconds", code="ambiguous", hint=hint)
    return f"{sign}{parts[0]} h {parts[1]} min {parts[2]} s"


def _without_groups(text: str) -> str:
    """1,234,567 and 1,234.5 without their commas; 1,200 alone could be 1.2, so it is refused."""
    position = 0
    while (comma := text.find(",", position)) >= 0:
        start = comma
        while start and text[start - 1] in DIGITS:
            start -= 1
        end = comma
        groups = 0
        while text[end : end + 1] == "," and _digits_end(text, end + 1) == end + 1 + GROUP:
            end += 1 + GROUP
            groups += 1
        number = text[start:end]
        if not groups or not 0 < comma - start <= GROUP or text[end : end + 1] in (*DIGITS, ",") or number[0] == "0":
            return text
        ungrouped = number.replace(",", "")
        if groups == 1 and text[end : end + 1] != ".":
            decimal = number.replace(",", ".").rstrip("0").rstrip(".")
            message = f"{number!r} may be {ungrouped} or {decimal}"
            raise UsageError(message, code="number", hint=f"write {ungrouped} or {decimal}, without a comma")
        text = text[:start] + ungrouped + text[end:]
        position = start + len(ungrouped)
    return text


def _without_signs(text: str) -> str:
    """The signs of feet and inches or, after degrees, of minutes and seconds of arc."""
    arc = any(sign in text for sign in ("°", "deg", "′"))
    feet, inches = (" arcmin ", " arcsec ") if arc else (" ft ", " in ")
    for signs, plain in ((FEET, feet), (INCHES, inches)):
        for sign in signs:
            text = text.replace(sign, plain)
    return text.strip()


def as_range(text: str) -> str:
    """How the range `0.7-0.8`, `20 – 25 m` or `20 m to 25 m` is written, with two points; empty for other text."""
    for mark in (" to ", " - ", " – ", "–", "-"):
        low, _, high = (part.strip() for part in text.partition(mark))
        # without spaces about it, a mark after a unit may be part of a power
        alone = low if mark in "–-" else low[:1]
        if alone.replace(".", "", 1).isdecimal() and high[:1].isdecimal():
            return f"write a range as {low}..{high}"
    return ""
