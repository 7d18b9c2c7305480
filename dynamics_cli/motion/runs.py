"""One motion integrated at two tolerances, and the growth of errors along it.

Where the two part, the answer is no longer that of the start that was given, whatever the energy says; the growth of
errors tells when that will be.
"""

import math

from dynamics_cli.errors import require
from dynamics_cli.motion.growth import Growth

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.rods import Rods

FINE, COARSE = 1e-13, 1e-12
# How far the two runs may part [rad].
APART = 1e-3
# Pieces of the time, and samples for the fastest motion, but not fewer and not more.
PIECES, DENSITY, FEWEST, MOST = 40, 12.0, 640, 40_000


def samples_of(turned: float) -> int:
    """How many samples show a motion whose largest rate times its duration is this; a multiple of the pieces."""
    return PIECES * round(min(max(DENSITY * turned, FEWEST), MOST) / PIECES)


class Runs:
    """Times and states of the fine run up to the horizon or the end, and what the others say of it."""

    def __init__(self, rods: "Rods", start: "list[float]", duration: float) -> None:
        self.rods, self.duration = rods, duration
        self.times: list[float] = [0.0]
        self.states: list[list[float]] = [list(start)]
        # how far the two runs are apart at each time, and the largest of these
        self.parted: list[float] = [0.0]
        self.difference = 0.0
        self.reached = False
        self.speed = rods.scale(start[: rods.n], start[rods.n :])
        self._integrate(start)
        self.growth = Growth(rods, start, self.times[-1])

    def _integrate(self, start: "list[float]") -> None:
        n = self.rods.n
        samples = samples_of(self.duration * self.speed) // PIECES
        states = [list(start), list(start)]
        for piece in range(PIECES):
            times = [self.duration * (piece + k / samples) / PIECES for k in range(samples + 1)]
            runs = [self._run(times, y, tolerance) for y, tolerance in zip(states, (FINE, COARSE), strict=True)]
            for k in range(1, samples + 1):
                fine, coarse = (run[k] for run in runs)
                apart = max(abs(fine[i] - coarse[i]) for i in range(n))
                if apart > APART:
                    self.reached = True
                    return
                self.difference = max(self.difference, apart)
                self.parted.append(apart)
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

    def horizon(self) -> float | None:
        """Where the two runs part: seen, or by the growth of errors expected after the end; None where none grows."""
        if self.reached:
            return self.times[-1]
        if self.growth.tenfold() is None:
            return None
        return self.growth.reaches(self.duration, math.log10(APART / max(self.difference, FINE)))

    def energy_errors(self) -> "list[float]":
        """The change of the energy at each time, over that of the start above hanging at rest."""
        n = self.rods.n
        energies = [self.rods.energy(y[:n], y[n:]) for y in self.states]
        return [abs(energy - energies[0]) / energies[0] for energy in energies]
