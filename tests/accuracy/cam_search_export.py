"""Written curves of `cam export` beside the exact curve, for the search: the distance of one from the other, both ways.

A place of an arc, a cubic or a line is computed in 240 bits from the doubles that are written; its distance from the
curve is taken along the curve's normal at the foot of the perpendicular. Where to look is found in doubles; what is off
along the tangent there adds only its square.
"""

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np
from cam_search_compared import Compared, Stated, nearest, table_angles
from cam_search_contact import Carried, Looking
from cam_search_motion import Turn, Zone, sine_cosine
from cam_search_tables import NOTHING, follower_of
from precise import FUNCTIONS, Exact

from dynamics_cli.cam.export.export import export
from dynamics_cli.cam.export.records import Curve, Form
from dynamics_cli.cam.geometry.followers import Flank, Rotation
from dynamics_cli.outlines import Arc, Cubic

SAMPLES = 121
PLACES = np.linspace(0.0, 1.0, 9)
Pair = tuple[Any, Any]


class Outline:
    """The exact curve: contact, moved along the normal, turned into the cam."""

    def __init__(self, turn: Turn, carried: Carried, away: float, start: float) -> None:
        self.turn, self.carried, self.away, self.start = turn, carried, away, start
        self.zones = [zone for zone in turn.zones if float(zone.end - zone.start) > 0.0]

    def at(self, zone: Zone, theta: Any) -> tuple[Pair, Pair]:
        """Point and normal at an exact angle."""
        touch = self.carried.touch(*zone.at(theta, 2))
        away, start = Exact(self.away), Exact(self.start)
        point = tuple(a + away * b for a, b in zip(touch["point"], touch["normal"], strict=True))
        return self.carried.turned(point, theta, start), self.carried.turned(touch["normal"], theta, start)

    def over(self, zone: Zone, share: Any) -> tuple[Any, Any]:
        """Points as complex numbers and normals in doubles."""
        touch = self.carried.touch(*zone.over(share, 2))
        low, high = float(zone.start), float(zone.end)
        sin, cos = sine_cosine(self.start - self.carried.turn * (low + (high - low) * share))
        turned = cos + 1j * sin
        normal = touch["normal"][0] + 1j * touch["normal"][1]
        point = touch["point"][0] + 1j * touch["point"][1] + self.away * normal
        return point * turned, normal * turned

    def feet(self, points: Any) -> list[tuple[Zone, float, float]]:
        """Zone, share and rough distance of the curve's nearest place to each point."""
        samples = SAMPLES * Looking.steps
        shares = np.linspace(0.0, 1.0, samples)
        curve = np.concatenate([self.over(zone, shares)[0] for zone in self.zones])
        near = np.array([int(np.argmin(np.abs(curve - point))) for point in points])
        found: list[Any] = [None] * len(points)
        for index in range(len(self.zones)):
            which = np.flatnonzero(near // samples == index)
            if which.size:
                self._settle(found, points, which, index, shares[near[which] % samples])
        # the foot of a place beside a joint may be in the zone on its other side
        for end, way, first in ((0.0, -1, 1.0), (1.0, 1, 0.0)):
            for i in [i for i, (_, share, _) in enumerate(found) if share == end]:
                held = found[i]
                other = (self.zones.index(held[0]) + way) % len(self.zones)
                self._settle(found, points, np.array([i]), other, np.array([first]))
                if found[i][1] == first:
                    found[i] = held
        return found

    def _settle(self, found: list[Any], points: Any, which: Any, index: int, share: Any) -> None:
        """Feet of some points in one zone, from shares to start at."""
        zone = self.zones[index]
        for _ in range(6 * min(Looking.steps, 4)):
            then = self._stepped(zone, share, points[which])
            near, far = (np.abs(points[which] - self.over(zone, one)[0]) for one in (share, then))
            # no step goes away from the place: a tight bend may have other feet
            share = np.where(far <= near, then, 0.5 * (share + then))
        q, normal = self.over(zone, share)
        apart = np.abs(((points[which] - q) * normal.conj()).real)
        for i, x, distance in zip(which.tolist(), share.tolist(), apart.tolist(), strict=True):
            found[i] = (zone, x, distance)

    def _stepped(self, zone: Zone, share: Any, points: Any) -> Any:
        """One secant step along the tangent towards the foot of the perpendicular."""
        step = 1e-6
        inner = np.clip(share, step, 1.0 - step)
        before, after = (self.over(zone, inner + way * step)[0] for way in (-1.0, 1.0))
        run = (after - before) / (2.0 * step)
        q, _ = self.over(zone, share)
        along = ((points - q) * run.conj()).real / np.maximum(np.abs(run) ** 2, 1e-300)
        return np.clip(share + along, 0.0, 1.0)


def on_piece(piece: Any, t: Any) -> tuple[Any, Any]:
    """A point of a written piece at a share of it, of reals or an array: an arc as a rational quadratic."""
    u = 1 - t
    kind = Exact if not hasattr(t, "shape") else float
    (x0, y0), (x3, y3) = (tuple(map(kind, end)) for end in (piece.start, piece.end))
    if isinstance(piece, Cubic):
        (x1, y1), (x2, y2) = (tuple(map(kind, point)) for point in (piece.control1, piece.control2))
        weights = (u * u * u, 3 * u * u * t, 3 * u * t * t, t * t * t)
        return (
            weights[0] * x0 + weights[1] * x1 + weights[2] * x2 + weights[3] * x3,
            weights[0] * y0 + weights[1] * y1 + weights[2] * y2 + weights[3] * y3,
        )
    bulge = kind(piece.bulge)
    square = 1 + bulge * bulge
    # cosine of half the angle, and half the chord's share that the middle control stands off, times that cosine
    cosine, stand = (1 - bulge * bulge) / square, bulge / square
    mx, my = cosine * (x0 + x3) / 2 + stand * (y3 - y0), cosine * (y0 + y3) / 2 - stand * (x3 - x0)
    whole = u * u + 2 * cosine * u * t + t * t
    return (u * u * x0 + 2 * u * t * mx + t * t * x3) / whole, (u * u * y0 + 2 * u * t * my + t * t * y3) / whole


def pieces_of(outline: Any) -> list[Any]:
    """Arcs and cubics as they are written, lines as arcs without a bulge."""
    found: list[Any] = []
    for piece in outline.pieces:
        points = getattr(piece, "points", None)
        found += [piece] if points is None else [Arc(a, b, 0.0) for a, b in pairwise(points)]
    return found


def exporting(case: dict[str, Any]) -> Iterator[Compared]:
    """`cam export`: the worst of nine places of each written piece, and of the curve between, and the tables."""
    tool, start = float(case.get("cutter_radius", 0.0)), float(case.get("start_angle", 0.0))
    answer = export(
        NOTHING, program=case["program"], follower=follower_of(case["follower"]),
        rotation=Rotation(case.get("rotation", "ccw")), flank=Flank(case.get("flank", "inner")),
        form=Form(case["form"]), curve=Curve(case.get("curve", "cam")), cutter_radius=tool or None,
        tolerance=float(case["tolerance"]), points=case["points"], start_angle=start,
    )  # fmt: skip
    turn, stated = Turn(case["program"]), Stated(answer)
    carried = Carried(case["follower"], case.get("rotation", ""), case.get("flank", "inner"))
    away = {"cam": 0.0, "pitch": carried.side * float(carried.roller), "cutter": carried.side * tool}
    curve = Outline(turn, carried, away[case.get("curve", "cam")], start)
    deviation, most = answer.deviation, Exact(0)
    for name, exact in _distances(curve, pieces_of(answer.shape.outlines[0])):
        most = max(most, exact)
        yield Compared(name, 0.0, deviation, exact, deviation, False, name)
    # what is stated is the deviation itself: it is as loose as it exceeds the largest distance found
    yield Compared("deviation", 0.0, deviation, most, 0.0, True, "deviation")
    yield from _rows(answer, curve, stated)


def _distances(curve: Outline, pieces: list[Any]) -> Iterator[tuple[str, Any]]:
    """Each piece's worst of a few places from the curve, and the curve's own places from the pieces."""
    places = np.array([np.add(*(part * unit for part, unit in zip(on_piece(piece, PLACES), (1.0, 1j), strict=True)))
                       for piece in pieces])  # fmt: skip
    feet = curve.feet(places.ravel())
    for index, piece in enumerate(pieces):
        own = feet[index * PLACES.size : (index + 1) * PLACES.size]
        worst = max(range(PLACES.size), key=lambda i: own[i][2])
        zone, share, _ = own[worst]
        yield f"pieces[{index}]", _apart(curve, zone, share, on_piece(piece, Exact(float(PLACES[worst]))))
    yield from _back(curve, pieces, places)


def _apart(curve: Outline, zone: Zone, share: float, place: Pair) -> Any:
    """The distance of a place from the curve along its normal at a foot; from the end where that is the nearest."""
    theta = zone.start + (zone.end - zone.start) * Exact(share)
    (x, y), (nx, ny) = curve.at(zone, theta)
    x, y = place[0] - x, place[1] - y
    across, along = x * nx + y * ny, x * ny - y * nx
    # at the end of a zone the next one goes on in the same direction: what is along it counts only if it is large
    far = abs(along) > Exact(2) ** -20 * abs(across) and abs(along) > Exact(1e-13) * (abs(place[0]) + abs(place[1]))
    return FUNCTIONS["sqrt"](across * across + along * along) if far else abs(across)


def _back(curve: Outline, pieces: list[Any], places: Any) -> Iterator[tuple[str, Any]]:
    """Places of the exact curve, and the nearest place of the written pieces."""
    fine = np.linspace(0.0, 1.0, 64 * min(Looking.steps, 16) + 1)
    few = 6 if Looking.steps == 1 else 40
    for number, zone in enumerate(curve.zones):
        for share in (0.0, 0.1234, 0.31, 0.5, 0.77):
            theta = zone.start + (zone.end - zone.start) * Exact(share)
            place, _ = curve.at(zone, theta)
            rough = complex(float(place[0]), float(place[1]))
            best = (np.inf, 0, 0.0)
            for index in np.argsort(np.abs(places - rough).min(axis=1))[:few].tolist():
                x, y = on_piece(pieces[index], fine)
                apart = np.abs(x + 1j * y - rough)
                at = int(np.argmin(apart))
                best = min(best, (float(apart[at]), index, float(fine[at])))
            yield f"curve[{number * 8 + int(share * 8)}]", _from_piece(pieces, best[1], best[2], place)


def _from_piece(pieces: list[Any], index: int, t: float, place: Pair) -> Any:
    """The distance of a place from a piece near a share of it, or from the piece that goes on there."""
    best = None
    for own, first in ((pieces[index], t), (pieces[index - 1], 1.0), (pieces[(index + 1) % len(pieces)], 0.0)):
        at = Exact(first)
        for _ in range(40):
            step = Exact(2) ** -60
            inner = min(max(at, step), 1 - step)
            (x, y), (u, v), (x1, y1) = (on_piece(own, one) for one in (at, inner - step, inner + step))
            runx, runy = (x1 - u) / (2 * step), (y1 - v) / (2 * step)
            move = ((place[0] - x) * runx + (place[1] - y) * runy) / (runx * runx + runy * runy)
            then = min(max(at + move, Exact(0)), Exact(1))
            if abs(then - at) < Exact(2) ** -70:
                break
            at = then
        x, y = on_piece(own, at)
        apart = FUNCTIONS["sqrt"]((place[0] - x) ** 2 + (place[1] - y) ** 2)
        best = apart if best is None else min(best, apart)
    return best


def _rows(answer: Any, curve: Outline, stated: Stated) -> Iterator[Compared]:
    """The polar table and the controller's table."""
    arrays = answer.points.arrays
    count = len(arrays["x"])
    size = float(arrays["radius"].max()) + sum(
        value for key, value in curve.carried.sizes.items() if key not in ("arm_angle", "offset")
    )
    for index, theta in enumerate(arrays["cam_angle"].tolist()):
        rows = []
        for zone, at, angle in table_angles(curve.turn, index, count, theta):
            touch = curve.carried.touch(*zone.at(at, 2))
            away = Exact(curve.away)
            point = tuple(a + away * b for a, b in zip(touch["point"], touch["normal"], strict=True))
            rows.append(curve.carried.turned(point, angle, Exact(curve.start)))
        row = f"points[{index}]"
        for which, name in enumerate("xy"):
            value = float(arrays[name][index])
            exact = nearest([one[which] for one in rows], value)
            yield from stated.compare(f"{row}.{name}", value, exact, 1e-14 * size, size=size, row=row)
    words = "swings" if curve.turn.swing else "lifts"
    table = getattr(answer, words).arrays
    for index, theta in enumerate(table["cam_angle"].tolist()):
        states = [zone.at(at, 2) for zone, at, _ in table_angles(curve.turn, index, count, theta)]
        names = (("swing" if curve.turn.swing else "lift"), "velocity", "acceleration")
        for order, name in enumerate(names):
            value = float(table[name][index])
            wide = float(np.abs(table[name]).max())
            exact = nearest([state[order] for state in states], value)
            yield from stated.compare(f"{words}[{index}].{name}", value, exact, 1e-9 * wide, size=wide,
                                      row=f"{words}[{index}]")  # fmt: skip
