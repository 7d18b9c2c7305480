"""Energy of deformation from crush profiles, and the change of velocity that goes with it."""

import math

from dynamics_cli.errors import require
from dynamics_cli.impact.central import reduced_mass, struck_mass
from dynamics_cli.impact.conventions import mass_of
from dynamics_cli.impact.crush_records import CrushFound, Damaged, DamageFound, MeanCrush, Opponent, Stations
from dynamics_cli.impact.crush_stiffness import coefficients
from dynamics_cli.impact.diagnostics import balance, plain, require_sizes, single
from dynamics_cli.numerics.elementary import absolute, cos, sin, sqrt
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Gravity,
    Restitution,
)
from dynamics_cli.records import Advice, Check

# CRASH3 corrects for the direction of force up to 45 degrees; beyond, the face was hardly pushed in.
STEEPEST_FORCE = 0.7853981633974483


def crush(
    *,
    first: Damaged,
    second: Opponent | None = None,
    restitution: Restitution = 0.0,
    gravity: Gravity = STANDARD_GRAVITY,
) -> CrushFound:
    """Energy of deformation from depths of crush and stiffness, the equivalent barrier speed, and ΔV of both vehicles.

    Equation
    --------
    E = ∫(G + A C + ½ B C²) dl · (1 + tan²α); EBS = √(2E/m); p = √(2 m_r E (1 + e)/(1 − e)), ΔV = p/m.

    Parameters
    ----------
    first : Damaged
        The first vehicle.
    second : Opponent
        What it met: another vehicle, or something fixed; without it there is no ΔV.
    restitution : Restitution
        Coefficient of restitution, for ΔV and closing speed; not used without a second body [-].
    gravity : Gravity
        Acceleration of gravity, for vehicles given by weight [m/s^2].

    Returns
    -------
    CrushFound
        Energies, EBS, effective masses, ΔV, closing speed.

    Raises
    ------
    InadmissibleError
        When there are fewer than two stations, no width or depth, a force angle beyond 45 degrees, a lever arm without
        yaw inertia, or e = 1 (nothing would be lost).

    Notes
    -----
    E is what remained lost; the impulse follows from E = ½ m_r (1 − e²) u². m_r is that of the effective masses
    m k²/(k² + h²), k² = J/m, h the lever arm |D cos α − x sin α|. The integral is exact for a profile of straight
    pieces: no station is favoured.

    References
    ----------
    Campbell, SAE 740565 (1974); CRASH3 technical manual (NHTSA, DOT HS 805 732), damage algorithm.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> from dynamics_cli.impact.crush_stiffness import Coefficients
    >>> car = Damaged(ByMass(1500.0), Coefficients(60000.0, 500000.0), MeanCrush(0.3, 1.5))
    >>> round(crush(first=car).first.energy, 6)
    66150.0
    """
    require_sizes(first=first, second=second, restitution=restitution, gravity=gravity)
    one, advice = _damage(first, mass_of(first.bulk, gravity, "the first vehicle"), "first")
    mass = None if second is None else struck_mass(second.bulk, gravity, "the second vehicle")
    two: DamageFound | None = None
    if second is not None:
        two, more = _opponent(second, mass)
        advice += more
    energy = one.energy if two is None else one.energy + two.energy
    if second is None:
        alone = "one vehicle alone: ΔV and the closing speed need the body that it met; restitution is not used"
        advice += (
            Advice("no-second-body", alone, "note", mend="give the second mass, or --second-fixed for a barrier"),
        )
        return CrushFound(one, None, energy, None, None, None, _checks(one, first), advice)
    require(
        restitution < 1.0,
        "a restitution of {0:.6g} leaves no energy for damage",
        restitution,
        code="no-loss",
        hint="vehicles with visible damage have 0 to 0.3",
    )
    effective = None if mass is None else (mass if two is None else two.effective_mass)
    reduced = reduced_mass(one.effective_mass, effective)
    impulse = sqrt(2.0 * reduced * energy * ((1.0 + restitution) / (1.0 - restitution)))
    closing = sqrt(2.0 * energy / (reduced * ((1.0 - restitution) * (1.0 + restitution))))
    one = DamageFound(**{**one.__dict__, "delta_v": impulse / one.mass})
    other: float | None = None
    if mass is not None:
        other = impulse / mass
    if two is not None and other is not None:
        two, other = DamageFound(**{**two.__dict__, "delta_v": other}), None
    scale = reduced * closing * (1.0 + restitution)
    checks = _checks(one, first) + balance("impulse from the closing speed", impulse, scale, impulse)
    return CrushFound(one, two, energy, impulse, closing, other, checks, advice)


def _opponent(second: Opponent, mass: float | None) -> tuple[DamageFound | None, tuple[Advice, ...]]:
    """The damage of the second vehicle, if it has any."""
    if second.profile is None and second.stiffness is None:
        return None, ()
    require(
        second.profile is not None and second.stiffness is not None,
        "the second vehicle needs both a stiffness and a crush profile, or neither",
        code="half-damage",
    )
    require(
        mass is not None,
        "the second body is fixed and takes no damage; it has a stiffness and a profile",
        code="fixed-damage",
        hint="give its mass, or leave out its damage",
    )
    assert second.profile is not None and second.stiffness is not None and mass is not None  # noqa: PT018
    return _damage(second, mass, "second")


def moments(profile: Stations | MeanCrush) -> tuple[float, float, float | None]:
    """Mean depth, mean square depth, and centroid along the width as a share of it, of straight pieces."""
    if isinstance(profile, MeanCrush):
        return profile.mean_crush, profile.mean_crush * profile.mean_crush, None
    depths = profile.stations
    require(
        len(depths) >= 2,
        f"{len(depths)} station of crush gives no profile",
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


def _damage(vehicle: Damaged | Opponent, mass: float, name: str) -> tuple[DamageFound, tuple[Advice, ...]]:
    assert vehicle.stiffness is not None and vehicle.profile is not None  # noqa: PT018
    a, b = coefficients(vehicle.stiffness, name)
    width = vehicle.profile.width
    require(width > 0.0, f"the {name} vehicle: " + "a width of {0:.6g} m is no damage", width, code="no-width")
    angle = vehicle.force_angle
    require(
        absolute(angle) <= STEEPEST_FORCE,
        f"the {name} vehicle: " + "the force is {0:.4g} degrees off the normal of the face; the correction "
        "1 + tan² holds to 45 degrees",
        angle * (180.0 / math.pi),
        code="force-angle",
        hint="take the face that was pushed in more squarely",
    )
    mean, square, centre = moments(vehicle.profile)
    intercept = a / b * (0.5 * a)
    normal = width * (intercept + a * mean + 0.5 * b * square)
    cosine = cos(angle)
    energy = normal / (cosine * cosine)
    share = _effective_share(vehicle, mass, name)
    found = DamageFound(
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
        effective_mass=mass * share,
        effective_share=share,
        delta_v=None,
    )
    return found, _advice(vehicle, mean, name)


def _effective_share(vehicle: Damaged | Opponent, mass: float, name: str) -> float:
    """k²/(k² + h²) of the line of force, one through the mass centre."""
    lever = vehicle.lever_arm
    if lever is None and vehicle.offset is None:
        return 1.0
    require(
        vehicle.yaw_inertia is not None,
        f"the {name} vehicle has a lever arm but no yaw inertia",
        code="no-inertia",
        hint="give its yaw inertia; `dynamics impact yaw-inertia` estimates it",
    )
    assert vehicle.yaw_inertia is not None
    require(
        vehicle.yaw_inertia > 0.0,
        f"the {name} vehicle: " + "a yaw inertia of {0:.6g} kg·m² holds no line of force",
        vehicle.yaw_inertia,
        code="no-inertia",
    )
    if lever is None:
        offset = vehicle.offset if vehicle.offset is not None else 0.0
        away = vehicle.face_distance if vehicle.face_distance is not None else 0.0
        lever = offset * cos(vehicle.force_angle) - away * sin(vehicle.force_angle)
    else:
        require(vehicle.offset is None, f"the {name} vehicle has both a lever arm and an offset", code="two-levers")
    return 1.0 / (1.0 + mass * (lever * lever) / vehicle.yaw_inertia)


def _advice(vehicle: Damaged | Opponent, mean: float, name: str) -> tuple[Advice, ...]:
    if not single(mean, vehicle.profile.width):  # type: ignore[union-attr]
        return ()
    found: tuple[Advice, ...] = ()
    if plain(mean) > 1.5:
        found += (
            Advice("deep-crush", f"the {name} vehicle: a mean crush of {plain(mean):.3g} m is deeper than cars allow"),
        )
    if vehicle.offset is not None and vehicle.face_distance is None and plain(vehicle.force_angle) != 0.0:
        found += (
            Advice(
                "face-distance",
                f"the {name} vehicle: without the distance of the face the turned force is taken through the offset "
                "abreast of the mass centre",
                mend="give the face distance",
            ),
        )
    return found


def _checks(one: DamageFound, vehicle: Damaged) -> tuple[Check, ...]:
    """Energy once more, by Simpson's rule on every piece, which is exact for squares."""
    profile = vehicle.profile
    depths = profile.stations if isinstance(profile, Stations) else (profile.mean_crush, profile.mean_crush)
    pieces = len(depths) - 1
    total: float = 0.0
    for index in range(pieces):
        left, right = depths[index], depths[index + 1]
        ends = [0.5 * (one.stiffness_a + one.stiffness_b * c) for c in (left, 0.5 * (left + right), right)]
        works = [2.0 * end / one.stiffness_b * end for end in ends]
        total = total + (works[0] + 4.0 * works[1] + works[2])
    return balance(
        "energy by Simpson's rule", profile.width * total / (6.0 * pieces), one.energy_normal, one.energy_normal
    )
