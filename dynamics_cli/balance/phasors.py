"""Phasors of any number: an amount with its angle, added, turned and divided as complex numbers are."""

from dynamics_cli.numerics.elementary import atan2, hypot, pi_beside
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.turns import turned

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any

# A sum this small beside its addends has no direction.
NOTHING = 1e-13
# An angle that rounding alone puts before the mark stays there: 360 degrees would not be read as 0.
BEFORE = 1e-14


class Phasor:
    """x + i·y of doubles or tracked numbers, which Python's complex numbers do not hold."""

    __slots__ = ("x", "y")

    def __init__(self, x: "Any", y: "Any" = 0.0) -> None:
        self.x = x
        self.y = y

    def __add__(self, other: "Phasor") -> "Phasor":
        return Phasor(self.x + other.x, self.y + other.y)

    def __sub__(self, other: "Phasor") -> "Phasor":
        return Phasor(self.x - other.x, self.y - other.y)

    def __neg__(self) -> "Phasor":
        return Phasor(-self.x + 0.0, -self.y + 0.0)

    def __mul__(self, other: "Phasor") -> "Phasor":
        return Phasor(self.x * other.x - self.y * other.y, self.x * other.y + self.y * other.x)

    def __truediv__(self, other: "Phasor") -> "Phasor":
        # Smith's way is not needed: readings and masses are far from the ends of the range
        square = other.x * other.x + other.y * other.y
        over = self * other.conjugate
        return Phasor(over.x / square, over.y / square)

    def times(self, factor: "Any") -> "Phasor":
        """The phasor, so many times as long."""
        return Phasor(self.x * factor, self.y * factor)

    @property
    def conjugate(self) -> "Phasor":
        """The phasor with its angle counted the other way."""
        return Phasor(self.x, -self.y + 0.0)

    @property
    def size(self) -> "Any":
        """Its amount."""
        return hypot(self.x, self.y)

    @property
    def angle(self) -> "Any":
        """Its angle, from 0 up to a whole turn."""
        angle = atan2(self.y, self.x)
        return angle if plain(angle) >= -BEFORE else angle + 2.0 * pi_beside(angle)

    @property
    def pair(self) -> "tuple[Any, Any]":
        """Its components."""
        return self.x, self.y

    def angle_beside(self, scale: "Any") -> "Any":
        """Its angle, or None where beside what was added up to it nothing is left."""
        return None if abs(plain(self.x)) + abs(plain(self.y)) <= NOTHING * plain(scale) else self.angle


def polar(size: "Any", angle: "Any") -> Phasor:
    """The phasor of an amount and an angle."""
    cosine, sine = turned(angle)
    return Phasor(size * cosine, size * sine)


def total(parts: "Iterable[Phasor]") -> Phasor:
    """The sum of phasors."""
    those = list(parts)
    whole = those[0]
    for part in those[1:]:
        whole = whole + part
    return whole


def cross(one: Phasor, other: Phasor) -> "Any":
    """The sine of the angle from one to the other, times both amounts."""
    return one.x * other.y - one.y * other.x


def scale_of(parts: "Iterable[Phasor]") -> float:
    """The largest amount that may cancel in a sum."""
    return sum((abs(plain(part.x)) + abs(plain(part.y)) for part in parts), 0.0)
