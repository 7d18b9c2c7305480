"""Intervals of whole tasks with correlated inputs contain what they claim, counted in samples by other formulas.

    python tests/core/test_task_coverage.py [PROBLEMS]

prints the coverage over fresh random problems of momentum and of an involute.
"""

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import task_coverage
from harness import answer

DEG = np.pi / 180.0
SAMPLES = 400_000
# Four deviations of a share counted in so many samples.
ROOM = 4.0 * (0.95 * 0.05 / SAMPLES) ** 0.5


def draw(rng: np.random.Generator, means: list[float], stds: list[float], rho: float) -> Any:
    """Normal samples, the first two correlated."""
    z = rng.standard_normal((len(means), SAMPLES))
    z[1] = rho * z[0] + np.sqrt(1.0 - rho * rho) * z[1]
    return np.array(means)[:, None] + np.array(stds)[:, None] * z


def inside(result: dict[str, Any], values: Any) -> float:
    """The share of samples within the interval that a document states."""
    low, high = result["interval"]
    return float(np.mean((values >= low) & (values <= high)))


def momentum(rng: np.random.Generator) -> list[float]:
    """Shares of both speeds of a crash whose headings after are correlated."""
    rho = rng.uniform(-0.9, 0.9)
    means = [rng.uniform(25, 45), rng.uniform(40, 65), rng.uniform(7, 12), rng.uniform(7, 12), rng.uniform(1200, 2000)]
    stds = [rng.uniform(0.5, 2.5), rng.uniform(0.5, 2.5), 0.4, 0.4, 40.0]
    written = [f"{mean!r} ± {std!r}" for mean, std in zip(means, stds, strict=True)]
    document = answer(
        "impact", "momentum", "--first-mass", f"{written[4]} kg", "--second-mass", "1500 kg",
        "--first-approach-heading", "0 deg", "--second-approach-heading", "90 deg",
        "--first-exit-heading", f"{written[0]} deg", "--second-exit-heading", f"{written[1]} deg",
        "--first-exit-speed", f"{written[2]} m/s", "--second-exit-speed", f"{written[3]} m/s",
        "--correlate", f"first.exit_heading,second.exit_heading={rho!r}", "--units", "base",
    )  # fmt: skip
    one, two, first, second, mass = draw(rng, means, stds, rho)
    # momentum east and north
    east = first * np.cos(one * DEG) + 1500.0 / mass * second * np.cos(two * DEG)
    north = mass / 1500.0 * first * np.sin(one * DEG) + second * np.sin(two * DEG)
    results = document["results"]
    return [inside(results["first"]["approach_speed"], east), inside(results["second"]["approach_speed"], north)]


def involute(rng: np.random.Generator) -> list[float]:
    """Shares of the pressure angle at a diameter that is correlated with the base diameter."""
    rho = rng.uniform(-0.9, 0.9)
    base = rng.uniform(30, 60)
    means, stds = [base * rng.uniform(1.03, 1.3), base], [rng.uniform(0.05, 0.2), rng.uniform(0.05, 0.2)]
    written = [f"{mean!r} ± {std!r} mm" for mean, std in zip(means, stds, strict=True)]
    document = answer(
        "gear", "involute", "--diameter", written[0], "--base-diameter", written[1],
        "--correlate", f"diameter,base_diameter={rho!r}", "--units", "base",
    )  # fmt: skip
    diameter, base_diameter = draw(rng, means, stds, rho)
    angle = np.arctan(np.sqrt((diameter / base_diameter) ** 2 - 1.0))
    return [inside(document["results"]["pressure_angle"], angle)]


def test_intervals_hold_what_they_claim() -> None:
    rng = np.random.default_rng(15)
    for problem in (momentum, involute):
        for _ in range(3):
            assert all(abs(share - 0.95) <= ROOM + 1e-4 for share in problem(rng))


@pytest.mark.parametrize(
    ("kind", "problems"),
    [("momentum", 1), ("momentum near one line", 1), ("skid on an uncertain slope", 3), ("correlated skid", 2)],
)
def test_intervals_and_stated_errors_hold(kind: str, problems: int) -> None:
    """`task_coverage.py` runs many more; all of these hold, none only within the shares asked of many."""
    made = task_coverage.coverage(kind, problems, 15)
    assert made.refusals == []
    assert len(made.verdicts) == 2 * problems
    assert made.contain == 1.0
    assert made.held == len(made.told)
    assert made.told or kind == "momentum"


def main(problems: int) -> None:
    """Print what many problems give."""
    rng = np.random.default_rng(problems)
    for problem in (momentum, involute):
        shares = np.array([share for _ in range(problems) for share in problem(rng)])
        held = np.mean(np.abs(shares - 0.95) <= ROOM + 1e-4)
        print(
            f"{problem.__name__}: {shares.size} intervals, coverage {shares.min():.4f} to {shares.max():.4f}, ", end=""
        )
        print(f"mean {shares.mean():.5f}, {100 * held:.1f} % within the counting error")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
