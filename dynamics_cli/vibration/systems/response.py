"""Frequency response of several masses between two coordinates, its peaks, and all amplitudes at one frequency."""

import math

from dynamics_cli.errors import require
from dynamics_cli.numerics.roots import highest
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    DampingRatio,
    Force,
    Frequency,
    Receptance,
    Size,
    Text,
    VibrationSpeed,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.vibration.single.oscillator import AtFrequency, AtSpeed
from dynamics_cli.vibration.systems.inputs import Bodies, Line, Matrices, MatrixFiles, System

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.vibration.systems.modal import Modal

# Frequencies of the curve about each resonance, and between lowest and highest.
NEAR, GRID = 60, 400
RECIPROCAL = 1e-9
# A frequency this near to that of an undamped mode is in resonance.
AT_RESONANCE = 1e-9
UNDAMPED = "without damping, amplitudes are those of the steady motion; peaks have no height"


@record
class Motion:
    """What one coordinate does."""

    name: Annotated[Text, "The coordinate."]
    amplitude: Annotated[Size, "Amplitude [m]."]
    velocity: Annotated[VibrationSpeed, "Effective (rms) velocity [m/s]."]
    lag: Annotated[Angle, "By how much it lags the force [rad]."]


@record
class Peak:
    """A peak of the frequency response."""

    frequency: Annotated[Frequency, "Frequency of the peak [Hz]."]
    amplitude: Annotated[Size, "Amplitude there [m]."]
    receptance: Annotated[Receptance, "Amplitude over force [m/N]."]
    lag: Annotated[Angle, "By how much the displacement lags the force [rad]."]


@record
class Response:
    """Frequency response."""

    amplitude: Annotated[Size | None, "Amplitude of the coordinate read, at the frequency given [m]."]
    lag: Annotated[Angle | None, "By how much it lags the force [rad]."]
    receptance: Annotated[Receptance | None, "Amplitude over force [m/N]."]
    motions: Annotated[tuple[Motion, ...] | None, "All coordinates at the frequency given."]
    peak: Annotated[Size | None, "Largest amplitude of the coordinate read over all frequencies [m]."]
    peak_frequency: Annotated[Frequency | None, "Frequency of that peak [Hz]."]
    peaks: Annotated[tuple[Peak, ...] | None, "Peaks of the coordinate read, from the lowest frequency."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def grid(modal: "Modal") -> "Any":
    """Angular frequencies of a curve over the lowest modes, closer about resonances."""
    import numpy as np

    moving = modal.omega > 0.0
    first = modal.omega[moving][:12] if moving.any() else np.ones(1)
    low, high = 0.3 * first[0], 2.0 * first[-1]
    parts = [np.geomspace(low, high, GRID)]
    for omega, zeta in zip(modal.omega[moving], modal.zeta[moving], strict=True):
        offsets = np.geomspace(max(zeta, 1e-6) / 20.0, 0.2, NEAR)
        parts += [omega * (1.0 + offsets), omega * (1.0 - offsets), np.array([omega])]
    whole = np.unique(np.concatenate(parts))
    return whole[(whole >= low) & (whole <= high)]


def response(
    *,
    system: Annotated[Line | Bodies | Matrices | MatrixFiles, "The system."],
    damping_ratio: Annotated[DampingRatio | None, "Damping ratio of every mode, instead of dampers, e.g. 0.02."] = None,
    force_at: Annotated[Text, "The coordinate that the force acts on: a name, or a number from 1."],
    read_at: Annotated[Text, "The coordinate that is read."],
    force: Annotated[Force, "Amplitude of the force, e.g. 500 N."] = 1.0,
    excitation: Annotated[AtFrequency | AtSpeed | None, "Frequency at which amplitudes are asked for."] = None,
) -> Response:
    """Frequency response between two coordinates of several masses: peaks, and amplitudes at one frequency.

    Equation
    --------
    x = (K − ω²M + iωC)⁻¹F; where damping leaves modes apart, Σφ_a·φ_b/(ω_r² − ω² + 2iζ_r·ω_r·ω).

    Returns
    -------
    Response
        Peaks, and amplitude, velocity and lag of every coordinate at the frequency given.

    Raises
    ------
    InadmissibleError
        Without damping when no frequency is given (peaks have no height) or at resonance, for names that are not
        there, singular masses, divergence.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 13.7 and 13.8.

    Examples
    --------
    >>> made = response(system=Line((1.0,), (1.0,)), damping_ratio=0.05, force_at="1", read_at="1")
    >>> round(made.peaks[0].receptance, 6)
    10.012523
    """
    from dynamics_cli.vibration.systems.modal import Modal

    model = System(system)
    modal = Modal(model, damping_ratio)
    damped = bool((modal.zeta > 0.0)[modal.omega > 0.0].all())
    require(
        damped or excitation is not None,
        "a mode has no damping: its peak has no height",
        code="undamped",
        hint="give --damping-ratio, for example 0.01, or dampers; or the --frequency at which amplitudes are wanted",
    )
    a, b = (model.moving(name) for name in (force_at, read_at))
    weights = modal.shapes[:, a]
    motions, largest = None, 0.0
    back = ahead = 0j
    if excitation is not None:
        rate = 2.0 * math.pi * excitation.frequency if isinstance(excitation, AtFrequency) else abs(excitation.speed)
        require(rate > 0.0, "the frequency is zero: nothing vibrates", code="at-rest")
        still = modal.omega[modal.zeta == 0.0]
        require(
            not (abs(still - rate) <= AT_RESONANCE * rate).any(),
            "at {frequency} a mode without damping is in resonance: its amplitude grows without limit",
            frequency=(rate / (2.0 * math.pi), Frequency),
            code="resonance",
            hint="give --damping-ratio, for example 0.01, or dampers",
        )
        column = modal.column(rate, weights)
        ahead, back = complex(column[b]), complex(modal.column(rate, modal.shapes[:, b])[a])
        largest = float(abs(column).max())
        motions = _motions(model, column, rate, abs(force))
    size = None if excitation is None else abs(ahead)
    off = abs(ahead - back) / max(abs(ahead), 1e-300) if excitation is not None else 0.0
    lost = RECIPROCAL * (1.0 if size is None else max(1.0, largest / max(size, 1e-300)))
    peaks = _peaks(modal, weights, b, abs(force)) if damped else ()
    highest_peak = max(peaks, key=lambda peak: peak.amplitude, default=None)
    return Response(
        amplitude=None if size is None else size * abs(force),
        lag=None if size is None else _lag(ahead),
        receptance=size,
        motions=motions,
        peak=None if highest_peak is None else highest_peak.amplitude,
        peak_frequency=None if highest_peak is None else highest_peak.frequency,
        peaks=peaks or None,
        checks=(Check("reciprocity", off <= lost, off, lost),) if excitation is not None else (),
        advice=(*model.advice, *(() if damped else (Advice("undamped", UNDAMPED, severity="note"),))),
    )


def _lag(x: complex) -> float:
    """The angle by which a phasor lags the force, from 0 to 2π."""
    turn = -math.atan2(x.imag, x.real)
    return turn if turn >= -1e-12 else turn + 2.0 * math.pi


def _motions(model: System, column: "Any", rate: float, force: float) -> "tuple[Motion, ...]":
    return tuple(
        Motion(model.names[place], abs(x) * force, abs(x) * force * rate * math.sqrt(0.5), _lag(x))
        for place, x in zip(model.kept, map(complex, column), strict=True)
    )


def _peaks(modal: "Modal", weights: "Any", read: int, force: float) -> "tuple[Peak, ...]":
    """Maxima of the curve, each by a golden section between the points beside it."""
    rates = grid(modal)
    sizes = abs(modal.curve(rates, weights, read))
    peaks = []
    for i in range(1, len(rates) - 1):
        if sizes[i - 1] < sizes[i] >= sizes[i + 1]:
            ends = float(rates[i - 1]), float(rates[i + 1])
            at = highest(lambda rate: float(abs(modal.curve([rate], weights, read)[0])), *ends, 1e-7 * ends[1])
            value = complex(modal.curve([at], weights, read)[0])
            peaks.append(Peak(at / (2.0 * math.pi), abs(value) * force, abs(value), _lag(value)))
    return tuple(peaks)
