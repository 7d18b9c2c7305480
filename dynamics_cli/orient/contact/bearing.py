"""A ball between a fixed race and a conical shaft: where it rolls without spin, and how fast all turns."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.orientation.quaternions import opposite
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import Angle, Annotated, Ratio, ShaftSpeed, Size
from dynamics_cli.records import Advice, record

RIGHT_ANGLE_HALF = 0.7853981633974483
ROOT_TWO = 1.4142135623730951
# Less spin than this share of the shaft's speed goes unsaid.
SLIGHT = 1e-6


@record
class Bearing:
    """Geometry and speeds of the bearing."""

    rolling_radius: Annotated[Size, "Radius of the ball centres' circle for rolling without spin on the shaft [m]."]
    centre_radius: Annotated[Size, "Radius of the ball centres' circle taken [m]."]
    contact_radius: Annotated[Size, "Radius of the shaft where balls touch it [m]."]
    cage_ratio: Annotated[Ratio, "Speed of the cage over that of the shaft [-]."]
    ball_ratio: Annotated[Ratio, "Speed of a ball, about an axis at 45°, over that of the shaft [-]."]
    spin_ratio: Annotated[Ratio, "Spin at the shaft contact over the speed of the shaft: zero when it only rolls [-]."]
    cage_speed: Annotated[ShaftSpeed | None, "Speed of the cage [rad/s]."] = None
    ball_speed: Annotated[ShaftSpeed | None, "Speed of a ball about its axis, in the fixed frame [rad/s]."] = None
    spin_speed: Annotated[ShaftSpeed | None, "Spin at the contact of ball and shaft [rad/s]."] = None
    advice: tuple[Advice, ...] = ()


def bearing(
    *,
    cone_angle: Annotated[Angle, "Half-angle of the shaft's cone, below 45 deg, e.g. 25 deg."],
    ball_radius: Annotated[Size, "Radius of a ball, e.g. 12 mm."],
    centre_radius: Annotated[Size | None, "Radius of the ball centres' circle, e.g. 35 mm; else without spin."] = None,
    shaft_speed: Annotated[ShaftSpeed | None, "Speed of the shaft, e.g. 1500 rpm."] = None,
) -> Bearing:
    """Radius at which balls roll without spin between a fixed race and a conical shaft, and the speeds of all parts.

    Equation
    --------
    b = a·(1 + sin θ)/(cos θ − sin θ); ball on floor and wall of the race: ω = w·(1, 1) with
    w = −Ω·(b − a·cos θ)/(a·(1 + cos θ + sin θ)), cage −w·a/b, spin w·(cos θ − sin θ) + Ω·sin θ.

    Raises
    ------
    InadmissibleError
        When the cone's half-angle is not between 0 and 45°, a radius is zero, or balls would reach the axis.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 4.13.

    Examples
    --------
    >>> round(bearing(cone_angle=0.4363323129985824, ball_radius=0.012).rolling_radius, 9)
    0.035294168
    """
    require(
        (cone_angle >= 0.0) & (cone_angle < RIGHT_ANGLE_HALF),
        "a cone of half-angle {angle} has no circle of rolling without spin",
        code="cone",
        hint="give a half-angle below 45 deg",
        angle=(cone_angle if single(cone_angle) else 0.0, Angle),
    )
    require(ball_radius > 0.0, "a ball of radius 0 does not roll", code="size")
    c, s = turned(cone_angle)
    best = ball_radius * (1.0 + s) / (c - s)
    radius = best if centre_radius is None else centre_radius
    contact = radius - ball_radius * c
    require(
        contact > 0.0,
        "at a radius of {radius} of the balls' circle the shaft has no radius left",
        code="size",
        hint="it must be larger than the balls' radius",
        radius=(radius if single(radius) else 0.0, Size),
    )
    # of the ball's angular velocity, each of the two equal components along and across the shaft, for Ω = 1
    w = opposite(contact / (ball_radius * (1.0 + c + s)))
    cage = opposite(w * ball_radius / radius)
    spin = w * (c - s) + s if centre_radius is not None else 0.0 * s
    ball = ROOT_TWO * absolute(w)
    turning = None if shaft_speed is None else absolute(shaft_speed)
    alone = single(w)
    return Bearing(
        rolling_radius=best,
        centre_radius=radius,
        contact_radius=contact,
        cage_ratio=cage,
        ball_ratio=ball,
        spin_ratio=spin,
        cage_speed=None if shaft_speed is None else cage * shaft_speed,
        ball_speed=None if turning is None else ball * turning,
        spin_speed=None if shaft_speed is None else spin * shaft_speed,
        advice=_advice(spin, best) if alone else (),
    )


def _advice(spin: float, best: float) -> tuple[Advice, ...]:
    if abs(plain(spin)) < SLIGHT:
        return ()
    message = worded(
        "the balls spin on the shaft at {share:3} of its speed; without spin the radius is {best:6}",
        share=(abs(plain(spin)), Ratio),
        best=(best, Size),
    )
    return (Advice("spin", message, severity="note"),)
