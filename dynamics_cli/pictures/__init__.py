"""Pictures as data: panels of curves, marks, arrows, bands and bars in SI numbers; the core draws them with units.

A task's picture function takes the result record and then the task's own parameters by name, and gives a `Picture`.
Axes carry a kind (`Axis("lift", Size)`), so that the core converts and labels them in the units the call asked for.
"""

from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence
    from typing import Any, Literal

    Numbers = Sequence[float]
    Style = Literal[
        "solid",
        "dashed",
        "dotted",
        "thin",
        "points",
        "steps",
        "filled",
        "fill",
        "outline",
        "centre",
        "dots",
        "thick",
        "ground",
        "track",
    ]


@record
class Axis:
    """One axis: its title, and the kind of its SI numbers (None for pure numbers).

    `names` stand at 1, 2, 3 …; `ends` are where it begins and ends, and `step` parts its ticks, where what is drawn is
    not to decide.
    """

    title: str
    kind: "Any" = None
    logarithmic: bool = False
    names: "tuple[str, ...]" = ()
    ends: "tuple[float, float] | None" = None
    step: float = 0.0


@record
class Curve:
    """A line through points; a non-finite y breaks it. `filled` closes it and fills it faintly.

    Of shapes, `outline` is the line alone and `fill` the area alone; `centre` is the dash-dotted line of axes and pitch
    circles, `dots` a fine dotted one, `thick` a line that stands out. Of scenes, `ground` is a pale area beneath all
    else, `track` the grey mark of a wheel.
    """

    x: "Numbers"
    y: "Numbers"
    label: str = ""
    style: "Style" = "solid"
    role: int = -1
    """Curves of one role share a colour across panels; -1 takes the next colour."""


@record
class Mark:
    """A point with words beside it, `aside` points of print from it; to its left where that is negative.

    Without a `dot` the words stand alone: centred where `aside` has no first part, and in the colour of a `role`.
    """

    x: float
    y: float
    label: str = ""
    aside: tuple[float, float] = (5.0, 5.0)
    dot: bool = True
    role: int = -1


@record
class Arrow:
    """An arrow from (x, y) by (dx, dy), in the units of the axes."""

    x: float
    y: float
    dx: float
    dy: float
    label: str = ""
    role: int = 0
    dashed: bool = False


@record
class Band:
    """A shaded stretch from `low` to `high` of the horizontal (or vertical) axis; equal ends make a line."""

    low: float
    high: float
    label: str = ""
    vertical: bool = True


@record
class Bars:
    """Horizontal bars from `low` to `high`, one for each name, the first on top."""

    names: tuple[str, ...]
    low: "Numbers"
    high: "Numbers"


@record
class Ranges:
    """Intervals from `low` to `high` with their values `at`, one for each name, and named `limits` across them.

    With `ends` the numbers of the intervals stand beside their ends.
    """

    names: tuple[str, ...]
    low: "Numbers"
    high: "Numbers"
    at: "Numbers"
    limits: "tuple[tuple[float, str], ...]" = ()
    ends: bool = False


@record
class Shares:
    """Bars that are a whole each: the words over every bar, and its parts by name; parts of one name look alike.

    A part without a name is that of all others together.
    """

    heads: tuple[str, ...]
    parts: "tuple[tuple[tuple[str, float], ...], ...]"


@record
class Ruler:
    """A scale of a scene: a bar of a round number in the unit shown, `per` metres long for one of the kind in SI.

    It begins at (x, y) and is not longer than `longest`; that of a velocity is an arrow.
    """

    x: float
    y: float
    title: str
    kind: "Any"
    per: float
    longest: float
    arrow: bool = False


@record
class Label:
    """Words without a point; `(x, y)` is their middle, or their left end with `left`.

    A text of `worded` has its values in the units of the picture; `a_w` is written with a subscript.
    """

    x: float
    y: float
    text: str
    role: int = 6
    left: bool = False


@record
class Dimension:
    """A dimension line with an arrow at each end, its text above the middle."""

    x: "tuple[float, float]"
    y: "tuple[float, float]"
    text: str


@record
class Rows:
    """A table in place of axes: name, symbol and value in each row; values may be texts of `worded`."""

    rows: "tuple[tuple[str, str, str], ...]"


@record
class Panel:
    """One pair of axes and what is drawn on it; `equal` gives both axes one scale, as shapes need.

    `bare` shows no axes, for a scene that brings its own scales; `wide` takes the whole width of a picture in columns.
    """

    x: Axis
    y: Axis
    items: "tuple[Curve | Mark | Arrow | Band | Bars | Ranges | Shares | Ruler | Label | Dimension | Rows, ...]"
    title: str = ""
    equal: bool = False
    bare: bool = False
    wide: bool = False


@record
class Picture:
    """Panels one below another, or in `columns`, under one title; so many on a `page` of a PDF (0: all).

    It is as wide as its columns ask for, or `width` inches. A `scene` is for the first page of a report. The last
    `distributions` panels show how an uncertain result is spread; with `spread` the panels show that themselves. The
    subtitle says for which inputs, or how to read it.

    With `views` the three panels are top, front and side view of one body, whose axes have their ends; they are drawn
    on one scale, with `notes` beside them: a symbol, its number in SI, its kind (None: words alone).
    """

    panels: tuple[Panel, ...]
    title: str = ""
    columns: int = 1
    page: int = 0
    width: float = 0.0
    scene: bool = False
    distributions: int = 0
    spread: bool = False
    subtitle: str = ""
    views: bool = False
    notes: "tuple[tuple[str, float, Any], ...]" = ()


@record
class Plan:
    """A scene as a drawing to scale: a bare panel whose coordinates are true, `origin` being its zero in the scene.

    On paper a metre is `1/scale` of one. Styles of curves are layers of a file for CAD: ground is the road, track the
    marks, fill what is uncertain.
    """

    panel: Panel
    title: str
    scale: float
    origin: "tuple[float, float]" = (0.0, 0.0)


@record
class Spreads:
    """How uncertain the results of a case are, by address and in SI, for pictures that show it.

    `shares` of the variance are those of inputs in words, the largest first.
    """

    coverage: float
    intervals: "Mapping[str, tuple[float, float]]"
    deviations: "Mapping[str, float]"
    shares: "Mapping[str, tuple[tuple[str, float], ...]]"
    correlations: "Mapping[tuple[str, str], float]"
    limits: "Mapping[str, Sequence[float]]"
    cases: "Callable[[], Iterable[Mapping[str, Any]]]" = tuple
    """The task's parameters at some hundred fair cases of the inputs, for bands about a curve."""

    def covariance(self, one: str, other: str) -> float:
        """Covariance of two results; nothing of one that does not vary."""
        product = self.deviations.get(one, 0.0) * self.deviations.get(other, 0.0)
        return product if one == other else product * self.correlations.get((one, other), 0.0)


@record
class Listing:
    """A table of a data sheet: a heading, the heads of its columns, and rows of words; values may be `worded`.

    Under an axis in the head stand numbers in SI; infinity is written as a dash.
    """

    title: str
    head: "tuple[str | Axis, ...]"
    rows: "tuple[tuple[str | float, ...], ...]"


@record
class Sheet:
    """A result on one page, to go with a drawing: `left` and `right` side by side, then `foot` over the whole width."""

    title: str
    subtitle: str
    left: "tuple[Picture | Listing, ...]"
    right: "tuple[Picture | Listing, ...]"
    foot: "tuple[Picture | Listing, ...]" = ()


def complex_curve(points: "Iterable[complex]", label: str, style: "Any", role: int) -> Curve:
    """A curve through points given as complex numbers."""
    points = list(points)
    return Curve([point.real for point in points], [point.imag for point in points], label, style, role)
