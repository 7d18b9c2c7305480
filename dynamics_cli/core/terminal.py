"""Standard input, output and error, the environment and the terminal's width, in one object that tests replace."""

import os
import sys

from dynamics_cli.errors import OutputError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from contextlib import AbstractContextManager
    from typing import BinaryIO


def encoded(text: str) -> bytes:
    """Text as bytes; lone surrogates, which no encoding has, are escaped."""
    return text.encode(errors="backslashreplace")


BOLD, RED, YELLOW = "1", "31", "33"


def painted(text: str, colour: str) -> str:
    """Text in a colour of the terminal, or bold."""
    return f"\x1b[{colour}m{text}\x1b[0m"


def painted_answer(text: str) -> str:
    """An answer for the terminal: its first line bold, cautions yellow, serious warnings red."""
    first, *lines = text.split("\n")
    out, colour = [painted(first, BOLD)], ""
    for line in lines:
        if not line.startswith("  "):
            colour = {"serious": RED, "caution": YELLOW}.get(line.partition(": ")[0], "")
        out.append(painted(line, colour) if colour else line)
    return "\n".join(out)


class Terminal:
    """Input and output streams of a command; bytes throughout, so that no locale can change a document."""

    def __init__(
        self,
        stdin: "BinaryIO | None" = None,
        stdout: "BinaryIO | None" = None,
        stderr: "BinaryIO | None" = None,
        environ: "Mapping[str, str] | None" = None,
    ) -> None:
        self._stdin = stdin
        self._stdout = stdout
        self._stderr = stderr
        self.environ = os.environ if environ is None else environ

    @property
    def stdin(self) -> "BinaryIO":
        """Standard input, as bytes."""
        if self._stdin is None and sys.stdin is None:
            raise UsageError("standard input is closed", code="unreadable")
        return self._stdin or sys.stdin.buffer

    @property
    def stdout(self) -> "BinaryIO":
        """Standard output, as bytes."""
        if self._stdout is None and sys.stdout is None:
            raise OutputError("standard output is closed")
        return self._stdout or sys.stdout.buffer

    @property
    def stderr(self) -> "BinaryIO":
        """Standard error, as bytes."""
        return self._stderr or sys.stderr.buffer

    def write(self, text: str) -> None:
        """Write a document to standard output."""
        self.stdout.write(encoded(text))

    def tell(self, text: str) -> None:
        """Write a message to standard error; if that fails, there is nowhere else to write it."""
        if self._stderr is None and sys.stderr is None:
            return
        try:
            self.stderr.write(encoded(text))
            self.stderr.flush()
        except OSError:
            pass

    def flush(self) -> None:
        """Flush the output of the program and of libraries that print text."""
        if self._stdout is None and sys.stdout is not None:
            sys.stdout.flush()
        self.stdout.flush()

    def own_stdout(self) -> "AbstractContextManager[object]":
        """Redirect the output of a library to this terminal's standard output."""
        import contextlib
        import io

        if self._stdout is None:
            return contextlib.nullcontext()
        target = self._stdout

        class Text(io.StringIO):
            def write(self, words: str) -> int:
                return target.write(words.encode())

        return contextlib.redirect_stdout(Text())

    @property
    def columns(self) -> int:
        """Width of standard output if it is a terminal, else 0."""
        try:
            return os.get_terminal_size(self.stdout.fileno()).columns
        except (OSError, ValueError):
            return 0

    @property
    def error_columns(self) -> int:
        """Width of standard error if it is a terminal, else 0."""
        try:
            return os.get_terminal_size(self.stderr.fileno()).columns
        except (AttributeError, OSError, ValueError):
            return 0

    def has_colours(self, columns: int) -> bool:
        """Whether a stream of so many columns (0: not a terminal) shows colours, and NO_COLOR does not forbid them."""
        shown = os.name != "nt" or "WT_SESSION" in self.environ
        return bool(columns and shown and not self.environ.get("NO_COLOR") and self.environ.get("TERM") != "dumb")

    @property
    def shows_progress(self) -> bool:
        """Whether standard error is a terminal."""
        return sys.stderr is not None and self.stderr.isatty()
