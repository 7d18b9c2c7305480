"""Vector polygons head to tail, components, angles and triads, to scale."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.pictures import Arrow, Axis, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Angle
from dynamics_cli.vec import kinds

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Pair = tuple[float, float]

# Roles of colours: vectors take turns in the first four, sums are black.
COLOURS, SUM = 4, 6
# An arrow this near to level or upright has its words squarely above or beside it.
FLAT = 0.12
# The oblique view of space: x towards the reader to the lower left, y to the right, z up.
FORWARD = (-0.5 * math.cos(0.6), -0.5 * math.sin(0.6))
ARC = 41


def resultant(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """The vectors head to tail with their sum; in space, from above and from the front."""
    values = [row.vector.value for row in result.parts]
    kind = kinds.scalar(result.resultant.kind)
    names = [_size(row.magnitude.value, row.angle, kind) for row in result.parts]
    total = result.resultant.value
    sum_name = worded("R = {size}", size=(result.magnitude.value, kind))
    if len(total) == 2:
        panel = _chain(values, names, total, sum_name, kind, ("x", "y"))
        return Picture((panel,), "vectors head to tail and their resultant")
    panels = []
    for (i, j), view in (((0, 1), "from above"), ((0, 2), "from the front")):
        parts = [(value[i], value[j]) for value in (_spatial(value) for value in values)]
        axes = ("xyz"[i], "xyz"[j])
        panels.append(_chain(parts, names, (total[i], total[j]), sum_name, kind, axes, view))
    return Picture(tuple(panels), "vectors head to tail and their resultant", columns=2)


def _spatial(value: "Sequence[float]") -> "tuple[float, float, float]":
    return value[0], value[1], value[2] if len(value) == 3 else 0.0


def _size(size: float, angle: "float | None", kind: "Any") -> str:
    if angle is None:
        return worded("{size}", size=(size, kind))
    return worded("{size} at {angle}", size=(size, kind), angle=(angle, Angle))


def _chain(
    values: "Sequence[Any]", names: "Sequence[str]", total: "Sequence[float]", sum_name: str, kind: "Any",
    axes: "tuple[str, str]", title: str = "",
) -> Panel:  # fmt: skip
    """Arrows from tip to tail, and the sum from the first tail to the last tip."""
    arrows: list[tuple[Pair, Pair, str, int]] = []
    x = y = 0.0
    for nth, (value, name) in enumerate(zip(values, names, strict=True)):
        arrows.append(((x, y), (value[0], value[1]), name, nth % COLOURS))
        x, y = x + value[0], y + value[1]
    arrows.append(((0.0, 0.0), (total[0], total[1]), sum_name, SUM))
    return _panel(arrows, kind, axes, title)


def _panel(
    arrows: "Sequence[tuple[Pair, Pair, str, int]]",
    kind: "Any",
    axes: "tuple[str, str]",
    title: str = "",
    more: "Sequence[Any]" = (),
) -> Panel:
    """Arrows with their labels beside them, where there is most space."""
    points = [point for (x, y), (dx, dy), _, _ in arrows for point in ((x, y), (x + dx, y + dy))]
    left, right = min(x for x, _ in points), max(x for x, _ in points)
    low, high = min(y for _, y in points), max(y for _, y in points)
    size = max(right - left, high - low) or 1.0
    visible = [arrow for arrow in arrows if math.hypot(*arrow[1]) > 1e-9 * size]
    items: list[Any] = list(more)
    for tail, step, name, role in visible:
        items.append(Arrow(*tail, *step, "", role))
        others = [(other, reach) for other, reach, _, which in visible if (other, reach, which) != (tail, step, role)]
        items.append(_beside(tail, step, name, role, others, size))
    # words stand beyond the outermost arrows: unseen corners keep room for them
    room_x, room_y = 0.3 * size, 0.08 * size
    items.append(Curve([left - room_x, right + room_x], [low - room_y, high + room_y], "", "fill", SUM))
    return Panel(Axis(axes[0], kind), Axis(axes[1], kind), tuple(items), title, equal=True)


def _beside(
    tail: "Pair", step: "Pair", name: str, role: int, others: "Sequence[tuple[Pair, Pair]]", size: float
) -> Mark:
    """Words beside an arrow, on the side and at the place that is farthest from the other arrows."""
    length = math.hypot(*step)
    ends = [tail, *(start for start, _ in others), *((x + dx, y + dy) for (x, y), (dx, dy) in others)]
    centre = sum(x for x, _ in ends) / len(ends), sum(y for _, y in ends) / len(ends)
    best: tuple[float, Pair, Pair] | None = None
    for fraction in (0.5, 0.35, 0.65):
        anchor = tail[0] + fraction * step[0], tail[1] + fraction * step[1]
        for sign in (1.0, -1.0):
            normal = -sign * step[1] / length, sign * step[0] / length
            middle = anchor[0] + (0.06 + 0.1 * abs(normal[0])) * size * normal[0], anchor[1] + 0.06 * size * normal[1]
            clearance = min((_distance(middle, *other) for other in others), default=size)
            away = normal[0] * (anchor[0] - centre[0]) + normal[1] * (anchor[1] - centre[1]) > 0.0
            score = min(clearance, 0.12 * size) - 0.02 * size * abs(fraction - 0.5) + 0.06 * size * away
            if best is None or score > best[0] + 1e-9 * size:
                best = (score, anchor, normal)
    assert best is not None
    _, anchor, normal = best
    across = 0.0 if abs(normal[0]) < FLAT else math.copysign(5.0, normal[0])
    up = 0.0 if abs(normal[1]) < FLAT else math.copysign(4.0, normal[1])
    return Mark(*anchor, name, (across, up), dot=False, role=role)


def _distance(point: "Pair", tail: "Pair", way: "Pair") -> float:
    """From a point to an arrow."""
    square = way[0] * way[0] + way[1] * way[1]
    along = ((point[0] - tail[0]) * way[0] + (point[1] - tail[1]) * way[1]) / square
    along = min(max(along, 0.0), 1.0)
    return math.hypot(point[0] - tail[0] - along * way[0], point[1] - tail[1] - along * way[1])


def angle(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """The two directions from one point with the angle between, in the plane that they span."""
    turn = abs(result.angle)
    arrows = [((0.0, 0.0), (1.0, 0.0), "first", 0), ((0.0, 0.0), (math.cos(turn), math.sin(turn)), "second", 1)]
    steps = [turn * i / (ARC - 1) for i in range(ARC)]
    arc = Curve([0.3 * math.cos(t) for t in steps], [0.3 * math.sin(t) for t in steps], "", "thin", SUM)
    name = worded("{angle}", angle=(turn, Angle))
    label = Label(0.45 * math.cos(0.5 * turn), 0.45 * math.sin(0.5 * turn), name, SUM)
    panel = _panel(arrows, kinds.NUMBER, ("", ""), "", (arc, label))
    plane = Panel(panel.x, panel.y, panel.items, equal=True, bare=True)
    return Picture(
        (plane,), "the angle between two vectors, in their plane", subtitle="directions only: both of unit length"
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
    flat = len(value) == 2 and all(len(part) == 2 for part, _ in parts)

    def drawn(view: "Any") -> "list[tuple[Pair, Pair, str, int]]":
        tip = (0.0, 0.0)
        arrows: list[tuple[Pair, Pair, str, int]] = []
        for nth, (part, name) in enumerate(parts):
            step = view(part)
            arrows.append((tip, step, name, nth % COLOURS))
            tip = tip[0] + step[0], tip[1] + step[1]
        return [*arrows, ((0.0, 0.0), view(value), size, SUM)]

    if flat:
        return Picture((_panel(drawn(lambda part: (part[0], part[1])), kind, ("x", "y")),), "a vector and its parts")
    panels = []
    for (i, j), title in (((0, 1), "from above"), ((0, 2), "from the front")):
        arrows = drawn(lambda part, i=i, j=j: (_spatial(part)[i], _spatial(part)[j]))
        panels.append(_panel(arrows, kind, ("xyz"[i], "xyz"[j]), title))
    return Picture(tuple(panels), "a vector and its parts", columns=2)


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
        panels.append(_chain(values, names, total, sum_name, kind, ("x", "y"), title))
    return Picture(tuple(panels), "vector polygon", columns=len(panels))


def _seen(v: "Sequence[float]") -> "Pair":
    """Space seen obliquely: x comes towards the reader, y goes to the right, z up."""
    return v[1] + FORWARD[0] * v[0], v[2] + FORWARD[1] * v[0]


def _axes(reach: float) -> "list[Any]":
    """The axes of space, named at their ends."""
    # an unseen line keeps the name of Z off the title
    items: list[Any] = [Curve([0.0, 0.0], [0.0, 1.4 * reach], "", "fill", SUM)]
    asides = ((-6.0, 4.0), (4.0, 4.0), (4.0, 4.0))
    for name, axis, aside in zip("XYZ", ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), asides, strict=True):
        x, y = _seen([1.25 * reach * part for part in axis])
        items += [Curve([0.0, x], [0.0, y], "", "centre", SUM), Mark(x, y, name, aside, dot=False, role=SUM)]
    return items


def _line(points: "Sequence[Sequence[float]]", style: "Any", role: int) -> Curve:
    """A line through points of space."""
    pairs = [_seen(point) for point in points]
    return Curve([x for x, _ in pairs], [y for _, y in pairs], "", style, role)


def _scene(items: "Sequence[Any]", title: str, subtitle: str) -> Picture:
    panel = Panel(Axis(""), Axis(""), tuple(items), equal=True, bare=True)
    return Picture((panel,), title, subtitle=subtitle)


def _arrow(v: "Sequence[float]", name: str, role: int) -> "list[Any]":
    """An arrow from the origin with its name beyond its tip."""
    x, y = _seen(v)
    aside = math.copysign(6.0, x), math.copysign(5.0, y)
    return [Arrow(0.0, 0.0, x, y, "", role), Mark(x, y, name, aside, dot=False, role=role)]


def _unit(v: "Sequence[float]") -> "tuple[float, ...]":
    size = math.hypot(*v) or 1.0
    return tuple(part / size for part in v)


def direction(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """The direction in the axes, over its shadow on the X-Y plane."""
    v = _unit(_spatial(result.vector.value))
    name = worded("{size}", size=(result.magnitude.value, kinds.scalar(result.magnitude.kind)))
    shadow = [(0.0, 0.0, 0.0), (v[0], v[1], 0.0), v]
    steps = [(v[0], 0.0, 0.0), (v[0], v[1], 0.0), (0.0, v[1], 0.0)]
    lines_ = [_line(points, "thin", SUM) for points in (shadow, steps)]
    return _scene([*_axes(1.0), *lines_, *_arrow(v, name, 0)], "a direction in space", "seen obliquely; unit length")


def product(result: "Any", first: "Any", second: "Any", third: "Any" = None, /) -> Picture:
    """The factors and their vector product, as directions."""
    items = _axes(1.0)
    factors = [("a", first), ("b", second), *([("c", third)] if third is not None else [])]
    for role, (name, vector) in enumerate(factors):
        items += _arrow(_unit(_spatial(getattr(vector, "value", vector))), name, role)
    if any(result.vector_product.value):
        items += _arrow(_unit(result.vector_product.value), "a×b", 3)
    return _scene(items, "the vectors and their vector product", "seen obliquely; directions only, of unit length")


def lines(result: "Any", *, first: "Any", second: "Any", **_: "Any") -> Picture:
    """Points, lines and planes with their shortest connection, obliquely."""
    starts = [_spatial(getattr(item.point, "value", item.point)) for item in (first, second)]
    ends = [item.value for item in (result.first_foot, result.second_foot, result.intersection) if item is not None]
    middle = [sum(point[i] for point in (*starts, *ends)) / len((*starts, *ends)) for i in range(3)]
    reach = max([math.dist(point, middle) for point in (*starts, *ends)]) or 1.0
    items: list[Any] = []
    for role, (name, item, point) in enumerate(zip(("first", "second"), (first, second), starts, strict=True)):
        x, y = _seen(point)
        aside = (6.0, 6.0) if role else (-6.0, -6.0)
        items.append(Mark(x, y, name, aside, role=role))
        direction = _way(item, point)
        if direction is None:
            continue
        u = _unit(direction)
        if item.normal is not None:
            items.append(_patch(point, u, reach, role))
        else:
            feet = (result.first_foot, result.second_foot)[role] or result.intersection
            far = max(1.3 * reach, math.dist(feet.value, point) + 0.3 * reach) if feet is not None else 1.3 * reach
            points = [[p + t * far * q for p, q in zip(point, u, strict=True)] for t in (-1.0, 1.0)]
            items.append(_line(points, "solid", role))
    if result.first_foot is not None and result.distance.value > 0.0:
        (x0, y0), (x1, y1) = _seen(result.first_foot.value), _seen(result.second_foot.value)
        items.append(Curve([x0, x1], [y0, y1], "", "thick", SUM))
        name = worded("{size}", size=(result.distance.value, kinds.scalar(result.distance.kind)))
        items.append(Mark(0.5 * (x0 + x1), 0.5 * (y0 + y1), name, (6.0, -4.0), dot=False, role=SUM))
    if result.intersection is not None:
        items.append(Mark(*_seen(result.intersection.value), "they meet", (6.0, -8.0), role=SUM))
    return _scene(items, f"relative position: {result.relation}", "seen obliquely; black: the shortest connection")


def _way(item: "Any", point: "Sequence[float]") -> "tuple[float, ...] | None":
    vector = item.direction or item.normal or item.to
    if vector is None:
        return None
    value = _spatial(getattr(vector, "value", vector))
    return tuple(b - a for a, b in zip(point, value, strict=True)) if vector is item.to else value


def _patch(point: "Sequence[float]", n: "Sequence[float]", reach: float, role: int) -> Curve:
    """A square of a plane about a point."""
    helper = (1.0, 0.0, 0.0) if abs(n[0]) < 0.7 else (0.0, 1.0, 0.0)
    u = _unit([n[1] * helper[2] - n[2] * helper[1], n[2] * helper[0] - n[0] * helper[2],
               n[0] * helper[1] - n[1] * helper[0]])  # fmt: skip
    v = (n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0])
    corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)]
    points = [[p + 1.2 * reach * (s * a + t * b) for p, a, b in zip(point, u, v, strict=True)] for s, t in corners]
    return _line(points, "filled", role)


def frame(result: "Any", *_: "Any", x: "Any" = None, y: "Any" = None, z: "Any" = None, **__: "Any") -> Picture:
    """The triad in the old axes, seen obliquely, with the directions given as dashed lines."""
    items = _axes(1.0)
    for role, (name, axis) in enumerate((("x", result.x_axis), ("y", result.y_axis), ("z", result.z_axis))):
        items += _arrow(axis.value, name, role)
    for role, direction in enumerate((x, y, z)):
        if direction is not None:
            a, b = _seen(_unit(_spatial(getattr(direction, "value", direction))))
            items.append(Curve([0.0, a], [0.0, b], "", "dashed", role))
    return _scene(items, "the triad x, y, z in the axes X, Y, Z", "seen obliquely; dashed: directions as given")
