"""Proof of how far arcs, lines and cubics are from the exact curve, both ways, by pairing their parameters on cells.

Between two nodes of the curve's parameter, a distance w apart, let the piece's own parameter run evenly from its value
at one to its value at the other. Then the error e, curve less piece, has |e| ≤ max(|e₀|, |e₁|) + w²/8 (max|z″| +
max|b″| (Δt/w)²). At the first node the piece's parameter is its start and at the last its end, so that curve and piece
are covered by the pairing from end to end: the bound holds from curve to file and from file to curve.

Which parameter a node is paired with is free (the nearest point is found, and held between the ends), so nothing is
inferred from samples. max|z″| comes from `Path.acceleration`, the nodes from `Path.points`, both in disc arithmetic
with every rounding inside; |b″| of a cubic is that of its control points, of an arc its curvature.
"""

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.numerics.discs import UP, Disc
from dynamics_cli.numerics.fitting.pieces import bezier
from dynamics_cli.quantities import Angle, Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.fitting.path import Path

SHARE = 0.02
"""What the second-order term of a cell may add to the tolerance."""
MOST_CELLS = 4_000_000
BLOCK = 16_384
FINER = 4
COARSE = 12
DEEPEST = 4
# Twice the rounding error of a point of a cubic (sixteen roundings of convex sums), of the arc length of a projection,
# and to coordinates on their way into a file's unit, by the largest coordinate.
ROUNDING = 2.0**-46
# joints between zones are doubles; the exact joint is within this share of a radian or of the angle
SLIVER = 2.0**-48


def proved(path: "Path", piece: int, places: "Any", shape: "Any", form: str, points: "Any", tolerance: float) -> "Any":
    """Bounds of the distance between the curve and each of its pieces, both ways.

    `path`: the curve; `piece`: which smooth piece of the curve; `places`: parameters of the ends; `shape`: bulges
    (n,), or the inner control points (n, 2, 2) of cubics; `form`: "arcs", "cubics" or "lines"; `points`: the ends as
    they are written; `tolerance`: decides how fine the cells are [m]. Returns a bound for each [m]. Raises
    InadmissibleError when it would take more than four million cells, or nothing is known of the curve's acceleration.

    See the module. The ends are those written: that they are on the curve is not assumed.

    References
    ----------
    Derived: the error of linear interpolation between nodes, w²/8·max|e″|.
    """
    coarse = _coarse(path, piece, places)
    size = float(np.abs(points).max() if form != "cubics" else max(np.abs(points).max(), np.abs(shape).max()))
    bounds = np.full(places.size - 1, np.inf)
    remaining = np.arange(bounds.size)
    finer = 1.0
    for _ in range(FINER):
        owner, low, high, bend, _ = coarse
        cells = np.ceil(finer * (high - low) * np.sqrt(bend / (4.0 * SHARE * tolerance))).clip(1.0)
        counts = np.zeros(bounds.size)
        np.add.at(counts, owner, cells)
        require(
            float(counts[remaining].sum()) <= MOST_CELLS,
            "a tolerance of {tolerance} is too fine to be proved for this curve",
            tolerance=(tolerance, Size),
            code="too-fine",
            hint="allow a wider tolerance",
        )
        group = np.floor_divide(np.cumsum(counts[remaining]), BLOCK)
        for index in sorted(set(group.tolist())):
            chosen = remaining[group == index]
            block_bounds = _block(path, piece, places, shape, form, points, coarse, cells, chosen)
            bounds[chosen] = np.minimum(bounds[chosen], block_bounds + ROUNDING * size)
        remaining = remaining[bounds[remaining] > tolerance]
        if not remaining.size:
            break
        finer *= 3.0
    return bounds


def _coarse(path: "Path", piece: int, places: "Any") -> "tuple[Any, ...]":
    """Coarse cells in order: the piece each belongs to, its ends, and bounds of |z″| and |z′| on it."""
    count = places.size - 1
    fractions = np.arange(COARSE) / COARSE
    low = (places[:-1, None] + np.diff(places)[:, None] * fractions).ravel()
    owner = np.repeat(np.arange(count), COARSE)
    for level in range(DEEPEST + 1):
        high = np.append(low[1:], places[-1])
        half = 0.5 * (high - low) * (1.0 + 1e-12) + SLIVER * np.maximum(np.abs(low), 1.0)
        bend, fast = path.acceleration(0.5 * (low + high), half, piece)
        bad = ~(np.isfinite(bend) & np.isfinite(fast))
        if not bad.any() or level == DEEPEST:
            break
        # nothing is known of wide cells where the curve nearly stops: they are cut in eight
        parts = np.where(bad, 8, 1)
        owner = np.repeat(owner, parts)
        number = np.arange(owner.size) - np.repeat(np.cumsum(parts) - parts, parts)
        low = np.repeat(low, parts) + np.repeat((high - low) / parts, parts) * number
    require(
        not bad.any(),
        f"the curve bends too sharply at a {path.parameter} of {{place:6}} for a deviation to be proved",
        place=(low[int(np.argmax(bad))], Angle),
        code="not-proved",
        hint=path.sharp,
    )
    return owner, low, high, bend, fast


def _block(
    path: "Path", piece: int, places: "Any", shape: "Any", form: str, points: "Any",
    coarse: "tuple[Any, ...]", cells: "Any", chosen: "Any",
) -> "Any":  # fmt: skip
    """Bounds for the chosen pieces, neighbours in order."""
    selected = np.zeros(places.size - 1, dtype=bool)
    selected[chosen] = True
    in_block = selected[coarse[0]]
    coarse_owner, low, high, bend, fast = (part[in_block] for part in coarse)
    count = cells[in_block].astype(int)
    cell = np.repeat(np.arange(count.size), count)
    number = np.arange(cell.size) - np.repeat(np.cumsum(count) - count, count)
    theta = low[cell] + (high - low)[cell] * (number / count[cell])
    owner = np.searchsorted(chosen, coarse_owner)[cell]
    first = np.append(True, owner[1:] != owner[:-1])
    last = np.append(first[1:], True)
    ends = np.concatenate((points[:-1], points[1:]), axis=1)[chosen]
    # the nodes are the starts of the cells and, after them, the ends of the pieces
    nodes = np.concatenate((theta, places[1:][chosen]))
    x, y = path.points(nodes, piece)
    if form == "cubics":
        near, place, bent = _on_cubics(ends, shape[chosen], owner, last, (x, y))
    else:
        near, place, bent = _on_arcs(ends, shape[chosen], owner, (x, y))
    final = theta.size + np.arange(chosen.size)
    for index, column, which in ((np.flatnonzero(first), 0, 0), (final, 2, 1)):
        near[index] = _apart(x[index] - ends[:, column], y[index] - ends[:, column + 1])
        place[index] = bent[which]
    after = np.where(last, final[owner], np.arange(1, theta.size + 1))
    width = (nodes[after] - theta) * UP
    steps = np.abs(place[after] - place[: theta.size]) * UP + bent[3]
    second = (width * width * bend[cell] + bent[2][owner] * steps * steps) * (0.125 * UP)
    errors = np.maximum(near[: theta.size], near[after]) + second + SLIVER * (1.0 + np.abs(theta)) * fast[cell]
    bounds = np.zeros(chosen.size)
    np.maximum.at(bounds, owner, np.where(np.isfinite(errors), errors, np.inf))
    return bounds * UP


def _apart(x: Disc, y: Disc) -> "Any":
    """Largest length of a vector."""
    return np.hypot(x.size, y.size) * (1.0 + 2.0**-49)


def _on_arcs(ends: "Any", bulges: "Any", owner: "Any", at: "tuple[Disc, Disc]") -> "tuple[Any, Any, tuple[Any, ...]]":
    """Distances of nodes from their arcs, arc lengths of the nearest points, and the data of the arcs.

    With the chord on the x axis, a half of it, G = ½κ((x − a)(x + a) + y²) − y cos(½ sweep) has distance from the
    circle 2G/(1 + √(1 + 2κG)), without cancellation down to straight pieces; the nearest point is at the angle
    arctan2(κx, cos(½ sweep) − κy) from the middle of the arc.
    """
    x0, y0, x1, y1 = (Disc(column) for column in ends.T)
    bulge = Disc(bulges)
    cx, cy = x1 - x0, y1 - y0
    chord = (cx.square() + cy.square()).root()
    ux, uy, a = cx / chord, cy / chord, 0.5 * chord
    below = (bulge.square() + 1.0).inverse()
    kappa, cosine = 2.0 * bulge * below / a, (1.0 - bulge.square()) * below
    x, y = at
    # the ends of the pieces come after their cells
    owners = np.concatenate((owner, np.arange(bulges.size)))
    rx, ry = x - (0.5 * (x0 + x1))[owners], y - (0.5 * (y0 + y1))[owners]
    ux, uy, a_, kappa_, cosine_ = ux[owners], uy[owners], a[owners], kappa[owners], cosine[owners]
    along, across = rx * ux + ry * uy, ry * ux - rx * uy
    g = 0.5 * kappa_ * ((along - a_) * (along + a_) + across.square()) - across * cosine_
    away = 2.0 * g / ((1.0 + 2.0 * kappa_ * g).root() + 1.0)
    bent = np.abs(kappa.centre)
    half = 2.0 * np.arctan(np.abs(bulges)) / np.where(bent > 0.0, bent, 1.0)
    half = np.where(bent > 0.0, half, a.centre)
    angle = np.arctan2(kappa_.centre * along.centre, cosine_.centre - kappa_.centre * across.centre)
    straight = kappa_.centre == 0.0
    place = np.where(straight, along.centre, angle / np.where(straight, 1.0, kappa_.centre))
    inside = np.abs(place) <= half[owners]
    before = _apart(x - x0[owners], y - y0[owners])
    behind = _apart(x - x1[owners], y - y1[owners])
    near = np.where(inside, away.size, np.where(place > 0.0, behind, before))
    rounding = ROUNDING * float(np.abs(ends).max())
    return near, np.clip(place, -half[owners], half[owners]), (-half, half, kappa.size, rounding)


def _on_cubics(
    ends: "Any", inner: "Any", owner: "Any", last: "Any", at: "tuple[Disc, Disc]"
) -> "tuple[Any, Any, tuple[Any, ...]]":
    """Distances of nodes from points of their cubics, the parameters of these, and the data of the cubics."""
    x, y = at
    owners = np.concatenate((owner, np.arange(ends.shape[0])))
    px = np.stack((ends[:, 0], inner[:, 0, 0], inner[:, 1, 0], ends[:, 2]))
    py = np.stack((ends[:, 1], inner[:, 0, 1], inner[:, 1, 1], ends[:, 3]))
    count = np.bincount(owner, minlength=ends.shape[0])
    number = np.arange(owner.size) - np.repeat(np.cumsum(count) - count, count)
    t = np.concatenate((number / count[owner], np.ones(count.size)))
    px_, py_ = px[:, owners], py[:, owners]
    for _ in range(ROUNDS):
        bx, dx, _ = bezier(px_[0], px_[1], px_[2], px_[3], t)
        by, dy, _ = bezier(py_[0], py_[1], py_[2], py_[3], t)
        ex, ey = x.centre - bx, y.centre - by
        t = np.clip(t + (ex * dx + ey * dy) / (dx * dx + dy * dy), 0.0, 1.0)
    bx, by = bezier(px_[0], px_[1], px_[2], px_[3], t)[0], bezier(py_[0], py_[1], py_[2], py_[3], t)[0]
    near = _apart(x - bx, y - by)
    # the second derivative of a cubic is linear: the largest is at an end
    turn = 6.0 * np.maximum(
        np.hypot(px[2] - 2.0 * px[1] + px[0], py[2] - 2.0 * py[1] + py[0]),
        np.hypot(px[3] - 2.0 * px[2] + px[1], py[3] - 2.0 * py[2] + py[1]),
    )
    turn = turn * UP + ROUNDING * np.maximum(np.abs(px).max(axis=0), np.abs(py).max(axis=0))
    return near, t, (0.0, 1.0, turn, 0.0)


# from an even spread of parameters
ROUNDS = 4
