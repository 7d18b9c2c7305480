"""Swerve: how far and how long it takes to move aside, and the speed above which it needs less room than braking."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import asin, atan, pi_beside, sqrt, total
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import HIGHEST_FRICTION
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Deceleration,
    Distance,
    DragFactor,
    Gravity,
    RoadSpeed,
    Time,
)
from dynamics_cli.records import Advice, record


@record
class Swerve:
    """The way and the time of a swerve, and of braking instead."""

    distance: Annotated[Distance, "Along the road, in two equal arcs that end straight, without the reaction [m]."]
    time: Annotated[Time, "Time of the two arcs [s]."]
    total_distance: Annotated[
        Distance | None, "The two arcs with what comes before them; needs reaction time or steering lag [m]."
    ]
    total_time: Annotated[Time | None, "The same in time; needs reaction time or steering lag [s]."]
    one_arc_distance: Annotated[Distance, "Along the road to the same lateral shift in one arc, not straightened [m]."]
    sine_time: Annotated[Time, "Time of the same shift with a sine of lateral acceleration [s]."]
    sine_distance: Annotated[Distance, "Along the road in that time [m]."]
    arc_radius: Annotated[Distance, "Radius of the arcs [m]."]
    lean_angle: Annotated[Angle, "Lean from the vertical with which a rider takes the arcs [rad]."]
    braking_distance: Annotated[Distance | None, "To stop from the same speed instead; needs the drag factor [m]."]
    equal_speed: Annotated[
        RoadSpeed | None, "Speed at which stopping needs as much room as the two arcs; needs the drag factor [m/s]."
    ]
    advice: tuple[Advice, ...] = ()


def swerve(
    *,
    speed: Annotated[RoadSpeed, "Speed, kept through the swerve, e.g. 90 km/h [m/s]."],
    lateral_shift: Annotated[Distance, "How far it must move aside, e.g. 3.5 m [m]."],
    lateral_acceleration: Annotated[Deceleration, "Lateral acceleration of the arcs, e.g. 0.35 g [m/s^2]."],
    reaction_time: Annotated[Time | None, "Reaction before the steering begins, e.g. 1.2 s [s]."] = None,
    steering_lag: Annotated[Time | None, "From steering wheel to lateral acceleration, e.g. 0.2 s [s]."] = None,
    drag_factor: Annotated[DragFactor | None, "Drag factor of braking instead, e.g. 0.7 [-]."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Swerve:
    """Distance and time of a swerve in two arcs, in one, and as a sine, with the speed at which braking needs as much.

    Equation
    --------
    R = v²/a; lean tan = a/g; along √(y (4R − y)), time (2R/v)·2 asin√(y/(4R)); one arc √(y (2R − y)).
    Sine of lateral acceleration: T = √(2πy/a).
    Braking needs as much at v² = A + √(A² − 4f²g²y²), A = 8f²g²y/a.

    Returns
    -------
    Swerve
        Distances and times with and without the reaction, and the comparison with braking.

    Raises
    ------
    InadmissibleError
        When the speed or the shift is zero, or the shift is more than the arcs can give.

    Notes
    -----
    A point at constant speed; the lateral acceleration comes and goes at once in the arcs. Real steering takes time:
    give it as the steering lag.

    References
    ----------
    Motion on a circle, Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 3; derived.

    Examples
    --------
    >>> round(swerve(speed=25.0, lateral_shift=3.5, lateral_acceleration=0.35 * 9.80665).distance, 6)
    50.369043
    """
    require(speed > 0.0, "a vehicle at rest does not swerve", code="at-rest")
    require(lateral_shift > 0.0, "a shift of zero needs no swerve", code="no-shift")
    radius = speed * (speed / lateral_acceleration)
    require(
        lateral_shift <= 2.0 * radius,
        "a shift of {shift} is more than two arcs of {radius} give before they turn back",
        shift=(lateral_shift, Distance), radius=(radius, Distance), code="too-slow",
        hint="at this speed it is a turn: it needs less lateral acceleration",
    )  # fmt: skip
    along = sqrt(lateral_shift * (4.0 * radius - lateral_shift))
    time = 4.0 * (radius / speed) * asin(sqrt(0.25 * lateral_shift / radius))
    sine = sqrt(2.0 * pi_beside(lateral_shift, lateral_acceleration) * (lateral_shift / lateral_acceleration))
    waits = [wait for wait in (reaction_time, steering_lag) if wait is not None]
    before = total(waits) if waits else None
    braking, equal = None, None
    if drag_factor is not None:
        require(drag_factor > 0.0, "a drag factor of zero does not stop anything", code="no-drag")
        slowing = gravity * drag_factor
        braking = speed * (speed / (2.0 * slowing))
        equal = _equal_speed(slowing, lateral_shift, lateral_acceleration)
    one_arc = sqrt(lateral_shift * (2.0 * radius - lateral_shift))
    return Swerve(
        distance=along,
        time=time,
        total_distance=None if before is None else along + speed * before,
        total_time=None if before is None else time + before,
        one_arc_distance=one_arc,
        sine_time=sine,
        sine_distance=speed * sine,
        arc_radius=radius,
        lean_angle=atan(lateral_acceleration / gravity),
        braking_distance=braking,
        equal_speed=equal,
        advice=_advice(lateral_acceleration, gravity, along, braking),
    )


def _equal_speed(slowing: float, shift: float, lateral: float) -> float:
    """Where v²/(2fg) = √(y (4v²/a − y)): the larger root, quadratic in v²."""
    half = 8.0 * slowing * (slowing * shift / lateral)
    inside = (half - 2.0 * slowing * shift) * (half + 2.0 * slowing * shift)
    require(
        inside >= 0.0,
        "with {slowing} of braking and {lateral} of swerving no speed needs the same room for both",
        slowing=(slowing, Deceleration), lateral=(lateral, Deceleration), code="no-equal-speed",
        hint="leave the drag factor out, or look at the lateral acceleration",
    )  # fmt: skip
    return sqrt(half + sqrt(inside))


def _advice(lateral: float, gravity: float, along: float, braking: "float | None") -> tuple[Advice, ...]:
    notes: list[Advice] = []
    if single(lateral) and plain(lateral) > HIGHEST_FRICTION * plain(gravity):
        message = worded("{lateral} across the road is more than tyres give", lateral=(lateral, Deceleration))
        notes.append(Advice(code="high-lateral", message=message, remedy="look at the number and its unit"))
    if braking is not None and single(along, braking):
        least, most = ("braking", "swerving") if plain(braking) < plain(along) else ("swerving", "braking")
        message = worded(
            "{least} needs {difference} less than {most}", least=least, most=most,
            difference=(abs(plain(along) - plain(braking)), Distance),
        )  # fmt: skip
        notes.append(Advice(code="which-needs-less", message=message, severity="note"))
    return tuple(notes)
