"""Writes tests/vibration/motion.json: shocks, nonlinear oscillators, complex modes, motions of several masses,
to 20 digits.

Shocks by exponentials of the matrix of oscillator and load, extremes as zeros of the derivative; van der Pol by Taylor
series in 32 digits, other nonlinear periods by quadrature of the energy integral; complex modes as roots of the
characteristic polynomial; motions under loads by one exponential of system and load.

Run: python tests/references/generate_vibration_motion_references.py [FILE]. The same bytes every time.
"""

import json
import sys
from itertools import pairwise
from pathlib import Path
from typing import Any

from mpmath import cos, diag, diff, eigsy, expm, findroot, matrix, mp, mpf, nstr, pi, polyroots, quad, sin, sqrt, zeros

mp.dps = 32
FILE = Path(__file__).resolve().parents[1] / "vibration" / "motion.json"


def text(value: Any) -> str:
    return nstr(value, 20, min_fixed=1, max_fixed=0)


def generator(omega: Any, zeta: Any, wave: Any, load: list[Any]) -> Any:
    """State z, ż, and of the load: sine and cosine of `wave`·t, 1, t; the load is a combination of these four."""
    made = zeros(6, 6)
    made[0, 1] = 1
    made[1, 0], made[1, 1] = -omega * omega, -2 * zeta * omega
    for i, share in enumerate(load):
        made[1, 2 + i] = -share
    made[2, 3], made[3, 2], made[5, 4] = wave, -wave, 1
    return made


def pieces(shape: str, tau: Any) -> list[tuple[Any, Any, list[Any]]]:
    """Length, wave and load of each stretch of the pulse."""
    if shape == "half-sine":
        return [(tau, pi / tau, [1, 0, 0, 0])]
    if shape == "versed-sine":
        return [(tau, 2 * pi / tau, [0, mpf("-0.5"), mpf("0.5"), 0])]
    if shape == "sawtooth":
        return [(tau, mpf(1), [0, 0, 0, 1 / tau])]
    if shape == "triangle":
        return [(tau / 2, mpf(1), [0, 0, 0, 2 / tau]), (tau / 2, mpf(1), [0, 0, 1, -2 / tau])]
    return [(tau, mpf(1), [0, 0, 1, 0])]


def extremes(shape: str, tau: Any, hertz: Any, zeta: Any) -> dict[str, str]:
    """Largest absolute acceleration of each sign at any time, for a pulse of unit height."""
    omega = 2 * pi * hertz
    state, values = matrix([0, 0, 0, 1, 1, 0]), [mpf(0)]
    row = matrix([[-omega * omega, -2 * zeta * omega, 0, 0, 0, 0]])
    for length, wave, load in [*pieces(shape, tau), (mpf("1.2") / hertz, mpf(1), [0, 0, 0, 0])]:
        rate = generator(omega, zeta, wave, load)
        start = state.copy()
        start[2], start[3], start[4], start[5] = 0, 1, 1, 0
        hop = expm(rate * (length / 40))
        looks, here = [], start
        for i in range(41):
            looks.append((length * i / 40, (row * rate * here)[0]))
            here = hop * here
        for (low, f), (high, g) in pairwise(looks):
            if f * g < 0:
                at = findroot(lambda t, a=rate, x=start: (row * a * expm(a * t) * x)[0], (low, high),
                              solver="anderson", tol=mpf("1e-42"), maxsteps=40)  # fmt: skip
                values.append((row * expm(rate * at) * start)[0])
        state = expm(rate * length) * start
        values.append((row * state)[0])
    return {"positive": text(max(values)), "negative": text(min(values))}


def shocks() -> list[dict[str, Any]]:
    made = []
    for shape, hertz in (
        ("half-sine", 20), ("half-sine", 100), ("half-sine", 500), ("triangle", 80), ("versed-sine", 80),
        ("sawtooth", 60),
    ):  # fmt: skip
        made.append({"shape": shape, "frequency": float(hertz), "duration": 0.011, "damping_ratio": 0.05,
                     **extremes(shape, mpf(0.011), mpf(hertz), mpf(0.05))})  # fmt: skip
    return made


def undamped() -> dict[str, str]:
    """The undamped half-sine by its formula: the largest factor of all, and that at 2fτ = 7.3."""

    def factor(b: Any) -> Any:
        # during the pulse, extremes at x = 2n/(b + 1), b = 2fτ
        return max(abs((b * b * sin(pi * x) - b * sin(pi * b * x)) / (b * b - 1))
                   for x in (2 * n / (b + 1) for n in range(1, int((b + 1) / 2) + 1)))  # fmt: skip

    best = findroot(lambda b: diff(factor, b), mpf("1.62"))
    b = mpf("7.3")
    return {"largest": text(factor(best)), "at": text(best), "primary": text(factor(b)),
            "residual": text(abs(2 * b * cos(pi * b / 2) / (b * b - 1)))}  # fmt: skip


def taylor(mu: Any, x: Any, v: Any, h: Any, order: int = 26) -> list[list[Any]]:
    """Coefficients of displacement and velocity of van der Pol's equation about a state."""
    a, b = [x], [v]
    for n in range(order):
        square = [sum(a[i] * a[k - i] for i in range(k + 1)) for k in range(n + 1)]
        product = sum(square[i] * b[n - i] for i in range(n + 1))
        a.append(b[n] / (n + 1))
        b.append((mu * (b[n] - product) - a[n]) / (n + 1))
    return [a, b]


def at(series: list[Any], h: Any) -> Any:
    total = mpf(0)
    for coefficient in reversed(series):
        total = total * h + coefficient
    return total


def van_der_pol(mu: Any) -> dict[str, str]:
    """Half a cycle from rest by Taylor series; the start for which it ends at its mirror."""

    def half(start: Any) -> tuple[Any, Any]:
        x, v, time, step = start, mpf(0), mpf(0), mpf("0.1") / (1 + mu)
        while True:
            a, b = taylor(mu, x, v, step)
            ahead = at(b, step)
            if time > 0.5 and v < 0 <= ahead:
                h = findroot(lambda s, b=b: at(b, s), (mpf(0), step), solver="anderson", tol=mpf("1e-50"), maxsteps=80)
                return time + h, at(a, h)
            x, v, time = at(a, step), ahead, time + step

    start = findroot(lambda s: half(s)[1] + s, (mpf("2.0"), mpf("2.01")), solver="secant", tol=mpf("1e-44"))
    return {"period": text(2 * half(start)[0]), "amplitude": text(start)}


def periods() -> dict[str, Any]:
    """Frequencies by the energy integral, with the angle that smooths its ends."""

    def duffing(share: Any) -> Any:
        # x = sin φ: ω/ω₀ = (π/2)/∫dφ/√(1 + ½·ε·(1 + sin²φ))
        return pi / 2 / quad(lambda p: 1 / sqrt(1 + share * (1 + sin(p) ** 2) / 2), [0, pi / 4, pi / 2])

    def pendulum(turn: Any) -> Any:
        k = sin(turn / 2)
        return pi / 2 / quad(lambda p: 1 / sqrt(1 - (k * sin(p)) ** 2), [0, pi / 4, pi / 2])

    return {"duffing": {str(s): text(duffing(mpf(float(s)))) for s in ("0.1", "-0.1", "1000", "-0.5")},
            "pendulum": {str(d): text(pendulum(mpf(d) * pi / 180)) for d in (30, 90, 170)}}  # fmt: skip


def complex_modes() -> list[list[str]]:
    """Roots of det(λ²M + λC + K) of M = diag(2, 1), K = [[300, −100], [−100, 100]], C = diag(½, 0)."""
    # (2λ² + λ/2 + 300)(λ² + 100) − 10⁴
    roots = polyroots([2, mpf("0.5"), 500, 50, 20000], maxsteps=300, extraprec=200)
    return [[text(root.real), text(root.imag)] for root in sorted(roots, key=abs) if root.imag > 0]


def jumps() -> list[str]:
    """Ends of the middle branch: two equal amplitudes, by both equations at once."""
    zeta, alpha, force = mpf("0.02"), mpf("0.5"), mpf("0.2")

    def off(omega: Any, u: Any) -> list[Any]:
        p = 1 - omega**2 + 3 * alpha * u / 4
        q = 4 * zeta**2 * omega**2
        return [(p * p + q) * u - force**2, p * p + q + 3 * alpha * u * p / 2]

    found = [findroot(off, start, tol=mpf("1e-50"))[0] for start in ((mpf("1.21"), mpf("0.4")), (mpf("1.9"), mpf("7")))]
    return [text(omega) for omega in found]


# Masses, springs (the first to the wall), dampers beside them; a ratio for every mode instead of dampers.
SYSTEMS = {
    "undamped": ([1, 2, 3], [100, 200, 50], None, "0"),
    "one ratio": ([1, 2, 3], [100, 200, 50], None, "0.03"),
    "overdamped": ([2, 1], [50, 10], None, "1.4"),
    "proportional": ([2, 2], [100, 100], ["0.5", "0.5"], None),
    "coupled": ([1, 2, 3], [100, 200, 50], ["0.5", 0, 7], None),
    "free ends": ([1, 2], [80], [2], None),
    "soft": ([1, 1, 1], ["0.001", 10**8, 10**8], None, "0.01"),
}
# As linear equations of two states, the load is the first: sine, decaying sine, straight lines.
WAVE, FALL = mpf(9), mpf(3)
SAMPLES = [(0, 0), ("0.1", 5), ("0.3", -2), ("0.35", 4), ("0.8", 0)]


def system(name: str) -> tuple[Any, Any, Any]:
    """M, C and K."""
    masses, springs, dampers, ratio = SYSTEMS[name]
    n = len(masses)
    walls = [(i - 1, i) for i in range(n)] if len(springs) == n else [(i, i + 1) for i in range(n - 1)]

    def assembled(values: list[Any]) -> Any:
        made = zeros(n, n)
        for (i, j), value in zip(walls, values, strict=True):
            for a, b, sign in ((i, i, 1), (j, j, 1), (i, j, -1), (j, i, -1)):
                if a >= 0 and b >= 0:
                    made[a, b] += sign * mpf(value)
        return made

    mass, stiffness = diag([mpf(m) for m in masses]), assembled(springs)
    if dampers is not None:
        return mass, assembled(dampers), stiffness
    root = diag([sqrt(mpf(m)) for m in masses])
    values, vectors = eigsy(root**-1 * stiffness * root**-1)
    rates = diag([2 * mpf(ratio) * sqrt(abs(value)) for value in values])
    return mass, root * vectors * rates * vectors.T * root, stiffness


def histories() -> list[dict[str, Any]]:
    """Displacement and velocity of the last coordinate at the end, by one exponential of state and load together."""
    made = []
    for name in SYSTEMS:
        mass, damping, stiffness = system(name)
        n, end = mass.rows, mpf("0.8")
        inverse = mass**-1
        for kind in ("sine", "formula", "record"):
            for based in (False, True):
                push = -matrix([1] * n) if based else inverse * matrix([1] + [0] * (n - 1))
                laws = {"sine": [[0, -WAVE], [WAVE, 0]], "formula": [[-FALL, WAVE], [-WAVE, -FALL]],
                        "record": [[0, 1], [0, 0]]}  # fmt: skip
                whole = zeros(2 * n + 2, 2 * n + 2)
                for i in range(n):
                    whole[i, n + i] = 1
                whole[n : 2 * n, :n], whole[n : 2 * n, n : 2 * n] = -inverse * stiffness, -inverse * damping
                whole[n : 2 * n, 2 * n] = push
                whole[2 * n :, 2 * n :] = matrix(laws[kind])
                state = zeros(2 * n + 2, 1)
                steps = [(end, {"sine": (1, 0), "formula": (0, 1), "record": (0, 0)}[kind])]
                if kind == "record":
                    points = [(mpf(t), mpf(f)) for t, f in SAMPLES]
                    steps = [(b[0] - a[0], (a[1], (b[1] - a[1]) / (b[0] - a[0]))) for a, b in pairwise(points)]
                for length, load in steps:
                    state[2 * n], state[2 * n + 1] = load
                    state = expm(whole * length) * state
                made.append({
                    "system": name, "load": kind, "base": based, "displacement": text(state[n - 1]),
                    "velocity": text(state[2 * n - 1]),
                })  # fmt: skip
    return made


def moved_bases() -> list[dict[str, Any]]:
    """Where the base is moved by y(t): absolute coordinates, M·ẍ = −K·(x − y) − C·(ẋ − ẏ), by one exponential.

    All is at rest before; y is A·sin ωt, or B·e^{−at}·cos ωt, which jumps at the start.
    """
    made = []
    for name in ("one ratio", "coupled", "overdamped", "proportional", "free ends"):
        mass, damping, stiffness = system(name)
        n, end, one = mass.rows, mpf("0.8"), matrix([1] * mass.rows)
        inverse = mass**-1
        for kind, law, start in (
            ("sine", [[0, WAVE], [-WAVE, 0]], (0, 1)), ("jump", [[-FALL, WAVE], [-WAVE, -FALL]], (1, 0)),
        ):  # fmt: skip
            whole = zeros(2 * n + 2, 2 * n + 2)
            for i in range(n):
                whole[i, n + i] = 1
            whole[n : 2 * n, :n], whole[n : 2 * n, n : 2 * n] = -inverse * stiffness, -inverse * damping
            # forces of springs and dampers to the base: K·1·y + C·1·ẏ, ẏ = law · (y, its partner)
            for part, column in ((stiffness * one, (1, 0)), (damping * one, law[0])):
                for j in (0, 1):
                    whole[n : 2 * n, 2 * n + j] += inverse * part * column[j]
            whole[2 * n :, 2 * n :] = matrix(law)
            state = zeros(2 * n + 2, 1)
            state[2 * n], state[2 * n + 1] = start
            rate = expm(whole * end) * state
            speed = whole * rate
            # the damper's force of the jump itself is an impulse: it adds C·1·y(0) to the momenta
            kick = zeros(2 * n + 2, 1)
            kick[n : 2 * n, 0] = inverse * damping * one * start[0]
            after = expm(whole * end) * kick
            rate, speed = rate + after, speed + whole * after
            made.append({
                "system": name, "load": kind, "absolute": text(rate[n - 1]), "absolute_velocity": text(speed[n - 1]),
                "acceleration": text(speed[2 * n - 1]), "base": text(rate[2 * n]),
            })  # fmt: skip
    return made


def main(target: Path) -> None:
    made = {
        "about": "Written by generate_vibration_motion_references.py: other formulas than the program's, 32 digits.",
        "shocks": shocks(), "undamped": undamped(), "complex_modes": complex_modes(), "jumps": jumps(),
        "systems": SYSTEMS, "histories": histories(), "moved_bases": moved_bases(),
        "van_der_pol": {mu: van_der_pol(mpf(mu)) for mu in ("1",)}, **periods(),
    }  # fmt: skip
    target.write_text(json.dumps(made, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else FILE)
