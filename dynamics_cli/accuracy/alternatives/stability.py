"""Stability as textbooks and scripts have it: Routh's array with ε, numpy.roots, sweeps of gain or frequency."""

import cmath
import math
from fractions import Fraction
from itertools import pairwise, zip_longest

from dynamics_cli.accuracy.questions import Method, Question, textbooks
from dynamics_cli.numerics.exact.polynomial_text import read
from dynamics_cli.numerics.exact.rational import exact
from dynamics_cli.stability.matrix import matrix

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

FILE, HERE = "stability_roots.json", "dynamics_cli.accuracy.alternatives.stability:"
# What scripts put for a zero pivot, and what they take for the axis.
EPSILON, ON_AXIS = 1e-6, 1e-9
STEPS = 1000


def own_matrix(**given: "Any") -> "Any":
    """The program's own, of doubles."""
    rows = {name: tuple(tuple(map(exact, row)) for row in rows) for name, rows in given.items()}
    return matrix(rows.pop("matrix", None), **rows)  # type: ignore[arg-type]


def _numbers(text: str, variable: str = "s", gain: str = "", power: int = 0) -> "list[Fraction]":
    """Coefficients from the highest power down, of a power of the gain."""
    terms = read(text, variable, gain)
    return [Fraction(*terms.get((k, power), (0, 1))) for k in range(max(k for k, _ in terms), -1, -1)]


def _sides(numbers: "Any", names: "tuple[str, str, str]" = ("left", "right", "axis")) -> "dict[str, float]":
    left, right = (sum(sign * x > ON_AXIS for x in numbers) for sign in (-1, 1))
    return dict(zip(names, (left, right, len(numbers) - left - right), strict=True))


def by_epsilon(polynomial: str) -> "dict[str, float]":
    """Sign changes in Routh's array: a zero pivot becomes a small number, a row of zeros the derivative above."""
    p = [float(c) for c in _numbers(polynomial)]
    degree = len(p) - 1
    rows = [p[::2], [*p[1::2], *[0.0] * (len(p) % 2)]]
    even = None
    for k in range(1, degree + 1):
        above, row = rows[-2], rows[-1]
        if not any(row):
            # derived from the even polynomial above
            powers = [degree - k + 1 - 2 * j for j in range(len(row))]
            even = degree - k + 1 if even is None else even
            rows[-1] = row = [power * c for power, c in zip(powers, above, strict=False) if power > 0]
        elif not row[0]:
            rows[-1] = row = [EPSILON, *row[1:]]
        if k < degree:
            rows.append([a - above[0] / row[0] * b for a, b in zip_longest(above[1:], row[1:], fillvalue=0.0)])
    column = [row[0] for row in rows]
    changes = sum((a < 0) != (b < 0) for a, b in pairwise(column))
    within = 0 if even is None else sum((a < 0) != (b < 0) for a, b in pairwise(column[degree - even :]))
    axis = 0 if even is None else even - 2 * within
    return {"left": degree - changes - axis, "right": changes, "axis": axis}


def _top(roots: "Any") -> "dict[str, float]":
    """The root that decides, and how many are where."""
    first = max(roots, key=lambda z: (z.real, -abs(z.imag)))
    results = {"rightmost": first.real, "roots[0].real": first.real, "roots[0].imaginary": abs(first.imag)}
    return results | _sides([z.real for z in roots])


def circle_by_roots(polynomial: str) -> "dict[str, float]":
    """The sizes of numpy's roots."""
    import numpy as np

    sizes = abs(np.roots([float(c) for c in _numbers(polynomial, "z")]))
    return {"largest": max(sizes)} | _sides(sizes - 1.0, ("inside", "outside", "circle"))


def _first_order(given: "dict[str, Any]") -> "Any":
    import numpy as np

    if "matrix" in given:
        return np.array(given["matrix"])
    mass, stiffness = np.array(given["mass"]), np.array(given["stiffness"])
    none = np.zeros(mass.shape)
    rates = np.array(given.get("damping", none)) + np.array(given.get("gyroscopic", none))
    over = np.linalg.inv(mass)
    return np.block([[none, np.eye(len(mass))], [-over @ stiffness, -over @ rates]])


def by_eigenvalues(**given: "Any") -> "dict[str, float]":
    """QR of LAPACK."""
    import numpy as np

    return _top(np.linalg.eigvals(_first_order(given)))


def gain_by_sweep(polynomial: str) -> "dict[str, float]":
    """A root locus of a thousand gains, read where it crosses the axis."""
    import numpy as np

    p, q = (np.array([float(c) for c in _numbers(polynomial, gain="K", power=power)]) for power in (0, 1))

    def right(gain: float) -> int:
        return int((np.roots(p + gain * q).real > 0.0).sum())

    sizes = [10.0 ** (24.0 * k / STEPS - 6.0) for k in range(STEPS // 2 + 1)]
    results: dict[str, float] = {}
    for low, high in pairwise([*(-size for size in reversed(sizes)), 0.0, *sizes]):
        if right(high) == right(low):
            continue
        gain = 0.5 * (low + high)
        swing = min(np.roots(p + gain * q), key=lambda z: abs(z.real))
        place = f"critical[{len(results) // 2}]."
        results |= {place + "gain": gain, place + "frequency": abs(swing.imag)}
    return results


def _crossings(p: "Any", q: "Any", frequencies: "Sequence[float]") -> "dict[str, float]":
    results, first = {}, []
    for k, omega in enumerate(sorted(frequencies, reverse=True)):
        ratio = -_at(q, omega) / _at(p, omega)
        first.append(cmath.phase(ratio) % (2.0 * math.pi) / omega)
        results[f"crossings[{k}].frequency"] = omega
        results |= {f"crossings[{k}].first": first[-1], f"crossings[{k}].spacing": 2.0 * math.pi / omega}
    return results | {"first_unstable": min(first)}


def _at(p: "Sequence[float]", omega: float) -> complex:
    value = 0j
    for c in p:
        value = value * 1j * omega + c
    return value


def delay_by_sweep(polynomial: str, *, delayed: str) -> "dict[str, float]":
    """Phase margin over crossover frequency, read from a thousand frequencies."""
    p, q = ([float(c) for c in _numbers(text)] for text in (polynomial, delayed))
    places = [10.0 ** (5.0 * k / STEPS - 3.0) for k in range(STEPS + 1)]
    sizes = [math.log(abs(_at(q, omega)) / abs(_at(p, omega))) for omega in places]
    met = [
        a - one * (b - a) / (other - one)
        for (a, one), (b, other) in pairwise(zip(places, sizes, strict=True))
        if (one < 0.0) != (other < 0.0)
    ]
    return _crossings(p, q, met)


QUESTIONS = (
    Question(
        "stability", "matrix", "stability matrix", FILE, "matrix",
        Method("exact counts", HERE + "own_matrix", chosen=True),
        Method("numpy.linalg.eigvals", HERE + "by_eigenvalues"),
    ),
    *textbooks(
        "stability", FILE, HERE,
        ("routh", "textbook: Routh's array with ε, counts alone", "by_epsilon"),
        ("gain", "textbook: root locus of 1,000 gains", "gain_by_sweep"),
        ("delay", "textbook: phase margin from 1,000 frequencies", "delay_by_sweep"),
        ("discrete", "numpy.roots, the circle within 1e-9", "circle_by_roots"),
    ),
)  # fmt: skip
