"""Lines from a file or a pipe, in blocks: as many as have arrived, never more than fit into a little memory."""

from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import BinaryIO

    from dynamics_cli.core.terminal import Terminal

# Enough rows to amortise array calls, few enough to stay in the processor's cache.
BLOCK_ROWS = 6000
LEAST_BYTES, MOST_BYTES = 1 << 16, 1 << 22
# A longer line cannot be a case, and must not fill the memory.
LONGEST_LINE = 1 << 24
BOM = b"\xef\xbb\xbf"


class Source:
    """A stream of lines: `blocks()` gives lists of lines without their ends.

    A line longer than `LONGEST_LINE` is given as None in a block of its own; the rest of it is read and dropped.
    """

    def __init__(self, name: str, terminal: "Terminal") -> None:
        self.name = name
        self.bytes_read = 0
        self.size: int | None = None
        self._file = terminal.stdin if name == "-" else self._open(name)
        # `read1` returns the bytes received; a buffered `read` would wait for a whole block.
        self._read = getattr(self._file, "read1", self._file.read)
        self._first = True
        self._block = LEAST_BYTES

    def _open(self, name: str) -> "BinaryIO":
        import os

        try:
            file = open(name, "rb", buffering=0)  # noqa: SIM115  closed by `close`
            self.size = os.fstat(file.fileno()).st_size or None
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            message = f"cannot read {name!r}: {reason}"
            raise UsageError(message, code="unreadable", parameter="rows") from None
        return file

    def close(self) -> None:
        """Close the file, but not standard input."""
        if self.name != "-":
            self._file.close()

    def blocks(self) -> "Iterator[list[bytes | None]]":
        """The lines, block by block."""
        rest: list[bytes] = []
        length = 0
        dropping = False
        while data := self._next() if not self._first else self._beginning():
            end = data.rfind(b"\n")
            if dropping:
                start = data.find(b"\n")
                if start < 0:
                    continue
                dropping = False
                yield [None]
                data, end = data[start + 1 :], end - start - 1
            if end < 0:
                rest.append(data)
                length += len(data)
                if length > LONGEST_LINE:
                    rest, length, dropping = [], 0, True
                continue
            block = b"".join((*rest, data[:end])) if rest else data[:end]
            rest = [data[end + 1 :]]
            length = len(rest[0])
            yield self._lines(block)
        if dropping:
            yield [None]
        if last := b"".join(rest):
            yield self._lines(last)

    def _next(self) -> bytes:
        """One read, and further bytes already received, up to a block."""
        data: bytes = self._read(self._block)
        if data and len(data) < self._block and self._more():
            parts = [data]
            missing = self._block - len(data)
            while missing > 0 and self._more():
                part = self._read(missing)
                if not part:
                    break
                parts.append(part)
                missing -= len(part)
            data = b"".join(parts)
        self.bytes_read += len(data)
        return data

    def _beginning(self) -> bytes:
        """The first bytes; for long rows as many as in later blocks, if they have arrived."""
        data = self._next()
        if len(data) < LEAST_BYTES or (self.size is None and not self._more()):
            return data
        self._fit(len(data), data.count(b"\n") + 1)
        self._block -= len(data)
        return data + self._next() if self._block >= LEAST_BYTES else data

    def _more(self) -> bool:
        """Whether more bytes wait in a pipe; false where this cannot be determined."""
        if self.size is not None:
            return False
        from select import select

        try:
            return bool(select([self._file.fileno()], [], [], 0)[0])
        except (OSError, ValueError):
            return False

    def _lines(self, data: bytes) -> "list[bytes | None]":
        if self._first and data:
            self._first = False
            data = data.removeprefix(BOM)
        if b"\r" in data:
            data = data.replace(b"\r\n", b"\n").removesuffix(b"\r")
        lines = data.split(b"\n")
        self._fit(len(data), len(lines))
        return lines  # type: ignore[return-value]

    def _fit(self, length: int, count: int) -> None:
        """Choose how much to read next: about so many rows as a block should have."""
        size = length * BLOCK_ROWS // (count + 1)
        self._block = max(LEAST_BYTES, min(size, MOST_BYTES))
