"""What pictures of linkages share: a plane to scale, pins, blocks, circles, and curves over a turn of the crank."""

from math import cos, pi, sin

from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel
from dynamics_cli.quantities import Angle, Coordinate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Where names stand beside their pins.
LEFT, BELOW = (-14.0, -12.0), (5.0, -12.0)
ROUND = 180
TURN = Axis("crank angle θ", Angle, ends=(0.0, 2.0 * pi), step=pi / 6.0)
ZERO = Band(0.0, 0.0, vertical=False)


def plan(items: "Sequence[Any]", title: str = "") -> Panel:
    """Shapes in the plane, to scale."""
    return Panel(Axis("x", Coordinate), Axis("y", Coordinate), tuple(items), title, equal=True)


def pin(at: complex, name: str, aside: "tuple[float, float]" = (5.0, 5.0)) -> Mark:
    """A point with its name."""
    return Mark(at.real, at.imag, name, aside)


def turned(angle: float) -> complex:
    """The direction of an angle."""
    return complex(cos(angle), sin(angle))


def circle(centre: complex, radius: float) -> "list[complex]":
    """A circle."""
    return [centre + radius * turned(2.0 * pi * k / ROUND) for k in range(ROUND + 1)]


def block(at: complex, size: float) -> "list[complex]":
    """A slider."""
    return [at + size * corner for corner in (-1 - 0.6j, 1 - 0.6j, 1 + 0.6j, -1 + 0.6j, -1 - 0.6j)]


def here(angle: "float | None") -> "tuple[Band, ...]":
    """The line at a crank angle."""
    return () if angle is None else (Band(angle % (2.0 * pi), angle % (2.0 * pi)),)


def over_turn(y: Axis, angles: "Sequence[float]", values: "Sequence[float]", role: int, *bands: Band) -> Panel:
    """One quantity over a turn of the crank."""
    return Panel(TURN, y, (Curve(angles, values, role=role), *bands))
