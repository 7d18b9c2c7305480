"""Shapes as patches of the unit cube, and their mass, centroid and second moments by quadrature at any precision.

Nothing of the program's formulas is here: a patch maps (u, v, w) of [0, 1]^d to a point and the element of length, area
or volume there. Full turns are integrated by the trapezoidal rule, which is exact for them; all other directions by
Gauss and Legendre, exact for polynomials and at 40 digits with the nodes taken for the arcs used.
"""

from collections.abc import Callable
from functools import cache
from typing import Any

from mpmath import cos, mp, mpf, pi, sin, sqrt

mp.dps = 90
Point = tuple[Any, Any, Any]
Patch = tuple[str, Callable[..., tuple[Point, Any]], int]


@cache
def gauss(n: int) -> list[tuple[Any, Any]]:
    """Nodes and weights on [0, 1]."""
    found = []
    for k in range(n):
        x = cos(pi * (k + mpf(3) / 4) / (n + mpf(1) / 2))
        for _ in range(12):
            p0, p1 = mpf(1), x
            for j in range(2, n + 1):
                p0, p1 = p1, ((2 * j - 1) * x * p1 - (j - 1) * p0) / j
            slope = n * (x * p1 - p0) / (x * x - 1)
            x -= p1 / slope
        found.append(((x + 1) / 2, 1 / ((1 - x * x) * slope * slope)))
    return found


@cache
def turn(n: int = 6) -> list[tuple[Any, Any]]:
    """Nodes of a full turn as shares of it, exact for trigonometric polynomials below degree n."""
    return [(mpf(k) / n, mpf(1) / n) for k in range(n)]


def rule(letter: str) -> list[tuple[Any, Any]]:
    """The rule of a direction: o a full turn, a an arc, p a polynomial."""
    return {"o": turn(), "a": gauss(34), "p": gauss(6)}[letter]


def integrate(patches: list[Patch]) -> dict[str, Any]:
    """Measure, centroid and central second moments for a mass of one; the sign of a patch adds it or takes it away."""
    sums = [mpf(0)] * 10
    samples: list[tuple[Point, Any]] = []
    for letters, place, sign in patches:
        nodes: list[tuple[list[Any], Any]] = [([], mpf(sign))]
        for letter in letters:
            nodes = [([*at, x], weight * w) for at, weight in nodes for x, w in rule(letter)]
        for at, weight in nodes:
            point, element = place(*at)
            samples.append((point, weight * element))
    for (x, y, z), w in samples:
        for k, term in enumerate((1, x, y, z)):
            sums[k] += w * term
    measure = sums[0]
    middle = [part / measure for part in sums[1:4]]
    for (x, y, z), w in samples:
        a, b, c = x - middle[0], y - middle[1], z - middle[2]
        for k, term in enumerate((a * a, b * b, c * c, a * b, b * c, c * a)):
            sums[4 + k] += w * term
    xx, yy, zz, xy, yz, zx = (part / measure for part in sums[4:])
    return {"measure": measure, "centroid": middle, "second": (xx, yy, zz, xy, yz, zx)}


def _circle(radius: Any, first: Any = 0, share: Any = 1) -> Callable[[Any], tuple[Any, Any]]:
    return lambda t: (radius * cos(2 * pi * (first + share * t)), radius * sin(2 * pi * (first + share * t)))


def arc(radius: Any, first: Any, share: Any, letter: str = "a") -> list[Patch]:
    at = _circle(radius, first, share)
    return [(letter, lambda t: ((*at(t), mpf(0)), 2 * pi * share * radius), 1)]


def sector(radius: Any, first: Any, share: Any, letter: str = "a", inner: Any = 0, b: Any = None) -> list[Patch]:
    """A ring sector in the plane; `b` is the other semi-axis of an ellipse."""
    scale = mpf(1) if b is None else b / radius

    def place(u: Any, t: Any) -> tuple[Point, Any]:
        r = inner + (radius - inner) * u
        x, y = _circle(r, first, share)(t)
        return (x, scale * y, mpf(0)), (radius - inner) * r * 2 * pi * share * scale

    return [("p" + letter, place, 1)]


def extruded(flat: list[Patch], height: Any) -> list[Patch]:
    """A prism on a plane shape, its middle at z = 0."""

    def lift(place: Callable[..., tuple[Point, Any]]) -> Callable[..., tuple[Point, Any]]:
        def lifted(*at: Any) -> tuple[Point, Any]:
            (x, y, _), element = place(*at[:-1])
            return (x, y, height * (at[-1] - mpf(1) / 2)), element * height

        return lifted

    return [(letters + "p", lift(place), sign) for letters, place, sign in flat]


def triangle(a: Point, b: Point, c: Point, sign: int = 1) -> Patch:
    """A plane triangle by the map that shrinks a square to it."""
    e, f = [q - p for p, q in zip(a, b, strict=True)], [q - p for p, q in zip(b, c, strict=True)]
    cross = (e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0])
    size = sqrt(sum(part * part for part in cross))

    def place(u: Any, v: Any) -> tuple[Point, Any]:
        return tuple(p + u * (q + v * r) for p, q, r in zip(a, e, f, strict=True)), size * u  # type: ignore[return-value]

    return ("pp", place, sign)


def polygon(corners: list[tuple[Any, Any]]) -> list[Patch]:
    """Signed triangles from the origin of coordinates."""
    made = []
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True):
        twice = ax * by - ay * bx
        if twice:
            zero = mpf(0)
            made.append(triangle((zero, zero, zero), (ax, ay, zero), (bx, by, zero), 1 if twice > 0 else -1))
    total = sum(ax * by - ay * bx for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True))
    return [(letters, place, sign if total > 0 else -sign) for letters, place, sign in made]


def block(a: Any, b: Any, c: Any, sign: int = 1) -> Patch:
    half = mpf(1) / 2
    return ("ppp", lambda u, v, w: ((a * (u - half), b * (v - half), c * (w - half)), a * b * c), sign)


def revolved(radius_at: Callable[[Any], Any], low: Any, high: Any, sign: int = 1, power: int = 1) -> Patch:
    """A solid of revolution about z: z runs as low + (high − low) s^power, the section is a disk of radius_at(s)."""

    def place(s: Any, v: Any, t: Any) -> tuple[Point, Any]:
        z = low + (high - low) * s**power
        r = radius_at(s) * v
        x, y = _circle(r)(t)
        return (x, y, z), (high - low) * power * s ** (power - 1) * radius_at(s) * r * 2 * pi

    return ("ppo", place, sign)


def ball(a: Any, b: Any, c: Any, low: Any = -1, sign: int = 1, middle: Any = 0, high: Any = 1) -> Patch:
    """An ellipsoid, or the part of it with z/c between `low` and `high`."""

    def place(s: Any, v: Any, t: Any) -> tuple[Point, Any]:
        h = low + (high - low) * s
        r = sqrt(1 - h * h)
        x, y = _circle(r * v)(t)
        return (a * x, b * y, middle + c * h), (high - low) * c * a * b * r * r * v * 2 * pi

    return ("ppo", place, sign)


def sphere_skin(radius: Any, low: Any = -1) -> Patch:
    """A zone of a sphere, by Archimedes of even area in z."""

    def place(s: Any, t: Any) -> tuple[Point, Any]:
        h = low + (1 - low) * s
        x, y = _circle(radius * sqrt(1 - h * h))(t)
        return (x, y, radius * h), (1 - low) * radius * radius * 2 * pi

    return ("po", place, 1)


def cone_skin(a: Any, b: Any, low: Any, high: Any, first: Any = 0, share: Any = 1, letter: str = "o") -> Patch:
    slant = sqrt((a - b) ** 2 + (high - low) ** 2)

    def place(s: Any, t: Any) -> tuple[Point, Any]:
        r = a + (b - a) * s
        x, y = _circle(r, first, share)(t)
        return (x, y, low + (high - low) * s), slant * r * 2 * pi * share

    return ("p" + letter, place, 1)


def disk_at(radius: Any, z: Any) -> Patch:
    def place(v: Any, t: Any) -> tuple[Point, Any]:
        x, y = _circle(radius * v)(t)
        return (x, y, z), radius * radius * v * 2 * pi

    return ("po", place, 1)


def ring(major: Any, outer: Any, inner: Any) -> Patch:
    def place(v: Any, s: Any, t: Any) -> tuple[Point, Any]:
        r = inner + (outer - inner) * v
        across, z = _circle(r)(s)
        x, y = _circle(major + across)(t)
        return (x, y, z), (outer - inner) * r * 2 * pi * (major + across) * 2 * pi

    return ("poo", place, 1)


def ring_skin(major: Any, minor: Any) -> Patch:
    def place(s: Any, t: Any) -> tuple[Point, Any]:
        across, z = _circle(minor)(s)
        x, y = _circle(major + across)(t)
        return (x, y, z), minor * 2 * pi * (major + across) * 2 * pi

    return ("oo", place, 1)


def pyramid(a: Any, b: Any, h: Any) -> Patch:
    half = mpf(1) / 2

    def place(u: Any, v: Any, s: Any) -> tuple[Point, Any]:
        k = 1 - s
        return (a * k * (u - half), b * k * (v - half), h * s), a * b * k * k * h

    return ("ppp", place, 1)


def tetrahedron(p: list[Point]) -> Patch:
    a, e, f, g = p[0], *([p[i + 1][k] - p[i][k] for k in range(3)] for i in range(3))
    volume = abs(
        e[0] * (f[1] * g[2] - f[2] * g[1]) + e[1] * (f[2] * g[0] - f[0] * g[2]) + e[2] * (f[0] * g[1] - f[1] * g[0])
    )

    def place(u: Any, v: Any, w: Any) -> tuple[Point, Any]:
        return tuple(a[k] + u * (e[k] + v * (f[k] + w * g[k])) for k in range(3)), volume * u * u * v  # type: ignore[return-value]

    return ("ppp", place, 1)


def skin_of_box(a: Any, b: Any, c: Any) -> list[Patch]:
    half = mpf(1) / 2
    made: list[Patch] = []
    for k, (p, q, r) in enumerate(((b, c, a), (c, a, b), (a, b, c))):
        for side in (-half, half):

            def place(u: Any, v: Any, k: int = k, p: Any = p, q: Any = q, r: Any = r, side: Any = side) -> Any:
                at = [mpf(0)] * 3
                at[k], at[(k + 1) % 3], at[(k + 2) % 3] = r * side, p * (u - half), q * (v - half)
                return tuple(at), p * q

            made.append(("pp", place, 1))
    return made


QUARTER = mpf(1) / 4


def patches(shape: str, s: dict[str, Any]) -> list[Patch]:
    """The patches of a shape by its name and sizes (exact numbers)."""
    return _SHAPES[shape](s)


def _corners(s: dict[str, Any]) -> list[tuple[Any, Any]]:
    return [(vertex["x"], vertex["y"]) for vertex in s["vertices"]]


def _regular(s: dict[str, Any]) -> list[tuple[Any, Any]]:
    n = int(s["sides"])
    return [(s["radius"] * cos(2 * pi * k / n), s["radius"] * sin(2 * pi * k / n)) for k in range(n)]


def _cylinder(r: Any, length: Any, sign: int = 1) -> Patch:
    return revolved(lambda _: r, -length / 2, length / 2, sign)


def _frustum(a: Any, b: Any, h: Any, sign: int = 1) -> Patch:
    return revolved(lambda s: a + (b - a) * s, mpf(0), h, sign)


_ENDS = {"open": (), "one": (-1,), "both": (-1, 1)}
_SHAPES: dict[str, Callable[[dict[str, Any]], list[Patch]]] = {
    "rod": lambda s: [("p", lambda u: ((s["length"] * (u - mpf(1) / 2), mpf(0), mpf(0)), s["length"]), 1)],
    "ring-rod": lambda s: arc(s["radius"], 0, 1, "o"),
    "arc-rod": lambda s: arc(s["radius"], -s["angle"] / (4 * pi), s["angle"] / (2 * pi)),
    "semicircle-rod": lambda s: arc(s["radius"], -QUARTER, 2 * QUARTER),
    "quarter-circle-rod": lambda s: arc(s["radius"], 0, QUARTER),
    "triangle": lambda s: polygon([(mpf(0), mpf(0)), (s["base"], mpf(0)), (s["offset"], s["height"])]),
    "rectangle": lambda s: [
        (
            "pp",
            lambda u, v: (
                (s["width"] * (u - mpf(1) / 2), s["height"] * (v - mpf(1) / 2), mpf(0)),
                s["width"] * s["height"],
            ),
            1,
        )
    ],
    "polygon": lambda s: polygon(_corners(s)),
    "disk": lambda s: sector(s["radius"], 0, 1, "o"),
    "half-disk": lambda s: sector(s["radius"], -QUARTER, 2 * QUARTER),
    "quarter-disk": lambda s: sector(s["radius"], 0, QUARTER),
    "sector": lambda s: sector(s["radius"], -s["angle"] / (4 * pi), s["angle"] / (2 * pi)),
    "ellipse": lambda s: sector(s["x_radius"], 0, 1, "o", b=s["y_radius"]),
    "annulus": lambda s: sector(s["radius"], 0, 1, "o", inner=s["radius"] - s["thickness"]),
    "cylindrical-shell": lambda s: [
        cone_skin(s["radius"], s["radius"], -s["length"] / 2, s["length"] / 2),
        *(disk_at(s["radius"], side * s["length"] / 2) for side in _ENDS[s["ends"]]),
    ],
    "half-cylindrical-shell": lambda s: [
        cone_skin(s["radius"], s["radius"], -s["length"] / 2, s["length"] / 2, -QUARTER, 2 * QUARTER, "a")
    ],
    "conical-shell": lambda s: [
        cone_skin(s["radius"], mpf(0), mpf(0), s["height"]),
        *([disk_at(s["radius"], mpf(0))] if s["closed"] else []),
    ],
    "frustum-shell": lambda s: [cone_skin(s["base_radius"], s["top_radius"], mpf(0), s["height"])],
    "spherical-shell": lambda s: [sphere_skin(s["radius"])],
    "hemispherical-shell": lambda s: [
        sphere_skin(s["radius"], mpf(0)),
        *([disk_at(s["radius"], mpf(0))] if s["closed"] else []),
    ],
    "box-shell": lambda s: skin_of_box(s["width"], s["depth"], s["height"]),
    "torus-shell": lambda s: [ring_skin(s["ring_radius"], s["radius"])],
    "sphere": lambda s: [ball(s["radius"], s["radius"], s["radius"])],
    "hemisphere": lambda s: [ball(s["radius"], s["radius"], s["radius"], mpf(0))],
    "cylinder": lambda s: [_cylinder(s["radius"], s["length"])],
    "half-cylinder": lambda s: extruded(sector(s["radius"], -QUARTER, 2 * QUARTER), s["length"]),
    "quarter-cylinder": lambda s: extruded(sector(s["radius"], 0, QUARTER), s["length"]),
    "elliptic-cylinder": lambda s: extruded(sector(s["x_radius"], 0, 1, "o", b=s["y_radius"]), s["length"]),
    "cone": lambda s: [_frustum(s["radius"], mpf(0), s["height"])],
    "frustum": lambda s: [_frustum(s["base_radius"], s["top_radius"], s["height"])],
    "paraboloid": lambda s: [revolved(lambda u: s["radius"] * u, mpf(0), s["height"], power=2)],
    "capsule": lambda s: [
        _cylinder(s["radius"], s["length"]),
        ball(s["radius"], s["radius"], s["radius"], mpf(0), middle=s["length"] / 2),
        ball(s["radius"], s["radius"], s["radius"], mpf(-1), middle=-s["length"] / 2, high=mpf(0)),
    ],
    "ellipsoid": lambda s: [ball(s["x_radius"], s["y_radius"], s["z_radius"])],
    "half-ellipsoid": lambda s: [ball(s["x_radius"], s["y_radius"], s["z_radius"], mpf(0))],
    "torus": lambda s: [ring(s["ring_radius"], s["radius"], mpf(0))],
    "block": lambda s: [block(s["width"], s["depth"], s["height"])],
    "wedge": lambda s: extruded(polygon([(mpf(0), mpf(0)), (s["width"], mpf(0)), (mpf(0), s["height"])]), s["length"]),
    "prism": lambda s: extruded(polygon(_corners(s)), s["height"]),
    "regular-prism": lambda s: extruded(polygon(_regular(s)), s["height"]),
    "pyramid": lambda s: [pyramid(s["width"], s["depth"], s["height"])],
    "tetrahedron": lambda s: [tetrahedron([tuple(s[k]) for k in ("first", "second", "third", "fourth")])],
    "hollow-sphere": lambda s: [_ball(s["radius"]), _ball(s["radius"] - s["thickness"], sign=-1)],
    "hollow-hemisphere": lambda s: [_ball(s["radius"], 0), _ball(s["radius"] - s["thickness"], 0, -1)],
    "hollow-cylinder": lambda s: [
        _cylinder(s["radius"], s["length"]),
        _cylinder(s["radius"] - s["thickness"], s["length"], -1),
    ],
    "closed-cylinder": lambda s: [
        _cylinder(s["radius"], s["length"]),
        _cylinder(s["radius"] - s["thickness"], s["length"] - 2 * s["thickness"], -1),
    ],
    "hollow-frustum": lambda s: [
        _frustum(s["base_radius"], s["top_radius"], s["height"]),
        _frustum(s["base_radius"] - s["thickness"], s["top_radius"] - s["thickness"], s["height"], -1),
    ],
    "hollow-block": lambda s: [
        block(s["width"], s["depth"], s["height"]),
        block(*(s[k] - 2 * s["thickness"] for k in ("width", "depth", "height")), -1),
    ],
    "rectangular-tube": lambda s: [
        block(s["width"], s["depth"], s["length"]),
        block(s["width"] - 2 * s["thickness"], s["depth"] - 2 * s["thickness"], s["length"], -1),
    ],
    "hollow-torus": lambda s: [ring(s["ring_radius"], s["radius"], s["radius"] - s["thickness"])],
}


def _ball(radius: Any, low: Any = -1, sign: int = 1) -> Patch:
    return ball(radius, radius, radius, mpf(low), sign)


NAMES = tuple(_SHAPES)
