"""What a nonlinear oscillator really does: integrated over one cycle, or closed by the arithmetic–geometric mean."""

import math

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.numerics.roots import bisected

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Law = Callable[[float, float], float]

TOLERANCE, LOOSER = 1e-12, 1e-10
# Beyond this a van der Pol oscillator is stiff.
STIFF = 20.0
NEWTON = 12


def half_cycle(f: "Law", start: float, tolerance: float, jacobian: "Any" = None) -> "tuple[float, float]":
    """From rest at `start` to the next rest of ẍ + x + f(x, ẋ) = 0: the time, and the displacement there."""
    from scipy.integrate import solve_ivp

    side = 1.0 if start > 0.0 else -1.0

    def rate(_: float, y: "Any") -> "tuple[float, float]":
        return y[1], -y[0] - f(float(y[0]), float(y[1]))

    def resting(t: float, y: "Any") -> float:
        return float(y[1]) * side + (1e-300 if t == 0.0 else 0.0)

    resting.terminal, resting.direction = True, 1.0  # type: ignore[attr-defined]
    require(
        -side * (start + f(start, 0.0)) < 0.0, "from rest at {start:4g} the motion does not come back",
        code="no-return", start=f"{start:g}", hint="the spring pushes away there: begin nearer to the middle",
    )  # fmt: skip
    more = {"jac": jacobian} if jacobian else {}
    solved = solve_ivp(
        rate, (0.0, 1e4), (start, 0.0), method="Radau" if jacobian else "DOP853", rtol=tolerance, atol=tolerance,
        events=resting, dense_output=False, **more,
    )  # fmt: skip
    require(solved.status == 1, "the motion does not come back to rest", code="no-return")
    return float(solved.t_events[0][-1]), float(solved.y_events[0][-1][0])


def limit_cycle(f: "Law", start: float, stiff: "Any", tolerance: float) -> "tuple[float, float]":
    """Amplitude and period of a limit cycle of an odd law: the half-cycle map meets its mirror; secant method."""

    def off(x: float) -> "tuple[float, float]":
        time, end = half_cycle(f, x, tolerance, stiff)
        return -end - x, time

    a, b = start, start * 1.001
    (fa, _), (fb, time) = off(a), off(b)
    for _ in range(NEWTON):
        if abs(fb) <= 10.0 * tolerance * b or fb == fa:
            break
        a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
        fb, time = off(b)
    return b, 2.0 * time


def after_cycles(f: "Law", start: float, cycles: int, tolerance: float) -> "tuple[float, float]":
    """Amplitude after so many cycles, and the time they took."""
    time, place = 0.0, start
    for _ in range(2 * cycles):
        more, place = half_cycle(f, place, tolerance)
        time += more
    return abs(place), time


class Forced:
    """ẍ + 2ζẋ + x + αx³ = F·cos Ωt: cycles of the period of the force by shooting."""

    def __init__(self, zeta: float, cubic: float, force: float, omega: float) -> None:
        self.zeta, self.cubic, self.force, self.omega = zeta, cubic, force, omega

    def rate(self, t: float, y: "Any") -> "tuple[float, float]":
        """The rates of displacement and velocity."""
        x, v = float(y[0]), float(y[1])
        return v, self.force * math.cos(self.omega * t) - 2.0 * self.zeta * v - x - self.cubic * x * x * x

    def over_period(self, state: "Any", dense: bool = False) -> "Any":
        """The state a period later (or the whole solution)."""
        from scipy.integrate import solve_ivp

        period = 2.0 * math.pi / self.omega
        solved = solve_ivp(self.rate, (0.0, period), state, method="DOP853", rtol=TOLERANCE, atol=TOLERANCE,
                         dense_output=dense)  # fmt: skip
        return solved if dense else solved.y[:, -1]

    def cycle(self, amplitude: float, lag: float) -> "tuple[float, float, bool] | None":
        """First harmonic and largest displacement of the true cycle near to an averaged one; whether it is stable."""
        state = np.array([amplitude * math.cos(lag), amplitude * self.omega * math.sin(lag)])
        for _ in range(NEWTON):
            end = self.over_period(state)
            step = 1e-6 * max(amplitude, 1e-9)
            columns = [(self.over_period(state + step * unit) - end) / step for unit in np.eye(2)]
            monodromy = np.array(columns).T
            change = np.linalg.solve(monodromy - np.eye(2), end - state)
            state = state - change
            if abs(change).max() <= 1e-10 * max(amplitude, 1e-9):
                break
        else:
            return None
        period = self.over_period(state, dense=True)
        times = np.arange(256) / 256.0 * period.t[-1]
        x = period.sol(times)[0]
        first = 2.0 * abs((x * np.exp(-1j * self.omega * times)).mean())
        stable = bool(max(abs(np.linalg.eigvals(monodromy))) < 1.0)
        return float(first), float(abs(x).max()), stable


def balance_roots(zeta: float, cubic: float, force: float, omega: float) -> "list[float]":
    """Amplitudes a of ((1 − Ω² + ¾αa²)² + 4ζ²Ω²)·a² = F², from the smallest."""
    p, q = (1.0 - omega) * (1.0 + omega), 4.0 * zeta * zeta * omega * omega
    c = 0.75 * cubic
    polynomial = np.array([c * c, 2.0 * c * p, p * p + q, -force * force])
    roots = np.roots(np.trim_zeros(polynomial, "f"))
    amplitudes = []
    for root in roots:
        if abs(root.imag) > 1e-7 * abs(root) or root.real <= 0.0:
            continue
        u = float(root.real)
        for _ in range(3):
            value = ((c * u + p) ** 2 + q) * u - force * force
            slope = (c * u + p) * (3.0 * c * u + p) + q
            u -= value / slope if slope else 0.0
        amplitudes.append(math.sqrt(u))
    return sorted(amplitudes)


def jumps(zeta: float, cubic: float, force: float, top: float) -> "list[float | None]":
    """Frequencies at which the number of amplitudes changes: zeros of the cubic's discriminant, from the lowest.

    None stands for one at which a softening spring pushes away.
    """

    def discriminant(omega: "Any") -> "Any":
        p, q = (1.0 - omega) * (1.0 + omega), 4.0 * zeta * zeta * omega * omega
        a, b, c, d = (0.75 * cubic) ** 2, 1.5 * cubic * p, p * p + q, -force * force
        return 18 * a * b * c * d - 4 * b**3 * d + b * b * c * c - 4 * a * c**3 - 27 * a * a * d * d

    looks = np.linspace(0.01, top, 4000)
    positive = discriminant(looks) > 0.0
    places = [
        bisected(discriminant, float(looks[nth]), float(looks[nth + 1]))
        for nth in np.flatnonzero(positive[1:] != positive[:-1])
    ]
    return [place if _returns(zeta, cubic, force, place) else None for place in places]


def _returns(zeta: float, cubic: float, force: float, omega: float) -> bool:
    """Whether the amplitude that two branches share at a jump lies where a softening spring still pulls back."""
    p, q, c = (1.0 - omega) * (1.0 + omega), 4.0 * zeta * zeta * omega * omega, 0.75 * cubic
    root = math.sqrt(max(p * p - 3.0 * q, 0.0))
    shared = [(-2.0 * p + sign * root) / (3.0 * c) for sign in (-1.0, 1.0)]
    u = min(shared, key=lambda u: abs(((c * u + p) ** 2 + q) * u - force * force))
    return 1.0 + cubic * u > 0.0
