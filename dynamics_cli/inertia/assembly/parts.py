"""The parts of an assembly as written in a scene, and the resulting leaves in the assembly's frame."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.bodies.amount import Amount, OfMass, mass_of
from dynamics_cli.inertia.bodies.mass_moments import NOTHING, Lump, second_of
from dynamics_cli.inertia.mesh.surface import LengthUnit
from dynamics_cli.inertia.shapes import Shape
from dynamics_cli.inertia.tensors.tensor import require_tensor
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.orientation.rotations import IDENTITY, Turn, matrix_of, product
from dynamics_cli.numerics.vectors import add, times
from dynamics_cli.quantities import Annotated, Direction, InertiaTensor, InputFile, Mass, PartPosition, Text
from dynamics_cli.records import over_parts, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.inertia.bodies.mass_moments import Matrix, Vector

# A measured tensor has few digits; one farther off than this is wrong.
MEASURED_TOLERANCE = 1e-3


@record
class ZAxis:
    """A part turned the shortest way from the z-axis, along which cylinders and tubes lie."""

    z_axis: Annotated[Direction, "Where the part's own z-axis points, of any length, e.g. 1, 0, 1."]

    @property
    def matrix(self) -> "Matrix":
        """The rotation that takes (0, 0, 1) to a unit vector (a, b, c) = ±(a, b, |c|)."""
        x, y, z = self.z_axis
        length = sqrt(x * x + y * y + z * z)
        require(length > 0.0, "the z-axis has no length", code="rotation", hint="for example 1, 0, 1")
        sign = 1.0 if plain(z) >= 0.0 else -1.0
        a, b, c = (sign * component / length for component in (x, y, z))
        over = 1.0 / (1.0 + c)
        return (
            (1.0 - a * a * over, -sign * a * b * over, sign * a),
            (-a * b * over, sign * (1.0 - b * b * over), sign * b),
            (-a, -sign * b, sign * c),
        )


@record
class Part:
    """A part: a shape, a mesh, a measured body, a point mass, or an assembly of parts."""

    name: Annotated[Text, "Its name, in tables and for --about, e.g. rim."] = ""
    shape: Annotated[
        Shape | None, "Its shape; `dynamics inertia shapes` lists all with their sizes, e.g. cylinder."
    ] = None
    amount: Annotated[Amount | None, "Its mass, or the density of its shape or mesh, e.g. material."] = None
    mesh: Annotated[InputFile, "A closed mesh instead of a shape, e.g. part.stl."] = ""
    length_unit: Annotated[LengthUnit | None, "Unit of the mesh file's numbers; a 3MF file states its own."] = None
    tensor: Annotated[
        InertiaTensor | None,
        "Inertia tensor of a measured part about its mass centre, in the part's own axes [kg*m^2].",
    ] = None
    centroid: Annotated[
        PartPosition | None, "Mass centre of a measured part or a point mass, in the part's own axes [m]."
    ] = None
    mass_std: Annotated[Mass | None, "Standard uncertainty of the mass, e.g. 0.05 kg."] = None
    centroid_std: Annotated[
        PartPosition | None,
        "Standard uncertainties of the mass centre's coordinates, in the part's own axes, e.g. 1, 1, 2 mm.",
    ] = None
    tensor_std: Annotated[
        InertiaTensor | None,
        "Standard uncertainties of the tensor's elements, e.g. [[0.02, 0, 0], [0, 0.02, 0], [0, 0, 0.02]] kg*m^2.",
    ] = None
    position: Annotated[PartPosition, "Place of the part's origin in the frame that it belongs to [m]."] = (
        0.0,
        0.0,
        0.0,
    )
    turn: Annotated[Turn | ZAxis | None, "How the part's own axes are turned in that frame."] = None
    subtract: Annotated[
        bool, "Subtract the part, as a hole; unless given, its density is that of the body before it."
    ] = False
    parts: Annotated["tuple[Part, ...]", "Parts in its own frame."] = ()


class Leaf:
    """One body in the assembly's frame: its lump, the position of the lump's axes, and whether it is subtracted."""

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
    """Gathers the leaves of an assembly, in its frame, and the origins of named parts.

    `width` is the number of derivatives of its numbers, None if they are plain.
    """

    def __init__(self, width: int | None = None) -> None:
        self.width = width
        self.leaves: list[Leaf] = []
        self.origins: dict[str, Vector] = {}

    def into(
        self,
        parts: "tuple[Part, ...]",
        prefix: str,
        origin: "Vector",
        rotation: "Matrix",
        sign: float,
        stuff: Amount | None = None,
    ) -> None:
        """Every part of a list, in the frame at `origin` turned by `rotation`.

        A hole without a density has that of the body before it or around it: `stuff`.
        """
        for index, part in enumerate(parts):
            label = prefix + (part.name or f"part {index + 1}")
            place = add(origin, part.position if rotation is IDENTITY else times(rotation, part.position))
            turn = rotation
            if part.turn is not None:
                own_turn = part.turn.matrix if isinstance(part.turn, ZAxis) else matrix_of(part.turn)
                turn = own_turn if rotation is IDENTITY else product(rotation, own_turn)
            self._name(part, label, place)
            part_sign = -sign if part.subtract else sign
            amount = part.amount
            if amount is None and part.subtract and (part.shape or part.mesh):
                amount = stuff
            elif amount is not None and not isinstance(amount, OfMass):
                stuff = amount
            properties, measure = lump_of(part, amount, label, self.width)
            if properties is not None:
                self.leaves.append(Leaf(label, part, properties, place, turn, part_sign, measure))
            else:
                require(
                    part.parts,
                    "{part} has neither shape, mesh, tensor, mass nor parts",
                    code="empty-part",
                    hint="give a shape with a density, a mass, or parts of its own",
                    part=label,
                )
            if part.parts:
                self.into(part.parts, label + "/", place, turn, part_sign, stuff)

    def _name(self, part: Part, label: str, place: "Vector") -> None:
        if not part.name:
            return
        require(
            label not in self.origins,
            "two parts are named {part}",
            code="name",
            hint="give each part of an assembly a name of its own",
            part=repr(label),
        )
        self.origins[label] = place


def lump_of(part: Part, amount: Amount | None, label: str, width: int | None) -> "tuple[Lump | None, Any]":
    """The mass properties of a part in its own axes, and its measure by dimension; None if it is only an assembly."""
    bodies = [word for word, has in (("shape", part.shape), ("mesh", part.mesh), ("tensor", part.tensor)) if has]
    require(
        len(bodies) < 2,
        "{part} has {given} together",
        code="exclusive",
        hint="a part is one body; give further bodies as parts within it",
        part=label,
        given=" and ".join(bodies),
    )
    _require_measured(part, label, body=bool(bodies) or amount is not None)
    if amount is None:
        require(
            not bodies,
            "{part} has neither mass nor density",
            code="missing",
            hint="give mass, density, material, areal-density or linear-density",
            part=label,
        )
        return None, None
    if part.shape is not None:
        return _shaped(part, amount, label)
    if part.mesh:
        return _meshed(part, amount, label, width)
    return _weighed(part, amount, label)


def _require_measured(part: Part, label: str, *, body: bool) -> None:
    for word in ("mass_std", "centroid_std", "tensor_std", "centroid"):
        require(
            getattr(part, word) is None or body,
            "{part} gives {field} without a body",
            code="contradiction",
            part=label,
            field=word,
        )
    require(
        part.centroid is None or not (part.shape or part.mesh),
        "{part} gives a centroid, which its shape already determines",
        code="contradiction",
        hint="move the part by its position",
        part=label,
    )
    require(
        part.tensor_std is None or part.tensor is not None,
        "{part} gives tensor_std without a tensor",
        code="contradiction",
        part=label,
    )


def _shaped(part: Part, amount: Amount, label: str) -> "tuple[Lump, Any]":
    unit = part.shape.unit()  # type: ignore[union-attr]
    dimension = part.shape.dimension  # type: ignore[union-attr]
    mass = mass_of(amount, unit.measure, dimension, label)
    return unit.lump(mass), (dimension, unit.measure)


def _weighed(part: Part, amount: Amount, label: str) -> "tuple[Lump, Any]":
    require(
        isinstance(amount, OfMass),
        "{part} has a density and no shape",
        code="contradiction",
        hint="give its mass, or a shape",
        part=label,
    )
    mass = mass_of(amount, 0.0, 0, label)
    middle = part.centroid or (0.0, 0.0, 0.0)
    if part.tensor is None:
        return Lump(mass, middle, NOTHING), None
    require_tensor(part.tensor, MEASURED_TOLERANCE, hint=f"check the tensor of {label}, which is about its mass centre")
    return Lump(mass, middle, second_of(part.tensor)), None


def _meshed(part: Part, amount: Amount, label: str, width: int | None) -> "tuple[Lump, Any]":
    from dynamics_cli.inertia.mesh.measurement import measured, require_closed, require_extent, unit_of
    from dynamics_cli.inertia.mesh.tracked_integrals import Lift

    readings = measured(part.mesh, shell=False)
    require_closed(readings, allowed=False, part=label)
    require_extent(readings, shell=False, part=label)
    lift = Lift(readings, unit_of(readings, part.length_unit, label), width or 0)
    volume = lift.measure()
    mass = mass_of(amount, volume, 3, label)
    density = mass / volume if isinstance(amount, OfMass) else mass_of(amount, 1.0, 3, label)
    properties = Lump(mass, lift.centroid(), lift.second(density))
    if width is not None:
        return properties, (3, volume)
    return each_number(properties, plain, type(volume)), (3, plain(volume))


def each_number(tree: "Any", change: "Callable[[Any], Any]", kind: type = float) -> "Any":
    """A tree of records and tuples with every number of a kind changed."""
    if type(tree) is kind:
        return change(tree)
    return over_parts(tree, lambda part: each_number(part, change, kind))
