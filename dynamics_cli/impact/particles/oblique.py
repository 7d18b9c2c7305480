"""Oblique impact of particles and smooth spheres: the central impact on the line of impact, nothing across it."""

from dynamics_cli.errors import require
from dynamics_cli.impact.conventions import (
    AXES,
    PDOF_ZERO,
    Axes,
    Energetic,
    PdofZero,
    Restituted,
    conventions,
    delta_v,
    direction_of,
    heading_of,
    mass_of,
    travel_of,
    velocity_of,
)
from dynamics_cli.impact.diagnostics import balance, momentum_kept, not_above, require_finite, require_sizes
from dynamics_cli.impact.particles.central import (
    contact_advice,
    plain_above,
    reduced_mass,
    require_approach,
    struck_mass,
    velocities_after,
)
from dynamics_cli.impact.particles.contact_time import push
from dynamics_cli.impact.particles.hunt_crossley import HuntCrossley
from dynamics_cli.impact.particles.oblique_records import (
    AfterOblique,
    Centres,
    ChangeOfVelocity,
    Met,
    Moving,
    Normal,
    ObliqueImpact,
    Offset,
)
from dynamics_cli.impact.particles.springs import Hertz, Spring
from dynamics_cli.numerics.elementary import absolute, hypot, multiply_add, sqrt, where
from dynamics_cli.numerics.vectors import planar_cross as cross
from dynamics_cli.numerics.vectors import planar_dot as dot
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Annotated,
    Gravity,
    Length,
)
from dynamics_cli.records import Check

Pair = tuple[float, float]


def oblique(
    *,
    first: Annotated[Moving, "The first body."],
    second: Annotated[Met, "The second body; at rest unless its motion is given."],
    line: Annotated[
        Normal | Centres | Offset,
        "The line of impact: its direction, the centres of two spheres, or how far off centre they meet.",
    ],
    contact: Annotated[
        Restituted | Energetic, "Coefficient of restitution, or the ratio of speeds of a contact that gives energy."
    ],
    force: Annotated[
        Spring | Hertz | HuntCrossley | None, "Stiffness of the contact, for duration and peak force."
    ] = None,
    axes: Annotated[Axes, "Axes of velocities and headings: mathematical, compass, sae or iso."] = AXES,
    pdof_zero: Annotated[PdofZero, "Where a force of PDOF zero comes from: heading, travel or scene."] = PDOF_ZERO,
    gravity: Annotated[Gravity, "Acceleration of gravity, for bodies given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> ObliqueImpact:
    """Two particles or smooth spheres meet at an angle: the line of impact sees a central impact, nothing acts across.

    Equation
    --------
    p = (1 + e) m_r u_n along n, u_n = (v₁ − v₂)·n; tangential velocities stay; loss ½ m_r (1 − e²) u_n².

    Returns
    -------
    ObliqueImpact
        Velocities, ΔV and PDOF of both bodies, impulse, energies.

    Raises
    ------
    InadmissibleError
        When the bodies separate or pass each other (no impact), a mass is zero, or the line has no direction.

    Notes
    -----
    Without friction there is no impulse across the line and no spin; with friction or shape use the planar impact.
    Everything follows from the impulse: ΔV is J/m and the loss is never a difference of kinetic energies.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.11.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass, ByVelocity, Restituted
    >>> car, other = Moving(ByMass(1.0), ByVelocity((0.1414, 0.1414))), Met(ByMass(1.0), ByVelocity((-0.1299, 0.075)))
    >>> hit = oblique(first=car, second=other, line=Normal(0.0), contact=Restituted(0.95))
    >>> round(hit.first.normal_velocity, 7), round(hit.second.normal_velocity, 7)
    (-0.1231175, 0.1346175)
    """
    require_sizes(first=first, second=second, line=line, contact=contact, force=force, gravity=gravity)
    mass = mass_of(first.bulk, gravity, "the first body")
    two = struck_mass(second.bulk, gravity, "the second body")
    before = velocity_of(first.motion, axes), velocity_of(second.motion, axes)
    relative = before[0][0] - before[1][0], before[0][1] - before[1][1]
    normal, closing = _normal(line, relative, axes)
    require_approach(closing, "the line of impact points from the first body to the second: turn it by 180 degrees")
    reduced = reduced_mass(mass, two)
    compression = reduced * closing
    size = (1.0 + contact.restitution) * compression
    require_finite(size * closing, "the energy of the impact")
    back = -normal[0], -normal[1]
    share = (1.0 - contact.restitution) * (1.0 + contact.restitution)
    shares = -(reduced / mass), 0.0 if two is None else reduced / two
    along = dot(before[0], normal), dot(before[1], normal)
    final = velocities_after((mass, two), along, shares, closing, contact.restitution)[1]
    answer = ObliqueImpact(
        first=_after(mass, before[0], final[0], size, back, _nose(first.nose, before[0], axes), axes, pdof_zero, -1.0),
        second=_after(
            two, before[1], final[1], size, normal, _nose(second.nose, before[1], axes), axes, pdof_zero, 1.0
        ),
        impulse=size,
        normal_direction=heading_of(normal[0], normal[1], axes),
        closing_speed=closing,
        separation_speed=contact.restitution * closing,
        sliding_speed=absolute(cross(normal, relative)),
        energy_lost=0.5 * share * (compression * closing),
        push=push(force, reduced, closing, contact.restitution),
        conventions=conventions(axes, pdof_zero),
        advice=contact_advice(contact),
    )
    return ObliqueImpact(**{**answer.__dict__, "checks": _checks(answer, (mass, two), before, normal, contact)})


def _normal(line: Normal | Centres | Offset, relative: Pair, axes: Axes) -> tuple[Pair, float]:
    """Unit vector of the line of impact, from the first body to the second, and the closing speed along it."""
    if isinstance(line, Normal):
        normal = direction_of(line.normal, axes)
        return normal, dot(relative, normal)
    if isinstance(line, Centres):
        normal = _unit(
            (line.second_centre[0] - line.first_centre[0], line.second_centre[1] - line.first_centre[1]),
            "the centres coincide: the line of impact has no direction",
            "no-line",
        )
        return normal, dot(relative, normal)
    speed = hypot(relative[0], relative[1])
    require(speed > 0.0, "no impact: the bodies do not move against each other", code="no-impact")
    reach = line.first_radius + line.second_radius
    require(reach > 0.0, "an offset needs spheres with radii above zero", code="no-radius")
    across = line.offset
    require(
        absolute(across) < reach,
        "no impact: an offset of {offset:6} passes spheres whose radii sum to {reach:6}",
        offset=(across, Length),
        reach=(reach, Length),
        code="no-impact",
    )
    # for spheres that nearly miss, both differences are exact
    larger = where(line.first_radius >= line.second_radius, line.first_radius, line.second_radius)
    smaller = where(line.first_radius >= line.second_radius, line.second_radius, line.first_radius)
    overlap = (larger - absolute(across)) + smaller
    along = sqrt(overlap / reach) * sqrt((reach + absolute(across)) / reach)
    across = across / reach
    x, y = relative
    normal = multiply_add(along, x, -(across * y)) / speed, multiply_add(along, y, across * x) / speed
    return normal, along * speed


def _unit(vector: Pair, message: str, code: str) -> Pair:
    size = hypot(vector[0], vector[1])
    require(size > 0.0, message, code=code)
    return vector[0] / size, vector[1] / size


def _nose(nose: float | None, velocity: Pair, axes: Axes) -> Pair:
    """Direction of the nose: given, else that of travel, else that of heading zero."""
    if nose is not None:
        return direction_of(nose, axes)
    return travel_of(velocity, axes)


def _after(
    mass: float | None, before: Pair, final: float, size: float, way: Pair, nose: Pair, axes: Axes, zero: PdofZero,
    sense: float,
) -> AfterOblique:  # fmt: skip
    """State of one body after an impulse of a size along a direction, which is the normal times `sense`.

    `final` is its velocity along the normal.
    """
    change: ChangeOfVelocity | None = None
    after = before
    middle = along = dot(before, way)
    if mass is not None:
        travel = travel_of(before, axes)
        road = delta_v(way, mass, nose, axes=axes, pdof_zero=zero, travel=travel, size=size)
        change = ChangeOfVelocity(road.vector, road.magnitude, road.longitudinal, road.lateral, road.pdof, road.clock)
        gain = size / mass
        middle = along + 0.5 * gain
        after = multiply_add(way[0], gain, before[0]), multiply_add(way[1], gain, before[1])
        # where the impulse removes nearly all motion, the remainder is assembled from its components
        left, aside = sense * final, cross(way, before)
        parts = multiply_add(way[0], left, -(way[1] * aside)), multiply_add(way[1], left, way[0] * aside)
        taken = absolute(gain) > 4.0 * (absolute(left) + absolute(aside))
        after = where(taken, parts[0], after[0]), where(taken, parts[1], after[1])
    return AfterOblique(
        velocity=after,
        speed=hypot(after[0], after[1]),
        heading=heading_of(after[0], after[1], axes),
        normal_velocity=final,
        tangential_velocity=sense * cross(way, before),
        delta_v=change,
        energy_change=size * middle,
    )


def _checks(
    answer: ObliqueImpact,
    masses: tuple[float, float | None],
    before: tuple[Pair, Pair],
    normal: Pair,
    contact: Restituted | Energetic,
) -> tuple[Check, ...]:
    one, two = answer.first, answer.second
    checks = momentum_kept(masses, before, (one.velocity, two.velocity), answer.impulse)
    speeds = hypot(before[0][0], before[0][1]) + hypot(before[1][0], before[1][1]) + answer.closing_speed
    speeds = speeds + answer.separation_speed
    parted = two.normal_velocity - one.normal_velocity
    checks += balance("restitution", parted, contact.restitution * answer.closing_speed, speeds)
    checks += balance("velocity along the line", dot(normal, one.velocity), one.normal_velocity, speeds)
    checks += balance("nothing across the line", cross(normal, one.velocity), one.tangential_velocity, speeds)
    work = absolute(one.energy_change) + absolute(two.energy_change) + answer.impulse * speeds
    checks += balance("energy", one.energy_change + two.energy_change, -answer.energy_lost, work)
    if plain_above(contact.restitution):
        return checks
    return checks + not_above("no energy is gained", -answer.energy_lost, 0.0, work)
