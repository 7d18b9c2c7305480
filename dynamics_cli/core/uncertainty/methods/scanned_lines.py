"""Quantiles on scanned lines: for models that turn, jump, stay flat or are partly inadmissible; and one input alone."""

import numpy as np

from dynamics_cli.core.uncertainty.methods.grids import rule
from dynamics_cli.core.uncertainty.methods.lattices import larger
from dynamics_cli.core.uncertainty.methods.lines import Lines
from dynamics_cli.core.uncertainty.methods.outcome import FLOOR, REPLICATE_FACTOR, SHIFTS, Goal, Outcome, width_of
from dynamics_cli.core.uncertainty.methods.scan import REACH, Scan
from dynamics_cli.core.uncertainty.space import Space
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature.lattice import lattice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# Points along the only line when one input is uncertain.
FINE_SCAN = 1025
# The same where every point is a separate call.
SLOW_SCAN = 49
# Scans with smaller steps can be compared with a quarter of their points.
FINE_STEP = 0.05


def alone(space: Space, result: int, direction: "Array", goal: Goal, *, pieces: bool) -> Outcome | None:
    """One input that bears on a result: its own quantiles through the model, exact; by monotone pieces if it turns.

    None where it turns and `pieces` are not wanted: each needs dozens of calls of the model, one by one.
    """
    lines = Lines(space, result, direction, np.zeros((space.size, 0)), np.zeros((0, 1)), np.ones(1))
    if space.stepped:
        return _atoms(space, result, lines, goal)
    points = SLOW_SCAN if space.slow else FINE_SCAN
    if not pieces:
        values = lines.values(np.linspace(-REACH, REACH, points)[None, :])
        if not _rises(values) and not (space.slow and np.isnan(values).any()):
            return None
    scan = Scan(lines, points=points)
    if not np.isnan(scan.values).any() and _rises(scan.values):
        quantiles = lines.values(goal.scores[None, :])[0]
        outcome = _with_moments(Outcome("the input's own quantiles through the model", quantiles, lines), scan)
        outcome.estimate = _coarser(scan, outcome) if outcome.std > 0.0 and not space.heavy else FLOOR
        return outcome
    # where every point is a call of its own, no finer than is asked
    fine = goal if space.slow else Goal(goal.p, goal.scores, 1e-9, goal.points, goal.seed)
    return _scan_outcome(scan, fine, 1, "monotone pieces of the only input")


def _rises(values: "Array") -> bool:
    return bool((np.diff(values[0]) >= 0.0).all())


def _atoms(space: Space, result: int, lines: Lines, goal: Goal) -> Outcome:
    """A listed input alone: the model at every listed value."""
    values = space.distributions[0].values  # type: ignore[attr-defined]
    with np.errstate(all="ignore"):
        results, refused = space.model({**space.fixed, space.names[0]: values})
    values_at = np.array(np.broadcast_to(results[space.results[result]], values.shape), dtype=float)
    if refused is not None:
        values_at[refused] = np.nan
    good = np.sort(values_at[np.isfinite(values_at)])
    place = np.ceil(goal.p * good.size - 1e-12).astype(int) - 1
    outcome = Outcome("the model at every listed value", good[np.clip(place, 0, good.size - 1)], lines)
    outcome.estimate, outcome.admissible = FLOOR, good.size / values.size
    outcome.mean, outcome.std = float(good.mean()), float(good.std())
    outcome.scan = Listed(good)  # type: ignore[assignment]
    return outcome


class Listed:
    """Stands in for a scan where the distribution is a list."""

    def __init__(self, values: "Array") -> None:
        self.values = values
        self.ordered = False
        self.admissible = 1.0

    def below(self, v: "Array", tolerance: float) -> "tuple[Array, Array]":
        """The share of values up to v."""
        if not self.ordered:  # large samples are sorted only if someone asks
            self.values, self.ordered = np.sort(self.values), True
        share = np.searchsorted(self.values, v, side="right") / self.values.size
        return share[None, :], np.zeros(v.size)


def scanned(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome:
    """Growing lattices of scanned lines: for models that turn, jump, stay flat or are partly inadmissible."""
    count = 16
    while True:
        uniform = lattice(space.size, count, SHIFTS, goal.seed)
        rest = quantile(uniform[:-1])
        lines = Lines(space, result, direction, across, rest, np.full(rest.shape[1], 1.0 / rest.shape[1]))
        best = _scan_outcome(
            Scan(lines, uniform[-1] - 0.5), goal, SHIFTS, f"{SHIFTS} shifted lattices of {count} scanned lines"
        )
        grown = larger(count, best.estimate / goal.accuracy)
        while grown > count and space.points + 60 * SHIFTS * grown > goal.points:
            grown //= 2
        if best.estimate <= goal.accuracy or grown == count:
            return best
        count = grown


def scanned_grids(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome | None:
    """Tensor grids of scanned lines: good where probabilities are smooth across the lines; None where they are not."""
    last: Outcome | None = None
    before = np.inf
    for level in range(2, 7):
        lines = Lines(space, result, direction, across, *rule(space.size - 1, level, goal.accuracy))
        outcome = _scan_outcome(Scan(lines), goal, 1, f"tensor Gauss–Hermite, {lines.weights.size} scanned lines")
        if last is not None:
            now = _apart(outcome, last, goal)
            outcome.estimate = max(now, 0.3 * before, outcome.estimate)
            if outcome.estimate <= goal.accuracy:
                return outcome
            if level >= 4 and now > 0.5 * before:
                return None
            before = now
        last = outcome
    return None


def _apart(one: Outcome, other: Outcome, goal: Goal) -> float:
    """The distance of two outcomes in standard deviations."""
    width = one.std if one.std > 0.0 else width_of(one.quantiles, goal)
    if not width > 0.0:
        return 0.0
    parts = [*np.abs(one.quantiles - other.quantiles), abs(one.mean - other.mean), abs(one.std - other.std)]
    return float(np.nanmax(parts)) / width


def _scan_outcome(scan: Scan, goal: Goal, groups: int, method: str) -> Outcome:
    if not scan.admissible > 1e-12:
        raise InadmissibleError(
            "no case within the inputs' uncertainty is admissible", code="inadmissible", hint="check the inputs"
        )
    tolerance = min(max(0.02 * goal.accuracy, 1e-11), 1e-4)
    quantiles, share, slope = scan.quantiles(goal.p, tolerance)
    outcome = _with_moments(Outcome(method, quantiles, scan.lines, groups=groups), scan)
    heavy = scan.lines.space.heavy
    width = width_of(quantiles, goal) if heavy else outcome.std
    if groups > 1 and width > 0.0:
        outcome.estimate = _scan_estimate(scan, outcome, goal, share, slope, width)
    elif width == 0.0 or heavy:
        outcome.estimate = FLOOR
    else:
        outcome.estimate = _coarser(scan, outcome)
    outcome.estimate = max(outcome.estimate, tolerance, _broken(scan, outcome))
    return outcome


def _broken(scan: Scan, outcome: Outcome) -> float:
    """Error of mean and deviation from the rule on partly admissible lines, in deviations."""
    if scan.lines.space.heavy or not outcome.std > 0.0:
        return 0.0
    first, second = (error / scan.admissible for error in scan.broken_error())
    # of the second moment about the scan's centre the mean's part is taken away again
    away = abs(outcome.mean - scan.centre)
    return max(first / outcome.std, (0.5 * second + away * first) / outcome.std**2)


def _with_moments(outcome: Outcome, scan: Scan) -> Outcome:
    """The outcome with the scan's further numbers: the admissible share, mean and deviation where these exist."""
    outcome.scan, outcome.admissible = scan, scan.admissible
    if scan.lines.space.heavy:
        return outcome
    first, second = scan.moments()
    weights = scan.lines.weights
    mean = float(weights @ first) / scan.admissible
    outcome.mean = scan.centre + mean
    outcome.std = float(np.sqrt(max(float(weights @ second) / scan.admissible - mean * mean, 0.0)))
    return outcome


def _coarser(scan: Scan, outcome: Outcome) -> float:
    """How far mean and deviation move with parts of the scan's points, and what may lie beyond its ends.

    On smooth lines every part gives the same. The trapezoid rule errs by (½ − t) h of a jump and by
    (1/6 − t(1 − t)) h²/2 of a bend, t their place within the step h: of four parts, each of every fourth point, some
    differ by six times either at the least, wherever it is.
    """
    every, share = (4, 1.0 / 6.0) if scan.step < FINE_STEP else (2, 0.3)
    weights = scan.lines.weights
    means, stds = [outcome.mean - scan.centre], [outcome.std]
    for start in range(every if every == 4 else 1):
        first, second = (float(weights @ part) / scan.admissible for part in scan.moments(every, start))
        means.append(first)
        stds.append(float(np.sqrt(max(second - first * first, 0.0))))
    apart = share * max(max(means) - min(means), max(stds) - min(stds)) / outcome.std
    cut, squared = (float(weights @ part) / scan.admissible for part in scan.beyond())
    # d std = ½ d(std²)/std
    return max(apart, cut / outcome.std, 0.5 * squared / outcome.std**2, FLOOR)


def _scan_estimate(scan: Scan, outcome: Outcome, goal: Goal, share: "Array", slope: "Array", width: float) -> float:
    """The scatter of replicates: of probabilities over the density (not at atoms and gaps), and of the moments."""
    weights = scan.lines.weights
    pieces = scan.pieces
    mass = np.bincount(pieces.line, scan.measures, minlength=weights.size).reshape(SHIFTS, -1).mean(axis=1)
    if not mass.all():
        # A replicate without an admissible case cannot be compared with the others.
        return np.inf
    shares = share.reshape(SHIFTS, -1, share.shape[1]).mean(axis=1) / mass[:, None]
    errors: list[float] = []
    if not scan.lines.space.heavy:
        means, squares = (part.reshape(SHIFTS, -1).mean(axis=1) / mass for part in scan.moments())
        mean = outcome.mean - scan.centre
        deviations = np.sqrt(np.maximum(squares - 2.0 * mean * means + mean * mean, 0.0))
        errors = [means.std(ddof=1) / width, deviations.std(ddof=1) / width]
    scatter = shares.std(axis=0, ddof=1)
    dense = slope * width / scan.admissible
    # Where the density vanishes a probability does not determine the quantile: the replicates' error stays a
    # probability.
    sure = REPLICATE_FACTOR * scatter
    before = scan.below(outcome.quantiles - 1e-7 * width, 1e-9)[0]
    under, over = (weights @ part / scan.admissible for part in (before, share))
    for e, d, low, high, p in zip(scatter, dense, under + sure, over - sure, goal.p, strict=True):
        # Well within an atom the quantile is the atom, whatever the scatter.
        errors.append(0.0 if low < p < high else float(e / d) if d > 1e-3 else float(e))
    return max(REPLICATE_FACTOR * max(errors) / float(np.sqrt(SHIFTS)), FLOOR)


def exceedance(outcome: Outcome, limits: "Array", goal: Goal) -> "Array":
    """P(result > limit), given admissibility, for each limit."""
    scan = outcome.scan or Scan(outcome.lines)
    outcome.scan = scan
    # A few lines cost nothing: their roots are solved to rounding.
    tolerance = min(max(0.01 * goal.accuracy, 1e-11), 1e-4) if outcome.lines.weights.size > 1 else 1e-12
    share, _ = scan.below(limits, tolerance)
    weights = outcome.lines.weights if share.shape[0] == outcome.lines.weights.size else np.ones(1)
    return np.clip(1.0 - (weights @ share) / scan.admissible, 0.0, 1.0)
