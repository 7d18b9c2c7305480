"""Two parties that meet: their positions over time, and the speed that would have avoided the impact."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import sqrt, total
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.road.drag import HIGHEST_FRICTION
from dynamics_cli.numerics.road.phases import Phase, legs
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Annotated,
    Count,
    Distance,
    Gravity,
    RoadSpeed,
    Text,
    Time,
)
from dynamics_cli.records import Advice, record
from dynamics_cli.sampling import drawing
from dynamics_cli.skid.timing.courses import Course
from dynamics_cli.skid.timing.timeline import MOST_STEPS, EndSpeed, StartSpeed, summed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.road.leg import Leg
    from dynamics_cli.skid.timing.hidden import Obstruction


@record
class Party:
    """One party: its motion to the impact in phases."""

    phases: Annotated[Phase | tuple[Phase, ...], "Its phases up to the impact, in order of time."]
    known: Annotated[StartSpeed | EndSpeed, "Its speed, at the start or at the impact."]
    name: Annotated[Text | None, "What it is called, e.g. Ford."] = None


@record
class Both:
    """Where both parties are at one time."""

    time_left: Annotated[Time, "Time left to the impact [s]."]
    first_distance: Annotated[Distance, "How far the first is from the impact [m]."]
    first_speed: Annotated[RoadSpeed, "Speed of the first [m/s]."]
    first_phase: Annotated[str, "What the first does."]
    second_distance: Annotated[Distance, "How far the second is from the impact [m]."]
    second_speed: Annotated[RoadSpeed, "Speed of the second [m/s]."]
    second_phase: Annotated[str, "What the second does."]


@record
class Meeting:
    """How two parties met, and what would have avoided the impact."""

    hazard_time: Annotated[Time, "How long before the impact the second set out [s]."]
    first_distance: Annotated[Distance, "How far the first then was from the impact [m]."]
    first_speed: Annotated[RoadSpeed, "Speed of the first then [m/s]."]
    avoidable: Annotated[bool | None, "Whether the first could have avoided it; needs its reaction and braking [-]."]
    sufficient_speed: Annotated[
        RoadSpeed | None, "Greatest speed from which the first avoids it; needs its reaction and braking [m/s]."
    ]
    speed_margin: Annotated[RoadSpeed | None, "That speed less its own; needs its reaction and braking [m/s]."]
    stopping_speed: Annotated[
        RoadSpeed | None, "Greatest speed from which it stops short; needs its reaction and braking [m/s]."
    ]
    late_speed: Annotated[
        RoadSpeed | None, "Greatest speed from which it arrives when the way is clear; needs the clear distance [m/s]."
    ]
    clear_time: Annotated[
        Time | None, "Time from the second's setting out until the way is clear; needs the clear distance [s]."
    ]
    sufficient_deceleration: Annotated[
        Acceleration | None,
        "Deceleration with which the first stops short at its own speed; left out where it "
        "arrives within its reaction time [m/s^2].",
    ]
    earlier: Annotated[
        Time | None, "How much earlier the first would have had to react to stop short; needs its braking [s]."
    ]
    moments: Annotated[tuple[Both, ...], "Both parties, at equal steps of time up to the impact."]
    advice: tuple[Advice, ...] = ()


def meet(
    *,
    first: Annotated[Party, "The party that could have braked: its reaction, build-up and braking are its phases."],
    second: Annotated[Party, "The party that crosses its way; the hazard begins when it sets out."],
    clear_distance: Annotated[
        Distance | None, "How far beyond the impact the second must get for the way to be clear, e.g. 1.9 m [m]."
    ] = None,
    steps: Annotated[Count, "Rows of the time–distance table [-]."] = 8,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Meeting:
    """Where two parties were before they met, and from which speed the first could have stopped or arrived late enough.

    Equation
    --------
    With D the first's distance when the hazard begins, T = t_r + t_b/2 and D' = D + a t_b²/24: it stops short from
    v ≤ 2D'/(T + √(T² + 2D'/a)); it arrives when the way is clear, at t_c, from v ≤ (D + a(t_c − T)²/2 + a t_b²/24)/t_c,
    if it is still moving then.

    Returns
    -------
    Meeting
        When the second set out, where the first was, the speeds that would have sufficed, and a table of both.

    Raises
    ------
    InadmissibleError
        When a phase is impossible as given, or steps is not within 1 to 10000.

    Notes
    -----
    Both are at zero distance at the impact. Before its first phase a party keeps its speed. Reaction, build-up and
    deceleration of the first are those of its own phases; stopping short and arriving late are two ways of avoiding,
    and the larger of the speeds that hold is sufficient.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 3; the two kinds of avoidance derived.

    Examples
    --------
    >>> from dynamics_cli.numerics.road.phases import Kind
    >>> car = Party((Phase(Kind("reaction"), duration=1.2), Phase(Kind("braking"), 1.0, friction=0.7)), EndSpeed(8.0))
    >>> walker = Party(Phase(Kind("constant"), distance=4.6), EndSpeed(1.4))
    >>> round(meet(first=car, second=walker).hazard_time, 4)
    3.2857
    """
    require((steps >= 1) & (steps <= MOST_STEPS), "the table cannot have {steps} rows", code="steps", steps=steps)
    motions = [motion_of(one, gravity, whose) for one, whose in ((first, "the first"), (second, "the second"))]
    courses = [course_to_impact(motion) for motion in motions]
    hazard = _sets_out(motions[1])
    distance, speed, _ = courses[0].at(-hazard)
    distance = -distance
    driver = driving(motions[0])
    clear = None
    if clear_distance is not None:
        last = motions[1][-1].end
        require(
            (last > 0.0) | (clear_distance == 0.0),
            "the second stands still at the impact, so that it never clears the way", code="never-clear",
            hint="leave out --clear-distance",
        )  # fmt: skip
        clear = hazard + (clear_distance / last if plain(clear_distance) > 0.0 else 0.0 * last)
    stopping = late = None
    if driver is not None:
        stopping = _stopping_speed(distance, *driver)
        if clear is not None:
            late = _late_speed(distance, clear, *driver)
    sufficient = stopping if late is None or stopping is None or plain(late) < plain(stopping) else late
    needed = None if driver is None else _needed(distance, speed, *driver[:2])
    return Meeting(
        hazard_time=hazard,
        first_distance=distance,
        first_speed=speed,
        avoidable=None if sufficient is None else plain(speed) <= plain(sufficient),
        sufficient_speed=sufficient,
        speed_margin=None if sufficient is None else sufficient - speed,
        stopping_speed=stopping,
        late_speed=late,
        clear_time=clear,
        sufficient_deceleration=needed,
        earlier=None if driver is None else _earlier(distance, speed, *driver),
        moments=() if drawing() else tuple(_table(courses, _longest(motions), steps)),
        advice=_beyond_tyres(needed, gravity),
    )


def _beyond_tyres(needed: "float | None", gravity: float) -> "tuple[Advice, ...]":
    """Advice when no braking could have stopped it short."""
    if needed is None or not plain(needed) > HIGHEST_FRICTION * plain(gravity):
        return ()
    message = worded(
        "a deceleration of {needed} is more than tyres give: after this reaction no braking stops it short",
        needed=(needed, Acceleration),
    )
    return (Advice(code="beyond-tyres", message=message, severity="note"),)


def motion_of(party: "Party | Obstruction", gravity: float, whose: str) -> "list[Leg]":
    """A party's phases with all their numbers; `whose` they are in a refusal."""
    given_quantity = party.known
    return legs(
        party.phases if isinstance(party.phases, tuple) else (party.phases,), gravity,
        start=given_quantity.start_speed if isinstance(given_quantity, StartSpeed) else None,
        end=given_quantity.end_speed if isinstance(given_quantity, EndSpeed) else None,
        whose=getattr(party, "name", None) or whose,
    )  # fmt: skip


def _sets_out(motion: "list[Leg]") -> float:
    """Time before the impact at which a party begins to move."""
    rows = summed(motion)
    return next((row.begins for row in rows if row.phase != "waiting"), rows[-1].begins)


def course_to_impact(motion: "list[Leg]") -> Course:
    """The course that reaches the impact at time and distance zero."""
    start = summed(motion)[0]
    return Course(motion, -start.begins, -start.from_distance)


def driving(motion: "list[Leg]") -> "tuple[float, float, float] | None":
    """Reaction time, build-up time and deceleration of a party that reacts and brakes."""
    braking = [leg for leg in motion if leg.kind == "braking"]
    if not braking:
        return None
    times = [total(leg.duration for leg in motion if leg.kind == kind) for kind in ("reaction", "build-up")]
    return times[0], times[1], -braking[-1].rate


def _stopping_speed(distance: float, reaction: float, build_up: float, deceleration: float) -> float:
    """The highest speed that can be stopped within the distance."""
    mean = reaction + 0.5 * build_up
    available = distance + deceleration * build_up * build_up / 24.0
    speed = 2.0 * available / (mean + sqrt(mean * mean + 2.0 * available / deceleration))
    if plain(speed) >= plain(0.5 * deceleration * build_up):
        return speed
    # it would stop within the build-up: s = v t_r + (2/3) v √(2 v t_b/a), by Newton's steps
    return _short_stop(distance, reaction, build_up, deceleration)


def _short_stop(distance: float, reaction: float, build_up: float, deceleration: float) -> float:
    """The same where the vehicle stops before the full deceleration is reached; √v is the unknown."""
    rise = 2.0 / 3.0 * sqrt(2.0 * build_up / deceleration)
    root = sqrt(distance / (reaction + rise * sqrt(plain(0.5 * deceleration * build_up))))
    for _ in range(60):
        residual = root * root * (reaction + rise * root) - distance
        root = root - residual / plain(root * (2.0 * reaction + 3.0 * rise * root))
        if abs(plain(residual)) <= 1e-16 * plain(distance):
            break
    return root * root


def _late_speed(distance: float, clear: float, reaction: float, build_up: float, deceleration: float) -> "float | None":
    """The highest speed from which the first, braking, arrives only after the path is clear; None if it stops."""
    if plain(clear) <= plain(reaction):
        return distance / clear
    since = clear - reaction
    if plain(since) < plain(build_up):
        lost, travelled = 0.5 * since * since / build_up, since * since * since / (6.0 * build_up)
    else:
        full = since - 0.5 * build_up
        lost, travelled = full, 0.5 * full * full + build_up * build_up / 24.0
    speed = (distance + deceleration * travelled) / clear
    return speed if plain(speed - deceleration * lost) >= 0.0 else None


def _needed(distance: float, speed: float, reaction: float, build_up: float) -> "float | None":
    """The deceleration that stops it short from its own speed, or None if its reaction takes the whole distance."""
    reach = distance - speed * (reaction + 0.5 * build_up)
    if plain(reach) <= 0.0:
        return None
    return speed * speed / (reach + sqrt(reach * reach + build_up * build_up * speed * speed / 12.0))


def _earlier(distance: float, speed: float, reaction: float, build_up: float, deceleration: float) -> float:
    """How much earlier it would have had to react, at its speed then; negative for time to spare."""
    if plain(speed) >= plain(0.5 * deceleration * build_up):
        stopping_distance = speed * (reaction + 0.5 * build_up) + 0.5 * speed * speed / deceleration
        return (stopping_distance - deceleration * build_up * build_up / 24.0 - distance) / speed
    return reaction + 2.0 / 3.0 * sqrt(2.0 * speed * build_up / deceleration) - distance / speed


def _longest(motions: "list[list[Leg]]") -> float:
    """The time from the earlier start to the impact."""
    return max((summed(motion)[0].begins for motion in motions), key=plain)


def _table(courses: "list[Course]", duration: float, steps: int) -> "list[Both]":
    """Both parties at equal steps of time, from the earlier start to the impact."""
    rows = []
    for step in range(steps):
        time = duration * (steps - step) / steps
        (first_place, fast, doing), (second_place, swift, walking) = (motion.at(-time) for motion in courses)
        rows.append(Both(time, -first_place, fast, doing, -second_place, swift, walking))
    (_, fast, doing), (_, swift, walking) = (motion.at(0.0 * duration) for motion in courses)
    return [*rows, Both(0.0, 0.0, fast, doing, 0.0, swift, walking)]
