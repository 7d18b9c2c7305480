"""Pictures of a motion: curves over time, the path with velocity, acceleration and its circle of curvature."""

import math
from itertools import pairwise

from dynamics_cli.errors import worded
from dynamics_cli.pictures import Arrow, Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.pictures.vectors import SUM, Step, arrow, corner, head_to_tail, labelled, scene, seen, times
from dynamics_cli.pictures.vectors import curve as in_view
from dynamics_cli.quantities import Acceleration, Length, Speed, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Plane = tuple[float, float]

TIME = Axis("time", Time)
X, Y = Axis("x", Length), Axis("y", Length)
# An arrow is drawn this share of the size of the picture long.
ARROW = 0.28
ROUND = 121
DRAWN = 400
# Radii of curvature beyond so many sizes of the picture are not drawn.
LARGE = 3.0
VELOCITY, ACCELERATION, PART = 0, 1, 2


def rectilinear(result: "Any", **_: "Any") -> Picture:
    """Displacement, velocity and acceleration over time."""
    times, distances, speeds, rates = _smooth(result.motion)
    stops = result.stop_time is not None and 0.0 < result.stop_time < times[-1]
    rest = (Band(result.stop_time, result.stop_time, "at rest"),) if stops else ()
    panels = [
        Panel(TIME, Axis("displacement", Length), (Curve(times, distances, role=0), *rest)),
        Panel(TIME, Axis("velocity", Speed), (Curve(times, speeds, role=0), *rest)),
        Panel(TIME, Axis("acceleration", Acceleration), (Curve(times, rates, role=0), Band(0.0, 0.0, vertical=False))),
    ]
    return Picture(tuple(panels), "straight motion")


def _smooth(rows: "Sequence[Any]") -> "tuple[list[float], ...]":
    """Cubics through displacements and velocities of the table, from row to row, and the slope of the latter."""
    track: tuple[list[float], ...] = ([], [], [], [])
    for row, following in pairwise(rows):
        span = following.time - row.time
        for u in (i / 12 for i in range(13)) if span > 0.0 else ():
            place = _cubic(u, row.distance, following.distance, span * row.speed, span * following.speed)
            speed = _cubic(u, row.speed, following.speed, span * row.acceleration, span * following.acceleration)
            now = row.time + u * span, place[0], speed[0], speed[1] / span
            for column, value in zip(track, now, strict=True):
                column.append(value)
    return track


def _cubic(u: float, first: float, last: float, slope: float, end: float) -> "tuple[float, float]":
    """The cubic with these values and slopes at 0 and 1, and its slope."""
    w, rise = 1.0 - u, last - first
    value = w * w * (1 + 2 * u) * first + u * u * (1 + 2 * w) * last + u * w * (w * slope - u * end)
    return value, 6.0 * u * w * rise + w * (1 - 3 * u) * slope + u * (1 - 3 * w) * end


def circle(result: "Any", *, radius: float, **_: "Any") -> Picture:
    """The circle with velocity and acceleration at the start and at the end."""
    items: list[Any] = [_ring((0.0, 0.0), radius, "centre"), Mark(0.0, 0.0, "")]
    ends = [("start" if result.angle is not None else "", 0.0, result.start)]
    if result.angle is not None:
        ends.append(("end", result.angle, result))
    fastest = max(abs(end.speed) for _, _, end in ends)
    hardest = max(end.acceleration for _, _, end in ends)
    for name, angle, end in ends:
        along, inward = (-math.sin(angle), math.cos(angle)), (-math.cos(angle), -math.sin(angle))
        place = (radius * math.cos(angle), radius * math.sin(angle))
        rate = _sum((end.tangential, along), (end.normal, inward))
        items += [Mark(*place, name), _arrow(place, (end.speed * along[0], end.speed * along[1]), fastest, radius, "v")]
        items.append(_arrow(place, rate, hardest, radius, "a"))
    return Picture((Panel(X, Y, tuple(items), equal=True),), "velocity and acceleration on the circle")


def _sum(*parts: "tuple[float, Plane]") -> "Plane":
    return sum(size * direction[0] for size, direction in parts), sum(size * direction[1] for size, direction in parts)


def _ring(centre: "Plane", radius: float, style: "Any", label: str = "") -> Curve:
    angles = [2.0 * math.pi * i / (ROUND - 1) for i in range(ROUND)]
    x = [centre[0] + radius * math.cos(angle) for angle in angles]
    return Curve(x, [centre[1] + radius * math.sin(angle) for angle in angles], label, style, role=6)


def _arrow(place: "Plane", vector: "Plane", largest: float, size: float, label: str) -> Arrow:
    return Arrow(*place, *_scaled(vector, largest, size), label, VELOCITY if label == "v" else ACCELERATION)


def around(result: "Any", *, radius: float, angle: float = 0.0, **_: "Any") -> Picture:
    """The radius, velocity and acceleration with its parts, in the plane square to the axis."""
    place = (result.position[0], result.position[1])
    out, beside = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    size = radius or 0.5
    rate = (result.cartesian_acceleration[0], result.cartesian_acceleration[1])
    parts = [
        ("aᵣ", (result.radial_acceleration * out[0], result.radial_acceleration * out[1])),
        ("aθ", (result.transverse_acceleration * beside[0], result.transverse_acceleration * beside[1])),
    ]
    largest = max(math.hypot(*rate), 1e-300)
    velocity = (result.cartesian_velocity[0], result.cartesian_velocity[1])
    steps = [
        Step(place, _scaled(part, largest, size), name, PART, dashed=True)
        for name, part in parts
        if math.hypot(*part) > 0.02 * largest
    ]
    steps += [
        Step(place, _scaled(velocity, math.hypot(*velocity), size), "v", VELOCITY),
        Step(place, _scaled(rate, largest, size), "a", ACCELERATION),
    ]
    items: list[Any] = [
        Curve([0.0, place[0]], [0.0, place[1]], "", "thin", role=6),
        Mark(0.0, 0.0, "axis", (-6.0, 6.0)),
        *labelled(steps),
        Mark(*place, ""),
    ]
    return Picture((Panel(X, Y, tuple(items), equal=True),), "velocity and acceleration, with their parts")


def _scaled(vector: "Plane", largest: float, size: float) -> "Plane":
    factor = 2.0 * ARROW * size / largest if largest else 0.0
    return factor * vector[0], factor * vector[1]


def in_space(result: "Any", **_: "Any") -> Picture:
    """Velocity and acceleration seen in the plane of both, with the circle of curvature."""
    speed = result.speed
    tangential, normal = result.tangential, result.normal
    if tangential is None or normal is None:
        items: tuple[Any, ...] = (Arrow(0.0, 0.0, 1.0, 0.0, "a", role=ACCELERATION), Mark(0.0, 0.0, "at rest"))
        return Picture((Panel(Axis("along a"), Axis("across"), items, equal=True),), "acceleration")
    size = result.radius_of_curvature if result.radius_of_curvature is not None else 1.0
    items = (
        *(() if result.radius_of_curvature is None else (
            Curve(*_arc(size), "path (circle of curvature)", "thin", role=6),
            Mark(0.0, size, "centre of curvature"),
        )),
        _arrow((0.0, 0.0), (speed, 0.0), speed, size, "v"),
        _arrow((0.0, 0.0), (tangential, normal), math.hypot(tangential, normal), size, "a"),
        Mark(0.0, 0.0, ""),
    )  # fmt: skip
    kind = None if result.radius_of_curvature is None else Length
    along, across = Axis("along the path, T", kind), Axis("to the centre, N", kind)
    return Picture((Panel(along, across, items, equal=True),), "velocity and acceleration along and across the path")


def _arc(radius: float) -> "tuple[list[float], list[float]]":
    angles = [math.radians(-70.0 + 140.0 * i / (ROUND - 1)) for i in range(ROUND)]
    return [radius * math.sin(angle) for angle in angles], [radius * (1.0 - math.cos(angle)) for angle in angles]


def curve(result: "Any", *, x: "Any" = None, y: "Any" = None, z: "Any" = None, shape: "Any" = None, let: "Any" = (),
          angle_law: "Any" = None, length_law: "Any" = None, **_: "Any") -> Picture:  # fmt: skip
    """The path with velocity, acceleration and circle of curvature; speed and acceleration over time."""
    from dynamics_cli.path.curves.moving_point import MovingPoint

    law = angle_law if angle_law is not None else length_law
    motion = MovingPoint({"x": x, "y": y, "z": z}, shape, law, let).plainly()
    rows = result.points
    if not rows:
        return in_space(result)
    first, last = rows[0].time, rows[-1].time
    times = [first + (last - first) * i / DRAWN for i in range(DRAWN + 1)]
    states = [motion.state(time) for time in times]
    path = _path_panel(result, states) if motion.flat else _path_in_space(result, states)
    rates = [
        Curve(times, [_or_gap(state.bend.tangential) for state in states], "aₜ", role=ACCELERATION),
        Curve(times, [_or_gap(state.bend.normal) for state in states], "aₙ", "dashed", role=PART),
    ]
    speeds = Panel(TIME, Axis("speed", Speed), (Curve(times, [state.bend.speed for state in states], role=VELOCITY),))
    panels = (path, speeds, Panel(TIME, Axis("acceleration", Acceleration), tuple(rates)))
    return Picture(panels, "motion along the curve" + ("" if motion.flat else ", seen obliquely"))


def _or_gap(value: "float | None") -> float:
    return math.nan if value is None else value


def _path_panel(result: "Any", states: "Sequence[Any]") -> Panel:
    xs, ys = [state.position[0] for state in states], [state.position[1] for state in states]
    size = 0.5 * max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0
    place = (result.position[0], result.position[1])
    items: list[Any] = [Curve(xs, ys, role=3, style="thick")]
    radius = result.radius_of_curvature
    if radius is not None and radius < LARGE * size and result.speed > 0.0:
        v, turn = (
            result.velocity,
            result.velocity[0] * result.acceleration[1] - result.velocity[1] * result.acceleration[0],
        )
        side = math.copysign(radius / result.speed, turn)
        centre = place[0] - side * v[1], place[1] + side * v[0]
        # as much of a large circle as the path is long: the path fills the picture
        half, heading = min(math.pi, size / radius), math.atan2(place[1] - centre[1], place[0] - centre[0])
        around = [heading + half * (2.0 * i / (ROUND - 1) - 1.0) for i in range(ROUND)]
        xs, ys = ([c + radius * wave(t) for t in around] for c, wave in zip(centre, (math.cos, math.sin), strict=True))
        items.append(Curve(xs, ys, "circle of curvature", "dotted", role=6))
    velocity, rate = (result.velocity[0], result.velocity[1]), (result.acceleration[0], result.acceleration[1])
    if math.hypot(*velocity):
        items.append(_arrow(place, velocity, math.hypot(*velocity), size, "v"))
    if math.hypot(*rate):
        items.append(_arrow(place, rate, math.hypot(*rate), size, "a"))
    items.append(Mark(*place, ""))
    return Panel(X, Y, tuple(items), equal=True)


def _path_in_space(result: "Any", states: "Sequence[Any]") -> Panel:
    """The path seen obliquely, with velocity and acceleration at the time shown."""
    places = [state.position for state in states]
    size = max(math.dist(place, places[0]) for place in places) or 1.0
    items: list[Any] = [in_view(places, "thick", 3)]
    for name, vector, role in (("v", result.velocity, VELOCITY), ("a", result.acceleration, ACCELERATION)):
        length = math.hypot(*vector)
        if length:
            items.append(arrow(times(ARROW * size / length, vector), name, role, start=result.position))
    return scene([*items, Mark(*seen(result.position), ""), *corner(items)])


def table(result: "Any", _file: str = "", **_: "Any") -> Picture:
    """The smoothed track, its speed, and its accelerations within their noise."""
    rows = result.points
    times = [row.time for row in rows]
    panels = []
    if rows[0].y is not None:
        ends = (Mark(rows[0].x, rows[0].y, "start"), Mark(rows[-1].x, rows[-1].y, "end"))
        track = (Curve([row.x for row in rows], [row.y for row in rows], role=3, style="thick"), *ends)
        panels.append(Panel(X, Y, track, equal=True))
    panels.append(Panel(TIME, Axis("speed", Speed), (Curve(times, [row.speed for row in rows], role=VELOCITY),)))
    rates: list[Any] = []
    for label, name, role in (("aₜ along", "tangential", ACCELERATION), ("aₙ across", "normal", PART)):
        values = [getattr(row, name) for row in rows]
        if name == "normal" and rows[0].y is None:
            continue
        noise = [row.acceleration_noise for row in rows]
        rates.append(Curve(times, values, label, role=role))
        rates += [
            Curve(times, [v + s * n for v, n in zip(values, noise, strict=True)], "", "dots", role) for s in (-1, 1)
        ]
    panels.append(Panel(TIME, Axis("acceleration", Acceleration), tuple(rates)))
    return Picture(tuple(panels), "the measured track", subtitle="dotted: one standard deviation of the noise")


def relative(result: "Any", *, first: "Any", second: "Any", end: "Any" = None, let: "Any" = (), **_: "Any") -> Picture:
    """Both paths, seen along z, and where they are closest; with tracks their distance over time within its noise."""
    from dynamics_cli.path.relative.motions import Pair

    pair = Pair(first, second, let)
    simple = first.simple and second.simple
    span = (1.5 * result.closest_time or 1.0) if simple else pair.end(end) - pair.start
    items: list[Any] = []
    for motion, name, place, role in zip(
        pair.motions, ("first", "second"), (result.first_position, result.second_position), (0, 1), strict=True
    ):
        states = [motion.at(pair.start + span * i / DRAWN)[0] for i in range(DRAWN + 1)]
        items += [
            Curve([r[0] for r in states], [r[1] for r in states], name, role=role),
            Mark(states[0][0], states[0][1], "", role=role),
            Mark(place[0], place[1], "", role=role),
        ]
    ends = result.first_position, result.second_position
    name = worded("{d} after {t}", d=(result.closest_distance, Length), t=(result.closest_time, Time))
    items += [
        Curve([ends[0][0], ends[1][0]], [ends[0][1], ends[1][1]], "closest approach", "dashed", role=6),
        Mark(0.5 * (ends[0][0] + ends[1][0]), 0.5 * (ends[0][1] + ends[1][1]), name, (7.0, -10.0), dot=False, role=6),
    ]
    paths = Panel(X, Y, tuple(items), equal=True)
    if not result.points:
        return Picture((paths,), "two paths and their closest approach")
    rows = [row for row in result.points if row.closing_speed is not None]
    times = [row.time for row in rows]
    closest = Mark(result.closest_time, result.closest_distance, "closest", (0.0, -12.0))
    distance = Panel(TIME, Axis("distance", Length), (Curve(times, [row.distance for row in rows], role=3), closest))
    closing = [Curve(times, [row.closing_speed for row in rows], role=VELOCITY)]
    for sign in (-1.0, 1.0):
        edge = [row.closing_speed + sign * row.closing_speed_noise for row in rows]
        closing.append(Curve(times, edge, "", "dots", VELOCITY))
    panels = (paths, distance, Panel(TIME, Axis("closing speed", Speed), tuple(closing)))
    words = "dotted: one standard deviation of the noise"
    return Picture(panels, "two tracks and their closest approach", subtitle=words)


def moving_frame(result: "Any", **_: "Any") -> Picture:
    """The five terms of the acceleration head to tail, seen along z of the frame, and their sum."""
    names = {"a of O": result.origin_part, "α×r": result.angular_part, "ω×(ω×r)": result.centripetal,
             "2ω×v": result.coriolis, "a in frame": result.relative_part}  # fmt: skip
    shown = {name: part for name, part in names.items() if math.hypot(part[0], part[1])}
    total = Step((0.0, 0.0), (result.acceleration[0], result.acceleration[1]), "a", SUM, dashed=True)
    items = labelled(head_to_tail(list(shown.values()), list(shown), total))
    panel = Panel(Axis("acceleration along x", Acceleration), Axis("along y", Acceleration), tuple(items), equal=True)
    return Picture((panel,), "the terms of the acceleration, head to tail")
