"""Singular values of small matrices by one-sided Jacobi rotations, in plain doubles: small ones keep their digits."""

from math import hypot, sqrt

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

SWEEPS = 30
# Rows this near to right angles are at right angles.
ACROSS = 1e-15


class Singular:
    """M = Σ σ·u·vᵀ of a matrix with no more rows than columns, or its transpose: from the largest σ down."""

    def __init__(self, matrix: "Sequence[Sequence[float]]") -> None:
        """Rotate rows in pairs until all are at right angles; their lengths are the singular values.

        References
        ----------
        M. R. Hestenes, Inversion of matrices by biorthogonalization, J. SIAM 6 (1958) 51.
        """
        wide = len(matrix) <= len(matrix[0])
        rows = [list(row) for row in (matrix if wide else zip(*matrix, strict=True))]
        size = len(rows)
        turns = [[float(i == j) for j in range(size)] for i in range(size)]
        for _ in range(SWEEPS):
            rotated = [_rotated(rows, turns, i, j) for i in range(size) for j in range(i + 1, size)]
            if not any(rotated):
                break
        lengths = [hypot(*row) for row in rows]
        order = sorted(range(size), key=lambda k: -lengths[k])
        self.values = [lengths[k] for k in order]
        outer = [turns[k] for k in order]
        inner = [[x / lengths[k] for x in rows[k]] if lengths[k] else [0.0] * len(rows[k]) for k in order]
        self.left: list[list[float]] = outer if wide else inner
        self.right: list[list[float]] = inner if wide else outer


def _rotated(rows: "list[list[float]]", turns: "list[list[float]]", i: int, j: int) -> bool:
    """Rotate two rows to right angles; whether that was necessary."""
    first = sum(x * x for x in rows[i])
    second = sum(x * x for x in rows[j])
    both = sum(x * y for x, y in zip(rows[i], rows[j], strict=True))
    if both == 0.0 or abs(both) <= ACROSS * sqrt(first) * sqrt(second):
        return False
    lean = (second - first) / (2.0 * both)
    tangent = (1.0 if lean >= 0.0 else -1.0) / (abs(lean) + hypot(1.0, lean))
    cosine = 1.0 / hypot(1.0, tangent)
    sine = cosine * tangent
    for pair in (rows, turns):
        a, b = pair[i], pair[j]
        pair[i] = [cosine * x - sine * y for x, y in zip(a, b, strict=True)]
        pair[j] = [sine * x + cosine * y for x, y in zip(a, b, strict=True)]
    return True
