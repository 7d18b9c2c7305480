"""A program of cam motion for the search: its words read anew, its zones as reals of 240 bits, and their jets.

Doubles are what a program is read into (levels in metres or radians, spans exactly in degrees); all else is exact.
"""

from fractions import Fraction
from typing import Any

import numpy as np
from cam_search_laws import Branch, law_of
from precise import FUNCTIONS, Exact, exact_pi

LENGTHS = {"mm": Fraction(1, 1000), "m": Fraction(1), "um": Fraction(1, 10**6), "in": Fraction(127, 5000)}
Clause = dict[str, Any]


def exact(number: Fraction) -> Any:
    """A ratio to 240 bits."""
    return Exact(number.numerator) / number.denominator


def radians(degrees: Fraction) -> Any:
    """Degrees in radians."""
    return exact(degrees) * exact_pi() / 180


def read(text: str) -> list[Clause]:
    """The clauses of a program: move, amount (metres, or degrees of swing), span in degrees, law and its numbers."""
    clauses = []
    for part in text.split(";"):
        words = part.split()
        clause: Clause = {
            "move": words.pop(0),
            "amount": None,
            "swing": False,
            "span": None,
            "law": None,
            "numbers": (),
        }
        if clause["move"] == "dwell":
            if words:
                clause["span"] = Fraction(words[0])
            clauses.append(clause)
            continue
        if words and words[0] not in ("in", "to") and len(words) > 1 and words[1] in (*LENGTHS, "deg"):
            amount, unit = Fraction(words.pop(0)), words.pop(0)
            clause["swing"] = unit == "deg"
            clause["amount"] = amount * LENGTHS.get(unit, 1)
        if words and words[0] == "in":
            clause["span"] = Fraction(words[1])
            words = words[3:]
        if words:
            names = [word for word in words if not word[0].isdigit() or word.count("-") > 1]
            clause["law"] = "-".join(names)
            clause["numbers"] = tuple(float(word) for word in words if word not in names)
        clauses.append(clause)
    return clauses


def decimal(number: Fraction) -> str:
    """A ratio of two and five as a decimal."""
    text = repr(float(number))
    if Fraction(text) == number:
        return text
    power = 0
    while number.denominator != 1:
        number, power = number * 10, power + 1
    return f"{number.numerator}e-{power}"


def written(clauses: list[Clause]) -> str:
    """Clauses as the program's words."""
    parts = []
    for clause in clauses:
        words = [clause["move"]]
        if clause["move"] != "dwell":
            if clause["amount"] is not None:
                unit, scale = ("deg", 1) if clause["swing"] else ("mm", 1000)
                words.append(f"{decimal(clause['amount'] * scale)} {unit}")
            if clause["span"] is not None:
                words.append(f"in {decimal(clause['span'])} deg")
            words += [clause["law"] or "3-4-5", *map(repr, clause["numbers"])]
        elif clause["span"] is not None:
            words.append(f"{decimal(clause['span'])} deg")
        parts.append(" ".join(words))
    return "; ".join(parts)


def levels_of(clauses: list[Clause]) -> list[float]:
    """The doubles of the lift at every joint."""
    found = [0.0]
    for clause in clauses:
        now = found[-1]
        if clause["move"] == "dwell":
            found.append(now)
        elif clause["amount"] is None:
            found.append(0.0)
        else:
            amount = float(radians(clause["amount"])) if clause["swing"] else float(clause["amount"])
            then = now + amount if clause["move"] == "rise" else now - amount
            found.append(0.0 if abs(then) <= 1e-12 * max(now, amount) else then)
    found[-1] = 0.0
    return found


class Zone:
    """A stretch of the turn on which the lift is one branch of one law; angles are exact."""

    def __init__(self, start: Any, width: Any, low: float, high: float, branch: Branch | None) -> None:
        self.branch, self.origin, self.width = branch, start, width
        self.low, self.rise = Exact(low), Exact(high) - Exact(low)
        self.start = start if branch is None else start + width * branch.low
        self.end = start + width if branch is None else start + width * branch.high

    def at(self, theta: Any, order: int) -> list[Any]:
        """Lift and derivatives per radian at an angle, near the zone's ends also a little beyond."""
        if self.branch is None:
            return [self.low, *[Exact(0)] * order]
        found = self.branch.at((theta - self.origin) / self.width, order)
        scale = self.rise
        for k in range(order + 1):
            found[k] *= scale
            scale = scale / self.width
        found[0] += self.low
        return found

    def over(self, share: Any, order: int) -> list[Any]:
        """The same in doubles at shares of the zone."""
        if self.branch is None:
            return [0.0 * share + float(self.low), *[0.0 * share] * order]
        low, high = float(self.branch.low), float(self.branch.high)
        found = self.branch.over(low + (high - low) * share, order)
        width = float(self.width)
        made = [float(self.rise) / width**k * found[k] for k in range(order + 1)]
        made[0] = made[0] + float(self.low)
        return made

    def jets(self, theta: Any, shift: int = 0) -> "tuple[Jet, Jet, Jet]":
        """Lift (or a derivative) and its next two derivatives, with two more derivatives each."""
        s = self.at(theta, 4 + shift)[shift:]
        return Jet(*s[0:3]), Jet(*s[1:4]), Jet(*s[2:5])


class Turn:
    """One turn of a program."""

    def __init__(self, text: str) -> None:
        self.clauses = read(text)
        self.levels = levels_of(self.clauses)
        self.swing = any(clause["swing"] for clause in self.clauses)
        known = sum((clause["span"] for clause in self.clauses if clause["span"] is not None), Fraction(0))
        spans = [360 - known if clause["span"] is None else clause["span"] for clause in self.clauses]
        spans[-1] += 360 - sum(spans)
        at = Fraction(0)
        self.zones: list[Zone] = []
        self.edges = [Fraction(0)]
        for i, (clause, span) in enumerate(zip(self.clauses, spans, strict=True)):
            law = () if clause["move"] == "dwell" else law_of(clause["law"] or "3-4-5", clause["numbers"])
            for branch in law or (None,):
                self.zones.append(Zone(radians(at), radians(span), self.levels[i], self.levels[i + 1], branch))
            at += span
            self.edges.append(at)
        self.joints = [float(radians(edge)) for edge in self.edges]
        self.ends = [float(zone.end) for zone in self.zones]

    def zones_at(self, theta: float) -> list[tuple[Zone, Any]]:
        """The zones an angle of a table may be meant to lie in, and the exact angle it means there.

        An angle that is the double of a joint means the joint; within a rounding of a branch's end either side may be.
        """
        near = 2.0**-50 * max(theta, 1e-3)
        found = []
        for zone in self.zones:
            low, high = float(zone.start), float(zone.end)
            if low - near <= theta <= high + near:
                meant = zone.start if theta == low else zone.end if theta == high else Exact(theta)
                found.append((zone, meant))
        return found


class Jet:
    """A number with its first two derivatives by cam angle."""

    __slots__ = ("first", "second", "value")

    def __init__(self, value: Any, first: Any, second: Any) -> None:
        self.value, self.first, self.second = value, first, second

    def __neg__(self) -> "Jet":
        return Jet(-self.value, -self.first, -self.second)

    def __add__(self, other: Any) -> "Jet":
        if type(other) is not Jet:
            return Jet(self.value + other, self.first, self.second)
        return Jet(self.value + other.value, self.first + other.first, self.second + other.second)

    __radd__ = __add__

    def __sub__(self, other: Any) -> "Jet":
        return self + -other

    def __rsub__(self, other: Any) -> "Jet":
        return -self + other

    def __mul__(self, other: Any) -> "Jet":
        if type(other) is not Jet:
            return Jet(self.value * other, self.first * other, self.second * other)
        a, b = self, other
        return Jet(
            a.value * b.value,
            a.first * b.value + a.value * b.first,
            a.second * b.value + 2 * a.first * b.first + a.value * b.second,
        )

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> "Jet":
        if type(other) is not Jet:
            return Jet(self.value / other, self.first / other, self.second / other)
        value = self.value / other.value
        first = (self.first - value * other.first) / other.value
        return Jet(value, first, (self.second - 2 * first * other.first - value * other.second) / other.value)

    def __rtruediv__(self, other: Any) -> "Jet":
        return as_jet(other) / self

    def through(self, value: Any, first: Any, second: Any) -> "Jet":
        """A function of this number, from its value and derivatives here."""
        return Jet(value, first * self.first, second * self.first * self.first + first * self.second)


def as_jet(x: Any) -> Jet:
    """A constant as a jet."""
    return x if type(x) is Jet else Jet(x, Exact(0), Exact(0))


def sqrt(x: Any) -> Any:
    """Square root of a jet, a real or an array."""
    if type(x) is Jet:
        root = FUNCTIONS["sqrt"](x.value)
        return x.through(root, 1 / (2 * root), -1 / (4 * root * x.value))
    return np.sqrt(x) if isinstance(x, np.ndarray | float) else FUNCTIONS["sqrt"](x)


def sine_cosine(x: Any) -> tuple[Any, Any]:
    """Sine and cosine of a jet, a real or an array."""
    if type(x) is Jet:
        sin, cos = FUNCTIONS["sin"](x.value), FUNCTIONS["cos"](x.value)
        return x.through(sin, cos, -sin), x.through(cos, -sin, -cos)
    if isinstance(x, np.ndarray | float):
        return np.sin(x), np.cos(x)
    return FUNCTIONS["sin"](x), FUNCTIONS["cos"](x)


def arc_tangent(y: Any, x: Any) -> Any:
    """The angle of (x, y), of jets, reals or arrays."""
    if type(y) is Jet or type(x) is Jet:
        y, x = as_jet(y), as_jet(x)
        square = x * x + y * y
        rate = (x.value * y.first - y.value * x.first) / square.value
        second = (x.value * y.second - y.value * x.second - rate * square.first) / square.value
        return Jet(FUNCTIONS["atan2"](y.value, x.value), rate, second)
    if isinstance(y, np.ndarray) or isinstance(x, np.ndarray | float):
        return np.arctan2(y, x)
    return FUNCTIONS["atan2"](y, x)
