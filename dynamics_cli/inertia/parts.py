"""The parts of an assembly as a scene writes them, and the leaves they come to in the assembly's own frame."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.amount import Amount, OfMass, mass_of
from dynamics_cli.inertia.lump import IDENTITY, NOTHING, Lump, plus, product, second_of, times
from dynamics_cli.inertia.mesh.surface import LengthUnit
from dynamics_cli.inertia.rotation import Turn, matrix_of
from dynamics_cli.inertia.shapes import Shape
from dynamics_cli.inertia.spread import plain
from dynamics_cli.inertia.tensor import require_tensor
from dynamics_cli.quantities import InertiaTensor, InputFile, Mass, PartPosition, Text
from dynamics_cli.records import over_parts, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.inertia.lump import Matrix, Vector

# A measured tensor is written with few digits; one further off than this is wrong.
MEASURED_TOLERANCE = 1e-3


@record
class Part:
    """A part: a shape, a mesh, a measured body, a point mass, or an assembly of parts.

    Parameters
    ----------
    name : Text
        Its name, for tables and to refer to.
    shape : Shape
        Its shape, if it has one.
    amount : Amount
        Mass; or density, material, areal or linear density of a shape or a mesh.
    mesh : InputFile
        A closed mesh instead of a shape.
    length_unit : LengthUnit
        Unit of the mesh file's numbers; it has to be given, as the file does not say it.
    tensor : InertiaTensor
        Inertia tensor of a measured part about its mass centre, in the part's own axes [kg*m^2].
    centroid : PartPosition
        Mass centre of a measured part or a point mass, in the part's own axes [m].
    mass_std : Mass
        Standard uncertainty of the mass [kg].
    centroid_std : PartPosition
        Standard uncertainties of the mass centre's coordinates, in the part's own axes [m].
    tensor_std : InertiaTensor
        Standard uncertainties of the tensor's elements [kg*m^2].
    position : PartPosition
        Where the part's own origin lies in the frame of what it belongs to [m].
    turn : Turn
        How the part's own axes are turned in that frame.
    subtract : bool
        Take it away instead: a hole.
    parts : tuple of Part
        Parts in its own frame.
    """

    name: Text = ""
    shape: Shape | None = None
    amount: Amount | None = None
    mesh: InputFile = ""
    length_unit: LengthUnit | None = None
    tensor: InertiaTensor | None = None
    centroid: PartPosition | None = None
    mass_std: Mass | None = None
    centroid_std: PartPosition | None = None
    tensor_std: InertiaTensor | None = None
    position: PartPosition = (0.0, 0.0, 0.0)
    turn: Turn | None = None
    subtract: bool = False
    parts: "tuple[Part, ...]" = ()


class Leaf:
    """One body in the assembly's frame: its lump in its own axes, where these lie, and whether it is taken away."""

    __slots__ = ("lump", "measures", "name", "origin", "part", "rotation", "sign")

    def __init__(
        self, name: str, part: Part, lump: Lump, origin: "Vector", rotation: "Matrix", sign: float, measures: "Any"
    ) -> None:
        self.name = name
        self.part = part
        self.lump = lump
        self.origin = origin
        self.rotation = rotation
        self.sign = sign
        self.measures = measures


class Walk:
    """Gathers the leaves of an assembly and the origins of its named parts.

    `width` is how many slopes its numbers have, None when they are bare.
    """

    def __init__(self, width: int | None = None) -> None:
        self.width = width
        self.leaves: list[Leaf] = []
        self.origins: dict[str, Vector] = {}

    def into(self, parts: "tuple[Part, ...]", prefix: str, origin: "Vector", rotation: "Matrix", sign: float) -> None:
        """Every part of a list, in the frame at `origin` turned by `rotation`."""
        for index, part in enumerate(parts):
            own = prefix + (part.name or f"part {index + 1}")
            place = plus(origin, part.position if rotation is IDENTITY else times(rotation, part.position))
            turn = rotation
            if part.turn is not None:
                own_turn = matrix_of(part.turn)
                turn = own_turn if rotation is IDENTITY else product(rotation, own_turn)
            self._name(part, own, place)
            kept = -sign if part.subtract else sign
            lump, measure = lump_of(part, own, self.width)
            if lump is not None:
                self.leaves.append(Leaf(own, part, lump, place, turn, kept, measure))
            else:
                require(
                    part.parts,
                    "{0} has neither shape, mesh, tensor, mass nor parts",
                    own,
                    code="empty-part",
                    hint="give a shape with a density, a mass, or parts of its own",
                )
            self.into(part.parts, own + "/", place, turn, kept)

    def _name(self, part: Part, own: str, place: "Vector") -> None:
        if not part.name:
            return
        require(
            own not in self.origins,
            "two parts are named {0!r}",
            own,
            code="name",
            hint="give each part of an assembly a name of its own",
        )
        self.origins[own] = place


def lump_of(part: Part, own: str, width: int | None) -> "tuple[Lump | None, Any]":
    """What a part itself weighs, in its own axes, and its measure by dimension; None when it is only an assembly."""
    given = [word for word, has in (("shape", part.shape), ("mesh", part.mesh), ("tensor", part.tensor)) if has]
    require(
        len(given) < 2,
        "{0} has {1} at once",
        own,
        " and ".join(given),
        code="exclusive",
        hint="a part is one body; put others into parts of its own",
    )
    _require_measured(part, own, given)
    if part.shape is not None:
        return _shaped(part, own)
    if part.mesh:
        return _meshed(part, own, width)
    if part.amount is None:
        return None, None
    return _weighed(part, own)


def _require_measured(part: Part, own: str, given: list[str]) -> None:
    body = bool(given) or part.amount is not None
    for word in ("mass_std", "centroid_std", "tensor_std", "centroid"):
        require(
            getattr(part, word) is None or body,
            "{0} gives {1} of a body that it does not have",
            own,
            word,
            code="contradiction",
        )
    require(
        part.centroid is None or not (part.shape or part.mesh),
        "{0} gives the centroid of a body whose shape says where it is",
        own,
        code="contradiction",
        hint="move the part by its position",
    )
    require(
        part.tensor_std is None or part.tensor is not None,
        "{0} gives the uncertainty of a tensor that it does not give",
        own,
        code="contradiction",
    )


def _amount(part: Part, own: str) -> Amount:
    require(
        part.amount is not None,
        "{0} has neither mass nor density",
        own,
        code="missing",
        hint="give mass, density, material, areal-density or linear-density",
    )
    assert part.amount is not None
    return part.amount


def _shaped(part: Part, own: str) -> "tuple[Lump, Any]":
    unit = part.shape.unit()  # type: ignore[union-attr]
    dimension = part.shape.dimension  # type: ignore[union-attr]
    mass = mass_of(_amount(part, own), unit.measure, dimension, own)
    return unit.lump(mass), (dimension, unit.measure)


def _weighed(part: Part, own: str) -> "tuple[Lump, Any]":
    amount = _amount(part, own)
    require(
        isinstance(amount, OfMass),
        "{0} has a density and no shape",
        own,
        code="contradiction",
        hint="give its mass, or a shape",
    )
    mass = mass_of(amount, 0.0, 0, own)
    middle = part.centroid or (0.0, 0.0, 0.0)
    if part.tensor is None:
        return Lump(mass, middle, NOTHING), None
    require_tensor(part.tensor, MEASURED_TOLERANCE, hint=f"check the tensor of {own}, which is about its mass centre")
    return Lump(mass, middle, second_of(part.tensor)), None


def _meshed(part: Part, own: str, width: int | None) -> "tuple[Lump, Any]":
    from dynamics_cli.inertia.mesh.lift import Lift
    from dynamics_cli.inertia.mesh.measured import measured, require_closed

    require(
        part.length_unit is not None,
        "{0} is a mesh without a unit of length",
        own,
        code="missing",
        hint='length_unit = "mm", for example',
    )
    found = measured(part.mesh, shell=False)
    require_closed(found, allowed=False, part=own)
    require(found.moments.measure != 0.0, "the mesh of {0} encloses nothing", own, code="no-volume")
    lift = Lift(found, part.length_unit, width or 0)  # type: ignore[arg-type]
    volume = lift.measure()
    amount = _amount(part, own)
    mass = mass_of(amount, volume, 3, own)
    density = mass / volume if isinstance(amount, OfMass) else mass_of(amount, 1.0, 3, own)
    lump = Lump(mass, lift.centroid(), lift.second(density))
    if width is not None:
        return lump, (3, volume)
    return each_number(lump, plain, type(volume)), (3, plain(volume))


def each_number(tree: "Any", change: "Callable[[Any], Any]", kind: type = float) -> "Any":
    """A tree of records and tuples with every number of a kind changed."""
    if type(tree) is kind:
        return change(tree)
    return over_parts(tree, lambda part: each_number(part, change, kind))
