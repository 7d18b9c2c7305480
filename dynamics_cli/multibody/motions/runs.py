"""One motion of a scene, integrated at two tolerances, put back onto loops and unit quaternions between stretches."""

from dynamics_cli.errors import require
from dynamics_cli.multibody.bodies.energy import kinetic, potential
from dynamics_cli.multibody.bodies.system import loads_of
from dynamics_cli.numerics.trees.articulated import forward
from dynamics_cli.numerics.trees.newton_euler import sweep
from dynamics_cli.numerics.trees.tree import BALL, rates
from dynamics_cli.numerics.vectors import dot
from dynamics_cli.quantities import Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.multibody.bodies.loops import Loops
    from dynamics_cli.multibody.bodies.system import System

# Stretches at least, after which loops are put right and quaternions scaled; samples of a motion in all.
STRETCHES, SAMPLES = 40, 400
# Rates that a motion may take: about a minute.
MOST = 200_000


class Run:
    """Times, states and energies of one motion; a state is coordinates, speeds, and the work done on the system."""

    def __init__(self, system: "System", loops: "Loops | None", times: "Sequence[float]", tolerance: float) -> None:
        self.system, self.loops, self.times, self.tolerance = system, loops, list(times), tolerance
        self.split = system.tree.coordinates
        self.gap = self.off_unit = 0.0
        self.calls = 0
        self.states: list[list[float]] = []
        self.energies: list[float] = []
        self.kinetics: list[float] = []
        self._march([*system.coordinates, *system.speeds, 0.0])

    def put(self, state: "Sequence[float]") -> None:
        """Put the system into a state."""
        n = self.split
        self.system.at(list(state[:n]), list(state[n:-1]))
        self.system.loads = loads_of(self.system, self.system.scene.loads)

    def accelerations(self) -> "list[float]":
        """Rates of the speeds where the system stands."""
        system = self.system
        springs = system.spring_efforts()
        driven = [motor + spring for motor, spring in zip(system.efforts, springs, strict=True)]
        if self.loops is not None:
            return self.loops.accelerations(driven)[0].tolist()  # type: ignore[no-any-return]
        return forward(system.tree, system.frames, system.speeds, driven, ground=system.base, loads=system.loads)

    def worked(self) -> bool:
        """Whether anything but weights and springs acts."""
        system = self.system
        return any(system.efforts) or bool(system.scene.loads) or any(spring.damping for spring in system.springs)

    def _rate(self, _: float, state: "Any") -> "list[float]":
        self.calls += 1
        require(self.calls <= MOST, "{duration} are too many swings to follow", duration=(self.times[-1], Time),
                code="too-long", hint="shorten it, or give a larger tolerance")  # fmt: skip
        numbers = state.tolist()
        self.put(numbers)
        system = self.system
        power = sum(effort * y for effort, y in zip(system.efforts, system.speeds, strict=True))
        for spring, y in zip(system.springs, system.speeds, strict=True):
            power -= spring.damping * y * y
        if system.scene.loads:
            for load, motion in zip(system.loads, sweep(system.tree, system.frames, system.speeds), strict=True):
                if load is not None:
                    power += dot(load[0], motion[2]) + dot(load[1], motion[0])
        return [*rates(system.tree, system.coordinates, system.speeds), *self.accelerations(), power]

    def _march(self, state: "list[float]") -> None:
        from scipy.integrate import solve_ivp

        self._keep(state)
        bound = self.loops is not None or any(link.joint == BALL for link in self.system.tree.links)
        share = max(len(self.times) // STRETCHES, 1) if bound else len(self.times)
        for begin in range(0, len(self.times) - 1, share):
            stretch = self.times[begin : begin + share + 1]
            solved: Any = solve_ivp(
                self._rate, (stretch[0], stretch[-1]), state, method="DOP853", rtol=self.tolerance,
                atol=self.tolerance, t_eval=stretch[1:],
            )  # fmt: skip
            require(bool(solved.success), "the integration stopped", code="no-convergence")
            for column in solved.y.T.tolist()[:-1]:
                self._keep(column)
            state = self._restored(solved.y[:, -1].tolist())
            self._keep(state)

    def _restored(self, state: "list[float]") -> "list[float]":
        """The state with loops closed and quaternions of length one."""
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
