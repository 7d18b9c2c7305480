"""Equations of motion beside sympy.physics.mechanics: time and error of the accelerations of two rods and a block.

Run where sympy is installed: PYTHONPATH=. python tests/benchmarks/motion_equations.py; without it there is nothing to
compare with, and it says so.
"""

import importlib.util
import sys
import time
from collections.abc import Callable
from typing import Any

from mpmath import cos, matrix, mp, mpf, sin

from dynamics_cli.motion.equations.records import Body, Scene, Sliding, Turning
from dynamics_cli.motion.equations.task import equations
from dynamics_cli.records import Formula

mp.dps = 50
STATE = ((0.1, 0.5), (0.4, 2.0), (-0.9, 3.0))
GRAVITY = 9.80665
HEAVY, LIGHT = (2.0, 1.0, 1.0), (1e8, 1.0, 1e-8)
ROD = 1.0 / 12.0


def ours(masses: tuple[float, ...]) -> list[float]:
    """A block on a rail, with two rods of 1 m below it."""
    block, first, second = masses
    (x, v), (a, va), (b, vb) = STATE

    def at(across: str, up: str, angle: str = "") -> dict[str, Any]:
        made = {"x": Formula(across, 1.0, "m"), "y": Formula(up, 1.0, "m")}
        return made | ({"angle": Formula(angle, 1.0, "rad")} if angle else {})

    scene = Scene(
        (Sliding("x", x, v), Turning("a", a, va), Turning("b", b, vb)),
        (
            Body("block", block, **at("x", "0")),
            Body("first", first, inertia=first * ROD, **at("x + 0.5*sin(a)", "-0.5*cos(a)", "a")),
            Body("second", second, inertia=second * ROD, **at("x + sin(a) + 0.5*sin(b)", "-cos(a) - 0.5*cos(b)", "b")),
        ),
    )
    return [row.acceleration.value for row in equations(scene).equations]


def exact(masses: tuple[float, ...]) -> list[Any]:
    """By the equations of two rods on a block as written down by hand, to 50 digits."""
    m, m1, m2, g = (*map(mpf, masses), mpf(GRAVITY))
    _, (a, va), (b, vb) = [[mpf(x) for x in pair] for pair in STATE]
    i1, i2 = (mpf(mass * ROD) for mass in masses[1:])
    p, r = m1 / 2 + m2, m2 / 2
    mass = matrix([
        [m + m1 + m2, p * cos(a), r * cos(b)],
        [p * cos(a), m1 / 4 + m2 + i1, r * cos(a - b)],
        [r * cos(b), r * cos(a - b), m2 / 4 + i2],
    ])  # fmt: skip
    right = matrix([
        p * sin(a) * va**2 + r * sin(b) * vb**2,
        -r * sin(a - b) * vb**2 - g * p * sin(a),
        r * sin(a - b) * va**2 - g * r * sin(b),
    ])  # fmt: skip
    return list(mp.lu_solve(mass, right))


def theirs(masses: tuple[float, ...], method: str) -> tuple[Callable[[], list[float]], float]:
    """sympy's equations as a function of numbers, and the seconds that it took to make them."""
    from sympy import cos, lambdify, sin, symbols
    from sympy.physics import mechanics as me

    start = time.process_time()
    x, a, b = q = me.dynamicsymbols("x a b")
    u = me.dynamicsymbols("u v w")
    m, m1, m2, i1, i2, g = symbols("m m1 m2 i1 i2 g")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    rates = u if method == "kane" else [one.diff() for one in q]
    to_speeds = dict(zip([one.diff() for one in q], rates, strict=True))

    def body(name: str, mass: Any, inertia: Any, across: Any, up: Any, angle: Any) -> Any:
        point = origin.locatenew(name, across * frame.x + up * frame.y)
        moved = across.diff(me.dynamicsymbols._t) * frame.x + up.diff(me.dynamicsymbols._t) * frame.y
        point.set_vel(frame, moved.subs(to_speeds))
        turned = frame.orientnew(name, "Axis", [angle, frame.z])
        turned.set_ang_vel(frame, angle.diff(me.dynamicsymbols._t).subs(to_speeds) * frame.z)
        made = me.RigidBody(name, point, turned, mass, (me.inertia(turned, 0, 0, inertia), point))
        made.potential_energy = mass * g * up
        return made, (point, -mass * g * frame.y)

    slider = origin.locatenew("S", x * frame.x)
    slider.set_vel(frame, rates[0] * frame.x)
    pairs = [
        body("A", m1, i1, x + sin(a) / 2, -cos(a) / 2, a),
        body("B", m2, i2, x + sin(a) + sin(b) / 2, -cos(a) - cos(b) / 2, b),
    ]
    bodies = [me.Particle("block", slider, m), *(one for one, _ in pairs)]
    if method == "kane":
        made = me.KanesMethod(frame, list(q), list(u), [one - w.diff() for one, w in zip(u, q, strict=True)])
        made.kanes_equations(bodies, [load for _, load in pairs])
        matrix_, right = made.mass_matrix, made.forcing
    else:
        made = me.LagrangesMethod(me.Lagrangian(frame, *bodies), list(q))
        made.form_lagranges_equations()
        matrix_, right = made.mass_matrix, made.forcing
    function = lambdify([*q, *rates, m, m1, m2, i1, i2, g], [matrix_, right])
    seconds = time.process_time() - start
    import numpy as np

    numbers = [one for one, _ in STATE] + [one for _, one in STATE]
    numbers += [*masses, masses[1] * ROD, masses[2] * ROD, GRAVITY]

    def call() -> list[float]:
        mass, force = function(*numbers)
        return list(np.linalg.solve(mass, np.ravel(force)))

    return call, seconds


def per_call(call: Callable[[], Any], count: int = 50) -> float:
    """The least processor time of five rounds."""
    times = []
    for _ in range(5):
        start = time.process_time()
        for _ in range(count):
            call()
        times.append((time.process_time() - start) / count)
    return min(times)


def error(made: list[float], masses: tuple[float, ...]) -> float:
    return max(float(abs((x - y) / y)) for x, y in zip(made, exact(masses), strict=True))


def main() -> int:
    rows = [("dynamics motion equations", 0.0, per_call(lambda: ours(HEAVY)), error(ours(HEAVY), HEAVY),
             error(ours(LIGHT), LIGHT))]  # fmt: skip
    if importlib.util.find_spec("sympy") is None:
        print("sympy is not installed: nothing to compare with")
    else:
        for method in ("kane", "lagrange"):
            call, setup = theirs(HEAVY, method)
            graded = theirs(LIGHT, method)[0]
            rows.append((f"sympy.physics.mechanics, {method}", setup, per_call(call), error(call(), HEAVY),
                         error(graded(), LIGHT)))  # fmt: skip
    print("| method | to make the equations, s | one instant, ms | error | masses 1e8, 1, 1e-8 kg |")
    print("|---|---:|---:|---:|---:|")
    for name, setup, once, plain, hard in rows:
        print(f"| {name} | {setup:.2f} | {1e3 * once:.3f} | {plain:.0e} | {hard:.0e} |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
