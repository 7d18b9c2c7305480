"""Plans: scenes as DXF on layers in true coordinates, and as SVG and PDF at their scale on paper."""

import io
from math import hypot

from dynamics_cli.core.output.drawing.dxf import need, written
from dynamics_cli.core.output.drawing.scaled import FileUnit
from dynamics_cli.core.output.plot.axes import Scale, rounded, words
from dynamics_cli.core.units.conversion import from_si
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.pictures import Arrow, Axis, Curve, Label, Mark, Ruler
from dynamics_cli.quantities import Length
from dynamics_cli.version import __version__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.pictures import Plan

    Pair = tuple[float, float]

INCH = 0.0254
METRE, FOOT = FileUnit("m", 6, 1, 1000.0), FileUnit("ft", 2, 0, 304.8)
# AutoCAD colours of layers, and of the first and the second vehicle.
LAYERS = {"road": 8, "marks": 252, "vehicles": 7, "paths": 7, "vectors": 7, "uncertainty": 9, "text": 7}
ROLES = {0: 5, 1: 30, 2: 94, 3: 210}
LAYER_OF = {
    "ground": "road", "track": "marks", "solid": "marks", "filled": "vehicles", "outline": "vehicles",
    "thick": "vehicles", "dotted": "paths", "dashed": "paths",
    "dots": "uncertainty", "thin": "text",
}  # fmt: skip
LINETYPES = {"dotted": "DOT", "dots": "DOT", "dashed": "DASHED"}
# Metres: a tyre's width, which marks are drawn with. Inches on paper: letters, lines, arrowheads.
TYRE, LETTER, LINE, HEAD = 0.2, 0.1, 0.16, 0.1
# Sheets of paper in inches, and the margin of both.
SHEETS = {"us": ("Letter", (11.0, 8.5)), "si": ("A4", (11.693, 8.268))}
MARGIN = 0.35


def write_plan(plan: "Plan", form: str, system: str) -> "tuple[bytes, str]":
    """The file of a plan, and its content in words."""
    if form == "dxf":
        unit = FOOT if system == "us" else METRE
        dxf = _Dxf(plan, system, unit)
        data = written(dxf.fill, [f"dynamics {__version__}: {plan.title}", f"unit: {unit.name}, scale 1 to 1"])
        return data, f"layers {', '.join(dxf.layers)}; in {unit.name}"
    sheet, data = _paper(plan, form, system)
    return data, f"scale 1:{plan.scale:g} on {sheet}"


class _Dxf:
    """The entities of a plan."""

    def __init__(self, plan: "Plan", system: str, unit: FileUnit) -> None:
        self.plan = plan
        self.system = system
        self.unit = unit
        self.metres = plan.scale * INCH
        self.target = parse_unit(unit.name)
        self.layers: list[str] = []

    def fill(self, document: "Any") -> None:
        """Write units, line types, the plan's items and their layers into a DXF document."""
        document.header["$INSUNITS"] = self.unit.insunits
        document.header["$MEASUREMENT"] = self.unit.measurement
        document.linetypes.add("DASHED", self._pattern(0.8, -0.4), description="Dashed __ __ __")
        document.linetypes.add("DOT", self._pattern(0.0, -0.3), description="Dotted . . . .")
        self.space = document.modelspace()
        for item in self.plan.panel.items:
            self._item(item)
        used = {entity.dxf.layer for entity in self.space}
        self.layers = [name for name in LAYERS if name in used]
        for name in self.layers:
            document.layers.add(name, color=LAYERS[name])
        (left, right), (low, high) = _ends(self.plan)
        (x0, y0), (x1, y1) = self._at(left, low), self._at(right, high)
        self.space.reset_extents((x0, y0, 0.0), (x1, y1, 0.0))
        document.set_modelspace_vport(1.05 * max(y1 - y0, x1 - x0), (0.5 * (x0 + x1), 0.5 * (y0 + y1)))

    def _pattern(self, *parts: float) -> "list[float]":
        lengths = [self._length(part) for part in parts]
        return [sum(map(abs, lengths)), *lengths]

    def _length(self, metres: float) -> float:
        return from_si(metres, self.target)

    def _at(self, x: float, y: float) -> "Pair":
        return self._length(x + self.plan.origin[0]), self._length(y + self.plan.origin[1])

    def _line(self, points: "list[Pair]", layer: str, role: int = 6, linetype: str = "", width: float = 0.0) -> None:
        closed = len(points) > 2 and points[0] == points[-1]
        style = {**_style(layer, role), **({"linetype": linetype} if linetype else {})}
        ends = points[:-1] if closed else points
        polyline = self.space.add_lwpolyline([self._at(*point) for point in ends], close=closed, dxfattribs=style)
        if width:
            polyline.dxf.const_width = self._length(width)

    def _item(self, item: "Any") -> None:
        if isinstance(item, Curve):
            points = list(zip(item.x, item.y, strict=True))
            # of the ground its two edges; an area without an edge is nothing to draw
            lines = {"ground": [points[:2], points[2:4]], "fill": []}.get(item.style, [points])
            for line in lines:
                width = TYRE if item.style == "track" else 0.0
                self._line(line, LAYER_OF[item.style], item.role, LINETYPES.get(item.style, ""), width)
        elif isinstance(item, Arrow):
            self._arrow(item.x, item.y, item.dx, item.dy, "vectors", item.role, dashed=item.dashed)
        elif isinstance(item, Label):
            self._text((item.x, item.y), words(item.text, self.system), item.role, left=item.left)
        elif isinstance(item, Mark):
            self.space.add_point(self._at(item.x, item.y), dxfattribs={"layer": "marks"})
        elif isinstance(item, Ruler):
            self._ruler(item)

    def _arrow(self, x: float, y: float, dx: float, dy: float, layer: str, role: int, *, dashed: bool = False) -> None:
        length = hypot(dx, dy)
        if not length:
            return
        head = min(HEAD * self.metres, 0.5 * length) / length
        tip, neck = (x + dx, y + dy), (x + (1.0 - head) * dx, y + (1.0 - head) * dy)
        self._line([(x, y), neck], layer, role, "DASHED" if dashed else "")
        side = -0.3 * head * dy, 0.3 * head * dx
        corners = [tip, (neck[0] + side[0], neck[1] + side[1]), (neck[0] - side[0], neck[1] - side[1])]
        places = [self._at(*corner) for corner in corners]
        self.space.add_solid([*places, places[-1]], dxfattribs=_style(layer, role))

    def _text(self, at: "Pair", text: str, role: int, *, left: bool) -> None:
        alignments = need().enums.TextEntityAlignment
        lines = text.split("\n")
        style = {**_style("text", role), "height": self._length(LETTER * self.metres)}
        align = alignments.MIDDLE_LEFT if left else alignments.MIDDLE_CENTER
        for nth, line in enumerate(lines):
            y = at[1] + (0.5 * (len(lines) - 1) - nth) * LINE * self.metres
            self.space.add_text(line, dxfattribs=style).set_placement(self._at(at[0], y), align=align)

    def _ruler(self, item: Ruler) -> None:
        length, text = rounded(item, self.system)
        tick = 0.04 * self.metres
        if item.arrow:
            self._arrow(item.x, item.y, length, 0.0, "text", 6)
        else:
            x, y, end = item.x, item.y, item.x + length
            ticks = [(x, y - tick), (x, y + tick), (x, y), (end, y), (end, y + tick), (end, y - tick)]
            self._line(ticks, "text")
        self._text((item.x, item.y + 0.14 * self.metres), text, 6, left=True)


def _ends(plan: "Plan") -> "tuple[Pair, Pair]":
    """Where a plan begins and ends along both axes."""
    across, up = plan.panel.x.ends, plan.panel.y.ends
    assert across is not None
    assert up is not None
    return across, up


def _style(layer: str, role: int) -> "dict[str, Any]":
    """The layer of an entity, and its vehicle's colour."""
    return {"layer": layer, **({"color": ROLES[role]} if role in ROLES else {})}


def _paper(plan: "Plan", form: str, system: str) -> "tuple[str, bytes]":
    """The plan on a sheet of paper, or on a larger one where it takes more."""
    from dynamics_cli.core.output.plot.items import DRAW, Pens
    from dynamics_cli.core.output.plot.library import ABOUT, blank, settle
    from dynamics_cli.core.output.plot.library import need as library

    matplotlib = library()
    panel = plan.panel
    spans = _ends(plan)
    wide, high = ((end - start) / (plan.scale * INCH) for start, end in spans)
    name, (across, up) = SHEETS.get(system, SHEETS["si"])
    if wide > across - 2.0 * MARGIN or high > up - 3.0 * MARGIN:
        name, across, up = "a sheet of its own size", wide + 2.0 * MARGIN, high + 3.0 * MARGIN
    with matplotlib.rc_context():
        settle(matplotlib)
        figure = blank(across, up)
        place = (0.5 * (across - wide) / across, 0.5 * (up - MARGIN - high) / up, wide / across, high / up)
        axes = figure.add_axes(place)
        axes.set_axis_off()
        x, y = Scale(Axis("", Length), system), Scale(Axis("", Length), system)
        pens = Pens(panel)
        for item in panel.items:
            DRAW[type(item)](axes, item, x, y, pens)
        axes.set_xlim(*x(spans[0]))
        axes.set_ylim(*y(spans[1]))
        figure.text(MARGIN / across, 1.0 - MARGIN / up, plan.title, fontsize=13.0, fontweight="bold", va="top")
        text = f"scale 1:{plan.scale:g} on {name}, printed at 100 %"
        figure.text(1.0 - MARGIN / across, 1.0 - MARGIN / up, text, fontsize=8.5, color="#555555", ha="right", va="top")
        file = io.BytesIO()
        figure.savefig(file, format=form, metadata=ABOUT[form])
    return name, file.getvalue()
