"""Polynomials as people type them, `s(s+4)(s^2+1.4s+1) + K(s^2+2s+4)` or `1, 2.5, 3/7`, read exactly."""

from math import gcd

from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.exact.rational import lowest, product, total

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Pair: TypeAlias = tuple[int, int]
    # powers of the variables, and their coefficient
    Terms: TypeAlias = dict[tuple[int, int], Pair]
    # above and below the line
    Quotient: TypeAlias = tuple[Terms, Terms]

ONE: "Terms" = {(0, 0): (1, 1)}
LONGEST = 4000
MOST_DEGREE = 40
MOST_DIGITS = 60
MOST_EXPONENT = 60
MOST_DEPTH = 40
SIGNS = {"−": "-", "·": "*", "×": "*", "÷": "/", "**": "^"}
RAISED = {letter: str(digit) for digit, letter in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")}


def read(text: str, variable: str = "s", gain: str = "") -> "Terms":
    """The terms of a polynomial in `variable` and, where it has a name, in `gain`.

    A list of numbers holds the coefficients from the highest power down.

    >>> read("2, 0, 1/3")
    {(2, 0): (2, 1), (0, 0): (1, 3)}
    """
    if len(text) > LONGEST:
        raise UsageError(f"the polynomial has more than {LONGEST} characters", code="polynomial")
    text = ", ".join(_numbers_apart(text)) or text
    if "," in text:
        parts = [part.strip() for part in text.strip().strip("[]").split(",")]
        terms: Terms = {}
        for place, part in enumerate(reversed(parts)):
            for (power, degree), value in _Reader(part, "", gain).whole().items():
                terms[place + power, degree] = value
    else:
        terms = _Reader(text, variable, gain).whole()
    terms = {key: terms[key] for key in sorted(terms, reverse=True) if terms[key][0]}
    if not terms:
        raise UsageError(
            f"{text!r} is zero for every {variable}", code="zero-polynomial", hint="check the coefficients"
        )
    highest = max(power for power, _ in terms)
    if highest > MOST_DEGREE:
        raise UsageError(f"{text!r} has degree {highest}, the highest is {MOST_DEGREE}", code="degree")
    return terms


def read_quotient(text: str, variable: str = "s", gain: str = "") -> "Quotient":
    """Numerator and denominator of a transfer function, without any factor cancelled but by adding.

    >>> read_quotient("2/(s + 1)")
    ({(0, 0): (2, 1)}, {(1, 0): (1, 1), (0, 0): (1, 1)})
    """
    if len(text) > LONGEST:
        raise UsageError(f"the transfer function has more than {LONGEST} characters", code="polynomial")
    return _Reader(text, variable, gain, quotients=True).quotient()


def read_number(text: str) -> "Pair":
    """A decimal or a fraction, exactly."""
    return _Reader(text, "", "").whole().get((0, 0), (0, 1))


def whole(terms: "Terms") -> "tuple[list[tuple[int, ...]], int]":
    """For each power of the gain the coefficients from the constant up, as whole numbers, and their denominator."""
    common = 1
    for _, bottom in terms.values():
        common = common * bottom // gcd(common, bottom)
    degree, highest = max(power for power, _ in terms), max(k for _, k in terms)
    rows = [[0] * (degree + 1) for _ in range(highest + 1)]
    for (power, k), (top, bottom) in terms.items():
        rows[k][power] = top * (common // bottom)
    return [tuple(row) for row in rows], common


def _without(terms: "Terms", power: int) -> "Terms":
    """Terms over a power of the variable that all of them have."""
    return {(own - power, k): value for (own, k), value in terms.items()}


def _numbers_apart(text: str) -> "list[str]":
    """The numbers of a list written with spaces between them, as in `[1 2 3]`; empty of anything else."""
    parts = text.strip().strip("[]").split()
    numbers = all(part.lstrip("+-−").replace(".", "").replace("/", "").isdigit() for part in parts)
    return parts if len(parts) > 1 and numbers and all(part[0] != "/" for part in parts) else []


class _Reader:
    """Reads from left to right, by precedence; a missing sign between two factors is a product."""

    def __init__(self, text: str, variable: str, gain: str, *, quotients: bool = False) -> None:
        self.typed, self.quotients = text, quotients
        for sign, plain in SIGNS.items():
            text = text.replace(sign, plain)
        self.text, self.at, self.raised = "".join(text.split()), 0, False
        self.powers = {variable: (1, 0), gain: (0, 1)} if gain else {variable: (1, 0)}
        self.powers.pop("", None)

    def whole(self) -> "Terms":
        """The text as one polynomial."""
        return self.quotient()[0]

    def quotient(self) -> "Quotient":
        """The text as one quotient of polynomials."""
        both = self._sum(0)
        if self.at < len(self.text):
            self._refuse(f"{self.text[self.at]!r} is not wanted here")
        return both

    def _peek(self) -> str:
        return self.text[self.at : self.at + 1]

    def _sum(self, depth: int) -> "Quotient":
        if depth > MOST_DEPTH:
            self._refuse("too many brackets within each other")
        terms: Terms = {}
        under = ONE
        sign = 1
        while True:
            while self._peek() in ("+", "-"):
                sign = -sign if self._peek() == "-" else sign
                self.at += 1
            added, below = self._product(depth)
            if below != under:
                # over one denominator: 1/s + 2/s² = (s + 2)/s²
                shared = min(power for part in (below, under) for power, _ in part)
                below, lower = _without(below, shared), _without(under, shared)
                terms, added, under = self._times(terms, below), self._times(added, lower), self._times(under, below)
            for key, value in added.items():
                terms[key] = total((terms.get(key, (0, 1)), (sign * value[0], value[1])))
            if self._peek() not in ("+", "-") or not self._peek():
                return terms, under
            sign = 1

    def _product(self, depth: int) -> "Quotient":
        terms, under = self._power(depth)
        while self._peek() and self._peek() not in "+-)":
            if self._peek() == "/":
                self.at += 1
                over, below = self._power(depth)
                divisor = {key: value for key, value in over.items() if value[0]}
                terms = self._times(terms, below)
                if self.quotients and divisor and list(divisor) != [(0, 0)]:
                    under = self._times(under, divisor)
                    continue
                if list(divisor) != [(0, 0)]:
                    self._refuse(
                        "a polynomial is divided by numbers other than zero only",
                        "multiply the whole by the denominator: s(s+2) + K instead of 1 + K/(s(s+2))",
                    )
                top, bottom = divisor[0, 0]
                terms = {key: product(value, lowest(bottom, top)) for key, value in terms.items()}
            else:
                self.at += self._peek() == "*"
                over, below = self._power(depth)
                terms, under = self._times(terms, over), self._times(under, below)
        return terms, under

    def _times(self, first: "Terms", second: "Terms") -> "Terms":
        out: Terms = {}
        for (a, j), coefficient in first.items():
            for (b, k), other in second.items():
                key = a + b, j + k
                if key[0] > MOST_DEGREE or key[1] > MOST_DEGREE:
                    self._refuse(f"the degree goes beyond {MOST_DEGREE}")
                out[key] = total((out.get(key, (0, 1)), product(coefficient, other)))
        return out

    def _power(self, depth: int) -> "Quotient":
        base = self._factor(depth)
        if self._peek() == "^":
            self.at += 1
            word = self._digits()
        else:
            word = ""
            while self._peek() in RAISED and self._peek():
                word += RAISED[self._peek()]
                self.at += 1
            if not word:
                return base
        if not word or len(word) > 2 or int(word) > MOST_DEGREE:
            self._refuse(f"a power is a whole number up to {MOST_DEGREE}")
        over, under = ONE, ONE
        for _ in range(int(word)):
            over, under = self._times(over, base[0]), self._times(under, base[1])
        return over, under

    def _factor(self, depth: int) -> "Quotient":
        letter = self._peek()
        if letter == "(":
            self.at += 1
            terms = self._sum(depth + 1)
            if self._peek() != ")":
                self._refuse("a bracket is not closed")
            self.at += 1
            return terms
        if letter in self.powers:
            self.at += 1
            return {self.powers[letter]: (1, 1)}, ONE
        if letter.isascii() and (letter.isdigit() or letter == "."):
            return {(0, 0): self._number()}, ONE
        if letter.isalpha():
            capital = letter.upper() in self.powers
            self._refuse(f"{letter!r} has no value" + (f"; write a capital {letter.upper()}" if capital else ""))
        self._refuse(
            "it ends too early" if not letter else f"{letter!r} is not wanted here",
            "coefficients within ranges are for: dynamics stability interval" if letter == "±" else "",
        )
        raise AssertionError

    def _digits(self) -> str:
        start = self.at
        while self._peek().isascii() and self._peek().isdigit():
            self.at += 1
        return self.text[start : self.at]

    def _number(self) -> "Pair":
        before = self._digits()
        after = ""
        if self._peek() == ".":
            self.at += 1
            after = self._digits()
        exponent = 0
        mark = self.text[self.at : self.at + 3]
        if mark[:1] in ("e", "E") and (mark[1:2].isdigit() or (mark[1:2] in ("+", "-") and mark[2:].isdigit())):
            self.at += 2 if mark[1:2] in ("+", "-") else 1
            word = self._digits()
            exponent = int(word[:4]) * (-1 if mark[1:2] == "-" else 1)
        if not before + after or len(before + after) > MOST_DIGITS or abs(exponent) > MOST_EXPONENT:
            self._refuse(f"a number has up to {MOST_DIGITS} digits and powers of ten up to {MOST_EXPONENT}")
        shift = exponent - len(after)
        return lowest(int(before + after) * 10 ** max(shift, 0), 10 ** max(-shift, 0))

    def _refuse(self, why: str, remedy: str = "") -> None:
        names = " and ".join(self.powers)
        example = "s^3 + 2s^2 + 3/7".replace("s", next(iter(self.powers), "s"))
        rest = self.text[self.at : self.at + 12]
        raise UsageError(
            f"{self.typed!r}{f', at {rest!r}' if rest else ''}: {why}" if self.typed.strip() else "nothing is written",
            code="polynomial",
            hint=remedy
            or (f"write a polynomial in {names}, such as {example}" if names else "write numbers such as 2.5 or 3/7"),
        )
