"""Straight motion under a law of the acceleration: a(t), a(v), a(x), or of all three."""

import math

from dynamics_cli.errors import require
from dynamics_cli.numerics.expressions.second_order import Piece, Pole, crossing, pieces
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Length, Speed, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.path.straight.phases import Phase

# The body is at rest where the velocity is this small relative to the start.
TOUCH = 1e-9
# Beyond so many times the distance asked for, it will not be reached.
FAR = 1e4
ROUNDING = 2.0**-51


class Run:
    """A motion under a law: its pieces, when it ended, and the first time it stopped."""

    def __init__(self, parts: "list[Piece]", end: float, stop: float | None) -> None:
        self.parts = parts
        self.end = end
        self.stop = stop

    def at(self, time: float) -> "tuple[float, float, float]":
        """Position, velocity and acceleration at a time."""
        part = next((part for part in reversed(self.parts) if part.start <= time), self.parts[0])
        return part.at(time - part.start)


def run(law: "Callable[..., Any]", phase: "Phase", *, halved: bool = False) -> Run:
    """Follow the law from the start speed until the time, the distance or the end speed given; else to rest.

    Refused where that is never reached, or the law has a pole on the way.
    """
    speed = plain(phase.start_speed)
    time, distance = plain(phase.time), plain(phase.distance)
    end_speed = 0.0 if phase.end_speed is None else plain(phase.end_speed)
    first = _first_step(law, speed, time, distance, end_speed)
    goes_on = end_speed != 0.0 or time is not None or distance is not None
    parts: list[Piece] = []
    stop: float | None = None
    try:
        for part in pieces(law, speed, first=first, most=math.inf if time is None else time, halved=halved):
            parts.append(part)
            stop = stop if stop is not None else _stop_in(part, speed)
            end = _end_in(part, time, distance, end_speed) if goes_on else stop
            if end is not None:
                return Run(parts, end, stop if stop is not None and stop <= end else None)
            if distance is not None and abs(part.at(part.length)[0]) > FAR * abs(distance):
                break
    except Pole as pole:
        _refuse_pole(pole)
    return _not_reached(parts, stop, distance, end_speed)


def _first_step(
    law: "Callable[..., Any]", speed: float, time: float | None, distance: float | None, wanted: float
) -> float:
    """A time of the size that the motion takes."""
    if time is not None:
        require(time > 0.0, "the time is zero: there is no motion", code="no-time", hint="give a time above zero")
        return time
    try:
        rate = abs(float(law(t=0.0, x=0.0, v=speed)))
    except (ArithmeticError, ValueError):
        _refuse_pole(Pole((0.0, 0.0, speed)))
    sizes = [abs(speed - wanted) / rate] if rate else []
    if distance:
        sizes += [abs(distance / speed)] if speed else []
        sizes += [math.sqrt(abs(2.0 * distance) / rate)] if rate else []
    sizes = [size for size in sizes if size > 0.0]
    return 2.0 * max(sizes, default=math.inf)


def _end_in(part: Piece, time: float | None, distance: float | None, wanted: float) -> float | None:
    if time is not None:
        return time if part.start + part.length >= time else None
    if distance is not None:
        reached = crossing(part, lambda moment: part.at(moment)[0] - distance)
    else:
        reached = crossing(part, lambda moment: part.at(moment)[1] - wanted)
    return None if reached is None else part.start + reached


def _stop_in(part: Piece, speed: float) -> float | None:
    # where the velocity touches zero, the zero of the acceleration gives the time to all digits
    turn = crossing(part, lambda time: part.at(time)[2])
    if turn is not None and abs(part.at(turn)[1]) <= TOUCH * abs(speed):
        return part.start + turn
    moment = crossing(part, lambda time: part.at(time)[1])
    return part.start + moment if moment is not None and (moment or part.start) else None


def _refuse_pole(pole: Pole) -> None:
    time, position, velocity = pole.state
    require(
        False,
        "the law cannot be followed beyond {time:6}: at {position:6} and {velocity:6} it has a pole, a corner or no "
        "value",
        code="pole",
        hint="end before that time, or write another law",
        time=(time, Time),
        position=(position, Length),
        velocity=(velocity, Speed),
    )


def _not_reached(parts: "list[Piece]", stop: float | None, distance: float | None, wanted: float) -> Run:
    require(bool(parts), "without speed or acceleration it does not move", code="not-reached")
    last = parts[-1]
    position, velocity, _ = last.at(last.length)
    stopped = Run(parts, last.start + last.length, stop)
    goal_word = "{wanted_distance}" if distance is not None else "{wanted_speed}"
    require(
        False,
        (f"it does not reach {goal_word}: it turns back at {{turn:6}} after {{stop:6}}" if stop is not None else
         f"it does not reach {goal_word}: after {{time:6}} it is at {{position:6}} with {{velocity:6}}"),
        code="not-reached",
        hint="give a time, or another end",
        wanted_distance=(distance or 0.0, Length),
        wanted_speed=(wanted, Speed),
        turn=(stopped.at(stop)[0] if stop is not None else 0.0, Length),
        stop=(stop or 0.0, Time),
        time=(stopped.end, Time),
        position=(position, Length),
        velocity=(velocity, Speed),
    )  # fmt: skip
    return stopped


def estimate(value: float, coarser: float) -> float:
    """An estimate of the error from the same with half the steps, and a few roundings."""
    return 4.0 * abs(value - coarser) + ROUNDING * max(abs(value), abs(coarser))
