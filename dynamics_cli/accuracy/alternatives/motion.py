"""Motion as scripts have it: an integrator as it comes, modes of assembled matrices, differences of formulas."""

import math

from dynamics_cli.accuracy.questions import Method, Question
from dynamics_cli.motion.equations.records import Turning
from dynamics_cli.motion.equations.system import System
from dynamics_cli.motion.rods import chain_of, many

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# The usual choice for second differences: the fourth root of the roundoff.
STEP = 1e-4


def by_defaults(
    *, lengths: "Any", masses: "Any", angles: "Any", duration: float, rates: "Any" = (), end_masses: "Any" = (),
    **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """What solve_ivp of scipy gives with the tolerances that it has by default."""
    from scipy.integrate import solve_ivp

    rods = chain_of(lengths, masses, end_masses, (), None, 9.80665)
    n = rods.n
    start = many(angles, n, "angles", 0.0) + many(rates, n, "rates", 0.0)
    end = [float(row[-1]) for row in solve_ivp(rods.rate, (0.0, duration), start).y]
    made = {f"rods[{k}].angle": end[k] for k in range(n)}
    return made | {f"rods[{k}].rate": end[n + k] for k in range(n)}


def by_eigh(*, lengths: "Any", masses: "Any", end_masses: "Any" = (), **_: "Any") -> "dict[str, float]":
    """Symmetric eigenvalues of the assembled matrices (LAPACK's dsygv)."""
    import numpy as np
    from scipy.linalg import eigh

    rods = chain_of(lengths, masses, end_masses, (), None, 9.80665)
    squares = eigh(np.diag(rods.gravity * np.array(rods.b)), np.array(rods.a), eigvals_only=True)
    made: dict[str, float] = {}
    for nth, square in enumerate(squares):
        rate = math.sqrt(max(float(square), 0.0))
        made |= {f"modes[{nth}].angular_frequency": rate, f"modes[{nth}].frequency": rate / (2.0 * math.pi)}
    return made


def by_differences(*, scene: "Any", time: float = 0.0, up: str = "y", **_: "Any") -> "dict[str, float]":
    """Velocities by central differences of the formulas; the mass matrix and T of bodies that turn in the plane."""
    system = System(scene, (), up)
    if any(len(turns) > 1 for turns in system.turns.values()):
        raise ValueError("turns in space")
    q = [one.angle if isinstance(one, Turning) else one.position for one in scene.coordinates]
    w = [one.rate if isinstance(one, Turning) else one.velocity for one in scene.coordinates]
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

    def summed(one: "list[list[float]]", other: "list[list[float]]") -> float:
        total = 0.0
        for body, a, b in zip(scene.bodies, one, other, strict=True):
            total += sum(body.mass * x * y for x, y in zip(a[:3], b[:3], strict=True))
            total += sum(body.inertia * x * y for x, y in zip(a[3:], b[3:], strict=True))
        return total

    made = {f"mass_matrix[{r}].entries[{s}].value": summed(parts[r], parts[s]) for r in range(n) for s in range(n)}
    return made | {"kinetic_energy": 0.5 * summed(moved, moved)}


HERE = "dynamics_cli.accuracy.alternatives.motion:"
QUESTIONS = (
    Question(
        "motion", "", "", "motion.json", "chain",
        Method("scipy.integrate.solve_ivp, default tolerances", HERE + "by_defaults", needs="scipy"),
    ),
    Question(
        "motion", "", "", "motion.json", "modes",
        Method("scipy.linalg.eigh(K, M)", HERE + "by_eigh", needs="scipy"),
    ),
    Question(
        "motion", "", "", "motion.json", "equations",
        Method("central differences of the formulas", HERE + "by_differences"),
    ),
)  # fmt: skip
