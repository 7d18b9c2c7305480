"""The task `fall`: a body dropped, with drag by the square of its speed, and its deflection by the turning earth."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, cos, exp, log, sqrt, tanh
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Distance,
    Gravity,
    Length,
    Speed,
    Time,
)
from dynamics_cli.records import record

# Turning rate of the earth [rad/s], IERS conventions.
EARTH = 7.292115e-5
QUARTER = 1.5707963267948966


@record
class Fall:
    """A fall from rest."""

    time: Annotated[Time, "Time of the fall [s]."]
    speed: Annotated[Speed, "Speed at its end [m/s]."]
    vacuum_time: Annotated[Time | None, "Time without drag; with drag [s]."]
    vacuum_speed: Annotated[Speed | None, "Speed without drag; with drag [m/s]."]
    steady_share: Annotated[float | None, "Speed over the terminal speed; with drag."]
    deflection: Annotated[Length | None, "Deflection to the east without drag; with the latitude [m]."]


def fall(
    *,
    height: Annotated[Distance, "Height of the fall, e.g. 100 m."],
    terminal_speed: Annotated[Speed | None, "Speed at which drag carries the weight, e.g. 60 m/s."] = None,
    latitude: Annotated[Angle | None, "Latitude, for the deflection, e.g. 45 deg."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Fall:
    """A body that falls from rest: time and speed, with drag by the square of the speed, and deflection to the east.

    Equation
    --------
    v² = 2·g·h, t = √(2h/g); with drag v² = v_t²·(1 − e^(−2gh/v_t²)),
    t = (v_t/g)·arcosh e^(gh/v_t²); east Ω·g·t³·cos λ/3.

    Returns
    -------
    Fall
        The fall with drag, and beside it without.

    Raises
    ------
    InadmissibleError
        When height or terminal speed is not above zero, or the latitude is beyond a pole.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.7.

    Examples
    --------
    >>> round(fall(height=100.0, latitude=0.7853981633974483).deflection, 6)
    0.015524
    """
    require(height > 0.0, "the height of {height} is not above zero", height=(height, Length))
    time, speed = sqrt(2.0 * height / gravity), sqrt(2.0 * height * gravity)
    deflection = None
    if latitude is not None:
        require(absolute(latitude) <= QUARTER, "a latitude of {latitude} lies beyond a pole",
        latitude=(latitude, Angle),
                code="latitude", hint="give an angle between -90 and 90 deg")  # fmt: skip
        deflection = EARTH * gravity * time * time * time * cos(latitude) / 3.0
    if terminal_speed is None:
        return Fall(
            time=time, speed=speed, vacuum_time=None, vacuum_speed=None, steady_share=None, deflection=deflection
        )
    require(terminal_speed > 0.0, "the terminal speed of {speed} is not above zero", speed=(terminal_speed, Speed))
    depth = gravity * height / (terminal_speed * terminal_speed)
    share = sqrt(_one_less(2.0 * depth))
    # arcosh e^d = d + ln(1 + √(1 − e^(−2d)))
    longer = (
        terminal_speed / gravity * (depth + log(1.0 + share))
        if plain(depth) > 0.1
        else _early(depth, terminal_speed, gravity)
    )
    return Fall(
        time=longer,
        speed=terminal_speed * share,
        vacuum_time=time,
        vacuum_speed=speed,
        steady_share=share,
        deflection=deflection,
    )


def _one_less(d: float) -> float:
    """1 − e^(−d) = 2·tanh(d/2)/(1 + tanh(d/2)), which does not cancel."""
    half = tanh(0.5 * d)
    return 2.0 * half / (1.0 + half)


def _early(depth: float, terminal: float, gravity: float) -> float:
    """Arcosh e^d = 2·arsinh √((e^d − 1)/2), for a fall that drag has hardly slowed."""
    grown = _one_less(depth) * exp(depth)
    root = sqrt(0.5 * grown)
    # arsinh x = ln(x + √(1 + x²)), formed as ln(1 + y) by its series in y/(2 + y)
    y = root + root * root / (1.0 + sqrt(1.0 + root * root))
    z = y / (2.0 + y)
    square, term = z * z, z
    total = z
    for k in range(3, 40, 2):
        term = term * square
        total = total + term / k
    return terminal / gravity * 4.0 * total
