"""The pre-crash table of an event data recorder: distance, braking and event speed from its speeds."""

from itertools import pairwise

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute, maximum, sqrt, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Annotated,
    Count,
    Distance,
    DragFactor,
    Fraction,
    Gravity,
    Ratio,
    RoadSpeed,
    Time,
)
from dynamics_cli.records import Advice, record
from dynamics_cli.skid.timing.recorded import ListedSpeeds, Samples, SpeedFile

KILOMETRE_PER_HOUR = 1.0 / 3.6
# 49 CFR 563.8: recorded speeds end here.
END_OF_RANGE = 200.0 / 3.6
HARD_BRAKING = 0.4
MOST_OF_TYRES = 1.0


@record
class Interval:
    """One sample, and the interval up to the next."""

    time_left: Annotated[Time, "Time to the last sample [s]."]
    speed: Annotated[RoadSpeed, "Recorded speed [m/s]."]
    distance_left: Annotated[Distance, "Distance to the last sample [m]."]
    acceleration: Annotated[
        Acceleration | None, "Mean change of speed to the next sample; none after the last [m/s^2]."
    ]
    drag_factor: Annotated[DragFactor | None, "The mean deceleration over gravity; none where it did not slow [-]."]


@record
class SkidRecord:
    """Results from the recorded speeds."""

    distance: Annotated[Distance, "Distance from the first sample to the last [m]."]
    distance_deviation: Annotated[Distance, "Its standard deviation, from tolerance and rounding of the record [m]."]
    common_deviation: Annotated[Distance, "The part of an error that all samples share [m]."]
    rounding_deviation: Annotated[Distance, "The part of the rounding of each sample [m]."]
    least_distance: Annotated[
        Distance | None, "Least distance whatever the speed did between samples; needs the greatest acceleration [m]."
    ]
    greatest_distance: Annotated[
        Distance | None, "Greatest distance whatever it did between samples; needs the greatest acceleration [m]."
    ]
    least_event_speed: Annotated[
        RoadSpeed, "Least speed at the event: the last deceleration goes on up to it, less slip of the wheels [m/s]."
    ]
    greatest_event_speed: Annotated[
        RoadSpeed, "Maximum speed at the event: the last sample with the largest slip [m/s]."
    ]
    greatest_to_event: Annotated[Distance, "Greatest distance from the last sample to the event [m]."]
    greatest_deceleration: Annotated[Acceleration, "Greatest mean deceleration between two samples [m/s^2]."]
    greatest_drag_factor: Annotated[DragFactor, "The same over gravity [-]."]
    brake_earliest: Annotated[
        Time | None, "Earliest onset of braking, before the event; needs the sample at which the brake is on [s]."
    ]
    brake_latest: Annotated[
        Time | None, "Latest onset of braking, before the event; needs the sample at which the brake is on [s]."
    ]
    speed_before_braking: Annotated[
        RoadSpeed | None, "Recorded speed before the brake was on; needs the sample at which the brake is on [m/s]."
    ]
    intervals: Annotated[tuple[Interval, ...], "The samples, with distances and accelerations."]
    advice: tuple[Advice, ...] = ()


def record_of(
    *,
    recorded: Annotated[ListedSpeeds | SpeedFile, "The recorded speeds, listed or in a file."],
    least_age: Annotated[Time, "Least age of the last sample at the event [s]."] = 0.0,
    greatest_age: Annotated[Time | None, "Greatest age of the last sample; one interval unless given [s]."] = None,
    brake_on: Annotated[
        Count | None, "Number of the first sample at which the brake switch is on, counted from 1, e.g. 6 [-]."
    ] = None,
    greatest_acceleration: Annotated[
        Acceleration | None, "The most that tyres can change the speed, e.g. 9 m/s^2; wanted for limits [m/s^2]."
    ] = None,
    least_slip: Annotated[Fraction, "Least slip of the braked wheels at the last sample, e.g. 8 % [-]."] = 0.0,
    greatest_slip: Annotated[Fraction, "Greatest slip of the braked wheels there, e.g. 18 % [-]."] = 0.0,
    tolerance: Annotated[RoadSpeed, "Limit of an error that all samples share [m/s]."] = KILOMETRE_PER_HOUR,
    resolution: Annotated[RoadSpeed, "Step to which each sample is rounded [m/s]."] = KILOMETRE_PER_HOUR,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> SkidRecord:
    """Distances, decelerations and the speed at the event from the speeds that an event data recorder kept.

    Equation
    --------
    s = Σ (vᵢ + vᵢ₊₁)Δt/2; within |a| ≤ A it lies within ± Σ (A²Δt² − Δv²)/(4A). At the event v = vₙ − dδ with the last
    deceleration d and the age δ of the last sample; wheels that slip by s are slower than the vehicle: v/(1 − s).
    σ² = (T·c/√3)² + Σ wᵢ²·(r/√12)², c the tolerance, r the resolution.

    Returns
    -------
    SkidRecord
        Distance with its deviation and limits, speed at the event, onset of braking, and every interval.

    Raises
    ------
    InadmissibleError
        When fewer than two speeds are given, a jump exceeds the greatest acceleration, an age or slip is not within
        its limits, or the sample of the brake is not one of them.

    Notes
    -----
    Tolerance and resolution are those that 49 CFR 563.8, table III, asks of recorders (±1 km/h, 1 km/h), as limits:
    uniform, the first common to all samples, the second of each. Wheel speed is not vehicle speed.

    References
    ----------
    49 CFR 563.8, table III (tolerances); limits between samples derived.

    Examples
    --------
    >>> result = record_of(recorded=ListedSpeeds((20.0, 18.0, 12.0, 6.0)))
    >>> round(result.distance, 6), round(result.least_event_speed, 6)
    (21.5, 0.0)
    """
    samples = Samples(recorded)
    speeds, interval = samples.speeds, samples.interval
    count = len(speeds)
    least_age = least_age + samples.ended
    oldest = samples.ended + (interval if greatest_age is None else greatest_age)
    brake_on = samples.brake_on if brake_on is None else brake_on
    _require_record(count, interval, (least_age, oldest), (least_slip, greatest_slip))
    changes = [(after - before) / interval for before, after in pairwise(speeds)]
    rows, distance = _rows(speeds, changes, interval, gravity)
    common = (count - 1) * interval * tolerance / sqrt(3.0 + 0.0 * tolerance)
    rounding = interval * sqrt(count - 1.5 + 0.0 * resolution) * resolution / sqrt(12.0 + 0.0 * resolution)
    least, greatest = _limits(speeds, interval, greatest_acceleration, distance)
    last = maximum(-changes[-1], 0.0 * changes[-1])
    hardest = maximum(_largest([-change for change in changes]), 0.0 * changes[0])
    earlier_speed = maximum(speeds[-1] - last * oldest, 0.0 * last)
    earliest = latest = before = None
    if brake_on is not None:
        require(
            (brake_on >= 1) & (brake_on <= count), "there is no sample {number}: {count} are given",
            code="brake", number=int(brake_on), count=count,
        )  # fmt: skip
        after = (count - int(brake_on)) * interval
        latest = after + least_age
        earliest = None if brake_on == 1 else after + interval + oldest
        before = speeds[max(int(brake_on) - 2, 0)]
    return SkidRecord(
        distance=distance,
        distance_deviation=sqrt(common * common + rounding * rounding),
        common_deviation=common,
        rounding_deviation=rounding,
        least_distance=least,
        greatest_distance=greatest,
        least_event_speed=earlier_speed / (1.0 - least_slip),
        greatest_event_speed=maximum(speeds[-1] - last * least_age, 0.0 * last) / (1.0 - greatest_slip),
        greatest_to_event=speeds[-1] * oldest / (1.0 - greatest_slip),
        greatest_deceleration=hardest,
        greatest_drag_factor=hardest / gravity,
        brake_earliest=earliest,
        brake_latest=latest,
        speed_before_braking=before,
        intervals=tuple(rows),
        advice=_stops_early(speeds[-1], interval, least_age, oldest) + _advice(speeds, changes, greatest_slip, gravity),
    )


def _require_record(count: int, interval: float, ages: "tuple[float, float]", slips: "tuple[float, float]") -> None:
    """Refuse a record without an interval, and limits in the wrong order."""
    require(
        count >= 2, "a record needs at least two speeds, and {count} is given", code="too-few", count=count,
        hint="write them in the order of time: --speeds '78, 77, 66 km/h'",
    )  # fmt: skip
    require(interval > 0.0, "samples must be some time apart", code="no-time", hint="leave the interval out for 0.5 s")
    require(
        ages[1] >= ages[0], "the greatest age, {oldest}, is below the least age, {least}", code="ages",
        oldest=(ages[1], Time), least=(ages[0], Time),
    )  # fmt: skip
    require(
        (slips[1] >= slips[0]) & (slips[1] < 1.0), "the slip cannot range from {least} to {greatest}", code="slip",
        least=(slips[0], Fraction), greatest=(slips[1], Fraction), hint="the least first, both below 100 %",
    )  # fmt: skip


def _largest(values: "list[float]") -> float:
    """The largest of some numbers of any kind."""
    most = values[0]
    for value in values[1:]:
        most = maximum(most, value)
    return most


def _rows(
    speeds: "tuple[float, ...]", changes: "list[float]", interval: float, gravity: float
) -> "tuple[list[Interval], float]":
    """The table from the last sample back, and the whole distance."""
    rows = [Interval(0.0 * interval, speeds[-1], 0.0 * speeds[-1], None, None)]
    way = 0.0 * speeds[-1]
    for index in range(len(speeds) - 2, -1, -1):
        way = way + 0.5 * interval * (speeds[index] + speeds[index + 1])
        slower = single(changes[index]) and plain(changes[index]) < 0.0
        drag = -changes[index] / gravity if slower else None
        rows.append(Interval((len(speeds) - 1 - index) * interval, speeds[index], way, changes[index], drag))
    rows.reverse()
    return rows, way


def _limits(
    speeds: "tuple[float, ...]", interval: float, most: "float | None", distance: float
) -> "tuple[float | None, float | None]":
    """Minimum and maximum distance if the acceleration between samples is at most `most`."""
    if most is None:
        return None, None
    more = less = 0.0 * distance
    reach = most * interval
    for before, after in pairwise(speeds):
        change, both = after - before, before + after
        require(
            absolute(change) <= reach, "from {before} to {after} the record needs {needed}; at most {most} is possible",
            code="jump", hint="a wheel that locked or spun is not the vehicle's speed",
            before=(before, RoadSpeed), after=(after, RoadSpeed), needed=(absolute(change) / interval, Acceleration),
            most=(most, Acceleration),
        )  # fmt: skip
        room = 0.25 * (reach * reach - change * change) / most
        more = more + room
        # it may stand for a while
        stopped = 0.5 * interval * both - 0.5 * (before * before + after * after) / most
        less = less + where(both < reach, stopped, room)
    return distance - less, distance + more


def _stops_early(speed: float, interval: float, least_age: float, oldest: float) -> "tuple[Advice, ...]":
    """A caution when the samples next to the event are missing."""
    if not single(speed, interval, least_age, oldest):
        return ()
    if plain(least_age) < plain(interval) and plain(oldest) <= 2.0 * plain(interval):
        return ()
    message = worded(
        "the record stops {least} to {greatest} before the event, at {speed}: up to {way:3} of the way are not in it, "
        "and the last deceleration is taken to go on",
        least=(least_age, Time), greatest=(oldest, Time), speed=(speed, RoadSpeed), way=(speed * oldest, Distance),
    )  # fmt: skip
    return (Advice(code="stops-early", message=message, remedy="look for the samples that are missing"),)


def _advice(speeds: "tuple[float, ...]", changes: "list[float]", slip: float, gravity: float) -> "tuple[Advice, ...]":
    """Advice on causes of recorded speeds that differ from the vehicle's."""
    if not single(*speeds, *changes, gravity, slip):
        return ()
    advice: list[Advice] = []
    hardest, at = max((abs(plain(change)), index) for index, change in enumerate(changes))
    braked = max(-plain(change) for change in changes)
    if hardest > MOST_OF_TYRES * plain(gravity):
        advice.append(
            Advice(
                code="wheel-locked",
                message=worded(
                    "from {before} to {after} the record needs {drag:3} g, and tyres give about 1 g: a wheel locked "
                    "or spun, so this is not the vehicle's speed", drag=(hardest / plain(gravity), Ratio),
                    before=(speeds[at], RoadSpeed), after=(speeds[at + 1], RoadSpeed),
                ),
                severity="serious",
            )
        )  # fmt: skip
    elif braked > HARD_BRAKING * plain(gravity) and plain(slip) == 0.0:
        advice.append(
            Advice(
                code="wheel-slip",
                message="braked wheels turn slower than the vehicle travels: the record reads low",
                remedy="give --least-slip and --greatest-slip; tests with ABS found 8 to 18 %",
            )
        )
    if max(plain(speed) for speed in speeds) >= END_OF_RANGE:
        advice.append(
            Advice(code="end-of-range", message="recorders need not show more than 200 km/h: it may have been faster")
        )
    return tuple(advice)
