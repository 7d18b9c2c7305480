"""What acts on bodies in a plane besides weight: loads, and springs between points, by complex numbers."""

from math import hypot

from dynamics_cli.errors import require
from dynamics_cli.numerics.vectors import dot, times

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dynamics_cli.multibody.bodies.records import Load
    from dynamics_cli.multibody.bodies.springs import PointSpring
    from dynamics_cli.multibody.bodies.system import System
    from dynamics_cli.numerics.vectors import Vector

    # link, arm from its origin, force, moment; power that is not stored
    Push = tuple[int, complex, complex, float]
    Flat = Callable[[Vector], complex]
    Numbers = Sequence[complex]


class PlanarLoad:
    """A load; of its force and moment what moves bodies in the plane."""

    def __init__(self, system: "System", load: "Load", flat: "Flat", normal: "Vector") -> None:
        self.link = system.body_link(load.body)
        turn = system.ground[self.link][0]
        self.of_body = load.axes == "body"
        self.arm = flat(times(turn, load.at))
        self.force = flat(times(turn, load.force) if self.of_body else load.force)
        self.moment = dot(normal, times(turn, load.moment) if self.of_body else load.moment)

    def pushes(
        self, turns: "Numbers", _: "Numbers", velocities: "Numbers", omegas: "Sequence[float]"
    ) -> "tuple[list[Push], float]":
        """Its force, and its power."""
        k = self.link
        arm, force = turns[k] * self.arm, turns[k] * self.force if self.of_body else self.force
        moving = velocities[k] + 1j * omegas[k] * arm
        power = force.real * moving.real + force.imag * moving.imag + self.moment * omegas[k]
        return [(k, arm, force, self.moment)], power


class PlanarSpring:
    """A spring with a damper between points, which may lie in front of each other."""

    def __init__(self, system: "System", spring: "PointSpring", flat: "Flat", normal: "Vector") -> None:
        self.spring = spring
        self.ends = [
            (k, flat(times(system.ground[k][0], at)) if k >= 0 else flat(at))
            for k, at in zip(spring.links, spring.at, strict=True)
        ]
        self.depth = dot(normal, spring.way(system.ground))

    def pushes(
        self, turns: "Numbers", origins: "Numbers", velocities: "Numbers", omegas: "Sequence[float]"
    ) -> "tuple[list[Push], float]":
        """Its forces, and the power that its damper takes."""
        arms, places, rates = [], [], []
        for k, at in self.ends:
            arm = turns[k] * at if k >= 0 else at
            arms.append(arm)
            places.append(origins[k] + arm if k >= 0 else at)
            rates.append(velocities[k] + 1j * omegas[k] * arm if k >= 0 else 0j)
        way, opening = places[1] - places[0], rates[1] - rates[0]
        size = hypot(way.real, way.imag, self.depth)
        spring = self.spring
        if not spring.free and not spring.damping:
            share, power = spring.stiffness, 0.0
        else:
            require(size > 0.0, "the ends of spring {number} have met: its force has no direction",
                    number=spring.number, code="spring")  # fmt: skip
            rate = (way.real * opening.real + way.imag * opening.imag) / size
            share = (spring.stiffness * (size - spring.free) + spring.damping * rate) / size
            power = -spring.damping * rate * rate
        pull = share * way
        return [(k, arm, sign * pull, 0.0) for (k, _), arm, sign in zip(self.ends, arms, (1.0, -1.0), strict=True)
                if k >= 0], power  # fmt: skip
