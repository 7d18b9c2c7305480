"""Slider-crank: the acceleration of a piston by orders of the crank angle."""

from math import comb, pi

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, only_in_doubles, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import Annotated, Ratio, Size
from dynamics_cli.records import record

TURN = 2.0 * pi

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# A rod shorter than this share allows is no engine's, and the series would be long.
LONGEST_CRANK = 0.9
SMALL = 1e-18
# The mean over this many angles is exact in doubles up to order 40 and a crank ratio with offset of 0.9.
POINTS = 128


@record
class CrankRadius:
    """A crank by its radius."""

    crank_radius: Annotated[Size, "Half the stroke, e.g. 43 mm."]

    @property
    def radius(self) -> "Any":
        """Its radius."""
        return self.crank_radius


@record
class Stroke:
    """A crank by the stroke that it gives a piston whose cylinder is not offset."""

    stroke: Annotated[Size, "Twice the crank radius, e.g. 86 mm."]

    @property
    def radius(self) -> "Any":
        """Half the stroke."""
        return 0.5 * self.stroke


def require_rod(ratio: "Any", offset: "Any" = 0.0) -> None:
    """Refuse a crank that is too long for its rod, with the offset of the cylinder over the rod's length."""
    require(
        (plain(ratio) > 0.0) and (plain(ratio) <= LONGEST_CRANK),
        "crank radius over rod length is {ratio}, wanted above 0 and up to 0.9",
        code="rod",
        hint="check crank radius and rod length: the rod is measured between the centres of its eyes",
        ratio=(ratio, Ratio),
    )
    require(
        plain(ratio) + abs(plain(offset)) <= LONGEST_CRANK,
        "crank radius and offset together over rod length are {sum}, wanted up to 0.9",
        code="rod",
        hint="check --offset: it is some millimetres in most engines",
        sum=(ratio + absolute(offset), Ratio),
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


def motion(ratio: "Any", offset: "Any", cosine: "Any", sine: "Any") -> "tuple[Any, Any]":
    """Of a piston: its speed towards the crankshaft over r·ω, its acceleration towards it over r·ω².

    `offset` is the distance of the cylinder's axis from that of the crankshaft over the rod's length, on the side to
    which the crank pin goes after top dead centre.
    """
    lean = ratio * sine - offset
    height = sqrt((1.0 - lean) * (1.0 + lean))
    slope = lean * cosine / height
    return sine + slope, cosine + (ratio * (cosine * cosine + slope * slope) - sine * lean) / height


def order_factors(ratio: "Any", offset: "Any", orders: "list[int]") -> "list[tuple[Any, Any]]":
    """(A_n, B_n) for each order: the acceleration over r·ω² is ΣA_n·cos nθ + B_n·sin nθ; an offset adds the odd sines.

    >>> [round(b, 12) for _, b in order_factors(0.3, 0.05, [1, 3])]
    [0.05186392033, -0.005565242443]
    """
    if plain(offset) == 0.0:
        return [(order_factor(ratio, n), 0.0 * ratio) for n in orders]
    only_in_doubles(ratio, offset)
    turns = [turned(TURN * k / POINTS) for k in range(POINTS)]
    values = [motion(ratio, offset, *turn)[1] for turn in turns]
    rows = []
    for n in orders:
        # even orders are cosines, odd ones sines, but for the cosine of the crank pin itself
        part = n % 2
        mean = sum(value * turns[n * k % POINTS][part] for k, value in enumerate(values)) * (2.0 / POINTS)
        rows.append((1.0 if n == 1 else 0.0, mean) if part else (mean, 0.0))
    return rows
