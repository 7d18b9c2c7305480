"""Results of an impact in space, and its checks."""

from dynamics_cli.impact.conventions import clock
from dynamics_cli.impact.diagnostics import balance, momentum_kept, not_above
from dynamics_cli.impact.spatial.arithmetic import angle, fused, length, root
from dynamics_cli.impact.spatial.bodies import Matrix, SolidInSpace, Vector, combine, nothing
from dynamics_cli.impact.spatial.straight_slip import End, stick_ratio
from dynamics_cli.numerics.vectors import add, cross, dot, scale, subtract, times
from dynamics_cli.quantities import (
    Angle,
    AngularVelocity,
    Annotated,
    Energy,
    Impulse,
    ImpulseVector,
    Ratio,
    SpaceVelocity,
    Speed,
    Text,
)
from dynamics_cli.records import Advice, Check, Numerics, record

PI = 3.141592653589793


@record
class AfterSpatial:
    """One body after an impact in space."""

    velocity: Annotated[SpaceVelocity, "Velocity of the mass centre after [m/s]."]
    speed: Annotated[Speed, "Its size [m/s]."]
    spin: Annotated[AngularVelocity, "Angular velocity after [rad/s]."]
    spin_change: Annotated[AngularVelocity, "Change of the angular velocity [rad/s]."]
    delta_v: Annotated[SpaceVelocity | None, "Change of velocity, from the impulse over the mass [m/s]."]
    delta_v_magnitude: Annotated[Speed | None, "Its size [m/s]."]
    pdof: Annotated[
        Angle | None,
        "Where the force came from in the plane x, y: from the nose, clockwise seen from +z; none of a fixed body "
        "[rad].",
    ]
    clock: Annotated[Ratio | None, "The same as the nearest hour on a clock whose 12 is straight ahead [h]."]
    elevation: Annotated[Angle | None, "How far above the plane x, y the force came from [rad]."]
    energy_change: Annotated[Energy, "Change of its kinetic energy; of a fixed body, the work done on it [J]."]


@record
class SpatialImpact:
    """Results of an impact in space."""

    first: Annotated[AfterSpatial, "The first body."]
    second: Annotated[AfterSpatial, "The second body."]
    law: Annotated[Text, "The law these results are by."]
    slip_history: Annotated[Text, "What the contact did."]
    impulse: Annotated[ImpulseVector, "Impulse on the second body; the first gets the opposite [N·s]."]
    impulse_magnitude: Annotated[Impulse, "Its size [N·s]."]
    normal_impulse: Annotated[Impulse, "Its part along the normal [N·s]."]
    tangential_impulse: Annotated[Impulse, "Size of its tangential part [N·s]."]
    impulse_ratio: Annotated[Ratio, "Tangential over normal impulse [-]."]
    stick_friction: Annotated[Ratio, "Friction that holds the contact once slip has stopped [-]."]
    compression_impulse: Annotated[Impulse, "Normal impulse until the greatest compression [N·s]."]
    slip_impulse: Annotated[Impulse, "Normal impulse until the slip first stops, or all of it if it never does [N·s]."]
    closing_speed: Annotated[Speed, "Normal relative speed at the contact before [m/s]."]
    separation_speed: Annotated[Speed, "Normal relative speed at the contact after [m/s]."]
    sliding_before: Annotated[
        SpaceVelocity, "Tangential velocity of the first body relative to the second at the contact before [m/s]."
    ]
    sliding_after: Annotated[SpaceVelocity, "The same after [m/s]."]
    energy_lost: Annotated[Energy, "Kinetic energy turned into other forms [J]."]
    energy_lost_normal: Annotated[Energy, "The part the normal impulse took [J]."]
    energy_lost_tangential: Annotated[Energy, "The part friction took [J]."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


@record
class Solved:
    """The solver's result of an impact in space: the bodies, the frame of the contact, K, u before, and the end."""

    bodies: tuple[SolidInSpace, SolidInSpace]
    frame: Matrix
    k: Matrix
    before: Vector
    end: End
    friction: float
    restitution: float
    law: str
    how: str

    @property
    def lost(self) -> float:
        """Energy that the normal impulse took."""
        if self.law == "stronge":
            return (1 - self.restitution) * (1 + self.restitution) * self.end.work
        return self.end.work - self.end.work_back


def report(solved: Solved) -> SpatialImpact:
    """The answer from the end of the path in the frame of the contact, in the solver's numbers."""
    end, frame, before = solved.end, solved.frame, solved.before
    x, y, z = combine(frame, end.impulse)
    sideways = length(end.impulse[0], end.impulse[1])
    still = before[0] * 0
    return SpatialImpact(
        first=after_impact(solved.bodies[0], (x, y, z)),
        second=after_impact(solved.bodies[1], (0 - x, 0 - y, 0 - z)),
        law=solved.law,
        slip_history=end.history,
        impulse=(0 - x, 0 - y, 0 - z),
        impulse_magnitude=length(sideways, end.impulse[2]),
        normal_impulse=end.impulse[2],
        tangential_impulse=sideways,
        impulse_ratio=sideways / end.impulse[2],
        stick_friction=length(*stick_ratio(solved.k)),
        compression_impulse=end.compression,
        slip_impulse=end.slip_impulse,
        closing_speed=-before[2],
        separation_speed=end.velocity[2],
        sliding_before=combine(frame, (before[0], before[1], still)),
        sliding_after=combine(frame, (end.velocity[0], end.velocity[1], still)),
        energy_lost=solved.lost + end.heat,
        energy_lost_normal=solved.lost,
        energy_lost_tangential=end.heat,
    )


def after_impact(body: SolidInSpace, impulse: Vector) -> AfterSpatial:
    """State of one body after its impulse."""
    change: Vector | None = None
    turned = half = nothing(impulse[0])
    moment = cross(body.lever, impulse)
    after = body.velocity
    came = hours = elevation = size = None
    if body.mass is not None:
        change = impulse[0] / body.mass, impulse[1] / body.mass, impulse[2] / body.mass
        half = change[0] / 2, change[1] / 2, change[2] / 2
        turned = body.turned(moment)
        after = add(body.velocity, change)
        size = root(dot(change, change))
        came = _pdof(impulse, body.nose)
        hours = clock(came)
        elevation = angle(-impulse[2], length(impulse[0], impulse[1]))
    spun = body.spin[0] + turned[0] / 2, body.spin[1] + turned[1] / 2, body.spin[2] + turned[2] / 2
    return AfterSpatial(
        velocity=after,
        speed=root(dot(after, after)),
        spin=add(body.spin, turned),
        spin_change=turned,
        delta_v=change,
        delta_v_magnitude=size,
        pdof=came,
        clock=hours,
        elevation=elevation,
        energy_change=dot(impulse, add(body.velocity, half)) + dot(moment, spun),
    )


def _pdof(impulse: Vector, nose: tuple[float, float]) -> float:
    """Angle from the nose, clockwise seen from above, to where the force came from, in (−π, π]."""
    x, y = 0 - impulse[0], 0 - impulse[1]
    direction = angle(fused(x, nose[1], -(y * nose[0])), fused(x, nose[0], y * nose[1]))
    return direction if direction > -PI else PI


State = tuple[SolidInSpace, AfterSpatial]


def certificate(answer: SpatialImpact, solved: Solved) -> tuple[Check, ...]:
    """Momentum, angular momentum, velocities at the contact, energy, friction, no tension, the law's own definition."""
    end, bodies, frame, k, before = solved.end, solved.bodies, solved.frame, solved.k, solved.before
    friction, restitution, law = solved.friction, solved.restitution, solved.law
    size = answer.impulse_magnitude
    states = (bodies[0], answer.first), (bodies[1], answer.second)
    velocities = [body.velocity for body in bodies], [after.velocity for _, after in states]
    checks = momentum_kept([body.mass for body in bodies], *velocities, size)
    for state, name in zip(states, ("first", "second"), strict=True):
        checks += _turning(*state, name, size)
    # velocity change at the contact in the most compliant direction: all components are rounded beside it
    moved = max(k[0][0], k[1][1], k[2][2]) * size
    checks += _contact(states, end, frame, before, moved)
    work = end.work + end.heat + moved * size + abs(answer.first.energy_change) + abs(answer.second.energy_change)
    for body, after in states:
        # the work on a body is that on its mass centre plus that on its spin, which may cancel
        reach = root(dot(body.lever, body.lever))
        turning = root(dot(body.spin, body.spin)) + root(dot(after.spin, after.spin))
        work += size * (root(dot(body.velocity, body.velocity)) + after.speed + reach * turning)
    gained = answer.first.energy_change + answer.second.energy_change
    checks += balance("energy", gained, -answer.energy_lost, work)
    if restitution <= 1.0:
        checks += not_above("no energy is gained", -answer.energy_lost, 0.0, work)
    checks += not_above("no tension", -answer.normal_impulse, 0.0, size)
    limit = friction * answer.normal_impulse
    checks += not_above("friction at most μ times the normal impulse", answer.tangential_impulse, limit, size)
    name = f"restitution as {law} defines it"
    if law == "newton":
        return checks + balance(name, end.velocity[2], -restitution * before[2], abs(before[2]))
    if law == "poisson":
        back = end.impulse[2] - end.compression
        return checks + balance(name, back, restitution * end.compression, end.impulse[2])
    return checks + balance(name, end.work_back, restitution * restitution * end.work, end.work)


def _turning(body: SolidInSpace, after: AfterSpatial, name: str, size: float) -> tuple[Check, ...]:
    """Angular momentum of a body about the contact, where the impulse has no moment."""
    if body.mass is None or body.inertia is None:
        return ()
    start = add(times(body.inertia, body.spin), scale(body.mass, cross(body.velocity, body.lever)))
    end = add(times(body.inertia, after.spin), scale(body.mass, cross(after.velocity, body.lever)))
    reach = root(dot(body.lever, body.lever))
    largest = reach * size + root(dot(start, start)) + reach * body.mass * root(dot(body.velocity, body.velocity))
    # the rounding of the spin, magnified about the long axes of a slender body
    largest += max(body.inertia[0][0], body.inertia[1][1], body.inertia[2][2]) * root(dot(after.spin, after.spin))
    apart = subtract(start, end)
    return balance(f"angular momentum of the {name} about the contact", root(dot(apart, apart)), 0.0, largest)


def _contact(states: tuple[State, State], end: End, frame: Matrix, before: Vector, least: float) -> tuple[Check, ...]:
    """Velocities after, taken to the contact, give the relative velocity that the path ended with."""
    moved = [add(after.velocity, cross(after.spin, body.lever)) for body, after in states]
    relative = subtract(moved[0], moved[1])
    speeds = least + abs(before[2]) + length(before[0], before[1])
    for (body, after), velocity in zip(states, moved, strict=True):
        reach = root(dot(body.lever, body.lever))
        speeds += root(dot(velocity, velocity)) + reach * (
            root(dot(body.spin, body.spin)) + root(dot(after.spin, after.spin))
        )
    checks: tuple[Check, ...] = ()
    for axis, value, name in zip(frame, end.velocity, ("slip 1", "slip 2", "separation"), strict=True):
        checks += balance(f"{name} at the contact", dot(relative, axis), value, speeds)
    return checks
