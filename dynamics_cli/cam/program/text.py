"""A motion program in one line: `rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell`.

program   = clause { ";" clause }
clause    = "start" angle | [ range ] move [ ["to"] amount ] [ [ "in" | "over" | "for" ] angle | range ] [ law ]
move      = "rise" | "return" | "dwell"                     amount = length or angle
range     = angle "-" angle | "until" angle                 an angle turned without a unit is in degrees
law       = name { number | key "=" value }                 numbers: shares, degree or share at constant velocity
"""

from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.program.parts import Exact, from_radians
from dynamics_cli.cam.program.segments import Move, Segment, Step
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.exact.rational import nearest, total

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, NoReturn

# Metres, as ratios.
LENGTHS: "dict[str, Exact]" = {
    "mm": (1, 1000), "m": (1, 1), "cm": (1, 100), "um": (1, 10**6), "µm": (1, 10**6), "μm": (1, 10**6),
    "micron": (1, 10**6), "in": (127, 5000), "inch": (127, 5000), "inches": (127, 5000), "ft": (381, 1250),
    "mil": (127, 5 * 10**6), "thou": (127, 5 * 10**6),
}  # fmt: skip
# Degrees, as ratios.
ANGLES: "dict[str, Exact]" = {
    "deg": (1, 1), "°": (1, 1), "degree": (1, 1), "degrees": (1, 1), "rev": (360, 1), "turn": (360, 1),
    "turns": (360, 1), "grad": (9, 10), "gon": (9, 10), "arcmin": (1, 60), "arcsec": (1, 3600),
}  # fmt: skip
STATES = {
    "v0": "start_velocity", "v1": "end_velocity", "a0": "start_acceleration", "a1": "end_acceleration",
    "start_velocity": "start_velocity", "end_velocity": "end_velocity",
    "start_acceleration": "start_acceleration", "end_acceleration": "end_acceleration",
}  # fmt: skip
LONGEST = 40


def read_program(text: str) -> "tuple[list[Step], Exact | None]":
    """The segments of a program written as text, and its start angle in degrees if it has one.

    Raises UsageError when a clause cannot be read; the message quotes the clause and says what was expected.
    """
    steps: list[Step] = []
    start: Exact | None = None
    text = text.replace("\n", ";").replace("−", "-")
    for word in (*Move.names, *Move.aliases):
        text = text.replace(f", {word}", f"; {word}")
    at: Exact | None = None
    for clause in text.split(";"):
        if not clause.strip():
            continue
        words = _Words(clause, at if steps or start else (0, 1))
        if "±" in clause:
            words.fail("± is not wanted: a program takes no uncertain values")
        if words.peek() == "start":
            words.take()
            words.skip("at", "from")
            start = at = words.angle()
            words.end()
            continue
        step = _step(words)
        begin = words.begins or at or (None if steps else (0, 1))
        if at and begin and nearest(at) != nearest(begin):
            words.fail(f"it begins at {nearest(begin):g} deg, where the one before ends at {nearest(at):g} deg")
        start = start or (None if steps else words.begins)
        at = total((begin, step.span)) if begin and step.span else None
        steps.append(step)
    return steps, start


def _step(words: "_Words") -> Step:
    span = words.range()
    words.skip(":")
    word = words.take()
    try:
        move = Move(word)
    except ValueError:
        words.fail(f"read {word!r}, wanted rise, return or dwell")
    fields: dict[str, Any] = {"move": move}
    level: float | None = None
    if move == "dwell":
        words.skip("in", "for", "over", "of")
        span = span or words.range("to")
        if words.peek() and span is None:
            span = words.angle()
        words.end()
        return Step(Segment(**fields), span)
    absolute = words.skip("to")
    words.skip("by")
    at_amount = words.at_number()
    if at_amount:
        amount, is_angle = words.amount()
        if absolute:
            # A level has the dimension of the program, as the lift has.
            fields["swing" if is_angle else "lift"] = None
            level = amount
            fields.update({"swing": abs(amount)} if is_angle else {})
        else:
            fields["swing" if is_angle else "lift"] = amount
    written = words.skip("in", "over", "for", "during")
    span = span or words.range()
    if span is None and (written or (at_amount and words.at_number())):
        span = words.angle()
    _read_law(words, fields)
    return Step(Segment(**fields), span, level)


def _near_laws(word: str) -> str:
    """Laws with similar names, as a question."""
    from difflib import get_close_matches

    near = get_close_matches(word.lower(), (*LawName.names, *LawName.aliases))
    # another spelling of a law already listed is not a new choice
    laws = list(dict.fromkeys(str(LawName(name)) for name in near))
    return f"did you mean {' or '.join(laws)}? " if laws else ""


def _read_law(words: "_Words", fields: "dict[str, Any]") -> None:
    words.skip("with", "by", "law")
    words.words = [word for word in words.words if word.lower() not in ("motion", "law")]
    if not words.peek():
        return
    word = words.take()
    while words.peek() and not words.at_number() and "=" not in words.peek():
        word += "-" + words.take()
    try:
        fields["law"] = LawName(word)
    except ValueError:
        apart = "clauses are separated by semicolons; " if "," in words.clause else ""
        words.fail(f"there is no law {word!r}; {apart}{_near_laws(word)}`dynamics cam laws` lists all")
    numbers = []
    while words.at_number():
        numbers.append(words.number())
    _place_numbers(words, fields, [top / bottom for top, bottom in numbers])
    while words.peek():
        key, _, value = words.take().partition("=")
        if key not in STATES or not value:
            words.fail(f"read {key!r}, wanted v0=, v1=, a0= or a1= with a value")
        fields[STATES[key]] = words.rate(value)


def _place_numbers(words: "_Words", fields: "dict[str, Any]", numbers: "list[float]") -> None:
    law = fields["law"]
    if law == "scca" and len(numbers) in (3, 4):
        fields["shares"] = tuple(numbers[:3])
        if numbers[3:]:
            fields["constant"] = numbers[3]
    elif law == "polynomial" and len(numbers) == 1:
        fields["degree"] = int(numbers[0]) if numbers[0] == int(numbers[0]) else 0
    elif law == "modified-constant-velocity" and len(numbers) == 1:
        fields["constant"] = numbers[0]
    elif numbers:
        words.fail(f"the {law} law does not take {len(numbers)} number{'s' * (len(numbers) > 1)}")


class _Words:
    """The words of one clause, and the refusal when they are not understood.

    `at`: the cam angle in degrees where the clause begins, as far as those before it say. `begins`: as it says itself.
    """

    def __init__(self, clause: str, at: "Exact | None") -> None:
        self.clause = clause.strip()
        self.at = at
        self.begins: Exact | None = None
        text = self.clause.replace(",", " ").replace("(", " ").replace(")", " ").replace(" = ", "=")
        self.words = [part for word in text.replace(":", " : ").split() for part in _ends(word)]

    def fail(self, message: str) -> "NoReturn":
        """Refuse the clause."""
        raise UsageError(
            f"in {self.clause!r}: {message}",
            code="program-words",
            parameter="program",
            hint="for example: rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell",
        )

    def peek(self) -> str:
        """The next word, or nothing."""
        return self.words[0] if self.words else ""

    def take(self, wanted: str = "more") -> str:
        """The next word, which must exist."""
        if not self.words:
            self.fail(f"the clause ends too early, wanted {wanted}")
        return self.words.pop(0)

    def skip(self, *fillers: str) -> bool:
        """Skip the next word if it is one of these; returns whether it was."""
        if self.peek().lower() in fillers:
            self.words.pop(0)
            return True
        return False

    def at_number(self) -> bool:
        """Whether a number is next."""
        return bool(self.words) and _ratio(self.words[0]) is not None

    def end(self) -> None:
        """Refuse remaining words."""
        if self.words:
            self.fail(f"{self.words[0]!r} is not expected here")

    def number(self) -> "Exact":
        """The next word as an exact number."""
        word = self.take("a number")
        value = _ratio(word)
        if value is None:
            self.fail(f"read {word!r}, wanted a number")
        return value

    def amount(self) -> "tuple[float, bool]":
        """A length in metres, or an angle in radians."""
        top, bottom = self.number()
        wanted = "a unit of length or angle, such as mm or deg"
        unit = self.take(wanted)
        if unit == "in" and self.at_number():
            if top:
                self.fail("the lift has no unit; write 20 mm in 90 deg, or of inches 1 in in 90 deg")
            self.words.insert(0, unit)
            return 0.0, False
        if unit in LENGTHS:
            a, b = LENGTHS[unit]
            return top * a / (bottom * b), False
        return _as_radians(self._angle(top, bottom, unit, wanted)), True

    def angle(self) -> "Exact":
        """An angle in degrees, as an exact ratio; a number without a unit is one of degrees."""
        top, bottom = self.number()
        if self.peek() in (*ANGLES, *LENGTHS, "rad", "radian", "radians"):
            return self._angle(top, bottom, self.take(), "a unit of angle, such as deg")
        return top, bottom

    def range(self, *until: str) -> "Exact | None":
        """The angle turned, where its ends are written: 0-90 deg, from 0 to 90 deg, until 90 deg."""
        if self.skip("until", "till", *until):
            begin = self.at
            if begin is None:
                self.fail("it is not known where it begins; write from 240 to 360 deg")
        elif self.skip("from", "between"):
            begin = self.begins = self.angle()
            if not self.skip("to", "and"):
                self.fail("wanted where it ends, as in from 0 to 90 deg")
        else:
            return None
        return total((self.angle(), (-begin[0], begin[1])))

    def _angle(self, top: int, bottom: int, unit: str, wanted: str) -> "Exact":
        if unit in ("rad", "radian", "radians"):
            return from_radians((top, bottom))
        if unit not in ANGLES:
            self.fail(f"read {unit!r}, wanted {wanted}")
        a, b = ANGLES[unit]
        return top * a, bottom * b

    def rate(self, text: str) -> float:
        """A length per angle or per angle squared, such as 5 mm/rad or 0.1 mm/deg^2, or a pure number."""
        value = _ratio(text)
        if value is None:
            parts = _parted(text)
            value = _ratio(parts[0])
            if value is None or len(parts) != 2:
                self.fail(f"read {text!r}, wanted a number and a unit such as 5 mm/rad")
            self.words.insert(0, parts[1])
        top, bottom = value
        number = top / bottom
        if not self.peek() or "=" in self.peek():
            return number
        unit = self.take()
        length, _, angle = unit.partition("/")
        name, _, power = angle.replace("²", "^2").partition("^")
        if (length not in LENGTHS and length not in ("1", *ANGLES, "rad")) or power not in ("", "2"):
            self.fail(f"read {unit!r}, wanted a unit such as mm/rad or mm/rad^2")
        up = LENGTHS[length][0] / LENGTHS[length][1] if length in LENGTHS else _unit_radians(length)
        down = _unit_radians(name)
        return number * up / (down * down if power else down)


def _unit_radians(name: str) -> float:
    return _as_radians(ANGLES[name]) if name in ANGLES else 1.0


def _as_radians(degrees: "Exact") -> float:
    from dynamics_cli.cam.program.parts import radians

    return radians(degrees)[0]


def _ends(word: str) -> "list[str]":
    """`0-90` as from 0 to 90, but law names such as 2-3 and numbers such as 1e-3 whole; other words in their parts."""
    first, dash, second = word.replace("–", "-").replace("..", "-").partition("-")
    ends = _parted(first), _parted(second)
    if dash and word not in LawName.aliases and _ratio(word) is None and all(_ratio(end[0]) for end in ends):
        return ["from", *ends[0], "to", *ends[1]]
    return _parted(word)


def _parted(word: str) -> "list[str]":
    """`20mm` and `90°` as number and unit; law names such as 3-4-5 stay whole."""
    if _ratio(word) is not None:
        return [word]
    cut = 0
    for i in range(1, len(word)):
        if _ratio(word[:i]) is not None:
            cut = i
    head, tail = word[:cut], word[cut:]
    return [head, tail] if cut and (tail in LENGTHS or tail in ANGLES or tail == "rad" or "/" in tail) else [word]


def _ratio(text: str) -> "Exact | None":
    """A decimal number or a ratio of two, exactly; None for other text."""
    top, slash, bottom = text.partition("/")
    first = decimal(top)
    if first is None or not slash:
        return first
    second = decimal(bottom)
    if second is None or not second[0]:
        return None
    return first[0] * second[1], first[1] * second[0]


def decimal(text: str) -> "Exact | None":
    """A plain decimal number, exactly; None for other text."""
    body = text[1:] if text[:1] in ("+", "-") else text
    mantissa, letter, exponent = body.lower().partition("e")
    integer, _, tail = mantissa.partition(".")
    digits = integer + tail
    power = exponent[1:] if exponent[:1] in ("+", "-") else exponent
    if not digits.isdecimal() or not digits.isascii() or len(digits) > LONGEST:
        return None
    if letter and not (power.isdecimal() and power.isascii() and len(power) <= 3):
        return None
    shift = (int(exponent) if letter else 0) - len(tail)
    value = int(digits) * (-1 if text[:1] == "-" else 1)
    return (value * 10**shift, 1) if shift >= 0 else (value, 10**-shift)
