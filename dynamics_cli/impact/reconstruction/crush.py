"""Energy of deformation from crush profiles, and the resulting change of velocity."""

from dynamics_cli.errors import judge, require, require_given, worded
from dynamics_cli.impact.conventions import mass_of
from dynamics_cli.impact.diagnostics import balance, require_sizes
from dynamics_cli.impact.particles.central import reduced_mass, struck_mass
from dynamics_cli.impact.reconstruction.crush_records import (
    CrushResult,
    Damaged,
    GivenEnergy,
    GivenSpeed,
    MeanCrush,
    Opponent,
    Stations,
    VehicleDamage,
    require_damage,
)
from dynamics_cli.impact.reconstruction.crush_stiffness import coefficients
from dynamics_cli.impact.reconstruction.crush_verdict import (
    damage_verdict,
    restitution_advice,
    restitution_tolerance,
    share_advice,
    verdict_advice,
)
from dynamics_cli.numerics.elementary import absolute, cos, sin, sqrt
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Gravity,
    Inertia,
    Restitution,
    Size,
)
from dynamics_cli.records import Advice, Check

# CRASH3 corrects for the direction of force up to 45 degrees; beyond that the face is hardly crushed.
STEEPEST_FORCE = 0.7853981633974483
RIGHT_ANGLE = 1.5707963267948966


def crush(
    *,
    first: Annotated[Damaged, "The first vehicle."],
    second: Annotated[
        Opponent | None, "The body that it met: another vehicle, or something fixed; without it there is no ΔV."
    ] = None,
    restitution: Annotated[
        Restitution, "Coefficient of restitution, for ΔV and closing speed; not used without a second body [-]."
    ] = 0.0,
    gravity: Annotated[Gravity, "Acceleration of gravity, for vehicles given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> CrushResult:
    """Energy of deformation from crush and stiffness, or as given, equivalent barrier speed and ΔV of both vehicles.

    Equation
    --------
    E = ∫(G + A C + ½ B C²) dl · (1 + tan²α); EBS = √(2E/m); p = √(2 m_r E (1 + e)/(1 − e)), ΔV = p/m.

    Returns
    -------
    CrushResult
        Energies, EBS, effective masses, ΔV, closing speed.

    Raises
    ------
    InadmissibleError
        When a vehicle's damage is missing, incomplete or given twice, there are fewer than two stations, no width or
        depth, a force angle beyond 45 degrees, a lever arm without yaw inertia, or e = 1 (nothing would be lost).

    Notes
    -----
    E is the energy finally lost; the impulse follows from E = ½ m_r (1 − e²) u². m_r is that of the effective masses
    m k²/(k² + h²), k² = J/m, h the lever arm |D cos α − x sin α|. The integral is exact for a profile of straight
    pieces: no station is favoured.

    References
    ----------
    Campbell, SAE 740565 (1974); CRASH3 technical manual (NHTSA, DOT HS 805 732), damage algorithm.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> from dynamics_cli.impact.reconstruction.crush_stiffness import Coefficients
    >>> car = Damaged(ByMass(1500.0), Coefficients(60000.0, 500000.0), MeanCrush(0.3, 1.5))
    >>> round(crush(first=car).first.energy, 6)
    66150.0
    """
    require_sizes(first=first, second=second, restitution=restitution, gravity=gravity)
    damage, advice = _damage(first, mass_of(first.bulk, gravity, "the first vehicle"), "first")
    if second is None:
        alone = "one vehicle alone: ΔV and the closing speed need the body that it met; restitution is not used"
        advice += (
            Advice("no-second-body", alone, "note", remedy="give the second mass, or --second-fixed for a barrier"),
        )
        return CrushResult(damage, None, damage.energy, None, None, None, None, _checks(damage, first), advice)
    mass = struck_mass(second.bulk, gravity, "the second vehicle")
    two: VehicleDamage | None = None
    if _is_damaged(second):
        require(
            mass is not None,
            "the second body is fixed, so it takes no damage, but its damage is given",
            code="fixed-damage",
            hint="give its mass, or leave out its damage",
        )
        assert mass is not None
        two, more = _damage(second, mass, "second")
        advice += more
    energy = damage.energy if two is None else damage.energy + two.energy
    require(
        restitution < 1.0,
        "a restitution of {restitution:6} leaves no energy for damage",
        restitution=(restitution, Restitution),
        code="no-loss",
        hint="vehicles with visible damage have 0 to 0.3",
    )
    effective = None if mass is None else (mass if two is None else two.effective_mass)
    reduced = reduced_mass(damage.effective_mass, effective)
    impulse = sqrt(2.0 * reduced * energy * ((1.0 + restitution) / (1.0 - restitution)))
    closing = sqrt(2.0 * energy / (reduced * ((1.0 - restitution) * (1.0 + restitution))))
    damage = VehicleDamage(**{**damage.__dict__, "delta_v": impulse / damage.mass})
    undamaged: float | None = None
    if two is not None:
        two = VehicleDamage(**{**two.__dict__, "delta_v": impulse / two.mass})
        advice += share_advice(first.damage is not None, "first", damage.energy, energy)
        advice += share_advice(second.damage is not None, "second", two.energy, energy)
    elif mass is not None:
        undamaged = impulse / mass
    scale = reduced * closing * (1.0 + restitution)
    tolerance = restitution_tolerance(restitution)
    advice += restitution_advice(tolerance)
    checks = _checks(damage, first) + balance("impulse from the closing speed", impulse, scale, impulse)
    return CrushResult(damage, two, energy, impulse, closing, undamaged, tolerance, checks, advice)


def _is_damaged(vehicle: Damaged | Opponent) -> bool:
    return vehicle.damage is not None or vehicle.profile is not None or vehicle.stiffness is not None


def moments(profile: Stations | MeanCrush) -> tuple[float, float, float | None]:
    """Mean depth, mean square depth, and centroid along the width as a share of it, of straight pieces."""
    if isinstance(profile, MeanCrush):
        return profile.mean_crush, profile.mean_crush * profile.mean_crush, None
    depths = profile.stations
    require(
        len(depths) >= 2,
        "a crush profile needs at least two stations: {count} given",
        count=len(depths),
        code="stations",
        hint="give two to six depths, or the mean crush",
    )
    pieces = len(depths) - 1
    mean: float = 0.0
    square: float = 0.0
    lever: float = 0.0
    for index in range(pieces):
        a, b = depths[index], depths[index + 1]
        mean = mean + (a + b)
        square = square + (a * a + a * b + b * b)
        lever = lever + (index * 3.0 * (a + b) + (a + 2.0 * b))
    require(mean > 0.0, "all depths of crush are zero", code="no-crush")
    return mean / (2.0 * pieces), square / (3.0 * pieces), lever / (3.0 * pieces * mean)


def _crushed(vehicle: Damaged | Opponent, name: str) -> tuple[float, float, Stations | MeanCrush]:
    """Stiffness coefficients A and B, and the crush, of a vehicle whose damage is measured."""
    require_damage(vehicle, name)
    assert vehicle.stiffness is not None and vehicle.profile is not None  # noqa: PT018
    a, b = coefficients(vehicle.stiffness, name)
    require(vehicle.profile.width > 0.0, "the {name} vehicle: its crushed width is zero", name=name, code="no-width")
    judge(
        absolute(vehicle.force_angle) <= STEEPEST_FORCE,
        "the {name} vehicle: the force is {angle} off the normal of the face; the correction 1 + tan² holds to 45 "
        "degrees",
        name=name,
        angle=(vehicle.force_angle, Angle),
        code="force-angle",
        hint="use the face that the force met more squarely",
        results=("energy",),
    )
    return a, b, vehicle.profile


def _damage(vehicle: Damaged | Opponent, mass: float, name: str) -> tuple[VehicleDamage, tuple[Advice, ...]]:
    angle = vehicle.force_angle
    require(
        absolute(angle) < RIGHT_ANGLE,
        "the {name} vehicle: a force {angle} off the normal of the face would not push it in",
        name=name,
        angle=(angle, Angle),
        code="force-angle",
    )
    effective = _effective_share(vehicle, mass, name)
    if vehicle.damage is not None:
        require(
            vehicle.stiffness is None and vehicle.profile is None,
            "the {name} vehicle: its damage is given twice, by energy or EES and by stiffness or crush",
            name=name,
            code="two-damages",
            hint="leave out one of them",
        )
        return _given_damage(vehicle.damage, mass, effective, name), ()
    a, b, profile = _crushed(vehicle, name)
    width = profile.width
    mean, square, centre = moments(profile)
    intercept = a / b * (0.5 * a)
    normal = width * (intercept + a * mean + 0.5 * b * square)
    cosine = cos(angle)
    energy = normal / (cosine * cosine)
    damage = VehicleDamage(
        energy=energy,
        energy_normal=normal,
        equivalent_barrier_speed=sqrt(2.0 * energy / mass),
        force=width * (a + b * mean),
        stiffness_a=a,
        stiffness_b=b,
        stiffness_g=intercept,
        mean_crush=mean,
        crush_centre=None if centre is None else centre * width,
        mass=mass,
        effective_mass=mass * effective,
        effective_share=effective,
        delta_v=None,
        determined=damage_verdict(normal, width * (a + b * mean), angle),
    )
    cautions = verdict_advice(damage.determined, damage.equivalent_barrier_speed, name)
    return damage, cautions + _advice(vehicle, mean, name)


def _given_damage(evidence: GivenEnergy | GivenSpeed, mass: float, share: float, name: str) -> VehicleDamage:
    """Damage by its energy E or by E = ½ m EES²."""
    if isinstance(evidence, GivenEnergy):
        energy = evidence.energy
        speed = sqrt(2.0 * energy / mass)
    else:
        speed = evidence.ees
        energy = 0.5 * mass * (speed * speed)
    require(
        energy > 0.0, "the {name} vehicle: its energy of deformation must be above zero", name=name, code="no-damage"
    )
    return VehicleDamage(
        energy=energy,
        energy_normal=None,
        equivalent_barrier_speed=speed,
        force=None,
        stiffness_a=None,
        stiffness_b=None,
        stiffness_g=None,
        mean_crush=None,
        crush_centre=None,
        mass=mass,
        effective_mass=mass * share,
        effective_share=share,
        delta_v=None,
    )


def _effective_share(vehicle: Damaged | Opponent, mass: float, name: str) -> float:
    """k²/(k² + h²) of the line of force, one through the mass centre."""
    lever = vehicle.lever_arm
    if lever is None and vehicle.offset is None:
        return 1.0
    require_given(
        vehicle.yaw_inertia is not None,
        "the {name} vehicle has a lever arm or an offset but no yaw inertia (dynamics impact yaw-inertia estimates it)",
        (f"{name}.yaw_inertia",),
        name=name,
        code="no-inertia",
    )
    assert vehicle.yaw_inertia is not None
    require(
        vehicle.yaw_inertia > 0.0,
        "the {name} vehicle: its yaw inertia is {inertia:6}; it must be above zero",
        name=name,
        inertia=(vehicle.yaw_inertia, Inertia),
        code="no-inertia",
    )
    if lever is None:
        offset = vehicle.offset if vehicle.offset is not None else 0.0
        away = vehicle.face_distance if vehicle.face_distance is not None else 0.0
        lever = offset * cos(vehicle.force_angle) - away * sin(vehicle.force_angle)
    else:
        require(
            vehicle.offset is None,
            "the {name} vehicle has both a lever arm and an offset",
            name=name,
            code="two-levers",
            hint="leave out one of them",
        )
    return 1.0 / (1.0 + mass * (lever * lever) / vehicle.yaw_inertia)


def _advice(vehicle: Damaged | Opponent, mean: float, name: str) -> tuple[Advice, ...]:
    if not single(mean, vehicle.profile.width):  # type: ignore[union-attr]
        return ()
    advice: tuple[Advice, ...] = ()
    if plain(mean) > 1.5:
        message = worded(
            "the {name} vehicle: a mean crush of {mean:3} is deeper than cars allow", name=name, mean=(mean, Size)
        )
        advice += (Advice("deep-crush", message),)
    if vehicle.offset is not None and vehicle.face_distance is None and plain(vehicle.force_angle) != 0.0:
        text = worded(
            "the {name} vehicle: the distance of the face is not given, so the turned force is taken through "
            "the offset abreast of the mass centre",
            name=name,
        )
        advice += (Advice("face-distance", text, remedy="give the face distance"),)
    return advice


def _checks(damage: VehicleDamage, vehicle: Damaged) -> tuple[Check, ...]:
    """Check the energy by Simpson's rule on every piece, which is exact for squares."""
    profile = vehicle.profile
    if profile is None:
        return ()
    assert damage.stiffness_a is not None and damage.stiffness_b is not None and damage.energy_normal is not None  # noqa: PT018
    depths = profile.stations if isinstance(profile, Stations) else (profile.mean_crush, profile.mean_crush)
    pieces = len(depths) - 1
    total: float = 0.0
    for index in range(pieces):
        c0, c1 = depths[index], depths[index + 1]
        ends = [0.5 * (damage.stiffness_a + damage.stiffness_b * c) for c in (c0, 0.5 * (c0 + c1), c1)]
        works = [2.0 * end / damage.stiffness_b * end for end in ends]
        total = total + (works[0] + 4.0 * works[1] + works[2])
    return balance(
        "energy by Simpson's rule", profile.width * total / (6.0 * pieces), damage.energy_normal, damage.energy_normal
    )
