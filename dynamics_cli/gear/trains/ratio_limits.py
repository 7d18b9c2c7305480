"""Limits that every train of a search must keep, and the ranking of ratios by their distance from the target."""

from math import gcd

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.rational import nearest
from dynamics_cli.quantities import Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    from dynamics_cli.numerics.exact.rational import Pair

    Stage: TypeAlias = tuple[int, int]
    Train: TypeAlias = tuple[Stage, ...]

# Lists longer than this would take minutes and gigabytes.
MOST_LISTED = 12_000_000
# Ratios tested against the constraints, best first, before they are declared out of reach.
MOST_LOOKED_AT = 60_000


class Limits:
    """Limits that every pair of a train must keep."""

    def __init__(self, coprime: bool, coaxial: bool, sums: range | None, largest: float | None) -> None:
        self.coprime = coprime
        self.coaxial = coaxial
        self.sums = sums
        self.largest = largest

    def pair(self, driver: int, driven: int) -> bool:
        """Whether a pair is allowed."""
        if self.coprime and gcd(driver, driven) != 1:
            return False
        if self.sums is not None and driver + driven not in self.sums:
            return False
        return self.largest is None or max(driver, driven) <= self.largest * min(driver, driven)


def require_between(target: "Pair", least: "Pair", most: "Pair", stages: int) -> None:
    """Refuse a target outside the range of the teeth."""
    inside = least[0] * target[1] <= target[0] * least[1] and target[0] * most[1] <= most[0] * target[1]
    require(
        inside,
        "{target:6} is out of reach: {stages} pairs give {least:6} to {most:6}",
        target=(nearest(target), Ratio),
        stages=stages,
        least=(nearest(least), Ratio),
        most=(nearest(most), Ratio),
        code="out-of-reach",
        hint="take more stages, or a wider range of teeth",
    )


def require_found(trains: object, rejected: int) -> None:
    """Refuse when no train keeps the limits."""
    require(
        bool(trains),
        "none of the {rejected} nearest ratios can be made within the constraints",
        rejected=rejected,
        code="constraints",
        hint="loosen a constraint, or widen the range of teeth",
    )


WANTED_AT_FIRST = 60.0
WIDER = 12.0
# Products are ordered as doubles; their rounding is added to every reach.
HIDDEN = 1e-14


def by_distance(values: "object", target: "Pair") -> "list[Pair]":
    """Ratios by their exact error, then by size."""
    top, bottom = target
    pairs: list[Pair] = list(values)  # type: ignore[call-overload]
    if not pairs:
        return []
    # fine enough that two different errors never give the same integer
    unit = 4 * max(q for _, q in pairs) ** 2 * bottom * top
    return sorted(pairs, key=lambda pair: (abs(pair[0] * bottom - pair[1] * top) * unit // (pair[1] * top), pair))


def beyond(value: "Pair", target: "Pair", reach: float) -> bool:
    """Whether a ratio is beyond the range in which all ratios are known."""
    top, bottom = value[0] * target[1], value[1] * target[0]
    return abs(top - bottom) / bottom > reach
