"""Pictures of one gear: its teeth with their circles, its profile, its rack."""

from math import acos, cos, pi, sin, tan

from dynamics_cli.errors import InadmissibleError, worded
from dynamics_cli.gear.section import BLACK, MOST_DRAWN, RIM, centre_lines, circle, outline_points
from dynamics_cli.pictures import Axis, Curve, Dimension, Label, Panel, Picture, Rows
from dynamics_cli.quantities import Angle, Coordinate, Force, Module, Ratio, Size, Speed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.pictures import Style

    Points = tuple[list[float], list[float]]

X, Y = Axis("x", Coordinate), Axis("y", Coordinate)
SHOWN = 3
# Colours of tip, reference, base and root circle.
ROLES = (0, 1, 2, 3)
STEPS = 96
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
    return Picture(
        (
            _whole_gear(result, teeth, internal, inputs),
            Panel(X, Y, (Rows(_sizes(result)),)),
            _enlarged(result, teeth, internal, inputs),
        ),
        title,
        columns=2,
        subtitle="Transverse section; reference circle dash-dotted, base circle dotted",
    )


def _whole_gear(result: "Any", teeth: int, internal: bool, inputs: "dict[str, Any]") -> Panel:
    """The gear with its centre lines."""
    outer = (
        0.5 * float(result.root_diameter) + RIM * float(result.normal_module) if internal else 0.5 * result.tip_diameter
    )
    centre = (0.0, 0.0)
    items: list[Any] = [*centre_lines(centre, 1.1 * float(outer))]
    line = _outline(result, teeth, internal, teeth, inputs) if teeth <= MOST_DRAWN else None
    if line is None:
        items.append(circle(centre, 0.5 * float(result.tip_diameter), "", "outline", 0))
    elif internal:
        rim = circle(centre, float(outer), "", "solid", 0)
        around = (*rim.x, *reversed(line[0]), rim.x[0]), (*rim.y, *reversed(line[1]), rim.y[0])
        items += [Curve(*around, "", "fill", 0), Curve(*line, "", "outline", 0)]
    else:
        items.append(Curve(*line, "", "filled", 0))
    items += [
        circle(centre, 0.5 * float(result.reference_diameter), "", "centre", 0),
        circle(centre, 0.5 * float(result.base_diameter), "", "dots", 0),
    ]
    return Panel(X, Y, tuple(items), equal=True, bare=True)


def _sizes(result: "Any") -> "tuple[tuple[str, str, str], ...]":
    """The main sizes with their symbols; sizes that the gear does not have are left out."""
    listed = (
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
    )
    rows: list[tuple[str, str, str]] = [
        (name, symbol, worded("{value:6}", value=(float(value), kind)))
        for name, symbol, value, kind in listed
        if value is not None
    ]
    if result.undercut is not None:
        rows.append(("undercut", "", "yes" if result.undercut else "no"))
    return tuple(rows)


def _enlarged(result: "Any", teeth: int, internal: bool, inputs: "dict[str, Any]") -> Panel:
    """Three teeth with their circles, each named at its end."""
    items: list[Any] = []
    line = _outline(result, teeth, internal, SHOWN, inputs)
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
    items: list[Any] = []
    outline = _outline(result, teeth, False, teeth, {**inputs, "helix_angle": helix_angle})
    pitch, datum = float(result.pitch), -float(result.datum_distance)
    if outline is not None:
        # the gear's middle tooth stands in the rack's space at x = 0
        turn = pi + pi * (teeth - 1) / teeth
        x = [cos(turn) * a - sin(turn) * b for a, b in zip(*outline, strict=True)]
        y = [sin(turn) * a + cos(turn) * b for a, b in zip(*outline, strict=True)]
        items.append(Curve((*x, x[0]), (*y, y[0]), "", "filled", 0))
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
    rows = tuple(
        (name, symbol, worded("{value:6}", value=(float(value), kind)))
        for name, symbol, value, kind in (
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
        if value is not None
    )
    title = worded("Rack and gear of {teeth} teeth, x = {shift}", teeth=teeth, shift=(_shift(inputs), Ratio))
    x_axis, y_axis = Axis("x", Coordinate, ends=(-wide, wide)), Axis("y", Coordinate, ends=(low, top))
    scene = Panel(x_axis, y_axis, tuple(items), equal=True, bare=True)
    subtitle = "Transverse section; pitch circle dash-dotted, base circle dotted"
    return Picture((scene, Panel(X, Y, (Rows(rows),))), title, subtitle=subtitle)


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


def _outline(result: "Any", teeth: int, internal: bool, teeth_drawn: int, inputs: "dict[str, Any]") -> "Points | None":
    """The exact outline of some teeth about +y; None if it cannot be drawn, for example for pointed teeth."""
    shift = inputs.get("profile_shift", 0.0)
    shift_as_cut = getattr(result, "profile_shift", None)
    profile = exact_profile(
        teeth,
        internal,
        teeth_drawn,
        {**inputs, "profile_shift": shift if shift_as_cut is None else float(shift_as_cut)},
        result,
    )
    if profile is None:
        return None
    # Tooth after tooth anticlockwise from +y: rotated back by half of them, they are centred on it.
    turn = -pi * (min(teeth_drawn, teeth) - 1) / teeth
    x, y = outline_points(profile.drawing.outlines[0])
    return (
        [cos(turn) * a - sin(turn) * b for a, b in zip(x, y, strict=True)],
        [sin(turn) * a + cos(turn) * b for a, b in zip(x, y, strict=True)],
    )


def exact_profile(
    teeth: int, internal: bool, teeth_drawn: "int | None", inputs: "dict[str, Any]", result: "Any" = None
) -> "Any":
    """The profile of a gear from the task's inputs, in lines; None if it cannot be drawn."""
    from dynamics_cli.gear.pitch import module_of
    from dynamics_cli.gear.single.cylindrical import normal_pressure_angle
    from dynamics_cli.gear.single.profile import profile

    helix = inputs.get("helix_angle", 0.0)
    names = ("profile", "addendum_factor", "dedendum_factor", "root_radius_factor")
    chosen = {name: inputs[name] for name in names if inputs.get(name) is not None}
    transverse = inputs.get("transverse_pressure_angle")
    if transverse is not None or inputs.get("pressure_angle") is not None:
        chosen["pressure_angle"] = normal_pressure_angle(inputs.get("pressure_angle"), transverse, helix)
    if result is not None:
        chosen["tip_diameter"] = float(result.tip_diameter)
    elif inputs.get("tip_diameter") is not None:
        chosen["tip_diameter"] = inputs["tip_diameter"]
    if result is None and "shift_sign" in inputs:
        chosen["shift_sign"] = inputs["shift_sign"]
    try:
        return profile(
            teeth=teeth,
            pitch=inputs["pitch"],
            helix_angle=helix,
            profile_shift=inputs["profile_shift"],
            internal=internal,
            only_teeth=None if teeth_drawn is None else min(teeth_drawn, teeth),
            form="lines",  # type: ignore[arg-type]
            tolerance=FINE * module_of(inputs["pitch"], helix),
            **chosen,
        )
    except InadmissibleError:
        return None


def _arc(radius: float, reach: float, label: str, style: "Any", role: int) -> Curve:
    """An arc about the centre, symmetrical about +y."""
    turns = [reach * (2.0 * k / STEPS - 1.0) for k in range(STEPS + 1)]
    return Curve([radius * sin(t) for t in turns], [radius * cos(t) for t in turns], label, style, role)
