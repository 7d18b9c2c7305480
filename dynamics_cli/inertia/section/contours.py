"""Contours of a section in integers: all numbers, typed or given as doubles, have a common denominator."""

from math import lcm

from dynamics_cli.errors import require
from dynamics_cli.inertia.section.profiles import Bar, outlines
from dynamics_cli.quantities import Annotated, SectionCoordinate, SectionSize
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import TypeAlias

    Point: TypeAlias = tuple[int, int]
    Ratio: TypeAlias = tuple[int, int]

MOST_CORNERS = 20_000
NOTHING = (0, 1)


@record
class Hole:
    """A hole: a polygon, or a circle or a rectangle about (x, y)."""

    polygon: Annotated[
        tuple[SectionCoordinate, ...], "Its corners x1, y1, x2, y2, … in order, e.g. 0, 0, 60, 0, 60, 40 mm."
    ] = ()
    diameter: Annotated[SectionSize | None, "Diameter of a circle [m]."] = None
    width: Annotated[SectionSize | None, "Width of a rectangle, along x [m]."] = None
    height: Annotated[SectionSize | None, "Height of a rectangle, along y [m]."] = None
    x: Annotated[SectionCoordinate, "Where the centre of the circle or rectangle is [m]."] = 0.0
    y: Annotated[SectionCoordinate, "Where the centre of the circle or rectangle is [m]."] = 0.0


@record
class Piece:
    """A piece of material: a polygon, or a circle or a rectangle about (x, y)."""

    polygon: Annotated[
        tuple[SectionCoordinate, ...], "Its corners x1, y1, x2, y2, … in order, e.g. 0, 0, 60, 0, 60, 40 mm."
    ] = ()
    diameter: Annotated[SectionSize | None, "Diameter of a circle [m]."] = None
    width: Annotated[SectionSize | None, "Width of a rectangle, along x [m]."] = None
    height: Annotated[SectionSize | None, "Height of a rectangle, along y [m]."] = None
    x: Annotated[SectionCoordinate, "Where the centre of the circle or rectangle is [m]."] = 0.0
    y: Annotated[SectionCoordinate, "Where the centre of the circle or rectangle is [m]."] = 0.0


class Contour:
    """A polygon, a circle or the fillet of a corner in whole multiples of a unit; `sign` is −1 for a hole.

    A circle has its centre as its only corner and a diameter; a fillet the corner that it fills, a radius, and the
    way from the corner into the open (±1, ±1).
    """

    __slots__ = ("corners", "diameter", "name", "radius", "sign", "way")

    def __init__(
        self, name: str, sign: int, corners: "list[Point]", size: int = 0, way: "tuple[int, int] | None" = None
    ) -> None:
        self.name = name
        self.sign = sign
        self.corners = corners
        self.way = way
        self.diameter = 0 if way else size
        self.radius = size if way else 0

    def sides(self) -> "Iterator[tuple[Point, Point]]":
        """The sides of a polygon."""
        if not (self.diameter or self.way):
            yield from zip(self.corners, [*self.corners[1:], self.corners[0]], strict=True)


def contours(
    polygon: "tuple[float, ...]",
    pieces: "tuple[Piece, ...]",
    holes: "tuple[Hole, ...]",
    bars: "Bar | tuple[Bar, ...]" = (),
) -> "tuple[list[Contour], int]":
    """Every contour in a common unit, and the number of these units in a metre."""
    shapes: list[tuple[str, int, list[tuple[Ratio, ...]], Ratio]] = []
    ways: dict[int, tuple[int, int]] = {}
    if polygon:
        require(len(polygon) % 2 == 0, "the polygon has an odd number of coordinates", code="polygon")
        shapes.append(("the polygon", 1, [(part.as_integer_ratio(),) for part in polygon], NOTHING))
    shapes += [_shape(f"piece {index}", 1, item) for index, item in enumerate(pieces, 1)]
    shapes += [_shape(f"hole {index}", -1, item) for index, item in enumerate(holes, 1)]
    for index, item in enumerate(bars if isinstance(bars, tuple) else (bars,), 1):
        for sign, points, size, way in outlines(item):
            if way:
                ways[len(shapes)] = way
            parts: list[tuple[Ratio, ...]] = [(number.as_integer_ratio(),) for point in points for number in point]
            shapes.append((f"bar {index}", sign, parts, size.as_integer_ratio()))
    require(
        any(sign > 0 for _, sign, _, _ in shapes),
        "there is no material",
        code="missing",
        hint="give a profile, a polygon or a piece",
    )
    unit = lcm(
        *(part[1] for _, _, numbers, diameter in shapes for number in (*numbers, (_half(diameter),)) for part in number)
    )
    out = []
    for place, (name, sign, numbers, diameter) in enumerate(shapes):
        multiples = [sum(up * (unit // down) for up, down in number) for number in numbers]
        corners = list(zip(multiples[0::2], multiples[1::2], strict=True))
        round_ = diameter != NOTHING
        if not round_ and len(corners) > 1 and corners[0] == corners[-1]:
            corners.pop()
        require(
            round_ or len(corners) >= 3,
            "{name} needs at least 3 corners; it has {count}",
            code="polygon",
            name=name,
            count=len(corners),
        )
        require(
            len(corners) <= MOST_CORNERS,
            "{name} has {count} corners; the limit is {most}",
            name=name,
            count=len(corners),
            most=MOST_CORNERS,
        )
        out.append(Contour(name, sign, corners, diameter[0] * (unit // diameter[1]), ways.get(place)))
    return out, unit


def _shape(name: str, sign: int, item: "Piece | Hole") -> "tuple[str, int, list[tuple[Ratio, ...]], Ratio]":
    """A contour's name, sign, coordinates (each an exact sum) and diameter, in metres."""
    kinds = [bool(item.polygon), item.diameter is not None, item.width is not None or item.height is not None]
    require(
        sum(kinds) == 1,
        "{name} needs a polygon, or a diameter, or a width and a height",
        code="exclusive" if sum(kinds) else "missing",
        name=name,
    )
    if item.polygon:
        require(len(item.polygon) % 2 == 0, "{name} has an odd number of coordinates", code="polygon", name=name)
        return name, sign, [(part.as_integer_ratio(),) for part in item.polygon], NOTHING
    if item.diameter is not None:
        require(item.diameter > 0.0, "{name} has no diameter", code="size", name=name)
        return (
            name,
            sign,
            [(item.x.as_integer_ratio(),), (item.y.as_integer_ratio(),)],
            item.diameter.as_integer_ratio(),
        )
    require(
        item.width is not None and item.height is not None,
        "{name} needs a width and a height",
        code="missing",
        name=name,
    )
    assert item.width is not None
    assert item.height is not None
    require(item.width > 0.0 and item.height > 0.0, "{name} has no area", code="size", name=name)
    low_x, high_x = _ends(item.x.as_integer_ratio(), item.width.as_integer_ratio())
    low, high = _ends(item.y.as_integer_ratio(), item.height.as_integer_ratio())
    return name, sign, [low_x, low, high_x, low, high_x, high, low_x, high], NOTHING


def _half(number: "Ratio") -> "Ratio":
    return number[0], 2 * number[1]


def _ends(middle: "Ratio", width: "Ratio") -> "tuple[tuple[Ratio, Ratio], tuple[Ratio, Ratio]]":
    """Where a width about a middle begins and ends."""
    up, down = _half(width)
    return (middle, (-up, down)), (middle, (up, down))
