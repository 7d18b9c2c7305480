"""Extremes, integrals and crossings of functions of a motion, zone by zone."""

from math import pi

from dynamics_cli.cam.peaks import extremes
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.cam.motion import Motion

    Law = Callable[[Any, Any, Any], Any]

STEPS = 64
NARROW = 1e-8


@record
class Found:
    """A value and the cam angle it was found at.

    Parameters
    ----------
    value : float
        The value.
    at : float
        Cam angle [rad].
    """

    value: float
    at: float


def least_and_greatest(motion: "Motion", function: "Law") -> tuple[Found, Found]:
    """Give the least and greatest value of a function of s, s′ and s″ over the turn, one-sided values included.

    Parameters
    ----------
    motion : Motion
        The motion.
    function : callable
        Takes arrays of s, ds/dθ, d²s/dθ² and gives an array.

    Returns
    -------
    (Found, Found)
        The least and the greatest, each at its first place.

    Notes
    -----
    64 steps on each zone; then every hump that could be the highest (its sample and eight times what a parabola through
    it and its neighbours may add) is cut in 16 again and again, until rounding ends it.
    """
    sampled = _sampled(motion, function)
    return _highest(motion, function, sampled, -1.0), _highest(motion, function, sampled, 1.0)


def greatest(motion: "Motion", function: "Law") -> Found:
    """Give the greatest value only; see `least_and_greatest`."""
    return _highest(motion, function, _sampled(motion, function), 1.0)


def _sampled(motion: "Motion", function: "Law") -> "list[Any]":
    import numpy as np

    found = []
    for index, zone in enumerate(motion.zones):
        t = np.linspace(0.0, 1.0, 2 if zone.dwell else STEPS + 1)
        found.append((index, t, np.asarray(function(*motion.in_zone(index, t, 2)), dtype=float) + 0.0 * t))
    return found


def _highest(motion: "Motion", function: "Law", sampled: "list[Any]", sign: float) -> Found:
    top = max(float((sign * values).max()) for _, _, values in sampled)
    best: Found | None = None
    for index, t, values in sampled:
        zone = motion.zones[index]
        for hump in _humps(sign * values, top):
            place, value = _climbed(motion, function, index, t, values, hump, sign)
            # Equal extremes differ by rounding; the first keeps its place.
            if best is None or value > sign * best.value + 1e-13 * abs(value):
                best = Found(sign * value, zone.start + (zone.end - zone.start) * place)
    assert best is not None
    return best


def _humps(values: "Any", top: float) -> "list[int]":
    """Samples about which the function may rise to `top` or above."""
    import numpy as np

    padded = np.concatenate(([-np.inf], values, [-np.inf]))
    before, after = padded[:-2], padded[2:]
    # a plateau counts by its ends
    humps = np.flatnonzero((values >= before) & (values >= after) & ((values > before) | (values > after)))
    found = []
    for i in humps.tolist():
        # At an end of the zone the parabola is the one through the three samples next to it.
        middle = min(max(i, 1), values.size - 2)
        # beside an infinite sample the bend is no number: that hump is climbed too
        with np.errstate(invalid="ignore"):
            bend = abs(values[middle - 1] - 2.0 * values[middle] + values[middle + 1]) if values.size > 2 else 0.0
        if values[i] == top or not values[i] + bend < top:
            found.append(i)
    return found


def _climbed(
    motion: "Motion", function: "Law", index: int, t: "Any", values: "Any", top: int, sign: float
) -> tuple[float, float]:
    """The top of one hump, by cutting the interval about the highest sample in 16 again and again."""
    import numpy as np

    place, value = float(t[top]), sign * float(values[top])
    if t.size == 2:
        return place, value
    low, high = float(t[max(top - 1, 0)]), float(t[min(top + 1, t.size - 1)])
    while high - low > NARROW:
        grid = np.linspace(low, high, 17)
        tried = sign * np.asarray(function(*motion.in_zone(index, grid, 2)), dtype=float)
        top = int(np.argmax(tried))
        if tried[top] > value:
            place, value = float(grid[top]), float(tried[top])
        low, high = float(grid[max(top - 1, 0)]), float(grid[min(top + 1, 16)])
    return place, value


def integral(motion: "Motion", function: "Law") -> tuple[float, float]:
    """Integral of a function of s, s′, s″ over the turn, and of its magnitude, by Gauss's rule on halves of zones."""
    import numpy as np

    nodes, weights = np.polynomial.legendre.leggauss(24)
    total = size = 0.0
    for index, zone in enumerate(motion.zones):
        if zone.dwell:
            continue
        for low in (0.0, 0.5):
            values = function(*motion.in_zone(index, low + 0.25 * (nodes + 1.0), 2))
            share = 0.25 * (zone.end - zone.start)
            total += share * float(weights @ values)
            size += share * float(weights @ np.abs(values))
    return total, size


def crossings(motion: "Motion", level: float) -> list[tuple[float, bool]]:
    """Cam angles at which the lift passes a level, and whether upwards.

    Parameters
    ----------
    motion : Motion
        The motion.
    level : float
        The lift [m].

    Returns
    -------
    list of (float, bool)
        In order of the angle. A touch without passing is none.
    """
    found = []
    for index, span in enumerate(motion.segments):
        if span.law is None:
            continue
        start, end = motion.joints[index], motion.joints[index + 1]
        places = sorted({x for x, _ in extremes(span.law, 0)})
        angles = [start, *(start + x * (end - start) for x in places if 0.0 < x < 1.0), end]
        values = [motion.at(angle, 0, 1 if angle < end else -1)[0] - level for angle in angles]
        for low, high, before, after in zip(angles, angles[1:], values, values[1:], strict=False):
            if (before < 0.0) != (after < 0.0):
                found.append((_bisected(motion, level, low, high), after >= 0.0))
    return found


def _bisected(motion: "Motion", level: float, low: float, high: float) -> float:
    below = motion.at(low, 0)[0] < level
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return middle if middle < 2.0 * pi else high
        if (motion.at(middle, 0)[0] < level) == below:
            low = middle
        else:
            high = middle
