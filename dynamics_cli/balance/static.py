"""Static balance: what the masses on a rotor add up to in one plane, and one mass that balances them."""

from dynamics_cli.balance.phasors import polar, scale_of, total
from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    BalanceGrade,
    BalanceMass,
    Eccentricity,
    Force,
    Mass,
    ShaftSpeed,
    Size,
    Unbalance,
)
from dynamics_cli.records import record


@record
class Weight:
    """A mass on a rotor."""

    mass: Annotated[BalanceMass, "The mass, e.g. 20 g."]
    radius: Annotated[Size, "Its distance from the axis, e.g. 100 mm."]
    angle: Annotated[Angle, "Its angle from the mark on the rotor, e.g. 30 deg."]


@record
class StaticBalance:
    """The unbalance of the masses, and its correction."""

    unbalance: Annotated[Unbalance, "What the masses add up to [kg·m]."]
    angle: Annotated[Angle | None, "Its angle; none without an unbalance [rad]."]
    correction_angle: Annotated[Angle | None, "Where mass is added, opposite to it [rad]."]
    correction_mass: Annotated[BalanceMass | None, "The mass to add at the radius given [kg]."]
    eccentricity: Annotated[Eccentricity | None, "How far the centre of mass lies off the axis [m]."]
    force: Annotated[Force | None, "Rotating force on the bearings at the speed given [N]."]
    grade: Annotated[BalanceGrade | None, "Balance grade: eccentricity times angular velocity [m/s]."]


def static(
    *,
    weights: Annotated[Weight | tuple[Weight, ...], "Masses on the rotor; one may be given by its plain fields."],
    correction_radius: Annotated[Size | None, "Radius at which mass is added or removed, e.g. 150 mm."] = None,
    rotor_mass: Annotated[Mass | None, "Mass of the complete rotor, e.g. 12 kg."] = None,
    speed: Annotated[ShaftSpeed | None, "Speed of the rotor, e.g. 3000 rpm."] = None,
) -> StaticBalance:
    """Unbalance of masses in one plane of a rotor and the mass that balances it.

    Equation
    --------
    U = Σ mᵢ·rᵢ at their angles; the correction is −U; e = U/M, F = U·Ω².

    Returns
    -------
    StaticBalance
        Unbalance with its angle, correction, eccentricity, force and grade.

    Raises
    ------
    InadmissibleError
        When no mass is given, or a radius for the correction or a mass of the rotor of zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 15.2.

    Examples
    --------
    >>> one, other = Weight(0.003, 0.1, 0.0), Weight(0.004, 0.1, 1.5707963267948966)
    >>> round(static(weights=(one, other)).unbalance, 9)
    0.0005
    """
    those = weights if isinstance(weights, tuple) else (weights,)
    require(len(those) > 0, "no mass is given", code="missing")
    require(
        correction_radius is None or correction_radius > 0.0, "a mass at the axis corrects nothing", code="no-radius"
    )
    require(rotor_mass is None or rotor_mass > 0.0, "the mass of the rotor is zero", code="no-mass")
    parts = [polar(one.mass * one.radius, one.angle) for one in those]
    whole = total(parts)
    size, angle = whole.size, whole.angle_beside(scale_of(parts))
    off = None if rotor_mass is None else size / rotor_mass
    return StaticBalance(
        unbalance=size,
        angle=angle,
        correction_angle=None if angle is None else (-whole).angle,
        correction_mass=None if correction_radius is None else size / correction_radius,
        eccentricity=off,
        force=None if speed is None else size * speed * speed,
        grade=None if off is None or speed is None or plain(size) == 0.0 else off * abs(speed),
    )
