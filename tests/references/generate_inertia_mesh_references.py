"""Writes inertia_mesh.json: solids and shells of triangles to 40 digits, for ordinary and hard triangles.

Corners are doubles, so volumes and moments are rational: they are summed exactly, about the origin of the file, from
the corners of each triangle, and moved to the mass centre exactly. Areas take square roots of 80 digits. Principal
moments by mpmath's QR. Run: python tests/references/generate_inertia_mesh_references.py [FILE]. The same bytes every
time.
"""

import sys
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

import inertia_found
from case_files import put
from inertia_solids import triangles
from mpmath import eigsy, matrix, mp, mpf, nstr, sqrt

ABOUT = "Written by generate_inertia_mesh_references.py: solids and shells of triangles of doubles, to 40 digits."
STILL = (1.0, 0.0, 0.0, 0.0)
TURN = (0.75, -0.5, 0.25, 0.375)


def recipe(
    solid: str, stretch: Any = (1.0, 1.0, 1.0), turn: Any = STILL, offset: Any = (0.0, 0.0, 0.0), **more: Any
) -> dict[str, Any]:
    """The inputs of a case."""
    made = {"solid": solid, "stretch": stretch, "quaternion": turn, "offset": offset, "single": False, "shell": False}
    return {**made, **more}


def cases() -> Iterator[tuple[str, str, str, dict[str, Any]]]:
    """Kind, name, why it is hard, inputs."""
    for solid in ("ball 1", "ball 2", "box", "tetrahedron", "bracket", "hollow ball"):
        for single in (False, True):
            for turn in (STILL, TURN):
                name = f"{solid}{' turned' if turn is TURN else ''}{' single' if single else ''}"
                yield "ordinary", name, "", recipe(solid, (1.0, 0.75, 0.5), turn, (0.25, -0.5, 1.0), single=single)
    for solid in ("ball 1", "bracket", "hollow ball"):
        yield "ordinary", f"shell of {solid}", "", recipe(solid, (1.0, 0.75, 0.5), TURN, (0.25, -0.5, 1.0), shell=True)
    for power in (2, 4, 6, 8):
        far = 10.0**power
        why = f"1e{power} sizes from the origin: moments about it exceed those about the centroid 1e{2 * power} times"
        yield (
            "hard",
            f"ball at 1e{power} sizes",
            why,
            recipe("ball 2", (1.0, 0.75, 0.5), TURN, (far, -0.7 * far, 0.3 * far)),
        )
    for power in (1, 3, 5):
        far = 10.0**power
        why = f"1e{power} sizes from the origin in single precision: corners keep {7 - power} digits, sums need more"
        inputs = recipe("ball 2", (1.0, 0.75, 0.5), TURN, (far, -0.7 * far, 0.3 * far), single=True)
        yield "hard", f"ball at 1e{power} sizes, single", why, inputs
    for power in (3, 6):
        thin = 10.0**-power
        why = f"a needle: the least second moment is 1e-{2 * power} of the others, and turning loses it among them"
        for single in (False, True):
            last = " single" if single else ""
            for turn in (STILL, TURN):
                name = f"needle 1e{power}{' turned' if turn is TURN else ''}{last}"
                yield "hard", name, why, recipe("ball 2", (1.0, 1.25 * thin, thin), turn, single=single)
        inputs = recipe("ball 2", (1.0, 1.25 * thin, thin), TURN, (10.0, 4.0, -3.0))
        yield "hard", f"needle 1e{power} turned at 10 sizes", why, inputs
        yield "hard", f"box needle 1e{power} turned", why, recipe("box", (1.0, 1.25 * thin, thin), TURN)
    why = "the volume is a small difference of large terms, and the least second moment smaller still"
    for power in (3, 6):
        thin = 10.0**-power
        for single in (False, True):
            last = " single" if single else ""
            yield "hard", f"plate 1e{power} turned{last}", why, recipe("ball 2", (1.0, 0.75, thin), TURN, single=single)
        yield "hard", f"box plate 1e{power} turned", why, recipe("box", (1.0, 0.75, thin), TURN, (3.0, -2.0, 1.0))
    far = (1e3, -7e2, 3e2)
    why = "a plate of 1e-6 at a thousand sizes: the least second moment is 1e-18 of what its sums about the origin are"
    yield "hard", "plate 1e6 turned at 1e3 sizes", why, recipe("ball 2", (1.0, 0.75, 1e-6), TURN, far)
    why = "three lengths of different size: the tensor is graded"
    yield "hard", "blade", why, recipe("ball 2", (1.0, 1e-2, 1e-5), TURN)
    yield "hard", "blade far off", why, recipe("ball 2", (1.0, 1e-2, 1e-5), TURN, (300.0, 500.0, -200.0))
    why = "equal moments determine no axes: what decides between them is the rounding of the corners"
    yield "hard", "cube turned", why, recipe("box", (1.0, 1.0, 1.0), TURN)
    yield "hard", "ball turned", why, recipe("ball 2", (1.0, 1.0, 1.0), TURN)
    yield "hard", "round needle", why, recipe("ball 2", (1.0, 1e-4, 1e-4), TURN)
    why = "fifth powers of lengths reach towards the ends of the range of a double"
    yield "hard", "huge", why, recipe("bracket", (1e40, 1e40, 1e40), TURN)
    yield "hard", "minute", why, recipe("bracket", (1e-45, 1e-45, 1e-45), TURN)
    yield "hard", "least of single precision", why, recipe("bracket", (1e-38, 1e-38, 1e-38), TURN, single=True)
    why = "a thin wall between two surfaces that nearly cancel, each of them far from the origin"
    yield "hard", "hollow ball far off", why, recipe("hollow ball", (1.0, 0.75, 0.5), TURN, (1e3, -2e3, 5e2))
    for power in (4, 8):
        far = 10.0**power
        why = "a shell's moments about the origin exceed those about the centroid by the square of the offset"
        inputs = recipe("ball 2", (1.0, 0.75, 0.5), TURN, (far, -0.7 * far, 0.3 * far), shell=True)
        yield "hard", f"shell at 1e{power} sizes", why, inputs
    for power in (3, 6):
        thin = 10.0**-power
        why = "areas of slivers are small differences of products unless their edges are short ones"
        yield (
            "hard",
            f"shell needle 1e{power} turned",
            why,
            recipe("ball 2", (1.0, 1.25 * thin, thin), TURN, shell=True),
        )
        inputs = recipe("ball 2", (1.0, 0.75, thin), TURN, (10.0, 4.0, -3.0), shell=True)
        why = "two sheets that nearly touch: the least second moment is that of their distance"
        yield "hard", f"shell plate 1e{power} turned at 10 sizes", why, inputs

    for name, why, inputs in inertia_found.MESHES:
        yield "hard", name, why, inputs


def large_cases() -> Iterator[tuple[str, str, str, dict[str, Any]]]:
    """Cases of many triangles: kind, name, why it is hard, inputs."""
    yield "ordinary", "ball 6 turned", "", recipe("ball 6", (1.0, 0.75, 0.5), TURN, (0.25, -0.5, 1.0))
    why = "many triangles at 1e4 sizes: what each loses adds up"
    yield "hard", "ball 6 at 1e4 sizes", why, recipe("ball 6", (1.0, 0.75, 0.5), TURN, (1e4, -7e3, 3e3))


def integrals(inputs: dict[str, Any]) -> dict[str, str]:
    """Measure, centroid, tensor and principal moments of unit density."""
    shell = inputs["shell"]
    whole, unit = in_whole_numbers(triangles(inputs))
    total, first, second = 0, [0, 0, 0], [[0] * 3 for _ in range(3)]
    for corners in whole:
        weight = area_of(corners) if shell else six_volumes(corners)
        middle = [sum(p[k] for p in corners) for k in range(3)]
        total += weight
        for i in range(3):
            first[i] += weight * middle[i]
            for j in range(3):
                second[i][j] += weight * (middle[i] * middle[j] + sum(p[i] * p[j] for p in corners))
    divisors, power = ((2, 6, 24), 2) if shell else ((6, 24, 120), 3)
    measure = ratio(total, divisors[0] * unit**power)
    centre = [ratio(x, divisors[1] * unit ** (power + 1)) / measure for x in first]
    s = [[ratio(x, divisors[2] * unit ** (power + 2)) for x in row] for row in second]
    s = [[real(s[i][j] - measure * centre[i] * centre[j]) for j in range(3)] for i in range(3)]
    spread = sorted(eigsy(matrix(s), eigvals_only=True), reverse=True)
    trace = s[0][0] + s[1][1] + s[2][2]
    out = {"area" if shell else "volume": real(measure)}
    out |= {f"centroid[{k}]": real(centre[k]) for k in range(3)}
    out |= {f"moments.{n}": trace - s[k][k] for k, n in enumerate(("xx", "yy", "zz"))}
    out |= {f"products.{n}": -s[i][j] for n, (i, j) in {"xy": (0, 1), "yz": (1, 2), "zx": (2, 0)}.items()}
    out["principal_moments.first"] = spread[1] + spread[2]
    out["principal_moments.second"] = spread[2] + spread[0]
    out["principal_moments.third"] = spread[0] + spread[1]
    # what roots of 80 digits leave of a zero is none
    reach = mpf(max(abs(x) for corners in whole for p in corners for x in p)) / unit
    sizes = {"centroid": reach, "moments": trace, "products": trace}
    least = {name: sizes.get(name.partition("[")[0].partition(".")[0], 0) * mpf(10) ** -60 for name in out}
    return {name: nstr(value, 40) if abs(value) > least[name] else "0.0" for name, value in out.items()}


def in_whole_numbers(made: list[Any]) -> tuple[list[Any], int]:
    """Corners as multiples of one over a power of two."""
    unit = max(x.as_integer_ratio()[1] for t in made for p in t for x in p)

    def whole(x: float) -> int:
        up, down = x.as_integer_ratio()
        return up * (unit // down)

    return [[[whole(x) for x in p] for p in t] for t in made], unit


def ratio(up: Any, down: int) -> Any:
    """A ratio: exact of whole numbers."""
    return Fraction(up, down) if isinstance(up, int) else up / down


def real(x: Any) -> mpf:
    """A ratio as a real number."""
    return mpf(x.numerator) / x.denominator if isinstance(x, Fraction) else mpf(x)


def six_volumes(corners: list[list[int]]) -> int:
    """Six times the volume of the tetrahedron on a triangle from the origin."""
    a, b, c = corners
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])


def area_of(corners: list[list[int]]) -> mpf:
    """Twice the area of a triangle."""
    a, b, c = corners
    e, f = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
    n = [e[(k + 1) % 3] * f[(k + 2) % 3] - e[(k + 2) % 3] * f[(k + 1) % 3] for k in range(3)]
    return sqrt(mpf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]))


def written(tree: Any) -> Any:
    """Doubles as text that reads back to the same bits."""
    if isinstance(tree, float):
        return repr(tree)
    if isinstance(tree, dict):
        return {name: written(part) for name, part in tree.items()}
    return [written(part) for part in tree] if isinstance(tree, list | tuple) else tree


def main() -> None:
    """Write every case."""
    mp.dps = 90
    out = []
    every = [("mesh", *case) for case in cases()] + [("large mesh", *case) for case in large_cases()]
    every += [("overlapping mesh", "hard", *case) for case in inertia_found.OVERLAPPING]
    for task, kind, name, why, inputs in every:
        case = {"task": task, "kind": kind, "name": name, **({"why": why} if why else {})}
        out.append({**case, "inputs": written(inputs), "results": integrals(inputs)})
    put("inertia_mesh", ABOUT, out, "  ")


if __name__ == "__main__":
    main()
