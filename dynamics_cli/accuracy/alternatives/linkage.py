"""Four-bars as textbooks have them: Freudenstein's quotient for tan(θ₄/2)."""

import math
from typing import Any

from dynamics_cli.accuracy.questions import textbooks


def _rates(a: float, c: float, angles: "tuple[float, float, float]") -> "dict[str, float]":
    """Angles and speed ratios by sines of differences."""
    theta, coupler, rocker = angles
    return {
        "rocker_angle": math.atan2(math.sin(rocker), math.cos(rocker)),
        "coupler_angle": coupler,
        "rocker_ratio": a * math.sin(theta - coupler) / (c * math.sin(rocker - coupler)),
    }


def by_quotient(
    *, crank: float, coupler: float, rocker: float, ground: float, crank_angle: float, branch: str = "open",
    **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """tan(θ₄/2) = (−B ∓ √(B² − 4AC))/2A with K₁ = d/a, K₂ = d/c, K₃ = (a² − b² + c² + d²)/2ac."""
    a, b, c, d = crank, coupler, rocker, ground
    cosine = math.cos(crank_angle)
    k1, k2, k3 = d / a, d / c, (a * a - b * b + c * c + d * d) / (2 * a * c)
    first, second, third = cosine - k1 - k2 * cosine + k3, -2 * math.sin(crank_angle), k1 - (k2 + 1) * cosine + k3
    root = math.sqrt(second * second - 4 * first * third)
    theta = 2 * math.atan((-second + (-root if branch == "open" else root)) / (2 * first))
    x, y = d + c * math.cos(theta) - a * cosine, c * math.sin(theta) - a * math.sin(crank_angle)
    return _rates(a, c, (crank_angle, math.atan2(y, x), theta))


QUESTIONS = textbooks(
    "linkage", "linkage.json", "dynamics_cli.accuracy.alternatives.linkage:",
    ("four_bar", "textbook: Freudenstein's quotient", "by_quotient"),
)  # fmt: skip
