"""Impacts of bodies as textbooks and spreadsheets calculate them: velocities first, and all else as differences.

Momentum before a crash by a 2×2 system; whole planar impacts by pycrash, where it is installed.
"""

from math import cos, sin

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

FOOT, POUND_FORCE, MILE_PER_HOUR = 0.3048, 4.4482216152605, 0.44704


def cross_products(*, first: "Any", second: "Any", gravity: float) -> "dict[str, Any]":
    """The program's own: each speed from the parts of momentum across the other's path."""
    from dynamics_cli.impact.reconstruction.momentum_terms import Term, solve

    terms = [
        Term(sign, one.bulk.mass, speed, heading, name)
        for sign, one, speed, heading, name in (
            (1.0, first, None, first.approach_heading, "the first"),
            (1.0, second, None, second.approach_heading, "the second"),
            (-1.0, first, first.exit_speed, first.exit_heading, "the first exit"),
            (-1.0, second, second.exit_speed, second.exit_heading, "the second exit"),
        )
    ]
    solve(terms, None)
    return {"first.approach_speed": terms[0].speed, "second.approach_speed": terms[1].speed}


def _system(first: "Any", second: "Any") -> "tuple[list[list[float]], list[float]]":
    """The equations of momentum along x and y for the two speeds before."""
    both = first, second
    return (
        [[one.bulk.mass * f(one.approach_heading) for one in both] for f in (cos, sin)],
        [sum(one.bulk.mass * one.exit_speed * f(one.exit_heading) for one in both) for f in (cos, sin)],
    )


def _named(one: float, two: float) -> "dict[str, float]":
    return {"first.approach_speed": one, "second.approach_speed": two}


def by_cramer(*, first: "Any", second: "Any", gravity: float) -> "dict[str, float]":
    """The 2×2 system by Cramer's rule."""
    ((a, b), (c, d)), (x, y) = _system(first, second)
    whole = a * d - b * c
    return _named((x * d - b * y) / whole, (a * y - c * x) / whole)
