"""The undercut verdict of `cam check` and the lift it costs, for the search.

The envelope runs backwards where the radius of curvature under a flat face, or 1 − Rκ of a roller, is below zero. A
corner is a point that two positions of the follower touch, one on either side of such a stretch; resting on it, the
follower falls behind its program by a gap whose greatest value is the lift lost.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from cam_search_compared import Compared, Stated
from cam_search_contact import Carried, climbed, extreme
from cam_search_motion import Jet, Turn, Zone, arc_tangent, sine_cosine, sqrt
from precise import Exact

SAMPLES = 400
Ends = tuple[Any, Any]


def room(carried: Carried, *state: Any) -> Any:
    """Radius of curvature under a flat face, 1 − Rκ of a roller: below zero where the envelope runs backwards."""
    touch = carried.touch(*state)
    if carried.flat:
        return touch["radius"]
    roller = float(carried.roller) if hasattr(state[0], "shape") else carried.roller
    return 1 - carried.side * roller * touch["curvature"]


def lost(answer: Any, turn: Turn, carried: Carried, stated: Stated) -> Iterator[Compared]:
    """Whether the envelope runs backwards is the verdict; what it costs is the greatest gap over the corners."""
    if answer.velocity_jumps or (not carried.flat and carried.roller == 0):
        return
    least = extreme(turn, lambda *state: room(carried, *state), -1)
    scale = carried.sizes["base_radius"] if carried.flat else 1.0
    if least > 1e-9 * scale and not answer.undercut:
        # a verdict is right or wrong
        yield from stated.compare("undercut", 0.0, Exact(0), 0.5)
    elif least < -1e-9 * scale:
        yield from stated.compare("undercut", float(answer.undercut), Exact(1), 0.5)
        exact = _greatest_gap(turn, carried)
        name = "swing_lost" if turn.swing else "lift_lost"
        size = 1.0 if turn.swing else sum(map(abs, carried.sizes.values())) + max(map(abs, turn.levels))
        yield from stated.compare(name, getattr(answer, name), exact, 1e-9 * size, size=size)


class _Envelope:
    """The envelope over the turn in doubles, and at single angles exactly."""

    def __init__(self, turn: Turn, carried: Carried) -> None:
        self.turn, self.carried = turn, carried
        shares = np.linspace(0.0, 1.0, SAMPLES, endpoint=False)
        self.zones = [zone for zone in turn.zones if zone.branch is not None]
        angles, points, rooms, lifts = [], [], [], []
        for zone in self.zones:
            state = zone.over(shares, 2)
            low, high = float(zone.start), float(zone.end)
            theta = low + (high - low) * shares
            x, y = carried.turned(carried.touch(*state)["point"], theta)
            angles.append(theta)
            points.append(x + 1j * y)
            rooms.append(room(carried, *state))
            lifts.append(state[0])
        self.angles, self.points, self.rooms = (np.concatenate(part) for part in (angles, points, rooms))
        self.lifts = np.concatenate(lifts)

    def zone_at(self, theta: Any) -> Zone:
        """The zone of an angle."""
        return next((zone for zone in self.turn.zones if zone.start <= theta <= zone.end), self.turn.zones[-1])

    def point(self, theta: Any) -> Ends:
        """The point of contact in the cam's frame, exactly."""
        zone = self.zone_at(theta)
        return self.carried.turned(self.carried.touch(*zone.at(theta, 2))["point"], theta)

    def stretches(self) -> list[tuple[int, int]]:
        """First and last sample of every backward stretch, none of them over the ends of the samples."""
        below = np.concatenate(([False], self.rooms < 0.0, [False]))
        steps = np.diff(below.astype(int))
        return list(zip(np.flatnonzero(steps == 1).tolist(), (np.flatnonzero(steps == -1) - 1).tolist(), strict=True))


def _greatest_gap(turn: Turn, carried: Carried) -> Any:
    """The lift lost where every backward stretch has one corner of its own that nothing else cuts away; else None."""
    envelope = _Envelope(turn, carried)
    best, last = None, -1.0
    for first, final in envelope.stretches():
        found = _corner(envelope, first, final)
        if found is None or float(found[0]) <= last or _covered(envelope, found):
            return None
        gap = _gap(envelope, found)
        if gap is None:
            return None
        best = gap if best is None else max(best, gap)
        last = float(found[1])
    return best


def _corner(envelope: _Envelope, first: int, final: int) -> Ends | None:
    """The two angles of the corner about a backward stretch, by Newton's method from crossings of the samples."""
    low, high = envelope.angles[first], envelope.angles[final]
    wide = max(final - first, 3)
    before = np.arange(max(first - 6 * wide, 0), first)
    after = np.arange(final + 1, min(final + 1 + 6 * wide, envelope.angles.size))
    starts = [(low - k * (high - low), high + k * (high - low)) for k in (0.25, 0.5, 1.0)]
    for i, j in _crossings(envelope.points, before, after):
        starts.insert(0, (envelope.angles[i], envelope.angles[j]))
    for a, b in starts:
        found = _solved(envelope, Exact(float(a)), Exact(float(b)))
        if found is not None and found[0] < low and found[1] > high:
            return found
    return None


def _crossings(points: Any, before: Any, after: Any) -> list[tuple[int, int]]:
    """Pairs of samples whose steps cross, the last found nearest to the stretch."""
    if before.size < 2 or after.size < 2:
        return []
    (px, py), (qx, qy) = ((points[own[:-1]].real, points[own[:-1]].imag) for own in (before, after))
    (rx, ry), (sx, sy) = ((np.diff(points[own].real), np.diff(points[own].imag)) for own in (before, after))
    away = (qx - px[:, None]) * sy - (qy - py[:, None]) * sx
    with np.errstate(all="ignore"):
        share = away / (rx[:, None] * sy - ry[:, None] * sx)
    i, j = np.nonzero((share >= 0.0) & (share <= 1.0))
    with np.errstate(all="ignore"):
        other = ((qx[j] - px[i]) * ry[i] - (qy[j] - py[i]) * rx[i]) / (rx[i] * sy[j] - ry[i] * sx[j])
    kept = (other >= 0.0) & (other <= 1.0)
    hits = np.stack((i[kept], j[kept]), axis=1)
    return [(int(before[i]), int(after[j])) for i, j in sorted(hits.tolist(), key=lambda hit: hit[1] - hit[0])][:3][
        ::-1
    ]


def _solved(envelope: _Envelope, a: Any, b: Any) -> Ends | None:
    """Two angles whose points are one, by Newton's method on differences of 2⁻¹⁰⁰."""
    step = Exact(2) ** -100
    size = max(map(abs, envelope.carried.sizes.values()))
    for _ in range(30):
        if not 0 < a < b < Exact(6.2831):
            return None
        (ax, ay), (bx, by) = envelope.point(a), envelope.point(b)
        (ux, uy), (vx, vy) = envelope.point(a + step), envelope.point(b + step)
        m = ((ux - ax) / step, (uy - ay) / step, -(vx - bx) / step, -(vy - by) / step)
        fx, fy = ax - bx, ay - by
        if abs(fx) + abs(fy) < Exact(size) * Exact(2) ** -170:
            return (a, b) if b - a > 1e-9 else None
        whole = m[0] * m[3] - m[1] * m[2]
        if whole == 0:
            return None
        a, b = a - (fx * m[3] - fy * m[2]) / whole, b - (fy * m[0] - fx * m[1]) / whole
    return None


def _covered(envelope: _Envelope, found: Ends) -> bool:
    """Whether another position of the follower takes the corner away."""
    x, y = envelope.point(found[0])
    theta = envelope.angles
    here = (theta < float(found[0]) - 1e-3) | (theta > float(found[1]) + 1e-3)
    gap = _fallen(envelope.carried, (float(x), float(y)), theta, envelope.lifts)
    # where the follower cannot reach the point its gap is no number
    inside = gap[here & ~np.isnan(gap)]
    return bool((inside < -1e-7 * (1.0 if envelope.turn.swing else np.abs(envelope.points).max())).any())


def _fallen(carried: Carried, corner: Any, theta: Any, lift: Any) -> Any:
    """How far the follower falls behind its lift at an angle, resting on a corner of the cam."""
    f, roller, start = carried._given(lift)
    sin, cos = sine_cosine(carried.turn * theta)
    x, y = corner[0] * cos - corner[1] * sin, corner[0] * sin + corner[1] * cos
    with np.errstate(invalid="ignore"):
        if carried.kind == "FlatFace":
            rest = y
        elif not carried.swing:
            away = x - f.get("offset", 0)
            rest = y + carried.side * sqrt(roller * roller - away * away)
        else:
            over = f["pivot_distance"] - x
            square = over * over + y * y
            if carried.flat:
                # far sin(ψ − β) is the offset of the face
                back = f.get("face_offset", 0)
                rest = arc_tangent(y, over) + arc_tangent(back + 0 * square, sqrt(square - back * back))
            else:
                arm = f["arm"]
                along = (arm * arm + square - roller * roller) / (2 * arm)
                rest = arc_tangent(y, over) + carried.side * arc_tangent(sqrt(square - along * along), along)
    return carried.side * (lift - (rest - start))


class _Gap:
    """The gap on a corner as a function of the angle, as the climbing takes it."""

    def __init__(self, zone: Zone) -> None:
        self.zone = zone

    def jets(self, theta: Any, _: int) -> tuple[Jet, Jet]:
        """The angle and the lift there."""
        return Jet(theta, Exact(1), Exact(0)), Jet(*self.zone.at(theta, 2))


def _gap(envelope: _Envelope, found: Ends) -> Any:
    """The greatest gap on a corner."""
    carried = envelope.carried
    corner = envelope.point(found[0])
    rough = float(corner[0]), float(corner[1])
    best: tuple[float, Any, Any, Any, Any] | None = None
    for zone in envelope.turn.zones:
        low, high = max(found[0], zone.start), min(found[1], zone.end)
        if low >= high:
            continue
        share = np.linspace(float((low - zone.start) / (zone.end - zone.start)),
                            float((high - zone.start) / (zone.end - zone.start)), 101)  # fmt: skip
        theta = float(zone.start) + float(zone.end - zone.start) * share
        gaps = _fallen(carried, rough, theta, zone.over(share, 2)[0])
        if np.isnan(gaps[1:-1]).any():
            return None
        i = int(np.nanargmax(gaps))
        if best is None or gaps[i] > best[0]:
            step = (high - low) / 100
            middle = low + step * i
            best = (
                float(gaps[i]),
                zone,
                max(middle - step, low),
                min(max(middle, low + step / 8), high - step / 8),
                min(middle + step, high),
            )
    if best is None:
        return None
    _, zone, low, middle, high = best
    return climbed(
        lambda theta, lift: _fallen(carried, corner, theta, lift), _Gap(zone), (low, high), middle, 1, 0, abs(best[0])
    )
