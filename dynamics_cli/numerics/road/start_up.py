"""A start-up whose acceleration falls with the speed, a = α − βv, from its first speed or back from its last."""

from math import expm1, inf, log1p, sqrt

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import exp as any_exp
from dynamics_cli.numerics.elementary import maximum, only_in_doubles, over_array
from dynamics_cli.numerics.number import is_array, is_carrier, plain
from dynamics_cli.numerics.road.leg import Leg, faded
from dynamics_cli.quantities import Acceleration, Distance, RoadSpeed, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_STEPS = 100


def start_up(phase: "Any", speed: float, name: str, *, forward: bool) -> Leg:
    """The leg of a start-up, from the speed at the side where the chain comes from."""
    alpha, fade = phase.acceleration, phase.fade
    require(
        phase.friction is None and alpha is not None and fade is not None,
        "{name}a phase of start-up needs its acceleration at rest and its fade, and no friction",
        name=name, code="incomplete", hint="for example acceleration=2 m/s^2, fade=0.12 1/s",
    )  # fmt: skip
    rate_now = alpha - fade * speed
    require(
        rate_now > 0.0,
        "{name}at {speed} nothing is left of the acceleration of {alpha}: the fade takes all of it",
        name=name, speed=(speed, RoadSpeed), alpha=(alpha, Acceleration), code="beyond-top-speed",
        hint="the top speed is acceleration over fade",
    )  # fmt: skip
    rate, bend = (rate_now, fade) if forward else (-rate_now, -fade)
    present = [word for word in ("duration", "distance", "speed") if getattr(phase, word) is not None]
    require(
        len(present) == 1, "{name}a phase of start-up needs one of its duration, distance and speed, and {given} given",
        name=name, given=" and ".join(present) + " are" if present else "none is",
        code="twice" if present else "incomplete",
    )  # fmt: skip
    duration = phase.duration
    if duration is None:
        duration = _time(speed, rate, bend, phase.distance, phase.speed, name)
    gained, more = faded(duration, bend)
    other = speed + rate * gained
    require(
        other >= -1e-12 * speed,
        "{name}going back {time} from {speed} leads below rest", name=name, time=(duration, Time),
        speed=(speed, RoadSpeed), code="stops-early", hint="a shorter phase: it began at rest",
    )  # fmt: skip
    other = maximum(other, 0.0) if phase.speed is None else phase.speed
    covered = speed * duration + rate * more if phase.distance is None else phase.distance
    if forward:
        return Leg("start-up", speed, other, duration, covered, rate_now, fade)
    return Leg("start-up", other, speed, duration, covered, alpha - fade * other, fade)


def _time(speed: "Any", rate: "Any", bend: "Any", way: "Any", other: "Any", name: str) -> "Any":
    """Time to a distance or a speed: a root in doubles, then one Newton step with bounds and derivatives."""
    to_way = way is not None
    target = way if to_way else other
    numbers = (speed, rate, bend, target)
    only_in_doubles(*numbers)
    function = _time_to_way if to_way else _time_to_speed
    if any(is_array(number) for number in numbers):
        time = over_array(function, *numbers)
    else:
        time = function(*map(plain, numbers))
    possible = time < inf
    if to_way:
        require(
            possible, "{name}a start-up to {speed} cannot be {way} long: it began at rest after less", name=name,
            speed=(speed, RoadSpeed), way=(way, Distance), code="too-long", hint="a shorter distance, or let it wait",
        )  # fmt: skip
    else:
        require(
            possible, "{name}a start-up does not lead from {speed} to {other}", name=name, speed=(speed, RoadSpeed),
            other=(other, RoadSpeed), code="wrong-direction", hint="look at the speeds, at acceleration and fade",
        )  # fmt: skip
    if not any(is_carrier(number) for number in numbers):
        return time
    gained, more = faded(time, bend)
    reached, slope = (
        (speed * time + rate * more, speed + rate * gained)
        if to_way
        else (speed + rate * gained, rate * any_exp(-bend * time))
    )
    return time - (reached - target) / plain(slope) if plain(slope) != 0.0 else time


def _time_to_speed(speed: float, rate: float, bend: float, other: float) -> float:
    """When v + r(1 − e^(−βt))/β is the other speed; endless when it never is."""
    relative = (other - speed) / rate
    if relative < 0.0:
        return inf
    inside = relative * bend
    if inside >= 1.0:
        return inf
    return relative if bend == 0.0 else -log1p(-inside) / bend


def _time_to_way(speed: float, rate: float, bend: float, way: float) -> float:
    """When the distance is covered; endless when the motion ends before. Halving a bracket that Newton's steps keep."""

    def states(time: float) -> tuple[float, float]:
        turned = bend * time
        if abs(turned) < 1e-3:
            gained = time * (1.0 - turned / 2.0 * (1.0 - turned / 3.0 * (1.0 - turned / 4.0 * (1.0 - turned / 5.0))))
            more = 0.5 * time * time * (1.0 - turned / 3.0 * (1.0 - turned / 4.0 * (1.0 - turned / 5.0)))
        else:
            gained = -expm1(-turned) / bend
            more = (time - gained) / bend
        return speed * time + rate * more, speed + rate * gained

    if way == 0.0:
        return 0.0
    low, high = 0.0, _longest(speed, rate, bend, way)
    if states(high)[0] < way * (1.0 - 1e-15):
        return inf
    time = 0.5 * (low + high)
    for _ in range(MOST_STEPS):
        reached, swift = states(time)
        if reached < way:
            low = time
        else:
            high = time
        step = time - (reached - way) / swift if swift > 0.0 else low
        after = step if low < step < high else 0.5 * (low + high)
        if abs(after - time) <= 4e-16 * time:
            return after
        time = after
    return time


def _longest(speed: float, rate: float, bend: float, way: float) -> float:
    """A time after which the distance is covered, or, going back, after which the party is at rest."""
    if rate < 0.0:
        return _time_to_speed(speed, rate, bend, 0.0)
    # within one fade at least two thirds of the rate act; after it x ≥ v_top (t − 1/β)
    time = sqrt(3.0 * way / rate)
    return time if bend * time <= 1.0 else way / (speed + rate / bend) + 1.0 / bend
