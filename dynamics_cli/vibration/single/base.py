"""One mass on a base that shakes, a machine with an unbalance, and the isolator that a machine or instrument needs."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, atan2, hypot, sqrt
from dynamics_cli.numerics.number import single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Angle,
    Annotated,
    DampingRatio,
    Force,
    Fraction,
    Frequency,
    Mass,
    Ratio,
    SagGravity,
    ShaftSpeed,
    Size,
    Unbalance,
    VibrationSpeed,
)
from dynamics_cli.records import Advice, record
from dynamics_cli.vibration.single.forced import NO_PEAK, magnification
from dynamics_cli.vibration.single.oscillator import (
    AtDetuning,
    AtFrequency,
    AtRatio,
    AtSpeed,
    Damper,
    DampingShare,
    Drive,
    Natural,
    Oscillator,
    OverWaves,
    Sag,
    Spring,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# √2: isolation begins here, whatever the damping.
ISOLATES = 1.4142135623730951


@record
class Shaking:
    """The base by the amplitude of its displacement."""

    base_amplitude: Annotated[Size, "Amplitude of the base's displacement, e.g. 2 mm."]

    def over(self, omega: float) -> float:
        """The amplitude at an angular frequency."""
        return self.base_amplitude


@record
class BaseAcceleration:
    """The base by the amplitude of its acceleration."""

    base_acceleration: Annotated[Acceleration, "Amplitude of the base's acceleration, e.g. 0.5 g."]

    def over(self, omega: float) -> float:
        """The amplitude of the displacement at an angular frequency."""
        return absolute(self.base_acceleration) / (omega * omega)


@record
class BaseVibration:
    """Vibration of a mass on a base that shakes."""

    transmissibility: Annotated[Ratio, "Amplitude of the mass over that of the base T [-]."]
    amplitude: Annotated[Size, "Amplitude of the mass [m]."]
    acceleration: Annotated[Acceleration, "Amplitude of its acceleration [m/s^2]."]
    phase: Annotated[Angle, "By how much the mass lags the base [rad]."]
    relative_amplitude: Annotated[Size, "Amplitude of the spring's deflection [m]."]
    relative_ratio: Annotated[Ratio, "That over the amplitude of the base [-]."]
    isolation: Annotated[Fraction | None, "1 − T, above √2 times the natural frequency [-]."]
    natural_frequency: Annotated[Frequency, "Undamped natural frequency f_n [Hz]."]
    ratio: Annotated[Ratio, "Frequency over natural frequency r [-]."]
    damping_ratio: Annotated[DampingRatio, "Damping over critical damping ζ [-]."]
    isolates_from: Annotated[Frequency, "From here on the mass shakes less than the base, √2·f_n [Hz]."]
    peak_frequency: Annotated[Frequency | None, "Where the transmissibility is largest [Hz]."]
    peak_transmissibility: Annotated[Ratio | None, "The largest transmissibility [-]."]
    advice: tuple[Advice, ...] = ()


def transmitted(gap: "Any", ratio: "Any", zeta: "Any") -> "tuple[Any, Any]":
    """T = √(1 + (2ζr)²)·H, and H."""
    across = 2.0 * zeta * ratio
    size = 1.0 / hypot(gap, across)
    return size * hypot(1.0, across), size


def behind(gap: "Any", ratio: "Any", zeta: "Any") -> "Any":
    """The lag of the mass behind the base."""
    across = 2.0 * zeta * ratio
    return atan2(across * ratio * ratio, gap + across * across)


def base(
    *,
    mass: Annotated[Mass | None, "The mass; not needed beside a natural frequency and a damping ratio."] = None,
    spring: Annotated[Spring | Natural | Sag, "The spring."],
    damping: Annotated[Damper | DampingShare | None, "The damping; none when left out."] = None,
    motion: Annotated[Shaking | BaseAcceleration, "How the base shakes."],
    excitation: Annotated[
        AtFrequency | AtSpeed | OverWaves | AtRatio | AtDetuning, "How fast the base shakes, or a vehicle over waves."
    ],
    gravity: Annotated[SagGravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> BaseVibration:
    """Vibration of a mass whose base shakes: absolute and relative motion, transmissibility, isolation.

    Equation
    --------
    X/Y = T = √(1 + (2ζr)²)·H, Z/Y = r²·H, H = 1/√((1 − r²)² + (2ζr)²); peak of T at r² = 2/(1 + √(1 + 8ζ²)).

    Returns
    -------
    BaseVibration
        Transmissibility, amplitudes of the mass and of the spring, isolation, and the peak.

    Raises
    ------
    InadmissibleError
        At resonance without damping, for negative damping or stiffness, or a frequency of zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 13.6.

    Examples
    --------
    >>> made = base(spring=Natural(5.0), motion=Shaking(0.001), excitation=AtRatio(2.0))
    >>> round(made.transmissibility, 9)
    0.333333333
    """
    system = Oscillator(mass, spring, damping, gravity)
    drive = Drive(excitation, system)
    drive.require_steady(system)
    shaking = motion.over(drive.omega)
    passed, size = transmitted(drive.gap, drive.ratio, system.zeta)
    relative = drive.ratio * drive.ratio * size
    place = height = None
    if system.zeta > 0.0:
        eight = sqrt(1.0 + 8.0 * system.zeta * system.zeta)
        square = 2.0 / (1.0 + eight)
        place = sqrt(square)
        height, _ = transmitted(8.0 * system.zeta * system.zeta / ((eight + 1.0) * (eight + 1.0)), place, system.zeta)
    return BaseVibration(
        transmissibility=passed,
        amplitude=passed * shaking,
        acceleration=passed * shaking * drive.omega * drive.omega,
        phase=behind(drive.gap, drive.ratio, system.zeta),
        relative_amplitude=relative * shaking,
        relative_ratio=relative,
        isolation=1.0 - passed if passed < 1.0 else None,
        natural_frequency=system.hertz,
        ratio=drive.ratio,
        damping_ratio=system.zeta,
        isolates_from=ISOLATES * system.hertz,
        peak_frequency=None if place is None else system.hertz * place,
        peak_transmissibility=height,
        advice=_amplifies(drive.ratio, passed),
    )


def _amplifies(ratio: "Any", passed: "Any") -> "tuple[Advice, ...]":
    if not single(ratio, passed) or passed < 1.0:
        return ()
    return (
        Advice(
            "no-isolation",
            "the mass shakes more than the base: isolation begins at √2 times the natural frequency",
            remedy="use a softer mount: dynamics vibration isolator",
        ),
    )


@record
class UnbalanceVibration:
    """Vibration of a machine with an unbalance."""

    amplitude: Annotated[Size, "Amplitude of the machine [m]."]
    velocity: Annotated[VibrationSpeed, "Effective (rms) velocity, as vibration severity is judged [m/s]."]
    phase: Annotated[Angle, "By how much the displacement lags the unbalance [rad]."]
    response: Annotated[Ratio, "Amplitude over U/M, r²·H [-]."]
    unbalance_force: Annotated[Force, "Rotating force of the unbalance [N]."]
    ground_force: Annotated[Force, "Amplitude of the force to the ground [N]."]
    transmissibility: Annotated[Ratio, "That over the rotating force [-]."]
    natural_frequency: Annotated[Frequency, "Undamped natural frequency f_n [Hz]."]
    critical_speed: Annotated[ShaftSpeed, "Speed at the natural frequency [rad/s]."]
    ratio: Annotated[Ratio, "Frequency over natural frequency r [-]."]
    damping_ratio: Annotated[DampingRatio, "Damping over critical damping ζ [-]."]
    peak_speed: Annotated[ShaftSpeed | None, "Speed of the largest amplitude [rad/s]."]
    peak_amplitude: Annotated[Size | None, "The largest amplitude [m]."]
    advice: tuple[Advice, ...] = ()


def unbalance(
    *,
    mass: Annotated[Mass, "Mass of the whole machine M, e.g. 200 kg."],
    unbalance: Annotated[Unbalance, "Unbalance U, mass times radius, e.g. 500 g*mm."],
    spring: Annotated[Spring | Natural | Sag, "The mounts."],
    damping: Annotated[Damper | DampingShare | None, "The damping; none when left out."] = None,
    excitation: Annotated[AtFrequency | AtSpeed | AtRatio | AtDetuning, "How fast the rotor turns."],
    gravity: Annotated[SagGravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> UnbalanceVibration:
    """Vibration of a machine on mounts with a rotating unbalance, and the force that reaches the ground.

    Equation
    --------
    X = (U/M)·r²·H, force to the ground U·ω²·T; largest amplitude at r = 1/√(1 − 2ζ²).

    Returns
    -------
    UnbalanceVibration
        Amplitude, rms velocity, phase, forces, critical speed and the largest amplitude.

    Raises
    ------
    InadmissibleError
        At resonance without damping, for negative damping or stiffness, zero mass or speed.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 13.6.

    Examples
    --------
    >>> made = unbalance(mass=1.0, unbalance=1e-3, spring=Natural(5.0), excitation=AtRatio(2.0))
    >>> round(made.response, 9)
    1.333333333
    """
    system = Oscillator(mass, spring, damping, gravity)
    drive = Drive(excitation, system)
    eccentric = unbalance / mass
    drive.require_steady(system, growth=(0.5 * system.turn * eccentric, Size))
    passed, size = transmitted(drive.gap, drive.ratio, system.zeta)
    _, lag = magnification(drive.gap, drive.ratio, system.zeta)
    response = drive.ratio * drive.ratio * size
    whirling = unbalance * drive.omega * drive.omega
    peaks = system.zeta > 0.0 and system.zeta < NO_PEAK
    return UnbalanceVibration(
        amplitude=eccentric * response,
        velocity=eccentric * response * drive.omega * NO_PEAK,
        phase=lag,
        response=response,
        unbalance_force=whirling,
        ground_force=whirling * passed,
        transmissibility=passed,
        natural_frequency=system.hertz,
        critical_speed=system.omega,
        ratio=drive.ratio,
        damping_ratio=system.zeta,
        peak_speed=system.omega / sqrt(1.0 - 2.0 * system.zeta * system.zeta) if peaks else None,
        peak_amplitude=eccentric / (2.0 * system.zeta * sqrt(system.room)) if peaks else None,
        advice=_amplifies(drive.ratio, passed),
    )


def require_share(passed: "Any") -> None:
    """Refuse a transmissibility that no isolator has."""
    require(
        passed < 1.0,
        "a transmissibility of {passed} is no isolation",
        passed=(passed, Ratio),
        code="no-isolation",
        hint="ask for less than 1, for example 0.1",
    )
    require(passed > 0.0, "no mount isolates wholly", code="no-isolation", hint="for example 0.05")
