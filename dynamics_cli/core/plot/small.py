"""Small pictures in the terminal: curves in dots of Braille, bars in blocks."""

import math

from dynamics_cli.core.plot.axes import Scale, finite
from dynamics_cli.core.render import number
from dynamics_cli.pictures import Arrow, Bars, Curve, Mark

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.pictures import Panel, Picture

    Point = tuple[float, float]

MARGIN = 11
MOST_WIDTH = 72
LEAST_WIDTH = 16
# Braille dots by row and column of a cell, which is two wide and four high.
_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
_BRAILLE = 0x2800


def sketch(picture: "Picture", system: str, columns: int, lines: int) -> str:
    """The picture as text of at most `columns` columns, each panel at most `lines` high."""
    width = max(LEAST_WIDTH, min(columns - MARGIN - 1, MOST_WIDTH))
    parts = [picture.title] if picture.title else []
    for panel in picture.panels:
        bars = [item for item in panel.items if isinstance(item, Bars)]
        if bars:
            parts += [_bars(panel, item, system, width) for item in bars]
        else:
            parts.append(_dots(panel, system, width, max(6, min(lines - 6, 14))))
    return "\n".join(parts) + "\n"


def _dots(panel: "Panel", system: str, width: int, height: int) -> str:
    x, y = Scale(panel.x, system), Scale(panel.y, system)
    paths = [path for item in panel.items for path in _paths(item, x, y)]
    if x.logarithmic:
        paths = [[(_log(a), b) for a, b in path] for path in paths]
    if y.logarithmic:
        paths = [[(a, _log(b)) for a, b in path] for path in paths]
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
    names = [item.label for item in panel.items if isinstance(item, Curve) and item.label]
    head = panel.title or ", ".join(names)
    ends = [_back(end, x.logarithmic) for end in (left, right)]
    sides = [_back(end, y.logarithmic) for end in (high, low)]
    rows = canvas.rows()
    texts = [sides[0], *[""] * (len(rows) - 2), sides[1]]
    body = [f"{text:>{MARGIN - 1}} {row}".rstrip() for text, row in zip(texts, rows, strict=True)]
    foot = f"{'':{MARGIN}}{ends[0]}{ends[1]:>{max(1, width - len(ends[0]))}}"
    return "\n".join([f"{y.label}{': ' + head if head else ''}", *body, foot, f"{'':{MARGIN}}{x.label}"])


def _log(value: float) -> float:
    return math.log10(value) if value > 0.0 else math.nan


def _back(value: float, logarithmic: bool) -> str:
    return number(10.0**value if logarithmic else value, 4)


def _paths(item: object, x: Scale, y: Scale) -> "list[list[Point]]":
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

    def path(self, points: "list[Point]") -> None:
        """A line through points; what is not finite breaks it."""
        before: Point | None = None
        for a, b in points:
            if not (a - a == 0.0 and b - b == 0.0):
                before = None
                continue
            here = ((a - self.left) * self.per_x, (b - self.low) * self.per_y)
            start = before or here
            steps = max(1, math.ceil(max(abs(here[0] - start[0]), abs(here[1] - start[1]))))
            for step in range(steps + 1):
                t = step / steps
                self._dot(round(start[0] + t * (here[0] - start[0])), round(start[1] + t * (here[1] - start[1])))
            before = here

    def _dot(self, column: int, row: int) -> None:
        if 0 <= column < self.wide and 0 <= row < self.high:
            line = self.high - 1 - row
            self.cells[line // 4][column // 2] |= _DOTS[line % 4][column % 2]

    def rows(self) -> "list[str]":
        """The lines of text."""
        return ["".join(chr(_BRAILLE + cell) if cell else " " for cell in row) for row in self.cells]


def _bars(panel: "Panel", item: Bars, system: str, width: int) -> str:
    x = Scale(panel.x, system)
    low, high = x(item.low), x(item.high)
    if x.logarithmic:
        low, high = [_log(end) for end in low], [_log(end) for end in high]
    least, most = min(low), max(high)
    per = (width - 1) / ((most - least) or 1.0)
    names = max(len(name) for name in item.names)
    lines = [f"{x.label}{': ' + panel.title if panel.title else ''}"]
    for name, start, end in zip(item.names, low, high, strict=True):
        before = round((start - least) * per)
        lines.append(f"{name:>{names}} {' ' * before}{'█' * max(1, round((end - start) * per))}")
    ends = _back(least, x.logarithmic), _back(most, x.logarithmic)
    lines.append(f"{'':{names + 1}}{ends[0]}{ends[1]:>{max(1, width - len(ends[0]))}}")
    return "\n".join(lines)
