"""Pictures of bodies: three views with parts, principal axes, and the ellipsoid of the same mass and inertia."""

from math import cos, pi, sin, sqrt

from dynamics_cli.inertia.assembly.parts import Walk
from dynamics_cli.inertia.shapes.wires import wires
from dynamics_cli.numerics.number import over_plain
from dynamics_cli.numerics.orientation.rotations import IDENTITY
from dynamics_cli.numerics.vectors import add, times
from dynamics_cli.pictures import Arrow, Axis, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Coordinate, Inertia, Mass

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.assembly.assembly import Assembly
    from dynamics_cli.inertia.bodies.properties import MassProperties
    from dynamics_cli.inertia.shapes.wires import Wire

VIEWS = ((0, 1, "top view"), (0, 2, "front view"), (1, 2, "side view"))
STEPS = 64
# Labels of marks closer than these shares of the body's size, along and across the text, would overlap.
CROWDED = 0.3, 0.1
# An axis seen nearly end on has no arrow.
SEEN = 0.08
# Free space around a body, and the least extent of a view, as shares of the largest extent.
ROOM, LEAST = 0.08, 0.3
BODY, HOLE, ELLIPSOID, AXES = 0, 1, 2, 3


def shape_picture(answer: "MassProperties", shape: "Any", **_: object) -> Picture:
    """A shape in its own axes."""
    return _picture(over_plain(answer), [(wires(over_plain(shape)), False)], shape.tag[1])


def body_picture(answer: "MassProperties", scene: "Assembly", **_: object) -> Picture:
    """An assembly, its holes dashed."""
    walk = Walk()
    walk.into(over_plain(scene.parts), "", (0.0, 0.0, 0.0), IDENTITY, 1.0)
    groups = []
    for leaf in walk.leaves:
        shape_wires = wires(leaf.part.shape) if leaf.part.shape is not None else []
        placed = [[add(leaf.origin, times(leaf.rotation, point)) for point in wire] for wire in shape_wires]
        groups.append((placed, leaf.sign < 0.0))
    return _picture(over_plain(answer), groups, scene.name or "assembly")


def drawn_picture(answer: "MassProperties", groups: "list[tuple[list[Wire], bool]]", title: str) -> Picture:
    """A body by given lines, in groups of material or of a hole."""
    return _picture(over_plain(answer), groups, title)


def _picture(answer: "MassProperties", groups: "list[tuple[list[Wire], bool]]", title: str) -> Picture:
    ends = _ends(answer, groups)
    panels = tuple(_panel(answer, groups, view, ends) for view in VIEWS)
    moments = answer.principal_moments
    notes: tuple[tuple[str, float, Any], ...] = (
        ("C mass centre; 1, 2, 3 principal axes", 0.0, None),
        ("m", answer.mass, Mass),
        ("I₁", moments.first, Inertia),
        ("I₂", moments.second, Inertia),
        ("I₃", moments.third, Inertia),
    )
    return Picture(panels, title, columns=3, views=True, notes=notes)


def _ends(answer: "MassProperties", groups: "list[tuple[list[Wire], bool]]") -> "list[tuple[float, float]]":
    """The ranges of the views along x, y and z."""
    reach = [sqrt(_seen(answer, k, k)) for k in range(3)]
    low = [centre - size for centre, size in zip(answer.centroid, reach, strict=True)]
    high = [centre + size for centre, size in zip(answer.centroid, reach, strict=True)]
    points = [point for lines, _ in groups for wire in lines for point in wire]
    points += [part.centroid for part in answer.parts or ()]
    for point in points:
        if point[0] == point[0]:
            low = list(map(min, low, point))
            high = list(map(max, high, point))
    largest = max(b - a for a, b in zip(low, high, strict=True)) or 1.0
    middles = [0.5 * (a + b) for a, b in zip(low, high, strict=True)]
    halves = [0.5 * max(b - a, LEAST * largest) + ROOM * largest for a, b in zip(low, high, strict=True)]
    return [(middle - half, middle + half) for middle, half in zip(middles, halves, strict=True)]


def _panel(
    answer: "MassProperties",
    groups: "list[tuple[list[Wire], bool]]",
    view: "tuple[int, int, str]",
    ends: "list[tuple[float, float]]",
) -> Panel:
    i, j, title = view
    items: list[Curve | Mark | Arrow] = []
    # One legend is enough for three views of one body.
    named = {False: "body", True: "hole"} if view == VIEWS[1] else {}
    for lines, hole in groups:
        for wire in lines:
            x, y = [point[i] for point in wire], [point[j] for point in wire]
            label = named.pop(hole, "")
            items.append(Curve(x, y, label, style="dashed" if hole else "thin", role=HOLE if hole else BODY))
    items.append(_ellipse(answer, i, j, "ellipsoid of the same inertia" if view == VIEWS[1] else ""))
    items += _arrows(answer, i, j)
    items += _marks(answer, i, j)
    across, up = (Axis("xyz"[k], Coordinate, ends=ends[k]) for k in (i, j))
    return Panel(across, up, tuple(items), title, equal=True)


def _arrows(answer: "MassProperties", i: int, j: int) -> "list[Arrow]":
    """The principal axes, each as long as its semi-axis of the ellipsoid."""
    centroid = answer.centroid
    arrows = []
    for k in range(3):
        size, axis = answer.equivalent_ellipsoid[k], answer.principal_axes[k]
        dx, dy = size * axis[i], size * axis[j]
        if max(abs(dx), abs(dy)) > SEEN * max(answer.equivalent_ellipsoid):
            arrows.append(Arrow(centroid[i], centroid[j], dx, dy, str(k + 1), AXES))
    return arrows


def _marks(answer: "MassProperties", i: int, j: int) -> "list[Mark]":
    """Mass centres of the body and of its parts, each place marked and named once."""
    along, across = (fraction * max(answer.equivalent_ellipsoid) for fraction in CROWDED)
    places = [(answer.centroid, "C"), *((part.centroid, part.part) for part in answer.parts or ())]
    marks: list[Mark] = []
    for point, name in places:
        if all(abs(point[i] - mark.x) > along or abs(point[j] - mark.y) > across for mark in marks):
            marks.append(Mark(point[i], point[j], name))
    return marks


def _seen(answer: "MassProperties", p: int, q: int) -> float:
    """An element of Q."""
    sizes, axes = answer.equivalent_ellipsoid, answer.principal_axes
    return sum(size * size * axis[p] * axis[q] for size, axis in zip(sizes, axes, strict=True))


def _ellipse(answer: "MassProperties", i: int, j: int, label: str) -> Curve:
    """The outline of the ellipsoid Q = Σ aₖ² vₖ vₖᵀ seen along an axis: the ellipse of the block of Q in the plane."""
    xx, yy, xy = (_seen(answer, p, q) for p, q in ((i, i), (j, j), (i, j)))
    first = sqrt(xx)
    across = xy / first if first else 0.0
    rest = sqrt(max(yy - across * across, 0.0))
    turns = [2.0 * pi * k / STEPS for k in range(STEPS + 1)]
    x = [answer.centroid[i] + first * cos(t) for t in turns]
    y = [answer.centroid[j] + across * cos(t) + rest * sin(t) for t in turns]
    return Curve(x, y, label, role=ELLIPSOID)
