"""A motion integrated three times: at two tolerances, and from a start that is a hair off; how long it can be known."""

import math

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.motion.bodies.system import SingularError
from dynamics_cli.motion.scenes.march import March
from dynamics_cli.motion.scenes.small import rates_of
from dynamics_cli.progress import going
from dynamics_cli.quantities import Time
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.start import Start

# Tolerances of DOP853, and of Radau, whose order is lower.
FINE, COARSE = 1e-11, 1e-10
STIFF_FINE, STIFF_COARSE = 1e-9, 1e-8
# That of a sample of uncertain inputs, which goes once: eight digits of its results.
SAMPLED = 1e-9
# How far the runs may part, and by how much the third start is off, in sizes of the scene and rad.
APART, NUDGE = 1e-3, 1e-7
# A decay of so many times the rest's rate, over so many of its own times, takes Radau.
STIFFNESS, LONG = 50.0, 2000.0
LONGEST = 20000.0
# Beyond so many times at which a table has a corner, steps take the corners as they come.
MOST_STOPS = 2000
KEPT = 1e-6
SINGULAR = 1e-7


class Runs:
    """The fine run up to its end, the horizon or a singular pose, and what the others say of it."""

    def __init__(self, start: "Start", duration: float, *, begun: bool = True) -> None:
        self.start, self.system, self.duration = start, start.system, duration
        fast, decay = rates_of(start.system, start.state)
        moving = float(np.abs(start.state[self.system.end : 2 * self.system.end]).max(initial=0.0))
        self.fast = max(fast, moving, 0.5 * self.system.gravity**0.5)
        self.stiff = decay * duration > LONG and decay > STIFFNESS * self.fast
        longest = LONGEST / max(self.fast, 0.0 if self.stiff else decay / 5.0, 1e-300)
        require(duration <= longest, "{duration} are too many swings to follow", duration=(duration, Time),
                code="too-long", hint="give {longest} or less", longest=(longest, Time))  # fmt: skip
        if begun:
            self._begin(start, duration)

    def _begin(self, start: "Start", duration: float) -> None:
        knots = sorted({knot for part in self.system.driven for knot in part.motion.knots} | set(self.system.knots))
        inside = [knot for knot in knots if 0.0 < knot < duration]
        self.stops = [*(inside if len(inside) <= MOST_STOPS else []), duration]
        fine, coarse = (STIFF_FINE, STIFF_COARSE) if self.stiff else (FINE, COARSE)
        fine = max(fine, SAMPLED) if drawing() else fine
        self.fine = March(self.system, start.state, self.stops, fine, stiff=self.stiff, dense=True)
        self.nudged: March | None = None
        self.reached, self.stuck = False, False
        self.crossed: list[float] = []
        self.difference = 0.0
        self._logs: list[tuple[float, float]] = []
        self._energies: list[tuple[float, float, float]] = []
        self.parted: list[tuple[float, float]] = []
        self._side: Any = None
        self.end = duration
        if drawing():  # the spread of a sample drowns what further runs would say
            self._integrate([], float)
            return
        others = [March(self.system, start.state, self.stops, coarse, stiff=self.stiff)]
        if start.freedom:
            self.nudged = March(self.system, self._nudged(), self.stops, coarse, stiff=self.stiff)
            others.append(self.nudged)
        with going(duration, "seconds of motion") as progress:
            self._integrate(others, progress)

    def _nudged(self) -> "Any":
        """The start moved by a hair the way its joints leave free."""
        system, state = self.system, self.start.state.copy()
        free = np.linalg.svd(system.jacobian(0.0, system.frame_of(state)))[2][system.m :]
        if not len(free):
            return state
        way = free.sum(axis=0)
        state[: system.end] += NUDGE * way / np.abs(way).max()
        return system.projected(0.0, state, 1e-14)

    def _integrate(self, others: "list[March]", progress: "Any") -> None:
        try:
            self._watch()
            while not all(run.over for run in (self.fine, *others)):
                run = min(others, key=lambda one: one.t, default=None)
                if run is not None and not run.over:
                    run.step()
                while not self.fine.over and (run is None or run.over or self.fine.t < run.t):
                    self.fine.step()
                    self._watch()
                    progress(self.fine.t)
                if run is not None and not self._compared(run):
                    return
        except SingularError:
            self.stuck = True
            self.end = self.fine.t

    def _compared(self, run: March) -> bool:
        """Note how far a run is from the fine one; False at the horizon."""
        apart = self.apart(run.y, self.fine.at(run.t))
        if run is self.nudged:
            if apart <= APART:
                self._logs.append((run.t, max(apart, NUDGE)))
            return True
        if apart > APART:
            self.reached, self.end = True, run.t
            return False
        self.difference = max(self.difference, apart)
        self.parted.append((run.t, apart))
        return True

    def apart(self, one: "Any", other: "Any") -> float:
        """The largest distance of mass centres, or angle, of two states."""
        return float(np.abs(one[: self.system.end] - other[: self.system.end]).max())

    def _watch(self) -> None:
        """Energy, and whether the joints are at, or have passed, a pose where they do not determine the motion."""
        system, run = self.system, self.fine
        kinetic, potential = system.energies(run.y)
        self._energies.append((run.t, float(kinetic + potential - run.y[-3] - run.y[-2] + run.y[-1]), kinetic))
        if not system.m:
            return
        u, values, v = np.linalg.svd(system.jacobian(run.t, system.frame_of(run.y)))
        free = v[system.m :]
        if values[-1] < SINGULAR * values[0]:
            raise SingularError
        # the sign of the determinant of the joints' conditions with the free directions below them
        sign = np.linalg.det(u) * np.linalg.det(v)
        if self._side is not None:
            before, old = self._side
            turned = np.linalg.det(free @ old.T) if len(free) else 1.0
            if sign * turned * before < 0.0:
                self.crossed.append(run.t)
        self._side = sign, free

    def tenfold(self) -> "float | None":
        """Time in which an error grows tenfold, where it grows faster than in proportion to time."""
        time, off = max(self._logs, key=lambda pair: pair[1], default=(0.0, NUDGE))
        slow = 3.0 * (1.0 + self.speed() * time)
        return time / math.log10(off / NUDGE) if off / NUDGE > slow else None

    def speed(self) -> float:
        """The largest rate of the motion."""
        end = self.system.end
        sampled = [self.fine.at(self.end * k / 50.0)[end : 2 * end] for k in range(51)]
        return float(max(self.fast, max(float(np.abs(rates).max()) for rates in sampled)))

    def horizon(self) -> "float | None":
        """Where the runs part: seen, or expected after the end; None where errors hardly grow."""
        if self.reached:
            return self.end
        tenfold = self.tenfold()
        if tenfold is None or self.difference == 0.0 or self.stuck:
            return None
        return self.duration + tenfold * math.log10(APART / self.difference)

    def energy_errors(self) -> "list[tuple[float, float]]":
        """Times, and the change of energy less work until then over the largest energy exchanged."""
        states = [self.fine.at(self.end * k / 50.0) for k in range(51)]
        works = [abs(float(x)) for state in states for x in state[-3:]]
        high = [self.system.energies(state)[1] for state in states]
        exchanged = max(max(kinetic for *_, kinetic in self._energies), max(works), max(high) - min(high))
        _, first, _ = self._energies[0]
        return [(t, abs(total - first) / exchanged if exchanged else 0.0) for t, total, _ in self._energies]

    def energy_error(self) -> float:
        """The largest of these."""
        return max(share for _, share in self.energy_errors())


_last: "list[tuple[Any, Runs]]" = []


def runs_of(scene: "Any", gravity: float, duration: float) -> Runs:
    """The runs of a scene; its picture asks for those of its answer again."""
    from dynamics_cli.motion.bodies.start import Start

    key = (scene, gravity, duration)
    if not _last or _last[0][0] != key:
        _last[:] = [(key, Runs(Start(scene, gravity), duration))]
    return _last[0][1]
