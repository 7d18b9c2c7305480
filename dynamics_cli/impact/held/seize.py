"""A moving body when a point or an axis of it is suddenly fixed."""

from dynamics_cli.errors import require
from dynamics_cli.impact.diagnostics import balance, not_above, require_finite, require_sizes
from dynamics_cli.impact.inertia_tensor import require_inertia_of_body
from dynamics_cli.numerics.elementary import absolute, maximum, sqrt
from dynamics_cli.numerics.number import single
from dynamics_cli.numerics.vectors import Vector, add, cross, dot, moved, scale, solve, subtract, times
from dynamics_cli.quantities import (
    AngularImpulse,
    AngularSpeed,
    AngularVelocity,
    Annotated,
    Direction,
    Energy,
    Impulse,
    ImpulseVector,
    InertiaTensor,
    Mass,
    MomentVector,
    Ratio,
    Size,
    SpacePosition,
    SpaceVelocity,
)
from dynamics_cli.records import Check, Choice, record

HALF_ROOT = 0.7071067811865476


class SeizedPart(Choice):
    """Part of the plate that is held: an edge as a hinge, or a corner that is not on the diagonal it spins about."""

    names = ("edge", "corner")


@record
class SquarePlate:
    """A thin square plate that spins about its diagonal."""

    plate_mass: Annotated[Mass, "Mass of the plate, e.g. 1 kg [kg]."]
    side: Annotated[Size, "Side of the plate, e.g. 1 m [m]."]
    spin: Annotated[AngularSpeed, "Angular velocity about the diagonal, e.g. 10 rad/s [rad/s]."]
    seized: Annotated[SeizedPart, "The part that is held: edge or corner."]


@record
class AnyBody:
    """A rigid body of any shape."""

    mass: Annotated[Mass, "Mass of the body [kg]."]
    inertia: Annotated[
        InertiaTensor, "Inertia about the mass centre, in axes fixed in space at the moment of the impact [kg·m²]."
    ]
    angular_velocity: Annotated[AngularVelocity, "Angular velocity before [rad/s]."]
    point: Annotated[SpacePosition, "The point that is held, from the mass centre, e.g. 0.2, -0.1, 0 m [m]."]
    velocity: Annotated[SpaceVelocity, "Velocity of the mass centre before [m/s]."] = (0.0, 0.0, 0.0)
    axis: Annotated[
        Direction | None, "Direction of the held axis through the point; if left out, only the point is held."
    ] = None


@record
class Seized:
    """The body just after the impact."""

    angular_velocity: Annotated[
        AngularVelocity,
        "Angular velocity after; of a plate in axes along its edges, the held edge at −y along x, the held corner "
        "at (+, −) [rad/s].",
    ]
    angular_speed: Annotated[AngularSpeed, "Its size [rad/s]."]
    angular_ratio: Annotated[
        Ratio | None, "The same over the angular speed before; none when the body did not spin [-]."
    ]
    centre_velocity: Annotated[SpaceVelocity, "Velocity of the mass centre after [m/s]."]
    impulse: Annotated[ImpulseVector, "Impulse of what holds the body [N·s]."]
    impulse_size: Annotated[Impulse, "Its size [N·s]."]
    couple: Annotated[
        MomentVector | None, "Impulsive couple on a held axis, perpendicular to it; zero for a point [N·m·s]."
    ]
    couple_size: Annotated[AngularImpulse | None, "Its size [N·m·s]."]
    energy_before: Annotated[Energy, "Kinetic energy before [J]."]
    energy_after: Annotated[Energy, "Kinetic energy after [J]."]
    energy_lost: Annotated[Energy, "The kinetic energy of the velocities lost (Carnot), which is what was lost [J]."]
    energy_ratio: Annotated[Ratio, "Energy after over energy before [-]."]
    checks: tuple[Check, ...] = ()


def seize(
    *,
    body: Annotated[
        SquarePlate | AnyBody,
        "The square plate of the book, or any body by mass, inertia, motion and the point or axis held.",
    ],
) -> Seized:
    """A point or an axis of a moving body is suddenly held: angular momentum about it is conserved, the rest is lost.

    Equation
    --------
    Point: I_O ω' = I_G ω + r × m v; axis a: ω' = a (a·H_O)/(a·I_O a); loss ½ m Δv² + ½ Δω·I_G Δω.

    Returns
    -------
    Seized
        Angular velocity and velocity after, impulse and couple of the support, energies.

    Raises
    ------
    InadmissibleError
        When mass or inertia is zero or not that of a real body, the body does not move, or the axis has no direction.

    Notes
    -----
    The support does not move and allows neither slip nor rebound. The energy lost is that of the lost
    velocities (Carnot's theorem), not a difference of energies. For a thin rod held at a point of its axis the spin
    about this axis is undetermined.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.12 and 10.12.

    Examples
    --------
    >>> plate = SquarePlate(plate_mass=1.0, side=1.0, spin=10.0, seized=SeizedPart("edge"))
    >>> round(seize(body=plate).angular_ratio, 12), round(seize(body=plate).energy_ratio, 12)
    (0.176776695297, 0.125)
    """
    require_sizes(body=body)
    solid = _plate(body) if isinstance(body, SquarePlate) else body
    mass = solid.mass
    require(mass > 0.0, "the mass of the body must be above zero", code="no-mass")
    require_inertia_of_body(solid.inertia, "the body")
    (a, b, c), (_, d, e), (_, _, f) = solid.inertia
    inertia = (a, b, c), (b, d, e), (c, e, f)
    spin, velocity = solid.angular_velocity, solid.velocity
    reach = scale(-1.0, solid.point)
    spin_part = times(inertia, spin)
    before = 0.5 * dot(spin_part, spin) + 0.5 * mass * dot(velocity, velocity)
    require(before > 0.0, "the body does not move before it is held", code="no-impact")
    require_finite(before, "the energy of the body")
    momentum = add(spin_part, scale(mass, cross(reach, velocity)))
    pivoted = moved(inertia, mass, solid.point)
    axis: Vector | None = None
    if solid.axis is None:
        after = solve(pivoted, momentum, "the body has no inertia about some direction through the held point")
    else:
        axis = _unit(solid.axis)
        moment = dot(axis, times(pivoted, axis))
        require(moment > 0.0, "the body has no inertia about the held axis", code="no-inertia")
        after = scale(dot(axis, momentum) / moment, axis)
    centre = cross(after, reach)
    lost_velocity, lost_spin = subtract(centre, velocity), subtract(after, spin)
    impulse = scale(mass, lost_velocity)
    turned = times(inertia, lost_spin)
    couple = add(turned, cross(reach, impulse))
    lost = 0.5 * mass * dot(lost_velocity, lost_velocity) + 0.5 * dot(turned, lost_spin)
    kept = 0.5 * dot(momentum, after)
    speed = _size(spin)
    checks = _checks(
        couple, axis, _size(momentum) + _size(turned) + mass * _size(reach) * (_size(velocity) + _size(centre))
    )
    checks += balance("energy", before, kept + lost, before) + not_above("no energy is gained", kept, before, before)
    return Seized(
        angular_velocity=after,
        angular_speed=_size(after),
        angular_ratio=_size(after) / speed if not single(speed) or bool(speed > 0.0) else None,
        centre_velocity=centre,
        impulse=impulse,
        impulse_size=_size(impulse),
        couple=None if axis is None else couple,
        couple_size=None if axis is None else _size(couple),
        energy_before=before,
        energy_after=kept,
        energy_lost=lost,
        energy_ratio=kept / before,
        checks=checks,
    )


def _plate(plate: SquarePlate) -> AnyBody:
    """The plate with x and y along its edges, spinning about the diagonal (1, 1, 0)."""
    require(plate.side > 0.0, "the side of the plate must be above zero", code="no-size")
    moment = plate.plate_mass * plate.side * plate.side / 12.0
    part = plate.spin * HALF_ROOT
    half = 0.5 * plate.side
    edge = plate.seized == "edge"
    return AnyBody(
        mass=plate.plate_mass,
        inertia=((moment, 0.0, 0.0), (0.0, moment, 0.0), (0.0, 0.0, 2.0 * moment)),
        angular_velocity=(part, part, 0.0),
        point=(0.0 if edge else half, -half, 0.0),
        axis=(1.0, 0.0, 0.0) if edge else None,
    )


def _unit(axis: Vector) -> Vector:
    largest = maximum(maximum(absolute(axis[0]), absolute(axis[1])), absolute(axis[2]))
    require(largest > 0.0, "the axis has no direction", code="no-axis")
    shrunk = scale(1.0 / largest, axis)
    size = sqrt(dot(shrunk, shrunk))
    return shrunk[0] / size, shrunk[1] / size, shrunk[2] / size


def _size(vector: Vector) -> float:
    return sqrt(dot(vector, vector))


def _checks(couple: Vector, axis: Vector | None, size: float) -> tuple[Check, ...]:
    """Check that angular momentum about the held point, or along the held axis, is conserved."""
    if axis is not None:
        return balance("angular momentum about the axis", dot(couple, axis), 0.0, size)
    checks: tuple[Check, ...] = ()
    for value, name in zip(couple, "xyz", strict=True):
        checks += balance(f"angular momentum about the point, {name}", value, 0.0, size)
    return checks
