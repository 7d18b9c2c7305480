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
        Force | None, "Least force that keeps it from sliding down: 0 where none is needed, none where none can [N]."
    ]
    moving_force: Annotated[Force | None, "Force at which it begins to slide up; none where it jams or lifts [N]."]
    time: Annotated[Time | None, "Time to slide the distance; none where it does not come so far [s]."]
    speed: Annotated[Speed | None, "Speed after it [m/s]."]
    stop_time: Annotated[Time | None, "Time after which a block that slides at first stops [s]."]
    stop_distance: Annotated[Length | None, "How far it slides until then [m]."]
    after: Annotated[Text | None, "Whether it then rests or slides back."]
    return_speed: Annotated[Speed | None, "Speed with which it comes back to its start [m/s]."]


def incline(
    *,
    mass: Annotated[Mass, "Mass of the block, e.g. 20 kg."],
    angle: Annotated[Angle, "Angle of the incline above the horizontal, e.g. 30 deg."],
    friction: Annotated[Friction, "Coefficient of friction, at rest and sliding unless --kinetic is given, e.g. 0.3."],
    kinetic: Annotated[Friction | None, "Coefficient while it slides, e.g. 0.25."] = None,
    force: Annotated[Force, "A force on the block, up the incline positive, e.g. 50 N."] = 0.0,
    force_angle: Annotated[
        Angle, "Angle of the force away from the incline; a level push on an incline of 30 deg is at -30 deg."
    ] = 0.0,
    start_speed: Annotated[Speed, "Speed along the incline at the start, up positive, e.g. 4 m/s."] = 0.0,
    distance: Annotated[Distance | None, "A distance to slide, e.g. 3 m."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Incline:
    """A block on an incline with friction: whether and how fast it slides, where it stops, what holds and moves it.

    Equation
    --------
    N = m·g·cos α − F·sin β; at rest it stays while |F·cos β − m·g·sin α| ≤ μ·N; sliding
    m·a = F·cos β − m·g·sin α ∓ μ_k·N; v² = v₀² + 2·a·s. It holds and moves at
    F = m·g·(sin α ∓ μ·cos α)/(cos β ∓ μ·sin β).

    Returns
    -------
    Incline
        The motion, the forces, and the limits.

    Raises
    ------
    InadmissibleError
        When the mass is not above zero, an angle is not between −90 and 90 degrees, kinetic friction exceeds static,
        or the force lifts the block.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 6.4 and 8.3.

    Examples
    --------
    >>> incline(mass=20.0, angle=0.5235987755982988, friction=0.3).motion
    'slides down'
    """
    require(mass > 0.0, "the mass of {mass} is not above zero", mass=(mass, Mass))
    for steep, name in ((angle, "incline"), (force_angle, "force")):
        require(absolute(steep) < QUARTER, "the {name} is at {angle}; it must be below 90 deg", name=name,
                angle=(steep, Angle), code="angle", hint="give an angle between -90 and 90 deg")  # fmt: skip
    sliding = friction if kinetic is None else kinetic
    require(plain(sliding) <= plain(friction),
            "the kinetic friction of {kinetic} is above the static one of {friction}",
            kinetic=(sliding, Friction), friction=(friction, Friction), code="friction",
            hint="static friction is the larger of the two")  # fmt: skip
    sine, cosine = sin(angle), cos(angle)
    across, along = sin(force_angle), cos(force_angle)
    normal = mass * gravity * cosine - force * across
    require(plain(normal) > 0.0, "the force of {force} lifts the block off the incline", force=(force, Force),
            code="lifts", hint="give a smaller force or another --force-angle")  # fmt: skip
    net = force * along - mass * gravity * sine
    motion, rubbed = _friction(net, friction * normal, sliding * normal, plain(start_speed))
    acceleration = 0.0 * net if motion == "rests" else (net + rubbed) / mass
    # a force that points beyond the vertical lifts the block before it moves it up
    upward = plain(cosine * along) > plain(sine * across)
    slips, grips = sine - friction * cosine, along - friction * across
    holding = 0.0 * normal if plain(slips) <= 0.0 else None
    if upward and plain(slips) > 0.0 and plain(grips) > 0.0:
        holding = mass * gravity * slips / grips
    moves = along + friction * across
    moving = mass * gravity * ((sine + friction * cosine) / moves) if upward and plain(moves) > 0.0 else None
    ahead = acceleration if motion == "slides up" else -acceleration
    time, speed = _after(absolute(start_speed), ahead, distance) if motion != "rests" else (None, None)
    stop_time = stop_distance = after = back = None
    if plain(start_speed) != 0.0 and plain(ahead) < 0.0:
        stop_time = absolute(start_speed) / -ahead
        stop_distance = 0.5 * absolute(start_speed) * stop_time
        after, rubbed_back = _friction(net, friction * normal, sliding * normal, 0.0)
        if after != "rests":
            back = _after(0.0 * ahead, absolute(net + rubbed_back) / mass, stop_distance)[1]
    return Incline(
        motion=motion,
        acceleration=acceleration,
        normal_force=normal,
        friction_force=rubbed,
        needed_friction=absolute(net) / normal,
        repose=atan(friction),
        holding_force=holding,
        moving_force=moving,
        time=time,
        speed=speed,
        stop_time=stop_time,
        stop_distance=stop_distance,
        after=None if after is None else f"then {after}",
        return_speed=back,
    )


def _friction(net: float, grip: float, sliding: float, velocity: float) -> "tuple[str, float]":
    """How a block moves that all other forces pull up by `net`, and the friction on it, up positive."""
    if velocity == 0.0 and abs(plain(net)) <= plain(grip):
        return "rests", -net
    up = velocity > 0.0 if velocity else plain(net) > 0.0
    return ("slides up", -sliding) if up else ("slides down", sliding)


def _after(start: float, ahead: float, distance: "float | None") -> "tuple[float | None, float | None]":
    """Time and speed after a distance, at a constant acceleration; none where it stops before."""
    if distance is None:
        return None, None
    squared = start * start + 2.0 * ahead * distance
    speed = sqrt(squared) if plain(squared) > 0.0 else None
    return (None, None) if speed is None else (2.0 * distance / (start + speed), speed)


@record
class Circle:
    """A bend with a bank."""

    greatest_speed: Annotated[
        RoadSpeed | None, "Above it it slides outwards; none where no speed is too great, or without a friction [m/s]."
    ]
    least_speed: Annotated[
        RoadSpeed | None, "Below it it slides inwards; 0 where it can stand, none without a friction [m/s]."
    ]
    free_speed: Annotated[RoadSpeed, "At it no friction is needed [m/s]."]
    needed_friction: Annotated[Friction | None, "Friction that the speed needs [-]."]
    slides: Annotated[Text | None, "What happens at the speed given."]
    acceleration: Annotated[Acceleration | None, "Towards the centre, at the speed [m/s^2]."]
    normal_force: Annotated[Force | None, "Force of the road across it, at the speed; with the mass [N]."]


def circle(
    *,
    radius: Annotated[Length, "Radius of the bend, e.g. 60 m."],
    friction: Annotated[Friction | None, "Coefficient of friction, for the limits, e.g. 0.6."] = None,
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
    greatest, least = (None, None) if friction is None else _limits(sine, cosine, friction, scale)
    needed = slides = push = normal = None
    if speed is not None:
        push = speed * speed / radius
        across = push * cosine - gravity * sine
        normal_share = gravity * cosine + push * sine
        require(normal_share > 0.0, "at {speed} it leaves the road", speed=(speed, RoadSpeed), code="leaves",
                hint="the road falls to the outside: give a smaller speed")  # fmt: skip
        needed = absolute(across) / normal_share
        if friction is not None:
            way = "outwards" if plain(across) > 0.0 else "inwards"
            slides = "holds" if plain(needed) <= plain(friction) else f"slides {way}"
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


def _limits(sine: float, cosine: float, friction: float, scale: float) -> "tuple[float | None, float | None]":
    """The greatest and the least speed that hold, of a bank by its sine and cosine; `scale` is g·R."""
    outer, inner = cosine - friction * sine, cosine + friction * sine
    up, down = sine + friction * cosine, sine - friction * cosine
    require((up > 0.0) | (outer <= 0.0), "it slides down the outside at every speed", code="slides",
            hint="the bank falls to the outside by more than friction holds")  # fmt: skip
    greatest = sqrt(scale * up / outer) if plain(outer) > 0.0 else None
    return greatest, sqrt(scale * down / inner) if plain(down) > 0.0 and plain(inner) > 0.0 else 0.0 * scale
