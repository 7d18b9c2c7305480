"""The task `disk`: a disk or hoop rolling, pivoting, or going round in a steady turn."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import cos, sin, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Friction,
    Gravity,
    GrowthRate,
    Length,
    Size,
    Text,
    TurnRate,
)
from dynamics_cli.records import Choice, record

QUARTER = 1.5707963267948966


class Wheel(Choice):
    """How its mass is spread."""

    __slots__ = ()
    names = ("disk", "hoop")


DISK = Wheel("disk")


@record
class Disk:
    """From which speeds a disk is stable, and its steady turn."""

    rolling_limit: Annotated[TurnRate, "Upright rolling is stable above it [rad/s]."]
    pivoting_limit: Annotated[TurnRate, "Upright pivoting about the vertical is stable above it [rad/s]."]
    upright: Annotated[Text | None, "Whether upright rolling is stable at the roll rate."]
    growth: Annotated[GrowthRate | None, "Rate at which it falls from there, where it does [1/s]."]
    spin: Annotated[TurnRate | None, "Angular velocity along its axis in the steady turn, a size [rad/s]."]
    path_radius: Annotated[Length | None, "Radius of the circle of its centre [m]."]
    needed_friction: Annotated[Friction | None, "Friction the steady turn needs [-]."]


def disk(
    *,
    radius: Annotated[Size, "Radius, e.g. 300 mm."],
    wheel: Annotated[Wheel, "A uniform disk, or a hoop."] = DISK,
    roll: Annotated[TurnRate | None, "Angular velocity of upright rolling, e.g. 4 rad/s."] = None,
    lean: Annotated[Angle | None, "Lean of its plane from the vertical, in a steady turn, e.g. 20 deg."] = None,
    turn: Annotated[TurnRate | None, "Rate of the steady turn about the vertical, e.g. 1.5 rad/s."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Disk:
    """A thin disk or hoop on a level floor without slip: least speeds of rolling and pivoting, and steady turns.

    Equation
    --------
    Rolling ω² > A·m·g·r/(C·(C + m·r²)); pivoting Ω² > m·g·r/(A + m·r²); steady turn
    (C + m·r²)·ω₃·φ̇·sin θ − A·φ̇²·sin θ·cos θ + m·g·r·cos θ = 0, θ between axis and vertical.

    Returns
    -------
    Disk
        Limits, growth, and the steady turn.

    Raises
    ------
    InadmissibleError
        When the radius is not above zero, lean and turn are not given together, the lean is not between 0 and 90
        degrees, or the turn is zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 8.13 and 14.5.

    Examples
    --------
    >>> round(disk(radius=0.3).rolling_limit, 9)
    3.300951041
    """
    require(radius > 0.0, "the radius of {radius} is not above zero", radius=(radius, Size))
    require((lean is None) == (turn is None), "a steady turn needs both its lean and its rate", code="missing",
            hint="give --lean and --turn")  # fmt: skip
    axial, across = _moments(wheel)
    pull = gravity / radius
    rolling = sqrt(across * pull / (axial * (axial + 1.0)))
    upright = growth = None
    if roll is not None:
        squared = growth_factor(wheel) * (rolling - abs(roll)) * (rolling + abs(roll))
        falls = plain(squared) > 0.0
        upright = "falls: it rolls too slowly" if falls else "stable"
        growth = sqrt(squared) if falls else None
    spin = path = friction = None
    if lean is not None and turn is not None:
        require((lean > 0.0) & (lean < QUARTER), "a lean of {lean} is no steady turn", lean=(lean, Angle), code="lean",
                hint="give a lean between 0 and 90 deg")  # fmt: skip
        require(abs(turn) > 0.0, "a turn of zero has no lean", code="turn", hint="give the rate of the turn")
        rate = abs(turn)
        # the axis is 90 degrees less the lean from the vertical
        along = (across * rate * rate * cos(lean) - pull) * sin(lean) / ((axial + 1.0) * rate * cos(lean))
        spin = abs(along)
        path = spin * radius / rate
        friction = spin * radius * rate / gravity
    return Disk(
        rolling_limit=rolling,
        pivoting_limit=sqrt(pull / (across + 1.0)),
        upright=upright,
        growth=growth,
        spin=spin,
        path_radius=path,
        needed_friction=friction,
    )


def _moments(wheel: str) -> "tuple[float, float]":
    """Moments of inertia by m·r²: axial, and across."""
    axial = 0.5 if wheel == DISK else 1.0
    return axial, 0.5 * axial


def growth_factor(wheel: str) -> float:
    """What the square of the growth is of the squares that the roll is short of its limit."""
    axial, across = _moments(wheel)
    return axial * (axial + 1.0) / (across * (across + 1.0))
