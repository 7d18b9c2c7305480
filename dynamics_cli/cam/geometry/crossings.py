"""Self-crossings of a curve of many arcs: boxes around halved arcs leave few pairs, which Newton's method decides."""

from cmath import phase
from itertools import pairwise
from math import pi, tan

import numpy as np

from dynamics_cli.cam.geometry.envelope import MARGIN, Arc, Envelope
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

# A curve that turns by less than half a turn in total does not cross itself.
APART = 2.8
# Relative to the cam's size: points this close coincide within rounding; arcs this short cross if they come this close.
CLOSE = 1e-14
TINY = 1e-12


@record
class Crossing:
    """The curve passes one point twice."""

    first: Annotated[float, "Places of the curve, in order."]
    second: Annotated[float, "Places of the curve, in order."]
    point: Annotated[complex, "The point [m]."]
    turn: Annotated[float, "Angle from the first direction to the second [rad]."]
    exact: Annotated[
        bool, "Whether Newton's method has found it; else it is one of many points too near to each other to separate."
    ] = True


def crossings(curve: Envelope, arcs: "list[Arc]", size: float) -> "list[Crossing]":
    """Every common point of forward arcs, except where one continues as the next.

    `arcs`: its forward arcs, in order; `size`: size of the cam, for rounding [m].

    An arc whose tangent turns by β lies within ½·tan β of its chord's length from the chord: pairs whose boxes are
    apart share no point. Pairs whose tangents never point alike share one point at most, found by Newton's method;
    others are halved, to 1e-12 of the size at most. The result depends on sampling only for the turning of an arc,
    which is increased by a quarter.
    """
    points: list[Crossing] = []
    stack = [(arcs[i], arcs[j]) for i, j in _pairs(arcs, len(curve.parts), size)]
    while stack:
        first, second = stack.pop()
        if _apart(first, second, size):
            continue
        length = max(abs(first.last - first.first), abs(second.last - second.first))
        short, point = length <= TINY * size, length <= CLOSE * size
        crossing = _newton(curve, first, second, size) if not point and (short or _cross_once(first, second)) else None
        if crossing is not None:
            points.append(crossing)
        elif short:
            middles = 0.5 * (first.low + first.high), 0.5 * (second.low + second.high)
            points.append(_made(curve, first, middles[0], second, middles[1], exact=False))
        else:
            tiny = TINY * size
            stack += [(a, b) for a in _split(curve, first, tiny) for b in _split(curve, second, tiny)]
    return _distinct(points)


def _pairs(arcs: "list[Arc]", parts: int, size: float) -> "list[tuple[int, int]]":
    """Arcs whose boxes overlap and between which the curve is interrupted or turns far."""
    count = len(arcs)
    if not count:
        return []
    first, last = np.array([arc.first for arc in arcs]), np.array([arc.last for arc in arcs])
    bend = np.array([arc.bend for arc in arcs])
    wide = 0.5 * np.abs(last - first) * np.tan(bend) + CLOSE * size
    boxes = []
    for a, b in ((first.real, last.real), (first.imag, last.imag)):
        boxes.append((np.minimum(a, b) - wide, np.maximum(a, b) + wide))
    i, j = np.triu_indices(count, 1)
    near = np.ones(i.size, dtype=bool)
    for low, high in boxes:
        near &= (low[i] <= high[j]) & (low[j] <= high[i])
    i, j = i[near], j[near]
    turned = np.concatenate(([0.0], np.cumsum(bend)))
    start, end = np.array([arc.start for arc in arcs]), np.array([arc.end for arc in arcs])
    breaks = np.concatenate(([0], np.cumsum(np.append(start[1:] != end[:-1], end[-1] - parts != start[0]))))
    through = (breaks[j] == breaks[i]) & (turned[j + 1] - turned[i] <= APART)
    round_ = (breaks[count] - breaks[j] + breaks[i] == 0) & (turned[count] - turned[j] + turned[i + 1] <= APART)
    keep = ~(through | round_)
    return list(zip(i[keep].tolist(), j[keep].tolist(), strict=True))


def _apart(first: Arc, second: Arc, size: float) -> bool:
    """Whether boxes along the chord of either separate the two."""
    for a, b in ((first, second), (second, first)):
        chord = a.last - a.first
        length = abs(chord)
        if not length:
            continue
        direction = chord.conjugate() / length
        wide = 0.5 * length * tan(min(a.bend, 1.2)) + CLOSE * size
        margin = 0.5 * abs(b.last - b.first) * tan(min(b.bend, 1.2)) + CLOSE * size
        p, q = (b.first - a.first) * direction, (b.last - a.first) * direction
        if min(p.imag, q.imag) - margin > wide or max(p.imag, q.imag) + margin < -wide:
            return True
        if min(p.real, q.real) - margin > length + wide or max(p.real, q.real) + margin < -wide:
            return True
    return False


def _cross_once(first: Arc, second: Arc) -> bool:
    """Whether tangents of the two are never parallel."""
    a, b = first.last - first.first, second.last - second.first
    if not a or not b:
        return True
    between = abs(phase(b / a))
    return min(between, pi - between) > first.bend + second.bend


def _split(curve: Envelope, arc: Arc, tiny: float) -> "tuple[Arc, ...]":
    """The halves of an arc, if it is long enough to halve."""
    return (arc,) if abs(arc.last - arc.first) <= tiny else _halves(curve, arc)


def _halves(curve: Envelope, arc: Arc) -> "tuple[Arc, Arc]":
    middle = 0.5 * (arc.low + arc.high)
    share = np.array([0.5 * (arc.low + middle), middle, 0.5 * (middle + arc.high)])
    points, _ = curve.at(arc.part, share)
    # the tangent turns at least as far as the chords, and about twice as far on a short arc
    corners = [arc.first, *(complex(point) for point in points), arc.last]
    chords = [b - a for a, b in pairwise(corners)]
    angles = [abs(phase(b / a)) if a and b else arc.bend for a, b in pairwise(chords)]
    left, right = (min(arc.bend, 2.0 * MARGIN * (angles[k] + angles[1]) + 1e-14) for k in (0, 2))
    return (
        Arc(arc.part, arc.low, middle, arc.first, corners[2], left),
        Arc(arc.part, middle, arc.high, corners[2], arc.last, right),
    )


def _newton(curve: Envelope, first: Arc, second: Arc, size: float) -> "Crossing | None":
    """The point that two arcs share, from the middles of both; None where they share none."""
    a, b = 0.5 * (first.low + first.high), 0.5 * (second.low + second.high)
    most = (first.high - first.low, second.high - second.low)
    visited = set()
    for _ in range(60):
        (p, u), (q, v) = (_single(curve, arc.part, t) for arc, t in ((first, a), (second, b)))
        away = q - p
        cross = (u.conjugate() * v).imag
        if cross == 0.0:
            return None
        step = (away.conjugate() * v).imag / cross, (away.conjugate() * u).imag / cross
        before = a, b
        a = min(max(a + min(max(step[0], -most[0]), most[0]), first.low), first.high)
        b = min(max(b + min(max(step[1], -most[1]), most[1]), second.low), second.high)
        # the iteration repeats: at a crossing in the last bits, without one at the ends
        if max(abs(a - before[0]), abs(b - before[1])) <= 2e-16 or (a, b) in visited:
            break
        visited.add((a, b))
    p, q = (_single(curve, arc.part, t)[0] for arc, t in ((first, a), (second, b)))
    if abs(p - q) > CLOSE * size:
        return None
    return _made(curve, first, a, second, b)


def _made(curve: Envelope, first: Arc, a: float, second: Arc, b: float, *, exact: bool = True) -> Crossing:
    point = 0.5 * (_single(curve, first.part, a)[0] + _single(curve, second.part, b)[0])
    # velocities vanish at a cusp, the tangent does not
    turn = phase(curve.way(second.part, b) / curve.way(first.part, a))
    return Crossing(first.part + a, second.part + b, point, turn, exact)


def _single(curve: Envelope, part: int, share: float) -> "tuple[complex, complex]":
    point, velocity = curve.at(part, np.array([share]))
    return complex(point[0]), complex(velocity[0])


def _distinct(points: "list[Crossing]") -> "list[Crossing]":
    """Merge crossings found twice at the common end of neighbouring arcs."""
    distinct: list[Crossing] = []
    for crossing in sorted(points, key=lambda item: (item.first, item.second)):
        if not any(
            abs(other.first - crossing.first) <= 1e-11 and abs(other.second - crossing.second) <= 1e-11
            for other in distinct[-4:]
        ):
            distinct.append(crossing)
    return distinct
