"""What a given inertia tensor says: principal moments and axes, whether a body can have it, extreme products."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.lines import unit
from dynamics_cli.inertia.lump import each, minus, second_of, symmetric, turned
from dynamics_cli.inertia.principal import principal
from dynamics_cli.inertia.properties import ProductSign
from dynamics_cli.inertia.results import PrincipalMoments
from dynamics_cli.inertia.rotation import Turn, matrix_of
from dynamics_cli.inertia.spread import bounded, ellipsoid, in_many_digits, plain, root
from dynamics_cli.numerics.symmetric import eigen
from dynamics_cli.quantities import (
    Direction,
    Inertia,
    InertiaTensor,
    InertiaTriple,
    Mass,
    PartLengths,
    Positive,
    ProductOfInertia,
    Ratio,
    Text,
    Vector,
)
from dynamics_cli.records import Advice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.lump import Matrix

HALF_ROOT = 0.7071067811865476
# A lamina's moments add up to within their rounding; a tensor printed with few digits needs more room.
TOLERANCE = 1e-9
# More than three printed digits leave open is no rounding any more.
PRINTED = 1e-2


@record
class Whole:
    """The tensor as its matrix.

    Parameters
    ----------
    tensor : InertiaTensor
        The inertia tensor; its elements off the diagonal are −∫ x y dm [kg*m^2].
    """

    tensor: InertiaTensor

    def matrix(self) -> "Matrix":
        """The tensor."""
        return self.tensor


@record
class Parts:
    """The tensor as moments and products.

    Parameters
    ----------
    moments : tuple of Inertia
        Moments of inertia xx, yy, zz [kg*m^2].
    products : tuple of ProductOfInertia
        Products of inertia xy, yz, zx; zero when not given [kg*m^2].
    product_sign : ProductSign
        Sign of the products given: negative (the tensor's elements) or positive (+∫ x y dm).
    """

    moments: tuple[Inertia, ...]
    products: tuple[ProductOfInertia, ...] = (0.0, 0.0, 0.0)
    product_sign: ProductSign = ProductSign("negative")

    def matrix(self) -> "Matrix":
        """The tensor."""
        require(len(self.moments) == 3, "read {0} moments, wanted 3", len(self.moments), code="tensor")
        require(len(self.products) == 3, "read {0} products, wanted 3", len(self.products), code="tensor")
        xy, yz, zx = self.products
        if self.product_sign == "positive":
            xy, yz, zx = minus(xy), minus(yz), minus(zx)
        xx, yy, zz = self.moments
        return symmetric(xx, yy, zz, xy, yz, zx)


@record
class TensorProperties:
    """Principal moments and axes of an inertia tensor, and its extremes.

    Parameters
    ----------
    principal_moments : PrincipalMoments
        Principal moments.
    principal_axes : tuple of Direction
        Unit vectors along the principal axes, one a row [-].
    degeneracy : Text
        Which principal axes are not determined because moments are equal, or that all are.
    slack : Ratio
        (I₁ + I₂ − I₃)/I₃, which no body has below zero; a lamina has zero [-].
    extreme_products : InertiaTriple
        Greatest products in the planes of principal axes 2-3, 3-1 and 1-2 [kg*m^2].
    greatest_product : Inertia
        The greatest product of inertia for any two axes, (I₃ − I₁)/2 [kg*m^2].
    greatest_product_axes : tuple of Direction
        Two axes with that product, halfway between principal axes 1 and 3 [-].
    moment_there : Inertia
        The moment about either of these two axes, (I₁ + I₃)/2 [kg*m^2].
    ellipsoid_axes : Vector
        Semi-axes 1/√I of the inertia ellipsoid along the principal axes, as shares of the longest [-].
    tensor : InertiaTensor
        The tensor, in the turned axes where a rotation is given; off the diagonal −∫ x y dm [kg*m^2].
    product_sign : Text
        What products mean.
    direction_moment : Inertia
        Moment about the axis along `direction`, when it is given [kg*m^2].
    radii_of_gyration : PartLengths
        Radii of gyration about the principal axes, when the mass is given [m].
    equivalent_box : PartLengths
        Sides along the principal axes of the solid box of the same mass and inertia, when the mass is given [m].
    """

    principal_moments: PrincipalMoments
    principal_axes: tuple[Direction, ...]
    degeneracy: Text
    slack: Ratio
    extreme_products: InertiaTriple
    greatest_product: Inertia
    greatest_product_axes: tuple[Direction, ...]
    moment_there: Inertia
    ellipsoid_axes: Vector
    tensor: InertiaTensor
    product_sign: Text
    direction_moment: Inertia | None = None
    radii_of_gyration: PartLengths | None = None
    equivalent_box: PartLengths | None = None
    advice: tuple[Advice, ...] = ()


def tensor(
    *,
    inertia: Whole | Parts,
    mass: Mass | None = None,
    turn: Turn | None = None,
    direction: Direction | None = None,
    tolerance: Positive = TOLERANCE,
) -> TensorProperties:
    """Principal moments and axes of a given inertia tensor, whether a body can have it, and its extreme products.

    Equation
    --------
    det(I − λ·1) = 0; the greatest product of any axes is (I₃ − I₁)/2, at 45° between principal axes 1 and 3.

    Parameters
    ----------
    inertia : Whole | Parts
        The tensor as its matrix, or its moments and products.
    mass : Mass
        Mass of the body, for radii of gyration and the equivalent box [kg].
    turn : Turn
        How axes are turned in which the tensor is wanted too.
    direction : Direction
        An axis through the same point to give the moment about, of any length [-].
    tolerance : Ratio
        By how much, relative to the greatest moment, I₁ + I₂ may fall short of I₃; raise it for a tensor printed with
        few digits [-].

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
    slack = (moments[0] - (moments[2] - moments[1])) / moments[2]
    first, third = axes[0], axes[2]
    ways = tuple(tuple(HALF_ROOT * (a + s * b) for a, b in zip(first, third, strict=True)) for s in (1.0, -1.0))
    seen = matrix if turn is None else turned(matrix, _rows(turn))
    along = None
    if direction is not None:
        u = unit(direction)
        along = turned(matrix, (u, u, u))[0][0]
    radii = box = None
    if mass is not None:
        require(mass > 0.0, "a mass of zero has no radius of gyration", code="no-mass")
        radii = each(lambda moment: root(moment / mass), moments)
        a, b, c = moments
        seconds = (c - a + b, c - b + a, a - (c - b))
        box = each(lambda part: root(6.0 * part / mass), seconds)
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
        greatest_product_axes=ways,  # type: ignore[arg-type]
        moment_there=0.5 * (moments[0] + moments[2]),
        ellipsoid_axes=ellipsoid(moments),
        tensor=seen,
        product_sign="negative: Ixy = -∫ x y dm",
        direction_moment=along,
        radii_of_gyration=radii,
        equivalent_box=box,
        advice=_advice(plain(slack)),
    )


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

    The hint says how to mend moments that no body has, unless the other sign of the products does it.

    Raises
    ------
    InadmissibleError
        When no body can have it.
    """
    bare = tuple(tuple(plain(x) for x in row) for row in matrix)
    # the least moment of a needle is a small difference of the tensor's elements
    found = eigen(bare).refined()  # type: ignore[arg-type]
    least, middle, most = values = found.values[::-1]
    require(most > 0.0, "the tensor has no positive moment", code="tensor", hint="a body has mass away from any axis")
    room = plain(tolerance) * most
    other = _other_sign(bare, room)  # type: ignore[arg-type]
    require(
        least >= -room,
        "a principal moment is negative: {0:.6g}, {1:.6g}, {2:.6g} kg·m²",
        least,
        middle,
        most,
        code="negative-moment",
        hint=other,
    )
    require(
        least + middle - most >= -room,
        "no body has these moments: {2:.6g} kg·m² exceeds the sum of {0:.6g} and {1:.6g} kg·m² by {3:.3g} of itself",
        least,
        middle,
        most,
        (most - least - middle) / most,
        code="triangle-inequality",
        hint=other or hint,
    )
    own = principal(second_of(bare))  # type: ignore[arg-type]
    if in_many_digits(matrix):
        from dynamics_cli.numerics.symmetric_digits import eigen_of_many_digits

        return eigen_of_many_digits(matrix)[0][::-1], own.axes, own.degeneracy  # type: ignore[return-value]
    if not any(hasattr(x, "slopes") for row in matrix for x in row):
        return values, own.axes, own.degeneracy
    moments = bounded(matrix, values, found.vectors[::-1])
    return moments, own.axes, own.degeneracy


def _other_sign(matrix: "Matrix", room: float) -> str | None:
    """A hint when the products' other sign would make a tensor that a body can have."""
    (xx, xy, zx), (_, yy, yz), (_, _, zz) = matrix
    least, middle, most = eigen(symmetric(xx, yy, zz, -xy, -yz, -zx)).values[::-1]
    if least >= -room and least + middle - most >= -room:
        return "with products of the other sign a body can have it: give the sign they are written in"
    return None


def _advice(slack: float) -> tuple[Advice, ...]:
    if slack < -TOLERANCE:
        return (
            Advice(
                "no-body",
                f"no body has exactly these moments: I₃ exceeds I₁ + I₂ by {-slack:.3g} of itself, which the tolerance "
                "allows",
                severity="caution" if slack > -PRINTED else "serious",
                mend="give the tensor with more digits",
            ),
        )
    if slack > TOLERANCE:
        return ()
    return (Advice("lamina", "I₁ + I₂ = I₃: the body is a lamina across axis 3, or a rod", severity="note"),)
