"""Slider-crank: the acceleration of a piston by orders of the crank angle."""

from math import comb

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import only_in_doubles
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# A rod shorter than this share allows is no engine's, and the series would be long.
LONGEST_CRANK = 0.9
SMALL = 1e-18


def require_rod(ratio: "Any") -> None:
    """Refuse a crank that is too long for its rod."""
    require(
        (plain(ratio) > 0.0) and (plain(ratio) <= LONGEST_CRANK),
        "crank radius over rod length is {ratio}, wanted above 0 and up to 0.9",
        code="rod",
        hint="check crank radius and rod length: the rod is measured between the centres of its eyes",
        ratio=(ratio, Ratio),
    )


def order_factor(ratio: "Any", order: int) -> "Any":
    """A_n: the part of order n of the piston's acceleration towards the crankshaft over r·ω².

    A₁ = 1, A₂ = λ + λ³/4 + …, A₄ = −(λ³/4 + …); other odd orders are zero. The series of √(1 − λ²·sin²θ), whose terms
    have one sign for each order, so that nothing cancels.

    >>> round(order_factor(0.25, 2), 12)
    0.254025042307
    """
    if order % 2:
        return 1.0 if order == 1 else 0.0
    only_in_doubles(ratio)
    half = order // 2
    square = ratio * ratio
    # C(2k, k)·C(2k, k − j)·λ²ᵏ/((2k − 1)·16ᵏ) from k = j on, each from the one before
    term: Any = comb(order, half) / ((order - 1) * 16.0**half)
    for _ in range(half):
        term = term * square
    whole, k = term, half
    while plain(term) > SMALL * plain(whole):
        term = term * square * ((4 * k * k - 1) / (4.0 * (k + 1 - half) * (k + 1 + half)))
        whole = whole + term
        k += 1
    sign = 1.0 if half % 2 else -1.0
    return sign * 2.0 * order * order * whole / ratio
