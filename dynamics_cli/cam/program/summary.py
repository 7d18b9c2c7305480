"""Summary of a motion: extremes with their places, jumps at the joints, means over a turn."""

from functools import partial
from math import inf, sqrt

from dynamics_cli.cam.laws.peaks import extremes, value_error
from dynamics_cli.cam.laws.selection import GAUSS
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.cam.laws.normalised import Law
    from dynamics_cli.cam.program.motion import Motion
    from dynamics_cli.cam.program.parts import Span

JUMP = 1e-10
# Rounding of the lift that a spline's derivatives take over from its points, over the power of their distance.
NOISE = 2.0**-47
UNIT = 2.0**-53
TURN = 6.283185307179586
MOST_TURNED = 8.0
NODES = [-node for node, _ in GAUSS[::-1]] + [node for node, _ in GAUSS]
WEIGHTS = [weight for _, weight in GAUSS[::-1]] + [weight for _, weight in GAUSS]


@record
class Extreme:
    """Minimum and maximum of one derivative, with their places."""

    least: Annotated[float, "Values, and cam angles [rad]."]
    least_at: Annotated[float, "Values, and cam angles [rad]."]
    greatest: Annotated[float, "Values, and cam angles [rad]."]
    greatest_at: Annotated[float, "Values, and cam angles [rad]."]
    least_error: Annotated[float, "Bound of the values' error."]
    greatest_error: Annotated[float, "Bound of the values' error."]


def extreme(motion: "Motion", order: int) -> Extreme:
    """Give the extremes of the lift (0) or a derivative per radian (1 to 3) over the turn, one-sided values included.

    `order`: which derivative. Returns the first place of each.

    From the extremes of the normalised laws, to the last bits; values equal to 10⁻¹² count as one, and the first is
    reported.
    """
    ends: list[tuple[float, float, Callable[[], float]]] = []
    for index, span in enumerate(motion.segments):
        start, end = motion.joints[index], motion.joints[index + 1]
        if span.law is None:
            value = span.low if order == 0 else 0.0
            ends += [(place, value, partial(float, sum(span.off) if order == 0 else 0.0)) for place in (start, end)]
            continue
        scale = span.high - span.low if span.scale is None else span.scale
        # the span is not the difference of its ends, which are rounded
        factor = scale / motion.width(index) ** order
        base = span.low if order == 0 else 0.0
        for x, f in extremes(span.law, order):
            angle = end - (1.0 - x) * (end - start) if x > 0.5 else start + x * (end - start)
            value = span.high if order == 0 and x == 1.0 else base + factor * f
            ends.append((angle, value, partial(_value_error, span, x, order, factor, f)))
    size = max(abs(value) for _, value, _ in ends) * 1e-12
    least, most = min(value for _, value, _ in ends), max(value for _, value, _ in ends)
    low = [(angle, error) for angle, value, error in ends if value <= least + size]
    high = [(angle, error) for angle, value, error in ends if value >= most - size]
    return Extreme(
        least, low[0][0], most, high[0][0], max(error() for _, error in low), max(error() for _, error in high)
    )


def _value_error(span: "Span", x: float, order: int, factor: float, value: float) -> float:
    """Error of a level, or of factor·value added to it; a factor counts one rounding, and two for each division."""
    level = sum(span.off)
    if order == 0 and x in (0.0, 1.0):
        return level
    rise = abs(span.high - span.low if span.scale is None else span.scale)
    law: Any = span.law
    error = value_error(law, x, order) + ((2.0 * order + 2.0) * UNIT + level / rise) * abs(value)
    base = abs(span.low) + abs(span.low + factor * value) if order == 0 else 0.0
    return (abs(factor) * error + level + UNIT * base) * (1.0 + 2.0**-40)


def root_mean_square(motion: "Motion", order: int) -> "tuple[float, float]":
    """Root mean square of a derivative over the turn, and its bound.

    Gauss's rule of 16 points on parts short enough that no wave of a law turns by more than four radians in half of
    one: exact to rounding. Its error is at most the root mean square of the values' errors.
    """
    total = slipped = 0.0
    for index, span in enumerate(motion.segments):
        if span.law is None:
            continue
        width = motion.width(index)
        scale = (span.high - span.low if span.scale is None else span.scale) / width**order
        mean, off = _mean_square(span.law, order)
        total += width * scale * scale * mean
        slipped += width * scale * scale * off
    value = sqrt(total / TURN)
    # weights, sums and factors, of the square
    return value, (sqrt(slipped / TURN) + (24.0 + 2.0 * order) * UNIT * value) * (1.0 + 2.0**-40)


def _mean_square(law: "Law", order: int) -> "tuple[float, float]":
    """Mean squares of a derivative and of its error bounds."""
    import numpy as np

    from dynamics_cli.numerics.discs import Disc

    total = slipped = 0.0
    for piece in law.pieces:
        start, end = piece.ends
        shape: Any = piece.shape
        count = 1 + int(shape.quickest * (end - start) / MOST_TURNED)
        edges = np.linspace(start, end, count + 1)
        half = 0.5 * np.diff(edges)
        t = (edges[:-1] + half)[:, None] + half[:, None] * NODES
        bounded = shape(Disc(t, 4.0 * UNIT * t), order)[order]
        value, error = bounded.centre, bounded.radius
        weight = half[:, None] * WEIGHTS
        total += float((weight * value * value).sum())
        slipped += float((weight * error * error).sum())
    return total, slipped


def jumps(motion: "Motion") -> "list[tuple[float, str, list[float]]]":
    """Every zone boundary: its angle, its segments, and the jumps of lift, velocity, acceleration and jerk.

    Returns angle, words, and the four jumps; a difference that rounding explains is zero.
    """
    zones = motion.zones
    sizes = [max(abs(ends.least), abs(ends.greatest)) for ends in (extreme(motion, order) for order in range(4))]
    boundaries = []
    for index, zone in enumerate(zones):
        before = zones[index - 1]
        at_end = motion.in_zone((index - 1) % len(zones), 1.0)
        right = motion.in_zone(index, 0.0)
        width = min(before.end - before.start, zone.end - zone.start)
        steps = [
            b - a if abs(b - a) > max(JUMP * max(abs(a), abs(b), 1e-4 * size), NOISE * sizes[0] / width**order) else 0.0
            for order, (a, b, size) in enumerate(zip(at_end, right, sizes, strict=True))
        ]
        words = _name(motion, zone.segment)
        if before.segment != zone.segment or not index:
            words = f"{_name(motion, before.segment)} to {words}"
        else:
            words = f"within {words}"
        boundaries.append((zone.start, words, steps))
    return boundaries


def _name(motion: "Motion", segment: int) -> str:
    return f"{motion.segments[segment].name} {segment + 1}"


def order_of_continuity(boundaries: "list[tuple[float, str, list[float]]]") -> int:
    """The highest derivative that is continuous together with all lower ones; -1 if the lift itself jumps."""
    first = min((next((i for i, step in enumerate(steps) if step), inf) for _, _, steps in boundaries), default=inf)
    return 3 if first == inf else int(first) - 1
