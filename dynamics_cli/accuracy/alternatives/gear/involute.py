"""The inverse involute by iteration on its residual, which loses 3/φ² units in the last place however it is solved."""

from math import atan, cbrt, tan

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

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
    """Newton on tan φ − φ from Laskin's start."""
    phi = 1.441 * cbrt(value) - 0.374 * value
    for _ in range(MOST_STEPS):
        tangent = tan(phi)
        step = (tangent - phi - value) / (tangent * tangent)
        phi -= step
        if abs(step) <= TINY * abs(phi):
            break
    return {"phi": phi}


def newton_in_tangent(value: float) -> "dict[str, float]":
    """Newton on t − tan⁻¹ t in t = tan φ, whose start and steps hold for every angle."""
    t = cbrt(3.0 * value) if value < 1.0 else value + 1.5
    for _ in range(MOST_STEPS):
        step = (t - atan(t) - value) * (1.0 + t * t) / (t * t)
        t -= step
        if abs(step) <= TINY * abs(t):
            break
    return {"phi": atan(t)}
