"""Four-bars by the forms of textbooks: Freudenstein's quotient for tan(θ₄/2), and the cosine rule."""

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


def by_cosine_rule(
    *, crank: float, coupler: float, rocker: float, ground: float, crank_angle: float, branch: str = "open",
    **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """Angle at A in the triangle of coupler, rocker and diagonal, by the arc cosine."""
    a, b, c, d = crank, coupler, rocker, ground
    x, y = d - a * math.cos(crank_angle), -a * math.sin(crank_angle)
    f = math.sqrt(x * x + y * y)
    corner = math.acos((b * b + f * f - c * c) / (2 * b * f))
    angle = math.atan2(y, x) + (corner if branch == "open" else -corner)
    angle = math.atan2(math.sin(angle), math.cos(angle))
    bx, by = a * math.cos(crank_angle) + b * math.cos(angle) - d, a * math.sin(crank_angle) + b * math.sin(angle)
    return _rates(a, c, (crank_angle, angle, math.atan2(by, bx)))


QUESTIONS = textbooks(
    "linkage", "linkage.json", "dynamics_cli.accuracy.alternatives.linkage:",
    ("four_bar", "textbook: Freudenstein's quotient", "by_quotient"),
    ("four_bar", "textbook: cosine rule", "by_cosine_rule"),
)  # fmt: skip
