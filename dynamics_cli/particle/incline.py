"""The tasks `incline` and `circle`: friction decides what slides."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, atan, cos, sin, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Angle,
    Annotated,
    Distance,
    Force,
    Friction,
    Gravity,
    Length,
    Mass,
    RoadSpeed,
    Speed,
    Text,
    Time,
)
from dynamics_cli.records import record

QUARTER = 1.5707963267948966


@record
class Incline:
    """A block on an incline."""

    motion: Annotated[Text, "Whether it rests, or slides up or down."]
    acceleration: Annotated[Acceleration, "Along the incline, up positive [m/s^2]."]
    normal_force: Annotated[Force, "Force of the incline across it [N]."]
    friction_force: Annotated[Force, "Friction along the incline, up positive [N]."]
    needed_friction: Annotated[Friction, "Friction that would hold it at rest [-]."]
    repose: Annotated[Angle, "Steepest angle at which it rests by itself [rad]."]
    holding_force: Annotated[
        Force, "Least force up along the incline that keeps it from sliding down; none needed: 0 [N]."
    ]
    moving_force: Annotated[Force, "Force up along the incline at which it begins to slide up [N]."]
    time: Annotated[Time | None, "Time to slide the distance from rest [s]."]
    speed: Annotated[Speed | None, "Speed after it [m/s]."]


def incline(
    *,
    mass: Annotated[Mass, "Mass of the block, e.g. 20 kg."],
    angle: Annotated[Angle, "Angle of the incline above the horizontal, e.g. 30 deg."],
    friction: Annotated[Friction, "Coefficient of friction, at rest and sliding unless --kinetic is given, e.g. 0.3."],
    kinetic: Annotated[Friction | None, "Coefficient while it slides, e.g. 0.25."] = None,
    force: Annotated[Force, "A force along the incline, up positive, e.g. 50 N."] = 0.0,
    distance: Annotated[Distance | None, "A distance to slide from rest, e.g. 3 m."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Incline:
    """A block at rest on an incline with friction: whether it slides, how fast, and the forces that hold and move it.

    Equation
    --------
    N = m·g·cos α; it rests while |F − m·g·sin α| ≤ μ·N; sliding m·a = F − m·g·sin α ∓ μ_k·N.

    Returns
    -------
    Incline
        The motion, the forces, and the limits.

    Raises
    ------
    InadmissibleError
        When the mass is not above zero, the angle is not between −90 and 90 degrees, or kinetic friction exceeds
        static.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 6.4 and 8.3.

    Examples
    --------
    >>> incline(mass=20.0, angle=0.5235987755982988, friction=0.3).motion
    'slides down'
    """
    require(mass > 0.0, "the mass of {mass} is not above zero", mass=(mass, Mass))
    require(absolute(angle) < QUARTER, "the incline is {angle}; it must be below 90 deg", angle=(angle, Angle),
            code="angle", hint="give an angle between -90 and 90 deg")  # fmt: skip
    sliding = friction if kinetic is None else kinetic
    require(plain(sliding) <= plain(friction),
    "the kinetic friction of {kinetic} is above the static one of {friction}",
            kinetic=(sliding, Friction), friction=(friction, Friction), code="friction",
            hint="static friction is the larger of the two")  # fmt: skip
    normal = mass * gravity * cos(angle)
    down = mass * gravity * sin(angle)
    net = force - down
    grip = friction * normal
    if abs(plain(net)) <= plain(grip):
        motion, rubbed, acceleration = "rests", -net, 0.0 * net
    else:
        up = plain(net) > 0.0
        motion = "slides up" if up else "slides down"
        rubbed = -sliding * normal if up else sliding * normal
        acceleration = (net + rubbed) / mass
    moving = motion != "rests" and plain(acceleration) != 0.0
    pace = absolute(acceleration)
    held = down - grip
    return Incline(
        motion=motion,
        acceleration=acceleration,
        normal_force=normal,
        friction_force=rubbed,
        needed_friction=absolute(net) / normal,
        repose=atan(friction),
        holding_force=held if plain(held) > 0.0 else 0.0 * held,
        moving_force=down + grip,
        time=sqrt(2.0 * distance / pace) if distance is not None and moving else None,
        speed=sqrt(2.0 * distance * pace) if distance is not None and moving else None,
    )


@record
class Circle:
    """A bend with a bank."""

    greatest_speed: Annotated[RoadSpeed | None, "Above it it slides outwards; none where no speed is too great [m/s]."]
    least_speed: Annotated[RoadSpeed, "Below it it slides inwards; 0 where it can stand [m/s]."]
    free_speed: Annotated[RoadSpeed, "At it no friction is needed [m/s]."]
    needed_friction: Annotated[Friction | None, "Friction that the speed needs [-]."]
    slides: Annotated[Text | None, "What happens at the speed given."]
    acceleration: Annotated[Acceleration | None, "Towards the centre, at the speed [m/s^2]."]
    normal_force: Annotated[Force | None, "Force of the road across it, at the speed; with the mass [N]."]


def circle(
    *,
    radius: Annotated[Length, "Radius of the bend, e.g. 60 m."],
    friction: Annotated[Friction, "Coefficient of friction, e.g. 0.6."],
    bank: Annotated[Angle, "Bank of the road, down to the inside positive, e.g. 5 deg."] = 0.0,
    speed: Annotated[RoadSpeed | None, "A speed to judge, e.g. 70 km/h."] = None,
    mass: Annotated[Mass | None, "Mass, for the force, e.g. 1500 kg."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Circle:
    """A body on a banked bend: the speeds at which it slides outwards and inwards, and what a speed needs.

    Equation
    --------
    v² = g·R·(sin β ± μ·cos β)/(cos β ∓ μ·sin β); without friction v² = g·R·tan β.

    Returns
    -------
    Circle
        The limits, and at a speed the friction it needs.

    Raises
    ------
    InadmissibleError
        When the radius is not above zero, or the bank is not between −90 and 90 degrees.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 3.7 and 8.3.

    Examples
    --------
    >>> round(circle(radius=60.0, friction=0.6, bank=0.08726646259971647).greatest_speed, 5)
    20.66225
    """
    require(radius > 0.0, "the radius of {radius} is not above zero", radius=(radius, Length))
    require(absolute(bank) < QUARTER, "the bank is {bank}; it must be below 90 deg", bank=(bank, Angle), code="bank",
            hint="give an angle between -90 and 90 deg")  # fmt: skip
    sine, cosine = sin(bank), cos(bank)
    scale = gravity * radius
    outer, inner = cosine - friction * sine, cosine + friction * sine
    up, down = sine + friction * cosine, sine - friction * cosine
    require((up > 0.0) | (outer <= 0.0), "it slides down the outside at every speed", code="slides",
            hint="the bank falls to the outside by more than friction holds")  # fmt: skip
    greatest = sqrt(scale * up / outer) if plain(outer) > 0.0 else None
    least = sqrt(scale * down / inner) if plain(down) > 0.0 and plain(inner) > 0.0 else 0.0 * scale
    needed = slides = push = normal = None
    if speed is not None:
        push = speed * speed / radius
        across = push * cosine - gravity * sine
        normal_share = gravity * cosine + push * sine
        require(normal_share > 0.0, "at {speed} it leaves the road", speed=(speed, RoadSpeed), code="leaves",
                hint="the road falls to the outside: give a smaller speed")  # fmt: skip
        needed = absolute(across) / normal_share
        slides = (
            "holds"
            if plain(needed) <= plain(friction)
            else "slides outwards"
            if plain(across) > 0.0
            else "slides inwards"
        )
        normal = None if mass is None else mass * normal_share
    return Circle(
        greatest_speed=greatest,
        least_speed=least,
        free_speed=sqrt(scale * sine / cosine) if plain(sine) > 0.0 else 0.0 * scale,
        needed_friction=needed,
        slides=slides,
        acceleration=push,
        normal_force=normal,
    )
