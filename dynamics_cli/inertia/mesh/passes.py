"""The two passes over a surface, its blocks by one process a core where there are many.

The sums of a block depend only on its triangles, and blocks are added in the order of the file: results are the same to
the bit on one core.
"""

import os
import sys

import numpy as np

from dynamics_cli.errors import DynamicsError, require
from dynamics_cli.inertia.mesh.block_sums import PART, Room
from dynamics_cli.inertia.mesh.faults.closure import edge_sum
from dynamics_cli.inertia.mesh.frame import Frame
from dynamics_cli.inertia.mesh.integrals import Moments, Sums
from dynamics_cli.inertia.mesh.stl import BLOCK
from dynamics_cli.quantities import Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence
    from typing import Any

    from dynamics_cli.inertia.mesh.stl import Source

    Array = np.ndarray[Any, np.dtype[Any]]
    # adds up the block that lies in a room; the number of triangles before it is for refusals
    Work = Callable[[Room, Any, int], None]

# Coordinates whose fifth powers would leave the range of a double.
LARGEST = 1e55
# Bits of the reference point's coordinates, as many as single precision has.
_REFERENCE_BITS = 24
# Spans whose numbers a pipe holds.
_MOST_SPANS = 1 << 13


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
        def block(space: Room, part: "Any", before: int) -> None:
            part["low"], part["high"] = _box(space.corners, before)
            if prove:
                part["edges"] = edge_sum(space.corners, space.hashes, space.mixed)
            space.seen(reference)
            space.add(part, shell=shell, turned=False)

        return block

    parts = _in_order(source, prepare)
    require(len(parts) > 0, "there are no triangles", code="empty")
    sums = Sums(parts, shell=shell, proved=prove)
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

        def block(space: Room, part: "Any", _: int) -> None:
            a, e, f = space.a, space.e, space.f
            for vector, turned in zip((a, e, f), frame.seen(space.corners).transpose(1, 0, 2), strict=True):
                vector[:] = turned
            reach = [np.abs(corner).max(axis=1) for corner in (a, a + e, a + f)]
            part["extent"] = np.maximum(np.maximum(reach[0], reach[1]), reach[2])
            space.add(part, shell=moments.shell, turned=True)

        return block

    frame = Frame(rows, reference, size, 0)
    sums = Sums(_in_order(source, prepare), shell=moments.shell, grain=frame.grain)
    return Moments(sums, reference, frame, np.maximum(before.high - reference, reference - before.low))


def _in_order(source: "Source", prepare: "Callable[[], Work]") -> "Array":
    """Sums of the blocks of a source, in their order; `prepare` gives each process its working arrays."""
    spans = source.spans()
    processes = min(_cores(), len(spans))
    if processes > 1 and len(spans) <= _MOST_SPANS and _may_fork():
        parts = _side_by_side(spans, processes, prepare)
        if parts is not None:
            return parts
    return np.fromiter(_added(source, prepare(), Room(source.room)), PART)


def _side_by_side(spans: "Sequence[Source]", processes: int, prepare: "Callable[[], Work]") -> "Array | None":
    """Sums of the blocks of all spans by several processes, None where one of them failed.

    Not by threads: between the short calls of a block they wait for one another half of the time.
    """
    import mmap
    import signal
    import warnings

    blocks = [-(-(span.count or 0) // BLOCK) for span in spans]
    ends = np.cumsum(blocks).tolist()
    parts = np.frombuffer(mmap.mmap(-1, ends[-1] * PART.itemsize), PART)
    # whoever is free takes the next span from a pipe
    taken, handed = os.pipe()
    os.write(handed, np.arange(len(spans), dtype=np.uint32).tobytes())
    os.close(handed)

    def work_off() -> None:
        work, room = prepare(), Room(BLOCK)
        while number := os.read(taken, 4):
            index = int.from_bytes(number, sys.byteorder)
            for place, part in enumerate(_added(spans[index], work, room), ends[index] - blocks[index]):
                parts[place] = part

    children: list[int] = []
    try:
        for _ in range(1, processes):
            with warnings.catch_warnings():
                # of threads, from Python 3.12 on
                warnings.simplefilter("ignore", DeprecationWarning)
                child = os.fork()
            if not child:
                try:
                    signal.signal(signal.SIGINT, signal.SIG_DFL)
                    signal.signal(signal.SIGTERM, signal.SIG_DFL)
                    work_off()
                    os._exit(0)
                finally:
                    os._exit(1)
            children.append(child)
        work_off()
        while children:
            _, status = os.waitpid(children[-1], 0)
            children.pop()
            if status:
                return None
    except DynamicsError:
        # another process may have met an earlier fault, which one process alone meets first
        return None
    finally:
        os.close(taken)
        for child in children:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
    return parts


def _added(source: "Source", work: "Work", room: Room) -> "Iterator[Any]":
    """Sums of each block of a source."""
    before = source.first
    for corners in source.blocks(room.corners):
        size = corners.shape[1]
        space = room if size == room.size else Room(size)
        part = np.zeros(1, PART)[0]
        part["count"], part["low"], part["high"] = size, np.inf, -np.inf
        if corners is not space.corners:
            space.corners[:] = corners
        work(space, part, before)
        yield part
        before += size


def _may_fork() -> bool:
    """Whether a copy of this process would be a whole one: without other threads, and not where systems forbid it.

    The thread that hashes a large input holds nothing that a copy needs.
    """
    threading = sys.modules.get("threading")
    others = [thread for thread in threading.enumerate() if thread is not threading.main_thread()] if threading else []
    hashing = all(thread.name.startswith("hash_") for thread in others)
    return hasattr(os, "fork") and sys.platform != "darwin" and hashing


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
