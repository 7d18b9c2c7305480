"""Speed and error of particle impacts: rates of one case and of arrays, and what differences of velocities cost.

    python tests/benchmarks/impact_particles.py [--count 200000]

The table of errors holds the program's formulas against those that subtract velocities or kinetic energies, on hard
cases, with 60-digit references. Peers run in the same table where they are installed (`uncertainties`).
"""

import argparse
import math
import time
from collections.abc import Callable

import numpy as np
from mpmath import mp, mpf

from dynamics_cli.impact.conventions import ByMass, Restituted
from dynamics_cli.impact.particles.central import Collinear, Struck, central
from dynamics_cli.impact.reconstruction.momentum import Vehicle, momentum
from dynamics_cli.numerics.tracked import Tracked

mp.dps = 60


def best(work: Callable[[], object], rounds: int = 5) -> float:
    """Seconds of the fastest of some rounds."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def crash(numbers: "list[object]") -> object:
    """Eight inputs of a momentum reconstruction: masses, speeds and headings after, headings before."""
    m1, m2, u1, u2, b1, b2, a1, a2 = numbers
    first, second = Vehicle(ByMass(m1), None, a1, u1, b1), Vehicle(ByMass(m2), None, a2, u2, b2)  # type: ignore[arg-type]
    return momentum(first=first, second=second)


def strike(numbers: "list[object]") -> object:
    m1, m2, v1, v2, e = numbers
    return central(
        first=Collinear(ByMass(m1), v1), second=Struck(ByMass(m2), v2), contact=Restituted(e)  # type: ignore[arg-type]
    )  # fmt: skip


CASES = {
    "momentum (8 inputs)": (crash, [1500.0, 1200.0, 8.0, 9.0, 0.70, 0.65, 0.0, 1.57]),
    "central (5 inputs)": (strike, [1500.0, 1200.0, 14.0, -3.0, 0.2]),
}


def rates(count: int) -> None:
    """Cases a second: one by one, tracked, and as arrays."""
    generator = np.random.default_rng(1)
    print(f"{'':22}{'one by one':>14}{'tracked':>14}{'arrays':>14}{'arrays/one':>12}")
    for name, (function, numbers) in CASES.items():
        columns = [number * (1.0 + 0.01 * generator.standard_normal(count)) for number in numbers]

        def singly(function: "Callable[..., object]" = function, numbers: "list[float]" = numbers) -> None:
            for _ in range(1000):
                function(numbers)

        def tracked(function: "Callable[..., object]" = function, numbers: "list[float]" = numbers) -> None:
            for _ in range(100):
                function(Tracked.inputs(numbers))

        one = 1000 / best(singly)
        own = 100 / best(tracked)
        many = count / best(lambda function=function, columns=columns: function(columns), 3)
        print(f"{name:22}{one:12.3g}/s{own:12.3g}/s{many:12.3g}/s{many / one:12.1f}")
    try:
        from uncertainties import ufloat, umath
    except ImportError:
        print("uncertainties is not installed: no peer")
        return
    inputs = [ufloat(number, abs(number) * 0.01 + 0.01) for number in CASES["momentum (8 inputs)"][1]]

    def peer() -> None:
        m1, m2, u1, u2, b1, b2, a1, a2 = inputs
        for _ in range(100):
            sine = umath.sin(a2 - a1)
            (m1 * u1 * umath.sin(a2 - b1) + m2 * u2 * umath.sin(a2 - b2)) / (m1 * sine)
            (m1 * u1 * umath.sin(b1 - a1) + m2 * u2 * umath.sin(b2 - a1)) / (m2 * sine)

    print(f"uncertainties, the two speeds of momentum alone: {100 / best(peer):.3g}/s")


HARD = (
    ("cars", 1500.0, 1200.0, 14.0, -3.0, 0.2),
    ("mass ratio 1e12", 1e12, 1.0, 20.0, 3.0, 0.3),
    ("mass ratio 1e16", 1e16, 1.0, 20.0, 3.0, 0.3),
    ("mass ratio 1e20", 1e20, 1.0, 20.0, 3.0, 0.3),
    ("closing 1e-6 at 40 m/s", 1000.0, 700.0, 40.0, 40.0 - 1e-6, 0.3),
    ("closing 1e-12 at 300 m/s", 1000.0, 700.0, 300.0, 300.0 - 1e-12, 0.3),
    ("e = 1 - 1e-15", 3.0, 2.0, 4.0, -1.0, 1.0 - 1e-15),
)


def naive(m1: float, m2: float, v1: float, v2: float, e: float) -> tuple[float, float]:
    """ΔV of the first and the energy lost, as differences."""
    w1 = (m1 * v1 + m2 * v2 - m2 * e * (v1 - v2)) / (m1 + m2)
    w2 = (m1 * v1 + m2 * v2 + m1 * e * (v1 - v2)) / (m1 + m2)
    before, after = 0.5 * m1 * v1 * v1 + 0.5 * m2 * v2 * v2, 0.5 * m1 * w1 * w1 + 0.5 * m2 * w2 * w2
    return w1 - v1, before - after


def errors() -> None:
    """Relative errors of ΔV and of the energy lost."""
    print(f"\n{'relative error':26}{'ΔV, impulse':>14}{'as difference':>15}{'loss, ½m_r…':>14}{'as difference':>15}")
    for name, *numbers in HARD:
        m1, m2, v1, v2, e = map(mpf, numbers)
        u, reduced = v1 - v2, m1 * m2 / (m1 + m2)
        exact = -(1 + e) * reduced * u / m1, reduced * (1 - e * e) * u * u / 2
        found = strike(list(numbers))
        own = found.first.delta_v, found.energy_lost  # type: ignore[attr-defined]
        alternative = naive(*numbers)
        shown = [float(abs((mpf(x) - y) / y)) for pair in zip(own, alternative, strict=True) for x, y in
                 zip(pair, [exact[0 if pair[0] == own[0] else 1]] * 2, strict=True)]  # fmt: skip
        print(f"{name:26}" + "".join(f"{x:{width}.1e}" for x, width in zip(shown, (14, 15, 14, 15), strict=True)))


def conditions() -> None:
    """What one degree of error in a heading does to the speed, beside the angle condition."""
    print(f"\n{'approach paths apart':26}{'condition':>12}{'v1 per degree':>16}{'verdict':>12}")
    for degrees in (90, 60, 30, 20, 15, 10, 5):
        numbers = [1500.0, 1200.0, 8.0, 9.0, math.radians(degrees) * 0.45, math.radians(degrees) * 0.42, 0.0,
                   math.radians(degrees)]  # fmt: skip
        try:
            tracked = crash(Tracked.inputs(numbers))
        except Exception as error:
            print(f"{degrees:>20} deg  {error}")
            continue
        speed = tracked.first.approach_speed  # type: ignore[attr-defined]
        change = math.radians(1.0) * math.hypot(*speed.slopes[4:])
        shown = f"{tracked.angle_condition.value:12.2f}{change:12.2f} m/s{tracked.verdict!s:>12}"  # type: ignore[attr-defined]
        print(f"{degrees:>20} deg  {shown}")


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=200_000)
    rates(parser.parse_args().count)
    errors()
    conditions()


if __name__ == "__main__":
    main()
