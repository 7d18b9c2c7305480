"""Laws of cam motion for the search, to 240 bits: polynomials and sines of each branch, made as the references are.

Accelerations are written down piece by piece and integrated from piece to piece, polynomials come from their boundary
conditions in rationals: nothing is folded about the middle, and no constant is the program's. A branch gives a law and
its derivatives to any order at a real of 240 bits, and in doubles at an array, which only says where to look.
"""

from fractions import Fraction
from functools import cache
from math import factorial
from typing import Any

import numpy as np
from precise import FUNCTIONS, Exact, exact_pi

Wave = tuple[Any, Any, int]


class Branch:
    """f(x) = Σ cᵢ tⁱ + Σ A sin(ωt + kπ/2), t = x − low, for low ≤ x ≤ high."""

    def __init__(self, low: Any, high: Any, powers: list[Any], waves: list[Wave]) -> None:
        self.low, self.high = Exact(low), Exact(high)
        self.waves = [(Exact(size), Exact(rate), quarter) for size, rate, quarter in waves]
        self.powers = [[Exact(c) for c in powers]]
        for _ in range(5):
            self.powers.append([i * c for i, c in enumerate(self.powers[-1])][1:])
        self.doubles = [[float(c) for c in row] for row in self.powers]
        self.rough = [(float(size), float(rate), quarter) for size, rate, quarter in self.waves]

    def at(self, x: Any, order: int) -> list[Any]:
        """The law and its derivatives."""
        t = x - self.low
        found = []
        for row in self.powers[: order + 1]:
            value = Exact(0)
            for c in reversed(row):
                value = value * t + c
            found.append(value)
        for size, rate, quarter in self.waves:
            sin, cos = FUNCTIONS["sin"](rate * t), FUNCTIONS["cos"](rate * t)
            turned = (sin, cos, -sin, -cos)
            for k in range(order + 1):
                found[k] += size * turned[(quarter + k) % 4]
                size = size * rate
        return found

    def over(self, x: Any, order: int) -> list[Any]:
        """The same in doubles at an array."""
        t = x - float(self.low)
        found = [np.polynomial.polynomial.polyval(t, row) if row else 0.0 * t for row in self.doubles[: order + 1]]
        for size, rate, quarter in self.rough:
            sin, cos = np.sin(rate * t), np.cos(rate * t)
            turned = (sin, cos, -sin, -cos)
            for k in range(order + 1):
                found[k] = found[k] + size * rate**k * turned[(quarter + k) % 4]
        return found


def _pulse(kind: str, length: Any) -> tuple[list[Any], list[Wave]]:
    """What an acceleration of unit peak gains from rest: powers of t and waves."""
    rate = exact_pi() / (2 * length)
    zero, half = Exact(0), Exact(1) / 2
    if kind == "rise":
        return [zero, 1 / rate], [(-1 / rate**2, rate, 0)]
    if kind == "fall":
        return [1 / rate**2], [(-1 / rate**2, rate, 1)]
    if kind == "flat":
        return [zero, zero, half], []
    if kind == "up":
        return [zero, zero, zero, 1 / (6 * length)], []
    if kind == "down":
        return [zero, zero, half, -1 / (6 * length)], []
    return [zero], []


def pulses(pieces: list[tuple[Any, str, int]]) -> list[Branch]:
    """A law from its acceleration: (length, kind, sign) pieces."""
    start = level = speed = Exact(0)
    raw = []
    for length, kind, sign in pieces:
        powers, waves = _pulse(kind, length)
        powers = [sign * c for c in powers] + [Exact(0)] * (2 - len(powers))
        waves = [(sign * size, rate, quarter) for size, rate, quarter in waves]
        powers[0], powers[1] = powers[0] + level, powers[1] + speed
        made = Branch(start, start + length, powers, waves)
        raw.append((made, powers, waves))
        level, speed = made.at(made.high, 1)
        start = start + length
    return [
        Branch(made.low, made.high, [c / level for c in powers], [(a / level, w, k) for a, w, k in waves])
        for made, powers, waves in raw
    ]


def scca(b: Any, c: Any, d: Any, constant: Any = 0) -> list[Branch]:
    """Sine, constant and cosine acceleration in shares of each half, constant velocity between."""
    q = (1 - Exact(constant)) / 2
    first = [(Exact(b) * q, "rise", 1), (Exact(c) * q, "flat", 1), (Exact(d) * q, "fall", 1)]
    first.append((Exact(constant) / 2, "none", 1))
    mirror = {"rise": "fall", "fall": "rise", "flat": "flat", "none": "none"}
    second = [(length, mirror[kind], -1) for length, kind, _ in reversed(first)]
    return pulses([piece for piece in first + second if piece[0]])


def polynomial(conditions: list[tuple[Any, int, Any]]) -> list[Branch]:
    """The polynomial through (place, order, value), its system solved in rationals."""
    n = len(conditions)
    rows = [
        [Fraction(factorial(i), factorial(i - k)) * Fraction(x) ** (i - k) if i >= k else Fraction(0) for i in range(n)]
        + [Fraction(value)]
        for x, k, value in conditions
    ]
    for i in range(n):
        pivot = next(j for j in range(i, n) if rows[j][i])
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [value / rows[i][i] for value in rows[i]]
        for j in range(n):
            if j != i and rows[j][i]:
                share = rows[j][i]
                rows[j] = [a - share * b for a, b in zip(rows[j], rows[i], strict=True)]
    return [Branch(0, 1, [Exact(row[-1].numerator) / row[-1].denominator for row in rows], [])]


def _rest_to_rest(degree: int) -> list[Branch]:
    orders = range((degree + 1) // 2)
    return polynomial([(0, k, 0) for k in orders] + [(1, k, 1 if k == 0 else 0) for k in orders])


def _sines(*terms: tuple[int, Any]) -> list[Branch]:
    """x − Σ A/(2π) sin 2πkx."""
    turn = 2 * exact_pi()
    return [Branch(0, 1, [0, 1], [(-Exact(a.numerator) / a.denominator / turn, turn * k, 0) for k, a in terms])]


def _trapezoid() -> list[Branch]:
    e, q = Exact(1) / 8, Exact(1) / 4
    up = [(e, "up", 1), (q, "flat", 1), (e, "down", 1)]
    return pulses(up + [(length, kind, -1) for length, kind, _ in up])


def _named(name: str) -> list[Branch]:
    pi, half, quarter = exact_pi(), Exact(1) / 2, Exact(1) / 4
    share = Fraction
    if name in ("cubic", "3-4-5", "4-5-6-7", "5-6-7-8-9"):
        return _rest_to_rest({"cubic": 3, "3-4-5": 5, "4-5-6-7": 7, "5-6-7-8-9": 9}[name])
    made = {
        "linear": lambda: [Branch(0, 1, [0, 1], [])],
        "parabolic": lambda: scca(0, 1, 0),
        "harmonic": lambda: [Branch(0, 1, [half], [(-half, pi, 1)])],
        "double-harmonic": lambda: [Branch(0, 1, [Exact(3) / 8], [(-half, pi, 1), (Exact(1) / 8, 2 * pi, 1)])],
        "cycloidal": lambda: _sines((1, share(1))),
        "modified-trapezoid": lambda: scca(quarter, half, quarter),
        "modified-sine": lambda: scca(quarter, 0, 3 * quarter),
        "trapezoid": _trapezoid,
        "gutman-1-3": lambda: _sines((1, share(15, 16)), (3, share(1, 48))),
        "freudenstein-1-3": lambda: _sines((1, share(27, 28)), (3, share(1, 84))),
        "freudenstein-1-3-5": lambda: _sines(
            (1, share(1125, 1192)), (3, share(1125, 1192 * 54)), (5, share(1125, 1192 * 1250))
        ),
        "half-cycloid-start": lambda: [Branch(0, 1, [0, 1], [(-1 / pi, pi, 0)])],
        "half-cycloid-end": lambda: [Branch(0, 1, [0, 1], [(1 / pi, pi, 0)])],
        "half-harmonic-start": lambda: [Branch(0, 1, [1], [(-Exact(1), pi / 2, 1)])],
        "half-harmonic-end": lambda: [Branch(0, 1, [0], [(Exact(1), pi / 2, 0)])],
    }
    return made[name]()


RESTING = (
    "cycloidal", "modified-sine", "modified-trapezoid", "3-4-5", "4-5-6-7", "5-6-7-8-9", "gutman-1-3",
    "freudenstein-1-3", "freudenstein-1-3-5", "trapezoid",
)  # fmt: skip
JERKY = ("harmonic", "double-harmonic", "parabolic", "cubic")
MOVING = ("linear", "half-cycloid-start", "half-cycloid-end", "half-harmonic-start", "half-harmonic-end")
NAMES = (*RESTING, *JERKY, *MOVING)


@cache
def law_of(name: str, numbers: tuple[float, ...] = ()) -> tuple[Branch, ...]:
    """The branches of a law by its name; `numbers` are the doubles that follow it in a program."""
    if name == "scca":
        return tuple(scca(*(Exact(number) for number in numbers)))
    if name == "modified-constant-velocity":
        constant = Exact(numbers[0]) if numbers else Exact(1) / 2
        return tuple(scca(Exact(1) / 4, 0, Exact(3) / 4, constant))
    return tuple(_named(name))
