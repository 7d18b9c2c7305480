"""Pictures in files: SVG, PNG and PDF by matplotlib, which only this module imports; the same bytes every time."""

import io

from dynamics_cli.core.plot.axes import Scale, finite
from dynamics_cli.errors import UsageError
from dynamics_cli.pictures import Arrow, Band, Bars, Curve, Mark

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.pictures import Panel, Picture

# Okabe and Ito's colours, which colour-blind readers tell apart; yellow is left out, being lost on paper.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
WIDTH = 6.6
HEIGHT = 3.0
EQUAL_HEIGHT = 5.0
LEAST_HEIGHT = 1.8
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
    "axes.spines.top": False,
    "axes.spines.right": False,
}
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
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_SETTINGS)
        columns = min(picture.columns, len(picture.panels))
        lines = -(-len(picture.panels) // columns)
        tall = [max(_height(panel) for panel in picture.panels[i * columns : (i + 1) * columns]) for i in range(lines)]
        figure = Figure(figsize=(WIDTH * (1.0 + 0.75 * (columns - 1)), sum(tall) + 0.3), layout="constrained")
        FigureCanvasAgg(figure)
        grid = figure.add_gridspec(lines, columns, height_ratios=tall)
        for index, panel in enumerate(picture.panels):
            _panel(figure.add_subplot(grid[index // columns, index % columns]), panel, system)
        if picture.title:
            figure.suptitle(picture.title, fontsize=10.5)
        file = io.BytesIO()
        figure.savefig(file, format=form, dpi=RESOLUTION, metadata=_ABOUT[form])
    return file.getvalue()


def _height(panel: "Panel") -> float:
    if panel.equal:
        return min(EQUAL_HEIGHT, max(LEAST_HEIGHT, 0.7 + 0.85 * WIDTH * _slenderness(panel)))
    bars = [len(item.names) for item in panel.items if isinstance(item, Bars)]
    return max(1.2, 0.6 + 0.28 * max(bars)) if bars else HEIGHT


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
    if panel.title:
        axes.set_title(panel.title)
    if x.logarithmic:
        axes.set_xscale("log")
    if y.logarithmic:
        axes.set_yscale("log")
    if panel.equal:
        axes.set_aspect("equal", adjustable="datalim")
    colours = iter(COLOURS * (1 + len(panel.items) // len(COLOURS)))
    for item in panel.items:
        _DRAW[type(item)](axes, item, x, y, colours)
    if any(isinstance(item, Mark | Arrow) and item.label for item in panel.items):
        # Room for words beside the outermost points.
        axes.margins(x=0.2, y=0.12)
    for axis, scale, limit, ticks in ((panel.x, x, axes.set_xlim, axes.xaxis), (panel.y, y, axes.set_ylim, axes.yaxis)):
        if axis.ends is not None:
            limit(*scale(axis.ends))
        if axis.step:
            ticks.set_major_locator(MultipleLocator(scale.width(axis.step)))
    if any(getattr(item, "label", "") and isinstance(item, Curve | Band) for item in panel.items):
        axes.legend(loc="best")


def _curve(axes: "Any", item: Curve, x: Scale, y: Scale, colours: "Any") -> None:
    colour = COLOURS[item.role % len(COLOURS)] if item.role >= 0 else next(colours)
    across, up = x(item.x), y(item.y)
    axes.plot(across, up, color=colour, label=item.label or None, **_STYLES[item.style])
    if item.style == "filled":
        axes.fill(across, up, color=colour, alpha=0.15, linewidth=0.0)


def _mark(axes: "Any", item: Mark, x: Scale, y: Scale, colours: "Any") -> None:
    (across,), (up,) = x((item.x,)), y((item.y,))
    axes.plot([across], [up], marker="o", markersize=4.0, color="black")
    axes.annotate(item.label, (across, up), xytext=(5, 5), textcoords="offset points", fontsize=8.0)


def _arrow(axes: "Any", item: Arrow, x: Scale, y: Scale, colours: "Any") -> None:
    colour = COLOURS[item.role % len(COLOURS)]
    (x0, x1), (y0, y1) = x((item.x, item.x + item.dx)), y((item.y, item.y + item.dy))
    # The arrow itself does not widen the axes; an unseen line along it does.
    axes.plot([x0, x1], [y0, y1], alpha=0.0)
    axes.annotate("", (x1, y1), (x0, y0), arrowprops={"arrowstyle": "-|>", "color": colour, **_SHAFT})
    axes.annotate(item.label, (x1, y1), xytext=(4, 4), textcoords="offset points", fontsize=8.0, color=colour)


def _band(axes: "Any", item: Band, x: Scale, y: Scale, colours: "Any") -> None:
    low, high = (x if item.vertical else y)((item.low, item.high))
    line, span = (axes.axvline, axes.axvspan) if item.vertical else (axes.axhline, axes.axhspan)
    if low == high:
        line(low, color="#D55E00", linestyle="--", linewidth=1.2, label=item.label or None)
    else:
        span(low, high, color="#56B4E9", alpha=0.25, linewidth=0.0, label=item.label or None)


def _bars(axes: "Any", item: Bars, x: Scale, y: Scale, colours: "Any") -> None:
    low, high = x(item.low), x(item.high)
    places = list(range(len(item.names)))
    axes.barh(places, [b - a for a, b in zip(low, high, strict=True)], left=low, height=0.6, color=COLOURS[0])
    axes.set_yticks(places, labels=list(item.names))
    axes.invert_yaxis()
    axes.grid(visible=False, axis="y")
    axes.use_sticky_edges = False


_DRAW: "dict[type, Callable[..., None]]" = {Curve: _curve, Mark: _mark, Arrow: _arrow, Band: _band, Bars: _bars}
