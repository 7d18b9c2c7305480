"""What is measured on damaged vehicles and what it says."""

from dynamics_cli.impact.conventions import ByMass, ByWeight, Fixed
from dynamics_cli.impact.crush_stiffness import BarrierTest, Campbell, Coefficients
from dynamics_cli.quantities import (
    Angle,
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
    RoadSpeed,
    Size,
)
from dynamics_cli.records import Advice, Check, record


@record
class Stations:
    """A profile by depths at equally spaced stations, from one end of the crushed width to the other.

    Parameters
    ----------
    stations : tuple[Size, ...]
        Depths of crush at two to six (or more) stations [m].
    width : Distance
        Width that is crushed, from the first station to the last [m].
    """

    stations: tuple[Size, ...]
    width: Distance


@record
class MeanCrush:
    """A profile of one depth.

    Parameters
    ----------
    mean_crush : Size
        Depth of crush over all the width [m].
    width : Distance
        Width that is crushed [m].
    """

    mean_crush: Size
    width: Distance


@record
class Damaged:
    """A damaged vehicle.

    Parameters
    ----------
    bulk : ByMass | ByWeight
        Its mass or its weight.
    stiffness : Coefficients | Campbell | BarrierTest
        Its stiffness: A and B, Campbell's b₀ and b₁, or one barrier test.
    profile : Stations | MeanCrush
        What was measured.
    force_angle : Angle
        Angle between the direction of force and the normal of the damaged face [rad].
    lever_arm : Length
        Distance of the line of force from the mass centre [m].
    offset : Length
        Distance of the middle of the damage from the mass centre along the face, to the side that the force angle turns
        the force to [m].
    face_distance : Distance
        Distance of the damaged face from the mass centre [m].
    yaw_inertia : Inertia
        Yaw moment of inertia about the mass centre, needed with a lever arm or an offset [kg·m²].
    """

    bulk: ByMass | ByWeight
    stiffness: Coefficients | Campbell | BarrierTest
    profile: Stations | MeanCrush
    force_angle: Angle = 0.0
    lever_arm: Length | None = None
    offset: Length | None = None
    face_distance: Distance | None = None
    yaw_inertia: Inertia | None = None


@record
class Opponent:
    """What the vehicle met: another damaged vehicle, or something fixed that took no damage.

    Parameters
    ----------
    bulk : ByMass | ByWeight | Fixed
        Its mass or its weight, or that it is fixed.
    stiffness : Coefficients | Campbell | BarrierTest
        Its stiffness: A and B, Campbell's b₀ and b₁, or one barrier test.
    profile : Stations | MeanCrush
        What was measured on it; no damage when left out.
    force_angle : Angle
        Angle between the direction of force and the normal of the damaged face [rad].
    lever_arm : Length
        Distance of the line of force from the mass centre [m].
    offset : Length
        Distance of the middle of the damage from the mass centre along the face [m].
    face_distance : Distance
        Distance of the damaged face from the mass centre [m].
    yaw_inertia : Inertia
        Yaw moment of inertia about the mass centre, needed with a lever arm or an offset [kg·m²].
    """

    bulk: ByMass | ByWeight | Fixed
    stiffness: Coefficients | Campbell | BarrierTest | None = None
    profile: Stations | MeanCrush | None = None
    force_angle: Angle = 0.0
    lever_arm: Length | None = None
    offset: Length | None = None
    face_distance: Distance | None = None
    yaw_inertia: Inertia | None = None


@record
class DamageFound:
    """What the damage of one vehicle says.

    Parameters
    ----------
    energy : Energy
        Energy of deformation, corrected for the direction of force [J].
    energy_normal : Energy
        The same without that correction [J].
    equivalent_barrier_speed : RoadSpeed
        Speed at which the vehicle would have the same damage from a fixed barrier: ½ m EBS² = E [m/s].
    force : Force
        Force on the whole face at the end of the crush, A + B·C over the width [N].
    stiffness_a : LineForce
        Force per width at which crush begins [N/m].
    stiffness_b : CrushStiffness
        Force per width and depth [N/m^2].
    stiffness_g : Force
        Energy per width without residual crush, A²/(2B) [N].
    mean_crush : Size
        Mean depth over the width [m].
    crush_centre : Distance
        Distance of the centroid of the crushed area from the first station along the width [m].
    mass : Mass
        Mass [kg].
    effective_mass : Mass
        Mass as the line of force feels it, m·k²/(k² + h²) [kg].
    effective_share : Fraction
        The same over the mass [-].
    delta_v : RoadSpeed
        Size of the change of velocity of the mass centre; needs the second vehicle or that it is fixed [m/s].
    """

    energy: Energy
    energy_normal: Energy
    equivalent_barrier_speed: RoadSpeed
    force: Force
    stiffness_a: LineForce
    stiffness_b: CrushStiffness
    stiffness_g: Force
    mean_crush: Size
    crush_centre: Distance | None
    mass: Mass
    effective_mass: Mass
    effective_share: Fraction
    delta_v: RoadSpeed | None


@record
class CrushFound:
    """Energies of deformation and what they say of the impact.

    Parameters
    ----------
    first : DamageFound
        The first vehicle.
    second : DamageFound
        The second vehicle; needs its damage.
    energy : Energy
        Energy of deformation of both [J].
    impulse : Impulse
        Impulse between them; needs the second vehicle or that it is fixed [N·s].
    closing_speed : RoadSpeed
        Relative speed along the line of force at the place of damage, before [m/s].
    second_delta_v : RoadSpeed
        Change of velocity of an undamaged second body [m/s].
    """

    first: DamageFound
    second: DamageFound | None
    energy: Energy
    impulse: Impulse | None
    closing_speed: RoadSpeed | None
    second_delta_v: RoadSpeed | None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
