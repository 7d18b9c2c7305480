"""Two or three independent inputs of any shape: integrals nested input by input, cut wherever a density has a corner.

In scores a bounded or triangular input makes the model non-smooth, and no smooth rule settles. Here each input is
integrated in a coordinate of its own (its value within bounds, its score else) by Gauss–Legendre panels. The innermost
integral is the first input's own distribution function at the root of the model; where that root meets a corner of the
first input (a bound, a mode), the panels of the others are cut. The remaining integrand is smooth on every panel.
"""

import numpy as np

from dynamics_cli.core.inputs.uncertain.distributions import StudentT
from dynamics_cli.core.uncertainty.axes import COARSE, FINE, Axis, points
from dynamics_cli.core.uncertainty.methods.outcome import Goal
from dynamics_cli.numerics.monotone import solve

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.uncertainty.space import Space

    Array = NDArray[Any]

# Tolerance, in widths of an axis, of the last step but one: a secant step squares it. A cut need not be as exact.
ROOT, CUT = 5e-4, 5e-3
LEAST_FREEDOM = 5.0
# Ratio of the fine level's error to the coarse one's, measured on thousands of problems.
GAIN = 0.05
CHECKED = 9
MOST_INADMISSIBLE = 1e-4
# The error left by the roots' tolerance.
FLOOR = 1e-5


def suits(space: "Space", goal: Goal) -> bool:
    """Whether inputs are few, independent, and of shapes for which smooth rules are slow."""
    if not 2 <= space.size <= 3 or space.factor is not None or space.smooth or space.stepped:
        return False
    own = [getattr(distribution, "angle", distribution) for distribution in space.distributions]
    students = [distribution for distribution in own if isinstance(distribution, StudentT)]
    return goal.accuracy >= 5.0 * FLOOR and all(distribution.freedom >= LEAST_FREEDOM for distribution in students)


class Nested:
    """The model of one result on the axes, the most important one first; the sense of each is known."""

    def __init__(self, space: "Space", result: int) -> None:
        self.space = space
        self.result = result
        self.axes = [Axis(distribution) for distribution in space.distributions]
        self.order = list(range(len(self.axes)))
        self.signs = [0] * len(self.axes)
        self.whole = True
        self.fits = self._look()

    def model(self, *coordinates: "Array") -> "Array":
        """The result where the axes, in order of importance, have these coordinates; inadmissible is below all."""
        inputs: dict[str, Any] = dict(self.space.fixed)
        for place, t in zip(self.order, coordinates, strict=True):
            inputs[self.space.names[place]] = self.axes[place].value(t)
        values = self.space.evaluate_inputs(inputs, coordinates[0].size)[self.result]
        return values if self.whole else np.where(np.isnan(values), -np.inf, values)

    @property
    def ordered(self) -> "list[Axis]":
        """The axes in order of importance."""
        return [self.axes[place] for place in self.order]

    def _look(self) -> bool:
        """The sense of the result along every axis, on a coarse grid; inadmissible cases lie only below."""
        lines = [np.linspace(axis.cuts[0], axis.cuts[-1], CHECKED) for axis in self.axes]
        mesh = np.meshgrid(*lines, indexing="ij")
        self.whole = False
        values = self.model(*(part.ravel() for part in mesh)).reshape(mesh[0].shape)
        self.whole = bool(np.isfinite(values).all())
        effects = []
        for place in range(len(self.axes)):
            with np.errstate(invalid="ignore"):
                steps = np.nan_to_num(np.diff(values, axis=place), nan=0.0)
            if (steps > 0.0).any() and (steps < 0.0).any():
                return False
            self.signs[place] = 1 if (steps > 0.0).any() else -1
            middle = [CHECKED // 2] * len(self.axes)
            around = [*middle], [*middle]
            around[0][place], around[1][place] = CHECKED // 2 - 1, CHECKED // 2 + 1
            axis = self.axes[place]
            reach = (lines[place][1] - lines[place][0]) * 2.0
            std = axis.distribution.std if axis.bounded else 1.0
            effects.append(abs(values[tuple(around[1])] - values[tuple(around[0])]) * std / reach)
        if not np.isfinite(effects).all() or max(effects) == 0.0:
            return False
        self.order.sort(key=lambda place: -effects[place])
        return True

    @property
    def rising(self) -> bool:
        """Whether the result rises with the first axis."""
        return self.signs[self.order[0]] > 0


def _rest(nested: Nested, v: "Array", count: int) -> "tuple[list[Array], Array, Array]":
    """Points of the axes beside the first, cut where the root of the model meets a corner: coordinates, weight, v's."""
    first, second, *others = nested.ordered
    signs = [nested.signs[place] > 0 for place in nested.order]
    which = np.arange(v.size)
    weight = np.ones(v.size)
    outer: list[Array] = []
    if others:
        (third,) = others
        roots = [
            solve(_held(nested, (c1, c2), v.size), third.cuts, v, rising=signs[2], near=CUT)[0]
            for c1 in first.corners
            for c2 in second.corners
        ]
        which, t3, weight = points(third, _columns(roots, v.size), count)
        outer = [t3]
    size = which.size
    target = v[which]
    roots = [
        solve(_along_second(nested, c1, outer, size), second.cuts, target, rising=signs[1], near=CUT)[0]
        for c1 in first.corners
    ]
    row, t2, inner = points(second, _columns(roots, size), count)
    return [t2, *(part[row] for part in outer)], inner * weight[row], which[row]


def _along_second(nested: Nested, corner: float, outer: "list[Array]", size: int) -> "Callable[[Array], Array]":
    """The model along the second axis, the first held at a corner, the third at its points."""

    def along(t: "Array") -> "Array":
        return nested.model(np.full(size, corner), t, *outer)

    return along


def _held(nested: Nested, corners: "tuple[float, ...]", size: int) -> "Callable[[Array], Array]":
    """The model along the last axis, those before it held at corners."""

    def along(t: "Array") -> "Array":
        return nested.model(*(np.full(size, corner) for corner in corners), t)

    return along


def _columns(roots: "list[Array]", size: int) -> "Array":
    return np.column_stack(roots) if roots else np.empty((size, 0))


def below(nested: Nested, v: "Array", count: int) -> "tuple[Array, Array]":
    """P(result ≤ v), inadmissible cases counted as below, and its derivative by v."""
    rest, weight, which = _rest(nested, v, count)
    first = nested.ordered[0]
    t, slope = solve(lambda t1: nested.model(t1, *rest), first.cuts, v[which], rising=nested.rising, near=ROOT)
    share = first.below(t) if nested.rising else 1.0 - first.below(t)
    dense = first.density(t) / slope
    return np.bincount(which, weight * share, v.size), np.bincount(which, weight * dense, v.size)


def moments(nested: Nested, count: int) -> "tuple[float, float, float]":
    """Mean and deviation of admissible results, and the share of inadmissible ones."""
    axes = nested.ordered
    coordinates: list[Array] = []
    weight = np.ones(1)
    for axis in axes[:0:-1]:
        _, t, own = points(axis, np.empty((1, 0)), count)
        coordinates = [np.tile(t, weight.size), *(np.repeat(part, t.size) for part in coordinates)]
        weight = np.repeat(weight, t.size) * np.tile(own, weight.size)
    first = axes[0]
    edge = np.empty((weight.size, 0)) if nested.whole else _edge(nested, coordinates)[:, None]
    row, t1, own = points(first, edge, count)
    values = nested.model(t1, *(part[row] for part in coordinates))
    mass = own * weight[row]
    good = np.isfinite(values)
    values, mass = values[good], mass[good]
    total = mass.sum()
    mean = float(mass @ values / total)
    std = float(np.sqrt(mass @ (values - mean) ** 2 / total))
    share = 0.0
    if not nested.whole:
        outside = first.below(edge[:, 0]) if nested.rising else 1.0 - first.below(edge[:, 0])
        share = float(weight @ outside)
    return mean, std, share


def _edge(nested: Nested, rest: "list[Array]") -> "Array":
    """Where results become admissible along the first axis; its end if all are."""
    cuts = nested.ordered[0].cuts
    low, high = (cuts[0], cuts[-1]) if nested.rising else (cuts[-1], cuts[0])
    a, b = np.full(rest[0].size, low), np.full(rest[0].size, high)
    whole = np.isfinite(nested.model(a, *rest))
    for _ in range(50):
        middle = 0.5 * (a + b)
        fine = np.isfinite(nested.model(middle, *rest))
        a, b = np.where(fine, a, middle), np.where(fine, middle, b)
    return np.where(whole, low, b)


class Found:
    """Quantiles, moments, the share of admissible cases, and the estimate of all their errors."""

    def __init__(self, nested: Nested, quantiles: "Array", mean: float, std: float, admissible: float) -> None:
        self.nested = nested
        self.quantiles = quantiles
        self.mean = mean
        self.std = std
        self.admissible = admissible
        self.estimate = np.inf

    def below(self, v: "Array", tolerance: float) -> "tuple[Array, Array]":
        """The share of admissible results up to v, as one line's."""
        share, _ = below(self.nested, np.asarray(v, dtype=float), FINE)
        return (share - (1.0 - self.admissible))[None, :], np.zeros(len(v))


def nested(space: "Space", result: int, goal: Goal) -> Found | None:
    """The distribution of a result; None where the model turns, or is inadmissible elsewhere than below."""
    model = Nested(space, result)
    # Where the first input is bounded, the edge of the inadmissible has corners that no panel is cut at.
    if not model.fits or (model.ordered[0].bounded and not model.whole):
        return None
    mean, std, refused = moments(model, FINE)
    rough_mean, rough_std, _ = moments(model, COARSE)
    if not (std > 0.0 and refused <= MOST_INADMISSIBLE):
        return None
    wanted = refused + (1.0 - refused) * goal.p
    v = mean + std * goal.scores
    for _ in range(12):
        share, dense = below(model, v, COARSE)
        step = np.clip((wanted - share) / np.maximum(dense, 1e-12 / std), -0.7 * std, 0.7 * std)
        if np.abs(step).max() < 2e-3 * std:
            break
        v = v + step
    else:
        return None
    fine, dense = below(model, v, FINE)
    last = (wanted - fine) / np.maximum(dense, 1e-12 / std)
    solution = Found(model, v + last, mean, std, 1.0 - refused)
    rough = np.abs(fine - share) / np.maximum(dense, 1e-12 / std)
    apart = max(float(rough.max()), abs(mean - rough_mean), abs(std - rough_std))
    solution.estimate = (GAIN * apart + float(np.abs(last).max()) ** 2 / std) / std + FLOOR
    return solution
