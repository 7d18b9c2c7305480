"""Clean-up when a signal ends the process."""

# `signal` brings `enum`, whose import costs more than a calculation: the builtin module itself.
import _signal  # type: ignore[import-not-found]
import os

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from types import FrameType
    from typing import Any, Self

INTERRUPTED = 130
# Signals that end a process which does not handle them. KILL cannot be handled; a crash must not be.
_NAMES = "SIGINT SIGTERM SIGHUP SIGQUIT SIGBREAK SIGALRM SIGVTALRM SIGPROF SIGUSR1 SIGUSR2 SIGXCPU SIGIO SIGPWR"
ENDING: "tuple[int, ...]" = tuple(getattr(_signal, name) for name in _NAMES.split() if hasattr(_signal, name))


def leave(*_: object) -> None:
    """End the process at once, without a traceback; no library can catch the KeyboardInterrupt."""
    os._exit(INTERRUPTED)


def leave_quietly() -> None:
    """Let Ctrl-C and a termination request end the process, unless it was started with them ignored."""
    for number in (_signal.SIGINT, _signal.SIGTERM):
        if _signal.getsignal(number) != _signal.SIG_IGN:
            _signal.signal(number, leave)


class Tidy:
    """Calls `tidy` if a signal ends the process inside; then the signal has its previous effect.

    Signals that are ignored, or that the calling program handles itself, stay as they are.
    """

    def __init__(self, tidy: "Callable[[], object]") -> None:
        self._tidy = tidy
        self._before: dict[int, Any] = {}
        self._held = False
        self._came = 0

    def __enter__(self) -> "Self":
        for number in ENDING:
            before = _signal.getsignal(number)
            if before not in (_signal.SIG_DFL, _signal.default_int_handler, leave) and not _is_tidy(before):
                continue
            try:
                _signal.signal(number, self._end)
            except ValueError:  # not in the main thread, which alone may set signal handlers
                break
            self._before[number] = before
        return self

    def hold(self) -> None:
        """Defer signals until the end of the block, which must not be interrupted."""
        self._held = True

    def __exit__(self, *_: object) -> None:
        for number, before in self._before.items():
            _signal.signal(number, before)
        if self._came:
            _signal.raise_signal(self._came)

    def _end(self, number: int, frame: "FrameType | None") -> None:
        if self._held:
            self._came = number
            return
        before = self._before[number]
        try:
            self._tidy()
        finally:
            if callable(before):
                before(number, frame)
            else:
                _signal.signal(number, before)
                _signal.raise_signal(number)


def _is_tidy(handler: "Any") -> bool:
    return isinstance(getattr(handler, "__self__", None), Tidy)


def forget() -> None:
    """For a process just forked: it must not clean up its parent's files."""
    for number in ENDING:
        if callable(_signal.getsignal(number)):
            _signal.signal(number, _signal.SIG_DFL)
