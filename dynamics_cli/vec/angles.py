"""Angles between vectors, right near 0 and 180 degrees, and verdicts decided on the numbers as typed."""

from dynamics_cli.errors import Wording, require, worded
from dynamics_cli.numerics.elementary import absolute, atan2, hypot
from dynamics_cli.numerics.exact.typed_products import cross, dot, norm, scaled, triple
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, FreeVector, Ratio, Text
from dynamics_cli.records import record
from dynamics_cli.vec import kinds

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.exact.typed_products import Vector

# Possible value of a zero product due to the rounding of inputs, relative to the product of the magnitudes.
ROUNDING = 4.0 * 2.0**-53


@record
class AngleBetween:
    """The angle between two vectors."""

    angle: Annotated[Angle, "From 0 to 180 degrees, or signed about the axis [rad]."]
    supplement: Annotated[Angle, "180 degrees less the angle, calculated directly [rad]."]
    relation: Annotated[Text, "Whether they are parallel, opposite, perpendicular or oblique, and how that is known."]
    cosine: Annotated[Ratio, "Cosine of the angle [-]."]
    sine: Annotated[Ratio, "Sine of the angle [-]."]


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
    along, across = dot(a, b), norm(cross(a, b))
    sizes = norm(a) * norm(b)
    opposite, adjacent, hypotenuse = across, along, sizes
    if axis is not None:
        opposite, adjacent = _about(kinds.Vector(axis, "the axis"), a, b)
        hypotenuse = hypot(opposite, adjacent)
    return AngleBetween(
        angle=atan2(opposite, adjacent),
        supplement=atan2(opposite, -adjacent),
        relation=relation(plain(across), plain(along), plain(sizes)),
        cosine=adjacent / hypotenuse,
        sine=opposite / hypotenuse,
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
