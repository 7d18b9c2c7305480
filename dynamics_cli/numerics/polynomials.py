"""Real roots of polynomials of low degree on an interval, found between the roots of their derivatives."""

from itertools import pairwise

from dynamics_cli.numerics.roots import bisected

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any


def value(coefficients: "Sequence[Any]", x: "Any") -> "Any":
    """Σ c_k x^k by Horner's rule, for any kind of numbers; coefficients from the constant up."""
    total = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        total = total * x + coefficient
    return total


def product(first: "Sequence[Any]", second: "Sequence[Any]") -> "list[Any]":
    """The coefficients of a product of two polynomials."""
    total: list[Any] = [0.0] * (len(first) + len(second) - 1)
    for i, coefficient in enumerate(first):
        for j, other in enumerate(second):
            total[i + j] = total[i + j] + coefficient * other
    return total


def derivative(coefficients: "Sequence[Any]") -> "list[Any]":
    """The coefficients of the derivative."""
    return [k * coefficient for k, coefficient in enumerate(coefficients)][1:] or [0.0]


def shifted(coefficients: "Sequence[Any]", by: "Any") -> "list[Any]":
    """The coefficients of p(x + by), by repeated synthetic division.

    References
    ----------
    Repeated synthetic division (Horner): W. H. Press et al., Numerical Recipes, 3rd ed., Cambridge 2007, section
    5.1.
    """
    moved = list(coefficients)
    for low in range(len(moved) - 1):
        for k in range(len(moved) - 2, low - 1, -1):
            moved[k] = moved[k] + by * moved[k + 1]
    return moved


def roots_between(coefficients: "Sequence[float]", low: float, high: float) -> "list[float]":
    """The real roots within [low, high], in doubles, in increasing order; each crossing once, double roots left out.

    Between two neighbouring roots of the derivative a polynomial is monotone and has a root where its sign changes.

    >>> roots_between([-6.0, 1.0, 1.0], 0.0, 4.0)
    [2.0]

    References
    ----------
    Rolle's theorem: between neighbouring roots of the derivative a polynomial is monotone.
    """
    while len(coefficients) > 1 and coefficients[-1] == 0.0:
        coefficients = coefficients[:-1]
    if len(coefficients) < 2 or not high > low:
        return []

    def polynomial(x: float) -> float:
        return value(coefficients, x)  # type: ignore[no-any-return]

    places = [low, *roots_between(derivative(coefficients), low, high), high]
    roots: list[float] = []
    for low_end, high_end in pairwise(places):
        at_left, at_right = value(coefficients, low_end), value(coefficients, high_end)
        if at_left == 0.0:
            if not roots or roots[-1] != low_end:
                roots.append(low_end)
        elif at_right == 0.0:
            roots.append(high_end)
        elif (at_left < 0.0) != (at_right < 0.0):
            roots.append(bisected(polynomial, low_end, high_end))
    return roots
