"""Pictures of bodies: three views with parts, principal axes, and the ellipsoid of the same mass and inertia."""

from math import cos, pi, sin, sqrt

from dynamics_cli.inertia.lump import IDENTITY, plus, times
from dynamics_cli.inertia.parts import Walk
from dynamics_cli.inertia.report import bare
from dynamics_cli.inertia.wires import wires
from dynamics_cli.pictures import Arrow, Axis, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Coordinate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.assembly import Assembly
    from dynamics_cli.inertia.properties import MassProperties
    from dynamics_cli.inertia.wires import Wire

VIEWS = ((0, 1), (0, 2), (1, 2))
STEPS = 64
# Marks closer than these shares of the body's size, along and across a name, would be written over one another.
CROWDED = 1.0, 0.2
# An axis that is seen end on has no arrow.
SEEN = 1e-3
BODY, HOLE, ELLIPSOID, AXES = 0, 1, 2, 3


def shape_picture(answer: "MassProperties", shape: "Any", **_: object) -> Picture:
    """A shape in its own axes."""
    return _picture(bare(answer), [(wires(bare(shape)), False)], shape.tag[1])


def body_picture(answer: "MassProperties", scene: "Assembly", **_: object) -> Picture:
    """An assembly, its holes dashed."""
    walk = Walk()
    walk.into(bare(scene.parts), "", (0.0, 0.0, 0.0), IDENTITY, 1.0)
    drawn = []
    for leaf in walk.leaves:
        own = wires(leaf.part.shape) if leaf.part.shape is not None else []
        placed = [[plus(leaf.origin, times(leaf.rotation, point)) for point in wire] for wire in own]
        drawn.append((placed, leaf.sign < 0.0))
    return _picture(bare(answer), drawn, scene.name)


def drawn_picture(answer: "MassProperties", drawn: "list[tuple[list[Wire], bool]]", title: str) -> Picture:
    """A body by lines of its own, each group of them of material or of a hole."""
    return _picture(bare(answer), drawn, title)


def _picture(answer: "MassProperties", drawn: "list[tuple[list[Wire], bool]]", title: str) -> Picture:
    panels = tuple(_panel(answer, drawn, i, j) for i, j in VIEWS)
    return Picture(panels, title, columns=3)


def _panel(answer: "MassProperties", drawn: "list[tuple[list[Wire], bool]]", i: int, j: int) -> Panel:
    items: list[Curve | Mark | Arrow] = []
    for lines, hole in drawn:
        for wire in lines:
            x, y = [point[i] for point in wire], [point[j] for point in wire]
            items.append(Curve(x, y, style="dashed" if hole else "thin", role=HOLE if hole else BODY))
    # One legend is enough for three views of one body.
    items.append(_ellipse(answer, i, j, "ellipsoid of the same inertia" if (i, j) == VIEWS[1] else ""))
    at = answer.centroid
    for k in range(3):
        size, axis = answer.equivalent_ellipsoid[k], answer.principal_axes[k]
        dx, dy = size * axis[i], size * axis[j]
        if max(abs(dx), abs(dy)) > SEEN * answer.equivalent_ellipsoid[0]:
            items.append(Arrow(at[i], at[j], dx, dy, str(k + 1), AXES))
    items += _marks(answer, i, j)
    names = "xyz"
    return Panel(
        Axis(names[i], Coordinate), Axis(names[j], Coordinate), tuple(items), f"{names[i]}{names[j]}", equal=True
    )


def _marks(answer: "MassProperties", i: int, j: int) -> "list[Mark]":
    """The mass centre and those of the parts, each place marked and named once."""
    along, across = (share * max(answer.equivalent_ellipsoid) for share in CROWDED)
    places = [(answer.centroid, "mass centre"), *((part.centroid, part.part) for part in answer.parts or ())]
    kept: list[Mark] = []
    for at, name in places:
        if all(abs(at[i] - mark.x) > along or abs(at[j] - mark.y) > across for mark in kept):
            kept.append(Mark(at[i], at[j], name))
    return kept


def _ellipse(answer: "MassProperties", i: int, j: int, label: str) -> Curve:
    """The outline of the ellipsoid Q = Σ aₖ² vₖ vₖᵀ seen along an axis: that of the block of Q in the plane."""
    a = [size * size for size in answer.equivalent_ellipsoid]
    v = answer.principal_axes
    xx, yy, xy = (sum(a[k] * v[k][p] * v[k][q] for k in range(3)) for p, q in ((i, i), (j, j), (i, j)))
    first = sqrt(xx)
    across = xy / first if first else 0.0
    rest = sqrt(max(yy - across * across, 0.0))
    turns = [2.0 * pi * k / STEPS for k in range(STEPS + 1)]
    x = [answer.centroid[i] + first * cos(t) for t in turns]
    y = [answer.centroid[j] + across * cos(t) + rest * sin(t) for t in turns]
    return Curve(x, y, label, role=ELLIPSOID)
