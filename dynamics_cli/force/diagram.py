"""The body and its supports as a free-body diagram shows them: an outline, triangles, rollers, hatching, ropes."""

import math

from dynamics_cli.force import ratios
from dynamics_cli.force.supports import Read
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
    """The hull of the points where something acts, or a line where they lie on one."""
    hull = _hull(points)
    closed = [*hull, hull[0]]
    x, y = [p[0] for p in closed], [p[1] for p in closed]
    if len(hull) < 3:
        return [Curve(x, y, "", "thick", GREY)]
    return [Curve(x, y, "", "fill", GREY), Curve(x, y, "", "outline", GREY)]


def symbols(supports: "Sequence[Any]", points: "Sequence[Plane]", size: float) -> "list[Curve]":
    """What holds the body in the plane, so large."""
    middle = tuple(sum(p[i] for p in points) / len(points) for i in range(2))
    drawn: list[Curve] = []
    for index, given in enumerate(supports):
        one = Read(given, index, planar=True)
        at = ratios.rounded(one.at)[:2]
        way = None if one.way is None else ratios.rounded(one.way)[:2]
        out = _unit(way) if way and any(way) else None
        if one.type in ("cable", "link"):
            drawn += _line(at, out or DOWN, 3.0 * size, dashed=one.type == "cable")
        elif one.type == "fixed":
            aside = (at[0] - middle[0], at[1] - middle[1])
            level = abs(aside[0]) >= abs(aside[1])
            away = (math.copysign(1.0, aside[0]), 0.0) if level else (0.0, math.copysign(1.0, aside[1]))
            drawn += _wall(at, away, 2.0 * size)
        elif one.type == "guide":
            n = out or (0.0, 1.0)
            for sign in (-1.0, 1.0):
                drawn += _wall(_moved(at, n, 0.3 * sign * size), (sign * n[0], sign * n[1]), 2.0 * size)
        else:
            back = DOWN if out is None or one.type == "pin" else (-out[0], -out[1])
            drawn += _foot(at, back, size, rolls=one.type != "pin")
    return drawn


def _hull(points: "Sequence[Plane]") -> "list[Plane]":
    """The convex hull by Andrew's monotone chain."""
    those = sorted(set(points))
    chains: list[list[Plane]] = []
    for row in (those, those[::-1]):
        chain: list[Plane] = []
        for p in row:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], p) <= 0.0:
                chain.pop()
            chain.append(p)
        chains.append(chain[:-1])
    return [*chains[0], *chains[1]] or those


def _turn(a: "Plane", b: "Plane", c: "Plane") -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _unit(way: "Sequence[float]") -> "Plane":
    size = math.hypot(way[0], way[1])
    return way[0] / size, way[1] / size


def _moved(at: "Sequence[float]", way: "Plane", by: float) -> "Plane":
    return at[0] + by * way[0], at[1] + by * way[1]


def _line(at: "Sequence[float]", way: "Plane", length: float, *, dashed: bool) -> "list[Curve]":
    x, y = _moved(at, way, length)
    line = Curve([at[0], x], [at[1], y], "", "dashed" if dashed else "solid", GREY)
    return [line, *_wall((x, y), way, 0.5 * length)]


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
    """A triangle from the point to the ground; a roller has a gap to it."""
    along = (-back[1], back[0])
    base = _moved(at, back, size)
    corners = [(at[0], at[1]), _moved(base, along, 0.6 * size), _moved(base, along, -0.6 * size), (at[0], at[1])]
    triangle = Curve([p[0] for p in corners], [p[1] for p in corners], "", "outline", GREY)
    return [triangle, *_wall(_moved(base, back, 0.25 * size if rolls else 0.0), back, 1.8 * size)]
