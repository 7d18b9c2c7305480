"""Three views of one body on one scale: the top view over the front view, the side view beside it, notes in the corner.

Labels are placed where they overlap neither other labels nor arrows; those that do not fit are left out.
"""

from dynamics_cli.core.output.plot.axes import Scale, sentence
from dynamics_cli.core.units.display import Shown
from dynamics_cli.pictures import Arrow, Curve, Mark

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

    from dynamics_cli.pictures import Panel, Picture

    # left, bottom, right, top in inches
    Box = tuple[float, float, float, float]

# In inches: space for two views side by side and one above the other, and the margins of a view.
LARGEST = 6.4, 6.8
LEFT, RIGHT, BELOW, ABOVE = 0.7, 0.15, 0.5, 0.35
# A letter of 8 points, and how far words stand from their point.
LETTER, LINE, ASIDE = 0.068, 0.15, 0.07
STEP = 0.08
# A background behind labels, so that a line under them does not strike them out.
BEHIND = {"facecolor": "white", "edgecolor": "none", "pad": 0.4, "alpha": 0.75}
ARROW = {"arrowstyle": "-|>", "lw": 1.4, "shrinkA": 0, "shrinkB": 0}


def three_views(
    picture: "Picture",
    system: str,
    blank: "Callable[[float, float], Any]",
    curve: "Callable[..., None]",
    pens: "Callable[[Panel], Any]",
    colours: "Any",
) -> "Any":
    """The figure of a picture whose panels are top, front and side view, each with the ends of its axes."""
    top, front, side = picture.panels
    spans = [axis.ends[1] - axis.ends[0] for axis in (top.x, top.y, front.y)]  # type: ignore[index]
    inch = min(LARGEST[0] / (spans[0] + spans[1]), LARGEST[1] / (spans[1] + spans[2]))
    wide, deep, tall = (span * inch for span in spans)
    width = LEFT + wide + RIGHT + LEFT + deep + RIGHT
    height = BELOW + tall + ABOVE + BELOW + deep + ABOVE + (0.25 if picture.title else 0.0)
    figure = blank(width, height)
    right, upper = LEFT + wide + RIGHT + LEFT, BELOW + tall + ABOVE + BELOW
    places = ((top, LEFT, upper, wide, deep), (front, LEFT, BELOW, wide, tall), (side, right, BELOW, deep, tall))
    views = []
    for panel, x, y, across, up in places:
        axes = figure.add_axes((x / width, y / height, across / width, up / height))
        _view(axes, panel, (across, up), system, curve, pens(panel), colours)
        views.append(axes)
    corner = figure.add_axes(((right - 0.4) / width, upper / height, (deep + 0.4) / width, deep / height))
    _notes(corner, views, picture, system)
    if picture.title:
        place = {"x": LEFT / width, "y": 1.0 - 0.06 / height, "ha": "left", "va": "top"}
        figure.suptitle(sentence(picture.title), fontsize=11.0, fontweight="bold", **place)
    return figure


def _view(
    axes: "Any",
    panel: "Panel",
    size: "tuple[float, float]",
    system: str,
    curve: "Callable[..., None]",
    pens: "Any",
    colours: "Any",
) -> None:
    x, y = Scale(panel.x, system), Scale(panel.y, system)
    axes.set_xlabel(x.label)
    axes.set_ylabel(y.label)
    axes.set_title(sentence(panel.title))
    for item in panel.items:
        if isinstance(item, Curve):
            curve(axes, item, x, y, pens)
        elif isinstance(item, Arrow):
            (x0, x1), (y0, y1) = x((item.x, item.x + item.dx)), y((item.y, item.y + item.dy))
            arrow = {**ARROW, "color": colours[item.role % len(colours)]}
            axes.annotate("", (x1, y1), (x0, y0), arrowprops=arrow)
        elif isinstance(item, Mark):
            axes.plot(x((item.x,)), y((item.y,)), marker="o", markersize=4.0, color="black")
    axes.set_xlim(*x(panel.x.ends))  # type: ignore[arg-type]
    axes.set_ylim(*y(panel.y.ends))  # type: ignore[arg-type]
    for side, length in zip("xy", size, strict=True):
        axes.locator_params(axis=side, nbins=max(2, int(length / 0.55)), steps=[1, 2, 2.5, 5, 10])
    for item, (across, up) in _words(panel, size):
        colour = colours[item.role % len(colours)] if isinstance(item, Arrow) else "black"
        place = {"xycoords": "axes fraction", "ha": "center", "va": "center", "bbox": BEHIND}
        axes.annotate(item.label, (across / size[0], up / size[1]), fontsize=8.0, color=colour, **place)


def _words(panel: "Panel", size: "tuple[float, float]") -> "Iterator[tuple[Mark | Arrow, tuple[float, float]]]":
    """Marks and arrows with the places of their words, in inches from the corner of the view."""
    (left, right), (low, _) = panel.x.ends, panel.y.ends  # type: ignore[misc]
    inch = size[0] / (right - left)
    occupied: list[Box] = []
    ends: list[tuple[Mark | Arrow, float, float, float, float]] = []
    for item in panel.items:
        if not isinstance(item, Mark | Arrow):
            continue
        across, up = (item.x - left) * inch, (item.y - low) * inch
        dx, dy = (item.dx * inch, item.dy * inch) if isinstance(item, Arrow) else (0.0, 0.0)
        length = (dx * dx + dy * dy) ** 0.5
        for nth in range(int(length / STEP) + 1):
            fraction = nth * STEP / length if length else 0.0
            occupied.append(_box(across + fraction * dx, up + fraction * dy, 0.03, 0.03))
        ends.append((item, across + dx, up + dy, dx / (length or 1.0), dy / (length or 1.0)))
    for item, across, up, dx, dy in ends:
        half = 0.5 * LETTER * len(item.label), 0.5 * LINE
        for sx, sy in _sides(dx, dy):
            place = across + sx * (half[0] + ASIDE), up + sy * (half[1] + ASIDE)
            box = _box(*place, *half)
            inside = box[0] >= 0.0 and box[1] >= 0.0 and box[2] <= size[0] and box[3] <= size[1]
            if item.label and inside and not any(_overlap(box, other) for other in occupied):
                occupied.append(box)
                yield item, place
                break


def _sides(dx: float, dy: float) -> "tuple[tuple[float, float], ...]":
    """Possible places of a label about a point: ahead of an arrow, then beside its end; about a mark, on any side."""
    around = ((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0), (0.0, 1.2), (0.0, -1.2), (1.0, 0.0), (-1.0, 0.0))
    return ((dx, dy), (dx - dy, dy + dx), (dx + dy, dy - dx), (-dy, dx), (dy, -dx)) if dx or dy else around


def _box(x: float, y: float, half_width: float, half_height: float) -> "Box":
    return x - half_width, y - half_height, x + half_width, y + half_height


def _overlap(first: "Box", second: "Box") -> bool:
    return first[0] < second[2] and second[0] < first[2] and first[1] < second[3] and second[1] < first[3]


def _notes(corner: "Any", views: "list[Any]", picture: "Picture", system: str) -> None:
    """The legend of lines, and the picture's numbers."""
    corner.set_axis_off()
    named = {label: handle for axes in views for handle, label in zip(*axes.get_legend_handles_labels(), strict=True)}
    legend = corner.legend(
        named.values(), named.keys(), loc="upper left", bbox_to_anchor=(0.0, 1.0), borderpad=0.0, borderaxespad=0.0
    )
    corner.add_artist(legend)
    lines = []
    for name, value, kind in picture.notes:
        if kind is None:
            lines.append(name)
            continue
        shown = Shown(kind, kind.shown_in(system))
        lines.append(f"{name} = {shown.value(value):.5g} {shown.text}".rstrip())
    corner.text(0.0, 0.0, "\n".join(lines), fontsize=8.5, va="bottom", linespacing=1.5)
