"""The mean of several orientations, and how far each is from it."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import only_in_doubles
from dynamics_cli.numerics.orientation.quaternions import axis_and_angle, conjugate, multiply, normalized, upright
from dynamics_cli.numerics.orientation.rotations import from_quaternion
from dynamics_cli.numerics.orientation.sequences import angles_in_words, angles_of_quaternion, sequence_of
from dynamics_cli.orient.turns.attitude import Attitude, orientation
from dynamics_cli.orient.turns.eigenvector import largest
from dynamics_cli.quantities import (
    Angle,
    AngleTriple,
    Annotated,
    Count,
    Direction,
    InputFile,
    Positive,
    Quaternion,
    Remark,
    RotationMatrix,
    Text,
)
from dynamics_cli.records import ErrorBound, Numerics, record

UNIT_ROUNDOFF = 2.0**-53
# Orientations whose best two means differ by less have none.
AMBIGUOUS = 1e-9
# Names of the columns of a log, in the order w, x, y, z.
COLUMNS = tuple((f"q{c}", f"q_{c}", c, f"quaternion[{k}]", f"orientation.{c}") for k, c in enumerate("wxyz"))


@record
class Reading:
    """An orientation that was measured, in any notation."""

    turn: Annotated[Attitude, "The rotation, in one of the notations."]
    weight: Annotated[Positive, "Its weight, as 1/variance, e.g. 2."] = 1.0
    name: Annotated[Text | None, "Its name, e.g. camera."] = None


@record
class Readings:
    """Orientations one by one."""

    readings: Annotated[tuple[Reading, ...], "The orientations."]


@record
class Log:
    """Orientations from a file."""

    log: Annotated[InputFile, "CSV with columns qw, qx, qy, qz; rows of zeros are left out, e.g. log.csv."]


@record
class Deviation:
    """One orientation compared with the mean."""

    name: Annotated[Text, "The orientation; of a log its line."]
    deviation: Annotated[Angle, "Angle of the turn from the mean to it [rad]."]


@record
class Average:
    """The mean orientation."""

    quaternion: Annotated[Quaternion, "w, x, y, z of the mean, with w ≥ 0 [-]."]
    euler_angles: Annotated[AngleTriple, "Its angles in the sequence asked for [rad]."]
    rotation_angle: Annotated[Angle, "Angle of its turn [rad]."]
    rotation_axis: Annotated[Direction, "Axis of its turn [-]."]
    rotation_matrix: Annotated[RotationMatrix, "Its matrix [-]."]
    scatter: Annotated[Angle, "Weighted root mean square of the angles from it [rad]."]
    largest_deviation: Annotated[Angle, "The largest of them [rad]."]
    farthest: Annotated[Text, "The orientation that is farthest from it."]
    count: Annotated[Count, "Number of orientations."]
    euler_order: Annotated[Text, "The sequence."]
    angle_names: Annotated[Remark, "The three angles in words, in their order."]
    deviations: Annotated[tuple[Deviation, ...], "Each orientation."]
    numerics: Numerics | None = None


def average(
    *,
    source: Annotated[Readings | Log, "The orientations, one by one or as a log."],
    sequence: Annotated[Text, "Angles to report: zyx, zxz, XYZ …, or rpy, e.g. zyx."] = "zyx",
) -> Average:
    """Mean of orientations, whatever the signs of their quaternions, and the scatter about it.

    Equation
    --------
    Σ wᵢ·(q·qᵢ)² greatest: q is the eigenvector of Σ wᵢ·qᵢqᵢᵀ with the largest eigenvalue, which makes Σ wᵢ·|R − Rᵢ|²
    least.

    Raises
    ------
    InadmissibleError
        When an orientation cannot be read, there is one only, or they are spread so evenly that they have no mean.

    References
    ----------
    Markley, Cheng, Crassidis & Oshman, Averaging quaternions, J. Guid. Control Dyn. 30 (2007) 1193.

    Examples
    --------
    >>> from dynamics_cli.orient.turns.attitude import YawPitchRoll
    >>> pair = tuple(Reading(YawPitchRoll(yaw)) for yaw in (0.1, 0.3))
    >>> round(average(source=Readings(pair)).euler_angles[0], 12)
    0.2
    """
    names, quaternions, weights = _logged(source.log) if isinstance(source, Log) else _read(source.readings)
    require(len(names) >= 2, "one orientation has no mean", code="count", hint="give --reading twice or more, or --log")
    total = sum(weights)
    products = [
        [sum(w * q[i] * q[j] for w, q in zip(weights, quaternions, strict=True)) / total for j in range(4)]
        for i in range(4)
    ]
    _, mean, gap, residual = largest(products)
    require(
        gap > AMBIGUOUS,
        "the orientations are spread so evenly that they have no mean",
        code="undetermined",
        hint="leave out those that are opposite, or give them weights",
    )
    mean = upright(mean)
    back = conjugate(mean)
    off = [axis_and_angle(upright(multiply(back, q)))[1] for q in quaternions]
    axis, angle = axis_and_angle(mean)
    order = sequence_of(sequence)
    farthest = max(range(len(off)), key=lambda nth: off[nth])
    error = (residual + len(names) ** 0.5 * 8.0 * UNIT_ROUNDOFF) / gap
    return Average(
        quaternion=mean,
        euler_angles=angles_of_quaternion(mean, order).angles,
        rotation_angle=angle,
        rotation_axis=axis,
        rotation_matrix=from_quaternion(mean),
        scatter=(sum(w * a * a for w, a in zip(weights, off, strict=True)) / total) ** 0.5,
        largest_deviation=off[farthest],
        farthest=names[farthest],
        count=len(names),
        euler_order=order.text,
        angle_names=angles_in_words(order),
        deviations=tuple(map(Deviation, names, off)),
        numerics=Numerics(
            "Jacobi rotations; bound from the residual of the eigenvector",
            (ErrorBound("quaternion", error, relative=False),),
        ),
    )


def _read(readings: "tuple[Reading, ...]") -> "tuple[list[str], list[Quaternion], list[float]]":
    quaternions = [orientation(reading.turn).quaternion for reading in readings]
    only_in_doubles(*(part for q in quaternions for part in q), *(reading.weight for reading in readings))
    names = [reading.name or f"reading {nth}" for nth, reading in enumerate(readings, 1)]
    return names, quaternions, [reading.weight for reading in readings]


def _logged(file: str) -> "tuple[list[str], list[Quaternion], list[float]]":
    from dynamics_cli.numerics.fitting.records_file import read_named

    lines, rows = read_named(file, COLUMNS)
    # a sensor that drops out writes zeros
    read = [(f"line {line}", normalized((w, x, y, z))) for line, (w, x, y, z) in zip(lines, rows, strict=True)
            if any((w, x, y, z))]  # fmt: skip
    return [name for name, _ in read], [q for _, q in read], [1.0] * len(read)
