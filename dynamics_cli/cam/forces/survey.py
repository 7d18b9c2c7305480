"""Extremes of functions of a motion, and of quotients of their sums, with bounds of their errors."""

from math import inf

import numpy as np

from dynamics_cli.cam.program.pieces import ALIKE, Cover, widths, within
from dynamics_cli.errors import require
from dynamics_cli.numerics.chebyshev.proxies import Proxies, extremes
from dynamics_cli.numerics.discs import Disc, as_disc
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.cam.program.motion import Motion

    Law = Callable[[Any, Any, Any], Any]


@record
class Found:
    """A value, its cam angle, and the bound of its error."""

    value: Annotated[float, "The value."]
    at: Annotated[float, "Cam angle [rad]."]
    error: Annotated[float, "Bound of its error, in its own unit."]


class Sum:
    """A weighted sum of a survey's rows (s, s′, s″ and its functions) and a constant.

    `weights`: one for each row from the first; missing ones are zero. A disc includes the rounding of a weight.
    """

    __slots__ = ("constant", "weights")

    def __init__(self, weights: "tuple[Any, ...]", constant: "float | Disc" = 0.0) -> None:
        self.weights = weights
        self.constant = constant

    def of(self, rows: "Disc") -> "Disc":
        """The sum of rows (q, n)."""
        total = Disc(np.zeros(rows.shape[1:]), np.zeros(rows.shape[1:])) + as_disc(self.constant)
        for index, weight in enumerate(self.weights):
            if not isinstance(weight, float) or weight:
                total = total + rows[index] * as_disc(weight)
        return total

    def middles(self, count: int) -> "tuple[Any, float]":
        """Weights of the given number of rows, and the constant, without their rounding."""
        padded = np.zeros(count)
        padded[: len(self.weights)] = [float(as_disc(weight).centre) for weight in self.weights]
        return padded, float(as_disc(self.constant).centre)


class Survey:
    """Functions of s, s′ and s″ over a motion, ready for their extremes.

    `functions`: each takes s, ds/dθ, d²s/dθ² as discs and gives the value. Raises InadmissibleError when
    numbers overflow.
    """

    def __init__(self, motion: "Motion", *functions: "Law") -> None:
        self.motion = motion
        self.count = 3 + len(functions)
        rows = (lambda s, s1, s2: s, lambda s, s1, s2: s1, lambda s, s1, s2: s2, *functions)
        try:
            with np.errstate(all="ignore"):
                self.cover = Cover(motion, lambda s, s1, s2: np.stack([row(s, s1, s2) + 0.0 * s for row in rows]))
        except ValueError:
            require(False, "the forces overflow: the speed or the spring is far too large", code="overflow")
            raise
        self.proxies = self.cover.proxies

    def extremes(self, which: int) -> tuple[Found, Found]:
        """Give the minimum and maximum of a function over the turn, one-sided values included.

        `which`: which of the functions. Returns the least and the greatest, each at the first place that is equal to
        the best within rounding.
        """
        (ends,) = self.cover.ends(3 + which)
        return Found(ends.least, ends.least_at, ends.least_error), Found(
            ends.greatest, ends.greatest_at, ends.greatest_error
        )

    def greatest_quotient(self, top: Sum, bottom: Sum) -> Found:
        """Give the greatest quotient of two sums over the turn; the lower one is nowhere below zero.

        Returns the quotient, its first place and bound; infinite where the lower sum is zero and the upper one is above
        its rounding, zero where the upper one is that nowhere.

        Dinkelbach's iteration: q = top/bottom increases until the maximum of top − q·bottom over the turn is zero. The
        quotient itself is never interpolated, and may have a pole nearby, or be 0/0 where a spring without preload
        rests.
        """
        quotient = before = 0.0
        while True:
            places = self._places(top, bottom, quotient)
            zones, shares, gains = places
            with np.errstate(all="ignore"):
                rows = self.cover.values(zones, shares)
                above, below = top.of(rows), bottom.of(rows)
                quotients = np.where(below.centre > 0.0, above.centre / below.centre, inf)
            # minus infinity where rounding leaves the sign of the upper sum open
            quotients = np.where(above.centre > above.radius, quotients, -inf)
            quotient = float(quotients.max())
            if not before * (1.0 + 1e-15) < quotient < inf:
                break
            before = quotient
        index = int(quotients.argmax())
        if not -inf < quotient < inf:
            return Found(max(quotient, 0.0), self._angle(places, index), 0.0)
        alike = np.flatnonzero(quotients >= quotient - ALIKE * quotient)
        excess = above.centre - quotient * below.centre
        blur = above.radius + quotient * below.radius
        blur += 2.0**-52 * (np.abs(above.centre) + quotient * np.abs(below.centre))
        counts = quotients > 0.0
        more = (excess + blur + gains)[counts] / below.centre[counts]
        error = max(float(blur[index] / below.centre[index]), float(more.max()))
        return Found(quotient, self._angle(places, int(alike[0])), error * (1.0 + 2.0**-40))

    def _angle(self, places: "tuple[Any, ...]", index: int) -> float:
        return float(self.cover.angles(*(part[index : index + 1] for part in places[:2]))[0])

    def _places(self, top: Sum, bottom: Sum, quotient: float) -> "tuple[Any, Any, Any]":
        """Zones and shares where top − quotient·bottom may be greatest, and how much it may exceed its values there."""
        (weights, constant), (lower, less) = top.middles(self.count), bottom.middles(self.count)
        weights, constant = weights - quotient * lower, constant - quotient * less
        proxies = self.proxies
        combined = np.tensordot(weights, proxies.coefficients, 1)
        combined[:, 0] += constant
        error = np.abs(weights) @ proxies.error
        candidates = extremes(Proxies(proxies.owner, proxies.starts, proxies.ends, combined[None], error[None]))
        rows = candidates.near(1.0)
        return candidates.owner[rows], candidates.places[rows], candidates.gains[rows]

    def integral(self, which: int) -> tuple[float, float]:
        """Integral of a function over the turn by cam angle, and a bound of that of its magnitude."""
        proxies = self.proxies
        rows = proxies.coefficients[3 + which]
        even = np.arange(0, rows.shape[1], 2)
        width = (proxies.ends - proxies.starts) * np.array(widths(self.motion))[proxies.owner]
        return (
            float(width @ (rows[:, even] @ (1.0 / (1.0 - even * even)))),
            float(width @ np.abs(rows).sum(axis=1)),
        )


def states(motion: "Motion", count: int = 33) -> "tuple[Any, ...]":
    """Lift and its derivatives at equal shares of every zone, ends included, zone by zone."""
    zones = len(motion.zones)
    return within(motion, np.tile(np.linspace(0.0, 1.0, count), (zones, 1)), np.arange(zones))
