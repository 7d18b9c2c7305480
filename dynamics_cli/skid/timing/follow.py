"""One vehicle behind another: whether, when, where and how fast the follower runs into the leader."""

from itertools import zip_longest

from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.polynomials import derivative
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Annotated,
    Count,
    Distance,
    Gravity,
    Length,
    RoadSpeed,
    Time,
)
from dynamics_cli.records import record
from dynamics_cli.skid.timing.courses import Course, changes
from dynamics_cli.skid.timing.meet import Party, motion_of
from dynamics_cli.skid.timing.timeline import MOST_STEPS


@record
class OneBehind:
    """Both vehicles at one time."""

    time: Annotated[Time, "Time since the start [s]."]
    gap: Annotated[Length, "Free distance between them, less than zero beyond the contact [m]."]
    leader_distance: Annotated[Distance, "Distance the leader has travelled [m]."]
    leader_speed: Annotated[RoadSpeed, "Speed of the leader [m/s]."]
    follower_distance: Annotated[Distance, "Distance the follower has travelled [m]."]
    follower_speed: Annotated[RoadSpeed, "Speed of the follower [m/s]."]


@record
class Following:
    """Whether the follower reaches the leader."""

    contact: Annotated[bool, "Whether it runs into the leader [-]."]
    contact_time: Annotated[Time | None, "Time from the start to the contact, if they touch [s]."]
    closing_speed: Annotated[RoadSpeed | None, "By how much the follower is faster then; none without contact [m/s]."]
    leader_speed: Annotated[RoadSpeed | None, "Speed of the leader then; none without contact [m/s]."]
    follower_speed: Annotated[RoadSpeed | None, "Speed of the follower then; none without contact [m/s]."]
    follower_distance: Annotated[Distance | None, "Distance of the follower up to then; none without contact [m]."]
    least_gap: Annotated[Length | None, "Minimum free distance, if they do not touch [m]."]
    least_gap_time: Annotated[Time | None, "When that is; none with a contact [s]."]
    sufficient_gap: Annotated[
        Length | None, "Least gap at time zero with which they do not touch; none if the follower stays faster [m]."
    ]
    missing_gap: Annotated[
        Length, "That gap less their own: above zero they touch; all of the gap if the follower stays faster [m]."
    ]
    moments: Annotated[tuple[OneBehind, ...], "Both, at equal steps of time up to the contact or to the end."]


def follow(
    *,
    leader: Annotated[Party, "The vehicle in front: its phases from time zero."],
    follower: Annotated[Party, "The vehicle behind it: its phases from time zero."],
    gap: Annotated[Length, "Free distance between them at time zero, e.g. 25 m [m]."],
    steps: Annotated[Count, "Rows of the time–distance table [-]."] = 8,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Following:
    """When and how fast a vehicle runs into the one before it, or how near it comes.

    Equation
    --------
    gap + s_leader(t) = s_follower(t), each s a polynomial of the time in every phase; after its last phase a vehicle
    keeps its speed.

    Returns
    -------
    Following
        The time, speeds and place of the first contact, or the least gap and its time; a table of both.

    Raises
    ------
    InadmissibleError
        When the gap is not above zero, a phase is impossible as given, or steps is not within 1 to 10000.

    Notes
    -----
    Both in one lane. The contact is sought until both speeds are constant, and beyond if the follower is faster.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 3 (straight-line motion).

    Examples
    --------
    >>> from dynamics_cli.numerics.road.phases import Kind, Phase
    >>> from dynamics_cli.skid.timing.timeline import StartSpeed
    >>> leader = Party(Phase(Kind("braking"), speed=0.0, acceleration=7.0), StartSpeed(20.0))
    >>> late = (Phase(Kind("reaction"), duration=1.1), Phase(Kind("braking"), speed=0.0, acceleration=6.5))
    >>> round(follow(leader=leader, follower=Party(late, StartSpeed(20.5)), gap=25.0).contact_time, 6)
    3.620055
    """
    require((steps >= 1) & (steps <= MOST_STEPS), "the table cannot have {steps} rows", code="steps", steps=steps)
    require(gap > 0.0, "the vehicles already touch: the gap is {gap}", code="no-gap", gap=(gap, Length))
    front, behind = (
        Course(motion_of(one, gravity, whose), 0.0, 0.0)
        for one, whose in ((leader, "the leader"), (follower, "the follower"))
    )
    last = max((motion.stretches[-1].origin for motion in (front, behind)), key=plain)

    def apart(ahead: "list[float]", rear: "list[float]") -> "list[float]":
        return _less([gap + ahead[0], *ahead[1:]], rear)

    contact = next((time for time, rises in changes(front, behind, apart, 0.0, plain(last)) if not rises), None)
    later = _later(front, behind, gap, last)
    nearest, when = _nearest(front, behind, gap, last)
    short = -nearest if later is None else gap
    enough = gap + short if later is None else None
    contact = later if contact is None else contact
    if contact is None:
        table = _table(front, behind, gap, last, steps)
        return Following(False, None, None, None, None, None, nearest, when, enough, short, tuple(table))
    _, slow, _ = front.at(contact)
    distance_behind, fast, _ = behind.at(contact)
    touching = OneBehind(contact, 0.0, front.at(contact)[0], slow, distance_behind, fast)
    rows = (*_table(front, behind, gap, contact, steps)[:-1], touching)
    return Following(True, contact, fast - slow, slow, fast, distance_behind, None, None, enough, short, rows)


def _later(front: Course, behind: Course, gap: float, last: float) -> "float | None":
    """The contact of two that keep their speeds from `last` on."""
    (ahead, slow, _), (rear, fast, _) = front.at(last + 1e-9), behind.at(last + 1e-9)
    if plain(fast) <= plain(slow):
        return None
    later: float = last + 1e-9 + (gap + ahead - rear) / (fast - slow)
    return later


def _nearest(front: Course, behind: Course, gap: float, last: float) -> "tuple[float, float]":
    """The least gap and when: where the speeds are equal, at a corner, at the start or at the end."""

    def faster(ahead: "list[float]", rear: "list[float]") -> "list[float]":
        return _less(derivative(ahead), derivative(rear))

    corners = [piece.origin for motion in (front, behind) for piece in motion.stretches[1:]]
    times = [*corners, *(time for time, _ in changes(front, behind, faster, 0.0, plain(last)))]
    gaps = [(gap + front.at(time)[0] - behind.at(time)[0], time) for time in times]
    return min(gaps, key=lambda entry: (plain(entry[0]), plain(entry[1])))


def _less(one: "list[float]", other: "list[float]") -> "list[float]":
    """The difference of two polynomials."""
    return [a - b for a, b in zip_longest(one, other, fillvalue=0.0)]


def _table(front: Course, behind: Course, gap: float, end: float, steps: int) -> "list[OneBehind]":
    """Both at equal steps of time."""
    rows = []
    for step in range(steps + 1):
        time = end * step / steps
        (ahead, slow, _), (rear, fast, _) = front.at(time), behind.at(time)
        rows.append(OneBehind(time, gap + ahead - rear, ahead, slow, rear, fast))
    return rows
