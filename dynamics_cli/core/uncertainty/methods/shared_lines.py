"""Quantiles from parallel lines that all results share: for results that turn, jump or have kinks, each in its own way.

Along a direction in which most results change, each is interpolated between a few points of a line; lines lie across it
as a lattice. A line's share of values below a level is smooth where that of a point is a jump, so lattices settle far
sooner than a sample of as many points. Kinks are common to results (slip ends for all of them): the cells they lie in
are divided. Where cells are long, what interpolation misses is added from some lines gone through more finely.
"""

import numpy as np

from dynamics_cli.core.uncertainty.methods.lines import Lines
from dynamics_cli.core.uncertainty.methods.outcome import DEFAULT_POINTS, FAIR, FLOOR, Goal, Outcome, width_of
from dynamics_cli.core.uncertainty.space import Space
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.distributions.normal_arrays import density, probability, quantile
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS, lattice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# Replicates; within so many deviations of their mean five numbers lie together, in 98 of 100 cases.
SHIFTS, FACTOR = 12, 3.5
# Lines of a replicate and cells of a line, by the number of inputs (the last: and more), and the ends of lines.
SIZES = {1: (1, 1024), 2: (128, 64), 3: (256, 48), 4: (512, 24)}
REACH = 4.8
# Values of all results together that are kept, how many times as many may be asked for, and the fewest lines.
MOST_VALUES, MOST_TIMES, FEWEST = 8_000_000, 10.0, 32
# Cells that are divided, for each line, their parts, and the bend of a result, in deviations, that is none.
DIVIDED, PARTS, STRAIGHT = 2, 4, 1e-3
# Of cells fewer than these one line in so many is gone through so many times as finely; the share of probability that
# so many cells may miss, and the part of what finer lines add.
FEW_CELLS, EVERY, FINER, MISSING = 48, 16, 4, (5e-5, 0.125)
# Points at which slopes are taken, their distance, and the share of a result's slopes that its lines have at least.
SLOPES, STEP, ALONG = 256, 1e-3, 0.4
# An error of the deviation, and its size beside the interval's, of a result that has none.
UNSETTLED, LONG_TAILED = 0.02, 1.5
# A first guess of quantiles is counted on one line in so many; the share of a value that makes it an atom.
THINNED, ATOM = 16, 2e-3
# Lines that a result's width is taken from; a distance is far that is so many widths.
MANY, FAR = 64, 4.0
# Steps to a quantile, and the length of one, in deviations, that is the last.
MOST_STEPS, LAST = 5, 0.02
# The part of a probability beside which values are counted for a density, and how much that may differ from the lines'.
NEAR, ALIKE = 0.4, 0.25


def _slopes(space: Space, seed: int) -> "Array":
    """For every result the products of its slopes (results, inputs, inputs), as shares of the sum of their squares."""
    z = quantile(lattice(space.size, SLOPES, 1, seed))
    beside = (z + STEP * axis[:, None] for axis in np.eye(space.size))
    values = space.evaluate(np.concatenate([z, *beside], axis=1))
    values = values.reshape(len(values), space.size + 1, -1)
    slopes = np.nan_to_num(values[:, 1:] - values[:, :1])
    products = slopes @ slopes.transpose(0, 2, 1)
    size = np.trace(products, axis1=1, axis2=2)[:, None, None]
    return products / np.where(size > 0.0, size, 1.0)  # type: ignore[no-any-return]


class SharedLines:
    """Lines of one direction, and the rows of the results that change along it; not those that lines suit badly."""

    def __init__(self, space: Space, goal: Goal) -> None:
        left = np.array([row for row in space.rest() if row not in space.whole], dtype=int)
        self.rows: dict[int, int] = {}
        self._known: dict[int, Outcome] = {}
        self._space, self._p = space, goal.p
        if space.size > MOST_DIMENSIONS or not left.size:
            return
        slopes = _slopes(space, goal.seed)[left]
        steepest = np.linalg.eigh(slopes.sum(axis=0))[1][:, -1]
        along = steepest @ slopes @ steepest >= ALONG
        self.rows = {int(row): place for place, row in enumerate(left[along])}
        if not self.rows:
            return
        self._sweep(space, goal, np.linalg.eigh(slopes[along].sum(axis=0))[1][:, ::-1])
        self._known = {row: self._outcome(row, goal) for row in self.rows}
        self.rows = {row: place for row, place in self.rows.items() if self._known[row].estimate <= FAIR}

    def _sweep(self, space: Space, goal: Goal, axes: "Array") -> None:
        """Values on the lines, along the first of the axes; the others, in their order, across it."""
        rows, self._axes = list(self.rows), (axes[:, 0], axes[:, 1:])
        self.count, self.cells = SIZES[min(space.size, max(SIZES))]
        while self.count > FEWEST and len(rows) * SHIFTS * self.count * self.cells > MOST_VALUES:
            self.count //= 2
        self.shifts = int(SHIFTS * min(max(goal.points / DEFAULT_POINTS, 1.0), MOST_TIMES))
        *across, offset = quantile(lattice(space.size, self.count, self.shifts, goal.seed))
        base = axes[:, 1:] @ np.reshape(across, (space.size - 1, offset.size))
        step = 2.0 * REACH / self.cells
        # each line's points are shifted, so that kinks lie anywhere between two of them
        start = (probability(offset) - 0.5) * step - REACH
        self.swept = Swept(space, rows, (axes[:, :1], base, start), self.cells, step)
        self.finer: Swept | None = None
        if self.cells < FEW_CELLS:
            lines = axes[:, :1], base[:, ::EVERY], start[::EVERY]
            self.finer = Swept(space, rows, lines, self.cells * FINER, step / FINER)

    def below(self, place: int, v: float) -> "tuple[Array, float, float]":
        """Each replicate's share of values up to v, the density there, and what the share may miss."""
        share, dense = self.swept.below(place, v)
        shares = share.reshape(self.shifts, -1).mean(axis=1)
        few, part = MISSING
        if self.finer is None:
            return shares, dense, few * (FEW_CELLS / self.cells) ** 2
        apart = (self.finer.below(place, v)[0] - share[::EVERY]).reshape(self.shifts, -1).mean(axis=1)
        return shares + apart, dense, part * abs(float(apart.mean()))

    def outcome(self, result: int, goal: Goal) -> Outcome:
        """One result's quantiles, mean and deviation."""
        return self._known[result] if goal.p is self._p else self._outcome(result, goal)

    def _outcome(self, result: int, goal: Goal) -> Outcome:
        centre = Lines(self._space, result, *self._axes, np.zeros((self._space.size - 1, 1)), np.ones(1))
        place = self.rows[result]
        about, sums = self.swept.moments(place)
        mass, first, second = sums.reshape(3, self.shifts, -1).mean(axis=2)
        if not mass.min() > 0.0:
            message = "almost no case within the inputs' uncertainty is admissible"
            raise InadmissibleError(message, code="inadmissible", hint="check the inputs")
        shared = Shares(self, place, float(mass.mean()))
        quantiles, errors = shared.quantiles(goal.p)
        cells = f"{self.cells} cells, shared by all results"
        outcome = Outcome(f"{self.shifts} shifted lattices of {self.count} lines of {cells}", quantiles, centre)
        outcome.scan, outcome.admissible = shared, shared.admissible  # type: ignore[assignment]
        width, error = width_of(quantiles, goal), max(errors)
        if centre.space.heavy:
            outcome.estimate = max(error / width, FLOOR) if width > 0.0 else FLOOR
            return outcome
        mean = float(first.sum() / mass.sum())
        squares = (second - 2.0 * mean * first + mean * mean * mass) / mass
        outcome.mean, outcome.std = about + mean, float(np.sqrt(max(squares.mean(), 0.0)))
        away = FACTOR * max(_error(first / mass), _error(np.sqrt(np.maximum(squares, 0.0))))
        outcome.tails = away > UNSETTLED * outcome.std and outcome.std > LONG_TAILED * width
        unit, error = (width, error) if outcome.tails else (outcome.std, max(error, away))
        outcome.estimate = max(error / unit, FLOOR) if unit > 0.0 else FLOOR
        return outcome


def _error(numbers: "Array") -> float:
    """The standard error of the mean of replicates."""
    return float(numbers.std(ddof=1) / np.sqrt(numbers.size))


class Shares:
    """One result's distribution function from the lines."""

    def __init__(self, lines: SharedLines, place: int, admissible: float) -> None:
        self._lines = lines
        self._place = place
        self.admissible = admissible
        self._ordered, self._ranks = lines.swept.ordered(place)

    def below(self, v: "Array", tolerance: float) -> "tuple[Array, Array]":
        """The share of admissible values up to v, as one line's."""
        shares = [float(self._lines.below(self._place, level)[0].mean()) for level in v.tolist()]
        return np.array([shares]), np.zeros(len(shares))

    def _guess(self, p: float) -> float:
        place = int(np.searchsorted(self._ranks, p * self._ranks[-1]))
        return float(self._ordered[min(place, self._ordered.size - 1)])

    def quantiles(self, p: "Array") -> "tuple[Array, list[float]]":
        """Quantiles, and the error of each."""
        found = [self._quantile(chance) for chance in p.tolist()]
        return np.array([v for v, _ in found]), [error for _, error in found]

    def _quantile(self, p: float) -> "tuple[float, float]":
        """A quantile and its error: Newton's steps from a guess, or the guess within an atom or a gap."""
        v, wanted = self._guess(p), p * self.admissible
        spread, part = self._guess(0.84) - self._guess(0.16), NEAR * min(p, 1.0 - p)
        beside = self._guess(p + part) - self._guess(p - part)
        low, high = np.searchsorted(self._ordered, v), np.searchsorted(self._ordered, v, side="right")
        atom = self._ranks[high - 1] - self._ranks[max(int(low) - 1, 0)] > ATOM * self._ranks[-1]
        move = error = 0.0
        for _ in range(MOST_STEPS):
            shares, dense, missing = self._lines.below(self._place, v)
            sure = FACTOR * _error(shares) + missing
            if atom or not beside > 0.0:
                before = self._lines.below(self._place, float(np.nextafter(v, -np.inf)))[0].mean()
                if atom and before + sure < wanted < shares.mean() - sure:
                    return v, 0.0
                ends = self._guess(max(p - sure, 0.0)), self._guess(min(p + sure, 1.0))
                return v, max(abs(end - v) for end in ends)
            counted = 2.0 * part * self.admissible / beside
            # lines along which a result is flat have no crossings
            exact = abs(dense / counted - 1.0) < ALIKE
            dense = dense if exact else counted
            move = (wanted - float(shares.mean())) / dense
            v += min(max(move, -spread), spread)
            error = sure / dense + (LAST if exact else ALIKE) * abs(move)
            if abs(move) <= LAST * spread * (1.0 if exact else LAST / ALIKE):
                return v, error
        return v, error + abs(move)


class Swept:
    """Values of results (rows, lines, points) along lines, and in the cells of those that have a kink."""

    def __init__(
        self, space: Space, rows: "list[int]", lines: "tuple[Array, Array, Array]", cells: int, step: float
    ) -> None:
        self._turns: dict[int, Any] = {}
        direction, base, self._start = lines
        self._step = step
        count = self._start.size
        self._s = self._start[:, None] + step * np.arange(cells + 1)

        def at(which: "Any", s: "Array") -> "Array":
            points = base[:, which, None] + direction[:, :, None] * s
            return space.some(points.reshape(space.size, -1), rows).reshape(len(rows), *s.shape)

        self._values = at(slice(None), self._s)
        self._weights = density(self._s)
        some = self._values[:, :MANY].reshape(len(rows), -1)
        self._widths = np.subtract(*np.nanpercentile(some, (70, 30), axis=1))
        kinked = np.sort(self._kinked(DIVIDED * count))
        self._divided = np.zeros((count, cells), dtype=bool)
        self._divided.ravel()[kinked] = True
        self._line, cell = np.divmod(kinked, cells)
        self._inner_start = self._start[self._line] + cell * step
        s = self._inner_start[:, None] + step / PARTS * np.arange(1, PARTS)
        self._inner = np.empty((len(rows), kinked.size, PARTS + 1))
        self._inner[:, :, 0], self._inner[:, :, -1] = (self._values[:, self._line, cell + end] for end in (0, 1))
        self._inner[:, :, 1:-1] = at(self._line, s)

    def _kinked(self, most: int) -> "Array":
        """The cells in which some result bends most, beyond what it bends beside them."""
        bends = np.zeros((self._values.shape[1], self._values.shape[2] - 1))
        for values, width in zip(self._values, self._widths.tolist(), strict=True):
            second = np.diff(values, 2, axis=1)
            size = np.abs(second)
            bend = np.abs(second[:, :-1] + second[:, 1:])
            bend[:, 1:] -= size[:, :-2]
            bend[:, :-1] -= size[:, 2:]
            if width > 0.0:
                np.fmax(bends[:, 1:-1], bend / width, out=bends[:, 1:-1])
        bends *= np.sqrt(self._weights[:, 1:] * self._weights[:, :-1])
        flat = bends.ravel()
        chosen = np.argpartition(flat, -most)[-most:] if most < flat.size else np.arange(flat.size)
        return chosen[flat[chosen] > STRAIGHT]

    def below(self, place: int, v: float) -> "tuple[Array, float]":
        """Each line's share of values up to v, and the density there."""
        values, far = self._values[place], FAR * float(self._widths[place])
        share, dense = _crossed(values, v, (self._start, self._step, far), self._divided)
        inner, more = _crossed(self._inner[place], v, (self._inner_start, self._step / PARTS, far), None)
        share = share + (values[:, -1] <= v) + np.bincount(self._line, inner, minlength=share.size)
        hidden, rest = self._hidden(place, v)
        return share + hidden, (dense + more + rest) / share.size

    def _hidden(self, place: int, v: float) -> "tuple[Array, float]":
        """Each line's share of values beyond a level between points that all lie on its other side: parabolas' ends."""
        values = self._values[place]
        if place not in self._turns:
            rise = np.diff(values, axis=1)
            turns = (rise[:, :-1] * rise[:, 1:] < 0.0) & ~(self._divided[:, :-1] | self._divided[:, 1:])
            self._turns[place] = np.nonzero(turns)
        line, cell = self._turns[place]
        before, middle, beyond = (values[line, cell + k] for k in range(3))
        bend, slope = before - 2.0 * middle + beyond, 0.5 * (beyond - before)
        with np.errstate(all="ignore"):
            square = (2.0 * (v - middle) + slope * slope / bend) / bend
            above = bend > 0.0
            found = (square > 0.0) & ((before > v) == above) & ((middle > v) == above) & ((beyond > v) == above)
            line, cell, bend = line[found], cell[found], bend[found]
            half, at = np.sqrt(square[found]), cell + 1.0 - slope[found] / bend
        ends = self._start[line] + (at + half * np.array([[-1.0], [1.0]])) * self._step
        share = np.bincount(line, np.sign(bend) * np.diff(probability(ends), axis=0)[0], minlength=len(values))
        return share, float((density(ends) * self._step / np.abs(bend * half)).sum())

    def moments(self, place: int) -> "tuple[float, Array]":
        """A number in the midst of the values, and each line's share of them, first and second moment about it."""
        values = self._values[place]
        sound = np.isfinite(values)
        about = float(np.nanmedian(values[:THINNED])) if sound[:THINNED].any() else 0.0
        apart = np.where(sound, values - about, 0.0)
        mass = self._weights * self._step
        first = apart * mass
        return about, np.array([(mass * sound).sum(axis=1), first.sum(axis=1), (first * apart).sum(axis=1)])

    def ordered(self, place: int) -> "tuple[Array, Array]":
        """Values of some lines in order, and the share of all up to each."""
        values, weights = self._values[place, ::THINNED].ravel(), self._weights[::THINNED].ravel()
        sound = ~np.isnan(values)
        values, weights = values[sound], weights[sound]
        order = np.argsort(values)
        return values[order], np.cumsum(weights[order])


def _crossed(
    values: "Array", v: float, lines: "tuple[Array, float, float]", divided: "Array | None"
) -> "tuple[Array, float]":
    """The probability between each line's crossings of a level, upward ones less downward ones, and their density.

    Of lines that start and step so, outside divided cells. Interpolation is cubic between four points (Everett), of
    which those beyond a divided cell are not used. A distance w from the level counts as w/(1 + |w|/far): beside a pole
    that is straight.
    """
    start, step, far = lines
    under = values <= v
    changes = under[:, :-1] != under[:, 1:]
    if divided is not None:
        changes &= ~divided
    at = np.flatnonzero(changes)
    cells = values.shape[1] - 1
    line, cell = np.divmod(at, cells)
    first, last = cell == 0, cell == cells - 1
    if divided is not None:
        marked = divided.ravel()
        first |= marked[np.maximum(at - 1, 0)]
        last |= marked[np.minimum(at + 1, marked.size - 1)]
    with np.errstate(all="ignore"):
        flat, left = values.ravel(), line + at
        w = flat[np.minimum(np.maximum(left + np.arange(-1, 3)[:, None], 0), flat.size - 1)] - v
        before, a, b, beyond = w / (1.0 + np.abs(w) / far)
        rise = b - a
        ahead, behind = before - 2.0 * a + b, a - 2.0 * b + beyond
        ahead, behind = (
            np.where(first, np.where(last, 0.0, behind), ahead),
            np.where(last, np.where(first, 0.0, ahead), behind),
        )
        # beside a jump or an edge of what is admissible there is nothing to be bent
        most = np.abs(rise)
        ahead, behind = (np.nan_to_num(np.minimum(np.maximum(part, -most), most)) for part in (ahead, behind))
        t = -a / rise
        slope = rise
        for _ in range(2):
            bend = (2.0 - t) * ahead + (1.0 + t) * behind
            away = t * (1.0 - t) / 6.0
            slope = rise - (1.0 - 2.0 * t) / 6.0 * bend - away * (behind - ahead)
            t = np.minimum(np.maximum(t - (a + t * rise - away * bend) / slope, 0.0), 1.0)
        # atoms, whole numbers and edges end anywhere in their cell
        t = np.where((a == 0.0) | (b == 0.0) | np.isnan(t), 0.5, t)
        root = start[line] + (cell + t) * step
        dense = np.nan_to_num(density(root) * step / np.abs(slope), posinf=0.0)
    chance = probability(root)
    share = np.bincount(line, np.where(under[line, cell], chance, -chance), minlength=len(values))
    return share, float(dense.sum())
