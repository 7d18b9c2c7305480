"""Inverse involute: time and error of the series beside Newton, brentq and scipy's vectorised root.

Run: python tests/benchmarks/gear_involute.py. Peers that are not installed are left out. All in one run; times are
processor time, the best of several, over a million angles; errors in units of the last place against 60 digits.
"""

import math
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from mpmath import mp, mpf, tan

from dynamics_cli.numerics.involute import inverse_involute, involute

COUNT = 1_000_000
BANDS = {"1e-8 rad … 1e-3": (1e-8, 1e-3), "1e-3 … 5°": (1e-3, 0.0873), "5° … 35°": (0.0873, 0.611),
         "35° … 70°": (0.611, 1.2217), "70° … 89.9999°": (1.2217, math.radians(89.9999))}  # fmt: skip


def newton(value: Any) -> Any:
    """Newton on tan φ − φ from Laskin's start, until nothing changes."""
    phi = 1.441 * np.cbrt(value) - 0.374 * value
    for _ in range(60):
        step = (np.tan(phi) - phi - value) / np.tan(phi) ** 2
        phi = phi - step
        if np.all(np.abs(step) <= 4e-16 * np.abs(phi)):
            break
    return phi


def newton_in_tangent(value: Any) -> Any:
    """Newton in t = tan φ on t − atan t."""
    t = np.where(value < 1.0, np.cbrt(3.0 * value), value + 1.5)
    for _ in range(60):
        step = (t - np.arctan(t) - value) * (1.0 + t * t) / (t * t)
        t = t - step
        if np.all(np.abs(step) <= 4e-16 * np.abs(t)):
            break
    return np.arctan(t)


def scipy_vectorised() -> Callable[[Any], Any] | None:
    """scipy.optimize.elementwise.find_root, bracketed."""
    try:
        from scipy.optimize import elementwise
    except ImportError:
        return None

    def solve(value: Any) -> Any:
        low, high = np.zeros_like(value), np.full_like(value, math.pi / 2 - 1e-9)
        return elementwise.find_root(lambda x, v: np.tan(x) - x - v, (low, high), args=(value,)).x

    return solve


def brentq_scalar() -> Callable[[float], float] | None:
    try:
        from scipy.optimize import brentq
    except ImportError:
        return None
    return lambda value: brentq(
        lambda x: math.tan(x) - x - value, 0.0, math.pi / 2 - 1e-9, xtol=1e-300, rtol=9e-16, disp=False, maxiter=500
    )


def best(work: Callable[[], Any], repeats: int) -> float:
    times = []
    for _ in range(repeats):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


def ulps(found: Any, values: Any) -> float:
    """Largest error in units of the last place."""
    mp.dps = 60
    worst = 0.0
    for phi, value in zip(np.asarray(found).tolist(), values.tolist(), strict=True):
        exact = mpf(inverse_involute(value))
        for _ in range(3):
            exact -= (tan(exact) - exact - mpf(value)) / tan(exact) ** 2
        error = abs(mpf(phi) - exact) / math.ulp(float(exact)) if math.isfinite(phi) else math.inf
        worst = max(worst, float(error))
    return worst


def main() -> None:
    generator = np.random.default_rng(17)
    methods: dict[str, Callable[[Any], Any]] = {"this program": inverse_involute, "Newton to convergence": newton,
                                                "Newton in tan φ": newton_in_tangent}  # fmt: skip
    rooted = scipy_vectorised()
    if rooted is not None:
        methods["scipy find_root, vectorised"] = rooted
    everywhere = involute(generator.uniform(1e-8, math.radians(89.9999), COUNT))
    usual = involute(generator.uniform(math.radians(5.0), math.radians(55.0), COUNT))
    times = {}
    print(f"{'ns a value, 1e6 values':32s} {'0 … 89.9999°':>14s} {'5° … 55°':>12s}")
    for name, method in methods.items():
        size = COUNT if name == "this program" else COUNT // 10
        with np.errstate(all="ignore"):
            cells = [best(lambda v=v, m=method: m(v), 7 if size == COUNT else 2) / v.size * 1e9  # type: ignore[misc]
                     for v in (everywhere[:size], usual[:size])]  # fmt: skip
        times[name] = cells
        print(f"{name:32s} {cells[0]:14.1f} {cells[1]:12.1f}")
    ours = times["this program"]
    for name, cells in times.items():
        if name != "this program":
            print(f"  this program is {cells[0] / ours[0]:.1f} × and {cells[1] / ours[1]:.1f} × as fast as {name}")
    some = usual[:2000].tolist()
    one = best(lambda: [inverse_involute(v) for v in some], 5) / 2000 * 1e9
    print(f"one at a time: this program {one:.0f} ns")
    brent = brentq_scalar()
    if brent is not None:
        each = best(lambda: [brent(v) for v in some[:300]], 3) / 300 * 1e9
        print(f"one at a time: brentq {each:.0f} ns, {each / one:.1f} ×")
        methods["brentq"] = lambda values: np.array([brent(float(v)) for v in values])
    print(f"\n{'largest error, ulp':32s} " + " ".join(f"{name:>18s}" for name in BANDS))
    for name, method in methods.items():
        cells = []
        for low, high in BANDS.values():
            values = involute(low * (high / low) ** generator.random(150))
            with np.errstate(all="ignore"):
                cells.append(ulps(method(values), values))
        print(f"{name:32s} " + " ".join(f"{cell:18.3g}" for cell in cells))


if __name__ == "__main__":
    main()
