"""`--time-limit "30 s"`: an alarm ends a calculation at any point; the answer holds the results obtained by then."""

from dynamics_cli.errors import InadmissibleError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

# The alarm repeats, in case the first occurs where exceptions are lost (a destructor) or while it is deferred.
AGAIN = 0.2
LONGEST = 1e8
# Not empty during a write. A signal mask would not work: other threads receive signals that this one blocks.
_held: list[bool] = []


class Reached(BaseException):
    """The time limit was reached. Not an Exception: code that turns errors into rows or cases must let it through."""


def read_time_limit(text: str) -> float:
    """The limit in seconds."""
    from dynamics_cli.core.inputs.quantity_text import read_scalar
    from dynamics_cli.quantities import Kind

    try:
        return read_scalar(text, Kind("time limit", "s", above=0.0, high=LONGEST, example="30 s")).si
    except UsageError as error:
        error.parameter = "time-limit"
        raise


def within(text: str, work: "Callable[[], Any]") -> "Any":
    """The result of `work`, or an error if it exceeds the time limit; without a limit just the result."""
    if not text:
        return work()
    import signal

    seconds = read_time_limit(text)
    try:
        before = signal.signal(signal.SIGALRM, _ring)
    except (AttributeError, ValueError):
        message = "--time-limit works in the main thread of systems that have interval timers"
        raise UsageError(message, parameter="time-limit", code="unsupported") from None
    try:
        try:
            signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN)
            return work()
        finally:
            stop()
    except Reached:
        stop()
        raise reached(text, "before there was an answer") from None
    finally:
        signal.signal(signal.SIGALRM, before)


def _ring(number: int, frame: object) -> None:
    if not _held:
        raise Reached


def stop() -> None:
    """Cancel the limit: the remaining work is short and must not be interrupted."""
    import signal

    signal.setitimer(signal.ITIMER_REAL, 0.0)


def held(write: "Callable[[bytes], Any]") -> "Callable[[bytes], None]":
    """`write`, with the alarm deferred until it is done."""

    def whole(data: bytes) -> None:
        _held.append(True)
        try:
            write(data)
        finally:
            _held.pop()

    return whole


def reached(text: str, where: str) -> InadmissibleError:
    """The error of a call that ends at its time limit."""
    hint = "raise --time-limit, or ask for less"
    return InadmissibleError(f"the time limit of {text} was reached {where}", code="time-limit", hint=hint)


def clock() -> float:
    """Seconds of a clock that only goes forward."""
    from time import perf_counter

    return perf_counter()
