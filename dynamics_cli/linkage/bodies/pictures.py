"""Pictures of a body in plane motion and of a chain."""

from itertools import pairwise

from dynamics_cli.errors import worded
from dynamics_cli.linkage.drawing import BELOW, circle, plan, turned
from dynamics_cli.pictures import Arrow, Curve, Mark, Picture, complex_curve
from dynamics_cli.quantities import TurnRate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# The longest arrow is this share of the picture.
ARROW = 0.3


def _arrows(points: "list[tuple[Any, Any, str]]", size: float, role: int, label: str) -> "list[Arrow]":
    longest = max((abs(complex(*vector)) for _, vector, _ in points), default=0.0)
    scale = ARROW * size / longest if longest else 0.0
    return [
        Arrow(position[0], position[1], scale * vector[0], scale * vector[1], f"{label}{name}", role)
        for position, vector, name in points
        if scale and abs(complex(*vector)) > 0.0
    ]


def body_picture(
    result: "Any", *, point: "Any", velocity: "Any", rest: "Any", acceleration: "Any" = None, **_: "Any"
) -> Picture:
    """Points with their velocities, the instant centre with its rays, and the inflection circle."""
    marks = [(point, velocity, " A")]
    second = getattr(rest, "second_point", None)
    if second is not None:
        marks.append((second, rest.second_velocity, " B"))
    marks += [(item.position, item.velocity, "") for item in result.points or ()]
    spots = [position for position, _, _ in marks] + [result.instant_centre or point, result.zero_acceleration or point]
    size = max(
        max(position[i] for position in spots) - min(position[i] for position in spots) for i in (0, 1)
    ) or 0.1  # fmt: skip
    items: list[Any] = []
    if result.instant_centre:
        px, py = result.instant_centre
        items += [Curve([px, position[0]], [py, position[1]], "", "thin", 6) for position, _, _ in marks]
        items.append(Mark(px, py, "instant centre"))
    if result.inflection_diameter and result.inflection_diameter < 10.0 * size:
        radius = 0.5 * result.inflection_diameter
        centre = complex(*result.instant_centre) + radius * turned(result.inflection_direction or 0.0)
        items.append(complex_curve(circle(centre, radius), "inflection circle", "dashed", 5))
    if result.zero_acceleration:
        items.append(Mark(result.zero_acceleration[0], result.zero_acceleration[1], "zero acceleration", BELOW))
    items += [Mark(position[0], position[1], name.strip(), (-12.0, -12.0)) for position, _, name in marks]
    items += _arrows(marks, size, 0, "v")
    return Picture(
        (plan(items),), worded("plane motion of a body\nω = {omega}", omega=(result.angular_velocity, TurnRate))
    )


def chain_picture(result: "Any", **_: "Any") -> Picture:
    """The links with velocity and acceleration of every joint."""
    joints = [(0.0, 0.0), *(joint.position for joint in result.joints)]
    size = sum(abs(complex(*b) - complex(*a)) for a, b in pairwise(joints))
    items: list[Any] = [
        Curve([a[0], b[0]], [a[1], b[1]], f"link {number}", "thick", number - 1)
        for number, (a, b) in enumerate(pairwise(joints), 1)
    ]
    items += [Mark(position[0], position[1], "") for position in joints]
    items += _arrows([(joint.position, joint.velocity, "") for joint in result.joints], size, 2, "v")
    items += _arrows([(joint.position, joint.acceleration, "") for joint in result.joints], size, 3, "a")
    return Picture((plan(items),), "open chain; v and a each to one scale")
