"""The work–precision diagram: time against error of every method, and the front that none beats in both.

Every panel has the same axis of errors, from exact to no digit right, and times over that of the program's own method,
so that panels can be compared.
"""

from math import ceil, floor, log10

from dynamics_cli.accuracy.listing import counted
from dynamics_cli.accuracy.rows import CHOSEN, compared_worst
from dynamics_cli.pictures import Axis, Bars, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import EvaluationTime

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.accuracy.report import Accuracy
    from dynamics_cli.accuracy.rows import Row

    # A method's error, its time, its name, and how many cases it left.
    Point = tuple[float, float, str, int]

# What is more exact stands at the left end, what has no digit right at the right one.
EXACT, WRONG = 1e-17, 1.0
ENDS = (2e-18, 5.0)
PIECES = (10.0, 1e6)
# A panel's axes in points of print, alone and where two stand side by side, and its letters.
ALONE, WIDTH, HEIGHT, LETTER, LINE = 400.0, 220.0, 165.0, 4.3, 10.0
LEAST_LETTERS = 16
# Beside bars, which have a margin for their words.
MOST_OF_BAR = 46
# How far words stand above a point or below it, the nearest first.
ASIDES = tuple((-1) ** step * (step // 2) * 0.75 * LINE + (3.0 if step % 2 == 0 else -LINE) for step in range(36))
# The last of the colours, black.
OWN = 6
TITLE = "left is more exact, down is quicker (−n: n cases unanswered)"
PAGE = 8
ERROR = "worst error (1: all wrong)"


def work_precision(accuracy: "Accuracy", *_: "Any", **__: "Any") -> Picture:
    """A panel for every question with several methods, one of all of them, and one of each family's other questions."""
    if accuracy.cases is not None:
        return counted(accuracy.cases)
    questions = by_question(accuracy)
    if not questions:
        return errors_alone(accuracy)
    several = [rows for rows in questions if len(rows) > 1]
    alone: dict[str, list[Row]] = {}
    for rows in questions:
        if len(rows) == 1:
            alone.setdefault(rows[0].family, []).append(rows[0])
    panels = [overview(several)] if len({rows[0].family for rows in several}) > 1 else []
    width = ALONE if len(panels) + len(several) + len(alone) == 1 else WIDTH
    panels += [question_panel(rows, width) for rows in several]
    panels += [_alone(family, rows, width) for family, rows in alone.items()]
    # in more columns words would not fit beside their points
    return Picture(tuple(panels), TITLE, 1 if len(panels) == 1 else 2, PAGE)


def by_question(accuracy: "Accuracy") -> "list[list[Row]]":
    """The methods that have a time and an error, question by question."""
    questions: dict[tuple[str, str], list[Row]] = {}
    for row in accuracy.methods:
        if row.time and row.cases:
            questions.setdefault((row.family, row.question), []).append(row)
    return list(questions.values())


def errors_alone(accuracy: "Accuracy") -> Picture:
    """Where there are no times: worst errors as bars, by method, and by question where each has one method."""
    questions: dict[tuple[str, str], list[Row]] = {}
    for row in accuracy.methods:
        questions.setdefault((row.family, row.question), []).append(row)
    several = [rows for rows in questions.values() if len(rows) > 1]
    panels = [_bars([(_words(*_named(row), MOST_OF_BAR), row) for row in rows], rows) for rows in several]
    alone: dict[str, list[Row]] = {}
    for rows in questions.values():
        if len(rows) == 1:
            alone.setdefault(rows[0].family, []).append(rows[0])
    for family, rows in alone.items():
        panels.append(_bars([(row.question.removeprefix(family).lstrip(", "), row) for row in rows], [], family))
    return Picture(tuple(panels), "worst errors: shorter is more exact", 1 if len(panels) == 1 else 2, PAGE)


def _bars(named: "list[tuple[str, Row]]", rows: "list[Row]", family: str = "") -> Panel:
    """Bars of methods of one question, or of one method each of several."""
    errors = [_error(row, rows or [row]) for _, row in named]
    bars = Bars(tuple(name for name, _ in named), [ENDS[0]] * len(named), errors)
    title = rows[0].question if rows else f"{family}: one method each"
    return Panel(_errors_in(named[0][1].measure), Axis(""), (bars,), title)


def overview(several: "list[list[Row]]") -> Panel:
    """Every method of every question of relative errors as a point, by family, the program's own in black."""
    points: dict[str, tuple[list[float], list[float]]] = {}
    own: list[float] = []
    for rows in several:
        if rows[0].measure != "relative":
            continue
        base = rows[0].time or 1.0
        for row in rows:
            if row.method.endswith(CHOSEN):
                own.append(_error(row, rows))
                continue
            across, up = points.setdefault("convert" if row.family == "coords" else row.family, ([], []))
            across.append(_error(row, rows))
            up.append((row.time or 0.0) / base)
    curves = [
        Curve(across, up, f"{family}: alternatives", "points", place)
        for place, (family, (across, up)) in enumerate(points.items())
    ]
    curves.append(Curve(own, [1.0] * len(own), "our own methods", "points", OWN))
    axis = _ratios([ratio for _, ups in points.values() for ratio in ups])
    return Panel(Axis(ERROR, None, True, ends=ENDS), axis, tuple(curves), "all questions with several methods")


def question_panel(rows: "list[Row]", width: float = WIDTH) -> Panel:
    """One question: its methods by name, and the front."""
    base = rows[0].time or 1.0
    pieces = rows[0].entities is not None
    x = Axis("pieces needed", None, True, ends=PIECES) if pieces else _errors_in(rows[0].measure)
    points = [
        (float(row.entities or PIECES[1]) if pieces else _error(row, rows), (row.time or 0.0) / base, *_named(row))
        for row in rows
    ]
    y = _ratios([ratio for _, ratio, *_ in points])
    marks = _marks(points, x, y, width)
    return Panel(x, y, (_front(points, x, y), *marks), f"{rows[0].question} (1 = {_amount(base)})")


def _alone(family: str, rows: "list[Row]", width: float) -> Panel:
    """Questions that only the program's own method answers, with times as they are."""
    points = [(_error(row, [row]), row.time or 0.0, row.question.removeprefix(family).lstrip(", "), 0) for row in rows]
    times = [time for _, time, *_ in points]
    ends = (10.0 ** floor(log10(min(times)) - 0.3), 10.0 ** ceil(log10(max(times)) + 0.3))
    x, y = _errors_in("relative"), Axis("time of one evaluation", EvaluationTime, True, ends=ends)
    return Panel(x, y, tuple(_marks(points, x, y, width)), f"{family}: one method each")


def _errors_in(measure: str) -> Axis:
    return Axis(ERROR if measure == "relative" else f"worst error in {measure}", None, True, ends=ENDS)


def _error(row: "Row", rows: "list[Row]") -> float:
    """Where a method of a question stands on the axis of errors."""
    return min(max(compared_worst(row, rows), EXACT), WRONG)


def _named(row: "Row") -> "tuple[str, int]":
    """A method's name, marked where it is the program's own, and how many cases it left."""
    name = row.method.removesuffix(CHOSEN)
    return (f"▸ {name}" if name != row.method else name), row.refused


def _words(name: str, left: int, most: int) -> str:
    """The words beside a point, no longer than there is room."""
    more = f" (−{left})" if left else ""
    room = max(most, LEAST_LETTERS) - len(more)
    return (name if len(name) <= room else name[: room - 1].rstrip(" ,") + "…") + more


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


def _front(points: "list[Point]", x: Axis, y: Axis) -> Curve:
    """The edge of what no method reaches: every point above it and to its right is beaten by one on it."""
    assert x.ends is not None
    assert y.ends is not None
    across: list[float] = []
    up = [y.ends[1]]
    for error, time, *_ in sorted(points):
        if time < up[-1]:
            across += [error, error]
            up += [up[-1], time] if len(up) > 1 else [time]
    return Curve([*across, x.ends[1]], [*up, up[-1]], "", "dashed", 0)


def _marks(points: "list[Point]", across: Axis, up: Axis, width: float) -> "list[Mark]":
    """Points with their words to the side that has more room, where the fewest other words and points are."""
    assert across.ends is not None
    assert up.ends is not None
    places = [(width * _share(error, across.ends), HEIGHT * _share(time, up.ends)) for error, time, *_ in points]
    taken = [(x - 3.0, x + 3.0, y - 3.0, y + 3.0) for x, y in places]
    marks = []
    for own, ((x, y), (error, time, name, less)) in enumerate(zip(places, points, strict=True)):
        left = x > 0.5 * width
        room = x - 5.0 if left else width - x - 5.0
        words = _words(name, less, int(room / LETTER))
        start = x - 5.0 - LETTER * len(words) if left else x + 5.0
        ends = start, start + LETTER * len(words)
        others = [box for place, box in enumerate(taken) if place != own]
        boxes = [(aside, (*ends, y + aside - 1.0, y + aside + LINE - 1.0)) for aside in ASIDES]
        inside = [pair for pair in boxes if pair[1][2] >= 0.0 and pair[1][3] <= HEIGHT] or boxes
        aside, box = min(inside, key=lambda pair: sum(_common(pair[1], other) for other in others))
        taken.append(box)
        marks.append(Mark(error, time, words, (-5.0 if left else 5.0, aside)))
    return marks


def _share(value: float, ends: "tuple[float, float]") -> float:
    """How far along a logarithmic axis a number stands."""
    return log10(value / ends[0]) / log10(ends[1] / ends[0])


def _common(one: "tuple[float, ...]", other: "tuple[float, ...]") -> float:
    """The area that two boxes share."""
    across = min(one[1], other[1]) - max(one[0], other[0])
    up = min(one[3], other[3]) - max(one[2], other[2])
    return across * up if across > 0.0 and up > 0.0 else 0.0
