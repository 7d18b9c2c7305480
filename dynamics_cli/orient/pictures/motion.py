"""Pictures of turning motion: angular velocities tip to tail, terms of an acceleration, points of a body."""

from math import hypot

from dynamics_cli.errors import worded
from dynamics_cli.orient.pictures.triads import ROOM, triad
from dynamics_cli.pictures import Mark, Panel, Picture
from dynamics_cli.pictures.vectors import (
    GREY,
    Step,
    arrow,
    curve,
    head_to_tail,
    labelled,
    numbers,
    scene,
    seen,
    square,
    times,
    unit,
    view_of,
    words,
)
from dynamics_cli.quantities import Acceleration, AngularAcceleration, AngularRate, Speed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

NOTHING = (0.0, 0.0, 0.0)


def _polygon(terms: "Sequence[tuple[str, Any]]", total: "Any", name: str, title: "Any") -> Panel:
    """Vectors tip to tail, and their sum."""
    terms_shown = [(label, numbers(v)) for label, v in terms]
    terms_shown = [(label, v) for label, v in terms_shown if any(v)]
    resultant = numbers(total)
    view = view_of([resultant, *(v for _, v in terms_shown)])
    sum_ = Step((0.0, 0.0), view(resultant), name, GREY, dashed=len(terms_shown) > 1)
    steps = head_to_tail([view(v) for _, v in terms_shown], [label for label, _ in terms_shown], sum_)
    return scene(labelled(steps), title)


def rates(answer: "Any", **_: "Any") -> Picture:
    """The body's axes, the axes that the angles turn about, and directions of ω and α."""
    matrix = [numbers(row) for row in answer.rotation_matrix]
    items = triad(matrix, "′", GREY, dashed=True)
    axes = (answer.first_partial, answer.second_partial, answer.third_partial)
    for nth, axis in enumerate(axes):
        n = numbers(axis)
        items += [curve([(0.0, 0.0, 0.0), times(0.8, n)], "centre", 2)]
        items.append(words(times(0.87, n), "u₁u₂u₃"[2 * nth : 2 * nth + 2], 2))
    for v, name, role in ((answer.angular_velocity, "ω", 0), (answer.angular_acceleration, "α", 1)):
        if any(numbers(v)):
            n = unit(numbers(v))
            items += [arrow(n, "", role), words(times(1.12, n), name, role)]
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
        _polygon(velocities, answer.angular_velocity, "ω", worded("|ω| = {v}", v=(answer.angular_speed, AngularRate))),
        _polygon(
            terms,
            answer.angular_acceleration,
            "α",
            worded("|α| = {v}", v=(answer.angular_acceleration_size, AngularAcceleration)),
        ),
    ]
    return Picture(tuple(panels), "addition along the chain", columns=2)


def moving_point(
    answer: "Any", *, relative_velocity: "Any" = NOTHING, origin_velocity: "Any" = NOTHING, **_: "Any"
) -> Picture:
    """Velocity and acceleration with their terms, tip to tail."""
    spun = times(-1.0, numbers(origin_velocity), numbers(answer.carried_velocity))
    velocities = [("v_O", origin_velocity), ("ω × r", spun), ("v_rel", relative_velocity)]
    terms = [
        ("a_O", answer.origin_part),
        ("α × r", answer.angular_part),
        ("ω × (ω × r)", answer.centripetal),
        ("2 ω × v_rel", answer.coriolis),
        ("a_rel", answer.relative_part),
    ]
    panels = (
        _polygon(velocities, answer.velocity, "v", worded("|v| = {v}", v=(answer.speed, Speed))),
        _polygon(terms, answer.acceleration, "a", worded("|a| = {v}", v=(answer.acceleration_size, Acceleration))),
    )
    return Picture(panels, "a point moving on a moving body", columns=2)


def points(answer: "Any", **_: "Any") -> Picture:
    """The points with their velocities, and the screw axis."""
    places = [numbers(point.position) for point in answer.points]
    speeds = [numbers(point.velocity) for point in answer.points]
    fastest = max((hypot(*v) for v in speeds), default=0.0) or 1.0
    reach = max((hypot(*p) for p in places), default=0.0) or 1.0
    if answer.axis is not None:
        foot, n = numbers(answer.axis_point), numbers(answer.axis)
        reach = max(reach, hypot(*foot))
    upright = answer.axis is None or abs(n[2]) > 1.0 - 1e-12
    view = view_of([*places, *speeds]) if upright else seen
    items: list[Any] = [curve([*places, places[0]], "thin", GREY, view)]
    for point, place, v in zip(answer.points, places, speeds, strict=True):
        items.append(arrow(times(0.5 * reach / fastest, v), "", 1, view, start=place))
        x, y = view(place)
        items.append(Mark(x, y, point.name, (-6.0, -12.0), role=0))
    if answer.axis is not None and view is seen:
        ends = [times(k * reach, n, foot) for k in (-0.3, 0.9)]
        items += [curve(ends, "centre", 3), words(ends[1], "axis", 3)]
    elif answer.axis is not None:
        x, y = view(foot)
        items.append(Mark(x, y, "axis", role=3))
    axis_words = "; screw axis dash-dotted" if answer.axis is not None and view is seen else ""
    subtitle = worded("velocities, the fastest {v}" + axis_words, v=(fastest, Speed))
    return Picture((scene(items, subtitle),), "points of a rigid body")


def rolling(answer: "Any", *, normal: "Any", **_: "Any") -> Picture:
    """Relative angular velocity at the contact, with its spin and roll parts."""
    n, roll, spin = unit(numbers(normal)), numbers(answer.roll), answer.spin
    relative = times(spin, n, roll)
    size = hypot(*relative) or 1.0
    items: list[Any] = [
        square((0.0, 0.0, 0.0), n, 0.9, GREY, unit(roll) if any(roll) else None),
        curve([(0.0, 0.0, 0.0), times(0.9, n)], "centre", GREY),
        words(n, "normal", GREY),
    ]
    if abs(spin) > 1e-12 * size and any(roll):
        items += [arrow(times(1.0 / size, roll), "roll", 2), arrow(times(spin / size, n), "spin", 1)]
    items.append(arrow(times(1.0 / size, relative), "ω₁ − ω₂", 0))
    subtitle = worded(
        "roll {r}, spin {s}, slip {v}",
        r=(answer.roll_speed, AngularRate),
        s=(answer.spin, AngularRate),
        v=(answer.slip_speed, Speed),
    )
    return Picture((scene(items, subtitle, room=ROOM),), "relative motion at the contact")
