"""Products of two and of three vectors, with the areas and volumes they measure."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.numerics.exact.typed_products import cross, dot, norm, sum_of_products, triple
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Annotated, FreeNumber, FreeVector, Ratio, Text
from dynamics_cli.records import Advice, record
from dynamics_cli.vec import kinds
from dynamics_cli.vec.angles import ROUNDING, relation

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.exact.typed_products import Vector


@record
class Products:
    """Products of two or three vectors."""

    scalar_product: Annotated[FreeNumber, "a·b."]
    vector_product: Annotated[FreeVector, "a×b."]
    parallelogram: Annotated[FreeNumber, "|a×b|, the area of the parallelogram of a and b."]
    triangle: Annotated[FreeNumber, "Half of |a×b|, the area of the triangle."]
    relation: Annotated[Text, "Whether a and b are parallel, opposite, perpendicular or oblique."]
    triple_product: Annotated[FreeNumber | None, "a·(b×c)."] = None
    box: Annotated[FreeNumber | None, "Its magnitude: the volume of the parallelepiped with the edges a, b and c."] = (
        None
    )
    tetrahedron: Annotated[FreeNumber | None, "A sixth of it: the volume of the tetrahedron."] = None
    coplanar: Annotated[Text | None, "Whether the three lie in one plane, and how that is known."] = None
    first_with_product: Annotated[FreeVector | None, "a×(b×c)."] = None
    product_with_third: Annotated[FreeVector | None, "(a×b)×c."] = None
    advice: tuple[Advice, ...] = ()


def product(
    first: Annotated[FreeVector, 'The vector a, such as "0.3, 0, 0.4 m".'],
    second: Annotated[FreeVector, 'The vector b, such as "0, 200, 0 N".'],
    third: Annotated[FreeVector | None, "The vector c."] = None,
    /,
) -> Products:
    """Scalar and vector products of two vectors, triple products of three, and areas and volumes.

    Equation
    --------
    a·b = Σ aᵢbᵢ, (a×b)_x = a_y·b_z − a_z·b_y, a·(b×c) the determinant, a×(b×c) = b(a·c) − c(a·b).

    Raises
    ------
    InadmissibleError
        When a vector has no direction.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 2.6 to 2.8.

    Examples
    --------
    >>> product((0.1, 0.2, 0.3), (0.4, 0.5, 0.6), (0.7, 0.8, 0.9)).triple_product.value
    0.0
    """
    a_vector, b_vector = kinds.Vector(first, "the first vector"), kinds.Vector(second, "the second vector")
    a, b = a_vector.parts, b_vector.parts
    c = cross(a, b)
    area = norm(c)
    sizes = plain(norm(a)) * plain(norm(b))
    kind = kinds.times(a_vector.kind, b_vector.kind, cross=True)
    none = "undetermined: a vector is zero"
    last = _triples(a_vector, b_vector, kinds.Vector(third, "the third vector")) if third is not None else {}
    return Products(
        scalar_product=kinds.number(dot(a, b), kinds.times(a_vector.kind, b_vector.kind)),
        vector_product=kinds.vector(c, kind),
        parallelogram=kinds.number(area, kind),
        triangle=kinds.number(0.5 * area, kind),
        relation=relation(plain(area), plain(dot(a, b)), sizes) if sizes else none,
        **last,
    )


def _triples(first: kinds.Vector, second: kinds.Vector, third: kinds.Vector) -> "dict[str, Any]":
    a, b, c = first.parts, second.parts, third.parts
    value = triple(a, b, c)
    kind = kinds.times(kinds.times(second.kind, third.kind, cross=True), first.kind)
    triple_kind = kinds.times(kinds.times(second.kind, third.kind, cross=True), first.kind, cross=True)
    sizes = plain(norm(a)) * plain(norm(b)) * plain(norm(c))
    return {
        "triple_product": kinds.number(value, kind),
        "box": kinds.number(absolute(value), kind),
        "tetrahedron": kinds.number(absolute(value) / 6.0, kind),
        "coplanar": coplanar(plain(value), sizes),
        "first_with_product": kinds.vector(_double(b, c, a), triple_kind),
        "product_with_third": kinds.vector(_double(b, a, c), triple_kind),
    }


def _double(outer: "Vector", other: "Vector", factor: "Vector") -> "Vector":
    """kept·(factor·other) − other·(factor·kept): a×(b×c) of (b, c, a), (a×b)×c of (b, a, c)."""

    def part(axis: int) -> float:
        plus = [(outer[axis], factor[j], other[j]) for j in range(3)]
        minus = [(-1.0, other[axis], factor[j], outer[j]) for j in range(3)]
        return sum_of_products(*plus, *minus)

    return part(0), part(1), part(2)


def coplanar(value: float, sizes: float) -> str:
    """Whether a triple product says that three vectors lie in one plane."""
    if value == 0.0:
        return "coplanar, exactly as typed"
    ratio = abs(value) / sizes
    if ratio <= ROUNDING:
        return str(worded("coplanar within rounding ({share:2} of the product of their lengths)", share=(ratio, Ratio)))
    return "not coplanar" if value > 0.0 else "not coplanar, left-handed"


def require_spanning(those: "tuple[kinds.Vector, ...]", value: float) -> None:
    """Refuse a basis of three vectors in one plane."""
    sizes = 1.0
    for vector in those:
        sizes *= plain(norm(vector.parts))
    require(
        abs(value) > ROUNDING * sizes,
        "the three directions of the basis lie in one plane ({share:2} of the product of their lengths)",
        share=(abs(value) / sizes if sizes else 0.0, Ratio),
        code="coplanar-basis",
        hint="give three directions that do not lie in one plane",
    )
