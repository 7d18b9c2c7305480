"""One mass under a force that varies as a sine: steady amplitude, resonance peak, bandwidth, force to the ground."""

from dynamics_cli.errors import worded
from dynamics_cli.numerics.elementary import absolute, atan2, hypot, sqrt
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Coordinate,
    DampingRatio,
    Force,
    Fraction,
    Frequency,
    Mass,
    Ratio,
    SagGravity,
    Size,
    Time,
)
from dynamics_cli.records import Advice, record
from dynamics_cli.vibration.single.motion import free_motion, from_rest
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
    Sag,
    Spring,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# √½: from here on there is no resonance peak. The lower half-power point ends at sin 22.5°.
NO_PEAK, NO_LOWER = 0.7071067811865476, 0.3826834323650898


@record
class ForcedVibration:
    """The steady vibration under a force."""

    amplitude: Annotated[Size, "Amplitude of the steady vibration [m]."]
    phase: Annotated[Angle, "By how much the displacement lags the force [rad]."]
    magnification: Annotated[Ratio, "Amplitude over the static deflection of the force, H [-]."]
    natural_frequency: Annotated[Frequency, "Undamped natural frequency f_n [Hz]."]
    ratio: Annotated[Ratio, "Frequency over natural frequency r [-]."]
    damping_ratio: Annotated[DampingRatio, "Damping over critical damping ζ [-]."]
    transmissibility: Annotated[Ratio, "Force to the ground over the force [-]."]
    ground_force: Annotated[Force, "Amplitude of the force to the ground [N]."]
    peak_frequency: Annotated[Frequency | None, "Where the amplitude is largest [Hz]."]
    peak_amplitude: Annotated[Size | None, "The largest amplitude [m]."]
    lower_frequency: Annotated[Frequency | None, "Lower half-power frequency: peak/√2 [Hz]."]
    upper_frequency: Annotated[Frequency | None, "Upper half-power frequency [Hz]."]
    bandwidth: Annotated[Frequency | None, "Between the two [Hz]."]
    position: Annotated[Coordinate | None, "Displacement at the time given, from rest at time 0 [m]."]
    advice: tuple[Advice, ...] = ()


def magnification(gap: "Any", ratio: "Any", zeta: "Any") -> "tuple[Any, Any]":
    """H = 1/√((1 − r²)² + (2ζr)²), and the lag of the displacement."""
    across = 2.0 * zeta * ratio
    return 1.0 / hypot(gap, across), atan2(across, gap)


def forced(
    *,
    mass: Annotated[Mass, "The mass, e.g. 50 kg."],
    spring: Annotated[Spring | Natural | Sag, "The spring."],
    damping: Annotated[Damper | DampingShare | None, "The damping; none when left out."] = None,
    force: Annotated[Force, "Amplitude of the force F, e.g. 100 N."],
    excitation: Annotated[AtFrequency | AtSpeed | AtRatio | AtDetuning, "How fast the force varies."],
    time: Annotated[Time | None, "When the displacement is asked for: F·cos ωt from rest, e.g. 2 s."] = None,
    gravity: Annotated[SagGravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> ForcedVibration:
    """Steady vibration of one mass under a force F·cos ωt, its resonance peak, and the response from rest.

    Equation
    --------
    X = (F/k)·H, H = 1/√((1 − r²)² + (2ζr)²), tan φ = 2ζr/(1 − r²); peak at r² = 1 − 2ζ²; half power at
    r² = 1 − 2ζ² ∓ 2ζ√(1 − ζ²); force to the ground F·H·√(1 + (2ζr)²).

    Returns
    -------
    ForcedVibration
        Amplitude, phase, magnification, peak, half-power band, force to the ground, and displacement at a time.

    Raises
    ------
    InadmissibleError
        At resonance without damping, for negative damping or stiffness, or zero mass or frequency.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 13.4 and 13.6.

    Examples
    --------
    >>> made = forced(mass=1.0, spring=Natural(1.0), damping=DampingShare(0.05), force=1.0, excitation=AtRatio(1.0))
    >>> round(made.magnification, 9)
    10.0
    """
    system = Oscillator(mass, spring, damping, gravity)
    drive = Drive(excitation, system)
    still = force / system.stiffness
    if time is None:
        drive.require_steady(system, growth=(absolute(still) * 0.5 * system.turn, Size))
    steady = system.zeta + absolute(drive.gap) > 0.0
    size, lag = magnification(drive.gap, drive.ratio, system.zeta) if steady else (None, None)
    passed = None if size is None else size * hypot(1.0, 2.0 * system.zeta * drive.ratio)
    peak = _peak(system)
    lower, upper = _half_power(system)
    return ForcedVibration(
        amplitude=None if size is None else absolute(still) * size,  # type: ignore[arg-type]
        phase=lag,  # type: ignore[arg-type]
        magnification=size,  # type: ignore[arg-type]
        natural_frequency=system.hertz,
        ratio=drive.ratio,
        damping_ratio=system.zeta,
        transmissibility=passed,  # type: ignore[arg-type]
        ground_force=None if passed is None else absolute(force) * passed,  # type: ignore[arg-type]
        peak_frequency=None if peak is None else system.hertz * peak[0],
        peak_amplitude=None if peak is None else absolute(still) * peak[1],
        lower_frequency=lower,
        upper_frequency=upper,
        bandwidth=_width(system),
        position=None if time is None else _at(system, drive, force, time),
        advice=_advice(system, drive),
    )


def _peak(system: Oscillator) -> "tuple[Any, Any] | None":
    """Frequency ratio and height of the resonance peak."""
    zeta = system.zeta
    if not zeta > 0.0 or not zeta < NO_PEAK:
        return None
    return sqrt(1.0 - 2.0 * zeta * zeta), 1.0 / (2.0 * zeta * sqrt(system.room))


def _half_power(system: Oscillator) -> "tuple[Any, Any]":
    zeta = system.zeta
    if not zeta > 0.0 or not zeta < NO_PEAK:
        return None, None
    middle, side = 1.0 - 2.0 * zeta * zeta, 2.0 * zeta * sqrt(system.room)
    lower = system.hertz * sqrt(middle - side) if zeta < NO_LOWER else None
    return lower, system.hertz * sqrt(middle + side)


def _width(system: Oscillator) -> "Any":
    """f₂ − f₁ = (f₂² − f₁²)/(f₂ + f₁)."""
    lower, upper = _half_power(system)
    if lower is None:
        return None
    return system.hertz * system.hertz * 4.0 * system.zeta * sqrt(system.room) / (lower + upper)


def _at(system: Oscillator, drive: Drive, force: "Any", time: "Any") -> "Any":
    """The displacement at a time, from rest."""
    if system.room > 0.0 and not system.is_critical:
        unit = from_rest(system.omega, drive.omega, drive.gap, system.zeta, system.room, time)
        return force / system.mass * unit
    from dynamics_cli.numerics.elementary import cos, sin

    size, lag = magnification(drive.gap, drive.ratio, system.zeta)
    still = force / system.stiffness * size
    start, pace = still * cos(lag), still * drive.omega * sin(lag)
    free, _ = free_motion(0.0 - start, 0.0 - pace, system.omega, system.zeta, system.room, time)
    return still * cos(drive.omega * time - lag) + free


def _advice(system: Oscillator, drive: Drive) -> "tuple[Advice, ...]":
    if not single(system.zeta, drive.gap):
        return ()
    gap, zeta = abs(plain(drive.gap)), plain(system.zeta)
    if not zeta and not gap:
        text = "at resonance without damping there is no steady amplitude; the displacement is at the time given"
        return tuple(
            Advice("resonance", text, result=name)
            for name in ("amplitude", "phase", "magnification", "transmissibility", "ground_force")
        )
    if gap < 2.0 * zeta * plain(drive.ratio) and gap < 0.2:
        text = "within the resonance peak: the amplitude is as uncertain as the damping"
        return (Advice("near-resonance", text, remedy="measure the damping, or keep a distance of 20 % in frequency"),)
    if not zeta and gap < 0.2:
        text = "{off} beside resonance without damping: the true amplitude is set by damping that was left out"
        return (Advice("near-resonance", worded(text, off=(0.5 * gap, Fraction)), remedy="give --damping-ratio"),)
    return ()
