"""Forced vibration as textbooks have it: by the ratio of frequencies."""

import cmath
import math
from typing import Any

from dynamics_cli.accuracy.questions import textbooks


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
    ("forced", "textbook: frequency ratio", "by_ratio"),
)  # fmt: skip
