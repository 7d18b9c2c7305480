"""Resultants of vectors, and directions of one."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import atan2, hypot, sqrt
from dynamics_cli.numerics.exact.typed_products import as_typed, difference, norm, sum_of_products, unit
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import Angle, Annotated, FreeNumber, FreeVector, Ratio
from dynamics_cli.records import Advice, record
from dynamics_cli.vec import kinds

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.quantities import Kind

# Beyond this the sum is known only to the last digits of its addends.
MOST_CANCELLED = 1e6


@record
class Added:
    """One of the vectors added."""

    vector: Annotated[FreeVector, "The vector."]
    magnitude: Annotated[FreeNumber, "Its magnitude."]
    angle: Annotated[Angle | None, "Its angle from x, counter-clockwise, where it is planar [rad]."]


@record
class Resultant:
    """The sum of vectors."""

    resultant: Annotated[FreeVector, "The sum."]
    magnitude: Annotated[FreeNumber, "Its magnitude."]
    angle: Annotated[Angle | None, "Its angle from x, counter-clockwise, of a planar sum [rad]."]
    angle_x: Annotated[Angle | None, "Its angle with the x-axis, of a sum in space [rad]."]
    angle_y: Annotated[Angle | None, "Its angle with the y-axis [rad]."]
    angle_z: Annotated[Angle | None, "Its angle with the z-axis [rad]."]
    direction: Annotated[FreeVector | None, "Its direction cosines."]
    equilibrant: Annotated[FreeVector, "The vector that balances it."]
    cancellation: Annotated[Ratio | None, "Sum of the magnitudes over the magnitude of the sum [-]."]
    parts: Annotated[tuple[Added, ...], "The vectors added."]
    advice: tuple[Advice, ...] = ()


@record
class DirectionOf:
    """Magnitude and direction of a vector."""

    vector: Annotated[FreeVector, "The vector, or the one from the first point to the second."]
    magnitude: Annotated[FreeNumber, "Its magnitude."]
    angle: Annotated[Angle | None, "Its angle from x, counter-clockwise, where it is planar [rad]."]
    angle_x: Annotated[Angle, "Its angle with the x-axis [rad]."]
    angle_y: Annotated[Angle, "Its angle with the y-axis [rad]."]
    angle_z: Annotated[Angle | None, "Its angle with the z-axis [rad]."]
    direction: Annotated[FreeVector, "Its direction cosines: the unit vector."]


def resultant(
    *vectors: Annotated[FreeVector, 'Vectors of one kind, such as "20 N @ 30 deg" "3, 4 N".'],
    between: Annotated[Angle | None, "The angle between two vectors given by magnitude only, e.g. 60 deg."]
    = None,
) -> Resultant:  # fmt: skip
    """Sum of vectors of one kind, planar or in space, and how much of them cancels.

    Equation
    --------
    R = Σ aᵢ; of two magnitudes at an angle φ: R² = (A − B)² + 4·A·B·cos²(φ/2).

    Raises
    ------
    InadmissibleError
        When no vector is given, or kinds are mixed.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 2.3 and 2.4.

    Examples
    --------
    >>> resultant((3.0, 0.0), (0.0, 4.0)).magnitude.value
    5.0
    """
    require(len(vectors) > 0, "no vector is given", code="missing", hint='for example "20 N @ 30 deg" "3, 4 N"')
    if between is not None:
        return _of_magnitudes(vectors, between)
    bare = [item for item in vectors if len(kinds.parts_of(item)) == 1]
    require(
        len(bare) < 2,
        "magnitudes alone have no sum: the directions decide it",
        code="no-direction",
        hint='of two give the angle, --between "60 deg"; or write them as 20 N @ 30 deg',
    )
    addends = kinds.vectors(vectors)
    kinds.require_same_kind(addends, "vectors of unlike kinds have no sum")
    planar = all(vector.planar for vector in addends)
    kind = addends[0].kind
    x, y, z = (sum_of_products(*((vector.parts[axis],) for vector in addends)) for axis in range(3))
    added = tuple(
        Added(
            vector=kinds.vector(vector.parts, vector.kind, planar=planar),
            magnitude=kinds.magnitude(vector),
            angle=_angle(vector.parts) if planar and not vector.is_zero else None,
        )
        for vector in addends
    )
    size = norm((x, y, z))
    return _summed((x, y, z), size, kind, added, planar=planar)


def _summed(
    parts: "tuple[float, float, float]", size: float, kind: "Kind", added: "tuple[Added, ...]", *, planar: bool
) -> Resultant:
    zero = plain(size) == 0.0
    sizes = sum_of_products(*((vector.magnitude.value,) for vector in added))
    cancellation = None if zero else sizes / size
    angles = () if zero else direction_angles(parts)
    return Resultant(
        resultant=kinds.vector(parts, kind, planar=planar),
        magnitude=kinds.number(size, kind),
        angle=_angle(parts) if planar and not zero else None,
        angle_x=angles[0] if angles and not planar else None,
        angle_y=angles[1] if angles and not planar else None,
        angle_z=angles[2] if angles and not planar else None,
        direction=None if zero else kinds.direction(tuple(part / size for part in parts), planar=planar),
        equilibrant=kinds.vector([-part + 0.0 for part in parts], kind, planar=planar),
        cancellation=cancellation,
        parts=added,
        advice=tuple(_advice(zero, cancellation)),
    )


def _advice(zero: bool, cancellation: "float | None") -> "list[Advice]":
    if zero:
        message = "the vectors are in equilibrium: their sum is zero and has no direction"
        return [Advice("equilibrium", message, severity="note", result="direction")]
    if plain(cancellation) > MOST_CANCELLED:
        message = worded(
            "the vectors cancel: their magnitudes add to {times} times the sum", times=(cancellation, Ratio)
        )
        remedy = "give the vectors with more digits, if they are known to more"
        return [Advice("cancellation", message, remedy=remedy)]
    return []


def _of_magnitudes(raw: "tuple[Any, ...]", between: float) -> Resultant:
    alone = [kinds.parts_of(item) for item in raw]
    require(
        [len(parts) for parts in alone] == [1, 1],
        "--between needs two magnitudes",
        code="magnitudes",
        hint='for example "15 N" "12 N" --between "60 deg"',
    )
    a, b = (as_typed(size) for (size,) in alone)
    require(plain(a) >= 0.0 and plain(b) >= 0.0, "a magnitude is below zero", code="negative", hint="reverse it")
    kind = getattr(raw[0], "kind", kinds.NUMBER)
    other = getattr(raw[1], "kind", kinds.NUMBER)
    message = "vectors of unlike kinds have no sum: {first} and {other}"
    kinds.require_one_kind(kind, other, message, "give two magnitudes of one kind")
    cosine, sine = turned(between)
    half, _ = turned(0.5 * between)
    apart = sum_of_products((a,), (-1.0, b))
    root = a * b
    size = hypot(apart, 2.0 * (sqrt(root) * half))
    parts = (sum_of_products((a,), (b, cosine)), b * sine, 0.0)
    added = (
        Added(kinds.vector((a, 0.0), kind, planar=True), kinds.number(a, kind), 0.0),
        Added(kinds.vector((b * cosine, b * sine), kind, planar=True), kinds.number(b, kind), between),
    )
    return _summed(parts, size, kind, added, planar=True)


def direction(
    vector: Annotated[FreeVector, 'A vector, such as "8, 12, 7 m"; with a second point, the first of two.'],
    point: Annotated[FreeVector | None, "The second of two points, for the line of sight from the first to it."] = None,
    /,
) -> DirectionOf:
    """Magnitude, unit vector and direction angles of a vector, or of the line from one point to another.

    Equation
    --------
    cos θx = v_x/|v|; computed as θx = atan2(√(v_y² + v_z²), v_x), which keeps small angles.

    Raises
    ------
    InadmissibleError
        When the vector is zero, the points are one, or of unlike kinds.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 2.4.

    Examples
    --------
    >>> round(direction((8.0, 12.0, 7.0)).magnitude.value, 6)
    16.03122
    """
    first = kinds.Vector(vector, "the vector")
    parts = first.parts
    planar = first.planar
    if point is not None:
        second = kinds.Vector(point, "the second point")
        kinds.require_same_kind((first, second), "a line of sight needs two points of one kind")
        parts = difference(second.parts, first.parts)
        planar = planar and second.planar
    size = norm(parts)
    require(
        plain(size) > 0.0,
        "{what} has no direction",
        what="a zero vector" if point is None else "the line between two equal points",
        code="zero-vector",
        hint="give a vector that is not zero" if point is None else "give two different points",
    )
    angles = direction_angles(parts)
    return DirectionOf(
        vector=kinds.vector(parts, first.kind, planar=planar),
        magnitude=kinds.number(size, first.kind),
        angle=_angle(parts) if planar else None,
        angle_x=angles[0],
        angle_y=angles[1],
        angle_z=None if planar else angles[2],
        direction=kinds.direction(unit(parts), planar=planar),
    )


def direction_angles(parts: "tuple[float, float, float]") -> "tuple[float, float, float]":
    """The angles with the three axes, by atan2 and never by the arc cosine."""
    x, y, z = parts
    return atan2(hypot(y, z), x), atan2(hypot(x, z), y), atan2(hypot(x, y), z)


def _angle(parts: "tuple[float, float, float]") -> float:
    return atan2(parts[1], parts[0])
