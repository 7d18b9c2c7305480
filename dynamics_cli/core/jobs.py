"""`--jobs`: pieces of work spread over processes, their results in the order of the pieces.

The processes are forked, so that they have what the parent has read; where a system cannot fork, one process does all.
"""

import itertools
import os
import time

from dynamics_cli.errors import FaultError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from concurrent.futures import Future, ProcessPoolExecutor
    from typing import Any

# Pieces under way for each process: enough to keep it busy, few enough for constant memory.
AHEAD = 3
# How often a process looks whether its parent is still there, in seconds.
PARENT_SEEN = 1.0
# What the forked processes carry out; set before they are made.
_work: "Callable[[Any], Any] | None" = None


def spread(work: "Callable[[Any], Any]", pieces: "Iterable[Any]", jobs: int) -> "Iterator[Any]":
    """`work(piece)` for every piece, in order, at most a few pieces ahead; few pieces are not worth a process."""
    pieces = iter(pieces)
    first = list(itertools.islice(pieces, 2)) if jobs > 1 and hasattr(os, "fork") else []
    if len(first) < 2:
        yield from map(work, itertools.chain(first, pieces))
        return
    from concurrent.futures.process import BrokenProcessPool
    from multiprocessing import active_children

    from dynamics_cli.core.writing import interrupt, on_termination

    others = set(active_children())
    before = on_termination(interrupt)
    pool = _pool(work, jobs)
    under_way: list[Future[Any]] = []
    try:
        for piece in itertools.chain(first, pieces):
            under_way.append(pool.submit(_carry_out, piece))
            if len(under_way) >= AHEAD * jobs:
                yield under_way.pop(0).result()
        while under_way:
            yield under_way.pop(0).result()
        pool.shutdown()
    except BrokenProcessPool:
        hint = "the system may have been out of memory: fewer --jobs need less"
        raise FaultError("one of the processes of --jobs was ended from outside", code="process", hint=hint) from None
    finally:
        # Whatever ended this early does not wait for the pieces that are under way: they may take minutes.
        for child in set(active_children()) - others:
            child.kill()
        _let_go(pool)
        pool.shutdown(cancel_futures=True)
        if before is not None:
            on_termination(before)


def _pool(work: "Callable[[Any], Any]", jobs: int) -> "ProcessPoolExecutor":
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    global _work
    _work = work
    return ProcessPoolExecutor(jobs, get_context("fork"), _begin, (os.getpid(),))


def _let_go(pool: "ProcessPoolExecutor") -> None:
    """Close our own end for reading pieces: Python 3.11 waits for ever while it writes to a pipe nobody reads."""
    reader = getattr(getattr(pool, "_call_queue", None), "_reader", None)
    if reader is not None:
        reader.close()


def _begin(parent: int) -> None:
    """Leave an interruption to the parent, which ends its processes; end with it, should it be killed."""
    import signal
    from threading import Thread

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # The parent's handler, which removes its unfinished file, came with the fork.
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    Thread(target=_end_with, args=(parent,), daemon=True).start()


def _end_with(parent: int) -> None:
    while os.getppid() == parent:
        time.sleep(PARENT_SEEN)
    os._exit(1)


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
