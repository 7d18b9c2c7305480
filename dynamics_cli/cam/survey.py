"""What a motion comes to: extremes with their places, jumps at the joints, means over a turn."""

from math import inf, sqrt

from dynamics_cli.cam.choosing import GAUSS
from dynamics_cli.cam.peaks import extremes
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.cam.motion import Motion

JUMP = 1e-10


@record
class Extreme:
    """Least and greatest value of one derivative, with their places.

    Parameters
    ----------
    least, least_at, greatest, greatest_at : float
        Values, and cam angles [rad].
    """

    least: float
    least_at: float
    greatest: float
    greatest_at: float


def extreme(motion: "Motion", order: int) -> Extreme:
    """Give the extremes of the lift (0) or a derivative per radian (1 to 3) over the turn, one-sided values included.

    Parameters
    ----------
    motion : Motion
        The motion.
    order : int
        Which derivative.

    Returns
    -------
    Extreme
        The first place of each.

    Notes
    -----
    From the extremes of the normalised laws, to the last bits; equal values to 10⁻¹² count as one, the first is named.
    """
    found = []
    for index, span in enumerate(motion.segments):
        start, end = motion.joints[index], motion.joints[index + 1]
        if span.law is None:
            value = span.low if order == 0 else 0.0
            found += [(start, value), (end, value)]
            continue
        scale = span.high - span.low if span.scale is None else span.scale
        factor = scale / (end - start) ** order
        base = span.low if order == 0 else 0.0
        for x, f in extremes(span.law, order):
            at = end - (1.0 - x) * (end - start) if x > 0.5 else start + x * (end - start)
            value = span.high if order == 0 and x == 1.0 else base + factor * f
            found.append((at, value))
    size = max(abs(value) for _, value in found) * 1e-12
    least, most = min(value for _, value in found), max(value for _, value in found)
    return Extreme(
        least,
        next(at for at, value in found if value <= least + size),
        most,
        next(at for at, value in found if value >= most - size),
    )


def root_mean_square(motion: "Motion", order: int) -> float:
    """Root mean square of a derivative over the turn, by Gauss's rule of 16 points on each piece: exact to rounding."""
    total = 0.0
    for index, span in enumerate(motion.segments):
        if span.law is None:
            continue
        width = motion.joints[index + 1] - motion.joints[index]
        scale = (span.high - span.low if span.scale is None else span.scale) / width**order
        total += width * scale * scale * _mean_square(span.law, order)
    return sqrt(total / 6.283185307179586)


def _mean_square(law: "object", order: int) -> float:
    total = 0.0
    for piece in law.pieces:  # type: ignore[attr-defined]
        ends = piece.ends
        half = 0.5 * (ends[1] - ends[0])
        for node, weight in GAUSS:
            for t in (ends[0] + half * (1.0 - node), ends[0] + half * (1.0 + node)):
                value = piece.shape(t, order)[order]
                total += weight * half * value * value
    return total


def jumps(motion: "Motion") -> "list[tuple[float, str, list[float]]]":
    """Every zone boundary: its angle, what meets there, and how much lift, velocity, acceleration and jerk jump.

    Parameters
    ----------
    motion : Motion
        The motion.

    Returns
    -------
    list of (float, str, list of float)
        Angle, words, and the four jumps; a difference that rounding explains is zero.
    """
    zones = motion.zones
    sizes = [max(abs(one.least), abs(one.greatest)) for one in (extreme(motion, order) for order in range(4))]
    found = []
    for index, zone in enumerate(zones):
        before = zones[index - 1]
        left = motion.in_zone((index - 1) % len(zones), 1.0)
        right = motion.in_zone(index, 0.0)
        steps = [
            b - a if abs(b - a) > JUMP * max(abs(a), abs(b), 1e-4 * size) else 0.0
            for a, b, size in zip(left, right, sizes, strict=True)
        ]
        words = _name(motion, zone.segment)
        if before.segment != zone.segment or len(motion.segments) == 1:
            words = f"{_name(motion, before.segment)} to {words}"
        else:
            words = f"within {words}"
        found.append((zone.start, words, steps))
    return found


def _name(motion: "Motion", segment: int) -> str:
    return f"{motion.segments[segment].name} {segment + 1}"


def order_of_continuity(found: "list[tuple[float, str, list[float]]]") -> int:
    """The highest derivative that jumps nowhere with none below it jumping; -1 where the lift itself steps."""
    first = min((next((i for i, step in enumerate(steps) if step), inf) for _, _, steps in found), default=inf)
    return 3 if first == inf else int(first) - 1
