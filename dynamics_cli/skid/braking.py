"""Speed from skid marks on one or several surfaces, and the distance a given change of speed takes."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import maximum, multiply_add, sqrt, summed
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import drag_advice, drag_along, require_drag, secant, speed_advice
from dynamics_cli.numerics.road.slide import SurfaceCrossed, crossed_back, crossing_time
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Annotated,
    Distance,
    DragFactor,
    Energy,
    Fraction,
    Friction,
    Gravity,
    Mass,
    RoadSpeed,
    Slope,
    Time,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.diagnostics import balance, split_product

# A mark as long as the computed stop may exceed it by rounding.
ROUNDING_ROOM = 1.0 + 1e-15


@record
class Segment:
    """A stretch of skid marks on one surface."""

    distance: Annotated[Distance, "Length of the marks along the road [m]."]
    friction: Annotated[Friction, "Coefficient of friction between tyre and road [-]."]
    grade: Annotated[Slope, "Rise over run of the road in the direction of travel, uphill positive [-]."] = 0.0
    braking: Annotated[
        Fraction, "Share of the full friction that the brakes use, 1 when all wheels are locked [-]."
    ] = 1.0


@record
class SkidSpeed:
    """Speed at the start of the marks, and the slide along them."""

    speed: Annotated[RoadSpeed, "Speed where the marks begin [m/s]."]
    time: Annotated[Time, "Time from the beginning of the marks to their end [s]."]
    total_distance: Annotated[Distance, "Length of all marks [m]."]
    energy: Annotated[Energy | None, "Kinetic energy where the marks begin; needs the mass [J]."]
    friction_work: Annotated[Energy | None, "Energy that friction turned into heat; needs the mass [J]."]
    surfaces: Annotated[tuple[SurfaceCrossed, ...], "The surfaces in the order they were crossed."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def speed(
    *,
    segments: Annotated[
        Segment | tuple[Segment, ...],
        "The surfaces in the order they were crossed; one may be given by its plain fields.",
    ],
    end_speed: Annotated[RoadSpeed, "Speed where the marks end: zero when the vehicle came to rest there [m/s]."] = 0.0,
    mass: Annotated[Mass | None, "Mass of the vehicle; needed for the energies only [kg]."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> SkidSpeed:
    """Speed at the start of skid marks, from the work of friction and grade over every surface crossed.

    Equation
    --------
    v² = v_e² + 2g Σ f_i d_i, with the drag factor f = (ημ + G)/√(1 + G²) of each surface.

    Returns
    -------
    SkidSpeed
        The speed, total time and distance, energies, and speeds, drag factor and time on every surface.

    Raises
    ------
    InadmissibleError
        When the drag factor of a surface is not above zero.

    Notes
    -----
    A point mass slowed uniformly on each surface; distances are measured along the road. The numerator ημ + G is
    rounded once, so a drag factor near zero keeps all its digits; but it magnifies errors of friction or grade.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10.

    Examples
    --------
    >>> round(speed(segments=Segment(distance=60.0, friction=0.7)).speed, 4)
    28.7012
    """
    stretches = segments if isinstance(segments, tuple) else (segments,)
    require(len(stretches) > 0, "no segment is given", code="no-segment")
    several = len(stretches) > 1
    names = [f"segments[{index}]: " if several else "" for index in range(len(stretches))]
    crossed, work = crossed_back(stretches, end_speed, gravity, names)
    advice: tuple[Advice, ...] = ()
    heat: float = 0.0
    for stretch, name in zip(reversed(stretches), reversed(names), strict=True):
        if mass is not None:
            heat = heat + stretch.braking * stretch.friction * stretch.distance / secant(stretch.grade)
        advice = drag_advice(stretch.friction, stretch.grade, stretch.braking, name) + advice
    return SkidSpeed(
        speed=crossed[0].entry_speed,
        time=summed([surface.time for surface in crossed]),
        total_distance=summed([surface.distance for surface in crossed]),
        energy=None if mass is None else mass * (0.5 * end_speed * end_speed + gravity * work),
        friction_work=None if mass is None else mass * (gravity * heat),
        surfaces=crossed,
        checks=_energy_check(crossed, gravity),
        advice=advice or speed_advice(crossed[0].entry_speed, "a speed", "check the distance and its unit"),
    )


def _energy_check(crossed: tuple[SurfaceCrossed, ...], gravity: float) -> tuple[Check, ...]:
    """Check squared speeds against work, summed surface by surface from the returned speeds."""
    first, last = crossed[0].entry_speed, crossed[-1].exit_speed
    gained = summed([2.0 * gravity * surface.drag_factor * surface.distance for surface in crossed])
    operands = [x for surface in crossed for x in (surface.drag_factor, surface.distance)]
    return balance("energy balance", (first - last) * (first + last), gained, first * first, first, gravity, *operands)


@record
class SkidDistance:
    """Distance and time that a change of speed takes."""

    distance: Annotated[Distance, "Distance along the road from speed to end speed [m]."]
    time: Annotated[Time, "Time from speed to end speed [s]."]
    drag_factor: Annotated[DragFactor, "Deceleration along the road over gravity [-]."]
    deceleration: Annotated[Acceleration, "Deceleration along the road [m/s^2]."]
    exit_speed: Annotated[RoadSpeed | None, "Speed remaining at the end of the mark; needs the mark [m/s]."] = None
    exit_time: Annotated[Time | None, "Time until the end of the mark; needs the mark [s]."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def distance(
    *,
    speed: Annotated[RoadSpeed, "Speed where braking begins [m/s]."],
    friction: Annotated[Friction, "Coefficient of friction between tyre and road [-]."],
    grade: Annotated[Slope, "Rise over run of the road in the direction of travel, uphill positive [-]."] = 0.0,
    braking: Annotated[
        Fraction, "Share of the full friction that the brakes use, 1 when all wheels are locked [-]."
    ] = 1.0,
    end_speed: Annotated[RoadSpeed, "Speed to slow down to [m/s]."] = 0.0,
    mark: Annotated[Distance | None, "Length of a mark at whose end the remaining speed is calculated [m]."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> SkidDistance:
    """Distance and time in which a braked vehicle slows down, and the speed left after a given mark.

    Equation
    --------
    t = (v − v_e)/(g f), d = t (v + v_e)/2, f = (ημ + G)/√(1 + G²); after a mark m: v_m² = v² − 2 g f m.

    Returns
    -------
    SkidDistance
        Distance, time, drag factor and deceleration; speed and time at the end of the mark when one is given.

    Raises
    ------
    InadmissibleError
        When the drag factor is not above zero, the end speed exceeds the speed, or the mark exceeds the stop.

    Notes
    -----
    A point mass slowed uniformly. Differences of speeds are taken before squaring, so nearly equal speeds lose no
    digit; v² − 2 g f m is formed in twice the precision. Close to the end of the stop the remaining speed varies
    as the root of the remaining distance: the smallest change of an input decides.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10.

    Examples
    --------
    >>> round(distance(speed=28.7, friction=0.7).distance, 4)
    59.995
    """
    drag = require_drag(drag_along(friction, grade, braking))
    require(
        end_speed <= speed,
        "the end speed of {end} exceeds the speed of {start}: braking cannot raise it",
        code="end-speed",
        end=(end_speed, RoadSpeed),
        start=(speed, RoadSpeed),
    )
    deceleration = gravity * drag
    time = (speed - end_speed) / deceleration
    length = time * (0.5 * (speed + end_speed))
    exit_speed: float | None = None
    exit_time: float | None = None
    advice = drag_advice(friction, grade, braking)
    if mark is not None:
        shed = sqrt(2.0 * deceleration * mark)
        require(
            shed <= speed * ROUNDING_ROOM,
            "the mark of {mark} exceeds the stop: from {start} the vehicle is at rest after {stop}",
            code="mark-exceeds-stop",
            mark=(mark, Distance),
            start=(speed, RoadSpeed),
            stop=(speed / deceleration * (0.5 * speed), Distance),
        )
        left_squared = _speed_left_squared(speed, gravity, drag, mark)
        advice += _stop_advice(left_squared, mark)
        exit_speed = sqrt(maximum(left_squared, 0.0))
        exit_time = crossing_time(mark, speed, exit_speed)
    return SkidDistance(
        distance=length,
        time=time,
        drag_factor=drag,
        deceleration=deceleration,
        exit_speed=exit_speed,
        exit_time=exit_time,
        checks=balance(
            "energy balance",
            speed * speed,
            end_speed * end_speed + 2.0 * deceleration * length,
            speed * speed,
            speed,
            deceleration,
            length,
        ),
        advice=advice,
    )


def _speed_left_squared(speed: float, gravity: float, drag: float, mark: float) -> float:
    """v² − 2 g f m, with its products corrected for rounding."""
    deceleration, more = split_product(gravity, drag)
    shed, rest = split_product(2.0 * deceleration, mark)
    return multiply_add(speed, speed, -shed) - (rest + 2.0 * more * mark)


def _stop_advice(left: float, mark: float) -> tuple[Advice, ...]:
    if not single(left, mark) or plain(left) > 0.0 or plain(mark) == 0.0:
        return ()
    message = (
        "the mark ends where the vehicle stops, within rounding: the remaining speed is taken as zero, "
        "and no condition number describes how it and the time there depend on the inputs"
    )
    return (Advice(code="mark-at-stop", message=message, remedy="read distance and time of the stop instead"),)
