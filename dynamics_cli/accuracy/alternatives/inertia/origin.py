"""Mass properties from integrals about a shape's own origin, with parallel axes at the end, as textbooks teach it.

I = ∫ (r²·1 − r·rᵀ) dm − m·(c²·1 − c·cᵀ): digits go as the mass centre lies far off or a wall becomes thin.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# How large a piece is (negative: cut out), its centroid, and its mean xx, yy, zz, xy, yz, zx about the origin.
Piece = tuple[float, tuple[float, float, float], tuple[float, float, float, float, float, float]]


def properties(pieces: "Sequence[Piece]", mass: float, measure: str) -> "dict[str, float]":
    """Measure, mass centre, tensor and principal moments (LAPACK) of pieces of one density."""
    import numpy as np

    sizes = np.array([piece[0] for piece in pieces])
    whole = float(sizes.sum())
    centre = sizes @ np.array([piece[1] for piece in pieces]) / whole
    xx, yy, zz, xy, yz, zx = (sizes @ np.array([piece[2] for piece in pieces]) / whole).tolist()
    second = np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]) - np.outer(centre, centre)
    tensor = mass * (np.trace(second) * np.eye(3) - second)
    results = {measure: whole, "mass": mass} | {f"centroid[{k}]": float(x) for k, x in enumerate(centre)}
    results |= {f"moments.{name}": float(tensor[k, k]) for k, name in enumerate(("xx", "yy", "zz"))}
    pairs = (("xy", 0, 1), ("yz", 1, 2), ("zx", 2, 0))
    results |= {f"products.{name}": float(tensor[i, j]) for name, i, j in pairs}
    moments = np.linalg.eigvalsh(tensor).tolist()
    names = ("first", "second", "third")
    return results | {f"principal_moments.{name}": moment for name, moment in zip(names, moments, strict=True)}


def measure_of(shape: "Any") -> str:
    """What the size of a shape is called."""
    return ("length", "area", "volume")[shape.dimension - 1]


def results(shape: "Any", amount: "Any", table: "dict[str, Any]") -> "dict[str, float]":
    """Those of a shape by a table of pieces."""
    return properties(table[type(shape).__name__](shape), amount.mass, measure_of(shape))
