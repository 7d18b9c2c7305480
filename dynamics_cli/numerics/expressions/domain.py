"""Where a formula has a pole, a corner or no real value: found by evaluating whole cells at once (discs)."""

import math

import numpy as np

from dynamics_cli.numerics.discs import Disc
from dynamics_cli.numerics.expressions import jets
from dynamics_cli.numerics.expressions.grammar import Expression, constant

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from dynamics_cli.numerics.expressions.grammar import Tree

# Initial cells, and how often a suspicious one is halved.
CELLS, HALVINGS = 64, 36
MOST_CELLS = 4096


def first_fault(formula: Expression, name: str, low: float, high: float, **others: float) -> "float | None":
    """The first place between two ends where the formula has a pole, a corner or no real value; None where none is.

    Every cell is evaluated as a whole (discs); a suspicious one is halved until it is cleared or is a point.
    """
    edges = np.linspace(low, high, CELLS + 1)
    lows, highs = edges[:-1], edges[1:]
    for step in range(HALVINGS):
        middle, half = 0.5 * (lows + highs), 0.5 * (highs - lows)
        cells = Disc(middle, half * (1.0 + 1e-15))
        numbers = {key: Disc(np.full(len(middle), value)) for key, value in others.items()}
        with np.errstate(all="ignore"):
            result = _over(formula.tree, {name: cells, **numbers}, len(middle))
            wrong = ~(np.isfinite(result.radius * 0.0 + result.centre) & np.isfinite(result.radius))
        if not wrong.any():
            return None
        lows, highs, middle = lows[wrong], highs[wrong], middle[wrong]
        if step == HALVINGS - 1:
            break
        # the first fault is reported
        lows, highs, middle = lows[:MOST_CELLS], highs[:MOST_CELLS], middle[:MOST_CELLS]
        lows, highs = np.concatenate([lows, middle]), np.concatenate([middle, highs])
        order = np.argsort(lows, kind="stable")
        lows, highs = lows[order], highs[order]
    place = 0.5 * float(lows[0] + highs[0])
    return 0.0 if abs(place) < 1e-9 * (high - low) else place


def _over(tree: "Tree", variables: "Mapping[str, Disc]", count: int) -> Disc:
    """The tree on cells; an infinite radius marks a suspicious cell."""
    operation = tree[0]
    if operation in ("number", "pi"):
        return Disc(np.full(count, math.pi if operation == "pi" else tree[1]), np.zeros(count))
    if operation == "name":
        return variables[tree[1]]
    parts = [_over(part, variables, count) for part in tree[1:]]
    if operation == "^":
        return _disc_power(parts[0], parts[1], tree[2])
    return _OPERATIONS[operation](*parts)


def _disc_power(base: Disc, exponent: Disc, tree: "Tree") -> Disc:
    value = constant(tree)
    if value is not None and value == int(value) and abs(value) <= 64:
        power: Disc = jets.whole_power(base, int(value))
        return power
    return (exponent * base.logarithm()).exponential()


def _half_exponentials(x: Disc, sign: float) -> Disc:
    up = x.exponential()
    return (up + up.inverse() * sign) * 0.5


def _disc_abs(x: Disc) -> Disc:
    return Disc(np.abs(x.centre), np.where(np.abs(x.centre) > x.radius, x.radius, np.inf))


def _disc_atan(x: Disc) -> Disc:
    return Disc(np.arctan(x.centre), np.minimum(x.radius, 4.0))


_OPERATIONS: "dict[str, Callable[..., Disc]]" = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "neg": lambda a: -a,
    "sin": lambda a: a.sine(),
    "cos": lambda a: a.cosine(),
    "tan": lambda a: a.sine() / a.cosine(),
    "asin": lambda a: a.arc_sine(),
    "acos": lambda a: a.arc_cosine(),
    "atan": _disc_atan,
    "sinh": lambda a: _half_exponentials(a, -1.0),
    "cosh": lambda a: _half_exponentials(a, 1.0),
    "tanh": lambda a: _half_exponentials(a, -1.0) / _half_exponentials(a, 1.0),
    "exp": lambda a: a.exponential(),
    "log": lambda a: a.logarithm(),
    "sqrt": lambda a: a.root(),
    "abs": _disc_abs,
}
