"""Records of CSV: lines, and several lines together where a quoted cell runs over their ends."""

from collections import deque

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    Lines = list[bytes | None]

# A quote that is never closed must not swallow the rest of the stream.
MOST_LINES = 1000


def cleared(blocks: "Iterable[Lines]") -> "Iterator[Lines]":
    """Blocks without empty lines; blocks of only empty lines are left out."""
    for lines in blocks:
        filled = [line for line in lines if line is None or line] if b"" in lines else lines
        if filled:
            yield filled


def records(blocks: "Iterable[Lines]") -> "Iterator[Lines]":
    """Blocks whose lines are complete records; a line too long to be read remains a block of its own."""
    joiner = _Joiner()
    for lines in blocks:
        if None in lines:
            yield joiner.rest()
            yield lines
        elif joiner.held or not _closed(b"\n".join(lines)):  # type: ignore[arg-type]
            yield joiner.joined(lines)  # type: ignore[arg-type]
        else:
            yield lines
    yield joiner.rest()


def first_record(lines: "Lines") -> "tuple[bytes, Lines]":
    """The first record of lines that begin with one, and the lines after it."""
    assert lines[0] is not None
    for count in range(1, min(len(lines), MOST_LINES) + 1):
        if lines[count - 1] is None:
            break
        if _whole(lines[:count]):  # type: ignore[arg-type]
            return b"\n".join(lines[:count]), lines[count:]  # type: ignore[arg-type]
    return lines[0], lines[1:]


def with_commas(blocks: "Iterable[Lines]", separator: bytes) -> "Iterator[Lines]":
    """Blocks whose cells were parted by another separator: with commas instead."""
    for lines in blocks:
        data = b"" if None in lines else b"\n".join(lines)  # type: ignore[arg-type]
        if data and b'"' not in data and b"," not in data:
            yield data.replace(separator, b",").split(b"\n")  # type: ignore[misc]
        else:
            yield [line and _with_commas(line, separator.decode()) for line in lines]


def _with_commas(line: bytes, separator: str) -> bytes:
    import csv
    from io import StringIO

    written = StringIO()
    try:
        cells = next(csv.reader([line.decode(errors="surrogateescape")], delimiter=separator, strict=True))
    except csv.Error:
        return line  # refused in its place
    csv.writer(written, lineterminator="").writerow(cells)
    return written.getvalue().encode(errors="surrogateescape")


class _Joiner:
    """Lines that wait for the end of a quoted cell.

    A quote that is not closed within `MOST_LINES` lines stays with its own line, and the next line is a record again.
    """

    def __init__(self) -> None:
        self.held: list[bytes] = []

    def joined(self, lines: "list[bytes]") -> "Lines":
        """The records that these lines complete."""
        waiting, records = deque(lines), list[bytes | None]()
        while waiting:
            line = waiting.popleft()
            self.held.append(line)
            record = _whole(self.held) if b'"' in line or len(self.held) == 1 else None
            if record is None and len(self.held) < MOST_LINES:
                continue
            first, *following = self.held
            self.held = []
            if record:
                records.append(b"\n".join((first, *following)))
            else:
                records.append(first)
                waiting.extendleft(reversed(following))
        return records

    def rest(self) -> "Lines":
        """Lines still waiting at the end: the first one as it is, the others as records."""
        records: Lines = []
        while self.held:
            first, *following = self.held
            self.held = []
            records += [first, *self.joined(following)]
        return records


def _closed(data: bytes) -> bool:
    """Whether every cell ends in its line: none is quoted, or each of those is closed and has no quote in it."""
    if b'"' not in data:
        return True
    import re

    cell = rb'(?:"[^"\n]*"|[^",\n]*)'
    return re.fullmatch(rb"(?:" + cell + rb"[,\n])*" + cell, data) is not None


def _whole(lines: "list[bytes]") -> bool | None:
    """Whether lines are one record; None where its last cell is still open."""
    # a carriage return within a line is an ordinary character, but the csv module takes it for an end
    text = b"\n".join(lines).replace(b"\r", b" ")
    if b'"' not in text:
        return True
    import csv

    try:
        next(csv.reader([text.decode(errors="replace")], strict=True))
    except csv.Error as error:
        return None if "unexpected end" in str(error) else False
    return True
