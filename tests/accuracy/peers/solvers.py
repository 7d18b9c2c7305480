"""A solver as numerical textbooks teach it: Brent's root."""

from math import copysign, inf, isfinite

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

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
