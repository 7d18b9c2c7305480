"""Carlson's elliptic integral of the first kind, for one real argument and a conjugate pair, in real arithmetic."""

from dynamics_cli.numerics.elementary import hypot, sqrt

# Each step divides the differences of the arguments by four: from a ratio of 1e-16 this many leave a remainder below
# 1e-60.
STEPS = 36


def first_kind_with_pair(x: float, real: float, imaginary: float) -> float:
    """R_F(x, real + i·imaginary, real − i·imaginary), for x and the real part not below zero, by duplication.

    >>> round(first_kind_with_pair(1.0, 1.0, 0.0), 12)
    1.0
    """
    for _ in range(STEPS):
        size = hypot(real, imaginary)
        # √x (√z + √z̄) + |z|, with twice the real part of √z
        mixed = sqrt(x) * sqrt(2.0 * (size + real)) + size
        x, real, imaginary = 0.25 * (x + mixed), 0.25 * (real + mixed), 0.25 * imaginary
    return 1.0 / sqrt((x + 2.0 * real) / 3.0)
