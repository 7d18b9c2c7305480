"""Flights of a projectile: without drag, with drag in proportion to its speed, and by the square of it."""

import math

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.quadrature.gauss import legendre
from dynamics_cli.numerics.roots import bisected

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    # time, distance, height above the launch, horizontal and vertical velocity
    State: TypeAlias = tuple[float, float, float, float, float]

NODES = legendre(16)
FEWER = legendre(12)
ROUNDS = 100
# A last step of Newton's rule, in widths of the panel.
SETTLED = 1e-8
# From this difference of slopes on, that of G is taken plainly.
NEAR = 0.02
STEEPEST = 1e150


class Vacuum:
    """A flight without drag."""

    def __init__(self, across: float, up: float, gravity: float) -> None:
        self.across, self.up, self.gravity = across, up, gravity

    def at(self, time: float) -> "State":
        """The state at a time."""
        rise = time * (self.up - 0.5 * self.gravity * time)
        return time, self.across * time, rise, self.across, self.up - self.gravity * time

    def apex(self) -> "State":
        """The highest place after the launch."""
        return self.at(self.up / self.gravity if self.up > 0.0 else 0.0 * self.up)

    def landing(self, drop: float) -> "State":
        """The state where it comes down to a level so far below the launch."""
        root = sqrt(self.up * self.up + 2.0 * self.gravity * drop)
        time = (self.up + root) / self.gravity if self.up >= 0.0 else 2.0 * drop / (root - self.up)
        return time, self.across * time, -drop, self.across, -root

    def passing(self, distance: float) -> "State | None":
        """The state at a distance, where it comes there."""
        return self.at(distance / self.across) if self.across > 0.0 else None


def _shortfall(s: float) -> float:
    """S − 1 + e^(−s), by its series where it cancels."""
    if s > 0.3:
        return s + math.expm1(-s)
    term, total, k = 0.5 * s * s, 0.0, 2
    while total + term != total:
        total += term
        k += 1
        term *= -s / k
    return total


class Linear:
    """A flight with drag in proportion to the speed through the air, in a wind along the ground."""

    def __init__(self, across: float, up: float, gravity: float, time_constant: float, wind: float) -> None:
        self.across, self.up, self.gravity = across, up, gravity
        self.tau, self.wind = time_constant, wind

    def at(self, time: float) -> "State":
        """The state at a time."""
        s = time / self.tau
        decay, spent = math.exp(-s), -math.expm1(-s)
        through = self.across - self.wind
        x = through * self.tau * spent + self.wind * time
        y = self.up * self.tau * spent - self.gravity * self.tau * self.tau * _shortfall(s)
        return time, x, y, through * decay + self.wind, self.up * decay - self.gravity * self.tau * spent

    def apex(self) -> "State":
        """The highest place after the launch."""
        return self.at(self.tau * math.log1p(self.up / (self.gravity * self.tau)) if self.up > 0.0 else 0.0)

    def landing(self, drop: float) -> "State":
        """The state where it comes down to a level so far below the launch, by Newton's rule from later times."""
        time = Vacuum(self.across, self.up, self.gravity).landing(drop)[0]
        while self.at(time)[2] > -drop:
            time *= 2.0
        for _ in range(ROUNDS):
            _, _, height, _, rate = self.at(time)
            step = (height + drop) / rate
            time -= step
            if abs(step) <= 1e-16 * time:
                break
        return _level(self.at(time), drop)

    def passing(self, distance: float) -> "State | None":
        """The state at a distance, where it comes there before it is far below."""
        low, high = 0.0, distance / self.across if self.across > 0.0 else self.tau
        while self.at(high)[1] < distance:
            low, high = high, 2.0 * high
            if self.at(high)[3] <= 0.0 or high > 1e3 * self.tau:
                return None
        return self.at(bisected(lambda time: self.at(time)[1] - distance, low, high))


class Quadratic:
    """A flight with drag by the square of the speed through the air, in a wind along the ground.

    In the air's frame the slope p of the path runs from that of the launch down; 1/v_x² = 1/v_x0² + (G(p₀) − G(p))/v_t²
    with G(p) = p·√(1 + p²) + asinh p, and t, x, y are ∫ v_x dp/g, ∫ v_x² dp/g, ∫ p·v_x² dp/g.
    """

    def __init__(self, across: float, up: float, gravity: float, terminal: float, wind: float) -> None:
        through = across - wind
        self.side = 1.0 if through >= 0.0 else -1.0
        self.through, self.gravity, self.terminal, self.wind = abs(through), gravity, terminal, wind
        self.slope = up / self.through
        self.start = _primitive(self.slope)
        self.head = 1.0 / (self.through * self.through)
        # the first panel is as wide as the launch speed takes to fall off, each next one twice as wide
        width = 0.25 * terminal * terminal * self.head / math.sqrt(1.0 + self.slope * self.slope)
        self.width = min(width, 0.25 * (1.0 + abs(self.slope)))
        self.edges = [(self.slope, (0.0, 0.0, 0.0))]
        self.nodes = NODES

    def _speed(self, slope: float) -> float:
        if self.slope - slope > NEAR * (1.0 + abs(self.slope)):
            risen = self.start - _primitive(slope)
        else:
            risen = _difference(self.slope, slope)
        return 1.0 / math.sqrt(self.head + risen / (self.terminal * self.terminal))

    def _added(self, high: float, low: float) -> "tuple[float, float, float]":
        """Time, distance and height from one slope to a lower one."""
        span, t, x, y = high - low, 0.0, 0.0, 0.0
        for share, weight in self.nodes:
            slope = high - share * span
            speed = self._speed(slope)
            t += weight * speed
            x += weight * speed * speed
            y += weight * slope * speed * speed
        scale = span / self.gravity
        return scale * t, scale * x, scale * y

    def _reach(self, index: int) -> "tuple[float, tuple[float, float, float]]":
        """The slope at an edge of the panels, and what was gone until there."""
        while len(self.edges) <= index:
            slope, gone = self.edges[-1]
            lower = slope - self.width * 2.0 ** (len(self.edges) - 1)
            # the apex is an edge, so that heights about it are not differences
            if slope > 0.0 > lower:
                lower = 0.0
            step = self._added(slope, lower)
            self.edges.append((lower, (gone[0] + step[0], gone[1] + step[1], gone[2] + step[2])))
        return self.edges[index]

    def _state(self, slope: float, gone: "tuple[float, float, float]") -> "State":
        speed = self._speed(slope)
        time = gone[0]
        across = self.side * speed + self.wind
        return time, self.side * gone[1] + self.wind * time, gone[2], across, slope * speed

    def _solved(self, which: "int | None", wanted: float) -> "State | None":
        """The state where time (0), distance over ground (1) or the height on the way down (2) is as wanted."""
        index = 0
        while True:
            slope, _ = self._reach(index)
            low, after = self._reach(index + 1)
            if self._past(which, low, after) >= wanted:
                break
            index += 1
            if low < -STEEPEST or index > 600:
                return None
        lower, upper = low, slope
        place = 0.5 * (lower + upper)
        for _ in range(ROUNDS):
            here = self._gone(index, place)
            excess, rate = self._past(which, place, here) - wanted, self._rate(which, place)
            lower, upper = (place, upper) if excess >= 0.0 else (lower, place)
            # Newton's step where it stays between, else halving; what it leaves is the square of a small step
            following = place - excess / rate if rate else lower
            if abs(following - place) <= SETTLED * (slope - low):
                place = following
                break
            if not lower < following < upper:
                following = 0.5 * (lower + upper)
            if not lower < following < upper:
                break
            place = following
        return self._state(place, self._gone(index, place))

    def _gone(self, index: int, slope: float) -> "tuple[float, float, float]":
        """What is gone until a slope beyond an edge."""
        high, before = self.edges[index]
        added = self._added(high, slope)
        return before[0] + added[0], before[1] + added[1], before[2] + added[2]

    def _rate(self, which: "int | None", slope: float) -> float:
        """The derivative of what is wanted by the slope."""
        speed = self._speed(slope)
        if which == 0:
            return -speed / self.gravity
        if which == 1:
            return -speed * (self.side * speed + self.wind) / self.gravity
        return slope * speed * speed / self.gravity

    def _past(self, which: "int | None", slope: float, gone: "tuple[float, float, float]") -> float:
        if which == 0:
            return gone[0]
        if which == 1:
            return self.side * gone[1] + self.wind * gone[0]
        return -gone[2] if slope <= 0.0 else -math.inf

    def at(self, time: float) -> "State":
        """The state at a time."""
        if time <= 0.0:
            return self._state(self.slope, (0.0, 0.0, 0.0))
        return _followed(self._solved(0, time))

    def apex(self) -> "State":
        """The highest place after the launch."""
        if self.slope <= 0.0:
            return self.at(0.0)
        index = 0
        while self._reach(index)[0] > 0.0:
            index += 1
        return self._state(*self._reach(index))

    def landing(self, drop: float) -> "State":
        """The state where it comes down to a level so far below the launch."""
        if drop == 0.0 and self.slope <= 0.0:
            return self.at(0.0)
        return _level(_followed(self._solved(2, drop)), drop)

    def passing(self, distance: float) -> "State | None":
        """The state at a distance, where it comes there."""
        return self._solved(1, distance)


def _level(state: "State", drop: float) -> "State":
    """The state at a level so far below the launch, without what is left of finding it."""
    time, x, _, across, up = state
    return time, x, 0.0 - drop, across, up


def _followed(state: "State | None") -> "State":
    require(state is not None, "the flight goes on farther than can be followed", code="range",
            hint="check the speed, the drag and the height")  # fmt: skip
    assert state is not None
    return state


class Upright:
    """A flight straight up with drag by the square of the speed, in still air."""

    def __init__(self, up: float, gravity: float, terminal: float) -> None:
        self.up, self.gravity, self.terminal = up, gravity, terminal
        self.rise = terminal / gravity * math.atan(up / terminal)
        self.top = terminal * terminal / (2.0 * gravity) * math.log1p((up / terminal) ** 2)

    def at(self, time: float) -> "State":
        """The state at a time."""
        rest = self.gravity * (self.rise - time) / self.terminal
        scale = self.terminal * self.terminal / self.gravity
        if rest >= 0.0:
            return time, 0.0, self.top + scale * math.log(math.cos(rest)), 0.0, self.terminal * math.tan(rest)
        fallen = scale * (abs(rest) + math.log1p(math.expm1(2.0 * rest) / 2.0))
        return time, 0.0, self.top - fallen, 0.0, self.terminal * math.tanh(rest)

    def apex(self) -> "State":
        """The highest place."""
        return self.rise, 0.0, self.top, 0.0, 0.0

    def landing(self, drop: float) -> "State":
        """The state where it comes down to a level so far below the launch."""
        growth = math.exp((self.top + drop) * self.gravity / (self.terminal * self.terminal))
        time = self.rise + self.terminal / self.gravity * math.acosh(growth)
        return time, 0.0, -drop, 0.0, -self.terminal * math.sqrt((growth - 1.0) * (growth + 1.0)) / growth

    def passing(self, _distance: float) -> "State | None":
        """It comes to no distance."""
        return None


def _primitive(p: float) -> float:
    return p * math.sqrt(1.0 + p * p) + math.asinh(p)


def _difference(high: float, low: float) -> float:
    """G(high) − G(low) by the mean value of its derivative, where they are near one another."""
    span = high - low
    total = 0.0
    for share, weight in FEWER:
        p = high - share * span
        total += weight * 2.0 * math.sqrt(1.0 + p * p)
    return span * total
