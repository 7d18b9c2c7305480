"""One mass struck by a step, a ramp, a pulse or a recorded load: displacement over time, peak, overshoot."""

import math

from dynamics_cli.errors import require
from dynamics_cli.numerics.fitting.records_file import read_load
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Acceleration,
    Annotated,
    Coordinate,
    DampingRatio,
    Force,
    Frequency,
    InputFile,
    Mass,
    Ratio,
    SagGravity,
    Size,
    Time,
    VibrationSpeed,
)
from dynamics_cli.records import Columns, Numerics, record
from dynamics_cli.vibration.shocks.pulses import Shape
from dynamics_cli.vibration.single.oscillator import Damper, DampingShare, Natural, Oscillator, Sag, Spring

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.vibration.shocks.pulses import Oscillators, Piece

ROWS = 241
# Periods shown after the load has ended, and the most in all.
AFTER, MOST = 5.0, 60.0


@record
class Push:
    """A force on the mass."""

    force: Annotated[Force, "Height of the force on the mass, e.g. 500 N."]
    shape: Annotated[Shape, "step, ramp, rectangle, half-sine, triangle, versed-sine, sawtooth or trapezoid."]
    duration: Annotated[Time | None, "Duration of the pulse, or rise time of the ramp, e.g. 20 ms."] = None


@record
class Jolt:
    """An acceleration of the base."""

    base_acceleration: Annotated[Acceleration, "Height of the base's acceleration, e.g. 30 g."]
    shape: Annotated[Shape, "step, ramp, rectangle, half-sine, triangle, versed-sine, sawtooth or trapezoid."]
    duration: Annotated[Time | None, "Duration of the pulse, or rise time of the ramp, e.g. 11 ms."] = None


@record
class Recorded:
    """A recorded load."""

    file: Annotated[InputFile, "CSV with t[s] and F[N] (or kN, lbf) on the mass, or a[g] (or m/s^2) of the base."]


@record
class HistoryPoint:
    """The state at a time."""

    time: Annotated[Time, "Time [s]."]
    displacement: Annotated[Coordinate, "Displacement of the mass, against the base where that moves [m]."]
    velocity: Annotated[VibrationSpeed, "Velocity, likewise [m/s]."]
    acceleration: Annotated[Acceleration, "Absolute acceleration of the mass [m/s^2]."]


@record
class Transient:
    """The vibration after a sudden load."""

    peak: Annotated[Size, "Size of the largest displacement, to either side [m]."]
    peak_time: Annotated[Time, "When [s]."]
    rebound: Annotated[Size, "Size of the largest displacement to the other side [m]."]
    static: Annotated[Size, "Displacement if the load came slowly [m]."]
    factor: Annotated[Ratio, "Dynamic factor: peak over that [-]."]
    overshoot: Annotated[Ratio | None, "Peak beyond the new rest position over its distance, after a step or ramp [-]."]
    peak_acceleration: Annotated[
        Acceleration | None, "On a base that moves: size of the largest absolute acceleration of the mass [m/s^2]."
    ]
    ground_force: Annotated[Force | None, "Under a force: largest force to the ground, of spring and damper [N]."]
    natural_frequency: Annotated[Frequency, "Undamped natural frequency f_n [Hz]."]
    damping_ratio: Annotated[DampingRatio, "Damping over critical damping ζ [-]."]
    history: Annotated[Columns[HistoryPoint], "The motion over time."]
    numerics: Numerics | None = None


class Load:
    """The load by unit mass as pieces, or as a record; what it is called; its largest size."""

    def __init__(self, load: "Any", mass: "float | None") -> None:
        from dynamics_cli.vibration.shocks.pulses import pieces

        self.based = isinstance(load, Jolt)
        self.shape = ""
        self.pieces: list[Piece] = []
        if isinstance(load, Recorded):
            self.times, values, self.based = read_load(load.file)
            self.values = values * self._factor(mass)
            self.end = float(self.times[-1])
            self.height = float(abs(self.values).max())
            return
        self.shape = str(load.shape)
        require(
            self.shape == "step" or (load.duration is not None and load.duration > 0.0),
            "a {shape} needs a duration",
            shape=self.shape,
            code="no-duration",
            hint="give --duration, for example 11 ms",
        )
        size = (load.base_acceleration if self.based else load.force) * self._factor(mass)
        self.end = load.duration if self.shape != "step" else 0.0
        self.height = abs(size)
        for piece in pieces(self.shape, self.end):
            piece.a, piece.b, piece.c = piece.a * size, piece.b * size, piece.c * size
            self.pieces.append(piece)

    def _factor(self, mass: "float | None") -> float:
        if self.based:
            return -1.0
        require(mass is not None, "a force needs the mass it acts on", code="no-mass", hint="give --mass")
        return 1.0 / mass  # type: ignore[operator]


def transient(
    *,
    mass: Annotated[Mass | None, "The mass; not needed for a base that moves, beside a natural frequency."] = None,
    spring: Annotated[Spring | Natural | Sag, "The spring."],
    damping: Annotated[Damper | DampingShare | None, "The damping; none when left out."] = None,
    load: Annotated[Push | Jolt | Recorded, "What strikes it."],
    gravity: Annotated[SagGravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Transient:
    """Motion of one mass, at rest before, under a step, a ramp, a pulse or a recorded load: exact between samples.

    Equation
    --------
    z̈ + 2ζω·ż + ω²·z = F/m (or −a of the base), solved in closed form on every piece of the load; the peak is where
    ż = 0, found between samples.

    Returns
    -------
    Transient
        Peak, when it comes, dynamic factor, overshoot, acceleration, and the motion over time.

    Raises
    ------
    InadmissibleError
        When the duration or the mass is missing, damping or stiffness is negative, or the file is no record.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 13.6; Duhamel's integral.

    Examples
    --------
    >>> made = transient(spring=Natural(10.0), load=Jolt(1.0, Shape("step")))
    >>> round(made.factor, 9)
    2.0
    """
    import numpy as np

    from dynamics_cli.vibration.shocks.pulses import Oscillators

    system = Oscillator(mass, spring, damping, gravity)
    loaded = Load(load, mass)
    require(loaded.height > 0.0, "the load is zero: nothing moves", code="no-load")
    of = Oscillators(np.array([system.omega]), system.zeta)
    square = system.omega * system.omega
    moved, pushed = _peaks(of, loaded, (1.0, 0.0)), _peaks(of, loaded, (-square, -2.0 * system.zeta * system.omega))
    sign = 1.0 if moved.high[0] >= -moved.low[0] else -1.0
    peak, other = (moved.high[0], moved.low[0]) if sign > 0.0 else (moved.low[0], moved.high[0])
    still = loaded.height / square
    steady = loaded.shape in ("step", "ramp")
    table = _history(of, loaded)
    force = table["load"]
    table["acceleration"] = (
        -2.0 * of.sigma * table["velocity"] - square * table["displacement"] + (0.0 if loaded.based else force)
    )
    strongest = float(max(pushed.high[0], -pushed.low[0]))
    return Transient(
        peak=float(abs(peak)),
        peak_time=float((moved.high_time if sign > 0.0 else moved.low_time)[0]),
        rebound=float(abs(other)),
        static=still,
        factor=float(abs(peak)) / still,
        overshoot=max(float(abs(peak)) / still - 1.0, 0.0) if steady else None,
        peak_acceleration=strongest if loaded.based else None,
        ground_force=None if loaded.based or mass is None else strongest * mass,
        natural_frequency=system.hertz,
        damping_ratio=system.zeta,
        history=Columns(HistoryPoint, **{name: table[name] for name in HistoryPoint.fields}),  # type: ignore[attr-defined]
        numerics=Numerics("closed form on each piece of the load; peaks by Newton's method between samples"),
    )


def _peaks(of: "Oscillators", loaded: Load, mix: "tuple[float, float]") -> "Any":
    """Extremes over the load and the time after it."""
    import numpy as np

    from dynamics_cli.vibration.shocks.extremes import Extremes, over_piece, over_record, over_rest

    into = Extremes(1)
    state: Any = (np.zeros(1), np.zeros(1))
    weights = (np.full(1, mix[0]), np.full(1, mix[1]))
    if not loaded.pieces:
        state = over_record(of, loaded.times, loaded.values, weights, into)
        if of.zeta < 1.0:
            over_rest(of, state, loaded.end, weights, into)
        return into
    period = 2.0 * math.pi / float(of.omega[0])
    for piece in loaded.pieces:
        length = piece.end - piece.start if math.isfinite(piece.end) else 1.5 * period * max(1.0, 4.0 * of.zeta)
        over_piece(of, state, piece, length, weights, into)
        state = of.after(state[0], state[1], piece, length)
    return into


def _history(of: "Oscillators", loaded: Load) -> "dict[str, Any]":
    import numpy as np

    from dynamics_cli.vibration.shocks.extremes import states_of_record

    period = 2.0 * math.pi / float(of.omega[0])
    if not loaded.pieces:
        (z,), (v,) = states_of_record(of, loaded.times, loaded.values)
        pick = np.unique(np.linspace(0, len(loaded.times) - 1, 8 * ROWS).astype(int))
        return {
            "time": loaded.times[pick], "displacement": z[pick], "velocity": v[pick], "load": loaded.values[pick]
        }  # fmt: skip
    times = np.linspace(0.0, min(loaded.end + AFTER * period, max(MOST * period, 2.0 * loaded.end)), ROWS)
    z, v, f = np.zeros(ROWS), np.zeros(ROWS), np.zeros(ROWS)
    state: Any = (np.zeros(1), np.zeros(1))
    for piece in loaded.pieces:
        here = (times >= piece.start) & (times <= piece.end)
        z[here], v[here] = of.after(state[0], state[1], piece, times[here] - piece.start)
        f[here] = piece.at(times[here] - piece.start)
        if math.isfinite(piece.end):
            state = of.after(state[0], state[1], piece, piece.end - piece.start)
    return {"time": times, "displacement": z, "velocity": v, "load": f}
