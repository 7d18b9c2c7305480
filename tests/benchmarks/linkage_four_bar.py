"""Four-bars: position, velocity and acceleration of many poses against `np.sin` of as many numbers, in one run.

Run: python tests/benchmarks/linkage_four_bar.py
"""

import time
from typing import Any

import numpy as np

from dynamics_cli.linkage.fourbar.closure import close, frame, ratios
from dynamics_cli.linkage.fourbar.four_bar import four_bar

POSES, RUNS = 2048, 300
MOST = 10.0


def best(function: object, *arguments: object) -> float:
    """The shortest of many runs, in seconds."""
    times = []
    for _ in range(RUNS):
        start = time.perf_counter()
        function(*arguments)  # type: ignore[operator]
        times.append(time.perf_counter() - start)
    return min(times)


def poses(links: Any, theta: Any, side: float) -> tuple[Any, Any]:
    """The loop, and the speed ratios with their derivatives, at many crank angles: two sines each."""
    cosine, sine = np.cos(0.5 * theta), np.sin(0.5 * theta)
    turn = (cosine - sine) * (cosine + sine), 2.0 * (sine * cosine)
    loop = close(links, turn, (cosine, sine), side)
    return loop, ratios(links, loop)


def solved(links: Any, theta: Any) -> tuple[object, ...]:
    """Vectors of coupler and rocker, ω and α of both for ω₂ = 10 and α₂ = 5."""
    loop, (coupler, rocker, coupler_change, rocker_change) = poses(links, theta, 1.0)
    bends = 5.0 * coupler + 100.0 * coupler_change, 5.0 * rocker + 100.0 * rocker_change
    return loop, 10.0 * coupler, 10.0 * rocker, *bends


if __name__ == "__main__":
    theta = np.linspace(0.0, 2.0 * np.pi, POSES, endpoint=False)
    links = frame(0.04, 0.12, 0.08, 0.1)
    sine = best(np.sin, theta)
    all_of_it = best(solved, links, theta)
    public = best(
        lambda: four_bar(crank=0.04, coupler=0.12, rocker=0.08, ground=0.1, crank_angle=theta, speed=10.0)  # type: ignore[arg-type]
    )
    alone = best(lambda: four_bar(crank=0.04, coupler=0.12, rocker=0.08, ground=0.1, crank_angle=0.7, speed=10.0))
    print(f"np.sin of {POSES} numbers: {1e9 * sine / POSES:.1f} ns each")
    print(f"position, velocity, acceleration: {1e9 * all_of_it / POSES:.1f} ns a pose, {all_of_it / sine:.1f} × np.sin")
    print(f"the task itself, with both branches: {public / sine:.1f} × np.sin")
    print(f"one call: {1e6 * alone:.0f} µs")
    print("kept" if all_of_it <= MOST * sine else f"slower than {MOST} × np.sin")
