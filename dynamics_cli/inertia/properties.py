"""Mass properties as every task of this family reports them: one record, made of a lump and of how it is looked at."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.lines import shaft_moment
from dynamics_cli.inertia.lump import (
    IDENTITY,
    Lump,
    about,
    each,
    minus,
    tensor_of,
    transposed,
    turned,
)
from dynamics_cli.inertia.mesh.surface import Surface
from dynamics_cli.inertia.results import (
    AxisMoments,
    AxisProducts,
    Cancellation,
    Deviation,
    PartShare,
    PrincipalMoments,
    ShaftMoment,
)
from dynamics_cli.inertia.spread import Spread, ellipsoid, root, spread_of
from dynamics_cli.numerics.elementary import only_in_doubles
from dynamics_cli.quantities import (
    Area,
    Direction,
    Distance,
    InertiaTensor,
    Mass,
    PartLengths,
    PartPosition,
    Text,
    Vector,
    Volume,
)
from dynamics_cli.records import Advice, Check, Choice, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.lump import Matrix


class Axes(Choice):
    """The axes that results are given in."""

    names = ("given", "principal")


class ProductSign(Choice):
    """What a product of inertia means: minus the integral of x y (the tensor's element), or plus."""

    names = ("negative", "positive")
    aliases = {"minus": "negative", "plus": "positive"}  # noqa: RUF012


@record
class Shaft:
    """A line to turn about.

    Parameters
    ----------
    direction : Direction
        Direction of the shaft, in the given axes, of any length [-].
    point : PartPosition
        A point of the shaft; the origin when not given [m].
    """

    direction: Direction
    point: PartPosition = (0.0, 0.0, 0.0)


@record
class MassProperties:
    """Mass, mass centre and inertia of a body.

    Parameters
    ----------
    mass : Mass
        Mass [kg].
    volume : Volume
        Volume of a solid [m^3].
    area : Area
        Area of a lamina or a thin shell [m^2].
    length : Size
        Length of a thin rod [m].
    centroid : PartPosition
        Mass centre, in the given axes from the given origin [m].
    about : Text
        What the moments and products are about.
    reference_point : PartPosition
        That point, in the given axes from the given origin [m].
    axes : Text
        The axes of moments, products, tensor and second moments.
    product_sign : Text
        What the products mean.
    moments : AxisMoments
        Moments of inertia about the reference point.
    products : AxisProducts
        Products of inertia about the reference point, of the sign that `product_sign` says.
    tensor : InertiaTensor
        The inertia tensor (the dyadic's matrix) about the reference point; off the diagonal −∫ x y dm [kg*m^2].
    radii_of_gyration : PartLengths
        √(moment/mass) about the three axes through the reference point [m].
    second_moments : InertiaTensor
        The matrix ∫ r rᵀ dm about the mass centre, in the same axes [kg*m^2].
    principal_moments : PrincipalMoments
        Principal moments about the mass centre.
    principal_axes : tuple of Direction
        Unit vectors along the principal axes, in the given axes, one a row [-].
    degeneracy : Text
        Which principal axes are not determined because moments are equal, or that all are.
    principal_radii : PartLengths
        Radii of gyration about the principal axes [m].
    ellipsoid_axes : Vector
        Semi-axes 1/√I of the inertia ellipsoid along the principal axes, as shares of the longest [-].
    equivalent_ellipsoid : PartLengths
        Semi-axes along the principal axes of the solid ellipsoid of the same mass and inertia [m].
    equivalent_box : PartLengths
        Sides along the principal axes of the solid box of the same mass and inertia [m].
    shaft : ShaftMoment
        What turning about the shaft takes, when one is given.
    cancellation : Cancellation
        How much cancels between material and holes, when something is cut out.
    standard_uncertainty : Deviation
        Standard uncertainties, when parts were measured with some.
    parts : tuple of PartShare
        What each part of an assembly brings.
    surface : Surface
        The surface that bounds the body, when it was read from a mesh.
    """

    mass: Mass
    volume: Volume | None
    area: Area | None
    length: Distance | None
    centroid: PartPosition
    about: Text
    reference_point: PartPosition
    axes: Text
    product_sign: Text
    moments: AxisMoments
    products: AxisProducts
    tensor: InertiaTensor
    radii_of_gyration: PartLengths
    second_moments: InertiaTensor
    principal_moments: PrincipalMoments
    principal_axes: tuple[Direction, ...]
    degeneracy: Text
    principal_radii: PartLengths
    ellipsoid_axes: Vector
    equivalent_ellipsoid: PartLengths
    equivalent_box: PartLengths
    shaft: ShaftMoment | None = None
    cancellation: Cancellation | None = None
    standard_uncertainty: Deviation | None = None
    parts: tuple[PartShare, ...] | None = None
    surface: Surface | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


class View:
    """How a body is looked at: about which point, in which axes, with which sign of products, and about which shaft.

    `rotation` is that of the axes looked along, its columns, from the given ones; None keeps these.
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
            "both principal axes and turned axes are asked for",
            code="exclusive",
            hint="leave out the rotation, or ask for given axes",
        )
        self.about = about
        self.point = point
        self.axes = axes
        self.rotation = None if rotation is None else transposed(rotation)
        self.product_sign = product_sign
        self.shaft = shaft


def named_point(
    about: str, about_point: "Vector | None", parts: "dict[str, Vector] | None" = None
) -> "tuple[str, Vector | None]":
    """The words for a reference point, and the point: None for the mass centre."""
    if about_point is not None:
        require(
            about == "centroid",
            "both a point and {0!r} are asked for as reference",
            about,
            each,
            code="exclusive",
            hint="give about or about-point",
        )
        return "the given point", about_point
    known = parts or {}
    if about in known and about not in ("centroid", "origin"):
        return f"the origin of part {about}", known[about]
    require(
        about in ("centroid", "origin"),
        "there is nothing named {0!r} to refer to",
        about,
        each,
        code="reference",
        hint=f"centroid, origin{', ' + ', '.join(known) if known else ''}, or a point by about-point",
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
    """Report a body as `view` looks at it; `spread` when principal second moments are known better than by `lump`.

    Raises
    ------
    InadmissibleError
        When there is no mass.
    """
    require(lump.mass > 0.0, "a mass of {0:.6g} kg has no mass centre", lump.mass, code="no-mass")
    own = spread or spread_of(lump.second)
    words, rotation = _axes(view, own)
    point = lump.centroid if view.point is None else view.point
    at_point = lump.second if view.point is None else about(lump, view.point)
    tensor = tensor_of(turned(at_point, rotation))
    moments = tuple(tensor[i][i] for i in range(3))
    products = (tensor[0][1], tensor[1][2], tensor[2][0])
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
        products=AxisProducts(*(minus(part) if flipped else part for part in products)),
        tensor=tensor,
        radii_of_gyration=each(lambda moment: root(moment / lump.mass), moments),
        second_moments=tuple(each(lambda x: minus(minus(x)), row) for row in turned(lump.second, rotation)),  # type: ignore[arg-type]
        principal_moments=PrincipalMoments(*own.moments),
        principal_axes=own.axes,
        degeneracy=own.degeneracy,
        principal_radii=each(lambda moment: root(moment / lump.mass), own.moments),
        ellipsoid_axes=ellipsoid(own.moments),
        equivalent_ellipsoid=each(lambda part: root(5.0 * part / lump.mass), own.seconds),
        equivalent_box=each(lambda part: root(12.0 * part / lump.mass), own.seconds),
        shaft=None if view.shaft is None else shaft_moment(lump, view.shaft),
        cancellation=cancellation,
        standard_uncertainty=standard_uncertainty,
        parts=parts,
        checks=checks,
        advice=advice,
        numerics=numerics,
    )


def _axes(view: View, own: Spread) -> "tuple[str, Matrix]":
    if view.axes == "principal":
        # results are about the axes that are shown, which are doubles
        only_in_doubles(*own.axes[0])
        return "principal", own.axes
    if view.rotation is not None:
        return "turned", view.rotation
    return "given", IDENTITY
