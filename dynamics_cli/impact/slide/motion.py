"""Motion of a car on four wheels that slide or roll, in a time stretched so that it ends exactly.

Friction is of degree zero in the velocities. With σ = √(V² + k²ω²), q = (V, kω)/σ and λ = ln(σ₀/σ) the stop,
singular in time, moves to λ = ∞, and places converge as e^(-2λ). A wheel that stops before the others, about which the
car then turns, is an event of its own: from there on the deceleration is constant.
"""

from dynamics_cli.errors import require
from dynamics_cli.impact.slide.wheels import Car, State
from dynamics_cli.numerics.elementary import cos, exp, hypot, sin, sqrt
from dynamics_cli.quantities import Angle, AngularSpeed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# From here on what is left of the way is below the last bit of the way so far.
LAST = 18.0
# A wheel this slow beside the car stands: its remaining slip moves the car by the square of it.
STANDS = 1e-5
MOST_STEPS = 20_000
# Where the state of a step holds its parts: velocities, place, nose, time, path, and work of each wheel.
X, NOSE, TIME, PATH, WORK = 3, 5, 6, 7, 8
TOLERANCE = 1e-8


class Moment:
    """Where the car is at one time: place, nose, velocities, path and work per mass of each wheel so far."""

    __slots__ = ("nose", "path", "spin", "time", "velocity", "work", "x", "y")

    def __init__(
        self, time: float, x: float, y: float, nose: float, velocity: "tuple[float, float]", spin: float, path: float,
        work: "tuple[float, ...]",
    ) -> None:  # fmt: skip
        self.time = time
        self.x = x
        self.y = y
        self.nose = nose
        self.velocity = velocity
        self.spin = spin
        self.path = path
        self.work = work


class Run:
    """A motion from the separation to rest; `about` is the wheel that the car turned about last, if any did stand."""

    def __init__(self) -> None:
        self.moments: list[Moment] = []
        self.about: int | None = None
        self.steps = 0

    @property
    def end(self) -> Moment:
        """At rest."""
        return self.moments[-1]

    def at(self, time: float) -> "tuple[float, float, float]":
        """Place and nose at a time, by cubics between the steps."""
        from bisect import bisect_right

        moments = self.moments
        index = min(max(bisect_right([one.time for one in moments], time), 1), len(moments) - 1)
        one, other = moments[index - 1], moments[index]
        step = other.time - one.time
        if step <= 0.0:
            return other.x, other.y, other.nose
        u = (time - one.time) / step
        ends = (
            (one.x, other.x, one.velocity[0], other.velocity[0]),
            (one.y, other.y, one.velocity[1], other.velocity[1]),
            (one.nose, other.nose, one.spin, other.spin),
        )
        w = u * u * (3.0 - 2.0 * u)
        x, y, nose = ((1.0 - w) * a + w * b + step * u * (1.0 - u) * ((1.0 - u) * da - u * db) for a, b, da, db in ends)
        return x, y, nose


def run(car: Car, start: State, tolerance: float = TOLERANCE) -> Run:
    """The motion of a car from a state to rest."""
    done = Run()
    at, passed, clock = start, [0.0] * 5, 0.0
    ignored: int | None = None
    while True:
        done.moments.append(_moment(at, clock, passed))
        size = at.size(car.gyration)
        if size == 0.0:
            return done
        wheel = car.standing(at, STANDS, ignored)
        if wheel is not None:
            done.about = wheel
            at, clock = _about(car, at, wheel, clock, passed)
            if at.size(car.gyration) == 0.0:
                done.moments.append(_moment(at, clock, passed))
                return done
            ignored = wheel
            continue
        at, clock, ended = _slid(car, at, clock, passed, done, tolerance, ignored)
        if ended:
            done.moments.append(_moment(at, clock, passed))
            return done
        ignored = None


def _moment(at: State, clock: float, passed: "list[float]") -> Moment:
    return Moment(clock, at.x, at.y, at.nose, (at.vx, at.vy), at.spin, passed[0], tuple(passed[1:]))


def _slid(
    car: Car, at: State, clock: float, passed: "list[float]", done: Run, tolerance: float, ignored: int | None
) -> "tuple[State, float, bool]":
    """Slide in stretched time to rest, or to where a wheel stands; whether it came to rest."""
    import numpy as np
    from scipy.integrate import LSODA

    size = at.size(car.gyration)
    k = car.gyration
    begin = [at.vx / size, at.vy / size, k * at.spin / size, at.x, at.y, at.nose, clock, *passed]

    def rates(stretched: float, y: "Any") -> "list[float]":
        return _rates(car, y.tolist(), size * exp(-stretched))

    solver = LSODA(rates, 0.0, np.array(begin), LAST, rtol=tolerance, atol=tolerance)
    while True:
        solver.step()
        done.steps += 1
        y = solver.y.tolist()
        left = size * exp(-solver.t)
        if solver.status != "running":
            rates_there = _rates(car, y, left)
            for index in range(X, len(y)):
                y[index] += (1.0 if index == TIME else 0.5) * rates_there[index]
            left = 0.0
        norm = sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2])
        scale = left / norm
        state = State(y[X], y[X + 1], y[NOSE], scale * y[0], scale * y[1], scale * y[2] / k)
        passed[:] = y[PATH:]
        clock = y[TIME]
        require(
            done.steps < MOST_STEPS, "the car still turns at {spin:3} after {turned:3}", code="too-long",
            spin=(abs(state.spin), AngularSpeed), turned=(abs(state.nose - at.nose), Angle),
            hint="cars turn at most once or twice a second: check the spin and its unit",
        )  # fmt: skip
        if solver.status != "running":
            return state, clock, True
        standing = car.standing(state, STANDS, None)
        if ignored is not None and standing != ignored:
            ignored = None
        if standing is not None and standing != ignored:
            return state, clock, False
        done.moments.append(_moment(state, clock, passed))


def _rates(car: Car, y: "list[float]", left: float) -> "list[float]":
    """Derivatives by the stretched time of velocities, place, nose, time, path and work."""
    qx, qy, qw = y[0], y[1], y[2]
    c, s = cos(y[NOSE]), sin(y[NOSE])
    ahead, aside, turn, powers = car.pushed(c * qx + s * qy, c * qy - s * qx, qw / car.gyration, y[X], y[X + 1], c, s)
    shed = powers[0] + powers[1] + powers[2] + powers[3]
    pull = 1.0 / (qx * qx + qy * qy + qw * qw)
    way = left * left / shed
    return [
        (c * ahead - s * aside) / shed + qx * pull,
        (s * ahead + c * aside) / shed + qy * pull,
        turn / (car.gyration * shed) + qw * pull,
        qx * way,
        qy * way,
        qw * way / car.gyration,
        left / shed,
        hypot(qx, qy) * way,
        *(power * way for power in powers),
    ]


def _about(car: Car, at: State, wheel: int, clock: float, passed: "list[float]") -> "tuple[State, float]":
    """Turn about a wheel that stands, until rest or until it can no longer be held."""
    pivot = car.pivot(at, wheel)
    spin, end, rate = pivot.spin, pivot.end, pivot.rate
    angle = (spin * spin - end * end) / (2.0 * rate)
    sense = 1.0 if spin > 0.0 else -1.0
    turned = sense * angle
    # the mass centre goes round the wheel; a difference of turned vectors, by half angles
    half = 2.0 * sin(0.5 * turned)
    c, s = cos(at.nose + 0.5 * turned), sin(at.nose + 0.5 * turned)
    dx, dy = pivot.arm
    x = at.x + half * (-s * dx - c * dy)
    y = at.y + half * (c * dx - s * dy)
    nose = at.nose + turned
    left = sense * end
    c, s = cos(nose), sin(nose)
    vx, vy = left * (-s * dx - c * dy), left * (c * dx - s * dy)
    passed[0] += hypot(dx, dy) * angle
    for index, moment in enumerate(pivot.moments):
        passed[1 + index] += moment * angle
    state = State(x, y, nose, vx, vy, left)
    return state, clock + (abs(spin) - end) / rate
