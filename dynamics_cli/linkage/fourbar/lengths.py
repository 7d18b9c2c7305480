"""Lengths of a four-bar as they were typed: sums and differences that decide are formed from the decimals.

A length reaches physics as the nearest double. The shortest decimal of that double is the number as typed whenever
that had up to fifteen digits and a decimal unit (millimetres and inches are): 0.1 + 0.7 equals 0.5 + 0.3.
"""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, where
from dynamics_cli.numerics.number import is_array, is_carrier, is_tracked, plain, single
from dynamics_cli.quantities import Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# A margin smaller than this share of the lengths is formed from decimals; above it doubles are accurate enough.
NEAR = 2.0**-10
UNIT = 2.0**-53
# Covers the rounding of a bound's own arithmetic.
SLACK = 1.0 + 2.0**-40
# Fourth powers of lengths beyond these leave the range of a double.
SMALLEST, LARGEST = 1e-75, 1e75
LINKS = ("crank", "coupler", "rocker", "ground")


def _signed_sum(signs: "Sequence[int]", lengths: "Sequence[float]") -> float:
    """The sum of the shortest decimals of the doubles, rounded once."""
    from decimal import Context, Decimal

    context, total = Context(prec=320), Decimal(0)
    for sign, length in zip(signs, lengths, strict=True):
        total = context.add(total, sign * Decimal(repr(float(plain(length)))))
    return float(total)


def margin(signs: "Sequence[int]", lengths: "Sequence[float]") -> float:
    """A sum of lengths with signs, exact for the decimals where it nearly vanishes: zero means zero as typed."""
    total, size = 0.0 * lengths[0], 0.0 * lengths[0]
    for sign, length in zip(signs, lengths, strict=True):
        total = total + length if sign > 0 else total - length
        size = size + length
    if is_carrier(total) and not is_tracked(total):
        return total
    if is_array(total) and not single(total):
        return _of_arrays(signs, lengths, total, size)  # type: ignore[no-any-return]
    if abs(plain(total)) > NEAR * plain(size):
        return total
    exact = _signed_sum(signs, lengths)
    if not is_tracked(total):
        return exact
    # the bound of the doubles, which covers their difference from the decimals
    tracked: Any = total
    error = (tracked.error + abs(exact - tracked.value) + UNIT * abs(exact)) * SLACK
    return type(tracked)(exact, error, tracked.slopes)  # type: ignore[no-any-return]


def _of_arrays(signs: "Sequence[int]", lengths: "Sequence[Any]", total: "Any", size: "Any") -> "Any":
    import numpy as np

    columns = np.broadcast_arrays(*lengths)
    for index in np.argwhere(np.abs(total) <= NEAR * size):
        place = tuple(index)
        total[place] = _signed_sum(signs, [float(column[place]) for column in columns])
    return total


def require_links(crank: float, coupler: float, rocker: float, ground: float) -> None:
    """Refuse lengths that are not above zero, and one longer than the other three together."""
    lengths = (crank, coupler, rocker, ground)
    for name, length in zip(LINKS, lengths, strict=True):
        require(
            length > 0.0,
            f"the {name} has a length of {{length}}: a link needs more than zero",
            length=(length, Size),
            code="no-length",
        )
        require(
            (length > SMALLEST) & (length < LARGEST),
            f"the {name} has a length of {{length}}: its square leaves the range of a double",
            length=(length, Size),
            code="range",
            hint="check its unit",
        )
    for index, name in enumerate(LINKS):
        signs = [1, 1, 1, 1]
        signs[index] = -1
        reserve = margin(signs, lengths)
        gap = absolute(where(reserve < 0.0, reserve, 0.0))
        require(
            reserve >= 0.0,
            f"the {name} of {{length}} is longer than the other three links together: it cannot be closed by {{gap}}",
            length=(lengths[index], Size),
            gap=(gap, Size),
            code="cannot-be-built",
            hint=f"shorten the {name} by {{gap}}, or lengthen another link by as much",
        )
