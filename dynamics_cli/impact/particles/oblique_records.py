"""Inputs and results of an oblique impact."""

from dynamics_cli.impact.conventions import (
    BodyName,
    ByMass,
    BySpeed,
    ByVelocity,
    ByWeight,
    Conventions,
    Fixed,
)
from dynamics_cli.impact.particles.contact_time import Push
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Distance,
    Energy,
    Impulse,
    Length,
    PartVelocity,
    PlanarPosition,
    Ratio,
    Speed,
)
from dynamics_cli.records import Advice, Check, record


@record
class Moving:
    """A body that moves in the plane."""

    bulk: Annotated[ByMass | ByWeight, "Its mass or its weight."]
    motion: Annotated[ByVelocity | BySpeed, "Its velocity before, by components or by speed and heading."]
    nose: Annotated[Angle | None, "Heading of its nose, for PDOF; unless given, its direction of travel [rad]."] = None
    name: BodyName = None


@record
class Met:
    """The other body, which may rest or be fixed."""

    bulk: Annotated[ByMass | ByWeight | Fixed, "Its mass or its weight, or that it is fixed."]
    motion: Annotated[ByVelocity | BySpeed, "Its velocity before; at rest when left out."] = ByVelocity((0.0, 0.0))
    nose: Annotated[Angle | None, "Heading of its nose, for PDOF; unless given, its direction of travel [rad]."] = None
    name: BodyName = None


@record
class Normal:
    """The line of impact by its direction."""

    normal: Annotated[
        Angle, "Direction of the line of impact from the first body to the second, counted like a heading [rad]."
    ]


@record
class Centres:
    """The line of impact through the centres of two spheres as they touch."""

    first_centre: Annotated[PlanarPosition, "Centre of the first sphere, e.g. 0, 0 m [m]."]
    second_centre: Annotated[PlanarPosition, "Centre of the second sphere, e.g. 50, 20 mm [m]."]


@record
class Offset:
    """The line of impact of two spheres from the distance at which their centres would pass each other."""

    offset: Annotated[
        Length,
        "Distance of the second centre from the relative path of the first, positive on its left (x towards y), "
        "e.g. 20 mm [m].",
    ]
    first_radius: Annotated[Distance, "Radius of the first sphere, e.g. 28.6 mm [m]."]
    second_radius: Annotated[Distance, "Radius of the second sphere, e.g. 28.6 mm [m]."]


@record
class ChangeOfVelocity:
    """Change of velocity of one body as `DeltaV`, in the units of spheres and particles."""

    vector: Annotated[PartVelocity, "Change of velocity along the axes [m/s]."]
    magnitude: Annotated[Speed, "Size of the change of velocity [m/s]."]
    longitudinal: Annotated[Speed, "Its part along the nose of the body, ahead positive [m/s]."]
    lateral: Annotated[Speed, "Its lateral component: positive to the left, in SAE axes to the right [m/s]."]
    pdof: Annotated[
        Angle, "Principal direction of force: where the force came from, clockwise from the zero that is named [rad]."
    ]
    clock: Annotated[Ratio, "The same as the nearest hour on a clock whose 12 is straight ahead of the nose [h]."]


@record
class AfterOblique:
    """One body after the impact."""

    velocity: Annotated[PartVelocity, "Velocity after, along the axes [m/s]."]
    speed: Annotated[Speed, "Speed after [m/s]."]
    heading: Annotated[Angle, "Direction of travel after [rad]."]
    normal_velocity: Annotated[
        Speed, "Part of the velocity after along the line of impact, from the first body to the second [m/s]."
    ]
    tangential_velocity: Annotated[
        Speed,
        "Component across the line, which the impact does not change, positive on the left of the line [m/s].",
    ]
    delta_v: Annotated[ChangeOfVelocity | None, "Change of velocity, impulse over mass; absent for a fixed body."]
    energy_change: Annotated[Energy, "Change of the kinetic energy [J]."]


@record
class ObliqueImpact:
    """Results of an oblique impact of smooth bodies."""

    first: Annotated[AfterOblique, "The first body."]
    second: Annotated[AfterOblique, "The second body."]
    impulse: Annotated[Impulse, "Size of the impulse, along the line of impact [N·s]."]
    normal_direction: Annotated[Angle, "Direction of the line of impact from the first body to the second [rad]."]
    closing_speed: Annotated[Speed, "Relative speed along the line before [m/s]."]
    separation_speed: Annotated[Speed, "Relative speed along the line after [m/s]."]
    sliding_speed: Annotated[Speed, "Relative speed across the line, which stays [m/s]."]
    energy_lost: Annotated[Energy, "Kinetic energy turned into other forms [J]."]
    push: Annotated[Push | None, "Duration and force; needs a stiffness of the contact."]
    conventions: Annotated[Conventions, "Axes, headings and the zero of PDOF."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
