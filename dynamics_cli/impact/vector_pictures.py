"""Polygons of momenta and triangles of velocities, with words where they cover nothing."""

import math
from textwrap import fill

from dynamics_cli.impact.scene_labels import Words, bounds, placed
from dynamics_cli.impact.scene_pictures import about, fitting
from dynamics_cli.pictures import Arrow, Axis, Panel, Ruler
from dynamics_cli.quantities import Impulse, RoadSpeed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Pair = tuple[float, float]

# Inches of such a panel on paper, the room at its edges and beneath it.
INCHES, ROOM, FOOT = (3.2, 2.3), 0.1, 0.3
# Letters of a name on one line.
NAME = 14
# The colour of changes of velocity, distinct from those of the vehicles.
CHANGE = 2


def polygon(
    names: "Sequence[str]", masses: "Sequence[float]", before: "Sequence[Pair]", after: "Sequence[Pair]"
) -> Panel:
    """Momenta head to tail, before dashed and after, which end at the same point: their sum."""
    items: list[Any] = []
    words: list[Words] = []
    total = (
        sum(mass * u for mass, (u, _) in zip(masses, after, strict=True)),
        sum(mass * v for mass, (_, v) in zip(masses, after, strict=True)),
    )
    for word, motions in (("before", before), ("after", after)):
        x = y = 0.0
        for role, (name, mass, (u, v)) in enumerate(zip(names, masses, motions, strict=True)):
            items.append(Arrow(x, y, mass * u, mass * v, "", role, dashed=word == "before"))
            if u or v:
                middle = x + 0.5 * mass * u, y + 0.5 * mass * v
                words.append(Words(middle, _away(middle, (u, v), total), fill(f"{name} {word}", NAME), role))
            x, y = x + mass * u, y + mass * v
    items.append(Arrow(0.0, 0.0, *total, "", 6))
    words.append(Words((0.4 * total[0], 0.4 * total[1]), (-total[1], total[0]), "sum", 6))
    return _framed(items, words, ("momentum", Impulse), "momentum")


def triangles(names: "Sequence[str]", before: "Sequence[Pair]", after: "Sequence[Pair]") -> Panel:
    """Velocities before, dashed, and after from one point, and from each to the other its change, on one scale."""
    items: list[Any] = []
    words: list[Words] = []
    for role, (name, u, v) in enumerate(zip(names, before, after, strict=True)):
        change = v[0] - u[0], v[1] - u[1]
        for velocity, dashed in ((u, True), (v, False)):
            if velocity != (0.0, 0.0):
                items.append(Arrow(0.0, 0.0, *velocity, "", role, dashed=dashed))
                tip = "before" if dashed else "after"
                words.append(Words(velocity, velocity, fill(f"{name} {tip}", NAME), role))
        if change != (0.0, 0.0):
            items.append(Arrow(*u, *change, "", CHANGE))
            middle = u[0] + 0.5 * change[0], u[1] + 0.5 * change[1]
            words.append(Words(middle, middle, about(fill(f"{name} ΔV", NAME), math.hypot(*change)), CHANGE))
    return _framed(items, words, ("velocity", RoadSpeed), "velocities and their changes")


def _framed(items: "list[Any]", words: "list[Words]", scale: "tuple[str, Any]", title: str) -> Panel:
    """Arrows with their words on one scale, which stands beneath; with room for all."""
    inch = fitting(items, words, INCHES)
    items = [*items, *placed(items, words, inch)]
    min_x, low, max_x, high = bounds(items, inch)
    longest = max((math.hypot(item.dx, item.dy) for item in items if isinstance(item, Arrow)), default=0.0)
    if longest > 0.0:
        low -= FOOT * inch
        items.append(Ruler(min_x, low, scale[0], scale[1], 1.0, 0.5 * longest, arrow=True))
    across = Axis("", scale[1], ends=(min_x - ROOM * inch, max_x + ROOM * inch))
    up = Axis("", scale[1], ends=(low - ROOM * inch, high + ROOM * inch))
    return Panel(across, up, tuple(items), title, equal=True, bare=True)


def _away(middle: "Pair", way: "Pair", total: "Pair") -> "Pair":
    """Place of a label beside an arrow: across it, on the side away from the sum."""
    is_left = total[0] * middle[1] - total[1] * middle[0] > 0.0
    nx, ny = -way[1], way[0]
    if (nx * -total[1] + ny * total[0] > 0.0) != is_left:
        nx, ny = -nx, -ny
    size = math.hypot(nx, ny)
    return (
        math.copysign(4.0, nx) if abs(nx) > 0.3 * size else 0.0,
        math.copysign(4.0, ny) if abs(ny) > 0.3 * size else 0.0,
    )
