"""Motion on a circle: speed and acceleration, and after a time or an angle of constant angular acceleration."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import atan2, hypot, maximum, multiply_add, pi_beside, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    AngularAcceleration,
    Annotated,
    Distance,
    Length,
    Ratio,
    ShaftSpeed,
    Speed,
    Time,
)
from dynamics_cli.records import record


@record
class Turning:
    """Angular velocity and acceleration."""

    angular_velocity: Annotated[ShaftSpeed, "Angular velocity ω, counter-clockwise positive, e.g. 1500 rpm."]
    angular_acceleration: Annotated[AngularAcceleration, "Angular acceleration α, e.g. 3 rad/s^2."] = 0.0


@record
class Running:
    """Speed along the circle and its rate."""

    speed: Annotated[Speed, "Speed along the circle, counter-clockwise positive, e.g. 12 m/s."]
    speed_rate: Annotated[Acceleration, "Rate of change of the speed, e.g. 2 m/s^2."] = 0.0


@record
class OnCircle:
    """Speed and acceleration at one place on the circle."""

    speed: Annotated[Speed, "Speed along the circle [m/s]."]
    angular_velocity: Annotated[ShaftSpeed, "Angular velocity [rad/s]."]
    tangential: Annotated[Acceleration, "Tangential acceleration a_t [m/s^2]."]
    normal: Annotated[Acceleration, "Normal acceleration a_n, towards the centre [m/s^2]."]
    acceleration: Annotated[Acceleration, "Magnitude of the acceleration [m/s^2]."]
    inclination: Annotated[Angle, "Angle of the acceleration from the inward radius, forwards positive [rad]."]


@record
class Circle:
    """Motion on a circle at the start, and at the end of a time or an angle."""

    speed: Annotated[Speed, "Speed along the circle, at the end if a time, an angle or an arc is given [m/s]."]
    angular_velocity: Annotated[ShaftSpeed, "Angular velocity there [rad/s]."]
    angular_acceleration: Annotated[AngularAcceleration, "Angular acceleration, constant [rad/s^2]."]
    tangential: Annotated[Acceleration, "Tangential acceleration a_t [m/s^2]."]
    normal: Annotated[Acceleration, "Normal acceleration a_n, towards the centre [m/s^2]."]
    acceleration: Annotated[Acceleration, "Magnitude of the acceleration there [m/s^2]."]
    inclination: Annotated[Angle, "Angle of the acceleration from the inward radius, forwards positive [rad]."]
    time: Annotated[Time | None, "Time taken [s]."]
    angle: Annotated[Angle | None, "Angle turned, counter-clockwise positive [rad]."]
    turns: Annotated[Ratio | None, "Number of turns [-]."]
    arc: Annotated[Length | None, "Length along the circle [m]."]
    start: Annotated[OnCircle, "The state at the start."]


def circle(
    *,
    radius: Annotated[Distance, "Radius of the circle, e.g. 0.5 m."],
    state: Annotated[Turning | Running, "Angular velocity and acceleration, or speed and its rate, at the start."],
    time: Annotated[Time | None, "Time to the end, at constant angular acceleration, e.g. 3 s."] = None,
    angle: Annotated[Angle | None, "Angle turned, in place of the time, e.g. 90 deg."] = None,
    arc: Annotated[Length | None, "Length along the circle, in place of the time, e.g. 3 m."] = None,
) -> Circle:
    """Speed, tangential and normal acceleration on a circle, now or after a time, an angle or an arc.

    Equation
    --------
    v = rω, a_t = rα, a_n = rω² = v²/r, ‖a‖ = √(a_t² + a_n²), angle to the inward radius atan2(a_t, a_n);
    ω₁ = ω + αt, θ = ωt + αt²/2, ω₁² = ω² + 2αθ.

    Raises
    ------
    InadmissibleError
        When the radius is not above zero, several of time, angle and arc are given, or the angle is never reached.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 3.7.

    Examples
    --------
    >>> round(circle(radius=2.0, state=Turning(3.0, 1.0)).normal, 6)
    18.0
    """
    require(plain(radius) > 0.0, "the radius of {radius} is not above zero", code="radius",
            hint="for example --radius '0.5 m'", radius=(radius, Length))  # fmt: skip
    ends = [name for name, value in (("time", time), ("angle", angle), ("arc", arc)) if value is not None]
    require(len(ends) <= 1, "{names} are given: give only one of them", code="exclusive", names=" and ".join(ends))
    if isinstance(state, Running):
        omega, alpha = state.speed / radius, state.speed_rate / radius
    else:
        omega, alpha = state.angular_velocity, state.angular_acceleration
    start = _place(radius, omega, alpha)
    last, swept, elapsed = omega, None, None
    if time is not None:
        last = multiply_add(alpha, time, omega)
        swept, elapsed = time * (0.5 * (omega + last)), time
    elif ends:
        swept = angle if angle is not None else arc / radius  # type: ignore[operator]
        last = _speed_after(omega, alpha, swept)
        elapsed = 2.0 * swept / (omega + last) if plain(swept) else 0.0 * omega
    end = _place(radius, last, alpha)
    return Circle(
        speed=end.speed,
        angular_velocity=last,
        angular_acceleration=alpha,
        tangential=end.tangential,
        normal=end.normal,
        acceleration=end.acceleration,
        inclination=end.inclination,
        time=elapsed,
        angle=swept,
        turns=None if swept is None else swept / (2.0 * pi_beside(radius, swept)),
        arc=None if swept is None else radius * swept,
        start=start,
    )


def _place(radius: float, omega: float, alpha: float) -> OnCircle:
    speed = radius * omega
    tangential, normal = radius * alpha, omega * speed
    return OnCircle(speed, omega, tangential, normal, hypot(tangential, normal), atan2(tangential, normal))


def _speed_after(omega: float, alpha: float, swept: float) -> float:
    """The angular velocity after an angle, on the first passage."""
    square = multiply_add(omega, omega, 2.0 * alpha * swept)
    forward = plain(omega) * plain(swept) > 0.0 or (plain(omega) == 0.0 and plain(alpha) * plain(swept) > 0.0)
    stop = plain(omega) * plain(omega) / (2.0 * abs(plain(alpha))) if plain(alpha) else 0.0
    if plain(swept) == 0.0:
        return omega
    turned_back = not forward and plain(alpha) * plain(swept) > 0.0
    require(
        forward or turned_back,
        "it turns the other way and does not reach {angle}",
        code="not-reached",
        hint="check the signs",
        angle=(plain(swept), Angle),
    )
    require(
        plain(square) >= 0.0,
        "it stops after {stop:6}, and does not reach {angle:6}",
        code="not-reached",
        hint="give a smaller angle, more speed or less deceleration",
        stop=(stop, Angle),
        angle=(abs(plain(swept)), Angle),
    )
    root = sqrt(maximum(square, 0.0 * square))
    return root if plain(swept) > 0.0 else -root
