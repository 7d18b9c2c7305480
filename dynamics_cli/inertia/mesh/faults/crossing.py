"""Where a surface passes through itself, and where it lies within what it bounds: what closure alone does not see.

A closed surface bounds each point of a solid once: just outside a triangle the winding number is 0 and just inside it
is 1. On the triangle itself, its own share left out, it is the mean of both; a point that other triangles touch is not
judged.
"""

from math import pi

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    Array = np.ndarray[Any, np.dtype[Any]]

# Products of points and triangles that are formed at once, and in all.
_AT_ONCE, MOST = 200_000, 4_000_000
# Determinants below this share of their terms have no sign that rounding could not have made.
_ROUNDING = 1e-13
# A winding number is whole; one further from it than this is of a point on another triangle.
_NEAR = 0.05


def crossings(points: "Array", faces: "Array") -> "Array":
    """Triangles that an edge of another one passes through, which shares no corner with it."""
    corners = points[faces]
    low, high = corners.min(axis=1), corners.max(axis=1)
    found = [np.empty(0, dtype=int)]
    for one, other in _near_pairs(low, high):
        apart = ~(faces[one][:, :, None] == faces[other][:, None, :]).any(axis=(1, 2))
        one, other = one[apart], other[apart]
        for through, along in ((one, other), (other, one)):
            for k in range(3):
                p, q = corners[along, k], corners[along, k - 1]
                found.append(through[_pierced(p, q, corners[through])])
    return np.unique(np.concatenate(found))


def _near_pairs(low: "Array", high: "Array") -> "Iterator[tuple[Array, Array]]":
    """Pairs of boxes that meet, swept along the axis along which fewest do."""
    sweeps = []
    for axis in range(3):
        order = np.argsort(low[:, axis], kind="stable")
        ends = np.searchsorted(low[order, axis], high[order, axis], side="right")
        sweeps.append((int((ends - np.arange(len(order))).sum()), axis, order, ends))
    _, _, order, ends = min(sweeps, key=lambda sweep: sweep[:2])
    counts = ends - np.arange(len(order)) - 1
    total = np.concatenate(([0], np.cumsum(counts)))
    start = 0
    while start < len(order):
        stop = max(int(np.searchsorted(total, total[start] + _AT_ONCE, side="right")) - 1, start + 1)
        sizes = counts[start:stop]
        first = np.repeat(np.arange(start, stop), sizes)
        second = first + 1 + np.arange(len(first)) - np.repeat(total[start:stop] - total[start], sizes)
        one, other = order[first], order[second]
        meet = ((low[one] <= high[other]) & (low[other] <= high[one])).all(axis=1)
        yield one[meet], other[meet]
        start = stop


def _pierced(p: "Array", q: "Array", corners: "Array") -> "Array":
    """Whether the segment from p to q passes through the inside of a triangle, beyond rounding."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    across = _side(a, b, c, p) * _side(a, b, c, q) < 0
    turns = [_side(p, q, *ends) for ends in ((a, b), (b, c), (c, a))]
    through: Array = across & (turns[0] != 0) & (turns[0] == turns[1]) & (turns[1] == turns[2])
    return through


def _side(a: "Array", b: "Array", c: "Array", d: "Array") -> "Array":
    """Which side of the plane through a, b, c the point d is on; 0 where rounding may decide."""
    u, v, w = b - a, c - a, d - a
    terms = [u[:, i] * v[:, j] * w[:, k] for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1))]
    terms += [-u[:, i] * v[:, j] * w[:, k] for i, j, k in ((0, 2, 1), (1, 0, 2), (2, 1, 0))]
    value, size = sum(terms), sum(map(np.abs, terms))
    return np.where(np.abs(value) > _ROUNDING * size, np.sign(value), 0.0)


def windings(at: "Array", corners: "Array", without: "Array", label: "Array") -> "Array":
    """The winding number of triangles about points; for each point the triangles of one label are left out.

    Not a number where a point touches a triangle.
    """
    out = np.empty(len(at))
    step = max(1, _AT_ONCE // len(corners))
    for start in range(0, len(at), step):
        rows = slice(start, start + step)
        a, b, c = (corners[None, :, k] - at[rows, None] for k in range(3))
        x, y, z = (np.sqrt((part * part).sum(axis=2)) for part in (a, b, c))
        size = x * y * z
        up = (a * np.cross(b, c)).sum(axis=2)
        down = size + (a * b).sum(axis=2) * z + (b * c).sum(axis=2) * x + (c * a).sum(axis=2) * y
        left_out = without[rows, None] == label
        touched = (np.abs(up) <= _ROUNDING * size) & (down <= _ROUNDING * size) & ~left_out
        angles = np.where(left_out, 0.0, np.arctan2(up, down))
        out[rows] = np.where(touched.any(axis=1), np.nan, angles.sum(axis=1) / (2.0 * pi))
    return out


def misplaced(points: "Array", faces: "Array", piece: "Array") -> "tuple[Array, Array]":
    """Triangles within what other triangles bound, which counts twice, and triangles that bound from the wrong side.

    Of many triangles only some are looked at, evenly spread, as many as `MOST` products allow.
    """
    corners = points[faces]
    step = -(-(len(faces) ** 2) // MOST)
    chosen = np.arange(0, len(faces), step)
    about = windings(corners[chosen].mean(axis=1), corners, chosen, np.arange(len(faces))) - 0.5
    # corners of one piece against all other pieces: those of a piece that faces inwards lie within another one
    middle = corners - corners.mean(axis=(0, 1))
    volumes = np.bincount(piece, weights=(middle[:, 0] * np.cross(middle[:, 1], middle[:, 2])).sum(axis=1))
    beside = windings(corners[chosen, 0], corners, piece[chosen], piece) - (volumes[piece[chosen]] < 0.0)
    about, beside = (np.where(np.abs(x - np.round(x)) < _NEAR, np.round(x), 0.0) for x in (about, beside))
    about = np.where(about == 0.0, beside, about)
    return chosen[about > 0.0], chosen[about < 0.0]
