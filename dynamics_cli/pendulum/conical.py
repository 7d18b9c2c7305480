"""The task `conical`: a point mass that circles on a string at one height."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import atan2 as angle_of
from dynamics_cli.numerics.elementary import cos, multiply_add, pi_beside, sin, sqrt
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Force,
    Frequency,
    Gravity,
    Length,
    Mass,
    ShaftSpeed,
    Speed,
    Time,
)
from dynamics_cli.records import record

HALF_PI = 1.5707963267948966


@record
class ConeAngle:
    """A cone by its angle."""

    angle: Annotated[Angle, "Angle of the string from the vertical, e.g. 40 deg."]


@record
class ConeSpeed:
    """A cone by how fast it turns."""

    rotation: Annotated[ShaftSpeed, "How fast it circles, e.g. 40 rpm."]


@record
class ConePeriod:
    """A cone by the time of one circle."""

    period: Annotated[Time, "Time of one circle, e.g. 1.8 s."]


@record
class ConeHeight:
    """A cone by its height."""

    height: Annotated[Length, "Height of the pivot above the circle, e.g. 0.8 m."]


@record
class BobSpeed:
    """A cone by the speed of the mass on its circle."""

    speed: Annotated[Speed, "Speed of the mass on its circle, e.g. 2 m/s."]


@record
class Conical:
    """The circle of a conical pendulum, and how it is disturbed."""

    angle: Annotated[Angle, "Angle of the string from the vertical [rad]."]
    rotation: Annotated[ShaftSpeed, "How fast it circles [rad/s]."]
    period: Annotated[Time, "Time of one circle [s]."]
    speed: Annotated[Speed, "Speed on the circle [m/s]."]
    radius: Annotated[Length, "Radius of the circle [m]."]
    height: Annotated[Length, "Height of the pivot above the circle [m]."]
    tension: Annotated[Force | None, "Force of the string; with the mass [N]."]
    disturbance: Annotated[Frequency, "Frequency with which a small disturbance oscillates [Hz]."]
    apsidal_angle: Annotated[Angle, "Turn from the highest to the lowest place of a disturbed circle [rad]."]
    least_rotation: Annotated[ShaftSpeed, "It circles only faster than this; slower it hangs [rad/s]."]


def conical(
    *,
    length: Annotated[Length, "Length of the string, e.g. 1 m."],
    cone: Annotated[ConeAngle | ConeSpeed | ConePeriod | ConeHeight | BobSpeed, "Which circle it is."],
    mass: Annotated[Mass | None, "The point mass, for the tension, e.g. 0.5 kg."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Conical:
    """A conical pendulum: angle, speed and tension of its circle, and the frequency of a disturbance.

    Equation
    --------
    cos α = g/(L·Ω²), from sin ½α = √((L·Ω² − g)/(2·L·Ω²)); by the speed, sin ½α = √(c/(2 + c + √(c² + 4))) with
    c = v²/(g·L); disturbance κ = Ω·√(1 + 3·cos²α), apsidal angle π·Ω/κ.

    Returns
    -------
    Conical
        The circle and its disturbance.

    Raises
    ------
    InadmissibleError
        When the length is not above zero, the angle is not between 0 and 90 degrees, the height is not below the
        length, or it turns too slowly for a cone.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 8.4.

    Examples
    --------
    >>> round(conical(length=1.0, cone=ConeAngle(0.6981317007977318)).disturbance, 9)
    0.946117728
    """
    require(length > 0.0, "the length of {length} is not above zero", length=(length, Length))
    pi = pi_beside(length, gravity, cone)
    least = sqrt(gravity / length)
    if isinstance(cone, ConeAngle):
        require(
            (cone.angle > 0.0) & (cone.angle < HALF_PI), "a cone cannot have an angle of {angle}",
            angle=(cone.angle, Angle), code="angle", hint="give an angle between 0 and 90 deg",
        )  # fmt: skip
        sine, cosine, angle = sin(cone.angle), cos(cone.angle), cone.angle
        rotation = sqrt(gravity / (length * cosine))
    elif isinstance(cone, ConeHeight):
        require(
            (cone.height > 0.0) & (cone.height < length),
            "a circle {height} below the pivot needs a longer string than {length}",
            height=(cone.height, Length), length=(length, Length), code="height",
            hint="give a height above zero and below the length",
        )  # fmt: skip
        cosine = cone.height / length
        sine = sqrt((length - cone.height) * (length + cone.height)) / length
        rotation = sqrt(gravity / cone.height)
        angle = angle_of(sine, cosine)
    elif isinstance(cone, BobSpeed):
        angle, sine, cosine = _by_speed(cone.speed * cone.speed / (gravity * length))
        rotation = sqrt(gravity / (length * cosine))
    else:
        rotation = abs(cone.rotation) if isinstance(cone, ConeSpeed) else 2.0 * pi / cone.period
        needed = length * rotation * rotation
        beyond = multiply_add(length * rotation, rotation, -gravity)
        require(
            beyond > 0.0, "at {rotation} it hangs straight down: a cone needs more than {least}",
            rotation=(rotation, ShaftSpeed), least=(least, ShaftSpeed), code="too-slow",
            hint=worded("turn it faster than {least}, or lengthen the string", least=(least, ShaftSpeed)),
        )  # fmt: skip
        half_sine, half_cosine = sqrt(beyond / (2.0 * needed)), sqrt((needed + gravity) / (2.0 * needed))
        angle = 2.0 * angle_of(half_sine, half_cosine)
        sine, cosine = 2.0 * half_sine * half_cosine, gravity / needed
    disturbed = sqrt(1.0 + 3.0 * cosine * cosine)
    return Conical(
        angle=angle,
        rotation=rotation,
        period=2.0 * pi / rotation,
        speed=rotation * length * sine,
        radius=length * sine,
        height=length * cosine,
        tension=None if mass is None else mass * length * rotation * rotation,
        disturbance=rotation * disturbed / (2.0 * pi),
        apsidal_angle=pi / disturbed,
        least_rotation=least,
    )


def _by_speed(share: float) -> "tuple[float, float, float]":
    """Angle, sine and cosine where v² = share·g·L: cos α = 2/(c + √(c² + 4)), and ½α without a difference."""
    require(share > 0.0, "at rest it hangs straight down", code="too-slow", hint="give a speed above zero")
    root = sqrt(share * share + 4.0)
    cosine = 2.0 / (share + root)
    half_sine, half_cosine = sqrt(share / (2.0 + share + root)), sqrt(0.5 * (1.0 + cosine))
    return 2.0 * angle_of(half_sine, half_cosine), 2.0 * half_sine * half_cosine, cosine
