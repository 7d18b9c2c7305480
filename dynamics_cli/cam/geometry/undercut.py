"""Effect of an undercut: where the cutter removes material that the follower needs, and the lift that is lost there.

On the cut cam the follower rests on a corner wherever its own contact has been cut away.
"""

from math import inf, isfinite

import numpy as np

from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.geometry.corners import BLURRED, TURN, Corner, left_by
from dynamics_cli.cam.geometry.envelope import Envelope
from dynamics_cli.cam.geometry.followers import FlatFace, OscillatingFlat
from dynamics_cli.cam.program.pieces import best_of, within
from dynamics_cli.numerics.chebyshev.proxies import extremes, proxies
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Position error of a corner, relative to the cam's size.
FOUND = 2e-15
# Rounding of the gap between lift and seat, relative to the sizes of cam and follower.
ROUNDED = 1.2e-15
SLIPPING = 2049


@record
class Loss:
    """The effect of an undercut."""

    lift: Annotated[
        float, "Maximum lift lost [m, or rad for an arm]; infinite where no surface remains to support the follower."
    ]
    at: Annotated[float, "Cam angle there [rad]."]
    error: Annotated[float, "Bound of the error of the lift lost [m or rad]."]
    stretches: Annotated[tuple[tuple[float, float], ...], "Cam angles between which the envelope runs backwards."]
    corners: Annotated[tuple[Corner, ...], "Corners of the remaining piece around the axis; empty if none remains."]
    pieces: Annotated[int, "Pieces of the cam that are cut off."]


def lift_lost(geometry: Geometry, motion: "Any", *, forward: bool = False) -> "Loss | None":
    """The maximum lift lost to an undercut, or None where there is no undercut.

    `geometry`: the follower in place, on either flank; `motion`: the program; `forward`: whether the curve is known to
    run forwards within every zone (`analysis.runs_forward`). Returns the lift lost; on an outer flank, how far the
    follower can leave its program outwards.

    The maximum gap between the program and a follower resting on a corner, from proxies whose remainder is
    estimated. For the corners see `corners.left_by`.
    """
    curve = Envelope(geometry, motion)
    remainder = left_by(curve, forward=forward)
    if remainder is None:
        return None
    if not remainder.edge:
        return Loss(inf, 0.0, 0.0, remainder.stretches, (), remainder.pieces)
    lift, place, error = _worst(
        curve, remainder.edge, remainder.size, FOUND if all(corner.exact for corner in remainder.edge) else BLURRED
    )
    if not remainder.stretches and remainder.pieces == 1 and lift <= BLURRED * remainder.size:
        # a dwell that is a point of the cam, on its axis
        return None
    return Loss(lift, float(place) % TURN, error, remainder.stretches, remainder.edge, remainder.pieces - 1)


def seat(geometry: Geometry, theta: "Any", x: "Any", y: "Any") -> "Any":
    """The lift at which the follower rests on a point of the cam; minus infinity where it slips past.

    `theta`: cam angles; `x`, `y`: points in the cam's frame, broadcast against `theta`. Returns lifts in the way in
    which the flank drives: negative ones of a second follower or of an outer flank [m or rad].
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
            # half the angle by its tangent: no cancellation where the roller is much smaller than the arm
            inner, outer = (roller - (arm - far)) * (roller + (arm - far)), (arm + far - roller) * (arm + far + roller)
            opening = 2.0 * np.arctan2(np.sqrt(inner), np.sqrt(outer))
        lift = level + opening - start if drives > 0.0 else start - (level - opening)
    return np.where(np.isnan(lift), -np.inf, lift)


def _worst(curve: Envelope, loop: "tuple[Corner, ...]", size: float, off: float) -> "tuple[float, float, float]":
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
        losses = proxies(lambda share, piece: level + lost(share, piece), np.zeros(count), np.ones(count))
    except ValueError:
        return _slipping(curve, parts, np.array([corner.point for corner in loop]))
    candidates = extremes(losses)
    near = candidates.near(1.0)
    piece, share = candidates.owner[near], candidates.places[near]
    gaps = lost(share[:, None], piece)[0, :, 0]
    index = int(gaps.argmax())
    best = int(piece[index])
    place = starts[best] + spans[best] * (low[best] + wide[best] * float(share[index]))
    # the seat rounds as if the corner were elsewhere by roundings of the lengths of cam and follower
    steep = _steep(geometry, place, complex(points[best]), 1e-6 * size)
    rounded = ROUNDED * (size + _reach(geometry)) * steep
    rounded += 2.0**-51 * (abs(geometry.start) + max(map(abs, motion.stroke)))
    error = best_of(gaps, rounded, candidates.gains[near])[2]
    return max(float(gaps[index]), 0.0), place, error + off * size * steep


def _steep(geometry: Geometry, theta: float, point: complex, step: float) -> float:
    """Sensitivity of the seat to the position of its point, by differences."""
    moved = point + step * np.array([1.0, -1.0, 1.0j, -1.0j])
    rests = seat(geometry, np.full(4, theta), moved.real, moved.imag)
    # where it slips past, its seat is at minus infinity
    with np.errstate(invalid="ignore"):
        slope = float(np.hypot(rests[0] - rests[1], rests[2] - rests[3])) / (2.0 * step)
    return slope if isfinite(slope) else inf


def _reach(geometry: Geometry) -> float:
    """Lengths of the follower that determine its seat."""
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


def _gone(curve: Envelope, loop: "tuple[Corner, ...]") -> "tuple[list[tuple[int, float, float]], Any]":
    """Lengths of zones whose contact is gone, as zone, first share and span, with the corner rested on in each."""
    zones: list[tuple[int, float, float]] = []
    points: list[complex] = []
    for corner in loop:
        over = len(curve.parts) if corner.returns < corner.leaves else 0
        for part in range(int(corner.leaves), int(corner.returns) + over + 1):
            zone = curve.parts[part % len(curve.parts)]
            low, high = max(corner.leaves - part, 0.0), min(corner.returns + over - part, 1.0)
            if isinstance(zone, int) and low < high:
                zones.append((zone, low, high - low))
                points.append(corner.point)
    return zones, np.array(points)
