"""Velocity and acceleration in polar, cylindrical and spherical coordinates, term by term."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import cos, sin
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.vectors import Vector, add, scale
from dynamics_cli.path.bends import advice_of, along_and_across, bend
from dynamics_cli.quantities import (
    Acceleration,
    AccelerationVector,
    Angle,
    AngularAcceleration,
    AngularSpeed,
    Annotated,
    Distance,
    Length,
    Position,
    Speed,
    Velocity,
)
from dynamics_cli.records import Advice, Check, record

PI = 3.141592653589793
ALONG_AND_ACROSS = ("tangential", "normal", "radius_of_curvature")


@record
class AroundAxis:
    """Motion by its distance from an axis, its angle about it and its height along it."""

    radial_velocity: Annotated[Speed, "v_r = dr/dt [m/s]."]
    transverse_velocity: Annotated[Speed, "v_θ = r·dθ/dt [m/s]."]
    axial_velocity: Annotated[Speed | None, "v_z [m/s]."]
    speed: Annotated[Speed, "Magnitude of the velocity [m/s]."]
    radial_acceleration: Annotated[Acceleration, "a_r = r̈ − rθ̇² [m/s^2]."]
    transverse_acceleration: Annotated[Acceleration, "a_θ = rθ̈ + 2ṙθ̇ [m/s^2]."]
    axial_acceleration: Annotated[Acceleration | None, "a_z [m/s^2]."]
    acceleration: Annotated[Acceleration, "Magnitude of the acceleration [m/s^2]."]
    centripetal: Annotated[Acceleration, "The term rθ̇², towards the axis [m/s^2]."]
    angular_part: Annotated[Acceleration, "The term rθ̈, across [m/s^2]."]
    coriolis: Annotated[Acceleration, "The term 2ṙθ̇, across [m/s^2]."]
    tangential: Annotated[Acceleration | None, "Along the path, a_t [m/s^2]."]
    normal: Annotated[Acceleration | None, "Towards the centre of curvature, a_n [m/s^2]."]
    radius_of_curvature: Annotated[Length | None, "Radius of curvature ρ of the path [m]."]
    position: Annotated[Position, "Cartesian position [m]."]
    cartesian_velocity: Annotated[Velocity, "Cartesian velocity [m/s]."]
    cartesian_acceleration: Annotated[AccelerationVector, "Cartesian acceleration [m/s^2]."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


@record
class FromPole:
    """Motion by its distance from a point and two angles."""

    radial_velocity: Annotated[Speed, "v_ρ = dρ/dt [m/s]."]
    polar_velocity: Annotated[Speed, "v_φ = ρ·dφ/dt [m/s]."]
    azimuth_velocity: Annotated[Speed, "v_θ = ρ·sinφ·dθ/dt [m/s]."]
    speed: Annotated[Speed, "Magnitude of the velocity [m/s]."]
    radial_acceleration: Annotated[Acceleration, "a_ρ = ρ̈ − ρφ̇² − ρθ̇² sin²φ [m/s^2]."]
    polar_acceleration: Annotated[Acceleration, "a_φ = ρφ̈ + 2ρ̇φ̇ − ρθ̇² sinφ cosφ [m/s^2]."]
    azimuth_acceleration: Annotated[Acceleration, "a_θ = (ρθ̈ + 2ρ̇θ̇) sinφ + 2ρφ̇θ̇ cosφ [m/s^2]."]
    acceleration: Annotated[Acceleration, "Magnitude of the acceleration [m/s^2]."]
    tangential: Annotated[Acceleration | None, "Along the path, a_t [m/s^2]."]
    normal: Annotated[Acceleration | None, "Towards the centre of curvature, a_n [m/s^2]."]
    radius_of_curvature: Annotated[Length | None, "Radius of curvature of the path [m]."]
    position: Annotated[Position, "Cartesian position [m]."]
    cartesian_velocity: Annotated[Velocity, "Cartesian velocity [m/s]."]
    cartesian_acceleration: Annotated[AccelerationVector, "Cartesian acceleration [m/s^2]."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def polar(
    *,
    radius: Annotated[Distance, "Distance r from the centre, e.g. 0.3 m."],
    angle: Annotated[Angle, "Angle θ from the x-axis, counter-clockwise, e.g. 30 deg."] = 0.0,
    radial_speed: Annotated[Speed, "Rate ṙ of the distance, e.g. 0.8 m/s."] = 0.0,
    angular_velocity: Annotated[AngularSpeed, "Rate θ̇ of the angle, e.g. 5 rad/s."] = 0.0,
    radial_speed_rate: Annotated[Acceleration, "Second derivative r̈ of the distance, e.g. 0.2 m/s^2."] = 0.0,
    angular_acceleration: Annotated[AngularAcceleration, "Second derivative θ̈ of the angle, e.g. 2 rad/s^2."] = 0.0,
) -> AroundAxis:
    """Velocity and acceleration of a point in polar coordinates, its terms apart.

    Equation
    --------
    v = (ṙ, rθ̇), a = (r̈ − rθ̇², rθ̈ + 2ṙθ̇).

    Raises
    ------
    InadmissibleError
        When a result leaves the range of a double.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 3.8.

    Examples
    --------
    >>> polar(radius=0.3, radial_speed=0.8, angular_velocity=5.0, angular_acceleration=2.0).radial_acceleration
    -7.5
    """
    return _around(
        (radius, angle), (radial_speed, angular_velocity), (radial_speed_rate, angular_acceleration), (None, None, None)
    )


def cylindrical(
    *,
    radius: Annotated[Distance, "Distance r from the axis, e.g. 0.3 m."],
    angle: Annotated[Angle, "Angle θ from the x-axis, counter-clockwise, e.g. 30 deg."] = 0.0,
    height: Annotated[Length, "Height z along the axis, e.g. 1 m."] = 0.0,
    radial_speed: Annotated[Speed, "Rate ṙ of the distance, e.g. 0.8 m/s."] = 0.0,
    angular_velocity: Annotated[AngularSpeed, "Rate θ̇ of the angle, e.g. 5 rad/s."] = 0.0,
    axial_speed: Annotated[Speed, "Rate ż of the height, e.g. 0.4 m/s."] = 0.0,
    radial_speed_rate: Annotated[Acceleration, "Second derivative r̈ of the distance, e.g. 0.2 m/s^2."] = 0.0,
    angular_acceleration: Annotated[AngularAcceleration, "Second derivative θ̈ of the angle, e.g. 2 rad/s^2."] = 0.0,
    axial_speed_rate: Annotated[Acceleration, "Second derivative z̈ of the height, e.g. -9.81 m/s^2."] = 0.0,
) -> AroundAxis:
    """Velocity and acceleration of a point in cylindrical coordinates, its terms apart.

    Equation
    --------
    v = (ṙ, rθ̇, ż), a = (r̈ − rθ̇², rθ̈ + 2ṙθ̇, z̈).

    Raises
    ------
    InadmissibleError
        When a result leaves the range of a double.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 3.8.

    Examples
    --------
    >>> round(cylindrical(radius=3.0, angular_velocity=1.0, axial_speed=4.0).radius_of_curvature, 9)
    8.333333333
    """
    first, second = (radial_speed, angular_velocity), (radial_speed_rate, angular_acceleration)
    return _around((radius, angle), first, second, (height, axial_speed, axial_speed_rate))


def _around(
    place: tuple[float, float],
    rates: tuple[float, float],
    seconds: tuple[float, float],
    axial: "tuple[float | None, float | None, float | None]",
) -> AroundAxis:
    radius, angle = place
    z, vz, az = (0.0 if part is None else part for part in axial)
    across = radius * rates[1]
    centripetal, angular, coriolis = rates[1] * across, radius * seconds[1], 2.0 * (rates[0] * rates[1])
    outward, sideward = seconds[0] - centripetal, angular + coriolis
    cosine, sine = cos(angle), sin(angle)

    def turned(along: float, beside: float, up: float) -> Vector:
        return along * cosine - beside * sine, along * sine + beside * cosine, up

    motion = bend((rates[0], across, vz), (outward, sideward, az))
    flat = axial[0] is None
    return AroundAxis(
        radial_velocity=rates[0],
        transverse_velocity=across,
        axial_velocity=None if flat else vz,
        **along_and_across(motion),
        radial_acceleration=outward,
        transverse_acceleration=sideward,
        axial_acceleration=None if flat else az,
        acceleration=motion.magnitude,
        centripetal=centripetal,
        angular_part=angular,
        coriolis=coriolis,
        position=(radius * cosine, radius * sine, z),
        cartesian_velocity=turned(rates[0], across, vz),
        cartesian_acceleration=turned(outward, sideward, az),
        advice=advice_of(motion, *ALONG_AND_ACROSS),
    )


def spherical(
    *,
    radius: Annotated[Distance, "Distance ρ from the origin, e.g. 2 m."],
    polar_angle: Annotated[Angle, "Angle φ from the Z-axis, 0 to 180 deg, e.g. 50 deg."],
    azimuth: Annotated[Angle, "Angle θ in the X–Y plane from X, e.g. 20 deg."] = 0.0,
    radial_speed: Annotated[Speed, "Rate of the distance, e.g. 0.3 m/s."] = 0.0,
    polar_rate: Annotated[AngularSpeed, "Rate of φ, e.g. 0.4 rad/s."] = 0.0,
    azimuth_rate: Annotated[AngularSpeed, "Rate of θ, e.g. -0.7 rad/s."] = 0.0,
    radial_speed_rate: Annotated[Acceleration, "Second derivative of the distance, e.g. 0.05 m/s^2."] = 0.0,
    polar_second: Annotated[AngularAcceleration, "Second derivative of φ, e.g. -0.2 rad/s^2."] = 0.0,
    azimuth_second: Annotated[AngularAcceleration, "Second derivative of θ, e.g. 0.6 rad/s^2."] = 0.0,
) -> FromPole:
    """Velocity and acceleration of a point in spherical coordinates: φ from the Z-axis, θ the azimuth.

    Equation
    --------
    v = (ρ̇, ρφ̇, ρθ̇ sinφ); a = (ρ̈ − ρφ̇² − ρθ̇² sin²φ, ρφ̈ + 2ρ̇φ̇ − ρθ̇² sinφ cosφ, (ρθ̈ + 2ρ̇θ̇) sinφ + 2ρφ̇θ̇
    cosφ).

    Raises
    ------
    InadmissibleError
        When φ is not within 0 to 180 degrees.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 1.6 and 3.8.

    Examples
    --------
    >>> spherical(radius=2.0, polar_angle=1.0, polar_rate=0.4).polar_velocity
    0.8
    """
    require(
        0.0 <= plain(polar_angle) <= PI,
        "φ is measured from the Z-axis, from 0 to 180 degrees; it cannot be {angle:6}",
        code="polar-angle",
        hint="beyond 180 degrees give 360 degrees less φ, and an azimuth half a turn on",
        angle=(plain(polar_angle), Angle),
    )
    rho, (down, across) = radius, (cos(polar_angle), sin(polar_angle))
    around = rho * across * azimuth_rate
    velocity = (radial_speed, rho * polar_rate, around)
    acceleration = (
        radial_speed_rate - rho * polar_rate * polar_rate - around * azimuth_rate * across,
        rho * polar_second + 2.0 * (radial_speed * polar_rate) - around * azimuth_rate * down,
        (rho * azimuth_second + 2.0 * (radial_speed * azimuth_rate)) * across
        + 2.0 * (rho * polar_rate * azimuth_rate) * down,
    )
    axes = local_axes(down, across, cos(azimuth), sin(azimuth))
    motion = bend(velocity, acceleration)
    return FromPole(
        radial_velocity=velocity[0],
        polar_velocity=velocity[1],
        azimuth_velocity=velocity[2],
        **along_and_across(motion),
        radial_acceleration=acceleration[0],
        polar_acceleration=acceleration[1],
        azimuth_acceleration=acceleration[2],
        acceleration=motion.magnitude,
        position=scale(rho, axes[0]),
        cartesian_velocity=combined(axes, velocity),
        cartesian_acceleration=combined(axes, acceleration),
        advice=advice_of(motion, *ALONG_AND_ACROSS),
    )


def local_axes(down: float, across: float, cosine: float, sine: float) -> tuple[Vector, Vector, Vector]:
    """The unit vectors along ρ, φ and θ, by cosine and sine of φ and of θ."""
    return (
        (across * cosine, across * sine, down),
        (down * cosine, down * sine, -across),
        (-sine, cosine, 0.0 * cosine),
    )


def combined(axes: tuple[Vector, Vector, Vector], parts: Vector) -> Vector:
    """The vector with these parts along those axes."""
    return add(add(scale(parts[0], axes[0]), scale(parts[1], axes[1])), scale(parts[2], axes[2]))
