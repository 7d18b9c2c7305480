"""The work–precision diagram: time against error of every method, and the front that none beats in both."""

from dynamics_cli.pictures import Axis, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import EvaluationTime

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.accuracy.report import Accuracy
    from dynamics_cli.accuracy.rows import Row

# Where an exact result stands on a logarithmic axis.
EXACT = 1e-18
MOST_PANELS = 12


def work_precision(made: "Accuracy", *_: "Any", **__: "Any") -> Picture:
    """A panel for every question with several methods; else one panel of all."""
    timed = [row for row in made.methods if row.time]
    by_question: dict[str, list[Row]] = {}
    for row in timed:
        by_question.setdefault(row.question, []).append(row)
    several = [rows for rows in by_question.values() if len(rows) > 1]
    panels = [_panel(rows[0].question, rows, by_method=True) for rows in several[:MOST_PANELS]]
    if not panels:
        panels = [_panel("", timed, by_method=False)]
    return Picture(tuple(panels), "work–precision", 2 if len(panels) > 1 else 1)


def _panel(title: str, rows: "list[Row]", *, by_method: bool) -> Panel:
    points = [(max(row.worst, EXACT), row.time or 0.0, row.method if by_method else row.question) for row in rows]
    front: list[tuple[float, float]] = []
    for error, time, _ in sorted(points):
        if not front or time < front[-1][1]:
            front.append((error, time))
    items: list[Any] = [Mark(error, time, label) for error, time, label in points]
    if len(front) > 1:
        items.insert(0, Curve([error for error, _ in front], [time for _, time in front], "front", "dashed"))
    x = Axis("worst relative error", logarithmic=True)
    return Panel(x, Axis("time of one evaluation", EvaluationTime, logarithmic=True), tuple(items), title)
