"""Writes inertia_sections.json: area properties of sections with pieces and holes to 40 digits, easy and hard.

Coordinates are doubles and taken as exact. Polygons are summed as triangles from their first corner, each by its
corners and centroid; circles by π of 90 digits; principal moments by the roots of the 2 × 2 matrix at 90 digits.
Run: python tests/references/generate_inertia_sections_references.py [FILE]. The same bytes every time.
"""

import random
import sys
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

import inertia_found
from case_files import put
from mpmath import atan2, cos, mp, mpf, nstr, pi, sin, sqrt

ABOUT = "Written by generate_inertia_sections_references.py: area properties of sections of doubles, to 40 digits."
Point = tuple[Any, Any]
ELL = [0.0, 0.0, 60.0, 0.0, 60.0, 8.0, 8.0, 8.0, 8.0, 40.0, 0.0, 40.0]
# The sine and cosine of turns that divide into no right angle; not quite a turn, which matters to nobody.
TURNS = ((0.955336489125606, 0.29552020666133955), (0.6, 0.8), (-0.28, 0.96))


def star(rng: random.Random, stretch: float = 1.0, at: tuple[float, float] = (0.0, 0.0), turn: int = 0) -> list[float]:
    """A polygon that goes once around a point, stretched, turned and moved."""
    count, made = rng.randrange(5, 12), []
    c, s = TURNS[turn]
    for k in range(count):
        angle, r = (k + rng.uniform(0.0, 0.4)) / count, rng.uniform(0.5, 1.0)
        x, y = r * float(cos(2 * pi * angle)), r * float(sin(2 * pi * angle)) / stretch
        made += [x * c - y * s + at[0], x * s + y * c + at[1]]
    return made


def strip(length: float, thickness: float, turn: int, at: tuple[float, float] = (0.0, 0.0)) -> list[float]:
    """A turned rectangle."""
    c, s = TURNS[turn]
    made = []
    for x, y in ((-length, -thickness), (length, -thickness), (length, thickness), (-length, thickness)):
        made += [0.5 * (x * c - y * s) + at[0], 0.5 * (x * s + y * c) + at[1]]
    return made


def cases(rng: random.Random) -> Iterator[tuple[str, str, str, dict[str, Any]]]:
    """Kind, name, why it is hard, inputs."""
    yield "ordinary", "angle section", "", {"polygon": ELL}
    for nth in range(8):
        yield "ordinary", f"star {nth}", "", {"polygon": star(rng, 1.0 + nth % 3, (0.1 * nth, -0.2), nth % 3)}
    yield "ordinary", "rectangle", "", {"pieces": [{"width": 0.12, "height": 0.07, "x": 0.3, "y": -0.1}]}
    yield "ordinary", "tube", "", {"pieces": [{"diameter": 0.06}], "holes": [{"diameter": 0.05}]}
    holes = [{"diameter": 6.0, "x": 4.0, "y": 20.0}, {"polygon": [20.0, 2.0, 40.0, 2.0, 30.0, 6.0]}]
    yield "ordinary", "angle section with holes", "", {"polygon": ELL, "holes": holes}
    flanges = [{"width": 0.1, "height": 0.01, "y": 0.095}, {"width": 0.006, "height": 0.18}]
    yield "ordinary", "built of plates", "", {"pieces": [*flanges, {"width": 0.1, "height": 0.01, "y": -0.095}]}
    for power in (3, 6, 8, 12):
        far = 10.0**power
        why = f"1e{power} sizes from the origin: moments about it exceed those about the centroid 1e{2 * power} times"
        yield "hard", f"star at 1e{power} sizes", why, {"polygon": star(rng, 1.5, (far, -0.7 * far), 1)}
    for power in (3, 6, 9):
        why = f"a strip: the least moment is 1e-{2 * power} of the others, and a difference of them once it is turned"
        for turn in (0, 2):
            yield "hard", f"strip 1e{power}, turn {turn}", why, {"polygon": strip(1.0, 10.0**-power, turn)}
        far = strip(1.0, 10.0**-power, 0, (30.0, -20.0))
        yield "hard", f"strip 1e{power} at 30 sizes", why, {"polygon": far}
    for power in (4, 8, 12):
        wall = 10.0**-power
        why = "a wall so thin that outer less inner circle has lost as many digits"
        yield (
            "hard",
            f"tube, wall 1e-{power}",
            why,
            {"pieces": [{"diameter": 1.0}], "holes": [{"diameter": 1.0 - wall}]},
        )
        inner = {"width": 1.0 - wall, "height": 0.5 - wall}
        why = "a wall so thin that outer less inner rectangle has lost as many digits"
        yield "hard", f"box, wall 1e-{power}", why, {"pieces": [{"width": 1.0, "height": 0.5}], "holes": [inner]}
    for gap in (1e-6, 1e-12):
        why = "moments nearly equal: the principal angle comes from a difference of them"
        yield "hard", f"square but for {gap:g}", why, {"pieces": [{"width": 1.0, "height": 1.0 + gap, "x": 0.3}]}
    why = "a hole the centroid lies in, and the section far off"
    far = {"pieces": [{"diameter": 2.0, "x": 1e6, "y": 1e6}], "holes": [{"diameter": 0.5, "x": 1e6 + 0.3, "y": 1e6}]}
    yield "hard", "eccentric bore far off", why, far
    why = "two small pieces far apart: almost all of the moment is the parallel axis term"
    yield "hard", "two wires", why, {"pieces": [{"diameter": 1e-3, "x": 1.0}, {"diameter": 1e-3, "x": -1.0, "y": 0.25}]}
    for name, why, inputs in inertia_found.SECTIONS:
        yield "hard", name, why, inputs


def polygon(numbers: list[float]) -> list[Fraction]:
    """∫ of 1, x, y, y², x², xy over a polygon either way round, by triangles from its first corner."""
    points = [(Fraction(x), Fraction(y)) for x, y in zip(numbers[0::2], numbers[1::2], strict=True)]
    sums, p = [Fraction(0)] * 6, points[0]
    for q, r in pairwise(points[1:]):
        area = ((q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])) / 2
        gx, gy = (p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3
        own = [
            (sum(v[i] * v[j] for v in (p, q, r)) + 9 * g) / 12
            for i, j, g in ((1, 1, gy * gy), (0, 0, gx * gx), (0, 1, gx * gy))
        ]
        sums = [total + area * part for total, part in zip(sums, (1, gx, gy, *own), strict=True)]
    return [-part for part in sums] if sums[0] < 0 else sums


def exact(x: Any) -> Any:
    """A ratio as a real number."""
    return mpf(x.numerator) / x.denominator if isinstance(x, Fraction) else mpf(x)


class Outline:
    """A contour: its integrals, corners or centre, diameter, and the length around it."""

    def __init__(self, item: dict[str, Any]) -> None:
        self.radius = mpf(item.get("diameter", 0.0)) / 2
        x, y = Fraction(item.get("x", 0.0)), Fraction(item.get("y", 0.0))
        if self.radius:
            area = pi * self.radius**2
            own = area * self.radius**2 / 4
            cx, cy = exact(x), exact(y)
            self.sums = [area, area * cx, area * cy, own + area * cy * cy, own + area * cx * cx, area * cx * cy]
            self.corners = [(cx, cy)]
            self.length = 2 * pi * self.radius
            return
        if "width" in item:
            a, b = Fraction(item["width"]) / 2, Fraction(item["height"]) / 2
            numbers = [x - a, y - b, x + a, y - b, x + a, y + b, x - a, y + b]
        else:
            numbers = item["polygon"]
        self.sums = [exact(part) for part in polygon(numbers)]
        points = [exact(Fraction(number)) for number in numbers]
        self.corners = list(zip(points[0::2], points[1::2], strict=True))
        ends = [*self.corners[1:], self.corners[0]]
        self.length = sum(
            sqrt((q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2) for p, q in zip(self.corners, ends, strict=True)
        )

    def reach(self, nx: Any, ny: Any, x: Any, y: Any) -> Any:
        """How far it reaches from a point in a direction."""
        return max(nx * (p[0] - x) + ny * (p[1] - y) for p in self.corners) + self.radius


def results(inputs: dict[str, Any]) -> dict[str, Any]:
    """Every result by address."""
    material = [Outline(item) for item in inputs.get("pieces", [])]
    material += [Outline({"polygon": inputs["polygon"]})] if "polygon" in inputs else []
    holes = [Outline(item) for item in inputs.get("holes", [])]
    sums = [sum(one.sums[k] for one in material) - sum(one.sums[k] for one in holes) for k in range(6)]
    area, x, y = sums[0], sums[1] / sums[0], sums[2] / sums[0]
    ix, iy, ixy = sums[3] - area * y * y, sums[4] - area * x * x, sums[5] - area * x * y
    radius = sqrt(((ix - iy) / 2) ** 2 + ixy**2)
    i1, i2 = (ix + iy) / 2 + radius, (ix + iy) / 2 - radius
    angle = atan2(-2 * ixy, ix - iy) / 2 if radius > mpf(10) ** -40 * i1 else mpf(0)
    found = {"area": area, "perimeter": sum(one.length for one in (*material, *holes)), "x": x, "y": y}
    for name, own in (("centroidal", (ix, iy, ixy, ix + iy)), ("about_origin", (*sums[3:], sums[3] + sums[4]))):
        found |= {f"{name}.{part}": value for part, value in zip(("ix", "iy", "ixy", "polar"), own, strict=True)}
    found |= {"principal.i1": i1, "principal.i2": i2, "principal.angle": angle}
    radii = {"rx": ix, "ry": iy, "r1": i1, "r2": i2, "polar": ix + iy}
    found |= {f"gyration.{name}": sqrt(value / area) for name, value in radii.items()}

    def reach(nx: Any, ny: Any) -> Any:
        return max(one.reach(nx, ny, x, y) for one in (*material, *holes))

    c, s = cos(angle), sin(angle)
    found |= {"moduli.x_top": ix / reach(0, 1), "moduli.x_bottom": ix / reach(0, -1)}
    found |= {"moduli.y_right": iy / reach(1, 0), "moduli.y_left": iy / reach(-1, 0)}
    found["moduli.first_least"] = i1 / max(reach(-s, c), reach(s, -c))
    found["moduli.second_least"] = i2 / max(reach(c, s), reach(-c, -s))
    return found


def written(tree: Any) -> Any:
    """Doubles as text that reads back to the same bits."""
    if isinstance(tree, float):
        return repr(tree)
    if isinstance(tree, dict):
        return {name: written(part) for name, part in tree.items()}
    return [written(part) for part in tree]


def main() -> None:
    """Write every case."""
    mp.dps = 90
    lines = []
    for kind, name, why, inputs in cases(random.Random(71)):
        found = results(inputs)
        # what 90 digits leave of an exact zero
        shown = {key: nstr(value, 40) if abs(value) > mpf(10) ** -60 else "0.0" for key, value in found.items()}
        case = {"task": "section", "kind": kind, "name": name, **({"why": why} if why else {})}
        lines.append({**case, "inputs": written(inputs), "results": shown})
    put("inertia_sections", ABOUT, lines, "  ")


if __name__ == "__main__":
    main()
