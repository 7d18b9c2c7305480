"""Coordinates: the stable forms, the textbook's arc functions, the library's, and numbers of 32 bits."""

import math

from dynamics_cli.accuracy.questions import Method, Question

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

HERE = "dynamics_cli.accuracy.alternatives.coords:"
CHOSEN = "dynamics_cli.convert.coords:"


def textbook_cylindrical(x: float, y: float, z: float, m: "Any" = math) -> "dict[str, Any]":
    """R = √(x² + y²), θ = tan⁻¹(y/x), a half turn added left of the axis (Josephs & Huston, section 1.6)."""
    return {"r": m.sqrt(x * x + y * y), "theta": _arc_tangent(x, y, m), "z": z}


def textbook_spherical(x: float, y: float, z: float, m: "Any" = math) -> "dict[str, Any]":
    """Φ = cos⁻¹(z/ρ), which loses half of the digits near the Z-axis."""
    rho = m.sqrt(x * x + y * y + z * z)
    return {"rho": rho, "phi": m.acos(z / rho), "theta": _arc_tangent(x, y, m)}


def library_cylindrical(x: float, y: float, z: float) -> "dict[str, float]":
    """The library's hypot and atan2."""
    return {"r": math.hypot(x, y), "theta": math.atan2(y, x), "z": z}


def library_spherical(x: float, y: float, z: float) -> "dict[str, float]":
    """The library's hypot and atan2, twice."""
    return {"rho": math.hypot(x, y, z), "phi": math.atan2(math.hypot(x, y), z), "theta": math.atan2(y, x)}


def cartesian_from_cylindrical(r: float, theta: float, z: float, m: "Any" = math) -> "dict[str, Any]":
    """X = r·cos θ, y = r·sin θ."""
    return {"x": r * m.cos(theta), "y": r * m.sin(theta), "z": z}


def spherical_from_cylindrical(r: float, theta: float, z: float, m: "Any" = math) -> "dict[str, Any]":
    """Φ = cos⁻¹(z/ρ), θ as given."""
    rho = m.sqrt(r * r + z * z)
    return {"rho": rho, "phi": m.acos(z / rho), "theta": theta}


def cartesian_from_spherical(rho: float, phi: float, theta: float, m: "Any" = math) -> "dict[str, Any]":
    """X = ρ·sin φ·cos θ, y = ρ·sin φ·sin θ, z = ρ·cos φ."""
    r = rho * m.sin(phi)
    return {"x": r * m.cos(theta), "y": r * m.sin(theta), "z": rho * m.cos(phi)}


def cylindrical_from_spherical(rho: float, phi: float, theta: float, m: "Any" = math) -> "dict[str, Any]":
    """R = ρ·sin φ, z = ρ·cos φ, θ as given."""
    return {"r": rho * m.sin(phi), "theta": theta, "z": rho * m.cos(phi)}


def _arc_tangent(x: float, y: float, m: "Any") -> float:
    theta = m.atan(y / x)
    if x > 0.0:
        return theta  # type: ignore[no-any-return]
    return theta + math.pi if y >= 0.0 else theta - math.pi  # type: ignore[no-any-return]


def _question(source: str, target: str, words: str, textbook: str, *others: Method) -> Question:
    name = f"{source}_to_{target}"
    own = Method("scaled components and atan2", CHOSEN + name, chosen=True, tracked=True, arrays=True)
    methods = (own, Method(f"textbook, {words}", HERE + textbook), *others)
    return Question("coords", "", f"coords, {source} to {target}", "coords.json", name, *methods)


QUESTIONS = (
    _question(
        "cartesian", "cylindrical", "atan(y/x)", "textbook_cylindrical",
        Method("library, hypot and atan2", HERE + "library_cylindrical"),
    ),
    _question(
        "cartesian", "spherical", "acos(z/rho)", "textbook_spherical",
        Method("library, hypot and atan2", HERE + "library_spherical"),
    ),
    _question("cylindrical", "cartesian", "r cos and r sin", "cartesian_from_cylindrical"),
    _question("cylindrical", "spherical", "acos(z/rho)", "spherical_from_cylindrical"),
    _question("spherical", "cartesian", "products of sines", "cartesian_from_spherical"),
    _question("spherical", "cylindrical", "rho sin and rho cos", "cylindrical_from_spherical"),
)  # fmt: skip
