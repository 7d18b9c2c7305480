"""One integration of a scene, step by step; every step is put back onto the joints."""

import numpy as np

from dynamics_cli.motion.bodies.system import SingularError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.system import System

# Gaps of the joints, in sizes of the scene, that are put right after a step, and those that stay.
DRIFT, CLOSED = 1e-13, 1e-14
# Steps that shrink to this share of the time have met something that no step passes.
SMALLEST = 1e-13


class March:
    """States from a start on; `t` and `y` are where it is. With `dense` every step is kept, to be read between."""

    def __init__(
        self,
        system: "System",
        state: "Any",
        stops: "list[float]",
        tolerance: float,
        *,
        stiff: bool,
        dense: bool = False,
    ) -> None:
        self.system, self.stops, self.tolerance = system, stops, tolerance
        self.stiff, self.dense = stiff, dense
        self.t, self.y = 0.0, state
        self.drift = 0.0
        self.pieces: list[Any] = []
        self.ends: list[float] = []
        self._solver: Any = None
        self._first: float | None = None
        # what rates are compared with, where they are small
        rates = np.abs(system.rate(0.0, state))
        quick = max(float(np.sqrt(rates[system.end : 2 * system.end].max(initial=0.0))),
                    float(np.abs(state[system.end : 2 * system.end]).max(initial=0.0)), 1.0 / stops[-1])  # fmt: skip
        kinetic = quick * quick
        parts = [1.0] * system.end + [quick] * system.end + [1.0] * len(system.phases) + [kinetic] * 3
        self.scales = np.array(parts)

    @property
    def over(self) -> bool:
        """Whether the end is reached."""
        return self.t >= self.stops[-1]

    def _new(self) -> "Any":
        from scipy.integrate import DOP853, Radau

        stop = next(stop for stop in self.stops if stop > self.t)
        method, span = Radau if self.stiff else DOP853, stop - self.t
        first = None if self._first is None else min(self._first, span)
        return method(self.system.rate, self.t, self.y, stop, rtol=self.tolerance, atol=self.tolerance * self.scales,
                      first_step=first)  # fmt: skip

    def step(self) -> None:
        """One step on; SingularError where none is possible."""
        if self._solver is None:
            self._solver = self._new()
        solver = self._solver
        solver.step()
        if solver.status == "failed" or not np.isfinite(solver.y).all():
            raise SingularError
        if self.dense:
            self.pieces.append(solver.dense_output())
            self.ends.append(float(solver.t))
        self.t, self.y = float(solver.t), solver.y
        self._put_back()
        if solver.status == "finished":
            self._first, self._solver = abs(solver.step_size), None
        elif solver.step_size < SMALLEST * self.stops[-1]:
            raise SingularError

    def _put_back(self) -> None:
        system = self.system
        if not system.m:
            return
        f = system.frame_of(self.y)
        gap = float(np.abs(system.gaps(self.t, f)).max())
        self.drift = max(self.drift, gap)
        if gap > DRIFT:
            self.y = system.projected(self.t, self.y, CLOSED)
            self._solver.y = self.y
            if not self.stiff:
                self._solver.f = system.rate(self.t, self.y)

    def at(self, t: float) -> "Any":
        """The state at a time passed."""
        from bisect import bisect_left

        if t <= 0.0:
            return self.pieces[0](0.0)
        k = min(bisect_left(self.ends, t), len(self.ends) - 1)
        return self.pieces[k](t)
