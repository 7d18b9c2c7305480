"""Closed surfaces made of triangles by exact recipes: only +, ×, ÷ and √, so that every machine makes the same bits."""

import struct
from math import sqrt

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any, TypeAlias

    Point: TypeAlias = tuple[float, float, float]
    Triangle: TypeAlias = tuple[Point, Point, Point]

OCTAHEDRON = [
    ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
    ((0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0)),
    ((-1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0)),
    ((0.0, -1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)),
    ((0.0, 1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, -1.0)),
    ((-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, -1.0)),
    ((0.0, -1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, -1.0)),
    ((1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0)),
]


def _halfway(a: "Point", b: "Point") -> "Point":
    x, y, z = a[0] + b[0], a[1] + b[1], a[2] + b[2]
    size = sqrt(x * x + y * y + z * z)
    return x / size, y / size, z / size


def ball(level: int) -> "list[Triangle]":
    """An octahedron whose triangles are divided into four, `level` times."""
    triangles: list[Triangle] = list(OCTAHEDRON)
    for _ in range(level):
        finer: list[Triangle] = []
        for a, b, c in triangles:
            p, q, r = _halfway(a, b), _halfway(b, c), _halfway(c, a)
            finer += [(a, p, r), (p, b, q), (r, q, c), (p, q, r)]
        triangles = finer
    return triangles


def prism(outline: "list[tuple[float, float]]", height: float) -> "list[Triangle]":
    """A prism on a polygon that is seen whole from its first corner."""
    out: list[Triangle] = []
    low = [(x, y, 0.0) for x, y in outline]
    high = [(x, y, height) for x, y in outline]
    for k in range(1, len(outline) - 1):
        out += [(low[0], low[k + 1], low[k]), (high[0], high[k], high[k + 1])]
    for k in range(len(outline)):
        j = (k + 1) % len(outline)
        out += [(low[k], low[j], high[j]), (low[k], high[j], high[k])]
    return out


SOLIDS: "dict[str, Any]" = {
    "ball 1": lambda: ball(1),
    "ball 2": lambda: ball(2),
    "ball 6": lambda: ball(6),
    "box": lambda: prism([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], 1.0),
    "tetrahedron": lambda: [
        ((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)),
        ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)),
        ((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 1.0, 0.0)),
        ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
    ],
    "bracket": lambda: prism([(0.0, 0.0), (60.0, 0.0), (60.0, 8.0), (8.0, 8.0), (8.0, 40.0), (0.0, 40.0)], 25.0),
    "hollow ball": lambda: ball(1) + [tuple(tuple(0.99 * x for x in p) for p in (a, c, b)) for a, b, c in ball(1)],
}


def turned(point: "Point", q: "tuple[float, float, float, float]") -> "Point":
    """A point turned by a quaternion of any length, and lengthened by the square of it."""
    w, x, y, z = q
    a, b, c = point
    return (
        (w * w + x * x - y * y - z * z) * a + 2.0 * (x * y - w * z) * b + 2.0 * (x * z + w * y) * c,
        2.0 * (x * y + w * z) * a + (w * w - x * x + y * y - z * z) * b + 2.0 * (y * z - w * x) * c,
        2.0 * (x * z - w * y) * a + 2.0 * (y * z + w * x) * b + (w * w - x * x - y * y + z * z) * c,
    )


def single(x: float) -> float:
    """The nearest number of single precision."""
    return float(struct.unpack("<f", struct.pack("<f", x))[0])


def triangles(recipe: "Mapping[str, Any]") -> "list[Triangle]":
    """The triangles of a recipe: solid, stretch, quaternion, offset, and whether rounded to single precision."""
    stretch, quaternion, offset = recipe["stretch"], recipe["quaternion"], recipe["offset"]
    out = []
    for triangle in SOLIDS[recipe["solid"]]():
        corners = []
        for p in triangle:
            q = turned((p[0] * stretch[0], p[1] * stretch[1], p[2] * stretch[2]), quaternion)
            q = (q[0] + offset[0], q[1] + offset[1], q[2] + offset[2])
            corners.append(tuple(map(single, q)) if recipe["single"] else q)
        out.append(tuple(corners))
    return out  # type: ignore[return-value]
