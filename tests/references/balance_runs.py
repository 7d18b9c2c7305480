"""Cases of rotor_balance.json for balancing by amplitudes alone and for turning moments of engines."""

import random
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

from case_files import Case
from mpmath import arg, cos, expj, linspace, lu_solve, matrix, mp, mpf, pi, quad, sin, sqrt

RANDOM = random.Random(2026)
POINTS = 256


def exact(text: str) -> Any:
    return mpf(float(text))


def turn_of(phasor: Any) -> Any:
    """Its angle, from 0 up to a whole turn."""
    return arg(phasor) % (2 * pi)


def drawn(low: float, high: float) -> str:
    return repr(round(RANDOM.uniform(low, high), 3))


def four_runs() -> Iterator[Case]:
    """Squares of the readings are linear in what the weight does: three equations."""
    hard = [
        (("6.0", "6.0001", "5.9999", "6.0002"), ("0.0", "2.0943951023931957", "4.1887902047863914"), "0.0001",
         "a weight that hardly shows: its effect is what equal readings differ by"),
        (("5.0", "7.0859", "6.6986", "6.2529"), ("0.0", "0.2", "0.4"), "6.5",
         "angles close together, as a short run leaves"),
    ]  # fmt: skip
    places = ("0.0", "2.0943951023931957", "4.1887902047863914")
    for _ in range(4):
        still, effect, turn = RANDOM.uniform(3, 9), RANDOM.uniform(2, 9), RANDOM.uniform(-3, 3)
        sizes = [abs(still + effect * complex(expj(float(place) + turn))) for place in places]
        hard.append((tuple(repr(round(size, 2)) for size in (still, *sizes)), places, drawn(0.001, 0.05), ""))
    for nth, (readings, angles, trial, why) in enumerate(hard):
        still, *runs = map(exact, readings)
        rows = matrix([[1, 2 * cos(exact(angle)), 2 * sin(exact(angle))] for angle in angles])
        square, x, y = lu_solve(rows, matrix([run**2 - still**2 for run in runs]))
        answer = x + 1j * y
        misses = [
            abs(abs(answer / still + still * expj(exact(at))) - run) for at, run in zip(angles, runs, strict=True)
        ]
        names = ("initial", "first", "second", "third")
        inputs = {**dict(zip(names, readings, strict=True)), "trial_mass": trial}
        inputs |= {f"{name}_angle": angle for name, angle in zip(names[1:], angles, strict=True)}
        yield (
            "four_runs", f"runs {nth}", why, inputs,
            {
                "mass": exact(trial) * abs(answer) / square, "angle": turn_of(-answer), "effect": sqrt(square),
                "consistency": abs(answer) / (still * sqrt(square)), "miss": max(misses),
            },
        )  # fmt: skip


def turnings() -> Iterator[Case]:
    """The inertia torque takes kinetic energy from the pistons: its waves are those of the energy, differentiated."""
    cycle = 4 * pi
    for nth, (preset, count) in enumerate((("inline-3", 3), ("inline-4", 4), ("inline-6", 6))):
        diagram = [("0.0", "2500000.0"), ("0.3", "5500000.0"), ("1.6", "800000.0"), ("9.5", "0.0"),
                   ("12.566370614359172", "2500000.0")]  # fmt: skip
        inputs: dict[str, Any] = {
            "diagram_points": [{"record": "Diagram", "angle": at, "pressure": size} for at, size in diagram],
            "bore": drawn(0.07, 0.1), "reciprocating_mass": drawn(0.3, 0.9),
            "crank": {"record": "CrankRadius", "crank_radius": drawn(0.03, 0.05)},
            "rod_length": drawn(0.12, 0.2), "speed": drawn(100, 600), "preset": {"word": preset},
        }  # fmt: skip
        numbers = {**inputs, **inputs["crank"]}
        names = ("bore", "reciprocating_mass", "crank_radius", "rod_length", "speed")
        bore, mass, r, rod, speed = (exact(numbers[name]) for name in names)
        area = pi * bore**2 / 4

        def sinks(angle: Any, r: Any = r, rod: Any = rod) -> Any:
            """Way of the piston by crank angle."""
            return r * sin(angle) + r**2 * sin(angle) * cos(angle) / sqrt(rod**2 - (r * sin(angle)) ** 2)

        turn = [2 * pi * k / POINTS for k in range(POINTS)]
        energies = [mass * (speed * sinks(theta)) ** 2 / 2 for theta in turn]
        table = [(exact(at), exact(size)) for at, size in diagram]

        def gas(n: Any, area: Any = area, table: Any = table, sinks: Any = sinks) -> Any:
            def integrated(a0: Any, p0: Any, a1: Any, p1: Any) -> Any:
                def torque(x: Any) -> Any:
                    return (p0 + (p1 - p0) * (x - a0) / (a1 - a0)) * area * sinks(x) * expj(-n * x)

                return quad(torque, linspace(a0, a1, 3 + int(a1 - a0)))

            with mp.workdps(50):
                return sum(integrated(*one, *two) for one, two in pairwise(table)) * 2 / cycle

        mean = count * gas(mpf(0)).real / 2
        results = {"mean_torque": mean, "power": mean * speed, "mean_pressure": mean * cycle / (2 * area * r * count)}
        # fired evenly, only waves remain of which a whole number falls between two firings
        for row, wave in enumerate(range(1, 6 * 2 // count + 1)):
            n = mpf(wave * count) / 2
            energy = 2 * sum(e * expj(-n * theta) for e, theta in zip(energies, turn, strict=True)) / POINTS
            burnt, thrown = gas(n), mpf(0) if n != int(n) else -1j * n * energy
            name = f"orders[{row}]."
            results |= {name + "torque": count * abs(burnt + thrown), name + "gas": count * abs(burnt)}
            results |= {name + "inertia": count * abs(thrown), name + "single": abs(burnt + thrown)}
        yield "turning", f"engine {nth}", "", inputs, results
