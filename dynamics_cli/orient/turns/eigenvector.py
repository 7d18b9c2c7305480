"""The quaternion that a symmetric 4×4 matrix singles out: its eigenvector of the largest eigenvalue."""

import math

from dynamics_cli.numerics.elementary import hypot, over_array, where
from dynamics_cli.numerics.number import is_array

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.orientation.quaternions import Quaternion

# Sweeps of Jacobi's rotations, at most, and the pairs of a sweep.
SWEEPS = 30
PAIRS = tuple((p, q) for p in range(4) for q in range(p + 1, 4))


def largest(matrix: "list[list[float]]") -> "tuple[float, Quaternion, float, float]":
    """The largest eigenvalue, its unit eigenvector, the distance to the next one, and the residual |K·q − λ·q|."""
    a = [list(row) for row in matrix]
    vectors = [[1.0 if i == j else 0.0 for j in range(4)] for i in range(4)]
    for _ in range(SWEEPS):
        rough = False
        for p, q in PAIRS:
            rough = rough | (abs(a[p][q]) > 1e-300 + 1e-18 * (abs(a[p][p]) + abs(a[q][q])))
        if not rough:
            break
        for p, q in PAIRS:
            _rotate(a, vectors, p, q)
    values = [a[i][i] for i in range(4)]
    order = sorted(range(4), key=lambda i: -values[i])
    column = [row[order[0]] for row in vectors]
    size = _length(column)
    vector = (column[0] / size, column[1] / size, column[2] / size, column[3] / size)
    value = values[order[0]]
    off = [sum(row[j] * vector[j] for j in range(4)) - value * vector[i] for i, row in enumerate(matrix)]
    return value, vector, value - values[order[1]], _length(off)


def _length(parts: "list[float]") -> float:
    if any(map(is_array, parts)):
        return over_array(math.hypot, *parts)  # type: ignore[no-any-return]
    return math.hypot(*parts)


def _rotate(a: "list[list[float]]", vectors: "list[list[float]]", p: int, q: int) -> None:
    """Turn rows and columns p and q until the element between them is zero."""
    if a[p][q] == 0.0:
        return
    ratio = (a[q][q] - a[p][p]) / (2.0 * a[p][q])
    t = where(ratio >= 0.0, 1.0, -1.0) / (abs(ratio) + hypot(1.0, ratio))
    c = 1.0 / hypot(1.0, t)
    s = t * c
    for row in a:
        row[p], row[q] = c * row[p] - s * row[q], s * row[p] + c * row[q]
    a[p], a[q] = (
        [c * x - s * y for x, y in zip(a[p], a[q], strict=True)],
        [s * x + c * y for x, y in zip(a[p], a[q], strict=True)],
    )
    a[p][q] = a[q][p] = 0.0
    for row in vectors:
        row[p], row[q] = c * row[p] - s * row[q], s * row[p] + c * row[q]
