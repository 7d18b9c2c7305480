"""Linear systems of whole numbers solved exactly, and exact ratios turned into doubles with one rounding.

Rows are integers, so elimination needs no special type: importing `fractions` costs a shell user two interpreter
starts.
"""

from math import gcd

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from typing import TypeAlias

    Pair: TypeAlias = tuple[int, int]


def lowest(numerator: int, denominator: int) -> "Pair":
    """Numerator and denominator in lowest terms, the denominator positive."""
    common = gcd(numerator, denominator)
    if denominator < 0:
        common = -common
    return numerator // common, denominator // common


def written(value: "Pair") -> str:
    """`-5/3`, or `7` when it is whole."""
    top, bottom = lowest(*value)
    return str(top) if bottom == 1 else f"{top}/{bottom}"


def exact(x: float) -> "Pair":
    """A double as the ratio it is."""
    return x.as_integer_ratio()


def product(*factors: "Pair") -> "Pair":
    """The exact product."""
    top = bottom = 1
    for numerator, denominator in factors:
        top *= numerator
        bottom *= denominator
    return lowest(top, bottom)


def total(terms: "Iterable[Pair]") -> "Pair":
    """The exact sum."""
    top, bottom = 0, 1
    for numerator, denominator in terms:
        top, bottom = lowest(top * denominator + numerator * bottom, bottom * denominator)
    return top, bottom


def nearest(value: "Pair") -> float:
    """The nearest double; infinite when it leaves the range."""
    numerator, denominator = value
    try:
        return numerator / denominator
    except OverflowError:
        return float("inf") if (numerator < 0) == (denominator < 0) else float("-inf")


def reduce_rows(rows: "Sequence[Sequence[int]]") -> tuple[list[list[int]], list[int]]:
    """Reduced row echelon form of integer rows: the rows that are not zero, and the column of each one's pivot.

    Every row is kept in lowest terms; its pivot is positive and alone in its column.

    References
    ----------
    Gauss–Jordan elimination in integers: each row is divided by its greatest common divisor.
    """
    work = [list(row) for row in rows]
    reduced: list[list[int]] = []
    pivots: list[int] = []
    width = len(work[0]) if work else 0
    for column in range(width):
        index = next((i for i, row in enumerate(work) if row[column]), None)
        if index is None:
            continue
        chosen = work.pop(index)
        _shorten(chosen, column)
        work = [_cleared(row, chosen, column) for row in work]
        reduced = [_cleared(row, chosen, column) for row in reduced]
        for row, pivot_column in zip(reduced, pivots, strict=True):
            _shorten(row, pivot_column)
        reduced.append(chosen)
        pivots.append(column)
    return reduced, pivots


def _cleared(row: list[int], pivot: list[int], column: int) -> list[int]:
    if not row[column]:
        return row
    a, b = pivot[column], row[column]
    return [a * element - b * pivot_element for element, pivot_element in zip(row, pivot, strict=True)]


def _shorten(row: list[int], pivot: int) -> None:
    common = gcd(*row)
    if row[pivot] < 0:
        common = -common
    if common != 1:
        row[:] = [value // common for value in row]


class Solved:
    """Homogeneous equations solved for some columns in terms of others that are given.

    `freedom` counts the solutions when nothing is given; `terms(column)` gives a column as exact multiples of the given
    ones, or None when the equations leave it open; `conflict` names given columns that are not free of one another.
    """

    def __init__(self, rows: "Sequence[Sequence[int]]", width: int, given: "Sequence[int]") -> None:
        order = [column for column in range(width) if column not in given] + list(given)
        self._place = {column: place for place, column in enumerate(order)}
        self._first_given = width - len(given)
        self._given = tuple(given)
        reduced, pivots = reduce_rows([[row[column] for column in order] for row in rows])
        self.freedom = width - len(pivots)
        self._rows = dict(zip(pivots, reduced, strict=True))
        self.conflict = tuple(order[pivot] for pivot in pivots if pivot >= self._first_given)

    def terms(self, column: int) -> "tuple[tuple[int, int], ...] | None":
        """The column as multiples, numerator and denominator, of the given columns in their order."""
        if column in self._given:
            return tuple((1 if column == other else 0, 1) for other in self._given)
        place = self._place[column]
        row = self._rows.get(place)
        if row is None or any(row[other] for other in range(self._first_given) if other != place):
            return None
        return tuple(lowest(-row[self._first_given + k], row[place]) for k in range(len(self._given)))
