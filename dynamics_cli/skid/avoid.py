"""Avoidability: whether the driver could have stopped, and from which speed."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import hypot, maximum, minimum, multiply_add, sqrt, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import drag_advice, drag_along, require_drag
from dynamics_cli.numerics.road.slide import require_kept
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Annotated,
    Distance,
    DragFactor,
    Fraction,
    Friction,
    Gravity,
    Length,
    RoadSpeed,
    Slope,
    Time,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.diagnostics import balance, reaction_advice


@record
class Approach:
    """One way of approaching the hazard."""

    case: Annotated[str, "Which speed this is: travelled, limit or sufficient."]
    approach_speed: Annotated[RoadSpeed, "Speed when the hazard became visible [m/s]."]
    reaction_distance: Annotated[Distance, "Distance travelled before the brakes act [m]."]
    braking_distance: Annotated[Distance, "Distance that braking to rest takes [m]."]
    stopping_distance: Annotated[Distance, "Reaction and braking distance together [m]."]
    margin: Annotated[Length, "Distance to spare before the hazard, negative when it falls short [m]."]
    impact_speed: Annotated[RoadSpeed, "Speed at the hazard, zero when the vehicle stops before [m/s]."]
    time: Annotated[Time, "Time until the vehicle stops or reaches the hazard [s]."]


@record
class Avoidance:
    """Whether the hazard could have been avoided by stopping."""

    avoidable: Annotated[bool, "Whether the vehicle stops before the hazard at the speed travelled [-]."]
    margin: Annotated[Length, "Distance to spare at the speed travelled, negative when it falls short [m]."]
    impact_speed: Annotated[RoadSpeed, "Speed at the hazard at the speed travelled [m/s]."]
    sufficient_speed: Annotated[RoadSpeed, "Highest speed from which the vehicle stops before the hazard [m/s]."]
    stopping_distance: Annotated[Distance, "Distance that the speed travelled needs to stop [m]."]
    avoidable_at_limit: Annotated[
        bool | None, "Whether the vehicle stops before the hazard at the speed limit; needs the speed limit [-]."
    ]
    margin_at_limit: Annotated[
        Length | None, "Distance to spare at the speed limit, negative when it falls short; needs the speed limit [m]."
    ]
    impact_speed_at_limit: Annotated[
        RoadSpeed | None, "Speed at the hazard at the speed limit; needs the speed limit [m/s]."
    ]
    drag_factor: Annotated[DragFactor, "Deceleration along the road over gravity [-]."]
    approaches: Annotated[
        tuple[Approach, ...],
        "Distances, speeds and times at the speed travelled, at the limit and at the sufficient speed.",
    ]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def avoid(
    *,
    speed: Annotated[RoadSpeed, "Speed travelled when the hazard became visible [m/s]."],
    sight_distance: Annotated[Distance, "Distance along the road from there to the hazard [m]."],
    reaction_time: Annotated[Time, "Time from the hazard becoming visible until the brakes act [s]."],
    friction: Annotated[Friction, "Coefficient of friction between tyre and road [-]."],
    speed_limit: Annotated[RoadSpeed | None, "Speed limit, or a speed considered prudent there [m/s]."] = None,
    grade: Annotated[Slope, "Rise over run of the road in the direction of travel, uphill positive [-]."] = 0.0,
    braking: Annotated[
        Fraction, "Share of the full friction that the brakes use, 1 when all wheels are locked [-]."
    ] = 1.0,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Avoidance:
    """Whether the driver could have stopped before the hazard, as travelled or at the limit, and the sufficient speed.

    Equation
    --------
    s = v t + v²/(2a), a = g f; the speed that suffices for S is 2S/(t + √(t² + 2S/a)). The margin is S − s, the speed
    at the hazard √(2a(s − S)) when the margin is negative, or v when the hazard is reached within the reaction.

    Returns
    -------
    Avoidance
        The answer at both speeds, the speed that would have sufficed, and a table of distances and times.

    Raises
    ------
    InadmissibleError
        When the drag factor is not above zero, or the sight distance is zero.

    Notes
    -----
    A point mass that keeps its speed during the reaction and is then slowed uniformly. The hazard stays where it is.
    The sufficient speed has no cancellation. The margin is a difference, near zero only as accurate as the inputs
    allow; whether the vehicle stops and the speed at the hazard follow from it, so the three never contradict each
    other.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10 (braking).

    Examples
    --------
    >>> round(avoid(speed=25.0, sight_distance=50.0, reaction_time=1.5, friction=0.7).sufficient_speed, 4)
    17.8543
    """
    drag = require_drag(drag_along(friction, grade, braking))
    deceleration = gravity * drag
    require(
        sight_distance > 0.0,
        "the sight distance must be more than zero",
        code="no-sight-distance",
    )
    sufficient = (
        2.0 * sight_distance / (reaction_time + hypot(reaction_time, sqrt(2.0 * sight_distance / deceleration)))
    )
    travelled = _approach("travelled", speed, sight_distance, reaction_time, deceleration)
    limit: Approach | None = None
    if speed_limit is not None:
        limit = _approach("limit", speed_limit, sight_distance, reaction_time, deceleration)
    enough = _sufficient(sufficient, reaction_time, deceleration)
    return Avoidance(
        avoidable=travelled.margin >= 0.0,
        margin=travelled.margin,
        impact_speed=travelled.impact_speed,
        sufficient_speed=sufficient,
        stopping_distance=travelled.stopping_distance,
        avoidable_at_limit=None if limit is None else limit.margin >= 0.0,
        margin_at_limit=None if limit is None else limit.margin,
        impact_speed_at_limit=None if limit is None else limit.impact_speed,
        drag_factor=drag,
        approaches=(travelled, enough) if limit is None else (travelled, limit, enough),
        checks=balance(
            "sufficient speed stops in the sight distance",
            enough.stopping_distance,
            sight_distance,
            sight_distance,
            sight_distance,
            reaction_time,
            deceleration,
            sufficient,
        ),
        advice=reaction_advice(reaction_time)
        + drag_advice(friction, grade, braking)
        + _close(travelled, sight_distance),
    )


def _approach(case: str, speed: float, sight: float, reaction_time: float, deceleration: float) -> Approach:
    reaction = speed * reaction_time
    braking = speed / deceleration * (0.5 * speed)
    require_kept((braking > 0.0) | (speed == 0.0), "the braking distance")
    before_braking = multiply_add(-speed, reaction_time, sight)
    margin = before_braking - braking
    root = sqrt(2.0 * deceleration * maximum(-margin, 0.0))
    # during the reaction the speed is constant; maximum and minimum keep the root's error where rounding decides
    impact = minimum(speed, maximum(root, where(before_braking <= 0.0, speed, 0.0)))
    available = maximum(before_braking, 0.0)
    covered = minimum(reaction, sight)
    braked = minimum(available, braking)
    speed_sum = speed + impact
    moving = speed_sum > 0.0
    time = covered / _nonzero(speed, moving) + 2.0 * braked / _nonzero(speed_sum, moving)
    return Approach(case, speed, reaction, braking, reaction + braking, margin, impact, time)


def _nonzero(x: float, moving: bool) -> float:
    return where(moving, x, 1.0)


def _sufficient(speed: float, reaction_time: float, deceleration: float) -> Approach:
    """The approach that stops exactly at the hazard: its margin and speed there are zero by definition."""
    reaction = speed * reaction_time
    braking = speed / deceleration * (0.5 * speed)
    time = reaction_time + speed / deceleration
    return Approach("sufficient", speed, reaction, braking, reaction + braking, 0.0, 0.0, time)


def _close(travelled: Approach, sight: float) -> tuple[Advice, ...]:
    if not single(travelled.margin, sight) or abs(plain(travelled.margin)) > 0.05 * plain(travelled.stopping_distance):
        return ()
    message = worded(
        "the margin of {margin:3} is within 5 % of the stopping distance of {stop}: a small error of any input "
        "changes the verdict",
        margin=(travelled.margin, Distance),
        stop=(travelled.stopping_distance, Distance),
    )
    return (Advice(code="close-call", message=message, remedy="state the inputs with their uncertainty"),)
