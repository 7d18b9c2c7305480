"""What `cam motion` gives."""

from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    AngularAcceleration,
    AngularSpeed,
    CamAcceleration,
    CamJerk,
    CamVelocity,
    Coordinate,
    Jerk,
    Speed,
    SwingAcceleration,
    SwingJerk,
    SwingVelocity,
    Text,
)
from dynamics_cli.records import Advice, Check, Columns, Numerics, record


@record
class LiftRange:
    """Extremes of the lift.

    Parameters
    ----------
    least : Coordinate
        Least [m].
    least_at : Angle
        Where first [rad].
    greatest : Coordinate
        Greatest [m].
    greatest_at : Angle
        Where first [rad].
    """

    least: Coordinate
    least_at: Angle
    greatest: Coordinate
    greatest_at: Angle


@record
class VelocityRange:
    """Extremes of the velocity.

    Parameters
    ----------
    least : CamVelocity
        Least [m/rad].
    least_at : Angle
        Where first [rad].
    greatest : CamVelocity
        Greatest [m/rad].
    greatest_at : Angle
        Where first [rad].
    """

    least: CamVelocity
    least_at: Angle
    greatest: CamVelocity
    greatest_at: Angle


@record
class AccelerationRange:
    """Extremes of the acceleration.

    Parameters
    ----------
    least : CamAcceleration
        Least [m/rad^2].
    least_at : Angle
        Where first [rad].
    greatest : CamAcceleration
        Greatest [m/rad^2].
    greatest_at : Angle
        Where first [rad].
    """

    least: CamAcceleration
    least_at: Angle
    greatest: CamAcceleration
    greatest_at: Angle


@record
class JerkRange:
    """Extremes of the jerk, apart from where the acceleration jumps.

    Parameters
    ----------
    least : CamJerk
        Least [m/rad^3].
    least_at : Angle
        Where first [rad].
    greatest : CamJerk
        Greatest [m/rad^3].
    greatest_at : Angle
        Where first [rad].
    """

    least: CamJerk
    least_at: Angle
    greatest: CamJerk
    greatest_at: Angle


@record
class SwingRange:
    """Extremes of an arm's angle and its derivatives by the cam angle.

    Parameters
    ----------
    least : Angle
        Least angle [rad].
    least_at : Angle
        Where first [rad].
    greatest : Angle
        Greatest angle [rad].
    greatest_at : Angle
        Where first [rad].
    least_velocity : SwingVelocity
        Least first derivative [-].
    greatest_velocity : SwingVelocity
        Greatest first derivative [-].
    least_acceleration : SwingAcceleration
        Least second derivative [1/rad].
    greatest_acceleration : SwingAcceleration
        Greatest second derivative [1/rad].
    least_jerk : SwingJerk
        Least third derivative [1/rad^2].
    greatest_jerk : SwingJerk
        Greatest third derivative [1/rad^2].
    """

    least: Angle
    least_at: Angle
    greatest: Angle
    greatest_at: Angle
    least_velocity: SwingVelocity
    greatest_velocity: SwingVelocity
    least_acceleration: SwingAcceleration
    greatest_acceleration: SwingAcceleration
    least_jerk: SwingJerk
    greatest_jerk: SwingJerk


@record
class Joint:
    """What jumps where two segments, or two parts of one, meet.

    Parameters
    ----------
    angle : Angle
        Cam angle [rad].
    between : Text
        What meets there.
    lift : Coordinate
        Jump of the lift [m].
    velocity : CamVelocity
        Jump of the velocity [m/rad].
    acceleration : CamAcceleration
        Jump of the acceleration [m/rad^2].
    jerk : CamJerk
        Jump of the jerk [m/rad^3].
    """

    angle: Angle
    between: Text
    lift: Coordinate
    velocity: CamVelocity
    acceleration: CamAcceleration
    jerk: CamJerk


@record
class SwingJoint:
    """What jumps where two segments of an arm's motion meet.

    Parameters
    ----------
    angle : Angle
        Cam angle [rad].
    between : Text
        What meets there.
    swing : Angle
        Jump of the arm's angle [rad].
    velocity : SwingVelocity
        Jump of the first derivative [-].
    acceleration : SwingAcceleration
        Jump of the second derivative [1/rad].
    jerk : SwingJerk
        Jump of the third derivative [1/rad^2].
    """

    angle: Angle
    between: Text
    swing: Angle
    velocity: SwingVelocity
    acceleration: SwingAcceleration
    jerk: SwingJerk


@record
class MotionPoint:
    """The motion at one cam angle.

    Parameters
    ----------
    angle : Angle
        Cam angle [rad].
    lift : Coordinate
        Lift [m].
    velocity : CamVelocity
        First derivative [m/rad].
    acceleration : CamAcceleration
        Second derivative [m/rad^2].
    jerk : CamJerk
        Third derivative [m/rad^3].
    """

    angle: Angle
    lift: Coordinate
    velocity: CamVelocity
    acceleration: CamAcceleration
    jerk: CamJerk


@record
class SwingPoint:
    """The motion of an arm at one cam angle.

    Parameters
    ----------
    angle : Angle
        Cam angle [rad].
    swing : Angle
        Angle of the arm from where it starts [rad].
    velocity : SwingVelocity
        First derivative [-].
    acceleration : SwingAcceleration
        Second derivative [1/rad].
    jerk : SwingJerk
        Third derivative [1/rad^2].
    """

    angle: Angle
    swing: Angle
    velocity: SwingVelocity
    acceleration: SwingAcceleration
    jerk: SwingJerk


@record
class InTime:
    """Greatest magnitudes in time at the speed of the shaft.

    Parameters
    ----------
    speed : Speed
        Speed of the follower [m/s].
    acceleration : Acceleration
        Its acceleration [m/s^2].
    jerk : Jerk
        Its jerk [m/s^3].
    rms_acceleration : Acceleration
        Root mean square of the acceleration over the turn [m/s^2].
    """

    speed: Speed
    acceleration: Acceleration
    jerk: Jerk
    rms_acceleration: Acceleration


@record
class SwingInTime:
    """Greatest magnitudes of an arm in time at the speed of the shaft.

    Parameters
    ----------
    speed : AngularSpeed
        Angular velocity of the arm [rad/s].
    acceleration : AngularAcceleration
        Its angular acceleration [rad/s^2].
    rms_acceleration : AngularAcceleration
        Root mean square of the angular acceleration over the turn [rad/s^2].
    """

    speed: AngularSpeed
    acceleration: AngularAcceleration
    rms_acceleration: AngularAcceleration


@record
class Revolution:
    """One revolution of cam motion.

    Parameters
    ----------
    continuity : Text
        C0 to C3: the highest derivative that jumps at no joint.
    lift : LiftRange
        Extremes of the lift.
    velocity : VelocityRange
        Extremes of the velocity.
    acceleration : AccelerationRange
        Extremes of the acceleration.
    jerk : JerkRange
        Extremes of the jerk.
    rms_acceleration : CamAcceleration
        Root mean square of the acceleration over the turn [m/rad^2].
    swing : SwingRange
        Extremes of an arm's motion.
    rms_swing_acceleration : SwingAcceleration
        Root mean square of an arm's acceleration [1/rad].
    in_time : InTime
        Greatest magnitudes in time.
    swing_in_time : SwingInTime
        Greatest magnitudes of an arm in time.
    joints : tuple of Joint
        Jumps at every joint, that from the end of the turn to its start first.
    swing_joints : tuple of SwingJoint
        The same for an arm.
    singularity_functions : Text
        The motion in the book's singularity functions.
    table : Columns of MotionPoint
        The motion over the turn.
    swing_table : Columns of SwingPoint
        The motion of an arm over the turn.
    """

    continuity: Text
    lift: LiftRange | None
    velocity: VelocityRange | None
    acceleration: AccelerationRange | None
    jerk: JerkRange | None
    rms_acceleration: CamAcceleration | None
    swing: SwingRange | None
    rms_swing_acceleration: SwingAcceleration | None
    in_time: InTime | None
    swing_in_time: SwingInTime | None
    joints: tuple[Joint, ...] | None
    swing_joints: tuple[SwingJoint, ...] | None
    singularity_functions: Text | None
    table: Columns[MotionPoint] | None
    swing_table: Columns[SwingPoint] | None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None
