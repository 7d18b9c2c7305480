"""Quantiles by integrating along one direction: parallel lines across the space, and on each the root of model = v.

With z = a·s + B·y, s along the gradient, P(result ≤ v) = Σ_j w_j Φ(s_j(v)) over lines j with quadrature points y_j. All
roots on all lines and all quantiles are found by one Newton iteration, bordered by the condition on the probability.

A call of the model gives all its results and costs about a millisecond, however few its points are. So these are
generators (`Steps`) that yield the places where they need their result: `side_by_side` evaluates all of these together.
"""

import numpy as np

from dynamics_cli.core.uncertainty.space import LARGEST_BLOCK
from dynamics_cli.numerics.distributions.normal_arrays import density, probability
from dynamics_cli.numerics.quadrature.hermite import gauss_hermite

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Generator, Mapping
    from typing import Any, TypeVar

    from numpy.typing import NDArray

    from dynamics_cli.core.uncertainty.space import Space

    Array = NDArray[Any]
    T = TypeVar("T")
    # Yields lines and places s (lines, k) on them, and is sent the result's values there.
    Steps = Generator[tuple["Lines", Array], Array, T]

MOST_STEPS = 9
FIRST_DIFFERENCE = 1e-3
LONGEST_STEP = 2.0
# The orders of the rule along the lines, for moments.
ORDERS = (7, 12, 20, 33, 55)
# The same where lines are thousands, and their number is what limits the accuracy.
ORDERS_OF_MANY = (4, *ORDERS)
# Half the curvature over the slope assumed for the error that the last step leaves; and how much of that is accepted,
# in units of the squared tolerance.
_CURVATURE = 0.1
_LEFT = 50.0
# Lines of less weight do not decide whether the model increases.
_NEGLIGIBLE = 1e-9


class Lines:
    """Parallel lines through the space: z = direction·s + base_j, with weights that sum to one."""

    def __init__(
        self, space: "Space", result: int, direction: "Array", across: "Array", rest: "Array", w: "Array"
    ) -> None:
        self.space = space
        self.result = result
        self.direction = direction
        self.rest = rest
        self.weights = w
        self.base = across @ rest

    def points(self, s: "Array") -> "Array":
        """The points at s (lines, k), one after another."""
        z = self.base[:, :, None] + self.direction[:, None, None] * s
        points: Array = z.reshape(len(z), -1)
        return points

    def values(self, s: "Array") -> "Array":
        """The result at s (lines, k)."""
        return self.space.values(self.points(s), self.result).reshape(s.shape)

    def at(self, index: "Array", s: "Array") -> "Array":
        """The result on chosen lines, one s each."""
        return self.space.values(self.base[:, index] + self.direction[:, None] * s, self.result)


def alone(steps: "Steps[T]") -> "T":
    """The outcome of one calculation by steps."""
    return side_by_side({0: steps})[0]


def side_by_side(calculations: "Mapping[int, Steps[T]]") -> "dict[int, T]":
    """The outcomes of calculations by steps on one model, whose points are evaluated together."""
    outcomes: dict[int, T] = {}
    going: dict[int, Steps[T]] = dict(calculations)
    values: dict[int, Any] = dict.fromkeys(calculations)
    while going:
        asked: dict[int, tuple[Lines, Array]] = {}
        for row, steps in list(going.items()):
            try:
                asked[row] = steps.send(values[row])
            except StopIteration as end:
                outcomes[row] = end.value
                del going[row]
        values = _evaluated(asked)
    return outcomes


def _evaluated(asked: "Mapping[int, tuple[Lines, Array]]") -> "dict[int, Array]":
    """The values that each calculation asked for: together for as many as fit into a block, in the order given."""
    values: dict[int, Array] = {}
    blocks: list[list[int]] = []
    room = 0
    for row, (lines, s) in asked.items():
        if s.size > LARGEST_BLOCK:
            values[row] = lines.values(s)
            continue
        if s.size > room:
            blocks.append([])
            room = LARGEST_BLOCK
        blocks[-1].append(row)
        room -= s.size
    for rows in blocks:
        parts = [asked[row] for row in rows]
        needed = sorted({lines.result for lines, _ in parts})
        points = np.concatenate([lines.points(s) for lines, s in parts], axis=1)
        found = dict(zip(needed, parts[0][0].space.some(points, needed), strict=True))
        ends = np.cumsum([s.size for _, s in parts])
        for row, (lines, s), end in zip(rows, parts, ends.tolist(), strict=True):
            values[row] = found[lines.result][end - s.size : end].reshape(s.shape)
    return values


class Roots:
    """Converged roots: s (lines, quantiles), the quantiles, the slopes there, and the error left by the last step."""

    __slots__ = ("quantiles", "residual", "s", "slopes", "steps")

    def __init__(self, s: "Array", quantiles: "Array", slopes: "Array", steps: int, residual: float = 0.0) -> None:
        self.s = s
        self.quantiles = quantiles
        self.slopes = slopes
        self.steps = steps
        self.residual = residual

    def density(self, weights: "Array") -> "Array":
        """The probability density of the result at its quantiles."""
        return weights @ (density(self.s) / self.slopes)


def solve(
    lines: Lines, p: "Array", scores: "Array", tolerance: float, guess: "tuple[Array, Array] | None" = None
) -> "Steps[Roots | None]":
    """Find all quantiles; None where a value is undefined, the model does not rise, or the iteration does not settle.

    `tolerance` bounds the weighted error left in s before the last step, whose own error is of second order.
    """
    weights = lines.weights
    if guess is None:
        s = np.broadcast_to(scores, (weights.size, p.size))
        both = yield lines, np.concatenate([s, s + FIRST_DIFFERENCE], axis=1)
        value = both[:, : p.size]
        slope = (both[:, p.size :] - value) / FIRST_DIFFERENCE
    else:
        s, slope = guess
        value = yield lines, s
    v = weights @ value
    absolute = np.abs(weights)
    last = FIRST_DIFFERENCE if guess is None else 1.0
    for step in range(1, MOST_STEPS + 1):
        if not (slope > 0.0).all() or np.isnan(value).any():
            return None
        share = weights[:, None] * density(s) / slope
        change = p - weights @ probability(s) - (share * (v - value)).sum(axis=0)
        v = v + change / share.sum(axis=0)
        move = np.minimum(np.maximum((v - value) / slope, -LONGEST_STEP), LONGEST_STEP)
        s_next = s + move
        rest = float((absolute @ np.abs(move)).max())
        # A secant's slope is wrong by the curvature times the previous step: the product of both steps remains.
        left = _CURVATURE * rest * last
        if rest < tolerance and left < _LEFT * tolerance * tolerance:
            return Roots(s_next, v, slope, step, left)
        last = rest
        before, s = value, s_next
        value = yield lines, s
        # Secant; where the step was too small, the old slope is kept.
        far = np.abs(move) > 1e-9
        slope = np.where(far, (value - before) / np.where(far, move, 1.0), slope)
    return None


class Moments:
    """Mean and deviation of a result over the lines, and the error estimate of the rule along them.

    `by_line` has the mean and the mean square about the common mean of every line.
    """

    __slots__ = ("by_line", "error", "mean", "order", "rising", "std")

    def __init__(
        self, mean: float, std: float, error: float, order: int, *, rising: bool,
        by_line: "tuple[Array, Array] | None" = None,
    ) -> None:  # fmt: skip
        self.mean = mean
        self.std = std
        self.error = error
        self.order = order
        self.rising = rising
        self.by_line = by_line


def moments(
    lines: Lines, accuracy: float, trial: Lines | None = None, orders: "tuple[int, ...]" = ORDERS
) -> "Steps[Moments]":
    """Mean and deviation by Gauss–Hermite along every line.

    The order is chosen on `trial`, fewer lines of the same space: the lower of two orders that agree.
    """
    trial = trial or lines
    if lines.space.heavy:
        moments_of = yield from order_moments(lines, ORDERS[1])
        moments_of.mean = moments_of.std = np.nan
        moments_of.error = 0.0
        return moments_of
    last = yield from order_moments(trial, orders[0])
    if not last.rising:
        return last
    for count in orders[1:]:
        moments_of = yield from order_moments(trial, count)
        if not moments_of.rising or moments_of.std == 0.0:
            return moments_of
        last.error = max(abs(moments_of.mean - last.mean), abs(moments_of.std - last.std)) / moments_of.std
        if last.error <= 0.3 * accuracy:
            break
        moments_of.error = last.error
        last = moments_of
    if trial is lines:
        return last
    final = yield from order_moments(lines, last.order)
    final.error = last.error
    return final


def order_moments(lines: Lines, count: int) -> "Steps[Moments]":
    """Mean and deviation by a rule of so many points along every line."""
    nodes, along = gauss_hermite(count)
    # Nodes of negligible weight would only meet the end of the model's domain.
    heavy = along > 1e-18
    nodes, along = nodes[heavy], along[heavy]
    values = yield lines, np.broadcast_to(nodes, (lines.weights.size, nodes.size))
    sound = bool((np.diff(values[np.abs(lines.weights) > _NEGLIGIBLE], axis=1) > 0.0).all())
    if np.isnan(values).any():
        return Moments(np.nan, np.nan, np.inf, count, rising=False)
    first = values @ along
    mean = float(lines.weights @ first)
    apart = values - mean
    second = (apart * apart) @ along
    variance = float(lines.weights @ second)
    return Moments(mean, np.sqrt(max(variance, 0.0)), np.inf, count, rising=sound, by_line=(first, second))


def features(rest: "Array", lines: int = 0) -> "Array":
    """Terms of a quadratic in y, which extrapolates roots to other lines.

    With products while there are few axes, or where it is fitted to so many lines that they bear it.
    """
    axes, count = rest.shape
    terms = [np.ones(count), *rest, *(rest * rest)]
    if axes <= 4 or lines >= 2 * (axes + 1) * (axes + 2):
        terms += [rest[i] * rest[j] for i in range(axes) for j in range(i)]
    return np.array(terms).T


_projections: "dict[tuple[object, object], Array]" = {}


def fitted(terms: "Array", values: "Array") -> "Array":
    """Least squares over many lines of one weight, for which a full factorization is slow; the shortest solution."""
    coefficients: Array = np.linalg.pinv(terms.T @ terms, rcond=1e-12, hermitian=True) @ (terms.T @ values)
    return coefficients


def _fit(old: Lines) -> "Array":
    """From values on the old lines to the coefficients of the quadratic through them."""
    root = np.sqrt(np.abs(old.weights))
    return np.linalg.pinv(features(old.rest) * root[:, None], rcond=1e-9) * root


def carry(old: Lines, roots: Roots, new: Lines, key: "tuple[object, object] | None" = None) -> "tuple[Array, Array]":
    """A guess of roots and slopes on new lines from a quadratic fitted to those of old ones."""
    if key is None:
        count = old.rest.shape[1]
        known = np.concatenate([roots.s, roots.slopes], axis=1)
        s, slope = np.split(features(new.rest, count) @ fitted(features(old.rest, count), known), 2, axis=1)
    else:
        if key not in _projections:
            _projections[key] = features(new.rest) @ _fit(old)
        s, slope = _projections[key] @ roots.s, _projections[key] @ roots.slopes
    # A quadratic may be far off on distant lines: it must stay within the range of the old roots.
    room = 1.0 + roots.s.max(axis=0) - roots.s.min(axis=0)
    s = np.clip(s, roots.s.min(axis=0) - room, roots.s.max(axis=0) + room)
    return s, np.maximum(slope, 0.1 * roots.slopes.min(axis=0))
