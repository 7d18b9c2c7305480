"""The task `damped`: how a pendulum runs down."""

import math

from dynamics_cli.errors import UsageError, require, worded
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Count,
    Fraction,
    Gravity,
    Length,
    Ratio,
    Time,
)
from dynamics_cli.records import Advice, ErrorBound, Numerics, record
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

FINE, COARSE = 1e-11, 1e-9
# The tolerance for samples of uncertain inputs; their steps, in radians of small swings, and so many at a time.
SAMPLED, STEP, STEPS = 1e-8, 0.1, 400
# Turning points at most: until an angle, and where none is asked for.
MOST_SWINGS, SHOWN_SWINGS = 2000, 100
# Peaks below this are at rest for every purpose.
STILL = 1e-6
# Places of the time's integral; more until two numbers of them agree.
PLACES, MOST_PLACES, AGREE = 32, 4096, 1e-13
SAMPLES = 60


@record
class Peak:
    """One turning point."""

    swing: Annotated[Count, "Half swings since the release."]
    time: Annotated[Time, "Time since the release [s]."]
    amplitude: Annotated[Angle, "Angle there, to either side [rad]."]
    loss: Annotated[Fraction, "Energy lost since the turning point before [-]."]


@record
class Damped:
    """How a pendulum runs down."""

    first_period: Annotated[Time, "Time of the first full swing, there and back [s]."]
    first_loss: Annotated[Fraction, "Energy lost in the first half swing [-]."]
    swings: Annotated[Ratio | None, "Full swings until the given angle, or until it is practically at rest [-]."]
    time: Annotated[Time | None, "Time until then [s]."]
    peaks: Annotated[tuple[Peak, ...], "The turning points."]
    numerics: Numerics
    advice: tuple[Advice, ...] = ()


def damped(
    *,
    length: Annotated[Length, "From the pivot to the point mass, e.g. 1 m."],
    amplitude: Annotated[Angle, "Where it is let go, e.g. 60 deg."],
    damping: Annotated[Ratio, "Damping ratio ζ of small swings, drag in proportion to speed, e.g. 0.01."] = 0.0,
    quadratic: Annotated[Ratio, "Drag by the square of the speed: ½·ρ·c_d·A·L/m, e.g. 0.02."] = 0.0,
    until: Annotated[Angle | None, "An amplitude to count the swings to, e.g. 5 deg."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Damped:
    """A pendulum with drag in proportion to its speed, to the square of it, or both: turning points and losses.

    Equation
    --------
    θ̈ + 2ζω₀·θ̇ + β·|θ̇|·θ̇ + ω₀²·sin θ = 0, ω₀² = g/L.

    Returns
    -------
    Damped
        Turning points with their times, and what is lost from one to the next; a hundred where no angle is asked for.

    Raises
    ------
    InadmissibleError
        When the length is not above zero, the amplitude is 180 degrees or more, or a drag is below zero.
    UsageError
        When there is no drag.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 8.4 and 13.4; integrated by DOP853
    (Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, Springer 1993, section II.10).

    Examples
    --------
    >>> round(damped(length=1.0, amplitude=0.1, damping=0.01).first_loss, 4)
    0.0609
    """
    require(length > 0.0, "the length of {length} is not above zero", length=(length, Length))
    require((abs(amplitude) < math.pi) & (amplitude != 0.0), "it cannot be let go at {amplitude}",
    amplitude=(amplitude, Angle),
            code="amplitude", hint="give an angle between 0 and 180 deg")  # fmt: skip
    require((damping >= 0.0) & (quadratic >= 0.0), "a drag below zero feeds the pendulum", code="drag",
            hint="give ζ and β of zero or more")  # fmt: skip
    if damping == 0.0 and quadratic == 0.0:
        raise UsageError("there is no drag", code="no-drag", parameter="damping",
                         hint="give --damping or --quadratic; without drag ask `dynamics pendulum simple`")  # fmt: skip
    size = abs(amplitude)
    goal = STILL if until is None else abs(until)
    require(0.0 < plain(goal) < plain(size), "an amplitude of {until} is not below that of the release",
            until=(goal, Angle), code="until", hint="give a smaller angle")  # fmt: skip
    natural = math.sqrt(plain(gravity) / plain(length))
    most = SHOWN_SWINGS if until is None else MOST_SWINGS
    if damping == 0.0:
        fine = coarse = _by_energy(natural, plain(quadratic), plain(size), plain(goal), most)
    else:
        given = natural, plain(damping), plain(quadratic), plain(size), plain(goal)
        if drawing():
            fine = coarse = _sampled(*given, most)
        else:
            fine, coarse = (_integrated(*given, tolerance, most) for tolerance in (FINE, COARSE))
    peaks = tuple(_losses(fine, plain(size)))
    reached = plain(until) is not None and len(fine) > 0 and fine[-1][1] <= plain(goal) if until is not None else False
    swings = _fraction(fine, plain(size), plain(goal)) if reached else None
    apart = max((abs(a[1] - b[1]) / a[1] for a, b in zip(fine, coarse, strict=False) if a[1] > 0.0), default=0.0)
    require(
        len(fine) > 1, "it creeps back without a swing", code="no-swing", hint="a damping ratio of 1 or more stops it"
    )
    return Damped(
        first_period=fine[1][0],
        first_loss=peaks[0].loss,
        swings=None if swings is None else 0.5 * swings[0],
        time=None if swings is None else swings[1],
        peaks=peaks,
        numerics=Numerics(
            "closed form of the speed, quadrature of the time" if damping == 0.0 else "DOP853, two tolerances",
            bounds=(ErrorBound("first_loss", max(apart, 1e-12, 1e-14 / max(peaks[0].loss, 1e-14))),),
        ),
        advice=_advice(until, reached, len(fine)),
    )


def _advice(until: "float | None", reached: bool, count: int) -> "tuple[Advice, ...]":
    if until is None or reached:
        return ()
    message = worded("{until} is not reached in {count} half swings", until=(until, Angle), count=str(count))
    return (Advice("not-reached", message, result="swings", remedy="give a larger angle"),)


def _losses(peaks: "Sequence[tuple[float, float]]", start: float) -> "list[Peak]":
    before, out = start, []
    for number, (time, size) in enumerate(peaks, 1):
        lost = 1.0 - (math.sin(0.5 * size) / math.sin(0.5 * before)) ** 2
        out.append(Peak(swing=number, time=time, amplitude=size, loss=max(lost, 0.0)))
        before = size
    return out


def _fraction(peaks: "Sequence[tuple[float, float]]", start: float, goal: float) -> "tuple[float, float]":
    """Half swings and time until an amplitude, between two turning points by the logarithm of the amplitude."""
    before = (0.0, start)
    for number, peak in enumerate(peaks):
        if peak[1] <= goal:
            share = math.log(before[1] / goal) / math.log(before[1] / peak[1])
            return number + share, before[0] + share * (peak[0] - before[0])
        before = peak
    return float(len(peaks)), peaks[-1][0]


def _by_energy(natural: float, quadratic: float, size: float, goal: float, most: int) -> "list[tuple[float, float]]":
    """Times and sizes of the turning points where drag is by the square of the speed alone.

    The square of the speed is linear in itself: from −a upwards it is 2ω₀²/(1 + 4β²) times cos φ − 2β·sin φ
    − (cos a + 2β·sin a)·e^(−2β(φ + a)).
    """
    import numpy as np
    from scipy.optimize import brentq

    peaks: list[tuple[float, float]] = []
    time, scale = 0.0, 2.0 * natural * natural / (1.0 + 4.0 * quadratic * quadratic)
    while len(peaks) < most and size > goal:
        start = math.cos(size) + 2.0 * quadratic * math.sin(size)

        def square(angle: "Any", a: float = size, start: float = start) -> "Any":
            """Of the speed, over the scale, as a sum of parts that vanish at −a."""
            half, rest = 0.5 * (angle + a), 0.5 * (angle - a)
            turned = -2.0 * np.sin(half) * np.sin(rest) - 4.0 * quadratic * np.sin(half) * np.cos(rest)
            return turned - start * np.expm1(-4.0 * quadratic * half)

        end = float(brentq(square, -0.999 * size, size, xtol=1e-15 * size, rtol=1e-15))
        middle, half = 0.5 * (end - size), 0.5 * (end + size)
        places, took, before = PLACES, 0.0, math.inf
        while abs(took - before) > AGREE * took and places <= MOST_PLACES:
            turns = (np.arange(places) + 0.5) * (math.pi / places)
            speeds = np.sqrt(scale * square(middle - half * np.cos(turns)))
            before, took = took, float((half * np.sin(turns) / speeds).sum()) * math.pi / places
            places *= 2
        time, size = time + took, end
        peaks.append((time, end))
    return peaks


def _integrated(
    natural: float, damping: float, quadratic: float, size: float, goal: float, tolerance: float, most: int
) -> "list[tuple[float, float]]":
    """Times and sizes of the turning points, until one is below the goal."""
    from scipy.integrate import solve_ivp

    def motion(_: float, state: "Any") -> "list[float]":
        angle, rate = float(state[0]), float(state[1])
        return [rate, -(2.0 * damping * natural + quadratic * abs(rate)) * rate - natural * natural * math.sin(angle)]

    def turns(_: float, state: "Any") -> float:
        return float(state[1])

    turns.terminal = True  # type: ignore[attr-defined]
    peaks: list[tuple[float, float]] = []
    time, angle, span = 0.0, size, 40.0 / natural
    while len(peaks) < most:
        # the first step leaves the turning point, where the rate is zero
        turns.direction = 1.0 if angle > 0.0 else -1.0  # type: ignore[attr-defined]
        solved = solve_ivp(motion, (time, time + span), [angle, 0.0], method="DOP853", rtol=tolerance,
                         atol=tolerance * abs(angle) * 1e-3, events=turns)  # fmt: skip
        if not len(solved.t_events[0]):
            break
        time, angle = float(solved.t_events[0][0]), float(solved.y_events[0][0][0])
        peaks.append((time, abs(angle)))
        if abs(angle) <= goal:
            break
    return peaks


def _sampled(
    natural: float, damping: float, quadratic: float, size: float, goal: float, most: int
) -> "list[tuple[float, float]]":
    """The same for samples: LSODA over many swings at a time, turning points by cubics of the rate within a step."""
    import numpy as np
    from scipy.integrate import odeint

    drag, pull = 2.0 * damping * natural, natural * natural

    def motion(state: "Any", _: float) -> "tuple[float, float]":
        angle, rate = state.tolist()
        return rate, -(drag + quadratic * abs(rate)) * rate - pull * math.sin(angle)

    peaks: list[tuple[float, float]] = []
    step, begin, state = STEP / natural, 0.0, (size, 0.0)
    while len(peaks) < most and (not peaks or peaks[-1][1] > goal):
        times = begin + step * np.arange(STEPS + 1)
        states = odeint(motion, state, times, rtol=SAMPLED, atol=SAMPLED * goal)
        angle, rate = states.T
        bend = step * (-(drag + quadratic * np.abs(rate)) * rate - pull * np.sin(angle))
        at = np.flatnonzero(rate[:-1] * rate[1:] < 0.0)
        if not at.size:
            break
        first, last = rate[at], rate[at + 1]
        terms = first, bend[at], 3.0 * (last - first) - 2.0 * bend[at] - bend[at + 1], (
            2.0 * (first - last) + bend[at] + bend[at + 1])  # fmt: skip
        share = first / (first - last)
        for _ in range(3):
            value = terms[0] + share * (terms[1] + share * (terms[2] + share * terms[3]))
            share -= value / (terms[1] + share * (2.0 * terms[2] + 3.0 * share * terms[3]))
        moved = sum(term * share ** (power + 1) / (power + 1) for power, term in enumerate(terms))
        peaks += zip((times[at] + step * share).tolist(), np.abs(angle[at] + step * moved).tolist(), strict=True)
        begin, state = float(times[-1]), states[-1]
    short = next((number for number, (_, peak) in enumerate(peaks, 1) if peak <= goal), len(peaks))
    return peaks[: min(short, most)]
