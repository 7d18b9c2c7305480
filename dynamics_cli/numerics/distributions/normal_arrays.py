"""The normal distribution for arrays: tails, density, quantile, in numpy's own loops.

The tail is one polynomial without branches; its coefficients come from tests/references/generate_normal_tables.py.
"""

import math
from math import erfc

import numpy as np

from dynamics_cli.numerics.distributions.normal import CENTRE, FAR, NEAR

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

_DENSITY_AT_ZERO = 0.3989422804014327
_K = 4.5
# (1 + 2x)·Q(x)·exp(x²/2) by powers of t = (x − K)/(x + K), x ≥ 0.
_TAIL = (
    0.8480339210780035, -0.03297037452939397, -0.07305965682934842, 0.11557801521508146, -0.10125649265630181,
    0.061371945643383205, -0.025414941731847378, 0.0056974680798445, 0.0005347976832292811, -0.0008086845042801587,
    0.0001301643271785995, 8.189014677551458e-05, -2.998173705697938e-05, -9.109844324167877e-06, 5.220342331624423e-06,
    1.3502317731745142e-06, -8.725379836240012e-07, -2.711562954678711e-07, 1.4056270089684728e-07,
    6.280891188418771e-08, -2.0174419156573e-08, -1.3825462633798932e-08, 2.2062419788056184e-09,
    2.3525277861720946e-09, -1.3129580530952605e-10, -2.1710844973423277e-10,
)  # fmt: skip
# Rounding to sixteenths: exp(−high²/2) is then exact in its argument.
_SIXTEENTHS = 6755399441055744.0 / 16.0


def gaussian(x: "Array") -> "Array":
    """exp(−x²/2), without the x²·2⁻⁵³ that rounding the square would cost."""
    high = (x + _SIXTEENTHS) - _SIXTEENTHS
    return np.exp(-0.5 * high * high) * np.exp(-0.5 * (x - high) * (x + high))


def tail(x: "Array") -> "Array":
    """P(Z > x) for x ≥ 0."""
    t = (x - _K) / (x + _K)
    total = _TAIL[-1] * t
    for coefficient in _TAIL[-2:0:-1]:
        total += coefficient
        total *= t
    total += _TAIL[0]
    return total * gaussian(x) / (1.0 + 2.0 * x)


def upper(z: "Array") -> "Array":
    """P(Z > z)."""
    far = tail(np.minimum(np.abs(z), 40.0))
    return np.where(z >= 0.0, far, 1.0 - far)


def lower(z: "Array") -> "Array":
    """P(Z ≤ z)."""
    return upper(-z)


def density(z: "Array") -> "Array":
    """The standard normal density."""
    return _DENSITY_AT_ZERO * np.exp(-0.5 * z * z)


def quantile(p: "Array") -> "Array":
    """The z with P(Z ≤ z) = p, for 0 < p < 1."""
    q = p - 0.5
    z = q * _ratio(CENTRE, np.maximum(0.180625 - q * q, 0.0))
    outside = np.abs(q) > 0.425
    if outside.any():
        outer = p[outside]
        r = np.sqrt(-np.log(np.where(outer < 0.5, outer, 1.0 - outer)))
        far = np.where(r <= 5.0, _ratio(NEAR, r - 1.6), _ratio(FAR, r - 5.0))
        z[outside] = np.copysign(far, outer - 0.5)
    return z


def _ratio(rational: "tuple[tuple[float, ...], tuple[float, ...]]", x: "Array") -> "Array":
    over, under = rational
    numerator, denominator = over[-1] * x, under[-1] * x
    for a, b in zip(over[-2:0:-1], under[-2:0:-1], strict=True):
        numerator += a
        numerator *= x
        denominator += b
        denominator *= x
    return (numerator + over[0]) / (denominator + under[0])


def probability(z: "Array") -> "Array":
    """P(Z ≤ z) to absolute rounding: for sums of probabilities, where far tails need no relative accuracy."""
    if z.size > _FEW:
        return lower(z)
    flat = (z.ravel() * -0.7071067811865476).tolist()
    return np.fromiter(map(erfc, flat), dtype=float, count=z.size).reshape(z.shape) * 0.5


# Below about this many values the C library's erfc, called one by one, costs less than fifty array operations.
_FEW = 1000


def truncated_moments(a: float, b: float) -> tuple[float, float]:
    """Mean and deviation of a standard normal between a and b, by tanh–sinh quadrature: no term cancels.

    References
    ----------
    H. Takahasi, M. Mori, Double exponential formulas for numerical integration, Publ. RIMS Kyoto 9 (1974) 721.
    """
    # Beyond this the density is below 1e-18 of its maximum.
    b = min(b, math.sqrt(max(a, 0.0) ** 2 + 84.0))
    a = max(a, -9.2)
    steps = np.arange(-72, 73) / 18.0
    bend = 0.5 * math.pi * np.sinh(steps)
    weight = np.cosh(steps) / np.cosh(bend) ** 2
    nearer = 1.0 / (np.exp(2.0 * np.abs(bend)) + 1.0)  # share of the way from the nearer end
    x = np.where(bend < 0.0, a + (b - a) * nearer, b - (b - a) * nearer)
    start = max(a, 0.0)
    mass = weight * np.exp(-0.5 * (x - start) * (x + start))
    mass /= mass.sum()
    mean = float(a + (mass * (x - a)).sum())
    return mean, math.sqrt(float((mass * (x - mean) ** 2).sum()))
