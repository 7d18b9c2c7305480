"""Mass properties of an assembly of shapes, meshes, measured parts, point masses and holes."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.compose import composed
from dynamics_cli.inertia.lump import IDENTITY
from dynamics_cli.inertia.parts import Part, Walk, each_number
from dynamics_cli.inertia.properties import Axes, MassProperties, ProductSign, Shaft, View, named_point
from dynamics_cli.inertia.report import reported
from dynamics_cli.inertia.rotation import Turn, matrix_of
from dynamics_cli.inertia.spread import plain
from dynamics_cli.numerics.elementary import only_in_doubles
from dynamics_cli.quantities import PartPosition, Text
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.compose import Composed

# Beyond this many numbers the derivatives by all of them are left out, and beyond this many parts the rounding bound:
# they would take longer than the answer.
MOST_SLOPES = 150
BOUNDED_PARTS = 2000


@record
class Assembly:
    """An assembly.

    Parameters
    ----------
    name : Text
        Its name.
    parts : tuple of Part
        Its parts.
    """

    parts: tuple[Part, ...]
    name: Text = ""


def body(
    scene: Assembly,
    /,
    *,
    about: Text = "centroid",
    about_point: PartPosition | None = None,
    axes: Axes = Axes("given"),  # noqa: B008
    turn: Turn | None = None,
    product_sign: ProductSign = ProductSign("negative"),  # noqa: B008
    shaft: Shaft | None = None,
) -> MassProperties:
    """Mass, centroid, inertia tensor and principal axes of an assembly of parts and holes.

    Equation
    --------
    m = Σ mᵢ, c = Σ mᵢ cᵢ/m, S = Σ Rᵢ Sᵢ Rᵢᵀ + mᵢ (cᵢ − c)(cᵢ − c)ᵀ, holes with negative mᵢ and Sᵢ; I = tr(S)·1 − S.

    Parameters
    ----------
    scene : Assembly
        The parts: shapes, meshes, measured bodies, point masses, and assemblies of them.
    about : Text
        What moments and products are about: centroid, origin, or the name of a part for that part's origin.
    about_point : PartPosition
        Another point to refer them to, in the assembly's frame [m].
    axes : Axes
        Axes of moments and products: given (the assembly's), or principal.
    turn : Turn
        How the axes of moments and products are turned from the assembly's.
    product_sign : ProductSign
        Sign of products: negative (Ixy = −∫ x y dm, the tensor's element) or positive (+∫ x y dm).
    shaft : Shaft
        A line to give the moment about, with WR², GD² and lbf·in·s².

    Returns
    -------
    MassProperties
        Everything about the assembly's mass, a row for each part, what cancels, and standard uncertainties.

    Raises
    ------
    InadmissibleError
        When a part contradicts itself, a rotation is none, a tensor is one no body has, or holes leave no body.

    Notes
    -----
    Positions count from the first part, and moments from the mass centre found first, so that an assembly far from
    its origin keeps its digits. The principal moments come from a second pass in the principal frame, which keeps
    those of a needle in any position. Bounds are a running error analysis of the same operations (Higham 3.3).
    Standard uncertainties are first order, of independent parts, as mass property engineers roll them up (SAWE RP 16
    and paper 3360); about the mass centre the terms through the centroid vanish.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 7.6 to 7.9.

    Examples
    --------
    >>> from dynamics_cli.inertia.amount import OfMass
    >>> ball = Part(amount=OfMass(mass=1.0), position=(1.0, 0.0, 0.0))
    >>> other = Part(amount=OfMass(mass=3.0), position=(5.0, 0.0, 0.0))
    >>> answer = body(Assembly(parts=(ball, other)))
    >>> answer.moments
    AxisMoments(xx=0.0, yy=12.0, zz=12.0)
    """
    whole = compose_scene(scene)
    if not whole.sloped:
        about_point, turn, shaft = each_number((about_point, turn, shaft), plain, _tracked())
    words, point = named_point(about, about_point, whole.origins)
    view = View(
        words,
        point,
        axes=axes,
        rotation=None if turn is None else matrix_of(turn),
        product_sign=product_sign,
        shaft=shaft,
    )
    return reported(whole, view)


def _tracked() -> type:
    from dynamics_cli.numerics.tracked import Tracked

    return Tracked


def compose_scene(scene: Assembly) -> "Composed":
    """Put an assembly together; tracked numbers carry their rounding along, and their slopes where these are few."""
    number = _first_number(scene.parts)
    if _has_mesh(scene.parts):
        # a mesh is integrated in doubles, whatever the numbers beside it
        only_in_doubles(number)
    slopes = getattr(number, "slopes", None)
    given = None if slopes is None else len(slopes)
    parts, width = _carried(scene.parts, given)
    walk = Walk(width)
    walk.into(parts, "", (0.0, 0.0, 0.0), IDENTITY, 1.0)
    require(walk.leaves, "the assembly has no body", code="empty")
    return composed(walk, asked=given is not None)


def _carried(parts: "tuple[Part, ...]", width: int | None) -> "tuple[tuple[Part, ...], int | None]":
    """The parts with as much on their numbers as is worth its time, and how many slopes that is (None: bare)."""
    from dynamics_cli.numerics.tracked import Tracked

    if width is None or width <= MOST_SLOPES:
        return parts, width
    if _count(parts) > BOUNDED_PARTS:
        return each_number(parts, plain, Tracked), None
    return each_number(parts, lambda x: Tracked(x.value, 0.0, ()), Tracked), 0


def _first_number(tree: "Any") -> "Any":
    """The first number of a tree that carries something along; None when all are bare."""
    if tree is None or type(tree) is float:
        return None
    if hasattr(tree, "apply"):
        return tree
    if isinstance(tree, tuple):
        found = map(_first_number, tree)
    elif hasattr(tree, "fields"):
        found = map(_first_number, (getattr(tree, name) for name in tree.fields))
    else:
        return None
    return next((number for number in found if number is not None), None)


def _has_mesh(parts: "tuple[Part, ...]") -> bool:
    return any(part.mesh or _has_mesh(part.parts) for part in parts)


def _count(parts: "tuple[Part, ...]") -> int:
    return sum(1 + _count(part.parts) for part in parts)
