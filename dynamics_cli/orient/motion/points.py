"""Points of a rigid body: their velocities and accelerations, or the body's motion from theirs."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import maximum, sqrt, total, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.vectors import Vector, add, cross, dot, length, scale, subtract
from dynamics_cli.quantities import (
    AccelerationVector,
    AngularAccelerationVector,
    AngularRate,
    AngularVelocity,
    Annotated,
    Direction,
    Length,
    Position,
    Speed,
    Text,
    Velocity,
)
from dynamics_cli.records import Advice, record

NOTHING = (0.0, 0.0, 0.0)
# Points whose spread across their line is this share of that along it do not determine the turning about the line.
COLLINEAR = 1e-9
# A departure from rigidity above this share of the velocities is worth a remark.
RIGID = 1e-6
# A misfit below this share of the fastest velocity is rounding.
EXACT = 1e-14


@record
class BodyPoint:
    """A point of the body; with its velocity where that was measured."""

    position: Annotated[Position, "Where it is, e.g. 1, 2, 0 m."]
    velocity: Annotated[Velocity | None, "Its velocity, to find the body's motion from, e.g. 3, 0, 1 m/s."] = None
    name: Annotated[Text | None, "Its name, e.g. P."] = None


@record
class PointMotion:
    """Motion of one point."""

    name: Annotated[Text, "The point."]
    position: Annotated[Position, "Where it is [m]."]
    velocity: Annotated[Velocity, "Its velocity [m/s]."]
    speed: Annotated[Speed, "Its magnitude [m/s]."]
    acceleration: Annotated[AccelerationVector | None, "Its acceleration, where the body's motion is given [m/s^2]."]
    misfit: Annotated[Speed, "How far a measured velocity is from the rigid body's [m/s]."]


@record
class Points:
    """Motion of a body and of its points."""

    angular_velocity: Annotated[AngularVelocity, "Angular velocity of the body [rad/s]."]
    angular_speed: Annotated[AngularRate, "Its magnitude [rad/s]."]
    axis: Annotated[Direction | None, "Direction of the instantaneous screw axis; without turning none [-]."]
    axis_point: Annotated[Position | None, "Its point nearest to the origin [m]."]
    slide: Annotated[Speed, "Speed along the axis [m/s]."]
    pitch: Annotated[Length | None, "Travel along the axis per radian, ω·v/ω² [m]."]
    misfit: Annotated[Speed | None, "Departure from rigidity: root mean square of the velocities' misfit [m/s]."]
    points: Annotated[tuple[PointMotion, ...], "Each point."]
    advice: tuple[Advice, ...] = ()


def points(
    *,
    angular_velocity: Annotated[AngularVelocity | None, "Angular velocity, where known, e.g. 0, 0, 2 rad/s."] = None,
    angular_acceleration: Annotated[AngularAccelerationVector, "Its rate α, e.g. 0, 0, 5 rad/s^2."] = (NOTHING),
    base: Annotated[Position, "The point whose motion is known; the origin unless given."] = NOTHING,
    base_velocity: Annotated[Velocity, "Its velocity, e.g. 3, 0, 1 m/s."] = NOTHING,
    base_acceleration: Annotated[AccelerationVector, "Its acceleration, e.g. 0, 0, 3 m/s^2."] = NOTHING,
    points: Annotated[BodyPoint | tuple[BodyPoint, ...], "Points of the body."],
) -> Points:
    """Velocities and accelerations of points of a rigid body, or the body's motion from velocities of three or more.

    Where the angular velocity is given and the velocity of one point, that point is the base.

    Equation
    --------
    v_Q = v_P + ω × r, a_Q = a_P + α × r + ω × (ω × r); from n points (tr S·1 − S)·ω = Σ d × u with S = Σ d dᵀ of
    positions d and velocities u from their means; screw axis at P + ω × v_P/ω².

    Raises
    ------
    InadmissibleError
        When neither the body's motion nor velocities of three points are given, or these lie on one line.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 4.9.

    Examples
    --------
    >>> answer = points(angular_velocity=(0.0, 0.0, 2.0), points=BodyPoint(position=(1.0, 0.0, 0.0)))
    >>> answer.points[0].velocity, answer.points[0].acceleration
    ((0.0, 2.0, 0.0), (-4.0, 0.0, 0.0))
    """
    each = points if isinstance(points, tuple) else (points,)
    measured = angular_velocity is None
    velocity, alpha, omega = base_velocity, angular_acceleration, angular_velocity
    if omega is None:
        base, velocity, omega = _from_velocities(each)
    elif len(moving := [point for point in each if point.velocity is not None]) == 1 and not any(
        not single(part) or plain(part) for part in (*base, *base_velocity)
    ):
        # no base is given, which is the origin at rest: the one point with a velocity is the base that was meant
        base, velocity = moving[0].position, moving[0].velocity or velocity
    moved, total = [], 0.0
    for nth, point in enumerate(each, 1):
        r = subtract(point.position, base)
        turning = cross(omega, r)
        v = add(velocity, turning)
        a = None if measured else add(base_acceleration, add(cross(alpha, r), cross(omega, turning)))
        off = length(subtract(point.velocity, v)) if point.velocity is not None else 0.0
        total = total + off * off
        moved.append(PointMotion(point.name or f"P{nth}", point.position, v, length(v), a, off))
    spin = length(omega)
    turns = not single(spin) or plain(spin) > 0.0
    axis = (omega[0] / spin, omega[1] / spin, omega[2] / spin) if turns else None
    velocities_given = all(point.velocity is not None for point in each)
    foot = _axis_point(base, velocity, axis, spin) if axis is not None else None
    root = sqrt(total / len(each))
    fastest = moved[0].speed
    for other in moved[1:]:
        fastest = maximum(fastest, other.speed)
    root = where(root <= EXACT * fastest, 0.0 * fastest, root)
    return Points(
        angular_velocity=omega,
        angular_speed=spin,
        axis=axis,
        axis_point=foot,
        slide=dot(axis, velocity) if axis is not None else length(velocity),
        pitch=dot(axis, velocity) / spin if axis is not None else None,
        misfit=root if velocities_given else None,
        points=tuple(moved),
        advice=_advice(turns, root if velocities_given else 0.0, moved) if single(spin) else (),
    )


def _from_velocities(points: "tuple[BodyPoint, ...]") -> "tuple[Vector, Vector, Vector]":
    """Mean position and velocity, and the angular velocity that fits all velocities best."""
    velocities = [point.velocity for point in points if point.velocity is not None]
    require(
        len(velocities) == len(points) and len(points) >= 3,
        "the body's motion is not given, and the velocities given ({count}) do not determine it",
        code="missing",
        hint="give --angular-velocity, or velocities of 3 or more points that are not on one line; of two points of a "
        "plane motion: dynamics linkage body",
        count=len(velocities),
    )
    weight = 1.0 / len(points)
    base = scale(weight, _total([point.position for point in points]))
    velocity = scale(weight, _total(velocities))
    arms = [subtract(point.position, base) for point in points]
    differences = [subtract(measured, velocity) for measured in velocities]
    second = [[total(d[i] * d[j] for d in arms) for j in range(3)] for i in range(3)]
    trace = second[0][0] + second[1][1] + second[2][2]
    right = _total([cross(d, u) for d, u in zip(arms, differences, strict=True)])
    # the cofactors of tr(S)·1 − S give its inverse; it is singular when all points lie on a line
    m = [[(trace if i == j else 0.0) - second[i][j] for j in range(3)] for i in range(3)]
    cofactors = [cross(_row(m, 1), _row(m, 2)), cross(_row(m, 2), _row(m, 0)), cross(_row(m, 0), _row(m, 1))]
    determinant = dot(_row(m, 0), cofactors[0])
    longest = max(arms, key=lambda d: plain(length(d)) if single(*d) else 0.0)
    size = length(longest)
    sized = single(size) and plain(size) > 0.0
    line = [part / size if sized else 0.0 for part in longest]
    require(
        determinant > COLLINEAR * trace * trace * trace,
        "the points lie on one line: they do not determine the rotation about its direction ({x:3}, {y:3}, {z:3})",
        code="collinear",
        hint="give a point off that line",
        x=(line[0], Direction),
        y=(line[1], Direction),
        z=(line[2], Direction),
    )
    omega = tuple(dot((cofactors[0][i], cofactors[1][i], cofactors[2][i]), right) / determinant for i in range(3))
    return base, velocity, omega  # type: ignore[return-value]


def _row(m: "list[list[float]]", i: int) -> Vector:
    return m[i][0], m[i][1], m[i][2]


def _total(vectors: "list[Vector]") -> Vector:
    total = vectors[0]
    for other in vectors[1:]:
        total = add(total, other)
    return total


def _axis_point(base: Vector, velocity: Vector, axis: Vector, spin: float) -> Vector:
    """The point of the screw axis nearest to the origin: base + ω × v/ω², without squares that vanish."""
    beside = add(base, scale(1.0 / spin, cross(axis, velocity)))
    return subtract(beside, scale(dot(beside, axis), axis))


def _advice(turns: bool, misfit: float, moved: "list[PointMotion]") -> tuple[Advice, ...]:
    advice = []
    if not turns:
        advice.append(Advice("translation", "the body does not turn: it has no axis", severity="note", result="axis"))
    fastest = max(plain(point.speed) for point in moved)
    if plain(misfit) > RIGID * fastest > 0.0:
        message = worded(
            "the velocities are not those of one rigid body: they depart from it by {misfit}", misfit=(misfit, Speed)
        )
        advice.append(Advice("not-rigid", message, remedy="check the point with the largest misfit"))
    return tuple(advice)
