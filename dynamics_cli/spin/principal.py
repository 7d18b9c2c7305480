"""Principal moments and axes of an inertia tensor, and an angular velocity along them."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.eigen3.jacobi import eigen
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Inertia

TYPE_CHECKING = False
if TYPE_CHECKING:
    Triple = tuple[float, float, float]
    Rows = tuple[Triple, Triple, Triple]

# Moments that differ by less, beside the largest, are equal.
EQUAL = 1e-13


def along_axes(tensor: "Rows", angular_velocity: "Triple") -> "tuple[Triple, Triple, Rows]":
    """Moments from the least to the greatest, the angular velocity along their axes, and these axes, right-handed.

    Quotients of the tensor along its axes, with the turn of the axes to first order: numbers that carry derivatives
    carry those of both.
    """
    doubles: Rows = tuple(tuple(plain(x) for x in row) for row in tensor)  # type: ignore[assignment]
    solved = eigen(doubles)
    least = solved.values[2]
    require(least > 0.0, "a principal moment of {least} is not above zero", least=(least, Inertia),
            code="impossible-body", hint="check the tensor with dynamics inertia tensor")  # fmt: skip
    axes = _right_handed(solved.vectors[2], solved.vectors[1])
    across = [[_dot(one, tuple(_dot(row, other) for row in tensor)) for other in axes] for one in axes]
    rates = [_dot(axis, angular_velocity) for axis in axes]
    values, largest = solved.values[::-1], solved.values[0]
    moments, turned = [], []
    for k in range(3):
        alike = [j for j in range(3) if abs(values[j] - values[k]) <= EQUAL * largest]
        moments.append(across[alike[0]][alike[0]])
        rate = rates[k]
        for j in range(3):
            if j not in alike:
                rate = rate + across[j][k] / (values[k] - values[j]) * rates[j]
        turned.append(rate)
    return tuple(moments), tuple(turned), axes  # type: ignore[return-value]


def _dot(one: "tuple[float, ...]", other: "tuple[float, ...]") -> float:
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2]


def _right_handed(first: "Triple", second: "Triple") -> "Rows":
    """Both axes with their largest component positive, and the third across them."""
    a, b = (tuple(x * (1.0 if max(axis, key=abs) > 0.0 else -1.0) + 0.0 for x in axis) for axis in (first, second))
    third = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    return a, b, third  # type: ignore[return-value]
