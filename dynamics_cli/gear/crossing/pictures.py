"""Pictures of bevel pairs and worm drives: axial sections to scale with their main sizes."""

from math import cos, degrees, pi, sin, tan

from dynamics_cli.errors import worded
from dynamics_cli.gear.section import BLACK, body, circle, form_of, sizes
from dynamics_cli.gear.single.gear import Gear
from dynamics_cli.gear.single.rack import basic_rack
from dynamics_cli.pictures import Axis, Band, Curve, Dimension, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate, Force, Fraction, Module, Ratio, Size, Speed, Torque

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Point = tuple[float, float]

X, Y = Axis("x", Coordinate), Axis("y", Coordinate)
STEPS = 96
# Lead angles a worm may have, for the curve of its efficiency.
STEEPEST_LEAD = 0.785
RIGHT = 0.5 * pi


def line(points: "list[Point]", label: str = "", style: "Any" = "solid", role: int = 0) -> Curve:
    """A curve through points."""
    return Curve([x for x, _ in points], [y for _, y in points], label, style, role)


def bevel(result: "Any", *, face_width: float, shaft_angle: float = RIGHT, **inputs: "Any") -> Picture:
    """Both gears cut through their axes: tip, pitch and root cones to the apex they share."""
    items: list[Any] = []
    outer = float(result.cone_distance)
    # Each gear lies about its axis; the second's is turned by the shaft angle, its near side facing the first.
    for role, (name, wheel, axis, side) in enumerate(
        (("pinion", result.first, 0.0, 1.0), ("wheel", result.second, shaft_angle, -1.0))
    ):
        items += _cut(wheel, outer, face_width, axis, side, role)
        pitch = float(wheel.pitch_angle)
        back = outer * max(cos(pitch), 0.0)
        items.append(line([(0.0, 0.0), turned_point((back + 0.3 * outer, 0.0), axis)], "", "centre", BLACK))
        inside = back - 0.5 * face_width * cos(pitch), -side * 0.45 * 0.5 * float(wheel.pitch_diameter)
        items.append(
            Label(
                *turned_point(inside, axis),
                f"{name}{', ' if role else chr(10)}δ_{role + 1} = {degrees(pitch):.4g}°",
                role,
            )
        )
        items += _across(wheel, outer, axis, role)
    items += [Mark(0.0, 0.0, "apex", (-6.0, -10.0))]
    title = worded(
        "Bevel pair {first} / {second}, shaft angle {angle:6}",
        first=inputs.get("first_teeth", "z1"),
        second=inputs.get("second_teeth", "z2"),
        angle=(shaft_angle, Angle),
    )
    pinion, gear = result.first, result.second
    table = sizes(
        ("outer cone distance", "R_e", outer, Size),
        ("face width", "b", face_width, Size),
        ("mean module", "m_m", result.mean_module, Module),
        ("contact ratio", "ε_α", result.contact_ratio, Ratio),
        ("pinion: tip diameter", "d_ae1", pinion.tip_diameter, Size),
        ("tip, root angle", "δ_a1, δ_f1", _two_angles(pinion), None),
        ("wheel: tip diameter", "d_ae2", gear.tip_diameter, Size),
        ("tip, root angle", "δ_a2, δ_f2", _two_angles(gear), None),
    )
    scene = Panel(X, Y, tuple(items), equal=True, bare=True)
    return Picture((scene, table), title, subtitle="Section through both axes; pitch cones dotted to their common apex")


def _two_angles(gear: "Any") -> str:
    return f"{degrees(float(gear.tip_angle)):.5g}°, {degrees(float(gear.root_angle)):.5g}°"


def _across(wheel: "Any", outer: float, axis: float, role: int) -> "list[Any]":
    """The outer pitch diameter, beyond the back of the gear."""
    radius, along = 0.5 * float(wheel.pitch_diameter), outer * max(cos(float(wheel.pitch_angle)), 0.0) + 0.16 * outer
    ends = [turned_point((along, side * radius), axis) for side in (-1.0, 1.0)]
    text = worded("d_e{role} = {size:6}", role=role + 1, size=(2.0 * radius, Size))
    beside = turned_point((along + (0.24 if not role else 0.06) * outer, 0.45 * radius), axis)
    return [Dimension((ends[0][0], ends[1][0]), (ends[0][1], ends[1][1]), ""), Label(*beside, text)]


def _cut(wheel: "Any", outer: float, width: float, axis: float, side: float, role: int) -> "list[Curve]":
    """The section of one gear: its blank, and its teeth on the side of its mate and on the other."""
    pitch, up, down = float(wheel.pitch_angle), float(wheel.addendum_angle), float(wheel.dedendum_angle)
    curves, feet = [], []
    for side_sense in (side, -side):

        def at(along: float, angle: float, side_sense: float = side_sense) -> "Point":
            return along * cos(axis + side_sense * angle), along * sin(axis + side_sense * angle)

        px, py = at(outer, pitch)
        nx, ny = cos(axis + side_sense * (pitch + RIGHT)), sin(axis + side_sense * (pitch + RIGHT))
        tip = px + float(wheel.addendum) * nx, py + float(wheel.addendum) * ny
        foot = px - float(wheel.dedendum) * nx, py - float(wheel.dedendum) * ny
        ends = []
        for corner, angle, turn in ((tip, pitch + up, up), (foot, pitch - down, down)):
            back = width / cos(turn)
            dx, dy = at(back, angle)
            ends.append((corner[0] - dx, corner[1] - dy))
        curves.append(line([foot, tip, ends[0], ends[1], foot], "", "filled", role))
        curves.append(line([(0.0, 0.0), (px, py)], "", "dotted", role))
        feet.append((foot, ends[1]))
    (near, near_in), (far, far_in) = feet
    curves.append(line([near, near_in, far_in, far, near], "", "filled", role))
    return curves


def turned_point(point: "Point", angle: float) -> "Point":
    """The point rotated about the origin."""
    x, y = point
    return x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)


def worm(result: "Any", *, teeth: int, threads: int = 0, **_: "Any") -> Picture:
    """The worm and its wheel in the middle plane, and the efficiency over the lead angle."""
    pitch, length = float(result.axial_pitch), float(result.worm_length)
    distance = float(result.centre_distance)
    outline = _threads(result)
    shaft = 0.55 * length + 2.0 * pitch
    items: list[Any] = [
        *_wheel(result, teeth),
        line(outline, "", "filled", 0),
        line([(-shaft, 0.0), (shaft, 0.0)], "", "centre", BLACK),
        line([(-0.5 * length, -0.5 * float(result.worm_diameter)), (0.5 * length, -0.5 * float(result.worm_diameter))],
             "", "dots", 0),
        line([(0.0, 0.0), (0.0, -distance)], "", "centre", BLACK),
        Mark(0.0, -distance),
        Label(-0.62 * length - pitch, 0.35 * float(result.worm_tip_diameter), "worm" if not threads
              else f"worm\n{threads} thread{'s' if threads > 1 else ''}", 0),
        Label(0.0, -distance - 0.16 * float(result.wheel_diameter), f"wheel\n{teeth} teeth", 1),
        Dimension((shaft, shaft), (0.0, -distance), ""),
        Label(shaft + 0.3 * pitch, -0.5 * distance, worded("a = {size:6}", size=(distance, Size)), left=True),
    ]  # fmt: skip
    table = sizes(
        ("centre distance", "a", distance, Size),
        ("lead angle", "γ", result.lead_angle, Angle),
        ("axial module", "m_x", result.axial_module, Module),
        ("diameter factor", "q", result.diameter_factor, Ratio),
        ("worm diameter", "d_1", result.worm_diameter, Size),
        ("wheel diameter", "d_2", result.wheel_diameter, Size),
        ("throat diameter", "d_a2", result.throat_diameter, Size),
        ("face width", "b", result.face_width, Size),
        ("efficiency, worm driving", "η", result.efficiency, Fraction),
        ("self-locking", "", "yes" if result.self_locking else "no", None),
        ("sliding speed", "v_g", result.sliding_speed, Speed),
        ("torque of the wheel", "T_2", result.wheel_torque, Torque),
        ("axial force on the worm", "F_a1", result.worm_axial_force, Force),
    )
    scene = Panel(X, Y, tuple(items), equal=True, bare=True, wide=True)
    title = worded(
        "Worm drive {threads}{teeth}, axial module {module:6}",
        threads=f"{threads} / " if threads else "",
        teeth=teeth,
        module=(float(result.axial_module), Module),
    )
    subtitle = "Middle plane of the wheel, the worm cut along its axis; reference circle dash-dotted"
    return Picture((scene, _efficiency(result), table), title, columns=2, subtitle=subtitle)


def _threads(result: "Any") -> "list[Point]":
    """The worm's axial section: threads below, and half a lead further on those above."""
    pitch, length = float(result.axial_pitch), float(result.worm_length)
    tip, root, middle = (
        0.5 * float(d) for d in (result.worm_tip_diameter, result.worm_root_diameter, result.worm_diameter)
    )
    lean = tan(float(result.axial_pressure_angle))
    foot, top = 0.25 * pitch + (middle - root) * lean, max(0.0, 0.25 * pitch - (tip - middle) * lean)

    def edge(shift: float, sense: float) -> "list[Point]":
        points: list[Point] = [(-0.5 * length, sense * root)]
        for nth in range(-round(length / pitch) - 1, round(length / pitch) + 2):
            centre = nth * pitch + shift
            if abs(centre) + foot <= 0.5 * length:
                points += [(centre - foot, sense * root), (centre - top, sense * tip), (centre + top, sense * tip),
                           (centre + foot, sense * root)]  # fmt: skip
        return [*points, (0.5 * length, sense * root)]

    below = edge(0.0, -1.0)
    return [*below, *reversed(edge(0.5 * float(result.lead), 1.0)), below[0]]


def _wheel(result: "Any", teeth: int) -> "list[Any]":
    """The wheel in its middle plane: teeth of the rack that the worm is there, a space under the thread at x = 0."""
    centre = (0.0, -float(result.centre_distance))
    items: list[Any] = [circle(centre, 0.5 * float(result.wheel_diameter), "", "centre", 1)]
    rack = basic_rack("a", float(result.axial_pressure_angle))
    gear = Gear(teeth, float(result.axial_module), rack, 0.0, float(result.profile_shift))
    form = form_of(gear, float(result.throat_diameter))
    if form is not None:
        return [*items, *body(form, centre, RIGHT + pi / teeth, 1)]
    diameters = (result.throat_diameter, result.wheel_root_diameter)
    return [*items, *(circle(centre, 0.5 * float(diameter), "", "solid", 1) for diameter in diameters)]


def _efficiency(result: "Any") -> Panel:
    lead, rub = float(result.lead_angle), float(result.friction_angle)
    angles = [max(STEEPEST_LEAD, 1.2 * lead) * k / STEPS for k in range(1, STEPS + 1)]
    forward = [tan(g) / tan(g + rub) for g in angles if g + rub < RIGHT]
    backward = [max(0.0, tan(g - rub) / tan(g)) for g in angles]
    items: list[Any] = [
        Curve(angles[: len(forward)], forward, "worm drives", role=0),
        Curve(angles, backward, "wheel drives", "dashed", role=1),
        Mark(lead, float(result.efficiency), "this worm", (6.0, -9.0)),
    ]
    if rub > 0.0:
        items.append(Band(0.0, rub, "self-locking"))
    return Panel(Axis("lead angle", Angle), Axis("efficiency", Fraction), tuple(items))
