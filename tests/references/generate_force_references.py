"""Writes tests/force/force.json: resultants, wrenches and reactions of 30 digits.

Plain fractions of the decimals, and of another form than the program's: moments are added about a far point and brought
back, the axis comes from two equations of its points solved by Cramer's rule, reactions from Cramer's rule with
determinants by permutations. Roots by mpmath.

Run: python tests/references/generate_force_references.py [FILE]. The same bytes every time.
"""

import json
import random
import sys
from fractions import Fraction
from itertools import permutations
from pathlib import Path

from mpmath import atan, cos, mp, mpf, nstr, pi, sin, sqrt, tan

mp.dps = 60
FILE = Path(__file__).resolve().parents[1] / "force" / "force.json"
FAR = (Fraction(17), Fraction(-31), Fraction(7, 3))

SYSTEMS = {
    "two forces across": ([("1 0 0", "0 0 0"), ("0 1 0", "0 0 1")], []),
    "decimals that cancel to a couple": (
        [("0.1 0 0", "0 0 0"), ("0.2 0 0", "0 1 0"), ("-0.3 0 0", "0 2 0")], []),
    "three and a couple": (
        [("10 -4 3", "1 2 -1"), ("-6 8 2", "-2 0.5 3"), ("1 1 -9", "0 -1 1.5")], ["2 -3 0.5"]),
    "cancellation of nine digits": (
        [("123456.789 -98765.4321 55555.5555", "0.3 0.7 0.2"), ("-123456.788 98765.4322 -55555.5554", "1.1 -0.4 0.9"),
         ("-0.0011 -0.0002 -0.0002", "0.5 0.5 -0.25")], []),
    "large and small": (
        [("1e8 0 0", "0 1 0"), ("-1e8 0 0", "0 -1 2"), ("0 1e-6 0", "1 0 0"), ("0 0 2e-6", "3 0 5")], []),
    "sides of a triangle": ([("4 0 0", "0 0 0"), ("-3 3 0", "4 0 0"), ("-1 -3 0", "1 3 0")], []),
    "single force": ([("3 4 0", "1 0 0"), ("-1 2 0", "0 2 0")], ["0 0 5"]),
}  # fmt: skip
SUPPORTED = {
    "pin and roller at 120 degrees to 15 digits": (
        [("0 -1000 0", "2 0 0"), ("300 0 0", "4 1 0")],
        [("pin", "0 0 0", "0 1 0"), ("roller", "5 0 0", "-0.5 0.866025403784439 0")]),
    "three links that nearly meet": (
        [("100 0 0", "3 0 0")],
        [("link", "0 0 0", "0.6 0.8 0"), ("link", "3 0 0", "0 1 0"), ("link", "6.000000001 0 0", "-0.6 0.8 0")]),
    "guide and link": (
        [("30 -70 0", "0.3 0.2 0")],
        [("guide", "0 0 0", "0.28 0.96 0"), ("link", "1 1 0", "0.6 -0.8 0")]),
}  # fmt: skip


def numbers(text):
    return tuple(Fraction(part) for part in text.split())


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def plus(*those):
    return tuple(map(sum, zip(*those, strict=True)))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b, strict=True))


def determinant(rows):
    total = Fraction(0)
    for order in permutations(range(len(rows))):
        sign = 1
        for i in range(len(order)):
            for j in range(i):
                sign = -sign if order[j] > order[i] else sign
        product = Fraction(sign)
        for row, column in zip(rows, order, strict=True):
            product *= row[column]
        total += product
    return total


def cramer(rows, right):
    whole = determinant(rows)
    return [
        determinant([[*row[:k], value, *row[k + 1 :]] for row, value in zip(rows, right, strict=True)]) / whole
        for k in range(len(rows))
    ]


def text(value):
    number = mpf(value.numerator) / value.denominator if isinstance(value, Fraction) else value
    return nstr(number, 30, min_fixed=1, max_fixed=0)


def summed(loads, couples):
    force = plus(*(numbers(f) for f, _ in loads))
    about_far = plus(*(cross(minus(numbers(p), FAR), numbers(f)) for f, p in loads), *map(numbers, couples), (0, 0, 0))
    return force, plus(about_far, cross(FAR, force))


def resultant(loads, couples):
    """The axis: points r with R·r = 0 and M − r × R along R, two rows of which are independent of R."""
    force, moment = summed(loads, couples)
    square = sum(x * x for x in force)
    out = {"force": list(map(text, force)), "moment": list(map(text, moment))}
    if not square:
        return out | {"system": "couple" if any(moment) else "zero: in equilibrium"}
    power = sum(x * y for x, y in zip(force, moment, strict=True))
    pitch = power / square
    rest = minus(moment, tuple(pitch * x for x in force))
    rows = [(0, force[2], -force[1]), (-force[2], 0, force[0]), (force[1], -force[0], 0)]
    for pick in ((0, 1), (0, 2), (1, 2)):
        chosen = [rows[pick[0]], rows[pick[1]], force]
        if determinant(chosen):
            point = cramer(chosen, [rest[pick[0]], rest[pick[1]], Fraction(0)])
            break
    out |= {"system": "wrench" if power else "single force", "axis_point": list(map(text, point))}
    root = sqrt(mpf(square.numerator) / square.denominator)
    if power:
        out |= {"pitch": text(pitch), "wrench_moment": text(mpf(power.numerator) / power.denominator / root)}
    return out | {"magnitude": text(root)}


def reactions(loads, supports):
    """Forces along x, y and the couple of each support in the plane."""
    columns, owner = [], []
    for index, (kind, at, way) in enumerate(supports):
        x, y, _ = numbers(at)
        u, v, _ = numbers(way)
        lines = {"pin": [(1, 0, -y), (0, 1, x)], "fixed": [(1, 0, -y), (0, 1, x), (0, 0, 1)],
                 "guide": [(u, v, x * v - y * u), (0, 0, 1)]}.get(kind, [(u, v, x * v - y * u)])  # fmt: skip
        columns += lines
        owner += [index] * len(lines)
    force, moment = summed(loads, [])
    load = (force[0], force[1], moment[2])
    found = cramer([list(row) for row in zip(*columns, strict=True)], [-value for value in load])
    out = []
    for index in range(len(supports)):
        mine = [(c, value) for c, o, value in zip(columns, owner, found, strict=True) if o == index]
        out.append([text(sum((c[k] * value for c, value in mine), Fraction(0))) for k in (0, 1)])
    return out


def drawn():
    """Systems of random decimals."""
    rng = random.Random(6)

    def some(span):
        return " ".join(f"{rng.uniform(-span, span):.{rng.randrange(4)}f}" for _ in range(3))

    return {
        f"drawn {n}": ([(some(200), some(3)) for _ in range(rng.randrange(2, 7))], [some(40)] * (n % 2))
        for n in range(12)
    }


def bounded():
    """Calls whose numbers are doubles exactly, with results from other forms: chords and roots for springs, moments
    about the edges of the base for blocks."""
    out = []
    for end, free, stiffness in (("1 1e-8", "1", "1048576"), ("3 4", "5.25", "1024"), ("0.5 0", "0.25", "4096")):
        x, y = map(mpf, end.split())
        stretch = sqrt(x * x + y * y) - mpf(free)
        ends = ", ".join(end.split())
        sizes = f'--free-length "{free} m" --stiffness "{stiffness} N/m"'
        call = f'spring --first-end "0, 0 m" --second-end "{ends} m" {sizes}'
        pull = mpf(stiffness) * stretch
        out.append({"call": call, "results": {"tension": text(pull), "energy": text(pull * stretch / 2)}})
    for angle, friction, push, height in (
        ("0.25", "0.5", "64", "0.125"),
        ("0.25", "2", "-16", "1.5"),
        ("-0.5", "1", "8", "1"),
    ):
        weight = mpf(16) * mpf("9.8125")
        down, normal = weight * sin(mpf(angle)), weight * cos(mpf(angle))
        at = mpf(height)
        # about the uphill and the downhill edge of a base of 0.5 m, the centre 0.75 m above it
        uphill, downhill = (mpf("0.75") * down + side * normal / 4 for side in (1, -1))
        results = {
            "largest_push": text(min(uphill / at, down + mpf(friction) * normal)),
            "least_push": text(max(downhill / at, down - mpf(friction) * normal)),
            "needed_friction": text(abs(tan(mpf(angle)) - mpf(push) / normal)),
        }
        call = (
            f'friction --mass "16 kg" --angle "{angle} rad" --friction {friction} --width "0.5 m" '
            f'--centre-height "0.75 m" --push "{push} N" --push-height "{height} m" --gravity "9.8125 m/s^2"'
        )
        out.append({"call": call, "results": results})
    share = mpf(6371000) / mpf(6771000)
    out.append({"call": 'gravity --mass "80 kg" --altitude "400000 m" --gravity "9.8125 m/s^2"',
                "results": {"force": text(80 * mpf("9.8125") * share * share)}})  # fmt: skip
    # one spring behind another: both pull alike, and their stretches add up to an eighth of a metre
    first, second, stretch = mpf(1024), mpf(3072), mpf("0.125")
    pull = stretch * first * second / (first + second)
    call = 'spring --length "1.125 m" --free-length "1 m" --stiffness "1024, 3072 N/m" --group series'
    out.append({"call": call, "results": {"tension": text(pull), "stiffness": text(pull / stretch)}})
    return out + wedges() + screws()


def wedges():
    """Forces across and along every face, from the four equations of equilibrium with friction at its limit."""
    out = []
    for angle, face, ground, guide in (("0.125", "0.25", "0.25", "0"), ("0.5", "0.125", "0.375", "0.25")):
        load, turn, mu, base, side = mpf(1000), mpf(angle), mpf(face), mpf(ground), mpf(guide)
        # driven in: the load rises
        across, along = sin(turn) + mu * cos(turn), cos(turn) - mu * sin(turn)
        normal = load / (along - side * across)
        results = {"drive": text(normal * (across + base * along)), "face_force": text(normal * sqrt(1 + mu * mu))}
        results["efficiency"] = text(load * tan(turn) / (normal * (across + base * along)))
        # let go: the load sinks, and leans on the guide of either side
        across, along = sin(turn) - mu * cos(turn), cos(turn) + mu * sin(turn)
        normal = load / (along + side * abs(across))
        results["release"] = text(normal * (base * along - across))
        call = (
            f'wedge --load "1000 N" --angle "{angle} rad" --friction {face} --ground-friction {ground} '
            f"--guide-friction {guide}"
        )
        out.append({"call": call, "results": results})
    return out


def screws():
    """Torques by the angles of lead and of friction, as on an inclined plane."""
    out = []
    load, mean, pitch = mpf(4096), mpf("0.03125"), mpf("0.00390625")
    for starts, friction, flank, collar in ((1, "0.125", "0.25", "0.0625"), (4, "0.0625", "0.5", "0.125")):
        lead = starts * pitch
        rise, grip = atan(lead / (pi * mean)), atan(mpf(friction) / cos(mpf(flank)))
        held = load * mpf(collar) * mpf("0.0625") / 2
        raising = load * mean / 2 * tan(rise + grip) + held
        results = {
            "raising_torque": text(raising),
            "lowering_torque": text(load * mean / 2 * tan(grip - rise) + held),
            "efficiency": text(load * lead / (2 * pi * raising)),
            "lead_angle": text(rise),
            "locking_friction": text(tan(rise) * cos(mpf(flank))),
        }
        call = (
            f'screw --load "4096 N" --flank-angle "{flank} rad" --mean-diameter "0.03125 m" --pitch "0.00390625 m" '
            f'--starts {starts} --friction {friction} --collar-diameter "0.0625 m" --collar-friction {collar}'
        )
        out.append({"call": call, "results": results})
    metric = mpf("0.0625") - 3 * sqrt(mpf(3)) / 8 * pitch
    call = 'screw --load "4096 N" --thread metric --diameter "0.0625 m" --pitch "0.00390625 m" --friction 0.125'
    torque = load * metric / 2 * tan(atan(pitch / (pi * metric)) + atan(mpf("0.125") / (sqrt(mpf(3)) / 2)))
    out.append({"call": call, "results": {"mean_diameter": text(metric), "raising_torque": text(torque)}})
    return out


def main(file=FILE):
    systems = [
        {"name": name, "loads": loads, "couples": couples, "results": resultant(loads, couples)}
        for name, (loads, couples) in (SYSTEMS | drawn()).items()
    ]
    held = [
        {"name": name, "loads": loads, "supports": supports, "reactions": reactions(loads, supports)}
        for name, (loads, supports) in SUPPORTED.items()
    ]
    file.write_text(
        json.dumps({"systems": systems, "supported": held, "bounded": bounded()}, indent=1) + "\n", encoding="utf-8"
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else FILE)
