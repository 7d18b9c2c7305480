"""The inverse involute by iteration on its residual, which loses 3/φ² units in the last place however it is solved."""

from math import atan, cbrt, copysign, inf, pi, tan

from dynamics_cli.accuracy.rivals.solvers import brent

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_STEPS = 100
TINY = 4e-16


def chosen_inverse(value: "Any") -> "dict[str, Any]":
    """Series in ∛(3 inv φ), and in the complement of φ above 60°."""
    from dynamics_cli.numerics.involute import inverse_involute

    return {"phi": inverse_involute(value)}


def chosen_involute(phi: "Any") -> "dict[str, Any]":
    """A series below 0.98 rad."""
    from dynamics_cli.numerics.involute import involute

    return {"value": involute(phi)}


def textbook_involute(phi: float) -> "dict[str, float]":
    """The definition, tan φ − φ: digits go as φ³."""
    return {"value": tan(phi) - phi}


def power_series(phi: float) -> "dict[str, float]":
    """Five terms of the power series, φ³/3 + 2·φ⁵/15 + 17·φ⁷/315 + 62·φ⁹/2835 + 1382·φ¹¹/155925."""
    square, total = phi * phi, 0.0
    for term in (1382 / 155925, 62 / 2835, 17 / 315, 2 / 15, 1 / 3):
        total = term + square * total
    return {"value": phi * square * total}


def newton(value: float) -> "dict[str, float]":
    """Newton on tan φ − φ from Laskin's start."""
    phi = 1.441 * cbrt(value) - 0.374 * value
    for _ in range(MOST_STEPS):
        tangent = tan(phi)
        step = (tangent - phi - value) / (tangent * tangent)
        phi -= step
        if abs(step) <= TINY * abs(phi):
            break
    return {"phi": phi}


def newton_in_tangent(value: float) -> "dict[str, float]":
    """Newton on t − tan⁻¹ t in t = tan φ, whose start and steps hold for every angle."""
    t = cbrt(3.0 * value) if value < 1.0 else value + 1.5
    for _ in range(MOST_STEPS):
        step = (t - atan(t) - value) * (1.0 + t * t) / (t * t)
        t -= step
        if abs(step) <= TINY * abs(t):
            break
    return {"phi": atan(t)}


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
