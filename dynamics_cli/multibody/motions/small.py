"""Small motions about a place: what drives the ways that joints and loops leave free, and how that changes with them.

Ways are combinations of the speeds over one unit of time, lengths in sizes of the scene. With loops a way is followed
by closing these again without changing it.
"""

import numpy as np

from dynamics_cli.multibody.bodies.system import loads_of
from dynamics_cli.numerics.trees.matrix import mass_matrix
from dynamics_cli.numerics.trees.newton_euler import inverse, sweep
from dynamics_cli.numerics.trees.tree import moved
from dynamics_cli.numerics.vectors import length

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.multibody.bodies.loops import Loops
    from dynamics_cli.multibody.bodies.system import System

# Five-point differences of forces over so much [rad, or sizes].
STEP = 2e-3
# Steps towards balance at most, and the longest of one.
STEPS, LONGEST = 200, 0.3
# Stiffnesses below this share of the largest count as none.
NEUTRAL = 1e-9
BALANCED = 1e-12


class Small:
    """A system at rest about a place, by the ways that it is free to go."""

    def __init__(self, system: "System", loops: "Loops | None") -> None:
        self.system, self.loops = system, loops
        reach = max((length(link.position) + length(link.centroid) for link in system.tree.links), default=0.0)
        size = loops.size if loops is not None else reach or 1.0
        self.scales = np.array([1.0 if turns else size for turns in system.turning])
        self.size = float(size)
        system.at(system.coordinates, [0.0] * system.tree.speeds)
        self.settle()

    def settle(self) -> None:
        """Take the place where the system stands as the middle."""
        self.start = list(self.system.coordinates)
        count = len(self.scales)
        if self.loops is None:
            self.free, self.bound = np.eye(count), np.zeros((count, 0))
        else:
            _, _, right, self.free = self.loops.parts()
            self.bound = right.T

    def go(self, way: "Any") -> None:
        """Put the system at a way from the middle, loops closed."""
        total = self.free @ way
        for _ in range(20):
            coordinates = moved(self.system.tree, self.start, (total * self.scales).tolist())
            self.system.at(coordinates, [0.0] * len(self.scales))
            if self.loops is None:
                return
            gaps = self.loops.gaps(self.system.ground)
            if float(np.abs(gaps).max()) < 1e-14:
                return
            b = self.loops.jacobian(self.system.ground)
            total = total - self.bound @ np.linalg.lstsq(b @ self.bound, gaps, rcond=1e-9)[0]

    def driving(self) -> "Any":
        """The forces of all speeds that weight, loads, springs and motors make, lengths in sizes."""
        system = self.system
        system.loads = loads_of(system)
        held, _ = inverse(system.tree, system.frames, system.speeds, ground=system.base, loads=system.loads)
        springs = system.spring_efforts()
        sums = [motor + spring - weight for motor, spring, weight in zip(system.efforts, springs, held, strict=True)]
        return np.array(sums) * self.scales

    def force(self, way: "Any") -> "Any":
        """The force along each free way, at a way from the middle."""
        self.go(way)
        forces = self.driving()
        if self.loops is None:
            return forces
        free = self.loops.parts()[3]
        return np.linalg.solve((self.free.T @ free).T, free.T @ forces)

    def stiffness(self) -> "tuple[Any, float]":
        """−∂force/∂way in the middle, its symmetric part, and the share of the other part."""
        count = self.free.shape[1]
        columns = []
        for k in range(count):
            step = np.eye(count)[k] * STEP
            far = self.force(2.0 * step) - self.force(-2.0 * step)
            near = self.force(step) - self.force(-step)
            columns.append((far - 8.0 * near) / (12.0 * STEP))
        self.go(np.zeros(count))
        matrix = np.array(columns).T if columns else np.zeros((0, 0))
        symmetric = 0.5 * (matrix + matrix.T)
        largest = float(np.abs(matrix).max(initial=0.0))
        return symmetric, float(np.abs(matrix - symmetric).max(initial=0.0)) / largest if largest else 0.0

    def masses(self) -> "Any":
        """The mass matrix of the free ways."""
        full = np.array(mass_matrix(self.system.tree, self.system.frames)) * np.outer(self.scales, self.scales)
        return self.free.T @ full @ self.free

    def dampers(self) -> "Any":
        """The damping of the free ways."""
        system = self.system
        full = np.diag(np.array([spring.damping for spring in system.springs]) * self.scales**2)
        for spring in system.between:
            if spring.damping:
                units = np.eye(len(self.scales)).tolist()
                rates = [spring.opening(system.ground, sweep(system.tree, system.frames, unit)) for unit in units]
                full += spring.damping * np.outer(rates, rates) * np.outer(self.scales, self.scales)
        return self.free.T @ full @ self.free

    def acting(self) -> float:
        """What forces are compared with: weights and efforts on their levers."""
        system = self.system
        weights = sum(link.mass for link in system.tree.links) * system.gravity * self.size
        scales = map(float, self.scales)
        springs = [spring.stiffness * scale**2 for spring, scale in zip(system.springs, scales, strict=True)]
        springs += [spring.stiffness * self.size**2 for spring in system.between]
        return max(weights, *springs, *(abs(x) for x in system.efforts), 1e-300)

    def rest(self) -> float:
        """Go where nothing drives any more, downhill; returns the largest force left, over what acts."""
        acting = self.acting()
        left = float("inf")
        for _ in range(STEPS):
            force = self.force(np.zeros(self.free.shape[1]))
            left = float(np.abs(force).max(initial=0.0)) / acting
            if left < BALANCED:
                break
            stiffness, _ = self.stiffness()
            values, ways = np.linalg.eigh(stiffness)
            # downhill also where it is unstable; a way that nothing holds takes no step
            size = np.maximum(np.abs(values), 0.05 * acting if left > 1e-3 else 0.0)
            along = ways.T @ force
            least = max(NEUTRAL * float(size.max(initial=0.0)), 1e-300)
            step = ways @ np.where(size > least, along / np.maximum(size, least), 0.0)
            longest = float(np.abs(step).max(initial=0.0))
            if longest < 1e-16:
                break
            self.go(step * min(1.0, LONGEST / longest))
            self.settle()
        return left
