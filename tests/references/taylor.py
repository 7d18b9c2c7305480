"""Taylor coefficients carried through arithmetic: derivatives without differences, of functions of one variable.

A `Taylor` is Σ cₖ εᵏ about a place; its coefficients are numbers of any field (see digits.py), or arrays of doubles:
many places at once. `Plane` is a complex number of two such parts. Derivatives may be taken of functions that take
derivatives of the same variable themselves.
"""

from collections.abc import Callable
from math import factorial
from typing import Any

from mpmath import taylor


class Taylor:
    """A truncated power series."""

    __slots__ = ("c",)
    # arrays leave the arithmetic with a series to the series
    __array_ufunc__ = None

    def __init__(self, c: list[Any]) -> None:
        self.c = c

    def __add__(self, other: Any) -> "Taylor":
        if type(other) is Taylor:
            return Taylor([a + b for a, b in zip(self.c, other.c, strict=True)])
        return Taylor([self.c[0] + other, *self.c[1:]])

    __radd__ = __add__

    def __neg__(self) -> "Taylor":
        return Taylor([-a for a in self.c])

    def __sub__(self, other: Any) -> "Taylor":
        return self + -other

    def __rsub__(self, other: Any) -> "Taylor":
        return -self + other

    def __mul__(self, other: Any) -> "Taylor":
        if type(other) is not Taylor:
            return Taylor([a * other for a in self.c])
        a, b = self.c, other.c
        return Taylor([sum(a[i] * b[k - i] for i in range(1, k + 1)) + a[0] * b[k] for k in range(len(a))])

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> "Taylor":
        if type(other) is not Taylor:
            return Taylor([a / other for a in self.c])
        b, out = other.c, []
        for k, a in enumerate(self.c):
            out.append((a - sum(out[i] * b[k - i] for i in range(k))) / b[0])
        return Taylor(out)

    def __rtruediv__(self, other: Any) -> "Taylor":
        return Taylor([0 * a + (other if k == 0 else 0) for k, a in enumerate(self.c)]) / self

    def __pow__(self, power: int) -> "Taylor":
        made = self
        for _ in range(power - 1):
            made = made * self
        return made


def sqrt(field: Any, x: Any) -> Any:
    """The square root."""
    if type(x) is not Taylor:
        return field.sqrt(x)
    out = [field.sqrt(x.c[0])]
    for k in range(1, len(x.c)):
        out.append((x.c[k] - sum(out[i] * out[k - i] for i in range(1, k))) / (2 * out[0]))
    return Taylor(out)


def circle(field: Any, x: Any) -> tuple[Any, Any]:
    """Cosine and sine, each by the other's derivative."""
    if type(x) is not Taylor:
        return field.cos(x), field.sin(x)
    c, s = [field.cos(x.c[0])], [field.sin(x.c[0])]
    for k in range(1, len(x.c)):
        slopes = [i * x.c[i] for i in range(1, k + 1)]
        c.append(-sum(slope * s[k - 1 - i] for i, slope in enumerate(slopes)) / k)
        s.append(sum(slope * c[k - 1 - i] for i, slope in enumerate(slopes)) / k)
    return Taylor(c), Taylor(s)


class Plane:
    """A complex number: a point or a direction of the plane."""

    __slots__ = ("imag", "real")

    def __init__(self, real: Any, imag: Any) -> None:
        self.real = real
        self.imag = imag

    def __add__(self, other: "Plane") -> "Plane":
        return Plane(self.real + other.real, self.imag + other.imag)

    def __sub__(self, other: "Plane") -> "Plane":
        return Plane(self.real - other.real, self.imag - other.imag)

    def __mul__(self, other: Any) -> "Plane":
        if type(other) is not Plane:
            return Plane(self.real * other, self.imag * other)
        a, b, c, d = self.real, self.imag, other.real, other.imag
        return Plane(a * c - b * d, a * d + b * c)

    def conjugate(self) -> "Plane":
        """Mirrored."""
        return Plane(self.real, -self.imag)

    def square(self) -> Any:
        """|z|²."""
        return self.real * self.real + self.imag * self.imag


def expanded(function: Callable[[Any], Any], t: Any, order: int) -> list[Any]:
    """f(t), f′(t), … to an order: numbers where t is one, series where t is a variable's."""
    beyond = len(t.c) - 1 if type(t) is Taylor else 0
    at = t.c[0] if type(t) is Taylor else t
    if beyond and t.c[1:] != [1] + [0] * (beyond - 1):
        raise TypeError("a derivative by something that is not the variable itself")
    made = function(variable(at, order + beyond) if order + beyond else at)
    if type(made) is Plane:
        parts = zip(_derived(made.real, order, beyond), _derived(made.imag, order, beyond), strict=True)
        return [Plane(*pair) for pair in parts]
    return _derived(made, order, beyond)


def variable(at: Any, order: int) -> Taylor:
    """at + ε."""
    return Taylor([at, *(1 if k == 1 else 0 for k in range(1, order + 1))])


def _derived(made: Any, order: int, beyond: int) -> list[Any]:
    c = made.c if type(made) is Taylor else [made, *[0] * (order + beyond)]
    out = []
    for n in range(order + 1):
        shares = [c[k + n] * (factorial(k + n) // factorial(k)) for k in range(beyond + 1)]
        out.append(Taylor(shares) if beyond else shares[0])
    return out


def diff(function: Callable[[Any], Any], t: Any, order: int = 1) -> Any:
    """The derivative of an order."""
    return expanded(function, t, order)[order]


def of_numbers(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """A function of mpmath's numbers alone, as one that takes series too: its derivatives by differences."""

    def made(t: Any) -> Any:
        return Taylor(list(taylor(function, t.c[0], len(t.c) - 1))) if type(t) is Taylor else function(t)

    return made
