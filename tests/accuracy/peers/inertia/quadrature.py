"""Shapes cut into the curves, patches and cells of a few maps from cubes, and summed by Gauss's quadrature."""

from itertools import pairwise
from math import pi

from dynamics_cli.accuracy.alternatives.inertia.book import properties

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    import numpy as np

    Array = np.ndarray[Any, np.dtype[Any]]
    from dynamics_cli.accuracy.alternatives.inertia.book import Piece, Pieces

TURN = 0.0, 2.0 * pi
RIGHT, QUARTER = (-0.5 * pi, 0.5 * pi), (0.0, 0.5 * pi)
# Nodes around, along, and across, where everything is a polynomial.
AROUND, ALONG, ACROSS = 32, 24, 3


def _gauss(*counts: int) -> "tuple[list[Array], Array]":
    """Nodes of the unit cube, an axis each, and their weights."""
    import numpy as np

    rules = [np.polynomial.legendre.leggauss(count) for count in counts]
    nodes = np.meshgrid(*(0.5 * (x + 1.0) for x, _ in rules), indexing="ij")
    weights = np.ones(1)
    for _, w in rules:
        weights = np.multiply.outer(weights, 0.5 * w)
    return [node.ravel() for node in nodes], weights.ravel()


def _piece(x: "Array", y: "Array", z: "Array", weights: "Array", sign: float = 1.0) -> "Piece":
    """Sums over the nodes, in the mean."""
    total = float(weights.sum())
    share = weights / total

    def mean(values: "Array") -> float:
        return float(share @ values)

    pairs = (x * x, y * y, z * z, x * y, y * z, z * x)
    xx, yy, zz, xy, yz, zx = map(mean, pairs)
    return sign * total, (mean(x), mean(y), mean(z)), (xx, yy, zz, xy, yz, zx)


def _solid(
    profile: "Callable[[Array], tuple[Array, Array, Array, Array]]", span: "tuple[float, float]" = TURN,
    scale: "tuple[float, float]" = (1.0, 1.0), sign: float = 1.0,
) -> "Piece":  # fmt: skip
    """What turns about z between two radii: the profile gives z, dz/ds and both radii at s from 0 to 1."""
    import numpy as np

    (s, across, around), weights = _gauss(ALONG, ACROSS, AROUND)
    z, slope, inner, outer = profile(s)
    radius, angle = inner + (outer - inner) * across, span[0] + (span[1] - span[0]) * around
    weights = weights * slope * (outer - inner) * radius * (span[1] - span[0]) * scale[0] * scale[1]
    return _piece(scale[0] * radius * np.cos(angle), scale[1] * radius * np.sin(angle), z, weights, sign)


def _plate(
    outer: float, span: "tuple[float, float]" = TURN, inner: float = 0.0, z: float = 0.0,
    scale: "tuple[float, float]" = (1.0, 1.0),
) -> "Piece":  # fmt: skip
    """A sector of a ring."""
    import numpy as np

    (across, around), weights = _gauss(ACROSS, AROUND)
    radius, angle = inner + (outer - inner) * across, span[0] + (span[1] - span[0]) * around
    weights = weights * (outer - inner) * radius * (span[1] - span[0]) * scale[0] * scale[1]
    return _piece(scale[0] * radius * np.cos(angle), scale[1] * radius * np.sin(angle), z + 0.0 * radius, weights)


def _sheet(profile: "Callable[[Array], tuple[Array, Array, Array]]", span: "tuple[float, float]" = TURN) -> "Piece":
    """A sheet that turns about z: the profile gives its radius, height and length per s."""
    import numpy as np

    (s, around), weights = _gauss(AROUND, AROUND)
    radius, z, slope = profile(s)
    angle = span[0] + (span[1] - span[0]) * around
    weights = weights * slope * radius * (span[1] - span[0])
    return _piece(radius * np.cos(angle), radius * np.sin(angle), z, weights)


def _arc(radius: float, span: "tuple[float, float]") -> "Piece":
    import numpy as np

    (around,), weights = _gauss(AROUND)
    angle = span[0] + (span[1] - span[0]) * around
    return _piece(radius * np.cos(angle), radius * np.sin(angle), 0.0 * angle, weights * radius * (span[1] - span[0]))


def _straight(a: float, b: float, low: float, high: float) -> "Callable[[Array], tuple[Array, Array, Array, Array]]":
    """A cone's profile from radius a at the low end to b at the high one."""
    return lambda s: (low + (high - low) * s, (high - low) + 0.0 * s, 0.0 * s, a + (b - a) * s)


def _bowl(
    r: float, ring: float = 0.0, start: float = -0.5, up: float = 0.0
) -> "Callable[[Array], tuple[Array, Array, Array, Array]]":
    """A ball's or a ring's profile by the angle of latitude, from `start` half turns to the pole."""
    import numpy as np

    def profile(s: "Array") -> "tuple[Array, Array, Array, Array]":
        angle = pi * (start + (0.5 - start) * s)
        half = r * np.cos(angle)
        slope = pi * (0.5 - start) * half
        return up + r * np.sin(angle), slope, (ring - half if ring else 0.0 * s), ring + half

    return profile


def _bar(width: float, depth: float = 0.0, height: float = 0.0) -> "Piece":
    """A rod, a rectangle or a block about the origin."""
    (x, y, z), weights = _gauss(2, 2, 2)
    size = width * (depth or 1.0) * (height or 1.0)
    return _piece(width * (x - 0.5), depth * (y - 0.5), height * (z - 0.5), weights * size)


def _box(s: "Any") -> "Pieces":
    a, b, c = s.width, s.depth, s.height
    (u, v), weights = _gauss(2, 2)
    made = []
    for side in (-0.5, 0.5):
        at = side + 0.0 * u
        made += [
            _piece(a * (u - 0.5), b * (v - 0.5), c * at, weights * a * b),
            _piece(a * at, b * (u - 0.5), c * (v - 0.5), weights * b * c),
            _piece(a * (v - 0.5), b * at, c * (u - 0.5), weights * c * a),
        ]
    return made


def _fan(corners: "list[tuple[float, float]]", height: float = 0.0) -> "Pieces":
    """A polygon as triangles from its first corner, of a height or of none."""
    (u, v, w), weights = _gauss(2, 2, 2 if height else 1)
    (a, b), made, z = corners[0], [], height * (w - 0.5)
    for (c, d), (e, f) in pairwise(corners[1:]):
        area = (c - a) * (f - b) - (e - a) * (d - b)
        x, y = a + u * (c - a + v * (e - c)), b + u * (d - b + v * (f - d))
        made.append(_piece(x, y, z, weights * u * abs(area) * (height or 1.0), 1.0 if area > 0.0 else -1.0))
    turn = 1.0 if sum(piece[0] for piece in made) > 0.0 else -1.0
    return [(turn * size, centre, second) for size, centre, second in made]


def _pyramid(s: "Any") -> "Pieces":
    (x, y, z), weights = _gauss(2, 2, ACROSS)
    left = 1.0 - z
    whole = weights * left * left * s.width * s.depth * s.height
    return [_piece(s.width * (x - 0.5) * left, s.depth * (y - 0.5) * left, s.height * z, whole)]


def _tetrahedron(s: "Any") -> "Pieces":
    import numpy as np

    (u, v, w), weights = _gauss(ACROSS, ACROSS, ACROSS)
    a, b, c, d = (np.array(corner) for corner in (s.first, s.second, s.third, s.fourth))
    x, y, z = (a[k] + u * (b[k] - a[k] + v * (c[k] - b[k] + w * (d[k] - c[k]))) for k in range(3))
    six = abs(float(np.linalg.det(np.array([b - a, c - b, d - c]))))
    return [_piece(x, y, z, weights * six * u * u * v)]


def _cup(r: float, start: float = -0.5) -> "Callable[[Array], tuple[Array, Array, Array]]":
    """A spherical sheet by the angle of latitude."""
    import numpy as np

    def profile(s: "Array") -> "tuple[Array, Array, Array]":
        angle = pi * (start + (0.5 - start) * s)
        return r * np.cos(angle), r * np.sin(angle), pi * (0.5 - start) * r + 0.0 * s

    return profile


def _tyre(ring: float, r: float) -> "Callable[[Array], tuple[Array, Array, Array]]":
    import numpy as np

    return lambda s: (ring + r * np.cos(2.0 * pi * s), r * np.sin(2.0 * pi * s), 2.0 * pi * r + 0.0 * s)


def _cone(a: float, b: float, low: float, high: float) -> "Callable[[Array], tuple[Array, Array, Array]]":
    from math import hypot

    return lambda s: (a + (b - a) * s, low + (high - low) * s, hypot(a - b, high - low) + 0.0 * s)


def _can(s: "Any") -> "Pieces":
    half = 0.5 * s.length
    ends = {"open": (), "one": (-half,), "both": (-half, half)}[str(s.ends)]
    return [_sheet(_cone(s.radius, s.radius, -half, half)), *(_plate(s.radius, z=z) for z in ends)]


def _regular(s: "Any") -> "Pieces":
    from math import cos, sin

    angles = [2.0 * pi * k / s.sides for k in range(s.sides)]
    return _fan([(s.radius * cos(angle), s.radius * sin(angle)) for angle in angles], s.height)


def _cylinder(s: "Any", span: "tuple[float, float]" = TURN) -> "Piece":
    return _solid(_straight(s.radius, s.radius, -0.5 * s.length, 0.5 * s.length), span)


def _capsule(s: "Any") -> "Pieces":
    size, (x, y, z), (xx, yy, zz, *rest) = _solid(_bowl(s.radius, start=0.0, up=0.5 * s.length))
    # and its mirror image
    xy, yz, zx = rest
    return [_cylinder(s), (size, (x, y, z), (xx, yy, zz, xy, yz, zx)), (size, (x, y, -z), (xx, yy, zz, xy, -yz, -zx))]


SHAPES: "dict[str, Callable[[Any], Pieces]]" = {
    "Rod": lambda s: [_bar(s.length)],
    "Rectangle": lambda s: [_bar(s.width, s.height)],
    "ArcRod": lambda s: [_arc(s.radius, (-0.5 * s.angle, 0.5 * s.angle))],
    "SemicircleRod": lambda s: [_arc(s.radius, RIGHT)],
    "QuarterCircleRod": lambda s: [_arc(s.radius, QUARTER)],
    "RingRod": lambda s: [_arc(s.radius, TURN)],
    "Triangle": lambda s: _fan([(0.0, 0.0), (s.base, 0.0), (s.offset, s.height)]),
    "Polygon": lambda s: _fan([(v.x, v.y) for v in s.vertices]),
    "Disk": lambda s: [_plate(s.radius)],
    "HalfDisk": lambda s: [_plate(s.radius, RIGHT)],
    "QuarterDisk": lambda s: [_plate(s.radius, QUARTER)],
    "Sector": lambda s: [_plate(s.radius, (-0.5 * s.angle, 0.5 * s.angle))],
    "Ellipse": lambda s: [_plate(1.0, scale=(s.x_radius, s.y_radius))],
    "Annulus": lambda s: [_plate(s.radius, inner=s.radius - s.thickness)],
    "CylindricalShell": _can,
    "HalfCylindricalShell": lambda s: [
        _sheet(_cone(s.radius, s.radius, -0.5 * s.length, 0.5 * s.length), RIGHT)
    ],
    "ConicalShell": lambda s: [
        _sheet(_cone(s.radius, 0.0, 0.0, s.height)), *([_plate(s.radius)] if s.closed else [])
    ],
    "FrustumShell": lambda s: [_sheet(_cone(s.base_radius, s.top_radius, 0.0, s.height))],
    "SphericalShell": lambda s: [_sheet(_cup(s.radius))],
    "HemisphericalShell": lambda s: [_sheet(_cup(s.radius, 0.0)), *([_plate(s.radius)] if s.closed else [])],
    "BoxShell": _box,
    "TorusShell": lambda s: [_sheet(_tyre(s.ring_radius, s.radius))],
    "Sphere": lambda s: [_solid(_bowl(s.radius))],
    "Hemisphere": lambda s: [_solid(_bowl(s.radius, start=0.0))],
    "Cylinder": lambda s: [_cylinder(s)],
    "HalfCylinder": lambda s: [_cylinder(s, RIGHT)],
    "QuarterCylinder": lambda s: [_cylinder(s, QUARTER)],
    "EllipticCylinder": lambda s: [
        _solid(_straight(1.0, 1.0, -0.5 * s.length, 0.5 * s.length), scale=(s.x_radius, s.y_radius))
    ],
    "Cone": lambda s: [_solid(_straight(s.radius, 0.0, 0.0, s.height))],
    "Frustum": lambda s: [_solid(_straight(s.base_radius, s.top_radius, 0.0, s.height))],
    "Paraboloid": lambda s: [
        _solid(lambda t: (s.height * t * t, 2.0 * s.height * t, 0.0 * t, s.radius * t))
    ],
    "Capsule": _capsule,
    "Ellipsoid": lambda s: [_scaled(_solid(_bowl(1.0), scale=(s.x_radius, s.y_radius)), s.z_radius)],
    "HalfEllipsoid": lambda s: [_scaled(_solid(_bowl(1.0, start=0.0), scale=(s.x_radius, s.y_radius)), s.z_radius)],
    "Torus": lambda s: [_solid(_bowl(s.radius, s.ring_radius))],
    "Block": lambda s: [_bar(s.width, s.depth, s.height)],
    "Wedge": lambda s: _fan([(0.0, 0.0), (s.width, 0.0), (0.0, s.height)], s.length),
    "Prism": lambda s: _fan([(v.x, v.y) for v in s.vertices], s.height),
    "RegularPrism": _regular,
    "Pyramid": _pyramid,
    "Tetrahedron": _tetrahedron,
}  # fmt: skip


def _scaled(piece: "Piece", up: float) -> "Piece":
    """Stretched along z."""
    size, (x, y, z), (xx, yy, zz, xy, yz, zx) = piece
    return size * up, (x, y, z * up), (xx, yy, zz * up * up, xy, yz * up, zx * up)


def shape(*, shape: "Any", amount: "Any") -> "dict[str, float]":
    """Two to thirty-two Gauss nodes along each direction; of thin walls it has none."""
    if type(shape).__name__ not in SHAPES:
        raise ArithmeticError
    return properties(shape, SHAPES[type(shape).__name__](shape), amount.mass)
