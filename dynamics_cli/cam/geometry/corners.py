"""What an undercut leaves of a cam: where the cutter takes the envelope away, and the corners where it crosses itself.

The cut cam is what no position of the follower covers. Its edge is the envelope where that is left, and corners where
the envelope crosses itself.
"""

from math import pi

import numpy as np

from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.geometry.crossings import Crossing, crossings
from dynamics_cli.cam.geometry.envelope import Arc, Envelope
from dynamics_cli.cam.geometry.followers import FlatFace, OscillatingFlat
from dynamics_cli.cam.program.pieces import within
from dynamics_cli.numerics.chebyshev.proxies import extremes, proxies
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

TURN = 2.0 * pi
# A corner that another position of the follower covers by less than this share of the cam's size is on its edge.
COVERED = 1e-12
# Where no corner is found between ends this close, of the cam's size, the undercut is less than its rounding.
NOTHING = 1e-11
# How far a corner may be from its place, of the cam's size, where points are too near to separate.
BLURRED = 1e-12


@record
class Corner:
    """A corner of what is left."""

    leaves: Annotated[float, "Place at which the curve leaves the edge."]
    returns: Annotated[float, "Place at which it comes back to it."]
    point: Annotated[complex, "The corner [m]."]
    exact: Annotated[
        bool,
        "Whether Newton's method has found it; else it is within the rounding of points too near to separate.",
    ]


@record
class Left:
    """What an undercut leaves of a cam."""

    stretches: Annotated[tuple[tuple[float, float], ...], "Cam angles between which the envelope runs backwards."]
    edge: Annotated[
        tuple[Corner, ...],
        "Corners of the piece that winds about the axis, in order along the curve; empty where nothing does.",
    ]
    pieces: Annotated[int, "All pieces that are left, that one among them."]
    size: Annotated[float, "Size of the cam [m]."]


def left_by(curve: Envelope, *, forward: bool = False) -> "Left | None":
    """What an undercut leaves of a cam, or None where the whole envelope is its edge.

    `curve`: the envelope of the follower; `forward`: whether the curve is known to run forwards within every zone
    (`analysis.runs_forward`). Returns the corners of what is left.

    The envelope runs backwards between certified places. All crossings of its forward arcs are found by halving pairs
    of arcs and by Newton's method; those that no position of the follower covers are corners, and the way from corner
    to corner along the curve is the edge of each piece that is left, of which one winds about the axis. How far an
    arc bends is taken from samples with a quarter to spare; beyond that nothing depends on samples, however small the
    undercut or however many run into each other. A place where the velocity jumps counts as backwards where its two
    contacts are in the wrong order.
    """
    if not curve.geometry.flat and curve.geometry.roller == 0.0:
        return None
    backward = curve.backward(forward=forward)
    arcs = curve.forward(backward)
    size = max((max(abs(arc.first), abs(arc.last)) for arc in arcs), default=0.0)
    found = _uncovered(curve.geometry, curve.motion, crossings(curve, arcs, size), size)
    if not backward and not found:
        return None
    whole = [_corner(curve, crossing) for crossing in found] + _cusps(curve, backward, found, size)
    loops = _loops(whole, backward, arcs)
    main = [loop for loop in loops if _winds(loop, arcs)]
    edge = tuple(main[0]) if main else ()
    return Left(tuple(_wrapped(curve, backward)), edge, len(loops), size)


def _wrapped(curve: Envelope, backward: "list[tuple[float, float]]") -> "list[tuple[float, float]]":
    """Stretches as cam angles; one that runs over the end of the turn is one."""
    wrapped = [(curve.angle_at(low), curve.angle_at(high)) for low, high in backward]
    if len(wrapped) > 1 and backward[0][0] == 0.0 and backward[-1][1] == len(curve.parts):
        wrapped[-1] = (wrapped[-1][0], wrapped.pop(0)[1] + TURN)
    return wrapped


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
    interpolants = proxies(depth, np.zeros(count), np.ones(count))
    return [
        crossing
        for index, crossing in enumerate(found)
        if extremes(interpolants, index).smallest()[0] >= -COVERED * size * (size if geometry.roller else 1.0)
    ]


def clearance(geometry: Geometry, s: "Any", point: "Any") -> "Any":
    """How far a point of the fixed frame is from being covered by the follower at lift s.

    `s`: lifts; `point`: points as complex numbers [m]. Returns square of the distance from the roller's centre less
    that of its radius [m²], or distance from a flat face towards the cam [m]; negative where covered.
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
        return Corner(crossing.first, crossing.second, crossing.point, crossing.exact)
    return Corner(crossing.second, crossing.first, crossing.point, crossing.exact)


def _cusps(
    curve: Envelope, backward: "list[tuple[float, float]]", found: "list[Crossing]", size: float
) -> "list[Corner]":
    """Backward stretches that are too short for a corner of their own: the curve stands there."""
    cusps = []
    for low, high in backward:
        if any(crossing.first <= low and high <= crossing.second for crossing in found):
            continue
        ends = []
        for place in (low, high):
            part = min(int(place), len(curve.parts) - 1)
            ends.append(complex(curve.at(part, np.array([place - part]))[0][0]))
        if abs(ends[1] - ends[0]) <= NOTHING * size:
            cusps.append(Corner(low, high, 0.5 * (ends[0] + ends[1]), exact=False))
    return cusps


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
