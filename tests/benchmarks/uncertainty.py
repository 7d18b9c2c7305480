"""Work and precision of uncertainty: time against error for this engine, plain Monte Carlo and peers where installed.

    python tests/benchmarks/uncertainty.py

Times are the fastest of several warm runs of the computation alone; errors are the worst of both ends of the 95 %
interval, median, mean and deviation, in standard deviations, against an answer a hundred times finer.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import importlib.util
import math
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "core"))
import uncertain_models as m

from dynamics_cli.core.uncertainty.propagation import Spread, propagate

PROBLEMS: "dict[str, tuple[Any, Any, float]]" = {
    "skid, 3 normal": (m.skid, m.SKID, 1e-8),
    "momentum, 8": (lambda x: m.momentum(x)["v1"], m.MOMENTUM, 1e-4),
    "surfaces, 12": (m.surfaces, m.SURFACES, 1e-4),
    "cam, 4 uniform": (m.cam, m.TOLERANCES, 1e-4),
    "gear, mixed": (m.gear, m.GEAR, 1e-4),
    "impact, kinked, 8": (m.impact, m.IMPACT, 1e-3),
    "mixed, 20": (m.mixed20, m.mixed20_inputs(), 1e-3),
}


def answer(function: Any, inputs: Any, **more: Any) -> Spread:
    return next(iter(propagate(m.model_of(function), inputs, shares=False, **more).spreads.values()))


def fastest(call: Callable[[], Any]) -> float:
    call()
    times: list[float] = []
    start = time.perf_counter()
    while len(times) < 3 or (time.perf_counter() - start < 0.5 and len(times) < 200):
        begin = time.perf_counter()
        call()
        times.append(time.perf_counter() - begin)
    return min(times)


def numbers(spread: Spread) -> "np.ndarray[Any, Any]":
    return np.array([*spread.interval, spread.median, spread.mean, spread.std])


def line(problem: str, method: str, seconds: float, error: float, estimate: float) -> None:
    print(f"{problem:18} {method:34} {seconds * 1e3:9.2f} ms {error:9.1e} {estimate:9.1e}", flush=True)


def peers(exact: Spread) -> None:
    """First-order libraries on the skid: what they give for the interval is mean ± 1.96 σ."""

    def report(name: str, call: Callable[[], tuple[float, float]]) -> None:
        mean, std = call()
        found = np.array([mean - 1.959964 * std, mean + 1.959964 * std, mean, mean, std])
        line("skid, 3 normal", name, fastest(call), float(np.abs(found - numbers(exact)).max()) / exact.std, math.nan)

    if importlib.util.find_spec("uncertainties"):
        from uncertainties import ufloat, umath

        def linear() -> tuple[float, float]:
            mu, d, theta = ufloat(0.72, 0.04), ufloat(38.5, 0.6), ufloat(-0.03, 0.005)
            v = umath.sqrt(2.0 * m.G * d * (mu * umath.cos(theta) + umath.sin(theta)))
            return v.nominal_value, v.std_dev

        report("uncertainties, first order", linear)
    if importlib.util.find_spec("GTC"):
        import GTC

        def gtc() -> tuple[float, float]:
            mu, d, theta = GTC.ureal(0.72, 0.04), GTC.ureal(38.5, 0.6), GTC.ureal(-0.03, 0.005)
            v = GTC.sqrt(2.0 * m.G * d * (mu * GTC.cos(theta) + GTC.sin(theta)))
            return GTC.value(v), GTC.uncertainty(v)

        report("GTC, first order", gtc)
    if importlib.util.find_spec("mcerp"):
        import mcerp
        from mcerp import umath as mc

        def latin() -> tuple[float, float]:
            mu, d, theta = mcerp.N(0.72, 0.04), mcerp.N(38.5, 0.6), mcerp.N(-0.03, 0.005)
            v = mc.sqrt(2.0 * m.G * d * (mu * mc.cos(theta) + mc.sin(theta)))
            return float(v.mean), float(v.std)

        report("mcerp, Latin hypercube of 1e4", latin)


def main() -> None:
    print(f"{'problem':18} {'method':34} {'time':>12} {'error':>9} {'estimate':>9}")
    for name, (function, inputs, accuracy) in PROBLEMS.items():
        exact = answer(function, inputs, accuracy=0.05 * accuracy, samples=20_000_000, seed=77)
        wanted = {f"ours, asked for {accuracy:.0e}": {"accuracy": accuracy}}
        for method in ("linear", "second-order", "unscented"):
            wanted[method] = {"method": method}
        for count in (10_000, 1_000_000):
            wanted[f"Monte Carlo, {count}"] = {"method": "monte-carlo", "samples": count}
        for label, more in wanted.items():
            spread = answer(function, inputs, **more)
            error = float(np.abs(numbers(spread) - numbers(exact)).max()) / exact.std
            # The classical methods are timed with the quadrature that tells their error.
            line(name, label, fastest(partial(answer, function, inputs, **more)), error, spread.estimate)
        if name == "skid, 3 normal":
            peers(exact)


if __name__ == "__main__":
    main()
