"""Principal moments: Jacobi's rotations, LAPACK, and the trigonometric formula, on matrices as bodies have them."""

import math
from statistics import median

from dynamics_cli.accuracy.cases import Case, load
from dynamics_cli.accuracy.measure import Errors, Pace, seconds
from dynamics_cli.accuracy.rows import row

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from dynamics_cli.accuracy.rows import Row

    Matrix = tuple[tuple[float, float, float], ...]
    Answer = tuple[list[float], list[float] | None]


def jacobi(rows: "Matrix") -> "Answer":
    """The program's own, with its bounds."""
    from dynamics_cli.numerics.symmetric import eigen

    found = eigen(rows)  # type: ignore[arg-type]
    return list(found.values), list(found.bounds)


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
    ("Jacobi (chosen)", jacobi),
    ("LAPACK eigvalsh", lapack),
    ("trigonometric", trigonometric),
)


def _rows(case: Case) -> "Matrix":
    return tuple(tuple(float(x) for x in line) for line in case.inputs["rows"])  # type: ignore[misc]


def compare(name: str, *, hard: bool, full: bool, timed: bool) -> "list[Row]":
    """Every method over every matrix; errors are relative to each eigenvalue itself."""
    pace = Pace(full=full)
    cases = [case for case in load("eigen.json") if case.hard or not hard]
    made: list[Row] = []
    base: float | None = None
    for method, function in METHODS:
        errors = Errors()
        for case in cases:
            errors.cases += 1
            values, bounds = function(_rows(case))
            for place, (address, text) in enumerate(case.results.items()):
                errors.add(f"{case.name}: {address}", values[place], text, bounds[place] if bounds else None)
        time = None
        if timed:
            some = [_rows(case) for case in cases[: pace.timed_cases]]
            time = median(
                [seconds(lambda: function(rows), repeats=pace.repeats, least=pace.least) for rows in some]  # noqa: B023
            )
        base = base or time
        made.append(row(name, method, errors, time, base))
    return made
