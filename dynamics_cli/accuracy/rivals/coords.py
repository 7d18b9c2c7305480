"""Coordinates: the stable forms, and the textbook's arc functions."""

import math

from dynamics_cli.accuracy.questions import Method, Question

HERE = "dynamics_cli.accuracy.rivals.coords:"
CHOSEN = "dynamics_cli.convert.coords:"
SYSTEMS = ("cartesian", "cylindrical", "spherical")


def textbook_cylindrical(x: float, y: float, z: float) -> "dict[str, float]":
    """R = √(x² + y²), θ = tan⁻¹(y/x), a half turn added left of the axis (Josephs & Huston, section 1.6)."""
    r = math.sqrt(x * x + y * y)
    return {"r": r, "theta": _arc_tangent(x, y), "z": z}


def textbook_spherical(x: float, y: float, z: float) -> "dict[str, float]":
    """Φ = cos⁻¹(z/ρ), which loses half of the digits near the Z-axis."""
    rho = math.sqrt(x * x + y * y + z * z)
    return {"rho": rho, "phi": math.acos(z / rho), "theta": _arc_tangent(x, y)}


def arc_sine_spherical(x: float, y: float, z: float) -> "dict[str, float]":
    """Φ = sin⁻¹(r/ρ), which loses half of the digits near the X–Y plane and cannot tell below from above."""
    rho = math.sqrt(x * x + y * y + z * z)
    phi = math.asin(min(1.0, math.sqrt(x * x + y * y) / rho))
    return {"rho": rho, "phi": phi if z >= 0.0 else math.pi - phi, "theta": _arc_tangent(x, y)}


def _arc_tangent(x: float, y: float) -> float:
    theta = math.atan(y / x)
    return theta if x > 0.0 else theta + math.copysign(math.pi, y)


def _question(source: str, target: str, *rivals: Method) -> Question:
    name = f"{source}_to_{target}"
    chosen = Method("scaled components and atan2", CHOSEN + name, chosen=True, tracked=True, arrays=True)
    return Question("coords", "", f"coords, {source} to {target}", "coords.json", name, chosen, *rivals)


_RIVALS = {
    "cylindrical": (Method("textbook, atan(y/x)", HERE + "textbook_cylindrical"),),
    "spherical": (
        Method("textbook, acos(z/rho)", HERE + "textbook_spherical"),
        Method("asin(r/rho)", HERE + "arc_sine_spherical"),
    ),
}
QUESTIONS = tuple(
    _question(source, target, *(_RIVALS.get(target, ()) if source == "cartesian" else ()))
    for source in SYSTEMS
    for target in SYSTEMS
    if source != target
)
