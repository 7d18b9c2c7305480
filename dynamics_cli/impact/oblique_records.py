"""What an oblique impact is given and what it finds."""

from dynamics_cli.impact.contact import Push
from dynamics_cli.impact.conventions import (
    ByMass,
    BySpeed,
    ByVelocity,
    ByWeight,
    Conventions,
    DeltaV,
    Fixed,
)
from dynamics_cli.quantities import (
    Angle,
    Distance,
    Energy,
    Impulse,
    Length,
    PlanarPosition,
    PlanarVelocity,
    RoadSpeed,
    RoadVelocity,
)
from dynamics_cli.records import Advice, Check, record


@record
class Moving:
    """A body that moves in the plane.

    Parameters
    ----------
    bulk : ByMass | ByWeight
        Its mass or its weight.
    motion : ByVelocity | BySpeed
        Its velocity before, by components or by speed and heading.
    nose : Angle
        Heading of its nose, for PDOF; its direction of travel when left out [rad].
    """

    bulk: ByMass | ByWeight
    motion: ByVelocity | BySpeed
    nose: Angle | None = None


@record
class Met:
    """The other body, which may rest or be fixed.

    Parameters
    ----------
    bulk : ByMass | ByWeight | Fixed
        Its mass or its weight, or that it is fixed.
    motion : ByVelocity | BySpeed
        Its velocity before; at rest when left out.
    nose : Angle
        Heading of its nose, for PDOF; its direction of travel when left out [rad].
    """

    bulk: ByMass | ByWeight | Fixed
    motion: ByVelocity | BySpeed = ByVelocity((0.0, 0.0))
    nose: Angle | None = None


@record
class Normal:
    """The line of impact by its direction.

    Parameters
    ----------
    normal : Angle
        Direction of the line of impact from the first body to the second, counted like a heading [rad].
    """

    normal: Angle


@record
class Centres:
    """The line of impact through the centres of two spheres as they touch.

    Parameters
    ----------
    first_centre : PlanarPosition
        Centre of the first sphere [m].
    second_centre : PlanarPosition
        Centre of the second sphere [m].
    """

    first_centre: PlanarPosition
    second_centre: PlanarPosition


@record
class Offset:
    """The line of impact of two spheres from the distance at which their centres would pass each other.

    Parameters
    ----------
    offset : Length
        Distance of the second centre from the relative path of the first, positive on its left (x towards y) [m].
    first_radius : Distance
        Radius of the first sphere [m].
    second_radius : Distance
        Radius of the second sphere [m].
    """

    offset: Length
    first_radius: Distance
    second_radius: Distance


@record
class AfterOblique:
    """One body after the impact.

    Parameters
    ----------
    velocity : PlanarVelocity
        Velocity after, along the axes [m/s].
    speed : RoadSpeed
        Speed after [m/s].
    heading : Angle
        Direction of travel after [rad].
    normal_velocity : RoadVelocity
        Part of the velocity after along the line of impact, from the first body to the second [m/s].
    tangential_velocity : RoadVelocity
        Part across the line, which the impact does not change, positive on the left of the line [m/s].
    delta_v : DeltaV
        Change of velocity, from the impulse over the mass; none of a fixed body.
    energy_change : Energy
        Change of the kinetic energy [J].
    """

    velocity: PlanarVelocity
    speed: RoadSpeed
    heading: Angle
    normal_velocity: RoadVelocity
    tangential_velocity: RoadVelocity
    delta_v: DeltaV | None
    energy_change: Energy


@record
class ObliqueImpact:
    """What an oblique impact of smooth bodies did.

    Parameters
    ----------
    first : AfterOblique
        The first body.
    second : AfterOblique
        The second body.
    impulse : Impulse
        Size of the impulse, along the line of impact [N·s].
    normal_direction : Angle
        Direction of the line of impact from the first body to the second [rad].
    closing_speed : RoadSpeed
        Relative speed along the line before [m/s].
    separation_speed : RoadSpeed
        Relative speed along the line after [m/s].
    sliding_speed : RoadSpeed
        Relative speed across the line, which stays [m/s].
    energy_lost : Energy
        Kinetic energy turned into other forms [J].
    push : Push
        Duration and force; needs a stiffness of the contact.
    conventions : Conventions
        Axes, headings and the zero of PDOF.
    """

    first: AfterOblique
    second: AfterOblique
    impulse: Impulse
    normal_direction: Angle
    closing_speed: RoadSpeed
    separation_speed: RoadSpeed
    sliding_speed: RoadSpeed
    energy_lost: Energy
    push: Push | None
    conventions: Conventions
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
