"""A body dropped on a floor: restitution from heights or times, and the whole series of bounces."""

from dynamics_cli.errors import require
from dynamics_cli.impact.conventions import Restituted
from dynamics_cli.impact.diagnostics import balance, not_above, plain, require_sizes, single
from dynamics_cli.numerics.elementary import exp, log, sqrt, where
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Count,
    Distance,
    Energy,
    Gravity,
    Mass,
    Ratio,
    Restitution,
    Speed,
    Time,
)
from dynamics_cli.records import Advice, Check, record


@record
class ReboundHeight:
    """Restitution from the height that a bounce reaches.

    Parameters
    ----------
    rebound_height : Distance
        Greatest height after the bounce [m].
    after_bounces : Count
        Which bounce it was, 1 for the first.
    """

    rebound_height: Distance
    after_bounces: Count = 1


@record
class FlightTimes:
    """Restitution from two flights that follow each other, heard as three clicks.

    Parameters
    ----------
    flight_time : Time
        Time from the first bounce to the second [s].
    next_flight_time : Time
        Time from the second bounce to the third [s].
    """

    flight_time: Time
    next_flight_time: Time


@record
class RestTime:
    """Restitution from the time until the bouncing ends.

    Parameters
    ----------
    rest_time : Time
        Time from letting go until the body rests [s].
    """

    rest_time: Time


@record
class Bounce:
    """One bounce and the flight after it.

    Parameters
    ----------
    number : Count
        Which bounce, from 1.
    time : Time
        Time since letting go [s].
    impact_speed : Speed
        Speed downwards [m/s].
    rebound_speed : Speed
        Speed upwards [m/s].
    height : Distance
        Greatest height after it [m].
    flight_time : Time
        Time to the next bounce [s].
    """

    number: Count
    time: Time
    impact_speed: Speed
    rebound_speed: Speed
    height: Distance
    flight_time: Time


@record
class Dropped:
    """A dropped body's restitution and bounces.

    Parameters
    ----------
    restitution : Restitution
        Coefficient of restitution [-].
    drop_height : Distance
        Height it was dropped from [m].
    impact_speed : Speed
        Speed at the first impact [m/s].
    fall_time : Time
        Time of the fall to the first impact [s].
    time_to_rest : Time
        Time until the endless series of bounces ends; none when e = 1 [s].
    way_to_rest : Distance
        Whole way up and down until then; none when e = 1 [m].
    share_lost : Ratio
        Share of the energy lost at every bounce, 1 − e² [-].
    energy_lost : Energy
        Energy lost at the first bounce; needs the mass [J].
    bounces : tuple[Bounce, ...]
        The first bounces.
    """

    restitution: Restitution
    drop_height: Distance
    impact_speed: Speed
    fall_time: Time
    time_to_rest: Time | None
    way_to_rest: Distance | None
    share_lost: Ratio
    energy_lost: Energy | None
    bounces: tuple[Bounce, ...]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def drop(
    *,
    evidence: Restituted | ReboundHeight | FlightTimes | RestTime,
    height: Distance | None = None,
    bounces: Count = 5,
    mass: Mass | None = None,
    gravity: Gravity = STANDARD_GRAVITY,
) -> Dropped:
    """Restitution of a body dropped on a floor, from heights or times, and its series of bounces.

    Equation
    --------
    v = √(2gh); e = (h_n/h)^(1/2n) = t₂/t₁ = (T − t₀)/(T + t₀), t₀ = √(2h/g); h_n = e²ⁿ h; T = t₀ (1 + e)/(1 − e).

    Parameters
    ----------
    evidence : Restituted | ReboundHeight | FlightTimes | RestTime
        The restitution, or what it is found from: a height reached, two flight times, or the time to rest.
    height : Distance
        Height the body was dropped from; flight times give it when it is left out [m].
    bounces : Count
        How many bounces to list.
    mass : Mass
        Mass of the body; wanted for the energy only [kg].
    gravity : Gravity
        Acceleration of gravity [m/s^2].

    Returns
    -------
    Dropped
        Restitution, speeds, heights and times of the bounces, time and way until rest.

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
    >>> found = drop(evidence=ReboundHeight(0.64), height=1.0)
    >>> round(found.restitution, 12), round(found.bounces[1].height, 12)
    (0.8, 0.4096)
    """
    require_sizes(evidence=evidence, height=height, mass=mass, gravity=gravity)
    require(bounces <= 10000, f"{bounces} bounces are more than a list should hold", code="too-many")
    restitution, missing, height = _found(evidence, height, gravity)
    require(height > 0.0, "a drop from a height of {0:.6g} m is no impact", height, code="no-impact")
    fall = sqrt(2.0 * (height / gravity))
    speed = sqrt(2.0 * gravity * height)
    listed: list[Bounce] = []
    way, moment, coming = height, fall, speed
    for number in range(1, bounces + 1):
        going = restitution * coming
        flight = 2.0 * going / gravity
        way = restitution * restitution * way
        listed.append(Bounce(number, moment, coming, going, way, flight))
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


def _found(
    evidence: Restituted | ReboundHeight | FlightTimes | RestTime, height: float | None, gravity: float
) -> tuple[float, float, float]:
    """Restitution, what it lacks of 1 and the height of the drop."""
    if isinstance(evidence, FlightTimes):
        first, second = evidence.flight_time, evidence.next_flight_time
        require(first > 0.0, "a flight of {0:.6g} s is no bounce", first, code="no-flight")
        require(
            second <= first,
            "the second flight of {0:.6g} s is longer than the first of {1:.6g} s: a bounce would give energy",
            second,
            first,
            code="energy-gained",
        )
        restitution = second / first
        if height is None:
            require(restitution > 0.0, "without a second flight the height is unknown", code="no-height")
            half = 0.5 * gravity * first / restitution
            height = 0.5 * half * (half / gravity)
        return restitution, (first - second) / first, height
    require(
        height is not None,
        "the height of the drop is missing",
        code="no-height",
        hint="give --height; only two flight times do without it",
    )
    assert height is not None
    if isinstance(evidence, Restituted):
        return evidence.restitution, 1.0 - evidence.restitution, height
    require(height > 0.0, "a drop from a height of {0:.6g} m is no impact", height, code="no-impact")
    if isinstance(evidence, ReboundHeight):
        return *_from_height(evidence, height), height
    fall = sqrt(2.0 * (height / gravity))
    require(
        evidence.rest_time >= fall,
        "the body rests after {0:.6g} s, but the fall alone takes {1:.6g} s",
        evidence.rest_time,
        fall,
        code="too-early",
    )
    whole = evidence.rest_time + fall
    return (evidence.rest_time - fall) / whole, 2.0 * fall / whole, height


def _from_height(evidence: ReboundHeight, height: float) -> tuple[float, float]:
    """Restitution, and what it lacks of 1: of equal heights that is their difference, not that of roots."""
    require(
        evidence.rebound_height <= height,
        "a rebound to {0:.6g} m from a drop of {1:.6g} m would give energy",
        evidence.rebound_height,
        height,
        code="energy-gained",
    )
    require(evidence.after_bounces >= 1, "a height is reached after the first bounce or a later one", code="no-bounce")
    share = evidence.rebound_height / height
    count = evidence.after_bounces
    if count == 1:
        restitution = sqrt(share)
    else:
        reached = share > 0.0
        root = exp(log(where(reached, share, 1.0)) / (2.0 * count))
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
    checks += not_above("energy never gained", last.height, height, height)
    return checks + balance("restitution", last.rebound_speed, restitution * last.impact_speed, listed[0].impact_speed)


def _advice(restitution: float) -> tuple[Advice, ...]:
    if not single(restitution) or plain(restitution) < 1.0:
        return ()
    words = "with e = 1 the body bounces for ever"
    return tuple(Advice("no-rest", words, severity="note", result=name) for name in ("time_to_rest", "way_to_rest"))
