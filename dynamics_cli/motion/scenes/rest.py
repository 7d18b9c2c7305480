"""Where a scene may stand still: Newton's method from its start and from poses along its own motions."""

import math

import numpy as np

from dynamics_cli.motion.scenes.small import reduced, stiffness_of, unbalanced

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.start import Start

STEPS, LARGEST = 60, 0.3
# Forces left, over those that act.
BALANCED = 1e-11
SAME = 1e-6
# Walks from the start: how many, and their steps.
WALKS, PACES, PACE = 24, 20, 0.2
MOST_WORK = 6000
# Smaller roots than this share of the largest are zero, and smaller real parts none.
ZERO = 1e-6


class Rest:
    """One place where it stands still: its pose, the multipliers of its joints, and how small motions about it go."""

    def __init__(self, start: "Start", q: "Any", multipliers: "Any") -> None:
        self.system = system = start.system
        self.q, self.multipliers = q, multipliers
        self.state = np.concatenate((q, np.zeros(len(start.state) - system.end)))
        self.roots: list[complex] = []
        self.ways: list[Any] = []
        free, stiffness, damping, mass = reduced(system, 0.0, q, multipliers)
        self.stability = "held" if not free.shape[1] else self._of_stiffness(stiffness)
        if free.shape[1] and np.linalg.cond(mass) < 1e12:
            self._roots(free, stiffness, damping, mass)

    @staticmethod
    def _of_stiffness(stiffness: "Any") -> str:
        values = np.linalg.eigvalsh(0.5 * (stiffness + stiffness.T))
        large = np.abs(values).max()
        if large == 0.0 or np.abs(values).min() <= ZERO * ZERO * large or large < 1e-13:
            return "unstable" if values[0] < -ZERO * large and large > 1e-13 else "neutral"
        return "stable" if values[0] > 0.0 else "unstable"

    def _roots(self, free: "Any", stiffness: "Any", damping: "Any", mass: "Any") -> None:
        k, even = free.shape[1], np.abs(stiffness - stiffness.T).max() <= 1e-8 * np.abs(stiffness).max()
        if even and not np.abs(damping).max():
            from scipy.linalg import eigh

            values, vectors = eigh(0.5 * (stiffness + stiffness.T), mass)
            small = ZERO * ZERO * np.abs(values).max()
            for value, vector in zip(values, vectors.T, strict=True):
                size = math.sqrt(abs(value)) if abs(value) > small else 0.0
                self.roots.append(complex(0.0, size) if value >= 0.0 else complex(size, 0.0))
                self.ways.append(free @ vector)
            return
        below = -np.linalg.solve(mass, np.hstack((stiffness, damping)))
        values, vectors = np.linalg.eig(np.block([[np.zeros((k, k)), np.eye(k)], [below]]))
        large = np.abs(values).max()
        for j in np.argsort(np.abs(values)):
            root = complex(values[j])
            if root.imag >= 0.0:
                real = root.real if abs(root.real) > ZERO * large * 1e-2 else 0.0
                self.roots.append(complex(real, root.imag) if abs(root) > ZERO * large else 0j)
                self.ways.append(np.abs(free @ vectors[:k, j]))
        if any(root.real > 0.0 for root in self.roots):
            self.stability = "unstable"

    def energy(self) -> float:
        """Potential energy in SI."""
        return self.system.energies(self.state)[1] * self.system.mass * self.system.size**2


def rests(start: "Start") -> "list[Rest]":
    """Every place found: first the one that Newton's method reaches from the start, then others."""
    system = start.system
    found: list[tuple[Any, Any]] = []
    count = min(WALKS, max(4, MOST_WORK // system.end**2)) if start.freedom else 0
    for q in [start.q, *_walks(start, count)]:
        for downhill in (False, True):
            one = _newton(start, q, downhill=downhill)
            if one is not None and not any(_same(one[0], other) for other, _ in found):
                found.append(one)
    return [Rest(start, *one) for one in found]


def _same(one: "Any", other: "Any") -> bool:
    apart = one - other
    apart[2::3] -= 2.0 * math.pi * np.round(apart[2::3] / (2.0 * math.pi))
    return bool(np.abs(apart).max() < SAME)


def _walks(start: "Start", count: int) -> "list[Any]":
    """Poses that the scene can move to, a walk for each, in directions spread by the golden ratio."""
    system, poses = start.system, []
    for number in range(count):
        q, heading = start.q, None
        share = 0.25 + 0.75 * ((number * 0.6180339887498949) % 1.0)
        for _ in range(round(PACES * share)):
            f = system.frame_of([*q, *[0.0] * (len(start.state) - system.end)])
            free = np.linalg.svd(system.jacobian(0.0, f))[2][system.m :]
            if heading is None:
                turns = np.array([math.cos((number + 1) * (2.3999632297 * k + 1.0)) for k in range(len(free))])
                heading = free.T @ turns
            way = free.T @ (free @ heading)
            size = float(np.abs(way).max())
            if size < 1e-9:
                break
            heading = way / size
            q = _closed(start, q + PACE * heading)
            if q is None:
                break
        if q is not None:
            poses.append(q)
    return poses


def _closed(start: "Start", q: "Any") -> "Any | None":
    system = start.system
    for _ in range(12):
        f = system.frame_of([*q, *[0.0] * (len(start.state) - system.end)])
        missed = system.gaps(0.0, f)
        if np.abs(missed).max(initial=0.0) < 1e-13:
            return q
        q = q - np.linalg.lstsq(system.jacobian(0.0, f), missed, rcond=1e-12)[0]
    return None


def _newton(start: "Start", q: "Any", *, downhill: bool) -> "tuple[Any, Any] | None":
    """Pose and multipliers at rest; downhill takes every stiffness for positive, which leads to a stable place."""
    system, rest = start.system, np.zeros(start.system.end)
    for _ in range(STEPS):
        f = system.frame_of([*q, *[0.0] * (len(start.state) - system.end)])
        jacobian, missed = system.jacobian(0.0, f), system.gaps(0.0, f)
        forces = unbalanced(system, 0.0, q, rest, np.zeros(system.m))
        multipliers = np.linalg.lstsq(jacobian.T, forces, rcond=1e-12)[0]
        left = forces - jacobian.T @ multipliers
        acting = max(np.abs(forces).max(), np.abs(np.array(system.weights)).max(), strained(system, f), 1e-300)
        if np.abs(left).max() <= BALANCED * acting and np.abs(missed).max(initial=0.0) < 1e-12:
            return q, multipliers
        free = np.linalg.svd(jacobian)[2][system.m :].T
        stiffness = free.T @ stiffness_of(system, 0.0, q, multipliers) @ free
        values, vectors = np.linalg.eigh(0.5 * (stiffness + stiffness.T))
        pull, large = vectors.T @ (free.T @ left), np.abs(values).max(initial=0.0)
        if not large and np.abs(pull).max(initial=0.0):
            return None
        bent = np.abs(values) if downhill else values
        step = free @ (vectors @ np.where(np.abs(values) > 1e-12 * large, pull / np.where(bent, bent, 1.0), 0.0))
        step = step * min(1.0, LARGEST / max(np.abs(step).max(initial=0.0), 1e-300))
        closing = np.linalg.lstsq(jacobian, missed, rcond=1e-12)[0] if system.m else 0.0
        q = q + step - closing
        if np.abs(q[0::3]).max() + np.abs(q[1::3]).max() > 1e4:
            return None
    return None


def strained(system: "Any", f: "Any") -> float:
    """The largest tension in a spring, in the scene's units."""
    return max((abs(force.tension(f)) for force in system.forces if hasattr(force, "tension")), default=0.0)
