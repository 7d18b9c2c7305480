"""What there is to look at in impacts of particles: scenes before and after, bounces, crush profiles, as data."""

import math

from dynamics_cli.pictures import Arrow, Axis, Band, Bars, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Count, Inertia, Length, RoadSpeed, Size, Speed, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

EAST, NORTH = Axis("velocity along x", RoadSpeed), Axis("velocity along y", RoadSpeed)
POINTS = 61


def _cross(vectors: "list[tuple[float, float]]") -> "tuple[Curve, ...]":
    """Thin lines through zero, as long as the longest vector: they keep the arrows inside the axes."""
    reach = 1.1 * max(max(abs(x), abs(y)) for x, y in vectors) or 1.0
    ends, zero = [-reach, reach], [0.0, 0.0]
    return Curve(ends, zero, style="thin", role=6), Curve(zero, ends, style="thin", role=6)


def _scene(
    before: "list[tuple[float, float]]",
    after: "list[tuple[float, float]]",
    changes: "list[tuple[float, float] | None]",
    title: str,
    line: "tuple[list[float], list[float]] | None" = None,
) -> Picture:
    """Velocities before and after, and the changes that the impulse made; the line of impact is named once."""
    every = [*before, *after, *(change for change in changes if change is not None)]
    panels = []
    for word, vectors in (("before", before), ("after", after), ("ΔV", changes)):
        arrows = [
            Arrow(0.0, 0.0, way[0], way[1], name, role)
            for role, (name, way) in enumerate(zip(("first", "second"), vectors, strict=True))
            if way is not None
        ]
        shown: list[Any] = [*_cross(every)]
        if line is not None:
            shown.append(Curve(*line, "line of impact" if word == "after" else "", "dashed", 5))
        panels.append(Panel(EAST, NORTH, (*shown, *arrows), word, equal=True))
    return Picture(tuple(panels), title, columns=3)


def oblique(made: "Any", **_: "Any") -> Picture:
    """Velocities before and after, the line of impact and both ΔV."""
    before, after, changes = [], [], []
    for one in (made.first, made.second):
        change = None if one.delta_v is None else one.delta_v.vector
        gone = change or (0.0, 0.0)
        after.append(one.velocity)
        before.append((one.velocity[0] - gone[0], one.velocity[1] - gone[1]))
        changes.append(change)
    turn = made.normal_direction
    compass = str(made.conventions.axes).startswith("compass")
    way = (math.sin(turn), math.cos(turn)) if compass else (math.cos(turn), math.sin(turn))
    reach = max(max(abs(x), abs(y)) for x, y in [*before, *after]) or 1.0
    line = [-reach * way[0], reach * way[0]], [-reach * way[1], reach * way[1]]
    return _scene(before, after, changes, "oblique impact", line)


def momentum(made: "Any", **_: "Any") -> Picture:
    """Velocities before and after with both ΔV."""
    compass = str(made.conventions.axes).startswith("compass")

    def vector(speed: float, heading: float) -> "tuple[float, float]":
        x, y = (math.sin(heading), math.cos(heading)) if compass else (math.cos(heading), math.sin(heading))
        return speed * x, speed * y

    both = (made.first, made.second)
    before = [vector(one.approach_speed, one.approach_heading) for one in both]
    after = [vector(one.exit_speed, one.exit_heading) for one in both]
    return _scene(before, after, [one.delta_v.vector for one in both], "momentum before and after")


def central(made: "Any", **_: "Any") -> Picture:
    """Velocities of both bodies: before, in common at the greatest compression, and after."""
    items: list[Any] = []
    for role, (name, one) in enumerate((("first", made.first), ("second", made.second))):
        items.append(
            Curve([1.0, 2.0, 3.0], [one.velocity - one.delta_v, made.common_velocity, one.velocity], name, role=role)
        )
    stage = Axis("", names=("before", "greatest compression", "after"))
    return Picture((Panel(stage, Axis("velocity", Speed), tuple(items)),), "central impact")


def drop(made: "Any", **_: "Any") -> Picture:
    """Height over time."""
    times = [made.fall_time * i / (POINTS - 1) for i in range(POINTS)]
    heights = [made.drop_height * (1.0 - (i / (POINTS - 1)) ** 2) for i in range(POINTS)]
    for one in made.bounces:
        shares = [i / (POINTS - 1) for i in range(POINTS)]
        times += [one.time + share * one.flight_time for share in shares]
        heights += [4.0 * one.height * share * (1.0 - share) for share in shares]
    items: list[Any] = [Curve(times, heights, role=0), Mark(0.0, made.drop_height, "let go")]
    if made.time_to_rest is not None and made.time_to_rest < 2.0 * times[-1]:
        items.append(Band(made.time_to_rest, made.time_to_rest, "rest"))
    return Picture((Panel(Axis("time", Time), Axis("height", Length), tuple(items)),), "bounces")


def crush(made: "Any", *, first: "Any", second: "Any" = None, **_: "Any") -> Picture:
    """The crush profiles of both vehicles."""
    panels = []
    for name, vehicle, found in (("first", first, made.first), ("second", second, made.second)):
        profile = None if vehicle is None else vehicle.profile
        if profile is None or found is None:
            continue
        depths = getattr(profile, "stations", None) or (found.mean_crush, found.mean_crush)
        width = profile.width
        x = [width * i / (len(depths) - 1) for i in range(len(depths))]
        items: list[Any] = [
            Curve([0.0, *x, width, 0.0], [0.0, *depths, 0.0, 0.0], "crush", "filled", 0),
            Curve(x, list(depths), "stations", "points", 1),
            Curve([0.0, width], [found.mean_crush, found.mean_crush], "mean", "dotted", 2),
        ]
        if found.crush_centre is not None:
            items.append(Band(found.crush_centre, found.crush_centre, "centroid"))
        panels.append(Panel(Axis("along the face", Length), Axis("depth of crush", Size), tuple(items), name))
    return Picture(tuple(panels), "crush profiles")


def chain(made: "Any", *, bodies: "Any", **_: "Any") -> Picture:
    """Velocities of the bodies before and after, law by law."""
    numbers = [float(nth) for nth in range(1, len(bodies) + 1)]
    items: list[Any] = [Curve(numbers, [body.velocity for body in bodies], "before", "points", 0)]
    for role, law in enumerate(made.laws, 1):
        speeds = [row.velocity for row in made.bodies if row.law == law.law]
        items.append(Curve(numbers, speeds, str(law.law), "points", role))
    return Picture((Panel(Axis("body", Count), Axis("velocity", Speed), tuple(items)),), "a chain of bodies")


def yaw_inertia(made: "Any", **_: "Any") -> Picture:
    """What every rule gives, and the range of all."""
    names = tuple(str(one.rule) for one in made.rules)
    rules = Bars(names, [0.0] * len(names), [float(one.yaw_inertia) for one in made.rules])
    items = (
        rules,
        Band(float(made.yaw_inertia), float(made.yaw_inertia), "estimate"),
        Band(float(made.lowest), float(made.highest), "range"),
    )
    return Picture((Panel(Axis("yaw inertia", Inertia), Axis(""), items),), "yaw inertia by rules")
