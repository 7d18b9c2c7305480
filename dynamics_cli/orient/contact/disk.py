"""A thin disk rolling on a level floor."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.numerics.number import decides, plain, single
from dynamics_cli.numerics.orientation.quaternions import opposite
from dynamics_cli.numerics.orientation.rotations import about_axis, product
from dynamics_cli.numerics.turns import turned
from dynamics_cli.numerics.vectors import Vector, add, cross, length
from dynamics_cli.numerics.vectors import times as rotated
from dynamics_cli.quantities import (
    AccelerationVector,
    Angle,
    AngularAcceleration,
    AngularAccelerationVector,
    AngularRate,
    AngularVelocity,
    Annotated,
    Length,
    Size,
    Speed,
    Velocity,
)
from dynamics_cli.records import record
from dynamics_cli.sampling import drawing


@record
class Disk:
    """Motion of a rolling disk; components are along the line of nodes, up the disk, and along its axis."""

    angular_velocity: Annotated[AngularVelocity, "Angular velocity ω [rad/s]."]
    angular_acceleration: Annotated[AngularAccelerationVector, "Angular acceleration α [rad/s^2]."]
    centre_velocity: Annotated[Velocity, "Velocity of the centre [m/s]."]
    centre_speed: Annotated[Speed, "Its magnitude [m/s]."]
    centre_acceleration: Annotated[AccelerationVector, "Acceleration of the centre [m/s^2]."]
    contact_acceleration: Annotated[
        AccelerationVector, "Acceleration of the disk's point at rest on the floor [m/s^2]."
    ]
    rim_velocity: Annotated[Velocity, "Velocity of the rim point asked for [m/s]."]
    rim_acceleration: Annotated[AccelerationVector, "Acceleration of the rim point [m/s^2]."]
    fixed_centre_velocity: Annotated[Velocity, "Velocity of the centre in fixed components, z up [m/s]."]
    fixed_centre_acceleration: Annotated[AccelerationVector, "Acceleration of the centre in fixed components."]
    contact_path_speed: Annotated[Speed, "Speed at which the point of contact runs along the floor [m/s]."]
    centre_path_radius: Annotated[Length | None, "Radius of the centre's circle, at a steady tilt [m]."] = None
    contact_path_radius: Annotated[Length | None, "Radius of the circle on the floor, at a steady tilt [m]."] = None


def disk(
    *,
    radius: Annotated[Size, "Radius of the disk, e.g. 350 mm."],
    tilt: Annotated[Angle, "Angle θ between the disk's axis and the vertical: 90 deg upright, e.g. 60 deg."],
    spin_rate: Annotated[AngularRate, "Rate ψ̇ of turning about its axis, e.g. -6 rad/s."],
    heading_rate: Annotated[AngularRate, "Rate φ̇ of turning about the vertical, e.g. 1.5 rad/s."] = 0.0,
    tilt_rate: Annotated[AngularRate, "Rate θ̇ of the tilt, e.g. 0.4 rad/s."] = 0.0,
    spin_acceleration: Annotated[AngularAcceleration, "Second rate of the spin, e.g. 0.5 rad/s^2."] = 0.0,
    heading_acceleration: Annotated[AngularAcceleration, "Second rate of the heading, e.g. 0.2 rad/s^2."] = 0.0,
    tilt_acceleration: Annotated[AngularAcceleration, "Second rate of the tilt, e.g. -0.3 rad/s^2."] = 0.0,
    heading: Annotated[Angle, "Angle φ of the line of nodes from the fixed x, e.g. 20 deg."] = 0.0,
    rim_angle: Annotated[Angle, "Rim point to report, from the top in the sense of the spin, e.g. 90 deg."] = 0.0,
) -> Disk:
    """Motion of a thin disk that rolls on a level floor without slipping.

    Equation
    --------
    with u = ψ̇ + φ̇·cos θ: ω = (θ̇, φ̇·sin θ, u), v_G = (−r·u, 0, r·θ̇),
    a_G = (−r·(ψ̈ + φ̈·cos θ − 2·φ̇·θ̇·sin θ), −r·φ̇·u·cos θ − r·θ̇², r·θ̈ + r·φ̇·u·sin θ).

    Raises
    ------
    InadmissibleError
        When the radius is zero, or the disk lies flat.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 4.12.

    Examples
    --------
    >>> disk(radius=0.35, tilt=1.5707963267948966, spin_rate=-6.0).centre_velocity
    (2.0999999999999996, 0.0, 0.0)
    """
    c, s = turned(tilt)
    require(radius > 0.0, "a disk of radius 0 does not roll", code="size", hint="give its radius")
    require(
        absolute(s) > 1e-12,
        "at a tilt of {tilt} the disk lies flat on the floor",
        code="flat",
        hint="90 deg is upright",
        tilt=(tilt if single(tilt) else 0.0, Angle),
    )
    u = spin_rate + heading_rate * c
    first = (tilt_rate, heading_rate, spin_rate)
    second = (tilt_acceleration, heading_acceleration, spin_acceleration)
    omega, alpha = _turning(c, s, first, second)
    velocity, acceleration = _centre(radius, c, s, first, second)

    def at(x: float, y: float) -> "tuple[Vector, Vector]":
        """Velocity and acceleration of a point of the disk, from its centre."""
        arm = (x, y, 0.0)
        around = cross(omega, arm)
        return add(velocity, around), add(acceleration, add(cross(alpha, arm), cross(omega, around)))

    _, contact = at(0.0, opposite(radius))
    cosine, sine = turned(rim_angle)
    rim = at(opposite(radius * sine), radius * cosine)
    fixed = product(about_axis(2, heading), about_axis(0, tilt))
    # of samples as of one case; of rows each one is asked
    asked = drawing() or decides(u, *velocity, s)
    steady = asked and not any(map(_somewhere, (tilt_rate, tilt_acceleration, heading_acceleration)))
    circles = steady and _somewhere(heading_rate)
    return Disk(
        angular_velocity=omega,
        angular_acceleration=alpha,
        centre_velocity=velocity,
        centre_speed=length(velocity),
        centre_acceleration=acceleration,
        contact_acceleration=contact,
        rim_velocity=rim[0],
        rim_acceleration=rim[1],
        fixed_centre_velocity=rotated(fixed, velocity),
        fixed_centre_acceleration=rotated(fixed, acceleration),
        contact_path_speed=absolute(radius * spin_rate),
        centre_path_radius=absolute(radius * u / heading_rate) if circles else None,
        contact_path_radius=absolute(radius * spin_rate / heading_rate) if circles else None,
    )


def _somewhere(rate: float) -> bool:
    """Whether a rate is not zero; of samples, whether that of any is not."""
    turns = plain(rate) != 0.0
    return bool(turns if decides(turns) else turns.any())  # type: ignore[attr-defined]


def _turning(c: float, s: float, first: Vector, second: Vector) -> "tuple[Vector, Vector]":
    """Angular velocity and acceleration from rates of tilt, heading and spin."""
    tilt, heading, spin = first
    omega = (tilt, heading * s, spin + heading * c)
    # rates of these components, and the contribution of their rotating axes
    rates = (second[0], second[1] * s + heading * tilt * c, second[2] + second[1] * c - heading * tilt * s)
    return omega, add(rates, cross((tilt, heading * s, heading * c), omega))


def _centre(radius: float, c: float, s: float, first: Vector, second: Vector) -> "tuple[Vector, Vector]":
    """Velocity and acceleration of the centre."""
    tilt, heading, spin = first
    u = spin + heading * c
    velocity = (opposite(radius * u), 0.0 * absolute(u), radius * tilt)
    change = second[2] + second[1] * c - 2.0 * (heading * tilt * s)
    return velocity, (
        opposite(radius * change),
        opposite(radius * (heading * u * c + tilt * tilt)),
        radius * (second[0] + heading * u * s),
    )
