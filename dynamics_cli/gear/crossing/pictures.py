"""What there is to look at where shafts cross or wheels roll: cones, worms, screws, hypoid offsets, belts."""

from math import acos, copysign, cos, degrees, pi, sin, tan

from dynamics_cli.pictures import Arrow, Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate, Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Point = tuple[float, float]

X, Y = Axis("x", Coordinate), Axis("y", Coordinate)
STEPS = 96
# Lead angles a worm may have, for the curve of its efficiency.
STEEPEST_LEAD = 0.785
RIGHT = 0.5 * pi


def _line(points: "list[Point]", label: str = "", style: "Any" = "solid", role: int = 0) -> Curve:
    return Curve([x for x, _ in points], [y for _, y in points], label, style, role)


def _circle(x: float, y: float, radius: float, label: str = "", style: "Any" = "solid", role: int = 0) -> Curve:
    turns = [2.0 * pi * k / STEPS for k in range(STEPS + 1)]
    return _line([(x + radius * cos(t), y + radius * sin(t)) for t in turns], label, style, role)


def bevel(made: "Any", *, face_width: float, shaft_angle: float = RIGHT, **_: "Any") -> Picture:
    """Both wheels cut through their axes: tip, pitch and root cones to the apex they share."""
    items: list[Any] = []
    outer = float(made.cone_distance)
    # Each wheel lies about its axis; the second's axis is turned by the shaft angle, its near side facing the first.
    for role, (name, wheel, axis, side) in enumerate(
        (("first", made.first, 0.0, 1.0), ("second", made.second, shaft_angle, -1.0))
    ):
        label = f"{name}, pitch angle {degrees(float(wheel.pitch_angle)):.4g}°"
        items += _cut(wheel, outer, face_width, axis, side, label, role)
        reach = 1.1 * outer * max(cos(float(wheel.pitch_angle)), 0.35)
        items.append(_line([(0.0, 0.0), (reach * cos(axis), reach * sin(axis))], "", "dashed", role))
    items.append(Mark(0.0, 0.0, "apex"))
    return Picture((Panel(X, Y, tuple(items), equal=True),), "bevel pair, section through the axes")


def _cut(wheel: "Any", outer: float, width: float, axis: float, side: float, name: str, role: int) -> "list[Curve]":
    """The section of one wheel, on the side of its mate and on the other."""
    pitch, up, down = float(wheel.pitch_angle), float(wheel.addendum_angle), float(wheel.dedendum_angle)
    curves = []
    for way in (side, -side):

        def at(along: float, angle: float, way: float = way) -> "Point":
            return along * cos(axis + way * angle), along * sin(axis + way * angle)

        px, py = at(outer, pitch)
        nx, ny = cos(axis + way * (pitch + RIGHT)), sin(axis + way * (pitch + RIGHT))
        tip = px + float(wheel.addendum) * nx, py + float(wheel.addendum) * ny
        foot = px - float(wheel.dedendum) * nx, py - float(wheel.dedendum) * ny
        ends = []
        for corner, angle, turn in ((tip, pitch + up, up), (foot, pitch - down, down)):
            back = width / cos(turn)
            dx, dy = at(back, angle)
            ends.append((corner[0] - dx, corner[1] - dy))
        curves.append(_line([foot, tip, ends[0], ends[1], foot], name if way == side else "", "filled", role))
        curves.append(_line([(0.0, 0.0), (px, py)], "", "dotted", role))
    return curves


def worm(made: "Any", *, teeth: int, **_: "Any") -> Picture:
    """The worm and its wheel in the middle plane, and the efficiency over the lead angle."""
    pitch, length = float(made.axial_pitch), float(made.worm_length)
    tip, root, middle = (0.5 * float(d) for d in (made.worm_tip_diameter, made.worm_root_diameter, made.worm_diameter))
    lean = tan(float(made.axial_pressure_angle))
    count = max(1, round(length / pitch))
    # Half a turn on, half a lead away, a thread stands on the other side.
    shift = 0.5 * float(made.lead) - pitch * round(0.5 * float(made.lead) / pitch)
    outline: list[Point] = []
    mirrored: list[Point] = []
    for nth in range(count):
        centre = (nth - 0.5 * (count - 1)) * pitch
        foot, top = 0.25 * pitch + (middle - root) * lean, max(0.0, 0.25 * pitch - (tip - middle) * lean)
        outline += [(centre - foot, -root), (centre - top, -tip), (centre + top, -tip), (centre + foot, -root)]
        other = centre + shift
        mirrored += [(other - foot, root), (other - top, tip), (other + top, tip), (other + foot, root)]
    distance = -float(made.centre_distance)
    items: list[Any] = [
        _line(outline, "worm", "solid", 0),
        _line(mirrored, "", "solid", 0),
        _line([(-0.6 * length, 0.0), (0.6 * length, 0.0)], "", "dashed", 0),
        _circle(0.0, distance, 0.5 * float(made.throat_diameter), "wheel, throat", "solid", 1),
        _circle(0.0, distance, 0.5 * float(made.wheel_diameter), "wheel, reference", "dashed", 1),
        _circle(0.0, distance, 0.5 * float(made.wheel_root_diameter), "wheel, root", "dotted", 1),
        Mark(0.0, distance, f"{teeth} teeth"),
    ]
    scene = Panel(X, Y, tuple(items), "middle plane", equal=True)
    return Picture((scene, _efficiency(made)), "worm and wheel")


def _efficiency(made: "Any") -> Panel:
    lead, rub = float(made.lead_angle), float(made.friction_angle)
    angles = [max(STEEPEST_LEAD, 1.2 * lead) * k / STEPS for k in range(1, STEPS + 1)]
    forward = [tan(g) / tan(g + rub) for g in angles if g + rub < RIGHT]
    backward = [max(0.0, tan(g - rub) / tan(g)) for g in angles]
    items: list[Any] = [
        Curve(angles[: len(forward)], forward, "worm drives", role=0),
        Curve(angles, backward, "wheel drives", role=1),
        Mark(lead, float(made.efficiency), "this worm"),
    ]
    if rub > 0.0:
        items.append(Band(0.0, rub, "self-locking"))
    return Panel(Axis("lead angle", Angle), Axis("efficiency", Ratio), tuple(items), "efficiency with this friction")


def crossed(made: "Any", *, first: "Any", second: "Any", **_: "Any") -> Picture:
    """Both screws seen along their common perpendicular, and the speeds where they touch."""
    one, two = float(made.first_working_helix), float(made.second_working_helix)
    one, two = copysign(one, float(first.helix_angle)), copysign(two, float(second.helix_angle))
    wide = 0.75 * max(float(made.first_working_diameter), float(made.second_working_diameter))
    items: list[Any] = []
    for role, (name, radius, axis) in enumerate(
        (
            (f"first, {first.teeth} teeth", 0.5 * float(made.first_working_diameter), 0.0),
            (f"second, {second.teeth} teeth", 0.5 * float(made.second_working_diameter), one + two),
        )
    ):
        corners = [(-wide, -radius), (wide, -radius), (wide, radius), (-wide, radius), (-wide, -radius)]
        items.append(_line([_turned(point, axis) for point in corners], name, "filled", role))
        items.append(_line([_turned((-1.2 * wide, 0.0), axis), _turned((1.2 * wide, 0.0), axis)], "", "dashed", role))
    tooth = [_turned((-0.6 * wide, 0.0), one), _turned((0.6 * wide, 0.0), one)]
    items += [_line(tooth, "common direction of the teeth", "solid", 3), Mark(0.0, 0.0, "C")]
    scene = Panel(X, Y, tuple(items), "seen along the common perpendicular", equal=True)
    return Picture((scene, _speeds(one, 0.0, two, one + two)), "crossed helical gears")


def _turned(point: "Point", angle: float) -> "Point":
    x, y = point
    return x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)


def _speeds(first_helix: float, first_axis: float, second_helix: float, second_axis: float) -> Panel:
    """Pitch line velocities over the first's: alike across the teeth, their difference slides along them."""
    across = Axis("along the first axis, over the first's speed")
    up = Axis("across the first axis")
    turned = _turned((0.0, 1.0), first_axis)
    size = cos(first_helix) / cos(second_helix)
    two = _turned((0.0, size), second_axis)
    items = (
        Arrow(0.0, 0.0, turned[0], turned[1], "first", 0),
        Arrow(0.0, 0.0, two[0], two[1], "second", 1),
        Arrow(two[0], two[1], turned[0] - two[0], turned[1] - two[1], "sliding", 3),
    )
    return Panel(across, up, items, "speeds at the pitch point", equal=True)


def hypoid(made: "Any", *, offset: float | None = None, wheel_radius: float, **_: "Any") -> Picture:
    """The wheel seen along its axis with the pinion's axis beside it, and the speeds in the pitch plane."""
    offset = float(made.offset) if offset is None else offset
    eta = float(made.axial_offset_angle)
    at = wheel_radius * cos(eta), wheel_radius * sin(eta)
    radius, half = float(made.first_pitch_radius), 0.2 * wheel_radius
    cone = float(made.first_pitch_angle)
    # The pinion's pitch cone about its axis, its mean section over the pitch point, its apex towards the wheel's axis.
    slim, thick = radius - half * tan(cone), radius + half * tan(cone)
    shape = [
        (at[0] - half, offset - slim), (at[0] + half, offset - thick), (at[0] + half, offset + thick),
        (at[0] - half, offset + slim), (at[0] - half, offset - slim),
    ]  # fmt: skip
    items: list[Any] = [
        _circle(0.0, 0.0, wheel_radius, "wheel, pitch circle", "solid", 1),
        _line(shape, "pinion, pitch cone", "filled", 0),
        _line([(-0.3 * wheel_radius, offset), (1.6 * wheel_radius, offset)], "pinion axis", "dashed", 0),
        _line([(0.0, 0.0), (0.0, offset)], "offset", "thin", 3),
        Mark(0.0, 0.0, "wheel axis"),
        Mark(*at, "P"),
    ]
    scene = Panel(X, Y, tuple(items), "seen along the wheel's axis", equal=True)
    one, two = float(made.first_spiral_angle), float(made.second_spiral_angle)
    return Picture((scene, _speeds(one, 0.0, two, two - one)), "hypoid pair")


def wheels(
    made: "Any", *, first_diameter: float, second_diameter: float, drive: str = "external", **_: "Any"
) -> Picture:
    """Both wheels, rolling on one another or with their belt."""
    one, two = 0.5 * first_diameter, 0.5 * second_diameter
    distance = float(made.centre_distance)
    items: list[Any] = [
        _circle(0.0, 0.0, one, "first", "solid", 0),
        _circle(distance, 0.0, two, "second", "solid", 1),
        Mark(0.0, 0.0),
        Mark(distance, 0.0),
    ]
    if drive.endswith("belt"):
        far = -two if drive == "crossed-belt" else two
        # A tangent's normal leans by acos((r₁ ∓ r₂)/a) from the line of centres.
        lean = acos((one - far) / distance)
        for nth, way in enumerate((1.0, -1.0)):
            n = cos(lean), way * sin(lean)
            belt = [(one * n[0], one * n[1]), (distance + far * n[0], far * n[1])]
            items.append(_line(belt, "" if nth else "belt", "solid", 6))
    return Picture((Panel(X, Y, tuple(items), equal=True),), f"wheels, {drive}")
