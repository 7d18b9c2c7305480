"""Free vibration of one mass: viscous damping of any size, or dry friction."""

import math

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, atan2, cos, hypot, log, pi_beside, sin, sqrt
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    AngularRate,
    Annotated,
    Coordinate,
    Count,
    DampingRatio,
    Frequency,
    Friction,
    Gravity,
    Mass,
    Ratio,
    Size,
    Text,
    Time,
    VibrationSpeed,
    ViscousDamping,
)
from dynamics_cli.records import Advice, record
from dynamics_cli.vibration.single.motion import free_motion
from dynamics_cli.vibration.single.oscillator import Damper, DampingShare, Natural, Oscillator, Sag, Spring

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_HALF_CYCLES = 1e6


@record
class DryFriction:
    """Sliding friction on the ground instead of a damper."""

    friction: Annotated[Friction, "Coefficient of dry friction on level ground, e.g. 0.1."]


@record
class FreeVibration:
    """Free vibration of one mass."""

    natural_frequency: Annotated[Frequency, "Undamped natural frequency f_n [Hz]."]
    angular_frequency: Annotated[AngularRate, "That in radians, ω_n [rad/s]."]
    damping_ratio: Annotated[DampingRatio | None, "Damping over critical damping ζ [-]."]
    motion: Annotated[Text, "Undamped, underdamped, critically damped, overdamped, or stopped by dry friction."]
    damped_frequency: Annotated[Frequency | None, "Frequency of the damped vibration [Hz]."]
    period: Annotated[Time | None, "Time of one damped cycle [s]."]
    decrement: Annotated[Ratio | None, "Logarithmic decrement: ln of one peak over the next [-]."]
    cycles_to_half: Annotated[Ratio | None, "Cycles until the amplitude is half [-]."]
    critical_damping: Annotated[ViscousDamping | None, "Damping without overshoot, 2√(km) [N·s/m]."]
    amplitude: Annotated[Size | None, "Envelope at the start; for dry friction the first turning point [m]."]
    position: Annotated[Coordinate | None, "Displacement at the time given [m]."]
    velocity: Annotated[VibrationSpeed | None, "Velocity at the time given [m/s]."]
    dead_band: Annotated[Size | None, "Within this of the middle, dry friction holds the mass [m]."]
    half_cycles: Annotated[Count | None, "Half cycles until dry friction stops it [-]."]
    rest_position: Annotated[Coordinate | None, "Where dry friction stops it [m]."]
    stop_time: Annotated[Time | None, "When [s]."]
    advice: tuple[Advice, ...] = ()


def free(
    *,
    mass: Annotated[Mass | None, "The mass, e.g. 2 kg."] = None,
    spring: Annotated[Spring | Natural | Sag, "The spring."],
    damping: Annotated[Damper | DampingShare | DryFriction | None, "The damping; none when left out."] = None,
    displacement: Annotated[Coordinate, "Displacement at the start, e.g. 100 mm."] = 0.0,
    start_velocity: Annotated[VibrationSpeed, "Velocity at the start, e.g. -200 mm/s."] = 0.0,
    time: Annotated[Time | None, "When displacement and velocity are asked for, e.g. 0.7 s."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> FreeVibration:
    """Free vibration of one mass on a spring, with viscous damping of any size or with dry friction.

    Equation
    --------
    x = e^{−σt}·(x₀·C + (v₀ + σx₀)·S), σ = ζω_n, w = ω_n² − σ²; C = cos √w·t, S = sin(√w·t)/√w, hyperbolic for w < 0.
    Dry friction: peaks fall by 2μmg/k in each half cycle; the mass stops within μmg/k of the middle.

    Returns
    -------
    FreeVibration
        Frequencies, damping, the kind of motion, decrement, and the state at a time.

    Raises
    ------
    InadmissibleError
        When the stiffness is negative (divergence) or zero, the damping negative, or the mass zero or missing.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 13.3 and 13.5.

    Examples
    --------
    >>> made = free(mass=2.0, spring=Spring(50.0), damping=Damper(4.0), displacement=0.1, start_velocity=-0.2, time=0.7)
    >>> round(made.position, 12)
    -0.044741475563
    """
    if isinstance(damping, DryFriction):
        return _dry(
            Oscillator(mass, spring, None, gravity), damping.friction, displacement, start_velocity, time, gravity
        )
    system = Oscillator(mass, spring, damping, gravity)
    position = velocity = None
    if time is not None:
        position, velocity = free_motion(displacement, start_velocity, system.omega, system.zeta, system.room, time)
    swings = not system.is_critical and system.room > 0.0
    damped = system.hertz * sqrt(system.room) if swings else None
    decays = swings and system.zeta > 0.0
    decrement = system.turn * system.zeta / sqrt(system.room) if decays else None
    amplitude = None
    if swings:
        pace = system.omega * sqrt(system.room)
        amplitude = hypot(displacement, (start_velocity + system.zeta * system.omega * displacement) / pace)
    return FreeVibration(
        natural_frequency=system.hertz,
        angular_frequency=system.omega,
        damping_ratio=system.zeta,
        motion=_motion(system),
        damped_frequency=damped,
        period=None if damped is None else 1.0 / damped,
        decrement=decrement,
        cycles_to_half=None if decrement is None else log(2.0 + 0.0 * decrement) / decrement,
        critical_damping=None if mass is None else 2.0 * mass * system.omega,
        amplitude=amplitude,
        position=position,
        velocity=velocity,
        dead_band=None,
        half_cycles=None,
        rest_position=None,
        stop_time=None,
    )


def _motion(system: Oscillator) -> str:
    if system.zeta == 0.0:
        return "undamped"
    if system.is_critical:
        return "critically damped"
    return "underdamped" if system.room > 0.0 else "overdamped, does not swing"


def _dry(system: Oscillator, friction: "Any", x: "Any", v: "Any", time: "Any", gravity: "Any") -> FreeVibration:
    """Half cycles about the edges of the dead band, each of half a natural period."""
    omega = system.omega
    band = friction * gravity / (omega * omega)
    require(friction > 0.0, "a friction of zero stops nothing", code="no-friction", hint="leave --friction out")
    pushed = bool(v != 0.0)
    way = -1.0 if v < 0.0 else 1.0
    # the first arc turns about the edge of the band that friction pushes towards
    middle = 0.0 - way * band
    radius = hypot(x - middle, v / omega)
    lag = atan2(way * v / omega, way * (x - middle)) / omega if pushed else 0.0 * x
    turning = middle + way * radius if pushed else x
    later = max(0, math.ceil(plain((absolute(turning) - band) / (2.0 * band))))
    require(
        later < MOST_HALF_CYCLES, "friction so small hardly stops it: {n} half cycles", n=str(later), code="friction"
    )
    side = 1.0 if turning >= 0.0 else -1.0
    rest = side * (-1.0) ** later * (absolute(turning) - 2.0 * band * float(later))
    half = pi_beside(omega) / omega
    stop = lag + half * float(later)
    position = velocity = None
    if time is not None:
        arcs = _Arcs(middle, radius, lag, turning, band, later, omega)
        position, velocity = (rest, 0.0 * rest) if time >= stop else arcs.at(time, way)
    note = Advice("held", "friction holds the mass where it is", severity="note")
    return FreeVibration(
        natural_frequency=system.hertz, angular_frequency=omega, damping_ratio=None,
        motion="stopped by dry friction", damped_frequency=system.hertz, period=1.0 / system.hertz,
        decrement=None, cycles_to_half=None, critical_damping=None, amplitude=absolute(turning),
        position=position, velocity=velocity, dead_band=band, half_cycles=later + (1 if pushed else 0),
        rest_position=rest, stop_time=stop, advice=() if pushed or later or not single(x) else (note,),
    )  # fmt: skip


class _Arcs:
    """The motion between turning points."""

    def __init__(
        self, middle: "Any", radius: "Any", lag: "Any", turning: "Any", band: "Any", later: int, omega: "Any"
    ) -> None:
        self.middle, self.radius, self.lag = middle, radius, lag
        self.turning, self.band, self.later, self.omega = turning, band, later, omega

    def at(self, time: "Any", way: float) -> "tuple[Any, Any]":
        """Displacement and velocity before it stops."""
        if time <= self.lag:
            phase = self.omega * (time - self.lag)
            return self.middle + way * self.radius * cos(phase), 0.0 - way * self.radius * self.omega * sin(phase)
        nth = int(plain(self.omega * (time - self.lag)) // math.pi)
        side = (1.0 if self.turning >= 0.0 else -1.0) * (-1.0) ** nth
        radius = absolute(self.turning) - self.band * float(2 * nth + 1)
        phase = self.omega * (time - self.lag) - float(nth) * pi_beside(self.omega)
        return side * (self.band + radius * cos(phase)), 0.0 - side * radius * self.omega * sin(phase)
