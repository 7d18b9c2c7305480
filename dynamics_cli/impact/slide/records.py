"""Inputs and results of a slide from the separation to rest."""

from dynamics_cli.impact.conventions import Conventions
from dynamics_cli.quantities import (
    Angle,
    AngularSpeed,
    Annotated,
    Distance,
    Energy,
    Fraction,
    Friction,
    Heading,
    PlanarPosition,
    RoadSpeed,
    Text,
    Time,
)
from dynamics_cli.records import Advice, Check, Numerics, record


@record
class Separation:
    """The motion just after the impact; the slide goes on from it to rest."""

    speed: Annotated[RoadSpeed, "Speed of the mass centre at the separation, e.g. 43 km/h [m/s]."]
    course: Annotated[Heading, "Its direction of travel there, e.g. 30 deg [rad]."]
    spin: Annotated[AngularSpeed, "Yaw rate there, from x towards y, e.g. 170 deg/s [rad/s]."] = 0.0


@record
class AtRest:
    """Where the car came to rest; the motion at the separation is looked for."""

    rest: Annotated[
        PlanarPosition, "Where its mass centre came to rest, in the axes of the scene, e.g. 9.6, 5.6 m [m]."
    ]
    rest_nose: Annotated[
        Heading, "Heading of its nose at rest with all whole turns since the separation counted, e.g. 192 deg [rad]."
    ]


@record
class Ground:
    """Ground of another friction: what is to the left of a line, or a strip along it, or a patch."""

    friction: Annotated[Friction, "Coefficient of friction there, e.g. 0.4 [-]."]
    edge_from: Annotated[PlanarPosition, "A point of the edge; the ground is to the left, seen along it, e.g. 0, 4 m."]
    edge_to: Annotated[PlanarPosition, "A second point of the edge, e.g. 10, 4 m [m]."]
    width: Annotated[
        Distance | None, "How wide a strip it is, a shoulder or a lane; all beyond the edge when left out [m]."
    ] = None
    patch: Annotated[bool, "Whether it ends at both points of the edge, a wet patch; else they only give a line."] = (
        False
    )


@record
class WheelMark:
    """What one wheel did."""

    wheel: Annotated[Text, "Which."]
    braking: Annotated[Fraction, "Share of its friction that its rotation is braked with: 1 locked [-]."]
    energy_share: Annotated[Fraction, "Its share of all the energy that the tyres took [-]."]
    mark: Annotated[Distance, "Length of its mark: where it is locked or slips sideways by more than its grip slope."]
    rest: Annotated[PlanarPosition, "Where it stands at rest [m]."]


@record
class PathPoint:
    """The car at one time of the slide."""

    time: Annotated[Time, "Time since the separation [s]."]
    position: Annotated[PlanarPosition, "Where the mass centre is [m]."]
    nose: Annotated[Angle, "Heading of the nose, whole turns counted [rad]."]


@record
class SlideRoot:
    """A motion at the separation that ends at the same rest."""

    speed: Annotated[RoadSpeed, "Speed at the separation [m/s]."]
    course: Annotated[Angle, "Direction of travel at the separation [rad]."]
    spin: Annotated[AngularSpeed, "Yaw rate at the separation [rad/s]."]


@record
class SlideResult:
    """The slide from the separation to rest."""

    speed: Annotated[RoadSpeed | None, "Speed at the separation; none where it was given [m/s]."]
    course: Annotated[Angle | None, "Direction of travel at the separation; none where it was given [rad]."]
    spin: Annotated[AngularSpeed | None, "Yaw rate at the separation; none where it was given [rad/s]."]
    rest_position: Annotated[PlanarPosition, "Where the mass centre comes to rest [m]."]
    rest_heading: Annotated[Angle, "Heading of the nose at rest, whole turns counted [rad]."]
    turned: Annotated[Angle, "How far the nose turned, whole turns counted [rad]."]
    time: Annotated[Time, "From the separation to rest [s]."]
    path_length: Annotated[Distance, "Length of the path of the mass centre [m]."]
    straight_distance: Annotated[Distance, "Straight from the separation to rest [m]."]
    bend: Annotated[
        Angle | None, "How far the straight line to rest is turned from the course; none without a way [rad]."
    ]
    mean_share: Annotated[
        Fraction | None,
        "Share of the friction that, along the path, would have stopped it from the same speed without turning [-].",
    ]
    energy: Annotated[Energy | None, "Energy that the tyres took; needs the mass [J]."]
    turned_about: Annotated[Text | None, "The wheel that stood at last, about which the car turned; none if none did."]
    wheels: Annotated[tuple[WheelMark, ...], "Each wheel."]
    path: Annotated[tuple[PathPoint, ...], "The car at equal times."]
    roots: Annotated[tuple[SlideRoot, ...], "Every motion that was found to end at this rest, the likeliest first."]
    conventions: Annotated[Conventions, "Axes and headings."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
