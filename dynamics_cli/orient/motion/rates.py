"""Angular velocity and acceleration from the rates of three angles, and the rates from these."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.orientation.quaternions import multiply, upright
from dynamics_cli.numerics.orientation.rotations import Matrix, about_axis, product, transposed
from dynamics_cli.numerics.orientation.sequences import Sequence, names_of, quaternion_of_angles, sequence_of
from dynamics_cli.numerics.vectors import Vector, add, cross, dot, length, scale
from dynamics_cli.numerics.vectors import times as rotated
from dynamics_cli.quantities import (
    AngleAccelerations,
    AngleRates,
    AngleTriple,
    AngularAcceleration,
    AngularAccelerationVector,
    AngularRate,
    AngularVelocity,
    Annotated,
    Direction,
    Positive,
    Quaternion,
    Remark,
    RotationMatrix,
    Text,
)
from dynamics_cli.records import Advice, record

NOTHING = (0.0, 0.0, 0.0)
# Rates this many times the angular velocity deserve a remark.
SENSITIVE = 50.0
# The determinant below this is lock: the cosine of the double nearest to 90° is 6e-17.
LOCK = 1e-15


@record
class ByRates:
    """Rates of the angles."""

    angle_rates: Annotated[AngleRates, "Rates of the three angles, in their order, e.g. 0.1, 0.2, 0.3 rad/s."]
    angle_accelerations: Annotated[AngleAccelerations, "Their second rates, e.g. 0.4, -0.5, 0.6 rad/s^2."] = NOTHING


@record
class ByFixed:
    """Angular velocity in fixed components."""

    angular_velocity: Annotated[AngularVelocity, "Angular velocity in fixed components, e.g. 0.1, 0.3, 0 rad/s."]
    angular_acceleration: Annotated[AngularAccelerationVector, "Its rate α, e.g. 0, 0, 5 rad/s^2."] = NOTHING


@record
class ByBody:
    """Angular velocity in body components, as gyroscopes on the body measure it."""

    body_angular_velocity: Annotated[AngularVelocity, "Angular velocity as gyroscopes read it, e.g. 0.1, 0.3, 0 rad/s."]
    body_angular_acceleration: Annotated[AngularAccelerationVector, "Its rate α, e.g. 0, 0, 5 rad/s^2."] = NOTHING


@record
class Rates:
    """Angular velocity and acceleration with the rates of the angles."""

    angular_velocity: Annotated[AngularVelocity, "Angular velocity ω in fixed components [rad/s]."]
    body_angular_velocity: Annotated[AngularVelocity, "The same in body components [rad/s]."]
    angular_speed: Annotated[AngularRate, "Its magnitude [rad/s]."]
    angular_acceleration: Annotated[AngularAccelerationVector, "Angular acceleration α in fixed components [rad/s^2]."]
    body_angular_acceleration: Annotated[AngularAccelerationVector, "The same in body components [rad/s^2]."]
    angular_acceleration_size: Annotated[AngularAcceleration, "Its magnitude [rad/s^2]."]
    angle_rates: Annotated[AngleRates, "Rates of the three angles, in their order [rad/s]."]
    angle_accelerations: Annotated[AngleAccelerations, "Second rates of the three angles [rad/s^2]."]
    quaternion_rate: Annotated[Quaternion, "Rate of the quaternion w, x, y, z [1/s]."]
    rotation_matrix: Annotated[RotationMatrix, "Takes body components to fixed ones [-]."]
    first_partial: Annotated[Direction, "Partial angular velocity of the first angle: the axis it turns about [-]."]
    second_partial: Annotated[Direction, "That of the second angle [-]."]
    third_partial: Annotated[Direction, "That of the third angle [-]."]
    names: Annotated[Remark, "Other names of these angles."]
    condition: Annotated[Positive | None, "How many times ω the rates of the angles may be; none at lock [-]."]
    advice: tuple[Advice, ...] = ()


def rates(
    *,
    euler_angles: Annotated[AngleTriple, "The three angles, in the order of the axes, e.g. 30, 20, -40 deg."],
    euler_order: Annotated[
        Text, "zyx, zxz … about the body's turned axes, XYZ … about the fixed ones, or rpy, bryan, euler, e.g. zyx."
    ] = "zyx",
    motion: Annotated[ByRates | ByFixed | ByBody, "Rates of the angles, or the angular velocity."],
) -> Rates:
    """Angular velocity and acceleration from rates of three angles, or the rates from angular velocity.

    Equation
    --------
    ω = ȧu₁ + ḃu₂ + ċu₃ with the axes u₁ = eᵢ, u₂ = R₁eⱼ, u₃ = R₁R₂eₖ;
    α = äu₁ + b̈u₂ + c̈u₃ + ȧu₁×ḃu₂ + (ȧu₁ + ḃu₂)×ċu₃.

    Raises
    ------
    InadmissibleError
        When the sequence is unknown, or rates are wanted at gimbal lock.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 4.5 and 4.8.

    Examples
    --------
    >>> answer = rates(euler_angles=(0.0, 0.5, 0.0), euler_order="zxz", motion=ByRates(angle_rates=(3.0, 0.0, 50.0)))
    >>> round(answer.angular_acceleration_size, 6)
    71.913831
    """
    sequence = sequence_of(euler_order)
    back = sequence.fixed
    axes, matrix = _axes(sequence, euler_angles[::-1] if back else euler_angles)
    if isinstance(motion, ByRates):
        first, second = motion.angle_rates, motion.angle_accelerations
        omega, alpha = _forward(axes, first[::-1] if back else first, second[::-1] if back else second)
    else:
        if isinstance(motion, ByBody):
            omega = rotated(matrix, motion.body_angular_velocity)
            alpha = rotated(matrix, motion.body_angular_acceleration)
        else:
            omega, alpha = motion.angular_velocity, motion.angular_acceleration
        solved, second_solved = _backward(axes, omega, alpha)
        first, second = (solved[::-1], second_solved[::-1]) if back else (solved, second_solved)
    ordered = axes[::-1] if back else axes
    inverse = transposed(matrix)
    volume = abs(dot(axes[0], cross(axes[1], axes[2])))
    q = quaternion_of_angles(euler_angles, sequence)
    rate = multiply((0.0, *omega), upright(q))
    return Rates(
        angular_velocity=omega,
        body_angular_velocity=rotated(inverse, omega),
        angular_speed=length(omega),
        angular_acceleration=alpha,
        body_angular_acceleration=rotated(inverse, alpha),
        angular_acceleration_size=length(alpha),
        angle_rates=first,
        angle_accelerations=second,
        quaternion_rate=(0.5 * rate[0], 0.5 * rate[1], 0.5 * rate[2], 0.5 * rate[3]),
        rotation_matrix=matrix,
        first_partial=ordered[0],
        second_partial=ordered[1],
        third_partial=ordered[2],
        names=names_of(sequence),
        condition=None if single(volume) and volume <= LOCK else 1.0 / volume,
        advice=_advice(volume) if single(volume) else (),
    )


def _axes(sequence: Sequence, angles: Vector) -> "tuple[Matrix, Matrix]":
    """The axes that the three angles turn about, as rows, and the whole rotation."""
    i, j, k = sequence.axes
    first = about_axis(i, angles[0])
    first_two = product(first, about_axis(j, angles[1]))
    matrix = product(first_two, about_axis(k, angles[2]))
    unit = tuple(1.0 if axis == i else 0.0 for axis in range(3))
    second, third = (tuple(row[j] for row in first), tuple(row[k] for row in first_two))
    return (unit, second, third), matrix  # type: ignore[return-value]


def _gyroscopic(axes: Matrix, first: Vector) -> Vector:
    """Contribution of the rotating axes to the angular acceleration."""
    a, b, c = (scale(rate, axis) for rate, axis in zip(first, axes, strict=True))
    return add(cross(a, b), cross(add(a, b), c))


def _forward(axes: Matrix, first: Vector, second: Vector) -> "tuple[Vector, Vector]":
    parts = [scale(rate, axis) for rate, axis in zip(first, axes, strict=True)]
    more = [scale(rate, axis) for rate, axis in zip(second, axes, strict=True)]
    omega = add(add(parts[0], parts[1]), parts[2])
    return omega, add(add(add(more[0], more[1]), more[2]), _gyroscopic(axes, first))


def _backward(axes: Matrix, omega: Vector, alpha: Vector) -> "tuple[Vector, Vector]":
    """Rates of the angles; refuses lock, where no rates give one component of the angular velocity."""
    across = cross(axes[1], axes[2])
    volume = dot(axes[0], across)
    free = cross(axes[0], axes[1])
    require(
        abs(volume) > LOCK,
        "gimbal lock: first and third axis are parallel, and no rates of the angles give the angular velocity about "
        "the direction ({x:3}, {y:3}, {z:3})",
        code="lock",
        hint="choose another sequence, or work with the quaternion",
        x=(free[0] if single(free[0]) else 0.0, Direction),
        y=(free[1] if single(free[1]) else 0.0, Direction),
        z=(free[2] if single(free[2]) else 0.0, Direction),
    )

    def solve(right: Vector) -> Vector:
        return dot(right, across) / volume, dot(right, axes[1]), dot(right, free) / volume

    first = solve(omega)
    drift = _gyroscopic(axes, first)
    return first, solve((alpha[0] - drift[0], alpha[1] - drift[1], alpha[2] - drift[2]))


def _advice(volume: float) -> tuple[Advice, ...]:
    size = plain(volume)
    if size > 1.0 / SENSITIVE:
        return ()
    if size <= LOCK:
        return (
            Advice(
                "lock",
                "gimbal lock: first and third angle turn about one axis",
                remedy="choose another sequence, or work with the quaternion",
                result="condition",
            ),
        )
    return (
        Advice(
            "near-lock",
            worded(
                "near gimbal lock: rates of first and third angle are up to {times:3} times the angular velocity",
                times=(1.0 / size, Positive),
            ),
            remedy="choose another sequence, or work with the quaternion",
        ),
    )
