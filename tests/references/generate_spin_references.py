"""Writes spin.json: gyroscopes, free bodies, tops, rotors, rods and disks to 40 digits, for ordinary and hard inputs.

Torques come from products of vectors, periods from Legendre's integral of momentum and energy, precession from roots of
polynomials; the program has products, the arithmetic–geometric mean and conjugate forms.
Run: python tests/references/generate_spin_references.py [FILE]. The same bytes every time.
"""

import random
from collections.abc import Iterator
from typing import Any

from case_files import write_given
from mpmath import acos, atan2, cos, ellipk, mp, mpf, pi, polyroots, re, sin, sqrt

mp.dps = 90
ABOUT = "Written by generate_spin_references.py: SI inputs as doubles, results to 40 digits from 90-digit arithmetic."
Case = tuple[str, str, str, str, dict[str, Any], dict[str, Any]]
RANDOM = random.Random(1758)
GRAVITY = mpf(9.80665)


def exact(text: str) -> Any:
    return mpf(float(text))


def drawn(low: float, high: float, digits: int = 3) -> str:
    return repr(round(RANDOM.uniform(low, high), digits))


def gyros() -> Iterator[Case]:
    hard = [("0.03", "0.02", "314.0", "2.0", "1e-09", "the two axes all but agree: their sine is small")]
    ordinary = [
        (drawn(0.01, 0.03, 4), drawn(0.016, 0.05, 4), drawn(10, 400), drawn(-5, 5), drawn(0.2, 2.5), "")
        for _ in range(7)
    ]
    for nth, (*texts, why) in enumerate([*hard, *ordinary]):
        inputs = dict(zip(("axial", "transverse", "spin", "precession", "angle"), texts, strict=True))
        axial, transverse, spin, turn, angle = (exact(text) for text in texts)
        # across the spin axis in the plane of both, and along it
        frame = (turn * sin(angle), turn * cos(angle))
        momentum = (transverse * frame[0], axial * (spin + frame[1]))
        results = {
            "torque": frame[0] * momentum[1] - frame[1] * momentum[0], "angular_momentum": momentum[1],
            "simple_torque": axial * spin * frame[0],
        }  # fmt: skip
        yield "gyro", "hard" if why else "ordinary", f"gyro {nth}", why, inputs, results


def bodies() -> Iterator[Case]:
    hard = [
        (
            ("1.0", "2.0", "3.0"),
            ("1e-06", "1.0", "0.0"),
            "all but about the middle axis: half a turn takes endless time",
        ),
        (("1.0", "1.000001", "2.0"), ("0.001", "1e-08", "10.0"), "all but alike in two directions"),
        (("1.0", "2.0", "3.0"), ("1e-09", "1e-09", "50.0"), "a wobble that the energy does not show"),
    ]
    ordinary = [(("1.0", "2.0", "3.0"), ("0.2", "1.0", "0.5"), "")]
    for _ in range(6):
        low, middle = drawn(1, 2), drawn(2.1, 3)
        moments = (low, middle, drawn(3.01, 3.09))
        ordinary.append((moments, (drawn(0.1, 2), drawn(0.1, 2), drawn(0.1, 2)), ""))
    for nth, (moment_texts, rate_texts, why) in enumerate([*hard, *ordinary]):
        low, middle, high = (exact(text) for text in moment_texts)
        p, q, r = (exact(text) for text in rate_texts)
        square = (low * p) ** 2 + (middle * q) ** 2 + (high * r) ** 2
        twice = low * p * p + middle * q * q + high * r * r
        first, second, third = square - twice * low, square - twice * middle, twice * high - square
        outer, inner = (high - middle) * first, (middle - low) * third
        if second < 0:
            outer, inner = inner, outer
        momentum = sqrt(square)
        results = {
            "period": 4 * ellipk(inner / outer) / sqrt(outer / (low * middle * high)),
            "angular_momentum": momentum, "energy": twice / 2,
        }  # fmt: skip
        if second > 0:
            results |= {"least_precession": momentum / middle, "greatest_precession": momentum / low}
            results["greatest_nutation"] = acos(sqrt(high * second / (high - middle)) / momentum)
            results["least_nutation"] = acos(sqrt(high * first / (high - low)) / momentum)
        else:
            results |= {"least_precession": momentum / high, "greatest_precession": momentum / middle}
            results["greatest_nutation"] = acos(sqrt(-low * second / (middle - low)) / momentum)
            results["least_nutation"] = acos(sqrt(low * third / (high - low)) / momentum)
        inputs = {"moments": list(moment_texts), "angular_velocity": list(rate_texts)}
        yield "free", "hard" if why else "ordinary", f"body {nth}", why, inputs, results


def tops() -> Iterator[Case]:
    hard = [
        ("20000000.0", "0.5", "the slow precession is a difference that loses every digit"),
        ("200.0", "1.5707", "all but level: the fast precession has no end"),
    ]
    ordinary = [(drawn(90, 900), drawn(0.1, 3.0), "") for _ in range(7)]
    for nth, (spin_text, tilt_text, why) in enumerate([*hard, *ordinary]):
        inputs = {
            "mass": "0.5", "distance": "0.06", "axial": "0.0006", "transverse": "0.0025", "spin": spin_text,
            "tilt": tilt_text,
        }  # fmt: skip
        mass, distance, axial, transverse, spin, tilt = (exact(text) for text in inputs.values())
        pull = mass * GRAVITY * distance
        roots = [re(x) for x in polyroots([transverse * cos(tilt), -axial * spin, pull], maxsteps=900, extraprec=900)]
        slow, fast = sorted(roots, key=abs)
        dips = polyroots(
            [1, -((axial * spin) ** 2) / (2 * transverse * pull),
             (axial * spin) ** 2 / (2 * transverse * pull) * cos(tilt) - 1], maxsteps=900, extraprec=900,
        )  # fmt: skip
        swing = sqrt((slow * sin(tilt)) ** 2 + (axial * spin / transverse - 2 * slow * cos(tilt)) ** 2)
        results = {
            "slow": slow, "fast": fast, "nutation": swing / (2 * pi),
            "sleeping_spin": sqrt(4 * transverse * pull) / axial,
            "lowest_tilt": acos(min(re(x) for x in dips)),
        }  # fmt: skip
        yield "top", "hard" if why else "ordinary", f"top {nth}", why, inputs, results


def shafts() -> Iterator[Case]:
    names = (
        "mass", "speed", "span", "position", "eccentricity", "skew", "axial", "transverse", "skew_direction",
    )  # fmt: skip
    for nth in range(7):
        texts = (
            drawn(1, 90), drawn(10, 400), drawn(0.2, 0.9), drawn(-0.2, 1.2), drawn(1e-5, 1e-3, 6), drawn(0.005, 0.5),
            drawn(0.1, 0.9), drawn(0.5, 0.9), drawn(-3, 3),
        )  # fmt: skip
        mass, speed, span, position, offset, skew, axial, transverse, lean = (exact(text) for text in texts)
        # a tensor along shaft, eccentricity and across both; H of a turn about the shaft, and its rate
        axis = (cos(skew), sin(skew) * cos(lean), sin(skew) * sin(lean))
        momentum = [(axial - transverse) * speed * axis[0] * part for part in axis]
        moment = (-speed * momentum[2], speed * momentum[1])
        # bearings: forces that sum to the centre's acceleration, with this moment about it
        accelerated = -mass * offset * speed**2
        right = ((position * accelerated + moment[1]) / span, -moment[0] / span)
        left = (accelerated - right[0], -right[1])
        results = {
            "force": -accelerated, "couple": sqrt(moment[0] ** 2 + moment[1] ** 2),
            "left_load": sqrt(left[0] ** 2 + left[1] ** 2), "right_load": sqrt(right[0] ** 2 + right[1] ** 2),
            "left_angle": atan2(-left[1], -left[0]), "right_angle": atan2(-right[1], -right[0]),
        }  # fmt: skip
        yield "shaft", "ordinary", f"rotor {nth}", "", dict(zip(names, texts, strict=True)), results


def rods() -> Iterator[Case]:
    hard = [
        ("4.288069495", "just above the critical speed: the angle is a small difference"),
        ("1000.0", "all but level: the cosine of the angle is nearly nothing"),
    ]
    for nth, (text, why) in enumerate([*hard, *((drawn(4.5, 30), "") for _ in range(5))]):
        speed, length = exact(text), mpf(float("0.8"))
        cosine = 3 * GRAVITY / (2 * length * speed**2)
        angle = acos(cosine)
        results = {
            "critical": sqrt(3 * GRAVITY / (2 * length)), "angle": angle, "frequency": speed * sin(angle) / (2 * pi),
            "pin_force": 2 * sqrt(GRAVITY**2 + (speed**2 * length * sin(angle) / 2) ** 2),
        }  # fmt: skip
        inputs = {"length": "0.8", "speed": text, "mass": "2.0"}
        yield "rod", "hard" if why else "ordinary", f"rod {nth}", why, inputs, results


def disks() -> Iterator[Case]:
    for nth in range(7):
        texts = {"radius": drawn(0.1, 0.9), "roll": drawn(0.1, 1.5), "lean": drawn(0.1, 1.3), "turn": drawn(0.5, 2)}
        radius, roll, lean, turn = (exact(text) for text in texts.values())
        axial, across = radius**2 / 2, radius**2 / 4
        theta, pull = pi / 2 - lean, GRAVITY * radius
        steady = across * turn**2 * sin(theta) * cos(theta) - pull * cos(theta)
        spin = abs(steady / ((axial + radius**2) * turn * sin(theta)))
        results = {
            "rolling_limit": sqrt(across * pull / (axial * (axial + radius**2))),
            "pivoting_limit": sqrt(pull / (across + radius**2)), "spin": spin, "path_radius": spin * radius / turn,
            "needed_friction": spin * radius * turn / GRAVITY,
            "growth": sqrt((pull - axial * (axial + radius**2) * roll**2 / across) / (across + radius**2)),
        }  # fmt: skip
        yield "disk", "ordinary", f"disk {nth}", "", texts, results


def every() -> Iterator[Case]:
    for part in (gyros, bodies, tops, shafts, rods, disks):
        yield from part()


if __name__ == "__main__":
    write_given("spin", ABOUT, every())
