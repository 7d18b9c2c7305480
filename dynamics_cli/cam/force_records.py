"""What `cam force` takes and gives."""

from dynamics_cli.cam.followers import FlatFace, KnifeEdge, OscillatingFlat, OscillatingRoller, Roller
from dynamics_cli.quantities import (
    Angle,
    Coordinate,
    Force,
    Frequency,
    Inertia,
    Mass,
    Power,
    Pressure,
    Ratio,
    ShaftSpeed,
    Size,
    Speed,
    Stiffness,
    Text,
    Torque,
    TorsionStiffness,
)
from dynamics_cli.records import Advice, Check, Columns, Numerics, record

STEEL = 206e9
STEEL_RATIO = 0.3

DrivenFollower = KnifeEdge | Roller | FlatFace | OscillatingRoller | OscillatingFlat


@record
class Slide:
    """A follower that slides: what it moves, and what presses it on the cam.

    Parameters
    ----------
    mass : Mass
        Mass that moves with a sliding follower, a third of the spring's included [kg].
    spring_rate : Stiffness
        Rate of the spring [N/m].
    preload : Force
        Force of the spring at no lift, or at no swing [N].
    load : Force
        Steady external force that presses a sliding follower on the cam; negative lifts it [N].
    spring_mass : Mass
        Mass of the spring's active coils, for its surge [kg].
    """

    mass: Mass
    spring_rate: Stiffness = 0.0
    preload: Force = 0.0
    load: Force = 0.0
    spring_mass: Mass | None = None


@record
class ArmOnTorsionSpring:
    """An arm, and a torsion spring about its pivot.

    Parameters
    ----------
    inertia : Inertia
        Moment of inertia of the arm and what moves with it, about its pivot [kg*m^2].
    torsion_rate : TorsionStiffness
        Rate of the torsion spring about the pivot [N*m/rad].
    preload_torque : Torque
        Torque of the torsion spring at no swing [N*m].
    load_torque : Torque
        Steady external torque that presses the arm on the cam; negative lifts it [N*m].
    spring_inertia : Inertia
        Moment of inertia of the torsion spring's active coils about its own axis, for its surge [kg*m^2].
    """

    inertia: Inertia
    torsion_rate: TorsionStiffness = 0.0
    preload_torque: Torque = 0.0
    load_torque: Torque = 0.0
    spring_inertia: Inertia | None = None


@record
class ArmOnSpring:
    """An arm, and a linear spring that acts square to a radius of the arm.

    Parameters
    ----------
    inertia : Inertia
        Moment of inertia of the arm and what moves with it, about its pivot [kg*m^2].
    spring_radius : Size
        Distance of the spring's line of force from the arm's pivot [m].
    spring_rate : Stiffness
        Rate of the spring [N/m].
    preload : Force
        Force of the spring at no lift, or at no swing [N].
    load_torque : Torque
        Steady external torque that presses the arm on the cam; negative lifts it [N*m].
    spring_mass : Mass
        Mass of the spring's active coils, for its surge [kg].
    """

    inertia: Inertia
    spring_radius: Size
    spring_rate: Stiffness = 0.0
    preload: Force = 0.0
    load_torque: Torque = 0.0
    spring_mass: Mass | None = None


Train = Slide | ArmOnTorsionSpring | ArmOnSpring


@record
class Contact:
    """The contact of cam and follower, for its Hertz stress.

    Parameters
    ----------
    width : Size
        Width of the contact, across the plane of motion [m].
    cam_modulus : Pressure
        Young's modulus of the cam [Pa].
    follower_modulus : Pressure
        Young's modulus of the follower [Pa].
    cam_poisson : Ratio
        Poisson's ratio of the cam.
    follower_poisson : Ratio
        Poisson's ratio of the follower.
    """

    width: Size
    cam_modulus: Pressure = STEEL
    follower_modulus: Pressure = STEEL
    cam_poisson: Ratio = STEEL_RATIO
    follower_poisson: Ratio = STEEL_RATIO


@record
class Duration:
    """How long the follower is above a lift.

    Parameters
    ----------
    lift : Coordinate
        The lift, above the lowest of the turn [m].
    opens : Angle
        Cam angle at which it is passed upwards [rad].
    closes : Angle
        Cam angle at which it is passed downwards [rad].
    duration : Angle
        Cam angle between [rad].
    crank_duration : Angle
        The same in angle of a four-stroke engine's crank, twice the cam's [rad].
    opening_speed : Speed
        Speed of the follower when it passes upwards [m/s].
    closing_speed : Speed
        Speed when it passes downwards, where a valve would seat [m/s].
    """

    lift: Coordinate
    opens: Angle
    closes: Angle
    duration: Angle
    crank_duration: Angle
    opening_speed: Speed
    closing_speed: Speed


@record
class Ramp:
    """A ramp: cam angle from one lift to another.

    Parameters
    ----------
    side : Text
        Opening or closing.
    from_lift : Coordinate
        The lower lift [m].
    to_lift : Coordinate
        The higher lift [m].
    angle : Angle
        Cam angle between them [rad].
    mean_speed : Speed
        Mean speed of the follower on it [m/s].
    """

    side: Text
    from_lift: Coordinate
    to_lift: Coordinate
    angle: Angle
    mean_speed: Speed


@record
class ForcePoint:
    """Forces of a sliding follower at one cam angle.

    Parameters
    ----------
    angle : Angle
        Cam angle [rad].
    lift : Coordinate
        Lift [m].
    axial_force : Force
        Force between cam and follower along the follower's way [N].
    torque : Torque
        Torque the shaft has to give [N*m].
    """

    angle: Angle
    lift: Coordinate
    axial_force: Force
    torque: Torque


@record
class ArmPoint:
    """Torques of an arm at one cam angle.

    Parameters
    ----------
    angle : Angle
        Cam angle [rad].
    swing : Angle
        Angle of the arm [rad].
    arm_torque : Torque
        Torque about the pivot that the cam gives the arm [N*m].
    torque : Torque
        Torque the shaft has to give [N*m].
    """

    angle: Angle
    swing: Angle
    arm_torque: Torque
    torque: Torque


@record
class ContactPoint:
    """The contact at one cam angle.

    Parameters
    ----------
    angle : Angle
        Cam angle [rad].
    pressure_angle : Angle
        Angle from the follower's way to the common normal [rad].
    contact_force : Force
        Force between cam and follower along the common normal [N].
    """

    angle: Angle
    pressure_angle: Angle
    contact_force: Force


@record
class Forces:
    """Forces on a cam over one turn.

    Parameters
    ----------
    least_force : Force
        Least force between cam and a sliding follower, along its way; negative, the follower leaves the cam [N].
    least_force_at : Angle
        Where [rad].
    greatest_force : Force
        Greatest [N].
    greatest_force_at : Angle
        Where [rad].
    least_arm_torque : Torque
        Least torque about its pivot that the cam gives an arm; negative, the arm leaves the cam [N*m].
    least_arm_torque_at : Angle
        Where [rad].
    greatest_arm_torque : Torque
        Greatest [N*m].
    greatest_arm_torque_at : Angle
        Where [rad].
    least_contact_force : Force
        Least force along the common normal, for the follower given; negative, it leaves the cam [N].
    least_contact_force_at : Angle
        Where [rad].
    greatest_contact_force : Force
        Greatest [N].
    greatest_contact_force_at : Angle
        Where [rad].
    greatest_torque : Torque
        Greatest torque the shaft has to give [N*m].
    greatest_torque_at : Angle
        Where [rad].
    least_torque : Torque
        Least; negative, the follower drives the shaft [N*m].
    least_torque_at : Angle
        Where [rad].
    greatest_power : Power
        Greatest power between shaft and follower, either way [W].
    jump_speed : ShaftSpeed
        Speed of the shaft above which the follower leaves the cam [rad/s].
    jump_at : Angle
        Where it leaves first [rad].
    preload_needed : Force
        Least preload that keeps contact at this speed [N].
    preload_torque_needed : Torque
        Least preload of a torsion spring that keeps contact at this speed [N*m].
    stress : Pressure
        Greatest Hertz pressure [Pa].
    stress_at : Angle
        Where [rad].
    surge_frequency : Frequency
        Lowest natural frequency of the spring itself [Hz].
    surge_order : Ratio
        That frequency over the shaft's turns per second: the harmonic of the cam that meets it.
    durations : tuple of Duration
        How long a sliding follower is above given lifts.
    ramps : tuple of Ramp
        Cam angle from the lash to the first of those lifts.
    table : Columns of ForcePoint
        Forces of a sliding follower over the turn.
    arm_table : Columns of ArmPoint
        Torques of an arm over the turn.
    contact_table : Columns of ContactPoint
        Pressure angle and contact force over the turn, for the follower given.
    """

    least_force: Force | None
    least_force_at: Angle | None
    greatest_force: Force | None
    greatest_force_at: Angle | None
    least_arm_torque: Torque | None
    least_arm_torque_at: Angle | None
    greatest_arm_torque: Torque | None
    greatest_arm_torque_at: Angle | None
    least_contact_force: Force | None
    least_contact_force_at: Angle | None
    greatest_contact_force: Force | None
    greatest_contact_force_at: Angle | None
    greatest_torque: Torque
    greatest_torque_at: Angle
    least_torque: Torque
    least_torque_at: Angle
    greatest_power: Power
    jump_speed: ShaftSpeed | None
    jump_at: Angle | None
    preload_needed: Force | None
    preload_torque_needed: Torque | None
    stress: Pressure | None
    stress_at: Angle | None
    surge_frequency: Frequency | None
    surge_order: Ratio | None
    durations: tuple[Duration, ...] | None
    ramps: tuple[Ramp, ...] | None
    table: Columns[ForcePoint] | None
    arm_table: Columns[ArmPoint] | None
    contact_table: Columns[ContactPoint] | None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None
