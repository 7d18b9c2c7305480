"""Vault: the speed at which a vehicle left the ground, from where it landed."""

from dynamics_cli.errors import UsageError, require, worded
from dynamics_cli.numerics.elementary import absolute, atan2, cos, hypot, multiply_add, sin, sqrt, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Distance,
    Gravity,
    Length,
    RoadSpeed,
    Time,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.diagnostics import balance
from dynamics_cli.skid.drag import RIGHT_ANGLE


@record
class Vault:
    """A flight from take-off to landing."""

    speed: Annotated[RoadSpeed, "Speed at take-off [m/s]."]
    launch_angle: Annotated[
        Angle, "Angle of the take-off above the horizontal: as given, or that of the minimum speed [rad]."
    ]
    flight_time: Annotated[Time, "Time in the air [s]."]
    landing_speed: Annotated[RoadSpeed, "Speed at landing [m/s]."]
    landing_angle: Annotated[Angle, "Angle of the path at landing below the horizontal [rad]."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def least_speed_suffices(**inputs: object) -> str | None:
    """Why the least speed over all angles answers, or None when a take-off angle is given."""
    if inputs.get("take_off") is not None:
        return None
    return "no take-off angle is given: no lower speed could have reached the landing point"


def vault_least_speed(
    *,
    distance: Annotated[Distance, "Horizontal distance from take-off to landing [m]."],
    rise: Annotated[Length, "Height of the landing above the take-off, negative when lower [m]."] = 0.0,
    take_off: Annotated[
        Angle | None, "Angle of the take-off above the horizontal; if given, it determines the speed, e.g. 6 deg [rad]."
    ] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Vault:
    """Minimum take-off speed, over all take-off angles, with which a vehicle reaches the landing point.

    Equation
    --------
    v² = g (y + √(x² + y²)), at tan α = (y + √(x² + y²))/x; for y < 0 the sum is written x²/(√(x² + y²) − y).

    Returns
    -------
    Vault
        The least speed, its angle, and time, speed and angle of the landing.

    Raises
    ------
    InadmissibleError
        When the distance is zero.

    Notes
    -----
    A point mass in flight without air drag. The least speed is a lower bound for every take-off angle; there the path
    at take-off is perpendicular to the path at landing.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 8 (projectile motion); the least speed
    as commonly published in accident reconstruction.

    Examples
    --------
    >>> round(vault_least_speed(distance=20.0, rise=-2.0).speed, 4)
    13.3228
    """
    _require_way(distance)
    slant = hypot(distance, rise)
    long = slant + absolute(rise)
    short = distance * (distance / long)
    up = where(rise >= 0.0, long, short)
    down = where(rise >= 0.0, short, long)
    speed = sqrt(gravity * up)
    landing = sqrt(gravity * down)
    advice: tuple[Advice, ...] = ()
    if take_off is not None:
        advice = (
            Advice(
                code="take-off-unused",
                message="the minimum speed is taken over all take-off angles: the angle given was not used",
                severity="note",
            ),
        )
    return Vault(
        speed=speed,
        launch_angle=atan2(up, distance),
        flight_time=hypot(distance, up) / speed,
        landing_speed=landing,
        landing_angle=atan2(distance, up),
        checks=_energy_check(speed, landing, distance, rise, gravity),
        advice=advice,
    )


def vault_known_angle(
    *,
    distance: Annotated[Distance, "Horizontal distance from take-off to landing [m]."],
    rise: Annotated[Length, "Height of the landing above the take-off, negative when lower [m]."] = 0.0,
    take_off: Annotated[Angle | None, "Angle of the take-off above the horizontal, e.g. 6 deg [rad]."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Vault:
    """Take-off speed of a vehicle that left the ground at a known angle and landed at a known place.

    Equation
    --------
    v = x √(g/(2 cos α (x sin α − y cos α))).

    Returns
    -------
    Vault
        The speed, and time, speed and angle of the landing.

    Raises
    ------
    InadmissibleError
        When the distance is zero, the take-off angle is not within ±90 degrees, or the take-off does not point above
        the landing point.
    UsageError
        When no take-off angle is given.

    Notes
    -----
    A point mass in flight without air drag. The speed grows without limit as the take-off nears the line of sight to
    the landing point, or the vertical.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 8 (projectile motion).

    Examples
    --------
    >>> round(vault_known_angle(distance=20.0, rise=-2.0, take_off=0.1).speed, 4)
    22.236
    """
    if take_off is None:
        raise UsageError(
            "the known-angle model needs the take-off angle",
            parameter="take_off",
            hint="give take-off, or leave the model to be chosen",
        )
    _require_way(distance)
    require(
        absolute(take_off) < RIGHT_ANGLE,
        "a take-off at {angle} does not go forward",
        code="take-off",
        angle=(take_off, Angle),
    )
    sine, cosine = sin(take_off), cos(take_off)
    over = multiply_add(distance, sine, -rise * cosine)
    require(
        over > 0.0,
        "a take-off at {angle} cannot land there: it must point above {least}",
        code="cannot-land",
        angle=(take_off, Angle),
        least=(atan2(rise, distance), Angle),
    )
    speed = sqrt(gravity * distance * (distance / (2.0 * cosine * over)))
    # the landing's direction, times the take-off's speed
    fall = (over - rise * cosine) / distance
    landing = speed * hypot(cosine, fall)
    return Vault(
        speed=speed,
        launch_angle=take_off,
        flight_time=distance / (speed * cosine),
        landing_speed=landing,
        landing_angle=atan2(fall, cosine),
        checks=_energy_check(speed, landing, distance, rise, gravity),
        advice=_sight_advice(take_off, over, hypot(distance, rise)),
    )


def _require_way(distance: float) -> None:
    require(distance > 0.0, "the distance of a flight must be more than zero", code="no-way")


def _sight_advice(take_off: float, over: float, slant: float) -> tuple[Advice, ...]:
    """Advice when the take-off points only slightly above the line of sight, where the speed grows without limit."""
    if not single(take_off, over, slant) or plain(over) > 0.02 * plain(slant):
        return ()
    message = worded(
        "the take-off points only {above:3} above the landing point: an error of a tenth of that angle changes "
        "the speed by 5 %",
        above=(plain(over) / plain(slant), Angle),
    )
    remedy = "measure the take-off angle more closely, or leave it out for the minimum speed"
    return (Advice(code="near-line-of-sight", message=message, severity="serious", remedy=remedy),)


def _energy_check(speed: float, landing: float, distance: float, rise: float, gravity: float) -> tuple[Check, ...]:
    gained = 2.0 * gravity * rise
    return balance(
        "energy balance",
        speed * speed - landing * landing,
        gained,
        speed * speed + landing * landing + absolute(gained),
        speed,
        landing,
        distance,
        rise,
    )
