"""Shapes and assemblies, time against error: ours beside what a textbook program does.

Run: python tests/benchmarks/inertia_bodies.py.

The textbook: numpy, moments about the origin summed over the parts, shifted to the mass centre at the end, `eigvalsh`
of the inertia tensor; hollow shapes as the difference of two solids. Errors are the greatest relative ones of the three
principal moments, against exact rationals and 60 digits; times are the best of several runs, in one run of this script.
"""

import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import numpy as np
from mpmath import cos, eigsy, matrix, mp, mpf, sin, sqrt

from dynamics_cli.inertia.assembly.assembly import Assembly, body, compose_scene
from dynamics_cli.inertia.assembly.parts import Part, each_number
from dynamics_cli.inertia.bodies.amount import OfDensity, OfMass
from dynamics_cli.inertia.shapes import Block, HollowSphere
from dynamics_cli.inertia.shapes.sizes import Radius, Thickness
from dynamics_cli.inertia.shapes.task import shape
from dynamics_cli.numerics.orientation.rotations import AxisAngle
from dynamics_cli.numerics.tracked import Tracked

mp.dps = 60
AXIS, ANGLE = (0.3, -0.5, 0.8), 1.1


def best(call: Callable[[], Any], least: float = 0.1) -> float:
    """Microseconds of the fastest of several calls."""
    fastest, spent = float("inf"), 0.0
    while spent < least:
        start = time.perf_counter()
        call()
        took = time.perf_counter() - start
        fastest, spent = min(fastest, took), spent + took
    return 1e6 * fastest


def rotation() -> Any:
    x = [mpf(part) for part in AXIS]
    n = sqrt(sum(part * part for part in x))
    x = [part / n for part in x]
    c, s = cos(mpf(ANGLE)), sin(mpf(ANGLE))
    cross = matrix([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]])
    return mp.eye(3) + s * cross + (1 - c) * cross * cross


def tracked(tree: Any) -> Any:
    """As the program calls it: with bounds."""
    return each_number(tree, lambda x: Tracked(x, 0.0, ()))


ROTATION = np.array([[float(x) for x in row] for row in rotation().tolist()])


def blocks(count: int, sides: tuple[float, float, float], at: float) -> list[tuple[float, Any, Any]]:
    return [(1.0 + 0.25 * k, sides, (at + 0.5 * k, 0.25 * k * k + at, at - 0.125 * k)) for k in range(count)]


def exact(parts: list[Any], turned: bool) -> list[Any]:
    """Principal moments by the parallel axis theorem at 60 digits."""
    r = rotation() if turned else mp.eye(3)
    total, first, second = mpf(0), matrix([0, 0, 0]), matrix(3, 3)
    for mass, sides, place in parts:
        c = matrix([mpf(x) for x in place])
        own = mp.diag([mpf(side) * mpf(side) / 12 for side in sides])
        total += mpf(mass)
        first += mpf(mass) * c
        second += mpf(mass) * (r * own * r.T + c * c.T)
    centre = first / total
    values = sorted(eigsy(second - total * centre * centre.T, eigvals_only=True), reverse=True)
    return [sum(values) - value for value in values]


def textbook(parts: list[Any], turned: bool) -> Any:
    """Moments about the origin, shifted once, eigenvalues of the tensor."""
    one = np.eye(3)
    r = ROTATION if turned else one
    total, first, tensor = 0.0, np.zeros(3), np.zeros((3, 3))
    for mass, (a, b, c), place in parts:
        own = mass / 12.0 * np.diag([b * b + c * c, c * c + a * a, a * a + b * b])
        p = np.array(place)
        total += mass
        first += mass * p
        tensor += r @ own @ r.T + mass * (p @ p * one - np.outer(p, p))
    centre = first / total
    return np.linalg.eigvalsh(tensor - total * (centre @ centre * one - np.outer(centre, centre)))


def scene(parts: list[Any], turned: bool) -> Assembly:
    turn = AxisAngle(AXIS, ANGLE) if turned else None
    return Assembly(
        parts=tuple(Part(shape=Block(*sides), amount=OfMass(m), position=p, turn=turn) for m, sides, p in parts)
    )


def worst(found: Any, want: list[Any]) -> float:
    return max(float(abs(mpf(float(x)) - y) / y) for x, y in zip(found, want, strict=True))


def assemblies() -> None:
    print("assemblies: greatest relative error of a principal moment, stated bound, microseconds")
    print(f"{'case':38}{'textbook':>11}{'us':>8}{'ours':>11}{'bound':>11}{'us':>8}")
    cube, needle, plate = (0.25, 0.5, 0.75), (1.0, 2e-6, 1e-6), (1.0, 0.7, 1e-6)
    cases: list[tuple[str, list[Any], bool]] = [
        (f"{n} blocks at {at:g} sizes", blocks(n, cube, at), False) for n, at in ((4, 0), (4, 1e3), (4, 1e5), (4, 1e8))
    ]
    cases += [("4 blocks, turned", blocks(4, cube, 0.0), True), ("100 blocks", blocks(100, cube, 0.0), False)]
    cases += [
        ("needle 1e6 turned", blocks(1, needle, 0.0), True),
        ("needle 1e6 turned, at 10", blocks(1, needle, 10.0), True),
    ]
    cases += [("plate 1e6 turned, at 1e3", blocks(1, plate, 1e3), True)]
    for name, parts, turned in cases:
        want = exact(parts, turned)
        assembly = scene(parts, turned)
        p = body(assembly).principal_moments
        given = tracked(assembly)
        moments = compose_scene(given).spread.moments
        bound = max(m.error / m.value for m in moments)  # type: ignore[attr-defined]
        naive, took = worst(textbook(parts, turned), want), best(lambda p=parts, t=turned: textbook(p, t))
        ours, own = worst((p.first, p.second, p.third), want), best(lambda a=given: body(a))
        print(f"{name:38}{naive:11.1e}{took:8.0f}{ours:11.1e}{bound:11.1e}{own:8.0f}")


def walls() -> None:
    print("\nhollow ball: relative error of its moment; ball less ball, and by the wall's thickness")
    print(f"{'t/R':>10}{'difference':>12}{'ours':>12}")
    for exponent in (2, 4, 6, 8, 10, 12):
        t = 10.0**-exponent
        outer, inner = mpf(1), mpf(1) - mpf(t)
        rho = mpf(7850)
        want = mpf(8) / 15 * mp.pi * rho * (outer**5 - inner**5)
        r = 1.0 - t
        naive = 8.0 / 15.0 * np.pi * 7850.0 * (1.0 - r**5)
        ours = shape(HollowSphere(Radius(1.0), Thickness(t)), amount=OfDensity(7850.0)).moments.zz
        print(f"{t:10.0e}{float(abs(naive - want) / want):12.1e}{float(abs(ours - want) / want):12.1e}")


if __name__ == "__main__":
    assemblies()
    walls()
