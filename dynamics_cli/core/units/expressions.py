"""The grammar of unit expressions: `kg*m^2`, `lb/in.2`, `N·m`, `miles per hour`, `1/in`, `m s⁻¹`.

Products are written `*`, `·`, a space, or a hyphen or dot between names; powers `^2`, `**2`, `²` or the bare digit of
`ft2`; quotients `/` or `per`. Ambiguous expressions are refused: a product after a quotient (`kg/m s`) needs
parentheses. A number cannot be part of a unit, except the 1 of `1/in`, which may be left out (`/in`, `per inch`).
"""

from dynamics_cli.core.units.table import NAMES
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn

LONGEST = 120
DEEPEST = 8
HIGHEST_POWER = 20
PRODUCTS = "*·⋅∙×"
SHARES = {"%", "‰", "percent", "pct", "permille"}
NAME_SIGNS = "_°%‰′″℃℉"
SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹"
DIGITS = "0123456789"
# Distances that consumption is stated for.
HUNDREDS = ("100km", "100 km", "100mi", "100 mi")
MOST_WORDS = 3
POWER_WORDS = {"sq": 2, "square": 2, "cu": 3, "cubic": 3}


def factors(text: str) -> list[tuple[str, int]]:
    """Read an expression as its named factors with their powers, in the order written."""
    if len(text) > LONGEST:
        raise UsageError(f"a unit of {len(text)} characters is too long", code="unit-syntax", hint="example: kg*m^2")
    reader = _Reader(text)
    product = reader.product(0)
    if reader.at < len(text):
        reader.fail("')' has no '('" if reader.peek() == ")" else f"{show(reader.peek())} cannot stand in a unit")
    return product


def joined_name(words: "list[str]") -> str:
    """The table's name formed by several words, `nautical mile`, unless they are a product of units, `lb ft`."""
    joined = "_".join(words)
    if all(f" {word}|" in NAMES for word in words) and not joined.startswith("deg"):
        return ""
    return next((name for name in (joined, joined.lower()) if f" {name}|" in NAMES), "")


def show(text: str, longest: int = 60) -> str:
    """Quote the input, with control characters escaped, cut if it is long."""
    return repr(text if len(text) <= longest else text[:longest] + "…")


def starts_name(character: str) -> bool:
    """Whether a unit's name may begin with this character."""
    return character.isalpha() or (character != "" and character in NAME_SIGNS)


class _Reader:
    """A place in the text of a unit."""

    __slots__ = ("at", "text")

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0

    def fail(
        self, why: str, hint: str = "examples: m/s^2, kg*m^2, lbf*ft, 1/in", code: str = "unit-syntax"
    ) -> "NoReturn":
        """Refuse the text."""
        raise UsageError(f"cannot read {show(self.text)} as a unit: {why}", code=code, hint=hint)

    def peek(self, ahead: int = 0) -> str:
        """The character here or so many ahead; nothing at the end."""
        position = self.at + ahead
        return self.text[position : position + 1]

    def space(self) -> None:
        """Skip white space."""
        while self.peek().isspace():
            self.at += 1

    def at_per(self) -> bool:
        """Whether the word "per" is at this place."""
        after = self.peek(3)
        return self.text.startswith("per", self.at) and not (starts_name(after) or (after and after in DIGITS))

    def product(self, depth: int) -> list[tuple[str, int]]:
        """Factors with their powers, of products and quotients."""
        factors_read = self.operand(depth, first=True)
        divided = False
        while operator := self.operator():
            operand = self.operand(depth)
            if operator == "/":
                divided = True
                operand = [(name, -power) for name, power in operand]
            elif divided:
                self.fail(
                    "a product after a division can be read in two ways",
                    "use parentheses: kg/(m*s) for kg over both, or put the division last: kg*s/m",
                    "ambiguous-unit",
                )
            elif (
                not SHARES.isdisjoint(names := {name for name, _ in (*factors_read, *operand)}) and "grade" not in names
            ):
                self.fail(
                    "a percentage beside another unit", "write the value itself, 0.8 kg, or the share alone, 80 %"
                )
            factors_read += operand
        return factors_read

    def operator(self) -> str:
        """Consume an operator: "/", "*", " " between two names side by side, or nothing at the end."""
        self.space()
        character = self.peek()
        if character == "/":
            self.at += 1
            return "/"
        if self.at_per():
            self.at += 3
            return "/"
        if character and (character in PRODUCTS or (character == "-" and starts_name(self.peek(1)))):
            self.at += 1
            return "*"
        if starts_name(character) or character == "(" or (character and character in DIGITS):
            return " "
        return ""

    def operand(self, depth: int, first: bool = False) -> list[tuple[str, int]]:
        """One factor: a name, a 1 or a parenthesis, with its power."""
        self.space()
        character = self.peek()
        if character == "(":
            return self.parenthesis(depth)
        if first and (character == "/" or self.at_per()):
            return []
        if starts_name(character):
            name = self.words() or self.name()
            if name in POWER_WORDS and self.peek().isspace():
                inner = self.operand(depth)
                return [(inner_name, self.checked(power * POWER_WORDS[name])) for inner_name, power in inner]
            return [(name, self.power())]
        if distance := next((word for word in HUNDREDS if not first and self.text.startswith(word, self.at)), ""):
            self.at += len(distance)
            return [(distance.replace(" ", ""), 1)]
        if first and character == "1":
            self.at += 1
            self.space()
            if self.peek() in ("", "/", ")") or self.at_per():
                return []
        if character and character in DIGITS:
            self.fail(
                "a number inside the unit",
                "write one number and one unit, such as 8.5 in or 1 kg/m; powers as m^2; compounds as 5 ft 6 in",
            )
        if character and character in "'\"":
            self.fail("feet and inches have no signs here", "write 5 ft 6 in")
        self.fail("a unit is missing" if not character else f"{show(character)} cannot begin a unit")

    def parenthesis(self, depth: int) -> list[tuple[str, int]]:
        """The contents of parentheses."""
        if depth >= DEEPEST:
            self.fail("too many parentheses")
        self.at += 1
        inner = self.product(depth + 1)
        self.space()
        if self.peek() != ")":
            self.fail("'(' has no ')'" if not self.peek() else f"{show(self.peek())} cannot stand in a unit")
        self.at += 1
        power = self.power()
        return [(name, self.checked(each * power)) for name, each in inner]

    def words(self) -> str:
        """A unit's name of several words at this place, such as `nautical mile`; else empty."""
        end = self.at
        while self.peek(end - self.at).isalpha() or self.peek(end - self.at) == " ":
            end += 1
        words = self.text[self.at : end].split()
        for count in range(min(len(words), MOST_WORDS), 1, -1):
            if joined := joined_name(words[:count]):
                for word in words[:count]:
                    self.at = self.text.index(word, self.at) + len(word)
                return joined
        return ""

    def name(self) -> str:
        """A unit's name."""
        start = self.at
        while starts_name(self.peek()) or (self.peek() and self.peek() in DIGITS):
            self.at += 1
        token = self.text[start : self.at]
        base = token.rstrip(DIGITS)
        # The 2 of `ft2` is a power; the 0 of `g0` belongs to the name, and so does a digit after an underscore.
        if base != token and not base.endswith("_") and f" {token}|" not in NAMES:
            self.at = start + len(base)
            return base
        return token

    def power(self) -> int:
        """Consume a power in any of its spellings, with the abbreviation's dot of `in.2`; else 1."""
        if self.peek() == ".":
            self.at += 1
        character = self.peek()
        if character and character in DIGITS:
            return self.checked(self.digits())
        if character and character in SUPERSCRIPTS + "⁻":
            return self.superscript()
        if character and character in "-−" and self.peek(1) and self.peek(1) in DIGITS:
            self.at += 1
            return self.checked(-self.digits())
        start = self.at
        self.space()
        if self.peek() == "^" or self.text.startswith("**", self.at):
            self.at += 1 if self.peek() == "^" else 2
            return self.checked(self.signed())
        self.at = start
        return 1

    def signed(self) -> int:
        """A whole number that may have a sign and a parenthesis."""
        self.space()
        inside = self.peek() == "("
        self.at += inside
        self.space()
        sign = -1 if self.peek() and self.peek() in "-−" else 1
        self.at += sign < 0 or self.peek() == "+"
        value = sign * self.digits()
        if inside:
            self.space()
            if self.peek() != ")":
                self.fail("a power must be a whole number")
            self.at += 1
        return value

    def digits(self) -> int:
        """A short whole number."""
        start = self.at
        while self.peek() and self.peek() in DIGITS and self.at - start < 4:
            self.at += 1
        if start == self.at or (self.peek() == "." and self.peek(1) and self.peek(1) in DIGITS):
            self.fail("a power must be a whole number")
        return int(self.text[start : self.at])

    def superscript(self) -> int:
        """A whole number in superscripts."""
        sign = -1 if self.peek() == "⁻" else 1
        self.at += sign < 0
        value = count = 0
        while self.peek() and self.peek() in SUPERSCRIPTS and count < 4:
            value = value * 10 + SUPERSCRIPTS.index(self.peek())
            self.at += 1
            count += 1
        return self.checked(sign * value)

    def checked(self, power: int) -> int:
        """The power, checked against its bounds."""
        if not power or abs(power) > HIGHEST_POWER:
            self.fail(f"a power must be a whole number from 1 to {HIGHEST_POWER}, or its negative")
        return power
