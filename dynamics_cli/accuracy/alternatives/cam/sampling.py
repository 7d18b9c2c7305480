"""Extremes as tables give them: equal steps of cam angle, or steps of every zone and golden sections about the best."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    # Quantities by name, from lift, velocity and acceleration.
    Curves = Callable[..., dict[str, Any]]
    Extremes = dict[str, tuple[float, float]]

GOLDEN = 0.6180339887498949
SAMPLES, STEPS = 360, 64


def sampled(curves: "Curves", motion: "Any") -> "Extremes":
    """The least and the greatest of the samples of a turn."""
    import numpy as np

    values = curves(*motion.at(np.arange(SAMPLES) * (2.0 * np.pi / SAMPLES), 2))
    return {name: (float(np.min(v)), float(np.max(v))) for name, v in values.items()}


def refined(curves: "Curves", motion: "Any") -> "Extremes":
    """Steps of every zone, ends included, then golden sections about the best of each curve."""
    import numpy as np

    def at(zone: int, shares: "Any") -> "dict[str, Any]":
        values = curves(*motion.in_zone(zone, shares, 2))
        return {name: np.broadcast_to(v, shares.shape) for name, v in values.items()}

    shares = np.linspace(0.0, 1.0, STEPS + 1)
    zones = [at(zone, shares) for zone in range(len(motion.zones))]
    extremes: Extremes = {}
    for name in zones[0]:
        ends = []
        for sign in (-1.0, 1.0):
            values = np.array([sign * zone[name] for zone in zones])
            index, place = divmod(int(values.argmax()), shares.size)

            def value(share: float, name: str = name, sign: float = sign, index: int = index) -> float:
                return sign * float(at(index, np.array([share]))[name][0])

            ends.append(
                sign * max(float(values[index, place]), _climbed(value, (place - 1) / STEPS, (place + 1) / STEPS))
            )
        extremes[name] = ends[0], ends[1]
    return extremes


def _climbed(function: "Callable[[float], float]", low: float, high: float) -> float:
    """The greatest value between two places."""
    low, high = max(low, 0.0), min(high, 1.0)
    for _ in range(45):
        a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        low, high = (low, b) if function(a) > function(b) else (a, high)
    return function(0.5 * (low + high))
