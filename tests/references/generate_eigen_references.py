"""Writes eigen.json: eigenvalues and axes of symmetric 3 × 3 matrices, to 40 digits.

The program rotates by Jacobi; here the cubic is solved with 400 digits, and axes are across the rows of A − λ·1.
Matrices are doubles, taken as exact. Run: python tests/references/generate_eigen_references.py [FILE]. The same bytes
every time.
"""

import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import inertia_found
from case_files import put
from mpmath import mp, mpf

GRADES = ((1.0, 1e-3, 1e-6), (1.0, 1e-6, 1.0), (1e-4, 1.0, 1e4), (1.0, 1e-8, 1e-4), (1e-6, 1e-6, 1.0))


def matrices():
    """Kind, name, why and matrix of every case."""
    rng = random.Random(5)

    def symmetric(low):
        off = [rng.uniform(-0.4, 0.4) for _ in range(3)]
        a, b, c = (rng.uniform(low, 2.0) for _ in range(3))
        return [[a, off[0], off[1]], [off[0], b, off[2]], [off[1], off[2], c]]

    for nth in range(12):
        yield "ordinary", f"dense {nth}", "", symmetric(1.0)
    for nth, grade in enumerate(GRADES * 3):
        base = symmetric(1.0)
        graded = [[base[i][j] * grade[i] * grade[j] for j in range(3)] for i in range(3)]
        for i in range(3):
            for j in range(i):
                graded[i][j] = graded[j][i]
        a, b, c = grade
        why = f"graded by {a:g}, {b:g}, {c:g} on both sides: the small eigenvalue is lost beside the large one"
        yield "hard", f"graded {nth}", why, graded
    for gap in (1e-4, 1e-8, 1e-12, 1e-15):
        why = f"eigenvalues within {gap:g} of one another: the trigonometric formula loses half of the digits"
        yield "hard", f"gap {gap:g}", why, [[1.0, gap, 0.0], [gap, 1.0, gap], [0.0, gap, 1.0 + gap]]
    for name, why, rows in inertia_found.MATRICES:
        yield "hard", name, why, rows


def eigenvalues(rows):
    """The roots of the characteristic polynomial, the greatest first."""
    a = [[mpf(x) for x in row] for row in rows]
    trace = a[0][0] + a[1][1] + a[2][2]
    minors = sum(a[i][i] * a[j][j] - a[i][j] ** 2 for i, j in ((0, 1), (0, 2), (1, 2)))
    roots = mp.polyroots([1, -trace, minors, -mp.det(mp.matrix(a))], maxsteps=2000, extraprec=1500)
    return sorted((mp.re(root) for root in roots), reverse=True)


def axis(rows, value):
    """The unit vector that A − λ·1 takes to nothing: across its rows, by the two that span the most."""
    a = [[mpf(x) - (value if i == j else 0) for j, x in enumerate(row)] for i, row in enumerate(rows)]
    cross = [
        [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
        for p, q in ((a[0], a[1]), (a[1], a[2]), (a[2], a[0]))
    ]
    best = max(cross, key=lambda v: sum(x * x for x in v))
    size = mp.sqrt(sum(x * x for x in best))
    return [x / size for x in best]


def main() -> None:
    mp.dps = 400
    lines = []
    for kind, name, why, rows in matrices():
        case = {"task": "eigen", "kind": kind, "name": name, **({"why": why} if why else {})}
        inputs = {"rows": [[repr(x) for x in row] for row in rows]}
        found = eigenvalues(rows)
        results = {f"values[{i}]": mp.nstr(value, 40) for i, value in enumerate(found)}
        for i, value in enumerate(found):
            results |= {f"axes[{i}][{j}]": mp.nstr(x, 40) for j, x in enumerate(axis(rows, value))}
        lines.append({**case, "inputs": inputs, "results": results})
    about = "Written by generate_eigen_references.py: eigenvalues and axes of matrices of doubles, to 40 digits."
    put("eigen", about, lines)


if __name__ == "__main__":
    main()
