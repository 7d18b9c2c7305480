"""Two slides square to each other: scotch yoke, Oldham coupling and elliptic trammel."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, cos, maximum
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    AngularAcceleration,
    Annotated,
    Coordinate,
    Distance,
    Force,
    Length,
    Mass,
    PartAcceleration,
    PartPoint,
    PartVelocity,
    PlanarPosition,
    Size,
    Speed,
    Torque,
    TurnRate,
)
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Below this share of its length a bar is in line with the slide that drives it.
IN_LINE = 1e-12


def require_long(name: str, length: float) -> None:
    """Refuse a link that is not longer than zero."""
    require(
        length > 0.0,
        f"the {name} has a length of {{length}}: a link needs more than zero",
        length=(length, Size),
        code="no-length",
    )


@record
class ScotchYoke:
    """A scotch yoke in one pose, and its largest speed and acceleration."""

    position: Annotated[Coordinate, "Position x of the yoke from mid-stroke [m]."]
    velocity: Annotated[Speed | None, "Its velocity [m/s]."]
    acceleration: Annotated[Acceleration | None, "Its acceleration [m/s^2]."]
    slip: Annotated[Speed | None, "Speed of the pin along the slot [m/s]."]
    crank_torque: Annotated[Torque | None, "Torque at the crank that balances the load, without friction [N*m]."]
    stroke: Annotated[Size, "Stroke [m]."]
    top_speed: Annotated[Speed | None, "Largest speed of the yoke in a turn at this ω [m/s]."]
    top_acceleration: Annotated[Acceleration | None, "Largest acceleration in a turn at this ω, constant [m/s^2]."]


def scotch_yoke(
    *,
    crank: Annotated[Size, "Length a of the crank, e.g. 40 mm."],
    crank_angle: Annotated[Angle, "Crank angle θ from the direction of the stroke, e.g. 30 deg."] = 0.0,
    slot_angle: Annotated[Angle, "Lean β of the slot from square to the stroke [rad]."] = 0.0,
    speed: Annotated[TurnRate | None, "Angular velocity ω of the crank, e.g. 300 rpm."] = None,
    angular_acceleration: Annotated[AngularAcceleration, "Angular acceleration α of the crank [rad/s^2]."] = 0.0,
    load_force: Annotated[Force | None, "Force that the yoke delivers along x, e.g. 500 N."] = None,
) -> ScotchYoke:
    """Scotch yoke: pure harmonic motion of a slotted slide that a crank's pin drives.

    Equation
    --------
    x = a cos(θ + β)/cos β, v = −aω sin(θ + β)/cos β, dv/dt = −a(ω² cos(θ + β) + α sin(θ + β))/cos β; the pin slips
    along the slot at aω cos θ/cos β; stroke 2a/cos β; T = F·dx/dθ.

    Raises
    ------
    InadmissibleError
        When the crank is not longer than zero, or the slot lies along the stroke.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 5.3.

    Examples
    --------
    >>> round(scotch_yoke(crank=0.04, crank_angle=1.0, speed=10.0).velocity, 9)
    -0.336588394
    """
    require_long("crank", crank)
    lean = cos(slot_angle)
    require(
        lean > 0.0,
        "the slot leans by {angle}: along the stroke or beyond, it drives nothing",
        angle=(slot_angle, Angle),
        code="slot",
        hint="give a lean between -90 and 90 deg, 0 for a slot square to the stroke",
    )
    reach, turn = crank / lean, turned(crank_angle + slot_angle)
    position, slope = reach * turn[0], -(reach * turn[1])
    torque = None if load_force is None else load_force * slope
    if speed is None:
        return ScotchYoke(position, None, None, None, torque, 2.0 * reach, None, None)
    square = speed * speed
    return ScotchYoke(
        position=position,
        velocity=slope * speed,
        acceleration=slope * angular_acceleration - position * square,
        slip=reach * turned(crank_angle)[0] * speed,
        crank_torque=torque,
        stroke=2.0 * reach,
        top_speed=reach * absolute(speed),
        top_acceleration=reach * square,
    )


@record
class Oldham:
    """An Oldham coupling in one position of its shafts."""

    disc_speed: Annotated[TurnRate, "Angular velocity of the disc: that of both shafts [rad/s]."]
    largest_slip: Annotated[Speed, "Largest sliding speed in either slot [m/s]."]
    slide: Annotated[Size, "Travel of the disc in each slot, from end to end [m]."]
    first_slip: Annotated[Speed, "Sliding speed in the first shaft's slot here [m/s]."]
    second_slip: Annotated[Speed, "Sliding speed in the second shaft's slot here [m/s]."]
    centre: Annotated[PartPoint, "Centre of the disc, from the first shaft towards the second [m]."]
    centre_speed: Annotated[Speed, "Speed of the centre, which goes round twice in a turn [m/s]."]
    centre_acceleration: Annotated[Acceleration, "Acceleration of the centre towards its circle's, 2eω² [m/s^2]."]
    shaking_force: Annotated[Force | None, "Rotating force of the disc's mass, 2meω², twice a turn [N]."]


def oldham(
    *,
    offset: Annotated[Size, "Distance e of the parallel shafts, e.g. 3 mm."],
    speed: Annotated[TurnRate, "Angular velocity ω of the shafts, e.g. 1500 rpm."],
    shaft_angle: Annotated[Angle, "Angle θ of the first slot from the line of the shafts, e.g. 30 deg."] = 0.0,
    mass: Annotated[Mass | None, "Mass m of the disc, e.g. 0.2 kg."] = None,
) -> Oldham:
    """Oldham coupling: two parallel shafts turn alike while the disc between them slides in both slots.

    Equation
    --------
    The centre is e cos θ along the first slot and e sin θ along the second: on the circle over the shafts' distance e
    as its diameter, at 2ω; sliding −eω sin θ and eω cos θ; force 2meω².

    Raises
    ------
    InadmissibleError
        When the distance of the shafts or the mass is negative.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 5.3.

    Examples
    --------
    >>> round(oldham(offset=0.003, speed=157.0, mass=0.2).shaking_force, 6)
    29.5788
    """
    require(offset >= 0.0, "shafts {offset} apart: a distance is not negative", offset=(offset, Size), code="no-length")
    if mass is not None:
        require(mass >= 0.0, "a mass of {mass} is negative", mass=(mass, Mass), code="mass")
    cosine, sine = turned(shaft_angle)
    peak = offset * absolute(speed)
    bend = 2.0 * (offset * (speed * speed))
    along = offset * cosine
    return Oldham(
        disc_speed=speed,
        largest_slip=peak,
        slide=2.0 * offset,
        first_slip=-(offset * sine * speed),
        second_slip=along * speed,
        centre=(along * cosine, along * sine),
        centre_speed=peak,
        centre_acceleration=bend,
        shaking_force=None if mass is None else mass * bend,
    )


@record
class Trammel:
    """A bar whose ends slide on two lines square to each other, and a point of it."""

    position: Annotated[PlanarPosition, "The point P [m]."]
    velocity: Annotated[PartVelocity | None, "Its velocity [m/s]."]
    acceleration: Annotated[PartAcceleration | None, "Its acceleration [m/s^2]."]
    bar_speed: Annotated[TurnRate | None, "Angular velocity φ̇ of the bar, growing φ positive [rad/s]."]
    bar_acceleration: Annotated[AngularAcceleration | None, "Its angular acceleration [rad/s^2]."]
    foot: Annotated[Length, "The end A on the x axis [m]."]
    foot_velocity: Annotated[Speed | None, "Its velocity [m/s]."]
    top: Annotated[Length, "The end B on the y axis [m]."]
    top_velocity: Annotated[Speed | None, "Its velocity [m/s]."]
    centre: Annotated[PlanarPosition, "Instant centre of the bar [m]."]
    along_x: Annotated[Distance, "Half axis of P's ellipse along x [m]."]
    along_y: Annotated[Distance, "Half axis along y [m]."]


def trammel(
    *,
    bar: Annotated[Distance, "Length L of the bar between its sliding ends, e.g. 5 m."],
    angle: Annotated[Angle, "Angle φ of the bar from the x axis, at its end A there, e.g. 60 deg."],
    point: Annotated[Length, "Distance p of the point P from A towards B, e.g. 2 m."] = 0.0,
    speed: Annotated[TurnRate | None, "Angular velocity φ̇ of the bar, e.g. -0.3 rad/s."] = None,
    angular_acceleration: Annotated[AngularAcceleration, "Its angular acceleration [rad/s^2]."] = 0.0,
    pull: Annotated[Speed | None, "Or the velocity of the end A along x, e.g. 0.5 m/s."] = None,
    pull_acceleration: Annotated[Acceleration, "Acceleration of A along x [m/s^2]."] = 0.0,
) -> Trammel:
    """Elliptic trammel, or a ladder that slides down a wall: every point of the bar goes along an ellipse.

    Equation
    --------
    P = ((L − p) cos φ, p sin φ), half axes |L − p| and |p|; instant centre (L cos φ, L sin φ); with A pulled at v:
    φ̇ = −v/(L sin φ), φ̈ = −(dv/dt + Lφ̇² cos φ)/(L sin φ).

    Raises
    ------
    InadmissibleError
        When the bar is not longer than zero, both drives are given, or A is pulled while the bar lies along its slide.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 5.3 and 5.4.

    Examples
    --------
    >>> round(trammel(bar=5.0, angle=0.9272952180016122, pull=1.0).top_velocity, 9)
    -0.75
    """
    require_long("bar", bar)
    require(
        speed is None or pull is None,
        "the bar's angular velocity and the velocity of its end are both given",
        code="exclusive",
        hint="give --speed or --pull",
    )
    cosine, sine = turned(angle)
    foot, top = bar * cosine, bar * sine
    rate, bend = speed, angular_acceleration
    if pull is not None:
        require(
            absolute(sine) > IN_LINE,
            "the bar lies along the slide of A: pulling there cannot turn it",
            code="in-line",
            hint="give another angle, or --speed",
        )
        rate = -(pull / top)
        bend = -((pull_acceleration + foot * rate * rate) / top)
    rest = bar - point
    shape: dict[str, Any] = {
        "position": (rest * cosine, point * sine), "foot": foot, "top": top, "centre": (foot, top),
        "along_x": maximum(rest, -rest), "along_y": maximum(point, -point),
    }  # fmt: skip
    if rate is None:
        return Trammel(velocity=None, acceleration=None, bar_speed=None, bar_acceleration=None, foot_velocity=None,
                       top_velocity=None, **shape)  # fmt: skip
    square = rate * rate
    run, pulled = (-(top * rate), -(foot * square + top * bend)) if pull is None else (pull, pull_acceleration)
    ratio = rest / bar
    return Trammel(
        velocity=(ratio * run, point * cosine * rate),
        acceleration=(ratio * pulled, point * (cosine * bend - sine * square)),
        bar_speed=rate,
        bar_acceleration=bend,
        foot_velocity=run,
        top_velocity=foot * rate,
        **shape,
    )
