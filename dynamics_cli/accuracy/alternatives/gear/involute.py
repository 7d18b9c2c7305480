"""The inverse involute and the end of undercut by iteration on residuals, which cancel however they are solved."""

from math import acos, atan, cbrt, cos, pi, sin, sqrt, tan

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.single.trochoid import Cutter

# Dedendum and corner of basic rack A of ISO 53.
DEDENDUM, CORNER = 1.25, 0.38
MOST_STEPS = 100
TINY = 4e-16


def chosen_inverse(value: "Any") -> "dict[str, Any]":
    """Series in ∛(3 inv φ), and in the complement of φ above 60°."""
    from dynamics_cli.numerics.involute import inverse_involute

    return {"phi": inverse_involute(value)}


def chosen_involute(phi: "Any") -> "dict[str, Any]":
    """A series below 0.98 rad."""
    from dynamics_cli.numerics.involute import involute

    return {"value": involute(phi)}


def textbook_involute(phi: float) -> "dict[str, float]":
    """The definition, tan φ − φ: digits go as φ³."""
    return {"value": tan(phi) - phi}


def newton(value: float) -> "dict[str, float]":
    """Newton on tan φ − φ from Laskin's start: it loses 3/φ² units in the last place."""
    phi = 1.441 * cbrt(value) - 0.374 * value
    for _ in range(MOST_STEPS):
        tangent = tan(phi)
        step = (tangent - phi - value) / (tangent * tangent)
        phi -= step
        if abs(step) <= TINY * abs(phi):
            break
    return {"phi": phi}


def chosen_root(**given: "Any") -> "Any":
    """The bracketed root of differences from the trochoid's start."""
    from dynamics_cli.gear.single.trochoid import Cutter, root

    return {"form_radius": root(Cutter(**given)).form_radius}


def _apart(cutter: "Cutter", theta: float) -> "tuple[float, float]":
    """Half angles of trochoid less involute at the trochoid's point θ, and its radius; above the base circle only."""
    from dynamics_cli.gear.single.flanks import trochoid_points

    radius, half, _ = map(float, trochoid_points(cutter, theta))  # type: ignore[arg-type]
    angle = acos(min(cutter.base_radius / radius, 1.0))
    transverse = cutter.transverse_angle
    space = (0.5 * pi - 2.0 * cutter.shift * tan(cutter.pressure_angle)) / cutter.teeth - (tan(transverse) - transverse)
    return half - space - (tan(angle) - angle), radius


def _without_undercut(cutter: "Cutter") -> "float | None":
    """The end of the straight flank, where it lies on the line of action: r·sin α − h/sin α from the pitch point."""
    margin = cutter.pitch_radius * sin(cutter.transverse_angle) - cutter.form_depth / sin(cutter.transverse_angle)
    return sqrt(cutter.base_radius**2 + margin**2) if margin >= 0.0 else None


def root_by_newton(**given: "Any") -> "dict[str, float]":
    """Newton with a divided difference from the middle of the corner, on half angles as textbooks write them."""
    from dynamics_cli.gear.single.trochoid import Cutter

    cutter = Cutter(**given)
    radius = _without_undercut(cutter)
    theta = 0.5 * (cutter.transverse_angle + 0.5 * pi)
    for _ in range(MOST_STEPS):
        if radius is not None:
            return {"form_radius": radius}
        here = _apart(cutter, theta)[0]
        step = here * 1e-7 / (_apart(cutter, theta + 1e-7)[0] - here)
        theta -= step
        if abs(step) <= 1e-14:
            radius = _apart(cutter, theta)[1]
    raise ArithmeticError


def profile(
    *, teeth: int, pitch: "Any", pressure_angle: float, profile_shift: float, internal: bool, helix_angle: float,
    root_radius_factor: float = CORNER, **other: "Any",
) -> "dict[str, float]":  # fmt: skip
    """The form circle where the rack's straight flank ends, undercut or not, as handbooks have it."""
    if internal or "addendum_factor" in other:
        raise ArithmeticError
    transverse = atan(tan(pressure_angle) / cos(helix_angle))
    reference = teeth * pitch.module / cos(helix_angle)
    base = reference * cos(transverse)
    depth = pitch.module * (DEDENDUM - root_radius_factor * (1.0 - sin(pressure_angle)) - profile_shift)
    along = reference * sin(transverse) - 2.0 * depth / sin(transverse)
    return {"base_diameter": base, "form_diameter": sqrt(base * base + along * along)}
