"""Unit quaternions, scalar first: products, and to and from matrices, rotation vectors, axis and angle.

Every function takes numbers, arrays and tracked numbers, and keeps its digits at small angles and at half turns.
"""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import atan2, cos, maximum, sin, sqrt, where
from dynamics_cli.numerics.number import is_tracked
from dynamics_cli.numerics.orientation.rotations import Matrix
from dynamics_cli.numerics.turns import turned
from dynamics_cli.numerics.vectors import Vector, length

Quaternion = tuple[float, float, float, float]


def opposite(x: float) -> float:
    """The opposite number; that of zero is plain zero."""
    other = 0.0 - x
    if is_tracked(other) and other == 0.0:
        other.value = 0.0  # type: ignore[attr-defined]
    return other


def multiply(p: Quaternion, q: Quaternion) -> Quaternion:
    """The rotation q in axes already rotated by p: p·q."""
    a, b, c, d = p
    w, x, y, z = q
    return (
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


def conjugate(q: Quaternion) -> Quaternion:
    """The inverse rotation."""
    return q[0], opposite(q[1]), opposite(q[2]), opposite(q[3])


def normalized(q: Quaternion) -> Quaternion:
    """The unit quaternion along one of any length, without overflow or underflow.

    Raises
    ------
    InadmissibleError
        When all four components are zero.
    """
    largest = maximum(maximum(abs(q[0]), abs(q[1])), maximum(abs(q[2]), abs(q[3])))
    hint = "1, 0, 0, 0 leaves the axes as they are"
    require(largest > 0.0, "the quaternion has no length", code="rotation", hint=hint)
    w, x, y, z = q[0] / largest, q[1] / largest, q[2] / largest, q[3] / largest
    size = sqrt(w * w + x * x + y * y + z * z)
    return w / size, x / size, y / size, z / size


def upright(q: Quaternion) -> Quaternion:
    """The one of q and −q with w ≥ 0; for a half turn, the one whose first nonzero component is positive."""
    w, x, y, z = q
    first = where(x != 0.0, x, where(y != 0.0, y, z))
    turn = where(w != 0.0, w, first) < 0.0
    return _flipped(turn, w), _flipped(turn, x), _flipped(turn, y), _flipped(turn, z)


def _flipped(turn: bool, x: float) -> float:
    return where(turn, opposite(x), opposite(opposite(x)))


def of_axis_angle(axis: Vector, angle: float) -> Quaternion:
    """The quaternion of a turn about an axis of any length."""
    size = length(axis)
    require(size > 0.0, "the rotation axis has no length", code="rotation", hint="for example 0, 0, 1")
    cosine, sine = turned(0.5 * angle)
    return cosine, sine * (axis[0] / size), sine * (axis[1] / size), sine * (axis[2] / size)


def of_vector(v: Vector) -> Quaternion:
    """The quaternion of a rotation vector, the axis times the angle: the exponential."""
    angle = length(v)
    still = angle == 0.0
    factor = where(still, 0.5, sin(0.5 * angle) / where(still, 1.0, angle))
    return cos(0.5 * angle), factor * v[0], factor * v[1], factor * v[2]


def of_rotation(m: Matrix) -> Quaternion:
    """The quaternion of a rotation matrix.

    The matrix 4·q qᵀ follows from that of the rotation; its row with the largest diagonal element (at least one) is
    along q, without cancellation in its length.

    References
    ----------
    S. W. Shepperd, Quaternion from rotation matrix, J. Guid. Control 1 (1978) 223.
    """
    (a, b, c), (d, e, f), (g, h, i) = m
    wx, wy, wz = h - f, c - g, d - b
    xy, zx, yz = b + d, c + g, f + h
    ww, xx, yy, zz = 1.0 + (a + e + i), 1.0 + (a - e - i), 1.0 + (e - a - i), 1.0 + (i - a - e)
    by_w = (ww >= xx) & (ww >= yy) & (ww >= zz)
    by_x = (xx >= yy) & (xx >= zz)
    by_y = yy >= zz
    rows = ((ww, wx, wy, wz), (wx, xx, xy, zx), (wy, xy, yy, yz), (wz, zx, yz, zz))
    w, x, y, z = (where(by_w, p, where(by_x, q, where(by_y, r, s))) for p, q, r, s in zip(*rows, strict=True))
    size = sqrt(w * w + x * x + y * y + z * z)
    return w / size, x / size, y / size, z / size


def axis_and_angle(q: Quaternion) -> tuple[Vector, float]:
    """Axis and angle of a unit quaternion with w ≥ 0: the angle from 0 to 180°; for no turn the axis is z."""
    axis, angle, _ = axis_angle_and_vector(q)
    return axis, angle


def axis_angle_and_vector(q: Quaternion) -> tuple[Vector, float, Vector]:
    """Axis, angle and rotation vector."""
    w, x, y, z = q
    size = length((x, y, z))
    still = size == 0.0
    divisor = where(still, 1.0, size)
    axis = (x / divisor, y / divisor, where(still, 1.0, z / divisor))
    angle = 2.0 * atan2(size, w)
    factor = where(still, 2.0, angle / divisor)
    return axis, angle, (factor * x, factor * y, factor * z)


def between_directions(first: Vector, second: Vector) -> Quaternion:
    """The shortest turn that takes one direction to another.

    Raises
    ------
    InadmissibleError
        When a direction is the zero vector, or the two are opposite, which leaves the axis open.

    References
    ----------
    Derived: half the sum of two unit vectors is along their bisector.
    """
    (a, b, c), (x, y, z) = unit(first), unit(second)
    # half the sum is along the bisector, whose length is the cosine of half the angle
    middle = (0.5 * (a + x), 0.5 * (b + y), 0.5 * (c + z))
    cosine = length(middle)
    require(
        cosine > 1e-15,
        "the two directions are opposite: any axis across them gives a half turn",
        code="opposite",
        hint="give axis and angle instead",
    )
    u, v, w = middle[0] / cosine, middle[1] / cosine, middle[2] / cosine
    return cosine, b * w - c * v, c * u - a * w, a * v - b * u


def unit(v: Vector, message: str = "the direction is the zero vector") -> Vector:
    """The unit vector along a direction.

    Raises
    ------
    InadmissibleError
        When it has no length.
    """
    size = length(v)
    require(size > 0.0, message, code="direction", hint="give three numbers of which one is not zero")
    return v[0] / size, v[1] / size, v[2] / size
