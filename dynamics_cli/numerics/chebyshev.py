"""Chebyshev proxies of analytic functions, piece by piece, with a proved remainder, and all their extremes.

Many functions on many pieces are sampled and searched at once: the cost is that of a few array operations. Nodes lie
inside the pieces, so that a function that jumps at their ends is never asked there. What a proxy leaves out is bounded
by the function's values on a disc of the complex plane around the piece, in disc arithmetic, not by its samples.
"""

from functools import lru_cache

import numpy as np

from dynamics_cli.numerics.discs import UP, Disc
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

COUNT = 24
"""Nodes of a piece."""
RESOLVED = 3e-15
"""A remainder this small beside the largest value is small enough."""
LEBESGUE = 3.0
# radii of the discs tried about a piece, by its half width, and what their bound of the function is multiplied by in
# the remainder of the piece and of its halves, quarters, eighths and sixteenths
MULTIPLES = np.array([0.3, 0.6, 1.0, 1.6, 2.1, 2.7, 3.5, 5.0])
UNIT = 2
GRID = 72
LEVELS = 12
SPLIT = 8
END = 1e-4
NOISE = 1.5e-15
CALM = 1e-15
# below this nothing is told from zero
SMALLEST = 1e-280
# pieces of one round: more are left as they are, with the remainder there is
MOST = 4096
ROUNDING = 2.0**-45


def _remainders() -> "Any":
    inside = np.maximum(2.0 ** np.arange(5)[:, None] * MULTIPLES, 1.0)
    rho = inside + np.sqrt((inside - 1.0) * (inside + 1.0))
    # nothing is known without room around the piece; a constant is left alone by any number
    return np.where(rho > 1.0, 4.0 * rho ** (1.0 - COUNT) / np.where(rho > 1.0, rho - 1.0, 1.0), 1e300) * UP


REMAINDERS = _remainders()


@record
class Proxies:
    """Chebyshev coefficients of `q` functions on `m` pieces.

    Parameters
    ----------
    owner : array of m
        The given piece that each lies in.
    starts, ends : array of m
        The pieces, in order.
    coefficients : array (q, m, COUNT)
        Coefficients on each piece.
    error : array (q, m)
        Proved bound of the distance between function and proxy on the piece, all roundings included.
    """

    owner: "Any"
    starts: "Any"
    ends: "Any"
    coefficients: "Any"
    error: "Any"


@record
class Extremes:
    """Every candidate for an extreme of one function: ends of pieces and places where it turns, in order of place.

    Parameters
    ----------
    owner : array
        The given piece each place lies in.
    places : array
        Where.
    values : array
        The function there, one-sided at ends of pieces.
    inside : array of bool
        Whether the place is inside a piece: a place where the function turns.
    error : float
        Proved: the function's greatest and least value on the pieces are within it of the greatest and least here.
    """

    owner: "Any"
    places: "Any"
    values: "Any"
    inside: "Any"
    error: float

    def largest(self) -> tuple[float, float]:
        """The largest value and its place."""
        index = int(np.argmax(self.values))
        return float(self.values[index]), float(self.places[index])

    def smallest(self) -> tuple[float, float]:
        """The smallest value and its place."""
        index = int(np.argmin(self.values))
        return float(self.values[index]), float(self.places[index])


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


def proxies(function: "Callable[[Disc, Any], Any]", starts: "Any", ends: "Any", *, rounds: int = 16) -> Proxies:
    """Interpolate analytic functions on pieces cut as fine as the remainder that is proved for them asks.

    f(x) ≈ Σ c_k T_k, from values at the nodes cos((2j + 1)π/2n).

    Parameters
    ----------
    function : callable
        Takes places (m, k) and the index of the given piece each of the m rows lies in, gives values (q, m, k). Places
        come as a `Disc`, complex discs about real numbers: a formula of arithmetic, roots, sines and the like on arrays
        does for them.
    starts, ends : array
        The pieces, each in a coordinate of its own if need be; the functions are analytic inside each, and the same
        formula continues them beyond its ends.
    rounds : int
        How often pieces may be cut, each time into 2 to 16.

    Returns
    -------
    Proxies
        The coefficients, on pieces in order.

    Raises
    ------
    ValueError
        When a function is not finite at a node.

    Notes
    -----
    Where the disc of radius λh about the middle of a piece of half width h bounds |f − f(middle)| by M, f is analytic
    there, and its interpolant on n nodes is off by 4Mρ¹⁻ⁿ/(ρ − 1) at most, ρ = λ + √(λ² − 1): the coefficients are
    below 2Mρ⁻ᵏ, each one left out counts once for itself and once for its alias. Also by (1 + Λ)M, Λ ≤ 3 the Lebesgue
    constant. To this come Λ times the rounding of the values, and that of the transform, 2u(n + 12)Σ|f − f(middle)|
    over the nodes. Trefethen, Approximation Theory and Approximation Practice, chapters 4, 8 and 15.

    Examples
    --------
    >>> made = proxies(lambda x, piece: np.exp(x)[None], np.array([0.0]), np.array([1.0]))
    >>> round(float(made.coefficients[0, 0, 0]), 10), bool(made.error[0, 0] < 1e-13)
    (1.7533876544, True)
    """
    nodes, matrix = _transform(COUNT)
    low, high, origin, middle, left_out = _cut(function, starts, ends, rounds)
    half = 0.5 * (high - low)
    with np.errstate(all="ignore"):
        found = function(Disc(0.5 * (low + high)[:, None] + half[:, None] * nodes), origin)
    shape = np.broadcast_shapes(found.centre.shape, (1, low.size, COUNT))
    values = np.broadcast_to(found.centre, shape)
    slip = np.broadcast_to(found.radius, shape).max(axis=2)
    if not (np.isfinite(values).all() and np.isfinite(slip).all()):
        raise ValueError("the function is not finite inside a piece")
    away = values - middle[:, :, None]
    made = away @ matrix
    made[:, :, 0] += middle
    error = left_out + LEBESGUE * slip + 2.0**-52 * ((COUNT + 12.0) * np.abs(away).sum(axis=2) + np.abs(middle))
    return Proxies(origin, low, high, made, error * UP)


def _cut(function: "Callable[[Disc, Any], Any]", starts: "Any", ends: "Any", rounds: int) -> "tuple[Any, ...]":
    """Pieces in order with the values at their middles and the remainder proved for each."""
    low, high = np.array(starts, dtype=float), np.array(ends, dtype=float)
    origin = np.arange(low.size)
    scale: Any = 0.0
    done: list[tuple[Any, ...]] = []
    for level in range(rounds + 1):
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        with np.errstate(all="ignore"):
            found = function(Disc(middle[:, None], half[:, None] * MULTIPLES), origin)
        shape = np.broadcast_shapes(found.centre.shape, found.radius.shape, (1, low.size, MULTIPLES.size))
        # the middles may go along the discs' axis or stand alone
        values = np.broadcast_to(found.centre, shape)[:, :, 0]
        wide = np.broadcast_to(found.radius, shape)
        wide = np.where(np.isfinite(wide), wide, np.inf)
        finite = np.where(np.isfinite(values) & (wide[:, :, 0] < np.inf), np.abs(values), 0.0)
        scale = np.maximum(scale, finite.max(axis=1))
        wanted = (RESOLVED * scale + SMALLEST)[:, None]
        with np.errstate(over="ignore"):
            remainders = [(wide * row).min(axis=2) for row in REMAINDERS]
        left_out = np.minimum(remainders[0], (1.0 + LEBESGUE) * wide[:, :, UNIT])
        good = (left_out <= wanted).all(axis=0) | (level == rounds) | (middle <= low) | (middle >= high)
        good |= low.size > MOST
        done.append((low[good], high[good], origin[good], values[:, good], left_out[:, good]))
        if good.all():
            break
        # as many parts as would do if the discs of the parts were no worse than those of the whole
        enough = np.array([(remainder <= wanted).all(axis=0) for remainder in remainders[1:]])
        parts = np.where(enough.any(axis=0), 2 ** (1 + enough.argmax(axis=0)), 16)[~good]
        step = (high - low)[~good] / parts
        owner = np.repeat(np.arange(parts.size), parts)
        number = np.arange(owner.size) - np.repeat(np.cumsum(parts) - parts, parts)
        first, last = low[~good][owner], high[~good][owner]
        low, high = first + number * step[owner], first + (number + 1.0) * step[owner]
        high = np.where(number == parts[owner] - 1, last, high)
        # neighbours share their end to the bit
        high[:-1] = np.where(number[1:] > 0, low[1:], high[:-1])
        origin = origin[~good][owner]
    all_low, owner = np.concatenate([part[0] for part in done]), np.concatenate([part[2] for part in done])
    order = np.lexsort((all_low, owner))
    return (
        all_low[order],
        np.concatenate([part[1] for part in done])[order],
        owner[order],
        *(np.concatenate([part[index] for part in done], axis=1)[:, order] for index in (3, 4)),
    )


def extremes(made: Proxies, which: int = 0, *, every: bool = False) -> Extremes:
    """Find the greatest and the least value of one of the functions, or every place where it turns.

    f′ = 0 is looked for in t, x = cos t: between grid points a cell has no root when both ends keep one sign and are
    above h²/8·max|f‴|, exactly one when f″ keeps its sign likewise; a cell that is neither is divided.

    Parameters
    ----------
    made : Proxies
        The interpolated functions.
    which : int
        Which of them.
    every : bool
        Whether places are wanted that decide neither the greatest nor the least value.

    Returns
    -------
    Extremes
        Ends of pieces and places where the function turns.

    Raises
    ------
    ValueError
        Never for finite coefficients.

    Notes
    -----
    Derivatives are bounded by Σ kⁿ|c_k|, and what rounding does to them by 2⁻⁴⁵ Σ kⁿ|c_k| (angles kt to 23π, sums of 24
    terms), so no turn of the proxy is missed; cells still undecided within which it moves by less than 1e-15 of its
    size are candidates themselves. `error` adds to what is proved for the proxies the rounding of the values, what
    coefficients too small to be searched come to, and what Newton's method leaves at the places.

    Examples
    --------
    >>> made = proxies(lambda x, piece: np.sin(x)[None], np.array([0.0]), np.array([3.0]))
    >>> value, place = extremes(made).largest()
    >>> abs(place - np.pi / 2) < 1e-7, abs(value - 1.0) < 1e-15
    (True, True)
    """
    whole = made.coefficients[which]
    count = whole.shape[1]
    t, basis, first, second = _basis(count)
    k = np.arange(count, dtype=float)
    size = np.abs(whole)
    # a coefficient that is rounding alone would be searched for turns of its own
    c = np.where(size > NOISE * size.sum(axis=1)[:, None], whole, 0.0)
    size = np.abs(c)
    bounds = [size @ k**power for power in (2, 3, 4)]
    slack = [ROUNDING * (size @ k), ROUNDING * bounds[0]]
    scale = size.sum(axis=1)
    # what the values may be off the largest and least of the proxy
    off = 2.0 * np.abs(whole - c).sum(axis=1) + 0.5 * ROUNDING * size[:, 1:].sum(axis=1) + 2.0**-48 * scale
    step = np.pi / GRID
    roots: list[tuple[Any, Any, Any]] = []
    calm: list[tuple[Any, Any]] = []
    q, d1, d2 = c @ basis, c @ first, c @ second
    ends = np.concatenate((whole @ np.where(k % 2, -1.0, 1.0), whole.sum(axis=1)))
    most, least = ends.max(), ends.min()
    owner, grid = np.arange(c.shape[0]), np.broadcast_to(t, (c.shape[0], t.size))
    # a piece that is constant to its rounding has no extremes
    bounds[0] = np.where(step * bounds[0] <= 1e-15 * scale, 0.0, bounds[0])
    for level in range(LEVELS + 1):
        turning, unsure = _cells(d1, d2, step, bounds, slack, owner[:, None])
        steady = (bounds[0] == 0.0)[owner]
        turning[steady], unsure[steady] = False, False
        # within a cell the function is near its chord
        room = (0.125 * step * step * bounds[0] + 4e-16 * scale)[owner][:, None]
        high, low = np.maximum(q[:, :-1], q[:, 1:]) + room, np.minimum(q[:, :-1], q[:, 1:]) - room
        if level == 0:
            tops, bottoms = high.max(axis=1), low.min(axis=1)
        if not every:
            most, least = max(most, q.max()), min(least, q.min())
            decides = (high >= most) | (low <= least)
            turning &= decides
            unsure &= decides
        found, cells = np.nonzero(turning)
        roots.append((owner[found], grid[found, cells], grid[found, cells + 1]))
        found, cells = np.nonzero(unsure)
        rows, left = owner[found], grid[found, cells]
        if not rows.size:
            break
        # where the function hardly moves within a cell, any place of it will do
        moves = step * np.maximum(np.abs(d1[found, cells]), np.abs(d1[found, cells + 1]))
        moves += 0.125 * step**3 * bounds[1][rows] + step * slack[0][rows]
        still = (moves <= CALM * scale[rows]) | (level == LEVELS)
        np.maximum.at(off, rows[still], off[rows[still]] + moves[still])
        calm.append((rows[still], left[still] - 0.5 * step))
        owner, left = rows[~still], left[~still]
        if not owner.size:
            break
        step /= SPLIT
        grid = left[:, None] - step * np.arange(SPLIT + 1)
        q, d1, d2 = _derivatives(c[owner], grid)
    at = [np.concatenate([part[index] for part in roots]) for index in range(3)]
    row = np.concatenate([at[0], *(part[0] for part in calm)])
    turns, slope = _refined(c, at[0], at[1], at[2])
    np.maximum.at(off, at[0], off[at[0]] + (np.abs(slope) + slack[0][at[0]]) * np.abs(at[1] - at[2]))
    place = np.concatenate([turns, *(part[1] for part in calm)])
    half, middle = 0.5 * (made.ends - made.starts), 0.5 * (made.ends + made.starts)
    inner = (whole[row] * np.cos(k * place[:, None])).sum(axis=1)
    places = np.concatenate((made.starts, made.ends, middle[row] + half[row] * np.cos(place)))
    values = np.concatenate((ends, inner))
    # by t, every function turns at the ends of its piece
    inside = np.concatenate((np.zeros(ends.size, dtype=bool), (place > END) & (place < np.pi - END)))
    owners = made.owner[np.concatenate((np.tile(np.arange(c.shape[0]), 2), row))]
    order = np.lexsort((places, owners))
    # a piece that stays below the greatest value by more than its error has no part in the error of that
    room = np.maximum(np.minimum(tops - values.max(), 0.0), np.minimum(values.min() - bottoms, 0.0))
    return Extremes(
        owners[order], places[order], values[order], inside[order],
        float(max(np.max(made.error[which] + off + room) * UP, 0.0)),
    )  # fmt: skip


def _cells(
    d1: "Any", d2: "Any", step: float, bounds: "list[Any]", slack: "list[Any]", rows: "Any"
) -> "tuple[Any, Any]":
    """Cells with exactly one root of the derivative, and cells about which nothing is known yet."""
    a, b = d1[:, :-1], d1[:, 1:]
    changes = (a > 0.0) != (b > 0.0)
    room = 0.125 * step * step
    clear = ~changes & (np.minimum(np.abs(a), np.abs(b)) > room * bounds[1][rows] + slack[0][rows])
    p, q = d2[:, :-1], d2[:, 1:]
    monotone = ((p > 0.0) == (q > 0.0)) & (np.minimum(np.abs(p), np.abs(q)) > room * bounds[2][rows] + slack[1][rows])
    return changes & monotone, ~clear & ~monotone


def _derivatives(c: "Any", t: "Any") -> "tuple[Any, Any, Any]":
    """The function and its first two derivatives by t."""
    k = np.arange(c.shape[1])
    angle = t[..., None] * k
    sine, cosine = np.sin(angle), np.cos(angle)
    rows = np.stack((c, k * k * c), axis=-1)
    kc = (k * c)[..., None]
    if t.ndim == 1:
        both = (cosine[:, None, :] @ rows)[:, 0]
        return both[:, 0], -(sine[:, None, :] @ kc)[:, 0, 0], -both[:, 1]
    both = cosine @ rows
    return both[..., 0], -(sine @ kc)[..., 0], -both[..., 1]


def _refined(c: "Any", rows: "Any", high: "Any", low: "Any") -> "tuple[Any, Any]":
    """Newton kept within a hair of its cell, where the derivative is monotone, and the derivative that is left."""
    if not rows.size:
        return np.zeros(0), np.zeros(0)
    own, hair = c[rows], 0.01 * (high - low)
    place = 0.5 * (low + high)
    for _ in range(6):
        _, d1, d2 = _derivatives(own, place)
        place = np.clip(place - d1 / np.where(d2 == 0.0, np.inf, d2), low - hair, high + hair)
    return place, _derivatives(own, place)[1]
