"""What textbooks read of vehicles in the plane: masses, headings, and a change of velocity by subtraction."""

from math import atan2, cos, hypot, pi, remainder, sin

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Pair = tuple[float, float]


def mass_of(bulk: "Any", gravity: float) -> "float | None":
    """Mass, m = W/g where the weight is given; None of what is fixed."""
    if hasattr(bulk, "fixed"):
        return None
    return float(bulk.mass if hasattr(bulk, "mass") else bulk.weight / gravity)


def angle_of(heading: float, axes: str) -> float:
    """The mathematical angle of a heading: 90° − heading on a compass."""
    return 0.5 * pi - heading if axes == "compass" else heading


def heading_of(x: float, y: float, axes: str) -> float:
    """The heading of a vector."""
    return atan2(x, y) if axes == "compass" else atan2(y, x)


def velocity_of(motion: "Any", axes: str) -> "Pair":
    """Components of a velocity given by them, or by speed and heading."""
    if hasattr(motion, "velocity"):
        return motion.velocity[0], motion.velocity[1]
    angle = angle_of(motion.heading, axes)
    return motion.speed * cos(angle), motion.speed * sin(angle)


def change(name: str, before: "Pair", after: "Pair", nose: "float | None", axes: str, zero: str) -> "dict[str, float]":
    """ΔV = v' − v, its parts along and across the nose by cos and sin of the angle between, PDOF by angles."""
    x, y = after[0] - before[0], after[1] - before[1]
    travel = atan2(before[1], before[0]) if any(before) else angle_of(0.0, axes)
    ahead = travel if nose is None else angle_of(nose, axes)
    size, way = hypot(x, y), atan2(y, x)
    start = {"heading": ahead, "travel": travel, "scene": angle_of(0.0, axes)}[zero]
    turn = -1.0 if axes == "sae" else 1.0
    results = {
        "vector[0]": x, "vector[1]": y, "magnitude": size, "longitudinal": size * cos(way - ahead),
        "lateral": size * sin(way - ahead), "pdof": remainder(turn * (start - way + pi), 2.0 * pi),
    }  # fmt: skip
    return {f"{name}.delta_v.{key}": value for key, value in results.items()}
