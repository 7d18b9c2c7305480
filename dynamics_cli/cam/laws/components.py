"""The pieces of rise laws: each gives a function that is zero at its end of the rise, with its derivatives.

A shape is called with a distance t ≥ 0 from the end of the rise it belongs to (x at the start, 1 − x at the end), so
that it keeps its digits where the rise begins and ends. t is a float or an array, or carries its error (`Tracked`, or a
`Disc` over an array): then the values carry theirs, with the rounding of the shape's constants. `quickest` is the
frequency of a shape's fastest wave.
"""

import math

from dynamics_cli.numerics.elementary import cos, sin
from dynamics_cli.numerics.number import is_array, is_tracked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# (−1)^n 6/(2n + 3)!: coefficients of (u − sin u)/(u³/6) in powers of u²; the last first.
_SERIES = tuple((-1.0) ** n * 6.0 / math.factorial(2 * n + 3) for n in range(8, -1, -1))
_SERIES_BELOW = 1.0


U = 2.0**-53
# Roundings of a coefficient of a polynomial, and how far constants change with the sum of the shares.
CONSTANT, OFF = 3.0, 8.0


def carrying(number: float, error: float, beside: "Any") -> "Any":
    """A constant with its error, as the kind of number beside it; floats and arrays take it as it is."""
    if type(beside) is float or is_array(beside):
        return number
    return type(beside)(number, error, ()) if is_tracked(beside) else type(beside)(number, error)


def _pi(power: int, beside: "Any") -> "Any":
    """A power of π."""
    return carrying(math.pi**power, 4.0 * U * math.pi**power, beside)


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
    if type(u) is float or is_tracked(u):
        return _series(u) if -_SERIES_BELOW < u < _SERIES_BELOW else u - (sin(u) if sine is None else sine)
    if not is_array(u):
        # a disc: the slope is 1 − cos u; the series is within 8 roundings, the difference those of a sine
        centre = u_minus_sine(u.centre)
        rounding = (abs(u.centre) < _SERIES_BELOW) * (8.0 * U * abs(centre))
        rounding = rounding + (abs(u.centre) >= _SERIES_BELOW) * (U * abs(centre) + 8.0 * U)
        return type(u)(centre, u.radius * (1.0 - u.cosine()).size + rounding)
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
    if type(u) is float or is_tracked(u):
        half, other = sin(0.5 * u), cos(0.5 * u)
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

    __slots__ = ("_polynomials", "backwards", "near", "off", "origin", "quickest", "waves")

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
        self.quickest = max((w for _, w, _ in waves), default=0.0)
        rows = [tuple(coefficients)]
        for _ in range(4):
            rows.append(tuple(i * c for i, c in enumerate(rows[-1]))[1:])
        self._polynomials = tuple(rows)

    def __call__(self, t: "Any", derivatives: int) -> "list[Any]":
        """The value and its derivatives with respect to t."""
        rows, waves, origin = self._polynomials[: derivatives + 1], self.waves, self.origin
        if not (type(t) is float or is_array(t)):
            rows, waves, origin, t = self._bounded(rows, t)
        tau = origin - t if self.backwards else t - origin if self.origin else t
        derivatives_at = [_horner(row, tau) if row else None for row in rows]
        for amplitude, w, start in waves:
            factor = amplitude
            for order, wave in enumerate(_waves(w * tau, start, start + derivatives)):
                part = factor * wave
                derivatives_at[order] = part if derivatives_at[order] is None else derivatives_at[order] + part
                factor = factor * w
        if self.backwards:
            derivatives_at[1::2] = [None if value is None else -value for value in derivatives_at[1::2]]
        return [0.0 * tau if value is None else value for value in derivatives_at]

    def _bounded(self, rows: "Sequence[Any]", t: "Any") -> "tuple[Any, ...]":
        """Coefficients, waves, origin and place with their errors."""
        off, (wide, fast) = OFF * self.off, self.near
        coefficients = [
            [carrying(c, ((CONSTANT + order) * U + off) * abs(c), t) for c in row] for order, row in enumerate(rows)
        ]
        waves = [
            (carrying(a, (wide * U + off) * abs(a), t), carrying(w, (fast * U + off) * abs(w), t), start)
            for a, w, start in self.waves
        ]
        return coefficients, waves, carrying(self.origin, U * abs(self.origin), t), t + carrying(0.0, self.off, t)


class Beta:
    """The polynomial whose velocity is C pⁿ, p = t(1 − t): 3-4-5 for n = 2, 4-5-6-7 for n = 3."""

    __slots__ = ("constant", "n", "row")
    quickest = 0.0

    def __init__(self, n: int) -> None:
        self.n = n
        self.constant = float(math.factorial(2 * n + 1) // math.factorial(n) ** 2)
        self.row = tuple(self.constant * (-1) ** k * math.comb(n, k) / (n + 1 + k) for k in range(n + 1))

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
    quickest = 2.0 * math.pi

    def __call__(self, t: "Any", derivatives: int) -> "list[Any]":
        """The value and its derivatives with respect to t."""
        u = _pi(1, t) * t
        versed = 0.5 * _wave(1, u)
        orders = [versed * versed]
        sine = _wave(2, u)
        if derivatives >= 1:
            orders.append(_pi(1, t) * sine * versed)
        if derivatives >= 2:
            orders.append(_pi(2, t) * _wave(2, 1.5 * u) * _wave(2, 0.5 * u))
        if derivatives >= 3:
            orders.append(0.5 * _pi(3, t) * sine * (4.0 * _wave(3, u) - 1.0))
        if derivatives >= 4:
            orders.append(0.5 * _pi(4, t) * (4.0 * _wave(3, 2.0 * u) - _wave(3, u)))
        return orders


class EndOfDoubleHarmonic:
    """1 − sin⁴(π(1 − t)/2), the end of the double harmonic, where its acceleration jumps."""

    __slots__ = ()
    quickest = 2.0 * math.pi

    def __call__(self, t: "Any", derivatives: int) -> "list[Any]":
        """The value and its derivatives with respect to t."""
        u = _pi(1, t) * t
        half_versed = 0.5 * _wave(1, u)
        sine = _wave(2, u)
        cosine = _wave(3, u)
        orders = [half_versed * (2.0 - half_versed)]
        if derivatives >= 1:
            orders.append(_pi(1, t) * sine * (1.0 - half_versed))
        if derivatives >= 2:
            orders.append(0.5 * _pi(2, t) * (cosine + _wave(3, 2.0 * u)))
        if derivatives >= 3:
            orders.append(-0.5 * _pi(3, t) * sine * (1.0 + 4.0 * cosine))
        if derivatives >= 4:
            orders.append(-0.5 * _pi(4, t) * (cosine + 4.0 * _wave(3, 2.0 * u)))
        return orders
