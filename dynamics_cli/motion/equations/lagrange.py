"""Lagrange's method: the derivatives of the energies and of the power, by jets of jets, without any vector of Kane's.

A coordinate is a jet in time whose coefficients are jets in two small changes; second derivatives are read from them.
"""

from dynamics_cli.motion.equations.system import NOWHERE
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.vectors import cross, dot, subtract

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from dynamics_cli.motion.equations.system import System

UNITS = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class Change:
    """A direction in which coordinates, rates and the time change: one coordinate, one rate, or with the motion."""

    def __init__(self, n: int, place: int = -1, rate: int = -1) -> None:
        self.places = [1.0 if k == place else 0.0 for k in range(n)]
        self.rates = [1.0 if k == rate else 0.0 for k in range(n)]
        self.time = 0.0

    @classmethod
    def motion(cls, rates: "list[float]") -> "Change":
        """With the motion, without accelerations."""
        change = cls(len(rates))
        change.places, change.time = list(rates), 1.0
        return change


class Lagrange:
    """Second derivatives of T, slopes of V and of the power of all other loads, at an instant."""

    def __init__(self, system: "System", q: "list[float]", rates: "list[float]", time: float, gravity: float) -> None:
        self.system, self.q, self.rates, self.time = system, q, rates, time
        n = len(q)
        none = Change(n)
        self.matrix = [[0.0] * n for _ in range(n)]
        self.forces, self.right = [], []
        motion = Change.motion(rates)
        for r in range(n):
            place, rate = Change(n, place=r), Change(n, rate=r)
            for s in range(r + 1):
                mixed = _read(self._kinetic(self._numbers(Change(n, rate=s), rate)), 1, 1)
                self.matrix[r][s] = self.matrix[s][r] = mixed
            numbers = self._numbers(none, place)
            force = _read(self._power(self._numbers(none, rate)), 0, 1)
            force -= _read(potential(system, numbers, gravity), 0, 1)
            slope = _read(self._kinetic(numbers), 0, 1)
            carried = _read(self._kinetic(self._numbers(motion, rate)), 1, 1)
            self.forces.append(force)
            self.right.append(force + slope - carried)

    def _numbers(self, first: Change, second: Change) -> "dict[str, Jet]":
        """The coordinates and the time: jets in time of jets in the first change of jets in the second."""
        made = {}
        for k, name in enumerate(self.system.names):
            made[name] = Jet([
                Jet([Jet([self.q[k], second.places[k]]), Jet([first.places[k], 0.0])]),
                Jet([Jet([self.rates[k], second.rates[k]]), Jet([first.rates[k], 0.0])]),
            ])  # fmt: skip
        made["t"] = Jet([
            Jet([Jet([self.time, second.time]), Jet([first.time, 0.0])]), Jet([Jet([1.0, 0.0]), Jet([0.0, 0.0])])
        ])  # fmt: skip
        return made

    def _kinetic(self, numbers: "dict[str, Jet]") -> "Any":
        """½·Σ m·ṗ² and, of a turning body, ½·Σ J_k·ė_k² of its axes, J_k its second moments of mass."""
        total: Any = 0.0
        for name, body in self.system.bodies.items():
            if body.mass:
                velocity = _rates(self.system.place(name, numbers))
                total = total + dot(velocity, velocity) * (0.5 * body.mass)
            moments = self.system.moments[name]
            if not any(moments) or not self.system.turns[name]:
                continue
            for moment, unit in zip(moments, UNITS, strict=True):
                second = 0.5 * sum(moments) - moment
                if second:
                    turned = _rates(self.system.turned(name, unit, numbers))
                    total = total + dot(turned, turned) * (0.5 * second)
        return total

    def _power(self, numbers: "dict[str, Jet]") -> "Any":
        """Σ F·ṗ and M·ω of given loads, and −½·c·l̇² of dampers, whose slope by a rate is theirs too."""
        system, scene = self.system, self.system.scene
        given = dict(zip(system.names, self.q, strict=True)) | {"t": self.time}
        given |= {f"{name}_dot": w for name, w in zip(system.names, self.rates, strict=True)}
        total: Any = 0.0
        for one in scene.forces:
            force = system.three(one.name, system.forces[one.name], given)
            total = total + dot(force, _rates(system.place(one.at, numbers)))
        for turner in scene.torques:
            law: Any = system.torques[turner.name]
            size = system.value(turner.name, law, given) / sqrt(dot(turner.axis, turner.axis))
            for body, sign in ((turner.body, 1.0), (turner.against, -1.0)):
                if body:
                    total = total + dot(turner.axis, self._spin(body, numbers)) * (sign * size)
        for spring in scene.springs:
            if spring.damping:
                speed = _rate(sqrt(_square(system, spring, numbers)))
                total = total - speed * speed * (0.5 * spring.damping)
        for twist in scene.torsion_springs:
            law = system.twists[twist.name]
            speed = _rate(system.value(twist.name, law, numbers))
            total = total - speed * speed * (0.5 * twist.damping)
        return total

    def _spin(self, name: str, numbers: "dict[str, Jet]") -> "Any":
        """Angular velocity as ½·Σ e_k × ė_k of the body's axes."""
        total: Any = NOWHERE
        for unit in UNITS:
            axis = self.system.turned(name, unit, numbers)
            part = cross(tuple(map(_value, axis)), _rates(axis))
            total = tuple(a + b * 0.5 for a, b in zip(total, part, strict=True))
        return total


def potential(system: "System", numbers: "Mapping[str, Any]", gravity: float) -> "Any":
    """Potential energy of gravity and of springs."""
    scene = system.scene
    total: Any = 0.0
    for body, height in zip(scene.bodies, system.heights(numbers), strict=True):
        total = total + _value(height) * (body.mass * gravity)
    for one in scene.springs:
        square = _value(_square(system, one, numbers))
        if one.free_length:
            stretch = sqrt(square) - one.free_length
            square = stretch * stretch
        total = total + square * (0.5 * one.stiffness)
    for twist in scene.torsion_springs:
        law: Any = system.twists[twist.name]
        angle = _value(system.value(twist.name, law, numbers)) - twist.free_angle
        total = total + angle * angle * (0.5 * twist.stiffness)
    return total


def _square(system: "System", spring: "Any", numbers: "Mapping[str, Any]") -> "Any":
    way = subtract(system.place(spring.end, numbers), system.place(spring.start, numbers))
    return dot(way, way)


def _value(number: "Any") -> "Any":
    return number.parts[0] if isinstance(number, Jet) else number


def _rate(number: "Any") -> "Any":
    return number.parts[1] if isinstance(number, Jet) else 0.0


def _rates(vector: "Any") -> "Any":
    return tuple(map(_rate, vector))


def _read(number: "Any", first: int, second: int) -> float:
    """The coefficient of both changes."""
    for order in (first, second):
        number = number.parts[order] if isinstance(number, Jet) else number if order == 0 else 0.0
    return float(number)
