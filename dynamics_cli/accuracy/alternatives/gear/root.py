"""Where undercut leaves the involute: the equations of textbooks, whose trivial root and cancellation must be met."""

from math import acos, pi, sin, sqrt, tan

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.single.trochoid import Cutter

MOST_STEPS = 60


def chosen(**given: "Any") -> "Any":
    """The bracketed root of differences from the trochoid's start."""
    from dynamics_cli.gear.single.trochoid import Cutter, root

    return {"form_radius": root(Cutter(**given)).form_radius}


def _apart(cutter: "Cutter", theta: float) -> "tuple[float, float]":
    """Half angles of trochoid less involute at the trochoid's point θ, and its radius; above the base circle only."""
    from dynamics_cli.gear.single.trochoid import trochoid_point

    radius, half = trochoid_point(cutter, theta)
    angle = acos(min(cutter.base_radius / radius, 1.0))
    transverse = cutter.transverse_angle
    space = (0.5 * pi - 2.0 * cutter.shift * tan(cutter.pressure_angle)) / cutter.teeth - (tan(transverse) - transverse)
    return half - space - (tan(angle) - angle), radius


def _without_undercut(cutter: "Cutter") -> "float | None":
    """The end of the straight flank, where it lies on the line of action: r·sin α − h/sin α from the pitch point."""
    margin = cutter.pitch_radius * sin(cutter.transverse_angle) - cutter.form_depth / sin(cutter.transverse_angle)
    return sqrt(cutter.base_radius**2 + margin**2) if margin >= 0.0 else None


def newton(**given: "Any") -> "dict[str, float]":
    """Newton with a divided difference from the middle of the corner, on half angles as textbooks write them."""
    from dynamics_cli.gear.single.trochoid import Cutter

    cutter = Cutter(**given)
    plain = _without_undercut(cutter)
    if plain is not None:
        return {"form_radius": plain}
    theta = 0.5 * (cutter.transverse_angle + 0.5 * pi)
    for _ in range(MOST_STEPS):
        here = _apart(cutter, theta)[0]
        slope = (_apart(cutter, theta + 1e-7)[0] - here) / 1e-7
        step = here / slope
        theta -= step
        if abs(step) <= 1e-14:
            return {"form_radius": _apart(cutter, theta)[1]}
    raise ArithmeticError


def halving(**given: "Any") -> "dict[str, float]":
    """Halving of the textbook's equation between the trochoid's start and the base circle."""
    from dynamics_cli.gear.single.trochoid import Cutter, trochoid_point

    cutter = Cutter(**given)
    plain = _without_undercut(cutter)
    if plain is not None:
        return {"form_radius": plain}
    # inside the base circle there is no involute; the trochoid rises above it at its start and goes below
    low, high = cutter.transverse_angle, 0.5 * pi
    for _ in range(100):
        middle = 0.5 * (low + high)
        inside = trochoid_point(cutter, middle)[0] < cutter.base_radius
        if inside or _apart(cutter, middle)[0] > 0.0:
            high = middle
        else:
            low = middle
    return {"form_radius": trochoid_point(cutter, 0.5 * (low + high))[0]}
