"""Zeros of several orders at one place: rounding parts them, or moves them by a root of its size."""

import math

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    Taylor = Callable[[float, int], list[float]]

# The highest order looked at, steps of Newton towards the zero of the derivative before it.
HIGHEST, STEPS = 7, 6
# A term of rounding is below this share of the largest; it moves a zero of order m by the root of that order of it.
NOTHING = 1e-13
# Zeros of several orders nearer than this share of the reach are one.
SAME = 1e-6


def distinct(taylor: "Taylor", places: "Iterable[float]", reach: float) -> "list[tuple[float, int]]":
    """Zeros in order, each with its order: what rounding has parted is one."""
    kept: list[tuple[float, int]] = []
    for zero in sorted(_recentred(taylor, at, reach) for at in places):
        if not kept or max(zero[1], kept[-1][1]) == 1 or zero[0] - kept[-1][0] > SAME * reach:
            kept.append(zero)
    return kept


def _recentred(taylor: "Taylor", at: float, reach: float) -> "tuple[float, int]":
    """A zero of a function by its Taylor coefficients, and its order: at one of order m the derivative m − 1 is zero.

    That derivative has a simple zero there, which is found to all digits; the order is the highest at whose place all
    terms before it are rounding.
    """
    for order in range(HIGHEST, 1, -1):
        place = at
        for _ in range(STEPS):
            before, slope = taylor(place, order)[order - 1 :]
            if not slope or not math.isfinite(before / slope):
                break
            place -= before / (order * slope)
        if abs(place - at) <= 10.0 * NOTHING ** (1.0 / order) * reach:
            parts = [abs(part) * reach**k for k, part in enumerate(taylor(place, HIGHEST))]
            nothing = NOTHING * max(parts)
            if max(parts[:order]) <= nothing < parts[order]:
                return place, order
    return at, 1
