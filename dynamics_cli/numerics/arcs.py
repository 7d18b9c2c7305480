"""Means over a circular arc of half angle α that cancel for short arcs, which therefore take a series.

Both series alternate and their terms decrease for x ≤ π, so the first term omitted bounds the remainder.
"""

from dynamics_cli.numerics.elementary import horner, sin

# Above these the closed form magnifies rounding less than 7 times; below, the series keeps every digit.
SINC_SWITCH = 1.5
SPREAD_SWITCH = 1.6

# Above this the closed form loses at most twelve of sixty digits; below, the series gives all of them.
SHORT = 1e-3


def _factorial(n: int) -> int:
    return 1 if n < 2 else n * _factorial(n - 1)


# Numerators and denominators of (−1)ᵏ⁺¹/(2k+1)!, k = 1…10: the terms of 1 − sin x/x by x²ᵏ
_SINC = tuple((-((-1) ** k), _factorial(2 * k + 1)) for k in range(1, 11))
# and of (−1)ᵏ (k − 1)/(2k + 2)!, k = 2…17: the terms of ½(1 + sin x/x) − (2/x)² sin²(x/2) by x²ᵏ
_SPREAD = tuple(((-1) ** k * (k - 1), _factorial(2 * k + 2)) for k in range(2, 18))
_SINC_DOUBLES, _SPREAD_DOUBLES = (tuple(up / down for up, down in terms) for terms in (_SINC, _SPREAD))


def _exact_horner(terms: "tuple[tuple[int, int], ...]", x: float) -> float:
    """Horner's rule for numbers of many digits."""
    total = 0.0 * x
    for up, down in terms[::-1]:
        total = total * x + (0.0 * x + up) / down
    return total


def one_less_sinc(x: float) -> float:
    """1 − sin x/x: the difference of the mean of cos over (−x, x) from one.

    References
    ----------
    Derived: Taylor series of sin x/x, whose alternating terms bound what is left out.
    """
    many = hasattr(x, "exact")
    if abs(x) > (SHORT if many else SINC_SWITCH):
        return 1.0 - sin(x) / x
    square = x * x
    return square * (_exact_horner(_SINC, square) if many else horner(_SINC_DOUBLES, square))


def cosine_variance(alpha: float) -> float:
    """Variance of the cosine over (−α, α): ½(1 + sin 2α/(2α)) − (sin α/α)², about α⁴/45 for short arcs.

    References
    ----------
    Derived: moments of the cosine over an arc; below the switch their Taylor series, which alternates.
    """
    many = hasattr(alpha, "exact")
    if abs(alpha) > (SHORT if many else SPREAD_SWITCH):
        mean = sin(alpha) / alpha
        return 0.5 * (1.0 + sin(2.0 * alpha) / (2.0 * alpha)) - mean * mean
    square = 4.0 * alpha * alpha
    return square * square * (_exact_horner(_SPREAD, square) if many else horner(_SPREAD_DOUBLES, square))
