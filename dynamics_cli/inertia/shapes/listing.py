"""The available shapes, as a table."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.shapes import HOLLOW, PLATES, RODS, SHELLS, SOLIDS
from dynamics_cli.quantities import Annotated, Text
from dynamics_cli.records import Advice, docstring, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

DIAMETERS = "a diameter may stand for any radius, inner_radius or inner_diameter for the thickness of a round wall"
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
