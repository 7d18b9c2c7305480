"""Proof of how far arcs, lines and cubics are from the exact curve, both ways, by Taylor bounds on small cells.

On a cell of half width h about m a distance f keeps |f(m)| + |f′(m)| h + ½h² max|f″|, and max|f″| is enclosed by
interval arithmetic from enclosures of the lift and its derivatives; nothing is inferred from samples.
"""

import numpy as np

from dynamics_cli.cam.approximation import bezier, circle_distance, controls, foot
from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.path import Path

SHARE = 0.02
"""What the second-order term of a cell may add to the tolerance."""
MOST_CELLS = 4_000_000
BLOCK = 65_536
FINER = 4
COARSE = 64
# Rounding of coordinates and distances, and joints taken a hair inside their pieces, by the largest coordinate.
ROUNDING = 4096.0 * 2.0**-53


def proved(path: "Path", piece: int, places: "Any", shape: "Any", form: str, points: "Any", tolerance: float) -> "Any":
    """Bounds of the distance between the curve and each of its pieces, both ways.

    Parameters
    ----------
    path : Path
        The curve.
    piece : int
        Which smooth piece of the motion.
    places : array (n + 1,)
        Cam angles of the ends.
    shape : array
        Bulges (n,) or handles (n, 2).
    form : str
        "arcs", "cubics" or "lines".
    points : array (n + 1, 2)
        The ends as they are written.
    tolerance : float
        Decides how fine the cells are [m].

    Returns
    -------
    array (n,)
        A bound for each [m].

    Raises
    ------
    InadmissibleError
        When it would take more than four million cells.

    Notes
    -----
    The way back, from file to curve: along an arc the projection of the curve runs on without turning, from one end to
    the other, which is checked on every cell; on a cubic the parameters reached are checked for gaps.
    """
    width = np.diff(places)
    # one pass of coarse cells tells how steep the curve is
    shares = (np.arange(COARSE) + 0.5) / COARSE
    middle = places[:-1, None] + width[:, None] * shares
    half = np.repeat(0.5 * width / COARSE, COARSE)
    steep, _ = path.acceleration(middle.ravel(), half, np.full(middle.size, piece))
    steep = np.where(np.isfinite(steep), steep, 1e3).reshape(middle.shape).max(axis=1)
    cells = np.maximum(np.ceil(width * np.sqrt(2.0 * steep / (8.0 * SHARE * tolerance))), 4.0)
    bounds = np.full(width.size, np.inf)
    left = np.arange(width.size)
    for _ in range(FINER):
        require(
            float(cells[left].sum()) <= MOST_CELLS,
            "a tolerance of {0:.3g} m is too fine to be proved for this curve",
            tolerance,
            code="too-fine",
            hint="allow a wider tolerance",
        )
        for chosen in _blocks(left, cells):
            bounds[chosen] = np.minimum(bounds[chosen], _block(path, piece, places, shape, form, points, cells, chosen))
        left = left[bounds[left] > tolerance]
        if not left.size:
            break
        cells[left] *= 3.0
    return bounds


def _blocks(left: "Any", cells: "Any") -> "Any":
    """The pieces in groups of cells that stay in the cache."""
    group = np.floor_divide(np.cumsum(cells[left]), BLOCK)
    for index in sorted(set(group.tolist())):
        yield left[group == index]


def _block(
    path: "Path", piece: int, places: "Any", shape: "Any", form: str, points: "Any", all_cells: "Any", chosen: "Any"
) -> "Any":  # fmt: skip
    handles, shape = shape, shape[chosen]
    width, cells = np.diff(places)[chosen], all_cells[chosen].astype(int)
    ends = np.concatenate((points[:-1], points[1:]), axis=1)[chosen]
    owner = np.repeat(np.arange(cells.size), cells)
    index = np.arange(owner.size) - np.repeat(np.cumsum(cells) - cells, cells)
    step = (width / cells)[owner]
    theta = places[:-1][chosen][owner] + (index + 0.5) * step
    half = 0.5 * step * (1.0 + 1e-12) + 4e-16 * np.abs(theta)
    x, y, tx, ty, speed = path.at(theta)
    bend, fast = path.acceleration(theta, half, np.full(theta.size, piece))
    zx, zy = tx * speed, ty * speed
    size = ROUNDING * float(np.max(np.abs(points)) + np.max(np.hypot(x, y)))
    if form == "cubics":
        cx, cy = controls(path, places, handles, chosen)
        # the file's own ends: those of neighbouring pieces are the same doubles
        cx[:, 0], cy[:, 0], cx[:, 3], cy[:, 3] = ends.T
        found = _cubic_cells(cx, cy, owner, index, cells, (x, y, zx, zy), half, bend)
    else:
        found = _arc_cells(shape, ends, owner, (x, y, zx, zy), half, bend, fast)
    bounds = np.zeros(cells.size)
    np.maximum.at(bounds, owner, found)
    return bounds + size


def _arc_cells(
    bulges: "Any", ends: "Any", owner: "Any", at: "tuple[Any, ...]", half: "Any", bend: "Any", fast: "Any"
) -> "Any":
    x, y, zx, zy = at
    x0, y0, x1, y1 = ends[owner].T
    distance, gx, gy, kappa = circle_distance(x0, y0, x1, y1, bulges[owner], x, y)
    slope = np.abs(gx * zx + gy * zy)
    # curvature of the level lines of the distance, within the cell
    near = 1.0 / np.maximum(1.0 / np.maximum(np.abs(kappa), 1e-300) - np.abs(distance) - fast * half, 1e-300)
    second = bend + fast * fast * near
    # the projection onto the circle must run on: its speed, least a bound of its change
    ahead = np.abs(gx * zy - gy * zx) - second * half
    found = np.abs(distance) + slope * half + 0.5 * half * half * second
    return np.where(ahead > 0.0, found, np.inf)


def _cubic_cells(
    cx: "Any", cy: "Any", owner: "Any", index: "Any", cells: "Any",
    at: "tuple[Any, ...]", half: "Any", bend: "Any",
) -> "Any":  # fmt: skip
    x, y, zx, zy = at
    ox, oy = cx[owner], cy[owner]
    t, _ = foot(ox, oy, x, y, (index + 0.5) / cells[owner], rounds=6)
    bx, dx, _ = bezier(ox[:, 0], ox[:, 1], ox[:, 2], ox[:, 3], t)
    by, dy, _ = bezier(oy[:, 0], oy[:, 1], oy[:, 2], oy[:, 3], t)
    rate = (zx * dx + zy * dy) / (dx * dx + dy * dy)
    # second derivatives of a cubic are linear: the largest is at an end
    turn = np.maximum(
        np.hypot(cx[:, 2] - 2.0 * cx[:, 1] + cx[:, 0], cy[:, 2] - 2.0 * cy[:, 1] + cy[:, 0]),
        np.hypot(cx[:, 3] - 2.0 * cx[:, 2] + cx[:, 1], cy[:, 3] - 2.0 * cy[:, 2] + cy[:, 1]),
    )
    second = bend + 6.0 * turn[owner] * rate * rate
    found = np.hypot(x - bx, y - by) + np.hypot(zx - dx * rate, zy - dy * rate) * half + 0.5 * half * half * second
    # parameters reached: nothing beyond the ends, no gap between neighbours
    low, high = t - rate * half, t + rate * half
    fastest = 3.0 * np.maximum.reduce([np.hypot(np.diff(cx)[:, i], np.diff(cy)[:, i]) for i in range(3)])[owner]
    before = np.where(index == 0, 0.0, np.roll(high, 1))
    after = np.where(index == cells[owner] - 1, 1.0, np.roll(low, -1))
    outside = np.maximum(np.maximum(-low, high - 1.0), 0.0)
    gap = np.maximum(np.maximum(low - before, after - high), 0.0)
    return np.where(rate > 0.0, found + fastest * (outside + gap), np.inf)
