"""Inputs and results of `cam force`."""

from dynamics_cli.cam.geometry.followers import FlatFace, KnifeEdge, OscillatingFlat, OscillatingRoller, Roller
from dynamics_cli.quantities import (
    Angle,
    Annotated,
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
    """A sliding follower: moved mass, spring and load."""

    mass: Annotated[Mass, "Moving mass of a sliding follower, with a third of the spring's, e.g. 0.5 kg [kg]."]
    spring_rate: Annotated[Stiffness, "Rate of the spring [N/m]."] = 0.0
    preload: Annotated[Force, "Force of the spring at no lift, or at no swing [N]."] = 0.0
    load: Annotated[
        Force, "Steady external force that presses a sliding follower on the cam; negative lifts it [N]."
    ] = 0.0
    spring_mass: Annotated[Mass | None, "Mass of the spring's active coils, for its surge, e.g. 0.1 kg [kg]."] = None


@record
class ArmOnTorsionSpring:
    """An arm, and a torsion spring about its pivot."""

    inertia: Annotated[
        Inertia,
        "Moment of inertia about the pivot, of the arm and all parts that move with it, e.g. 0.002 kg*m^2 [kg*m^2].",
    ]
    torsion_rate: Annotated[TorsionStiffness, "Rate of the torsion spring about the pivot [N*m/rad]."] = 0.0
    preload_torque: Annotated[Torque, "Torque of the torsion spring at no swing [N*m]."] = 0.0
    load_torque: Annotated[
        Torque, "Steady external torque that presses the arm on the cam; negative lifts it [N*m]."
    ] = 0.0
    spring_inertia: Annotated[
        Inertia | None,
        "Inertia of a torsion spring's active coils about its axis, for the surge, e.g. 1e-5 kg*m^2 [kg*m^2].",
    ] = None


@record
class ArmOnSpring:
    """An arm with a linear spring that acts perpendicular to a radius of the arm."""

    inertia: Annotated[
        Inertia,
        "Moment of inertia about the pivot, of the arm and all parts that move with it, e.g. 0.002 kg*m^2 [kg*m^2].",
    ]
    spring_radius: Annotated[Size, "Distance of the spring's line of force from the arm's pivot, e.g. 50 mm [m]."]
    spring_rate: Annotated[Stiffness, "Rate of the spring [N/m]."] = 0.0
    preload: Annotated[Force, "Force of the spring at no lift, or at no swing [N]."] = 0.0
    load_torque: Annotated[
        Torque, "Steady external torque that presses the arm on the cam; negative lifts it [N*m]."
    ] = 0.0
    spring_mass: Annotated[Mass | None, "Mass of the spring's active coils, for its surge, e.g. 0.1 kg [kg]."] = None


Train = Slide | ArmOnTorsionSpring | ArmOnSpring


@record
class Contact:
    """The contact of cam and follower, for its Hertz stress."""

    width: Annotated[Size, "Width of the contact, across the plane of motion, e.g. 12 mm [m]."]
    cam_modulus: Annotated[Pressure, "Young's modulus of the cam [Pa]."] = STEEL
    follower_modulus: Annotated[Pressure, "Young's modulus of the follower [Pa]."] = STEEL
    cam_poisson: Annotated[Ratio, "Poisson's ratio of the cam."] = STEEL_RATIO
    follower_poisson: Annotated[Ratio, "Poisson's ratio of the follower."] = STEEL_RATIO


@record
class Duration:
    """How long the follower is above a lift."""

    lift: Annotated[Coordinate, "The lift, above the lowest of the turn [m]."]
    opens: Annotated[Angle, "Cam angle at which it is passed upwards [rad]."]
    closes: Annotated[Angle, "Cam angle at which it is passed downwards [rad]."]
    duration: Annotated[Angle, "Cam angle between [rad]."]
    crank_duration: Annotated[Angle, "The same in angle of a four-stroke engine's crank, twice the cam's [rad]."]
    opening_speed: Annotated[Speed, "Speed of the follower when it passes upwards [m/s]."]
    closing_speed: Annotated[Speed, "Speed when it passes downwards, where a valve would seat [m/s]."]


@record
class Ramp:
    """A ramp: cam angle from one lift to another."""

    side: Annotated[Text, "Opening or closing."]
    from_lift: Annotated[Coordinate, "The lower lift [m]."]
    to_lift: Annotated[Coordinate, "The higher lift [m]."]
    angle: Annotated[Angle, "Cam angle between them [rad]."]
    mean_speed: Annotated[Speed, "Mean speed of the follower on it [m/s]."]


@record
class ForcePoint:
    """Forces of a sliding follower at one cam angle."""

    angle: Annotated[Angle, "Cam angle [rad]."]
    lift: Annotated[Coordinate, "Lift [m]."]
    axial_force: Annotated[Force, "Force between cam and follower along the follower's way [N]."]
    torque: Annotated[Torque, "Torque the shaft has to give [N*m]."]


@record
class ArmPoint:
    """Torques of an arm at one cam angle."""

    angle: Annotated[Angle, "Cam angle [rad]."]
    swing: Annotated[Angle, "Angle of the arm [rad]."]
    arm_torque: Annotated[Torque, "Torque about the pivot that the cam gives the arm [N*m]."]
    torque: Annotated[Torque, "Torque the shaft has to give [N*m]."]


@record
class ContactPoint:
    """The contact at one cam angle."""

    angle: Annotated[Angle, "Cam angle [rad]."]
    pressure_angle: Annotated[Angle, "Angle from the follower's way to the common normal [rad]."]
    contact_force: Annotated[Force, "Force between cam and follower along the common normal [N]."]


@record
class Forces:
    """Forces on a cam over one turn."""

    least_force: Annotated[
        Force | None,
        "Minimum force of the cam on a sliding follower, along its travel; if negative, it leaves the cam [N].",
    ]
    least_force_at: Annotated[Angle | None, "Where [rad]."]
    greatest_force: Annotated[Force | None, "Maximum of the same [N]."]
    greatest_force_at: Annotated[Angle | None, "Where [rad]."]
    least_arm_torque: Annotated[
        Torque | None,
        "Minimum torque of the cam on an arm, about its pivot; if negative, the arm leaves the cam [N*m].",
    ]
    least_arm_torque_at: Annotated[Angle | None, "Where [rad]."]
    greatest_arm_torque: Annotated[Torque | None, "Maximum of the same [N*m]."]
    greatest_arm_torque_at: Annotated[Angle | None, "Where [rad]."]
    least_contact_force: Annotated[
        Force | None,
        "Minimum force along the common normal, for the given follower; if negative, it leaves the cam [N].",
    ]
    least_contact_force_at: Annotated[Angle | None, "Where [rad]."]
    greatest_contact_force: Annotated[Force | None, "Maximum of the same [N]."]
    greatest_contact_force_at: Annotated[Angle | None, "Where [rad]."]
    greatest_torque: Annotated[Torque, "Maximum torque the shaft has to give [N*m]."]
    greatest_torque_at: Annotated[Angle, "Where [rad]."]
    least_torque: Annotated[Torque, "Minimum; negative, the follower drives the shaft [N*m]."]
    least_torque_at: Annotated[Angle, "Where [rad]."]
    greatest_power: Annotated[Power, "Maximum power between shaft and follower, either way [W]."]
    jump_speed: Annotated[ShaftSpeed | None, "Speed of the shaft above which the follower leaves the cam [rad/s]."]
    jump_at: Annotated[Angle | None, "Cam angle where it leaves first [rad]."]
    preload_needed: Annotated[Force | None, "Minimum preload that keeps contact at this speed [N]."]
    preload_torque_needed: Annotated[
        Torque | None, "Minimum preload of a torsion spring that keeps contact at this speed [N*m]."
    ]
    stress: Annotated[Pressure | None, "Maximum Hertz pressure [Pa]."]
    stress_at: Annotated[Angle | None, "Where [rad]."]
    surge_frequency: Annotated[Frequency | None, "Lowest natural frequency of the spring itself [Hz]."]
    surge_order: Annotated[
        Ratio | None, "That frequency over the shaft's turns per second: the harmonic of the cam that meets it."
    ]
    durations: Annotated[tuple[Duration, ...] | None, "How long a sliding follower is above given lifts."]
    ramps: Annotated[tuple[Ramp, ...] | None, "Cam angle from the lash to the first of those lifts."]
    table: Annotated[Columns[ForcePoint] | None, "Forces of a sliding follower over the turn."]
    arm_table: Annotated[Columns[ArmPoint] | None, "Torques of an arm over the turn."]
    contact_table: Annotated[
        Columns[ContactPoint] | None, "Pressure angle and contact force over the turn, for the follower given."
    ]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None
