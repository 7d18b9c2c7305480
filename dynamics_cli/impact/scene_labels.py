"""Words of a scene put where they cover nothing: each near its point, on the side it asks for if that is free."""

import math
from itertools import pairwise

from dynamics_cli.pictures import Arrow, Curve, Dimension, Label, Ruler
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any

    Pair = tuple[float, float]
    Box = tuple[float, float, float, float]

# Inches of print: a letter, a line, the room around words, and the steps at which lines are looked at.
LETTER, LINE, ROOM, STEP = 0.068, 0.15, 0.03, 0.06
# How far words may stand from their point, in inches; farther ones have a line to it.
DISTANCES = (0.06, 0.16, 0.3, 0.5, 0.8, 1.2)
FAR = 0.25
WAYS = 16
# Costs of a covered point, an inch of distance, the other side, and overlapping labels.
COVERED, AWAY, TURNED, CLASH = 2.0, 1.5, 0.8, 1000.0
# Pale areas beneath all else.
GROUND = ("ground", "fill", "dots")


@record
class Words:
    """Words that belong to a point and would stand on a side of it."""

    at: "Pair"
    way: "Pair"
    text: str
    role: int


def placed(items: "Sequence[Any]", wanted: "Sequence[Words]", metres: float) -> "list[Any]":
    """Labels, and thin lines to those that are far, for a scene drawn at so many metres to an inch."""
    covered = [point for item in items if getattr(item, "style", "") not in GROUND for point in _along(item, metres)]
    labels: list[Any] = []
    boxes: list[Box] = []
    for words in wanted:
        box, far = min(
            _choices(words, metres), key=lambda choice: _cost(words, choice[0], choice[1], metres, covered, boxes)
        )
        boxes.append(box)
        middle = 0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])
        if far > FAR * metres:
            labels.append(_leader(words, box))
        labels.append(Label(*middle, words.text, words.role))
    return labels


def _choices(words: Words, metres: float) -> "Iterator[tuple[Box, float]]":
    """Boxes about the point at growing distances, and these distances."""
    half = _half(words.text, metres)
    for inches in DISTANCES:
        for nth in range(WAYS):
            x, y = math.cos(math.tau * nth / WAYS), math.sin(math.tau * nth / WAYS)
            # extent of the box against this direction, less at a corner
            reach = min(
                half[0] / abs(x) if abs(x) > 1e-9 else math.inf, half[1] / abs(y) if abs(y) > 1e-9 else math.inf
            )
            away = inches * metres + reach
            cx, cy = words.at[0] + away * x, words.at[1] + away * y
            yield (cx - half[0], cy - half[1], cx + half[0], cy + half[1]), inches * metres


def _half(text: str, metres: float) -> "Pair":
    """Half the width and half the height of words."""
    lines = text.split("\n")
    return 0.5 * LETTER * metres * max(map(len, lines)), 0.5 * LINE * metres * len(lines)


def bounds(items: "Sequence[Any]", metres: float) -> "Box":
    """Bounding box of items with their labels: left, low, right, high."""
    points = [point for item in items for point in ends(item)]
    for item in items:
        if isinstance(item, Label):
            wide, high = _half(item.text, metres)
            middle = item.x + wide if item.left else item.x
            points += [(middle - wide, item.y - high), (middle + wide, item.y + high)]
        elif isinstance(item, Ruler):
            points.append((item.x + 2.0 * _half(item.title + ": 100 km/h", metres)[0], item.y))
    x, y = [point[0] for point in points], [point[1] for point in points]
    return min(x), min(y), max(x), max(y)


def _cost(
    words: Words, box: "Box", far: float, metres: float, covered: "Sequence[Pair]", boxes: "Sequence[Box]"
) -> float:
    """Cost of a place: items covered, and distance from the preferred place."""
    margin = ROOM * metres
    x0, y0, x1, y1 = box[0] - margin, box[1] - margin, box[2] + margin, box[3] + margin
    hidden = sum(x0 < x < x1 and y0 < y < y1 for x, y in covered)
    clashes = sum(x0 < b[2] and b[0] < x1 and y0 < b[3] and b[1] < y1 for b in boxes)
    offset = 0.5 * (box[0] + box[2]) - words.at[0], 0.5 * (box[1] + box[3]) - words.at[1]
    size = math.hypot(*offset) * math.hypot(*words.way)
    turn = 1.0 - (offset[0] * words.way[0] + offset[1] * words.way[1]) / size if size else 0.0
    return COVERED * hidden + CLASH * clashes + AWAY * far / metres + TURNED * turn


def _leader(words: Words, box: "Box") -> Curve:
    """A thin line from the point to the nearest side of the words."""
    x = min(max(words.at[0], box[0]), box[2])
    y = min(max(words.at[1], box[1]), box[3])
    return Curve([words.at[0], x], [words.at[1], y], "", "thin", words.role)


def ends(item: "Any") -> "list[Pair]":
    """The points that an item spans."""
    if isinstance(item, Curve | Dimension):
        return list(zip(item.x, item.y, strict=True))
    if isinstance(item, Arrow):
        return [(item.x, item.y), (item.x + item.dx, item.y + item.dy)]
    if isinstance(item, Ruler):
        return [(item.x, item.y), (item.x + item.longest, item.y)]
    return [(item.x, item.y)]


def _along(item: "Any", metres: float) -> "Iterator[Pair]":
    """Points along an item's lines, close enough that no words slip between them."""
    points = ends(item)
    yield points[0]
    for (x0, y0), (x1, y1) in pairwise(points):
        steps = max(1, math.ceil(math.hypot(x1 - x0, y1 - y0) / (STEP * metres)))
        for step in range(1, steps + 1):
            yield x0 + (x1 - x0) * step / steps, y0 + (y1 - y0) * step / steps
