"""Which method gives a result's quantiles, moments and probabilities: a table, tried from the top.

A method is tried when it suits the problem and the best error so far is above its limit; the first outcome within the
requested accuracy ends the search, else the best of all is taken. Errors are in standard deviations of the result.
The factors of the estimates were fitted on thousands of random problems so that the true error stays below them; plain
differences between levels or replicates do not achieve that.

Not in the table: a single input, and a slow model that answers thousands of cases at once, whose results all come from
one sample.
"""

import numpy as np

from dynamics_cli.core.uncertainty.methods.grids import grids
from dynamics_cli.core.uncertainty.methods.lattices import lattices
from dynamics_cli.core.uncertainty.methods.lines import alone as stepped
from dynamics_cli.core.uncertainty.methods.lines import side_by_side
from dynamics_cli.core.uncertainty.methods.mixtures import mixtures
from dynamics_cli.core.uncertainty.methods.mixtures import suits as suits_mixtures
from dynamics_cli.core.uncertainty.methods.outcome import FAIR, GOOD, Goal, Outcome, direction_of
from dynamics_cli.core.uncertainty.methods.pooled import pooled
from dynamics_cli.core.uncertainty.methods.scanned_lines import alone, scanned, scanned_grids
from dynamics_cli.core.uncertainty.space import BEARING_CASES, Space, bearing, complement
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS, lattice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.uncertainty.methods.lines import Steps

    Array = NDArray[Any]
    Method = Callable[[Space, int, Array, Array, Goal], Outcome | None]

# Evaluations that results of one input may cost before further ones take the sample.
PIECES = 20_000
# Grids of scanned lines are for at most this many inputs.
FEW_INPUTS = 3
ANY = float("inf")
# Values of an input, for mixtures, are so many only where no sample stands behind.
OWN_ACCURACY = 1e-3
# Classical methods take their error from what is integrated beside them: no more accurately than their own numbers.
SHARING = ("auto", "linear", "second-order", "unscented")


class Problem:
    """One result of a model, and the accuracy requested."""

    def __init__(self, space: Space, goal: Goal, asked: str, result: int) -> None:
        self.space = space
        self.goal = goal
        self.asked = asked
        self.narrow = space.size <= MOST_DIMENSIONS
        self.several = space.several
        self.mixture = asked == "auto" and suits_mixtures(space)
        self.counted = asked == "auto" and result in space.whole and not (space.slow or space.heavy)


class Way:
    """A row of the table: the method, the problems it suits, and the error above which it is tried."""

    def __init__(
        self, method: "Method", suits: "Callable[[Problem], bool]", *, above: float = 0.0, whole: bool = False
    ) -> None:
        self.method = method
        self.suits = suits
        self.above = above
        # Whether it may use all of the goal's points because it does so once for all results.
        self.whole = whole


def _grids(space: Space, result: int, direction: "Array", across: "Array", goal: Goal) -> Outcome | None:
    """Grids along the gradient, where they have not been started beside those of other results."""
    if result in space.started:
        return space.started[result][1]  # type: ignore[no-any-return]
    return stepped(_levels(space, result, direction, None, goal))


def _levels(space: Space, result: int, direction: "Array", axes: "Array | None", goal: Goal) -> "Steps[Outcome | None]":
    """Grids of one result across the axes that bear on it (None: all); a mixture where these are not smooth."""
    if suits_mixtures(space, axes):
        return mixtures(space, result, direction, axes, goal)
    return grids(space, result, direction, complement(direction, axes), goal)


# What a method costs, in evaluations of the model for one result. A model that is called case by case takes
# grids, else the sample that results share.
WAYS = (
    # 3e4 and more, once for all results: whole numbers; jumps leave nothing to be had from other points
    Way(pooled, lambda p: p.counted, whole=True),
    # 1e2 to 1e5: results that rise along every line; exact to many digits where they are smooth
    # (bounded inputs and lists among smooth ones: value by value)
    GRIDS := Way(_grids, lambda p: p.asked != "lattice" and (not p.space.stepped or p.mixture)),
    # 1e6, once for all of many results, whatever they do; 3e5 of a slow model
    Way(pooled, lambda p: p.several, above=GOOD, whole=True),
    # 1e4 to 3e6, of few results: kinks, bounded inputs, many inputs, as long as results rise along every line
    Way(
        lambda *problem: stepped(lattices(*problem)),
        lambda p: p.narrow and not (p.space.stepped or p.several or p.space.slow),
    ),
    # 1e4 to 1e6: few inputs, results that turn or jump
    Way(
        scanned_grids,
        lambda p: p.space.size <= FEW_INPUTS and not (p.space.stepped or p.several or p.space.slow),
        above=GOOD,
    ),
    # 1e5 to 3e6: the same of more inputs
    Way(scanned, lambda p: p.narrow and not (p.several or p.space.slow), above=FAIR),
    # 1e6
    Way(pooled, lambda p: not p.several, above=GOOD, whole=True),
)


def _in_pieces(space: Space) -> bool:
    """Whether a single input is divided where a result turns or jumps: exact, until many results have cost so much."""
    return space.size == 1 and not space.slow and space.points < PIECES


def start(space: Space, goals: "Mapping[int, Goal]", probe: "Array", asked: str) -> None:
    """Grids of many results in common calls of the model, each across the inputs that bear on it."""
    calculations = {}
    bears = bearing(space, quantile(lattice(space.size, BEARING_CASES, 2))) if space.size <= MOST_DIMENSIONS else None
    rest = set(space.whole)
    for result, goal in goals.items():
        own = goal.own(space)
        problem = Problem(space, own, asked, result)
        if next(way for way in WAYS if way.suits(problem)) is not GRIDS:
            rest.add(result)
            continue
        direction = direction_of(space, probe, result)
        axes = None if bears is None or space.heavy or not bears[result].any() else bears[result]
        if axes is not None:
            direction = np.where(axes, direction, 0.0)
            direction /= np.sqrt(direction @ direction)
        if axes is not None and axes.sum() == 1:
            outcome = alone(space, result, direction, goal, pieces=_in_pieces(space))
            space.started[result] = direction, outcome
            rest.update(() if outcome else (result,))
            continue
        space.started[result] = direction, None
        if problem.several and suits_mixtures(space, axes):
            own.accuracy = max(own.accuracy, OWN_ACCURACY)
        calculations[result] = _levels(space, result, direction, axes, own)
    for result, outcome in side_by_side(calculations).items():
        space.started[result] = space.started[result][0], outcome
        if outcome is None or outcome.estimate > max(GOOD, goals[result].accuracy):
            rest.add(result)
    space.open = sorted(rest)


def integrate(space: Space, result: int, direction: "Array", goal: Goal, asked: str) -> Outcome:
    """The best outcome for one result within the goal's points."""
    own = goal.own(space)
    problem = Problem(space, own, asked, result)
    across = complement(direction)
    if space.affordable is not None and asked in SHARING:
        return pooled(space, result, direction, across, goal)
    if space.size == 1:
        known = space.started.get(result, (None, None))[1]
        found = known or alone(space, result, direction, goal, pieces=_in_pieces(space))
        return found or pooled(space, result, direction, across, goal)
    if space.together and asked in SHARING:
        # Thousands of cases at once cost little more than the few that lines ask for at a time.
        return pooled(space, result, direction, across, goal)
    best: Outcome | None = None
    for way in WAYS:
        known = ANY if best is None else best.estimate
        if not known > max(way.above, own.accuracy) or not way.suits(problem):
            continue
        outcome = way.method(space, result, direction, across, goal if way.whole else own)
        if outcome is not None and (best is None or outcome.estimate < best.estimate):
            best = outcome
        if best is not None and (problem.counted or (way is GRIDS and asked == "quadrature")):
            break
    assert best is not None
    return best
