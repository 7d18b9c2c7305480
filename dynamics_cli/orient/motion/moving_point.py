"""A point that moves on a moving body: its velocity and acceleration, term by term."""

from dynamics_cli.numerics.vectors import FrameTerms, length
from dynamics_cli.quantities import (
    Acceleration,
    AccelerationVector,
    AngularAccelerationVector,
    AngularVelocity,
    Annotated,
    Position,
    Speed,
    Velocity,
)
from dynamics_cli.records import record

NOTHING = (0.0, 0.0, 0.0)


@record
class MovingPoint:
    """Velocity and acceleration of the point, with their terms."""

    velocity: Annotated[Velocity, "Velocity of the point [m/s]."]
    speed: Annotated[Speed, "Its magnitude [m/s]."]
    acceleration: Annotated[AccelerationVector, "Acceleration of the point [m/s^2]."]
    acceleration_size: Annotated[Acceleration, "Its magnitude [m/s^2]."]
    carried_velocity: Annotated[Velocity, "ω × r: velocity of the body there, from its turning [m/s]."]
    origin_acceleration: Annotated[AccelerationVector, "Acceleration of the body's origin [m/s^2]."]
    tangential: Annotated[AccelerationVector, "α × r [m/s^2]."]
    centripetal: Annotated[AccelerationVector, "ω × (ω × r) [m/s^2]."]
    coriolis: Annotated[AccelerationVector, "2·ω × v_rel [m/s^2]."]
    relative: Annotated[AccelerationVector, "Acceleration seen on the body [m/s^2]."]


def moving_point(
    *,
    angular_velocity: Annotated[AngularVelocity, "Angular velocity ω of the body, e.g. 0, 0, 2 rad/s."],
    position: Annotated[Position, "Where the point is, from the body's origin, e.g. 1, 0, 0 m."],
    relative_velocity: Annotated[Velocity, "Velocity of the point on the body, e.g. 0.5, 0, 0 m/s."] = NOTHING,
    relative_acceleration: Annotated[AccelerationVector, "Its acceleration on the body, e.g. 0, 0, 3 m/s^2."] = NOTHING,
    angular_acceleration: Annotated[AngularAccelerationVector, "α of the body, e.g. 0, 0, 5 rad/s^2."] = (NOTHING),
    origin_velocity: Annotated[Velocity, "Velocity of the body's origin, e.g. 3, 0, 0 m/s."] = NOTHING,
    origin_acceleration: Annotated[AccelerationVector, "Acceleration of the origin, e.g. 0, 0, 3 m/s^2."] = (NOTHING),
) -> MovingPoint:
    """Velocity and acceleration of a point that moves on a moving body, all vectors in one set of axes.

    Equation
    --------
    v = v_O + ω × r + v_rel; a = a_O + α × r + ω × (ω × r) + 2·ω × v_rel + a_rel.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 4.10.

    Examples
    --------
    >>> answer = moving_point(
    ...     angular_velocity=(0.0, 0.0, 2.0), position=(1.0, 0.0, 0.0), relative_velocity=(0.5, 0.0, 0.0)
    ... )
    >>> answer.velocity, answer.acceleration
    ((0.5, 2.0, 0.0), (-4.0, 2.0, 0.0))
    """
    terms = FrameTerms(
        position,
        (angular_velocity, angular_acceleration),
        (relative_velocity, relative_acceleration),
        (origin_velocity, origin_acceleration),
    )
    return MovingPoint(
        velocity=terms.velocity,
        speed=length(terms.velocity),
        acceleration=terms.acceleration,
        acceleration_size=length(terms.acceleration),
        carried_velocity=terms.spun,
        origin_acceleration=origin_acceleration,
        tangential=terms.angular,
        centripetal=terms.centripetal,
        coriolis=terms.coriolis,
        relative=relative_acceleration,
    )
