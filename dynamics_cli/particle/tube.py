"""The tasks `tube` and `hoop`: a particle in a tube that turns."""

from dynamics_cli.errors import UsageError, require
from dynamics_cli.numerics.elementary import atan2, cos, cosh, pi_beside, sin, sinh, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Angle,
    Annotated,
    Count,
    Force,
    Frequency,
    Gravity,
    GrowthRate,
    Length,
    Mass,
    ShaftSpeed,
    Speed,
    Stiffness,
    Text,
    Time,
)
from dynamics_cli.records import Choice, record

MOST_ROWS = 10000
SERIES = 0.5


class Plane(Choice):
    """The plane in which the tube turns."""

    __slots__ = ()
    names = ("horizontal", "vertical")


LEVEL = Plane("horizontal")


@record
class Spring:
    """A spring between the particle and the axis."""

    stiffness: Annotated[Stiffness, "Stiffness of the spring, e.g. 40 N/m."]
    free_length: Annotated[Length, "Its length without force, e.g. 0.2 m."]


@record
class Moment:
    """The particle at one time."""

    time: Annotated[Time, "Time since the start [s]."]
    position: Annotated[Length, "Distance from the axis [m]."]
    speed: Annotated[Speed, "Speed along the tube, outwards positive [m/s]."]


@record
class Tube:
    """Where a particle in a turning tube goes."""

    position: Annotated[Length, "Distance from the axis at the end [m]."]
    speed: Annotated[Speed, "Speed along the tube then, outwards positive [m/s]."]
    total_speed: Annotated[Speed, "Speed through space then [m/s]."]
    acceleration: Annotated[Acceleration, "Acceleration along the tube then [m/s^2]."]
    wall_force: Annotated[
        Force | None, "Force of the wall across the tube, in the plane of turning; with the mass [N]."
    ]
    motion: Annotated[Text, "What the particle does in the end."]
    rest: Annotated[
        Length | None, "Where it would stay at rest in the tube; with a spring, in the horizontal plane [m]."
    ]
    path: Annotated[tuple[Moment, ...], "The motion at equal times."]


def tube(
    *,
    rotation: Annotated[ShaftSpeed, "How fast the tube turns, e.g. 60 rpm."],
    start: Annotated[Length, "Distance from the axis at the start, e.g. 0.1 m."],
    time: Annotated[Time, "Time since the start, e.g. 0.5 s."],
    start_speed: Annotated[Speed, "Speed along the tube at the start, outwards positive, e.g. 0.2 m/s."] = 0.0,
    plane: Annotated[Plane, "The plane it turns in; in the vertical one it starts level and rises."] = LEVEL,
    mass: Annotated[Mass | None, "Mass of the particle, for the force; with a spring, e.g. 0.5 kg."] = None,
    spring: Annotated[Spring | None, "A spring between the particle and the axis."] = None,
    steps: Annotated[Count, "Rows of the motion, less one [-]."] = 8,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Tube:
    """A particle in a straight, smooth tube that turns at a constant rate about an axis across it.

    Equation
    --------
    r̈ + (k/m − Ω²)·r = k·ℓ₀/m − g·sin Ωt (the last in the vertical plane); wall force m·(2·Ω·ṙ + g·cos Ωt).

    Returns
    -------
    Tube
        Position and speed at the time, the force of the wall, and the motion until then.

    Raises
    ------
    UsageError
        When a spring is given without the mass.
    InadmissibleError
        When the tube does not turn.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 8.5 and 11.7.

    Examples
    --------
    >>> round(tube(rotation=2.0, start=0.1, time=0.5).position, 9)
    0.154308063
    """
    require(rotation != 0.0, "the tube does not turn", code="at-rest", hint="give a rotation above zero")
    require((steps >= 1) & (steps <= MOST_ROWS), "the motion cannot have {steps} rows", code="steps", steps=steps)
    if spring is not None and mass is None:
        raise UsageError("a spring without the mass", code="missing", parameter="mass", hint="give --mass")
    pull = spring.stiffness / mass if spring is not None and mass is not None else 0.0 * rotation
    free = spring.free_length if spring is not None else 0.0 * start
    upright = plane == "vertical"
    turning = abs(rotation)

    def at(moment: float) -> "tuple[float, float]":
        return _state(turning, pull, free, start, start_speed, gravity if upright else None, moment)

    position, speed = at(time)
    weight = gravity if upright else 0.0 * gravity
    stiff = pull - turning * turning
    level = turning * time
    return Tube(
        position=position,
        speed=speed,
        total_speed=sqrt(speed * speed + (turning * position) * (turning * position)),
        acceleration=pull * free - stiff * position - weight * sin(level),
        wall_force=None if mass is None else mass * (2.0 * turning * speed + weight * cos(level)),
        motion="oscillates" if plain(stiff) > 0.0 else "goes on outwards or inwards without end",
        rest=pull * free / stiff if spring is not None and not upright and plain(stiff) > 0.0 else None,
        path=tuple(Moment(time * k / steps, *at(time * k / steps)) for k in range(steps + 1)),
    )


def _state(
    turning: float, pull: float, free: float, start: float, speed: float, weight: "float | None", time: float
) -> "tuple[float, float]":
    """Position and speed: the free motion about the place of rest, and what gravity adds."""
    stiff = pull - turning * turning
    if plain(stiff) > 0.0:
        own = sqrt(stiff)
        level, rise, fall = cos(own * time), sin(own * time) / own, -own * sin(own * time)
    elif plain(stiff) < 0.0:
        own = sqrt(-stiff)
        level, rise, fall = cosh(own * time), sinh(own * time) / own, own * sinh(own * time)
    else:
        level, rise, fall = 1.0 + 0.0 * time, time, 0.0 * time
    # ∫∫ of the constant force of the spring: (1 − level)/stiff, which is t²/2 where both are nothing
    grown = 2.0 * _half_rise(stiff, time) if plain(stiff) != 0.0 else 0.5 * time * time
    push = pull * free
    position = start * level + speed * rise + push * grown
    rate = start * fall + speed * level + push * rise
    if weight is not None:
        sank, sinks = _gravity(turning, stiff, weight, level, rise, time)
        position, rate = position + sank, rate + sinks
    return position, rate


def _half_rise(stiff: float, time: float) -> float:
    """(1 − cos √w·t)/(2w) = sin²(½√w·t)/w, or with hyperbolic functions."""
    if plain(stiff) > 0.0:
        sine = sin(0.5 * sqrt(stiff) * time)
        return sine * sine / stiff
    sine = sinh(0.5 * sqrt(-stiff) * time)
    return sine * sine / -stiff


def _gravity(
    turning: float, stiff: float, weight: float, level: float, rise: float, time: float
) -> "tuple[float, float]":
    """What −g·sin Ωt adds to position and speed from rest at nothing."""
    u = turning * time
    if plain(stiff) > 0.0:
        # both turn at nearly one rate in resonance: differences of sines as products
        own = sqrt(stiff)
        apart = (stiff - turning * turning) / (own + turning)
        half = 0.5 * apart * time
        beat = 0.5 * time * (sin(half) / half if plain(half) != 0.0 else 1.0 + half)
        mean = 0.5 * (own + turning) * time
        both = own + turning
        return -weight * (rise - 2.0 * cos(mean) * beat) / both, -2.0 * weight * turning * sin(mean) * beat / both
    if plain(stiff) == -plain(turning) * plain(turning) and plain(u) < SERIES:
        # sin u − sinh u = −2·(u³/3! + u⁷/7! + …), cos u − cosh u = −2·(u²/2! + u⁶/6! + …)
        fourth = u * u * u * u
        sank = u * u * u / 6.0 * (1.0 + fourth / 840.0 * (1.0 + fourth / 7920.0 * (1.0 + fourth / 32760.0)))
        sinks = u * u / 2.0 * (1.0 + fourth / 360.0 * (1.0 + fourth / 5040.0 * (1.0 + fourth / 24024.0)))
        return -weight * sank / (turning * turning), -weight * sinks / turning
    apart = stiff - turning * turning
    return -weight * (sin(u) - turning * rise) / apart, -weight * turning * (cos(u) - level) / apart


@record
class Hoop:
    """Equilibria of a bead on a turning hoop."""

    critical_rotation: Annotated[ShaftSpeed, "Above it the bottom is unstable and a tilted place is stable [rad/s]."]
    bottom: Annotated[Text, "Whether the bottom is stable."]
    bottom_frequency: Annotated[Frequency | None, "Small oscillations about the bottom; where it is stable [Hz]."]
    bottom_growth: Annotated[GrowthRate | None, "Rate at which it leaves the bottom; where it is unstable [1/s]."]
    angle: Annotated[Angle | None, "The tilted equilibrium, from the bottom; above the critical rotation [rad]."]
    frequency: Annotated[Frequency | None, "Small oscillations about it [Hz]."]
    height: Annotated[Length | None, "Its height above the bottom [m]."]
    force: Annotated[Force | None, "Force of the tube there; with the mass [N]."]


def hoop(
    *,
    radius: Annotated[Length, "Radius of the hoop, e.g. 0.25 m."],
    rotation: Annotated[ShaftSpeed, "How fast it turns about its vertical diameter, e.g. 80 rpm."],
    mass: Annotated[Mass | None, "Mass of the bead, for the force, e.g. 0.1 kg."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Hoop:
    """A bead in a smooth circular tube that turns about its vertical diameter: equilibria and their frequencies.

    Equation
    --------
    cos θ = g/(a·Ω²) where Ω² > g/a; frequencies √((Ω_c − Ω)·(Ω_c + Ω)) at the bottom, Ω·sin θ at the tilted place.

    Returns
    -------
    Hoop
        The critical rotation, the equilibria and what small disturbances do.

    Raises
    ------
    InadmissibleError
        When the radius is not above zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 8.5 and 14.3.

    Examples
    --------
    >>> round(hoop(radius=0.25, rotation=8.0).frequency * 6.283185307179586, 9)
    6.321186909
    """
    require(radius > 0.0, "the radius of {radius} is not above zero", radius=(radius, Length))
    critical, turning = sqrt(gravity / radius), abs(rotation)
    two_pi = 2.0 * pi_beside(radius, rotation, gravity)
    squared = (critical - turning) * (critical + turning)
    if plain(squared) >= 0.0:
        return Hoop(
            critical_rotation=critical,
            bottom="stable" if plain(squared) > 0.0 else "stable, but without stiffness: at the critical rotation",
            bottom_frequency=sqrt(squared) / two_pi,
            bottom_growth=None,
            angle=None,
            frequency=None,
            height=None,
            force=None,
        )
    growth = sqrt(-squared)
    cosine = gravity / (radius * turning * turning)
    sine = growth * sqrt(turning * turning + critical * critical) / (turning * turning)
    return Hoop(
        critical_rotation=critical,
        bottom="unstable",
        bottom_frequency=None,
        bottom_growth=growth,
        angle=atan2(sine, cosine),
        frequency=turning * sine / two_pi,
        height=radius * sine * sine / (1.0 + cosine),
        force=None if mass is None else mass * radius * turning * turning,
    )
