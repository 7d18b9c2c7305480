"""Eigenvalues and eigenvectors of a real symmetric 3 × 3 matrix of 60 digits, by Jacobi's rotations.

For bounds that a second pass in many digits measures; `symmetric.eigen` is the same in doubles.
"""

from decimal import Decimal

from dynamics_cli.numerics.exact.many_digits import DIGITS, ManyDigits

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import TypeAlias

    Triple: TypeAlias = tuple[ManyDigits, ManyDigits, ManyDigits]
    Rows: TypeAlias = tuple[Triple, Triple, Triple]

SWEEPS = 40
_PAIRS = ((0, 1, 2), (0, 2, 1), (1, 2, 0))
# An off-diagonal element this small is negligible: relative to its two diagonal elements, or to the largest one.
_FAINT, _NOTHING = Decimal(10) ** -(2 * DIGITS + 6), Decimal(10) ** -(2 * DIGITS)
_ZERO, _ONE = Decimal(0), Decimal(1)


def eigen_of_many_digits(matrix: "Sequence[Sequence[ManyDigits | float]]") -> "tuple[Triple, Rows]":
    """Eigenvalues, the greatest first, and their unit vectors as rows, to some 58 digits of the largest.

    `matrix`: the matrix; only its lower triangle is read, and its numbers must be finite. Returns eigenvalues and
    vectors.

    To be called within `many_digits.run`, whose context the arithmetic takes.

    References
    ----------
    J. Demmel, K. Veselić, Jacobi's method is more accurate than QR, SIAM J. Matrix Anal. Appl. 13 (1992) 1204.
    """
    a = [[_decimal(matrix[max(i, j)][min(i, j)]) for j in range(3)] for i in range(3)]
    axes = [[_ONE if i == j else _ZERO for j in range(3)] for i in range(3)]
    nothing = _NOTHING * max(abs(x) for row in a for x in row)
    for _ in range(SWEEPS):
        if not sum(_rotate(a, axes, *pair, nothing) for pair in _PAIRS):
            break
    order = sorted(range(3), key=lambda k: (-a[k][k], k))
    values = tuple(ManyDigits(a[k][k]) for k in order)
    return values, tuple(tuple(map(ManyDigits, axes[k])) for k in order)  # type: ignore[return-value]


def _decimal(number: "ManyDigits | float") -> Decimal:
    return number.exact if isinstance(number, ManyDigits) else Decimal(number)


def _rotate(a: "list[list[Decimal]]", axes: "list[list[Decimal]]", p: int, q: int, r: int, nothing: Decimal) -> bool:
    """Annihilate a[p][q] unless it is negligible."""
    off = a[p][q]
    if abs(off) <= nothing or off * off <= _FAINT * abs(a[p][p] * a[q][q]):
        a[p][q] = a[q][p] = _ZERO
        return False
    theta = (a[q][q] - a[p][p]) / (2 * off)
    t = (_ONE if theta >= 0 else -_ONE) / (abs(theta) + (1 + theta * theta).sqrt())
    c = 1 / (1 + t * t).sqrt()
    s = t * c
    a[p][p] -= t * off
    a[q][q] += t * off
    a[p][q] = a[q][p] = _ZERO
    x, y = a[r][p], a[r][q]
    a[r][p] = a[p][r] = c * x - s * y
    a[r][q] = a[q][r] = s * x + c * y
    for k in range(3):
        x, y = axes[p][k], axes[q][k]
        axes[p][k], axes[q][k] = c * x - s * y, s * x + c * y
    return True
