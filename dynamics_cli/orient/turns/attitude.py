"""A rotation as a user gives it, in any notation, read into its quaternion and its matrix."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import atan2, sqrt
from dynamics_cli.numerics.orientation.quaternions import (
    Quaternion,
    between_directions,
    normalized,
    of_axis_angle,
    of_rotation,
    of_vector,
    upright,
)
from dynamics_cli.numerics.orientation.rotations import (
    AxisAngle,
    ByMatrix,
    ByQuaternion,
    Euler,
    Matrix,
    about_axis,
    axis_angle,
    from_quaternion,
    from_rows,
    product,
)
from dynamics_cli.numerics.orientation.sequences import (
    Angles,
    Sequence,
    angles_of_quaternion,
    angles_of_rotation,
    quaternion_of_angles,
    sequence_of,
)
from dynamics_cli.quantities import Angle, Annotated, Direction, Ratio, Vector
from dynamics_cli.quantities import RotationVector as RotationVectorKind
from dynamics_cli.records import record


@record
class RotationVector:
    """A rotation vector."""

    rotation_vector: Annotated[RotationVectorKind, "The axis times the angle, e.g. 0, 0, 1.2 rad."]


@record
class Rodrigues:
    """Rodrigues parameters, also called the Gibbs vector."""

    rodrigues: Annotated[Vector, "The axis times tan(θ/2), e.g. 0, 0, 0.5."]


@record
class TwoDirections:
    """The shortest turn from one direction to another."""

    from_direction: Annotated[Direction, "A direction before the turn, of any length, e.g. 1, 0, 0."]
    to_direction: Annotated[Direction, "The same direction after the shortest turn, e.g. 1, 1, 0."]


@record
class YawPitchRoll:
    """Yaw, pitch and roll: turns about the body's z, then its y, then its x axis."""

    yaw: Annotated[Angle, "Turn about the body's z axis, the first, e.g. 30 deg."]
    pitch: Annotated[Angle, "Then about its y axis, e.g. 5 deg."] = 0.0
    roll: Annotated[Angle, "Then about its x axis, e.g. -10 deg."] = 0.0


@record
class ByComponents:
    """A quaternion by its components' names, as the columns of logs have them, in any order."""

    qw: Annotated[Ratio, "Scalar part of a quaternion of any length, e.g. 0.924."]
    qx: Annotated[Ratio, "Its x component, e.g. 0."]
    qy: Annotated[Ratio, "Its y component, e.g. 0."]
    qz: Annotated[Ratio, "Its z component, e.g. 0.383."]


Attitude = (
    ByQuaternion
    | ByComponents
    | Euler
    | YawPitchRoll
    | AxisAngle
    | RotationVector
    | ByMatrix
    | Rodrigues
    | TwoDirections
)


@record
class Orientation:
    """A rotation as read: its unit quaternion with w ≥ 0, its matrix, and the form to take angles from."""

    quaternion: Quaternion
    matrix: Matrix
    by_matrix: bool
    departure: float | None = None
    """How far a given matrix is from the rotation nearest to it (Frobenius norm)."""

    def angles(self, sequence: Sequence, *, zero_third: bool = False) -> Angles:
        """The angles of a sequence, directly from the input: a detour would lose digits near lock."""
        if self.by_matrix:
            return angles_of_rotation(self.matrix, sequence, zero_third=zero_third)
        return angles_of_quaternion(self.quaternion, sequence, zero_third=zero_third)


def orientation(turn: Attitude) -> Orientation:
    """Read a rotation; refuse zero axes and quaternions, unknown sequences, mirrors, opposite directions."""
    if isinstance(turn, ByMatrix):
        return _of_matrix(turn)
    if isinstance(turn, YawPitchRoll):
        return _of_angles(Euler((turn.yaw, turn.pitch, turn.roll), "zyx"))
    if isinstance(turn, Euler):
        return _of_angles(turn)
    if isinstance(turn, AxisAngle):
        quaternion = upright(of_axis_angle(turn.rotation_axis, turn.rotation_angle))
        return Orientation(
            quaternion=quaternion, matrix=axis_angle(turn.rotation_axis, turn.rotation_angle), by_matrix=False
        )
    if isinstance(turn, RotationVector):
        q = of_vector(turn.rotation_vector)
    elif isinstance(turn, Rodrigues):
        x, y, z = turn.rodrigues
        q = normalized((1.0, x, y, z))
    elif isinstance(turn, TwoDirections):
        q = between_directions(turn.from_direction, turn.to_direction)
    else:
        q = normalized(turn.quaternion if isinstance(turn, ByQuaternion) else (turn.qw, turn.qx, turn.qy, turn.qz))
    return Orientation(quaternion=upright(q), matrix=from_quaternion(q), by_matrix=False)


def _of_matrix(turn: ByMatrix) -> Orientation:
    nearest = from_rows(turn.rotation_matrix)
    off = 0.0
    for written, row in zip(turn.rotation_matrix, nearest, strict=True):
        for element, other in zip(written, row, strict=True):
            off = off + (element - other) * (element - other)
    return Orientation(quaternion=upright(of_rotation(nearest)), matrix=nearest, by_matrix=True, departure=sqrt(off))


def _of_angles(turn: Euler) -> Orientation:
    sequence = sequence_of(turn.euler_order)
    angles = turn.euler_angles
    require(len(angles) == 3, "read {count} Euler angles, wanted 3", code="rotation", count=len(angles),
            hint="for example 30, 0, 45 deg")  # fmt: skip
    triple = (angles[0], angles[1], angles[2])
    first, second, third = (
        about_axis(axis, angle)
        for axis, angle in zip(sequence.axes, triple[::-1] if sequence.fixed else triple, strict=True)
    )
    return Orientation(
        quaternion=upright(quaternion_of_angles(triple, sequence)),
        matrix=product(product(first, second), third),
        by_matrix=True,
    )


def given_digits(rows: "tuple[tuple[float, float, float], ...]") -> int | None:
    """How many decimals every element of a matrix was written with, where these are few."""
    for digits in range(1, 11):
        if all(round(element, digits) == element for row in rows for element in row):
            return digits
    return None


def part_about(q: Quaternion, axis: "tuple[float, float, float]") -> float:
    """Angle of the part of a rotation about a unit axis, as a gimbal along it would show."""
    along = q[1] * axis[0] + q[2] * axis[1] + q[3] * axis[2]
    return 2.0 * atan2(along, q[0])
