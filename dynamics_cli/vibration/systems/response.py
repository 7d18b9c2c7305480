"""Frequency response of several masses between two coordinates, its peaks, and all amplitudes at one frequency."""

import math

from dynamics_cli.errors import require
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
from dynamics_cli.vibration.single.oscillator import AtFrequency, AtSpeed, require_damping
from dynamics_cli.vibration.systems.inputs import Bodies, Line, Matrices, MatrixFiles, System
from dynamics_cli.vibration.systems.modes import LOST, undamped

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Frequencies of the curve about each resonance, and between lowest and highest.
NEAR, GRID = 60, 400
GOLDEN = 0.6180339887498949
RECIPROCAL = 1e-9


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
    peaks: Annotated[tuple[Peak, ...], "Peaks of the coordinate read, from the lowest frequency."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


class Receptances:
    """Receptance by frequency: a sum over modes where damping leaves them apart, else a solution at each frequency."""

    def __init__(self, those: System, damping_ratio: "float | None") -> None:
        import numpy as np

        self.mass, self.stiffness, self.damping = those.matrices()
        omega, shapes, errors, _ = undamped(those)
        require(
            those.elements is not None or bool((errors < LOST).all()),
            "a soft mode is lost in the rounding of the matrices",
            code="lost",
            hint="give masses and springs: --masses and --stiffnesses, or --body and --coupling",
        )
        self.omega, self.shapes = omega, shapes.T
        self.zeta: Any = np.full(len(omega), damping_ratio or 0.0)
        self.coupled = False
        if self.damping is not None:
            from dynamics_cli.vibration.systems.matrices import proportional

            self.coupled = not proportional(self.mass, self.damping, self.stiffness)
            modal = np.einsum("ir,ij,jr->r", self.shapes, self.damping, self.shapes)
            self.zeta = np.where(self.omega > 0.0, modal / (2.0 * np.where(self.omega > 0.0, self.omega, 1.0)), 0.0)
            self.rates = modal
        else:
            self.rates = 2.0 * self.zeta * self.omega

    def column(self, rate: float, force: int) -> "Any":
        """Receptances of all coordinates for a force on one, at an angular frequency."""
        import numpy as np

        if self.coupled:
            n = len(self.mass)
            unit = np.zeros(n)
            unit[force] = 1.0
            return np.linalg.solve(self.stiffness - rate * rate * self.mass + 1j * rate * self.damping, unit)
        below = (self.omega - rate) * (self.omega + rate) + 1j * rate * self.rates
        return self.shapes @ (self.shapes[force] / below)

    def curve(self, rates: "Any", force: int, read: int) -> "Any":
        """Receptances between two coordinates over angular frequencies."""
        import numpy as np

        rates = np.asarray(rates, dtype=float)
        if self.coupled:
            return np.array([self.column(float(rate), force)[read] for rate in rates])
        below = (self.omega - rates[:, None]) * (self.omega + rates[:, None]) + 1j * rates[:, None] * self.rates
        return (self.shapes[read] * self.shapes[force] / below).sum(axis=1)

    def grid(self, low: float, high: float) -> "Any":
        """Angular frequencies from low to high, closer about resonances."""
        import numpy as np

        parts = [np.geomspace(low, high, GRID)]
        for omega, zeta in zip(self.omega, self.zeta, strict=True):
            if omega > 0.0:
                offsets = np.geomspace(max(zeta, 1e-6) / 20.0, 0.2, NEAR)
                parts += [omega * (1.0 + offsets), omega * (1.0 - offsets), np.array([omega])]
        whole = np.unique(np.concatenate(parts))
        return whole[(whole >= low) & (whole <= high)]

    def limits(self) -> "tuple[float, float]":
        """Where a curve begins and ends unless it is said."""
        moving = [float(omega) for omega in self.omega if omega > 0.0] or [1.0]
        return 0.3 * moving[0], 2.0 * moving[min(len(moving), 12) - 1]


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
        Without damping (the peaks have no height), for names that are not there, singular masses, divergence.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 13.7 and 13.8.

    Examples
    --------
    >>> made = response(system=Line((1.0,), (1.0,)), damping_ratio=0.05, force_at="1", read_at="1")
    >>> round(made.peaks[0].receptance, 6)
    10.012523
    """
    those = System(system)
    if damping_ratio is not None:
        require_damping(damping_ratio, DampingRatio)
    of = Receptances(those, damping_ratio)
    require(
        of.damping is None or damping_ratio is None, "dampers and a damping ratio of all modes are both given",
        code="both", hint="leave out --damping-ratio, or the dampers",
    )  # fmt: skip
    moving = [zeta for zeta, omega in zip(of.zeta, of.omega, strict=True) if omega > 0.0]
    require(
        all(zeta > 0.0 for zeta in moving),
        "a mode has no damping: its peak has no height",
        code="undamped",
        hint="give --damping-ratio, for example 0.01, or dampers; frequencies alone: dynamics vibration modes",
    )
    a, b = (_place(those, name) for name in (force_at, read_at))
    motions = None
    back = ahead = 0j
    if excitation is not None:
        rate = 2.0 * math.pi * excitation.frequency if isinstance(excitation, AtFrequency) else abs(excitation.speed)
        require(rate > 0.0, "the frequency is zero: nothing vibrates", code="at-rest")
        column = of.column(rate, a)
        ahead, back = complex(column[b]), complex(of.column(rate, b)[a])
        motions = _motions(those, column, rate, abs(force))
    size = None if excitation is None else abs(ahead)
    off = abs(ahead - back) / max(abs(ahead), 1e-300) if excitation is not None else 0.0
    lost = RECIPROCAL * (1.0 if size is None else max(1.0, float(abs(of.column(rate, a)).max()) / max(size, 1e-300)))
    return Response(
        amplitude=None if size is None else size * abs(force),
        lag=None if size is None else _lag(ahead),
        receptance=size,
        motions=motions,
        peaks=_peaks(of, a, b, abs(force)),
        checks=(Check("reciprocity", off <= lost, off, lost),) if excitation is not None else (),
        advice=tuple(those.advice),
    )


def _place(those: System, name: str) -> int:
    place = those.place(name)
    require(
        place in those.kept, "{name} has no mass: it is condensed, and nothing acts or is read there", name=repr(name),
        code="condensed",
    )  # fmt: skip
    return those.kept.index(place)


def _lag(x: complex) -> float:
    """The angle by which a phasor lags the force, from 0 to 2π."""
    turn = -math.atan2(x.imag, x.real)
    return turn if turn >= -1e-12 else turn + 2.0 * math.pi


def _motions(those: System, column: "Any", rate: float, force: float) -> "tuple[Motion, ...]":
    return tuple(
        Motion(those.names[place], abs(x) * force, abs(x) * force * rate * math.sqrt(0.5), _lag(x))
        for place, x in zip(those.kept, map(complex, column), strict=True)
    )


def _peaks(of: Receptances, a: int, b: int, force: float) -> "tuple[Peak, ...]":
    """Maxima of the curve, each by a golden section between the points beside it."""
    low, high = of.limits()
    rates = of.grid(low, high)
    sizes = abs(of.curve(rates, a, b))
    made = []
    for i in range(1, len(rates) - 1):
        if sizes[i - 1] < sizes[i] >= sizes[i + 1]:
            at = _golden(lambda rate: float(abs(of.curve([rate], a, b)[0])), float(rates[i - 1]), float(rates[i + 1]))
            value = complex(of.curve([at], a, b)[0])
            made.append(Peak(at / (2.0 * math.pi), abs(value) * force, abs(value), _lag(value)))
    return tuple(made)


def _golden(function: "Any", low: float, high: float) -> float:
    """The place of a maximum by golden section; a flat top hardly changes its height."""
    one, other = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    f, g = function(one), function(other)
    while high - low > 1e-7 * high:
        if f > g:
            high, other, g = other, one, f
            one = high - GOLDEN * (high - low)
            f = function(one)
        else:
            low, one, f = one, other, g
            other = low + GOLDEN * (high - low)
            g = function(other)
    return 0.5 * (low + high)
