"""Triangles from STL files in constant memory: blocks of corner coordinates, nine rows by at most 8192 columns."""

import os
from struct import unpack

import numpy as np

from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any, BinaryIO, TypeAlias

    Block: TypeAlias = np.ndarray[Any, np.dtype[Any]]

# Triangles a block; smaller ones pay for calls, larger ones leave the cache.
BLOCK = 8192
HEADER, RECORD = 84, 50
_READ = 8 * BLOCK
_TEXT = 1 << 20


class Source:
    """Triangles that can be gone through more than once.

    `count` is how many there are (None until a text has been read through), `single` whether coordinates are stored in
    single precision. `blocks` gives arrays of rows ax, ay, az, bx, … cz without minus zeros; each is overwritten by the
    next.
    """

    name = ""
    form = ""
    single = False
    count: "int | None" = None

    @property
    def room(self) -> int:
        """Triangles of the largest block."""
        return BLOCK if self.count is None else min(self.count, BLOCK)

    def blocks(self) -> "Iterator[Block]":
        """Blocks of corner coordinates in order."""
        raise NotImplementedError


class BinaryStl(Source):
    """A binary STL file whose size is what its header claims."""

    form = "binary STL"
    single = True

    def __init__(self, name: str, count: int) -> None:
        self.name = name
        self.count: int = count

    def blocks(self) -> "Iterator[Block]":
        """Blocks of corner coordinates in order."""
        buffer = bytearray(min(_READ, self.count) * RECORD)
        rows = np.empty((9, self.room), dtype=np.float32)
        zero = np.float32(0.0)
        with open(self.name, "rb", buffering=0) as file:
            file.seek(HEADER)
            left = self.count
            while left:
                size = min(_READ, left)
                _fill(file, memoryview(buffer)[: size * RECORD])
                corners = np.ndarray((size, 9), "<f4", buffer, offset=12, strides=(RECORD, 4))
                for start in range(0, size, BLOCK):
                    part = corners[start : start + BLOCK]
                    block = rows[:, : len(part)]
                    np.add(part.T, zero, out=block)
                    yield block
                left -= size


class TextStl(Source):
    """An STL file of words."""

    form = "ASCII STL"

    def __init__(self, name: str) -> None:
        self.name = name

    def blocks(self) -> "Iterator[Block]":
        """Blocks of corner coordinates in order."""
        import re

        corner = re.compile(rb"vertex([^\r\n]*)", re.IGNORECASE)
        facet = re.compile(rb"end\s*facet", re.IGNORECASE)
        done = 0
        rest = b""
        with open(self.name, "rb") as file:
            while chunk := file.read(_TEXT):
                text = rest + chunk
                ends = [match.end() for match in facet.finditer(text)]
                if not ends:
                    require(len(text) < 8 * _TEXT, "no facet ends within {0} bytes", len(text), code="stl")
                    rest = text
                    continue
                rest = text[ends[-1] :]
                lines = corner.findall(text[: ends[-1]])
                numbers = _numbers(b" ".join(lines))
                require(
                    len(lines) == 3 * len(ends) and numbers.size == 9 * len(ends),
                    "facets {0} to {1} of the text are not three corners of three numbers each",
                    done + 1,
                    done + len(ends),
                    code="stl",
                    hint="export the file again, as binary STL if you can",
                )
                done += len(ends)
                columns = numbers.reshape(-1, 9).T + 0.0
                for start in range(0, len(ends), BLOCK):
                    yield np.ascontiguousarray(columns[:, start : start + BLOCK])
        require(
            b"endsolid" in rest.lower(),
            "the text ends after {0} triangles without endsolid: it is cut off",
            done,
            code="truncated",
            hint="copy or export the file again",
        )
        require(corner.search(rest) is None, "the last facet is not finished", code="truncated")
        self.count = done


class Corners(Source):
    """Triangles already in memory, as vertices and the indices of corners."""

    def __init__(self, name: str, form: str, vertices: "Block", faces: "Block") -> None:
        self.name = name
        self.form = form
        self.vertices = np.asarray(vertices, dtype=np.float64) + 0.0
        self.faces = faces
        self.count = len(faces)

    def blocks(self) -> "Iterator[Block]":
        """Blocks of corner coordinates in order."""
        for start in range(0, len(self.faces), BLOCK):
            part = self.vertices[self.faces[start : start + BLOCK]]
            yield np.ascontiguousarray(part.reshape(-1, 9).T)


def open_stl(name: str) -> Source:
    """An STL file, binary if its size is what its header claims, whatever words the header begins with.

    Raises
    ------
    InadmissibleError
        When it is empty, is neither form of STL, or its size is not what its header claims.
    """
    size = os.path.getsize(name)
    require(size > 0, "the file is empty", code="empty")
    with open(name, "rb") as file:
        head = file.read(2048)
    claimed = unpack("<I", head[80:HEADER])[0] if len(head) >= HEADER else 0
    if size == HEADER + RECORD * claimed and claimed:
        return BinaryStl(name, claimed)
    if head.lstrip()[:5].lower() == b"solid" and b"\0" not in head and _has_facet(name, head, size):
        return TextStl(name)
    require(size >= HEADER, "a file of {0} bytes is no STL: its header alone has 84", size, code="truncated")
    require(claimed > 0, "the header claims no triangles", code="empty")
    held = (size - HEADER) // RECORD
    require(
        False,
        "the header claims {0} triangles, {1} bytes; the file has {2} bytes, room for {3}",
        claimed,
        HEADER + RECORD * claimed,
        size,
        held,
        code="truncated" if held < claimed else "count",
        hint="copy or export the file again" if held < claimed else "its count is wrong or something else follows it",
    )
    raise AssertionError


def _has_facet(name: str, head: bytes, size: int) -> bool:
    """Whether words of an STL text are near the beginning, or the file is an empty solid."""
    low = head.lower()
    if b"facet" in low or b"endsolid" in low:
        return True
    with open(name, "rb") as file:
        return size > len(head) and b"facet" in file.read(1 << 16).lower()


def _fill(file: "BinaryIO", view: memoryview) -> None:
    """Read until the view is full."""
    done = 0
    while done < len(view):
        got = file.readinto(view[done:])  # type: ignore[attr-defined]
        require(got, "the file became shorter while it was read", code="truncated")
        done += got


def _numbers(text: bytes) -> "Block":
    """Every number of a text, up to the first word that is none."""
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        try:
            return np.fromstring(text, dtype=np.float64, sep=" ")
        except ValueError:
            return np.empty(0)
