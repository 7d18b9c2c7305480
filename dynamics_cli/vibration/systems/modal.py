"""A system in the coordinates of its undamped modes: its receptances, and its motion under a load over time."""

import math

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.quantities import DampingRatio
from dynamics_cli.vibration.shocks.extremes import states_of_record
from dynamics_cli.vibration.shocks.pulses import Oscillators, Piece
from dynamics_cli.vibration.shocks.recursion import EVEN, even, followed
from dynamics_cli.vibration.single.oscillator import require_damping
from dynamics_cli.vibration.systems.matrices import proportional
from dynamics_cli.vibration.systems.modes import LOST, undamped

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.vibration.systems.inputs import System

# Eigenvectors of the state matrix that are nearer to dependent than this are not used.
INDEPENDENT = 1e6
# Frequencies that are solved at once.
BLOCK = 64


class Modal:
    """Equations q̈ + C·q̇ + Ω²·q = w·load: C has a diagonal `rates`, or is full where dampers couple the modes."""

    def __init__(self, model: "System", damping_ratio: "float | None") -> None:
        if damping_ratio is not None:
            require_damping(damping_ratio, DampingRatio)
        mass, stiffness, damping = model.matrices()
        require(
            damping is None or damping_ratio is None, "dampers and a damping ratio of all modes are both given",
            code="both", hint="leave out --damping-ratio, or the dampers",
        )  # fmt: skip
        self.omega, self.shapes, errors, _ = undamped(model)
        require(
            model.elements is not None or bool((errors < LOST).all()),
            "a soft mode is lost in the rounding of the matrices",
            code="lost",
            hint="give masses and springs: --masses and --stiffnesses, or --body and --coupling",
        )
        self.base = -self.shapes @ mass.sum(axis=1)
        self.full: Any = None
        self.rates = 2.0 * (damping_ratio or 0.0) * self.omega
        if damping is not None:
            full = self.shapes @ damping @ self.shapes.T
            self.rates = np.diag(full)
            rigid = bool((self.rates[self.omega == 0.0] > 0.0).any())
            self.full = full if rigid or not proportional(mass, damping, stiffness) else None
        self.zeta = self.rates / (2.0 * np.where(self.omega > 0.0, self.omega, 1.0))

    def _state(self, weights: "Any") -> "tuple[Any, Any, float]":
        """The matrix of (q, q̇/pace), how a load drives it, and the pace: the largest frequency."""
        n, pace = len(self.omega), float(self.omega.max()) or 1.0
        below = np.hstack([-np.diag(self.omega**2 / pace), -self.full])
        return np.vstack([pace * np.eye(n, 2 * n, n), below]), np.append(np.zeros(n), weights / pace), pace

    def column(self, rate: float, weights: "Any") -> "Any":
        """Amplitudes of all coordinates under a load of amplitude one at an angular frequency."""
        return self.shapes.T @ self._solved(np.array([rate]), weights)[0]

    def _solved(self, rates: "Any", weights: "Any") -> "Any":
        """Amplitudes of the modes at each angular frequency."""
        column = rates[:, None]
        if self.full is None:
            return weights / ((self.omega - column) * (self.omega + column) + 1j * column * self.rates)
        steps, n = [], len(self.omega)
        for begin in range(0, len(rates), BLOCK):
            some = rates[begin : begin + BLOCK, None]
            left = 1j * some[:, :, None] * self.full
            left[:, range(n), range(n)] += (self.omega - some) * (self.omega + some)
            steps.append(np.linalg.solve(left, np.broadcast_to(weights, (len(some), n))[:, :, None])[:, :, 0])
        return np.concatenate(steps)

    def curve(self, rates: "Any", weights: "Any", read: int) -> "Any":
        """The amplitude of one coordinate over angular frequencies: a sum over real or complex modes."""
        rates = np.asarray(rates, dtype=float)
        if self.full is not None and len(rates) > BLOCK:
            matrix, driven, _ = self._state(weights)
            values, vectors = np.linalg.eig(matrix)
            if np.linalg.cond(vectors) < INDEPENDENT:
                parts = self.shapes[:, read] @ vectors[: len(weights)] * np.linalg.solve(vectors, driven)
                return (parts / (1j * rates[:, None] - values)).sum(axis=1)
        return self._solved(rates, weights) @ self.shapes[:, read]

    def under_sine(self, weights: "Any", load: complex, rate: float, times: "Any", start: "Any") -> "tuple[Any, Any]":
        """Modes and their velocities over even times from `start`, under Re(`load`·e^{iωt}); a mode in each row."""
        if self.full is not None:
            turning = np.array([[0.0, -rate], [rate, 0.0]])
            return self._stepped(weights, turning, times, np.array([[load.real, load.imag]]), start)
        still = np.zeros((len(self.omega), 1))
        unit = self._column().after(still, still, Piece(0.0, math.inf, c=load, p=rate), times)
        return self._with_start(weights, unit, times, start)

    def under_lines(self, weights: "Any", times: "Any", loads: "Any", start: "Any") -> "tuple[Any, Any]":
        """The same under a load that runs straight from sample to sample."""
        if self.full is not None:
            pairs = np.column_stack([loads[:-1], np.diff(loads) / np.diff(times)])
            return self._stepped(weights, np.array([[0.0, 1.0], [0.0, 0.0]]), times, pairs, start)
        unit = states_of_record(Oscillators(self.omega, self.zeta), times, loads)
        return self._with_start(weights, unit, times, start)

    def _column(self) -> Oscillators:
        return Oscillators(self.omega[:, None], self.zeta[:, None])

    def _with_start(self, weights: "Any", unit: "tuple[Any, Any]", times: "Any", start: "Any") -> "tuple[Any, Any]":
        """Responses to a load that acts on each mode by its weight, and the free motion from `start`."""
        q, v = (weights[:, None] * part for part in unit)
        if not np.any(start):
            return q, v
        free = self._column().after(start[0][:, None], start[1][:, None], Piece(0.0, math.inf), times)
        return q + free[0], v + free[1]

    def _stepped(self, weights: "Any", law: "Any", times: "Any", loads: "Any", start: "Any") -> "tuple[Any, Any]":
        """Exact steps by the exponential of state and load together; the load obeys `law`, `loads` are its states."""
        from scipy.linalg import expm

        n = len(self.omega)
        whole = np.zeros((2 * n + 2, 2 * n + 2))
        whole[: 2 * n, : 2 * n], whole[: 2 * n, 2 * n], pace = self._state(weights)
        whole[2 * n :, 2 * n :] = law
        steps = np.zeros((len(times), 2 * n + 2))
        steps[0, :n], steps[0, n : 2 * n], steps[0, 2 * n :] = start[0], start[1] / pace, loads[0]
        if even(np.diff(times)):
            factor = expm(float(times[-1] - times[0]) / (len(times) - 1) * whole)
            if len(loads) > 1:
                steps = steps[:, : 2 * n]
                steps[1:] = loads @ factor[: 2 * n, 2 * n :].T
                factor = factor[: 2 * n, : 2 * n]
            steps = followed(steps, factor)
            return steps[:, :n].T, pace * steps[:, n : 2 * n].T
        last_step, factor = -1.0, whole
        for i, step in enumerate(np.diff(times).tolist()):
            if abs(step - last_step) > EVEN * step:
                last_step, factor = step, expm(step * whole)
            if len(loads) > 1:
                steps[i, 2 * n :] = loads[i]
            steps[i + 1] = factor @ steps[i]
        return steps[:, :n].T, pace * steps[:, n : 2 * n].T

    def damped(self, v: "Any") -> "Any":
        """C·v of velocities of the modes, in one row each or at one time."""
        if self.full is not None:
            return self.full @ v
        return (self.rates if v.ndim == 1 else self.rates[:, None]) * v

    def accelerations(self, weights: "Any", q: "Any", v: "Any", loads: "Any") -> "Any":
        """q̈ of modes in rows; of rates q̇ and q̈ and those of the load it gives the next derivative."""
        return weights[:, None] * loads - self.damped(v) - self.omega[:, None] ** 2 * q

    def losses(self, v: "Any", w: "Any") -> "Any":
        """Σ C·v·w at each time: the power of the dampers for w = v."""
        return (w * self.damped(v)).sum(axis=0)
