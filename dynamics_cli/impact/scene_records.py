"""Two bodies and one contact as a scene file states them."""

from dynamics_cli.impact.conventions import ByMass, BySpeed, ByWeight, Fixed
from dynamics_cli.impact.space import ZERO
from dynamics_cli.impact.spatial import SPATIAL_LAW, LeverInSpace, PlacedInSpace, SpatialLaw
from dynamics_cli.quantities import (
    AngularSpeed,
    AngularVelocity,
    Direction,
    Distance,
    Friction,
    Inertia,
    InertiaTensor,
    Position,
    Restitution,
    Velocity,
)
from dynamics_cli.records import record


@record
class ByTensor:
    """Inertia about the mass centre by its tensor.

    Parameters
    ----------
    inertia : InertiaTensor
        Inertia about the mass centre, along the axes of the scene [kg·m²].
    """

    inertia: InertiaTensor


@record
class ByMoment:
    """Inertia of a body that turns about z only, or about any axis alike.

    Parameters
    ----------
    moment : Inertia
        Moment of inertia about the axis through the mass centre that the body turns about [kg·m²].
    """

    moment: Inertia


@record
class ByRadius:
    """The same by the radius of gyration.

    Parameters
    ----------
    radius_of_gyration : Distance
        Radius of gyration about the axis through the mass centre that the body turns about [m].
    """

    radius_of_gyration: Distance


@record
class ByComponents:
    """A velocity by its components.

    Parameters
    ----------
    velocity : Velocity
        Velocity of the mass centre [m/s].
    """

    velocity: Velocity


@record
class SpinVector:
    """An angular velocity by its components.

    Parameters
    ----------
    spin : AngularVelocity
        Angular velocity [rad/s].
    """

    spin: AngularVelocity


@record
class YawRate:
    """An angular velocity about z.

    Parameters
    ----------
    yaw_rate : AngularSpeed
        Angular velocity about z, from x towards y [rad/s].
    """

    yaw_rate: AngularSpeed


@record
class SceneBody:
    """A body of a scene.

    Parameters
    ----------
    bulk : ByMass | ByWeight | Fixed
        Its mass or its weight, or that it is fixed.
    turning : ByTensor | ByMoment | ByRadius
        Its inertia; a particle has none.
    arm : LeverInSpace | PlacedInSpace
        Where it is struck; a particle at itself.
    motion : ByComponents | BySpeed
        Its velocity before; at rest when left out.
    rotation : SpinVector | YawRate
        Its angular velocity before; none when left out.
    nose : Direction
        Direction of its nose, for PDOF; its direction of travel when left out.
    """

    bulk: ByMass | ByWeight | Fixed
    turning: ByTensor | ByMoment | ByRadius | None = None
    arm: LeverInSpace | PlacedInSpace | None = None
    motion: ByComponents | BySpeed = ByComponents(ZERO)
    rotation: SpinVector | YawRate = YawRate(0.0)
    nose: Direction | None = None


@record
class SceneContact:
    """The contact of a scene.

    Parameters
    ----------
    normal : Direction
        Contact normal from the first body to the second, of any length.
    restitution : Restitution
        Coefficient of restitution [-].
    friction : Friction
        Coefficient of friction; none when left out [-].
    law : SpatialLaw
        What ends the impact: stronge, newton or poisson.
    point : Position
        Where the bodies touch, when bodies are placed by their centres [m].
    """

    normal: Direction
    restitution: Restitution
    friction: Friction = 0.0
    law: SpatialLaw = SPATIAL_LAW
    point: Position | None = None


@record
class Scene:
    """Two bodies and a contact.

    Parameters
    ----------
    first : SceneBody
        The first body.
    second : SceneBody
        The second body.
    contact : SceneContact
        Their contact.
    """

    first: SceneBody
    second: SceneBody
    contact: SceneContact
