"""Pictures of one gear: its teeth with their circles, its profile, its rack."""

from math import acos, cos, pi, sin, tan

from dynamics_cli.errors import InadmissibleError, worded
from dynamics_cli.gear import options
from dynamics_cli.gear.section import (
    BLACK,
    RIM,
    body,
    centre_lines,
    circle,
    form_of,
    gear_items,
    outline_points,
    sizes,
    turned,
)
from dynamics_cli.gear.single.cylindrical import normal_pressure_angle
from dynamics_cli.gear.single.outline import gear_outline
from dynamics_cli.gear.single.toothing_given import GEAR, gear_of
from dynamics_cli.pictures import Axis, Curve, Dimension, Label, Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate, Force, Module, Ratio, Size, Speed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.section import Line
    from dynamics_cli.gear.single.flanks import ToothForm
    from dynamics_cli.pictures import Style

    Points = tuple[list[float], list[float]]

X, Y = Axis("x", Coordinate), Axis("y", Coordinate)
SHOWN = 3
# Colours of tip, reference, base and root circle.
ROLES = (0, 1, 2, 3)
STEPS = 96
UPWARDS = 0.5 * pi
# Resolution of a printed line, relative to the module.
FINE = 2e-3


def gear_picture(result: "Any", *, teeth: int, internal: bool = False, **inputs: "Any") -> Picture:
    """The whole gear with its main sizes, and three teeth enlarged with their circles."""
    module = float(result.normal_module)
    title = worded(
        "{kind} gear of {teeth} teeth, module {module:6}, x = {shift}",
        kind="Internal" if internal else "Helical" if result.hand is not None else "Spur",
        teeth=teeth,
        module=(module, Module),
        shift=(float(result.profile_shift), Ratio),
    )
    form = form_in(teeth, internal, inputs, result)
    return Picture(
        (_whole_gear(result, form, internal), _sizes(result), _enlarged(result, form, teeth)),
        title,
        columns=2,
        subtitle="Transverse section; reference circle dash-dotted, base circle dotted",
    )


def _whole_gear(result: "Any", form: "ToothForm | None", internal: bool) -> Panel:
    """The gear with its centre lines."""
    outer = 0.5 * float(result.root_diameter if internal else result.tip_diameter)
    outer += RIM * float(result.normal_module) if internal else 0.0
    centre, pitch_radius = (0.0, 0.0), 0.5 * float(result.reference_diameter)
    items = centre_lines(centre, 1.1 * outer)
    if form is not None:
        items += gear_items(form, centre, UPWARDS, 0, pitch_radius)
    else:
        items.append(circle(centre, 0.5 * float(result.tip_diameter), "", "outline", 0))
        items.append(circle(centre, pitch_radius, "", "centre", 0))
    return Panel(X, Y, tuple(items), equal=True, bare=True)


def _sizes(result: "Any") -> Panel:
    """The main sizes with their symbols; sizes that the gear does not have are left out."""
    return sizes(
        ("reference diameter", "d", result.reference_diameter, Size),
        ("base diameter", "d_b", result.base_diameter, Size),
        ("tip diameter", "d_a", result.tip_diameter, Size),
        ("root diameter", "d_f", result.root_diameter, Size),
        ("root form diameter", "d_Ff", result.root_form_diameter, Size),
        ("lead", "p_z", result.lead, Size),
        ("transverse pressure angle", "α_t", result.transverse_pressure_angle, Angle),
        ("tooth depth", "h", result.tooth_depth, Size),
        ("normal tooth thickness", "s_n", result.normal_thickness, Size),
        ("tip thickness", "s_a", result.tip_thickness, Size),
        ("undercut", "", None if result.undercut is None else "yes" if result.undercut else "no", None),
    )


def _enlarged(result: "Any", form: "ToothForm | None", teeth: int) -> Panel:
    """Three teeth with their circles, each named at its end."""
    items: list[Any] = []
    line = None if form is None else _middle_teeth(form, min(SHOWN, teeth))
    if line is not None:
        items.append(Curve(*line, "", "outline", role=BLACK))
    reach = min(1.15 * pi * SHOWN / teeth, 0.5 * pi)
    circles = (
        ("tip circle d_a", result.tip_diameter, "thin"),
        ("reference circle d", result.reference_diameter, "centre"),
        ("base circle d_b", result.base_diameter, "dots"),
        ("root circle d_f", result.root_diameter, "thin"),
    )
    radii = [0.5 * float(diameter) for _, diameter, _ in circles]
    side = sin(reach) * max(radii)
    ends = sorted(zip((radius * cos(reach) for radius in radii), circles, strict=True), key=lambda end: -end[0])
    height = None
    for level, (name, diameter, style) in ends:
        # labels keep their distance where circles are close together
        height = level if height is None else min(level, height - 0.075 * side)
        radius = 0.5 * float(diameter)
        role = [name for name, _, _ in circles].index(name)
        items.append(_arc(radius, reach, "", style, ROLES[role]))
        items.append(Curve((sin(reach) * radius, 1.05 * side), (level, height), "", "thin", ROLES[role]))
        text = worded(name + " = {diameter:6}", diameter=(float(diameter), Size))
        items.append(Label(1.07 * side, height, text, ROLES[role], left=True))
    low = min(height or 0.0, min(level for level, _ in ends), *(line[1] if line is not None else ())) - 0.05 * side
    across, up = (-1.03 * side, 1.85 * side), (low, max(radii) + 0.05 * side)
    x, y = Axis("x", Coordinate, ends=across), Axis("y", Coordinate, ends=up)
    return Panel(x, y, tuple(items), "Three teeth enlarged" if teeth > SHOWN else "", equal=True, bare=True, wide=True)


def profile_picture(result: "Any", **_: "Any") -> Picture:
    """The profile with its circles."""
    outline = result.drawing.outlines[0]
    x, y = outline_points(outline)
    items: list[Any] = []
    if outline.closed:
        x, y = (*x, x[0]), (*y, y[0])
        items = [*centre_lines((0.0, 0.0), 1.08 * max(x))]
        items += [
            circle((0.0, 0.0), 0.5 * float(result.base_diameter), "base circle", "dots", 2),
            circle((0.0, 0.0), 0.5 * float(result.form_diameter), "form circle", "thin", 3),
        ]
    style: Style = "filled" if result.drawing.title == "gear" else "outline"
    items.insert(0, Curve(x, y, "", style, role=0))
    return Picture((Panel(X, Y, tuple(items), equal=True),), f"Profile: {result.drawing.title}")


def rack_picture(result: "Any", *, teeth: int, helix_angle: float = 0.0, **inputs: "Any") -> Picture:
    """The gear on its rack in the transverse plane, the rack below, and the main sizes."""
    form = form_in(teeth, False, {**inputs, "helix_angle": helix_angle}, result)
    pitch, datum = float(result.pitch), -float(result.datum_distance)
    # a tooth of the gear stands in the rack's space at x = 0
    items: list[Any] = body(form, (0.0, 0.0), -UPWARDS, 0) if form is not None else []
    bottom = datum - 2.2 * float(result.dedendum)
    points, foot_line = _rack_line(result, pitch, datum, bottom)
    items.append(Curve(*points, "", "filled", 1))
    wide = 2.4 * pitch
    radius = 0.5 * float(result.reference_diameter)
    low, top = bottom - 0.15 * pitch, datum + 2.9 * pitch
    items += [
        circle((0.0, 0.0), radius, "", "centre", 0),
        circle((0.0, 0.0), 0.5 * float(result.base_diameter), "", "dots", 0),
        Curve((-wide, wide), (datum, datum), "", "centre", 1),
        Curve((-wide, wide), (-radius, -radius), "", "thin", BLACK),
        Label(-0.97 * wide, -radius + 0.12 * pitch, "pitch line", BLACK, left=True),
        Label(-0.97 * wide, datum - 0.12 * pitch, "datum line", 1, left=True),
        Label(0.0, min(top - 0.3 * pitch, -0.25 * radius), f"gear, {teeth} teeth", 0),
        Label(0.0, bottom + 0.35 * float(result.dedendum), "rack", 1),
        Dimension((0.5 * pitch, 1.5 * pitch), (foot_line,) * 2, worded("p = {size:6}", size=(pitch, Size))),
    ]
    table = sizes(
        ("axis to datum line", "a", result.datum_distance, Size),
        ("axis to back of the rack", "", result.mounting_distance, Size),
        ("pitch along the travel", "p_t", result.pitch, Size),
        ("travel in one turn", "", result.travel, Size),
        ("tip diameter", "d_a", result.tip_diameter, Size),
        ("reference diameter", "d", result.reference_diameter, Size),
        ("transverse contact ratio", "ε_α", result.transverse_contact_ratio, Ratio),
        ("speed of the rack", "v", result.rack_speed, Speed),
        ("force along the travel", "F_t", result.tangential_force, Force),
    )
    title = worded("Rack and gear of {teeth} teeth, x = {shift}", teeth=teeth, shift=(_shift(inputs), Ratio))
    x_axis, y_axis = Axis("x", Coordinate, ends=(-wide, wide)), Axis("y", Coordinate, ends=(low, top))
    scene = Panel(x_axis, y_axis, tuple(items), equal=True, bare=True)
    subtitle = "Transverse section; pitch circle dash-dotted, base circle dotted"
    return Picture((scene, table), title, subtitle=subtitle)


def _shift(inputs: "dict[str, Any]") -> float:
    return float(inputs.get("profile_shift") or 0.0)


def _rack_line(result: "Any", pitch: float, datum: float, bottom: float) -> "tuple[Points, float]":
    """The rack as a closed line down to its back, and the height where its pitch is measured."""
    lean = tan(acos(min(1.0, float(result.base_diameter) / float(result.reference_diameter))))
    add, dedendum = float(result.addendum), float(result.dedendum)
    x: list[float] = []
    y: list[float] = []
    for nth in range(-4, 4):
        middle = (nth + 0.5) * pitch
        foot, top = 0.25 * pitch + dedendum * lean, 0.25 * pitch - add * lean
        x += [middle - foot, middle - top, middle + top, middle + foot]
        y += [datum - dedendum, datum + add, datum + add, datum - dedendum]
    return ([x[0], *x, x[-1], x[0]], [bottom, *y, bottom, bottom]), datum - 1.35 * dedendum


def _middle_teeth(form: "ToothForm", count: int) -> "Line":
    """The line of some teeth, centred on +y."""
    outline, _ = gear_outline(form, FINE * form.module, teeth=count)
    return turned(outline_points(outline), -pi * (count - 1) / form.teeth)


def form_in(teeth: int, internal: bool, inputs: "dict[str, Any]", result: "Any" = None) -> "ToothForm | None":
    """The form of a task's gear, its shift and tips as a result has them; None if it cannot be drawn."""
    helix = inputs.get("helix_angle", 0.0)
    angle = normal_pressure_angle(inputs.get("pressure_angle"), inputs.get("transverse_pressure_angle"), helix)
    given: dict[str, Any] = {"profile": options.RACK_A, "shift_sign": options.ISO, "profile_shift": 0.0, **inputs}
    given |= {"teeth": teeth, "internal": internal, "helix_angle": helix, "pressure_angle": angle}
    if getattr(result, "profile_shift", None) is not None:
        given |= {"profile_shift": float(result.profile_shift), "shift_sign": options.ISO}
    tip = inputs.get("tip_diameter") if result is None else float(result.tip_diameter)
    try:
        gear = gear_of(**{name: given.get(name) for name in GEAR})  # type: ignore[arg-type]
        return form_of(gear, tip, inputs.get("root_radius_factor"))
    except InadmissibleError:
        return None


def _arc(radius: float, reach: float, label: str, style: "Any", role: int) -> Curve:
    """An arc about the centre, symmetrical about +y."""
    turns = [reach * (2.0 * k / STEPS - 1.0) for k in range(STEPS + 1)]
    return Curve([radius * sin(t) for t in turns], [radius * cos(t) for t in turns], label, style, role)
