"""Writes tests/balance/balance.json: corrections, orders and flywheels to 30 digits.

The formulas are others than the program's. Corrections come from linear equations of moments with real components;
piston orders from Fourier sums over the exact acceleration, differentiated in closed form, at 512 points; engines from
the same sums of all cylinders at once; the work of a torque from Simpson's rule between crossings found by bisection.

Run: python tests/references/generate_balance_references.py [FILE]. The same bytes every time.
"""

import itertools
import json
import sys
from pathlib import Path

from mpmath import atan2, cos, diff, expj, lu_solve, matrix, mp, mpc, mpf, pi, quad, sin, sqrt

mp.dps = 45
FILE = Path(__file__).resolve().parents[1] / "balance" / "balance.json"
POINTS = 512
RATIO = mpf("0.25")
DEGREE = pi / 180


def text(value):
    """Digits; what is left of zeros is none."""
    if abs(value) < mpf("1e-30"):
        return "0.0"
    return mp.nstr(value, 30, min_fixed=1, max_fixed=0)


def polar(x, y):
    return [text(sqrt(x * x + y * y)), text(atan2(y, x) % (2 * pi) / DEGREE)]


def planes():
    """Forces and moments of unbalances and corrections are zero: four real equations."""
    given = [("12", 30, "0.1"), ("20", 140, "0.35"), ("8", 260, "0.6")]
    first, second = mpf("0.05"), mpf("0.7")
    rows, right = matrix(4, 4), matrix(4, 1)
    for axis, turn in enumerate((cos, sin)):
        rows[axis, axis] = rows[axis, 2 + axis] = 1
        rows[2 + axis, axis], rows[2 + axis, 2 + axis] = first, second
        right[axis] = -sum(mpf(u) * turn(a * DEGREE) for u, a, _ in given)
        right[2 + axis] = -sum(mpf(u) * mpf(z) * turn(a * DEGREE) for u, a, z in given)
    x = lu_solve(rows, right)
    return {"first": polar(x[0], x[1]), "second": polar(x[2], x[3])}


def trial(sensors, weights):
    """Real normal equations of the components of masses."""
    count = len(weights)

    def vector(reading):
        size, angle = reading
        return mpf(size) * cos(angle * DEGREE), mpf(size) * sin(angle * DEGREE)

    rows, right = matrix(2 * len(sensors), 2 * count), matrix(2 * len(sensors), 1)
    for s, runs in enumerate(sensors):
        start = vector(runs[0])
        right[2 * s], right[2 * s + 1] = -start[0], -start[1]
        for p, (mass, angle) in enumerate(weights):
            run = vector(runs[1 + p])
            dx, dy = run[0] - start[0], run[1] - start[1]
            wx, wy = vector((mass, angle))
            square = wx * wx + wy * wy
            ax, ay = (dx * wx + dy * wy) / square, (dy * wx - dx * wy) / square
            rows[2 * s, 2 * p], rows[2 * s, 2 * p + 1] = ax, -ay
            rows[2 * s + 1, 2 * p], rows[2 * s + 1, 2 * p + 1] = ay, ax
    x = lu_solve(rows.T * rows, rows.T * right)
    left = rows * x - right
    return {
        "masses": [polar(x[2 * p], x[2 * p + 1]) for p in range(count)],
        "residuals": [text(sqrt(left[2 * s] ** 2 + left[2 * s + 1] ** 2)) for s in range(len(sensors))],
    }


def four_runs(still, runs, mass):
    """The plane through the squares of the readings, from linear equations in t² and both parts of z."""
    rows, right = matrix(3, 3), matrix(3, 1)
    for k, (angle, size) in enumerate(runs):
        turn = mpf(angle) * DEGREE
        rows[k, 0], rows[k, 1], rows[k, 2] = 1, 2 * cos(turn), 2 * sin(turn)
        right[k] = mpf(size) ** 2 - mpf(still) ** 2
    square, x, y = lu_solve(rows, right)
    length, effect = sqrt(x * x + y * y), sqrt(square)
    where = (-x / mpf(still), -y / mpf(still))
    misses = []
    for angle, size in runs:
        turn = mpf(angle) * DEGREE
        away = sqrt((where[0] - mpf(still) * cos(turn)) ** 2 + (where[1] - mpf(still) * sin(turn)) ** 2)
        misses.append(abs(away - mpf(size)))
    return {
        "still": still, "runs": runs, "trial": mass, "mass": polar(-x * mpf(mass) / square, -y * mpf(mass) / square),
        "consistency": text(length / (mpf(still) * effect)), "effect": text(effect), "miss": text(max(misses)),
    }  # fmt: skip


def acceleration(ratio, angle):
    """Of the piston towards the crankshaft over r·ω²."""
    root = sqrt(1 - (ratio * sin(angle)) ** 2)
    return cos(angle) + ratio * (cos(2 * angle) + ratio**2 * sin(angle) ** 4) / root**3


def orders(ratio):
    """A₂, A₄ and A₆ by means over the turn."""
    angles = [2 * pi * k / POINTS for k in range(POINTS)]
    values = [acceleration(ratio, angle) for angle in angles]
    return [text(2 * sum(v * cos(n * a) for v, a in zip(values, angles, strict=True)) / POINTS) for n in (2, 4, 6)]


def height(ratio, offset, angle):
    """Of the piston over the crankshaft, by the crank radius."""
    lean = ratio * sin(angle) - offset
    return cos(angle) + sqrt(1 - lean * lean) / ratio


def offset_orders(ratio, offset):
    """A_n and B_n of orders 1 to 6: those of the height, times the square of the order."""
    angles = [2 * pi * k / POINTS for k in range(POINTS)]
    values = [height(ratio, offset, angle) for angle in angles]
    return [
        [
            text(2 * n * n * sum(v * wave(n * a) for v, a in zip(values, angles, strict=True)) / POINTS)
            for wave in (cos, sin)
        ]
        for n in range(1, 7)
    ]


DIAGRAM = [(0, 25), (20, 55), (90, 8), (180, 0), (540, 0), (720, 25)]


def turning(ratio, offset, orders):
    """Torques of one cylinder by order over two turns, in bar·A·r and m·r²·ω²: from derivatives of the height."""
    mp.dps = 30
    out = {}
    for n in orders:
        sums = [mpc(0), mpc(0)]
        for (a, p), (b, q) in itertools.pairwise(DIAGRAM):
            knots = [(a + (b - a) * mpf(k) / 18) * DEGREE for k in range(19)]

            def wave(angle, part, a=a, p=p, b=b, q=q, n=n):
                first = diff(lambda x: height(ratio, offset, x), angle)
                if part:
                    torque = -first * diff(lambda x: height(ratio, offset, x), angle, 2)
                else:
                    torque = -first * (p + (q - p) * (angle / DEGREE - a) / (b - a))
                return torque * expj(-n * angle)

            for part in range(2):
                sums[part] += quad(lambda x, part=part: wave(x, part), knots, method="gauss-legendre", maxdegree=3)
        factor = 2 / (4 * pi)
        out[str(n)] = [[text(one.real * factor), text(one.imag * factor)] for one in sums]
    mp.dps = 45
    return out


def engine(cylinders, ratio=RATIO):
    """Forward and backward force and couple of orders 1, 2 and 4, from the exact forces of all cylinders."""
    angles = [2 * pi * k / 128 for k in range(128)]
    single = [acceleration(ratio, 2 * pi * k / 640) for k in range(640)]
    out = {}
    for n in (1, 2, 4):
        sums = [mpf(0)] * 8
        for angle, step in zip(angles, range(128), strict=True):
            c, s = cos(n * angle), sin(n * angle)
            for crank, bank, place in cylinders:
                local = 5 * step + mpf(crank - bank) * 640 / 360
                value = single[int(local) % 640] if local == int(local) else acceleration(ratio, local * 2 * pi / 640)
                x, y = value * cos(bank * DEGREE), value * sin(bank * DEGREE)
                for base, lever in ((0, mpf(1)), (4, mpf(place))):
                    # e^{−inθ} picks what turns forward, e^{inθ} what turns backward
                    sums[base] += lever * (x * c + y * s)
                    sums[base + 1] += lever * (y * c - x * s)
                    sums[base + 2] += lever * (x * c - y * s)
                    sums[base + 3] += lever * (y * c + x * s)
        sizes = [sqrt(sums[k] ** 2 + sums[k + 1] ** 2) / 128 for k in (0, 2, 4, 6)]
        out[str(n)] = [text(size) for size in sizes]
    return out


ENGINES = {
    "inline-3": [(0, 0, -1), (120, 0, 0), (240, 0, 1)],
    "inline-4": [(a, 0, z - mpf("1.5")) for z, a in enumerate((0, 180, 180, 0))],
    "inline-5": [(a, 0, z - 2) for z, a in enumerate((0, 144, 216, 288, 72))],
    "v2": [(0, -45, 0), (0, 45, 0)],
    "v6": [(a + d, b, z - 1) for z, a in enumerate((0, 120, 240)) for d, b in ((0, -30), (-60, 30))],
    "v8-cross": [(a, b, z - mpf("1.5")) for z, a in enumerate((0, 90, 270, 180)) for b in (-45, 45)],
    "v8-flat": [(a, b, z - mpf("1.5")) for z, a in enumerate((0, 180, 180, 0)) for b in (-45, 45)],
    "boxer-4": [(a, 180 * (z % 2), z - mpf("1.5")) for z, a in enumerate((0, 180, 180, 0))],
    "radial-3": [(0, 120 * k, 0) for k in range(3)],
    "radial-5": [(0, 72 * k, 0) for k in range(5)],
}


def flywheel():
    """Work between bisected crossings by Simpson's rule."""
    table = [(0, -80), (30, 400), (75, 900), (120, 350), (180, -120), (270, -160), (360, -80)]

    def torque(degrees):
        for (a, s), (b, t) in itertools.pairwise(table):
            if degrees <= b:
                return mpf(s) + (mpf(t) - s) * (degrees - a) / (b - a)
        raise ValueError(degrees)

    def work(low, high, mean):
        inner = [mpf(a) for a, _ in table if low < a < high]
        corners = [low, *inner, high]
        whole = mpf(0)
        for a, b in itertools.pairwise(corners):
            whole += (torque(a) + 4 * torque((a + b) / 2) + torque(b) - 6 * mean) * (b - a) / 6
        return whole * DEGREE

    mean = work(mpf(0), mpf(360), mpf(0)) / (2 * pi)

    def crossing(low, high):
        rising = torque(low) < mean
        for _ in range(160):
            middle = (low + high) / 2
            low, high = (middle, high) if (torque(middle) < mean) == rising else (low, middle)
        return low

    slow, fast = crossing(mpf(0), mpf(30)), crossing(mpf(120), mpf(180))
    energy = work(slow, fast, mean)
    speed = 10 * pi
    return {
        "mean": text(mean), "energy": text(energy), "inertia": text(energy / (mpf("0.02") * speed**2)),
        "slowest": text(slow), "fastest": text(fast),
    }  # fmt: skip


def main():
    two = [[("170", 112), ("235", 94), ("186", 115)], [("53", 78), ("58", 68), ("77", 104)]]
    three = [*two, [("120", 95), ("150", 80), ("139", 101)]]
    weights = [("1.15", 0), ("1.15", 0)]
    data = {
        "about": "Written by generate_balance_references.py: other formulas than the program's, 45 digits.",
        "planes": planes(),
        "one_plane": trial([[("6", 40), ("8", 110)]], [("5", 0)]),
        "two_planes": trial(two, weights),
        "least_squares": trial(three, weights),
        "four_runs": [
            four_runs("6", [(0, "4"), (120, "9"), (240, "7.5")], "10"),
            four_runs("4.2", [(0, "5.9"), (110, "2.1"), (250, "5.6")], "14"),
        ],
        "orders": {ratio: orders(mpf(ratio)) for ratio in ("0.25", "0.3", "0.5", "0.85")},
        "offset_orders": {f"{r} {e}": offset_orders(mpf(r), mpf(e)) for r, e in (("0.3", "0.05"), ("0.25", "-0.1"))},
        "turning": {"diagram": DIAGRAM, "0.3 0.05": turning(mpf("0.3"), mpf("0.05"), (0, 0.5, 1, 2, 2.5, 6))},
        "engines": {name: engine(cylinders) for name, cylinders in ENGINES.items()},
        "flywheel": flywheel(),
    }
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else FILE
    path.write_text(json.dumps(data, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
