"""Polygons by their corners: area, centroid and second moments as sums over the sides, seen from the centroid."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.shapes.unit import Unit
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Annotated, Coordinate
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Pair: TypeAlias = tuple[float, float]


@record
class Vertex:
    """A corner."""

    x: Annotated[Coordinate, "Its x [m]."]
    y: Annotated[Coordinate, "Its y [m]."]


def polygon_unit(vertices: "tuple[Vertex, ...]", height: float = 0.0, *, solid: bool = False) -> Unit:
    """A polygon with a mass of 1 kg, or the straight prism on it, its mid-plane at z = 0; corners in either sense."""
    require(
        len(vertices) >= 3,
        "a polygon needs at least 3 corners; read {count}",
        code="polygon",
        hint="give --vertex three times or more",
        count=len(vertices),
    )
    first = vertices[0]
    corners = [(vertex.x - first.x, vertex.y - first.y) for vertex in vertices]
    _require_simple(corners)
    area, x, y = _first_moments(corners)
    require(area > 0.0 or area < 0.0, "the polygon has no area", code="polygon", hint="check the order of the corners")
    # seen from near the centroid nothing large is subtracted; any point serves, so this one is a plain number
    middle = (plain(x / (3.0 * area)), plain(y / (3.0 * area)))
    shifted = [(px - middle[0], py - middle[1]) for px, py in corners]
    area, x, y = _first_moments(shifted)
    rest = (x / (3.0 * area), y / (3.0 * area))
    xx = yy = xy = 0.0
    for (ax, ay), (bx, by) in _sides(shifted):
        weight = ax * (by - ay) - ay * (bx - ax)
        sx, sy = ax + bx, ay + by
        xx = xx + weight * (ax * ax + bx * bx + sx * sx)
        yy = yy + weight * (ay * ay + by * by + sy * sy)
        xy = xy + weight * (ax * ay + bx * by + sx * sy)
    scale = 12.0 * area
    return Unit(
        0.5 * abs(area) * (height if solid else 1.0),
        (first.x + middle[0] + rest[0], first.y + middle[1] + rest[1], 0.0),
        xx / scale - rest[0] * rest[0],
        yy / scale - rest[1] * rest[1],
        height * height / 12.0,
        xy=xy / scale - rest[0] * rest[1],
    )


def _sides(corners: "list[Pair]") -> "list[tuple[Pair, Pair]]":
    return list(zip(corners, [*corners[1:], corners[0]], strict=True))


def _first_moments(corners: "list[Pair]") -> "tuple[float, float, float]":
    """Twice the area, and six times its first moments."""
    area = x = y = 0.0
    for (ax, ay), (bx, by) in _sides(corners):
        weight = ax * (by - ay) - ay * (bx - ax)
        area = area + weight
        x = x + weight * (ax + bx)
        y = y + weight * (ay + by)
    return area, x, y


def _require_simple(corners: "list[Pair]") -> None:
    """Refuse sides that cross: such an outline has no definite area."""
    sides = _sides([(getattr(x, "value", x), getattr(y, "value", y)) for x, y in corners])
    for i, (a, b) in enumerate(sides):
        for j in range(i + 2, len(sides) - (i == 0)):
            c, d = sides[j]
            require(
                not (_apart(a, b, c, d) and _apart(c, d, a, b)),
                "sides {first} and {second} of the polygon cross",
                code="polygon",
                hint="give the corners in order along the outline",
                first=i + 1,
                second=j + 1,
            )


def _apart(a: "Pair", b: "Pair", c: "Pair", d: "Pair") -> bool:
    """Whether c and d lie on either side of the line through a and b."""
    return _turn(a, b, c) * _turn(a, b, d) < 0.0


def _turn(a: "Pair", b: "Pair", c: "Pair") -> float:
    value = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (value > 0.0) - (value < 0.0)
