"""A point that moves in a moving and turning frame: the five terms of its acceleration, apart and together."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.vectors import FrameTerms, Vector, add, dot, length, scale
from dynamics_cli.numerics.vectors import compensated_cross as cross
from dynamics_cli.quantities import (
    Acceleration,
    AccelerationVector,
    AngularAccelerationVector,
    AngularVelocity,
    Annotated,
    Position,
    Quaternion,
    Speed,
    Velocity,
)
from dynamics_cli.records import record

ZERO = (0.0, 0.0, 0.0)
# A quaternion typed to five digits is one of a rotation.
UNIT = 1e-4


@record
class InMovingFrame:
    """Velocity and acceleration of the point, as the fixed frame sees them."""

    speed: Annotated[Speed, "Magnitude of the velocity [m/s]."]
    acceleration_size: Annotated[Acceleration, "Magnitude of the acceleration [m/s^2]."]
    velocity: Annotated[Velocity, "Velocity v_O + ω×r + v_rel [m/s]."]
    acceleration: Annotated[AccelerationVector, "Acceleration, all five terms [m/s^2]."]
    carried_velocity: Annotated[Velocity, "Velocity of the frame's own point there, v_O + ω×r [m/s]."]
    origin_part: Annotated[AccelerationVector, "Acceleration of the origin, a_O [m/s^2]."]
    angular_part: Annotated[AccelerationVector, "By angular acceleration, α×r [m/s^2]."]
    centripetal: Annotated[AccelerationVector, "Centripetal, ω×(ω×r) [m/s^2]."]
    coriolis: Annotated[AccelerationVector, "Coriolis, 2ω×v_rel [m/s^2]."]
    relative_part: Annotated[AccelerationVector, "Relative to the frame, a_rel [m/s^2]."]
    coriolis_size: Annotated[Acceleration, "Magnitude of the Coriolis term [m/s^2]."]
    fixed_velocity: Annotated[Velocity | None, "Velocity in fixed axes; needs the orientation [m/s]."]
    fixed_acceleration: Annotated[AccelerationVector | None, "In fixed axes; needs the orientation [m/s^2]."]


def moving_frame(
    *,
    position: Annotated[Position, "Position r in the frame, e.g. 0.3, 0, 0 m."],
    angular_velocity: Annotated[AngularVelocity, "Angular velocity ω of the frame, e.g. 0, 0, 5 rad/s."] = ZERO,
    angular_acceleration: Annotated[AngularAccelerationVector, "Its rate α, e.g. 0, 0, 2 rad/s^2."] = ZERO,
    relative_velocity: Annotated[Velocity, "Velocity in the frame, v_rel, e.g. 0.8, 0, 0 m/s."] = ZERO,
    relative_acceleration: Annotated[AccelerationVector, "Acceleration in it, a_rel, e.g. 0, 0, 1 m/s^2."] = ZERO,
    origin_velocity: Annotated[Velocity, "Velocity v_O of the frame's origin, e.g. 1, 0, 0 m/s."] = ZERO,
    origin_acceleration: Annotated[AccelerationVector, "Acceleration a_O of the origin, e.g. 0, 0, 1 m/s^2."] = ZERO,
    orientation: Annotated[Quaternion | None, "Quaternion to fixed components, e.g. 0.9239, 0, 0, 0.3827."] = None,
) -> InMovingFrame:
    """Velocity and acceleration of a point moving in a frame that moves and turns; all vectors in the frame's axes.

    Equation
    --------
    v = v_O + ω×r + v_rel; a = a_O + α×r + ω×(ω×r) + 2ω×v_rel + a_rel.

    Raises
    ------
    InadmissibleError
        When the orientation is not of length one.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 3.4, 4.6 and 4.10.

    Examples
    --------
    >>> moving_frame(position=(0.3, 0.0, 0.0), angular_velocity=(0.0, 0.0, 5.0),
    ...     relative_velocity=(0.8, 0.0, 0.0)).coriolis
    (0.0, 8.0, 0.0)
    """
    terms = FrameTerms(
        position,
        (angular_velocity, angular_acceleration),
        (relative_velocity, relative_acceleration),
        (origin_velocity, origin_acceleration),
    )
    return InMovingFrame(
        speed=length(terms.velocity),
        acceleration_size=length(terms.acceleration),
        velocity=terms.velocity,
        acceleration=terms.acceleration,
        carried_velocity=terms.carried,
        origin_part=origin_acceleration,
        angular_part=terms.angular,
        centripetal=terms.centripetal,
        coriolis=terms.coriolis,
        relative_part=relative_acceleration,
        coriolis_size=length(terms.coriolis),
        fixed_velocity=None if orientation is None else _fixed(orientation, terms.velocity),
        fixed_acceleration=None if orientation is None else _fixed(orientation, terms.acceleration),
    )


def _fixed(turn: "tuple[float, float, float, float]", vector: Vector) -> Vector:
    """The vector turned by the quaternion: v + 2(w·q×v + q×(q×v))/‖Q‖²."""
    w, q = turn[0], (turn[1], turn[2], turn[3])
    square = w * w + dot(q, q)
    require(
        absolute(square - 1.0) <= UNIT,
        "the quaternion has length {length:6}; a rotation needs length 1",
        code="quaternion",
        hint="give four numbers w, x, y, z whose squares add up to 1",
        length=str(round(plain(square) ** 0.5, 6)) if single(square) else "",
    )
    across = cross(q, vector)
    change = add(scale(w, across), cross(q, across))
    return add(vector, scale(2.0 / square, change))
