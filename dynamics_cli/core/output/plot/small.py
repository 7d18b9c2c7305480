"""Small pictures in the terminal: curves in dots of Braille, bars in blocks."""

import math
from textwrap import wrap

from dynamics_cli.core.documents import number
from dynamics_cli.core.output.plot.axes import Scale, finite, words
from dynamics_cli.pictures import Arrow, Band, Bars, Curve, Mark, Ranges, Rows, Shares

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.pictures import Panel, Picture

    Point = tuple[float, float]

MARGIN = 11
MOST_WIDTH = 72
LEAST_WIDTH = 16
LETTERS = "abcdefghijkl"
# Braille dots by row and column of a cell, which is two wide and four high.
_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
_BRAILLE = 0x2800


def sketch(picture: "Picture", system: str, columns: int, lines: int) -> str:
    """The picture as text of at most `columns` columns, each panel at most `lines` high."""
    width = max(LEAST_WIDTH, min(columns - MARGIN - 1, MOST_WIDTH))
    parts = [words(picture.title, system)] if picture.title else []
    for panel in picture.panels:
        if any(isinstance(item, Rows | Ranges) for item in panel.items):
            continue  # a table of results: the answer is printed above
        share_items = [item for item in panel.items if isinstance(item, Shares)]
        parts += [_told(item, panel.title, system, min(columns, MARGIN + MOST_WIDTH)) for item in share_items]
        bars = [item for item in panel.items if isinstance(item, Bars)]
        if bars:
            parts += [_bars(panel, item, system, min(columns, MARGIN + MOST_WIDTH)) for item in bars]
        elif not share_items:
            parts.append(_dots(panel, system, width, max(6, min(lines - 6, 14))))
    return "\n".join(line.rstrip() for part in parts for line in part.split("\n")) + "\n"


def _dots(panel: "Panel", system: str, width: int, height: int) -> str:
    x, y = Scale(panel.x, system), Scale(panel.y, system)
    paths = [path for item in panel.items for path in _paths(item, x, y)]
    every = [point for path in paths for point in path]
    across, up = finite([a for a, _ in every]), finite([b for _, b in every])
    if not across or not up:
        return f"{panel.title or y.label}: nothing to show"
    left, right, low, high = min(across), max(across), min(up), max(up)
    if panel.equal:
        left, right, low, high = _squared(left, right, low, high, width / (2.0 * height))
    canvas = _Canvas(width, height, (left, right or left + 1.0), (low, high))
    for path in paths:
        canvas.path(path)
    names = [*_named(panel, canvas, x, y, system), *_lines(panel, canvas, x, y)]
    ends = [_back(end, x.logarithmic) for end in (left, right)]
    if panel.x.names:
        ends = [panel.x.names[0], panel.x.names[-1]]
    sides = [_back(end, y.logarithmic) for end in (high, low)]
    rows = canvas.rows()
    texts = [sides[0], *[""] * (len(rows) - 2), sides[1]]
    body = [f"{text:>{MARGIN - 1}} {row}".rstrip() for text, row in zip(texts, rows, strict=True)]
    foot = f"{'':{MARGIN}}{ends[0]}{ends[1]:>{max(1, width - len(ends[0]))}}"
    head = wrap(f"{y.label}{': ' + panel.title if panel.title else ''}", MARGIN + width)
    legend = wrap("; ".join(names), MARGIN + width) if names else []
    return "\n".join([*head, *legend, *body, foot, f"{'':{MARGIN}}{x.label}"])


def _named(panel: "Panel", canvas: "_Canvas", x: Scale, y: Scale, system: str) -> "list[str]":
    """The names of curves, each with the letter that stands on it when there are several; words at marks and arrows."""
    curves = [item for item in panel.items if isinstance(item, Curve) and item.label]
    names = [words(item.label, system) for item in curves]
    if len(curves) > 1:
        names = [f"{letter} {name}" for letter, name in zip(LETTERS, names, strict=False)]
        for nth, curve in enumerate(curves[: len(LETTERS)]):
            points = [point for path in _paths(curve, x, y) for point in path]
            # Spread over the curves' lengths, so that curves side by side have their letters apart.
            canvas.letter(points[len(points) * (nth + 1) // (len(curves) + 1)], LETTERS[nth])
    for item in panel.items:
        if isinstance(item, Mark | Arrow) and item.label:
            canvas.words(_paths(item, x, y)[0][-1], words(item.label, system))
    return names


def _lines(panel: "Panel", canvas: "_Canvas", x: Scale, y: Scale) -> "list[str]":
    """Dotted lines across the panel, and labels for them and for shaded ranges."""
    labels = []
    for item in panel.items:
        if not isinstance(item, Band):
            continue
        scale = x if item.vertical else y
        low, high = (_log(end) if scale.logarithmic else end for end in scale((item.low, item.high)))
        if low == high:
            canvas.line(low, vertical=item.vertical)
        ends = dict.fromkeys(_back(end, scale.logarithmic) for end in (low, high))
        if item.label:
            labels.append(f"{item.label} {' to '.join(ends)}")
    return labels


def _log(value: float) -> float:
    return math.log10(value) if value > 0.0 else math.nan


def _back(value: float, logarithmic: bool) -> str:
    return number(10.0**value if logarithmic else value, 4)


def _paths(item: object, x: Scale, y: Scale) -> "list[list[Point]]":
    """The lines that an item draws, in axis units."""
    paths = _shown(item, x, y)
    if x.logarithmic:
        paths = [[(_log(a), b) for a, b in path] for path in paths]
    if y.logarithmic:
        paths = [[(a, _log(b)) for a, b in path] for path in paths]
    return paths


def _shown(item: object, x: Scale, y: Scale) -> "list[list[Point]]":
    if isinstance(item, Curve) and item.style == "ground":
        return []
    if isinstance(item, Curve):
        points = list(zip(x(item.x), y(item.y), strict=True))
        return [[point] for point in points] if item.style == "points" else [points]
    if isinstance(item, Mark):
        return [list(zip(x((item.x,)), y((item.y,)), strict=True))]
    if isinstance(item, Arrow):
        return [list(zip(x((item.x, item.x + item.dx)), y((item.y, item.y + item.dy)), strict=True))]
    return []


def _squared(left: float, right: float, low: float, high: float, shape: float) -> "tuple[float, float, float, float]":
    """Both axes widened to one scale; `shape` is width over height of the canvas."""
    middle, centre = 0.5 * (left + right), 0.5 * (low + high)
    half = 0.5 * max(right - left, (high - low) * shape)
    return middle - half, middle + half, centre - half / shape, centre + half / shape


class _Canvas:
    """Dots, two by four to a character."""

    def __init__(self, width: int, height: int, across: "tuple[float, float]", up: "tuple[float, float]") -> None:
        self.wide, self.high = 2 * width, 4 * height
        self.left, self.low = across[0], up[0]
        self.per_x = (self.wide - 1) / ((across[1] - across[0]) or 1.0)
        self.per_y = (self.high - 1) / ((up[1] - up[0]) or 1.0)
        self.cells = [[0] * width for _ in range(height)]
        self.text: list[dict[int, str]] = [{} for _ in range(height)]

    def path(self, points: "list[Point]") -> None:
        """A line through points, broken at non-finite ones."""
        before: Point | None = None
        for a, b in points:
            if not (a - a == 0.0 and b - b == 0.0):
                before = None
                continue
            cell = ((a - self.left) * self.per_x, (b - self.low) * self.per_y)
            start = before or cell
            steps = max(1, math.ceil(max(abs(cell[0] - start[0]), abs(cell[1] - start[1]))))
            for step in range(steps + 1):
                t = step / steps
                self._dot(round(start[0] + t * (cell[0] - start[0])), round(start[1] + t * (cell[1] - start[1])))
            before = cell

    def _dot(self, column: int, row: int) -> None:
        if 0 <= column < self.wide and 0 <= row < self.high:
            line = self.high - 1 - row
            self.cells[line // 4][column // 2] |= _DOTS[line % 4][column % 2]

    def line(self, at: float, *, vertical: bool) -> None:
        """A dotted line across."""
        place = (at - self.left) * self.per_x if vertical else (at - self.low) * self.per_y
        if place - place == 0.0:
            for other in range(0, self.high if vertical else self.wide, 3):
                self._dot(*(round(place), other) if vertical else (other, round(place)))

    def letter(self, point: "Point", text: str) -> None:
        """A letter on a point."""
        place = self._cell(point)
        if place is not None:
            row, column = place
            self.text[row][column] = text

    def words(self, point: "Point", text: str) -> None:
        """A label beside a point on whichever side it fits; else none."""
        place = self._cell(point)
        if place is None:
            return
        row, column = place
        for start in (column + 1, column - len(text) - 1):
            cells = range(start - 1, start + len(text) + 1)
            fits = start >= 0 and start + len(text) <= len(self.cells[row])
            if fits and not any(cell in self.text[row] for cell in cells):
                self.text[row].update({start + nth: letter for nth, letter in enumerate(text)})
                return

    def _cell(self, point: "Point") -> "tuple[int, int] | None":
        a, b = (point[0] - self.left) * self.per_x, (point[1] - self.low) * self.per_y
        if not (a - a == 0.0 and b - b == 0.0 and -1.0 < a < self.wide and -1.0 < b < self.high):
            return None
        return (self.high - 1 - max(0, round(b))) // 4, min(round(a), self.wide - 1) // 2

    def rows(self) -> "list[str]":
        """The lines of text."""
        return [
            "".join(words.get(nth) or (chr(_BRAILLE + cell) if cell else " ") for nth, cell in enumerate(row))
            for row, words in zip(self.cells, self.text, strict=True)
        ]


def _told(item: Shares, title: str, system: str, columns: int) -> str:
    """The parts of every whole, in words."""
    lines = [title]
    for head, parts in zip(item.heads, item.parts, strict=True):
        total = sum(amount for _, amount in parts)
        shares_text = ", ".join(f"{name or 'others'} {100.0 * amount / total:.0f} %" for name, amount in parts)
        lines += [
            *wrap(words(head, system), columns),
            *wrap(shares_text, columns, initial_indent="  ", subsequent_indent="  "),
        ]
    return "\n".join(lines)


def _bars(panel: "Panel", item: Bars, system: str, columns: int) -> str:
    """Bars in blocks, their names cut to less than half of the columns."""
    x = Scale(panel.x, system)
    low, high = x(item.low), x(item.high)
    if x.logarithmic:
        low, high = [_log(end) for end in low], [_log(end) for end in high]
    least, most = min(low), max(high)
    names = [name if len(name) <= columns // 2 else f"{name[: columns // 2 - 1]}…" for name in item.names]
    margin = max(map(len, names)) + 1
    width = max(LEAST_WIDTH // 2, columns - margin)
    per = (width - 1) / ((most - least) or 1.0)
    lines = [f"{x.label}{': ' + panel.title if panel.title else ''}"]
    labels = [
        f"{band.label} {' to '.join(dict.fromkeys(number(end, 4) for end in x((band.low, band.high))))}"
        for band in panel.items
        if isinstance(band, Band) and band.label
    ]
    lines += wrap("; ".join(labels), columns) if labels else []
    for name, start, end in zip(names, low, high, strict=True):
        before = round((start - least) * per)
        lines.append(f"{name:>{margin - 1}} {' ' * before}{'█' * round((end - start) * per) or '▏'}")
    ends = _back(least, x.logarithmic), _back(most, x.logarithmic)
    lines.append(f"{'':{margin}}{ends[0]}{ends[1]:>{max(1, width - len(ends[0]))}}")
    return "\n".join(lines)
