"""`--jobs`: pieces of work spread over processes, their results in the order of the pieces.

The processes are forked and share the parent's data; on a system without fork, one process does all the work. Each has
its own pipe and at most one piece, and the parent has no threads: if a process is killed in the middle of a result,
nothing waits for the rest of it.
"""

import itertools
import os
import time
from collections import deque

from dynamics_cli.core.termination import ENDING, Tidy, forget
from dynamics_cli.errors import FaultError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from multiprocessing.connection import Connection
    from types import TracebackType
    from typing import Any, Self

# Pieces read ahead for each process: enough to keep it busy, few enough for constant memory.
AHEAD = 3
# Seconds between a process's checks that its parent is still alive.
PARENT_SEEN = 1.0


def spread(work: "Callable[[Any], Any]", pieces: "Iterable[Any]", jobs: int) -> "Iterator[Any]":
    """`work(piece)` for every piece, in order, at most a few pieces ahead; few pieces are not worth a process."""
    pieces = iter(pieces)
    first = list(itertools.islice(pieces, 2)) if jobs > 1 and hasattr(os, "fork") else []
    pieces = itertools.chain(first, pieces)
    if len(first) < 2:
        yield from map(work, pieces)
        return
    with _Team(work, jobs) as team:
        yield from team.results(pieces)


class _Team:
    """The processes, the pieces waiting for a free one, and the results waiting for their turn."""

    def __init__(self, work: "Callable[[Any], Any]", jobs: int) -> None:
        self._work = work
        self._jobs = jobs
        self._members: list[_Member] = []
        self._waiting: deque[tuple[int, Any]] = deque()
        self._done: dict[int, tuple[bool, Any]] = {}
        self._tidy = Tidy(self._end)

    def __enter__(self) -> "Self":
        import signal

        # A process just forked still has the parent's signal handlers: signals wait until it has its own.
        before = signal.pthread_sigmask(signal.SIG_BLOCK, ENDING)
        try:
            self._tidy.__enter__()
            for _ in range(self._jobs):
                self._members.append(_Member(self._work))
        except BaseException:
            self.__exit__(None, None, None)
            raise
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
        return self

    def __exit__(self, kind: "type[BaseException] | None", error: object, trace: "TracebackType | None") -> None:
        self._end()
        self._tidy.__exit__()

    def _end(self) -> None:
        """Kill all processes at once: pieces in progress may take minutes."""
        for member in self._members:
            member.kill()
        for member in self._members:
            member.bury()

    def results(self, pieces: "Iterable[Any]") -> "Iterator[Any]":
        """The result of every piece, in order."""
        yielded = count = 0
        for piece in pieces:
            self._waiting.append((count, piece))
            count += 1
            self._move(0.0)
            if count - yielded >= AHEAD * self._jobs:
                yield self._next(yielded)
                yielded += 1
        for place in range(yielded, count):
            yield self._next(place)

    def _next(self, place: int) -> "Any":
        while place not in self._done:
            self._move(None)
        well, result = self._done.pop(place)
        if not well:
            raise result
        return result

    def _move(self, timeout: float | None) -> None:
        """Fetch finished results, waiting up to the given time, and hand out waiting pieces."""
        from multiprocessing.connection import wait

        busy = {member.pipe: member for member in self._members if member.place is not None}
        for pipe in wait(list(busy), timeout) if busy else ():
            place, result = busy[pipe].fetch()  # type: ignore[index]
            self._done[place] = result
        for member in self._members:
            if self._waiting and member.place is None:
                member.hand(*self._waiting.popleft())


class _Member:
    """One process, its pipe, and the place of the piece it has, if any."""

    def __init__(self, work: "Callable[[Any], Any]") -> None:
        from multiprocessing import get_context

        context = get_context("fork")
        self.place: int | None = None
        self.pipe, end = context.Pipe()
        self._process = context.Process(target=_serve, args=(work, end, os.getpid()), daemon=True)
        self._process.start()
        # Only the process holds its end of the pipe, so that its death is an end of file here.
        end.close()

    def hand(self, place: int, piece: "Any") -> None:
        """Give it a piece."""
        self.place = place
        try:
            self.pipe.send(piece)
        except OSError:
            raise _ended() from None

    def fetch(self) -> "tuple[int, tuple[bool, Any]]":
        """The index of its piece, whether it succeeded, and the result or the error."""
        place, self.place = self.place, None
        assert place is not None
        try:
            return place, self.pipe.recv()
        except (EOFError, OSError):
            raise _ended() from None

    def kill(self) -> None:
        """Kill the process."""
        self._process.kill()
        self.pipe.close()

    def bury(self) -> None:
        """Wait until it has ended."""
        self._process.join()


def _ended() -> FaultError:
    hint = "the system may have run out of memory: use fewer --jobs"
    return FaultError("one of the --jobs processes was killed from outside", code="process", hint=hint)


def _serve(work: "Callable[[Any], Any]", pipe: "Connection", parent: int) -> None:
    """The loop of a process: leave interruptions to the parent, which ends it, and answer one piece after another."""
    import signal
    from threading import Thread

    # The parent's handlers, which remove its unfinished file, came with the fork.
    forget()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, ENDING)
    Thread(target=_end_with, args=(parent,), daemon=True).start()
    while True:
        piece = pipe.recv()
        try:
            result = True, work(piece)
        except Exception as error:
            result = False, _portable(error)
        pipe.send(result)


def _portable(error: Exception) -> Exception:
    """The error itself if it can be sent to the parent, else its message."""
    import pickle

    try:
        pickle.loads(pickle.dumps(error))
    except Exception:
        return FaultError(f"{type(error).__name__}: {error}")
    return error


def _end_with(parent: int) -> None:
    while os.getppid() == parent:
        time.sleep(PARENT_SEEN)
    os._exit(1)
