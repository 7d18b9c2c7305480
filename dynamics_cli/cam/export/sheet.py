"""A cam as a data sheet: its shape with the follower, its motion, its limits, and a table in steps of 30 degrees."""

from math import inf, pi

from dynamics_cli.cam.export.export import export
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.geometry.followers import MATES, Flank, Rotation
from dynamics_cli.cam.geometry.pictures import profile_picture
from dynamics_cli.cam.geometry.profile import STRAIGHT, CamProfile, profile
from dynamics_cli.cam.program.motion import Motion
from dynamics_cli.cam.program.pictures import LENGTHS as LIFTS
from dynamics_cli.cam.program.pictures import SWING_SYMBOLS, SWINGS, SYMBOLS, named_program, svaj
from dynamics_cli.cam.program.pieces import sample
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.cam.program.revolution import motion as revolution
from dynamics_cli.cam.program.summary import extreme
from dynamics_cli.errors import DynamicsError, worded
from dynamics_cli.pictures import Axis, Band, Listing, Panel, Picture, Sheet
from dynamics_cli.quantities import Angle, Area, Coordinate, Inertia, Mass, Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.export.records import CamExport

    Row = tuple[str, ...]

# Inches of a column.
LEFT, RIGHT = 3.7, 3.0
# The field of the shape is so much wider than high.
SHAPE = 1.45
HEAD = "size", "symbol", "value"
STEPS = 12
CCW = Rotation("counter-clockwise")
INNER = Flank("inner")
_NAMES = {
    "base_radius": ("base circle radius", "R_b"), "roller_radius": ("roller radius", "R_r"), "offset": ("offset", "e"),
    "arm": ("length of the arm", ""), "pivot_distance": ("pivot from the cam's axis", ""),
    "face_offset": ("face from the pivot", ""), "roller_distance": ("distance of the rollers", ""),
    "arm_angle": ("angle between the arms", ""),
}  # fmt: skip


def cam_sheet(
    result: "CamProfile | CamExport",
    scene: Program,
    program: str = "",
    follower: "Any" = None,
    rotation: Rotation = CCW,
    flank: Flank = INNER,
    start_angle: float = 0.0,
    **inputs: "Any",
) -> Sheet:
    """Shape, motion and limits of a cam on one page, with the deviation of its drawing."""
    same = {"program": program, "follower": follower, "rotation": rotation, "flank": flank}
    plate = {name: inputs[name] for name in ("thickness", "density") if name in inputs}
    turned = {**same, "start_angle": start_angle, "cutter_radius": inputs.get("cutter_radius")}
    cam = profile(scene, points=360, **turned, **plate)
    motion = motion_of(scene, program)
    shape, pressure, curvature = profile_picture(cam, scene, **turned).panels
    moved = svaj(revolution(scene, program=program), scene, program).panels[:3]
    angle_axis = Axis("cam angle θ", Angle, ends=(0.0, 2.0 * pi), step=0.5 * pi)
    panels = tuple(
        Panel(
            angle_axis,
            Axis(panel.y.title.rpartition(" ")[2], panel.y.kind, ends=panel.y.ends),
            tuple(map(_unnamed, panel.items)),
        )
        for panel in (*moved, pressure, curvature)
    )
    deviation = _drawn(result, scene, same, start_angle, inputs)
    name = type(follower).tag[1].replace("-", " ")
    pair = "; the first cam of the pair" if isinstance(follower, MATES) else ""
    return Sheet(
        worded("{follower} cam, base circle radius {base}", follower=name.capitalize(),
               base=(follower.base_radius, Size)),
        f"{named_program(scene, program)}{pair}",
        (
            Picture((_bare(shape),), _at_start(start_angle, rotation), width=LEFT),
            Listing("Cam", HEAD, (*_design(follower, motion), *_limits(cam, inputs, deviation))),
        ),
        (
            Picture(panels, "motion, pressure angle, radius of curvature", width=RIGHT),
        ),
        (_table(scene, motion, same, start_angle),),
    )  # fmt: skip


def _at_start(start_angle: float, rotation: Rotation) -> str:
    turned = worded(", drawn turned on by {angle}", angle=(start_angle, Angle)) if start_angle else ""
    return worded("the cam at cam angle 0{turned}, turning {way}", turned=turned, way=str(rotation).replace("-", ""))


def _bare(shape: Panel) -> Panel:
    """The shape without axes, all of it on a field somewhat wider than it is high."""
    x: list[float] = []
    y: list[float] = []
    for item in shape.items:
        across: Any = getattr(item, "x", [])
        up: Any = getattr(item, "y", [])
        x += across if isinstance(across, list) else [across]
        y += up if isinstance(up, list) else [up]
    half = 0.53 * (max(y) - min(y))
    wide = max(0.53 * (max(x) - min(x)), SHAPE * half)
    middle, centre = 0.5 * (min(x) + max(x)), 0.5 * (min(y) + max(y))
    return Panel(
        Axis("x", Coordinate, ends=(middle - wide, middle + wide)),
        Axis("y", Coordinate, ends=(centre - half, centre + half)),
        shape.items,
        "",
        equal=True,
        bare=True,
    )


def _unnamed(item: "Any") -> "Any":
    return Band(item.low, item.high, "", item.vertical) if isinstance(item, Band) else item


def _drawn(
    result: "CamProfile | CamExport",
    scene: Program,
    same: "dict[str, Any]",
    start_angle: float,
    inputs: "dict[str, Any]",
) -> "list[Row]":
    """Deviation of the drawing from the exact curve: of the drawing requested, or of `cam export` with its defaults."""
    form, curve = str(inputs.get("form", "arcs")), str(inputs.get("curve", "cam"))
    if isinstance(result, CamProfile):
        try:
            result = export(scene, start_angle=start_angle, **same, points=2)
        except DynamicsError as error:
            return [("drawing for a machine", "", f"none: {error.message}")]
    return [
        (f"{curve} curve as drawn (DXF)", "", f"{int(result.pieces)} {form}"),
        ("deviation, proved", "", worded("{off:3}", off=(float(result.deviation), Size))),
    ]


def _design(follower: "Any", motion: Motion) -> "list[Row]":
    """The follower and its motion."""
    ends = [extreme(motion, order) for order in range(3)]
    axes, symbols = (SWINGS, SWING_SYMBOLS) if motion.swing else (LIFTS, SYMBOLS)
    rows: list[Row] = [("follower", "", type(follower).tag[1].replace("-", " "))]
    for key in follower.fields:
        value = getattr(follower, key)
        if value:
            rows.append((*_NAMES.get(key, (key.replace("_", " "), "")), _text(value, _kind(key))))
    for (_, kind), span_ends, symbol in zip(axes, ends, symbols.values(), strict=False):
        words, _, sign = symbol.rpartition(" ")
        span = worded("{low:5} to {high:5}", low=(span_ends.least, kind), high=(span_ends.greatest, kind))
        rows.append((words, sign, span))
    return rows


def _limits(cam: CamProfile, inputs: "dict[str, Any]", deviation: "list[Row]") -> "list[Row]":
    """The limits of the shape, the plate, and the drawing."""
    rows: list[Row] = []
    for text, symbol, value, place, kind in (
        ("maximum pressure angle", "α", cam.largest_pressure_angle, cam.largest_pressure_angle_at, Angle),
        ("minimum pressure angle", "α", cam.least_pressure_angle, cam.least_pressure_angle_at, Angle),
        ("minimum convex radius", "ρ", cam.least_convex_radius, cam.least_convex_radius_at, Coordinate),
        ("minimum concave radius", "ρ", cam.least_concave_radius, cam.least_concave_radius_at, Coordinate),
    ):
        if value is not None and place is not None:
            rows.append((text, symbol, worded("{value:5} at {at:4}", value=(value, kind), at=(place, Angle))))
    for text, symbol, value, kind in (
        ("face width touched", "", cam.face_width, Size),
        ("smallest, largest radius", "r", None, Size),
        ("cutter radius", "", inputs.get("cutter_radius"), Size),
        ("area of the plate", "A", cam.area, Area),
        ("mass of the plate", "m", cam.mass, Mass),
        ("moment of inertia", "J", cam.inertia, Inertia),
    ):
        if text.startswith("smallest"):
            least, most = (cam.smallest_radius, Size), (cam.largest_radius, Size)
            rows.append((text, symbol, worded("{least:6}, {most:6}", least=least, most=most)))
        elif value is not None:
            rows.append((text, symbol, _text(value, kind)))
    return rows + deviation


def _table(scene: Program, motion: Motion, same: "dict[str, Any]", start_angle: float) -> Listing:
    """The motion and the shape every 30 degrees."""
    import numpy as np

    cam = profile(scene, points=STEPS, start_angle=start_angle, **same)
    theta = np.arange(STEPS) * (2.0 * pi / STEPS)
    columns = [column.tolist() for column in sample(motion, theta, 2)]
    axes, symbols = (SWINGS, SWING_SYMBOLS) if motion.swing else (LIFTS, SYMBOLS)
    heads = [Axis(symbols[name].rpartition(" ")[2], kind) for name, kind in axes[:3]]
    arrays = {name: column.tolist() for name, column in cam.points.arrays.items()}
    radii = [inf if abs(radius) >= STRAIGHT else radius for radius in arrays["radius_of_curvature"]]
    heads += [Axis("α", Angle), Axis("ρ", Coordinate), Axis("r", Size), Axis("x", Coordinate), Axis("y", Coordinate)]
    columns += [arrays["pressure_angle"], radii, arrays["radius"], arrays["x"], arrays["y"]]
    roller = bool(Geometry(same["follower"], same["rotation"], same["flank"]).roller)
    if roller:
        heads += [Axis("x_p", Coordinate), Axis("y_p", Coordinate)]
        columns += [arrays["pitch_x"], arrays["pitch_y"]]
    rows = tuple(zip(theta.tolist(), *columns, strict=True))
    pitch = ", x_p, y_p centre of the roller" if roller else ""
    title = f"Motion, and points of the cam in its own frame (r from the axis{pitch})"
    return Listing(title, (Axis("θ", Angle), *heads), rows)


def _kind(key: str) -> "Any":
    return Angle if key == "arm_angle" else Coordinate


def _text(value: "Any", kind: "Any") -> str:
    return worded("{value:6}", value=(float(value), kind))
