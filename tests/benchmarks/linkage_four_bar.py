"""Four-bars: position, velocity and acceleration of many poses against `np.sin` of as many numbers, in one run.

Run: python tests/benchmarks/linkage_four_bar.py
"""

import time

import numpy as np

from dynamics_cli.linkage.fourbar.closure import frame
from dynamics_cli.linkage.fourbar.four_bar import four_bar
from dynamics_cli.linkage.fourbar.table import poses

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


def solved(links: object, theta: object) -> tuple[object, ...]:
    """Vectors of coupler and rocker, ω and α of both for ω₂ = 10 and α₂ = 5."""
    loop, ratios = poses(links, theta, 1.0)  # type: ignore[arg-type]
    return (
        loop,
        10.0 * ratios[0],
        10.0 * ratios[1],
        5.0 * ratios[0] + 100.0 * ratios[2],
        (5.0 * ratios[1] + 100.0 * ratios[3]),
    )


if __name__ == "__main__":
    theta = np.linspace(0.0, 2.0 * np.pi, POSES, endpoint=False)
    links = frame(0.04, 0.12, 0.08, 0.1)
    sine = best(np.sin, theta)
    all_of_it = best(solved, links, theta)
    alone = best(lambda: four_bar(crank=0.04, coupler=0.12, rocker=0.08, ground=0.1, crank_angle=0.7, speed=10.0))
    print(f"np.sin of {POSES} numbers: {1e9 * sine / POSES:.1f} ns each")
    print(f"position, velocity, acceleration: {1e9 * all_of_it / POSES:.1f} ns a pose, {all_of_it / sine:.1f} × np.sin")
    print(f"one call: {1e6 * alone:.0f} µs")
    print("kept" if all_of_it <= MOST * sine else f"slower than {MOST} × np.sin")
