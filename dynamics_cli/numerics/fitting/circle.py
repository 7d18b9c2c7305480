"""The circle nearest to measured points of an arc, and how well they decide its radius."""

from math import fsum, hypot, sqrt

from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.vectors import eliminated

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Rows = list[list[float]]

MOST_STEPS = 60
CLOSE = 1e-15


class Circle:
    """A fitted circle: centre from the first point, radius, and quality of the fit.

    `factor` is the standard deviation of the radius over that of a point, `residual` the scatter of the points about
    the circle where more than three tell, `sagitta` the height of the arc over the chord of its ends.
    """

    __slots__ = ("deviations", "factor", "radius", "residual", "sagitta", "x", "y")

    def __init__(self, x: float, y: float, radius: float, deviations: "list[float]", factor: float) -> None:
        self.x = x
        self.y = y
        self.radius = radius
        self.deviations = deviations
        self.factor = factor
        free = len(deviations) - 3
        self.residual = sqrt(fsum(part * part for part in deviations) / free) if free > 0 else None
        self.sagitta = 0.0


def circle_through(x: "Sequence[float]", y: "Sequence[float]") -> "Circle | None":
    """The circle with the least sum of squared distances; None for points on a line, which have none.

    From the algebraic circle about the centroid by Gauss–Newton steps on the distances, which minimise Σ(|p − c| − R)²;
    points are scaled to one.
    """
    count = len(x)
    middle = fsum(x) / count, fsum(y) / count
    u, v = [a - middle[0] for a in x], [b - middle[1] for b in y]
    size = sqrt(fsum(a * a + b * b for a, b in zip(u, v, strict=True)) / count)
    if size == 0.0:
        return None
    u, v = [a / size for a in u], [b / size for b in v]
    start = _algebraic(u, v)
    if start is None:
        return None
    cx, cy, radius = start
    for _ in range(MOST_STEPS):
        rows = [_row(a - cx, b - cy) for a, b in zip(u, v, strict=True)]
        off = [hypot(a - cx, b - cy) - radius for a, b in zip(u, v, strict=True)]
        normal = [[fsum(row[i] * row[j] for row in rows) for j in range(3)] for i in range(3)]
        step = eliminated(normal, [-fsum(row[i] * part for row, part in zip(rows, off, strict=True)) for i in range(3)])
        if step is None:
            return None
        cx, cy, radius = cx + step[0], cy + step[1], radius + step[2]
        if max(map(abs, step)) <= CLOSE * (1.0 + radius):
            break
    inverse = eliminated(normal, [0.0, 0.0, 1.0])
    if inverse is None or not inverse[2] > 0.0 or not radius > 0.0:
        return None
    off = [hypot(a - cx, b - cy) - radius for a, b in zip(u, v, strict=True)]
    fitted = Circle(
        middle[0] + size * cx, middle[1] + size * cy, size * radius, [size * part for part in off], sqrt(inverse[2])
    )
    chord = hypot(x[-1] - x[0], y[-1] - y[0])
    fitted.sagitta = fitted.radius - sqrt(max(fitted.radius * fitted.radius - 0.25 * chord * chord, 0.0))
    return fitted


def settled_radius(x: "Sequence[Any]", y: "Sequence[Any]", circle: Circle) -> "Any":
    """The radius with the bounds and derivatives of the points: one full Newton step from the doubles of the fit."""
    from dynamics_cli.numerics.elementary import hypot as any_hypot

    gradient: list[Any] = [0.0, 0.0, 0.0]
    second = [[0.0] * 3 for _ in range(3)]
    for a, b in zip(x, y, strict=True):
        right, up = a - circle.x, b - circle.y
        away = any_hypot(right, up)
        off = away - circle.radius
        parts = (-right / away, -up / away)
        gradient = [
            gradient[0] + off * parts[0],
            gradient[1] + off * parts[1],
            gradient[2] - off,
        ]
        row = _row(plain(right), plain(up))
        bend = plain(off) / plain(away)
        for i in range(3):
            for j in range(3):
                second[i][j] += row[i] * row[j]
                if i < 2 and j < 2:
                    second[i][j] += bend * ((i == j) - row[i] * row[j])
    weights = eliminated(second, [0.0, 0.0, 1.0])
    assert weights is not None
    return circle.radius - (weights[0] * gradient[0] + weights[1] * gradient[1] + weights[2] * gradient[2])


def _row(right: float, up: float) -> "list[float]":
    """How a point's distance from the circle changes with the centre and the radius."""
    away = hypot(right, up)
    return [-right / away, -up / away, -1.0]


def _algebraic(u: "list[float]", v: "list[float]") -> "tuple[float, float, float] | None":
    """The circle u² + v² = 2au + 2bv + c nearest in those terms, of centred points."""
    squares = [a * a + b * b for a, b in zip(u, v, strict=True)]
    uu, vv = fsum(a * a for a in u), fsum(b * b for b in v)
    uv = fsum(a * b for a, b in zip(u, v, strict=True))
    det = uu * vv - uv * uv
    if not det > 1e-26 * uu * vv + 1e-300:
        return None
    first = 0.5 * fsum(a * s for a, s in zip(u, squares, strict=True))
    other = 0.5 * fsum(b * s for b, s in zip(v, squares, strict=True))
    cx, cy = (first * vv - other * uv) / det, (other * uu - first * uv) / det
    return cx, cy, sqrt(cx * cx + cy * cy + fsum(squares) / len(u))
