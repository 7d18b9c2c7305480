"""SVG, written here: one path for each outline, the view box in the file's unit and the page in its true size.

The y axis of SVG points down, so y changes its sign, which is exact.
"""

from dynamics_cli.core.output.drawing.scaled import box, stated
from dynamics_cli.outlines import Arc, Cubic, Points
from dynamics_cli.version import __version__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.core.output.drawing.scaled import FileUnit
    from dynamics_cli.outlines import Drawing, Outline, Pair, Piece

MARGIN = 0.05
# Construction lines, dash-dotted.
DASHES = ' stroke-dasharray="12 3 2 3" stroke-width="0.5"'


def write(drawing: "Drawing", unit: "FileUnit") -> bytes:
    """The drawing's file; its arcs are of a quarter turn at most."""
    left, right, low, high = box(drawing)
    margin = MARGIN * max(right - left, high - low)
    width, height = right - left + 2.0 * margin, high - low + 2.0 * margin
    view = " ".join(map(_number, (left - margin, -high - margin, width, height)))
    page = "in" if unit.name == "in" else "mm"
    times = 1.0 if page == "in" else unit.millimetres
    title = f"<title>{_escaped(drawing.title)}</title>\n" if drawing.title else ""
    description = [f"dynamics {__version__}; unit: {unit.name}; the y axis points down, as in every SVG"]
    description += [stated(outline, unit) for outline in drawing.outlines]
    paths = "\n".join([*map(_path, drawing.outlines), *(_path(line, DASHES) for line in drawing.construction)])
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_number(times * width)}{page}" '
        f'height="{_number(times * height)}{page}" viewBox="{view}">\n'
        f"{title}<desc>{_escaped('. '.join(description))}.</desc>\n"
        f'<g fill="none" stroke="black" stroke-width="1" stroke-linejoin="round">\n{paths}\n</g>\n</svg>\n'
    ).encode()


def _path(outline: "Outline", style: str = "") -> str:
    words = ["M", _point(outline.pieces[0].start)]
    for piece in outline.pieces:
        words += _words(piece)
    if outline.closed:
        words.append("Z")
    title = f"<title>{_escaped(outline.name)}</title>"
    return f'<path{style} vector-effect="non-scaling-stroke" d="{" ".join(words)}">{title}</path>'


def _words(piece: "Piece") -> "list[str]":
    if isinstance(piece, Points):
        return ["L", *map(_point, piece.points[1:])]
    if isinstance(piece, Cubic):
        return ["C", _point(piece.control1), _point(piece.control2), _point(piece.end)]
    if isinstance(piece, Arc):
        radius = _number(piece.radius)
        # a sweep of 1 turns clockwise where y points up, which is anticlockwise once it points down
        return ["A", radius, radius, "0", "0", "0" if piece.bulge > 0.0 else "1", _point(piece.end)]
    return ["L", _point(piece.end)]


def _point(point: "Pair") -> str:
    return f"{_number(point[0])},{_number(-point[1])}"


def _number(number: float) -> str:
    return repr(number + 0.0).removesuffix(".0")


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")
