"""Test whether a tensor can be the inertia of a body."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import where

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Triple: TypeAlias = tuple[float, float, float]
    Matrix: TypeAlias = tuple[Triple, Triple, Triple]

# Written tensors are rounded: violations below this part of the trace are tolerated.
OVERLOOKED = 10**9


def possible(inertia: "Matrix") -> bool:
    """Whether no principal moment exceeds the sum of the other two; of the upper triangle.

    Equivalently: the second moments of the mass, ½ tr(I)·1 − I, are negative in no direction. Pivots of
    elimination show this, without eigenvalues, of floats, arrays and decimals alike.

    References
    ----------
    P. M. Wensing, S. Kim, J.-J. E. Slotine, Linear matrix inequalities for physically consistent inertial
    parameter identification, IEEE Robot. Autom. Lett. 3 (2018) 60.
    """
    (a, d, e), (_, b, f), (_, _, c) = inertia
    tolerance = (a + b + c) / OVERLOOKED
    half = (a + b + c) / 2 + tolerance
    first = half - a
    divisor = where(first > 0, first, half - half + 1)
    second = half - b - d * d / divisor
    two = where(second > 0, second, half - half + 1)
    across = -f - d * e / divisor
    third = half - c - e * e / divisor - across * across / two
    return (tolerance > 0) & (first > 0) & (second > 0) & (third > 0)


def require_inertia_of_body(inertia: "Matrix", name: str) -> None:
    """Refuse a tensor that no body can have; `name` says whose it is."""
    (a, _, _), (_, b, _), (_, _, c) = inertia
    require(a + b + c > 0, name + " has no inertia", code="no-inertia")
    require(
        possible(inertia),
        name + " has a tensor that belongs to no body: one principal moment exceeds the sum of the other two",
        code="no-body",
        hint="check the moments, and the signs and the axes of the products",
    )
