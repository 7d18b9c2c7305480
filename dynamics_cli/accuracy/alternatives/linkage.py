"""Four-bars by the forms of textbooks: Freudenstein's quotient for tan(θ₄/2), and the cosine rule."""

import math

from dynamics_cli.accuracy.questions import Method, Question

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def _rates(a: float, c: float, angles: "tuple[float, float, float]", m: "Any") -> "dict[str, float]":
    """Angles and speed ratios by sines of differences."""
    theta, coupler, rocker = angles
    return {
        "rocker_angle": m.atan2(m.sin(rocker), m.cos(rocker)),
        "coupler_angle": coupler,
        "rocker_ratio": a * m.sin(theta - coupler) / (c * m.sin(rocker - coupler)),
    }


def by_quotient(
    *, crank: float, coupler: float, rocker: float, ground: float, crank_angle: float, branch: str = "open",
    m: "Any" = math, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """tan(θ₄/2) = (−B ∓ √(B² − 4AC))/2A with K₁ = d/a, K₂ = d/c, K₃ = (a² − b² + c² + d²)/2ac."""
    a, b, c, d = crank, coupler, rocker, ground
    cosine = m.cos(crank_angle)
    k1, k2, k3 = d / a, d / c, (a * a - b * b + c * c + d * d) / (2 * a * c)
    first, second, third = cosine - k1 - k2 * cosine + k3, -2 * m.sin(crank_angle), k1 - (k2 + 1) * cosine + k3
    root = m.sqrt(second * second - 4 * first * third)
    theta = 2 * m.atan((-second + (-root if branch == "open" else root)) / (2 * first))
    x, y = d + c * m.cos(theta) - a * cosine, c * m.sin(theta) - a * m.sin(crank_angle)
    return _rates(a, c, (crank_angle, m.atan2(y, x), theta), m)


def by_cosine_rule(
    *, crank: float, coupler: float, rocker: float, ground: float, crank_angle: float, branch: str = "open",
    m: "Any" = math, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """Angle at A in the triangle of coupler, rocker and diagonal, by the arc cosine."""
    a, b, c, d = crank, coupler, rocker, ground
    x, y = d - a * m.cos(crank_angle), -a * m.sin(crank_angle)
    f = m.sqrt(x * x + y * y)
    corner = m.acos((b * b + f * f - c * c) / (2 * b * f))
    angle = m.atan2(y, x) + (corner if branch == "open" else -corner)
    angle = m.atan2(m.sin(angle), m.cos(angle))
    bx, by = a * m.cos(crank_angle) + b * m.cos(angle) - d, a * m.sin(crank_angle) + b * m.sin(angle)
    return _rates(a, c, (crank_angle, angle, m.atan2(by, bx)), m)


HERE = "dynamics_cli.accuracy.alternatives.linkage:"
QUESTIONS = (
    Question(
        "linkage", "", "", "linkage.json", "four_bar",
        Method("textbook: Freudenstein's quotient", HERE + "by_quotient"),
        Method("textbook: cosine rule", HERE + "by_cosine_rule"),
    ),
)  # fmt: skip
