"""The rotation that takes given directions to measured ones: least squares, or one direction exactly."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import atan2, only_in_doubles
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.orientation.quaternions import axis_and_angle, of_rotation, unit, upright
from dynamics_cli.numerics.orientation.rotations import Matrix, from_quaternion, product, transposed
from dynamics_cli.numerics.orientation.sequences import angles_in_words, angles_of_quaternion, sequence_of
from dynamics_cli.numerics.vectors import Vector, cross, dot, length, scale, subtract
from dynamics_cli.numerics.vectors import times as rotated
from dynamics_cli.orient.turns.eigenvector import largest
from dynamics_cli.quantities import Angle, AngleTriple, Annotated, Direction, Positive, Quaternion, Ratio, Remark, Text
from dynamics_cli.quantities import RotationMatrix as RotationMatrixKind
from dynamics_cli.records import Advice, Choice, ErrorBound, Numerics, record

UNIT_ROUNDOFF = 2.0**-53
# A gap below this leaves the rotation open.
AMBIGUOUS = 1e-9
# Below this, errors of the directions are magnified enough to say so.
WEAK = 0.05


class Method(Choice):
    """How the rotation is fitted."""

    names = ("least-squares", "triad")


LEAST_SQUARES = Method("least-squares")


@record
class Pair:
    """A direction before and after the turn."""

    before: Annotated[Direction, "Direction in the body, of any length, e.g. 1, 0, 0."]
    after: Annotated[Direction, "The same direction in fixed components, e.g. 0, 1, 0."]
    weight: Annotated[Positive, "Its weight, as 1/variance, e.g. 2."] = 1.0
    name: Annotated[Text | None, "Its name, e.g. sun."] = None


@record
class Fit:
    """One pair compared with the rotation."""

    name: Annotated[Text, "The pair."]
    residual: Annotated[Angle, "Angle between the turned direction and the measured one [rad]."]
    weight: Annotated[Positive, "Its weight [-]."]


@record
class Aligned:
    """The rotation that fits."""

    quaternion: Annotated[Quaternion, "w, x, y, z with w ≥ 0 [-]."]
    rotation_angle: Annotated[Angle, "Angle of the turn [rad]."]
    rotation_axis: Annotated[Direction, "Its axis [-]."]
    rotation_matrix: Annotated[RotationMatrixKind, "Takes directions before to those after [-]."]
    euler_angles: Annotated[AngleTriple, "Angles in the sequence asked for [rad]."]
    euler_order: Annotated[Text, "The sequence."]
    angle_names: Annotated[Remark, "The three angles in words, in their order."]
    residual: Annotated[Angle, "Weighted root mean square of the remaining angles [rad]."]
    largest_residual: Annotated[Angle, "The largest of them [rad]."]
    sharpness: Annotated[Ratio, "How well the directions are spread: 0 on one line, 1 and more good [-]."]
    pairs: Annotated[tuple[Fit, ...], "Each pair."]
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def align(
    *,
    pairs: Annotated[Pair | tuple[Pair, ...], "Pairs of directions, two or more."],
    fit: Annotated[Method, "least-squares, or triad: of two pairs the first exactly."] = LEAST_SQUARES,
    sequence: Annotated[Text, "Angles to report: zyx, zxz, XYZ …, or rpy, e.g. zyx."] = "zyx",
) -> Aligned:
    """Rotation that takes directions to measured ones, by least squares or with the first exact.

    Equation
    --------
    Σ wᵢ·|R·bᵢ − aᵢ|² least: the quaternion is the eigenvector of Davenport's K with the largest eigenvalue.

    Raises
    ------
    InadmissibleError
        When a direction is zero, there is one pair only, or all directions are on one line.

    References
    ----------
    Wahba's problem (1965), by Davenport's q-method.

    Examples
    --------
    >>> first = Pair(before=(1.0, 0.0, 0.0), after=(0.0, 1.0, 0.0))
    >>> two = Pair(before=(0.0, 1.0, 0.0), after=(-1.0, 0.0, 0.0))
    >>> round(align(pairs=(first, two)).rotation_angle, 12)
    1.570796326795
    """
    several = pairs if isinstance(pairs, tuple) else (pairs,)
    only_in_doubles(*(part for pair in several for part in (*pair.before, *pair.after, pair.weight)))
    require(
        len(several) >= 2,
        "one pair of directions does not determine a rotation: any turn about it may be added",
        code="undetermined",
        hint='give --pair "before=…, after=…" twice or more',
    )
    require(fit == "least-squares" or len(several) == 2, "triad needs two pairs; there are {count}", count=len(several),
            code="pairs", hint="--fit least-squares takes any number")  # fmt: skip
    total = sum(pair.weight for pair in several)
    before = [unit(pair.before) for pair in several]
    after = [unit(pair.after) for pair in several]
    weights = [pair.weight / total for pair in several]
    k = _davenport(before, after, weights)
    _, q, gap, residual = largest(k)
    _require_spread(before, gap)
    if fit == "triad":
        q = of_rotation(product(_triad(after), transposed(_triad(before))))
    q = upright(q)
    matrix = from_quaternion(q)
    misfits = [_angle(rotated(matrix, b), a) for b, a in zip(before, after, strict=True)]
    axis, angle = axis_and_angle(q)
    order = sequence_of(sequence)
    error = 2.0 * (residual + 24.0 * UNIT_ROUNDOFF) / gap
    return Aligned(
        quaternion=q,
        rotation_angle=angle,
        rotation_axis=axis,
        rotation_matrix=matrix,
        euler_angles=angles_of_quaternion(q, order).angles,
        euler_order=order.text,
        angle_names=angles_in_words(order),
        residual=sum(weight * off * off for weight, off in zip(weights, misfits, strict=True)) ** 0.5,
        largest_residual=max(misfits),
        sharpness=gap,
        pairs=tuple(
            Fit(pair.name or f"pair {nth}", off, pair.weight)
            for nth, (pair, off) in enumerate(zip(several, misfits, strict=True), 1)
        ),
        advice=_advice(gap),
        numerics=Numerics(
            "Jacobi rotations of Davenport's matrix; bound from the residual of the eigenvector",
            (
                ErrorBound("quaternion", error, relative=False),
                ErrorBound("rotation_matrix", 4.0 * error, relative=False),
            ),
        ),
    )


def _davenport(before: "list[Vector]", after: "list[Vector]", shares: "list[float]") -> "list[list[float]]":
    b = [
        [sum(s * a[i] * v[j] for s, a, v in zip(shares, after, before, strict=True)) for j in range(3)]
        for i in range(3)
    ]
    trace = b[0][0] + b[1][1] + b[2][2]
    z = (b[2][1] - b[1][2], b[0][2] - b[2][0], b[1][0] - b[0][1])
    lower = [[z[i], *(b[i][j] + b[j][i] - (trace if i == j else 0.0) for j in range(3))] for i in range(3)]
    return [[trace, *z], *lower]


def _require_spread(before: "list[Vector]", gap: float) -> None:
    line = before[0]
    require(
        gap > AMBIGUOUS,
        "the directions do not determine the rotation: any turn about ({x:3}, {y:3}, {z:3}) fits as well",
        code="undetermined",
        hint="add a direction at an angle to it",
        x=(plain(line[0]), Direction),
        y=(plain(line[1]), Direction),
        z=(plain(line[2]), Direction),
    )


def _triad(directions: "list[Vector]") -> Matrix:
    """Columns: the first direction, the normal of both, and the third."""
    first = directions[0]
    normal = unit(cross(first, directions[1]), "the two directions are parallel")
    third = cross(first, normal)
    return transposed((first, normal, third))


def _angle(a: Vector, b: Vector) -> float:
    """The angle of two unit vectors, which keeps its digits when it is small."""
    return atan2(length(cross(a, subtract(b, scale(dot(a, b), a)))), dot(a, b))


def _advice(gap: float) -> tuple[Advice, ...]:
    if gap >= WEAK:
        return ()
    message = worded(
        "the directions are nearly on one line: rotation about it magnifies their errors about {times:3} times",
        times=(1.0 / gap, Ratio),
    )
    return (Advice("weak", message, remedy="add a direction at an angle to it"),)
