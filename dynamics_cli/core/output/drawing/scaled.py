"""A drawing in the unit of its file: coordinates rounded once, and the bound of the error that the file adds."""

from itertools import pairwise
from math import hypot, ulp

from dynamics_cli.core.units.conversion import from_si
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.outlines import Arc, Cubic, Drawing, Line, Outline, Points

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from dynamics_cli.core.units.unit import Unit
    from dynamics_cli.outlines import Pair, Piece

# The bulge of a quarter turn, with a small margin.
QUARTER = 0.4143
# A bulge below this bends an arc by less than the rounding of its ends.
STRAIGHT = 1e-15
# Halving arcs and calculating their radii takes fewer roundings (of the drawing's size) than this.
HALVING = 64 * 2.0**-53


class FileUnit:
    """A unit that files are written in: its name, and DXF's codes for it."""

    def __init__(self, name: str, insunits: int, measurement: int, millimetres: float) -> None:
        self.name = name
        self.insunits = insunits
        self.measurement = measurement
        self.millimetres = millimetres


# Files follow --units: machines read mm or in, and base is coherent SI here as everywhere.
FILE_UNITS = {
    "si": FileUnit("mm", 4, 1, 1.0),
    "us": FileUnit("in", 1, 0, 25.4),
    "base": FileUnit("m", 6, 1, 1000.0),
}


def scaled(drawing: Drawing, unit: FileUnit) -> Drawing:
    """The drawing in a file's unit; each coordinate is the nearest double, so that equal ends stay equal.

    Outlines without a name are numbered, and pieces too small for doubles of that unit are left out.
    """
    target = parse_unit(unit.name)
    outlines = (
        _scaled_outline(outline, target, outline.name or f"outline {index}")
        for index, outline in enumerate(drawing.outlines, 1)
    )
    construction = (_scaled_outline(outline, target, outline.name) for outline in drawing.construction)
    return Drawing(tuple(outlines), drawing.title, tuple(construction))


def _scaled_outline(outline: Outline, unit: "Unit", name: str) -> Outline:
    converted: dict[float, float] = {}

    def number(si: float) -> float:
        if si not in converted:
            converted[si] = from_si(si, unit)
        return converted[si]

    def pair(point: "Pair") -> "Pair":
        return number(point[0]), number(point[1])

    pieces: list[Piece] = []
    stretch = 1.0
    for piece in outline.pieces:
        scaled_piece: Piece
        if isinstance(piece, Points):
            points = [pair(point) for point in piece.points]
            distinct = [points[0], *(b for a, b in pairwise(points) if a != b)]
            if len(distinct) > 1:
                pieces.append(Points(tuple(distinct)))
            continue
        if isinstance(piece, Cubic):
            scaled_piece = Cubic(pair(piece.start), pair(piece.control1), pair(piece.control2), pair(piece.end))
            vanished = scaled_piece.start == scaled_piece.control1 == scaled_piece.control2 == scaled_piece.end
        elif isinstance(piece, Arc):
            scaled_piece = Arc(pair(piece.start), pair(piece.end), piece.bulge)
            # the points of an arc move at most by this multiple of the movement of its ends
            stretch = max(stretch, hypot(1.0, piece.bulge))
            vanished = scaled_piece.start == scaled_piece.end
        else:
            scaled_piece = Line(pair(piece.start), pair(piece.end))
            vanished = scaled_piece.start == scaled_piece.end
        if not vanished:
            pieces.append(scaled_piece)
    if not pieces:
        raise InadmissibleError(f"{name} is a single point: there is nothing to draw", code="no-drawing")
    rounding = 0.7072 * ulp(max(map(abs, converted.values()))) if unit.numerator != unit.denominator else 0.0
    exact = outline.deviation * (unit.denominator / unit.numerator)
    return Outline(tuple(pieces), outline.closed, round_bound(exact + stretch * rounding), name)


def quartered(drawing: Drawing) -> Drawing:
    """The drawing with every arc in parts of a quarter turn at most, for readers that want a radius.

    A half circle's radius and ends do not fix its centre to the last digits; those of a quarter do.
    """
    construction = tuple(map(_quartered_outline, drawing.construction))
    return Drawing(tuple(map(_quartered_outline, drawing.outlines)), drawing.title, construction)


def _quartered_outline(outline: Outline) -> Outline:
    arcs = [piece for piece in outline.pieces if isinstance(piece, Arc)]
    if not arcs:
        return outline
    size = max(
        max(map(abs, (*arc.start, *arc.end)))
        + (1.0 + abs(arc.bulge)) * hypot(arc.end[0] - arc.start[0], arc.end[1] - arc.start[1])
        for arc in arcs
    )
    pieces: list[Piece] = []
    for piece in outline.pieces:
        pieces.extend(_halves(piece) if isinstance(piece, Arc) else (piece,))
    return Outline(tuple(pieces), outline.closed, round_bound(outline.deviation + HALVING * size), outline.name)


def _halves(arc: Arc) -> "Iterator[Piece]":
    """An arc as parts of a quarter turn at most."""
    bulge = arc.bulge
    if abs(bulge) < STRAIGHT:
        yield Line(arc.start, arc.end)
    elif abs(bulge) <= QUARTER:
        yield arc
    else:
        (x0, y0), (x1, y1) = arc.start, arc.end
        dx, dy = 0.5 * (x1 - x0), 0.5 * (y1 - y0)
        middle = (x0 + dx + bulge * dy, y0 + dy - bulge * dx)
        half = bulge / (1.0 + hypot(1.0, bulge))
        yield from _halves(Arc(arc.start, middle, half))
        yield from _halves(Arc(middle, arc.end, half))


def box(drawing: Drawing) -> "tuple[float, float, float, float]":
    """Bounding box of a drawing: minimum and maximum x, minimum and maximum y."""
    xs: list[float] = []
    ys: list[float] = []
    parts = quartered(drawing)
    for outline in (*parts.outlines, *parts.construction):
        for piece in outline.pieces:
            margin = 0.0
            if isinstance(piece, Points):
                points = piece.points
            elif isinstance(piece, Cubic):
                points = (piece.start, piece.control1, piece.control2, piece.end)
            else:
                points = (piece.start, piece.end)
                if isinstance(piece, Arc):
                    # the rise of the arc over its chord
                    margin = 0.5 * abs(piece.bulge) * hypot(points[1][0] - points[0][0], points[1][1] - points[0][1])
            for x, y in points:
                xs += (x - margin, x + margin)
                ys += (y - margin, y + margin)
    return min(xs), max(xs), min(ys), max(ys)


def round_bound(bound: float) -> float:
    """A bound rounded up to four digits, allowing for the rounding of its own sums."""
    bound *= 1.0 + 1e-12
    rounded = float(f"{bound:.3e}")
    return rounded if rounded >= bound else float(f"{bound * 1.001:.3e}")


def stated(outline: Outline, unit: FileUnit) -> str:
    """The description of an outline in a file."""
    ends = "closed" if outline.closed else "open"
    return f"{outline.name}: {ends}, at most {outline.deviation!r} {unit.name} from the exact curve (proved)"
