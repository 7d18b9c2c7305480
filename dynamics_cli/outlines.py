"""Shapes as data: outlines of ordered pieces that share their end points to the bit, and the deviation proved for them.

Physics gives lengths in metres, x to the right and y up; writers in `core/drawing` turn them into files. Pieces say
nothing that two readers could take differently: an arc is its end points and its bulge, so that its ends are exact.
"""

from math import atan2, hypot, isfinite, tan

from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeAlias

    Pair: TypeAlias = tuple[float, float]
    Piece: TypeAlias = "Line | Arc | Cubic | Points"

# Ends of an arc this far apart in their distance from its centre, relatively, are a mistake and not rounding.
SAME_RADIUS = 1e-6


@record
class Line:
    """A straight piece."""

    start: "Pair"
    end: "Pair"

    def __post_init__(self) -> None:
        _settle(self, "start", "end")


@record
class Arc:
    """An arc of a circle by its end points and its bulge, the tangent of a quarter of its angle.

    A positive bulge turns anticlockwise, 1 is a half circle and 0 a straight piece. A full circle is two arcs.
    """

    start: "Pair"
    end: "Pair"
    bulge: float

    def __post_init__(self) -> None:
        _settle(self, "start", "end")
        self.__dict__["bulge"] = _number(self.bulge)

    @property
    def radius(self) -> float:
        """The radius; infinite for a straight piece."""
        if not self.bulge:
            return float("inf")
        return 0.25 * _chord(self) * (1.0 / abs(self.bulge) + abs(self.bulge))

    @property
    def centre(self) -> "Pair":
        """The centre of an arc that is not straight."""
        (x0, y0), (x1, y1) = self.start, self.end
        away = 0.25 * (1.0 / self.bulge - self.bulge)
        return x0 + 0.5 * (x1 - x0) - away * (y1 - y0), y0 + 0.5 * (y1 - y0) + away * (x1 - x0)


@record
class Cubic:
    """A cubic Bézier curve."""

    start: "Pair"
    control1: "Pair"
    control2: "Pair"
    end: "Pair"

    def __post_init__(self) -> None:
        _settle(self, "start", "control1", "control2", "end")


@record
class Points:
    """Straight from each point to the next; from arrays, `Points(tuple(zip(x.tolist(), y.tolist())))`."""

    points: "tuple[Pair, ...]"

    def __post_init__(self) -> None:
        if len(self.points) < 2:
            raise ValueError("a piece has two points at least")
        self.__dict__["points"] = tuple(map(_pair, self.points))

    @property
    def start(self) -> "Pair":
        """The first point."""
        return self.points[0]

    @property
    def end(self) -> "Pair":
        """The last point."""
        return self.points[-1]


@record
class Outline:
    """Pieces in order, each beginning where the one before ends, to the bit.

    `deviation` bounds, by proof and not by sampling, how far the pieces are from the exact curve, in metres. The name
    becomes a layer of the file; outlines of one name share it.
    """

    pieces: "tuple[Piece, ...]"
    closed: bool
    deviation: float
    name: str = ""

    # Tells the specification what this is without an import.
    is_drawing = True

    def __post_init__(self) -> None:
        own = self.__dict__
        own["pieces"] = pieces = tuple(self.pieces)
        own["deviation"] = deviation = _number(self.deviation)
        if not pieces:
            raise ValueError("an outline has one piece at least")
        for index in range(1, len(pieces)):
            if pieces[index].start != pieces[index - 1].end:
                raise ValueError(
                    f"piece {index} of {self.name or 'an outline'} starts at {pieces[index].start}, "
                    f"but the piece before ends at {pieces[index - 1].end}"
                )
        if self.closed and pieces[-1].end != pieces[0].start:
            raise ValueError(
                f"{self.name or 'an outline'} is closed, but starts at {pieces[0].start} and ends at {pieces[-1].end}"
            )
        if deviation < 0.0:
            raise ValueError(f"a deviation is a bound of a distance, not {deviation}")
        _one_line(self.name)


@record
class Drawing:
    """Outlines that belong together, under a title; `construction` holds lines that are no edge of the part.

    Centre lines and pitch circles are construction lines: files draw them dash-dotted on layers of their own.
    """

    outlines: "tuple[Outline, ...]"
    title: str = ""
    construction: "tuple[Outline, ...]" = ()

    is_drawing = True

    def __post_init__(self) -> None:
        self.__dict__["outlines"] = tuple(self.outlines)
        if not self.outlines:
            raise ValueError("a drawing has one outline at least")
        _one_line(self.title)

    @property
    def deviation(self) -> float:
        """The greatest deviation of its outlines."""
        return max(outline.deviation for outline in self.outlines)


def arc_about(start: "Pair", end: "Pair", centre: "Pair", *, clockwise: bool) -> Arc:
    """Give the arc from `start` to `end` that turns about `centre`.

    The end points stay as they are; the bulge is exact to a few roundings where both are equally far from the centre.
    """
    start, end, centre = _pair(start), _pair(end), _pair(centre)
    ax, ay = start[0] - centre[0], start[1] - centre[1]
    bx, by = end[0] - centre[0], end[1] - centre[1]
    # the cross product by the chord keeps its digits where the arc is short
    quarter = 0.25 * atan2(ax * (end[1] - start[1]) - ay * (end[0] - start[0]), ax * bx + ay * by)
    radius = hypot(ax, ay)
    if not quarter or abs(hypot(bx, by) - radius) > SAME_RADIUS * radius:
        raise ValueError(f"no arc about {centre} joins {start} and {end}: a full circle is two arcs")
    return Arc(start, end, tan(quarter) if (quarter < 0.0) == clockwise else -1.0 / tan(quarter))


def circle(centre: "Pair", radius: float, *, clockwise: bool = False) -> "tuple[Arc, Arc]":
    """Give a full circle as its two halves, right end first."""
    (x, y), bulge = _pair(centre), -1.0 if clockwise else 1.0
    right, left = (x + radius, y), (x - radius, y)
    return Arc(right, left, bulge), Arc(left, right, bulge)


def _chord(piece: Arc) -> float:
    return hypot(piece.end[0] - piece.start[0], piece.end[1] - piece.start[1])


def _settle(piece: "Any", *names: str) -> None:
    for name in names:
        piece.__dict__[name] = _pair(getattr(piece, name))


def _pair(point: "Any") -> "Pair":
    x, y = point
    return _number(x), _number(y)


def _number(number: "Any") -> float:
    """A plain double, whatever number physics gave; minus zero is zero, so that equal means equal to the bit."""
    plain = float(getattr(number, "value", number)) + 0.0
    if not isfinite(plain):
        raise OverflowError("a coordinate of the outline is not finite")
    return plain


def _one_line(text: str) -> None:
    if not text.isprintable():
        raise ValueError(f"{text!r} is not one line of text")
