"""A body dropped on a floor: restitution from heights or times, and its series of bounces."""

from dynamics_cli.errors import require, require_given
from dynamics_cli.impact.conventions import Restituted
from dynamics_cli.impact.diagnostics import balance, not_above, require_sizes
from dynamics_cli.numerics.elementary import exp, log, sqrt, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Annotated,
    Count,
    Distance,
    Energy,
    Gravity,
    Length,
    Mass,
    Ratio,
    Restitution,
    Speed,
    Time,
)
from dynamics_cli.records import Advice, Check, record


@record
class ReboundHeight:
    """Restitution from the height that a bounce reaches."""

    rebound_height: Annotated[Distance, "Greatest height after the bounce, e.g. 0.64 m [m]."]
    after_bounces: Annotated[Count, "Number of the bounce, 1 for the first."] = 1


@record
class FlightTimes:
    """Restitution from two flights that follow each other, heard as three clicks."""

    flight_time: Annotated[Time, "Time from the first bounce to the second, e.g. 0.62 s [s]."]
    next_flight_time: Annotated[Time, "Time from the second bounce to the third, e.g. 0.53 s [s]."]


@record
class RestTime:
    """Restitution from the time until the bouncing ends."""

    rest_time: Annotated[Time, "Time from letting go until the body rests, e.g. 4.1 s [s]."]


@record
class Bounce:
    """One bounce and the flight after it."""

    number: Annotated[Count, "Number of the bounce, from 1."]
    time: Annotated[Time, "Time since letting go [s]."]
    impact_speed: Annotated[Speed, "Speed downwards [m/s]."]
    rebound_speed: Annotated[Speed, "Speed upwards [m/s]."]
    height: Annotated[Distance, "Greatest height after it [m]."]
    flight_time: Annotated[Time, "Time to the next bounce [s]."]


@record
class Dropped:
    """A dropped body's restitution and bounces."""

    restitution: Annotated[Restitution, "Coefficient of restitution [-]."]
    drop_height: Annotated[Distance, "Height it was dropped from [m]."]
    impact_speed: Annotated[Speed, "Speed at the first impact [m/s]."]
    fall_time: Annotated[Time, "Time of the fall to the first impact [s]."]
    time_to_rest: Annotated[Time | None, "Time until the endless series of bounces ends; none when e = 1 [s]."]
    way_to_rest: Annotated[Distance | None, "Whole way up and down until then; none when e = 1 [m]."]
    share_lost: Annotated[Ratio, "Share of the energy lost at every bounce, 1 − e² [-]."]
    energy_lost: Annotated[Energy | None, "Energy lost at the first bounce; needs the mass [J]."]
    bounces: Annotated[tuple[Bounce, ...], "The first bounces."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def drop(
    *,
    evidence: Annotated[
        Restituted | ReboundHeight | FlightTimes | RestTime,
        "The restitution, or a measurement that gives it: a height reached, two flight times, or the time to rest.",
    ],
    height: Annotated[
        Distance | None, "Height the body was dropped from; flight times give it when it is left out, e.g. 1 m [m]."
    ] = None,
    bounces: Annotated[Count, "Number of bounces to list."] = 5,
    mass: Annotated[Mass | None, "Mass of the body; needed only for the energy, e.g. 0.06 kg [kg]."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Dropped:
    """Restitution of a body dropped on a floor, from heights or times, and its series of bounces.

    Equation
    --------
    v = √(2gh); e = (h_n/h)^(1/2n) = t₂/t₁ = (T − t₀)/(T + t₀), t₀ = √(2h/g); h_n = e²ⁿ h; T = t₀ (1 + e)/(1 − e).

    Returns
    -------
    Dropped
        Restitution, speeds, heights and times of the bounces, time and distance until rest.

    Raises
    ------
    InadmissibleError
        When the height is missing or zero, a bounce is higher or a flight longer than the one before, or the body rests
        before it could have fallen.

    Notes
    -----
    The floor is fixed, air drag is neglected, and e is the same at every speed. Sums of the series are closed forms;
    near e = 1 they grow as 1/(1 − e).

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.10.

    Examples
    --------
    >>> result = drop(evidence=ReboundHeight(0.64), height=1.0)
    >>> round(result.restitution, 12), round(result.bounces[1].height, 12)
    (0.8, 0.4096)
    """
    require_sizes(evidence=evidence, height=height, mass=mass, gravity=gravity)
    require(bounces <= 10000, "{bounces} bounces are more than 10000", bounces=bounces, code="too-many")
    restitution, missing, height = _restitution(evidence, height, gravity)
    require(height > 0.0, "the height of the drop must be above zero", code="no-impact")
    fall = sqrt(2.0 * (height / gravity))
    speed = sqrt(2.0 * gravity * height)
    listed: list[Bounce] = []
    rise, moment, coming = height, fall, speed
    for number in range(1, bounces + 1):
        going = restitution * coming
        flight = 2.0 * going / gravity
        rise = restitution * restitution * rise
        listed.append(Bounce(number, moment, coming, going, rise, flight))
        moment, coming = moment + flight, going
    share = missing * (1.0 + restitution)
    ends = share > 0.0
    rest = fall * ((1.0 + restitution) / missing) if ends else None
    path = height * ((1.0 + restitution * restitution) / share) if ends else None
    return Dropped(
        restitution=restitution,
        drop_height=height,
        impact_speed=speed,
        fall_time=fall,
        time_to_rest=rest,
        way_to_rest=path,
        share_lost=share,
        energy_lost=None if mass is None else mass * gravity * height * share,
        bounces=tuple(listed),
        checks=_checks(listed, restitution, height, gravity),
        advice=_advice(restitution),
    )


def _restitution(
    evidence: Restituted | ReboundHeight | FlightTimes | RestTime, height: float | None, gravity: float
) -> tuple[float, float, float]:
    """Restitution e, 1 − e, and the height of the drop."""
    if isinstance(evidence, FlightTimes):
        first, second = evidence.flight_time, evidence.next_flight_time
        require(first > 0.0, "the first flight time must be above zero", code="no-flight")
        require(
            second <= first,
            "the second flight of {second:6} is longer than the first of {first:6}: a bounce would give energy",
            second=(second, Time),
            first=(first, Time),
            code="energy-gained",
        )
        restitution = second / first
        if height is None:
            require(restitution > 0.0, "the second flight time is zero, so the height is unknown", code="no-height")
            half = 0.5 * gravity * first / restitution
            height = 0.5 * half * (half / gravity)
        return restitution, (first - second) / first, height
    require_given(
        height is not None,
        "the height of the drop is missing",
        ("height",),
        ("flight_time", "next_flight_time"),
        code="no-height",
    )
    assert height is not None
    if isinstance(evidence, Restituted):
        return evidence.restitution, 1.0 - evidence.restitution, height
    require(height > 0.0, "the height of the drop must be above zero", code="no-impact")
    if isinstance(evidence, ReboundHeight):
        return *_from_height(evidence, height), height
    fall = sqrt(2.0 * (height / gravity))
    require(
        evidence.rest_time >= fall,
        "the body rests after {rest:6}, but the fall alone takes {fall:6}",
        rest=(evidence.rest_time, Time),
        fall=(fall, Time),
        code="too-early",
    )
    time_sum = evidence.rest_time + fall
    return (evidence.rest_time - fall) / time_sum, 2.0 * fall / time_sum, height


def _from_height(evidence: ReboundHeight, height: float) -> tuple[float, float]:
    """Restitution e and 1 − e, the latter from the difference of heights: no digits cancel."""
    require(
        evidence.rebound_height <= height,
        "a rebound to {rebound:9} from a drop of {height:9} would give energy",
        rebound=(evidence.rebound_height, Length),
        height=(height, Length),
        code="energy-gained",
    )
    require(evidence.after_bounces >= 1, "a height is reached after the first bounce or a later one", code="no-bounce")
    height_ratio = evidence.rebound_height / height
    count = evidence.after_bounces
    if count == 1:
        restitution = sqrt(height_ratio)
    else:
        reached = height_ratio > 0.0
        root = exp(log(where(reached, height_ratio, 1.0)) / (2.0 * count))
        restitution = where(reached, root, 0.0)
    if count > 1000:
        return restitution, 1.0 - restitution
    # 1 − e²ⁿ = (1 − e)(1 + e + … + e²ⁿ⁻¹)
    total: float = 1.0
    for _ in range(2 * count - 1):
        total = 1.0 + restitution * total
    return restitution, (height - evidence.rebound_height) / height / total


def _checks(listed: list[Bounce], restitution: float, height: float, gravity: float) -> tuple[Check, ...]:
    if not listed:
        return ()
    last = listed[-1]
    rise = 0.5 * last.rebound_speed * last.rebound_speed
    checks = balance("height of the last bounce from its speed", rise, gravity * last.height, gravity * height)
    checks += not_above("no energy is gained", last.height, height, height)
    return checks + balance("restitution", last.rebound_speed, restitution * last.impact_speed, listed[0].impact_speed)


def _advice(restitution: float) -> tuple[Advice, ...]:
    if not single(restitution) or plain(restitution) < 1.0:
        return ()
    words = "with e = 1 the body bounces for ever"
    return tuple(Advice("no-rest", words, severity="note", result=name) for name in ("time_to_rest", "way_to_rest"))
