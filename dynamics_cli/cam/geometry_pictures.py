"""Pictures of a cam: its profile with the follower, pressure angle and radius of curvature."""

from cmath import exp
from math import pi

from dynamics_cli.cam.contact import Geometry
from dynamics_cli.cam.figures import CIRCLE, Figure, figure, turning_arrow
from dynamics_cli.cam.followers import Flank, Rotation
from dynamics_cli.cam.profile import CamProfile, profile
from dynamics_cli.cam.program import Program, motion_of
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any

TURN = 2.0 * pi
# Fewer points than this look like a polygon.
SMOOTH = 720
# Radii beyond this many times the cam are straight for the eye.
FAR = 4.0
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
    **given: "Any",
) -> Picture:
    """Cam, pitch curve and base circle with the follower at the first angle; pressure angle; radius of curvature.

    Parameters
    ----------
    result : CamProfile
        The profile.
    scene : Program
        The program from a file.
    program : str
        The program in one line.
    follower : Follower
        The follower and where it stands.
    rotation : Rotation
        Which way the cam turns.
    flank : Flank
        Which surface.
    start_angle : float
        Angle by which the cam's drawing is turned on [rad].
    **given
        The task's other parameters.

    Returns
    -------
    Picture
        Three panels.
    """
    cutter = given.get("cutter_radius")
    table = profile(
        scene, program=program, follower=follower, rotation=rotation, flank=flank, start_angle=start_angle,
        cutter_radius=cutter, points=SMOOTH,
    ).points  # fmt: skip
    arrays = {name: column.tolist() for name, column in table.arrays.items()}
    geometry = Geometry(follower, rotation, flank)
    face = None if result.face_low is None or result.face_high is None else (result.face_low, result.face_high)
    lift = float(motion_of(scene, program).at(0.0, 0)[0])
    shown = figure(geometry, lift, result.largest_radius, face)
    shape = Panel(
        Axis("x", Coordinate),
        Axis("y", Coordinate),
        tuple(_items(arrays, geometry, shown, exp(1j * start_angle), cutter)),
        f"Cam and follower at cam angle 0, turning {rotation}",
        equal=True,
    )
    way = Axis("cam angle", Angle, ends=(0.0, TURN), step=pi / 6.0)
    angle = [*arrays["cam_angle"], TURN]
    # a flat face square to its way has none but rounding, which is nothing to enlarge
    none = max(map(abs, arrays["pressure_angle"])) < ROUNDING
    pressure = Panel(
        way,
        Axis("pressure angle", Angle, ends=(-pi / 18.0, pi / 18.0)) if none else Axis("pressure angle", Angle),
        (
            Curve(angle, _closed(arrays["pressure_angle"]), role=0),
            Mark(result.largest_pressure_angle_at, result.largest_pressure_angle, "largest"),
            *_least(result),
            Band(0.0, 0.0, vertical=False),
        ),
        "Pressure angle",
    )
    return Picture((shape, pressure, _curvature(result, arrays, way, angle)), "Cam profile")


def _items(
    arrays: "dict[str, list[float]]", geometry: Geometry, shown: Figure, on: complex, cutter: "float | None"
) -> "list[Any]":
    """What the first panel shows, in the cam's frame at its first angle."""
    items: list[Any] = [Curve(_closed(arrays["x"]), _closed(arrays["y"]), _flank(geometry), role=0)]
    if geometry.roller:
        items.append(Curve(_closed(arrays["pitch_x"]), _closed(arrays["pitch_y"]), "pitch curve", "dashed", 5))
    if cutter:
        items.append(Curve(_closed(arrays["cutter_x"]), _closed(arrays["cutter_y"]), "cutter path", "dotted", 3))
    if shown.base:
        items.append(_line((shown.base * step for step in CIRCLE), "base circle", "thin", 6))
    items += [
        _line((on * point for point in shown.shape), shown.name, "solid", 1),
        _line((on * point for point in shown.holder), shown.holder_name, "thin", 1),
        _line(turning_arrow(geometry.turn, 0.3 * (shown.base or _size(arrays))), "", "thin", 6),
        Mark(0.0, 0.0, ""),
        Mark(arrays["x"][0], arrays["y"][0], ""),
    ]
    if shown.pivot is not None:
        pivot = on * shown.pivot
        items.append(Mark(pivot.real, pivot.imag, "pivot"))
    return items


def _curvature(result: CamProfile, arrays: "dict[str, list[float]]", way: Axis, angle: "list[float]") -> Panel:
    """The radius of curvature, broken where the curve is all but straight."""
    reach = FAR * result.largest_radius
    radii = [radius if abs(radius) <= reach else float("nan") for radius in _closed(arrays["radius_of_curvature"])]
    marks = [
        Mark(at, sign * radius, label)
        for at, radius, sign, label in (
            (result.least_convex_radius_at, result.least_convex_radius, 1.0, "least convex"),
            (result.least_concave_radius_at, result.least_concave_radius, -1.0, "least concave"),
        )
        if at is not None and radius is not None and abs(radius) <= reach
    ]
    return Panel(
        way,
        Axis("radius of curvature", Coordinate),
        (Curve(angle, radii, role=0), *marks, Band(0.0, 0.0, vertical=False)),
        "Radius of curvature of the cam: convex above zero, broken where nearly straight",
    )


def _flank(geometry: Geometry) -> str:
    return "cam" if geometry.side > 0.0 else "outer flank"


def _least(result: CamProfile) -> "tuple[Mark, ...]":
    """No second mark on top of the first where the pressure angle is constant."""
    if result.least_pressure_angle == result.largest_pressure_angle:
        return ()
    return (Mark(result.least_pressure_angle_at, result.least_pressure_angle, "least"),)


def _line(points: "Iterable[complex]", label: str, style: "Any", role: int) -> Curve:
    points = list(points)
    return Curve([point.real for point in points], [point.imag for point in points], label, style, role)


def _size(arrays: "dict[str, list[float]]") -> float:
    return max(arrays["radius"])


def _closed(values: "list[float]") -> "list[float]":
    return [*values, values[0]]
