"""Curved ways as pictures: surveyed points with their circle, and a swerve in plan."""

import math

from dynamics_cli.numerics.fitting.circle import circle_through
from dynamics_cli.numerics.number import plain
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Length

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

POINTS = 121
ENLARGED = 20.0


def surveyed(result: "Any", path: "Any") -> Picture:
    """The points, the circle through them, and their distances from it twenty times enlarged."""
    points = [float(plain(number)) for number in path.points]
    x, y = points[0::2], points[1::2]
    circle = circle_through([a - x[0] for a in x], [b - y[0] for b in y])
    assert circle is not None
    cx, cy, radius = x[0] + circle.x, y[0] + circle.y, float(result.mark_radius)
    first = math.atan2(y[0] - cy, x[0] - cx)
    turn = math.remainder(math.atan2(y[-1] - cy, x[-1] - cx) - first, 2.0 * math.pi)
    angles = [first + turn * (1.1 * i / (POINTS - 1) - 0.05) for i in range(POINTS)]
    arc = ([cx + radius * math.cos(a) for a in angles], [cy + radius * math.sin(a) for a in angles])
    far_x, far_y = [], []
    for a, b in zip(x, y, strict=True):
        away = math.hypot(a - cx, b - cy)
        wide = (radius + ENLARGED * (away - radius)) / away
        far_x.append(cx + wide * (a - cx))
        far_y.append(cy + wide * (b - cy))
    items = [
        Curve(*arc, "circle of least squares", role=0),
        Curve([x[0], x[-1]], [y[0], y[-1]], "chord", "dashed", role=6),
        Curve(x, y, "points", "points", role=1),
    ]
    if len(x) > 3:
        items.append(Curve(far_x, far_y, "their distances × 20", "dotted", role=2))
    return Picture((Panel(Axis("x", Length), Axis("y", Length), tuple(items), equal=True),), "yaw mark")


def swerve(
    result: "Any", *, speed: float, lateral_shift: float, reaction_time: "float | None" = None,
    steering_lag: "float | None" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """The two arcs in plan after reaction and lag, one arc beside them, and where braking would have stopped."""
    start, radius = speed * ((reaction_time or 0.0) + (steering_lag or 0.0)), float(result.arc_radius)
    half = 0.5 * float(result.distance)
    near = [half * i / (POINTS - 1) for i in range(POINTS)]
    low = [radius - math.sqrt(radius * radius - a * a) for a in near]
    x = [start + a for a in near] + [start + 2.0 * half - a for a in reversed(near)]
    y = low + [lateral_shift - b for b in reversed(low)]
    single = [float(result.one_arc_distance) * i / (POINTS - 1) for i in range(POINTS)]
    items: list[Any] = [
        Curve([0.0, start, *x], [0.0, 0.0, *y], "two arcs", role=0),
        Curve(
            [start + a for a in single], [radius - math.sqrt(max(radius * radius - a * a, 0.0)) for a in single],
            "one arc", "dashed", role=1,
        ),
        Mark(start, 0.0, "steering acts", aside=(4.0, -14.0), role=0),
        Mark(start + 2.0 * half, lateral_shift, "straight again", aside=(4.0, -16.0), role=0),
    ]  # fmt: skip
    if result.braking_distance is not None:
        stop = start + float(result.braking_distance)
        items += [Band(stop, stop, "braking instead stops here")]
    return Picture(
        (Panel(Axis("along the road", Length), Axis("aside", Length), tuple(items)),),
        "swerve",
        subtitle="the shift is drawn on a larger scale than the road",
    )
