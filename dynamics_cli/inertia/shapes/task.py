"""Mass properties of one shape."""

from dynamics_cli.inertia.bodies.amount import Amount, mass_of
from dynamics_cli.inertia.bodies.properties import Axes, MassProperties, ProductSign, properties, view_of
from dynamics_cli.inertia.bodies.records import Shaft
from dynamics_cli.inertia.shapes import Shape
from dynamics_cli.inertia.shapes.rods import Rod
from dynamics_cli.numerics.orientation.rotations import Turn
from dynamics_cli.quantities import Annotated, PartPosition, Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def shape(
    shape: Annotated[
        Shape, "The shape; `dynamics inertia shapes` lists all with their sizes, a radius or diameter among them"
    ],
    /,
    *,
    amount: Annotated[
        Amount, "Mass; or density or material of a solid, areal density of a lamina or shell, linear density of a rod."
    ],
    about: Annotated[
        Text, "Reference point of moments and products: centroid, origin of the shape's own axes, or end of a rod."
    ] = "centroid",
    about_point: Annotated[PartPosition | None, "Another point to refer them to, in the shape's own axes [m]."] = None,
    axes: Annotated[Axes, "Axes of moments and products: given (the shape's own), or principal."] = Axes("given"),  # noqa: B008
    turn: Annotated[Turn | None, "How the axes of moments and products are turned from the shape's own."] = None,
    product_sign: Annotated[
        ProductSign, "Sign of products: negative (Ixy = −∫ x y dm, the tensor's element) or positive (+∫ x y dm)."
    ] = ProductSign("negative"),  # noqa: B008
    shaft: Annotated[Shaft | None, "A line to give the moment about, with WR², GD² and lbf·in·s²."] = None,
) -> MassProperties:
    """Mass, centroid, inertia tensor and principal axes of a rod, a lamina, a shell or a solid.

    Equation
    --------
    S = ∫ (r − c)(r − c)ᵀ dm; I = tr(S)·1 − S about the mass centre c, plus m (d²·1 − d dᵀ) about a point at d from it.

    Returns
    -------
    MassProperties
        The mass properties of the shape.

    Raises
    ------
    InadmissibleError
        When sizes contradict each other, a density has the wrong dimension, or the mass is zero.

    Notes
    -----
    Second moments are the state and moments their sums, so a lamina has Izz = Ixx + Iyy to the bit and no moment is
    ever negative. Hollow shapes are factored in the wall thickness, which keeps every digit of a thin wall.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 7, appendices I and II.

    Examples
    --------
    >>> from dynamics_cli.inertia.bodies.amount import OfMass
    >>> from dynamics_cli.inertia.shapes import Rod
    >>> shape(Rod(length=2.0), amount=OfMass(mass=3.0)).moments
    AxisMoments(xx=0.0, yy=1.0, zz=1.0)
    """
    unit_body = shape.unit()
    mass = mass_of(amount, unit_body.measure, shape.dimension, "the " + shape.tag[1])  # type: ignore[union-attr]
    ends = {"end": (-0.5 * shape.length, 0.0, 0.0)} if isinstance(shape, Rod) else {}
    view = view_of(about, about_point, turn, axes=axes, product_sign=product_sign, shaft=shaft, points=ends)
    measure: dict[str, Any] = {("length", "area", "volume")[shape.dimension - 1]: unit_body.measure}
    return properties(unit_body.lump(mass), view, **measure)
