"""Vibration by the forms of textbooks and scripts: modes from assembled matrices, roots of the frequency equation."""

import cmath
import math

from dynamics_cli.accuracy.questions import Method, Question

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


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


def _listed(squares: "Any") -> "dict[str, float]":
    """Frequencies by address, the lowest first; what came out negative is none."""
    rates = [math.sqrt(max(float(square), 0.0)) for square in sorted(squares)]
    made: dict[str, float] = {}
    for nth, rate in enumerate(rates):
        made |= {f"modes[{nth}].angular_frequency": rate, f"modes[{nth}].frequency": rate / (2.0 * math.pi)}
    return made


def by_eigh(*, system: "Any", **_: "Any") -> "dict[str, float]":
    """Symmetric eigenvalues of assembled stiffness and mass (LAPACK's dsygv)."""
    from scipy.linalg import eigh

    mass, stiffness = _assembled(system)
    return _listed(eigh(stiffness, mass, eigvals_only=True))


def by_inverse(*, system: "Any", **_: "Any") -> "dict[str, float]":
    """Eigenvalues of M⁻¹K, as scripts have it."""
    import numpy as np

    mass, stiffness = _assembled(system)
    return _listed(np.linalg.eigvals(np.linalg.inv(mass) @ stiffness).real)


def _oscillator(mass: "Any", spring: "Any", damping: "Any") -> "tuple[float, float]":
    if hasattr(spring, "stiffness"):
        omega = math.sqrt(spring.stiffness / mass)
    else:
        omega = 2.0 * math.pi * spring.natural_frequency
    if damping is None:
        return omega, 0.0
    return omega, damping.damping_ratio if hasattr(damping, "damping_ratio") else damping.damping / (2.0 * mass * omega)


def by_roots(
    *, spring: "Any", mass: "Any" = None, damping: "Any" = None, displacement: float = 0.0, start_velocity: float = 0.0,
    time: "float | None" = None, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """A·e^{s₁t} + B·e^{s₂t} with the roots of m·s² + c·s + k = 0."""
    if hasattr(damping, "friction") or time is None:
        raise ValueError("no viscous damping")
    omega, zeta = _oscillator(mass, spring, damping)
    root = cmath.sqrt(zeta * zeta - 1.0)
    one, other = omega * (-zeta + root), omega * (-zeta - root)
    a = (start_velocity - other * displacement) / (one - other)
    b = displacement - a
    grown, fallen = a * cmath.exp(one * time), b * cmath.exp(other * time)
    return {"position": (grown + fallen).real, "velocity": (one * grown + other * fallen).real}


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
    made = {"magnification": size, "amplitude": still * size, "phase": math.atan2(2.0 * zeta * r, 1.0 - r * r)}
    if time is not None:
        steady = still * size * cmath.exp(1j * (r * omega * time - made["phase"]))
        start = still * size * cmath.exp(-1j * made["phase"])
        damped = omega * math.sqrt(1.0 - zeta * zeta)
        sine = -((1j * r * omega * start).real + zeta * omega * start.real) / damped
        free = -start.real * math.cos(damped * time) + sine * math.sin(damped * time)
        made["position"] = steady.real + math.exp(-zeta * omega * time) * free
    return made


HERE = "dynamics_cli.accuracy.alternatives.vibration:"
QUESTIONS = (
    Question(
        "vibration", "", "", "vibration.json", "modes",
        Method("scipy.linalg.eigh(K, M)", HERE + "by_eigh", needs="scipy"),
        Method("eigenvalues of inv(M) @ K", HERE + "by_inverse", needs="numpy"),
    ),
    Question("vibration", "", "", "vibration.json", "free", Method("textbook: two roots", HERE + "by_roots")),
    Question("vibration", "", "", "vibration.json", "forced", Method("textbook: frequency ratio", HERE + "by_ratio")),
)  # fmt: skip
