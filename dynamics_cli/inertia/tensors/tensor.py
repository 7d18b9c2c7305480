"""Properties of a given inertia tensor: principal moments and axes, whether a body can have it, extreme products."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.bodies.lines import unit
from dynamics_cli.inertia.bodies.mass_moments import each, minus, second_of, symmetric, turned
from dynamics_cli.inertia.bodies.principal import principal
from dynamics_cli.inertia.bodies.principal_tracked import (
    bounded,
    determined,
    ellipsoid,
    error_of,
    in_many_digits,
    root,
    stated_tilt,
    tilts_of,
)
from dynamics_cli.inertia.bodies.properties import ProductSign
from dynamics_cli.inertia.bodies.records import PrincipalMoments
from dynamics_cli.numerics.eigen3.jacobi import eigen
from dynamics_cli.numerics.number import is_tracked, plain
from dynamics_cli.numerics.orientation.rotations import Turn, matrix_of
from dynamics_cli.quantities import (
    Annotated,
    Direction,
    Inertia,
    InertiaTensor,
    InertiaTriple,
    Mass,
    PartLengths,
    Positive,
    ProductOfInertia,
    Ratio,
    Remark,
    Text,
    Vector,
)
from dynamics_cli.records import Advice, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.bodies.mass_moments import Matrix

HALF_ROOT = 0.7071067811865476
# A lamina's moments add up within their rounding; a tensor printed with few digits needs more tolerance.
TOLERANCE = 1e-9
# A deficit beyond the rounding of three printed digits.
PRINTED = 1e-2


@record
class Whole:
    """The tensor as its matrix."""

    tensor: Annotated[InertiaTensor, "The inertia tensor; its elements off the diagonal are −∫ x y dm [kg*m^2]."]

    def matrix(self) -> "Matrix":
        """The tensor."""
        return self.tensor


@record
class Parts:
    """The tensor as moments and products."""

    moments: Annotated[tuple[Inertia, ...], "Moments of inertia I_xx, I_yy, I_zz, e.g. 2, 2, 3 kg*m^2."]
    products: Annotated[tuple[ProductOfInertia, ...], "Products of inertia xy, yz, zx, e.g. -0.5, 0, 0 kg*m^2."] = (
        0.0,
        0.0,
        0.0,
    )
    product_sign: Annotated[
        ProductSign, "Sign of the products given: negative (the tensor's elements) or positive (+∫ x y dm)."
    ] = ProductSign("negative")

    def matrix(self) -> "Matrix":
        """The tensor."""
        require(len(self.moments) == 3, "read {count} moments, wanted 3", code="tensor", count=len(self.moments))
        require(len(self.products) == 3, "read {count} products, wanted 3", code="tensor", count=len(self.products))
        xy, yz, zx = self.products
        if self.product_sign == "positive":
            xy, yz, zx = minus(xy), minus(yz), minus(zx)
        xx, yy, zz = self.moments
        return symmetric(xx, yy, zz, xy, yz, zx)


@record
class TensorProperties:
    """Principal moments and axes of an inertia tensor, and its extremes."""

    principal_moments: Annotated[PrincipalMoments, "Principal moments."]
    principal_axes: Annotated[tuple[Direction, ...], "Unit vectors along the principal axes, one a row [-]."]
    degeneracy: Annotated[Text, "Principal axes that equal moments leave undetermined, or none."]
    slack: Annotated[Ratio, "(I₁ + I₂ − I₃)/I₃: zero for a lamina, never negative for a body [-]."]
    extreme_products: Annotated[
        InertiaTriple, "Maximum products in the planes of principal axes 2-3, 3-1 and 1-2 [kg*m^2]."
    ]
    greatest_product: Annotated[Inertia, "The maximum product of inertia for any two axes, (I₃ − I₁)/2 [kg*m^2]."]
    greatest_product_axes: Annotated[
        tuple[Direction, ...], "Two axes with that product, halfway between principal axes 1 and 3 [-]."
    ]
    moment_there: Annotated[Inertia, "The moment about either of these two axes, (I₁ + I₃)/2 [kg*m^2]."]
    ellipsoid_axes: Annotated[
        Vector, "Semi-axes 1/√I of the inertia ellipsoid along the principal axes, as shares of the longest [-]."
    ]
    tensor: Annotated[
        InertiaTensor, "The tensor, in the turned axes where a rotation is given; off the diagonal −∫ x y dm [kg*m^2]."
    ]
    second_moments: Annotated[
        InertiaTensor,
        "The matrix ∫ r rᵀ dm = ½ tr(I)·1 − I in the same axes, as simulators' pseudo-inertia holds it [kg*m^2].",
    ]
    product_sign: Annotated[Remark, "Sign convention of the products."]
    direction_moment: Annotated[
        Inertia | None, "Moment about the axis along `direction`, when it is given [kg*m^2]."
    ] = None
    radii_of_gyration: Annotated[
        PartLengths | None, "Radii of gyration about the principal axes, when the mass is given [m]."
    ] = None
    equivalent_box: Annotated[
        PartLengths | None,
        "Sides along the principal axes of the solid box of the same mass and inertia, when the mass is given [m].",
    ] = None
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def tensor(
    *,
    inertia: Annotated[Whole | Parts, "The tensor as its matrix, or its moments and products."],
    mass: Annotated[Mass | None, "Mass of the body, for radii of gyration and the equivalent box, e.g. 40 kg."] = None,
    turn: Annotated[Turn | None, "Rotation of further axes, in which the tensor is given too."] = None,
    direction: Annotated[
        Direction | None, "An axis through the same point to give the moment about, of any length [-]."
    ] = None,
    tolerance: Annotated[
        Positive,
        "Permitted deficit of I₁ + I₂ against I₃, relative to I₃; raise it for a tensor printed with few digits [-].",
    ] = TOLERANCE,
) -> TensorProperties:
    """Principal moments and axes of a given inertia tensor, whether a body can have it, and its extreme products.

    Equation
    --------
    det(I − λ·1) = 0; the greatest product of any axes is (I₃ − I₁)/2, at 45° between principal axes 1 and 3.

    Returns
    -------
    TensorProperties
        Principal moments, axes and extremes.

    Raises
    ------
    InadmissibleError
        When a principal moment is negative or one exceeds the sum of the two others by more than the tolerance, or
        when all are zero.

    Notes
    -----
    Jacobi's rotations on the tensor as given; axes between equal moments are declared undetermined and given closest
    to the input axes.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 7.7 to 7.11.

    Examples
    --------
    >>> answer = tensor(inertia=Parts(moments=(2.0, 2.0, 3.0), products=(-0.5, 0.0, 0.0)))
    >>> answer.principal_moments
    PrincipalMoments(first=1.5, second=2.5, third=3.0)
    """
    matrix = inertia.matrix()
    moments, axes, words = require_tensor(matrix, tolerance)
    bounded_moments = determined(words) and hasattr(moments[0], "error")
    slack = (moments[0] - (moments[2] - moments[1])) / moments[2]
    first, third = axes[0], axes[2]
    diagonals = tuple(tuple(HALF_ROOT * (a + s * b) for a, b in zip(first, third, strict=True)) for s in (1.0, -1.0))
    rotated = matrix if turn is None else turned(matrix, _rows(turn))
    along = None
    if direction is not None:
        u = unit(direction)
        along = turned(matrix, (u, u, u))[0][0]
    radii, box = (None, None) if mass is None else _radii_and_box(moments, mass)
    return TensorProperties(
        principal_moments=PrincipalMoments(*moments),
        principal_axes=axes,
        degeneracy=words,
        slack=slack,
        extreme_products=(
            0.5 * (moments[2] - moments[1]),
            0.5 * (moments[2] - moments[0]),
            0.5 * (moments[1] - moments[0]),
        ),
        greatest_product=0.5 * (moments[2] - moments[0]),
        greatest_product_axes=diagonals,  # type: ignore[arg-type]
        moment_there=0.5 * (moments[0] + moments[2]),
        ellipsoid_axes=ellipsoid(moments),
        tensor=rotated,
        second_moments=tuple(each(lambda x: minus(minus(x)), row) for row in second_of(rotated)),  # type: ignore[arg-type]
        product_sign="negative: Ixy = -∫ x y dm",
        direction_moment=along,
        radii_of_gyration=radii,
        equivalent_box=box,
        advice=_advice(plain(slack)),
        numerics=Numerics("Jacobi rotations", stated_tilt(tilts_of(matrix, axes) if bounded_moments else None)),
    )


def _radii_and_box(moments: "tuple[float, ...]", mass: float) -> "tuple[Vector, Vector]":
    """Radii of gyration, and the sides of the solid box of that mass and those moments."""
    require(mass > 0.0, "a mass of zero has no radius of gyration", code="no-mass")
    a, b, c = moments
    seconds = (c - a + b, c - b + a, a - (c - b))
    return each(lambda moment: root(moment / mass), moments), each(lambda part: root(6.0 * part / mass), seconds)


def _rows(turn: Turn) -> "Matrix":
    columns = tuple(zip(*matrix_of(turn), strict=True))
    return columns  # type: ignore[return-value]


def require_tensor(
    matrix: "Matrix",
    tolerance: float = TOLERANCE,
    *,
    hint: str = "for a tensor printed with few digits give a larger tolerance",
) -> "tuple[tuple[float, ...], Matrix, str]":
    """Principal moments (ascending), axes and words about them, of a tensor that a body can have.

    The hint gives the remedy for impossible moments, or suggests the other sign of the products.

    Raises InadmissibleError when no body can have it.
    """
    doubles = tuple(tuple(plain(x) for x in row) for row in matrix)
    # the least moment of a needle is a small difference of the tensor's elements
    eigenvalues = eigen(doubles).refined()  # type: ignore[arg-type]
    least, middle, most = values = eigenvalues.values[::-1]
    require(most > 0.0, "the tensor has no positive moment", code="tensor", hint="moments of inertia are positive")
    allowed = plain(tolerance) * most
    other = _other_sign(doubles, allowed)  # type: ignore[arg-type]
    require(
        least >= -allowed,
        "a principal moment is negative: {least:6}, {middle:6}, {most:6}",
        code="negative-moment",
        hint=other,
        least=(least, Inertia),
        middle=(middle, Inertia),
        most=(most, Inertia),
    )
    require(
        least + middle - most >= -allowed,
        "impossible moments: {most:6} exceeds the sum of {least:6} and {middle:6} by {excess:3} of it",
        code="triangle-inequality",
        hint=other or "{remedy}",
        remedy=hint,
        least=(least, Inertia),
        middle=(middle, Inertia),
        most=(most, Inertia),
        excess=((most - least - middle) / most, Ratio),
    )
    result = principal(second_of(doubles))  # type: ignore[arg-type]
    if in_many_digits(matrix):
        from dynamics_cli.numerics.eigen3.jacobi_digits import eigen_of_many_digits

        return eigen_of_many_digits(matrix)[0][::-1], result.axes, result.degeneracy  # type: ignore[return-value]
    if not any(is_tracked(x) for row in matrix for x in row):
        return values, result.axes, result.degeneracy
    moments = bounded(matrix, values, eigenvalues.vectors[::-1])
    result = principal(second_of(doubles), each(error_of, moments))  # type: ignore[arg-type]
    return moments, result.axes, result.degeneracy


def _other_sign(matrix: "Matrix", room: float) -> str | None:
    """A hint when the products' other sign would make a tensor that a body can have."""
    (xx, xy, zx), (_, yy, yz), (_, _, zz) = matrix
    least, middle, most = eigen(symmetric(xx, yy, zz, -xy, -yz, -zx)).values[::-1]
    if least >= -room and least + middle - most >= -room:
        return "the products may have the other sign: give --product-sign"
    return None


def _advice(slack: float) -> tuple[Advice, ...]:
    if slack < -TOLERANCE:
        message = f"I₃ exceeds I₁ + I₂ by a share of {-slack:.3g}, which is impossible but within the tolerance"
        remedy = "give the tensor with more digits"
        return (Advice("no-body", message, severity="caution" if slack > -PRINTED else "serious", remedy=remedy),)
    if slack > TOLERANCE:
        return ()
    return (Advice("lamina", "I₁ + I₂ = I₃: the body is a lamina across axis 3, or a rod", severity="note"),)
