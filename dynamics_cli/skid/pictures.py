"""Pictures of skids: speed along the road, flights, test skids and curves, as data."""

import math
from itertools import pairwise

from dynamics_cli.errors import worded
from dynamics_cli.pictures import Axis, Band, Bars, Curve, Mark, Panel, Picture, Ranges
from dynamics_cli.quantities import Angle, Count, DragFactor, Fraction, Friction, Length, RoadSpeed, Slope, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.pictures import Spreads

POINTS = 121
# Steepest grade of the road in the picture.
STEEPEST = 0.15
DISTANCE = Axis("distance", Length)
SPEED = Axis("speed", RoadSpeed)


def slowing(first: float, last: float, start: float, length: float) -> "tuple[list[float], list[float]]":
    """Speeds over a stretch of uniform deceleration: v² falls in a straight line."""
    fractions = [i / (POINTS - 1) for i in range(POINTS)]
    speeds = [math.sqrt(max(0.0, first * first + fraction * (last * last - first * first))) for fraction in fractions]
    return [start + fraction * length for fraction in fractions], speeds


def speed(result: "Any", **_: "Any") -> Picture:
    """Speed along the marks, surface by surface."""
    items: list[Any] = []
    position = 0.0
    for nth, surface in enumerate(result.surfaces, 1):
        x, y = slowing(surface.entry_speed, surface.exit_speed, position, surface.distance)
        items.append(Curve(x, y, f"surface {nth}, drag factor {surface.drag_factor:.3g}"))
        position += surface.distance
    items.append(Mark(0.0, result.speed, "marks begin"))
    return Picture((Panel(DISTANCE, SPEED, tuple(items)),), "speed along the marks")


def distance(
    result: "Any", *, speed: float, end_speed: float = 0.0, mark: "float | None" = None, **_: "Any"
) -> Picture:
    """Speed over the distance of braking."""
    x, y = slowing(speed, end_speed, 0.0, result.distance)
    items: list[Any] = [Curve(x, y, role=0), Mark(result.distance, end_speed, "slowed")]
    if mark is not None and result.exit_speed is not None:
        items.append(Mark(mark, result.exit_speed, "mark ends"))
    return Picture((Panel(DISTANCE, SPEED, tuple(items)),), "speed while braking")


def stop(result: "Any", **_: "Any") -> Picture:
    """Speed over distance and over time, phase by phase."""
    rows = result.timeline
    phases = list(dict.fromkeys(row.phase for row in rows))
    panels = []
    for axis, key in ((DISTANCE, "distance"), (Axis("time", Time), "time")):
        items = []
        for phase in phases:
            phase_rows = [row for row in rows if row.phase == phase]
            before = [rows[rows.index(phase_rows[0]) - 1]] if rows.index(phase_rows[0]) else []
            items.append(Curve(*_along([*before, *phase_rows], key), phase))
        panels.append(Panel(axis, SPEED, tuple(items)))
    return Picture(tuple(panels), "a whole stop")


def _along(rows: "list[Any]", key: str) -> "tuple[list[float], list[float]]":
    """A phase's speeds; over distance, uniform deceleration is a curve from row to row."""
    if key == "time" or rows[-1].phase != "braking":
        return [getattr(row, key) for row in rows], [row.speed for row in rows]
    x: list[float] = []
    y: list[float] = []
    for before, following in pairwise(rows):
        part, speeds = slowing(before.speed, following.speed, before.distance, following.distance - before.distance)
        x, y = [*x, *part], [*y, *speeds]
    return x, y


def avoid(
    result: "Any", *, speed: float, sight_distance: float, reaction_time: float, speed_limit: "float | None" = None,
    **_: "Any",
) -> Picture:  # fmt: skip
    """Speed over distance at the speed travelled and at the limit, with the hazard."""
    items: list[Any] = []
    for approach in result.approaches:
        x, y = slowing(approach.approach_speed, 0.0, approach.reaction_distance, approach.braking_distance)
        items.append(Curve([0.0, *x], [approach.approach_speed, *y], str(approach.case)))
    items.append(Band(sight_distance, sight_distance, "hazard"))
    return Picture((Panel(DISTANCE, SPEED, tuple(items)),), "could it have stopped?")


def vault(result: "Any", *, distance: float, rise: float = 0.0, **_: "Any") -> Picture:
    """The flight."""
    slope = math.tan(result.launch_angle)
    # Through take-off and landing: the fall equals the height of the line of departure above the landing.
    drop = distance * slope - rise
    fractions = [i / (POINTS - 1) for i in range(POINTS)]
    x = [fraction * distance for fraction in fractions]
    y = [fraction * distance * slope - drop * fraction * fraction for fraction in fractions]
    marks = (Mark(0.0, 0.0, "take-off"), Mark(distance, rise, "landing"))
    panel = Panel(DISTANCE, Axis("height", Length), (Curve(x, y, role=0), *marks), equal=True)
    return Picture((panel,), "flight")


def yaw(result: "Any", *, path: "Any", friction: float, **_: "Any") -> Picture:
    """The mark as an arc with its chord, or the surveyed points with their circle."""
    if hasattr(path, "points"):
        from dynamics_cli.skid.curved.pictures import surveyed

        return surveyed(result, path)
    radius = result.mark_radius if result.mark_radius is not None else result.path_radius
    chord = getattr(path, "chord", radius)
    half = math.asin(min(1.0, chord / (2.0 * radius)))
    angles = [half * (2.0 * i / (POINTS - 1) - 1.0) for i in range(POINTS)]
    x = [radius * math.sin(angle) for angle in angles]
    y = [radius * (math.cos(angle) - math.cos(half)) for angle in angles]
    items = (Curve(x, y, "mark"), Curve([x[0], x[-1]], [y[0], y[-1]], "chord", "dashed"))
    return Picture((Panel(Axis("along", Length), Axis("across", Length), items, equal=True),), "yaw mark")


def friction(result: "Any", **_: "Any") -> Picture:
    """Every test skid's coefficient, with their mean and its standard error."""
    numbers = [float(nth) for nth in range(1, len(result.tests) + 1)]
    items: list[Any] = [Curve(numbers, [test.friction for test in result.tests], "test skids", "points")]
    items.append(Band(result.friction, result.friction, "mean", vertical=False))
    if result.standard_error:
        spread = result.standard_error
        items.append(Band(result.friction - spread, result.friction + spread, "standard error", vertical=False))
    return Picture(
        (Panel(Axis("test skid", Count, ends=(0.5, len(numbers) + 0.5)), Axis("friction", Friction), tuple(items)),),
        "friction from test skids",
    )


def throw(
    result: "Any", *, throw_distance: float, friction: float, launch_angle: "float | None" = None,
    launch_height: float = 0.0, grade: "float | None" = None, gravity: float, spreads: "Spreads | None" = None,
    **_: "Any",
) -> Picture:  # fmt: skip
    """Projection speed for every launch angle at this throw distance, and the one given."""
    slope = math.atan(grade or 0.0)
    height, along = launch_height * math.cos(slope), throw_distance / math.cos(slope)
    reach = along - friction * height
    drag = friction * math.cos(slope) + math.sin(slope)
    steepest = 2.0 * math.atan(friction) if reach > 0.0 else float(result.greatest_angle)
    angles = [slope + min(steepest, 0.5 * math.pi - slope) * 0.999 * i / (POINTS - 1) for i in range(POINTS)]

    def speed(angle: float) -> float:
        sine, cosine = math.sin(angle - slope), math.cos(angle - slope)
        if reach > 0.0:
            return math.sqrt(2.0 * drag * gravity * reach) / (cosine + friction * sine)
        rise = launch_height * cosine + throw_distance * sine
        return throw_distance * math.sqrt(gravity / (2.0 * cosine * rise))

    speeds = [speed(angle) for angle in angles]
    items: list[Any] = [Curve(angles, speeds, role=0)]
    items.append(Band(result.least_speed, result.least_speed, "least", vertical=False))
    if launch_angle is not None and result.speed is not None:
        items.append(Mark(launch_angle, result.speed, "as launched"))
    panel = Panel(Axis("launch angle", Angle), SPEED, tuple(items))
    title = "projection speed of the throw"
    if spreads is None or result.speed is not None or result.greatest_speed is None:
        return Picture((panel,), title)
    # without a launch angle the answer is a range, both ends of which are uncertain
    at = (result.least_speed, result.greatest_speed)
    ends = zip(("least_speed", "greatest_speed"), at, strict=True)
    low, high = zip(*(spreads.intervals.get(address, (end, end)) for address, end in ends), strict=True)
    heads = (
        worded("lower bound {speed:3}", speed=(at[0], RoadSpeed)),
        worded("upper bound {speed:3}", speed=(at[1], RoadSpeed)),
    )
    bars = Ranges(heads, low, high, at, ends=True)
    bounds = Panel(SPEED, Axis(""), (bars,), f"bounds with {100.0 * spreads.coverage:.4g} % intervals")
    return Picture((panel, bounds), title, spread=True)


def drag_factor(result: "Any", *, measurement: "Any", **_: "Any") -> Picture:
    """Drag factor over the grade of the road, everything else as it is; the load of each axle where axles are known."""
    grades = [STEEPEST * (2.0 * i / (POINTS - 1) - 1.0) for i in range(POINTS)]
    # Work along the road: f = (m + G)/√(1 + G²), m the drag factor of the tyres on a level road.
    friction = float(result.effective_friction)
    factors = [(friction + grade) / math.sqrt(1.0 + grade * grade) for grade in grades]
    items: list[Any] = [
        Curve(grades, factors, role=0),
        Mark(measurement.grade, float(result.drag_factor), "here"),
    ]
    if friction <= STEEPEST:
        items.append(Band(0.0, 0.0, "no drag", vertical=False))
    panels = [Panel(Axis("grade, uphill positive", Slope), Axis("drag factor", DragFactor), tuple(items))]
    if result.front_share is not None and result.rear_share is not None:
        fractions = [float(result.front_share), float(result.rear_share)]
        bars = Bars(("front axle", "rear axle"), [0.0, 0.0], fractions)
        panels.append(Panel(Axis("share of the weight while braking", Fraction), Axis(""), (bars,)))
    return Picture(tuple(panels), "drag factor")


def spin(
    result: "Any", *, drag: "Any", distance: float, friction: float, grade: float = 0.0, end_speed: float = 0.0,
    gravity: float, **_: "Any",
) -> Picture:  # fmt: skip
    """The share of friction acting while the vehicle turns, and its speed along the path."""
    fractions = [i / (POINTS - 1) for i in range(POINTS)]
    mean = float(result.mean_share)
    rotation = getattr(drag, "rotation", None)
    panels = []
    local = [mean] * POINTS
    if rotation is not None:
        rolling = drag.rolling_drag
        turns = [drag.start_angle + fraction * rotation for fraction in fractions]
        local = [rolling + (1.0 - rolling) * abs(math.sin(turn)) for turn in turns]
        items = (
            Curve([fraction * rotation for fraction in fractions], local, "share of the friction that acts", role=0),
            Band(mean, mean, "mean", vertical=False),
        )
        panels.append(Panel(Axis("rotation since the impact", Angle), Axis("share of the friction", Fraction), items))
    # From the end back: the decrease of v² in each stretch, scaled so that the total agrees with the answer.
    slope = math.sqrt(1.0 + grade * grade)
    squares = [end_speed * end_speed]
    for before, after in pairwise(reversed(local)):
        drag_here = (0.5 * (before + after) * friction + grade) / slope
        squares.append(squares[-1] + 2.0 * gravity * drag_here * distance / (POINTS - 1))
    top = float(result.speed) ** 2 - squares[0]
    scale = top / (squares[-1] - squares[0]) if squares[-1] != squares[0] else 1.0
    speeds = [math.sqrt(max(0.0, squares[0] + scale * (square - squares[0]))) for square in reversed(squares)]
    road = Curve([fraction * distance for fraction in fractions], speeds, role=0)
    panels.append(Panel(DISTANCE, SPEED, (road, Mark(0.0, float(result.speed), "after the impact"))))
    return Picture(tuple(panels), "a spin to rest" if end_speed == 0.0 else "a spin")
