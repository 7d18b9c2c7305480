"""Inputs and results of a crash from one vehicle's recorded change of velocity."""

from dynamics_cli.impact.conventions import BodyName, ByMass, ByWeight, Conventions, DeltaV
from dynamics_cli.impact.planar.bodies import ByGyration, ByInertia, Lever, OnBody, Placed
from dynamics_cli.quantities import (
    Angle,
    AngularSpeed,
    Annotated,
    Energy,
    Impulse,
    PlanarPosition,
    Ratio,
    RoadSpeed,
    RoadVelocity,
    Text,
)
from dynamics_cli.records import Advice, Check, record


@record
class Recorder:
    """The vehicle with the recorder."""

    bulk: Annotated[ByMass | ByWeight, "Its mass or its weight."]
    delta_v_longitudinal: Annotated[
        RoadVelocity, "Recorded change of velocity along its nose, ahead positive, e.g. -44.6 km/h."
    ]
    delta_v_lateral: Annotated[
        RoadVelocity, "Recorded change across it: to the left positive, in SAE axes to the right, e.g. 7.2 km/h."
    ] = 0.0
    spin_change: Annotated[AngularSpeed | None, "Recorded change of its yaw rate, e.g. 1.9 rad/s."] = None
    module: Annotated[
        PlanarPosition,
        "Place of the recorder on the body from the mass centre: x ahead, y as lateral, e.g. -0.4, 0.1 m.",
    ] = (0.0, 0.0)
    nose: Annotated[Angle, "Heading of its nose at the impact, e.g. 12 deg."] = 0.0
    approach_speed: Annotated[
        RoadSpeed | None, "Its speed just before the impact, from the pre-crash record, e.g. 13.2 m/s."
    ] = None
    approach_heading: Annotated[
        Angle | None, "Its direction of travel before the impact; unless given, that of its nose."
    ] = None
    approach_spin: Annotated[AngularSpeed, "Its angular velocity just before."] = 0.0
    turning: Annotated[ByInertia | ByGyration | None, "Its yaw inertia; without it, its turning is neglected."] = None
    arm: Annotated[Lever | Placed | OnBody | None, "Where it was struck; goes with the inertia."] = None
    name: BodyName = None


@record
class Partner:
    """The other vehicle."""

    bulk: Annotated[ByMass | ByWeight, "Its mass or its weight."]
    approach_heading: Annotated[
        Angle | None, "Its direction of travel just before; when left out, the vehicles met head on (or in line)."
    ] = None
    exit_heading: Annotated[
        Angle | None, "Its direction of travel just after: with the heading before it gives the speeds, e.g. 82 deg."
    ] = None
    approach_spin: Annotated[AngularSpeed, "Its angular velocity just before."] = 0.0
    turning: Annotated[ByInertia | ByGyration | None, "Its yaw inertia; without it, its turning is neglected."] = None
    arm: Annotated[Lever | Placed | OnBody | None, "Where it was struck; goes with the inertia."] = None
    nose: Annotated[Angle | None, "Heading of its nose, for PDOF; that of its travel when left out."] = None
    name: BodyName = None


@record
class RecordedVehicle:
    """Results for the vehicle with the recorder."""

    delta_v: Annotated[DeltaV, "Change of velocity of the mass centre, and where the force came from."]
    delta_v_low: Annotated[RoadSpeed, "The same with the recorder at the lower limit of its tolerance [m/s]."]
    delta_v_high: Annotated[RoadSpeed, "The same at the upper limit [m/s]."]
    spin_change: Annotated[AngularSpeed | None, "Change of spin that the impulse gives at its lever [rad/s]."]
    exit_speed: Annotated[RoadSpeed | None, "Speed just after the impact [m/s]."]
    exit_heading: Annotated[Angle | None, "Direction of travel just after [rad]."]


@record
class OtherVehicle:
    """Results for the other vehicle."""

    delta_v: Annotated[DeltaV, "Change of velocity of the mass centre, and where the force came from."]
    approach_speed: Annotated[RoadSpeed | None, "Speed just before the impact [m/s]."]
    approach_speed_low: Annotated[RoadSpeed | None, "Lowest speed within tolerance and range of restitution [m/s]."]
    approach_speed_high: Annotated[RoadSpeed | None, "Highest speed within them [m/s]."]
    approach_heading: Annotated[Angle | None, "Direction of travel just before [rad]."]
    exit_speed: Annotated[RoadSpeed | None, "Speed just after [m/s]."]
    exit_heading: Annotated[Angle | None, "Direction of travel just after [rad]."]
    spin_change: Annotated[AngularSpeed | None, "Change of spin that the impulse gives at its lever [rad/s]."]


@record
class RecordResult:
    """The crash according to the record."""

    first: Annotated[RecordedVehicle, "The vehicle with the recorder."]
    second: Annotated[OtherVehicle, "The other vehicle."]
    closing_speed: Annotated[RoadSpeed | None, "Closing speed of the contact points along the normal [m/s]."]
    closing_speed_low: Annotated[RoadSpeed | None, "Lowest within tolerance and range of restitution [m/s]."]
    closing_speed_high: Annotated[RoadSpeed | None, "Highest within them [m/s]."]
    restitution: Annotated[
        Ratio | None, "Restitution at the contact: the middle of its range, or what the headings imply [-]."
    ]
    impulse: Annotated[Impulse, "Size of the impulse between the vehicles [N·s]."]
    impulse_heading: Annotated[Angle, "Direction of the impulse on the first vehicle [rad]."]
    impulse_ratio: Annotated[Ratio | None, "Tangential over normal impulse [-]."]
    slip_before: Annotated[RoadVelocity | None, "Velocity of the contact points along each other, before [m/s]."]
    slip_after: Annotated[RoadVelocity | None, "The same after [m/s]."]
    energy_lost: Annotated[Energy | None, "Kinetic energy lost in the contact [J]."]
    heading_tolerance: Annotated[
        Angle | None, "Error of a heading of the other vehicle that changes its speed before by a tenth [rad]."
    ]
    worst_heading: Annotated[Text | None, "The heading that this is of, as the parameter is called."]
    per_degree: Annotated[RoadSpeed | None, "Change of that speed for one degree of it [m/s]."]
    verdict: Annotated[Text | None, "How well the headings determine that speed: good, caution, undetermined."]
    conventions: Annotated[Conventions, "Axes, headings and the zero of PDOF."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
