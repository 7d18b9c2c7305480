"""Quantiles, moments and probabilities of one result by integration along its gradient, with an estimate of the error.

Rules across the direction, in order: tensor Gauss–Hermite (at most two axes) or Smolyak grids; when these do not settle
(kinks, bounded inputs), shifted lattices; when the model turns, jumps or is partly inadmissible, lattices whose lines are
scanned. Errors are in units of the result's standard deviation. The factors of the estimates were fitted on thousands of random
problems so that the true error stays below them; plain differences of levels or replicates do not achieve that.
"""

import numpy as np

from dynamics_cli.core.propagate_lines import ORDERS, Lines, Roots, carry, moments, order_moments, solve
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
MOST_LEVEL = 4
MOST_GRID_LINES = 12_000
# So many lines are not tried when the level before does not promise that they will do.
MANY_LINES = 2_000
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
        return min(max(0.06 * float(np.sqrt(self.accuracy)), 1e-8), 3e-3)


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
    if space.heavy:
        # Along the axis of the heaviest tail, so that the lines beside it differ little.
        heaviest = [made_.std == np.inf for made_ in space.distributions]
        made[int(np.argmax(np.where(heaviest, np.abs(gradient) + 1e-300, 0.0)))] = 1.0
        return made
    size = float(np.sqrt(gradient @ gradient))
    if size > 1e-9 * float(np.abs(bend).max(initial=0.0)) and size > 0.0:
        return gradient / size  # type: ignore[no-any-return]
    overall = _overall(space, result)
    if overall is not None:
        return overall
    made[int(np.argmax(np.abs(bend)))] = 1.0
    return made


def _overall(space: Space, result: int) -> "Array | None":
    """The direction of a plane laid through many points: where the centre is flat, the result may rise elsewhere."""
    if space.size > MOST_DIMENSIONS:
        return None
    z = quantile(lattice(space.size, 128, SHIFTS))
    values = space.evaluate(z)[result]
    good = ~np.isnan(values)
    if good.sum() < 4 * space.size:
        return None
    terms = np.column_stack([np.ones(int(good.sum())), z[:, good].T])
    plane, _, _, _ = np.linalg.lstsq(terms, values[good], rcond=None)
    slope = plane[1:]
    size = float(np.sqrt(slope @ slope))
    # Of an even function only the scatter is left.
    return slope / size if size > 0.1 * float(values[good].std()) else None


def tail_direction(space: Space, result: int, direction: "Array", score: float) -> "Array":
    """The direction half-way between the gradient at the centre and those at both ends of the interval.

    Where inputs are bounded the ends rise along other inputs than the centre; the lines then tilt less.
    """
    count = space.size
    step = 0.5 * np.eye(count)
    ends = [score * direction[:, None], -score * direction[:, None]]
    values = space.evaluate(np.concatenate([part for end in ends for part in (end + step, end - step)], axis=1))[result]
    made = direction.copy()
    for part in values.reshape(2, 2, count):
        gradient = part[0] - part[1]
        size = float(np.sqrt(gradient @ gradient))
        if not size > 0.0:
            return direction
        made += 0.5 * gradient / size
    size = float(np.sqrt(made @ made))
    return made / size if size > 0.5 else direction  # type: ignore[no-any-return]


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
    return [level for level in range(1, MOST_LEVEL + 1) if smolyak.size(rest, level) <= MOST_GRID_LINES]


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
        shape = (rest, level, lines.weights.size)
        guess = carry(last[0], last[1], lines, (last[2], shape)) if last else None
        roots = solve(lines, goal.p, goal.scores, goal.tolerance, guess)
        if roots is None and guess is not None:
            roots = solve(lines, goal.p, goal.scores, goal.tolerance)
        if roots is None or (level == 2 and not order_moments(lines, ORDERS[1]).rising):
            # Far lines of a finer grid that turn or leave the admissible region would bias a coarser one: start anew.
            return None
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
        if made.estimate <= goal.accuracy or _stalled(differences, rest) or _hopeless(space, level, differences, goal):
            break
    return _with_moments(best, goal)


def _stalled(differences: "list[float]", rest: int) -> bool:
    """Whether a kink or a bounded input keeps the levels from converging."""
    if rest <= 2:
        return len(differences) >= 4 and differences[-1] > 0.7 * differences[-2]
    return len(differences) >= 2 and differences[-1] > CONVERGING * differences[-2]


def _hopeless(space: Space, level: int, differences: "list[float]", goal: Goal) -> bool:
    """Whether the next sparse grid would be large and, by what bounded inputs do to it, not good enough."""
    rest = space.size - 1
    if rest <= 2 or space.smooth or not differences:
        return False
    return CONVERGING * differences[-1] > goal.accuracy and smolyak.size(rest, level + 1) > MANY_LINES


def _width(quantiles: "Array", goal: Goal) -> float:
    spread = float(quantiles[-1] - quantiles[0])
    return spread / float(goal.scores[-1] - goal.scores[0])


def _with_moments(outcome: Outcome | None, goal: Goal) -> Outcome | None:
    """Mean and deviation on the lines found; None when the values along them do not rise."""
    if outcome is None:
        return None
    made = moments(outcome.lines, goal.accuracy, outcome.before)
    if not made.rising:
        return None
    outcome.mean, outcome.std = made.mean, made.std
    error = made.error
    if outcome.before is not None and made.std > 0.0:
        before = order_moments(outcome.before, made.order)
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


def _lattice_lines(space: Space, result: int, direction: "Array", across: "Array", count: int, seed: int) -> Lines:
    rest = quantile(lattice(space.size - 1, count, SHIFTS, seed))
    return Lines(space, result, direction, across, rest, np.full(rest.shape[1], 1.0 / rest.shape[1]))


def _lattices(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome | None:
    """Growing lattices until the replicates agree; None when the iteration fails on any line.

    After the first the axes across are turned so that the first of them is the one along which roots shift most: the
    leading coordinates of a lattice are its best.
    """
    if not space.smooth:
        direction = tail_direction(space, result, direction, float(goal.scores[-1]))
        across = complement(direction)
    last: tuple[Lines, Roots] | None = None
    count = FIRST_LATTICE
    while True:
        guess = None
        lines = _lattice_lines(space, result, direction, across, count, goal.seed)
        if last is not None:
            turn = _tilt(*last)
            across = across @ turn
            last[0].rest = turn.T @ last[0].rest
            lines = _lattice_lines(space, result, direction, across, count, goal.seed)
            guess = carry(_thinned(last[0]), _thin_roots(*last), lines)
        if last is None and not order_moments(lines, ORDERS[1]).rising:
            return None
        roots = solve(lines, goal.p, goal.scores, goal.tolerance, guess)
        if roots is None:
            return None
        made = Outcome(f"{SHIFTS} shifted lattices of {count} lines along the gradient", roots.quantiles, lines, groups=SHIFTS)
        made.roots = roots
        made.estimate = replicate_estimate(made, goal)
        last = (lines, roots)
        larger = _larger(count, made.estimate / goal.accuracy)
        cost = 4 * SHIFTS * larger * goal.p.size
        if made.estimate <= goal.accuracy or larger == count or space.points + cost > goal.points:
            return _lattice_moments(made, goal)
        count = larger


def _tilt(lines: Lines, roots: Roots) -> "Array":
    """A rotation of the axes across whose first axis is the linear tilt of the outer roots."""
    thin, few = _thinned(lines), _thin_roots(lines, roots)
    terms = np.vstack([np.ones(thin.rest.shape[1]), thin.rest])
    slopes = np.linalg.lstsq(terms.T, few.s[:, 0] + few.s[:, -1], rcond=None)[0][1:]
    size = float(np.sqrt(slopes @ slopes))
    if len(slopes) < 2 or size < 1e-9:
        return np.eye(len(slopes))
    return np.column_stack([slopes / size, complement(slopes / size)])


def _larger(count: int, ratio: float) -> int:
    """The next lattice: errors fall about as fast as the count grows, or somewhat faster."""
    power = min(max(int(np.ceil(0.85 * np.log2(max(ratio, 1.0)))), 1), 4)
    return min(count << power, MOST_POINTS)


def _thin_roots(lines: Lines, roots: Roots) -> Roots:
    part = slice(None, None, max(1, lines.weights.size // 1024))
    return Roots(roots.s[part], roots.quantiles, roots.slopes[part], 0)


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
    made = moments(outcome.lines, max(goal.accuracy, 0.1 * outcome.estimate), _thinned(outcome.lines))
    if not made.rising:
        return None
    outcome.mean, outcome.std = made.mean, made.std
    outcome.estimate = max(outcome.estimate, made.error)
    return outcome


def _thinned(lines: Lines) -> Lines:
    """Every so many of the lines, about a thousand."""
    made = Lines.__new__(Lines)
    part = slice(None, None, max(1, lines.weights.size // 1024))
    made.space, made.result, made.direction = lines.space, lines.result, lines.direction
    made.rest, made.base = lines.rest[:, part], lines.base[:, part]
    made.weights = np.full(made.rest.shape[1], 1.0 / made.rest.shape[1])
    return made


def _scanned(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome:
    """Growing lattices of scanned lines: for models that turn, jump, stay flat or are partly inadmissible."""
    if space.size <= 3 and not space.stepped:
        made = _scanned_grids(space, result, direction, across, goal)
        if made is not None:
            return made
    count = 16
    while True:
        lines = _lattice_lines(space, result, direction, across, count, goal.seed)
        best = _scan_outcome(Scan(lines), goal, SHIFTS, f"{SHIFTS} shifted lattices of {count} scanned lines")
        larger = _larger(count, best.estimate / goal.accuracy)
        if best.estimate <= goal.accuracy or larger == count or space.points + 60 * SHIFTS * larger > goal.points:
            return best
        count = larger


def _scanned_grids(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome | None:
    """Tensor grids of scanned lines: good where probabilities are smooth across the lines; None where they are not."""
    last: Outcome | None = None
    before = np.inf
    for level in range(2, 7):
        lines = Lines(space, result, direction, across, *rule(space.size - 1, level, goal.accuracy))
        made = _scan_outcome(Scan(lines), goal, 1, f"tensor Gauss–Hermite, {lines.weights.size} scanned lines")
        if last is not None:
            now = _apart(made, last, goal)
            made.estimate = max(now, 0.3 * before, FLOOR)
            if made.estimate <= goal.accuracy:
                return made
            if level >= 4 and now > 0.5 * before:
                return None
            before = now
        last = made
    return None


def _apart(one: Outcome, other: Outcome, goal: Goal) -> float:
    """The distance of two outcomes in standard deviations."""
    width = one.std if one.std > 0.0 else _width(one.quantiles, goal)
    if not width > 0.0:
        return 0.0
    parts = [*np.abs(one.quantiles - other.quantiles), abs(one.mean - other.mean), abs(one.std - other.std)]
    return float(np.nanmax(parts)) / width


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
    heavy = scan.lines.space.heavy
    if heavy:
        made.std = _width(quantiles, goal)
    if groups > 1 and made.std > 0.0:
        made.estimate = _scan_estimate(scan, made, goal, share, slope, first, second)
    elif made.std == 0.0:
        made.estimate = FLOOR
    if heavy:
        made.mean = made.std = float("nan")
    return made


def _scan_estimate(
    scan: Scan, made: Outcome, goal: Goal, share: "Array", slope: "Array", first: "Array", second: "Array"
) -> float:
    """The scatter of replicates: of probabilities over the density (not at atoms and gaps), and of the moments."""
    weights = scan.lines.weights
    pieces = scan.pieces
    mass = np.bincount(pieces.line, scan.measures, minlength=weights.size).reshape(SHIFTS, -1).mean(axis=1)
    shares = share.reshape(SHIFTS, -1, share.shape[1]).mean(axis=1) / mass[:, None]
    means = first.reshape(SHIFTS, -1).mean(axis=1) / mass
    squares = second.reshape(SHIFTS, -1).mean(axis=1) / mass
    deviations = np.sqrt(np.maximum(squares - 2.0 * made.mean * means + made.mean**2, 0.0))
    errors = [] if scan.lines.space.heavy else [means.std(ddof=1) / made.std, deviations.std(ddof=1) / made.std]
    scatter = shares.std(axis=0, ddof=1)
    dense = slope * made.std / scan.admissible
    # Where the density vanishes a probability says nothing of the quantile: the replicates' error stays a probability.
    sure = REPLICATE_FACTOR * scatter
    before = scan.below(made.quantiles - 1e-7 * made.std, 1e-9)[0]
    under, over = (weights @ part / scan.admissible for part in (before, share))
    for e, d, low, high, p in zip(scatter, dense, under + sure, over - sure, goal.p, strict=True):
        # Well within an atom the quantile is the atom, whatever the scatter.
        errors.append(0.0 if low < p < high else float(e / d) if d > 1e-3 else float(e))
    return max(REPLICATE_FACTOR * max(errors) / float(np.sqrt(SHIFTS)), FLOOR)


def exceedance(outcome: Outcome, limits: "Array", goal: Goal) -> "Array":
    """P(result > limit), given admissibility, for each limit."""
    scan = outcome.scan or Scan(outcome.lines)
    outcome.scan = scan
    share, _ = scan.below(limits, min(max(0.01 * goal.accuracy, 1e-11), 1e-4))
    weights = outcome.lines.weights if share.shape[0] == outcome.lines.weights.size else np.ones(1)
    return np.clip(1.0 - (weights @ share) / scan.admissible, 0.0, 1.0)  # type: ignore[no-any-return]
