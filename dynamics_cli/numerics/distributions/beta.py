"""The beta distribution on 0..1: its tails, and a table of its quantiles for arrays.

The log-odds of the quantile are a smooth function of the standard normal z of the same probability, so a piecewise
Chebyshev table of them serves whole arrays, and both ends keep their digits.
"""

import math

import numpy as np

from dynamics_cli.numerics.distributions import normal
from dynamics_cli.numerics.distributions.student import incomplete_fraction, powers_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# The table reaches so far in z (a tail of 1e-19) in steps of one, with polynomials of this degree.
_REACH = 9
_DEGREE = 15
_NEWTON_STEPS = 100
_tables: "dict[tuple[float, float], Array]" = {}


def tails(odds: float, a: float, b: float) -> tuple[float, float]:
    """P(X < x) and P(X > x), for the x of these log-odds.

    References
    ----------
    NIST Digital Library of Mathematical Functions, section 8.17 (incomplete beta functions).
    """
    x, rest = _share(odds), _share(-odds)
    front = _front(odds, a, b)
    if x < (a + 1.0) / (a + b + 2.0):
        low = front / a * incomplete_fraction(a, b, x)
        return low, 1.0 - low
    high = front / b * incomplete_fraction(b, a, rest)
    return 1.0 - high, high


def log_odds(z: "Array", a: float, b: float) -> "Array":
    """The log-odds of the x with P(X < x) = P(Z < z); beyond 9 they stay as they are there."""
    if (a, b) not in _tables:
        _tables[a, b] = _table(a, b)
    table = _tables[a, b]
    inside = np.clip(z, -_REACH, _REACH)
    piece = np.minimum((inside + _REACH).astype(np.int64), 2 * _REACH - 1)
    local = 2.0 * (inside + _REACH - piece) - 1.0
    total = table[_DEGREE][piece]
    for k in range(_DEGREE - 1, -1, -1):
        total = total * local + table[k][piece]
    return total  # type: ignore[no-any-return]


def _share(odds: float) -> float:
    return 1.0 / (1.0 + math.exp(-odds)) if odds > -700.0 else math.exp(odds)


def _front(odds: float, a: float, b: float) -> float:
    """x^a (1 − x)^b/B(a, b): also the density by log-odds."""
    scale = math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b)
    # ln x and ln(1 − x) from the side that does not cancel
    less = -math.log1p(math.exp(-abs(odds)))
    log_x, log_rest = (less, less - odds) if odds > 0.0 else (less + odds, less)
    return math.exp(scale + a * log_x + b * log_rest)


def _solve(z: float, a: float, b: float, odds: float) -> float:
    """Newton on the logarithm of the smaller tail."""
    tail = normal.upper(abs(z))
    for _ in range(_NEWTON_STEPS):
        low, high = tails(odds, a, b)
        probability = low if z < 0.0 else high
        step = math.log(probability / tail) * probability / _front(odds, a, b)
        step = max(min(-step if z < 0.0 else step, 2.0 / min(a, b, 1.0)), -2.0 / min(a, b, 1.0))
        odds += step
        if abs(step) <= 1e-15 * max(abs(odds), 1.0):
            break
    return odds


def _table(a: float, b: float) -> "Array":
    """Coefficients by powers of the local coordinate: (degree + 1, pieces)."""
    angles = math.pi * (2 * np.arange(_DEGREE + 1) + 1) / (2 * (_DEGREE + 1))
    local = np.cos(angles)
    values = np.empty((_DEGREE + 1, 2 * _REACH))
    start = math.log(a / b)
    # From the middle outwards each is the first guess of the next.
    for pieces in (range(_REACH, 2 * _REACH), range(_REACH - 1, -1, -1)):
        odds = start
        for piece in pieces:
            for k in np.argsort(local if pieces[0] == _REACH else -local).tolist():
                odds = _solve(piece - _REACH + 0.5 * (1.0 + float(local[k])), a, b, odds)
                values[k, piece] = odds
    chebyshev = np.cos(np.outer(np.arange(_DEGREE + 1), angles)) @ values * (2.0 / (_DEGREE + 1))
    chebyshev[0] *= 0.5
    return powers_of(chebyshev)
