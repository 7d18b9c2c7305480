"""Output: to standard output, or to files that appear complete and all together, or not at all."""

import os
from contextlib import suppress

from dynamics_cli.core.termination import Tidy
from dynamics_cli.errors import OutputError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from types import TracebackType
    from typing import Any, BinaryIO, Self

    from dynamics_cli.core.terminal import Terminal

    # A file's name, its contents, and the option that named it.
    File = tuple[str, bytes, str]

_CREATE = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
WRITABLE = 0o222


class WholeFile:
    """One file, written beside its destination under an unpredictable name."""

    def __init__(self, name: str, parameter: str) -> None:
        self._shown = name
        self._parameter = parameter
        self._name = name
        self._file: BinaryIO | None = None
        self._existed = self._renamed = False
        # Temporary names while they exist: of the part written so far, and of the file that was there before.
        self._part = ""
        self._kept = ""

    def open(self) -> None:
        """Open the file; refuses one that cannot be written."""
        self._do(self._open)

    def _open(self) -> None:
        if os.path.isdir(self._shown):
            raise OSError(None, "it is a directory")
        if os.path.exists(self._shown) and not os.path.isfile(self._shown):
            # A device or a pipe must not be replaced by a file.
            self._file = open(self._shown, "wb")  # noqa: SIM115  closed by `finish`
            return
        # A link stays a link: its target is replaced.
        self._name = os.path.realpath(self._shown)
        self._existed = os.path.exists(self._name)
        before = os.stat(self._name) if self._existed else None
        if before is not None and not (before.st_mode & WRITABLE and os.access(self._name, os.W_OK)):
            raise OSError(None, "it is read-only")
        self._part = self._beside()
        # Until it has the mode of the file it replaces, nobody else may read it.
        number = os.open(self._part, _CREATE, 0o600 if before is not None else 0o666)
        self._file = os.fdopen(number, "wb")
        if before is not None and hasattr(os, "fchown"):
            with suppress(PermissionError):  # another user's writable file becomes this user's
                os.fchown(number, before.st_uid, before.st_gid)
            os.fchmod(number, before.st_mode & 0o7777)

    def _beside(self) -> str:
        return os.path.join(os.path.dirname(self._name), f".dynamics-{os.urandom(8).hex()}.part")

    def write(self, data: bytes) -> None:
        """Write some bytes."""
        assert self._file is not None
        self._do(self._file.write, data)

    def finish(self) -> None:
        """Flush everything to the disk."""
        assert self._file is not None
        self._do(self._file.flush)
        if self._part:
            self._do(os.fsync, self._file.fileno())
        self._do(self._file.close)

    def rename(self, *, keep: bool) -> None:
        """Rename it to its final name; `keep` keeps a previous file, so that it can be restored."""
        if not self._part:
            return
        if keep and self._existed:
            backup = self._beside()
            with suppress(OSError):  # a file system without links
                os.link(self._name, backup)
                self._kept = backup
        self._do(os.replace, self._part, self._name)
        self._part = ""
        self._renamed = True

    def settle(self) -> None:
        """Flush the directory entry to the disk too, where the system can."""
        if not self._renamed:
            return
        with suppress(OSError):
            number = os.open(os.path.dirname(self._name), os.O_RDONLY)
            try:
                os.fsync(number)
            finally:
                os.close(number)

    def put_back(self) -> None:
        """Undo the renaming."""
        if not self._renamed:
            return
        with suppress(OSError):  # it stays whole, if new
            if self._kept:
                os.replace(self._kept, self._name)
                self._kept = ""
            elif not self._existed:
                os.unlink(self._name)

    def discard(self) -> None:
        """Remove the temporary files."""
        for name in filter(None, (self._part, self._kept)):
            with suppress(OSError):
                os.unlink(name)
        self._part = self._kept = ""
        if self._file is not None:
            with suppress(OSError):
                self._file.close()

    def _do(self, step: "Callable[..., Any]", *values: "Any") -> None:
        try:
            step(*values)
        except BrokenPipeError:
            raise
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or error
            raise OutputError(f"cannot write {self._shown!r}: {reason}", parameter=self._parameter) from None


class Files:
    """Files that all get their names when the block has ended; if it fails, earlier files stay as they were."""

    def __init__(self, files: "Iterable[File]" = ()) -> None:
        self._given = files
        self._files: list[WholeFile] = []
        self._tidy = Tidy(self._discard)

    def __enter__(self) -> "Self":
        self._tidy.__enter__()
        try:
            for name, data, parameter in self._given:
                self.add(name, parameter).write(data)
        except BaseException:
            self._discard()
            self._tidy.__exit__()
            raise
        return self

    def add(self, name: str, parameter: str = "output") -> WholeFile:
        """One more file, to be written."""
        file = WholeFile(name, parameter)
        # Registered before it exists, so that the clean-up finds it however the process ends.
        self._files.append(file)
        file.open()
        return file

    def __exit__(self, kind: "type[BaseException] | None", error: object, trace: "TracebackType | None") -> None:
        try:
            # A reader such as `head` may close the pipe: the files are still written.
            if kind is None or issubclass(kind, BrokenPipeError):
                for file in self._files:
                    file.finish()
                self._tidy.hold()
                self._rename()
        finally:
            self._discard()
            self._tidy.__exit__()

    def _rename(self) -> None:
        try:
            for file in self._files:
                file.rename(keep=file is not self._files[-1])
        except BaseException:
            for file in self._files:
                file.put_back()
            raise
        for file in self._files:
            file.settle()

    def _discard(self) -> None:
        for file in self._files:
            file.discard()


class OneFile(Files):
    """A single file, written piece by piece."""

    def __init__(self, name: str) -> None:
        super().__init__([(name, b"", "output")])

    def write(self, data: bytes) -> None:
        """Write some bytes."""
        self._files[0].write(data)


class StandardOutput:
    """Standard output with the same interface."""

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


def output(name: str, terminal: "Terminal") -> "OneFile | StandardOutput":
    """The output of a command."""
    return OneFile(name) if name else StandardOutput(terminal)
