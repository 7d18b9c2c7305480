"""A vault by search, and the mean sine of a spin by steps of a degree."""

import math

from dynamics_cli.accuracy.alternatives.skid import spun

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def spin_by_degrees(
    *, drag: "Any", distance: float, friction: float, end_speed: float, grade: float, gravity: float
) -> "dict[str, float]":
    """The mean of |sin| as the sum over steps of a degree, each in its middle; all else alike."""
    if hasattr(drag, "drag_share"):
        share = drag.drag_share
    else:
        count = max(1, math.ceil(math.degrees(drag.rotation)))
        step = drag.rotation / count
        mean = sum(abs(math.sin(drag.start_angle + (k + 0.5) * step)) for k in range(count)) / count
        share = drag.rolling_drag + (1 - drag.rolling_drag) * mean
    return spun(drag, share, distance, friction, end_speed, grade, gravity)


def least_vault_by_search(
    *, distance: float, rise: float, gravity: float, take_off: "float | None" = None
) -> "dict[str, float]":
    """The least speed over take-off angles by golden sections: half of the angle's digits, as at any minimum."""
    low, high = math.atan2(rise, distance), 0.5 * math.pi
    golden = 0.5 * (math.sqrt(5.0) - 1.0)

    def need(angle: float) -> float:
        below = distance * math.tan(angle) - rise
        return distance / math.cos(angle) * math.sqrt(0.5 * gravity / below) if below > 0.0 else math.inf

    for _ in range(80):
        one, other = high - golden * (high - low), low + golden * (high - low)
        low, high = (low, other) if need(one) < need(other) else (one, high)
    angle = 0.5 * (low + high)
    speed = need(angle)
    time = distance / (speed * math.cos(angle))
    down = gravity * time - speed * math.sin(angle)
    return {
        "speed": speed, "launch_angle": angle, "flight_time": time,
        "landing_speed": math.hypot(speed * math.cos(angle), down),
        "landing_angle": math.atan2(down, speed * math.cos(angle)),
    }  # fmt: skip
