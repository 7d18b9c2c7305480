"""Two bodies in contact: rates at which they roll on each other, slip, spin and roll."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.orientation.quaternions import unit
from dynamics_cli.numerics.vectors import Vector, add, cross, dot, length, scale, subtract
from dynamics_cli.quantities import (
    AngularAccelerationVector,
    AngularRate,
    AngularVelocity,
    Annotated,
    Direction,
    Position,
    Speed,
    Velocity,
)
from dynamics_cli.records import Advice, record

NOTHING = (0.0, 0.0, 0.0)
# A slip below this share of the speeds at the contact is rounding.
TOLERANCE = 1e-12
# Directions of slip whose squared sine is below this are the same.
PARALLEL = 1e-20


@record
class Roller:
    """A body: the known part of its motion, and the axis of the unknown rate."""

    angular_velocity: Annotated[AngularVelocity, "Known part of its angular velocity, e.g. 0, 0, 2 rad/s."] = NOTHING
    axis: Annotated[Direction | None, "Axis of its unknown rate; the known part carries it, e.g. 1, 0, 0."] = None
    point: Annotated[Position, "A point of it (on that axis) of known velocity; else the origin."] = NOTHING
    velocity: Annotated[Velocity, "Velocity of that point, e.g. 3, 0, 0 m/s."] = NOTHING


GROUND = Roller()


@record
class RollerMotion:
    """Motion of one of the bodies."""

    rate: Annotated[AngularRate | None, "The rate that was unknown [rad/s]."]
    angular_velocity: Annotated[AngularVelocity, "Angular velocity [rad/s]."]
    angular_speed: Annotated[AngularRate, "Its magnitude [rad/s]."]
    angular_acceleration: Annotated[AngularAccelerationVector, "At constant rates: known part × the rest [rad/s^2]."]
    contact_velocity: Annotated[Velocity, "Velocity of its point of contact [m/s]."]


@record
class Rolling:
    """How two bodies move on each other."""

    first: Annotated[RollerMotion, "Motion of the first body."]
    second: Annotated[RollerMotion, "Motion of the second body."]
    slip: Annotated[Velocity, "Velocity of the first body's point of contact over the second's [m/s]."]
    slip_speed: Annotated[Speed, "Its magnitude along the surfaces: zero when they roll [m/s]."]
    closing_speed: Annotated[Speed, "Its part along the normal: not zero when they separate or press in [m/s]."]
    spin: Annotated[AngularRate, "Relative angular velocity about the normal [rad/s]."]
    roll: Annotated[AngularVelocity, "Relative angular velocity along the surfaces [rad/s]."]
    roll_speed: Annotated[AngularRate, "Its magnitude [rad/s]."]
    advice: tuple[Advice, ...] = ()


def rolling(
    *,
    contact: Annotated[Position, "The point of contact, e.g. 0.2, 0, 0 m."],
    normal: Annotated[Direction, "Normal of the surfaces there, of any length, e.g. 0, 0, 1."],
    first: Annotated[Roller, "The first body."],
    second: Annotated[Roller, "The second body; at rest if left out."] = GROUND,
) -> Rolling:
    """Rates at which two bodies roll on each other, or their slip; spin and roll parts of the relative motion.

    Equation
    --------
    v₁ + ω₁ × r₁ = v₂ + ω₂ × r₂ along the surfaces, ωᵢ = known part + rateᵢ·nᵢ; for one rate by least squares.

    Raises
    ------
    InadmissibleError
        When the normal or an axis is zero, an axis passes through the contact, or both rates do the same there.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 4.11.

    Examples
    --------
    >>> wheel = Roller(axis=(0.0, 1.0, 0.0), point=(0.0, 0.0, 0.3), velocity=(6.0, 0.0, 0.0))
    >>> round(rolling(contact=(0.0, 0.0, 0.0), normal=(0.0, 0.0, 1.0), first=wheel).first.rate, 9)
    20.0
    """
    n = unit(normal, "the normal is the zero vector")
    arms = [subtract(contact, body.point) for body in (first, second)]
    surface_velocities = [
        add(body.velocity, cross(body.angular_velocity, arm)) for body, arm in zip((first, second), arms, strict=True)
    ]
    off = _along(subtract(surface_velocities[0], surface_velocities[1]), n)
    axes = [None if body.axis is None else unit(body.axis, "an axis is the zero vector") for body in (first, second)]
    slips = [
        None if axis is None else _along(scale(sign, cross(axis, arm)), n)
        for axis, arm, sign in zip(axes, arms, (1.0, -1.0), strict=True)
    ]
    moves = [
        _moved(body, axis, arm, rate)
        for body, axis, arm, rate in zip((first, second), axes, arms, _rates(off, slips[0], slips[1]), strict=True)
    ]
    over = subtract(moves[0].contact_velocity, moves[1].contact_velocity)
    relative = subtract(moves[0].angular_velocity, moves[1].angular_velocity)
    slip = length(_along(over, n))
    closing = dot(over, n)
    spin = dot(relative, n)
    roll = _along(relative, n)
    unknowns = any(axis is not None for axis in axes)
    alone = single(slip, closing)
    size = sum(plain(length(v)) for v in (*surface_velocities, *(m.contact_velocity for m in moves))) if alone else 0.0
    return Rolling(
        first=moves[0],
        second=moves[1],
        slip=over,
        slip_speed=slip,
        closing_speed=closing,
        spin=spin,
        roll=roll,
        roll_speed=length(roll),
        advice=_advice(slip, closing, size, unknowns) if alone else (),
    )


def _along(v: Vector, n: Vector) -> Vector:
    """The part of a vector along the surfaces."""
    return cross(n, cross(v, n))


def _rates(off: Vector, first_arm: "Vector | None", second_arm: "Vector | None") -> "tuple[float | None, float | None]":
    """Rates that leave the least slip: the normal equations of one or two of them."""
    a = dot(first_arm, first_arm) if first_arm is not None else 0.0
    b = dot(second_arm, second_arm) if second_arm is not None else 0.0
    for arm, square in ((first_arm, a), (second_arm, b)):
        require(
            arm is None or square > 0.0,
            "an axis passes through the contact, or rotation about it moves the contact along the normal: its rate is "
            "not determined",
            code="axis",
            hint="give another axis, or leave it out",
        )
    if first_arm is None or second_arm is None:
        return (
            None if first_arm is None else 0.0 - dot(off, first_arm) / a,
            None if second_arm is None else 0.0 - dot(off, second_arm) / b,
        )
    between = cross(first_arm, second_arm)
    square = dot(between, between)
    require(
        square > PARALLEL * a * b,
        "both rates move the contact along one line, so that only their ratio would be determined",
        code="undetermined",
        hint="give one of the rates as a part of --first-angular-velocity or --second-angular-velocity",
    )
    return 0.0 - dot(cross(off, second_arm), between) / square, 0.0 - dot(cross(first_arm, off), between) / square


def _moved(body: Roller, axis: "Vector | None", arm: Vector, rate: "float | None") -> RollerMotion:
    omega = body.angular_velocity
    alpha: Vector = NOTHING
    if axis is not None and rate is not None:
        sought = scale(rate, axis)
        alpha = cross(omega, sought)
        omega = add(omega, sought)
    return RollerMotion(rate, omega, length(omega), alpha, add(body.velocity, cross(omega, arm)))


def _advice(slip: float, closing: float, size: float, unknowns: bool) -> tuple[Advice, ...]:
    advice = []
    if unknowns and plain(slip) > TOLERANCE * size:
        message = worded("no rate makes the bodies roll: at the best one {slip} of slip remains", slip=(slip, Speed))
        advice.append(Advice("slips", message, severity="serious", remedy="check the axis, or free a second rate"))
    if abs(plain(closing)) > TOLERANCE * size:
        message = worded(
            "the bodies do not stay in contact: they move along the normal at {closing}", closing=(closing, Speed)
        )
        advice.append(Advice("no-contact", message, remedy="check the normal and the points"))
    return tuple(advice)
