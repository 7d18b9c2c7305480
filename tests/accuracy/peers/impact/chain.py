"""Further ways beside those of `alternatives/impact/chain`."""

from dynamics_cli.accuracy.alternatives.impact.chain import MOST, NOTHING, _by_differences, _closing, _rounds

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    # Velocities after, impulses between neighbours, collisions or rounds.
    Answer = tuple[list[float], list[float], int]


SWEEPS = 400


def _pair_by_system(masses: "list[float]", before: "list[float]", ratios: "list[float]") -> "Answer":
    """The same order, each pair's momentum and restitution as a system of two equations."""
    import numpy as np

    speeds, impulses = list(before), [0.0] * len(ratios)
    least = NOTHING * max(map(abs, before))
    for count in range(MOST):
        closing = _closing(speeds)
        fastest = max(closing)
        if fastest <= least:
            return speeds, impulses, count
        k = closing.index(fastest)
        m, n, v, w = masses[k], masses[k + 1], speeds[k], speeds[k + 1]
        new = np.linalg.solve(np.array([[m, n], [-1.0, 1.0]]), np.array([m * v + n * w, ratios[k] * fastest])).tolist()
        speeds[k : k + 2] = new
        impulses[k] += m * (v - new[0])
    raise ArithmeticError


def _sweeps(k: "Any", closing: "Any") -> "Any":
    """Projected Gauss–Seidel, as physics engines do it: each impulse in turn, none below zero."""
    import numpy as np

    found = np.zeros(len(closing))
    for _ in range(SWEEPS):
        for i in range(len(found)):
            found[i] = max(0.0, found[i] + (closing[i] - k[i] @ found) / k[i, i])
    return found


def by_sweeps(*, bodies: "Any", restitution: float, law: str) -> "dict[str, float]":
    """Pairs as systems of two equations; all contacts at once by 400 sweeps of projected Gauss–Seidel."""
    return _by_differences(bodies, restitution, law, _pair_by_system, lambda m, v, e: _rounds(m, v, e, _sweeps))
