"""A curve of the cam for drawing or cutting, offset from the contact, with proved enclosures on cells."""

import numpy as np

from dynamics_cli.cam.geometry.analysis import refuse_size, start_slip
from dynamics_cli.cam.geometry.contact import Geometry, rotated
from dynamics_cli.cam.geometry.followers import FlatFace, OscillatingFlat
from dynamics_cli.cam.laws.components import U
from dynamics_cli.cam.program.pieces import Cover, pieces, sample
from dynamics_cli.errors import require
from dynamics_cli.numerics.discs import UP, Disc
from dynamics_cli.numerics.fitting.path import OnPiece
from dynamics_cli.quantities import Angle

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Path:
    """Cam, pitch or cutter curve: the contact moved `away` along its normal, in the cam's frame.

    z′ = turn·g (n_y, −n_x) with g = run + away·spin, and |z″|² = g′² + (g·spin)². `points` and `acceleration` are
    enclosures in disc arithmetic, from the laws' own constants, including the rounding of every step; a follower's
    start height or angle counts as eight roundings.
    """

    parameter = "cam angle"
    sharp = "the contact nearly stops there: raise the base radius"

    def __init__(self, geometry: Geometry, motion: "Any", *, away: float, start_angle: float = 0.0) -> None:
        self.geometry = geometry
        self.turn = geometry.turn
        self.motion = motion
        self.away = away
        self.start_angle = start_angle
        self.starts, self.ends = pieces(motion)
        self.still = np.array([zone.dwell for zone in motion.zones])
        self.straight: tuple[int, ...] = ()
        self.slip = start_slip(geometry)

    def at(self, theta: "Any", piece: "int | None" = None) -> "tuple[Any, ...]":
        """Point, unit direction of travel and speed at cam angles; those of one piece of the motion if it is named.

        At the joint of two pieces each has its own values.
        """
        s, s1, s2 = sample(self.motion, theta, 2)
        if piece is not None:
            end = theta >= self.ends[piece]
            if end.any():
                for part, value in zip((s, s1, s2), self.motion.in_zone(piece, 1.0, 2), strict=True):
                    part[end] = value
        touch = self.geometry.touch(s, s1, s2)
        (x, y), (nx, ny) = touch.point, touch.normal
        g = touch.run + self.away * touch.spin
        px, py = self.geometry.turned((x + self.away * nx, y + self.away * ny), theta, self.start_angle)
        mx, my = self.geometry.turned((nx, ny), theta, self.start_angle)
        turn = self.geometry.turn
        return px, py, turn * my, -turn * mx, g

    def on(self, piece: int) -> "OnPiece":
        """The curve seen from within one piece of the motion."""
        return OnPiece(self, piece)

    def require_regular(self) -> None:
        """Refuse a curve that stops or runs backwards: it cuts itself and no machine can follow it."""

        def speed(s: "Any", s1: "Any", s2: "Any") -> "Any":
            touch = self.geometry.touch(s.widened(self.slip), s1, s2)
            return (touch.run + self.away * touch.spin)[None]

        try:
            with np.errstate(all="ignore"):
                (extremes,) = Cover(self.motion, speed).ends()
        except ValueError:
            refuse_size()
            raise
        slowest, place = extremes.smallest()
        require(
            slowest > extremes.error,
            "the curve is undercut: at a cam angle of {place:6} it runs backwards and cuts itself",
            place=(place, Angle),
            code="undercut",
            hint="raise the base radius, take a smaller roller, or see the lift that is lost with `dynamics cam check`",
        )

    def points(self, theta: "Any", piece: int) -> "tuple[Disc, Disc]":
        """Discs that hold the coordinates of the curve at cam angles (n,) of one piece of the motion."""
        s, s1 = _about(self.motion, piece, theta, np.zeros(1), 1)
        point = self.geometry.point(s.widened(self.slip), s1, self.away)
        return rotated(point, Disc(theta, 0.0), self.geometry.turn, self.start_angle)

    def acceleration(self, theta: "Any", half: "Any", piece: int) -> "tuple[Any, Any]":
        """Proved bounds of |z″| and of |z′| on cells of middle `theta` and half width `half` of one piece."""
        turn = self.geometry.turn
        with np.errstate(all="ignore"):
            s, s1, s2, s3 = _about(self.motion, piece, theta, half, 3)
            speed, change, spin = self._enclosed(s.widened(self.slip), turn * s1, s2, turn * s3)
            # one is along the curve, the other perpendicular to it
            return np.hypot(change.size, (speed * spin).size) * (1.0 + 2.0**-49), speed.size

    def _enclosed(self, s: Disc, s1: Disc, s2: Disc, s3: Disc) -> "tuple[Disc, Disc, Disc]":
        """Speed g, its derivative g′ and the spin, from enclosures of the lift and three derivatives."""
        f, geometry, away = self.geometry.follower, self.geometry, self.away
        if isinstance(f, FlatFace):
            disc = Disc(np.ones_like(s.centre), np.zeros_like(s.radius))
            return s + s2 + (geometry.start + away), s1 + s3, disc
        if isinstance(f, OscillatingFlat):
            angle, spin = s + geometry.start, s1 + 1.0
            sin, cos, less = angle.sine(), angle.cosine(), spin.inverse()
            c, back = f.pivot_distance, f.face_offset - away
            square = less.square()
            speed = c * (sin * (2.0 - less) + s2 * cos * square) - back * spin
            change = (
                c * (cos * s1 * (2.0 - less) + (s2 * sin * (1.0 - s1) + s3 * cos) * square)
                - (2.0 * c) * (s2.square() * cos * square * less) - back * s2
            )  # fmt: skip
            return speed, change, spin
        x, y, x1, y1, x2, y2 = self._pitch(s, s1, s2, s3)
        square = x.square() + y.square()
        w = square.root()
        less = square.inverse()
        w1 = (x * x1 + y * y1) * w.inverse()
        across = y * x1 - x * y1
        spin = 1.0 + across * less
        # the change of D/w² with D = w² + Y X′ − X Y′
        turning = (y * x2 - x * y2) * less - 2.0 * (across * w1 * w.inverse() * less)
        reach = geometry.side * geometry.roller - away
        return w - reach * spin, w1 - reach * turning, spin

    def _pitch(self, s: Disc, s1: Disc, s2: Disc, s3: Disc) -> "tuple[Disc, ...]":
        f, start = self.geometry.follower, self.geometry.start
        if not self.geometry.oscillating:
            return s + start, s1 - f.offset, s1, s2, s2, s3  # type: ignore[union-attr]
        angle = s + start
        sin, cos = angle.sine(), angle.cosine()
        arm = f.arm  # type: ignore[union-attr]
        g, g1, g2 = arm * (s1 + 1.0), arm * s2, arm * s3
        along, twice = g * s1, 2.0 * (g1 * s1)
        radial, cross = g2 - g * s1.square(), twice + g * s2
        return (
            g * sin, g * cos - f.pivot_distance,  # type: ignore[union-attr]
            g1 * sin + along * cos, g1 * cos - along * sin,
            radial * sin + cross * cos, radial * cos - cross * sin,
        )  # fmt: skip


def _about(motion: "Any", index: int, theta: "Any", half: "Any", derivatives: int) -> "tuple[Disc, ...]":
    """Lift and derivatives on cells of half width `half` about cam angles (n,), which need not be within the zone.

    The value in the middle, widened by the half width times the next derivative's bound on the cell.
    """
    parts = motion.parts_of(index)
    owner = np.zeros(theta.size, dtype=int)
    for number, part in enumerate(parts[1:], 1):
        # measured from the other end, or farther along
        t = part.local(theta)
        owner[(1.0 - t if part.law_piece.far else t) >= part.law_piece.low] = number
    half = np.broadcast_to(half, theta.shape)
    centres, radii = np.empty((2, derivatives + 1, theta.size))
    for number, part in enumerate(parts):
        rows = np.flatnonzero(owner == number)
        if not rows.size:
            continue
        t = theta[rows] if part.law_piece is None else part.local(theta[rows])
        off, wide = U * (5.0 * np.abs(t) + 3.0), half[rows]
        values = part.bounded(Disc(t, off), derivatives)
        if wide.any():
            beyond = part.bounded(Disc(t, off + wide / part.span * UP), derivatives + 1)[1:]
            values = [value.widened(wide * slope.size) for value, slope in zip(values, beyond, strict=True)]
        for order, value in enumerate(values):
            centres[order, rows], radii[order, rows] = value.centre, value.radius
    return tuple(map(Disc, centres, radii))
