"""The tasks `gravity` and `first-moment`: weights, attractions, mass centres."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.typed_products import sum_of_products
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Annotated,
    Distance,
    Force,
    Gravity,
    Length,
    LoadPoint,
    Mass,
    MassMoment,
    Position,
    Ratio,
)
from dynamics_cli.records import record

# CODATA 2018, m³/(kg·s²).
NEWTON = 6.6743e-11
MEAN_RADIUS = 6371000.0
ORIGIN = (0.0, 0.0, 0.0)


@record
class AtAltitude:
    """At an altitude above the ground."""

    altitude: Annotated[Length, "Height above the ground, e.g. 400 km."]
    radius: Annotated[Distance, "Radius of the earth, or of another body, e.g. 6371 km."] = MEAN_RADIUS


@record
class Beside:
    """At a distance from another mass."""

    other_mass: Annotated[Mass, "The other mass, e.g. 5.972e24 kg."]
    distance: Annotated[Distance, "Distance between the centres, e.g. 7000 km."]


@record
class Attraction:
    """The force of gravity on a mass."""

    force: Annotated[Force, "Force on the mass [N]."]
    acceleration: Annotated[Acceleration, "Acceleration of the mass [m/s^2]."]
    share: Annotated[Ratio | None, "Ratio to the acceleration of gravity on the ground [-]."]


def gravity(
    *,
    mass: Annotated[Mass, "The mass, e.g. 80 kg."],
    place: Annotated[AtAltitude | Beside, "An altitude, or another mass at a distance."],
    gravity: Annotated[Gravity, "Acceleration of gravity on the ground [m/s^2]."] = STANDARD_GRAVITY,
) -> Attraction:
    """Weight of a mass at an altitude, or its attraction by another mass.

    Equation
    --------
    g = g₀·(R/(R + h))², F = m·g; between two masses F = G·m₁·m₂/r² with G = 6.6743e-11 m³/(kg·s²).

    Returns
    -------
    Attraction
        The force, the acceleration, and at an altitude its ratio to that on the ground.

    Raises
    ------
    InadmissibleError
        When the altitude is below the ground, the radius or the distance is zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 6.7; CODATA 2018.

    Examples
    --------
    >>> round(gravity(mass=80.0, place=AtAltitude(400e3)).acceleration, 4)
    8.6822
    """
    if isinstance(place, AtAltitude):
        require(plain(place.radius) > 0.0, "the radius is zero", code="radius", hint="give for example 6371 km")
        require(
            plain(place.altitude) >= 0.0,
            "an altitude of {altitude} is below the ground, where gravity decreases with depth",
            altitude=(place.altitude, Length),
            code="altitude",
            hint="give an altitude of zero or more",
        )
        ratio = place.radius / (place.radius + place.altitude)
        share = ratio * ratio
        acceleration = gravity * share
        return Attraction(force=mass * acceleration, acceleration=acceleration, share=share)
    require(
        plain(place.distance) > 0.0,
        "the distance is zero",
        code="distance",
        hint="give the distance between the centres",
    )
    acceleration = NEWTON * (place.other_mass / place.distance) / place.distance
    return Attraction(force=mass * acceleration, acceleration=acceleration, share=None)


@record
class Particle:
    """A mass at a point."""

    mass: Annotated[Mass, "The mass, e.g. 2 kg."]
    at: Annotated[LoadPoint, "Where it is, e.g. 1, 0 m."]


@record
class FirstMoment:
    """First moment and mass centre."""

    first_moment: Annotated[MassMoment, "Sum of mass times position from the reference [kg·m]."]
    mass: Annotated[Mass, "Total mass [kg]."]
    centre: Annotated[Position, "Mass centre [m]."]


def first_moment(
    *,
    particles: Annotated[Particle | tuple[Particle, ...], "The particles; one may be given by its plain fields."],
    about: Annotated[LoadPoint, "The point of reference, e.g. 0, 0 m."] = ORIGIN,
) -> FirstMoment:
    """First moment of mass of particles about a point, and their mass centre.

    Equation
    --------
    S = Σ m·(r − Q); the mass centre is Q + S/Σ m, where the first moment is zero.

    Returns
    -------
    FirstMoment
        The first moment, the mass, the mass centre.

    Raises
    ------
    InadmissibleError
        When no particle is given, or the masses are zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 6.8.

    Examples
    --------
    >>> two = Particle(1.0, (0.0, 0.0, 0.0)), Particle(3.0, (1.0, 2.0, 0.0))
    >>> first_moment(particles=two).centre
    (0.75, 1.5, 0.0)
    """
    several = particles if isinstance(particles, tuple) else (particles,)
    require(
        len(several) > 0, "no particle is given", code="missing", hint='for example --particle "mass=2 kg, at=1, 0 m"'
    )
    mass = sum_of_products(*((particle.mass,) for particle in several))
    require(plain(mass) > 0.0, "the masses are zero: there is no mass centre", code="no-mass")
    moment = tuple(
        sum_of_products(*(term for p in several for term in ((p.mass, p.at[i]), (-1.0, p.mass, about[i]))))
        for i in range(3)
    )
    about_origin = [sum_of_products(*((p.mass, p.at[i]) for p in several)) for i in range(3)]
    return FirstMoment(
        first_moment=moment,  # type: ignore[arg-type]
        mass=mass,
        centre=tuple(component / mass for component in about_origin),  # type: ignore[arg-type]
    )
