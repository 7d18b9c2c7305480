"""Formulas as typed, `20*t - 2*t^2`, parsed into a small tree and evaluated; never by `eval`.

Numbers, variables, pi, + − * / ^ (also **), brackets and the functions of `FUNCTIONS`. A tree is evaluated on doubles,
arrays, tracked numbers, numbers of many digits and jets (`jets.Jet`), which give exact derivatives.
"""

import math

from dynamics_cli.errors import UsageError
from dynamics_cli.numerics import elementary
from dynamics_cli.numerics.elementary import pi_beside
from dynamics_cli.numerics.expressions import jets
from dynamics_cli.numerics.number import is_array, plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection, Iterator, Mapping
    from typing import Any, Protocol, TypeAlias

    # an operation and its operands: numbers (those with a unit have a dimension too), names, trees
    Tree: TypeAlias = tuple[Any, ...]

    class Units(Protocol):
        """What units there are."""

        def get(self, name: str, /) -> tuple[float, tuple[int, ...]] | None:
            """The size of a unit in SI, and its dimension."""


FUNCTIONS = tuple(jets.FUNCTIONS)
MOST_DEPTH = 60
LONGEST = 2000
SIGNS = {"−": "-", "·": "*", "×": "*", "÷": "/"}
PRODUCTS, SUMS = ("*", "/"), ("+", "-")


class Expression:
    """A formula: its text, its tree, the variables in it, and where in the text it ends."""

    __slots__ = ("end", "names", "text", "tree")

    def __init__(self, text: str, tree: "Tree", end: int) -> None:
        self.text = text
        self.tree = tree
        self.end = end
        self.names = frozenset(_names(tree))

    def __call__(self, **variables: "Any") -> "Any":
        """The value for these variables: numbers of any type, or jets."""
        beside = [x.parts[0] if isinstance(x, jets.Jet) else x for x in variables.values()]
        return _value(self.tree, variables, pi_beside(*beside))


def parse(
    text: str,
    variables: "frozenset[str] | set[str] | tuple[str, ...] | None" = None,
    units: "Units | None" = None,
    taken: "Collection[str]" = (),
) -> Expression:
    """Read a whole formula; refuse trailing text and names that are not variables.

    Numbers may have these units; in `3 m/s*m` the last m is a variable if that name is taken.

    >>> parse("3*t^2 - sin(t)")(t=2.0)
    11.090702573174319
    """
    formula = begin(text, units, taken)
    if formula.end < len(text.rstrip()):
        rest = text[formula.end :]
        start = formula.end + len(rest) - len(rest.lstrip())
        _refuse(text, start, f"{rest.strip()[:20]!r} cannot follow here in the formula")
    if variables is not None:
        check_names(formula, variables)
    return formula


def check_names(formula: Expression, variables: "frozenset[str] | set[str] | tuple[str, ...]", more: str = "") -> None:
    """Refuse variables that have no value; the hint says `more`."""
    for name in sorted(formula.names - set(variables)):
        names = ", ".join(sorted(variables))
        start = _position_of(formula.text, name)
        hint = f"variables here: {names}; functions: sin, sqrt, …{more}"
        _refuse(formula.text, start, f"{name!r} has no value", hint=hint)


def begin(text: str, units: "Units | None" = None, taken: "Collection[str]" = ()) -> Expression:
    """Read the formula at the beginning of a text; the text after it, such as a unit, begins at `end`."""
    if len(text) > LONGEST:
        raise UsageError(f"the formula has more than {LONGEST} characters", code="expression")
    reader = _Reader("".join(SIGNS.get(letter, letter) for letter in text), units, taken)
    tree = reader.sum(0)
    return Expression(text, tree, reader.at)


class _Reader:
    """Reads a formula from left to right, by precedence."""

    def __init__(self, text: str, units: "Units | None", taken: "Collection[str]") -> None:
        self.text = text
        self.units, self.taken = units, taken
        self.at = 0

    def peek(self) -> str:
        """The next character that is not a space, without taking it; empty at the end."""
        start = self._blank(self.at)
        return self.text[start : start + 1]

    def take(self) -> str:
        """Take the next character that is not a space."""
        while self.text[self.at].isspace():
            self.at += 1
        self.at += 1
        return self.text[self.at - 1]

    def sum(self, depth: int) -> "Tree":
        """Sum: product { ("+" | "-") product }."""
        if depth > MOST_DEPTH:
            _refuse(self.text, self.at, "brackets are nested too deeply")
        tree = self.product(depth)
        while self.peek() in SUMS:
            sign = self.take()
            tree = (sign, tree, self.product(depth))
        return tree

    def product(self, depth: int) -> "Tree":
        """Product: signed { ("*" | "/") signed }."""
        tree = self.signed(depth)
        while self.peek() in PRODUCTS:
            sign = self.take()
            tree = (sign, tree, self.signed(depth))
        return tree

    def signed(self, depth: int) -> "Tree":
        """Sign: ("+" | "-") signed, or raised: the minus of -t^2 is applied last."""
        if self.peek() in SUMS:
            if depth > MOST_DEPTH:
                _refuse(self.text, self.at, "too many signs in a row")
            sign = self.take()
            tree = self.signed(depth + 1)
            return ("neg", tree) if sign == "-" else tree
        return self.raised(depth)

    def raised(self, depth: int) -> "Tree":
        """Power: operand [ ("^" | "**") signed ]; a^b^c is a^(b^c)."""
        base = self.operand(depth)
        rest = self.text[self.at :].lstrip()
        if rest.startswith(("^", "**")):
            self.take()
            if rest.startswith("**"):
                self.take()
            return ("^", base, self.signed(depth + 1))
        return base

    def operand(self, depth: int) -> "Tree":
        """Operand: number, name, function of an argument, or "(" sum ")"."""
        letter = self.peek()
        if not letter:
            _refuse(self.text, len(self.text), "the formula ends where a number, a variable or a bracket is expected")
        if letter == "(":
            self.take()
            return self.measured(self.closed(depth))
        if letter.isdigit() or letter == ".":
            return self.measured(("number", self.number()))
        if letter.isalpha() or letter == "_":
            return self.name(depth)
        self.take()
        _refuse(self.text, self.at - 1, f"{letter!r} is not expected here")
        raise AssertionError

    def measured(self, tree: "Tree") -> "Tree":
        """The number or bracket times the unit after it, which goes on as long as units follow: 5 N*s/m*v."""
        dimension: tuple[int, ...] = (0,) * 7
        size, way, end = 1.0, 1, -1
        while self.units and (unit := self.unit(() if end < 0 else self.taken)) is not None:
            factor, powers, power = unit
            size *= factor ** (way * power)
            dimension = tuple(a + way * power * b for a, b in zip(dimension, powers, strict=True))
            end = self.at
            if self.peek() not in PRODUCTS:
                break
            way = 1 if self.take() == "*" else -1
        if end < 0:
            return tree
        self.at = end
        return ("*", tree, ("number", size, dimension))

    def unit(self, taken: "Collection[str]") -> "tuple[float, tuple[int, ...], int] | None":
        """A unit here, with its power; without one None, and nothing is read."""
        start = self._blank(self.at)
        at = start
        while at < len(self.text) and (self.text[at].isalnum() or self.text[at] in "_°%"):
            at += 1
        word = self.text[start:at]
        known = self.units.get(word) if self.units and word and not word[0].isdigit() and word not in taken else None
        if known is None or self.text[self._blank(at) :].startswith("("):
            return None
        self.at = at
        at = self._blank(at)
        for sign in ("**", "^"):
            if self.text.startswith(sign, at):
                at += len(sign)
                end = at + self.text.startswith("-", at) + 1
                if self.text[end - 1 : end].isdigit():
                    self.at = end
                    return *known, int(self.text[at:end])
        return *known, 1

    def _blank(self, at: int) -> int:
        while at < len(self.text) and self.text[at].isspace():
            at += 1
        return at

    def closed(self, depth: int) -> "Tree":
        """Bracket: sum ")", the opening bracket just taken."""
        opened = self.at - 1
        tree = self.sum(depth + 1)
        if self.peek() != ")":
            _refuse(self.text, opened, "this bracket is not closed")
        self.take()
        return tree

    def number(self) -> float:
        """A decimal number with an optional exponent; refuses one beyond a double."""
        self.take()
        start = self.at - 1
        while self.at < len(self.text) and (self.text[self.at].isdigit() or self.text[self.at] == "."):
            self.at += 1
        mark = self.text[self.at : self.at + 1]
        rest = self.text[self.at + 1 : self.at + 3]
        if mark in ("e", "E") and (rest[:1].isdigit() or (rest[:1] in SUMS and rest[1:].isdigit())):
            self.at += 2
            while self.at < len(self.text) and self.text[self.at].isdigit():
                self.at += 1
        word = self.text[start : self.at]
        try:
            value = float(word) if word.isascii() else math.nan
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            _refuse(self.text, start, f"{word!r} is not a number")
        return value

    def name(self, depth: int) -> "Tree":
        """A variable, pi, or a function with its argument in brackets."""
        self.take()
        start = self.at - 1
        while self.at < len(self.text) and (self.text[self.at].isalnum() or self.text[self.at] == "_"):
            self.at += 1
        word = self.text[start : self.at]
        if self.peek() == "(":
            if word not in FUNCTIONS:
                _refuse(
                    self.text, start, f"there is no function {word!r}", hint=f"functions are {', '.join(FUNCTIONS)}"
                )
            self.take()
            return (word, self.closed(depth))
        if word in FUNCTIONS:
            _refuse(self.text, start, f"{word} needs its argument in brackets", hint=f"for example {word}(2*t)")
        return ("pi",) if word == "pi" else ("name", word)


def _refuse(text: str, at: int, why: str, hint: str = "") -> None:
    where = f"{text[: at + 1].lstrip()[-20:]!r}" if at < len(text) else "its end"
    raise UsageError(
        f"{text!r}, at character {at + 1} ({where}): {why}",
        code="expression",
        hint=hint or "a formula such as 3*t^2 - 2*sin(t)",
    )


def _position_of(text: str, name: str) -> int:
    start = text.find(name)
    while start >= 0 and (
        text[start - 1 : start].isalnum() or text[start + len(name) : start + len(name) + 1].isalnum()
    ):
        start = text.find(name, start + 1)
    return max(start, 0)


def _names(tree: "Tree") -> "Iterator[str]":
    if tree[0] == "name":
        yield tree[1]
    elif tree[0] not in ("number", "pi"):
        for part in tree[1:]:
            yield from _names(part)


def _value(tree: "Tree", variables: "Mapping[str, Any]", pi: "Any") -> "Any":
    operation = tree[0]
    if operation == "number":
        return tree[1]
    if operation == "name":
        return variables[tree[1]]
    if operation == "pi":
        return pi
    first = _value(tree[1], variables, pi)
    if operation == "neg":
        return -first
    if len(tree) == 2:
        return _function(operation, first)
    second = _value(tree[2], variables, pi)
    if isinstance(second, jets.Jet) and not isinstance(first, jets.Jet):
        # numbers that carry more than a double cannot operate on jets
        first = jets.Jet([first, *[0.0] * (len(second.parts) - 1)])
    if operation == "+":
        return first + second
    if operation == "-":
        return first - second
    if operation == "*":
        return first * second
    return first / second if operation == "/" else _power(first, second)


def _function(name: str, x: "Any") -> "Any":
    if isinstance(x, jets.Jet):
        return jets.FUNCTIONS[name](x)
    if name == "abs":
        return abs(x)
    return getattr(elementary, name)(x)


def _power(base: "Any", exponent: "Any") -> "Any":
    if isinstance(base, jets.Jet) or isinstance(exponent, jets.Jet):
        return jets.power(base, exponent)
    power = plain(exponent)
    if not is_array(power) and power == int(power) and abs(power) <= 64:
        return jets.whole_power(base, int(power))
    return elementary.exp(exponent * elementary.log(base))


def constant(tree: "Tree") -> "float | None":
    """The value of a tree without variables; None where it has some."""
    return float(_value(tree, {}, math.pi)) if not any(_names(tree)) else None
