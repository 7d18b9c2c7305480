"""The turn from one orientation to another, and orientations on the way."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.orientation.quaternions import (
    axis_and_angle,
    axis_angle_and_vector,
    conjugate,
    multiply,
    of_axis_angle,
    unit,
    upright,
)
from dynamics_cli.numerics.orientation.rotations import from_quaternion, product
from dynamics_cli.numerics.orientation.sequences import angles_of_quaternion, sequence_of
from dynamics_cli.numerics.vectors import Vector
from dynamics_cli.numerics.vectors import times as rotated
from dynamics_cli.orient.turns.attitude import Attitude, orientation, part_about
from dynamics_cli.orient.turns.convert import TOLERANCE, distance_of
from dynamics_cli.quantities import (
    Angle,
    AngleTriple,
    AngularVelocity,
    Annotated,
    Count,
    Direction,
    Fraction,
    Quaternion,
    Text,
    Time,
)
from dynamics_cli.quantities import RotationMatrix as RotationMatrixKind
from dynamics_cli.records import Advice, Check, record

MOST_STEPS = 1000


@record
class Oriented:
    """An orientation, in any notation."""

    turn: Annotated[Attitude, "The rotation, in one of the notations."]


@record
class Step:
    """An orientation on the way, at a constant rate about a constant axis."""

    share: Annotated[Fraction, "Share of the way [-]."]
    quaternion: Annotated[Quaternion, "Its quaternion [-]."]
    euler_angles: Annotated[AngleTriple, "Its angles in the sequence asked for [rad]."]


@record
class Between:
    """The turn from one orientation to another."""

    rotation_angle: Annotated[Angle, "Angle of the turn, from 0 to 180° [rad]."]
    rotation_axis: Annotated[Direction, "Its axis in fixed components [-]."]
    body_axis: Annotated[Direction, "Its axis by components in either body, which are the same [-]."]
    quaternion: Annotated[Quaternion, "The turn in axes of the first orientation: q₁⁻¹·q₂ [-]."]
    rotation_matrix: Annotated[RotationMatrixKind, "R₁ᵀ·R₂ [-]."]
    angular_velocity: Annotated[
        AngularVelocity | None, "Mean angular velocity over the time given, in fixed components [rad/s]."
    ] = None
    body_angular_velocity: Annotated[
        AngularVelocity | None, "The same in components of either body, as gyroscopes read it [rad/s]."
    ] = None
    part_about: Annotated[Angle | None, "The part of it about the axis given [rad]."] = None
    rest: Annotated[Angle | None, "What the rest tilts that axis by [rad]."] = None
    steps: Annotated[tuple[Step, ...] | None, "Orientations in between, if requested."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def between(
    *,
    first: Annotated[Oriented, "The orientation before."],
    second: Annotated[Oriented, "The orientation after."],
    about: Annotated[Direction | None, "An axis of the first body: the part about it, e.g. 0, 0, 1."] = None,
    time: Annotated[Time | None, "Time from the first to the second: the mean angular velocity, e.g. 10 ms."] = None,
    count: Annotated[Count, "Number of orientations in between, e.g. 5."] = 0,
    sequence: Annotated[Text, "Angles to report in between: zyx, zxz, XYZ …, or rpy, e.g. zyx."] = "zyx",
) -> Between:
    """Turn from one orientation to another: its angle and axis, its part about an axis, orientations on the way.

    Equation
    --------
    q = q₁⁻¹·q₂ with the sign of the shorter way; part about n: 2·atan2(v·n, w); mean ω = θ·n/t; on the
    way q₁·(cos ½sθ, n sin ½sθ).

    Raises
    ------
    InadmissibleError
        When an orientation or the axis cannot be read, or more than 1000 steps are wanted.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 4.2.

    Examples
    --------
    >>> from dynamics_cli.numerics.orientation.rotations import ByQuaternion
    >>> row = Oriented(turn=ByQuaternion(quaternion=(1.0, 0.0, 0.0, 0.0)))
    >>> two = Oriented(turn=ByQuaternion(quaternion=(1.0, 1.0, 1.0, 1.0)))
    >>> round(between(first=row, second=two).rotation_angle, 9)
    2.094395102
    """
    order = sequence_of(sequence)
    require(count <= MOST_STEPS, "{count} orientations in between are more than {most}", count=count, most=MOST_STEPS)
    start, end = orientation(first.turn), orientation(second.turn)
    q = upright(multiply(conjugate(start.quaternion), end.quaternion))
    axis, angle, vector = axis_angle_and_vector(q)
    spin = None if time is None else _mean_velocity(vector, time)
    part = rest = None
    if about is not None:
        n = unit(about)
        part = part_about(q, n)
        twist = of_axis_angle(n, part)
        rest = axis_and_angle(upright(multiply(q, conjugate(twist))))[1]
    steps = []
    for nth in range(1, count + 1):
        fraction = nth / (count + 1)
        passed = upright(multiply(start.quaternion, of_axis_angle(axis, fraction * angle)))
        steps.append(Step(fraction, passed, angles_of_quaternion(passed, order).angles))
    alone = single(*q)
    return Between(
        rotation_angle=angle,
        rotation_axis=rotated(start.matrix, axis),
        body_axis=axis,
        quaternion=q,
        rotation_matrix=from_quaternion(q),
        angular_velocity=spin and rotated(start.matrix, spin),
        body_angular_velocity=spin,
        part_about=part,
        rest=rest,
        steps=tuple(steps) if alone and count else None,
        checks=_checks(start.matrix, q, end.matrix) if alone else (),
        advice=_advice(q) if alone else (),
    )


def _mean_velocity(vector: Vector, time: float) -> Vector:
    """The constant angular velocity that turns by a rotation vector in a time."""
    require(time > 0.0, "the time from the first to the second orientation is {time}, not above zero",
            time=(time, Time), code="time", hint="exchange the two orientations")  # fmt: skip
    return vector[0] / time, vector[1] / time, vector[2] / time


def _checks(start: "tuple[tuple[float, ...], ...]", q: Quaternion, end: object) -> tuple[Check, ...]:
    doubles = from_quaternion(tuple(map(plain, q)))  # type: ignore[arg-type]
    off = distance_of(product(start, doubles), end)  # type: ignore[arg-type]
    return (Check("the rotation takes the first to the second", off <= TOLERANCE, off, TOLERANCE),)


def _advice(q: Quaternion) -> tuple[Advice, ...]:
    if plain(q[0]) == 0.0:
        message = "half a turn apart: both directions of rotation are equally long, and one of the two is shown"
        return (Advice("half-turn", message, severity="note"),)
    if not any(map(plain, q[1:])):
        return (Advice("no-turn", "both orientations are the same: the axis shown is arbitrary", severity="note"),)
    return ()
