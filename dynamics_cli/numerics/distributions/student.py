"""Student's t: tail and quantile for any degrees of freedom, one number at a time, and a table for arrays.

A standard normal z and the t of the same tail probability belong together; t(z) is odd and log(t/z) is smooth, so a
piecewise Chebyshev table of it serves whole arrays.
"""

import math

import numpy as np

from dynamics_cli.numerics.distributions import normal
from dynamics_cli.numerics.distributions.normal_arrays import tail

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# The table reaches so far in z (a tail of 1e-19) in steps of one, with polynomials of this degree.
_REACH = 9
_DEGREE = 15
_tables: "dict[float, Array]" = {}


def upper(t: float, freedom: float) -> float:
    """P(T > t) for t ≥ 0.

    References
    ----------
    NIST Digital Library of Mathematical Functions, section 8.17 (Student's t as an incomplete beta function).
    """
    if t == 0.0:
        return 0.5
    square = t * t
    total = freedom + square
    near = freedom < square * (freedom + 2.0)
    # ½ I_x(ν/2, ½) with x = ν/(ν + t²), from whichever end the continued fraction converges fast.
    if near:
        front = _front(freedom, t) * 2.0 / freedom
        return 0.5 * front * incomplete_fraction(0.5 * freedom, 0.5, freedom / total)
    return 0.5 - _front(freedom, t) * incomplete_fraction(0.5, 0.5 * freedom, square / total)


def density(t: float, freedom: float) -> float:
    """The density of T."""
    return _at_zero(freedom) * math.exp(-0.5 * (freedom + 1.0) * math.log1p(t * t / freedom))


def quantile(z: float, freedom: float) -> float:
    """The t with P(T > t) = P(Z > z)."""
    if z < 0.0:
        return -quantile(-z, freedom)
    if z == 0.0:
        return 0.0
    return _solve(z, freedom, z)


def quantiles(z: "Array", freedom: float) -> "Array":
    """The quantile for an array of z."""
    x = np.abs(z)
    if freedom == 1.0:
        with np.errstate(over="ignore", divide="ignore"):
            return np.copysign(1.0 / np.tan(math.pi * tail(x)), z) * (x > 0.0)
    if freedom == 2.0:
        q = tail(x)
        return np.copysign((1.0 - 2.0 * q) / np.sqrt(2.0 * q * (1.0 - q)), z)
    if freedom not in _tables:
        _tables[freedom] = _table(freedom)
    table = _tables[freedom]
    piece = np.minimum(x.astype(np.int64), _REACH - 1)
    local = 2.0 * (np.minimum(x, _REACH) - piece) - 1.0
    total = table[_DEGREE][piece]
    for k in range(_DEGREE - 1, -1, -1):
        total = total * local + table[k][piece]
    t = z * np.exp(total)
    far = x > _REACH
    if far.any():
        t[far] = [quantile(value, freedom) for value in z[far].tolist()]
    return t  # type: ignore[no-any-return]


def _solve(z: float, freedom: float, guess: float) -> float:
    """Newton on the logarithm of the tail by log t, nearly straight at both ends."""
    target = normal.upper(z)
    t = guess
    for _ in range(100):
        tail = upper(t, freedom)
        if z < 1.0:
            step = (tail - target) / density(t, freedom)
        else:
            slope = t * density(t, freedom) / tail
            step = t * math.expm1(max(min(math.log(tail / target) / slope, 2.0), -2.0))
        t = max(t + step, 0.25 * t)
        if abs(step) <= 4e-16 * t:
            break
    return t


def _table(freedom: float) -> "Array":
    """Coefficients by powers of the local coordinate: (degree + 1, pieces)."""
    angles = math.pi * (2 * np.arange(_DEGREE + 1) + 1) / (2 * (_DEGREE + 1))
    local = np.cos(angles)
    order = np.argsort(local)
    values = np.empty((_DEGREE + 1, _REACH))
    z, t = 0.0, 0.0
    for piece in range(_REACH):
        for k in order.tolist():
            target = piece + 0.5 * (1.0 + float(local[k]))
            # dt/dz = φ(z)/f(t): a step along it is a good first guess.
            slope = normal.density(z) / density(t, freedom)
            z, t = target, _solve(target, freedom, t + slope * (target - z))
            values[k, piece] = math.log(t / z)
    chebyshev = np.cos(np.outer(np.arange(_DEGREE + 1), angles)) @ values * (2.0 / (_DEGREE + 1))
    chebyshev[0] *= 0.5
    return powers_of(chebyshev)


def powers_of(chebyshev: "Array") -> "Array":
    """The same polynomials by powers."""
    count = len(chebyshev)
    powers = np.zeros_like(chebyshev)
    before, now = np.zeros(count), np.zeros(count)
    before[0] = 1.0
    now[1] = 1.0
    powers += np.outer(before, chebyshev[0])
    for k in range(1, count):
        powers += np.outer(now, chebyshev[k])
        after = -before
        after[1:] += 2.0 * now[:-1]
        before, now = now, after
    return powers


def _at_zero(freedom: float) -> float:
    """Γ((ν+1)/2)/(√(νπ) Γ(ν/2)); a product for whole ν, where lgamma would lose digits."""
    if freedom == int(freedom) and freedom < 2000:
        start, ratio = (2, 1.0 / math.pi) if int(freedom) % 2 else (3, 0.5)
        for n in range(start, int(freedom) + 1, 2):
            ratio *= n / (n - 1.0)
        return ratio / math.sqrt(freedom)
    half = 0.5 * freedom
    return math.exp(math.lgamma(half + 0.5) - math.lgamma(half)) / math.sqrt(math.pi * freedom)


def _front(freedom: float, t: float) -> float:
    """x^{ν/2} (1 − x)^{1/2}/B(ν/2, ½), x = ν/(ν + t²)."""
    return _at_zero(freedom) * t * math.exp(-0.5 * (freedom + 1.0) * math.log1p(t * t / freedom))


def incomplete_fraction(a: float, b: float, x: float) -> float:
    """The continued fraction of the incomplete beta function by Lentz's method (DLMF 8.17.22).

    References
    ----------
    NIST Digital Library of Mathematical Functions, 8.17.22; Lentz's method: W. H. Press et al., Numerical
    Recipes, 3rd ed., Cambridge 2007, section 5.2.
    """
    tiny = 1e-300
    c = 1.0
    d = 1.0 - (a + b) * x / (a + 1.0)
    d = 1.0 / (d if abs(d) > tiny else tiny)
    total = d
    for m in range(1, 2000):
        for numerator in (
            m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m)),
            -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0)),
        ):
            d = 1.0 + numerator * d
            d = 1.0 / (d if abs(d) > tiny else tiny)
            c = 1.0 + numerator / (c if abs(c) > tiny else tiny)
            total *= d * c
        if abs(d * c - 1.0) < 1e-16:
            break
    return total
