"""Vectors of exact ratios: sums and products of what was typed, rounded once at the end.

A calculated component, as of `20 N @ 120 deg`, is taken to 15 digits of its vector: then sines and cosines of simple
angles cancel as they do on paper.
"""

from math import floor, frexp, isfinite, lcm

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.numerics.exact.rational import lowest, nearest, product, total
from dynamics_cli.numerics.exact.typed import TypedNumber

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.numerics.exact.rational import Pair

    Ratios = tuple[Pair, Pair, Pair]

ZERO: "Pair" = (0, 1)
NONE: "Ratios" = (ZERO, ZERO, ZERO)
AXES: "tuple[Ratios, ...]" = (((1, 1), ZERO, ZERO), (ZERO, (1, 1), ZERO), (ZERO, ZERO, (1, 1)))
DIGITS = 15


def of_number(x: float, largest: float = 0.0) -> "Pair":
    """The exact ratio of a typed number; a calculated one to 15 digits of the largest component of its vector."""
    require(isfinite(x), "a number is too large for a double", code="range", hint="check the inputs")
    if isinstance(x, TypedNumber):
        return x.ratio
    size = max(abs(x), largest)
    if size == 0.0 or float(x).is_integer():
        return float(x).as_integer_ratio()
    # the power of ten that is above the largest component
    places = DIGITS - 1 - floor((frexp(size)[1] - 1) * 0.30102999566398114)
    top, bottom = float(x).as_integer_ratio()
    if places < 0:
        return top, bottom
    scaled = top * 10**places
    return lowest((2 * scaled + bottom) // (2 * bottom), 10**places)


def of_vector(parts: "Sequence[float]") -> "Ratios":
    """Three exact components from two or three; a single one is along z, as a couple in the plane is."""
    largest = max(abs(float(part)) for part in parts)
    x = [of_number(part, largest) for part in parts]
    if len(x) == 1:
        return ZERO, ZERO, x[0]
    return x[0], x[1], x[2] if len(x) == 3 else ZERO


def plus(*vectors: "Ratios") -> "Ratios":
    """The exact sum."""
    x, y, z = (total(vector[axis] for vector in vectors) for axis in range(3))
    return x, y, z


def sums(points: "Sequence[Ratios]", forces: "Sequence[Ratios]") -> "tuple[Ratios, Ratios]":
    """The sum of forces and of their moments about the origin, in whole numbers over common denominators."""
    of_points, of_forces = _denominator(points), _denominator(forces)
    total_force, total_moment = [0, 0, 0], [0, 0, 0]
    for point, force in zip(points, forces, strict=True):
        x, y, z = (top * (of_points // bottom) for top, bottom in point)
        u, v, w = (top * (of_forces // bottom) for top, bottom in force)
        for i, part in enumerate((u, v, w)):
            total_force[i] += part
        for i, part in enumerate((y * w - z * v, z * u - x * w, x * v - y * u)):
            total_moment[i] += part
    a, b, c = (lowest(part, of_forces) for part in total_force)
    d, e, f = (lowest(part, of_forces * of_points) for part in total_moment)
    return (a, b, c), (d, e, f)


def _denominator(vectors: "Sequence[Ratios]") -> int:
    """The least common denominator of all components."""
    return lcm(*{bottom for vector in vectors for _, bottom in vector})


def times(factor: "Pair", a: "Ratios") -> "Ratios":
    """A multiple of a vector."""
    return product(factor, a[0]), product(factor, a[1]), product(factor, a[2])


def minus(a: "Ratios", b: "Ratios") -> "Ratios":
    """The vector from `b` to `a`."""
    return plus(a, times((-1, 1), b))


def dot(a: "Ratios", b: "Ratios") -> "Pair":
    """Scalar product."""
    return total(product(x, y) for x, y in zip(a, b, strict=True))


def cross(a: "Ratios", b: "Ratios") -> "Ratios":
    """Vector product."""

    def part(i: int, j: int) -> "Pair":
        return total((product(a[i], b[j]), product((-1, 1), a[j], b[i])))

    return part(1, 2), part(2, 0), part(0, 1)


def over(a: "Pair", b: "Pair") -> "Pair":
    """The exact quotient, where `b` is not zero."""
    return product(a, lowest(b[1], b[0]))


def is_zero(a: "Ratios") -> bool:
    """Whether every component is zero, exactly."""
    return not any(part[0] for part in a)


def rounded(a: "Ratios") -> "Any":
    """The nearest doubles."""
    return nearest(a[0]), nearest(a[1]), nearest(a[2])


def size(a: "Ratios") -> float:
    """The length, to the last bit or two."""
    x, y, z = rounded(a)
    return hypot(hypot(x, y), z)
