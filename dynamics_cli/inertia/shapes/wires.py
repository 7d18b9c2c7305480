"""Shapes as a few lines in space, for pictures: rims and sides of solids of revolution, edges of prisms and boxes."""

from math import cos, pi, sin, sqrt

from dynamics_cli.inertia.shapes.hollow import HollowBlock, HollowTorus, RectangularTube
from dynamics_cli.inertia.shapes.plates import Annulus, Disk, Ellipse, Polygon, Rectangle, Sector, Triangle
from dynamics_cli.inertia.shapes.polyhedra import Block, Prism, Pyramid, RegularPrism, Tetrahedron, Wedge
from dynamics_cli.inertia.shapes.quadrics import Ellipsoid, EllipticCylinder, HalfEllipsoid, Paraboloid
from dynamics_cli.inertia.shapes.rods import ArcRod, Rod
from dynamics_cli.inertia.shapes.shells import BoxShell, TorusShell
from dynamics_cli.inertia.shapes.solids import Capsule, Torus

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeAlias

    from dynamics_cli.inertia.bodies.mass_moments import Vector

    Wire: TypeAlias = list[Vector]

STEPS = 48


def wires(shape: "Any") -> "list[Wire]":
    """Lines that show a shape in its own axes."""
    for classes, draw in DRAWN:
        if isinstance(shape, classes):
            return draw(shape)
    return _round(shape)


def ring(radius: float, z: float, other: float | None = None, first: float = 0.0, last: float = 2.0 * pi) -> "Wire":
    """A circle, an ellipse or an arc of them at a height."""
    b = radius if other is None else other
    angles = [first + (last - first) * k / STEPS for k in range(STEPS + 1)]
    return [(radius * cos(t), b * sin(t), z) for t in angles]


def _round(shape: "Any") -> "list[Wire]":
    """Wires of a body of revolution about z, whole, half or quarter, from its radii and heights."""
    low, high = _heights(shape)
    base = getattr(shape, "base_radius", getattr(shape, "radius", 0.0))
    name = type(shape).__name__
    top = getattr(shape, "top_radius", 0.0 if name in ("Cone", "ConicalShell") else base)
    first, last = _span(name)
    if "pher" in name:
        full = not name.lower().replace("hollow", "").startswith("hemi")
        return _ball(base, base, base, whole=full)
    wall = shape.wall.inside(base)[1] if hasattr(shape, "wall") else getattr(shape, "thickness", 0.0)
    lines = [ring(base, low, None, first, last)]
    if 0.0 < wall < base:
        lines.append(ring(base - wall, low))
    if high > low:
        lines.append(ring(top, high, None, first, last))
        sides = [first, last] if last - first < 2.0 * pi else [k * pi / 2.0 for k in range(4)]
        lines += [[(base * cos(t), base * sin(t), low), (top * cos(t), top * sin(t), high)] for t in sides]
    if last - first < 2.0 * pi:
        lines += [
            [(0.0, 0.0, z), (r * cos(t), r * sin(t), z)] for z, r in ((low, base), (high, top)) for t in (first, last)
        ]
    return lines


def _span(name: str) -> "tuple[float, float]":
    if name.startswith(("Half", "Semi")):
        return -0.5 * pi, 0.5 * pi
    return (0.0, 0.5 * pi) if name.startswith("Quarter") else (0.0, 2.0 * pi)


def _heights(shape: "Any") -> "tuple[float, float]":
    if hasattr(shape, "length"):
        return -0.5 * shape.length, 0.5 * shape.length
    return 0.0, getattr(shape, "height", 0.0)


def _ball(a: float, b: float, c: float, *, whole: bool = True) -> "list[Wire]":
    arc = (
        [-pi / 2 + pi * k / STEPS for k in range(STEPS + 1)]
        if whole
        else [0.5 * pi * k / STEPS for k in range(STEPS + 1)]
    )
    turns = [k * 0.5 * pi for k in range(4)]
    return [ring(a, 0.0, b), *([(a * cos(h) * cos(t), b * cos(h) * sin(t), c * sin(h)) for h in arc] for t in turns)]


def _box(shape: "Any") -> "list[Wire]":
    if isinstance(shape, Rectangle):
        return _prism([(x * shape.width / 2, y * shape.height / 2) for x, y in SQUARE], 0.0, 0.0)
    height = getattr(shape, "length", getattr(shape, "height", 0.0))
    outer = [(x * shape.width / 2, y * shape.depth / 2) for x, y in SQUARE]
    return _prism(outer, -height / 2, height / 2)


SQUARE = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))


def _prism(corners: "list[tuple[float, float]]", low: float, high: float) -> "list[Wire]":
    closed = [*corners, corners[0]]
    lines: list[Wire] = [[(x, y, low) for x, y in closed]]
    if high > low:
        lines.append([(x, y, high) for x, y in closed])
        lines += [[(x, y, low), (x, y, high)] for x, y in corners]
    return lines


def _flat(shape: "Any") -> "list[Wire]":
    if isinstance(shape, Triangle):
        return _prism([(0.0, 0.0), (shape.base, 0.0), (shape.offset, shape.height)], 0.0, 0.0)
    if isinstance(shape, Wedge):
        corners = [(0.0, 0.0), (shape.width, 0.0), (0.0, shape.height)]
        return _prism(corners, -shape.length / 2, shape.length / 2)
    if isinstance(shape, RegularPrism):
        n = shape.sides
        corners = [(shape.radius * cos(2 * pi * k / n), shape.radius * sin(2 * pi * k / n)) for k in range(n)]
    else:
        corners = [(vertex.x, vertex.y) for vertex in shape.vertices]
    half = 0.5 * getattr(shape, "height", 0.0)
    return _prism(corners, -half, half)


def _corners(shape: "Any") -> "list[Wire]":
    if isinstance(shape, Tetrahedron):
        p = (shape.first, shape.second, shape.third, shape.fourth)
        return [[p[i], p[j]] for i in range(4) for j in range(i)]
    base = [(x * shape.width / 2, y * shape.depth / 2) for x, y in SQUARE]
    top = (0.0, 0.0, shape.height)
    return [*_prism(base, 0.0, 0.0), *([(x, y, 0.0), top] for x, y in base)]


def _arc(shape: "Any") -> "list[Wire]":
    half = 0.5 * shape.angle
    rim = ring(shape.radius, 0.0, None, -half, half)
    return [rim] if isinstance(shape, ArcRod) else [[(0.0, 0.0, 0.0), *rim, (0.0, 0.0, 0.0)]]


def _torus(shape: "Any") -> "list[Wire]":
    big, small = shape.ring_radius, shape.radius
    torus = [ring(big + small, 0.0), ring(big - small, 0.0), ring(big, small), ring(big, -small)]
    for t in (0.0, 0.5 * pi, pi, 1.5 * pi):
        section = [
            ((big + x) * cos(t), (big + x) * sin(t), z) for x, z, _ in ((p[0], p[1], 0) for p in ring(small, 0.0))
        ]
        torus.append(section)
    return torus


def _special(shape: "Any") -> "list[Wire]":
    if isinstance(shape, Rod):
        return [[(-0.5 * shape.length, 0.0, 0.0), (0.5 * shape.length, 0.0, 0.0)]]
    if isinstance(shape, Ellipse):
        return [ring(shape.x_radius, 0.0, shape.y_radius)]
    if isinstance(shape, Disk):
        return [ring(shape.radius, 0.0)]
    if isinstance(shape, Annulus):
        return [ring(shape.radius, 0.0), ring(shape.wall.inside(shape.radius)[0], 0.0)]
    if isinstance(shape, EllipticCylinder):
        a, b, h = shape.x_radius, shape.y_radius, 0.5 * shape.length
        sides = [(a, 0.0), (0.0, b), (-a, 0.0), (0.0, -b)]
        return [ring(a, -h, b), ring(a, h, b), *([(x, y, -h), (x, y, h)] for x, y in sides)]
    if isinstance(shape, Capsule):
        r, h = shape.radius, 0.5 * shape.length
        caps = [[(x, y, z + h) for x, y, z in wire] for wire in _ball(r, r, r, whole=False)]
        below = [[(x, y, -z) for x, y, z in wire] for wire in caps]
        sides = [(r, 0.0), (0.0, r), (-r, 0.0), (0.0, -r)]
        return [*caps, *below, *([(x, y, -h), (x, y, h)] for x, y in sides)]
    if isinstance(shape, Paraboloid):
        heights = [k / STEPS for k in range(STEPS + 1)]
        turns = [k * 0.5 * pi for k in range(4)]
        r, h = shape.radius, shape.height
        return [
            ring(r, h),
            *([(r * sqrt(s) * cos(t), r * sqrt(s) * sin(t), h * s) for s in heights] for t in turns),
        ]
    return _ball(shape.x_radius, shape.y_radius, shape.z_radius, whole=isinstance(shape, Ellipsoid))


DRAWN = (
    ((Rectangle, Block, BoxShell, HollowBlock, RectangularTube), _box),
    ((Triangle, Wedge, RegularPrism, Polygon, Prism), _flat),
    ((Pyramid, Tetrahedron), _corners),
    ((ArcRod, Sector), _arc),
    ((Torus, TorusShell, HollowTorus), _torus),
    ((Rod, Ellipse, Disk, Annulus, EllipticCylinder, Capsule, Paraboloid, Ellipsoid, HalfEllipsoid), _special),
)
