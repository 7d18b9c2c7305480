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
from dynamics_cli.numerics.quadrature.cells import Cells
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]
    Pair = tuple[Array, Array]

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
# Halvings of a cell in which an edge of what is admissible lies.
HALVINGS = 10
# Change on doubling the step, as a multiple of the step's own error, at kinks.
OF_TWICE = 0.5
# Together they err far less than lattices with random shifts would: a tenth or less, as measured.
OF_PARTS = 0.25


def suits(space: Space) -> bool:
    """Whether inputs are not too many, and continuous with a finite variance."""
    return 1 <= space.size <= MOST_DIMENSIONS and not (space.heavy or space.stepped)


class SharedLines:
    """Values (lines, points) of the results that need them on parallel lines.

    The only line of a `sole` direction is for results that no other direction bears on.
    """

    def __init__(self, space: Space, direction: "Array", count: int, seed: int, *, sole: bool = False) -> None:
        self.direction = direction
        self.count = count
        self.sole = sole = sole or space.size == 1
        across = principal(space, complement(direction))[:, : 0 if sole else None]
        rest, weights, self.group = crossings(across.shape[1], count, seed)
        self.lines = weights.size
        many = POINTS if space.size - 1 in GRIDS else POINTS_OF_MANY
        self.points = POINTS_ALONE if space.size == 1 else POINTS_SOLE if sole else many
        grid = np.linspace(-REACH, REACH, self.points)
        # Kinks then lie anywhere between two points, and the error of a fixed grid averages out.
        shift = (np.arange(self.lines) * 0.6180339887498949 + 0.5) % 1.0 - 0.5
        self.s = grid + (shift * (grid[1] - grid[0]))[:, None]
        rows = space.rest()

        def at(s: "Array", lines: "Array") -> "Array":
            z = (across @ rest)[:, lines] + direction[:, None] * s
            return space.some(z, rows)

        every = np.repeat(np.arange(self.lines), self.points)
        values = at(self.s.ravel(), every).reshape(-1, self.lines, self.points)
        low, high = self.s[:, :-1].copy(), self.s[:, 1:].copy()
        first, last = values[:, :, :-1], values[:, :, 1:]
        if np.isnan(values).any():
            first, last = first.copy(), last.copy()
        _cut(at, (low, high), (first, last))
        self.between = low, high
        self.ends = {row: (first[place], last[place]) for place, row in enumerate(rows)}
        # Beyond the ends the values of the ends are used.
        under, over = probability(low), probability(high)
        under[:, 0] = np.where(low[:, 0] == self.s[:, 0], 0.0, under[:, 0])
        over[:, -1] = np.where(high[:, -1] == self.s[:, -1], 1.0, over[:, -1])
        self.mass = (over - under) * weights[:, None]

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
        return Cells(self.ends[result], self.between, self.mass, self.group, every)

    def sound(self, result: int) -> bool:
        """Whether a result is admissible at all points."""
        return all(bool(np.isfinite(part).all()) for part in self.ends[result])


def principal(space: Space, across: "Array") -> "Array":
    """Orthonormal columns turned so that the first are those along which most results change most.

    The leading coordinates of a lattice are its best.
    """
    gradients = np.array([direction for direction, _ in space.started.values()])
    if not gradients.size:
        return across
    turn: Array = np.linalg.svd(gradients @ across)[2]
    return across @ turn.T


def _cut(at: "Callable[[Array, Array], Array]", between: "Pair", ends: "Pair") -> None:
    """Where an edge of what is admissible lies within a cell, the cell ends there instead; by halving."""
    refused = [np.isnan(part).all(axis=0) for part in ends]
    for inner, outer in ((0, 1), (1, 0)):
        lines, cells = np.nonzero(~refused[inner] & refused[outer])
        if not lines.size:
            continue
        sound, out = between[inner][lines, cells], between[outer][lines, cells]
        found = ends[inner][:, lines, cells]
        for _ in range(HALVINGS):
            middle = 0.5 * (sound + out)
            values = at(middle, lines)
            good = ~np.isnan(values).all(axis=0)
            found = np.where(good, values, found)
            sound, out = np.where(good, middle, sound), np.where(good, out, middle)
        between[outer][lines, cells] = 0.5 * (sound + out)
        ends[outer][:, lines, cells] = found


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
    if not lines.sound(result):
        return None
    first, last = lines.ends[result]
    rise = last - first
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
