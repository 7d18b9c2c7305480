"""The tasks `power` and `drive`: power of forces and torques, and what a vehicle needs."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import atan, cos, sin, summed
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Angle,
    Annotated,
    Area,
    Density,
    Force,
    Fraction,
    Friction,
    Gravity,
    Mass,
    PotentialEnergy,
    Power,
    RoadSpeed,
    ShaftSpeed,
    Slope,
    Speed,
    Time,
    Torque,
)
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Newton's method for a convex cubic from above: it doubles the digits from the second step on.
STEPS = 60
CLOSE = 1e-15


@record
class Straight:
    """A force on a point that moves."""

    force: Annotated[Force, "A force, e.g. 400 N."]
    speed: Annotated[Speed, "Speed of its point of application, e.g. 12 m/s."]
    angle: Annotated[Angle, "Angle between force and motion, e.g. 20 deg."] = 0.0


@record
class Turning:
    """A torque on a shaft."""

    torque: Annotated[Torque, "A torque on a shaft, e.g. 150 N*m."]
    rotation: Annotated[ShaftSpeed, "Speed of the shaft, e.g. 3000 rpm."]


@record
class Output:
    """What is done with a power."""

    power: Annotated[Power, "Power of the force or torque [W]."]
    input_power: Annotated[Power | None, "Power that must be put in for it; with the efficiency [W]."]
    loss: Annotated[Power | None, "Power lost on the way; with the efficiency [W]."]
    energy: Annotated[PotentialEnergy | None, "Energy over the time [J]."]


def power(
    *,
    load: Annotated[Straight | Turning, "A force on a point that moves, or a torque on a shaft."],
    efficiency: Annotated[Fraction | None, "Efficiency between the source and here, e.g. 90 %."] = None,
    time: Annotated[Time | None, "A time, for the energy, e.g. 30 s."] = None,
) -> Output:
    """Power of a force or a torque, what must be put in for it, and the energy over a time.

    Equation
    --------
    P = F·v·cos α or M·ω; put in P/η; E = P·t.

    Returns
    -------
    Output
        The power, what is put in and lost, the energy.

    Raises
    ------
    InadmissibleError
        When the efficiency is zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.4.

    Examples
    --------
    >>> power(load=Straight(400.0, 12.0)).power
    4800.0
    """
    result = load.torque * load.rotation if isinstance(load, Turning) else load.force * load.speed * cos(load.angle)
    given = None
    if efficiency is not None:
        require(efficiency > 0.0, "with an efficiency of zero no power arrives", code="efficiency",
                hint="give it above zero, e.g. 90 %")  # fmt: skip
        # a machine that is driven backwards gives back less than it takes up
        given = result / efficiency if plain(result) >= 0.0 else result * efficiency
    return Output(
        power=result,
        input_power=given,
        loss=None if given is None else given - result,
        energy=None if time is None else result * time,
    )


@record
class AtSpeed:
    """A speed is given."""

    speed: Annotated[RoadSpeed, "Speed, for the power, e.g. 90 km/h."]


@record
class WithPower:
    """A power is given."""

    power: Annotated[Power, "Power of the engine, for the top speed, e.g. 60 kW."]


@record
class Resistance:
    """What a vehicle needs at a speed."""

    power: Annotated[Power, "Power of the engine; if negative, the power of the brakes at the wheels [W]."]
    speed: Annotated[RoadSpeed, "Speed [m/s]."]
    force: Annotated[Force, "Force at the wheels [N]."]
    rolling: Annotated[Force, "Rolling resistance [N]."]
    climbing: Annotated[Force, "Force of the slope, below zero downhill [N]."]
    drag: Annotated[Force, "Drag of the air [N]."]
    inertia_force: Annotated[Force | None, "Force that accelerates; with an acceleration [N]."]


def drive(
    *,
    mass: Annotated[Mass, "Mass of the vehicle, e.g. 1500 kg."],
    at: Annotated[AtSpeed | WithPower, "A speed, or the power for a top speed."],
    slope: Annotated[Slope, "Slope of the road, uphill positive, e.g. 5 %."] = 0.0,
    rolling_resistance: Annotated[Friction, "Rolling resistance over the force on the road, e.g. 0.012."] = 0.0,
    drag_area: Annotated[Area, "Drag coefficient times frontal area, e.g. 0.7 m^2."] = 0.0,
    density: Annotated[
        Density, "Density of the air; ISO 2533 at sea level where none is given, e.g. 1.2 kg/m^3."
    ] = 1.225,
    acceleration: Annotated[Acceleration, "Acceleration wanted, e.g. 0.5 m/s^2."] = 0.0,
    efficiency: Annotated[Fraction, "Efficiency from the engine to the wheels, e.g. 92 %."] = 1.0,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Resistance:
    """Power that a vehicle needs at a speed, or the steady speed that a power gives.

    Equation
    --------
    F = m·g·(c_r·cos α + sin α) + ½·ρ·c_d·A·v² + m·a, P = F·v/η.

    Returns
    -------
    Resistance
        Power, speed, and the forces that make them.

    Raises
    ------
    InadmissibleError
        When the mass, the density or the efficiency is zero, or a power gives no steady speed.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.4; forces on a vehicle by Newton's law.

    Examples
    --------
    >>> car = {"mass": 1500.0, "slope": 0.05, "rolling_resistance": 0.012, "drag_area": 0.7, "density": 1.2}
    >>> result = drive(at=AtSpeed(25.0), **car)
    >>> round(result.power, 6)
    29334.514001
    """
    require(mass > 0.0, "the mass of {mass} is not above zero", mass=(mass, Mass))
    require(density > 0.0, "air without density has no drag", code="density", hint="leave out --drag-area instead")
    require(efficiency > 0.0, "with an efficiency of zero no power arrives", code="efficiency",
            hint="give it above zero, e.g. 92 %")  # fmt: skip
    angle = atan(slope)
    weight = mass * gravity
    rolling, climbing = rolling_resistance * weight * cos(angle), weight * sin(angle)
    pushing = mass * acceleration
    constant = summed([rolling, climbing, pushing])
    square = 0.5 * density * drag_area
    if isinstance(at, AtSpeed):
        speed = at.speed
        force = constant + square * speed * speed
        wheel = force * speed
        # downhill the engine's losses do not count: brakes take it at the wheels
        power = wheel / efficiency if plain(wheel) > 0.0 else wheel
    else:
        power = at.power
        require(power >= 0.0, "the power is {power}; it must not be negative", power=(power, Power), code="power",
                hint="give a power above zero; 0 kW for coasting")  # fmt: skip
        wheel = power * efficiency
        speed = _steady(square, constant, wheel)
        # not the sum of its parts, which cancel downhill
        force = wheel / speed if plain(speed) > 0.0 else constant
    return Resistance(
        power=power,
        speed=speed,
        force=force,
        rolling=rolling,
        climbing=climbing,
        drag=square * speed * speed,
        inertia_force=pushing if plain(acceleration) else None,
    )


def _steady(square: "Any", constant: "Any", wheel: "Any") -> "Any":
    """The speed at which the resistance takes the power at the wheels: the positive root of D·v³ + C·v = P."""
    if plain(square) == 0.0:
        require(constant > 0.0, "without resistance there is no steady speed", code="no-top",
                hint="give --drag-area or --rolling-resistance")  # fmt: skip
        return wheel / constant
    d, c, p = plain(square), plain(constant), plain(wheel)
    if p == 0.0 and c >= 0.0:
        return 0.0 * wheel / square
    root = (p / d) ** (1.0 / 3.0) + (-c / d) ** 0.5 if c < 0.0 else (p / d) ** (1.0 / 3.0)
    for _ in range(STEPS):
        step = (root * (d * root * root + c) - p) / (3.0 * d * root * root + c)
        root -= step
        if abs(step) <= CLOSE * root:
            break
    # one step on the numbers as they came, which carries what they know of their errors to the root
    slope = 3.0 * square * root * root + constant
    return root - (root * (square * root * root + constant) - wheel) / slope
