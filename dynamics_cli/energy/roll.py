"""The task `roll`: a round body down a slope, rolling or slipping."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import cos, sin, sqrt, tan
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Angle,
    Annotated,
    Distance,
    Fraction,
    Friction,
    Gravity,
    Positive,
    Speed,
    Text,
    Time,
)
from dynamics_cli.records import Choice, record

QUARTER = 1.5707963267948966


class Form(Choice):
    """Round bodies by their moment of inertia over m·r²: 1, 1/2, 2/5, 2/3."""

    __slots__ = ()
    names = ("hoop", "disk", "sphere", "shell")


RATIOS = {"hoop": 1.0, "disk": 0.5, "sphere": 2.0 / 5.0, "shell": 2.0 / 3.0}


@record
class Shape:
    """A body of one of the usual forms."""

    form: Annotated[Form, "Hoop or thin tube; disk or cylinder; solid sphere; thin shell of a ball."]


@record
class Inertial:
    """Any other round body."""

    inertia_ratio: Annotated[Positive, "Its moment of inertia over m·r², e.g. 0.45."]


@record
class Roll:
    """A body that rolls or slips down a slope."""

    motion: Annotated[Text, "Whether it rolls or slips."]
    acceleration: Annotated[Acceleration, "Acceleration of its centre down the slope [m/s^2]."]
    needed_friction: Annotated[Friction, "Friction that rolling without slip takes [-]."]
    speed: Annotated[Speed | None, "Speed after the distance from rest [m/s]."]
    time: Annotated[Time | None, "Time for it [s]."]
    rim_speed: Annotated[Speed | None, "Speed of its rim beside its centre; slipping it is below the speed [m/s]."]
    turning_share: Annotated[Fraction, "Share of rotation in its kinetic energy [-]."]
    lost_share: Annotated[Fraction, "Share of the energy that friction takes [-]."]


def roll(
    *,
    body: Annotated[Shape | Inertial, "Its form, or its moment of inertia over m·r²."],
    angle: Annotated[Angle, "Slope, e.g. 20 deg."],
    friction: Annotated[Friction | None, "Coefficient of friction, to see whether it slips, e.g. 0.2."] = None,
    distance: Annotated[Distance | None, "A way down the slope from rest, e.g. 3 m."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Roll:
    """A round body let go on a slope: its acceleration, the friction that rolling needs, and speed after a way.

    Equation
    --------
    a = g·sin α/(1 + κ), κ = I/(m·r²); rolls while μ ≥ κ·tan α/(1 + κ); slipping a = g·(sin α − μ·cos α) and the rim
    gains μ·g·cos α/κ.

    Returns
    -------
    Roll
        Whether it rolls, accelerations, speeds and where the energy goes.

    Raises
    ------
    InadmissibleError
        When the slope is not above zero and below 90 degrees.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.9.

    Examples
    --------
    >>> round(roll(body=Shape(Form("disk")), angle=0.5235987755982988).acceleration, 6)
    3.268883
    """
    require(
        0.0 < plain(angle) < QUARTER,
        "a slope of {angle} is too flat or too steep to roll down",
        angle=(angle, Angle),
        code="angle",
        hint="give an angle between 0 and 90 deg",
    )
    ratio = RATIOS[str(body.form)] if isinstance(body, Shape) else body.inertia_ratio
    whole = 1.0 + ratio
    needed = ratio * tan(angle) / whole
    if friction is None or plain(friction) >= plain(needed):
        acceleration = gravity * sin(angle) / whole
        rim, motion, lost = acceleration, "rolls", 0.0 * needed
    else:
        acceleration = gravity * (sin(angle) - friction * cos(angle))
        rim = friction * gravity * cos(angle) / ratio
        motion = "slips and turns" if plain(friction) else "slides without turning"
        # what slips by is the way of the contact point beside that of the centre
        lost = friction * (1.0 - rim / acceleration) / tan(angle)
    turning = ratio * rim * rim
    speed = None if distance is None else sqrt(2.0 * acceleration * distance)
    return Roll(
        motion=motion,
        acceleration=acceleration,
        needed_friction=needed,
        speed=speed,
        time=None if distance is None else sqrt(2.0 * distance / acceleration),
        rim_speed=None if speed is None else speed * (rim / acceleration),
        turning_share=turning / (acceleration * acceleration + turning),
        lost_share=lost,
    )
