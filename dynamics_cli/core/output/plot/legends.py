"""Legends where they hide no curve: in a free corner, beside the axes, under them, or one over all panels."""

from dynamics_cli.core.output.plot.library import part
from dynamics_cli.pictures import Band, Bars, Curve

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.pictures import Panel

# Width in inches by the number of columns: prints on a page with almost no reduction of the labels.
WIDTHS = (6.6, 7.6, 8.4)
# A picture for a column of a page.
NARROW = 5.0
# Letters of a title over the whole width.
LONGEST_TITLE = 84
# More names than this find no place among the curves.
MOST_INSIDE, FEW = 4, 2
# Letters that the line of a curve and the room around it take in a legend.
LETTERS_OF_A_LINE = 8


def named_curves(panel: "Panel") -> "list[str]":
    """The names of curves and bands that a legend shows."""
    return [item.label for item in panel.items if isinstance(item, Curve | Band) and item.label]


def legend_place(axes: "Any", panel: "Panel", columns: int) -> "dict[str, Any]":
    """Under a narrow panel and under shapes; beside bars and many curves, which leave no corner free; else anywhere."""
    if columns == 1:
        full = (
            panel.equal
            or len(named_curves(panel)) > MOST_INSIDE
            or any(
                isinstance(item, Bars) or (isinstance(item, Curve) and item.style == "filled") for item in panel.items
            )
        )
        ncols = in_one_row(panel, axes.figure.get_figwidth())
        if not full or not panel.equal or not ncols:
            if len(named_curves(panel)) <= FEW and _free_beneath(panel):
                return {"loc": "lower right"}
            return {"loc": "upper left", "bbox_to_anchor": (1.0, 1.0)} if full else {"loc": "best"}
    else:
        ncols = 1
    return _beneath(axes, ncols)


def _beneath(axes: "Any", ncols: int) -> "dict[str, Any]":
    """The place of a legend under the axes and their title."""
    below = axes.transAxes + part("transforms").ScaledTranslation(
        0.0, -0.42 if axes.axison else -0.05, axes.figure.dpi_scale_trans
    )
    return {"loc": "upper center", "bbox_to_anchor": (0.5, 0.0), "bbox_transform": below, "ncols": ncols}


def one_legend(figure: "Any") -> None:
    """One legend over narrow panels of the same curves, which leave no corner free."""
    named: dict[str, Any] = {}
    for axes in figure.axes:
        for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
            named.setdefault(label, handle)
        if axes.get_legend():
            axes.get_legend().remove()
    if named:
        first = figure.axes[0]
        above = part("transforms").ScaledTranslation(0.0, 0.22 if first.get_title() else 0.0, figure.dpi_scale_trans)
        place = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "bbox_transform": first.transAxes + above}
        first.legend(named.values(), named.keys(), ncols=2, borderaxespad=0.2, **place)


def _free_beneath(panel: "Panel") -> bool:
    """Whether the lowest bars leave the right half free, as those of a tornado do."""
    bars = next((item for item in panel.items if isinstance(item, Bars)), None)
    if bars is None or len(bars.names) <= FEW + 1:
        return False
    low, high = min(bars.low), max(bars.high)
    return all(end < low + 0.65 * (high - low) for end in bars.high[-FEW:])


def in_one_row(panel: "Panel", wide: float) -> int:
    """How many names of shapes stand side by side under a picture; none where they are long for a whole page."""
    names = named_curves(panel)
    letters = [len(name) + LETTERS_OF_A_LINE for name in names]
    if sum(letters) <= LONGEST_TITLE * wide / WIDTHS[0]:
        return len(names)
    return int(LONGEST_TITLE * wide / WIDTHS[0] / max(letters)) if wide < NARROW else 0


def freed_curves(figure: "Any") -> bool:
    """Move legends that find no place free of curves beneath their axes; whether there were any."""
    moved = False
    for axes in figure.axes:
        legend = axes.get_legend()
        if legend is None or legend.get_window_extent().width >= axes.bbox.width:
            continue
        box = legend.get_window_extent()
        paths = [line.get_path().transformed(line.get_transform()) for line in axes.lines if line.get_alpha() != 0.0]
        if any(path.intersects_bbox(box, filled=False) for path in paths):
            handles, names = axes.get_legend_handles_labels()
            axes.legend(handles, names, **_beneath(axes, len(names)))
            moved = True
    return moved
