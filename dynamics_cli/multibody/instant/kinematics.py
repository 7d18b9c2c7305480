"""The task `kinematics`: places, velocities and accelerations of a tree of bodies, and their partial velocities."""

from dynamics_cli.multibody.bodies.energy import kinetic, momentum, potential
from dynamics_cli.multibody.bodies.records import ORIGIN, Scene, Upward
from dynamics_cli.multibody.bodies.system import System
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.orientation.quaternions import of_rotation, upright
from dynamics_cli.numerics.trees.matrix import partial
from dynamics_cli.numerics.trees.newton_euler import at_point, sweep
from dynamics_cli.numerics.vectors import add, length, scale, times
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    AccelerationVector,
    AngularAccelerationVector,
    AngularMomentumVector,
    AngularVelocity,
    Annotated,
    FreeVector,
    Gravity,
    ImpulseVector,
    Kind,
    PotentialEnergy,
    Quaternion,
    SpacePosition,
    SpaceVelocity,
    Text,
    Vector,
)
from dynamics_cli.records import Advice, Check, Numerics, Quantity, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.trees.newton_euler import Motion

# A velocity per speed of a joint: a length where that turns.
PER_ANGLE: "Any" = Kind("partial velocity", "m/rad", us="ft/rad", form="vector", about="velocity per angular velocity")
PER_LENGTH: "Any" = Kind("partial velocity", "", form="vector", about="velocity per velocity")
TURN_PER_ANGLE: "Any" = Kind("partial angular velocity", "", form="vector", about="angular velocity per such")
TURN_PER_LENGTH: "Any" = Kind("partial angular velocity", "rad/m", us="rad/ft", form="vector", about="ω per velocity")
SAME = 1e-12


@record
class BodyMotion:
    """Where a body is and how fast, in ground axes."""

    body: Annotated[Text, "The body."]
    centre: Annotated[SpacePosition, "Its mass centre [m]."]
    velocity: Annotated[SpaceVelocity, "Velocity of the mass centre [m/s]."]
    acceleration: Annotated[AccelerationVector, "Acceleration of the mass centre [m/s^2]."]
    origin: Annotated[SpacePosition, "Its own origin, at its joint [m]."]


@record
class Turning:
    """How a body turns, in ground axes."""

    body: Annotated[Text, "The body."]
    angular_velocity: Annotated[AngularVelocity, "Its angular velocity [rad/s]."]
    angular_acceleration: Annotated[AngularAccelerationVector, "Its angular acceleration [rad/s^2]."]


@record
class PartialRow:
    """What one speed adds to the motion of a body and of a point, per unit of it, in ground axes."""

    speed: Annotated[Text, "The speed."]
    velocity: Annotated[FreeVector, "Partial velocity of the point."]
    angular_velocity: Annotated[FreeVector, "Partial angular velocity of the body."]


@record
class Kinematics:
    """Motion of a tree of bodies."""

    point_position: Annotated[SpacePosition | None, "The point asked for, in the ground's frame [m]."]
    point_velocity: Annotated[SpaceVelocity | None, "Its velocity [m/s]."]
    point_acceleration: Annotated[AccelerationVector | None, "Its acceleration [m/s^2]."]
    axes: Annotated[
        tuple[Vector, ...] | None, "Rows of the rotation that takes the body's axes to those of the ground [-]."
    ]
    euler_parameters: Annotated[Quaternion | None, "Its Euler parameters e₀, e₁, e₂, e₃, scalar first [-]."]
    bodies: Annotated[tuple[BodyMotion, ...] | None, "All bodies, in ground axes; not beside the one asked for."]
    turning: Annotated[tuple[Turning, ...], "How they turn, or the one asked for, in ground axes."]
    partials: Annotated[tuple[PartialRow, ...] | None, "Partial velocities of the point and of its body."]
    kinetic_energy: Annotated[PotentialEnergy, "Kinetic energy [J]."]
    potential_energy: Annotated[PotentialEnergy, "Of weights above the ground's origin, and of springs [J]."]
    momentum: Annotated[ImpulseVector, "Linear momentum, in ground axes [N*s]."]
    angular_momentum: Annotated[AngularMomentumVector, "About the ground's origin, or --about [N*m*s]."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def kinematics(
    scene: Annotated[Scene, "The bodies, from a file."],
    /,
    *,
    of: Annotated[Text | None, "The body whose axes, point and partial velocities are shown, e.g. boom."] = None,
    point: Annotated[SpacePosition, "A point of that body, in its own axes, e.g. 0, 0, -0.5 m."] = ORIGIN,
    about: Annotated[SpacePosition, "Point of the ground that the angular momentum is about [m]."] = ORIGIN,
    up: Annotated[Upward, "The axis that points up: x, y, z, or none without gravity."] = Upward("z"),  # noqa: B008
    gravity: Annotated[Gravity, "Acceleration of gravity, for the potential energy [m/s^2]."] = STANDARD_GRAVITY,
) -> Kinematics:
    """Places, velocities and accelerations of a tree of bodies for the motion of its joints, with partial velocities.

    Equation
    --------
    S_OK = S_OJ·S_JK; ω_K = ω_J + axis·y; a_K = a_J + α_J × r + ω_J × (ω_J × r) + 2ω_K × axis·y + axis·ẏ.

    Raises
    ------
    InadmissibleError
        When the body is unknown, or a joint has too many numbers.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.3 to 18.14.

    Examples
    --------
    >>> from dynamics_cli.multibody.bodies.records import Body
    >>> arm = Body("arm", axis=(0.0, 1.0, 0.0), mass=2.0, rod=(1.0, 0.0, 0.0), speed=(3.0,))
    >>> kinematics(Scene((arm,)), of="arm", point=(1.0, 0.0, 0.0)).point_velocity
    (0.0, 0.0, -3.0)
    """
    asked = of is not None
    system = System(scene, up, gravity)
    motions = sweep(system.tree, system.frames, system.speeds, system.accelerations)
    k = system.body_link(of) if of is not None else len(system.tree.links) - 1
    rotation, origin = system.ground[k]
    place = add(origin, times(rotation, point))
    velocity, acceleration = at_point(motions[k], point)
    velocity, acceleration = times(rotation, velocity), times(rotation, acceleration)
    ways = partial(system.tree, system.ground, k, place)
    linear, angular = momentum(system, motions, about)
    rows = (_row(name, turns, *way) for name, turns, way in zip(system.names, system.turning, ways, strict=True))
    # the partial velocities give the velocity once more
    again = ORIGIN
    size = 0.0
    for speed, (_, way) in zip(system.speeds, ways, strict=True):
        size += abs(plain(speed)) * plain(length(way))
        again = add(again, scale(speed, way))
    off = max(abs(plain(a) - plain(b)) for a, b in zip(again, velocity, strict=True)) / size if size else 0.0
    return Kinematics(
        point_position=place if asked else None,
        point_velocity=velocity if asked else None,
        point_acceleration=acceleration if asked else None,
        axes=rotation if asked else None,
        euler_parameters=upright(of_rotation(rotation)) if asked else None,
        bodies=None if asked else tuple(_motion(system, one.name, motions) for one in system.bodies),
        turning=tuple(_turning(system, one.name, motions) for one in system.bodies if of in (None, one.name)),
        partials=tuple(rows) if asked else None,
        kinetic_energy=kinetic(system, motions),
        potential_energy=potential(system),
        momentum=linear,
        angular_momentum=angular,
        numerics=Numerics("recursion from the ground outwards"),
        checks=(Check("partial velocities give the velocity", off <= SAME, off, SAME),),
        advice=tuple(system.advice),
    )


def _motion(system: System, name: str, motions: "list[Motion]") -> BodyMotion:
    k = system.link[name]
    rotation, origin = system.ground[k]
    velocity, acceleration = at_point(motions[k], system.tree.links[k].centroid)
    return BodyMotion(name, system.centre(k), times(rotation, velocity), times(rotation, acceleration), origin)


def _turning(system: System, name: str, motions: "list[Motion]") -> Turning:
    k = system.link[name]
    rotation = system.ground[k][0]
    return Turning(name, times(rotation, motions[k][0]), times(rotation, motions[k][1]))


def _row(name: str, turns: bool, turning: "Any", way: "Any") -> PartialRow:
    return PartialRow(
        name,
        Quantity(way, PER_ANGLE if turns else PER_LENGTH),
        Quantity(turning, TURN_PER_ANGLE if turns else TURN_PER_LENGTH),
    )
