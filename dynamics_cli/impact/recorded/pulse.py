"""A recorded crash pulse: ΔV every 10 ms, its greatest value, its end, and its turn with the car."""

from itertools import pairwise

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import atan2, cos, hypot, sin
from dynamics_cli.numerics.fitting.records_file import interval_of, read_columns
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Angle,
    AngularSpeed,
    Annotated,
    Count,
    Fraction,
    Friction,
    Gravity,
    InputFile,
    RoadSpeed,
    RoadVelocity,
    Time,
)
from dynamics_cli.records import Advice, Numerics, record

TEN_MS = 0.01
# 49 CFR 563.8, table III: resolution of ΔV.
KM_H = 0.2777777777777778
LAST = 0.02
# Columns of a file and their units.
SPEEDS = {"km/h": KM_H, "mph": 0.44704, "m/s": 1.0, "ft/s": 0.3048}
COLUMNS = {
    "longitudinal": SPEEDS, "lateral": SPEEDS, "yaw_rate": {"deg/s": 0.017453292519943295, "rad/s": 1.0},
}  # fmt: skip
# A fraction of an interval that rounding may lose.
SLACK = 1e-9


@record
class PulseTable:
    """A pulse sample by sample."""

    longitudinal: Annotated[
        tuple[RoadVelocity, ...],
        "ΔV along the nose from time zero on, ahead positive, e.g. 0, -2, -7, -15, -21, -22 km/h [m/s].",
    ]
    lateral: Annotated[
        tuple[RoadVelocity, ...], "ΔV across it at the same times, to the left positive, e.g. 0, 0, 1, 2, 3, 3 km/h."
    ] = ()
    yaw_rate: Annotated[
        tuple[AngularSpeed, ...], "Yaw rate at the same times, to the left positive, e.g. 0, 2, 9, 20, 27, 28 deg/s."
    ] = ()
    interval: Annotated[Time, "Time between samples, e.g. 10 ms [s]."] = TEN_MS


@record
class PulseFile:
    """A pulse in a file."""

    file: Annotated[
        InputFile,
        "CSV with time[ms],longitudinal[km/h] and, if recorded, lateral[km/h] and yaw_rate[deg/s], e.g. pulse.csv.",
    ]

    def table(self) -> PulseTable:
        """The same pulse sample by sample."""
        times, columns = read_columns(self.file, COLUMNS)
        require(
            "longitudinal" in columns, "the file has no ΔV along the nose", code="header",
            hint="name it longitudinal[km/h]",
        )  # fmt: skip
        return PulseTable(**{name: tuple(column) for name, column in columns.items()}, interval=interval_of(times))


@record
class PulseRow:
    """One sample of the pulse."""

    time: Annotated[Time, "Time since the record begins [s]."]
    longitudinal: Annotated[RoadVelocity, "ΔV along the nose as recorded [m/s]."]
    lateral: Annotated[RoadVelocity, "ΔV across the nose as recorded [m/s]."]
    acceleration: Annotated[Acceleration, "Mean acceleration since the sample before, its size [m/s^2]."]
    nose: Annotated[Angle, "How far the car has turned since the beginning [rad]."]


@record
class Pulse:
    """Results of a crash pulse."""

    delta_v: Annotated[RoadSpeed, "Greatest change of velocity [m/s]."]
    delta_v_low: Annotated[RoadSpeed, "The same at the lower limit of the tolerance [m/s]."]
    delta_v_high: Annotated[RoadSpeed, "At the upper limit [m/s]."]
    time: Annotated[Time, "When it is reached [s]."]
    delta_v_longitudinal: Annotated[
        RoadVelocity, "Its part along the nose as the record began, the turn of the car taken out [m/s]."
    ]
    delta_v_lateral: Annotated[RoadVelocity, "Its part across that nose, to the left positive [m/s]."]
    duration: Annotated[Time, "From the first to the last interval in which ΔV changes by the resolution [s]."]
    mean_acceleration: Annotated[Acceleration, "Greatest ΔV over the time to it [m/s^2]."]
    greatest_acceleration: Annotated[Acceleration, "Greatest mean over one interval [m/s^2]."]
    final_change: Annotated[RoadSpeed, "How far ΔV still changed over the last 20 ms [m/s]."]
    turned: Annotated[Angle | None, "How far the car turned until then; needs the yaw rate [rad]."]
    direction_shift: Annotated[
        Angle | None, "How far that turn had moved the direction of the recorded ΔV; needs the yaw rate [rad]."
    ]
    tyres: Annotated[RoadSpeed | None, "What tyres can have added meanwhile; needs the friction [m/s]."]
    samples: Annotated[Count, "Number of samples."]
    rows: Annotated[tuple[PulseRow, ...], "Every sample."]
    numerics: Numerics
    advice: tuple[Advice, ...] = ()


def pulse(
    *,
    recorded: Annotated[PulseTable | PulseFile, "The recorded pulse, listed or in a file."],
    tolerance: Annotated[Fraction, "Limits of the recorded ΔV; 49 CFR 563.8 allows 10 %."] = 0.1,
    resolution: Annotated[RoadSpeed, "Resolution of the record [m/s]."] = KM_H,
    friction: Annotated[
        Friction | None, "Friction of the road, for the effect of the tyres during the pulse [-]."
    ] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Pulse:
    """Greatest ΔV of a recorded pulse, whether it had ended, and its direction with the turn of the car taken out.

    Equation
    --------
    ψ(t) = ∫ ω dt, ΔV = Σ R(ψ) dv in the axes of the start, ψ in the middle of each interval; tyres ≤ μgT.

    Returns
    -------
    Pulse
        Greatest ΔV with limits, its time, parts along and across the nose at the beginning, accelerations, its end.

    Raises
    ------
    InadmissibleError
        When there are fewer than two samples, the tables are not of one length, or ΔV stays zero.

    Notes
    -----
    A recorder integrates along axes that turn with the car. The direction of its ΔV is turned by the mean of the car's
    turn weighted by the pulse: never more than the whole turn, and nothing where the car did not turn meanwhile.

    References
    ----------
    49 CFR 563.7 and 563.8, tables I and III: ΔV at 10 ms, resolution 1 km/h, within 10 %.

    Examples
    --------
    >>> result = pulse(recorded=PulseTable((0.0, -0.5, -2.0, -4.5, -6.0, -6.2, -6.2, -6.2)))
    >>> round(result.delta_v, 6), round(result.time, 6), round(result.greatest_acceleration, 6)
    (6.2, 0.05, 250.0)
    """
    table = recorded.table() if isinstance(recorded, PulseFile) else recorded
    longitudinal, lateral, yaw_rate, interval = table.longitudinal, table.lateral, table.yaw_rate, table.interval
    count = len(longitudinal)
    require(count >= 2, "a pulse of {count} samples has no interval", count=count, code="too-few")
    for name, column in (("lateral", lateral), ("yaw rate", yaw_rate)):
        require(
            not column or len(column) == count,
            "{name} has {has} samples, longitudinal {count}", name=name, has=len(column), count=count, code="lengths",
        )  # fmt: skip
    require(interval > 0.0, "samples must be some time apart", code="no-time")
    require(tolerance < 1.0, "a tolerance of 100 % or more: the record contains no information", code="tolerance")
    across = lateral or (0.0,) * count
    sizes = [hypot(x, y) for x, y in zip(longitudinal, across, strict=True)]
    top = max(range(count), key=sizes.__getitem__)
    require(sizes[top] > 0.0, "the recorded change of velocity stays zero: no impact", code="no-impact")
    noses = [0.0]
    for before, after in pairwise(yaw_rate or (0.0,) * count):
        noses.append(noses[-1] + 0.5 * interval * (before + after))
    x, y = _at_the_start(longitudinal, across, noses, top)
    changes = [hypot(longitudinal[i + 1] - longitudinal[i], across[i + 1] - across[i]) for i in range(count - 1)]
    moving = [i for i, change in enumerate(changes) if change >= resolution * (1.0 - SLACK)] or [0]
    back = max(count - 1 - max(round(LAST / interval), 1), 0)
    final = hypot(longitudinal[-1] - longitudinal[back], across[-1] - across[back])
    time = top * interval
    sense = longitudinal[top] * y - across[top] * x
    return Pulse(
        delta_v=sizes[top],
        delta_v_low=(1.0 - tolerance) * sizes[top],
        delta_v_high=(1.0 + tolerance) * sizes[top],
        time=time,
        delta_v_longitudinal=x,
        delta_v_lateral=y,
        duration=(moving[-1] + 1 - moving[0]) * interval,
        mean_acceleration=sizes[top] / time if top else 0.0,
        greatest_acceleration=max(changes) / interval,
        final_change=final,
        turned=noses[top] if yaw_rate else None,
        direction_shift=atan2(sense, longitudinal[top] * x + across[top] * y) if yaw_rate else None,
        tyres=None if friction is None else friction * gravity * (moving[-1] + 1 - moving[0]) * interval,
        samples=count,
        rows=tuple(
            PulseRow(i * interval, longitudinal[i], across[i], changes[i - 1] / interval if i else 0.0, noses[i])
            for i in range(count)
        ),
        numerics=Numerics("sums over the samples"),
        advice=_advice(final, resolution, bool(yaw_rate), top, count),
    )  # fmt: skip


def _at_the_start(
    along: "tuple[float, ...]", across: "tuple[float, ...]", noses: "list[float]", top: int
) -> "tuple[float, float]":
    """ΔV up to a sample in the axes of the start."""
    # the reading of the sensor at time zero is from before the impact
    x, y = along[0], across[0]
    for index in range(top):
        middle = 0.5 * (noses[index] + noses[index + 1])
        dx, dy = along[index + 1] - along[index], across[index + 1] - across[index]
        x, y = x + cos(middle) * dx - sin(middle) * dy, y + sin(middle) * dx + cos(middle) * dy
    return x, y


def _advice(final: float, resolution: float, turns: bool, top: int, count: int) -> "tuple[Advice, ...]":
    notes: list[Advice] = []
    if final > resolution:
        text = worded(
            "the pulse had not ended: over its last 20 ms ΔV still changed by {final:3}, so ΔV is a lower bound",
            final=(final, RoadSpeed),
        )
        notes.append(
            Advice("lower-bound", text, "serious", "give it as --final-change to impact record, and look for more data")
        )
    elif top == count - 1:
        text = worded("the greatest ΔV is the last sample")
        notes.append(Advice("at-the-end", text, "note", "the pulse may have gone on below the resolution"))
    if not turns:
        text = worded("without yaw rate the axes of the recorder are taken as those of the start")
        remedy = "of a car that turned during the pulse widen PDOF to one side by its turn, or give the yaw rate"
        notes.append(Advice("no-yaw-rate", text, "note", remedy))
    return tuple(notes)
