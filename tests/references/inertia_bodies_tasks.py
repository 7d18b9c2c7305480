"""Inputs of inertia_bodies.json as the program's records, and its answers with their bounds by address."""

from typing import Any

from dynamics_cli.inertia.amount import OfDensity, OfMass
from dynamics_cli.inertia.assembly import Assembly, body, compose_scene
from dynamics_cli.inertia.parts import Part, each_number
from dynamics_cli.inertia.rotation import AxisAngle, ByQuaternion, Euler
from dynamics_cli.inertia.shape import shape
from dynamics_cli.inertia.shapes import Shape
from dynamics_cli.inertia.shapes.polygon import Vertex
from dynamics_cli.inertia.shapes.shells import Ends
from dynamics_cli.inertia.spread import Spread
from dynamics_cli.inertia.tensor import Whole, tensor
from dynamics_cli.inertia.torque import torque
from dynamics_cli.numerics.tracked import Tracked

BY_NAME = {cls.tag[1]: cls for cls in Shape.__args__}
NAMES = ("first", "second", "third")


def plain(tree: Any) -> Any:
    """Text as doubles."""
    if isinstance(tree, str):
        return float(tree)
    return tuple(plain(item) for item in tree) if isinstance(tree, list) else tree


def shape_of(inputs: dict[str, Any]) -> Any:
    cls = BY_NAME[inputs["shape"]]
    made = {}
    for name in cls.fields:
        if name == "ends":
            made[name] = Ends(inputs[name])
        elif name == "vertices":
            made[name] = tuple(Vertex(plain(v["x"]), plain(v["y"])) for v in inputs[name])
        else:
            made[name] = plain(inputs[name]) if name in inputs else cls.defaults[name]
    return cls(**made)


def amount_of(inputs: dict[str, Any]) -> Any:
    if "mass" in inputs:
        return OfMass(plain(inputs["mass"]))
    return OfDensity(plain(inputs["density"])) if "density" in inputs else None


def turn_of(inputs: dict[str, Any]) -> Any:
    if "rotation_axis" in inputs:
        return AxisAngle(plain(inputs["rotation_axis"]), plain(inputs["rotation_angle"]))
    if "euler_angles" in inputs:
        return Euler(plain(inputs["euler_angles"]), inputs["euler_order"])
    return ByQuaternion(plain(inputs["quaternion"])) if "quaternion" in inputs else None


def part_of(inputs: dict[str, Any]) -> Part:
    more = {name: plain(inputs[name]) for name in ("position", "tensor", "centroid") if name in inputs}
    return Part(
        shape=shape_of(inputs) if "shape" in inputs else None,
        amount=amount_of(inputs),
        turn=turn_of(inputs),
        subtract=bool(inputs.get("subtract")),
        parts=tuple(part_of(item) for item in inputs.get("parts", [])),
        **more,
    )


def tracked(tree: Any) -> Any:
    return each_number(tree, lambda x: Tracked(x, 0.0, ()))


def by_address(record: Any, address: str) -> Any:
    """A result by its address: `moments.xx`, `centroid[0]`."""
    if address == "measure":
        return next(x for x in (record.volume, record.area, record.length) if x is not None)
    for name in address.replace("]", "").replace("[", ".").split("."):
        record = record[int(name)] if name.isdigit() else getattr(record, name)
    return record


class _Whole:
    """A composed assembly under the names of a report."""

    def __init__(self, lump: Any, spread: Spread) -> None:
        from dynamics_cli.inertia.results import AxisMoments, AxisProducts, PrincipalMoments

        rows = lump.second
        from dynamics_cli.inertia.lump import tensor_of

        full = tensor_of(rows)
        self.mass, self.centroid = lump.mass, lump.centroid
        self.moments = AxisMoments(full[0][0], full[1][1], full[2][2])
        self.products = AxisProducts(full[0][1], full[1][2], full[2][0])
        self.principal_moments = PrincipalMoments(*spread.moments)


def answers(task: str, inputs: dict[str, Any]) -> tuple[Any, Any]:
    """The plain answer and the one whose numbers carry their bounds."""
    if task == "shape":
        own, amount = shape_of(inputs), amount_of(inputs)
        return shape(own, amount=amount), shape(tracked(own), amount=tracked(amount))
    if task == "tensor":
        matrix = plain(inputs["tensor"])
        return tensor(inertia=Whole(matrix)), tensor(inertia=Whole(tracked(matrix)))
    if task == "torque":
        given = {name: plain(value) for name, value in inputs.items()}
        return torque(**given), torque(**{name: tracked(value) for name, value in given.items()})
    scene = Assembly(parts=tuple(part_of(item) for item in inputs["parts"]))
    whole = compose_scene(tracked(scene))
    return body(scene), _Whole(whole.lump, whole.spread)
