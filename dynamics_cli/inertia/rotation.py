"""Rotations as people write them: an axis and an angle, Euler angles in a named order, a quaternion, a matrix."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.lump import IDENTITY, product, transposed
from dynamics_cli.numerics.elementary import cos, sin, sqrt
from dynamics_cli.quantities import Angle, Direction, Quaternion, Text, Vector
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.lump import Matrix

# A matrix further than this from a rotation is a mistake; one that is nearer was rounded by who wrote it.
NEAR_ROTATION = 1e-3
ORDERS = ("xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "xyx", "xzx", "yxy", "yzy", "zxz", "zyz")


@record
class AxisAngle:
    """A turn about an axis, right-handed.

    Parameters
    ----------
    rotation_axis : Direction
        Direction of the axis, of any length [-].
    rotation_angle : Angle
        Angle of the turn [rad].
    """

    rotation_axis: Direction
    rotation_angle: Angle


@record
class Euler:
    """Three turns about axes in a named order.

    Parameters
    ----------
    euler_angles : tuple of Angle
        The three angles, in the order of the axes [rad].
    euler_order : Text
        Axes in order: small letters turn about the body's own axes as they have become (zyx is yaw, pitch, roll),
        capitals about the fixed ones (XYZ is roll, pitch, yaw as URDF takes them).
    """

    euler_angles: tuple[Angle, ...]
    euler_order: Text


@record
class ByQuaternion:
    """A quaternion.

    Parameters
    ----------
    quaternion : Quaternion
        w, x, y, z, its scalar first, of any length [-].
    """

    quaternion: Quaternion


@record
class ByMatrix:
    """A rotation matrix.

    Parameters
    ----------
    rotation_matrix : tuple of Vector
        Its three rows, on the command line in parentheses; its columns are the turned axes [-].
    """

    rotation_matrix: tuple[Vector, ...]


Turn = AxisAngle | Euler | ByQuaternion | ByMatrix


def matrix_of(turn: Turn) -> "Matrix":
    """The rotation matrix R that takes vectors of the turned axes to the given ones; its columns are the turned axes.

    Raises
    ------
    InadmissibleError
        When an axis or a quaternion has no length, the order of Euler angles is none, or a matrix is no rotation.
    """
    if isinstance(turn, AxisAngle):
        return axis_angle(turn.rotation_axis, turn.rotation_angle)
    if isinstance(turn, Euler):
        return euler(turn.euler_angles, turn.euler_order)
    if isinstance(turn, ByQuaternion):
        return from_quaternion(turn.quaternion)
    return from_rows(turn.rotation_matrix)


def axis_angle(axis: "tuple[float, float, float]", angle: float) -> "Matrix":
    """Rodrigues' rotation cos θ·1 + (1 − cos θ) n nᵀ + sin θ [n×], by the half angle, which loses no small angles."""
    x, y, z = axis
    square = x * x + y * y + z * z
    require(square > 0.0, "the rotation axis has no length", code="rotation")
    half = sin(0.5 * angle)
    versed = 2.0 * half * half / square
    sine = sin(angle) / sqrt(square)
    return (
        (1.0 - versed * (y * y + z * z), versed * x * y - sine * z, versed * x * z + sine * y),
        (versed * x * y + sine * z, 1.0 - versed * (x * x + z * z), versed * y * z - sine * x),
        (versed * x * z - sine * y, versed * y * z + sine * x, 1.0 - versed * (x * x + y * y)),
    )


def from_quaternion(q: "tuple[float, float, float, float]") -> "Matrix":
    """The rotation of a quaternion of any length."""
    w, x, y, z = q
    square = w * w + x * x + y * y + z * z
    require(square > 0.0, "the quaternion has no length", code="rotation", hint="1, 0, 0, 0 is no rotation")
    s = 2.0 / square
    return (
        (1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)),
        (s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)),
        (s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)),
    )


def euler(angles: "tuple[float, ...]", order: str) -> "Matrix":
    """The product of three turns about coordinate axes; intrinsic for small letters, extrinsic for capitals."""
    require(
        order.lower() in ORDERS and order in (order.lower(), order.upper()),
        "there is no order of Euler angles {0!r}",
        order,
        code="rotation",
        hint="zyx or zxz about the turning axes, XYZ about the fixed ones",
    )
    require(len(angles) == 3, "read {0} Euler angles, wanted 3", len(angles), code="rotation")
    made = IDENTITY
    for letter, angle in zip(order.lower(), angles, strict=True):
        turn = about_axis("xyz".index(letter), angle)
        made = product(made, turn) if order.islower() else product(turn, made)
    return made


def about_axis(k: int, angle: float) -> "Matrix":
    """A turn about a coordinate axis."""
    c, s = cos(angle), sin(angle)
    if k == 0:
        return (1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c)
    if k == 1:
        return (c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c)
    return (c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)


def from_rows(rows: "tuple[tuple[float, float, float], ...]") -> "Matrix":
    """The rotation nearest to a matrix that was written with few digits; anything further off is refused."""
    require(len(rows) == 3, "read {0} rows of a rotation matrix, wanted 3", len(rows), code="rotation")
    matrix: Matrix = (rows[0], rows[1], rows[2])
    off = departure(matrix)
    require(
        off <= NEAR_ROTATION,
        "the matrix is no rotation: its rows are {0:.3g} away from unit length and right angles",
        off,
        code="rotation",
        hint="write it with more digits, or give axis and angle",
    )
    require(
        _determinant(matrix) > 0.0,
        "the matrix mirrors: its determinant is {0:.6g}",
        _determinant(matrix),
        code="rotation",
        hint="a body is turned, not mirrored; change the sign of one row if the axes are left-handed",
    )
    # Newton's iteration for the polar factor squares the departure; three steps end at rounding
    for _ in range(4):
        if departure(matrix) < 4e-16:
            break
        excess = product(transposed(matrix), matrix)
        half = tuple(tuple((1.5 if i == j else 0.0) - 0.5 * excess[i][j] for j in range(3)) for i in range(3))
        matrix = product(matrix, half)  # type: ignore[arg-type]
    return matrix


def departure(matrix: "Matrix") -> float:
    """The greatest element of R Rᵀ − 1."""
    grown = product(matrix, transposed(matrix))
    return max(abs(grown[i][j] - (1.0 if i == j else 0.0)) for i in range(3) for j in range(3))


def _determinant(m: "Matrix") -> float:
    (a, b, c), (d, e, f), (g, h, i) = m
    return a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
