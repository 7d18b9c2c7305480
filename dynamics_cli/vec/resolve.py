"""A vector resolved along and across a direction or a plane, or along the directions of a basis."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import atan2
from dynamics_cli.numerics.exact.typed_products import cross, dot, norm, sum_of_products, triple
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, FreeNumber, FreeVector, Ratio
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.vec import kinds
from dynamics_cli.vec.angles import ROUNDING
from dynamics_cli.vec.products import require_spanning

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.exact.typed_products import Vector

ILL_CONDITIONED = 1e6
REASSEMBLED = 1e-12


@record
class Along:
    """A direction."""

    along: Annotated[FreeVector, "The direction to resolve along, e.g. 1, 2, 2."]


@record
class Plane:
    """A plane."""

    normal: Annotated[FreeVector, "The normal of the plane to resolve in, e.g. 0, 0, 1."]


@record
class Basis:
    """Two or three directions."""

    first: Annotated[FreeVector, "First direction of two in a plane or three in space, e.g. 3, 0, 4."]
    second: Annotated[FreeVector, "Second direction, e.g. -3, 2, 4."]
    third: Annotated[FreeVector | None, "Third direction, in space, e.g. 0, -2, 4."] = None


@record
class Oblique:
    """Component of a vector along one direction of a basis."""

    direction: Annotated[FreeVector, "The direction as given."]
    coefficient: Annotated[FreeNumber, "Multiple of the direction as given."]
    component: Annotated[FreeNumber, "Signed length of that part of the vector."]
    part: Annotated[FreeVector, "That part of the vector."]
    reciprocal: Annotated[FreeVector, "The vector of the reciprocal basis."]


@record
class Resolved:
    """A vector in its parts."""

    component: Annotated[FreeNumber | None, "The component along the direction, with its sign."] = None
    across: Annotated[FreeNumber | None, "Magnitude of the part across it."] = None
    angle: Annotated[Angle | None, "The angle between the vector and the direction, or the plane [rad]."] = None
    part_along: Annotated[FreeVector | None, "The part along the direction."] = None
    part_across: Annotated[FreeVector | None, "The part across it."] = None
    in_plane: Annotated[FreeNumber | None, "The magnitude of the part in the plane."] = None
    out_of_plane: Annotated[FreeNumber | None, "The component along the normal, with its sign."] = None
    part_in_plane: Annotated[FreeVector | None, "The part in the plane."] = None
    part_out_of_plane: Annotated[FreeVector | None, "The part along its normal."] = None
    condition: Annotated[Ratio | None, "How many times a relative change of the vector may appear in a part [-]."] = (
        None
    )
    components: Annotated[tuple[Oblique, ...] | None, "The parts along the directions of the basis."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


_ALONG = ("component", "across", "part_along", "part_across")
_IN_PLANE = ("out_of_plane", "in_plane", "part_out_of_plane", "part_in_plane")


def resolve(
    vector: Annotated[FreeVector, 'The vector, such as "100 N @ 30 deg" or "3, 4, 5 m/s".'],
    /,
    *,
    onto: Along | Plane | Basis,
) -> Resolved:
    """Components of a vector along and across a direction or a plane, or along two or three directions.

    Equation
    --------
    Along n: (v·n)n/n², across: n×(v×n)/n²; in a basis: (v·(b₂×b₃))/(b₁·(b₂×b₃)) and so on in turn.

    Raises
    ------
    InadmissibleError
        When the direction is zero, or the directions of a basis lie in one plane or on one line.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 2.4 and 2.11.

    Examples
    --------
    >>> resolve((3.0, 4.0, 0.0), onto=Along((1.0, 0.0, 0.0))).across.value
    4.0
    """
    resolved = kinds.Vector(vector, "the vector")
    if isinstance(onto, Basis):
        directions = {"first": onto.first, "second": onto.second, "third": onto.third}
        return _in_basis(
            resolved,
            {name: kinds.Vector(b, f"the {name} direction") for name, b in directions.items() if b is not None},
        )
    is_along = isinstance(onto, Along)
    name = "the direction" if is_along else "the normal"
    n = kinds.Vector(onto.along if is_along else onto.normal, name)  # type: ignore[union-attr]
    kinds.require_direction(n, name)
    planar = resolved.planar and n.planar
    length = norm(n.parts)
    component = dot(resolved.parts, n.parts) / length
    along = tuple(component * (part / length) for part in n.parts)
    product = cross(resolved.parts, n.parts)
    across = cross(n.parts, product)
    square = dot(n.parts, n.parts)
    rest = tuple(part / square for part in across)
    size = norm(product) / length
    parts = [kinds.vector(part, resolved.kind, planar=planar) for part in (along, rest)]
    numbers = [kinds.number(part, resolved.kind) for part in (component, size)]
    zero = resolved.is_zero
    turn = None if zero else atan2(size, component) if is_along else atan2(component, size)
    named = _ALONG if is_along else _IN_PLANE
    parted: dict[str, Any] = dict(zip(named, (*numbers, *parts), strict=True))
    return Resolved(**parted, angle=turn, checks=(_reassembled(resolved.parts, [along, rest]),))


def _in_basis(vector: kinds.Vector, named: "dict[str, kinds.Vector]") -> Resolved:
    basis = list(named.values())
    for name, direction in named.items():
        kinds.require_direction(direction, f"the {name} direction")
    dual = _reciprocal_plane(vector, basis) if len(basis) == 2 else _reciprocal_space(vector, basis)
    rows = []
    largest = 0.0
    size = plain(norm(vector.parts))
    for direction, (numerators, top, below) in zip(basis, dual, strict=True):
        coefficient = top / below
        length = norm(direction.parts)
        part = tuple(coefficient * x for x in direction.parts)
        reciprocal = (numerators[0] / below, numerators[1] / below, numerators[2] / below)
        largest = max(largest, plain(length) * plain(norm(reciprocal)))
        rows.append(
            Oblique(
                direction=kinds.vector(direction.parts, direction.kind, planar=direction.planar),
                coefficient=kinds.number(coefficient, kinds.over(vector.kind, direction.kind)),
                component=kinds.number(coefficient * length, vector.kind),
                part=kinds.vector(part, vector.kind, planar=vector.planar),
                reciprocal=kinds.vector(reciprocal, kinds.over(kinds.NUMBER, direction.kind), planar=direction.planar),
            )
        )
    advice: tuple[Advice, ...] = ()
    if largest > ILL_CONDITIONED:
        message = worded("the directions nearly lie in one plane: a part may change {times:2} times as much as the "
                         "vector", times=(largest, Ratio))  # fmt: skip
        advice = (Advice("condition", message, remedy="give directions further apart, or with more digits"),)
    parts = [row.part.value for row in rows]
    checks = (_reassembled(vector.parts, parts, size * largest),)
    return Resolved(condition=largest, components=tuple(rows), checks=checks, advice=advice)


def _reciprocal_plane(vector: kinds.Vector, basis: "list[kinds.Vector]") -> "list[tuple[Vector, float, float]]":
    b, c = basis
    require(
        vector.planar and b.planar and c.planar,
        "two directions form a basis of a plane, and not all vectors here are planar",
        code="basis",
        hint="give vectors of two components, or a third direction",
    )
    (bx, by, _), (cx, cy, _) = b.parts, c.parts
    below = sum_of_products((bx, cy), (-1.0, by, cx))
    sine = abs(plain(below)) / (plain(norm(b.parts)) * plain(norm(c.parts)))
    require(
        sine > ROUNDING,
        "the two directions of the basis are parallel (sine {share:2})",
        share=(sine, Ratio),
        code="parallel-basis",
        hint="give two directions that are not parallel",
    )
    first, second = (cy, -cx, 0.0), (-by, bx, 0.0)
    return [(first, dot(vector.parts, first), below), (second, dot(vector.parts, second), below)]


def _reciprocal_space(vector: kinds.Vector, basis: "list[kinds.Vector]") -> "list[tuple[Vector, float, float]]":
    b = [vector.parts for vector in basis]
    below = triple(*b)
    require_spanning((basis[0], basis[1], basis[2]), plain(below))
    pairs = ((b[1], b[2]), (b[2], b[0]), (b[0], b[1]))
    return [(cross(p, q), triple(vector.parts, p, q), below) for p, q in pairs]


def _reassembled(v: "Vector", parts: "list[Any]", size: float = 0.0) -> Check:
    """The parts add up to the vector again, to the rounding of the largest of them."""
    original = [plain(part) for part in v]
    sums = [sum(plain(part[axis]) if axis < len(part) else 0.0 for part in parts) for axis in range(3)]
    scale = max([size, *(abs(plain(x)) for part in parts for x in part), *map(abs, original)])
    off = max(abs(a - b) for a, b in zip(sums, original, strict=True)) / scale if scale else 0.0
    return Check("parts add up to the vector", off <= REASSEMBLED, off, REASSEMBLED)
