"""Writes rotor_balance.json: corrections, grades, engines and flywheels to 40 digits.

Unbalances are complex exponentials, corrections come from real linear equations of forces and moments, orders of
engines from sums over the exact acceleration of the pistons, flywheels from crossings by linear equations, turning
moments from the pistons' energy; the program
has products of sines and cosines, shares of a beam, a power series, and sums of trapezia.
Run: python tests/references/generate_rotor_balance_references.py [FILE]. The same bytes every time.
"""

import random
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

from balance_runs import four_runs, turn_of, turnings
from case_files import Case, write
from mpmath import cos, expj, lu_solve, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 90
ABOUT = (
    "Written by generate_rotor_balance_references.py: SI inputs as doubles, results to 40 digits from 90-digit "
    "arithmetic."
)
RANDOM = random.Random(1940)
POINTS = 256


def exact(text: str) -> Any:
    return mpf(float(text))


def drawn(low: float, high: float, digits: int = 3) -> str:
    return repr(round(RANDOM.uniform(low, high), digits))


def vector(size: str, angle: str) -> Any:
    return exact(size) * expj(exact(angle))


def statics() -> Iterator[Case]:
    hard = [
        ([("0.02", "0.08", "0.5"), ("0.02", "0.08", "3.6415926535")],
         "two masses all but opposite: what is left is the rounding of the half turn"),
        ([("0.05", "0.1", "1.0"), ("0.0499999999", "0.1", "4.1415926535897931")],
         "opposite masses that differ in the ninth digit"),
    ]  # fmt: skip
    drawings = [([(drawn(0.001, 0.1), drawn(0.02, 0.3), drawn(-6, 6)) for _ in range(n)], "") for n in (1, 2, 3, 5)]
    for nth, (masses, why) in enumerate([*hard, *drawings]):
        fields = ("mass", "radius", "angle")
        inputs = {
            "weights": [{"record": "Weight", **dict(zip(fields, row, strict=True))} for row in masses],
            "correction_radius": drawn(0.05, 0.3), "rotor_mass": drawn(1, 50), "speed": drawn(10, 900),
        }  # fmt: skip
        whole = sum(exact(mass) * vector(radius, angle) for mass, radius, angle in masses)
        size, speed = abs(whole), exact(inputs["speed"])
        off = size / exact(inputs["rotor_mass"])
        yield (
            "static", f"masses {nth}", why, inputs,
            {
                "unbalance": size, "angle": turn_of(whole), "correction_angle": turn_of(-whole), "eccentricity": off,
                "correction_mass": size / exact(inputs["correction_radius"]), "force": size * speed**2,
                "grade": off * speed,
            },
        )  # fmt: skip


def grades() -> Iterator[Case]:
    for nth in range(4):
        names = ("grade", "speed", "mass", "first_distance", "second_distance", "measured")
        values = drawn(0.0004, 0.02, 5), drawn(50, 900), drawn(1, 900), drawn(0.3, 0.5), drawn(0.3, 0.5), drawn(0, 0.01)
        inputs = dict(zip(names, values, strict=True))
        g, speed, mass, first, second, measured = map(exact, values)
        # loads of a beam: both planes carry the whole, and their moments about the mass centre cancel
        share = lu_solve(matrix([[1, 1], [first, -second]]), matrix([g / speed * mass, 0]))
        yield (
            "grade", f"rotor {nth}", "", inputs,
            {
                "eccentricity": g / speed, "unbalance": share[0] + share[1], "first_unbalance": share[0],
                "second_unbalance": share[1], "reached": measured / mass * speed,
                "usage": measured / (share[0] + share[1]),
            },
        )  # fmt: skip


def splits() -> Iterator[Case]:
    hard = [
        ("0.01", "0.5", "0.4999999", "0.5000002", "places all but at one angle: the shares are large and opposite"),
        ("0.01", "0.5", "0.4999999999", "1.7", "all but at the first place: the second mass is nearly nothing"),
        ("0.01", "1.0", "-0.5", "2.6", "places nearly opposite: the sine between them is a small difference"),
    ]
    for nth, (mass, angle, first, second, why) in enumerate(
        [*hard, *((drawn(0.001, 0.1), drawn(0.5, 0.9), drawn(0, 0.4), drawn(1, 2.2), "") for _ in range(3))]
    ):
        ends = expj(exact(first)), expj(exact(second))
        rows = matrix([[end.real for end in ends], [end.imag for end in ends]])
        whole = vector(mass, angle)
        sizes = lu_solve(rows, matrix([whole.real, whole.imag]))
        places = {"record": "Angles", "first_angle": first, "second_angle": second}
        yield (
            "split", f"angles {nth}", why, {"mass": mass, "angle": angle, "places": places},
            {"first_mass": sizes[0], "second_mass": sizes[1]},
        )  # fmt: skip


def two_shares(rows: "list[tuple[Any, Any]]", first: Any, second: Any) -> "list[Any]":
    """Two forces that do what all these at their places do, by force and moment."""
    force = sum(size for size, _ in rows)
    moment = sum(size * place for size, place in rows)
    solved = lu_solve(matrix([[1, 1], [first, second]]), matrix([force, moment]))
    return [solved[0], solved[1]]


def planes() -> Iterator[Case]:
    hard = [
        ([("1e-05", "0.5", "0.1"), ("1e-05", "3.64159265", "0.6")], "a couple with hardly any static part"),
        ([("2e-05", "1.0", "0.3"), ("1e-05", "2.0", "0.30000000001")], "unbalances all but in the first plane"),
    ]
    drawings = [([(drawn(1e-6, 1e-4, 8), drawn(-3, 3), drawn(0, 1)) for _ in range(n)], "") for n in (1, 2, 3, 4)]
    for nth, (rows, why) in enumerate([*hard, *drawings]):
        fields = ("amount", "angle", "position")
        inputs: dict[str, Any] = {
            "unbalances": [{"record": "Unbalance", **dict(zip(fields, row, strict=True))} for row in rows],
            "first_plane": "0.3" if nth == 1 else drawn(-0.1, 0.3), "second_plane": drawn(0.5, 1.2),
            "first_bearing": drawn(-0.3, 0.1), "second_bearing": drawn(0.8, 1.5), "speed": drawn(100, 900),
        }  # fmt: skip
        first, second, left, right, speed = (exact(text) for text in list(inputs.values())[1:])
        given = [(vector(amount, angle), exact(place)) for amount, angle, place in rows]
        sides = [-side for side in two_shares(given, first, second)]
        static = sum(size for size, _ in given)
        results = {
            "first_unbalance": abs(sides[0]), "first_angle": turn_of(sides[0]), "second_unbalance": abs(sides[1]),
            "second_angle": turn_of(sides[1]), "static": abs(static), "static_angle": turn_of(static),
            "couple": abs(sum(size * (place - (first + second) / 2) for size, place in given)),
        }  # fmt: skip
        for k, load in enumerate(two_shares(given, left, right)):
            results |= {f"bearings[{k}].load": abs(load) * speed**2, f"bearings[{k}].angle": turn_of(load)}
        yield "planes", f"rotor {nth}", why, inputs, results


def trials() -> Iterator[Case]:
    """Corrections from real normal equations of the components."""
    names = ("initial", "first", "second")
    hard = [
        [("60.0", "10.0"), ("80.0", "30.0"), ("79.0", "30.5")],
        [("-20.0", "55.0"), ("-3.0", "71.0"), ("-2.0", "70.5")],
    ]
    drawings = [[[(drawn(-90, 90), drawn(-90, 90)) for _ in range(3)] for _ in range(n)] for n in (2, 3, 4)]
    why = "the planes act nearly alike: their masses nearly cancel"
    for nth, (sensors, reason) in enumerate([(hard, why), *((rows, "") for rows in drawings)]):
        weights = [("0.005", "0.3"), (drawn(0.001, 0.01), drawn(0, 6))]
        rows, right = matrix(2 * len(sensors), 4), matrix(2 * len(sensors), 1)
        for s, readings in enumerate(sensors):
            start, *runs = (exact(x) + 1j * exact(y) for x, y in readings)
            right[2 * s], right[2 * s + 1] = -start.real, -start.imag
            for p, (run, weight) in enumerate(zip(runs, weights, strict=True)):
                share = (run - start) / vector(*weight)
                rows[2 * s, 2 * p], rows[2 * s, 2 * p + 1] = share.real, -share.imag
                rows[2 * s + 1, 2 * p], rows[2 * s + 1, 2 * p + 1] = share.imag, share.real
        solved = lu_solve(rows.T * rows, rows.T * right)
        masses = [solved[0] + 1j * solved[1], solved[2] + 1j * solved[3]]
        left = rows * solved - right
        results = {f"{name}_mass": abs(mass) for name, mass in zip(names[1:], masses, strict=True)}
        results |= {f"{name}_angle": turn_of(mass) for name, mass in zip(names[1:], masses, strict=True)}
        if len(sensors) > 2:
            for s in range(len(sensors)):
                results[f"predicted[{s}].residual"] = sqrt(left[2 * s] ** 2 + left[2 * s + 1] ** 2)
        inputs = {
            "sensors": [{"record": "Sensor", **dict(zip(names, map(list, row), strict=True))} for row in sensors],
            **{f"{name}_trial": {"record": "TrialWeight", "mass": mass, "angle": angle}
               for name, (mass, angle) in zip(names[1:], weights, strict=True)},
        }  # fmt: skip
        yield "trial", f"readings {nth}", reason, inputs, results


def acceleration(ratio: Any, angle: Any) -> Any:
    """Of the piston towards the crankshaft over r·ω²."""
    root = sqrt(1 - (ratio * sin(angle)) ** 2)
    return cos(angle) + ratio * (cos(2 * angle) + ratio**2 * sin(angle) ** 4) / root**3


def factor(ratio: Any, order: int) -> Any:
    """The part of an order, as the mean over a turn of what it is multiplied by."""
    angles = [2 * pi * k / POINTS for k in range(POINTS)]
    return 2 * sum(acceleration(ratio, angle) * cos(order * angle) for angle in angles) / POINTS


def throw(radius: str) -> dict[str, str]:
    """A crank by its radius, as the tasks read it."""
    return {"record": "CrankRadius", "crank_radius": radius}


def numbers_of(inputs: dict[str, Any]) -> "list[str]":
    """The numbers of an engine in their order, the crank by its radius."""
    return [value["crank_radius"] if name == "crank" else value for name, value in inputs.items()]


def engines() -> Iterator[Case]:
    """Forces along their banks, added as complex numbers at every angle of a turn; e^{∓inθ} picks both parts."""
    hard = "the cylinders cancel but for the angles' rounding"
    drawings = [
        [("0.0", "0.0", "0.0"), ("3.1415926", "0.0", "0.09")],
        *([(drawn(0, 6), drawn(-1, 1), drawn(-0.3, 0.3)) for _ in range(n)] for n in (1, 2, 3)),
    ]
    for nth, cylinders in enumerate(drawings):
        fields = ("crank", "bank", "position")
        inputs: dict[str, Any] = {
            "reciprocating_mass": drawn(0.1, 2), "crank": throw(drawn(0.02, 0.1)), "rod_length": drawn(0.2, 0.4),
            "speed": drawn(50, 700), "highest_order": 4,
            "cylinders": [{"record": "Cylinder", **dict(zip(fields, row, strict=True))} for row in cylinders],
        }  # fmt: skip
        mass, radius, rod, speed = (exact(text) for text in numbers_of(inputs)[:4])
        results: dict[str, Any] = {}
        turn = [2 * pi * k / POINTS for k in range(POINTS)]
        for lever in (False, True):
            sums = []
            for theta in turn:
                whole = mpf(0)
                for crank, bank, place in cylinders:
                    size = acceleration(radius / rod, theta + exact(crank) - exact(bank))
                    whole += (exact(place) if lever else 1) * size * expj(exact(bank))
                sums.append(whole * mass * radius * speed**2)
            for row, n in enumerate((1, 2, 4)):
                parts = [
                    sum(value * expj(way * n * theta) for value, theta in zip(sums, turn, strict=True)) / POINTS
                    for way in (-1, 1)
                ]
                name = "couple" if lever else "force"
                results[f"orders[{row}].{name}"] = abs(parts[0]) + abs(parts[1])
                if not lever:
                    results |= {f"orders[{row}].forward": abs(parts[0]), f"orders[{row}].backward": abs(parts[1])}
        yield "engine", f"cylinders {nth}", "" if nth else hard, inputs, results


def lanchesters() -> Iterator[Case]:
    hard = [
        ("0.0001", "0.172", "a crank of nothing beside the rod"),
        ("0.0855", "0.1", "hardly any rod to spare: the series of the orders converges slowly"),
    ]
    for nth, (radius, rod, why) in enumerate([*hard, *((drawn(0.02, 0.1), drawn(0.2, 0.4), "") for _ in range(3))]):
        inputs: dict[str, Any] = {
            "reciprocating_mass": drawn(0.1, 2), "crank": throw(radius), "rod_length": rod, "speed": drawn(50, 700),
            "weight_radius": drawn(0.01, 0.03), "cylinders": 4, "order": 2 + 2 * (nth % 2),
        }  # fmt: skip
        mass, r, length, speed, arm = (exact(text) for text in numbers_of(inputs)[:5])
        n = inputs["order"]
        force = 4 * abs(factor(r / length, n)) * mass * r * speed**2
        unbalance = force / (2 * (n * speed) ** 2)
        yield (
            "lanchester", f"shafts {nth}", why, inputs,
            {
                "force": force, "shaft_unbalance": unbalance, "shaft_force": force / 2, "shaft_mass": unbalance / arm,
                "shaft_speed": n * speed,
            },
        )  # fmt: skip


def flywheels() -> Iterator[Case]:
    tables = [
        [("0.0", "100.0"), ("1.0", "100.0000001"), ("2.0", "99.9999999"), ("3.0", "100.0")],
        *([(repr(float(k)), drawn(-300, 900)) for k in range(5)] for _ in range(4)),
    ]
    for nth, rows in enumerate(tables):
        rows = [*rows[:-1], (rows[-1][0], rows[0][1])]
        inputs: dict[str, Any] = {
            "points": [{"record": "Point", "angle": angle, "torque": torque} for angle, torque in rows],
            "speed": drawn(10, 90), "fluctuation": drawn(0.005, 0.05), "rim_radius": drawn(0.1, 1),
        }  # fmt: skip
        speed, share, radius = (exact(text) for text in list(inputs.values())[1:])
        table = [(exact(angle), exact(torque)) for angle, torque in rows]
        # the torque's integral is a quadratic of the angle in every piece, sought where its slope is the mean
        whole = sum((t1 + t0) * (a1 - a0) / 2 for (a0, t0), (a1, t1) in pairwise(table))
        mean = whole / (table[-1][0] - table[0][0])
        stored, levels = mpf(0), []
        for (a0, t0), (a1, t1) in pairwise(table):
            slope = (t1 - t0) / (a1 - a0)
            if (t0 - mean) * (t1 - mean) < 0 or (t0 == mean != t1):
                along = (mean - t0) / slope
                levels.append((stored + (t0 - mean) * along + slope * along**2 / 2, a0 + along))
            width = a1 - a0
            stored += (t0 - mean) * width + slope * width**2 / 2
        (low, slowest), (high, fastest) = min(levels), max(levels)
        inertia = (high - low) / (share * speed**2)
        why = "" if nth else "a torque that hardly varies: all is a difference of equal numbers"
        yield (
            "flywheel", f"table {nth}", why, inputs,
            {
                "mean_torque": mean, "energy": high - low, "inertia": inertia, "rim_mass": inertia / radius**2,
                "fastest": fastest, "slowest": slowest,
            },
        )  # fmt: skip


def every() -> Iterator[Case]:
    for part in (statics, planes, trials, splits, grades, engines, lanchesters, flywheels):
        yield from part()
    yield from four_runs()
    yield from turnings()


if __name__ == "__main__":
    write("rotor_balance", ABOUT, every())
