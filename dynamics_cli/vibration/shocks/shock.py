"""Shock response spectra of pulses and records: largest response of oscillators over their natural frequency."""

import math

from dynamics_cli.errors import require
from dynamics_cli.numerics.fitting.records_file import ACCELERATIONS, read_load
from dynamics_cli.quantities import (
    Acceleration,
    Annotated,
    Count,
    DampingRatio,
    Frequency,
    InputFile,
    Ratio,
    Size,
    Time,
    VibrationSpeed,
)
from dynamics_cli.records import Advice, Columns, Numerics, record
from dynamics_cli.sampling import cost, drawing, kept
from dynamics_cli.vibration.shocks.pulses import Shape
from dynamics_cli.vibration.single.oscillator import require_damping

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_POINTS = 2000
# Of samples of uncertain inputs: under which name the worst frequency of the first is kept, and the seconds of each.
WORST, COST = "worst frequency of a shock", 4e-3
# A record at rest has no more than this of its peak at its ends.
LEFT = 0.05


@record
class Pulse:
    """A pulse of the base's acceleration."""

    shape: Annotated[
        Shape,
        "rectangle, half-sine, triangle, versed-sine, sawtooth (terminal peak) or trapezoid (a tenth up and down).",
    ]
    base_acceleration: Annotated[Acceleration, "Height of the pulse, e.g. 30 g."]
    duration: Annotated[Time, "Duration of the pulse, e.g. 11 ms."]


@record
class Recorded:
    """A recorded acceleration."""

    file: Annotated[InputFile, "CSV with t[s] and a[g] (or m/s^2, ft/s^2) of the base."]


@record
class SpectrumPoint:
    """What one oscillator does."""

    frequency: Annotated[Frequency, "Natural frequency of the oscillator [Hz]."]
    maximax: Annotated[Acceleration, "Absolute acceleration, largest in size at any time [m/s^2]."]
    positive: Annotated[Acceleration, "Largest in the sense of the pulse [m/s^2]."]
    negative: Annotated[Acceleration, "Largest against it [m/s^2]."]
    primary: Annotated[Acceleration, "Largest in size during the pulse [m/s^2]."]
    residual: Annotated[Acceleration, "Largest in size after it [m/s^2]."]
    displacement: Annotated[Size, "Largest displacement against the base [m]."]
    pseudo_velocity: Annotated[VibrationSpeed, "ω times that [m/s]."]


@record
class ShockSpectrum:
    """A shock response spectrum."""

    worst: Annotated[Acceleration, "Largest of the spectrum [m/s^2]."]
    worst_frequency: Annotated[Frequency, "At this natural frequency [Hz]."]
    factor: Annotated[Ratio, "That over the peak of the input [-]."]
    peak_input: Annotated[Acceleration, "Largest acceleration of the base [m/s^2]."]
    velocity_change: Annotated[VibrationSpeed, "Change of velocity of the base [m/s]."]
    quality: Annotated[Ratio | None, "Quality factor Q = 1/2ζ [-]."]
    spectrum: Annotated[Columns[SpectrumPoint], "The spectrum."]
    numerics: Numerics | None = None
    advice: tuple[Advice, ...] = ()


def shock(
    *,
    input_: Annotated[Pulse | Recorded, "How the base moves."],
    damping_ratio: Annotated[DampingRatio, "Damping ratio of the oscillators; 0.05 is Q = 10, e.g. 0.05."] = 0.05,
    lowest: Annotated[Frequency, "Lowest natural frequency, e.g. 10 Hz."] = 10.0,
    highest: Annotated[Frequency, "Highest natural frequency, e.g. 2000 Hz."] = 2000.0,
    per_octave: Annotated[Count, "Oscillators in an octave."] = 12,
) -> ShockSpectrum:
    """Shock response spectrum of a pulse or a recorded acceleration, extremes found between samples.

    Equation
    --------
    z̈ + 2ζω·ż + ω²·z = −a(t), absolute acceleration −(2ζω·ż + ω²·z); primary: during the pulse; residual: after it;
    maximax: the larger.

    Returns
    -------
    ShockSpectrum
        The spectrum with both signs, primary and residual, displacement and pseudo-velocity; its largest value.

    Raises
    ------
    InadmissibleError
        When the damping ratio is negative or one and above, frequencies are not in order, or the file is no record.

    References
    ----------
    Biot, Trans. ASCE 108 (1943) 365; ISO 18431-4 (definitions).

    Examples
    --------
    >>> made = shock(input_=Pulse(Shape("half-sine"), 1.0, 0.011), lowest=100.0, highest=200.0, per_octave=1)
    >>> round(float(made.spectrum.arrays["maximax"][0]), 8)
    1.59139571
    """
    import numpy as np

    from dynamics_cli.vibration.shocks.pulses import Oscillators

    require_damping(damping_ratio, DampingRatio)
    require(
        damping_ratio < 1.0, "a shock spectrum is of oscillators that swing: a damping ratio below 1",
        code="overdamped", hint="0.05 is usual",
    )  # fmt: skip
    require(lowest > 0.0, "the lowest frequency is zero", code="frequencies")
    require(
        highest > lowest,
        "the highest frequency of {highest} does not lie above the lowest of {lowest}",
        highest=(highest, Frequency),
        lowest=(lowest, Frequency),
        code="frequencies",
    )
    require(per_octave > 0, "no oscillator in an octave", code="frequencies", hint="--per-octave 12")
    count = math.floor(per_octave * math.log2(highest / lowest) + 1e-9) + 1
    require(count <= MOST_POINTS, "{count} oscillators are too many", count=str(count), code="frequencies")
    hertz = lowest * 2.0 ** (np.arange(count) / per_octave)
    if hertz[-1] < highest * (1.0 - 1e-9):
        hertz = np.append(hertz, highest)
    if drawing():
        hertz = _about_worst(hertz, damping_ratio, input_)
    of = Oscillators(2.0 * math.pi * hertz, damping_ratio)
    during, after, moved, source = _extremes(of, input_)
    high, low = np.maximum(during.high, after.high), np.minimum(during.low, after.low)
    maximax = np.maximum(high, -low)
    away = np.maximum(moved.high, -moved.low)
    worst = int(maximax.argmax())
    return ShockSpectrum(
        worst=float(maximax[worst]),
        worst_frequency=float(hertz[worst]),
        factor=float(maximax[worst]) / source.peak,
        peak_input=source.peak,
        velocity_change=source.change,
        quality=0.5 / damping_ratio if damping_ratio else None,
        spectrum=Columns(
            SpectrumPoint, frequency=hertz, maximax=maximax, positive=high, negative=low,
            primary=np.maximum(during.high, -during.low), residual=np.maximum(after.high, -after.low),
            displacement=away, pseudo_velocity=of.omega * away,
        ),
        numerics=Numerics("closed form on each piece, extremes by Newton's method between samples"),
        advice=source.advice,
    )  # fmt: skip


def _about_worst(hertz: "Any", damping_ratio: float, input_: "Pulse | Recorded") -> "Any":
    """Of a sample of uncertain inputs, the frequencies within an octave of the worst of the first one."""
    import numpy as np

    from dynamics_cli.vibration.shocks.pulses import Oscillators

    cost(0.0, COST, 1)
    if WORST not in kept():
        during, after, _, _ = _extremes(Oscillators(2.0 * math.pi * hertz, damping_ratio), input_)
        sizes = np.maximum(np.maximum(during.high, after.high), -np.minimum(during.low, after.low))
        kept()[WORST] = float(hertz[sizes.argmax()])
    return hertz[abs(np.log2(hertz / kept()[WORST])) <= 1.0]


class _Source:
    """Peak, change of velocity, and what is odd about the input."""

    def __init__(self, peak: float, change: float, advice: "tuple[Advice, ...]" = ()) -> None:
        self.peak, self.change, self.advice = peak, change, advice


# Mean height of each pulse.
AREAS = {"rectangle": 1.0, "half-sine": 2.0 / math.pi, "triangle": 0.5, "versed-sine": 0.5, "sawtooth": 0.5,
         "trapezoid": 0.9}  # fmt: skip


def _extremes(of: "Any", input_: "Pulse | Recorded") -> "tuple[Any, Any, Any, _Source]":
    """Absolute acceleration during and after the input, displacement at any time."""
    import numpy as np

    from dynamics_cli.vibration.shocks.extremes import Extremes, over_piece, over_record, over_rest
    from dynamics_cli.vibration.shocks.pulses import pieces

    count = len(of.omega)
    during, after, moved = Extremes(count), Extremes(count), Extremes(count)
    mixes = ((-of.omega * of.omega, -2.0 * of.sigma), (np.ones(count), np.zeros(count)))
    state = (np.zeros(count), np.zeros(count))
    if isinstance(input_, Recorded):
        times, values, _ = read_load(input_.file, ACCELERATIONS)
        source = _of_record(times, values)
        for mix, into in zip(mixes, (during, moved), strict=True):
            state = over_record(of, times, -values, mix, into)
        end = float(times[-1])
    else:
        require(input_.shape in AREAS, "a {shape} has no end: a shock spectrum is of a pulse", shape=str(input_.shape),
                code="no-pulse", hint="for example --shape half-sine; steps: dynamics vibration transient")  # fmt: skip
        require(input_.duration > 0.0, "the duration is zero", code="no-duration")
        size, end = input_.base_acceleration, input_.duration
        require(size != 0.0, "the pulse has no height", code="no-load")
        source = _Source(abs(size), abs(size) * end * AREAS[str(input_.shape)])
        for piece in pieces(str(input_.shape), end)[:-1]:
            piece.a, piece.b, piece.c = -size * piece.a, -size * piece.b, -size * piece.c
            for mix, into in zip(mixes, (during, moved), strict=True):
                over_piece(of, state, piece, piece.end - piece.start, mix, into)
            state = of.after(*state, piece, piece.end - piece.start)
    for mix, into in zip(mixes, (after, moved), strict=True):
        over_rest(of, state, end, mix, into)
    return during, after, moved, source


def _of_record(times: "Any", values: "Any") -> _Source:
    peak = float(abs(values).max())
    require(peak > 0.0, "the record is zero throughout", code="no-load")
    change = float(((values[1:] + values[:-1]) * (times[1:] - times[:-1])).sum() * 0.5)
    notes: tuple[Advice, ...] = ()
    if max(abs(values[0]), abs(values[-1])) > LEFT * peak:
        text = "the record does not begin and end at rest: low frequencies of the spectrum are of its offset"
        notes = (Advice("offset", text, remedy="take the mean before the shock off"),)
    return _Source(peak, abs(change), notes)
