"""Angular velocity and acceleration along a chain of bodies, each turning about an axis in the one before it."""

from dynamics_cli.numerics.orientation.quaternions import unit
from dynamics_cli.numerics.orientation.rotations import IDENTITY, axis_angle, product
from dynamics_cli.numerics.vectors import Vector, add, cross, length, scale
from dynamics_cli.numerics.vectors import times as rotated
from dynamics_cli.orient.turns.compose import letter
from dynamics_cli.quantities import (
    Angle,
    AngularAcceleration,
    AngularAccelerationVector,
    AngularRate,
    AngularVelocity,
    Annotated,
    Direction,
    Text,
)
from dynamics_cli.records import record


@record
class Link:
    """A body of the chain, turning about an axis fixed in the body before it."""

    axis: Annotated[Direction, "Axis of the rotation in components of the body before, of any length, e.g. 0, 0, 1."]
    rate: Annotated[AngularRate, "Rate of the turn, e.g. 1500 rpm."]
    acceleration: Annotated[AngularAcceleration, "Second rate of the turn, e.g. 3 rad/s^2."] = 0.0
    angle: Annotated[Angle, "Angle of the turn now, e.g. 30 deg."] = 0.0
    name: Annotated[Text | None, "Its name, e.g. rotor."] = None


@record
class LinkMotion:
    """Motion of one body of the chain, in fixed components."""

    name: Annotated[Text, "The body."]
    axis: Annotated[Direction, "Its axis now, in fixed components [-]."]
    angular_velocity: Annotated[AngularVelocity, "Its angular velocity [rad/s]."]
    angular_acceleration: Annotated[AngularAccelerationVector, "Its angular acceleration [rad/s^2]."]
    relative_velocity: Annotated[AngularVelocity, "Its angular velocity in the body before [rad/s]."]
    relative_acceleration: Annotated[AngularAccelerationVector, "Its second rate in the body before [rad/s^2]."]
    carried: Annotated[AngularAccelerationVector, "What the turning of the body before adds: ω × ω_rel [rad/s^2]."]


@record
class Chain:
    """Angular velocity and acceleration of the last body, and of each."""

    angular_velocity: Annotated[AngularVelocity, "Angular velocity of the last body, in fixed components [rad/s]."]
    angular_speed: Annotated[AngularRate, "Its magnitude [rad/s]."]
    angular_acceleration: Annotated[AngularAccelerationVector, "Angular acceleration of the last body [rad/s^2]."]
    angular_acceleration_size: Annotated[AngularAcceleration, "Its magnitude [rad/s^2]."]
    links: Annotated[tuple[LinkMotion, ...], "Each body in order."]


def addition(*, links: Annotated[Link | tuple[Link, ...], "The bodies of the chain, from the frame outward."]) -> Chain:
    """Angular velocity and acceleration of bodies that turn on one another.

    Equation
    --------
    ω_AC = ω_AB + ω_BC; α_AC = α_AB + α_BC + ω_AB × ω_BC, with α_BC as seen in B.

    Raises
    ------
    InadmissibleError
        When an axis is the zero vector.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 4.4, 4.7 and 4.8.

    Examples
    --------
    >>> spin = Link(axis=(1.0, 0.0, 0.0), rate=100.0)
    >>> addition(links=(Link(axis=(0.0, 0.0, 1.0), rate=2.0), spin)).angular_acceleration
    (0.0, 200.0, 0.0)
    """
    chain = links if isinstance(links, tuple) else (links,)
    omega: Vector = (0.0, 0.0, 0.0)
    alpha: Vector = (0.0, 0.0, 0.0)
    matrix = IDENTITY
    moved: list[LinkMotion] = []
    for nth, link in enumerate(chain):
        axis = rotated(matrix, unit(link.axis, "the axis of a link is the zero vector"))
        relative = scale(link.rate, axis)
        relative_acceleration = scale(link.acceleration, axis)
        carried = cross(omega, relative)
        omega, alpha = add(omega, relative), add(alpha, add(relative_acceleration, carried))
        matrix = product(matrix, axis_angle(link.axis, link.angle))
        moved.append(
            LinkMotion(link.name or letter(nth + 1), axis, omega, alpha, relative, relative_acceleration, carried)
        )
    return Chain(
        angular_velocity=omega,
        angular_speed=length(omega),
        angular_acceleration=alpha,
        angular_acceleration_size=length(alpha),
        links=tuple(moved),
    )
