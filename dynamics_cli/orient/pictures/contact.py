"""Pictures of a rolling disk, a ball bearing on a cone, and a universal joint over a turn."""

from math import cos, hypot, pi, sin

from dynamics_cli.errors import worded
from dynamics_cli.numerics.orientation.rotations import IDENTITY, about_axis, product
from dynamics_cli.pictures import Axis, Curve, Label, Mark, Panel, Picture
from dynamics_cli.pictures.vectors import GREY, arrow, circle, curve, numbers, scene, times, words
from dynamics_cli.quantities import Acceleration, Angle, Ratio, Size, Speed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

POINTS = 181


def disk(answer: "Any", *, radius: float, tilt: float, heading: float = 0.0, **_: "Any") -> Picture:
    """The disk on the floor, with velocity and acceleration of its centre."""
    r = radius
    axes = product(about_axis(2, heading), about_axis(0, tilt))
    nodes, up = (numbers(tuple(row[nth] for row in axes)) for nth in (0, 1))
    centre = times(r, up)
    floor = circle((0.0, 0.0, 0.0), IDENTITY[0], IDENTITY[1], 1.7 * r)
    v, a = numbers(answer.fixed_centre_velocity), numbers(answer.fixed_centre_acceleration)
    items: list[Any] = [
        curve(floor, "filled", GREY),
        curve([times(k * r, nodes) for k in (-1.6, 1.6)], "centre", GREY),
        curve(circle(centre, nodes, up, r), "solid", 0),
        curve([(0.0, 0.0, 0.0), centre], "thin", 0),
        curve([(0.0, 0.0, 0.0)], "points", 0),
    ]
    for vector, name, role in ((v, "v", 1), (a, "a", 2)):
        size = hypot(*vector)
        if size:
            scaled = times(1.1 * r / size, vector)
            items += [arrow(scaled, "", role, start=centre), words(times(1.12, scaled, centre), name, role)]
    subtitle = worded(
        "centre: v {v}, a {a} (directions alone are to scale)",
        v=(answer.centre_speed, Speed),
        a=(hypot(*a), Acceleration),
    )
    return Picture((scene(items, subtitle),), "disk rolling on a floor")


def bearing(answer: "Any", *, cone_angle: float, ball_radius: float, **_: "Any") -> Picture:
    """Half of the section through the shaft: race, ball and cone."""
    a, theta, b, touch = ball_radius, cone_angle, answer.centre_radius, answer.contact_radius
    c, s = cos(theta), sin(theta)
    rim = [2.0 * pi * k / 96 for k in range(97)]

    def along(t: float) -> "tuple[float, float]":
        return touch + t * s, a * s + t * c

    low, high = max(-1.9 * a, (-touch / s) if s else -1.9 * a), 1.9 * a
    (x0, y0), (x1, y1) = along(low), along(high)
    items: list[Any] = [
        Curve([0.0, x1, x0, 0.0], [y1, y1, y0, y0], style="fill", role=GREY),
        Curve([x0, x1], [y0, y1], style="thick", role=0),
        Curve([b + a * cos(t) for t in rim], [a * sin(t) for t in rim], style="outline", role=1),
        Curve([b - 1.3 * a, b + a, b + a], [-a, -a, 1.5 * a], style="thick", role=6),
        Curve([0.0, 0.0], [-2.2 * a, 2.4 * a], style="centre", role=GREY),
        Curve([b - 0.8 * a, b + 1.8 * a], [-1.8 * a, 0.8 * a], style="centre", role=2),
        Curve([b, b + a, touch], [-a, 0.0, a * s], style="points", role=6),
        Label(b + 1.1 * a, -0.5 * a, "axis of the ball", 2, left=True),
        Mark(b, 0.0, "b", role=1),
        Label(0.4 * touch, 1.9 * a, "shaft", 0),
    ]
    title = worded(
        "cone of half-angle {angle}; no spin at b = {b:5}", angle=(theta, Angle), b=(answer.rolling_radius, Size)
    )
    panel = Panel(Axis("radius", Size), Axis("height", Size), tuple(items), title, equal=True)
    return Picture((panel,), "ball between a race and a conical shaft")


def joint(
    answer: "Any",
    *,
    joint_angle: float,
    input_angle: float = 0.0,
    second_joint_angle: "float | None" = None,
    fork_angle: float = 0.0,
    **_: "Any",
) -> Picture:
    """Speed ratio and lead of the driven shaft over a turn."""
    from dynamics_cli.orient.contact.joint import joint as calculated

    angles = [input_angle - pi + 2.0 * pi * k / (POINTS - 1) for k in range(POINTS)]
    bent = {"joint_angle": joint_angle, "second_joint_angle": second_joint_angle, "fork_angle": fork_angle}
    rows = [calculated(input_angle=t, **bent) for t in angles]  # type: ignore[arg-type]
    x = Axis("angle of the driving shaft", Angle)
    ratio = Panel(
        x,
        Axis("speed ratio", Ratio),
        (Curve(angles, [row.ratio for row in rows], role=0), Mark(input_angle, answer.ratio, "here")),
        worded("bent by {angle}", angle=(joint_angle, Angle)),
    )
    lead = Panel(
        x,
        Axis("lead of the driven shaft", Angle),
        (Curve(angles, [row.lead for row in rows], role=1), Mark(input_angle, answer.lead, "here")),
    )
    title = "universal joint" if second_joint_angle is None else "two universal joints"
    return Picture((ratio, lead), title)
