"""Rows answered in the same way, their results column by column, and texts woven into rows: all without arrays."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any

    from dynamics_cli.core.output.row_layout import Part

    # (part, "each", one value or text a row), (part, "measured", (columns, units)) or (part, "all", that of every row).
    Result = tuple[Part, str, Any]
    # A text of every row, or a column: a text or a number a row.
    Piece = bytes | Sequence[Any]

# Numbers whose texts are put together at once, and the fewest rows.
SLICE_NUMBERS, LEAST_SLICE = 10_000, 100


class Unsuited(Exception):
    """These rows cannot be answered together; `numeric` holds the addresses of the numbers that could be."""

    def __init__(self, why: str, numeric: "set[str] | None" = None) -> None:
        super().__init__(why)
        self.numeric = numeric


class Tokens:
    """Texts that are all numbers."""

    __slots__ = ("tokens",)

    def __init__(self, tokens: "list[bytes]") -> None:
        self.tokens = tokens


def in_runs(pieces: "list[Piece]") -> "list[Any]":
    """Pieces of rows in order: texts, and runs of columns, where columns of numbers with only a comma between are one.

    Their texts are made together, which saves a split and a join for each number.
    """
    merged: list[Any] = []
    for piece in pieces:
        last = merged[-1] if merged else b""
        if not isinstance(piece, bytes):
            if last == b"," and len(merged) > 1 and hasattr(piece, "dtype") and hasattr(merged[-2][-1], "dtype"):
                merged.pop()
                merged[-1].append(piece)
            else:
                merged.append([piece])
        elif merged and isinstance(last, bytes):
            merged[-1] = last + piece
        elif piece:
            merged.append(piece)
    return merged


def weave(pieces: "list[bytes | list[bytes]]", count: int) -> bytes:
    """Rows of pieces, joined: a piece is the same in every row, or a list with one item for each."""
    woven: list[bytes] = [b""] * (len(pieces) * count)
    for index, piece in enumerate(pieces):
        woven[index :: len(pieces)] = [piece] * count if isinstance(piece, bytes) else piece
    return b"".join(woven)


class Answered:
    """Rows answered in the same way: their indices, results and branch."""

    __slots__ = ("results", "rows", "signature")

    def __init__(self, rows: "Any", results: "list[Result]", signature: "tuple[Any, ...]") -> None:
        self.rows = rows
        self.results = results
        self.signature = signature


def slices(width: int, count: int) -> "Iterator[slice]":
    """A few rows at a time: the texts of so many columns are put together while they are in the processor's cache."""
    step = max(LEAST_SLICE, SLICE_NUMBERS // max(width, 1))
    for start in range(0, count, step):
        yield slice(start, min(start + step, count))


def rows_of(how: str, value: "Any", rows: "Any") -> "Any":
    """Some rows of a column."""
    if how == "measured":
        columns, units = value
        return [column[rows] for column in columns], units
    return value[rows] if how == "each" else value
