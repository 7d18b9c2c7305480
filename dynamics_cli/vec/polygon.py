"""Planar vector polygons with two unknowns: two directions, two magnitudes, or one of each."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, atan2, sqrt
from dynamics_cli.numerics.exact.typed_products import as_typed, norm, sum_of_products
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import Angle, Annotated, FreeNumber, FreeVector
from dynamics_cli.records import Advice, record
from dynamics_cli.vec import kinds

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

PARALLEL = 4.0 * 2.0**-53
MANY_TURNS = 100.0

if TYPE_CHECKING:
    Pair = tuple[float, float]


@record
class Solution:
    """One way to close the polygon."""

    first: Annotated[FreeVector, "The first unknown vector."]
    first_magnitude: Annotated[FreeNumber, "Its magnitude; negative when it is opposite to the given direction."]
    first_angle: Annotated[Angle, "Its angle from x, counter-clockwise [rad]."]
    second: Annotated[FreeVector, "The second unknown vector."]
    second_magnitude: Annotated[FreeNumber, "Its magnitude; negative when it is opposite to the given direction."]
    second_angle: Annotated[Angle, "Its angle from x, counter-clockwise [rad]."]


@record
class Polygon:
    """A planar sum of vectors, two of them in part unknown."""

    solutions: Annotated[tuple[Solution, ...], "Every way to close the polygon."]
    missing: Annotated[FreeVector, "Sum of the two unknown vectors."]
    advice: tuple[Advice, ...] = ()


def polygon(
    *known: Annotated[FreeVector, "Known vectors of the sum, planar and of one kind."],
    sum_: Annotated[FreeVector | None, "Sum of all vectors; zero (a closed polygon) if left out."] = None,
    magnitudes: Annotated[FreeVector | None, "Magnitudes of vectors of unknown direction, e.g. 5, 4 kN."] = None,
    directions: Annotated[tuple[Angle, ...], "Directions of vectors of unknown magnitude, e.g. 30, 135 deg."] = (),
) -> Polygon:
    """Planar sum with two unknowns: two directions, two magnitudes, or one of each; every solution.

    Equation
    --------
    p + q = T; magnitudes A and B: p = T(u ± iv)/|T|, u = (T² + (A − B)(A + B))/(2|T|), v = √(A² − u²) in factors.

    Raises
    ------
    InadmissibleError
        When the polygon cannot close (with the gap), or is not determined.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 2.3 and 5.5.

    Examples
    --------
    >>> round(polygon(sum_=(6.0, 2.0), magnitudes=(5.0, 4.0)).solutions[1].first_angle, 6)
    1.006215
    """
    sizes = [] if magnitudes is None else [as_typed(size) for size in kinds.parts_of(magnitudes)]
    require(
        len(sizes) + len(directions) == 2,
        "a planar sum determines two unknowns, {count} are given",
        count=str(len(sizes) + len(directions)),
        code="unknowns",
        hint="give two magnitudes, two directions, or one of each",
    )
    kind, total = _missing(known, sum_)
    for size in sizes:
        require(size >= 0.0, "a magnitude is below zero", code="negative", hint="reverse the vector")
    if sizes:
        sized = getattr(magnitudes, "kind", kinds.NUMBER)
        kind = sized if kind is None else kind
        message = "vectors of different kinds cannot be added: {first} and {other}"
        kinds.require_one_kind(kind, sized, message, "give all vectors and magnitudes in one kind")
    kind = kind or kinds.NUMBER
    if len(sizes) == 2:
        pairs = _two_directions(total, sizes[0], sizes[1], kind)
    elif sizes:
        pairs = _one_of_each(total, directions[0], sizes[0], kind)
    else:
        pairs = _two_magnitudes(total, directions[0], directions[1])
    solutions = tuple(_solution(p, q, kind, sizes, directions) for p, q in pairs)
    against = any(plain(s.value) < 0.0 for row in solutions for s in (row.first_magnitude, row.second_magnitude))
    note = Advice("against", "a negative magnitude means a vector opposite to the given direction", severity="note")
    return Polygon(
        solutions=solutions,
        missing=kinds.vector((*total, 0.0), kind, planar=True),
        advice=(note,) if against else (),
    )


def _missing(known: "tuple[Any, ...]", sum_: "Any") -> "tuple[Any, Pair]":
    sides = [*kinds.vectors(known), *([kinds.Vector(sum_, "the sum")] if sum_ is not None else [])]
    for vector in sides:
        require(
            vector.planar, "a polygon needs planar vectors", code="planar", hint="give two components, or 5 N @ 30 deg"
        )
    kinds.require_same_kind(sides, "vectors of different kinds cannot be added")
    terms = [(-1.0, vector) for vector in sides[: len(known)]] + [(1.0, vector) for vector in sides[len(known) :]]
    x, y = (sum_of_products((0.0,), *((sign, vector.parts[axis]) for sign, vector in terms)) for axis in range(2))
    return (sides[0].kind if sides else None), (x, y)


def _two_directions(total: "Pair", a: float, b: float, kind: "Any") -> "list[tuple[Pair, Pair]]":
    x, y = total
    size = norm((x, y, 0.0))
    require(
        plain(size) > 0.0,
        "the two vectors must add up to zero: they are opposite in any direction, or unequal and cannot close",
        code="undetermined",
        hint="give one of them a direction",
    )
    # (A + B)² − T² and T² − (A − B)², exactly as typed, so that a touching polygon closes
    far = sum_of_products((a, a), (2.0, a, b), (b, b), (-1.0, x, x), (-1.0, y, y))
    near = sum_of_products((x, x), (y, y), (-1.0, a, a), (2.0, a, b), (-1.0, b, b))
    longest, shortest = plain(a) + plain(b), abs(plain(a) - plain(b))
    require(
        far >= 0.0,
        "the polygon cannot close: {first} and {second} together are {gap} short of {total}",
        first=(a, kind),
        second=(b, kind),
        total=(size, kind),
        gap=(plain(size) - longest, kind),
        code="gap",
        hint="lengthen one of them by {gap}, or shorten their sum",
    )
    require(
        near >= 0.0,
        "the polygon cannot close: {first} and {second} differ by {gap} more than {total}",
        first=(a, kind),
        second=(b, kind),
        total=(size, kind),
        gap=(shortest - plain(size), kind),
        code="gap",
        hint="bring them nearer to each other by {gap}",
    )
    square = sum_of_products((x, x), (y, y))
    u = sum_of_products((x, x), (y, y), (a, a), (-1.0, b, b)) / (2.0 * square)
    v = sqrt(far) * sqrt(near) / (2.0 * square)
    signs = (-1.0, 1.0) if plain(v) > 0.0 else (1.0,)
    pairs = []
    for sign in signs:
        p = (x * u - y * (sign * v), y * u + x * (sign * v))
        pairs.append((p, (x - p[0], y - p[1])))
    return pairs


def _one_of_each(total: "Pair", direction: float, a: float, kind: "Any") -> "list[tuple[Pair, Pair]]":
    x, y = total
    cosine, sine = turned(direction)
    along = x * cosine + y * sine
    across = y * cosine - x * sine
    gap = plain(absolute(across)) - plain(a)
    require(
        gap <= 0.0,
        "the polygon cannot close: {size} is {gap} short of reaching the line of the direction given",
        size=(a, kind),
        gap=(gap, kind),
        code="gap",
        hint="lengthen it by {gap}",
    )
    reach = sqrt((a - across) * (a + across))
    pairs = []
    for sign in (1.0, -1.0) if plain(reach) > 0.0 else (1.0,):
        length = along - sign * reach
        q = (sign * reach * cosine - across * sine, sign * reach * sine + across * cosine)
        pairs.append((q, (length * cosine, length * sine)))
    return pairs


def _two_magnitudes(total: "Pair", first_direction: float, second_direction: float) -> "list[tuple[Pair, Pair]]":
    x, y = total
    (c, s), (d, t) = turned(first_direction), turned(second_direction)
    sine, _ = _sine_of(first_direction, second_direction)
    require(
        abs(plain(sine)) > PARALLEL,
        "the two directions are parallel: the sum cannot be divided between them",
        code="parallel",
        hint="give two directions that are not parallel",
    )
    p = (x * t - y * d) / sine
    q = (y * c - x * s) / sine
    return [((p * c, p * s), (q * d, q * t))]


def _sine_of(start: float, end: float) -> "tuple[float, float]":
    """Sine and cosine of the turn from one direction to the other, small turns exactly.

    Angles of so many turns that their difference is rounded by more than a last bit of a turn have it from their sines.
    """
    if abs(plain(start)) + abs(plain(end)) > MANY_TURNS:
        (c, s), (d, t) = turned(start), turned(end)
        return t * c - d * s, d * c + t * s
    cosine, sine = turned(end - start)
    return sine, cosine


def _solution(p: "Pair", q: "Pair", kind: "Any", sizes: "list[float]", direction: "tuple[float, ...]") -> Solution:
    # vectors of given magnitude come first, as the options are read
    directions = [None] * len(sizes) + list(direction)
    sides = []
    for nth, (parts, angle) in enumerate(zip((p, q), directions, strict=True)):
        size = sizes[nth] if angle is None else norm((*parts, 0.0))
        angle_of = atan2(parts[1], parts[0])
        if angle is not None:
            cosine, sine = turned(angle)
            forward = plain(parts[0]) * plain(cosine) + plain(parts[1]) * plain(sine) >= 0.0
            size, angle_of = (size if forward else -size), angle
        sides.append((kinds.vector((*parts, 0.0), kind, planar=True), kinds.number(size, kind), angle_of))
    (first, a, alpha), (second, b, beta) = sides
    return Solution(first, a, alpha, second, b, beta)
