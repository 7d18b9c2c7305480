"""The task `rotating-frame`: what acts on a particle as seen from a turning frame, a turntable or the earth."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, cos, pi_beside, sin
from dynamics_cli.numerics.number import decides, plain
from dynamics_cli.numerics.vectors import FrameTerms, Vector, add, length, scale
from dynamics_cli.particle.fall import EARTH, QUARTER
from dynamics_cli.quantities import (
    Acceleration,
    AccelerationVector,
    Angle,
    AngularAccelerationVector,
    AngularVelocity,
    Annotated,
    Force,
    ForceVector,
    LongDistance,
    LongTime,
    Mass,
    Position,
    SlowTurnRate,
    Velocity,
)
from dynamics_cli.records import record

ZERO = (0.0, 0.0, 0.0)


@record
class Turning:
    """A frame that turns about its origin."""

    angular_velocity: Annotated[AngularVelocity, "Angular velocity ω of the frame, e.g. 0, 0, 2 rad/s."]
    position: Annotated[Position, "Where the particle is in the frame, from the axis, e.g. 1.5, 0, 0 m."] = ZERO
    angular_acceleration: Annotated[
        AngularAccelerationVector, "Angular acceleration α of the frame, e.g. 0, 0, 0.5 rad/s^2."
    ] = ZERO


@record
class OnEarth:
    """The ground: axes to the east, to the north and up."""

    latitude: Annotated[Angle, "Latitude, north positive, e.g. 52 deg."]


@record
class RotatingFrame:
    """The apparent accelerations of a particle in a turning frame."""

    coriolis: Annotated[AccelerationVector, "Coriolis, −2ω×v [m/s^2]."]
    coriolis_size: Annotated[Acceleration, "Its magnitude [m/s^2]."]
    centrifugal: Annotated[AccelerationVector | None, "Centrifugal, −ω×(ω×r); part of gravity on the ground [m/s^2]."]
    euler: Annotated[AccelerationVector | None, "By the angular acceleration, −α×r (Euler) [m/s^2]."]
    apparent: Annotated[AccelerationVector | None, "All three together [m/s^2]."]
    true_velocity: Annotated[Velocity | None, "Velocity v + ω×r seen from a frame at rest [m/s]."]
    apparent_force: Annotated[ForceVector | None, "Apparent force on the mass [N]."]
    force_size: Annotated[Force | None, "Its magnitude [N]."]
    inertial_radius: Annotated[LongDistance | None, "Radius of the circle of a level motion with no other force [m]."]
    inertial_time: Annotated[LongTime | None, "Time once round it, half a pendulum day [s]."]
    foucault_rate: Annotated[
        SlowTurnRate | None, "Turning rate of a pendulum's plane, clockwise from above positive [rad/s]."
    ]
    foucault_time: Annotated[LongTime | None, "Time in which it turns once [s]."]


def rotating_frame(
    *,
    frame: Turning | OnEarth,
    velocity: Annotated[Velocity, "Velocity v in the frame; on the ground east, north, up, e.g. 0, 1.2, 0 m/s."] = ZERO,
    mass: Annotated[Mass | None, "Mass of the particle, for the forces, e.g. 70 kg."] = None,
) -> RotatingFrame:
    """Coriolis, centrifugal and Euler accelerations of a particle that moves in a turning frame.

    Equation
    --------
    a = −2ω×v − ω×(ω×r) − α×r; on the ground ω = Ω·(0, cos λ, sin λ), a pendulum's plane turns at Ω·sin λ and a level
    motion at speed v in a circle of radius v/(2·Ω·sin λ).

    Returns
    -------
    RotatingFrame
        The apparent accelerations, with a mass the forces; on the ground the circle and Foucault's pendulum.

    Raises
    ------
    InadmissibleError
        When the latitude is beyond a pole, or the mass is not above zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 4.10.

    Examples
    --------
    >>> turntable = Turning((0.0, 0.0, 2.0), (1.5, 0.0, 0.0))
    >>> rotating_frame(frame=turntable, velocity=(0.0, 1.0, 0.0)).coriolis
    (4.0, 0.0, 0.0)
    """
    if mass is not None:
        require(mass > 0.0, "the mass of {mass} is not above zero", mass=(mass, Mass))
    if isinstance(frame, OnEarth):
        return _on_earth(frame.latitude, velocity, mass)
    terms = FrameTerms(
        frame.position, (frame.angular_velocity, frame.angular_acceleration), (velocity, ZERO), (ZERO, ZERO)
    )
    coriolis, centrifugal, euler = (_against(term) for term in (terms.coriolis, terms.centripetal, terms.angular))
    apparent = add(add(centrifugal, euler), coriolis)
    return RotatingFrame(
        coriolis, length(coriolis), centrifugal, euler, apparent, terms.velocity, *_forces(mass, apparent),
        None, None, None, None,
    )  # fmt: skip


def _on_earth(latitude: float, velocity: Vector, mass: float | None) -> RotatingFrame:
    require(absolute(latitude) <= QUARTER, "a latitude of {latitude} lies beyond a pole", latitude=(latitude, Angle),
            code="latitude", hint="give an angle between -90 and 90 deg")  # fmt: skip
    upwards = EARTH * sin(latitude)
    spin = (0.0 * upwards, EARTH * cos(latitude), upwards)
    coriolis = _against(FrameTerms(ZERO, (spin, ZERO), (velocity, ZERO), (ZERO, ZERO)).coriolis)
    rate = absolute(upwards)
    level = length((velocity[0], velocity[1], 0.0))
    turns = not decides(rate) or plain(rate) > 0.0
    goes = turns and (not decides(level) or plain(level) > 0.0)
    turn = pi_beside(latitude) / rate if turns else None
    return RotatingFrame(
        coriolis, length(coriolis), None, None, None, None, *_forces(mass, coriolis),
        level / (2.0 * rate) if goes else None, turn if goes else None,
        upwards, None if turn is None else 2.0 * turn,
    )  # fmt: skip


def _against(term: Vector) -> Vector:
    """What the frame adds: the term of the true acceleration, turned round."""
    return (0.0 - term[0], 0.0 - term[1], 0.0 - term[2])


def _forces(mass: float | None, apparent: Vector) -> "tuple[Vector | None, float | None]":
    if mass is None:
        return None, None
    force = scale(mass, apparent)
    return force, length(force)
