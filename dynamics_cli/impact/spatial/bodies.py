"""Rigid bodies in space at a contact: vectors, tensors, and the velocity change per impulse.

Everything works in doubles and in decimals.
"""

from dynamics_cli.errors import require
from dynamics_cli.impact.inertia_tensor import require_inertia_of_body
from dynamics_cli.impact.planar.bodies import Pair
from dynamics_cli.impact.spatial.arithmetic import fused, length, root, total
from dynamics_cli.numerics.vectors import add, cross, dot, times
from dynamics_cli.records import record

Vector = tuple[float, float, float]
Matrix = tuple[Vector, Vector, Vector]
ZERO = 0.0, 0.0, 0.0
TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable


@record
class SolidInSpace:
    """A body at the contact; `mass` is None when it is fixed, `inertia` and its inverse when it is a particle."""

    mass: float | None
    inertia: Matrix | None
    inverse: Matrix | None
    lever: Vector
    velocity: Vector
    spin: Vector
    nose: Pair

    def contact_velocity(self) -> Vector:
        """Velocity of the body's point at the contact."""
        return add(self.velocity, cross(self.spin, self.lever))

    def answer(self, impulse: Vector) -> Vector:
        """Change of velocity at the contact from an impulse there."""
        if self.mass is None:
            return nothing(impulse[0])
        moved = impulse[0] / self.mass, impulse[1] / self.mass, impulse[2] / self.mass
        return add(cross(self.turned(cross(self.lever, impulse)), self.lever), moved)

    def turned(self, moment: Vector) -> Vector:
        """Change of spin from an impulsive moment.

        The residual of the first solution is summed exactly and solved for too (iterative refinement): a slender
        body's spin is then accurate to its last digits although its inverse tensor is not.
        """
        if self.inertia is None or self.inverse is None:
            return nothing(moment[0])
        change = times(self.inverse, moment)
        if hasattr(change[0], "sqrt"):
            # decimals have digits to spare
            return change
        remainders = tuple(-residual(row, change, part) for row, part in zip(self.inertia, moment, strict=True))
        return add(change, times(self.inverse, remainders))  # type: ignore[arg-type]


def residual(row: Vector, vector: Vector, target: float) -> float:
    """row·vector − given, rounded once."""
    return total([*exact_products(zip(row, vector, strict=True)), -target])


def exact_products(pairs: "Iterable[tuple[float, float]]") -> list[float]:
    """Products and their rounding errors: together they sum to the exact products."""
    products = []
    for a, b in pairs:
        product = a * b
        products += [product, fused(a, b, -product)]
    return products


def relative_velocity(first: SolidInSpace, second: SolidInSpace) -> Vector:
    """Velocity of body 1 relative to body 2 at the contact, each component rounded once: all may be a last bit."""
    parts = []
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        turning = [
            (first.spin[j], first.lever[k]),
            (-first.spin[k], first.lever[j]),
            (-second.spin[j], second.lever[k]),
            (second.spin[k], second.lever[j]),
        ]
        parts.append(total([first.velocity[i], -second.velocity[i], *exact_products(turning)]))
    return parts[0], parts[1], parts[2]


def nose_in_plane(nose: Vector | None, velocity: Vector) -> Pair:
    """Unit vector of the nose in the plane x, y: given, else that of travel, else x."""
    for x, y in [] if nose is None else [nose[:2]]:
        size = length(x, y)
        require(size > 0, "the nose points along z: it has no direction in the plane", code="no-nose")
        return x / size, y / size
    size = length(velocity[0], velocity[1])
    return (velocity[0] / size, velocity[1] / size) if size > 0 else (type(size)(1), type(size)(0))


def nothing(like: float) -> Vector:
    """The zero vector in the same sort of numbers."""
    zero = type(like)(0)
    return zero, zero, zero


def combine(frame: Matrix, parts: Vector) -> Vector:
    """Sum of the frame's vectors times `parts`."""
    return tuple(sum(part * axis[i] for part, axis in zip(parts, frame, strict=True)) for i in range(3))  # type: ignore[return-value]


def determinant(matrix: Matrix) -> float:
    """Determinant, by the triple product."""
    return dot(matrix[0], cross(matrix[1], matrix[2]))


def inverse(matrix: Matrix) -> Matrix:
    """Inverse of a symmetric matrix, by cofactors."""
    det = determinant(matrix)
    rows = cross(matrix[1], matrix[2]), cross(matrix[2], matrix[0]), cross(matrix[0], matrix[1])
    return tuple(tuple(entry / det for entry in row) for row in rows)  # type: ignore[return-value]


def frame_about(normal: Vector, along: Vector = ZERO) -> Matrix:
    """Two tangents and the normal, right-handed; the first tangent as near `along` as it may be, else any."""
    number = type(normal[0])
    tangent = cross(cross(normal, along), normal) if any(along) else along
    size = root(dot(tangent, tangent)) if any(along) else 0
    if not size > 0:
        index = min(range(3), key=lambda i: abs(normal[i]))
        tangent = cross(normal, (number(index == 0), number(index == 1), number(index == 2)))
        size = root(dot(tangent, tangent))
    first = tangent[0] / size, tangent[1] / size, tangent[2] / size
    return first, cross(normal, first), normal


def unit(vector: Vector) -> Vector:
    """The contact normal at length one; refuses the zero vector."""
    largest = max(map(abs, vector))
    require(largest > 0, "the normal is the zero vector: it has no direction", code="no-normal")
    x, y, z = vector[0] / largest, vector[1] / largest, vector[2] / largest
    size = length(x, y, z)
    return x / size, y / size, z / size


def require_inertia(inertia: Matrix, name: str) -> None:
    """Refuse a tensor that no body can have."""
    (a, b, _), (_, d, _), _ = inertia
    require(
        a > 0 and fused(a, d, -(b * b)) > 0 and determinant(inertia) > 0,
        "the inertia of {name} is not that of a real body: its principal moments are not all above zero",
        name=name,
        code="no-inertia",
    )
    require_inertia_of_body(inertia, name)


def mobility(bodies: tuple[SolidInSpace, SolidInSpace], frame: Matrix) -> Matrix:
    """K in the frame of the contact."""
    rows = []
    for axis in frame:
        moved = add(bodies[0].answer(axis), bodies[1].answer(axis))
        rows.append((dot(moved, frame[0]), dot(moved, frame[1]), dot(moved, frame[2])))
    # symmetric but for rounding
    a, b, c = rows
    return a, (a[1], b[1], b[2]), (a[2], b[2], c[2])
