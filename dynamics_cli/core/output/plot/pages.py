"""Pictures in files: SVG, PNG and PDF by matplotlib; the same bytes every time."""

import io
import itertools
from textwrap import fill

from dynamics_cli.core.output.plot.axes import Scale, finite, sentence, words
from dynamics_cli.core.output.plot.items import COLOURS, DRAW, Pens, written
from dynamics_cli.core.output.plot.legends import (
    LONGEST_TITLE,
    NARROW,
    WIDTHS,
    freed_curves,
    in_one_row,
    legend_place,
    named_curves,
    one_legend,
)
from dynamics_cli.core.output.plot.library import ABOUT, blank, need, part, settle
from dynamics_cli.pictures import Arrow, Bars, Curve, Dimension, Label, Mark, Ranges, Rows, Ruler, Shares
from dynamics_cli.quantities import Count

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.pictures import Axis, Panel, Picture

HEIGHT = 3.0
# Panels above one another over one axis: inches, and at most this share of a narrow picture's width.
SHARED_SHAPE = 0.38
SHARED_HEIGHT, ROOM_FOR_TICKS = 1.9, 0.4
EQUAL_HEIGHT = 5.0
LEAST_HEIGHT = 1.8
# Maximum height of shapes in a narrow column, relative to its width.
CAPPED, CAPPED_BELOW = 0.8, 4.0
LETTERS_PER_INCH = 11
# Ticks of an axis over the whole width.
MOST_TICKS = 12
# A logarithmic axis within these numbers is written without powers of ten; 2 and 5 are named up to so many decades.
PLAIN, NAMED_DECADES = (1e-3, 1e5), 1e3
# Inches of a bar of shares with the words over it.
SHARE_HEIGHT = 0.4
# The label of a full-width panel, regardless of the labels beside the axes of others.
WHOLE = "whole"
RESOLUTION = 160
KEPT = 0.25


def draw(picture: "Picture", form: str, system: str) -> bytes:
    """The bytes of a picture's file."""
    matplotlib = need()
    with matplotlib.rc_context():
        settle(matplotlib)
        file = io.BytesIO()
        if form == "pdf" and 0 < picture.page < len(picture.panels):
            with part("backends.backend_pdf").PdfPages(file, metadata=ABOUT[form]) as pages:
                for start in range(0, len(picture.panels), picture.page):
                    pages.savefig(_figure(picture, picture.panels[start : start + picture.page], system))
        else:
            figure = _figure(picture, picture.panels, system)
            # the words of a scene stand where its arrows end, which may be beyond the page
            frameless = any(panel.bare for panel in picture.panels)
            more = {"bbox_inches": "tight", "pad_inches": 0.05} if frameless else {}
            figure.savefig(file, format=form, dpi=RESOLUTION, metadata=ABOUT[form], **more)
    return file.getvalue()


def _figure(picture: "Picture", panels: "tuple[Panel, ...]", system: str) -> "Any":
    """One page of panels."""
    if picture.views:
        from dynamics_cli.core.output.plot.views import three_views

        return three_views(picture, system, blank, DRAW[Curve], Pens, COLOURS)
    columns = min(picture.columns, len(panels))
    lines = _lines(panels, columns)
    wide = picture.width or WIDTHS[min(columns, len(WIDTHS)) - 1]
    tall = [max(_height(panel, columns if len(line) > 1 else 1, wide) for panel in line) for line in lines]
    # labels of other panels shrink all panels equally; a scene must keep its size
    frameless = [len(lines) > 1 and len(line) == 1 and line[0].bare for line in lines]
    tall = [height * (1.0 + KEPT * alone) for height, alone in zip(tall, frameless, strict=True)]
    head = 0.5 if picture.subtitle else 0.3 if picture.title else 0.0
    # panels one below another over the same stretch of one axis name it once
    shared = [columns == 1 and _shares_axis(*pair) for pair in itertools.pairwise(panels)] + [False]
    for index in [index for index, is_shared in enumerate(shared) if is_shared]:
        height = min(SHARED_HEIGHT, SHARED_SHAPE * wide)
        tall[index : index + 2] = [height, height + ROOM_FOR_TICKS]
    figure = blank(wide, sum(tall) + head, layout="constrained")
    grid = figure.add_gridspec(len(lines), columns, height_ratios=tall)
    for row, line in enumerate(lines):
        for column, panel in enumerate(line):
            # a panel that would be alone in the last line takes all of it
            full_width = panel.wide or (len(line) == 1 and row == len(lines) - 1)
            place = grid[row, :] if full_width else grid[row, column]
            axes = figure.add_subplot(place)
            _panel(axes, panel, system, 1 if full_width else columns)
            if columns == 1 and shared[row]:
                axes.set_xlabel("")
                axes.tick_params(which="both", labelbottom=False)
    if any(shared) and wide < NARROW:
        one_legend(figure)
    if picture.subtitle:
        _head(figure, picture, system)
        return figure
    if picture.title:
        lines_ = sentence(written(picture.title, system)).split("\n")
        text = "\n".join(fill(line, int(LETTERS_PER_INCH * wide)) for line in lines_)
        title = figure.suptitle(text, fontsize=11.0, fontweight="bold", ha="left")
    if any(shared):
        figure.align_ylabels()
    _settle(figure)
    if picture.title:
        title.set_x(figure.axes[0].get_position().x0)
    return figure


def _head(figure: "Any", picture: "Picture", system: str) -> None:
    """Title and subtitle above the left edge of the first panel; the layout is settled with them."""
    layout = figure.get_layout_engine()
    layout.set(h_pad=0.1, w_pad=0.1)
    title = figure.suptitle(sentence(written(picture.title, system)), ha="left", fontsize=13.0, fontweight="bold")
    figure.axes[0].set_title(written(picture.subtitle, system), loc="left", fontsize=8.5, color="#555555")
    _settle(figure)
    title.set_x(figure.axes[0].get_position().x0)


def _settle(figure: "Any") -> None:
    """Keep the layout, rounded: its last bits depend on the order in which a solver finds it."""
    engine = figure.get_layout_engine()
    engine.execute(figure)
    # the first layout may change the ticks, and with them the room for their labels
    engine.execute(figure)
    if freed_curves(figure):
        engine.execute(figure)
    figure.set_layout_engine("none")
    for axes in figure.axes:
        if axes.get_label() == WHOLE:
            _, low, _, high = axes.get_position().bounds
            axes.set_position([0.02, round(low, 6), 0.96, round(high, 6)])
            continue
        # a scene has no axes to stand in line with those of other panels
        if not axes.axison and axes.get_aspect() != "auto" and len(figure.axes) > 1 and whole_width(axes):
            place = axes.get_position(original=True).bounds
            axes.set_position([0.01, round(place[1], 6), 0.98, round(place[3], 6)])
            axes.apply_aspect()
            continue
        axes.set_position([round(part, 6) for part in axes.get_position().bounds])


def whole_width(axes: "Any") -> bool:
    """Whether a panel takes the whole line of its grid."""
    place = axes.get_subplotspec()
    return bool(place.colspan.start == 0 and place.colspan.stop == place.get_gridspec().ncols)


def _shares_axis(panel: "Panel", below: "Panel") -> bool:
    return panel.x.ends is not None and panel.x == below.x


def _lines(panels: "tuple[Panel, ...]", columns: int) -> "list[list[Panel]]":
    """The panels line by line; a wide one takes a whole line."""
    lines: list[list[Panel]] = []
    for panel in panels:
        if not lines or panel.wide or lines[-1][0].wide or len(lines[-1]) == columns:
            lines.append([])
        lines[-1].append(panel)
    return lines


def _height(panel: "Panel", columns: int, wide: float) -> float:
    """Height of a panel that shares a line of this width with `columns`."""
    legend = 0.2 * len(named_curves(panel)) if columns > 1 else 0.0
    if panel.equal:
        row = in_one_row(panel, wide) if columns == 1 and wide < NARROW else 0
        legend += 0.2 * (-(-len(named_curves(panel)) // row)) if row else 0.0
        highest = CAPPED * wide if wide < CAPPED_BELOW else EQUAL_HEIGHT
        factor = (0.97 if panel.bare else 0.85) * wide / columns
        return legend + min(highest, max(LEAST_HEIGHT, (0.1 if panel.bare else 0.7) + factor * _slenderness(panel)))
    tables = [len(item.rows) for item in panel.items if isinstance(item, Rows)]
    if tables:
        return 0.3 + 0.26 * max(tables)
    bar_items = [len(item.heads) for item in panel.items if isinstance(item, Shares)]
    if bar_items:
        return 0.35 + SHARE_HEIGHT * max(bar_items)
    bars = [len(item.names) * (1 + isinstance(item, Ranges)) for item in panel.items if isinstance(item, Bars | Ranges)]
    return legend + (
        max(1.2, 0.6 + 0.28 * max(bars)) if bars else min(HEIGHT, (0.42 if wide < CAPPED_BELOW else 0.55) * wide)
    )


def _slenderness(panel: "Panel") -> float:
    """Height over width of the content of a panel with equal axes."""
    if panel.x.ends is not None and panel.y.ends is not None:
        return (panel.y.ends[1] - panel.y.ends[0]) / (panel.x.ends[1] - panel.x.ends[0])
    across: list[float] = []
    up: list[float] = []
    for item in panel.items:
        if isinstance(item, Curve):
            across += finite(item.x)
            up += finite(item.y)
        elif isinstance(item, Mark | Arrow | Label | Ruler):
            across.append(item.x)
            up.append(item.y)
        elif isinstance(item, Dimension):
            across += item.x
            up += item.y
    width = max(across, default=1.0) - min(across, default=0.0)
    return (max(up, default=1.0) - min(up, default=0.0)) / width if width > 0.0 else 1.0


def _panel(axes: "Any", panel: "Panel", system: str, columns: int) -> None:
    x, y = Scale(panel.x, system), Scale(panel.y, system)
    if panel.bare:
        axes.set_axis_off()
    axes.set_xlabel(written(x.label, system))
    axes.set_ylabel(written(y.label, system))
    if panel.title:
        room = min(1.0, axes.figure.get_figwidth() / WIDTHS[min(columns, len(WIDTHS)) - 1])
        axes.set_title(fill(sentence(words(panel.title, system)), int(room * LONGEST_TITLE / columns)))
    if x.logarithmic:
        axes.set_xscale("log")
    if y.logarithmic:
        axes.set_yscale("log")
    if panel.equal:
        fixed = panel.x.ends is not None and panel.y.ends is not None
        axes.set_aspect("equal", adjustable="box" if fixed else "datalim")
    for axis, side in ((panel.x, axes.xaxis), (panel.y, axes.yaxis)):
        _ticks(side, axis, columns)
    pens = Pens(panel)
    for item in panel.items:
        DRAW[type(item)](axes, item, x, y, pens)
    if any(isinstance(item, Shares) for item in panel.items):
        axes.set_axis_off()
        axes.set_label(WHOLE)
    elif panel.bare or any(isinstance(item, Rows) for item in panel.items):
        axes.set_axis_off()
        axes.margins(0.02)
    elif any(isinstance(item, Mark | Arrow) and item.label for item in panel.items):
        # Margin for labels beside the outermost points.
        beside = any(isinstance(item, Mark) and not item.dot for item in panel.items)
        axes.margins(x=0.3 if beside else 0.2, y=0.12 if panel.x.ends is None else 0.2)
    if named_curves(panel):
        axes.legend(**legend_place(axes, panel, columns))
    for axis, scale, limit, side in ((panel.x, x, axes.set_xlim, axes.xaxis), (panel.y, y, axes.set_ylim, axes.yaxis)):
        if axis.ends is not None:
            limit(*scale(axis.ends))
        if axis.step:
            side.set_major_locator(part("ticker").MultipleLocator(scale.width(axis.step)))


def _ticks(side: "Any", axis: "Axis", columns: int) -> None:
    """Names at 1, 2, 3 …, whole numbers where things are counted, and no more ticks than there is room for."""
    if axis.names:
        side.set_ticks(range(1, len(axis.names) + 1), labels=list(axis.names))
    elif axis.kind is Count:
        side.set_major_locator(part("ticker").MaxNLocator(integer=True))
    elif axis.logarithmic:
        _plain_numbers(side)
    elif columns > 1:
        side.set_major_locator(part("ticker").MaxNLocator(nbins=MOST_TICKS // columns, steps=[1, 2, 2.5, 5, 10]))


def _plain_numbers(side: "Any") -> None:
    """A logarithmic axis of a few decades is numbered 1, 2, 5, 10, 20 … as on paper; a longer one by powers of ten."""
    ticker = part("ticker")
    powers = ticker.LogFormatterMathtext()
    powers.set_axis(side)

    def decade(value: float, _: object) -> str:
        low, high = sorted(side.get_view_interval())
        return f"{value:g}" if PLAIN[0] <= low and high <= PLAIN[1] else powers(value)

    def between(value: float, _: object) -> str:
        low, high = sorted(side.get_view_interval())
        return f"{value:g}" if PLAIN[0] <= low and high <= min(PLAIN[1], NAMED_DECADES * low) else ""

    side.set_minor_locator(ticker.LogLocator(subs=(2.0, 5.0), numticks=MOST_TICKS))
    side.set_major_formatter(ticker.FuncFormatter(decade))
    side.set_minor_formatter(ticker.FuncFormatter(between))
    # minor ticks are shorter, but their numbers stand on one line with the others
    side.set_tick_params(which="minor", pad=5.0)
