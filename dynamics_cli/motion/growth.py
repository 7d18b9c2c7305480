"""How an error of the start grows: the equations linearized about the motion, integrated beside it."""

import math

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.rods import Rods

# A coarse integration tells the growth; it looks so many slowest swings ahead, or until errors have grown so far.
TOLERANCE, SWINGS, ENOUGH = 1e-7, 20.0, 10.0
# The change by which the equations are linearized; a difference of this size is right to eight digits.
HAIR = 1e-6


class Growth:
    """Powers of ten by which an error has grown, over time from the start."""

    def __init__(self, rods: "Rods", start: "list[float]", duration: float) -> None:
        self.powers: list[tuple[float, float]] = [(0.0, 0.0)]
        self._speed = rods.scale(start[: rods.n], start[rods.n :])
        piece = 2.0 * math.pi * rods.oscillations()[0][0]
        until = max(duration, SWINGS * piece)
        if rods.n > 1:
            self._follow(rods, list(start), piece, until)

    def _follow(self, rods: "Rods", state: "list[float]", piece: float, until: float) -> None:
        import numpy as np
        from scipy.integrate import solve_ivp

        n = rods.n

        def rate(time: float, both: "Any") -> "Any":
            y, off = both[: 2 * n], both[2 * n :]
            ahead, behind = (np.asarray(rods.rate(time, y + sign * HAIR * off)) for sign in (1.0, -1.0))
            return np.concatenate((0.5 * (ahead + behind), (ahead - behind) / (2.0 * HAIR)))

        off = np.zeros(2 * n)
        off[0] = 1.0
        time, power = 0.0, 0.0
        while time < until and power < ENOUGH:
            both: Any = np.concatenate((state, off))
            run: Any = solve_ivp(rate, (time, time + piece), both, method="DOP853", rtol=TOLERANCE, atol=TOLERANCE)
            if not run.success:
                return
            state, off, time = run.y[: 2 * n, -1].tolist(), run.y[2 * n :, -1], time + piece
            size = float(np.max(np.abs(off[:n])))
            power += math.log10(size)
            off = off / size
            self.powers.append((time, power))

    def tenfold(self) -> float | None:
        """Time in which an error grows tenfold, where it grows faster than in proportion to time."""
        time, power = self.powers[-1]
        # a regular motion parts from its neighbours in proportion to time
        return time / power if power > math.log10(3.0 * (1.0 + self._speed * time)) else None

    def reaches(self, time: float, by: float) -> float:
        """The time at which an error has grown by so many powers of ten from what it is at a time."""
        wanted = self._at(time) + by
        for (early, low), (late, high) in zip(self.powers, self.powers[1:], strict=False):
            if high >= wanted and late > time:
                return early + (late - early) * max(wanted - low, 0.0) / (high - low)
        end, power = self.powers[-1]
        return end + (wanted - power) * (self.tenfold() or math.inf)

    def _at(self, time: float) -> float:
        for (early, low), (late, high) in zip(self.powers, self.powers[1:], strict=False):
            if time <= late:
                return low + (high - low) * (time - early) / (late - early)
        return self.powers[-1][1]
