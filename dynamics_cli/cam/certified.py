"""Certified extremes of functions of a motion, with what the proxies, the motion and the arithmetic may err by."""

from itertools import pairwise
from math import inf

import numpy as np

from dynamics_cli.cam.motion import radians
from dynamics_cli.cam.pieces import over_pieces, within
from dynamics_cli.errors import require
from dynamics_cli.numerics import chebyshev
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.cam.motion import Motion

    Law = Callable[[Any, Any, Any], Any]
    Place = tuple[int, float]
    Rounding = Callable[[float, float, float], float]

# Errors of s, s′ and s″, in shares of their sums of Chebyshev coefficients on a zone, which no peak exceeds.
EVALUATED = (2e-15, 2e-15, 5e-15)
# Relative error of a named law next to either of its ends.
NAMED = 4e-15
STEP = 1e-30
# At most so many places that rounding cannot tell apart are looked at again.
PLACES = 64
# A piece this far below the best, as a share of the largest value, is not the best whatever it errs by.
NEAR = 1e-3


class _Candidates:
    """Candidates for the greatest value of a row of proxies, and what the proxies of each piece leave out."""

    __slots__ = ("inside", "places", "room", "values")

    def __init__(self, made: "chebyshev.Proxies", which: int = 0) -> None:
        found = chebyshev.extremes(made, which)
        self.values = found.values
        self.places = [(int(zone), float(share)) for zone, share in zip(found.owner, found.places, strict=True)]
        self.room = made.error[which] + 16.0 * 2.0**-53 * np.abs(made.coefficients[which]).sum(axis=1)
        own = made.owner[:, None] == found.owner
        self.inside = own & (found.places >= made.starts[:, None]) & (found.places <= made.ends[:, None])

    def ties(self) -> "tuple[list[Place], float]":
        """The place of the greatest value and all that the proxies cannot tell from it, in order; what they err by."""
        room = np.where(self.inside, self.room[:, None], 0.0).max(axis=0)
        near = np.flatnonzero(self.values + room >= (self.values - room).max())[:PLACES]
        return [self.places[index] for index in near.tolist()], float(room[near].max())

    def reaches(self) -> "list[tuple[float, Place]]":
        """The greatest value of each piece with what its proxies leave out, and where it is."""
        values = np.where(self.inside, self.values, -inf)
        tops = values.argmax(axis=1)
        reach = values[np.arange(tops.size), tops] + self.room
        return [(high, self.places[index]) for high, index in zip(reach.tolist(), tops.tolist(), strict=True)]


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


class Sum:
    """A weighted sum of a survey's rows (s, s′, s″ and its functions) and a constant.

    Parameters
    ----------
    weights : tuple of float
        One for each row from the first; what is left out counts nothing.
    constant : float
        The constant.
    rounding : callable
        What its arithmetic may round by, from s, s′ and s″.
    """

    __slots__ = ("constant", "rounding", "weights")

    def __init__(self, weights: "tuple[float, ...]", constant: float, rounding: "Rounding") -> None:
        self.weights = weights
        self.constant = constant
        self.rounding = rounding


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
        self.rows = (lambda s, s1, s2: s, lambda s, s1, s2: s1, lambda s, s1, s2: s2, *functions)
        try:
            with np.errstate(all="ignore"):
                self.made = over_pieces(
                    motion, lambda s, s1, s2: np.stack([row(s, s1, s2) + 0.0 * s for row in self.rows])
                )
        except ValueError:
            require(False, "the forces overflow: the speed or the spring is beyond all bounds", code="overflow")
            raise
        sums = np.abs(self.made.coefficients[:3]).sum(axis=2)
        self.peaks = np.array([sums[:, self.made.owner == zone].max(axis=1) for zone in range(len(motion.zones))])

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
        for order, error in enumerate(self._errors(zone, share, state[0])):
            if error:
                moved = [complex(value) for value in state]
                step = STEP * float(self.peaks[zone, order])
                moved[order] += step * 1j
                total += abs(complex(function(*moved)).imag / step) * error
        return total

    def _errors(self, zone: int, share: float, s: float) -> "list[float]":
        """Errors of s, s′ and s″; at rest there is nothing but a level."""
        own = self.motion.zones[zone]
        if own.dwell:
            return [2.0**-53 * abs(s), 0.0, 0.0]
        errors = [part * float(size) for part, size in zip(EVALUATED, self.peaks[zone], strict=True)]
        span = self.motion.segments[own.segment]
        if span.law is not None and span.law.monotone:
            # the named laws keep their digits towards both ends of a rise
            level = min(span.low, span.high, key=lambda end: abs(s - end))
            errors[0] = min(errors[0], 2.0**-52 * abs(level) + NAMED * abs(s - level))
        return errors

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
        function = self.rows[3 + which]

        def noise(place: "Place") -> float:
            return self.noise(function, *place) + rounding(*self.state(*place))

        candidates = _Candidates(self.made, 3 + which)
        high = self._first(candidates, function, 1.0, noise)
        candidates.values = -candidates.values
        return self._first(candidates, function, -1.0, noise), high

    def _first(self, candidates: _Candidates, function: "Law", sign: float, noise: "Callable[[Place], float]") -> Found:
        ties, left = candidates.ties()
        own = [(sign * float(function(*self.state(*place))), place) for place in ties]
        best = max(value for value, _ in own)
        place = next(place for value, place in own if value >= best - left)
        # no piece reaches beyond its own best, what its proxies leave out and what it errs by
        floor = best - NEAR * max(abs(best), float(np.abs(candidates.values).max()))
        reach = max(high + noise(at) for high, at in candidates.reaches() if high >= floor)
        return Found(sign * best, self.angle(*place), max(reach - best, noise(place)))

    def greatest_quotient(self, top: Sum, bottom: Sum) -> Found:
        """Give the greatest quotient of two sums over the turn; the lower one is nowhere below zero.

        Parameters
        ----------
        top, bottom : Sum
            The sums.

        Returns
        -------
        Found
            The quotient, its first place and bound; infinite where the lower sum is zero and the upper one is above
            its rounding, zero where the upper one is that nowhere.

        Notes
        -----
        Dinkelbach's iteration: q = top/bottom rises to where top − q·bottom, whose greatest value over the turn is
        certified, comes to zero. The quotient itself is never interpolated, and may have a pole next to the turn, or be
        0/0 where a spring of no preload rests.
        """
        places, _ = self._places(top, None, 0.0)
        place = places[0]
        quotient = self._quotient(top, bottom, place)
        while -inf < quotient < inf:
            places, left = self._places(top, bottom, quotient)
            better = max(self._quotient(top, bottom, one) for one in places)
            if not better > quotient + 1e-15 * abs(quotient):
                break
            quotient = better
            place = next(one for one in places if self._quotient(top, bottom, one) == better)
        if abs(quotient) == inf:
            return Found(max(quotient, 0.0), self.angle(*place), 0.0)
        alike = (one for one in places if self._quotient(top, bottom, one) >= quotient - 4e-15 * quotient)
        # of every zone the first place that might be the best, and of course the best
        rivals = {one[0]: one for one in reversed(places) if self._quotient(top, bottom, one) > 0.0}
        error = max(
            (left + self._noise(top, one) + quotient * self._noise(bottom, one)) / self._value(bottom, one)
            for one in (place, *rivals.values())
        )
        return Found(quotient, self.angle(*next(alike, place)), error)

    def _places(self, top: Sum, bottom: "Sum | None", quotient: float) -> "tuple[list[Place], float]":
        """Where top − quotient·bottom is greatest but for rounding, and what that rounding is."""
        weights, constant = np.zeros(len(self.rows)), top.constant
        weights[: len(top.weights)] += top.weights
        if bottom is not None:
            weights[: len(bottom.weights)] -= quotient * np.array(bottom.weights)
            constant -= quotient * bottom.constant
        own = np.tensordot(weights, self.made.coefficients, 1)
        own[:, 0] += constant
        rounded = 2.0**-51 * np.abs(self.made.coefficients).sum(axis=2)
        error = np.abs(weights) @ (self.made.error + rounded) + 2.0**-51 * abs(constant)
        made = chebyshev.Proxies(self.made.owner, self.made.starts, self.made.ends, own[None], error[None])
        return _Candidates(made).ties()

    def _value(self, one: Sum, place: "Place") -> float:
        state = self.state(*place)
        return one.constant + sum(
            weight * float(row(*state)) for weight, row in zip(one.weights, self.rows, strict=False) if weight
        )

    def _quotient(self, top: Sum, bottom: Sum, place: "Place") -> float:
        """The quotient at a place, or minus infinity where rounding leaves the sign of the upper sum open."""
        above, below = self._value(top, place), self._value(bottom, place)
        if above <= self._noise(top, place):
            return -inf
        return above / below if below > 0.0 else inf

    def _noise(self, one: Sum, place: "Place") -> float:
        rows = zip(one.weights, self.rows, strict=False)
        errors = (abs(weight) * self.noise(row, *place) for weight, row in rows if weight)
        return sum(errors, start=one.rounding(*self.state(*place)))

    def integral(self, which: int) -> tuple[float, float]:
        """Integral of a function over the turn by cam angle, and a bound of that of its magnitude."""
        made = self.made
        own = made.coefficients[3 + which]
        even = np.arange(0, own.shape[1], 2)
        width = (made.ends - made.starts) * np.array(_widths(self.motion))[made.owner]
        return (
            float(width @ (own[:, even] @ (1.0 / (1.0 - even * even)))),
            float(width @ np.abs(own).sum(axis=1)),
        )


def _widths(motion: "Motion") -> "list[float]":
    """Widths of the zones; the ends of a narrow one, as angles, would not tell them."""
    found = []
    for span in motion.segments:
        width = span.end[0] * span.start[1] - span.start[0] * span.end[1], span.end[1] * span.start[1]
        cuts = (0.0, *(span.law.breaks if span.law is not None else ()), 1.0)
        found += [radians(width)[0] * (high - low) for low, high in pairwise(cuts)]
    return found


def states(motion: "Motion", count: int = 33) -> "tuple[Any, ...]":
    """Lift and its derivatives at equal shares of every zone, ends included, zone by zone."""
    zones = len(motion.zones)
    return within(motion, np.tile(np.linspace(0.0, 1.0, count), (zones, 1)), np.arange(zones))
