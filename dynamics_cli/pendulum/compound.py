"""The tasks `compound` and `rod`: a rigid body swinging about a pivot."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import cos, pi_beside, sin, sqrt
from dynamics_cli.numerics.elliptic import mean
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Force,
    Gravity,
    Inertia,
    Length,
    Mass,
    Ratio,
    Size,
    Time,
    TurnRate,
)
from dynamics_cli.records import record

PI = 3.141592653589793


@record
class PivotInertia:
    """A body by its moment of inertia about the pivot."""

    inertia: Annotated[Inertia, "Moment of inertia about the pivot, e.g. 0.48 kg*m^2."]


@record
class CentralInertia:
    """A body by its moment of inertia about its own centre of mass."""

    central_inertia: Annotated[Inertia, "Moment of inertia about the centre of mass, e.g. 0.12 kg*m^2."]


@record
class Gyration:
    """A body by its radius of gyration."""

    gyration: Annotated[Size, "Radius of gyration about the centre of mass, e.g. 300 mm."]


@record
class Compound:
    """How a body swings about a pivot."""

    period: Annotated[Time, "Time of a full swing, there and back [s]."]
    small_period: Annotated[Time, "Period of small swings [s]."]
    slowdown: Annotated[Ratio, "The period over that of small swings [-]."]
    equivalent_length: Annotated[
        Length, "Length of the simple pendulum of the same period; to the centre of percussion [m]."
    ]
    conjugate_distance: Annotated[Length, "A pivot so far on the other side of the centre has the same period [m]."]
    quickest_distance: Annotated[Length, "Distance of the pivot of least period: the radius of gyration [m]."]
    least_period: Annotated[Time, "The small period of a pivot there [s]."]
    inertia: Annotated[Inertia | None, "Moment of inertia about the pivot; with the mass [kg*m^2]."]
    rate: Annotated[TurnRate | None, "Angular velocity at the angle asked for [rad/s]."]
    along_force: Annotated[Force | None, "Force of the pivot towards the centre's opposite side, along the body [N]."]
    across_force: Annotated[Force | None, "Force of the pivot across the body, against its weight's pull [N]."]
    pin_force: Annotated[Force | None, "The two together [N]."]


def compound(
    *,
    mass: Annotated[Mass, "Mass of the body, e.g. 2 kg."],
    distance: Annotated[Length, "From the pivot to the centre of mass, e.g. 0.6 m."],
    body: Annotated[PivotInertia | CentralInertia | Gyration, "How its mass is spread."],
    amplitude: Annotated[Angle, "Largest angle from the vertical, e.g. 60 deg."] = 0.0,
    angle: Annotated[Angle | None, "An angle for the forces of the pivot, e.g. 20 deg."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Compound:
    """A rigid body swinging about a fixed pivot: period, centre of percussion, pivots of equal and of least period.

    Equation
    --------
    T = 2π·√(I/(m·g·d))/M(1, cos ½θ₀); pin along the body m·g·cos θ + m·d·ω², across it m·g·sin θ·(1 − m·d²/I), with
    ω² = 2·m·g·d·(cos θ − cos θ₀)/I.

    Returns
    -------
    Compound
        Period, lengths and, at an angle, the forces of the pivot.

    Raises
    ------
    InadmissibleError
        When mass, distance or inertia is not above zero, the inertia about the pivot is less than m·d², the
        amplitude is 180 degrees or more, or the angle lies beyond it.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 8.9.

    Examples
    --------
    >>> body = CentralInertia(2.0 * 1.2**2 / 12.0)
    >>> round(compound(mass=2.0, distance=0.6, body=body).small_period, 9)
    1.794587028
    """
    require(mass > 0.0, "the mass of {mass} is not above zero", mass=(mass, Mass))
    require(distance > 0.0, "the pivot is at the centre of mass: the body does not swing", code="centre",
            hint="give the distance from the pivot to the centre of mass")  # fmt: skip
    require(
        abs(amplitude) < PI, "the amplitude is {amplitude}; it must be below 180 deg", amplitude=(amplitude, Angle),
        code="at-top", hint="give an amplitude below 180 deg",
    )  # fmt: skip
    inertia, gyration = _inertia(body, mass, distance)
    pi = pi_beside(mass, distance, gravity, amplitude)
    length = inertia / (mass * distance)
    small = 2.0 * pi * sqrt(length / gravity)
    complement = cos(0.5 * amplitude)
    slow = 1.0 / mean(1.0 + 0.0 * complement, complement)
    rate = along = across = pin = None
    if angle is not None:
        rate, along, across = _forces(mass, distance, inertia, gyration, amplitude, angle, gravity)
        pin = sqrt(along * along + across * across)
    return Compound(
        period=small * slow,
        small_period=small,
        slowdown=slow,
        equivalent_length=length,
        conjugate_distance=gyration * gyration / distance,
        quickest_distance=gyration,
        least_period=2.0 * pi * sqrt(2.0 * gyration / gravity),
        inertia=inertia,
        rate=rate,
        along_force=along,
        across_force=across,
        pin_force=pin,
    )


def rod(
    *,
    length: Annotated[Length, "Length of the uniform rod, pinned at its end, e.g. 1.2 m."],
    mass: Annotated[Mass | None, "Its mass, for the forces of the pivot, e.g. 2 kg."] = None,
    amplitude: Annotated[Angle, "Largest angle from the vertical, e.g. 60 deg."] = 0.0,
    angle: Annotated[Angle | None, "An angle for the forces of the pivot, e.g. 20 deg."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Compound:
    """A uniform rod swinging about its end: period, pivots of equal and of least period, forces of the pivot.

    Equation
    --------
    T = 2π·√(2L/(3g))/M(1, cos ½θ₀); pin along the rod ½·m·g·(5·cos θ − 3·cos θ₀), across it ¼·m·g·sin θ.

    Returns
    -------
    Compound
        Period, lengths and, at an angle, the forces of the pivot.

    Raises
    ------
    InadmissibleError
        When the length is not above zero, the amplitude is 180 degrees or more, or the angle lies beyond it.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 8.9.

    Examples
    --------
    >>> round(rod(length=1.2, amplitude=1.0471975511965976).period, 9)
    1.925918508
    """
    require(length > 0.0, "the length of {length} is not above zero", length=(length, Length))
    weight = 1.0 + 0.0 * length if mass is None else mass
    body = CentralInertia(weight * length * length / 12.0)
    made = compound(mass=weight, distance=0.5 * length, body=body, amplitude=amplitude, angle=angle, gravity=gravity)
    if mass is not None:
        return made
    return Compound(**{**made.__dict__, "inertia": None, "along_force": None, "across_force": None, "pin_force": None})


def _inertia(body: "PivotInertia | CentralInertia | Gyration", mass: float, distance: float) -> "tuple[float, float]":
    """Moment of inertia about the pivot, and the radius of gyration about the centre."""
    if isinstance(body, CentralInertia):
        require(body.central_inertia > 0.0, "the moment of inertia is not above zero")
        return body.central_inertia + mass * distance * distance, sqrt(body.central_inertia / mass)
    if isinstance(body, Gyration):
        require(body.gyration > 0.0, "the radius of gyration is not above zero")
        return mass * (body.gyration * body.gyration + distance * distance), body.gyration
    central = body.inertia - mass * distance * distance
    require(
        central > 0.0, "a moment of inertia of {inertia} about the pivot is below mass times distance squared, {least}",
        inertia=(body.inertia, Inertia), least=(mass * distance * distance, Inertia), code="impossible-body",
        hint="give the moment about the pivot; that about the centre is --central-inertia",
    )  # fmt: skip
    return body.inertia, sqrt(central / mass)


def _forces(
    mass: float, distance: float, inertia: float, gyration: float, amplitude: float, angle: float, gravity: float
) -> "tuple[float, float, float]":
    """Angular velocity, and the forces of the pivot along the body and across it, after a start from rest."""
    require(
        abs(plain(angle)) <= abs(plain(amplitude)), "{angle} lies beyond the amplitude of {amplitude}",
        angle=(angle, Angle), amplitude=(amplitude, Angle), code="beyond", hint="give an angle within the swing",
    )  # fmt: skip
    # cos θ − cos θ₀ without cancellation
    fallen = 2.0 * sin(0.5 * (amplitude + angle)) * sin(0.5 * (amplitude - angle))
    rate = sqrt(2.0 * mass * gravity * distance * abs(fallen) / inertia)
    along = mass * gravity * cos(angle) + mass * distance * rate * rate
    across = mass * gravity * sin(angle) * (mass * gyration * gyration / inertia)
    return rate, along, across
