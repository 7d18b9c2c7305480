"""The task `fall`: a body that trips turns about its support as one piece; whether the support slips."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, cos, sin, sqrt
from dynamics_cli.numerics.elliptic import first_kind
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.roots import halved, highest
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    AngularSpeed,
    Annotated,
    Energy,
    Friction,
    Gravity,
    Inertia,
    Length,
    Mass,
    Speed,
    Text,
    Time,
)
from dynamics_cli.records import record

RIGHT_ANGLE = 1.5707963267948966
HALF_TURN = 3.141592653589793
STEPS = 400
# The place of a maximum is known to half the digits.
WIDTH = 1e-9


@record
class Gyration:
    """A body by its radius of gyration."""

    gyration: Annotated[Length, "Radius of gyration about the mass centre, left-right axis, e.g. 0.4 m."]
    mass: Annotated[Mass | None, "Mass of the body, for the energy, e.g. 75 kg."] = None

    def squared(self, height: float) -> float:
        """Square of the radius of gyration about the support."""
        return self.gyration * self.gyration + height * height


@record
class SupportInertia:
    """A body by its moment of inertia about the support."""

    support_inertia: Annotated[Inertia, "Moment of inertia about the support, e.g. 87 kg*m^2."]
    mass: Annotated[Mass, "Mass of the body, e.g. 75 kg."]

    def squared(self, height: float) -> float:
        """Square of the radius of gyration about the support."""
        require(self.mass > 0.0, "the mass of {mass} is not above zero", mass=(self.mass, Mass), code="mass")
        square = self.support_inertia / self.mass
        require(
            square >= height * height, "a moment of inertia of {inertia} about the support is below mass times height "
            "of the mass centre squared, {least}", inertia=(self.support_inertia, Inertia),
            least=(self.mass * height * height, Inertia), code="impossible-body",
            hint="give the moment about the point from which --centre-height is measured, or --gyration",
        )  # fmt: skip
        return square


@record
class Fall:
    """A fall as one piece."""

    time: Annotated[Time, "Time from the start to the end angle [s]."]
    rate: Annotated[AngularSpeed, "Angular velocity there [rad/s]."]
    centre_speed: Annotated[Speed, "Speed of the mass centre there [m/s]."]
    head_speed: Annotated[Speed | None, "Speed of the top of the head there [m/s]."]
    energy: Annotated[Energy | None, "Kinetic energy there [J]."]
    start_rate: Annotated[AngularSpeed | None, "Angular velocity after the trip, with a speed before it [rad/s]."]
    friction_needed: Annotated[Friction, "Friction that keeps the support from slipping while it pushes forward [-]."]
    friction_angle: Annotated[Angle, "Inclination at which that much is needed [rad]."]
    slip: Annotated[Text | None, "Whether the support slips, and which way."]
    slip_angle: Annotated[Angle | None, "Inclination at which it begins to slip [rad]."]


def fall(
    *,
    centre_height: Annotated[Length, "From the support to the mass centre, e.g. 1.0 m."],
    body: Annotated[Gyration | SupportInertia, "How its mass is spread."],
    start: Annotated[Angle, "Inclination from the vertical at the start, e.g. 5 deg."] = 0.0,
    speed: Annotated[Speed, "Walking speed before the trip, which stops the foot, e.g. 1.4 m/s."] = 0.0,
    end: Annotated[Angle, "Inclination at the end, e.g. 90 deg."] = RIGHT_ANGLE,
    height: Annotated[Length | None, "From the support to the top of the head, e.g. 1.75 m."] = None,
    friction: Annotated[Friction | None, "Friction of the floor, for slipping, e.g. 0.4."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Fall:
    """A person who trips or topples, as one rigid piece about the support: time, speed of the head, slipping.

    Equation
    --------
    p² = g·h/(k² + h²), ω² = ω₀² + 4p²·sin(½(θ₁ + θ₀))·sin(½(θ₁ − θ₀)), t = ∫ dθ/ω by Carlson's integral R_F; a trip at
    speed v starts with ω₀ = v·h·cos θ₀/(k² + h²).

    Returns
    -------
    Fall
        Time and speeds at the end, the friction needed, and where the support slips.

    Raises
    ------
    InadmissibleError
        When the body stands upright at rest and never falls, or the end does not lie beyond the start.

    Notes
    -----
    Nobody falls as one piece: knees bend and arms reach out, so this is a fall without a reaction. The time grows
    without limit as the start comes near the vertical.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 20.12; Carlson, Numerical Algorithms 10,
    1995.

    Examples
    --------
    >>> answer = fall(centre_height=1.0, body=Gyration(0.5477225575051661), start=0.1, gravity=9.81)
    >>> round(answer.time, 9)
    1.274741175
    """
    require(centre_height > 0.0, "the mass centre at {height} is not above the support",
            height=(centre_height, Length), code="height")  # fmt: skip
    require((start >= 0.0) & (start < HALF_TURN), "a start at {start} is not between upright and upside down",
            start=(start, Angle), code="start", hint="measure the inclination from the vertical, forward")  # fmt: skip
    require((end > start) & (end <= HALF_TURN), "the end at {end} does not lie beyond the start at {start}",
            end=(end, Angle), start=(start, Angle), code="end")  # fmt: skip
    require(speed >= 0.0, "a speed of {speed} is below zero", speed=(speed, Speed), code="speed")
    require(
        (start > 0.0) | (speed > 0.0),
        "upright and at rest the body never falls: the time has no limit as the start comes near the vertical",
        code="never-falls", hint="give --start, e.g. --start 2deg, or --speed",
    )  # fmt: skip
    square = body.squared(centre_height)
    swing = gravity * centre_height / square
    tripped = speed * centre_height * cos(start) / square
    boost = tripped * tripped / (4.0 * swing)
    gained = sin(0.5 * (end + start)) * sin(0.5 * (end - start))
    rate = 2.0 * sqrt(swing * (gained + boost))
    time = _time(start, end, gained, boost) / sqrt(swing)
    share = centre_height * centre_height / square
    peak, needed = _peak(share, start, float(plain(end)), boost)
    slip, slip_angle = _slip(share, start, float(plain(end)), boost, friction)
    mass = body.mass
    return Fall(
        time=time,
        rate=rate,
        centre_speed=rate * centre_height,
        head_speed=None if height is None else rate * height,
        energy=None if mass is None else 0.5 * mass * square * rate * rate,
        start_rate=tripped if float(plain(speed)) > 0.0 else None,
        friction_needed=needed,
        friction_angle=peak,
        slip=slip,
        slip_angle=slip_angle,
    )


def _time(start: float, end: float, gained: float, boost: float) -> float:
    """Time in units of 1/p; `gained` is sin²½θ₁ − sin²½θ₀, `boost` is ω₀²/4p².

    With u = sin²½θ it is ½ ∫ du/√(u·(1 − u)·(u − sin²½θ₀ + boost)), by Carlson's formula between two limits.
    """
    s, c, fast = sin(0.5 * end), cos(0.5 * end), sqrt(gained + boost)
    s0, c0, slow = sin(0.5 * start), cos(0.5 * start), sqrt(boost)
    pairs = s * c * slow + s0 * c0 * fast, s * fast * c0 + s0 * slow * c, s * c0 * slow + s0 * c * fast
    x, y, z = (pair / gained for pair in pairs)
    return first_kind(x * x, y * y, z * z)


def forces_at(share: float, start: float, boost: float, angle: float) -> "tuple[float, float]":
    """Friction force and normal force over the weight, at an inclination."""
    turning = 4.0 * (sin(0.5 * (angle + start)) * sin(0.5 * (angle - start)) + boost)
    along = share * sin(angle) * (cos(angle) - turning)
    normal = 1.0 - share * (sin(angle) * sin(angle) + cos(angle) * turning)
    return along, normal


def _peak(share: float, start: float, end: float, boost: float) -> "tuple[float, float]":
    """The inclination at which most friction is needed while the ground pushes the support forward, and how much."""
    numbers = float(plain(share)), float(plain(start)), float(plain(boost))

    def needed(angle: float) -> float:
        along, normal = forces_at(*numbers, angle)
        return along / normal if normal > 0.0 else 0.0

    step = (end - numbers[1]) / STEPS
    at = max((numbers[1] + k * step for k in range(STEPS + 1)), key=needed)
    angle = highest(needed, max(numbers[1], at - step), min(end, at + step), WIDTH)
    along, normal = forces_at(share, start, boost, angle)
    return angle, absolute(along / normal)


def _slip(
    share: float, start: float, end: float, boost: float, friction: "float | None"
) -> "tuple[str | None, float | None]":
    """Whether the support slips before the end, which way, and where it begins."""
    if friction is None:
        return None, None
    numbers = float(plain(share)), float(plain(start)), float(plain(boost))
    limit = float(plain(friction))

    def holds(angle: float) -> bool:
        along, normal = forces_at(*numbers, angle)
        return abs(along) <= limit * normal

    step = (end - numbers[1]) / STEPS
    for k in range(STEPS + 1):
        if holds(numbers[1] + k * step):
            continue
        _, high = halved(holds, numbers[1] + max(k - 1, 0) * step, numbers[1] + k * step)
        along, normal = forces_at(*numbers, high)
        if normal <= 0.0:
            return "the support lifts off", high
        return "the support slips " + ("backward" if along > 0.0 else "forward"), high
    return "the support holds", None
