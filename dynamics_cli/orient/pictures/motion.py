"""Pictures of turning motion: angular velocities tip to tail, terms of an acceleration, points of a body."""

from math import hypot

from dynamics_cli.errors import worded
from dynamics_cli.numerics.number import plain
from dynamics_cli.orient.pictures.space import GREY, arrow, curve, numbers, scene, seen, triad, view_of, words
from dynamics_cli.pictures import Panel, Picture
from dynamics_cli.quantities import Acceleration, AngularAcceleration, AngularRate, Speed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Vector = tuple[float, float, float]

ROOM = 1.35


def _size(v: "Sequence[float]") -> float:
    return hypot(*v)


def _unit(v: "Sequence[float]") -> "Vector":
    size = _size(v) or 1.0
    return v[0] / size, v[1] / size, v[2] / size


def _sum(v: "Sequence[float]", w: "Sequence[float]") -> "Vector":
    return v[0] + w[0], v[1] + w[1], v[2] + w[2]


def _polygon(terms: "Sequence[tuple[str, Any]]", total: "Any", name: str, title: "Any") -> Panel:
    """Vectors tip to tail, and their sum."""
    terms_shown = [(label, numbers(v)) for label, v in terms]
    terms_shown = [(label, v) for label, v in terms_shown if any(v)]
    resultant = numbers(total)
    view = view_of([resultant, *(v for _, v in terms_shown)])
    items: list[Any] = []
    tip: Vector = (0.0, 0.0, 0.0)
    for role, (label, v) in enumerate(terms_shown, 1):
        items.append(arrow(v, label, role % 6, view, start=tip))
        tip = _sum(tip, v)
    items.append(arrow(resultant, name, 0, view, dashed=len(terms_shown) > 1))
    return scene(items, title)


def rates(answer: "Any", **_: "Any") -> Picture:
    """The body's axes, the axes that the angles turn about, and directions of ω and α."""
    matrix = [numbers(row) for row in answer.rotation_matrix]
    items = triad(matrix, "′", GREY, dashed=True)
    axes = (answer.first_partial, answer.second_partial, answer.third_partial)
    for nth, axis in enumerate(axes):
        n = numbers(axis)
        items += [curve([(0.0, 0.0, 0.0), tuple(0.8 * part for part in n)], "centre", 2)]
        items.append(words(tuple(0.87 * part for part in n), "u₁u₂u₃"[2 * nth : 2 * nth + 2], 2))
    for v, name, role in ((answer.angular_velocity, "ω", 0), (answer.angular_acceleration, "α", 1)):
        if any(numbers(v)):
            n = _unit(numbers(v))
            items += [arrow(n, "", role), words(tuple(1.12 * part for part in n), name, role)]
    subtitle = worded(
        "directions of ω ({w}) and α ({a}); u₁ u₂ u₃ are the axes of the angles",
        w=(answer.angular_speed, AngularRate),
        a=(answer.angular_acceleration_size, AngularAcceleration),
    )
    return Picture((scene(items, subtitle, room=ROOM),), "angular velocity and acceleration")


def addition(answer: "Any", **_: "Any") -> Picture:
    """Angular velocities of the links tip to tail, and the terms of the angular acceleration."""
    velocities = [(link.name, link.relative_velocity) for link in answer.links]
    terms = []
    for link in answer.links:
        terms += [(link.name, link.relative_acceleration), (f"ω × {link.name}", link.carried)]
    panels = [
        _polygon(velocities, answer.angular_velocity, "ω", worded("ω {v}", v=(answer.angular_speed, AngularRate))),
        _polygon(
            terms,
            answer.angular_acceleration,
            "α",
            worded("α {v}", v=(answer.angular_acceleration_size, AngularAcceleration)),
        ),
    ]
    return Picture(tuple(panels), "addition along the chain", columns=2)


def moving_point(answer: "Any", *, relative_velocity: "Any" = (0.0, 0.0, 0.0), **_: "Any") -> Picture:
    """Velocity and acceleration with their terms, tip to tail."""
    carried, relative = numbers(answer.carried_velocity), numbers(relative_velocity)
    total = numbers(answer.velocity)
    origin = tuple(v - a - b for v, a, b in zip(total, carried, relative, strict=True))
    tiny = 1e-12 * (_size(total) + _size(carried))
    velocities = [
        ("v_O", origin if _size(origin) > tiny else (0.0, 0.0, 0.0)), ("ω × r", carried), ("v_rel", relative)
    ]  # fmt: skip
    terms = [
        ("a_O", answer.origin_acceleration),
        ("α × r", answer.tangential),
        ("ω × (ω × r)", answer.centripetal),
        ("2 ω × v_rel", answer.coriolis),
        ("a_rel", answer.relative),
    ]
    panels = (
        _polygon(velocities, total, "v", worded("v {v}", v=(answer.speed, Speed))),
        _polygon(terms, answer.acceleration, "a", worded("a {v}", v=(answer.acceleration_size, Acceleration))),
    )
    return Picture(panels, "a point moving on a moving body", columns=2)


def points(answer: "Any", **_: "Any") -> Picture:
    """The points with their velocities, and the screw axis."""
    places = [numbers(point.position) for point in answer.points]
    speeds = [numbers(point.velocity) for point in answer.points]
    fastest = max((_size(v) for v in speeds), default=0.0) or 1.0
    reach = max((_size(p) for p in places), default=0.0) or 1.0
    if answer.axis_point is not None:
        reach = max(reach, _size(numbers(answer.axis_point)))
    scale = 0.5 * reach / fastest
    view = view_of([*places, *speeds]) if answer.axis is None or abs(plain(answer.axis[2])) > 1.0 - 1e-12 else seen
    items: list[Any] = []
    for point, place, v in zip(answer.points, places, speeds, strict=True):
        items.append(curve([place], "points", 0, view))
        items.append(arrow(tuple(scale * part for part in v), "", 1, view, start=place))
        items.append(words(tuple(1.08 * part for part in place), point.name, 0, view))
    items.append(curve([*places, places[0]], "thin", GREY, view))
    if answer.axis is not None:
        foot, n = numbers(answer.axis_point), numbers(answer.axis)
        if view is seen:
            ends = [_sum(foot, tuple(k * reach * part for part in n)) for k in (-0.3, 0.9)]
            items += [curve(ends, "centre", 3), words(ends[1], "axis", 3)]
        else:
            items += [curve([foot], "points", 3, view), words(tuple(f - 0.08 * reach for f in foot), "axis", 3, view)]
    subtitle = worded("velocities, the fastest {v}; screw axis dash-dotted", v=(fastest, Speed))
    return Picture((scene(items, subtitle),), "points of a rigid body")


def rolling(answer: "Any", *, normal: "Any", **_: "Any") -> Picture:
    """Relative angular velocity at the contact, with its spin and roll parts."""
    n = _unit(numbers(normal))
    spin = float(plain(answer.spin))
    roll = numbers(answer.roll)
    relative = _sum(roll, tuple(spin * part for part in n))
    size = _size(relative) or 1.0
    first = _unit(roll) if any(roll) else _unit((n[1] - n[2], n[2] - n[0], n[0] - n[1]))
    across = (
        n[1] * first[2] - n[2] * first[1],
        n[2] * first[0] - n[0] * first[2],
        n[0] * first[1] - n[1] * first[0],
    )
    plane = [tuple(0.9 * (a * p + b * q) for p, q in zip(first, across, strict=True))
             for a, b in ((1, 1), (1, -1), (-1, -1), (-1, 1), (1, 1))]  # fmt: skip
    items: list[Any] = [
        curve(plane, "filled", GREY),
        curve([(0.0, 0.0, 0.0), tuple(0.9 * part for part in n)], "centre", GREY),
        words(tuple(part for part in n), "normal", GREY),
    ]
    if abs(spin) > 1e-12 * size and any(roll):
        items += [
            arrow(tuple(part / size for part in roll), "roll", 2),
            arrow(tuple(spin / size * part for part in n), "spin", 1),
        ]
    items.append(arrow(tuple(part / size for part in relative), "ω₁ − ω₂", 0))
    subtitle = worded(
        "roll {r}, spin {s}, slip {v}",
        r=(answer.roll_speed, AngularRate),
        s=(answer.spin, AngularRate),
        v=(answer.slip_speed, Speed),
    )
    return Picture((scene(items, subtitle, room=ROOM),), "relative motion at the contact")
