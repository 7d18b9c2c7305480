"""Writes tests/stability/stability.json: root counts, gains, delays and modes to 30 digits.

Nothing of the program's exact counting is used. Roots come from mpmath's simultaneous iteration at 120 digits, after
repeated factors were multiplied out; critical gains from Newton's method on p(iω) = 0 for its real and imaginary part;
delays from bisection on the same with the exponential; equilibria by Newton's method.

Run: python tests/references/generate_stability_references.py [FILE]. The same bytes every time.
"""

import json
import random
import sys
from pathlib import Path

from mpmath import cos, exp, findroot, im, mp, mpc, mpf, nstr, polyroots, polyval, re, sin, sqrt

mp.dps = 60
FILE = Path(__file__).resolve().parents[1] / "stability" / "stability.json"
HARD = {
    "1, 1, 3, 3, 3, 2, 1": "a zero pivot and roots ±i: the method of ε says four on the right, or two",
    "1, 1, 12, 22, 39, 59, 48, 38, 20": "a row of zeros",
    "1, 3, 10, 24, 48, 96, 128, 192, 128": "a row of zeros",
    "1, 1, -6, 0, 1, 1, -6": "a row of zeros",
    "1, 7, 6, 42, 8, 56": "two pairs on the axis",
    "1, 0, 2, 3": "a zero first column",
    "1, 0, 0, 0, 4": "roots at ±1 ± i",
}


def text(value):
    return nstr(value, 30, min_fixed=1, max_fixed=0) if abs(value) > mpf("1e-40") else "0.0"


def expanded(factors):
    """Coefficients from the highest power down."""
    out = [mpf(1)]
    for factor in factors:
        made = [mpf(0)] * (len(out) + len(factor) - 1)
        for i, a in enumerate(out):
            for j, b in enumerate(factor):
                made[i + j] += a * b
        out = made
    return out


def by_side(coefficients):
    """Left, right, axis, by roots of 120 digits; repeated ones spread, and so the limit is wide."""
    with mp.workdps(160):
        roots = polyroots([mpf(c) for c in coefficients], maxsteps=4000, extraprec=4000)
        limit = mpf("1e-18")
        right = sum(re(root) > limit for root in roots)
        left = sum(re(root) < -limit for root in roots)
    return [int(left), int(right), len(roots) - int(left) - int(right)]


def counts():
    out = [{"polynomial": p, "counts": by_side(p.split(",")), "why": why} for p, why in HARD.items()]
    draw = random.Random(14)
    pieces = ["1, 0, 1", "1, 0, 3", "1, 1", "1, -2", "1, 2, 5", "1, -1, 4", "1, 0", "2, 3", "1, 0, 0, 0, 4"]
    for _ in range(40):
        chosen = [draw.choice(pieces) for _ in range(draw.randint(2, 5))]
        product = expanded([[mpf(c) for c in piece.split(",")] for piece in chosen])
        sides = [0, 0, 0]
        for piece in chosen:
            sides = [a + b for a, b in zip(sides, by_side(piece.split(",")), strict=True)]
        out.append(
            {
                "polynomial": ", ".join(str(int(c)) for c in product),
                "counts": sides,
                "why": "a product of factors whose roots are counted one by one",
            }
        )
    return out


def crossing(p, q, start):
    """ω and K with p(iω) + K·q(iω) = 0."""

    def parts(omega, gain):
        value = polyval(p, mpc(0, omega)) + gain * polyval(q, mpc(0, omega))
        return [re(value), im(value)]

    omega, gain = findroot(parts, start)
    return {"frequency": text(omega), "gain": text(gain)}


def gains():
    p = expanded([[1, 0], [1, 4], [1, 6], [1, mpf("1.4"), 1]])
    q = [mpf(1), mpf(2), mpf(4)]
    return [crossing(p, q, start) for start in ((1.2, 15.0), (2.1, 67.0), (3.7, 163.0))]


def delays():
    p, q = [mpf(1), mpf("0.4"), mpf(1)], [mpf("0.5")]

    def parts(omega, delay):
        value = polyval(p, mpc(0, omega)) + polyval(q, mpc(0, omega)) * exp(-mpc(0, omega) * delay)
        return [re(value), im(value)]

    out = []
    for start in ((1.1, 0.98), (0.78, 3.16), (1.1, 6.65), (0.78, 11.2)):
        omega, delay = findroot(parts, start)
        out.append({"frequency": text(omega), "delay": text(delay)})
    return out


def gyroscopic():
    """Roots of (s² − 1)(s² − 2) + (G·s)² = 0 for a G below and one above 1 + √2."""
    out = []
    for g in ("2.4", "2.42", "3"):
        found = polyroots([1, 0, mpf(g) ** 2 - 3, 0, 2], maxsteps=500, extraprec=400)
        out.append({"gyroscopic": g, "rightmost": text(max(re(root) for root in found))})
    return out


def equilibria():
    """A bead on a hoop that turns at w: V = −m·g·r·cos θ − m·r²·w²·sin²θ/2."""
    m, g, r, w = mpf("0.2"), mpf("9.81"), mpf("0.3"), mpf(8)
    angle = findroot(lambda x: g * sin(x) - r * w * w * sin(x) * cos(x), 1.0)
    curvature = m * g * r * cos(angle) - m * r * r * w * w * cos(2 * angle)
    return {
        "angle": text(angle),
        "frequency": text(sqrt(curvature / (m * r * r)) / (2 * mp.pi)),
        "growth": text(sqrt(-(m * g * r - m * r * r * w * w) / (m * r * r))),
    }


def flows():
    """Equilibria of rates by Newton's method, the eigenvalues of Jacobians derived by hand, rightmost first."""
    third, ten = mpf(8) / 3, mpf(10)
    c = sqrt(third * 27)
    lorenz = {
        "states": ["10*(y-x)", "x*(28-z)-y", "x*y-8/3*z"],
        "at": [c, c, mpf(27)], "jacobian": [[-ten, ten, 0], [1, -1, -c], [c, c, -third]],
    }  # fmt: skip
    angle = findroot(lambda x: sin(x) - x / 3, 2.2)
    pendulum = {
        "states": ["y", "3*sin(x) - x - 0.05*y"], "at": [angle, mpf(0)],
        "jacobian": [[0, 1], [3 * cos(angle) - 1, -mpf("0.05")]],
    }  # fmt: skip
    x = findroot(lambda x: x**2 * exp(-x) - mpf("0.3"), 3.0)
    reactor = {
        "states": ["x^2*exp(-x) - y", "y - 0.3 - 0.2*(y - 0.3)^2 + 0.1*(x^2*exp(-x) - y)"], "at": [x, mpf("0.3")],
        "jacobian": [[(2 * x - x * x) * exp(-x), -1], [(2 * x - x * x) * exp(-x) / 10, 1 - mpf("0.1")]],
    }  # fmt: skip
    out = []
    for case in (lorenz, pendulum, reactor):
        values = sorted(mp.eig(mp.matrix(case["jacobian"]), right=False), key=lambda z: (-re(z), im(z)))
        upper = [z for z in values if im(z) > -mpf("1e-40")]
        parts = [(re(z), im(z) if abs(im(z)) > mpf("1e-40") else mpf(0)) for z in upper]
        out.append({"states": case["states"], "at": [text(v) for v in case["at"]],
                    "roots": [[text(x), text(y)] for x, y in parts]})  # fmt: skip
    return out


def main():
    data = {
        "counts": counts(),
        "gains": gains(),
        "delays": delays(),
        "gyroscopic": gyroscopic(),
        "hoop": equilibria(),
        "flows": flows(),
    }
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else FILE
    target.write_text(json.dumps(data, indent=None, ensure_ascii=False).replace("}, ", "},\n") + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
