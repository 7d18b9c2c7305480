"""Central impact: two bodies on one line, and the line of impact inside every oblique one."""

from dynamics_cli.errors import (
    require,
    worded,
)
from dynamics_cli.impact.conventions import BodyName, ByMass, ByWeight, Energetic, Fixed, Restituted, mass_of
from dynamics_cli.impact.diagnostics import balance, not_above, require_finite, require_sizes
from dynamics_cli.impact.particles.contact_time import Push, push
from dynamics_cli.impact.particles.hunt_crossley import HuntCrossley
from dynamics_cli.impact.particles.springs import Hertz, Spring
from dynamics_cli.numerics.elementary import absolute, multiply_add, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Annotated,
    Energy,
    Gravity,
    Impulse,
    Mass,
    Ratio,
    Restitution,
    RoadSpeed,
    Speed,
)
from dynamics_cli.records import Advice, Check, record

CLOSING_HINT = "the first body is behind and must be the faster one: exchange the bodies or the signs"


@record
class Collinear:
    """A body on the line of impact."""

    bulk: Annotated[ByMass | ByWeight, "Its mass or its weight."]
    velocity: Annotated[
        Speed | None,
        "Velocity along the line, positive from first to second body; at rest when left out, e.g. 30 mph [m/s].",
    ] = None
    name: BodyName = None


@record
class Struck:
    """The body ahead on the line of impact, which may be fixed."""

    bulk: Annotated[ByMass | ByWeight | Fixed, "Its mass or its weight, or that it is fixed."]
    velocity: Annotated[
        Speed | None,
        "Velocity along the line, positive away from the first body; at rest when left out, e.g. -25 mph [m/s].",
    ] = None
    name: BodyName = None


@record
class AfterCentral:
    """One body after the impact."""

    velocity: Annotated[Speed, "Velocity after [m/s]."]
    delta_v: Annotated[Speed, "Change of velocity, from the impulse over the mass [m/s]."]
    energy_change: Annotated[
        Energy, "Change of the kinetic energy of this body; of a fixed body that moves, the work done on it [J]."
    ]
    mass: Annotated[Mass | None, "Its mass, unless it is fixed [kg]."]


@record
class CentralImpact:
    """Results of a central impact."""

    first: Annotated[AfterCentral, "The first body, which was behind."]
    second: Annotated[AfterCentral, "The second body, ahead of the first."]
    impulse: Annotated[Impulse, "Size of the impulse: it pushes the second body ahead and the first back [N·s]."]
    compression_impulse: Annotated[Impulse, "Its part until the bodies move at one velocity [N·s]."]
    closing_speed: Annotated[Speed, "Relative speed before [m/s]."]
    separation_speed: Annotated[Speed, "Relative speed after [m/s]."]
    common_velocity: Annotated[
        Speed, "Velocity of the mass centre, which both bodies have at the greatest compression [m/s]."
    ]
    reduced_mass: Annotated[Mass, "m₁m₂/(m₁ + m₂) [kg]."]
    energy_lost: Annotated[
        Energy, "Kinetic energy turned into other forms; negative when the contact gives energy [J]."
    ]
    share_lost: Annotated[Ratio, "The same over the kinetic energy of the closing motion, 1 − e² [-]."]
    push: Annotated[Push | None, "Duration and force; needs a stiffness of the contact."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def struck_mass(bulk: ByMass | ByWeight | Fixed, gravity: float, name: str) -> float | None:
    """Mass of a body, None when it is fixed."""
    if isinstance(bulk, Fixed):
        require(bulk.fixed, "{name} has neither mass nor weight and is not fixed", name=name, code="no-mass")
        return None
    return mass_of(bulk, gravity, name)


def reduced_mass(first: float, second: float | None) -> float:
    """Mass m₁m₂/(m₁ + m₂) of the relative motion, without leaving the range; m₁ against a fixed body."""
    if second is None:
        return first
    light, heavy = where(first <= second, first, second), where(first <= second, second, first)
    return light / (1.0 + light / heavy)


def central(
    *,
    first: Annotated[Collinear, "The body behind."],
    second: Annotated[Struck, "The body ahead; at rest unless its velocity or the closing speed says otherwise."],
    contact: Annotated[
        Restituted | Energetic, "Coefficient of restitution, or the ratio of speeds of a contact that gives energy."
    ],
    closing_speed: Annotated[
        RoadSpeed | None,
        "Relative speed before, where it is known better than the difference of two velocities tells [m/s].",
    ] = None,
    force: Annotated[
        Spring | Hertz | HuntCrossley | None, "Stiffness of the contact, for duration and peak force."
    ] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity, for bodies given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> CentralImpact:
    """Two bodies meet head on: velocities after, impulse and energy from masses, velocities and restitution.

    Equation
    --------
    p = (1 + e) m_r u, m_r = m₁m₂/(m₁ + m₂), u = v₁ − v₂; v₁' = v₁ − p/m₁, v₂' = v₂ + p/m₂; loss ½ m_r (1 − e²) u².

    Returns
    -------
    CentralImpact
        Velocities, impulse, closing and separation speed, energies.

    Raises
    ------
    InadmissibleError
        When the bodies separate or keep their distance (no impact), a mass is zero, or the closing speed contradicts
        the velocities.

    Notes
    -----
    Everything follows from the impulse: changes of velocity and the loss are never differences of large numbers. With
    two velocities the closing speed carries their rounding; give it where they are nearly equal.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.10.

    Examples
    --------
    >>> hit = central(first=Collinear(ByMass(2.0), 3.0), second=Struck(ByMass(1.0)), contact=Restituted(0.5))
    >>> hit.first.velocity, hit.second.velocity
    (1.5, 3.0)
    """
    require_sizes(
        first=first, second=second, contact=contact, closing_speed=closing_speed, force=force, gravity=gravity
    )
    mass = mass_of(first.bulk, gravity, "the first body")
    two = struck_mass(second.bulk, gravity, "the second body")
    before, closing = _approach(first.velocity, second.velocity, closing_speed)
    restitution = contact.restitution
    reduced = reduced_mass(mass, two)
    compression = reduced * closing
    impulse = (1.0 + restitution) * compression
    require_finite(impulse * closing, "the energy of the impact")
    lost_share = (1.0 - restitution) * (1.0 + restitution)
    lost = 0.5 * lost_share * (compression * closing)
    fractions = -(reduced / mass), 0.0 if two is None else reduced / two
    changes = -(impulse / mass), 0.0 if two is None else impulse / two
    common, after = velocities_after((mass, two), before, fractions, closing, restitution)
    if closing_speed is not None and first.velocity is not None and second.velocity is not None:
        # the velocities give the closing speed less accurately: each body keeps its own
        after = [
            multiply_add(restitution * lost_share, closing, multiply_add(lost_share, closing, velocity))
            for lost_share, velocity in zip(fractions, before, strict=True)
        ]
    answer = CentralImpact(
        first=AfterCentral(after[0], changes[0], -impulse * (before[0] + 0.5 * changes[0]), mass),
        second=AfterCentral(after[1], changes[1], impulse * (before[1] + 0.5 * changes[1]), two),
        impulse=impulse,
        compression_impulse=compression,
        closing_speed=closing,
        separation_speed=restitution * closing,
        common_velocity=common,
        reduced_mass=reduced,
        energy_lost=lost,
        share_lost=lost_share,
        push=push(force, reduced, closing, restitution),
        advice=contact_advice(contact),
    )
    return CentralImpact(**{**answer.__dict__, "checks": _checks(answer, before, restitution)})


def velocities_after(
    masses: tuple[float, float | None],
    before: tuple[float, float],
    shares: tuple[float, float],
    closing: float,
    restitution: float,
) -> tuple[float, list[float]]:
    """The common velocity of the greatest compression, and both velocities after: on from it by e times the same share.

    Taken from the heavier body, which changes less, so that nothing cancels unless it was nearly equal before.
    """
    m1, m2 = masses
    common = before[1]
    if m2 is not None:
        ends = multiply_add(shares[0], closing, before[0]), multiply_add(shares[1], closing, before[1])
        common = where(m1 > m2, ends[0], where(m1 < m2, ends[1], 0.5 * (ends[0] + ends[1])))
    return common, [multiply_add(restitution * fraction, closing, common) for fraction in shares]


def _approach(first: float | None, second: float | None, closing: float | None) -> tuple[tuple[float, float], float]:
    """Velocities before and the closing speed, from those that are given."""
    ahead: float = 0.0 if first is None else first
    if closing is None:
        other = 0.0 if second is None else second
        closing = ahead - other
    elif second is None:
        other = ahead - closing
    elif first is None:
        other, ahead = second, second + closing
    else:
        other = second
        apart = absolute(ahead - other - closing)
        require(
            apart <= 1e-6 * closing + 4e-16 * (absolute(ahead) + absolute(other)),
            "the velocities differ by {difference:9}, but the closing speed is {closing:9}",
            difference=(ahead - other, Speed),
            closing=(closing, Speed),
            code="contradiction",
            hint="leave out the closing speed or one of the velocities",
        )
    require_approach(closing)
    return (ahead, other), closing


def require_approach(closing: float, hint: str = CLOSING_HINT) -> None:
    """Refuse bodies that do not approach each other."""
    require(
        closing > 0.0,
        "no impact: the bodies do not approach each other, their closing speed is {closing:6}",
        closing=(closing, Speed),
        code="no-impact",
        hint=hint,
    )


def contact_advice(contact: Restituted | Energetic) -> tuple[Advice, ...]:
    """Advice when the contact adds energy."""
    ratio = contact.restitution
    if not single(ratio) or not plain(ratio) > 1.0:
        return ()
    message = worded(
        "the contact adds energy: the bodies separate {ratio} times as fast as they closed", ratio=(ratio, Ratio)
    )
    return (Advice(code="energetic-contact", message=message, severity="note"),)


def _checks(answer: CentralImpact, before: tuple[float, float], restitution: Restitution) -> tuple[Check, ...]:
    first, second = answer.first, answer.second
    momentum: tuple[Check, ...] = ()
    if first.mass is not None and second.mass is not None:
        momenta = first.mass * before[0], second.mass * before[1]
        momentum_after = first.mass * first.velocity + second.mass * second.velocity
        size = absolute(momenta[0]) + absolute(momenta[1]) + answer.impulse
        momentum = balance("momentum", momenta[0] + momenta[1], momentum_after, size)
    speeds = absolute(before[0]) + absolute(before[1]) + answer.closing_speed + answer.separation_speed
    restituted = balance("restitution", second.velocity - first.velocity, restitution * answer.closing_speed, speeds)
    work = absolute(first.energy_change) + absolute(second.energy_change) + answer.impulse * answer.closing_speed
    energy = balance("energy", first.energy_change + second.energy_change, -answer.energy_lost, work)
    gained = () if plain_above(restitution) else not_above("no energy is gained", -answer.energy_lost, 0.0, work)
    return momentum + restituted + energy + gained


def plain_above(restitution: float) -> bool:
    """Whether a single contact adds energy."""
    return single(restitution) and bool(plain(restitution) > 1.0)
