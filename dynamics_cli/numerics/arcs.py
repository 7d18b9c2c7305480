"""Means over a circular arc of half angle α that cancel for short arcs: closed form for long ones, series for short.

Both series alternate and their terms fall from the first on for x ≤ π, so the last one kept bounds what is left out.
"""

from dynamics_cli.numerics.elementary import sin

# Above these the closed form loses less than a factor of 7; below, the series keeps every digit.
SINC_SWITCH = 1.5
SPREAD_SWITCH = 1.6

# (−1)ᵏ⁺¹/(2k+1)!, k = 1…13: the terms of 1 − sin x/x by x²ᵏ
_SINC = (
    1 / 6, -1 / 120, 1 / 5040, -1 / 362880, 1 / 39916800, -1 / 6227020800, 1 / 1307674368000, -1 / 355687428096000,
    1 / 121645100408832000, -1 / 51090942171709440000,
)  # fmt: skip


def _factorial(n: int) -> int:
    return 1 if n < 2 else n * _factorial(n - 1)


# (−1)ᵏ (k − 1)/(2k + 2)!, k = 2…17: the terms of ½(1 + sin x/x) − (2/x)² sin²(x/2) by x²ᵏ
_SPREAD = tuple((-1) ** k * (k - 1) / _factorial(2 * k + 2) for k in range(2, 18))


def _horner(coefficients: "tuple[float, ...]", x: float) -> float:
    total = coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        total = total * x + coefficient
    return total


def one_less_sinc(x: float) -> float:
    """1 − sin x/x: how far the mean of cos over (−x, x) falls short of one."""
    if abs(x) > SINC_SWITCH:
        return 1.0 - sin(x) / x
    square = x * x
    return square * _horner(_SINC, square)


def cosine_variance(alpha: float) -> float:
    """Variance of the cosine over (−α, α): ½(1 + sin 2α/(2α)) − (sin α/α)², about α⁴/45 for short arcs."""
    if abs(alpha) > SPREAD_SWITCH:
        mean = sin(alpha) / alpha
        return 0.5 * (1.0 + sin(2.0 * alpha) / (2.0 * alpha)) - mean * mean
    square = 4.0 * alpha * alpha
    return square * square * _horner(_SPREAD, square)
