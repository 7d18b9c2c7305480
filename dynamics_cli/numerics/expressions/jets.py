"""Taylor coefficients that pass through a formula like numbers, so that its derivatives come out exactly.

A `Jet` holds f, f′, f″/2, f‴/6 … at one point. Its coefficients are doubles, arrays, tracked numbers, numbers of many
digits, or jets in another variable, for mixed derivatives. Functions follow the recurrences of their differential
equations (Moore, Methods and Applications of Interval Analysis, SIAM 1979, section 3.4).
"""

from dynamics_cli.numerics import elementary
from dynamics_cli.numerics.number import plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any


class Jet:
    """The Taylor coefficients of a function at a point, from its value up.

    References
    ----------
    R. E. Moore, Methods and Applications of Interval Analysis, SIAM 1979, section 3.4.
    """

    __slots__ = ("parts",)
    # makes arrays leave the operation to the jet
    __array_ufunc__ = None

    def __init__(self, parts: "Sequence[Any]") -> None:
        self.parts = list(parts)

    @classmethod
    def variable(cls, at: "Any", order: int) -> "Jet":
        """The variable itself at a point, with coefficients up to the order."""
        return cls([at, 1.0, *[0.0] * (order - 1)][: order + 1])

    def apply(self, name: str, *_: "Any") -> "Any":
        """A function of a jet that is the coefficient of another one."""
        return elementary.pi_beside(self.parts[0]) if name == "pi" else FUNCTIONS[name](self)

    def derivative(self, order: int) -> "Any":
        """The derivative of that order."""
        factor = 1.0
        for number in range(2, order + 1):
            factor *= number
        return self.parts[order] * factor

    def integral(self, slope: "Jet", value: "Any") -> "Jet":
        """The function that has this value and whose derivative by this jet is the slope."""
        return _by_slope(value, self, slope)

    def _with(self, other: "Any") -> "list[Any]":
        return other.parts if isinstance(other, Jet) else [other, *[0.0] * (len(self.parts) - 1)]

    def __add__(self, other: "Any") -> "Jet":
        if not isinstance(other, Jet):
            return Jet([self.parts[0] + other, *self.parts[1:]])
        return Jet([a + b for a, b in zip(self.parts, other.parts, strict=True)])

    __radd__ = __add__

    def __neg__(self) -> "Jet":
        return Jet([-a for a in self.parts])

    def __sub__(self, other: "Any") -> "Jet":
        if not isinstance(other, Jet):
            return Jet([self.parts[0] - other, *self.parts[1:]])
        return Jet([a - b for a, b in zip(self.parts, other.parts, strict=True)])

    def __rsub__(self, other: "Any") -> "Jet":
        return (-self).__add__(other)

    def __mul__(self, other: "Any") -> "Jet":
        if not isinstance(other, Jet):
            return Jet([a * other for a in self.parts])
        return Jet([_folded(self.parts, other.parts, k) for k in range(len(self.parts))])

    __rmul__ = __mul__

    def __truediv__(self, other: "Any") -> "Jet":
        if not isinstance(other, Jet):
            return Jet([a / other for a in self.parts])
        out: list[Any] = []
        for k, part in enumerate(self.parts):
            rest = part
            for j in range(k):
                if not _nothing(other.parts[k - j]):
                    rest = rest - out[j] * other.parts[k - j]
            out.append(rest / other.parts[0])
        return Jet(out)

    def __rtruediv__(self, other: "Any") -> "Jet":
        return Jet(self._with(other)) / self


def _nothing(x: "Any") -> bool:
    return type(x) is float and x == 0.0


def _folded(a: "Sequence[Any]", b: "Sequence[Any]", k: int) -> "Any":
    """The coefficient k of a product."""
    terms = [a[j] * b[k - j] for j in range(k + 1) if not (_nothing(a[j]) or _nothing(b[k - j]))]
    return _sum(terms)


def _sum(terms: "Sequence[Any]") -> "Any":
    total: Any = 0.0
    for index, term in enumerate(terms):
        total = total + term if index else term
    return total


def _chained(inner: "Sequence[Any]", slope: "Sequence[Any]", k: int) -> "Any":
    """The coefficient k of a function whose derivative by its argument has the coefficients `slope`."""
    terms = [(inner[j] * slope[k - j]) * float(j) for j in range(1, k + 1) if not _nothing(inner[j])]
    return _sum(terms) / float(k)


def sqrt(u: Jet) -> Jet:
    """Square root; at zero it has no derivative."""
    if not isinstance(u, Jet):
        return elementary.sqrt(u)
    out: list[Any] = [elementary.sqrt(u.parts[0])]
    for k in range(1, len(u.parts)):
        rest = u.parts[k]
        for j in range(1, k):
            rest = rest - out[j] * out[k - j]
        out.append(rest / (out[0] * 2.0))
    return Jet(out)


def exp(u: Jet) -> Jet:
    """Exponential."""
    out: list[Any] = [elementary.exp(u.parts[0])]
    for k in range(1, len(u.parts)):
        out.append(_chained(u.parts, out, k))
    return Jet(out)


def log(u: Jet) -> Jet:
    """Natural logarithm."""
    return _by_slope(elementary.log(u.parts[0]), u, 1.0 / u)


def _by_slope(value: "Any", u: Jet, slope: Jet) -> Jet:
    return Jet([value, *[_chained(u.parts, slope.parts, k) for k in range(1, len(u.parts))]])


def _pair(u: Jet, first: "Any", second: "Any", sign: float) -> "tuple[Jet, Jet]":
    """Two functions, each the derivative of the other but for a sign: sine and cosine, with h or without."""
    first_series, second_series = [first], [second]
    for k in range(1, len(u.parts)):
        up, down = _chained(u.parts, second_series, k), _chained(u.parts, first_series, k)
        first_series.append(up)
        second_series.append(down * sign)
    return Jet(first_series), Jet(second_series)


def sin(u: Jet) -> Jet:
    """Sine."""
    return _pair(u, elementary.sin(u.parts[0]), elementary.cos(u.parts[0]), -1.0)[0]


def cos(u: Jet) -> Jet:
    """Cosine."""
    return _pair(u, elementary.sin(u.parts[0]), elementary.cos(u.parts[0]), -1.0)[1]


def sinh(u: Jet) -> Jet:
    """Hyperbolic sine."""
    return _pair(u, elementary.sinh(u.parts[0]), elementary.cosh(u.parts[0]), 1.0)[0]


def cosh(u: Jet) -> Jet:
    """Hyperbolic cosine."""
    return _pair(u, elementary.sinh(u.parts[0]), elementary.cosh(u.parts[0]), 1.0)[1]


def _riccati(u: Jet, value: "Any", sign: float) -> Jet:
    """A function whose slope is 1 ± its square: tangents."""
    out = [value]
    slope = [value * value * sign + 1.0]
    for k in range(1, len(u.parts)):
        out.append(_chained(u.parts, slope, k))
        slope.append(_folded(out, out, k) * sign)
    return Jet(out)


def tan(u: Jet) -> Jet:
    """Tangent."""
    return _riccati(u, elementary.tan(u.parts[0]), 1.0)


def tanh(u: Jet) -> Jet:
    """Hyperbolic tangent."""
    return _riccati(u, elementary.tanh(u.parts[0]), -1.0)


def asin(u: Jet) -> Jet:
    """Arc sine; at ±1 it has no derivative."""
    return _by_slope(elementary.asin(u.parts[0]), u, 1.0 / sqrt((1.0 - u) * (1.0 + u)))


def acos(u: Jet) -> Jet:
    """Arc cosine; at ±1 it has no derivative."""
    return _by_slope(elementary.acos(u.parts[0]), u, -1.0 / sqrt((1.0 - u) * (1.0 + u)))


def atan(u: Jet) -> Jet:
    """Arc tangent."""
    return _by_slope(elementary.atan(u.parts[0]), u, 1.0 / (u * u + 1.0))


def magnitude(u: Jet) -> Jet:
    """Absolute value; at zero it has no derivative."""
    first = u.parts[0]
    while isinstance(first, Jet):
        first = first.parts[0]
    first = plain(first)
    if getattr(first, "ndim", 0):
        import numpy as np

        return u.__mul__(np.sign(first))
    if first == 0.0:
        raise ZeroDivisionError("|x| at x = 0")
    return u if first > 0.0 else -u


def power(u: Jet, exponent: "Any") -> Jet:
    """A power: whole exponents by products, others of positive numbers by their differential equation."""
    if isinstance(exponent, Jet):
        return exp(exponent * log(u)) if isinstance(u, Jet) else exp(exponent * elementary.log(u))
    exponent_value = plain(exponent)
    if type(exponent_value) is float and exponent_value == int(exponent_value) and abs(exponent_value) <= 64.0:
        return whole_power(u, int(exponent_value))  # type: ignore[no-any-return]
    return exp(log(u) * exponent)


def whole_power(u: "Any", count: int) -> "Any":
    """A power with a whole exponent, of numbers of any type, by squaring."""
    if count < 0:
        return 1.0 / whole_power(u, -count)
    if count == 0:
        return u * 0.0 + 1.0
    square, out = u, None
    while count:
        if count & 1:
            out = square if out is None else out * square
        count >>= 1
        if count:
            square = square * square
    return out


FUNCTIONS: "dict[str, Callable[[Jet], Jet]]" = {
    "sin": sin, "cos": cos, "tan": tan, "asin": asin, "acos": acos, "atan": atan, "sinh": sinh, "cosh": cosh,
    "tanh": tanh, "exp": exp, "log": log, "sqrt": sqrt, "abs": magnitude,
}  # fmt: skip
