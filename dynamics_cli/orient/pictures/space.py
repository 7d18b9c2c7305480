"""Vectors in space as they are drawn on paper: seen from the side of the first octant, or from above when flat."""

from math import cos, pi, radians, sin

from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.orientation.quaternions import of_axis_angle, rotated
from dynamics_cli.numerics.orientation.rotations import from_quaternion
from dynamics_cli.pictures import Arrow, Axis, Curve, Label, Panel

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Vector = tuple[float, float, float]
    Point = tuple[float, float]

# Where the eye is: azimuth and elevation.
AZIMUTH, ELEVATION = radians(32.0), radians(24.0)
STEPS = 48
FLAT = 1e-12
GREY = 6


def numbers(v: "Any") -> "Vector":
    """A vector in doubles."""
    x, y, z = (float(plain(part)) for part in v)
    return x, y, z


def seen(v: "Sequence[float]") -> "Point":
    """A vector on paper, seen from the first octant."""
    x, y, z = v
    right = -sin(AZIMUTH) * x + cos(AZIMUTH) * y
    up = -sin(ELEVATION) * (cos(AZIMUTH) * x + sin(AZIMUTH) * y) + cos(ELEVATION) * z
    return right, up


def from_above(v: "Sequence[float]") -> "Point":
    """A vector on paper, seen from above."""
    return v[0], v[1]


def view_of(vectors: "Sequence[Sequence[float]]") -> "Any":
    """From above when all vectors are in the plane of x and y, else from the side."""
    size = max((abs(part) for v in vectors for part in v), default=0.0)
    return from_above if all(abs(v[2]) <= FLAT * size for v in vectors) else seen


def arrow(
    v: "Sequence[float]", label: str, role: int, view: "Any" = seen, *, start: "Sequence[float]" = (0.0, 0.0, 0.0),
    dashed: bool = False,
) -> Arrow:  # fmt: skip
    """An arrow for a vector from a point."""
    x, y = view(start)
    dx, dy = view(v)
    return Arrow(x, y, dx, dy, label, role, dashed=dashed)


def curve(points: "Sequence[Sequence[float]]", style: str, role: int = GREY, view: "Any" = seen) -> Curve:
    """A line through points in space."""
    flat = [view(point) for point in points]
    return Curve([x for x, _ in flat], [y for _, y in flat], style=style, role=role)  # type: ignore[arg-type]


def words(at: "Sequence[float]", text: str, role: int = 6, view: "Any" = seen) -> Label:
    """Label beside the tip of a vector."""
    x, y = view(at)
    return Label(x, y, text, role)


def triad(matrix: "Any", mark: str, role: int, *, dashed: bool = False) -> "list[Any]":
    """Three arrows along the columns of a rotation matrix."""
    items: list[Any] = []
    for k, name in enumerate("xyz"):
        tip = numbers(tuple(plain(row[k]) for row in matrix))
        items.append(arrow(tip, "", role, dashed=dashed))
        # primed names farther out, for axes that fall together
        items.append(words(tuple((1.2 if mark in ("′", "₂") else 1.08) * part for part in tip), name + mark, role))
    return items


def swept(axis: "Sequence[float]", angle: float, start: "Vector") -> "list[Vector]":
    """The way of a vector that turns about an axis."""
    return [rotated(from_quaternion(of_axis_angle(numbers(axis), angle * k / STEPS)), start) for k in range(STEPS + 1)]


def circle(centre: "Vector", first: "Vector", second: "Vector", radius: float) -> "list[Vector]":
    """A circle in the plane of two unit vectors."""
    turns = [2.0 * pi * k / (2 * STEPS) for k in range(2 * STEPS + 1)]
    return [
        tuple(c + radius * (cos(t) * a + sin(t) * b) for c, a, b in zip(centre, first, second, strict=True))  # type: ignore[misc]
        for t in turns
    ]


def scene(items: "Sequence[Any]", title: "Any" = "", *, room: float = 0.0) -> Panel:
    """A panel without axes, on one scale; `room` is half its width and height."""
    if not room:
        return Panel(Axis(""), Axis(""), tuple(items), title, equal=True, bare=True)
    ends = (-room, room)
    return Panel(Axis("", ends=ends), Axis("", ends=ends), tuple(items), title, equal=True, bare=True)
