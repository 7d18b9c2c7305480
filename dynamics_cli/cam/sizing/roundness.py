"""The start height of a slide's roller for a required radius of curvature, and the offset that minimises it.

At each cam angle the height X of the pitch curve has to exceed the largest root of w³ = ρ·(w² + Y s′ − X s″),
Y = s′ − e; on an outer flank, where the hollow of the pitch curve binds, of w³ = −ρ·(…).
"""

from math import hypot, inf, sqrt

import numpy as np

from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.analysis import analyse
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.program.pieces import within
from dynamics_cli.numerics.chebyshev.proxies import extremes, proxies
from dynamics_cli.numerics.roots import halved

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

# Nodes of a zone, denser towards its ends; how near to the largest one a peak is refined.
NODES = 49
NEAR = 0.02
# Steps of the coarse search for the best offset on either side, and its final tolerance, relative to the reach.
GRID = 16
FINEST = 1e-9
# slopes on both sides of a dip that differ by less belong to one smooth curve; costs that differ by less are equal
POINTED = 1e-5
ALIKE = 1e-13
UNIT = 2.0**-53
GOLDEN = 0.5 * (sqrt(5.0) - 1.0)


class Falling:
    """The motion of a second follower of a conjugate pair, which falls where the first rises."""

    def __init__(self, motion: "Any") -> None:
        self.motion = motion
        self.zones, self.swing = motion.zones, motion.swing
        self.stroke = tuple(-level for level in motion.stroke[::-1])

    def parts_of(self, index: int) -> "list[Any]":
        """The parts of a zone."""
        return [part.negated() for part in self.motion.parts_of(index)]

    def in_zone(self, index: int, t: "Any", derivatives: int = 3) -> "tuple[Any, ...]":
        """Lift and derivatives at shares of a zone."""
        return tuple(-value for value in self.motion.in_zone(index, t, derivatives))

    def at(self, theta: "Any", derivatives: int = 3, side: int = 1) -> "tuple[Any, ...]":
        """Lift and derivatives at cam angles."""
        return tuple(-value for value in self.motion.at(theta, derivatives, side))


class Round:
    """A radius of curvature that the pitch curve of a slide is to keep.

    `motion`: the program; `wanted`: least radius of curvature of the pitch curve, where convex, or where hollow on an
    outer flank [m]; `turn`, `side`: -1 for a clockwise cam; -1 for an outer flank.
    """

    def __init__(self, motion: "Any", wanted: float, turn: float, side: float) -> None:
        self.motion, self.wanted, self.turn, self.side = motion, wanted, turn, side
        half = (NODES - 1) // 2
        self.shares = 0.5 + 0.5 * np.sin(0.5 * np.pi * (np.arange(NODES) / half - 1.0))
        count = len(motion.zones)
        self.nodes = within(motion, np.tile(self.shares, (count, 1)), np.arange(count))

    def bend(self, e: float, d: float) -> float:
        """The maximum of the relevant curvature at height d; negative where the curve never has that sign."""
        return self._bend(e, d)[0]

    def _bend(self, e: float, d: float) -> "tuple[float, float]":
        """That curvature and the bound of its error."""
        geometry = Geometry(followers.KnifeEdge(hypot(e, d), self.turn * e), "clockwise" if self.turn < 0.0 else "ccw")
        geometry.start = d
        curvature = analyse(geometry, self.motion).curvature
        if self.side > 0.0:
            return curvature.greatest, curvature.greatest_error
        return -curvature.least, curvature.least_error

    def slip(self, e: float, d: float) -> float:
        """Error bound of a height that just keeps the curvature: certainly violated below and kept above."""
        return sure_about(lambda height: self._bend(e, height), self.wanted, d, 1e-6 * self.wanted)

    def kept(self, e: float, d: float) -> bool:
        """Whether the radius is kept at height d."""
        return self.bend(e, d) * self.wanted <= 1.0

    def _roots(self, e: float) -> "Any":
        """Largest roots at the nodes, less the lift; minus infinity where no root exists."""
        s, s1, s2 = (part.ravel() for part in self.nodes)
        y = s1 - e
        # D = X² − s″X + q; (w²)³ = ρ²D² is of degree 6 in X, its largest coefficient one
        q, yy, rho = y * (y + s1), y * y, self.wanted * self.wanted
        rows = np.zeros((s.size, 6, 6))
        rows[:, np.arange(1, 6), np.arange(5)] = 1.0
        rows[:, 0, 1] = -(3.0 * yy - rho)
        rows[:, 0, 2] = -2.0 * rho * s2
        rows[:, 0, 3] = -(3.0 * yy * yy - rho * (s2 * s2 + 2.0 * q))
        rows[:, 0, 4] = -2.0 * rho * s2 * q
        rows[:, 0, 5] = -(yy * yy * yy - rho * q * q)
        roots = np.linalg.eigvals(rows)
        x = roots.real
        true = (np.abs(roots.imag) < 1e-6 * self.wanted) & (self.side * (x * x - s2[:, None] * x + q[:, None]) > 0.0)
        return np.where(true, x - s[:, None], -np.inf).max(axis=1).reshape(self.nodes[0].shape)

    def rough(self, e: float) -> float:
        """Height required at the nodes, slightly below the true one."""
        return float(self._roots(e).max())

    def fine(self, e: float) -> float:
        """Required height: peaks between nodes by Chebyshev proxies."""
        at_nodes = self._roots(e)
        top = float(at_nodes.max())
        if not top > -inf:
            return -inf
        near = at_nodes >= top - NEAR * (abs(top) + self.wanted)
        low = np.concatenate((np.full((near.shape[0], 1), -np.inf), at_nodes[:, :-1]), axis=1)
        high = np.concatenate((at_nodes[:, 1:], np.full((near.shape[0], 1), -np.inf)), axis=1)
        zone, node = np.nonzero(near & (at_nodes >= low) & (at_nodes >= high))
        left, right = self.shares[np.maximum(node - 1, 0)], self.shares[np.minimum(node + 1, NODES - 1)]
        start = at_nodes[zone, node] + self.nodes[0][zone, node]

        def heights(share: "Any", piece: "Any") -> "Any":
            s, s1, s2 = within(self.motion, share, zone[piece])
            return (self._newton(s, s1, s2, e, start[piece][:, None]) - s)[None]

        try:
            with np.errstate(all="ignore"):
                return max(top, extremes(proxies(heights, left, right, depth=6)).largest()[0])
        except ValueError:
            return top

    def _newton(self, s: "Any", s1: "Any", s2: "Any", e: float, start: "Any") -> "Any":
        """The root of w³ = ±ρD near another angle's."""
        y, rho = s1 - e, self.side * self.wanted
        x = start + 0.0 * s
        for _ in range(12):
            w = np.sqrt(x * x + y * y)
            value = w * w * w - rho * (w * w + y * s1 - x * s2)
            x = x - value / (3.0 * w * x - rho * (2.0 * x - s2))
        return x

    def height(self, e: float) -> float:
        """The same, by a secant on extremes over the turn, from the fine height."""
        d = self.fine(e)
        if not d > -inf:
            return d
        residual, slope = 1.0 - self.wanted * self.bend(e, d), 1.0 / self.wanted
        for _ in range(20):
            if abs(residual) <= 2e-15:
                break
            new = d - min(max(residual / slope, -0.1 * self.wanted), 0.1 * self.wanted)
            now = 1.0 - self.wanted * self.bend(e, new)
            if new == d:
                break
            if now != residual:
                slope = min(max((now - residual) / (new - d), 0.01 / self.wanted), 1e4 / self.wanted)
            d, residual = new, now
        return d if abs(residual) <= 1e-13 else self._bisected(e, max(d, self.fine(e)))

    def _bisected(self, e: float, start: float) -> float:
        """The height by bisection, after steps that double; where peaks are too narrow for the nodes."""
        low = high = start
        step = 0.01 * self.wanted
        while not self.kept(e, high):
            low, high, step = high, high + step, 2.0 * step
        while low == high and step > 1e-9 * self.wanted:
            # kept at the start: go back to where it is not
            if self.kept(e, high - step):
                high = low = high - step
            else:
                low = high - step
            step *= 0.5
        return halved(lambda height: not self.kept(e, height), low, high)[1]


def sure_about(bend: "Callable[[float], tuple[float, float]]", wanted: float, place: float, step: float) -> float:
    """Distance from a place at which a curvature is certainly too large below and certainly not above.

    `bend`: curvature and the bound of its error; it falls as its argument grows; `wanted`: the radius of curvature that
    is to be kept [m]; `place`: where it is just kept, as found; `step`: a step that resolves the slope. Returns the
    distance; infinite where there is none.
    """

    def sure(argument: float, sense: float) -> bool:
        value, error = bend(argument)
        return sense * (1.0 - wanted * value) > wanted * error + 4.0 * UNIT

    value, error = bend(place)
    step = max(step, 1e-6 * abs(place))
    slope = (value - bend(place + step)[0]) * wanted / step
    off = abs(1.0 - wanted * value) + 2.2 * wanted * error + 8.0 * UNIT
    wide = max(off / slope if slope > 0.0 else 1e-9 * place, 4.0 * UNIT * place)
    for _ in range(40):
        if sure(place + wide, 1.0) and (place <= wide or sure(place - wide, -1.0)):
            return wide
        wide *= 1.5
    return inf


def best_offset(
    rough: "Callable[[float], float]", fine: "Callable[[float], float]", reach: float
) -> tuple[float, float]:
    """The offset of minimum cost: every dip of a grid by golden section, and the corner where two slopes meet in it.

    `rough`, `fine`: cost of an offset, quickly and exactly; `reach`: no offset farther out can do better [m]. Returns
    the offset, zero where that costs no more, and how much less another might cost.
    """
    step = reach / GRID
    costs = [rough(k * step) for k in range(-GRID, GRID + 1)]
    least = min(costs)
    dips = [
        k - GRID
        for k in range(2 * GRID + 1)
        if costs[k] <= 1.05 * least and costs[k] <= min(costs[max(k - 1, 0)], costs[min(k + 1, 2 * GRID)])
    ]
    candidates = [_dip(fine, (k - 1) * step, (k + 1) * step, FINEST * reach) for k in dips]
    best = min(cost for cost, _ in candidates)
    # a candidate that is a corner lies where its two sides meet
    ends = [
        _met(fine, place, 4.0 * FINEST * reach) for cost, place in candidates if cost <= best + 4.0 * FINEST * reach
    ]
    cost, place, loose = min(ends)
    # where a circle binds, all offsets are equivalent
    return (0.0 if fine(0.0) <= cost * (1.0 + ALIKE) else place), loose


def _met(cost: "Callable[[float], float]", place: float, step: float) -> tuple[float, float, float]:
    """The minimum cost near a place, the place, and how far the cost there is from its extrapolation.

    Of two smooth sides each is a line over a billionth of the reach, to the square of that.
    """
    at_place = cost(place)
    far, before, right, beyond = (cost(place + k * step) for k in (-2.0, -1.0, 1.0, 2.0))
    down, up = (before - far) / step, (beyond - right) / step
    rounding = 8.0 * UNIT * at_place
    if not down < 0.0 < up or up - down < POINTED:
        return at_place, place, rounding
    met = (right - before - (up + down) * step) / (down - up)
    if abs(met) > step:
        return at_place, place, step * (up - down)
    at_met = cost(place + met)
    predicted = before + down * (met + step)
    return (at_met, place + met, abs(at_met - predicted) + rounding)


def _dip(cost: "Callable[[float], float]", low: float, high: float, finest: float) -> tuple[float, float]:
    """The least cost between two offsets, and where."""
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_a, at_b = cost(a), cost(b)
    while high - low > finest and low < a < high and low < b < high:
        if at_a < at_b:
            high, b, at_b = b, a, at_a
            a = high - GOLDEN * (high - low)
            at_a = cost(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + GOLDEN * (high - low)
            at_b = cost(b)
    return (at_a, a) if at_a < at_b else (at_b, b)
