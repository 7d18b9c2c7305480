"""Points, lines and planes: distances, feet of the common perpendicular, intersections, angles."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute, atan2
from dynamics_cli.numerics.exact.typed_products import cross, difference, dot, norm, sum_of_products
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, FreeNumber, FreeVector, Ratio, Text
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.vec import kinds
from dynamics_cli.vec.angles import ROUNDING

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.exact.typed_products import Vector

NEARLY = 1e-6
FEET = 1e-9


@record
class Item:
    """A point; with a direction or a second point a line, with a normal or two more points a plane."""

    point: Annotated[FreeVector, "The point, or a point on the line or plane, e.g. 1, 2, 3 m."]
    direction: Annotated[FreeVector | None, "The direction of a line, e.g. 1, 1, 1."] = None
    to: Annotated[FreeVector | None, "A second point of a line or a plane, e.g. 4, 0, 1 m."] = None
    normal: Annotated[FreeVector | None, "The normal of a plane, e.g. 0, 0, 1."] = None
    third: Annotated[FreeVector | None, "A third point of a plane, beside `to`, e.g. 0, 5, 1 m."] = None


@record
class Lines:
    """How two points, lines or planes lie to one another."""

    relation: Annotated[Text, "Skew, intersecting, parallel, coincident or apart, and how that is known."]
    distance: Annotated[FreeNumber, "The shortest distance."]
    angle: Annotated[Angle | None, "The angle between them, from 0 to 90 degrees [rad]."]
    first_foot: Annotated[FreeVector | None, "Foot of the shortest connection on the first."]
    second_foot: Annotated[FreeVector | None, "Foot on the second."]
    intersection: Annotated[FreeVector | None, "Where they meet: a point, or a point of two planes' common line."]
    common_direction: Annotated[FreeVector | None, "Direction of the two planes' common line."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


class _Read:
    """An item as read: its shape, a point of it, and its direction or normal."""

    __slots__ = ("kind", "point", "shape", "way")

    def __init__(self, item: Item, name: str) -> None:
        point = kinds.Vector(item.point, f"the point of the {name}")
        forms = [word for word in ("direction", "to", "normal") if getattr(item, word) is not None]
        require(
            len(forms) < 2,
            "the {name} has {given}: a line has a direction or a second point, a plane a normal",
            name=name,
            given=" and ".join(forms),
            code="shape",
            hint="give one of them",
        )
        self.point = point.parts
        self.kind = point.kind
        self.shape = "point"
        self.way: Vector = (0.0, 0.0, 0.0)
        require(
            item.third is None or forms == ["to"],
            "the {name} has a third point and no second one",
            name=name,
            code="shape",
            hint="a plane is given by its point, `to` and `third`",
        )
        if forms:
            self.shape = "plane" if forms[0] == "normal" or item.third is not None else "line"
            vector = kinds.Vector(getattr(item, forms[0]), f"the {forms[0]} of the {name}")
            if forms[0] == "to":
                kinds.require_same_kind((point, vector), f"the two points of the {name} are of different kinds")
                vector.parts = difference(vector.parts, point.parts)
            if item.third is not None:
                third = kinds.Vector(item.third, f"the third point of the {name}")
                kinds.require_same_kind((point, third), f"the points of the {name} are of different kinds")
                vector.parts = cross(vector.parts, difference(third.parts, point.parts))
                require(
                    not vector.is_zero,
                    "the three points of the {name} lie on one line",
                    name=name,
                    code="zero-vector",
                    hint="a plane needs three points that do not",
                )
            role = "direction" if self.shape == "line" else "normal"
            kinds.require_direction(vector, f"the {role} of the {name}")
            self.way = vector.parts


def lines(*, first: Item, second: Item) -> Lines:
    """Distance, angle, feet of the common perpendicular and intersection of two points, lines or planes.

    Equation
    --------
    Skew lines: d = |(q − p)·(u×v)|/|u×v|; parallel: |(q − p)×u|/|u|; from a plane: |n·(q − p)|/|n|.

    Raises
    ------
    InadmissibleError
        When a direction or a normal is zero, or points are of different kinds.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 2.7 and 2.8.

    Examples
    --------
    >>> x_axis, other = Item((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)), Item((0.0, 2.0, 3.0), (0.0, 1.0, 0.0))
    >>> lines(first=x_axis, second=other).distance.value
    3.0
    """
    left, right = _Read(first, "first"), _Read(second, "second")
    message = "the points are of different kinds: {first} and {other}"
    kinds.require_one_kind(left.kind, right.kind, message, "give both points in units of length, or both without units")
    order = ("point", "line", "plane")
    swapped = order.index(left.shape) > order.index(right.shape)
    a, b = (right, left) if swapped else (left, right)
    pose = _CASES[a.shape, b.shape](a, b)
    feet = pose.pop("feet", (None, None))
    if swapped:
        feet = feet[::-1]

    def point(parts: "Vector | None") -> "Any":
        return None if parts is None else kinds.vector(parts, left.kind)

    distance = pose["distance"]
    return Lines(
        relation=pose["relation"],
        distance=kinds.number(distance, left.kind),
        angle=pose.get("angle"),
        first_foot=point(feet[0]),
        second_foot=point(feet[1]),
        intersection=point(pose.get("meet")),
        common_direction=kinds.direction(pose["common"]) if "common" in pose else None,
        checks=_feet_apart(feet, distance, left.point, right.point) if feet[0] is not None else (),
        advice=_nearly_parallel(pose),
    )


def _moved(p: "Vector", factor: float, u: "Vector") -> "Vector":
    x, y, z = (sum_of_products((start,), (factor, step)) for start, step in zip(p, u, strict=True))
    return x, y, z


def _apart(p: "Vector", q: "Vector", n: "Vector") -> float:
    """(q − p)·n, from the points as typed."""
    return sum_of_products(*((q[i], n[i]) for i in range(3)), *((-1.0, p[i], n[i]) for i in range(3)))


def _is_small(value: float, size: float) -> bool:
    return abs(plain(value)) <= ROUNDING * size


def _two_points(a: _Read, b: _Read) -> "dict[str, Any]":
    distance = norm(difference(b.point, a.point))
    relation = "apart" if plain(distance) else "one point"
    return {"distance": distance, "relation": relation, "feet": (a.point, b.point)}


def _point_and_line(a: _Read, b: _Read) -> "dict[str, Any]":
    gap = difference(a.point, b.point)
    distance = norm(cross(gap, b.way)) / norm(b.way)
    foot = _moved(b.point, dot(gap, b.way) / dot(b.way, b.way), b.way)
    relation = _touch("the point is on the line", distance) if _incident(distance, a, b) else "apart"
    return {"distance": distance, "relation": relation, "feet": (a.point, foot)}


def _point_and_plane(a: _Read, b: _Read) -> "dict[str, Any]":
    height = _apart(b.point, a.point, b.way) / norm(b.way)
    foot = _moved(a.point, -height / norm(b.way), b.way)
    side = "on the side of the normal" if plain(height) > 0.0 else "on the side away from the normal"
    relation = _touch("the point is in the plane", height) if _incident(height, a, b) else f"apart, {side}"
    return {"distance": absolute(height), "relation": relation, "feet": (a.point, foot)}


def _incident(distance: float, a: _Read, b: _Read) -> bool:
    """Whether a distance is none, beside those of the points from the origin."""
    return _is_small(distance, plain(norm(a.point)) + plain(norm(b.point)))


def _parallel(distance: float, off: float, a: _Read, b: _Read, within: str) -> str:
    """Parallel, or one within the other, and how that is known."""
    return _touch(within, distance) if _incident(distance, a, b) else _touch("parallel", off)


def _touch(words: str, value: float) -> str:
    return f"{words}, exactly as typed" if plain(value) == 0.0 else f"{words}, within rounding"


def _two_lines(a: _Read, b: _Read) -> "dict[str, Any]":
    u, v = a.way, b.way
    product = cross(u, v)
    sine = norm(product)
    size = plain(norm(u)) * plain(norm(v))
    angle = atan2(sine, absolute(dot(u, v)))
    gap = difference(b.point, a.point)
    if _is_small(sine, size):
        distance = norm(cross(gap, u)) / norm(u)
        foot = _moved(b.point, -dot(gap, v) / dot(v, v), v)
        relation = _parallel(distance, sine, a, b, "coincident")
        return {"distance": distance, "relation": relation, "angle": angle, "feet": (a.point, foot)}
    volume = _apart(a.point, b.point, product)
    distance = absolute(volume) / sine
    square = dot(product, product)
    s = dot(cross(gap, v), product) / square
    t = dot(cross(gap, u), product) / square
    feet = _moved(a.point, s, u), _moved(b.point, t, v)
    meet = _incident(distance, a, b)
    pose = {"distance": distance, "angle": angle, "feet": feet, "sine": plain(sine) / size}
    return {**pose, "relation": _touch("intersecting", distance), "meet": feet[0]} if meet else {
        **pose, "relation": "skew"}  # fmt: skip


def _line_and_plane(a: _Read, b: _Read) -> "dict[str, Any]":
    u, n = a.way, b.way
    along = dot(u, n)
    size = plain(norm(u)) * plain(norm(n))
    angle = atan2(absolute(along), norm(cross(u, n)))
    height = _apart(b.point, a.point, n)
    if _is_small(along, size):
        distance = absolute(height) / norm(n)
        foot = _moved(a.point, -height / dot(n, n), n)
        relation = _parallel(distance, along, a, b, "the line is in the plane")
        return {"distance": distance, "relation": relation, "angle": angle, "feet": (a.point, foot)}
    meet = _moved(a.point, -height / along, u)
    pose = {"distance": 0.0 * height, "relation": "intersecting", "angle": angle, "meet": meet}
    return {**pose, "sine": abs(plain(along)) / size}


def _two_planes(a: _Read, b: _Read) -> "dict[str, Any]":
    m, n = a.way, b.way
    product = cross(m, n)
    sine = norm(product)
    size = plain(norm(m)) * plain(norm(n))
    angle = atan2(sine, absolute(dot(m, n)))
    height = _apart(b.point, a.point, n)
    if _is_small(sine, size):
        distance = absolute(height) / norm(n)
        return {"distance": distance, "relation": _parallel(distance, sine, a, b, "coincident"), "angle": angle}
    # within the first plane, square to the common line, down to the second plane
    direction = cross(product, m)
    meet = _moved(a.point, -height / dot(direction, n), direction)
    common = tuple(part / sine for part in product)
    pose = {"distance": 0.0 * height, "relation": "intersecting in a line", "angle": angle, "meet": meet}
    return {**pose, "common": common, "sine": plain(sine) / size}


_CASES: "dict[tuple[str, str], Any]" = {
    ("point", "point"): _two_points,
    ("point", "line"): _point_and_line,
    ("point", "plane"): _point_and_plane,
    ("line", "line"): _two_lines,
    ("line", "plane"): _line_and_plane,
    ("plane", "plane"): _two_planes,
}


def _nearly_parallel(pose: "dict[str, Any]") -> "tuple[Advice, ...]":
    sine = pose.get("sine")
    if sine is None or sine > NEARLY:
        return ()
    message = worded("the two are nearly parallel (sine {sine:2}): the point where they meet or come "
                     "nearest magnifies errors {times:2}", sine=(sine, Ratio), times=(1.0 / sine, Ratio))  # fmt: skip
    return (Advice("near-parallel", message, remedy="rely on the distance and the angle rather than on the points"),)


def _feet_apart(feet: "Any", distance: float, p: "Vector", q: "Vector") -> "tuple[Check, ...]":
    first, second = ([plain(x) for x in foot] for foot in feet)
    apart = sum((a - b) ** 2 for a, b in zip(first, second, strict=True)) ** 0.5
    size = max(map(abs, [*first, *second, *map(plain, p), *map(plain, q)])) or 1.0
    off = abs(apart - plain(distance)) / size
    return (Check("the feet are that distance apart", off <= FEET, off, FEET),)
