"""Mass properties as every task of this family reports them: one record, made of a lump and of how it is looked at."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.lump import (
    IDENTITY,
    Lump,
    about,
    less,
    minus,
    tensor_of,
    transposed,
    turned,
)
from dynamics_cli.inertia.mesh.surface import Surface
from dynamics_cli.inertia.spread import Spread, spread_of
from dynamics_cli.numerics.elementary import hypot, sqrt
from dynamics_cli.quantities import (
    Area,
    Direction,
    Distance,
    Inertia,
    InertiaTensor,
    Mass,
    PartPosition,
    ProductOfInertia,
    Ratio,
    SignedMass,
    Size,
    Text,
    Volume,
)
from dynamics_cli.records import Advice, Check, Choice, Measured, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.lump import Matrix, Vector

# One avoirdupois pound [kg], one foot and one inch [m], one pound-force second squared per inch [kg]; the last is lbf·s²/in.
POUND, FOOT, INCH = 0.45359237, 0.3048, 0.0254
SNAIL = POUND * 9.80665 / INCH


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
class ShaftMoment:
    """What a shaft feels of a body.

    Parameters
    ----------
    moment : Inertia
        Moment of inertia about the shaft [kg*m^2].
    radius_of_gyration : Size
        Radius of gyration about the shaft [m].
    eccentricity : Size
        Distance of the mass centre from the shaft [m].
    wr2 : Measured
        WR², weight times radius of gyration squared, as motor tables give it [lb*ft^2].
    gd2 : Measured
        GD² = 4 J, weight times diameter of gyration squared, as older metric tables give it [kg*m^2].
    inertia_lbf_in_s2 : Measured
        The moment in lbf·in·s², as motion control catalogues give it.
    """

    moment: Inertia
    radius_of_gyration: Size
    eccentricity: Size
    wr2: Measured
    gd2: Measured
    inertia_lbf_in_s2: Measured


@record
class AxisMoments:
    """Moments of inertia about three axes.

    Parameters
    ----------
    xx : Inertia
        About x [kg*m^2].
    yy : Inertia
        About y [kg*m^2].
    zz : Inertia
        About z [kg*m^2].
    """

    xx: Inertia
    yy: Inertia
    zz: Inertia


@record
class AxisProducts:
    """Products of inertia of three axes.

    Parameters
    ----------
    xy : ProductOfInertia
        Of x and y [kg*m^2].
    yz : ProductOfInertia
        Of y and z [kg*m^2].
    zx : ProductOfInertia
        Of z and x [kg*m^2].
    """

    xy: ProductOfInertia
    yz: ProductOfInertia
    zx: ProductOfInertia


@record
class PrincipalMoments:
    """Principal moments of inertia, the smallest first.

    Parameters
    ----------
    first : Inertia
        The smallest [kg*m^2].
    second : Inertia
        The one between [kg*m^2].
    third : Inertia
        The greatest [kg*m^2].
    """

    first: Inertia
    second: Inertia
    third: Inertia


@record
class PartShare:
    """What one part brings.

    Parameters
    ----------
    part : Text
        Its name, after those of the assemblies it is in.
    mass : SignedMass
        Its mass, negative for what is cut out [kg].
    centroid : PartPosition
        Its mass centre, in the given axes [m].
    moments : tuple of ProductOfInertia
        What it adds to the moments xx, yy, zz, its offset from the reference point included [kg*m^2].
    """

    part: Text
    mass: SignedMass
    centroid: PartPosition
    moments: tuple[ProductOfInertia, ...]


@record
class Cancellation:
    """How much of what the parts bring cancels: the sum of sizes over the size of the sum; digits are lost by it.

    Parameters
    ----------
    mass : Ratio
        Of the mass [-].
    moments : tuple of Ratio
        Of the moments xx, yy, zz about the reference point [-].
    """

    mass: Ratio
    moments: tuple[Ratio, ...]


@record
class Deviation:
    """Standard uncertainties that those of the measured parts lead to, in first order, the parts independent.

    Parameters
    ----------
    mass : Mass
        Of the mass [kg].
    centroid : PartPosition
        Of the mass centre's coordinates [m].
    moments : tuple of Inertia
        Of the moments xx, yy, zz about the mass centre, in the given axes [kg*m^2].
    products : tuple of Inertia
        Of the products xy, yz, zx about the mass centre, in the given axes [kg*m^2].
    principal_moments : tuple of Inertia
        Of the principal moments, their axes held [kg*m^2].
    """

    mass: Mass
    centroid: PartPosition
    moments: tuple[Inertia, ...]
    products: tuple[Inertia, ...]
    principal_moments: tuple[Inertia, ...]


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
        The inertia tensor (the matrix of the inertia dyadic) about the reference point; off the diagonal −∫ x y dm [kg*m^2].
    radii_of_gyration : tuple of Size
        √(moment/mass) about the three axes through the reference point [m].
    second_moments : InertiaTensor
        The matrix ∫ r rᵀ dm about the mass centre, in the same axes [kg*m^2].
    principal_moments : PrincipalMoments
        Principal moments about the mass centre.
    principal_axes : tuple of Direction
        Unit vectors along the principal axes, in the given axes, one a row [-].
    degeneracy : Text
        Which principal axes are not determined because moments are equal, or that all are.
    principal_radii : tuple of Size
        Radii of gyration about the principal axes [m].
    ellipsoid_axes : tuple of Ratio
        Semi-axes 1/√I of the inertia ellipsoid along the principal axes, as shares of the longest [-].
    equivalent_ellipsoid : tuple of Size
        Semi-axes along the principal axes of the solid ellipsoid of the same mass and inertia [m].
    equivalent_box : tuple of Size
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
    radii_of_gyration: tuple[Size, ...]
    second_moments: InertiaTensor
    principal_moments: PrincipalMoments
    principal_axes: tuple[Direction, ...]
    degeneracy: Text
    principal_radii: tuple[Size, ...]
    ellipsoid_axes: tuple[Ratio, ...]
    equivalent_ellipsoid: tuple[Size, ...]
    equivalent_box: tuple[Size, ...]
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
        code="reference",
        hint=f"centroid, origin{', ' + ', '.join(known) if known else ''}, or a point by about-point",
    )
    return about, None if about == "centroid" else (0.0, 0.0, 0.0)


def root(x: float) -> float:
    """√x, zero where rounding made a zero negative."""
    return sqrt(x) if x > 0.0 else 0.0


def unit(direction: "Vector") -> "Vector":
    """The unit vector along a direction; a vector along an axis keeps its exact zeros."""
    length = hypot(hypot(direction[0], direction[1]), direction[2])
    require(length > 0.0, "the direction has no length", code="direction")
    return direction[0] / length, direction[1] / length, direction[2] / length


def complement(u: "Vector") -> "tuple[Vector, Vector]":
    """Two unit vectors across `u` and across each other; exact for an axis."""
    x, y, z = u
    size = tuple(abs(part) for part in u)
    if size[0] <= size[1] and size[0] <= size[2]:
        first = (0.0, z, -y)
    elif size[1] <= size[2]:
        first = (-z, 0.0, x)
    else:
        first = (y, -x, 0.0)
    a, b, c = first = unit(first)
    return first, (y * c - z * b, z * a - x * c, x * b - y * a)


def moment_about(lump: Lump, point: "Vector", direction: "Vector") -> "tuple[float, float]":
    """Moment of inertia about a line, as the sum of two second moments across it, and the mass centre's distance."""
    moment = distance = 0.0
    d = less(lump.centroid, point)
    for e in complement(unit(direction)):
        along = turned(lump.second, (e, e, e))[0][0]
        off = e[0] * d[0] + e[1] * d[1] + e[2] * d[2]
        moment = moment + along + lump.mass * off * off
        distance = hypot(distance, off)
    return moment, distance


def shaft_moment(lump: Lump, shaft: Shaft) -> ShaftMoment:
    """Moment about a shaft in the units that people who turn shafts read."""
    moment, distance = moment_about(lump, shaft.point, shaft.direction)
    number = getattr(moment, "value", moment)
    return ShaftMoment(
        moment=moment,
        radius_of_gyration=root(moment / lump.mass),
        eccentricity=distance,
        wr2=Measured(number / (POUND * FOOT * FOOT), "lb*ft^2"),
        gd2=Measured(4.0 * number, "kg*m^2"),
        inertia_lbf_in_s2=Measured(number / (SNAIL * INCH * INCH), "lbf*in*s^2"),
    )


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
    """Report a body as `view` looks at it; `spread` when the principal second moments are known better than `lump` says.

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
        radii_of_gyration=tuple(root(moment / lump.mass) for moment in moments),
        second_moments=turned(lump.second, rotation),
        principal_moments=PrincipalMoments(*own.moments),
        principal_axes=own.axes,
        degeneracy=own.degeneracy,
        principal_radii=tuple(root(moment / lump.mass) for moment in own.moments),
        ellipsoid_axes=ellipsoid(own.moments),
        equivalent_ellipsoid=tuple(root(5.0 * part / lump.mass) for part in own.seconds),
        equivalent_box=tuple(root(12.0 * part / lump.mass) for part in own.seconds),
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
        return "principal", own.axes
    if view.rotation is not None:
        return "turned", view.rotation
    return "given", IDENTITY


def ellipsoid(moments: "tuple[float, ...]") -> "tuple[float, ...]":
    """Semi-axes 1/√I over the longest; a body without inertia about an axis has an ellipsoid that is a line."""
    least = moments[0]
    if not least > 0.0:
        return tuple(1.0 if not moment > 0.0 else 0.0 for moment in moments)
    return tuple(root(least / moment) for moment in moments)
