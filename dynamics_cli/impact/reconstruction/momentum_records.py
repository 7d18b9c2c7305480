"""Inputs and results of a momentum reconstruction."""

from dynamics_cli.impact.conventions import (
    BodyName,
    ByMass,
    ByWeight,
    Conventions,
    DeltaV,
)
from dynamics_cli.impact.reconstruction.momentum_verdict import SpeedVerdict
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Energy,
    Heading,
    Impulse,
    Ratio,
    RoadSpeed,
    RoadVelocity,
    Text,
)
from dynamics_cli.records import Advice, Check, record


@record
class Vehicle:
    """A vehicle before and after; omitted quantities are unknown, at most two in total."""

    bulk: Annotated[ByMass | ByWeight, "Its mass or its weight."]
    approach_speed: Annotated[RoadSpeed | None, "Speed just before the impact [m/s]."] = None
    approach_heading: Annotated[
        Heading | None, "Direction of travel just before; on a compass also NE or north; e.g. 90 deg [rad]."
    ] = None
    exit_speed: Annotated[RoadSpeed | None, "Speed of the mass centre just after the impact, e.g. 22 mph [m/s]."] = None
    exit_heading: Annotated[
        Heading | None, "Direction of travel of the mass centre just after the impact, e.g. 40 deg [rad]."
    ] = None
    nose: Annotated[Heading | None, "Heading of its nose, for PDOF; its approach heading when left out [rad]."] = None
    name: BodyName = None


@record
class CrushEnergies:
    """Damage by the energies of deformation."""

    first_crush_energy: Annotated[Energy, "Energy of deformation of the first vehicle [J]."]
    second_crush_energy: Annotated[Energy, "Energy of deformation of the second vehicle [J]."]


@record
class EquivalentSpeeds:
    """Damage by energy equivalent speeds."""

    first_ees: Annotated[
        RoadSpeed,
        "Energy equivalent speed of the first vehicle: ½ m EES² is its energy of deformation, e.g. 25 km/h [m/s].",
    ]
    second_ees: Annotated[RoadSpeed, "Energy equivalent speed of the second vehicle, e.g. 15 km/h [m/s]."]


@record
class Reconstructed:
    """One vehicle, reconstructed."""

    approach_speed: Annotated[RoadSpeed, "Speed before [m/s]."]
    approach_heading: Annotated[Angle, "Direction of travel before [rad]."]
    exit_speed: Annotated[RoadSpeed, "Speed after [m/s]."]
    exit_heading: Annotated[Angle, "Direction of travel after [rad]."]
    delta_v: Annotated[DeltaV, "Change of velocity, and where the force came from."]
    energy_change: Annotated[Energy, "Change of the kinetic energy of the mass centre [J]."]
    determined: Annotated[
        SpeedVerdict | None,
        "How well the headings determine its reconstructed speed (of two, the worse one).",
    ] = None


@record
class MomentumResult:
    """Both vehicles before and after, and the reliability of the answer."""

    first: Annotated[Reconstructed, "The first vehicle."]
    second: Annotated[Reconstructed, "The second vehicle."]
    angle_condition: Annotated[
        Ratio | None,
        "Cotangent of half the angle between the lines of the unknown speeds: 1 at 90 degrees, 11 at 10 [-].",
    ]
    verdict: Annotated[Text | None, "The worse of both vehicles' verdicts."]
    impulse: Annotated[Impulse, "Size of the impulse between the vehicles [N·s]."]
    impulse_heading: Annotated[Angle, "Direction of the impulse on the first vehicle [rad]."]
    closing_speed: Annotated[RoadSpeed, "Relative speed of the mass centres before [m/s]."]
    closing_along_impulse: Annotated[
        RoadVelocity, "The part of it along the impulse, positive when they approach [m/s]."
    ]
    separation_along_impulse: Annotated[
        RoadVelocity, "Relative speed of the mass centres after, along the impulse, positive when they part [m/s]."
    ]
    restitution: Annotated[Ratio, "Separation over closing along the impulse, of the mass centres [-]."]
    energy_lost: Annotated[Energy, "Kinetic energy of the mass centres turned into other forms, spins among them [J]."]
    total_momentum: Annotated[Impulse, "Size of the momentum of both [N·s]."]
    momentum_heading: Annotated[Angle, "Its direction [rad]."]
    closure: Annotated[
        Impulse | None, "Momentum that remains unbalanced when fewer than two quantities are unknown [N·s]."
    ]
    conventions: Annotated[Conventions, "Axes, headings and the zero of PDOF."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
