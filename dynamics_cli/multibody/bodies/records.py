"""A scene of bodies in space as users write it: each on the joint that carries it, with its state and its loads."""

from dynamics_cli.numerics.orientation.rotations import Turn
from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    AngleFormula,
    AngularAcceleration,
    Annotated,
    Damping,
    Direction,
    Force,
    ForceVector,
    Inertia,
    InertiaTensor,
    InertiaTriple,
    Length,
    LengthFormula,
    Mass,
    Quaternion,
    Size,
    SpacePosition,
    Speed,
    Stiffness,
    Text,
    Torque,
    TorqueVector,
    TorsionDamping,
    TorsionStiffness,
    TurnRate,
)
from dynamics_cli.records import Choice, record

GROUND = "ground"
ORIGIN = (0.0, 0.0, 0.0)


class Joint(Choice):
    """How a body is joined to the one that carries it."""

    names = ("revolute", "prismatic", "cylindrical", "universal", "ball", "planar", "free", "fixed")
    aliases = {  # noqa: RUF012
        "pin": "revolute", "hinge": "revolute", "slide": "prismatic", "slider": "prismatic", "spherical": "ball",
        "cardan": "universal", "weld": "fixed", "rigid": "fixed", "floating": "free",
    }  # fmt: skip


class Axes(Choice):
    """The axes that components are along."""

    names = ("ground", "body")


class Upward(Choice):
    """Which axis points up."""

    names = ("x", "y", "z", "none")


@record
class Body:
    """A rigid body. Its own axes sit at the joint that carries it, and turn and slide with it."""

    name: Annotated[Text, "Its name, e.g. boom."]
    parent: Annotated[Text, "The body that carries it; ground by default."] = GROUND
    joint: Annotated[
        Joint, "The joint: revolute (pin), prismatic (slide), cylindrical, universal, ball, planar, free, fixed (weld)."
    ] = Joint("revolute")
    axis: Annotated[Direction, "Axis of the joint, in its own axes; of a planar joint the normal."] = (0.0, 0.0, 1.0)
    second_axis: Annotated[Direction | None, "Second axis of a universal joint, which turns with the first."] = None
    position: Annotated[SpacePosition, "Where the joint is, in the axes of the carrying body [m]."] = ORIGIN
    turn: Annotated[Turn | None, "How the joint's axes are turned from those of the carrying body."] = None
    mass: Annotated[Mass, "Mass; without one it is massless, e.g. 2 kg."] = 0.0
    centroid: Annotated[SpacePosition | None, "Mass centre, in its own axes [m]."] = None
    tensor: Annotated[InertiaTensor | None, "Inertia tensor about the mass centre, in its own axes [kg*m^2]."] = None
    moments: Annotated[InertiaTriple | None, "Or its principal moments along its own axes, e.g. 2, 3, 4 kg*m^2."] = None
    rod: Annotated[SpacePosition | None, "Or the end of a slender uniform rod that begins at the joint [m]."] = None
    angle: Annotated[tuple[Angle, ...], "Angle of the joint (two of a universal joint), e.g. 20 deg."] = ()
    slide: Annotated[tuple[Length, ...], "Way along the joint's axis; two of a planar, three of a free joint [m]."] = ()
    orientation: Annotated[
        Quaternion | None, "Euler parameters of a ball or free joint, scalar first, e.g. 0.924, 0, 0, 0.383."
    ] = None
    speed: Annotated[
        tuple[TurnRate, ...], "Rate of each angle; of a ball or free joint ω against the carrier, in its own axes."
    ] = ()
    velocity: Annotated[tuple[Speed, ...], "Rate of each way, e.g. 0.5 m/s."] = ()
    angular_acceleration: Annotated[tuple[AngularAcceleration, ...], "Rate of each turning speed, e.g. 3 rad/s^2."] = ()
    acceleration: Annotated[tuple[Acceleration, ...], "Rate of each sliding speed, e.g. 1 m/s^2."] = ()
    torque: Annotated[tuple[Torque, ...], "Torque of the joint's motor for each turning speed, e.g. 2 N*m."] = ()
    force: Annotated[tuple[Force, ...], "Force of the joint's motor for each sliding speed, e.g. 20 N."] = ()
    torsion_stiffness: Annotated[TorsionStiffness, "Torsion spring in a joint with one angle, e.g. 5 N*m/rad."] = 0.0
    free_angle: Annotated[Angle, "Angle at which that spring is free."] = 0.0
    torsion_damping: Annotated[TorsionDamping, "Torque per angular velocity in the joint, e.g. 0.1 N*m*s/rad."] = 0.0
    stiffness: Annotated[Stiffness, "Spring along a joint with one slide, e.g. 2 N/mm."] = 0.0
    free_slide: Annotated[Length, "Way at which that spring is free, e.g. 0.1 m."] = 0.0
    damping: Annotated[Damping, "Force per speed along the joint, e.g. 50 N*s/m."] = 0.0
    lower_angle: Annotated[
        Angle | None, "Smallest angle of a joint with one angle; none if left out, e.g. -30 deg."
    ] = None
    upper_angle: Annotated[Angle | None, "Largest angle, e.g. 90 deg."] = None
    lower_slide: Annotated[Length | None, "Smallest way of a joint with one slide; none if left out, e.g. -0.1 m."] = (
        None
    )
    upper_slide: Annotated[Length | None, "Largest way, e.g. 0.4 m."] = None
    stop_torsion_stiffness: Annotated[
        TorsionStiffness, "Of the stops at these angles; without, passing them is said, e.g. 5 kN*m/rad."
    ] = 0.0
    stop_stiffness: Annotated[Stiffness, "Of the stops at these ways; without, passing them is said, e.g. 50 N/mm."] = (
        0.0
    )
    rotor_inertia: Annotated[Inertia, "Inertia of the motor's rotor as felt at a revolute joint [kg*m^2]."] = 0.0


@record
class Load:
    """A force at a point of a body, a moment on it, or both."""

    body: Annotated[Text, "The body that it acts on."]
    force: Annotated[ForceVector, "The force, e.g. 0, 0, -20 N."] = ORIGIN
    moment: Annotated[TorqueVector, "The moment, e.g. 0, 5, 0 N*m."] = ORIGIN
    at: Annotated[SpacePosition, "Where the force acts, in the body's axes; its own origin by default [m]."] = ORIGIN
    axes: Annotated[Axes, "Axes of the components: ground, or those of the body."] = Axes("ground")


@record
class Loop:
    """A joint that closes a loop: a point of one body held at a point of another."""

    first: Annotated[Text, "One body."]
    second: Annotated[Text, "The other; ground by default."] = GROUND
    first_at: Annotated[SpacePosition, "The point, in the first body's axes [m]."] = ORIGIN
    second_at: Annotated[SpacePosition, "The same point, in the second body's axes [m]."] = ORIGIN
    axis: Annotated[
        Direction | None, "Axis of a pin, in the first body's axes, about which they may turn; a ball joint without."
    ] = None


@record
class Spring:
    """A spring with a damper between a point of one body and a point of another."""

    first: Annotated[Text, "One body."]
    second: Annotated[Text, "The other; ground by default."] = GROUND
    first_at: Annotated[SpacePosition, "Its end on the first, in that body's axes [m]."] = ORIGIN
    second_at: Annotated[SpacePosition, "Its end on the second, in that body's axes [m]."] = ORIGIN
    stiffness: Annotated[Stiffness, "Its stiffness, e.g. 2 N/mm."] = 0.0
    free_length: Annotated[Size | None, "Its free length; that in the scene if left out, e.g. 300 mm."] = None
    damping: Annotated[Damping, "Force per speed of a damper beside it, e.g. 50 N*s/m."] = 0.0


@record
class Drive:
    """A prescribed motion of a revolute or prismatic joint, in `simulate`."""

    body: Annotated[Text, "The body whose joint is driven."]
    speed: Annotated[TurnRate, "A constant angular velocity, e.g. 60 rpm."] = 0.0
    velocity: Annotated[Speed, "Or a constant velocity of a slide, e.g. 0.2 m/s."] = 0.0
    angle_law: Annotated[AngleFormula | None, "Or the angle over time t in s, e.g. 90*sin(t) deg."] = None
    slide_law: Annotated[LengthFormula | None, "Or the way over time t in s, e.g. 20*sin(3*t) mm."] = None


@record
class Scene:
    """Bodies in space."""

    bodies: Annotated[tuple[Body, ...], "The bodies, in any order."] = ()
    loads: Annotated[tuple[Load, ...], "Forces and moments from outside, besides weight."] = ()
    loops: Annotated[tuple[Loop, ...], "Joints that close loops."] = ()
    drives: Annotated[tuple[Drive, ...], "Joints whose motion is prescribed, in simulate."] = ()
    springs: Annotated[tuple[Spring, ...], "Springs and dampers between points of two bodies."] = ()
