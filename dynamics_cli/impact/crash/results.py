"""Results of a whole crash."""

from dynamics_cli.impact.conventions import Conventions
from dynamics_cli.quantities import (
    Angle,
    AngularSpeed,
    Annotated,
    Distance,
    Energy,
    Fraction,
    Length,
    PlanarPosition,
    Ratio,
    RoadSpeed,
    RoadVelocity,
    Text,
    Time,
)
from dynamics_cli.records import Advice, Check, record


@record
class BeforeImpact:
    """A vehicle from its first phase to the impact."""

    speed: Annotated[RoadSpeed, "Speed where its first phase begins: at perception, or at the first mark [m/s]."]
    time: Annotated[Time, "How long before the impact that was [s]."]
    distance: Annotated[Distance, "How far before the impact [m]."]
    position: Annotated[PlanarPosition | None, "Where, back along its approach heading; needs that heading [m]."]
    braking_speed: Annotated[RoadSpeed | None, "Speed where it began to brake; none without braking [m/s]."]
    braking_time: Annotated[Time | None, "How long before the impact that was; none without braking [s]."]
    braking_distance: Annotated[Distance | None, "How far before the impact; none without braking [m]."]
    impact_speed_at_limit: Annotated[
        RoadSpeed | None,
        "Speed into the impact had it braked alike, from the same place, from the limit: 0 when it would have stopped "
        "[m/s].",
    ]


@record
class CrashDeltaV:
    """Change of velocity of one vehicle, and where the force came from; `impact momentum` gives more detail."""

    magnitude: Annotated[RoadSpeed, "Size of the change of velocity [m/s]."]
    pdof: Annotated[
        Angle, "Principal direction of force: where the force came from, clockwise from the zero that is named [rad]."
    ]


@record
class CrashCourse:
    """One vehicle through the whole crash."""

    start: Annotated[BeforeImpact | None, "Its start; absent when it has no phase before the impact."]
    approach_speed: Annotated[RoadSpeed, "Speed just before the impact [m/s]."]
    approach_heading: Annotated[Angle, "Direction of travel just before the impact [rad]."]
    exit_speed: Annotated[RoadSpeed, "Speed just after the impact, where it separates [m/s]."]
    exit_heading: Annotated[Angle, "Direction of travel just after the impact [rad]."]
    exit_spin: Annotated[AngularSpeed | None, "Yaw rate just after, from a slide with spin; none without [rad/s]."]
    delta_v: Annotated[CrashDeltaV, "Change of velocity in the impact, and where the force came from."]
    slide_distance: Annotated[Distance | None, "Length of the slide; none without one [m]."]
    rest_position: Annotated[PlanarPosition | None, "Where the slide ends, straight along its exit heading [m]."]
    per_degree: Annotated[
        RoadSpeed | None, "What one degree of the worst heading changes its speed into the impact by [m/s]."
    ] = None


@record
class CrashEnergy:
    """Energy balance of both vehicles."""

    start: Annotated[Energy, "Kinetic energy of both where their first phases begin, or at the impact [J]."]
    before: Annotated[Energy, "Lost before the impact to tyres and grade, less what they gained [J]."]
    impact: Annotated[Energy, "Lost in the impact, mostly as deformation and rotation [J]."]
    after: Annotated[Energy, "Lost after the impact to tyres and grade [J]."]
    remaining: Annotated[Energy, "Left where the slides end: nothing at rest, all of an exit without a slide [J]."]


@record
class Course:
    """One row of the course through the crash."""

    vehicle: Annotated[Text, "Whose."]
    what: Annotated[Text, "A phase before the impact, the impact, or the surface of the slide after it."]
    start_speed: Annotated[RoadSpeed, "Speed where it begins [m/s]."]
    end_speed: Annotated[RoadSpeed, "Speed where it ends [m/s]."]
    duration: Annotated[Time, "How long it takes [s]."]
    distance: Annotated[Distance, "How far it goes [m]."]
    energy: Annotated[Energy, "Kinetic energy that it takes from the vehicle [J]."]


@record
class LinkVerdict:
    """How well the measurements determine one step of the reconstruction."""

    link: Annotated[Text, "The step: a slide, the impact as one vehicle sees it, or the braking before."]
    verdict: Annotated[Text, "good, caution or undetermined."]
    decided_by: Annotated[Text, "The input that it depends on most."]
    friction: Annotated[
        Fraction | None, "Relative error of friction that changes its speed by a tenth; none in the impact [-]."
    ]
    heading: Annotated[
        Angle | None, "Error of the worst heading that changes its speed by a tenth; only in the impact [rad]."
    ]
    per_degree: Annotated[
        RoadSpeed | None, "What one degree of that heading changes the speed by; only in the impact [m/s]."
    ] = None


@record
class Agreement:
    """One quantity by two links."""

    quantity: Annotated[Text, "The quantity that both give."]
    one: Annotated[Text, "The first of them."]
    other: Annotated[Text, "The second."]
    speed_gap: Annotated[RoadVelocity | None, "By how much the second is less, for speeds [m/s]."]
    distance_gap: Annotated[Length | None, "How far both are apart, for positions [m]."]
    normalised: Annotated[
        Ratio | None, "The gap over its standard deviation, to first order; none without uncertain inputs [-]."
    ]


@record
class Crash:
    """The whole crash."""

    first: Annotated[CrashCourse, "The first vehicle."]
    second: Annotated[CrashCourse, "The second vehicle."]
    closing_speed: Annotated[RoadSpeed, "Relative speed of the mass centres just before the impact [m/s]."]
    restitution: Annotated[Ratio, "Separation over closing along the impulse, of the mass centres [-]."]
    angle_condition: Annotated[Ratio | None, "Angle condition of the approach paths, 1 when they are square [-]."]
    energy: Annotated[CrashEnergy, "Energy of the whole crash."]
    weakest: Annotated[Text, "The weakest link."]
    courses: Annotated[tuple[Course, ...], "Both vehicles through phases, impact and slides."]
    links: Annotated[tuple[LinkVerdict, ...], "The verdict of every link."]
    agreements: Annotated[tuple[Agreement, ...], "Quantities that two links give."]
    conventions: Annotated[Conventions, "Axes, headings and the zero of PDOF."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
