"""Elliptic integrals and functions by the arithmetic–geometric mean, for numbers of every sort."""

from dynamics_cli.numerics.elementary import asin, cos, sin, sqrt

# Each step halves the exponent of the ratio of the two, then doubles its digits: from the smallest, fifteen reach the
# last bit.
STEPS = 15


def mean(a: float, b: float) -> float:
    """The arithmetic–geometric mean of two positive numbers.

    >>> round(mean(1.0, 0.5), 15)
    0.728395515523453
    """
    for _ in range(STEPS):
        a, b = 0.5 * (a + b), sqrt(a * b)
    return a


def amplitude(u: float, modulus: float, complement: float) -> float:
    """am(u), whose sine, cosine and √(1 − k²·sin²) are Jacobi's sn, cn and dn, by Gauss's descending steps.

    >>> round(sin(amplitude(1.0, 0.6, 0.8)), 12)
    0.81409141238
    """
    a, b, c = 1.0 + 0.0 * complement, complement, modulus
    ladder = []
    for _ in range(STEPS):
        a, b, c = 0.5 * (a + b), sqrt(a * b), 0.5 * (a - b)
        ladder.append((a, c))
    angle = 2.0**STEPS * a * u
    for upper, difference in reversed(ladder):
        angle = 0.5 * (angle + asin(difference / upper * sin(angle)))
    return angle


def functions(u: float, modulus: float, complement: float) -> tuple[float, float, float]:
    """Jacobi's sn, cn and dn of u; dn² is formed as k′² + k²·cn², without cancellation."""
    angle = amplitude(u, modulus, complement)
    sn, cn = sin(angle), cos(angle)
    return sn, cn, sqrt(complement * complement + (modulus * cn) * (modulus * cn))
