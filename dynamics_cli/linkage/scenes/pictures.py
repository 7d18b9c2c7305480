"""Pictures of a linkage from a scene: poses over the driver's range, paths of the pins, and a moving SVG."""

from math import pi

from dynamics_cli.animation import animated
from dynamics_cli.linkage.drawing import pin as pin_mark
from dynamics_cli.linkage.drawing import plan
from dynamics_cli.numerics.linkages.records import GROUND, Scene
from dynamics_cli.pictures import Arrow, Axis, Curve, Panel, Picture, complex_curve
from dynamics_cli.quantities import Angle, Coordinate, Speed, TurnRate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Pins = dict[str, complex]

FRAMES = 90
# Points of a curve over the driver's range, however few rows the table has.
SMOOTH = 180
GHOSTS = 5
ARROW = 0.25
# How far a pushed pin goes in a picture, in sizes of the linkage.
PUSH = 0.5
# Centres this close have their labels on different sides.
CLOSE = 0.12
ASIDE = ((5.0, 5.0), (5.0, -12.0), (-36.0, 5.0), (-36.0, -12.0), (5.0, 17.0))


def motion(scene: Scene, start: "Pins", count: int, span: "float | None" = None) -> "list[Pins]":
    """Poses over a turn of the first driver, or over its range in both directions and back; with a span, over that."""
    from dynamics_cli.linkage.scenes.continuation import Continuation
    from dynamics_cli.numerics.linkages.system import System

    system = System(scene)
    first = scene.drivers[0]
    q = system.vector({pin: place / system.scale for pin, place in start.items()})
    range_ = span or (PUSH * system.scale if first.point else 2.0 * pi)

    def run(sense: int) -> "list[Pins]":
        walk, poses = Continuation(system, q), [start]
        while len(poses) < count and walk.to(sense * range_ * len(poses) / count):
            poses.append({pin: place * system.scale for pin, place in walk.system.positions(walk.q).items()})
        return poses

    forward = run(1)
    whole = not first.point and range_ % (2.0 * pi) == 0.0
    if len(forward) == count or span:
        return forward if whole and len(forward) == count else [*forward, *forward[-2:0:-1]]
    outward = [*run(-1)[:0:-1], *forward]
    return outward + outward[-2:0:-1] if len(outward) > 2 else outward


def _shape(scene: Scene, name: str, at: "Pins") -> "list[complex]":
    """A link as a line, or as a polygon through its points."""
    names = [pin.name for link in scene.links if link.name == name for pin in link.points]
    points = [at[pin] for pin in names]
    return [*points, points[0]] if len(points) > 2 else points


def _posed(result: "Any", scene: Scene) -> "Any":
    """The result with its pins, which one that follows a motion leaves out."""
    from dynamics_cli.linkage.scenes.solve import solve

    return result if result.pins is not None else solve(scene)


def scene_picture(
    result: "Any",
    scene: Scene,
    follow: str = "",
    turn: "float | None" = None,
    travel: "float | None" = None,
    **_: "Any",
) -> Picture:
    """The linkage, ghosts of it over the driver's range, the paths of its pins, and their velocities."""
    curves = _curves(scene, follow, turn, travel) if result.motion else ()
    result = _posed(result, scene)
    places = {pin.name: complex(*pin.position) for pin in result.pins}
    poses = motion(scene, places, FRAMES, turn or travel)
    moving = [link.name for link in scene.links if link.name != GROUND]
    items: list[Any] = []
    for pose in poses[:: max(1, len(poses) // GHOSTS)]:
        items += [complex_curve(_shape(scene, name, pose), "", "dots", 6) for name in moving]
    fixed = {pin.name for link in scene.links if link.name == GROUND for pin in link.points}
    closed = [*poses, poses[0]]
    items += [complex_curve([pose[pin] for pose in closed], "", "thin", 3) for pin in places if pin not in fixed]
    items += [complex_curve(_shape(scene, name, places), name, "thick", index) for index, name in enumerate(moving)]
    for slide in scene.slides:
        items.append(complex_curve((places[slide.start], places[slide.end]), "", "centre", 5))
    size = max(abs(first - second) for first in places.values() for second in places.values())
    speeds = {pin.name: complex(*pin.velocity) for pin in result.pins if pin.velocity is not None}
    longest = max((abs(speed) for speed in speeds.values()), default=0.0)
    for pin, place in places.items():
        items.append(pin_mark(place, pin))
        if longest and abs(speeds.get(pin, 0j)) > 0.0:
            arrow = speeds[pin] * (ARROW * size / longest)
            items.append(Arrow(place.real, place.imag, arrow.real, arrow.imag, "", 6))
    words = "with velocities" if longest else "paths of its pins"
    return Picture((plan(items), *curves), f"linkage of {len(scene.links)} links, {words}")


def _curves(scene: Scene, name: str, turn: "float | None", travel: "float | None") -> "tuple[Panel, ...]":
    """The followed link's angle and speed, or pin's coordinates, over the driver's range."""
    from dynamics_cli.linkage.scenes.solve import solve

    rows = solve(scene, follow=name, steps=SMOOTH, turn=turn, travel=travel).motion or ()
    pushed = rows[0].driver_angle is None
    positions: Any = [row.driver_position if pushed else row.driver_angle for row in rows]
    ends = min(positions), max(positions)
    axis = (
        Axis("driver position", Coordinate, ends=ends)
        if pushed
        else Axis("driver angle", Angle, ends=ends, step=pi / 6.0)
    )
    panels: list[Panel] = []
    if rows[0].angle is None:
        for quantity, kind in (("position", Coordinate), ("velocity", Speed)):
            vectors: Any = [getattr(row, quantity) for row in rows]
            if None not in vectors and any(map(any, vectors)):
                x, y = ([vector[i] for vector in vectors] for i in (0, 1))
                curves = (Curve(positions, x, "x", role=0), Curve(positions, y, "y", "dashed", 1))
                panels.append(Panel(axis, Axis(quantity, kind), curves, "" if panels else f"pin {name}"))
        return tuple(panels)
    angles: Any = [row.angle for row in rows]
    speeds: Any = [row.speed for row in rows]
    panels.append(Panel(axis, Axis("angle", Angle), (Curve(positions, angles, role=0),), f"link {name}"))
    if None not in speeds and any(speeds):
        panels.append(Panel(axis, Axis("angular velocity ω", TurnRate), (Curve(positions, speeds, role=1),)))
    return tuple(panels)


def centres_picture(result: "Any", scene: Scene, **_: "Any") -> Picture:
    """The linkage with its instant centres."""
    from dynamics_cli.linkage.scenes.solve import solve

    solved = solve(scene)
    places = {pin.name: complex(*pin.position) for pin in solved.pins or ()}
    size = max(abs(centre - other) for centre in places.values() for other in places.values())
    middle = sum(places.values()) / len(places)
    moving = [link.name for link in scene.links if link.name != GROUND]
    items: list[Any] = [
        complex_curve(_shape(scene, name, places), name, "thick", index) for index, name in enumerate(moving)
    ]
    names = {link.name: str(number) for number, link in enumerate(scene.links, 1)}
    far = []
    placed: list[tuple[complex, int]] = []
    for centre in result.centres:
        label = f"I({names[centre.first]},{names[centre.second]})"
        if centre.position is None or abs(complex(*centre.position) - middle) > 4.0 * size:
            far.append(label)
        else:
            place = complex(*centre.position)
            beside = sum(abs(place - other) < CLOSE * size for other, _ in placed)
            placed.append((place, beside))
            items.append(pin_mark(place, label, ASIDE[beside % len(ASIDE)]))
    order = ", ".join(f"{number} {name}" for name, number in names.items())
    title = f"instant centres: {order}" + (f"\nfar away: {', '.join(far)}" if far else "")
    return Picture((plan(items),), title)


def moving_scene(
    result: "Any", scene: Scene, turn: "float | None" = None, travel: "float | None" = None, **_: "Any"
) -> str:
    """The linkage over its driver's range as an animated SVG."""
    result = _posed(result, scene)
    places = {pin.name: complex(*pin.position) for pin in result.pins}
    poses = motion(scene, places, FRAMES, turn or travel)
    moving = [link.name for link in scene.links if link.name != GROUND]
    fixed = [pin.name for link in scene.links if link.name == GROUND for pin in link.points]
    free = [pin for pin in places if pin not in fixed]
    frames = [[_shape(scene, name, pose) for name in moving] for pose in poses]
    traces = [[pose[pin] for pose in [*poses, poses[0]]] for pin in free]
    traces += [[places[slide.start], places[slide.end]] for slide in scene.slides if slide.link == GROUND]
    pins = [[pose[pin] for pin in free] for pose in poses]
    return animated("A linkage in motion", frames, traces, [places[pin] for pin in fixed], pins)
