"""Principal moments and axes of an inertia tensor, and an angular velocity along them."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.eigen3.jacobi import eigen
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.vectors import cross, dot, times
from dynamics_cli.quantities import Inertia

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.vectors import Tensor, Vector

# Moments that differ by less, beside the largest, are equal.
EQUAL = 1e-13


def along_axes(tensor: "Tensor", angular_velocity: "Vector") -> "tuple[Vector, Vector, Tensor]":
    """Moments from the least to the greatest, the angular velocity along their axes, and these axes, right-handed.

    Quotients of the tensor along its axes, with the turn of the axes to first order: numbers that carry derivatives
    carry those of both.
    """
    doubles: Tensor = tuple(tuple(plain(x) for x in row) for row in tensor)  # type: ignore[assignment]
    solved = eigen(doubles)
    least = solved.values[2]
    require(least > 0.0, "a principal moment of {least} is not above zero", least=(least, Inertia),
            code="impossible-body", hint="check the tensor with dynamics inertia tensor")  # fmt: skip
    axes = _right_handed(solved.vectors[2], solved.vectors[1])
    across = [[dot(one, times(tensor, other)) for other in axes] for one in axes]
    rates = times(axes, angular_velocity)
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


def _right_handed(first: "Vector", second: "Vector") -> "Tensor":
    """Both axes with their largest component positive, and the third across them."""
    a, b = (tuple(x * (1.0 if max(axis, key=abs) > 0.0 else -1.0) + 0.0 for x in axis) for axis in (first, second))
    return a, b, cross(a, b)  # type: ignore[arg-type, return-value]
