"""Rows woven from texts: what they need without arrays."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


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
