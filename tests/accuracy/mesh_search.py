"""A search for stated bounds of `inertia mesh` below the true error, against sums of whole numbers.

    python tests/accuracy/mesh_search.py [EVALUATIONS ["inertia mesh" [SEED]]]

A surface is corners and faces, so that moving a corner leaves it closed; an evaluation is one surface as a solid or as
a shell, in one unit of length: volume or area, centroid, moments, products and principal moments of unit density. The
exact side takes the corners as multiples of a power of two and adds signed tetrahedra on the origin of the file in
whole numbers, with no rounding at all; areas take roots, and principal moments the cubic's cosines, in 700 bits.
Drawn are solids of four to a hundred faces: needles, plates and blades, far off, rounded to single precision, hollow,
of several pieces, and with faces through one another; the shipped hard cases are disturbed too. Half of the surfaces
go the way of those of few faces, half that of those of many, whose sums are in doubles.
"""

import json
import random
import sys
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
sys.path.insert(0, str(Path(__file__).resolve().parent))

import numpy as np
from climbing import Answer, Compared, Question, Tree, bits, main_of
from precise import FUNCTIONS, Exact, exact_pi, gmpy2

from dynamics_cli.accuracy.alternatives.inertia.bodies import NAMES, PAIRS, named
from dynamics_cli.accuracy.alternatives.inertia.solids import SOLIDS, single, turned
from dynamics_cli.accuracy.cases import DATA
from dynamics_cli.inertia.bodies.mass_moments import tensor_of
from dynamics_cli.inertia.mesh import measurement
from dynamics_cli.inertia.mesh.measurement import require_closed
from dynamics_cli.inertia.mesh.stl import Corners
from dynamics_cli.inertia.mesh.surface import LengthUnit
from dynamics_cli.inertia.mesh.tracked_integrals import Lift

BITS = 700
NOISE = 320
Whole: Any = gmpy2.mpz if gmpy2 else int
Share: Any = gmpy2.mpq if gmpy2 else Fraction
sqrt, cos, acos = (FUNCTIONS[name] for name in ("sqrt", "cos", "acos"))


# ---- the exact side ----


def in_whole_numbers(corners: list[list[float]]) -> tuple[list[list[Any]], int]:
    """Corners as multiples of one over a power of two, and that power."""
    shares = [[x.as_integer_ratio() for x in corner] for corner in corners]
    unit = max(down for corner in shares for _, down in corner)
    return [[Whole(up) * (unit // down) for up, down in corner] for corner in shares], unit


def sums(corners: list[list[Any]], faces: list[list[int]], *, shell: bool) -> tuple[Any, list[Any], list[list[Any]]]:
    """Measure, first and second moments about the origin, but for their common divisors."""
    total, first, second = 0, [0, 0, 0], [[0, 0, 0] for _ in range(3)]
    for face in faces:
        a, b, c = (corners[place] for place in face)
        weight = _area(a, b, c) if shell else _volume(a, b, c)
        middle = [a[i] + b[i] + c[i] for i in range(3)]
        total += weight
        for i in range(3):
            first[i] += weight * middle[i]
            for j in range(i + 1):
                second[i][j] += weight * (middle[i] * middle[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j])
    return total, first, second


def _volume(a: list[Any], b: list[Any], c: list[Any]) -> Any:
    """Six times that of the tetrahedron on the origin."""
    x, y, z = (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2] for i in range(3))
    return a[0] * x + a[1] * y + a[2] * z


def _area(a: list[Any], b: list[Any], c: list[Any]) -> Any:
    """Twice that of the triangle."""
    e, f = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
    n = [e[i - 2] * f[i - 1] - e[i - 1] * f[i - 2] for i in range(3)]
    return sqrt(Exact(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]))


def exact(tree: Tree) -> dict[str, Any]:
    """Every result, in metres."""
    shell = tree["shell"]
    corners, unit = in_whole_numbers(tree["corners"])
    total, first, second = sums(corners, tree["faces"], shell=shell)
    up, down = LengthUnit(tree["unit"]["word"]).ratio
    length = Share(int(up), int(down)) / unit
    divide = (lambda x, y: x / y) if shell else Share
    power, divisors = (2, (2, 6, 24)) if shell else (3, (6, 24, 120))
    measure = divide(total, divisors[0])
    centre = [divide(x, divisors[1]) / measure for x in first]
    s = [[Share(0)] * 3 for _ in range(3)]
    for i in range(3):
        for j in range(i + 1):
            central = divide(second[i][j], divisors[2]) - measure * centre[i] * centre[j]
            s[i][j] = s[j][i] = central * length ** (power + 2)
    trace = s[0][0] + s[1][1] + s[2][2]
    spread = roots([[Exact(x) for x in row] for row in s])
    out = {"area" if shell else "volume": measure * length**power}
    out |= {f"centroid[{k}]": x * length for k, x in enumerate(centre)}
    out |= {f"moments.{name}": trace - s[k][k] for k, name in enumerate(("xx", "yy", "zz"))}
    out |= {f"products.{name}": -s[i][j] for name, i, j in PAIRS}
    others = (spread[1] + spread[2], spread[2] + spread[0], spread[0] + spread[1])
    return out | {f"principal_moments.{name}": x for name, x in zip(NAMES, others, strict=True)}


def roots(s: list[list[Any]]) -> list[Any]:
    """Eigenvalues of a symmetric matrix, the greatest first, by the cosines of the cubic."""
    mean = (s[0][0] + s[1][1] + s[2][2]) / 3
    d = [[s[i][j] - (mean if i == j else 0) for j in range(3)] for i in range(3)]
    size = sqrt(sum(x * x for row in d for x in row) / 6)
    if size == 0:
        return [mean] * 3
    determinant = sum(
        d[0][i] * (d[1][i - 2] * d[2][i - 1] - d[1][i - 1] * d[2][i - 2]) for i in range(3)
    ) / (2 * size * size * size)  # fmt: skip
    angle = acos(min(max(determinant, Exact(-1)), Exact(1))) / 3
    high, low = mean + 2 * size * cos(angle), mean + 2 * size * cos(angle + 2 * exact_pi() / 3)
    return [high, 3 * mean - high - low, low]


# ---- what is asked ----


def ask(_: random.Random, tree: Tree) -> Iterator[Answer]:
    """One surface."""
    shell, faces = tree["shell"], np.array(tree["faces"])
    source = Corners("", "", np.array(tree["corners"]), faces)
    few = measurement.FEW
    try:
        # bodies of many faces are summed in doubles, whose errors average out least where faces are few
        measurement.FEW = 0 if tree["doubles"] else few
        found = measurement.Measured(source, shell=shell)
    finally:
        measurement.FEW = few
    if not shell:
        require_closed(found, allowed=False)
    if not found.moments.measure:
        return
    lift = Lift(found, LengthUnit(tree["unit"]["word"]), 0)
    tensor = tensor_of(lift.second(1.0))
    made = named(lift.centroid(), tensor, lift.spread(1.0).moments)
    made["area" if shell else "volume"] = lift.measure()
    with bits(BITS):
        wanted = exact(tree)
        noise = noise_of(tree, wanted)
        results = [
            Compared(name, own.value, own.error, Exact(wanted[name]), noise[name.partition("[")[0].partition(".")[0]])
            for name, own in made.items()
        ]
    yield Answer(tree, results, f"{'shell' if shell else 'solid'}{', doubles' if tree['doubles'] else ''}")


def noise_of(tree: Tree, wanted: dict[str, Any]) -> dict[str, Any]:
    """What roots and cosines of 700 bits may be off by, beside results that come to nothing."""
    up, down = LengthUnit(tree["unit"]["word"]).ratio
    reach = max(abs(x) for corner in tree["corners"] for x in corner) * Exact(up) / Exact(down)
    most = max(abs(Exact(wanted[f"moments.{name}"])) for name in ("xx", "yy", "zz"))
    least = Exact(2) ** -NOISE
    moments = dict.fromkeys(("moments", "products", "principal_moments"), most * least)
    return {"centroid": reach * least, "volume": Exact(0), "area": Exact(0)} | moments


def surface(triangles: Any) -> Tree:
    """Corners, each once, and faces."""
    places: dict[Any, int] = {}
    faces = [[places.setdefault(tuple(corner), len(places)) for corner in triangle] for triangle in triangles]
    return {"corners": [list(corner) for corner in places], "faces": faces}


def pyramid(rng: random.Random) -> Any:
    """A pyramid on a polygon of any corners, which may cross itself."""
    count = rng.randrange(3, 7)
    base = [tuple(rng.uniform(-1.0, 1.0) for _ in range(3)) for _ in range(count)]
    top = tuple(rng.uniform(-1.0, 1.0) for _ in range(3))
    foot = [(base[0], base[k + 1], base[k]) for k in range(1, count - 1)]
    made = foot + [(base[k], base[(k + 1) % count], top) for k in range(count)]
    return made if _sign(made) > 0 else [(a, c, b) for a, b, c in made]


def _sign(triangles: Any) -> float:
    return sum(
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        for a, b, c in triangles
    )


SIMPLE = ("box", "tetrahedron", "bracket", "ball 1")


def solid(rng: random.Random) -> Any:
    """A solid, a hollow one, or several pieces that may overlap."""
    if rng.random() < 0.4:
        return pyramid(rng)
    made = SOLIDS[rng.choice(SIMPLE)]()
    if rng.random() < 0.15:
        wall = 1.0 - 10.0 ** rng.uniform(-9.0, -0.3)
        return made + [tuple(tuple(wall * x for x in p) for p in (a, c, b)) for a, b, c in made]
    if rng.random() < 0.2:
        aside = [rng.choice((0.0, 0.5, 1.0)) * rng.uniform(-1.0, 1.0) for _ in range(3)]
        return made + [tuple(tuple(x + d for x, d in zip(p, aside, strict=True)) for p in t) for t in pyramid(rng)]
    return made


def draw(rng: random.Random) -> Tree:
    """A solid stretched, turned, moved off, and now and then rounded to single precision."""
    thin = [10.0 ** rng.choice((0.0, rng.uniform(-7.0, 0.0))) for _ in range(3)]
    scale = 10.0 ** rng.choice((0.0, 0.0, rng.uniform(-6.0, 6.0)))
    turn = rng.choice(((1.0, 0.0, 0.0, 0.0), tuple(rng.uniform(-1.0, 1.0) for _ in range(4))))
    off = [rng.choice((0.0, 1.0)) * rng.uniform(-1.0, 1.0) * 10.0 ** rng.uniform(0.0, 8.0) for _ in range(3)]
    rounded = single if rng.random() < 0.15 else float

    def moved(p: Any) -> Any:
        laid = turned((p[0] * thin[0], p[1] * thin[1], p[2] * thin[2]), turn)  # type: ignore[arg-type]
        return tuple(rounded(scale * (x + d)) for x, d in zip(laid, off, strict=True))

    made = surface([tuple(moved(p) for p in t) for t in solid(rng)])
    unit = rng.choice(("m", "m", "mm", "in", "ft", "um"))
    return {**made, "shell": rng.random() < 0.25, "unit": {"word": unit}, "doubles": rng.random() < 0.5}


def starts() -> list[Tree]:
    """The hard cases that are shipped, but those of many faces."""
    from dynamics_cli.accuracy.alternatives.inertia.solids import triangles

    found = []
    for case in json.loads((DATA / "inertia_mesh.json").read_text(encoding="utf-8"))["cases"]:
        if case["kind"] != "hard" or case["inputs"]["solid"] in ("ball 2", "ball 6"):
            continue
        recipe = {
            key: list(map(float, part)) if isinstance(part, list) else part for key, part in case["inputs"].items()
        }
        made = surface(triangles(recipe))
        tree = {**made, "shell": recipe["shell"], "unit": {"word": "m"}}
        found += [{**tree, "doubles": doubles} for doubles in (False, True)]
    return found


def question() -> Question:
    """`inertia mesh`."""
    return Question("inertia mesh", starts(), draw, ask, drawn=0.7)


if __name__ == "__main__":
    main_of({"inertia mesh": question})
