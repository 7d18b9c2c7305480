"""A universal joint, alone or as one of two on an intermediate shaft."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, atan2, pi_beside
from dynamics_cli.numerics.number import single
from dynamics_cli.numerics.orientation.sequences import wrapped
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import Angle, AngularAcceleration, Annotated, Ratio, ShaftSpeed
from dynamics_cli.records import Advice, record

RIGHT_ANGLE = 1.5707963267948966
# Beyond this, joints of practice do not turn.
USUAL = 0.7853981633974483 + 1e-12


@record
class Joint:
    """Angle, speed and acceleration of the driven shaft."""

    output_angle: Annotated[Angle, "Angle of the driven shaft [rad]."]
    lead: Annotated[Angle, "How far it is ahead of the driving shaft [rad]."]
    ratio: Annotated[Ratio, "Its speed over that of the driving shaft [-]."]
    highest_ratio: Annotated[Ratio, "The highest ratio in a turn of one joint, 1/cos β [-]."]
    lowest_ratio: Annotated[Ratio, "The lowest, cos β [-]."]
    unevenness: Annotated[Ratio, "Their difference over the mean speed [-]."]
    ratio_slope: Annotated[Ratio, "Change of the ratio per radian of the driving shaft [1/rad]."]
    output_speed: Annotated[ShaftSpeed | None, "Speed of the driven shaft [rad/s]."] = None
    output_acceleration: Annotated[AngularAcceleration | None, "Its angular acceleration [rad/s^2]."] = None
    intermediate_ratio: Annotated[Ratio | None, "Speed of the intermediate shaft over the driving one's [-]."] = None
    advice: tuple[Advice, ...] = ()


def joint(
    *,
    joint_angle: Annotated[Angle, "Angle β between the shafts, e.g. 30 deg."],
    input_angle: Annotated[Angle, "Angle of the driving fork from the plane of the shafts, e.g. 50 deg."] = 0.0,
    speed: Annotated[ShaftSpeed | None, "Speed of the driving shaft, e.g. 1500 rpm."] = None,
    acceleration: Annotated[AngularAcceleration, "Its angular acceleration, e.g. 3 rad/s^2."] = 0.0,
    second_joint_angle: Annotated[Angle | None, "Angle of a second joint in the same plane, e.g. 30 deg."] = None,
    fork_angle: Annotated[Angle, "Angle between the intermediate shaft's forks, 0 in line, e.g. 90 deg."] = 0.0,
) -> Joint:
    """Angle, speed ratio and acceleration of a universal joint, or of two on an intermediate shaft.

    Equation
    --------
    tan θ₂ = tan θ₁/cos β, ω₂/ω₁ = cos β/(1 − sin²β·cos²θ₁), α₂ = i·α₁ + ω₁²·di/dθ₁.

    Raises
    ------
    InadmissibleError
        When a joint angle is not below 90°.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 1.4.

    Examples
    --------
    >>> answer = joint(joint_angle=0.5235987755982988, input_angle=0.8726646259971648)
    >>> round(answer.ratio, 9)
    0.965785199
    """
    for angle in (joint_angle,) if second_joint_angle is None else (joint_angle, second_joint_angle):
        require(
            absolute(angle) < RIGHT_ANGLE,
            "a joint at an angle of {angle} does not turn",
            code="joint-angle",
            hint="below 90 deg, in practice below 45 deg",
            angle=(angle if single(angle) else 0.0, Angle),
        )
    c, _ = turned(joint_angle)
    output, ratio, slope = _through(joint_angle, input_angle)
    middle = None
    if second_joint_angle is not None:
        # the second joint's driving fork stands across its driven one when the intermediate forks are in line
        quarter = 0.5 * pi_beside(input_angle)
        turn = fork_angle + quarter
        last, second, second_slope = _through(second_joint_angle, output + turn)
        output, middle = last - turn, ratio
        slope = second_slope * ratio * ratio + second * slope
        ratio = second * ratio
    alone = single(output, ratio)
    return Joint(
        output_angle=output,
        lead=wrapped(output - input_angle),
        ratio=ratio,
        highest_ratio=1.0 / c,
        lowest_ratio=c,
        unevenness=1.0 / c - c,
        ratio_slope=slope,
        output_speed=None if speed is None else ratio * speed,
        output_acceleration=None if speed is None else ratio * acceleration + speed * speed * slope,
        intermediate_ratio=middle,
        advice=_advice(joint_angle, second_joint_angle) if alone else (),
    )


def _through(beta: float, theta: float) -> tuple[float, float, float]:
    """Output angle in the same turn as the input's, speed ratio and its slope, of one joint."""
    c, s = turned(beta)
    cosine, sine = turned(theta)
    square = s * s
    # 1 − sin²β·cos²θ, a sum of squares
    below = sine * sine + c * c * (cosine * cosine)
    ratio = c / below
    slope = -2.0 * c * square * cosine * sine / (below * below)
    principal = atan2(sine, cosine * c)
    return theta + wrapped(principal - theta), ratio, slope


def _advice(first: float, second: float | None) -> tuple[Advice, ...]:
    advice = []
    if any(absolute(angle) > USUAL for angle in (first, second) if angle is not None):
        message = "universal joints in practice bend by at most about 45 deg"
        advice.append(Advice("steep-joint", message))
    return tuple(advice)
