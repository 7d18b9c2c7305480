"""The equations of motion of a scene: masses, joints and forces in one linear system for accelerations and reactions.

Coordinates are those of the mass centres and the angles of the bodies: M·a + Jᵀλ = Q, J·a = γ.
"""

import numpy as np
from scipy.linalg.lapack import dgesv

from dynamics_cli.motion.bodies.build import Built
from dynamics_cli.motion.bodies.frame import Frame

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.records import Scene


class SingularError(ArithmeticError):
    """Accelerations are not determined at this state."""


class System(Built):
    """A scene whose pose is found; states are q, v, phases of given rates, work of drivers and loads, loss."""

    def __init__(self, scene: "Scene", gravity: float, *, static: bool = False) -> None:
        super().__init__(scene, gravity, static=static)
        self.kept: list[int] = []
        self.left: set[int] = set()
        self.calls = 0

    def arrange(self, kept: "list[int] | None" = None) -> None:
        """Lay out the matrix for the conditions kept: all, or those that are independent."""
        self.parts = [part for joint in self.joints for part in joint.parts]
        self.driven = [part for part in self.parts if getattr(part, "motion", None) is not None]
        phases = [part for part in self.driven if part.motion.of_rate]
        for k, part in enumerate(phases):
            part.phase = k
        self.phases = phases
        self.kept = list(range(self.rows)) if kept is None else kept
        self.place = {row: k for k, row in enumerate(self.kept)}
        end = 3 * self.n
        self.end, self.m = end, len(self.kept)
        self.masses = np.array([x for body in self.bodies for x in (body.mass, body.mass, body.moment)])
        self.weights = [x for body in self.bodies for x in (0.0, -body.mass * self.gravity, 0.0)]
        template = np.zeros((end + self.m, end + self.m), order="F")
        template[range(end), range(end)] = self.masses
        for part in self.parts:
            for row, column, value in part.fixed():
                if row in self.place:
                    r = end + self.place[row]
                    template[r, column] = template[column, r] = value
        self.template = template
        places = [place for part in self.parts for place in part.places()]
        self.mask = np.array([row in self.place for row, _ in places], dtype=bool)
        self.i = np.array([end + self.place[row] for row, _ in places if row in self.place], dtype=int)
        self.j = np.array([column for row, column in places if row in self.place], dtype=int)
        self.whole = self.m == self.rows

    def matrix(self, t: float, f: Frame) -> "tuple[Any, list[float]]":
        """The matrix of the linear system, and what J·a must be."""
        values: list[float] = []
        right: list[float] = []
        for part in self.parts:
            part.add(t, f, values, right)
        a = self.template.copy(order="F")
        entries = np.array(values)
        if not self.whole:
            entries, right = entries[self.mask], [right[row] for row in self.kept]
        a[self.i, self.j] = a[self.j, self.i] = entries
        return a, right

    def frame_of(self, y: "Any") -> Frame:
        """The bodies in a state."""
        return Frame(self.n, self.spots, y.tolist() if hasattr(y, "tolist") else list(y))

    def solved(self, t: float, y: "Any") -> "tuple[Any, Any, list[float]]":
        """Accelerations, multipliers, and the powers of loads and dampers."""
        f = self.frame_of(y)
        a, right = self.matrix(t, f)
        out, power = list(self.weights), [0.0, 0.0]
        for force in self.forces:
            force.add(t, f, out, power)
        _, _, x, info = dgesv(a, np.array(out + right), overwrite_a=1, overwrite_b=1)
        if info:
            raise SingularError
        return x[: self.end], x[self.end :], power

    def rate(self, t: float, y: "Any") -> "Any":
        """Rates of a state."""
        end = self.end
        self.calls += 1
        accelerations, multipliers, power = self.solved(t, y)
        out = np.empty(len(y))
        out[:end] = y[end : 2 * end]
        out[end : 2 * end] = accelerations
        driving = 0.0
        for part in self.driven:
            speed = part.motion.law(t)[1]
            if part.motion.of_rate:
                out[2 * end + part.phase] = speed
            if part.row in self.place:
                driving -= multipliers[self.place[part.row]] * speed
        out[-3:] = driving, *power
        return out

    def gaps(self, t: float, f: Frame) -> "Any":
        """How far the conditions that are kept are missed."""
        every = [gap for part in self.parts for gap in part.gap(t, f)]
        return np.array(every if self.whole else [every[row] for row in self.kept])

    def drives(self, t: float) -> "Any":
        """Prescribed rates of the conditions that are kept."""
        every = [rate for part in self.parts for rate in part.drive(t)]
        return np.array(every if self.whole else [every[row] for row in self.kept])

    def jacobian(self, t: float, f: Frame) -> "Any":
        """Derivatives of the conditions that are kept."""
        return self.matrix(t, f)[0][self.end :, : self.end]

    def projected(self, t: float, y: "Any", gap: float) -> "Any":
        """The state moved onto its conditions, by the masses; `gap` is what may remain."""
        end, out = self.end, y.copy()
        for _ in range(8):
            f = self.frame_of(out)
            missed = self.gaps(t, f)
            a, _ = self.matrix(t, f)
            slipped = a[end:, :end] @ out[end : 2 * end] - self.drives(t)
            right = np.zeros((end + self.m, 2), order="F")
            right[end:, 0], right[end:, 1] = -missed, -slipped
            _, _, x, info = dgesv(a, right, overwrite_a=1, overwrite_b=1)
            if info:
                raise SingularError
            out[:end] += x[:end, 0]
            out[end : 2 * end] += x[:end, 1]
            if np.abs(missed).max(initial=0.0) <= gap:
                break
        return out

    def energies(self, y: "Any") -> "tuple[float, float]":
        """Kinetic and potential energy."""
        f = self.frame_of(y)
        kinetic = 0.5 * float((self.masses * np.array(f.v) ** 2).sum())
        high = sum(body.mass * y[3 * k + 1] for k, body in enumerate(self.bodies))
        return kinetic, self.gravity * float(high) + sum(force.energy(f) for force in self.forces)

    def multipliers(self, t: float, y: "Any") -> "list[float]":
        """A multiplier for every condition; those that are left out have none."""
        found = self.solved(t, y)[1]
        return [float(found[self.place[row]]) if row in self.place else 0.0 for row in range(self.rows)]
