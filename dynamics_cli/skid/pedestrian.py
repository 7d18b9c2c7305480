"""Pedestrian throw: the speed at which a body was projected, from how far it came to rest (Searle)."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import (
    absolute,
    atan,
    atan2,
    cos,
    hypot,
    maximum,
    multiply_add,
    sin,
    sqrt,
    tan,
    where,
)
from dynamics_cli.quantities import STANDARD_GRAVITY, Angle, Distance, Friction, Gravity, RoadSpeed, Time
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.diagnostics import DEGREES, balance, friction_advice, plain, require_kept, single
from dynamics_cli.skid.drag import RIGHT_ANGLE


@record
class Throw:
    """Projection speed of a thrown pedestrian and its bounds.

    Parameters
    ----------
    least_speed : RoadSpeed
        No smaller projection speed reaches the throw distance, whatever the angle [m/s].
    greatest_speed : RoadSpeed
        Speed of a level launch: no greater one stays within it, for launch angles from zero to the greatest angle
        [m/s].
    greatest_angle : Angle
        Launch angle up to which the greatest speed holds: 2 atan μ, or less when landing stops the body before [rad].
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
    v = √(2μg r)/(cos α + μ sin α), r = s − μH; √(2μg r/(1 + μ²)) ≤ v always. For 0 ≤ α ≤ α_g no more than a level
    launch needs: v ≤ √(2μg r), α_g = 2 atan μ while (1 + μ²) k ≥ 4μ², k = 1 − μH/r, else
    tan α_g = (2μ + √(4μ² − k²)) r/s; and v ≤ s √(g/(2H)), tan α_g = s/H, when k < 0.

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
    Level ground; the landing takes the vertical speed w and μw of the horizontal one, or all of it when it is less,
    then friction slows the slide. Both bounds count the launches that end where the body lands: at the speed of a level
    launch the landing stops it above sin² α = k/(1 + μ²), which for H = 0 is 90° − atan μ. For H = 0 the greatest angle
    is 2 atan μ up to μ = tan 30°, and ½(180° − asin(1/(2μ))) above.

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
    sliding = sqrt(2.0 * gravity * (friction * reach))
    require_kept(sliding > 0.0, "friction times the throw distance")
    least = sliding / hypot(1.0, friction)
    share = multiply_add(-2.0 * friction, launch_height, throw_distance) / reach
    # a level launch that the landing stops flies the whole way
    fall = where(share < 0.0, sqrt(2.0 * launch_height / gravity), 1.0)
    greatest = where(share < 0.0, throw_distance / fall, sliding)
    greatest_angle = _greatest_angle(friction, share, reach / throw_distance, throw_distance, launch_height)
    advice = friction_advice(friction) + _stop_advice(friction, share, greatest_angle)
    if launch_angle is None:
        return Throw(least_speed=least, greatest_speed=greatest, greatest_angle=greatest_angle, advice=advice)
    require(
        absolute(launch_angle) < RIGHT_ANGLE,
        "a launch at {0:.6g} degrees goes nowhere forward",
        launch_angle * DEGREES,
        code="launch-angle",
    )
    sine, cosine = sin(launch_angle), cos(launch_angle)
    gain = multiply_add(friction, sine, cosine)
    slope = tan(launch_angle)
    over_forward = multiply_add(friction, slope, 1.0)
    require(
        (gain > 0.0) & (over_forward > 0.0),
        "cos α + μ sin α is {0:.6g} at the launch angle {1:.6g} degrees: landing stops the body at once",
        gain,
        launch_angle * DEGREES,
        code="stops-at-landing",
    )
    speed = sliding / gain
    forward = speed * cosine
    # √(2gH) over the forward speed, without the speed
    landing, falling = _flight(slope, sqrt(launch_height / (friction * reach)) * over_forward)
    flight_time = forward * falling / gravity
    # the share of √(2μg r) left for the slide, from the form that subtracts less
    kept = where(slope >= 0.0, multiply_add(-friction, landing, 1.0), over_forward - friction * falling)
    left = kept / over_forward
    require(
        kept >= -1e-15,
        "landing stops the body at once: its horizontal speed {0:.6g} m/s is less than friction times the vertical "
        "one, {1:.6g} m/s",
        forward,
        friction * landing * forward,
        code="stops-at-landing",
    )
    left = maximum(left, 0.0)
    flight = forward * flight_time
    slide = reach * left * left
    return Throw(
        least_speed=least,
        greatest_speed=greatest,
        greatest_angle=greatest_angle,
        speed=speed,
        flight_time=flight_time,
        flight_distance=flight,
        slide_time=sliding * left / (friction * gravity),
        slide_distance=slide,
        checks=balance(
            "flight and slide make the throw",
            flight + slide,
            throw_distance,
            throw_distance,
            throw_distance,
            friction,
            launch_height,
            speed,
            reach,
        ),
        advice=advice + _angle_advice(launch_angle, greatest_angle),
    )


def _greatest_angle(friction: float, share: float, part: float, distance: float, height: float) -> float:
    """Largest angle at which the speed of a level launch reaches the distance; `part` is r/s."""
    slope = 2.0 * friction
    room = maximum(slope - share, 0.0) * (slope + share)
    flying = atan((slope + sqrt(maximum(room, 0.0))) * part)
    slides = _slides_there(friction, share)
    return where(share < 0.0, atan2(distance, height), where(slides, 2.0 * atan(friction), flying))


def _slides_there(friction: float, share: float) -> bool:
    """Whether a body launched at 2 atan μ still slides when it has landed."""
    return sqrt(maximum(share, 0.0)) * hypot(1.0, friction) >= 2.0 * friction


def _flight(slope: float, drop: float) -> tuple[float, float]:
    """Vertical speed at landing and g times the time in the air, per forward speed; so is `drop`, √(2gH).

    The time comes from whichever root does not cancel.
    """
    landing = hypot(slope, drop)
    both = absolute(slope) + landing
    return landing, where(slope >= 0.0, both, drop * (drop / where(both > 0.0, both, 1.0)))


def _stop_advice(friction: float, share: float, greatest_angle: float) -> tuple[Advice, ...]:
    if not single(friction, share) or (plain(share) >= 0.0 and _slides_there(friction, share)):
        return ()
    from_angle = plain(atan2(sqrt(maximum(share, 0.0)), sqrt(multiply_add(friction, friction, 1.0 - share))))
    return (
        Advice(
            code="may-stop-at-landing",
            message=f"launched at the greatest speed above {from_angle * DEGREES:.4g} degrees the body stops where it "
            f"lands: that speed holds up to {plain(greatest_angle) * DEGREES:.4g} degrees, not 2 atan μ = "
            f"{2.0 * plain(atan(friction)) * DEGREES:.4g} degrees",
            severity="note",
        ),
    )


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
