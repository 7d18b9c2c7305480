"""Inputs and results of approach speeds from exit motion."""

from dynamics_cli.impact.conventions import BodyName, ByMass, ByWeight, Conventions, DeltaV
from dynamics_cli.impact.planar.bodies import ByGyration, ByInertia, Lever, OnBody, Placed
from dynamics_cli.quantities import (
    Angle,
    AngularSpeed,
    Annotated,
    Count,
    Distance,
    DragFactor,
    Energy,
    Fraction,
    Friction,
    Heading,
    Impulse,
    PlanarImpulse,
    PlanarPosition,
    PlanarVelocity,
    Ratio,
    Restitution,
    RoadSpeed,
    Text,
)
from dynamics_cli.records import Advice, Check, Numerics, record


@record
class ExitVelocity:
    """The motion after by its components."""

    exit_velocity: Annotated[
        PlanarVelocity, "Velocity of the mass centre just after the impact, along x and y, e.g. 11.2, 0.2 m/s."
    ]


@record
class ExitSpeed:
    """The motion after by speed and heading."""

    exit_speed: Annotated[RoadSpeed, "Speed of the mass centre just after the impact, e.g. 40 km/h."]
    exit_heading: Annotated[Heading, "Direction of travel of the mass centre just after the impact, e.g. 40 deg."]


@record
class RestAfter:
    """The motion after by where it ended: a straight slide from the impact."""

    rest: Annotated[
        PlanarPosition, "Where its mass centre came to rest, from where it was at the impact, e.g. 13, 1 m."
    ]
    drag: Annotated[DragFactor, "Mean deceleration of its slide over gravity, e.g. 0.5."]


@record
class TurningAfter:
    """The motion after by where it ended, turning on its wheels."""

    rest: Annotated[
        PlanarPosition, "Where its mass centre came to rest, from where it was at the impact, e.g. 13, 1 m."
    ]
    rest_nose: Annotated[Heading, "Heading of its nose at rest, whole turns since the impact counted, e.g. 200 deg."]
    slide_friction: Annotated[Friction, "Coefficient of friction of its tyres, e.g. 0.7."]
    front_axle: Annotated[Distance, "Distance from the mass centre ahead to the front axle, e.g. 1.2 m."]
    rear_axle: Annotated[Distance, "Distance from the mass centre back to the rear axle, e.g. 1.4 m."]
    track: Annotated[Distance, "Distance between its left and right wheels, e.g. 1.5 m."]
    braking: Annotated[Fraction, "Share of its friction that a wheel is braked with: 100 % locked, 2 % rolling."]
    left_front: Annotated[Fraction | None, "The same share of the left front wheel, where it differs."] = None
    right_front: Annotated[Fraction | None, "Of the right front wheel."] = None
    left_rear: Annotated[Fraction | None, "Of the left rear wheel."] = None
    right_rear: Annotated[Fraction | None, "Of the right rear wheel."] = None


@record
class Departing:
    """A vehicle after the impact, and its known quantities before."""

    bulk: Annotated[ByMass | ByWeight, "Its mass or its weight."]
    motion: Annotated[
        ExitVelocity | ExitSpeed | RestAfter | TurningAfter, "Its motion just after the impact, or where that ended."
    ]
    turning: Annotated[ByInertia | ByGyration | None, "Its yaw inertia, needed to use its spin."] = None
    arm: Annotated[Lever | Placed | OnBody | None, "Where it was struck, needed to use its spin."] = None
    exit_spin: Annotated[AngularSpeed | None, "Angular velocity just after the impact, e.g. -2.7 rad/s."] = None
    approach_heading: Annotated[
        Heading | None, "Direction of travel just before; on a compass also NE or north; e.g. 90 deg."
    ] = None
    approach_spin: Annotated[
        AngularSpeed | None, "Angular velocity just before: 0 rad/s where it drove straight; unknown when left out."
    ] = None
    velocity_sigma: Annotated[
        RoadSpeed | None, "Standard deviation of each component of its exit velocity, in place of ±, e.g. 0.5 m/s."
    ] = None
    spin_sigma: Annotated[AngularSpeed | None, "Standard deviation of its exit spin, e.g. 0.4 rad/s."] = None
    heading_sigma: Annotated[
        Angle, "Standard deviation of its approach heading, e.g. 2 deg; 0 where it is certain."
    ] = 0.0
    rest_sigma: Annotated[
        Distance | None, "Standard deviation of each coordinate of its rest position, e.g. 0.5 m."
    ] = None
    rest_nose_sigma: Annotated[Angle, "Standard deviation of its nose at rest, e.g. 10 deg."] = 0.17453292519943295
    drag_sigma: Annotated[DragFactor, "Standard deviation of the drag or friction of its slide, e.g. 0.05."] = 0.0
    nose: Annotated[Heading | None, "Heading of its nose, for PDOF; its approach heading when left out."] = None
    name: BodyName = None


@record
class KnownContact:
    """Known data of the contact, for a forward simulation of the impact."""

    restitution: Annotated[Restitution | None, "Restitution at the contact, e.g. 0.1."] = None
    impulse_ratio: Annotated[
        Ratio | None, "Tangential over normal impulse, the tangent 90 deg on from the inward normal, e.g. -0.45."
    ] = None
    restitution_sigma: Annotated[Ratio, "Standard deviation of the restitution, e.g. 0.05."] = 0.0
    ratio_sigma: Annotated[Ratio, "Standard deviation of the ratio of impulses, e.g. 0.1."] = 0.0


UNKNOWN_CONTACT = KnownContact()


@record
class Approach:
    """The approach of one vehicle."""

    approach_speed: Annotated[RoadSpeed, "Speed just before the impact [m/s]."]
    approach_heading: Annotated[Angle, "Direction of travel just before [rad]."]
    speed_sigma: Annotated[RoadSpeed | None, "Standard deviation of that speed, from the standard deviations given."]
    heading_sigma: Annotated[Angle | None, "Standard deviation of that heading [rad]."]
    verdict: Annotated[Text | None, "How well its speed is determined."]
    heading_tolerance: Annotated[
        Angle | None, "By momentum alone: error of one heading that changes this speed by a tenth [rad]."
    ]
    worst_heading: Annotated[Text | None, "The heading that this is of, as the parameter is called."]
    per_degree: Annotated[RoadSpeed | None, "What one degree of it changes this speed by [m/s]."]
    exit_velocity: Annotated[PlanarVelocity, "Velocity after that agrees with the fit [m/s]."]
    exit_spin: Annotated[AngularSpeed | None, "Spin after that agrees with the fit [rad/s]."]
    delta_v: Annotated[DeltaV, "Change of velocity, and where the force came from."]


@record
class Residual:
    """One measurement against the fit."""

    measurement: Annotated[Text, "What was measured."]
    residual: Annotated[Ratio, "Fitted minus measured, in standard deviations [-]."]


@record
class InverseResult:
    """The approach of both vehicles, and how well the measurements agree."""

    first: Annotated[Approach, "The first vehicle."]
    second: Annotated[Approach, "The second vehicle."]
    correlation: Annotated[Ratio | None, "Correlation of the two speeds [-]."]
    least_certain: Annotated[Text | None, "The direction in which the two speeds are known least, in words."]
    least_certain_sigma: Annotated[RoadSpeed | None, "Standard deviation in that direction [m/s]."]
    impulse: Annotated[PlanarImpulse, "Impulse on the first vehicle along x and y [N·s]."]
    impulse_size: Annotated[Impulse, "Size of that impulse [N·s]."]
    chi_squared: Annotated[Ratio | None, "Sum of the squared residuals, in standard deviations [-]."]
    degrees_of_freedom: Annotated[Count, "Measurements minus unknowns; at 0 nothing is left to compare."]
    probability: Annotated[
        Fraction | None, "Probability that correct measurements disagree as much or more (chi-squared)."
    ]
    lever_sine: Annotated[
        Ratio | None, "Sine of the angle between the levers to the contact, for headings from spins [-]."
    ]
    restitution: Annotated[Ratio | None, "Implied restitution at the contact [-]."]
    restitution_sigma: Annotated[Ratio | None, "Standard deviation of the implied restitution [-]."]
    impulse_ratio: Annotated[Ratio | None, "Implied tangential over normal impulse [-]."]
    impulse_ratio_sigma: Annotated[Ratio | None, "Standard deviation of the implied ratio of impulses [-]."]
    energy_lost: Annotated[Energy | None, "Kinetic energy lost in the contact, where the spins are known [J]."]
    residuals: Annotated[tuple[Residual, ...], "Measurements against the fit, the worst first."]
    conventions: Annotated[Conventions, "Axes, headings and the zero of PDOF."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
