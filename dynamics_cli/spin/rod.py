"""The task `rod`: a uniform rod pinned to a turning shaft."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import atan2, hypot, pi_beside, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Force,
    Frequency,
    Gravity,
    Length,
    Mass,
    ShaftSpeed,
    Text,
)
from dynamics_cli.records import record


@record
class Rod:
    """Where a rod on a turning shaft stays."""

    critical: Annotated[ShaftSpeed, "Above it the rod lifts off the shaft [rad/s]."]
    motion: Annotated[Text, "Whether it hangs or stands out."]
    angle: Annotated[Angle, "Its steady angle from the vertical [rad]."]
    frequency: Annotated[Frequency, "Small oscillations about it [Hz]."]
    pin_force: Annotated[Force | None, "Force of the pin; with the mass [N]."]


def rod(
    *,
    length: Annotated[Length, "Length of the rod, pinned at its upper end on the shaft's axis, e.g. 0.8 m."],
    speed: Annotated[ShaftSpeed, "Speed of the vertical shaft, e.g. 70 rpm."],
    mass: Annotated[Mass | None, "Its mass, for the force of the pin, e.g. 2 kg."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Rod:
    """A uniform rod pinned to a vertical shaft that turns: the angle it stands out at, its frequency, the pin's force.

    Equation
    --------
    cos θ = 3·g/(2·L·Ω²) above Ω² = 3·g/(2·L), else it hangs; frequencies Ω·sin θ and √(Ω_c² − Ω²).

    Returns
    -------
    Rod
        Critical speed, angle, frequency, force.

    Raises
    ------
    InadmissibleError
        When the length is not above zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 8.12.

    Examples
    --------
    >>> round(rod(length=0.8, speed=7.0).angle * 57.29577951308232, 9)
    67.959958847
    """
    require(length > 0.0, "the length of {length} is not above zero", length=(length, Length))
    critical, turning = sqrt(1.5 * (gravity / length)), abs(speed)
    two_pi = 2.0 * pi_beside(length, speed, gravity)
    squared = (critical - turning) * (critical + turning)
    if plain(squared) >= 0.0:
        rate = sqrt(squared) if plain(squared) > 0.0 else 0.0 * squared
        return Rod(
            critical=critical, motion="hangs along the shaft", angle=0.0 * critical, frequency=rate / two_pi,
            pin_force=None if mass is None else mass * gravity,
        )  # fmt: skip
    ratio = critical / turning
    cosine = ratio * ratio
    sine = sqrt(-squared) * sqrt(turning * turning + critical * critical) / (turning * turning)
    pull = 0.5 * length * sine * turning * turning
    return Rod(
        critical=critical,
        motion="stands out from the shaft",
        angle=atan2(sine, cosine),
        frequency=turning * sine / two_pi,
        pin_force=None if mass is None else mass * hypot(gravity, pull),
    )
