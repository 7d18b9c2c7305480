"""Phases of a motion along a path: each given by its known quantities, chained forward or back from a known speed."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, hypot, maximum, sqrt, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import drag_along, require_drag
from dynamics_cli.numerics.road.leg import Leg
from dynamics_cli.numerics.road.start_up import start_up
from dynamics_cli.quantities import (
    Acceleration,
    Annotated,
    Distance,
    Fraction,
    Friction,
    RoadSpeed,
    Slope,
    SpeedFade,
    Time,
)
from dynamics_cli.records import Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Kind(Choice):
    """Kind of motion in a phase."""

    names = ("waiting", "constant", "reaction", "build-up", "braking", "coasting", "accelerating", "start-up")
    aliases = {  # noqa: RUF012
        "steady": "constant",
        "standing": "waiting",
        "sliding": "braking",
        "build": "build-up",
        "startup": "start-up",
    }


# Speed does not change in these.
EVEN = ("waiting", "constant", "reaction")


@record
class Phase:
    """One phase of a motion; it needs two of duration, distance, speed and acceleration, or one at constant speed."""

    kind: Annotated[
        Kind,
        "Kind of phase: waiting, constant, reaction, build-up, braking, coasting, accelerating, start-up; e.g. "
        "braking.",
    ]
    duration: Annotated[Time | None, "How long it takes, e.g. 1.2 s [s]."] = None
    distance: Annotated[Distance | None, "How far it goes, e.g. 14 m [m]."] = None
    speed: Annotated[
        RoadSpeed | None,
        "Speed at the end that the chain does not give: after the phase, before it when going back [m/s].",
    ] = None
    friction: Annotated[Friction | None, "Friction used while braking or sliding, e.g. 0.7 [-]."] = None
    grade: Annotated[Slope, "Rise over run in the direction of travel, with the friction [-]."] = 0.0
    braking: Annotated[Fraction, "Share of the friction that the brakes use [-]."] = 1.0
    acceleration: Annotated[
        Acceleration | None,
        "Change of speed in its amount: lost while braking or coasting, won while accelerating, e.g. 2 m/s^2 [m/s^2].",
    ] = None
    fade: Annotated[
        SpeedFade | None, "How much of a start-up's acceleration each m/s takes: a = α − βv, e.g. 0.12 1/s [1/s]."
    ] = None


def legs(
    phases: "tuple[Phase, ...]", gravity: float, *, start: "float | None", end: "float | None", whose: str = ""
) -> "list[Leg]":
    """The phases with all quantities, from the speed known at the start or at the end of all."""
    require(len(phases) > 0, "no phase is given", code="no-phase")
    if start is not None:
        speed, order = start, range(len(phases))
    else:
        assert end is not None
        speed, order = end, range(len(phases) - 1, -1, -1)
    chain: list[Any] = [None] * len(phases)
    for index in order:
        leg = _leg(phases, index, speed, gravity, whose, forward=start is not None)
        speed = leg.end if start is not None else leg.start
        chain[index] = leg
    return chain


def _leg(phases: "tuple[Phase, ...]", index: int, speed: float, gravity: float, whose: str, *, forward: bool) -> Leg:
    """One phase, from the speed at its known side."""
    phase = phases[index]
    name = f"phase {index + 1}: " if len(phases) > 1 else ""
    if whose:
        name = f"{whose}, {name}" if name else f"{whose}: "
    require(
        phase.fade is None or phase.kind == "start-up", "{name}fade has no meaning in a phase of {kind}",
        code="surplus", hint="kind=start-up is the phase whose acceleration falls with the speed",
        name=name, kind=str(phase.kind),
    )  # fmt: skip
    if phase.kind in EVEN:
        return _even(phase, speed, name, forward=forward)
    if phase.kind == "start-up":
        return start_up(phase, speed, name, forward=forward)
    if phase.kind == "build-up":
        return _build_up(phases, index, speed, gravity, name, forward=forward)
    amount = rate_of(phase, gravity, name)
    slowing = phase.kind != "accelerating"
    away = None if amount is None else (-amount if slowing == forward else amount)
    other, duration, distance, away = _uniform(speed, phase, away, name)
    require(
        (other <= speed) if slowing == forward else (other >= speed),
        "{name}a phase of {kind} cannot lead from {before} to {after}",
        code="wrong-direction",
        hint="check the phase's speed, distance and duration, or its kind",
        name=name, kind=str(phase.kind),
        before=(speed if forward else other, RoadSpeed), after=(other if forward else speed, RoadSpeed),
    )  # fmt: skip
    if forward:
        return Leg(str(phase.kind), speed, other, duration, distance, away)
    return Leg(str(phase.kind), other, speed, duration, distance, -away)


def rate_of(phase: Phase, gravity: float, name: str = "") -> "float | None":
    """The amount of a phase's acceleration: as given, or by its friction and grade."""
    require(
        phase.friction is None or phase.acceleration is None,
        "{name}friction and acceleration are both given; one of them determines how the speed changes",
        code="twice",
        hint="give one of them",
        name=name,
    )
    if phase.friction is not None:
        return gravity * require_drag(drag_along(phase.friction, phase.grade, phase.braking), name)
    return phase.acceleration


def _even(phase: Phase, speed: float, name: str, *, forward: bool) -> Leg:
    """A phase at constant speed: by its duration or its distance."""
    duration, distance = phase.duration, phase.distance
    for word in ("friction", "acceleration"):
        require(
            getattr(phase, word) is None, "{name}{word} has no meaning in a phase of {kind}",
            code="even", hint="braking, coasting and accelerating change the speed",
            name=name, word=word, kind=str(phase.kind),
        )  # fmt: skip
    if phase.kind == "waiting":
        # a pedestrian is assumed to reach walking speed at once: going back, waiting ends where the walk begins
        require(
            (speed == 0.0) | (not forward), "{name}a phase of waiting begins and ends at rest, not at {speed}",
            code="moving", hint="use kind=constant for a steady speed", name=name, speed=(speed, RoadSpeed),
        )  # fmt: skip
        _require_count(phase, ("duration",), 1, name)
        assert duration is not None
        return Leg("waiting", 0.0 * speed, 0.0 * speed, duration, 0.0 * duration, 0.0)
    if phase.speed is not None:
        require(
            speed == phase.speed or speed == 0.0,
            "{name}the speed of {own} is not the {chain} of the adjacent phase",
            code="speeds-differ", hint="leave the speed out: it follows from the adjacent phase",
            name=name, own=(phase.speed, RoadSpeed), chain=(speed, RoadSpeed),
        )  # fmt: skip
        speed = phase.speed
    _require_count(phase, ("duration", "distance"), 1, name)
    if duration is not None:
        return Leg(str(phase.kind), speed, speed, duration, speed * duration, 0.0)
    assert distance is not None
    require(speed > 0.0, "{name}a party at rest covers no distance", code="at-rest", hint="give its speed", name=name)
    return Leg(str(phase.kind), speed, speed, distance / speed, distance, 0.0)


def _build_up(
    phases: "tuple[Phase, ...]", index: int, speed: float, gravity: float, name: str, *, forward: bool
) -> Leg:
    """A phase in which the deceleration rises linearly from zero to that of the braking after it."""
    phase = phases[index]
    _require_count(phase, ("duration",), 1, name)
    rate = rate_of(phase, gravity, name)
    after = phases[index + 1] if index + 1 < len(phases) else None
    if rate is None and after is not None and after.kind == "braking":
        rate = rate_of(after, gravity, f"phases[{index + 1}]: ")
    require(
        rate is not None, "{name}the deceleration that the build-up leads to is not known",
        code="no-rate", hint="give friction or acceleration in it, or in the braking after it", name=name,
    )  # fmt: skip
    assert phase.duration is not None
    assert rate is not None
    duration: Any = phase.duration
    lost = 0.5 * rate * duration
    start = speed if forward else speed + lost
    end = speed - lost if forward else speed
    require(
        end >= 0.0, "{name}the vehicle stops within the build-up, after {time}",
        code="stops-early", hint="a shorter build-up, or none",
        name=name, time=(sqrt(2.0 * start * duration / maximum(rate, 1e-300)), Time),
    )  # fmt: skip
    return Leg("build-up", start, end, duration, duration * (end + 2.0 * lost / 3.0), -rate)


def _require_count(phase: Phase, words: "tuple[str, ...]", count: int, name: str) -> None:
    """Refuse a phase with more or fewer quantities than it needs."""
    present = [word for word in words if getattr(phase, word) is not None]
    everything = ("duration", "distance") if phase.kind in EVEN else ("duration", "distance", "speed")
    surplus = [word for word in everything if word not in words and getattr(phase, word) is not None]
    require(
        not surplus, "{name}{words} has no meaning in a phase of {kind}",
        code="surplus", name=name, words=" and ".join(surplus), kind=str(phase.kind),
    )  # fmt: skip
    require(
        len(present) == count, "{name}a phase of {kind} needs {wanted}, and {given} given",
        code="incomplete" if len(present) < count else "twice",
        name=name, kind=str(phase.kind),
        wanted=f"its {words[0]}" if len(words) == 1 else f"either {' or '.join(words)}",
        given="neither is" if not present else "both are" if len(present) > 1 else f"{present[0]} is",
    )  # fmt: skip


def _uniform(speed: float, phase: Phase, rate: "float | None", name: str) -> "tuple[float, float, float, float]":
    """Speed at the other side, duration, distance and rate, seen from the side whose speed is known.

    Going back in time is going forward with the rate's sign turned.
    """
    time, covered, other = phase.duration, phase.distance, phase.speed
    quantities = ("duration", time), ("distance", covered), ("speed", other)
    present = [word for word, value in quantities if value is not None]
    needed = 2 if rate is None else 1
    rate_word = [] if rate is None else ["friction" if phase.friction is not None else "acceleration"]
    require(
        len(present) == needed,
        "{name}a phase of {kind} needs two of its duration, distance, speed and acceleration (or friction), "
        "and {given} given",
        code="incomplete" if len(present) < needed else "twice",
        hint=f"give {' or '.join(_lacking(phase, present, rate))}"
        if len(present) < needed
        else "leave one of them out",
        name=name, kind=str(phase.kind),
        given=_and([*present, *rate_word]),
    )  # fmt: skip
    if rate is None:
        return _by_two(speed, time, covered, other, name)
    if time is not None:
        other = speed + rate * time
        require(
            other >= 0.0, "{name}the party is at rest after {rest}, before the {time} of the phase are over",
            code="stops-early", hint="end the phase there and wait", name=name,
            rest=(speed / absolute(where(rate == 0.0, 1.0, rate)), Time), time=(time, Time),
        )  # fmt: skip
        return other, time, time * (speed + 0.5 * rate * time), rate
    if covered is not None:
        square = speed * speed + 2.0 * rate * covered
        require(
            square >= 0.0, "{name}the party is at rest after {rest}, before the {way} of the phase are over",
            code="stops-early", hint="end the phase there and wait", name=name,
            rest=(0.5 * speed * speed / absolute(where(rate == 0.0, 1.0, rate)), Distance), way=(covered, Distance),
        )  # fmt: skip
        if single(rate):
            other = hypot(speed, sqrt(2.0 * rate * covered)) if plain(rate) >= 0.0 else sqrt(square)
        else:
            other = where(rate >= 0.0, hypot(speed, sqrt(2.0 * maximum(rate, 0.0) * covered)), sqrt(square))
        return other, _crossing(covered, speed, other, name), covered, rate
    assert other is not None
    require(rate != 0.0, "{name}without acceleration the speed does not change", code="no-rate", name=name)
    time = (other - speed) / rate
    require(
        time >= 0.0, "{name}a phase of {kind} cannot lead to a speed of {other}", code="wrong-direction",
        name=name, kind=str(phase.kind), other=(other, RoadSpeed),
    )  # fmt: skip
    return other, time, 0.5 * time * (speed + other), rate


def _by_two(
    speed: float, time: "float | None", way: "float | None", other: "float | None", name: str
) -> "tuple[float, float, float, float]":
    """The same, with the rate from duration, distance and speed."""
    if way is None:
        assert time is not None
        assert other is not None
        way = 0.5 * time * (speed + other)
    elif time is None:
        assert other is not None
        time = _crossing(way, speed, other, name)
    else:
        require(time > 0.0, "{name}a distance needs a time above zero", code="no-time", name=name)
        other = 2.0 * way / time - speed
        require(
            other >= 0.0, "{name}{way} in {time} is too short: the party would have to turn back",
            code="stops-early", name=name, way=(way, Distance), time=(time, Time),
        )  # fmt: skip
    require(time > 0.0, "{name}a change of speed needs a time above zero", code="no-time", name=name)
    return other, time, way, (other - speed) / time


def _lacking(phase: Phase, known: "list[str]", rate: "float | None") -> "list[str]":
    """The quantities of a phase that are not given yet, as they are written."""
    named = (("distance", "14 m"), ("duration", "1.2 s"), ("speed", "0 m/s"))
    lacking = [f"{word}={value}" for word, value in named if word not in known]
    if rate is None:
        lacking[:0] = ["friction=0.7"] if phase.kind == "braking" else ["acceleration=2 m/s^2"]
    return lacking


def _crossing(way: float, speed: float, other: float, name: str) -> float:
    """Time of a distance at a uniformly changing speed."""
    speed_sum = speed + other
    require((speed_sum > 0.0) | (way == 0.0), "{name}a party at rest covers no distance", code="at-rest", name=name)
    return 2.0 * way / where(speed_sum > 0.0, speed_sum, 1.0)


def _and(words: "list[str]") -> str:
    return "none is" if not words else " and ".join(words) + (" are" if len(words) > 1 else " is")
