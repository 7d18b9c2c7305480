"""The pieces rise laws are made of: each gives a function that is zero at its end of the rise, with its derivatives.

A shape is called with a distance t ≥ 0 from the end of the rise it belongs to (x at the start, 1 − x at the end), so
that it keeps its digits where the rise begins and ends; t is a float or an array.
"""

import math

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Σ (−1)^n 6 u^(2n)/(2n + 3)!: what u − sin u is of u³/6, as ratios of neighbouring terms.
_RATIOS = tuple(1.0 / ((2.0 * n + 4.0) * (2.0 * n + 5.0)) for n in range(8))
_SERIES_BELOW = 1.0


def _series(u: "Any") -> "Any":
    square = u * u
    total = 1.0
    for ratio in reversed(_RATIOS):
        total = 1.0 - square * ratio * total
    return u * square / 6.0 * total


def u_minus_sine(u: "Any") -> "Any":
    """u − sin u to a few roundings also where u is small."""
    if type(u) is float:
        return _series(u) if -_SERIES_BELOW < u < _SERIES_BELOW else u - math.sin(u)
    import numpy as np

    direct = u - np.sin(u)
    small = np.abs(u) < _SERIES_BELOW
    if small.any():
        direct[small] = _series(u[small])
    return direct


def _wave(order: int, u: "Any") -> "Any":
    """The derivative of that order of u − sin u."""
    if order == 0:
        return u_minus_sine(u)
    if type(u) is float:
        sine, cosine = math.sin, math.cos
    else:
        import numpy as np

        sine, cosine = np.sin, np.cos
    if order == 1:
        half = sine(0.5 * u)
        return 2.0 * half * half
    quarter = (order - 2) % 4
    value = cosine(u) if quarter % 2 else sine(u)
    return -value if quarter > 1 else value


def _horner(coefficients: "Sequence[float]", t: "Any") -> "Any":
    total = 0.0 * t + coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        total = total * t + coefficient
    return total


class Mixed:
    """Polynomial and waves: Σ cᵢ τⁱ + Σ A W_m(w τ), τ = ±(t − origin), W₀ = u − sin u and W_m its derivatives."""

    __slots__ = ("_polynomials", "backwards", "origin", "waves")

    def __init__(
        self,
        coefficients: "Sequence[float]" = (),
        waves: "Sequence[tuple[float, float, int]]" = (),
        *,
        origin: float = 0.0,
        backwards: bool = False,
    ) -> None:
        self.origin = origin
        self.backwards = backwards
        self.waves = tuple(waves)
        rows = [tuple(coefficients)]
        for _ in range(4):
            rows.append(tuple(i * c for i, c in enumerate(rows[-1]))[1:])
        self._polynomials = tuple(rows)

    def __call__(self, t: "Any", derivatives: int) -> "list[Any]":
        """The value and its derivatives with respect to t."""
        tau = self.origin - t if self.backwards else t - self.origin if self.origin else t
        found = []
        for order in range(derivatives + 1):
            row = self._polynomials[order]
            total = _horner(row, tau) if row else None
            for amplitude, w, start in self.waves:
                part = amplitude * w**order * _wave(start + order, w * tau)
                total = part if total is None else total + part
            if total is None:
                total = 0.0 * tau
            found.append(-total if self.backwards and order % 2 else total)
        return found


class Beta:
    """The polynomial whose velocity is C pⁿ, p = t(1 − t): 3-4-5 for n = 2, 4-5-6-7 for n = 3."""

    __slots__ = ("constant", "n", "row")

    def __init__(self, n: int) -> None:
        self.n = n
        self.constant = float(math.factorial(2 * n + 1) // math.factorial(n) ** 2)
        self.row = tuple(self.constant * (-1) ** k * math.comb(n, k) / (n + 1 + k) for k in range(n + 1))

    def __call__(self, t: "Any", derivatives: int) -> "list[Any]":
        """The value and its derivatives with respect to t."""
        n, c = self.n, self.constant
        p = t * (1.0 - t)
        power = _power(p, n - 1)
        found = [_horner(self.row, t) * _power(t, n + 1)]
        if derivatives >= 1:
            found.append(c * power * p)
        if derivatives >= 2:
            slope = 1.0 - 2.0 * t
            found.append(c * n * power * slope)
        if derivatives >= 3:
            less = _power(p, n - 2) if n > 1 else None
            found.append(0.0 * t - 2.0 * c if less is None else c * n * less * ((n - 1) - (4 * n - 2) * p))
        if derivatives >= 4:
            found.append(self._fourth(p) * slope)
        return found

    def _fourth(self, p: "Any") -> "Any":
        n, c = self.n, self.constant
        if n == 1:
            return 0.0 * p
        bent = (n - 1) * (n - 2) * _power(p, n - 3) if n > 2 else 0.0
        return c * n * (bent - (4 * n - 2) * (n - 1) * _power(p, n - 2))


def _power(x: "Any", n: int) -> "Any":
    """The product of n factors; x**n would differ between floats and arrays."""
    total = 0.0 * x + 1.0
    for _ in range(n):
        total = total * x
    return total


class FourthPowerOfSine:
    """sin⁴(πt/2), the start of the double harmonic."""

    __slots__ = ()

    def __call__(self, t: "Any", derivatives: int) -> "list[Any]":
        """The value and its derivatives with respect to t."""
        u = math.pi * t
        versed = 0.5 * _wave(1, u)
        found = [versed * versed]
        sine = _wave(2, u)
        if derivatives >= 1:
            found.append(math.pi * sine * versed)
        if derivatives >= 2:
            found.append(math.pi**2 * _wave(2, 1.5 * u) * _wave(2, 0.5 * u))
        if derivatives >= 3:
            found.append(0.5 * math.pi**3 * sine * (4.0 * _wave(3, u) - 1.0))
        if derivatives >= 4:
            found.append(0.5 * math.pi**4 * (4.0 * _wave(3, 2.0 * u) - _wave(3, u)))
        return found


class EndOfDoubleHarmonic:
    """1 − sin⁴(π(1 − t)/2), the end of the double harmonic, where its acceleration jumps."""

    __slots__ = ()

    def __call__(self, t: "Any", derivatives: int) -> "list[Any]":
        """The value and its derivatives with respect to t."""
        u = math.pi * t
        left = 0.5 * _wave(1, u)
        sine = _wave(2, u)
        cosine = _wave(3, u)
        found = [left * (2.0 - left)]
        if derivatives >= 1:
            found.append(math.pi * sine * (1.0 - left))
        if derivatives >= 2:
            found.append(0.5 * math.pi**2 * (cosine + _wave(3, 2.0 * u)))
        if derivatives >= 3:
            found.append(-0.5 * math.pi**3 * sine * (1.0 + 4.0 * cosine))
        if derivatives >= 4:
            found.append(-0.5 * math.pi**4 * (cosine + 4.0 * _wave(3, 2.0 * u)))
        return found
