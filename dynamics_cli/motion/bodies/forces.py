"""Forces on the bodies: springs with dampers, torsion springs, loads.

Each adds to the generalized forces, and to `power` what loads put in and dampers take out.
"""

from math import hypot

from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from dynamics_cli.motion.bodies.frame import Frame

    Given = Callable[[dict[str, float]], float]

NONE = -1


def _push(f: "Frame", out: "list[float]", spot: int, body: int, fx: float, fy: float) -> None:
    if body != NONE:
        k = 3 * body
        out[k] += fx
        out[k + 1] += fy
        out[k + 2] += f.rx[spot] * fy - f.ry[spot] * fx


class SpringForce:
    """Between two spots: stiffness, free length, damping."""

    def __init__(
        self, name: str, first: "tuple[int, int]", second: "tuple[int, int]", stiffness: float, free: float,
        damping: float,
    ) -> None:  # fmt: skip
        (self.a, self.i), (self.b, self.j) = first, second
        self.name, self.k, self.free, self.d = name, stiffness, free, damping

    def length(self, f: "Frame") -> float:
        """How long it is."""
        return hypot(f.x[self.b] - f.x[self.a], f.y[self.b] - f.y[self.a])

    def tension(self, f: "Frame") -> float:
        """What it pulls with."""
        length = self.length(f)
        return self.k * (length - self.free) + self.d * self._opening(f, length)

    def _opening(self, f: "Frame", length: float) -> float:
        a, b = self.a, self.b
        along = (f.x[b] - f.x[a]) * (f.vx[b] - f.vx[a]) + (f.y[b] - f.y[a]) * (f.vy[b] - f.vy[a])
        return along / length if length else 0.0

    def add(self, t: float, f: "Frame", out: "list[float]", power: "list[float]") -> None:
        """Pull both ends together."""
        a, b, share = self.a, self.b, self.share(f, power)
        fx, fy = share * (f.x[b] - f.x[a]), share * (f.y[b] - f.y[a])
        _push(f, out, a, self.i, fx, fy)
        _push(f, out, b, self.j, -fx, -fy)

    def share(self, f: "Frame", power: "list[float]") -> float:
        """Tension over length."""
        if self.free == 0.0 and self.d == 0.0:
            return self.k
        length = self.length(f)
        require(length > 0.0, "the spring from {name} has no length and so no direction", name=self.name,
                code="no-length", hint="begin elsewhere")  # fmt: skip
        opening = self._opening(f, length)
        power[1] += self.d * opening * opening
        return (self.k * (length - self.free) + self.d * opening) / length

    def energy(self, f: "Frame") -> float:
        """What it stores."""
        return 0.5 * self.k * (self.length(f) - self.free) ** 2


class TorsionForce:
    """Between two bodies."""

    def __init__(self, i: int, j: int, stiffness: float, free: float, damping: float) -> None:
        self.i, self.j, self.k, self.free, self.d = i, j, stiffness, free, damping

    def _twist(self, values: "list[float]") -> float:
        return (values[self.i] if self.i != NONE else 0.0) - (values[self.j] if self.j != NONE else 0.0)

    def add(self, t: float, f: "Frame", out: "list[float]", power: "list[float]") -> None:
        """Turn both back."""
        rate = self._twist(f.w)
        torque = -self.k * (self._twist(f.q[2::3]) - self.free) - self.d * rate
        power[1] += self.d * rate * rate
        for body, sign in ((self.i, 1.0), (self.j, -1.0)):
            if body != NONE:
                out[3 * body + 2] += sign * torque

    def energy(self, f: "Frame") -> float:
        """What it stores."""
        return 0.5 * self.k * (self._twist(f.q[2::3]) - self.free) ** 2


class PointLoad:
    """A force at a spot, along the axes of ground or of a body; `sizes` are a length and a force in SI."""

    def __init__(
        self, spot: "tuple[int, int]", x: "Given | None", y: "Given | None", along: int, sizes: "tuple[float, float]"
    ) -> None:
        self.a, self.i = spot
        self.x, self.y, self.along, self.sizes = x, y, along, sizes

    def add(self, t: float, f: "Frame", out: "list[float]", power: "list[float]") -> None:
        """Push the spot."""
        a, (length, force) = self.a, self.sizes
        given = {"t": t, "x": f.x[a] * length, "y": f.y[a] * length, "vx": f.vx[a] * length, "vy": f.vy[a] * length}
        fx = self.x(given) / force if self.x else 0.0
        fy = self.y(given) / force if self.y else 0.0
        if self.along != NONE:
            c, s = f.c[self.along], f.s[self.along]
            fx, fy = c * fx - s * fy, s * fx + c * fy
        _push(f, out, a, self.i, fx, fy)
        power[0] += fx * f.vx[a] + fy * f.vy[a]

    def energy(self, f: "Frame") -> float:
        """None: its work is counted apart."""
        return 0.0


class TorqueLoad:
    """A torque on a body; `size` is one of them in SI."""

    def __init__(self, body: int, torque: "Given", size: float) -> None:
        self.i, self.torque, self.size = body, torque, size

    def add(self, t: float, f: "Frame", out: "list[float]", power: "list[float]") -> None:
        """Turn the body."""
        w = f.w[self.i]
        torque = self.torque({"t": t, "angle": f.q[3 * self.i + 2], "speed": w}) / self.size
        out[3 * self.i + 2] += torque
        power[0] += torque * w

    def energy(self, f: "Frame") -> float:
        """None: its work is counted apart."""
        return 0.0
