"""Pictures as data: panels of curves, marks, arrows, bands and bars in SI numbers; the core draws them with units.

A task's picture function takes the result record and then the task's own parameters by name, and gives a `Picture`.
Axes carry a kind (`Axis("lift", Size)`), so that the core converts and labels them in the units the call asked for.
"""

from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any, Literal

    Numbers = Sequence[float]


@record
class Axis:
    """One axis: its title, the kind of its SI numbers (None for pure numbers or names), and its ends, if set."""

    title: str
    kind: "Any" = None
    logarithmic: bool = False
    ends: tuple[float, float] | None = None


@record
class Curve:
    """A line through points; a non-finite y breaks it. `filled` closes it and fills it faintly."""

    x: "Numbers"
    y: "Numbers"
    label: str = ""
    style: "Literal['solid', 'dashed', 'dotted', 'thin', 'points', 'steps', 'filled']" = "solid"
    role: int = -1
    """Curves of one role share a colour across panels; -1 takes the next colour."""


@record
class Mark:
    """A point with words beside it, `aside` points of print from it; to its left where that is negative."""

    x: float
    y: float
    label: str = ""
    aside: tuple[float, float] = (5.0, 5.0)


@record
class Arrow:
    """An arrow from (x, y) by (dx, dy), in the units of the axes."""

    x: float
    y: float
    dx: float
    dy: float
    label: str = ""
    role: int = 0


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
class Panel:
    """One pair of axes and what is drawn on it; `equal` gives both axes one scale, as shapes need."""

    x: Axis
    y: Axis
    items: "tuple[Curve | Mark | Arrow | Band | Bars, ...]"
    title: str = ""
    equal: bool = False


@record
class Picture:
    """Panels one below another, or in `columns`, under one title; so many on a `page` of a PDF (0: all)."""

    panels: tuple[Panel, ...]
    title: str = ""
    columns: int = 1
    page: int = 0
