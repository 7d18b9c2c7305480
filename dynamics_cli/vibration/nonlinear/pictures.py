"""Averaging and truth overlaid, phase portraits, backbones, branches under a force."""

import math

import numpy as np

from dynamics_cli.numerics.elliptic import mean
from dynamics_cli.pictures import Axis, Band, Curve, Panel, Picture
from dynamics_cli.vibration.nonlinear.averaging import averages
from dynamics_cli.vibration.nonlinear.task import Duffing, ForcedDuffing, Pendulum, VanDerPol, law_of
from dynamics_cli.vibration.nonlinear.truth import STIFF

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

POINTS = 1200
CYCLES = 4.0


def nonlinear(result: "Any", *, oscillator: "Any", **_: "Any") -> Picture:
    """What there is to see of this oscillator."""
    if isinstance(oscillator, ForcedDuffing):
        return _branches(result, oscillator)
    panels = [_overlay(result, oscillator)]
    if isinstance(oscillator, Pendulum | Duffing):
        panels.append(_backbone(oscillator))
    else:
        panels.append(_portrait(result, oscillator))
    return Picture(tuple(panels), "averaging beside the truth")


def _start(result: "Any", oscillator: "Any") -> float:
    if isinstance(oscillator, Pendulum):
        return abs(float(oscillator.swing))
    return float(result.true_amplitude) if isinstance(oscillator, VanDerPol) else float(oscillator.amplitude)


def _motion(oscillator: "Any", start: float, velocity: float, end: float) -> "tuple[Any, Any, Any]":
    """The integrated motion: times, displacements, velocities."""
    from scipy.integrate import solve_ivp

    f = law_of(oscillator)
    times = np.linspace(0.0, end, POINTS)
    method: Any = "Radau" if isinstance(oscillator, VanDerPol) and oscillator.mu > STIFF else "DOP853"
    solution = solve_ivp(lambda _, y: (y[1], -y[0] - f(float(y[0]), float(y[1]))), (0.0, end), (start, velocity),
                         method=method, rtol=1e-8, atol=1e-8, t_eval=times)  # fmt: skip
    return solution.t, solution.y[0], solution.y[1]


def _overlay(result: "Any", oscillator: "Any") -> Panel:
    """Displacement over time, integrated and averaged."""
    a = _start(result, oscillator)
    end = float(result.period) * getattr(oscillator, "cycles", CYCLES)
    times, places, _ = _motion(oscillator, a, 0.0, end)
    if isinstance(oscillator, Pendulum | Duffing | VanDerPol):
        size = 2.0 if isinstance(oscillator, VanDerPol) else a
        averaged = size * np.cos(float(result.averaged_frequency) * times)
    else:
        averaged = _averaged(law_of(oscillator), a, times)
    items = (Curve(times, places, "integrated", role=0), Curve(times, averaged, "averaged", "dashed", role=1))
    return Panel(Axis("time · ω", ends=(0.0, end)), Axis("displacement"), items)


def _averaged(f: "Any", a: float, times: "Any") -> "Any":
    """The averaged motion by Heun's steps; a picture needs no more."""
    result, phase = [a], 0.0
    step = float(times[1] - times[0])
    for _ in times[1:]:
        fall, turn = averages(f, max(a, 1e-9))
        a += step * 0.5 * (fall + averages(f, max(a + step * fall, 1e-9))[0])
        phase += step * turn
        result.append(a * math.cos(phase))
    return np.array(result)


def _portrait(result: "Any", oscillator: "Any") -> Panel:
    """Velocity over displacement, from inside and outside."""
    a = _start(result, oscillator)
    end = 3.0 * CYCLES * float(result.period) if isinstance(oscillator, VanDerPol) else float(result.period) * CYCLES
    items = []
    for nth, share in enumerate((1.0, 0.2, 1.6) if isinstance(oscillator, VanDerPol) else (1.0,)):
        _, x, v = _motion(oscillator, share * a, 0.0, end)
        items.append(Curve(x, v, f"from {share * a:.3g}", "solid" if nth == 0 else "thin", role=nth))
    return Panel(Axis("displacement"), Axis("velocity / ω"), tuple(items), "phase portrait")


def _backbone(oscillator: "Any") -> Panel:
    """Frequency over amplitude, both ways."""
    if isinstance(oscillator, Pendulum):
        sizes = [math.radians(i) for i in range(1, 180)]
        true = [mean(1.0, math.cos(0.5 * size)) for size in sizes]
        averaged = [1.0 - size * size / 16.0 for size in sizes]
        at, x = math.degrees(abs(oscillator.swing)), [math.degrees(size) for size in sizes]
    else:
        limit = 2.0 * oscillator.amplitude
        if oscillator.cubic < 0.0:
            limit = min(limit, 0.999 / math.sqrt(-oscillator.cubic))
        x = [limit * i / 200.0 for i in range(1, 201)]
        shares = [oscillator.cubic * size * size for size in x]
        true = [mean(math.sqrt(1.0 + share), math.sqrt(1.0 + 0.5 * share)) for share in shares]
        averaged = [1.0 + 0.375 * share for share in shares]
        at = oscillator.amplitude
    items = (
        Curve(x, true, "true", role=0), Curve(x, averaged, "averaged", "dashed", role=1), Band(at, at, "this amplitude")
    )  # fmt: skip
    unit = "amplitude [deg]" if isinstance(oscillator, Pendulum) else "amplitude"
    return Panel(Axis(unit, ends=(0.0, x[-1])), Axis("frequency over linear"), items, "backbone")


def _branches(result: "Any", given: ForcedDuffing) -> Picture:
    """Steady amplitudes over frequency: stable, unstable, jumps, backbone, what was integrated."""
    zeta, cubic, force = given.damping_ratio, given.cubic, given.force
    largest = max(row.amplitude for row in result.branches)
    # at resonance F/(2ζΩ): a softening spring has it below 1
    peak = max(force / (2.0 * zeta * min([1.0, *(jump for jump in result.jumps if jump > 0.2)])), largest)
    curves: dict[tuple[float, bool], tuple[list[float], list[float]]] = {
        (sign, stable): ([], []) for sign in (-1.0, 1.0) for stable in (True, False)
    }
    backbone: tuple[list[float], list[float]] = ([], [])
    tip = largest
    sizes = [peak * 1.2 * i / 1500.0 for i in range(3, 1501)]
    for a in sizes:
        p = 1.0 + 0.75 * cubic * a * a
        if p > 0.0:
            backbone[0].append(math.sqrt(p))
            backbone[1].append(a)
        half, square = p - 2.0 * zeta * zeta, p * p - (force / a) ** 2
        inside = half * half - square
        if inside < 0.0:
            for x, y in curves.values():
                x.append(math.sqrt(max(p, 0.0)))
                y.append(math.nan)
            continue
        tip = a
        for sign in (-1.0, 1.0):
            u = half + sign * math.sqrt(inside)
            if u <= 0.0:
                continue
            # where the force falls with the amplitude, the motion leaves the branch
            q, c = 1.0 - u, 0.75 * cubic * a * a
            steady = 3.0 * c * c + 4.0 * c * q + q * q + 4.0 * zeta * zeta * u > 0.0
            for stable in (True, False):
                x, y = curves[sign, stable]
                x.append(math.sqrt(u))
                y.append(a if stable == steady else math.nan)
    end = 1.6 * max([given.frequency_ratio, 1.0, *(one for one in result.jumps if one < 10.0)])
    items: list[Any] = [Curve(*backbone, "backbone", "dotted", role=6)]
    for (sign, stable), curve in curves.items():
        name = "" if sign > 0.0 else "stable" if stable else "unstable"
        items.append(Curve(*curve, name, "solid" if stable else "dashed", role=0 if stable else 1))
    for nth, jump in enumerate(result.jumps):
        items.append(Band(jump, jump, "jumps" if nth == 0 else ""))
    heights = [row.true_amplitude or row.amplitude for row in result.branches]
    items.append(Curve([given.frequency_ratio] * len(heights), heights, "integrated", "points", role=2))
    axes = (
        Axis("frequency over linear", ends=(0.0, end)),
        Axis("amplitude", ends=(0.0, max(1.3 * largest, 1.1 * min(tip, 3.0 * largest)))),
    )
    return Picture((Panel(*axes, tuple(items)),), "steady amplitudes under the force")
