"""Skids: the forms of the textbook, with the slope's sine and cosine and with differences of squares."""

import math

from dynamics_cli.accuracy.questions import Method, Question

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

HERE = "dynamics_cli.accuracy.rivals.skid:"


def speed_by_slope_angle(
    *, segments: "tuple[Any, ...]", end_speed: float = 0.0, mass: "float | None" = None, gravity: float
) -> "dict[str, float]":
    """V² = vₑ² + Σ 2·g·d·(η·μ·cos θ + sin θ) with θ = tan⁻¹(grade): digits go as the drag comes near zero."""
    total = end_speed**2
    for one in segments:
        theta = math.atan(one.grade)
        total += 2 * gravity * one.distance * (one.braking * one.friction * math.cos(theta) + math.sin(theta))
    return {"speed": math.sqrt(total)}


def distance_by_squares(
    *, speed: float, friction: float, grade: float = 0.0, braking: float = 1.0, end_speed: float = 0.0,
    mark: "float | None" = None, gravity: float,
) -> "dict[str, float]":  # fmt: skip
    """D = (v² − vₑ²)/(2·g·f): digits go as the two speeds come near one another."""
    theta = math.atan(grade)
    drag = braking * friction * math.cos(theta) + math.sin(theta)
    deceleration = gravity * drag
    return {"distance": (speed**2 - end_speed**2) / (2 * deceleration), "time": (speed - end_speed) / deceleration}


def yaw_by_bank_angle(
    *, path: "Any", friction: float, superelevation: float = 0.0, track_width: "float | None" = None, gravity: float
) -> "dict[str, float]":
    """V = √(g·R·tan(tan⁻¹ μ + tan⁻¹ e)), the radius less half a track; R = C²/(8·M) + M/2."""
    radius = path.radius - (0.5 * track_width if track_width is not None else 0.0)
    return {"speed": math.sqrt(gravity * radius * math.tan(math.atan(friction) + math.atan(superelevation)))}


QUESTIONS = (
    Question(
        "skid", "speed", "skid speed", "skid.json", "speed",
        Method("sine and cosine of the slope", HERE + "speed_by_slope_angle"),
    ),
    Question(
        "skid", "distance", "skid distance", "skid.json", "distance",
        Method("difference of squares", HERE + "distance_by_squares"),
    ),
    Question("skid", "yaw", "skid yaw", "skid.json", "yaw", Method("angles added", HERE + "yaw_by_bank_angle")),
)  # fmt: skip
