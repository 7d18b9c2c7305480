"""Two bodies and one contact as stated in a scene file."""

from dynamics_cli.impact.conventions import BodyName, ByMass, BySpeed, ByWeight, Fixed
from dynamics_cli.impact.spatial.bodies import ZERO
from dynamics_cli.impact.spatial.impact import SPATIAL_LAW, LeverInSpace, PlacedInSpace, SpatialLaw
from dynamics_cli.quantities import (
    AngularSpeed,
    AngularVelocity,
    Annotated,
    Direction,
    Distance,
    Friction,
    Inertia,
    InertiaTensor,
    Restitution,
    SpacePosition,
    SpaceVelocity,
)
from dynamics_cli.records import record


@record
class ByTensor:
    """Inertia about the mass centre by its tensor."""

    inertia: Annotated[InertiaTensor, "Inertia about the mass centre, along the axes of the scene [kg·m²]."]


@record
class ByMoment:
    """Inertia of a body that turns about z only, or equally about any axis."""

    moment: Annotated[
        Inertia, "Moment of inertia about the axis through the mass centre that the body turns about [kg·m²]."
    ]


@record
class ByRadius:
    """The same by the radius of gyration."""

    radius_of_gyration: Annotated[
        Distance, "Radius of gyration about the axis through the mass centre that the body turns about, e.g. 1.3 m [m]."
    ]


@record
class ByComponents:
    """A velocity by its components."""

    velocity: Annotated[SpaceVelocity, "Velocity of the mass centre [m/s]."]


@record
class SpinVector:
    """An angular velocity by its components."""

    spin: Annotated[AngularVelocity, "Angular velocity [rad/s]."]


@record
class YawRate:
    """An angular velocity about z."""

    yaw_rate: Annotated[AngularSpeed, "Angular velocity about z, from x towards y, e.g. 40 deg/s [rad/s]."]


@record
class SceneBody:
    """A body of a scene."""

    bulk: Annotated[ByMass | ByWeight | Fixed, "Its mass or its weight, or that it is fixed."]
    turning: Annotated[ByTensor | ByMoment | ByRadius | None, "Its inertia; left out for a particle."] = None
    arm: Annotated[LeverInSpace | PlacedInSpace | None, "Where it is struck; left out for a particle."] = None
    motion: Annotated[ByComponents | BySpeed, "Its velocity before; at rest when left out."] = ByComponents(ZERO)
    rotation: Annotated[SpinVector | YawRate, "Its angular velocity before; zero if left out."] = YawRate(0.0)
    nose: Annotated[
        Direction | None, "Direction of its nose, for PDOF; unless given, its direction of travel, e.g. 1, 0, 0."
    ] = None
    name: BodyName = None


@record
class SceneContact:
    """The contact of a scene."""

    normal: Annotated[Direction, "Contact normal from the first body to the second, of any length."]
    restitution: Annotated[Restitution, "Coefficient of restitution [-]."]
    friction: Annotated[Friction, "Coefficient of friction; zero if left out [-]."] = 0.0
    law: Annotated[SpatialLaw, "What ends the impact: stronge, newton or poisson."] = SPATIAL_LAW
    point: Annotated[SpacePosition | None, "Where the bodies touch, when bodies are placed by their centres [m]."] = (
        None
    )


@record
class Scene:
    """Two bodies and a contact."""

    first: Annotated[SceneBody, "The first body."]
    second: Annotated[SceneBody, "The second body."]
    contact: Annotated[SceneContact, "Their contact."]
