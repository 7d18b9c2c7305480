"""CSV: a table of the pieces in order, every number the shortest text that reads back as the same double."""

from itertools import pairwise

from dynamics_cli.core.output.csv_text import csv_cell
from dynamics_cli.core.output.drawing.scaled import STRAIGHT
from dynamics_cli.outlines import Arc, Cubic, Points

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from dynamics_cli.core.output.drawing.scaled import FileUnit
    from dynamics_cli.outlines import Drawing, Piece

LENGTHS = (
    "start_x", "start_y", "end_x", "end_y", "control1_x", "control1_y", "control2_x", "control2_y", "centre_x",
    "centre_y", "radius", "deviation",
)  # fmt: skip
COLUMNS = ("outline", "closed", "piece", "kind", "bulge", *LENGTHS)


def write(drawing: "Drawing", unit: "FileUnit") -> bytes:
    """The drawing's file: a row for each straight line, arc and cubic; those of one polyline share its number.

    An arc is its ends and its bulge, which are exact; its centre and radius are worked out from them.
    """
    lines = [",".join(f"{name}[{unit.name}]" if name in LENGTHS else name for name in COLUMNS)]
    for outline in drawing.outlines:
        name, closed = csv_cell(outline.name), "true" if outline.closed else "false"
        for number, piece in enumerate(outline.pieces, 1):
            for kind, bulge, lengths in _rows(piece):
                cells = [repr(length) if length is not None else "" for length in lengths]
                head = (name, closed, str(number), kind, repr(bulge) if kind == "arc" else "")
                lines.append(",".join((*head, *cells, repr(outline.deviation))))
    return ("\n".join(lines) + "\n").encode()


def _rows(piece: "Piece") -> "Iterator[tuple[str, float, tuple[float | None, ...]]]":
    nothing = (None,) * 4
    if isinstance(piece, Points):
        for start, end in pairwise(piece.points):
            yield "line", 0.0, (*start, *end, *nothing, None, None, None)
    elif isinstance(piece, Cubic):
        yield "cubic", 0.0, (*piece.start, *piece.end, *piece.control1, *piece.control2, None, None, None)
    elif isinstance(piece, Arc):
        straight = abs(piece.bulge) < STRAIGHT
        circle = (None, None, None) if straight else (*piece.centre, piece.radius)
        yield "arc", piece.bulge, (*piece.start, *piece.end, *nothing, *circle)
    else:
        yield "line", 0.0, (*piece.start, *piece.end, *nothing, None, None, None)
