"""A slide from the separation to rest with its spin, or the motion at the separation from the rest."""

from dynamics_cli.errors import require, worded
from dynamics_cli.impact.conventions import AXES, Axes, conventions, direction_of
from dynamics_cli.impact.slide.back import Root, Target, roots
from dynamics_cli.impact.slide.marks import marks, points
from dynamics_cli.impact.slide.motion import TOLERANCE, Moment, Run, run
from dynamics_cli.impact.slide.records import AtRest, Ground, Separation, SlideResult, SlideRoot
from dynamics_cli.impact.slide.wheels import INFINITE, NAMES, Car, State, Verge, Wheel
from dynamics_cli.numerics.elementary import atan2, hypot
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.road.drag import friction_advice, speed_advice
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    AngularSpeed,
    Annotated,
    Distance,
    Fraction,
    Friction,
    Gravity,
    Heading,
    Mass,
    PlanarPosition,
    Positive,
    RoadSpeed,
)
from dynamics_cli.records import Advice, Check, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

ORIGIN = (0.0, 0.0)
RIGHT_ANGLE = 1.5707963267948966
ENERGY = 1e-6
SIDEWAYS = 0.35
# Two turns a second, in rad/s.
FASTEST_SPIN = 12.566370614359172


def slide(
    *,
    motion: Annotated[Separation | AtRest, "The motion at the separation, or the rest that it led to."],
    front_axle: Annotated[Distance, "Distance from the mass centre ahead to the front axle, e.g. 1.2 m [m]."],
    rear_axle: Annotated[Distance, "Distance from the mass centre back to the rear axle, e.g. 1.4 m [m]."],
    track: Annotated[Distance, "Distance between the left and the right wheels, e.g. 1.5 m [m]."],
    radius_of_gyration: Annotated[Distance, "Radius of gyration of yaw, e.g. 1.35 m [m]."],
    friction: Annotated[Friction, "Coefficient of friction of a sliding tyre, e.g. 0.7 [-]."],
    braking: Annotated[
        Fraction, "Share of its friction that a wheel's rotation is braked with: 100 % locked, 2 % rolling [-]."
    ],
    nose: Annotated[Heading, "Heading of the nose at the separation, e.g. 20 deg [rad]."] = 0.0,
    left_front: Annotated[Fraction | None, "The same share of the left front wheel, where it differs [-]."] = None,
    right_front: Annotated[Fraction | None, "Of the right front wheel [-]."] = None,
    left_rear: Annotated[Fraction | None, "Of the left rear wheel [-]."] = None,
    right_rear: Annotated[Fraction | None, "Of the right rear wheel [-]."] = None,
    grip_slope: Annotated[
        Positive,
        "Slip angle (tangent) from which a rolling tyre slides: μ/c of its cornering stiffness c per load [-].",
    ] = 0.1,
    steer: Annotated[Angle, "Steer of the front wheels, counted like headings [rad]."] = 0.0,
    place: Annotated[PlanarPosition, "Where the mass centre is at the separation [m]."] = ORIGIN,
    grounds: Annotated[tuple[Ground, ...], "Grounds of another friction; the last one counts."] = (),
    mass: Annotated[Mass | None, "Mass, for the energy in numbers [kg]."] = None,
    axes: Annotated[Axes, "Axes of positions and headings: mathematical, compass, sae or iso."] = AXES,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> SlideResult:
    """Where and how a car comes to rest after an impact, turning on wheels that are locked or roll; or back from rest.

    Equation
    --------
    m dV/dt = Σ F, m k² dω/dt = Σ r × F; of a wheel with the slip l along and across it:
    F_x = −s μN l_x/|l|, F_y = −√(1 − s²) μN l_y/√(l_y² + (τ l_x)²), locked (s = 1): −μN l/|l|.

    Returns
    -------
    SlideResult
        Rest position and nose, time, path and wheel marks; from a rest, the motion at the separation that led there.

    Raises
    ------
    InadmissibleError
        When no wheel brakes, the car neither moves nor turns, or no slide of these wheels ends at the rest given.

    Notes
    -----
    The law of a wheel is a choice of this program: never more than μN, saturated beyond the grip slope. Wheel loads are
    static: the transfer of load is left out, which on dry roads moves some hundred millimetres. Integrated in a
    stretched time, λ = ln(σ₀/σ) with σ² = V² + k²ω², in which the stop is at infinity and nothing is singular there.

    References
    ----------
    Newton and Euler in the plane with Coulomb friction at four wheels; derived, and checked by extrapolated integration
    in 30 digits.

    Examples
    --------
    >>> found = slide(motion=Separation(12.0, 0.5235987755982988, 3.0), front_axle=1.2, rear_axle=1.4, track=1.5,
    ...               radius_of_gyration=1.35, friction=0.7, braking=1.0)
    >>> [round(part, 4) for part in found.rest_position], found.turned_about
    ([9.5634, 5.6008], 'right front')
    """
    shares = [braking if one is None else one for one in (left_front, right_front, left_rear, right_rear)]
    car = car_of(
        front_axle, rear_axle, track, radius_of_gyration, friction, shares, grip_slope, steer, gravity, grounds, axes
    )
    if isinstance(motion, AtRest):
        ways = roots(car, target_of(motion, nose, place, axes))
        done, start = ways[0].run, ways[0]
    else:
        ways = []
        state = moving(motion, nose, place, axes)
        start = Root((state.vx, state.vy, car.gyration * state.spin), car, Run())
        done = run(car, state, TOLERANCE)
    return _answer(car, start, done, ways, axes, place, nose, mass)


def shares_of(given: "Mapping[str, Any]") -> "list[float]":
    """The braking of each wheel: that of the car, where the wheel has none of its own."""
    own = (given.get(name.replace(" ", "_")) for name in NAMES)
    return [given["braking"] if one is None else one for one in own]


def start_of(motion: Separation | SlideRoot, nose: float, place: "tuple[float, float]", axes: Axes) -> State:
    """The state of a car that sets out so."""
    x, y = direction_of(motion.course, axes)
    return State(*place, heading_angle(nose, axes), motion.speed * x, motion.speed * y, motion.spin)


def moving(motion: Separation, nose: float, place: "tuple[float, float]", axes: Axes) -> State:
    """The state of a car that sets out so; refuses one that stands."""
    require(
        motion.speed > 0.0 or motion.spin != 0.0,
        "the car neither moves nor turns: there is no slide", code="no-motion",
    )  # fmt: skip
    return start_of(motion, nose, place, axes)


def target_of(motion: AtRest, nose: float, place: "tuple[float, float]", axes: Axes) -> Target:
    """Where a car has come to rest from its separation; refuses one that was there already."""
    begin = heading_angle(nose, axes)
    target = Target(place, begin, motion.rest, begin + _sense(axes) * (motion.rest_nose - nose))
    require(
        target.distance > 0.0 or target.turn != 0.0,
        "the car neither moved nor turned: there was no slide", code="no-motion",
    )  # fmt: skip
    return target


def car_of(
    front_axle: float,
    rear_axle: float,
    track: float,
    gyration: float,
    friction: float,
    shares: "list[float]",
    grip_slope: float,
    steer: float,
    gravity: float,
    grounds: "tuple[Ground, ...]" = (),
    axes: Axes = AXES,
) -> Car:
    """A car with static wheel loads; refuses one that nothing slows."""
    wheelbase = front_axle + rear_axle
    require(
        front_axle > 0.0 and rear_axle > 0.0, "the mass centre is not between the axles: {front} to the front and "
        "{rear} to the rear", front=(front_axle, Distance), rear=(rear_axle, Distance), code="no-wheelbase",
    )  # fmt: skip
    longest = max(wheelbase, track)
    require(
        0.0 < gyration <= longest, "the radius of gyration of {gyration} is not between zero and {longest}, the longer "
        "of wheelbase and track", gyration=(gyration, Distance), longest=(longest, Distance), code="no-inertia",
        hint="of cars it is about half the wheelbase: check its unit",
    )  # fmt: skip
    require(
        friction > 0.0 and all(one.friction > 0.0 for one in grounds),
        "a friction is zero: the car does not come to rest", code="no-friction",
    )  # fmt: skip
    require(
        max(shares) > 0.0,
        "no wheel brakes: a car that rolls without drag does not come to rest",
        code="no-drag",
        hint="a rolling wheel has about 2 %: --braking 2%",
    )
    sense = -1.0 if axes == "sae" else 1.0
    turned = _sense(axes) * steer
    half = 0.5 * track * sense
    wheels = [
        Wheel(front_axle, half, 0.5 * rear_axle / wheelbase, shares[0], grip_slope, turned),
        Wheel(front_axle, -half, 0.5 * rear_axle / wheelbase, shares[1], grip_slope, turned),
        Wheel(-rear_axle, half, 0.5 * front_axle / wheelbase, shares[2], grip_slope, 0.0),
        Wheel(-rear_axle, -half, 0.5 * front_axle / wheelbase, shares[3], grip_slope, 0.0),
    ]
    edges = [_verge(one, sense) for one in grounds]
    return Car(wheels, gyration, friction, gravity, edges)


def _verge(ground: Ground, sense: float) -> Verge:
    """The ground beyond an edge; in sae axes, seen from above, left is the other side of the line."""
    require(
        ground.edge_from != ground.edge_to, "both points of an edge are the same: it has no direction", code="no-edge"
    )
    require(ground.width is None or ground.width > 0.0, "a strip of ground has no width", code="no-width")
    ends = (ground.edge_from, ground.edge_to) if sense > 0.0 else (ground.edge_to, ground.edge_from)
    return Verge(*ends, ground.friction, INFINITE if ground.width is None else ground.width, patch=ground.patch)


def _sense(axes: Axes) -> float:
    """The sign of headings as angles from x to y."""
    return -1.0 if axes == "compass" else 1.0


def heading_angle(heading: float, axes: Axes) -> float:
    """A heading as an angle from x to y, whole turns counted."""
    return RIGHT_ANGLE - heading if axes == "compass" else heading


def _answer(
    car: Car, start: Root, done: Run, ways: "list[Root]", axes: Axes, place: "tuple[float, float]", nose: float,
    mass: float | None,
) -> SlideResult:  # fmt: skip
    begin, kinetic, taken = done.moments[0], energy_of(start), sum(done.end.work)
    found = roots_of(ways, axes)
    numbers = numbers_of(car, start, done.end, found, axes, place, nose, mass)
    return SlideResult(
        **numbers,
        turned_about=None if done.about is None else NAMES[done.about],
        wheels=marks(car, done),
        path=points(done, lambda angle: nose + _sense(axes) * (angle - begin.nose)),
        roots=found,
        conventions=conventions(axes, None),
        numerics=Numerics(
            f"stretched time, variable order and step, {done.steps} steps to 1e-8; places within an estimated "
            "1e-6 of the path"
        ),
        checks=(Check("work of the tyres", abs(taken / kinetic - 1.0) <= ENERGY, abs(taken / kinetic - 1.0), ENERGY),),
        advice=_typed(car, hypot(*start.velocity)) + spin_advice(start.spin) + _advice(numbers["bend"], found),
    )  # fmt: skip


def energy_of(start: Root) -> float:
    """Kinetic energy per mass."""
    return 0.5 * sum(part * part for part in start.unknowns)


def numbers_of(
    car: Car, start: Root, end: Moment, found: "tuple[SlideRoot, ...]", axes: Axes, place: "tuple[float, float]",
    nose: float, mass: float | None,
) -> "dict[str, Any]":  # fmt: skip
    """The numbers of an answer, by the name of the result."""
    turned = _sense(axes) * (end.nose - heading_angle(nose, axes))
    speed = hypot(*start.velocity)
    way = end.x - place[0], end.y - place[1]
    straight = hypot(*way)
    bend = None
    if speed > 0.0 and straight > 0.0:
        (vx, vy) = start.velocity
        bend = _sense(axes) * atan2(vx * way[1] - vy * way[0], vx * way[0] + vy * way[1])
    first = found[0] if found else None
    return {
        "speed": None if first is None else first.speed,
        "course": None if first is None else first.course,
        "spin": None if first is None else first.spin,
        "rest_position": (end.x, end.y),
        "rest_heading": nose + turned,
        "turned": turned,
        "time": end.time,
        "path_length": end.path,
        "straight_distance": straight,
        "bend": bend,
        "mean_share": 0.5 * speed * speed / (car.friction * car.gravity * end.path) if end.path > 0.0 else None,
        "energy": None if mass is None else mass * energy_of(start),
    }


def roots_of(ways: "list[Root]", axes: Axes) -> "tuple[SlideRoot, ...]":
    """Motions at the separation as results have them."""
    listed = []
    for one in ways:
        (x, y) = one.velocity
        course = atan2(x, y) if axes == "compass" else atan2(y, x)
        listed.append(SlideRoot(hypot(x, y), course, one.spin))
    return tuple(listed)


def _typed(car: Car, speed: float) -> "tuple[Advice, ...]":
    """Advice on friction and a speed that are most often slips of the pen."""
    beyond = speed_advice(speed, "a speed at the separation", "check the speed, or the rest position and its unit")
    return friction_advice(car.friction) + beyond


def spin_advice(spin: float) -> "tuple[Advice, ...]":
    """Advice when a car turns faster than cars do: most often whole turns miscounted."""
    if not abs(plain(spin)) > FASTEST_SPIN:
        return ()
    message = worded(
        "a car that turns at {spin:4} turns faster than crashes make cars turn", spin=(abs(spin), AngularSpeed)
    )
    remedy = "check the whole turns of the nose at rest, and its unit"
    return (Advice(code="fast-spin", message=message, remedy=remedy),)


def _advice(bend: float | None, found: "tuple[SlideRoot, ...]") -> "tuple[Advice, ...]":
    notes: list[Advice] = []
    if bend is not None and abs(bend) > SIDEWAYS / 4.0:
        text = worded(
            "the straight line to rest is {bend:3} off the course at the separation: it is not the exit heading",
            bend=(abs(bend), Angle),
        )
        notes.append(Advice("bent-path", text, severity="note", remedy="use the course of this slide in the impact"))
    if len(found) > 1:
        first, other = found[0], found[1]
        text = worded(
            "more than one motion ends there: {one:3} at {here:3}, and {two:3} at {there:3}",
            one=(first.speed, RoadSpeed), here=(first.course, Angle), two=(other.speed, RoadSpeed),
            there=(other.course, Angle),
        )  # fmt: skip
        notes.append(Advice("several-roots", text, remedy="tyre marks near the impact decide between them (see roots)"))
    return tuple(notes)
