"""Pictures of gears on skew axes, crossed helical and hypoid, with the speeds at the contact."""

from math import copysign, cos, pi, sin, tan

from dynamics_cli.errors import worded
from dynamics_cli.gear.crossing.pictures import X, Y, line, turned_point
from dynamics_cli.gear.section import BLACK, circle, sizes
from dynamics_cli.pictures import Arrow, Axis, Dimension, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Fraction, Module, Ratio, Size, Speed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.pictures import Curve

    Point = tuple[float, float]

# Half the width that crossed gears are drawn with, in modules.
HALF_WIDTH = 6.0
GREEN, SLIDING = 2, 3


def crossed(result: "Any", *, first: "Any", second: "Any", module: float, **_: "Any") -> Picture:
    """Both gears seen along their common perpendicular with their teeth, and the speeds where they touch."""
    lean1, lean2 = float(result.first_working_helix), float(result.second_working_helix)
    lean1, lean2 = copysign(lean1, float(first.helix_angle)), copysign(lean2, float(second.helix_angle))
    wide = HALF_WIDTH * module
    radii = 0.5 * float(result.first_tip_diameter), 0.5 * float(result.second_tip_diameter)
    # the second lies behind
    items = [
        *_screw("second", int(second.teeth), radii[1], lean1, lean1 + lean2, wide, 1),
        *_screw("first", int(first.teeth), radii[0], lean1, 0.0, wide, 0),
    ]
    reach = 1.1 * wide
    items += [
        line([turned_point((-reach, 0.0), lean1), turned_point((reach, 0.0), lean1)], "", "thick", GREEN),
        Mark(0.0, 0.0, "C", (7.0, -10.0)),
    ]
    table = sizes(
        ("shaft angle", "Σ", result.shaft_angle, Angle),
        ("centre distance", "a_w", result.centre_distance, Size),
        ("gear ratio", "u", result.ratio, Ratio),
        ("working diameter", "d_w1", result.first_working_diameter, Size),
        ("", "d_w2", result.second_working_diameter, Size),
        ("working helix angle", "β_w1", lean1, Angle),
        ("", "β_w2", lean2, Angle),
        ("pressure angle", "α_wn", result.working_pressure_angle, Angle),
        ("efficiency", "η", result.efficiency, Fraction),
        ("sliding speed", "v_g", result.sliding_speed, Speed),
    )
    title = worded(
        "Crossed helical gears {first} / {second}, module {module:6}",
        first=first.teeth,
        second=second.teeth,
        module=(module, Module),
    )
    scene = Panel(X, Y, tuple(items), equal=True, bare=True, wide=True)
    subtitle = (
        "Seen along the common perpendicular; teeth as they lie where the gears touch, thick their common direction"
    )
    return Picture((scene, _speeds(lean1, 0.0, lean2, lean1 + lean2), table), title, columns=2, subtitle=subtitle)


def _screw(name: str, teeth: int, radius: float, helix: float, axis: float, wide: float, role: int) -> "list[Any]":
    """One gear about its axis, with its teeth."""
    corners = [(-wide, -radius), (wide, -radius), (wide, radius), (-wide, radius), (-wide, -radius)]
    out = 1.35 * wide + 0.1 * radius
    traces = _traces(radius, wide, helix - axis, teeth)
    return [
        line([turned_point(point, axis) for point in corners], "", "filled", role),
        *(line([turned_point(point, axis) for point in trace], "", "thin", role) for trace in traces),
        line([turned_point((-out, 0.0), axis), turned_point((out, 0.0), axis)], "", "centre", BLACK),
        Label(*turned_point((1.28 * out + 0.15 * wide, 0.0), axis), f"{name}\n{teeth} teeth", role),
    ]


def _traces(radius: float, wide: float, lean: float, teeth: int) -> "list[list[Point]]":
    """The teeth on the near side of a cylinder along x: helices that lean by an angle from its axis at y = 0."""
    traces = []
    turn = tan(lean) / radius
    places = [wide * (k / 24 - 1.0) for k in range(49)]
    for nth in range(-teeth // 2, teeth // 2 + 1):
        points = [(x, 2.0 * pi * nth / teeth + turn * x) for x in places]
        trace = [(x, radius * sin(angle)) for x, angle in points if abs(angle) < 0.5 * pi]
        if len(trace) > 1:
            traces.append(trace)
    return traces


def _speeds(first_helix: float, first_axis: float, second_helix: float, second_axis: float) -> Panel:
    """Pitch line velocities relative to the first's: equal across the teeth; their difference slides along them."""
    first_speed = turned_point((0.0, 1.0), first_axis)
    size = cos(first_helix) / cos(second_helix)
    second_speed = turned_point((0.0, size), second_axis)
    sliding = first_speed[0] - second_speed[0], first_speed[1] - second_speed[1]
    side = copysign(0.1, -second_speed[0] if second_speed[0] else 1.0)
    items = (
        Arrow(0.0, 0.0, first_speed[0], first_speed[1], "", 0),
        Arrow(0.0, 0.0, second_speed[0], second_speed[1], "", 1),
        Arrow(second_speed[0], second_speed[1], sliding[0], sliding[1], "", SLIDING),
        Label(side * 1.5, 0.45, "v_1", 0),
        Label(0.5 * second_speed[0] - side, 0.5 * second_speed[1] - 0.1, "v_2", 1),
        Label(second_speed[0] + 0.5 * sliding[0], second_speed[1] + 0.5 * sliding[1] + 0.09, "sliding v_g", SLIDING),
    )
    none = Axis("")
    return Panel(none, none, items, "Speeds at the pitch point", equal=True, bare=True)


def hypoid(result: "Any", *, offset: float | None = None, wheel_radius: float, **inputs: "Any") -> Picture:
    """The wheel seen along its axis with the pinion's axis beside it, and the speeds in the pitch plane."""
    offset = float(result.offset) if offset is None else offset
    eta = float(result.axial_offset_angle)
    pitch_point = wheel_radius * cos(eta), wheel_radius * sin(eta)
    half = 0.2 * wheel_radius
    reach = 1.35 * wheel_radius
    teeth = [inputs.get("first_teeth", ""), inputs.get("second_teeth", "")]
    far = pitch_point[0] + half + 0.35 * wheel_radius
    items: list[Any] = [
        circle((0.0, 0.0), wheel_radius, "", "centre", 1),
        circle((0.0, 0.0), wheel_radius + half * sin(float(result.second_pitch_angle)), "", "outline", 1),
        circle((0.0, 0.0), wheel_radius - half * sin(float(result.second_pitch_angle)), "", "outline", 1),
        *_pinion(result, pitch_point, offset, half),
        line([(-reach, 0.0), (reach, 0.0)], "", "centre", BLACK),
        line([(0.0, -1.2 * wheel_radius), (0.0, 1.2 * wheel_radius)], "", "centre", BLACK),
        line([(-0.3 * wheel_radius, offset), (far, offset)], "", "centre", BLACK),
        Dimension((-0.2 * wheel_radius,) * 2, (0.0, offset), ""),
        Label(-0.24 * wheel_radius - 0.2 * wheel_radius, 0.5 * offset, worded("E = {size:6}", size=(offset, Size))),
        Mark(*pitch_point, "P", (6.0, -10.0)),
        Label(-0.35 * wheel_radius, -0.4 * wheel_radius, f"wheel\n{teeth[1]} teeth" if teeth[1] else "wheel", 1),
        Label(far + 0.16 * wheel_radius, offset, f"pinion\n{teeth[0]} teeth" if teeth[0] else "pinion", 0),
    ]
    beta1, beta2 = float(result.first_spiral_angle), float(result.second_spiral_angle)
    table = sizes(
        ("ratio", "i", result.ratio, Ratio),
        ("pitch angle", "δ_1", result.first_pitch_angle, Angle),
        ("", "δ_2", result.second_pitch_angle, Angle),
        ("spiral angle", "β_1", beta1, Angle),
        ("", "β_2", beta2, Angle),
        ("pitch radius", "r_1", result.first_pitch_radius, Size),
        ("", "r_2", result.second_pitch_radius, Size),
        ("mean normal module", "m_n", result.normal_module, Module),
        ("limit pressure angle", "α_lim", result.limit_pressure_angle, Angle),
        ("sliding over wheel's speed", "", result.sliding_ratio, Ratio),
    )
    title = "Hypoid pair " + " / ".join(str(number) for number in teeth if number)
    scene = Panel(X, Y, tuple(items), equal=True, bare=True, wide=True)
    subtitle = "Seen along the wheel's axis; pitch circle and axes dash-dotted, P the pitch point"
    return Picture((scene, _speeds(beta1, 0.0, beta2, beta2 - beta1), table), title, columns=2, subtitle=subtitle)


def _pinion(result: "Any", at: "Point", offset: float, half: float) -> "list[Curve]":
    """The pinion's pitch cone about its axis, its mean section over the pitch point, its apex towards the wheel."""
    radius, cone = float(result.first_pitch_radius), float(result.first_pitch_angle)
    slim, thick = radius - half * tan(cone), radius + half * tan(cone)
    near, far = at[0] - half, at[0] + half
    shape = [(near, offset - slim), (far, offset - thick), (far, offset + thick), (near, offset + slim)]
    curves = [line([*shape, shape[0]], "", "filled", 0)]
    spiral = tan(float(result.first_spiral_angle))
    places = [half * (k / 24 - 1.0) for k in range(49)]
    for nth in range(-12, 13):
        # helices on the near side of the cone
        points = [(x, 0.3 * nth + x * spiral / radius) for x in places]
        trace = [
            (at[0] + x, offset + (radius + x * tan(cone)) * sin(turn)) for x, turn in points if abs(turn) < 0.5 * pi
        ]
        if len(trace) > 1:
            curves.append(line(trace, "", "thin", 0))
    return curves
