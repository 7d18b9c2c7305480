"""Krylov and Bogoliuboff: slow equations of amplitude and phase of ẍ + x + f(x, ẋ) = 0, averaged over a cycle."""

import math

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    Law = Callable[[float, float], float]

# The trapezoidal rule over a period converges faster than any power for smooth laws.
POINTS = 256


def averages(f: "Law", a: float) -> "tuple[float, float]":
    """ȧ = −(1/2π)∮f·cos ψ dψ and ψ̇ = 1 + (1/2πa)∮f·sin ψ dψ, with x = a·sin ψ, ẋ = a·cos ψ."""
    fall = turn = 0.0
    for i in range(POINTS):
        psi = 2.0 * math.pi * (i + 0.5) / POINTS
        s, c = math.sin(psi), math.cos(psi)
        value = f(a * s, a * c)
        fall -= value * c / POINTS
        turn += value * s / (a * POINTS)
    return fall, 1.0 + turn


def after(f: "Law", a: float, time: float) -> "tuple[float, float]":
    """Amplitude and phase after a time, by the averaged equations."""
    from scipy.integrate import solve_ivp

    def rate(_: float, y: "list[float]") -> "tuple[float, float]":
        return averages(f, max(float(y[0]), 1e-12 * a))

    end = solve_ivp(rate, (0.0, time), (a, 0.0), rtol=1e-9, atol=1e-12 * a).y[:, -1]
    return max(float(end[0]), 0.0), float(end[1])
