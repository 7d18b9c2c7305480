"""The task `interval`: robust stability of a polynomial whose coefficients lie within ranges."""

from itertools import accumulate

from dynamics_cli.errors import UsageError, require
from dynamics_cli.numerics.exact.polynomial_text import MOST_DEGREE, read_number
from dynamics_cli.numerics.exact.rational import lowest, written
from dynamics_cli.quantities import Annotated, Count, Text
from dynamics_cli.records import Numerics, record
from dynamics_cli.stability.counting import ASYMPTOTIC, count, verdict

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Pair: TypeAlias = tuple[int, int]

# Which end each coefficient takes, from the constant up and then again: the polynomials of Kharitonov's theorem.
CORNERS = ((0, 0, 1, 1), (1, 1, 0, 0), (1, 0, 0, 1), (0, 1, 1, 0))


@record
class Corner:
    """One of the four polynomials that decide."""

    coefficients: Annotated[Text, "From the highest power down."]
    verdict: Annotated[Text, "Whether it is stable."]
    left: Annotated[Count, "Roots in the left half plane."]
    right: Annotated[Count, "Roots in the right half plane."]
    axis: Annotated[Count, "Roots on the imaginary axis."]


@record
class Interval:
    """Whether every polynomial within the ranges is stable."""

    verdict: Annotated[Text, "Robustly stable or not."]
    worst_right: Annotated[Count, "The most roots in the right half plane of one of the four [-]."]
    failing: Annotated[Text | None, "The first of the four that is not stable; none where all are."]
    corners: Annotated[tuple[Corner, ...], "The four polynomials."]
    numerics: Numerics


def interval(
    coefficients: Annotated[Text, "From the highest power down, numbers or ranges, e.g. 1, 2..3, 3 ± 0.5, 1..5."], /
) -> Interval:
    """Stability of all polynomials whose coefficients lie within ranges, independently of one another.

    Equation
    --------
    All are stable when the four with coefficients at the ends low-low-high-high, high-high-low-low, high-low-low-high
    and low-high-high-low, from the constant up and so on, are stable.

    Returns
    -------
    Interval
        The verdict, and the four polynomials with their root counts.

    Raises
    ------
    UsageError
        When a coefficient is neither a number nor a range.
    InadmissibleError
        When the leading coefficient may be zero.

    Notes
    -----
    A range is a set here, not a distribution. Where coefficients depend on one another the verdict is on the safe side.

    References
    ----------
    Kharitonov, Differential Equations 14 (1979) 1483.

    Examples
    --------
    >>> interval("1, 2..3, 3..4, 1..5").verdict
    'robustly stable'
    """
    ranges = [_range(part) for part in _parts(coefficients)]
    ranges.reverse()
    leading = ranges[-1]
    require(
        leading[0][0] * leading[1][0] > 0,
        "the leading coefficient {low} to {high} may be zero" if leading[0] != leading[1] else
        "the leading coefficient is zero",
        low=written(leading[0]), high=written(leading[1]), code="degree",
        hint="leave a leading zero out, or narrow the range",
    )  # fmt: skip
    require(1 < len(ranges) <= MOST_DEGREE + 1, "read {count} coefficients, wanted a polynomial of degree 1 to {most}",
            count=str(len(ranges)), most=str(MOST_DEGREE), code="degree")  # fmt: skip
    if leading[0][0] < 0:
        ranges = [((-high[0], high[1]), (-low[0], low[1])) for low, high in ranges]
    corners = tuple(_corner(ranges, ends) for ends in CORNERS)
    failing = next((corner for corner in corners if corner.verdict != ASYMPTOTIC), None)
    return Interval(
        verdict="robustly stable" if failing is None else "not robustly stable",
        worst_right=max(corner.right for corner in corners),
        failing=None if failing is None else failing.coefficients,
        corners=corners,
        numerics=Numerics("exact counts"),
    )


def _parts(text: str) -> "list[str]":
    """The coefficients of a list, its ranges written 2..3 or [2, 3], the whole in brackets or not."""
    text = text.strip()
    depths = list(accumulate(("[" in letter) - ("]" in letter) for letter in text))
    if depths and (depths[-1] != 0 or min(depths) < 0):
        raise UsageError(f"{text!r}: a bracket is not closed", code="syntax", hint="write a range as 2..3 or [2, 3]")
    if text.startswith("[") and 0 not in depths[:-1]:
        text, depths = text[1:-1], [depth - 1 for depth in depths[1:-1]]
    parts = "".join(";" if letter == "," and depth == 0 else letter for letter, depth in zip(text, depths, strict=True))
    return [
        "..".join(part.strip()[1:-1].split(",", 1)) if part.strip().startswith("[") else part
        for part in parts.split(";")
    ]


def _range(text: str) -> "tuple[Pair, Pair]":
    middle, sign, half = text.replace("+/-", "±").partition("±")
    if sign:
        (mean, below), (width, under) = read_number(middle), read_number(half)
        text = f"{mean * under - width * below}/{below * under}..{mean * under + width * below}/{below * under}"
    low, dots, high = text.strip().partition("..")
    ends = low.lower().replace("e-", "e").split("-")
    if not dots and len(ends) == 2 and all(ends):
        raise UsageError(f"{low!r} is a difference, not a range", code="range",
                         hint=f"write {ends[0].strip()}..{ends[1].strip()}")  # fmt: skip
    one = read_number(low)
    other = read_number(high) if dots else one
    return (one, other) if one[0] * other[1] <= other[0] * one[1] else (other, one)


def _corner(ranges: "list[tuple[Pair, Pair]]", ends: "tuple[int, ...]") -> Corner:
    chosen = [pair[ends[k % 4]] for k, pair in enumerate(ranges)]
    common = 1
    for _, bottom in chosen:
        common *= lowest(bottom, common)[0]
    counts = count([top * (common // bottom) for top, bottom in chosen])
    return Corner(
        coefficients=", ".join(written(pair) for pair in reversed(chosen)),
        verdict=verdict(counts),
        left=counts.left,
        right=counts.right,
        axis=counts.axis,
    )
