"""Pedestrian throw: the speed at which a body was projected, from how far it came to rest (Searle)."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, atan, cos, hypot, maximum, multiply_add, sin, sqrt, where
from dynamics_cli.quantities import STANDARD_GRAVITY, Angle, Distance, Friction, Gravity, RoadSpeed, Time
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.diagnostics import DEGREES, balance, plain, single
from dynamics_cli.skid.drag import RIGHT_ANGLE


@record
class Throw:
    """Projection speed of a thrown pedestrian and its bounds.

    Parameters
    ----------
    least_speed : RoadSpeed
        No smaller projection speed reaches the throw distance, whatever the angle [m/s].
    greatest_speed : RoadSpeed
        No greater one stays within it, for launch angles from zero to the greatest angle [m/s].
    greatest_angle : Angle
        Launch angle up to which the greatest speed holds, 2 atan μ [rad].
    speed : RoadSpeed
        Projection speed; needs the launch angle [m/s].
    flight_time : Time
        Time in the air; needs the launch angle [s].
    flight_distance : Distance
        Horizontal distance in the air; needs the launch angle [m].
    slide_time : Time
        Time from the landing to rest; needs the launch angle [s].
    slide_distance : Distance
        Distance from the landing to rest; needs the launch angle [m].
    """

    least_speed: RoadSpeed
    greatest_speed: RoadSpeed
    greatest_angle: Angle
    speed: RoadSpeed | None = None
    flight_time: Time | None = None
    flight_distance: Distance | None = None
    slide_time: Time | None = None
    slide_distance: Distance | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def pedestrian(
    *,
    throw_distance: Distance,
    friction: Friction,
    launch_angle: Angle | None = None,
    launch_height: Distance = 0.0,
    gravity: Gravity = STANDARD_GRAVITY,
) -> Throw:
    """Projection speed of a pedestrian from the throw distance: its bounds, and itself when the launch angle is known.

    Equation
    --------
    v = √(2μg(s − μH))/(cos α + μ sin α); √(2μg(s − μH)/(1 + μ²)) ≤ v always, v ≤ √(2μg(s − μH)) for 0 ≤ α ≤ 2 atan μ.

    Parameters
    ----------
    throw_distance : Distance
        Horizontal distance from launch to rest [m].
    friction : Friction
        Coefficient of friction between the body and the ground [-].
    launch_angle : Angle
        Angle of the launch above the horizontal [rad].
    launch_height : Distance
        Height of the centre of mass at launch above its height at rest [m].
    gravity : Gravity
        Acceleration of gravity [m/s^2].

    Returns
    -------
    Throw
        Least and greatest speed; with the launch angle also the speed, and the flight and slide it is made of.

    Raises
    ------
    InadmissibleError
        When friction is zero, the throw distance does not exceed μH, the launch angle is not within ±90 degrees, or
        landing would stop the body at once (v cos α < μ √(v² sin² α + 2gH)), where the formula does not hold.

    Notes
    -----
    Level ground; the landing takes the vertical speed w and μw of the horizontal one, then friction slows the slide.
    The bounds assume that the body keeps sliding after it lands.

    References
    ----------
    Searle & Searle (SAE 831622, 1983) and Searle (1993), as commonly published; launch height and the condition on the
    landing derived from the motion described above.

    Examples
    --------
    >>> round(pedestrian(throw_distance=25.0, friction=0.66).least_speed, 4)
    15.0141
    """
    require(friction > 0.0, "friction {0:.6g} cannot stop a thrown body", friction, code="no-friction")
    reach = multiply_add(-friction, launch_height, throw_distance)
    require(
        reach > 0.0,
        "the throw distance {0:.6g} m must exceed friction × launch height, {1:.6g} m",
        throw_distance,
        friction * launch_height,
        code="throw-too-short",
    )
    greatest = sqrt(2.0 * gravity * (friction * reach))
    least = greatest / hypot(1.0, friction)
    greatest_angle = 2.0 * atan(friction)
    if launch_angle is None:
        return Throw(least_speed=least, greatest_speed=greatest, greatest_angle=greatest_angle)
    require(
        absolute(launch_angle) < RIGHT_ANGLE,
        "a launch at {0:.6g} degrees goes nowhere forward",
        launch_angle * DEGREES,
        code="launch-angle",
    )
    sine, cosine = sin(launch_angle), cos(launch_angle)
    gain = multiply_add(friction, sine, cosine)
    require(
        gain > 0.0,
        "cos α + μ sin α is {0:.6g} at the launch angle {1:.6g} degrees: landing stops the body at once",
        gain,
        launch_angle * DEGREES,
        code="stops-at-landing",
    )
    speed = greatest / gain
    upward, forward = speed * sine, speed * cosine
    flight_time, landing = _flight(upward, launch_height, gravity)
    # the speed left for the slide, from the form that subtracts less
    rising = multiply_add(-friction, landing, forward)
    left = where(upward >= 0.0, rising, multiply_add(-friction, gravity * flight_time, greatest))
    require(
        left >= -1e-15 * forward,
        "landing stops the body at once: its horizontal speed {0:.6g} m/s is less than friction times the vertical "
        "one, {1:.6g} m/s",
        forward,
        friction * landing,
        code="stops-at-landing",
    )
    left = maximum(left, 0.0)
    flight = forward * flight_time
    slide_time = left / (friction * gravity)
    slide = slide_time * (0.5 * left)
    return Throw(
        least_speed=least,
        greatest_speed=greatest,
        greatest_angle=greatest_angle,
        speed=speed,
        flight_time=flight_time,
        flight_distance=flight,
        slide_time=slide_time,
        slide_distance=slide,
        checks=balance("flight and slide make the throw", flight + slide, throw_distance, throw_distance),
        advice=_angle_advice(launch_angle, greatest_angle),
    )


def _flight(upward: float, height: float, gravity: float) -> tuple[float, float]:
    """Time in the air and vertical speed at landing, from whichever root does not cancel."""
    landing = hypot(upward, sqrt(2.0 * gravity * height))
    both = absolute(upward) + landing
    rising = both / gravity
    falling = 2.0 * height / where(both > 0.0, both, 1.0)
    return where(upward >= 0.0, rising, falling), landing


def _angle_advice(launch_angle: float, greatest_angle: float) -> tuple[Advice, ...]:
    if not single(launch_angle, greatest_angle) or 0.0 <= plain(launch_angle) <= plain(greatest_angle):
        return ()
    return (
        Advice(
            code="beyond-greatest-angle",
            message=f"the greatest speed holds for launches from 0 to {plain(greatest_angle) * DEGREES:.4g} degrees",
            mend="use the speed of this launch angle, or the least speed",
        ),
    )
