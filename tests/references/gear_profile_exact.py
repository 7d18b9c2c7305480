"""How far a drawn profile is from the exact one: vertices from their curves, curves from their chords.

An involute's parallel curves are involutes, so a point's distance from it is the base circle times an angle. From the
trochoid it is where the gradient of the squared distance vanishes; a curve is farthest from its chord where the two are
parallel, found by halving in the curve's own parameter.
"""

from abc import ABC, abstractmethod
from typing import Any

from gear_exact import Exact, Tooth, atan2, cos, illinois, pi, sin, sqrt, tan

H = Exact(2) ** -100
HALVINGS = 30


class Flank(ABC):
    """One flank of the tooth that points along +y, by a parameter; the right one, mirrored for the left."""

    def __init__(self, tooth: Tooth) -> None:
        self.tooth = tooth

    @abstractmethod
    def point(self, t: Any) -> tuple[Any, Any]:
        """A point at a parameter."""

    @abstractmethod
    def off(self, x: Any, y: Any) -> Any:
        """How far a point is from the curve."""

    @abstractmethod
    def parameter(self, x: Any, y: Any) -> Any:
        """The parameter of the curve's point nearest a point."""

    def arrow(self, a: tuple[Any, Any], b: tuple[Any, Any]) -> Any:
        """The largest distance of the curve between two points of it from their chord."""
        ux, uy = b[0] - a[0], b[1] - a[1]
        size = sqrt(ux * ux + uy * uy)
        low, high = self.parameter(*a), self.parameter(*b)

        def height(t: Any) -> Any:
            x, y = self.point(t)
            return ((x - a[0]) * uy - (y - a[1]) * ux) / size

        def slope(t: Any) -> Any:
            return height(t + H) - height(t - H)

        start = slope(low)
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            low, high = (middle, high) if (slope(middle) > 0) == (start > 0) else (low, middle)
        return abs(height(low))


class Involute(Flank):
    """The involute, by its roll angle."""

    def half(self, roll: Any) -> Any:
        """Angle from the centreline of the tooth at a roll angle."""
        bounded = self.tooth.solid - roll + atan2(roll, Exact(1))
        return pi() / self.tooth.z - bounded if self.tooth.internal else bounded

    def point(self, t: Any) -> tuple[Any, Any]:
        radius, angle = self.tooth.rb * sqrt(1 + t * t), self.half(t)
        return radius * sin(angle), radius * cos(angle)

    def parameter(self, x: Any, y: Any) -> Any:
        square = (x * x + y * y) / (self.tooth.rb * self.tooth.rb) - 1
        return sqrt(square) if square > 0 else Exact(0)

    def off(self, x: Any, y: Any) -> Any:
        roll = self.parameter(x, y)
        return abs(self.tooth.rb * (atan2(x, y) - self.half(roll)))


class Trochoid(Flank):
    """The trochoid, by the parameter of the rack's corner."""

    def point(self, t: Any) -> tuple[Any, Any]:
        x, y, _, _ = self.tooth.rolled(t)
        # from the middle of the space to the middle of the tooth beside it
        turn = pi() / self.tooth.z
        c, s = cos(turn), sin(turn)
        return x * s - y * c, x * c + y * s

    def parameter(self, x: Any, y: Any) -> Any:
        low = self.tooth.alpha if self.tooth.corner is None else self.tooth.corner
        high = pi() / 2

        def slope(t: Any) -> Any:
            px, py = self.point(t)
            qx, qy = self.point(t + H)
            return (x - px) * (qx - px) + (y - py) * (qy - py)

        # an end of the trochoid is nearest to itself
        if slope(low) <= 0:
            return low
        if slope(high) >= 0:
            return high
        return illinois(slope, low, high)

    def off(self, x: Any, y: Any) -> Any:
        px, py = self.point(self.parameter(x, y))
        return sqrt((x - px) ** 2 + (y - py) ** 2)


def fillet_off(tooth: Tooth, x: Any, y: Any) -> Any:
    """How far a point on the right side of an internal gear's tooth at +y is from its fillet's circle."""
    centre = tooth.root - tooth.fillet
    angle = pi() / tooth.z - tooth.fillet_half
    cx, cy = centre * sin(angle), centre * cos(angle)
    return abs(sqrt((x - cx) ** 2 + (y - cy) ** 2) - tooth.fillet)


def circle_off(radius: Any, x: Any, y: Any) -> Any:
    """How far a point is from a circle about the centre."""
    return abs(sqrt(x * x + y * y) - radius)


def rack_corners(m: Any, alpha: Any, ha: Any, hf: Any, rho: Any, index: int) -> list[tuple[Any, Any]]:
    """The corners of a rack's tooth from left to right: flank and corner tangent, so the arc's centre tells both."""
    quarter = pi() / 4
    tip = quarter - ha * tan(alpha)
    # the corner's centre stands ρ above the root line and ρ from the flank's line x = π/4 + h·tan α at depth h
    depth = hf - rho
    centre = quarter + depth * tan(alpha) + rho / cos(alpha)
    right = [(tip, ha), (centre - rho * cos(alpha), -(depth + rho * sin(alpha))), (centre, -hf)]
    left = [(-x, y) for x, y in reversed(right)]
    return [(m * (x + pi() * index), m * y) for x, y in left + right]
