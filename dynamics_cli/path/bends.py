"""Properties of a path from velocity, acceleration and jerk: speed, tangential and normal parts, curvature, torsion.

Products are compensated, so that nearly parallel velocity and acceleration keep their digits. Undefined results (the
direction of a point at rest, the normal of a straight path) are None, with the reason.
"""

from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.vectors import Vector, dot, length, scale
from dynamics_cli.numerics.vectors import compensated_cross as cross
from dynamics_cli.records import Advice, Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


@record
class Bend:
    """Speed and curvature of a path at one point; None where undefined."""

    speed: float
    magnitude: float
    tangential: float | None
    normal: float | None
    curvature: float | None
    radius: float | None
    tangent: Vector | None
    normal_direction: Vector | None
    binormal: Vector | None
    torsion: float | None
    reason: str = ""


def directed(a: Vector, size: float) -> Vector:
    """The unit vector of one of that length."""
    return a[0] / size, a[1] / size, a[2] / size


def vanishes(x: float, size: float) -> bool:
    """Whether a number is zero, or smaller than its own rounding bound beside that size."""
    value = abs(plain(x))
    return bool(value == 0.0 or value <= getattr(x, "error", 0.0) or value < 1e-300 * plain(size))


def bend(velocity: Vector, acceleration: Vector, jerk: "Vector | None" = None) -> Bend:
    """Tangential and normal acceleration, curvature, directions and torsion at one point.

    Equation: a_t = v·a/‖v‖, a_n = ‖v×a‖/‖v‖, κ = ‖v×a‖/‖v‖³, τ = (v×a)·j/‖v×a‖², T = v/‖v‖, B = v×a/‖v×a‖, N = B×T.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 3.
    """
    speed, size = length(velocity), length(acceleration)
    if vanishes(speed, 1.0):
        return Bend(speed, size, None, None, None, None, None, None, None, None, "rest")
    tangential = dot(velocity, acceleration) / speed
    across = cross(velocity, acceleration)
    turning = length(across)
    tangent = directed(velocity, speed)
    if vanishes(turning, 1.0):
        return Bend(speed, size, tangential, turning, 0.0 * speed, None, tangent, None, None, None, "straight")
    normal = turning / speed
    curvature = normal / speed / speed
    binormal = directed(across, turning)
    torsion = None if jerk is None else dot(across, jerk) / turning / turning
    radius = speed * (speed / normal)
    side = cross(binormal, tangent)
    return Bend(speed, size, tangential, normal, curvature, radius, tangent, side, binormal, torsion)


REST = (
    "the point is at rest: direction, curvature and the parts of the acceleration do not exist; it starts or reverses "
    "along the acceleration"
)
STRAIGHT = "velocity and acceleration are parallel: the curvature is zero and the radius of curvature infinite"


# What a straight path has and a point at rest has not.
OF_ALL_MOTION = ("tangential", "normal", "curvature", "tangent")


def advice_of(motion: Bend, *names: str) -> tuple[Advice, ...]:
    """Reasons for those of some results that are None."""
    if not motion.reason:
        return ()
    message = REST if motion.reason == "rest" else STRAIGHT
    missing = [name for name in names if motion.reason == "rest" or name not in OF_ALL_MOTION]
    return tuple(Advice(f"at-{motion.reason}", message, "note", result=name) for name in missing)


def centre_of(position: Vector, motion: Bend) -> "Vector | None":
    """The centre of curvature."""
    if motion.radius is None or motion.normal_direction is None:
        return None
    offset = scale(motion.radius, motion.normal_direction)
    return position[0] + offset[0], position[1] + offset[1], position[2] + offset[2]


def along_and_across(motion: Bend) -> "dict[str, Any]":
    """Fields of a result: speed, parts of the acceleration along and across the path, their check."""
    return {
        "speed": motion.speed, "tangential": motion.tangential, "normal": motion.normal,
        "radius_of_curvature": motion.radius, "checks": _parts_check(motion),
    }  # fmt: skip


def _parts_check(motion: Bend) -> tuple[Check, ...]:
    """That a_t and a_n make up the acceleration."""
    if motion.tangential is None or motion.normal is None:
        return ()
    apart = abs(plain(hypot(motion.tangential, motion.normal)) - plain(motion.magnitude))
    room = 1e-12 * plain(motion.magnitude) + 1e-300
    return (Check("a_t and a_n make up a", apart <= room, apart, room),)
