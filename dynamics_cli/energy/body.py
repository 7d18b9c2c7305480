"""The task `body`: kinetic energy, momentum and angular momentum of bodies."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import summed
from dynamics_cli.quantities import (
    AngularMomentumVector,
    AngularRate,
    Annotated,
    ImpulseVector,
    Inertia,
    Mass,
    Position,
    PotentialEnergy,
    Velocity,
)
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

ORIGIN = (0.0, 0.0, 0.0)


@record
class Body:
    """A body that moves, and turns about an axis parallel to z."""

    mass: Annotated[Mass, "Mass, e.g. 2 kg."]
    velocity: Annotated[Velocity, "Velocity of its mass centre, e.g. 3, 0 m/s."] = ORIGIN
    at: Annotated[Position, "Its mass centre, e.g. 0, 1 m."] = ORIGIN
    inertia: Annotated[Inertia, "Moment of inertia about its centre, e.g. 0.1 kg*m^2."] = 0.0
    rotation: Annotated[AngularRate, "Angular velocity about z, e.g. 20 rad/s."] = 0.0


@record
class Motion:
    """Energy and momenta of bodies."""

    energy: Annotated[PotentialEnergy, "Kinetic energy [J]."]
    translation: Annotated[PotentialEnergy, "Its part from the motion of the mass centres [J]."]
    rotation: Annotated[PotentialEnergy, "Its part from turning [J]."]
    inner_energy: Annotated[PotentialEnergy | None, "Kinetic energy beside the common mass centre; of several [J]."]
    momentum: Annotated[ImpulseVector, "Momentum [N·s]."]
    angular_momentum: Annotated[AngularMomentumVector, "Angular momentum about the point [kg·m²/s]."]
    central_momentum: Annotated[AngularMomentumVector, "Angular momentum about the common mass centre [kg·m²/s]."]
    centre: Annotated[Position, "Common mass centre [m]."]
    centre_velocity: Annotated[Velocity, "Its velocity [m/s]."]
    mass: Annotated[Mass, "Mass of all [kg]."]


def body(
    *,
    bodies: Annotated[Body | tuple[Body, ...], "The bodies; one may be given by its plain fields."],
    about: Annotated[Position, "Point of the angular momentum, at rest, e.g. 0, 0 m."] = ORIGIN,
) -> Motion:
    """Kinetic energy, momentum and angular momentum of one or more bodies that turn about axes parallel to z.

    Equation
    --------
    T = ½·Σ(m·v² + I·ω²), p = Σ m·v, H = Σ((r − Q) × m·v + I·ω), T′ = T − ½·M·v_C² as ½·Σ m·(v − v_C)² + ½·Σ I·ω².

    Returns
    -------
    Motion
        The energy and its parts, the momenta, and the mass centre with its velocity.

    Raises
    ------
    InadmissibleError
        When no body is given, or none has a mass.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.3 to 9.6 and 10.4.

    Examples
    --------
    >>> result = body(bodies=(Body(2.0, (3.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.1, 20.0),))
    >>> result.energy, result.angular_momentum
    (29.0, (0.0, 0.0, -4.0))
    """
    bodies = bodies if isinstance(bodies, tuple) else (bodies,)
    require(len(bodies) > 0, "no body is given", code="none", hint='give --body "mass=2 kg, velocity=3, 0 m/s"')
    mass = summed([solid.mass for solid in bodies])
    require(mass > 0.0, "the bodies have no mass", code="mass", hint="give a mass above zero")
    velocity = _weighted([solid.velocity for solid in bodies], bodies, mass)
    centre = _weighted([solid.at for solid in bodies], bodies, mass)
    translation = summed([0.5 * solid.mass * _square(solid.velocity) for solid in bodies])
    turning = summed([0.5 * solid.inertia * solid.rotation * solid.rotation for solid in bodies])
    inner = None
    if len(bodies) > 1:
        apart = [_between(velocity, solid.velocity) for solid in bodies]
        inner = summed([0.5 * solid.mass * _square(way) for solid, way in zip(bodies, apart, strict=True)]) + turning
    return Motion(
        energy=translation + turning,
        translation=translation,
        rotation=turning,
        inner_energy=inner,
        momentum=_vector(summed([solid.mass * solid.velocity[axis] for solid in bodies]) for axis in range(3)),
        angular_momentum=_about(about, ORIGIN, bodies),
        # the velocities beside the centre's give the same sum without its cancellation
        central_momentum=_about(centre, velocity, bodies),
        centre=centre,
        centre_velocity=velocity,
        mass=mass,
    )


def _about(point: "Any", velocity: "Any", bodies: "tuple[Body, ...]") -> "Any":
    """Sum of (r − Q) × m·(v − V) and of what the bodies turn by themselves."""
    parts: list[list[Any]] = [[], [], []]
    for solid in bodies:
        x, y, z = _between(point, solid.at)
        u, v, w = (solid.mass * rate for rate in _between(velocity, solid.velocity))
        for part, value in zip(parts, (y * w - z * v, z * u - x * w, x * v - y * u), strict=True):
            part.append(value)
        parts[2].append(solid.inertia * solid.rotation)
    return _vector(summed(part) for part in parts)


def _weighted(vectors: "list[Any]", bodies: "tuple[Body, ...]", mass: float) -> "Any":
    if len(bodies) == 1:
        return vectors[0]
    pairs = list(zip(bodies, vectors, strict=True))
    return _vector(summed([solid.mass * vector[axis] for solid, vector in pairs]) / mass for axis in range(3))


def _between(start: "Any", end: "Any") -> "Any":
    return _vector(after - before for before, after in zip(start, end, strict=True))


def _square(vector: "Any") -> float:
    return summed([part * part for part in vector])


def _vector(parts: "Any") -> "Any":
    return tuple(parts)
