"""Output: to standard output, or to a file that is written whole or not at all."""

import os

from dynamics_cli.errors import OutputError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from types import TracebackType
    from typing import Any, BinaryIO, Self

    from dynamics_cli.core.terminal import Terminal

    # A file's name, what it is to hold, and the option that named it.
    File = tuple[str, bytes, str]


class WholeFile:
    """A file that appears under its name only when everything has been written."""

    def __init__(self, name: str, parameter: str = "output") -> None:
        self.parameter = parameter
        # A link stays a link: what it points to is replaced.
        self.name = name if os.path.isdir(name) else os.path.realpath(name)
        folder, last = os.path.split(self.name)
        self._part = os.path.join(folder, f".{last}.{os.getpid()}.part")
        self._file: BinaryIO | None = None
        self._before: Any = None

    def __enter__(self) -> "Self":
        if os.path.isdir(self.name):
            raise OutputError(f"cannot write {self.name!r}: it is a directory", parameter=self.parameter)
        self._before = on_termination(interrupt)
        try:
            self._file = open(self._part, "wb")
        except OSError as error:
            raise self._failure(error) from None
        return self

    def write(self, data: bytes) -> None:
        """Write some bytes."""
        assert self._file is not None
        try:
            self._file.write(data)
        except OSError as error:
            raise self._failure(error) from None

    def __exit__(self, kind: "type[BaseException] | None", error: object, trace: "TracebackType | None") -> None:
        assert self._file is not None
        try:
            self._file.close()
            if kind is None:
                if os.path.exists(self.name) and not os.path.isfile(self.name):
                    self._copy_into_special()
                else:
                    if os.path.exists(self.name):
                        os.chmod(self._part, os.stat(self.name).st_mode & 0o7777)
                    os.replace(self._part, self.name)
        except OSError as failure:
            raise self._failure(failure) from None
        finally:
            if os.path.exists(self._part):
                os.unlink(self._part)
            if self._before is not None:
                on_termination(self._before)

    def _copy_into_special(self) -> None:
        """A device or a pipe must not be replaced by a file."""
        with open(self._part, "rb") as source, open(self.name, "wb") as target:
            while block := source.read(1 << 20):
                target.write(block)

    def _failure(self, error: OSError) -> OutputError:
        return OutputError(f"cannot write {self.name!r}: {error.strerror or error}", parameter=self.parameter)


def on_termination(handler: "Any") -> "Any":
    """Say what a request to end the process does, so that no part of a file is left behind; what it did before."""
    import signal

    try:
        return signal.signal(signal.SIGTERM, handler)
    except ValueError:  # not in the main thread: the caller's to decide
        return None


def interrupt(*_: object) -> None:
    """End the process as Ctrl-C does."""
    raise KeyboardInterrupt


class Beforehand:
    """Files written before what is done inside; should that fail, what was there before is there again."""

    def __init__(self, files: "list[File]") -> None:
        self._files = files
        self._before: list[tuple[str, bytes | None, str]] = []

    def __enter__(self) -> "Self":
        try:
            for name, data, parameter in self._files:
                before = self._read(name, parameter)
                self._write(name, data, parameter)
                self._before.append((name, before, parameter))
        except BaseException:
            self._take_back()
            raise
        return self

    def __exit__(self, kind: "type[BaseException] | None", error: object, trace: "TracebackType | None") -> None:
        # A reader that has seen enough closes the pipe: the files were written all the same.
        if kind is not None and not issubclass(kind, BrokenPipeError):
            self._take_back()

    @staticmethod
    def _read(name: str, parameter: str) -> bytes | None:
        if not os.path.isfile(name):
            return None
        try:
            with open(name, "rb") as file:
                return file.read()
        except OSError as error:
            message = f"cannot write {name!r}: what it holds cannot be kept ({error.strerror or error})"
            raise OutputError(message, parameter=parameter) from None

    @staticmethod
    def _write(name: str, data: bytes, parameter: str) -> None:
        with WholeFile(name, parameter) as file:
            file.write(data)

    def _take_back(self) -> None:
        while self._before:
            name, data, parameter = self._before.pop()
            if data is not None:
                self._write(name, data, parameter)
            elif os.path.isfile(name):
                os.unlink(os.path.realpath(name))


class StandardOutput:
    """Standard output with the same manners."""

    def __init__(self, terminal: "Terminal") -> None:
        self._file = terminal.stdout

    def __enter__(self) -> "Self":
        return self

    def write(self, data: bytes) -> None:
        """Write some bytes; a closed pipe is left to the caller."""
        try:
            self._file.write(data)
        except BrokenPipeError:
            raise
        except OSError as error:
            raise OutputError(f"cannot write to standard output: {error.strerror or error}") from None

    def __exit__(self, kind: "type[BaseException] | None", error: object, trace: "TracebackType | None") -> None:
        try:
            self._file.flush()
        except BrokenPipeError:
            raise
        except OSError as failure:
            raise OutputError(f"cannot write to standard output: {failure.strerror or failure}") from None


def output(name: str, terminal: "Terminal") -> "WholeFile | StandardOutput":
    """Where a command writes."""
    return WholeFile(name) if name else StandardOutput(terminal)
