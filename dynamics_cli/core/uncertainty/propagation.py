"""Uncertain inputs through any model: distributions in, distributions and their drivers out.

`propagate` takes a model on arrays and the inputs' distributions and gives, for every result, mean, median, standard
deviation and interval with an error estimate of its own; variance shares; covariances; probabilities beyond limits;
and, separately labelled, the range over the corners of all the inputs' intervals.
"""

import numpy as np

from dynamics_cli.core.deadline import Reached, stop
from dynamics_cli.core.inputs.settings import METHODS
from dynamics_cli.core.uncertainty.interval_ends import add_corners
from dynamics_cli.core.uncertainty.methods.choice import integrate, start
from dynamics_cli.core.uncertainty.methods.classical import Plain, Sample, linear, second_order, unscented
from dynamics_cli.core.uncertainty.methods.outcome import DEFAULT_POINTS, FAIR, Goal, Outcome, direction_of
from dynamics_cli.core.uncertainty.methods.scanned_lines import Listed, exceedance
from dynamics_cli.core.uncertainty.methods.surrogate import StandIn, suits
from dynamics_cli.core.uncertainty.space import Space
from dynamics_cli.core.uncertainty.straight import Straight
from dynamics_cli.core.uncertainty.variance_shares import Shares, variance_shares
from dynamics_cli.errors import InadmissibleError, UsageError
from dynamics_cli.numerics.distributions import normal
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature.lattice import DEFAULT_SEED, MOST_DIMENSIONS, lattice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.inputs.uncertain.distributions import Distribution
    from dynamics_cli.core.uncertainty.space import Model

    Array = NDArray[Any]

DEFAULT_ACCURACY = 1e-4
# Points of a distribution function for a picture.
CURVE_POINTS = 121
# Polynomials that miss more than this share of a result's variance are not used for its drivers.
MOST_MISSED = 0.1


class Spread:
    """One result's distribution in numbers."""

    def __init__(self, name: str, method: str, quantiles: "Sequence[float]", mean: float, std: float) -> None:
        self.name, self.method = name, method
        self.interval = (float(quantiles[0]), float(quantiles[-1]))
        self.median = float(quantiles[len(quantiles) // 2])
        self.mean = float(mean)
        self.std = float(std)
        self.estimate = 0.0
        self.tails = False
        self.admissible = 1.0
        self.first: list[float] = []
        self.total: list[float] = []
        self.beyond: list[tuple[float, float]] = []
        self.levels: list[tuple[float, float]] = []
        self.cumulative: tuple[list[float], list[float]] = ([], [])
        self.cases = 0  # how many were counted for the curve; 0 where it is an integral
        self.corners: tuple[float, float] | None = None
        self.tornado: list[tuple[float, float]] = []

    @property
    def varies(self) -> bool:
        """Whether the result has a distribution at all."""
        return self.interval[0] < self.interval[1]

    def number(self, which: str) -> float:
        """One of mean, median, std, low and high."""
        if which in ("low", "high"):
            return self.interval[which == "high"]
        return float(getattr(self, which))


class Propagation:
    """All results: `spreads` by name, `inputs` in the order of shares, `correlation` of the results.

    `correlated` lists the inputs treated as correlated.
    """

    def __init__(self, space: Space, coverage: float, seed: int) -> None:
        self.inputs = space.names
        self.space = space
        self.coverage = coverage
        self.seed = seed
        self.spreads: dict[str, Spread] = {}
        self.correlated: dict[tuple[str, str], float] = {}
        self.correlation: Array | None = None
        self.shares_method, self.shares_error = "", 0.0
        self.points = 0
        self.remedy = "raise --samples"  # where intervals are known poorly
        # All results, where a time limit has left some of them without a spread.
        self.stopped: list[str] = []

    def varying(self) -> "set[str]":
        """The results that vary; a vector is one, whichever of its components do."""
        return {name.partition("[")[0] for name, spread in self.spreads.items() if spread.varies}

    @property
    def estimate(self) -> float:
        """The largest error estimate, in standard deviations of the result it belongs to."""
        return max((spread.estimate for spread in self.spreads.values()), default=0.0)


def propagate(
    model: "Model",
    distributions: "Mapping[str, Distribution]",
    correlation: "Mapping[tuple[str, str], float] | None" = None,
    *,
    coverage: float = 0.95,
    method: str = "auto",
    accuracy: float = DEFAULT_ACCURACY,
    samples: int = 0,
    seed: int = DEFAULT_SEED,
    limits: "Mapping[str, Sequence[float]] | None" = None,
    levels: "Mapping[str, Sequence[float]] | None" = None,
    slopes: "Mapping[str, Mapping[str, float]] | None" = None,
    shares: bool = True,
    curve: bool = False,
    partly: bool = False,
) -> Propagation:
    """Propagate uncertainty through `model`.

    `accuracy` is that of quantiles, mean and deviation, in standard deviations of the result; `samples` limits the
    model evaluations a result may cost (and is the sample of Monte Carlo); `limits` are values by result whose
    exceedance is asked, `levels` probabilities whose quantiles are; `slopes` the derivatives of each result at the
    inputs' means, where they are known; `curve` asks for the distribution function, at points across its range, of
    every result with a limit, or else of the first that varies; `partly` for what was done when a time limit came.
    """
    if method not in METHODS:
        raise UsageError(f"there is no method {method!r}", parameter="method", hint=f"known: {', '.join(METHODS)}")
    if not 0.0 < coverage < 1.0:
        raise UsageError(f"a coverage of {coverage:g} is not between 0 and 1", parameter="coverage")
    space = Space(model, distributions, correlation or {})
    tail = 0.5 * (1.0 - coverage)
    score = -normal.quantile(tail)
    p, scores = np.array([tail, 0.5, 1.0 - tail]), np.array([-score, 0.0, score])
    goal = Goal(p, scores, accuracy, samples or DEFAULT_POINTS, seed, curve=curve)
    propagation = Propagation(space, coverage, seed)
    propagation.correlated = dict(correlation or {})
    if space.size == 0:
        _certain(space, propagation)
        return propagation
    try:
        probe = _probe(space, seed)
        stand_in = StandIn(space, seed, goal.accuracy) if space.slow and method == "auto" and suits(space) else None
        _distribute(
            space, propagation, goal, method, samples, probe, (limits or {}, levels or {}), slopes or {}, stand_in
        )
        if shares and space.results:
            _add_shares(space, propagation, seed, stand_in)
            add_corners(space, propagation.spreads, propagation.coverage)
    except Reached:
        if not partly:
            raise
        stop()
        propagation.stopped = space.results
    propagation.points = space.points
    if space.affordable is not None and method != "monte-carlo":
        propagation.remedy = "give --method monte-carlo --samples 8000, which may take a minute"
    return propagation


def _certain(space: Space, propagation: Propagation) -> None:
    # in this order: the results are known once they are evaluated
    for [value], name in zip(space.evaluate(np.zeros((0, 1))).tolist(), space.results, strict=True):
        propagation.spreads[name] = Spread(name, "no input is uncertain", [value] * 3, value, 0.0)


def _probe(space: Space, seed: int) -> "Array":
    """All results at the centre, half a deviation to both sides of it on every axis, and at a few points beyond."""
    space.rehearse(seed)
    step = 0.5 * np.eye(n := space.size)
    few = np.resize(quantile(lattice(min(n, MOST_DIMENSIONS), 16, 1, seed)), (n, 16))
    return space.evaluate(np.concatenate([np.zeros((n, 1)), step, -step, few], axis=1))


def _distribute(
    space: Space,
    propagation: Propagation,
    goal: Goal,
    method: str,
    samples: int,
    probe: "Array",
    wanted: "tuple[Mapping[str, Sequence[float]], Mapping[str, Sequence[float]]]",
    slopes: "Mapping[str, Mapping[str, float]]",
    stand_in: StandIn | None,
) -> None:
    sample = Sample(space, samples, goal.seed) if method == "monte-carlo" else None
    limits, levels = wanted
    straight = Straight(space, probe, goal.seed)
    space.whole = set(np.flatnonzero((probe == np.rint(probe)).all(axis=1)).tolist())
    twins = [straight.of(row) for row in range(len(space.results))]
    noise = np.array([space.noise.get(name, 0.0) for name in space.results]).reshape(-1, 1)
    still = (np.abs(probe - probe[:, :1]) <= 2.0 * noise).all(axis=1)
    stand_in = stand_in if stand_in is None or stand_in.fits(probe.std(axis=1), still) else None
    if sample is None and space.several and not space.slow:
        goals = {}
        for row, name in enumerate(space.results):
            if not still[row] and (not twins[row][0] or {name, twins[row][0]} & (limits.keys() | levels.keys())):
                goals[row] = goal.asking(limits.get(name, ()), levels.get(name, ()), curve=False)
        start(space, goals, probe, method)
    for row, name in enumerate(space.results):
        curve = goal.curve and (name in limits if limits else not propagation.varying())  # or the first that varies
        own = goal.asking(limits.get(name, ()), levels.get(name, ()), curve=curve)
        twin, scale, shift = twins[row]
        more = {name, twin} & (limits.keys() | levels.keys())
        if twin and not more and not curve:
            propagation.spreads[name] = _copy(propagation.spreads[twin], name, scale, shift)
        elif still[row]:
            propagation.spreads[name] = _constant(name, float(probe[row, 0]), own)
        elif sample is not None:
            propagation.spreads[name] = _sampled(name, row, sample, own)
        else:
            replaced = space.affordable is not None or name not in more
            best = _stood_in(stand_in if replaced else None, name, row, own, probe, space)
            # where the polynomials are accurate enough, further points of the model add nothing
            near = best is not None and stand_in is not None and stand_in.errors[row] <= goal.accuracy * best.std
            if best is None or not (near or best.estimate <= FAIR):
                other = _integrated(space, name, row, own, method, probe, slopes.get(name))
                best = other if best is None or other.estimate < best.estimate else best
            propagation.spreads[name] = best
    for spread in propagation.spreads.values():
        spread.estimate += space.missed * spread.varies


def _stood_in(stand_in: StandIn | None, name: str, row: int, goal: Goal, probe: "Array", space: Space) -> Spread | None:
    """A result from the polynomials that replace a slow model; None where they are not accurate enough."""
    # of a costly model polynomials may be the best there is
    if stand_in is None or not stand_in.errors[row] < (np.nanstd(probe[row]) if space.affordable is None else np.inf):
        return None
    quick = goal.asking(goal.limits, goal.levels, curve=goal.curve)
    quick.points = DEFAULT_POINTS
    spread = _integrated(stand_in.space, name, row, quick, "auto", probe, None)
    spread.estimate += float(stand_in.errors[row]) / spread.std if spread.std > 0.0 else np.inf
    spread.method += f", on polynomials of degree {stand_in.degree} fitted to {stand_in.count} calls"
    return spread


def _copy(spread: Spread, name: str, scale: float, shift: float) -> Spread:
    """The distribution of scale · x + shift."""
    copied = Spread.__new__(Spread)
    copied.__dict__.update(spread.__dict__, name=name)
    if (scale, shift) != (1.0, 0.0):
        low, high = sorted(scale * end + shift for end in spread.interval)
        copied.interval = (low, high)
        copied.median, copied.mean = scale * spread.median + shift, scale * spread.mean + shift
        copied.std = abs(scale) * spread.std
    return copied


def _constant(name: str, value: float, goal: Goal) -> Spread:
    spread = Spread(name, "independent of the uncertain inputs", [value] * 3, value, 0.0)
    spread.beyond = [(limit, 1.0 if value > limit else 0.0) for limit in goal.limits]
    spread.levels = [(level, value) for level in goal.levels]
    return spread


def _sampled(name: str, row: int, sample: Sample, goal: Goal) -> Spread:
    plain, admissible, ordered = sample.plain(row, goal)
    if ordered.size < 2:
        raise InadmissibleError("almost no case within the inputs' uncertainty is admissible", hint="check the inputs")
    spread = _of_plain(name, plain, goal)
    spread.admissible = admissible
    spread.beyond = [(v, 1.0 - float(np.searchsorted(ordered, v, side="right")) / ordered.size) for v in goal.limits]
    if goal.curve:
        values, spread.cases = across_range(spread.interval), ordered.size
        spread.cumulative = (values.tolist(), (np.searchsorted(ordered, values, side="right") / ordered.size).tolist())
    return spread


def _of_plain(name: str, plain: Plain, goal: Goal) -> Spread:
    spread = Spread(name, plain.method, plain.quantiles[goal.main].tolist(), plain.mean, plain.std)
    spread.levels = goal.at_levels(plain.quantiles)
    spread.estimate = plain.estimate
    return spread


def _integrated(
    space: Space,
    name: str,
    row: int,
    goal: Goal,
    method: str,
    probe: "Array",
    slopes: "Mapping[str, float] | None",
) -> Spread:
    direction = space.started[row][0] if row in space.started else direction_of(space, probe, row)
    outcome = integrate(space, row, direction, goal, method)
    spread = Spread(name, outcome.method, outcome.quantiles[goal.main].tolist(), outcome.mean, outcome.std)
    spread.levels, spread.estimate = goal.at_levels(outcome.quantiles), outcome.estimate
    spread.admissible, spread.tails = outcome.admissible, outcome.tails
    if goal.limits:
        chances = exceedance(outcome, np.array(goal.limits, dtype=float), goal)
        spread.beyond = list(zip(goal.limits, chances.tolist(), strict=True))
    classical = method in ("linear", "second-order", "unscented")
    if goal.curve and not classical and spread.varies:
        values = across_range(spread.interval)
        spread.cumulative = (values.tolist(), (1.0 - exceedance(outcome, values, goal)).tolist())
        spread.cases = outcome.scan.values.size if isinstance(outcome.scan, Listed) else 0
    return _beside(spread, _classical(space, row, goal, method, slopes), outcome, goal) if classical else spread


def across_range(interval: "tuple[float, float]") -> "Array":
    """Points across a result's range: the interval, extended by half its width to each side."""
    return np.linspace(1.5 * interval[0] - 0.5 * interval[1], 1.5 * interval[1] - 0.5 * interval[0], CURVE_POINTS)


def _classical(space: Space, row: int, goal: Goal, method: str, slopes: "Mapping[str, float] | None") -> Plain:
    if method == "linear":
        return linear(space, row, goal, slopes)
    return second_order(space, row, goal) if method == "second-order" else unscented(space, row, goal)


def _beside(spread: Spread, plain: Plain, outcome: Outcome, goal: Goal) -> Spread:
    """A classical method's numbers; its error is the distance from the quadrature's; probabilities as if normal."""
    made = _of_plain(spread.name, plain, goal)
    if goal.curve and plain.std > 0.0:
        values = across_range(made.interval).tolist()
        made.cumulative = (values, [1.0 - normal.upper((v - plain.mean) / plain.std) for v in values])
    apart = [*np.abs(plain.quantiles - outcome.quantiles), abs(plain.mean - outcome.mean), abs(plain.std - outcome.std)]
    made.estimate = float(max(apart)) / (outcome.std or 1.0) + outcome.estimate
    made.admissible = spread.admissible
    for limit, _ in spread.beyond:
        z = (limit - plain.mean) / plain.std if plain.std > 0.0 else np.copysign(np.inf, limit - plain.mean)
        made.beyond.append((limit, normal.upper(float(z)) if np.isfinite(z) else float(z < 0.0)))
    return made


def _add_shares(space: Space, propagation: Propagation, seed: int, stand_in: StandIn | None) -> None:
    """Shares of the variance of every result, and the results' correlation."""
    variances = np.nan_to_num([propagation.spreads[name].std ** 2 for name in space.results], posinf=0.0)
    found = MOST_MISSED if stand_in is None else float(stand_in.missed[variances > 0.0].max(initial=0.0))
    missed = found if found < MOST_MISSED else 0.0
    if stand_in is not None and found < MOST_MISSED:
        space = stand_in.space
    elif space.affordable is not None:
        return
    admissible = min(spread.admissible for spread in propagation.spreads.values())
    shares: Shares = variance_shares(space, variances, seed, admissible)
    for row, name in enumerate(space.results):
        if propagation.spreads[name].varies and np.isfinite(shares.first[row]).all():
            propagation.spreads[name].first = shares.first[row].tolist()
            propagation.spreads[name].total = shares.total[row].tolist()
    propagation.shares_method, propagation.shares_error = shares.method, shares.error + missed
    if sum(spread.std > 0.0 for spread in propagation.spreads.values()) > 1:
        propagation.correlation = shares.covariance()
