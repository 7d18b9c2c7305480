"""What an undercut costs: where the cutter takes away what the follower needs, and the lift that is lost there.

The cut cam is what no position of the follower covers. Its edge is the envelope where that is left, and corners where
the envelope crosses itself; put back on the cam, the follower rests on such a corner wherever its own contact is gone.
"""

from math import inf, isfinite, pi

import numpy as np

from dynamics_cli.cam.contact import Geometry
from dynamics_cli.cam.crossings import Crossing, crossings
from dynamics_cli.cam.envelope import Arc, Envelope
from dynamics_cli.cam.followers import FlatFace, OscillatingFlat
from dynamics_cli.cam.pieces import within
from dynamics_cli.numerics.chebyshev import Proxies, extremes, proxies
from dynamics_cli.numerics.summits import settled, summits
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

TURN = 2.0 * pi
# A corner that another position of the follower covers by less than this share of the cam's size is on its edge.
COVERED = 1e-12
# How far a corner may be from its place, of the cam's size: found, and where points are too near to tell.
FOUND = 2e-15
# What a gap between lift and seat rounds by, of the sizes of cam and follower.
ROUNDED = 1.2e-15
BLURRED = 1e-12
SLIPPING = 2049
# Where no corner is found between ends this close, of the cam's size, the undercut is less than its rounding.
NOTHING = 1e-11


@record
class Loss:
    """What an undercut costs.

    Parameters
    ----------
    lift : float
        Greatest lift lost [m, or rad for an arm]; infinite where nothing is left for the follower to rest on.
    at : float
        Cam angle there [rad].
    error : float
        Bound of the error of the lift lost [m or rad].
    stretches : tuple of pairs
        Cam angles between which the envelope runs backwards.
    corners : int
        Corners of what is left.
    pieces : int
        Pieces of the cam that are cut off.
    """

    lift: float
    at: float
    error: float
    stretches: tuple[tuple[float, float], ...]
    corners: int
    pieces: int


@record
class Corner:
    """A corner of what is left: where the curve leaves the edge, where it comes back to it, and the point."""

    leaves: float
    returns: float
    point: complex


def lift_lost(geometry: Geometry, motion: "Any", *, forward: bool = False) -> "Loss | None":
    """The greatest lift that an undercut costs, or None where there is no undercut.

    Parameters
    ----------
    geometry : Geometry
        The follower in place, on either flank.
    motion : Motion
        The program.
    forward : bool
        Whether the curve is known to run forwards within every zone (`analysis.runs_forward`).

    Returns
    -------
    Loss | None
        The lift lost; on an outer flank, how far the follower can leave its program outwards.

    Notes
    -----
    The envelope runs backwards between certified places. All crossings of its forward arcs are found by halving pairs
    of arcs and by Newton's method; those that no position of the follower covers are corners, and the way from corner
    to corner along the curve is the edge of each piece that is left, of which one winds about the axis. How far an
    arc bends is taken from samples with a quarter to spare, and the greatest gap from proxies whose remainder is
    estimated; beyond that nothing depends on samples, however small the undercut or however many run into each other.
    A place where the velocity jumps counts as backwards where its two contacts are in the wrong order.
    """
    curve = Envelope(geometry, motion)
    if not geometry.flat and geometry.roller == 0.0:
        return None
    backward = curve.backward(forward=forward)
    arcs = curve.forward(backward)
    size = max((max(abs(arc.first), abs(arc.last)) for arc in arcs), default=0.0)
    found = _uncovered(geometry, motion, crossings(curve, arcs, size), size)
    if not backward and not found:
        return None
    stretches = tuple(_wrapped(curve, backward))
    whole = [_corner(curve, crossing) for crossing in found] + _cusps(curve, backward, found, size)
    loops = _loops(whole, backward, arcs)
    main = [loop for loop in loops if _winds(loop, arcs)]
    if not main:
        return Loss(inf, 0.0, 0.0, stretches, 0, len(loops))
    corner = FOUND if all(crossing.exact for crossing in found) and len(whole) == len(found) else BLURRED
    lift, place, error = _worst(curve, main[0], size, corner)
    if not backward and len(loops) == 1 and lift <= BLURRED * size:
        # a dwell that is a point of the cam, on its axis
        return None
    return Loss(lift, float(place) % TURN, error, stretches, len(main[0]), len(loops) - 1)


def _wrapped(curve: Envelope, backward: "list[tuple[float, float]]") -> "list[tuple[float, float]]":
    """Stretches as cam angles; one that runs over the end of the turn is one."""
    found = [(curve.angle_at(low), curve.angle_at(high)) for low, high in backward]
    if len(found) > 1 and backward[0][0] == 0.0 and backward[-1][1] == len(curve.parts):
        found[-1] = (found[-1][0], found.pop(0)[1] + TURN)
    return found


def _uncovered(geometry: Geometry, motion: "Any", found: "list[Crossing]", size: float) -> "list[Crossing]":
    """The crossings that no position of the follower takes away, certified."""
    if not found:
        return []
    points = np.array([crossing.point for crossing in found])[:, None, None]
    starts = np.array([zone.start for zone in motion.zones])
    widths = np.array([zone.end for zone in motion.zones]) - starts

    def depth(share: "Any", piece: "Any") -> "Any":
        s = within(motion, share, piece, 0)[0]
        theta = starts[piece][:, None] + widths[piece][:, None] * share
        return clearance(geometry, s[None], points * np.exp(1j * geometry.turn * theta))

    count = len(motion.zones)
    made = proxies(depth, np.zeros(count), np.ones(count))
    return [
        crossing
        for index, crossing in enumerate(found)
        if extremes(made, index).smallest()[0] >= -COVERED * size * (size if geometry.roller else 1.0)
    ]


def clearance(geometry: Geometry, s: "Any", point: "Any") -> "Any":
    """How far a point of the fixed frame is from being covered by the follower at lift s.

    Parameters
    ----------
    geometry : Geometry
        The follower in place.
    s : array
        Lifts.
    point : array
        Points as complex numbers [m].

    Returns
    -------
    array
        Square of the distance from the roller's centre less that of its radius [m²], or distance from a flat face
        towards the cam [m]; negative where covered.
    """
    f, level = geometry.follower, geometry.start + s
    if isinstance(f, FlatFace):
        return level - point.imag
    if isinstance(f, OscillatingFlat):
        along = (f.pivot_distance - point.real) * np.sin(level) - point.imag * np.cos(level)
        return along - f.face_offset
    away = np.abs(point - _centre(geometry, level))
    return (away - geometry.roller) * (away + geometry.roller)


def _centre(geometry: Geometry, level: "Any") -> "Any":
    """The roller's centre, as complex numbers."""
    f: Any = geometry.follower
    return f.pivot_distance - f.arm * np.exp(-1j * level) if geometry.oscillating else f.offset + 1j * level


def _corner(curve: Envelope, crossing: Crossing) -> Corner:
    """Which of the two passages leaves the edge: the cam is within the sides of both."""
    if curve.sense * crossing.turn < 0.0:
        return Corner(crossing.first, crossing.second, crossing.point)
    return Corner(crossing.second, crossing.first, crossing.point)


def _cusps(
    curve: Envelope, backward: "list[tuple[float, float]]", found: "list[Crossing]", size: float
) -> "list[Corner]":
    """Backward stretches that are too short for a corner of their own: the curve stands there."""
    made = []
    for low, high in backward:
        if any(crossing.first <= low and high <= crossing.second for crossing in found):
            continue
        ends = []
        for place in (low, high):
            part = min(int(place), len(curve.parts) - 1)
            ends.append(complex(curve.at(part, np.array([place - part]))[0][0]))
        if abs(ends[1] - ends[0]) <= NOTHING * size:
            made.append(Corner(low, high, 0.5 * (ends[0] + ends[1])))
    return made


def _loops(corners: "list[Corner]", backward: "list[tuple[float, float]]", arcs: "list[Arc]") -> "list[list[Corner]]":
    """The closed ways along the curve from each corner to the next: edges of the pieces left."""
    if not corners:
        return []
    # the curve leaves the edge at a corner, at last where it turns back
    stops = [(corner.leaves, 0, index) for index, corner in enumerate(corners)]
    stops = sorted([*stops, *((low, 1, -1) for low, _ in backward)])
    loops: list[list[Corner]] = []
    seen: set[int] = set()
    for start in range(len(corners)):
        way: list[int] = []
        now = start
        while now >= 0 and now not in way and now not in seen:
            way.append(now)
            place = corners[now].returns
            now = next((index for leaves, _, index in stops if leaves >= place and index != now), stops[0][2])
        if now in way:
            loops.append([corners[index] for index in way[way.index(now) :]])
        seen.update(way)
    return loops


def _winds(loop: "list[Corner]", arcs: "list[Arc]") -> bool:
    """Whether a way along the curve goes round the cam's axis, or through it."""
    points: list[complex] = []
    for index, corner in enumerate(loop):
        last = loop[(index + 1) % len(loop)].leaves
        points.append(corner.point)
        inside = [arc for arc in arcs if arc.start >= corner.returns]
        if last < corner.returns:
            inside += [arc for arc in arcs if arc.end <= last]
        else:
            inside = [arc for arc in inside if arc.end <= last]
        points += [arc.first for arc in inside] + [arc.last for arc in inside[-1:]]
    turned = sum(np.angle(b / a) for a, b in zip(points, [*points[1:], points[0]], strict=True) if a and b)
    return abs(turned) > pi or min(map(abs, points)) <= NOTHING * max(map(abs, points))


def seat(geometry: Geometry, theta: "Any", x: "Any", y: "Any") -> "Any":
    """The lift at which the follower rests on a point of the cam; minus infinity where it slips past.

    Parameters
    ----------
    geometry : Geometry
        The follower in place.
    theta : array
        Cam angles.
    x, y : array
        Points in the cam's frame, broadcast against `theta`.

    Returns
    -------
    array
        Lifts in the way in which the flank drives: negative ones of a second follower or of an outer flank [m or rad].
    """
    f, start, roller = geometry.follower, geometry.start, geometry.roller
    drives = geometry.way * geometry.side
    cos, sin = np.cos(theta), geometry.turn * np.sin(theta)
    px, py = x * cos - y * sin, x * sin + y * cos
    with np.errstate(invalid="ignore"):
        if isinstance(f, FlatFace):
            return py - start
        if isinstance(f, OscillatingFlat):
            far = np.hypot(px - f.pivot_distance, py)
            return np.arctan2(py, f.pivot_distance - px) + np.arcsin(f.face_offset / far) - start
        if not geometry.oscillating:
            away = px - f.offset  # type: ignore[union-attr]
            level, opening = py, np.sqrt((roller - away) * (roller + away))
        else:
            far = np.hypot(px - f.pivot_distance, py)  # type: ignore[union-attr]
            level = np.arctan2(py, f.pivot_distance - px)  # type: ignore[union-attr]
            arm = f.arm  # type: ignore[union-attr]
            # half the angle by its tangent: nothing cancels where the roller is small beside the arm
            inner, outer = (roller - (arm - far)) * (roller + (arm - far)), (arm + far - roller) * (arm + far + roller)
            opening = 2.0 * np.arctan2(np.sqrt(inner), np.sqrt(outer))
        found = level + opening - start if drives > 0.0 else start - (level - opening)
    return np.where(np.isnan(found), -np.inf, found)


def _worst(curve: Envelope, loop: "list[Corner]", size: float, off: float) -> "tuple[float, float, float]":
    """The greatest lift lost on any corner of a loop, its cam angle, and its error, corners being `off` that share."""
    motion, geometry = curve.motion, curve.geometry
    drives = geometry.way * geometry.side
    parts, points = _gone(curve, loop)
    if not parts:
        return 0.0, curve.angle_at(loop[0].leaves), 0.0
    zones, low, wide = (np.array(column) for column in zip(*parts, strict=True))
    starts = np.array([motion.zones[zone].start for zone in zones.tolist()])
    spans = np.array([motion.zones[zone].end for zone in zones.tolist()]) - starts
    # lifts far below the size are known to the roundings of the size
    level = 1.0 if geometry.oscillating else size

    def lost(share: "Any", piece: "Any") -> "Any":
        place = low[piece][:, None] + wide[piece][:, None] * share
        s = within(motion, place, zones[piece], 0)[0]
        theta = starts[piece][:, None] + spans[piece][:, None] * place
        point = points[piece][:, None]
        return (drives * s - seat(geometry, theta, point.real, point.imag))[None]

    count = len(parts)
    try:
        made = proxies(lambda share, piece: level + lost(share, piece), np.zeros(count), np.ones(count))
    except ValueError:
        return _slipping(curve, parts, np.array([corner.point for corner in loop]))
    # their remainder is estimated, and so is its slope: what is left is the rounding of the gap itself
    count = made.coefficients.shape[2]
    left = made.error + ROUNDED * level
    made = Proxies(made.owner, made.starts, made.ends, made.coefficients, left, False, (count + 2.0) ** 2 * left)
    (top,) = summits(made, ways=(1.0,))
    piece = made.owner[top.rows]
    share = 0.5 * (made.starts + made.ends)[top.rows] + 0.5 * (made.ends - made.starts)[top.rows] * top.units
    gaps = lost(share[:, None], piece)[0, :, 0]
    index = int(gaps.argmax())
    own = int(piece[index])
    place = starts[own] + spans[own] * (low[own] + wide[own] * float(share[index]))
    # the seat rounds as if the corner were elsewhere by roundings of the lengths of cam and follower
    steep = _steep(geometry, place, complex(points[own]), 1e-6 * size)
    rounded = ROUNDED * (size + _reach(geometry)) * steep
    rounded += 2.0**-51 * (abs(geometry.start) + max(map(abs, motion.stroke)))
    error = settled(top, level + gaps, np.full(gaps.shape, rounded))[2]
    return max(float(gaps[index]), 0.0), place, error + off * size * steep


def _steep(geometry: Geometry, theta: float, point: complex, step: float) -> float:
    """How far the seat on a point moves for each metre of the point, by differences."""
    moved = point + step * np.array([1.0, -1.0, 1.0j, -1.0j])
    rests = seat(geometry, np.full(4, theta), moved.real, moved.imag)
    found = float(np.hypot(rests[0] - rests[1], rests[2] - rests[3])) / (2.0 * step)
    return found if isfinite(found) else inf


def _reach(geometry: Geometry) -> float:
    """Lengths of the follower that its seat is told from."""
    f: Any = geometry.follower
    if isinstance(f, FlatFace):
        return 0.0
    if isinstance(f, OscillatingFlat):
        return float(f.pivot_distance + abs(f.face_offset))
    return float(geometry.roller + (f.pivot_distance + f.arm if geometry.oscillating else abs(f.offset)))


def _slipping(curve: Envelope, parts: "list[tuple[int, float, float]]", points: "Any") -> "tuple[float, float, float]":
    """The loss where the follower slips past a corner and rests on the next, from samples, with their spacing as bound.

    Infinite where it finds nothing to rest on: far beyond any cam that works.
    """
    motion, geometry = curve.motion, curve.geometry
    drives = geometry.way * geometry.side
    worst = 0.0, 0.0, 0.0
    for number, low, span in parts:
        share = low + span * np.linspace(0.0, 1.0, SLIPPING)
        zone = motion.zones[number]
        theta = zone.start + (zone.end - zone.start) * share
        rests = seat(geometry, theta[:, None], points.real, points.imag).max(axis=1)
        lost = drives * motion.in_zone(number, share, 0)[0] - rests
        index = int(np.argmax(lost))
        if lost[index] == inf:
            return inf, float(theta[index]), 0.0
        near = lost[max(index - 1, 0) : index + 2]
        worst = max(worst, (float(lost[index]), float(theta[index]), float(np.ptp(near))))
    return worst


def _gone(curve: Envelope, loop: "list[Corner]") -> "tuple[list[tuple[int, float, float]], Any]":
    """Lengths of zones whose contact is gone, as zone, first share and span, with the corner rested on in each."""
    found: list[tuple[int, float, float]] = []
    points: list[complex] = []
    for corner in loop:
        over = len(curve.parts) if corner.returns < corner.leaves else 0
        for part in range(int(corner.leaves), int(corner.returns) + over + 1):
            zone = curve.parts[part % len(curve.parts)]
            low, high = max(corner.leaves - part, 0.0), min(corner.returns + over - part, 1.0)
            if isinstance(zone, int) and low < high:
                found.append((zone, low, high - low))
                points.append(corner.point)
    return found, np.array(points)
