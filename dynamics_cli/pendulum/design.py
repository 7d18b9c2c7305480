"""The task `design`: the length, or the amplitude, for a wanted period."""

from dynamics_cli.errors import UsageError, require, worded
from dynamics_cli.numerics.elementary import atan2, cos, pi_beside, sqrt
from dynamics_cli.numerics.elliptic import mean
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.roots import halved
from dynamics_cli.quantities import STANDARD_GRAVITY, Angle, Annotated, Gravity, Length, Ratio, Time
from dynamics_cli.records import record

PI = 3.141592653589793
SECONDS_PER_DAY = 86400.0


@record
class Design:
    """A simple pendulum of a wanted period."""

    length: Annotated[Length, "Length of the simple pendulum [m]."]
    amplitude: Annotated[Angle, "Its amplitude [rad]."]
    small_period: Annotated[Time, "Period of its small swings [s]."]
    slowdown: Annotated[Ratio, "The period over that of small swings [-]."]
    daily_loss: Annotated[Time, "What a clock set by small swings loses in a day at this amplitude [s]."]
    length_per_second: Annotated[Length, "Length to add for a clock to lose one second more in a day [m]."]


def design(
    *,
    period: Annotated[Time, "Time of a full swing, there and back, e.g. 2 s."],
    amplitude: Annotated[Angle | None, "Amplitude, where the length is wanted; small unless given, e.g. 3 deg."] = None,
    length: Annotated[Length | None, "Length, where the amplitude is wanted, e.g. 0.99 m."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Design:
    """The length of a simple pendulum for a wanted period at an amplitude, or the amplitude for a length.

    Equation
    --------
    L = g·(T·M(1, cos ½θ₀)/(2π))²; for the amplitude M(1, cos ½θ₀) = 2π·√(L/g)/T.

    Returns
    -------
    Design
        The pendulum, and what its amplitude costs a clock.

    Raises
    ------
    UsageError
        When both length and amplitude are given.
    InadmissibleError
        When the period is not above zero, the amplitude is 180 degrees or more, or the length swings slower than
        that at every amplitude.

    References
    ----------
    Borwein & Borwein, Pi and the AGM, Wiley 1987, section 1.1.

    Examples
    --------
    >>> round(design(period=2.0, amplitude=0.0).length, 6)
    0.993621
    """
    require(period > 0.0, "the period of {period} is not above zero", period=(period, Time))
    if length is not None and amplitude is not None:
        raise UsageError("length and amplitude are both given: the period follows from them", code="ambiguous",
                         hint="give one of them, or ask `dynamics pendulum simple`")  # fmt: skip
    pi = pi_beside(period, gravity)
    if length is None:
        amplitude = 0.0 * period if amplitude is None else amplitude
        require(abs(amplitude) < PI, "the amplitude is {amplitude}; it must be below 180 deg",
                amplitude=(amplitude, Angle), code="at-top", hint="give an amplitude below 180 deg")  # fmt: skip
        complement = cos(0.5 * amplitude)
        ratio = mean(1.0 + 0.0 * complement, complement)
        root = period * ratio / (2.0 * pi)
        length = gravity * root * root
        angle = abs(amplitude)
    else:
        require(length > 0.0, "the length of {length} is not above zero", length=(length, Length))
        ratio = 2.0 * pi * sqrt(length / gravity) / period
        require(
            ratio <= 1.0, "a pendulum of {length} takes {least} and longer at every amplitude, {period} is wanted",
            length=(length, Length), least=(2.0 * pi * sqrt(length / gravity), Time), period=(period, Time),
            code="too-long", hint=worded("shorten it to {length}",
            length=(gravity * (period / (2.0 * pi)) ** 2, Length)),
        )  # fmt: skip
        angle = _amplitude(ratio)
    small = period * ratio
    return Design(
        length=length,
        amplitude=angle,
        small_period=small,
        slowdown=1.0 / ratio,
        daily_loss=SECONDS_PER_DAY * (1.0 - ratio),
        length_per_second=2.0 * length / SECONDS_PER_DAY,
    )


def _amplitude(wanted: float) -> float:
    """The amplitude at which M(1, cos ½θ₀) is as wanted, by halving on the complementary modulus."""
    high = halved(lambda modulus: mean(1.0, modulus) < plain(wanted), 0.0, 1.0)[1]
    return 2.0 * atan2(sqrt((1.0 - high) * (1.0 + high)), high)
