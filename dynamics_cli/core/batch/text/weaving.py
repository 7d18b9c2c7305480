"""Rows answered in the same way, their results column by column, and texts woven into rows: all without arrays."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from dynamics_cli.core.output.row_layout import Part

    # (part, "each", one value or text a row), (part, "measured", (texts, units)), (part, "all", that of every row) or
    # (part, "beside", None) where its text is that of the part before.
    Result = tuple[Part, str, Any]

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


def weave(pieces: "list[bytes | list[bytes]]", count: int) -> bytes:
    """Rows of pieces, joined: a piece is the same in every row, or a list with one item for each."""
    merged: list[Any] = []
    for piece in pieces:
        if isinstance(piece, bytes) and merged and isinstance(merged[-1], bytes):
            merged[-1] += piece
        elif piece != b"":
            merged.append(piece)
    woven: list[bytes] = [b""] * (len(merged) * count)
    for index, piece in enumerate(merged):
        woven[index :: len(merged)] = [piece] * count if isinstance(piece, bytes) else piece
    return b"".join(woven)


class Answered:
    """Rows answered in the same way: their indices, results and branch."""

    __slots__ = ("results", "rows", "signature")

    def __init__(self, rows: "Any", results: "list[Result]", signature: "tuple[Any, ...]") -> None:
        self.rows = rows
        self.results = results
        self.signature = signature


def sliced(results: "list[Result]", count: int) -> "Iterator[tuple[slice, list[Result]]]":
    """The results of a few rows at a time: their texts are put together while they are in the processor's cache."""
    step = max(LEAST_SLICE, SLICE_NUMBERS // max(len(results), 1))
    if count <= step:
        yield slice(0, count), results
        return
    for start in range(0, count, step):
        rows = slice(start, min(start + step, count))
        yield rows, [(part, how, rows_of(how, value, rows)) for part, how, value in results]


def rows_of(how: str, value: "Any", rows: "Any") -> "Any":
    """Some rows of a column."""
    if how == "measured":
        columns, units = value
        return [column[rows] for column in columns], units
    return value[rows] if how == "each" else value
