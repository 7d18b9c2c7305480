"""Meshes in exact numbers: the line of action, backlash, and the least distances from the roots.

The distances are found where the path of a tip's edge runs along the other gear's root and is nearest to it, by slopes
of both curves from differences and from the least of a grid in doubles; of the law of gearing nothing is used for them.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from gear_exact import Exact, NoSuchGear, Tooth, acos, atan2, cos, involute, involute_angle, pi, sin, sqrt

GRID, ALONG = 420, 150
# Closest together where the flank begins: there the root may bend most.
SHARES = 1.0 - np.linspace(1.0, 0.0, ALONG) ** 3
H = Exact(2) ** -60


class Mesh:
    """Two gears at a distance; the closed results by name."""

    def __init__(self, first: Tooth, second: Tooth, distance: float | None) -> None:
        self.first, self.second = first, second
        self.way = -1 if second.internal else 1
        bases = abs(first.rb + self.way * second.rb)
        total = first.z + self.way * second.z
        # solid halves of both and one pitch: on the working circles thicknesses fill a pitch
        tight = (first.z * first.solid + self.way * second.z * second.solid - (pi() if self.way > 0 else 0)) / total
        if distance is None:
            if tight < 0:
                raise NoSuchGear
            self.angle = involute_angle(tight)
            self.a = bases / cos(self.angle)
        else:
            self.a = Exact(distance)
            if self.a <= bases:
                raise NoSuchGear
            self.angle = acos(bases / self.a)
        self.backlash = Exact(0) if distance is None else 2 * bases * self.way * (involute(self.angle) - tight)
        self._path()

    def _path(self) -> None:
        one, two = self.first, self.second
        self.total = self.a * sin(self.angle)
        if two.internal:
            self.tip_start, form_end = two.length(two.tip) - self.total, two.length(two.form) - self.total
        else:
            self.tip_start, form_end = self.total - two.length(two.tip), self.total - two.length(two.form)
        self.tip_end, form_start = one.length(one.tip), one.length(one.form)
        self.start, self.end = max(self.tip_start, form_start), min(self.tip_end, form_end)
        if self.end <= self.start:
            raise NoSuchGear
        # how far from these being equal: a hair decides which the program takes
        self.ties = min(abs(self.tip_start - form_start), abs(self.tip_end - form_end)) / one.m

    def closed(self) -> dict[str, Any]:
        """What the lengths along the line of action say."""
        one, two, a = self.first, self.second, self.a
        pitch = 2 * pi() * one.rb / one.z
        return {
            "centre_distance": a,
            "working_pressure_angle": self.angle,
            "contact_ratio": (self.end - self.start) / pitch,
            "nominal_contact_ratio": (self.tip_end - self.tip_start) / pitch,
            "backlash": self.backlash,
            "first_tip_clearance": two.root - a - one.tip if two.internal else a - one.tip - two.root,
            "second_tip_clearance": two.tip - a - one.root if two.internal else a - two.tip - one.root,
            "transmission_error": Exact(0),
        }

    def point(self, share: Any) -> dict[str, Any]:
        """A point of contact at a share of the path."""
        one, two = self.first, self.second
        own = self.start + (self.end - self.start) * share
        other = own + self.total if two.internal else self.total - own
        return {
            "along": own - one.rb * sin(self.angle) / cos(self.angle),
            "first_diameter": 2 * sqrt(one.rb * one.rb + own * own),
            "second_diameter": 2 * sqrt(two.rb * two.rb + other * other),
            "error": Exact(0),
        }

    def gaps(self) -> dict[str, Any]:
        """The least distances of each gear's teeth from the other's root, where the tips get below the form circle."""
        touch = min(self.backlash / 2, Exact(0))
        play = max(self.backlash, Exact(0)) / (2 * self.second.rb)
        clear = self.closed()
        out: dict[str, Any] = {}
        for name, one, two, turned, clipped, tips in (
            ("first_in_second", self.first, self.second, play, self.end < self.tip_end, clear["first_tip_clearance"]),
            (
                "second_in_first", self.second, self.first, play * self.second.z / self.first.z,
                self.start > self.tip_start, clear["second_tip_clearance"],
            ),
        ):  # fmt: skip
            deepest = self.a + one.tip if two.internal else abs(self.a - one.tip)
            if (deepest < two.form) if two.internal else (deepest > two.form):
                continue
            found = [tips] + ([touch] if clipped else []) + _edge_distances(one, two, self.a, turned)
            out[name] = min(found)
        return out


class _Root:
    """The root of a space in its frame, by a parameter from the root circle (0) to the flank (1)."""

    def __init__(self, tooth: Tooth) -> None:
        self.tooth = tooth
        if tooth.internal:
            centre = tooth.root - tooth.fillet
            self.centre = centre * cos(tooth.fillet_half), centre * sin(tooth.fillet_half)
            reach = tooth.length(centre)
            self.span = tooth.fillet_half, tooth.fillet_half + atan2(tooth.rb, reach)
            angle = tooth.half(tooth.form)
        else:
            self.span = pi() / 2, tooth.alpha if tooth.corner is None else tooth.corner
            angle = pi() / tooth.z - tooth.half(tooth.form)
        self.end = tooth.form * cos(angle), tooth.form * sin(angle)

    def at(self, share: Any) -> tuple[Any, Any, Any, Any]:
        t = self.span[0] + (self.span[1] - self.span[0]) * share
        tooth = self.tooth
        if not tooth.internal:
            return tooth.rolled(t)
        c, s = cos(t), sin(t)
        return self.centre[0] + tooth.fillet * c, self.centre[1] + tooth.fillet * s, -c, -s


def _edge(one: Tooth, two: Tooth, a: Any, play: Any, half: Any, turn: Any, side: int) -> tuple[Any, Any]:
    """The edge of a tooth of `one` in the frame of the space of `two`."""
    angle = turn + side * half
    x, y = one.tip * cos(angle), one.tip * sin(angle)
    inside = one.internal or two.internal
    x, y = (x - a, y) if one.internal else (x + a, y) if two.internal else (a - x, -y)
    back = (turn if inside else -turn) * one.z / two.z + play
    c, s = cos(back), sin(back)
    return x * c + y * s, y * c - x * s


def _edge_distances(one: Tooth, two: Tooth, a: Any, play: Any) -> list[Any]:
    """The least signed distances of both edges from the root and from where the flank begins."""
    root = _Root(two)
    curve = np.array([[float(v) for v in root.at(Exact(float(share)))] for share in SHARES]).T
    out: list[Any] = []
    # without backlash one side is the mirror image of the other
    for side in (-1, 1) if play else (1,):
        turns, x, y = _doubles(one, two, a, play, side)
        out += _of_edge(one, two, a, play, side, root, curve, turns, x, y)
    return out


def _doubles(one: Tooth, two: Tooth, a: Any, play: Any, side: int) -> tuple[Any, Any, Any]:
    """The edge's path on a grid of doubles, where it is among the other gear's teeth."""
    d, tip, other, slack = float(a), float(one.tip), float(two.form), float(two.m)
    edge = max(other - slack, float(two.tip)) if two.internal else min(other + slack, float(two.tip))
    cosine = (edge**2 - tip**2 - d**2) if two.internal else (tip**2 + d**2 - edge**2)
    polar = float(np.arccos(np.clip(cosine / (2 * tip * d), -1.0, 1.0)))
    half = float(one.half(one.tip))
    half = np.pi / one.z - half if one.internal else half
    turns = np.linspace(-polar - half, polar + half, GRID)
    angle = turns + side * half
    z = tip * np.exp(1j * angle)
    z = z - d if one.internal else z + d if two.internal else d - z
    inside = one.internal or two.internal
    z = z * np.exp(-1j * ((turns if inside else -turns) * one.z / two.z + float(play)))
    away = abs(z)
    keep = away > float(two.tip) if two.internal else away < float(two.tip)
    return turns[keep], z.real[keep], z.imag[keep]


def _of_edge(
    one: Tooth, two: Tooth, a: Any, play: Any, side: int, root: _Root, curve: Any, turns: Any, x: Any, y: Any
) -> list[Any]:
    if len(turns) < 3:
        return []
    gap, place = _from_chords(curve, x, abs(y))
    best = [i for i in range(1, len(gap) - 1) if gap[i] <= gap[i - 1] and gap[i] <= gap[i + 1] and gap[i] < np.inf]
    out: list[Any] = []
    half = one.half(one.tip)
    half = pi() / one.z - half if one.internal else half
    for row in sorted(best, key=lambda i: gap[i])[:2]:
        mirror = 1 if y[row] >= 0 else -1
        start = Exact(float(turns[row]))
        step = Exact(float(turns[1] - turns[0]))

        def edge(turn: Any, mirror: int = mirror) -> tuple[Any, Any]:
            ex, ey = _edge(one, two, a, play, half, turn, side)
            return ex, mirror * ey

        # from there, or half a step on or back, where it lies between the last places before the flank
        for turn, share in _starts(turns, place, row):
            inside = _interior(root, edge, (turn, share), step)
            if inside:
                break
        out += inside + _at_end(root, edge, start, step)
    return out


def _starts(turns: Any, place: Any, row: int) -> Iterator[tuple[Any, Any]]:
    """The angle and share of a grid's place, and of those half way to its neighbours."""
    shares = np.interp(place, np.arange(ALONG), SHARES)
    for other in (row, row + 1, row - 1):
        if 0 <= other < len(turns):
            yield Exact(float(turns[row] + turns[other]) / 2), Exact(float(shares[row] + shares[other]) / 2)


def _from_chords(curve: Any, x: Any, y: Any) -> tuple[Any, Any]:
    """Signed distances of points from the chords of a curve, and where along it; none past its end in the flank."""
    cx, cy, nx, ny = curve
    ux, uy = np.diff(cx), np.diff(cy)
    dx, dy = x[:, None] - cx[:-1], y[:, None] - cy[:-1]
    share = np.clip((dx * ux + dy * uy) / (ux * ux + uy * uy), 0.0, 1.0)
    dx, dy = dx - share * ux, dy - share * uy
    chord = np.hypot(dx, dy).argmin(axis=1)
    rows = np.arange(len(x))
    dx, dy, share = dx[rows, chord], dy[rows, chord], share[rows, chord]
    sign = np.where(dx * nx[chord] + dy * ny[chord] < 0.0, -1.0, 1.0)
    past = (chord == ALONG - 2) & (share == 1.0) & (sign < 0.0)
    return np.where(past, np.inf, sign * np.hypot(dx, dy)), chord + share


def _slopes(function: Any, at: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """A point of a curve with its first and second derivatives, by differences good to 120 bits."""
    x, y = function(at)
    a, b = function(at + H)
    c, d = function(at - H)
    return x, y, (a - c) / (2 * H), (b - d) / (2 * H), (a - 2 * x + c) / (H * H), (b - 2 * y + d) / (H * H)


def _interior(root: _Root, edge: Any, start: tuple[Any, Any], step: Any) -> list[Any]:
    """The signed distance where the edge moves along the root and is nearest to it, by Newton's method."""
    turn, share = start
    for _ in range(60):
        x, y, u, v, ux, vy = _slopes(edge, turn)
        px, py, pu, pv, pux, pvy = _slopes(lambda at: root.at(at)[:2], share)
        dx, dy = x - px, y - py
        f, g = u * pv - v * pu, dx * pu + dy * pv
        a, b = ux * pv - vy * pu, u * pvy - v * pux
        c, d = u * pu + v * pv, dx * pux + dy * pvy - pu * pu - pv * pv
        slope = a * d - b * c
        if slope == 0:
            return []
        du, dv = (f * d - g * b) / slope, (g * a - f * c) / slope
        cut = max(abs(du) / step, abs(dv) * (ALONG / 2), Exact(1))
        turn, share = turn - du / cut, share - dv / cut
        if max(abs(du), abs(dv)) < Exact(2) ** -90:
            break
    else:
        return []
    if not 0 <= share <= 1 or abs(turn - start[0]) > 5 * step:
        return []
    ex, ey = edge(turn)
    px, py, nx, ny = root.at(share)
    return [(ex - px) * nx + (ey - py) * ny]


def _at_end(root: _Root, edge: Any, turn: Any, step: Any) -> list[Any]:
    """The distance from where the flank begins, where its square has no slope."""
    start = turn

    for _ in range(60):
        x, y, u, v, ux, vy = _slopes(edge, turn)
        dx, dy = x - root.end[0], y - root.end[1]
        move = (dx * u + dy * v) / (u * u + v * v + dx * ux + dy * vy)
        turn -= max(min(move, step), -step)
        if abs(move) < Exact(2) ** -90:
            break
    else:
        return []
    ex, ey = edge(turn)
    _, _, nx, ny = root.at(Exact(1))
    inside = (ex - root.end[0]) * nx + (ey - root.end[1]) * ny <= 0
    if inside or abs(turn - start) > 5 * step:
        return []
    return [sqrt((ex - root.end[0]) ** 2 + (ey - root.end[1]) ** 2)]


def least_count(points: int, shown: int) -> list[int]:
    """Which of the points are shown: evenly spread, first and last among them."""
    return sorted({int(i) for i in np.linspace(0, points - 1, max(2, min(shown, points)))})


def shares(points: int, shown: int) -> list[Any]:
    """The shares of the path at which they stand."""
    return [Exact(i) / (points - 1) for i in least_count(points, shown)]
