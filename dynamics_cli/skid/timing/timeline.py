"""A motion in phases, forward from its first speed or back from its last: position and speed over time."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.phases import Phase, legs
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Annotated,
    Count,
    Distance,
    Gravity,
    RoadSpeed,
    Time,
)
from dynamics_cli.records import Advice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.road.leg import Leg

MOST_STEPS = 10000


@record
class StartSpeed:
    """Forward from the speed at the start."""

    start_speed: Annotated[RoadSpeed, "Speed where the first phase begins: the phases are followed forward [m/s]."]


@record
class EndSpeed:
    """Back from the speed at the end."""

    end_speed: Annotated[RoadSpeed, "Speed where the last phase ends, at the impact say: they are followed back [m/s]."]


@record
class PhaseTravelled:
    """One phase with all its numbers."""

    phase: Annotated[str, "What the party does."]
    begins: Annotated[Time, "How long before the end it begins [s]."]
    from_distance: Annotated[Distance, "How far before the end it begins [m]."]
    start_speed: Annotated[RoadSpeed, "Speed where it begins [m/s]."]
    end_speed: Annotated[RoadSpeed, "Speed where it ends [m/s]."]
    duration: Annotated[Time, "Its duration [s]."]
    distance: Annotated[Distance, "How far it goes [m]."]
    acceleration: Annotated[
        Acceleration,
        "Change of speed, less than zero where it slows; reached in a build-up, at first in a start-up [m/s^2].",
    ]


@record
class Moment:
    """One row of the time–distance table."""

    phase: Annotated[str, "What the party does up to then."]
    time: Annotated[Time, "Time since the start [s]."]
    time_to_end: Annotated[Time, "Time left to the end [s]."]
    distance: Annotated[Distance, "Distance travelled since the start [m]."]
    distance_to_end: Annotated[Distance, "Distance left to the end [m]."]
    speed: Annotated[RoadSpeed, "Speed at that time [m/s]."]


@record
class Timeline:
    """The whole motion."""

    start_speed: Annotated[RoadSpeed, "Speed at the start [m/s]."]
    end_speed: Annotated[RoadSpeed, "Speed at the end [m/s]."]
    duration: Annotated[Time, "Time from the start to the end [s]."]
    distance: Annotated[Distance, "Distance from the start to the end [m]."]
    phases: Annotated[tuple[PhaseTravelled, ...], "The phases in order of time, counted back from the end."]
    moments: Annotated[tuple[Moment, ...], "Time, distance and speed from the start to the end."]
    advice: tuple[Advice, ...] = ()


def timeline(
    *,
    phases: Annotated[Phase | tuple[Phase, ...], "The phases in order of time; one may be given by its plain fields."],
    known: Annotated[StartSpeed | EndSpeed, "The speed that is known, at the start or at the end."],
    steps: Annotated[Count, "Rows of the time–distance table for every phase, equally spaced in time [-]."] = 4,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Timeline:
    """Time, distance and speed of a motion in phases, followed forward from its first speed or back from its last.

    Equation
    --------
    Uniform: v₂ = v₁ + a t, d = (v₁ + v₂) t/2, v₂² = v₁² + 2a d. Build-up over t_b to a deceleration a:
    v₂ = v₁ − a t_b/2, d = v₂ t_b + a t_b²/3. Start-up with a = α − βv from rest: v = (α/β)(1 − e^(−βt)),
    d = (α/β)t − v/β.

    Returns
    -------
    Timeline
        Speeds at both ends, duration, distance, every phase with all its numbers, and the time–distance table.

    Raises
    ------
    InadmissibleError
        When a phase has more or fewer numbers than it needs, stops before it ends, or leads to a speed impossible
        for its kind.

    Notes
    -----
    A point on a path. Of its duration, distance, speed and acceleration a phase needs two; friction with grade and
    braking share stands for an acceleration. A reaction and a constant phase need a duration or a distance.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 3 (straight-line motion), section 10.10.
    The start-up's form is the one that Long (2000) recommends; its constants are inputs.

    Examples
    --------
    >>> from dynamics_cli.numerics.road.phases import Kind
    >>> round(timeline(phases=Phase(Kind("braking"), distance=14.0, friction=0.7), known=EndSpeed(8.0)).start_speed, 4)
    16.0066
    """
    require(
        (steps >= 1) & (steps <= MOST_STEPS), "the table cannot have {steps} rows a phase", code="steps", steps=steps
    )
    listed = phases if isinstance(phases, tuple) else (phases,)
    motion = legs(
        listed, gravity,
        start=known.start_speed if isinstance(known, StartSpeed) else None,
        end=known.end_speed if isinstance(known, EndSpeed) else None,
    )  # fmt: skip
    travelled = summed(motion)
    return Timeline(
        start_speed=motion[0].start,
        end_speed=motion[-1].end,
        duration=travelled[0].begins,
        distance=travelled[0].from_distance,
        phases=tuple(travelled),
        moments=tuple(_moments(motion, travelled, steps)),
        advice=_at_rest(motion),
    )


def _at_rest(motion: "list[Leg]") -> tuple[Advice, ...]:
    """Advice on a reaction of one who stands: it takes time but no way, and is mostly a speed forgotten."""
    if not any(leg.kind == "reaction" and single(leg.start) and plain(leg.start) == 0.0 for leg in motion):
        return ()
    message = "the reaction is at 0 km/h: it takes its time and covers no distance"
    remedy = "check the speed and its end; for one who stands, kind=waiting says it"
    return (Advice(code="reaction-at-rest", message=message, remedy=remedy),)


def summed(motion: "list[Leg]") -> "list[PhaseTravelled]":
    """The phases with when and where they begin, counted back from the end."""
    rows: list[PhaseTravelled] = []
    time, travelled = 0.0, 0.0
    for leg in reversed(motion):
        time, travelled = time + leg.duration, travelled + leg.distance
        rows.append(PhaseTravelled(leg.kind, time, travelled, leg.start, leg.end, leg.duration, leg.distance, leg.rate))
    rows.reverse()
    return rows


def _moments(motion: "list[Leg]", travelled: "list[PhaseTravelled]", steps: int) -> "list[Moment]":
    """Equal steps of time within each phase; the first row is the start, the last the end."""
    time, place = 0.0, 0.0
    rows = [Moment(motion[0].kind, time, travelled[0].begins, place, travelled[0].from_distance, motion[0].start)]
    for index, leg in enumerate(motion):
        last = index == len(motion) - 1
        begins, ahead = (0.0, 0.0) if last else (travelled[index + 1].begins, travelled[index + 1].from_distance)
        for step in range(1, steps):
            since = leg.duration * step / steps
            gone, speed = leg.at(since)
            rest = leg.duration * (steps - step) / steps
            rows.append(
                Moment(leg.kind, time + since, begins + rest, place + gone, ahead + (leg.distance - gone), speed)
            )
        time, place = time + leg.duration, place + leg.distance
        rows.append(Moment(leg.kind, time, begins, place, ahead, leg.end))
    return rows
