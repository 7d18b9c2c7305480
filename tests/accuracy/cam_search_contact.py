"""Where cam and follower touch, for the search: the follower carried round the cam, and extremes of what follows.

With z the roller's centre in the fixed frame, c = z e^(−iτθ) is its way round the cam: the normal is iτc′/|c′| and the
curvature −τ Im(c̄′c″)/|c′|³. A flat face is a line at the distance h along its normal; by the angle α of the normal the
point of contact is n(h + ih_α) and the radius of curvature h + h_αα. Every formula takes jets, reals or arrays.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from cam_search_motion import Turn, Zone, arc_tangent, as_jet, sine_cosine, sqrt
from precise import FUNCTIONS, Exact, exact_pi

State = tuple[Any, Any, Any]
Quantity = Callable[[Any, Any, Any], Any]
FLATS = ("FlatFace", "OscillatingFlat")
SWINGING = ("OscillatingRoller", "OscillatingFlat", "ConjugateOscillatingRoller")


def times(a: Any, b: Any) -> tuple[Any, Any]:
    """The product of two complex numbers, as pairs."""
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


class Carried:
    """A follower carried round the cam."""

    def __init__(self, follower: dict[str, Any], rotation: str, flank: str = "inner") -> None:
        self.kind = follower["record"]
        self.f = {key: Exact(float(value)) for key, value in follower.items() if key != "record"}
        self.turn = -1 if rotation == "clockwise" else 1
        self.side = -1 if flank == "outer" else 1
        self.flat, self.swing = self.kind in FLATS, self.kind in SWINGING
        self.roller = self.f.get("roller_radius", Exact(0))
        self.mate = self.kind.startswith("Conjugate")
        self.restart()

    def restart(self) -> None:
        """Place the follower anew where one of its sizes has been changed."""
        self.start = self._start()
        self.sizes = {key: float(value) for key, value in self.f.items()}
        self.rough = float(self.start)

    def _start(self) -> Any:
        f, prime = self.f, self.f["base_radius"] + self.roller
        if self.kind == "FlatFace":
            return prime
        if self.kind == "OscillatingFlat":
            return FUNCTIONS["asin"]((f["base_radius"] + f.get("face_offset", 0)) / f["pivot_distance"])
        if not self.swing:
            return FUNCTIONS["sqrt"](prime * prime - f.get("offset", Exact(0)) ** 2) - f.get("roller_distance", 0)
        a, c = f["arm"], f["pivot_distance"]
        return FUNCTIONS["acos"]((a * a + c * c - prime * prime) / (2 * a * c)) - f.get("arm_angle", 0)

    def _given(self, s: Any) -> tuple[dict[str, Any], Any, Any]:
        """Sizes, roller radius and start in the kind of number that the lift is."""
        if isinstance(s, np.ndarray):
            return self.sizes, float(self.roller), self.rough
        return self.f, self.roller, self.start

    def centre(self, s: Any, s1: Any, s2: Any) -> tuple[Any, Any, Any, Any]:
        """Centre of the roller with two derivatives in the fixed frame, and the way it is driven."""
        f, _, start = self._given(s)
        none = 0 * s
        if not self.swing:
            way = (none, none - 1 if self.mate else none + 1)
            return (none + f.get("offset", 0), start + s), (none, s1), (none, s2), way
        sin, cos = sine_cosine(start + s)
        arm = f["arm"]
        # z = c − a e^(−iψ)
        first, second = (arm * s1 * sin, arm * s1 * cos), arm * s1 * s1
        bent = (arm * s2 * sin + second * cos, arm * s2 * cos - second * sin)
        way = (-sin, -cos) if self.mate else (sin, cos)
        return (f["pivot_distance"] - arm * cos, arm * sin), first, bent, way

    def face(self, s: Any, s1: Any, s2: Any) -> dict[str, Any]:
        """A flat face: contact in the fixed frame, normal, radius of curvature, place along the face."""
        f, _, start = self._given(s)
        if self.kind == "FlatFace":
            normal, level, first, second = (0 * s, 0 * s + 1), start + s, s1, s2
            rate, bend = 0 * s - self.turn, 0 * s
        else:
            sin, cos = sine_cosine(start + s)
            c = f["pivot_distance"]
            normal, level = (sin, cos), c * sin - f.get("face_offset", 0)
            first, second = c * cos * s1, c * cos * s2 - c * sin * s1 * s1
            rate, bend = 0 * s - s1 - self.turn, 0 * s - s2
        by_angle = first / rate
        radius = level + (second - by_angle * bend) / (rate * rate)
        point = times(normal, (level, by_angle))
        if self.kind == "FlatFace":
            return {"point": point, "normal": normal, "radius": radius, "along": point[0], "pressure": 0 * s}
        lever = (point[0] - f["pivot_distance"], point[1])
        along = -times(lever, (cos, sin))[0]
        # the point of the face moves square to its lever, outwards
        pressure = self.turn * arc_tangent(
            lever[0] * normal[0] + lever[1] * normal[1], lever[1] * normal[0] - lever[0] * normal[1]
        )
        return {"point": point, "normal": normal, "radius": radius, "along": along, "pressure": pressure}

    def touch(self, s: Any, s1: Any, s2: Any) -> dict[str, Any]:
        """Contact: point, normal and centre in the fixed frame, curvature of the pitch curve, pressure angle."""
        if self.flat:
            return self.face(s, s1, s2)
        _, roller, _ = self._given(s)
        z, z1, z2, way = self.centre(s, s1, s2)
        t = self.turn
        # c′ and c″ without their common factor e^(−iτθ)
        c1 = (z1[0] + t * z[1], z1[1] - t * z[0])
        c2 = (z2[0] + 2 * t * z1[1] - z[0], z2[1] - 2 * t * z1[0] - z[1])
        square = c1[0] * c1[0] + c1[1] * c1[1]
        size = sqrt(square)
        normal = (-t * c1[1] / size, t * c1[0] / size)
        curvature = -t * (c1[0] * c2[1] - c1[1] * c2[0]) / (square * size)
        reach = self.side * roller
        point = (z[0] - reach * normal[0], z[1] - reach * normal[1])
        leaning = times(normal, (way[0], -way[1]))
        return {
            "point": point, "normal": normal, "centre": z, "curvature": curvature, "speed": size,
            "pressure": t * arc_tangent(leaning[1], leaning[0]),
        }  # fmt: skip

    def leaning(self, s: Any, s1: Any, s2: Any) -> Any:
        """The pressure angle."""
        return self.touch(s, s1, s2)["pressure"]

    def bend(self, s: Any, s1: Any, s2: Any) -> Any:
        """Curvature of the pitch curve."""
        return self.touch(s, s1, s2)["curvature"]

    def rounding(self, s: Any, s1: Any, s2: Any) -> Any:
        """Radius of curvature under a flat face."""
        return self.face(s, s1, s2)["radius"]

    def turned(self, point: Any, theta: Any, start_angle: Any = 0) -> tuple[Any, Any]:
        """A point of the fixed frame in the cam's."""
        sin, cos = sine_cosine(start_angle - self.turn * theta)
        return times(point, (cos, sin))


def _shares(count: int) -> Any:
    """Shares of a zone to sample, fine towards its ends, where a law leaves its dwell with a high power."""
    ends = [2.0**-k for k in range(8, 36)]
    return np.unique(np.concatenate([np.linspace(0.0, 1.0, count), ends, 1.0 - np.array(ends)]))


# So many of the highest humps are climbed at most, and so many samples beside each end of a zone are finer than others.
MANY, FINE = 40, 30


class Looking:
    """How finely the turn is looked at: coarsely first, finely where a bound seems to be broken."""

    coarse, fine = (_shares(161), 1), (_shares(6001), 24)
    shares, steps = coarse


def climbed(
    quantity: Quantity, zone: Zone, ends: tuple[Any, Any], place: Any, sign: int, shift: int, size: float
) -> Any:
    """The quantity where its derivative vanishes between two places, by Newton's method kept between them.

    What comes back is a value that is taken there, whatever the derivative does.
    """
    low, high = ends
    little = Exact(size) * Exact(2) ** -100
    for _ in range(200):
        made = as_jet(quantity(*zone.jets(place, shift)))
        slope, bend = sign * made.first, sign * made.second
        low, high = (place, high) if slope > 0 else (low, place)
        step = -slope / bend if bend < 0 else None
        if step is not None and low < place + step < high:
            # the next step moves the value by less than matters
            if abs(slope * step) <= little:
                return made.value - made.first * made.first / made.second / 2
            place += step
        else:
            place = (low + high) / 2
        if abs(slope) * (high - low) <= little:
            return made.value
    return made.value


def extreme(
    turn: Turn, quantity: Quantity, sign: int, *, only: Callable[..., Any] | None = None, rests: bool = True,
    shift: int = 0,
) -> Any:  # fmt: skip
    """The largest of sign·quantity over the turn, exactly; `only` says of arrays and reals where it counts.

    Samples in doubles say which humps may be the highest; each of those is climbed in 240 bits. What comes back is a
    value that is taken on (or the limit of such at an end), so that a bound that does not reach it is broken for sure.
    With a `shift` the quantity is one of a higher derivative of the lift.
    """
    humps: list[tuple[float, float, Zone, int]] = []
    shares = Looking.shares
    with np.errstate(all="ignore"):
        for zone in turn.zones:
            if zone.branch is None and not rests:
                continue
            own = shares if zone.branch is not None else np.array([0.0, 1.0])
            state = zone.over(own, 2 + shift)[shift:]
            values = sign * np.broadcast_to(quantity(*state), own.shape)
            if only is not None:
                values = np.where(only(*state), values, -np.inf)
            humps += [(value, rise, zone, i) for value, rise, i in _humps(np.where(np.isnan(values), -np.inf, values))]
    if not humps:
        return None
    best = max(height for height, _, _, _ in humps)
    found: list[Any] = []
    ends: set[int] = set()
    for height, rise, zone, i in sorted(humps, key=lambda hump: -hump[0])[:MANY]:
        if height + rise < best - 1e-7 * abs(best):
            continue
        if id(zone) not in ends:
            ends.add(id(zone))
            states = [zone.at(place, 2 + shift)[shift:] for place in (zone.start, zone.end)]
            found += [quantity(*state) for state in states if only is None or only(*state)]
        if zone.branch is not None:
            found += _turning(quantity, zone, i, sign, only, shift, abs(best))
    return sign * max(sign * value for value in found)


def _humps(values: Any) -> list[tuple[float, float, int]]:
    """Samples no lower than their neighbours: height, how far the hump may rise above it, and which.

    Beside the end of a zone what differs from the end by rounding alone is no hump, unless it is looked at finely.
    """
    padded = np.concatenate(([-np.inf], values, [-np.inf]))
    size = float(np.max(np.abs(values), initial=0.0, where=np.isfinite(values)))
    last = len(values) - 1
    found = []
    for i in np.flatnonzero((values >= padded[:-2]) & (values >= padded[2:]) & (values > -np.inf)).tolist():
        end = 0 if i < FINE else last
        if Looking.steps == 1 and not FINE <= i <= last - FINE and values[i] - values[end] <= 2e-15 * size:
            i = end
        # as much as it falls to the nearer neighbour
        beside = max(padded[i], padded[i + 2])
        rise = max(values[i] - beside, 0.0) if np.isfinite(beside) else 0.0
        found.append((float(values[i]), float(rise), i))
    return list(dict.fromkeys(found))


def _turning(quantity: Quantity, zone: Zone, i: int, sign: int, only: Any, shift: int, size: float) -> list[Any]:
    """The exact value where the hump about one sample turns, if it does."""
    width, shares = zone.end - zone.start, Looking.shares
    at = [zone.start + width * Exact(float(share)) for share in shares[max(i - 1, 0) : i + 2]]
    if i in (0, len(shares) - 1):
        # a hump beside an end rises from it
        slope = as_jet(quantity(*zone.jets(zone.start if i == 0 else zone.end, shift))).first
        if sign * slope * (1 if i == 0 else -1) <= 0:
            return []
        at.insert(1, (at[0] + at[1]) / 2)
    state = zone.at(at[1], 2 + shift)[shift:]
    if only is not None and not only(*state):
        return []
    return [climbed(quantity, zone, (at[0], at[2]), at[1], sign, shift, size)]


def nodes(count: int = 40) -> list[tuple[Any, Any]]:
    """Gauss's rule on −1 … 1 to all bits."""
    found = []
    for k in range(count):
        x = FUNCTIONS["cos"](exact_pi() * (Exact(k) + Exact(3) / 4) / (count + Exact(1) / 2))
        for _ in range(9):
            before, value = Exact(1), x
            for n in range(2, count + 1):
                before, value = value, ((2 * n - 1) * x * value - (n - 1) * before) / n
            slope = count * (x * value - before) / (x * x - 1)
            x -= value / slope
        found.append((x, 2 / ((1 - x * x) * slope * slope)))
    return found
