"""Writes coords.json: points in the other systems of coordinates, to 40 digits.

Angles come from arc cosines at 1,400 digits and from the argument of a complex exponential; the program uses atan2.
Run: python tests/references/generate_coords_references.py [FILE]. The same bytes every time.
"""

import math
import random
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

from case_files import put
from found_cases import found
from mpmath import mp, mpf

DIGITS = 1400
Point = tuple[float, float, float]


def between(along: Any, whole: Any, side: Any) -> Any:
    """The angle from an axis of a vector with a component along it, on the positive or negative side."""
    if whole == 0:
        return mpf(0)
    angle = mp.acos(along / whole)
    return -angle if side < 0 else angle


def principal(theta: Any, off_axis: Any) -> Any:
    """Within (−π, π]; −180 degrees, which reads as the double nearest −π, is 180 degrees; on the axis, 0."""
    if off_axis == 0:
        return mpf(0)
    return theta + 2 * mp.pi if theta == -mpf(PI) else mp.arg(mp.expj(theta))


def from_cartesian(x: Any, y: Any, z: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    r, rho = mp.sqrt(x * x + y * y), mp.sqrt(x * x + y * y + z * z)
    theta = between(x, r, y)
    return {"r": r, "theta": theta, "z": z}, {"rho": rho, "phi": between(z, rho, 1), "theta": theta}


def from_cylindrical(r: Any, theta: Any, z: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    turned = r * mp.expj(theta)
    rho = mp.sqrt(r * r + z * z)
    spherical = {"rho": rho, "phi": between(z, rho, 1), "theta": principal(theta, r)}
    return {"x": turned.real, "y": turned.imag, "z": z}, spherical


def from_spherical(rho: Any, phi: Any, theta: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    meridian = rho * mp.expj(phi)
    r, z = meridian.imag, meridian.real
    turned = r * mp.expj(theta)
    return {"x": turned.real, "y": turned.imag, "z": z}, {"r": r, "theta": principal(theta, r), "z": z}


SOURCES = {
    "cartesian": (("x", "y", "z"), from_cartesian, ("cylindrical", "spherical")),
    "cylindrical": (("r", "theta", "z"), from_cylindrical, ("cartesian", "spherical")),
    "spherical": (("rho", "phi", "theta"), from_spherical, ("cartesian", "cylindrical")),
}
PI = 3.141592653589793
TINY, LEAST, HUGE = 1e-300, 5e-324, 1e300


def apart(point: Point) -> str:
    """Why a point is hard whose components are of any size."""
    low, high = (round(math.log10(pick(map(abs, point)))) for pick in (min, max))
    return f"components from 1e{low:+d} to 1e{high:+d}: squares leave the range of doubles, and small ones are lost"


def cartesian(generator: random.Random) -> Iterator[tuple[str, Point]]:
    for _ in range(20):
        x, y, z = (generator.uniform(-10.0, 10.0) for _ in range(3))
        yield "", (x, y, z)
    for _ in range(20):
        x, y, z = (generator.choice((-1, 1)) * 10.0 ** generator.uniform(-300, 300) for _ in range(3))
        yield apart((x, y, z)), (x, y, z)
    yield from (("", point) for point in [(3.0, 1.0, 4.0), (1.0, 2.0, 5.0)])
    yield from [
        ("the origin: no angle is determined, and a quotient for one is zero over zero", (0.0, 0.0, 0.0)),
        ("on the z-axis, where θ is not determined and φ is an exact zero", (0.0, 0.0, 2.0)),
        ("on the z-axis below the origin: θ is not determined, and φ is the rounded π", (0.0, 0.0, -2.0)),
        ("on the cut of θ: 180 degrees, not −180, by the sign of a zero", (-1.0, 0.0, 0.0)),
        ("below the cut of θ by less than an angle can show: −180 degrees, not 180", (-1.0, -1e-300, 1.0)),
        ("above the cut of θ by less than its last place: the sine of a double near π decides", (-1.0, 1e-17, 1.0)),
        ("off the z-axis by less than the last place of ρ: an arc cosine gives φ = 0", (1e-20, 0.0, 1.0)),
        (
            "off the negative z-axis by 1e-20: an arc cosine gives exactly π, and θ must keep its digits",
            (1e-20, 1e-20, -1.0),
        ),
        ("off the plane by less than the last place of ρ: an arc cosine sees a right angle only", (1.0, 1.0, 1e-20)),
        ("three of the smallest doubles: lengths round to whole multiples of them", (LEAST, LEAST, LEAST)),
        ("a triangle 3, 4, 5 of the smallest doubles: the length is exact", (3 * LEAST, -4 * LEAST, 0.0)),
        ("subnormal components: few digits are given, and none of them may be lost", (7e-310, -3e-312, 5e-309)),
        ("squares of all components underflow, and the radius does not", (TINY, TINY, TINY)),
        ("squares of all components overflow, and the radius does not", (HUGE, -HUGE, HUGE)),
        ("near the largest double: the sum of components overflows, their length does not", (1e308, 1e308, 1e308)),
        (
            "600 orders of magnitude between components: θ is a right angle to the last bit",
            (TINY, HUGE, 1.0),
        ),
        ("down the z-axis, 600 orders of magnitude from it: φ is π, and θ is exactly 45 degrees", (TINY, TINY, -HUGE)),
        ("squares of x and y underflow, and the square of z does not stay normal", (1e-170, 1e-170, 1e-160)),
        ("squares of x and y overflow, and z is lost beside them", (1e170, 1e170, -1e160)),
    ]


def cylindrical(generator: random.Random) -> Iterator[tuple[str, Point]]:
    for _ in range(20):
        yield "", (generator.uniform(0.0, 10.0), generator.uniform(-PI, PI), generator.uniform(-10.0, 10.0))
    yield "", (4.0, 0.5235987755982988, 2.0)
    yield from [
        ("no radius: θ says nothing, and must not appear in the answer", (0.0, 0.4, 1.0)),
        ("the origin with an angle given: a radius of zero takes it away, and the answer has none", (0.0, 0.4, 0.0)),
        ("the double nearest π: its sine is 1.2e-16, what that double is short of π", (1.0, PI, 0.0)),
        ("the double nearest −π, which other angles write as 180 degrees", (1.0, -PI, 0.0)),
        ("an angle beyond π must be brought back by an exact turn", (1.0, 4.0, 1.0)),
        ("64 turns backwards: the turn's own rounding times 64", (1.0, -400.5, 1.0)),
        ("1e22 radians: the reduction by π needs forty digits of it", (1.0, 1e22, 1.0)),
        ("a full turn as a double: an angle of −2.4e-16 is left", (1.0, 6.283185307179586, 1.0)),
        ("off the negative z-axis by less than the last place of ρ", (1e-20, 1.0, -1.0)),
        ("the smallest doubles: components round to none or one of them", (LEAST, 1.0, LEAST)),
        ("radius and angle of 1e-300: their product underflows to zero", (TINY, 1e-300, TINY)),
        ("squares of radius and height overflow, and their root does not", (HUGE, 2.0, -HUGE)),
        (
            "a right angle as a double, its cosine 6e-17, at 600 orders of magnitude between radius and height",
            (1e-300, 1.5707963267948966, 1e300),
        ),
    ]


def spherical(generator: random.Random) -> Iterator[tuple[str, Point]]:
    for _ in range(20):
        yield "", (generator.uniform(0.0, 10.0), generator.uniform(0.0, PI), generator.uniform(-PI, PI))
    yield "", (7.0, 0.7853981633974483, 1.0471975511965976)
    yield from [
        ("no distance: both angles say nothing, and must not appear in the answer", (0.0, 0.4, 1.0)),
        ("on the z-axis: θ says nothing, and must not appear in the answer", (2.0, 0.0, 1.0)),
        ("φ of the double nearest π: the radius is 2.4e-16, what that double is short of π", (2.0, PI, 1.0)),
        ("φ of 1e-300: a radius that a difference of squares cannot see", (2.0, 1e-300, 1.0)),
        ("φ a right angle as a double: the height is 1.2e-16, not zero", (2.0, 1.5707963267948966, -3.0)),
        ("θ the double nearest −π, which other systems write as 180 degrees", (2.0, 1.0, -PI)),
        ("θ beyond a full turn must be brought back by an exact turn", (2.0, 1.0, 7.0)),
        ("16,000 turns backwards: the turn's own rounding times 16,000", (2.0, 1.0, -1e5)),
        ("a tiny distance and a small angle: radius, x and y are subnormal numbers", (TINY, 1e-10, 2.0)),
        ("the smallest double as a distance: components round to none or one of it", (LEAST, 1.0, 1.0)),
        ("a huge distance by two tiny angles: 1e300 · 1e-300 is one, and times another 1e-300", (HUGE, 1e-300, 1e-300)),
        ("a distance near the largest double: no square of it may be taken", (1e308, 3.0, -3.0)),
    ]


def generate() -> Iterator[dict[str, Any]]:
    mp.dps = DIGITS
    points = {"cartesian": cartesian, "cylindrical": cylindrical, "spherical": spherical}
    for source, (names, convert, targets) in SOURCES.items():
        for why, point in points[source](random.Random(source)):
            inputs = {name: repr(value) for name, value in zip(names, point, strict=True)}
            for target, results in zip(targets, convert(*map(mpf, point)), strict=True):
                texts = {name: mp.nstr(value, 40) for name, value in results.items()}
                task = f"{source}_to_{target}"
                reason = {"why": why} if why else {}
                case = {"task": task, "kind": "hard" if why else "ordinary", "name": f"{task} {point}", **reason}
                yield {**case, "inputs": inputs, "results": texts}
    for worst in found("coords.json"):
        source, target = worst["task"].split("_to_")
        _, convert, targets = SOURCES[source]
        results = convert(*(mpf(float(text)) for text in worst["inputs"].values()))[targets.index(target)]
        texts = {name: mp.nstr(value, 40) for name, value in results.items()}
        own = {key: worst[key] for key in ("name", "why", "inputs")}
        yield {"task": worst["task"], "kind": "hard", **own, "results": texts}


def main() -> None:
    about = "Written by generate_coords_references.py: coordinates as doubles, results to 40 digits."
    put("coords", about, generate())


if __name__ == "__main__":
    main()
