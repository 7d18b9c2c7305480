"""Chebyshev proxies of smooth functions, piece by piece, and all their extremes, certified by bounds of derivatives.

Many functions on many pieces are sampled and searched at once: the cost is that of a few array operations. Nodes lie
inside the pieces, so that a function that jumps at their ends is never evaluated there.
"""

from functools import lru_cache

import numpy as np

from dynamics_cli.numerics.discs import UP
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

COUNT = 32
"""Nodes of a piece whose remainder is estimated."""
RESOLVED = 4e-15
"""Last coefficients this small beside the whole mean that a piece is resolved."""
GRID = 72
LEVELS = 12
SPLIT = 8
END = 1e-4
NOISE = 1.5e-15
CALM = 1e-15
# values this close to the best are equal: the first is reported
ALIKE = 1e-14
ROUNDING = 2.0**-45


@record
class Proxies:
    """Chebyshev coefficients of `q` functions on `m` pieces."""

    owner: Annotated["Any", "The given piece that each lies in."]
    starts: Annotated["Any", "The pieces, in order."]
    ends: Annotated["Any", "The pieces, in order."]
    coefficients: Annotated["Any", "Coefficients on each piece."]
    error: Annotated["Any", "What the coefficients left out may come to."]


@record
class Extremes:
    """Every candidate for an extremum of one function: ends of pieces and stationary points, in order of place."""

    owner: Annotated["Any", "The given piece each place lies in."]
    places: Annotated["Any", "Where."]
    values: Annotated["Any", "The function there, one-sided at ends of pieces."]
    inside: Annotated["Any", "Whether the place is inside a piece: a place where the function turns."]
    error: Annotated[
        float,
        "The function's greatest and least value on the pieces are within it of the greatest and least here.",
    ]
    gains: Annotated["Any", "How much the function may exceed its extremum at each place nearby."] = None

    def near(self, sign: float) -> "Any":
        """The places that may hold the greatest value (sign 1) or the least (-1)."""
        values = sign * self.values
        return np.flatnonzero(values >= values.max() - 2.0 * self.error)

    def largest(self) -> tuple[float, float]:
        """The largest value, and the first place whose value equals it within rounding."""
        top = float(self.values.max())
        return top, float(self.places[int(np.argmax(self.values >= top - min(self.error, ALIKE * abs(top))))])

    def smallest(self) -> tuple[float, float]:
        """The smallest value, and the first place whose value equals it within rounding."""
        least = float(self.values.min())
        return least, float(self.places[int(np.argmax(self.values <= least + min(self.error, ALIKE * abs(least))))])


@lru_cache(maxsize=4)
def _transform(count: int) -> "tuple[Any, Any]":
    """The nodes cos t in increasing order, and the matrix that turns values there into coefficients."""
    # angles reduced as whole numbers of quarter steps, folded into the first turn's half
    steps = np.outer(2 * np.arange(count)[::-1] + 1, np.arange(count)) % (4 * count)
    steps = np.minimum(steps, 4 * count - steps)
    matrix = 2.0 / count * np.sin(0.5 * np.pi * (count - steps) / count)
    matrix[:, 0] *= 0.5
    nodes = np.sin(0.5 * np.pi * (2.0 * np.arange(count) + 1.0 - count) / count)
    return nodes, matrix


@lru_cache(maxsize=4)
def _basis(count: int) -> "tuple[Any, ...]":
    """cos(kt) and its first two derivatives by t, on a grid from the left end (t = π) to the right."""
    t = np.linspace(np.pi, 0.0, GRID + 1)
    k = np.arange(count)[:, None]
    cosine = np.cos(k * t)
    return t, cosine, -k * np.sin(k * t), -k * k * cosine


def proxies(function: "Callable[[Any, Any], Any]", starts: "Any", ends: "Any", *, depth: int = 24) -> Proxies:
    """Interpolate functions on pieces, halving those that are not resolved; the remainder is estimated.

    f(x) ≈ Σ c_k T_k, from values at the nodes cos((2j + 1)π/2n).

    `function`: takes places (m, n) and the index of the given piece each of the m rows lies in, gives values (q, m, n);
    `starts`, `ends`: the pieces, each in its own coordinate if necessary; the functions are smooth inside each;
    `depth`: how often a piece may be halved. Returns the coefficients, on pieces in order. Raises ValueError when a
    function is not finite at a node.

    A piece is resolved when its last four coefficients are below 4e-15 of their sum, or when halving no longer helps
    (rounding of the function itself). For an analytic function the omitted coefficients decrease like the last ones;
    `error` is twice the last four, which is an estimate. Trefethen, Approximation Theory and Approximation Practice,
    chapters 3-8.

    References
    ----------
    L. N. Trefethen, Approximation Theory and Approximation Practice, SIAM 2013, chapters 3 to 8.

    Examples
    --------
    >>> result = proxies(lambda x, piece: np.exp(x)[None], np.array([0.0]), np.array([1.0]))
    >>> round(float(result.coefficients[0, 0, 0]), 10)
    1.7533876544
    """
    nodes, matrix = _transform(COUNT)
    low, high = np.array(starts, dtype=float), np.array(ends, dtype=float)
    origin = np.arange(low.size)
    before: Any = np.inf
    resolved: list[tuple[Any, Any, Any, Any, Any]] = []
    for level in range(depth + 1):
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        values = function(middle[:, None] + half[:, None] * nodes, origin)
        if not np.isfinite(values).all():
            raise ValueError("the function is not finite inside a piece")
        coefficients = values @ matrix
        size = np.abs(coefficients).sum(axis=2)
        tail = np.abs(coefficients[:, :, -4:]).sum(axis=2)
        worst = np.max(tail / np.where(size > 0.0, size, 1.0), axis=0)
        hopeless = (worst > 0.2 * before) & (worst < 1e-6) & (level > 1)
        good = (worst <= RESOLVED) | hopeless | (level == depth) | (middle <= low) | (middle >= high)
        resolved.append((low[good], high[good], coefficients[:, good], 2.0 * tail[:, good], origin[good]))
        if good.all():
            break
        bad = ~good
        lows, mid, right = low[bad], middle[bad], high[bad]
        low, high = np.concatenate((lows, mid)), np.concatenate((mid, right))
        origin = np.concatenate((origin[bad], origin[bad]))
        before = np.concatenate((worst[bad], worst[bad]))
    all_low = np.concatenate([part[0] for part in resolved])
    owner = np.concatenate([part[4] for part in resolved])
    order = np.lexsort((all_low, owner))
    return Proxies(
        owner[order],
        all_low[order],
        np.concatenate([part[1] for part in resolved])[order],
        np.concatenate([part[2] for part in resolved], axis=1)[:, order],
        np.concatenate([part[3] for part in resolved], axis=1)[:, order],
    )


def extremes(proxy: Proxies, which: int = 0, *, every: bool = False) -> Extremes:
    """Find the maximum and the minimum of one of the functions, or every stationary point.

    f′ = 0 is sought in t, x = cos t: between grid points a cell has no root when both ends keep one sign and are
    above h²/8·max|f‴|, exactly one when f″ keeps its sign likewise; other cells are divided.

    `proxy`: the interpolated functions; `every`: also return places that decide neither maximum nor minimum. Returns
    ends of pieces and places where the function turns.

    Derivatives are bounded by Σ kⁿ|c_k|, and what rounding does to them by 2⁻⁴⁵ Σ kⁿ|c_k| (angles kt to 23π, sums of 24
    terms), so no turn of the proxy is missed; cells still undecided within which it moves by less than 1e-15 of its
    size are candidates themselves. `error` adds to that of the proxies the rounding of the values, the sum
    of coefficients too small to be searched, and the residual of Newton's method at the places.

    References
    ----------
    Derived: bounds of the derivatives of a Chebyshev sum exclude or isolate every root of f′.

    Examples
    --------
    >>> result = proxies(lambda x, piece: np.sin(x)[None], np.array([0.0]), np.array([3.0]))
    >>> value, place = extremes(result).largest()
    >>> abs(place - np.pi / 2) < 1e-7, abs(value - 1.0) < 1e-15
    (True, True)
    """
    series = proxy.coefficients[which]
    count = series.shape[1]
    t, basis, first, second = _basis(count)
    k = np.arange(count, dtype=float)
    size = np.abs(series)
    # a coefficient that is only rounding would add false turning points
    c = np.where(size > NOISE * size.sum(axis=1)[:, None], series, 0.0)
    size = np.abs(c)
    bounds = [size @ k**power for power in (2, 3, 4)]
    slack = [ROUNDING * (size @ k), ROUNDING * bounds[0]]
    scale = size.sum(axis=1)
    # error of the values against the maximum and minimum of the proxy
    off = 2.0 * np.abs(series - c).sum(axis=1) + ROUNDING * size[:, 1:].sum(axis=1) + 2.0**-51 * scale
    step = np.pi / GRID
    roots: list[tuple[Any, Any, Any]] = []
    calm: list[tuple[Any, Any]] = []
    q, d1, d2 = c @ basis, c @ first, c @ second
    # the mean last: the other terms are small beside it on a short piece
    moving, mean = series[:, 1:], series[:, 0]
    ends = np.concatenate((moving @ np.where(k[1:] % 2, -1.0, 1.0) + mean, moving.sum(axis=1) + mean))
    most, least = ends.max(), ends.min()
    owner, grid = np.arange(c.shape[0]), np.broadcast_to(t, (c.shape[0], t.size))
    # a piece that is constant to rounding has no extremum
    bounds[0] = np.where(step * bounds[0] <= 1e-15 * scale, 0.0, bounds[0])
    for level in range(LEVELS + 1):
        turning, unsure = _cells(d1, d2, step, bounds, slack, owner[:, None])
        steady = (bounds[0] == 0.0)[owner]
        turning[steady], unsure[steady] = False, False
        # within a cell the function is near its chord
        edge = (0.125 * step * step * bounds[0] + 4e-16 * scale)[owner][:, None]
        high, low = np.maximum(q[:, :-1], q[:, 1:]) + edge, np.minimum(q[:, :-1], q[:, 1:]) - edge
        if level == 0:
            tops, bottoms = high.max(axis=1), low.min(axis=1)
        if not every:
            most, least = max(most, q.max()), min(least, q.min())
            edge = 2.0 * proxy.error[which][owner][:, None]
            decides = (high >= most - edge) | (low <= least + edge)
            turning &= decides
            unsure &= decides
        pieces_found, cells = np.nonzero(turning)
        roots.append((owner[pieces_found], grid[pieces_found, cells], grid[pieces_found, cells + 1]))
        pieces_found, cells = np.nonzero(unsure)
        rows, lefts = owner[pieces_found], grid[pieces_found, cells]
        if not rows.size:
            break
        # where the function hardly varies within a cell, any place in it will do
        moves = step * np.maximum(np.abs(d1[pieces_found, cells]), np.abs(d1[pieces_found, cells + 1]))
        moves += 0.125 * step**3 * bounds[1][rows] + step * slack[0][rows]
        still = (moves <= CALM * scale[rows]) | (level == LEVELS)
        np.maximum.at(off, rows[still], off[rows[still]] + moves[still])
        calm.append((rows[still], lefts[still] - 0.5 * step))
        owner, lefts = rows[~still], lefts[~still]
        if not owner.size:
            break
        step /= SPLIT
        grid = lefts[:, None] - step * np.arange(SPLIT + 1)
        q, d1, d2 = _derivatives(c[owner], grid)
    at = [np.concatenate([part[index] for part in roots]) for index in range(3)]
    row = np.concatenate([at[0], *(part[0] for part in calm)])
    turns, slope = _refined(c, at[0], at[1], at[2])
    np.maximum.at(off, at[0], off[at[0]] + (np.abs(slope) + slack[0][at[0]]) * np.abs(at[1] - at[2]))
    place = np.concatenate([turns, *(part[1] for part in calm)])
    half, middle = 0.5 * (proxy.ends - proxy.starts), 0.5 * (proxy.ends + proxy.starts)
    inner = (moving[row] * np.cos(k[1:] * place[:, None])).sum(axis=1) + mean[row]
    places = np.concatenate((proxy.starts, proxy.ends, middle[row] + half[row] * np.cos(place)))
    values = np.concatenate((ends, inner))
    # by t, every function turns at the ends of its piece
    inside = np.concatenate((np.zeros(ends.size, dtype=bool), (place > END) & (place < np.pi - END)))
    rows = np.concatenate((np.tile(np.arange(c.shape[0]), 2), row))
    # the samples are rounded too
    gains = _gains(proxy.error[which] + 2.0**-52 * scale, c, moving, (place, slope, slack, at[0]), row)
    owners = proxy.owner[rows]
    order = np.lexsort((places, owners))
    # a piece below the maximum by more than its error does not contribute to the maximum's error
    edge = np.maximum(np.minimum(tops - values.max(), 0.0), np.minimum(values.min() - bottoms, 0.0))
    return Extremes(
        owners[order], places[order], values[order], inside[order],
        float(max(np.max(proxy.error[which] + off + edge) * UP, 0.0)), gains[order],
    )  # fmt: skip


def _gains(error: "Any", c: "Any", moving: "Any", turning: "tuple[Any, ...]", inner: "Any") -> "Any":
    """How much a function may exceed its value at ends of pieces, where it turns, and in cells where it hardly moves.

    By twice the error E of its interpolant at most; where that turns with f″ = −m, by (|f′| + nE)²/m, at an end with
    n²E in place of nE.
    """
    places, slope, slack, rows = turning
    count = c.shape[1]
    k, twice = np.arange(1, count, dtype=float), np.tile(error, 2)
    signs = [np.where(k % 2, sign, 1.0) for sign in (-1.0, 1.0)]
    steep = np.concatenate([np.abs((moving * k * k) @ sign) for sign in signs])
    bend = np.concatenate([np.abs((moving * k * k * (k * k - 1.0) / 3.0) @ sign) for sign in signs])
    reach = count * count * twice
    ends = np.minimum(2.0 * twice, (steep + reach) ** 2 / np.maximum(bend, 1e-300))
    ends = np.where(steep > 4.0 * reach, 0.0, ends)
    inside = 2.0 * error[inner]
    if rows.size:
        bend = np.abs(_derivatives(c[rows], places[: rows.size])[2])
        near = (np.abs(slope) + slack[0][rows] + count * error[rows]) ** 2 / np.maximum(bend - slack[1][rows], 1e-300)
        inside[: rows.size] = np.minimum(inside[: rows.size], near)
    # next to an end, which is a place itself, every function turns
    return np.concatenate((ends, np.where((places > END) & (places < np.pi - END), inside, 0.0)))


def _cells(
    d1: "Any", d2: "Any", step: float, bounds: "list[Any]", slack: "list[Any]", rows: "Any"
) -> "tuple[Any, Any]":
    """Cells with exactly one root of the derivative, and undecided cells."""
    a, b = d1[:, :-1], d1[:, 1:]
    changes = (a > 0.0) != (b > 0.0)
    bulge = 0.125 * step * step
    clear = ~changes & (np.minimum(np.abs(a), np.abs(b)) > bulge * bounds[1][rows] + slack[0][rows])
    p, q = d2[:, :-1], d2[:, 1:]
    monotone = ((p > 0.0) == (q > 0.0)) & (np.minimum(np.abs(p), np.abs(q)) > bulge * bounds[2][rows] + slack[1][rows])
    return changes & monotone, ~clear & ~monotone


def _derivatives(c: "Any", t: "Any") -> "tuple[Any, Any, Any]":
    """The function and its first two derivatives by t."""
    k = np.arange(c.shape[1])
    angle = t[..., None] * k
    sine, cosine = np.sin(angle), np.cos(angle)
    rows = np.stack((c, k * k * c), axis=-1)
    kc = (k * c)[..., None]
    if t.ndim == 1:
        value_and_bend = (cosine[:, None, :] @ rows)[:, 0]
        return value_and_bend[:, 0], -(sine[:, None, :] @ kc)[:, 0, 0], -value_and_bend[:, 1]
    value_and_bend = cosine @ rows
    return value_and_bend[..., 0], -(sine @ kc)[..., 0], -value_and_bend[..., 1]


def _refined(c: "Any", rows: "Any", high: "Any", low: "Any") -> "tuple[Any, Any]":
    """Newton's method kept close to its cell, where the derivative is monotone; and the remaining derivative."""
    if not rows.size:
        return np.zeros(0), np.zeros(0)
    series, hair = c[rows], 0.01 * (high - low)
    place = 0.5 * (low + high)
    for _ in range(6):
        _, d1, d2 = _derivatives(series, place)
        before, place = place, np.clip(place - d1 / np.where(d2 == 0.0, np.inf, d2), low - hair, high + hair)
        # the square of such a step is below a rounding
        if np.abs(place - before).max() <= 1e-9:
            break
    return place, _derivatives(series, place)[1]
