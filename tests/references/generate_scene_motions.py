"""Writes tests/motion/scenes.json: motions and places of rest of planar scenes, by other ways than the program's.

One coordinate and its energies in place of bodies with joints: a four-bar let go (integrated at 40 digits by Gragg's
midpoint rule with extrapolation, after its reduced inertia), a slider-crank at constant speed (accelerations as
derivatives of positions, forces part by part), a tube that turns, an oscillator, a torque that falls with the speed
(closed forms), a tailgate on its strut (roots of the derivative of its energy), a cart with a hanging rod.

Run: python tests/references/generate_scene_motions.py [FILE]. The same bytes every time.
"""

import json
import sys
from itertools import pairwise
from pathlib import Path

from generate_chain_motions import integrated
from mpmath import atan2, cos, cosh, diff, exp, expj, findroot, hypot, im, mp, mpc, mpf, nstr, pi, re, sin, sinh, sqrt

mp.dps = 40
TARGET = Path(__file__).resolve().parents[1] / "motion" / "scenes.json"
DEGREE = pi / 180
G, STANDARD = mpf("9.81"), mpf("9.80665")


def text(value):
    return nstr(value, 22, min_fixed=1, max_fixed=0)


class FourBar:
    """A at the origin, D at 1; crank 1 kg, coupler 2 kg, rocker 1.5 kg, uniform thin rods; the branch of the start."""

    a, b, c = hypot(mpf("0.3"), mpf("0.4")), hypot(mpf("0.9"), mpf("0.3")), hypot(mpf("0.2"), mpf("0.7"))

    def angles(self, theta):
        joint = self.a * expj(theta)
        way = 1 - joint
        far = abs(way)
        along = (self.b**2 - self.c**2 + far**2) / (2 * far)
        place = joint + way / far * mpc(along, sqrt(self.b**2 - along**2))
        return atan2(im(place - joint), re(place - joint)), atan2(im(place), re(place) - 1)

    def slopes(self, theta):
        phi, psi = self.angles(theta)
        return (
            self.a * sin(psi - theta) / (self.b * sin(phi - psi)),
            self.a * sin(theta - phi) / (self.c * sin(psi - phi)),
        )

    def inertia(self, theta):
        phi, _ = self.angles(theta)
        turn, swing = self.slopes(theta)
        middle = abs(self.a * expj(theta) + self.b / 2 * turn * expj(phi)) ** 2
        return self.a**2 / 3 + 2 * (middle + self.b**2 * turn**2 / 12) + mpf("1.5") * self.c**2 * swing**2 / 3

    def height(self, theta):
        phi, psi = self.angles(theta)
        return (
            self.a / 2 * sin(theta) + 2 * (self.a * sin(theta) + self.b / 2 * sin(phi))
            + mpf("1.5") * self.c / 2 * sin(psi)
        )  # fmt: skip

    def rate(self, y):
        theta, speed = y
        bend, fall = diff(self.inertia, theta), diff(self.height, theta)
        return [speed, -(bend * speed**2 / 2 + G * fall) / self.inertia(theta)]

    def state(self, y):
        theta, speed = y
        phi, psi = self.angles(theta)
        turn, swing = self.slopes(theta)
        assert abs(diff(lambda x: self.angles(x)[0], theta) - turn) < mpf("1e-15")
        assert abs(diff(lambda x: self.angles(x)[1], theta) - swing) < mpf("1e-15")
        return [theta, phi, psi, speed, turn * speed, swing * speed]


def slider_crank(time):
    """Crank 40 mm at 100 rad/s from 30°, rod 150 mm of 0.5 kg, piston 0.4 kg: torque, side force, pin forces."""
    r, length, rod, piston, speed = mpf("0.04"), mpf("0.15"), mpf("0.5"), mpf("0.4"), mpf(100)

    def theta(t):
        return 30 * DEGREE + speed * t

    def phi(t):
        return -mp.asin(r * sin(theta(t)) / length)

    def crosshead(t):
        return r * cos(theta(t)) + length * cos(phi(t))

    def middle(k):
        return lambda t: (r * expj(theta(t)) + length / 2 * expj(phi(t))).real if k == 0 else (
            r * expj(theta(t)) + length / 2 * expj(phi(t))).imag  # fmt: skip

    along = piston * diff(crosshead, time, 2)
    mx, my = rod * diff(middle(0), time, 2), rod * (diff(middle(1), time, 2) + STANDARD)
    couple = rod * length**2 / 12 * diff(phi, time, 2)
    # force of the rod on the piston: along x as it accelerates; across from the rod's moments about its centre
    c, s = cos(phi(time)), sin(phi(time))
    bx = along
    # rod: A + (−B) = m·a; moments about the centre, A at −length/2, −B at +length/2
    # couple = −length/2·(c·ay − s·ax) + length/2·(c·(−by) − s·(−bx)), ax = mx + bx, ay = my + by
    by = (-couple - length / 2 * (c * my - s * (mx + bx)) + length / 2 * s * bx) / (length * c)
    ax, ay = mx + bx, my + by
    side = piston * STANDARD - by
    at = r * expj(theta(time))
    torque = at.real * ay - at.imag * ax
    return {"torque": torque, "side": side, "A": hypot(ax, ay), "B": hypot(bx, by)}


def tailgate():
    """Roots of the derivative of its energy, from −180° to 180°; at the stable open place s² + 2δ·s + ω²."""
    mass, moment, stiffness, free, damping = mpf(25), mpf("2.6"), mpf(500), mpf("1.6"), mpf(1200)
    centre, strut, foot = mpc("0.48", "-0.03"), mpc("0.3", "-0.04"), mpc("0.05", "-0.45")

    def length(q):
        return abs(strut * expj(q) - foot)

    def energy(q):
        return mass * STANDARD * im(centre * expj(q)) + stiffness * (length(q) - free) ** 2 / 2

    def slope(q):
        return diff(energy, q)

    turns = [k * DEGREE for k in range(-180, 181)]
    pairs = [pair for pair in pairwise(turns) if slope(pair[0]) * slope(pair[1]) < 0]
    roots = [findroot(slope, pair, solver="anderson") for pair in pairs]
    stable = [q for q in roots if diff(energy, q, 2) > 0]
    opened = next(q for q in stable if 0 < q < pi / 2)
    inertia = moment + mass * abs(centre) ** 2
    return {
        "roots": roots, "stable": stable,
        "square": diff(energy, opened, 2) / inertia, "damping": damping * diff(length, opened) ** 2 / inertia,
        "pull": stiffness * (length(opened) - free),
    }  # fmt: skip


def cart():
    """2 kg on 50 N/m, a rod of 1 kg and 0.8 m hanging on it: ω from (3, 0.4; 0.4, 0.64/3), (50, 0; 0, 0.4·g)."""
    m = mp.matrix([[3, mpf("0.4")], [mpf("0.4"), mpf("0.64") / 3]])
    k = mp.matrix([[50, 0], [0, mpf("0.4") * STANDARD]])
    values = mp.eig(m**-1 * k, left=False, right=False)
    return sorted(sqrt(re(value)) for value in values)


def main():
    bar = FourBar()
    start = [atan2(mpf("0.4"), mpf("0.3")), mpf(0)]
    four = bar.state(integrated(bar.rate, start, mpf("0.5"), mpf(1) / 64))
    spin = mpf(8)
    u = spin * mpf("0.3")
    swing = 2 * (cosh(u) / 10) / 2 + STANDARD / (2 * spin**2) * (sin(u) - sinh(u))
    # 2 kg, 50 N/m, 4 N·s/m from 0.1 m and −0.2 m/s, after 0.7 s
    t, decay, square = mpf("0.7"), mpf(1), mpf(25) - 1
    w = sqrt(square)
    oscillator = exp(-decay * t) * (mpf("0.1") * cos(w * t) + (mpf("-0.2") + decay * mpf("0.1")) / w * sin(w * t))
    found = {
        "four-bar, 0.5 s": [text(x) for x in four],
        "slider-crank, 0.013 s": {name: text(x) for name, x in slider_crank(mpf("0.013")).items()},
        "tube, 0.3 s": text(swing),
        "oscillator, 0.7 s": text(oscillator),
        "torque 5 - 0.05 w on 0.01, 0.4 s": text(100 * (1 - exp(-mpf("0.4") * 5))),
        "tailgate": {
            name: [text(x) for x in value] if isinstance(value, list) else text(value)
            for name, value in tailgate().items()
        },
        "cart": [text(x) for x in cart()],
    }
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else TARGET
    target.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
