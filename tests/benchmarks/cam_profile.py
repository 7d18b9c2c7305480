"""Cam geometry: speed against error, beside PyPI `mechanism` where it has the feature.

    python tests/benchmarks/cam_profile.py

`pip install mechanism` gives the peer's lines; without it they are left out. Times are the best of several in one run.
"""

import time
from collections.abc import Callable
from typing import Any

import numpy as np

from dynamics_cli.cam.export.export import export
from dynamics_cli.cam.export.records import Form
from dynamics_cli.cam.forces.check import check
from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.contact import Geometry, curve
from dynamics_cli.cam.geometry.profile import profile
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.cam.sizing import records, size

CYCLE = "rise 10 mm in 90 deg modified-sine; dwell 90 deg; return in 90 deg cycloidal; dwell"
PEER = "rise 20 mm in 90 deg cycloidal; dwell 90 deg; return in 90 deg cycloidal; dwell"
NOTHING = Program()
ROLLER = followers.Roller(0.025, 0.006)


def best(function: Callable[[], Any], times: int = 15) -> float:
    """Least seconds of one call."""
    least = float("inf")
    for _ in range(times):
        start = time.perf_counter()
        function()
        least = min(least, time.perf_counter() - start)
    return least


def whole_design() -> None:
    print("whole design (one roller cam)")
    parts = {
        "motion from its line": lambda: motion_of(NOTHING, CYCLE),
        "profile, 3600 points, with extremes and plate": lambda: profile(
            NOTHING, program=CYCLE, follower=ROLLER, points=3600
        ),
        "verdicts": lambda: check(NOTHING, program=CYCLE, follower=ROLLER),
    }
    total = 0.0
    for name, part in parts.items():
        seconds = best(part)
        total += seconds
        print(f"  {name:<48s} {1e3 * seconds:8.2f} ms")
    print(f"  {'together':<48s} {1e3 * total:8.2f} ms")
    print(
        f"  {'smallest size, two limits':<48s} "
        f"{1e3 * best(lambda: size.size(NOTHING, program=CYCLE, follower=records.Roller(0.006))):8.2f} ms"
    )


def throughput() -> None:
    print("profile points a second (lift, contact, rotation; x and y)")
    motion, geometry = motion_of(NOTHING, CYCLE), Geometry(ROLLER)
    for count in (3600, 36_000, 360_000):
        theta = np.arange(count) * (2.0 * np.pi / count)
        seconds = best(lambda: curve(geometry, motion, theta), 30)  # noqa: B023
        sine = best(lambda: np.sin(theta), 30)  # noqa: B023
        print(f"  {count:>8d} points {count / seconds:12.3g} /s   {seconds / sine:6.1f} × numpy.sin")


def files() -> None:
    print("pieces and proved deviation of a file")
    for form, tolerance in (
        ("arcs", 1e-5),
        ("arcs", 1e-6),
        ("arcs", 1e-7),
        ("cubics", 1e-6),
        ("cubics", 1e-9),
        ("lines", 1e-6),
    ):
        made = export(NOTHING, program=CYCLE, follower=ROLLER, form=Form(form), tolerance=tolerance)
        seconds = best(lambda: export(NOTHING, program=CYCLE, follower=ROLLER, form=Form(form), tolerance=tolerance), 3)  # noqa: B023
        print(
            f"  {form:<7s} {tolerance:7.0e} m  {made.pieces:5d} pieces  "
            f"proved {made.deviation:.3g} m  {1e3 * seconds:7.1f} ms"
        )


def peer() -> None:
    try:
        import matplotlib as mpl

        mpl.use("Agg")
        from mechanism import Cam
    except ImportError:
        print("mechanism is not installed: its lines are left out")
        return
    print("beside mechanism (cycloidal 20 mm in 90 deg, base 50 mm, roller 10 mm)")
    count = 3600

    def theirs() -> Any:
        motion = [("Rise", 20, 90), ("Dwell", 90), ("Fall", 20, 90), ("Dwell", 90)]
        return Cam(motion=motion, degrees=True, h=2 * np.pi / count)

    seconds = best(theirs, 5)
    exact = best(lambda: motion_of(NOTHING, PEER).at(np.arange(count) * (2 * np.pi / count)))
    whole = best(lambda: profile(NOTHING, program=PEER, follower=followers.Roller(0.05, 0.01), points=count))
    print(
        f"  mechanism: motions at {count} angles {1e3 * seconds:.2f} ms; "
        f"here {1e3 * exact:.2f} ms, profile {1e3 * whole:.2f} ms"
    )
    lift, h = motion_of(NOTHING, PEER), 2 * np.pi / count
    theta = np.arange(count) * h
    # its own formula for a roller: the radius R_b + s along the cam's angle
    s = lift.at(theta, 0)[0]
    x, y = (0.05 + s) * np.sin(theta), (0.05 + s) * np.cos(theta)
    fine = np.arange(200_000) * (2 * np.pi / 200_000)
    ex, ey = curve(Geometry(followers.Roller(0.05, 0.01)), lift, fine)
    worst = max(float(np.sqrt(((ex - a) ** 2 + (ey - b) ** 2).min())) for a, b in zip(x[::9], y[::9], strict=True))
    print(f"  its radius R + s is {1e3 * worst:.3f} mm off the envelope; here within 1e-14 of the size")


if __name__ == "__main__":
    whole_design()
    throughput()
    files()
    peer()
