"""Coordinates: the stable forms, beside the textbook's arc functions."""

import math

from dynamics_cli.accuracy.questions import Method, Question

HERE = "dynamics_cli.accuracy.alternatives.coords:"
CHOSEN = "dynamics_cli.convert.coords:"


def textbook_cylindrical(x: float, y: float, z: float) -> "dict[str, float]":
    """R = √(x² + y²), θ = tan⁻¹(y/x), a half turn added left of the axis (Josephs & Huston, section 1.6)."""
    return {"r": math.sqrt(x * x + y * y), "theta": _arc_tangent(x, y), "z": z}


def textbook_spherical(x: float, y: float, z: float) -> "dict[str, float]":
    """Φ = cos⁻¹(z/ρ), which loses half of the digits near the Z-axis."""
    rho = math.sqrt(x * x + y * y + z * z)
    return {"rho": rho, "phi": math.acos(z / rho), "theta": _arc_tangent(x, y)}


def spherical_from_cylindrical(r: float, theta: float, z: float) -> "dict[str, float]":
    """Φ = cos⁻¹(z/ρ), θ as given."""
    rho = math.sqrt(r * r + z * z)
    return {"rho": rho, "phi": math.acos(z / rho), "theta": theta}


def cylindrical_from_spherical(rho: float, phi: float, theta: float) -> "dict[str, float]":
    """R = ρ·sin φ, z = ρ·cos φ, θ as given."""
    return {"r": rho * math.sin(phi), "theta": theta, "z": rho * math.cos(phi)}


def _arc_tangent(x: float, y: float) -> float:
    theta = math.atan(y / x)
    if x > 0.0:
        return theta
    return theta + math.pi if y >= 0.0 else theta - math.pi


# Source, target, what the textbook does, and its function.
ROWS = (
    ("cartesian", "cylindrical", "atan(y/x)", "textbook_cylindrical"),
    ("cartesian", "spherical", "acos(z/rho)", "textbook_spherical"),
    ("cylindrical", "cartesian", "", ""),
    ("cylindrical", "spherical", "acos(z/rho)", "spherical_from_cylindrical"),
    ("spherical", "cartesian", "", ""),
    ("spherical", "cylindrical", "rho sin and rho cos", "cylindrical_from_spherical"),
)
QUESTIONS = tuple(
    Question(
        "coords", "", f"coords, {source} to {target}", "coords.json", f"{source}_to_{target}",
        Method("scaled components and atan2", f"{CHOSEN}{source}_to_{target}", chosen=True, tracked=True),
        *((Method(f"textbook, {words}", HERE + textbook),) if textbook else ()),
    )
    for source, target, words, textbook in ROWS
)  # fmt: skip
