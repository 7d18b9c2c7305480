"""Further ways beside those of `alternatives/gear/sizes`."""

import math

from dynamics_cli.accuracy.alternatives.gear.sizes import _bevel, _crossed, _worm
from peers.gear.involute import brent_inverse
from peers.solvers import brent

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Inverse = Callable[[float], dict[str, float]]


def bevel_by_brent(
    *, first_teeth: int, second_teeth: int, module: float, shaft_angle: float, kind: str,
    face_width: "float | None" = None, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """The pitch angle from z₁·sin δ₂ = z₂·sin δ₁ with δ₂ = Σ − δ₁, by Brent's method."""

    def apart(one: float) -> float:
        return second_teeth * math.sin(one) - first_teeth * math.sin(shaft_angle - one)

    one = brent(apart, 0.0, min(shaft_angle, 0.5 * math.pi))
    return _bevel((first_teeth, second_teeth), module, (one, shaft_angle - one), kind, face_width, math)


def worm_by_angles(
    *, threads: int, teeth: int, size: "Any", worm: "Any", pressure_angle: float, profile_shift: float,
    friction: float, torque: "float | None" = None, m: "Any" = math, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """η = tan γ/tan(γ + ρ'), η' = tan(γ − ρ')/tan γ with tan ρ' = μ/cos α, as of a screw."""
    out, lead = _worm(threads, teeth, size, worm, profile_shift, m)
    rho = m.atan(friction / m.cos(pressure_angle))
    out |= {
        "efficiency": m.tan(lead) / m.tan(lead + rho),
        "backward_efficiency": m.tan(lead - rho) / m.tan(lead),
        "locking_margin": rho - lead,
    }
    if torque is not None:
        push = 2 * torque / worm.worm_diameter
        radial = push * m.tan(pressure_angle) * m.cos(rho) / m.sin(lead + rho)
        out |= {"worm_axial_force": push / m.tan(lead + rho), "radial_force": radial}
    return out


def crossed_by_brent(*, first: "Any", second: "Any", module: float, pressure_angle: float) -> "dict[str, float]":
    """The same by Brent's method."""
    return _crossed(first, second, module, pressure_angle, brent_inverse)
