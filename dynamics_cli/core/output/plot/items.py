"""Items of a panel: curves, marks, arrows, bands, bars, words, dimensions and tables, drawn by matplotlib."""

import re

from dynamics_cli.core.documents import number
from dynamics_cli.core.output.plot.axes import Scale, rounded, words
from dynamics_cli.pictures import Arrow, Band, Bars, Curve, Dimension, Label, Mark, Ranges, Rows, Ruler, Shares

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.pictures import Panel

# Okabe and Ito's colours, safe for colour-blind readers, without yellow, which is faint on paper.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
# Each colour has its dashes and marker, so that curves remain distinct in a grey print.
DASHES: "tuple[Any, ...]" = (
    "-", (0, (7, 2)), (0, (7, 2, 1.5, 2)), (0, (3, 1.5)), (0, (7, 2, 1.5, 2, 1.5, 2)), (0, (1.2, 1.2)), (0, (12, 3)),
)  # fmt: skip
MARKERS = "os^Dv<>"
GROUND, TRACK = "#eceef0", "#8f8f8f"
_STYLES: "dict[str, dict[str, Any]]" = {
    "solid": {"linestyle": "-", "linewidth": 1.5},
    "dashed": {"linestyle": "--", "linewidth": 1.3},
    "dotted": {"linestyle": ":", "linewidth": 1.5},
    "thin": {"linestyle": "-", "linewidth": 0.7},
    "points": {"linestyle": "none", "marker": "o", "markersize": 3.5},
    "steps": {"linestyle": "-", "linewidth": 1.5, "drawstyle": "steps-post"},
    "filled": {"linestyle": "-", "linewidth": 1.0},
    "outline": {"linestyle": "-", "linewidth": 1.0},
    "fill": {"linestyle": "none"},
    "dots": {"linestyle": ":", "linewidth": 0.8},
    "thick": {"linestyle": "-", "linewidth": 2.6, "solid_capstyle": "butt"},
    "track": {"linestyle": "-", "linewidth": 2.2, "solid_capstyle": "butt", "zorder": 1.0},
    "centre": {"linestyle": (0, (9, 2, 1.5, 2)), "linewidth": 0.7},
}
# Words stand out from the lines that they cross.
_BACKGROUND = {"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 0.4}
_PLAIN = {"facecolor": "white", "edgecolor": "none", "pad": 0.5}
# Bars of shares: maximum number of coloured names, inches per letter, and the colour of the others.
MOST_COLOURED, LETTER, OTHERS = 6, 0.068, "#d9d9d9"
# Letters of a name that stands over its own bar.
LONGEST_NAME = 48
_SHAFT = {"lw": 1.4, "shrinkA": 0, "shrinkB": 0}
_DIMENSION = {"lw": 0.8, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 8}


class Pens:
    """Colours, dashes and markers of a panel's curves."""

    def __init__(self, panel: "Panel") -> None:
        solid = [item for item in panel.items if isinstance(item, Curve) and item.style in ("solid", "steps")]
        # A single curve is a plain line; so are shapes, which their places distinguish.
        self.dashed = not panel.equal and sum(bool(item.label) for item in solid) > 1
        self.last = -1

    def style(self, item: Curve) -> "dict[str, Any]":
        """Arguments of matplotlib for a curve."""
        if item.role < 0:
            self.last += 1
        nth = (item.role if item.role >= 0 else self.last) % len(COLOURS)
        style = {**_STYLES[item.style], "color": COLOURS[nth]}
        # what stands behind the others
        if item.style == "track" or (item.style == "thin" and nth == len(COLOURS) - 1):
            style["color"] = TRACK
        elif item.style == "points":
            style["marker"] = MARKERS[nth]
        elif self.dashed and item.style in ("solid", "steps"):
            style["linestyle"] = DASHES[nth]
        return style


def _curve(axes: "Any", item: Curve, x: Scale, y: Scale, pens: Pens) -> None:
    across, up = x(item.x), y(item.y)
    if item.style == "ground":
        axes.fill(across, up, color=GROUND, linewidth=0.0, zorder=0.0)
        return
    style = pens.style(item)
    axes.plot(across, up, label=words(item.label, x.system) or None, **style)
    if item.style in ("filled", "fill"):
        axes.fill(across, up, color=style["color"], alpha=0.12, linewidth=0.0)


def _mark(axes: "Any", item: Mark, x: Scale, y: Scale, pens: Pens) -> None:
    (across,), (up,) = x((item.x,)), y((item.y,))
    colour = COLOURS[item.role % len(COLOURS)] if item.role >= 0 else "black"
    axes.plot([across], [up], marker="o", markersize=4.0, color=colour, alpha=float(item.dot))
    side, height = ("right" if item.aside[0] < 0.0 else "left"), "baseline"
    if not item.dot:
        side = side if item.aside[0] else "center"
        height = ("top" if item.aside[1] < 0.0 else "bottom") if item.aside[1] else "center"
    if not item.label:
        return
    place = {"xytext": item.aside, "textcoords": "offset points", "ha": side, "va": height, "bbox": _BACKGROUND}
    axes.annotate(written(item.label, x.system), (across, up), fontsize=8.0, color=colour, **place)


def _arrow(axes: "Any", item: Arrow, x: Scale, y: Scale, pens: Pens) -> None:
    colour = COLOURS[item.role % len(COLOURS)]
    (x0, x1), (y0, y1) = x((item.x, item.x + item.dx)), y((item.y, item.y + item.dy))
    # The arrow itself does not widen the axes; an unseen line along it does.
    axes.plot([x0, x1], [y0, y1], alpha=0.0)
    shaft = {**_SHAFT, "linestyle": "--"} if item.dashed else _SHAFT
    axes.annotate("", (x1, y1), (x0, y0), arrowprops={"arrowstyle": "-|>", "color": colour, **shaft})
    if not item.label:
        return
    # Away from the shaft, and the odd ones below, so that arrows side by side keep their words apart.
    place: dict[str, Any] = {"ha": "left" if x1 >= x0 else "right", "va": "top" if item.role % 2 else "bottom"}
    place["bbox"] = _BACKGROUND
    shift = (4 if x1 >= x0 else -4, -3 if item.role % 2 else 3)
    text = written(item.label, x.system)
    axes.annotate(text, (x1, y1), xytext=shift, textcoords="offset points", fontsize=8.0, color=colour, **place)


def _band(axes: "Any", item: Band, x: Scale, y: Scale, pens: Pens) -> None:
    low, high = (x if item.vertical else y)((item.low, item.high))
    line, span = (axes.axvline, axes.axvspan) if item.vertical else (axes.axhline, axes.axhspan)
    label = words(item.label, x.system) or None
    if low == high:
        line(low, color="black", linestyle="-.", linewidth=1.0 if label else 0.6, label=label)
    else:
        span(low, high, color="#56B4E9", alpha=0.25, linewidth=0.0, label=label)


def _bars(axes: "Any", item: Bars, x: Scale, y: Scale, pens: Pens) -> None:
    low, high = x(item.low), x(item.high)
    places = list(range(len(item.names)))
    axes.use_sticky_edges = False
    axes.barh(places, [b - a for a, b in zip(low, high, strict=True)], left=low, height=0.6, color=COLOURS[0])
    axes.set_yticks(places, labels=list(item.names))
    axes.set_ylim(len(places) - 0.4, -0.6)
    axes.grid(visible=False, axis="y")


def _ranges(axes: "Any", item: Ranges, x: Scale, y: Scale, pens: Pens) -> None:
    """Each interval as a bar with its value as a point, the name over it."""
    places = list(range(len(item.names)))
    low, high = x(item.low), x(item.high)
    axes.barh(places, [b - a for a, b in zip(low, high, strict=True)], left=low, height=0.16, color="#9ecae1")
    axes.plot(x(item.at), places, linestyle="none", marker="o", markersize=5.0, color=COLOURS[0])
    across = x([value for value, _ in item.limits])
    least, most = min([*low, *across]), max([*high, *across])
    margin = (0.18 if item.ends else 0.06) * (most - least)
    axes.set_xlim(least - margin, most + margin)
    for place, start, end in zip(places, low, high, strict=True):
        for value, edge in ((start, "right"), (end, "left")) if item.ends and start < end else ():
            text: dict[str, Any] = {"xytext": (-3 if edge == "right" else 3, 0), "textcoords": "offset points"}
            text |= {"ha": edge, "va": "center", "fontsize": 7.5, "bbox": _PLAIN, "zorder": 4.0}
            axes.annotate(number(value, 3), (value, place), **text)
    for place, name, start, end in zip(places, item.names, low, high, strict=True):
        right = 0.5 * (start + end) > 0.5 * (least + most)
        side: dict[str, Any] = {"ha": "right" if right else "left", "va": "bottom", "fontsize": 8.5}
        side |= {"bbox": _PLAIN, "zorder": 4.0}
        head = written(name, x.system)
        if max(map(len, head.split("\n"))) > LONGEST_NAME:
            # a sentence has room only along the whole panel; beside its bar it would squeeze all panels
            side |= {"ha": "left", "xycoords": ("axes fraction", "data")}
            axes.annotate(head, (0.0, place - 0.14), **side).set_in_layout(False)
        else:
            axes.annotate(head, (end if right else start, place - 0.14), **side)
    # the words of limits stand above the first name, however many lines it has
    top = -0.75 - 0.35 * item.names[0].count("\n") if item.names else -0.75
    for limit, (_, label) in zip(across, item.limits, strict=True):
        axes.axvline(limit, color="black", linestyle="--", linewidth=1.0)
        axes.annotate(
            written(label, x.system), (limit, top), xytext=(3, 0), textcoords="offset points", fontsize=9.0, va="top"
        )
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)
    axes.set_ylim(len(places) - 0.7, top - 0.05 if item.limits else -0.6)
    axes.grid(visible=False)


def _label(axes: "Any", item: Label, x: Scale, y: Scale, pens: Pens) -> None:
    (across,), (up,) = x((item.x,)), y((item.y,))
    side = "left" if item.left else "center"
    colour = COLOURS[item.role % len(COLOURS)]
    axes.text(
        across, up, written(item.text, x.system), fontsize=8.5, color=colour, ha=side, va="center", bbox=_BACKGROUND
    )


def _ruler(axes: "Any", item: Ruler, x: Scale, y: Scale, pens: Pens) -> None:
    length, text = rounded(item, x.system)
    (x0, x1), (height,) = x((item.x, item.x + length)), y((item.y,))
    if item.arrow:
        axes.annotate("", (x1, height), (x0, height), arrowprops={"arrowstyle": "-|>", "color": "black", **_SHAFT})
    else:
        axes.plot([x0, x1], [height, height], color="black", linewidth=1.0, marker="|", markersize=6.0)
    axes.annotate(text, (x0, height), xytext=(0, 5), textcoords="offset points", fontsize=8.5, va="bottom")


def _shares(axes: "Any", item: Shares, x: Scale, y: Scale, pens: Pens) -> None:
    """Each total as a bar of its parts, with its label above; the largest parts have their own colours."""
    sums: dict[str, float] = {}
    for parts in item.parts:
        for name, amount in parts:
            sums[name] = sums.get(name, 0.0) + amount
    sums.pop("", None)
    coloured = sorted(sums, key=lambda name: -sums[name])[:MOST_COLOURED]
    inches = 0.96 * axes.figure.get_figwidth()
    for nth, (head, parts) in enumerate(zip(item.heads, item.parts, strict=True)):
        axes.text(0.0, nth - 0.36, written(head, x.system), fontsize=8.5, va="center")
        start, total = 0.0, sum(amount for _, amount in parts)
        for name, part in parts:
            amount = part / total
            colour = COLOURS[coloured.index(name)] if name in coloured else OTHERS
            style = {"color": colour, "alpha": 0.38 if name in coloured else 1.0, "edgecolor": "white"}
            axes.barh([nth + 0.08], [amount], left=start, height=0.5, linewidth=1.0, **style)
            text = _fitting(name or "others", f"{100.0 * amount:.0f} %", amount * inches)
            if text:
                axes.text(
                    start + 0.5 * amount, nth + 0.08, text, fontsize=7.5, ha="center", va="center", linespacing=1.0
                )
            start += amount
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(len(item.heads) - 0.6, -0.6)


def _fitting(name: str, share: str, inches: float) -> str:
    """As much of a part's name and share as its bar has room for, on two lines at most."""
    words = f"{name} {share}"
    choices = [
        words,
        f"{name}\n{share}",
        *(f"{words[:i]}\n{words[i + 1 :]}" for i, letter in enumerate(words) if letter == " "),
    ]
    fits = [text for text in choices if max(map(len, text.split("\n"))) * LETTER < inches]
    return next(iter(fits), share if len(share) * LETTER < inches else "")


def _dimension(axes: "Any", item: Dimension, x: Scale, y: Scale, pens: Pens) -> None:
    (x0, x1), (y0, y1) = x(item.x), y(item.y)
    axes.annotate("", (x1, y1), (x0, y0), arrowprops={"arrowstyle": "<|-|>", "color": "black", **_DIMENSION})
    middle = 0.5 * (x0 + x1), 0.5 * (y0 + y1)
    text = written(item.text, x.system)
    axes.annotate(text, middle, xytext=(0, 2), textcoords="offset points", fontsize=8.5, ha="center", va="bottom")


def _rows(axes: "Any", item: Rows, x: Scale, y: Scale, pens: Pens) -> None:
    count = len(item.rows)
    for nth, (name, symbol, value) in enumerate(item.rows):
        height = count - nth - 0.5
        axes.text(0.0, height, name, fontsize=8.5, va="center")
        axes.text(0.62, height, written(symbol, x.system), fontsize=8.5, va="center", ha="center")
        axes.text(1.0, height, written(value, x.system), fontsize=8.5, va="center", ha="right")
        axes.plot([0.0, 1.0], [count - nth - 1.0] * 2, color="#cccccc", linewidth=0.6)
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(0.0, float(count))


def written(text: str, system: str) -> str:
    """A text with its values in the units of the picture, its symbols with subscripts."""
    return re.sub(r"(?<![^\W\d_])([^\W\d_])_(\w+)", r"$\1_{\2}$", words(text, system))


DRAW: "dict[type, Callable[..., None]]" = {
    Curve: _curve,
    Mark: _mark,
    Arrow: _arrow,
    Band: _band,
    Bars: _bars,
    Ranges: _ranges,
    Ruler: _ruler,
    Shares: _shares,
    Label: _label,
    Dimension: _dimension,
    Rows: _rows,
}
