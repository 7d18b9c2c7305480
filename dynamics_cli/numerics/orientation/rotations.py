"""Rotations as people write them: an axis and an angle, Euler angles in a named order, a quaternion, a matrix."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import maximum, sin, sqrt, where
from dynamics_cli.numerics.number import is_array, plain, single
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import Angle, Annotated, Direction, Quaternion, Ratio, Text, Vector
from dynamics_cli.records import record

Matrix = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]

IDENTITY: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
# A matrix farther than this from a rotation is a mistake; a nearer one was rounded in writing.
NEAR_ROTATION = 1e-3
ORDERS = ("xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "xyx", "xzx", "yxy", "yzy", "zxz", "zyz")


@record
class AxisAngle:
    """A turn about an axis, right-handed."""

    rotation_axis: Annotated[Direction, "Direction of the axis, of any length [-]."]
    rotation_angle: Annotated[Angle, "Angle of the turn [rad]."]


@record
class Euler:
    """Three turns about axes in a named order."""

    euler_angles: Annotated[tuple[Angle, ...], "The three angles, in the order of the axes, e.g. 30, 0, 45 deg."]
    euler_order: Annotated[
        Text,
        "Order of the three turns: small letters turn about the body's turned axes (zyx is yaw, pitch, roll), capitals "
        "about the fixed ones (XYZ is roll, pitch, yaw of URDF), e.g. zyx.",
    ]


@record
class ByQuaternion:
    """A quaternion."""

    quaternion: Annotated[Quaternion, "w, x, y, z: scalar first, of any length, e.g. 0.924, 0, 0, 0.383."]


@record
class ByMatrix:
    """A rotation matrix."""

    rotation_matrix: Annotated[
        tuple[Vector, ...], "Its three rows; its columns are the turned axes, e.g. (0, -1, 0), (1, 0, 0), (0, 0, 1)."
    ]


Turn = AxisAngle | Euler | ByQuaternion | ByMatrix


def matrix_of(turn: Turn) -> Matrix:
    """The rotation matrix R that takes vectors of the turned axes to the given ones; its columns are the turned axes.

    Raises InadmissibleError when an axis or a quaternion is zero, the order of Euler angles unknown, or a matrix not a
    rotation.
    """
    if isinstance(turn, AxisAngle):
        return axis_angle(turn.rotation_axis, turn.rotation_angle)
    if isinstance(turn, Euler):
        return euler(turn.euler_angles, turn.euler_order)
    if isinstance(turn, ByQuaternion):
        return from_quaternion(turn.quaternion)
    return from_rows(turn.rotation_matrix)


def product(a: Matrix, b: Matrix) -> Matrix:
    """The product of two matrices."""
    columns = tuple(zip(*b, strict=True))
    return tuple(tuple(r[0] * c[0] + r[1] * c[1] + r[2] * c[2] for c in columns) for r in a)  # type: ignore[return-value]


def transposed(matrix: Matrix) -> Matrix:
    """The transpose, for a rotation its inverse."""
    return tuple(zip(*matrix, strict=True))  # type: ignore[return-value]


def axis_angle(axis: "tuple[float, float, float]", angle: float) -> Matrix:
    """Rodrigues' rotation cos θ·1 + (1 − cos θ) n nᵀ + sin θ [n×], small angles by the half, which loses nothing.

    References
    ----------
    Rodrigues' formula: Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 4.
    """
    x, y, z = axis
    square = x * x + y * y + z * z
    require(square > 0.0, "the rotation axis has no length", code="rotation", hint="for example 0, 0, 1")
    half = sin(0.5 * angle)
    cosine, sine = turned(angle)
    versed = where(cosine <= 0.5, 1.0 - cosine, 2.0 * half * half) / square
    sine = sine / sqrt(square)
    return (
        (1.0 - versed * (y * y + z * z), versed * x * y - sine * z, versed * x * z + sine * y),
        (versed * x * y + sine * z, 1.0 - versed * (x * x + z * z), versed * y * z - sine * x),
        (versed * x * z - sine * y, versed * y * z + sine * x, 1.0 - versed * (x * x + y * y)),
    )


def from_quaternion(q: "tuple[float, float, float, float]") -> Matrix:
    """The rotation of a quaternion of any length."""
    w, x, y, z = q
    square = w * w + x * x + y * y + z * z
    require(
        square > 0.0, "the quaternion has no length", code="rotation", hint="1, 0, 0, 0 leaves the axes as they are"
    )
    s = 2.0 / square
    return (
        (1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)),
        (s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)),
        (s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)),
    )


def euler(angles: "tuple[float, ...]", order: str) -> Matrix:
    """The product of three turns about coordinate axes; intrinsic for small letters, extrinsic for capitals."""
    require(
        order.lower() in ORDERS and order in (order.lower(), order.upper()),
        "the order of Euler angles {read} is unknown",
        code="rotation",
        hint="zyx or zxz about the turning axes, XYZ about the fixed ones",
        read=repr(order),
    )
    require(len(angles) == 3, "read {count} Euler angles, wanted 3", code="rotation", count=len(angles),
            hint="for example 30, 0, 45 deg")  # fmt: skip
    rotation = IDENTITY
    for letter, angle in zip(order.lower(), angles, strict=True):
        turn = about_axis("xyz".index(letter), angle)
        rotation = product(rotation, turn) if order.islower() else product(turn, rotation)
    return rotation


def about_axis(k: int, angle: float) -> Matrix:
    """A turn about a coordinate axis."""
    c, s = turned(angle)
    if k == 0:
        return (1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c)
    if k == 1:
        return (c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c)
    return (c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)


def from_rows(rows: "tuple[tuple[float, float, float], ...]") -> Matrix:
    """The rotation nearest to a matrix that was written with few digits; anything further off is refused.

    References
    ----------
    N. J. Higham, Computing the polar decomposition—with applications, SIAM J. Sci. Stat. Comput. 7 (1986) 1160.
    """
    require(len(rows) == 3, "read {count} rows of a rotation matrix, wanted 3", code="rotation", count=len(rows),
            hint="for example (0, -1, 0), (1, 0, 0), (0, 0, 1)")  # fmt: skip
    matrix: Matrix = (rows[0], rows[1], rows[2])
    off = departure(matrix)
    scale = None if is_array(off) or off <= NEAR_ROTATION else _scale(matrix)
    require(
        off <= NEAR_ROTATION,
        "the matrix is not a rotation: its rows depart from unit length and right angles by {departure:3}",
        code="rotation",
        hint="write it with more digits, or give axis and angle" if scale is None else "divide it by {scale:6}",
        departure=(off, Ratio),
        scale=(scale or 1.0, Ratio),
    )
    require(
        determinant(matrix) > 0.0,
        "the matrix is a reflection: its determinant is {determinant:6}",
        code="rotation",
        hint="a body is turned, not mirrored; change the sign of one row if the axes are left-handed",
        determinant=(determinant(matrix), Ratio),
    )
    # Newton's iteration for the polar factor squares the departure; three steps end at rounding
    for _ in range(4):
        orthogonal = departure(matrix) < 4e-16
        if orthogonal is True or getattr(orthogonal, "all", bool)():
            break
        excess = product(transposed(matrix), matrix)
        half = tuple(tuple((1.5 if i == j else 0.0) - 0.5 * excess[i][j] for j in range(3)) for i in range(3))
        better = product(matrix, half)  # type: ignore[arg-type]
        matrix = _chosen(orthogonal, matrix, better)
    return matrix


def _scale(matrix: Matrix) -> float | None:
    """The common length of the rows of a rotation times a number; None of any other matrix."""
    length = sum(plain(x) ** 2 for x in matrix[0]) ** 0.5
    if not length:
        return None
    rows = tuple(tuple(plain(x) / length for x in row) for row in matrix)
    return length if departure(rows) <= NEAR_ROTATION else None  # type: ignore[arg-type]


def _chosen(first: bool, a: Matrix, b: Matrix) -> Matrix:
    """The first matrix where the condition holds, the second elsewhere."""
    if first is False:
        return b
    return tuple(tuple(where(first, x, y) for x, y in zip(p, q, strict=True)) for p, q in zip(a, b, strict=True))  # type: ignore[return-value]


def departure(matrix: Matrix) -> float:
    """The largest element of R Rᵀ − 1."""
    grown = product(matrix, transposed(matrix))
    off = [abs(grown[i][j] - (1.0 if i == j else 0.0)) for i in range(3) for j in range(3)]
    if single(*off):
        return max(off)
    largest = off[0]
    for other in off[1:]:
        largest = maximum(largest, other)
    return largest


def determinant(m: Matrix) -> float:
    """The determinant: 1 of a rotation, −1 of a mirror."""
    (a, b, c), (d, e, f), (g, h, i) = m
    return a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
