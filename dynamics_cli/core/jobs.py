"""`--jobs`: pieces of work spread over processes, their results in the order of the pieces.

The processes are forked, so that they have what the parent has read; where a system cannot fork, one process does all.
"""

import itertools
import os

from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from concurrent.futures import Future, ProcessPoolExecutor
    from typing import Any

# Pieces under way for each process: enough to keep it busy, few enough for constant memory.
AHEAD = 3
# What the forked processes carry out; set before they are made.
_work: "Callable[[Any], Any] | None" = None


def spread(work: "Callable[[Any], Any]", pieces: "Iterable[Any]", jobs: int) -> "Iterator[Any]":
    """`work(piece)` for every piece, in order, at most a few pieces ahead; few pieces are not worth a process."""
    pieces = iter(pieces)
    first = list(itertools.islice(pieces, 2)) if jobs > 1 and hasattr(os, "fork") else []
    if len(first) < 2:
        yield from map(work, itertools.chain(first, pieces))
        return
    with _pool(work, jobs) as pool:
        under_way: list[Future[Any]] = []
        try:
            for piece in itertools.chain(first, pieces):
                under_way.append(pool.submit(_carry_out, piece))
                if len(under_way) >= AHEAD * jobs:
                    yield under_way.pop(0).result()
            while under_way:
                yield under_way.pop(0).result()
        finally:
            for future in under_way:
                future.cancel()


def _pool(work: "Callable[[Any], Any]", jobs: int) -> "ProcessPoolExecutor":
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    global _work
    _work = work
    return ProcessPoolExecutor(jobs, get_context("fork"), _begin)


def _begin() -> None:
    """Leave an interruption to the parent, which ends its processes."""
    import signal

    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _carry_out(piece: "Any") -> "Any":
    assert _work is not None
    return _work(piece)


def read_jobs(text: str) -> int:
    """`4`, or `all` for every processor there is."""
    if text == "all":
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if not (text.isascii() and text.isdigit() and len(text) < 4 and int(text) >= 1):
        raise UsageError(f"read {text!r}, wanted a number of processes from 1 to 999, or all", parameter="jobs")
    return int(text)
