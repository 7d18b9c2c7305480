"""Proved bounds of every law and its derivatives: on the whole of a piece, around a place, and of their rounding.

Whatever formula a shape is computed by, it is a polynomial and waves: p(τ) + Σ A W_m(wτ), W₀ = u − sin u and W_m its
derivatives. All bounds come from these constants; nothing is inferred from values.

- On |τ| ≤ T, |f⁽ᵏ⁾| ≤ Σ |cᵢ| i!/(i − k)! Tⁱ⁻ᵏ + Σ |A| wᵏ |W|, with |W₀| ≤ u, |W₁| ≤ min(2, u²/2), |W_m| ≤ 1.
- Around a place, |f(τ + z) − f(τ)| ≤ Σ |f⁽ʲ⁾(τ)| rʲ/j! for every complex z of magnitude r or less: the finite sum for
  the polynomial, and |W′| sinh(wr) + |W″| (cosh(wr) − 1) for a wave, the terms in r added up before magnitudes are
  taken. To first order nothing tighter is possible.
- Rounding at single places is followed step by step (`cam.slips`). Over rows of places, u = 2⁻⁵³, factors lift/spanᵏ
  (11 u) among it: of a polynomial (2i + 20) u for the term of degree i, Horner's 2i + 1, the coefficient's 7; of powers
  of p = t(1 − t), products of numbers each within 2 u, 24 u of the magnitudes multiplied (20 u for the lift); of waves,
  sines and cosines of half the angle within four units in the last place, |A| wᵏ (64 + 4 wT) u. Places: t ≤ 1 as a
  share of the zone by six roundings of u/2, as a cam angle by five of u t.

The exact law of a name has its constants as its formula has them, π and all; a polynomial has the rational solution of
its conditions; a clamped spline has the coefficients it was given.
"""

from functools import lru_cache
from math import cos, perm, sin

from dynamics_cli.cam.shapes import Beta, u_minus_sine
from dynamics_cli.cam.slips import HALVES, HALVES_OF_FLOATS
from dynamics_cli.cam.slips import slips as running_slips

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.cam.motion import Motion
    from dynamics_cli.numerics.discs import Disc

U = 2.0**-53
# what magnitudes computed on the way may be too small by
LESS = 2.0**-44
UP = 1.0 + 2.0**-40
# so many places are computed one by one, by the more exact functions of the C library
SINGLE = 256
# and so many are followed one by one
SCALARS = 6


def bound(shape: "Any", order: int, reach: float) -> float:
    """Bound of a derivative of a shape where its own coordinate τ is within ±reach.

    Parameters
    ----------
    shape : shape
        What a law's piece is made of.
    order : int
        Which derivative, from 0.
    reach : float
        Largest |τ|, τ = t less the shape's origin.

    Returns
    -------
    float
        No magnitude is larger.

    Raises
    ------
    ValueError
        Never for finite numbers.

    Notes
    -----
    The triangle inequality; sharp where the terms do not cancel.

    Examples
    --------
    >>> from dynamics_cli.cam.shapes import Beta
    >>> bound(Beta(2), 2, 0.5) >= 60 * 0.25 * 0.5
    True
    """
    coefficients, waves, _, _ = shape.parts
    total: float = _polynomial_size(coefficients, order, reach)
    if 0 < order < 5 and isinstance(shape, Beta):
        total = min(total, shape.largest(order))
    for amplitude, w, start in waves:
        u, which = w * reach, start + order
        size = u if which == 0 else min(2.0, 0.5 * u * u) if which == 1 else 1.0
        total += abs(amplitude) * w**order * size
    return total * UP


def rounding(shape: "Any", order: int, reach: float) -> float:
    """Bound of what rounding does to a derivative of a shape at an exact place within ±reach, its scale included."""
    coefficients, waves, _, _ = shape.parts
    if isinstance(shape, Beta):
        size = 24.0 * shape.size(order) if 0 < order < 5 else 20.0 * _polynomial_size(coefficients, order, reach)
        return U * size
    total = 64.0 * U * _polynomial_size(coefficients, order, reach)
    for amplitude, w, _ in waves:
        total += U * abs(amplitude) * w**order * (80.0 + 12.0 * w * reach)
    return total


def derivative(shape: "Any", order: int, t: float) -> float:
    """A derivative of any order of a shape at a place, within `rounding` of it."""
    coefficients, waves, origin, backwards = shape.parts
    tau = origin - t if backwards else t - origin
    total = 0.0
    for i in range(len(coefficients) - 1, order - 1, -1):
        total = total * tau + perm(i, order) * coefficients[i]
    for amplitude, w, start in waves:
        u, which = w * tau, start + order
        if which == 0:
            wave = u_minus_sine(u)
        elif which == 1:
            wave = 2.0 * sin(0.5 * u) ** 2
        else:
            # sin, cos, −sin, −cos, …
            wave = (sin(u), cos(u))[which % 2] * (1.0 if (which - 2) % 4 < 2 else -1.0)
        total += amplitude * w**order * wave
    return -total if backwards and order % 2 else total


def reach_of(shape: "Any", ends: "tuple[float, float]") -> float:
    """Largest |τ| between two places of the shape's coordinate t."""
    origin: float = shape.parts[2]
    return max(abs(ends[0] - origin), abs(ends[1] - origin))


def _polynomial_size(coefficients: "Any", order: int, reach: float) -> float:
    return float(sum(abs(c) * perm(i, order) * reach ** (i - order) for i, c in enumerate(coefficients) if i >= order))


def spreads(shape: "Any", t: "Any", radius: "Any", derivatives: int) -> "Any":
    """How far f and its derivatives may be, within complex discs about t, from what they are at t (arrays).

    Parameters
    ----------
    shape : shape
        What a law's piece is made of.
    t, radius : array
        Places, and radii that go together with them.
    derivatives : int
        How many derivatives.

    Returns
    -------
    array
        A bound for f and for each derivative, in rows.

    Raises
    ------
    ValueError
        Never for finite numbers.

    Notes
    -----
    Taylor's series with the magnitudes of its coefficients, each taken a little too large.

    Examples
    --------
    >>> import numpy as np
    >>> from dynamics_cli.cam.shapes import Mixed
    >>> [round(float(part[0]), 9) for part in spreads(Mixed((0.0, 0.0, 3.0)), np.ones(1), 0.1 * np.ones(1), 2)]
    [0.63, 0.6, 0.0]
    """
    import numpy as np

    coefficients, waves, origin, backwards = shape.parts
    tau = origin - t if backwards else t - origin
    # terms may cancel in the slope: they are added up before magnitudes are taken
    slopes, slack, rest = _polynomial_spreads(coefficients, tau, radius, derivatives)
    orders = range(derivatives + 1)
    column = (-1, *([1] * tau.ndim))
    for amplitude, w, start in waves:
        u, v = w * tau, w * radius
        # what the slopes are made of: that of u − sin u, and sines and cosines
        made = np.empty((3, *u.shape))
        made[1], made[2] = np.sin(u), np.cos(u)
        made[0] = 1.0 - made[2]
        half = np.sinh(0.5 * v)
        # cosh v − 1, and v (cosh v − 1), above sinh v − v
        bent = 2.0 * half * half
        beyond = v * bent
        sine, cosine = np.abs(made[1:]) + LESS
        more = np.stack((cosine * beyond + sine * bent, sine * beyond + cosine * bent))
        which = [start + order for order in orders]
        factors = [amplitude * w**order for order in orders]
        signed = [
            factor * w * (1.0 if k % 4 in (1, 2) or not k else -1.0) for factor, k in zip(factors, which, strict=True)
        ]
        slopes = slopes + np.array(signed).reshape(column) * made[[2 - k % 2 if k else 0 for k in which]]
        sizes = np.abs(np.array(factors).reshape(column))
        slack, rest = slack + LESS * w * sizes, rest + sizes * more[[k % 2 for k in which]]
    return ((np.abs(slopes) + slack) * radius + rest) * UP


def _polynomial_spreads(coefficients: "Any", tau: "Any", radius: "Any", derivatives: int) -> "tuple[Any, ...]":
    """Slopes of a polynomial and its derivatives, what is added to their magnitudes, and the terms beyond the first."""
    import numpy as np

    degree, nothing = len(coefficients) - 1, 0.0 * tau
    slopes, slack = np.zeros((derivatives + 1, *tau.shape)), np.zeros((derivatives + 1, *([1] * tau.ndim)))
    rest = np.zeros((derivatives + 1, *np.broadcast_shapes(tau.shape, np.shape(radius))))
    if degree < 2:
        if degree == 1:
            slopes[0] = coefficients[1]
        return slopes, slack, rest
    rows = [tuple(coefficients)]
    for _ in range(degree):
        rows.append(tuple(i * c for i, c in enumerate(rows[-1]))[1:])
    reach = float(abs(tau).max()) if tau.size else 0.0
    values, less = [nothing], [0.0]
    for order in range(1, degree + 1):
        total = nothing + rows[order][-1]
        for c in rows[order][-2::-1]:
            total = total * tau + c
        values.append(total)
        less.append(LESS * _polynomial_size(coefficients, order, reach))
    sizes = [abs(value) + more for value, more in zip(values, less, strict=True)]
    for order in range(min(derivatives + 1, degree)):
        slopes[order], slack[order] = values[order + 1], less[order + 1]
        wide = rest[order]
        for j in range(degree - order, 1, -1):
            wide = (wide + sizes[order + j]) * (radius / j)
        rest[order] = wide * radius
    return slopes, slack, rest


@lru_cache(maxsize=64)
def _terms(coefficients: "tuple[float, ...]", orders: int) -> "tuple[Any, Any]":
    """Magnitudes of the coefficients of a polynomial and its derivatives, and units that their terms round by."""
    import numpy as np

    count = len(coefficients)
    sizes, slips = np.zeros((orders, count)), np.zeros((orders, count))
    for order in range(orders):
        for i in range(order, count):
            sizes[order, i - order] = abs(coefficients[i]) * perm(i, order)
            slips[order, i - order] = (2.0 * i + 20.0) * sizes[order, i - order]
    return sizes, slips


def _slips(shape: "Any", reach: "Any", t: "Any", offset: "Any", derivatives: int) -> "list[Any]":
    """Bounds of what roundings of the computation and of the place do to f and derivatives, by rows (arrays)."""
    import numpy as np

    coefficients, waves, _, _ = shape.parts
    orders = derivatives + 2
    sizes = rounded = np.zeros((orders, reach.size))
    if coefficients:
        terms, slips = _terms(tuple(coefficients), orders)
        powers = reach ** np.arange(len(coefficients))[:, None]
        sizes, rounded = terms @ powers, slips @ powers
        if isinstance(shape, Beta):
            whole = sizes.copy()
            for order in range(1, min(orders, 5)):
                sizes[order] = np.minimum(whole[order], shape.largest(order))
            for order, size in enumerate(whole):
                rounded[order] = 20.0 * size if order in (0, 5) else 24.0 * np.minimum(size, shape.size(order))
    for amplitude, w, start in waves:
        u = w * reach
        # below one u − sin u is a series, beyond it a difference; the others keep their digits
        most = np.ones((start + orders + 1, reach.size))
        most[0] = np.where(u < 1.0, u * u * u / 6.0, 1.0 + u)
        most[1], most[2] = np.minimum(2.0, 0.5 * u * u), np.minimum(1.0, u)
        size, steep = most[start:-1], most[start + 1 :]
        factor = np.array([[abs(amplitude) * w**order] for order in range(orders)])
        sizes = sizes + factor * size
        rounded = rounded + factor * (64.0 * size + 4.0 * u * steep)
    off = getattr(shape, "off", 0.0)
    place = U * (5.0 * t + offset) + off
    return [
        U * rounded[order] + 8.0 * off * sizes[order] + place * sizes[order + 1] for order in range(derivatives + 1)
    ]


class Parts:
    """Parts of a motion as arrays: what discs of them are made from.

    Parameters
    ----------
    parts : sequence
        Parts of a motion, as `Motion.parts_of` gives them.
    """

    __slots__ = ("base", "ends", "inner", "members", "off", "scales", "span")

    def __init__(self, parts: "Sequence[Any]") -> None:
        import numpy as np

        laws = [part.law_piece for part in parts]
        self.base, self.off, self.span = (
            np.array([getattr(part, name) for part in parts]) for name in ("base", "off", "span")
        )
        self.scales = np.array([part.scales for part in parts])
        self.ends = np.array([(0.0, 0.0) if law is None else law.ends for law in laws])
        self.inner = np.array([law is not None and min(law.ends) > 0.0 for law in laws])
        shapes: dict[int, list[int]] = {}
        for index, law in enumerate(laws):
            shapes.setdefault(id(None if law is None else law.shape), []).append(index)
        # the shape of a dwell is none
        self.members = []
        for own in shapes.values():
            among = np.zeros(len(laws), dtype=bool)
            among[own] = True
            law = laws[own[0]]
            self.members.append((None if law is None else law.shape, among))


def discs(
    parts: "Parts", which: "Any", t: "Any", radius: "Any", derivatives: int, *, shares: bool = False,
    exact: bool = False, singly: int = SINGLE,
) -> "tuple[Disc, ...]":  # fmt: skip
    """Discs of lift and derivatives by cam angle, each row of places by its part of the motion.

    Parameters
    ----------
    parts : Parts
        Parts of a motion.
    which : array (m,)
        The part of each row.
    t : array (m, n) or (m,)
        Places in the parts' own coordinates, within their ends.
    radius : array (m, k) or (m,)
        How far about the places, as cam angles [rad]; k may differ from n where one of them is 1.
    derivatives : int
        How many derivatives, 0 to 4.
    shares : bool
        Whether places come from shares of a zone, whose ends are exact, and not from cam angles.
    exact : bool
        Whether places are what they are, and only ends of parts among them rounded.
    singly : int
        So many places (m,) are computed one by one where they are what they are, by the more exact functions of the
        C library; others where it is more than usual.

    Returns
    -------
    tuple of Disc
        s, ds/dθ, …: centres as computed, radii with all roundings in them.

    Raises
    ------
    ValueError
        Never for finite numbers.

    Notes
    -----
    A part is one analytic function, so that discs may reach over its ends.

    Examples
    --------
    >>> import numpy as np
    >>> from dynamics_cli.cam.program import Program, motion_of
    >>> motion = motion_of(Program(), "rise 20 mm in 90 deg cycloidal; return in 270 deg cycloidal")
    >>> one = np.zeros(1, dtype=int)
    >>> lift = discs(Parts(motion.parts_of(0)), one, np.array([0.5]), np.array([0.1]), 0)[0]
    >>> float(lift.centre[0]), bool(0.002 < lift.radius[0] < 0.003)
    (0.01, True)
    """
    import numpy as np

    from dynamics_cli.numerics.discs import Disc

    column = (-1, *([1] * (t.ndim - 1)))
    centres = np.zeros((derivatives + 1, *t.shape))
    only = not radius.any()
    radii = np.zeros((derivatives + 1, *np.broadcast_shapes(t.shape, radius.shape)))
    for shape, among in parts.members:
        rows = np.flatnonzero(among[which])
        own = which[rows]
        if not own.size:
            continue
        base, off_base = parts.base[own].reshape(column), parts.off[own].reshape(column)
        if shape is None:
            centres[0, rows], radii[0, rows] = base, off_base
            continue
        places, scales = t[rows], parts.scales[own]
        single = (exact or singly > SINGLE) and t.ndim == 1 and rows.size <= singly
        values = _one_by_one(shape, places, derivatives) if single else shape(places, derivatives)
        about = None if only else radius[rows] / parts.span[own].reshape(column) * UP
        wide = [0.0] * 5 if only else spreads(shape, places, about, derivatives)
        offset = np.where(parts.inner[own] | (not shares), 3.0, 0.0)
        if t.ndim == 1:
            near = np.abs(places)
            off = U * (5.0 * near + offset)
            if exact:
                ends = parts.ends[own]
                off = np.where((ends[:, 0] == places) | (ends[:, 1] == places), 2.0 * U * near, 0.0)
            slips = _running(shape, places, off, derivatives, single=single)
            # the lift's factor and its product count two roundings, each division by the span two more
            slips = [
                slip + (2.0 + 2.0 * order) * U * np.abs(value)
                for order, (slip, value) in enumerate(zip(slips, values, strict=True))
            ]
        else:
            # the place itself is off by a few roundings: bounds hold a hair beyond it
            reach = np.abs(places - shape.parts[2]) + 2.0**-49
            slips = _slips(shape, reach.max(axis=1), np.abs(places).max(axis=1), offset, derivatives)
        # what the ends of a segment are off its lift is too
        whole = np.abs(scales[:, 0].reshape(column))
        share = off_base / np.where(whole > 0.0, whole, 1.0)
        for order in range(derivatives + 1):
            scale = scales[:, order].reshape(column)
            centre = scale * values[order]
            centres[order, rows] = centre + base if order == 0 else centre
            size = off_base + np.where(base, U * np.abs(centres[0, rows]), 0.0) if order == 0 else 0.0
            slip = slips[order].reshape(column) + share * np.abs(values[order])
            radii[order, rows] = (np.abs(scale) * (wide[order] + slip) + size) * UP
    return tuple(Disc(centre, wide) for centre, wide in zip(centres, radii, strict=True))


def _running(shape: "Any", t: "Any", off: "Any", derivatives: int, *, single: bool) -> "Any":
    """Running bounds at places (n,): a few are followed one by one, which takes floats a tenth of the time."""
    import numpy as np

    halves = HALVES_OF_FLOATS if single else HALVES
    if not 0 < t.size <= SCALARS:
        return running_slips(shape, t, off, derivatives, halves)
    pairs = zip(t.tolist(), off.tolist(), strict=True)
    return np.array([running_slips(shape, place, slip, derivatives, halves) for place, slip in pairs]).T


def _one_by_one(shape: "Any", t: "Any", derivatives: int) -> "Any":
    import numpy as np

    return np.array([shape(place, derivatives) for place in t.tolist()]).T


def about_angles(motion: "Motion", index: int, theta: "Any", radius: "Any", derivatives: int) -> "tuple[Disc, ...]":
    """Discs about cam angles (n,) of one zone of a motion, which are taken as exact and need not be within the zone."""
    import numpy as np

    parts = motion.parts_of(index)
    which = np.zeros(theta.shape, dtype=int)
    t = theta if parts[0].law_piece is None else parts[0].local(theta)
    for number, part in enumerate(parts[1:], 1):
        other = part.local(theta)
        # measured from the other end, or further along
        here = (1.0 - other if part.law_piece.far else other) >= part.law_piece.low
        which[here], t[here] = number, other[here]
    return discs(Parts(parts), which, t, radius, derivatives)
