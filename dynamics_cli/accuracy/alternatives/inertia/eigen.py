"""Principal moments: Jacobi's rotations, LAPACK, and the trigonometric formula, on matrices as bodies have them."""

import math
from decimal import Decimal

from dynamics_cli.accuracy.cases import Case
from dynamics_cli.accuracy.measure import DIGITS, Errors

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row

    Matrix = tuple[tuple[float, float, float], ...]
    Answer = tuple[list[float], list[float] | None]
    Axes = Sequence[Sequence[float]]


def jacobi(rows: "Matrix") -> "Answer":
    """The program's own, with its bounds."""
    from dynamics_cli.numerics.eigen3.jacobi import eigen

    eigenvalues = eigen(rows).refined()  # type: ignore[arg-type]
    return list(eigenvalues.values), list(eigenvalues.bounds)


def lapack(rows: "Matrix") -> "Answer":
    """Reduction to tridiagonal form and QR, as numpy offers it."""
    import numpy as np

    return np.linalg.eigvalsh(np.array(rows))[::-1].tolist(), None


def trigonometric(rows: "Matrix") -> "Answer":
    """The textbook's closed form: Cardano's roots by an arc cosine."""
    (a, d, e), (_, b, f), (_, _, c) = rows
    mean = (a + b + c) / 3.0
    p = math.sqrt(((a - mean) ** 2 + (b - mean) ** 2 + (c - mean) ** 2 + 2.0 * (d * d + e * e + f * f)) / 6.0)
    a, b, c, d, e, f = ((a - mean) / p, (b - mean) / p, (c - mean) / p, d / p, e / p, f / p)
    half = 0.5 * (a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e))
    angle = math.acos(max(-1.0, min(1.0, half))) / 3.0
    greatest = mean + 2.0 * p * math.cos(angle)
    least = mean + 2.0 * p * math.cos(angle + 2.0 * math.pi / 3.0)
    return [greatest, 3.0 * mean - greatest - least, least], None


METHODS: "tuple[tuple[str, Callable[[Matrix], Answer]], ...]" = (
    ("Jacobi, an exact quotient each (chosen)", jacobi),
    ("LAPACK eigvalsh", lapack),
    ("trigonometric", trigonometric),
)


def jacobi_axes(rows: "Matrix") -> "Axes":
    """The program's own."""
    from dynamics_cli.numerics.eigen3.jacobi import eigen

    return eigen(rows).vectors  # type: ignore[arg-type]


def lapack_axes(rows: "Matrix") -> "Axes":
    """Of numpy's eigh."""
    import numpy as np

    return np.linalg.eigh(np.array(rows))[1].T[::-1].tolist()  # type: ignore[no-any-return]


def textbook_axes(rows: "Matrix") -> "Axes":
    """Across the rows of A − λ·1, by the eigenvalues of the trigonometric formula."""
    found = []
    for value in trigonometric(rows)[0]:
        a, b, c = (tuple(x - (value if i == j else 0.0) for j, x in enumerate(row)) for i, row in enumerate(rows))
        best = max((_cross(a, b), _cross(b, c), _cross(c, a)), key=_length)
        size = _length(best)
        found.append(tuple(x / size for x in best))
    return found


def _cross(a: "Sequence[float]", b: "Sequence[float]") -> "tuple[float, float, float]":
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _length(v: "Sequence[float]") -> float:
    return math.hypot(*v)


AXES: "tuple[tuple[str, Callable[[Matrix], Axes]], ...]" = (
    ("Jacobi (chosen)", jacobi_axes),
    ("LAPACK eigh", lapack_axes),
    ("trigonometric, across two rows", textbook_axes),
)


def _tilt(axis: "Sequence[float]", case: Case, place: int) -> float:
    """The sine of the angle between an axis and the true one, times the least relative gap between the eigenvalues.

    Nearly equal eigenvalues determine no axes; what is left is what the method itself loses.
    """
    true = [Decimal(case.results[f"axes[{place}][{j}]"]) for j in range(3)]
    own = [Decimal(x) for x in axis]
    parts = [DIGITS.subtract(own[i] * true[j], own[j] * true[i]) for i, j in ((0, 1), (1, 2), (2, 0))]
    values = [Decimal(case.results[f"values[{k}]"]) for k in range(3)]
    mine = values.pop(place)
    gap = min(abs(mine - other) / (abs(mine) + abs(other)) for other in values)
    return math.hypot(*map(float, parts)) * float(gap)


def compare_axes(comparing: "Comparing") -> "list[Row]":
    """Principal axes: errors are angles times relative gaps."""

    def answer(errors: "Errors", case: Case, function: "Callable[[Matrix], Axes]", _: int) -> "Callable[[], Any]":
        for place, axis in enumerate(function(_rows(case))):
            errors.note(f"{case.name}: axis {place + 1}", _tilt(axis, case, place), None)
        rows = _rows(case)
        return lambda: function(rows)

    return comparing.rows(AXES, comparing.cases("eigen.json"), answer, most=comparing.pace.timed_cases)


def _rows(case: Case) -> "Matrix":
    return tuple(tuple(float(x) for x in line) for line in case.inputs["rows"])  # type: ignore[misc]


def compare(comparing: "Comparing") -> "list[Row]":
    """Every method over every matrix; errors are relative to each eigenvalue itself."""

    def answer(errors: "Errors", case: Case, function: "Callable[[Matrix], Any]", _: int) -> "Callable[[], Any]":
        rows = _rows(case)
        values, bounds = function(rows)
        for place in range(3):
            address, bound = f"values[{place}]", bounds[place] if bounds else None
            errors.add(f"{case.name}: {address}", values[place], case.results[address], bound)
        return lambda: function(rows)

    return comparing.rows(METHODS, comparing.cases("eigen.json"), answer, most=comparing.pace.timed_cases, shared=True)
