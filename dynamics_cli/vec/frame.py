"""Right-handed triads of unit vectors, from directions or points that need not be square to one another."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute, atan2
from dynamics_cli.numerics.exact.typed_products import cross, difference, dot, norm, scaled, triple, unit
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, FreeVector, Ratio, RotationMatrix, Text
from dynamics_cli.records import Advice, record
from dynamics_cli.vec import kinds
from dynamics_cli.vec.angles import ROUNDING
from dynamics_cli.vec.products import require_spanning

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.exact.typed_products import Vector

AXES = "xyz"


@record
class Frame:
    """A right-handed triad of unit vectors."""

    x_axis: Annotated[FreeVector, "Its first axis."]
    y_axis: Annotated[FreeVector, "Its second axis."]
    z_axis: Annotated[FreeVector, "Its third axis."]
    kept: Annotated[Text, "Which input kept its direction, and which one its plane."]
    departure: Annotated[Angle, "How far the directions given were from right angles, at most [rad]."]
    handedness: Annotated[Text | None, "Of three directions: right-handed or left-handed."]
    rotation_matrix: Annotated[RotationMatrix, "Its columns are the axes: from the triad outward."]
    components: Annotated[FreeVector | None, "The components of the vector in the triad."]
    advice: tuple[Advice, ...] = ()


def frame(
    *points: Annotated[FreeVector, "Three points: the origin, one on the x-axis, one in the x-y plane."],
    x: Annotated[FreeVector | None, "The direction of the x-axis."] = None,
    y: Annotated[FreeVector | None, "The direction of the y-axis."] = None,
    z: Annotated[FreeVector | None, "The direction of the z-axis."] = None,
    vector: Annotated[FreeVector | None, "A vector to resolve in the triad, e.g. 0, 0, -9.81 m/s^2."] = None,
) -> Frame:
    """Right-handed triad from two or three directions, or from three points.

    The first direction given, in the order x, y, z, is kept; the second keeps its plane with it.

    Equation
    --------
    e₁ = a/|a|, e₃ = (a×b)/|a×b|, e₂ = e₃×e₁, and so in turn; components v·e₁, v·e₂, v·e₃.

    Raises
    ------
    InadmissibleError
        When fewer than two directions are given, one is zero, two are parallel, or three lie in one plane.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 2.11.

    Examples
    --------
    >>> frame(x=(0.0, 2.0, 0.0), y=(-3.0, 1.0, 0.0)).y_axis.value
    (-1.0, 0.0, 0.0)
    """
    directions = _directions(points, x, y, z)
    order = [name for name in AXES if name in directions]
    first, second = order[0], order[1]
    a, b = scaled(directions[first].parts), scaled(directions[second].parts)
    product = cross(a, b)
    sine = plain(norm(product)) / (plain(norm(a)) * plain(norm(b)))
    require(
        sine > ROUNDING,
        "the directions of {first} and {second} are parallel (sine {share:2})",
        first=first,
        second=second,
        share=(sine, Ratio),
        code="parallel",
        hint="give two directions that are not parallel",
    )
    i, j = AXES.index(first), AXES.index(second)
    first_axis = unit(a)
    forward = (j - i) % 3 == 1
    last = unit(product if forward else (-product[0], -product[1], -product[2]))
    turned = cross(last, first_axis) if forward else cross(first_axis, last)
    axes: dict[int, Vector] = {i: first_axis, j: unit(turned), 3 - i - j: last}
    rows = (axes[0], axes[1], axes[2])
    handedness, advice = _handedness(directions)
    components = None
    if vector is not None:
        seen = kinds.Vector(vector)
        components = kinds.vector([dot(seen.parts, row) for row in rows], seen.kind)
    return Frame(
        x_axis=kinds.direction(rows[0]),
        y_axis=kinds.direction(rows[1]),
        z_axis=kinds.direction(rows[2]),
        kept=f"{first} kept its direction, {second} its plane with {first}",
        departure=_departure(directions, order),
        handedness=handedness,
        rotation_matrix=tuple(zip(*rows, strict=True)),  # type: ignore[arg-type]
        components=components,
        advice=advice,
    )


def _directions(points: "tuple[Any, ...]", x: "Any", y: "Any", z: "Any") -> "dict[str, kinds.Vector]":
    named = zip(AXES, (x, y, z), strict=True)
    directions = {name: kinds.Vector(axis, f"the direction of {name}") for name, axis in named if axis is not None}
    if points:
        require(
            len(points) == 3 and not directions,
            "a triad needs three points, or two or three directions; {points} points and {given} directions are given",
            points=str(len(points)),
            given=str(len(directions)),
            code="points",
            hint="give origin, a point on the x-axis and a point in the x-y plane, without --x, --y, --z",
        )
        placed = kinds.vectors(points, ("the origin", "the second point", "the third point"))
        kinds.require_same_kind(placed, "points of different kinds")
        for name, direction in zip("xy", placed[1:], strict=True):
            direction.parts = difference(direction.parts, placed[0].parts)
            directions[name] = direction
    require(
        len(directions) > 1,
        "a triad needs two directions, {count} given",
        count=str(len(directions)),
        code="directions",
        hint='for example --x "1, 2, 0" --y "0, 1, 0"',
    )
    for name, direction in directions.items():
        kinds.require_direction(direction, f"the direction of {name}")
    return directions


def _departure(directions: "dict[str, kinds.Vector]", order: "list[str]") -> float:
    """The largest departure of two directions from a right angle, small ones exactly."""
    pairs = [(first, second) for n, first in enumerate(order) for second in order[n + 1 :]]
    off = []
    for first, second in pairs:
        a, b = scaled(directions[first].parts), scaled(directions[second].parts)
        off.append(absolute(atan2(dot(a, b), norm(cross(a, b)))))
    return max(off, key=plain)


def _handedness(directions: "dict[str, kinds.Vector]") -> "tuple[str | None, tuple[Advice, ...]]":
    if len(directions) < 3:
        return None, ()
    triad = (directions["x"], directions["y"], directions["z"])
    value = plain(triple(*(scaled(direction.parts) for direction in triad)))
    for direction in triad:
        direction.parts = scaled(direction.parts)
    require_spanning(triad, value)
    if value > 0.0:
        return "right-handed", ()
    message = worded("the three directions are left-handed: the z-axis of the triad is opposite to the given one")
    return "left-handed", (Advice("left-handed", message, remedy="exchange two of them, or reverse one"),)
