"""Writes cam_motion.json: rise laws and whole motions to 40 digits, for ordinary and hard inputs.

Run: python tests/references/generate_cam_motion_references.py [FILE]. The same bytes every time.

The laws are made otherwise than in the program: accelerations are written down piece by piece over the whole rise and
their integrals carried from piece to piece, polynomials come from linear systems of boundary conditions, and nothing is
folded about the middle.
"""

import random
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

from case_files import put
from found_cases import found, numbered
from mpmath import cos, factorial, lu_solve, matrix, mp, mpf, pi, sin

# values near the end of a rise are differences: a tenth power of 1e-15 must keep 40 digits
mp.dps = 200
Value = tuple[Any, Any, Any, Any]
Law = Callable[[Any], Value]


def pulses(pieces: list[tuple[Any, str, int]]) -> Law:
    """A law from its acceleration: (length, kind, sign) pieces; kinds rise, flat, fall, none, up and down (ramps)."""

    def accelerate(kind: str, length: Any, t: Any) -> Value:
        """Third, second, first and zeroth integral-wise: (s, v, a, j) gained from rest at a local place."""
        w = pi / (2 * length) if length else mpf(0)
        if kind == "rise":
            return t / w - sin(w * t) / w**2, (1 - cos(w * t)) / w, sin(w * t), w * cos(w * t)
        if kind == "fall":
            return (1 - cos(w * t)) / w**2, sin(w * t) / w, cos(w * t), -w * sin(w * t)
        if kind == "flat":
            return t * t / 2, t, mpf(1), mpf(0)
        if kind == "up":
            return t**3 / (6 * length), t * t / (2 * length), t / length, 1 / length
        if kind == "down":
            return t * t / 2 - t**3 / (6 * length), t - t * t / (2 * length), 1 - t / length, -1 / length
        return mpf(0), mpf(0), mpf(0), mpf(0)

    def raw(x: Any) -> Value:
        s = v = a = j = mpf(0)
        start = mpf(0)
        for index, (length, kind, sign) in enumerate(pieces):
            last = index == len(pieces) - 1
            t = x - start if last else min(x - start, length)
            ds, dv, a, j = (sign * part for part in accelerate(kind, length, t))
            s, v = s + v * t + ds, v + dv
            start += length
            if x < start or last:
                break
        return s, v, a, j

    whole = raw(mpf(1))[0]
    return lambda x: tuple(part / whole for part in raw(x))  # type: ignore[return-value]


def scca(b: Any, c: Any, d: Any, constant: Any = 0) -> Law:
    q = (1 - mpf(constant)) / 2
    first = [(mpf(b) * q, "rise", 1), (mpf(c) * q, "flat", 1), (mpf(d) * q, "fall", 1), (mpf(constant) / 2, "none", 1)]
    mirror = {"rise": "fall", "fall": "rise", "flat": "flat", "none": "none"}
    second = [(length, mirror[kind], -1) for length, kind, _ in reversed(first)]
    return pulses([piece for piece in first + second if piece[0]])


def polynomial(conditions: list[tuple[Any, int, Any]]) -> Law:
    n = len(conditions)
    system, right = matrix(n, n), matrix(n, 1)
    for row, (x, order, value) in enumerate(conditions):
        for i in range(order, n):
            system[row, i] = factorial(i) / factorial(i - order) * mpf(x) ** (i - order)
        right[row] = value
    with mp.workdps(240):
        c = lu_solve(system, right)

    def law(x: Any) -> Value:
        return tuple(  # type: ignore[return-value]
            sum(c[i] * factorial(i) / factorial(i - order) * x ** (i - order) for i in range(order, n))
            for order in range(4)
        )

    return law


def rest_to_rest(degree: int) -> Law:
    orders = range((degree + 1) // 2)
    return polynomial([(0, k, 0) for k in orders] + [(1, k, 1 if k == 0 else 0) for k in orders])


def sines(*terms: tuple[int, Any]) -> Law:
    """x − Σ A sin 2πkx."""

    def law(x: Any) -> Value:
        return (
            x - sum(a * sin(2 * pi * k * x) for k, a in terms),
            1 - sum(a * 2 * pi * k * cos(2 * pi * k * x) for k, a in terms),
            sum(a * (2 * pi * k) ** 2 * sin(2 * pi * k * x) for k, a in terms),
            sum(a * (2 * pi * k) ** 3 * cos(2 * pi * k * x) for k, a in terms),
        )

    return law


def double_harmonic(x: Any) -> Value:
    u = pi * x
    return (
        ((1 - cos(u)) - (1 - cos(2 * u)) / 4) / 2,
        pi / 2 * (sin(u) - sin(2 * u) / 2),
        pi**2 / 2 * (cos(u) - cos(2 * u)),
        pi**3 / 2 * (2 * sin(2 * u) - sin(u)),
    )


def trapezoid() -> Law:
    eighth, quarter = mpf(1) / 8, mpf(1) / 4
    return pulses(
        [(eighth, "up", 1), (quarter, "flat", 1), (eighth, "down", 1), (eighth, "up", -1), (quarter, "flat", -1)]
        + [(eighth, "down", -1)]
    )


M = mpf(1125) / 1192
LAWS: dict[str, Law] = {
    "linear": lambda x: (x, mpf(1), mpf(0), mpf(0)),
    "parabolic": scca(0, 1, 0),
    "cubic": rest_to_rest(3),
    "harmonic": lambda x: (
        (1 - cos(pi * x)) / 2, pi / 2 * sin(pi * x), pi**2 / 2 * cos(pi * x), -(pi**3) / 2 * sin(pi * x)
    ),
    "double-harmonic": double_harmonic,
    "cycloidal": sines((1, 1 / (2 * pi))),
    "modified-trapezoid": scca(mpf(1) / 4, mpf(1) / 2, mpf(1) / 4),
    "modified-sine": scca(mpf(1) / 4, 0, mpf(3) / 4),
    "trapezoid": trapezoid(),
    "3-4-5": rest_to_rest(5),
    "4-5-6-7": rest_to_rest(7),
    "5-6-7-8-9": rest_to_rest(9),
    "gutman-1-3": sines((1, 15 / (32 * pi)), (3, 1 / (96 * pi))),
    "freudenstein-1-3": sines((1, mpf(27) / 28 / (2 * pi)), (3, 1 / (2 * pi) / 84)),
    "freudenstein-1-3-5": sines((1, M / (2 * pi)), (3, M / (2 * pi) / 54), (5, M / (2 * pi) / 1250)),
    "modified-constant-velocity": scca(mpf(1) / 4, 0, mpf(3) / 4, mpf(1) / 2),
    "half-cycloid-start": lambda x: (x - sin(pi * x) / pi, 1 - cos(pi * x), pi * sin(pi * x), pi**2 * cos(pi * x)),
    "half-cycloid-end": lambda x: (x + sin(pi * x) / pi, 1 + cos(pi * x), -pi * sin(pi * x), -(pi**2) * cos(pi * x)),
    "half-harmonic-start": lambda x: (
        1 - cos(pi * x / 2), pi / 2 * sin(pi * x / 2), pi**2 / 4 * cos(pi * x / 2), -(pi**3) / 8 * sin(pi * x / 2)
    ),
    "half-harmonic-end": lambda x: (
        sin(pi * x / 2), pi / 2 * cos(pi * x / 2), -(pi**2) / 4 * sin(pi * x / 2), -(pi**3) / 8 * cos(pi * x / 2)
    ),
}  # fmt: skip

ENDS = {
    "within 1e-9 of the start of {0}, where differences such as x − sin x lose all digits": 1e-9,
    "within 1e-9 of the end of {0}, where 1 − f must keep digits that x has lost": 1.0 - 1e-9,
    "within 1e-15 of the end of {0}: four units in the last place of the share, which rule its jerk": 1.0 - 1e-15,
}
DERIVATIVES = ("lift", "velocity", "acceleration", "jerk")


def text(value: Any) -> str:
    # what 200 digits leave of a zero is none; nothing here is truly so small
    return mp.nstr(value, 40) if abs(value) > mpf(10) ** -120 else "0.0"


def rise_case(kind: str, name: str, why: str, law: Law, inputs: dict[str, Any]) -> dict[str, Any]:
    lift, span, at = (mpf(inputs[key]) for key in ("lift", "span", "at"))
    values = law(at / span)
    results = {key: text(lift * values[k] / span**k) for k, key in enumerate(DERIVATIVES)}
    written = {key: repr(value) if isinstance(value, float) else value for key, value in inputs.items()}
    return {"task": "rise", "kind": kind, "name": name, "why": why, "inputs": written, "results": results}


def rises(generator: random.Random) -> list[dict[str, Any]]:
    cases = []
    for name, law in LAWS.items():
        for number in range(6):
            lift, span = round(generator.uniform(1e-3, 0.05), 5), generator.uniform(0.2, 3.0)
            inputs = {"law": name, "lift": lift, "span": span, "at": span * generator.random()}
            cases.append(rise_case("ordinary", f"{name} {number + 1}", "", law, inputs))
        for why, share in ENDS.items():
            inputs = {"law": name, "lift": 0.02, "span": 1.5707963267948966, "at": 1.5707963267948966 * share}
            cases.append(rise_case("hard", f"{name} at {share!r}", why.format(name), law, inputs))
    hard: list[tuple[str, str, Law, dict[str, Any]]] = []
    for at in (1e-15, 2.5e-7, 5e-7, 9.99999e-7):
        inputs = {"law": "cycloidal", "lift": 0.02, "span": 1e-6, "at": at}
        why = "2 cm in a millionth of a radian: a jerk of 1e17 m/rad³, and a share known to the rounding of the angle"
        hard.append((f"span of 1e-6 rad at {at}", why, LAWS["cycloidal"], inputs))
    for b in (1e-6, 1e-12):
        shares = [b, 0.5, 0.5 - b]
        inputs = {"law": "scca", "shares": [repr(x) for x in shares], "lift": 0.02, "span": 1.0, "at": 0.3}
        why = f"a sine over {b:g} of the rise beside a constant acceleration: a quotient of two vanishing numbers"
        hard.append((f"scca with b = {b}", why, scca(*shares), inputs))
    for constant in (0.999, 1e-9):
        inputs = {
            "law": "modified-constant-velocity",
            "constant": repr(constant),
            "lift": 0.02,
            "span": 1.0,
            "at": 0.0004,
        }
        why = f"constant velocity over {constant:g} of the rise: the pieces of sine are what is left of it"
        law = scca(mpf(1) / 4, 0, mpf(3) / 4, mpf(constant))
        hard.append((f"constant velocity for {constant}", why, law, inputs))
    hard.append(
        ("at the joint of the modified trapezoid",
         "the very joint of ramp and constant acceleration: both formulas must give the same, jerk that of one side",
         LAWS["modified-trapezoid"],
         {"law": "modified-trapezoid", "lift": 0.02, "span": 1.0, "at": 0.125})
    )  # fmt: skip
    hard.append(
        ("just past the middle",
         "one unit in the last place past the middle, where the fold changes sides and acceleration passes zero",
         LAWS["4-5-6-7"],
         {"law": "4-5-6-7", "lift": 0.02, "span": 1.0, "at": 0.5000000000000001})
    )  # fmt: skip
    return cases + [rise_case("hard", name, why, law, inputs) for name, why, law, inputs in hard]


def free_polynomials(generator: random.Random) -> list[dict[str, Any]]:
    cases = []
    for number in range(8):
        kind = "hard" if number % 2 else "ordinary"
        orders = range(1 + (number + 1) // 2)
        conditions = [(0.0, 0, 0.0), (1.0, 0, 1.0)]
        conditions += [(x, k, round(generator.uniform(-3, 3), 2)) for k in orders if k for x in (0.0, 1.0)]
        if number in (3, 5):
            conditions += [(0.5, 0, 0.55), (0.25, 1, 0.7)]
        conditions = conditions[:10]
        at = 1.0 - 1e-9 if kind == "hard" else round(generator.random(), 3)
        degree = len(conditions) - 1
        why = f"of degree {degree}, a billionth before its end: expanded about zero it loses its digits"
        values = polynomial(conditions)(mpf(at))
        cases.append(
            {
                "task": "polynomial",
                "kind": kind,
                "name": f"degree {degree}, at {at!r}",
                "why": why if kind == "hard" else "",
                "inputs": {"conditions": [[repr(x), k, repr(v)] for x, k, v in conditions], "at": repr(at)},
                "results": {key: text(values[k]) for k, key in enumerate(DERIVATIVES)},
            }
        )
    return cases


Segment = tuple[str, int, int, str]
PROGRAMS: dict[str, list[Segment]] = {
    "rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell": [
        ("0.02", 0, 90, "cycloidal"), ("0", 90, 150, ""), ("-0.02", 150, 240, "3-4-5"), ("0", 240, 360, ""),
    ],
    "rise 12.7 mm in 33.3 deg modified sine; dwell 0.001 deg; return in 77 deg 4-5-6-7; dwell": [
        ("0.0127", 0, 33300, "modified-sine"), ("0", 33300, 33301, ""), ("-0.0127", 33301, 110301, "4-5-6-7"),
        ("0", 110301, 360000, ""),
    ],
    "rise 5 mm in 0.0001 deg 3-4-5; dwell 300 deg; return in 10 deg modified trapezoid; dwell": [
        ("0.005", 0, 1, "3-4-5"), ("0", 1, 3000001, ""), ("-0.005", 3000001, 3100001, "modified-trapezoid"),
        ("0", 3100001, 3600000, ""),
    ],
    "dwell 200 deg; rise 5 mm in 0.0001 deg 3-4-5; dwell 100 deg; return in 33.3 deg cycloidal; dwell": [
        ("0", 0, 2000000, ""), ("0.005", 2000000, 2000001, "3-4-5"), ("0", 2000001, 3000001, ""),
        ("-0.005", 3000001, 3333001, "cycloidal"), ("0", 3333001, 3600000, ""),
    ],
}  # fmt: skip


def _joint(segment: Segment, number: int) -> str:
    side = "after the start" if number % 2 else "before the end"
    return f"a billionth of the span {side} of {segment[3]}: the rounding of the angle shows in the share that is left"


def motions(generator: random.Random) -> list[dict[str, Any]]:
    cases = []
    for program, segments in PROGRAMS.items():
        whole = mpf(segments[-1][2])
        for number in range(10):
            moves = [segment for segment in segments if segment[3]]
            chosen = generator.choice([0, 1])
            # hard ones take turns: each end of each move once
            segment = moves[chosen if number < 6 else number // 2 % 2]
            start, end = (2 * pi * mpf(edge) / whole for edge in segment[1:3])
            place = mpf(generator.random())
            hard = number >= 6
            if hard:
                place = mpf("1e-9") if number % 2 else 1 - mpf("1e-9")
            theta = float(start + (end - start) * place)
            base = sum((mpf(float(other[0])) for other in segments[: segments.index(segment)]), mpf(0))
            values = LAWS[segment[3]]((mpf(theta) - start) / (end - start))
            rise = mpf(float(segment[0]))
            results = {key: text(rise * values[k] / (end - start) ** k) for k, key in enumerate(DERIVATIVES)}
            results["lift"] = text(base + rise * values[0])
            cases.append(
                {
                    "task": "motion",
                    "kind": "hard" if hard else "ordinary",
                    "name": f"{segment[3]} in {program[:24]}… {number + 1}",
                    "why": _joint(segment, number) if hard else "",
                    "inputs": {"program": program, "theta": repr(theta), "lift": segment[0].lstrip("-"),
                               "span": repr(float(end - start)), "law": segment[3]},
                    "results": results,
                }
            )  # fmt: skip
    return cases


def searched() -> list[dict[str, Any]]:
    """The worst that the search for broken bounds has found."""
    cases = []
    for case in found("cam_motion.json"):
        inputs = {key: value if key == "law" else float(value) for key, value in case["inputs"].items()}
        cases.append(rise_case("hard", case["name"], case["why"], LAWS[inputs["law"]], inputs))
    return cases


def main() -> None:
    generator = random.Random(16_13)
    cases = numbered(rises(generator) + free_polynomials(generator) + motions(generator) + searched())
    put("cam_motion", "Written by generate_cam_motion_references.py: SI inputs, 40-digit results.", cases)


if __name__ == "__main__":
    main()
