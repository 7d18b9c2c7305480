"""Scenes of road vehicles: outlines with noses and wheels, and velocities as arrows of one scale."""

import math

from dynamics_cli.errors import Wording, worded
from dynamics_cli.impact.conventions import AXES, Axes, direction_of
from dynamics_cli.impact.scene_labels import Words, bounds, ends, placed
from dynamics_cli.impact.vehicle_outlines import LENGTH, WIDTH, outline
from dynamics_cli.pictures import Arrow, Axis, Curve, Label, Mark, Panel, Plan, Ruler
from dynamics_cli.quantities import Length, RoadSpeed, Speed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.impact.scene_labels import Box

    Pair = tuple[float, float]

# Length of the fastest arrow of a scene, in lengths of a neutral outline.
LONGEST_ARROW = 1.5
# A scene wider than this stands alone on its line.
WHOLE = 5.0
# Inches beneath a scene for its scales and notes.
FOOT = 0.95
MOST_TRIES = 8
# Half the width of a lane.
LANE = 1.75
# Scales of plans on paper, and metres of an inch.
SCALES = (50.0, 100.0, 150.0, 200.0, 250.0, 300.0, 400.0, 500.0, 750.0, 1000.0, 1500.0, 2000.0, 2500.0, 5000.0)
INCH = 0.0254
# Room beside the tips of velocities for their names, of the width of all.
NAME_ROOM = 0.2
# Inches of a plan on a sheet of paper across.
SHEET = (10.6, 7.0)


def axes_of(result: "Any") -> Axes:
    """The axes that a result is written in."""
    return Axes(result.conventions.axes.partition(":")[0])


def names_of(first: "Any", second: "Any") -> "tuple[str, str]":
    """Names of two bodies."""
    return getattr(first, "name", None) or "first", getattr(second, "name", None) or "second"


def seen(length: float, heading: float, axes: Axes) -> "Pair":
    """A vector of a heading as seen from above on the page: north or y up; the y axis of sae points down."""
    x, y = direction_of(heading, axes)
    return on_page((length * x, length * y), axes)


def on_page(vector: "Pair", axes: Axes) -> "Pair":
    """A vector of the scene as seen from above; the y axis of sae points down."""
    return vector[0], -vector[1] if axes == "sae" else vector[1]


def upward(axes: Axes) -> str:
    """The axis that points up on the page."""
    return "−y" if axes == "sae" else "y"


def north_of(axes: Axes) -> "Pair | None":
    """Where north is on the page, if the axes have one."""
    return (0.0, 1.0) if axes == "compass" else None


def apart(
    first: "Pair", second: "Pair", sizes: "tuple[Pair, Pair]" = ((LENGTH, WIDTH), (LENGTH, WIDTH))
) -> "tuple[Pair, Pair]":
    """Centres of two vehicles that drove in these directions and touch at the origin, without overlapping.

    Of two on one line the second stands ahead of the first. `sizes` are their lengths and widths.
    """
    start = -0.5 * sizes[0][0] * first[0], -0.5 * sizes[0][0] * first[1]
    along = 0.5 if first[0] * second[0] + first[1] * second[1] > 0.9 else -0.5
    back = 0.0
    while True:
        shift = along * sizes[1][0] + math.copysign(back, along)
        centre = shift * second[0], shift * second[1]
        if not _overlap(start, first, centre, second, sizes):
            return start, centre
        back += 0.05


def _overlap(a: "Pair", u: "Pair", b: "Pair", v: "Pair", sizes: "tuple[Pair, Pair]") -> bool:
    """Whether two outlines overlap, by the axes that could part them."""
    gap = b[0] - a[0], b[1] - a[1]
    for axis in (u, (-u[1], u[0]), v, (-v[1], v[0])):
        reach = 0.0
        for (x, y), (length, width) in zip((u, v), sizes, strict=True):
            reach += 0.5 * length * abs(axis[0] * x + axis[1] * y) + 0.5 * width * abs(axis[1] * x - axis[0] * y)
        if abs(gap[0] * axis[0] + gap[1] * axis[1]) >= reach:
            return False
    return True


def collision(
    names: "Sequence[str]",
    noses: "Sequence[Pair]",
    before: "Sequence[Pair]",
    after: "Sequence[Pair]",
    north: "Pair | None",
    centres: "Sequence[Pair] | None" = None,
    inches: "Pair" = (3.4, 3.6),
    barrier: "Sequence[Curve]" = (),
    uncertain: "Callable[[int, Pair, float], list[Any]] | None" = None,
) -> Panel:
    """Vehicles at the impact with their velocities before (behind them, dashed) and after (from their centres).

    One vehicle with the `barrier` that it struck stands on no lane. What is `uncertain` of a vehicle is drawn from its
    index, its centre and the scale of its arrows.
    """
    speeds = [math.hypot(*velocity) for velocity in (*before, *after)]
    scale = LONGEST_ARROW * LENGTH / (max(speeds) or 1.0)
    items: list[Any] = list(barrier)
    words: list[Words] = []
    centres = centres or apart(noses[0], noses[1])
    for role, (name, centre, nose) in enumerate(zip(names, centres, noses, strict=True)):
        items += outline(centre, nose, role)
        u, v = before[role], after[role]
        if uncertain is not None:
            items += uncertain(role, centre, scale)
        if speeds[role] > 0.0:
            direction = u[0] / speeds[role], u[1] / speeds[role]
            if not barrier:
                items.append(lane(centre, direction, (0.8 * LENGTH + scale * speeds[role], 1.2 * LENGTH)))
            reach = 0.5 * LENGTH * abs(direction[0] * nose[0] + direction[1] * nose[1]) + 0.5 * WIDTH * abs(
                direction[0] * nose[1] - direction[1] * nose[0]
            )
            end = centre[0] - (reach + 0.2) * direction[0], centre[1] - (reach + 0.2) * direction[1]
            tail = end[0] - scale * u[0], end[1] - scale * u[1]
            items.append(Arrow(*tail, scale * u[0], scale * u[1], "", role, dashed=True))
            words.append(Words(tail, (-direction[0], -direction[1]), about(f"{name} before", speeds[role]), role))
        if speeds[len(names) + role] > 0.0:
            items.append(Arrow(*centre, scale * v[0], scale * v[1], "", role))
            tip = centre[0] + scale * v[0], centre[1] + scale * v[1]
            words.append(Words(tip, v, about(f"{name} after", speeds[len(names) + role]), role))
    items.sort(key=lambda item: getattr(item, "style", "") != "ground")
    comma = "" if barrier else ";"
    note = [
        worded(
            "outlines {length:2} by {width:2}, not measured" + comma, length=(LENGTH, Length), width=(WIDTH, Length)
        ),
        worded("lanes {width:3} wide along the velocities before", width=(2.0 * LANE, Length)),
    ][: 1 if barrier else 2]
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
    note: "Sequence[str]",
) -> Panel:
    """A scene with its words where they cover nothing; beneath it the scales of velocity and distance, and a note.

    `inches` are its width and its greatest height on paper, `speeds` the metres of an arrow per metre per second and
    the fastest speed of the scene.
    """
    return _panel(
        items, words, inches, speeds, north, note, fitting(items, words, (inches[0] - 0.12, inches[1] - FOOT))
    )


def to_scale(
    items: "Sequence[Any]",
    words: "Sequence[Words]",
    speeds: "Pair",
    north: "Pair | None",
    note: "Sequence[str]",
    title: str,
    origin: "Pair" = (0.0, 0.0),
) -> Plan:
    """The same on a sheet of paper at a round scale; `origin` is the place of the picture's zero in the scene."""
    least = fitting(items, words, (SHEET[0], SHEET[1] - FOOT)) / INCH
    scale = next((scale for scale in SCALES if scale >= least), 1000.0 * math.ceil(0.001 * least))
    # as wide as it is: the sheet is around it
    panel = _panel(items, words, (0.0, 0.0), speeds, north, note, scale * INCH)
    return Plan(panel, title, scale, origin)


def fitting(items: "Sequence[Any]", words: "Sequence[Words]", inches: "Pair") -> float:
    """Metres to an inch that give a scene and its words room."""
    metres = _metres(bounds(items, 0.0), inches)
    # how much room words take depends on the scale, and the scale on how much room they take
    for _ in range(MOST_TRIES):
        required = _metres(bounds([*items, *placed(items, words, metres)], metres), inches)
        if required <= metres:
            break
        metres = required
    return metres


def _panel(
    items: "Sequence[Any]",
    words: "Sequence[Words]",
    inches: "Pair",
    speeds: "Pair",
    north: "Pair | None",
    note: "Sequence[str]",
    metres: float,
) -> Panel:
    """The scene at so many metres to an inch."""
    drawn = [*items, *placed(items, words, metres)]
    min_x, low, max_x, _ = bounds(drawn, metres)
    drawn += _foot((min_x, low), metres, max(inches[0], (max_x - min_x) / metres), speeds, note)
    if north is not None:
        drawn += _north(drawn, metres)
    min_x, low, max_x, high = bounds(drawn, metres)
    margin = 0.06 * metres
    lack = 0.5 * max(0.0, inches[0] * metres - (max_x - min_x) - 2.0 * margin)
    return Panel(
        Axis("", Length, ends=(min_x - margin - lack, max_x + margin + lack)),
        Axis("", Length, ends=(low - margin, high + margin)),
        tuple(drawn),
        equal=True,
        bare=True,
        wide=inches[0] > WHOLE,
    )


def _metres(box: "Box", inches: "Pair") -> float:
    """Metres to an inch that bring a box onto the paper."""
    return max((box[2] - box[0]) / inches[0], (box[3] - box[1]) / inches[1]) or 1.0


def _foot(corner: "Pair", metres: float, inches: float, speeds: "Pair", note: "Sequence[str]") -> "list[Any]":
    """The scales of velocity and distance, and a note on data not measured."""
    min_x, low = corner
    scale, fastest = speeds
    foot, start = low - 0.42 * metres, min_x
    bars: list[Any] = []
    if fastest > 0.0:
        longest = min(scale * fastest, 0.5 * inches * metres)
        bars.append(Ruler(start, foot, "velocity", RoadSpeed, scale, longest, arrow=True))
        start += max(longest, 1.25 * metres) + 0.3 * metres
    bars.append(Ruler(start, foot, "distance", Length, 1.0, 0.3 * inches * metres))
    return bars + [
        Label(min_x, foot - (0.19 + 0.15 * nth) * metres, line, 6, left=True) for nth, line in enumerate(note)
    ]


def _north(items: "Sequence[Any]", metres: float) -> "list[Any]":
    """An arrow to the north at the highest place that is free."""
    min_x, low, max_x, high = bounds(items, metres)
    size = 0.24 * metres
    covered = [point for item in items for point in (ends(item) if _style(item) != "ground" else _within(item))]
    for label in (item for item in items if isinstance(item, Label)):
        x0, y0, x1, y1 = bounds([label], metres)
        covered += [(x0 + 0.05 * nth * (x1 - x0), y) for nth in range(21) for y in (y0, y1)]
    # the scales stand beneath
    across, up = max_x - min_x - 2.0 * size, high - low - FOOT * metres - 2.0 * size
    places = [
        (min_x + size + 0.125 * i * across, high - 2.0 * size - 0.125 * j * up) for j in range(9) for i in range(9)
    ]

    def free(place: "Pair") -> float:
        x, y = place
        return min(math.dist((x, y + part * size), point) for part in (-1.0, 0.0, 1.0, 2.0) for point in covered)

    x, y = max(places, key=lambda place: min(free(place), 1.5 * size))
    if free((x, y)) < 0.6 * size:
        x, y = min_x + size, high + 1.5 * size
    return [Arrow(x, y - size, 0.0, 2.0 * size, "", 6), Label(x, y + size + 0.1 * metres, "N", 6)]


def _style(item: "Any") -> str:
    return getattr(item, "style", "")


def _within(ground: "Any") -> "list[Pair]":
    """Points all over a piece of ground of four corners."""
    (x0, x1, x2, x3), (y0, y1, y2, y3) = ground.x, ground.y
    parts = [0.05 * nth for nth in range(21)]
    return [
        (x0 + a * (x1 - x0) + b * (x3 - x0), y0 + a * (y1 - y0) + b * (y3 - y0)) for a in parts for b in (0.0, 0.5, 1.0)
    ] + [(x2, y2)]


def velocities(
    names: "Sequence[str]",
    before: "Sequence[Pair]",
    after: "Sequence[Pair]",
    title: str = "velocities before (dashed) and after",
    axes: Axes = AXES,
    kind: "type[float]" = Speed,
) -> Panel:
    """Velocities on the page before, dashed, and after from one point on one scale."""
    items: list[Any] = []
    for role, (name, u, v) in enumerate(zip(names, before, after, strict=True)):
        for word, (x, y) in (("before", u), ("after", v)):
            if x or y:
                items.append(Arrow(0.0, 0.0, x, y, "", role, dashed=word == "before"))
                items.append(beside((x, y), (x, y), f"{name} {word}", role))
    tips = [(0.0, 0.0), *before, *after]
    left, right = min(x for x, _ in tips), max(x for x, _ in tips)
    # a fine line through the start of all, with room for the words beside the tips
    room = NAME_ROOM * (right - left)
    items.append(Curve([left - room * (left < 0.0), right + room * (right > 0.0)], [0.0, 0.0], "", "dots", 6))
    across, up = Axis("velocity along x", kind), Axis(f"velocity along {upward(axes)}", kind)
    return Panel(across, up, tuple(items), title, equal=True)


def about(text: str, speed: float) -> Wording:
    """Words and a speed to three digits: the picture shows sizes, the results stand beside it."""
    return worded("{text}\n{speed:3}", text=text, speed=(speed, RoadSpeed))


def beside(at: "Pair", way: "Pair", text: str, role: int) -> Mark:
    """Words beyond the end of an arrow."""
    if abs(way[1]) > abs(way[0]):
        return Mark(*at, text, (0.0, math.copysign(4.0, way[1])), dot=False, role=role)
    return Mark(*at, text, (math.copysign(4.0, way[0]), 0.0), dot=False, role=role)
