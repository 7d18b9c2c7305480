"""Roots of monotone functions, many at once: bracketed, then by false position with Illinois' halving."""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

STEPS = 60


def solve(
    along: "Callable[[Array], Array]", cuts: "Array", v: "Array", *, rising: bool, near: float
) -> "tuple[Array, Array]":
    """The coordinate between the first and the last cut at which a monotone function reaches v, and its slope there.

    Each root is known to `near` widths of the cuts before a last secant step, which squares that. Where v lies beyond
    an end the end is given, its slope infinite. The function may be −∞ (if rising, at its lower end; else at its
    upper one).

    References
    ----------
    M. Dowell, P. Jarratt, A modified regula falsi method for computing the root of an equation, BIT 11 (1971) 168
    (Illinois' method).
    """
    v = v if rising else -v

    def up(t: "Array") -> "Array":
        return along(t) if rising else -along(t)

    a, b, f_a, f_b = _bracket(up, cuts, v)
    inside = (f_a < v) & (v <= f_b)
    t, slope = np.where(v <= f_a, a, b), np.full(v.size, np.inf)
    # The ends' residuals as they are, and as halved by the Illinois rule.
    true_a, true_b = f_a - v, f_b - v
    low, high = true_a, true_b
    side = np.zeros(v.size)
    before, f_before = a, true_a
    with np.errstate(invalid="ignore", divide="ignore"):
        for _ in range(STEPS):
            fraction = low / (low - high)
            middle = a + np.where((fraction > 0.0) & (fraction <= 1.0), fraction, 0.5) * (b - a)
            f = up(middle) - v
            below = f < 0.0
            # The secant through the last two points, or the chord to the retained end: near the root, the slope.
            secant = (f - f_before) / (middle - before)
            chord = np.where(below, (true_b - f) / (b - middle), (f - true_a) / (middle - a))
            chord = np.where(np.isfinite(secant) & (secant > 0.0), secant, chord)
            before, f_before = middle, f
            low = np.where(below, f, np.where(side > 0.0, 0.5 * low, low))
            high = np.where(below, np.where(side < 0.0, 0.5 * high, high), f)
            true_a, true_b = np.where(below, f, true_a), np.where(below, true_b, f)
            a, b = np.where(below, middle, a), np.where(below, b, middle)
            side = np.where(below, -1.0, 1.0)
            good = inside & np.isfinite(chord) & (chord > 0.0) & np.isfinite(f)
            step = np.where(good, f, 0.0) / np.where(good, chord, 1.0)
            t = np.where(inside, np.clip(middle - step, a, b), t)
            slope = np.where(good, chord, slope)
            left_over = np.abs(np.where(inside & ~good, b - a, step)).max(initial=0.0)
            if left_over < near * (cuts[-1] - cuts[0]):
                break
    return t, slope


def _bracket(up: "Callable[[Array], Array]", cuts: "Array", v: "Array") -> "tuple[Array, Array, Array, Array]":
    """The cuts about v, and the function there."""
    a, b = np.full(v.size, cuts[0]), np.full(v.size, cuts[-1])
    f_a, f_b = up(a), up(b)
    for cut in cuts[1:-1]:
        t = np.full(v.size, cut)
        f = up(t)
        above, below = (f >= v) & (t < b), (f < v) & (t > a)
        b, f_b = np.where(above, t, b), np.where(above, f, f_b)
        a, f_a = np.where(below, t, a), np.where(below, f, f_a)
    return a, b, f_a, f_b
