"""Conditions that joints and drivers put on the bodies: their gaps, their derivatives, and what they do to the bodies.

A condition adds its varying derivatives to `values`, in the order of its `places`, and to `right` what the second
derivatives of the coordinates must give. Its multiplier is minus the force on its first body.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.frame import Frame
    from dynamics_cli.motion.bodies.laws import Motion

    Places = list[tuple[int, int]]
    Fixed = list[tuple[int, int, float]]

NONE = -1


class Pin:
    """Two points stay together."""

    size = 2

    def __init__(self, row: int, first: "tuple[int, int]", second: "tuple[int, int]") -> None:
        self.row = row
        (self.a, self.i), (self.b, self.j) = first, second

    def fixed(self) -> "Fixed":
        """Derivatives that do not vary."""
        r = self.row
        signs = [(body, sign) for body, sign in ((self.i, 1.0), (self.j, -1.0)) if body != NONE]
        return [(r + k, 3 * body + k, sign) for body, sign in signs for k in (0, 1)]

    def places(self) -> "Places":
        """Where varying derivatives stand."""
        return [(self.row + k, 3 * body + 2) for body in (self.i, self.j) if body != NONE for k in (0, 1)]

    def gap(self, t: float, f: "Frame") -> "list[float]":
        """How far the condition is missed."""
        return [f.x[self.a] - f.x[self.b], f.y[self.a] - f.y[self.b]]

    def drive(self, t: float) -> "list[float]":
        """Rates that are prescribed."""
        return [0.0, 0.0]

    def add(self, t: float, f: "Frame", values: "list[float]", right: "list[float]") -> None:
        """Derivatives and what second derivatives must give."""
        a, b, rx, ry = self.a, self.b, f.rx, f.ry
        gx = gy = 0.0
        if self.i != NONE:
            values += (-ry[a], rx[a])
            w = f.w[self.i]
            gx, gy = w * w * rx[a], w * w * ry[a]
        if self.j != NONE:
            values += (ry[b], -rx[b])
            w = f.w[self.j]
            gx, gy = gx - w * w * rx[b], gy - w * w * ry[b]
        right += (gx, gy)

    def force(self, f: "Frame", multipliers: "Any") -> "tuple[float, float, float]":
        """Force and couple on the first body, by the second."""
        return -multipliers[self.row], -multipliers[self.row + 1], 0.0


class Along:
    """The position of a point along a direction of a body keeps a value: across a slide zero, or as it is pushed."""

    size = 1

    def __init__(
        self, row: int, point: "tuple[int, int]", start: "tuple[int, int]", way: complex, motion: "Motion | None" = None
    ) -> None:
        self.row = row
        (self.a, self.i), (self.b, self.j) = point, start
        self.way, self.motion = way, motion

    def _way(self, f: "Frame") -> "tuple[float, float]":
        x, y = self.way.real, self.way.imag
        if self.j == NONE:
            return x, y
        c, s = f.c[self.j], f.s[self.j]
        return c * x - s * y, s * x + c * y

    def fixed(self) -> "Fixed":
        """None: the direction may turn."""
        return []

    def places(self) -> "Places":
        """Where varying derivatives stand."""
        return [(self.row, 3 * body + k) for body in (self.i, self.j) if body != NONE for k in (0, 1, 2)]

    def gap(self, t: float, f: "Frame") -> "list[float]":
        """How far the condition is missed."""
        ux, uy = self._way(f)
        at = self.motion.law(t)[0] if self.motion else 0.0
        return [ux * (f.x[self.a] - f.x[self.b]) + uy * (f.y[self.a] - f.y[self.b]) - at]

    def drive(self, t: float) -> "list[float]":
        """Rates that are prescribed."""
        return [self.motion.law(t)[1] if self.motion else 0.0]

    def add(self, t: float, f: "Frame", values: "list[float]", right: "list[float]") -> None:
        """Derivatives and what second derivatives must give."""
        a, b = self.a, self.b
        ux, uy = self._way(f)
        total = self.motion.law(t)[2] if self.motion else 0.0
        if self.i != NONE:
            w = f.w[self.i]
            values += (ux, uy, uy * f.rx[a] - ux * f.ry[a])
            total += w * w * (ux * f.rx[a] + uy * f.ry[a])
        if self.j != NONE:
            w = f.w[self.j]
            dx, dy = f.x[a] - f.x[b], f.y[a] - f.y[b]
            values += (-ux, -uy, ux * dy - uy * dx - uy * f.rx[b] + ux * f.ry[b])
            along = ux * (f.vy[a] - f.vy[b]) - uy * (f.vx[a] - f.vx[b])
            total += w * (w * (ux * (dx - f.rx[b]) + uy * (dy - f.ry[b])) - 2.0 * along)
        right.append(total)

    def force(self, f: "Frame", multipliers: "Any") -> "tuple[float, float, float]":
        """Force and couple on the first body, by the second."""
        ux, uy = self._way(f)
        size = -multipliers[self.row]
        return ux * size, uy * size, 0.0


class Turn:
    """The angle between two bodies keeps a value, or is driven; `phase` is the state that a given rate adds up to."""

    size = 1

    def __init__(self, row: int, i: int, j: int, angle: float = 0.0, motion: "Motion | None" = None) -> None:
        self.row, self.i, self.j = row, i, j
        self.angle, self.motion = angle, motion
        self.phase = NONE

    def fixed(self) -> "Fixed":
        """Derivatives: all that there are."""
        return [(self.row, 3 * body + 2, sign) for body, sign in ((self.i, 1.0), (self.j, -1.0)) if body != NONE]

    def places(self) -> "Places":
        """None varies."""
        return []

    def gap(self, t: float, f: "Frame") -> "list[float]":
        """How far the condition is missed."""
        turned = (f.q[3 * self.i + 2] if self.i != NONE else 0.0) - (f.q[3 * self.j + 2] if self.j != NONE else 0.0)
        if self.motion is None:
            return [turned - self.angle]
        return [turned - (self.angle + f.phases[self.phase] if self.motion.of_rate else self.motion.law(t)[0])]

    def drive(self, t: float) -> "list[float]":
        """Rates that are prescribed."""
        return [self.motion.law(t)[1] if self.motion else 0.0]

    def add(self, t: float, f: "Frame", values: "list[float]", right: "list[float]") -> None:
        """Derivatives and what second derivatives must give."""
        right.append(self.motion.law(t)[2] if self.motion else 0.0)

    def force(self, f: "Frame", multipliers: "Any") -> "tuple[float, float, float]":
        """Force and couple on the first body, by the second."""
        return 0.0, 0.0, -multipliers[self.row]


class Joint:
    """What a user calls one joint: its name, its links, and the conditions that make it."""

    def __init__(self, name: str, kind: str, link: str, by: str, parts: "list[Any]", spot: int = NONE) -> None:
        self.name, self.kind, self.link, self.by = name, kind, link, by
        self.parts, self.spot = parts, spot

    def rows(self) -> "list[int]":
        """The rows of its conditions."""
        return [part.row + k for part in self.parts for k in range(part.size)]

    def force(self, f: "Frame", multipliers: "Any") -> "tuple[float, float, float]":
        """Force and couple on its link, by the other."""
        every = [part.force(f, multipliers) for part in self.parts]
        return sum(e[0] for e in every), sum(e[1] for e in every), sum(e[2] for e in every)
