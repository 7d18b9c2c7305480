"""One turn of a cam with its follower as an animated SVG (SMIL, no script); a still print shows the start.

Cam and follower are rigid: the cam only turns, a slide only shifts and an arm only swings, so that each is drawn once.
"""

from math import degrees, pi

from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.geometry.figures import figure, turning_arrow
from dynamics_cli.cam.geometry.followers import Flank, Rotation
from dynamics_cli.cam.geometry.profile import CamProfile, profile
from dynamics_cli.cam.program.reading import Program, motion_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any

# Points of the outline, positions of the follower in a turn, and the duration of a turn.
STEPS = 720
FRAMES = 360
SECONDS = 6
MILLIMETRES = 1e3
CCW = Rotation("counter-clockwise")
INNER = Flank("inner")


def _moves(geometry: Geometry, drawing: "Any", lifts: "list[float]") -> "tuple[str, str, list[str]]":
    """The follower's motion in SVG terms: type of transform, static position, and steps."""
    if geometry.oscillating:
        pivot = _point(drawing.pivot or 0j)
        moves = [f"{degrees(lift):.4f} {pivot}" for lift in lifts]
        kind, still = "rotate", f"rotate({moves[0].replace(' ', ',')})"
    else:
        moves = [f"0,{-MILLIMETRES * lift:.4f}" for lift in lifts]
        kind, still = "translate", f"translate({moves[0]})"
    return kind, still, moves


def animation(
    result: CamProfile,
    scene: Program,
    program: str = "",
    follower: "Any" = None,
    rotation: Rotation = CCW,
    flank: Flank = INNER,
    **inputs: "Any",
) -> str:
    """One turn of the cam with its follower, in millimetres and in true size.

    `follower`: the follower and where it stands; `rotation`: which way the cam turns; `flank`: the working surface.
    Returns the file.
    """
    del inputs
    geometry, motion = Geometry(follower, rotation, flank), motion_of(scene, program)
    table = profile(scene, program=program, follower=follower, rotation=rotation, flank=flank, points=STEPS).points
    outline = [complex(x, y) for x, y in zip(table.arrays["x"].tolist(), table.arrays["y"].tolist(), strict=True)]
    size = max(map(abs, outline))
    lifts = [float(motion.at(2.0 * pi * (k % FRAMES) / FRAMES, 0)[0]) for k in range(FRAMES + 1)]
    face = None if result.face_low is None or result.face_high is None else (result.face_low, result.face_high)
    drawing = figure(geometry, 0.0, size, face)
    most = max(abs(lift) for lift in lifts) if not geometry.oscillating else 0.0
    reach = 1.05 * max(size, *(abs(point) + most for point in (*drawing.shape, *drawing.holder)))
    line = 0.006 * reach * MILLIMETRES
    loop = f'dur="{SECONDS}s" repeatCount="indefinite"'
    kind, still, moves = _moves(geometry, drawing, lifts)
    body = f"M {_points(outline)} Z"
    if geometry.side < 0.0:
        wall = [complex(x, y) * reach for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        body = f"M {_points(wall)} Z {body}"
    start = [0j, outline[0]] if geometry.side > 0.0 else [outline[0], 1.08 * outline[0]]
    arrow = turning_arrow(geometry.turn, 0.3 * (drawing.base or size))
    parts = [
        f'<path d="{body}" fill="#d6e6f2" fill-rule="evenodd" stroke="#0072B2" stroke-width="{line:.4f}"/>',
        f'<path d="M {_points(start)}" stroke="#0072B2" stroke-width="{0.5 * line:.4f}"/>',
        f'<path d="M {_points(arrow)}" fill="none" stroke="#000000" stroke-width="{0.6 * line:.4f}"/>',
    ]
    circle = (
        f'<circle r="{MILLIMETRES * drawing.base:.4f}" fill="none" stroke="#555555" stroke-width="{0.5 * line:.4f}" '
        f'stroke-dasharray="{3 * line:.4f}"/>\n'
        if drawing.base
        else ""
    )
    support = f'<circle {_centre(drawing.pivot)} r="{1.5 * line:.4f}"/>\n' if drawing.pivot is not None else ""
    page = 2.0 * reach * MILLIMETRES
    corner = f"{-reach * MILLIMETRES:.4f}"
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{page:.4f}mm" height="{page:.4f}mm" '
        f'viewBox="{corner} {corner} {page:.4f} {page:.4f}">\n'
        "<title>One turn of a cam</title>\n"
        f"<desc>unit: mm; the cam turns {rotation}; the y axis points down, as in every SVG</desc>\n"
        f'<g transform="rotate(0)" fill="none">\n'
        f'<animateTransform attributeName="transform" type="rotate" from="0" to="{-360 * geometry.turn:.0f}" {loop}/>\n'
        + "\n".join(parts)
        + f"\n</g>\n{circle}"
        f'<circle r="{1.5 * line:.4f}"/>\n'
        f'<g transform="{still}" fill="none" stroke="#D55E00" stroke-width="{1.3 * line:.4f}" stroke-linecap="round">\n'
        f'<animateTransform attributeName="transform" type="{kind}" values="{";".join(moves)}" {loop}/>\n'
        f'<path d="M {_points(drawing.shape)}"><title>{drawing.name}</title></path>\n'
        f'<path d="M {_points(drawing.holder)}"><title>{drawing.holder_name}</title></path>\n'
        f"</g>\n{support}</svg>\n"
    )


def _point(point: complex) -> str:
    return f"{MILLIMETRES * point.real + 0.0:.4f} {-MILLIMETRES * point.imag + 0.0:.4f}"


def _points(points: "Iterable[complex]") -> str:
    return " L ".join(map(_point, points))


def _centre(point: complex) -> str:
    x, y = _point(point).split()
    return f'cx="{x}" cy="{y}"'
