"""One motion integrated three times: at two tolerances, and from a start that is a hair off.

Where the first two part, the answer is no longer that of the start that was given, whatever the energy says; the third
tells how fast errors grow.
"""

import math

from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.rods import Rods

FINE, COARSE = 1e-13, 1e-12
# How far the two runs may part [rad], and by how much the third start is off [rad].
APART, NUDGE = 1e-3, 1e-9
# Pieces of the time; in each, samples for the fastest motion, but not fewer and not more.
PIECES, FEWEST, MOST = 40, 16, 64


class Runs:
    """Times and states of the fine run up to the horizon or the end, and what the others say of it."""

    def __init__(self, rods: "Rods", start: "list[float]", duration: float) -> None:
        self.rods, self.duration = rods, duration
        self.times: list[float] = [0.0]
        self.states: list[list[float]] = [list(start)]
        self.difference = 0.0
        self.reached = False
        self._logs: list[tuple[float, float]] = []
        self.speed = rods.scale(start[: rods.n], start[rods.n :])
        self._integrate(start)

    def _integrate(self, start: "list[float]") -> None:
        n = self.rods.n
        samples = round(min(max(3.0 * self.duration / PIECES * self.speed, FEWEST), MOST))
        states = [list(start), list(start), [start[0] + NUDGE, *start[1:]]]
        for piece in range(PIECES):
            times = [self.duration * (piece + k / samples) / PIECES for k in range(samples + 1)]
            runs = [self._run(times, y, tolerance) for y, tolerance in zip(states, (FINE, COARSE, COARSE), strict=True)]
            for k in range(1, samples + 1):
                fine, coarse, nudged = (run[k] for run in runs)
                apart = max(abs(fine[i] - coarse[i]) for i in range(n))
                off = max(abs(nudged[i] - coarse[i]) for i in range(n))
                if apart > APART:
                    self.reached = True
                    return
                self.difference = max(self.difference, apart)
                if off <= APART:
                    self._logs.append((times[k], max(off, NUDGE)))
                self.times.append(times[k])
                self.states.append(fine)
            states = [run[-1] for run in runs]

    def _run(self, times: "list[float]", state: "list[float]", tolerance: float) -> "list[list[float]]":
        from scipy.integrate import solve_ivp

        solved: Any = solve_ivp(
            self.rods.rate, (times[0], times[-1]), state, method="DOP853", rtol=tolerance, atol=tolerance, t_eval=times
        )
        require(bool(solved.success), "the integration stopped", code="no-convergence")
        return solved.y.T.tolist()  # type: ignore[no-any-return]

    def tenfold(self) -> float | None:
        """Time in which an error grows tenfold, where it grows faster than in proportion to time."""
        if self.rods.n == 1:
            return None
        time, off = max(self._logs, key=lambda pair: pair[1], default=(0.0, NUDGE))
        # a regular motion parts from its neighbours in proportion to time
        grown = off / NUDGE
        slow = 3.0 * (1.0 + self.speed * time)
        return time / math.log10(grown) if grown > slow else None

    def horizon(self) -> float | None:
        """Where the two runs part: seen, or by the growth of errors expected after the end; None where none grows."""
        if self.reached:
            return self.times[-1]
        tenfold = self.tenfold()
        if tenfold is None or self.difference == 0.0:
            return None
        return self.duration + tenfold * math.log10(APART / self.difference)

    def energy_error(self) -> float:
        """The largest change of the energy, over that of the start above hanging at rest."""
        n = self.rods.n
        energies = [self.rods.energy(y[:n], y[n:]) for y in self.states]
        return max(abs(energy - energies[0]) for energy in energies) / energies[0]
