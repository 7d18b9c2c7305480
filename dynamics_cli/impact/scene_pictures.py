"""Scenes of road vehicles: outlines with noses and wheels, and velocities as arrows of one scale."""

import math

from dynamics_cli.pictures import Arrow, Axis, Curve, Mark, Panel
from dynamics_cli.quantities import Length, RoadSpeed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Pair = tuple[float, float]

# A neutral outline if a vehicle's size is unknown.
LENGTH, WIDTH = 4.5, 1.8
NEUTRAL = f"outlines {LENGTH:g} m by {WIDTH:g} m, not measured"
# Length of a scene's fastest arrow, in lengths of a neutral outline.
LONGEST_ARROW = 1.5
KM_H = 1.0 / 3.6


def outline(at: "Pair", way: "Pair", role: int, *, length: float = LENGTH, width: float = WIDTH) -> "list[Any]":
    """A vehicle with its centre at a point and its nose in a direction: body, windscreen, nose and wheels."""
    x, y = way
    half, side = 0.5 * length, 0.5 * width
    corner = 0.25 * width

    def place(points: "Sequence[Pair]") -> "tuple[list[float], list[float]]":
        return [at[0] + a * x - b * y for a, b in points], [at[1] + a * y + b * x for a, b in points]

    body = [
        (half - corner, side), (half - 0.3 * corner, side - 0.3 * corner), (half, side - corner),
        (half, corner - side), (half - 0.3 * corner, 0.3 * corner - side), (half - corner, -side),
        (-half, -side), (-half, side), (half - corner, side),
    ]  # fmt: skip
    screen = [(0.15 * length, 0.4 * width), (0.05 * length, 0.35 * width), (0.05 * length, -0.35 * width),
              (0.15 * length, -0.4 * width), (0.15 * length, 0.4 * width)]  # fmt: skip
    nose = [(0.44 * length, 0.0), (0.3 * length, 0.14 * length), (0.3 * length, -0.14 * length), (0.44 * length, 0.0)]
    nose = [(a, b * width / (0.4 * length)) for a, b in nose]
    items: list[Any] = [
        Curve(*place(body), "", "filled", role),
        Curve(*place(screen), "", "filled", role),
        Curve(*place(nose), "", "filled", role),
    ]
    for along in (0.31 * length, -0.31 * length):
        for across in (side, -side):
            ends = [(along - 0.07 * length, across), (along + 0.07 * length, across)]
            items.append(Curve(*place(ends), "", "thick", role))
    return items


def apart(first: "Pair", second: "Pair") -> "tuple[Pair, Pair]":
    """Centres of two vehicles that drove in these directions and touch at the origin, without overlapping.

    If both are on one line the second is ahead of the first.
    """
    start = -0.5 * LENGTH * first[0], -0.5 * LENGTH * first[1]
    along = 0.5 if first[0] * second[0] + first[1] * second[1] > 0.9 else -0.5
    back = 0.0
    while True:
        shift = along * LENGTH + math.copysign(back, along)
        centre = shift * second[0], shift * second[1]
        if not _overlap(start, first, centre, second):
            return start, centre
        back += 0.05


def _overlap(one: "Pair", way: "Pair", other: "Pair", course: "Pair") -> bool:
    """Whether two outlines overlap, by the separating-axis test."""
    gap = other[0] - one[0], other[1] - one[1]
    for axis in (way, (-way[1], way[0]), course, (-course[1], course[0])):
        reach = 0.0
        for x, y in (way, course):
            reach += 0.5 * LENGTH * abs(axis[0] * x + axis[1] * y) + 0.5 * WIDTH * abs(axis[1] * x - axis[0] * y)
        if abs(gap[0] * axis[0] + gap[1] * axis[1]) >= reach:
            return False
    return True


def collision(
    names: "Sequence[str]",
    noses: "Sequence[Pair]",
    before: "Sequence[Pair]",
    after: "Sequence[Pair]",
    north: "Pair | None",
) -> Panel:
    """Two vehicles at the impact with their velocities before (behind them, dashed) and after (from their centres)."""
    speeds = [math.hypot(*velocity) for velocity in (*before, *after)]
    scale = LONGEST_ARROW * LENGTH / (max(speeds) or 1.0)
    items: list[Any] = []
    centres = apart(noses[0], noses[1])
    for role, (name, centre, nose) in enumerate(zip(names, centres, noses, strict=True)):
        items += outline(centre, nose, role)
        u, v = before[role], after[role]
        if speeds[role] > 0.0:
            way = u[0] / speeds[role], u[1] / speeds[role]
            reach = 0.5 * LENGTH * abs(way[0] * nose[0] + way[1] * nose[1]) + 0.5 * WIDTH * abs(
                way[0] * nose[1] - way[1] * nose[0]
            )
            end = centre[0] - (reach + 0.2) * way[0], centre[1] - (reach + 0.2) * way[1]
            tail = end[0] - scale * u[0], end[1] - scale * u[1]
            items.append(Arrow(*tail, scale * u[0], scale * u[1], "", role, dashed=True))
            items.append(beside(tail, (-way[0], -way[1]), f"{name} before\n{about(speeds[role])}", role))
        if speeds[2 + role] > 0.0:
            items.append(Arrow(*centre, scale * v[0], scale * v[1], "", role))
            tip = centre[0] + scale * v[0], centre[1] + scale * v[1]
            way = v[0] / speeds[2 + role], v[1] / speeds[2 + role]
            items.append(beside(tip, way, f"{name} after\n{about(speeds[2 + role])}", role))
    return Panel(
        Axis("", Length), Axis("", Length), (*items, *scales(items, scale, max(speeds), north)), equal=True, bare=True
    )


def velocities(
    names: "Sequence[str]",
    before: "Sequence[Pair]",
    after: "Sequence[Pair]",
    title: str = "velocities before (dashed) and after",
) -> Panel:
    """Velocities before, dashed, and after from one point on one scale."""
    items: list[Any] = []
    for role, (name, u, v) in enumerate(zip(names, before, after, strict=True)):
        for word, (x, y) in (("before", u), ("after", v)):
            if x or y:
                items.append(Arrow(0.0, 0.0, x, y, "", role, dashed=word == "before"))
                items.append(beside((x, y), (x, y), f"{name} {word}", role))
    across, up = Axis("velocity along x", RoadSpeed), Axis("velocity along y", RoadSpeed)
    return Panel(across, up, tuple(items), title, equal=True)


def about(speed: float) -> str:
    """A speed to two digits: the picture shows magnitudes, the exact results are in the text."""
    shown = speed / KM_H
    return f"{shown:.0f} km/h" if shown >= 10.0 else f"{shown:.2g} km/h"


def beside(at: "Pair", way: "Pair", text: str, role: int) -> Mark:
    """Words beyond the end of an arrow."""
    if abs(way[1]) > abs(way[0]):
        return Mark(*at, text, (0.0, math.copysign(4.0, way[1])), dot=False, role=role)
    return Mark(*at, text, (math.copysign(4.0, way[0]), 0.0), dot=False, role=role)


def scales(
    items: "Sequence[Any]", scale: float, fastest: float, north: "Pair | None", note: str = NEUTRAL
) -> "list[Any]":
    """A scale arrow of a round speed, a note on the outlines, and the direction of north (or x)."""
    points = [(x, y) for item in items if isinstance(item, Curve) for x, y in zip(item.x, item.y, strict=True)]
    points += [(item.x, item.y) for item in items if isinstance(item, Arrow | Mark)]
    left, right = min(x for x, _ in points), max(x for x, _ in points)
    low, high = min(y for _, y in points), max(y for _, y in points)
    speed = next(s for s in (200.0, 100.0, 50.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.0) if s * KM_H <= 0.9 * fastest or not s)
    bars: list[Any] = []
    if speed:
        bars.append(Curve([left, left + scale * speed * KM_H], [low - 3.2, low - 3.2], "", "thick", 6))
        bars.append(Mark(left, low - 3.2, f"velocity: {speed:g} km/h", (0.1, 4.0), dot=False))
    bars.append(Mark(left, low - 3.2, note, (0.1, -4.0), dot=False))
    if north is not None:
        # in the corner that is farthest from everything else
        corners = [(x, y) for x in (left, right) for y in (high - 1.0, low + 1.0)]
        x, y = max(corners, key=lambda corner: min(math.dist(corner, point) for point in points))
        bars += [Arrow(x, y - 1.0, 0.0, 2.0, "", 6), Mark(x, y + 1.0, "N", (0.0, 3.0), dot=False)]
    return bars
