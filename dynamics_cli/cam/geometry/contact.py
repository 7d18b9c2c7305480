"""Where cam and follower touch: exact envelopes in the fixed frame, from the lift and its derivatives by cam angle.

With p the centre of the roller, u = dp/dθ − ip is its velocity relative to the cam; the outward normal is iu/|u|, and
the cam's curve is p − R_r n. A flat face touches where its normal passes the instant centre. Everything here is exact
and works on arrays; a clockwise cam is an anticlockwise one with the motion reversed.
"""

from math import pi

import numpy as np

from dynamics_cli.cam.geometry.followers import (
    FLAT,
    ConjugateOscillatingRoller,
    ConjugateRoller,
    Flank,
    FlatFace,
    Follower,
    OscillatingFlat,
    OscillatingRoller,
    Rotation,
    mate_angle,
    roller_radius,
    start_angle_of_arm,
    start_angle_of_face,
    start_height,
)
from dynamics_cli.cam.program.segments import LARGEST, SMALLEST
from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated, Ratio
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Pair = tuple[Any, Any]


@record
class Touch:
    """Contact at some cam angles, in the fixed frame (arrays)."""

    centre: Annotated["Pair", "Centre of the roller, or the point of contact of other followers [m]."]
    point: Annotated["Pair", "The point of contact [m]."]
    normal: Annotated["Pair", "Unit vector from the cam into the follower."]
    run: Annotated[
        "Any", "Speed of the point of contact along the cam per radian, negative where the envelope runs backwards [m]."
    ]
    spin: Annotated["Any", "How fast the normal turns back in the cam, per radian of the cam."]
    curvature: Annotated["Any", "Curvature of the pitch curve (roller and knife-edge), convex positive [1/m]."]
    radius: Annotated["Any", "Radius of curvature of the cam under a flat face; None for the others [m]."]
    pressure_angle: Annotated[
        "Any", "Angle from the follower's way to the normal, positive in the sense in which the cam turns [rad]."
    ]


class Geometry:
    """A follower over a cam: gives the contact at cam angles from its lift and derivatives there."""

    def __init__(self, follower: Follower, rotation: str = "counter-clockwise", flank: str = "inner") -> None:
        self.follower = follower
        self.turn = -1.0 if Rotation(rotation) == "clockwise" else 1.0
        self.side = -1.0 if Flank(flank) == "outer" else 1.0
        self.roller = roller_radius(follower)
        self.flat = isinstance(follower, FLAT)
        require(
            self.side > 0.0 or self.roller > 0.0,
            "only a roller runs in a track that has an outer flank",
            code="flank",
            hint="give a roller radius above zero",
        )
        sizes = [abs(size) for size in vars(follower).values()]
        require(
            all(size == 0.0 or SMALLEST < size < LARGEST for size in sizes),
            "a length of the follower is larger than any cam could have",
            code="range",
            hint="check the units of its lengths",
        )
        self.way = 1.0
        if isinstance(follower, OscillatingRoller):
            self.start = start_angle_of_arm(follower.base_radius, self.roller, follower.arm, follower.pivot_distance)
        elif isinstance(follower, ConjugateOscillatingRoller):
            self.start, self.way = mate_angle(follower), -1.0
        elif isinstance(follower, OscillatingFlat):
            self.start = start_angle_of_face(follower.base_radius, follower.face_offset, follower.pivot_distance)
        elif isinstance(follower, FlatFace):
            self.start = follower.base_radius
        else:
            self.start = start_height(follower.base_radius, self.roller, follower.offset)
            if isinstance(follower, ConjugateRoller):
                self.start, self.way = self.start - follower.roller_distance, -1.0

    @property
    def oscillating(self) -> bool:
        """Whether the lift is an angle."""
        return isinstance(self.follower, OscillatingRoller | OscillatingFlat | ConjugateOscillatingRoller)

    def pitch(self, s: "Any", s1: "Any", s2: "Any", s3: "Any" = None) -> "tuple[Any, ...]":
        """Centre (x, y) of the roller, u = (X, Y) and its derivatives by cam angle, of the anticlockwise cam."""
        f = self.follower
        if isinstance(f, OscillatingRoller | ConjugateOscillatingRoller):
            angle = self.start + s
            sin, cos = np.sin(angle), np.cos(angle)
            g, g1 = f.arm * (1.0 + s1), f.arm * s2
            along = g * s1
            first = (g * sin, g * cos - f.pivot_distance, g1 * sin + along * cos, g1 * cos - along * sin)
            place = (f.pivot_distance - f.arm * cos, f.arm * sin)
            if s3 is None:
                return (*place, *first)
            g2, twice, square = f.arm * s3, 2.0 * g1 * s1, g * s1 * s1
            return (
                *place, *first,
                (g2 - square) * sin + (twice + g * s2) * cos, (g2 - square) * cos - (twice + g * s2) * sin,
            )  # fmt: skip
        height, offset = self.start + s, f.offset  # type: ignore[union-attr]
        return (offset, height, height, s1 - offset, s1, s2, s2, s3)

    def touch(self, s: "Any", s1: "Any", s2: "Any") -> Touch:
        """Contact for a lift and its first two derivatives by cam angle (arrays), before the start angle is applied."""
        s1 = self.turn * s1
        if self.flat:
            return self._flat(s, s1, s2)
        x, y, big_x, big_y, x1, y1 = self.pitch(s, s1, s2)[:6]
        w, curvature = _curvature(big_x, big_y, x1, y1)
        nx, ny = -big_y / w, big_x / w
        reach = self.side * self.roller
        spin = curvature * w
        run = w - reach * spin
        pressure = self.turn * self._pressure(s, s1, big_x, big_y)
        return Touch((x, y), (x - reach * nx, y - reach * ny), (nx, ny), run, spin, curvature, None, pressure)

    def point(self, s: "Any", s1: "Any", away: float = 0.0) -> "Pair":
        """The point of contact alone, moved `away` along the normal, in the fixed frame: half the cost of a touch."""
        f, s1 = self.follower, s1 if self.turn > 0.0 else -s1
        if isinstance(f, FlatFace):
            height = self.start + s
            return s1, height + away if away else height
        if isinstance(f, OscillatingFlat):
            angle = self.start + s
            sin, cos = np.sin(angle), np.cos(angle)
            along, back = f.pivot_distance * cos / (1.0 + s1), f.face_offset - away
            return f.pivot_distance - along * cos - back * sin, along * sin - back * cos
        if self.oscillating:
            angle = self.start + s
            sin, cos = np.sin(angle), np.cos(angle)
            g = f.arm * (1.0 + s1)  # type: ignore[union-attr]
            big_x, big_y = g * sin, g * cos - f.pivot_distance  # type: ignore[union-attr]
            x, y = f.pivot_distance - f.arm * cos, f.arm * sin  # type: ignore[union-attr]
        else:
            x, y = f.offset, self.start + s  # type: ignore[union-attr]
            big_x, big_y = y, s1 - x
        scale = (self.side * self.roller - away) / np.sqrt(big_x * big_x + big_y * big_y)
        return x + scale * big_y, y - scale * big_x

    def bends(self, s: "Any", s1: "Any", s2: "Any") -> "tuple[Any, ...]":
        """The quantities that extremes are taken of: curvature or radius, pressure angle, place along a face."""
        if self.flat:
            touch = self._flat(s, self.turn * s1, s2)
            return touch.radius, touch.pressure_angle, self.along(touch)
        s1 = self.turn * s1
        _, _, big_x, big_y, x1, y1 = self.pitch(s, s1, s2)[:6]
        return _curvature(big_x, big_y, x1, y1)[1], self.turn * self._pressure(s, s1, big_x, big_y)

    def along(self, touch: Touch) -> "Any":
        """Where a flat face is touched, along it: to the right of the slide, or away from the pivot."""
        if isinstance(self.follower, OscillatingFlat):
            (x, y), (nx, ny) = touch.point, touch.normal
            return (self.follower.pivot_distance - x) * ny + y * nx
        return touch.point[0]

    def _pressure(self, s: "Any", s1: "Any", big_x: "Any", big_y: "Any") -> "Any":
        """Angle from the direction the cam drives a roller in to the normal, of the anticlockwise cam.

        With the normal i(X + iY)/w it is arctan2(Y, X) of a slide, and arctan2(g − c cos ψ, c sin ψ) of an arm, where
        g = L(1 + ψ′): g − c cos ψ = (L − c) + L ψ′ + 2c sin²(ψ/2) keeps its digits near the line of pivot and axis.
        """
        if not self.oscillating:
            return np.arctan2(self.way * big_y, self.way * big_x)
        f, angle = self.follower, self.start + s
        arm, c = f.arm, f.pivot_distance  # type: ignore[union-attr]
        half = np.sin(0.5 * angle)
        across = (arm - c) + arm * s1 + (2.0 * c) * (half * half)
        return np.arctan2(self.way * across, (self.way * c) * np.sin(angle))

    def _flat(self, s: "Any", s1: "Any", s2: "Any") -> Touch:
        f = self.follower
        if isinstance(f, FlatFace):
            height = self.start + s
            radius = height + s2
            nothing, ones = np.zeros_like(height), np.ones_like(height)
            point = (s1 + nothing, height)
            return Touch(point, point, (nothing, ones), radius, ones, nothing, radius, nothing)
        angle, speed = self.start + s, 1.0 + s1
        sin, cos = np.sin(angle), np.cos(angle)
        c, back = f.pivot_distance, f.face_offset  # type: ignore[union-attr]
        along = c * cos / speed
        radius = c * (sin * (1.0 + 2.0 * s1) * speed + s2 * cos) / (speed * speed * speed) - back
        point = (c - along * cos - back * sin, along * sin - back * cos)
        return Touch(
            point, point, (sin, cos), radius * speed, speed, 0.0 * sin, radius, -self.turn * np.arctan2(back, along)
        )

    def turned(self, point: "Pair", theta: "Any", start_angle: float = 0.0) -> "Pair":
        """A point of the fixed frame as one of the cam: back by the cam angle, forward by the start angle."""
        return rotated(point, theta, self.turn, start_angle)


def rotated(point: "Pair", theta: "Any", turn: float, start_angle: float) -> "Pair":
    """A point turned by −turn·θ + start angle."""
    angle = theta if not start_angle else theta - turn * start_angle
    cos, sin = np.cos(angle), np.sin(angle)
    if turn < 0.0:
        sin = -sin
    x, y = point
    return x * cos + y * sin, y * cos - x * sin


def _curvature(big_x: "Any", big_y: "Any", x1: "Any", y1: "Any") -> "Pair":
    """Speed w of the pitch curve, and its curvature (1 + (Y X′ − X Y′)/w²)/w."""
    square = big_x * big_x + big_y * big_y
    w = np.sqrt(square)
    return w, (1.0 + (big_y * x1 - big_x * y1) / square) / w


BLOCK = 8192


def curve(geometry: Geometry, motion: "Any", theta: "Any") -> "Pair":
    """The cam's curve at an array of cam angles, in blocks that stay in the cache."""
    out = np.empty((2, theta.size))
    for low in range(0, theta.size, BLOCK):
        part = theta[low : low + BLOCK]
        out[0, low : low + BLOCK], out[1, low : low + BLOCK] = rotated(
            geometry.point(*motion.at(part, 1)), part, geometry.turn, 0.0
        )
    return out[0], out[1]


def turned_back(count: int, start_angle: float, turn: float) -> "tuple[Any, Any]":
    """Cosines and sines that turn equal steps of one turn back into the cam, exact at quarters of the turn."""
    step = np.arange(count)
    quarter = (8 * step + count) // (2 * count)
    rest = (4 * step - quarter * count) * (0.5 * pi / count)
    quarters = round(start_angle / (0.5 * pi))
    angle = turn * rest - (start_angle - quarters * (0.5 * pi))
    cos, sin = np.cos(angle), np.sin(angle)
    quarter = (int(turn) * quarter - quarters) % 4
    return np.choose(quarter, (cos, -sin, -cos, sin)) + 0.0, np.choose(quarter, (sin, cos, -sin, -cos)) + 0.0


def check_speed(geometry: Geometry, s1: "Any") -> None:
    """Refuse a flat rocker that swings back as fast as the cam turns: it would touch at infinity."""
    if isinstance(geometry.follower, OscillatingFlat):
        slowest = float(np.min(1.0 + geometry.turn * np.asarray(s1)))
        require(
            slowest > 0.0,
            "the rocker turns as fast as the cam (1 + dψ/dθ falls to {slowest}): a flat face cannot follow this motion",
            slowest=(slowest, Ratio),
            code="face-too-fast",
            hint="give the return a larger angle of the cam",
        )
