"""Arcs, cubics or lines along a path, as few as a tolerance allows, split at every joint of its smooth pieces.

Pieces touch the exact curve at their ends with its direction. A pair of arcs meets on the curve; a cubic also meets it
at two places inside, which leaves an error of sixth order. Places are distributed so that every piece has the same
error.
"""

from math import pi

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.quantities import Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.fitting.path import OnPiece, Path

ORDER = {"arcs": 3, "cubics": 6, "lines": 2}
# this a minimises the maximum of |(1 − x²)²(x² − a²)|
INSIDE = 0.5 * 0.3254077
FRACTIONS = np.array([0.5 - INSIDE, 0.5 + INSIDE])
SAMPLES = (np.arange(24) + 0.5) / 24.0
TURN = 0.5 * pi
MOST = 20_000
EVEN = 40


def angle_between(ax: "Any", ay: "Any", bx: "Any", by: "Any") -> "Any":
    """Angle from one vector to another, anticlockwise."""
    return np.arctan2(ax * by - ay * bx, ax * bx + ay * by)


def form_of(path: "Path", piece: int, form: str) -> str:
    """The form of a piece: lines at a cusp of the curve, where the curvature is unbounded."""
    return "lines" if piece in path.straight else form


def fit(path: "Path", form: str, tolerance: float) -> "list[tuple[int, Any, Any]]":
    """Places of the pieces' ends on every smooth piece of the curve, and the shape between them.

    `path`: the curve; `form`: "arcs", "cubics" or "lines"; `tolerance`: allowed deviation of a piece, as sampled; it is
    proved afterwards [m]. Returns for each smooth piece its index, the places (n + 1,) and the bulges (n,) or handles
    (n, 2). Raises InadmissibleError when it would take more than 20,000 pieces.
    """
    fits = []
    for index, (start, end) in enumerate(zip(path.starts, path.ends, strict=True)):
        if path.still[index] and form == "arcs":
            count = max(1, int(np.ceil((end - start) / pi - 1e-9)))
            places = np.linspace(start, end, count + 1)
            fits.append((index, places, np.full(count, -path.turn * np.tan(0.25 * (end - start) / count))))
            continue
        shape = form_of(path, index, form)
        fits.append((index, *_spread(path.on(index), shape, float(start), float(end), tolerance)))
    return fits


def _spread(path: "OnPiece", form: str, start: float, end: float, tolerance: float) -> "tuple[Any, Any]":
    """The fewest places found that keep the tolerance on one smooth piece."""
    order = ORDER[form]
    count = max(1, int(np.ceil((end - start) / TURN - 1e-9)))
    places = np.linspace(start, end, count + 1)
    best = None
    for attempt in range(60):
        # a pair of arcs counts as one here
        shape, errors = _shaped(path, form, places)
        load = np.maximum(errors / tolerance, 1e-9) ** (1.0 / order)
        worst = float(load.max())
        if worst <= 1.0:
            best = (places, shape)
            break
        need = float(load.sum())
        least = places.size - 1
        # equal loads first; more pieces only where equal ones would still be too long
        count = int(np.ceil(need * 1.001)) if need > least else least
        if count == least and worst / (need / least) < 1.02:
            count += 1
        require(
            count <= MOST,
            "a tolerance of {tolerance} takes more than {most} pieces",
            tolerance=(tolerance, Size),
            most=MOST,
            code="too-fine",
            hint="ask for cubics, or for a wider tolerance",
        )
        if attempt < EVEN:
            places = _equal(places, load, count)
        else:
            # where the error of a piece has a zero that moves with its ends, loads never settle: the long ones are cut
            long = load > 1.0
            places = np.sort(np.concatenate((places, 0.5 * (places[:-1] + places[1:])[long])))
    require(
        best is not None,
        "no pieces keep a tolerance of {tolerance}: rounding is larger",
        tolerance=(tolerance, Size),
        code="too-fine",
    )
    return _finished(form, *best)  # type: ignore[misc]


def _equal(places: "Any", load: "Any", count: int) -> "Any":
    """Places that share the load equally, its density taken as constant between the present places."""
    total = np.concatenate(([0.0], np.cumsum(load)))
    new = np.interp(np.linspace(0.0, total[-1], count + 1), total, places)
    new[0], new[-1] = places[0], places[-1]
    return new


def _shaped(path: "OnPiece", form: str, places: "Any") -> "tuple[Any, Any]":
    if form == "cubics":
        return _cubics(path, places)
    if form == "lines":
        return np.zeros(places.size - 1), _arc_errors(path, places, np.zeros(places.size - 1))
    return _pairs(path, places)


def _finished(form: str, places: "Any", shape: "Any") -> "tuple[Any, Any]":
    if form != "arcs":
        return places, shape
    middle, bulges = shape
    all_places = np.empty(2 * places.size - 1)
    all_places[::2], all_places[1::2] = places, middle
    return all_places, bulges.reshape(-1)


def _pairs(path: "OnPiece", places: "Any") -> "tuple[Any, Any]":
    """Pairs of arcs that meet on the curve: tangent to it at their outer ends and to each other."""
    x, y, tx, ty, _ = path.at(places)
    x0, y0, x1, y1 = x[:-1], y[:-1], x[1:], y[1:]
    turning = 0.5 * angle_between(tx[:-1], ty[:-1], tx[1:], ty[1:])

    def excess(theta: "Any") -> "tuple[Any, Any, Any]":
        jx, jy = path.at(theta)[:2]
        first = angle_between(tx[:-1], ty[:-1], jx - x0, jy - y0)
        second = angle_between(x1 - jx, y1 - jy, tx[1:], ty[1:])
        return first + second - turning, first, second

    low, high = places[:-1].copy(), places[1:].copy()
    width = high - low
    sign = excess(low + 0.02 * width)[0] > 0.0
    low, high = low + 0.02 * width, high - 0.02 * width
    for _ in range(36):
        middle = 0.5 * (low + high)
        same = (excess(middle)[0] > 0.0) == sign
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    middle = 0.5 * (low + high)
    # where every place will do (an exact circle), the middle is used
    _, first, second = excess(middle)
    bulges = np.stack((np.tan(0.5 * first), np.tan(0.5 * second)), axis=1)
    all_places = np.empty(2 * places.size - 1)
    all_places[::2], all_places[1::2] = places, middle
    errors = _arc_errors(path, all_places, bulges.reshape(-1))
    return (middle, bulges), errors.reshape(-1, 2).max(axis=1)


def circle_distance(x0: "Any", y0: "Any", x1: "Any", y1: "Any", bulge: "Any", x: "Any", y: "Any") -> "tuple[Any, ...]":
    """Signed distance of points from the circle of an arc (a line for bulge zero), and its gradient; stable throughout.

    With the chord on the x axis, G = ½κ(x² + y² − a²) + y·c, the distance is 2G/(1 + √(1 + 2κG)).
    """
    cx, cy = x1 - x0, y1 - y0
    chord = np.hypot(cx, cy)
    ux, uy = cx / chord, cy / chord
    rx, ry = x - 0.5 * (x0 + x1), y - 0.5 * (y0 + y1)
    along, across = rx * ux + ry * uy, ry * ux - rx * uy
    a = 0.5 * chord
    below = 1.0 + bulge * bulge
    # a positive bulge hangs below the chord: its centre is above for bulge < 1
    kappa, cosine = 2.0 * bulge / (a * below), (1.0 - bulge * bulge) / below
    # the factored x² − a² keeps its digits near the ends
    g = 0.5 * kappa * ((along - a) * (along + a) + across * across) - across * cosine
    root = np.sqrt(1.0 + 2.0 * kappa * g)
    gx, gy = kappa * along / root, (kappa * across - cosine) / root
    return 2.0 * g / (1.0 + root), gx * ux - gy * uy, gx * uy + gy * ux, kappa


def _arc_errors(path: "OnPiece", places: "Any", bulges: "Any") -> "Any":
    x, y = path.at(places)[:2]
    theta = places[:-1, None] + np.diff(places)[:, None] * SAMPLES
    px, py = path.at(theta)[:2]
    ends = (x[:-1, None], y[:-1, None], x[1:, None], y[1:, None])
    return np.abs(circle_distance(*ends, bulges[:, None], px, py)[0]).max(axis=1)


def bezier(x0: "Any", x1: "Any", x2: "Any", x3: "Any", t: "Any") -> "tuple[Any, Any, Any]":
    """One coordinate of cubics with its first two derivatives."""
    d0, d1, d2 = x1 - x0, x2 - x1, x3 - x2
    u = 1.0 - t
    value = x0 * u * u * u + 3.0 * t * u * (x1 * u + x2 * t) + x3 * t * t * t
    return value, 3.0 * (d0 * u * u + 2.0 * d1 * u * t + d2 * t * t), 6.0 * ((d1 - d0) * u + (d2 - d1) * t)


def controls(path: "OnPiece", places: "Any", handles: "Any") -> "tuple[Any, Any]":
    """Control points of the cubics, (n, 4) for each coordinate."""
    x, y, tx, ty, _ = path.at(places)
    a, b = handles[:, 0], handles[:, 1]
    points = []
    for start, end, early, late in ((x[:-1], x[1:], tx[:-1], tx[1:]), (y[:-1], y[1:], ty[:-1], ty[1:])):
        points.append(np.stack((start, start + a * early, end - b * late, end), axis=1))
    return points[0], points[1]


def _cubics(path: "OnPiece", places: "Any") -> "tuple[Any, Any]":
    """Handles of cubics tangent at their ends that pass through two more points of the curve (Newton)."""
    x, y, tx, ty, g = path.at(places)
    width = np.diff(places)
    handles = np.stack((np.abs(g[:-1]), np.abs(g[1:])), axis=1) * (width / 3.0)[:, None]
    mean = np.hypot(np.diff(x), np.diff(y)) / 3.0
    first = np.clip(handles, 0.5 * mean[:, None], 2.0 * mean[:, None])
    theta = places[:-1, None] + width[:, None] * FRACTIONS
    qx, qy = path.at(theta)[:2]
    t = np.broadcast_to(FRACTIONS, qx.shape).copy()
    lengths = first.copy()
    for _ in range(8):
        cx, cy = controls(path, places, lengths)
        px, dx, _ = bezier(cx[:, 0:1], cx[:, 1:2], cx[:, 2:3], cx[:, 3:4], t)
        py, dy, _ = bezier(cy[:, 0:1], cy[:, 1:2], cy[:, 2:3], cy[:, 3:4], t)
        early, late = 3.0 * t * (1.0 - t) ** 2, 3.0 * t * t * (1.0 - t)
        matrix = np.zeros((width.size, 4, 4))
        matrix[:, 0:2, 0], matrix[:, 2:4, 0] = early * tx[:-1, None], early * ty[:-1, None]
        matrix[:, 0:2, 1], matrix[:, 2:4, 1] = -late * tx[1:, None], -late * ty[1:, None]
        for i in range(2):
            matrix[:, i, 2 + i], matrix[:, 2 + i, 2 + i] = dx[:, i], dy[:, i]
        misfit = np.concatenate((qx - px, qy - py), axis=1)
        try:
            step = np.linalg.solve(matrix, misfit[..., None])[..., 0]
        except np.linalg.LinAlgError:
            break
        lengths = np.clip(lengths + step[:, :2], 0.3 * first, 3.0 * first)
        t = np.clip(t + step[:, 2:], 0.05, 0.95)
    errors = _cubic_errors(path, places, lengths)
    plain = _cubic_errors(path, places, first)
    better = errors <= plain
    return np.where(better[:, None], lengths, first), np.where(better, errors, plain)


def _cubic_errors(path: "OnPiece", places: "Any", handles: "Any") -> "Any":
    theta = places[:-1, None] + np.diff(places)[:, None] * SAMPLES
    px, py = path.at(theta)[:2]
    cx, cy = controls(path, places, handles)
    return foot(cx[:, :, None], cy[:, :, None], px, py, np.broadcast_to(SAMPLES, px.shape))[1].max(axis=1)


def foot(cx: "Any", cy: "Any", px: "Any", py: "Any", t: "Any", rounds: int = 5) -> "tuple[Any, Any]":
    """Parameters of the nearest points of cubics, by Newton from `t`, and the distances there."""
    for _ in range(rounds):
        bx, dx, ddx = bezier(cx[:, 0], cx[:, 1], cx[:, 2], cx[:, 3], t)
        by, dy, ddy = bezier(cy[:, 0], cy[:, 1], cy[:, 2], cy[:, 3], t)
        ex, ey = px - bx, py - by
        slope = dx * dx + dy * dy - ex * ddx - ey * ddy
        t = np.clip(t + (ex * dx + ey * dy) / np.where(slope > 0.0, slope, dx * dx + dy * dy), 0.0, 1.0)
    bx, by = bezier(cx[:, 0], cx[:, 1], cx[:, 2], cx[:, 3], t)[0], bezier(cy[:, 0], cy[:, 1], cy[:, 2], cy[:, 3], t)[0]
    return t, np.hypot(px - bx, py - by)
