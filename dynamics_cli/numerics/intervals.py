"""Interval arithmetic on arrays, enough to enclose rational functions, roots, sines and cosines on many cells at once.

Ends are rounded to nearest: users add a margin for rounding, which is far below what the cells themselves cost.
"""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Interval:
    """Arrays of closed intervals [low, high]."""

    __slots__ = ("high", "low")
    __array_priority__ = 100.0

    def __init__(self, low: "Any", high: "Any") -> None:
        self.low = low
        self.high = high

    @classmethod
    def about(cls, middle: "Any", radius: "Any") -> "Interval":
        """The interval of that middle and radius."""
        return cls(middle - radius, middle + radius)

    @property
    def size(self) -> "Any":
        """The largest magnitude."""
        return np.maximum(np.abs(self.low), np.abs(self.high))

    def __neg__(self) -> "Interval":
        return Interval(-self.high, -self.low)

    def __add__(self, other: "Any") -> "Interval":
        if isinstance(other, Interval):
            return Interval(self.low + other.low, self.high + other.high)
        return Interval(self.low + other, self.high + other)

    __radd__ = __add__

    def __sub__(self, other: "Any") -> "Interval":
        opposite: Any = -other
        return self.__add__(opposite)

    def __rsub__(self, other: "Any") -> "Interval":
        return self.__neg__().__add__(other)

    def __mul__(self, other: "Any") -> "Interval":
        if isinstance(other, Interval):
            ends = (self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high)
            return Interval(np.minimum.reduce(ends), np.maximum.reduce(ends))
        a, b = self.low * other, self.high * other
        return Interval(np.minimum(a, b), np.maximum(a, b))

    __rmul__ = __mul__

    def square(self) -> "Interval":
        """The interval of squares."""
        low = np.where((self.low <= 0.0) & (self.high >= 0.0), 0.0, np.minimum(np.abs(self.low), np.abs(self.high)))
        return Interval(low * low, self.size * self.size)

    def inverse(self) -> "Interval":
        """The interval of reciprocals; infinite where it contains zero."""
        within = (self.low <= 0.0) & (self.high >= 0.0)
        with np.errstate(divide="ignore"):
            a, b = 1.0 / self.low, 1.0 / self.high
        return Interval(np.where(within, -np.inf, b), np.where(within, np.inf, a))

    def root(self) -> "Interval":
        """The interval of square roots of what is not negative."""
        return Interval(np.sqrt(np.maximum(self.low, 0.0)), np.sqrt(np.maximum(self.high, 0.0)))

    def sine(self) -> "Interval":
        """Enclosure of the sines, by the mean value."""
        middle, radius = 0.5 * (self.low + self.high), 0.5 * (self.high - self.low)
        return Interval.about(np.sin(middle), radius)

    def cosine(self) -> "Interval":
        """Enclosure of the cosines, by the mean value."""
        middle, radius = 0.5 * (self.low + self.high), 0.5 * (self.high - self.low)
        return Interval.about(np.cos(middle), radius)
