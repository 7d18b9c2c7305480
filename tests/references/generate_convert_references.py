"""Writes convert.json: conversions by exact rationals from the units' legal definitions, to 40 digits.

The definitions are written here by hand (the inch is 25.4 mm, the pound 0.45359237 kg, …) and share nothing with the
program's table. Run: python tests/references/generate_convert_references.py [FILE]. The same bytes every time.
"""

import random
import sys
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from case_files import put
from found_cases import found
from mpmath import mp, mpf

INCH, POUND, G = Fraction("0.0254"), Fraction("0.45359237"), Fraction("9.80665")
FOOT, MILE = 12 * INCH, 63360 * INCH
# Units of one kind: SI factor, power of π, zero in SI.
KINDS: dict[str, dict[str, tuple[Fraction, int, Fraction]]] = {
    kind: {name: (Fraction(factor), pi, Fraction(zero)) for name, factor, pi, zero in units}
    for kind, units in {
        "length": [("m", 1, 0, 0), ("ft", FOOT, 0, 0), ("in", INCH, 0, 0), ("mile", MILE, 0, 0), ("mm", "0.001", 0, 0)],
        "speed": [("m/s", 1, 0, 0), ("mph", MILE / 3600, 0, 0), ("km/h", "5/18", 0, 0), ("ft/s", FOOT, 0, 0),
                  ("knot", "463/900", 0, 0)],
        "force": [("N", 1, 0, 0), ("lbf", POUND * G, 0, 0), ("kgf", G, 0, 0), ("kN", 1000, 0, 0)],
        "pressure": [("Pa", 1, 0, 0), ("psi", POUND * G / INCH**2, 0, 0), ("bar", 10**5, 0, 0), ("atm", 101325, 0, 0)],
        "power": [("W", 1, 0, 0), ("hp", 550 * FOOT * POUND * G, 0, 0), ("kW", 1000, 0, 0)],
        "inertia": [("kg*m^2", 1, 0, 0), ("slug*ft^2", POUND * G * FOOT, 0, 0), ("lb*in^2", POUND * INCH**2, 0, 0)],
        "angle": [("rad", 1, 0, 0), ("deg", "1/180", 1, 0), ("rev", 2, 1, 0)],
        "angular velocity": [("rad/s", 1, 0, 0), ("rpm", "1/30", 1, 0), ("deg/s", "1/180", 1, 0)],
        "temperature": [("K", 1, 0, 0), ("degC", 1, 0, "273.15"), ("degF", "5/9", 0, Fraction(45967, 180))],
    }.items()
}  # fmt: skip
HARD = {
    "0.1": "a tenth is no double: read as one before it is converted it is off in its 17th digit",
    "1e300": "near the largest double: a product on the way to SI may overflow though the result does not",
    "3.3e-300": "near the smallest double: a product on the way to SI may lose its digits though the result has them",
    "9007199254740993": "more digits than a double holds: as a double it is even, and off by one",
    "-40": "a negative number: what rounds to the nearest must not round towards zero",
    "1.0000000000000002": "one unit in the last place above one: a factor rounded first hides it",
}
COLD = "forty below, where both scales meet: offsets of 273.15 and 459.67 cancel, and the result must be exact"
DEGREES = {
    "0.1": "a tenth of a degree beside an offset of hundreds: as a double it is not the decimal written",
    "1e300": "so large that the offset is lost beside it, and must be",
    "3.3e-300": "so small that nothing but the offset is left, correctly rounded",
}


# What other converters are known to print wrongly.
KNOWN = (
    ("98.6", "degF", "degC", "exactly 37: five ninths and the offset in doubles leave 37.00000000000006"),
    ("25", "degC", "degF", "exactly 77: nine fifths and the offset in doubles leave 76.99999999999993"),
    ("60", "mph", "ft/s", "exactly 88: a factor of 28 decimal digits leaves two units of the 26th"),
    ("1", "lbf", "N", "exactly 4.4482216152605: the double nearest to it, not to a product of rounded factors"),
    ("1e308", "km/h", "m/s", "within a factor of two of the largest double: a product by 1000 first overflows"),
    ("5e-308", "m/s", "km/h", "next to the smallest normal double: a quotient by 3600 first loses its digits"),
)


def reason(value: str, source: str, kind: str) -> str:
    """Why a value is hard to convert."""
    if kind == "temperature":
        return (
            (COLD if source != "K" else "below absolute zero, yet a number to convert: offsets do not cancel")
            if (value == "-40")
            else DEGREES.get(value, HARD[value])
        )
    return HARD[value]


def converted(value: str, source: str, target: str, kind: str, reach: int = 300) -> str | None:
    """The result to 40 digits; None where it has more than so many decimal orders."""
    (a, p, zero), (b, q, origin) = KINDS[kind][source], KINDS[kind][target]
    exact = (Fraction(value) * a + zero - origin) / b
    number = mpf(exact.numerator) / exact.denominator * mp.pi ** (p - q)
    if number != 0 and not mpf(10) ** -reach < abs(number) < mpf(10) ** reach:
        return None
    return mp.nstr(number, 40)


def main() -> None:
    mp.dps = 60
    rng = random.Random(7)
    lines = []
    for kind, units in KINDS.items():
        pairs = [(a, b) for a in units for b in units if a != b]
        for source, target in pairs:
            plain = f"{rng.choice([rng.uniform(0.1, 100), rng.randint(1, 500), rng.uniform(1, 9) * 1e4]):.6g}"
            values = [(plain, "")] + [(value, reason(value, source, kind)) for value in rng.sample(list(HARD), 2)]
            for value, why in values:
                expected = converted(value, source, target, kind)
                if expected is None:
                    continue
                case = {"task": "convert", "kind": "hard" if why else "ordinary"}
                case |= {"name": f"{value} {source} to {target}", **({"why": why} if why else {})}
                inputs = {"value": value, "from": source, "to": target}
                lines.append({**case, "inputs": inputs, "results": {"value": expected}})
    for value, source, target, why in KNOWN:
        kind = next(kind for kind, units in KINDS.items() if source in units)
        case = {"task": "convert", "kind": "hard", "name": f"{value} {source} to {target}", "why": why}
        inputs = {"value": value, "from": source, "to": target}
        results = {"value": converted(value, source, target, kind, 308)}
        lines.append({**case, "inputs": inputs, "results": results})
    for worst in found("convert.json"):
        inputs = worst["inputs"]
        kind = next(kind for kind, units in KINDS.items() if inputs["from"] in units)
        results = {"value": converted(inputs["value"], inputs["from"], inputs["to"], kind)}
        own = {key: worst[key] for key in ("name", "why", "inputs")}
        lines.append({"task": "convert", "kind": "hard", **own, "results": results})
    about = "Written by generate_convert_references.py: exact rationals (and π to 60 digits), results to 40 digits."
    put("convert", about, lines)


if __name__ == "__main__":
    main()
