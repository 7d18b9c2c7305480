"""Firing orders: at which crank angles the cylinders of an engine fire, given or the most even."""

import math
from itertools import pairwise, product

from dynamics_cli.errors import require
from dynamics_cli.records import Choice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    # Cylinder, crank angle of its firing, interval to the next.
    Fired = tuple[int, float, float]

TURN = 2.0 * math.pi
# Firings closer together than this are together, and intervals as alike are even.
ALIKE = 1e-9
MOST = 12


class Strokes(Choice):
    """Strokes of a cycle."""

    __slots__ = ()
    names = ("four", "two")


def firing(places: "Sequence[tuple[float, float]]", turns: int, order: "str | None") -> "tuple[list[Fired], str]":
    """Firings over a cycle of so many turns, from the first cylinder on, and whether they are even in words.

    A cylinder fires where its piston is on top, at bank less crank angle, in one of the turns; the first at zero.
    """
    require(len(places) <= MOST, "an engine of {count} cylinders is more than the 12 that are answered",
            code="cylinders", count=str(len(places)))  # fmt: skip
    tops = [_within(bank - crank - (places[0][1] - places[0][0]), TURN) for crank, bank in places]
    cycle = turns * TURN
    rows = _most_even(tops, turns) if order is None else _in_order(tops, turns, _numbers(order, len(places)))
    ends = [at for at, _ in rows[1:]] + [cycle]
    fired = [(number + 1, at, end - at) for (at, number), end in zip(rows, ends, strict=True)]
    gaps = [gap / TURN * 360.0 for _, _, gap in fired]
    if max(gaps) - min(gaps) <= 360.0 * ALIKE:
        return fired, f"even, every {gaps[0]:.6g} deg"
    return fired, "uneven: " + ", ".join(f"{abs(gap):.4g}" for gap in gaps) + " deg"


def _within(angle: float, cycle: float) -> float:
    """The angle within a cycle; what rounding leaves of a whole cycle is none."""
    rest = angle % cycle
    return 0.0 if cycle - rest <= ALIKE or rest <= ALIKE else rest


def _most_even(tops: "list[float]", turns: int) -> "list[tuple[float, int]]":
    """The choice of turns whose intervals are most alike, the first cylinder in the first turn."""
    best: list[tuple[float, int]] = []
    least = math.inf
    # later turns first for the earlier cylinders: 1-3-4-2 rather than 1-2-4-3
    for choice in product(range(turns - 1, -1, -1), repeat=len(tops) - 1):
        rows = sorted(
            (top + TURN * turn, number) for number, (top, turn) in enumerate(zip(tops, (0, *choice), strict=True))
        )
        angles = [at for at, _ in rows] + [turns * TURN]
        spread = sum((after - before) ** 2 for before, after in pairwise(angles))
        if spread < least - ALIKE:
            best, least = rows, spread
    return best


def _numbers(order: str, count: int) -> "list[int]":
    numbers = [part.strip() for part in order.replace(",", "-").split("-")]
    require(
        sorted(numbers) == sorted(str(k) for k in range(1, count + 1)),
        "the firing order {order} does not name each of {count} cylinders once",
        code="firing-order",
        hint="such as 1-3-4-2 for four",
        order=order,
        count=str(count),
    )
    whole = [int(number) - 1 for number in numbers]
    first = whole.index(0)
    return whole[first:] + whole[:first]


def _in_order(tops: "list[float]", turns: int, numbers: "list[int]") -> "list[tuple[float, int]]":
    """Each cylinder at its next top after the one before; of two strokes also together with it."""
    rows = [(0.0, numbers[0])]
    at = 0.0
    for number in numbers[1:]:
        at += _within(tops[number] - at, TURN) or (turns - 1) * TURN
        rows.append((at, number))
    require(
        at < turns * TURN - ALIKE,
        "this crankshaft cannot fire in the order {order} within a cycle",
        code="firing-order",
        hint="leave out --firing-order for the most even one",
        order="-".join(str(number + 1) for number in numbers),
    )
    return rows
