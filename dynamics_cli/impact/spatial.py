"""Impact of two rigid bodies in space, with friction: Keller's equations to the end that the law sets."""

from dynamics_cli.errors import require
from dynamics_cli.impact.bodies import Pair
from dynamics_cli.impact.central import contact_advice, require_approach
from dynamics_cli.impact.conventions import ByMass, ByWeight, Energetic, Fixed, Restituted, clock, mass_of, pdof
from dynamics_cli.impact.diagnostics import balance, not_above, require_finite
from dynamics_cli.impact.hodograph import End, stick_ratio, travel
from dynamics_cli.numerics.elementary import hypot, multiply_add, sqrt
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    AngularVelocity,
    Direction,
    Energy,
    Friction,
    Gravity,
    Impulse,
    ImpulseVector,
    InertiaTensor,
    Position,
    Ratio,
    RoadSpeed,
    Speed,
    Text,
    Velocity,
)
from dynamics_cli.records import Advice, Check, Choice, ErrorBound, Numerics, record

Vector = tuple[float, float, float]
Matrix = tuple[Vector, Vector, Vector]

# Proved by the references: the march keeps the impulse to this, relative to its size.
TOLERANCE = 1e-12


class SpatialLaw(Choice):
    """What ends an impact in space; the default is Stronge's energetic restitution, which never gains energy.

    stronge: the normal force gives back e² of its work. newton: u_n' = −e u_n. poisson: p_n = (1 + e) p_c.
    """

    names = ("stronge", "newton", "poisson")
    aliases = {"energetic": "stronge", "kinematic": "newton", "kinetic": "poisson"}  # noqa: RUF012


SPATIAL_LAW = SpatialLaw("stronge")


@record
class LeverInSpace:
    """The contact by its place relative to the mass centre.

    Parameters
    ----------
    lever : Position
        From the mass centre to the contact, along the axes of the scene [m].
    """

    lever: Position


@record
class PlacedInSpace:
    """The contact by where the mass centre is; the contact point is then given for the scene.

    Parameters
    ----------
    centre : Position
        Place of the mass centre in the scene [m].
    """

    centre: Position


@record
class BodyInSpace:
    """A rigid body that moves in space.

    Parameters
    ----------
    bulk : ByMass | ByWeight
        Its mass or its weight.
    inertia : InertiaTensor
        Its inertia about the mass centre, along the axes of the scene [kg·m²].
    arm : LeverInSpace | PlacedInSpace
        Where it is struck.
    velocity : Velocity
        Velocity of the mass centre before [m/s].
    spin : AngularVelocity
        Angular velocity before [rad/s].
    nose : Direction
        Direction of its nose, for PDOF; its direction of travel when left out.
    """

    bulk: ByMass | ByWeight
    inertia: InertiaTensor
    arm: LeverInSpace | PlacedInSpace
    velocity: Velocity = (0.0, 0.0, 0.0)
    spin: AngularVelocity = (0.0, 0.0, 0.0)
    nose: Direction | None = None


@record
class TargetInSpace:
    """The other rigid body, or a fixed barrier, which needs neither inertia nor lever.

    Parameters
    ----------
    bulk : ByMass | ByWeight | Fixed
        Its mass or its weight, or that it is fixed.
    inertia : InertiaTensor
        Its inertia about the mass centre, along the axes of the scene [kg·m²].
    arm : LeverInSpace | PlacedInSpace
        Where it is struck.
    velocity : Velocity
        Velocity of the mass centre before [m/s].
    spin : AngularVelocity
        Angular velocity before [rad/s].
    nose : Direction
        Direction of its nose, for PDOF; its direction of travel when left out.
    """

    bulk: ByMass | ByWeight | Fixed
    inertia: InertiaTensor | None = None
    arm: LeverInSpace | PlacedInSpace | None = None
    velocity: Velocity = (0.0, 0.0, 0.0)
    spin: AngularVelocity = (0.0, 0.0, 0.0)
    nose: Direction | None = None


@record
class AfterSpatial:
    """One body after an impact in space.

    Parameters
    ----------
    velocity : Velocity
        Velocity of the mass centre after [m/s].
    speed : RoadSpeed
        Its size [m/s].
    spin : AngularVelocity
        Angular velocity after [rad/s].
    spin_change : AngularVelocity
        Change of the angular velocity [rad/s].
    delta_v : Velocity
        Change of velocity, from the impulse over the mass [m/s].
    delta_v_magnitude : RoadSpeed
        Its size [m/s].
    pdof : Angle
        Where the force came from in the plane x, y: from the nose, clockwise seen from +z; none of a fixed body [rad].
    clock : Ratio
        The same as the nearest hour on a clock whose 12 is straight ahead [h].
    elevation : Angle
        How far above the plane x, y the force came from [rad].
    energy_change : Energy
        Change of its kinetic energy; of a fixed body, the work done on it [J].
    """

    velocity: Velocity
    speed: RoadSpeed
    spin: AngularVelocity
    spin_change: AngularVelocity
    delta_v: Velocity | None
    delta_v_magnitude: RoadSpeed | None
    pdof: Angle | None
    clock: Ratio | None
    elevation: Angle | None
    energy_change: Energy


@record
class SpatialImpact:
    """What an impact in space did.

    Parameters
    ----------
    first : AfterSpatial
        The first body.
    second : AfterSpatial
        The second body.
    law : Text
        The law these results are by.
    slip_history : Text
        What the contact did.
    impulse : ImpulseVector
        Impulse on the second body; the first gets the opposite [N·s].
    impulse_magnitude : Impulse
        Its size [N·s].
    normal_impulse : Impulse
        Its part along the normal [N·s].
    tangential_impulse : Impulse
        Size of its part across [N·s].
    impulse_ratio : Ratio
        Tangential over normal impulse [-].
    stick_friction : Ratio
        Friction that holds the contact once slip has stopped [-].
    compression_impulse : Impulse
        Normal impulse until the greatest compression [N·s].
    slip_impulse : Impulse
        Normal impulse until the first slip stopped, or all of it when it never did [N·s].
    closing_speed : RoadSpeed
        Normal relative speed at the contact before [m/s].
    separation_speed : Speed
        Normal relative speed at the contact after [m/s].
    sliding_before : Velocity
        Tangential velocity of the first body relative to the second at the contact before [m/s].
    sliding_after : Velocity
        The same after [m/s].
    energy_lost : Energy
        Kinetic energy turned into other forms [J].
    energy_lost_normal : Energy
        The part the normal impulse took [J].
    energy_lost_tangential : Energy
        The part friction took [J].
    """

    first: AfterSpatial
    second: AfterSpatial
    law: Text
    slip_history: Text
    impulse: ImpulseVector
    impulse_magnitude: Impulse
    normal_impulse: Impulse
    tangential_impulse: Impulse
    impulse_ratio: Ratio
    stick_friction: Ratio
    compression_impulse: Impulse
    slip_impulse: Impulse
    closing_speed: RoadSpeed
    separation_speed: Speed
    sliding_before: Velocity
    sliding_after: Velocity
    energy_lost: Energy
    energy_lost_normal: Energy
    energy_lost_tangential: Energy
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def spatial(
    *,
    first: BodyInSpace,
    second: TargetInSpace,
    normal: Direction,
    friction: Friction,
    contact: Restituted | Energetic,
    law: SpatialLaw = SPATIAL_LAW,
    contact_point: Position | None = None,
    gravity: Gravity = STANDARD_GRAVITY,
) -> SpatialImpact:
    """Two rigid bodies in space, or one and a fixed barrier, meet at a point with friction and restitution.

    Equation
    --------
    du = K (−μ u_t/|u_t|, 1) dp_n while the contact slips; p_t = −K_tt⁻¹ k_tn p_n while it sticks, which needs
    |K_tt⁻¹ k_tn| ≤ μ; K = Σ (1/m − [r] J⁻¹ [r]); end by the law.

    Parameters
    ----------
    first : BodyInSpace
        The first body.
    second : TargetInSpace
        The second body, or a fixed barrier.
    normal : Direction
        Contact normal from the first body to the second, of any length.
    friction : Friction
        Coefficient of friction at the contact [-].
    contact : Restituted | Energetic
        Coefficient of restitution in the sense of the law, or the ratio of a contact that gives energy.
    law : SpatialLaw
        What ends the impact: stronge, newton or poisson.
    contact_point : Position
        Where the bodies touch, when bodies are placed by their centres [m].
    gravity : Gravity
        Acceleration of gravity, for bodies given by weight [m/s^2].

    Returns
    -------
    SpatialImpact
        Velocities and spins after, impulses, ΔV, slip history, energies.

    Raises
    ------
    InadmissibleError
        When the bodies do not approach at the contact, a tensor is no inertia, or the law gains energy.

    Notes
    -----
    The slip turns while it lasts. Its equations are marched by Taylor series of order 24 in τ, dp_n = |u_t| dτ: regular
    where slip nearly stops, and where a contact jams, so that the normal velocity is not monotone. After slip has
    stopped all is linear: it sticks, or slips along the one way out. Impulses are good to 1e-12 of their size.

    References
    ----------
    J. B. Keller, Impact with friction, J. Appl. Mech. 53 (1986); W. J. Stronge, Impact Mechanics (2000), chapter 4.

    Examples
    --------
    >>> sphere = ((0.4, 0.0, 0.0), (0.0, 0.4, 0.0), (0.0, 0.0, 0.4))
    >>> ball = BodyInSpace(ByMass(1.0), sphere, LeverInSpace((0.0, 0.0, -1.0)), (1.0, 0.0, -2.0))
    >>> floor = TargetInSpace(Fixed(True))
    >>> hit = spatial(first=ball, second=floor, normal=(0.0, 0.0, -1.0), friction=0.1, contact=Restituted(0.5))
    >>> round(hit.normal_impulse, 12), round(hit.tangential_impulse, 12), hit.slip_history
    (3.0, 0.3, 'slip')
    """
    length = hypot(hypot(normal[0], normal[1]), normal[2])
    require(length > 0.0, "the normal is the zero vector: it has no direction", code="no-normal")
    inward = -normal[0] / length, -normal[1] / length, -normal[2] / length
    one = _solid(first, contact_point, gravity, "the first body")
    two = _solid(second, contact_point, gravity, "the second body")
    frame = _frame(inward)
    relative = _difference(one.contact_velocity(), two.contact_velocity())
    before = dot(relative, frame[0]), dot(relative, frame[1]), dot(relative, frame[2])
    require_approach(-before[2])
    k = _mobility((one, two), frame)
    restitution = contact.restitution
    end = travel(k, before, friction, restitution, str(law))
    lost = _normal_lost(end, restitution, str(law))
    require_finite(end.impulse[2] * before[2], "the energy of the impact")
    scale = end.work + end.heat
    require(
        restitution > 1.0 or lost + end.heat >= -1e-11 * scale,
        f"{law}: the law gains {{0:.6g}} J of energy here, which no passive contact does",
        -(lost + end.heat),
        code="energy-gained",
        hint="--law stronge never gains energy",
    )
    on_first = combine(frame, end.impulse)
    on_second = -on_first[0], -on_first[1], -on_first[2]
    sideways = hypot(end.impulse[0], end.impulse[1])
    stick = stick_ratio(k)
    answer = SpatialImpact(
        first=_after(one, on_first),
        second=_after(two, on_second),
        law=str(law),
        slip_history="slip without friction" if friction == 0.0 else end.history,
        impulse=on_second,
        impulse_magnitude=hypot(sideways, end.impulse[2]),
        normal_impulse=end.impulse[2],
        tangential_impulse=sideways,
        impulse_ratio=sideways / end.impulse[2],
        stick_friction=hypot(*stick),
        compression_impulse=end.compression or 0.0,
        slip_impulse=end.slip_impulse,
        closing_speed=-before[2],
        separation_speed=end.velocity[2],
        sliding_before=combine(frame, (before[0], before[1], 0.0)),
        sliding_after=combine(frame, (end.velocity[0], end.velocity[1], 0.0)),
        energy_lost=lost + end.heat,
        energy_lost_normal=lost,
        energy_lost_tangential=end.heat,
        advice=contact_advice(contact),
        numerics=_numerics(end, one, two),
    )
    checks = _checks(answer, end, (one, two), frame, friction, restitution, str(law), before)
    return SpatialImpact(**{**answer.__dict__, "checks": checks})


class _Solid:
    """A body as the contact sees it; `mass` is None when it is fixed."""

    __slots__ = ("inertia", "inverse", "lever", "mass", "nose", "spin", "velocity")

    def __init__(
        self, mass: float | None, inertia: Matrix | None, lever: Vector, velocity: Vector, spin: Vector, nose: Pair
    ) -> None:
        self.mass = mass
        self.inertia = inertia
        self.inverse = None if inertia is None else _inverse(inertia)
        self.lever = lever
        self.velocity = velocity
        self.spin = spin
        self.nose = nose

    def contact_velocity(self) -> Vector:
        """Velocity of the body's point at the contact."""
        return _sum(self.velocity, cross(self.spin, self.lever))

    def answer(self, impulse: Vector) -> Vector:
        """Change of velocity at the contact from an impulse there."""
        if self.mass is None or self.inverse is None:
            return 0.0, 0.0, 0.0
        turned = cross(times(self.inverse, cross(self.lever, impulse)), self.lever)
        return _sum(turned, (impulse[0] / self.mass, impulse[1] / self.mass, impulse[2] / self.mass))


def _solid(body: BodyInSpace | TargetInSpace, contact: Vector | None, gravity: float, name: str) -> _Solid:
    nose = _nose(body.nose, body.velocity)
    if isinstance(body.bulk, Fixed):
        require(body.bulk.fixed, name + " has neither mass nor weight and is not fixed", code="no-mass")
        lever = (0.0, 0.0, 0.0) if body.arm is None else _lever(body.arm, contact, name)
        return _Solid(None, None, lever, body.velocity, body.spin, nose)
    mass = mass_of(body.bulk, gravity, name)
    require(body.inertia is not None, name + " has no inertia", code="no-inertia", hint="give its inertia tensor")
    require(body.arm is not None, name + " has no lever to the contact", code="no-lever", hint="give its lever")
    inertia: Matrix = body.inertia  # type: ignore[assignment]
    (a, b, c), (_, d, e), (_, _, f) = inertia
    minor = multiply_add(a, d, -(b * b))
    require(
        a > 0.0 and minor > 0.0 and _determinant(inertia) > 0.0,
        name + " has a tensor that is no inertia: its principal moments are not all above zero",
        code="no-inertia",
    )
    require(
        a + d >= f * (1.0 - 1e-9) and a + f >= d * (1.0 - 1e-9) and d + f >= a * (1.0 - 1e-9),
        name + " has a tensor that no body has: one moment exceeds the sum of the other two",
        code="no-inertia",
        hint="check the signs and the axes of the tensor",
    )
    del c, e
    return _Solid(mass, inertia, _lever(body.arm, contact, name), body.velocity, body.spin, nose)  # type: ignore[arg-type]


def _lever(arm: LeverInSpace | PlacedInSpace, contact: Vector | None, name: str) -> Vector:
    if isinstance(arm, LeverInSpace):
        return arm.lever
    require(
        contact is not None,
        name + " is placed by its centre, but the scene has no contact point",
        code="no-contact-point",
        hint='give --contact-point "x, y, z m" in the same axes, or the lever',
    )
    return _difference(contact, arm.centre)  # type: ignore[arg-type]


def _nose(nose: Vector | None, velocity: Vector) -> Pair:
    """Unit vector of the nose in the plane x, y: given, else that of travel, else x."""
    for x, y in [] if nose is None else [nose[:2]]:
        size = hypot(x, y)
        require(size > 0.0, "the nose points along z: it has no direction in the plane", code="no-nose")
        return x / size, y / size
    size = hypot(velocity[0], velocity[1])
    return (velocity[0] / size, velocity[1] / size) if size > 0.0 else (1.0, 0.0)


def dot(a: Vector, b: Vector) -> float:
    """Scalar product."""
    return multiply_add(a[0], b[0], multiply_add(a[1], b[1], a[2] * b[2]))


def cross(a: Vector, b: Vector) -> Vector:
    """Vector product."""
    return (
        multiply_add(a[1], b[2], -(a[2] * b[1])),
        multiply_add(a[2], b[0], -(a[0] * b[2])),
        multiply_add(a[0], b[1], -(a[1] * b[0])),
    )


def times(matrix: Matrix, vector: Vector) -> Vector:
    """Matrix times vector."""
    return dot(matrix[0], vector), dot(matrix[1], vector), dot(matrix[2], vector)


def combine(frame: Matrix, parts: Vector) -> Vector:
    """Sum of the frame's vectors times `parts`."""
    return tuple(sum(part * axis[i] for part, axis in zip(parts, frame, strict=True)) for i in range(3))  # type: ignore[return-value]


def _sum(a: Vector, b: Vector) -> Vector:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def _difference(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _determinant(matrix: Matrix) -> float:
    return dot(matrix[0], cross(matrix[1], matrix[2]))


def _inverse(matrix: Matrix) -> Matrix:
    """Inverse of a symmetric matrix, by cofactors."""
    det = _determinant(matrix)
    rows = cross(matrix[1], matrix[2]), cross(matrix[2], matrix[0]), cross(matrix[0], matrix[1])
    return tuple(tuple(entry / det for entry in row) for row in rows)  # type: ignore[return-value]


def _frame(normal: Vector) -> Matrix:
    """Two tangents and the normal, right-handed; the axis farthest from the normal sets the first tangent."""
    index = min(range(3), key=lambda i: abs(normal[i]))
    axis = tuple(1.0 if i == index else 0.0 for i in range(3))
    tangent = cross(normal, axis)  # type: ignore[arg-type]
    size = sqrt(dot(tangent, tangent))
    first = tangent[0] / size, tangent[1] / size, tangent[2] / size
    return first, cross(normal, first), normal


def _mobility(bodies: tuple[_Solid, _Solid], frame: Matrix) -> Matrix:
    """K in the frame of the contact."""
    rows = []
    for axis in frame:
        moved = _sum(bodies[0].answer(axis), bodies[1].answer(axis))
        rows.append((dot(moved, frame[0]), dot(moved, frame[1]), dot(moved, frame[2])))
    # symmetric but for rounding
    a, b, c = rows
    return a, (a[1], b[1], b[2]), (a[2], b[2], c[2])


def _normal_lost(end: End, restitution: float, law: str) -> float:
    if law == "stronge":
        return (1.0 - restitution) * (1.0 + restitution) * end.work
    return end.work - end.work_back


def _after(body: _Solid, impulse: Vector) -> AfterSpatial:
    """State of one body after its impulse."""
    change: Vector | None = None
    turned = half = 0.0, 0.0, 0.0
    moment = cross(body.lever, impulse)
    after = body.velocity
    angle = hours = elevation = size = None
    if body.mass is not None and body.inverse is not None:
        change = impulse[0] / body.mass, impulse[1] / body.mass, impulse[2] / body.mass
        half = 0.5 * change[0], 0.5 * change[1], 0.5 * change[2]
        turned = times(body.inverse, moment)
        after = _sum(body.velocity, change)
        size = sqrt(dot(change, change))
        angle = pdof((impulse[0], impulse[1]), body.nose)
        hours = clock(angle)
        from dynamics_cli.numerics.elementary import atan2

        elevation = atan2(-impulse[2], hypot(impulse[0], impulse[1]))
    spun = body.spin[0] + 0.5 * turned[0], body.spin[1] + 0.5 * turned[1], body.spin[2] + 0.5 * turned[2]
    return AfterSpatial(
        velocity=after,
        speed=sqrt(dot(after, after)),
        spin=_sum(body.spin, turned),
        spin_change=turned,
        delta_v=change,
        delta_v_magnitude=size,
        pdof=angle,
        clock=hours,
        elevation=elevation,
        energy_change=dot(impulse, _sum(body.velocity, half)) + dot(moment, spun),
    )


def _numerics(end: End, one: _Solid, two: _Solid) -> Numerics:
    names = ["impulse_magnitude", "normal_impulse", "compression_impulse"]
    names += [f"{name}.delta_v_magnitude" for name, body in (("first", one), ("second", two)) if body.mass is not None]
    how = "closed form: the contact does not slip at first" if not end.steps else (
        f"Taylor series of order 24, {end.steps} steps of slip"
    )  # fmt: skip
    return Numerics(how, tuple(ErrorBound(name, TOLERANCE) for name in names))


def _checks(
    answer: SpatialImpact,
    end: End,
    bodies: tuple[_Solid, _Solid],
    frame: Matrix,
    friction: float,
    restitution: float,
    law: str,
    before: Vector,
) -> tuple[Check, ...]:
    """Momentum, angular momentum, velocities at the contact, energy, friction, no tension, the law's own definition."""
    size = answer.impulse_magnitude
    states = (bodies[0], answer.first), (bodies[1], answer.second)
    checks: tuple[Check, ...] = ()
    if all(body.mass is not None for body, _ in states):
        for axis, letter in enumerate("xyz"):
            held = sum(body.mass * body.velocity[axis] for body, _ in states)  # type: ignore[operator]
            left = sum(body.mass * end_.velocity[axis] for body, end_ in states)  # type: ignore[operator]
            scale = size + sum(abs(body.mass * body.velocity[axis]) for body, _ in states)  # type: ignore[operator]
            checks += balance(f"momentum along {letter}", held, left, scale)
    for (body, after), name in zip(states, ("first", "second"), strict=True):
        if body.mass is None or body.inertia is None:
            continue
        reach = sqrt(dot(body.lever, body.lever))
        worst = scale = 0.0
        held = _sum(times(body.inertia, body.spin), _scaled(cross(body.velocity, body.lever), body.mass))
        left = _sum(times(body.inertia, after.spin), _scaled(cross(after.velocity, body.lever), body.mass))
        apart = _difference(held, left)
        worst = sqrt(dot(apart, apart))
        scale = reach * size + sqrt(dot(held, held)) + reach * body.mass * sqrt(dot(body.velocity, body.velocity))
        checks += balance(f"angular momentum of the {name} about the contact", worst, 0.0, scale)
    moved = [_sum(after.velocity, cross(after.spin, body.lever)) for body, after in states]
    relative = _difference(moved[0], moved[1])
    speeds = sum(sqrt(dot(v, v)) for v in moved) + abs(before[2]) + hypot(before[0], before[1])
    speeds += sum(sqrt(dot(b.spin, b.spin)) * sqrt(dot(b.lever, b.lever)) for b in bodies)
    for axis, value, name in zip(frame, end.velocity, ("slip 1", "slip 2", "separation"), strict=True):
        checks += balance(f"{name} at the contact", dot(relative, axis), value, speeds)
    work = end.work + end.heat + abs(answer.first.energy_change) + abs(answer.second.energy_change)
    gained = answer.first.energy_change + answer.second.energy_change
    checks += balance("energy", gained, -answer.energy_lost, work)
    if restitution <= 1.0:
        checks += not_above("energy never gained", -answer.energy_lost, 0.0, work)
    checks += not_above("no tension", -answer.normal_impulse, 0.0, size)
    limit = friction * answer.normal_impulse
    checks += not_above("friction at most μ times the normal impulse", answer.tangential_impulse, limit, size)
    name = f"restitution as {law} defines it"
    if law == "newton":
        return checks + balance(name, answer.separation_speed, restitution * answer.closing_speed, speeds)
    if law == "poisson":
        back = answer.normal_impulse - answer.compression_impulse
        return checks + balance(name, back, restitution * answer.compression_impulse, answer.normal_impulse)
    return checks + balance(name, end.work_back, restitution * restitution * end.work, end.work)


def _scaled(a: Vector, factor: float) -> Vector:
    return a[0] * factor, a[1] * factor, a[2] * factor
