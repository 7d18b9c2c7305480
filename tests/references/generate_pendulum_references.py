"""Writes pendulum.json: pendulums to 40 digits, for ordinary and hard inputs.

Periods are complete elliptic integrals of the first kind from their hypergeometric series, speeds come from energies,
forces from Newton's law, cones from the force polygon; the program has arithmetic–geometric means and half angles.
Run: python tests/references/generate_pendulum_references.py [FILE]. The same bytes every time.
"""

import random
from collections.abc import Iterator
from typing import Any

from case_files import write_given
from mpmath import acos, cos, ellipk, mp, mpf, pi, sin, sqrt

mp.dps = 90
ABOUT = (
    "Written by generate_pendulum_references.py: SI inputs as doubles, results to 40 digits from 90-digit arithmetic."
)
Case = tuple[str, str, str, str, dict[str, Any], dict[str, Any]]
RANDOM = random.Random(1656)
GRAVITY = mpf(9.80665)


def exact(text: str) -> Any:
    return mpf(float(text))


def drawn(low: float, high: float, digits: int = 3) -> str:
    return repr(round(RANDOM.uniform(low, high), digits))


def slow(amplitude: Any) -> Any:
    """T/T₀ of a swing."""
    return 2 * ellipk(sin(amplitude / 2) ** 2) / pi


def simple() -> Iterator[Case]:
    hard = [
        ("Amplitude", "3.141592653589", "the period grows without bound towards the top"),
        ("Amplitude", "1e-08", "the slowdown differs from one by less than a last bit"),
        ("FromTop", "1e-09", "the amplitude in radians has lost this angle"),
        ("FromTop", "1e-150", "its square leaves the range of doubles"),
        ("BottomSpeed", "6.26", "just below the speed that reaches the top of one metre"),
        ("BottomSpeed", "6.27", "just above the speed that reaches the top of one metre"),
        ("BottomSpeed", "1e6", "gravity hardly counts: speeds at bottom and top all but agree"),
    ]
    for name, text, why in hard:
        yield one_simple("hard", f"{name} {text}", why, name, "1.0", text)
    for nth in range(6):
        yield one_simple("ordinary", f"swing {nth}", "", "Amplitude", drawn(0.1, 3.0), drawn(0.05, 3.0))
        yield one_simple("ordinary", f"by speed {nth}", "", "BottomSpeed", drawn(0.1, 3.0), drawn(0.5, 15.0))


def one_simple(kind: str, name: str, why: str, start: str, length_text: str, text: str) -> Case:
    length, value, mass = exact(length_text), exact(text), mpf(2)
    field = {"Amplitude": "amplitude", "FromTop": "from_top", "BottomSpeed": "bottom_speed"}[start]
    small = 2 * pi * sqrt(length / GRAVITY)
    if start == "BottomSpeed":
        half_energy = value * value / (4 * GRAVITY * length)
    else:
        half_energy = sin(value / 2) ** 2 if start == "Amplitude" else cos(value / 2) ** 2
    speed = sqrt(4 * GRAVITY * length * half_energy)
    results = {"small_period": small, "bottom_speed": speed, "bottom_tension": mass * (GRAVITY + speed**2 / length)}
    if half_energy < 1 or start == "FromTop":
        complement = 1 - half_energy
        if start == "FromTop":
            complement = sin(value / 2) ** 2
        # K by the complement where the modulus is all but one
        with mp.workdps(420):
            quarter = ellipk(1 - mpf(complement)) if complement > mpf(10) ** -60 else _near_one(complement)
        results |= {"period": small * 2 * quarter / pi, "slowdown": 2 * quarter / pi}
        results["end_tension"] = mass * GRAVITY * (1 - 2 * half_energy)
    else:
        top = sqrt(speed**2 - 4 * GRAVITY * length)
        results |= {
            "period": 4 * length / speed * ellipk(1 / half_energy),
            "top_speed": top,
            "end_tension": mass * (top**2 / length - GRAVITY),
        }
    inputs = {"length": length_text, "start": {"record": start, field: text}, "mass": "2.0"}
    return "simple", kind, name, why, inputs, results


def _near_one(complement: Any) -> Any:
    """K for a modulus so near one that the next term of its series is nothing."""
    return mp.log(4 / sqrt(complement))


def bodies() -> Iterator[Case]:
    given = [(drawn(0.5, 9), drawn(0.05, 2), drawn(0.05, 1.5), drawn(0.1, 2.9), drawn(0.0, 0.09)) for _ in range(6)]
    hard = [
        ("2.0", "1e-06", "0.3", "0.5", "0.1", "the pivot lies all but at the centre of mass"),
        (
            "2.0",
            "0.6",
            "1e-07",
            "1.0",
            "0.9999999",
            "almost all of the moment is that of the distance; near the turning point",
        ),
    ]
    for nth, row in enumerate([*((*row, "") for row in given), *hard]):
        mass_text, distance_text, gyration_text, amplitude_text, angle_text, why = row
        mass, d, k, start, at = (exact(text) for text in row[:5])
        inertia = mass * (k * k + d * d)
        small = 2 * pi * sqrt((k * k + d * d) / (d * GRAVITY))
        rate = sqrt(2 * mass * GRAVITY * d * (cos(at) - cos(start)) / inertia)
        # Newton's law for the centre: along, centripetal; across, by the angular acceleration
        across = mass * GRAVITY * sin(at) - mass * d * (mass * GRAVITY * d * sin(at) / inertia)
        inputs = {
            "mass": mass_text, "distance": distance_text, "body": {"record": "Gyration", "gyration": gyration_text},
            "amplitude": amplitude_text, "angle": angle_text,
        }  # fmt: skip
        yield (
            "compound", "hard" if why else "ordinary", f"body {nth}", why, inputs,
            {
                "small_period": small, "period": small * slow(start), "equivalent_length": (k * k + d * d) / d,
                "conjugate_distance": k * k / d, "least_period": 2 * pi * sqrt(2 * k / GRAVITY), "inertia": inertia,
                "rate": rate, "along_force": mass * GRAVITY * cos(at) + mass * d * rate**2, "across_force": across,
            },
        )  # fmt: skip
    for nth in range(4):
        inputs = {"length": drawn(0.1, 3), "mass": drawn(0.5, 9), "amplitude": drawn(0.5, 3), "angle": drawn(0, 0.49)}
        length, mass, start, at = (exact(text) for text in inputs.values())
        small = 2 * pi * sqrt(2 * length / (3 * GRAVITY))
        yield (
            "rod", "ordinary", f"rod {nth}", "", inputs,
            {
                "small_period": small, "period": small * slow(start),
                "along_force": mass * GRAVITY * (5 * cos(at) - 3 * cos(start)) / 2,
                "across_force": mass * GRAVITY * sin(at) / 4,
            },
        )  # fmt: skip


def cones() -> Iterator[Case]:
    hard = [
        ("ConeSpeed", "3.1315571207", "just above the rotation at which it hangs: the arc cosine has lost the angle"),
        ("ConeSpeed", "1000.0", "all but level: cosine and height are nearly nothing"),
        ("ConeAngle", "1e-07", "a cone so thin that its cosine is one"),
    ]
    drawn_ones = [("ConeSpeed", drawn(3.3, 12.0), "") for _ in range(4)] + [
        ("ConeAngle", drawn(0.1, 1.5), "") for _ in range(4)
    ]
    for nth, (record, text, why) in enumerate([*hard, *drawn_ones]):
        value = exact(text)
        angle = acos(GRAVITY / value**2) if record == "ConeSpeed" else value
        rotation = value if record == "ConeSpeed" else sqrt(GRAVITY / cos(value))
        disturbed = sqrt(1 + 3 * cos(angle) ** 2)
        field = "rotation" if record == "ConeSpeed" else "angle"
        inputs = {"length": "1.0", "cone": {"record": record, field: text}, "mass": "0.5"}
        yield (
            "conical", "hard" if why else "ordinary", f"{record} {nth}", why, inputs,
            {
                "angle": angle, "rotation": rotation, "period": 2 * pi / rotation, "radius": sin(angle),
                "speed": rotation * sin(angle), "height": cos(angle), "tension": mpf("0.5") * GRAVITY / cos(angle),
                "disturbance": rotation * disturbed / (2 * pi), "apsidal_angle": pi / disturbed,
            },
        )  # fmt: skip


def every() -> Iterator[Case]:
    for part in (simple, bodies, cones):
        yield from part()


if __name__ == "__main__":
    write_given("pendulum", ABOUT, every())
