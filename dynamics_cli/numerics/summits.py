"""The greatest value of a proxied function to the rounding of one evaluation: values at turning places, not proxies.

A proxy (`numerics.remainders`) tells where a function may be greatest; it errs itself by far more than one evaluation
of the function does. At a place where it turns, though, the function's value hardly depends on the place: what is left
is second order in the error of the proxy's slope, and the bound that of the value at the very place.
"""

from functools import lru_cache
from math import inf

import numpy as np

from dynamics_cli.numerics.chebyshev import ALIKE, NOISE, Proxies, extremes
from dynamics_cli.numerics.discs import UP
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# what the derivatives of a polynomial of 24 terms round by, of Σ k²|c| and Σ k⁴|c|
SLACK = (2.0**-44, 2.0**-43)


@record
class Summits:
    """Places that may hold the greatest value of a function.

    Parameters
    ----------
    rows : array
        The proxies' piece that each place lies in.
    units : array
        Where in that piece, between -1 and 1.
    gains : array
        How much greater than at its place the function may be about it; infinite where that is not known.
    tops : array of m
        What no value of the function on each of the pieces is above.
    errors : array of m
        What the proxies leave out on each piece.
    level : array of m
        Values of the proxy that places were looked for from, by pieces.
    """

    rows: "Any"
    units: "Any"
    gains: "Any"
    tops: "Any"
    errors: "Any"
    level: "Any"


@lru_cache(maxsize=2)
def _derivative(count: int) -> "Any":
    """The matrix that turns Chebyshev coefficients into those of the derivative."""
    made = np.zeros((count, count))
    for k in range(count):
        for j in range(k - 1, -1, -2):
            made[k, j] = 2.0 * k if j else 1.0 * k
    return made


def summits(made: Proxies, which: int = 0) -> "tuple[Summits, Summits]":
    """Find the places that may hold the greatest value of a function, and those that may hold its least.

    Parameters
    ----------
    made : Proxies
        The functions, their error proved.
    which : int
        Which of them.

    Returns
    -------
    (Summits, Summits)
        Of the function, and of the function upside down.

    Raises
    ------
    ValueError
        Never for finite coefficients.

    Notes
    -----
    On a piece, f = p + e, |e| ≤ E, |e′| ≤ D. Where p turns (its slope σ at most) and p″ ≤ −m/2 as far as r on either
    side, f is above its value there by (σ + D)h − ¼mh² ≤ (σ + D)²/m at most; at an end of the piece that p falls away
    from by a and more, by nothing if a > 2D. Whatever is not so near a place is below the level looked for: p rises
    from there to one of the places, and is below that level at r already. Pieces without such a proof keep p + E.

    Examples
    --------
    >>> from dynamics_cli.numerics.remainders import proved_proxies
    >>> made = proved_proxies(lambda x, piece: np.sin(x)[None], np.array([0.0]), np.array([3.0]))
    >>> float(summits(made)[0].gains[0]) < 1e-18
    True
    """
    whole = made.coefficients[which]
    small = made.error[which] * UP
    best = float(np.where(np.isfinite(small), small, 0.0)[_reaching(whole, small)].max(initial=0.0))
    with np.errstate(invalid="ignore"):
        margin = np.where(np.isfinite(small), 2.0 * small + 4.0 * best, 0.0)
    found = extremes(made, which, margin=margin)
    # the polynomial that was searched has no coefficients that are rounding alone
    sizes = np.abs(whole)
    searched = np.where(sizes > NOISE * sizes.sum(axis=1)[:, None], whole, 0.0)
    dropped = np.abs(whole - searched).sum(axis=1)
    steep = (np.full(small.shape, inf) if made.steep is None else made.steep[which]) + whole.shape[1] ** 2 * dropped
    # all that it is off, with the rounding of its values
    errors = small + found.off
    parts = []
    for sign in (1.0, -1.0):
        values = sign * found.values
        level = values.max() - margin
        tops = np.full(errors.shape, -inf)
        np.maximum.at(tops, found.rows, values)
        parts.append((sign, values, np.flatnonzero(values >= level[found.rows]), level, tops + errors))
    near = np.concatenate([part[2] for part in parts])
    signs, values, levels = (
        np.concatenate([np.broadcast_to(column(part), part[2].shape) for part in parts])
        for column in (lambda part: part[0], lambda part: part[1][part[2]], lambda part: part[3][found.rows[part[2]]])
    )
    rows, units = found.rows[near], found.units[near]
    gains = _gains(signs[:, None] * searched[rows], units, values + errors[rows] - levels, steep[rows])
    count = parts[0][2].size
    first, second = (
        Summits(rows[own], units[own], gains[own], part[4], errors, part[3])
        for own, part in zip((slice(count), slice(count, None)), parts, strict=True)
    )
    return first, second


def _reaching(whole: "Any", error: "Any") -> "Any":
    """Pieces that may hold the greatest or the least value, by what they have at their ends and middles."""
    count = whole.shape[1]
    k = np.arange(count)
    some = np.stack((whole @ np.where(k % 2, -1.0, 1.0), whole.sum(axis=1), whole @ np.cos(0.5 * np.pi * k)))
    room = np.abs(whole[:, 1:]).sum(axis=1)
    high, low = whole[:, 0] + room, whole[:, 0] - room
    return (high >= some.max()) | (low <= some.min())


def _gains(own: "Any", units: "Any", above: "Any", steep: "Any") -> "Any":
    """How much greater a function may be about places than at them, its proxy being `above` the level looked for."""
    count = own.shape[1]
    matrix, k = _derivative(count), np.arange(count, dtype=float)
    first = own @ matrix
    second = first @ matrix
    third = second @ matrix
    basis = np.cos(k * np.arccos(np.clip(units, -1.0, 1.0))[:, None])
    slack = [factor * (np.abs(own) @ k**power) for factor, power in zip(SLACK, (2, 4), strict=True)]
    slope, bend = (first * basis).sum(axis=1), (second * basis).sum(axis=1)
    # into the piece from its ends, either way from within
    slope = np.where(units == 1.0, -slope, np.where(units == -1.0, slope, np.abs(slope))) + slack[0]
    bent, twisted = np.abs(second).sum(axis=1) * UP + slack[1], np.abs(third).sum(axis=1) * UP
    with np.errstate(all="ignore"):
        m = -bend - slack[1]
        r = np.minimum(m / (2.0 * twisted), 2.0)
        up = np.maximum(slope, 0.0)
        smooth = (m > 0.0) & (above + up * r < 0.25 * m * r * r)
        gain = np.where(smooth, (up + steep) ** 2 / np.where(m > 0.0, m, 1.0), inf)
        a = -slope
        r = np.minimum(a / (2.0 * bent), 2.0)
        ending = (np.abs(units) == 1.0) & (a > 2.0 * steep) & (above < 0.5 * a * r)
    return np.where(ending, 0.0, np.where(np.isfinite(gain), gain, inf))


def settled(found: Summits, values: "Any", errors: "Any") -> "tuple[float, int, float]":
    """The greatest value, the first of the places that rounding cannot tell from it, and the bound of its error.

    Parameters
    ----------
    found : Summits
        The places.
    values : array
        The function at each of them.
    errors : array
        What each of these values may err by.

    Returns
    -------
    (float, int, float)
        The value, the index of its place, and what the greatest value may be off.

    Raises
    ------
    ValueError
        Never for finite values.

    Notes
    -----
    The greatest value is at least what is certain at the best place, and at most the most of what is possible at every
    place and on every piece without a proof of its own.

    Examples
    --------
    >>> from dynamics_cli.numerics.remainders import proved_proxies
    >>> made = proved_proxies(lambda x, piece: np.sin(x)[None], np.array([0.0]), np.array([3.0]))
    >>> top = summits(made)[0]
    >>> settled(top, np.array([1.0]), np.array([1e-16]))[2] < 2e-16
    True
    """
    best = float(values.max())
    index = int(np.argmax(values >= best - min(ALIKE * abs(best), float(found.errors[found.rows[values.argmax()]]))))
    sure = float((values - errors).max())
    # pieces whose proxy stays below what is certain hold nothing greater
    open_ = found.tops >= sure
    loose = np.zeros(found.tops.shape, dtype=bool)
    loose[found.rows[np.isinf(found.gains)]] = True
    # places were looked for from a level that has to be below what is certain, by the error of the piece
    loose |= found.level > sure - found.errors
    loose |= ~np.isfinite(found.errors)
    with np.errstate(invalid="ignore"):
        reach = float((values + errors + np.where(np.isinf(found.gains), -inf, found.gains)).max())
    rest = found.tops[open_ & loose]
    if rest.size:
        reach = max(reach, float(rest.max()))
    return best, index, max(reach - best, best - sure) * UP
