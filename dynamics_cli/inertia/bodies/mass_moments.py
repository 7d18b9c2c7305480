"""Mass, mass centre and central second moments: the common form of every body, and the addition of bodies.

The state is the matrix of second moments S = ∫ (r − c)(r − c)ᵀ dm, not the inertia tensor I = tr(S)·1 − S: S of a body
is any matrix without a negative eigenvalue, so laminae, rods and needles need no special case and keep their digits.
"""

from dynamics_cli.numerics.number import is_array, is_tracked
from dynamics_cli.numerics.orientation.rotations import IDENTITY, product
from dynamics_cli.numerics.vectors import add, subtract
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import TypeAlias

    Vector: TypeAlias = tuple[float, float, float]
    Matrix: TypeAlias = tuple[Vector, Vector, Vector]


@record
class Lump:
    """A body by its mass [kg], mass centre [m] and second moments about it [kg·m²], in one frame."""

    mass: float
    centroid: "Vector"
    second: "Matrix"


NOTHING: "Matrix" = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))


def symmetric(xx: float, yy: float, zz: float, xy: float = 0.0, yz: float = 0.0, zx: float = 0.0) -> "Matrix":
    """The symmetric matrix of six elements."""
    return (xx, xy, zx), (xy, yy, yz), (zx, yz, zz)


def minus(x: float) -> float:
    """The negative of a number; that of zero is plain zero, with its derivatives negated."""
    opposite = -x
    if type(opposite) is float or is_array(opposite):
        return opposite + 0.0
    if opposite == 0.0 and is_tracked(opposite):
        opposite.value = 0.0  # type: ignore[attr-defined]
    return opposite


def tensor_of(second: "Matrix") -> "Matrix":
    """The inertia tensor tr(S)·1 − S, each moment the sum of two second moments."""
    (xx, xy, zx), (_, yy, yz), (_, _, zz) = second
    a, b, c = minus(xy), minus(yz), minus(zx)
    return (yy + zz, a, c), (a, zz + xx, b), (c, b, xx + yy)


def second_of(tensor: "Matrix") -> "Matrix":
    """The second moments of an inertia tensor: half the trace less each moment."""
    (xx, xy, zx), (_, yy, yz), (_, _, zz) = tensor
    a, b, c = minus(xy), minus(yz), minus(zx)
    return (
        (0.5 * ((yy - xx) + zz), a, c),
        (a, 0.5 * ((zz - yy) + xx), b),
        (c, b, 0.5 * ((xx - zz) + yy)),
    )


def each(change: "Callable[[float], float]", v: "tuple[float, ...]") -> "Vector":
    """A function of each of three numbers."""
    a, b, c = v
    return change(a), change(b), change(c)


def turned(second: "Matrix", rotation: "Matrix") -> "Matrix":
    """R S Rᵀ: second moments in axes from which the body's are rotated by `rotation`, exactly symmetric."""
    if rotation is IDENTITY:
        return second
    half = product(rotation, second)
    cell = [
        [half[i][0] * rotation[j][0] + half[i][1] * rotation[j][1] + half[i][2] * rotation[j][2] for j in range(i + 1)]
        for i in range(3)
    ]
    return symmetric(cell[0][0], cell[1][1], cell[2][2], cell[1][0], cell[2][1], cell[2][0])


def outer(scale: float, d: "Vector") -> "Matrix":
    """`scale`·d dᵀ: the second moments of a point mass at d."""
    x, y, z = scale * d[0], scale * d[1], scale * d[2]
    return symmetric(x * d[0], y * d[1], z * d[2], x * d[1], y * d[2], x * d[2])


def added(a: "Matrix", b: "Matrix") -> "Matrix":
    """The sum of two matrices."""
    return tuple(add(x, y) for x, y in zip(a, b, strict=True))  # type: ignore[return-value]


def scaled(scale: float, a: "Matrix") -> "Matrix":
    """A matrix times a number."""
    return tuple((scale * x, scale * y, scale * z) for x, y, z in a)  # type: ignore[return-value]


def about(body: Lump, point: "Vector") -> "Matrix":
    """Second moments about another point: S + m d dᵀ."""
    d = subtract(body.centroid, point)
    return added(body.second, outer(body.mass, d))
