"""The task `drop`: a mass that falls or runs onto a spring."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Annotated,
    Distance,
    Force,
    Gravity,
    Mass,
    PotentialEnergy,
    Ratio,
    Size,
    Speed,
    SpringRate,
)
from dynamics_cli.records import record


@record
class Falling:
    """Dropped from rest onto a spring below."""

    height: Annotated[Distance, "Height of the fall to the spring; 0 when it is let go on it, e.g. 0.5 m."]


@record
class Running:
    """Running into a spring along the level."""

    speed: Annotated[Speed, "Speed at the spring, along the level, e.g. 1.5 m/s."]


@record
class Known:
    """A spring that is there."""

    stiffness: Annotated[SpringRate, "Stiffness of the spring, e.g. 5 N/mm."]


@record
class Stroke:
    """A spring that is looked for."""

    stroke: Annotated[Size, "Largest compression that is allowed, for the stiffness, e.g. 80 mm."]


@record
class Stop:
    """How a spring stops the mass."""

    compression: Annotated[Size, "Greatest compression [m]."]
    force: Annotated[Force, "Greatest force of the spring [N]."]
    deceleration: Annotated[Acceleration, "Greatest deceleration [m/s^2]."]
    speed: Annotated[Speed, "Speed as it meets the spring [m/s]."]
    top_speed: Annotated[Speed | None, "Greatest speed, where spring and weight balance; of a fall [m/s]."]
    stiffness: Annotated[SpringRate, "Stiffness of the spring [N/m]."]
    rest: Annotated[Size | None, "Compression at rest in the end; of a fall [m]."]
    factor: Annotated[Ratio | None, "Greatest force over the weight; of a fall [-]."]
    energy: Annotated[PotentialEnergy, "Energy in the spring then [J]."]


def drop(
    *,
    mass: Annotated[Mass, "The mass, e.g. 2 kg."],
    arrival: Annotated[Falling | Running, "A fall from a height, or a speed along the level."],
    spring: Annotated[Known | Stroke, "Its stiffness, or the compression that is allowed."],
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Stop:
    """Greatest compression and force as a mass falls or runs onto a spring, or the stiffness for a stroke.

    Equation
    --------
    Fall: ½·k·x² = m·g·(h + x), x = (m·g/k)·(1 + √(1 + 2·k·h/(m·g))). Level: x = v·√(m/k).

    Returns
    -------
    Stop
        Compression, force, deceleration, and the speeds.

    Raises
    ------
    InadmissibleError
        When mass, stiffness or stroke is not above zero, or it does not move.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.9.

    Examples
    --------
    >>> round(drop(mass=2.0, arrival=Falling(0.5), spring=Known(5000.0)).compression, 12)
    0.066676522522
    """
    require(mass > 0.0, "the mass of {mass} is not above zero", mass=(mass, Mass))
    weight = mass * gravity
    if isinstance(arrival, Falling):
        height = arrival.height
        if isinstance(spring, Known):
            require(spring.stiffness > 0.0, "a spring without stiffness cannot stop it", code="stiffness")
            stiffness = spring.stiffness
            sag = weight / stiffness
            travel = sag + sqrt(sag * (sag + 2.0 * height))
        else:
            require(spring.stroke > 0.0, "the stroke is zero", code="stroke", hint="give a stroke above zero")
            travel = spring.stroke
            stiffness = 2.0 * weight * (height + travel) / (travel * travel)
            sag = weight / stiffness
        force = stiffness * travel
        return Stop(
            compression=travel,
            force=force,
            deceleration=(force - weight) / mass,
            speed=sqrt(2.0 * gravity * height),
            top_speed=sqrt(gravity * (2.0 * height + sag)),
            stiffness=stiffness,
            rest=sag,
            factor=force / weight,
            energy=0.5 * force * travel,
        )
    speed = arrival.speed
    require(plain(speed) > 0.0, "at {speed} it does not run into the spring", speed=(speed, Speed), code="speed",
            hint="give a speed above zero, or a --height")  # fmt: skip
    if isinstance(spring, Known):
        require(spring.stiffness > 0.0, "a spring without stiffness cannot stop it", code="stiffness")
        stiffness = spring.stiffness
        travel = speed * sqrt(mass / stiffness)
    else:
        require(spring.stroke > 0.0, "the stroke is zero", code="stroke", hint="give a stroke above zero")
        travel = spring.stroke
        stiffness = mass * (speed / travel) * (speed / travel)
    force = stiffness * travel
    return Stop(travel, force, force / mass, speed, None, stiffness, None, None, 0.5 * mass * speed * speed)
