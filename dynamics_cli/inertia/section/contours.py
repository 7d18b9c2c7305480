"""Contours of a section in integers: all numbers, typed or given as doubles, have a common denominator."""

from fractions import Fraction
from itertools import chain
from math import lcm

from dynamics_cli.errors import require
from dynamics_cli.inertia.section.profiles import Bar, exact, outlines
from dynamics_cli.quantities import Annotated, SectionCoordinate, SectionSize
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import TypeAlias

    from dynamics_cli.inertia.section.profiles import Corner, Outline

    Point: TypeAlias = tuple[int, int]

MOST_CORNERS = 20_000
NOTHING = Fraction(0)


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
    shapes: list[tuple[str, Outline]] = []
    if polygon:
        shapes.append(("the polygon", (1, _corners("the polygon", polygon), NOTHING, None)))
    shapes += [(f"piece {index}", _outline(f"piece {index}", 1, item)) for index, item in enumerate(pieces, 1)]
    shapes += [(f"hole {index}", _outline(f"hole {index}", -1, item)) for index, item in enumerate(holes, 1)]
    for index, item in enumerate(bars if isinstance(bars, tuple) else (bars,), 1):
        shapes += [(f"bar {index}", outline) for outline in outlines(item)]
    require(
        any(sign > 0 for _, (sign, *_) in shapes),
        "there is no material",
        code="missing",
        hint="give a profile, a polygon or a piece",
    )
    numbers = {number for _, (_, corners, size, _) in shapes for number in (*chain(*corners), size / 2)}
    unit = lcm(*(number.denominator for number in numbers))
    out = []
    for name, (sign, corners, size, way) in shapes:
        whole = [(_multiple(x, unit), _multiple(y, unit)) for x, y in corners]
        if len(whole) > 1 and whole[0] == whole[-1]:
            whole.pop()
        require(
            size > 0 or len(whole) >= 3,
            "{name} needs at least 3 corners; it has {count}",
            code="polygon",
            name=name,
            count=len(whole),
        )
        require(
            len(whole) <= MOST_CORNERS,
            "{name} has {count} corners; the limit is {most}",
            name=name,
            count=len(whole),
            most=MOST_CORNERS,
        )
        out.append(Contour(name, sign, whole, _multiple(size, unit), way))
    return out, unit


def _multiple(number: Fraction, unit: int) -> int:
    return number.numerator * (unit // number.denominator)


def _corners(name: str, polygon: "tuple[float, ...]") -> "list[Corner]":
    require(len(polygon) % 2 == 0, "{name} has an odd number of coordinates", code="polygon", name=name)
    numbers = list(map(exact, polygon))
    return list(zip(numbers[0::2], numbers[1::2], strict=True))


def _outline(name: str, sign: int, item: "Piece | Hole") -> "Outline":
    """A contour's sign, its corners or its centre, and its diameter, in metres."""
    kinds = [bool(item.polygon), item.diameter is not None, item.width is not None or item.height is not None]
    require(
        sum(kinds) == 1,
        "{name} needs a polygon, or a diameter, or a width and a height",
        code="exclusive" if sum(kinds) else "missing",
        name=name,
    )
    if item.polygon:
        return sign, _corners(name, item.polygon), NOTHING, None
    x, y = exact(item.x), exact(item.y)
    if item.diameter is not None:
        require(item.diameter > 0.0, "{name} has no diameter", code="size", name=name)
        return sign, [(x, y)], exact(item.diameter), None
    require(
        item.width is not None and item.height is not None,
        "{name} needs a width and a height",
        code="missing",
        name=name,
    )
    a, b = exact(item.width or 0.0) / 2, exact(item.height or 0.0) / 2
    require(a > 0 and b > 0, "{name} has no area", code="size", name=name)
    return sign, [(x - a, y - b), (x + a, y - b), (x + a, y + b), (x - a, y + b)], NOTHING, None
