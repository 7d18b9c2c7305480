"""A car on four wheels and what the road does to it, for one velocity of the car."""

from dynamics_cli.numerics.elementary import cos, hypot, sin, sqrt
from dynamics_cli.numerics.roots import halved

# The square of the slip, beside a car's speed of one, below which the direction of a force is smoothed: of a wheel
# that passes through standstill step control sees no corner, and no other slip notices it.
NO_SLIP = 1e-12
HALVINGS = 60
INFINITE = float("inf")
NAMES = ("left front", "right front", "left rear", "right rear")


class State:
    """Place of the mass centre, nose, velocity along the axes and spin."""

    __slots__ = ("nose", "spin", "vx", "vy", "x", "y")

    def __init__(self, x: float, y: float, nose: float, vx: float, vy: float, spin: float) -> None:
        self.x = x
        self.y = y
        self.nose = nose
        self.vx = vx
        self.vy = vy
        self.spin = spin

    def size(self, gyration: float) -> float:
        """√(V² + k²ω²)."""
        turning = gyration * self.spin
        return sqrt(self.vx * self.vx + self.vy * self.vy + turning * turning)


class Verge:
    """Ground of another friction to the left of a line through two points: all of it, a strip, or a patch.

    `bounds` are of a point's part across the line and along it, times the distance of the two points.
    """

    __slots__ = ("bounds", "friction", "normal")

    def __init__(
        self, begin: "tuple[float, float]", end: "tuple[float, float]", friction: float, width: float = INFINITE,
        *, patch: bool = False,
    ) -> None:  # fmt: skip
        a, b = self.normal = begin[1] - end[1], end[0] - begin[0]
        across = a * begin[0] + b * begin[1]
        along = b * begin[0] - a * begin[1], b * end[0] - a * end[1]
        self.bounds = across, across + hypot(a, b) * width, *(along if patch else (-INFINITE, INFINITE))
        self.friction = friction

    def holds(self, x: float, y: float) -> bool:
        """Whether a point is on it."""
        (a, b), (low, high, begin, end) = self.normal, self.bounds
        return low < a * x + b * y < high and begin <= b * x - a * y <= end


class Wheel:
    """Where a wheel is on the body, its load over the car's weight, its share of braking, grip slope and steer.

    A locked wheel slides: its force is against its slip, whatever the grip slope.
    """

    __slots__ = ("across", "ahead", "cosine", "left", "load", "share", "sine", "slope_squared")

    def __init__(self, ahead: float, left: float, load: float, share: float, grip_slope: float, steer: float) -> None:
        self.ahead = ahead
        self.left = left
        self.load = load
        self.share = share
        locked = share == 1.0
        self.across = 1.0 if locked else sqrt((1.0 - share) * (1.0 + share))
        self.slope_squared = 1.0 if locked else grip_slope * grip_slope
        self.cosine, self.sine = cos(steer), sin(steer)


class Pivot:
    """Turning about a wheel that stands: spin at its begin, size of the spin at its end, deceleration of the spin.

    `arm` goes from the wheel to the mass centre, on the body; `moments` are what the other wheels take of the energy
    per mass and per angle.
    """

    def __init__(self, spin: float, rate: float, arm: "tuple[float, float]", moments: "list[float]") -> None:
        self.spin = spin
        self.end = 0.0
        self.rate = rate
        self.arm = arm
        self.moments = moments


class Car:
    """A car on the road; wheels in the order of `NAMES`, seen from above with x ahead and y to the left."""

    def __init__(
        self, wheels: "list[Wheel]", gyration: float, friction: float, gravity: float, verges: "list[Verge]"
    ) -> None:
        self.wheels = wheels
        self.gyration = gyration
        self.friction = friction
        self.gravity = gravity
        self.verges = verges

    def grip(self, wheel: Wheel, x: float, y: float, c: float, s: float) -> float:
        """Friction times load over the car's mass, of a wheel where the car is."""
        friction = self.friction
        if self.verges:
            place = x + c * wheel.ahead - s * wheel.left, y + s * wheel.ahead + c * wheel.left
            for verge in self.verges:
                if verge.holds(*place):
                    friction = verge.friction
        return friction * self.gravity * wheel.load

    def pushed(
        self, u: float, v: float, spin: float, x: float, y: float, c: float, s: float
    ) -> "tuple[float, float, float, list[float]]":
        """Acceleration ahead and to the left, moment per mass, and the power that each wheel takes, per mass."""
        ahead = aside = turn = 0.0
        powers: list[float] = []
        level = self.friction * self.gravity
        # written out, as nine tenths of the time of a run pass here
        for wheel in self.wheels:
            grip = self.grip(wheel, x, y, c, s) if self.verges else level * wheel.load
            out, left = wheel.ahead, wheel.left
            ux, uy = u - spin * left, v + spin * out
            cosine, sine = wheel.cosine, wheel.sine
            along, across = cosine * ux + sine * uy, cosine * uy - sine * ux
            lengthwise, crosswise = along * along, across * across
            braking = -wheel.share * grip * along / sqrt(lengthwise + crosswise + NO_SLIP)
            reach = sqrt(crosswise + wheel.slope_squared * lengthwise + NO_SLIP)
            sideways = -wheel.across * grip * across / reach
            fx, fy = cosine * braking - sine * sideways, sine * braking + cosine * sideways
            ahead += fx
            aside += fy
            turn += out * fy - left * fx
            powers.append(-(braking * along + sideways * across))
        return ahead, aside, turn, powers

    def force(
        self, wheel: Wheel, u: float, v: float, x: float, y: float, c: float, s: float
    ) -> "tuple[float, float, float]":
        """Force per mass on a wheel that moves so over the road, along the axes of the body, and its power."""
        grip = self.grip(wheel, x, y, c, s) if self.verges else self.friction * self.gravity * wheel.load
        along = wheel.cosine * u + wheel.sine * v
        across = wheel.cosine * v - wheel.sine * u
        size = sqrt(along * along + across * across + NO_SLIP)
        braking = -wheel.share * grip * along / size
        reach = sqrt(across * across + wheel.slope_squared * along * along + NO_SLIP)
        sideways = -wheel.across * grip * across / reach
        fx, fy = wheel.cosine * braking - wheel.sine * sideways, wheel.sine * braking + wheel.cosine * sideways
        return fx, fy, -(braking * along + sideways * across)

    def standing(self, at: State, least: float, but: int | None) -> int | None:
        """The wheel that hardly moves beside the car, where friction can hold it: the car then turns about it."""
        size = at.size(self.gyration)
        c, s = cos(at.nose), sin(at.nose)
        u, v = c * at.vx + s * at.vy, c * at.vy - s * at.vx
        for index, wheel in enumerate(self.wheels):
            slip = hypot(u - at.spin * wheel.left, v + at.spin * wheel.ahead)
            if slip < least * size and index != but:
                pivot = self.pivot(at, index)
                if self._holds(at, index, pivot, pivot.spin * pivot.spin):
                    return index
        return None

    def pivot(self, at: State, index: int) -> Pivot:
        """Turning about a wheel, with the moment of momentum about it that the car has."""
        wheel = self.wheels[index]
        c, s = cos(at.nose), sin(at.nose)
        u, v = c * at.vx + s * at.vy, c * at.vy - s * at.vx
        dx, dy = -wheel.ahead, -wheel.left
        inertia = self.gyration * self.gyration + dx * dx + dy * dy
        spin = (self.gyration * self.gyration * at.spin + dx * v - dy * u) / inertia
        sense = 1.0 if spin > 0.0 else -1.0
        moments = []
        for other, one in enumerate(self.wheels):
            ahead, left = one.ahead + dx, one.left + dy
            power = 0.0 if other == index else self.force(one, -sense * left, sense * ahead, at.x, at.y, c, s)[2]
            moments.append(power)
        pivot = Pivot(spin, sum(moments) / inertia, (dx, dy), moments)
        if not self._holds(at, index, pivot, 0.0):
            pivot.end = sqrt(halved(lambda x: not self._holds(at, index, pivot, x), 0.0, spin * spin, HALVINGS)[1])
        return pivot

    def _holds(self, at: State, index: int, pivot: Pivot, square: float) -> bool:
        """Whether friction holds the wheel while the car turns about it with this square of its spin."""
        wheel = self.wheels[index]
        c, s = cos(at.nose), sin(at.nose)
        sense = 1.0 if pivot.spin > 0.0 else -1.0
        dx, dy = pivot.arm
        rate = -sense * pivot.rate
        fx, fy = -rate * dy - square * dx, rate * dx - square * dy
        for other, one in enumerate(self.wheels):
            if other != index:
                ahead, left = one.ahead + dx, one.left + dy
                more = self.force(one, -sense * left, sense * ahead, at.x, at.y, c, s)
                fx, fy = fx - more[0], fy - more[1]
        grip = self.grip(wheel, at.x, at.y, c, s)
        along, across = wheel.cosine * fx + wheel.sine * fy, wheel.cosine * fy - wheel.sine * fx
        if wheel.share == 1.0:
            return hypot(along, across) <= grip
        if wheel.share == 0.0:
            return abs(across) <= grip and along == 0.0
        part = along / (wheel.share * grip)
        rest = 1.0 - part * part
        reach = wheel.across * grip
        return bool(
            rest >= 0.0 and across * across * (rest + wheel.slope_squared * part * part) <= reach * reach * rest
        )
