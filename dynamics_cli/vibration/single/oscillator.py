"""One mass on a spring with a damper: what may be given of it, and what it is refused for."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, multiply_add, pi_beside, sqrt
from dynamics_cli.quantities import (
    Annotated,
    DampingRatio,
    Frequency,
    Length,
    Ratio,
    RoadSpeed,
    ShaftSpeed,
    Size,
    SpringRate,
    ViscousDamping,
)
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# The rounding of inputs: damping this near to critical, relatively, is critical.
NEAR = 1e-15


@record
class Spring:
    """The spring by its rate."""

    stiffness: Annotated[SpringRate, "Stiffness of all springs together, e.g. 20 N/mm."]


@record
class Natural:
    """The spring by the frequency that it gives the mass."""

    natural_frequency: Annotated[Frequency, "Undamped natural frequency, e.g. 8 Hz."]


@record
class Sag:
    """The spring by its deflection under the weight."""

    static_deflection: Annotated[Size, "Deflection under the weight of the mass, e.g. 5 mm."]


@record
class Damper:
    """Damping by its coefficient."""

    damping: Annotated[ViscousDamping, "Force of the damper per speed, e.g. 50 N*s/m."]


@record
class DampingShare:
    """Damping over critical damping."""

    damping_ratio: Annotated[DampingRatio, "Damping over critical damping, e.g. 0.05."]


@record
class AtFrequency:
    """Excitation by its frequency."""

    frequency: Annotated[Frequency, "Frequency of the excitation, e.g. 25 Hz."]


@record
class AtSpeed:
    """Excitation once a revolution."""

    speed: Annotated[ShaftSpeed, "Speed of the shaft, one cycle a revolution, e.g. 1450 rpm."]


@record
class AtRatio:
    """Excitation over natural frequency."""

    frequency_ratio: Annotated[Ratio, "Frequency over natural frequency, e.g. 0.8."]


@record
class AtDetuning:
    """Excitation by its distance from resonance."""

    detuning: Annotated[Ratio, "Frequency over natural frequency, less one, e.g. 1e-6."]


@record
class OverWaves:
    """A vehicle over a wavy road."""

    road_speed: Annotated[RoadSpeed, "Speed of a vehicle over a wavy road, e.g. 60 km/h."]
    wavelength: Annotated[Length, "From crest to crest, e.g. 6 m."]

    @property
    def frequency(self) -> "Any":
        """Crests in a second."""
        require(self.wavelength > 0.0, "the wavelength is zero", code="no-length", hint="for example 6 m")
        return self.road_speed / self.wavelength


class Oscillator:
    """Mass (or none), stiffness (or none), natural frequency, damping ratio.

    `room` is 1 − ζ² without its cancellation.
    """

    def __init__(self, mass: "Any", spring: "Any", damping: "Any", gravity: float) -> None:
        require(mass is None or mass > 0.0, "the mass is zero", code="no-mass", hint="give a mass above zero")
        self.mass = mass
        self.stiffness: Any = None
        if isinstance(spring, Spring):
            self._of_spring(spring.stiffness)
        elif isinstance(spring, Natural):
            hertz = spring.natural_frequency
            require(hertz > 0.0, "a natural frequency of zero: nothing brings the mass back", code="no-stiffness")
            self.hertz: Any = hertz
            self.omega: Any = 2.0 * pi_beside(hertz, mass) * hertz
        else:
            sag = spring.static_deflection
            require(sag > 0.0, "a static deflection of zero: the spring is rigid", code="rigid")
            self.omega = sqrt(gravity / sag)
            self.hertz = self.omega / (2.0 * pi_beside(self.omega))
        if self.stiffness is None and mass is not None:
            self.stiffness = mass * self.omega * self.omega
        self._damped(damping)

    def _of_spring(self, stiffness: "Any") -> None:
        require(
            stiffness >= 0.0,
            "a stiffness of {stiffness} is negative: the mass moves away from rest, it does not vibrate",
            stiffness=(stiffness, SpringRate),
            code="divergence",
            hint="a spring that pushes away (an inverted pendulum, a magnet) needs a stiffer one beside it",
        )
        require(stiffness > 0.0, "a stiffness of zero: nothing brings the mass back", code="no-stiffness")
        require(
            self.mass is not None,
            "a stiffness alone gives no natural frequency",
            code="no-mass",
            hint="give --mass, or the spring by --natural-frequency or --static-deflection",
        )
        self.stiffness = stiffness
        self.omega = sqrt(stiffness / self.mass)
        self.hertz = self.omega / (2.0 * pi_beside(self.omega))

    def _damped(self, damping: "Any") -> None:
        self.damping: Any = None
        if isinstance(damping, Damper):
            self.damping = damping.damping
            require_damping(self.damping, ViscousDamping)
            require(
                self.mass is not None,
                "a damping coefficient alone gives no damping ratio",
                code="no-mass",
                hint="give --mass, or the damping by --damping-ratio",
            )
            self.zeta: Any = self.damping / (2.0 * self.mass * self.omega)
            self.room: Any = _room(self.mass, self.stiffness, self.damping)
        else:
            self.zeta = 0.0 if damping is None else damping.damping_ratio
            require_damping(self.zeta, DampingRatio)
            self.room = (1.0 - self.zeta) * (1.0 + self.zeta)
            if self.mass is not None:
                self.damping = 2.0 * self.zeta * self.mass * self.omega

    @property
    def turn(self) -> "Any":
        """2π beside the numbers of this oscillator."""
        return 2.0 * pi_beside(self.omega)

    @property
    def is_critical(self) -> bool:
        """Whether the damping is critical, to the rounding of the inputs."""
        return absolute(self.room) <= NEAR


def _room(mass: "Any", stiffness: "Any", damping: "Any") -> "Any":
    """1 − c²/(4km), its difference of products as if in twice the precision."""
    four = 4.0 * stiffness
    product = four * mass
    return (multiply_add(four, mass, 0.0 - product) + multiply_add(0.0 - damping, damping, product)) / product


def require_damping(damping: "Any", kind: "Any") -> None:
    """Refuse negative damping, which no task may call a decay."""
    require(
        damping >= 0.0,
        "damping of {damping} is negative: it feeds energy in, the motion grows and no decay or steady state exists",
        damping=(damping, kind),
        code="negative-damping",
        hint="give damping of zero or more; self-excited motion: dynamics vibration nonlinear --law van-der-pol",
    )


class Drive:
    """Frequency ratio r = ω/ω_n, 1 − r² without cancellation, ω and the frequency in hertz."""

    def __init__(self, excitation: "Any", system: Oscillator) -> None:
        if isinstance(excitation, AtDetuning):
            d = excitation.detuning
            self.ratio: Any = 1.0 + d
            self.gap: Any = 0.0 - d * (2.0 + d)
        elif isinstance(excitation, AtRatio):
            self.ratio = excitation.frequency_ratio
            self.gap = (1.0 - self.ratio) * (1.0 + self.ratio)
        elif isinstance(excitation, AtFrequency | OverWaves):
            hertz = excitation.frequency
            self.ratio = hertz / system.hertz
            self.gap = (system.hertz - hertz) * (system.hertz + hertz) / (system.hertz * system.hertz)
        else:
            omega = absolute(excitation.speed)
            self.ratio = omega / system.omega
            self.gap = (system.omega - omega) * (system.omega + omega) / (system.omega * system.omega)
        require(self.ratio > 0.0, "the frequency of the excitation is zero: nothing vibrates", code="at-rest")
        self.omega: Any = self.ratio * system.omega
        self.hertz: Any = self.ratio * system.hertz
        self.excitation = excitation

    def require_steady(self, system: Oscillator, growth: "Any" = None) -> None:
        """Refuse resonance without damping; `growth` is what the amplitude gains in a cycle, with its kind."""
        more = "" if growth is None else ", by {growth} in each cycle"
        typed = {} if growth is None else {"growth": growth}
        require(
            system.zeta + absolute(self.gap) > 0.0,
            "at resonance without damping there is no steady amplitude: it grows" + more,
            code="resonance",
            hint="give --damping-ratio or --damping, or a frequency off the natural one",
            **typed,
        )
