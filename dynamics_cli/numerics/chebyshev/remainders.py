"""Chebyshev proxies with a proved remainder: the function is bounded on discs of the complex plane around each piece.

The remainder of a proxy follows from the largest value of the function on a disc containing the piece, in
disc arithmetic (`numerics.discs`), not from samples of the function.
"""

import numpy as np

from dynamics_cli.numerics.chebyshev.proxies import Proxies, _transform
from dynamics_cli.numerics.discs import UP, Disc

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

COUNT = 24
"""Nodes of a piece."""
RESOLVED = 3e-15
"""A remainder this small beside the largest value is small enough."""
LEBESGUE = 3.0
U = 2.0**-53
# radii of the discs tried about a piece, in half widths, and the factors from their bound of the function to the
# remainder of the piece and of its halves, quarters, eighths and sixteenths
MULTIPLES = np.array([0.3, 0.6, 1.0, 1.6, 2.1, 2.7, 3.5, 5.0])
UNIT = 2
# below this nothing can be distinguished from zero
SMALLEST = 1e-280
# pieces per round: further ones stay as they are, with the remainder so far
MOST = 4096
# how often a piece may be cut, each time into 2 to 16
ROUNDS = 16


def _remainders() -> "Any":
    inside = np.maximum(2.0 ** np.arange(5)[:, None] * MULTIPLES, 1.0)
    rho = inside + np.sqrt((inside - 1.0) * (inside + 1.0))
    # a disc needs space around the piece; a constant is unaffected by any number
    return np.where(rho > 1.0, 4.0 * rho ** (1.0 - COUNT) / np.where(rho > 1.0, rho - 1.0, 1.0), 1e300) * UP


REMAINDERS = _remainders()


def proved_proxies(function: "Callable[[Disc, Any], Any]", starts: "Any", ends: "Any") -> Proxies:
    """Interpolate analytic functions on pieces fine enough for the proved remainder.

    f(x) ≈ Σ c_k T_k, from values at the nodes cos((2j + 1)π/2n).

    `function`: takes places (m, k) and the index of the given piece each of the m rows lies in, gives values (q, m, k).
    Places come as a `Disc`, complex discs about real numbers: a formula of arithmetic, roots, sines and the like on
    arrays does for them; `starts`, `ends`: the pieces, each in its own coordinate if necessary; the functions are
    analytic inside each, and the same formula continues them beyond its ends. Returns the coefficients, on pieces in
    order. Raises ValueError when a function is not finite at a node.

    Where the disc of radius λh about the middle of a piece of half width h bounds |f − f(middle)| by M, f is analytic
    there, and the error of its interpolant on n nodes is at most 4Mρ¹⁻ⁿ/(ρ − 1), ρ = λ + √(λ² − 1): the coefficients
    are below 2Mρ⁻ᵏ, each omitted one counts twice, for itself and for its alias. Also by (1 + Λ)M, Λ ≤ 3 the
    Lebesgue constant. Added are Λ times the rounding of the values, the effect of the rounding of the nodes by |f′|,
    and the rounding of the transform, 2u(n + 12)Σ|f − f(middle)| over the nodes. Without a bound the error is infinite.
    The derivative of what is left out is (n + 2)² times as large at most: Markov's n² for all that is a polynomial on
    the nodes, and Σ k²ρ⁻ᵏ ≤ (n² + 2n/(ρ − 1) + (ρ + 1)/(ρ − 1)²) Σ ρ⁻ᵏ for the rest, ρ ≥ 2.8. Trefethen, Approximation
    Theory and Approximation Practice, chapters 4, 8 and 15.

    References
    ----------
    L. N. Trefethen, Approximation Theory and Approximation Practice, SIAM 2013, chapters 4, 8 and 15.

    Examples
    --------
    >>> result = proved_proxies(lambda x, piece: np.exp(x)[None], np.array([0.0]), np.array([1.0]))
    >>> round(float(result.coefficients[0, 0, 0]), 10), bool(result.error[0, 0] < 1e-12)
    (1.7533876544, True)
    """
    nodes, matrix = _transform(COUNT)
    low, high, origin, middle, left_out, steep, wide, spectral = _cut(function, starts, ends)
    half = 0.5 * (high - low)
    places = 0.5 * (low + high)[:, None] + half[:, None] * nodes
    with np.errstate(all="ignore"):
        samples = function(Disc(places), origin)
    shape = np.broadcast_shapes(samples.centre.shape, (1, low.size, COUNT))
    values = np.broadcast_to(samples.centre, shape)
    rounding = np.broadcast_to(samples.radius, shape).max(axis=2)
    if not np.isfinite(values).all():
        raise ValueError("the function is not finite inside a piece")
    # nodes are rounded: to half a unit of their place, and eight units of their share of the piece
    moved = U * (np.abs(places).max(axis=1) + 8.0 * half)
    with np.errstate(all="ignore"):
        rounding = rounding + np.minimum(steep * (moved / np.where(half > 0.0, half, 1.0)), 2.0 * wide)
    rounding = np.where(np.isfinite(rounding), rounding, np.inf)
    away = values - middle[:, :, None]
    coefficients = away @ matrix
    coefficients[:, :, 0] += middle
    rounded = LEBESGUE * rounding + 2.0**-52 * ((COUNT + 12.0) * np.abs(away).sum(axis=2) + np.abs(middle))
    error, steep = left_out + rounded, (COUNT + 2.0) ** 2 * (spectral + rounded)
    error, steep = (np.where(np.isfinite(part), part * UP, np.inf) for part in (error, steep))
    return Proxies(origin, low, high, coefficients, error, True, steep)


def _cut(function: "Callable[[Disc, Any], Any]", starts: "Any", ends: "Any") -> "tuple[Any, ...]":
    """Pieces in order, values at their middles, remainders, bounds of h|f′| (by Cauchy) and of |f − f(middle)|."""
    low, high = np.array(starts, dtype=float), np.array(ends, dtype=float)
    origin = np.arange(low.size)
    scale: Any = 0.0
    finished: list[tuple[Any, ...]] = []
    for level in range(ROUNDS + 1):
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        with np.errstate(all="ignore"):
            enclosures = function(Disc(middle[:, None], half[:, None] * MULTIPLES), origin)
        shape = np.broadcast_shapes(enclosures.centre.shape, enclosures.radius.shape, (1, low.size, MULTIPLES.size))
        # the middles may go along the discs' axis or stand alone
        values = np.broadcast_to(enclosures.centre, shape)[:, :, 0]
        wide = np.broadcast_to(enclosures.radius, shape)
        wide = np.where(np.isfinite(wide), wide, np.inf)
        finite = np.where(np.isfinite(values) & (wide[:, :, 0] < np.inf), np.abs(values), 0.0)
        scale = np.maximum(scale, finite.max(axis=1))
        allowed = (RESOLVED * scale + SMALLEST)[:, None]
        with np.errstate(over="ignore"):
            remainder = (wide * REMAINDERS[0]).min(axis=2)
        left_out = np.minimum(remainder, (1.0 + LEBESGUE) * wide[:, :, UNIT])
        good = (left_out <= allowed).all(axis=0) | (level == ROUNDS) | (middle <= low) | (middle >= high)
        good |= low.size > MOST
        with np.errstate(over="ignore"):
            steep = (wide[:, :, UNIT + 1 :] / (MULTIPLES[UNIT + 1 :] - 1.0)).min(axis=2)
        parted = (values, left_out, steep, wide[:, :, UNIT], remainder)
        finished.append((low[good], high[good], origin[good], *(item[:, good] for item in parted)))
        if good.all():
            break
        # enough parts if the discs of the parts are as good as the disc of the piece
        with np.errstate(over="ignore"):
            enough = np.array([((wide * row).min(axis=2) <= allowed).all(axis=0) for row in REMAINDERS[1:]])
        parts = np.where(enough.any(axis=0), 2 ** (1 + enough.argmax(axis=0)), 16)[~good]
        step = (high - low)[~good] / parts
        owner = np.repeat(np.arange(parts.size), parts)
        number = np.arange(owner.size) - np.repeat(np.cumsum(parts) - parts, parts)
        first, last = low[~good][owner], high[~good][owner]
        low, high = first + number * step[owner], first + (number + 1.0) * step[owner]
        high = np.where(number == parts[owner] - 1, last, high)
        # neighbouring pieces share their end to the bit
        high[:-1] = np.where(number[1:] > 0, low[1:], high[:-1])
        origin = origin[~good][owner]
    all_low, owner = np.concatenate([part[0] for part in finished]), np.concatenate([part[2] for part in finished])
    order = np.lexsort((all_low, owner))
    return (
        all_low[order],
        np.concatenate([part[1] for part in finished])[order],
        owner[order],
        *(np.concatenate([part[index] for part in finished], axis=1)[:, order] for index in range(3, 8)),
    )
