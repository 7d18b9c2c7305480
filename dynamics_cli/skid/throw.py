"""Throw on a grade, and the speed of the striking vehicle: Searle's formula extended from the level road."""

from dynamics_cli.errors import require, require_given
from dynamics_cli.numerics.elementary import absolute, cos, hypot, maximum, multiply_add, sin, sqrt, where
from dynamics_cli.numerics.road.drag import drag_along, friction_advice, grade_advice, secant
from dynamics_cli.numerics.road.slide import require_kept
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Distance,
    Friction,
    RoadSpeed,
    Slope,
    Time,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.diagnostics import balance
from dynamics_cli.skid.drag import RIGHT_ANGLE


@record
class Throw:
    """Projection speed of a thrown pedestrian or rider, its bounds, and the vehicle's speed."""

    least_speed: Annotated[
        RoadSpeed, "No smaller projection speed reaches the throw distance, whatever the angle [m/s]."
    ]
    greatest_speed: Annotated[
        RoadSpeed | None,
        "Speed of a level launch: no greater one stays within it, for launch angles from zero to the greatest "
        "angle; needs a level road [m/s].",
    ] = None
    greatest_angle: Annotated[
        Angle | None,
        "Launch angle up to which the greatest speed holds: 2 atan μ, or less when landing stops the body before; "
        "needs a level road [rad].",
    ] = None
    speed: Annotated[RoadSpeed | None, "Projection speed; needs the launch angle [m/s]."] = None
    flight_time: Annotated[Time | None, "Time in the air; needs the launch angle [s]."] = None
    flight_distance: Annotated[Distance | None, "Horizontal distance in the air; needs the launch angle [m]."] = None
    slide_time: Annotated[Time | None, "Time from the landing to rest; needs the launch angle [s]."] = None
    slide_distance: Annotated[
        Distance | None, "Horizontal distance from the landing to rest; needs the launch angle [m]."
    ] = None
    vehicle_speed: Annotated[
        RoadSpeed | None, "Speed of the vehicle at the impact; needs launch angle and projection efficiency [m/s]."
    ] = None
    least_vehicle_speed: Annotated[
        RoadSpeed | None,
        "The same from the least projection speed; needs the projection efficiency [m/s].",
    ] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def require_throw(throw_distance: float, friction: float) -> None:
    """Refuse a throw without friction or without distance."""
    require(
        friction > 0.0,
        "a friction of {friction:6} does not stop a thrown body",
        friction=(friction, Friction),
        code="no-friction",
    )
    require(throw_distance > 0.0, "a throw distance of zero gives no speed", code="throw-too-short")


def require_launch(launch_angle: float) -> None:
    """Refuse a launch that does not go forward."""
    require(
        absolute(launch_angle) < RIGHT_ANGLE,
        "a launch at {angle:6} does not move the body forward",
        angle=(launch_angle, Angle),
        code="launch-angle",
    )


def vehicle_share(
    efficiency: "float | None", body_mass: "float | None", vehicle_mass: "float | None"
) -> "float | None":
    """Speed of the vehicle before the impact over the projection speed, or None where the efficiency is not known."""
    masses = body_mass is not None or vehicle_mass is not None
    require_given(
        not masses or (body_mass is not None and vehicle_mass is not None),
        "the speed that the vehicle loses in the impact needs both masses",
        ("body_mass", "vehicle_mass"),
    )
    require_given(
        not masses or efficiency is not None,
        "the vehicle's speed needs the projection efficiency",
        ("efficiency",),
    )
    if efficiency is None:
        return None
    require(efficiency > 0.0, "a projection efficiency of zero throws nobody", code="no-efficiency")
    if body_mass is None or vehicle_mass is None:
        return 1.0 / efficiency
    require(vehicle_mass > 0.0, "the mass of the vehicle must be more than zero", code="no-mass")
    return (1.0 + body_mass / vehicle_mass) / efficiency


def vehicle_speed(speed: "float | None", share: "float | None") -> "float | None":
    """A projection speed as a speed of the vehicle, where both are known."""
    return None if speed is None or share is None else speed * share


def on_grade(
    *,
    throw_distance: float,
    friction: float,
    launch_angle: float | None = None,
    launch_height: float = 0.0,
    grade: float | None = None,
    efficiency: float | None = None,
    body_mass: float | None = None,
    vehicle_mass: float | None = None,
    gravity: float = STANDARD_GRAVITY,
) -> Throw:
    """Projection speed of a pedestrian or rider thrown along a grade: the least, and that of a known launch angle.

    The parameters are those of `pedestrian`.

    Equation
    --------
    v = √(2g (μ cosφ + sinφ)(S − μH))/(cosα + μ sinα), α from the road, φ its slope, H = h cosφ across it and
    S = s/cosφ − h sinφ along it; least, over all angles, √(2g (μ cosφ + sinφ)(S − μH)/(1 + μ²)).
    Vehicle: V = v (1 + m_b/m_v)/η.

    Returns
    -------
    Throw
        Least speed; with the launch angle also the speed, and the flight and slide it is made of.

    Raises
    ------
    InadmissibleError
        When friction or the throw distance is zero, friction does not hold the body on the grade, the launch does not
        go forward, or landing would stop the body at once.

    Notes
    -----
    Distances are horizontal and the launch angle is from the horizontal, as on a level road; the launch height is that
    above the road, less the same at rest. The landing takes the speed w into the road and μw along it. The greatest
    speed is stated for level roads only.

    References
    ----------
    Searle & Searle (SAE 831622, 1983) and Searle (1993), as commonly published; the grade derived.

    Examples
    --------
    >>> round(on_grade(throw_distance=25.0, friction=0.66, grade=-0.05).least_speed, 4)
    14.4342
    """
    require_throw(throw_distance, friction)
    slope = 0.0 * throw_distance if grade is None else grade
    road = secant(slope)
    drag = drag_along(friction, slope, 1.0)
    require(
        drag > 0.0,
        "on a grade of {grade} a friction of {friction} does not stop the body: it slides on",
        grade=(slope, Slope), friction=(friction, Friction), code="no-drag",
        hint="uphill grades are positive; check the sign of grade, and friction",
    )  # fmt: skip
    height = launch_height / road
    # from the foot of the normal, which is uphill of the foot of the vertical
    along = throw_distance * road - slope * height
    over = multiply_add(-friction, height, along)
    require(
        over > 0.0,
        "the throw of {distance} is not above friction × launch height: landing stops the body at once",
        distance=(throw_distance, Distance), code="stops-at-landing",
        hint="leave the grade out: on a level road the flight alone gives the speed",
    )  # fmt: skip
    sliding = sqrt(2.0 * gravity * (drag * over))
    require_kept(sliding > 0.0, "friction times the throw distance")
    least = sliding / hypot(1.0, friction)
    mass_ratio = vehicle_share(efficiency, body_mass, vehicle_mass)
    advice = friction_advice(friction) + grade_advice(slope)
    if launch_angle is None:
        return Throw(least_speed=least, least_vehicle_speed=vehicle_speed(least, mass_ratio), advice=advice)
    require_launch(launch_angle)
    speed, flight_time, flight, slide_time, slide = stages(
        friction, slope, road, launch_angle, height, sliding, gravity * drag, gravity / road
    )
    return Throw(
        least_speed=least,
        speed=speed,
        flight_time=flight_time,
        flight_distance=flight,
        slide_time=slide_time,
        slide_distance=slide,
        vehicle_speed=vehicle_speed(speed, mass_ratio),
        least_vehicle_speed=vehicle_speed(least, mass_ratio),
        checks=balance(
            "flight and slide make the throw", flight + slide, throw_distance, throw_distance, throw_distance,
            friction, height, speed, over, drag,
        ),
        advice=advice,
    )  # fmt: skip


# Speed, time and way in the air, time and way of the slide; ways are horizontal.
Stages = tuple[float, float, float, float, float]


def stages(
    friction: float, slope: float, road: float, angle: float, height: float, sliding: float, slowing: float, fall: float
) -> Stages:
    """Flight and slide of a launch; `sliding` is its speed if level, `fall` gravity across the road."""
    sine, cosine = sin(angle), cos(angle)
    up, along = (sine - slope * cosine) / road, multiply_add(slope, sine, cosine) / road
    gain = multiply_add(friction, up, along)
    require(
        (gain > 0.0) & (along > 0.0),
        "a launch at {angle:6} is stopped by its landing at once, or does not go along the road",
        angle=(angle, Angle), code="stops-at-landing",
    )  # fmt: skip
    speed = sliding / gain
    landing = sqrt(multiply_add(speed * up, speed * up, 2.0 * fall * height))
    time = _flight_time(speed * up, landing, fall, height)
    drop = fall * slope * time
    forward = speed * along - drop
    # what the landing leaves, from the form that subtracts less
    landing_speed = where(up >= 0.0, forward - friction * landing, sliding - friction * (fall * time) - drop)
    require(
        landing_speed >= -1e-15 * speed,
        "landing stops the body at once: friction takes {lost:6} of the {forward:6} along the road",
        lost=(friction * landing, RoadSpeed), forward=(forward, RoadSpeed), code="stops-at-landing",
        hint="a flatter launch, or read the least speed, which holds always",
    )  # fmt: skip
    landing_speed = maximum(landing_speed, 0.0)
    flight = (time * multiply_add(-0.5 * fall * slope, time, speed * along) + slope * height) / road
    return speed, time, flight, landing_speed / slowing, 0.5 * landing_speed * landing_speed / slowing / road


def _flight_time(rising: float, landing: float, fall: float, height: float) -> float:
    """(rising + landing)/g of the flight, from the form that does not cancel when the launch points down."""
    down = landing - rising
    return where(rising >= 0.0, rising + landing, 2.0 * fall * height / where(rising >= 0.0, 1.0, down)) / fall


def level_suffices(**inputs: object) -> str | None:
    """Why the level road answers, or None when a grade is given."""
    return None if inputs.get("grade") is not None else "level road"
