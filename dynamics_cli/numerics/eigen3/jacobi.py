"""Eigenvalues and eigenvectors of a real symmetric 3 × 3 matrix by Jacobi's rotations.

Jacobi keeps the small eigenvalues of a graded positive matrix to full relative accuracy, where reduction to
tridiagonal form keeps them to a rounding of the largest one only, and the trigonometric formula not even that.
"""

from dynamics_cli.numerics.elementary import binary_exponent, maximum, sqrt, times_power_of_two, where
from dynamics_cli.numerics.number import is_array

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.eigen3.residual import Rows, Triple

UNIT_ROUNDOFF = 2.0**-53
SWEEPS = 40
_PAIRS = ((0, 1, 2), (0, 2, 1), (1, 2, 0))


class Eigen:
    """Eigenvalues in decreasing order, their unit vectors as rows, and a bound of each one's error."""

    __slots__ = ("_bounds", "_matrix", "values", "vectors")

    def __init__(self, values: "Triple", vectors: "Rows", matrix: "Rows | None") -> None:
        self.values = values
        self.vectors = vectors
        # None for a diagonal matrix, which needs no rotation
        self._matrix = matrix
        self._bounds: Triple | None = None if matrix is not None else (0.0, 0.0, 0.0)

    @property
    def bounds(self) -> "Triple":
        """Error bounds of the eigenvalues of the given matrix, proved afterwards."""
        if self._bounds is None:
            assert self._matrix is not None
            from dynamics_cli.numerics.eigen3.residual import residual_bounds

            self._bounds = residual_bounds(self._matrix, self.values, self.vectors)
        return self._bounds

    def refined(self) -> "Eigen":
        """The same with every eigenvalue accurate to its last bits, even if far smaller than the others."""
        if self._matrix is None:
            return self
        from dynamics_cli.numerics.eigen3.residual import quotients

        refined_values = quotients(self._matrix, self.vectors)
        order = sorted(range(3), key=lambda k: (-refined_values[k], k))
        values, vectors = (tuple(part[k] for k in order) for part in (refined_values, self.vectors))
        return Eigen(values, vectors, self._matrix)  # type: ignore[arg-type]


def eigen(matrix: "Rows") -> Eigen:
    """Eigenvalues and eigenvectors of a symmetric 3 × 3 matrix, as its doubles stand.

    `matrix`: the matrix; only its lower triangle is read, and its numbers must be finite. Returns eigenvalues (the
    greatest first), unit eigenvectors as rows, and absolute error bounds. Raises OverflowError when a number of the
    matrix is not finite.

    Errors are some u ‖A‖ at most and, for a positive matrix, some u κ λ with κ the condition of A scaled to a unit
    diagonal and u = 2⁻⁵³ (Demmel and Veselić, Jacobi's method is more accurate than QR, SIAM J. Matrix Anal. Appl. 13
    (1992) 1204). Bounds are not these but `residual_bounds`. They are of the eigenvalues of the doubles given, not of
    the data behind them. Eigenvectors are good to about u ‖A‖ over the gap to the next eigenvalue.

    Equation
    --------
    A ← Jᵀ A J with t = tan φ the smaller root of t² + 2 ϑ t − 1 = 0, ϑ = (a_qq − a_pp)/(2 a_pq).

    References
    ----------
    J. Demmel, K. Veselić, Jacobi's method is more accurate than QR, SIAM J. Matrix Anal. Appl. 13 (1992) 1204.

    Examples
    --------
    >>> eigen(((2.0, 1.0, 0.0), (1.0, 2.0, 0.0), (0.0, 0.0, 5.0))).values
    (5.0, 3.0, 1.0)
    """
    largest = 0.0
    for i in range(3):
        for j in range(i + 1):
            largest = maximum(largest, abs(matrix[i][j]))
    if not largest < float("inf") or any(x != x for row in matrix for x in row):
        raise OverflowError("a number of the matrix is not finite")
    axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    exponent = -binary_exponent(largest)
    a = [[times_power_of_two(matrix[max(i, j)][min(i, j)], exponent) for j in range(3)] for i in range(3)]
    diagonal = a[1][0] == a[2][0] == a[2][1] == 0.0
    for _ in range(SWEEPS):
        if not sum(_rotate(a, axes, *pair) for pair in _PAIRS):
            break
    order = sorted(range(3), key=lambda k: (-a[k][k], k))
    values = tuple(times_power_of_two(a[k][k], -exponent) for k in order)
    symmetric = None if diagonal else tuple(tuple(matrix[max(i, j)][min(i, j)] for j in range(3)) for i in range(3))
    return Eigen(values, tuple(_normal(axes[k]) for k in order), symmetric)  # type: ignore[arg-type]


def _rotate(a: "list[list[float]]", axes: "list[list[float]]", p: int, q: int, r: int) -> bool:
    """Annihilate a[p][q] unless it is below a rounding of the geometric mean of its diagonal elements."""
    off = a[p][q]
    if is_array(off):
        from dynamics_cli.numerics.eigen3.jacobi_lanes import rotate

        return rotate(a, axes, p, q, r)
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


def _normal(vector: "list[float]") -> "Triple":
    """The vector at unit length; a coordinate axis is unchanged."""
    x, y, z = (part + 0.0 for part in vector)
    square = x * x + y * y + z * z
    scale = where(square == 1.0, 1.0, 1.0 / sqrt(square))
    return x * scale, y * scale, z * scale
