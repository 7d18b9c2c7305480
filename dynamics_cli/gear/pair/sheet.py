"""A pair of gears as a data sheet: drawing data of both gears, their mesh, and both to scale."""

from math import cos, pi, tan

from dynamics_cli.errors import DynamicsError, worded
from dynamics_cli.gear.measure.data_block import rack_name
from dynamics_cli.gear.measure.measurement import measure
from dynamics_cli.gear.pair.pictures import module_in, pair_panels
from dynamics_cli.gear.rounding import bare
from dynamics_cli.gear.single.cylindrical import normal_pressure_angle
from dynamics_cli.pictures import Listing, Picture, Sheet
from dynamics_cli.quantities import (
    Angle,
    Coordinate,
    DiametralPitch,
    Force,
    Fraction,
    Frequency,
    Module,
    Power,
    Ratio,
    ShaftSpeed,
    Size,
    Speed,
    Torque,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.measure.measurement import Measurements
    from dynamics_cli.gear.pair.records import Mate, PairData

    Row = tuple[str, ...]

# Inches of a column.
LEFT, RIGHT = 3.7, 3.0
# Beside more rows than these the path of contact is drawn lower.
MANY = 15
PITCHES = {
    "module": ("module", "m_n", Module),
    "diametral_pitch": ("diametral pitch", "P_nd", DiametralPitch),
    "circular_pitch": ("circular pitch", "p_n", Size),
    "transverse_module": ("transverse module", "m_t", Module),
    "transverse_diametral_pitch": ("transverse diametral pitch", "P_d", DiametralPitch),
    "transverse_circular_pitch": ("transverse circular pitch", "p_t", Size),
}


def pair_sheet(
    result: "PairData", *, first: "Mate", second: "Mate", internal: bool = False, pitch: "Any", **inputs: "Any"
) -> Sheet:
    """Both gears and their mesh on one page."""
    result = bare(result)
    helix = abs(float(inputs.get("helix_angle", 0.0)))
    module = module_in(pitch, helix)
    angle = normal_pressure_angle(inputs.get("pressure_angle"), inputs.get("transverse_pressure_angle"), helix)
    mesh = _mesh(result, first, second, inputs)
    overview, contact, _, sliding = pair_panels(
        result, first=first, second=second, internal=internal, pitch=pitch, brief=2 if len(mesh) > MANY else 1, **inputs
    )
    gears = Listing("Gears", ("size", "symbol", "gear 1", "gear 2"), tuple(
        _gears(result, (first, second), internal, pitch, module, float(bare(angle)), helix, inputs)
    ))  # fmt: skip
    kinds = {name: kind for name, (_, _, kind) in PITCHES.items()}
    name, size = next(item for item in vars(pitch).items() if item[0] in kinds)
    title = worded(
        "Gear pair {first} / {second}, {name} {size:6}",
        first=first.teeth,
        second=f"{second.teeth} internal" if internal else second.teeth,
        name=PITCHES[name][0],
        size=(float(bare(size)), kinds[name]),
    )
    return Sheet(
        title,
        "Transverse section at the working centre distance; pitch circles dash-dotted, base circles dotted.",
        (Picture((overview,), "both gears at the working centre distance", width=LEFT), gears),
        (
            Picture((contact,), "path of contact, A to E", width=RIGHT),
            Listing("Mesh", ("size", "symbol", "value"), tuple(mesh)),
            Picture((sliding,), "specific sliding along the path of contact", width=RIGHT),
        ),
    )


def _gears(
    result: "PairData",
    mates: "tuple[Mate, Mate]",
    internal: bool,
    pitch: "Any",
    module: float,
    angle: float,
    helix: float,
    inputs: "dict[str, Any]",
) -> "list[Row]":
    """Data of each gear, with its inspection sizes."""
    teeth = mates[0].teeth, -mates[1].teeth if internal else mates[1].teeth
    sizes = [_measured(result, nth, mates[nth].teeth, internal, angle, module, inputs) for nth in (0, 1)]
    factors = inputs.get("addendum_factor"), inputs.get("dedendum_factor"), inputs.get("root_radius_factor")
    rows: list[Row] = [
        ("number of teeth", "z", *map(str, teeth)),
        *_pitch(pitch, module, bool(helix)),
        _both("pressure angle", "α_n" if helix else "α", (angle, angle), Angle),
        ("basic rack", "", *[rack_name(inputs.get("profile", "a"), *factors)] * 2),
    ]
    if helix:
        hand = str(inputs.get("hand", "right"))
        if float(inputs.get("helix_angle", 0.0)) < 0.0:
            hand = _other(hand)
        lead = [pi * abs(count) * module / cos(helix) / tan(helix) for count in teeth]
        rows += [
            _both("helix angle", "β", (helix, helix), Angle),
            ("hand of helix", "", hand, hand if internal else _other(hand)),
            _both("lead", "p_z", lead, Size),
        ]
    rows += [
        _of(result, "profile shift", "x", "profile_shift", Ratio),
        _both("reference diameter", "d", [abs(count) * module / cos(helix) for count in teeth], Size),
        _of(result, "base diameter", "d_b", "base_diameter", Size),
        _of(result, "working pitch diameter", "d_w", "working_diameter", Size),
        _of(result, "tip diameter", "d_a", "tip_diameter", Size),
        _of(result, "root diameter", "d_f", "root_diameter", Size),
        _both("tooth depth", "h", [
            0.5 * abs(float(getattr(result, f"{side}_tip_diameter")) - float(getattr(result, f"{side}_root_diameter")))
            for side in ("first", "second")], Size),
        _both("normal tooth thickness", "s_n", [_part(size, "normal_thickness") for size in sizes], Size),
    ]  # fmt: skip
    return rows + _inspection(sizes, [_thinning(result, nth, module, angle) for nth in (0, 1)], result)


def _pitch(pitch: "Any", module: float, helical: bool) -> "list[Row]":
    """The size of the teeth as it was given, and as normal module."""
    rows = [_both("normal module" if helical else "module", "m_n" if helical else "m", (module, module), Module)]
    for name, (words, symbol, kind) in PITCHES.items():
        size = getattr(pitch, name, None)
        if size is not None and name != "module":
            rows.insert(0, _both(words, symbol, (size, size), kind))
    return rows


def _inspection(sizes: "list[Measurements | None]", thinning: "list[float]", result: "PairData") -> "list[Row]":
    """Span, pins and chord of both gears, nominal and, for thinned teeth, as to be measured."""
    thin = any(thinning)
    over = [_part(size, "span.over") for size in sizes]
    rows: list[Row] = [_both("thinning of the teeth", "A_sn", thinning, Size, 4)] if thin else []
    rows += [
        ("teeth (spaces) to span", "k", *(_dash(count) for count in over)),
        _both("span (base tangent)", "W_k", [_part(size, "span.span") for size in sizes], Size),
        *([_both("span, thinned", "W_k", [_part(size, "span.span_upper") for size in sizes], Size)] if thin else []),
        _both("pin or ball diameter", "D_M", [_part(size, "pins.pin") for size in sizes], Size),
        _both("size over (between) pins", "M_d", [_part(size, "pins.size") for size in sizes], Size),
    ]
    if thin:
        rows.append(_both("size over pins, thinned", "M_d", [_part(size, "pins.size_upper") for size in sizes], Size))
    chord, height = ([_part(size, f"chordal.{name}") for size in sizes] for name in ("thickness", "height"))
    return [
        *rows,
        _both("chordal thickness", "s_c", chord, Size),
        _both("chordal height", "h_c", height, Size),
        _both("tip clearance", "c", (result.first_tip_clearance, result.second_tip_clearance), Coordinate, 4),
    ]


def _measured(
    result: "PairData", nth: int, teeth: int, internal: bool, angle: float, module: float, inputs: "dict[str, Any]"
) -> "Measurements | None":
    """Sizes that measure a gear's tooth thickness; None where they do not exist."""
    from dynamics_cli.gear.pitch import NormalModule

    side = ("first", "second")[nth]
    thinning = _thinning(result, nth, module, angle)
    try:
        return measure(
            teeth=teeth,
            pitch=NormalModule(module),
            pressure_angle=angle,
            helix_angle=abs(float(inputs.get("helix_angle", 0.0))),
            profile_shift=float(getattr(result, f"{side}_profile_shift")),
            internal=internal and nth == 1,
            tip_diameter=float(getattr(result, f"{side}_tip_diameter")),
            upper_allowance=-thinning if thinning else None,
            **{
                name: inputs[name]
                for name in ("profile", "addendum_factor", "dedendum_factor", "root_radius_factor")
                if name in inputs
            },
        )
    except DynamicsError:
        return None


def _thinning(result: "PairData", nth: int, module: float, angle: float) -> float:
    """A_sn = 2 (x − x_E) m_n tan α_n: thickness allowance of a gear's teeth."""
    side = ("first", "second")[nth]
    cut = getattr(result, f"{side}_generating_shift")
    if cut is None:
        return 0.0
    return 2.0 * abs(float(getattr(result, f"{side}_profile_shift")) - float(cut)) * module * tan(angle)


def _mesh(result: "PairData", first: "Mate", second: "Mate", inputs: "dict[str, Any]") -> "list[Row]":
    """How the gears run together."""
    common = int(result.common_factor)
    interferes = [verdict.kind.partition(":")[0] for verdict in result.verdicts if not verdict.free]
    ends = result.points[0], result.points[-1]
    highest = max((abs(float(value)) for point in ends for value in (point.first_sliding, point.second_sliding)
                   if value is not None), default=None)  # fmt: skip
    rows: list[Row] = [
        _one("centre distance", "a_w", result.centre_distance, Size),
        _one("working pressure angle", "α_wt", result.working_pressure_angle, Angle),
        ("gear ratio", "u", worded("{b}/{a} = {u:6}", a=first.teeth, b=second.teeth, u=(float(result.ratio), Ratio))),
        _one("transverse contact ratio", "ε_α", result.transverse_contact_ratio, Ratio, 4),
        _one("overlap ratio", "ε_β", result.overlap_ratio, Ratio, 4),
        _one("total contact ratio", "ε_γ", result.total_contact_ratio, Ratio, 4),
        _one("path of contact", "g_α", result.path_length, Size),
        _one("circumferential backlash", "j_wt", result.circumferential_backlash, Coordinate, 4),
        _one("normal backlash", "j_bn", result.normal_backlash, Coordinate, 4),
        _one("largest specific sliding", "ζ", highest, Ratio, 4),
        _one("tip change", "k", result.tip_change, Ratio, 4),
        ("interference", "", f"yes: {', '.join(interferes)}" if interferes else "none"),
        ("every tooth meets every other", "", "yes" if common == 1 else f"no: common factor {common}"),
        _one(
            worded("efficiency at friction {mu}", mu=(float(inputs.get("friction", 0.06)), Ratio)),
            "η", result.efficiency, Fraction, 4,
        ),
        _one("face width", "b", inputs.get("face_width"), Size),
        _one("speed of gear 1", "n_1", inputs.get("speed"), ShaftSpeed),
        _one("power", "P", inputs.get("power"), Power),
        _one("torque on gear 1", "T_1", result.torque, Torque),
        _one("torque on gear 2", "T_2", result.second_torque, Torque),
        _one("pitch line velocity", "v", result.pitch_line_speed, Speed, 4),
        _one("tooth meshing frequency", "f_z", result.mesh_frequency, Frequency, 4),
    ]  # fmt: skip
    if result.forces is not None:
        rows += [
            _one(f"{name} force", symbol, getattr(result.forces, name), Force, 5)
            for name, symbol in (("tangential", "F_t"), ("radial", "F_r"), ("axial", "F_a"))
        ]
    return [row for row in rows if row[-1] != "–"]


def _of(result: "PairData", name: str, symbol: str, key: str, kind: "Any") -> "Row":
    return _both(name, symbol, [getattr(result, f"{side}_{key}") for side in ("first", "second")], kind)


def _both(name: str, symbol: str, values: "Any", kind: "Any", digits: int = 6) -> "Row":
    return name, symbol, *(_text(value, kind, digits) for value in values)


def _one(name: str, symbol: str, value: "Any", kind: "Any", digits: int = 6) -> "Row":
    return name, symbol, _text(value, kind, digits)


def _text(value: "Any", kind: "Any", digits: int) -> str:
    return "–" if value is None else worded(f"{{value:{digits}}}", value=(float(bare(value)), kind))


def _dash(value: "Any") -> str:
    return "–" if value is None else str(int(value))


def _other(hand: str) -> str:
    return "left" if hand == "right" else "right"


def _part(size: "Measurements | None", address: str) -> "Any":
    """A part of the measurements, None where any step of the way is missing."""
    node: Any = size
    for step in address.split("."):
        node = getattr(node, step, None)
    return node
