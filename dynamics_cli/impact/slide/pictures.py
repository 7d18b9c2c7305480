"""The slide to scale: outlines at every eighth of a turn, the path of the mass centre, and the marks of the wheels.

As a picture, and as a drawing in the coordinates of the scene.
"""

from dynamics_cli.errors import worded
from dynamics_cli.impact.conventions import AXES, Axes
from dynamics_cli.impact.scene_labels import Words
from dynamics_cli.impact.scene_pictures import about, finished, to_scale
from dynamics_cli.impact.slide.marks import lines
from dynamics_cli.impact.slide.motion import Run, run
from dynamics_cli.impact.slide.records import AtRest, Ground
from dynamics_cli.impact.slide.task import car_of, shares_of, start_of
from dynamics_cli.impact.slide.wheels import Car
from dynamics_cli.impact.vehicle_outlines import outline
from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.pictures import Arrow, Curve, Mark, Picture, Plan
from dynamics_cli.quantities import STANDARD_GRAVITY, Friction

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Pair = tuple[float, float]

EIGHTH = 0.7853981633974483
# Overhangs beyond the axles and outside of the tracks, of a common car.
OVERHANG, OUTSIDE = 0.8, 0.25
SPEED_PER_METRE = 4.0
# How far an edge is drawn beyond the path, in metres.
BESIDE = 2.0
# Inches of the picture.
WIDE, HIGH = 7.2, 4.6


TITLE = "from the separation to rest, to scale"
NOTE = ("outlines at every eighth of a turn, of common overhangs",)


def slide(made: "Any", **given: "Any") -> Picture:
    """The car from the separation to rest, seen from above."""
    items, words, speeds, north = _drawn(made, given)
    return Picture((finished(items, words, (WIDE, HIGH), speeds, north, NOTE),), TITLE, width=WIDE, scene=True)


def plan(made: "Any", **given: "Any") -> Plan:
    """The same as a drawing, its marks as wide as tyres."""
    items, words, speeds, north = _drawn(made, given)
    marked = [
        Curve(item.x, item.y, "", "track", 6) if isinstance(item, Curve) and item.style == "solid" else item
        for item in items
    ]
    return to_scale(marked, words, speeds, north, NOTE, TITLE)


def _drawn(
    made: "Any", given: "dict[str, Any]"
) -> "tuple[list[Any], list[Words], tuple[float, float], tuple[float, float] | None]":
    """The scene with its words, the scale of its arrow with the speed, and north."""
    axes: Axes = given.get("axes", AXES)
    flip = -1.0 if axes == "sae" else 1.0
    car = car_of(
        given["front_axle"], given["rear_axle"], given["track"], given["radius_of_gyration"], given["friction"],
        shares_of(given), given.get("grip_slope", 0.1), given.get("steer", 0.0), given.get("gravity", STANDARD_GRAVITY),
        given.get("grounds", ()), axes,
    )  # fmt: skip
    motion = given["motion"]
    if isinstance(motion, AtRest):
        motion = made.roots[0]
    start = start_of(motion, given.get("nose", 0.0), given.get("place", (0.0, 0.0)), axes)
    done = run(car, start)
    size = {"length": car.wheels[0].ahead - car.wheels[2].ahead + 2.0 * OVERHANG,
            "width": given["track"] + 2.0 * OUTSIDE}  # fmt: skip
    items, words = _marks(car, done, (-start.vx, -flip * start.vy), flip)
    places = [(one.x, one.y) for one in done.moments]
    for ground in given.get("grounds", ()):
        area, edges, label = _ground(ground, places, flip)
        items = [area, *items, *edges]
        words.append(label)
    shown = _eighths(done)
    for index, (x, y, nose) in enumerate(shown):
        drawn = outline((x, flip * y), _way(nose, flip), 0, **size)
        if 0 < index < len(shown) - 1:
            # between the ends the body and the nose are enough
            drawn = [Curve(one.x, one.y, "", "outline", 0) for one in (drawn[0], drawn[2])]
        items += drawn
    dense = [done.at(done.end.time * i / 200) for i in range(201)]
    items.append(Curve([one[0] for one in dense], [flip * one[1] for one in dense], "", "dashed", 6))
    speed = (start.vx * start.vx + start.vy * start.vy) ** 0.5
    scale = 1.0 / SPEED_PER_METRE
    if speed > 0.0:
        items.append(Arrow(start.x, flip * start.y, scale * start.vx, flip * scale * start.vy, "", 3))
        tip = start.x + scale * start.vx, flip * (start.y + scale * start.vy)
        words.append(Words(tip, (start.vx / speed, flip * start.vy / speed), about("at the separation", speed), 3))
    end = done.end
    ahead = end.x - start.x, flip * (end.y - start.y)
    length = max((ahead[0] ** 2 + ahead[1] ** 2) ** 0.5, 1e-9)
    way = ahead[0] / length, ahead[1] / length
    front = end.x + 0.5 * size["length"] * way[0], flip * end.y + 0.5 * size["length"] * way[1]
    words.append(Words(front, way, "at rest", 0))
    items += [Mark(start.x, flip * start.y, "", role=6)]
    return items, words, (scale, speed), (0.0, 1.0) if axes == "compass" else None


def _ground(ground: Ground, places: "list[Pair]", flip: float) -> "tuple[Curve, list[Curve], Words]":
    """A ground as far as the car came by, or the whole patch; its edges; and its friction where the car is far."""
    x, y = ground.edge_from
    way = ground.edge_to[0] - x, ground.edge_to[1] - y
    length = hypot(*way)
    a, b = way[0] / length, way[1] / length
    begin, end = 0.0, length
    if not ground.patch:
        along = [a * (one[0] - x) + b * (one[1] - y) for one in places]
        begin, end = min(along) - BESIDE, max(along) + BESIDE
    width = ground.width
    # seen from above, left of a line
    across = [a * (one[1] - y) - b * (one[0] - x) for one in places]
    deep = max(*across, 0.0) + BESIDE if width is None else width

    def at(along: float, across: float) -> "Pair":
        return x + a * along - flip * b * across, flip * (y + b * along) + a * across

    corners = [at(begin, 0.0), at(end, 0.0), at(end, deep), at(begin, deep)]
    closed = [*corners, corners[0]]
    pieces = [corners[:2]] if width is None else [closed] if ground.patch else [corners[:2], corners[2:]]
    near = [(at(begin, 0.5 * deep), (-a, -flip * b)), (at(end, 0.5 * deep), (a, flip * b))]
    far, away = max(near, key=lambda one: min(hypot(one[0][0] - p, one[0][1] - flip * q) for p, q in places))
    label = worded("friction {friction:3}", friction=(ground.friction, Friction))
    return _line(closed, "fill"), [_line(one, "thin") for one in pieces], Words(far, away, label, 6)


def _line(points: "list[Pair]", style: "Any", role: int = 6) -> Curve:
    return Curve([p for p, _ in points], [q for _, q in points], "", style, role)


def _way(nose: float, flip: float) -> "tuple[float, float]":
    from dynamics_cli.numerics.elementary import cos, sin

    return cos(nose), flip * sin(nose)


def _eighths(done: Run) -> "list[tuple[float, float, float]]":
    """The car at both ends and wherever its nose has turned through another eighth of a turn."""
    moments = done.moments
    listed = [(moments[0].x, moments[0].y, moments[0].nose)]
    for one in moments[1:-1]:
        if abs(one.nose - listed[-1][2]) >= EIGHTH:
            listed.append((one.x, one.y, one.nose))
    if abs(moments[-1].nose - listed[-1][2]) < 0.5 * EIGHTH and len(listed) > 2:
        listed.pop()
    listed.append((moments[-1].x, moments[-1].y, moments[-1].nose))
    return listed


def _marks(car: Car, done: Run, back: "Pair", flip: float) -> "tuple[list[Any], list[Words]]":
    """The marks of the wheels, broken where they do not slip, and the words of those on one side."""
    items: list[Any] = []
    words: list[Words] = []
    for index, (wheel, name) in enumerate(zip(car.wheels, ("", "front wheel", "", "rear wheel"), strict=True)):
        role = 1 if index < 2 else 2
        marks = [[(x, flip * y) for x, y in line] for line in lines(wheel, done)]
        items += [_line(mark, "solid", role) for mark in marks]
        if marks and name:
            words.append(Words(marks[0][0], back, name, role))
    return items, words
