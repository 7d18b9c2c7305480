"""Inputs of references of bodies, written as trees of the program's records."""

from typing import Any

TURNS = {"rotation_axis": "AxisAngle", "euler_angles": "Euler", "quaternion": "ByQuaternion"}
AMOUNTS = {"mass": "OfMass", "density": "OfDensity"}
# Sizes that may be given in several ways: the field of the shape, and the record of the way used here.
ALTERNATIVES = {
    "radius": ("size", "Radius"),
    "ring_radius": ("ring", "RingRadius"),
    "base_radius": ("taper", "Radii"),
    "top_radius": ("taper", "Radii"),
    "thickness": ("wall", "Thickness"),
}
WALLED = ("annulus", "hollow-sphere", "hollow-hemisphere", "hollow-cylinder")
OWN = ("parts", "position", "centroid", "tensor", "subtract", "rotation_angle", "euler_order", *TURNS, *AMOUNTS)


def written(tree: Any) -> Any:
    """Doubles as text that reads back to the same bits, and words marked as such."""
    if isinstance(tree, float):
        return repr(tree)
    if isinstance(tree, str):
        return {"word": tree}
    if isinstance(tree, dict):
        return {name: written(part) for name, part in tree.items()}
    return [written(part) for part in tree] if isinstance(tree, list) else tree


def class_of(shape: str) -> str:
    """The class that a shape's name stands for."""
    return "".join(word.capitalize() for word in shape.split("-"))


def shaped(inputs: dict[str, Any]) -> dict[str, Any]:
    """A shape and how much of it there is."""
    sizes = {name: written(value) for name, value in inputs.items() if name not in (*OWN, "shape")}
    shape: dict[str, Any] = {"record": class_of(inputs["shape"])}
    for name, value in sizes.items():
        field, record = ALTERNATIVES.get(name, ("", ""))
        if field == "wall" and inputs["shape"] not in WALLED:
            field = ""
        if field:
            shape.setdefault(field, {"record": record})[name] = value
        else:
            shape[name] = value
    return {"shape": shape}


def amount(inputs: dict[str, Any]) -> dict[str, Any]:
    """Mass or density, where one is given."""
    given = [key for key in AMOUNTS if key in inputs]
    return {"amount": {"record": AMOUNTS[given[0]], given[0]: repr(inputs[given[0]])}} if given else {}


def part(inputs: dict[str, Any]) -> dict[str, Any]:
    """A part of an assembly."""
    made = shaped(inputs) if "shape" in inputs else {}
    made |= amount(inputs)
    for key, cls in TURNS.items():
        if key in inputs:
            more = {name: written(inputs[name]) for name in ("rotation_angle", "euler_order") if name in inputs}
            made["turn"] = {"record": cls, key: written(inputs[key]), **more}
    made |= {name: written(inputs[name]) for name in ("position", "centroid", "tensor", "subtract") if name in inputs}
    return {**made, "parts": [part(item) for item in inputs["parts"]]} if "parts" in inputs else made


def assembly(inputs: dict[str, Any]) -> dict[str, Any]:
    """An assembly."""
    return {"record": "Assembly", "parts": [part(item) for item in inputs["parts"]]}


def arguments(task: str, inputs: dict[str, Any]) -> dict[str, Any]:
    """What a task is given."""
    if task == "shape":
        return {**shaped(inputs), **amount(inputs)}
    if task == "body":
        return {"scene": assembly(inputs)}
    if task == "compare":
        both = {name: assembly(inputs[name]) for name in ("first", "second")}
        return {"scene": {"record": "Pair", **both}}
    if task == "tensor":
        return {"inertia": {"record": "Whole", "tensor": written(inputs["tensor"])}}
    return written(inputs)  # type: ignore[no-any-return]
