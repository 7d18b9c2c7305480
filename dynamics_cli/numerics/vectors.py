"""Vectors of three or two components and symmetric tensors as tuples, for numbers, arrays and tracked numbers alike."""

from math import isfinite

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import hypot, multiply_add

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

Vector = tuple[float, float, float]
Pair = tuple[float, float]
Tensor = tuple[Vector, Vector, Vector]


def dot(a: Vector, b: Vector) -> float:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def planar_dot(a: Pair, b: Pair) -> float:
    """Scalar product in the plane, rounded as if in twice the precision."""
    return multiply_add(a[0], b[0], a[1] * b[1])


def planar_cross(a: Pair, b: Pair) -> float:
    """The component of a × b out of the plane."""
    return multiply_add(a[0], b[1], -(a[1] * b[0]))


def product_difference(a: float, b: float, c: float, d: float) -> float:
    """a·b − c·d, within a rounding or two of exact also where it cancels (Kahan)."""
    product = c * d
    rest = multiply_add(c, d, -product)
    return multiply_add(a, b, -product) - rest


def compensated_cross(a: Vector, b: Vector) -> Vector:
    """Vector product that keeps its digits where the vectors are nearly parallel."""
    return (
        product_difference(a[1], b[2], a[2], b[1]),
        product_difference(a[2], b[0], a[0], b[2]),
        product_difference(a[0], b[1], a[1], b[0]),
    )


def length(a: Vector) -> float:
    """Length of a vector, without overflow."""
    return hypot(hypot(a[0], a[1]), a[2])


def add(a: Vector, b: Vector) -> Vector:
    """Sum."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def scale(factor: float, a: Vector) -> Vector:
    """A number times a vector."""
    return factor * a[0], factor * a[1], factor * a[2]


def subtract(a: Vector, b: Vector) -> Vector:
    """Difference."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


class FrameTerms:
    """Velocity and acceleration of a point in a moving, turning frame, term by term; all vectors in one set of axes.

    v = v_O + ω×r + v_rel; a = a_O + α×r + ω×(ω×r) + 2ω×v_rel + a_rel.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 3.4, 4.6 and 4.10.
    """

    def __init__(
        self,
        position: Vector,
        turning: "tuple[Vector, Vector]",
        relative: "tuple[Vector, Vector]",
        origin: "tuple[Vector, Vector]",
    ) -> None:
        omega, alpha = turning
        self.spun = compensated_cross(omega, position)
        self.carried = add(origin[0], self.spun)
        self.velocity = add(self.carried, relative[0])
        self.angular = compensated_cross(alpha, position)
        self.centripetal = compensated_cross(omega, self.spun)
        self.coriolis = scale(2.0, compensated_cross(omega, relative[0]))
        acceleration = add(add(add(origin[1], self.angular), self.centripetal), self.coriolis)
        self.acceleration = add(acceleration, relative[1])


def times(tensor: Tensor, a: Vector) -> Vector:
    """A tensor applied to a vector."""
    return dot(tensor[0], a), dot(tensor[1], a), dot(tensor[2], a)


def moved(tensor: Tensor, mass: float, way: Vector) -> Tensor:
    """Inertia about a point that is `way` from the mass centre: I + m(r² − r rᵀ).

    References
    ----------
    Parallel axis theorem: Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 7.
    """
    square = dot(way, way)
    rows = []
    for i in range(3):
        row = [tensor[i][j] - mass * (way[i] * way[j]) for j in range(3)]
        row[i] = tensor[i][i] + mass * (square - way[i] * way[i])
        rows.append((row[0], row[1], row[2]))
    return rows[0], rows[1], rows[2]


def solve(tensor: Tensor, right: Vector, message: str) -> Vector:
    """Solve a symmetric positive definite system by LDLᵀ; refuse one without inertia about some direction.

    References
    ----------
    G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., Johns Hopkins 2013, chapter 4 (LDLᵀ).
    """
    a, b, c = tensor[0]
    d, e = tensor[1][1], tensor[1][2]
    trace = a + d + tensor[2][2]
    first = a
    require(first > 1e-14 * trace, message, code="no-inertia")
    l1, l2 = b / first, c / first
    second = d - l1 * b
    require(second > 1e-14 * trace, message, code="no-inertia")
    middle = e - l1 * c
    l3 = middle / second
    third = tensor[2][2] - l2 * c - l3 * middle
    require(third > 1e-14 * trace, message, code="no-inertia")
    y1 = right[1] - l1 * right[0]
    y2 = right[2] - l2 * right[0] - l3 * y1
    z = y2 / third
    y = y1 / second - l3 * z
    return right[0] / first - l1 * y - l2 * z, y, z


def eliminated(matrix: "Sequence[Sequence[float]]", right: "Sequence[float]") -> "list[float] | None":
    """The solution of a small linear system by elimination with pivots; None where it is singular."""
    rows = [[*row, end] for row, end in zip(matrix, right, strict=True)]
    size = len(rows)
    for column in range(size):
        best = max(range(column, size), key=lambda row: abs(rows[row][column]))
        if rows[best][column] == 0.0 or not all(map(isfinite, rows[best])):
            return None
        rows[column], rows[best] = rows[best], rows[column]
        for row in range(column + 1, size):
            factor = rows[row][column] / rows[column][column]
            rows[row] = [a - factor * b for a, b in zip(rows[row], rows[column], strict=True)]
    answer = [0.0] * size
    for row in reversed(range(size)):
        substituted = sum(rows[row][k] * answer[k] for k in range(row + 1, size))
        answer[row] = (rows[row][size] - substituted) / rows[row][row]
    return answer
