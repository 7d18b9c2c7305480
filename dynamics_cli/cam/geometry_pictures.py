"""Pictures of a cam: its profile with the follower, pressure angle and curvature; and one turn, animated."""

from math import cos, degrees, pi, sin

from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.profile import CamProfile

CIRCLE = tuple(2.0 * pi * k / 90 for k in range(91))
# Fewer points than this look like a polygon.
SMOOTH = 360
# Radii beyond this many times the cam are straight for the eye.
FAR = 8.0


def profile_picture(
    result: "CamProfile", scene: "Any" = None, *, program: str = "", follower: "Any" = None, **given: "Any"
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
        The follower, for its base circle and roller.
    **given
        The task's other parameters.

    Returns
    -------
    Picture
        Three panels.
    """
    given.pop("points", None)
    table = result.points
    if scene is not None and len(table) < SMOOTH:
        from dynamics_cli.cam.profile import profile

        table = profile(scene, program=program, follower=follower, points=SMOOTH, **given).points
    arrays = {name: _closed(column.tolist()) for name, column in table.arrays.items()}
    items: list[Any] = [Curve(arrays["x"], arrays["y"], "cam", role=0)]
    roller = getattr(follower, "roller_radius", 0.0)
    if roller:
        items.append(Curve(arrays["pitch_x"], arrays["pitch_y"], "pitch curve", style="dashed", role=1))
        cx, cy = arrays["pitch_x"][0], arrays["pitch_y"][0]
        items.append(_circle(cx, cy, roller, "roller", 2))
    elif result.face_width is not None and result.arm_start_angle is None:
        items.append(_face(arrays, result))
    base = getattr(follower, "base_radius", 0.0)
    if base:
        items.append(_circle(0.0, 0.0, base, "base circle", 3))
    items += [Mark(0.0, 0.0, ""), Mark(arrays["x"][0], arrays["y"][0], "0°")]
    shape = Panel(Axis("x", Coordinate), Axis("y", Coordinate), tuple(items), "Cam", equal=True)
    angle = [*arrays["cam_angle"][:-1], arrays["cam_angle"][0] + 2.0 * pi]
    pressure = Panel(
        Axis("cam angle", Angle),
        Axis("pressure angle", Angle),
        (
            Curve(angle, arrays["pressure_angle"], role=0),
            Mark(result.largest_pressure_angle_at, result.largest_pressure_angle, "largest"),
            *_least(result),
            Band(0.0, 0.0, vertical=False),
        ),
        "Pressure angle",
    )
    reach = FAR * result.largest_radius
    radii = [radius if abs(radius) <= reach else float("nan") for radius in arrays["radius_of_curvature"]]
    marks: tuple[Mark, ...] = ()
    if result.least_convex_radius is not None and result.least_convex_radius_at is not None:
        marks = (Mark(result.least_convex_radius_at, result.least_convex_radius, "least convex"),)
    bend = Panel(
        Axis("cam angle", Angle),
        Axis("radius of curvature", Coordinate),
        (Curve(angle, radii, role=0), *marks, Band(0.0, 0.0, vertical=False)),
        "Radius of curvature of the cam",
    )
    return Picture((shape, pressure, bend), "Cam profile")


def _least(result: "CamProfile") -> "tuple[Mark, ...]":
    """No second mark on top of the first where the pressure angle is constant."""
    if result.least_pressure_angle == result.largest_pressure_angle:
        return ()
    return (Mark(result.least_pressure_angle_at, result.least_pressure_angle, "least"),)


def _face(arrays: "dict[str, list[float]]", result: "CamProfile") -> Curve:
    """The flat face at the first angle, in the cam's frame, as wide as the contact wanders."""
    at = complex(arrays["x"][0], arrays["y"][0])
    touch = complex(arrays["contact_x"][0], arrays["contact_y"][0])
    turn = at / touch if touch else 1.0 + 0.0j
    low, high = result.face_low or 0.0, result.face_high or 0.0
    ends = [complex(along, touch.imag) * turn for along in (low, high)]
    return Curve([end.real for end in ends], [end.imag for end in ends], "face", role=2)


def _closed(values: "list[float]") -> "list[float]":
    return [*values, values[0]]


def _circle(x: float, y: float, radius: float, label: str, role: int) -> Curve:
    return Curve([x + radius * cos(t) for t in CIRCLE], [y + radius * sin(t) for t in CIRCLE], label, "thin", role)


def animation(result: "CamProfile") -> str:
    """One turn of the cam with its follower, as a page that moves by itself (SVG with SMIL, no script).

    Parameters
    ----------
    result : CamProfile
        The profile; its table's points are the frames.

    Returns
    -------
    str
        An HTML page.
    """
    arrays = {name: column.tolist() for name, column in result.points.arrays.items()}
    points = [complex(x, y) for x, y in zip(arrays["x"], arrays["y"], strict=True)]
    touch = [complex(x, y) for x, y in zip(arrays["contact_x"], arrays["contact_y"], strict=True)]
    pitch = [complex(x, y) for x, y in zip(arrays["pitch_x"], arrays["pitch_y"], strict=True)]
    # what turns the cam's frame into the fixed one, at every angle of the table
    turns = [t / p if p else 1.0 + 0.0j for p, t in zip(points, touch, strict=True)]
    centres = [p * turn for p, turn in zip(pitch, turns, strict=True)]
    roller = max(abs(p - q) for p, q in zip(pitch, points, strict=True))
    reach = 1e3 * (max(map(abs, pitch)) + roller) * 1.1
    outline = " ".join(f"{1e3 * p.real:.4f},{-1e3 * p.imag:.4f}" for p in points)
    clockwise = (turns[1] / turns[0]).imag < 0.0 if abs(turns[0]) else False
    first = -degrees(_phase(turns[0]))
    last = first + (360.0 if clockwise else -360.0)
    loop = 'dur="6s" repeatCount="indefinite"'
    centres.append(centres[0])
    path = ";".join(f"{1e3 * c.real:.4f} {-1e3 * c.imag:.4f}" for c in centres)
    if roller > 0.0:
        shape = f'<circle r="{1e3 * roller:.4f}" class="f"/>'
    elif result.face_width is not None and result.arm_start_angle is None:
        shape = f'<path d="M {-1.2 * reach:.3f} 0 H {1.2 * reach:.3f}" class="f"/>'
        path = ";".join(f"0 {-1e3 * c.imag:.4f}" for c in centres)
    elif result.arm_start_angle is not None:
        shape = _rocker(points, turns, reach, loop)
    else:
        mark = 0.02 * reach
        shape = f'<path d="M 0 0 L {-mark:.3f} {-3 * mark:.3f} H {mark:.3f} Z" class="f"/>'
    return (
        "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><title>One turn of a cam</title></head><body>\n"
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{-reach:.3f} {-reach:.3f} {2 * reach:.3f} {2 * reach:.3f}" '
        'style="max-width:40em;display:block;margin:auto">\n'
        f"<style>.c{{fill:#9ecae1;stroke:#08519c;stroke-width:{0.006 * reach:.4f}}}"
        f".f{{fill:none;stroke:#a63603;stroke-width:{0.008 * reach:.4f}}}</style>\n"
        f'<g><polygon class="c" points="{outline}"/><circle r="{0.03 * reach:.3f}" fill="#08519c"/>'
        f'<animateTransform attributeName="transform" type="rotate" from="{first:.6f}" to="{last:.6f}" {loop}/></g>\n'
        f'<g>{shape}<animateTransform attributeName="transform" type="translate" values="{path}" {loop}/></g>\n'
        "</svg>\n</body></html>\n"
    )


def _rocker(points: "list[complex]", turns: "list[complex]", reach: float, loop: str) -> str:
    """The face of an arm, as a line that keeps to the cam's tangent where they touch."""
    ways = [(points[(k + 1) % len(points)] - points[k - 1]) * turn for k, turn in enumerate(turns)]
    first = _phase(ways[0])
    angles = [first + _phase(way / ways[0]) if way and ways[0] else first for way in [*ways, ways[0]]]
    values = ";".join(f"{-degrees(angle):.4f}" for angle in angles)
    return (
        f'<path d="M {-0.6 * reach:.3f} 0 H {0.6 * reach:.3f}" class="f">'
        f'<animateTransform attributeName="transform" type="rotate" values="{values}" {loop}/></path>'
    )


def _phase(value: complex) -> float:
    from cmath import phase

    return phase(value)
