"""The remainder of an undercut cam: where the cutter removes the envelope, and the corners where it crosses itself.

The cut cam is the region that no position of the follower covers. Its edge is the remaining envelope, with corners
where the envelope crosses itself.
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
# A corner covered by another position of the follower by less than this share of the cam's size counts as on its edge.
COVERED = 1e-12
# If no corner exists between ends closer than this (relative to the cam's size), the undercut is below rounding.
NOTHING = 1e-11
# Position error of a corner, relative to the cam's size, where points are too near to separate.
BLURRED = 1e-12


@record
class Corner:
    """A corner of the remaining cam."""

    leaves: Annotated[float, "Place at which the curve leaves the edge."]
    returns: Annotated[float, "Place at which it comes back to it."]
    point: Annotated[complex, "The corner [m]."]
    exact: Annotated[
        bool,
        "Whether Newton's method has found it; else it is within the rounding of points too near to separate.",
    ]


@record
class Left:
    """The remainder of an undercut cam."""

    stretches: Annotated[tuple[tuple[float, float], ...], "Cam angles between which the envelope runs backwards."]
    edge: Annotated[
        tuple[Corner, ...],
        "Corners of the piece that winds about the axis, in order along the curve; empty where nothing does.",
    ]
    pieces: Annotated[int, "All pieces that are left, that one among them."]
    size: Annotated[float, "Size of the cam [m]."]


def left_by(curve: Envelope, *, forward: bool = False) -> "Left | None":
    """The remainder of an undercut cam, or None where the whole envelope is its edge.

    `curve`: the envelope of the follower; `forward`: whether the curve is known to run forwards within every zone
    (`analysis.runs_forward`). Returns the corners of the remainder.

    The envelope runs backwards between places where it stands. All crossings of its forward arcs are found by halving
    pairs of arcs and by Newton's method; those that no position of the follower covers are corners, and the path from
    corner to corner along the curve is the edge of each remaining piece, one of which encloses the axis. The turning of
    an arc is taken from samples with a margin of a quarter; nothing else depends on samples, however small the undercut
    and even where several merge. A velocity jump counts as backwards if its two contacts are in the wrong order.
    """
    if not curve.geometry.flat and curve.geometry.roller == 0.0:
        return None
    backward = curve.backward(forward=forward)
    arcs = curve.forward(backward)
    size = max((max(abs(arc.first), abs(arc.last)) for arc in arcs), default=0.0)
    corners = _uncovered(curve.geometry, curve.motion, crossings(curve, arcs, size), size)
    if not backward and not corners:
        return None
    all_corners = [_corner(curve, crossing) for crossing in corners] + _cusps(curve, backward, corners, size)
    loops = _loops(all_corners, backward, arcs)
    main = [loop for loop in loops if _winds(loop, arcs)]
    edge = tuple(main[0]) if main else ()
    return Left(tuple(_wrapped(curve, backward)), edge, len(loops), size)


def _wrapped(curve: Envelope, backward: "list[tuple[float, float]]") -> "list[tuple[float, float]]":
    """Stretches as cam angles; one that crosses the end of the turn counts once."""
    wrapped = [(curve.angle_at(low), curve.angle_at(high)) for low, high in backward]
    if len(wrapped) > 1 and backward[0][0] == 0.0 and backward[-1][1] == len(curve.parts):
        wrapped[-1] = (wrapped[-1][0], wrapped.pop(0)[1] + TURN)
    return wrapped


def _uncovered(geometry: Geometry, motion: "Any", crossings_met: "list[Crossing]", size: float) -> "list[Crossing]":
    """The crossings that no position of the follower covers."""
    if not crossings_met:
        return []
    points = np.array([crossing.point for crossing in crossings_met])[:, None, None]
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
        for index, crossing in enumerate(crossings_met)
        if extremes(interpolants, index).smallest()[0] >= -COVERED * size * (size if geometry.roller else 1.0)
    ]


def clearance(geometry: Geometry, s: "Any", point: "Any") -> "Any":
    """Clearance of a point of the fixed frame from the follower at lift s.

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
    """The corner, with the passage that leaves the edge: the cam is on the inner side of both."""
    if curve.sense * crossing.turn < 0.0:
        return Corner(crossing.first, crossing.second, crossing.point, crossing.exact)
    return Corner(crossing.second, crossing.first, crossing.point, crossing.exact)


def _cusps(
    curve: Envelope, backward: "list[tuple[float, float]]", crossings_met: "list[Crossing]", size: float
) -> "list[Corner]":
    """Backward stretches too short for a corner: the curve stops there."""
    cusps = []
    for low, high in backward:
        if any(crossing.first <= low and high <= crossing.second for crossing in crossings_met):
            continue
        ends = []
        for place in (low, high):
            part = min(int(place), len(curve.parts) - 1)
            ends.append(complex(curve.at(part, np.array([place - part]))[0][0]))
        if abs(ends[1] - ends[0]) <= NOTHING * size:
            cusps.append(Corner(low, high, 0.5 * (ends[0] + ends[1]), exact=False))
    return cusps


def _loops(corners: "list[Corner]", backward: "list[tuple[float, float]]", arcs: "list[Arc]") -> "list[list[Corner]]":
    """The closed paths along the curve from each corner to the next: edges of the remaining pieces."""
    if not corners:
        return []
    # the curve leaves the edge at a corner, at last where it turns back
    stops = [(corner.leaves, 0, index) for index, corner in enumerate(corners)]
    stops = sorted([*stops, *((low, 1, -1) for low, _ in backward)])
    loops: list[list[Corner]] = []
    seen: set[int] = set()
    for start in range(len(corners)):
        route: list[int] = []
        now = start
        while now >= 0 and now not in route and now not in seen:
            route.append(now)
            place = corners[now].returns
            now = next((index for leaves, _, index in stops if leaves >= place and index != now), stops[0][2])
        if now in route:
            loops.append([corners[index] for index in route[route.index(now) :]])
        seen.update(route)
    return loops


def _winds(loop: "list[Corner]", arcs: "list[Arc]") -> bool:
    """Whether a path along the curve encloses the cam's axis, or passes through it."""
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
