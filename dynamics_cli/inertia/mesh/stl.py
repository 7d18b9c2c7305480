"""Triangles from STL files in constant memory: blocks of corner coordinates, nine rows by at most 8192 columns."""

import os
from abc import ABC, abstractmethod
from struct import unpack

import numpy as np

from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any, BinaryIO, TypeAlias

    Block: TypeAlias = np.ndarray[Any, np.dtype[Any]]

# Triangles a block; smaller ones pay for calls, larger ones leave the cache.
BLOCK = 8192
# Triangles that one process goes through at a time.
SPAN = 16 * BLOCK
HEADER, RECORD = 84, 50
_TEXT = 1 << 20
_END = b"endfacet"
_BOM = b"\xef\xbb\xbf"


class Source(ABC):
    """Triangles that can be read more than once.

    `count` is how many there are (None until a text has been read through), `single` whether coordinates are stored in
    single precision. `blocks` gives arrays of rows ax, ay, az, bx, … cz without minus zeros, contiguous doubles that
    may be overwritten, and are by the next.
    """

    name = ""
    form = ""
    single = False
    count: "int | None" = None
    # a fault of the file that was tolerated, for a warning
    caution = ""
    # the unit of length stated in the file
    unit = ""
    # the number of triangles of the file before these
    first = 0

    @property
    def room(self) -> int:
        """Triangles of the largest block."""
        return BLOCK if self.count is None else min(self.count, BLOCK)

    @abstractmethod
    def blocks(self, into: "Block | None" = None) -> "Iterator[Block]":
        """Blocks of corner coordinates in order; `into` is room for the largest, which may be used."""

    def spans(self) -> "Sequence[Source]":
        """Sources of consecutive triangles that together are this one, to be gone through side by side."""
        return (self,)


class BinaryStl(Source):
    """A binary STL file whose size agrees with its header."""

    form = "binary STL"
    single = True

    def __init__(self, name: str, count: int, first: int = 0) -> None:
        self.name = name
        self.count: int = count
        self.first = first

    def blocks(self, into: "Block | None" = None) -> "Iterator[Block]":
        """Blocks of corner coordinates in order; `into` is room for the largest, which may be used."""
        rows = np.empty((9, self.room)) if into is None else into
        buffer = bytearray(self.room * RECORD)
        with open(self.name, "rb", buffering=0) as file:
            file.seek(HEADER + RECORD * self.first)
            remaining = self.count
            while remaining:
                size = min(self.room, remaining)
                _fill(file, memoryview(buffer)[: size * RECORD])
                corners = np.ndarray((size, 9), "<f4", buffer, offset=12, strides=(RECORD, 4))
                block = rows if size == rows.shape[1] else rows.reshape(-1)[: 9 * size].reshape(9, size)
                block[:] = corners.T
                # no minus zeros
                np.add(block, 0.0, out=block)
                yield block
                remaining -= size

    def spans(self) -> "Sequence[Source]":
        """Sources of consecutive triangles that together are this one, to be gone through side by side."""
        starts = range(0, self.count, SPAN)
        return [BinaryStl(self.name, min(SPAN, self.count - start), self.first + start) for start in starts]


class TextStl(Source):
    """An ASCII STL file."""

    form = "ASCII STL"

    def __init__(self, name: str) -> None:
        self.name = name

    def blocks(self, into: "Block | None" = None) -> "Iterator[Block]":
        """Blocks of corner coordinates in order."""
        read_so_far = 0
        rest = last = pending = b""
        with open(self.name, "rb") as file:
            while chunk := file.read(_TEXT) or (rest and b"\n"):
                # a line may end in either character or both
                text = rest + chunk.lower().replace(b"\r", b"\n")
                cut = text.rfind(b"\n") + 1
                lines, rest = text[:cut], text[cut:]
                last = lines.rstrip().rpartition(b"\n")[2].lstrip() or last
                body = pending + _nameless(lines)
                end = body.rfind(_END)
                pending = body[end + len(_END) :] if end >= 0 else body
                require(
                    len(pending) + len(rest) < 8 * _TEXT,
                    "no facet ends within {size} bytes",
                    code="stl",
                    size=8 * _TEXT,
                )
                if end < 0:
                    continue
                count, columns = _facets(body[: end + len(_END)])
                require(
                    columns is not None,
                    "facets {first} to {last} of the text are not three corners of three numbers each",
                    code="stl",
                    hint="export the file again, as binary STL if you can",
                    first=read_so_far + 1,
                    last=read_so_far + count,
                )
                assert columns is not None
                read_so_far += count
                for start in range(0, count, BLOCK):
                    yield np.ascontiguousarray(columns[:, start : start + BLOCK])
        require(
            not {b"facet", b"outer", b"vertex"}.intersection(pending.split()),
            "the text ends within facet {first}: the file is incomplete",
            code="truncated",
            hint="copy or export the file again",
            first=read_so_far + 1,
        )
        if not last.startswith(b"endsolid"):
            self.caution = f"the text ends after {read_so_far} triangles without endsolid: triangles may be missing"
        self.count = read_so_far


def _nameless(text: bytes) -> bytes:
    """A text without the lines that name solids: a name may be any word."""
    pieces, position = [], 0
    while (start := text.find(b"solid", position)) >= 0:
        pieces.append(text[position:start].removesuffix(b"end"))
        line = text.find(b"\n", start)
        position = len(text) if line < 0 else line
    return b"".join([*pieces, text[position:]])


def _facets(text: bytes) -> "tuple[int, Block | None]":
    """The number of facets in a text, and their corner coordinates as columns, if each has three corners."""
    count = text.count(_END)
    loops = text.split(b"loop")
    inner = loops[1::2]
    if len(loops) != 2 * count + 1 or any(loop.count(b"vertex") != 3 for loop in inner):
        return count, None
    # the words between numbers show a corner with more or fewer than three of them
    numbers = _numbers(b" ".join(inner).replace(b"end", b" ").replace(b"vertex", b" nan "))
    if numbers.size != 12 * count or not np.isnan(numbers[::4]).all():
        return count, None
    return count, numbers.reshape(-1, 3, 4)[:, :, 1:].reshape(-1, 9).T + 0.0


class Corners(Source):
    """Triangles already in memory, as vertices and the indices of corners."""

    def __init__(self, name: str, form: str, vertices: "Block", faces: "Block") -> None:
        self.name = name
        self.form = form
        self.vertices = np.asarray(vertices, dtype=np.float64) + 0.0
        self.faces = faces
        self.count = len(faces)

    def blocks(self, into: "Block | None" = None) -> "Iterator[Block]":
        """Blocks of corner coordinates in order."""
        for start in range(0, len(self.faces), BLOCK):
            part = self.vertices[self.faces[start : start + BLOCK]]
            yield np.ascontiguousarray(part.reshape(-1, 9).T)


def open_stl(name: str) -> Source:
    """An STL file; binary if its size agrees with its header, even if the header begins with `solid`.

    Raises InadmissibleError when it is empty, is not STL, or its size disagrees with its header.
    """
    size = os.path.getsize(name)
    require(size > 0, "the file is empty", code="empty")
    with open(name, "rb") as file:
        head = file.read(2048)
    claimed = unpack("<I", head[80:HEADER])[0] if len(head) >= HEADER else 0
    if size == HEADER + RECORD * claimed and claimed:
        return BinaryStl(name, claimed)
    words = head.removeprefix(_BOM).lstrip()[:5].lower()
    if words == b"solid" and b"\0" not in head and _has_facet(name, head, size):
        return TextStl(name)
    require(size >= HEADER, "the file has {size} bytes; a binary STL has at least 84", code="truncated", size=size)
    require(claimed > 0, "the header claims no triangles", code="empty")
    present = (size - HEADER) // RECORD
    require(
        False,
        "the header claims {claimed} triangles, {needed} bytes; the file has {size} bytes, enough for {held}",
        code="truncated" if present < claimed else "count",
        hint="copy or export the file again"
        if present < claimed
        else "its count is wrong or something else follows it",
        claimed=claimed,
        needed=HEADER + RECORD * claimed,
        size=size,
        held=present,
    )
    raise AssertionError


def _has_facet(name: str, head: bytes, size: int) -> bool:
    """Whether keywords of an ASCII STL are near the beginning, or the file is an empty solid."""
    low = head.lower()
    if b"facet" in low or b"endsolid" in low:
        return True
    with open(name, "rb") as file:
        return size > len(head) and b"facet" in file.read(1 << 16).lower()


def _fill(file: "BinaryIO", view: memoryview) -> None:
    """Read until the view is full."""
    filled = 0
    while filled < len(view):
        received = file.readinto(view[filled:])  # type: ignore[attr-defined]
        require(received, "the file became shorter while it was read", code="truncated")
        filled += received


def _numbers(text: bytes) -> "Block":
    """Every number of a text, up to the first word that is not a number."""
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        try:
            return np.fromstring(text, dtype=np.float64, sep=" ")
        except ValueError:
            return np.empty(0)
