"""Velocities in the plane before and after, and all else from them as differences, as tables and spreadsheets do.

A vehicle's heading, its nose and the zero of PDOF are read as the program reads them; the sums are those of textbooks.
"""

from math import atan2, cos, hypot, pi, sin

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


def polar(size: float, heading: float, axes: str) -> "Pair":
    """Components V·cos θ, V·sin θ."""
    angle = angle_of(heading, axes)
    return size * cos(angle), size * sin(angle)


def velocity_of(motion: "Any", axes: str) -> "Pair":
    """Components of a velocity given by them, or by speed and heading."""
    if hasattr(motion, "velocity"):
        return motion.velocity[0], motion.velocity[1]
    return polar(motion.speed, motion.heading, axes)


def kinetic(mass: float, velocity: "Pair") -> float:
    """½·m·v²."""
    return 0.5 * mass * (velocity[0] * velocity[0] + velocity[1] * velocity[1])


def change(name: str, before: "Pair", after: "Pair", nose: "float | None", axes: str, zero: str) -> "dict[str, float]":
    """ΔV = v' − v, its parts along and across the nose by cos and sin of the angle between, PDOF by angles."""
    x, y = after[0] - before[0], after[1] - before[1]
    travel = atan2(before[1], before[0]) if any(before) else angle_of(0.0, axes)
    ahead = travel if nose is None else angle_of(nose, axes)
    size, way = hypot(x, y), atan2(y, x)
    start = {"heading": ahead, "travel": travel, "scene": angle_of(0.0, axes)}[zero]
    turn = -1.0 if axes == "sae" else 1.0
    hours = round(_folded(turn * (ahead - way + pi)) * 6.0 / pi)
    return {
        f"{name}.delta_v.vector[0]": x,
        f"{name}.delta_v.vector[1]": y,
        f"{name}.delta_v.magnitude": size,
        f"{name}.delta_v.longitudinal": size * cos(way - ahead),
        f"{name}.delta_v.lateral": size * sin(way - ahead),
        f"{name}.delta_v.pdof": _folded(turn * (start - way + pi)),
        f"{name}.delta_v.clock": float(hours if hours > 0 else hours + 12),
    }


def _folded(angle: float) -> float:
    """The same direction between −180° and 180°."""
    while angle > pi:
        angle -= 2.0 * pi
    while angle <= -pi:
        angle += 2.0 * pi
    return angle


def state(name: str, velocity: "Pair", axes: str) -> "dict[str, float]":
    """Velocity after by components, size and heading."""
    return {
        f"{name}.velocity[0]": velocity[0],
        f"{name}.velocity[1]": velocity[1],
        f"{name}.speed": hypot(*velocity),
        f"{name}.heading": heading_of(*velocity, axes),
    }
