"""Further ways beside those of `alternatives/skid/flights`."""

import math

TYPE_CHECKING = False


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
