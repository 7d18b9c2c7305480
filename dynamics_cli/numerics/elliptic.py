"""Elliptic integrals and functions by the arithmetic–geometric mean and by duplication, for numbers of every sort."""

from dynamics_cli.numerics.elementary import asin, cos, hypot, sin, sqrt

# Each step halves the exponent of the ratio of the two, then doubles its digits: from the smallest, fifteen reach the
# last bit.
STEPS = 15
# Each divides the differences of Carlson's arguments by four: from a ratio of 1e-16 these leave less than 1e-60.
DUPLICATIONS = 36


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


def first_kind_with_pair(x: float, real: float, imaginary: float) -> float:
    """R_F(x, real + i·imaginary, real − i·imaginary), for x and the real part not below zero, by duplication.

    >>> round(first_kind_with_pair(1.0, 1.0, 0.0), 12)
    1.0
    """
    for _ in range(DUPLICATIONS):
        size = hypot(real, imaginary)
        # √x (√z + √z̄) + |z|, with twice the real part of √z
        mixed = sqrt(x) * sqrt(2.0 * (size + real)) + size
        x, real, imaginary = 0.25 * (x + mixed), 0.25 * (real + mixed), 0.25 * imaginary
    return 1.0 / sqrt((x + 2.0 * real) / 3.0)


def first_kind(x: float, y: float, z: float) -> float:
    """R_F(x, y, z), for numbers not below zero of which at most one is zero, by duplication.

    References
    ----------
    B. C. Carlson, Numerical Algorithms 10, 1995.

    >>> round(first_kind(0.0, 1.0, 2.0), 12)
    1.311028777146
    """
    for _ in range(DUPLICATIONS):
        a, b, c = sqrt(x), sqrt(y), sqrt(z)
        mixed = a * (b + c) + b * c
        x, y, z = 0.25 * (x + mixed), 0.25 * (y + mixed), 0.25 * (z + mixed)
    return 1.0 / sqrt((x + y + z) / 3.0)
