"""Kane's method: partial velocities, generalized active and inertia forces, as vectors."""

from math import hypot

from dynamics_cli.errors import require
from dynamics_cli.motion.equations.records import ORIGIN
from dynamics_cli.motion.equations.system import NOWHERE
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.vectors import add, cross, dot, scale, subtract

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any

    from dynamics_cli.motion.equations.system import System

    Three = tuple[float, float, float]

# The share of its terms that a sum must exceed: a few roundings.
ROUNDING = 1e-15


def coefficient(value: "Any", order: int) -> "Any":
    """The Taylor coefficient of a jet; a plain number is constant."""
    if isinstance(value, Jet):
        return value.parts[order]
    return value if order == 0 else 0.0


def coefficients(vector: "Any", order: int) -> "Any":
    """Those of a vector."""
    return tuple(coefficient(part, order) for part in vector)


class Load:
    """A force with its partial velocities, or a moment with its partial angular velocities, or both.

    After the partial velocities stands the velocity itself, whose share is the power.
    """

    def __init__(
        self, name: str, sort: str, force: "Three | None", velocities: "list[Three]", moment: "Three | None" = None,
        turns: "list[Three] | None" = None,
    ) -> None:  # fmt: skip
        self.name, self.sort = name, sort
        self.force, self.velocities = force, velocities
        self.moment, self.turns = moment, turns or []

    def share(self, r: int) -> float:
        """What it contributes to the generalized force of a coordinate."""
        total = dot(self.force, self.velocities[r]) if self.force is not None else 0.0
        return total + (dot(self.moment, self.turns[r]) if self.moment is not None else 0.0)

    def size(self, r: int) -> float:
        """The size of the terms of that sum: components that cancel have the rounding of their vectors."""
        pairs = ((self.force, self.velocities), (self.moment, self.turns))
        return sum(_length(load) * _length(ways[r]) for load, ways in pairs if load is not None)


def generalized(loads: "Iterable[Load]", r: int) -> float:
    """The generalized force of a coordinate; what rounding leaves of terms that cancel is zero."""
    loads = list(loads)
    total = sum(load.share(r) for load in loads)
    return total if abs(plain(total)) > ROUNDING * sum(load.size(r) for load in loads) else 0.0 * total


def _length(vector: "Three") -> float:
    return hypot(*map(plain, vector))


class Kane:
    """The scene at an instant; accelerations with all second derivatives of coordinates zero are `rest`."""

    def __init__(self, system: "System", q: "list[float]", rates: "list[float]", time: float, gravity: float) -> None:
        self.system, self.rates, self.gravity = system, rates, gravity
        names = system.names
        self.numbers: dict[str, Any] = dict(zip(names, q, strict=True)) | {"t": time}
        along: dict[str, Any] = {name: Jet([x, w, 0.0]) for name, x, w in zip(names, q, rates, strict=True)}
        along["t"] = Jet([time, 1.0, 0.0])
        self.along = along
        self.each: list[dict[str, Any]] = [
            self.numbers | {"t": Jet([time, 0.0]), name: Jet.variable(self.numbers[name], 1)} for name in names
        ]
        places = {name: system.place(name, along) for name in system.places}
        self.place = {name: coefficients(at, 0) for name, at in places.items()} | {ORIGIN: NOWHERE}
        self.rest = {name: scale(2.0, coefficients(at, 2)) for name, at in places.items()}
        # by the coordinates, and at last by the motion: the velocity itself
        self.partial: dict[str, list[Three]] = {
            name: [coefficients(system.place(name, each), 1) for each in (*self.each, along)] for name in system.places
        }
        self.partial[ORIGIN] = [NOWHERE] * (len(names) + 1)
        self.turning: dict[str, Three] = {}
        self.partial_spin: dict[str, list[Three]] = {}
        for name in system.bodies:
            self._turn(name)
        self.loads = self._loads()

    def _turn(self, name: str) -> None:
        system = self.system
        turning: Any = NOWHERE
        for angle, axis in system.axes(name, self.along):
            rate, second = coefficient(angle, 1), 2.0 * coefficient(angle, 2)
            turning = add(turning, add(scale(second, coefficients(axis, 0)), scale(rate, coefficients(axis, 1))))
        self.turning[name] = turning
        made = []
        for each in (*self.each, self.along):
            total: Any = NOWHERE
            for angle, axis in system.axes(name, each):
                total = add(total, scale(coefficient(angle, 1), coefficients(axis, 0)))
            made.append(total)
        self.partial_spin[name] = made

    def inertia(self, name: str, vector: "Any") -> "Any":
        """The central inertia of a body times a vector in space."""
        columns = [self.system.turned(name, unit, self.numbers) for unit in ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0))]
        total: Any = NOWHERE
        for moment, column in zip(self.system.moments[name], columns, strict=True):
            total = add(total, scale(moment * dot(column, vector), column))
        return total

    def inertia_load(self, name: str, seconds: "list[float]") -> Load:
        """The inertia force and moment of a body for these second derivatives of the coordinates."""
        body = self.system.bodies[name]
        acceleration, turning = self.rest[name], self.turning[name]
        # the last is the velocity itself
        for second, v, w in zip(seconds, self.partial[name], self.partial_spin[name], strict=False):
            acceleration, turning = add(acceleration, scale(second, v)), add(turning, scale(second, w))
        spin = self.partial_spin[name][-1]
        moment = add(self.inertia(name, turning), cross(spin, self.inertia(name, spin)))
        return Load(name, "inertia", scale(-body.mass, acceleration), self.partial[name], scale(-1.0, moment),
                    self.partial_spin[name])  # fmt: skip

    def masses(self) -> "list[list[float]]":
        """The mass matrix: Σ m·v_r·v_s + ω_r·I·ω_s."""
        n = len(self.rates)
        matrix = [[0.0] * n for _ in range(n)]
        for name, body in self.system.bodies.items():
            v, w = self.partial[name], self.partial_spin[name]
            momenta = [self.inertia(name, one) for one in w]
            for r in range(n):
                for s in range(n):
                    matrix[r][s] += body.mass * dot(v[r], v[s]) + dot(w[r], momenta[s])
        return matrix

    def kinetic(self, name: str) -> float:
        """Kinetic energy of a body."""
        v, w = self.partial[name][-1], self.partial_spin[name][-1]
        return 0.5 * self.system.bodies[name].mass * dot(v, v) + 0.5 * dot(w, self.inertia(name, w))

    def _loads(self) -> "list[Load]":
        system, scene = self.system, self.system.scene
        given = self.numbers | {f"{name}_dot": w for name, w in zip(system.names, self.rates, strict=True)}
        made = []
        if system.up is not None:
            for body in scene.bodies:
                force: Any = tuple(-body.mass * self.gravity if k == system.up else 0.0 for k in range(3))
                made.append(Load(body.name, "weight", force, self.partial[body.name]))
        for one in scene.forces:
            force = system.three(one.name, system.forces[one.name], given)
            made.append(Load(one.name, "force", force, self.partial[one.at]))
        for turner in scene.torques:
            moment = scale(system.value(turner.name, system.torques[turner.name], given), _unit(turner))  # type: ignore[arg-type]
            turns = self.partial_spin[turner.body]
            if turner.against:
                turns = [subtract(a, b) for a, b in zip(turns, self.partial_spin[turner.against], strict=True)]
            made.append(Load(turner.name, "torque", None, [], moment, turns))
        return [*made, *self._springs()]

    def _springs(self) -> "list[Load]":
        system, scene = self.system, self.system.scene
        made = []
        for one in scene.springs:
            way = subtract(self.place[one.end], self.place[one.start])
            length = sqrt(dot(way, way))
            slack = one.free_length == 0.0 and one.damping == 0.0
            require(length > 0.0 or slack, "{name} has no length at this instant, so that its direction is unknown",
                    name=one.name, code="no-direction", hint="move an end, or the instant")  # fmt: skip
            velocities = [subtract(a, b) for a, b in zip(self.partial[one.end], self.partial[one.start], strict=True)]
            force = scale(-one.stiffness, way)
            if length > 0.0:
                pull = one.stiffness * one.free_length - one.damping * dot(velocities[-1], way) / length
                force = add(force, scale(pull / length, way))
            made.append(Load(one.name, "spring", force, velocities))
        for twist in scene.torsion_springs:
            law: Any = system.twists[twist.name]
            angle = system.value(twist.name, law, self.along)
            moment = -twist.stiffness * (coefficient(angle, 0) - twist.free_angle)
            moment -= twist.damping * coefficient(angle, 1)
            slopes = [coefficient(system.value(twist.name, law, each), 1) for each in (*self.each, self.along)]
            made.append(Load(twist.name, "spring", None, [], (0.0, 0.0, moment), [(0.0, 0.0, x) for x in slopes]))
        return made


def _unit(turner: "Any") -> "Three":
    size = sqrt(dot(turner.axis, turner.axis))
    require(size > 0.0, "{name}: its axis is a zero vector", name=turner.name, code="zero-vector",
            hint="0, 0, 1 is the axis of a torque in the plane")  # fmt: skip
    return (turner.axis[0] / size, turner.axis[1] / size, turner.axis[2] / size)
