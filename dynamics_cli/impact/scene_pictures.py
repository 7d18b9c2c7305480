"""Scenes of road vehicles: outlines with noses and wheels, and velocities as arrows of one scale."""

import math

from dynamics_cli.impact.scene_labels import Words, bounds, ends, placed
from dynamics_cli.pictures import Arrow, Axis, Curve, Label, Mark, Panel
from dynamics_cli.quantities import Length, RoadSpeed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.impact.scene_labels import Box

    Pair = tuple[float, float]

# A neutral outline, where nothing is known of a vehicle's size.
LENGTH, WIDTH = 4.5, 1.8
NEUTRAL = f"outlines {LENGTH:g} m by {WIDTH:g} m, not measured"
# What the fastest arrow of a scene takes of its page, in lengths of a neutral outline.
LONGEST_ARROW = 1.5
KM_H = 1.0 / 3.6
# A scene wider than this stands alone on its line.
WHOLE = 5.0
# Inches beneath a scene for its scales and notes.
FOOT = 0.95
MOST_TRIES = 8
# Half the width of a lane.
LANE = 1.75


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

    Of two on one line the second stands ahead of the first.
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
    """Whether two outlines overlap, by the axes that could part them."""
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
    centres: "tuple[Pair, Pair] | None" = None,
    inches: "Pair" = (3.4, 3.6),
) -> Panel:
    """Two vehicles at the impact with their velocities before (behind them, dashed) and after (from their centres)."""
    speeds = [math.hypot(*velocity) for velocity in (*before, *after)]
    scale = LONGEST_ARROW * LENGTH / (max(speeds) or 1.0)
    items: list[Any] = []
    words: list[Words] = []
    centres = centres or apart(noses[0], noses[1])
    for role, (name, centre, nose) in enumerate(zip(names, centres, noses, strict=True)):
        items += outline(centre, nose, role)
        u, v = before[role], after[role]
        if speeds[role] > 0.0:
            way = u[0] / speeds[role], u[1] / speeds[role]
            items.append(lane(centre, way, (0.8 * LENGTH + scale * speeds[role], 1.2 * LENGTH)))
            reach = 0.5 * LENGTH * abs(way[0] * nose[0] + way[1] * nose[1]) + 0.5 * WIDTH * abs(
                way[0] * nose[1] - way[1] * nose[0]
            )
            end = centre[0] - (reach + 0.2) * way[0], centre[1] - (reach + 0.2) * way[1]
            tail = end[0] - scale * u[0], end[1] - scale * u[1]
            items.append(Arrow(*tail, scale * u[0], scale * u[1], "", role, dashed=True))
            words.append(Words(tail, (-way[0], -way[1]), f"{name} before\n{about(speeds[role])}", role))
        if speeds[2 + role] > 0.0:
            items.append(Arrow(*centre, scale * v[0], scale * v[1], "", role))
            tip = centre[0] + scale * v[0], centre[1] + scale * v[1]
            words.append(Words(tip, v, f"{name} after\n{about(speeds[2 + role])}", role))
    items.sort(key=lambda item: getattr(item, "style", "") != "ground")
    note = f"{NEUTRAL};\nlanes 3.5 m wide along the velocities before"
    return finished(items, words, inches, (scale, max(speeds)), north, note)


def lane(centre: "Pair", way: "Pair", reach: "Pair") -> Curve:
    """The ground of a lane through a vehicle's centre, so far behind it and ahead."""
    x, y = way
    corners = [(-reach[0], LANE), (reach[1], LANE), (reach[1], -LANE), (-reach[0], -LANE)]
    points = [(centre[0] + a * x - b * y, centre[1] + a * y + b * x) for a, b in corners]
    return Curve([point[0] for point in points], [point[1] for point in points], "", "ground", 6)


def finished(
    items: "Sequence[Any]",
    words: "Sequence[Words]",
    inches: "Pair",
    speeds: "Pair",
    north: "Pair | None",
    note: str,
) -> Panel:
    """A scene with its words where they cover nothing; beneath it the scales of velocity and distance, and a note.

    `inches` are its width and its greatest height on paper, `speeds` the metres of an arrow per metre per second and
    the fastest speed of the scene.
    """
    metres = _metres(bounds(items, 0.0), inches)
    # how much room words take depends on the scale, and the scale on how much room they take
    for _ in range(MOST_TRIES):
        whole = [*items, *placed(items, words, metres)]
        wanted = _metres(bounds(whole, metres), inches)
        if wanted <= metres:
            break
        metres = wanted
    whole += _foot(bounds(whole, metres), metres, inches[0], speeds, note)
    if north is not None:
        whole += _north(whole, metres)
    left, low, right, high = bounds(whole, metres)
    room = 0.06 * metres
    lack = 0.5 * max(0.0, inches[0] * metres - (right - left) - 2.0 * room)
    return Panel(
        Axis("", Length, ends=(left - room - lack, right + room + lack)),
        Axis("", Length, ends=(low - room, high + room)),
        tuple(whole),
        equal=True,
        bare=True,
        wide=inches[0] > WHOLE,
    )


def _metres(box: "Box", inches: "Pair") -> float:
    """Metres to an inch that bring a box onto the paper, with room for the scales beneath."""
    return max((box[2] - box[0]) / (inches[0] - 0.12), (box[3] - box[1]) / (inches[1] - FOOT)) or 1.0


def _foot(box: "Box", metres: float, inches: float, speeds: "Pair", note: str) -> "list[Any]":
    """The scales of velocity and distance, and what was not measured."""
    left, low, *_ = box
    scale, fastest = speeds
    foot, start = low - 0.42 * metres, left
    shown = [speed for speed in (200.0, 100.0, 50.0, 20.0, 10.0, 5.0, 2.0, 1.0) if speed * KM_H <= fastest]
    bars: list[Any] = []
    if shown:
        length = scale * shown[0] * KM_H
        bars += _scale_bar((start, foot), length, f"velocity: {shown[0]:g} km/h", metres)
        start += max(length, 1.25 * metres) + 0.3 * metres
    size = next(
        size for size in (100.0, 50.0, 20.0, 10.0, 5.0, 2.0, 1.0) if size <= 0.3 * inches * metres or size == 1.0
    )
    bars += _scale_bar((start, foot), size, f"distance: {size:g} m", metres)
    lines = note.split("\n")
    return bars + [
        Label(left, foot - (0.19 + 0.15 * nth) * metres, line, 6, left=True) for nth, line in enumerate(lines)
    ]


def _scale_bar(at: "Pair", length: float, text: str, metres: float) -> "list[Any]":
    (x, y), tick = at, 0.04 * metres
    line = [x, x, x, x + length, x + length, x + length], [y - tick, y + tick, y, y, y + tick, y - tick]
    return [Curve(*line, "", "outline", 6), Label(x, y + 0.14 * metres, text, 6, left=True)]


def _north(whole: "Sequence[Any]", metres: float) -> "list[Any]":
    """An arrow to the north at the highest place that is free."""
    left, low, right, high = bounds(whole, metres)
    size = 0.24 * metres
    covered = [point for item in whole if getattr(item, "style", "") != "ground" for point in ends(item)]
    for label in (item for item in whole if isinstance(item, Label)):
        x0, y0, x1, y1 = bounds([label], metres)
        covered += [(x0 + 0.05 * nth * (x1 - x0), y) for nth in range(21) for y in (y0, y1)]
    # the scales stand beneath
    across, up = right - left - 2.0 * size, high - low - FOOT * metres - 2.0 * size
    places = [
        (left + size + 0.125 * i * across, high - 2.0 * size - 0.125 * j * up) for j in range(9) for i in range(9)
    ]

    def free(place: "Pair") -> float:
        x, y = place
        return min(math.dist((x, y + part * size), point) for part in (-1.0, 0.0, 1.0, 2.0) for point in covered)

    x, y = max(places, key=lambda place: min(free(place), 1.5 * size))
    if free((x, y)) < 0.6 * size:
        x, y = left + size, high + 1.5 * size
    return [Arrow(x, y - size, 0.0, 2.0 * size, "", 6), Label(x, y + size + 0.1 * metres, "N", 6)]


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
    """A speed to two digits: the picture shows sizes, the results stand beside it."""
    shown = speed / KM_H
    return f"{shown:.0f} km/h" if shown >= 10.0 else f"{shown:.2g} km/h"


def beside(at: "Pair", way: "Pair", text: str, role: int) -> Mark:
    """Words beyond the end of an arrow."""
    if abs(way[1]) > abs(way[0]):
        return Mark(*at, text, (0.0, math.copysign(4.0, way[1])), dot=False, role=role)
    return Mark(*at, text, (math.copysign(4.0, way[0]), 0.0), dot=False, role=role)
