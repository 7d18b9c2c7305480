"""A curve of the cam to be drawn or cut, at a distance from the contact, with enclosures of its acceleration."""

import numpy as np

from dynamics_cli.cam.contact import Geometry
from dynamics_cli.cam.followers import FlatFace, OscillatingFlat
from dynamics_cli.cam.pieces import over_pieces, pieces, sample, turning_places
from dynamics_cli.errors import require
from dynamics_cli.numerics.intervals import Interval

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Path:
    """Cam, pitch or cutter curve: the contact moved `away` along its normal, in the cam's frame.

    z′ = turn·g (n_y, −n_x) with g = run + away·spin, and |z″| ≤ |g′| + |g·spin|.
    """

    def __init__(self, geometry: Geometry, motion: "Any", *, away: float, start_angle: float = 0.0) -> None:
        self.geometry = geometry
        self.motion = motion
        self.away = away
        self.start_angle = start_angle
        self.starts, self.ends = pieces(motion)
        jerks = over_pieces(motion, lambda s, s1, s2, s3: s3[None], 3)
        # on the Chebyshev coefficients: |s⁗| ≤ Σ k²|c_k|·2/length, on the piece the law has there
        k = np.arange(jerks.coefficients.shape[2])
        steep = (np.abs(jerks.coefficients[0]) @ (k * k) + 1024.0 * jerks.error[0]) * 2.0 / (jerks.ends - jerks.starts)
        self.snap = np.zeros(self.starts.size)
        np.maximum.at(self.snap, jerks.owner, steep / (self.ends - self.starts)[jerks.owner])
        self.still = np.array([zone.dwell for zone in motion.zones])

    def at(self, theta: "Any") -> "tuple[Any, ...]":
        """Point, unit direction of travel and speed at cam angles."""
        s, s1, s2 = sample(self.motion, theta, 2)
        touch = self.geometry.touch(s, s1, s2)
        (x, y), (nx, ny) = touch.point, touch.normal
        g = touch.run + self.away * touch.spin
        px, py = self.geometry.turned((x + self.away * nx, y + self.away * ny), theta, self.start_angle)
        mx, my = self.geometry.turned((nx, ny), theta, self.start_angle)
        turn = self.geometry.turn
        return px, py, turn * my, -turn * mx, g

    def require_regular(self) -> None:
        """Refuse a curve that stops or runs backwards: it cuts itself and no machine can follow it."""

        def speed(s: "Any", s1: "Any", s2: "Any") -> "Any":
            touch = self.geometry.touch(s, s1, s2)
            return (touch.run + self.away * touch.spin)[None]

        slowest, place = turning_places(self.motion, over_pieces(self.motion, speed)).smallest()
        require(
            slowest > 0.0,
            "the curve is undercut: at a cam angle of {0:.6g} deg it runs backwards and cuts itself",
            float(np.degrees(place)),
            code="undercut",
            hint="raise the base radius, take a smaller roller, or see `cam check` for the lift that is lost",
        )

    def acceleration(self, theta: "Any", half: "Any", piece: "Any") -> "tuple[Any, Any]":
        """Bounds of |z″| and of |z′| on the cells of middle `theta` and half width `half`, each in its piece."""
        s, s1, s2, s3 = sample(self.motion, theta)
        turn = self.geometry.turn
        j = Interval.about(turn * s3, self.snap[piece] * half)
        a = Interval.about(s2, j.size * half)
        v = Interval.about(turn * s1, a.size * half)
        h = Interval.about(s, v.size * half)
        speed, change, spin = self._enclosed(h, v, a, j)
        return change.size + (speed * spin).size, speed.size

    def _enclosed(self, s: Interval, s1: Interval, s2: Interval, s3: Interval) -> "tuple[Interval, Interval, Interval]":
        """Speed g, its derivative g′ and the spin, from enclosures of the lift and three derivatives."""
        f, geometry, away = self.geometry.follower, self.geometry, self.away
        if isinstance(f, FlatFace):
            one = Interval(np.ones_like(s.low), np.ones_like(s.low))
            return s + s2 + (geometry.start + away), s1 + s3, one
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

    def _pitch(self, s: Interval, s1: Interval, s2: Interval, s3: Interval) -> "tuple[Interval, ...]":
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
