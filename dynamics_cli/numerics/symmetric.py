"""Eigenvalues and eigenvectors of a real symmetric 3 × 3 matrix by Jacobi's rotations.

Jacobi keeps the small eigenvalues of a graded positive matrix to full relative accuracy, where reduction to
tridiagonal form keeps them to a rounding of the largest one only, and the trigonometric formula not even that.
"""

from math import frexp, ldexp, sqrt

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Triple: TypeAlias = tuple[float, float, float]
    Rows: TypeAlias = tuple[Triple, Triple, Triple]

UNIT_ROUNDOFF = 2.0**-53
# Roundings that each rotation may add, in units of the norm, or of each eigenvalue times the scaled condition.
ROUNDINGS = 1.5
SWEEPS = 40
_PAIRS = ((0, 1, 2), (0, 2, 1), (1, 2, 0))


class Eigen:
    """Eigenvalues, the greatest first, their unit vectors as rows in that order, and a bound of each one's error."""

    __slots__ = ("bounds", "values", "vectors")

    def __init__(self, values: "Triple", vectors: "Rows", bounds: "Triple") -> None:
        self.values = values
        self.vectors = vectors
        self.bounds = bounds


def eigen(matrix: "Rows") -> Eigen:
    """Eigenvalues and eigenvectors of a symmetric 3 × 3 matrix, as its doubles stand.

    Equation
    --------
    A ← Jᵀ A J with t = tan φ the smaller root of t² + 2 ϑ t − 1 = 0, ϑ = (a_qq − a_pp)/(2 a_pq).

    Parameters
    ----------
    matrix : tuple of rows
        The matrix; only its lower triangle is read, and its numbers must be finite.

    Returns
    -------
    Eigen
        Eigenvalues (the greatest first), unit eigenvectors as rows, and absolute error bounds.

    Raises
    ------
    OverflowError
        When a number of the matrix is not finite.

    Notes
    -----
    The bound is the smaller of c u ‖A‖ and, for a positive matrix, c u κ λ with κ the condition of A scaled to a unit
    diagonal (Demmel and Veselić, Jacobi's method is more accurate than QR, SIAM J. Matrix Anal. Appl. 13 (1992)
    1204, theorem 2.4), c = 3/2 for each rotation and u = 2⁻⁵³. It is of the eigenvalues of the doubles given,
    not of the data behind them. Eigenvectors are good to about u ‖A‖ over the gap to the next eigenvalue.

    Examples
    --------
    >>> eigen(((2.0, 1.0, 0.0), (1.0, 2.0, 0.0), (0.0, 0.0, 5.0))).values
    (5.0, 3.0, 1.0)
    """
    largest = max(abs(matrix[i][j]) for i in range(3) for j in range(i + 1))
    if not largest < float("inf") or any(x != x for row in matrix for x in row):
        raise OverflowError("a number of the matrix is not finite")
    axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    exponent = -frexp(largest)[1]
    a = [[ldexp(matrix[max(i, j)][min(i, j)], exponent) for j in range(3)] for i in range(3)]
    diagonal = a[1][0] == a[2][0] == a[2][1] == 0.0
    condition = 0.0 if diagonal else _condition(a)
    norm = sqrt(sum(x * x for row in a for x in row))
    roundings = 0.0
    for _ in range(SWEEPS):
        turned = sum(_rotate(a, axes, *pair) for pair in _PAIRS)
        if not turned:
            break
        roundings += ROUNDINGS * turned
    order = sorted(range(3), key=lambda k: (-a[k][k], k))
    values = tuple(ldexp(a[k][k], -exponent) for k in order)
    bounds = tuple(
        0.0 if diagonal else ldexp(roundings * UNIT_ROUNDOFF * min(norm, condition * abs(a[k][k])), -exponent)
        for k in order
    )
    return Eigen(values, tuple(_normal(axes[k]) for k in order), bounds)  # type: ignore[arg-type]


def _rotate(a: "list[list[float]]", axes: "list[list[float]]", p: int, q: int, r: int) -> bool:
    """Annihilate a[p][q] unless it is below a rounding of the geometric mean of its diagonal elements."""
    off = a[p][q]
    if off == 0.0:
        return False
    if abs(off) <= 0.25 * UNIT_ROUNDOFF * sqrt(abs(a[p][p])) * sqrt(abs(a[q][q])):
        a[p][q] = a[q][p] = 0.0
        return False
    theta = (a[q][q] - a[p][p]) / (2.0 * off)
    t = (
        (1.0 if theta >= 0.0 else -1.0) / (abs(theta) + sqrt(1.0 + theta * theta))
        if abs(theta) < 1e150
        else 0.5 / theta
    )
    c = 1.0 / sqrt(1.0 + t * t)
    s = c * t
    tau = s / (1.0 + c)
    a[p][p] -= t * off
    a[q][q] += t * off
    a[p][q] = a[q][p] = 0.0
    x, y = a[r][p], a[r][q]
    a[r][p] = a[p][r] = x - s * (y + tau * x)
    a[r][q] = a[q][r] = y + s * (x - tau * y)
    for k in range(3):
        x, y = axes[p][k], axes[q][k]
        axes[p][k] = x - s * (y + tau * x)
        axes[q][k] = y + s * (x - tau * y)
    return True


def _condition(a: "list[list[float]]") -> float:
    """The condition of a positive matrix scaled to a unit diagonal, infinite when it cannot be shown positive.

    With a unit diagonal the eigenvalues add up to 3, so the least is at least det/(3/2)².
    """
    if not min(a[0][0], a[1][1], a[2][2]) > 0.0:
        return float("inf")
    d = [sqrt(a[k][k]) for k in range(3)]
    if min(d) < 1e-140:
        return float("inf")
    x, y, z = (a[i][j] / (d[i] * d[j]) for i, j in ((0, 1), (1, 2), (2, 0)))
    determinant = 1.0 + 2.0 * x * y * z - (x * x + y * y + z * z) - 32.0 * UNIT_ROUNDOFF
    if not determinant > 0.0:
        return float("inf")
    least = max(determinant / 2.25, 1.0 - max(abs(x) + abs(y), abs(y) + abs(z), abs(z) + abs(x)))
    return 1.0 / least


def _normal(vector: "list[float]") -> "Triple":
    """The vector at unit length, an axis left as it is."""
    x, y, z = (part + 0.0 for part in vector)
    square = x * x + y * y + z * z
    scale = 1.0 if square == 1.0 else 1.0 / sqrt(square)
    return x * scale, y * scale, z * scale
