"""Vector polygons head to tail, components, angles and triads, to scale."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.numerics.vectors import cross
from dynamics_cli.pictures import Axis, Curve, Label, Mark, Panel, Picture
from dynamics_cli.pictures.vectors import (
    SUM,
    Step,
    beside,
    corner,
    curve,
    from_above,
    head_to_tail,
    labelled,
    numbers,
    scene,
    seen,
    square,
    times,
    tipped,
    unit,
)
from dynamics_cli.quantities import Angle
from dynamics_cli.vec import kinds

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

ARC = 41
ORIGIN = (0.0, 0.0, 0.0)
# Views of space, with the axes that they show.
VIEWS = ((from_above, "xy", "from above"), (lambda v: (v[0], v[2]), "xz", "from the front"))


def resultant(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """The vectors head to tail with their sum; in space, from above and from the front."""
    kind = kinds.scalar(result.resultant.kind)
    names = [_size(row.magnitude.value, row.angle, kind) for row in result.parts]
    sum_name = worded("R = {size}", size=(result.magnitude.value, kind))
    values = [row.vector.value for row in result.parts]
    return _chains(values, names, result.resultant.value, sum_name, kind, "vectors head to tail and their resultant")


def _size(size: float, angle: "float | None", kind: "Any") -> str:
    if angle is None:
        return worded("{size}", size=(size, kind))
    return worded("{size} at {angle}", size=(size, kind), angle=(angle, Angle))


def _chains(
    values: "Sequence[Any]", names: "Sequence[str]", total: "Sequence[float]", sum_name: str, kind: "Any", title: str
) -> Picture:
    """Arrows from tip to tail with their sum; in space, from above and from the front."""
    flat = all(len(value) == 2 for value in (*values, total))
    panels = []
    for view, axes, words in VIEWS[: 1 if flat else 2]:
        ways = [view(numbers(value)) for value in values]
        sum_ = Step((0.0, 0.0), view(numbers(total)), sum_name, SUM)
        panels.append(_plane(labelled(head_to_tail(ways, names, sum_)), kind, axes, "" if flat else words))
    return Picture(tuple(panels), title, columns=len(panels))


def _plane(items: "Sequence[Any]", kind: "Any", axes: str = "xy", title: str = "") -> Panel:
    return Panel(Axis(axes[0], kind), Axis(axes[1], kind), tuple(items), title, equal=True)


def angle(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """The two directions from one point with the angle between, in the plane that they span."""
    turn = abs(result.angle)
    arrows = (Step((0.0, 0.0), (1.0, 0.0), "first", 0), Step((0.0, 0.0), (math.cos(turn), math.sin(turn)), "second", 1))
    steps = [turn * i / (ARC - 1) for i in range(ARC)]
    arc = Curve([0.3 * math.cos(t) for t in steps], [0.3 * math.sin(t) for t in steps], "", "thin", SUM)
    name = worded("{angle}", angle=(turn, Angle))
    label = Label(0.45 * math.cos(0.5 * turn), 0.45 * math.sin(0.5 * turn), name, SUM)
    return _scene(
        [*labelled(arrows), arc, label],
        "the angle between two vectors, in their plane",
        "directions only: both of unit length",
    )


def resolve(result: "Any", vector: "Any", **_: "Any") -> Picture:
    """A vector and its parts."""
    value = getattr(vector, "value", vector)
    kind = kinds.scalar(getattr(vector, "kind", kinds.NUMBER))
    if result.components is not None:
        parts = [(row.part.value, worded("{size}", size=(row.component.value, kind))) for row in result.components]
    else:
        along, across = (result.part_along, result.part_across) if result.component is not None else (
            result.part_out_of_plane, result.part_in_plane)  # fmt: skip
        names = ("along", "across") if result.component is not None else ("along the normal", "in the plane")
        parts = [
            (part.value, worded("{size} " + name, size=(math.hypot(*part.value), kind)))
            for part, name in zip((along, across), names, strict=True)
        ]
    size = worded("{size}", size=(math.hypot(*value), kind))
    return _chains(
        [part for part, _ in parts], [name for _, name in parts], value, size, kind, "a vector and its parts"
    )


def polygon(result: "Any", *known: "Any", sum_: "Any" = None, **_: "Any") -> Picture:
    """Every solution: the known vectors, the two solved for, and their sum."""
    kind = kinds.scalar(result.missing.kind)
    panels = []
    for nth, solution in enumerate(result.solutions, 1):
        values = [getattr(each, "value", each) for each in known]
        names = [_size(math.hypot(*value), math.atan2(value[1], value[0]), kind) for value in values]
        values += [solution.first.value, solution.second.value]
        names += [_size(solution.first_magnitude.value, solution.first_angle, kind)]
        names += [_size(solution.second_magnitude.value, solution.second_angle, kind)]
        total = getattr(sum_, "value", sum_) or (0.0, 0.0)
        sum_name = worded("sum {size}", size=(math.hypot(*total), kind))
        title = f"solution {nth}" if len(result.solutions) > 1 else ""
        items = labelled(head_to_tail(values, names, Step((0.0, 0.0), tuple(total), sum_name, SUM)))
        panels.append(_plane(items, kind, title=title))
    return Picture(tuple(panels), "vector polygon", columns=len(panels))


def _axes() -> "list[Any]":
    """The axes of space, named at their ends."""
    # an unseen line keeps the name of Z off the title
    items: list[Any] = [Curve([0.0, 0.0], [0.0, 1.3], "", "fill", SUM)]
    for name, axis in zip("XYZ", ((1.15, 0.0, 0.0), (0.0, 1.15, 0.0), (0.0, 0.0, 1.15)), strict=True):
        x, y = seen(axis)
        items += [
            curve((ORIGIN, axis), "centre"),
            Mark(x, y, name, (-6.0 if x < 0.0 else 4.0, 4.0), dot=False, role=SUM),
        ]
    return items


def _scene(items: "Sequence[Any]", title: str, subtitle: str) -> Picture:
    return Picture((scene(items),), title, subtitle=subtitle)


def direction(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """The direction in the axes, over its shadow on the X-Y plane, with its components."""
    kind = kinds.scalar(result.magnitude.kind)
    components = numbers(result.vector)
    v = unit(components)
    x, y = v[:2]
    corners = (ORIGIN, (x, 0.0, 0.0), (x, y, 0.0), v)
    items = [*_axes(), curve(((0.0, y, 0.0), (x, y, 0.0), ORIGIN), "thin")]
    for nth, (name, part) in enumerate(zip("xyz", components, strict=True)):
        items.append(curve(corners[nth : nth + 2], "thin"))
        if part:
            middle = seen([0.5 * (a + b) for a, b in zip(*corners[nth : nth + 2], strict=True)])
            label = worded(name + " = {part}", part=(part, kind))
            items.append(
                Mark(*middle, label, (-5.0, 4.0) if nth == 0 and part > 0.0 else (5.0, -5.0), dot=False, role=SUM)
            )
    items += tipped(v, worded("{size}", size=(result.magnitude.value, kind)), 0)
    return _scene(items, "a direction in space", "seen obliquely; the arrow is of unit length")


def product(result: "Any", first: "Any", second: "Any", third: "Any" = None, /) -> Picture:
    """The factors and their vector product, as directions."""
    items = _axes()
    factors = [("a", first), ("b", second), *([("c", third)] if third is not None else [])]
    for role, (name, vector) in enumerate(factors):
        items += tipped(unit(numbers(vector)), name, role)
    if any(result.vector_product.value):
        items += tipped(unit(result.vector_product.value), "a×b", 3)
    return _scene(items, "the vectors and their vector product", "seen obliquely; directions only, of unit length")


def lines(result: "Any", *, first: "Any", second: "Any", **_: "Any") -> Picture:
    """Points, lines and planes with their shortest connection, obliquely, beside the axes."""
    starts = [numbers(item.point) for item in (first, second)]
    feet = [item.value if item is not None else None for item in (result.first_foot, result.second_foot)]
    meeting = result.intersection.value if result.intersection is not None else None
    known = [*starts, *(point for point in (*feet, meeting) if point is not None)]
    middle = [sum(point[i] for point in known) / len(known) for i in range(3)]
    reach = max(math.dist(point, middle) for point in known) or 1.0
    items: list[Any] = []
    for role, (name, item, point) in enumerate(zip(("first", "second"), (first, second), starts, strict=True)):
        flat = item.normal is not None or item.third is not None
        if not (flat or item.direction is not None or item.to is not None):
            items.append(Mark(*seen(point), name, role=role))
            continue
        beyond = [times(-1.0, point, numbers(other)) for other in (item.to, item.third) if other is not None]
        u = unit(cross(*beyond) if len(beyond) > 1 else beyond[0] if beyond else numbers(item.direction or item.normal))
        foot = feet[role] or meeting
        far = max(1.3 * reach, math.dist(foot, point) + 0.3 * reach if foot else 0.0)
        end = times(-far, u, point)
        if flat:
            items.append(square(point, u, max(1.2 * reach, 1.2 * math.dist(point, meeting) if meeting else 0.0), role))
        else:
            items.append(curve((end, times(far, u, point)), "solid", role))
        items += [
            Mark(*seen(point), "", role=role),
            Mark(*seen(point if flat else end), name, (4.0, -5.0), dot=False, role=role),
        ]
    if result.first_foot is not None and result.distance.value > 0.0:
        name = worded("{size}", size=(result.distance.value, kinds.scalar(result.distance.kind)))
        ends = [seen(foot) for foot in (result.first_foot.value, result.second_foot.value)]
        step = Step(ends[0], (ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]), name, SUM)
        items += [curve(ends, "thick", view=from_above), beside(step, (), reach)]
    if meeting is not None and result.common_direction is not None:
        way = unit(result.common_direction.value)
        items.append(curve((times(-1.2 * reach, way, meeting), times(1.2 * reach, way, meeting)), "thick"))
    elif meeting is not None:
        items.append(Mark(*seen(meeting), "they meet", (6.0, -8.0), role=SUM))
    shown = "; black: the shortest connection" if result.distance.value > 0.0 else ""
    return _scene([*items, *corner(items)], f"relative position: {result.relation}", f"seen obliquely{shown}")


def frame(result: "Any", *points: "Any", **directions: "Any") -> Picture:
    """The triad in the old axes, seen obliquely, with the directions given as dashed lines."""
    items = _axes()
    given = [numbers(directions[name]) if directions.get(name) is not None else None for name in "xyz"]
    if points:
        given = [times(-1.0, numbers(points[0]), numbers(point)) for point in points[1:]]
    for role, (name, axis) in enumerate(zip("xyz", (result.x_axis, result.y_axis, result.z_axis), strict=True)):
        items += tipped(axis.value, name, role)
    for role, direction in enumerate(given):
        if direction is not None:
            items.append(curve((ORIGIN, unit(direction)), "dashed", role))
    return _scene(items, "the triad x, y, z in the axes X, Y, Z", "seen obliquely; dashed: directions as given")
