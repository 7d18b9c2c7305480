"""Pictures of a motion: curves over time, the path with velocity, acceleration and its circle of curvature."""

import cmath
import math

from dynamics_cli.errors import worded
from dynamics_cli.pictures import Arrow, Axis, Band, Curve, Mark, Panel, Picture, complex_curve
from dynamics_cli.pictures.vectors import SUM, Step, arrow, corner, head_to_tail, labelled, scene, seen, times
from dynamics_cli.pictures.vectors import curve as in_view
from dynamics_cli.quantities import Acceleration, Length, Speed, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

TIME = Axis("time", Time)
X, Y = Axis("x", Length), Axis("y", Length)
# An arrow is drawn this share of the size of the picture long.
ARROW = 0.28
ROUND = 121
DRAWN = 400
# Radii of curvature beyond so many sizes of the picture are not drawn.
LARGE = 3.0
VELOCITY, ACCELERATION, PART = 0, 1, 2


def rectilinear(result: "Any", *, phases: "Any", law: "Any" = None, let: "Any" = (), **_: "Any") -> Picture:
    """Displacement, velocity and acceleration over time."""
    from dynamics_cli.path.straight import task

    followed = task.rectilinear if law is None else task.rectilinear_law
    rows = followed(phases=phases, law=law, let=let, steps=ROUND).motion
    times = [row.time for row in rows]
    stops = result.stop_time is not None and 0.0 < result.stop_time < times[-1]
    rest = (Band(result.stop_time, result.stop_time, "at rest"),) if stops else ()
    panels = [
        Panel(TIME, Axis("displacement", Length), (Curve(times, [row.distance for row in rows], role=0), *rest)),
        Panel(TIME, Axis("velocity", Speed), (Curve(times, [row.speed for row in rows], role=0), *rest)),
        Panel(
            TIME, Axis("acceleration", Acceleration),
            (Curve(times, [row.acceleration for row in rows], role=0), Band(0.0, 0.0, vertical=False)),
        ),
    ]  # fmt: skip
    return Picture(tuple(panels), "straight motion")


def circle(result: "Any", *, radius: float, **_: "Any") -> Picture:
    """The circle with velocity and acceleration at the start and at the end."""
    items: list[Any] = [complex_curve(_arc(0j, radius, 0.0, math.pi), "", "centre", 6), Mark(0.0, 0.0, "")]
    ends = [("start" if result.angle is not None else "", 0.0, result.start)]
    if result.angle is not None:
        ends.append(("end", result.angle, result))
    fastest = max(abs(end.speed) for _, _, end in ends)
    hardest = max(end.acceleration for _, _, end in ends)
    for name, angle, end in ends:
        out = cmath.rect(1.0, angle)
        place, rate = radius * out, (1j * end.tangential - end.normal) * out
        items += [Mark(place.real, place.imag, name), _arrow(place, 1j * end.speed * out, fastest, radius, "v")]
        items.append(_arrow(place, rate, hardest, radius, "a"))
    return Picture((Panel(X, Y, tuple(items), equal=True),), "velocity and acceleration on the circle")


def _arc(centre: complex, radius: float, heading: float, half: float) -> "list[complex]":
    """Part of a circle, so far on either side of a heading."""
    return [centre + cmath.rect(radius, heading + half * (2.0 * i / (ROUND - 1) - 1.0)) for i in range(ROUND)]


def _scaled(vector: complex, largest: float, size: float) -> complex:
    return 2.0 * ARROW * size / largest * vector if largest else 0j


def _arrow(place: complex, vector: complex, largest: float, size: float, label: str) -> Arrow:
    way = _scaled(vector, largest, size)
    return Arrow(place.real, place.imag, way.real, way.imag, label, VELOCITY if label == "v" else ACCELERATION)


def around(result: "Any", *, radius: float, angle: float = 0.0, **_: "Any") -> Picture:
    """The radius, velocity and acceleration with its parts, in the plane square to the axis."""
    place, velocity, rate = (
        complex(*v[:2]) for v in (result.position, result.cartesian_velocity, result.cartesian_acceleration)
    )
    out, largest = cmath.rect(1.0, angle), max(abs(rate), 1e-300)
    parts = (("aᵣ", result.radial_acceleration * out), ("aθ", result.transverse_acceleration * 1j * out))
    steps = []
    for name, vector, longest, role in (
        *((name, part, largest, PART) for name, part in parts if abs(part) > 0.02 * largest),
        ("v", velocity, abs(velocity), VELOCITY),
        ("a", rate, largest, ACCELERATION),
    ):
        way = _scaled(vector, longest, radius or 0.5)
        steps.append(Step((place.real, place.imag), (way.real, way.imag), name, role, dashed=role == PART))
    items: list[Any] = [
        complex_curve((0j, place), "", "thin", 6),
        Mark(0.0, 0.0, "axis", (-6.0, 6.0)),
        *labelled(steps),
        Mark(place.real, place.imag, ""),
    ]
    return Picture((Panel(X, Y, tuple(items), equal=True),), "velocity and acceleration, with their parts")


def in_space(result: "Any", **_: "Any") -> Picture:
    """Velocity and acceleration seen in the plane of both, with the circle of curvature."""
    if result.tangential is None or result.normal is None:
        items: list[Any] = [Arrow(0.0, 0.0, 1.0, 0.0, "a", role=ACCELERATION), Mark(0.0, 0.0, "at rest")]
        return Picture((Panel(Axis("along a"), Axis("across"), tuple(items), equal=True),), "acceleration")
    radius, rate = result.radius_of_curvature, complex(result.tangential, result.normal)
    items, kind = [], None
    if radius is not None:
        kind = Length
        arc = _arc(1j * radius, radius, -0.5 * math.pi, math.radians(70.0))
        items = [complex_curve(arc, "path (circle of curvature)", "thin", 6), Mark(0.0, radius, "centre of curvature")]
    size = 1.0 if radius is None else radius
    items += [_arrow(0j, complex(result.speed), result.speed, size, "v"), _arrow(0j, rate, abs(rate), size, "a")]
    along, across = Axis("along the path, T", kind), Axis("to the centre, N", kind)
    panel = Panel(along, across, (*items, Mark(0.0, 0.0, "")), equal=True)
    return Picture((panel,), "velocity and acceleration along and across the path")


def curve(
    result: "Any", *, x: "Any" = None, y: "Any" = None, z: "Any" = None, shape: "Any" = None, let: "Any" = (),
    radius_law: "Any" = None, angle_law: "Any" = None, length_law: "Any" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """The path with velocity, acceleration and circle of curvature; speed and acceleration over time."""
    from dynamics_cli.path.curves.task import moving_point

    laws = {"radius law": radius_law, "angle law": angle_law, "length law": length_law}
    motion = moving_point({"x": x, "y": y, "z": z}, laws, shape, let).plainly()
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
    place, velocity, rate = (complex(*v[:2]) for v in (result.position, result.velocity, result.acceleration))
    items: list[Any] = [Curve(xs, ys, role=3, style="thick")]
    radius = result.radius_of_curvature
    if radius is not None and radius < LARGE * size and result.speed > 0.0:
        side = math.copysign(radius / result.speed, (velocity.conjugate() * rate).imag)
        centre = place + 1j * side * velocity
        # as much of a large circle as the path is long: the path fills the picture
        ring = _arc(centre, radius, cmath.phase(place - centre), min(math.pi, size / radius))
        items.append(complex_curve(ring, "circle of curvature", "dotted", 6))
    items += [_arrow(place, v, abs(v), size, name) for v, name in ((velocity, "v"), (rate, "a")) if v]
    return Panel(X, Y, (*items, Mark(place.real, place.imag, "")), equal=True)


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
