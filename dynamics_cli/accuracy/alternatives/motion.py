"""Equations of motion as scripts have them: velocities and mass matrices by differences of the formulas."""

from typing import Any

from dynamics_cli.accuracy.questions import textbooks
from dynamics_cli.motion.equations.records import Turning
from dynamics_cli.motion.equations.system import System

# The usual choice for second differences: the fourth root of the roundoff.
STEP = 1e-4


def by_differences(*, scene: "Any", time: float = 0.0, up: str = "y", **_: "Any") -> "dict[str, float]":
    """Velocities by central differences of the formulas; the mass matrix and T of bodies that turn in the plane."""
    system = System(scene, (), up)
    if any(len(turns) > 1 for turns in system.turns.values()):
        raise ValueError("turns in space")
    q = [c.angle if isinstance(c, Turning) else c.position for c in scene.coordinates]
    w = [c.rate if isinstance(c, Turning) else c.velocity for c in scene.coordinates]
    n = len(q)

    def placed(changes: "list[float]", later: float) -> "list[list[float]]":
        numbers = dict(zip(system.names, (a + b for a, b in zip(q, changes, strict=True)), strict=True))
        numbers["t"] = time + later
        return [
            [*system.place(name, numbers), *(angle for angle, _ in system.axes(name, numbers))]
            for name in system.bodies
        ]

    def slopes(changes: "list[float]", later: float) -> "list[list[float]]":
        ahead, behind = (placed([s * x for x in changes], s * later) for s in (STEP, -STEP))
        return [
            [(a - b) / (2.0 * STEP) for a, b in zip(*pair, strict=True)] for pair in zip(ahead, behind, strict=True)
        ]

    parts = [slopes([float(k == r) for k in range(n)], 0.0) for r in range(n)]
    moved = slopes(w, 1.0)

    def summed(first: "list[list[float]]", second: "list[list[float]]") -> float:
        total = 0.0
        for body, a, b in zip(scene.bodies, first, second, strict=True):
            total += sum(body.mass * x * y for x, y in zip(a[:3], b[:3], strict=True))
            total += sum(body.inertia * x * y for x, y in zip(a[3:], b[3:], strict=True))
        return total

    masses = {f"mass_matrix[{r}].entries[{s}].value": summed(parts[r], parts[s]) for r in range(n) for s in range(n)}
    return masses | {"kinetic_energy": 0.5 * summed(moved, moved)}


QUESTIONS = textbooks(
    "motion", "motion.json", "dynamics_cli.accuracy.alternatives.motion:",
    ("equations", "central differences of the formulas", "by_differences"),
)  # fmt: skip
