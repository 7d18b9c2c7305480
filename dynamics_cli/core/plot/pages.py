"""Pictures in files: SVG, PNG and PDF by matplotlib, which only this module imports; the same bytes every time."""

import io
from textwrap import fill

from dynamics_cli.core.plot.axes import Scale, finite
from dynamics_cli.errors import UsageError
from dynamics_cli.pictures import Arrow, Band, Bars, Curve, Mark
from dynamics_cli.quantities import Count

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.pictures import Axis, Panel, Picture

# Okabe and Ito's colours, which colour-blind readers tell apart; yellow is left out, being lost on paper.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
# Dashes and markers go with the colours, so that a grey print tells curves apart as well.
DASHES: "tuple[Any, ...]" = (
    "-", (0, (7, 2)), (0, (7, 2, 1.5, 2)), (0, (3, 1.5)), (0, (7, 2, 1.5, 2, 1.5, 2)), (0, (1.2, 1.2)), (0, (12, 3)),
)  # fmt: skip
MARKERS = "os^Dv<>"
# Inches by the number of columns: what a page of paper takes with hardly any shrinking of the words.
WIDTHS = (6.6, 7.6, 8.4)
HEIGHT = 3.0
EQUAL_HEIGHT = 5.0
LEAST_HEIGHT = 1.8
# Letters of a title and ticks of an axis over the whole width.
LONGEST_TITLE = 84
MOST_TICKS = 12
RESOLUTION = 160
_STYLES: "dict[str, dict[str, Any]]" = {
    "solid": {"linestyle": "-", "linewidth": 1.5},
    "dashed": {"linestyle": "--", "linewidth": 1.3},
    "dotted": {"linestyle": ":", "linewidth": 1.5},
    "thin": {"linestyle": "-", "linewidth": 0.7},
    "points": {"linestyle": "none", "marker": "o", "markersize": 3.5},
    "steps": {"linestyle": "-", "linewidth": 1.5, "drawstyle": "steps-post"},
    "filled": {"linestyle": "-", "linewidth": 1.2},
}
_SETTINGS = {
    "svg.hashsalt": "dynamics",
    "svg.fonttype": "path",
    "pdf.compression": 6,
    "font.family": "DejaVu Sans",
    "font.size": 9.0,
    "axes.titlesize": 9.5,
    "axes.grid": True,
    "grid.linewidth": 0.4,
    "grid.color": "#cccccc",
    "axes.axisbelow": True,
    "legend.frameon": False,
    "legend.fontsize": 8.0,
    "legend.handlelength": 3.2,
    "axes.spines.top": False,
    "axes.spines.right": False,
    # A scale that begins somewhere else, told in small print at its end, is misread.
    "axes.formatter.useoffset": False,
}
# More names than this find no place among the curves.
MOST_INSIDE = 4
_SHAFT = {"lw": 1.4, "shrinkA": 0, "shrinkB": 0}
# No dates and no version of a library, so that a file depends on its numbers alone.
_ABOUT: "dict[str, dict[str, Any]]" = {
    "svg": {"Date": None, "Creator": "dynamics"},
    "png": {"Software": "dynamics"},
    "pdf": {"CreationDate": None, "Creator": "dynamics", "Producer": "dynamics"},
}


def need() -> "Any":
    """The library, or how to get it."""
    try:
        import matplotlib
    except ImportError:
        raise UsageError(
            "pictures in files need a part that is not installed",
            code="not-installed",
            parameter="plot",
            hint="pip install 'dynamics-cli[plot]'; --plot - needs nothing",
        ) from None
    return matplotlib


def draw(picture: "Picture", form: str, system: str) -> bytes:
    """The bytes of a picture's file."""
    matplotlib = need()
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_SETTINGS)
        file = io.BytesIO()
        if form == "pdf" and 0 < picture.page < len(picture.panels):
            from matplotlib.backends.backend_pdf import PdfPages

            with PdfPages(file, metadata=_ABOUT[form]) as pages:
                for start in range(0, len(picture.panels), picture.page):
                    pages.savefig(_figure(picture, picture.panels[start : start + picture.page], system))
        else:
            figure = _figure(picture, picture.panels, system)
            figure.savefig(file, format=form, dpi=RESOLUTION, metadata=_ABOUT[form])
    return file.getvalue()


def _figure(picture: "Picture", panels: "tuple[Panel, ...]", system: str) -> "Any":
    """One page of panels."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    columns = min(picture.columns, len(panels))
    lines = -(-len(panels) // columns)
    tall = [max(_height(panel, columns) for panel in panels[i * columns : (i + 1) * columns]) for i in range(lines)]
    figure = Figure(figsize=(_width(columns), sum(tall) + 0.3), layout="constrained")
    FigureCanvasAgg(figure)
    grid = figure.add_gridspec(lines, columns, height_ratios=tall)
    for index, panel in enumerate(panels):
        _panel(figure.add_subplot(grid[index // columns, index % columns]), panel, system)
    if picture.title:
        figure.suptitle(picture.title, fontsize=10.5)
    return figure


def _width(columns: int) -> float:
    return WIDTHS[min(columns, len(WIDTHS)) - 1]


def _height(panel: "Panel", columns: int) -> float:
    legend = 0.2 * len(_legend(panel)) if columns > 1 else 0.0
    if panel.equal:
        share = 0.85 * _width(columns) / columns
        return legend + min(EQUAL_HEIGHT, max(LEAST_HEIGHT, 0.7 + share * _slenderness(panel)))
    bars = [len(item.names) for item in panel.items if isinstance(item, Bars)]
    return legend + (max(1.2, 0.6 + 0.28 * max(bars)) if bars else HEIGHT)


def _slenderness(panel: "Panel") -> float:
    """Height over width of what a panel of equal axes shows."""
    across: list[float] = []
    up: list[float] = []
    for item in panel.items:
        if isinstance(item, Curve):
            across += finite(item.x)
            up += finite(item.y)
        elif isinstance(item, Mark | Arrow):
            across.append(item.x)
            up.append(item.y)
    width = max(across, default=1.0) - min(across, default=0.0)
    return (max(up, default=1.0) - min(up, default=0.0)) / width if width > 0.0 else 1.0


def _panel(axes: "Any", panel: "Panel", system: str) -> None:
    from matplotlib.ticker import MultipleLocator

    x, y = Scale(panel.x, system), Scale(panel.y, system)
    axes.set_xlabel(x.label)
    axes.set_ylabel(y.label)
    columns = axes.get_gridspec().ncols
    if panel.title:
        axes.set_title(fill(panel.title, LONGEST_TITLE // columns))
    if x.logarithmic:
        axes.set_xscale("log")
    if y.logarithmic:
        axes.set_yscale("log")
    if panel.equal:
        axes.set_aspect("equal", adjustable="datalim")
    for axis, side in ((panel.x, axes.xaxis), (panel.y, axes.yaxis)):
        _ticks(side, axis, columns)
    pens = _Pens(panel)
    for item in panel.items:
        _DRAW[type(item)](axes, item, x, y, pens)
    if any(isinstance(item, Mark | Arrow) and item.label for item in panel.items):
        # Room for words beside the outermost points.
        axes.margins(x=0.2, y=0.12)
    if _legend(panel):
        axes.legend(**_legend_place(axes, panel))
    for axis, scale, limit, side in ((panel.x, x, axes.set_xlim, axes.xaxis), (panel.y, y, axes.set_ylim, axes.yaxis)):
        if axis.ends is not None:
            limit(*scale(axis.ends))
        if axis.step:
            side.set_major_locator(MultipleLocator(scale.width(axis.step)))


def _legend(panel: "Panel") -> "list[str]":
    return [item.label for item in panel.items if isinstance(item, Curve | Band) and item.label]


def _legend_place(axes: "Any", panel: "Panel") -> "dict[str, Any]":
    """Under a narrow panel; beside shapes, bars and many curves, which leave no corner free; else anywhere."""
    if axes.get_gridspec().ncols == 1:
        full = (
            panel.equal
            or len(_legend(panel)) > MOST_INSIDE
            or any(
                isinstance(item, Bars) or (isinstance(item, Curve) and item.style == "filled") for item in panel.items
            )
        )
        return {"loc": "upper left", "bbox_to_anchor": (1.0, 1.0)} if full else {"loc": "best"}
    from matplotlib.transforms import ScaledTranslation

    below = axes.transAxes + ScaledTranslation(0.0, -0.42, axes.figure.dpi_scale_trans)
    return {"loc": "upper center", "bbox_to_anchor": (0.5, 0.0), "bbox_transform": below}


def _ticks(side: "Any", axis: "Axis", columns: int) -> None:
    """Names at 1, 2, 3 …, whole numbers where things are counted, and no more ticks than there is room for."""
    from matplotlib.ticker import MaxNLocator

    if axis.names:
        side.set_ticks(range(1, len(axis.names) + 1), labels=list(axis.names))
    elif axis.kind is Count:
        side.set_major_locator(MaxNLocator(integer=True))
    elif columns > 1 and not axis.logarithmic:
        side.set_major_locator(MaxNLocator(nbins=MOST_TICKS // columns, steps=[1, 2, 2.5, 5, 10]))


class _Pens:
    """Colours, dashes and markers of a panel's curves."""

    def __init__(self, panel: "Panel") -> None:
        solid = [item for item in panel.items if isinstance(item, Curve) and item.style in ("solid", "steps")]
        # One curve alone is a plain line, and so are shapes, whose places tell them apart.
        self.dashed = not panel.equal and sum(bool(item.label) for item in solid) > 1
        self.last = -1

    def style(self, item: Curve) -> "dict[str, Any]":
        """What matplotlib takes for a curve."""
        if item.role < 0:
            self.last += 1
        nth = (item.role if item.role >= 0 else self.last) % len(COLOURS)
        style = {**_STYLES[item.style], "color": COLOURS[nth]}
        if item.style == "points":
            style["marker"] = MARKERS[nth]
        elif self.dashed and item.style in ("solid", "steps"):
            style["linestyle"] = DASHES[nth]
        return style


def _curve(axes: "Any", item: Curve, x: Scale, y: Scale, pens: "_Pens") -> None:
    across, up = x(item.x), y(item.y)
    style = pens.style(item)
    axes.plot(across, up, label=item.label or None, **style)
    if item.style == "filled":
        axes.fill(across, up, color=style["color"], alpha=0.15, linewidth=0.0)


def _mark(axes: "Any", item: Mark, x: Scale, y: Scale, pens: "_Pens") -> None:
    (across,), (up,) = x((item.x,)), y((item.y,))
    axes.plot([across], [up], marker="o", markersize=4.0, color="black")
    side = "right" if item.aside[0] < 0.0 else "left"
    axes.annotate(item.label, (across, up), xytext=item.aside, textcoords="offset points", fontsize=8.0, ha=side)


def _arrow(axes: "Any", item: Arrow, x: Scale, y: Scale, pens: "_Pens") -> None:
    colour = COLOURS[item.role % len(COLOURS)]
    (x0, x1), (y0, y1) = x((item.x, item.x + item.dx)), y((item.y, item.y + item.dy))
    # The arrow itself does not widen the axes; an unseen line along it does.
    axes.plot([x0, x1], [y0, y1], alpha=0.0)
    axes.annotate("", (x1, y1), (x0, y0), arrowprops={"arrowstyle": "-|>", "color": colour, **_SHAFT})
    # Away from the shaft, and the odd ones below, so that arrows side by side keep their words apart.
    place = {"ha": "left" if x1 >= x0 else "right", "va": "top" if item.role % 2 else "bottom"}
    shift = (4 if x1 >= x0 else -4, -3 if item.role % 2 else 3)
    axes.annotate(item.label, (x1, y1), xytext=shift, textcoords="offset points", fontsize=8.0, color=colour, **place)


def _band(axes: "Any", item: Band, x: Scale, y: Scale, pens: "_Pens") -> None:
    low, high = (x if item.vertical else y)((item.low, item.high))
    line, span = (axes.axvline, axes.axvspan) if item.vertical else (axes.axhline, axes.axhspan)
    if low == high:
        line(low, color="black", linestyle="-.", linewidth=1.0 if item.label else 0.6, label=item.label or None)
    else:
        span(low, high, color="#56B4E9", alpha=0.25, linewidth=0.0, label=item.label or None)


def _bars(axes: "Any", item: Bars, x: Scale, y: Scale, pens: "_Pens") -> None:
    low, high = x(item.low), x(item.high)
    places = list(range(len(item.names)))
    axes.use_sticky_edges = False
    axes.barh(places, [b - a for a, b in zip(low, high, strict=True)], left=low, height=0.6, color=COLOURS[0])
    axes.set_yticks(places, labels=list(item.names))
    axes.set_ylim(len(places) - 0.4, -0.6)
    axes.grid(visible=False, axis="y")


_DRAW: "dict[type, Callable[..., None]]" = {Curve: _curve, Mark: _mark, Arrow: _arrow, Band: _band, Bars: _bars}
