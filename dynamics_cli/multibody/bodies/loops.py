"""Joints that close loops: their conditions on places and speeds, and motion within them.

Lengths are counted in sizes of the scene, so that angles and lengths stand beside each other.
"""

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.multibody.bodies.results import Reaction, reaction_rows
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.orientation.rotations import IDENTITY
from dynamics_cli.numerics.trees.matrix import mass_matrix, partial
from dynamics_cli.numerics.trees.newton_euler import at_point, back, inverse, sweep
from dynamics_cli.numerics.trees.tree import ZERO, moved, placed, poses
from dynamics_cli.numerics.vectors import add, cross, dot, length, subtract, times
from dynamics_cli.quantities import Distance

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.multibody.bodies.records import Loop
    from dynamics_cli.multibody.bodies.system import System
    from dynamics_cli.numerics.trees.newton_euler import Motion, Wrench
    from dynamics_cli.numerics.trees.tree import Pose
    from dynamics_cli.numerics.vectors import Vector

# A condition counts where its singular value is above this share of the largest.
COUNTS = 1e-10
# Loops are closed where their gaps are below this share of the scene's size; a start this far off is moved.
CLOSED = 1e-13
STEPS, DAMPING = 60, 0.1
# Rounding of a unit force that no condition determines.
UNKNOWN = 1e-9
STILL = (IDENTITY, ZERO)


class Closure:
    """One loop: its bodies, the point on each, and two directions across its pin."""

    def __init__(self, system: "System", loop: "Loop", number: int) -> None:
        self.name = f"{loop.first} on {loop.second}"
        self.first, self.second = system.body_link(loop.first), system.body_link(loop.second)
        require(self.first != self.second, "loop {number} joins {body} to itself", number=number, body=loop.first,
                code="loop", hint="name two bodies")  # fmt: skip
        self.at = loop.first_at, loop.second_at
        self.across: tuple[Vector, ...] = ()
        self.along = ZERO
        if loop.axis is not None:
            size = length(loop.axis)
            require(size > 0.0, "the axis of loop {number} is the zero vector", number=number, code="direction",
                    hint="for example 0, 1, 0")  # fmt: skip
            axis = (loop.axis[0] / size, loop.axis[1] / size, loop.axis[2] / size)
            self.across = _across(axis)
            # the same axis in the second body, as the scene stands
            turn, there = _frame(system.ground, self.first)[0], _frame(system.ground, self.second)[0]
            self.along = back(there, times(turn, axis))

    def rows(self, system: "System", ground: "list[Pose]") -> "list[list[float]]":
        """Velocity of the first point against the second, and rates across the pin, per unit of every speed."""
        points = self._point(ground, 0), self._point(ground, 1)
        ways = [
            partial(system.tree, ground, k, point) if k >= 0 else [(ZERO, ZERO)] * system.tree.speeds
            for k, point in zip((self.first, self.second), points, strict=True)
        ]
        columns = [(subtract(a[1], b[1]), subtract(a[0], b[0])) for a, b in zip(*ways, strict=True)]
        directions = self.directions(ground)
        out = [[column[0][k] for column in columns] for k in range(3)]
        return out + [[dot(direction, column[1]) for column in columns] for direction in directions]

    def directions(self, ground: "list[Pose]") -> "list[Vector]":
        """The two directions across the pin, in ground axes."""
        return [times(_frame(ground, self.first)[0], direction) for direction in self.across]

    def gaps(self, ground: "list[Pose]") -> "list[float]":
        """How far it is open."""
        off = subtract(self._point(ground, 0), self._point(ground, 1))
        along = times(_frame(ground, self.second)[0], self.along)
        # a turn by a small angle about t moves the axis along by t × axis; so does the gap of a condition on it
        axis = times(_frame(ground, self.first)[0], cross(*self.across)) if self.across else ZERO
        turned = cross(along, axis)
        return [*off, *(dot(direction, turned) for direction in self.directions(ground))]

    def drift(self, ground: "list[Pose]", motions: "list[Motion]") -> "list[float]":
        """What the conditions' second derivatives are without rates of the speeds."""
        ends = []
        for k, point in ((self.first, self.at[0]), (self.second, self.at[1])):
            if k < 0:
                ends.append((ZERO, ZERO, ZERO))
                continue
            turn, (omega, alpha, _, _) = ground[k][0], motions[k]
            moving = at_point(motions[k], point)[1]
            ends.append((times(turn, moving), times(turn, alpha), times(turn, omega)))
        (moving, alpha, omega), second = ends
        spin, turning = subtract(omega, second[2]), subtract(alpha, second[1])
        across = (dot(direction, turning) + dot(cross(omega, direction), spin) for direction in self.directions(ground))
        return [*subtract(moving, second[0]), *across]

    def wrenches(self, ground: "list[Pose]", parts: "list[float]") -> "tuple[Vector, Vector]":
        """Force and moment on the first body at the point, in ground axes."""
        moment = ZERO
        for size, direction in zip(parts[3:], self.directions(ground), strict=True):
            moment = add(moment, (size * direction[0], size * direction[1], size * direction[2]))
        return (parts[0], parts[1], parts[2]), moment

    def loads(self, ground: "list[Pose]", force: "Vector", moment: "Vector") -> "list[tuple[int, Wrench]]":
        """The same on both bodies, in their own axes about their own origins."""
        out = []
        for k, point, sign in ((self.first, self.at[0], 1.0), (self.second, self.at[1], -1.0)):
            if k >= 0:
                turn = ground[k][0]
                f, n = (back(turn, (sign * v[0], sign * v[1], sign * v[2])) for v in (force, moment))
                out.append((k, (f, add(n, cross(point, f)))))
        return out

    def _point(self, ground: "list[Pose]", side: int) -> "Vector":
        turn, origin = _frame(ground, (self.first, self.second)[side])
        return add(origin, times(turn, self.at[side]))


def _open(force: "Vector", moment: "Vector") -> "set[str]":
    """The components that are there."""
    parts = zip(("Fx", "Fy", "Fz", "Mx", "My", "Mz"), (*force, *moment), strict=True)
    return {word for word, part in parts if abs(part) > UNKNOWN}


def _frame(ground: "list[Pose]", k: int) -> "Pose":
    return ground[k] if k >= 0 else STILL


def _across(axis: "Vector") -> "tuple[Vector, Vector]":
    """Two unit vectors at right angles to an axis and to each other, so that their cross product is the axis."""
    k = min(range(3), key=lambda i: abs(axis[i]))
    first = cross(axis, (float(k == 0), float(k == 1), float(k == 2)))
    size = length(first)
    first = (first[0] / size, first[1] / size, first[2] / size)
    return first, cross(axis, first)


class Loops:
    """All loops of a system."""

    def __init__(self, system: "System") -> None:
        self.system = system
        self.closures = [Closure(system, loop, n) for n, loop in enumerate(system.scene.loops, 1)]
        spans = [length(link.position) for link in system.tree.links] + [
            length(point) for closure in self.closures for point in closure.at
        ]
        self.size = max(spans, default=0.0) or 1.0
        row_scale = [1.0 / self.size] * 3
        self.row_scales = np.array(
            [x for closure in self.closures for x in (*row_scale, *(1.0 for _ in closure.across))]
        )
        self.column_scales = np.array([1.0 if turns else self.size for turns in system.turning])

    def jacobian(self, ground: "list[Pose]") -> "Any":
        """The conditions on the speeds, free of units."""
        rows = [row for closure in self.closures for row in closure.rows(self.system, ground)]
        return np.array(rows) * self.row_scales[:, None] * self.column_scales

    def gaps(self, ground: "list[Pose]") -> "Any":
        """How far the loops are open, free of units."""
        return np.array([gap for closure in self.closures for gap in closure.gaps(ground)]) * self.row_scales

    def close(self) -> float:
        """Move the system until its loops close; returns the largest move, in sizes of the scene and rad.

        Joints without a place in the scene move first, then all. Refuses loops that do not close, with their gap.
        """
        start = list(self.system.coordinates)
        for free in ([not given for given in self.system.placed], [True] * len(self.system.placed)):
            moves = self._closed(start, np.array(free))
            if moves is not None:
                return float(np.abs(moves).max(initial=0.0))
            self.system.at(list(start), self.system.speeds)
        require(False, "the loops do not close: a gap of {gap} remains", gap=(self._least(start), Distance),
                code="open-loop", hint="check lengths and points, or give places nearer to closed ones")  # fmt: skip
        return 0.0

    def _least(self, start: "list[float]") -> float:
        """The least gap that can be reached from here."""
        from scipy.optimize import least_squares

        def gaps(way: "Any") -> "Any":
            self.system.at(moved(self.system.tree, start, (way * self.column_scales).tolist()), self.system.speeds)
            return self.gaps(self.system.ground)

        nearest: Any = least_squares(gaps, np.zeros(len(self.column_scales)))
        return float(np.linalg.norm(nearest.fun)) * self.size

    def _closed(self, start: "list[float]", free: "Any") -> "Any":
        system, coordinates = self.system, list(start)
        total = np.zeros(len(self.column_scales))
        for _ in range(STEPS):
            gaps = self.gaps(system.ground)
            if float(np.abs(gaps).max()) < CLOSED:
                return total
            if not free.any():
                return None
            way = np.zeros(len(self.column_scales))
            b = self.jacobian(system.ground)[:, free]
            # Levenberg's damping goes with the gap: it keeps the last steps quadratic
            damping = DAMPING * float(gaps @ gaps) * np.eye(len(gaps))
            way[free] = -b.T @ np.linalg.lstsq(b @ b.T + damping, gaps, rcond=1e-17)[0]
            way *= min(1.0, 0.5 / max(float(np.abs(way).max()), 1e-300))
            total += way
            coordinates = moved(system.tree, coordinates, (way * self.column_scales).tolist())
            system.at(coordinates, system.speeds)
            if float(np.abs(way).max()) < 1e-16:
                break
        return total if float(np.abs(self.gaps(system.ground)).max()) < 1e3 * CLOSED else None

    def settle(self) -> float:
        """Give the speeds that the loops allow; returns the largest change of a speed that the scene gives.

        Speeds that it leaves out follow from the others; where these contradict each other, all change, by as little
        kinetic energy as possible.
        """
        system = self.system
        b = self.jacobian(system.ground)
        given = np.array(system.moving)
        y = np.array(system.speeds) / self.column_scales
        if not np.any(y):
            return 0.0
        kept = np.where(given, y, 0.0)
        if not given.all():
            kept[~given] = -np.linalg.lstsq(b[:, ~given], b @ kept, rcond=1e-9)[0]
        if float(np.abs(b @ kept).max()) > 1e-12 * float(np.abs(y).max()):
            kept = self._nearest(b, y)
        change = float(np.abs((kept - y)[given]).max(initial=0.0))
        system.at(system.coordinates, (kept * self.column_scales).tolist())
        return change

    def restore(self) -> float:
        """Put places and speeds of a motion back onto the loops; returns the largest gap before, in sizes."""
        system = self.system
        gap = float(np.abs(self.gaps(system.ground)).max())
        self._closed(list(system.coordinates), np.ones(len(self.column_scales), dtype=bool))
        y = self._nearest(self.jacobian(system.ground), np.array(system.speeds) / self.column_scales)
        system.at(system.coordinates, (y * self.column_scales).tolist())
        return gap

    def _nearest(self, b: "Any", y: "Any") -> "Any":
        """The speeds that the loops allow, with the least kinetic energy of the difference."""
        complement, m = self._parts(b)[3], self._masses()
        allowed = np.linalg.lstsq(complement.T @ m @ complement, complement.T @ m @ y, rcond=1e-13)[0]
        return complement @ allowed

    def _masses(self) -> "Any":
        """The mass matrix, lengths in sizes of the scene."""
        masses = np.array(mass_matrix(self.system.tree, self.system.frames))
        return masses * np.outer(self.column_scales, self.column_scales)

    def parts(self) -> "tuple[Any, Any, Any, Any]":
        """The conditions that count where the system stands, and the ways left free."""
        return self._parts(self.jacobian(self.system.ground))

    def _parts(self, b: "Any") -> "tuple[Any, Any, Any, Any]":
        """The conditions that count: left vectors, singular values, right vectors; and the ways left free."""
        u, s, v = np.linalg.svd(b)
        rank = int((s > COUNTS * s[0]).sum()) if s.size and s[0] > 0.0 else 0
        return u[:, :rank], s[:rank], v[:rank], v[rank:].T

    def require_regular(self) -> None:
        """Refuse a change point, where the loops lose a condition that they have nearby."""
        system = self.system
        here = len(self._parts(self.jacobian(system.ground))[1])
        for n in range(1, 4):
            way = [
                (0.01 + 0.003 * k * n) * (-1.0) ** (k // n) * scale
                for k, scale in enumerate(self.column_scales.tolist())
            ]
            nearby = placed(system.tree, poses(system.tree, moved(system.tree, system.coordinates, way)))
            require(
                len(self._parts(self.jacobian(nearby))[1]) <= here,
                "the loops are at a change point: here they could go on in two ways",
                code="change-point", hint="start a little beside it, on the branch that is meant",
            )  # fmt: skip

    def accelerations(self, efforts: "list[float]") -> "tuple[Any, Any, Any]":
        """Rates of the speeds, the forces of all conditions, and directions in which those are not determined.

        (CᵀM·C)·ż = Cᵀ(F − h − M·ẏ_p), with C the ways that the conditions leave free, ẏ_p any rates that keep them.
        """
        system = self.system
        b = self.jacobian(system.ground)
        left, values, right, free = self._parts(b)
        motions = sweep(system.tree, system.frames, system.speeds)
        drift = (
            -np.array([x for closure in self.closures for x in closure.drift(system.ground, motions)]) * self.row_scales
        )
        particular = right.T @ ((left.T @ drift) / values)
        m = self._masses()
        bias, _ = inverse(system.tree, system.frames, system.speeds, ground=system.base, loads=system.loads)
        force = (np.array(efforts) - np.array(bias)) * self.column_scales
        rates = particular
        if free.shape[1]:
            reduced = free.T @ m @ free
            weak = np.linalg.eigvalsh(reduced)
            require(float(weak[0]) > 1e-13 * max(float(weak[-1]), float(np.abs(m).max())),
                    "nothing resists a motion that the loops leave free", code="no-inertia",
                    hint="give the bodies that move freely mass or a tensor")  # fmt: skip
            rates = particular + free @ np.linalg.solve(reduced, free.T @ (force - m @ particular))
        multipliers = left @ ((right @ (m @ rates - force)) / values)
        nothing = np.eye(len(b)) - left @ left.T
        # a force works on lengths in sizes of the scene
        return rates * self.column_scales, multipliers * self.row_scales, (nothing * self.row_scales).T

    def forces(self, multipliers: "Any") -> "list[tuple[Vector, Vector]]":
        """Force and moment of every loop on its first body, in ground axes."""
        out, place = [], 0
        numbers = [float(plain(x)) for x in multipliers]
        for closure in self.closures:
            count = 3 + len(closure.across)
            out.append(closure.wrenches(self.system.ground, numbers[place : place + count]))
            place += count
        return out

    def reactions(self, multipliers: "Any", nothing: "Any", wrenches: "Sequence[Wrench]") -> "tuple[Reaction, ...]":
        """What the joints of the tree and of the loops transmit, with the components that are not determined."""
        system = self.system
        words: list[set[str]] = [set() for _ in system.tree.links]
        loop_words: list[set[str]] = [set() for _ in self.closures]
        still = [0.0] * system.tree.speeds
        for way in nothing:
            if not float(np.abs(way).max()) > UNKNOWN:
                continue
            _, moved_by = inverse(system.tree, system.frames, still, loads=self.with_loads(way, alone=True))
            for k, (force, moment) in enumerate(moved_by):
                turn = system.ground[k][0]
                words[k] |= _open(times(turn, force), times(turn, moment))
            for k, pair in enumerate(self.forces(way)):
                loop_words[k] |= _open(*pair)
        unknown = [", ".join(sorted(word)) or None for word in words]
        names = [(loop.first, loop.second) for loop in system.scene.loops]
        loops = (
            Reaction(*name, *pair, ", ".join(sorted(word)) or None)
            for name, pair, word in zip(names, self.forces(multipliers), loop_words, strict=True)
        )
        return (*reaction_rows(system, wrenches, unknown), *loops)

    def with_loads(self, multipliers: "Any", *, alone: bool = False) -> "list[Wrench | None]":
        """The loads with the forces of the loops, or these alone."""
        loads: list[Wrench | None] = [None] * len(self.system.loads) if alone else list(self.system.loads)
        for closure, (force, moment) in zip(self.closures, self.forces(multipliers), strict=True):
            for k, (f, n) in closure.loads(self.system.ground, force, moment):
                before = loads[k]
                loads[k] = (f, n) if before is None else (add(before[0], f), add(before[1], n))
        return loads
