"""Further ways beside those of `alternatives/impact/held`."""

from math import sqrt

from dynamics_cli.accuracy.alternatives.impact.held import Held, Wheel, _climbs, _results
from dynamics_cli.accuracy.alternatives.solvers import brent

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    import numpy as np

    Array = np.ndarray[Any, np.dtype[Any]]


def seize_by_matrix(*, body: "Any") -> "dict[str, float]":
    """M·v' − J = M·v, I·ω' − r × J − C = I·ω with v' + ω' × r = 0 (and ω' along the axis) as one system, LAPACK."""
    import numpy as np

    b = Held(body)
    x, y, z = b.point
    # r × J as a matrix times J, and ω' × r as minus it times ω'
    arm = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    ties = [np.hstack([np.eye(3), -arm])]
    if b.axis is not None:
        across = np.linalg.svd(b.axis[None, :])[2][1:]
        ties.append(np.hstack([np.zeros((2, 3)), across]))
    tie = np.vstack(ties)
    masses = np.zeros((6, 6))
    masses[:3, :3], masses[3:, 3:] = b.mass * np.eye(3), b.inertia
    count = len(tie)
    whole = np.block([[masses, -tie.T], [tie, np.zeros((count, count))]])
    right = np.concatenate([masses @ np.concatenate([b.velocity, b.spin]), np.zeros(count)])
    found = np.linalg.solve(whole, right)
    return _results(b, found[3:6], found[:3])


def step_by_equations(
    *, radius: float, height: float, wheel: "Any", gravity: float, speed: "float | None" = None,
    mass: "float | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """Spin after and impulses by three equations at once; the least speed by Brent's method on the energy left."""
    import numpy as np

    w = Wheel(radius, height, wheel, mass)
    down, aside = radius - height, sqrt(radius**2 - (radius - height) ** 2)
    start = 1.0 if speed is None else speed
    # m = 1: ω'·(r − h) − X = v, ω'·s − Y = 0, I·ω' + (r − h)·X + s·Y = I·ω
    rows = np.array([[down, -1.0, 0.0], [aside, 0.0, -1.0], [w.inertia, down, aside]])
    spin, forward, upward = np.linalg.solve(rows, np.array([start, 0.0, w.inertia * start / radius])).tolist()
    kept = spin * radius / start
    about = w.inertia + radius**2

    def short(speed: float) -> float:
        return float(gravity * height - 0.5 * about * (kept * speed / radius) ** 2)

    # the edge takes less than all, so that this is too fast for any wheel
    most = 2.0 * sqrt(2.0 * gravity * height) / min(kept, 1.0)
    least = brent(short, 0.0, most)
    found = _climbs(w, speed, kept, least, gravity)
    if speed is not None and mass is not None:
        found |= {"impulse_forward": mass * forward, "impulse_upward": mass * upward}
    return found
