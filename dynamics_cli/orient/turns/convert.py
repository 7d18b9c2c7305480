"""A rotation in every notation, from any of them."""

from dynamics_cli.errors import worded
from dynamics_cli.numerics.number import decides, is_many, over_plain, plain, single
from dynamics_cli.numerics.orientation.quaternions import axis_angle_and_vector, normalized
from dynamics_cli.numerics.orientation.rotations import ORDERS, ByMatrix, Euler, determinant, product, transposed
from dynamics_cli.numerics.orientation.rotations import from_quaternion as matrix_of
from dynamics_cli.numerics.orientation.sequences import (
    Angles,
    Sequence,
    angles_in_words,
    names_of,
    nearest,
    sequence_of,
)
from dynamics_cli.orient.turns.attitude import Attitude, Orientation, given_digits, orientation
from dynamics_cli.quantities import (
    Angle,
    AngleTriple,
    Annotated,
    Direction,
    Quaternion,
    Ratio,
    Remark,
    RotationMatrix,
    RotationVector,
    Text,
    Vector,
)
from dynamics_cli.records import Advice, Check, Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.orientation.rotations import Matrix

# Uncertainty of a rotation due to the rounding of doubles.
ROUNDING = 4e-16
# An angle that is not known to this [rad] is not determined.
UNDETERMINED = 0.1
# Angles this many times as sensitive as the rotation deserve a remark.
SENSITIVE = 50.0
# A residual above this is a mistake of the program.
TOLERANCE = 1e-14


class Zeroed(Choice):
    """The angle that is set to zero at lock."""

    names = ("first", "third")


FIRST = Zeroed("first")


@record
class SequenceAngles:
    """Angles of one sequence of turns about body axes; in reverse order, about fixed axes."""

    body: Annotated[Text, "The sequence about the turning axes."]
    fixed: Annotated[Text, "The same turns about the fixed axes, in reverse."]
    first: Annotated[Angle, "First angle of the body sequence, last of the fixed one [rad]."]
    second: Annotated[Angle, "Middle angle [rad]."]
    third: Annotated[Angle, "Third angle of the body sequence, first of the fixed one [rad]."]
    lock_distance: Annotated[Angle, "How far the middle angle is from lock [rad]."]


@record
class Converted:
    """A rotation in every notation."""

    rotation_angle: Annotated[Angle, "Angle of the turn, from 0 to 180° [rad]."]
    rotation_axis: Annotated[Direction, "Unit vector along its axis [-]."]
    euler_angles: Annotated[AngleTriple, "The three angles of the sequence [rad]."]
    quaternion: Annotated[Quaternion, "w, x, y, z with w ≥ 0: the Euler parameters, scalar first [-]."]
    rotation_vector: Annotated[RotationVector, "The axis times the angle [rad]."]
    rotation_matrix: Annotated[RotationMatrix, "Takes body components to fixed ones; its columns are the body axes."]
    alternative_angles: Annotated[AngleTriple, "The other three angles of the sequence for the same rotation [rad]."]
    lock_distance: Annotated[Angle, "How far the middle angle is from lock [rad]."]
    rodrigues: Annotated[Vector | None, "The axis times tan(θ/2); of a half turn none [-]."]
    euler_order: Annotated[Text, "The sequence: small letters about the body's axes, capitals about fixed ones."]
    lock: Annotated[Text, "Gimbal lock: none, near, or locked, where the input does not determine two of the angles."]
    names: Annotated[Remark, "What others call these angles."]
    angle_names: Annotated[Remark, "The three angles in words, in their order."]
    convention: Annotated[Remark, "Meaning of the numbers."]
    departure: Annotated[Ratio | None, "How far a given matrix is from the rotation nearest to it [-]."] = None
    sequences: Annotated[tuple[SequenceAngles, ...], "The angles of all 24 sequences."] = ()
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def convert(
    *,
    turn: Annotated[Attitude, "The rotation, in one of the notations."],
    sequence: Annotated[
        Text,
        "Angles to report: zyx, zxz … about the turned axes, XYZ … about fixed ones, or rpy, bryan, euler, e.g. zyx.",
    ] = "zyx",
    near: Annotated[AngleTriple | None, "Give the angles nearest to these, e.g. 170, 0, 0 deg."] = None,
    zero: Annotated[Zeroed, "The angle that is zero at lock: first or third."] = FIRST,
) -> Converted:
    """A rotation in every notation: matrix, axis and angle, rotation vector, quaternion, angles, Rodrigues parameters.

    Equation
    --------
    q = (cos ½θ, n sin ½θ), R = 1 + sin θ [n×] + (1 − cos θ) [n×]², R = Rᵢ(a)·Rⱼ(b)·Rₖ(c) of the body sequence ijk.

    Raises
    ------
    InadmissibleError
        When an axis or quaternion is zero, a sequence unknown, a matrix not a rotation, or two directions opposite.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 4.2, 18.5 and 18.7; Bernardes & Viollet,
    2022 (quaternion to angles).

    Examples
    --------
    >>> from dynamics_cli.numerics.orientation.rotations import ByMatrix
    >>> answer = convert(turn=ByMatrix(rotation_matrix=((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))))
    >>> answer.quaternion
    (0.5, 0.5, 0.5, 0.5)
    """
    order = sequence_of(sequence)
    rotation = orientation(turn)
    angles = rotation.angles(order, zero_third=zero == "third")
    q = rotation.quaternion
    axis, angle, vector = axis_angle_and_vector(q)
    # words, tables and checks are about one case in doubles
    alone = single(*q) and not is_many(q[0])
    w, x, y, z = q
    # a half turn has no Rodrigues parameters; rows of which one is such are answered one by one
    parameters = None if single(*q) and w == 0.0 else (x / w, y / w, z / w)
    return Converted(
        rotation_angle=angle,
        rotation_axis=axis,
        euler_angles=angles.angles if near is None else nearest(angles, near),
        quaternion=q,
        rotation_vector=vector,
        rotation_matrix=rotation.matrix,
        alternative_angles=angles.alternative,
        lock_distance=angles.distance,
        rodrigues=parameters,
        euler_order=order.text,
        lock=_state(rotation, angles) if decides(*q) and not is_many(q[0]) else "",
        names=names_of(order),
        angle_names=angles_in_words(order),
        convention="right-handed; the matrix takes body components to fixed ones; the quaternion is scalar first",
        departure=rotation.departure,
        sequences=_all_sequences(rotation) if alone else (),
        checks=_checks(rotation, angles, order) if alone else (),
        advice=_advice(turn, rotation, angles, zero) if alone else (),
    )


def _state(read: Orientation, angles: Angles) -> str:
    """Whether the uncertainty of the rotation leaves first and third angle undetermined."""
    unknown = ROUNDING + 2.0 * (plain(read.departure) if read.departure is not None else 0.0)
    margin = plain(angles.margin)
    if margin * UNDETERMINED < unknown:
        return "locked"
    return "near" if margin < 1.0 / SENSITIVE else "none"


def _all_sequences(read: Orientation) -> tuple[SequenceAngles, ...]:
    doubles: Orientation = over_plain(read)
    rows = []
    for order in ORDERS:
        angles = doubles.angles(sequence_of(order))
        first, second, third = angles.angles
        rows.append(SequenceAngles(order, order[::-1].upper(), first, second, third, angles.distance))
    return tuple(rows)


def distance_of(a: "Matrix", b: "Matrix") -> float:
    """The largest difference of two matrices' elements."""
    return float(max(abs(plain(x) - plain(y)) for p, q in zip(a, b, strict=True) for x, y in zip(p, q, strict=True)))


def _checks(read: Orientation, angles: Angles, sequence: Sequence) -> tuple[Check, ...]:
    from dynamics_cli.numerics.orientation.rotations import IDENTITY

    doubles: Orientation = over_plain(read)
    triple = tuple(plain(angle) for angle in angles.angles)
    rebuilt = orientation(Euler(euler_angles=triple, euler_order=sequence.text)).matrix
    residuals = {
        "angles give the rotation": distance_of(rebuilt, doubles.matrix),
        "quaternion gives the rotation": distance_of(matrix_of(normalized(doubles.quaternion)), doubles.matrix),
        "RᵀR = 1": distance_of(product(transposed(doubles.matrix), doubles.matrix), IDENTITY),
        "det R = 1": abs(determinant(doubles.matrix) - 1.0),
    }
    return tuple(Check(name, value <= TOLERANCE, value, TOLERANCE) for name, value in residuals.items())


def _advice(turn: Attitude, read: Orientation, angles: Angles, zero: Zeroed) -> tuple[Advice, ...]:
    advice = [*_repair(turn, read), *_lock(angles, zero)]
    w, *rest = map(plain, read.quaternion)
    if w == 0.0:
        message = "a half turn: the axis and its opposite give the same rotation, and Rodrigues parameters do not exist"
        advice.append(Advice("half-turn", message, severity="note", result="rodrigues"))
    elif not any(rest):
        advice.append(Advice("no-turn", "no rotation: the axis is arbitrary, and z is shown", severity="note"))
    return tuple(advice)


def _repair(turn: Attitude, read: Orientation) -> "list[Advice]":
    """The correction of a matrix that is not exactly a rotation."""
    if not isinstance(turn, ByMatrix) or read.departure is None or read.departure <= TOLERANCE:
        return []
    rows = tuple(tuple(plain(element) for element in row) for row in turn.rotation_matrix)
    digits = given_digits(rows)  # type: ignore[arg-type]
    message = worded(
        "the matrix departs from a rotation by {departure}{rounded}; the nearest rotation was taken",
        departure=(read.departure, Ratio),
        rounded=f", as of elements rounded to {digits} decimals" if digits else "",
    )
    return [Advice("repaired", message, remedy="give more digits")]


def _lock(angles: Angles, zero: Zeroed) -> "list[Advice]":
    """Effect of gimbal lock, or of being close to it, on the angles."""
    margin = plain(angles.margin)
    if margin == 0.0:
        return [
            Advice(
                "lock",
                "gimbal lock: only the sum or difference of first and third angle is determined; "
                f"the {zero} was set to 0",
                remedy="choose a sequence that is far from lock (table sequences), or --zero third",
            )
        ]
    if margin >= 1.0 / SENSITIVE:
        return []
    message = worded(
        "{distance} from gimbal lock: first and third angle are {times:3} times as sensitive as the rotation",
        distance=(angles.distance, Angle),
        times=(1.0 / margin, Ratio),
    )
    remedy = "the rotation they give is right; another sequence is farther from lock (table sequences)"
    return [Advice("near-lock", message, severity="note", remedy=remedy)]
