"""Writes tests/pendulum/pendulum.json and tests/particle/particle.json, to 25 digits and more.

Other formulas than the program's: periods by mpmath's elliptic integrals, states and flights with drag by its Taylor
integration of the equations of motion, best angles by root finding on the derivative, tubes by their closed forms at 60
digits.

Run: python tests/references/generate_integrated_motions.py [FOLDER]. The same bytes every time.
"""

import json
import sys
from pathlib import Path

from mpmath import acos, atan, cos, cosh, ellipk, findroot, mp, mpf, nstr, odefun, pi, sin, sinh, sqrt, tan

mp.dps = 50
TESTS = Path(__file__).resolve().parents[1]
G = mpf("9.80665")
DEGREE = pi / 180


def text(value):
    return nstr(value, 25, min_fixed=1, max_fixed=0)


def pendulums():
    slow = {}
    for degrees in ("10", "90", "179", "179.999"):
        slow[degrees] = text(2 * ellipk(sin(mpf(degrees) * DEGREE / 2) ** 2) / pi)
    near_top = {}
    for degrees in ("1e-7", "1e-11", "0.001"):
        complement = sin(mpf(degrees) * DEGREE / 2) ** 2
        with mp.workdps(80):
            near_top[degrees] = text(2 * ellipk(1 - complement) / pi)
    whirl = mpf("6.5")
    # a turn: 2∫dθ/ω from 0 to π with ω² = ω_b² − 4g/L·sin²(θ/2)
    turn = 4 / whirl * ellipk(4 * G / whirl**2)
    with mp.workdps(30):
        state = odefun(lambda _, y: [y[1], -G * sin(y[0])], 0, [mpf(2), mpf(0)])(mpf("1.5"))
        around = odefun(lambda _, y: [y[1], -G * sin(y[0])], 0, [mpf(0), whirl])(mpf("2.7"))
    rod_length, mass, start, at = mpf("1.2"), mpf(2), 60 * DEGREE, 20 * DEGREE
    small = 2 * pi * sqrt(2 * rod_length / (3 * G))
    gyration = rod_length / sqrt(mpf(12))
    return {
        "slowdown": slow,
        "near_top": near_top,
        "whirl": text(turn),
        "state": [text(value) for value in state],
        "around": [text(value) for value in around],
        "rod": {
            "small": text(small),
            "period": text(small * 2 * ellipk(sin(start / 2) ** 2) / pi),
            "least": text(2 * pi * sqrt((gyration**2 + gyration**2) / (G * gyration))),
            "along": text(mass * G * (5 * cos(at) - 3 * cos(start)) / 2),
            "across": text(mass * G * sin(at) / 4),
        },
        "cone": {
            "disturbance": text(sqrt(1 + 3 * cos(40 * DEGREE) ** 2)),
            "angle": text(acos(G / mpf("2.5") ** 2 / 2)),
        },
        "damped": damped(),
    }


def damped():
    """The first turning points of θ̈ + 2ζω₀θ̇ + β|θ̇|θ̇ + ω₀²·sin θ = 0 from 60 degrees, L = 1."""
    own = sqrt(G)
    out = {}
    for name, zeta, beta in (("linear", mpf("0.05"), mpf(0)), ("quadratic", mpf(0), mpf("0.1"))):
        with mp.workdps(25):

            def motion(_, y, zeta=zeta, beta=beta):
                # on the first half swing the rate is negative
                return [y[1], -2 * zeta * own * y[1] + beta * y[1] * y[1] - own**2 * sin(y[0])]

            path = odefun(motion, 0, [60 * DEGREE, mpf(0)])
            time = findroot(lambda t, path=path: path(t)[1], mpf("1.05"), tol=1e-36, verify=False)
            out[name] = [text(time), text(-path(time)[0])]
    return out


def flight(speed, degrees, drop, force):
    """Time, distance, speed and angle at the landing, by Taylor integration."""
    with mp.workdps(25):
        angle = mpf(degrees) * DEGREE

        def motion(_, y):
            ax, ay = force(y[2], y[3])
            return [y[2], y[3], ax, ay - G]

        path = odefun(motion, 0, [mpf(0), mpf(0), mpf(speed) * cos(angle), mpf(speed) * sin(angle)])
        guess = 2 * mpf(speed) * sin(angle) / G * mpf("0.8")
        time = findroot(lambda t: path(t)[1] + mpf(drop), guess, tol=1e-38, verify=False)
        end = path(time)
        return [text(time), text(end[0]), text(sqrt(end[2] ** 2 + end[3] ** 2)), text(atan(-end[3] / end[2]))]


def particles():
    tau = mpf(3)

    def square(terminal, wind=0):
        def force(vx, vy):
            through = vx - wind
            pull = G * sqrt(through**2 + vy**2) / mpf(terminal) ** 2
            return -pull * through, -pull * vy

        return force

    v, x, y = mpf(30), mpf(80), mpf(5)
    low, high = (
        findroot(lambda a, s=s: x * tan(a) - G * x**2 / (2 * v**2 * cos(a) ** 2) - y, s) for s in (mpf("0.63"), mpf(1))
    )
    u = mpf("1e-4")
    stiff = mpf(40) / mpf("0.5") - (2 * pi) ** 2
    with mp.workdps(30):
        turning = 2 * pi
        spring = odefun(
            lambda t, s: [s[1], -stiff * s[0] + mpf(80) * mpf("0.2") - G * sin(turning * t)], 0, [mpf("0.2"), mpf(0)]
        )(mpf("0.7"))
    return {
        "drop": flight(30, 45, 2, lambda vx, vy: (mpf(0), mpf(0))),
        "linear": flight(30, 45, 0, lambda vx, vy: (-vx / tau, -vy / tau)),
        "quadratic": flight(30, 45, 0, square(25)),
        "steep": flight(50, 35, 1, square(40)),
        "wind": flight(30, 45, 0, square(25, mpf(-6))),
        "fast": flight(200, 45, 0, square(40)),
        "target": [text(low), text(high)],
        "tube": text(mpf("0.1") * cosh(u) + G / (2 * u**2) * (sin(u) - sinh(u))),
        "spring": [text(value) for value in spring],
        "hoop": [text(acos(G / (mpf("0.25") * 64))), text(8 * sqrt(1 - (G / 16) ** 2))],
    }


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else TESTS
    for name, made in (("pendulum", pendulums), ("particle", particles)):
        target = folder / name / f"{name}.json" if len(sys.argv) < 2 else folder / f"{name}.json"
        target.write_text(json.dumps(made(), indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
