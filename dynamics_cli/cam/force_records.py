"""What `cam force` takes and gives."""

from dynamics_cli.quantities import (
    Angle,
    Coordinate,
    Force,
    Frequency,
    Power,
    Pressure,
    Ratio,
    ShaftSpeed,
    Size,
    Speed,
    Text,
    Torque,
)
from dynamics_cli.records import Advice, Check, Columns, Numerics, record

STEEL = 206e9
STEEL_RATIO = 0.3


@record
class Contact:
    """What touches the cam: a roller, or a flat face when no roller radius is given.

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle [m].
    width : Size
        Width of the contact [m].
    roller_radius : Size
        Radius of the roller [m].
    offset : Coordinate
        Offset of a roller follower [m].
    cam_modulus : Pressure
        Young's modulus of the cam [Pa].
    follower_modulus : Pressure
        Young's modulus of the follower [Pa].
    cam_poisson : Ratio
        Poisson's ratio of the cam.
    follower_poisson : Ratio
        Poisson's ratio of the follower.
    """

    base_radius: Size
    width: Size
    roller_radius: Size | None = None
    offset: Coordinate = 0.0
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
    """Forces at one cam angle.

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
class Forces:
    """Forces on a cam over one turn.

    Parameters
    ----------
    least_force : Force
        Least force between cam and follower; negative, the follower leaves the cam [N].
    least_force_at : Angle
        Where [rad].
    greatest_force : Force
        Greatest [N].
    greatest_force_at : Angle
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
        Greatest power of the shaft [W].
    jump_speed : ShaftSpeed
        Speed of the shaft above which the follower leaves the cam [rad/s].
    jump_at : Angle
        Where it leaves first [rad].
    preload_needed : Force
        Least preload that keeps contact at this speed [N].
    stress : Pressure
        Greatest Hertz pressure [Pa].
    stress_at : Angle
        Where [rad].
    surge_frequency : Frequency
        Lowest natural frequency of the spring itself [Hz].
    surge_order : Ratio
        That frequency over the shaft's turns per second: the harmonic of the cam that meets it.
    durations : tuple of Duration
        How long the follower is above given lifts.
    ramps : tuple of Ramp
        Cam angle from the lash to the first of those lifts.
    table : Columns of ForcePoint
        Forces over the turn.
    """

    least_force: Force
    least_force_at: Angle
    greatest_force: Force
    greatest_force_at: Angle
    greatest_torque: Torque
    greatest_torque_at: Angle
    least_torque: Torque
    least_torque_at: Angle
    greatest_power: Power
    jump_speed: ShaftSpeed | None
    jump_at: Angle | None
    preload_needed: Force
    stress: Pressure | None
    stress_at: Angle | None
    surge_frequency: Frequency | None
    surge_order: Ratio | None
    durations: tuple[Duration, ...]
    ramps: tuple[Ramp, ...] | None
    table: Columns[ForcePoint]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None
