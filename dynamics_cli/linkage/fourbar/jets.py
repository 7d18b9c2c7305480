"""Values with their first two derivatives, over arrays or over discs that enclose them."""

import numpy as np

from dynamics_cli.numerics.discs import Disc

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Jet:
    """A function of one parameter: its value, slope and second derivative."""

    __slots__ = ("first", "second", "value")

    def __init__(self, value: "Any", first: "Any" = 0.0, second: "Any" = 0.0) -> None:
        self.value = value
        self.first = first
        self.second = second

    def __add__(self, other: "Any") -> "Jet":
        o = _jet(other)
        return Jet(self.value + o.value, self.first + o.first, self.second + o.second)

    __radd__ = __add__

    def __neg__(self) -> "Jet":
        return Jet(-self.value, -self.first, -self.second)

    def __sub__(self, other: "Any") -> "Jet":
        return self + (-_jet(other))

    def __rsub__(self, other: "Any") -> "Jet":
        return _jet(other) + (-self)

    def __mul__(self, other: "Any") -> "Jet":
        if not isinstance(other, Jet):
            return Jet(self.value * other, self.first * other, self.second * other)
        return Jet(
            self.value * other.value,
            self.value * other.first + self.first * other.value,
            self.value * other.second + 2.0 * (self.first * other.first) + self.second * other.value,
        )

    __rmul__ = __mul__

    def inverse(self) -> "Jet":
        """One over it."""
        over = 1.0 / self.value
        slope = -(self.first * over) * over
        return Jet(over, slope, -2.0 * (slope * self.first * over) - self.second * over * over)

    def root(self) -> "Jet":
        """Its square root, where it is positive."""
        value = self.value.root() if isinstance(self.value, Disc) else np.sqrt(self.value)
        half = 0.5 * (1.0 / value)
        slope = self.first * half
        return Jet(value, slope, (self.second - 2.0 * (slope * slope)) * half)


def _jet(x: "Any") -> Jet:
    return x if isinstance(x, Jet) else Jet(x)


def wave(u: "Any") -> "tuple[Jet, Jet]":
    """Cosine and sine of the parameter."""
    cosine, sine = (u.cosine(), u.sine()) if isinstance(u, Disc) else (np.cos(u), np.sin(u))
    return Jet(cosine, -sine, -cosine), Jet(sine, cosine, -sine)
