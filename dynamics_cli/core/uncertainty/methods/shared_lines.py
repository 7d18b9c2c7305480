"""Quantiles from lines that many results share: for results that turn, jump or have kinks, each in its own way.

The model is evaluated once at dense points on parallel lines, for all results together. Along a line a result is
represented by pieces between the points, and the measure of each piece is nearly exact: only the directions across the
lines are sampled, where kinks have been integrated out. Results that rise in like directions share their lines.
"""

import numpy as np

from dynamics_cli.core.uncertainty.methods.grids import PARTS, crossings
from dynamics_cli.core.uncertainty.methods.lines import Lines
from dynamics_cli.core.uncertainty.methods.outcome import FAIR, FLOOR, REPLICATE_FACTOR, SHIFTS, Goal, Outcome
from dynamics_cli.core.uncertainty.space import Space, complement
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.distributions.normal_arrays import probability
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# In standard deviations: the accuracy of results on shared lines (typically five times better); finer lines are not
# worth their cost.
ACCURACY = 5e-3
# Reach of the lines in standard deviations; a normal variable is beyond it with 2e-8.
REACH = 5.6
POINTS = 97
# For a single input the only line has more, and one of several that alone bears on a result; where many lines are
# needed, each has fewer.
POINTS_ALONE, POINTS_SOLE, POINTS_OF_MANY = 4097, 1025, 49
# Lines across: on a grid with this many for each of one or two remaining dimensions, else this many of each
# lattice; the first try, and the finer one if needed.
GRIDS = {0: (1,), 1: (48, 144), 2: (26, 44)}
COUNTS = (256,)
# The cosine between a result's direction and that of the lines it may share.
ALIKE, OWN = 0.5, 0.95
# More sets of lines than this cost more than one sample for the results they serve badly.
MOST_SETS = 4
STEPS = 8
# Cells are sought once for all values within this part of a result's range.
NEAR = 0.004
# Change on doubling the step, as a multiple of the step's own error, at kinks.
OF_TWICE = 0.5
# Together they err far less than lattices with random shifts would: a tenth or less, as measured.
OF_PARTS = 0.25


def suits(space: Space) -> bool:
    """Whether inputs are two or more, not too many, and continuous with a finite variance."""
    return 1 <= space.size <= MOST_DIMENSIONS and not (space.heavy or space.stepped)


class SharedLines:
    """Values (lines, points) of the results that need them on parallel lines.

    The only line of a `sole` direction is for results that no other direction bears on.
    """

    def __init__(self, space: Space, direction: "Array", count: int, seed: int, *, sole: bool = False) -> None:
        self.direction = direction
        self.count = count
        self.sole = sole = sole or space.size == 1
        across = complement(direction)[:, : 0 if sole else None]
        rest, weights, self.group = crossings(across.shape[1], count, seed)
        self.lines = weights.size
        many = POINTS if space.size - 1 in GRIDS else POINTS_OF_MANY
        self.points = POINTS_ALONE if space.size == 1 else POINTS_SOLE if sole else many
        grid = np.linspace(-REACH, REACH, self.points)
        # Kinks then lie anywhere between two points, and the error of a fixed grid averages out.
        shift = (np.arange(self.lines) * 0.6180339887498949 + 0.5) % 1.0 - 0.5
        self.s = grid + (shift * (grid[1] - grid[0]))[:, None]
        z = (across @ rest)[:, :, None] + direction[:, None, None] * self.s
        rows = space.rest()
        values = space.some(z.reshape(space.size, -1), rows).reshape(-1, self.lines, self.points)
        self.values = dict(zip(rows, values, strict=True))
        below = probability(self.s)
        # Beyond the ends the values of the ends are used.
        below[:, 0], below[:, -1] = 0.0, 1.0
        self.mass = np.diff(below, axis=1) * weights[:, None]

    @property
    def method(self) -> str:
        """Their description in words."""
        if self.lines == 1:
            return f"{self.points} points of the only input, shared by all results"
        if self.group.max() == PARTS - 1:
            return f"a grid of {self.lines} lines that results share, {self.points} points on each"
        return f"{SHIFTS} shifted lattices of {self.count} lines that results share, {self.points} points on each"

    def cells(self, result: int, every: int = 1) -> "Cells":
        """One result between neighbouring points, or between every few of them."""
        mass = self.mass if every == 1 else self.mass.reshape(len(self.mass), -1, every).sum(axis=2)
        s = self.s[:, ::every]
        return Cells(
            self.values[result][:, ::every], mass, self.group, 0.25 * (s[:, :-1] + s[:, 1:]) * (s[0, 1] - s[0, 0])
        )


class Cells:
    """A result on lines, cell by cell: both ends, half its bend, the share of cases and half the fall of their density.

    With t the place in a cell from 0 to 1, the result is a + (b − a) t − bend t(1 − t), and the share of the cell's
    cases up to t is t + fall t(1 − t).
    """

    def __init__(self, values: "Array", mass: "Array", group: "Array", fall: "Array") -> None:
        sound = np.isfinite(values)
        self.whole = bool(sound.all())
        a, b = values[:, :-1], values[:, 1:]
        if not self.whole:
            # Half a cell is admissible, on average, where only one of its ends is.
            mass = mass * (0.5 * (sound[:, :-1].astype(float) + sound[:, 1:]))
            a, b = np.where(sound[:, :-1], a, b), np.where(sound[:, 1:], b, a)
            lost = ~np.isfinite(a)
            a, b = np.where(lost, 0.0, a), np.where(lost, 0.0, b)
        a, b = np.ascontiguousarray(a), np.ascontiguousarray(b)
        self.a, self.b, self.mass, self.group, self.fall = a, b, mass, group, fall
        self.low, self.high = np.minimum(a, b), np.maximum(a, b)
        self.bend = _bend(a, b)
        self.admissible = float(mass.sum())
        self.reach = NEAR * float(self.high.max() - self.low.min())
        self._windows: list[Window] = []

    def replicates(self, by_line: "Array") -> "Array":
        """Sums over the lines of each replicate."""
        return np.bincount(self.group, by_line)

    def moments(self) -> "tuple[Array, Array, Array, float]":
        """Mass, mean and mean square of each replicate, both about a value in the midst."""
        centre = float(self.a[len(self.a) // 2, self.a.shape[1] // 2])
        rise, mass = self.b - self.a, self.mass
        middle = self.a + 0.5 * rise - (rise * self.fall + self.bend) / 6.0 - centre
        sums = (
            mass.sum(axis=1),
            np.einsum("ij,ij->i", mass, middle),
            np.einsum("ij,ij,ij->i", mass, middle, middle) + np.einsum("ij,ij,ij->i", mass, rise, rise) / 12.0,
        )
        share, first, second = map(self.replicates, sums)
        return share, first, second, centre

    def below(self, v: float) -> "tuple[Array, float]":
        """The admissible share up to a value in each replicate, and the density there."""
        for window in self._windows:
            if window.low <= v <= window.high:
                return window.below(v)
        self._windows.append(Window(self, v))
        return self._windows[-1].below(v)

    def quantile(self, p: float, start: float, scale: float) -> "tuple[float, Array, float]":
        """The value below which a given share of the admissible cases lies; the shares there, and the density."""
        wanted = p * self.admissible
        low, high = float(self.low.min()), float(self.high.max())
        v = min(max(start, low), high)
        for step in range(60):
            share, dense = self.below(v)
            excess = float(share.sum()) - wanted
            low, high = (low, v) if excess >= 0.0 else (v, high)
            if abs(excess) <= 1e-7:
                break
            if high - low <= 1e-9 * scale:
                v = high  # a jump of the probability: an atom
                share, dense = self.below(v)
                break
            move = -excess / dense if dense > 0.0 else np.inf
            new = v + move
            v = new if step < STEPS and low < new < high else 0.5 * (low + high)
        return v, share, dense

    def first_quantiles(self, p: "Array") -> "Array":
        """Quantiles of a part of the cells, each taken at its middle."""
        every = max(self.mass.size // 8192, 1)
        middle = (0.5 * (self.low + self.high)).ravel()[::every]
        mass = self.mass.ravel()[::every]
        order = np.argsort(middle)
        ranked = np.cumsum(mass[order])
        place = np.searchsorted(ranked, p * ranked[-1])
        return middle[order][np.minimum(place, ranked.size - 1)]  # type: ignore[no-any-return]


class Window:
    """The cells that values within a small range cut, and the cases below all of these."""

    def __init__(self, cells: Cells, v: float) -> None:
        self.low, self.high = v - cells.reach, v + cells.reach
        over = cells.high > self.low
        self.base = cells.replicates(cells.mass.sum(axis=1, where=~over))
        cut = np.flatnonzero(over & (cells.low <= self.high))
        self.group = cells.group[cut // cells.a.shape[1]]
        self.a, b, self.mass, self.bend, self.fall, self.bottom, self.top = (
            part.ravel()[cut] for part in (cells.a, cells.b, cells.mass, cells.bend, cells.fall, cells.low, cells.high)
        )
        self.rise = b - self.a
        self.curved = np.abs(self.bend) < np.abs(self.rise)
        self.groups = self.base.size

    def below(self, v: float) -> "tuple[Array, float]":
        """The admissible share up to a value within the range in each replicate, and the density there."""
        under = self.top <= v
        cut = np.nonzero((self.bottom <= v) & ~under)[0]
        rise, mass = self.rise[cut], self.mass[cut]
        t = (v - self.a[cut]) / rise
        t = np.where(self.curved[cut], t + self.bend[cut] / rise * t * (1.0 - t), t).clip(0.0, 1.0)
        part = t + self.fall[cut] * t * (1.0 - t)
        inside = mass * np.where(rise > 0.0, part, 1.0 - part)
        share = self.base + np.bincount(self.group[cut], inside, minlength=self.groups)
        share += np.bincount(self.group, np.where(under, self.mass, 0.0), minlength=self.groups)
        return share, float((mass / np.abs(rise)).sum())


def _bend(a: "Array", b: "Array") -> "Array":
    """Half the second difference of each cell: the smaller of those at its ends, none where these turn (kinks)."""
    bend = np.zeros_like(a)
    rise = b - a
    half = 0.5 * (rise[:, 1:] - rise[:, :-1])
    one, other = half[:, :-1], half[:, 1:]
    inner = bend[:, 1:-1]
    np.maximum(np.minimum(one, other), 0.0, out=inner)
    inner += np.minimum(np.maximum(one, other), 0.0)
    return bend


def _moments(cells: Cells) -> "tuple[Array, float, float, tuple[Array, Array]]":
    """The replicates' masses, mean and deviation of all, and those of every replicate (about the mean of all)."""
    share, first, second, centre = cells.moments()
    mean = float(first.sum()) / cells.admissible
    std = float(np.sqrt(max(float(second.sum()) / cells.admissible - mean**2, 0.0)))
    means, squares = first / share, second / share
    return share, centre + mean, std, (means, np.sqrt(np.maximum(squares - 2.0 * mean * means + mean**2, 0.0)))


class Found:
    """One result's numbers, and its probabilities for limits."""

    def __init__(self, cells: Cells, p: "Array") -> None:
        self.cells = cells
        self.p = p
        self.admissible = cells.admissible
        self.share, self.mean, self.std, self.replicates = _moments(cells)
        scale = self.std or 1.0
        quantiles = [
            cells.quantile(q, s, scale) for q, s in zip(p.tolist(), cells.first_quantiles(p).tolist(), strict=True)
        ]
        self.quantiles = np.array([v for v, _, _ in quantiles])
        self.shares = [(shares, dense) for _, shares, dense in quantiles]

    def below(self, v: "Array", tolerance: float) -> "tuple[Array, Array]":
        """The admissible share up to each value, as one line's."""
        shares = [self.cells.below(float(value)) for value in np.asarray(v, dtype=float)]
        return np.array([[share.sum() for share, _ in shares]]), np.array([dense for _, dense in shares])

    def scatter(self) -> float:
        """The scatter of the replicates, in deviations: of mean and deviation, and of probabilities over densities."""
        if not self.std > 0.0 or self.share.size == 1:
            return 0.0
        errors = [float(part.std(ddof=1)) / self.std for part in self.replicates]
        for v, p, (share, dense) in zip(self.quantiles.tolist(), self.p.tolist(), self.shares, strict=True):
            own = float((share / self.share).std(ddof=1))
            sure = REPLICATE_FACTOR * own
            before = float(self.cells.below(v - 1e-7 * self.std)[0].sum()) / self.admissible
            if before + sure < p < float(share.sum()) / self.admissible - sure:
                continue  # well within an atom the quantile is the atom, whatever the scatter
            steep = dense / self.admissible * self.std
            # Where the density vanishes a probability does not determine the quantile.
            errors.append(own / steep if steep > 1e-3 else own)
        factor = OF_PARTS if self.share.size == PARTS else 1.0
        return factor * REPLICATE_FACTOR * max(errors) / float(np.sqrt(self.share.size))

    def apart(self, other: Cells) -> float:
        """How far these numbers are from those of coarser cells, in deviations."""
        if not self.std > 0.0:
            return 0.0
        _, mean, std, _ = _moments(other)
        parts = [abs(self.mean - mean) / self.std, abs(self.std - std) / self.std]
        for v, p, (share, dense) in zip(self.quantiles.tolist(), self.p.tolist(), self.shares, strict=True):
            if float(share.sum()) / self.admissible - p > 1e-3:
                continue  # an atom
            off = abs(float(other.below(v)[0].sum()) / other.admissible - float(share.sum()) / self.admissible)
            steep = dense / self.admissible * self.std
            parts.append(off / steep if steep > 1e-3 else off)
        return max(parts)


def sole_line(space: Space, result: int, direction: "Array", goal: Goal) -> Outcome | None:
    """A result on which one input bears, where it turns or jumps; the edge of what is admissible is found elsewhere."""
    lines = _lines(space, direction, 1, ALIKE, goal.seed, sole=True)
    values = lines.values[result]
    if not np.isfinite(values).all():
        return None
    rise = np.diff(values, axis=1)
    if (rise >= 0.0).all() or (rise <= 0.0).all():
        return None
    return _outcome(lines, space, result, complement(direction), goal)


def shared_lines(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome:
    """One result by lines that it shares with others; finer ones where the first are not accurate enough."""
    wanted = max(goal.accuracy, ACCURACY)
    counts = GRIDS.get(space.size - 1, COUNTS)
    outcome = _outcome(_lines(space, direction, counts[0], ALIKE, goal.seed), space, result, across, goal)
    # Errors fall about in proportion to the number of lines: where that cannot suffice, finer ones are not tried.
    if wanted < outcome.estimate <= 8.0 * wanted and counts[-1] > counts[0]:
        outcome = _outcome(_lines(space, direction, counts[-1], ALIKE, goal.seed), space, result, across, goal)
    if outcome.estimate > FAIR and len(space.shared) < MOST_SETS:
        own = _outcome(_lines(space, direction, counts[0], OWN, goal.seed), space, result, across, goal)
        outcome = own if own.estimate < outcome.estimate else outcome
    return outcome


def _lines(space: Space, direction: "Array", count: int, alike: float, seed: int, *, sole: bool = False) -> SharedLines:
    known: list[SharedLines] = space.sole if sole else space.shared
    fitting = [lines for lines in known if abs(float(lines.direction @ direction)) >= alike and lines.count >= count]
    if not fitting:
        known.append(SharedLines(space, direction, count, seed, sole=sole))
        return known[-1]
    return max(fitting, key=lambda lines: abs(float(lines.direction @ direction)))


def _outcome(lines: SharedLines, space: Space, result: int, across: "Array", goal: Goal) -> Outcome:
    cells = lines.cells(result)
    if not cells.admissible > 1e-6:
        message = "almost no case within the inputs' uncertainty is admissible"
        raise InadmissibleError(message, code="inadmissible", hint="check the inputs")
    numbers = Found(cells, goal.p)
    centre = Lines(space, result, lines.direction, across, np.zeros((space.size - 1, 1)), np.ones(1))
    outcome = Outcome(lines.method, numbers.quantiles, centre)
    outcome.mean, outcome.std, outcome.admissible = numbers.mean, numbers.std, min(numbers.admissible, 1.0)
    outcome.scan = numbers  # type: ignore[assignment]
    outcome.estimate = max(numbers.scatter() + OF_TWICE * numbers.apart(lines.cells(result, 2)), FLOOR)
    return outcome
