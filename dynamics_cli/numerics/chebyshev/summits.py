"""The maximum of a proxied function to the rounding of one evaluation, from its values at stationary points.

A proxy (`numerics.remainders`) shows where a function may be greatest, but its error is far larger than that of one
evaluation of the function. At a stationary point the value hardly depends on the place: its error is of second order in
the error of the proxy's slope, and the bound is the bound of the value there.
"""

from functools import lru_cache
from math import inf

import numpy as np

from dynamics_cli.numerics.chebyshev.proxies import ALIKE, NOISE, ROUNDING, Proxies, extremes
from dynamics_cli.numerics.discs import UP
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# number of nearly constant cells of a piece that are examined
CALM = 8
# more places than these are not compared with one another
COVERED = 256
# rounding of the derivatives of a polynomial of 24 terms, relative to Σ k²|c| and Σ k⁴|c|
SLACK = (2.0**-44, 2.0**-43)


@record
class Summits:
    """Places that may hold the greatest value of a function."""

    rows: Annotated["Any", "The proxies' piece that each place lies in."]
    units: Annotated["Any", "Where in that piece, between -1 and 1."]
    gains: Annotated["Any", "How much the function may exceed its value at the place nearby; infinite where unknown."]
    tops: Annotated["Any", "What no value of the function on each of the pieces is above."]
    errors: Annotated["Any", "What the proxies leave out on each piece."]
    level: Annotated["Any", "Values of the proxy that places were looked for from, by pieces."]
    loose: Annotated["Any", "Pieces about whose places nothing is known."]


@lru_cache(maxsize=2)
def _derivative(count: int) -> "Any":
    """The matrix from Chebyshev coefficients to those of the derivative."""
    matrix = np.zeros((count, count))
    for k in range(count):
        for j in range(k - 1, -1, -2):
            matrix[k, j] = 2.0 * k if j else 1.0 * k
    return matrix


def summits(
    proxy: Proxies, which: int = 0, still: "Any" = False, ways: "tuple[float, ...]" = (1.0, -1.0)
) -> "tuple[Summits, ...]":
    """Find the places that may be the maximum of a function, and those that may be its minimum.

    `proxy`: the functions, their error proved; `still`: pieces on which the functions are known to be constant; `ways`:
    1 for the greatest value, -1 for the least. Returns those of each way; for the least value, of the function upside
    down.

    On a piece, f = p + e, |e| ≤ E, |e′| ≤ D. Where p turns (its slope σ at most) and p″ ≤ −m/2 as far as r on either
    side, f is above its value there by (σ + D)h − ¼mh² ≤ (σ + D)²/m at most; at an end of the piece that p falls away
    from by a and more, by nothing if a > 2D. Elsewhere f is below the level sought: p rises from there to one of the
    places, and is below that level at r already. Where p hardly moves within a cell, r has to reach beyond the cell.
    Pieces without such a proof keep p + E.

    References
    ----------
    Derived: a parabola below the function about a place where its proxy turns.

    Examples
    --------
    >>> from dynamics_cli.numerics.chebyshev.remainders import proved_proxies
    >>> result = proved_proxies(lambda x, piece: np.sin(x)[None], np.array([0.0]), np.array([3.0]))
    >>> float(summits(result)[0].gains[0]) < 1e-18
    True
    """
    series = proxy.coefficients[which]
    slack = proxy.error[which] * UP
    # including the rounding of the proxies' values
    moving = np.abs(series[:, 1:]).sum(axis=1)
    wide = slack + 2.0 * ROUNDING * moving + 2.0**-50 * np.abs(series[:, 0])
    best = float(np.where(np.isfinite(wide), wide, 0.0)[_reaching(series)].max(initial=0.0))
    with np.errstate(invalid="ignore"):
        margin = np.where(np.isfinite(wide), 2.0 * wide + 4.0 * best, 0.0)
    # on a piece that varies by less than that, all places are equivalent
    even = (moving <= margin) & ~np.broadcast_to(still, margin.shape)
    candidates = extremes(proxy, which, margin=np.where(even, 0.0, margin))
    # the searched polynomial has no coefficients that are only rounding
    sizes = np.abs(series)
    searched = np.where(sizes > NOISE * sizes.sum(axis=1)[:, None], series, 0.0)
    dropped = np.abs(series - searched).sum(axis=1)
    steep = (np.full(slack.shape, inf) if proxy.steep is None else proxy.steep[which]) + series.shape[1] ** 2 * dropped
    # the whole error, with the rounding of the values
    errors = slack + candidates.off
    parts = []
    for sign in ways:
        values = sign * candidates.values
        level = values.max() - margin
        tops = np.full(errors.shape, -inf)
        np.maximum.at(tops, candidates.rows, values)
        near = values >= level[candidates.rows]
        # of many places where it hardly varies, one suffices
        calm = even | (np.bincount(candidates.rows[near & (candidates.about > 0.0)], minlength=even.size) > CALM)
        near &= ~calm[candidates.rows] | (values == tops[candidates.rows])
        tops = np.where(even, values.max(), tops) + errors
        parts.append((sign, values, np.flatnonzero(near), level, tops, calm))
    near = np.concatenate([part[2] for part in parts])
    rows = candidates.rows[near]
    signs = np.concatenate([np.full(part[2].shape, part[0]) for part in parts])
    values = np.concatenate([part[1][part[2]] for part in parts])
    levels = np.concatenate([part[3][candidates.rows[part[2]]] for part in parts])
    turned = signs[:, None] * searched[rows]
    units, widths = _nearer(turned, candidates.units[near], candidates.about[near])
    gains, wide = _gains(turned, units, values + errors[rows] - levels, steep[rows], widths)
    gains = _covered(gains, wide, widths, signs * (1.0 + rows), units, values)
    gains = np.where(np.broadcast_to(still, slack.shape)[rows], 0.0, gains)
    result, low = [], 0
    for part in parts:
        cut = slice(low, low + part[2].size)
        low, loose = cut.stop, part[5] | ~np.isfinite(errors)
        loose[rows[cut][np.isinf(gains[cut])]] = True
        result.append(Summits(rows[cut], units[cut], gains[cut], part[4], errors, part[3], loose))
    return tuple(result)


def _reaching(series: "Any") -> "Any":
    """Pieces that may contain the maximum or minimum, judged by their ends and middles."""
    count = series.shape[1]
    k = np.arange(count)
    samples = np.stack((series @ np.where(k % 2, -1.0, 1.0), series.sum(axis=1), series @ np.cos(0.5 * np.pi * k)))
    swing = np.abs(series[:, 1:]).sum(axis=1)
    high, low = series[:, 0] + swing, series[:, 0] - swing
    return (high >= samples.max()) | (low <= samples.min())


def _nearer(series: "Any", units: "Any", about: "Any") -> "tuple[Any, Any]":
    """Places in cells where a function hardly varies, moved towards a stationary point by two Newton steps."""
    calm = about > 0.0
    if not calm.any():
        return units, about
    matrix, k = _derivative(series.shape[1]), np.arange(series.shape[1])
    first = series[calm] @ matrix
    second, place = first @ matrix, units[calm]
    for _ in range(2):
        basis = np.cos(k * np.arccos(place)[:, None])
        bend = (second * basis).sum(axis=1)
        step = np.where(bend < 0.0, -(first * basis).sum(axis=1) / np.where(bend < 0.0, bend, 1.0), 0.0)
        place = np.clip(place + np.clip(step, -about[calm], about[calm]), -1.0, 1.0)
    refined, wide = units.copy(), about.copy()
    wide[calm] += np.abs(place - units[calm])
    refined[calm] = place
    return refined, wide


def _gains(series: "Any", units: "Any", above: "Any", steep: "Any", about: "Any") -> "tuple[Any, Any]":
    """Largest increase of a function near places, and the distance to each side for which it is proved.

    `above`: height of the proxy above the level sought.
    """
    count = series.shape[1]
    matrix, k = _derivative(count), np.arange(count, dtype=float)
    first = series @ matrix
    second = first @ matrix
    third = second @ matrix
    basis = np.cos(k * np.arccos(np.clip(units, -1.0, 1.0))[:, None])
    slack = [factor * (np.abs(series) @ k**power) for factor, power in zip(SLACK, (2, 4), strict=True)]
    slope, bend = (first * basis).sum(axis=1), (second * basis).sum(axis=1)
    # into the piece from its ends, either way from within
    slope = np.where(units == 1.0, -slope, np.where(units == -1.0, slope, np.abs(slope))) + slack[0]
    bent, twisted = np.abs(second).sum(axis=1) * UP + slack[1], np.abs(third).sum(axis=1) * UP
    with np.errstate(all="ignore"):
        m = -bend - slack[1]
        r = np.minimum(m / (2.0 * twisted), 2.0)
        up = np.maximum(slope, 0.0)
        smooth = (m > 0.0) & (r > about) & (above + up * r < 0.25 * m * r * r)
        gain = np.where(smooth, (up + steep) ** 2 / np.where(m > 0.0, m, 1.0), inf)
        a = -slope
        fall = np.minimum(a / (2.0 * bent), 2.0)
        ending = (np.abs(units) == 1.0) & (a > 2.0 * steep) & (above < 0.5 * a * fall)
    gain = np.where(np.isfinite(gain), gain, inf)
    return np.where(ending, 0.0, gain), np.where(gain < inf, r, 0.0)


def _covered(gains: "Any", wide: "Any", about: "Any", rows: "Any", units: "Any", values: "Any") -> "Any":
    """The same gains, but zero for a place within the proved range of the best place of its piece."""
    if not 1 < gains.size <= COVERED:
        return gains
    same = rows[:, None] == rows
    # only the bound about the best place of a piece counts: no other place covers it
    first = ~(same & (values[:, None] > values)).any(axis=0)
    within = np.abs(units[:, None] - units) + about < wide[:, None]
    return np.where((same & first[:, None] & within).any(axis=0) & ~first, 0.0, gains)


def doubtful(summits_known: Summits, sure: float) -> "Any":
    """Pieces (m booleans) that may exceed `sure` and have no proof about their places."""
    # the level of the search must be below the certain value by the error of the piece
    return (summits_known.tops >= sure) & (summits_known.loose | (summits_known.level > sure - summits_known.errors))


def settled(summits_known: Summits, values: "Any", errors: "Any") -> "tuple[float, int, float]":
    """The maximum, the first of its places that are equal within rounding, and its error bound.

    `summits_known`: places; `values`: the function at each of them; `errors`: the error bound of each value. Returns
    the value, the index of its place, and the error bound of the maximum.

    The maximum is at least the certain value at the best place, and at most the largest possible value at every place
    and on every piece without its own proof.

    Examples
    --------
    >>> from dynamics_cli.numerics.chebyshev.remainders import proved_proxies
    >>> result = proved_proxies(lambda x, piece: np.sin(x)[None], np.array([0.0]), np.array([3.0]))
    >>> top = summits(result)[0]
    >>> settled(top, np.array([1.0]), np.array([1e-16]))[2] < 2e-16
    True
    """
    best = float(values.max())
    index = int(
        np.argmax(
            values >= best - min(ALIKE * abs(best), float(summits_known.errors[summits_known.rows[values.argmax()]]))
        )
    )
    sure = float((values - errors).max())
    loose = doubtful(summits_known, sure)
    with np.errstate(invalid="ignore"):
        reach = values + errors + np.where(np.isinf(summits_known.gains), 0.0, summits_known.gains)
        # the bound of the piece's proxy may be smaller
        reach = float(np.maximum(values + errors, np.minimum(reach, summits_known.tops[summits_known.rows])).max())
    rest = summits_known.tops[loose]
    if rest.size:
        reach = max(reach, float(rest.max()))
    return best, index, max(reach - best, best - sure) * UP
