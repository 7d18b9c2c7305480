"""Mass properties as reported by every task of this family: one record, from a lump and a view of it."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.bodies.lines import shaft_moment
from dynamics_cli.inertia.bodies.mass_moments import Lump, about, each, minus, tensor_of, turned
from dynamics_cli.inertia.bodies.principal_tracked import Spread, ellipsoid, root, spread_of
from dynamics_cli.inertia.bodies.records import (
    AxisMoments,
    AxisProducts,
    Cancellation,
    Deviation,
    PartShare,
    PrincipalMoments,
    Shaft,
    ShaftMoment,
)
from dynamics_cli.inertia.mesh.surface import Surface
from dynamics_cli.numerics.elementary import only_in_doubles
from dynamics_cli.numerics.orientation.rotations import IDENTITY, Turn, matrix_of, transposed
from dynamics_cli.quantities import (
    Annotated,
    Area,
    Direction,
    Distance,
    InertiaTensor,
    Mass,
    PartLengths,
    PartPosition,
    Remark,
    Text,
    Vector,
    Volume,
)
from dynamics_cli.records import Advice, Check, Choice, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.bodies.mass_moments import Matrix


# Other words for the centroid.
CENTROID = (
    "centre", "center", "cg", "com", "cog", "mass centre", "mass center", "centre of mass", "center of mass",
    "centre of gravity", "center of gravity", "middle",
)  # fmt: skip


class Axes(Choice):
    """The axes that results are given in."""

    names = ("given", "principal")


class ProductSign(Choice):
    """Sign convention of products of inertia: minus the integral of x y (the tensor's element), or plus."""

    names = ("negative", "positive")
    aliases = {"minus": "negative", "plus": "positive"}  # noqa: RUF012


@record
class MassProperties:
    """Mass, mass centre and inertia of a body."""

    mass: Annotated[Mass, "Mass [kg]."]
    volume: Annotated[Volume | None, "Volume of a solid [m^3]."]
    area: Annotated[Area | None, "Area of a lamina or a thin shell [m^2]."]
    length: Annotated[Distance | None, "Length of a thin rod [m]."]
    centroid: Annotated[PartPosition, "Mass centre, in the given axes from the given origin [m]."]
    about: Annotated[Text, "Reference point of the moments and products."]
    reference_point: Annotated[PartPosition, "That point, in the given axes from the given origin [m]."]
    axes: Annotated[Text, "The axes of moments, products, tensor and second moments."]
    product_sign: Annotated[Remark, "What the products mean."]
    moments: Annotated[AxisMoments, "Moments of inertia about the reference point."]
    products: Annotated[
        AxisProducts, "Products of inertia about the reference point, of the sign that `product_sign` says."
    ]
    tensor: Annotated[
        InertiaTensor,
        "The inertia tensor (the dyadic's matrix) about the reference point; off the diagonal −∫ x y dm [kg*m^2].",
    ]
    radii_of_gyration: Annotated[PartLengths, "√(moment/mass) about the three axes through the reference point [m]."]
    second_moments: Annotated[InertiaTensor, "The matrix ∫ r rᵀ dm about the mass centre, in the same axes [kg*m^2]."]
    principal_moments: Annotated[PrincipalMoments, "Principal moments about the mass centre."]
    principal_axes: Annotated[
        tuple[Direction, ...], "Unit vectors along the principal axes, in the given axes, one a row [-]."
    ]
    degeneracy: Annotated[Text, "Principal axes that equal moments leave undetermined, or none."]
    principal_radii: Annotated[PartLengths, "Radii of gyration about the principal axes [m]."]
    ellipsoid_axes: Annotated[
        Vector, "Semi-axes 1/√I of the inertia ellipsoid along the principal axes, as shares of the longest [-]."
    ]
    equivalent_ellipsoid: Annotated[
        PartLengths, "Semi-axes along the principal axes of the solid ellipsoid of the same mass and inertia [m]."
    ]
    equivalent_box: Annotated[
        PartLengths, "Sides along the principal axes of the solid box of the same mass and inertia [m]."
    ]
    shaft: Annotated[ShaftMoment | None, "Inertia about the shaft, when one is given."] = None
    cancellation: Annotated[Cancellation | None, "Cancellation between material and holes, when there are holes."] = (
        None
    )
    standard_uncertainty: Annotated[Deviation | None, "Standard uncertainties, when measured parts have some."] = None
    parts: Annotated[tuple[PartShare, ...] | None, "Contribution of each part of an assembly."] = None
    surface: Annotated[Surface | None, "The surface that bounds the body, when it was read from a mesh."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


class View:
    """How a body is looked at: about which point, in which axes, with which sign of products, and about which shaft.

    `rotation`: the axes of the view as columns, in the given axes; None keeps the given axes.
    """

    def __init__(
        self,
        about: str = "centroid",
        point: "Vector | None" = None,
        *,
        axes: str = "given",
        rotation: "Matrix | None" = None,
        product_sign: str = "negative",
        shaft: Shaft | None = None,
    ) -> None:
        require(
            rotation is None or axes == "given",
            "--axes principal and a rotation cannot be given together",
            code="exclusive",
            hint="leave out one of them",
        )
        self.about = about
        self.point = point
        self.axes = axes
        self.rotation = None if rotation is None else transposed(rotation)
        self.product_sign = product_sign
        self.shaft = shaft


def view_of(
    about: str,
    about_point: "Vector | None",
    turn: Turn | None,
    *,
    axes: str,
    product_sign: str,
    shaft: Shaft | None,
    points: "dict[str, Vector] | None" = None,
    called: str = "{}",
) -> View:
    """The view that a task's parameters ask for; `points` are further reference points by name, `called` so."""
    words, point = _reference(about, about_point, points or {}, called)
    rotation = None if turn is None else matrix_of(turn)
    return View(words, point, axes=axes, rotation=rotation, product_sign=product_sign, shaft=shaft)


def _reference(
    about: str, about_point: "Vector | None", points: "dict[str, Vector]", called: str
) -> "tuple[str, Vector | None]":
    """The name of the reference point, and the point: None for the mass centre."""
    if about_point is not None:
        require(
            about == "centroid",
            "two reference points are given: --about {read} and --about-point",
            code="exclusive",
            hint="give one of them",
            read=repr(about),
        )
        return "the given point", about_point
    about = "centroid" if about not in points and about.lower() in CENTROID else about
    if about in points and about not in ("centroid", "origin"):
        return called.format(about), points[about]
    require(
        about in ("centroid", "origin"),
        "there is no reference point {read}",
        code="reference",
        hint="give centroid, origin{names}, or a point by --about-point",
        names="".join(f", {name}" for name in points),
        read=repr(about),
    )
    return about, None if about == "centroid" else (0.0, 0.0, 0.0)


def properties(
    lump: Lump,
    view: View,
    *,
    volume: float | None = None,
    area: float | None = None,
    length: float | None = None,
    spread: Spread | None = None,
    cancellation: Cancellation | None = None,
    standard_uncertainty: Deviation | None = None,
    parts: tuple[PartShare, ...] | None = None,
    checks: tuple[Check, ...] = (),
    advice: tuple[Advice, ...] = (),
    numerics: Numerics | None = None,
) -> MassProperties:
    """Report a body in a `view`; `spread` if principal second moments are known better than from `lump`.

    Raises InadmissibleError when the mass is zero.
    """
    require(lump.mass > 0.0, "a mass of {mass:6} has no mass centre", code="no-mass", mass=(lump.mass, Mass))
    principal = spread or spread_of(lump.second)
    words, rotation = _axes(view, principal)
    point = lump.centroid if view.point is None else view.point
    at_point = lump.second if view.point is None else about(lump, view.point)
    tensor = tensor_of(turned(at_point, rotation))
    moments = tuple(tensor[i][i] for i in range(3))
    flipped = view.product_sign == "positive"
    return MassProperties(
        mass=lump.mass,
        volume=volume,
        area=area,
        length=length,
        centroid=lump.centroid,
        about=view.about,
        reference_point=point,
        axes=words,
        product_sign=f"{view.product_sign}: Ixy = {'+' if flipped else '-'}∫ x y dm",
        moments=AxisMoments(*moments),
        products=_products(tensor, flipped=flipped),
        tensor=tensor,
        radii_of_gyration=each(lambda moment: root(moment / lump.mass), moments),
        second_moments=tuple(each(lambda x: minus(minus(x)), row) for row in turned(lump.second, rotation)),  # type: ignore[arg-type]
        principal_moments=PrincipalMoments(*principal.moments),
        principal_axes=principal.axes,
        degeneracy=principal.degeneracy,
        principal_radii=each(lambda moment: root(moment / lump.mass), principal.moments),
        ellipsoid_axes=ellipsoid(principal.moments),
        equivalent_ellipsoid=each(lambda part: root(5.0 * part / lump.mass), principal.seconds),
        equivalent_box=each(lambda part: root(12.0 * part / lump.mass), principal.seconds),
        shaft=None if view.shaft is None else shaft_moment(lump, view.shaft),
        cancellation=cancellation,
        standard_uncertainty=standard_uncertainty,
        parts=parts,
        checks=checks,
        advice=advice,
        numerics=Numerics("closed form" if numerics is None else numerics.method, principal.axes_bound()),
    )


def _products(tensor: "Matrix", *, flipped: bool) -> AxisProducts:
    products = (tensor[0][1], tensor[1][2], tensor[2][0])
    return AxisProducts(*(minus(part) if flipped else part for part in products))


def _axes(view: View, principal: Spread) -> "tuple[str, Matrix]":
    if view.axes == "principal":
        # results are about the axes that are shown, which are doubles
        only_in_doubles(*principal.axes[0])
        return "principal", principal.axes
    if view.rotation is not None:
        return "turned", view.rotation
    return "given", IDENTITY
