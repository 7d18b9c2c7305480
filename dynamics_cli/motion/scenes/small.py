"""Small motions of a scene about a state at rest: stiffness, damping and mass the way its joints leave free."""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.system import System

# Five points: the remainder of fourth order and rounding are alike about here.
STEP = 1e-3
POINTS = ((1.0, 8.0 / 12.0), (-1.0, -8.0 / 12.0), (2.0, -1.0 / 12.0), (-2.0, 1.0 / 12.0))


def unbalanced(system: "System", t: float, q: "Any", v: "Any", multipliers: "Any") -> "Any":
    """Forces less what the joints take of them."""
    state = np.concatenate((q, v, np.zeros(len(system.phases) + 3)))
    f = system.frame_of(state)
    out, power = list(system.weights), [0.0, 0.0]
    for force in system.forces:
        force.add(t, f, out, power)
    return np.array(out) - system.jacobian(t, f).T @ multipliers


def stiffness_of(system: "System", t: float, q: "Any", multipliers: "Any") -> "Any":
    """Minus the derivatives of the unbalanced forces by the coordinates."""
    return _slopes(lambda shift: unbalanced(system, t, q + shift, np.zeros(len(q)), multipliers), len(q), STEP)


def _slopes(forces: "Any", n: int, step: float) -> "Any":
    out = np.zeros((n, n))
    for j in range(n):
        shift = np.zeros(n)
        for times, weight in POINTS:
            shift[j] = times * step
            out[:, j] -= weight / step * forces(shift)
    return out


def reduced(system: "System", t: float, q: "Any", multipliers: "Any") -> "tuple[Any, Any, Any, Any]":
    """Directions left free, and stiffness, damping and mass along them."""
    state = np.concatenate((q, np.zeros(len(q) + len(system.phases) + 3)))
    free = np.linalg.svd(system.jacobian(t, system.frame_of(state)))[2][system.m :].T
    stiffness = stiffness_of(system, t, q, multipliers)
    quick = system.gravity**0.5 or 1.0
    damping = _slopes(lambda shift: unbalanced(system, t, q, shift, multipliers), len(q), STEP * quick)
    # what rounding leaves of no damper at all
    damping[np.abs(damping) < 1e-10 * np.abs(stiffness).max() / quick] = 0.0
    mass = (free.T * system.masses) @ free
    return free, free.T @ stiffness @ free, free.T @ damping @ free, mass


def rates_of(system: "System", state: "Any") -> "tuple[float, float]":
    """The fastest oscillation or growth and the fastest decay near a state, whether or not it is an equilibrium."""
    q, n = state[: system.end], system.end
    multipliers = system.solved(0.0, np.concatenate((q, np.zeros(len(state) - n))))[1]
    free, stiffness, damping, mass = reduced(system, 0.0, q, multipliers)
    k = free.shape[1]
    if not k:
        return 0.0, 0.0
    below = -np.linalg.solve(mass, np.hstack((stiffness, damping)))
    values = np.linalg.eigvals(np.block([[np.zeros((k, k)), np.eye(k)], [below]]))
    quick = max(np.abs(values.imag).max(), values.real.max())
    return float(quick), float(max(-values.real.min(), 0.0))
