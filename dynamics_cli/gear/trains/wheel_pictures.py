"""A picture of two wheels that roll on one another or share a belt."""

from math import acos, cos, degrees, pi, sin

from dynamics_cli.errors import worded
from dynamics_cli.gear.section import BLACK, centre_lines, circle, sizes
from dynamics_cli.pictures import Axis, Curve, Dimension, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate, Force, Ratio, ShaftSpeed, Size, Speed, Torque

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

X, Y = Axis("x", Coordinate), Axis("y", Coordinate)
STEPS = 72
# A wheel smaller than this share of the other is labelled beside it.
SMALL = 0.5


def wheels(
    result: "Any", *, first_diameter: float, second_diameter: float, drive: str = "external", **_: "Any"
) -> Picture:
    """Both wheels to scale, rolling on one another or with their belt, and the main results."""
    radii = 0.5 * first_diameter, 0.5 * second_diameter
    distance, drive = float(result.centre_distance), str(drive)
    items: list[Any] = []
    for role, (spot, radius) in enumerate(zip(((0.0, 0.0), (distance, 0.0)), radii, strict=True)):
        edge = circle(spot, radius, "", "filled", role)
        items += [edge, *centre_lines(spot, 1.15 * radius), Mark(*spot)]
        name = f"{'driver' if not role else 'driven'}\n"
        text = worded(name + "d_{role} = {size:6}", role=role + 1, size=(2.0 * radius, Size))
        inner = radius < SMALL * max(radii)
        beside = (
            (spot[0] - radius - 0.4 * max(radii), spot[1])
            if inner
            else (spot[0] + 0.4 * radius, spot[1] + 0.45 * radius)
        )
        items.append(Label(*beside, text, role))
    low = -max(radii) * 1.12
    items.append(Dimension((0.0, distance), (low, low), worded("a = {size:6}", size=(distance, Size))))
    if drive.endswith("belt"):
        items.append(_belt(radii, distance, crossed=drive == "crossed-belt"))
    table = sizes(
        ("ratio", "i", result.ratio, Ratio),
        ("speed of the driven wheel", "n_2", result.second_speed, ShaftSpeed),
        ("rim speed", "v", result.rim_speed, Speed),
        ("belt length", "L", result.belt_length, Size),
        ("wrap of the driver", "θ_1", result.first_wrap, Angle),
        ("tight side", "F_1", result.tight_tension, Force),
        ("slack side", "F_2", result.slack_tension, Force),
        ("force that presses them together", "F_n", result.normal_force, Force),
        ("torque on the driven wheel", "T_2", result.second_torque, Torque),
    )
    titles = {
        "external": "Friction wheels",
        "internal": "Friction wheels, one inside the other",
        "open-belt": "Open belt drive",
        "crossed-belt": "Crossed belt drive",
    }
    ratio = worded("{title}, i = {ratio}", title=titles.get(drive, drive), ratio=(float(result.ratio), Ratio))
    wraps = (result.first_wrap, result.second_wrap)
    subtitle = "To scale"
    if all(wrap is not None for wrap in wraps):
        subtitle += "; the belt wraps " + " and ".join(f"{degrees(float(wrap)):.4g}°" for wrap in wraps)
    scene = Panel(X, Y, tuple(items), equal=True, bare=True)
    return Picture((scene, table), ratio, subtitle=subtitle)


def _belt(radii: "tuple[float, float]", distance: float, *, crossed: bool) -> Curve:
    """The belt as one closed line: a tangent, the wrap of the second wheel, a tangent, the wrap of the first."""
    r1, r2 = radii
    far = -r2 if crossed else r2
    # A tangent's normal leans by acos((r₁ ∓ r₂)/a) from the line of centres.
    lean = acos((r1 - far) / distance)
    span = [(r1 * cos(lean), r1 * sin(lean)), (distance + far * cos(lean), far * sin(lean))]
    turns = [k / STEPS for k in range(1, STEPS)]
    if crossed:
        second = [(pi + lean) + (2.0 * pi - 2.0 * lean) * k for k in turns]
    else:
        second = [lean - 2.0 * lean * k for k in turns]
    points = [*span, *((distance + r2 * cos(t), r2 * sin(t)) for t in second)]
    points += [(distance + far * cos(lean), -far * sin(lean)), (r1 * cos(lean), -r1 * sin(lean))]
    points += [(r1 * cos(t), r1 * sin(t)) for t in (-lean - (2.0 * pi - 2.0 * lean) * k for k in turns)]
    points.append(span[0])
    return Curve([x for x, _ in points], [y for _, y in points], "", "thick", BLACK)
