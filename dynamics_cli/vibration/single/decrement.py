"""Damping from measurements: peaks of a decay, a record of it, or the half-power frequencies of a resonance."""

from itertools import pairwise

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import atan, exp, log, pi_beside, sin, sqrt, total
from dynamics_cli.numerics.fitting.records_file import read_record
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import Annotated, Count, DampingRatio, Frequency, InputFile, Positive, Ratio
from dynamics_cli.records import Advice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Deviations of log peaks from their line beyond this share of the decay say that it is no viscous one.
CURVED = 0.1
# Peaks below this share of the largest are scatter.
CLEAR = 0.02
# A decay begins with the first peak above this share of the largest.
STRONG = 0.2
# Peaks follow in periods that differ by less; those of noise do not.
UNEVEN = 0.25
# A swing, from turn to turn, below this share of both beside it is none.
RIPPLE = 0.25
FEWEST_IN_A_RECORD = 3


@record
class Peaks:
    """Peaks on one side, read one after another."""

    peaks: Annotated[tuple[Positive, ...], "Sizes of the peaks in one unit, without it, e.g. 12.1, 9.8, 7.9."]
    every: Annotated[Count, "Cycles from each peak to the next that is given."] = 1


@record
class HalfPower:
    """The frequencies at which a resonance is down to 1/√2 of its peak."""

    lower_frequency: Annotated[Frequency, "Below the peak, where the amplitude is 1/√2 of it, e.g. 9.52 Hz."]
    upper_frequency: Annotated[Frequency, "Above the peak, where the amplitude is 1/√2 of it, e.g. 10.5 Hz."]


@record
class Recorded:
    """A record of the decay."""

    file: Annotated[InputFile, "CSV with t[s] and the signal of a decay; its peaks are searched."]


@record
class Decrement:
    """Damping as measured."""

    damping_ratio: Annotated[DampingRatio, "Damping over critical damping ζ [-]."]
    deviation: Annotated[DampingRatio | None, "Its standard deviation, from the scatter of the peaks [-]."]
    decrement: Annotated[Ratio, "Logarithmic decrement of one cycle δ [-]."]
    quality: Annotated[Ratio, "Quality factor Q = 1/2ζ [-]."]
    peak_ratio: Annotated[Ratio, "One peak over the one a cycle before [-]."]
    scatter: Annotated[Ratio | None, "Root mean square of ln peak beside its line [-]."]
    natural_frequency: Annotated[Frequency | None, "Undamped natural frequency, of a record or a resonance [Hz]."]
    peaks_used: Annotated[Count | None, "Number of peaks [-]."]
    advice: tuple[Advice, ...] = ()


def decrement(*, measured: Annotated[Peaks | HalfPower | Recorded, "What was measured."]) -> Decrement:
    """Damping ratio from peaks of a decay by least squares on their logarithms, or from half-power frequencies.

    Equation
    --------
    ln xᵢ = a − δ·i, ζ = δ/√(4π² + δ²); half power: tan 2θ = (f₂² − f₁²)/(f₂² + f₁²), ζ = sin θ.

    Returns
    -------
    Decrement
        Damping ratio with its standard deviation, decrement, quality factor.

    Raises
    ------
    InadmissibleError
        When peaks rise (the damping would be negative), there are fewer than two, or frequencies are not in order.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 13.5.

    Examples
    --------
    >>> round(decrement(measured=Peaks((1.0, 0.5))).damping_ratio, 9)
    0.109652581
    """
    if isinstance(measured, HalfPower):
        return _half_power(measured.lower_frequency, measured.upper_frequency)
    if isinstance(measured, Recorded):
        times, sizes = peaks_of(measured.file)
        return _of_peaks(sizes, 1, (len(times) - 1) / (times[-1] - times[0]))
    require(measured.every > 0, "peaks cannot be 0 cycles apart", code="every", hint="--every 1")
    return _of_peaks(measured.peaks, measured.every, None)


def _of_peaks(peaks: "tuple[Any, ...]", every: int, frequency: "float | None") -> Decrement:
    count = len(peaks)
    require(count >= 2, "one peak says nothing of a decay", code="too-few", hint="give --peaks 12.1,9.8,7.9")
    logs = [log(peak) for peak in peaks]
    middle = 0.5 * float(count - 1)
    below = sum((i - middle) ** 2 for i in range(count))
    step = total((middle - float(i)) * one for i, one in enumerate(logs)) / below
    require(
        step >= 0.0,
        "the peaks rise, from {first} to {last}: that is no decay",
        first=(peaks[0], Ratio),
        last=(peaks[-1], Ratio),
        code="rising",
        hint="list them as they follow in time; a motion that grows by itself has negative damping",
    )
    delta = step / float(every)
    turn = 2.0 * pi_beside(delta)
    root = sqrt(turn * turn + delta * delta)
    zeta = delta / root
    deviation = scatter = None
    if count > 2:
        mean = total(logs) / float(count)
        rest = total(_square(one - mean + (float(i) - middle) * step) for i, one in enumerate(logs))
        scatter = sqrt(rest / float(count))
        # dζ/dδ = 4π²/(4π² + δ²)^{3/2}
        deviation = sqrt(rest / (float(count - 2) * below)) / float(every) * turn * turn / (root * root * root)
    return Decrement(
        damping_ratio=zeta,
        deviation=deviation,
        decrement=delta,
        quality=0.5 / zeta if step > 0.0 else None,  # type: ignore[arg-type]
        peak_ratio=exp(0.0 - delta),
        scatter=scatter,
        natural_frequency=None if frequency is None else frequency * root / turn,
        peaks_used=count,
        advice=_advice(peaks, scatter, step, count),
    )


def _square(x: "Any") -> "Any":
    return x * x


def _half_power(lower: "Any", upper: "Any") -> Decrement:
    require(lower > 0.0, "the lower frequency is zero", code="half-power", hint="it lies just below the peak")
    require(
        upper > lower,
        "the upper frequency of {upper} does not lie above the lower one of {lower}",
        upper=(upper, Frequency),
        lower=(lower, Frequency),
        code="half-power",
    )
    share = (upper - lower) * (upper + lower) / (upper * upper + lower * lower)
    zeta = sin(0.5 * atan(share))
    room = (1.0 - zeta) * (1.0 + zeta)
    delta = 2.0 * pi_beside(zeta) * zeta / sqrt(room)
    middle = 0.5 * (upper * upper + lower * lower)
    return Decrement(
        damping_ratio=zeta, deviation=None, decrement=delta, quality=0.5 / zeta, peak_ratio=exp(0.0 - delta),
        scatter=None, natural_frequency=sqrt(middle / (1.0 - 2.0 * zeta * zeta)), peaks_used=None,
    )  # fmt: skip


def peaks_of(file: str) -> "tuple[list[float], tuple[float, ...]]":
    """Times and heights of the maxima above the place of rest, by parabolas through three samples."""
    times, values, _ = read_record(file)
    tail = values[-max(len(values) // 10, 3) :]
    rest = _place_of_rest(_turns(times, values, sum(tail) / len(tail)), sum(tail) / len(tail))
    highs = [(at, value - rest) for at, value, side in _turns(times, values, rest) if side > 0.0]
    decay = _without_noise(highs)
    require(
        len(decay) >= FEWEST_IN_A_RECORD,
        "clear peaks in the record: {count}; a decay needs at least {least}",
        count=str(len(decay)),
        least=str(FEWEST_IN_A_RECORD),
        code="few-peaks",
    )
    return [at for at, _ in decay], tuple(size for _, size in decay)


def _without_noise(highs: "list[tuple[float, float]]") -> "list[tuple[float, float]]":
    """The peaks of the decay, without those before it begins and after it has sunk into the noise."""
    largest = max((size for _, size in highs), default=0.0)
    strong = [nth for nth, (_, size) in enumerate(highs) if size > STRONG * largest]
    if not strong:
        return []
    peaks = highs[strong[0] :]
    periods = [after - before for (before, _), (after, _) in pairwise(peaks)]
    early = sorted(periods[: max(strong[-1] - strong[0], 1)])
    usual = early[len(early) // 2] if early else 0.0
    last = next(
        (nth for nth, (period, (_, size)) in enumerate(zip(periods, peaks[1:], strict=True), 1)
         if size <= CLEAR * largest or abs(period - usual) > UNEVEN * usual), len(peaks),
    )  # fmt: skip
    return peaks[:last]


def _turns(times: "list[float]", values: "list[float]", rest: float) -> "list[tuple[float, float, float]]":
    """Time, value and side (1 or −1) of the maxima above a place and the minima below it."""
    turns = []
    for i in range(1, len(values) - 1):
        side = 1.0 if values[i] > rest else -1.0
        before, here, after = (side * (value - rest) for value in values[i - 1 : i + 2])
        if here > 0.0 and before < here >= after:
            off = 0.5 * (before - after) / (before - 2.0 * here + after)
            at = times[i] + off * 0.5 * (times[i + 1] - times[i - 1])
            turns.append((at, rest + side * (here - 0.25 * (before - after) * off), side))
    return _without_ripples(_one_a_swing(turns, rest))


def _one_a_swing(turns: "list[tuple[float, float, float]]", rest: float) -> "list[tuple[float, float, float]]":
    """Of maxima that follow without a minimum between them, the largest: the others are noise."""
    swings: list[tuple[float, float, float]] = []
    for turn in turns:
        if swings and swings[-1][2] == turn[2]:
            swings[-1] = max(swings[-1], turn, key=lambda one: abs(one[1] - rest))
        else:
            swings.append(turn)
    return swings


def _without_ripples(turns: "list[tuple[float, float, float]]") -> "list[tuple[float, float, float]]":
    """Without swings much smaller than those before and after: noise where the motion passes the place of rest."""
    kept: list[tuple[float, float, float]] = []
    for turn in turns:
        kept.append(turn)
        while len(kept) > 3:
            before, swing, after = (abs(high[1] - low[1]) for low, high in pairwise(kept[-4:]))
            if swing >= RIPPLE * min(before, after):
                break
            del kept[-3:-1]
    return kept


def _place_of_rest(turns: "list[tuple[float, float, float]]", tail: float) -> float:
    """Where the motion comes to rest, also of a record that ends before: heights above it fall by one factor.

    Of a maximum, the minimum after it and the next maximum, or the other way round: (a − r)·(c − r) = (b − r)².
    """
    largest = max((abs(value - tail) for _, value, _ in turns), default=0.0)
    places = [
        b + (a - b) * (c - b) / ((a - b) + (c - b))
        for (_, a, one), (_, b, other), (_, c, _) in zip(turns, turns[1:], turns[2:], strict=False)
        if one != other and abs(b - tail) > CLEAR * largest and (a - b) * (c - b) > 0.0
    ]
    return sorted(places)[len(places) // 2] if places else tail


def _advice(peaks: "tuple[Any, ...]", scatter: "Any", step: "Any", count: int) -> "tuple[Advice, ...]":
    if not single(step, peaks[0]):
        return ()
    notes = []
    if plain(step) == 0.0:
        text = "the peaks do not fall: no damping is measured"
        notes.append(Advice("no-decay", text, result="quality"))
    if scatter is not None and plain(scatter) > CURVED * plain(step) * float(count - 1):
        drops = [plain(one) - plain(other) for one, other in pairwise(peaks)]
        steady = max(drops) - min(drops) < 0.25 * max(map(abs, drops))
        text = "the logarithms of the peaks leave a straight line by {scatter:2}: the damping is not viscous"
        remedy = "peaks that fall by equal amounts are dry friction" if steady else "use peaks of similar size"
        notes.append(Advice("not-viscous", worded(text, scatter=(scatter, Ratio)), remedy=remedy))
    return tuple(notes)
