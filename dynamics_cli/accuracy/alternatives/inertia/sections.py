"""Plane sections by sums in doubles about the origin of the drawing, as textbooks have them."""

from math import atan2, cos, hypot, pi, sin, sqrt

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.section.contours import Hole, Piece

    Contour = tuple[int, list[tuple[float, float]], float]


def _contours(polygon: "tuple[float, ...]", pieces: "tuple[Piece, ...]", holes: "tuple[Hole, ...]") -> "list[Contour]":
    """Sign, corners (or the centre) and diameter."""
    contours: list[Contour] = [(1, list(zip(polygon[0::2], polygon[1::2], strict=True)), 0.0)] if polygon else []
    for sign, items in ((1, pieces), (-1, holes)):
        for item in items:
            if item.polygon:
                contours.append((sign, list(zip(item.polygon[0::2], item.polygon[1::2], strict=True)), 0.0))
            elif item.diameter is not None:
                contours.append((sign, [(item.x, item.y)], item.diameter))
            else:
                a, b = 0.5 * (item.width or 0.0), 0.5 * (item.height or 0.0)
                ends = ((-a, -b), (a, -b), (a, b), (-a, b))
                contours.append((sign, [(item.x + x, item.y + y) for x, y in ends], 0.0))
    return contours


def _sums(contour: "Contour") -> "list[float]":
    """∫ of 1, x, y, y², x², xy: the shoelace formula and its like."""
    sign, points, diameter = contour
    if diameter:
        (x, y), area = points[0], pi * diameter**2 / 4.0
        own = pi * diameter**4 / 64.0
        sums = [area, area * x, area * y, own + area * y * y, own + area * x * x, area * x * y]
        return [sign * part for part in sums]
    sums = [0.0] * 6
    for (ax, ay), (bx, by) in zip(points, [*points[1:], points[0]], strict=True):
        cross = ax * by - bx * ay
        sums[0] += cross / 2.0
        sums[1] += cross * (ax + bx) / 6.0
        sums[2] += cross * (ay + by) / 6.0
        sums[3] += cross * (ay * ay + ay * by + by * by) / 12.0
        sums[4] += cross * (ax * ax + ax * bx + bx * bx) / 12.0
        sums[5] += cross * (ax * (2.0 * ay + by) + bx * (ay + 2.0 * by)) / 24.0
    way = sign if sums[0] > 0.0 else -sign
    return [way * part for part in sums]


def _answer(contours: "list[Contour]") -> "dict[str, float]":
    """Area, centroid, and moments about it by parallel axes, the principal ones by Mohr's circle."""
    parts = [_sums(contour) for contour in contours]
    area, mx, my, ix, iy, ixy = (sum(column) for column in zip(*parts, strict=True))
    x, y = mx / area, my / area
    ix, iy, ixy = ix - area * y * y, iy - area * x * x, ixy - area * x * y
    radius = sqrt(((ix - iy) / 2.0) ** 2 + ixy**2)
    one, two = (ix + iy) / 2.0 + radius, (ix + iy) / 2.0 - radius
    angle = 0.5 * atan2(-2.0 * ixy, ix - iy)
    about = ix + area * y * y, iy + area * x * x, ixy + area * x * y
    return {
        "area": area, "perimeter": _perimeter(contours), "x": x, "y": y, "centroidal.ix": ix, "centroidal.iy": iy,
        "centroidal.ixy": ixy, "centroidal.polar": ix + iy, "about_origin.ix": about[0], "about_origin.iy": about[1],
        "about_origin.ixy": about[2], "about_origin.polar": about[0] + about[1], "principal.i1": one,
        "principal.i2": two, "principal.angle": angle, "gyration.rx": sqrt(ix / area), "gyration.ry": sqrt(iy / area),
        "gyration.r1": sqrt(one / area), "gyration.r2": sqrt(two / area), "gyration.polar": sqrt((ix + iy) / area),
        "moduli.x_top": ix / _reach(contours, (x, y), (0.0, 1.0)),
        "moduli.x_bottom": ix / _reach(contours, (x, y), (0.0, -1.0)),
        "moduli.y_right": iy / _reach(contours, (x, y), (1.0, 0.0)),
        "moduli.y_left": iy / _reach(contours, (x, y), (-1.0, 0.0)),
        "moduli.first_least": one / _farthest(contours, (x, y), (-sin(angle), cos(angle))),
        "moduli.second_least": two / _farthest(contours, (x, y), (cos(angle), sin(angle))),
    }  # fmt: skip


def _perimeter(contours: "list[Contour]") -> float:
    """Lengths of all sides, holes too, and of circles."""
    return sum(
        pi * diameter if diameter else sum(hypot(c - a, d - b) for (a, b), (c, d) in _sides(corners))
        for _, corners, diameter in contours
    )


def _sides(corners: "list[tuple[float, float]]") -> "Any":
    return zip(corners, [*corners[1:], corners[0]], strict=True)


def _reach(contours: "list[Contour]", centre: "tuple[float, float]", way: "tuple[float, float]") -> float:
    """How far material reaches from the centroid along a direction."""
    return max(
        (x - centre[0]) * way[0] + (y - centre[1]) * way[1] + 0.5 * diameter
        for sign, corners, diameter in contours
        if sign > 0
        for x, y in corners
    )


def _farthest(contours: "list[Contour]", centre: "tuple[float, float]", way: "tuple[float, float]") -> float:
    """The same to whichever side it reaches farther."""
    return max(_reach(contours, centre, way), _reach(contours, centre, (-way[0], -way[1])))


def about_origin(
    *, polygon: "tuple[float, ...]" = (), pieces: "tuple[Piece, ...]" = (), holes: "tuple[Hole, ...]" = ()
) -> "dict[str, float]":
    """The textbook: sums about the origin of the drawing, parallel axes at the end."""
    return _answer(_contours(polygon, pieces, holes))
