"""Accelerations within loops in one plane, by complex numbers: all pins at right angles to it, all slides within it.

Places and arms are those of the start, turned with their bodies. Out of the plane joints hold what acts.
"""

from cmath import rect

from dynamics_cli.multibody.motions.guided import eliminated, reduced_rates
from dynamics_cli.multibody.motions.planar_forces import PlanarLoad, PlanarSpring
from dynamics_cli.numerics.trees.tree import BALL, FIXED, PRISMATIC
from dynamics_cli.numerics.vectors import cross, dot, length, subtract, times

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.multibody.bodies.loops import Loops
    from dynamics_cli.multibody.motions.drives import Drives
    from dynamics_cli.numerics.vectors import Vector

# Axes count as parallel within this angle [rad].
PARALLEL = 1e-13


class Part:
    """A link in the plane: its arm from the carrier's origin, its mass centre, its axis or its way."""

    __slots__ = ("arm", "centre", "first", "inertia", "mass", "parent", "rotor", "sign", "start", "way")

    parent: int
    first: int
    arm: complex
    centre: complex
    way: complex
    sign: float
    start: float
    mass: float
    inertia: float
    rotor: float


def normal_of(loops: "Loops") -> "Vector | None":
    """The direction that all pins have, and no slide; None where bodies do not move in one plane."""
    system = loops.system
    axes = [
        (link.joint, times(system.ground[k][0], link.axis))
        for k, link in enumerate(system.tree.links)
        if link.joint != FIXED
    ]
    axes += [
        ("pin", times(system.ground[one.first][0], cross(*one.across)))
        for one in loops.closures
        if one.across and one.first >= 0
    ]
    normal = next((axis for joint, axis in axes if joint not in (PRISMATIC, BALL)), None)
    if normal is None or any(one.first < 0 for one in loops.closures):
        return None
    for joint, axis in axes:
        if joint == BALL:
            return None
        off = abs(dot(axis, normal)) if joint == PRISMATIC else length(cross(axis, normal))
        if off > PARALLEL:
            return None
    return normal


class Planar:
    """A system with loops in one plane; makes no use of where the system stands later."""

    def __init__(self, loops: "Loops", normal: "Vector", drives: "Drives | None" = None) -> None:
        system = loops.system
        self.drives = drives
        # power of loads and dampers, and efforts of drives and loops, at the last state
        self.power = 0.0
        self.missing: list[float] = []
        k = min(range(3), key=lambda i: abs(normal[i]))
        east = cross(normal, (float(k == 0), float(k == 1), float(k == 2)))
        size = length(east)
        east = (east[0] / size, east[1] / size, east[2] / size)
        north = cross(normal, east)

        def flat(v: "Vector") -> complex:
            return complex(dot(v, east), dot(v, north))

        self.weight = flat(system.base)
        self.columns: list[float] = loops.column_scales.tolist()
        self.scale = 1.0 / loops.size
        self.parts: list[Part] = []
        for k, link in enumerate(system.tree.links):
            turn, origin = system.ground[k]
            part = Part()
            part.parent, part.mass, part.rotor, part.first = link.parent, link.mass, link.rotor, link.first
            before = system.ground[link.parent][1] if link.parent >= 0 else (0.0, 0.0, 0.0)
            part.arm, part.centre = flat(subtract(origin, before)), flat(times(turn, link.centroid))
            axis = times(turn, link.axis)
            part.way = flat(axis) if link.joint == PRISMATIC else 0j
            part.sign = 0.0 if link.joint in (PRISMATIC, FIXED) else 1.0 if dot(axis, normal) > 0.0 else -1.0
            part.start = system.coordinates[link.place] if link.joint != FIXED else 0.0
            across = (dot(normal, column) for column in zip(*turn, strict=True))
            own: Vector = tuple(across)  # type: ignore[assignment]
            part.inertia = dot(own, times(link.tensor, own))
            self.parts.append(part)
        scene = system.scene
        self.acting: list[PlanarLoad | PlanarSpring] = [
            *(PlanarLoad(system, load, flat, normal) for load in scene.loads),
            *(PlanarSpring(system, spring, flat, normal) for spring in system.between),
        ]
        # the points of every loop, from the origins of their bodies
        self.ends = [
            tuple(
                (k, flat(times(system.ground[k][0], at)) if k >= 0 else flat(at))
                for k, at in zip((one.first, one.second), one.at, strict=True)
            )
            for one in loops.closures
        ]

    def accelerations(
        self, q: "Sequence[float]", y: "Sequence[float]", efforts: "Sequence[float]", time: float = 0.0
    ) -> "list[float]":
        """Rates of the speeds at coordinates and speeds (both in the order of the links)."""
        self._place(q, y)
        count = len(self.columns)
        matrix, bias = self._matrix(count)
        conditions = self._conditions(count)
        if self.drives is not None:
            conditions += self.drives.conditions(time, self.columns)
        left = [effort - held for effort, held in zip(efforts, bias, strict=True)]
        rates = reduced_rates(eliminated(conditions, count), self.columns, matrix, left)
        if self.drives is not None:
            self.missing = [
                sum([a * b for a, b in zip(row, rates, strict=True)]) - given
                for row, given in zip(matrix, left, strict=True)
            ]
        return rates

    def _place(self, q: "Sequence[float]", y: "Sequence[float]") -> None:
        """Turn, origin, angular velocity and acceleration without rates of the speeds, of every link."""
        self.turns: list[complex] = []
        self.origins: list[complex] = []
        self.omegas: list[float] = []
        self.drifts: list[complex] = []
        self.velocities: list[complex] = []
        self.ways: list[complex] = []
        for part in self.parts:
            k = part.parent
            velocity = self.velocities[k] if k >= 0 else 0j
            turn, origin, omega, drift = (
                (self.turns[k], self.origins[k], self.omegas[k], self.drifts[k])
                if k >= 0
                else (1.0, 0.0, 0.0, self.weight)
            )
            arm, way = turn * part.arm, turn * part.way
            if part.way:
                velocity += way * y[part.first]
                arm += way * (q[part.first] - part.start)
                drift += 2j * omega * y[part.first] * way
            drift -= omega * omega * arm
            velocity += 1j * omega * arm
            if part.sign:
                turn *= rect(1.0, part.sign * (q[part.first] - part.start))
                omega += part.sign * y[part.first]
            self.turns.append(turn)
            self.origins.append(origin + arm)
            self.omegas.append(omega)
            self.drifts.append(drift)
            self.velocities.append(velocity)
            self.ways.append(way)

    def _matrix(self, count: int) -> "tuple[list[list[float]], list[float]]":
        """Mass matrix by composite bodies, and the efforts that weight and speeds alone take."""
        parts, origins = self.parts, self.origins
        matrix = [[0.0] * count for _ in range(count)]
        bias = [0.0] * count
        # of all that a link carries, about its origin: mass, first and second moment, force and moment
        masses = [part.mass for part in parts]
        firsts, seconds, forces, moments = [], [], [], []
        for part, turn, omega, drift in zip(parts, self.turns, self.omegas, self.drifts, strict=True):
            centre = turn * part.centre
            first = part.mass * centre
            force = part.mass * (drift - omega * omega * centre)
            firsts.append(first)
            seconds.append(part.inertia + part.mass * (centre.real**2 + centre.imag**2))
            forces.append(force)
            moments.append(centre.real * force.imag - centre.imag * force.real)
        self.power = 0.0
        for one in self.acting:
            pushes, power = one.pushes(self.turns, origins, self.velocities, self.omegas)
            self.power += power
            for k, arm, push, moment in pushes:
                forces[k] -= push
                moments[k] -= arm.real * push.imag - arm.imag * push.real + moment
        for k in range(len(parts) - 1, -1, -1):
            part = parts[k]
            if part.sign or part.way:
                way = self.ways[k]
                if part.sign:
                    momentum, spin = 1j * part.sign * firsts[k], part.sign * seconds[k]
                    bias[part.first] = part.sign * moments[k]
                else:
                    momentum, spin = masses[k] * way, firsts[k].real * way.imag - firsts[k].imag * way.real
                    bias[part.first] = way.real * forces[k].real + way.imag * forces[k].imag
                self._felt(matrix, k, momentum, spin)
                matrix[part.first][part.first] += part.rotor
            if part.parent >= 0:
                n = part.parent
                arm = origins[k] - origins[n]
                seconds[n] += (
                    seconds[k]
                    + 2.0 * (arm.real * firsts[k].real + arm.imag * firsts[k].imag)
                    + masses[k] * (arm.real**2 + arm.imag**2)
                )
                firsts[n] += firsts[k] + masses[k] * arm
                masses[n] += masses[k]
                forces[n] += forces[k]
                moments[n] += moments[k] + arm.real * forces[k].imag - arm.imag * forces[k].real
        return matrix, bias

    def _felt(self, matrix: "list[list[float]]", k: int, momentum: complex, spin: float) -> None:
        """Write row and column of one speed: its momentum, seen from every joint below."""
        place, origin = self.parts[k].first, self.origins[k]
        while k >= 0:
            part = self.parts[k]
            if part.sign:
                arm = origin - self.origins[k]
                felt = part.sign * (spin + arm.real * momentum.imag - arm.imag * momentum.real)
                matrix[place][part.first] = matrix[part.first][place] = felt
            elif part.way:
                way = self.ways[k]
                matrix[place][part.first] = matrix[part.first][place] = (
                    way.real * momentum.real + way.imag * momentum.imag
                )
            k = part.parent

    def _conditions(self, count: int) -> "list[list[float]]":
        """Two conditions of every loop on the rates of the speeds, free of units."""
        out = []
        for ends in self.ends:
            east, north, drift = [0.0] * (count + 1), [0.0] * (count + 1), 0j
            for (k, at), sign in zip(ends, (self.scale, -self.scale), strict=True):
                if k < 0:
                    drift += sign * self.weight
                    continue
                arm = self.turns[k] * at
                point = self.origins[k] + arm
                drift += sign * (self.drifts[k] - self.omegas[k] ** 2 * arm)
                while k >= 0:
                    part = self.parts[k]
                    if part.sign or part.way:
                        moving = 1j * part.sign * (point - self.origins[k]) if part.sign else self.ways[k]
                        moving *= sign * self.columns[part.first]
                        east[part.first] += moving.real
                        north[part.first] += moving.imag
                    k = part.parent
            east[count], north[count] = -drift.real, -drift.imag
            out += [east, north]
        return out
