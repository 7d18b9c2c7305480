"""Quantiles, moments and probabilities of one result by integration along its gradient, with an estimate of the error.

Rules across the direction, in order: tensor Gauss–Hermite (at most two axes) or Smolyak grids; when these do not settle
(kinks, bounded inputs), shifted lattices; when the model turns, jumps or is partly inadmissible, lattices whose lines are
scanned. Errors are in units of the result's standard deviation. The factors of the estimates were fitted on thousands of random
problems so that the true error stays below them; plain differences of levels or replicates do not achieve that.
"""

import numpy as np

from dynamics_cli.core.propagate_lines import Lines, Roots, carry, moments, solve
from dynamics_cli.core.propagate_scan import Scan
from dynamics_cli.core.propagate_space import Space, complement
from dynamics_cli.numerics import smolyak
from dynamics_cli.numerics.hermite import gauss_hermite, tensor
from dynamics_cli.numerics.lattice import MOST_DIMENSIONS, MOST_POINTS, lattice
from dynamics_cli.numerics.normal_arrays import quantile

TYPE_CHECKING = False
if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

TENSOR_COUNTS = (3, 5, 8, 12, 18, 27, 40, 60)
SHIFTS = 8
# Student's 97.5 % quantile with seven degrees of freedom, doubled: replicates are few and not quite normal.
REPLICATE_FACTOR = 2.0 * 2.365
FLOOR = 3e-14
FIRST_LATTICE = 128
# A level that moves less than this share of the level before is converging.
CONVERGING = 0.2
MOST_GRID_LINES = 12_000
_rules: "dict[tuple[int, int, int], tuple[Array, Array]]" = {}


class Goal:
    """What is wanted of every result: probabilities of the quantiles, accuracy, and at most how many points."""

    def __init__(self, p: "Array", scores: "Array", accuracy: float, points: int, seed: int) -> None:
        self.p = p
        self.scores = scores
        self.accuracy = accuracy
        self.points = points
        self.seed = seed

    @property
    def tolerance(self) -> float:
        """How near roots must come before the last step, which squares it."""
        return min(max(0.03 * float(np.sqrt(self.accuracy)), 1e-8), 1e-3)


class Outcome:
    """Quantiles of one result with the lines they were found on (and those one level below), and the error estimated."""

    def __init__(self, method: str, quantiles: "Array", lines: Lines, *, groups: int = 1) -> None:
        self.method = method
        self.quantiles = quantiles
        self.lines = lines
        self.groups = groups
        self.before: Lines | None = None
        self.scan: Scan | None = None
        self.roots: Roots | None = None
        self.estimate = float("inf")
        self.admissible = 1.0
        self.mean = float("nan")
        self.std = float("nan")

    @property
    def width(self) -> float:
        """A standard deviation, about."""
        return self.std if self.std > 0.0 else 0.0


def direction_of(space: Space, probe: "Array", result: int) -> "Array":
    """The unit vector along which a result rises fastest; along the most curved axis where it does not rise."""
    count = space.size
    centre, ahead, behind = probe[result, 0], probe[result, 1 : count + 1], probe[result, count + 1 : 2 * count + 1]
    gradient = np.nan_to_num(ahead - behind)
    bend = np.nan_to_num(ahead + behind - 2.0 * centre)
    made = np.zeros(count)
    size = float(np.sqrt(gradient @ gradient))
    if size > 1e-9 * float(np.abs(bend).max(initial=0.0)) and size > 0.0:
        return gradient / size  # type: ignore[no-any-return]
    made[int(np.argmax(np.abs(bend)))] = 1.0
    return made


def integrate(space: Space, result: int, direction: "Array", goal: Goal, asked: str) -> Outcome:
    """The best outcome for one result within the goal's points."""
    if space.size == 1:
        return _alone(space, result, direction, goal)
    across = complement(direction)
    best: Outcome | None = None
    if asked != "lattice" and not space.stepped:
        best = _grids(space, result, direction, across, goal)
        if best is not None and (best.estimate <= goal.accuracy or asked == "quadrature"):
            return best
    if space.size - 1 <= MOST_DIMENSIONS:
        if not space.stepped:
            other = _lattices(space, result, direction, across, goal)
            if other is not None and (best is None or other.estimate < best.estimate):
                best = other
        if best is None:
            best = _scanned(space, result, direction, across, goal)
    assert best is not None
    return best


def rule(rest: int, level: int, accuracy: float) -> "tuple[Array, Array]":
    """Points and weights across the direction; tensor points of no weight are left out."""
    if rest > 2:
        return smolyak.smolyak(rest, level)
    power = max(-15, int(np.floor(np.log10(accuracy))) - 4)
    key = (rest, level, power)
    if key not in _rules:
        points, weights = tensor(*gauss_hermite(TENSOR_COUNTS[level - 1]), rest)
        order = np.argsort(weights)
        light = order[np.cumsum(weights[order]) <= 10.0**power]
        kept = np.setdiff1d(np.arange(weights.size), light)
        _rules[key] = points[:, kept], weights[kept] / weights[kept].sum()
    return _rules[key]


def _levels(rest: int, goal: Goal) -> "list[int]":
    if rest <= 2:
        return list(range(1, len(TENSOR_COUNTS) + 1))
    return [level for level in range(1, 5) if smolyak.size(rest, level) <= MOST_GRID_LINES]


def _grids(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome | None:
    """Levels of tensor or sparse grids until two agree; None when the model is not monotone along the lines."""
    rest = space.size - 1
    name = "tensor Gauss–Hermite" if rest <= 2 else "Smolyak"
    factor = 0.03 if space.smooth else 0.3
    best: Outcome | None = None
    differences: list[float] = []
    last: tuple[Lines, Roots, tuple[int, int]] | None = None
    for level in _levels(rest, goal):
        lines = Lines(space, result, direction, across, *rule(rest, level, goal.accuracy))
        key = (rest, level)
        shape = (rest, level, lines.weights.size)
        guess = carry(last[0], last[1], lines, (last[2], shape)) if last else None
        roots = solve(lines, goal.p, goal.scores, goal.tolerance, guess)
        if roots is None and guess is not None:
            roots = solve(lines, goal.p, goal.scores, goal.tolerance)
        if roots is None:
            return _not_rising(best)
        made = Outcome(f"{name} along the gradient, {lines.weights.size} lines", roots.quantiles, lines)
        made.roots = roots
        if last is not None:
            width = _width(roots.quantiles, goal)
            differences.append(float(np.abs(roots.quantiles - last[1].quantiles).max()) / width if width > 0.0 else 0.0)
            made.before = last[0]
            now = differences[-1]
            made.estimate = max(now, factor * differences[-2] if len(differences) > 1 else np.inf, FLOOR)
            if len(differences) == 1 and now < 1e-3 * goal.accuracy:
                made.estimate = max(30.0 * now, FLOOR)
        if best is None or made.estimate <= best.estimate:
            best = made
        last = (lines, roots, shape)
        if made.estimate <= goal.accuracy or _stalled(differences, rest):
            break
        del key
    return _with_moments(best, goal)


def _stalled(differences: "list[float]", rest: int) -> bool:
    """Whether a kink or a bounded input keeps the levels from converging."""
    if rest <= 2:
        return len(differences) >= 4 and differences[-1] > 0.7 * differences[-2]
    return len(differences) >= 2 and differences[-1] > CONVERGING * differences[-2]


def _not_rising(best: Outcome | None) -> None:
    """Far lines of a finer grid that turn or leave the admissible region would bias a coarser one: start anew."""
    return None


def _width(quantiles: "Array", goal: Goal) -> float:
    spread = float(quantiles[-1] - quantiles[0])
    return spread / float(goal.scores[-1] - goal.scores[0])


def _with_moments(outcome: Outcome | None, goal: Goal) -> Outcome | None:
    """Mean and deviation on the lines found; None when the values along them do not rise."""
    if outcome is None:
        return None
    made = moments(outcome.lines, goal.accuracy)
    if not made.rising:
        return None
    outcome.mean, outcome.std = made.mean, made.std
    error = made.error if np.isfinite(made.error) else 0.0
    if outcome.before is not None and made.std > 0.0:
        before = moments(outcome.before, goal.accuracy, made.order)
        if not np.isnan(before.mean):
            apart = max(abs(before.mean - made.mean), abs(before.std - made.std)) / made.std
            error = max(error, apart if outcome.estimate > goal.accuracy else min(apart, 0.3 * apart + goal.accuracy))
    outcome.estimate = max(outcome.estimate, error)
    return outcome


def _alone(space: Space, result: int, direction: "Array", goal: Goal) -> Outcome:
    """One uncertain input: its own quantiles through the model, exact; by monotone pieces where it turns."""
    lines = Lines(space, result, direction, np.zeros((1, 0)), np.zeros((0, 1)), np.ones(1))
    if not space.stepped:
        scan = Scan(lines)
        rising = not np.isnan(scan.values).any() and bool((np.diff(scan.values[0]) >= 0.0).all())
        if rising:
            quantiles = lines.values(goal.scores[None, :])[0]
            made = Outcome("the input's own quantiles through the model", quantiles, lines)
            made.scan = scan
            made.estimate = FLOOR
            first, second = scan.moments()
            made.mean = float(first[0])
            fine = moments(lines, goal.accuracy)
            made.std = fine.std if fine.rising else float(np.sqrt(max(second[0] - first[0] ** 2, 0.0)))
            return made
        made = _scan_outcome(scan, goal, 1, "monotone pieces of the only input")
        made.estimate = max(1e-9, FLOOR)
        return made
    return _atoms(space, result, lines, goal)


def _atoms(space: Space, result: int, lines: Lines, goal: Goal) -> Outcome:
    """A listed input alone: the model at every listed value."""
    values = space.distributions[0].values  # type: ignore[attr-defined]
    with np.errstate(all="ignore"):
        results, refused = space.model({**space.fixed, space.names[0]: values})
    found = np.array(np.broadcast_to(results[space.results[result]], values.shape), dtype=float)
    if refused is not None:
        found[refused] = np.nan
    good = np.sort(found[np.isfinite(found)])
    place = np.ceil(goal.p * good.size - 1e-12).astype(int) - 1
    made = Outcome("the model at every listed value", good[np.clip(place, 0, good.size - 1)], lines)
    made.estimate, made.admissible = FLOOR, good.size / values.size
    made.mean, made.std = float(good.mean()), float(good.std())
    made.scan = _Listed(good)  # type: ignore[assignment]
    return made


class _Listed:
    """Stands in for a scan where the distribution is a list."""

    def __init__(self, values: "Array") -> None:
        self.values = values
        self.admissible = 1.0

    def below(self, v: "Array", tolerance: float) -> "tuple[Array, Array]":
        """The share of values up to v."""
        share = np.searchsorted(self.values, v, side="right") / self.values.size
        return share[None, :], np.zeros(v.size)


def _lattice_lines(
    space: Space, result: int, direction: "Array", across: "Array", count: int, seed: int, rest: "Array | None" = None
) -> Lines:
    """Lattice lines, the old ones (`rest`) first when a lattice is doubled; every replicate keeps its own columns."""
    axes = space.size - 1
    fresh = quantile(lattice(axes, count, SHIFTS, seed, start=0 if rest is None else 1))
    if rest is not None:
        old = rest.reshape(axes, SHIFTS, -1)
        fresh = np.concatenate([old, fresh.reshape(axes, SHIFTS, -1)], axis=2).reshape(axes, -1)
    return Lines(space, result, direction, across, fresh, np.full(fresh.shape[1], 1.0 / fresh.shape[1]))


def _lattices(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome | None:
    """Doubled lattices until the replicates agree; None when the iteration fails on any line."""
    best: Outcome | None = None
    last: tuple[Lines, Roots] | None = None
    count = FIRST_LATTICE
    rest: Array | None = None
    while count <= MOST_POINTS:
        lines = _lattice_lines(space, result, direction, across, count, goal.seed, rest)
        rest = lines.rest
        guess = _carried(last, lines) if last else None
        roots = solve(lines, goal.p, goal.scores, goal.tolerance, guess)
        if roots is None:
            return None
        best = Outcome(f"{SHIFTS} shifted lattices of {count} lines along the gradient", roots.quantiles, lines, groups=SHIFTS)
        best.roots = roots
        best.estimate = replicate_estimate(best, goal)
        enough = space.points + 3 * 4 * lines.weights.size * goal.p.size > goal.points
        if best.estimate <= goal.accuracy or enough:
            break
        last = (lines, roots)
        count *= 2
    return _lattice_moments(best, goal)


def _carried(last: "tuple[Lines, Roots]", lines: Lines) -> "tuple[Array, Array]":
    """Old lines keep their roots; new ones start from a quadratic through a part of the old ones."""
    old, roots = last
    part = slice(None, None, max(1, old.weights.size // 1024))
    few = Lines.__new__(Lines)
    few.rest, few.weights = old.rest[:, part], old.weights[part]
    s, slope = carry(few, Roots(roots.s[part], roots.quantiles, roots.slopes[part], 0), lines)
    half = old.weights.size // SHIFTS
    for made, known in ((s, roots.s), (slope, roots.slopes)):
        made.reshape(SHIFTS, 2 * half, -1)[:, :half] = known.reshape(SHIFTS, half, -1)
    return s, slope


def replicate_estimate(outcome: Outcome, goal: Goal) -> float:
    """The scatter of the replicates' probabilities at the common quantiles, over the density."""
    from dynamics_cli.numerics.normal_arrays import probability

    assert outcome.roots is not None
    share = probability(outcome.roots.s).reshape(SHIFTS, -1, goal.p.size).mean(axis=1)
    scatter = share.std(axis=0, ddof=1) / np.sqrt(SHIFTS)
    dense = outcome.roots.density(outcome.lines.weights)
    width = _width(outcome.quantiles, goal)
    if not width > 0.0:
        return FLOOR
    return max(float((REPLICATE_FACTOR * scatter / dense).max()) / width, FLOOR)


def _lattice_moments(outcome: Outcome | None, goal: Goal) -> Outcome | None:
    if outcome is None:
        return None
    made = moments(outcome.lines, max(goal.accuracy, 0.1 * outcome.estimate))
    if not made.rising:
        return None
    outcome.mean, outcome.std = made.mean, made.std
    if np.isfinite(made.error):
        outcome.estimate = max(outcome.estimate, made.error)
    return outcome


def _scanned(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome:
    """Doubled lattices of scanned lines: for models that turn, jump, stay flat or are partly inadmissible."""
    count = 16
    rest: Array | None = None
    while True:
        lines = _lattice_lines(space, result, direction, across, count, goal.seed, rest)
        rest = lines.rest
        best = _scan_outcome(Scan(lines), goal, SHIFTS, f"{SHIFTS} shifted lattices of {count} scanned lines")
        if best.estimate <= goal.accuracy or 2 * count > MOST_POINTS:
            return best
        if space.points + 2 * 60 * lines.weights.size > goal.points:
            return best
        count *= 2


def _scan_outcome(scan: Scan, goal: Goal, groups: int, method: str) -> Outcome:
    from dynamics_cli.errors import InadmissibleError

    if not scan.admissible > 1e-12:
        raise InadmissibleError(
            "no case within the inputs' uncertainty is admissible", code="inadmissible", hint="check the inputs"
        )
    tolerance = min(max(0.02 * goal.accuracy, 1e-11), 1e-4)
    quantiles, share, slope = scan.quantiles(goal.p, tolerance)
    made = Outcome(method, quantiles, scan.lines, groups=groups)
    made.scan, made.admissible = scan, scan.admissible
    first, second = scan.moments()
    weights = scan.lines.weights
    made.mean = float(weights @ first) / scan.admissible
    made.std = float(np.sqrt(max(float(weights @ second) / scan.admissible - made.mean**2, 0.0)))
    if groups > 1 and made.std > 0.0:
        made.estimate = _scan_estimate(scan, made, share, slope, first, second)
    elif made.std == 0.0:
        made.estimate = FLOOR
    return made


def _scan_estimate(
    scan: Scan, made: Outcome, share: "Array", slope: "Array", first: "Array", second: "Array"
) -> float:
    """The scatter of replicates: of probabilities over the density (not at atoms and gaps), and of the moments."""
    weights = scan.lines.weights
    pieces = scan.pieces
    mass = np.bincount(pieces.line, scan.measures, minlength=weights.size).reshape(SHIFTS, -1).mean(axis=1)
    shares = share.reshape(SHIFTS, -1, share.shape[1]).mean(axis=1) / mass[:, None]
    means = first.reshape(SHIFTS, -1).mean(axis=1) / mass
    squares = second.reshape(SHIFTS, -1).mean(axis=1) / mass
    deviations = np.sqrt(np.maximum(squares - 2.0 * made.mean * means + made.mean**2, 0.0))
    errors = [means.std(ddof=1) / made.std, deviations.std(ddof=1) / made.std]
    scatter = shares.std(axis=0, ddof=1)
    dense = slope * made.std / scan.admissible
    # Where the density vanishes a probability says nothing of the quantile: the replicates' error stays a probability.
    errors += [float(e / d) if d > 1e-3 else float(e) for e, d in zip(scatter, dense, strict=True)]
    return max(REPLICATE_FACTOR * max(errors) / float(np.sqrt(SHIFTS)), FLOOR)


def exceedance(outcome: Outcome, limits: "Array", goal: Goal) -> "Array":
    """P(result > limit), given admissibility, for each limit."""
    scan = outcome.scan or Scan(outcome.lines)
    outcome.scan = scan
    share, _ = scan.below(limits, min(max(0.01 * goal.accuracy, 1e-11), 1e-4))
    weights = outcome.lines.weights if share.shape[0] == outcome.lines.weights.size else np.ones(1)
    return np.clip(1.0 - (weights @ share) / scan.admissible, 0.0, 1.0)  # type: ignore[no-any-return]
