"""A motion through phases as polynomials of time, so that two parties can be compared."""

from itertools import pairwise
from math import inf, isfinite

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import only_in_doubles
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.polynomials import derivative, roots_between, shifted, value
from dynamics_cli.numerics.road.leg import faded
from dynamics_cli.numerics.road.slide import require_kept
from dynamics_cli.quantities import Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.numerics.road.leg import Leg

# A start-up is cut where half of a fade is over: so many terms leave 1e-17 of a piece.
TERMS, MOST_PIECES = 14, 400


class Stretch:
    """One piece of a course: distance travelled as a polynomial of the time since `origin`."""

    __slots__ = ("begin", "coefficients", "end", "kind", "origin")

    def __init__(self, kind: str, begin: float, end: float, origin: "Any", coefficients: "list[Any]") -> None:
        self.kind = kind
        self.begin = begin
        self.end = end
        self.origin = origin
        self.coefficients = coefficients


class Course:
    """A party's distance over time; before its first phase and after its last it keeps its speed."""

    def __init__(self, motion: "list[Leg]", begin: "Any", distance: "Any") -> None:
        """`begin` is when the first phase begins, `distance` where the party then is."""
        self.stretches = [Stretch("constant", -inf, plain(begin), begin, [distance, motion[0].start])]
        for leg in motion:
            if leg.kind == "start-up":
                begin, distance = self._starts_up(leg, begin, distance)
                continue
            rise = [distance, leg.start]
            if leg.kind != "build-up":
                rise.append(0.5 * leg.rate)
            elif plain(leg.duration) > 0.0:
                rise += [0.0, leg.rate / (6.0 * leg.duration)]
            after = begin + leg.duration
            self.stretches.append(Stretch(leg.kind, plain(begin), plain(after), begin, rise))
            begin, distance = after, distance + leg.distance
        kind = "constant" if plain(motion[-1].end) > 0.0 else "waiting"
        self.stretches.append(Stretch(kind, plain(begin), inf, begin, [distance, motion[-1].end]))

    def _starts_up(self, leg: "Leg", begin: "Any", distance: "Any") -> "tuple[Any, Any]":
        """A start-up in pieces so short that its series ends within a rounding; where and when it ends."""
        count = 1 + int(2.0 * plain(leg.fade) * plain(leg.duration))
        require(
            count <= MOST_PIECES, "a start-up phase of {time} is too long: its speed settles long before its end",
            time=(leg.duration, Time), code="too-long", hint="make it shorter and add a phase with kind=constant",
        )  # fmt: skip
        step, speed, rate = leg.duration / count, leg.start, leg.rate
        for _ in range(count):
            terms, coefficient = [distance, speed], 0.5 * rate
            for term in range(3, 3 + TERMS):
                terms.append(coefficient)
                coefficient = -coefficient * leg.fade / term
            after = begin + step
            self.stretches.append(Stretch(leg.kind, plain(begin), plain(after), begin, terms))
            gained, more = faded(step, leg.fade)
            distance, speed, rate = (
                distance + speed * step + rate * more,
                speed + rate * gained,
                rate - leg.fade * rate * gained,
            )
            begin = after
        return begin, distance

    def on(self, time: "Any") -> Stretch:
        """The piece that contains a time; at a corner the earlier one."""
        moment = plain(time)
        # finite, of a number or of each of several
        require_kept(moment - moment == 0.0, "a speed or an acceleration, or the difference of two,")
        return next(piece for piece in self.stretches if moment <= piece.end)

    def at(self, time: "Any") -> "tuple[Any, Any, str]":
        """Distance, speed and phase at a time."""
        piece = self.on(time)
        since = time - piece.origin
        return value(piece.coefficients, since), value(derivative(piece.coefficients), since), piece.kind


def changes(
    first: Course, second: Course, combined: "Callable[[list[Any], list[Any]], list[Any]]", begin: float, end: float
) -> "list[tuple[Any, bool]]":
    """The times within [begin, end] at which a combination of two courses changes its sign, and whether it rises.

    `combined` makes one polynomial of those of both courses, over the same time.
    """
    ends = {piece.end for path in (first, second) for piece in path.stretches}
    corners = sorted({begin, end, *(corner for corner in ends if begin < corner < end)})
    times: list[tuple[Any, bool]] = []
    for low, high in pairwise(corners):
        pieces = (first.on(0.5 * (low + high)), second.on(0.5 * (low + high)))
        poly = combined(*(shifted(piece.coefficients, low - piece.origin) for piece in pieces))
        require_kept(
            all(isfinite(plain(part)) for part in poly), "a speed or an acceleration, or the difference of two,"
        )
        slope = derivative(poly)
        for root in roots_between([plain(part) for part in poly], 0.0, high - low):
            steep = plain(value(slope, root))
            # a root at a corner belongs to both pieces
            repeated = times and abs(plain(times[-1][0]) - (low + root)) <= 1e-12 * (1.0 + abs(low))
            if steep != 0.0 and not repeated:
                times.append((low + _settled(poly, root, steep), steep > 0.0))
    return times


def _settled(polynomial: "list[Any]", root: float, steep: float) -> "Any":
    """The root with the bounds and derivatives of the coefficients: one Newton step from the nearest double."""
    residual = value(polynomial, root)
    only_in_doubles(residual)
    return root - residual / steep


def crossings(
    courses: "list[Course]", decisive: "Callable[..., list[list[Any]]]", begin: float, end: float
) -> "list[Any]":
    """The times within [begin, end], in order, at which one of several combinations of courses changes its sign."""
    ends = {piece.end for path in courses for piece in path.stretches}
    corners = sorted({begin, end, *(corner for corner in ends if begin < corner < end)})
    times: list[Any] = []
    for low, high in pairwise(corners):
        pieces = [path.on(0.5 * (low + high)) for path in courses]
        for poly in decisive(*(shifted(piece.coefficients, low - piece.origin) for piece in pieces)):
            require_kept(all(isfinite(plain(part)) for part in poly), "a speed or an acceleration, or their product,")
            slope = derivative(poly)
            for root in roots_between([plain(part) for part in poly], 0.0, high - low):
                steep = plain(value(slope, root))
                if steep != 0.0:
                    times.append(low + _settled(poly, root, steep))
    times.sort(key=plain)
    return times
