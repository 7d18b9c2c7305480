"""Does the stated error hold? Fresh random problems; each is answered, then answered again far more finely.

    python tests/core/coverage_experiment.py [PROBLEMS]

prints, for problems whose finer answer can tell, for every kind of problem, the share whose true error (worst of the interval's ends, median, mean and deviation)
stays within the estimate, how often the wanted accuracy was met, and the median and 95th percentile of the time.
"""  # noqa: E501

import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))

import uncertain_models as m

from dynamics_cli.core.inputs.uncertain.distributions import Distribution, Normal, Uniform
from dynamics_cli.core.uncertainty.propagation import Spread, propagate

Maker = Callable[[np.random.Generator], dict[str, Distribution]]


def random_impact(rng: np.random.Generator) -> dict[str, Distribution]:
    return {
        "m": Normal(rng.uniform(900, 2500), 50.0), "J": Normal(rng.uniform(1500, 4000), 150.0),
        "rn": Normal(rng.uniform(1.2, 2.2), 0.1), "rt": Normal(rng.uniform(-0.8, 0.8), 0.1),
        "e": Uniform(0.05, rng.uniform(0.15, 0.4)), "mu": Normal(rng.uniform(0.3, 0.7), 0.06),
        "un": Normal(rng.uniform(5, 15), 0.5), "ut": Normal(rng.uniform(2, 25), 1.0),
    }  # fmt: skip


def random_cam(rng: np.random.Generator) -> dict[str, Distribution]:
    return {
        "h": m.any_distribution(rng, 0.012, 1e-4), "beta": m.any_distribution(rng, rng.uniform(1.0, 2.0), 0.015),
        "r": m.any_distribution(rng, rng.uniform(0.03, 0.06), 3e-4),
    }  # fmt: skip


def random_gear(rng: np.random.Generator) -> dict[str, Distribution]:
    return {
        "alpha": Normal(20.0 * m.DEG, rng.uniform(0.02, 0.2) * m.DEG), "x": Normal(rng.uniform(-0.3, 0.8), 0.02),
        "z": Normal(float(rng.integers(20, 80)), 0.0), "m": Normal(3.0, rng.uniform(0.001, 0.01)),
    }  # fmt: skip


KINDS: dict[str, tuple[Callable[[dict[str, Any]], Any], Maker, float, int]] = {
    "skid, normal": (m.skid, lambda rng: m.random_skid(rng, mixed=False), 1e-8, 1),
    "skid, mixed": (m.skid, lambda rng: m.random_skid(rng, mixed=True), 1e-4, 1),
    "momentum": (lambda x: m.momentum(x)["v1"], m.random_momentum, 1e-4, 2),
    "impact, kinked": (m.impact, random_impact, 1e-3, 20),
    "cam, mixed": (m.cam_without_offset, random_cam, 1e-4, 1),
    "gear, normal": (m.gear, random_gear, 1e-6, 1),
}


def answer(function: Any, inputs: Any, accuracy: float, **more: Any) -> Spread:
    made = propagate(m.model_of(function), inputs, accuracy=accuracy, shares=False, **more)
    return next(iter(made.spreads.values()))


def numbers(spread: Spread) -> np.ndarray:
    return np.array([*spread.interval, spread.median, spread.mean, spread.std])


def experiment(kind: str, problems: int, seed: int = 11) -> tuple[float, float, float, float]:
    """Shares held and met, and the median and 95 % time in ms."""
    function, maker, accuracy, _ = KINDS[kind]
    rng = np.random.default_rng(seed)
    held, met, times = [], [], []
    for _ in range(problems):
        inputs = maker(rng)
        start = time.perf_counter()
        spread = answer(function, inputs, accuracy)
        times.append(time.perf_counter() - start)
        fine = answer(function, inputs, 0.02 * accuracy, seed=99, samples=20_000_000)
        if fine.estimate > 0.3 * accuracy:
            continue
        error = float(np.abs(numbers(spread) - numbers(fine)).max()) / fine.std
        held.append(error <= spread.estimate + 1e-13)
        met.append(error <= accuracy)
    low, high = np.percentile(times, [50, 95]) * 1e3
    return float(np.mean(held)), float(np.mean(met)), float(low), float(high)


def main() -> None:
    wanted = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    print(f"{'problems':18} {'count':>6} {'asked':>8} {'held':>7} {'met':>7} {'ms':>8} {'95 %':>8}")
    for kind, (_, _, accuracy, cost) in KINDS.items():
        count = max(wanted // cost, 10)
        held, met, low, high = experiment(kind, count)
        print(f"{kind:18} {count:6} {accuracy:8.0e} {held:7.1%} {met:7.1%} {low:8.2f} {high:8.2f}", flush=True)


if __name__ == "__main__":
    main()
