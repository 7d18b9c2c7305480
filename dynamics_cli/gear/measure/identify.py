"""An unknown gear from measurements: module or pitch, pressure angle and profile shift."""

from math import pi

from dynamics_cli.errors import require, worded
from dynamics_cli.gear.pitch import SERIES_I, SERIES_II
from dynamics_cli.gear.single.toothing import Toothing
from dynamics_cli.numerics.elementary import absolute, cos, maximum, minimum, pi_beside, sin, sqrt
from dynamics_cli.numerics.number import like, plain
from dynamics_cli.quantities import Angle, Annotated, Coordinate, Count, Module, Ratio, Size, Text
from dynamics_cli.records import Advice, Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import TypeAlias

    # deviation, name, module as a fraction, and pressure angle in degrees
    Found: TypeAlias = "tuple[float, str, tuple[int, int], float]"

PRESSURE_ANGLES = (20.0, 14.5, 15.0, 17.5, 22.5, 25.0, 30.0)
SMALL_MODULES = (0.1, 0.12, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8, 0.9)
DIAMETRAL_PITCHES = (
    1, 1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3, 3.5, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30,
    32, 36, 40, 44, 48, 56, 64, 72, 80, 96, 120,
)  # fmt: skip
COMMON_SHIFT = 1.0
# Teeth are cut thinner for backlash by up to so much of a profile shift: the tip diameter does not follow.
THINNED = 0.06
# A tip diameter is so many modules, twice, from that of a gear without profile shift where the gear is one.
UNSHIFTED = 0.03
# How many of the gears that fit a warning names.
NAMED = 4


@record
class SpanRead:
    """A span that was measured."""

    over: Annotated[Count, "Number of teeth spanned, e.g. 4."]
    length: Annotated[Size, "What was read [m]."]


@record
class Candidate:
    """A gear that agrees with the measurements."""

    size: Annotated[Text, "Its module or diametral pitch, as in an order."]
    module: Annotated[Module, "Normal module [m]."]
    pressure_angle: Annotated[Angle | None, "Normal pressure angle, which takes a span [rad]."]
    profile_shift: Annotated[Ratio, "Profile shift factor, from the spans; without any, from the tip diameter."]
    addendum_factor: Annotated[Ratio | None, "Addendum factor that the tip diameter implies."]
    base_pitch_error: Annotated[Coordinate | None, "Normal base pitch, measured less nominal [m]."]
    disagreement: Annotated[
        Ratio, "Deviation of all readings, in units of the accuracy of measurement; below 1 the gear fits."
    ]


@record
class Identified:
    """Gears that fit, best first."""

    candidates: Annotated[tuple[Candidate, ...], "The gears."]
    base_pitch: Annotated[Size | None, "Normal base pitch that was measured [m]."]
    fitting: Annotated[Count, "Number of standard gears that fit within the accuracy of measurement."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def identify(
    *,
    teeth: Annotated[Count, "Number of teeth, counted, e.g. 24."],
    spans: Annotated[tuple[SpanRead, ...], "Spans over different numbers of teeth; two give the base pitch."] = (),
    tip_diameter: Annotated[Size | None, "Tip diameter, e.g. 80 mm [m]."] = None,
    helix_angle: Annotated[Angle, "Helix angle, measured at the pitch cylinder [rad]."] = 0.0,
    reading: Annotated[Size, "Accuracy of a reading [m]."] = 2e-5,
    count: Annotated[Count, "Number of candidates to show."] = 5,
) -> Identified:
    """Name an unknown gear from its teeth, spans and tip diameter.

    Equation
    --------
    p_bn = (W_k − W_j)/(k − j) = π m_n cos α_n; then x from W_k, and h_a* = (d_a − d)/(2 m_n) − x.
    From the tip diameter alone: x = (d_a − d)/(2 m_n) − 1.

    Returns
    -------
    Identified
        Standard modules and diametral pitches with common pressure angles, best agreement first.

    Raises
    ------
    InadmissibleError
        When spans contradict one another, or are too few to identify the gear.

    Notes
    -----
    A span grows by one base pitch a tooth for any shift, so that it gives only m cos α. The tip diameter and common
    practice separate module and pressure angle: a shift beyond ±1 and an addendum other than 1 or 0.8 count against a
    candidate. Teeth may be thinner than the tip diameter tells, for backlash, by 0.06 of a shift.

    References
    ----------
    KHK Gear Technical Reference (identifying an unknown gear); ISO 54.

    Examples
    --------
    >>> reads = (SpanRead(4, 0.0328266), SpanRead(3, 0.0239703))
    >>> identify(teeth=24, spans=reads, tip_diameter=0.0804).candidates[0].size
    'module 3'
    """
    require(teeth >= 3, "a gear needs at least 3 teeth, not {teeth}", teeth=teeth, code="teeth")
    require(count > 0, "the number of candidates to show is zero", code="count")
    require(reading > 0.0, "the accuracy of a reading must be above zero", code="reading", hint='--reading "0.02 mm"')
    if not spans:
        require(
            tip_diameter is not None,
            "neither a span nor the tip diameter is given",
            code="spans",
            hint='--span-read "over=4, length=32.83 mm", or --tip-diameter "80.4 mm"',
        )
        assert tip_diameter is not None
        return _from_tip(teeth, tip_diameter, helix_angle, reading, count)
    require(len({item.over for item in spans}) == len(spans), "two spans over the same number of teeth", code="spans")
    for item in spans:
        require(
            item.over >= 1 and item.length > 0.0,
            "a span needs at least one tooth and a length above zero, not {over} teeth and {length:6}",
            over=item.over,
            length=(item.length, Size),
            code="spans",
        )
    require(
        len(spans) > 1 or tip_diameter is not None,
        "one span alone fits too many gears",
        code="spans",
        hint="give a second span over one tooth more, or the tip diameter",
    )
    readings = _Readings(teeth, spans, tip_diameter, helix_angle, reading)
    names = _chosen(readings.plain())
    require(
        bool(names),
        "no standard gear of {teeth} teeth has a base pitch near {base_pitch:6}",
        teeth=teeth,
        base_pitch=(plain(readings.pitch or 0.0), Size),
        code="no-candidate",
    )
    fitting = sum(off <= 1.0 for off, _, _, _ in names)
    candidates = tuple(_candidate(readings, name, size, degrees) for _, name, size, degrees in names[:count])
    return Identified(
        candidates=candidates,
        base_pitch=readings.pitch,
        fitting=fitting,
        checks=_checks(readings, candidates[0]),
        advice=_advice(names[:fitting], tip_diameter),
    )


def _from_tip(teeth: int, tip_diameter: float, helix_angle: float, reading: float, count: int) -> Identified:
    """The gears of full depth that have this tip diameter, those of the least shift first."""
    candidates = []
    for size, top, bottom in _sizes():
        module = like(float(top), tip_diameter) / float(bottom)
        shift = 0.5 * (tip_diameter / module - teeth / cos(helix_angle)) - 1.0
        disagreement = absolute(shift) / (0.5 * reading / module + UNSHIFTED)
        if absolute(plain(shift)) <= COMMON_SHIFT:
            candidates.append(Candidate(size, module, None, shift, like(1.0, shift), None, disagreement))
    require(
        bool(candidates),
        "no standard gear of {teeth} teeth has a tip diameter of {tip_diameter:6}",
        teeth=teeth,
        tip_diameter=(plain(tip_diameter), Size),
        code="no-candidate",
        hint="count the teeth again; its teeth are perhaps helical: --helix-angle",
    )
    candidates.sort(key=lambda candidate: plain(candidate.disagreement))
    fitting = sum(plain(candidate.disagreement) <= 1.0 for candidate in candidates)
    text = "the pressure angle and a profile shift take a span beside the tip diameter"
    if not fitting:
        text = "no standard gear without profile shift has this tip diameter: the nearest are shown"
    remedy = 'measure a span: --span-read "over=4, length=32.83 mm"'
    advice = (Advice("tip-alone", text, "note" if fitting else "caution", remedy),)
    return Identified(tuple(candidates[:count]), None, fitting, advice=advice)


def _base_pitch(spans: tuple[SpanRead, ...], reading: float) -> tuple[float | None, float]:
    """The base pitch from the spans farthest apart, and its uncertainty; refuses spans that contradict it."""
    if len(spans) == 1:
        return None, 0.0
    ordered = sorted(spans, key=lambda item: item.over)
    steps = ordered[-1].over - ordered[0].over
    pitch = (ordered[-1].length - ordered[0].length) / steps
    require(
        pitch > 0.0,
        "the spans grow shorter with more teeth: {pitch:6} for each tooth",
        pitch=(pitch, Size),
        code="spans",
    )
    for item in ordered[1:-1]:
        off = item.length - ordered[0].length - (item.over - ordered[0].over) * pitch
        require(
            absolute(off) <= 3.0 * reading,
            "the span over {over} teeth is {off:6} off the line of the others",
            over=item.over,
            off=(off, Size),
            code="spans",
            hint="an anvil was off the flank, or the teeth were miscounted: measure again",
        )
    return pitch, 2.0 * reading / steps


def _sizes() -> "Iterator[tuple[str, int, int]]":
    """Name, and the module in metres as a fraction."""
    for module in (*SMALL_MODULES, *SERIES_I, *SERIES_II):
        # none has more than three decimals of a millimetre
        yield f"module {module:g}", round(1000 * module), 1_000_000
    for diametral in DIAMETRAL_PITCHES:
        yield f"{diametral:g} DP", 2540, round(100_000 * diametral)


class _Readings:
    """Readings of the gear and their uncertainty."""

    def __init__(
        self, teeth: int, spans: tuple[SpanRead, ...], tip_diameter: float | None, helix_angle: float, reading: float
    ) -> None:
        self.teeth = teeth
        self.spans = spans
        self.tip_diameter = tip_diameter
        self.helix_angle = helix_angle
        self.reading = reading
        self.pitch, self.room = _base_pitch(spans, reading)

    def plain(self) -> "_Readings":
        """The same in plain doubles."""
        spans = tuple(SpanRead(reading.over, plain(reading.length)) for reading in self.spans)
        tip = None if self.tip_diameter is None else plain(self.tip_diameter)
        return _Readings(self.teeth, spans, tip, plain(self.helix_angle), plain(self.reading))

    def mean(self) -> float:
        """The mean of the spans."""
        return sum(reading.length for reading in self.spans) / len(self.spans)

    def bare(self, angle: float) -> float:
        """The same mean of a gear of module one without shift: m times this, and 2 x m sin α more, is a span."""
        from dynamics_cli.gear.measure.sizes import span_length

        unit = Toothing(self.teeth, False, like(1.0, angle), angle, self.helix_angle, 0.0, 1.0, 1.0)
        return sum(span_length(unit, reading.over) for reading in self.spans) / len(self.spans)


def _chosen(read: _Readings) -> "list[Found]":
    """Candidates, best first."""
    candidates_fitting = []
    mean, sizes = read.mean(), tuple(_sizes())
    for degrees in PRESSURE_ANGLES:
        angle = degrees * pi / 180.0
        unit_span = read.bare(angle)
        for name, *size in sizes:
            module = size[0] / size[1]
            error = None if read.pitch is None else read.pitch - pi * module * cos(angle)
            if error is not None and abs(error) > 6.0 * read.room:
                continue
            shift = (mean / module - unit_span) / (2.0 * sin(angle))
            if abs(shift) > 2.5:
                continue
            off, _ = _disagreement(read, module, angle, degrees, shift, error)
            if off < 1e4:
                candidates_fitting.append((sqrt(off), name, (size[0], size[1]), degrees))
    # among equal ones the size listed first
    order = {name: place for place, (name, *_) in enumerate(sizes)}
    return sorted(candidates_fitting, key=lambda row: (row[0], order[row[1]], PRESSURE_ANGLES.index(row[3])))


def _candidate(read: _Readings, name: str, size: tuple[int, int], degrees: float) -> Candidate:
    """A candidate in the numbers of the readings; its standard size and angle are rounded doubles too."""
    mean = read.mean()
    module = like(float(size[0]), mean) / float(size[1])
    angle = like(degrees, mean) * pi_beside(mean) / 180.0
    error = None if read.pitch is None else read.pitch - pi_beside(mean) * module * cos(angle)
    shift = (mean / module - read.bare(angle)) / (2.0 * sin(angle))
    off, addendum = _disagreement(read, module, angle, degrees, shift, error)
    return Candidate(name, module, angle, shift, addendum, error, sqrt(off))


def _disagreement(
    read: _Readings, module: float, angle: float, degrees: float, shift: float, error: float | None
) -> tuple[float, float | None]:
    """The squared deviation of a candidate, and its addendum."""
    off = 0.0 if error is None else error * error / (read.room * read.room)
    beyond = maximum(absolute(shift) - COMMON_SHIFT, 0.0)
    off = off + 0.2 * shift * shift + 25.0 * beyond * beyond
    addendum = None
    if read.tip_diameter is not None:
        addendum = 0.5 * read.tip_diameter / module - 0.5 * read.teeth / cos(read.helix_angle) - shift
        uncertainty = 3.0 * read.reading / module / (2.0 * sin(angle)) + 0.02
        # full depth, or 4/5 for stub teeth
        full, stub = (_off(addendum - depth) / uncertainty for depth in (1.0, like(4.0, shift) / 5.0))
        off = off + minimum(full * full, stub * stub + 0.25)
    # unusual values get a small penalty
    return off + (0.0 if degrees == 20.0 else 0.05 if degrees in (14.5, 25.0) else 0.2), addendum


def _off(addendum: float) -> float:
    """How far an addendum is from what it should be, where teeth may have been cut thinner for backlash."""
    return maximum(addendum - THINNED, 0.0) + minimum(addendum, 0.0)


def _checks(read: _Readings, best: Candidate) -> tuple[Check, ...]:
    """The spans of the best candidate against the readings."""
    from dynamics_cli.gear.measure.sizes import span_length

    assert best.pressure_angle is not None
    gear = Toothing(
        read.teeth,
        False,
        best.module,
        best.pressure_angle,
        plain(read.helix_angle),
        plain(best.profile_shift),
        1.0,
        1.0,
    )
    worst = max(abs(span_length(gear, reading.over) - plain(reading.length)) for reading in read.spans)
    tolerance = 6.0 * plain(read.reading)
    return (Check("spans of the best candidate against the readings [m]", worst <= tolerance, worst, tolerance),)


def _advice(fitting: "list[Found]", tip_diameter: float | None) -> tuple[Advice, ...]:
    if len(fitting) == 1:
        return ()
    if not fitting:
        text = "no standard gear fits within the accuracy of the readings: the nearest are shown"
        return (Advice("no-fit", text, "serious"),)
    named = ", ".join(f"{name} of {degrees:g}°" for _, name, _, degrees in fitting[:NAMED])
    message = worded(
        "{fitting} standard gears fit these readings: {named}",
        fitting=len(fitting),
        named=named + ", …" * (len(fitting) > NAMED),
    )
    remedy = "measure more accurately" if tip_diameter is not None else "give the tip diameter"
    return (Advice("several-fit", message, remedy=remedy),)
