"""The tasks `impulse` and `draw-in`: what forces over a time, or a change of inertia, do to a motion."""

from dynamics_cli.energy.work import LINES, Between, area
from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    AngularImpulse,
    Annotated,
    Force,
    Impulse,
    Inertia,
    Mass,
    PotentialEnergy,
    Ratio,
    ShaftSpeed,
    Speed,
    Time,
)
from dynamics_cli.records import record


@record
class Steady:
    """A constant force, or the mean of one."""

    force: Annotated[Force, "A constant or mean force, e.g. -800 N."]
    time: Annotated[Time, "How long it acts, e.g. 0.2 s."]


@record
class Measured:
    """A force that was recorded over time."""

    times: Annotated[tuple[Time, ...], "Times of the samples, e.g. 0, 2, 5, 9 ms."]
    forces: Annotated[tuple[Force, ...], "Force at each, e.g. 0, 900, 1400, 0 N."]
    between: Annotated[Between, "What the force does between two times."] = LINES


@record
class Stopped:
    """A speed that is reached within a time."""

    end_speed: Annotated[Speed, "Speed at the end, for the mean force, e.g. 0 m/s."]
    duration: Annotated[Time, "Time within which it is reached, e.g. 50 ms."]


@record
class Change:
    """What an impulse does."""

    impulse: Annotated[Impulse, "Impulse of the force [N·s]."]
    mean_force: Annotated[Force, "Mean force over the time [N]."]
    greatest_force: Annotated[Force | None, "Largest sample of the force; of a record [N]."]
    duration: Annotated[Time, "Time that it acts [s]."]
    change: Annotated[Speed | None, "Change of the speed; with the mass [m/s]."]
    end_speed: Annotated[Speed | None, "Speed at the end; with the mass [m/s]."]
    work: Annotated[PotentialEnergy | None, "Change of the kinetic energy; with the mass [J]."]


def impulse(
    *,
    cause: Annotated[Steady | Measured | Stopped, "A force over a time, a record of one, or the speed it reaches."],
    mass: Annotated[Mass | None, "Mass of the body, e.g. 70 kg."] = None,
    start_speed: Annotated[Speed, "Speed at the start, along the force positive, e.g. -12 m/s."] = 0.0,
) -> Change:
    """Impulse of a force over time, and the speed that it gives; or the mean force that changes a speed in a time.

    Equation
    --------
    J = ∫ F dt = m·(v₂ − v₁), mean F = J/T.

    Returns
    -------
    Change
        Impulse, mean force, and with the mass the change of speed.

    Raises
    ------
    InadmissibleError
        When the time or the mass is zero, or samples are fewer than two, unequal in number, or out of order.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.2 and 9.5.

    Examples
    --------
    >>> impulse(cause=Steady(-800.0, 0.5), mass=80.0, start_speed=5.0).end_speed
    0.0
    """
    require(mass is None or mass > 0.0, "a body without mass has no momentum", code="mass",
            hint="give a mass above zero")  # fmt: skip
    greatest = None
    if isinstance(cause, Stopped):
        require(mass is not None, "without its mass the force of a change of speed is unknown", code="mass",
                hint="give --mass")  # fmt: skip
        duration = cause.duration
        momentum = (mass or 0.0) * (cause.end_speed - start_speed)
    elif isinstance(cause, Steady):
        duration, momentum = cause.time, cause.force * cause.time
    else:
        momentum = area(cause.times, cause.forces, str(cause.between), Time, "times")
        duration = cause.times[-1] - cause.times[0]
        greatest = max(cause.forces, key=lambda force: abs(plain(force)))
    require(duration > 0.0, "a force that acts for no time has no impulse", code="time", hint="give a time above zero")
    change = end = gained = None
    if mass is not None:
        change = momentum / mass
        end = start_speed + change if not isinstance(cause, Stopped) else cause.end_speed
        gained = 0.5 * momentum * (start_speed + end)
    return Change(momentum, momentum / duration, greatest, duration, change, end, gained)


@record
class Drawn:
    """A turning body whose moment of inertia has changed."""

    end_rotation: Annotated[ShaftSpeed, "Its speed then [rad/s]."]
    work: Annotated[PotentialEnergy, "Work of the force that draws it in; negative when let out [J]."]
    energy_ratio: Annotated[Ratio, "Kinetic energy over that at the start [-]."]
    angular_momentum: Annotated[AngularImpulse, "Angular momentum, which stays [N·m·s]."]


def draw_in(
    *,
    inertia: Annotated[Inertia, "Moment of inertia at the start, e.g. 5 kg*m^2."],
    end_inertia: Annotated[Inertia, "Moment of inertia at the end, e.g. 1.2 kg*m^2."],
    rotation: Annotated[ShaftSpeed, "Speed at the start, e.g. 2 rad/s."],
) -> Drawn:
    """A body that turns freely and draws its mass in or lets it out: its speed then, and the work that it takes.

    Equation
    --------
    I₁·ω₁ = I₂·ω₂, W = ½·I₁·ω₁²·(I₁ − I₂)/I₂.

    Returns
    -------
    Drawn
        Speed, work, and the ratio of energies.

    Raises
    ------
    InadmissibleError
        When a moment of inertia is not above zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.7 and 10.4.

    Examples
    --------
    >>> round(draw_in(inertia=5.0, end_inertia=1.2, rotation=2.0).work, 12)
    31.666666666667
    """
    for value in (inertia, end_inertia):
        require(value > 0.0, "a moment of inertia of {value} is not above zero", value=(value, Inertia), code="inertia")
    ratio = inertia / end_inertia
    return Drawn(
        end_rotation=ratio * rotation,
        work=0.5 * inertia * rotation * rotation * ((inertia - end_inertia) / end_inertia),
        energy_ratio=ratio,
        angular_momentum=inertia * rotation,
    )
