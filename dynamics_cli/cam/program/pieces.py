"""Smooth pieces of a motion, each in its own coordinate, and extremes over them."""

from itertools import pairwise

import numpy as np

from dynamics_cli.cam.laws.components import U
from dynamics_cli.cam.program.motion import located
from dynamics_cli.cam.program.parts import radians
from dynamics_cli.numerics.chebyshev.proxies import extremes, proxies
from dynamics_cli.numerics.discs import Disc
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.cam.program.motion import Motion

# values this close to the best are equal: the first place is reported
ALIKE = 1e-14


def pieces(motion: "Motion") -> "tuple[Any, Any]":
    """Starts and ends of the pieces of one turn, in radians and in order."""
    return np.array([zone.start for zone in motion.zones]), np.array([zone.end for zone in motion.zones])


def widths(motion: "Motion") -> "list[float]":
    """Widths of the zones; the ends of a narrow one, as angles, would lose their digits."""
    widths_of_zones = []
    for span in motion.segments:
        width = span.end[0] * span.start[1] - span.start[0] * span.end[1], span.end[1] * span.start[1]
        cuts = (0.0, *(span.law.breaks if span.law is not None else ()), 1.0)
        widths_of_zones += [radians(width)[0] * (high - low) for low, high in pairwise(cuts)]
    return widths_of_zones


def sample(motion: "Motion", theta: "Any", derivatives: int = 3) -> "tuple[Any, ...]":
    """Lift and its derivatives by cam angle at an array of angles."""
    return motion.at(theta, derivatives)


def within(motion: "Motion", place: "Any", piece: "Any", derivatives: int = 2) -> "tuple[Any, ...]":
    """Lift and its derivatives at shares (m, n) of the pieces that the m rows lie in."""
    out = np.empty((derivatives + 1, *place.shape))
    # numpy.unique would import numpy.ma, a quarter of the import of numpy
    for index in sorted(set(piece.tolist())):
        rows = piece == index
        out[:, rows] = motion.in_zone(index, place[rows], derivatives)
    return tuple(out)


@record
class Ends:
    """Minimum and maximum of a function over the turn, each evaluated by the function at the stated place."""

    least: Annotated[float, "The value, its cam angle [rad], and the bound of its error."]
    least_at: Annotated[float, "The value, its cam angle [rad], and the bound of its error."]
    least_error: Annotated[float, "The value, its cam angle [rad], and the bound of its error."]
    greatest: Annotated[float, "The same for the maximum."]
    greatest_at: Annotated[float, "The same for the maximum."]
    greatest_error: Annotated[float, "The same for the maximum."]

    @property
    def error(self) -> float:
        """The larger of both bounds."""
        return max(self.least_error, self.greatest_error)

    def smallest(self) -> tuple[float, float]:
        """The least value, and where."""
        return self.least, self.least_at

    def largest(self) -> tuple[float, float]:
        """The greatest value, and where."""
        return self.greatest, self.greatest_at


class Cover:
    """Functions of lift and derivatives over a motion: interpolants, and values with their rounding.

    `function`: takes lift and derivatives as discs, gives values (q, m, n): arithmetic, roots, sines, arc tangents,
    `numpy.stack` and the like, as for arrays (`numerics.discs`); `derivatives`: how many derivatives. Raises ValueError
    when a function is not finite inside a piece.
    """

    def __init__(self, motion: "Motion", function: "Callable[..., Any]", derivatives: int = 2) -> None:
        self.motion, self.function, self.derivatives = motion, function, derivatives

        def sampled(place: "Any", piece: "Any") -> "Any":
            values = function(*map(Disc, within(motion, place, piece, derivatives))).centre
            return np.broadcast_to(values, (*values.shape[:-2], *place.shape))

        count = len(motion.zones)
        self.proxies = proxies(sampled, np.zeros(count), np.ones(count))

    def values(self, zones: "Any", shares: "Any") -> Disc:
        """The functions (q, n) at shares of zones, with their rounding."""
        return self.function(*bounded(self.motion, zones, shares, self.derivatives))[:, :]  # type: ignore[no-any-return]

    def angles(self, zones: "Any", shares: "Any") -> "Any":
        """Cam angles of shares of zones."""
        starts, ends = pieces(self.motion)
        return np.where(shares == 1.0, ends[zones], starts[zones] + shares * (ends - starts)[zones])

    def ends(self, *which: int) -> "list[Ends]":
        """The extremes of some of the functions, or of all, evaluated by the function itself where they are."""
        which = which or tuple(range(self.proxies.coefficients.shape[0]))
        with np.errstate(all="ignore"):
            found = [(extremes(self.proxies, index), index, sign) for index in which for sign in (-1.0, 1.0)]
            near = [candidates.near(sign) for candidates, _, sign in found]
            zones, shares = (
                np.concatenate([getattr(part[0], name)[rows] for part, rows in zip(found, near, strict=True)])
                for name in ("owner", "places")
            )
            values, low, sides = self.values(zones, shares), 0, []
            for (candidates, index, sign), rows in zip(found, near, strict=True):
                part = slice(low, low + rows.size)
                value, place, error = best_of(
                    sign * values.centre[index, part], values.radius[index, part], candidates.gains[rows]
                )
                at = slice(low + place, low + place + 1)
                sides.append((sign * value, float(self.angles(zones[at], shares[at])[0]), error))
                low = part.stop
        return [Ends(*least, *greatest) for least, greatest in zip(sides[::2], sides[1::2], strict=True)]


def best_of(values: "Any", errors: "Any", gains: "Any") -> "tuple[float, int, float]":
    """The greatest of values at places, the first of the places that are equal to rounding, and its error.

    `errors`: bounds of their rounding; `gains`: how much the function may exceed each value nearby.
    """
    best = float(values.max())
    reach, sure = float((values + errors + gains).max()), float((values - errors).max())
    alike = values >= best - min(ALIKE * abs(best), reach - best + best - sure)
    return best, int(alike.argmax()), max(reach - best, best - sure) * (1.0 + 2.0**-40)


def bounded(motion: "Motion", zones: "Any", shares: "Any", derivatives: int) -> "tuple[Disc, ...]":
    """Lift and derivatives at shares (n,) of zones, with their rounding; shares inside are exact, ends are rounded."""
    centres, radii = np.empty((2, derivatives + 1, zones.size))
    for zone in sorted(set(zones.tolist())):
        rows = np.flatnonzero(zones == zone)
        share = shares[rows]
        for part, inside, t in located(motion.parts_of(zone), share):
            end = (share[inside] == 0.0) | (share[inside] == 1.0)
            for order, number in enumerate(part.bounded(Disc(t, np.where(end, 2.0 * U * t, 0.0)), derivatives)):
                centres[order, rows[inside]], radii[order, rows[inside]] = number.centre, number.radius
    return tuple(map(Disc, centres, radii))


def joint_jumps(motion: "Motion") -> tuple[int, int]:
    """Joints where velocity or acceleration jumps, beyond rounding."""
    counts = [0, 0]
    before = [motion.in_zone(index, 1.0, 2) for index in range(len(motion.zones))]
    after = [motion.in_zone(index, 0.0, 2) for index in range(len(motion.zones))]
    for order in (1, 2):
        peak = max(abs(state[order]) for state in (*before, *after))
        peak = max(peak, *(abs(motion.in_zone(index, 0.37, 2)[order]) for index in range(len(before))))
        for index, state in enumerate(after):
            counts[order - 1] += abs(state[order] - before[index - 1][order]) > 1e-9 * peak
    return counts[0], counts[1]


def column_errors(motion: "Motion", table: "Any") -> "list[float]":
    """Error bounds of lift and derivatives of a table, the largest of all rows."""
    arrays = table.arrays
    angles = arrays["angle"]
    worst = [0.0] * 4
    values = [arrays[name] for name in arrays if name != "angle"]
    for part, rows in motion.by_parts(angles):
        t = np.abs(part.local(angles[rows].copy())) if part.law_piece is not None else np.zeros(rows.shape)
        steep = [np.abs(value) for value in part.give(t, 4)]
        # a place that follows from a cam angle is five roundings off
        for order, number in enumerate(part.bounded(Disc(t, 5.0 * U * t), 3)):
            # less than its change over the rounding of the angle is shown as zero
            still = 4.0 * U * np.abs(angles[rows]) * steep[order + 1]
            errors = number.radius + np.where(values[order][rows] == 0.0, still, 0.0)
            worst[order] = max(worst[order], float(errors.max()))
    return worst
