"""Damage of vehicles as measured or given, and its results."""

from dynamics_cli.errors import require_given
from dynamics_cli.impact.conventions import BodyName, ByMass, ByWeight, Fixed
from dynamics_cli.impact.reconstruction.crush_stiffness import BarrierTest, Campbell, Coefficients
from dynamics_cli.impact.reconstruction.crush_verdict import DamageVerdict
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    CrushStiffness,
    Distance,
    Energy,
    Force,
    Fraction,
    Impulse,
    Inertia,
    Length,
    LineForce,
    Mass,
    Restitution,
    RoadSpeed,
    Size,
)
from dynamics_cli.records import Advice, Check, record


@record
class Stations:
    """A profile by depths at equally spaced stations, from one end of the crushed width to the other."""

    stations: Annotated[
        tuple[Size, ...], "Depths of crush at two to six (or more) stations, e.g. 5,12,18,20,14,6 in [m]."
    ]
    width: Annotated[Distance, "Width that is crushed, from the first station to the last, e.g. 60 in [m]."]


@record
class MeanCrush:
    """A profile of one depth."""

    mean_crush: Annotated[Size, "Depth of crush over all the width, e.g. 14 in [m]."]
    width: Annotated[Distance, "Width that is crushed, e.g. 60 in [m]."]


@record
class GivenEnergy:
    """Damage by its energy, from a crash simulation, a test or comparison with known damage."""

    energy: Annotated[Energy, "Energy of deformation, instead of stiffness and crush, e.g. 62 kJ [J]."]


@record
class GivenSpeed:
    """Damage by the energy equivalent speed."""

    ees: Annotated[
        RoadSpeed, "Energy equivalent speed, E = ½ m EES², instead of stiffness and crush, e.g. 30 km/h [m/s]."
    ]


@record
class Damaged:
    """A damaged vehicle."""

    bulk: Annotated[ByMass | ByWeight, "Its mass or its weight."]
    stiffness: Annotated[
        Coefficients | Campbell | BarrierTest | None,
        "Its stiffness: A and B, Campbell's b₀ and b₁, or one barrier test.",
    ] = None
    profile: Annotated[Stations | MeanCrush | None, "The crush that was measured."] = None
    force_angle: Annotated[
        Angle, "Angle between the direction of force and the normal of the damaged face, e.g. 10 deg [rad]."
    ] = 0.0
    lever_arm: Annotated[Length | None, "Distance of the line of force from the mass centre, e.g. 0.4 m [m]."] = None
    offset: Annotated[
        Length | None,
        "Distance of the middle of the damage from the mass centre along the face, to the side that the force "
        "angle turns the force to, e.g. 0.5 m [m].",
    ] = None
    face_distance: Annotated[Distance | None, "Distance of the damaged face from the mass centre, e.g. 1.9 m [m]."] = (
        None
    )
    yaw_inertia: Annotated[
        Inertia | None,
        "Yaw moment of inertia about the mass centre, needed with a lever arm or an offset, e.g. 2500 kg*m^2 [kg·m²].",
    ] = None
    damage: Annotated[GivenEnergy | GivenSpeed | None, "Its damage as energy or EES, without stiffness and crush."] = (
        None
    )
    name: BodyName = None


@record
class Opponent:
    """The body that the vehicle met: another damaged vehicle, or something fixed without damage."""

    bulk: Annotated[ByMass | ByWeight | Fixed, "Its mass or its weight, or that it is fixed."]
    stiffness: Annotated[
        Coefficients | Campbell | BarrierTest | None,
        "Its stiffness: A and B, Campbell's b₀ and b₁, or one barrier test.",
    ] = None
    profile: Annotated[Stations | MeanCrush | None, "The crush that was measured on it; no damage when left out."] = (
        None
    )
    force_angle: Annotated[
        Angle, "Angle between the direction of force and the normal of the damaged face, e.g. 10 deg [rad]."
    ] = 0.0
    lever_arm: Annotated[Length | None, "Distance of the line of force from the mass centre, e.g. 0.4 m [m]."] = None
    offset: Annotated[
        Length | None, "Distance of the middle of the damage from the mass centre along the face, e.g. 0.5 m [m]."
    ] = None
    face_distance: Annotated[Distance | None, "Distance of the damaged face from the mass centre, e.g. 1.9 m [m]."] = (
        None
    )
    yaw_inertia: Annotated[
        Inertia | None,
        "Yaw moment of inertia about the mass centre, needed with a lever arm or an offset, e.g. 2500 kg*m^2 [kg·m²].",
    ] = None
    damage: Annotated[GivenEnergy | GivenSpeed | None, "Its damage as energy or EES, without stiffness and crush."] = (
        None
    )
    name: BodyName = None


@record
class VehicleDamage:
    """Damage of one vehicle and its results."""

    energy: Annotated[Energy, "Energy of deformation, corrected for the direction of force [J]."]
    energy_normal: Annotated[Energy | None, "The same without that correction [J]."]
    equivalent_barrier_speed: Annotated[
        RoadSpeed, "Speed at which the vehicle would have the same damage from a fixed barrier: ½ m EBS² = E [m/s]."
    ]
    force: Annotated[Force | None, "Force on the whole face at the end of the crush, A + B·C over the width [N]."]
    stiffness_a: Annotated[LineForce | None, "Force per width at which crush begins [N/m]."]
    stiffness_b: Annotated[CrushStiffness | None, "Force per width and depth [N/m^2]."]
    stiffness_g: Annotated[Force | None, "Energy per width without residual crush, A²/(2B) [N]."]
    mean_crush: Annotated[Size | None, "Mean depth over the width [m]."]
    crush_centre: Annotated[
        Distance | None, "Distance of the centroid of the crushed area from the first station along the width [m]."
    ]
    mass: Annotated[Mass, "Mass [kg]."]
    effective_mass: Annotated[Mass, "Mass as the line of force feels it, m·k²/(k² + h²) [kg]."]
    effective_share: Annotated[Fraction, "The same over the mass [-]."]
    delta_v: Annotated[
        RoadSpeed | None,
        "Size of the change of velocity of the mass centre; needs the second vehicle or that it is fixed [m/s].",
    ]
    determined: Annotated[
        DamageVerdict | None, "How well the measured damage determines it; absent for a given energy."
    ] = None


@record
class CrushResult:
    """Energies of deformation and the resulting impact."""

    first: Annotated[VehicleDamage, "The first vehicle."]
    second: Annotated[VehicleDamage | None, "The second vehicle; needs its damage."]
    energy: Annotated[Energy, "Energy of deformation of both [J]."]
    impulse: Annotated[Impulse | None, "Impulse between them; needs the second vehicle or that it is fixed [N·s]."]
    closing_speed: Annotated[
        RoadSpeed | None, "Relative speed along the line of force at the place of damage, before [m/s]."
    ]
    second_delta_v: Annotated[RoadSpeed | None, "Change of velocity of an undamaged second body [m/s]."]
    restitution_tolerance: Annotated[
        Restitution | None, "Error of the restitution that changes ΔV by a tenth; needs the second body [-]."
    ] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def require_damage(vehicle: Damaged | Opponent, name: str) -> None:
    """Require both stiffness and crush, or an energy instead."""
    profiles: tuple[tuple[str, ...], ...] = (("mean_crush", "width"), ("stations", "width"))
    stiffness = ("stiffness_a", "stiffness_b")
    missing = "damage"
    alternatives: tuple[tuple[str, ...], ...] = (("energy",), ("ees",), stiffness + profiles[0])
    if vehicle.stiffness is not None:
        missing, alternatives = "crush profile", profiles
    elif vehicle.profile is not None:
        test = ("test_speed", "test_crush", "no_damage_speed", "test_mass", "test_width")
        missing, alternatives = "stiffness", (stiffness, test)
    require_given(
        vehicle.profile is not None and vehicle.stiffness is not None,
        "the {name} vehicle: its {missing} is missing",
        *(tuple(f"{name}.{part}" for part in names) for names in alternatives),
        name=name,
        missing=missing,
        code="half-damage",
    )
