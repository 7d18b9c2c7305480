"""Certified extremes of functions of a motion, with what the proxies, the motion and the arithmetic may err by."""

import numpy as np

from dynamics_cli.cam.pieces import over_pieces, within
from dynamics_cli.errors import require
from dynamics_cli.numerics import chebyshev
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.cam.motion import Motion
    from dynamics_cli.numerics.chebyshev import Proxies

    Law = Callable[[Any, Any, Any], Any]
    Rounding = Callable[[float, float, float], float]

# Errors of s, s′ and s″, in shares of their sums of Chebyshev coefficients on a zone, which no peak exceeds.
EVALUATED = (2e-15, 2e-15, 5e-15)
STEP = 1e-30
# At most so many places that rounding cannot tell apart are looked at again.
PLACES = 64


@record
class Found:
    """A value, the cam angle it was found at, and what it may err by.

    Parameters
    ----------
    value : float
        The value.
    at : float
        Cam angle [rad].
    error : float
        Bound of its error, in its own unit.
    """

    value: float
    at: float
    error: float


class Survey:
    """Functions of s, s′ and s″ over a motion, ready for their extremes.

    Parameters
    ----------
    motion : Motion
        The motion.
    functions : callable
        Each takes s, ds/dθ, d²s/dθ² (arrays, or complex numbers) and gives what it finds there; analytic in them.

    Raises
    ------
    InadmissibleError
        When numbers overflow.
    """

    def __init__(self, motion: "Motion", *functions: "Law") -> None:
        self.motion = motion
        self.functions = functions
        rows = (lambda s, s1, s2: s, lambda s, s1, s2: s1, lambda s, s1, s2: s2, *functions)
        try:
            with np.errstate(all="ignore"):
                self.made = over_pieces(motion, lambda s, s1, s2: np.stack([row(s, s1, s2) + 0.0 * s for row in rows]))
        except ValueError:
            require(False, "the forces overflow: the speed or the spring is beyond all bounds", code="overflow")
            raise
        sums = np.abs(self.made.coefficients[:3]).sum(axis=2)
        self.peaks = np.array([sums[:, self.made.owner == zone].max(axis=1) for zone in range(len(motion.zones))])

    def combined(self, s: float, constant: float, s2: float) -> "Proxies":
        """Proxies of s·(lift) + constant + s2·(second derivative): sums of those there are."""
        own, left = self.made.coefficients, self.made.error
        sums = s * own[0] + s2 * own[2]
        sums[:, 0] += constant
        error = abs(s) * left[0] + abs(s2) * left[2]
        return chebyshev.Proxies(self.made.owner, self.made.starts, self.made.ends, sums[None], error[None])

    def state(self, zone: int, share: float) -> "tuple[float, float, float]":
        """Lift and its two derivatives at a share of a zone."""
        s, s1, s2 = self.motion.in_zone(zone, share, 2)
        return s, s1, s2

    def angle(self, zone: int, share: float) -> float:
        """The cam angle of a share of a zone."""
        own = self.motion.zones[zone]
        return own.end if share == 1.0 else own.start + (own.end - own.start) * share

    def noise(self, function: "Law", zone: int, share: float) -> float:
        """What the errors of s, s′ and s″ come to in a function of them: its derivatives by complex steps."""
        state, total = self.state(zone, share), 0.0
        for order, part in enumerate(EVALUATED):
            moved = [complex(value) for value in state]
            size = float(self.peaks[zone, order])
            if size:
                moved[order] += STEP * size * 1j
                slope = complex(function(*moved)).imag / (STEP * size)
                total += abs(slope) * part * size
        return total

    def extremes(self, which: int, rounding: "Rounding") -> tuple[Found, Found]:
        """Give the least and the greatest value of a function over the turn, one-sided values included.

        Parameters
        ----------
        which : int
            Which of the functions.
        rounding : callable
            What the function's own arithmetic may round by, from s, s′ and s″.

        Returns
        -------
        (Found, Found)
            The least and the greatest, each at the first place that rounding cannot tell from the best.

        Notes
        -----
        Every candidate comes from `numerics.chebyshev.extremes`, which leaves none out; its value is the function's
        own there. The bound adds what the proxies leave out, what s, s′ and s″ err by, and the arithmetic.
        """
        found = chebyshev.extremes(self.made, 3 + which)
        function = self.functions[which]

        def noise(index: int) -> float:
            zone, share = int(found.owner[index]), float(found.places[index])
            return self.noise(function, zone, share) + rounding(*self.state(zone, share))

        return self._first(found, function, -1.0, noise), self._first(found, function, 1.0, noise)

    def _first(
        self, found: "chebyshev.Extremes", function: "Law", sign: float, noise: "Callable[[int], float]"
    ) -> Found:
        values = sign * found.values
        top = float(values.max())
        ties = np.flatnonzero(values >= top - found.error).tolist()
        places = [(int(found.owner[index]), float(found.places[index]), index) for index in ties[:PLACES]]
        own = [(sign * float(function(*self.state(zone, share))), index) for zone, share, index in places]
        best = max(value for value, _ in own)
        index = next(index for value, index in own if value >= best - found.error)
        error = found.error + max(noise(index) for index in self._rivals(found, values, top, noise))
        return Found(sign * best, self.angle(int(found.owner[index]), float(found.places[index])), error)

    def _rivals(
        self, found: "chebyshev.Extremes", values: "Any", top: float, noise: "Callable[[int], float]"
    ) -> "list[int]":
        """The best place, and of every other zone the best one if its errors could make it the best of all."""
        best = int(values.argmax())
        mine = noise(best)
        near = [best]
        for zone in range(len(self.motion.zones)):
            rows = np.flatnonzero(found.owner == zone)
            if zone == found.owner[best] or not rows.size:
                continue
            index = int(rows[values[rows].argmax()])
            if values[index] >= top - 1e-6 * abs(top) - 1e3 * mine and values[index] + noise(index) >= top - mine:
                near.append(index)
        return near

    def integral(self, which: int) -> tuple[float, float]:
        """Integral of a function over the turn by cam angle, and a bound of that of its magnitude."""
        made = self.made
        own = made.coefficients[3 + which]
        even = np.arange(0, own.shape[1], 2)
        zones = np.array([zone.end - zone.start for zone in self.motion.zones])
        width = (made.ends - made.starts) * zones[made.owner]
        return (
            float(width @ (own[:, even] @ (1.0 / (1.0 - even * even)))),
            float(width @ np.abs(own).sum(axis=1)),
        )


def states(motion: "Motion", count: int = 33) -> "tuple[Any, ...]":
    """Lift and its derivatives at equal shares of every zone, ends included, zone by zone."""
    zones = len(motion.zones)
    return within(motion, np.tile(np.linspace(0.0, 1.0, count), (zones, 1)), np.arange(zones))
