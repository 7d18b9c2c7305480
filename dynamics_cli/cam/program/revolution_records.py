"""Results of `cam motion`."""

from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    AngularAcceleration,
    AngularSpeed,
    Annotated,
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
    """Extremes of the lift."""

    least: Annotated[Coordinate, "Minimum lift [m]."]
    least_at: Annotated[Angle, "Where first, as a cam angle [rad]."]
    greatest: Annotated[Coordinate, "Maximum lift [m]."]
    greatest_at: Annotated[Angle, "Where first, as a cam angle [rad]."]


@record
class VelocityRange:
    """Extremes of the velocity."""

    least: Annotated[CamVelocity, "Minimum velocity [m/rad]."]
    least_at: Annotated[Angle, "Where first, as a cam angle [rad]."]
    greatest: Annotated[CamVelocity, "Maximum velocity [m/rad]."]
    greatest_at: Annotated[Angle, "Where first, as a cam angle [rad]."]


@record
class AccelerationRange:
    """Extremes of the acceleration; absent in the sense of an impulse, where the velocity jumps."""

    least: Annotated[CamAcceleration | None, "Minimum acceleration [m/rad^2]."]
    least_at: Annotated[Angle, "Where first, as a cam angle [rad]."]
    greatest: Annotated[CamAcceleration | None, "Maximum acceleration [m/rad^2]."]
    greatest_at: Annotated[Angle, "Where first, as a cam angle [rad]."]


@record
class JerkRange:
    """Extremes of the jerk, apart from where the acceleration jumps."""

    least: Annotated[CamJerk, "Minimum jerk [m/rad^3]."]
    least_at: Annotated[Angle, "Where first, as a cam angle [rad]."]
    greatest: Annotated[CamJerk, "Maximum jerk [m/rad^3]."]
    greatest_at: Annotated[Angle, "Where first, as a cam angle [rad]."]


@record
class SwingRange:
    """Extremes of an arm's angle and its derivatives by the cam angle."""

    least: Annotated[Angle, "Minimum angle [rad]."]
    least_at: Annotated[Angle, "Where first [rad]."]
    greatest: Annotated[Angle, "Maximum angle [rad]."]
    greatest_at: Annotated[Angle, "Where first [rad]."]
    least_velocity: Annotated[SwingVelocity, "Minimum first derivative [-]."]
    greatest_velocity: Annotated[SwingVelocity, "Maximum first derivative [-]."]
    least_acceleration: Annotated[SwingAcceleration | None, "Minimum second derivative [1/rad]."]
    greatest_acceleration: Annotated[SwingAcceleration | None, "Maximum second derivative [1/rad]."]
    least_jerk: Annotated[SwingJerk, "Minimum third derivative [1/rad^2]."]
    greatest_jerk: Annotated[SwingJerk, "Maximum third derivative [1/rad^2]."]


@record
class Joint:
    """Jumps at a joint of two segments, or of two parts of one."""

    angle: Annotated[Angle, "Cam angle [rad]."]
    between: Annotated[Text, "The two segments that meet there."]
    lift: Annotated[Coordinate, "Jump of the lift [m]."]
    velocity: Annotated[CamVelocity, "Jump of the velocity [m/rad]."]
    acceleration: Annotated[CamAcceleration, "Jump of the acceleration [m/rad^2]."]
    jerk: Annotated[CamJerk, "Jump of the jerk [m/rad^3]."]


@record
class SwingJoint:
    """Jumps at a joint of two segments of an arm's motion."""

    angle: Annotated[Angle, "Cam angle [rad]."]
    between: Annotated[Text, "The two segments that meet there."]
    swing: Annotated[Angle, "Jump of the arm's angle [rad]."]
    velocity: Annotated[SwingVelocity, "Jump of the first derivative [-]."]
    acceleration: Annotated[SwingAcceleration, "Jump of the second derivative [1/rad]."]
    jerk: Annotated[SwingJerk, "Jump of the third derivative [1/rad^2]."]


@record
class MotionPoint:
    """The motion at one cam angle."""

    angle: Annotated[Angle, "Cam angle [rad]."]
    lift: Annotated[Coordinate, "Lift [m]."]
    velocity: Annotated[CamVelocity, "First derivative [m/rad]."]
    acceleration: Annotated[CamAcceleration, "Second derivative [m/rad^2]."]
    jerk: Annotated[CamJerk, "Third derivative [m/rad^3]."]


@record
class SwingPoint:
    """The motion of an arm at one cam angle."""

    angle: Annotated[Angle, "Cam angle [rad]."]
    swing: Annotated[Angle, "Angle of the arm from where it starts [rad]."]
    velocity: Annotated[SwingVelocity, "First derivative [-]."]
    acceleration: Annotated[SwingAcceleration, "Second derivative [1/rad]."]
    jerk: Annotated[SwingJerk, "Third derivative [1/rad^2]."]


@record
class InTime:
    """Maximum magnitudes in time at the speed of the shaft."""

    speed: Annotated[Speed, "Speed of the follower [m/s]."]
    acceleration: Annotated[Acceleration | None, "Its acceleration; none where the velocity jumps [m/s^2]."]
    jerk: Annotated[Jerk, "Its jerk, apart from where the acceleration jumps [m/s^3]."]
    rms_acceleration: Annotated[Acceleration | None, "Root mean square of the acceleration over the turn [m/s^2]."]


@record
class SwingInTime:
    """Maximum magnitudes of an arm in time at the speed of the shaft."""

    speed: Annotated[AngularSpeed, "Angular velocity of the arm [rad/s]."]
    acceleration: Annotated[
        AngularAcceleration | None, "Its angular acceleration; none where the velocity jumps [rad/s^2]."
    ]
    rms_acceleration: Annotated[
        AngularAcceleration | None, "Root mean square of the angular acceleration over the turn [rad/s^2]."
    ]


@record
class Revolution:
    """One revolution of cam motion."""

    continuity: Annotated[Text, "C0 to C3: the highest derivative that jumps at no joint."]
    lift: Annotated[LiftRange | None, "Extremes of the lift."]
    velocity: Annotated[VelocityRange | None, "Extremes of the velocity."]
    acceleration: Annotated[AccelerationRange | None, "Extremes of the acceleration."]
    jerk: Annotated[JerkRange | None, "Extremes of the jerk."]
    rms_acceleration: Annotated[CamAcceleration | None, "Root mean square of the acceleration over the turn [m/rad^2]."]
    swing: Annotated[SwingRange | None, "Extremes of an arm's motion."]
    rms_swing_acceleration: Annotated[SwingAcceleration | None, "Root mean square of an arm's acceleration [1/rad]."]
    in_time: Annotated[InTime | None, "Maximum magnitudes in time."]
    swing_in_time: Annotated[SwingInTime | None, "Maximum magnitudes of an arm in time."]
    joints: Annotated[
        tuple[Joint, ...] | None, "Jumps at every joint; the joint from the end of the turn to its start comes first."
    ]
    swing_joints: Annotated[tuple[SwingJoint, ...] | None, "The same for an arm."]
    singularity_functions: Annotated[Text | None, "The motion in the book's singularity functions."]
    table: Annotated[Columns[MotionPoint] | None, "The motion over the turn."]
    swing_table: Annotated[Columns[SwingPoint] | None, "The motion of an arm over the turn."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None
