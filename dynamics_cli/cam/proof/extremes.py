"""Certified extremes of functions of a motion, and of quotients of their sums, with bounds of all errors."""

from math import inf

import numpy as np

from dynamics_cli.cam.program.pieces import FEW, ROUGH, Cover, best_unit, widths, within
from dynamics_cli.errors import require
from dynamics_cli.numerics.chebyshev.proxies import Proxies
from dynamics_cli.numerics.chebyshev.summits import Summits, doubtful, summits
from dynamics_cli.numerics.discs import Disc, as_disc
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.cam.program.motion import Motion

    Law = Callable[[Any, Any, Any], Any]

# quotients that differ by less are equal, and the first place is reported
ALIKE = 4e-15


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

        Dinkelbach's iteration: q = top/bottom increases until the certified maximum of top − q·bottom over the
        turn is zero. The quotient itself is never interpolated, and may have a pole nearby, or be 0/0 where a spring
        without preload rests.
        """
        tops = self._places(top, None, 0.0)
        above, below = self._sums(top, bottom, tops)
        quotient = float(_quotients(above, below)[0])
        while -inf < quotient < inf:
            tops = self._places(top, bottom, quotient)
            above, below = self._sums(top, bottom, tops)
            better = float(_quotients(above, below).max())
            if not better > quotient + 1e-15 * abs(quotient):
                break
            quotient = better
        quotients = _quotients(above, below)
        index = int(quotients.argmax())
        if not -inf < quotient < inf:
            return Found(max(quotient, 0.0), self._angle(tops, index), 0.0)
        alike = np.flatnonzero(quotients >= quotient - ALIKE * quotient)
        error, loose = _off(tops, above, below, quotients, quotient)
        if loose.size and error > ROUGH * quotient:
            more = self._closer(top, bottom, quotient, tops, loose)
            error, _ = _off(tops, above, below, quotients, quotient, more)
        return Found(quotient, self._angle(tops, int(alike[0]) if alike.size else index), error)

    def _closer(self, top: Sum, bottom: Sum, quotient: float, tops: Summits, loose: "Any") -> float:
        """The maximum of top − quotient·bottom on pieces too flat for their proxies: these are cut about a place."""
        if loose.size > FEW:
            return inf

        middles = top.of(Disc(*self.cover.values(tops.rows, tops.units))).centre
        units = np.array([best_unit(tops, middles, row) for row in loose.tolist()])
        # a quantity that vanishes at its maximum gives no scale for its error: it is raised by a fraction of its terms
        size = 0.0625 * float(np.abs(middles).max())

        def left(rows: Disc) -> Disc:
            return (top.of(rows) - bottom.of(rows) * quotient + size)[None]

        with np.errstate(all="ignore"):
            (ends,) = self.cover.cut(left, loose, units).ends(again=False)
        most = ends.greatest - size
        return most + ends.greatest_error + 2.0**-52 * abs(most)

    def _angle(self, tops: Summits, index: int) -> float:
        place = slice(index, index + 1)
        return float(self.cover.angles(tops.rows[place], tops.units[place])[0])

    def _places(self, top: Sum, bottom: "Sum | None", quotient: float) -> Summits:
        """Where top − quotient·bottom may be greatest."""
        weights, constant = top.middles(self.count)
        if bottom is not None:
            lower, less = bottom.middles(self.count)
            weights, constant = weights - quotient * lower, constant - quotient * less
        proxies = self.proxies
        combined = np.tensordot(weights, proxies.coefficients, 1)
        combined[:, 0] += constant
        rounded = 2.0**-50 * np.abs(proxies.coefficients).sum(axis=2)
        error = np.abs(weights) @ (proxies.error + rounded) + 2.0**-51 * abs(constant)
        steep = (
            np.abs(weights) @ (proxies.steep + rounded * combined.shape[1] ** 2) if proxies.steep is not None else None
        )
        difference = Proxies(
            proxies.owner, proxies.starts, proxies.ends, combined[None], error[None], proxies.proved,
            None if steep is None else steep[None],
        )  # fmt: skip
        with np.errstate(all="ignore"):
            return summits(difference, 0, self.cover.still, (1.0,))[0]

    def _sums(self, top: Sum, bottom: Sum, tops: Summits) -> "tuple[Disc, Disc]":
        with np.errstate(all="ignore"):
            rows = Disc(*self.cover.values(tops.rows, tops.units))
            return top.of(rows), bottom.of(rows)

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


def _quotients(above: Disc, below: Disc) -> "Any":
    """Quotients at places; minus infinity where rounding leaves the sign of the upper sum open."""
    with np.errstate(all="ignore"):
        quotients = np.where(below.centre > 0.0, above.centre / below.centre, inf)
    return np.where(above.centre > above.radius, quotients, -inf)


def _off(
    summits_: Summits, above: Disc, below: Disc, quotients: "Any", quotient: float, most: float = inf
) -> "tuple[float, Any]":
    """Error bound of the maximum quotient, from the maximum of above − quotient·below, and the pieces that decide it.

    These are the pieces without a proof about their places; on them the value is at most `most`, where known.
    """
    counts = quotients > 0.0
    excess = above.centre - quotient * below.centre
    blur = above.radius + quotient * below.radius + 2.0**-52 * (np.abs(above.centre) + quotient * np.abs(below.centre))
    with np.errstate(all="ignore"):
        relative = blur / below.centre
        best = int(quotients.argmax())
        more = (excess + blur + np.where(np.isinf(summits_.gains), 0.0, summits_.gains)) / below.centre
        error = max(float(relative[best]), float(more[counts].max()))
        loose = doubtful(summits_, float((excess - blur)[best]))
        open_ = counts & loose[summits_.rows]
        if open_.any():
            tops = np.minimum(summits_.tops[summits_.rows], most)
            error = max(error, float((np.maximum(tops, blur) / below.centre)[open_].max()))
    return error * (1.0 + 2.0**-40), np.flatnonzero(np.bincount(summits_.rows[open_], minlength=1))


def states(motion: "Motion", count: int = 33) -> "tuple[Any, ...]":
    """Lift and its derivatives at equal shares of every zone, ends included, zone by zone."""
    zones = len(motion.zones)
    return within(motion, np.tile(np.linspace(0.0, 1.0, count), (zones, 1)), np.arange(zones))
