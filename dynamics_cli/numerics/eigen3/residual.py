"""A posteriori bounds of eigenvalues, from the off-diagonal part of the matrix in the basis of its vectors.

Doubles are integer multiples of a power of two, so that the matrix in that basis is formed without rounding.
"""

from math import asin, frexp, hypot, inf, ldexp, sqrt

from dynamics_cli.numerics.number import is_array

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import TypeAlias

    Triple: TypeAlias = tuple[float, float, float]
    Rows: TypeAlias = tuple[Triple, Triple, Triple]

UNIT_ROUNDOFF = 2.0**-53
# Covers the rounding of the bound's own arithmetic, and that the vectors are unit ones to rounding only.
_SLACK = 1.0 + 2.0**-30
# Roundings of the difference of two quotients.
_CLOSE = 4.0 * UNIT_ROUNDOFF
# Error of a bound by gradual underflow.
_TINY = 5e-324
_OTHERS = ((1, 2), (0, 2), (0, 1))


def residual_bounds(matrix: "Rows", values: "Triple", vectors: "Rows", errors: "Rows | None" = None) -> "Triple":
    """Error bounds of given eigenvalues of a symmetric 3 × 3 matrix.

    `matrix`: the symmetric matrix A, of finite numbers; `values`: its computed eigenvalues, in order of size;
    `vectors`: its computed eigenvectors V as rows, orthonormal to some roundings; `errors`: error
    bound of each element of the matrix, zero when not given. Returns a bound for each, in the order of the values.

    The three terms are the distance of Rayleigh's quotient from the value; its distance from an eigenvalue, quadratic
    over the gap η to the others (Li and Li, A note on eigenvalues of perturbed Hermitian matrices, Linear Algebra Appl.
    395 (2005) 183), or the norm of the off-diagonal part where there is no gap (Weyl); and the relative change of every
    eigenvalue by vectors that are not quite orthogonal (Ostrowski). The first is exact, and the others are of second
    order or a rounding of the value. Errors E of the matrix add |V| E |V|ᵀ to T.

    Equation
    --------
    G = V Vᵀ, T = V A Vᵀ, tᵢⱼ over √(gᵢᵢ gⱼⱼ); |λ − λₖ| ≤ |tₖₖ − λₖ| + Σ tₖⱼ²/η + f |λ|, f = ‖G − 1‖.

    References
    ----------
    C.-K. Li, R.-C. Li, A note on eigenvalues of perturbed Hermitian matrices, Linear Algebra Appl. 395 (2005)
    183; Weyl's and Ostrowski's theorems: R. A. Horn, C. R. Johnson, Matrix Analysis, Cambridge, chapter 4.

    Examples
    --------
    >>> v = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    >>> [round(bound) for bound in residual_bounds(((9.0, 0.0, 0.0), (0.0, 5.0, 0.0), (0.0, 0.0, 1.0)), (9, 5, 2), v)]
    [0, 0, 1]
    """
    if errors is not None and not all(error < inf for row in errors for error in row):
        return inf, inf, inf
    terms = _Seen(matrix, values, vectors, errors)
    bounds = []
    for k, spread in enumerate(_spreads(terms.quotients, terms.beside, terms.blur)):
        magnitude = abs(terms.quotients[k]) + terms.blur[k] + spread
        bounds.append((terms.away[k] + terms.blur[k] + spread + terms.skew * magnitude) * _SLACK)
    return _back(_paired(values, bounds, terms.size), terms.size)


def tilt_bounds(matrix: "Rows", vectors: "Rows", errors: "Rows | None" = None) -> "Triple":
    """Bounds of the angles between given vectors and the eigenvectors of a symmetric 3 × 3 matrix.

    `matrix`: the symmetric matrix A, of finite numbers; `vectors`: its eigenvectors V as they were found, as rows:
    orthonormal to some roundings; `errors`: error bound of each element of the matrix, zero when not given.
    Returns an angle for each vector [rad]; infinite where its eigenvalue cannot be separated from another.

    The residual over the gap: Davis and Kahan, The rotation of eigenvectors by a perturbation III, SIAM J. Numer. Anal.
    7 (1970) 1. The vectors' departure from orthonormality is added.

    Equation
    --------
    T and G as of `residual_bounds`; sin θₖ ≤ √(Σ (tₖⱼ − tₖₖ gₖⱼ)²)/minⱼ |tₖₖ − λⱼ|, j other than k.

    References
    ----------
    C. Davis, W. M. Kahan, The rotation of eigenvectors by a perturbation III, SIAM J. Numer. Anal. 7 (1970) 1.

    Examples
    --------
    >>> v = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    >>> tilt_bounds(((1.0, 1e-9, 0.0), (1e-9, 2.0, 0.0), (0.0, 0.0, 3.0)), v)[0] < 1.1e-9
    True
    """
    if errors is not None and not all(error < inf for row in errors for error in row):
        return inf, inf, inf
    terms = _Seen(matrix, (0.0, 0.0, 0.0), vectors, errors)
    spreads = _spreads(terms.quotients, terms.beside, terms.blur)
    bounds = []
    for k, pair in enumerate(_OTHERS):
        gap = min(
            abs(terms.quotients[k] - terms.quotients[j]) * (1.0 - _CLOSE) - terms.blur[k] - terms.blur[j] - spreads[j]
            for j in pair
        )
        off = hypot(*(terms.residual(k, j) for j in pair))
        separated = off < gap
        bounds.append((asin(off / gap) + 2.0 * terms.skew + terms.long[k]) * _SLACK if separated else inf)
    return bounds[0], bounds[1], bounds[2]


class _Seen:
    """A matrix along vectors, its numbers as shares of 2^size, within the range of doubles.

    Rayleigh's quotients, the distance of given values from them, the off-diagonal part without row and column k, the
    error of the diagonal, and the deviations of the vectors from orthogonality and unit length.
    """

    def __init__(self, matrix: "Rows", values: "Triple", vectors: "Rows", errors: "Rows | None") -> None:
        self.size = size = frexp(max(abs(x) for row in matrix for x in row))[1]
        rows, unit = whole((*matrix, values))
        lines, one = whole(vectors)
        cells, products = along(rows[:3], lines), grams(lines)
        self.long = [abs(products[k][k] - one * one) / (one * one) for k in range(3)]
        scale = unit << size if size > 0 else unit
        more = 1 << -size if size < 0 else 1
        squares = [products[k][k] * scale for k in range(3)]
        self.quotients = [more * cells[k][k] / squares[k] for k in range(3)]
        self.away = [more * abs(cells[k][k] - rows[3][k] * products[k][k]) / squares[k] for k in range(3)]
        self.beside = [more * abs(cells[i][j]) / min(squares) for i, j in _OTHERS]
        skews = [sum(abs(products[k][j]) for j in range(3) if j != k) / products[k][k] for k in range(3)]
        self.skew = max(skews) * _SLACK
        self.blur, self._others = [0.0] * 3, [0.0] * 3
        if errors is not None:
            self.blur, self._others = _blurred(errors, vectors, size)
            self.beside = [one + other for one, other in zip(self.beside, self._others, strict=True)]
        self._exact = cells, products, scale, more

    def residual(self, k: int, j: int) -> float:
        """Component along vⱼ, which may not be exactly orthogonal to vₖ, of A vₖ less its quotient times vₖ."""
        cells, products, scale, more = self._exact
        norm = products[k][k]
        residue = (
            more * abs(cells[k][j] * norm - cells[k][k] * products[k][j]) / (norm * min(norm, products[j][j]) * scale)
        )
        return residue + self._others[3 - k - j]


def _blurred(errors: "Rows", vectors: "Rows", size: int) -> "tuple[list[float], list[float]]":
    """|V| E |V|ᵀ as shares of 2^size: on the diagonal, and off row and column k."""
    e = [[ldexp(x, -size) for x in row] for row in errors]
    v = [[abs(x) for x in row] for row in vectors]
    half = [[sum(x * y for x, y in zip(line, row, strict=True) if x) for row in e] for line in v]
    full = [[sum(x * y for x, y in zip(line, part, strict=True) if x) for line in v] for part in half]
    return [full[k][k] for k in range(3)], [full[i][j] for i, j in _OTHERS]


def quotients(matrix: "Rows", vectors: "Rows") -> "Triple":
    """Rayleigh's quotients vᵀ A v/vᵀ v of a symmetric 3 × 3 matrix, each rounded once.

    `matrix`: the symmetric matrix A, of finite numbers; `vectors`: vectors v. Returns a quotient for each vector: its
    eigenvalue, with an error of second order in that of the vector.

    References
    ----------
    B. N. Parlett, The Symmetric Eigenvalue Problem, SIAM 1998 (Rayleigh's quotient).

    Examples
    --------
    >>> quotients(((2.0, 1.0, 0.0), (1.0, 2.0, 0.0), (0.0, 0.0, 5.0)), ((1, 1, 0), (1, -1, 0), (0, 0, 1)))
    (3.0, 1.0, 5.0)
    """
    if any(is_array(x) for row in matrix for x in row):
        from dynamics_cli.numerics.eigen3.quotients_lanes import quotients as of_lanes

        return of_lanes(matrix, vectors, quotients)
    rows, unit = whole(matrix)
    lines, _ = whole(vectors)
    a, b, c = (_dot(line, [_dot(row, line) for row in rows]) / (_dot(line, line) * unit) for line in lines)
    return a, b, c


def whole(rows: "Sequence[Sequence[float]]") -> "tuple[list[list[int]], int]":
    """Finite numbers as whole multiples of one over a common power of two, and that power.

    `rows`: the numbers. Returns the multiples, in rows, and the power of two.

    Examples
    --------
    >>> whole(((0.5, 3.0), (0.25, 0.0)))
    ([[2, 12], [1, 0]], 4)
    """
    ratios = [[number.as_integer_ratio() for number in row] for row in rows]
    unit = max(down for row in ratios for _, down in row)
    return [[up * (unit // down) for up, down in row] for row in ratios], unit


def along(matrix: "Sequence[Sequence[int]]", lines: "Sequence[Sequence[int]]") -> "list[list[int]]":
    """V A Vᵀ: a matrix along vectors, which are rows."""
    half = [[_dot(row, line) for row in matrix] for line in lines]
    return [[_dot(part, line) for line in lines] for part in half]


def grams(lines: "Sequence[Sequence[int]]") -> "list[list[int]]":
    """V Vᵀ: the Gram matrix of the vectors."""
    return [[_dot(row, line) for line in lines] for row in lines]


def _dot(a: "Sequence[int]", b: "Sequence[int]") -> int:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _spreads(diagonal: "list[float]", beside: "list[float]", blur: "list[float]") -> "list[float]":
    """Distances of eigenvalues from the diagonal, known within `blur`; `beside[k]` leaves out row and column k."""
    spreads = [sqrt(2.0 * (beside[0] * beside[0] + beside[1] * beside[1] + beside[2] * beside[2]))] * 3
    apart = [
        abs(diagonal[i] - diagonal[j]) - blur[i] - blur[j] - _CLOSE * (abs(diagonal[i]) + abs(diagonal[j]))
        for i, j in _OTHERS
    ]
    for index, (i, j) in enumerate(_OTHERS):
        gap = min(apart[i], apart[j]) - beside[index]
        if gap > 0.0:
            # its own diagonal element, and the other two as a matrix
            square = (beside[i] * beside[i] + beside[j] * beside[j]) / gap
            within = beside[index] * min(1.0, beside[index] / apart[index] if apart[index] > 0.0 else 1.0)
            spreads[index] = min(spreads[index], square)
            spreads[i], spreads[j] = min(spreads[i], square + within), min(spreads[j], square + within)
    return spreads


def _paired(values: "Triple", bounds: "list[float]", size: int) -> "list[float]":
    """Bounds of values that may be interchanged: the larger of the two."""
    for _ in range(2):
        for k in range(2):
            if not abs(ldexp(values[k] - values[k + 1], -size)) > (bounds[k] + bounds[k + 1]) * _SLACK:
                bounds[k] = bounds[k + 1] = max(bounds[k], bounds[k + 1])
    return bounds


def _back(bounds: "list[float]", size: int) -> "Triple":
    a, b, c = (ldexp(bound, size) for bound in bounds)
    return a + _TINY, b + _TINY, c + _TINY
