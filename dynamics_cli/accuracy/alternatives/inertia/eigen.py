"""Principal moments: Jacobi's rotations and the trigonometric formula, on matrices as bodies have them."""

import math
from decimal import Decimal

from dynamics_cli.accuracy.measure import DIGITS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.rows import Row

    Matrix = tuple[tuple[float, float, float], ...]
    Axes = Sequence[Sequence[float]]


def _values(values: "Sequence[Any]") -> "dict[str, Any]":
    return {f"values[{k}]": value for k, value in enumerate(values)}


def jacobi(*, rows: "Any") -> "dict[str, Any]":
    """The program's own, with its bounds."""
    from dynamics_cli.numerics.eigen3.jacobi import eigen
    from dynamics_cli.numerics.tracked import Tracked

    eigenvalues = eigen(rows).refined()
    return _values([Tracked(*pair, ()) for pair in zip(eigenvalues.values, eigenvalues.bounds, strict=True)])


def by_arc_cosine(*, rows: "Any") -> "dict[str, float]":
    """The textbook's closed form."""
    return _values(trigonometric(rows))


def trigonometric(rows: "Matrix") -> "list[float]":
    """Cardano's roots by an arc cosine, the greatest first."""
    (a, d, e), (_, b, f), (_, _, c) = rows
    mean = (a + b + c) / 3.0
    p = math.sqrt(((a - mean) ** 2 + (b - mean) ** 2 + (c - mean) ** 2 + 2.0 * (d * d + e * e + f * f)) / 6.0)
    a, b, c, d, e, f = ((a - mean) / p, (b - mean) / p, (c - mean) / p, d / p, e / p, f / p)
    half = 0.5 * (a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e))
    angle = math.acos(max(-1.0, min(1.0, half))) / 3.0
    greatest = mean + 2.0 * p * math.cos(angle)
    least = mean + 2.0 * p * math.cos(angle + 2.0 * math.pi / 3.0)
    return [greatest, 3.0 * mean - greatest - least, least]


def jacobi_axes(rows: "Matrix") -> "Axes":
    """The program's own."""
    from dynamics_cli.numerics.eigen3.jacobi import eigen

    return eigen(rows).vectors  # type: ignore[arg-type]


def textbook_axes(rows: "Matrix") -> "Axes":
    """Across the rows of A − λ·1, by the eigenvalues of the trigonometric formula."""
    axes = []
    for value in trigonometric(rows):
        a, b, c = (tuple(x - (value if i == j else 0.0) for j, x in enumerate(row)) for i, row in enumerate(rows))
        best = max((_cross(a, b), _cross(b, c), _cross(c, a)), key=lambda v: math.hypot(*v))
        size = math.hypot(*best)
        axes.append(tuple(x / size for x in best))
    return axes


def _cross(a: "Sequence[float]", b: "Sequence[float]") -> "tuple[float, float, float]":
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _tilt(axis: "Sequence[float]", case: "Case", place: int) -> float:
    """The sine of the angle between an axis and the true one, times the least relative gap between the eigenvalues.

    Nearly equal eigenvalues determine no axes; what is left is what the method itself loses.
    """
    true = [Decimal(case.results[f"axes[{place}][{j}]"]) for j in range(3)]
    given = [Decimal(x) for x in axis]
    parts = [DIGITS.subtract(given[i] * true[j], given[j] * true[i]) for i, j in ((0, 1), (1, 2), (2, 0))]
    values = [Decimal(case.results[f"values[{k}]"]) for k in range(3)]
    mine = values.pop(place)
    gap = min(abs(mine - other) / (abs(mine) + abs(other)) for other in values)
    return math.hypot(*map(float, parts)) * float(gap)


def compare_axes(comparing: "Comparing") -> "list[Row]":
    """Principal axes: errors are angles times relative gaps."""

    def answer(errors: "Errors", case: "Case", function: "Any", _: int) -> "Callable[[], Axes]":
        rows: Matrix = tuple(tuple(map(float, line)) for line in case.inputs["rows"])  # type: ignore[misc]
        for place, axis in enumerate(function(rows)):
            errors.note(f"{case.name}: axis {place + 1}", _tilt(axis, case, place), None)
        return lambda: function(rows)

    methods = (
        ("Jacobi (chosen)", jacobi_axes),
        ("trigonometric, across two rows", textbook_axes),
    )
    return comparing.rows(methods, comparing.cases("eigen.json"), answer, most=comparing.pace.timed_cases)
