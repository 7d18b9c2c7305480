"""One motion of a scene, integrated at two tolerances, put back onto loops and unit quaternions between stretches."""

from dynamics_cli.errors import require
from dynamics_cli.multibody.bodies.energy import kinetic, potential
from dynamics_cli.multibody.bodies.system import loads_of
from dynamics_cli.numerics.trees.articulated import forward
from dynamics_cli.numerics.trees.newton_euler import inverse, sweep
from dynamics_cli.numerics.trees.tree import BALL, rates
from dynamics_cli.numerics.vectors import dot
from dynamics_cli.quantities import Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.multibody.bodies.loops import Loops
    from dynamics_cli.multibody.bodies.system import System
    from dynamics_cli.multibody.motions.drives import Drives
    from dynamics_cli.multibody.motions.guided import Guided
    from dynamics_cli.multibody.motions.planar import Planar

# Stretches at least, after which loops are put right and quaternions scaled; samples of a motion in all.
STRETCHES, SAMPLES = 40, 400
# Rates that a motion may take: about a minute.
MOST = 200_000


def guides(system: "System", loops: "Loops | None", drives: "Drives | None") -> "tuple[Guided | None, Planar | None]":
    """What gives accelerations within loops and with drives: in space, and in a plane where all stays in one."""
    if loops is None and drives is None:
        return None, None
    from dynamics_cli.multibody.motions.guided import Guided
    from dynamics_cli.multibody.motions.planar import Planar, normal_of

    normal = None if loops is None else normal_of(loops)
    planar = None if loops is None or normal is None else Planar(loops, normal, drives)
    return Guided(system, loops, drives), planar


class Run:
    """Times, states and energies of one motion; a state is coordinates, speeds, and the work done on the system."""

    def __init__(
        self, system: "System", loops: "Loops | None", drives: "Drives | None", times: "Sequence[float]",
        tolerance: float,
    ) -> None:  # fmt: skip
        self.system, self.loops, self.drives = system, loops, drives
        self.times, self.tolerance = list(times), tolerance
        self.split = system.tree.coordinates
        self.gap = self.off_unit = 0.0
        self.calls = 0
        self.guide, self.plane = guides(system, loops, drives)
        self.states: list[list[float]] = []
        self.energies: list[float] = []
        self.kinetics: list[float] = []
        self._march([*system.coordinates, *system.speeds, 0.0])

    def put(self, state: "Sequence[float]") -> None:
        """Put the system into a state."""
        n = self.split
        self.system.at(list(state[:n]), list(state[n:-1]))
        self.system.loads = loads_of(self.system)

    def driven(self, coordinates: "list[float]", speeds: "list[float]") -> "list[float]":
        """Efforts of motors and of springs in the joints."""
        columns = zip(self.system.efforts, self.system.springs, speeds, strict=True)
        return [motor + spring.effort(coordinates, y) for motor, spring, y in columns]

    def accelerations(self, time: float, coordinates: "list[float]", speeds: "list[float]") -> "list[float]":
        """Rates of the speeds where the system stands, or where coordinates and speeds say."""
        system, driven = self.system, self.driven(coordinates, speeds)
        if self.plane is not None:
            return self.plane.accelerations(coordinates, speeds, driven, time)
        if self.guide is not None:
            return self.guide.accelerations(driven, time)
        return forward(system.tree, system.frames, system.speeds, driven, ground=system.base, loads=system.loads)

    def worked(self) -> bool:
        """Whether anything but weights and springs acts."""
        system = self.system
        damped = any(s.damping for s in system.springs) or any(s.damping for s in system.between)
        return damped or any(system.efforts) or bool(system.scene.loads) or bool(self.drives)

    def _rate(self, time: float, state: "Any") -> "list[float]":
        self.calls += 1
        require(self.calls <= MOST, "{duration} are too many swings to follow", duration=(self.times[-1], Time),
                code="too-long", hint="shorten it, or give a larger tolerance")  # fmt: skip
        numbers = state.tolist()
        if self.plane is None:
            self.put(numbers)
        system = self.system
        coordinates, speeds = numbers[: self.split], numbers[self.split : -1]
        power = 0.0
        for effort, spring, y in zip(system.efforts, system.springs, speeds, strict=True):
            power += effort * y - spring.damping * y * y
        accelerations = self.accelerations(float(time), coordinates, speeds)
        if system.scene.loads or system.between:
            power += self.plane.power if self.plane is not None else self._load_power()
        if self.drives is not None:
            power += sum(a * y for a, y in zip(self.missing(accelerations), speeds, strict=True))
        return [*rates(system.tree, coordinates, speeds), *accelerations, power]

    def missing(self, accelerations: "list[float]") -> "list[float]":
        """What drives and loops add to every joint's effort, at the state that these belong to."""
        if self.plane is not None:
            return self.plane.missing
        system = self.system
        needed, _ = inverse(
            system.tree, system.frames, system.speeds, accelerations, ground=system.base, loads=system.loads
        )
        driven = self.driven(system.coordinates, system.speeds)
        return [effort - given for effort, given in zip(needed, driven, strict=True)]

    def _load_power(self) -> float:
        """Power of loads and dampers between points; what springs store is energy, and no work."""
        system = self.system
        motions = sweep(system.tree, system.frames, system.speeds)
        power = 0.0
        for load, motion in zip(system.loads, motions, strict=True):
            if load is not None:
                power += dot(load[0], motion[2]) + dot(load[1], motion[0])
        return power + sum(spring.storing(system.ground, motions) for spring in system.between)

    def _march(self, state: "list[float]") -> None:
        """Follow the motion to its end, put right after the first step beyond each stretch."""
        from scipy.integrate import DOP853

        self._keep(state)
        bound = self.guide is not None or any(link.joint == BALL for link in self.system.tree.links)
        begin, end = self.times[0], self.times[-1]
        stretches = [begin + (end - begin) * n / STRETCHES for n in range(1, STRETCHES)] if bound else []
        step: float | None = None
        while begin < end:
            solver: Any = DOP853(
                self._rate, begin, state, end, first_step=step, rtol=self.tolerance, atol=self.tolerance
            )
            stop = next((t for t in stretches if t > begin), end)
            while solver.status == "running" and solver.t < stop:
                solver.step()
                require(solver.status != "failed", "the integration stopped", code="no-convergence")
                self._sample(solver)
            begin, step = float(solver.t), min(solver.h_abs, end - solver.t) or None
            state = self._restored(begin, solver.y.tolist())
        self._keep(state)

    def _sample(self, solver: "Any") -> None:
        """Keep the states at the times within the last step, but for the end."""
        within = None
        while len(self.states) < len(self.times) - 1 and self.times[len(self.states)] <= solver.t:
            within = within or solver.dense_output()
            self._keep(within(self.times[len(self.states)]).tolist())

    def _restored(self, time: float, state: "list[float]") -> "list[float]":
        """The state with loops closed, drives in their places, and quaternions of length one."""
        if self.drives is not None:
            self.put(state)
            self.drives.place(time)
            state = [*self.system.coordinates, *self.system.speeds, state[-1]]
        for link in self.system.tree.links:
            if link.joint == BALL:
                part = state[link.place : link.place + 4]
                size = sum(x * x for x in part) ** 0.5
                self.off_unit = max(self.off_unit, abs(size - 1.0))
                state[link.place : link.place + 4] = [x / size for x in part]
        if self.loops is not None:
            self.put(state)
            self.gap = max(self.gap, self.loops.restore())
            state = [*self.system.coordinates, *self.system.speeds, state[-1]]
        return state

    def _keep(self, state: "list[float]") -> None:
        self.put(state)
        self.states.append(state)
        moving = kinetic(self.system, sweep(self.system.tree, self.system.frames, self.system.speeds))
        self.kinetics.append(moving)
        self.energies.append(moving + potential(self.system) - state[-1])

    def clean(self, value: float, place: int) -> float:
        """A number of a state, 0 where it is below the tolerance beside the largest that there was."""
        return value if abs(value) > self.tolerance * max(abs(state[place]) for state in self.states) else 0.0

    def energy_error(self) -> float:
        """The largest change of energy less work, over the largest energy exchanged."""
        exchanged = max(max(self.kinetics), max(abs(state[-1]) for state in self.states))
        off = max(abs(energy - self.energies[0]) for energy in self.energies)
        return off / exchanged if exchanged else 0.0


def parted(one: Run, other: Run, scales: "Sequence[float]") -> "list[float]":
    """How far two runs are apart at each time, in rad or sizes of the scene."""
    return [
        max(abs(a - b) / scale for a, b, scale in zip(p, q, scales, strict=False))
        for p, q in zip(one.states, other.states, strict=True)
    ]
