"""Pictures of a cam: its profile with the follower, pressure angle and radius of curvature."""

from cmath import exp
from math import pi

from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.geometry.figures import CIRCLE, Figure, figure, turning_arrow
from dynamics_cli.cam.geometry.followers import Flank, Rotation
from dynamics_cli.cam.geometry.profile import CamProfile, profile
from dynamics_cli.cam.program.pictures import ABOVE, BELOW, extreme_mark, named_program
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.errors import worded
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture, complex_curve
from dynamics_cli.quantities import Angle, Coordinate, Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

TURN = 2.0 * pi
# Fewer points than this look like a polygon.
SMOOTH = 720
# Radii beyond this many times the cam are straight for the eye.
FAR = 4.0
# Where the words of a negative convex radius stand, clear of the curve.
LOWER = (6.0, -24.0)
# Pressure angles below this are rounding.
ROUNDING = 1e-12
CCW = Rotation("counter-clockwise")
INNER = Flank("inner")


def profile_picture(
    result: CamProfile,
    scene: Program,
    program: str = "",
    follower: "Any" = None,
    rotation: Rotation = CCW,
    flank: Flank = INNER,
    start_angle: float = 0.0,
    **inputs: "Any",
) -> Picture:
    """Cam, pitch curve and base circle with the follower at the first angle; pressure angle; radius of curvature.

    `follower`: the follower and where it stands; `rotation`: which way the cam turns; `flank`: which surface;
    `start_angle`: angle by which the cam's drawing is turned on [rad]. Returns three panels.
    """
    del result
    cam = profile(
        scene, program=program, follower=follower, rotation=rotation, flank=flank, start_angle=start_angle,
        cutter_radius=inputs.get("cutter_radius"), points=SMOOTH,
    )  # fmt: skip
    geometry = Geometry(follower, rotation, flank)
    title = _title("Cam for {follower}, base circle radius {base}{pair}", follower, scene, program)
    return _picture(title, cam, geometry, motion_of(scene, program), start_angle, inputs.get("cutter_radius"))


def check_picture(
    result: "Any",
    scene: Program,
    program: str = "",
    follower: "Any" = None,
    rotation: Rotation = CCW,
    flank: Flank = INNER,
    rise_limit: float = pi / 6.0,
    return_limit: float = pi / 6.0,
    least_radius: float | None = None,
    **inputs: "Any",
) -> Picture:
    """The same with the limits of `cam check`, whose parameters these are."""
    del inputs
    cam = profile(scene, program=program, follower=follower, rotation=rotation, flank=flank, points=SMOOTH)
    geometry = Geometry(follower, rotation, flank)
    verdict = "within all limits" if getattr(result, "fits", True) else f"exceeded: {result.binding}"
    title = _title("Cam for {follower}, base circle radius {base}{pair}\n" + verdict, follower, scene, program)
    limits = (rise_limit, -return_limit)
    return _picture(title, cam, geometry, motion_of(scene, program), limits=limits, least_radius=least_radius)


def size_picture(result: "Any", scene: Program, program: str = "", follower: "Any" = None, **inputs: "Any") -> Picture:
    """The cam that `cam size` found, of a pair the first, with the limits that it keeps."""
    kind = getattr(followers, type(follower).__name__.removeprefix("Conjugate"))
    sizes = {}
    for name in kind.fields:
        value = getattr(result, name, None)
        sizes[name] = getattr(follower, name) if value is None else value
    return check_picture(None, scene, program, kind(**sizes), **inputs)


def _title(template: str, follower: "Any", scene: Program, program: str) -> str:
    name = type(follower).tag[1].replace("-", " ")
    return worded(
        f"{template}\n{{program}}",
        follower=f"{'an' if name[0] == 'o' else 'a'} {name}" + ("" if "roller" in name else " follower"),
        base=(follower.base_radius, Size), pair=" of the first cam" if isinstance(follower, followers.MATES) else "",
        program=named_program(scene, program),
    )  # fmt: skip


def _picture(
    title: str, cam: CamProfile, geometry: Geometry, motion: "Any", start_angle: float = 0.0,
    cutter: float | None = None, limits: "tuple[float, ...]" = (), least_radius: float | None = None,
) -> Picture:  # fmt: skip
    """Cam with its follower, pressure angle and radius of curvature, with limits as lines."""
    arrays = {name: column.tolist() for name, column in cam.points.arrays.items()}
    face = None if cam.face_low is None or cam.face_high is None else (cam.face_low, cam.face_high)
    drawing = figure(geometry, float(motion.at(0.0, 0)[0]), cam.largest_radius, face)
    shape = Panel(
        Axis("x", Coordinate),
        Axis("y", Coordinate),
        tuple(_items(arrays, geometry, drawing, exp(1j * start_angle), cutter)),
        f"at cam angle 0, turning {'clockwise' if geometry.turn < 0.0 else 'counter-clockwise'}",
        equal=True,
    )
    angle_axis = Axis("cam angle θ", Angle, ends=(0.0, TURN), step=pi / 6.0)
    angle = [*arrays["cam_angle"], TURN]
    # a flat face square to its way has no pressure angle but rounding
    if max(map(abs, arrays["pressure_angle"])) < ROUNDING and face is not None:
        middle = _along_face(_places(arrays, drawing.pivot), geometry, angle_axis, angle, face)
    else:
        middle = _pressure(cam, arrays, angle_axis, angle, limits)
    return Picture((shape, middle, _curvature(cam, arrays, angle_axis, angle, least_radius)), title)


def _places(arrays: "dict[str, list[float]]", pivot: "complex | None") -> "list[float]":
    """Where a flat face is touched: to the right of its slide, or of one through its pivot away from that."""
    if pivot is None:
        return arrays["contact_x"]
    return [abs(contact - pivot) for contact in map(complex, arrays["contact_x"], arrays["contact_y"])]


def _along_face(
    places: "list[float]", geometry: Geometry, way: Axis, angle: "list[float]", face: "tuple[float, float]"
) -> Panel:
    """Where a flat face is touched."""
    side = "away from the pivot" if geometry.oscillating else "to the right of the slide"
    low, high = (angle[places.index(pick(places))] for pick in (min, max))
    return Panel(
        way,
        Axis("contact on the face", Coordinate),
        (
            Curve(angle, _closed(places), role=0),
            *extreme_mark(high, face[1], Coordinate, ABOVE),
            *extreme_mark(low, face[0], Coordinate, BELOW),
        ),
        f"contact {side}; the pressure angle is zero",
    )


def _pressure(
    cam: CamProfile, arrays: "dict[str, list[float]]", way: Axis, angle: "list[float]", limits: "tuple[float, ...]"
) -> Panel:
    """The pressure angle with its limits."""
    high, low = cam.largest_pressure_angle, cam.least_pressure_angle
    return Panel(
        way,
        Axis("pressure angle α", Angle),
        (
            Curve(angle, _closed(arrays["pressure_angle"]), role=0),
            *extreme_mark(cam.largest_pressure_angle_at, high, Angle, ABOVE),
            # no second mark on top of the first where the pressure angle is constant
            *(() if low == high else extreme_mark(cam.least_pressure_angle_at, low, Angle, BELOW)),
            *([Band(limit, limit, vertical=False) for limit in limits] or [Band(0.0, 0.0, vertical=False)]),
        ),
        "pressure angle; its limits dash-dotted" if limits else "",
    )


def _items(
    arrays: "dict[str, list[float]]", geometry: Geometry, drawing: Figure, rotation: complex, cutter: "float | None"
) -> "list[Any]":
    """Contents of the first panel, in the cam's frame at its first angle."""
    items: list[Any] = [Curve(_closed(arrays["x"]), _closed(arrays["y"]), _flank(geometry), role=0)]
    if geometry.roller:
        items.append(Curve(_closed(arrays["pitch_x"]), _closed(arrays["pitch_y"]), "pitch curve", "dashed", 5))
    if cutter:
        items.append(Curve(_closed(arrays["cutter_x"]), _closed(arrays["cutter_y"]), "cutter path", "dotted", 3))
    if drawing.base:
        items.append(complex_curve((drawing.base * step for step in CIRCLE), "base circle", "thin", 6))
    items += [
        complex_curve((rotation * point for point in drawing.shape), drawing.name, "solid", 1),
        complex_curve((rotation * point for point in drawing.holder), "", "thin", 1),
        complex_curve(turning_arrow(geometry.turn, 0.3 * (drawing.base or _size(arrays))), "", "thin", 6),
        Mark(0.0, 0.0, ""),
        Mark(arrays["x"][0], arrays["y"][0], ""),
    ]
    if drawing.pivot is not None:
        pivot = rotation * drawing.pivot
        items.append(Mark(pivot.real, pivot.imag, "pivot"))
    return items


def _curvature(
    cam: CamProfile, arrays: "dict[str, list[float]]", way: Axis, angle: "list[float]", least_radius: float | None
) -> Panel:
    """The radius of curvature, broken where the curve is nearly straight."""
    reach = FAR * cam.largest_radius
    radii = [radius if abs(radius) <= reach else float("nan") for radius in _closed(arrays["radius_of_curvature"])]
    convex, hollow = cam.least_convex_radius, cam.least_concave_radius
    marks: list[Mark] = []
    if convex is not None and abs(convex) <= reach:
        marks += extreme_mark(cam.least_convex_radius_at, convex, Coordinate, BELOW if convex > 0.0 else LOWER)
    if hollow is not None and cam.least_concave_radius_at is not None and hollow <= reach:
        words = convex is None or convex > 0.0
        place = cam.least_concave_radius_at
        marks += extreme_mark(place, -hollow, Coordinate, ABOVE) if words else (Mark(place, -hollow),)
    limit = [Band(least_radius, least_radius, "limit", vertical=False)] if least_radius else []
    return Panel(
        way,
        Axis("radius of curvature ρ", Coordinate),
        (Curve(angle, radii, role=0), *marks, *limit, Band(0.0, 0.0, vertical=False)),
        "radius of curvature: convex above zero, broken where nearly straight",
    )


def _flank(geometry: Geometry) -> str:
    return "cam" if geometry.side > 0.0 else "outer flank"


def _size(arrays: "dict[str, list[float]]") -> float:
    return max(arrays["radius"])


def _closed(values: "list[float]") -> "list[float]":
    return [*values, values[0]]
