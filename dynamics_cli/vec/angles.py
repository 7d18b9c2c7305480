"""Angles between vectors, right near 0 and 180 degrees, and verdicts decided on the numbers as typed."""

from dynamics_cli.errors import Wording, require, worded
from dynamics_cli.numerics.elementary import absolute, atan2, hypot
from dynamics_cli.numerics.exact.typed_products import cross, dot, norm, scaled, triple
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, FreeNumber, FreeVector, Ratio, Text
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.vec import kinds

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.exact.typed_products import Vector

# Possible value of a zero product due to the rounding of inputs, relative to the product of the magnitudes.
ROUNDING = 4.0 * 2.0**-53
LAGRANGE = 1e-13
# Products beyond these are of no double, or of one that has lost digits.
SMALLEST, LARGEST = 1e-290, 1e305


@record
class AngleBetween:
    """The angle between two vectors."""

    angle: Annotated[Angle, "From 0 to 180 degrees, or signed about the axis [rad]."]
    supplement: Annotated[Angle, "180 degrees less the angle, calculated directly [rad]."]
    relation: Annotated[Text, "Whether they are parallel, opposite, perpendicular or oblique, and how that is known."]
    cosine: Annotated[Ratio, "Cosine of the angle [-]."]
    sine: Annotated[Ratio, "Sine of the angle [-]."]
    scalar_product: Annotated[FreeNumber | None, "a·b."]
    vector_product: Annotated[FreeVector | None, "a×b."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def angle(
    first: Annotated[FreeVector, 'A vector, such as "1, 2, 3" or "20 N @ 30 deg".'],
    second: Annotated[FreeVector, "The second vector, of the same kind or not."],
    /,
    *,
    axis: Annotated[FreeVector | None, "The axis about which the angle from the first to the second is signed."] = None,
) -> AngleBetween:
    """Angle between two vectors, to the last digits also where they are nearly parallel.

    Equation
    --------
    θ = atan2(|a×b|, a·b); about an axis n: θ = atan2(|n|·n·(a×b), (n×a)·(n×b)).

    Raises
    ------
    InadmissibleError
        When a vector or the axis is zero, or the axis is parallel to a vector.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 2.5 to 2.7.

    Examples
    --------
    >>> angle((1.0, 0.0, 0.0), (1.0, 1e-9, 0.0)).angle
    1e-09
    """
    start, end = kinds.Vector(first, "the first vector"), kinds.Vector(second, "the second vector")
    kinds.require_direction(start, "the first vector")
    kinds.require_direction(end, "the second vector")
    a, b = scaled(start.parts), scaled(end.parts)
    product, along = cross(a, b), dot(a, b)
    across = norm(product)
    sizes = norm(a) * norm(b)
    opposite, adjacent, hypotenuse = across, along, sizes
    if axis is not None:
        opposite, adjacent = _about(kinds.Vector(axis, "the axis"), a, b)
        hypotenuse = hypot(opposite, adjacent)
    scaled_back = (a, b) != (start.parts, end.parts)
    within = not scaled_back or SMALLEST < plain(norm(start.parts)) * plain(norm(end.parts)) < LARGEST
    if scaled_back and within:
        product, along_typed = cross(start.parts, end.parts), dot(start.parts, end.parts)
    else:
        along_typed = along
    message = "the products leave the range of a double"
    advice = tuple(Advice("range", message, severity="note", result=f"{name}_product") for name in ("scalar", "vector"))
    return AngleBetween(
        angle=atan2(opposite, adjacent),
        supplement=atan2(opposite, -adjacent),
        relation=relation(plain(across), plain(along), plain(sizes)),
        cosine=adjacent / hypotenuse,
        sine=opposite / hypotenuse,
        scalar_product=kinds.number(along_typed, kinds.times(start.kind, end.kind)) if within else None,
        vector_product=kinds.vector(product, kinds.times(start.kind, end.kind, cross=True)) if within else None,
        checks=(lagrange(a, b),),
        advice=() if within else advice,
    )


def _about(axis: kinds.Vector, a: "Vector", b: "Vector") -> "tuple[float, float]":
    """The sides opposite and adjacent to the angle about an axis."""
    kinds.require_direction(axis, "the axis")
    n = scaled(axis.parts)
    p, q = cross(n, a), cross(n, b)
    for name, vector, moment in (("first", a, p), ("second", b, q)):
        relative = plain(norm(moment)) / (plain(norm(n)) * plain(norm(vector)))
        require(
            relative > ROUNDING,
            "the axis is parallel to the {name} vector (sine {sine:2}): there is no angle about it",
            name=name,
            sine=(relative, Ratio),
            code="parallel-axis",
            hint="give an axis perpendicular to both vectors, such as 0, 0, 1 for vectors in the x–y plane",
        )
    return norm(n) * triple(n, a, b), dot(p, q)


def relation(across: float, along: float, sizes: float) -> str:
    """Parallel, perpendicular or neither: exactly, as the numbers were typed, or within their rounding."""
    if across <= ROUNDING * sizes:
        return _said("parallel" if along > 0.0 else "opposite", across, sizes)
    if absolute(along) <= ROUNDING * sizes:
        return _said("perpendicular", along, sizes)
    return "oblique"


def _said(word: str, number: float, sizes: float) -> str:
    if number == 0.0:
        return f"{word}, exactly as typed"
    name = "cosine" if word == "perpendicular" else "sine"
    wording: Wording = worded("{word} within rounding ({name} {share:2})", word=word, name=name,
                              share=(abs(number) / sizes, Ratio))  # fmt: skip
    return str(wording)


def lagrange(a: "Vector", b: "Vector") -> Check:
    """|a×b|² + (a·b)² = |a|²·|b|², of the doubles."""
    x = [plain(part) for part in a]
    y = [plain(part) for part in b]
    c = (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])
    squares = sum(part * part for part in x) * sum(part * part for part in y)
    left_side = sum(part * part for part in c) + sum(p * q for p, q in zip(x, y, strict=True)) ** 2
    off = abs(left_side - squares) / squares if squares > 0.0 else 0.0
    return Check("|a×b|² + (a·b)² = |a|²|b|²", off <= LAGRANGE, off, LAGRANGE)
