"""Smooth pieces of a motion, each in its own coordinate, and proved extremes over them."""

from itertools import pairwise
from math import ceil, pi

import numpy as np

from dynamics_cli.cam.program.parts import radians
from dynamics_cli.cam.proof.law_discs import Parts, discs
from dynamics_cli.numerics.chebyshev.proxies import Extremes, Proxies, extremes, proxies
from dynamics_cli.numerics.chebyshev.remainders import proved_proxies
from dynamics_cli.numerics.chebyshev.summits import doubtful, settled, summits
from dynamics_cli.numerics.discs import Disc
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.cam.program.motion import Motion

STEP = pi / 12.0
# A relative bound above this is refined, on at most this many pieces, each cut this often about its place.
ROUGH = 30.0 * 2.0**-53
FEW = 8
FINER = 7
# This many places of these cuts are evaluated directly: about a flat place a proxy errs by the rounding of its values.
SINGLY = 2048


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
    proved: Annotated[bool, "Whether the bounds are proved."] = True

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
    """Functions of lift and derivatives over a motion: their proxies, and their values with rounding bounds.

    `function`: takes lift and derivatives, gives values (q, m, n): arithmetic, roots, sines, arc tangents,
    `numpy.stack` and the like, which work on discs (`numerics.discs`) as on arrays. Comparisons and branches on values
    do not: such a function is called with arrays, and what its proxies leave out is estimated (`Proxies.proved` is
    false); so it is for a motion without `parts_of`; `derivatives`: how many derivatives. Raises ValueError when a
    function is not finite inside a piece.
    """

    def __init__(self, motion: "Motion", function: "Callable[..., Any]", derivatives: int = 2) -> None:
        self.motion, self.function, self.derivatives = motion, function, derivatives
        self.owner: Any = None
        self.finer = False
        if not hasattr(motion, "parts_of"):
            self.proxies = _estimated(motion, function, derivatives)
            return
        self.parts, self.rows = _rows(motion)
        self.whole = Parts(self.parts)
        owner = self.rows.owner
        try:
            proxies = proved_proxies(self._sampled, self.rows.starts, self.rows.ends)
        except TypeError:
            self.proxies = _estimated(motion, function, derivatives)
            return
        self.owner = proxies.owner
        self.still = np.array([part.law_piece is None for part in self.parts])[self.rows.which[proxies.owner]]
        self.proxies = Proxies(
            owner[proxies.owner],
            proxies.starts,
            proxies.ends,
            proxies.coefficients,
            proxies.error,
            proxies.proved,
            proxies.steep,
        )

    def _sampled(self, place: Disc, piece: "Any") -> "Any":
        rows = self.rows
        which, width = rows.which[piece], rows.width[piece]
        t = rows.first[piece][:, None]
        t = t + width[:, None] * np.where(rows.far[piece][:, None], 1.0 - place.centre, place.centre)
        if self.finer and not np.ndim(place.radius):
            flat = discs(
                self.whole, np.repeat(which, t.shape[1]), t.ravel(), np.zeros(t.size), self.derivatives, shares=True,
                singly=SINGLY,
            )  # fmt: skip
            return self.function(*(Disc(disc.centre.reshape(t.shape), disc.radius.reshape(t.shape)) for disc in flat))
        radius = np.broadcast_to(place.radius, (piece.size, np.shape(place.radius)[-1] if np.ndim(place.radius) else 1))
        radius = radius * (width * self.whole.span[which])[:, None]
        return self.function(*discs(self.whole, which, t, radius, self.derivatives, shares=True))

    def state(self, pieces_: "Any", units: "Any") -> "tuple[Any, ...]":
        """Lift and derivatives at places (n,) of the proxies' pieces, with their rounding."""
        rows, proxies, row = self.rows, self.proxies, self.owner[pieces_]
        starts, ends = proxies.starts[pieces_], proxies.ends[pieces_]
        share = 0.5 * (starts + ends) + 0.5 * (ends - starts) * units
        share = np.where(units == 1.0, ends, np.where(units == -1.0, starts, share))
        t = rows.first[row] + rows.width[row] * np.where(rows.far[row], 1.0 - share, share)
        # ends of parts are exact
        t = np.where(share == rows.starts[row], rows.opens[row], np.where(share == rows.ends[row], rows.closes[row], t))
        which = rows.which[row]
        return discs(self.whole, which, t, np.zeros(t.shape), self.derivatives, shares=True, exact=True)

    def angles(self, pieces_: "Any", units: "Any") -> "Any":
        """Cam angles of places of the proxies' pieces."""
        proxies = self.proxies
        starts, ends = pieces(self.motion)
        middle, half = 0.5 * (proxies.ends + proxies.starts)[pieces_], 0.5 * (proxies.ends - proxies.starts)[pieces_]
        share = np.where(units == 1.0, proxies.ends[pieces_], middle + half * units)
        share = np.where(units == -1.0, proxies.starts[pieces_], share)
        owner = proxies.owner[pieces_]
        return np.where(share == 1.0, ends[owner], starts[owner] + share * (ends - starts)[owner])

    def values(self, pieces_: "Any", units: "Any") -> "tuple[Any, Any]":
        """The functions (q, n) at places of the proxies' pieces, and their rounding."""
        disc = self.function(*self.state(pieces_, units))
        shape = np.broadcast_shapes(disc.centre.shape, (1, np.size(units)))
        return np.broadcast_to(disc.centre, shape), np.broadcast_to(disc.radius, shape)

    def ends(self, *which: int, again: bool = True) -> "list[Ends]":
        """The certified extremes of some of the functions, or of all; `again` about places that are too flat."""
        which = which or tuple(range(self.proxies.coefficients.shape[0]))
        if self.owner is None:
            return [self._loose(index) for index in which]
        with np.errstate(all="ignore"):
            tops = [top for index in which for top in summits(self.proxies, index, self.still)]
            rows, units = (np.concatenate([getattr(top, name) for top in tops]) for name in ("rows", "units"))
            centres, radii = self.values(rows, units)
            extremes_, places, low = [], [], 0
            for number, top in enumerate(tops):
                part = slice(low, low + top.rows.size)
                low = part.stop
                index, sign = which[number // 2], 1.0 - 2.0 * (number % 2)
                value, place, error = settled(top, sign * centres[index, part], radii[index, part])
                places.append(part.start + place)
                if again and error > ROUGH * abs(value):
                    value, error = self._closer(index, sign, top, centres[index, part], radii[index, part], error)
                extremes_.append((sign * value, error))
            angles = self.angles(rows[places], units[places]).tolist()
        ends = [(value, angle, error) for (value, error), angle in zip(extremes_, angles, strict=True)]
        return [Ends(*low_, *high) for high, low_ in zip(ends[::2], ends[1::2], strict=True)]

    def cut(self, which: "Any", rows: "Any", units: "Any") -> "Cover":
        """The same on some of the proxies' pieces only, cut ever finer about a place (n,) of each of the n."""
        proxies = self.proxies
        starts, ends, owner = [], [], []
        for row, unit in zip(rows.tolist(), units.tolist(), strict=True):
            steps = 2.0 * 4.0 ** -np.arange(FINER)
            edges = np.concatenate((unit - steps, unit + steps[::-1]))
            inner = sorted({-1.0, unit, 1.0, *edges[np.abs(edges) < 1.0].tolist()})
            low, high = float(proxies.starts[row]), float(proxies.ends[row])
            borders = [low, *(0.5 * (low + high) + 0.5 * (high - low) * edge for edge in inner[1:-1]), high]
            starts += borders[:-1]
            ends += borders[1:]
            owner += [int(self.owner[row])] * (len(borders) - 1)
        finer = Cover.__new__(Cover)
        finer.motion, finer.derivatives, finer.rows = self.motion, self.derivatives, self.rows
        finer.parts, finer.whole = self.parts, self.whole
        finer.function, finer.finer = lambda *state: which(self.function(*state)), True
        origin = np.array(owner)
        fine = proved_proxies(
            lambda place, piece: finer._sampled(place, origin[piece]), np.array(starts), np.array(ends)
        )
        finer.owner = origin[fine.owner]
        finer.still = np.zeros(fine.starts.shape, dtype=bool)
        finer.proxies = Proxies(
            self.rows.owner[finer.owner], fine.starts, fine.ends, fine.coefficients, fine.error, True, fine.steep
        )
        return finer

    def _closer(
        self, which: int, sign: float, top: "Any", values: "Any", errors: "Any", error: float
    ) -> "tuple[float, float]":
        """The greatest value and its error where pieces are too flat for their proxies: these are cut about the place.

        Small pieces about a flat place vary little, and their proxies err by little more than the function rounds.
        """
        values = sign * values
        best, sure = float(values.max()), float((values - errors).max())
        loose = doubtful(top, sure)
        rows = np.flatnonzero(loose)
        if not 0 < rows.size <= FEW:
            return best, error
        units = np.array([best_unit(top, values, row) for row in rows.tolist()])
        finer = self.cut(lambda disc: sign * disc[which : which + 1], rows, units)
        (ends,) = finer.ends(again=False)
        settled = ~loose[top.rows]
        gains = np.where(np.isinf(top.gains), 0.0, top.gains)
        reach = max(float((values + errors + gains)[settled].max(initial=-np.inf)), ends.greatest + ends.greatest_error)
        sure = max(sure, ends.greatest - ends.greatest_error)
        best = max(best, ends.greatest)
        return best, min(error, max(reach - best, best - sure) * (1.0 + 2.0**-40))

    def _loose(self, which: int) -> Ends:
        stationary = extremes(self.proxies, which)
        starts, ends = pieces(self.motion)
        theta = starts[stationary.owner] + stationary.places * (ends - starts)[stationary.owner]
        placed = Extremes(stationary.owner, theta, stationary.values, stationary.inside, stationary.error)
        low, high = placed.smallest(), placed.largest()
        return Ends(*low, stationary.error, *high, stationary.error, proved=False)


def best_unit(top: "Any", values: "Any", row: int) -> float:
    """The best place of a piece; its start if none is known."""
    places = np.flatnonzero(top.rows == row)
    return float(top.units[places[values[places].argmax()]]) if places.size else -1.0


def _estimated(motion: "Motion", function: "Callable[..., Any]", derivatives: int) -> Proxies:
    """Proxies by arrays, their remainders estimated from the last coefficients."""
    count = len(motion.zones)
    return proxies(
        lambda place, piece: function(*within(motion, place, piece, derivatives)), np.zeros(count), np.ones(count)
    )


@record
class Rows:
    """Rows of shares of zones that each lie in one part of a motion."""

    owner: Annotated["Any", "The zone."]
    starts: Annotated["Any", "Shares of the zone."]
    ends: Annotated["Any", "Shares of the zone."]
    opens: Annotated["Any", "The same in the part's own coordinate."]
    closes: Annotated["Any", "The same in the part's own coordinate."]
    which: Annotated["Any", "The part."]
    far: Annotated["Any", "Whether its coordinate runs backwards."]
    first: Annotated["Any", "The part's coordinate is `first` and `width` times the share, or what the share leaves."]
    width: Annotated["Any", "The part's coordinate is `first` and `width` times the share, or what the share leaves."]


def _rows(motion: "Motion") -> "tuple[Any, Rows]":
    """Parts of the motion, and the rows: parts cut into steps of 15 degrees or less."""
    parts: list[Any] = []
    owner: list[int] = []
    rows: list[tuple[float, ...]] = []
    for index in range(len(motion.zones)):
        parts_here = motion.parts_of(index)
        laws = [part.law_piece for part in parts_here]
        low, high = (0.0, 1.0) if laws[0] is None else (laws[0].low, laws[-1].high)
        for part, law in zip(parts_here, laws, strict=True):
            a, b = (0.0, 1.0) if law is None else ((law.low - low) / (high - low), (law.high - low) / (high - low))
            steps = 1 if law is None else max(1, ceil((b - a) * (high - low) * part.span / STEP - 1e-9))
            edges = [a + (b - a) * i / steps for i in range(steps)] + [1.0 if part is parts_here[-1] else b]
            far = law is not None and law.far
            first, width = 1.0 - high if far else low, high - low
            own_t = [first + width * (1.0 - edge if far else edge) for edge in edges]
            if law is not None:
                own_t[0], own_t[-1] = law.ends[::-1] if far else law.ends
            rows += [
                (start, end, opens, closes, len(parts), far, first, width)
                for (start, end), (opens, closes) in zip(pairwise(edges), pairwise(own_t), strict=True)
            ]
            owner += [index] * steps
            parts.append(part)
    starts, ends, opens, closes, which, fars, first, width = (np.array(column) for column in zip(*rows, strict=True))
    return parts, Rows(np.array(owner), starts, ends, opens, closes, which.astype(int), fars.astype(bool), first, width)


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
