"""Solvers as numerical textbooks teach them: Brent's root, Dormand and Prince's steps with events."""

from math import copysign, inf, isfinite

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    State = list[float]
    Slope = Callable[[float, State], Sequence[float]]
    Event = Callable[[float, State], float]

ROUNDING = 2.0**-52


def brent(f: "Callable[[float], float]", low: float, high: float, *, relative: float = 4.0 * ROUNDING) -> float:
    """A root between two places of opposite signs: secants and inverse parabolas while these close in, else halving.

    Brent, Algorithms for Minimization without Derivatives (1973), chapter 4.
    """
    a, b = low, high
    fa, fb = f(a), f(b)
    if fa * fb > 0.0:
        raise ArithmeticError
    # b is the best place so far, c the last with the opposite sign, a the best before b
    c, fc = a, fa
    last = before = b - a
    while True:
        if fb * fc > 0.0:
            c, fc = a, fa
            last = before = b - a
        if abs(fc) < abs(fb):
            a, b, c = b, c, b
            fa, fb, fc = fb, fc, fb
        room, half = 0.5 * relative * abs(b), 0.5 * (c - b)
        if abs(half) <= room or fb == 0.0:
            return b
        step = _interpolated(a, b, c, fa, fb, fc)
        if abs(fa) <= abs(fb) or abs(before) < room or not _closes_in(step, half, before):
            last = before = half
        else:
            before, last = last, step
        a, fa = b, fb
        b += last if abs(last) > room else copysign(room, half)
        fb = f(b)


def _interpolated(a: float, b: float, c: float, fa: float, fb: float, fc: float) -> float:
    """The step from b to where a secant, or an inverse parabola through three places, has its root."""
    s = fb / fa if fa else inf
    if not isfinite(s):
        return inf
    if a == c:
        return (c - b) * s / (s - 1.0) if s != 1.0 else inf
    q, r = fa / fc, fb / fc
    bottom = (q - 1.0) * (r - 1.0) * (s - 1.0)
    return -s * ((c - b) * q * (q - r) - (b - a) * (r - 1.0)) / bottom if bottom else inf


def _closes_in(step: float, half: float, before: float) -> bool:
    """Whether a step stays within three quarters of the bracket, and halves the step before the last."""
    return isfinite(step) and 0.0 < step / half < 1.5 and abs(step) < 0.5 * abs(before)


# Dormand and Prince, A family of embedded Runge–Kutta formulae (1980): places, slopes so far, weights, errors.
PLACES = 0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0
SLOPES = (
    (),
    (1 / 5,),
    (3 / 40, 9 / 40),
    (44 / 45, -56 / 15, 32 / 9),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
)
WEIGHTS = 35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84
ERRORS = 71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40


def _step(slope: "Slope", t: float, y: "State", first: "Sequence[float]", h: float) -> "tuple[State, State]":
    """The state a step on, and the error of each of its parts."""
    found = [first]
    for place, row in zip(PLACES[1:], SLOPES[1:], strict=True):
        at = [v + h * sum(w * k[i] for w, k in zip(row, found, strict=True)) for i, v in enumerate(y)]
        found.append(slope(t + place * h, at))
    new = [v + h * sum(w * k[i] for w, k in zip(WEIGHTS, found, strict=True)) for i, v in enumerate(y)]
    found.append(slope(t + h, new))
    return new, [h * sum(w * k[i] for w, k in zip(ERRORS, found, strict=True)) for i in range(len(y))]


def dormand_prince(
    slope: "Slope", y: "State", events: "Sequence[Event]", tolerance: float, absolute: float, *, first: float,
    most: int = 3000,
) -> "tuple[float, State, list[bool]]":  # fmt: skip
    """From t = 0 with steps of orders 5 and 4 until an event's function is no longer below zero: when, where, which.

    Within a step the event is found by Brent's method on the length of the step.
    """
    t, h = 0.0, first
    for _ in range(most):
        here = slope(t, y)
        new, errors = _step(slope, t, y, here, h)
        parts = [
            error / (absolute + tolerance * max(abs(old), abs(now)))
            for error, old, now in zip(errors, y, new, strict=True)
        ]
        worst = max(map(abs, parts))
        if not isfinite(worst):
            h *= 0.1
        elif worst > 1.0:
            h *= max(0.2, 0.9 * worst**-0.2)
        else:
            over = [event(t + h, new) >= 0.0 for event in events]
            if any(over):
                # the earliest of those that happen
                length = min(
                    _when(event, slope, t, y, here, h) for event, happens in zip(events, over, strict=True) if happens
                )
                end = _step(slope, t, y, here, length)[0] if length < h else new
                near = 16.0 * ROUNDING
                which = [
                    happens
                    and event(t + length * (1.0 + near), _step(slope, t, y, here, length * (1.0 + near))[0]) >= 0.0
                    for event, happens in zip(events, over, strict=True)
                ]
                return t + length, end, which
            t, y = t + h, new
            h *= min(5.0, 0.9 * max(worst, 1e-9) ** -0.2)
    raise ArithmeticError


def _when(event: "Event", slope: "Slope", t: float, y: "State", here: "Sequence[float]", h: float) -> float:
    """The length of the step after which the event's function is zero."""

    def value(length: float) -> float:
        return event(t + length, _step(slope, t, y, here, length)[0]) if length else event(t, y)

    return brent(value, 0.0, h) if value(h) > 0.0 else h
