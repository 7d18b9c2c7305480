"""The two passes over a surface, its blocks on every core where there are many; the same to the bit on one core.

The sums of a block depend only on its triangles, and blocks are added in the order of the file.
"""

import os

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.inertia.mesh.block_sums import BlockSum, Room
from dynamics_cli.inertia.mesh.faults.closure import Boundary, edge_sum
from dynamics_cli.inertia.mesh.frame import Frame
from dynamics_cli.inertia.mesh.integrals import Moments, Sums
from dynamics_cli.quantities import Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

    from dynamics_cli.inertia.mesh.stl import Source

    Array = np.ndarray[Any, np.dtype[Any]]
    # adds up the block that lies in a room; the number of triangles before it is for refusals
    Work = Callable[[Room, BlockSum, int], None]

# Coordinates whose fifth powers would leave the range of a double.
LARGEST = 1e55
# Bits of the reference point's coordinates, as many as single precision has.
_REFERENCE_BITS = 24
# Threads wait for one another between the short calls of a block; more than these would mostly wait.
_MOST_THREADS = 8


def first_pass(source: "Source", *, shell: bool, prove: bool) -> "tuple[Sums, Moments]":
    """Integrate over a source in the axes of its file, its boundary summed on the way when `prove` says so.

    Raises InadmissibleError when a coordinate is not finite or out of range, or the file has no triangles.
    """
    reference = np.zeros((3, 1))
    for corners in source.blocks():
        _box(corners, 0)
        reference = _reference(corners)
        break

    def prepare() -> "Work":
        def block(space: Room, part: BlockSum, before: int) -> None:
            part.low, part.high = _box(space.weighted, before)
            if prove:
                part.boundary = edge_sum(space.weighted, space.words, space.hashes, space.mixed, single=source.single)
            space.seen(reference)
            space.add(part, shell=shell, turned=False)

        return block

    sums = Sums(shell=shell, boundary=Boundary() if prove else None)
    for part in _in_order(source, prepare):
        sums.add(part)
    require(sums.count > 0, "there are no triangles", code="empty")
    sums.finish()
    middle = reference[:, 0]
    sums.extent = np.maximum(sums.high - middle, middle - sums.low)
    return sums, Moments(sums, middle)


def second_pass(source: "Source", before: Sums, moments: Moments, rows: "Array") -> Moments:
    """Integrate again, seen from the mass centre in the axes that are the rows of `rows`.

    Coordinates in these axes are exact to a rounding of themselves, so that thin bodies lose no digits.
    """
    reference = moments.centroid
    size = float(max(before.high - before.low))

    def prepare() -> "Work":
        frame = Frame(rows, reference, size, source.room)

        def block(space: Room, part: BlockSum, _: int) -> None:
            a, e, f = space.a, space.e, space.f
            for vector, turned in zip((a, e, f), frame.seen(space.weighted).transpose(1, 0, 2), strict=True):
                vector[:] = turned
            reach = [np.abs(corner).max(axis=1) for corner in (a, a + e, a + f)]
            part.extent = np.maximum(np.maximum(reach[0], reach[1]), reach[2])
            space.add(part, shell=moments.shell, turned=True)

        return block

    frame = Frame(rows, reference, size, 0)
    sums = Sums(shell=moments.shell, grain=frame.grain)
    for part in _in_order(source, prepare):
        sums.add(part)
    sums.finish()
    return Moments(sums, reference, frame, np.maximum(before.high - reference, reference - before.low))


def _in_order(source: "Source", prepare: "Callable[[], Work]") -> "Iterator[BlockSum]":
    """Sums of the blocks of a source, in their order; `prepare` gives each thread its working arrays."""
    spans = source.spans()
    threads = min(_cores(), len(spans), _MOST_THREADS)
    if threads < 2:
        yield from _added(source, prepare(), Room(source.room))
        return
    from concurrent.futures import ThreadPoolExecutor
    from threading import local

    thread_data = local()

    def added(span: "Source") -> "list[BlockSum]":
        if not hasattr(thread_data, "work"):
            thread_data.work, thread_data.room = prepare(), Room(source.room)
        return list(_added(span, thread_data.work, thread_data.room))

    with ThreadPoolExecutor(threads) as pool:
        for parts in pool.map(added, spans):
            yield from parts


def _added(source: "Source", work: "Work", room: Room) -> "Iterator[BlockSum]":
    """Sums of each block of a source."""
    before = source.first
    for corners in source.blocks(room.weighted):
        size = corners.shape[1]
        space, part = room if size == room.size else Room(size), BlockSum(size)
        if corners is not space.weighted:
            space.weighted[:] = corners
        work(space, part, before)
        yield part
        before += size


def _cores() -> int:
    """Cores that this process may use."""
    allowed = getattr(os, "sched_getaffinity", None)
    return len(allowed(0)) if allowed else os.cpu_count() or 1


def _reference(corners: "Array") -> "Array":
    """A point near the first triangles, on a coarse grid so that differences from it are mostly exact."""
    mean = corners.reshape(3, 3, -1).mean(axis=(0, 2), dtype=np.float64)
    mantissa, exponent = np.frexp(mean)
    return np.ldexp(np.round(mantissa * 2.0**_REFERENCE_BITS), exponent - _REFERENCE_BITS)[:, None]  # type: ignore[no-any-return]


def _box(corners: "Array", before: int) -> "tuple[Array, Array]":
    """Minimum and maximum of each coordinate of the corners; refuses coordinates out of range."""
    low, high = np.minimum.reduce(corners, axis=1), np.maximum.reduce(corners, axis=1)
    if np.dot(low, low) + np.dot(high, high) < LARGEST:
        return low, high
    size = max(float(np.abs(low).max()), float(np.abs(high).max()))
    if not size < np.inf:
        column = int(np.argmin(np.isfinite(corners).all(axis=0)))
        row = int(np.argmin(np.isfinite(corners[:, column])))
        require(
            False,
            "coordinate {axis} of corner {corner} of triangle {triangle} is {value}",
            code="not-finite",
            hint="export the file again",
            axis="xyz"[row % 3],
            corner=row // 3 + 1,
            triangle=before + column + 1,
            value=float(corners[row, column]),
        )
    require(size < LARGEST, "a coordinate of {size:3} is out of range", code="range", size=(size, Ratio))
    return low, high
