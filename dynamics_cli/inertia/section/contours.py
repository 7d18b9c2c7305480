"""Contours of a section in whole numbers: doubles are whole multiples of a power of two, so nothing is rounded."""

from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated, Coordinate, Size
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import TypeAlias

    Point: TypeAlias = tuple[int, int]

MOST_CORNERS = 20_000


@record
class Hole:
    """A hole: a polygon, or a circle or a rectangle about (x, y)."""

    polygon: Annotated[
        tuple[Coordinate, ...], "Its corners x1, y1, x2, y2, … in order, e.g. 0, 0, 60, 0, 60, 40 mm."
    ] = ()
    diameter: Annotated[Size | None, "Diameter of a circle [m]."] = None
    width: Annotated[Size | None, "Width of a rectangle, along x [m]."] = None
    height: Annotated[Size | None, "Height of a rectangle, along y [m]."] = None
    x: Annotated[Coordinate, "Where the centre of the circle or rectangle is [m]."] = 0.0
    y: Annotated[Coordinate, "Where the centre of the circle or rectangle is [m]."] = 0.0


@record
class Piece:
    """A piece of material: a polygon, or a circle or a rectangle about (x, y)."""

    polygon: Annotated[
        tuple[Coordinate, ...], "Its corners x1, y1, x2, y2, … in order, e.g. 0, 0, 60, 0, 60, 40 mm."
    ] = ()
    diameter: Annotated[Size | None, "Diameter of a circle [m]."] = None
    width: Annotated[Size | None, "Width of a rectangle, along x [m]."] = None
    height: Annotated[Size | None, "Height of a rectangle, along y [m]."] = None
    x: Annotated[Coordinate, "Where the centre of the circle or rectangle is [m]."] = 0.0
    y: Annotated[Coordinate, "Where the centre of the circle or rectangle is [m]."] = 0.0


class Contour:
    """A polygon or a circle in whole multiples of 2⁻ᵏ metres; `sign` is −1 for a hole.

    A circle has its centre as its only corner and a diameter.
    """

    __slots__ = ("corners", "diameter", "name", "sign")

    def __init__(self, name: str, sign: int, corners: "list[Point]", diameter: int = 0) -> None:
        self.name = name
        self.sign = sign
        self.corners = corners
        self.diameter = diameter

    def sides(self) -> "Iterator[tuple[Point, Point]]":
        """The sides of a polygon."""
        if not self.diameter:
            yield from zip(self.corners, [*self.corners[1:], self.corners[0]], strict=True)


def contours(
    polygon: "tuple[float, ...]", pieces: "tuple[Piece, ...]", holes: "tuple[Hole, ...]"
) -> "tuple[list[Contour], int]":
    """Every contour, and the power k of the unit 2⁻ᵏ m that all their numbers are whole multiples of."""
    made: list[tuple[str, int, list[tuple[float, ...]], float]] = []
    if polygon:
        require(len(polygon) % 2 == 0, "the polygon has an odd number of coordinates", code="polygon")
        made.append(("the polygon", 1, [(part,) for part in polygon], 0.0))
    made += [_shape(f"piece {index}", 1, item) for index, item in enumerate(pieces, 1)]
    made += [_shape(f"hole {index}", -1, item) for index, item in enumerate(holes, 1)]
    require(
        any(sign > 0 for _, sign, _, _ in made),
        "there is no material",
        code="missing",
        hint="give a polygon or a piece",
    )
    power = max(
        _power(part) for _, _, numbers, diameter in made for number in (*numbers, (0.5 * diameter,)) for part in number
    )
    out = []
    for name, sign, numbers, diameter in made:
        whole = [sum(_whole(part, power) for part in number) for number in numbers]
        corners = list(zip(whole[0::2], whole[1::2], strict=True))
        if not diameter and len(corners) > 1 and corners[0] == corners[-1]:
            corners.pop()
        require(
            diameter or len(corners) >= 3,
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
        out.append(Contour(name, sign, corners, _whole(diameter, power)))
    return out, power


def _shape(name: str, sign: int, item: "Piece | Hole") -> "tuple[str, int, list[tuple[float, ...]], float]":
    """A contour's name, sign, coordinates (each an exact sum of doubles) and diameter."""
    given = [bool(item.polygon), item.diameter is not None, item.width is not None or item.height is not None]
    require(
        sum(given) == 1,
        "{name} needs a polygon, or a diameter, or a width and a height",
        code="exclusive" if sum(given) else "missing",
        name=name,
    )
    if item.polygon:
        require(len(item.polygon) % 2 == 0, "{name} has an odd number of coordinates", code="polygon", name=name)
        return name, sign, [(part,) for part in item.polygon], 0.0
    if item.diameter is not None:
        require(item.diameter > 0.0, "{name} has no diameter", code="size", name=name)
        return name, sign, [(item.x,), (item.y,)], item.diameter
    require(
        item.width is not None and item.height is not None,
        "{name} needs a width and a height",
        code="missing",
        name=name,
    )
    assert item.width is not None
    assert item.height is not None
    require(item.width > 0.0 and item.height > 0.0, "{name} has no area", code="size", name=name)
    x, y, a, b = item.x, item.y, 0.5 * item.width, 0.5 * item.height
    left, right, low, high = (x, -a), (x, a), (y, -b), (y, b)
    return name, sign, [left, low, right, low, right, high, left, high], 0.0


def _power(number: float) -> int:
    """The least k for which the number is a whole multiple of 2⁻ᵏ."""
    return number.as_integer_ratio()[1].bit_length() - 1 if number else 0


def _whole(number: float, power: int) -> int:
    up, down = number.as_integer_ratio()
    return up * ((1 << power) // down)
