"""Proved bounds of every law and its derivatives: on the whole of a piece, around a place, and of their rounding.

Whatever formula a shape is computed by, it is a polynomial and waves: p(τ) + Σ A W_m(wτ), W₀ = u − sin u and W_m its
derivatives. All bounds come from these constants; nothing is inferred from values.

- On |τ| ≤ T, |f⁽ᵏ⁾| ≤ Σ |cᵢ| i!/(i − k)! Tⁱ⁻ᵏ + Σ |A| wᵏ |W|, with |W₀| ≤ u, |W₁| ≤ min(2, u²/2), |W_m| ≤ 1.
- Around a place, |f(τ + z) − f(τ)| ≤ Σ |f⁽ʲ⁾(τ)| rʲ/j! for every complex z of magnitude r or less: the finite sum for
  the polynomial, and |W′| sinh(wr) + |W″| (cosh(wr) − 1) for a wave, the terms in r added up before magnitudes are
  taken. To first order nothing tighter is possible.
- Rounding at single places is followed step by step (`cam.proof.law_rounding`). Over rows of places, u = 2⁻⁵³, factors
  lift/spanᵏ (11 u) among it: of a polynomial (2i + 20) u for the term of degree i, Horner's 2i + 1, the coefficient's
  7; of powers of p = t(1 − t), products of numbers each within 2 u, 24 u of the magnitudes multiplied (20 u for the
  lift); of waves, sines and cosines of half the angle within four units in the last place, |A| wᵏ (64 + 4 wT) u.
  Places: t ≤ 1 as a share of the zone by six roundings of u/2, as a cam angle by five of u t.

The exact law of a name has its constants as its formula has them, π and all; a polynomial has the rational solution of
its conditions; a clamped spline has the coefficients it was given.
"""

from math import cos, perm, sin

from dynamics_cli.cam.laws.components import Beta, u_minus_sine

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


U = 2.0**-53
# relative error by which intermediate magnitudes may be too small
LESS = 2.0**-44
UP = 1.0 + 2.0**-40


def bound(shape: "Any", order: int, reach: float) -> float:
    """Bound of a derivative of a shape where its own coordinate τ is within ±reach.

    `shape`: shape of a law's piece; `order`: which derivative, from 0; `reach`: largest |τ|, τ = t less the shape's
    origin. Returns an upper bound of the magnitude.

    The triangle inequality; sharp where the terms do not cancel.

    Examples
    --------
    >>> from dynamics_cli.cam.laws.components import Beta
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
    """Rounding error bound of a derivative of a shape at an exact place within ±reach, its scale included."""
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
    """Largest change of f and its derivatives within complex discs about t (arrays).

    `shape`: shape of a law's piece; `t`, `radius`: places and the radii about them, broadcast; `derivatives`:
    how many derivatives. Returns a bound for f and for each derivative, in rows.

    Taylor's series with the magnitudes of its coefficients, each taken a little too large.

    Examples
    --------
    >>> import numpy as np
    >>> from dynamics_cli.cam.laws.components import Mixed
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
        # terms of the slopes: that of u − sin u, and sines and cosines
        trio = np.empty((3, *u.shape))
        trio[1], trio[2] = np.sin(u), np.cos(u)
        trio[0] = 1.0 - trio[2]
        half = np.sinh(0.5 * v)
        # cosh v − 1, and v (cosh v − 1), above sinh v − v
        bent = 2.0 * half * half
        beyond = v * bent
        sine, cosine = np.abs(trio[1:]) + LESS
        more = np.stack((cosine * beyond + sine * bent, sine * beyond + cosine * bent))
        which = [start + order for order in orders]
        factors = [amplitude * w**order for order in orders]
        signed = [
            factor * w * (1.0 if k % 4 in (1, 2) or not k else -1.0) for factor, k in zip(factors, which, strict=True)
        ]
        slopes = slopes + np.array(signed).reshape(column) * trio[[2 - k % 2 if k else 0 for k in which]]
        sizes = np.abs(np.array(factors).reshape(column))
        slack, rest = slack + LESS * w * sizes, rest + sizes * more[[k % 2 for k in which]]
    return ((np.abs(slopes) + slack) * radius + rest) * UP


def _polynomial_spreads(coefficients: "Any", tau: "Any", radius: "Any", derivatives: int) -> "tuple[Any, ...]":
    """Slopes of a polynomial and its derivatives, the addition to their magnitudes, and the higher terms."""
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
