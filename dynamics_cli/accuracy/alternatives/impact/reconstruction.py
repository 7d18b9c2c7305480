"""Reconstruction as printed: speeds by Cramer's rule."""

from math import cos, sin

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def cross_products(*, first: "Any", second: "Any", gravity: float) -> "dict[str, Any]":
    """The program's own: each speed from the parts of momentum across the other's path."""
    from dynamics_cli.impact.reconstruction.momentum_terms import Term, solve

    before = [Term(1.0, car.bulk.mass, None, car.approach_heading, "before") for car in (first, second)]
    after = [Term(-1.0, car.bulk.mass, car.exit_speed, car.exit_heading, "after") for car in (first, second)]
    solve([*before, *after], None)
    return {"first.approach_speed": before[0].speed, "second.approach_speed": before[1].speed}


def by_cramer(*, first: "Any", second: "Any", gravity: float) -> "dict[str, float]":
    """Momentum along x and y as a 2×2 system, by Cramer's rule."""
    both = first, second
    (a, b), (c, d) = ([car.bulk.mass * f(car.approach_heading) for car in both] for f in (cos, sin))
    x, y = (sum(car.bulk.mass * car.exit_speed * f(car.exit_heading) for car in both) for f in (cos, sin))
    whole = a * d - b * c
    return {"first.approach_speed": (x * d - b * y) / whole, "second.approach_speed": (a * y - c * x) / whole}
