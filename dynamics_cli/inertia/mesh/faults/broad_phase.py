"""Pairs that may meet: boxes with boxes, and points with the rectangles around them, by a sweep within strips.

The space is cut into strips along one axis, about as wide as two boxes, and each strip is swept along another: the
work grows with the number of neighbouring pairs, not with the square of all.
"""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    Array = np.ndarray[Any, np.dtype[Any]]

# Pairs that are formed at once.
AT_ONCE = 200_000
# At most as many strips as boxes, each at least this many box widths wide.
WIDTH = 2.0
# Places along the sweep take half of the way from one strip's number to the next.
HALF, SLACK = 0.5, 1e-9


class Pairs:
    """For each entry a stretch of another order, paired with it block by block."""

    def __init__(self, starts: "Array", sizes: "Array") -> None:
        self.starts = starts
        self.sizes = sizes

    @property
    def count(self) -> int:
        """Number of pairs examined."""
        return int(self.sizes.sum())

    def blocks(self) -> "Iterator[tuple[Array, Array]]":
        """Which entry, and which place in the other order, for about so many pairs at once."""
        total = np.concatenate(([0], np.cumsum(self.sizes)))
        start, end = 0, len(self.sizes)
        while start < end:
            stop = max(int(np.searchsorted(total, total[start] + AT_ONCE, side="right")) - 1, start + 1)
            sizes = self.sizes[start:stop]
            first = np.repeat(np.arange(start, stop), sizes)
            place = np.arange(len(first)) - np.repeat(total[start:stop] - total[start], sizes)
            yield first, np.repeat(self.starts[start:stop], sizes) + place
            start = stop


class _Strips:
    """Strips along `across`, and places along `along`, for boxes within one range."""

    def __init__(self, low: "Array", high: "Array", along: int, across: int) -> None:
        self.along, self.across = along, across
        self.low, extent = low.min(axis=0), np.ptp(np.concatenate((low, high)), axis=0)
        self.extent = np.where(extent > 0.0, extent, 1.0)
        mean = float((high[:, across] - low[:, across]).mean()) / float(self.extent[across])
        self.number = int(min(max(1.0, 1.0 / (WIDTH * mean) if mean > 0.0 else len(low)), len(low)))

    def strip(self, points: "Array") -> "Array":
        """The number of the strip of each point."""
        fraction = (points[:, self.across] - self.low[self.across]) / self.extent[self.across]
        return np.clip((fraction * self.number).astype(int), 0, self.number - 1)  # type: ignore[no-any-return]

    def place(self, points: "Array") -> "Array":
        """How far along the sweep each point is, as a share of the way to the next strip's number."""
        return HALF * (points[:, self.along] - self.low[self.along]) / self.extent[self.along]  # type: ignore[no-any-return]

    def entries(self, low: "Array", high: "Array") -> "tuple[Array, Array]":
        """Every box once for each strip that it reaches: the box, and the strip."""
        first = self.strip(low)
        sizes = self.strip(high) - first + 1
        owner = np.repeat(np.arange(len(low)), sizes)
        offset = np.arange(len(owner)) - np.repeat(np.cumsum(sizes) - sizes, sizes)
        return owner, first[owner] + offset


def _slender(low: "Array", high: "Array") -> "list[int]":
    """Axes by the mean size of boxes relative to the extent, smallest first."""
    extent = np.ptp(np.concatenate((low, high)), axis=0)
    fraction = (high - low).mean(axis=0) / np.where(extent > 0.0, extent, 1.0)
    fraction = np.where(extent > 0.0, fraction, 1.0)
    return sorted(range(low.shape[1]), key=lambda axis: float(fraction[axis]))


def _column(low: "Array", high: "Array", axis: int) -> "tuple[Array, Array]":
    return np.ascontiguousarray(low[:, axis]), np.ascontiguousarray(high[:, axis])


class MeetingBoxes:
    """Pairs of boxes that meet."""

    def __init__(self, low: "Array", high: "Array") -> None:
        along, across, rest = _slender(low, high)
        strips = _Strips(low, high, along, across)
        # first the coordinate not yet tested by strip or sweep
        self.ranges = [_column(low, high, axis) for axis in (rest, across, along)]
        owner, strip = strips.entries(low, high)
        key = strip + strips.place(low)[owner]
        order = np.argsort(key, kind="stable")
        self.owner, self.strip = owner[order], strip[order]
        ends = np.searchsorted(key[order], (strip + strips.place(high)[owner])[order] + SLACK, side="right")
        begin = np.arange(len(order)) + 1
        self.pairs = Pairs(begin, ends - begin)
        self.first = strips.strip(low)

    def __iter__(self) -> "Iterator[tuple[Array, Array]]":
        for entry, place in self.pairs.blocks():
            first, second = self.owner[entry], self.owner[place]
            # a pair in several strips is counted in the first that both reach
            once = self.strip[entry] == np.maximum(self.first[first], self.first[second])
            first, second = first[once], second[once]
            for low, high in self.ranges:
                meet = low[first] <= high[second]
                meet &= low[second] <= high[first]
                first, second = first[meet], second[meet]
            yield first, second


class BoxesAround:
    """Pairs of a point and a box around it, of two coordinates each."""

    def __init__(self, points: "Array", low: "Array", high: "Array") -> None:
        along, across = _slender(low, high)
        strips = _Strips(low, high, along, across)
        self.ranges = [(np.ascontiguousarray(points[:, axis]), *_column(low, high, axis)) for axis in (across, along)]
        self.box, strip = strips.entries(low, high)
        keys = strips.strip(points) + strips.place(points)
        self.order = np.argsort(keys, kind="stable")
        keys = keys[self.order]
        starts = np.searchsorted(keys, strip + strips.place(low)[self.box] - SLACK, side="left")
        ends = np.searchsorted(keys, strip + strips.place(high)[self.box] + SLACK, side="right")
        self.pairs = Pairs(starts, ends - starts)

    def __iter__(self) -> "Iterator[tuple[Array, Array]]":
        for entry, place in self.pairs.blocks():
            point, box = self.order[place], self.box[entry]
            for coordinates, low, high in self.ranges:
                values = coordinates[point]
                inside = low[box] <= values
                inside &= values <= high[box]
                point, box = point[inside], box[inside]
            yield point, box
