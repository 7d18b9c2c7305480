"""The envelope of a follower as one curve of smooth parts: where it runs forwards, and its arcs of small curvature.

A part is a zone of the motion, or the bridge cut by one position of the follower where its velocity jumps: an arc
of the roller or a length of the flat face. A place of the curve is a part and a share of it; as one number, their sum.
"""

import numpy as np

from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.program.pieces import Cover, within
from dynamics_cli.numerics.chebyshev.proxies import extremes
from dynamics_cli.numerics.roots import halved
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# A step of the velocity below this share of its peak is rounding.
JUMP = 1e-9
# Arcs are halved until the curve turns by less than this on each, the range in which the sampled turning is trusted.
BEND = 0.35
MARGIN = 1.25
SAMPLES = 7
DEPTH = 60


@record
class Bridge:
    """The part of the cam cut by one position of the follower where its velocity jumps."""

    angle: Annotated[float, "Cam angle [rad]."]
    first: Annotated[complex, "Its ends in the cam's frame [m]."]
    last: Annotated[complex, "Its ends in the cam's frame [m]."]
    centre: Annotated[complex, "Centre of the roller there [m]."]
    turning: Annotated[float, "Angle by which it goes round the roller, zero for a face [rad]."]
    run: Annotated[float, "How far it runs, negative backwards [m]."]


@record
class Arc:
    """A forward arc: its part, the shares at its ends, its end points, its turning, and where its tangents point."""

    part: Annotated[int, "The part it lies in."]
    low: Annotated[float, "Shares of the part."]
    high: Annotated[float, "Shares of the part."]
    first: Annotated[complex, "Its ends [m]."]
    last: Annotated[complex, "Its ends [m]."]
    bend: Annotated[float, "Bound of the angle that the tangent turns through [rad]."]

    @property
    def start(self) -> float:
        """Where it starts along the curve."""
        return self.part + self.low

    @property
    def end(self) -> float:
        """Where it ends along the curve."""
        return self.part + self.high


class Envelope:
    """The curve that a follower leaves of a cam, in the cam's frame, as complex numbers.

    `motion`: the program.
    """

    def __init__(self, geometry: Geometry, motion: "Any") -> None:
        self.geometry = geometry
        self.motion = motion
        self.sense = geometry.turn * geometry.side
        self.parts: list[int | Bridge] = []
        bridges = _bridges(geometry, motion)
        for index in range(len(motion.zones)):
            if index in bridges:
                self.parts.append(bridges[index])
            self.parts.append(index)
        self.zone_part = [number for number, part in enumerate(self.parts) if not isinstance(part, Bridge)]

    def angle(self, part: int, share: "Any") -> "Any":
        """Cam angle at a share of a part."""
        piece = self.parts[part]
        if isinstance(piece, Bridge):
            return piece.angle + 0.0 * share
        zone = self.motion.zones[piece]
        return zone.start + (zone.end - zone.start) * share

    def angle_at(self, place: float) -> float:
        """Cam angle at a place of the curve."""
        part = min(int(place), len(self.parts) - 1)
        return float(self.angle(part, place - part))

    def at(self, part: int, share: "Any") -> "tuple[Any, Any]":
        """Points and velocities, by the share, at an array of shares of one part."""
        piece = self.parts[part]
        if isinstance(piece, Bridge):
            if not piece.turning:
                return piece.first + share * (piece.last - piece.first), (piece.last - piece.first) + 0.0 * share
            arm = (piece.first - piece.centre) * np.exp(1j * piece.turning * share)
            return piece.centre + arm, 1j * piece.turning * arm
        zone = self.motion.zones[piece]
        s, s1, s2 = self.motion.in_zone(piece, share, 2)
        point, normal, run = self._turned((s, s1, s2), self.angle(part, share))
        return point, (zone.end - zone.start) * self.geometry.turn * run * (-1j) * normal

    def way(self, part: int, share: float) -> complex:
        """The direction in which the curve runs forwards."""
        piece = self.parts[part]
        if isinstance(piece, Bridge):
            velocity = self.at(part, np.array([share]))[1]
            return complex(velocity[0] / abs(velocity[0]))
        state = self.motion.in_zone(piece, np.array([share]), 2)
        return -1j * self.geometry.turn * complex(self._turned(state, self.angle(part, share))[1][0])

    def _turned(self, state: "tuple[Any, ...]", theta: "Any") -> "tuple[Any, Any, Any]":
        s, s1, s2 = state
        touch = self.geometry.touch(s, s1, s2)
        back = np.exp(-1j * self.geometry.turn * theta)
        (x, y), (nx, ny) = touch.point, touch.normal
        return (x + 1j * y) * back, (nx + 1j * ny) * back, touch.run

    def backward(self, *, forward: bool = False) -> "list[tuple[float, float]]":
        """Places between which the curve runs backwards or stands, from every turning place of its speed.

        `forward`: whether it is known to run forwards within every zone: only bridges may run backwards then. Returns
        the stretches in order.

        Speeds that are zero within their error take their sign as computed.
        """
        if not self.geometry.flat and self.geometry.roller == 0.0:
            return []
        stretches: list[tuple[float, float]] = []
        speed = None if forward else self._speed()
        if speed is not None and extremes(speed).smallest()[0] <= 0.0:
            every = extremes(speed, every=True)
            for zone, part in enumerate(self.zone_part):
                in_zone = np.flatnonzero(every.owner == zone)
                # a dwell on the axis is a point within its error, and loses nothing
                if np.abs(every.values[in_zone]).max() > every.error:
                    stretches += self._backward(part, zone, every.places[in_zone], every.values[in_zone])
        for number, piece in enumerate(self.parts):
            if isinstance(piece, Bridge) and piece.run < 0.0:
                stretches.append((float(number), number + 1.0))
        return _joined(sorted((float(low), float(high)) for low, high in stretches if high > low))

    def _speed(self) -> "Any":
        return Cover(self.motion, lambda s, s1, s2: self.geometry.touch(s, s1, s2).run[None], 2).proxies

    def _backward(self, part: int, zone: int, places: "Any", values: "Any") -> "list[tuple[float, float]]":
        """Backward stretches of one zone, the speed being monotone from each of the places to the next."""
        stretches = []
        inside = None
        for index in range(places.size):
            back = values[index] <= 0.0
            if back and inside is None:
                inside = self._zero(zone, places[index], places[index - 1]) if index else 0.0
            elif not back and inside is not None:
                stretches.append((part + inside, part + self._zero(zone, places[index - 1], places[index])))
                inside = None
        if inside is not None:
            stretches.append((part + inside, part + 1.0))
        return stretches

    def _zero(self, zone: int, bad: float, good: float) -> float:
        """Where the speed passes zero, by bisection."""

        def backward(place: float) -> bool:
            return not self.geometry.touch(*self.motion.in_zone(zone, np.array([place]), 2)).run[0] > 0.0

        return halved(backward, bad, good)[0]

    def forward(self, backward: "list[tuple[float, float]]") -> "list[Arc]":
        """Arcs of the forward parts in order, each bending little.

        `backward`: the result of `backward`.
        """
        arcs: list[Arc] = []
        zones: list[tuple[int, float, float]] = []
        for part, low, high in self._stretches(backward):
            piece = self.parts[part]
            if isinstance(piece, Bridge):
                arcs += self._bridged(part, piece)
                continue
            width = (high - low) * (self.motion.zones[piece].end - self.motion.zones[piece].start)
            cuts = np.linspace(low, high, int(np.ceil(width / BEND)) + 1 or 2)
            zones += [(part, cuts[k], cuts[k + 1]) for k in range(cuts.size - 1)]
        return sorted(arcs + self._bent(zones), key=lambda arc: arc.start)

    def _stretches(self, backward: "list[tuple[float, float]]") -> "list[tuple[int, float, float]]":
        """The rest of every part between the backward stretches."""
        stretches = []
        for part in range(len(self.parts)):
            low = 0.0
            for start, end in [(a - part, b - part) for a, b in backward if b > part and a < part + 1]:
                if start > low:
                    stretches.append((part, low, start))
                low = max(low, end)
            if low < 1.0:
                stretches.append((part, low, 1.0))
        return stretches

    def _bridged(self, part: int, bridge: Bridge) -> "list[Arc]":
        count = max(int(np.ceil(abs(bridge.turning) / BEND)), 1)
        cuts = np.linspace(0.0, 1.0, count + 1)
        points, bend = self.at(part, cuts)[0], abs(bridge.turning) / count
        return [
            Arc(part, float(cuts[k]), float(cuts[k + 1]), complex(points[k]), complex(points[k + 1]), bend)
            for k in range(count)
        ]

    def _bent(self, stretches: "list[tuple[int, float, float]]") -> "list[Arc]":
        """Stretches of zones, halved until each arc bends little."""
        part = np.array([row[0] for row in stretches], dtype=int)
        starts, ends = (np.array([row[index] for row in stretches], dtype=float) for index in (1, 2))
        share = np.linspace(0.0, 1.0, SAMPLES)
        arcs: list[Arc] = []
        for level in range(DEPTH):
            if not part.size:
                break
            place = starts[:, None] + (ends - starts)[:, None] * share
            zone = np.array([self.parts[index] for index in part.tolist()])
            low = np.array([self.motion.zones[index].start for index in zone.tolist()])
            wide = np.array([self.motion.zones[index].end for index in zone.tolist()]) - low
            theta = low[:, None] + wide[:, None] * place
            point, normal, _ = self._turned(within(self.motion, place, zone), theta)
            bend = MARGIN * np.abs(np.angle(normal[:, 1:] * normal[:, :-1].conj())).sum(axis=1)
            good = (bend <= BEND) | (level == DEPTH - 1)
            rows = np.flatnonzero(good).tolist()
            first, last = point[:, 0].tolist(), point[:, -1].tolist()
            arcs += [
                Arc(int(part[k]), float(starts[k]), float(ends[k]), first[k], last[k], float(bend[k])) for k in rows
            ]
            a, b = starts[~good], ends[~good]
            starts, ends = np.concatenate((a, 0.5 * (a + b))), np.concatenate((0.5 * (a + b), b))
            part = np.concatenate((part[~good], part[~good]))
        return arcs


def _joined(stretches: "list[tuple[float, float]]") -> "list[tuple[float, float]]":
    """Stretches that meet, as one."""
    joined: list[tuple[float, float]] = []
    for low, high in stretches:
        if joined and low <= joined[-1][1]:
            joined[-1] = (joined[-1][0], max(joined[-1][1], high))
        else:
            joined.append((low, high))
    return joined


def _bridges(geometry: Geometry, motion: "Any") -> "dict[int, Bridge]":
    """The bridge before each zone at whose start the velocity jumps."""
    count = len(motion.zones)
    ends = [
        [np.atleast_1d(value) for value in motion.in_zone(index, t, 2)] for index in range(count) for t in (0.0, 1.0)
    ]
    peak = max(abs(float(state[1][0])) for state in ends)
    bridges = {}
    for index in range(count):
        before, after = ends[2 * index - 1], ends[2 * index]
        if abs(float(after[1][0] - before[1][0])) <= JUMP * peak:
            continue
        theta = motion.zones[index].start
        sides = [geometry.touch(*state) for state in (before, after)]
        back = complex(np.exp(-1j * geometry.turn * theta))
        first, last = (complex(side.point[0][0], side.point[1][0]) * back for side in sides)
        from_, to = (complex(side.normal[0][0], side.normal[1][0]) for side in sides)
        turning = float(np.angle(to / from_))
        if geometry.flat:
            turning = 0.0
            run = ((last - first) / (-1j * geometry.turn * from_ * back)).real
        else:
            run = geometry.turn * geometry.side * geometry.roller * turning
        x, y = (float(np.atleast_1d(value)[0]) for value in sides[0].centre)
        bridges[index] = Bridge(theta, first, last, complex(x, y) * back, turning, run)
    return bridges
