"""The pieces of rise laws: each gives a function that is zero at its end of the rise, with its derivatives.

A shape is called with a distance t ≥ 0 from the end of the rise it belongs to (x at the start, 1 − x at the end), so
that it keeps its digits where the rise begins and ends; t is a float or an array. However a shape is computed, `parts`
describes it as a polynomial and waves, `(coefficients, waves, origin, backwards)` as `Mixed` takes them.
"""

import math

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# (−1)^n 6/(2n + 3)!: coefficients of (u − sin u)/(u³/6) in powers of u²; the last first.
_SERIES = tuple((-1.0) ** n * 6.0 / math.factorial(2 * n + 3) for n in range(8, -1, -1))
_SERIES_BELOW = 1.0


def _series(u: "Any") -> "Any":
    square = u * u
    total = square * _SERIES[0]
    # in place on arrays, the same on floats
    for c in _SERIES[1:-1]:
        total += c
        total *= square
    total += _SERIES[-1]
    return u * square / 6.0 * total


def u_minus_sine(u: "Any", sine: "Any" = None) -> "Any":
    """U − sin u to a few roundings even where u ≥ 0 is small; `sine` is sin u if known."""
    if type(u) is float:
        return _series(u) if -_SERIES_BELOW < u < _SERIES_BELOW else u - (math.sin(u) if sine is None else sine)
    import numpy as np

    small = u < _SERIES_BELOW
    count = int(np.count_nonzero(small))
    if count == u.size:
        return _series(u)
    direct = u - (np.sin(u) if sine is None else sine)
    if count:
        # ordered angles have the small ones at one end, and a slice is cheaper than a mask
        part: Any = small
        if u.ndim == 1 and small[0] and small[:count].all():
            part = slice(count)
        elif u.ndim == 1 and small[-1] and small[-count:].all():
            part = slice(u.size - count, None)
        direct[part] = _series(u[part])
    return direct


def _waves(u: "Any", first: int, last: int) -> "list[Any]":
    """The derivatives of u − sin u from one order to another, from one sine and one cosine of the half angle."""
    if type(u) is float:
        half, other = math.sin(0.5 * u), math.cos(0.5 * u)
    else:
        import numpy as np

        middle = 0.5 * u
        half, other = np.sin(middle), np.cos(middle)
    versed = 2.0 * half * half
    sine = 2.0 * half * other
    waves = []
    for order in range(first, last + 1):
        if order == 0:
            waves.append(u_minus_sine(u, sine))
        elif order == 1:
            waves.append(versed)
        else:
            value = 1.0 - versed if order % 2 else sine
            waves.append(-value if (order - 2) % 4 > 1 else value)
    return waves


def _wave(order: int, u: "Any") -> "Any":
    """The derivative of that order of u − sin u."""
    return _waves(u, order, order)[0]


def _horner(coefficients: "Sequence[float]", t: "Any") -> "Any":
    if len(coefficients) == 1:
        return 0.0 * t + coefficients[0]
    total = coefficients[-1] * t + coefficients[-2]
    for coefficient in coefficients[-3::-1]:
        total = total * t + coefficient
    return total


class Mixed:
    """Polynomial and waves: Σ cᵢ τⁱ + Σ A W_m(w τ), τ = ±(t − origin), W₀ = u − sin u and W_m its derivatives."""

    __slots__ = ("_polynomials", "backwards", "near", "off", "origin", "waves")

    def __init__(
        self,
        coefficients: "Sequence[float]" = (),
        waves: "Sequence[tuple[float, float, int]]" = (),
        *,
        origin: float = 0.0,
        backwards: bool = False,
        off: float = 0.0,
        near: "tuple[float, float]" = (3.4, 1.4),
    ) -> None:
        # within how many half units in the last place amplitudes and frequencies of the waves are
        self.near = near
        # errors of constants (relative) and of places (in t) besides rounding
        self.off = off
        self.origin = origin
        self.backwards = backwards
        self.waves = tuple(waves)
        rows = [tuple(coefficients)]
        for _ in range(4):
            rows.append(tuple(i * c for i, c in enumerate(rows[-1]))[1:])
        self._polynomials = tuple(rows)

    @property
    def parts(self) -> "tuple[Any, ...]":
        """Coefficients, waves, origin and direction."""
        return self._polynomials[0], self.waves, self.origin, self.backwards

    def __call__(self, t: "Any", derivatives: int) -> "list[Any]":
        """The value and its derivatives with respect to t."""
        tau = self.origin - t if self.backwards else t - self.origin if self.origin else t
        derivatives_at = [_horner(row, tau) if row else None for row in self._polynomials[: derivatives + 1]]
        for amplitude, w, start in self.waves:
            factor = amplitude
            for order, wave in enumerate(_waves(w * tau, start, start + derivatives)):
                part = factor * wave
                derivatives_at[order] = part if derivatives_at[order] is None else derivatives_at[order] + part
                factor = factor * w
        if self.backwards:
            derivatives_at[1::2] = [None if value is None else -value for value in derivatives_at[1::2]]
        return [0.0 * tau if value is None else value for value in derivatives_at]


class Beta:
    """The polynomial whose velocity is C pⁿ, p = t(1 − t): 3-4-5 for n = 2, 4-5-6-7 for n = 3."""

    __slots__ = ("constant", "n", "row")

    def __init__(self, n: int) -> None:
        self.n = n
        self.constant = float(math.factorial(2 * n + 1) // math.factorial(n) ** 2)
        self.row = tuple(self.constant * (-1) ** k * math.comb(n, k) / (n + 1 + k) for k in range(n + 1))

    @property
    def parts(self) -> "tuple[Any, ...]":
        """The coefficients, all whole numbers."""
        return (0.0,) * (self.n + 1) + self.row, (), 0.0, False

    def __call__(self, t: "Any", derivatives: int) -> "list[Any]":
        """The value and its derivatives with respect to t."""
        n, c = self.n, self.constant
        p = t * (1.0 - t)
        power = _power(p, n - 1)
        orders = [_horner(self.row, t) * _power(t, n + 1)]
        if derivatives >= 1:
            orders.append(c * power * p)
        if derivatives >= 2:
            slope = 1.0 - 2.0 * t
            orders.append(c * n * power * slope)
        if derivatives >= 3:
            less = _power(p, n - 2) if n > 1 else None
            orders.append(0.0 * t - 2.0 * c if less is None else c * n * less * ((n - 1) - (4 * n - 2) * p))
        if derivatives >= 4:
            orders.append(self._fourth(p) * slope)
        return orders

    def size(self, order: int) -> float:
        """Bound of the sum of magnitudes of a derivative's terms (first to fourth) for 0 ≤ t ≤ 1, p ≤ ¼."""
        n, c = self.n, self.constant
        if order < 3:
            return (c * 0.25**n, c * n * 0.25 ** (n - 1))[order - 1]
        if order == 3:
            return c * n * 0.25 ** max(n - 2, 0) * ((n - 1) + (4 * n - 2) * 0.25) if n > 1 else 2.0 * c
        bent = (n - 1) * (n - 2) * 0.25 ** max(n - 3, 0)
        return c * n * (bent + (4 * n - 2) * (n - 1) * 0.25 ** max(n - 2, 0))

    def largest(self, order: int) -> float:
        """Bound of that derivative itself for 0 ≤ t ≤ 1: of the third, C n pⁿ⁻²((n − 1) − (4n − 2)p), the extremes."""
        n = self.n
        if order != 3 or n == 1:
            return self.size(order)
        return self.constant * n * max(((n - 2) / (4 * n - 2)) ** (n - 2), 0.5 * 0.25 ** (n - 2))

    def _fourth(self, p: "Any") -> "Any":
        n, c = self.n, self.constant
        if n == 1:
            return 0.0 * p
        bent = (n - 1) * (n - 2) * _power(p, n - 3) if n > 2 else 0.0
        return c * n * (bent - (4 * n - 2) * (n - 1) * _power(p, n - 2))


def _power(x: "Any", n: int) -> "Any":
    """The product of n factors; x**n would differ between floats and arrays."""
    if n == 0:
        return 0.0 * x + 1.0
    total = x
    for _ in range(n - 1):
        total = total * x
    return total


class FourthPowerOfSine:
    """sin⁴(πt/2), the start of the double harmonic."""

    __slots__ = ()
    # sin⁴(u/2) = ½(1 − cos u) − ⅛(1 − cos 2u)
    parts = ((), ((0.5, math.pi, 1), (-0.125, 2.0 * math.pi, 1)), 0.0, False)

    def __call__(self, t: "Any", derivatives: int) -> "list[Any]":
        """The value and its derivatives with respect to t."""
        u = math.pi * t
        versed = 0.5 * _wave(1, u)
        orders = [versed * versed]
        sine = _wave(2, u)
        if derivatives >= 1:
            orders.append(math.pi * sine * versed)
        if derivatives >= 2:
            orders.append(math.pi**2 * _wave(2, 1.5 * u) * _wave(2, 0.5 * u))
        if derivatives >= 3:
            orders.append(0.5 * math.pi**3 * sine * (4.0 * _wave(3, u) - 1.0))
        if derivatives >= 4:
            orders.append(0.5 * math.pi**4 * (4.0 * _wave(3, 2.0 * u) - _wave(3, u)))
        return orders


class EndOfDoubleHarmonic:
    """1 − sin⁴(π(1 − t)/2), the end of the double harmonic, where its acceleration jumps."""

    __slots__ = ()
    # ½(1 − cos u) + ⅛(1 − cos 2u)
    parts = ((), ((0.5, math.pi, 1), (0.125, 2.0 * math.pi, 1)), 0.0, False)

    def __call__(self, t: "Any", derivatives: int) -> "list[Any]":
        """The value and its derivatives with respect to t."""
        u = math.pi * t
        half_versed = 0.5 * _wave(1, u)
        sine = _wave(2, u)
        cosine = _wave(3, u)
        orders = [half_versed * (2.0 - half_versed)]
        if derivatives >= 1:
            orders.append(math.pi * sine * (1.0 - half_versed))
        if derivatives >= 2:
            orders.append(0.5 * math.pi**2 * (cosine + _wave(3, 2.0 * u)))
        if derivatives >= 3:
            orders.append(-0.5 * math.pi**3 * sine * (1.0 + 4.0 * cosine))
        if derivatives >= 4:
            orders.append(-0.5 * math.pi**4 * (cosine + 4.0 * _wave(3, 2.0 * u)))
        return orders
