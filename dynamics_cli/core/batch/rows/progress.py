"""A progress bar for work of more than about a second, on standard error if it is a terminal."""

from time import monotonic

from dynamics_cli.core.termination import Tidy
from dynamics_cli.progress import Going

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Protocol, Self

    from dynamics_cli.core.terminal import Terminal

    class Work(Protocol):
        """The amount of work, and how much of it is done; for a stream, in bytes."""

        @property
        def size(self) -> int | None:
            """The total, where it is known."""

        @property
        def bytes_read(self) -> int:
            """The amount done."""


PATIENCE = 1.0


class Progress:
    """Shows rows done, and the share of a file read; or as much of other work, `what` being counted."""

    def __init__(self, source: "Work", terminal: "Terminal", what: str = "rows") -> None:
        self._what = what
        self._source = source
        self._terminal = terminal
        self._start = monotonic()
        self._shown: Any = None
        self._task: Any = None
        self._tidy = Tidy(self._show_cursor)
        self._wanted = terminal.shows_progress

    def __enter__(self) -> "Self":
        return self

    def advance(self, rows: int) -> None:
        """Say how far the work has come."""
        if not self._wanted or (self._shown is None and monotonic() - self._start < PATIENCE):
            return
        if self._shown is None:
            self._show()
        self._shown.update(self._task, completed=self._source.bytes_read, rows=rows)

    def _show(self) -> None:
        import io

        from rich.console import Console
        from rich.progress import BarColumn, TextColumn, TimeRemainingColumn
        from rich.progress import Progress as Bar

        text = io.TextIOWrapper(self._terminal.stderr, encoding="utf-8", errors="replace", write_through=True)
        self._text = text
        columns = (TextColumn(self._what), BarColumn(), TextColumn("{task.fields[rows]:,}"), TimeRemainingColumn())
        self._shown = Bar(*columns, console=Console(file=text, force_terminal=True), transient=True)
        self._tidy.__enter__()
        self._shown.start()
        self._task = self._shown.add_task(self._what, total=self._source.size, rows=0)

    def __exit__(self, *_: object) -> None:
        if self._shown is not None:
            self._shown.stop()
            self._tidy.__exit__()
            self._text.detach()  # standard error outlives the bar

    def _show_cursor(self) -> None:
        """Show the cursor that the bar hid."""
        self._terminal.tell("\x1b[?25h\n")


class Counted(Going):
    """A single calculation that says how far it is."""

    def __init__(self, size: float, what: str, terminal: "Terminal") -> None:
        self.size, self.bytes_read = size, 0.0
        self._bar = Progress(self, terminal, what)  # type: ignore[arg-type]

    def __exit__(self, *_: object) -> None:
        self._bar.__exit__()

    def _done(self, amount: float) -> None:
        self.bytes_read = amount
        self._bar.advance(round(amount, 2))  # type: ignore[arg-type]
