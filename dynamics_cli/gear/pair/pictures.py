"""A pair of gears as a data sheet: both gears to scale, the path of contact enlarged, the main sizes, sliding."""

from math import atan, cos, isfinite, sin

from dynamics_cli.errors import worded
from dynamics_cli.gear.section import (
    BLACK,
    GREEN,
    RIM,
    arc,
    centre_lines,
    circle,
    contact_panel,
    contact_points,
    form_of,
    meshing,
    sizes,
)
from dynamics_cli.gear.single.cylindrical import normal_pressure_angle
from dynamics_cli.gear.single.gear import Gear
from dynamics_cli.gear.single.rack import basic_rack
from dynamics_cli.numerics.involute import involute
from dynamics_cli.pictures import Axis, Band, Curve, Dimension, Label, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate, Fraction, Module, Ratio, Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.pair.records import Mate, PairData
    from dynamics_cli.gear.single.flanks import ToothForm

POINTS = 41
PATH = Axis("position along the path of contact, from the pitch point", Coordinate)
X, Y = Axis("x", Coordinate), Axis("y", Coordinate)
# Specific sliding beyond this leaves the panel: it has no bound at a base circle.
_STEEPEST = 6.0
# A pinion smaller than this share of its wheel has its words above it.
_SMALL = 0.6


def pair(
    result: "PairData", *, first: "Mate", second: "Mate", internal: bool = False, pitch: "Any", **inputs: "Any"
) -> Picture:
    """Both gears at their working distance, the path of contact, the main sizes and the specific sliding."""
    module = module_in(pitch, float(inputs.get("helix_angle", 0.0)))
    title = worded(
        "Gear pair {first} / {second}, module {module:6}",
        first=first.teeth,
        second=second.teeth,
        module=(module, Module),
    )
    return Picture(
        pair_panels(result, first=first, second=second, internal=internal, pitch=pitch, **inputs),
        title,
        columns=2,
        subtitle="Transverse section at the working centre distance; pitch circles dash-dotted, base circles dotted",
    )


def pair_panels(
    result: "PairData",
    *,
    first: "Mate",
    second: "Mate",
    internal: bool,
    pitch: "Any",
    brief: int = 0,
    **inputs: "Any",
) -> "tuple[Panel, ...]":
    """The gears, the path of contact, the main sizes and the sliding; `brief` where a table stands beside them.

    Beside a long table (2) the path of contact is wider than high.
    """
    gears = _gears(result, internal, _forms(result, first, second, internal, pitch, inputs))
    module = module_in(pitch, float(inputs.get("helix_angle", 0.0)))
    return (
        _whole(result, first, second, internal, gears, module, brief > 0),
        contact_panel(gears, _path(result), module, wide=brief > 1, titled=not brief),
        _table(result, first, second),
        _sliding(result, internal, brief > 0),
    )


def module_in(pitch: "Any", helix: float) -> float:
    """The normal module from a module or diametral pitch, normal or transverse."""
    return float(pitch.normal(cos(helix)))


def _forms(
    result: "PairData", first: "Mate", second: "Mate", internal: bool, pitch: "Any", inputs: "dict[str, Any]"
) -> "list[ToothForm | None]":
    """The exact forms of both gears as cut; None for a gear that cannot be drawn."""
    helix = abs(float(inputs.get("helix_angle", 0.0)))
    angle = normal_pressure_angle(inputs.get("pressure_angle"), inputs.get("transverse_pressure_angle"), helix)
    radius = inputs.get("root_radius_factor")
    factors = inputs.get("addendum_factor"), inputs.get("dedendum_factor"), radius
    rack = basic_rack(inputs.get("profile", "a"), angle, *factors)
    ends = (
        (first.teeth, result.first_profile_shift, result.first_generating_shift, result.first_tip_diameter),
        (-second.teeth if internal else second.teeth, result.second_profile_shift, result.second_generating_shift,
         result.second_tip_diameter),
    )  # fmt: skip
    forms: list[ToothForm | None] = []
    for teeth, shift, generating, tip in ends:
        gear = Gear(teeth, module_in(pitch, helix), rack, helix, float(shift if generating is None else generating))
        forms.append(form_of(gear, float(tip), radius))
    return forms


def _gears(result: "PairData", internal: bool, forms: "list[ToothForm | None]") -> "list[Any]":
    """Both gears about their axes; circles where a gear has no exact form."""
    radii = 0.5 * float(result.first_working_diameter), 0.5 * float(result.second_working_diameter)
    exact = [form for form in forms if form is not None]
    if len(exact) == len(forms):
        return [*meshing(exact, float(result.centre_distance), radii)]
    places = (0.0, 0.0), (float(-result.centre_distance if internal else result.centre_distance), 0.0)
    tips = result.first_tip_diameter, result.second_tip_diameter
    return [
        item
        for role in (0, 1)
        for item in (
            circle(places[role], 0.5 * float(tips[role]), "", "outline", role),
            circle(places[role], radii[role], "", "centre", role),
        )
    ]


def _path(result: "PairData") -> "list[tuple[str, float, float]]":
    """The points A to E in the plane of the gears, the first gear's axis at the origin."""
    along = [(point.point, float(point.path)) for point in result.points]
    return contact_points(along, 0.5 * float(result.first_working_diameter), float(result.working_pressure_angle))


def _whole(
    result: "PairData",
    first: "Mate",
    second: "Mate",
    internal: bool,
    gears: "list[Any]",
    module: float,
    brief: bool,
) -> Panel:
    """Both gears to scale with their distance."""
    outer = (
        0.5 * float(result.second_root_diameter) + RIM * module if internal else 0.5 * float(result.second_tip_diameter)
    )
    radii = 0.5 * float(result.first_tip_diameter), outer
    x = float(-result.centre_distance if internal else result.centre_distance)
    size = max(radii)
    foot = -1.2 * size
    points = _path(result)
    distance = worded("a_w = {distance:6}", distance=(float(result.centre_distance), Size))
    items: list[Any] = [*centre_lines((0.0, 0.0), 1.08 * radii[0]), *centre_lines((x, 0.0), 1.08 * radii[1]), *gears]
    items += [
        Curve((points[0][1], points[-1][1]), (points[0][2], points[-1][2]), "", "thick", GREEN),
        Curve((0.0, 0.0), (-1.08 * radii[0], foot), "", "thin", BLACK),
        Curve((x, x), (-1.08 * radii[1], foot), "", "thin", BLACK),
    ]
    ends = min(0.0, x), max(0.0, x)
    if abs(x) > 0.5 * size:
        items.append(Dimension(ends, (foot, foot), distance))
    else:
        items += [Dimension(ends, (foot, foot), ""), Label(ends[1] + 0.05 * size, foot, distance, BLACK, left=True)]
    items += _names(result, first, second, internal, radii, x, brief)
    return Panel(X, Y, tuple(items), equal=True, bare=True, wide=True)


def _names(
    result: "PairData",
    first: "Mate",
    second: "Mate",
    internal: bool,
    radii: "tuple[float, float]",
    x: float,
    brief: bool,
) -> "list[Label]":
    """The names of both gears: inside them where there is room between the teeth, a small pinion's above it."""
    size = max(radii)
    pinion_small = radii[0] < _SMALL * radii[1]
    if pinion_small and not internal:
        places = (
            (-0.1 * size, 1.08 * radii[0] + (0.09 if brief else 0.16) * size),
            (x + 0.4 * radii[1], 0.35 * radii[1]),
        )
    else:
        places = (
            ((0.4 if internal else -0.4) * radii[0], 0.35 * radii[0]),
            ((x, 1.13 * radii[1]) if internal else (x + 0.35 * radii[1], 0.35 * radii[1])),
        )
    shifts = result.first_profile_shift, result.second_profile_shift
    labels = []
    for role, name in enumerate(("1", "2, internal" if internal else "2")):
        text = worded(
            "gear {name}"
            if brief
            else "gear {name}: z = {teeth}, x = {shift}"
            if internal and role
            else "gear {name}\nz = {teeth}\nx = {shift}",
            name=name,
            teeth=(first, second)[role].teeth,
            shift=(float(shifts[role]), Ratio),
        )
        labels.append(Label(*places[role], text, role))
    return labels


def _table(result: "PairData", first: "Mate", second: "Mate") -> Panel:
    """The main sizes with their symbols."""
    common = int(result.common_factor)
    ratio = worded("{z2}/{z1} = {u:5}", z1=first.teeth, z2=second.teeth, u=(float(result.ratio), Ratio))
    return sizes(
        ("centre distance", "a_w", result.centre_distance, Size),
        ("working pressure angle", "α_wt", result.working_pressure_angle, Angle),
        ("gear ratio", "u", ratio, None),
        ("path of contact", "g_α", result.path_length, Size),
        ("transverse contact ratio", "ε_α", result.transverse_contact_ratio, Ratio),
        ("total contact ratio", "ε_γ", result.total_contact_ratio, Ratio),
        ("circumferential backlash", "j_wt", result.circumferential_backlash, Coordinate),
        ("tip clearance of gear 1", "c_1", result.first_tip_clearance, Coordinate),
        ("tip clearance of gear 2", "c_2", result.second_tip_clearance, Coordinate),
        ("efficiency of the mesh", "η", result.efficiency, Fraction),
        ("every tooth meets every other", "", "yes" if common == 1 else f"no: common factor {common}", None),
    )


def _sliding(result: "PairData", internal: bool, brief: bool) -> Panel:
    """Specific sliding of both flanks along the path of contact, with the points A to E."""
    start, end, pitch = result.points[0], result.points[-1], result.points[2]
    u = -result.ratio if internal else result.ratio
    other = -pitch.second_curvature if internal else pitch.second_curvature
    steps = [start.path + (end.path - start.path) * k / (4 * POINTS) for k in range(4 * POINTS + 1)]
    zeta1 = [_bounded(s * (1.0 + 1.0 / u), pitch.first_curvature + s) for s in steps]
    zeta2 = [_bounded(-s * (1.0 + u), other - s) for s in steps]
    finite = [value for value in zeta1 + zeta2 if isfinite(value)]
    low, high = min(finite), max(finite)
    # Lines without names: they would look the same in the legend, so the points are labelled instead.
    marks = [Band(point.path, point.path) for point in result.points]
    margin = 0.16 * (high - low)
    across = 0.008 * (end.path - start.path)
    names = [Label(point.path + across, high + 0.6 * margin, point.point, left=True) for point in result.points]
    curves = (Curve(steps, zeta1, role=0), Curve(steps, zeta2, "", "dashed", role=1))
    names += _beside(steps, zeta1, zeta2)
    up = Axis("ζ" if brief else "specific sliding ζ", Ratio, ends=(low - 0.3 * margin, high + margin))
    along = Axis("along the path of contact", Coordinate) if brief else PATH
    return Panel(along, up, (*curves, *marks, *names), wide=True)


def _beside(steps: "list[float]", zeta1: "list[float]", zeta2: "list[float]") -> "list[Label]":
    """The names of both curves at their lower ends, on the side where the panel is free."""
    length = steps[-1] - steps[0]
    names = []
    for role, values in enumerate((zeta1, zeta2)):
        place, value = min(
            ((s, v) for s, v in zip(steps, values, strict=True) if isfinite(v)), key=lambda item: item[1]
        )
        inwards = 0.05 if place - steps[0] < 0.5 * length else -0.16
        names.append(Label(place + inwards * length, value, f"gear {role + 1}", role, left=True))
    return names


def _bounded(above: float, below: float) -> float:
    """The quotient, or a gap in the line where it leaves the panel."""
    value = above / below if below else float("nan")
    return value if isfinite(value) and abs(value) <= _STEEPEST else float("nan")


def involute_curve(result: "Any", *, base_diameter: "float | None" = None, **_: "Any") -> Picture:
    """The involute from its base circle to the given point, or the involute function if no base circle is given."""
    if base_diameter is None:
        angles = [result.pressure_angle * k / (POINTS - 1) for k in range(POINTS)]
        items = (Curve(angles, [involute(a) for a in angles]), Mark(result.pressure_angle, result.involute, "inv α"))
        return Picture(
            (Panel(Axis("pressure angle", Angle), Axis("involute function", Ratio), items),), "involute function"
        )
    base = 0.5 * base_diameter
    rolls = [result.roll_angle * k / (POINTS - 1) for k in range(POINTS)]
    radii = [base * (1.0 + t * t) ** 0.5 for t in rolls]
    polar = [t - atan(t) for t in rolls]
    x, y = (
        [r * cos(p) for r, p in zip(radii, polar, strict=True)],
        [r * sin(p) for r, p in zip(radii, polar, strict=True)],
    )
    string = Curve([base * cos(rolls[-1]), x[-1]], [base * sin(rolls[-1]), y[-1]], "string", "thin")
    items2 = (Curve(x, y, "involute"), arc((0.0, 0.0), base, (0.0, rolls[-1]), "base circle", "dotted", 2), string)
    across = Axis("from the centre", Coordinate)
    return Picture((Panel(across, Axis("across", Coordinate), items2, equal=True),), "an involute")
