"""The work–precision diagram: time against error of every method.

Every panel has the same axis of errors, from exact to no digit right, and times over that of the program's own method,
so that panels can be compared.
"""

from math import ceil, floor, log10

from dynamics_cli.accuracy.listing import counted
from dynamics_cli.accuracy.rows import CHOSEN, compared_worst
from dynamics_cli.pictures import Axis, Bars, Curve, Panel, Picture

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.accuracy.report import Accuracy
    from dynamics_cli.accuracy.rows import Row

# What is more exact stands at the left end, what has no digit right at the right one.
EXACT, WRONG = 1e-17, 1.0
ENDS = (2e-18, 5.0)
# The last of the colours, black.
OWN = 6
TITLE = "left is more exact, down is quicker (−n: n cases unanswered)"
UNTIMED = "worst errors: shorter is more exact"
PAGE = 8
ERROR = "worst error (1: all wrong)"


def work_precision(accuracy: "Accuracy", *_: "Any", **__: "Any") -> Picture:
    """A panel for every question with several methods, one of all of them, and one of each family's other questions.

    Where there are no times, and where a question has one method, errors are bars.
    """
    if accuracy.cases is not None:
        return counted(accuracy.cases)
    questions = by_question(accuracy)
    several = [rows for rows in questions if len(rows) > 1]
    alone: dict[str, list[Row]] = {}
    for rows in questions:
        if len(rows) == 1:
            alone.setdefault(rows[0].family, []).append(rows[0])
    timed = any(row.time for rows in questions for row in rows)
    panels = [overview(several)] if timed and len({rows[0].family for rows in several}) > 1 else []
    panels += [question_panel(rows) if timed else _bars(rows) for rows in several]
    panels += [_bars(rows, family) for family, rows in alone.items()]
    return Picture(tuple(panels), TITLE if timed else UNTIMED, 1 if len(panels) == 1 else 2, PAGE)


def by_question(accuracy: "Accuracy") -> "list[list[Row]]":
    """The methods that answer, question by question."""
    questions: dict[tuple[str, str], list[Row]] = {}
    for row in accuracy.methods:
        if row.cases:
            questions.setdefault((row.family, row.question), []).append(row)
    return list(questions.values())


def _bars(rows: "list[Row]", family: str = "") -> Panel:
    """Worst errors of the methods of one question, or of a family's questions of one method each."""
    if family:
        names = tuple(row.question.removeprefix(family).lstrip(", ") for row in rows)
        errors = [_error(row, [row]) for row in rows]
    else:
        names, errors = tuple(_name(row) for row in rows), [_error(row, rows) for row in rows]
    title = f"{family}: one method each" if family else rows[0].question
    return Panel(_errors_in(rows[0].measure), Axis(""), (Bars(names, [ENDS[0]] * len(rows), errors),), title)


def overview(several: "list[list[Row]]") -> Panel:
    """Every method of every question of relative errors as a point, the program's own in black."""
    own: list[float] = []
    across: list[float] = []
    up: list[float] = []
    for rows in several:
        if rows[0].measure == "relative":
            first, *others = rows
            own.append(_error(first, rows))
            across += [_error(row, rows) for row in others]
            up += [(row.time or 0.0) / (first.time or 1.0) for row in others]
    curves = (
        Curve(across, up, "textbooks' methods and others", "points", 1),
        Curve(own, [1.0] * len(own), "our own methods", "points", OWN),
    )
    return Panel(Axis(ERROR, None, True, ends=ENDS), _ratios(up), curves, "all questions with several methods")


def question_panel(rows: "list[Row]") -> Panel:
    """One question: its methods by name."""
    base = rows[0].time or 1.0
    x = _errors_in(rows[0].measure)
    ratios = [(row.time or 0.0) / base for row in rows]
    curves = tuple(
        Curve(
            (_error(row, rows),), (ratio,), _name(row), "points",
            OWN if row.method.endswith(CHOSEN) else place,
        )
        for place, (row, ratio) in enumerate(zip(rows, ratios, strict=True), start=-1)
    )  # fmt: skip
    return Panel(x, _ratios(ratios), curves, f"{rows[0].question} (1 = {_amount(base)})")


def _errors_in(measure: str) -> Axis:
    return Axis(ERROR if measure == "relative" else f"worst error in {measure}", None, True, ends=ENDS)


def _error(row: "Row", rows: "list[Row]") -> float:
    """Where a method of a question stands on the axis of errors."""
    return min(max(compared_worst(row, rows), EXACT), WRONG)


def _name(row: "Row") -> str:
    """A method's name, marked where it is the program's own, and how many cases it left."""
    name = row.method.removesuffix(CHOSEN)
    return (f"our own: {name}" if name != row.method else name) + (f" (−{row.refused})" if row.refused else "")


def _amount(seconds: float) -> str:
    """A time with the unit that suits it."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def _ratios(ratios: "list[float]") -> Axis:
    """The axis of times over the chosen method's: whole decades about one, two at least."""
    low, high = min(*ratios, 1.0), max(*ratios, 1.0)
    ends = (10.0 ** min(floor(log10(low) - 0.2), -1), 10.0 ** max(ceil(log10(high) + 0.2), 1))
    return Axis("time, own method = 1", None, True, ends=ends)
