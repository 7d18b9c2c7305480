"""Vectors as arrows with words beside them, and space as it is drawn on paper."""

import math

from dynamics_cli.pictures import Arrow, Axis, Curve, Label, Mark, Panel
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Pair = tuple[float, float]
    Vector = tuple[float, float, float]

# Roles of colours: vectors take turns in the first four, sums are black; what lies behind is grey.
COLOURS, SUM, GREY = 4, 6, 6
# An arrow this near to level or upright has its words squarely above or beside it.
FLAT = 0.12
# A share of the longest vector that does not show.
HIDDEN = 1e-9
# Where the eye is that looks at space: azimuth and elevation.
AZIMUTH, ELEVATION = math.radians(32.0), math.radians(24.0)
STEPS = 96


@record
class Step:
    """An arrow with words beside it."""

    tail: "Pair"
    way: "Pair"
    name: str
    role: int
    dashed: bool = False

    @property
    def tip(self) -> "Pair":
        """Where it ends."""
        return self.tail[0] + self.way[0], self.tail[1] + self.way[1]


def head_to_tail(ways: "Sequence[Sequence[float]]", names: "Sequence[str]", total: "Step") -> "list[Step]":
    """Arrows from tip to tail, and their sum."""
    steps: list[Step] = []
    for nth, (way, name) in enumerate(zip(ways, names, strict=True)):
        steps.append(Step(steps[-1].tip if steps else (0.0, 0.0), (way[0], way[1]), name, nth % COLOURS))
    return [*steps, total]


def labelled(steps: "Sequence[Step]") -> "list[Any]":
    """Arrows with their words beside them, where there is most space."""
    points = [point for step in steps for point in (step.tail, step.tip)]
    left, right = min(x for x, _ in points), max(x for x, _ in points)
    low, high = min(y for _, y in points), max(y for _, y in points)
    size = max(right - left, high - low) or 1.0
    visible = [step for step in steps if math.hypot(*step.way) > HIDDEN * size]
    arrows: list[Any] = [Arrow(*step.tail, *step.way, "", step.role, step.dashed) for step in visible]
    marks: list[Mark] = []
    for step in visible:
        marks.append(beside(step, [other for other in visible if other is not step], size, marks))
    # words stand beyond the outermost arrows: unseen corners keep room for them
    room_x, room_y = 0.3 * size, 0.08 * size
    return [*arrows, *marks, Curve([left - room_x, right + room_x], [low - room_y, high + room_y], "", "fill", SUM)]


def beside(step: Step, others: "Sequence[Step]", size: float, marks: "Sequence[Mark]" = ()) -> Mark:
    """Words beside an arrow, on the side and at the place that is farthest from the other arrows and their words."""
    length = math.hypot(*step.way)
    ends = [step.tail, *(end for other in others for end in (other.tail, other.tip))]
    centre = sum(x for x, _ in ends) / len(ends), sum(y for _, y in ends) / len(ends)
    best: tuple[float, Pair, Pair] | None = None
    for fraction in (0.5, 0.35, 0.65):
        anchor = step.tail[0] + fraction * step.way[0], step.tail[1] + fraction * step.way[1]
        for sign in (1.0, -1.0):
            normal = -sign * step.way[1] / length, sign * step.way[0] / length
            middle = anchor[0] + (0.06 + 0.1 * abs(normal[0])) * size * normal[0], anchor[1] + 0.06 * size * normal[1]
            clearance = min((_distance(middle, other) for other in others), default=size)
            away = normal[0] * (anchor[0] - centre[0]) + normal[1] * (anchor[1] - centre[1]) > 0.0
            score = min(clearance, 0.12 * size) - 0.02 * size * abs(fraction - 0.5) + 0.06 * size * away
            # words of arrows that coincide take different sides
            score -= (
                0.2
                * size
                * any(
                    math.hypot(anchor[0] - mark.x, anchor[1] - mark.y) < 0.2 * size
                    and normal[0] * mark.aside[0] + normal[1] * mark.aside[1] > 0.0
                    for mark in marks
                )
            )
            if best is None or score > best[0] + 1e-9 * size:
                best = (score, anchor, normal)
    assert best is not None
    _, anchor, normal = best
    across = 0.0 if abs(normal[0]) < FLAT else math.copysign(5.0, normal[0])
    up = 0.0 if abs(normal[1]) < FLAT else math.copysign(4.0, normal[1])
    return Mark(*anchor, step.name, (across, up), dot=False, role=step.role)


def _distance(point: "Pair", step: Step) -> float:
    """From a point to an arrow."""
    (x, y), (dx, dy) = step.tail, step.way
    along = ((point[0] - x) * dx + (point[1] - y) * dy) / (dx * dx + dy * dy)
    along = min(max(along, 0.0), 1.0)
    return math.hypot(point[0] - x - along * dx, point[1] - y - along * dy)


def numbers(v: "Any") -> "Vector":
    """A vector in doubles; a planar one has no height."""
    x, y, *z = (float(getattr(part, "value", part)) for part in getattr(v, "value", v))
    return x, y, z[0] if z else 0.0


def unit(v: "Sequence[float]") -> "Vector":
    """The direction of a vector."""
    size = math.hypot(*v) or 1.0
    return v[0] / size, v[1] / size, v[2] / size


def times(factor: float, v: "Sequence[float]", start: "Sequence[float]" = (0.0, 0.0, 0.0)) -> "Vector":
    """The point that a multiple of a vector reaches."""
    return start[0] + factor * v[0], start[1] + factor * v[1], start[2] + factor * v[2]


def cross(a: "Sequence[float]", b: "Sequence[float]") -> "Vector":
    """The vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def seen(v: "Sequence[float]") -> "Pair":
    """A vector on paper, seen from the first octant."""
    x, y, z = v
    right = -math.sin(AZIMUTH) * x + math.cos(AZIMUTH) * y
    inward = math.cos(AZIMUTH) * x + math.sin(AZIMUTH) * y
    return right, math.cos(ELEVATION) * z - math.sin(ELEVATION) * inward


def from_above(v: "Sequence[float]") -> "Pair":
    """A vector on paper, seen from above."""
    return v[0], v[1]


def view_of(vectors: "Sequence[Sequence[float]]") -> "Any":
    """From above when all vectors are in the plane of x and y, else from the side."""
    size = max((abs(part) for v in vectors for part in v), default=0.0)
    return from_above if all(abs(v[2]) <= HIDDEN * size for v in vectors) else seen


def arrow(
    v: "Sequence[float]", label: str, role: int, view: "Any" = seen, *, start: "Sequence[float]" = (0.0, 0.0, 0.0),
    dashed: bool = False,
) -> Arrow:  # fmt: skip
    """An arrow for a vector from a point."""
    (x, y), (dx, dy) = view(start), view(v)
    return Arrow(x, y, dx, dy, label, role, dashed=dashed)


def tipped(v: "Sequence[float]", name: str, role: int) -> "list[Any]":
    """An arrow from the origin with its name beyond its tip."""
    x, y = seen(v)
    aside = math.copysign(6.0, x), math.copysign(5.0, y)
    return [Arrow(0.0, 0.0, x, y, "", role), Mark(x, y, name, aside, dot=False, role=role)]


def curve(points: "Sequence[Sequence[float]]", style: "Any", role: int = GREY, view: "Any" = seen) -> Curve:
    """A line through points in space."""
    flat = [view(point) for point in points]
    return Curve([x for x, _ in flat], [y for _, y in flat], style=style, role=role)


def words(at: "Sequence[float]", text: str, role: int = GREY, view: "Any" = seen) -> Label:
    """Words at a point in space."""
    x, y = view(at)
    return Label(x, y, text, role)


def square(centre: "Sequence[float]", normal: "Vector", half: float, role: int, first: "Vector | None" = None) -> Curve:
    """A square of a plane about a point."""
    u = first or unit(cross(normal, (1.0, 0.0, 0.0) if abs(normal[0]) < 0.7 else (0.0, 1.0, 0.0)))
    v = cross(normal, u)
    corners = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0))
    return curve([times(half * t, v, times(half * s, u, centre)) for s, t in corners], "filled", role)


def circle(centre: "Vector", first: "Vector", second: "Vector", radius: float) -> "list[Vector]":
    """A circle in the plane of two unit vectors."""
    turns = [2.0 * math.pi * k / STEPS for k in range(STEPS + 1)]
    return [times(radius * math.sin(t), second, times(radius * math.cos(t), first, centre)) for t in turns]


def corner(items: "Sequence[Any]", view: "Any" = seen) -> "list[Any]":
    """Small axes at the lower left of what is drawn."""
    points = [(x, y) for item in items if isinstance(item, Curve) for x, y in zip(item.x, item.y, strict=True)]
    points += [(item.x + item.dx, item.y + item.dy) for item in items if isinstance(item, Arrow)]
    x, y = zip(*points, strict=True) if points else ((-1.0, 1.0), (-1.0, 1.0))
    size = 0.12 * max(max(x) - min(x), max(y) - min(y))
    left, low = min(x) - 2.0 * size, min(y)
    axes: list[Any] = []
    for name, axis in zip("xyz", ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), strict=True):
        dx, dy = view(times(size, axis))
        axes += [Arrow(left, low, dx, dy, "", SUM), Label(left + 1.3 * dx, low + 1.3 * dy, name, SUM)]
    return axes


def scene(items: "Sequence[Any]", title: "Any" = "", *, room: float = 0.0) -> Panel:
    """A panel without axes, on one scale; `room` is half its width and height."""
    ends = (-room, room) if room else None
    return Panel(Axis("", ends=ends), Axis("", ends=ends), tuple(items), title, equal=True, bare=True)
