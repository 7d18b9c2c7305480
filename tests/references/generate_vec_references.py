"""Writes vec.json: the vector tasks' answers to 40 digits, for ordinary and hard inputs.

Run: python tests/references/generate_vec_references.py [FILE]. The same bytes every time. A double of at most 15 digits
stands for that decimal, any other for itself. Angles come from arc cosines in 400 digits, never from arc tangents;
polygons from the law of cosines, feet from normal equations, triads from Gram and Schmidt, bases from Cramer's rule.
"""

import random
import sys
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import permutations
from typing import Any

from case_files import put
from mpmath import acos, atan2, cos, mp, mpf, pi, sin, sqrt

mp.dps = 400
LARGEST = Fraction(sys.float_info.max)
Vector = list[Any]


def exact(x: float) -> Fraction:
    """What a double stands for."""
    digits = repr(x).partition("e")[0].replace(".", "").replace("-", "").strip("0")
    return Fraction(repr(x)) if len(digits) <= 15 else Fraction(x)


def real(x: Any) -> Any:
    """Many digits of a ratio."""
    return mpf(x.numerator) / x.denominator if isinstance(x, Fraction) else mpf(x)


def vector(v: Sequence[float]) -> Vector:
    """Three exact components."""
    parts = [exact(float(x)) for x in v]
    return parts + [Fraction(0)] * (3 - len(parts))


def dot(a: Vector, b: Vector) -> Any:
    return sum(x * y for x, y in zip(a, b, strict=True))


def determinant(*rows: Vector) -> Any:
    total = Fraction(0)
    for order in permutations(range(3)):
        sign = (order[0] - order[1]) * (order[1] - order[2]) * (order[2] - order[0]) // 2
        term = Fraction(sign)
        for row, column in zip(rows, order, strict=True):
            term = term * row[column]
        total += term
    return total


UNITS = [[Fraction(int(i == j)) for j in range(3)] for i in range(3)]


def cross(a: Vector, b: Vector) -> Vector:
    """By determinants with the unit vectors."""
    return [determinant(unit, a, b) for unit in UNITS]


def length(a: Vector) -> Any:
    return sqrt(real(dot(a, a)))


def between(a: Vector, b: Vector) -> Any:
    """The angle by its cosine."""
    return acos(real(dot(a, b)) / (length(a) * length(b)))


def indexed(name: str, parts: Sequence[Any], size: int = 3) -> dict[str, Any]:
    return {f"{name}[{i}]": parts[i] for i in range(size)}


def resultant(vectors: list[Any], between: float | None = None) -> dict[str, Any]:
    if between is not None:
        a, b, turn = exact(vectors[0]), exact(vectors[1]), mpf(between)
        size = sqrt(real(a * a + b * b) + 2 * real(a * b) * cos(turn))
        return {"magnitude": size, "nearly parallel directions, between which the parts cancel": real(a + b) / size}
    planar = all(len(v) == 2 for v in vectors)
    those = [vector(v) for v in vectors]
    whole = [sum(v[i] for v in those) for i in range(3)]
    size = length(whole)
    out = {**indexed("resultant", whole, 2 if planar else 3), "magnitude": size}
    if size:
        out["nearly parallel directions, between which the parts cancel"] = sum(length(v) for v in those) / size
        if not planar:
            out |= {f"angle_{axis}": acos(real(whole[i]) / size) for i, axis in enumerate("xyz")}
    return out


def direction(vector_: list[float], point: list[float] | None = None) -> dict[str, Any]:
    a = vector(vector_)
    way = a if point is None else [q - p for p, q in zip(a, vector(point), strict=True)]
    size = length(way)
    out = {"magnitude": size, "angle_x": acos(real(way[0]) / size), "angle_y": acos(real(way[1]) / size)}
    if len(vector_) == 3:
        out["angle_z"] = acos(real(way[2]) / size)
    return out | {f"direction[{i}]": real(way[i]) / size for i in range(len(vector_))}


def angle(first: list[float], second: list[float], axis: list[float] | None = None) -> dict[str, Any]:
    a, b = vector(first), vector(second)
    if axis is not None:
        n = vector(axis)
        square = dot(n, n)
        flat = [[x - dot(v, n) * y / square for x, y in zip(v, n, strict=True)] for v in (a, b)]
        turn = between(*flat)
        return {"angle": turn if determinant(n, a, b) >= 0 else -turn}
    turn = between(a, b)
    rest = between(a, [-x for x in b])
    return {"angle": turn, "supplement": rest, "cosine": cos(turn), "sine": sin(turn)}


def product(first: list[float], second: list[float], third: list[float] | None = None) -> dict[str, Any]:
    a, b = vector(first), vector(second)
    c = cross(a, b)
    out = {"scalar_product": dot(a, b), **indexed("vector_product", c), "parallelogram": length(c)}
    out["triangle"] = length(c) / 2
    if third is not None:
        d = vector(third)
        whole = determinant(a, b, d)
        out |= {"triple_product": whole, "box": abs(whole), "tetrahedron": abs(whole) / 6}
        out |= indexed("first_with_product", cross(a, cross(b, d))) | indexed("product_with_third", cross(c, d))
    return out


def resolve(vector_: list[float], onto: dict[str, Any]) -> dict[str, Any]:
    v = vector(vector_)
    if "along" in onto:
        turn = between(v, vector(onto["along"]))
        return {"component": length(v) * cos(turn), "across": length(v) * sin(turn), "angle": turn}
    if "normal" in onto:
        turn = between(v, vector(onto["normal"]))
        return {"out_of_plane": length(v) * cos(turn), "in_plane": length(v) * sin(turn), "angle": pi / 2 - turn}
    basis = [vector(onto[name]) for name in ("first", "second", "third") if name in onto]
    if len(basis) == 2:
        basis.append(UNITS[2])
    below = determinant(*basis)
    out: dict[str, Any] = {}
    for i in range(len(onto)):
        swapped = [v if i == j else b for j, b in enumerate(basis)]
        coefficient = determinant(*swapped) / below
        out[f"components[{i}].coefficient"] = coefficient
        out[f"components[{i}].component"] = real(coefficient) * length(basis[i])
    return out


def polygon(sum_: list[float], magnitudes: list[float], directions: list[float]) -> dict[str, Any]:
    x, y = (real(exact(part)) for part in sum_)
    size, way = sqrt(x * x + y * y), atan2(y, x)
    out: dict[str, Any] = {}
    if len(magnitudes) == 2:
        a, b = (real(exact(part)) for part in magnitudes)
        turn = acos((size * size + a * a - b * b) / (2 * size * a))
        for i, sign in enumerate((-1, 1) if turn else (1,)):
            p = a * cos(way + sign * turn), a * sin(way + sign * turn)
            q = x - p[0], y - p[1]
            out |= indexed(f"solutions[{i}].first", p, 2) | indexed(f"solutions[{i}].second", q, 2)
        return out
    one, other = (mpf(part) for part in directions)
    # the sine rule in the triangle of the two directions and the sum
    out["solutions[0].first_magnitude"] = size * sin(other - way) / sin(other - one)
    out["solutions[0].second_magnitude"] = size * sin(way - one) / sin(other - one)
    return out


def frame(x: list[float], y: list[float], vector_: list[float]) -> dict[str, Any]:
    a, b = vector(x), vector(y)
    first = [real(part) / length(a) for part in a]
    rest = [q - dot(a, b) * p / dot(a, a) for p, q in zip(a, b, strict=True)]
    second = [real(part) / length(rest) for part in rest]
    third = [real(part) / length(cross(a, rest)) for part in cross(a, rest)]
    v = [real(part) for part in vector(vector_)]
    rows = (first, second, third)
    out = {
        key: value for name, row in zip("xyz", rows, strict=True) for key, value in indexed(f"{name}_axis", row).items()
    }
    return {**out, **indexed("components", [dot(v, row) for row in rows]), "departure": abs(between(a, b) - pi / 2)}


def lines(first: dict[str, Any], second: dict[str, Any]) -> dict[str, Any]:
    p, q = vector(first["point"]), vector(second["point"])
    gap = [b - a for a, b in zip(p, q, strict=True)]
    if "normal" in second:
        n = vector(second["normal"])
        height = dot(gap, n) / dot(n, n)
        if "direction" not in first:
            foot = [a + height * b for a, b in zip(p, n, strict=True)]
            return {"distance": abs(real(height)) * length(n), **indexed("second_foot", foot)}
        u = vector(first["direction"])
        along = dot(gap, n) / dot(u, n)
        meet = [a + along * b for a, b in zip(p, u, strict=True)]
        return {**indexed("intersection", meet), "angle": abs(pi / 2 - between(u, n))}
    u, v = vector(first["direction"]), vector(second["direction"])
    # |p + su − q − tv|² is least where its derivatives vanish
    a, b, c = dot(u, u), -dot(u, v), dot(v, v)
    d, e = dot(u, gap), -dot(v, gap)
    if a * c == b * b:
        along = dot(u, gap) / a
        rest = [x - along * y for x, y in zip(gap, u, strict=True)]
        return {"distance": length(rest), "angle": mpf(0)}
    s, t = (d * c - e * b) / (a * c - b * b), (a * e - b * d) / (a * c - b * b)
    one = [x + s * y for x, y in zip(p, u, strict=True)]
    other = [x + t * y for x, y in zip(q, v, strict=True)]
    turn = between(u, v)
    rest = [x - y for x, y in zip(one, other, strict=True)]
    out = {"distance": length(rest), "angle": min(turn, pi - turn)}
    return out | indexed("first_foot", one) | indexed("second_foot", other)


TASKS = {
    "resultant": resultant, "direction": direction, "angle": angle, "product": product, "resolve": resolve,
    "polygon": polygon, "frame": frame, "lines": lines,
}  # fmt: skip


def basis(name: str, *rows: list[float]) -> dict[str, Any]:
    return {"record": name, **dict(zip(("first", "second", "third"), rows, strict=False))}


def hard() -> Iterator[tuple[str, str, str, dict[str, Any]]]:
    near = 1.0 + 2.0**-40
    yield (
        "angle",
        "nearly parallel, 1e-9",
        "the arc cosine of their cosine gives zero in doubles",
        {"first": [1.0, 0.0, 0.0], "second": [1.0, 1e-9, 0.0]},
    )
    yield (
        "angle",
        "nearly parallel by 2⁻⁴⁰",
        "doubles of 17 digits, which are not what a person typed",
        {"first": [1.0, 1.0, 1.0], "second": [1.0, 1.0, near]},
    )
    yield (
        "angle",
        "nearly opposite by 2⁻³⁰",
        "π less a small angle, which the cosine does not show",
        {"first": [1.0, 2.0, 3.0], "second": [-1.0, -2.0, -3.0 - 2.0**-30]},
    )
    yield (
        "angle",
        "nearly square",
        "the cosine is a difference of products that cancels",
        {"first": [0.1, 0.2, 0.3], "second": [0.3, 0.3, -0.3000000001]},
    )
    for size in (1e-300, 1e-61, 1e-59, 1e59, 1e61, 1e200, 3e307):
        why = "components whose squares leave the range of doubles, or next to where they are scaled"
        yield "angle", f"components of {size:g}", why, {"first": [size, 2.0, 0.0] if size > 1 else [size, 0.0, 0.0],
                                                       "second": [0.5 * size, 0.75 * size, 0.0]}  # fmt: skip
    yield "angle", "signed about an axis", "the angle of the parts across the axis", {
        "first": [1.0, 0.2, 3.0], "second": [1.0, 0.1, -2.0], "axis": [0.0, 0.0, 2.0]}  # fmt: skip
    yield "direction", "the book's data", "", {"vector": [8.0, 12.0, 7.0]}
    yield (
        "direction",
        "almost along x",
        "a small direction angle, whose cosine rounds to one",
        {"vector": [1.0, 1e-12, -3e-13]},
    )
    yield "direction", "between far points", "the direction is a small difference of long vectors", {
        "vector": [1e8, 2.5, 0.1], "point": [100000000.1, 2.4, 0.3]}  # fmt: skip
    yield "resultant", "two magnitudes at 60 degrees", "", {"vectors": [15.0, 12.0], "between": 1.0471975511965976}
    yield "resultant", "two magnitudes almost opposite", "the law of cosines cancels to the small difference of both", {
        "vectors": [10.0, 10.0], "between": 3.141592}  # fmt: skip
    yield "resultant", "almost in equilibrium", "the sum cancels to some last digits of its parts", {
        "vectors": [[0.1, 0.2, 0.3], [0.2, 0.1, -0.6], [-0.3, -0.3, 0.3000000001]]}  # fmt: skip
    yield "resultant", "sixteen digits that cancel", "not a decimal of 15 digits, so a double", {
        "vectors": [[0.1234567890123456, 1.0], [-0.1234567890123, -1.0]]}  # fmt: skip
    yield "product", "coplanar decimals", "the triple product is zero as typed, and not in doubles", {
        "first": [0.1, 0.2, 0.3], "second": [0.4, 0.5, 0.6], "third": [0.7, 0.8, 0.9]}  # fmt: skip
    yield "product", "nearly coplanar", "the determinant cancels to some last digits of its terms", {
        "first": [1.0, 2.0, 3.0], "second": [4.0, 5.0, 6.0], "third": [7.0, 8.0, 9.0000000001]}  # fmt: skip
    yield "product", "a long thin triangle", "products of 1e8 that differ by one", {
        "first": [1e8, 1.0], "second": [2e8, 2.00000001]}  # fmt: skip
    oblique = basis("Basis", [1.0, 0.0, 0.0], [1.0, 1e-6, 0.0], [1.0, 1.0, 1e-3])
    yield (
        "resolve",
        "an oblique basis of condition 1e9",
        "nearly parallel directions, between which the parts cancel",
        {"vector": [2.0, 3.0, 4.0], "onto": oblique},
    )
    yield "resolve", "almost across", "a component that cancels to a small part of the vector", {
        "vector": [1.0, 2.0, 3.0], "onto": {"record": "Along", "along": [3.0, 3.0, -2.99999999999]}}  # fmt: skip
    yield "resolve", "almost in the plane", "a component that cancels to a small part of the vector", {
        "vector": [0.1, 0.2, 0.3], "onto": {"record": "Plane", "normal": [0.3, 0.3, -0.30000000001]}}  # fmt: skip
    yield "polygon", "two directions", "", {"sum_": [6.0, 2.0], "magnitudes": [5.0, 4.0], "directions": []}
    yield "polygon", "stretched but for 1e-9", "the height is a root whose terms cancel nearly to zero", {
        "sum_": [3.0, 4.0], "magnitudes": [2.0, 3.000000001], "directions": []}  # fmt: skip
    yield (
        "polygon",
        "stretched exactly",
        "the two polygons are one: a double root at the limit",
        {"sum_": [0.3, 0.4], "magnitudes": [0.1, 0.4], "directions": []},
    )
    yield "polygon", "two magnitudes nearly parallel", "the sine between the two known directions is small", {
        "sum_": [1.0, 0.5], "magnitudes": [], "directions": [0.25, 0.2500001]}  # fmt: skip
    yield "lines", "nearly parallel lines", "nearly parallel lines, whose feet lie very far away", {
        "first": {"record": "Item", "point": [1.0, 2.0, 3.0], "direction": [1.0, 1.0, 1.0]},
        "second": {"record": "Item", "point": [4.0, 0.5, -1.0], "direction": [1.0, 1.0, 1.0001]}}  # fmt: skip
    yield "lines", "parallel decimals", "parallel as typed, not in doubles", {
        "first": {"record": "Item", "point": [1.0, 2.0, 3.0], "direction": [0.1, 0.2, 0.3]},
        "second": {"record": "Item", "point": [4.0, 0.5, -1.0], "direction": [0.3, 0.6, 0.9]}}  # fmt: skip
    yield "frame", "nearly parallel directions", "the second axis is the small rest of nearly parallel vectors", {
        "x": [1.0, 1.0, 0.0], "y": [1.0, 1.0000001, 0.0000001], "vector": [1.0, 2.0, 3.0]}  # fmt: skip
    yield "frame", "nearly square", "a small departure from a right angle is asked for", {
        "x": [3.0, 4.0, 0.0], "y": [-4.0, 3.0000000001, 1.0], "vector": [0.0, 0.0, -9.81]}  # fmt: skip


def drawn(generator: random.Random) -> Iterator[tuple[str, dict[str, Any]]]:
    def v(size: int = 3) -> list[float]:
        return [round(generator.uniform(-10.0, 10.0), 2) if generator.random() < 0.5 else generator.uniform(-10.0, 10.0)
                for _ in range(size)]  # fmt: skip

    for _ in range(8):
        yield "resultant", {"vectors": [v() for _ in range(generator.randint(2, 4))]}
        yield "resultant", {"vectors": [v(2) for _ in range(3)]}
        yield "direction", {"vector": v(), "point": v()}
        yield "angle", {"first": v(), "second": v()}
        yield "angle", {"first": v(), "second": v(), "axis": v()}
        yield "product", {"first": v(), "second": v(), "third": v()}
        yield "resolve", {"vector": v(), "onto": {"record": "Along", "along": v()}}
        yield "resolve", {"vector": v(2), "onto": basis("Basis", v(2), v(2))}
        yield "resolve", {"vector": v(), "onto": basis("Basis", v(), v(), v())}
        a, b = (round(generator.uniform(3.0, 9.0), 2) for _ in range(2))
        turn, size = generator.uniform(-3.0, 3.0), generator.uniform(abs(a - b) + 0.5, a + b - 0.5)
        sum_ = [round(float(size * cos(turn)), 3), round(float(size * sin(turn)), 3)]
        yield "polygon", {"sum_": sum_, "magnitudes": [a, b], "directions": []}
        yield "polygon", {"sum_": sum_, "magnitudes": [], "directions": [0.4, generator.uniform(1.0, 2.5)]}
        yield "frame", {"x": v(), "y": v(), "vector": v()}
        item = {"record": "Item"}
        yield (
            "lines",
            {"first": {**item, "point": v(), "direction": v()}, "second": {**item, "point": v(), "direction": v()}},
        )
        yield "lines", {"first": {**item, "point": v()}, "second": {**item, "point": v(), "normal": v()}}
        yield (
            "lines",
            {"first": {**item, "point": v(), "direction": v()}, "second": {**item, "point": v(), "normal": v()}},
        )


def written(tree: Any) -> Any:
    if isinstance(tree, float):
        return repr(tree)
    if isinstance(tree, dict):
        return {name: part if name == "record" else written(part) for name, part in tree.items()}
    return [written(part) for part in tree] if isinstance(tree, list) else tree


def case(task: str, kind: str, name: str, why: str, inputs: dict[str, Any]) -> dict[str, Any]:
    # the generator's names for what would hide its own functions
    renamed = {"vector_" if key == "vector" else key: part for key, part in inputs.items()}
    parts = {key: {k: p for k, p in part.items() if k != "record"} if isinstance(part, dict) else part
             for key, part in renamed.items()}  # fmt: skip
    results = {
        key: mp.nstr(real(value), 40, min_fixed=1, max_fixed=0)
        for key, value in TASKS[task](**parts).items()
        if abs(value) < LARGEST
    }
    return {"task": task, "kind": kind, "name": name, **({"why": why} if why else {}), "inputs": written(inputs),
            "results": results}  # fmt: skip


def main() -> None:
    cases = [case(task, "hard" if why else "ordinary", name, why, inputs) for task, name, why, inputs in hard()]
    for nth, (task, inputs) in enumerate(drawn(random.Random(5)), 1):
        cases.append(case(task, "ordinary", f"drawn, {nth}", "", inputs))
    about = "Written by generate_vec_references.py: doubles of at most 15 digits are decimals, results to 40 digits."
    put("vec", about, cases)


if __name__ == "__main__":
    main()
