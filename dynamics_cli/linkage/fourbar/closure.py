"""Closing the loop of a four-bar: two circles, without arc cosines or quotients of tangents, smooth at change points.

O₂ = (0, 0), O₄ = (d, 0), A = a·e^{iθ₂}, B from A by the coupler b and from O₄ by the rocker c. With f = |A O₄|,
D₁ = (b + c)² − f² and D₂ = f² − (b − c)², B lies at ±√(D₁D₂)/2f from the line A O₄. Where b + c = a + d exactly, √D₁ is
the signed 2√(ad)·cos(θ₂/2), where |b − c| = |a − d| exactly √D₂ is 2√(ad)·sin(θ₂/2): the motion runs on smoothly.
"""

from dynamics_cli.linkage.fourbar.lengths import margin
from dynamics_cli.numerics.elementary import absolute, maximum, sqrt, where
from dynamics_cli.numerics.number import single
from dynamics_cli.records import Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


class Branch(Choice):
    """The side on which the pin of coupler and rocker lies, seen from the crank's pin towards the rocker's pivot."""

    names = ("open", "crossed")
    aliases = {"+": "open", "left": "open", "-": "crossed", "−": "crossed", "right": "crossed"}  # noqa: RUF012


OPEN = Branch("open")


@record
class Frame:
    """Quantities of the four lengths alone.

    `outer` is b + c − a − d and `inner` |a − d| − |b − c|, both exact for decimals; they are zero at change points and
    negative where the crank has limits.
    """

    a: float
    b: float
    c: float
    d: float
    longer: float
    apart: float
    slim: float
    outer: float
    inner: float
    product: float
    excess: float

    @property
    def lengths(self) -> "tuple[float, float, float, float]":
        """Crank, coupler, rocker, ground."""
        return self.a, self.b, self.c, self.d


def frame(a: float, b: float, c: float, d: float) -> Frame:
    """The four lengths with their differences and margins."""
    apart, slim = margin((1, -1), (a, d)), margin((1, -1), (b, c))
    # |a − d| − |b − c| as one sum of the four lengths
    alike, unlike = margin((1, -1, 1, -1), (a, b, c, d)), margin((1, 1, -1, -1), (a, b, c, d))
    inner = where((apart >= 0.0) == (slim >= 0.0), alike, unlike)
    inner = where(apart >= 0.0, inner, -inner)
    outer = margin((-1, 1, 1, -1), (a, b, c, d))
    return Frame(a, b, c, d, apart, absolute(apart), slim, outer, inner, a * d, slim * (b + c))


@record
class Closed:
    """The loop at one crank angle: f² and f⃗ from A to O₄, b⃗ and c⃗, the two roots, and the derivatives of the angles.

    `response` is K = a·d·sin θ₂/(√D₁·√D₂) and `change` its derivative by θ₂, both finite at change points.
    """

    square: float
    fx: float
    fy: float
    first: float
    second: float
    bx: float
    by: float
    cx: float
    cy: float
    response: float
    change: float
    along: float
    moment: float


def discriminants(links: Frame, half: "tuple[float, float]") -> "tuple[float, float]":
    """D₁ and D₂ at a crank angle whose half has this cosine and sine: negative where the loop does not close."""
    cosine, sine = half
    four = 4.0 * links.product
    a, b, c, d = links.lengths
    gap = absolute(links.slim)
    first = _either(
        links.outer >= 0.0,
        lambda: links.outer * (a + b + c + d) + four * (cosine * cosine),
        lambda: (b + c - links.apart) * (b + c + links.apart) - four * (sine * sine),
    )
    second = _either(
        links.inner >= 0.0,
        lambda: links.inner * (links.apart + gap) + four * (sine * sine),
        lambda: (a + d - gap) * (a + d + gap) - four * (cosine * cosine),
    )
    return first, second


def _either(condition: bool, yes: "Callable[[], float]", no: "Callable[[], float]") -> float:
    """One of the two; only one is calculated if the condition is the same for all."""
    if single(condition):
        return yes() if condition else no()
    return where(condition, yes(), no())


def close(
    links: Frame,
    turn: "tuple[float, float]",
    half: "tuple[float, float]",
    side: float,
    drop: "tuple[Any, Any] | None" = None,
) -> Closed:
    """Close the loop at a crank angle, given by cosine and sine of itself and of its half, with B on a side of A–O₄.

    The side is +1 on the open branch, −1 on the crossed one. `drop` are D₁ and D₂ where they are known; where a root
    vanishes away from a change point (a toggle) the response is infinite.
    """
    sine, (half_cosine, half_sine) = turn[1], half
    first, second = drop or discriminants(links, half)
    a, ad = links.a, links.product
    smooth_first, smooth_second = links.outer == 0.0, links.inner == 0.0
    root = sqrt(ad)
    # the root of a change point may be that of a rounding error below zero
    r1 = _either(smooth_first, lambda: 2.0 * root * half_cosine, lambda: sqrt(_kept(first)))
    r2 = _either(smooth_second, lambda: 2.0 * root * half_sine, lambda: sqrt(_kept(second)))
    square = links.apart * links.apart + 4.0 * ad * (half_sine * half_sine)
    fx, fy = 2.0 * a * (half_sine * half_sine) - links.longer, -(a * sine)
    area, twice = side * (r1 * r2), 0.5 / square
    ahead, behind = (square + links.excess) * twice, (square - links.excess) * twice
    across = area * twice
    response, change = _response(links, turn, half, (r1, r2), (smooth_first, smooth_second))
    return Closed(
        square, fx, fy, r1, r2,
        ahead * fx - across * fy, ahead * fy + across * fx,
        -(behind * fx) - across * fy, across * fx - behind * fy,
        side * response, side * change, -(a * links.longer) - 2.0 * ad * (half_sine * half_sine), ad * sine,
    )  # fmt: skip


def is_regular(links: Frame, loop: Closed) -> bool:
    """Whether the crank's speed determines the others: not at a toggle, but at a change point passed smoothly."""
    return (loop.first * loop.second != 0.0) | (links.outer == 0.0) | (links.inner == 0.0)


def _kept(x: float) -> float:
    """The value, or zero if it is below zero."""
    return maximum(x, 0.0 * x) if single(x) else x.clip(0.0)  # type: ignore[attr-defined]


def _response(
    links: Frame, turn: "tuple[float, float]", half: "tuple[float, float]", roots: "tuple[Any, Any]",
    smooth: "tuple[Any, Any]",
) -> "tuple[float, float]":  # fmt: skip
    """K and its derivative; a zero root is taken as one, and refused by the caller unless it is a change point."""
    (r1, r2), moment = roots, links.product * turn[1]
    root = sqrt(links.product)

    def general() -> "tuple[float, float]":
        over = _reciprocal(r1 * r2)
        response = moment * over
        return response, (links.product * turn[0] - response * response * ((r1 - r2) * (r1 + r2))) * over

    def through_first() -> "tuple[float, float]":
        over = _reciprocal(r2)
        return root * half[1] * over, root * over * (0.5 * half[0] - half[1] * moment * (over * over))

    def through_second() -> "tuple[float, float]":
        over = _reciprocal(r1)
        return root * half[0] * over, root * over * (half[0] * moment * (over * over) - 0.5 * half[1])

    def through_both() -> "tuple[float, float]":
        return 0.5 + 0.0 * moment, 0.0 * moment

    first, second = smooth
    if single(first, second):
        beside_first = through_both if second else through_first
        return beside_first() if first else through_second() if second else general()
    response, change = general()
    for condition, motion in ((first & ~second, through_first), (second & ~first, through_second),
                              (first & second, through_both)):  # fmt: skip
        if condition.any():
            along = motion()
            response, change = where(condition, along[0], response), where(condition, along[1], change)
    return response, change


def _reciprocal(x: float) -> float:
    """One over it; of zero one, which only poses show that the caller refuses."""
    return 1.0 / where(x > 0.0, x, 1.0)


def ratios(links: Frame, loop: Closed) -> "tuple[float, float, float, float]":
    """ω₃/ω₂, ω₄/ω₂ and their derivatives by the crank angle."""
    over = 1.0 / loop.square
    excess, twice = links.excess, 2.0 * loop.moment
    coupler = -((loop.response * (loop.square - excess) + loop.along) * over)
    rocker = (loop.response * (loop.square + excess) - loop.along) * over
    grown = loop.response * twice
    coupler_change = -((loop.change * (loop.square - excess) + grown - loop.moment + coupler * twice) * over)
    rocker_change = (loop.change * (loop.square + excess) + grown + loop.moment - rocker * twice) * over
    return coupler, rocker, coupler_change, rocker_change
