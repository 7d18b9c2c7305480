"""Further ways beside those of `alternatives/impact/momentum`."""

from math import atan2, cos, sin, sqrt

from dynamics_cli.accuracy.alternatives.impact.momentum import Crash, Line, _condition, _results
from peers.solvers import newton_of_two

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def by_solver(**given: "Any") -> "dict[str, float]":
    """Newton's method on the two equations with whatever is unknown in them, from the mean of what is known."""
    c = Crash(given)
    unknown = [(c.speeds, k) for k in range(4) if c.speeds[k] is None]
    unknown += [(c.angles, k) for k in range(4) if c.angles[k] is None]
    if len(unknown) != 2:
        raise ArithmeticError
    found: dict[str, float] = {}
    if all(where is c.speeds for where, _ in unknown):
        found["angle_condition"] = _condition(c.angles[unknown[0][1]], c.angles[unknown[1][1]])
    known = [v for v in c.speeds if v is not None]
    speed = sum(known) / len(known)
    one, two = (speed if where is c.speeds else c.closing(k) for where, k in unknown)
    sizes = [speed if where is c.speeds else 1.0 for where, _ in unknown]

    def left(*values: float) -> "tuple[float, float]":
        for (where, k), value in zip(unknown, values, strict=True):
            where[k] = value
        parts = [(c.amount(k) * c.speeds[k], c.angles[k]) for k in range(4)]
        x, y = (sum(p * f(a) for p, a in parts) / (sum(c.masses) * speed) for f in (cos, sin))
        return x, y

    for (where, k), value in zip(unknown, newton_of_two(left, one, two, (sizes[0], sizes[1])), strict=True):
        if where is c.speeds and value < 0.0:
            raise ArithmeticError
        where[k] = value if where is c.speeds else atan2(sin(value), cos(value))
    return _results(c) | found


def energy_by_solver(**given: "Any") -> "dict[str, float]":
    """Newton's method on momentum and energy together, from speeds apart by half the energy."""
    one = Line(given)
    (m1, m2), (u1, u2) = one.crash.masses, one.after
    energy = one.damage + 0.5 * m1 * u1**2 + 0.5 * m2 * u2**2
    speed = sqrt(2.0 * energy / (m1 + m2))

    def left(v1: float, v2: float) -> "tuple[float, float]":
        return (
            (m1 * (v1 - u1) + m2 * (v2 - u2)) / ((m1 + m2) * speed),
            (0.5 * m1 * v1 * v1 + 0.5 * m2 * v2 * v2 - energy) / energy,
        )

    common, apart = (m1 * u1 + m2 * u2) / (m1 + m2), sqrt(energy / m1)
    return one.results(*newton_of_two(left, common + apart, common - apart, (speed, speed)))
