"""Mass properties of an assembly of shapes, meshes, measured parts, point masses and holes."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.assembly.parts import Part, Walk, each_number
from dynamics_cli.inertia.assembly.report import reported
from dynamics_cli.inertia.bodies.compose import composed
from dynamics_cli.inertia.bodies.properties import Axes, MassProperties, ProductSign, view_of
from dynamics_cli.inertia.bodies.records import Shaft
from dynamics_cli.numerics.elementary import only_in_doubles
from dynamics_cli.numerics.number import carriers, plain
from dynamics_cli.numerics.orientation.rotations import IDENTITY, Turn
from dynamics_cli.quantities import Annotated, PartPosition, Text
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.bodies.compose import Composed

# With more numbers than this the derivatives are left out, and with more parts than this the rounding bound: they
# would take longer than the answer.
MOST_SLOPES = 150
BOUNDED_PARTS = 2000


@record
class Assembly:
    """An assembly."""

    parts: Annotated[tuple[Part, ...], "Its parts."]
    name: Annotated[Text, "Its name, e.g. flywheel."] = ""


def body(
    scene: Annotated[Assembly, "The parts: shapes, meshes, measured bodies, point masses, and assemblies of them."],
    /,
    *,
    about: Annotated[
        Text, "Reference point of moments and products: centroid, origin, or the name of a part for its origin."
    ] = "centroid",
    about_point: Annotated[PartPosition | None, "Another point to refer them to, in the assembly's frame [m]."] = None,
    axes: Annotated[Axes, "Axes of moments and products: given (the assembly's), or principal."] = Axes("given"),  # noqa: B008
    turn: Annotated[Turn | None, "How the axes of moments and products are turned from the assembly's."] = None,
    product_sign: Annotated[
        ProductSign, "Sign of products: negative (Ixy = −∫ x y dm, the tensor's element) or positive (+∫ x y dm)."
    ] = ProductSign("negative"),  # noqa: B008
    shaft: Annotated[Shaft | None, "A shaft to give the moment about, also as WR², GD² and lbf·in·s²."] = None,
) -> MassProperties:
    """Mass, centroid, inertia tensor and principal axes of an assembly of parts and holes.

    Equation
    --------
    m = Σ mᵢ, c = Σ mᵢ cᵢ/m, S = Σ Rᵢ Sᵢ Rᵢᵀ + mᵢ (cᵢ − c)(cᵢ − c)ᵀ, holes with negative mᵢ and Sᵢ; I = tr(S)·1 − S.

    Returns
    -------
    MassProperties
        The assembly's mass properties, a row for each part, cancellation, and standard uncertainties.

    Raises
    ------
    InadmissibleError
        When a part is contradictory, a rotation or a tensor is impossible, or the holes leave no mass.

    Notes
    -----
    Positions count from the first part, and moments from a previously calculated mass centre, so that an assembly
    far from its origin keeps its digits. The principal moments come from a second pass in the principal frame, which
    keeps those of a needle in any position. Bounds are a running error analysis of the same operations (Higham 3.3).
    Standard uncertainties are first order, of independent parts, as mass property engineers roll them up (SAWE RP 16
    and paper 3360); about the mass centre the terms through the centroid vanish.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 7.6 to 7.9.

    Examples
    --------
    >>> from dynamics_cli.inertia.bodies.amount import OfMass
    >>> ball = Part(amount=OfMass(mass=1.0), position=(1.0, 0.0, 0.0))
    >>> other = Part(amount=OfMass(mass=3.0), position=(5.0, 0.0, 0.0))
    >>> answer = body(Assembly(parts=(ball, other)))
    >>> answer.moments
    AxisMoments(xx=0.0, yy=12.0, zz=12.0)
    """
    assembly = compose_scene(scene)
    if not assembly.sloped:
        about_point, turn, shaft = each_number((about_point, turn, shaft), plain, _tracked())
    view = view_of(
        about,
        about_point,
        turn,
        axes=axes,
        product_sign=product_sign,
        shaft=shaft,
        points=assembly.origins,
        called="the origin of part {}",
    )
    return reported(assembly, view)


def _tracked() -> type:
    from dynamics_cli.numerics.tracked import Tracked

    return Tracked


def compose_scene(scene: Assembly) -> "Composed":
    """Compose an assembly; tracked numbers carry their rounding, and their derivatives if these are few."""
    number = next(carriers(scene.parts), None)
    if _has_mesh(scene.parts):
        # a mesh is integrated in doubles, also beside numbers of other types
        only_in_doubles(number)
    slopes = getattr(number, "slopes", None)
    slope_count = None if slopes is None else len(slopes)
    parts, width = _carried(scene.parts, slope_count)
    walk = Walk(width)
    walk.into(parts, "", (0.0, 0.0, 0.0), IDENTITY, 1.0)
    require(walk.leaves, "the assembly has no body", code="empty")
    return composed(walk, asked=slope_count is not None)


def _carried(parts: "tuple[Part, ...]", width: int | None) -> "tuple[tuple[Part, ...], int | None]":
    """The parts with affordable bounds and derivatives, and the number of derivatives (None: plain numbers)."""
    from dynamics_cli.numerics.tracked import Tracked

    if width is None or width <= MOST_SLOPES:
        return parts, width
    if _count(parts) > BOUNDED_PARTS:
        return each_number(parts, plain, Tracked), None
    return each_number(parts, lambda x: Tracked(x.value, 0.0, ()), Tracked), 0


def _has_mesh(parts: "tuple[Part, ...]") -> bool:
    return any(part.mesh or _has_mesh(part.parts) for part in parts)


def _count(parts: "tuple[Part, ...]") -> int:
    return sum(1 + _count(part.parts) for part in parts)
