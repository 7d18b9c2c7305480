"""The available shapes, as a table."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.shapes import HOLLOW, PLATES, RODS, SHELLS, SOLIDS
from dynamics_cli.quantities import Annotated, Text
from dynamics_cli.records import Advice, docstring, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

DIAMETERS = "a diameter may stand for any radius, inner_radius or inner_diameter for the thickness of a round wall"
# The symbols of sizes in the formulas.
LETTERS = {
    "mass": "m", "radius": "R", "length": "L", "height": "h", "width": "w", "depth": "d", "thickness": "t"
}  # fmt: skip
GROUPS = (("rod", RODS), ("lamina", PLATES), ("shell", SHELLS), ("solid", SOLIDS), ("hollow", HOLLOW))


@record
class ShapeRow:
    """One shape."""

    shape: Annotated[Text, "Its name."]
    kind: Annotated[Text, "Rod, lamina, shell, solid or hollow."]
    sizes: Annotated[Text, "The options that give its sizes; those in brackets may be left out."]
    frame: Annotated[Text, "Position of its axes."]
    formula: Annotated[Text, "Its centroid and moments, about the centroid unless a point is named."]


@record
class ShapeTable:
    """The shapes."""

    shapes: Annotated[tuple[ShapeRow, ...], "One row each."]
    advice: tuple[Advice, ...] = ()


def shapes(
    *, kind: Annotated[Text, "Only rods, laminae, shells, solids or hollow ones, or one shape by its name."] = ""
) -> ShapeTable:
    """The shapes by name, with their sizes, their own axes and their formulas.

    Returns
    -------
    ShapeTable
        A row for each shape.

    Raises
    ------
    InadmissibleError
        When no kind and no shape has that name.

    Examples
    --------
    >>> shapes(kind="rod").shapes[0].sizes
    'length'
    """
    kind_sought = kind.strip().lower().replace(" ", "-")
    matching = tuple(
        _row(name, cls)
        for name, members in GROUPS
        for cls in members.__args__
        if not kind_sought or kind_sought in (name, name + "s", cls.tag[1], *getattr(cls, "also", ()))
    )
    require(
        matching,
        "no kind or shape is named {read}",
        code="shape",
        hint="rod, lamina, shell, solid or hollow",
        read=repr(kind),
    )
    round_ones = any("radius" in row.sizes for row in matching)
    return ShapeTable(matching, (Advice("diameters", DIAMETERS, "note"),) if round_ones else ())


def formula(inputs: "dict[str, Any]") -> str:
    """The formula of the shape of a call, its symbols with the addresses of its sizes; empty for an unknown shape."""
    import re

    every = [cls for _, members in GROUPS for cls in members.__args__]
    shape = next((cls for cls in every if inputs.get("shape") in (cls.tag[1], *getattr(cls, "also", ()))), None)
    if shape is None:
        return ""
    sizes = {*_row("", shape).sizes.replace("-", "_").split(", "), "mass"}
    names = {letter: size for size, letter in LETTERS.items() if size in sizes}
    if "ring_radius" in sizes:
        names |= {"R": "ring_radius", "r": "radius"}
    letters = f"(?<![A-Za-z_])([{''.join(names)}])(?![A-Za-z_])"
    text = re.sub(letters, lambda match: f"{{{names[match[0]]}|{match[0]}}}", shape.formula)
    elsewhere = "about_point" in inputs or inputs.get("about", "centroid") != "centroid"
    return text + "; about a point at d from the centroid: + {mass|m}·(d²·1 − d dᵀ)" * elsewhere


def _written(name: str, annotation: "Any") -> str:
    """How a size may be given: the names of its first alternative, or its own."""
    alternatives = getattr(getattr(annotation, "inner", annotation), "__args__", ())
    return ", ".join(getattr(alternatives[0], "fields", (name,))) if alternatives else name


def _row(kind: str, cls: type) -> ShapeRow:
    names = [
        f"[{name}]" if name in cls.defaults else _written(name, cls.__annotations__[name])  # type: ignore[attr-defined]
        for name in cls.fields  # type: ignore[attr-defined]
    ]
    further = getattr(cls, "also", ())
    return ShapeRow(
        shape=cls.tag[1],  # type: ignore[attr-defined]
        kind=kind,
        sizes=", ".join(names).replace("_", "-"),
        frame=docstring(cls).partition("\n")[0].rstrip(".") + (f"; also {', '.join(further)}" if further else ""),
        formula=cls.formula,  # type: ignore[attr-defined]
    )
