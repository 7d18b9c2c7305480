"""Numbers of many digits for the generators: MPFR's by gmpy2, or mpmath's, slower, where that is not installed.

A `Field` is an arithmetic: its numbers, π and elementary functions. `MANY` has 300 bits (90 digits), `MPMATH` what
mpmath has; `DOUBLES` are NumPy's, on arrays at once, to look where something happens before `MANY` say what it is.
"""

from typing import Any

import numpy as np
from mpmath import mp, mpf

try:
    import gmpy2
except ImportError:
    gmpy2 = None

BITS = 300
# mpmath's own numbers are as long
mp.prec = BITS
if gmpy2:
    gmpy2.get_context().precision = BITS


class Field:
    """Numbers (from text or doubles), π, and functions of them."""

    def __init__(self, number: Any, pi: Any, library: Any) -> None:
        self.number = number
        self.pi = pi
        self.library = library
        self.sqrt, self.sin, self.cos = library.sqrt, library.sin, library.cos

    def double(self, text: Any) -> Any:
        """The double that a text reads as."""
        return self.number(float(text))


MANY = Field(gmpy2.mpfr, gmpy2.const_pi(), gmpy2) if gmpy2 else Field(mpf, +mp.pi, mp)
MPMATH = Field(mpf, +mp.pi, mp)
DOUBLES = Field(lambda text: float(mpf(text)), float(mp.pi), np)


def written(value: Any, digits: int = 40) -> str:
    """Digits of a number as text, with an exponent; what is left of zeros is none (no size here is so small)."""
    number = mpf(str(value))
    if abs(number) < mpf(10) ** -50:
        return "0.0"
    return str(mp.nstr(number, digits, min_fixed=1, max_fixed=0))


def solved(equations: Any, start: Any) -> list[Any]:
    """A root of as many equations as unknowns: Newton's method with differences of 1e-40 for derivatives."""
    at, step = [MANY.number(x) for x in start], MANY.number("1e-40")
    for _ in range(60):
        values = equations(*at)
        moved = [equations(*(x + (step if i == k else 0) for i, x in enumerate(at))) for k in range(len(at))]
        rows = [[*((moved[k][row] - value) / step for k in range(len(at))), -value] for row, value in enumerate(values)]
        change = _eliminated(rows)
        at = [x + dx for x, dx in zip(at, change, strict=True)]
        if max(map(abs, change)) < 10**-60:
            return at
    raise ArithmeticError("no root found")


def _eliminated(rows: list[list[Any]]) -> list[Any]:
    """The solution of linear equations, the largest pivot first."""
    n = len(rows)
    for i in range(n):
        best = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[best] = rows[best], rows[i]
        for k in range(n):
            if k != i:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i], strict=True)]
    return [rows[i][n] / rows[i][i] for i in range(n)]
