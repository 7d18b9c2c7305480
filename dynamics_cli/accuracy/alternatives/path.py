"""Motion of a point as textbooks have it: the quadratic formula, the normal part by a difference of squares."""

import math

from dynamics_cli.accuracy.questions import textbooks

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

STEPS = 100


def by_quadratic_formula(*, phases: "Any", **_: object) -> "dict[str, float]":
    """Time by (−u ± √(u² + 2as))/a where start speed, acceleration and distance are given."""
    u, a, s = phases.start_speed, phases.acceleration, phases.distance
    if None in (u, a, s):
        raise ArithmeticError
    root = math.sqrt(u * u + 2.0 * a * s)
    time = min(t for t in ((-u + root) / a, (-u - root) / a) if t >= 0.0)
    return {"time": time, "end_speed": u + a * time}


def by_runge_kutta(*, phases: "Any", law: "Any", **_: object) -> "dict[str, float]":
    """A hundred steps of the classical method of Runge and Kutta."""
    from dynamics_cli.numerics.expressions.laws import law_of

    rate = law_of(law, (), ("t", "x", "v"))
    t, x, v, h = 0.0, 0.0, phases.start_speed, phases.time / STEPS

    def slope(t: float, x: float, v: float) -> "tuple[float, float]":
        return v, float(rate(t=t, x=x, v=v))

    for _step in range(STEPS):
        a = slope(t, x, v)
        b = slope(t + 0.5 * h, x + 0.5 * h * a[0], v + 0.5 * h * a[1])
        c = slope(t + 0.5 * h, x + 0.5 * h * b[0], v + 0.5 * h * b[1])
        d = slope(t + h, x + h * c[0], v + h * c[1])
        x, v = (w + h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]) for k, w in enumerate((x, v)))
        t += h
    return {"distance": x, "end_speed": v}


def by_squares(*, velocity: "Sequence[float]", acceleration: "Sequence[float]", **_: object) -> "dict[str, float]":
    """Normal part √(a² − a_t²), radius v²/a_n."""
    square = sum(x * x for x in velocity)
    tangential = sum(x * y for x, y in zip(velocity, acceleration, strict=True)) / math.sqrt(square)
    normal = math.sqrt(sum(x * x for x in acceleration) - tangential * tangential)
    return {"tangential": tangential, "normal": normal, "radius_of_curvature": square / normal}


def by_differences(*, first: "Any", second: "Any", **_: object) -> "dict[str, float]":
    """Closest approach of constant velocities from the relative position at its time."""
    if any(first.acceleration) or any(second.acceleration):
        raise ArithmeticError
    r = [b - a for a, b in zip(first.position, second.position, strict=True)]
    v = [b - a for a, b in zip(first.velocity, second.velocity, strict=True)]
    when = max(0.0, -sum(a * b for a, b in zip(r, v, strict=True)) / sum(b * b for b in v))
    return {"closest_time": when, "closest_distance": math.hypot(*(a + when * b for a, b in zip(r, v, strict=True)))}


QUESTIONS = textbooks(
    "path", "path.json", "dynamics_cli.accuracy.alternatives.path:",
    ("rectilinear", "textbook: quadratic formula", "by_quadratic_formula"),
    ("rectilinear_law", "Runge–Kutta, 100 steps", "by_runge_kutta"),
    ("components", "textbook: difference of squares", "by_squares"),
    ("relative", "textbook: positions subtracted", "by_differences"),
)  # fmt: skip
