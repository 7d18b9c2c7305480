"""The body and its supports as a free-body diagram shows them: an outline, triangles, rollers, hatching, ropes."""

import math

from dynamics_cli.force import ratios
from dynamics_cli.force.supports import ExactSupport
from dynamics_cli.pictures import Curve

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Plane = tuple[float, float]

GREY = 6
DOWN = (0.0, -1.0)
HATCHES = 5


def body(points: "Sequence[Plane]") -> "list[Curve]":
    """The convex hull of the points where something acts, or their line."""
    hull = _hull(points)
    closed = [*hull, hull[0]]
    x, y = [p[0] for p in closed], [p[1] for p in closed]
    if len(hull) < 3:
        return [Curve(x, y, "", "thick", GREY)]
    return [Curve(x, y, "", "fill", GREY), Curve(x, y, "", "outline", GREY)]


def symbols(supports: "Sequence[Any]", points: "Sequence[Plane]", size: float) -> "list[Curve]":
    """Symbols of the supports in the plane, of a given size."""
    middle = tuple(sum(p[i] for p in points) / len(points) for i in range(2))
    curves: list[Curve] = []
    for index, given in enumerate(supports):
        support = ExactSupport(given, index, planar=True)
        at = ratios.rounded(support.at)[:2]
        line = None if support.direction is None else ratios.rounded(support.direction)[:2]
        out = _unit(line) if line and any(line) else None
        if support.type in ("cable", "link"):
            curves += _line(at, out or DOWN, 3.0 * size, dashed=support.type == "cable")
        elif support.type == "fixed":
            dx, dy = at[0] - middle[0], at[1] - middle[1]
            away = (math.copysign(1.0, dx), 0.0) if abs(dx) >= abs(dy) else (0.0, math.copysign(1.0, dy))
            curves += _wall(at, away, 2.0 * size)
        elif support.type == "guide":
            n = out or (0.0, 1.0)
            for sign in (-1.0, 1.0):
                curves += _wall(_moved(at, n, 0.3 * sign * size), (sign * n[0], sign * n[1]), 2.0 * size)
        else:
            back = DOWN if out is None or support.type == "pin" else (-out[0], -out[1])
            curves += _foot(at, back, size, rolls=support.type != "pin")
    return curves


def _hull(points: "Sequence[Plane]") -> "list[Plane]":
    """The convex hull by Andrew's monotone chain."""
    in_order = sorted(set(points))
    chains: list[list[Plane]] = []
    for row in (in_order, in_order[::-1]):
        chain: list[Plane] = []
        for p in row:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], p) <= 0.0:
                chain.pop()
            chain.append(p)
        chains.append(chain[:-1])
    return [*chains[0], *chains[1]] or in_order


def _turn(a: "Plane", b: "Plane", c: "Plane") -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _unit(vector: "Sequence[float]") -> "Plane":
    size = math.hypot(vector[0], vector[1])
    return vector[0] / size, vector[1] / size


def _moved(at: "Sequence[float]", unit: "Plane", by: float) -> "Plane":
    return at[0] + by * unit[0], at[1] + by * unit[1]


def _line(at: "Sequence[float]", unit: "Plane", length: float, *, dashed: bool) -> "list[Curve]":
    x, y = _moved(at, unit, length)
    line = Curve([at[0], x], [at[1], y], "", "dashed" if dashed else "solid", GREY)
    return [line, *_wall((x, y), unit, 0.5 * length)]


def _wall(at: "Plane", away: "Plane", width: float) -> "list[Curve]":
    """A line across `away` with hatching behind it."""
    along = (-away[1], away[0])
    ends = [_moved(at, along, side * width / 2.0) for side in (-1.0, 1.0)]
    curves = [Curve([p[0] for p in ends], [p[1] for p in ends], "", "solid", GREY)]
    for k in range(HATCHES):
        start = _moved(at, along, width * ((k + 1) / HATCHES - 0.5))
        end = _moved(_moved(start, along, -0.2 * width), away, 0.2 * width)
        curves.append(Curve([start[0], end[0]], [start[1], end[1]], "", "thin", GREY))
    return curves


def _foot(at: "Sequence[float]", back: "Plane", size: float, *, rolls: bool) -> "list[Curve]":
    """A triangle from the point to the ground; with a gap for a roller."""
    along = (-back[1], back[0])
    base = _moved(at, back, size)
    corners = [(at[0], at[1]), _moved(base, along, 0.6 * size), _moved(base, along, -0.6 * size), (at[0], at[1])]
    triangle = Curve([p[0] for p in corners], [p[1] for p in corners], "", "outline", GREY)
    return [triangle, *_wall(_moved(base, back, 0.25 * size if rolls else 0.0), back, 1.8 * size)]
