"""The task `simple`: a point mass on a rod or string, swinging or going round."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import acos, asin, atan2, cos, pi_beside, sin, sqrt, tanh
from dynamics_cli.numerics.elliptic import amplitude as elliptic_amplitude
from dynamics_cli.numerics.elliptic import functions, mean
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Force,
    Gravity,
    Length,
    Mass,
    Ratio,
    Speed,
    Text,
    Time,
    TurnRate,
)
from dynamics_cli.records import Advice, record

PI = 3.141592653589793
SWING, WHIRL, LIMIT = "swing", "goes round", "comes to rest at the top, in endless time"


@record
class Amplitude:
    """A swing from rest."""

    amplitude: Annotated[Angle, "Largest angle from the vertical, e.g. 60 deg."]


@record
class FromTop:
    """A swing from rest near the top."""

    from_top: Annotated[Angle, "Angle from the upright at which it is let go, e.g. 0.001 deg."]


@record
class BottomSpeed:
    """A motion by its speed at the bottom."""

    bottom_speed: Annotated[Speed, "Speed at the lowest point, e.g. 4 m/s."]


@record
class State:
    """A motion by a state on its way."""

    angle: Annotated[Angle, "Angle from the vertical, e.g. 30 deg."]
    rate: Annotated[TurnRate, "Angular velocity there, e.g. 2 rad/s."]


@record
class Simple:
    """How a simple pendulum moves."""

    motion: Annotated[Text, "Swing, or going round."]
    period: Annotated[Time | None, "Time of a full swing there and back, or of one turn; none at the limit [s]."]
    small_period: Annotated[Time, "Period of small swings [s]."]
    slowdown: Annotated[Ratio | None, "Period of the swing over that of small ones [-]."]
    amplitude: Annotated[Angle | None, "Largest angle from the vertical; none where it goes round [rad]."]
    bottom_speed: Annotated[Speed, "Speed at the lowest point [m/s]."]
    top_speed: Annotated[Speed | None, "Speed at the highest point; where it goes round [m/s]."]
    bottom_tension: Annotated[Force | None, "Force of rod or string at the lowest point; with the mass [N]."]
    end_tension: Annotated[Force | None, "At the end of the swing, or at the top; negative pushes; with the mass [N]."]
    slack_angle: Annotated[Angle | None, "Where a string would go slack; none where it stays taut [rad]."]
    angle_then: Annotated[Angle | None, "Angle at the time asked for [rad]."]
    rate_then: Annotated[TurnRate | None, "Angular velocity then [rad/s]."]
    advice: tuple[Advice, ...] = ()


def simple(
    *,
    length: Annotated[Length, "From the pivot to the point mass, e.g. 1 m."],
    start: Annotated[Amplitude | FromTop | BottomSpeed | State, "How it is started."],
    mass: Annotated[Mass | None, "The point mass, for forces, e.g. 2 kg."] = None,
    time: Annotated[
        Time | None, "A time for angle and rate, since it was let go, or since the bottom, e.g. 1.5 s."
    ] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Simple:
    """A simple pendulum at any amplitude, or going round: period, speeds, tension, and the state at a time.

    Equation
    --------
    Swing: T = 2π·√(L/g)/M(1, cos ½θ₀). Going round: T = 2π/M(ω_b, ω_t) with ω_t² = ω_b² − 4g/L. M is the
    arithmetic–geometric mean. From rest sin ½θ = k·cd(√(g/L)·t), k = sin ½θ₀.

    Returns
    -------
    Simple
        The motion; a result that does not exist is none.

    Raises
    ------
    InadmissibleError
        When the length is not above zero, the amplitude is 180 degrees or more, or a time is asked of a start on the
        way.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 8.4 and 10.8; Borwein & Borwein, Pi and
    the AGM, Wiley 1987, section 1.1.

    Examples
    --------
    >>> round(simple(length=1.0, start=Amplitude(1.5707963267948966)).slowdown, 12)
    1.180340599016
    """
    require(length > 0.0, "the length of {length} is not above zero", length=(length, Length))
    own = sqrt(gravity / length)
    modulus, complement, bottom = _energy(start, own, length)
    pi = pi_beside(length, gravity, bottom)
    small = 2.0 * pi / own
    # a modulus that rounds to one is still a swing where the angle says so
    swings = plain(complement) > 0.0 and (isinstance(start, Amplitude | FromTop) or plain(modulus) < 1.0)
    top = None
    if not swings:
        squared = (bottom - 2.0 * own) * (bottom + 2.0 * own)
        top = sqrt(squared) if plain(squared) > 0.0 else 0.0 * squared
    period = None
    if swings:
        period = small / mean(1.0 + 0.0 * complement, complement)
    elif top is not None and plain(top) > 0.0:
        period = 2.0 * pi / mean(bottom, top)
    end = _amplitude(start, modulus, complement) if swings else None
    motion = SWING if swings else WHIRL if period is not None else LIMIT
    then = _state(start, own, modulus, complement, bottom, top, time) if time is not None else (None, None)
    slack = _slack(length, gravity, bottom, top, end)
    return Simple(
        motion=motion,
        period=period,
        small_period=small,
        slowdown=1.0 / mean(1.0 + 0.0 * complement, complement) if swings else None,
        amplitude=end,
        bottom_speed=bottom * length,
        top_speed=None if top is None else top * length,
        bottom_tension=None if mass is None else mass * (gravity + length * bottom * bottom),
        end_tension=None if mass is None else mass * _end_pull(length, gravity, top, modulus, complement),
        slack_angle=slack,
        angle_then=then[0],
        rate_then=then[1],
        advice=_advice(slack, period, gravity, length),
    )


def _energy(
    start: "Amplitude | FromTop | BottomSpeed | State", own: float, length: float
) -> "tuple[float, float, float]":
    """Modulus k, complementary modulus, and the angular velocity at the bottom, 2k√(g/L)."""
    if isinstance(start, Amplitude):
        size = abs(start.amplitude)
        require(
            size < PI, "the amplitude is {amplitude}; it must be below 180 deg", amplitude=(start.amplitude, Angle),
            code="at-top",
            hint="give an amplitude below 180 deg, or --from-top, or the speed at the bottom",
        )  # fmt: skip
        require(size > 0.0, "at an amplitude of zero it does not move", code="at-rest",
                hint="the period of small swings is that of any small amplitude")  # fmt: skip
        modulus, complement = sin(0.5 * size), cos(0.5 * size)
    elif isinstance(start, FromTop):
        size = abs(start.from_top)
        require((size > 0.0) & (size < PI), "the angle from the top is {angle}; it must be above 0 and below 180 deg",
        angle=(start.from_top, Angle),
                code="at-top", hint="give an angle between 0 and 180 deg")  # fmt: skip
        modulus, complement = cos(0.5 * size), sin(0.5 * size)
    elif isinstance(start, BottomSpeed):
        bottom = abs(start.bottom_speed) / length
        require(bottom > 0.0, "it hangs at rest", code="at-rest", hint="give the speed at the bottom, above zero")
        modulus = 0.5 * bottom / own
        complement = _root((1.0 - modulus) * (1.0 + modulus))
    else:
        sine, cosine = sin(0.5 * start.angle), abs(cos(0.5 * start.angle))
        turn = 0.5 * abs(start.rate) / own
        modulus = sqrt(sine * sine + turn * turn)
        require(modulus > 0.0, "it hangs at rest", code="at-rest", hint="give an angle or a rate")
        complement = _root((cosine - turn) * (cosine + turn))
    return modulus, complement, 2.0 * modulus * own


def _root(squared: float) -> float:
    """The root of what may be below zero where it goes round."""
    return sqrt(squared) if plain(squared) > 0.0 else 0.0 * squared


def _amplitude(start: "Amplitude | FromTop | BottomSpeed | State", modulus: float, complement: float) -> float:
    if isinstance(start, Amplitude):
        return abs(start.amplitude)
    return 2.0 * atan2(modulus, complement)


def _end_pull(length: float, gravity: float, top: "float | None", modulus: float, complement: float) -> float:
    """Force by mass at the end of a swing, or at the top."""
    if top is not None:
        return length * top * top - gravity
    return gravity * (complement - modulus) * (complement + modulus)


def _slack(length: float, gravity: float, bottom: float, top: "float | None", end: "float | None") -> "float | None":
    """Where gravity pulls as much as the motion needs: the force of the string is zero."""
    slack = plain(end) > 0.5 * PI if end is not None else top is not None and plain(length * top * top - gravity) < 0.0
    return acos((2.0 * gravity - length * bottom * bottom) / (3.0 * gravity)) if slack else None


def _state(
    start: "Amplitude | FromTop | BottomSpeed | State",
    own: float,
    modulus: float,
    complement: float,
    bottom: float,
    top: "float | None",
    time: float,
) -> "tuple[float, float]":
    """Angle and angular velocity at a time: from rest at the amplitude, or from the bottom."""
    require(
        not isinstance(start, State), "a time is counted from rest or from the bottom", code="start",
        hint="give --amplitude or --bottom-speed; both are results here",
    )  # fmt: skip
    if top is None:
        sn, cn, dn = functions(own * time, modulus, complement)
        if isinstance(start, BottomSpeed):
            return 2.0 * atan2(modulus * sn, dn), bottom * cn
        return 2.0 * atan2(modulus * cn, complement), -bottom * complement * sn / dn
    if plain(top) > 0.0:
        ratio = top / bottom
        turned = elliptic_amplitude(0.5 * bottom * time, 2.0 * own / bottom, ratio)
        cn, round_once = cos(turned), ratio * ratio
        return 2.0 * turned, bottom * sqrt(round_once + (1.0 - ratio) * (1.0 + ratio) * cn * cn)
    # just to the top: the Gudermannian
    rise = tanh(0.5 * bottom * time)
    return 2.0 * asin(rise), bottom * sqrt((1.0 - rise) * (1.0 + rise))


def _advice(slack: "float | None", period: "float | None", gravity: float, length: float) -> "tuple[Advice, ...]":
    found = []
    if period is None:
        message = "its energy takes it to the top and no further, so that it has no period"
        found.append(Advice("no-period", message, severity="note", result="period"))
    if slack is not None:
        message = worded("a string goes slack at {angle}: these results are those of a rod", angle=(slack, Angle))
        least = worded("a string stays taut up to 90 deg, or all round from {speed} at the bottom",
                       speed=(sqrt(5.0 * gravity * length), Speed))  # fmt: skip
        found.append(Advice("slack", message, remedy=least))
    return tuple(found)
