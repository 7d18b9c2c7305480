"""Further ways beside those of `alternatives/coords`."""

import math

from dynamics_cli.accuracy.alternatives.coords import _arc_tangent

TYPE_CHECKING = False


def arc_sine_spherical(x: float, y: float, z: float) -> "dict[str, float]":
    """Φ = sin⁻¹(r/ρ), which loses half of the digits near the X–Y plane and cannot tell below from above."""
    rho = math.sqrt(x * x + y * y + z * z)
    phi = math.asin(min(1.0, math.sqrt(x * x + y * y) / rho))
    return {"rho": rho, "phi": phi if z >= 0.0 else math.pi - phi, "theta": _arc_tangent(x, y)}
