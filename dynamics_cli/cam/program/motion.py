"""A whole revolution of lift over cam angle, as segments that join exactly.

Interface for the whole family
---------------------------------------
A task takes the program as its first parameter and one option, `def task(scene: Program, /, *, program: Text = "", …)`,
and calls `motion = motion_of(scene, program)` (both from `dynamics_cli.cam.program.reading`).

- `motion.at(theta, derivatives=3, side=1) -> (s, s1, s2, s3)`: lift and its derivatives per radian at a float or an
  array of cam angles in radians, any number of turns; `side=-1` takes the value before a joint, `+1` after it.
- `motion.zones`: `Zone(start, end, segment, dwell)` in radians, in order, from `motion.start` to `motion.start` + 2π:
  within a zone all derivatives exist; at its ends some may jump. Segment ends are always zone ends.
- `motion.in_zone(index, t, derivatives=3)`: the same four at local coordinates 0 ≤ t ≤ 1 of that zone, with the
  one-sided values at its ends and full accuracy on the shortest spans.
- `motion.joints`: angles of the segments' ends, `len(segments) + 1` of them; `motion.segments`: what they are.
- `motion.swing`: whether the lift is an angle (an oscillating follower, lift in radians) or a length (metres).
- `motion.stroke`: the least and the greatest level (extremes of s at stationary points and ends).
"""

from bisect import bisect_left, bisect_right
from math import floor, inf

from dynamics_cli.cam.laws.peaks import extremes
from dynamics_cli.cam.program.parts import Part, Span, Zone, radians
from dynamics_cli.numerics.number import is_array

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

TURN = 6.283185307179586
_TURN_LOW = 2.4492935982947064e-16

BLOCK = 8192


class Motion:
    """Lift over one revolution, and its derivatives per radian; periodic.

    `segments`: segments in order, each starting where the one before ends, 360° together; `swing`: whether the lift is
    an angle.

    The table of segments is exact: ends are ratios of whole numbers of degrees, and each is held in radians with the
    rounding error of its double, so that no rounding accumulates over the turn.

    Examples
    --------
    >>> from dynamics_cli.cam.laws.normalised import law_named
    >>> rise = Span((0, 1), (180, 1), 0.0, 0.02, law_named("cycloidal"))
    >>> fall = Span((180, 1), (360, 1), 0.02, 0.0, law_named("cycloidal"))
    >>> Motion([rise, fall]).at(3.141592653589793)[0]
    0.02
    """

    def __init__(self, segments: "Sequence[Span]", *, swing: bool = False) -> None:
        self.segments = tuple(segments)
        self.swing = swing
        self.joints = [radians(span.start)[0] for span in self.segments] + [radians(self.segments[-1].end)[0]]
        self.start = self.joints[0]
        self._pieces: list[Part] = []
        self._edges: list[float] = []
        zones: list[Zone] = []
        self._zone_pieces: list[list[int]] = []
        for index, span in enumerate(self.segments):
            self._add(index, span, zones)
        self.zones = tuple(zones)
        self._edges.pop()
        self._edge_array: Any = None

    def _add(self, index: int, span: Span, zones: "list[Zone]") -> None:
        start, end = self.joints[index], self.joints[index + 1]
        first = len(self._pieces)
        if span.law is None:
            self._pieces.append(Part(span, index, None))
            self._edges.append(end)
            zones.append(Zone(start, end, index, True))
            self._zone_pieces.append([first])
            return
        inside: list[int] = []
        low = start
        for piece in span.law.pieces:
            part = Part(span, index, piece)
            if piece.low in span.law.breaks:
                self._zone_pieces.append(inside)
                zones.append(Zone(low, self._edges[-1], index, False))
                low, inside = self._edges[-1], []
            inside.append(len(self._pieces))
            self._pieces.append(part)
            edge = end - piece.ends[0] * part.span if piece.far else start + piece.high * part.span
            self._edges.append(end if piece.high == 1.0 else edge)
        zones.append(Zone(low, end, index, False))
        self._zone_pieces.append(inside)

    def wrapped(self, theta: "Any", side: int = 1) -> "Any":
        """The same angle within the turn that begins at `start`; at its end when `side` is -1."""
        first, last = self.joints[0], self.joints[-1]
        if type(theta) is float:
            if first < theta < last or (theta == first and side > 0) or (theta == last and side < 0):
                return theta
            turns = floor((theta - first) / TURN)
            angle = (theta - turns * TURN) - turns * _TURN_LOW
            return self._settled(angle, side)
        if theta.size and theta.min() > first and theta.max() < last:
            return theta
        import numpy as np

        turns = np.floor((theta - first) / TURN)
        angle = (theta - turns * TURN) - turns * _TURN_LOW
        if side > 0:
            angle[angle >= last] = first
            return np.maximum(angle, first)
        angle[angle <= first] = last
        return np.minimum(angle, last)

    def _settled(self, angle: float, side: int) -> float:
        first, last = self.joints[0], self.joints[-1]
        if side > 0:
            return first if angle >= last or angle < first else angle
        return last if angle <= first or angle > last else angle

    def at(self, theta: "Any", derivatives: int = 3, side: int = 1) -> "tuple[Any, ...]":
        """Lift and its derivatives per radian at cam angles; before a joint with `side=-1`, after it with +1.

        `theta`: cam angles, of any turn [rad]; `derivatives`: how many derivatives, 0 to 4; `side`: which value where
        one jumps. Returns s, ds/dθ, …, each a float or an array of the shape of `theta`.

        Errors are within 10⁻¹⁵ of the peak for s and ds/dθ, apart from the effect of the rounding of `theta`.
        """
        if isinstance(theta, (int, float)):
            theta = self.wrapped(float(theta), side)
            find = bisect_right if side > 0 else bisect_left
            piece = self._pieces[find(self._edges, theta)]
            return tuple(piece.give(piece.local(theta), derivatives))
        return self._over_array(theta, derivatives, side)

    def _over_array(self, theta: "Any", derivatives: int, side: int) -> "tuple[Any, ...]":
        import numpy as np

        angles = np.asarray(theta, dtype=float)
        angle = angles.ravel()
        if self._edge_array is None:
            self._edge_array = np.array(self._edges)
        out = np.empty((derivatives + 1, angle.size))
        first, last = self.joints[0], self.joints[-1]
        if not angle.size:
            return tuple(row.reshape(angles.shape) for row in out)
        if bool((angle[1:] >= angle[:-1]).all()) and first <= angle[0] and angle[-1] <= last:
            self._over_sorted(angle, derivatives, side, out)
            # The end of the turn is its start, approached from the other side.
            end = slice(angle.searchsorted(last), None) if side > 0 else slice(angle.searchsorted(first, side="right"))
            if out[0, end].size:
                out[:, end] = np.reshape(self.at(first if side > 0 else last, derivatives, side), (-1, 1))
            return tuple(row.reshape(angles.shape) for row in out)
        angle = self.wrapped(angle, side)
        which = np.searchsorted(self._edge_array, angle, side="right" if side > 0 else "left")
        for index in np.unique(which).tolist():
            piece, part = self._pieces[index], which == index
            for order, values in enumerate(piece.give(piece.local(angle[part]), derivatives)):
                out[order, part] = values
        return tuple(row.reshape(angles.shape) for row in out)

    def by_parts(self, angle: "Any") -> "list[tuple[Any, Any]]":
        """Parts, each with the indices of the angles (an array within the turn, in order) that lie in it or end it."""
        import numpy as np

        ends = [*self._edges, inf]
        starts = [-inf, *self._edges]
        return [
            (piece, np.arange(angle.searchsorted(low), angle.searchsorted(high, side="right")))
            for piece, low, high in zip(self._pieces, starts, ends, strict=True)
            if angle.searchsorted(low) < angle.searchsorted(high, side="right")
        ]

    def _over_sorted(self, angle: "Any", derivatives: int, side: int, out: "Any") -> None:
        """Piece by piece, in blocks that stay in the cache."""
        cuts = angle.searchsorted(self._edge_array, side="left" if side > 0 else "right")
        bounds = [0, *cuts.tolist(), angle.size]
        for piece, start, stop in zip(self._pieces, bounds, bounds[1:], strict=False):
            if piece.law_piece is None:
                out[0, start:stop] = piece.base
                out[1:, start:stop] = 0.0
                continue
            for low in range(start, stop, BLOCK):
                part = slice(low, min(low + BLOCK, stop))
                for order, values in enumerate(piece.give(piece.local_of_sorted(angle[part]), derivatives)):
                    out[order, part] = values

    def in_zone(self, index: int, t: "Any", derivatives: int = 3) -> "tuple[Any, ...]":
        """Lift and derivatives per radian at local coordinates 0 ≤ t ≤ 1 of a zone.

        `index`: which zone; `t`: share of the zone's span; `derivatives`: how many derivatives, 0 to 4. Returns s,
        ds/dθ, …; at t = 0 and t = 1 the values within the zone.
        """
        pieces = self.parts_of(index)
        law = pieces[0].law_piece
        if law is None:
            return tuple(pieces[0].give(t, derivatives))
        low, high = law.low, pieces[-1].law_piece.high
        if not is_array(t):
            return tuple(_within(pieces, low, high, float(t), derivatives))
        import numpy as np

        out = np.empty((derivatives + 1, *t.shape))
        for piece, inside, local in located(pieces, t):
            for order, values in enumerate(piece.give(local, derivatives)):
                out[order][inside] = values
        return tuple(out)

    def parts_of(self, index: int) -> "list[Part]":
        """The pieces of a zone's law in order, each with the end it is measured from."""
        return [self._pieces[i] for i in self._zone_pieces[index]]

    def width(self, segment: int) -> float:
        """Span of a segment [rad]; the difference of its rounded ends loses digits where it is narrow."""
        span = self.segments[segment]
        return radians((span.end[0] * span.start[1] - span.start[0] * span.end[1], span.end[1] * span.start[1]))[0]

    @property
    def stroke(self) -> "tuple[float, float]":
        """The least and the greatest lift."""
        least, most = inf, -inf
        for span in self.segments:
            ends = [span.low, span.high]
            if span.law is not None and not span.law.monotone:
                scale = span.high - span.low if span.scale is None else span.scale
                ends += [span.low + scale * f for _, f in extremes(span.law, 0)]
            least, most = min(least, *ends), max(most, *ends)
        return least, most


def located(pieces: "list[Part]", share: "Any") -> "list[tuple[Part, Any, Any]]":
    """The parts of a zone with the shares (an array) that lie in each, and these in the part's own coordinate."""
    if pieces[0].law_piece is None:
        return [(pieces[0], slice(None), share)]
    low, high = pieces[0].law_piece.low, pieces[-1].law_piece.high
    x = low + (high - low) * share
    places = []
    for piece in pieces:
        law_piece = piece.law_piece
        inside = (x >= law_piece.low) if piece is pieces[-1] else (x >= law_piece.low) & (x < law_piece.high)
        places.append((piece, inside, _from_end(law_piece, low, high, share[inside])))
    return places


def _from_end(law_piece: "Any", low: float, high: float, t: "Any") -> "Any":
    """Distance from the end of the segment that this piece is measured from."""
    if law_piece.far:
        return (1.0 - high) + (high - low) * (1.0 - t)
    return low + (high - low) * t


def _within(pieces: "list[Part]", low: float, high: float, t: float, derivatives: int) -> "list[Any]":
    x = low + (high - low) * t
    piece = next((item for item in pieces if x < item.law_piece.high), pieces[-1])
    return piece.give(_from_end(piece.law_piece, low, high, t), derivatives)
