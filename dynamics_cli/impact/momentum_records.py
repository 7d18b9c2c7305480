"""What a momentum reconstruction is given and what it finds."""

from dynamics_cli.impact.conventions import (
    ByMass,
    ByWeight,
    Conventions,
    DeltaV,
)
from dynamics_cli.quantities import (
    Angle,
    Energy,
    Impulse,
    Ratio,
    RoadSpeed,
    RoadVelocity,
    Text,
)
from dynamics_cli.records import Advice, Check, record


@record
class Vehicle:
    """A vehicle before and after; what is left out is unknown, up to two quantities in all.

    Parameters
    ----------
    bulk : ByMass | ByWeight
        Its mass or its weight.
    approach_speed : RoadSpeed
        Speed just before the impact [m/s].
    approach_heading : Angle
        Direction of travel just before the impact [rad].
    exit_speed : RoadSpeed
        Speed of the mass centre just after the impact [m/s].
    exit_heading : Angle
        Direction of travel of the mass centre just after the impact [rad].
    nose : Angle
        Heading of its nose, for PDOF; its approach heading when left out [rad].
    """

    bulk: ByMass | ByWeight
    approach_speed: RoadSpeed | None = None
    approach_heading: Angle | None = None
    exit_speed: RoadSpeed | None = None
    exit_heading: Angle | None = None
    nose: Angle | None = None


@record
class CrushEnergies:
    """Damage by the energies of deformation.

    Parameters
    ----------
    first_crush_energy : Energy
        Energy of deformation of the first vehicle [J].
    second_crush_energy : Energy
        Energy of deformation of the second vehicle [J].
    """

    first_crush_energy: Energy
    second_crush_energy: Energy


@record
class EquivalentSpeeds:
    """Damage by energy equivalent speeds.

    Parameters
    ----------
    first_ees : RoadSpeed
        Energy equivalent speed of the first vehicle: ½ m EES² is its energy of deformation [m/s].
    second_ees : RoadSpeed
        Energy equivalent speed of the second vehicle [m/s].
    """

    first_ees: RoadSpeed
    second_ees: RoadSpeed


@record
class Reconstructed:
    """One vehicle, reconstructed.

    Parameters
    ----------
    approach_speed : RoadSpeed
        Speed before [m/s].
    approach_heading : Angle
        Direction of travel before [rad].
    exit_speed : RoadSpeed
        Speed after [m/s].
    exit_heading : Angle
        Direction of travel after [rad].
    delta_v : DeltaV
        Change of velocity, and where the force came from.
    energy_change : Energy
        Change of the kinetic energy of the mass centre [J].
    """

    approach_speed: RoadSpeed
    approach_heading: Angle
    exit_speed: RoadSpeed
    exit_heading: Angle
    delta_v: DeltaV
    energy_change: Energy


@record
class MomentumFound:
    """Both vehicles before and after, and how far the answer can be trusted.

    Parameters
    ----------
    first : Reconstructed
        The first vehicle.
    second : Reconstructed
        The second vehicle.
    angle_condition : Ratio
        Cotangent of half the angle between the lines of the unknown speeds: 1 at 90 degrees, 11 at 10 [-].
    verdict : Text
        good up to 4, caution above; above 12 the answer is refused.
    impulse : Impulse
        Size of the impulse between the vehicles [N·s].
    impulse_heading : Angle
        Direction of the impulse on the first vehicle [rad].
    closing_speed : RoadSpeed
        Relative speed of the mass centres before [m/s].
    closing_along_impulse : RoadVelocity
        The part of it along the impulse, positive when they approach [m/s].
    separation_along_impulse : RoadVelocity
        Relative speed of the mass centres after, along the impulse, positive when they part [m/s].
    restitution : Ratio
        Separation over closing along the impulse, of the mass centres [-].
    energy_lost : Energy
        Kinetic energy of the mass centres turned into other forms, spins among them [J].
    total_momentum : Impulse
        Size of the momentum of both [N·s].
    momentum_heading : Angle
        Its direction [rad].
    closure : Impulse
        Momentum that is left over when fewer than two quantities are unknown [N·s].
    conventions : Conventions
        Axes, headings and the zero of PDOF.
    """

    first: Reconstructed
    second: Reconstructed
    angle_condition: Ratio | None
    verdict: Text | None
    impulse: Impulse
    impulse_heading: Angle
    closing_speed: RoadSpeed
    closing_along_impulse: RoadVelocity
    separation_along_impulse: RoadVelocity
    restitution: Ratio
    energy_lost: Energy
    total_momentum: Impulse
    momentum_heading: Angle
    closure: Impulse | None
    conventions: Conventions
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
