"""Vibration by the forms of textbooks and scripts: modes from assembled matrices, roots of the frequency equation."""

import cmath
import math
from typing import Any

from dynamics_cli.accuracy.questions import textbooks


def _assembled(system: "Any") -> "tuple[Any, Any]":
    import numpy as np

    masses, stiffnesses = system.masses, system.stiffnesses
    n = len(masses)
    stiffness = np.zeros((n, n))
    first = 0 if len(stiffnesses) >= n else 1
    for nth, k in enumerate(stiffnesses):
        i, j = nth + first - 1, nth + first
        for a, b, sign in ((i, i, 1.0), (j, j, 1.0), (i, j, -1.0), (j, i, -1.0)):
            if 0 <= a < n and 0 <= b < n:
                stiffness[a, b] += sign * k
    return np.diag(masses), stiffness


def frequencies(squares: "Any") -> "dict[str, float]":
    """Modes by address, the lowest first; what came out negative is none."""
    results: dict[str, float] = {}
    for nth, square in enumerate(sorted(map(float, squares))):
        rate = math.sqrt(max(square, 0.0))
        results |= {f"modes[{nth}].angular_frequency": rate, f"modes[{nth}].frequency": rate / (2.0 * math.pi)}
    return results


def by_eigh(*, system: "Any", **_: "Any") -> "dict[str, float]":
    """Symmetric eigenvalues of assembled stiffness and mass (LAPACK's dsygv)."""
    from scipy.linalg import eigh

    mass, stiffness = _assembled(system)
    return frequencies(eigh(stiffness, mass, eigvals_only=True))


def by_inverse(*, system: "Any", **_: "Any") -> "dict[str, float]":
    """Eigenvalues of M⁻¹K, as scripts have it."""
    import numpy as np

    mass, stiffness = _assembled(system)
    return frequencies(np.linalg.eigvals(np.linalg.inv(mass) @ stiffness).real)


def _oscillator(mass: "Any", spring: "Any", damping: "Any") -> "tuple[float, float]":
    if hasattr(spring, "stiffness"):
        omega = math.sqrt(spring.stiffness / mass)
    else:
        omega = 2.0 * math.pi * spring.natural_frequency
    if damping is None:
        return omega, 0.0
    return omega, damping.damping_ratio if hasattr(damping, "damping_ratio") else damping.damping / (2.0 * mass * omega)


def by_ratio(
    *, mass: float, spring: "Any", force: float, excitation: "Any", damping: "Any" = None, time: "float | None" = None,
    **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """1/√((1 − r²)² + (2ζr)²) with r rounded first; from rest, steady vibration less a free one."""
    omega, zeta = _oscillator(mass, spring, damping)
    if hasattr(excitation, "detuning"):
        r = 1.0 + excitation.detuning
    else:
        r = getattr(excitation, "frequency_ratio", 0.0) or 2.0 * math.pi * excitation.frequency / omega
    size = 1.0 / math.sqrt((1.0 - r * r) ** 2 + (2.0 * zeta * r) ** 2)
    still = force / (mass * omega * omega)
    results = {"magnification": size, "amplitude": still * size, "phase": math.atan2(2.0 * zeta * r, 1.0 - r * r)}
    if time is not None:
        steady = still * size * cmath.exp(1j * (r * omega * time - results["phase"]))
        start = still * size * cmath.exp(-1j * results["phase"])
        damped = omega * math.sqrt(1.0 - zeta * zeta)
        sine = -((1j * r * omega * start).real + zeta * omega * start.real) / damped
        free = -start.real * math.cos(damped * time) + sine * math.sin(damped * time)
        results["position"] = steady.real + math.exp(-zeta * omega * time) * free
    return results


QUESTIONS = textbooks(
    "vibration", "vibration.json", "dynamics_cli.accuracy.alternatives.vibration:",
    ("modes", "scipy.linalg.eigh(K, M)", "by_eigh", "scipy"),
    ("modes", "eigenvalues of inv(M) @ K", "by_inverse", "numpy"),
    ("forced", "textbook: frequency ratio", "by_ratio"),
)  # fmt: skip
