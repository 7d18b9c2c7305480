"""Pedestrian throw: the projection speed of a body from the distance to its rest position (Searle)."""

from dynamics_cli.errors import UsageError, require, worded
from dynamics_cli.numerics.elementary import (
    atan,
    atan2,
    cos,
    hypot,
    maximum,
    minimum,
    multiply_add,
    sin,
    sqrt,
    where,
)
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import friction_advice
from dynamics_cli.numerics.road.slide import require_kept
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Distance,
    Fraction,
    Friction,
    Gravity,
    Mass,
    Slope,
)
from dynamics_cli.records import Advice
from dynamics_cli.skid.diagnostics import balance
from dynamics_cli.skid.throw import Stages, Throw, require_launch, require_throw, stages, vehicle_share, vehicle_speed


def pedestrian(
    *,
    throw_distance: Annotated[Distance, "Horizontal distance from launch to rest [m]."],
    friction: Annotated[Friction, "Coefficient of friction between the body and the ground [-]."],
    launch_angle: Annotated[Angle | None, "Angle of the launch above the horizontal, e.g. 10 deg [rad]."] = None,
    launch_height: Annotated[Distance, "Height of the centre of mass at launch above its height at rest [m]."] = 0.0,
    grade: Annotated[Slope | None, "Rise over run along the throw, uphill positive; level unless given [-]."] = None,
    efficiency: Annotated[
        Fraction | None, "Projection efficiency: the body's projection speed over the vehicle's, e.g. 0.8 [-]."
    ] = None,
    body_mass: Annotated[Mass | None, "Mass of the body thrown, e.g. 75 kg [kg]."] = None,
    vehicle_mass: Annotated[
        Mass | None, "Mass of the vehicle, given together with that of the body, e.g. 1300 kg [kg]."
    ] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Throw:
    """Projection speed of a pedestrian or rider from the throw: its bounds, and its value if the launch angle is known.

    Equation
    --------
    v = √(2μg r)/(cos α + μ sin α), r = s − μH; √(2μg r/(1 + μ²)) ≤ v always. For 0 ≤ α ≤ α_g no more than a level
    launch needs: v ≤ √(2μg r), α_g = 2 atan μ while (1 + μ²) k ≥ 4μ², k = 1 − μH/r, else
    tan α_g = (2μ + √(4μ² − k²)) r/s; and v ≤ s √(g/(2H)), tan α_g = s/H, when k < 0.
    For s ≤ μH no body slides: v = s √(g/(2 cos α (H cos α + s sin α))), at least s √(g/(√(s² + H²) + H)).
    Vehicle: V = v (1 + m_b/m_v)/η.

    Returns
    -------
    Throw
        Least and greatest speed; with the launch angle also the speed, and its flight and slide.

    Raises
    ------
    InadmissibleError
        When friction or the throw distance is zero, the launch angle is not within ±90 degrees, the launch points below
        the place of rest (s ≤ μH), or landing would stop the body at once (v cos α < μ √(v² sin² α + 2gH), s > μH),
        where the formula does not hold; or a grade is given, which the model on a grade is for.

    Notes
    -----
    Level ground; the landing takes the vertical speed w and μw of the horizontal one, or all of it when it is less,
    then friction slows the slide. Both bounds count the launches that end where the body lands: at the speed of a level
    launch the landing stops it above sin² α = k/(1 + μ²), which for H = 0 is 90° − atan μ. For H = 0 the greatest angle
    is 2 atan μ up to μ = tan 30°, and ½(180° − asin(1/(2μ))) above.

    A body that slides came farther than μH: its throw is μH + (v_x + μ v_y)²/(2μg). The least speed √(2μg r/(1 + μ²)),
    r = s − μH, is that of a launch at atan μ; where the landing stops that one, as just above s = μH, the least speed
    is that of the shortest flight √(g (√(s² + H²) − H)), or of a throw that the landing just stops.

    References
    ----------
    Searle & Searle (SAE 831622, 1983) and Searle (1993), as commonly published; launch height and the condition on the
    landing derived from the motion described above.

    Examples
    --------
    >>> round(pedestrian(throw_distance=25.0, friction=0.66).least_speed, 4)
    15.0141
    """
    require_throw(throw_distance, friction)
    if grade is not None:
        raise UsageError("this model is of level roads", parameter="grade", hint="leave the model to be chosen")
    beyond = vehicle_share(efficiency, body_mass, vehicle_mass)
    over = multiply_add(-friction, launch_height, throw_distance)
    # Within μH the landing stops every throw; the terms of the slide are then not used.
    lands = over <= 0.0
    reach = where(lands, throw_distance, over)
    sliding = sqrt(2.0 * gravity * (friction * reach))
    require_kept(sliding > 0.0, "friction times the throw distance")
    relative = where(lands, -1.0, multiply_add(-2.0 * friction, launch_height, throw_distance) / reach)
    # a level launch that the landing stops flies the whole way
    fall = where(relative < 0.0, sqrt(2.0 * launch_height / gravity), 1.0)
    greatest = where(relative < 0.0, throw_distance / fall, sliding)
    shortest = throw_distance * sqrt(gravity / (hypot(throw_distance, launch_height) + launch_height))
    least = where(lands, shortest, _least_sliding(friction, reach, throw_distance, launch_height, gravity, shortest))
    greatest_angle = _greatest_angle(friction, relative, reach / throw_distance, throw_distance, launch_height)
    advice = friction_advice(friction) + _stop_advice(friction, lands)
    if launch_angle is None:
        return Throw(
            least_speed=least, greatest_speed=greatest, greatest_angle=greatest_angle,
            least_vehicle_speed=vehicle_speed(least, beyond), advice=advice,
        )  # fmt: skip
    require_launch(launch_angle)
    flown = _flown(throw_distance, launch_height, launch_angle, gravity, lands)
    # where nothing slides, the numbers of a level launch from the ground
    angle, height = where(lands, 0.0, launch_angle), where(lands, 0.0, launch_height)
    slid = stages(friction, 0.0, 1.0, angle, height, sliding, gravity * friction, gravity)
    speed, flight_time, flight, slide_time, slide = (
        where(lands, alone, combined) for alone, combined in zip(flown, slid, strict=True)
    )
    return Throw(
        least_speed=least,
        greatest_speed=greatest,
        greatest_angle=greatest_angle,
        speed=speed,
        flight_time=flight_time,
        flight_distance=flight,
        slide_time=slide_time,
        slide_distance=slide,
        vehicle_speed=vehicle_speed(speed, beyond),
        least_vehicle_speed=vehicle_speed(least, beyond),
        checks=balance(
            "flight and slide make the throw", flight + slide, throw_distance, throw_distance, throw_distance,
            friction, launch_height, speed, reach,
        ),
        advice=advice + _angle_advice(launch_angle, greatest_angle),
    )  # fmt: skip


def _least_sliding(
    friction: float, reach: float, distance: float, height: float, gravity: float, shortest: float
) -> float:
    """The least speed beyond μH: of throws that slide, that end where they land, or are just between the two."""
    across = hypot(1.0, friction)
    level = (height == 0.0) & (friction <= 1.0)
    # at atan μ a slide is reached at the least speed, if the landing leaves any
    drop = friction * (friction * friction) + height * (across * across) * (across * across) / reach
    slides = level | (friction * drop <= 1.0)
    # the shortest throw lands across its launch, and ends there where that is steep enough
    stops = distance <= friction * (hypot(distance, height) + height)
    flight = sqrt(2.0 * reach / (friction * gravity))
    forward = distance / flight
    between = hypot(forward, gravity * flight - forward / friction)
    least = where(slides, sqrt(2.0 * gravity * (friction * reach)) / across, between)
    return where(stops, minimum(shortest, least), least)


def _flown(distance: float, height: float, angle: float, gravity: float, lands: bool) -> Stages:
    """A throw that the landing stops; where it is not one, the numbers of a throw from its own distance."""
    height = where(lands, height, distance)
    angle = where(lands, angle, 0.0)
    cosine = cos(angle)
    rise = multiply_add(distance, sin(angle), height * cosine)
    require(
        rise > 0.0,
        "a launch at {angle:6} points below where the body lands, {height} lower at {distance}",
        angle=(angle, Angle),
        height=(height, Distance),
        distance=(distance, Distance),
        code="launch-angle",
    )
    root = sqrt(2.0 * rise / (gravity * cosine))
    speed = distance / (root * cosine)
    return speed, root, speed * cosine * root, 0.0 * speed, 0.0 * speed


def _greatest_angle(friction: float, share: float, part: float, distance: float, height: float) -> float:
    """Largest angle at which the speed of a level launch reaches the distance; `part` is r/s."""
    slope = 2.0 * friction
    square = maximum(slope - share, 0.0) * (slope + share)
    flying = atan((slope + sqrt(maximum(square, 0.0))) * part)
    slides = _slides_there(friction, share)
    return where(share < 0.0, atan2(distance, height), where(slides, 2.0 * atan(friction), flying))


def _slides_there(friction: float, share: float) -> bool:
    """Whether a body launched at 2 atan μ still slides when it has landed."""
    return sqrt(maximum(share, 0.0)) * hypot(1.0, friction) >= 2.0 * friction


def _stop_advice(friction: float, lands: bool) -> tuple[Advice, ...]:
    if not single(friction, lands) or not plain(lands):
        return ()
    text = (
        "the throw distance is at most friction × launch height: landing stops the body at once, "
        "whatever the launch angle, and the speeds are those of the flight alone"
    )
    return (Advice(code="stops-where-it-lands", message=text, severity="note"),)


def _angle_advice(launch_angle: float, greatest_angle: float) -> tuple[Advice, ...]:
    if not single(launch_angle, greatest_angle) or 0.0 <= plain(launch_angle) <= plain(greatest_angle):
        return ()
    message = worded("the greatest speed holds for launches from 0 to {greatest}", greatest=(greatest_angle, Angle))
    remedy = "use the speed of this launch angle, or the least speed"
    return (Advice(code="beyond-greatest-angle", message=message, remedy=remedy),)
