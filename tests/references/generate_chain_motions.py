"""Writes tests/motion/chains.json: motions of chains of rods and frequencies of their small oscillations.

Another formulation than the program's: every rod's centre and end by its partial velocities in the plane, the mass
matrix Σ m·JᵀJ, forces and centripetal terms as vectors; integrated at 40 digits by Gragg's midpoint rule with
extrapolation. Frequencies of equal points by the zeros of Laguerre's polynomials, others by the eigenvalues of the same
matrices at 60 digits.

Run: python tests/references/generate_chain_motions.py [FILE]. The same bytes every time.
"""

import json
import sys
from pathlib import Path

from mpmath import binomial, cos, factorial, lu_solve, matrix, mp, mpf, nstr, pi, polyroots, sin, sqrt

mp.dps = 40
TARGET = Path(__file__).resolve().parents[1] / "motion" / "chains.json"
DEGREE = pi / 180
STANDARD = mpf("9.80665")
COLUMNS = 12


def text(value):
    return nstr(value, 22, min_fixed=1, max_fixed=0)


def masses(lengths, rods, points):
    """Each mass with the shares of the lengths that carry it, and each rod's moment about its centre."""
    n = len(lengths)
    found = []
    for i in range(n):
        for mass, share in ((rods[i], lengths[i] / 2), (points[i], lengths[i])):
            if mass:
                found.append((mass, [*lengths[:i], share] + [mpf(0)] * (n - i - 1)))
    return found, [rods[i] * lengths[i] ** 2 / 12 for i in range(n)]


def motion(lengths, rods, points, gravity):
    n = len(lengths)
    carried, turned = masses(lengths, rods, points)

    def rate(y):
        q, w = y[:n], y[n:]
        s, c = [sin(x) for x in q], [cos(x) for x in q]
        m, right = matrix(n, n), matrix(n, 1)
        for i in range(n):
            m[i, i] += turned[i]
        for mass, arms in carried:
            jx, jy = [a * x for a, x in zip(arms, c, strict=True)], [a * x for a, x in zip(arms, s, strict=True)]
            bx = -sum(arms[k] * s[k] * w[k] ** 2 for k in range(n))
            by = sum(arms[k] * c[k] * w[k] ** 2 for k in range(n))
            for i in range(n):
                right[i] += mass * (-jx[i] * bx + jy[i] * (-gravity - by))
                for j in range(n):
                    m[i, j] += mass * (jx[i] * jx[j] + jy[i] * jy[j])
        return [*w, *lu_solve(m, right)]

    return rate


def midpoint(rate, y, step, count):
    h = step / count
    before, now = y, [a + h * b for a, b in zip(y, rate(y), strict=True)]
    for _ in range(count - 1):
        before, now = now, [a + 2 * h * b for a, b in zip(before, rate(now), strict=True)]
    return [(a + b + h * c) / 2 for a, b, c in zip(before, now, rate(now), strict=True)]


def integrated(rate, y, time, step):
    for _ in range(int(time / step)):
        table = []
        for k in range(COLUMNS):
            row = [midpoint(rate, y, step, 2 * (k + 1))]
            for j in range(k):
                ratio = (mpf(k + 1) / (k - j)) ** 2 - 1
                row.append([a + (a - b) / ratio for a, b in zip(row[j], table[j], strict=True)])
            table = row
        y = table[-1]
    return y


def frequencies(lengths, rods, points):
    """ω² for a gravity of 1, from the lowest."""
    n = len(lengths)
    with mp.workdps(60):
        carried, turned = masses(lengths, rods, points)
        m, weights = matrix(n, n), [mpf(0)] * n
        for i in range(n):
            m[i, i] += turned[i]
        for mass, arms in carried:
            for i in range(n):
                weights[i] += mass * arms[i]
                for j in range(n):
                    m[i, j] += mass * arms[i] * arms[j]
        scaled = matrix(n, n)
        for i in range(n):
            for j in range(n):
                scaled[i, j] = m[i, j] / sqrt(weights[i] * weights[j])
        values, _ = mp.eigsy(scaled)
        return sorted(1 / value for value in values)


def ones(n, value=1):
    return [mpf(value)] * n


def main():
    unit = motion(ones(2), ones(2), ones(2, 0), mpf(1))
    points = motion(ones(2), ones(2, 0), ones(2), mpf("9.81"))
    three = motion(ones(3, "0.5"), ones(3), ones(3, 0), STANDARD)
    mixed = motion([mpf("0.4"), mpf("0.9")], [mpf(2), mpf("0.5")], [mpf(1), mpf(3)], STANDARD)
    right = [pi / 2, pi / 2, mpf(0), mpf(0)]
    bent = [30 * DEGREE, -20 * DEGREE, 45 * DEGREE, mpf(0), mpf(0), mpf(0)]
    fine = mpf(1) / 32
    with mp.workdps(30):
        motions = {
            "unit rods, 1 s": integrated(unit, right, 1, fine),
            "unit rods, 5 s": integrated(unit, right, 5, fine),
            "unit points, 1 s": integrated(points, right, 1, fine),
            "unit points, 10 s": integrated(points, right, 10, fine),
            "three rods, 2 s": integrated(three, bent, 2, fine / 2),
            "rods with ends, 1 s": integrated(mixed, [mpf(1), mpf(2), mpf("-1.5"), mpf(4)], 1, fine / 2),
        }
    graded = [mpf("1e-6"), mpf(1), mpf("1e6")]
    squares = {
        "3 rods": frequencies(ones(3), ones(3), ones(3, 0)),
        "10 rods": frequencies(ones(10), ones(10), ones(10, 0)),
        "points 1e-6, 1, 1e6": frequencies(ones(3), ones(3, 0), graded),
        "points 1e6, 1, 1e-6": frequencies(ones(3), ones(3, 0), graded[::-1]),
    }
    for n in (3, 6):
        coefficients = [(-1) ** k * binomial(n, k) / factorial(k) for k in range(n, -1, -1)]
        squares[f"{n} points"] = sorted(polyroots(coefficients, maxsteps=200, extraprec=200))
    found = {
        "motions": {name: [text(value) for value in state] for name, state in motions.items()},
        "squares": {name: [text(value) for value in values] for name, values in squares.items()},
    }
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else TARGET
    target.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
