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
ROUNDS = 14


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
    64 steps on each zone, then the interval about every hump is cut in 16 again and again until rounding ends it.
    """
    import numpy as np

    best: list[Found | None] = [None, None]
    for index, zone in enumerate(motion.zones):
        width = zone.end - zone.start
        t = np.linspace(0.0, 1.0, STEPS + 1 if not zone.dwell else 2)
        values = np.asarray(function(*motion.in_zone(index, t, 2)), dtype=float) + 0.0 * t
        for side, sign in enumerate((-1.0, 1.0)):
            place, value = _refined(motion, function, index, t, sign * values, sign)
            found = Found(sign * value, zone.start + width * place)
            now = best[side]
            # Equal extremes differ by rounding; the first keeps its place.
            if now is None or value > sign * now.value + 1e-13 * abs(value):
                best[side] = found
    assert best[0] is not None
    assert best[1] is not None
    return best[0], best[1]


def _refined(
    motion: "Motion", function: "Law", index: int, t: "Any", values: "Any", sign: float
) -> tuple[float, float]:
    import numpy as np

    place, value = 0.0, float(values[0])
    flat = float(values.max()) == float(values.min())
    inner = np.concatenate(([-np.inf], values, [-np.inf]))
    # Every hump is refined: between two samples a lower one may rise above the highest sample.
    tops = np.flatnonzero((inner[1:-1] >= inner[:-2]) & (inner[1:-1] >= inner[2:]))
    for top in [0] if flat else tops.tolist():
        found = _climbed(motion, function, index, t, values, top, sign, flat)
        if found[1] > value:
            place, value = found
    return place, value


def _climbed(
    motion: "Motion", function: "Law", index: int, t: "Any", values: "Any", top: int, sign: float, flat: bool
) -> tuple[float, float]:
    """The top of one hump, by cutting the interval about the highest sample in 16 again and again."""
    import numpy as np

    place, value = float(t[top]), float(values[top])
    low, high = float(t[max(top - 1, 0)]), float(t[min(top + 1, t.size - 1)])
    for _ in range(0 if flat else ROUNDS):
        grid = np.linspace(low, high, 17)
        tried = sign * np.asarray(function(*motion.in_zone(index, grid, 2)), dtype=float)
        top = int(np.argmax(tried))
        if tried[top] > value:
            place, value = float(grid[top]), float(tried[top])
        low, high = float(grid[max(top - 1, 0)]), float(grid[min(top + 1, 16)])
        if high - low < 1e-9:
            break
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
