"""Cam motion: speed against error, beside PyPI `mechanism` where it has the feature.

    python tests/benchmarks/cam_motion.py

`pip install mechanism matplotlib` gives the peer's lines; without it they are left out. Times are the best of several
in one run; errors are against 40-digit values, in shares of each peak.
"""

import time
from collections.abc import Callable
from typing import Any

import numpy as np
from mpmath import cos, mp, mpf, pi, sin

from dynamics_cli.cam.forces.forces import force
from dynamics_cli.cam.forces.records import ArmOnTorsionSpring, Contact, Slide
from dynamics_cli.cam.geometry.followers import OscillatingRoller
from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.normalised import law_named
from dynamics_cli.cam.laws.peaks import extremes
from dynamics_cli.cam.laws.rise import rise
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.cam.program.revolution import motion

LINE = "rise 20 mm in 90 deg cycloidal; dwell 90 deg; return in 90 deg cycloidal; dwell"
SWING = "rise 15 deg in 120 deg 3-4-5; dwell 60 deg; return in 120 deg modified-sine; dwell"
NOTHING = Program()


def best(function: Callable[[], Any], times: int = 25) -> float:
    """Least seconds of one call."""
    least = float("inf")
    for _ in range(times):
        start = time.perf_counter()
        function()
        least = min(least, time.perf_counter() - start)
    return least


def designs() -> None:
    print("what one call computes                                        ms")
    calls = {
        "motion from its line": lambda: motion_of(NOTHING, LINE),
        "whole `cam motion` (extremes, joints, rms, 361 points)": lambda: motion(NOTHING, program=LINE, count=361),
        "whole `cam force`": lambda: force(NOTHING, program=LINE, shaft_speed=50.0, train=Slide(0.5, 5e3, 60.0)),
        "whole `cam force` of an arm, with contact force and stress": lambda: force(
            NOTHING,
            program=SWING,
            shaft_speed=50.0,
            train=ArmOnTorsionSpring(0.002, 10.0, 2.0),
            follower=OscillatingRoller(0.03, 0.008, 0.08, 0.1),
            contact=Contact(0.01),
        ),
        "whole `cam rise` at one angle": lambda: rise(law=LawName("cycloidal"), lift=0.02, span=1.5, at=(0.4,)),
    }
    for name, call in calls.items():
        print(f"  {name:58s} {1e3 * best(call):8.3f}")


def throughput() -> None:
    print("\ns, v, a, j of 1e6 sorted angles (rise, dwell, return, dwell)    ns/point   × np.sin")
    theta = np.linspace(0.0, 2.0 * np.pi, 1_000_000)
    sine = best(lambda: np.sin(theta), 7)
    for law in ("cycloidal", "3-4-5", "4-5-6-7", "modified-sine", "modified-trapezoid", "freudenstein-1-3-5"):
        found = motion_of(NOTHING, LINE.replace("cycloidal", law))
        spent = best(lambda found=found: found.at(theta), 7)  # type: ignore[misc]
        print(f"  {law:58s} {1e3 * spent:10.1f} {spent / sine:8.1f}")


def exact(theta: float) -> list[Any]:
    """The cycloidal rise of LINE to 40 digits."""
    mp.dps = 40
    span = pi / 2
    x = mpf(theta) / span
    h = mpf(0.02)
    return [
        h * (x - sin(2 * pi * x) / (2 * pi)),
        h / span * (1 - cos(2 * pi * x)),
        h / span**2 * 2 * pi * sin(2 * pi * x),
        h / span**3 * 4 * pi**2 * cos(2 * pi * x),
    ]


def beside_mechanism() -> None:
    try:
        from mechanism.cams import Cam
    except ImportError:
        print("\n`mechanism` is not installed: its lines are left out")
        return
    print("\nbeside mechanism: 1014 angles of one turn, cycloidal        time [µs]   worst errors of s, v, a, j / peak")
    moves = [("Rise", 0.02, 90), ("Dwell", 90), ("Fall", 0.02, 90), ("Dwell", 90)]
    theta = np.arange(0, 2 * np.pi, 0.0062)
    law = law_named("cycloidal")
    tops = [0.02 * max(abs(v) for _, v in extremes(law, k)) / (np.pi / 2) ** k for k in range(4)]
    inside = [i for i in range(1, 250, 7) if theta[i] < np.pi / 2]
    wanted = [exact(float(theta[i])) for i in inside]

    def ours() -> Any:
        return motion_of(NOTHING, LINE).at(theta)

    def theirs() -> Any:
        law = Cam(motion=moves, degrees=True, omega=1.0).cycloidal
        return law.S, law.V, law.A, law.J

    for name, call in (("dynamics", ours), ("mechanism", theirs)):
        values = call()
        worst = [
            max(float(abs(mpf(float(values[k][i])) - row[k])) for i, row in zip(inside, wanted, strict=True)) / tops[k]
            for k in range(4)
        ]
        print(f"  {name:58s} {1e6 * best(call):8.0f}   {'  '.join(f'{error:.1e}' for error in worst)}")


if __name__ == "__main__":
    designs()
    throughput()
    beside_mechanism()
