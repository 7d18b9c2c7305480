"""Further ways beside those of `alternatives/gear/involute`."""

from math import copysign, inf, pi, tan

from dynamics_cli.accuracy.alternatives.gear.involute import MOST_STEPS, TINY
from peers.solvers import brent

TYPE_CHECKING = False


def power_series(phi: float) -> "dict[str, float]":
    """Five terms of the power series, φ³/3 + 2·φ⁵/15 + 17·φ⁷/315 + 62·φ⁹/2835 + 1382·φ¹¹/155925."""
    square, total = phi * phi, 0.0
    for term in (1382 / 155925, 62 / 2835, 17 / 315, 2 / 15, 1 / 3):
        total = term + square * total
    return {"value": phi * square * total}


def _residual(phi: float, value: float) -> float:
    return tan(phi) - phi - value


def bisection(value: float) -> "dict[str, float]":
    """Halving between 0 and 90° until nothing is left to halve."""
    low, high = 0.0, 0.5 * pi
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return {"phi": middle}
        if _residual(middle, value) < 0.0:
            low = middle
        else:
            high = middle


def ridders(value: float) -> "dict[str, float]":
    """Ridders' bracketed method, as safe as halving and as quick as a secant."""
    low, high = 0.0, 0.5 * pi
    below, above = -value, _residual(high, value)
    last = inf
    for _ in range(MOST_STEPS):
        middle = 0.5 * (low + high)
        between = _residual(middle, value)
        # scaled, so that the product of the ends cannot overflow
        share = between / above
        root = (share * share - below / above) ** 0.5
        if root == 0.0:
            return {"phi": middle}
        place = middle + (middle - low) * copysign(share / root, -share if below < 0.0 else share)
        there = _residual(place, value)
        if there == 0.0 or abs(place - last) <= TINY * abs(place):
            return {"phi": place}
        last = place
        if (there < 0.0) != (between < 0.0):
            low, below, high, above = (
                (place, there, middle, between) if there < 0.0 else (middle, between, place, there)
            )
        elif there < 0.0:
            low, below = place, there
        else:
            high, above = place, there
    raise ArithmeticError


def brent_inverse(value: float) -> "dict[str, float]":
    """Brent's bracketed method, of numerical textbooks."""
    return {"phi": brent(lambda phi: _residual(phi, value), 0.0, 0.5 * pi)}


def by_brentq(value: float) -> "dict[str, float]":
    """The bracketed method of scipy, to its finest tolerance."""
    from scipy.optimize import brentq

    return {"phi": brentq(_residual, 0.0, 0.5 * pi, (value,), 1e-300, 9e-16, 1000)}
