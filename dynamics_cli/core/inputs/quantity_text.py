"""The text of quantities: `60 mph`, `-40degC`, `5 ft 6 in`, `-3 %`, `365.2422/27.3217`, read exactly.

A number here is a plain decimal and nothing else: `float` would take `nan`, `1_000` and `٣`, and make 1e400 infinite.
A refusal states what was read, what was expected and the remedy; the caller adds the parameter.
"""

from dynamics_cli.core.units.conversion import lowest, nearest, to_si
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.core.units.unit import NONE, NUMBER, Unit, conformable
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn, TypeAlias

    from dynamics_cli.quantities import Kind

    Parts: TypeAlias = tuple[list[float], str]

DIGITS = "0123456789"
SIGNS = "+-−"
LONGEST_NUMBER, LONGEST_TEXT = 400, 1000
# Beyond this exponent no unit brings a number back into the range of a double.
BEYOND = "beyond the range of a double (about 1.8e308)"
HIGHEST_EXPONENT, MOST_PARTS = 999, 6
EXACT_INTEGERS = 2**53
# A number right after one of these belongs to the unit; elsewhere, after a space, it begins a new part.
JOINING = "/^*·⋅∙×(-−+"
ARC_SIGNS = "°′″"
# What may follow the number in 29×10^6 psi and 10^6 N; empty text ends the quantity.
POWER_SIGNS = tuple("^x×*·")
NO_UNIT = "it has no unit"
# Signs of a text in one of the forms of `typed_forms`.
FRACTIONS = {"½": "1/2", "¼": "1/4", "¾": "3/4", "⅓": "1/3", "⅔": "2/3", "⅛": "1/8", "⅜": "3/8", "⅝": "5/8", "⅞": "7/8"}
FORM_MARKS = "'\"’‘”“:,+"
UNCERTAIN_SIGNS = ("±", "+/-", "+-", "..")
DISTRIBUTIONS = ("normal", "uniform", "lognormal", "triangular", "truncated", "beta", "empirical", "readings")
ANGLE = (0, 0, 0, 0, 0, 0, 0, 1)


class Amount:
    """Numbers with their units as written, exact: (numerator, denominator, unit) for each part.

    `plain`: the last number was written without a point or an exponent; `added`: parts were joined by a plus, so
    that they need not decrease.
    """

    __slots__ = ("added", "parts", "plain", "text")

    def __init__(self, parts: tuple[tuple[int, int, str], ...], text: str, plain: bool, *, added: bool = False) -> None:
        self.parts = parts
        self.added = added
        self.text = text
        self.plain = plain


class Reading:
    """One scalar as read: its SI value, the number and the unit as written, and notes on its interpretation.

    `parts`: the numbers and units of `5 ft 6 in`, as a document writes them.
    """

    __slots__ = ("notes", "parts", "si", "unit", "value")

    def __init__(
        self, si: float, value: float, unit: str, notes: tuple[str, ...] = (), parts: "Parts | None" = None
    ) -> None:
        self.si = si
        self.value = value
        self.unit = unit
        self.notes = notes
        self.parts = parts


def read_number(text: str) -> tuple[int, int]:
    """Read a plain decimal number (`-1.5e3`, `.5`, `5.`) as an exact ratio, not reduced."""
    if text.isdigit() and text.isascii() and len(text) <= LONGEST_NUMBER:
        return int(text), 1
    if len(text) > LONGEST_NUMBER:
        raise _not_a_number(text, f"it has more than {LONGEST_NUMBER} characters")
    body = text[1:] if text[:1] and text[0] in SIGNS else text
    mark = "e" if "e" in body else "E"
    mantissa, marked, power = body.partition(mark)
    integer, _, broken = mantissa.partition(".")
    digits = integer + broken
    power_digits = power[1:] if power[:1] and power[0] in SIGNS else power
    if not _all_digits(digits) or (marked and not _all_digits(power_digits)):
        raise _not_a_number(text)
    exponent = int(power_digits) if marked else 0
    if exponent > HIGHEST_EXPONENT:
        small = power[:1] in ("-", "−")
        limit = "too close to zero for a double (about 5e-324)" if small else BEYOND
        raise UsageError(f"{shown(text)} is {limit}", code="range")
    exponent = (-exponent if power[:1] and power[0] in "-−" else exponent) - len(broken)
    numerator = -int(digits) if text[0] in "-−" else int(digits)
    return (numerator * 10**exponent, 1) if exponent >= 0 else (numerator, 10**-exponent)


def read_amount(text: str) -> Amount:
    """Read numbers with units: `60 mph`, `60mph`, `5 ft 6 in`, `3° 20′`, or a bare number.

    A new part begins at a number after a space (or after °, ′, ″). The sign of the first part applies to all, and
    every part of the result carries it; `-5 ft -6 in`, as a document writes it, is the same value.
    """
    body = text.strip()
    if len(body) > LONGEST_TEXT:
        raise UsageError(f"{shown(body)} is too long for a quantity", code="syntax")
    if not body.isascii() and any(mark in body for mark in FRACTIONS):
        body = "".join(f" {FRACTIONS[mark]}" if mark in FRACTIONS else mark for mark in body).strip()
    if not any(mark in body for mark in FORM_MARKS):
        return _amount(body, text)
    from dynamics_cli.core.inputs.typed_forms import plain_text, summands

    several = summands(plain_text(body))
    if len(several) == 1:
        return _amount(several[0], text)
    amounts = [_amount(part.strip(), text) for part in several]
    parts = tuple(part for amount in amounts for part in amount.parts)
    return Amount(parts, text, all(amount.plain for amount in amounts), added=True)


def _amount(body: str, text: str) -> Amount:
    parts: list[tuple[int, int, str]] = []
    position = 0
    plain, negative = True, body[:1] in ("-", "−")
    while position < len(body):
        end = number_end(body, position)
        if end == position or len(parts) == MOST_PARTS:
            raise _not_a_number(body, "it does not begin with a number" if not parts else "")
        token = body[position:end]
        if parts and token[0] in SIGNS and (token[0] == "+" or not (negative or all(not part[0] for part in parts))):
            hint = "a sign before 5 ft 6 in applies to the whole value; powers are written m^-1"
            raise UsageError(f"{shown(body)} has a sign inside", code="syntax", hint=hint)
        if end < len(body) - 1 and body[end] in ",_'’" and body[end + 1] in DIGITS:
            raise _not_a_number(body[position:].split(" ")[0])
        numerator, denominator = read_number(token)
        plain = "." not in token and "e" not in token and "E" not in token
        if plain and "/" in body and body[body.index("/") + 1 :][:1] in tuple(DIGITS):
            from dynamics_cli.core.inputs.typed_forms import with_fraction

            numerator, denominator, end = with_fraction(body, position, end, numerator)
            plain = denominator == 1
        elif body[end:].lstrip()[:1] in POWER_SIGNS:
            from dynamics_cli.core.inputs.typed_forms import with_power

            numerator, denominator, end = with_power(body, token, end, numerator, denominator)
        position = _unit_end(body, end)
        parts.append((-abs(numerator) if negative else numerator, denominator, " ".join(body[end:position].split())))
    if not parts:
        raise UsageError("the quantity is empty", code="syntax")
    return Amount(tuple(parts), text, plain)


def total(amount: Amount, wanted: Unit | None = None) -> tuple[int, int, Unit]:
    """Give an amount as one exact number in the last part's unit, the parts added up.

    The caller checks that the unit fits `wanted`, which only selects among a unit's readings.
    """
    if len(amount.parts) == 1:
        numerator, denominator, text = amount.parts[0]
        return numerator, denominator, parse_unit(text, wanted)
    from dynamics_cli.core.units.compound import joined

    return joined(amount.parts, wanted, added=amount.added)


def read_scalar(text: str, kind: "Kind", default_unit: str = "") -> Reading:
    """Read one certain value of a kind, check its unit and its bounds, and give it in SI, rounded once.

    `default_unit` stands in where none is written, as in a table whose header names the unit.
    """
    try:
        return _scalar(read_amount(text), kind, default_unit)
    except UsageError as error:
        if kind.letter and default_unit != kind.si:
            bare = text.lstrip(kind.letter + kind.letter.lower() + " ")
            try:
                return read_scalar(bare, kind, kind.si)
            except UsageError as of_bare:
                message = of_bare.message.replace(shown(bare), shown(text), 1)
                raise UsageError(message, code=of_bare.code, hint=of_bare.hint) from None
        if is_uncertain(text):
            message = f"{shown(text)} is an uncertain value; a certain value is wanted here"
            hint = f"write one number, for example {kind.example}"
            raise UsageError(message, code="uncertain", hint=hint) from None
        if error.message == NO_UNIT:
            hint = f"write for example {kind.example}" if kind.example else "write the number with its unit"
            raise UsageError(f"{shown(text)} has no unit", code=error.code, hint=hint) from None
        from dynamics_cli.core.inputs.typed_forms import as_range

        if hint := as_range(text):
            raise UsageError(f"{shown(text)} is not one number", code="range", hint=hint) from None
        expected = kind.about if kind.form == "whole" else kind.one
        if error.code == "bounds":
            hint = f"example: {kind.example}"
            raise UsageError(f"{shown(text)} is out of range: {error.message}", code=error.code, hint=hint) from None
        counted = kind.form == "whole" and error.code in ("whole", "number")
        wrong = "a whole number" if counted else f"{expected}: {error.message}"
        hint = f"{error.hint}; example: {kind.example}" if error.hint else f"example: {kind.example}"
        raise UsageError(f"{shown(text)} is not {wrong}", code=error.code, hint=hint) from None


def is_uncertain(text: str) -> bool:
    """Whether a text is written as a distribution: `0.72 ± 0.04`, `0.65..0.75`, `lognormal(…)`, `[0.71, 0.74]`."""
    if text.lstrip().startswith("[") or any(sign in text for sign in UNCERTAIN_SIGNS):
        return True
    name, opened, _ = text.partition("(")
    return opened == "(" and name.strip().lower() in DISTRIBUTIONS


def read_fraction(text: str) -> tuple[int, int]:
    """Read an exact ratio of two decimal numbers (`365.2422/27.3217`, `10:1`) or one number, in lowest terms."""
    up, divided, down = text.replace(":", "/").partition("/")
    numerator, over = read_number(up.strip())
    if not divided:
        return lowest(numerator, over)
    denominator, under = read_number(down.strip())
    if not denominator:
        raise UsageError(f"{shown(text)} divides by zero", code="number", hint="example: 365.2422/27.3217")
    return lowest(numerator * under, denominator * over)


def _scalar(amount: Amount, kind: "Kind", default_unit: str) -> Reading:
    numerator, denominator, unit_text = amount.parts[0]
    if default_unit and not unit_text and len(amount.parts) == 1:
        amount = Amount(((numerator, denominator, default_unit),), amount.text, amount.plain)
    base_unit = parse_unit(kind.unit) if kind.unit else NUMBER
    numerator, denominator, unit = total(amount, base_unit)
    if kind.form == "slope" and unit.dimension == ANGLE:
        si = _tangent(numerator, denominator, unit)
    elif not conformable(unit, base_unit):
        _mismatch(unit, base_unit, amount)
    else:
        si = to_si(numerator, denominator, unit)
        if kind.exact and not unit.pi:
            from dynamics_cli.numerics.exact.typed import TypedNumber

            si = TypedNumber(numerator * unit.numerator, denominator * unit.denominator)
    if limit := kind.outside(si):
        raise UsageError(f"it must be {limit}{kind.unit and ' '}{kind.unit}", code="bounds")
    if kind.form == "whole":
        if unit.text or numerator % denominator:
            raise UsageError("it is not a whole number", code="whole")
        if abs(numerator // denominator) > EXACT_INTEGERS:
            raise UsageError(f"it must be at most {EXACT_INTEGERS}", code="bounds")
        return Reading(si, numerator // denominator, "")
    return Reading(si, _as_written(numerator, denominator, amount), unit.text, unit.notes, parts_of(amount))


def parts_of(amount: Amount) -> "Parts | None":
    """The numbers of `5 ft 6 in` and their units as `ft;in`; None of one number, and of parts joined by a plus."""
    if len(amount.parts) == 1 or amount.added:
        return None
    numbers = [up // down if up % down == 0 else nearest(up, down) for up, down, _ in amount.parts]
    return numbers, ";".join(unit for *_, unit in amount.parts)


def _as_written(numerator: int, denominator: int, amount: Amount) -> float:
    if denominator == 1 and amount.plain and -EXACT_INTEGERS < numerator < EXACT_INTEGERS:
        return numerator
    return nearest(numerator, denominator)


def _tangent(numerator: int, denominator: int, unit: Unit) -> float:
    from dynamics_cli.numerics.turns import tangent

    radians = to_si(numerator, denominator, unit)
    # 90 degrees rounds to a double just below π/2, so degrees are compared exactly.
    upright = 2 * abs(numerator) * unit.numerator >= denominator * unit.denominator if unit.pi == 1 else False
    if upright or abs(radians) > 1.5707963267948966:
        raise UsageError("a slope of 90 deg or more has no rise over run", code="bounds")
    return tangent(radians)


def _mismatch(unit: Unit, wanted: Unit, amount: Amount) -> "NoReturn":
    if unit.dimension == NONE and not amount.parts[-1][2]:
        raise UsageError(NO_UNIT, code="missing-unit", hint="write the number with its unit")
    from dynamics_cli.core.units.names import explain_mismatch

    message, hint = explain_mismatch(unit, wanted)
    raise UsageError(message, code="kind", hint=hint)


def number_end(text: str, at: int) -> int:
    """Find the end of the number that begins here: sign, digits and points, and an exponent only with its digits."""
    end = at + 1 if text[at] in SIGNS else at
    start = end
    while end < len(text) and text[end] in "0123456789.":
        end += 1
    if end == start or not any(character in DIGITS for character in text[start:end]):
        return at
    if text[end : end + 1] in ("e", "E"):
        digits = end + 2 if text[end + 1 : end + 2] and text[end + 1] in SIGNS else end + 1
        stop = digits
        while stop < len(text) and text[stop] in DIGITS:
            stop += 1
        if stop > digits:
            return stop
    return end


def _unit_end(text: str, start: int) -> int:
    """Find where the unit that begins here ends: before the next number that begins a part."""
    before = ""
    for position in range(start, len(text)):
        character = text[position]
        if character.isspace():
            continue
        apart = text[position - 1].isspace() or before in ARC_SIGNS
        if before and apart and before not in JOINING and number_end(text, position) > position:
            return position
        if before.isalpha() and character in DIGITS and not apart:
            from dynamics_cli.core.inputs.typed_forms import after_unit

            if after_unit(text, start, position):
                return position
        before = character
    return len(text)


def _all_digits(text: str) -> bool:
    return text.isascii() and text.isdigit()


def _not_a_number(text: str, why: str = "") -> UsageError:
    hint = None
    whole, _, broken = text.partition(",")
    if _all_digits(whole) and _all_digits(broken):
        hint = f"write {whole}.{broken} with a point"
    elif "," in text or "_" in text or "'" in text:
        hint = "write 1.5 with a point, and thousands without a separator: 1000"
    return UsageError(f"{shown(text)} is not a decimal number{why and ': '}{why}", code="number", hint=hint)


def shown(text: str) -> str:
    """A text as messages quote it."""
    from dynamics_cli.core.units.expressions import show

    return show(text)
