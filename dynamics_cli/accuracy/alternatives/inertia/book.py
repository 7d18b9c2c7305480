"""Shapes by the integrals that handbooks print about an edge, a base or a centre; walls as outer less inner.

I = ∫ (r²·1 − r·rᵀ) dm − m·(c²·1 − c·cᵀ): digits go as the mass centre lies far off or a wall becomes thin.
"""

from math import pi, sin

from dynamics_cli.accuracy.alternatives.inertia.bodies import named

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    # How large a piece is (negative: cut out), its centroid, and its mean xx, yy, zz, xy, yz, zx about the origin.
    Piece = tuple[float, tuple[float, float, float], tuple[float, float, float, float, float, float]]
    Pieces = list[Piece]

FLAT = 0.0, 0.0, 0.0


def _round(size: float, z: float, across: float, along: float) -> "Piece":
    """A piece alike about z: ∫x² = ∫y² = across, ∫z² = along, of size one."""
    return size, (0.0, 0.0, z), (across, across, along, *FLAT)


def _symmetric(size: float, xx: float, yy: float, zz: float, z: float = 0.0) -> "Piece":
    return size, (0.0, 0.0, z), (xx, yy, zz, *FLAT)


def _arc(size: float, mean: float, square: float, half: float, along: float = 0.0) -> "Piece":
    """An arc or a sector of half angle α about x: x̄ = r̄·sin α/α, ∫x² = r̄²/2·(1 + sin 2α/2α)."""
    swing = sin(2.0 * half) / (2.0 * half)
    x = mean * sin(half) / half
    return size, (x, 0.0, 0.0), (0.5 * square * (1.0 + swing), 0.5 * square * (1.0 - swing), along, *FLAT)


def _quarter(size: float, mean: float, square: float, along: float = 0.0) -> "Piece":
    """A quarter between x and y: x̄ = ȳ = 2r̄/π, ∫xy = r̄²/π."""
    x = 2.0 * mean / pi
    return size, (x, x, 0.0), (0.5 * square, 0.5 * square, along, square / pi, 0.0, 0.0)


def _disk(r: float, z: float = 0.0) -> "Piece":
    return _round(pi * r**2, z, r**2 / 4.0, z**2)


def _cylinder(r: float, length: float) -> "Piece":
    return _round(pi * r**2 * length, 0.0, r**2 / 4.0, length**2 / 12.0)


def _block(a: float, b: float, c: float) -> "Piece":
    return _symmetric(a * b * c, a**2 / 12.0, b**2 / 12.0, c**2 / 12.0)


def _ball(r: float) -> "Piece":
    return _round(4.0 / 3.0 * pi * r**3, 0.0, r**2 / 5.0, r**2 / 5.0)


def _half_ball(r: float) -> "Piece":
    return _round(2.0 / 3.0 * pi * r**3, 3.0 / 8.0 * r, r**2 / 5.0, r**2 / 5.0)


def _frustum(a: float, b: float, h: float) -> "Piece":
    square = a**2 + a * b + b**2
    across = 3.0 * (a**4 + a**3 * b + a**2 * b**2 + a * b**3 + b**4) / (20.0 * square)
    along = h**2 * (a**2 + 3.0 * a * b + 6.0 * b**2) / (10.0 * square)
    return _round(pi * h * square / 3.0, h * (a**2 + 2.0 * a * b + 3.0 * b**2) / (4.0 * square), across, along)


def _torus(ring: float, r: float) -> "Piece":
    return _round(2.0 * pi**2 * ring * r**2, 0.0, ring**2 / 2.0 + 3.0 * r**2 / 8.0, r**2 / 4.0)


def _less(outer: "Piece", inner: "Piece") -> "Pieces":
    return [outer, (-inner[0], *inner[1:])]


def _sides(vertices: "Any") -> "Pieces":
    """Sums over the sides from the origin: A = Σ (xᵢyⱼ − xⱼyᵢ)/2, and so on, each side's triangle with the origin."""
    made = []
    for one, two in zip(vertices, (*vertices[1:], vertices[0]), strict=True):
        a, b, c, d = one.x, one.y, two.x, two.y
        made.append(
            (
                0.5 * (a * d - c * b),
                ((a + c) / 3.0, (b + d) / 3.0, 0.0),
                ((a * a + a * c + c * c) / 6.0, (b * b + b * d + d * d) / 6.0, 0.0,
                 (a * d + 2.0 * a * b + 2.0 * c * d + c * b) / 12.0, 0.0, 0.0),
            )
        )  # fmt: skip
    turn = 1.0 if sum(piece[0] for piece in made) > 0.0 else -1.0
    return [(turn * size, centre, second) for size, centre, second in made]


def _prism(s: "Any") -> "Pieces":
    own = s.height**2 / 12.0
    return [(size * s.height, c, (xx, yy, own, xy, 0.0, 0.0)) for size, c, (xx, yy, _, xy, _, _) in _sides(s.vertices)]


def _triangle(s: "Any") -> "Pieces":
    """About the corner at the origin: ∫x² = (a² + a·b + b²)/6, ∫y² = h²/6, ∫xy = h·(2a + b)/12."""
    b, h, a = s.base, s.height, s.offset
    second = ((a**2 + a * b + b**2) / 6.0, h**2 / 6.0, 0.0, h * (2.0 * a + b) / 12.0, 0.0, 0.0)
    return [(0.5 * b * h, ((a + b) / 3.0, h / 3.0, 0.0), second)]


def _wedge(s: "Any") -> "Pieces":
    a, b, c = s.width, s.height, s.length
    return [(0.5 * a * b * c, (a / 3.0, b / 3.0, 0.0), (a**2 / 6.0, b**2 / 6.0, c**2 / 12.0, a * b / 12.0, 0.0, 0.0))]


def _tetrahedron(s: "Any") -> "Pieces":
    """∫ r·rᵀ = (Σ rᵢ·rᵢᵀ + s·sᵀ)/20 about the origin, s the sum of the corners."""
    import numpy as np

    corners = np.array([s.first, s.second, s.third, s.fourth])
    total = corners.sum(axis=0)
    second = (corners.T @ corners + np.outer(total, total)) / 20.0
    volume = abs(float(np.linalg.det(corners[1:] - corners[0]))) / 6.0
    x, y, z = (float(v) / 4.0 for v in total)
    xx, yy, zz, xy, yz, zx = (float(second[i, j]) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)))
    return [(volume, (x, y, z), (xx, yy, zz, xy, yz, zx))]


# Shapes whose mass centre is not where their sizes are from, or whose walls are differences.
SHAPES: "dict[str, Callable[[Any], Pieces]]" = {
    "ArcRod": lambda s: [_arc(s.radius * s.angle, s.radius, s.radius**2, 0.5 * s.angle)],
    "SemicircleRod": lambda s: [_arc(pi * s.radius, s.radius, s.radius**2, 0.5 * pi)],
    "QuarterCircleRod": lambda s: [_quarter(0.5 * pi * s.radius, s.radius, s.radius**2)],
    "Triangle": _triangle,
    "Polygon": lambda s: _sides(s.vertices),
    "HalfDisk": lambda s: [_arc(0.5 * pi * s.radius**2, 2.0 * s.radius / 3.0, s.radius**2 / 2.0, 0.5 * pi)],
    "QuarterDisk": lambda s: [_quarter(0.25 * pi * s.radius**2, 2.0 * s.radius / 3.0, s.radius**2 / 2.0)],
    "Sector": lambda s: [
        _arc(0.5 * s.angle * s.radius**2, 2.0 * s.radius / 3.0, s.radius**2 / 2.0, 0.5 * s.angle)
    ],
    "Annulus": lambda s: _less(_disk(s.radius), _disk(s.radius - s.thickness)),
    "HalfCylindricalShell": lambda s: [
        _arc(pi * s.radius * s.length, s.radius, s.radius**2, 0.5 * pi, s.length**2 / 12.0)
    ],
    "Hemisphere": lambda s: [_half_ball(s.radius)],
    "HalfCylinder": lambda s: [
        _arc(0.5 * pi * s.radius**2 * s.length, 2.0 * s.radius / 3.0, s.radius**2 / 2.0, 0.5 * pi, s.length**2 / 12.0)
    ],
    "QuarterCylinder": lambda s: [
        _quarter(0.25 * pi * s.radius**2 * s.length, 2.0 * s.radius / 3.0, s.radius**2 / 2.0, s.length**2 / 12.0)
    ],
    "Cone": lambda s: [_frustum(s.radius, 0.0, s.height)],
    "Frustum": lambda s: [_frustum(s.base_radius, s.top_radius, s.height)],
    "Paraboloid": lambda s: [
        _round(0.5 * pi * s.radius**2 * s.height, 2.0 * s.height / 3.0, s.radius**2 / 6.0, s.height**2 / 2.0)
    ],
    "HalfEllipsoid": lambda s: [
        _symmetric(2.0 / 3.0 * pi * s.x_radius * s.y_radius * s.z_radius, s.x_radius**2 / 5.0, s.y_radius**2 / 5.0,
                   s.z_radius**2 / 5.0, 3.0 / 8.0 * s.z_radius)
    ],
    "Wedge": _wedge,
    "Prism": _prism,
    "Pyramid": lambda s: [
        _symmetric(s.width * s.depth * s.height / 3.0, s.width**2 / 20.0, s.depth**2 / 20.0, s.height**2 / 10.0,
                   s.height / 4.0)
    ],
    "Tetrahedron": _tetrahedron,
    "HollowSphere": lambda s: _less(_ball(s.radius), _ball(s.radius - s.thickness)),
    "HollowHemisphere": lambda s: _less(_half_ball(s.radius), _half_ball(s.radius - s.thickness)),
    "HollowCylinder": lambda s: _less(_cylinder(s.radius, s.length), _cylinder(s.radius - s.thickness, s.length)),
    "ClosedCylinder": lambda s: _less(
        _cylinder(s.radius, s.length), _cylinder(s.radius - s.thickness, s.length - 2.0 * s.thickness)
    ),
    "HollowFrustum": lambda s: _less(
        _frustum(s.base_radius, s.top_radius, s.height),
        _frustum(s.base_radius - s.thickness, s.top_radius - s.thickness, s.height),
    ),
    "HollowBlock": lambda s: _less(
        _block(s.width, s.depth, s.height), _block(*(x - 2.0 * s.thickness for x in (s.width, s.depth, s.height)))
    ),
    "RectangularTube": lambda s: _less(
        _block(s.width, s.depth, s.length),
        _block(s.width - 2.0 * s.thickness, s.depth - 2.0 * s.thickness, s.length),
    ),
    "HollowTorus": lambda s: _less(_torus(s.ring_radius, s.radius), _torus(s.ring_radius, s.radius - s.thickness)),
}  # fmt: skip


def properties(shape: "Any", pieces: "Pieces", mass: float) -> "dict[str, Any]":
    """Measure, mass centre, tensor and principal moments (LAPACK) of pieces of one density."""
    import numpy as np

    sizes = np.array([piece[0] for piece in pieces])
    whole = float(sizes.sum())
    centre = sizes @ np.array([piece[1] for piece in pieces]) / whole
    xx, yy, zz, xy, yz, zx = (sizes @ np.array([piece[2] for piece in pieces]) / whole).tolist()
    second = np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]) - np.outer(centre, centre)
    tensor = mass * (np.trace(second) * np.eye(3) - second)
    size = {("length", "area", "volume")[shape.dimension - 1]: whole, "mass": mass}
    return size | named(centre.tolist(), tensor.tolist(), np.linalg.eigvalsh(tensor).tolist())


def shape(shape: "Any", *, amount: "Any") -> "dict[str, Any]":
    """Integrals as handbooks print them about the origin of the shape, and parallel axes."""
    if type(shape).__name__ not in SHAPES:
        raise ArithmeticError
    return properties(shape, SHAPES[type(shape).__name__](shape), amount.mass)
