"""DXF by ezdxf, which only this module imports: LWPOLYLINE with bulges, SPLINE for cubics, the same bytes every time.

R2000, the version most machines read. Cubics that follow one another are one spline, clamped at its ends, with a knot
of multiplicity three at each joint: the control points are those of the cubics, and nothing is fitted again. A curve of
cubics alone is thus one closed entity.
"""

from itertools import groupby

from dynamics_cli.core.output.drawing.scaled import box, stated
from dynamics_cli.errors import UsageError
from dynamics_cli.outlines import Arc, Cubic, Points
from dynamics_cli.version import __version__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.core.output.drawing.scaled import FileUnit
    from dynamics_cli.outlines import Drawing, Outline, Piece

    Vertex = tuple[float, float, float]

APPLICATION = "DYNAMICS"
CLOSED, PLANAR = 1, 8
# Dash, gap, dot and gap of construction lines, as shares of the size of the drawing.
CENTRE = (0.04, -0.008, 0.008, -0.008)
# Characters not allowed in a layer's name.
FORBIDDEN = '<>/\\":;?*|=`,'


def need() -> "Any":
    """The library, or how to get it."""
    try:
        import ezdxf
    except ImportError:
        raise UsageError(
            "DXF needs a part that is not installed",
            code="not-installed",
            parameter="drawing",
            hint="pip install 'dynamics-cli[drawing]'; SVG and CSV need nothing",
        ) from None
    return ezdxf


def write(drawing: "Drawing", unit: "FileUnit") -> bytes:
    """The drawing's file; the same drawing gives the same bytes."""
    return written(lambda document: _fill(document, drawing, unit), _comments(drawing, unit))


def written(fill: "Callable[[Any], None]", comments: "list[str]") -> bytes:
    """The bytes of a file of R2000 that `fill` fills, with comments at its head."""
    import io

    ezdxf = need()
    before = ezdxf.options.write_fixed_meta_data_for_testing
    # else the file would contain the time of day and a random identifier
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        document = ezdxf.new("R2000")
        fill(document)
        stream = io.StringIO()
        document.write(stream)
        body: bytes = document.encode(stream.getvalue())
        return b"".join(b"999\n" + document.encode(line) + b"\n" for line in comments) + body
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before


def _comments(drawing: "Drawing", unit: "FileUnit") -> "list[str]":
    title = f": {drawing.title}" if drawing.title else ""
    lines = [f"dynamics {__version__}{title}", f"unit: {unit.name}"]
    return lines + [stated(outline, unit) for outline in drawing.outlines]


def _fill(document: "Any", drawing: "Drawing", unit: "FileUnit") -> None:
    document.header["$INSUNITS"] = unit.insunits
    document.header["$MEASUREMENT"] = unit.measurement
    document.appids.add(APPLICATION)
    space = document.modelspace()
    left, right, low, high = box(drawing)
    space.reset_extents((left, low, 0.0), (right, high, 0.0))
    document.set_modelspace_vport(1.1 * max(high - low, right - left), (0.5 * (left + right), 0.5 * (low + high)))
    if drawing.construction:
        # lengths of dash, gap and dot in the unit of the file; a positive number draws, a negative one leaves out
        dashes = [length * max(high - low, right - left) for length in CENTRE]
        document.linetypes.add("CENTER", [sum(map(abs, dashes)), *dashes], description="Center ____ _ ____ _ ____")
    for outline in (*drawing.outlines, *drawing.construction):
        layer = outline.name.translate(dict.fromkeys(map(ord, FORBIDDEN), "_"))
        if layer not in document.layers:
            document.layers.add(layer, linetype="CENTER" if outline in drawing.construction else "Continuous")
        for entity in _entities(space, outline):
            entity.dxf.layer = layer
            # 1041 is a distance, which CAD scales with the entity
            entity.set_xdata(APPLICATION, [(1000, f"proved deviation in {unit.name}"), (1041, outline.deviation)])


def _entities(space: "Any", outline: "Outline") -> "list[Any]":
    """Lines and arcs that follow one another as one polyline, cubics that do as one spline."""
    entities: list[Any] = []
    runs = [(kind, list(run)) for kind, run in groupby(outline.pieces, key=lambda piece: isinstance(piece, Cubic))]
    for cubic, run in runs:
        closed = outline.closed and len(runs) == 1
        if cubic:
            entities.append(_spline(space, run, closed=closed))
            continue
        vertices = [vertex for piece in run for vertex in _vertices(piece)]
        ends = vertices if closed else [*vertices, (*run[-1].end, 0.0)]
        entities.append(space.add_lwpolyline(ends, format="xyb", close=closed))
    return entities


def _spline(space: "Any", cubics: "list[Any]", *, closed: bool) -> "Any":
    spline = space.add_spline(degree=3)
    spline.dxf.flags = PLANAR + (CLOSED if closed else 0)
    points = [cubics[0].start]
    for cubic in cubics:
        points += [cubic.control1, cubic.control2, cubic.end]
    count = len(cubics)
    spline.control_points = points
    spline.knots = [0.0] * 4 + [float(joint) for joint in range(1, count) for _ in range(3)] + [float(count)] * 4
    return spline


def _vertices(piece: "Piece") -> "list[Vertex]":
    """A piece's vertices without its end."""
    if isinstance(piece, Points):
        return [(x, y, 0.0) for x, y in piece.points[:-1]]
    return [(*piece.start, piece.bulge if isinstance(piece, Arc) else 0.0)]
